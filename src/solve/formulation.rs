//! One way of solving a contact problem: contact element × algorithm × rule × stiffness.

use crate::algorithm::{
    Acceleration, ContactProblem, Iteration, Leeway, Settings, Spring, Springs, StiffnessRule, iterate_from,
};
use crate::contact::{ContactPoint, Element, Interface, Quadrature};
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::Start;

/// One way of solving a contact problem.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Formulation {
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
    /// Initial stiffness κ₀ = k_n ℓ/E*.
    pub stiffness: f64,
    /// Factors on the initial stiffness, used cyclically from point to point; empty means 1.
    pub stiffness_pattern: Vec<f64>,
    /// How far varying stiffness lets its rule go in an iteration.
    pub leeway: Leeway,
    /// Quadrature of the line and layer elements.
    pub quadrature: Quadrature,
    /// Thickness `t₀` of the layer element over the length of its edge.
    pub layer_thickness: f64,
    /// Acceleration of constant stiffness; the paper has none.
    pub acceleration: Acceleration,
    /// Where kinematic load starts; in the paper with every candidate closed.
    pub start: Start,
    /// When to stop.
    pub settings: Settings,
}

impl Formulation {
    /// An element with an algorithm at their defaults.
    pub fn new(element: Element, algorithm: Iteration) -> Self {
        Self {
            element,
            algorithm,
            rule: algorithm.rules()[0],
            stiffness: algorithm.default_stiffness(),
            stiffness_pattern: Vec::new(),
            leeway: Leeway::default(),
            quadrature: Quadrature::Gauss,
            layer_thickness: 0.05,
            acceleration: Acceleration::None,
            start: Start::Closed,
            settings: Settings::default(),
        }
    }

    /// Node element with kinematic load at tolerance 1e-8: the formulation of the verification rows.
    pub fn verification() -> Self {
        Self::new(Element::Node, Iteration::Kinematic).tolerance(1e-8)
    }

    /// All nine, stopped where the engineering comparison of the paper needs it: p₀ and a to 1 %, a third of it for the
    /// iteration.
    pub fn compared() -> Vec<Self> {
        Self::nine().into_iter().map(|formulation| formulation.tolerance(3e-3)).collect()
    }

    /// All nine at their defaults.
    pub fn nine() -> Vec<Self> {
        let pairs = Element::ALL.into_iter().flat_map(|e| Iteration::ALL.map(move |a| (e, a)));
        pairs.map(|(element, algorithm)| Self::new(element, algorithm)).collect()
    }

    /// The same with another tolerance.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.settings.tolerance = tolerance;
        self
    }

    /// `element.algorithm`, and the rule, its bound, what has a stiffness, the acceleration and the start where they are not the default.
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
        if self.start != Start::Closed {
            name += &format!("+{}", self.start.name());
        }
        name
    }

    /// Whether the paper itself shows results of this element with this algorithm.
    pub fn is_in_the_paper(&self) -> bool {
        use {Element::*, Iteration::*};
        matches!((self.element, self.algorithm), (Line | Layer, Varying | Constant) | (Node, Kinematic))
    }

    /// Contact points of interfaces.
    pub(super) fn points(&self, interfaces: &[Interface]) -> Vec<ContactPoint> {
        let element = self.element.with(self.quadrature, self.layer_thickness);
        interfaces.iter().flat_map(|interface| element.points(interface)).collect()
    }

    /// Iterates a problem from given springs, which are left as they stand after the last iteration.
    pub(super) fn iterate(&self, springs: &mut Springs, problem: &ContactProblem) -> Result<Solution, Error> {
        let mut algorithm = self.algorithm.with(self.rule, self.leeway, self.acceleration, self.settings.tolerance);
        iterate_from(springs, problem, algorithm.as_mut(), self.settings)
    }
}
