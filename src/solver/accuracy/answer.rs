//! What is asked, and what is answered.

use crate::accuracy::bar::{Barred, Bars, bars_up_to, of_family};
use crate::accuracy::family::Family;
use crate::error::Error;
use crate::measure::{Quantity, larger};
use crate::mesh::size::MOST;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Displaced};

/// What is asked.
#[derive(Clone, Debug)]
pub struct Asked {
    /// Relative error that may remain.
    pub relative: f64,
    /// In which quantities.
    pub quantities: Vec<Quantity>,
    /// Most cells of a mesh that is tried.
    pub most_cells: f64,
    /// Most dofs of any mesh that is solved, those of the error bars among them; none where there is no bound.
    pub most_dofs: Option<usize>,
    /// Whether cells of order 5 to 8 that end with the contacts are tried.
    pub high_order: bool,
    /// Displacements whose bars are asked for with the others, besides those of loaded sides.
    pub wanted: Vec<Displaced>,
}

impl Asked {
    /// A relative error in peak and half-width, by meshes of any size that is solved at all.
    pub fn new(relative: f64) -> Self {
        Self {
            relative,
            quantities: Quantity::ASKED.into(),
            most_cells: MOST[0],
            most_dofs: None,
            high_order: true,
            wanted: vec![],
        }
    }
}

/// What came out.
#[derive(Debug)]
pub struct Answer {
    /// The scene with the candidates and growth of the mesh answered.
    pub scene: Scene,
    /// The mesh answered.
    pub resolution: Resolution,
    /// Its run.
    pub run: Run,
    /// What is said of each quantity.
    pub estimates: Vec<Barred>,
    /// Why the accuracy is not met; none where it is.
    pub unmet: Option<String>,
    /// Dofs of the mesh that would have been next, where more than are allowed ended the search.
    pub next: Option<usize>,
    /// Every mesh solved, in order.
    pub tried: Vec<Tried>,
    /// The mesh answered, assembled and condensed, where it was the last one or the one that this judges.
    pub discretisation: Option<Discretisation>,
    /// The finer mesh that judges it, and its run.
    pub judge: Option<(Discretisation, Run)>,
    /// What the meshes that told its bars say, where no finer one judges it.
    pub family: Option<Family>,
}

impl Answer {
    /// The bars of all numbers of a run on the mesh answered, by meshes that the search has solved, and otherwise by as
    /// many dofs as it may.
    pub fn bars(&self, asked: &Asked, discretisation: &Discretisation, run: &Run) -> Result<Bars, Error> {
        if let Some(family) = &self.family {
            let all = of_family(discretisation, run, family, Some(&asked.wanted))?;
            return Ok(Bars { all, meshes: family.meshes(), dofs: family.dofs() });
        }
        let judge = self.judge.as_ref().map(|(finer, judge)| (finer, judge));
        bars_up_to(asked.most_dofs, judge, discretisation, run, &asked.wanted)
    }

    /// Degrees of freedom of all meshes solved, with those of the bars.
    pub fn dofs_in_all(&self) -> usize {
        self.tried.iter().map(|tried| tried.dofs + tried.coarser).sum()
    }

    /// Those of the largest mesh solved: in most searches the last one, which judges the one answered.
    pub fn most_dofs(&self) -> usize {
        self.tried.iter().map(|tried| tried.dofs).max().unwrap_or(0)
    }

    /// Largest estimated relative error of the quantities asked for; NaN where nothing is known.
    pub fn estimate(&self) -> f64 {
        largest(&self.estimates)
    }
}

/// The quantities asked for of every contact that touches, with their bars.
pub(super) fn quoted(bars: &[Barred], run: &Run, asked: &Asked) -> Vec<Barred> {
    let touches = |contact: usize| run.contacts[contact].open != Some(true);
    let is_asked = |one: &&Barred| touches(one.contact) && asked.quantities.contains(&one.quantity);
    bars.iter().filter(is_asked).cloned().collect()
}

/// A mesh that was solved.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "OneMesh"))]
pub struct Tried {
    /// What it was solved for.
    pub purpose: &'static str,
    /// Order of its elements.
    #[serde(serialize_with = "number")]
    #[cfg_attr(feature = "schema", schemars(with = "u8"))]
    pub order: Order,
    /// Elements within the contact, within half of it where it has both sides; within that of fewest where there are
    /// several.
    #[cfg_attr(feature = "schema", schemars(description = "Its candidate elements."))]
    pub elements: usize,
    /// Growth along the surface; NaN where the mesh of every body is given.
    #[cfg_attr(feature = "schema", schemars(description = "Its growth."))]
    pub growth: f64,
    /// Dofs; 0 where contact went on beyond the candidates.
    #[serde(rename = "freedoms")]
    #[cfg_attr(feature = "schema", schemars(description = "Its degrees of freedom."))]
    pub dofs: usize,
    /// Those of the coarser meshes of its bars.
    #[serde(skip)]
    pub coarser: usize,
    /// Iterations on it.
    #[serde(rename = "steps")]
    pub iterations: usize,
    /// What it found of each contact.
    pub contacts: Vec<TriedContact>,
    /// Largest estimated relative error of the quantities asked for; NaN where there is none yet.
    #[cfg_attr(feature = "schema", schemars(description = "Its estimate."))]
    pub estimate: f64,
}

fn number<S: serde::Serializer>(order: &Order, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_u8(order.number())
}

impl Tried {
    /// A mesh of which nothing is known but what it was for, its order, and the candidates of its contact.
    pub(super) fn unsolved(purpose: &'static str, order: Order, stretch: f64) -> Self {
        let contacts = vec![TriedContact { stretch, peak: f64::NAN, half_width: f64::NAN }];
        let [elements, dofs, coarser, iterations] = [0; 4];
        let [growth, estimate] = [f64::NAN; 2];
        Self { purpose, order, elements, growth, dofs, coarser, iterations, contacts, estimate }
    }
}

/// What one mesh says of one contact.
#[derive(Clone, Copy, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TriedContact {
    /// Candidate stretch \[mm, or rad\].
    pub stretch: f64,
    /// Peak pressure \[MPa\].
    #[serde(rename = "peak_pressure")]
    pub peak: f64,
    /// Half-width \[mm, or rad\].
    pub half_width: f64,
}

/// Largest relative bar; NaN where one is, or none is known.
pub(super) fn largest(quoted: &[Barred]) -> f64 {
    if quoted.is_empty() {
        return f64::NAN;
    }
    quoted.iter().map(Barred::relative).fold(0.0, larger)
}
