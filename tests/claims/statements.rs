//! The paper's statements: each judgement follows its numbers, and a counter-example turns it.

use contact_vv::report::statements::{self, Judgement, Statement};
use contact_vv::solve::{Element, Formulation, Iteration};
use contact_vv::study::drawn::Curve;
use contact_vv::study::sweep::run::{Numbers as Sweeps, Sweep};
use contact_vv::study::sweep::scene::Scene;
use contact_vv::study::{Finding, Numbers, Room};

/// Initial stiffnesses of the sweeps below.
const STARTS: [f64; 3] = [0.1, 1.0, 10.0];

/// A sweep with an end at each start: the iterations, or none where it did not converge.
fn sweep(scene: Scene, formulation: Formulation, ends: [Option<f64>; 3]) -> Finding {
    let mut iterations = Curve::default();
    for (start, end) in STARTS.into_iter().zip(ends) {
        match end {
            Some(count) => iterations.points.push([start, count]),
            None => iterations.failed.push(start),
        }
    }
    let numbers = Numbers::Sweep(Sweeps::Sweep(Sweep { scene, formulation, iterations, error: None }));
    Finding { room: Room::Sweep, case: "sweep".into(), name: "sweep".into(), numbers, judged: vec![] }
}

/// Both scenes under all nine, by what becomes of each.
fn sweeps(ends: impl Fn(Element, Iteration) -> [Option<f64>; 3]) -> Vec<Finding> {
    let of = |scene| Formulation::nine().into_iter().map(move |formulation| (scene, formulation));
    let all = Scene::PAPER.into_iter().flat_map(of);
    all.map(|(scene, formulation)| {
        let ends = ends(formulation.element, formulation.algorithm);
        sweep(scene, formulation, ends)
    })
    .collect()
}

fn judged(findings: &[Finding], begins: &str) -> Statement {
    let mut all = statements::judge(findings).into_iter();
    all.find(|statement| statement.text.starts_with(begins)).expect(begins)
}

#[test]
fn varying_stiffness_is_more_stable_only_as_far_as_it_converges() {
    let about = |varying: [Option<f64>; 3], constant: [Option<f64>; 3]| {
        let findings = sweeps(|_, algorithm| if algorithm == Iteration::Varying { varying } else { constant });
        judged(&findings, "Varying stiffness is more stable")
    };
    let (all, two, last) = ([Some(9.0); 3], [Some(9.0), Some(9.0), None], [None, Some(9.0), Some(9.0)]);
    assert_eq!(about(all, two).judgement, Judgement::Reproduced);
    assert_eq!(about(all, all).judgement, Judgement::NotReproduced);
    let part = about(two, [None; 3]);
    assert_eq!(part.judgement, Judgement::UnderCondition);
    assert!(part.measured.ends_with("up to κ₀ = 1"), "{}", part.measured);
    // Nothing converges below the first failure: there is no condition under which it holds.
    let none = about(last, [None; 3]);
    assert_eq!(none.judgement, Judgement::NotReproduced);
    assert!(!none.measured.contains("Condition"), "{}", none.measured);
}

#[test]
fn two_iterations_are_two_and_from_every_start() {
    let begins = "Kinematic load with node elements";
    let about = |wide: [Option<f64>; 3], edge: [Option<f64>; 3]| {
        let mut findings = sweeps(|_, _| wide);
        findings.push(sweep(Scene::AtTheEdge, Formulation::new(Element::Node, Iteration::Kinematic), edge));
        judged(&findings, begins).judgement
    };
    let (two, seven, failing) = ([Some(2.0); 3], [Some(2.0), Some(7.0), Some(2.0)], [Some(2.0), None, Some(2.0)]);
    assert_eq!(about(two, two), Judgement::Reproduced);
    assert_eq!(about(seven, two), Judgement::UnderCondition);
    assert_eq!(about(failing, two), Judgement::UnderCondition);
    assert_eq!(about(seven, seven), Judgement::NotReproduced);
    assert_eq!(about(seven, failing), Judgement::NotReproduced);
}
