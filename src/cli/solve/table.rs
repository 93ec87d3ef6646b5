//! The result of a solve as lines on standard output.

use crate::algorithm::Acceleration;
use crate::case::{Problem, Run};
use crate::cli::reactions::ReactionReading;
use crate::cli::{json, say};
use crate::formulation::Start;
use crate::measure::display_factor;
use crate::mesh::Resolution;
use crate::report::format;

/// A reaction below this part of the largest force, or a place below this part of the half-width, is round-off, told as 0.
const ROUND_OFF: f64 = 1e-9;

/// Prints what was solved, how it ended, what was measured, and how far that is from the oracle.
pub fn print(problem: &Problem, resolution: Resolution, run: &Run, reactions: &[ReactionReading]) {
    let factor = display_factor(&problem.scene.contact.path);
    let unit = if factor > 1.0 { "°" } else { "mm" };
    let order = resolution.order.nodes_per_cell();
    say(format!("{}: {}", problem.name, problem.title));
    say(format!(
        "{}, {order}-node cells, {} freedoms, {} retained",
        run.formulation.name(),
        run.freedoms,
        run.retained
    ));
    let work = &run.solution.work;
    say(format!(
        "{} after {} steps, {} factorisations, residual {}",
        run.solution.outcome,
        work.steps,
        work.factorisations,
        format::error(run.solution.residual())
    ));
    if run.formulation.acceleration != Acceleration::None {
        say(format!("{} accelerated steps given up for the plain one", work.rejected));
    }
    if run.formulation.start == Start::Nested {
        let coarser = &run.solution.coarser;
        say(format!(
            "start found by {} steps and {} factorisations on coarser meshes",
            coarser.steps, coarser.factorisations
        ));
    }
    say(format!(
        "half-width by second moment {} {unit}, by counting {} {unit}",
        format::value(factor * run.measures.half_width),
        format::value(factor * run.measures.half_width_nodes)
    ));
    let place = |s: f64| format::value(if s.abs() < ROUND_OFF * run.measures.half_width { 0.0 } else { factor * s });
    say(format!(
        "peak pressure {} MPa at {} {unit}, resultant {} N",
        format::value(run.measures.peak.pressure),
        place(run.measures.peak.position),
        format::value(run.transmitted)
    ));
    if problem.scene.contact.path.has_both_sides() {
        let [centre, begin, edge] = [run.measures.centre, run.measures.begin, run.measures.edge];
        let [centre, begin, edge] = [centre, begin, edge].map(place);
        say(format!("centre of pressure at {centre} {unit}, pressed from {begin} to {edge} {unit}"));
    }
    let largest = reactions.iter().map(|reaction| reaction.force.abs()).fold(run.transmitted.abs(), f64::max);
    for ReactionReading { body, at, component, force } in reactions {
        let force = if force.abs() < ROUND_OFF * largest { 0.0 } else { *force };
        say(format!("reaction on `{body}` at {at}: {component} {} N", format::value(force)));
    }
    if let Some(note) = run.note() {
        say(format!("note: {note}"));
    }
    for oracle in json::oracles(problem, run) {
        say(format!(
            "{} ({}) {}: {}, error {}",
            oracle.name,
            oracle.kind,
            oracle.quantity,
            format::value(oracle.reference),
            format::error(oracle.error)
        ));
    }
}
