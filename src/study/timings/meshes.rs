//! The meshes the scenes have by default, and what coarser and finer ones away from the contact would change.

use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::Resolution;
use crate::scene::Grading;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::timings::judge::TIMINGS;
use crate::study::unsorted::{Finding, Table, Trial};

/// Growth along the surface and into the depth, and the coarsest element over the body, of the meshes tried.
const TRIED: [[f64; 3]; 4] = [[1.3, 1.25, 0.1], [1.5, 1.4, 0.2], [1.7, 1.6, 0.3], [2.0, 1.8, 0.5]];
/// How many times finer the mesh is that stands for the truth.
const FINER: usize = 4;
/// Error a default mesh may have in the peak and in the half-width: half of what the rows on Hertz and Persson ask.
const ACCEPTED: f64 = 5e-4;

/// One trial a scene.
pub fn trials() -> Vec<Trial> {
    let trial = |name: &'static str| {
        Trial::new(TIMINGS, format!("default mesh, {name}"), move || judged(&problem::problem(name, None)?))
    };
    ["cylinder", "truncated-hertz", "pin-rod", "pin-plate"].map(trial).into()
}

/// The mesh of a problem against one much finer, and others beside it.
pub fn judged(problem: &Problem) -> Result<Finding, Error> {
    let own = problem.scene.grading;
    let elements = problem.resolution.elements;
    let truth = solved(problem, own, FINER * elements)?;
    let apart = |run: &Run| {
        let (found, wanted) = (&run.measures(), &truth.measures());
        [found.peak.pressure / wanted.peak.pressure - 1.0, found.half_width / wanted.half_width - 1.0]
    };
    let row = |kind: String, run: &Run| {
        let percent = apart(run).map(|error| format!("{:+.3} %", 100.0 * error));
        [vec![kind, run.freedoms.to_string()], percent.into()].concat()
    };
    let default = solved(problem, own, elements)?;
    let mut rows = vec![row(format!("**{}**", told(&own)), &default)];
    for [along, depth, coarsest] in TRIED {
        let tried = Grading { along, depth, coarsest, ..own };
        if told(&tried) != told(&own) {
            rows.push(row(told(&tried), &solved(problem, tried, elements)?));
        }
    }
    let [peak, half_width] = apart(&default).map(f64::abs);
    let largest = if peak.is_nan() || half_width.is_nan() { f64::NAN } else { peak.max(half_width) };
    let head = ["growth along, into the depth, coarsest", "freedoms", "peak", "half-width or angle"];
    let title = format!(
        "{}, {elements} elements; errors against {FINER} times as many, {} freedoms",
        problem.name, truth.freedoms
    );
    Ok(Finding {
        checks: vec![Judged::norm(
            "The default mesh shall be fine enough for the rows that judge its scene",
            "largest error of peak and half-width",
            largest,
            Reference::own("the finer mesh", 0.0),
            ACCEPTED,
            format!("half of the {} % that the Hertz rows ask", 200.0 * ACCEPTED),
        )],
        tables: vec![Table { title, head: head.map(String::from).into(), rows }],
        ..Default::default()
    })
}

fn told(grading: &Grading) -> String {
    format!("{}, {}, {}", grading.along, grading.depth, grading.coarsest)
}

fn solved(problem: &Problem, grading: Grading, elements: usize) -> Result<Run, Error> {
    let mut scene = problem.scene.clone();
    scene.grading = grading;
    let resolution = Resolution { elements, ..problem.resolution };
    Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification())
}
