//! Vertical stress on the deformed meshes (the paper's Figs 9 and 13).

use crate::case::problem::problem;
use crate::error::Error;
use crate::figure::palette::ColourMap;
use crate::figure::{Detail, Field, Window};
use crate::study::pictures;
use crate::study::unsorted::{FieldData, Finding};

fn data<'a>(findings: &'a [Finding], scene: &str) -> Result<&'a FieldData, Error> {
    let name = pictures::field(scene);
    let finding = findings.iter().find(|finding| finding.case == name);
    finding
        .and_then(|finding| finding.fields.first())
        .ok_or_else(|| Error::at(name.as_str(), "the study of this figure has no field", "let its study keep one"))
}

/// The cylinder, with the contact enlarged.
pub fn cylinder(findings: &[Finding]) -> Result<String, Error> {
    let scene = problem("cylinder", None)?.scene;
    let (a, p0) = (scene.reference.length, scene.reference.pressure);
    let window = Window { x: (0.0, 4.0 * a), y: (-0.1 * a, 3.9 * a) };
    draw(data(findings, "cylinder")?, 1.0, (-p0, p0), Some(window))
}

/// Pin and rod.
pub fn pin_rod(findings: &[Finding]) -> Result<String, Error> {
    let scene = problem("pin-rod", None)?.scene;
    let (r, p) = (scene.reference.length, scene.reference.pressure);
    let window = Window { x: (0.0, 1.3 * r), y: (-1.3 * r, 0.0) };
    draw(data(findings, "pin-rod")?, 20.0, (-1.5 * p, 1.5 * p), Some(window))
}

/// Values are rounded to this fraction of the range, so that round-off cannot move one across the edge of a band.
const GRAIN: f64 = 1e-6;

fn draw(data: &FieldData, magnification: f64, range: (f64, f64), zoom: Option<Window>) -> Result<String, Error> {
    let pairs = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| (x, y)).collect();
    let grain = GRAIN * (range.1 - range.0);
    Field {
        title: data.title.clone(),
        quantity: "σ_y [MPa]".into(),
        points: pairs(&data.points),
        cells: data.cells.clone(),
        values: data.values.iter().map(|value| (value / grain).round() * grain).collect(),
        displacements: pairs(&data.displacements),
        magnification,
        map: ColourMap::Diverging,
        range: Some(range),
        zoom: zoom.map(|window| Detail::of(window, magnification)),
        notes: vec![],
    }
    .svg()
}
