//! How far each digitised curve lies from ours.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::digitised::{Digitised, DigitisedCurve, OurPoint, compare};
use crate::oracle::{Oracle, ReferenceKind};
use crate::study::digitised::ours;

/// What the folder of a source holds.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// The figures are not at hand.
    Absent {
        /// Name of the source.
        source: String,
        /// Why.
        why: String,
    },
    /// Every curve.
    Present(Vec<Curve>),
}

/// A digitised curve beside ours.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// Its file.
    pub file: String,
    /// Name of the source.
    pub source: String,
    /// Experiment, or elements of another code.
    pub kind: ReferenceKind,
    /// Largest deviation of a point, in combined standard uncertainties; NaN without points, or where a run of ours did not converge.
    pub worst: f64,
    /// What the source models and we do not.
    pub model_form: Option<String>,
}

/// Where the curves of a source are looked for.
pub fn folder(name: &str) -> PathBuf {
    root().join("oracles/digitised").join(name)
}

/// Compares every curve of a source's folder.
pub fn against(source: &str, folder: &Path) -> Result<Numbers, Error> {
    match Digitised::load(folder)? {
        Digitised::Absent(why) => Ok(Numbers::Absent { source: source.into(), why }),
        Digitised::Present(curves) => curves.iter().map(curve).collect::<Result<_, _>>().map(Numbers::Present),
    }
}

fn curve(curve: &DigitisedCurve) -> Result<Curve, Error> {
    let ours = ours::Curve::of(curve)?;
    // A scene that is refused says why; one that cannot be solved beside a point is no agreement: NaN, which no check passes.
    for point in &curve.points {
        ours.at(point.abscissa)?;
    }
    let comparison = compare(curve, &|at| ours.at(at).unwrap_or(OurPoint { value: f64::NAN, uncertainty: f64::NAN }));
    let worst = comparison.worst().map_or(f64::NAN, |deviation| deviation.ratio);
    Ok(Curve {
        file: curve.file.clone(),
        source: curve.name().into(),
        kind: curve.kind(),
        worst,
        model_form: comparison.model_form,
    })
}
