//! The readings that fit the searched mesh best, tried where they were not looked for: other meshes, cells and starts.

use rayon::prelude::*;
use serde::Serialize;

use crate::algorithm::{Spring, StiffnessRule};
use crate::error::Error;
use crate::mesh::Order;
use crate::study::readings::axes::Example;
use crate::study::readings::course::{self, Ground};
use crate::study::readings::map::{self, Judged, bit};
use crate::study::readings::reading::Reading;
use crate::study::readings::sentence::{Seen, Sentence};

/// Elements of the meshes over those of the searched one.
pub const ELEMENTS: [f64; 3] = [0.75, 1.25, 1.5];
/// Starts: quarter decades from 1e-3 to 1e6.
pub fn starts() -> Vec<f64> {
    (-12..=24).map(|k| 10f64.powf(0.25 * f64::from(k))).collect()
}

/// A reading on meshes that it was not chosen by.
#[derive(Clone, Debug, Serialize)]
pub struct Trial {
    /// The reading.
    pub reading: Reading,
    /// Meshes.
    pub of: usize,
    /// On how many of them each sentence holds, in the order of [`Sentence::ALL`].
    pub holds: Vec<usize>,
}

/// The reading of every rule of varying stiffness, whatever its bound, under which most sentences hold in the first example, and of those the
/// nearest to the text; the best of them.
pub fn chosen(all: &[Judged], number: usize) -> Vec<Reading> {
    let nearest = Reading::nearest();
    let rank = |judged: &Judged| {
        (std::cmp::Reverse(judged.single[0].count_ones()), nearest.differences(&judged.reading).len())
    };
    let mut best: Vec<&Judged> = Vec::new();
    for judged in all {
        match best.iter_mut().find(|kept| kind(&kept.reading) == kind(&judged.reading)) {
            Some(kept) if rank(judged) < rank(kept) => *kept = judged,
            Some(_) => {}
            None => best.push(judged),
        }
    }
    best.sort_by_key(|judged| rank(judged));
    best.into_iter().take(number).map(|judged| judged.reading).collect()
}

/// A rule of varying stiffness without its bound.
fn kind(reading: &Reading) -> (StiffnessRule, Spring) {
    (reading.varying.rule, reading.varying.spring)
}

/// Tries some readings on every other mesh.
pub fn trials(readings: &[Reading]) -> Result<Vec<Trial>, Error> {
    let starts = starts();
    let meshes: Vec<(f64, Order)> =
        ELEMENTS.into_iter().flat_map(|times| [(times, Order::Linear), (times, Order::Quadratic)]).collect();
    let on = |reading: &Reading, (times, order): (f64, Order)| -> Result<u16, Error> {
        let seen = |example| {
            let searched = Ground::searched(example, reading.candidates);
            let elements = (searched.elements as f64 * times).round() as usize;
            Ok(Seen::five(course::ends(&Ground { elements, order, ..searched }, reading, &starts)?))
        };
        let both = [seen(Example::Cylinder)?, seen(Example::PinRod)?];
        Ok(map::bits(|sentence| sentence.holds(&both)))
    };
    let trial = |reading: &Reading| {
        let found = meshes.par_iter().map(|&mesh| on(reading, mesh)).collect::<Result<Vec<u16>, Error>>()?;
        let count = |sentence| found.iter().filter(|bits| *bits & bit(sentence) != 0).count();
        Ok(Trial { reading: *reading, of: found.len(), holds: Sentence::ALL.map(count).to_vec() })
    };
    readings.par_iter().map(trial).collect()
}
