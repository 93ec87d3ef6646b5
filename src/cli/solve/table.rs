//! The result of a solve as lines on standard output.

use crate::algorithm::Acceleration;
use crate::cli::json::{OracleReading, oracle};
use crate::cli::solve::found::{Found, ReactionReading};
use crate::cli::terminal::{say, say_in_lines};
use crate::cli::{bars, verify};
use crate::markdown;
use crate::measure::display_factor;
use crate::mesh::Order;
use crate::scene::ContactPair;
use crate::solve::run::{Contact, Run};

/// A reaction below this part of the largest force, or a place below this part of the half-width, is round-off, told as
/// 0.
const ROUND_OFF: f64 = 1e-9;

/// What is said of the width of a contact, and of that by its second moment: of strips, and of bodies of revolution.
const OF_STRIP: [&str; 2] = ["half-width", "second-moment width"];
const OF_CIRCLE: [&str; 2] = ["contact radius", "second-moment radius"];

/// Prints what was solved, how it ended, what was measured, and how far that is from the oracle.
pub fn print(found: &Found) {
    let Found { problem, run, reactions, checks, .. } = found;
    say_in_lines(&format!("{}: {}", problem.name, problem.title));
    print_work(run, problem.resolution.order);
    let several = run.contacts.len() > 1;
    for (index, pair) in problem.scene.contacts.iter().enumerate() {
        if several {
            say(format!("contact `{}`:", pair.name));
        }
        let widths = if problem.scene.is_around_axis(index) { OF_CIRCLE } else { OF_STRIP };
        print_contact((pair, widths), &run.contacts[index], &found.notes_of(index), if several { "  " } else { "" });
    }
    print_reactions(run, reactions);
    bars::print(found);
    for check in checks {
        say_in_lines(&verify::told("check", check));
    }
    for OracleReading { contact, name, kind, called, reference, error, of: (index, number), .. } in
        oracle::readings(problem, run)
    {
        let of = if several { format!("contact `{contact}`: ") } else { String::new() };
        let (unit, factor) = number.unit(!problem.scene.contacts[index].path.is_straight());
        let (reference, error) = (markdown::value(factor * reference), markdown::error(error));
        say_in_lines(&format!("{of}{name} ({kind}) {called}: {reference} {unit}, error {error}"));
    }
    found.notes().iter().for_each(|note| say_in_lines(&format!("note: {note}")));
}

/// By what it was solved, how it ended, and what that took.
fn print_work(run: &Run, order: Order) {
    let order = order.nodes_per_cell();
    say(format!("{}, {order}-node cells, {} dofs, {} retained", run.formulation.name(), run.dofs, run.retained));
    let work = &run.solution.work;
    say(format!(
        "{} after {} iterations, {} factorisations, iteration error {}",
        run.solution.outcome,
        work.iterations,
        work.factorisations,
        markdown::error(run.solution.error().largest())
    ));
    if run.formulation.acceleration != Acceleration::None {
        say(format!("{} accelerated iterations given up for the plain one", work.rejected));
    }
}

/// What the supports exert.
fn print_reactions(run: &Run, reactions: &[ReactionReading]) {
    let forces = run.contacts.iter().map(|contact| contact.transmitted);
    let largest = forces.chain(reactions.iter().map(|reaction| reaction.force)).map(f64::abs).fold(0.0, f64::max);
    for ReactionReading { body, at, component, force } in reactions {
        let force = if force.abs() < ROUND_OFF * largest { 0.0 } else { *force };
        say(format!("reaction on `{body}` at {at}: {component} {} N", markdown::value(force)));
    }
    say(format!("equilibrium: every body within {} of its largest force", markdown::error(run.imbalance())));
}

/// What was measured of one contact.
fn print_contact((pair, [own, moment]): (&ContactPair, [&str; 2]), found: &Contact, notes: &[String], indent: &str) {
    let factor = display_factor(&pair.path);
    let unit = if factor > 1.0 { "°" } else { "mm" };
    let measures = &found.measures;
    let [width, by_moment, counted] = [measures.half_width(), measures.second_moment_width, measures.half_width_nodes]
        .map(|width| format!("{} {unit}", markdown::value(factor * width)));
    say(format!("{indent}{own} {width}, by counting {counted}"));
    say(format!("{indent}{moment} {by_moment}"));
    let place =
        |s: f64| markdown::value(if s.abs() < ROUND_OFF * measures.second_moment_width { 0.0 } else { factor * s });
    let peak = match found.unbounded {
        None => format!("{} MPa", markdown::value(measures.peak.pressure)),
        Some(_) => "without limit".into(),
    };
    say(format!("{indent}peak pressure {peak} at {} {unit}", place(measures.peak.position)));
    say(format!(
        "{indent}largest pressure of a point {} MPa at {} {unit}",
        markdown::value(measures.largest.pressure),
        place(measures.largest.position),
    ));
    say(format!("{indent}resultant {} N", markdown::value(found.transmitted)));
    let pressed = measures.stretches.iter().map(|s| format!("from {} to {}", place(s.begin), place(s.end)));
    let pressed = pressed.collect::<Vec<_>>().join(", ");
    let centre = if pair.path.has_both_sides() {
        format!(", centre of pressure at {} {unit}", place(measures.centre))
    } else {
        String::new()
    };
    if !pressed.is_empty() {
        say(format!("{indent}pressed {pressed} {unit}{centre}"));
    }
    for note in notes {
        say_in_lines(&format!("{indent}note: {note}"));
    }
}
