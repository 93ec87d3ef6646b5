//! What the paper says of iterations, judged over the designed set of its readings.

use super::found::Findings;
use super::statement::{Judgement, Statement};
use crate::study::readings::fared::{Fared, NONE};
use crate::study::readings::reading::{Axis, JUDGED, Reading, told};
use crate::study::readings::runs::{Example, seen};
use crate::study::readings::sentence::Sentence;

/// How a judgement is made, for the page.
pub const RULE: &str = "What the paper says of iterations is judged under the reading nearest to its text, at three tolerances, and \
    [beside it](readings.md) under every single departure that keeps the agreement with the exact solution. Where a statement holds at all three \
    tolerances and no other rule of stiffness flips it, it is reproduced; where another rule does, it is not decidable without [12], the paper's \
    reference on that rule, which is not at hand. Where it holds at some of the tolerances, or under a departure of another kind, it is \
    reproduced only if that is so; else it is not reproduced.";

/// What its reference 12 would tell.
const RULES: [Axis; 2] = [Axis::Varying, Axis::Constant];

/// The sentences but for the agreement, which is held against the closed form itself.
pub fn of_all(f: &Findings) -> Vec<Statement> {
    let Some(courses) = f.readings() else { return Vec::new() };
    let seen = Example::ALL.map(|example| seen(courses, &Reading::nearest(), example));
    let own = Sentence::ALL.into_iter().filter(|one| *one != Sentence::Agrees);
    own.map(|sentence| statement(sentence, &sentence.numbers(&seen), &Fared::of(sentence, courses))).collect()
}

fn statement(sentence: Sentence, numbers: &str, fared: &Fared) -> Statement {
    let held = JUDGED.iter().zip(fared.held);
    let at = held.map(|(tolerance, held)| format!("{} at {tolerance:.0e}", if held { "holds" } else { "fails" }));
    let at = at.collect::<Vec<_>>().join(", ");
    let count = fared.held.iter().filter(|held| **held).count();
    let flips = |axis: &Axis| fared.flips.iter().any(|one| one.axes() == [*axis]);
    let axes: Vec<String> =
        Axis::ALL.iter().filter(|axis| flips(axis)).map(|axis| axis.title().to_lowercase()).collect();
    let flips = if axes.is_empty() { NONE.into() } else { format!("hangs on: {}", axes.join(", ")) };
    Statement {
        text: sentence.name(),
        clause: format!("holds at {count} of {} tolerances; {flips}", fared.held.len()),
        measured: format!("cylinder and pin–rod, reading nearest to the text: {numbers}; {at}; {}", fared.told()),
        judgement: judgement(fared),
    }
}

/// The judgement by how a sentence fares.
pub fn judgement(fared: &Fared) -> Judgement {
    let is_rule = |one: &&Reading| one.axes().iter().all(|axis| RULES.contains(axis));
    let by_rule: Vec<&Reading> = fared.flips.iter().filter(is_rule).collect();
    let at = JUDGED.iter().zip(fared.held).filter(|(_, held)| *held).map(|(one, _)| format!("{one:.0e}"));
    let at: Vec<String> = at.collect();
    if at.len() < JUDGED.len() && !at.is_empty() {
        return Judgement::OnlyIf(format!("the tolerance is {}", at.join(" or ")));
    }
    match (fared.holds(), fared.flips.is_empty()) {
        _ if !by_rule.is_empty() => Judgement::Undecidable(format!("{} {}", fared.otherwise(), told(by_rule))),
        (true, _) => Judgement::Reproduced,
        (false, true) => Judgement::NotReproduced,
        (false, false) => Judgement::OnlyIf(told(&fared.flips)),
    }
}
