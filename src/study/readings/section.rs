//! The map of readings in words and tables.

use crate::error::Error;
use crate::markdown::{significant, table};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::readings::axes::{Example, Rule, Stop};
use crate::study::readings::courses::Courses;
use crate::study::readings::map::{self, Judged, bit};
use crate::study::readings::reading::Reading;
use crate::study::readings::run::Numbers;
use crate::study::readings::sentence::{GOOD, STRONG, Sentence};
use crate::study::readings::trial::{ELEMENTS, Trial, starts};

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    Ok(findings.iter().map(|found| of(found.numbers)).collect())
}

fn of(numbers: &Numbers) -> String {
    let courses = Courses::of(&numbers.recorded);
    let all = map::all(&courses);
    let nearest = Judged::of(&courses, Reading::nearest());
    let most = all.iter().map(Judged::count).max().unwrap_or(0);
    let count = all.iter().filter(|judged| judged.count() == most).count();
    format!(
        "The paper leaves open by which rule stiffnesses change (its reference 12), what has one, when a run has converged, when it \
         is given up, how thick layers are and how far the candidates reach. Tried here: {} rules of varying and {} of constant \
         stiffness, {} criteria with tolerances, and every choice of the rest, {} readings in all, from {} starts each; the criteria are \
         those that can be had without the discrete solution: the contact conditions (penetration, tension, pressure across a gap), the \
         residuals (change of displacements, penetration, tension), the change of displacements alone, the contact state alone. A sentence holds \
         where it does in both examples, with the elements and algorithms that the paper shows. Agreement is a peak within {} % of the \
         discrete solution whenever a run ends, a strong dependence {STRONG} times as many iterations from one start as from another; \
         constant stiffness saves operations where it does from every start.\n\n{}\n\
         The reading nearest to the text ({}) fulfils {} of {} sentences. The most that any fulfils is {most}, and {count} do:\n\n{}\n\
         Together under none of the readings, though each part of them is under some:\n\n{}\n\
         Readings that fit the cylinder on the searched mesh best, the nearest of each rule, on other meshes of both examples: {} times the \
         elements, 4- and 8-node cells, {} starts. On how many of them each sentence holds:\n\n{}\n\
         {}{}",
        Rule::varying().len(),
        Rule::constant().len(),
        Stop::all().len(),
        all.len(),
        crate::study::readings::axes::starts().count(),
        100.0 * GOOD,
        by_sentence(&all, &nearest),
        Reading::nearest().name(),
        nearest.count(),
        Sentence::ALL.len(),
        best(&all),
        contradictions(&all),
        ELEMENTS.map(|times| times.to_string()).join(", "),
        starts().len(),
        trials(&numbers.trials),
        picture("readings.svg", "Sentences that hold by readings"),
        picture(
            "figure-11.svg",
            "Fig. 11 with its four curves: the reading nearest to the text, and those of the most sentences that are next to it; hollow: \
             given up",
        ),
    )
}

/// A share of all.
fn share(all: &[Judged], holds: impl Fn(&Judged) -> bool) -> String {
    match all.iter().filter(|judged| holds(judged)).count() {
        0 => "none".into(),
        number => format!("{} %", significant(100.0 * number as f64 / all.len() as f64, 2)),
    }
}

/// Where each sentence holds.
fn by_sentence(all: &[Judged], nearest: &Judged) -> String {
    let head = [
        "sentence",
        "nearest reading",
        "of all readings",
        "all nine formulations",
        Example::Cylinder.name(),
        Example::PinRod.name(),
    ];
    let row = |sentence: Sentence| {
        let share = |of: &dyn Fn(&Judged) -> u16| share(all, |judged| of(judged) & bit(sentence) != 0);
        let own = if nearest.holds(sentence) { "holds" } else { "does not" };
        vec![
            sentence.name().to_string(),
            own.into(),
            share(&|judged| judged.both),
            share(&|judged| judged.nine),
            share(&|judged| judged.single[0]),
            share(&|judged| judged.single[1]),
        ]
    };
    table(&head.map(String::from), &Sentence::ALL.map(row))
}

/// The readings under which most hold: of each rule of varying stiffness the nearest to the text.
fn best(all: &[Judged]) -> String {
    let row = |judged: &&Judged| vec![judged.reading.name(), missing(judged.both)];
    table(&["reading", "what does not hold"].map(String::from), &map::best(all).iter().map(row).collect::<Vec<_>>())
}

/// Sentences that are not among some bits.
fn missing(bits: u16) -> String {
    let names = Sentence::ALL.into_iter().filter(|&sentence| bits & bit(sentence) == 0).map(Sentence::name);
    names.collect::<Vec<_>>().join("; ")
}

/// The smallest sets of sentences that exclude one another.
fn contradictions(all: &[Judged]) -> String {
    let mut sets = map::contradictions(all);
    let least = sets.iter().map(Vec::len).min().unwrap_or(0);
    sets.retain(|set| set.len() == least);
    sets.iter().map(|set| format!("* {}\n", set.iter().map(|one| one.name()).collect::<Vec<_>>().join(" · "))).collect()
}

/// The chosen readings on other meshes.
fn trials(trials: &[Trial]) -> String {
    let numbered = || trials.iter().enumerate().map(|(k, trial)| (k + 1, trial));
    let names: String = numbered().map(|(k, trial)| format!("{k}. {}\n", trial.reading.name())).collect();
    let head = std::iter::once("sentence".to_string()).chain(numbered().map(|(k, _)| k.to_string()));
    let row = |(k, sentence): (usize, &Sentence)| {
        let held = trials.iter().map(|trial| format!("{} of {}", trial.holds[k], trial.of));
        std::iter::once(sentence.name().to_string()).chain(held).collect()
    };
    let rows: Vec<Vec<String>> = Sentence::ALL.iter().enumerate().map(row).collect();
    names + "\n" + &table(&head.collect::<Vec<_>>(), &rows)
}
