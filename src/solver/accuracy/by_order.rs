//! Cells of higher and higher order, fitted to the contacts of a scene, until the error bars of a mesh are within what
//! is asked.
//!
//! They know where the contact ends, and where the curvature of its gap leaps, by mesh lines; 8-node cells know it by
//! pressures alone, so that these take three times as many dofs to tell the half-width. Each mesh is judged by the next
//! one, which is then the one that is judged. Once one is good enough, those before it are judged by it, and the
//! cheapest that is good enough is answered.

use crate::accuracy::coarser::finer;
use crate::accuracy::longest::longest;
use crate::accuracy::rungs::{Held, Rung, Rungs};
use crate::accuracy::{Asked, Quantity};
use crate::error::{Error, Kind};
use crate::measure::Stretch;
use crate::mesh::{Order, Resolution};
use crate::scene::{ContactPair, Scene};
use crate::solve::edge_fitted::{self, Sought};
use crate::solve::{Discretisation, Element, Fitted, Formulation, Run};

/// What such meshes are solved for.
const PURPOSE: &str = "order";

/// Meshes that are as good as is asked: the smallest relative error asked for with which one is the first, order and
/// layers. Every layer leaves an eighth to a fifteenth of the error of an end, every order a third of that of the peak.
const FIRST: [(f64, Fitted); 5] = [
    (5e-3, Fitted::of(Order::Quartic, 1)),
    (5e-4, Fitted::of(Order::Quintic, 1)),
    (5e-5, Fitted::of(Order::Quintic, 2)),
    (5e-6, Fitted::of(Order::Septic, 2)),
    (0.0, Fitted::of(Order::Octic, 3)),
];

/// Move of an end over the half-width, over what is asked, that no longer matters: a thirtieth to a quarter of it is
/// left in the end.
const REST: f64 = 2.0;
/// Move at rest from which on the ends are sought on the mesh itself, without a coarse one.
const AT_ONCE: f64 = 0.024;
/// Bar over that of the mesh before, from which on the bars fall too slowly; and how many in a row may: the first is
/// followed by a higher order, others by smaller cells, and where those gain nothing either, 8-node cells do hardly
/// more.
const SLOW: f64 = 0.5;
const PATIENCE: usize = 2;
/// Bar over what is asked up to which a finer mesh may show a mesh to be good enough: bars are up to ten times the
/// distance to the next one.
const HOPEFUL: f64 = 20.0;
/// Dofs of a mesh of high order from which on no smaller cells follow it: these have up to four times as many, a matrix
/// of gigabytes.
const LARGE: usize = 60_000;

/// Whether such meshes are tried.
pub(super) fn applies(scene: &Scene, formulation: &Formulation, asked: &Asked) -> bool {
    let known = |quantity: &Quantity| {
        matches!(quantity, Quantity::PeakPressure | Quantity::HalfWidth | Quantity::SecondMomentWidth)
    };
    let is_meshed = scene.bodies.iter().all(|body| !body.shape.has_given_mesh());
    asked.high_order && is_meshed && formulation.element == Element::Node && asked.quantities.iter().all(known)
}

/// The cheapest of such meshes that is good enough, as the first whose bars, by the next one, are within what is asked
/// shows, held with what judges it; or else the best of them.
pub(super) fn found(scene: &Scene, rungs: &mut Rungs) -> Result<Option<(Rung, Option<Held>)>, Error> {
    let asked = rungs.asked.relative;
    // Those before it, and the meshes of those that may do.
    let mut cheaper: Vec<(Option<Discretisation>, Rung)> = Vec::new();
    let mut mesh = first(scene, rungs);
    let (mut stalled, mut before) = (0, f64::INFINITY);
    while let Some((discretisation, mut rung)) = mesh {
        let next = next(&discretisation, &rung, stalled > 0, rungs);
        rungs.judge((&discretisation, &mut rung), next.as_ref())?;
        let estimate = rung.error;
        if estimate <= asked {
            for (own, mut other) in cheaper {
                if let Some(own) = own.filter(|_| rungs.is_enough(&mut other, &rung)) {
                    return Ok(Some((other, Some((own, Some((discretisation, rung.run)))))));
                }
            }
            return Ok(Some((rung, Some((discretisation, next.map(|(finer, judge)| (finer, judge.run)))))));
        }
        cheaper.push((Some(discretisation).filter(|_| estimate <= HOPEFUL * asked), rung));
        // What is not smooth within a cell gains nothing by its order, and may by smaller cells.
        stalled = if estimate <= SLOW * before { 0 } else { stalled + 1 };
        if stalled > PATIENCE {
            break;
        }
        (mesh, before) = (next, estimate);
    }
    // None is good enough.
    let is_better = |rung: &Rung, best: &Rung| best.error.is_nan() || rung.error < best.error;
    let all = cheaper.into_iter().map(|(_, rung)| rung);
    Ok(all.reduce(|best, rung| if is_better(&rung, &best) { rung } else { best }).map(|best| (best, None)))
}

/// The first mesh, whose lines lie on the ends of the contact that the cheap one shows; a coarser one where the
/// iteration does not converge on it, and none where none can be fitted, or is allowed.
fn first(scene: &Scene, rungs: &mut Rungs) -> Option<(Discretisation, Rung)> {
    let known = rungs.first.as_ref().and_then(|(_, first)| wider(scene, &first.run, BEYOND));
    let scene = known.as_ref().unwrap_or(scene);
    // Where a gap is not smooth, cells of order 4 tell nothing that those of order 5 do not.
    let is_smooth = rungs.first.as_ref().is_some_and(|(_, first)| {
        let mut each = scene.contacts.iter().zip(&first.run.contacts);
        each.all(|(pair, contact)| pair.profile.is_smooth(contact.measures.half_width()))
    });
    let meshes = if is_smooth { &FIRST[..] } else { &FIRST[1..] };
    let wanted = meshes.iter().position(|(least, _)| *least <= rungs.asked.relative)?;
    for (_, mesh) in meshes[..=wanted].iter().rev() {
        let mut answer = sought(*mesh, scene, rungs).map_err(|error| rungs.is_refused(&error)).ok()?;
        let is_around_axis = (0..scene.contacts.len()).any(|contact| scene.is_around_axis(contact));
        if let Some(wider) = wider(scene, &answer.run, SQUEEZED[usize::from(is_around_axis)]) {
            answer.tried.iter().for_each(|tried| rungs.sought(tried));
            let permits = |dofs| rungs.watch.permits(dofs);
            let near = Sought {
                permits: &permits,
                is_near: true,
                ..Sought::new(&wider, &rungs.formulation, at_rest(rungs.asked))
            };
            answer = mesh.around(&answer.run, &near).map_err(|error| rungs.is_refused(&error)).ok()?;
        }
        // The last one is the mesh itself.
        let others = answer.tried.len().saturating_sub(1);
        answer.tried[..others].iter().for_each(|tried| rungs.sought(tried));
        let rung = rungs.remember(&answer.discretisation, answer.run, PURPOSE);
        if is_kept(&answer.discretisation, &rung, rungs) {
            return Some((answer.discretisation, rung));
        }
    }
    None
}

/// A mesh whose lines lie on the ends of the contact.
fn sought(mesh: Fitted, scene: &Scene, rungs: &Rungs) -> Result<edge_fitted::Answer, Error> {
    let permits = |dofs| rungs.watch.permits(dofs);
    let at_rest = at_rest(rungs.asked);
    let sought =
        Sought { is_near: at_rest >= AT_ONCE, permits: &permits, ..Sought::new(scene, &rungs.formulation, at_rest) };
    let around = rungs.first.as_ref().map(|(_, first)| mesh.around(&first.run, &sought));
    match around {
        Some(Ok(answer)) if answer.is_where_it_was_sought(at_rest) => Ok(answer),
        Some(Err(error @ Error { kind: Kind::TooManyDofs { .. }, .. })) => Err(error),
        // The cheap mesh takes two stretches for one, or one that ends elsewhere: ends are sought on finer ones.
        _ => mesh.found(&Sought { is_near: false, ..sought }),
    }
}

/// How far candidates go beyond a stretch, over its half-width: where only a third of that, the mesh leaves five times
/// as much in its end, and farther out it leaves as much.
const BEYOND: f64 = 1.0;
/// The same below which the cells there are squeezed so much that the mesh is made again: of a sphere with 4 % of
/// candidates beyond, as a cheap mesh took its contact for a quarter shorter, no order of cells told the half-width to
/// better than 1e-4. And around an axis, where half of the radius beyond leaves three times as much in the end.
const SQUEEZED: [f64; 2] = [0.2, 0.6];

/// A scene with candidates that go [so far](BEYOND) beyond what a run found closed, where some do not go beyond it by a
/// part of the half-width and can go farther; none where all do.
fn wider(scene: &Scene, run: &Run, least: f64) -> Option<Scene> {
    let mut wider = scene.clone();
    for (pair, contact) in wider.contacts.iter_mut().zip(&run.contacts) {
        let beyond = |part: f64| {
            let reached = |one: &Stretch| one.end.abs().max(one.begin.abs()) + part * one.half_width();
            contact.measures.stretches.iter().map(reached).fold(0.0, f64::max)
        };
        if pair.stretch < beyond(least) {
            pair.stretch = beyond(BEYOND).min(longest(scene, pair)).max(pair.stretch);
        }
    }
    let goes_farther = |(wider, pair): (&ContactPair, &ContactPair)| wider.stretch > pair.stretch * (1.0 + 1e-9);
    wider.contacts.iter().zip(&scene.contacts).any(goes_farther).then_some(wider)
}

/// Move of an end, over the half-width, that no longer matters.
fn at_rest(asked: &Asked) -> f64 {
    REST * asked.relative
}

/// The next mesh, its lines on the ends that one shows: of the next order and with a layer more, or of smaller cells.
fn next(before: &Discretisation, rung: &Rung, smaller: bool, rungs: &mut Rungs) -> Option<(Discretisation, Rung)> {
    let (scene, resolution) = (&before.scene, before.resolution);
    let is_last = resolution.order == Order::Octic;
    if (smaller || is_last) && rung.run.dofs > LARGE {
        return None;
    }
    let (mut scene, resolution) = match smaller {
        true => (scene.clone(), Resolution { elements: 2 * resolution.elements, ..resolution }),
        false => finer(scene, resolution),
    };
    edge_fitted::lay_on_ends(&mut scene, &rung.run, at_rest(rungs.asked));
    let solved = rungs.solve((scene, resolution), PURPOSE);
    let (mut discretisation, mut rung) = solved.map_err(|error| rungs.is_refused(&error)).ok()?;
    for (pair, contact) in discretisation.scene.contacts.iter_mut().zip(&rung.run.contacts) {
        pair.ends.off = edge_fitted::off(pair, &contact.measures.stretches);
    }
    rung.scene = discretisation.scene.clone();
    is_kept(&discretisation, &rung, rungs).then_some((discretisation, rung))
}

/// Whether a mesh was solved, and has no more cells than are allowed: counted as the 8-node cells that have as many
/// nodes along a side.
fn is_kept(discretisation: &Discretisation, rung: &Rung, rungs: &Rungs) -> bool {
    let across = 0.5 * discretisation.resolution.order.intervals() as f64;
    let cells = discretisation.mesh.cells() as f64 * across * across;
    cells <= rungs.asked.most_cells && rung.run.solution.converged()
}
