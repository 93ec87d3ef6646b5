//! Which meshes of a search are solved, and what is told of each before it is.

use crate::error::{Error, Kind};
use crate::mesh::Resolution;
use crate::scene::Scene;
use crate::solve::Discretisation;
use crate::solve::run::Run;

/// Dofs above which a mesh is announced, and seconds that it is expected to take.
const LONG: (usize, f64) = (200_000, 10.0);

/// A mesh that is about to be solved.
#[derive(Clone, Copy, Debug)]
pub struct Next {
    /// Its degrees of freedom.
    pub dofs: usize,
    /// What it is expected to take \[s\], by the seconds per dof of the meshes before; NaN for the first one.
    pub seconds: f64,
    /// Largest relative bar of the mesh before; NaN where none is known.
    pub estimate: f64,
    /// The relative error that is asked for.
    pub asked: f64,
}

impl Next {
    /// Whether it takes so long that one should know before.
    pub fn is_long(&self) -> bool {
        let (dofs, seconds) = LONG;
        self.dofs > dofs || self.seconds > seconds
    }
}

/// Who is told of each mesh before it is solved.
pub type Tell<'a> = &'a (dyn Fn(&Next) + Sync);

/// What a search may solve.
pub(super) struct Watch<'a> {
    most_dofs: Option<usize>,
    tell: Tell<'a>,
    next: Next,
    /// Dofs of the largest mesh so far, and what it took \[s\].
    largest: (usize, f64),
}

impl<'a> Watch<'a> {
    /// Of a search for a relative error, on meshes of so many dofs at most.
    pub(super) fn new(asked: f64, most_dofs: Option<usize>, tell: Tell<'a>) -> Self {
        let next = Next { dofs: 0, seconds: f64::NAN, estimate: f64::NAN, asked };
        Self { most_dofs, tell, next, largest: (0, f64::NAN) }
    }

    /// Refuses a mesh of too many dofs, and tells of any other.
    pub(super) fn permits(&self, dofs: usize) -> Result<(), Error> {
        within(dofs, self.most_dofs)?;
        let (known, seconds) = self.largest;
        (self.tell)(&Next { dofs, seconds: seconds * dofs as f64 / known as f64, ..self.next });
        Ok(())
    }

    /// A mesh that is permitted.
    pub(super) fn discretised(&self, scene: Scene, resolution: Resolution) -> Result<Discretisation, Error> {
        Discretisation::permitted(scene, resolution, &|dofs| self.permits(dofs))
    }

    /// Takes what a mesh has cost.
    pub(super) fn took(&mut self, run: &Run) {
        if run.dofs > self.largest.0 {
            self.largest = (run.dofs, run.seconds.iter().map(|(_, seconds)| seconds).sum());
        }
    }

    /// Takes what the bars of a mesh say.
    pub(super) fn estimated(&mut self, estimate: f64) {
        self.next.estimate = estimate;
    }
}

/// Refuses a mesh of more dofs than are allowed.
fn within(dofs: usize, most: Option<usize>) -> Result<(), Error> {
    match most {
        Some(most) if dofs > most => {
            let message = format!("the next mesh would have {dofs} dofs, more than the {most} allowed");
            let error = Error::at("accuracy", message, "allow more dofs, or accept a larger error");
            Err(Error { kind: Kind::TooManyDofs { dofs }, ..error })
        }
        _ => Ok(()),
    }
}

/// What permits meshes of so many dofs at most.
pub(super) fn up_to(most: Option<usize>) -> impl Fn(usize) -> Result<(), Error> + Sync {
    move |dofs| within(dofs, most)
}
