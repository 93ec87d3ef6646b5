//! The pressure profile as a table for other programs.

use std::path::Path;

use crate::error::Error;
use crate::measure::display_factor;
use crate::report::record;
use crate::scene::Scene;
use crate::solve::Run;

/// Columns of the position, and whether that is along a straight path.
const POSITIONS: [(&str, bool); 2] = [("position [mm]", true), ("position [deg]", false)];
/// Columns behind the position.
const HEAD: [&str; 4] = ["pressure [MPa]", "gap [mm]", "area [mm2]", "contact"];

/// Position, pressure, gap, area and contact of every contact point: positions along straight paths in mm, on arcs in degrees;
/// where a scene has contacts of both kinds, each kind has a column.
pub fn csv(scene: &Scene, run: &Run, path: &Path) -> Result<String, Error> {
    let has = |is_straight| scene.contacts.iter().any(|pair| pair.path.is_straight() == is_straight);
    let kinds: Vec<(&str, bool)> = POSITIONS.into_iter().filter(|(_, is_straight)| has(*is_straight)).collect();
    let mut rows: Vec<Vec<String>> =
        vec![kinds.iter().map(|(title, _)| *title).chain(HEAD).map(String::from).collect()];
    for (index, pair) in scene.contacts.iter().enumerate() {
        for point in run.solution.points_of(index) {
            let position = (display_factor(&pair.path) * point.position).to_string();
            // Nothing where it is of the other kind.
            let cell =
                |is_straight| if pair.path.is_straight() == is_straight { position.clone() } else { String::new() };
            let positions = kinds.iter().map(|(_, is_straight)| cell(*is_straight));
            let numbers = [point.pressure, point.gap, point.weight].map(|number| number.to_string());
            rows.push(positions.chain(numbers).chain([pair.name.clone()]).collect());
        }
    }
    record::text(path, &rows)
}

/// Whether a text is such a table, every row as long as the head.
pub fn is_profile(text: &str) -> bool {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let is_head = reader.headers().is_ok_and(|head| {
        let is_position = |title: &&str| POSITIONS.iter().any(|(known, _)| known == title);
        let (positions, rest) = head.iter().partition::<Vec<_>, _>(is_position);
        !positions.is_empty() && rest == HEAD
    });
    is_head && reader.records().all(|row| row.is_ok())
}
