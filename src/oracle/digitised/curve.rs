//! A digitised curve, with all that is needed to compute its twin.

use std::path::Path;

use super::text::text_of;
use super::{Abscissa, CurvePoint, CurveProvenance, DigitisedScene, Hand, Kind, Ordinate, Provenance, columns};
use crate::error::Error;
use crate::oracle::{Oracle, Quantity, Reading, ReferenceKind, Source};

/// One curve with all that is needed to compute its twin.
#[derive(Debug, Clone, PartialEq)]
pub struct DigitisedCurve {
    /// Name of the CSV file in its folder.
    pub file: String,
    /// Dimensions, materials and load of the source.
    pub scene: DigitisedScene,
    /// Figure, calibration, kind and hand of this curve.
    pub provenance: CurveProvenance,
    /// Publication, who digitised it, and how.
    pub source: Source,
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
    pub fn read(
        folder: &Path,
        entry: &CurveProvenance,
        provenance: &Provenance,
        scene: DigitisedScene,
    ) -> Result<Self, Error> {
        let file = folder.join(&entry.file);
        let text = text_of(&file, "add the file, or take its entry out of provenance.toml")?;
        let (abscissa, ordinate, points) = columns::read(&file, &text)?;
        if !scene.has_curve(abscissa, ordinate) {
            let message = format!("{ordinate:?} over {abscissa:?} is no curve of the scene in scene.toml");
            let remedy = "give a stress over an angle or a distance with a rod, a half-angle over a force with a sheet";
            return Err(Error::file(&file, message, remedy));
        }

        Ok(Self {
            file: entry.file.clone(),
            scene,
            provenance: entry.clone(),
            source: source(entry, provenance),
            abscissa,
            ordinate,
            points,
        })
    }

    /// Ordinate between its neighbours, and its uncertainty with the abscissa error carried through their slope.
    fn interpolate(&self, at: f64) -> Option<(f64, f64)> {
        self.points.windows(2).find_map(|pair| {
            let (left, right) = (pair[0], pair[1]);
            let width = right.abscissa - left.abscissa;
            let weight = (at - left.abscissa) / width;
            if !(0.0..=1.0).contains(&weight) {
                return None;
            }
            let between = |from: f64, to: f64| from + weight * (to - from);
            let slope = (right.ordinate - left.ordinate) / width;
            let across = slope * between(left.abscissa_error, right.abscissa_error);
            let up = between(left.ordinate_error, right.ordinate_error);
            Some((between(left.ordinate, right.ordinate), across.hypot(up)))
        })
    }
}

fn source(entry: &CurveProvenance, provenance: &Provenance) -> Source {
    let hand = match entry.hand {
        Hand::FirstHand => "first hand",
        Hand::ReadOffEgert => "read off Egert's figures",
    };
    let note = format!(
        "{hand}; digitised by {}, {}; axes: {}",
        provenance.digitised_by, provenance.method, entry.axis_calibration
    );
    Source::new(&format!("{}, {}", provenance.citation, entry.figure), &note)
}

impl Oracle for DigitisedCurve {
    fn name(&self) -> &str {
        &self.file
    }

    fn kind(&self) -> ReferenceKind {
        match self.provenance.kind {
            Kind::Measured => ReferenceKind::Measured,
            Kind::Fem => ReferenceKind::CrossCode,
        }
    }

    fn source(&self) -> Source {
        self.source.clone()
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let at = match (quantity, self.ordinate) {
            (Quantity::Pressure { at }, Ordinate::Pressure) => at,
            (Quantity::HoopStress { at }, Ordinate::HoopStress) => at,
            _ => return Reading::Silent,
        };
        match self.interpolate(*at) {
            Some((value, uncertainty)) => Reading::Value { value, uncertainty },
            None => Reading::Unavailable(format!("at is {at}, outside the digitised points")),
        }
    }
}
