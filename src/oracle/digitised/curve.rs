//! A digitised curve, with all that is needed to compute its twin, and how far ours may lie from it.

use std::path::Path;

use super::keys::text_of;
use super::provenance::FEM;
use super::{Abscissa, CurvePoint, CurveProvenance, DigitisedScene, Ordinate, columns};
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::ReferenceKind;
use crate::uncertainty::{Comparison, combined};

/// One curve with all that is needed to compute its twin.
#[derive(Debug, Clone, PartialEq)]
pub struct DigitisedCurve {
    /// Name of the CSV file in its folder.
    pub file: String,
    /// Dimensions, materials and load of the source.
    pub scene: DigitisedScene,
    /// Figure, calibration, kind and hand of this curve.
    pub provenance: CurveProvenance,
    /// What the abscissa is.
    pub abscissa: Abscissa,
    /// What the ordinate is.
    pub ordinate: Ordinate,
    /// The points, by rising abscissa; never empty.
    pub points: Vec<CurvePoint>,
}

impl DigitisedCurve {
    /// Reads the CSV file of one provenance entry.
    ///
    /// # Errors
    /// Names the column that is missing or unknown, or the line and column of a refused entry.
    pub fn read(folder: &Path, entry: &CurveProvenance, scene: &DigitisedScene) -> Result<Self, Error> {
        let file = folder.join(&entry["file"]);
        let text = text_of(&file, "add the file, or take its entry out of provenance.toml")?;
        let (abscissa, ordinate, points) = columns::read(&file, &text)?;
        if !scene.has_curve(abscissa, ordinate) {
            let message = format!("{ordinate:?} over {abscissa:?} is no curve of the scene in scene.toml");
            let remedy = "give a stress over an angle or a distance with a rod, a half-angle over a force with a sheet";
            return Err(Error::file(&file, message, remedy));
        }

        let (file, provenance, scene) = (entry["file"].clone(), entry.clone(), scene.clone());
        Ok(Self { file, scene, provenance, abscissa, ordinate, points })
    }

    /// What its points are: measured, or another code's.
    pub fn kind(&self) -> ReferenceKind {
        if self.provenance["kind"] == FEM { ReferenceKind::CrossCode } else { ReferenceKind::Measured }
    }
}

/// Our value at an abscissa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OurPoint {
    /// The value.
    pub value: f64,
    /// Its own standard uncertainty, such as the discretisation error.
    pub uncertainty: f64,
}

/// Holds our curve against a digitised one, point by point: differences, each with `√(u_dig² + u_ours²)`.
///
/// `ours` takes the abscissa of the curve (rad, mm or N) and is asked one abscissa error to both sides
/// of each point too, so a symmetric curve must take negative arguments.
pub fn compare(curve: &DigitisedCurve, ours: &dyn Fn(f64) -> OurPoint) -> Vec<Comparison> {
    curve.points.iter().map(|point| at(point, ours)).collect()
}

/// `u_dig² = u_y² + (s u_x)²` with the slope `s` of our curve over `x ± u_x`.
fn at(point: &CurvePoint, ours: &dyn Fn(f64) -> OurPoint) -> Comparison {
    let (x, error) = (point.abscissa, point.abscissa_error);
    let mine = ours(x);
    let slope = (ours(x + error).value - ours(x - error).value) / (2.0 * error);
    let digitising = combined([point.ordinate_error, slope * error]);
    Comparison::of(mine.value, point.ordinate, [digitising, mine.uncertainty])
}

/// The largest difference in units of its uncertainty; NaN, which no check passes, where one is no number or there is
/// none.
pub fn worst(compared: &[Comparison]) -> f64 {
    compared.iter().map(Comparison::ratio).reduce(larger).unwrap_or(f64::NAN)
}

/// What the source models and we do not, which no uncertainty covers.
pub fn model_form(curve: &DigitisedCurve) -> Option<String> {
    let friction = curve.scene.number("friction");
    (friction > 0.0).then(|| format!("the source has a coefficient of friction of {friction}, ours has none"))
}
