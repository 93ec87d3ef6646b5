//! One way of solving a contact problem: contact element × algorithm × rule × stiffness.

use crate::algorithm::{
    Acceleration, ContactProblem, Iteration, Leeway, Settings, Spring, Springs, StiffnessRule, StiffnessUnit,
    iterate_from,
};
use crate::contact::{ContactPoint, Element, Interface, Quadrature};
use crate::error::Error;
use crate::solution::Solution;

/// One way of solving a contact problem.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Formulation {
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// What that is a multiple of; `E*/ℓ` in the paper.
    pub stiffness_unit: StiffnessUnit,
    /// Factors on the initial stiffness, used cyclically from point to point; empty means 1.
    pub stiffness_pattern: Vec<f64>,
    /// How far varying stiffness lets its rule go in an iteration.
    pub leeway: Leeway,
    /// Quadrature of the line and layer elements.
    pub quadrature: Quadrature,
    /// Thickness `t₀` of the layer element over the length of its edge.
    pub layer_thickness: f64,
    /// Acceleration of varying and constant stiffness; the paper has none.
    pub acceleration: Acceleration,
    /// When to stop.
    pub settings: Settings,
}

impl Formulation {
    /// An element with an algorithm of the paper, as it stands there.
    pub fn new(element: Element, algorithm: Iteration) -> Self {
        Self {
            element,
            algorithm,
            rule: algorithm.rules()[0],
            stiffness: algorithm.default_stiffness(),
            stiffness_unit: StiffnessUnit::Reference,
            stiffness_pattern: Vec::new(),
            leeway: Leeway::default(),
            quadrature: Quadrature::Gauss,
            layer_thickness: 0.05,
            acceleration: Acceleration::None,
            settings: Settings::default(),
        }
    }

    /// The same as the program and its pages take it where no more is said: varying and constant stiffness by Newton's
    /// method, with which every scene of the library converges.
    ///
    /// Under kinematic load the points of line and layer start from 10 by the bodies: from the hardest springs
    /// pressures of neighbouring points alternate where they are more than displacements can follow, and do not settle.
    pub fn accelerated(element: Element, algorithm: Iteration) -> Self {
        let paper = Self::new(element, algorithm);
        match (algorithm, element) {
            (Iteration::Varying | Iteration::Constant, _) => Self { acceleration: Acceleration::Newton, ..paper },
            (Iteration::Kinematic, Element::Node) => paper,
            (Iteration::Kinematic, _) => Self { stiffness: 10.0, stiffness_unit: StiffnessUnit::Bodies, ..paper },
        }
    }

    /// The same with a rule and an acceleration that may be asked for: what is neither accelerated nor asked to be is
    /// the paper's.
    pub fn with(
        element: Element,
        algorithm: Iteration,
        rule: Option<StiffnessRule>,
        acceleration: Option<Acceleration>,
    ) -> Self {
        let own = Self::accelerated(element, algorithm);
        let rule = rule.unwrap_or(own.rule);
        let by_default = if rule == own.rule { own.acceleration } else { Acceleration::None };
        let acceleration = acceleration.unwrap_or(by_default);
        let is_own = (rule, acceleration) == (own.rule, own.acceleration);
        Self { rule, acceleration, ..if is_own { own } else { Self::new(element, algorithm) } }
    }

    /// The same with a stiffness for every point, or for every element, which is not accelerated unless that is asked
    /// for.
    pub fn with_springs(self, spring: Spring, acceleration: Option<Acceleration>) -> Self {
        let by_default = if spring == Spring::Point { self.acceleration } else { Acceleration::None };
        let leeway = Leeway { spring, ..self.leeway };
        Self { leeway, acceleration: acceleration.unwrap_or(by_default), ..self }
    }

    /// The same in place of a scene's own: it begins from its own defaults, and keeps increments and cap of iterations.
    pub fn in_place_of(self, own: &Self) -> Self {
        let Settings { increments, max_iterations, .. } = own.settings;
        Self { settings: Settings { increments, max_iterations, ..self.settings }, ..self }
    }

    /// The same discrete problem by kinematic load with its own defaults, which converges where others may not.
    pub fn by_kinematic_load(&self) -> Self {
        let own = Self {
            quadrature: self.quadrature,
            layer_thickness: self.layer_thickness,
            ..Self::new(self.element, Iteration::Kinematic)
        };
        own.tolerance(self.settings.tolerance)
    }

    /// Node element with kinematic load at tolerance 1e-8: the formulation of the verification rows.
    pub fn verification() -> Self {
        Self::new(Element::Node, Iteration::Kinematic).tolerance(1e-8)
    }

    /// All nine as the program takes them.
    pub fn compared() -> Vec<Self> {
        Self::pairs().map(|(element, algorithm)| Self::accelerated(element, algorithm)).collect()
    }

    /// All nine as they stand in the paper.
    pub fn nine() -> Vec<Self> {
        Self::pairs().map(|(element, algorithm)| Self::new(element, algorithm)).collect()
    }

    fn pairs() -> impl Iterator<Item = (Element, Iteration)> {
        Element::ALL.into_iter().flat_map(|element| Iteration::ALL.map(move |algorithm| (element, algorithm)))
    }

    /// The same with another tolerance.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.settings.tolerance = tolerance;
        self
    }

    /// `element.algorithm`, and the rule, its bound, what has a stiffness, and the acceleration where they are not the
    /// default.
    pub fn name(&self) -> String {
        let mut name = format!("{}.{}", self.element.name(), self.algorithm.name());
        if self.rule != self.algorithm.rules()[0] {
            name += &format!(".{}", self.rule.name());
        }
        let Leeway { bound, spring } = self.leeway;
        if bound.is_infinite() {
            name += ".unbounded";
        } else if bound != Leeway::default().bound {
            name += &format!(".bound-{bound}");
        }
        if spring != Spring::Point {
            name += &format!(".per-{}", spring.name());
        }
        if self.acceleration != Acceleration::None {
            name += &format!("+{}", self.acceleration.name());
        }
        name
    }

    /// Whether it differs from another in stiffness, points and settings at most.
    pub fn is_like(&self, other: &Self) -> bool {
        let all = |one: &Self| (one.element, one.algorithm, one.rule, one.leeway, one.acceleration);
        all(self) == all(other)
    }

    /// Whether the paper itself shows results of this element with this algorithm.
    pub fn is_in_the_paper(&self) -> bool {
        use {Element::*, Iteration::*};
        matches!((self.element, self.algorithm), (Line | Layer, Varying | Constant) | (Node, Kinematic))
    }

    /// Contact points of interfaces.
    pub(super) fn points(&self, interfaces: &[Interface]) -> Vec<ContactPoint> {
        let points = |one| self.element.points(one, self.quadrature, self.layer_thickness);
        interfaces.iter().flat_map(points).collect()
    }

    /// Iterates a problem from given springs, which are left as they stand after the last iteration.
    pub(super) fn iterate(&self, springs: &mut Springs, problem: &ContactProblem) -> Result<Solution, Error> {
        let mut algorithm = self.algorithm.with(self.rule, self.leeway, self.acceleration, self.settings.tolerance);
        iterate_from(springs, problem, algorithm.as_mut(), self.settings)
    }
}
