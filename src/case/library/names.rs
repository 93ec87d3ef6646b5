//! Cases by the names that `solve` knows.

use crate::case::definition::Case;
use crate::case::library::{
    Bars, Cylinder, CylinderModel, FlatPunch, Patch, PinPlate, PinRod, PressFit, TruncatedHertz,
};
use crate::case::library::{
    bars, cylinder, flat_punch, indented, own_weight, patch, pin_plate, pin_rod, sphere, truncated_hertz,
};
use crate::error::{Error, Place, meant};
use crate::scene::PlaneHypothesis;

/// Name, what it is, whether its load can be set, and the case under a load by its a/R.
type Entry = (&'static str, &'static str, bool, fn(f64) -> Case);

/// Default a/R of the scenes whose load can be set.
const RATIO: f64 = 0.05;

const ENTRIES: [Entry; 15] = [
    ("cylinder", cylinder::TITLE, true, |a_over_r| Cylinder { a_over_r, ..Default::default() }.case()),
    ("cylinder-half", "the same with the half cylinder modelled", true, |a_over_r| {
        Cylinder { a_over_r, model: CylinderModel::Half, ..Default::default() }.case()
    }),
    ("cylinder-between-plates", "the same between two rigid plates, the lower quarter", true, |a_over_r| {
        Cylinder { a_over_r, model: CylinderModel::BetweenPlates, ..Default::default() }.case()
    }),
    ("truncated-hertz", truncated_hertz::TITLE, true, |a_over_r| {
        TruncatedHertz { a_over_r, ..Default::default() }.case()
    }),
    ("pin-rod", pin_rod::TITLE, false, |_| PinRod::default().case()),
    ("pin-plate", pin_plate::TITLE, false, |_| PinPlate::of_half_angle(60.0).case()),
    ("patch", patch::TITLE, false, |_| Patch::default().case()),
    ("bars", bars::TITLE, false, |_| Bars::default().case()),
    ("own-weight", own_weight::TITLE, false, |_| own_weight::case()),
    ("press-fit", "press fit of two rings, plane stress", false, |_| PressFit::default().case()),
    ("press-fit-strain", "press fit of two rings, plane strain", false, |_| {
        PressFit { plane: PlaneHypothesis::Strain, ..Default::default() }.case()
    }),
    ("flat-punch", flat_punch::TITLE, false, |_| FlatPunch::default().case()),
    ("sphere", sphere::TITLE, true, sphere::case),
    ("truncated-sphere", indented::SPHERE, true, indented::truncated_sphere),
    ("cone", indented::CONE, false, |_| indented::cone()),
];

/// Names and titles.
pub const NAMES: [(&str, &str); ENTRIES.len()] = {
    let mut names = [("", ""); ENTRIES.len()];
    let mut k = 0;
    while k < ENTRIES.len() {
        names[k] = (ENTRIES[k].0, ENTRIES[k].1);
        k += 1;
    }
    names
};

/// The case of a name; `a_over_r` sets the load of the Hertz scenes.
pub fn find(name: &str, a_over_r: Option<f64>) -> Result<Case, Error> {
    let Some((name, title, is_loaded, case)) = ENTRIES.iter().find(|(known, ..)| *known == name) else {
        let known = NAMES.map(|(name, _)| name);
        let remedy = format!("{}choose one of {}", meant(name, known), known.join(", "));
        return Err(Error::at(Place::Nowhere, format!("there is no case `{name}`"), remedy));
    };
    let ratio = match a_over_r {
        None => RATIO,
        Some(ratio) if *is_loaded => allowed(name, ratio)?,
        Some(_) => {
            let loaded: Vec<&str> = ENTRIES.iter().filter(|entry| entry.2).map(|entry| entry.0).collect();
            let remedy = format!("leave it out, or solve one of {}", loaded.join(", "));
            return Err(Error::at(Place::Nowhere, format!("`{name}` has no a/R"), remedy));
        }
    };
    Ok(Case { title: (*title).into(), ..case(ratio).named(*name) })
}

fn allowed(name: &str, ratio: f64) -> Result<f64, Error> {
    if ratio > 0.0 && ratio <= 0.5 {
        return Ok(ratio);
    }
    let expected = "it must lie between 0 and 0.5, where the candidates reach the side of the cylinder";
    Err(Error::value(name, "a-over-r", ratio, expected, "use for instance 0.05"))
}
