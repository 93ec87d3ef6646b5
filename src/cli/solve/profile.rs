//! The pressure profile as a table for other programs.

use std::path::Path;

use crate::error::Error;
use crate::scene::Scene;
use crate::solve::Run;

/// Position, pressure, gap, area and contact of every contact point.
pub fn csv(scene: &Scene, run: &Run, path: &Path) -> Result<String, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let head = ["position [mm or rad]", "pressure [MPa]", "gap [mm]", "area [mm2]", "contact"];
    writer.write_record(head).map_err(|error| Error::unwritable(path, error))?;
    for (index, pair) in scene.contacts.iter().enumerate() {
        for point in run.solution.points_of(index) {
            let numbers = [point.position, point.pressure, point.gap, point.weight].map(|number| number.to_string());
            let record = numbers.iter().chain([&pair.name]);
            writer.write_record(record).map_err(|error| Error::unwritable(path, error))?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| Error::unwritable(path, error))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
