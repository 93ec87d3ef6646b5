//! What a user must know before quoting a contact, in words. What of it is hardly meant is told by `plausible`.

use crate::markdown;
use crate::measure::{nodal, profile};
use crate::solution::Unseen;
use crate::solve::run::{Contact, INSIDE, Unbounded};
use crate::solve::{Element, Run};

/// Active points and pressed edges on a half-width from which on it is worth quoting.
pub const RESOLVED: [usize; 2] = [4, 3];

/// Width of a contact over the edge in which it lies, below which it is narrower; where a mesh line lies on its end,
/// round-off does not count.
const NARROW: f64 = 0.98;

/// Departure of a pressure from its neighbours' line, over the peak, that no smooth contact on a usable mesh shows.
const ROUGH: f64 = 0.1;

/// What the solution of a converged run shows of a contact, to be known before it is quoted; one note hides no other:
/// no contact, what a penalty costs, contact on too few points, pressures that oscillate, a point above its neighbours,
/// an open middle.
pub fn of(run: &Run, contact: usize) -> Vec<String> {
    if !run.solution.converged() {
        return Vec::new();
    }
    let Contact { measures, penalty, open, unbounded, .. } = &run.contacts[contact];
    if *open == Some(true) {
        return vec!["no contact: every candidate is open".into()];
    }
    let points = run.solution.points_of(contact);
    let (begin, edge) = (measures.begin(), measures.edge());
    let (middle, reach) = (0.5 * (begin + edge), 0.5 * (edge - begin));
    let rough = profile::oscillation(&profile::about(points, middle), INSIDE * reach) / measures.peak.pressure;
    let highest = measures.largest.pressure;
    let penalty = penalty.map(|errors| {
        let [peak, half_width] = [errors.peak, errors.half_width].map(|error| 100.0 * error);
        format!("the springs of the penalty cost {peak:+.2} % of the peak and {half_width:+.2} % of the half-width")
    });
    let unbounded = unbounded.map(|Unbounded { position, growth, exponent }| {
        let percent = markdown::significant(100.0 * growth, 2);
        match exponent {
            Some(exponent) => format!(
                "a corner is pressed at s = {position}: the pressure grows as r^-{} towards it, by {percent} % with \
                every halving of the elements, and has no limit",
                markdown::significant(exponent, 2)
            ),
            None => format!(
                "the peak grows by {percent} % with a halving of the elements: it has no limit, or is narrower than \
                the mesh shows"
            ),
        }
    });
    let remedy = match run.formulation.element {
        Element::Node => "quote means over edges, or refine the mesh",
        _ => "quote means over edges, or use the node element",
    };
    let rough = (rough > ROUGH).then(|| {
        format!(
            "pressures of neighbouring points depart from one another by {:.0} % of the peak: {remedy}",
            100.0 * rough
        )
    });
    // A corner is told above.
    let above = (unbounded.is_none() && run.stands_out(contact)).then(|| {
        let highest = markdown::significant(highest, 3);
        format!(
            "a point carries {highest} MPa, more than the peak through its neighbours: a corner, or too coarse a mesh"
        )
    });
    let open_between = (measures.stretches.len() > 1).then(|| {
        format!(
            "the contact is closed on {} stretches and open between them: the half-width is that of all together",
            measures.stretches.len()
        )
    });
    let notes = [penalty, unbounded, unresolved(run, contact), rough, above, open_between].into_iter().flatten();
    notes.chain(unseen(run, contact)).collect()
}

/// Penetrations that no contact point sees.
fn unseen(run: &Run, contact: usize) -> impl Iterator<Item = String> {
    let approach = run.solution.contacts[contact].approach;
    run.solution.unseen.get(contact).into_iter().flatten().map(move |one| {
        let Unseen { position, penetration, is_candidate } = one;
        let part = 100.0 * penetration / approach;
        let (place, remedy) = match is_candidate {
            true => ("between contact points", "the gap is narrower there than an element: refine the mesh"),
            false => ("beyond the candidates", "widen the candidate stretch, or add a contact there"),
        };
        format!(
            "{place}, at s = {position}, the surfaces penetrate by {penetration:.2e} mm, {part:.1} % of the \
            approach that the contact's force makes: {remedy}"
        )
    })
}

/// That a contact rests on too few points, or else on too few edges.
fn unresolved(run: &Run, contact: usize) -> Option<String> {
    let points = run.solution.points_of(contact);
    let measures = &run.contacts[contact].measures;
    // As many on each side of x = 0, where the point there may be common to both.
    let across = points.first().is_some_and(|point| point.position < 0.0);
    let resolved = RESOLVED.map(|number| if across { 2 * number - 1 } else { number });
    let all = [points.len(), run.solution.edges_of(contact).len()];
    let rests = |on: usize, k: usize, what: &str| {
        let few = on < resolved[k].min(all[k]);
        few.then(|| format!("contact rests on {on} of {} candidate {what}: refine before quoting it", all[k]))
    };
    // An edge of many nodes is as good as several.
    let by_edges = !nodal::are_many(run.solution.part(contact));
    let few = || if by_edges { rests(measures.pressed_edges, 1, "edges") } else { narrow(run, contact) };
    rests(measures.active, 0, "points").or_else(few)
}

/// That a closed stretch is narrower than the edge in which it lies, however many nodes that has.
fn narrow(run: &Run, contact: usize) -> Option<String> {
    let edges = run.solution.edges_of(contact);
    run.contacts[contact].measures.stretches.iter().find_map(|one| {
        let middle = 0.5 * (one.begin + one.end);
        let edge = edges.iter().find(|edge| edge.ends[0] <= middle && middle <= edge.ends[1])?;
        let part = (one.end - one.begin) / edge.length();
        let told = || format!("contact is narrower than an element, {part:.2} of its length: refine before quoting it");
        (part < NARROW).then(told)
    })
}
