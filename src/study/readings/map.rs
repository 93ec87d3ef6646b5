//! Sentences by readings: which hold under which, and which never together.

use std::collections::HashSet;

use rayon::prelude::*;

use crate::study::readings::axes::Example;
use crate::study::readings::course::pairs;
use crate::study::readings::courses::Courses;
use crate::study::readings::reading::Reading;
use crate::study::readings::sentence::{Seen, Sentence};

/// What holds under a reading: a bit a sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The reading.
    pub reading: Reading,
    /// In both examples, with the paper's five combinations.
    pub both: u16,
    /// In the cylinder alone, and in the pin–rod alone.
    pub single: [u16; 2],
    /// In both examples, with all nine formulations.
    pub nine: u16,
}

impl Judged {
    /// A reading judged.
    pub fn of(courses: &Courses, reading: Reading) -> Self {
        let ends = |example| pairs().map(move |(a, e)| (e, a, courses.ends(&reading, example, e, a))).collect();
        let five = Example::ALL.map(|example| Seen::five(ends(example)));
        let all = Example::ALL.map(|example| Seen::nine(ends(example)));
        Self {
            reading,
            both: bits(|sentence| sentence.holds(&five)),
            single: [0, 1].map(|k| bits(|sentence| sentence.holds_in(&five[k]))),
            nine: bits(|sentence| sentence.holds(&all)),
        }
    }

    /// Whether a sentence holds in both examples.
    pub fn holds(&self, sentence: Sentence) -> bool {
        self.both & bit(sentence) != 0
    }

    /// How many do.
    pub fn count(&self) -> u32 {
        self.both.count_ones()
    }
}

/// All readings judged.
pub fn all(courses: &Courses) -> Vec<Judged> {
    Reading::all().into_par_iter().map(|reading| Judged::of(courses, reading)).collect()
}

/// The readings under which most sentences hold: of each rule of varying stiffness the nearest to the text, the nearest first.
pub fn best(all: &[Judged]) -> Vec<&Judged> {
    let (nearest, most) = (Reading::nearest(), all.iter().map(Judged::count).max().unwrap_or(0));
    let far = |judged: &Judged| nearest.differences(&judged.reading).len();
    let mut chosen: Vec<&Judged> = Vec::new();
    for judged in all.iter().filter(|judged| judged.count() == most) {
        match chosen.iter_mut().find(|kept| kept.reading.varying == judged.reading.varying) {
            Some(kept) if far(judged) < far(kept) => *kept = judged,
            Some(_) => {}
            None => chosen.push(judged),
        }
    }
    chosen.sort_by_key(|judged| far(judged));
    chosen
}

/// The smallest sets of sentences that no reading fulfils together, though it does any part of them: a set of one holds under
/// none.
pub fn contradictions(all: &[Judged]) -> Vec<Vec<Sentence>> {
    let every: HashSet<u16> = all.iter().map(|judged| judged.both).collect();
    let ever = |wanted: u16| every.iter().any(|found| found & wanted == wanted);
    let mut never: Vec<u16> = (1..1 << Sentence::ALL.len()).filter(|&wanted| !ever(wanted)).collect();
    never.sort_by_key(|wanted| wanted.count_ones());
    let mut least: Vec<u16> = Vec::new();
    for wanted in never {
        if !least.iter().any(|smaller| wanted & smaller == *smaller) {
            least.push(wanted);
        }
    }
    least.into_iter().map(sentences).collect()
}

/// The sentences of some bits.
pub fn sentences(bits: u16) -> Vec<Sentence> {
    Sentence::ALL.into_iter().filter(|&sentence| bits & bit(sentence) != 0).collect()
}

/// The bits of the sentences that hold.
pub fn bits(holds: impl Fn(Sentence) -> bool) -> u16 {
    Sentence::ALL.into_iter().filter(|&sentence| holds(sentence)).map(bit).fold(0, |all, one| all | one)
}

/// The bit of a sentence.
pub fn bit(sentence: Sentence) -> u16 {
    1 << sentence as u16
}
