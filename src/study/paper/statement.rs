//! How a sentence fares over the designed set — under the nearest reading, and by which departures — and what is made of it.

use std::fmt;

use crate::study::paper::reading::{Axis, JUDGED, Reading, told};
use crate::study::paper::runs::{Course, Example, seen};
use crate::study::paper::sentence::{Seen, Sentence, agrees};

/// How a statement of the paper fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as stated.
    Reproduced,
    /// It holds under this condition, which the paper does not state.
    OnlyIf(String),
    /// It hangs on the rule by which stiffnesses change, which the paper's reference 12 would tell: so it does otherwise.
    Undecidable(String),
    /// It does not hold here.
    NotReproduced,
    /// Nothing to judge it by.
    NotJudged,
}

impl Judgement {
    /// Reproduced or not.
    pub fn of(holds: bool) -> Self {
        if holds { Self::Reproduced } else { Self::NotReproduced }
    }

    /// The kind of judgement.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::OnlyIf(_) => "reproduced on a condition",
            Self::Undecidable(_) => "not decidable without [12]",
            Self::NotReproduced => "not reproduced",
            Self::NotJudged => "not judged",
        }
    }

    /// The judgement without what would decide it.
    pub fn brief(&self) -> String {
        match self {
            Self::OnlyIf(condition) => format!("only if: {condition}"),
            _ => self.word().into(),
        }
    }
}

impl fmt::Display for Judgement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OnlyIf(condition) => write!(f, "reproduced only if: {condition}"),
            Self::Undecidable(condition) => write!(f, "{}: it {condition}", self.word()),
            _ => f.write_str(self.word()),
        }
    }
}

/// A statement of the paper with what was measured.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What the paper says.
    pub text: &'static str,
    /// The one number that tells most.
    pub clause: String,
    /// What was measured.
    pub measured: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// How a judgement is made, for the page.
pub const RULE: &str = "What the paper says of iterations is judged under the reading nearest to its text, at three tolerances, and \
    beside it under every single departure that keeps the agreement with the exact solution. Where a statement holds at all three \
    tolerances and no other rule of stiffness flips it, it is reproduced; where another rule does, it is not decidable without [12], the paper's \
    reference on that rule, which is not at hand. Where it holds at some of the tolerances, or under a departure of another kind, it is \
    reproduced only if that is so; else it is not reproduced.";

/// What the paper's reference 12 would tell.
const RULES: [Axis; 2] = [Axis::Varying, Axis::Constant];

/// The sentences of the paper, judged over the courses of the designed set.
pub fn statements(courses: &[Course]) -> Vec<Statement> {
    let both = |reading: &Reading| Example::ALL.map(|example| seen(courses, reading, example));
    let nearest = both(&Reading::nearest());
    let agrees = |reading: &Reading| agrees(&both(reading));
    let judged = |sentence: Sentence| {
        statement(sentence, &nearest, &Fared::by(|reading| sentence.holds(&both(reading)), agrees))
    };
    Sentence::ALL.map(judged).into()
}

fn statement(sentence: Sentence, nearest: &[Seen; 2], fared: &Fared) -> Statement {
    let count = fared.held.iter().filter(|held| **held).count();
    let flips = |axis: &Axis| fared.flips.iter().any(|one| one.axes() == [*axis]);
    let axes: Vec<String> =
        Axis::ALL.iter().filter(|axis| flips(axis)).map(|axis| axis.title().to_lowercase()).collect();
    let flips = if axes.is_empty() { NONE.into() } else { format!("hangs on: {}", axes.join(", ")) };
    let numbers = sentence.numbers(nearest);
    Statement {
        text: sentence.name(),
        clause: format!("holds at {count} of {} tolerances; {flips}", fared.held.len()),
        measured: format!(
            "cylinder and pin–rod, reading nearest to the text: {numbers}; {}; {}",
            fared.at(),
            fared.told()
        ),
        judgement: fared.judgement(),
    }
}

/// A sentence over the designed set. Under a reading it holds where it does at each tolerance that the reading is judged at.
///
/// A departure counts only where every combination still agrees with the exact solution: the paper's do, so that a rule or a stop under which
/// they do not is not the paper's.
pub struct Fared {
    /// Whether it holds under the nearest reading, at each tolerance of [`JUDGED`].
    pub held: [bool; JUDGED.len()],
    /// Single departures under which it holds where it else does not, or fails where it else holds.
    pub flips: Vec<Reading>,
    /// Pairs that flip it where neither part does.
    pub together: Vec<Reading>,
    /// Pairs that do not where a part does.
    pub undone: Vec<Reading>,
}

/// What is said where none flips it.
pub const NONE: &str = "no departure that keeps the agreement flips it";

impl Fared {
    /// The agreement itself, of which every departure counts.
    pub fn agreement(courses: &[Course]) -> Self {
        Self::by(|reading| agrees(&Example::ALL.map(|example| seen(courses, reading, example))), |_| true)
    }

    /// A sentence of which it is known under which readings it holds, and which readings count.
    pub fn by(holds: impl Fn(&Reading) -> bool, counts: impl Fn(&Reading) -> bool) -> Self {
        let held = JUDGED.map(|tolerance| holds(&Reading::nearest().at(tolerance)));
        let own = held.iter().all(|held| *held);
        let counted = |mut of: Vec<Reading>| {
            of.retain(|reading| reading.judged().iter().all(&counts));
            of
        };
        let flips = |reading: &Reading| reading.judged().iter().all(&holds) != own;
        let mut singles = counted(Reading::departures());
        singles.retain(flips);
        let (mut undone, mut together): (Vec<Reading>, Vec<Reading>) = counted(Reading::pairs())
            .into_iter()
            .partition(|pair| pair.parts().iter().any(|part| singles.contains(part)));
        undone.retain(|pair| !flips(pair));
        together.retain(flips);
        Self { held, flips: singles, together, undone }
    }

    /// Whether it holds under the nearest reading.
    fn holds(&self) -> bool {
        self.held.iter().all(|held| *held)
    }

    /// What the departures that flip it make of it.
    fn otherwise(&self) -> &'static str {
        if self.holds() { "fails if" } else { "holds if" }
    }

    /// Whether it holds at each tolerance, in words.
    pub fn at(&self) -> String {
        let at = JUDGED.iter().zip(self.held);
        let at = at.map(|(tolerance, held)| format!("{} at {tolerance:.0e}", if held { "holds" } else { "fails" }));
        at.collect::<Vec<_>>().join(", ")
    }

    /// Which choices flip it, in words.
    pub fn told(&self) -> String {
        let otherwise = self.otherwise();
        let part = |begins: String, of: &[Reading]| (!of.is_empty()).then(|| format!("{begins} {}", told(of)));
        let parts = [
            part(otherwise.into(), &self.flips),
            part(format!("{otherwise} together"), &self.together),
            part("not so if".into(), &self.undone),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        if parts.is_empty() { NONE.into() } else { parts.join("; ") }
    }

    /// The judgement that follows.
    pub fn judgement(&self) -> Judgement {
        let is_rule = |one: &&Reading| one.axes().iter().all(|axis| RULES.contains(axis));
        let by_rule: Vec<&Reading> = self.flips.iter().filter(is_rule).collect();
        let at = JUDGED.iter().zip(self.held).filter(|(_, held)| *held).map(|(one, _)| format!("{one:.0e}"));
        let at: Vec<String> = at.collect();
        if at.len() < JUDGED.len() && !at.is_empty() {
            return Judgement::OnlyIf(format!("the tolerance is {}", at.join(" or ")));
        }
        match (self.holds(), self.flips.is_empty()) {
            _ if !by_rule.is_empty() => Judgement::Undecidable(format!("{} {}", self.otherwise(), told(by_rule))),
            (true, _) => Judgement::Reproduced,
            (false, true) => Judgement::NotReproduced,
            (false, false) => Judgement::OnlyIf(told(&self.flips)),
        }
    }
}
