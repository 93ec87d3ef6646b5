//! The paper's statements: each judgement follows its numbers, and a counter-example turns it.

use std::sync::LazyLock;

use contact_vv::algorithm::{Criterion, StiffnessRule};
use contact_vv::case::library::{cylinder, pin_rod};
use contact_vv::case::{self, Check, Reference, Verdict};
use contact_vv::checkout::root;
use contact_vv::measure::Quantity;
use contact_vv::oracle::ReferenceKind;
use contact_vv::report::{record, statements};
use contact_vv::solve::{Element, Iteration};
use contact_vv::study::measured::{self, GAERTNER};
use contact_vv::study::paper::reading::{Axis, Candidates, Reading, Stop};
use contact_vv::study::paper::sentence::{GOOD, Met, Seen, Sentence, Starts, agrees};
use contact_vv::study::paper::statement::{self, Course, Example, courses, later as later_of, shown};
use contact_vv::study::paper::statement::{Fared, Judgement};
use contact_vv::study::{Finding, Study, cases};

use crate::workbench;

/// An end after so many iterations.
fn end(iterations: usize) -> Option<Met> {
    Some(Met { iterations, error: 0.01 })
}

/// Ends of the paper's combinations under which every sentence holds.
fn fitting(element: Element, algorithm: Iteration) -> Vec<Option<Met>> {
    let ends = match (element, algorithm) {
        (Element::Line, Iteration::Varying) => [Some(10), Some(20), Some(30), Some(30), Some(30)],
        (_, Iteration::Varying) => [Some(10), Some(20), Some(30), Some(30), None],
        (Element::Line, Iteration::Constant) => [Some(15), Some(45), None, None, None],
        (_, Iteration::Constant) => [None, Some(15), Some(45), None, None],
        (_, Iteration::Kinematic) => [Some(2); 5],
    };
    ends.map(|iterations| iterations.and_then(end)).to_vec()
}

/// Both examples, the second spoiled.
fn spoiled(spoil: impl Fn(Element, Iteration, &mut [Option<Met>])) -> [Seen; 2] {
    [false, true].map(|is_second| {
        let of = shown().map(|(element, algorithm)| {
            let mut met = fitting(element, algorithm);
            if is_second {
                spoil(element, algorithm, &mut met);
            }
            Starts { element, algorithm, retained: 10, met }
        });
        Seen { of: of.collect() }
    })
}

#[test]
fn every_sentence_holds_under_runs_made_for_it_and_fails_where_they_are_spoiled_in_one_example() {
    let sound = spoiled(|_, _, _| {});
    assert!(agrees(&sound));
    let off = spoiled(|element, algorithm, ends| {
        if (element, algorithm) == (Element::Layer, Iteration::Constant) {
            ends[1] = Some(Met { iterations: 15, error: 0.051 });
        }
    });
    assert!(!agrees(&off));
    for sentence in Sentence::ALL {
        assert!(sentence.holds(&sound), "{}", sentence.name());
        let seen = spoiled(|element, algorithm, ends| match (sentence, element, algorithm) {
            (Sentence::Agrees, Element::Layer, Iteration::Constant) => {
                ends[1] = Some(Met { iterations: 15, error: 0.051 })
            }
            (Sentence::NoDifference, Element::Layer, Iteration::Constant) => {
                ends[1] = Some(Met { iterations: 15, error: 0.011 })
            }
            (Sentence::VaryingDepends, Element::Line, Iteration::Varying) => ends[0] = end(11),
            (Sentence::ConstantDepends, Element::Line, Iteration::Constant) => ends[0] = end(16),
            (Sentence::Fails, _, Iteration::Varying | Iteration::Constant) => ends.fill(end(10)),
            (Sentence::MoreStable, Element::Layer, Iteration::Constant) => ends[0] = end(50),
            (Sentence::LineAlways, Element::Line, Iteration::Varying) => ends[2] = None,
            (Sentence::Proviso, Element::Layer, Iteration::Varying) => ends[4] = end(40),
            (Sentence::KinematicAlways, Element::Node, Iteration::Kinematic) => ends[2] = None,
            (Sentence::TwoSteps, Element::Node, Iteration::Kinematic) => ends[1] = end(3),
            (Sentence::Fewest, Element::Node, Iteration::Kinematic) => ends[1] = end(15),
            (Sentence::LeastWork, Element::Node, Iteration::Kinematic) => ends[0] = end(7),
            (Sentence::Saves, _, Iteration::Constant) => ends.fill(end(45)),
            (Sentence::Alike, Element::Layer, Iteration::Varying) => ends[..2].fill(None),
            _ => {}
        });
        assert!(!sentence.holds(&seen), "{}", sentence.name());
    }
    // By hand: kinematic load ends from every start, the others from 5 and 2 with line and 4 and 2 with layer elements;
    // of 10 retained dofs an iteration of varying stiffness takes 1000/3 + 200 operations, one of constant stiffness
    // 200 and all of them 1000/3 more, which is a third only of 20 and 15 iterations: 10,667 over 3,333.
    assert_eq!(Sentence::Fewest.starts(&sound).as_deref(), Some("so from 13 of 13 and 13 of 13 starts where both end"));
    assert_eq!(Sentence::Saves.starts(&sound).as_deref(), Some("so from 1 of 4 and 1 of 4 starts where both end"));
    let late = spoiled(|_, algorithm, ends| {
        if algorithm == Iteration::Kinematic {
            ends[1] = end(15)
        }
    });
    assert_eq!(Sentence::Fewest.starts(&late).as_deref(), Some("so from 13 of 13 and 12 of 13 starts where both end"));
    assert_eq!(Sentence::Alike.starts(&sound), None);
    // Of runs that are not there nothing holds.
    let starts = || Starts { element: Element::Line, algorithm: Iteration::Varying, retained: 10, met: vec![] };
    let none = [0, 1].map(|_| Seen { of: vec![starts()] });
    assert!(!agrees(&none) && Sentence::ALL.into_iter().all(|sentence| !sentence.holds(&none)));
}

#[test]
fn designed_set_is_small_and_departs_from_the_nearest_reading_by_one_choice_or_by_two() {
    let [set, departures, pairs] = [Reading::designed(), Reading::departures(), Reading::pairs()];
    assert!(set.len() <= 200, "{}", set.len());
    assert!(Reading::nearest().axes().is_empty() && set[0].stop.criterion == Criterion::Conditions);
    for reading in &departures {
        assert!(reading.axes().len() == 1 && reading.parts() == [*reading], "{}", reading.name());
    }
    for axis in Axis::ALL {
        assert!(departures.iter().any(|reading| reading.axes() == [axis]), "{axis:?}");
    }
    for pair in &pairs {
        let parts = pair.parts();
        assert!(parts.len() == 2 && parts.iter().all(|part| departures.contains(part)), "{}", pair.name());
    }
    for reading in departures.iter().chain(&pairs).flat_map(Reading::judged) {
        assert!(set.contains(&reading), "{}", reading.name());
    }
}

/// How a sentence fares that holds under some readings, where all count.
fn fared(holds: impl Fn(&Reading) -> bool) -> Fared {
    Fared::by(holds, |_| true)
}

#[test]
fn judgement_names_what_would_have_to_be_so() {
    let judged = |holds: &dyn Fn(&Reading) -> bool| fared(holds).judgement(Sentence::LineAlways);
    assert_eq!(judged(&|_| true), Judgement::Reproduced);
    assert_eq!(judged(&|_| false), Judgement::NotReproduced);
    let exact = |one: &Reading| one.stop.tolerance <= 1e-3;
    assert_eq!(judged(&exact), Judgement::OnlyIf("the tolerance is 1e-3 or 1e-4".into()));
    let at_edge = |one: &Reading| one.candidates == Candidates::AtEdge;
    assert_eq!(judged(&|one| !at_edge(one)), Judgement::Reproduced);
    // A counter-example at every tolerance: what would flip it, another rule too, is told beside it.
    let by_doubling = |one: &Reading| one.varying.rule == StiffnessRule::Doubling;
    assert_eq!(judged(&at_edge), Judgement::NotReproduced);
    assert_eq!(judged(&by_doubling), Judgement::NotReproduced);
    // Another rule alone is what the paper's reference 12 would tell, but where the nearest reading decides start by
    // start.
    let told = "fails if varying stiffness changes by doubling".to_string();
    assert_eq!(judged(&|one| !by_doubling(one)), Judgement::Undecidable(told));
    for sentence in [Sentence::Saves, Sentence::Fewest] {
        assert_eq!(fared(|one| !by_doubling(one)).judgement(sentence), Judgement::Reproduced);
        assert_eq!(fared(by_doubling).judgement(sentence), Judgement::NotReproduced);
    }
    // But not a rule under which nothing agrees.
    let agreed = Fared::by(|one| !by_doubling(one), |one| !by_doubling(one));
    assert_eq!(agreed.judgement(Sentence::LineAlways), Judgement::Reproduced);
}

#[test]
fn departures_that_flip_a_sentence_are_told_and_pairs_that_go_another_way_than_their_parts() {
    let begin = format!("of {} departures counted: ", Reading::departures().len());
    let told = |holds: &dyn Fn(&Reading) -> bool| fared(holds).told().trim_start_matches(&begin).to_owned();
    let [edge, state] = ["candidates end where the contact does", "runs stop by contact state"];
    let is_edge = |one: &Reading| one.candidates == Candidates::AtEdge;
    let is_state = |one: &Reading| one.stop.criterion == Criterion::State;
    assert_eq!(fared(|_| true).told(), begin.clone() + "none flips it");
    assert_eq!(Fared::by(|_| true, |one| !is_edge(one)).counted, Reading::departures().len() - 1);
    assert_eq!(told(&|one| is_edge(one)), format!("holds if {edge}"));
    assert_eq!(told(&|one| !is_edge(one)), format!("fails if {edge}"));
    assert_eq!(told(&|one| is_edge(one) && is_state(one)), format!("holds if together {edge} and {state}"));
    let but = format!("holds if {edge}; not so if {edge} and {state}");
    assert_eq!(told(&|one| is_edge(one) && !is_state(one)), but);
}

/// Courses of the nearest reading alone, by every stop.
static NEAREST: LazyLock<Vec<Course>> = LazyLock::new(|| {
    let by = |stop| Reading { stop, ..Reading::nearest() };
    courses(&Stop::all().into_iter().map(by).collect::<Vec<_>>()).expect("runs")
});

fn judged(courses: Vec<Course>, sentence: Sentence) -> Judgement {
    let finding = Finding::of("r", "r", courses).expect("judged");
    let mut all = statements::judge(&[finding]).into_iter();
    all.find(|statement| statement.text == sentence.name()).expect("a statement").judgement
}

#[test]
fn what_the_cap_ends_beside_what_it_does_not_is_told_with_when_it_ends_later() {
    let later: Vec<_> = NEAREST.iter().flat_map(|course| &course.later).collect();
    assert!(!later.is_empty());
    for (stiffness, met) in later {
        let met = met.expect("it ends");
        assert!(met.iterations > Reading::nearest().cap && met.error <= GOOD, "κ₀ = {stiffness:e}: {met:?}");
    }
    let without = |spoil: fn(&mut Course)| {
        let mut all = NEAREST.clone();
        all.iter_mut().for_each(spoil);
        later_of(&all)
    };
    let never = workbench::spoiled(&*NEAREST, |all| {
        all.iter_mut().for_each(|one| one.later.iter_mut().for_each(|one| one.1 = None))
    });
    let told = |courses: &[Course]| {
        let all = statement::statements(courses).into_iter();
        all.map(|one| one.measured).filter(|one| one.contains(" times as large")).collect::<String>()
    };
    assert!(told(&NEAREST).contains("Of 8 starts") && told(&NEAREST).contains(", 8 end by one"), "{}", told(&NEAREST));
    assert!(told(&never).ends_with(", 0 end by one 10 times as large"), "{}", told(&never));
    assert!(without(|_| ()).contains("iterations from κ₀ = 1e-3 and after"), "{}", without(|_| ()));
    assert!(!without(|course| course.later.retain(|one| one.0 > 1.0)).contains("1e-3"));
    assert!(without(|course| course.later.iter_mut().for_each(|one| one.1 = None)).contains(" not from κ₀ = 1e-3"));
}

#[test]
fn one_start_that_never_ends_turns_the_sentence_on_every_case() {
    assert_eq!(judged(NEAREST.clone(), Sentence::LineAlways), Judgement::Reproduced);
    let is_line = |course: &&mut Course| course.site.element == Element::Line;
    let lost = |all: &mut Vec<Course>| all.iter_mut().find(is_line).expect("line elements").met[3].fill(None);
    assert_ne!(judged(workbench::spoiled(&NEAREST, lost), Sentence::LineAlways), Judgement::Reproduced);
}

/// A passed run of a case, of which nothing is told but errors of the kind that statements ask.
fn off(case: &str, by: [(case::Quantity, f64); 2]) -> Finding {
    let judge = |(quantity, error)| {
        Check::near(quantity, Reference::analytic("Hertz", 100.0), 0.1, "a reason").judge(100.0 + error)
    };
    let bars = cases::Numbers::plan()
        .into_iter()
        .find(|trial| trial.case == "bars, u/g = 3")
        .expect("bars are in the library");
    let mut finding = Finding::of(case, "one", bars.run().expect("solved")).expect("judged");
    finding.judged = by.map(judge).into();
    finding
}

#[test]
fn what_is_off_of_hertz_is_told_in_per_cent() {
    let paper = Finding::of("r", "r", NEAREST.clone()).expect("judged");
    // Of a hundred, so that the number is the share in per cent.
    let cylinder =
        off(cylinder::NINE, [(Quantity::PeakPressure.into(), 0.25), (Quantity::SecondMomentWidth.into(), -0.5)]);
    let rod = off(pin_rod::NINE, [(Quantity::PeakPressure.into(), 1.25), (case::Quantity::EdgeMeans, 1.75)]);
    let all = statements::judge(&[paper, cylinder, rod]);
    let agrees = all.iter().find(|one| one.text == Sentence::Agrees.name()).expect("a statement");
    let told = "p₀ within 0.25 % of Hertz, a within 0.50 %, pin–rod peak within 1.25 %, edge means within 1.75 %";
    assert!(agrees.measured.ends_with(told), "{}", agrees.measured);
}

#[test]
fn curve_of_gaertner_that_fails_is_not_reproduced() {
    let curve = |ratio: f64| {
        let numbers =
            measured::Numbers::Curves(vec![measured::check("a", "a", ReferenceKind::Measured, None).judge(ratio)]);
        let all = statements::judge(&[Finding::of(GAERTNER, "digitised curves", numbers).expect("judged")]);
        all.last().expect("a statement").judgement.clone()
    };
    assert_eq!([1.9, 2.1].map(curve), [Judgement::Reproduced, Judgement::NotReproduced]);
}

#[test]
fn what_was_measured_is_told_in_sentences_of_at_most_45_words() {
    let text = std::fs::read_to_string(root().join(record::STATEMENTS)).expect("a record");
    let rows = record::parsed::<[String; 3]>(&text).expect("rows");
    assert!(rows.len() > 10);
    for sentence in rows.iter().flat_map(|[.., measured]| measured.split(". ")) {
        assert!(sentence.split_whitespace().count() <= 45, "{sentence}");
    }
}

#[test]
fn a_run_has_ended_by_a_cap_of_as_many_iterations_and_not_of_one_less() {
    let nearest = Reading::nearest();
    let ends = |cap: usize| -> Vec<Option<Met>> {
        let seen = statement::seen(&NEAREST, &Reading { cap, ..nearest }, Example::Cylinder);
        seen.of.into_iter().flat_map(|starts| starts.met).collect()
    };
    let all = ends(nearest.cap);
    let (at, met) = all.iter().enumerate().find_map(|(k, met)| Some((k, (*met)?))).expect("one that ends");
    assert_eq!(ends(met.iterations)[at], Some(met));
    assert_eq!(ends(met.iterations - 1)[at], None);
}

#[test]
fn condensation_pays_by_the_factorisations_of_sparse_matrices_that_it_spares() {
    let finding =
        off(cylinder::NINE, [(Quantity::PeakPressure.into(), 0.0), (Quantity::SecondMomentWidth.into(), 0.0)]);
    let run = &finding.numbers::<cases::Numbers>().expect("a run").run;
    assert_ne!(run.formulation.algorithm, Iteration::Constant);
    // Without it every factorisation is of the sparse matrix, with it one, beside those of the dense one.
    let work = &run.solution.work;
    let gain = run.sparse_operations * work.factorisations as f64 / (run.sparse_operations + work.operations);
    let all = statements::judge(std::slice::from_ref(&finding));
    let told = all.iter().find(|one| one.text.contains("substructuring")).expect("a statement");
    assert_eq!(told.clause, format!("{gain:.1} to {gain:.0} times the operations without"));
}

#[test]
fn statement_that_needs_what_was_not_run_is_not_judged() {
    let all = statements::judge(&[]);
    assert!(all.len() == 3 && all.iter().all(|one| one.judgement == Judgement::NotJudged));
}

#[test]
fn run_that_stops_elsewhere_than_its_course_tells_is_red() {
    let verdict = |courses: &[Course]| {
        let judged = courses.to_vec().judge().expect("judged");
        judged[0].verdict.clone()
    };
    let all = NEAREST.clone();
    assert_eq!(verdict(&all), Verdict::Pass);
    assert_eq!(verdict(&[]), Verdict::Fail, "nothing was looked at");
    let first = all.iter().position(|course| course.alone.iter().any(|pair| pair[1].is_some())).expect("one that ends");
    let spoiled = |spoil: &dyn Fn(&mut [Option<Met>; 2])| {
        let ended = |all: &mut Vec<Course>| {
            spoil(all[first].alone.iter_mut().find(|pair| pair[1].is_some()).expect("one that ends"));
        };
        verdict(&workbench::spoiled(&all, ended))
    };
    let none =
        |all: &mut Vec<Course>| all.iter_mut().flat_map(|course| &mut course.alone).for_each(|pair| pair.fill(None));
    assert_eq!(verdict(&workbench::spoiled(&all, none)), Verdict::Fail, "nothing ended");
    let of = |pair: &[Option<Met>; 2]| pair[0].expect("it ended");
    for error in [of(&all[first].alone[0]).error + 1e-8, f64::NAN] {
        assert_eq!(spoiled(&|pair| pair[0] = Some(Met { error, ..of(pair) })), Verdict::Fail);
    }
    assert_eq!(spoiled(&|pair| pair[0] = Some(Met { iterations: of(pair).iterations + 1, ..of(pair) })), Verdict::Fail);
    assert_eq!(spoiled(&|pair| pair[0] = None), Verdict::Fail);
}

#[test]
fn statement_on_every_case_is_told_beside_what_the_error_stops() {
    let finding = Finding::of("r", "r", NEAREST.clone()).expect("judged");
    let all = statements::judge(&[finding]);
    let told = all.iter().find(|one| one.text == Sentence::LineAlways.name()).expect("a statement");
    // By hand from the lines of the record: converged, and p₀ and a within 0.3 %.
    let right = |scene: &str| {
        let text = std::fs::read_to_string(root().join(format!("snapshots/atlas/{scene}.csv"))).expect("a record");
        let own = text.lines().find(|line| line.starts_with("line.varying.secant,")).expect("its line");
        let cells: Vec<&str> = own.split(',').skip(2).collect();
        let starts = cells.chunks(5);
        starts.filter(|start| start[0] == "converged" && start[2].parse::<f64>().expect("an error") <= 3e-3).count()
    };
    let [cylinder, rod] = ["cylinder", "pin-rod"].map(right);
    let wanted = format!(
        "from {cylinder} of 25 initial stiffnesses on cylinder (8 elements per a) and from {rod} of 25 initial \
        stiffnesses on pin-rod"
    );
    assert!(told.measured.contains(&wanted) && told.clause.contains(&wanted), "{}", told.clause);
    assert!(rod < cylinder && statements::two_stops().contains(&wanted));
}
