//! A refinement series of answers: observed orders, what the series says of its own limit, and whether that is the
//! truth.

use crate::case::{Check, Judged};
use crate::measure::order::{Observed, Richardson, pairs, richardson};
use crate::measure::{Measures, Quantity};
use crate::referee::truth::{Known, Truth};
use crate::solution::EdgeState;

use super::{Profile, Ruled, Verdicts};

/// One number along a series, coarse to fine.
#[derive(Clone, Debug)]
pub struct Along {
    /// What it is.
    pub name: &'static str,
    /// Its values \[mm, rad or MPa\].
    pub values: Vec<f64>,
    /// Errors with their signs, relative to the truth.
    pub errors: Vec<f64>,
    /// Observed orders pair by pair.
    pub orders: Vec<Observed>,
    /// What the last three say of their limit; none where they are not three, or their meshes are not halved.
    pub limit: Option<Richardson>,
    /// Whether the series goes to the truth.
    pub judged: Judged,
}

/// A series.
#[derive(Clone, Debug)]
pub struct Series {
    /// Index of the contact.
    pub contact: usize,
    /// Mean edge within the contact of each mesh, over the half-width of the truth.
    pub sizes: Vec<f64>,
    /// Numbers along it.
    pub along: Vec<Along>,
}

/// The numbers that are followed, and what is judged of their limits.
const WIDTH: [&str; 2] =
    ["second-moment width", "distance of the limit of the second-moment width from the truth, over both error bars"];
const PEAK: [&str; 2] = ["peak pressure", "distance of the limit of the peak from the truth, over both error bars"];

/// How far the ratio of two sizes may be from 2: counted edges are whole.
const HALVED: f64 = 0.1;
/// What straight lines between exact pressures of Hertz leave of the second-moment width at most, over `(h/a)^{3/2}`:
/// it depends on where within an edge the contact ends, which jumps from mesh to mesh, so that no order tells it.
const END: f64 = 0.55;

/// The series of every contact that all answers hold, coarse to fine.
pub fn all(truth: &Truth, answers: &[Verdicts]) -> Vec<Series> {
    (0..truth.case.scene.contacts.len()).filter_map(|contact| of(truth, answers, contact)).collect()
}

/// The series of a contact.
fn of<'a>(truth: &Truth, answers: &'a [Verdicts], contact: usize) -> Option<Series> {
    let one = |one: &'a Verdicts| {
        let profile = Profile::of(&truth.case.scene, one.answer.of(contact)?);
        Some((one.ruled.iter().find(|ruled| ruled.contact == contact)?, profile))
    };
    // None where an answer lacks the contact.
    let all = answers.iter().map(one).collect::<Option<Vec<(&Ruled, Profile)>>>()?;
    if all.len() < 2 {
        return None;
    }
    let width = truth.known(contact, &Quantity::SecondMomentWidth);
    let peak = truth.known(contact, &Quantity::PeakPressure);
    let reach = truth.run.contacts[contact].measures.edge().abs();
    let sizes: Vec<f64> =
        all.iter().map(|(_, profile)| mean_edge(&profile.edges, reach) / width.reference.value).collect();
    let values = |of: fn(&Measures) -> f64| all.iter().map(|(ruled, _)| of(&ruled.measures)).collect::<Vec<f64>>();
    let (_, finest) = &all[all.len() - 1];
    let has_edges = finest.has_forces || finest.has_means;
    let of_end = if has_edges { 0.0 } else { END * sizes[sizes.len() - 1].powf(1.5) * width.reference.value };
    let mut numbers = vec![along(WIDTH, width, values(|measures| measures.second_moment_width), (&sizes, of_end))];
    if !truth.is_unbounded(contact) {
        numbers.push(along(PEAK, peak, values(|measures| measures.peak.pressure), (&sizes, 0.0)));
    }
    Some(Series { contact, sizes, along: numbers })
}

/// Mean length of the edges within the contact.
fn mean_edge(edges: &[EdgeState], reach: f64) -> f64 {
    let within: Vec<f64> = edges.iter().filter(|edge| edge.position().abs() <= reach).map(EdgeState::length).collect();
    within.iter().sum::<f64>() / within.len() as f64
}

/// A number on meshes of these sizes; `of_end` is what it may be off by where the contact ends within an edge, whatever
/// the finest values say.
fn along([name, distance]: [&'static str; 2], known: Known, values: Vec<f64>, (sizes, of_end): (&[f64], f64)) -> Along {
    let truth = known.reference.value;
    let errors: Vec<f64> = values.iter().map(|value| (value - truth) / truth).collect();
    let orders = pairs(sizes, &errors, known.bar / truth.abs());
    let last = |list: &[f64]| <[f64; 3]>::try_from(list.get(list.len().saturating_sub(3)..).unwrap_or_default()).ok();
    let halved = |[coarse, medium, fine]: [f64; 3]| {
        [coarse / medium, medium / fine].iter().all(|ratio| (ratio - 2.0).abs() <= HALVED * 2.0)
    };
    let limit = last(sizes).filter(|three| halved(*three)).and_then(|_| last(&values)).map(richardson);
    let limit = limit.map(|limit| Richardson { bar: limit.bar + of_end, ..limit });
    let check = Check::error(
        distance,
        known.reference.clone(),
        1.0,
        "the error bar of the series (Roache's GCI, an estimate, or what its changes allow) and that of the reference",
    );
    let judged = match limit {
        // Changes that do not fall tell nothing: the finest value is the truth as far as that is known, or fails.
        Some(limit) => {
            let own = if limit.bar.is_nan() { of_end } else { limit.bar };
            check.judge((limit.limit - truth).abs() / (own + known.bar))
        }
        None => {
            let why = "three meshes are needed, each with edges half as long as the one before".into();
            check.not_run(known.reference.kind, &known.reference.name, why)
        }
    };
    Along { name, values, errors, orders, limit, judged }
}
