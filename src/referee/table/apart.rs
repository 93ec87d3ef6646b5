//! Rows that press nothing among those that do, which a column tells from them: those of the other side, or of nodes
//! within a body.

use std::collections::BTreeSet;

use crate::referee::answer::FEWEST;

/// A row: its place, what presses there, and its cells.
pub(super) type Pressed<'a> = (f64, f64, &'a [String]);

/// Most values of a column that tells rows apart.
const VALUES: usize = 8;
/// What to do about such rows.
pub(super) const ONE_SIDE: &str = "keep the rows that press alone: the others are of the other side of the contact, \
    within a body, or mid-sides without a pressure";

/// What is wrong where rows that press nothing lie among those that do, nearly by turns, and one of the columns that
/// may tell them apart has other values there.
pub(super) fn apart(head: &[String], columns: &[usize], mut rows: Vec<Pressed>) -> Option<String> {
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let presses = |row: &Pressed| row.1.abs() > 0.0;
    let within = &rows[rows.iter().position(presses)?..=rows.iter().rposition(presses)?];
    let runs = within.chunk_by(|a, b| presses(a) == presses(b)).count();
    let (pressed, free): (Vec<&Pressed>, Vec<&Pressed>) = within.iter().partition(|row| presses(row));
    if free.len() < FEWEST || 2 * runs < within.len() {
        return None;
    }
    let values = |rows: &[&Pressed], column: usize| -> BTreeSet<String> {
        rows.iter().filter_map(|row| row.2.get(column).cloned()).collect()
    };
    columns.iter().find_map(|&column| {
        let [pressed, free] = [&pressed, &free].map(|rows| values(rows, column));
        let tells = pressed.is_disjoint(&free) && pressed.len() + free.len() <= VALUES;
        let [of_pressed, of_free] = [pressed, free].map(|all| all.into_iter().collect::<Vec<_>>().join(", "));
        tells.then(|| {
            format!(
                "rows that press nothing lie among those that do: the column `{}` is {of_free} of these, and \
                {of_pressed} of the others",
                head[column]
            )
        })
    })
}
