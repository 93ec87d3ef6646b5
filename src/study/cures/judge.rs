//! The checks of the cures.

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::solve::{Formulation, Iteration};
use crate::study::cures::nested::Start;
use crate::study::cures::record::{DRAWN, Measured, RECORD, Runs, TOLERANCES};
use crate::study::cures::rules::{Ended, Rule};
use crate::study::cures::run::{Numbers, Reach};

/// How many times the plain share of starts an acceleration must reach.
pub const TIMES: f64 = 2.5;
/// How far a share may be from the recorded one: six of the 133 starts.
const DRIFT: f64 = 0.05;
/// Factor between numbers of iterations that are near one another.
const STEADY: f64 = 1.5;
/// Iterations that a nested start may take on every mesh.
const ITERATIONS: f64 = 3.0;

/// The checks of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Reach(reach) => of_reach(reach),
        Numbers::Rules(rules) => of_rules(rules).into(),
        Numbers::Nested(nested) => nested.starts.iter().flat_map(of_start).collect(),
    })
}

fn of_reach(Reach { now, recorded }: &Reach) -> Vec<Judged> {
    let mut judged: Vec<Judged> = now[1..].iter().flat_map(|one| [times(&now[0].runs, &one.runs), same(one)]).collect();
    let pairs = || now.iter().map(|one| &one.runs).zip(recorded);
    judged.extend(pairs().flat_map(|(runs, before)| [0, 1].map(|tolerance| drift(runs, before, tolerance))));
    judged.extend(pairs().map(|(runs, before)| steady(runs, before)));
    judged
}

fn place(runs: &Runs, tolerance: usize) -> String {
    format!("{}, iteration error ≤ {:e}", runs.formulation().name(), TOLERANCES[tolerance])
}

/// The accelerated share against the plain one, at the tight tolerance.
pub fn times(plain: &Runs, runs: &Runs) -> Judged {
    Check::at_least(
        Quantity::at("share of starts from which an acceleration converges", place(runs, 1)),
        Reference::own(&format!("{TIMES} times the plain share"), TIMES * plain.share(1)),
        "at 1e-3 the plain share leaves too little to cure",
    )
    .judge(runs.share(1))
}

fn same(measured: &Measured) -> Judged {
    Check::error(
        Quantity::at(
            "largest difference of an acceleration's mean edge pressures over p_ref",
            measured.runs.formulation().name(),
        ),
        Reference::own("kinematic load at 1e-8", 0.0),
        1e-3,
        "the tolerance of the shares at 1e-3",
    )
    .judge(measured.apart)
}

fn drift(runs: &Runs, recorded: &Runs, tolerance: usize) -> Judged {
    Check::error(
        Quantity::at("difference of the shares of starts that converge", place(runs, tolerance)),
        Reference::own(RECORD, 0.0),
        DRIFT,
        "noise of 1e-12 on the stiffness moved a share by at most four of 133 starts",
    )
    .judge((runs.share(tolerance) - recorded.share(tolerance)).abs())
}

/// Iterations on the drawn plane against the recorded ones: the same where plain, near where round-off is amplified.
fn steady(runs: &Runs, recorded: &Runs) -> Judged {
    let pairs = runs.iterations[0][DRAWN].iter().zip(&recorded.iterations[0][DRAWN]);
    let far = |(now, before): (usize, usize)| now.max(before) as f64 > STEADY * now.min(before) as f64;
    let both: Vec<(usize, usize)> = pairs.filter_map(|(now, before)| now.zip(*before)).collect();
    let moved = both.iter().filter(|pair| far(**pair)).count() as f64 / both.len() as f64;
    Check::error(
        Quantity::at("share of drawn starts whose iterations differ by more than half", runs.formulation().name()),
        Reference::own(RECORD, 0.0),
        0.2,
        "noise of 1e-12 changes the iterations of single long runs, not of most",
    )
    .judge(moved)
}

fn of_rules(rules: &[Rule]) -> [Judged; 2] {
    let (correction, others): (Vec<&Rule>, Vec<&Rule>) =
        rules.iter().partition(|rule| rule.rule == StiffnessRule::Correction);
    let iterations = |ended: &Ended| ended.converged().map_or(f64::NAN, |iterations| iterations as f64);
    let shares = |rule: &Rule| {
        let plain = iterations(&rule.ended[0]);
        rule.ended[1..].iter().map(|ended| iterations(ended) / plain).collect::<Vec<_>>()
    };
    let slowest = correction.into_iter().flat_map(shares).reduce(larger).unwrap_or(f64::NAN);
    let converged = others.iter().flat_map(|rule| &rule.ended).filter(|ended| ended.converged().is_some()).count();
    [
        Check::at_most(
            Quantity::at("number of iterations of an acceleration over that of none", "rule correction, both starts"),
            Reference::own("as many", 1.0),
            "correction is a fixed point of the forces alone, which an acceleration reaches sooner",
        )
        .judge(slowest),
        Check::none(
            Quantity::at("run with the rule secant or literal that converges", "plain and accelerated"),
            "secant drives springs to their ceiling, literal keeps stiffnesses beside its forces: a finding, locked",
        )
        .judge(converged as f64),
    ]
}

fn of_start(Start { element, stiffness, meshes }: &Start) -> [Judged; 2] {
    let of = format!("{}, κ₀ = {stiffness:e}", Formulation::new(*element, Iteration::Kinematic).name());
    let iterations = |ended: Ended| ended.converged().map_or(f64::NAN, |iterations| iterations as f64);
    let most = meshes.iter().map(|mesh| iterations(mesh.nested)).fold(0.0, larger);
    let apart = meshes.iter().filter_map(|mesh| mesh.apart).fold(0.0, larger);
    [
        Check::at_most(
            Quantity::at("number of iterations of kinematic load from a nested start", of.clone()),
            Reference::own("on every mesh", ITERATIONS),
            "one for the active set, one for its edge, one to spare, whatever the mesh",
        )
        .judge(most),
        Check::error(
            Quantity::at("largest difference of half-widths found from a nested start", of),
            Reference::own("every candidate closed", 0.0),
            1e-3,
            "both converge to an iteration error of 1e-3",
        )
        .judge(apart),
    ]
}
