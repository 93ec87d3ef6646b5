//! What a formulation is not defined for: refused before anything is solved.

use crate::algorithm::problem::LIMITS;
use crate::algorithm::{Acceleration, Iteration, Leeway, Spring, StiffnessRule};
use crate::contact::Quadrature;
use crate::error::{Error, Place};
use crate::scene::Scene;
use crate::solve::Formulation;

/// Tolerances between round-off and no answer at all.
const TOLERANCES: [f64; 2] = [1e-13, 0.1];

impl Formulation {
    /// A scene under this formulation, as errors name it.
    fn place(&self, scene: &Scene) -> Place {
        Place::Solve(format!("{} with {}", scene.name, self.name()))
    }

    /// Refuses what is not defined, naming value and remedy.
    pub fn validate(&self, scene: &Scene) -> Result<(), Error> {
        let place = self.place(scene);
        let number = |key: &str, value: f64| {
            if value.is_finite() && value > 0.0 {
                return Ok(());
            }
            Err(Error::value(&place, key, value, "a finite value above 0 is needed", "give a positive number"))
        };
        number("stiffness", self.stiffness)?;
        let [softest, stiffest] = LIMITS;
        if !(softest..=stiffest).contains(&self.stiffness) {
            let expected = format!("springs are kept between {softest:e} and {stiffest:e} E*/ℓ");
            return Err(Error::value(&place, "stiffness", self.stiffness, expected, "give κ₀ within these limits"));
        }
        number("tolerance", self.settings.tolerance)?;
        number("layer thickness", self.layer_thickness)?;
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
        self.validate_options(place)?;
        let tightest = scene.contacts.iter().map(|pair| pair.gap(0.0)).fold(f64::INFINITY, f64::min);
        self.refuse_interference(scene, tightest)
    }

    /// Refuses a gap \[mm\] that is an interference which the algorithm and rule cannot take.
    pub(super) fn refuse_interference(&self, scene: &Scene, gap: f64) -> Result<(), Error> {
        let takes_interference = matches!(
            (self.algorithm, self.rule),
            (Iteration::Kinematic, _) | (Iteration::Constant, StiffnessRule::Correction)
        );
        if gap < 0.0 && !takes_interference {
            let message =
                format!("the scene starts with an interference of {} mm, which this formulation cannot take", -gap);
            let remedy = "use the kinematic algorithm, or constant with the rule correction";
            return Err(Error::at(self.place(scene), message, remedy));
        }
        Ok(())
    }

    /// Refuses an acceleration that the algorithm does not have.
    fn validate_options(&self, place: Place) -> Result<(), Error> {
        let refused = |message: String, remedy: &str| Err(Error::at(place, message, remedy));
        let algorithm = self.algorithm.name();
        let is_point = self.leeway.spring == Spring::Point;
        let has_fixed_point = match self.algorithm {
            Iteration::Varying => self.rule == StiffnessRule::Secant && is_point,
            Iteration::Constant => self.rule == StiffnessRule::Correction,
            Iteration::Kinematic => false,
        };
        if self.acceleration != Acceleration::None && !has_fixed_point {
            let rule = self.rule.name();
            return refused(
                format!(
                    "the {algorithm} algorithm with rule `{rule}` has no fixed point for `{}`",
                    self.acceleration.name()
                ),
                "choose newton for constant with the rule correction, or for varying with the rule secant and springs of points; else `none`",
            );
        }
        Ok(())
    }
}
