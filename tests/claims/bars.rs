//! Error bars against scenes of closed form, and that narrower ones would be seen.

use std::path::Path;

use contact_vv::accuracy::longest::longest;
use contact_vv::accuracy::{self, Asked, Bars, Quantity, Subject, bars};
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::Case;
use contact_vv::case::library::{self, Cylinder};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::study::met::draw::Draw;
use contact_vv::study::met::{Family, Site};

/// Families with a closed form; number of scenes of each.
const FAMILIES: [Family; 4] = [Family::Polynomial, Family::Cosine, Family::Cylinder, Family::Pin];
const EACH: usize = 40;
/// Numbers of scenes from which no constant of the bars was chosen.
const FROM: usize = 5000;

/// True error over its bar, of peak, half-width and end, of a random scene on a random mesh; none where that does not hold it.
fn ratios(family: Family, number: usize) -> Option<[f64; 3]> {
    let mut draw = Draw::new((31_000_000 + 10_000 * family as usize + number) as u64);
    draw.between(0.0, 1.0);
    let sample = Site { family, number }.sample().expect("a scene");
    let (mut scene, [peak, half_width]) = (sample.scene, sample.truths[0]);
    let per = draw.decades(4.0, 30.0);
    let elements = per.ceil();
    let reach = if family == Family::Pin { 1.5 * half_width } else { draw.between(1.3, 2.5) * half_width };
    scene.contacts[0].stretch = reach.min(longest(&scene, scene.contact()));
    scene.grading.unit = half_width * scene.contact().path.metric() * elements / per;
    (scene.grading.along, scene.grading.depth) = (draw.between(1.2, 1.6), draw.between(1.2, 1.5));
    let order = if number.is_multiple_of(2) { Order::Linear } else { Order::Quadratic };
    let element = Element::ALL[number / 2 % 3];
    let (resolution, length) =
        (Resolution { elements: elements as usize, refinement: 0, order }, scene.reference.length);
    let discretisation = Discretisation::of(scene, resolution).ok()?;
    let run = Run::of(&discretisation, &Formulation::new(element, Iteration::Kinematic).tolerance(1e-8)).ok()?;
    let bars = bars(&discretisation, &run, None).expect("bars");
    let ratio = |quantity: Quantity, truth: f64| {
        let bar = bars.of_contact(0, quantity).expect("a bar").total();
        (quantity.of(run.measures()) - truth).abs() / bar
    };
    // Where these scenes name a length, it is that up to which the closed form is pressed; a pin's is not among them.
    let end = if family == Family::Pin { 0.0 } else { ratio(Quantity::End(0), length) };
    Some([ratio(Quantity::PeakPressure, peak), ratio(Quantity::HalfWidth, half_width), end])
}

#[test]
fn true_errors_lie_within_their_bars_and_bars_a_fifth_as_wide_would_be_seen() {
    for family in FAMILIES {
        let all: Vec<[f64; 3]> = (FROM..FROM + EACH).filter_map(|number| ratios(family, number)).collect();
        assert!(10 * all.len() >= 9 * EACH, "{}: {} scenes", family.name(), all.len());
        for (k, name) in ["peak", "half-width", "end"].into_iter().enumerate() {
            if family == Family::Pin && k == 2 {
                continue;
            }
            let share = |of_bar: f64| all.iter().filter(|ratio| ratio[k] <= of_bar).count() as f64 / all.len() as f64;
            assert!(share(1.0) >= 0.95, "{}, {name}: {:.3} within", family.name(), share(1.0));
            assert!(share(3.0) >= 1.0, "{}, {name}: {all:?}", family.name());
            // A bar that is never needed says nothing.
            assert!(share(0.2) < 0.95, "{}, {name}: {:.3} within a fifth", family.name(), share(0.2));
        }
    }
}

fn cylinder(formulation: &Formulation, elements: usize) -> (Run, Bars) {
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(Cylinder::default().scene(), resolution).expect("a mesh");
    let run = Run::of(&discretisation, formulation).expect("a run");
    let bars = bars(&discretisation, &run, None).expect("bars");
    (run, bars)
}

#[test]
fn parts_of_iteration_and_penalty_are_distances_to_the_discrete_solution() {
    let exact = Formulation::new(Element::Node, Iteration::Kinematic).tolerance(1e-10);
    let (wanted, narrow) = cylinder(&exact, 12);
    let hasty = Formulation::new(Element::Node, Iteration::Constant).tolerance(1e-2);
    let soft = Formulation {
        rule: StiffnessRule::Penalty,
        stiffness: 30.0,
        ..Formulation::new(Element::Node, Iteration::Kinematic).tolerance(1e-8)
    };
    for quantity in [Quantity::PeakPressure, Quantity::HalfWidth, Quantity::End(0)] {
        let (run, bars) = cylinder(&hasty, 12);
        let apart = (quantity.of(run.measures()) - quantity.of(wanted.measures())).abs();
        let bar = bars.of_contact(0, quantity).expect("a bar");
        assert!(
            (bar.iteration - apart).abs() <= 1e-6 * quantity.of(wanted.measures()),
            "{quantity:?}: {bar:?}, {apart}"
        );
        // The mesh's part is that of the discrete solution, wherever the iteration ended.
        let mesh = narrow.of_contact(0, quantity).expect("a bar").mesh;
        assert!((bar.mesh - mesh).abs() <= 1e-6 * quantity.of(wanted.measures()), "{quantity:?}: {bar:?}, {mesh}");
    }
    let (run, bars) = cylinder(&soft, 12);
    let apart = (run.measures().peak.pressure - wanted.measures().peak.pressure).abs();
    let bar = bars.of_contact(0, Quantity::PeakPressure).expect("a bar");
    assert!(
        bar.penalty > 1e-3 * apart && (bar.penalty - apart).abs() <= bar.iteration + 1e-6 * apart,
        "{bar:?}, {apart}"
    );
}

#[test]
fn unknown_is_unknown_and_no_zero() {
    // Nothing coarser holds the contact on one element.
    let (_, bars) = cylinder(&Formulation::new(Element::Node, Iteration::Kinematic), 1);
    let peak = bars.of_contact(0, Quantity::PeakPressure).expect("a bar");
    assert!(peak.total().is_nan() || peak.mesh > 0.0, "{peak:?}");
    // What the mesh leaves exact keeps its round-off.
    let (_, bars) = cylinder(&Formulation::new(Element::Node, Iteration::Kinematic), 12);
    assert!(bars.of(Subject::Reaction(0, 0)).expect("a bar").total() > 0.0);
}

#[test]
fn exact_numbers_of_an_eccentric_load_lie_within_their_bars() {
    let file = crate::outputs::scene("eccentric-load");
    let case = Case::read(Path::new(&file)).expect("a case");
    let (meshed, run) = case.solve().expect("a run");
    let bars = bars(&meshed.discretisation, &run, None).expect("bars");
    let exact = [
        (Quantity::PeakPressure, 140.0),
        (Quantity::PeakPlace, 10.0),
        (Quantity::Centre, 4.0 / 3.0),
        (Quantity::Resultant, 4000.0),
        (Quantity::Moment, 16000.0 / 3.0),
        (Quantity::Begin(0), -10.0),
        (Quantity::End(0), 10.0),
    ];
    for (quantity, exact) in exact {
        let one = bars.all.iter().find(|one| one.subject == Subject::Contact(0, quantity)).expect("a bar");
        assert!((one.value - exact).abs() <= one.bar.total(), "{quantity:?}: {one:?}, {exact}");
    }
    let support = bars.all.iter().find(|one| one.subject == Subject::Reaction(0, 0)).expect("a bar");
    assert!(support.value.abs() <= support.bar.total(), "{support:?}");
}

#[test]
fn springs_of_a_penalty_are_told_apart_in_reactions_too() {
    let case = library::find("pin-rod", None).expect("a case");
    let resolution = Resolution { elements: 8, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(case.scene, resolution).expect("a mesh");
    let rigid = Formulation::new(Element::Node, Iteration::Kinematic).tolerance(1e-9);
    let soft = Formulation { rule: StiffnessRule::Penalty, stiffness: 100.0, ..rigid.clone() };
    let [rigid, soft] = [rigid, soft].map(|formulation| Run::of(&discretisation, &formulation).expect("a run"));
    let bars = bars(&discretisation, &soft, None).expect("bars");
    let [wanted, found] =
        [&rigid, &soft].map(|run| discretisation.reactions(&run.solution).expect("reactions")[0].force);
    let bar = bars.of(Subject::Reaction(0, 0)).expect("a bar");
    let apart = (wanted - found).abs();
    assert!(apart > 1e-6 * wanted.abs(), "{apart}");
    assert!((bar.penalty - apart).abs() <= 1e-3 * apart && bar.iteration <= 1e-3 * apart, "{bar:?}, {apart}");
}

#[test]
fn accuracy_that_is_met_and_the_bar_are_one_number() {
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let answer = accuracy::solve(&Cylinder::default().scene(), &formulation, &Asked::new(1e-2)).expect("an answer");
    let discretisation = Discretisation::of(answer.scene.clone(), answer.resolution).expect("a mesh");
    let bars = bars(&discretisation, &answer.run, Some(&answer)).expect("bars");
    for quoted in &answer.estimates {
        let bar = bars.of_contact(0, quoted.quantity).expect("a bar");
        let value = quoted.quantity.of(answer.run.measures());
        assert!((bar.total() / value - quoted.relative).abs() <= 1e-6, "{bar:?}, {quoted:?}");
    }
    assert_eq!(answer.estimates.len(), 2);
}
