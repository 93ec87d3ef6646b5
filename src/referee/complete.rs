//! Whether an answer holds the whole contact: a part of it is not judged.

use crate::error::Error;
use crate::measure::larger;
use crate::referee::answer::places;
use crate::referee::profile::{EDGES, Profile};
use crate::referee::side::{DROPPED, PRESSED};
use crate::referee::source::Source;
use crate::referee::truth::Truth;
use crate::referee::{Answer, Handed, mistakes, norm};
use crate::scene::ContactPair;

/// Intervals over which the force behind an end is summed.
const INTERVALS: usize = 2000;
/// Times the spacing of the points beside it from which on a step between two points is a hole: of those on either
/// side, or of the two next ones on each, since steps that grow one way are not longer than both; and share of the
/// force that may lie in holes.
const HOLE: f64 = 5.0;
const BETWEEN: f64 = 3.5;
const HIDDEN: f64 = 0.05;
/// Steps on either side by which that spacing is known.
const BESIDE: usize = 4;
/// What to do about an end under pressure, and about holes.
const ALL: &str = "hand in every point up to where nothing presses, on both sides of a contact that is not symmetric";
const EVERY: &str = "hand in every point of the contact; what lies between two of them is not guessed";

/// Share of the force of a contact between two places; between two places that are beyond it none.
type Share<'a> = &'a dyn Fn([f64; 2]) -> f64;

/// Refuses an answer that ends, or begins, under pressure while the contact of the truth goes on, or that has holes in
/// it.
pub fn all(truth: &Truth, answer: &Answer, handed: &Handed, profile: &Profile, tolerance: f64) -> Result<(), Error> {
    let contact = profile.contact;
    let pair = &truth.case.scene.contacts[contact];
    let ours = &truth.run.contacts[contact].measures;
    let from = match (!pair.path.has_both_sides(), profile.across) {
        (true, true) => 0.0 - ours.edge(),
        (true, false) => ours.begin().max(0.0),
        (false, _) => ours.begin(),
    };
    // Where the contact of the truth begins and ends, on the sides that the answer has.
    let reach = [from, ours.edge()];
    let carried = |s: f64| {
        let pressure = truth.pressure(contact, s) * truth.case.scene.depth(pair.path.point(s));
        if pressure.is_finite() { pressure } else { 0.0 }
    };
    let force = |[from, to]: [f64; 2]| (to - from) * norm::mean([from, to], INTERVALS, carried);
    let share = |[from, to]: [f64; 2]| {
        let within = [from.max(reach[0]), to.min(reach[1])];
        if within[0] < within[1] { force(within) / force(reach) } else { 0.0 }
    };
    let cut = cut(&share, reach, handed, profile).map(|message| (message, ALL));
    let lacking = cut.or_else(|| hole(&share, pair, handed).map(|message| (message, EVERY)));
    let Some((message, remedy)) = lacking else { return Ok(()) };
    let explained = mistakes::explain(truth, handed, (&answer.units, false), tolerance);
    let explained = explained.into_iter().map(|says| format!("; or {says}"));
    let source = Source { file: &answer.file, text: "" };
    Err(source.refused(message, remedy.to_owned() + &explained.collect::<String>()))
}

/// Where a profile stops under pressure, and how much of the force lies beyond.
fn cut(share: Share, reach: [f64; 2], handed: &Handed, profile: &Profile) -> Option<String> {
    let ([first, last], [begin, end]) =
        ([profile.points.first()?, profile.points.last()?], [profile.edges.first()?, profile.edges.last()?]);
    let largest = profile.points.iter().map(|point| point.pressure.abs()).fold(0.0, larger);
    let is_pressed = |pressure: f64| pressure.abs() > PRESSED * largest;
    // An end within one edge of that of the contact is judged as what it is; at a symmetry line none ends, and areas
    // may be of points within edges.
    let path = &profile.pair().path;
    let is_half = !path.has_both_sides() && !profile.across && !profile.scene.is_around_axis(profile.contact);
    let has_areas = handed.points.iter().all(|point| point.area.is_some());
    let is_at_line = is_half && reach[0] <= 0.0 && !has_areas;
    let begins = first.position.min(begin.ends[0]);
    let cuts = [
        (first, [reach[0], begins], if is_at_line { 0.0 } else { EDGES * begin.length() }),
        (last, [last.position, reach[1]], EDGES * end.length()),
    ];
    let dropped =
        cuts.into_iter().filter(|(stop, ..)| is_pressed(stop.pressure)).find_map(|(stop, [from, to], near)| {
            let share = share([from, to]);
            (to - from > near && share > DROPPED).then_some((stop, share))
        });
    let (stop, share) = dropped?;
    Some(format!(
        "the pressures of contact `{}` stop at {} with {:.0} % of the largest, and {:.1} % of the force lies beyond",
        profile.pair().name,
        places(profile.pair(), &[stop.position]),
        100.0 * stop.pressure.abs() / largest,
        100.0 * share
    ))
}

/// Where an answer has holes, the widest by name, and how much of the force lies in all.
fn hole(share: Share, pair: &ContactPair, handed: &Handed) -> Option<String> {
    let holes: Vec<([f64; 2], f64)> = holes(handed).into_iter().filter(|(ends, _)| share(*ends) > 0.0).collect();
    let share: f64 = holes.iter().map(|(ends, _)| share(*ends)).sum();
    let (widest, times) = holes.iter().max_by(|(a, _), (b, _)| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let others = match holes.len() - 1 {
        0 => String::new(),
        more => format!(" and in {more} more like it"),
    };
    (share > HIDDEN).then(|| {
        format!(
            "contact `{}` has no point from {}, {times:.0} times as far apart as those beside them, and {:.1} % of the \
            force lies there{others}",
            pair.name,
            places(pair, widest),
            100.0 * share
        )
    })
}

/// The steps between points that are much longer than those beside them, with how many times. Of four on either side
/// the longest quarter does not count: other holes may be among them, and points that lie in pairs have every second
/// step short.
fn holes(handed: &Handed) -> Vec<([f64; 2], f64)> {
    let steps: Vec<[f64; 2]> = handed.points.windows(2).map(|two| [two[0].position, two[1].position]).collect();
    let length = |step: &[f64; 2]| step[1] - step[0];
    let times = |k: usize| {
        let beside = k.saturating_sub(BESIDE)..(k + BESIDE + 1).min(steps.len());
        let mut beside: Vec<f64> = beside.filter(|&other| other != k).map(|other| length(&steps[other])).collect();
        beside.sort_by(|a, b| b.total_cmp(a));
        let spacing = beside.get(beside.len() / 4).filter(|_| beside.len() >= BESIDE)?;
        Some(length(&steps[k]) / spacing).filter(|times| *times > HOLE)
    };
    let between = |k: usize| {
        let longest = |side: &[[f64; 2]]| side.iter().map(length).reduce(f64::max);
        let longer = longest(&steps[k.checked_sub(2)?..k])?.max(longest(steps.get(k + 1..k + 3)?)?);
        Some(length(&steps[k]) / longer).filter(|times| *times > BETWEEN)
    };
    (0..steps.len()).filter_map(|k| Some((steps[k], times(k).or_else(|| between(k))?))).collect()
}
