//! A plane as a chart of classes: neighbours, boundaries, and the text that is frozen.

use std::fmt::Write;

use crate::study::atlas::plane::Plane;
use crate::study::atlas::record::{Record, same};
use crate::study::class::Class;
use crate::study::method::Method;

/// The records of a plane, a line per row of the plan.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Chart {
    /// The plane.
    pub plane: Plane,
    /// Records by row, then by initial stiffness.
    pub rows: Vec<Vec<Record>>,
}

impl Chart {
    /// The records in the order of the plan.
    pub fn of(plane: Plane, records: &[Record]) -> Self {
        Self { plane, rows: records.chunks(plane.stiffnesses().len()).map(<[Record]>::to_vec).collect() }
    }

    /// Rows of a method, by growing ordinate.
    pub fn of_method(&self, method: Method) -> impl Iterator<Item = &[Record]> {
        self.rows.iter().map(Vec::as_slice).filter(move |row| row[0].method == method)
    }

    /// Whether a neighbour in stiffness or in the other number ended in another class.
    pub fn is_near_a_boundary(&self, row: usize, column: usize) -> bool {
        let own = &self.rows[row][column];
        let beside = [column.checked_sub(1), Some(column + 1)];
        let across = self.across(own);
        let mut neighbours = beside.into_iter().flatten().filter_map(|c| self.rows[row].get(c)).chain(across);
        neighbours.any(|other| other.class != own.class)
    }

    /// The points of the same formulation and stiffness at the ordinates before and after.
    fn across<'a>(&'a self, own: &'a Record) -> impl Iterator<Item = &'a Record> {
        let ordinates = self.plane.ordinates();
        let place = ordinates.iter().position(|o| same(*o, own.ordinate));
        let near = move |record: &Record| {
            let other = ordinates.iter().position(|o| same(*o, record.ordinate));
            place.zip(other).is_some_and(|(a, b)| a.abs_diff(b) == 1)
        };
        let alike = |record: &&Record| record.method == own.method && same(record.stiffness, own.stiffness);
        self.rows.iter().flatten().filter(alike).filter(move |record| near(record))
    }

    /// What is frozen: the iterations where all neighbours ended alike, the class alone near a boundary.
    pub fn frozen(&self) -> String {
        let mut text = format!("{}; κ₀ from 1e-6 to 1e6\n", self.plane.label());
        for (r, row) in self.rows.iter().enumerate() {
            let _ = write!(text, "{} {}:", row[0].method, row[0].ordinate);
            for (c, record) in row.iter().enumerate() {
                let _ = match record.class {
                    Class::Converged if !self.is_near_a_boundary(r, c) => write!(text, " {}", record.iterations),
                    class => write!(text, " {}", class.name()),
                };
            }
            text.push('\n');
        }
        text
    }
}
