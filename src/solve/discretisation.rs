//! A scene meshed, assembled and condensed: what all nine formulations share.

use std::sync::OnceLock;

use crate::algorithm::{ContactProblem, Scale};
use crate::clock::Clock;
use crate::condensation::{self, Condensed, CoupledSpring};
use crate::contact::{ContactEdge, ContactPoint, Interface};
use crate::elasticity::{ElasticSystem, Numbering};
use crate::error::Error;
use crate::mesh::{Mesh, Resolution};
use crate::scene::Scene;
use crate::solution::{Solution, Work};
use crate::solve::{Change, Formulation, spill};

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
    /// Candidate stretch of every contact.
    pub interfaces: Vec<Interface>,
    /// Edges of these stretches.
    pub edges: Vec<ContactEdge>,
    /// Seconds by stage.
    pub seconds: Vec<(&'static str, f64)>,
    /// The same scene half as fine, built when a nested start first asks for it.
    pub(super) coarser: OnceLock<Box<Discretisation>>,
}

/// Stages of a discretisation, in their order.
pub const STAGES: [&str; 3] = ["mesh", "assembly", "condensation"];

impl Discretisation {
    /// Mesh, assembly, condensation and interface of a scene.
    pub fn of(scene: Scene, resolution: Resolution) -> Result<Self, Error> {
        Self::announced(scene, resolution, &|_| ())
    }

    /// The same, each of its [`STAGES`] announced as it begins.
    pub fn announced(scene: Scene, resolution: Resolution, begins: &dyn Fn(&'static str)) -> Result<Self, Error> {
        let [meshing, assembling, condensing] = STAGES;
        let mut clock = Clock::start();
        begins(meshing);
        let mesh = Mesh::of(&scene, resolution)?;
        clock.lap("mesh");
        begins(assembling);
        let numbering = Numbering::of(&scene, &mesh)?;
        clock.lap("ordering");
        let system = ElasticSystem::assemble_numbered(&scene, &mesh, numbering, &|_| 1.0)?;
        clock.lap("assembly");
        begins(condensing);
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
        clock.take(&condensed.seconds);
        let interfaces = Interface::all(&scene, &mesh, &condensed)?;
        clock.lap("interface");
        Ok(Self {
            scene,
            resolution,
            mesh,
            system,
            condensed,
            edges: interfaces.iter().flat_map(Interface::contact_edges).collect(),
            interfaces,
            seconds: clock.laps,
            coarser: OnceLock::new(),
        })
    }

    /// Solves the contact problem by one formulation.
    pub fn solve(&self, formulation: &Formulation) -> Result<Solution, Error> {
        formulation.validate(&self.scene)?;
        formulation.refuse_interference(&self.scene, self.tightest_gap())?;
        self.refuse_unloaded(formulation)?;
        let (solution, _, _) = self.solve_from_start(formulation).map_err(|error| self.named(error))?;
        if solution.converged() {
            spill::refuse(self, &solution, Change::NONE, formulation.settings.tolerance)?;
        }
        Ok(solution)
    }

    /// Smallest initial gap of a candidate node \[mm\].
    pub(super) fn tightest_gap(&self) -> f64 {
        let stations = self.interfaces.iter().flat_map(|interface| &interface.stations);
        stations.map(|station| station.gap).fold(f64::INFINITY, f64::min)
    }

    /// Refuses bodies that contact alone would hold, and nothing presses.
    fn refuse_unloaded(&self, formulation: &Formulation) -> Result<(), Error> {
        let points = formulation.points(&self.interfaces);
        self.refuse_nothing(&self.problem(formulation, &points))
    }

    /// Refuses a problem in which nothing presses and springs alone would hold the bodies.
    pub(super) fn refuse_nothing(&self, problem: &ContactProblem) -> Result<(), Error> {
        let held = || problem.factorise(&vec![0.0; problem.points.len()], &mut Work::default()).is_some();
        if self.is_unloaded(problem.load) && !held() && !problem.interference_presses() {
            return Err(Error::NothingPresses { bodies: self.names() });
        }
        Ok(())
    }

    /// Whether a condensed load is no more than round-off of the loads on the bodies.
    fn is_unloaded(&self, condensed: &[f64]) -> bool {
        let sum = |forces: &[f64]| forces.iter().map(|f| f.abs()).sum::<f64>();
        sum(condensed) <= UNLOADED * self.system.bodies.iter().map(|body| sum(&body.force)).sum::<f64>()
    }

    /// What the algorithms see of this scene under a formulation.
    pub fn problem<'a>(&'a self, formulation: &Formulation, points: &'a [ContactPoint]) -> ContactProblem<'a> {
        let reference = &self.scene.reference;
        let unit = self.scene.contact_modulus() / reference.length;
        let pattern = |i: usize| match formulation.stiffness_pattern.len() {
            0 => 1.0,
            n => formulation.stiffness_pattern[i % n],
        };
        let scale = Scale { gap: reference.gap, stiffness: unit };
        let compliance =
            self.scene.contacts.iter().map(|pair| 1.0 / (self.scene.modulus_of(pair) * self.scene.thickness));
        let nominal = formulation.stiffness * unit;
        let initial = |(i, point): (usize, &ContactPoint)| scale.clip(nominal * pattern(i) * point.relative_stiffness);
        ContactProblem {
            stiffness: &self.condensed.stiffness,
            load: &self.condensed.load,
            points,
            edges: &self.edges,
            scale,
            compliance: compliance.collect(),
            initial: points.iter().enumerate().map(initial).collect(),
        }
    }

    /// Contact points of a formulation.
    pub fn points(&self, formulation: &Formulation) -> Vec<ContactPoint> {
        formulation.points(&self.interfaces)
    }

    /// The spring pressures of a solution once more, from the full system without condensation \[MPa\].
    ///
    /// Every loaded point is replaced by a spring around the condensed solution, `p = p_s + k (w − w_s)`; the sparse
    /// system of all bodies then gives `w`, and with it `p`, without S having been used.
    pub fn uncondensed_pressures(&self, formulation: &Formulation, solution: &Solution) -> Result<Vec<f64>, Error> {
        let points = formulation.points(&self.interfaces);
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
            .flat_map(|(body, u)| u[body.retained.clone()].iter().copied())
            .collect();
        Ok((points.iter().zip(states)).map(|(point, (w, p, k))| p + k * (point.approach(&retained) - w)).collect())
    }

    /// An error of the iteration, which sees matrices only, with the names of the bodies.
    pub(super) fn named(&self, error: Error) -> Error {
        match error {
            Error::NoSpringLeft { steps, .. } => Error::NoSpringLeft { bodies: self.names(), steps },
            Error::SpringsTooSoft { times, .. } => Error::SpringsTooSoft { bodies: self.names(), times },
            other => other,
        }
    }

    /// Names of the bodies, as messages give them.
    pub(super) fn names(&self) -> String {
        let bodies = self.scene.bodies.iter().map(|body| format!("`{}`", body.name));
        bodies.collect::<Vec<_>>().join(" and ")
    }
}

/// A condensed load below this fraction of the loads on the bodies is round-off of the condensation.
const UNLOADED: f64 = 1e-13;

/// κ of the springs that check the condensed solution against the full one: far stiffer than the bodies, and soft enough
/// that round-off in the approach stays below 1e-12 of the pressure.
const CHECKING_STIFFNESS: f64 = 1e3;
