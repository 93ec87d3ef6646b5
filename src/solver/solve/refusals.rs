//! What a formulation is not defined for, refused before anything is solved, and problems that have no solution, with
//! the names of their bodies.

use crate::algorithm::problem::LIMITS;
use crate::algorithm::{Acceleration, ContactProblem, Iteration, Leeway, Spring, StiffnessRule};
use crate::contact::Quadrature;
use crate::error::{Error, Kind, Part, Place, positive};
use crate::scene::Scene;
use crate::solution::Work;
use crate::solve::{Change, Discretisation, Formulation};

/// Tolerances between round-off and no answer at all.
const TOLERANCES: [f64; 2] = [1e-13, 0.1];
/// Most contact points of which Newton's method keeps its matrix, a number for every two of them.
const DENSE: usize = 8000;

impl Formulation {
    /// A scene under this formulation, as errors name it.
    fn place(&self, scene: &Scene) -> Place {
        Place::Solve(format!("{} with {}", scene.name, self.name()))
    }

    /// Refuses what is not defined, naming value and remedy.
    pub fn validate(&self, scene: &Scene) -> Result<(), Error> {
        let place = self.place(scene);
        positive(&place, "stiffness", self.stiffness)?;
        let [softest, stiffest] = LIMITS;
        if !(softest..=stiffest).contains(&self.stiffness) {
            let expected = format!("springs are kept between {softest:e} and {stiffest:e} E*/ℓ");
            return Err(Error::value(&place, "stiffness", self.stiffness, expected, "give κ₀ within these limits"));
        }
        positive(&place, "tolerance", self.settings.tolerance)?;
        positive(&place, "layer thickness", self.layer_thickness)?;
        let [finest, coarsest] = TOLERANCES;
        if !(finest..=coarsest).contains(&self.settings.tolerance) {
            let expected = format!("iteration errors between {finest:e} (round-off) and {coarsest} can be asked for");
            return Err(Error::value(&place, "tolerance", self.settings.tolerance, expected, "use 1e-3 to 1e-8"));
        }
        if self.settings.increments == 0 {
            let remedy = "use 1 for the whole load at once";
            return Err(Error::value(place, "increments", 0, "at least 1 is needed", remedy));
        }
        if self.settings.max_iterations == 0 {
            let expected = "at least 1 is needed: nothing is solved without an iteration";
            return Err(Error::value(place, "max-iterations", 0, expected, "use 2000, or leave it out"));
        }
        let offered = [self.algorithm.rules(), self.algorithm.further_rules()].concat();
        if !offered.contains(&self.rule) {
            let names: Vec<&str> = offered.iter().map(|rule| rule.name()).collect();
            let message = format!("the {} algorithm has no rule `{}`", self.algorithm.name(), self.rule.name());
            return Err(Error::at(place, message, format!("choose one of {}", names.join(", "))));
        }
        if self.leeway.bound.is_nan() || self.leeway.bound <= 1.0 {
            let expected = "a factor above 1 is needed, or `inf` for none";
            return Err(Error::value(place, "bound", self.leeway.bound, expected, "use 2 to 100"));
        }
        if self.leeway != Leeway::default() && self.algorithm != Iteration::Varying {
            let message =
                format!("the {} algorithm has no stiffness that a rule changes step by step", self.algorithm.name());
            return Err(Error::at(place, message, "leave `bound` and `spring` out, or use the varying algorithm"));
        }
        if scene.is_of_revolution() && self.quadrature == Quadrature::Lobatto {
            let message = "points at the nodes of edges have no area on the axis of revolution";
            return Err(Error::at(place, message, "use the Gauss points of line and layer elements, or node elements"));
        }
        let has_fixed_point = match self.algorithm {
            Iteration::Varying => self.rule == StiffnessRule::Secant && self.leeway.spring == Spring::Point,
            Iteration::Constant => self.rule == StiffnessRule::Correction,
            Iteration::Kinematic => false,
        };
        if self.acceleration != Acceleration::None && !has_fixed_point {
            let (algorithm, rule, acceleration) = (self.algorithm.name(), self.rule.name(), self.acceleration.name());
            let message =
                format!("the {algorithm} algorithm with rule `{rule}` has no fixed point for `{acceleration}`");
            let remedy = "choose newton for constant with the rule correction, or for varying with the rule secant and \
                springs of points; else `none`";
            return Err(Error::at(place, message, remedy));
        }
        let tightest = scene.contacts.iter().map(|pair| pair.gap(0.0)).fold(f64::INFINITY, f64::min);
        self.refuse_interference(scene, tightest)
    }

    /// Refuses a gap \[mm\] that is an interference which the algorithm and rule cannot take.
    pub(super) fn refuse_interference(&self, scene: &Scene, gap: f64) -> Result<(), Error> {
        let takes_interference = matches!(
            (self.algorithm, self.rule),
            (Iteration::Kinematic, _) | (Iteration::Constant, StiffnessRule::Correction)
        );
        if gap < -ROUND_OFF * scene.reference.gap && !takes_interference {
            let message = format!(
                "the scene starts with an interference of {} mm, which this formulation cannot take",
                -gap as f32
            );
            let remedy = "use the kinematic algorithm, or constant with the rule correction";
            return Err(Error::at(self.place(scene), message, remedy));
        }
        Ok(())
    }

    /// Refuses an acceleration whose matrix would not fit.
    pub(super) fn refuse_dense(&self, scene: &Scene, points: usize) -> Result<(), Error> {
        if self.acceleration == Acceleration::None || points <= DENSE {
            return Ok(());
        }
        let bytes = 8.0 * (points as f64).powi(2);
        let message = format!("{} has a matrix of all {points} contact points, {bytes:.1e} bytes", self.name());
        Err(Error::at(scene.name.as_str(), message, "ask for kinematic load, or for no acceleration"))
    }
}

/// Interference over the reference gap that a formula leaves where bodies just touch: such a gap counts as none.
const ROUND_OFF: f64 = 1e-9;

/// A condensed load below this fraction of the loads on the bodies is round-off of the condensation.
const UNLOADED: f64 = 1e-13;

impl Discretisation {
    /// Refuses a formulation that is not defined for this scene after a change.
    pub(super) fn refuse_undefined(&self, formulation: &Formulation, change: Change) -> Result<(), Error> {
        formulation.validate(&self.scene)?;
        change.validate(&self.scene.name)?;
        formulation.refuse_interference(&self.scene, self.tightest_gap() + change.clearance)
    }

    /// Smallest initial gap of a candidate node \[mm\].
    fn tightest_gap(&self) -> f64 {
        let nodes = self.interfaces.iter().flat_map(|interface| &interface.nodes);
        nodes.map(|node| node.gap).fold(f64::INFINITY, f64::min)
    }

    /// Refuses a problem in which nothing presses and springs alone would hold the bodies.
    pub(super) fn refuse_nothing(&self, problem: &ContactProblem) -> Result<(), Error> {
        let held = || problem.factorise(&vec![0.0; problem.points.len()], &mut Work::default()).is_some();
        if self.is_unloaded(problem.load) && !held() && !problem.interference_presses() {
            let error = self.unheld(1.0)?.unwrap_or_else(|| {
                let message = "only contact fixes the bodies, and nothing presses them together: the pressure is zero \
                    and the position undetermined";
                Error::at(self.contacts(), message, "apply a load or add a support")
            });
            return Err(Error { kind: Kind::NothingPresses, ..error });
        }
        Ok(())
    }

    /// Whether a condensed load is no more than round-off of the loads on the bodies.
    fn is_unloaded(&self, condensed: &[f64]) -> bool {
        let sum = |forces: &[f64]| forces.iter().map(|f| f.abs()).sum::<f64>();
        sum(condensed) <= UNLOADED * self.system.bodies.iter().map(|body| sum(&body.force)).sum::<f64>()
    }

    /// An error of the iteration, which sees matrices only, with what is not held, or with the names of the bodies.
    pub(super) fn named(&self, error: Error, load: f64) -> Error {
        match error.kind {
            Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft => {}
            _ => return error,
        }
        match (self.unheld(load), error.kind) {
            (Err(other), _) => other,
            (Ok(Some(unheld)), Kind::NoSpringLeft { iterations }) => {
                let message = format!("no contact spring is left after iteration {iterations}: {}", unheld.message);
                Error { kind: error.kind, message, ..unheld }
            }
            (Ok(Some(unheld)), _) => unheld,
            (Ok(None), Kind::SpringsTooSoft) => Error { place: Place::Stiffness(self.names()), ..error },
            (Ok(None), _) => Error { place: self.contacts(), ..error },
        }
    }

    /// All contacts: the first of them, by the names of all bodies.
    fn contacts(&self) -> Place {
        Place::Contact { contact: 0, part: Part::First, name: self.names().into() }
    }

    /// Names of the bodies, as messages give them.
    fn names(&self) -> String {
        let bodies = self.scene.bodies.iter().map(|body| format!("`{}`", body.name));
        bodies.collect::<Vec<_>>().join(" and ")
    }
}
