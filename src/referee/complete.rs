//! Whether an answer holds the whole contact: a part of it is not judged.

use crate::error::Error;
use crate::markdown::significant;
use crate::measure::{display_factor, larger};
use crate::referee::profile::Profile;
use crate::referee::source::Source;
use crate::referee::truth::Truth;
use crate::referee::{Answer, Handed, mistakes, norm};

/// Pressure at an end, over the largest, from which on the contact does not end there.
const PRESSED: f64 = 0.02;
/// Share of the force that may lie behind it.
const DROPPED: f64 = 1e-3;
/// Edges of the answer within which an end counts as that of the contact.
const EDGES: f64 = 1.0 + 1e-3;
/// Intervals over which the force behind it is summed.
const INTERVALS: usize = 2000;

/// Refuses an answer that ends, or begins, under pressure while the contact of the truth goes on.
pub fn all(truth: &Truth, answer: &Answer, handed: &Handed, profile: &Profile, tolerance: f64) -> Result<(), Error> {
    let contact = profile.contact;
    let pair = &truth.case.scene.contacts[contact];
    let ours = &truth.run.contacts[contact].measures;
    let (Some(first), Some(last)) = (profile.points.first(), profile.points.last()) else { return Ok(()) };
    let [Some(begin), Some(end)] = [profile.edges.first(), profile.edges.last()] else { return Ok(()) };
    let largest = profile.points.iter().map(|point| point.pressure.abs()).fold(0.0, larger);
    let is_pressed = |pressure: f64| pressure.abs() > PRESSED * largest;
    let symmetric = !pair.path.has_both_sides();
    let from = match (symmetric, profile.across) {
        (true, true) => 0.0 - ours.edge(),
        (true, false) => ours.begin().max(0.0),
        (false, _) => ours.begin(),
    };
    // An end within one edge of that of the contact is judged as what it is.
    let cuts = [
        (first, [from, first.position], EDGES * begin.length()),
        (last, [last.position, ours.edge()], EDGES * end.length()),
    ];
    let carried = |s: f64| {
        let pressure = truth.pressure(contact, s) * truth.case.scene.depth(pair.path.point(s));
        if pressure.is_finite() { pressure } else { 0.0 }
    };
    let force = |from: f64, to: f64| (to - from) * norm::mean([from, to], INTERVALS, carried);
    let whole = force(from, ours.edge());
    for (stop, [begin, end], near) in cuts.into_iter().filter(|(stop, ..)| is_pressed(stop.pressure)) {
        // An answer away from the contact has none of it.
        let share = force(begin.max(from), end.min(ours.edge())) / whole;
        if end - begin <= near || share <= DROPPED {
            continue;
        }
        let message = format!(
            "the pressures of contact `{}` stop at {} {} with {:.0} % of the largest, and {:.1} % of the force lies beyond",
            pair.name,
            significant(display_factor(&pair.path) * stop.position, 4),
            if pair.path.is_straight() { "mm" } else { "°" },
            100.0 * stop.pressure.abs() / largest,
            100.0 * share
        );
        let explained = mistakes::explain(truth, handed, tolerance).into_iter().map(|says| format!("; or {says}"));
        let remedy =
            "hand in every point up to where nothing presses, on both sides of a contact that is not symmetric";
        let source = Source { file: &answer.file, text: "" };
        return Err(source.refused(message, remedy.to_owned() + &explained.collect::<String>()));
    }
    Ok(())
}
