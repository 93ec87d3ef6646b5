//! The pressure profile as a table for other programs.

use std::path::Path;

use crate::case::Run;
use crate::error::Error;

/// Position, pressure, gap and area of every contact point.
pub fn csv(run: &Run, path: &Path) -> Result<String, Error> {
    let failed = |reason: String| Error::File { path: path.into(), reason, remedy: "try another file".into() };
    let mut writer = csv::Writer::from_writer(Vec::new());
    let head = ["position [mm or rad]", "pressure [MPa]", "gap [mm]", "area [mm2]"];
    writer.write_record(head).map_err(|error| failed(error.to_string()))?;
    for point in &run.solution.points {
        let numbers = [point.position, point.pressure, point.gap, point.weight].map(|number| number.to_string());
        writer.write_record(numbers).map_err(|error| failed(error.to_string()))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(error.to_string()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
