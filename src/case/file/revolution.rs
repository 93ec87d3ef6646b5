//! `plane = "axisymmetric"`: what a scene of bodies of revolution has otherwise than one in the plane.

use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::{ContactPair, PlaneHypothesis};

/// The thickness of the bodies \[mm\], which those of revolution have not.
pub(super) fn thickness(file: Value, plane: PlaneHypothesis) -> Result<f64, Error> {
    match (file.get("thickness"), plane.is_of_revolution()) {
        (Some(thickness), false) => thickness.length(),
        (Some(thickness), true) => {
            let message = "bodies of revolution have no thickness: loads and resultants are whole forces";
            Err(thickness.refused(message, "leave it out"))
        }
        (None, true) => Ok(1.0),
        (None, false) => {
            let remedy = "add or correct it; tests/cases/README.md describes every key";
            Err(file.refused("missing field `thickness`", remedy))
        }
    }
}

/// Refuses contacts that bodies of revolution cannot have.
pub(super) fn refuse_other_contacts(contacts: &[Value]) -> Result<(), Error> {
    for contact in contacts {
        if let Some(given) = contact.asked("both-sides") {
            let message = "bodies of revolution lie at x ≥ 0, on one side of their axis, and so does their contact";
            return Err(given.refused(message, "leave `both-sides` out"));
        }
        if let Some(given) = contact.asked("symmetric") {
            let message = "bodies of revolution are modelled whole: their section is no half of a symmetric scene";
            return Err(given.refused(message, "leave `symmetric` out"));
        }
        if let Some(given) = contact.get("arc") {
            let message = "contact along an arc is not computed for bodies of revolution: areas and forces are taken over the radius";
            let remedy = "leave `arc` out: the gap of spheres is given along y = 0; a ring on a shaft is a plane scene";
            return Err(given.refused(message, remedy));
        }
        let is_off = |origin: &Value| origin.entries().first().is_some_and(|x| x.number().abs() > 0.0);
        if let Some(given) = contact.get("origin").filter(is_off) {
            let message = "the contact coordinate of bodies of revolution is the radius, from the axis x = 0 on";
            return Err(given.refused(message, "give an `origin` at x = 0"));
        }
    }
    Ok(())
}

/// Sections of revolution stand for the whole bodies.
pub(super) fn whole(mut pairs: Vec<ContactPair>) -> Vec<ContactPair> {
    pairs.iter_mut().for_each(|pair| pair.symmetric = false);
    pairs
}
