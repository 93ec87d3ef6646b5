//! The charts.

use crate::error::Error;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::fields::run::Numbers;

/// Charts with their captions.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    let charts = [
        ("field-cylinder.svg", "As Fig. 9. Cylinder: mesh and vertical stress on the deformed shape"),
        ("field-pin-rod.svg", "As Fig. 13. Pin and rod: mesh and vertical stress on the deformed shape"),
        (
            "figure-15.svg",
            "Fig. 15, which quantity it shows not being known: hoop stress and displacement along pin and rod by the five combinations \
             that the paper shows; the place of Gaertner's curves is empty",
        ),
        ("iteration-paths.svg", "Figs 6 and 7, and kinematic load beside them: the path of the iterations"),
    ];
    let charts = charts.map(|(file, caption)| picture(file, caption));
    Ok(charts.concat())
}
