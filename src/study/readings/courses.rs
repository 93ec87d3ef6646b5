//! The record, by what it is of: how runs end under any reading.

use std::collections::HashMap;

use crate::algorithm::{Spring, StiffnessRule};
use crate::solve::{Element, Iteration};
use crate::study::readings::axes::{Candidates, Example, Stop, THICKNESSES};
use crate::study::readings::course::{Record, UNIT};
use crate::study::readings::reading::{End, Reading};

/// What identifies the starts of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Key {
    example: Example,
    candidates: Candidates,
    element: Element,
    thickness: u64,
    algorithm: Iteration,
    rule: StiffnessRule,
    bound: u64,
    spring: Spring,
}

/// Of every start: κ₀, retained dofs, and iterations with the error there by every criterion.
type Starts = Vec<(f64, usize, Vec<Option<(usize, f64)>>)>;

/// The record, by what it is of.
pub struct Courses(HashMap<Key, Starts>);

impl Courses {
    /// Of records; what cannot be read of one is a start that never ends.
    pub fn of(records: &[Record]) -> Self {
        let mut all: HashMap<Key, Starts> = HashMap::new();
        for record in records {
            let key = Key {
                example: record.example,
                candidates: record.candidates,
                element: record.element,
                thickness: record.thickness.to_bits(),
                algorithm: record.algorithm,
                rule: record.rule,
                bound: record.bound.to_bits(),
                spring: record.spring,
            };
            let pairs = record.iterations.split(' ').zip(record.errors.split(' '));
            let met = pairs
                .map(|(iterations, error)| Some((iterations.parse().ok()?, UNIT * error.parse::<f64>().ok()?)))
                .collect();
            all.entry(key).or_default().push((record.stiffness, record.retained, met));
        }
        Self(all)
    }

    /// The starts of an element with an algorithm under a reading; empty where they are not recorded.
    pub fn ends(&self, reading: &Reading, example: Example, element: Element, algorithm: Iteration) -> Vec<End> {
        let rule = reading.rule(algorithm);
        let thickness = if element == Element::Layer { reading.thickness } else { THICKNESSES[0] };
        let key = Key {
            example,
            candidates: reading.candidates,
            element,
            thickness: thickness.to_bits(),
            algorithm,
            rule: rule.rule,
            bound: rule.bound.to_bits(),
            spring: rule.spring,
        };
        let Some(at) = Stop::all().iter().position(|stop| *stop == reading.stop) else { return Vec::new() };
        let starts = self.0.get(&key).map_or(&[][..], |starts| starts);
        let end = |(stiffness, retained, met): &(f64, usize, Vec<Option<(usize, f64)>>)| {
            let within = met.get(at).copied().flatten().filter(|(iterations, _)| *iterations <= reading.cap);
            End {
                stiffness: *stiffness,
                iterations: within.map(|(iterations, _)| iterations),
                error: within.map_or(f64::NAN, |(_, error)| error),
                retained: *retained,
            }
        };
        starts.iter().map(end).collect()
    }
}
