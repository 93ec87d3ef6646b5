//! The halving law of kinematic load: predicted against measured steps.

use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::halving;
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the trials of the halving law.
pub const HALVING: &str = "predicted steps of kinematic load";

/// Trials of the law.
pub(super) fn trials() -> Vec<Trial> {
    let scenes = [("cylinder", true), ("truncated hertz", false)];
    let mut trials: Vec<Trial> =
        scenes.map(|(name, cylinder)| Trial::new(HALVING, name, move || halving_law(cylinder))).into();
    trials.push(Trial::new(HALVING, "pin-rod", pin_rod));
    trials
}

/// Candidate stretch over the half-width, elements per half-width and initial stiffnesses of the halving law.
const STRETCHES: [f64; 4] = [1.0, 1.5, 2.0, 3.0];
const ELEMENTS: [usize; 3] = [5, 8, 16];
const SOFT_AND_HARD: [f64; 2] = [1.0, 1e6];

fn halving_law(cylinder: bool) -> Result<Finding, Error> {
    let (mut rows, mut checks) = (Vec::new(), Vec::new());
    for stretch in STRETCHES {
        for elements in ELEMENTS {
            let (scene, _, _) = if cylinder {
                problem::cylinder(Cylinder { stretch, ..Default::default() })
            } else {
                problem::truncated_hertz(TruncatedHertz { stretch, ..Default::default() })
            };
            let half_width = scene.reference.length;
            let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
            let discretisation = Discretisation::of(scene, resolution)?;
            let spacing = half_width / (2.0 * elements as f64);
            let mut cells = vec![stretch.to_string(), elements.to_string()];
            for stiffness in SOFT_AND_HARD {
                let formulation = Formulation { stiffness, ..Formulation::new(Element::Node, Iteration::Kinematic) };
                let run = Run::of(&discretisation, &formulation)?;
                let steps = if run.solution.converged() { run.solution.work.steps as f64 } else { f64::NAN };
                let predicted = halving::steps(stretch * half_width, half_width, spacing, stiffness);
                cells.push(format!("{predicted} / {steps}"));
                checks.push(Judged::norm(
                    "Kinematic load shall take the steps of the halving law",
                    format!("steps off, L/a = {stretch}, {elements} per half-width, κ₀ = {stiffness:e}"),
                    (steps - predicted as f64).abs(),
                    Reference::own("halving of L² − a²", 0.0),
                    1.0,
                    "the law counts halvings; the last one may end anywhere within a node spacing",
                ));
            }
            rows.push(cells);
        }
    }
    let head = ["L/a", "elements per a", "predicted / measured, κ₀ = 1", "predicted / measured, κ₀ = 1e6"];
    let title = format!("{HALVING}: {}", if cylinder { "cylinder" } else { "truncated Hertz" });
    let table = Table { title, head: head.map(String::from).into(), rows };
    Ok(Finding { checks, tables: vec![table], ..Default::default() })
}

/// Candidates of the pin-rod beyond its contact \[degrees\], and elements per 10 mm of arc.
const PIN_STRETCHES: [f64; 4] = [65.0, 70.0, 75.0, 85.0];
const PIN_ELEMENTS: [usize; 2] = [12, 24];

/// The law beside the pin-rod, whose contact is no Hertz contact: reported, not gated.
fn pin_rod() -> Result<Finding, Error> {
    let mut rows = Vec::new();
    for degrees in PIN_STRETCHES {
        for elements in PIN_ELEMENTS {
            let scene = PinRod { stretch: degrees.to_radians(), ..Default::default() }.scene();
            let problem = Problem::new("pin-rod", "pin-rod", (scene, elements, None));
            let discretisation = Discretisation::of(problem.scene.clone(), problem.resolution)?;
            let edge = Run::of(&discretisation, &Formulation::verification())?.measures().edge();
            let stretch = discretisation.scene.contact().stretch;
            let spacing = stretch / (discretisation.interfaces[0].stations.len() - 1) as f64;
            let mut cells = vec![format!("{:.2}", stretch / edge), elements.to_string()];
            for stiffness in SOFT_AND_HARD {
                let formulation = Formulation { stiffness, ..Formulation::new(Element::Node, Iteration::Kinematic) };
                let solution = discretisation.solve(&formulation)?;
                let predicted = halving::steps(stretch, edge, spacing, stiffness);
                cells.push(format!("{predicted} / {}", solution.work.steps));
            }
            rows.push(cells);
        }
    }
    let head = [
        "L / last closed point",
        "elements per 10 mm",
        "predicted / measured, κ₀ = 1",
        "predicted / measured, κ₀ = 1e6",
    ];
    let title = format!("{HALVING}: pin-rod, reported beside the law");
    let table = Table { title, head: head.map(String::from).into(), rows };
    Ok(Finding { tables: vec![table], ..Default::default() })
}
