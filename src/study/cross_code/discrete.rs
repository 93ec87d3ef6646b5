//! The same discrete problem: our mesh, loads, supports and line elements, assembled and solved by another code.

use serde::Serialize;

use crate::error::Error;
use crate::mesh::Order;
use crate::oracle::cross_code::frozen::Digest;
use crate::oracle::cross_code::{Code, DiscreteAnswer};
use crate::study::answers::{Answers, Reproduced};
use crate::study::cross_code::answers::{Answered, answered};
use crate::study::cross_code::twin::Twin;
use crate::study::differences::{relative_difference, worst_difference};
use crate::study::handed_over::KAPPA;

/// A discrete problem in another code.
#[derive(Clone, Debug, Serialize)]
pub struct Compared {
    /// The code.
    pub code: Code,
    /// Whether it finds what was frozen; none where it was not asked.
    pub reproduced: Option<Reproduced>,
    /// Ours against its answer.
    pub differences: Vec<Difference>,
}

/// A relative difference from another code.
#[derive(Clone, Debug, Serialize)]
pub struct Difference {
    /// Of what.
    pub part: Part,
    /// By which numbers.
    pub by: String,
    /// The difference, over the largest of them.
    pub error: f64,
}

/// What both codes make of the same mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Part {
    /// The stiffness.
    Stiffness,
    /// The loads.
    Loads,
    /// The contact by penalty line elements.
    Contact,
}

impl Part {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Stiffness, Self::Loads, Self::Contact];
}

impl Difference {
    fn new(part: Part, by: impl Into<String>, error: f64) -> Self {
        Self { part, by: by.into(), error }
    }
}

/// A scene and order in another code.
pub fn compare(name: &str, order: Order, code: Code, answers: Answers) -> Result<Compared, Error> {
    let twin = Twin::of(name, order)?;
    let Answered { digest, whole, reproduced } = answered(answers, code, &twin)?;
    let mut differences = differences(&twin.digest(), &digest);
    differences.extend(whole.iter().flat_map(|answer| twin.in_full(answer)));
    Ok(Compared { code, reproduced, differences })
}

/// Ours against another code's, by their digests.
pub fn differences(ours: &Digest, theirs: &Digest) -> Vec<Difference> {
    let forms = relative_difference(&ours.forms.concat(), &theirs.forms.concat());
    let mut all = vec![
        Difference::new(Part::Stiffness, "vᵢᵀ K vⱼ, ten vectors", forms),
        Difference::new(Part::Loads, "vᵢ · f, ten vectors", relative_difference(&ours.work, &theirs.work)),
    ];
    for (index, kappa) in KAPPA.iter().enumerate() {
        let of = |list: &Vec<Vec<f64>>| list.get(index).cloned().unwrap_or_default();
        let pressure = relative_difference(&of(&ours.pressure), &of(&theirs.pressure));
        let moved = relative_difference(&of(&ours.moved), &of(&theirs.moved));
        all.push(Difference::new(Part::Contact, format!("p at the Gauss points, κ = {kappa:e}"), pressure));
        all.push(Difference::new(Part::Contact, format!("vᵢ · u, κ = {kappa:e}"), moved));
    }
    all
}

impl Twin {
    /// Every component of products, load and displacements, not only their digest.
    pub fn in_full(&self, answer: &DiscreteAnswer) -> [Difference; 3] {
        let reduced: Vec<Vec<f64>> = answer.products.iter().map(|product| self.along_unknowns(product)).collect();
        let product = worst_difference(&self.ours.products, &reduced);
        let load = relative_difference(&self.ours.load, &self.along_unknowns(&answer.load));
        let moved = worst_difference(&self.ours.displacement, &answer.displacement);
        [
            Difference::new(Part::Stiffness, "K v in every component, ten vectors", product),
            Difference::new(Part::Loads, "f in every component", load),
            Difference::new(Part::Contact, "u in every component, κ = 1e2 and 1e4", moved),
        ]
    }
}
