//! `plane = "axisymmetric"`: what a scene of bodies of revolution has otherwise than one in the plane.

use crate::case::file::contact::way;
use crate::case::file::form::DESCRIBED;
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::revolution::{NO_HALF, beside};
use crate::scene::{ContactPair, PlaneHypothesis};

/// The hypotheses that a file may name.
pub(super) const PLANES: [(&str, PlaneHypothesis); 3] = [
    ("strain", PlaneHypothesis::Strain),
    ("stress", PlaneHypothesis::Stress),
    ("axisymmetric", PlaneHypothesis::Axisymmetric),
];

/// The plane hypothesis; of bodies of revolution about the `axis` that is named, `y` where none is.
pub(super) fn plane(file: Value) -> Result<PlaneHypothesis, Error> {
    let plane = file.at("plane").choice("plane hypothesis", &PLANES)?;
    match file.get("axis") {
        Some(axis) if plane.is_of_revolution() => {
            axis.choice("axis", &[("y", plane), ("x", PlaneHypothesis::AxisymmetricAboutX)])
        }
        Some(axis) => Err(axis
            .refused("only bodies of revolution have an `axis`", "leave it out, or give `plane = \"axisymmetric\"`")),
        None => Ok(plane),
    }
}

/// The thickness of the bodies \[mm\], which those of revolution have not.
pub(super) fn thickness(file: Value, plane: PlaneHypothesis) -> Result<f64, Error> {
    match (file.get("thickness"), plane.is_of_revolution()) {
        (Some(thickness), false) => thickness.length(),
        (Some(thickness), true) => {
            let message = "bodies of revolution have no thickness: loads and resultants are whole forces";
            Err(thickness.refused(message, "leave it out"))
        }
        (None, true) => Ok(1.0),
        (None, false) => Err(file.refused("missing field `thickness`", DESCRIBED)),
    }
}

/// Refuses contacts that bodies of revolution cannot have.
pub(super) fn refuse_other_contacts(plane: PlaneHypothesis, contacts: &[Value]) -> Result<(), Error> {
    let Some(radial) = plane.radial() else { return Ok(()) };
    for &contact in contacts {
        let [message, remedy] = NO_HALF;
        Value::refuse(contact.asked("symmetric").filter(|_| radial == 0), message, remedy)?;
        let (path, stretch) = way(contact)?;
        if let Some([message, remedy]) = beside(&path, radial, stretch) {
            let given = contact.first(["arc", "origin", "both-sides"]).unwrap_or(contact);
            return Err(given.refused(message, remedy));
        }
    }
    Ok(())
}

/// Sections of revolution about x = 0 stand for the whole bodies.
pub(super) fn whole(plane: PlaneHypothesis, mut pairs: Vec<ContactPair>) -> Vec<ContactPair> {
    if plane.radial() == Some(0) {
        pairs.iter_mut().for_each(|pair| pair.symmetric = false);
    }
    pairs
}
