//! Studies over meshes: observed orders, the cylinder's model error, half against quarter, the pin–rod's own uncertainty.

use crate::case::hertz;
use crate::case::library::{Cylinder, CylinderModel, TruncatedHertz};
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::order::{observed, richardson};
use crate::measure::{profile, whole};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Finding, Series, Table, Trial};

/// Elements per half-width of the coarsest of the nested meshes on truncated Hertz.
const COARSEST: usize = 4;
/// Elements per 10 mm of arc of the coarsest nested mesh of the pin–rod.
const COARSEST_PIN: usize = 8;
/// Times the meshes are halved.
const LEVELS: u32 = 4;

/// Trials of the refinement studies.
pub fn trials() -> Vec<Trial> {
    let orders = [("4-node", Order::Linear, 0.6), ("8-node", Order::Quadratic, 0.9)];
    let mut trials: Vec<Trial> = orders
        .map(|(name, order, l2)| Trial::new("order of accuracy, truncated hertz", name, move || orders_of(order, l2)))
        .into();
    trials.push(Trial::new("model error, cylinder", "node.kinematic", model_error));
    trials.push(Trial::new("half cylinder against quarter", "node.kinematic", half_against_quarter));
    trials.push(Trial::new("refinement, pin-rod", "4-node and 8-node", pin_rod));
    trials
}

/// Errors on one mesh of truncated Hertz.
struct Errors {
    size: f64,
    freedoms: usize,
    peak: f64,
    half_width: f64,
    l2: f64,
    load: f64,
}

fn orders_of(order: Order, l2_order: f64) -> Result<Finding, Error> {
    let numbers = TruncatedHertz::default();
    let problem = Problem::new("truncated-hertz", "truncated Hertz", problem::truncated_hertz(numbers.clone()));
    let levels = (0..LEVELS).map(|refinement| errors(&problem, &numbers, order, refinement));
    let levels: Vec<Errors> = levels.collect::<Result<_, _>>()?;
    let slope = |of: fn(&Errors) -> f64| {
        let sizes: Vec<f64> = levels.iter().map(|l| l.size).collect();
        observed(&sizes, &levels.iter().map(of).collect::<Vec<_>>())
    };
    let bound = |value| Reference::analytic("at least", value);
    let quadrature = levels.iter().map(|l| l.load).fold(0.0, f64::max);
    let checks = vec![
        Judged::at_least(
            "The pressure of the centre node shall converge with order",
            "order of p₀",
            slope(|l| l.peak),
            bound(1.8),
            "second order expected; least-squares slope over four meshes",
        ),
        Judged::at_least(
            "The half-width shall converge with order",
            "order of a",
            slope(|l| l.half_width),
            bound(1.8),
            "second order expected; the edge lies on a node",
        ),
        Judged::at_least(
            "The pressure profile shall converge with order",
            "order of L2(p)",
            slope(|l| l.l2),
            bound(l2_order),
            "capped near 1 by the square-root edge (Drouet & Hild 2015; Belhachmi & Ben Belgacem 2003)",
        ),
        Judged::norm(
            "The assembled load shall be the closed-form tractions' resultant",
            "|ΣF − P/2| / (P/2)",
            quadrature,
            Reference::analytic("Hertz", 0.0),
            1e-7,
            "16-point Gauss on every edge",
        ),
    ];
    let name = format!("{}-node", order.nodes_per_cell());
    let rows = levels.iter().map(|l| {
        vec![
            format!("{:.4}", l.size),
            l.freedoms.to_string(),
            format!("{:.2e}", l.peak),
            format!("{:.2e}", l.half_width),
            format!("{:.2e}", l.l2),
        ]
    });
    let table = Table {
        title: format!(
            "Truncated Hertz, {name}: errors on nested meshes (orders: p₀ {:.2}, a {:.2}, L2 {:.2})",
            slope(|l| l.peak),
            slope(|l| l.half_width),
            slope(|l| l.l2)
        ),
        head: ["h / a", "freedoms", "p₀", "a", "L2(p)"].map(String::from).into(),
        rows: rows.collect(),
    };
    let curve = |quantity: &str, of: fn(&Errors) -> f64| Series {
        picture: "orders".into(),
        label: format!("{quantity}, {name}"),
        points: levels.iter().map(|l| [l.size, of(l)]).collect(),
        failed: Vec::new(),
    };
    let series = vec![curve("p₀", |l| l.peak), curve("a", |l| l.half_width), curve("L2(p)", |l| l.l2)];
    Ok(Finding { checks, tables: vec![table], series, ..Default::default() })
}

fn errors(problem: &Problem, numbers: &TruncatedHertz, order: Order, refinement: u32) -> Result<Errors, Error> {
    let resolution = Resolution { elements: COARSEST, refinement, order };
    let discretisation = Discretisation::of(problem.scene.clone(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let exact = Hertz { load: numbers.load(), radius: numbers.radius, modulus: problem.scene.contact_modulus() };
    let [_, half_width, l2] = hertz::errors(&run, &exact);
    let centre = run.measures().largest.pressure;
    let peak = if run.solution.converged() { (centre / exact.peak_pressure() - 1.0).abs() } else { f64::NAN };
    let load = whole(problem.scene.contact()) * discretisation.system.bodies[0].applied_vertical().abs();
    Ok(Errors {
        size: 1.0 / (COARSEST << refinement) as f64,
        freedoms: run.freedoms,
        peak,
        half_width,
        l2,
        load: (load - numbers.load()).abs() / numbers.load(),
    })
}

/// What the quarter cylinder under uniform load differs from Hertz by, on meshes fine enough to show it.
fn model_error() -> Result<Finding, Error> {
    let mut rows = Vec::new();
    for a_over_r in [0.005, 0.05, 0.1, 0.2] {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let (scene, _, _) = problem::cylinder(numbers);
        let resolution = Resolution { elements: 48, refinement: 0, order: Order::Quadratic };
        let run = Run::of(&Discretisation::of(scene.clone(), resolution)?, &Formulation::verification())?;
        let peak = run.measures().peak.pressure / scene.reference.pressure;
        let width = run.measures().half_width / numbers.half_width();
        rows.push(vec![a_over_r.to_string(), format!("{peak:.4}"), format!("{width:.4}"), run.freedoms.to_string()]);
    }
    let head = ["a/R", "p₀ / Hertz", "a / Hertz", "freedoms"].map(String::from).into();
    let title = "Cylinder: model error against Hertz (48 elements per half-width)".into();
    Ok(Finding { tables: vec![Table { title, head, rows }], ..Default::default() })
}

/// The top quarter may be left out while the contact is small: the change grows with (a/R)².
///
/// The half cylinder is loaded on the same horizontal line as the quarter; loading its upper arc is shown beside it.
fn half_against_quarter() -> Result<Finding, Error> {
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for a_over_r in [0.0125, JUDGED, 0.05, 0.1] {
        let run = |model: CylinderModel| -> Result<Run, Error> {
            let (scene, elements, _) = problem::cylinder(Cylinder { a_over_r, model, ..Default::default() });
            let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
            Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification())
        };
        let (quarter, half) = (run(CylinderModel::Quarter)?, run(CylinderModel::Half)?);
        let above = run(CylinderModel::HalfLoadedAbove)?;
        let change = |run: &Run, of: fn(&Run) -> f64| format!("{:+.3} %", 100.0 * (of(run) / of(&quarter) - 1.0));
        let changes = [&half, &above].into_iter().flat_map(|run| HERTZ.map(|(_, of)| change(run, of)));
        rows.push(std::iter::once(a_over_r.to_string()).chain(changes).collect());
        let worst = HERTZ.map(|(_, of)| (of(&half) / of(&quarter) - 1.0).abs()).into_iter().fold(0.0, f64::max);
        finding.series.push(Series {
            picture: QUARTER.into(),
            label: a_over_r.to_string(),
            points: vec![[a_over_r, worst]],
            failed: Vec::new(),
        });
        if a_over_r <= JUDGED {
            finding.checks.extend(HERTZ.map(|(quantity, of)| {
                Judged::relative(
                    format!("Leaving out the top quarter shall not change a contact of a/R = {a_over_r}"),
                    quantity,
                    of(&quarter),
                    Reference::own("half cylinder", of(&half)),
                    LEFT_OUT,
                    "far field: of the order of (a/R)²",
                )
            }));
        }
    }
    let head = ["a/R", "p₀, loaded on the same line", "a, same line", "p₀, loaded on the upper arc", "a, upper arc"];
    let title = "Cylinder: change of the contact when the half cylinder is modelled instead of the quarter".into();
    finding.tables.push(Table { title, head: head.map(String::from).into(), rows });
    Ok(finding)
}

/// Picture name of the half-against-quarter study.
pub const QUARTER: &str = "half against quarter";
/// Change of p₀ and a below which the top quarter may be left out.
pub const LEFT_OUT: f64 = 1e-3;
/// a/R at which that is required.
const JUDGED: f64 = 0.025;

/// A number one quotes, by name.
type Quantity = (&'static str, fn(&Run) -> f64);

/// The two numbers of a Hertz contact.
const HERTZ: [Quantity; 2] =
    [("p₀ [MPa]", |run| run.measures().peak.pressure), ("a [mm]", |run| run.measures().half_width)];

/// The pin–rod has no closed form: its refinement series gives its own uncertainty.
fn pin_rod() -> Result<Finding, Error> {
    let (linear, quadratic) = (pin_levels(Order::Linear)?, pin_levels(Order::Quadratic)?);
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for (name, runs) in [("4-node", &linear), ("8-node", &quadratic)] {
        for (level, run) in runs.iter().enumerate() {
            rows.push(vec![
                name.into(),
                (COARSEST_PIN << level).to_string(),
                run.freedoms.to_string(),
                format!("{:.3}", run.measures().peak.pressure),
                format!("{:.3}", run.measures().half_width.to_degrees()),
            ]);
        }
        for (quantity, of) in QUANTITIES {
            let series = richardson([of(&runs[1]), of(&runs[2]), of(&runs[3])]);
            finding.checks.push(Judged::norm(
                format!("The {name} series shall know its own {quantity}"),
                format!("u({quantity}) / {quantity}, {name}"),
                series.uncertainty,
                Reference::own("Richardson", 0.0),
                3e-3,
                "three finest of four nested meshes, factor of safety 1.25",
            ));
        }
    }
    for (quantity, of) in QUANTITIES {
        let limit = |runs: &[Run]| richardson([of(&runs[1]), of(&runs[2]), of(&runs[3])]);
        let (a, b) = (limit(&linear), limit(&quadratic));
        finding.checks.push(Judged::relative(
            "4-node and 8-node cells shall tend to the same value",
            format!("{quantity}, extrapolated"),
            a.limit,
            Reference::own("8-node, extrapolated", b.limit),
            a.uncertainty.hypot(b.uncertainty).max(3e-3),
            "combined uncertainty of both series, at least the 0.3 % asked of each",
        ));
    }
    let l2 = profile::relative_l2_between(&linear[3].solution.edges, &quadratic[3].solution.edges);
    finding.checks.push(Judged::norm(
        "4-node and 8-node cells shall tend to the same curve",
        "L2(p) between them on the finest mesh",
        l2,
        Reference::own("8-node", 0.0),
        1e-2,
        "edge means on the finest mesh; the contact edge moves by a fraction of an element",
    ));
    let head = ["cells", "elements / 10 mm", "freedoms", "peak [MPa]", "2 √(∫pθ²/∫p) [°]"].map(String::from).into();
    finding.tables.push(Table { title: "Pin–rod: refinement series".into(), head, rows });
    Ok(finding)
}

/// The quantities whose uncertainty is asked for.
const QUANTITIES: [Quantity; 2] =
    [("peak", |run| run.measures().peak.pressure), ("second-moment angle", |run| run.measures().half_width)];

fn pin_levels(order: Order) -> Result<Vec<Run>, Error> {
    let problem = problem::problem("pin-rod", None)?;
    let level = |refinement| {
        let resolution = Resolution { elements: COARSEST_PIN, refinement, order };
        Run::of(&Discretisation::of(problem.scene.clone(), resolution)?, &Formulation::verification())
    };
    (0..LEVELS).map(level).collect()
}
