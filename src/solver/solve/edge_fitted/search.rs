//! The ends of the contact sought on coarse fitted meshes, then on the one that is asked for.

use super::closed::{Closed, Moves, astray, places};
use super::fitted::{Fitted, REMEDY, on_fitted, refuse_given};
use crate::error::{Error, Kind};
use crate::measure::{Stretch, larger};
use crate::mesh::size::solvable;
use crate::mesh::{Order, Resolution};
use crate::scene::{ContactPair, Scene};
use crate::solution::Outcome;
use crate::solve::{Change, Discretisation, Formulation, Iteration, Permits, Run};

/// A mesh on which an end was sought.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Tried {
    /// Its order.
    pub order: Order,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Cells.
    pub cells: usize,
    /// Largest move of an end that it asked for, over the half-width; NaN for the first mesh, which knows of no end.
    pub moved: f64,
}

/// An answer on a fitted mesh.
#[derive(Debug)]
pub struct Answer {
    /// The mesh, assembled and condensed.
    pub discretisation: Discretisation,
    /// The solution with its contact conditions, and its measures.
    pub run: Run,
    /// Where every stretch begins and ends, contact by contact: on the last mesh, and moved as that asks.
    pub stretches: Vec<Vec<[f64; 2]>>,
    /// All meshes, in the order in which they were solved.
    pub tried: Vec<Tried>,
}

impl Answer {
    /// Whether every contact is closed between the ends that were found, and open beyond, but for so much of the
    /// half-width beside them.
    ///
    /// Where a first mesh takes two stretches for one, or one that begins away from a symmetry line for one that begins
    /// on it, the fitted mesh has no line where the contact ends.
    pub fn is_where_it_was_sought(&self, near: f64) -> bool {
        let contacts = self.discretisation.scene.contacts.iter().zip(&self.run.contacts).zip(&self.stretches);
        contacts.enumerate().all(|(contact, ((pair, found), stretches))| {
            let (lines, points) = (&pair.ends.places, self.run.solution.points_of(contact));
            // Every end that is read has its line.
            places(&found.measures.stretches).len() == lines.len()
                && astray(stretches, lines, points) <= near * found.measures.half_width()
        })
    }
}

/// Mesh that finds about where the contact is: 8-node cells, so many on the grading's unit of length.
const FIRST: Resolution = Resolution { elements: 3, refinement: 0, order: Order::Quadratic };
/// Times that this mesh is halved where the contact found on it is not that of the fitted mesh.
const HALVED: u32 = 5;
/// Order of the mesh on which its ends are sought first, with a layer more than the last one: an order costs more than
/// a layer, and tells less of an end.
const COARSE: Order = Order::Quartic;
/// Move of an end, over the half-width, from which on the last mesh is worth while.
const NEAR: f64 = 2e-3;
/// Part of a move of an end that is left after it, at most: the mesh itself tells whether it was less.
const LEFT: f64 = 0.25;
/// Farthest that the ends of two contacts of one body may be from one another and share a mesh line, over the
/// half-width: on the last of the meshes no farther than an end may be off.
const TOGETHER: f64 = 0.1;
/// Most meshes of each kind.
const MESHES: usize = 5;

/// What is sought on fitted meshes.
#[derive(Clone, Copy)]
pub struct Sought<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// How it is solved.
    pub formulation: &'a Formulation,
    /// Cells on each piece of the contact side, between its ends.
    pub elements: usize,
    /// Move of an end, over the half-width, that no longer matters.
    pub at_rest: f64,
    /// Whether the run that tells where the contacts are is one on such a mesh, so that no coarse ones are solved
    /// first.
    pub is_near: bool,
    /// Whether ends that would move there and back for ever are brought to rest between.
    pub is_damped: bool,
    /// Which meshes are solved.
    pub permits: Permits<'a>,
}

impl<'a> Sought<'a> {
    /// On one cell a piece, however many dofs that has.
    pub fn new(scene: &'a Scene, formulation: &'a Formulation, at_rest: f64) -> Self {
        Self { scene, formulation, elements: 1, at_rest, is_near: false, is_damped: false, permits: &|_| Ok(()) }
    }
}

impl Fitted {
    /// Solves a scene on such a mesh, whose ends are found on the way, as well as peak and second-moment width need it.
    pub fn solve(self, scene: &Scene, formulation: &Formulation) -> Result<Answer, Error> {
        self.solve_with_ends(scene, formulation, self.at_rest())
    }

    /// The same with ends that move no farther than so many half-widths.
    pub fn solve_with_ends(self, scene: &Scene, formulation: &Formulation, at_rest: f64) -> Result<Answer, Error> {
        let sought = Sought::new(scene, formulation, at_rest);
        self.found(&sought).or_else(|refused| self.found(&Sought { is_damped: true, ..sought }).map_err(|_| refused))
    }

    /// The same from nothing but the scene.
    pub fn found(self, sought: &Sought) -> Result<Answer, Error> {
        let Sought { scene, formulation, at_rest, permits, .. } = *sought;
        refuse_given(scene)?;
        // Other iterations leave points open, and pressed, that the contact conditions do not.
        let is_exact = formulation.algorithm == Iteration::Kinematic;
        let near = if is_exact { larger(at_rest, NEAR) } else { f64::INFINITY };
        let mut tried = Vec::new();
        let mut refused = None;
        for halved in 0..=HALVED {
            let resolution = Resolution { elements: FIRST.elements << halved, ..FIRST };
            if refused.is_some() && solvable(scene, resolution).is_err() {
                break;
            }
            let made = Discretisation::permitted(scene.clone(), resolution, permits).map_err(on_fitted)?;
            let first = Run::of(&made, &formulation.by_kinematic_load())?;
            tried.push(Tried { order: FIRST.order, dofs: first.dofs, cells: made.mesh.cells(), moved: f64::NAN });
            // Surfaces may meet between two points alone.
            if halved < HALVED && first.is_open() && first.solution.meets_between_points() {
                continue;
            }
            found(&first).refuse(scene)?;
            match self.around(&first, sought) {
                Ok(mut answer) => {
                    tried.append(&mut answer.tried);
                    // An iteration that did not converge says nothing of the mesh.
                    let has_converged = answer.run.solution.outcome == Outcome::Converged;
                    if !has_converged || answer.is_where_it_was_sought(near) {
                        return Ok(Answer { tried, ..answer });
                    }
                    let message = "the contact is not closed where its ends were found: the mesh that it was sought on \
                        is too coarse";
                    refused = Some(Error::at(scene.name.as_str(), message, REMEDY));
                }
                Err(error @ Error { kind: Kind::TooManyDofs { .. }, .. }) => return Err(error),
                Err(error) => refused = Some(error),
            }
        }
        Err(refused.unwrap_or_else(|| Error::at(scene.name.as_str(), "no mesh was solved", REMEDY)))
    }

    /// The same where a run on another mesh tells about where the contacts are.
    pub fn around(self, first: &Run, sought: &Sought) -> Result<Answer, Error> {
        let Sought { scene, formulation, elements, at_rest, is_near, is_damped, permits } = *sought;
        let mut ends = found(first);
        let mut tried = Vec::new();
        ends.refuse(scene)?;
        let coarse = Fitted::of(COARSE, self.layers + 1);
        let meshes = [(coarse, 1, NEAR.max(at_rest)), (self, elements, at_rest)];
        for &(mesh, elements, enough) in &meshes[usize::from(is_near)..] {
            let last = mesh == self;
            let mut before: Option<[Moves; 2]> = None;
            for left in (0..MESHES).rev() {
                ends.join(scene, (enough * 2f64.powi(left as i32)).min(TOGETHER));
                let mut discretisation = ends.discretised(scene, mesh, elements, permits)?;
                let moves = ends.moves(&discretisation)?;
                let moved = moves.iter().flatten().flatten().fold(0.0_f64, |most, [by, _]| most.max(by.abs()));
                let (dofs, cells) = (discretisation.system.dofs(), discretisation.mesh.cells());
                tried.push(Tried { order: mesh.order, dofs, cells, moved });
                // What is left matters as its square does: on the last mesh a tenth of the misfit is let pass.
                let is_let_pass = is_damped && left == 0 && 20.0 * moved * moved <= Self::misfit(self.order);
                let resting = moved <= enough || is_let_pass;
                if last && resting {
                    discretisation.scene.contacts.iter_mut().for_each(|pair| pair.ends.off = moved);
                    let run = Run::from(Some(&first.solution), &discretisation, formulation, Change::NONE)?;
                    ends.moved(scene, &moves);
                    let stretches = ends.stretches.iter();
                    let stretches = stretches.map(|all| all.iter().map(|one| [one.begin, one.end]).collect()).collect();
                    return Ok(Answer { discretisation, run, stretches, tried });
                }
                let steps = damped(&moves, before.as_ref().filter(|_| is_damped));
                ends.moved(scene, &steps);
                before = Some([moves, steps]);
                if !last && LEFT * moved <= enough {
                    break;
                }
            }
        }
        let moved = tried.last().map_or(f64::NAN, |last| last.moved);
        Err(Error::at(
            scene.name.as_str(),
            format!("the ends of the contact still move by {moved:.1e} half-widths after {MESHES} meshes"),
            REMEDY,
        ))
    }
}

/// What the ends shall move, where the mesh asks for such moves and did for others before, upon which they made such
/// steps: to the zero of the line through both where they would go back, for some would do so for ever.
fn damped(moves: &Moves, before: Option<&[Moves; 2]>) -> Moves {
    let mut steps = moves.clone();
    let Some([asked, made]) = before else { return steps };
    let flat = |all: &Moves| all.iter().flatten().flatten().map(|[by, _]| *by).collect::<Vec<f64>>();
    let old = flat(asked).into_iter().zip(flat(made));
    for ([by, _], (asked, made)) in steps.iter_mut().flatten().flatten().zip(old) {
        if *by * asked < 0.0 {
            *by *= made / (asked - *by);
        }
    }
    steps
}

/// Lays the mesh lines of a scene on the ends that a run found; those of two contacts of a body on one line where they
/// lie within so many half-widths. A contact that has other ends than lines keeps these.
pub(crate) fn lay_on_ends(scene: &mut Scene, run: &Run, near: f64) {
    let mut ends = found(run);
    ends.join(scene, near);
    for (pair, stretches) in scene.contacts.iter_mut().zip(&ends.stretches) {
        let places = places(stretches);
        if places.len() == pair.ends.places.len() {
            pair.ends.places = places;
        }
    }
}

/// How far the mesh lines of a contact lie from the ends that a run on that mesh found, over the half-width.
pub(crate) fn off(pair: &ContactPair, stretches: &[Stretch]) -> f64 {
    let away = |end: f64| pair.ends.places.iter().map(|place| (place - end).abs()).fold(f64::INFINITY, f64::min);
    let of = |one: &Stretch| {
        let ends = places(std::slice::from_ref(one));
        ends.into_iter().map(away).fold(0.0, larger) / one.half_width()
    };
    stretches.iter().map(of).fold(0.0, larger)
}

/// The closed stretches that a run found.
fn found(run: &Run) -> Closed {
    Closed { stretches: run.contacts.iter().map(|contact| contact.measures.stretches.clone()).collect() }
}
