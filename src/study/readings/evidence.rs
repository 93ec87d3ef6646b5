//! What a sentence rests on: the numbers of both examples under one reading.

use crate::measure::larger;
use crate::solve::{Element, Iteration};
use crate::study::readings::reading::{End, ended, error, extremes};
use crate::study::readings::sentence::{Seen, Sentence};

/// The numbers of both examples, the first before the second.
pub fn of(sentence: Sentence, seen: &[Seen; 2]) -> String {
    use Iteration::{Constant, Kinematic, Varying};
    let both = |text: &dyn Fn(&Seen) -> String| seen.each_ref().map(text).join(" and ");
    match sentence {
        Sentence::Agrees => {
            let worst = |seen: &Seen| seen.all().map(|(_, _, ends)| error(ends)).fold(0.0, larger);
            format!("peak of what ended off by up to {}", both(&|seen| format!("{:.1} %", 100.0 * worst(seen))))
        }
        Sentence::VaryingDepends => format!("most over fewest iterations {}", both(&|seen| ratios(seen, Varying))),
        Sentence::ConstantDepends => format!("most over fewest iterations {}", both(&|seen| ratios(seen, Constant))),
        Sentence::Fails | Sentence::MoreStable | Sentence::Alike => {
            let of = |algorithm: Iteration| format!("{} {}", algorithm.name(), both(&|seen| counts(seen, algorithm)));
            format!("starts that ended: {}; {}", of(Varying), of(Constant))
        }
        Sentence::LineAlways => {
            format!("starts that ended: {}", both(&|seen| count(seen.starts(Element::Line, Varying))))
        }
        Sentence::Proviso => {
            format!("starts that ended: {}", both(&|seen| count(seen.starts(Element::Layer, Varying))))
        }
        Sentence::TwoSteps => {
            let own = |seen: &Seen| range(&[seen.starts(Element::Node, Kinematic)]);
            format!("{} iterations", both(&own))
        }
        Sentence::Fewest => {
            let others = |seen: &Seen| {
                let own: Vec<&[End]> = seen.by(Varying).chain(seen.by(Constant)).map(|(_, ends)| ends).collect();
                range(&own)
            };
            let own = both(&|seen| range(&[seen.starts(Element::Node, Kinematic)]));
            format!("{own} iterations, the others {}", both(&others))
        }
        Sentence::Saves | Sentence::LeastWork => {
            let quotients = |seen: &Seen| {
                let pairs = if sentence == Sentence::Saves { seen.of_constant() } else { seen.of_kinematic() };
                let quotients: Vec<f64> = pairs.into_iter().map(|[other, own]| other / own).collect();
                let [low, high] = [
                    quotients.iter().copied().fold(f64::INFINITY, f64::min),
                    quotients.iter().copied().fold(0.0, larger),
                ];
                format!("{low:.2} to {high:.0}")
            };
            let whose =
                if sentence == Sentence::Saves { "varying's over constant's" } else { "the others' over kinematic's" };
            format!("operations, {whose}: {}", both(&quotients))
        }
    }
}

/// Most over fewest iterations with each element.
fn ratios(seen: &Seen, algorithm: Iteration) -> String {
    let ratio = |(element, ends): (Element, &[End])| match extremes(ends) {
        Some([low, high]) => format!("{:.1} ({})", high as f64 / low as f64, element.name()),
        None => format!("– ({})", element.name()),
    };
    seen.by(algorithm).map(ratio).collect::<Vec<_>>().join(", ")
}

/// `15 of 19 (line), …`.
fn counts(seen: &Seen, algorithm: Iteration) -> String {
    let own = seen.by(algorithm).map(|(element, ends)| format!("{} ({})", count(ends), element.name()));
    own.collect::<Vec<_>>().join(", ")
}

fn count(ends: &[End]) -> String {
    format!("{} of {}", ended(ends), ends.len())
}

/// Fewest and most iterations of several.
fn range(all: &[&[End]]) -> String {
    let own: Vec<[usize; 2]> = all.iter().filter_map(|ends| extremes(ends)).collect();
    match (own.iter().map(|one| one[0]).min(), own.iter().map(|one| one[1]).max()) {
        (Some(low), Some(high)) if low < high => format!("{low} to {high}"),
        (Some(low), _) => low.to_string(),
        _ => "no".into(),
    }
}
