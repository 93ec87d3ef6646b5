//! The paper's statements: each judgement follows its numbers, and a counter-example turns it.

use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::Verdict;
use contact_vv::report::statements::readings::judgement;
use contact_vv::report::statements::{self, Judgement};
use contact_vv::solve::{Element, Iteration};
use contact_vv::study::readings::axes::{Candidates, Rule};
use contact_vv::study::readings::course::Record;
use contact_vv::study::readings::map::{self, Judged};
use contact_vv::study::readings::reading::{End, Reading};
use contact_vv::study::readings::sentence::{Seen, Sentence};
use contact_vv::study::readings::{self, judge};
use contact_vv::study::{Finding, Numbers, Room, records};

/// An end after so many iterations with 10 dofs retained; none is a start that never ends.
fn end(iterations: Option<usize>) -> End {
    End { stiffness: 1.0, iterations, error: 0.01, retained: 10 }
}

/// Ends of the paper's combinations under which every sentence holds.
fn fitting(element: Element, algorithm: Iteration) -> Vec<End> {
    let ends = match (element, algorithm) {
        (Element::Line, Iteration::Varying) => [Some(10), Some(20), Some(30), Some(30)],
        (_, Iteration::Varying) => [Some(10), Some(20), Some(30), None],
        (Element::Line, Iteration::Constant) => [Some(15), Some(45), None, None],
        (_, Iteration::Constant) => [None, Some(15), Some(45), None],
        (_, Iteration::Kinematic) => [Some(2); 4],
    };
    ends.map(end).to_vec()
}

/// Both examples, the second spoiled.
fn spoiled(spoil: impl Fn(Element, Iteration, &mut [End])) -> [Seen; 2] {
    [false, true].map(|is_second| {
        let pairs = Element::ALL.into_iter().flat_map(|element| Iteration::ALL.map(|algorithm| (element, algorithm)));
        let of = pairs.map(|(element, algorithm)| {
            let mut ends = fitting(element, algorithm);
            if is_second {
                spoil(element, algorithm, &mut ends);
            }
            (element, algorithm, ends)
        });
        Seen::five(of.collect())
    })
}

#[test]
fn every_sentence_holds_under_runs_made_for_it_and_fails_where_they_are_spoiled_in_one_example() {
    let sound = spoiled(|_, _, _| {});
    for sentence in Sentence::ALL {
        assert!(sentence.holds(&sound), "{}", sentence.name());
        let seen = spoiled(|element, algorithm, ends| {
            let all = |ends: &mut [End], iterations| ends.iter_mut().for_each(|one| one.iterations = iterations);
            match (sentence, element, algorithm) {
                (Sentence::Agrees, Element::Layer, Iteration::Constant) => ends[1].error = 0.051,
                (Sentence::VaryingDepends, Element::Line, Iteration::Varying) => ends[0].iterations = Some(11),
                (Sentence::ConstantDepends, Element::Line, Iteration::Constant) => ends[0].iterations = Some(16),
                (Sentence::Fails, _, Iteration::Varying | Iteration::Constant) => all(ends, Some(10)),
                (Sentence::MoreStable, Element::Layer, Iteration::Constant) => ends[0].iterations = Some(50),
                (Sentence::LineAlways, Element::Line, Iteration::Varying) => ends[2].iterations = None,
                (Sentence::Proviso, Element::Layer, Iteration::Varying) => ends[3].iterations = Some(40),
                (Sentence::TwoSteps, Element::Node, Iteration::Kinematic) => ends[1].iterations = Some(3),
                (Sentence::Fewest, Element::Node, Iteration::Kinematic) => ends[1].iterations = Some(10),
                (Sentence::LeastWork, Element::Node, Iteration::Kinematic) => ends[0].iterations = Some(7),
                (Sentence::Saves, Element::Line, Iteration::Constant) => ends[0].iterations = Some(26),
                (Sentence::Alike, Element::Layer, Iteration::Varying) => all(&mut ends[..2], None),
                _ => {}
            }
        });
        assert!(!sentence.holds(&seen), "{}", sentence.name());
    }
    // Of runs that are not there nothing holds.
    let none = [0, 1].map(|_| Seen::five(vec![(Element::Line, Iteration::Varying, vec![])]));
    assert!(Sentence::ALL.into_iter().all(|sentence| !sentence.holds(&none)));
}

#[test]
fn judgement_names_what_would_have_to_be_so() {
    let nearest = Reading::nearest();
    let holding = |reading| Judged { reading, both: map::bit(Sentence::TwoSteps), single: [0; 2], nine: 0 };
    let failing = Judged { both: 0, ..holding(nearest) };
    let judged = |held: [bool; 3], all: &[Judged]| judgement(Sentence::TwoSteps, &nearest, &held, all);
    let none = [false; 3];
    assert_eq!(judged([true; 3], &[failing]), Judgement::Reproduced);
    assert_eq!(judged([false, true, false], &[failing]), Judgement::OnlyIf("the tolerance is 1e-3".into()));
    assert_eq!(judged(none, &[failing]), Judgement::NotReproduced);
    let at_edge = Reading { candidates: Candidates::AtEdge, ..nearest };
    let condition = "candidates that end where the contact does".to_string();
    assert_eq!(judged(none, &[failing, holding(at_edge)]), Judgement::OnlyIf(condition.clone()));
    // What differs in more is no nearer; of what differs in as much all is told.
    let both = Reading { cap: 50, ..at_edge };
    assert_eq!(judged(none, &[holding(both), holding(at_edge)]), Judgement::OnlyIf(condition.clone()));
    let capped = Reading { cap: 50, ..nearest };
    let either = format!("given up after 50 iterations; or {condition}");
    assert_eq!(judged(none, &[holding(capped), holding(at_edge)]), Judgement::OnlyIf(either));
    // Another rule alone is what the paper's reference 12 would tell.
    let rule = Rule { rule: StiffnessRule::Step, ..nearest.varying };
    let stepping = Reading { varying: rule, ..nearest };
    let told = Judgement::Undecidable("varying stiffness by step, bound 100".into());
    assert_eq!(judged(none, &[holding(at_edge), holding(stepping)]), told);
}

/// The record as it is committed.
fn recorded() -> Vec<Record> {
    records::read(&records::file(readings::NAME), "").expect("a record")
}

fn judged(recorded: Vec<Record>, begins: &str) -> Judgement {
    let numbers = Numbers::Readings(readings::Numbers { recorded, fresh: vec![], trials: vec![] });
    let finding = Finding { room: Room::Readings, case: "r".into(), name: "r".into(), numbers, judged: vec![] };
    let mut all = statements::judge(&[finding]).into_iter();
    all.find(|statement| statement.text.starts_with(begins)).expect(begins).judgement
}

#[test]
fn one_start_of_the_record_that_never_ends_turns_the_sentence_on_every_case() {
    let begins = "With varying stiffness and line elements";
    assert_eq!(judged(recorded(), begins), Judgement::Reproduced);
    let (Rule { rule, bound, spring, .. }, candidates) = (Reading::nearest().varying, Candidates::Wide);
    let mut one_lost = recorded();
    let is_own = |record: &&mut Record| {
        (record.rule, record.bound.to_bits(), record.spring) == (rule, bound.to_bits(), spring)
            && (record.element, record.candidates) == (Element::Line, candidates)
    };
    let lost = one_lost.iter_mut().find(is_own).expect("a start of line elements");
    lost.iterations = lost.iterations.split(' ').map(|_| "-").collect::<Vec<_>>().join(" ");
    assert_ne!(judged(one_lost, begins), Judgement::Reproduced);
}

#[test]
fn record_of_readings_is_complete_and_one_start_less_or_another_count_is_seen() {
    let all = recorded();
    assert!(judge::complete(&all).verdict == Verdict::Pass);
    assert!(judge::complete(&all[1..]).verdict != Verdict::Pass);
    let few: Vec<Record> = all[..19].to_vec();
    assert!(judge::as_recorded(&all, &few).verdict == Verdict::Pass);
    assert!(judge::as_recorded(&all, &[]).verdict != Verdict::Pass);
    let mut moved = few.clone();
    moved[3].iterations = moved[3].iterations.replace(' ', "0 ");
    assert!(judge::as_recorded(&all, &moved).verdict != Verdict::Pass);
    let mut fewer = few;
    fewer[3].iterations = fewer[3].iterations.rsplit_once(' ').expect("several").0.to_string();
    assert!(judge::as_recorded(&all, &fewer).verdict != Verdict::Pass);
}

#[test]
fn contradictions_are_the_smallest_sets_that_never_hold_together() {
    let [a, b, c] = [Sentence::Fails, Sentence::LineAlways, Sentence::Proviso];
    let judged = |sentences: &[Sentence]| Judged {
        reading: Reading::nearest(),
        both: sentences.iter().map(|&one| map::bit(one)).sum(),
        single: [0; 2],
        nine: 0,
    };
    let others: Vec<Sentence> = Sentence::ALL.into_iter().filter(|one| ![a, b, c].contains(one)).collect();
    let with = |some: &[Sentence]| judged(&[others.clone(), some.to_vec()].concat());
    assert_eq!(map::contradictions(&[with(&[a, b]), with(&[b, c]), with(&[a, c])]), [vec![a, b, c]]);
    assert_eq!(map::contradictions(&[with(&[a, b]), with(&[c])]), [vec![a, c], vec![b, c]]);
    assert_eq!(map::contradictions(&[with(&[a, b])]), [vec![c]]);
    assert!(map::contradictions(&[with(&[a, b, c])]).is_empty());
}
