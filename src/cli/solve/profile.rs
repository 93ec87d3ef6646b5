//! The pressure profile as a table for other programs.

use std::path::Path;

use crate::error::Error;
use crate::measure::display_factor;
use crate::scene::{ContactPair, Scene};
use crate::solution::PointState;
use crate::solve::Run;

/// Columns behind the position.
const HEAD: [&str; 4] = ["pressure [MPa]", "gap [mm]", "area [mm2]", "contact"];

/// Position, pressure, gap, area and contact of every contact point: positions along straight paths in mm, on arcs in degrees;
/// where a scene has contacts of both kinds, each kind has a column.
pub fn csv(scene: &Scene, run: &Run, path: &Path) -> Result<String, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let columns: Vec<Kind> = Kind::ALL.into_iter().filter(|kind| scene.contacts.iter().any(|p| kind.has(p))).collect();
    let head = columns.iter().map(|kind| kind.title()).chain(HEAD);
    writer.write_record(head).map_err(|error| Error::unwritable(path, error))?;
    for (index, pair) in scene.contacts.iter().enumerate() {
        for point in run.solution.points_of(index) {
            let positions = columns.iter().map(|kind| kind.cell(pair, point));
            let numbers = [point.pressure, point.gap, point.weight].map(|number| number.to_string());
            let record = positions.chain(numbers).chain([pair.name.clone()]);
            writer.write_record(record).map_err(|error| Error::unwritable(path, error))?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| Error::unwritable(path, error))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Whether a text is such a table, every row as long as the head.
pub fn is_profile(text: &str) -> bool {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let is_head = reader.headers().is_ok_and(|head| {
        let (positions, rest) = head.iter().partition::<Vec<_>, _>(|title| title.starts_with("position ["));
        !positions.is_empty() && rest == HEAD
    });
    is_head && reader.records().all(|row| row.is_ok())
}

/// What a position is.
#[derive(Clone, Copy)]
enum Kind {
    Length,
    Angle,
}

impl Kind {
    const ALL: [Self; 2] = [Self::Length, Self::Angle];

    fn title(self) -> &'static str {
        match self {
            Self::Length => "position [mm]",
            Self::Angle => "position [deg]",
        }
    }

    fn has(self, pair: &ContactPair) -> bool {
        pair.path.is_straight() == matches!(self, Self::Length)
    }

    /// The position of a point; nothing where it is of the other kind.
    fn cell(self, pair: &ContactPair, point: &PointState) -> String {
        if self.has(pair) { (display_factor(&pair.path) * point.position).to_string() } else { String::new() }
    }
}
