//! A case: a scene with its mesh, the formulations that solve it, its oracle and its checks.

use std::path::PathBuf;
use std::sync::Arc;

use crate::accuracy::Asked;
use crate::case::check::{Against, Check, Reference};
use crate::case::file::Places;
use crate::case::quantity::Quantity;
use crate::measure::Quantity as Number;
use crate::mesh::{Order, Resolution};
use crate::oracle::{Oracle, SharedOracle};
use crate::scene::Scene;
use crate::solve::{Displaced, Formulation};

/// A claim, whether it was built in or read from a scene file.
#[derive(Clone)]
pub struct Case {
    /// Name in records, and on the command line.
    pub name: String,
    /// What it is, in a sentence.
    pub title: String,
    /// Where it comes from; empty where that is its oracle's.
    pub source: String,
    /// The scene.
    pub scene: Scene,
    /// Its mesh; with an accuracy the first one of the search.
    pub resolution: Resolution,
    /// The accuracy that chooses the mesh; none where it is given.
    pub accuracy: Option<Asked>,
    /// What it is solved by.
    pub formulations: Vec<Formulation>,
    /// Independent truth of each contact, in the order of the scene; what is left out has none.
    pub oracles: Vec<Option<SharedOracle>>,
    /// What its closed forms may be off of the scene, relative, where no check states it: 0 where they are of the very
    /// scene.
    pub model: f64,
    /// What shall hold; a case without checks is reported.
    pub checks: Vec<Check>,
    /// Where bodies and contacts stand in its file; none where it is built in.
    pub places: Option<Places>,
}

impl Case {
    /// A case without an oracle or checks, on 8-node cells, for the verification formulation.
    pub fn of(name: impl Into<String>, title: impl Into<String>, scene: Scene, elements: usize) -> Self {
        Self {
            name: name.into(),
            title: title.into(),
            source: String::new(),
            scene,
            resolution: Resolution { elements, refinement: 0, order: Order::Quadratic },
            accuracy: None,
            formulations: vec![Formulation::verification()],
            oracles: Vec::new(),
            model: 0.0,
            checks: Vec::new(),
            places: None,
        }
    }

    /// The same, its first contact held against an oracle.
    pub fn against(self, oracle: impl Oracle + Send + Sync + 'static) -> Self {
        Self { oracles: vec![Some(Arc::new(oracle))], ..self }
    }

    /// The same held to checks, each of which by its oracle leaves what closed forms leave.
    pub fn held_to(self, checks: impl IntoIterator<Item = Check>) -> Self {
        let leaving = |check: Check| match check.against {
            Against::Oracle => check.leaving(self.model),
            _ => check,
        };
        Self { checks: checks.into_iter().map(leaving).collect(), ..self }
    }

    /// The same under another name.
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// The files that it was read from: its own, and meshes; none of a case of the library.
    pub fn read_files(&self) -> Vec<PathBuf> {
        self.places.iter().flat_map(|places| places.read().cloned()).collect()
    }

    /// The displacements that its checks ask for.
    pub fn displaced(&self) -> Vec<Displaced> {
        let displaced = |check: &Check| match check.quantity.number() {
            Some(Number::Displacement(displaced)) => Some(displaced.clone()),
            _ => None,
        };
        self.checks.iter().filter_map(displaced).collect()
    }

    /// The oracle of the first contact.
    pub fn oracle(&self) -> Option<&SharedOracle> {
        self.oracle_of(0)
    }

    /// The oracle of a contact.
    pub fn oracle_of(&self, contact: usize) -> Option<&SharedOracle> {
        self.oracles.get(contact)?.as_ref()
    }

    /// The pressure of a contact's oracle at a contact coordinate \[MPa\]; NaN where there is no oracle or it cannot
    /// say.
    pub fn reference_pressure(&self, contact: usize, at: f64) -> f64 {
        self.reading(contact, &Number::Pressure { at }).value
    }

    /// What the oracle of a contact reads for a number of the scene, in its own unit; NaN, which no check passes, where
    /// there is no oracle or it cannot say.
    pub fn reading(&self, contact: usize, quantity: &Number) -> Reference {
        match self.oracle_of(contact) {
            Some(oracle) => Reference::of(oracle.as_ref(), &self.scene, contact, quantity),
            None => Reference::own("no oracle", f64::NAN),
        }
    }

    /// What the oracle of a contact reads for a quantity of a check, in the unit of that; NaN where no oracle reads it.
    pub fn reference(&self, contact: usize, quantity: &Quantity) -> Reference {
        match quantity {
            Quantity::Number { of, .. } => self.reading(contact, of).times(quantity.factor()),
            Quantity::Departure => self.reading(contact, &Number::PeakPressure),
            Quantity::Profile => Reference { value: 0.0, ..self.reading(contact, &Number::PeakPressure) },
            _ => Reference::own("no oracle reads it", f64::NAN),
        }
    }
}
