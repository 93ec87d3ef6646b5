//! One point of the grid: contact element × algorithm × rule × stiffness.
//!
//! * [`again`] — another load or clearance on a condensation at hand.
//! * [`carried`] — a start from the contact set of another mesh.
//! * [`discretisation`] — a scene meshed, assembled and condensed, on which formulations solve.
//! * [`fields`] — displacements and stresses of a solution.
//! * [`mod@reactions`] — what the supports exert.
//! * [`spill`] — contact that goes on beyond the candidates.
//! * [`start`] — where kinematic load starts.
//! * [`run`] — one scene solved by one formulation, measured.
//! * [`unbounded`] — peaks without a limit.

pub mod again;
pub mod carried;
pub mod discretisation;
pub mod fields;
pub mod reactions;
pub mod run;
pub mod spill;
pub mod start;
pub mod unbounded;

use crate::algorithm::{Acceleration, Algorithm, Constant, Kinematic, StiffnessRule, Varying};
use crate::contact::{ContactElement, ContactPoint, Interface, Layer, Line, Node, Quadrature};
use crate::error::Error;
use crate::scene::Scene;

pub use crate::algorithm::Settings;
pub use crate::algorithm::problem::LIMITS;
pub use again::Change;
pub use discretisation::{Discretisation, STAGES};
pub use fields::Fields;
pub use reactions::Reaction;
pub use run::Run;
pub use start::Start;

/// Tolerances between round-off and no answer at all.
const TOLERANCES: [f64; 2] = [1e-13, 0.1];

/// Contact element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Element {
    /// Two facing edges joined by a distributed spring.
    Line,
    /// A thin element of fictitious material.
    Layer,
    /// One spring per node pair.
    Node,
}

/// Iteration algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Iteration {
    /// Varying stiffness.
    Varying,
    /// Constant stiffness.
    Constant,
    /// Kinematic load.
    Kinematic,
}

impl Element {
    /// All three, in the paper's order.
    pub const ALL: [Self; 3] = [Self::Line, Self::Layer, Self::Node];

    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Layer => "layer",
            Self::Node => "node",
        }
    }
}

impl Iteration {
    /// All three, in the paper's order.
    pub const ALL: [Self; 3] = [Self::Varying, Self::Constant, Self::Kinematic];

    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Varying => "varying",
            Self::Constant => "constant",
            Self::Kinematic => "kinematic",
        }
    }

    /// Rules the algorithm offers, the default first.
    pub fn rules(self) -> &'static [StiffnessRule] {
        match self {
            Self::Varying => &[StiffnessRule::Secant, StiffnessRule::Correction],
            Self::Constant => &[StiffnessRule::Correction, StiffnessRule::Secant, StiffnessRule::Literal],
            Self::Kinematic => &[StiffnessRule::Switching, StiffnessRule::Penalty],
        }
    }

    /// Default initial stiffness κ₀: that of the bodies, and under kinematic load one that hardly yields.
    pub fn default_stiffness(self) -> f64 {
        match self {
            Self::Varying | Self::Constant => 1.0,
            Self::Kinematic => 1e6,
        }
    }
}

/// One way of solving a contact problem.
#[derive(Clone, Debug)]
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

    /// `element.algorithm`, and the rule, the acceleration and the start where they are not the default.
    pub fn name(&self) -> String {
        let mut name = format!("{}.{}", self.element.name(), self.algorithm.name());
        if self.rule != self.algorithm.rules()[0] {
            name += &format!(".{}", self.rule.name());
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
        match self.algorithm {
            Iteration::Varying | Iteration::Constant => self.element != Element::Node,
            Iteration::Kinematic => self.element == Element::Node,
        }
    }

    fn points(&self, interfaces: &[Interface]) -> Vec<ContactPoint> {
        let of = |interface: &Interface| match self.element {
            Element::Line => Line { quadrature: self.quadrature }.points(interface),
            Element::Layer => Layer { quadrature: self.quadrature, thickness: self.layer_thickness }.points(interface),
            Element::Node => Node.points(interface),
        };
        interfaces.iter().flat_map(of).collect()
    }

    fn algorithm(&self) -> Box<dyn Algorithm> {
        match self.algorithm {
            Iteration::Varying => Box::new(Varying::new(self.rule)),
            Iteration::Constant => Box::new(Constant::accelerated(self.rule, self.acceleration)),
            Iteration::Kinematic => Box::new(Kinematic::new(self.rule, self.settings.tolerance)),
        }
    }

    /// Refuses what is not defined, naming value and remedy.
    pub fn validate(&self, scene: &Scene) -> Result<(), Error> {
        let place = format!("{} with {}", scene.name, self.name());
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
            return Err(Error::value(
                place,
                "increments",
                0,
                "at least 1 is needed",
                "use 1 for the whole load at once",
            ));
        }
        let offered = self.algorithm.rules();
        if !offered.contains(&self.rule) {
            let names: Vec<&str> = offered.iter().map(|rule| rule.name()).collect();
            return Err(Error::Combination {
                what: format!("the {} algorithm has no rule `{}`", self.algorithm.name(), self.rule.name()),
                remedy: format!("choose one of {}", names.join(", ")),
            });
        }
        self.validate_options()?;
        let tightest = scene.contacts.iter().map(|pair| pair.profile.gap(0.0)).fold(f64::INFINITY, f64::min);
        self.refuse_interference(scene, tightest)
    }

    /// Refuses a gap \[mm\] that is an interference which the algorithm and rule cannot take.
    fn refuse_interference(&self, scene: &Scene, gap: f64) -> Result<(), Error> {
        let takes_interference = matches!(
            (self.algorithm, self.rule),
            (Iteration::Kinematic, _) | (Iteration::Constant, StiffnessRule::Correction)
        );
        if gap < 0.0 && !takes_interference {
            return Err(Error::Combination {
                what: format!(
                    "{} starts with an interference of {} mm, which {} cannot take",
                    scene.name,
                    -gap,
                    self.name()
                ),
                remedy: "use the kinematic algorithm, or constant with the rule correction".into(),
            });
        }
        Ok(())
    }

    /// Refuses an acceleration or a start that the algorithm does not have.
    fn validate_options(&self) -> Result<(), Error> {
        let algorithm = self.algorithm.name();
        if self.acceleration != Acceleration::None && self.algorithm != Iteration::Constant {
            return Err(Error::Combination {
                what: format!("the {algorithm} algorithm has no fixed point for `{}`", self.acceleration.name()),
                remedy: "accelerate the constant algorithm, or choose the acceleration `none`".into(),
            });
        }
        if self.start != Start::Closed && self.algorithm != Iteration::Kinematic {
            return Err(Error::Combination {
                what: format!("the {algorithm} algorithm has no contact set to start `{}` from", self.start.name()),
                remedy: "start the kinematic algorithm so, or choose the start `closed`".into(),
            });
        }
        if self.start != Start::Closed && self.settings.increments > 1 {
            return Err(Error::Combination {
                what: "a nested start carries the contact of the whole load, which increments do not begin with".into(),
                remedy: "use 1 increment, or choose the start `closed`".into(),
            });
        }
        Ok(())
    }
}
