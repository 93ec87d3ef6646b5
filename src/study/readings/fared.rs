//! How a sentence fares over the designed set: under the nearest reading, and which departures flip it.

use crate::study::readings::reading::{JUDGED, Reading, told};
use crate::study::readings::runs::{Course, Example, seen};
use crate::study::readings::sentence::Sentence;

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
    /// A sentence over the set; of the agreement itself every departure counts.
    pub fn of(sentence: Sentence, courses: &[Course]) -> Self {
        let holds = |sentence: Sentence, reading: &Reading| {
            sentence.holds(&Example::ALL.map(|example| seen(courses, reading, example)))
        };
        let counts = |reading: &Reading| sentence == Sentence::Agrees || holds(Sentence::Agrees, reading);
        Self::by(|reading| holds(sentence, reading), counts)
    }

    /// The same of a sentence of which it is known under which readings it holds, and which readings count.
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
    pub fn holds(&self) -> bool {
        self.held.iter().all(|held| *held)
    }

    /// What the departures that flip it make of it.
    pub fn otherwise(&self) -> &'static str {
        if self.holds() { "fails if" } else { "holds if" }
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
}
