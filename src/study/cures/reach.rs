//! Over which initial stiffnesses constant stiffness converges within 200 steps: plain, crossed secant, Anderson.

use crate::algorithm::Acceleration;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::study::cures::PICTURE;
use crate::study::cures::record::{self, DRAWN, PLANES, Runs, STEPS, TOLERANCES, discretised, stiffnesses};
use crate::study::unsorted::{Finding, Series, Table};

/// How many times the plain share of starts an acceleration must reach.
pub const TIMES: f64 = 2.5;
/// How far a share may be from the recorded one: six of the 133 starts.
const DRIFT: f64 = 0.05;

/// Factor between steps that are near one another.
const STEADY: f64 = 1.5;

/// Columns of the tables of shares.
pub const SHARES_HEAD: [&str; 6] = [
    "formulation",
    "iteration error ≤",
    "starts that converge within 200 steps",
    "times plain (possible)",
    "κ₀ at which all planes converge",
    "accelerated steps given up",
];
/// Columns of the tables of reach by plane.
pub const PLANES_HEAD: [&str; 7] =
    ["element", "iteration error ≤", "L/a", "elements per a", "plain", "crossed secant", "Anderson"];

/// Shares and reach of the three accelerations of an element: judged as measured now, shown as recorded.
pub fn reach(element: Element) -> Result<Finding, Error> {
    let (now, recorded) = (record::measure(element)?, record::read(element)?);
    let mut checks: Vec<Judged> = now[1..].iter().flat_map(|runs| [times(&now[0], runs), same(runs)]).collect();
    checks.extend(now.iter().zip(&recorded).flat_map(|(runs, before)| [0, 1].map(|k| drift(runs, before, k))));
    checks.extend(now.iter().zip(&recorded).map(|(runs, before)| steady(runs, before)));
    let shares = recorded.iter().flat_map(|runs| [0, 1].map(|k| row_of_shares(&recorded[0], runs, k))).collect();
    let planes = [0, 1].into_iter().flat_map(|k| rows_of_planes(element, &recorded, k)).collect();
    let tables = vec![
        Table { title: "shares".into(), head: SHARES_HEAD.map(String::from).into(), rows: shares },
        Table { title: "planes".into(), head: PLANES_HEAD.map(String::from).into(), rows: planes },
    ];
    Ok(Finding { checks, tables, series: recorded.iter().map(series).collect(), ..Default::default() })
}

/// The accelerated share against the plain one, at the tight tolerance.
pub fn times(plain: &Runs, runs: &Runs) -> Judged {
    Judged::at_least(
        format!("An acceleration shall converge from {TIMES} times as many starts as the plain iteration"),
        format!("share of starts, {}, iteration error ≤ {:e}", runs.formulation, TOLERANCES[1]),
        runs.share(1),
        Reference::own("so many times the plain share", TIMES * plain.share(1)),
        "at 1e-3 the plain share leaves too little to cure",
    )
}

fn same(runs: &Runs) -> Judged {
    Judged::norm(
        "What an acceleration converges to shall be the solution of kinematic load",
        format!("largest difference of mean edge pressures over p_ref, {}", runs.formulation),
        runs.apart,
        Reference::own("kinematic at 1e-8", 0.0),
        1e-3,
        "the tolerance of the shares at 1e-3",
    )
}

fn drift(runs: &Runs, recorded: &Runs, tolerance: usize) -> Judged {
    Judged::norm(
        "The share of starts shall be what was recorded",
        format!("difference of shares, {}, iteration error ≤ {:e}", runs.formulation, TOLERANCES[tolerance]),
        (runs.share(tolerance) - recorded.share(tolerance)).abs(),
        Reference::own("snapshots/atlas/reach.json", 0.0),
        DRIFT,
        "noise of 1e-12 on the stiffness moved a share by at most four of 133 starts",
    )
}

/// Steps of the drawn plane against the recorded ones: the same where plain, near where round-off is amplified.
fn steady(runs: &Runs, recorded: &Runs) -> Judged {
    let pairs = runs.steps[0][DRAWN].iter().zip(&recorded.steps[0][DRAWN]);
    let far = |(now, before): (usize, usize)| now.max(before) as f64 > STEADY * now.min(before) as f64;
    let both: Vec<(usize, usize)> = pairs.filter_map(|(now, before)| now.zip(*before)).collect();
    let moved = both.iter().filter(|pair| far(**pair)).count() as f64 / both.len() as f64;
    Judged::norm(
        "The steps that are drawn shall be near those that were recorded",
        format!("share of starts whose steps differ by more than half, {}", runs.formulation),
        moved,
        Reference::own("snapshots/atlas/reach.json", 0.0),
        0.2,
        "noise of 1e-12 changes the steps of single long runs, not of most",
    )
}

fn row_of_shares(plain: &Runs, runs: &Runs, tolerance: usize) -> Vec<String> {
    let steps = &runs.steps[tolerance];
    let everywhere: Vec<bool> =
        (0..stiffnesses().len()).map(|k| steps.iter().all(|plane| plane[k].is_some())).collect();
    let [share, plain] = [runs, plain].map(|runs| runs.share(tolerance));
    vec![
        runs.formulation.clone(),
        format!("{:e}", TOLERANCES[tolerance]),
        format!("{:.0} %", 100.0 * share),
        format!("{:.1} ({:.1})", share / plain, 1.0 / plain),
        interval(&everywhere),
        runs.rejected.to_string(),
    ]
}

fn rows_of_planes(element: Element, all: &[Runs], tolerance: usize) -> Vec<Vec<String>> {
    let row = |(plane, (stretch, elements)): (usize, (f64, usize))| {
        let reached =
            |runs: &Runs| interval(&runs.steps[tolerance][plane].iter().map(Option::is_some).collect::<Vec<_>>());
        let place =
            [element.name().into(), format!("{:e}", TOLERANCES[tolerance]), stretch.to_string(), elements.to_string()];
        place.into_iter().chain(all.iter().map(reached)).collect()
    };
    PLANES.into_iter().enumerate().map(row).collect()
}

/// Lowest and highest start that converge, and how many between them do not.
fn interval(found: &[bool]) -> String {
    let (Some(first), Some(last)) = (found.iter().position(|f| *f), found.iter().rposition(|f| *f)) else {
        return "–".into();
    };
    let stiffnesses = stiffnesses();
    let gaps = found[first..=last].iter().filter(|found| !**found).count();
    let but = if gaps > 0 { format!(" but {gaps}") } else { String::new() };
    format!("{:.1e} … {:.1e}{but}", stiffnesses[first], stiffnesses[last])
}

/// Steps to the default tolerance against initial stiffness on the drawn plane.
fn series(runs: &Runs) -> Series {
    let (mut points, mut failed) = (Vec::new(), Vec::new());
    for (stiffness, steps) in stiffnesses().into_iter().zip(&runs.steps[0][DRAWN]) {
        match steps {
            Some(steps) => points.push([stiffness, *steps as f64]),
            None => failed.push(stiffness),
        }
    }
    Series { picture: PICTURE.into(), label: runs.formulation.clone(), points, failed }
}

/// Every rule of constant stiffness with every acceleration on the drawn plane, node element: steps, where within 200.
///
/// Whether the others exhaust their steps or diverge hangs on round-off.
pub fn rules() -> Result<Finding, Error> {
    let discretisation = discretised(PLANES[DRAWN])?;
    let base = Formulation::new(Element::Node, Iteration::Constant);
    let settings = Settings { max_steps: STEPS, ..Settings::default() };
    let mut rows = Vec::new();
    for &rule in Iteration::Constant.rules() {
        for stiffness in [1.0, 10.0] {
            let mut row = vec![rule.name().to_string(), stiffness.to_string()];
            for acceleration in Acceleration::ALL {
                let formulation = Formulation { rule, stiffness, acceleration, settings, ..base.clone() };
                let solution = discretisation.solve(&formulation)?;
                let steps = format!("{} steps", solution.work.steps);
                row.push(if solution.converged() { steps } else { "not".into() });
            }
            rows.push(row);
        }
    }
    let head = ["rule", "κ₀", "plain", "crossed secant", "Anderson"].map(String::from).into();
    let title = "Every rule within 200 steps, iteration error ≤ 1e-3, node element".into();
    Ok(Finding { tables: vec![Table { title, head, rows }], ..Default::default() })
}
