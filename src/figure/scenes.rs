//! The two scenes of the comparison, as drawings with loads and supports; every label comes from a number.

use super::canvas::Canvas;
use super::pen::Lettering;
use super::scene_cylinder::draw_cylinder;
use super::scene_pin_rod::draw_pin_rod;
use crate::error::Error;

/// Elastic cylinder on a rigid plane, the lower quarter of it.
#[derive(Clone, Debug)]
pub struct CylinderScene {
    /// Radius `R`, in mm.
    pub radius: f64,
    /// Half-width `a` of the contact, in mm.
    pub half_width: f64,
    /// Length `L` of the candidates from the symmetry line, in mm.
    pub candidates: f64,
    /// Uniform load `q` on the horizontal cut, in MPa.
    pub load: f64,
    /// Small print below.
    pub notes: Vec<String>,
}

/// Pin in the eye of a connecting rod, half of the rod and a quarter of the pin.
#[derive(Clone, Debug)]
pub struct PinRodScene {
    /// Radius `R` of the pin, in mm.
    pub pin_radius: f64,
    /// Radial clearance `c`, in mm.
    pub clearance: f64,
    /// Outer radius of the eye, in mm.
    pub eye_radius: f64,
    /// Whole width of the shank, in mm.
    pub shank_width: f64,
    /// Height of the shank's end above the centre of the eye, in mm.
    pub shank_end: f64,
    /// Force on the whole rod, in N.
    pub force: f64,
    /// Angle of the last candidate from the load line, in degrees.
    pub candidates: f64,
    /// Small print below.
    pub notes: Vec<String>,
}

impl CylinderScene {
    /// The drawing as SVG.
    pub fn svg(&self) -> Result<String, Error> {
        let mut canvas = Canvas::new();
        draw_cylinder(&mut canvas, self);
        let shown = "Not to scale: a and L are drawn larger.".to_string();
        canvas.svg("Cylinder on a rigid plane", (452.0, 414.0), &[self.notes.as_slice(), &[shown]].concat())
    }
}

impl PinRodScene {
    /// The drawing as SVG.
    pub fn svg(&self) -> Result<String, Error> {
        let mut canvas = Canvas::new();
        draw_pin_rod(&mut canvas, self);
        let shown = "Not to scale: the clearance is drawn larger.".to_string();
        canvas.svg("Pin and connecting rod", (452.0, 606.0), &[self.notes.as_slice(), &[shown]].concat())
    }
}

/// A named number with its unit, `R = 50 mm`.
pub(super) fn quantity(name: &str, value: f64, unit: &str) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{name} = {rounded} {unit}").replace('-', "−")
}

/// Text beside a drawing.
pub(super) fn text() -> Lettering {
    Lettering::start(super::sketch::TEXT)
}
