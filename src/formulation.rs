//! One point of the grid: contact element × algorithm × rule × stiffness, on a discretised scene.

use std::time::Instant;

use crate::algorithm::{
    Algorithm, Constant, ContactProblem, Kinematic, Scale, Settings, StiffnessRule, Varying, iterate,
};
use crate::condensation::{self, Condensed, CoupledSpring};
use crate::contact::{ContactElement, ContactPoint, Interface, Layer, Line, Node, Quadrature};
use crate::elasticity::{ElasticSystem, stress};
use crate::error::Error;
use crate::mesh::{Mesh, Resolution};
use crate::scene::Scene;
use crate::solution::Solution;

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

    /// Default initial stiffness κ₀ with an element.
    ///
    /// Kinematic load starts hard on nodes. On the Gauss points of line and layer elements hard springs let a pressure
    /// mode grow that no node feels (alternating sign); 2e3 keeps it below a few per cent while the penetration,
    /// about `1/κ₀` of the gap at the edge of a Hertz contact, stays below the default tolerance.
    pub fn default_stiffness(self, element: Element) -> f64 {
        match (self, element) {
            (Self::Varying | Self::Constant, _) => 1.0,
            (Self::Kinematic, Element::Node) => 1e6,
            (Self::Kinematic, Element::Line | Element::Layer) => 2e3,
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
            stiffness: algorithm.default_stiffness(element),
            stiffness_pattern: Vec::new(),
            quadrature: Quadrature::Gauss,
            layer_thickness: 0.05,
            settings: Settings::default(),
        }
    }

    /// Node element with kinematic load at tolerance 1e-8: the formulation of the verification rows.
    pub fn verification() -> Self {
        Self::new(Element::Node, Iteration::Kinematic).tolerance(1e-8)
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

    /// `element.algorithm`, and the rule where it is not the default.
    pub fn name(&self) -> String {
        let base = format!("{}.{}", self.element.name(), self.algorithm.name());
        if self.rule == self.algorithm.rules()[0] { base } else { format!("{base}.{}", self.rule.name()) }
    }

    /// Whether the paper itself shows results of this element with this algorithm.
    pub fn is_in_the_paper(&self) -> bool {
        match self.algorithm {
            Iteration::Varying | Iteration::Constant => self.element != Element::Node,
            Iteration::Kinematic => self.element == Element::Node,
        }
    }

    fn points(&self, interface: &Interface) -> Vec<ContactPoint> {
        match self.element {
            Element::Line => Line { quadrature: self.quadrature }.points(interface),
            Element::Layer => Layer { quadrature: self.quadrature, thickness: self.layer_thickness }.points(interface),
            Element::Node => Node.points(interface),
        }
    }

    fn algorithm(&self) -> Box<dyn Algorithm> {
        match self.algorithm {
            Iteration::Varying => Box::new(Varying { rule: self.rule }),
            Iteration::Constant => Box::new(Constant::new(self.rule)),
            Iteration::Kinematic => Box::new(Kinematic { rule: self.rule, tolerance: self.settings.tolerance }),
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
        number("tolerance", self.settings.tolerance)?;
        number("layer thickness", self.layer_thickness)?;
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
        let gap = scene.contact.profile.gap(0.0);
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
}

/// A scene meshed, assembled and condensed: what all nine formulations share.
#[derive(Debug)]
pub struct Discretisation {
    /// The scene.
    pub scene: Scene,
    /// How fine it is.
    pub resolution: Resolution,
    /// Mesh.
    pub mesh: Mesh,
    /// Assembled bodies.
    pub system: ElasticSystem,
    /// Condensed bodies.
    pub condensed: Condensed,
    /// Candidate stretch.
    pub interface: Interface,
    /// Seconds by stage.
    pub seconds: Vec<(&'static str, f64)>,
}

impl Discretisation {
    /// Mesh, assembly, condensation and interface of a scene.
    pub fn of(scene: Scene, resolution: Resolution) -> Result<Self, Error> {
        let mut clock = Clock::start();
        let mesh = Mesh::of(&scene, resolution)?;
        clock.lap("mesh");
        let system = ElasticSystem::assemble(&scene, &mesh)?;
        clock.lap("assembly");
        Self::from_parts(scene, resolution, mesh, system, clock)
    }

    /// The same from a mesh and a system at hand, for instance perturbed or renumbered ones.
    pub fn of_system(scene: Scene, resolution: Resolution, mesh: Mesh, system: ElasticSystem) -> Result<Self, Error> {
        Self::from_parts(scene, resolution, mesh, system, Clock::start())
    }

    fn from_parts(
        scene: Scene,
        resolution: Resolution,
        mesh: Mesh,
        system: ElasticSystem,
        mut clock: Clock,
    ) -> Result<Self, Error> {
        let condensed = system.condense()?;
        clock.lap("condensation");
        let interface = Interface::between(&scene, &mesh, &condensed)?;
        clock.lap("interface");
        Ok(Self { scene, resolution, mesh, system, condensed, interface, seconds: clock.laps })
    }

    /// Solves the contact problem by one formulation.
    pub fn solve(&self, formulation: &Formulation) -> Result<Solution, Error> {
        formulation.validate(&self.scene)?;
        let points = formulation.points(&self.interface);
        let problem = self.problem(formulation, &points);
        iterate(&problem, formulation.algorithm().as_mut(), formulation.settings).map_err(|error| match error {
            Error::NoSpringLeft { steps, .. } => Error::NoSpringLeft { bodies: self.names(), steps },
            other => other,
        })
    }

    /// What the algorithms see of this scene under a formulation.
    pub fn problem<'a>(&'a self, formulation: &Formulation, points: &'a [ContactPoint]) -> ContactProblem<'a> {
        let reference = &self.scene.reference;
        let unit = self.scene.contact_modulus() / reference.length;
        let pattern = |i: usize| match formulation.stiffness_pattern.len() {
            0 => 1.0,
            n => formulation.stiffness_pattern[i % n],
        };
        let nominal = formulation.stiffness * unit;
        ContactProblem {
            stiffness: &self.condensed.stiffness,
            load: &self.condensed.load,
            points,
            scale: Scale { pressure: reference.pressure, gap: reference.gap, stiffness: unit },
            initial: points.iter().enumerate().map(|(i, p)| nominal * pattern(i) * p.relative_stiffness).collect(),
        }
    }

    /// Contact points of a formulation.
    pub fn points(&self, formulation: &Formulation) -> Vec<ContactPoint> {
        formulation.points(&self.interface)
    }

    /// Displacement \[mm\] and stress \[MPa\] at every node, by one back-substitution per body.
    pub fn recover(&self, solution: &Solution) -> Result<Fields, Error> {
        let unknowns = self.condensed.recover(&self.system, &solution.displacement, &solution.contact_force);
        let displacement = self.system.nodal_displacements(&unknowns);
        let stress = stress::at_nodes(&self.scene, &self.mesh, &displacement)?;
        Ok(Fields { displacement, stress, unknowns })
    }

    /// The spring pressures of a solution once more, from the full system without condensation \[MPa\].
    ///
    /// Every loaded point is replaced by a spring around the condensed solution, `p = p_s + k (w − w_s)`; the sparse
    /// system of all bodies then gives `w`, and with it `p`, without S having been used.
    pub fn uncondensed_pressures(&self, formulation: &Formulation, solution: &Solution) -> Result<Vec<f64>, Error> {
        let points = formulation.points(&self.interface);
        let stiffness = CHECKING_STIFFNESS * self.scene.contact_modulus() / self.scene.reference.length;
        let states: Vec<(f64, f64, f64)> = (solution.points.iter().zip(&points).zip(&solution.spring_pressures))
            .map(|((state, point), &p)| (point.gap - state.gap, p, if p.abs() > 0.0 { stiffness } else { 0.0 }))
            .collect();
        let springs: Vec<_> = (points.iter().zip(&states))
            .map(|(point, &(w, p, k))| CoupledSpring {
                row: point.row.clone(),
                constant: point.weight * k,
                force: point.weight * (k * w - p),
            })
            .collect();
        let unknowns = condensation::solve_uncondensed(&self.system, &springs)?;
        let retained: Vec<f64> = (self.system.bodies.iter().zip(&unknowns))
            .flat_map(|(body, u)| body.retained.iter().map(|&equation| u[equation]))
            .collect();
        Ok((points.iter().zip(states)).map(|(point, (w, p, k))| p + k * (point.approach(&retained) - w)).collect())
    }

    fn names(&self) -> String {
        let bodies = self.scene.bodies.iter().map(|body| format!("`{}`", body.name));
        bodies.collect::<Vec<_>>().join(" and ")
    }
}

/// κ of the springs that check the condensed solution against the full one: far stiffer than the bodies, and soft enough
/// that round-off in the approach stays below 1e-12 of the pressure.
const CHECKING_STIFFNESS: f64 = 1e3;

/// Fields recovered on the whole mesh.
#[derive(Clone, Debug)]
pub struct Fields {
    /// Displacement of every node \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// `[σ_x, σ_y, τ_xy]` at every node \[MPa\], tension positive.
    pub stress: Vec<[f64; 3]>,
    /// Unknowns of each body in its own frames and numbering \[mm\].
    pub unknowns: Vec<Vec<f64>>,
}

/// Seconds by stage.
#[derive(Debug)]
struct Clock {
    last: Instant,
    laps: Vec<(&'static str, f64)>,
}

impl Clock {
    fn start() -> Self {
        Self { last: Instant::now(), laps: Vec::new() }
    }

    fn lap(&mut self, stage: &'static str) {
        self.laps.push((stage, self.last.elapsed().as_secs_f64()));
        self.last = Instant::now();
    }
}
