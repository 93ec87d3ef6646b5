//! What is found is right, whatever the formulation.

use super::found::{Findings, extremes};
use super::statement::{Judgement, Statement, judged};
use crate::case::library::{cylinder, pin_rod};
use crate::case::{Quantity, Verdict};
use crate::study::atlas::{self, Plane};
use crate::study::digitised::GAERTNER;
use crate::study::quarter::LEFT_OUT;
use crate::study::{Numbers, Room};
use crate::uncertainty::COVERAGE;

/// Difference of the nine that counts as none.
const UNREMARKABLE: f64 = 1.0;
/// Most over fewest iterations that count as a difference.
const DIFFERENT: f64 = 10.0;

/// Every combination agrees with the reference.
pub fn of_all(f: &Findings) -> Statement {
    let worst = |case: &'static str, quantity| 100.0 * f.error(case, &quantity);
    Statement {
        text: "Every combination of element and algorithm agrees with Hertz, and for the pin–rod with one another (Figs 10, 14, 15)",
        clause: format!(
            "p₀ within {:.2} % of Hertz, pin–rod peak within {:.2} %",
            worst(cylinder::NINE, Quantity::PeakPressure),
            worst(pin_rod::NINE, Quantity::PeakPressure),
        ),
        measured: format!(
            "cylinder, all nine: p₀ within {:.2} %, a within {:.2} %; pin–rod, all nine: peak within {:.2} %, edge means within {:.2} %",
            worst(cylinder::NINE, Quantity::PeakPressure),
            worst(cylinder::NINE, Quantity::SecondMomentWidth),
            worst(pin_rod::NINE, Quantity::PeakPressure),
            worst(pin_rod::NINE, Quantity::EdgeMeans),
        ),
        judgement: judged(f.passes(cylinder::NINE) && f.passes(pin_rod::NINE)),
    }
}

/// No formulation is more accurate than another, as they stand in the paper.
pub fn no_difference(f: &Findings) -> Statement {
    let nine = f.0.iter().find_map(|finding| match &finding.numbers {
        Numbers::Atlas(atlas::Numbers::Saved(Plane::Cylinder, saved)) => Some(saved.as_slice()),
        _ => None,
    });
    let nine = nine.unwrap_or_default();
    let [low, high] = extremes(nine.iter().map(|one| one.iterations[0].map_or(f64::NAN, |count| count as f64)));
    let spread = |quantity: usize| {
        let [low, high] = extremes(nine.iter().map(|one| one.measured[quantity]));
        100.0 * (high / low - 1.0)
    };
    let [peak, width] = [0, 1].map(spread);
    Statement {
        text: "Within the prescribed accuracy there is no remarkable difference between elements or algorithms; the differences are in iterations and time",
        clause: format!("spread {peak:.2} % in p₀; {low} to {high} iterations"),
        measured: format!(
            "cylinder: spread of the nine {peak:.2} % in p₀, {width:.2} % in the second-moment width; {low} to {high} iterations"
        ),
        judgement: judged(peak < UNREMARKABLE && width < UNREMARKABLE && high / low > DIFFERENT),
    }
}

/// The upper quarter may be left out.
pub fn top_quarter(f: &Findings) -> Statement {
    let changes = f.0.iter().filter_map(|finding| match &finding.numbers {
        Numbers::Quarter(numbers) => Some(&numbers.changes),
        _ => None,
    });
    let points: Vec<[f64; 2]> = changes.flatten().map(|change| [change.a_over_r, change.largest()]).collect();
    let small = points.iter().filter(|p| p[1] <= LEFT_OUT).map(|p| p[0]).fold(0.0, f64::max);
    let all = points.iter().all(|p| p[1] <= LEFT_OUT);
    let worst =
        points.iter().map(|p| format!("{:.3} % at a/R = {}", 100.0 * p[1], p[0])).collect::<Vec<_>>().join(", ");
    Statement {
        text: "The top quarter of the half cylinder does not influence the contact and may be left out",
        clause: format!("change below {} % up to a/R = {small}", 100.0 * LEFT_OUT),
        measured: format!("change of p₀ or a: {worst}; below {} % up to a/R = {small}", 100.0 * LEFT_OUT),
        judgement: if all {
            Judgement::Reproduced
        } else if small > 0.0 {
            Judgement::OnlyIf(format!("a/R is at most {small}"))
        } else {
            Judgement::NotReproduced
        },
    }
}

/// Gaertner's curves.
pub fn gaertner(f: &Findings) -> Statement {
    let verdict =
        f.0.iter()
            .find(|finding| finding.room == Room::Digitised && finding.case == GAERTNER)
            .map(|finding| finding.verdict());
    let (measured, judgement) = match verdict {
        Some(Verdict::Pass) => (format!("every point within {COVERAGE} u_val"), Judgement::Reproduced),
        Some(Verdict::Fail) => (format!("a point beyond {COVERAGE} u_val"), Judgement::NotReproduced),
        Some(Verdict::NotRun(why)) => (why, Judgement::NotJudged),
        None => ("not asked".to_string(), Judgement::NotJudged),
    };
    Statement {
        text: "Reasonable agreement with Gaertner's finite elements and experiment (Figs 14, 15)",
        clause: measured.clone(),
        measured,
        judgement,
    }
}
