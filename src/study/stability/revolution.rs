//! Bodies of revolution: whether the halving law, the averaged map and the methods to use of plane scenes are theirs too.

use rayon::prelude::*;

use crate::case::library::Indented;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::largest;
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::revolution::indentation::Indentation;
use crate::scene::Scene;
use crate::solve::{Discretisation, Element, Ended, Formulation, Iteration, Run};
use crate::stability::halving;
use crate::study::method::Method;

/// A name and what makes its scene.
type Made = (&'static str, fn() -> Indented);

/// Scenes by their names.
pub(super) const SCENES: [Made; 2] = [("truncated sphere", || Indented::by_sphere(0.05)), ("cone", Indented::by_cone)];
/// Candidates over the radius of the contact: just outside it, and up to half of the block.
const STRETCHES: [f64; 5] = [1.15, 1.4, 1.9, 2.9, 3.9];
/// Initial stiffnesses: every other decade of twelve.
const STARTS: [f64; 7] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6];
/// Elements on the radius of the contact.
const ELEMENTS: usize = 8;
/// Iterations within which a law is met.
const HALVINGS: f64 = 1.0;
/// Halvings that find where a pressure changes its sign.
const BISECTIONS: usize = 60;

/// How runs end on candidates of one length.
#[derive(Clone, Copy, Debug)]
pub struct Revolved {
    /// Candidate stretch over the radius of the contact.
    pub stretch: f64,
    /// Iterations of kinematic load on nodes, as the program takes it.
    pub iterations: usize,
    /// Those by the halving law of the plane.
    pub halving: usize,
    /// Those by the closed form of contact that is kept up to a radius.
    pub kept: usize,
    /// Runs of constant stiffness with correction from any start, and how many of them diverge or cycle.
    pub averaged: [usize; 2],
    /// Runs of all nine as the program takes them and of kinematic load on nodes from any start, and how many of them do not converge.
    pub used: [usize; 2],
}

/// A scene on candidates of every length.
pub(super) fn revolved(scene: fn() -> Indented) -> Result<Vec<Revolved>, Error> {
    STRETCHES.into_par_iter().map(|stretch| Revolved::of(&scene(), stretch)).collect()
}

impl Revolved {
    fn of(indented: &Indented, stretch: f64) -> Result<Self, Error> {
        let (mut scene, a): (Scene, f64) = (indented.scene(), indented.contact.radius);
        scene.contacts[0].stretch = stretch * a;
        let resolution = Resolution { elements: ELEMENTS, refinement: 0, order: Order::Quadratic };
        let discretisation = Discretisation::of(scene, resolution)?;
        let ended = |formulation: &Formulation| Ended::of(&Run::of(&discretisation, formulation));
        let all = |formulations: Vec<Formulation>| formulations.iter().map(ended).collect::<Result<Vec<_>, _>>();
        let from = |method: Method| STARTS.map(|stiffness| method.formulation(stiffness));
        let kinematic = Method::usual(Element::Node, Iteration::Kinematic);
        let plain = Element::ALL.map(|element| Method::usual(element, Iteration::Constant));
        let plain = all(plain.into_iter().flat_map(from).collect())?;
        let used = all(Formulation::compared().into_iter().chain(from(kinematic)).collect())?;
        let own = Formulation::new(Element::Node, Iteration::Kinematic);
        let spacing = stretch * a / (discretisation.interfaces[0].nodes.len() - 1) as f64;
        let wrong = plain.iter().filter(|(class, _)| [Ended::Diverged, Ended::Cycling].contains(class)).count();
        let converged = used.iter().filter(|(class, _)| *class == Ended::Converged).count();
        Ok(Self {
            stretch,
            iterations: ended(&own)?.1,
            halving: halving::iterations(stretch * a, a, spacing, own.stiffness),
            kept: iterations(&indented.contact, stretch * a, spacing),
            averaged: [plain.len(), wrong],
            used: [used.len(), used.len() - converged],
        })
    }
}

/// Iterations from contact that is kept up to a radius, each of which opens what pulls, until less than a node spacing of that is left;
/// one more confirms it.
fn iterations(contact: &Indentation, from: f64, spacing: f64) -> usize {
    let a = contact.radius;
    let radii = std::iter::successors(Some(shrunk(contact, from)), |radius| Some(shrunk(contact, *radius)));
    2 + radii.take_while(|radius| radius * radius - a * a > 2.0 * a * spacing).count()
}

/// Up to where contact presses that is kept up to a radius under the load of a smaller one.
fn shrunk(contact: &Indentation, radius: f64) -> f64 {
    let kept = Indentation { radius, ..contact.clone() };
    // A flat punch pulls with what is too much.
    let pulled = Indentation::flat(contact.modulus, radius, kept.load() - contact.load());
    let [mut low, mut high] = [0.0, radius];
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        *if kept.pressure(middle) > pulled.pressure(middle) { &mut low } else { &mut high } = middle;
    }
    low
}

/// The laws hold, and what is to be used converges.
pub fn judge_revolved(rows: &[Revolved]) -> Vec<Judged> {
    let off = rows.iter().map(|row| (row.iterations as f64 - row.kept as f64).abs());
    let law = Check::at_most(
        "largest number of iterations off those of contact kept up to a radius, on nodes under kinematic load",
        Reference::own("the closed form's", HALVINGS),
        "each iteration opens what pulls; the last one may end anywhere within a node spacing",
    );
    let sum = |of: fn(&Revolved) -> [usize; 2]| {
        rows.iter().map(of).fold([0, 0], |[runs, wrong], row| [runs + row[0], wrong + row[1]])
    };
    let none = |what: &'static str, [runs, wrong]: [usize; 2], because: &'static str| {
        let wrong = if runs > 0 { wrong as f64 } else { f64::NAN };
        Check::none(Quantity::at(what, format!("of {runs}")), because).judge(wrong)
    };
    vec![
        law.judge(if rows.is_empty() { f64::NAN } else { largest(off) }),
        none(
            "run of constant stiffness with correction that diverges or cycles on a body of revolution",
            sum(|row| row.averaged),
            "an averaged map comes no farther from its limit at any iteration, whatever the bodies are",
        ),
        none(
            "run that does not converge on a body of revolution of all nine, and of kinematic load on nodes from any start",
            sum(|row| row.used),
            "acceleration, κ₀ and tolerance were chosen in the plane",
        ),
    ]
}

/// Every row with the name of its scene.
pub(super) fn table_of_revolved(rows: &[(&str, &Revolved)]) -> String {
    let columns: [Column<(&str, &Revolved)>; 7] = [
        ("scene", |(scene, _)| scene.to_string()),
        ("L/a", |(_, row)| row.stretch.to_string()),
        ("iterations", |(_, row)| row.iterations.to_string()),
        ("by the closed form", |(_, row)| row.kept.to_string()),
        ("by halving L² − a²", |(_, row)| row.halving.to_string()),
        ("`constant.correction`: diverge or cycle", |(_, row)| format!("{} of {}", row.averaged[1], row.averaged[0])),
        ("nine, and `node.kinematic` from any κ₀: do not converge", |(_, row)| {
            format!("{} of {}", row.used[1], row.used[0])
        }),
    ];
    markdown::columns(&columns, rows)
}
