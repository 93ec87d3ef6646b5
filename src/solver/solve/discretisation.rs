//! A scene meshed, assembled and condensed: what all nine formulations share, and on which they solve; under another
//! load or clearance pressures only, at the price of a few dense steps.

use crate::algorithm::{ContactProblem, Scale};
use crate::clock::{Clock, Seconds, Stage};
use crate::condensation::Condensed;
use crate::contact::{ContactEdge, ContactPoint, Interface};
use crate::elasticity::dilatation::Split;
use crate::elasticity::{ElasticSystem, numbered};
use crate::error::Error;
use crate::mesh::{Mesh, Resolution};
use crate::scene::{ContactPair, Scene};
use crate::solve::Formulation;

/// What refuses a mesh of so many dofs before anything of it is assembled.
pub type Permits<'a> = &'a (dyn Fn(usize) -> Result<(), Error> + Sync);

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
    /// What its stages took.
    pub seconds: Seconds,
}

impl Discretisation {
    /// Mesh, assembly, condensation and interfaces of a scene.
    pub fn of(scene: Scene, resolution: Resolution) -> Result<Self, Error> {
        Self::timed(scene, resolution, Clock::silent())
    }

    /// The same, timed by a clock, which may tell of every stage as it begins.
    pub fn timed(scene: Scene, resolution: Resolution, clock: Clock) -> Result<Self, Error> {
        Self::made(scene, resolution, &|_| Ok(()), clock)
    }

    /// The same where its dofs are permitted.
    pub fn permitted(scene: Scene, resolution: Resolution, permits: Permits) -> Result<Self, Error> {
        Self::made(scene, resolution, permits, Clock::silent())
    }

    fn made(scene: Scene, resolution: Resolution, permits: Permits, mut clock: Clock) -> Result<Self, Error> {
        let mesh = clock.time(Stage::Mesh, || Mesh::of(&scene, resolution))?;
        let numbered = clock.time(Stage::Ordering, || numbered(&scene, &mesh))?;
        permits(numbered.iter().map(|(_, dofs)| dofs.equations).sum())?;
        let assembled = || ElasticSystem::assemble_numbered(&scene, &mesh, numbered, &|_| 1.0);
        let system = clock.time(Stage::Assembly, assembled)?;
        Self::condensed(scene, resolution, mesh, system, clock)
    }

    /// The same from a mesh and a system at hand, for instance perturbed or renumbered ones.
    pub fn of_system(scene: Scene, resolution: Resolution, mesh: Mesh, system: ElasticSystem) -> Result<Self, Error> {
        Self::condensed(scene, resolution, mesh, system, Clock::silent())
    }

    fn condensed(
        scene: Scene,
        resolution: Resolution,
        mesh: Mesh,
        system: ElasticSystem,
        mut clock: Clock,
    ) -> Result<Self, Error> {
        let coupled = |(contact, pair): (usize, &ContactPair)| {
            let side = |body: usize| (body, mesh.bodies[body].candidates_of(contact));
            Some([side(pair.first), side(pair.second?)])
        };
        let coupled: Vec<_> = scene.contacts.iter().enumerate().filter_map(coupled).collect();
        let condensed = system.condense_timed(Some(&coupled), &mut clock)?;
        let interfaces = clock.time(Stage::Interface, || Interface::all(&scene, &mesh, &condensed))?;
        let edges = interfaces.iter().flat_map(Interface::contact_edges).collect();
        Ok(Self { scene, resolution, mesh, system, condensed, interfaces, edges, seconds: clock.seconds })
    }

    /// Whether cells of a body smooth its dilatation, since it is nearly incompressible.
    pub fn is_smoothed(&self, body: usize) -> bool {
        Split::of(&self.scene.bodies[body].material, self.scene.plane).excess > 0.0
    }

    /// Contact points of a formulation.
    pub fn points(&self, formulation: &Formulation) -> Vec<ContactPoint> {
        formulation.points(&self.interfaces)
    }

    /// Contact points and condensed load after a change.
    pub(super) fn changed(&self, formulation: &Formulation, change: Change) -> (Vec<ContactPoint>, Vec<f64>) {
        let mut points = self.points(formulation);
        points.iter_mut().for_each(|point| point.gap += change.clearance);
        (points, self.condensed.load.iter().map(|f| f * change.load).collect())
    }

    /// What the algorithms see of this scene under a formulation.
    pub fn problem<'a>(&'a self, formulation: &Formulation, points: &'a [ContactPoint]) -> ContactProblem<'a> {
        self.problem_under(formulation, points, &self.condensed.load)
    }

    /// The same under another condensed load.
    pub(super) fn problem_under<'a>(
        &'a self,
        formulation: &Formulation,
        points: &'a [ContactPoint],
        load: &'a [f64],
    ) -> ContactProblem<'a> {
        let reference = &self.scene.reference;
        let unit = self.scene.contact_modulus() / reference.length;
        let pattern = |i: usize| match formulation.stiffness_pattern.len() {
            0 => 1.0,
            n => formulation.stiffness_pattern[i % n],
        };
        let scale = Scale { gap: reference.gap, stiffness: unit };
        // Around the axis a flat punch as wide as the candidates, `δ = F/(2E*a)`.
        let across = |(contact, pair): (usize, &ContactPair)| match self.scene.is_around_axis(contact) {
            true => 2.0 * pair.stretch,
            false => self.scene.depth(pair.path.point(0.0)),
        };
        let contacts = self.scene.contacts.iter().enumerate();
        let compliance = contacts.map(|one| 1.0 / (self.scene.modulus_of(one.1) * across(one)));
        let mut problem = ContactProblem {
            stiffness: &self.condensed.stiffness,
            load,
            points,
            edges: &self.edges,
            scale,
            compliance: compliance.collect(),
            initial: Vec::new(),
        };
        let initial = |(i, unit): (usize, f64)| {
            scale.clip(formulation.stiffness * unit * pattern(i) * points[i].relative_stiffness)
        };
        problem.initial = formulation.stiffness_unit.of(&problem).into_iter().enumerate().map(initial).collect();
        problem
    }
}

/// What has changed since the condensation; the bodies, their supports and the places of their loads have not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// All loads and prescribed displacements times this.
    pub load: f64,
    /// Added to the gap everywhere \[mm\].
    pub clearance: f64,
}

impl Change {
    /// Nothing has changed.
    pub const NONE: Self = Self { load: 1.0, clearance: 0.0 };

    /// Refuses numbers that are none.
    pub(super) fn validate(self, scene: &str) -> Result<(), Error> {
        for (key, value) in [("load factor", self.load), ("clearance", self.clearance)] {
            if !value.is_finite() {
                return Err(Error::value(scene, key, value, "a finite number is needed", "give a number"));
            }
        }
        Ok(())
    }
}
