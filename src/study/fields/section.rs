//! The charts.

use crate::error::Error;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::fields::run::Numbers;

/// Charts with their captions.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    let charts = [
        ("field-cylinder.svg", "Cylinder: mesh and vertical stress on the deformed shape"),
        ("field-pin-rod.svg", "Pin and rod: mesh and vertical stress on the deformed shape"),
        ("along-the-pin.svg", "Hoop stress and displacement along pin and rod"),
        ("iteration-paths.svg", "The path of the iterations"),
    ];
    let charts = charts.map(|(file, caption)| picture(file, caption));
    Ok(format!("## Fields and iteration paths\n\n{}", charts.concat()))
}
