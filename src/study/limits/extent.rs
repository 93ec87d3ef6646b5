//! Limits of the contact's extent: candidates and bodies that end before it, and a/R, where it is the reference that fails.

use crate::algorithm::{Kinematic, iterate};
use crate::case::library::{self, Cylinder, TruncatedHertz};
use crate::case::{Check, Quantity, Reference};
use crate::error::{Error, Kind};
use crate::measure::{Measures, larger, largest};
use crate::mesh::Order;
use crate::scene::{Load, Scene};
use crate::solve::run::Errors;
use crate::solve::{Discretisation, Formulation};
use crate::study::limits::push::{
    Limit, Push, Solved, against_hertz, meshed, number, percent, refused, size, told, told_with_remedy,
};

/// Candidate stretches over the true half-width.
const STRETCHES: [f64; 8] = [2.0, 1.1, 1.0, 0.98, 0.95, 0.9, 0.8, 0.5];
/// Index of candidates that end where the contact ends.
const EXACT: usize = 2;
/// Index of candidates that are too short by more than a node spacing of the finer meshes.
const CUT: usize = 5;
/// Elements per half-width.
const ELEMENTS: [usize; 3] = [4, 8, 16];

/// What comes of candidates that end before the contact.
struct Cut {
    /// What the user gets.
    result: Result<Solved, Error>,
    /// Error of p₀ of what the iteration finds, whether it is accepted or not.
    unchecked: f64,
}

impl Cut {
    fn at(stretch: f64, elements: usize) -> Result<Self, Error> {
        let scene = TruncatedHertz { stretch, ..Default::default() }.scene();
        let discretisation = meshed(scene, elements, Order::Quadratic)?;
        Ok(Self { result: Solved::on(&discretisation), unchecked: peak_of_any(&discretisation)? - 1.0 })
    }

    fn is_refused(&self) -> bool {
        matches!(self.result, Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }))
    }

    fn cell(&self) -> String {
        let refused = if self.result.is_ok() { "" } else { "refused, else " };
        format!("{refused}{}", percent(self.unchecked))
    }
}

/// Peak over p₀ of whatever the loop converges to, whether the contact reaches the end of its candidates or not.
fn peak_of_any(discretisation: &Discretisation) -> Result<f64, Error> {
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let settings = formulation.settings;
    let mut algorithm = Kinematic::new(formulation.rule, settings.tolerance);
    let solution = iterate(&problem, &mut algorithm, settings)?;
    let measures = Measures::of(&discretisation.scene, 0, solution.part(0));
    Ok(measures.peak.pressure / discretisation.scene.reference.pressure)
}

/// The candidates end before the contact does.
pub(super) fn short_candidates() -> Result<Limit, Error> {
    let stretches = Push::of("L/a", &STRETCHES, ELEMENTS, Cut::at)?;
    let [exact, cut] = [EXACT, CUT].map(|index| &stretches.tried[index].1);
    let refusing = exact.iter().filter(|cut| cut.is_refused()).count();
    let accepting = cut[1..].iter().filter(|cut| !cut.is_refused()).count();
    let accepted = stretches.all().filter_map(|cut| cut.result.as_ref().ok()).map(|solved| solved.errors().peak.abs());
    let onsets = [0, 1, 2].map(|mesh| {
        let onset = stretches.onset(|cuts| cuts[mesh].is_refused());
        format!("{} elements per a: {onset}", ELEMENTS[mesh])
    });
    let shortest = stretches.tried.iter().rev().find_map(|(_, [.., fine])| fine.result.as_ref().err());
    let [seen, instead] = told_with_remedy(shortest);
    Ok(Limit {
        pushed: "candidate surface shorter than the true contact",
        range: stretches.range("L/a"),
        onset: onsets.join("; "),
        seen,
        instead,
        judged: vec![
            Check::none(
                Quantity::at("mesh that refuses candidates ending where the contact ends", "L = a"),
                "beyond the true edge the surfaces part: nothing penetrates",
            )
            .judge(refusing as f64),
            Check::none(
                Quantity::at(
                    "mesh that accepts candidates too short by more than a node spacing",
                    "L = 0.9 a, 8 and 16 elements",
                ),
                "the node beyond the end then lies inside the true contact and penetrates",
            )
            .judge(accepting as f64),
            against_hertz(
                "largest error of p₀ of what is accepted",
                largest(accepted),
                1e-2,
                "what no node can see is shorter than a node spacing, and enters the peak squared",
            ),
        ],
        table: stretches.table(
            "Truncated Hertz, candidates ending at L: what is refused, and how wrong it would have been",
            &[
                ("L / a", |(stretch, _)| number(*stretch)),
                ("error of p₀, 4 elements per a", |(_, [four, ..])| four.cell()),
                ("8 elements", |(_, [_, eight, _])| eight.cell()),
                ("16 elements", |(_, [.., sixteen])| sixteen.cell()),
            ],
        ),
    })
}

/// Loads over that whose Hertz contact is half as wide as the block.
const LOADS: [f64; 7] = [0.2, 1.0, 2.0, 4.0, 6.0, 8.0, 50.0];

/// A block of two half-widths.
fn block() -> TruncatedHertz {
    TruncatedHertz { size: 2.0, stretch: 2.0, ..Default::default() }
}

/// The block pressed evenly on the parabola by a multiple of the Hertz load.
fn pressed(factor: f64) -> Scene {
    let (load, width) = (factor * block().load(), 2.0 * block().half_width());
    let mut scene = block().scene();
    scene.bodies[0].loads = vec![Load::Traction { boundary: "far".into(), traction: [0.0, -0.5 * load / width] }];
    scene
}

/// Last closed point over the width of the block.
fn edge(solved: &Solved) -> f64 {
    solved.run.measures().edge() / (2.0 * block().half_width())
}

/// Pressure at the corner over the peak.
fn at_corner(solved: &Solved) -> f64 {
    let corner = solved.run.solution.points.last().map_or(f64::NAN, |point| point.pressure);
    corner / solved.run.measures().peak.pressure
}

/// The contact grows until it reaches the end of the body.
pub(super) fn body_end() -> Result<Limit, Error> {
    let loads = Push::of("P/P₁", &LOADS, [8], |factor, elements| {
        Solved::on(&meshed(pressed(factor), elements, Order::Quadratic)?)
    })?;
    let balance = |(factor, [solved]): &(f64, [Solved; 1])| {
        let error = (solved.run.transmitted() / (factor * block().load()) - 1.0).abs();
        if solved.run.solution.converged() { error } else { f64::NAN }
    };
    let [before, last] = [2, 1].map(|back| at_corner(&loads.tried[LOADS.len() - back].1[0]));
    Ok(Limit {
        pushed: "contact reaching the end of the body",
        range: loads.range("P/P₁, with the Hertz half-width of P₁ half the block's"),
        onset: loads.onset(|[solved]| edge(solved) > 1.0 - 1e-9),
        seen: format!("{}; the pressure is that of a body that ends there", loads.last()[0].seen()),
        instead: "nothing; model the body as long as it is".into(),
        judged: vec![
            Check::error(
                Quantity::at("largest |ΣA p − P| / P of a contact that reaches the end of the body", "every load"),
                Reference::own("the applied load", 0.0),
                1e-8,
                "the tolerance of the runs; there is no surface beyond the end",
            )
            .judge(largest(loads.tried.iter().map(balance))),
            Check::at_least(
                Quantity::at("pressure at the corner over the peak", "largest load"),
                Reference::own("that under the load before", before),
                "towards a punch of the block's width, whose pressure is largest at the corner",
            )
            .judge(last),
        ],
        table: loads.table(
            "Block between a flat plate and a parabola",
            &[
                ("P / P₁", |(load, _)| number(*load)),
                ("outcome", |(_, [solved])| solved.run.solution.outcome.to_string()),
                ("last closed point / width", |(_, [solved])| format!("{:.3}", edge(solved))),
                ("p at the corner / peak", |(_, [solved])| format!("{:.3}", at_corner(solved))),
            ],
        ),
    })
}

/// Half-widths over the radius.
const RATIOS: [f64; 7] = [0.005, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5];
/// Difference to Hertz that counts as its failure.
const FAILS: f64 = 0.01;
/// Difference to Hertz, and change by refinement, that is none.
const HOLDS: f64 = 1e-3;
/// Ratio from which on the contact is large.
const LARGE: f64 = 0.15;

/// By how much the differences to Hertz change from a mesh to one of twice the elements.
fn change([coarse, fine]: &[Solved; 2]) -> Errors {
    let [coarse, fine] = [coarse.errors(), fine.errors()];
    Errors { peak: fine.peak - coarse.peak, half_width: fine.half_width - coarse.half_width }
}

/// Contacts of up to half the radius: the difference to Hertz's parabola on a half-space grows, the change by refinement does not.
pub(super) fn large_contact() -> Result<Limit, Error> {
    let ratios = Push::of("a/R", &RATIOS, [12, 24], |a_over_r, elements| {
        let scene = Cylinder { a_over_r, ..Default::default() }.scene();
        Solved::on(&meshed(scene, elements, Order::Quadratic)?)
    })?;
    let beyond = refused(library::find("cylinder", Some(0.6)), "a contact of more than half the radius")?;
    let is_off = |bound: f64| move |[_, fine]: &[Solved; 2]| fine.is_off(bound);
    let largest_change = largest(ratios.tried.iter().map(|(_, found)| change(found).largest()));
    let large = ratios.tried.iter().filter(|(ratio, _)| *ratio > LARGE);
    let shares = large.map(|(_, found)| change(found).largest() / found[1].errors().largest());
    Ok(Limit {
        pushed: "a/R of the cylinder: Hertz's own limit",
        range: ratios.range("a/R"),
        onset: format!(
            "Hertz is off by {} {}; refinement changes p₀ and a by at most {}",
            size(FAILS),
            ratios.onset(is_off(FAILS)),
            size(largest_change)
        ),
        seen: format!("{}; beyond, {}", ratios.last()[1].seen(), told(&beyond)),
        instead: format!(
            "trust the solution, not Hertz; verify at a/R ≤ {}",
            number(ratios.last_before(is_off(HOLDS)))
        ),
        judged: vec![
            Check::error(
                Quantity::at("largest change of p₀ and a by refinement", "from 12 to 24 elements per half-width"),
                Reference::own("twice as fine a mesh", 0.0),
                HOLDS,
                "a tenth of the difference that is attributed to the reference",
            )
            .judge(largest_change),
            Check::at_least(
                Quantity::at("difference to Hertz over change by refinement of a large contact", "a/R ≥ 0.2"),
                Reference::own("ten times", 10.0),
                "parabola for circle, half-space for cylinder: of the order of (a/R)²",
            )
            .judge(shares.reduce(larger).map_or(f64::NAN, f64::recip)),
            against_hertz(
                Quantity::at("error of p₀ and a of a small contact", "a/R = 0.005"),
                ratios.tried[0].1[1].errors().largest(),
                HOLDS,
                "(a/R)² is 2.5e-5; 24 8-node cells per half-width",
            ),
        ],
        table: ratios.table(
            "Cylinder: what fails at large a/R",
            &[
                ("a/R", |(ratio, _)| ratio.to_string()),
                ("p₀ against Hertz", |(_, [_, fine])| percent(fine.errors().peak)),
                ("a against Hertz", |(_, [_, fine])| percent(fine.errors().half_width)),
                ("p₀, change by refinement", |(_, both)| percent(change(both).peak)),
                ("a, change by refinement", |(_, both)| percent(change(both).half_width)),
            ],
        ),
    })
}
