//! Where one contact begins and ends, found on cheap meshes from a guess of the candidate stretch.

use crate::accuracy::Tried;
use crate::accuracy::fitted::{self, Fitted, ORDER, Plan};
use crate::accuracy::longest::longest;
use crate::accuracy::rungs::{Rung, Rungs};
use crate::error::{Error, Kind, Part};
use crate::mesh::Resolution;
use crate::scene::Scene;

/// Elements of the first mesh, over the candidate stretch that the scene guesses.
const FIRST: usize = 8;
/// Pressed elements on a side from which on a first mesh tells where the contact ends.
const TOLD: usize = 3;
/// Most elements of a first mesh on a side.
const FINEST: usize = 128;
/// Guesses of the stretch: each is twice as long, or as short as what was pressed.
const GUESSES: usize = 16;
/// Gentlest growth of a first mesh, where a steeper one degenerates.
const GENTLEST: f64 = 8.0;
/// Imbalance of a body up to which a first mesh tells where the contact ends: round-off of long, thin cells takes none
/// of later ones.
const UNBALANCED: f64 = 1e-2;
/// What such meshes are solved for.
const PURPOSE: &str = "contact length";

/// The scene on the first mesh of the search.
pub(super) fn first(scene: &Scene) -> (Scene, Resolution) {
    Plan::even(ORDER, FIRST, scene.contact().stretch, 0.0).laid(scene)
}

/// Meshes fitted to the contact found; where it is not found, the last mesh with the reason.
pub(super) fn found(scene: &Scene, rungs: &mut Rungs) -> Result<Result<Fitted, (Rung, String)>, Error> {
    let longest = longest(scene, scene.contact());
    let mut stretch = scene.contact().stretch.min(longest);
    let (mut elements, mut level) = (FIRST, 0.0);
    let mut last = None;
    for _ in 0..GUESSES {
        let plan = Plan::even(ORDER, elements, stretch, level);
        let solved = rungs.solve(plan.laid(scene), PURPOSE);
        let solved = match solved {
            Err(Error { kind: Kind::DegenerateCell, .. }) if level < GENTLEST => {
                level += 2.0;
                continue;
            }
            Err(error) if stretch < longest && is_short(scene, &error) => {
                // A stretch beyond which contact went on.
                let Plan { order, elements, stretch: beyond, .. } = plan;
                let growth = plan.growth()[0];
                rungs.tried.push(Tried { elements, growth, ..Tried::unsolved(PURPOSE, order, beyond) });
                stretch = (2.0 * stretch).min(longest);
                continue;
            }
            // A contact shorter than two elements.
            Err(Error { kind: Kind::NoSpringLeft { .. }, .. }) if elements < FINEST && turns(scene) => {
                elements *= 2;
                continue;
            }
            Err(error) => match last {
                Some(rung) if rungs.is_refused(&error) => return Ok(Err((rung, error.message))),
                _ => return Err(error),
            },
            Ok(solved) => solved,
        };
        let (discretisation, rung) = solved;
        match guess(&plan, &rung, longest) {
            Ok(None) => {
                let ends = fitted::ends(&rung.run, 0);
                rungs.first = Some((discretisation, rung));
                return Ok(Ok(Fitted { scene: scene.clone(), longest, ends }));
            }
            Err(reason) => return Ok(Err((rung, reason))),
            Ok(Some(next)) => (elements, stretch) = next,
        }
        last = Some(rung);
    }
    match last {
        Some(rung) => Ok(Err((rung, format!("no contact length was found in {GUESSES} guesses")))),
        None => Err(Error::value(
            scene.place_of(0, Part::Stretch),
            "candidate stretch",
            scene.contact().path.reported(scene.contact().stretch),
            format!("no contact length was found in {GUESSES} guesses"),
            "give a stretch a little longer than the contact",
        )),
    }
}

/// Whether longer candidates may be solved: contact reaches their end, or all of it lies there and across x = 0
/// nothing holds a body against turning.
fn is_short(scene: &Scene, error: &Error) -> bool {
    match error.kind {
        Kind::ContactBeyondCandidates { .. } => true,
        Kind::NoSpringLeft { .. } => turns(scene),
        _ => false,
    }
}

/// Whether nothing but contact fixes a body against turning, as across x = 0.
fn turns(scene: &Scene) -> bool {
    scene.contact().path.has_both_sides()
}

/// Elements and stretch of the next mesh; none where the contact is known well enough, an error where no mesh is next.
fn guess(plan: &Plan, rung: &Rung, longest: f64) -> Result<Option<(usize, f64)>, String> {
    let Plan { elements, stretch, .. } = *plan;
    let (solution, pair) = (&rung.run.solution, rung.scene.contact());
    let [pressed, outermost] = fitted::pressed(&rung.run, 0);
    let filled = fitted::is_filled(&rung.run, 0);
    let across = pair.path.has_both_sides();
    let told = pressed >= if across { 2 * TOLD } else { TOLD };
    // Across x = 0 one or two points hold no body against turning.
    let is_found = rung.run.is_found(UNBALANCED);
    if !is_found && (told || !across) {
        return Err(format!("the first iteration ended so: {}", solution.outcome));
    }
    if pressed == 0 {
        // Surfaces may meet between two points alone.
        return if elements < FINEST && solution.meets_between_points() {
            Ok(Some((2 * elements, stretch)))
        } else {
            Err("no candidate is pressed".into())
        };
    }
    if filled && stretch < longest * (1.0 - 1e-9) {
        return Ok(Some((elements, (2.0 * stretch).min(longest))));
    }
    if is_found && (told || filled) {
        return Ok(None);
    }
    match outermost + 1 {
        enough if enough < elements => Ok(Some((elements, stretch * enough as f64 / elements as f64))),
        // A shorter stretch would end within the contact.
        _ if elements < FINEST => Ok(Some((2 * elements, stretch))),
        _ => Err(format!(
            "the contact takes {pressed} of {} candidate elements, far from x = 0: put x = 0 nearer to it",
            2 * elements
        )),
    }
}
