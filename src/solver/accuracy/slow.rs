//! Algorithms other than kinematic load: the mesh is chosen by kinematic load on the same contact element, whose
//! discrete solution they share, and the mesh answered is run by the one asked for.
//!
//! An iteration to a hundredth of the accuracy on every mesh is what constant and varying stiffness do not reach in
//! their iterations; one to what the mesh leaves of the accuracy they often do. The error of that iteration is known
//! (`src/solver/algorithm/target.rs`) and is part of the estimate.

use crate::accuracy::answer::{largest, quoted};
use crate::accuracy::bar::of_pressures;
use crate::accuracy::family::Family;
use crate::accuracy::watch::up_to;
use crate::accuracy::{Answer, Asked, Barred, Tell, Tried, search};
use crate::error::Error;
use crate::scene::Scene;
use crate::solution::Outcome;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};

/// Part of the accuracy that the mesh may take; the rest is the iteration's.
const MESH: f64 = 0.8;
/// Part of what the mesh leaves that the iteration is asked for.
const ITERATION: f64 = 0.9;
/// Part of the accuracy that it is asked for where the mesh leaves nothing; the tolerance of the formulation is not
/// looked at.
const LEAST: f64 = 0.1;
/// Parts of it that are asked for where the iteration converged and the answer is not within the accuracy: an end of
/// the contact moves by whole points, and a loose iteration may leave some pressed.
const CLOSER: [f64; 2] = [0.1, 0.01];

/// The mesh by kinematic load, its run by the formulation asked.
pub(super) fn solve(scene: &Scene, formulation: &Formulation, asked: &Asked, tell: Tell) -> Result<Answer, Error> {
    let choosing = formulation.by_kinematic_load();
    let of_mesh = Asked { relative: MESH * asked.relative, ..asked.clone() };
    let mut answer = search::solve(scene, &choosing, &of_mesh, tell)?;
    let mut formulation = formulation.clone();
    let room = ITERATION * (asked.relative - answer.estimate());
    let room = if room > 0.0 { room } else { LEAST * asked.relative };
    let held = answer.discretisation.take();
    let discretisation = held.map_or_else(|| Discretisation::of(answer.scene.clone(), answer.resolution), Ok)?;
    let mut by = |part: f64| -> Result<(Run, Vec<Barred>), Error> {
        formulation.settings.tolerance = part * room;
        let mut run = Run::of(&discretisation, &formulation)?;
        let limits = answer.run.contacts.iter().map(|contact| contact.unbounded);
        run.contacts.iter_mut().zip(limits).for_each(|(contact, unbounded)| contact.unbounded = unbounded);
        // Of no other mesh: what the mesh leaves is that of the discrete solution, whatever iterates, and the search
        // has told it.
        let alone = Family::permitted(&discretisation, &run.formulation, None, None, &up_to(Some(0)));
        let mut estimates = quoted(&of_pressures(&discretisation, &run, &alone), &run, asked);
        estimates.iter_mut().for_each(|one| one.take_mesh_of(&answer.estimates));
        Ok((run, estimates))
    };
    let (mut run, mut estimates) = by(1.0)?;
    for part in CLOSER {
        let is_met = largest(&estimates) <= asked.relative;
        if is_met || run.solution.outcome != Outcome::Converged {
            break;
        }
        let next = by(part)?;
        if largest(&next.1).total_cmp(&largest(&estimates)).is_lt() {
            (run, estimates) = next;
        }
    }
    answer.estimates = estimates;
    let same = answer.tried.iter().find(|tried| tried.dofs == run.dofs).cloned();
    let (iterations, contacts) = (run.solution.work.iterations, Tried::contacts(&answer.scene, &run));
    let last = same.map(|same| Tried { purpose: "answer", iterations, contacts, estimate: answer.estimate(), ..same });
    answer.tried.extend(last);
    if answer.estimate() <= asked.relative {
        answer.unmet = None;
    } else if answer.unmet.is_none() {
        let (name, outcome, error) = (formulation.name(), &run.solution.outcome, 100.0 * run.iteration_error());
        answer.unmet = Some(format!(
            "the iteration {name} ended so: {outcome}, with an error of {error:.2e} % on the mesh that kinematic load \
            chose"
        ));
    }
    (answer.run, answer.discretisation) = (run, Some(discretisation));
    Ok(answer)
}
