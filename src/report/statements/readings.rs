//! What the paper says of iterations, judged over the readings that its text leaves open.
//!
//! Under the reading nearest to the text, at three tolerances, a sentence holds or it does not. Where it does at all three, it is
//! reproduced. Where it does not and another rule of its reference 12 alone would change that, it is not decidable; where something else
//! would, it is reproduced only if that is so; where nothing would, it is not reproduced.

use super::found::Findings;
use super::statement::{Judgement, Statement};
use crate::markdown;
use crate::study::readings::axes::{Example, Stop};
use crate::study::readings::course::pairs;
use crate::study::readings::courses::Courses;
use crate::study::readings::evidence;
use crate::study::readings::map::{self, Judged};
use crate::study::readings::reading::{Axis, Reading};
use crate::study::readings::sentence::{Seen, Sentence};

/// Tolerances that a judgement is made at.
const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];
/// What its reference 12 would tell.
const RULES: [Axis; 2] = [Axis::Varying, Axis::Constant];
/// Conditions that are told of those equally near.
const TOLD: usize = 3;

/// The sentences but for the agreement, which is held against the closed form itself.
pub fn of_all(f: &Findings) -> Vec<Statement> {
    let Some(courses) = f.readings() else { return Vec::new() };
    let all = map::all(&courses);
    Sentence::ALL.into_iter().filter(|one| *one != Sentence::Agrees).map(|one| statement(one, &courses, &all)).collect()
}

fn statement(sentence: Sentence, courses: &Courses, all: &[Judged]) -> Statement {
    let nearest = Reading::nearest();
    let at = |tolerance: f64| Reading { stop: Stop { tolerance, ..nearest.stop }, ..nearest };
    let held = TOLERANCES.map(|tolerance| Judged::of(courses, at(tolerance)).holds(sentence));
    let seen = Example::ALL
        .map(|example| Seen::five(pairs().map(|(a, e)| (e, a, courses.ends(&nearest, example, e, a))).collect()));
    let told = TOLERANCES
        .iter()
        .zip(held)
        .map(|(tolerance, held)| format!("{} at {tolerance:.0e}", if held { "holds" } else { "fails" }));
    let number = all.iter().filter(|judged| judged.holds(sentence)).count();
    Statement {
        text: text(sentence),
        clause: format!(
            "holds at {} of {} tolerances, and under {} % of {} readings",
            held.iter().filter(|held| **held).count(),
            held.len(),
            markdown::significant(100.0 * number as f64 / all.len() as f64, 2),
            all.len()
        ),
        measured: format!(
            "reading nearest to the text: {}; {}; cylinder and pin–rod. Holds under {number} of {} readings",
            evidence::of(sentence, &seen),
            told.collect::<Vec<_>>().join(", "),
            all.len(),
        ),
        judgement: judgement(sentence, &nearest, &held, all),
    }
}

/// The judgement from what holds at the tolerances, and under all readings.
pub fn judgement(sentence: Sentence, nearest: &Reading, held: &[bool], all: &[Judged]) -> Judgement {
    if held.iter().all(|held| *held) {
        return Judgement::Reproduced;
    }
    if held.iter().any(|held| *held) {
        let own =
            TOLERANCES.iter().zip(held).filter(|(_, held)| **held).map(|(tolerance, _)| format!("{tolerance:.0e}"));
        return Judgement::OnlyIf(format!("the tolerance is {}", own.collect::<Vec<_>>().join(" or ")));
    }
    let holding = all.iter().filter(|judged| judged.holds(sentence));
    let apart: Vec<Vec<(Axis, String)>> = holding.map(|judged| nearest.differences(&judged.reading)).collect();
    let Some(least) = apart.iter().map(Vec::len).min() else { return Judgement::NotReproduced };
    let nearby: Vec<Vec<(Axis, String)>> = apart.into_iter().filter(|one| one.len() == least).collect();
    let is_rule = |one: &&Vec<(Axis, String)>| one.iter().all(|(axis, _)| RULES.contains(axis));
    let by_rule: Vec<Vec<(Axis, String)>> = nearby.iter().filter(is_rule).cloned().collect();
    if by_rule.is_empty() { Judgement::OnlyIf(some(&nearby)) } else { Judgement::Undecidable(some(&by_rule)) }
}

/// Some conditions of as many, in words.
fn some(conditions: &[Vec<(Axis, String)>]) -> String {
    let told = conditions
        .iter()
        .take(TOLD)
        .map(|one| one.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(", "));
    let told = told.collect::<Vec<_>>().join("; or ");
    match conditions.len().saturating_sub(TOLD) {
        0 => told,
        more => format!("{told}; or {more} more"),
    }
}

/// What the paper says.
fn text(sentence: Sentence) -> &'static str {
    match sentence {
        Sentence::Agrees => "Every combination is in good agreement with the reference (Figs 10, 14, 15)",
        Sentence::VaryingDepends => {
            "The iterations of varying stiffness depend strongly on the initial stiffness (Fig. 11, §5)"
        }
        Sentence::ConstantDepends => {
            "The iterations of constant stiffness depend strongly on the initial stiffness (Fig. 11, §5)"
        }
        Sentence::Fails => "In some cases there was no convergence found at all (Fig. 11, §5)",
        Sentence::MoreStable => "Varying stiffness is much more stable than constant stiffness (Fig. 11)",
        Sentence::LineAlways => {
            "With varying stiffness and line elements convergence was found in every case (Fig. 11, §5)"
        }
        Sentence::Proviso => "… provided that line elements have been used: with layer elements not in every case (§5)",
        Sentence::TwoSteps => {
            "Kinematic load with node elements converged in two iterations for any initial stiffness, in both examples"
        }
        Sentence::Fewest => "Kinematic load takes the fewest iterations",
        Sentence::LeastWork => "Kinematic load takes the least computing time (counted in operations)",
        Sentence::Saves => {
            "Constant stiffness needs one factorisation only and saves a great deal of operations against varying stiffness"
        }
        Sentence::Alike => "For the pin–rod the elements and algorithms converge as they do for the cylinder",
    }
}
