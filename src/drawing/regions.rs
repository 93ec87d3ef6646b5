//! Regions of a map: cells side by side, or one above the other, that have one class and one label.

/// One cell: its class, and which side of the predicted boundary it is on, if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Number of its class, which colours it.
    pub class: usize,
    /// A few characters that stand once in the region of cells that are alike.
    pub label: String,
    /// Side of the predicted boundary.
    pub predicted: Option<bool>,
}

/// A region, and its longest stretch of cells in one row, where its label has most room.
pub(super) struct Region<'a> {
    pub class: usize,
    pub label: &'a str,
    pub row: usize,
    /// First column of the stretch, and the one after its last.
    pub from: usize,
    pub to: usize,
}

/// The regions of a map, row by row.
pub(super) fn regions<'a>(rows: &[&'a [Cell]]) -> Vec<Region<'a>> {
    let mut seen: Vec<Vec<bool>> = rows.iter().map(|cells| vec![false; cells.len()]).collect();
    let mut found = Vec::new();
    for row in 0..rows.len() {
        for column in 0..rows[row].len() {
            if !seen[row][column] {
                let members = filled(rows, (row, column), &mut seen);
                let (row, from, to) = longest(members);
                let Cell { class, label, .. } = &rows[row][from];
                found.push(Region { class: *class, label, row, from, to });
            }
        }
    }
    found
}

/// All cells of the region that a cell is in, marked as seen.
fn filled(rows: &[&[Cell]], start: (usize, usize), seen: &mut [Vec<bool>]) -> Vec<(usize, usize)> {
    let alike = |a: (usize, usize), b: (usize, usize)| {
        let [a, b] = [a, b].map(|(row, column)| &rows[row][column]);
        a.class == b.class && a.label == b.label
    };
    seen[start.0][start.1] = true;
    let (mut members, mut next) = (vec![start], 0);
    while let Some(&(row, column)) = members.get(next) {
        next += 1;
        let beside =
            [(row, column + 1), (row + 1, column), (row, column.wrapping_sub(1)), (row.wrapping_sub(1), column)];
        for place in beside {
            let inside = seen.get(place.0).is_some_and(|row| row.get(place.1) == Some(&false));
            if inside && alike(start, place) {
                seen[place.0][place.1] = true;
                members.push(place);
            }
        }
    }
    members
}

/// The longest stretch of members in one row, of equal ones that nearest to the middle row.
fn longest(mut members: Vec<(usize, usize)>) -> (usize, usize, usize) {
    members.sort_unstable();
    let middle = members[members.len() / 2].0;
    let pieces = members.chunk_by(|a, b| a.0 == b.0 && a.1 + 1 == b.1);
    let stretches = pieces.map(|piece| (piece[0].0, piece[0].1, piece[0].1 + piece.len()));
    let best = stretches.max_by_key(|(row, from, to)| (to - from, usize::MAX - row.abs_diff(middle), usize::MAX - row));
    best.unwrap_or((members[0].0, members[0].1, members[0].1 + 1))
}
