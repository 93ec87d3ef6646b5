//! What is frozen besides the runs of the paper's scenes: every mesh, every number of the scene files, of meshes fitted
//! to their contacts and of some random scenes.
//!
//! A change that leaves all truths within their tolerances shows here.

use std::fmt::Write;
use std::path::Path;

use contact_vv::accuracy::{Bars, Told, bars};
use contact_vv::case::Case;
use contact_vv::case::file::files_in;
use contact_vv::case::library::{NAMES, find};
use contact_vv::error::Error;
use contact_vv::markdown::significant;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::Order;
use contact_vv::scene::Scene;
use contact_vv::solve::{Discretisation, Fitted, Formulation, Run};
use contact_vv::study::promised::bars::setup;
use contact_vv::study::random::family::{self, FAMILIES};
use contact_vv::study::random::{Family, Sample, Site};
use libtest_mimic::{Failed, Trial};

/// First scenes of a family that are frozen on meshes fitted to their contact too.
const FITTED: usize = 3;
/// Digits of coordinates, of numbers, and of their bars.
const DIGITS: [usize; 3] = [8, 5, 2];
/// Part of the largest number of its kind below which one is round-off.
const ROUND_OFF: f64 = 1e-6;

/// Names of the snapshots.
pub fn names() -> Vec<String> {
    let random = FAMILIES.map(|family| format!("random@{}.snap", family.name()));
    ["meshes.snap", "scene-files.snap", "fitted.snap"].map(String::from).into_iter().chain(random).collect()
}

/// The trials.
pub fn trials() -> Vec<Trial> {
    let random = |family: Family| Trial::test(format!("snapshot, random × {}", family.name()), move || random(family));
    let mut trials = vec![
        Trial::test("snapshot, meshes of all scenes", || freeze("meshes", None, meshes()?)),
        Trial::test("snapshot, numbers of the scene files", || freeze("scene-files", None, scene_files()?)),
        Trial::test("snapshot, meshes fitted to the contact", || freeze("fitted", None, fitted()?)),
    ];
    trials.extend(FAMILIES.map(random));
    trials
}

/// Compares a text with its snapshot.
pub fn freeze(name: &str, suffix: Option<&str>, text: String) -> Result<(), Failed> {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    if let Some(suffix) = suffix {
        settings.set_snapshot_suffix(suffix);
    }
    settings.bind(|| insta::assert_snapshot!(name, text));
    Ok(())
}

/// The worked scene files whose mesh is given by its numbers.
fn files() -> Result<Vec<Case>, Failed> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let files = files_in(&folder).map_err(said)?;
    let cases = files.iter().map(|file| Case::read(file)).collect::<Result<Vec<_>, _>>().map_err(said)?;
    Ok(cases.into_iter().filter(|case| case.accuracy.is_none()).collect())
}

/// Cells, candidates and moments of every body's mesh.
fn meshes() -> Result<String, Failed> {
    let mut text = String::new();
    for (name, _) in NAMES {
        let case = find(name, None).map_err(said)?;
        moments(&mut text, name, &case.scene, &Mesh::of(&case.scene, case.resolution).map_err(said)?);
    }
    for case in files()? {
        moments(&mut text, &case.name, &case.scene, &Mesh::of(&case.scene, case.resolution).map_err(said)?);
    }
    Ok(text)
}

/// A line for each body.
fn moments(text: &mut String, name: &str, scene: &Scene, mesh: &Mesh) {
    for (body, part) in scene.bodies.iter().zip(&mesh.bodies) {
        let points = &mesh.points[part.nodes.clone()];
        let mean = |of: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
        let size = mean(&|[x, y]| x.hypot(*y));
        let moments = [mean(&|p| p[0]), mean(&|p| p[1]), mean(&|p| p[0] * p[1]) / size];
        let squares = [mean(&|p| p[0] * p[0]).sqrt(), mean(&|p| p[1] * p[1]).sqrt()];
        let numbers = [moments.as_slice(), squares.as_slice()].concat();
        let numbers: Vec<String> = numbers.into_iter().map(|one| rounded(one, size, DIGITS[0])).collect();
        let (cells, candidates) = (part.cells.len(), part.candidates.len());
        let _ = writeln!(text, "{name}, {}: {cells} cells, {candidates} candidates, {}", body.name, numbers.join(", "));
    }
}

/// Meshes fitted to the contacts of library and scene files, and what they say; which scenes are refused.
fn fitted() -> Result<String, Failed> {
    let mut text = String::new();
    for (name, _) in NAMES {
        fit(&mut text, name, &find(name, None).map_err(said)?.scene)?;
    }
    for case in files()? {
        fit(&mut text, &case.name, &case.scene)?;
    }
    Ok(text)
}

/// Lines of a mesh fitted to the contacts of a scene.
fn fit(text: &mut String, name: &str, scene: &Scene) -> Result<(), Failed> {
    let mesh = Fitted { order: Order::Quartic, layers: 1 };
    let Ok(answer) = mesh.solve(scene, &Formulation::verification()) else {
        let _ = writeln!(text, "{name}: refused");
        return Ok(());
    };
    let scene = &answer.discretisation.scene;
    moments(text, name, scene, &answer.discretisation.mesh);
    let found = bars(&answer.discretisation, &answer.run, &[]).map_err(said)?;
    told(text, name, scene, &answer.run, &found);
    Ok(())
}

/// Every number of the scene files, with its bar.
fn scene_files() -> Result<String, Failed> {
    let mut text = String::new();
    for case in files()? {
        let (meshed, run) = case.solve().map_err(said)?;
        let found = bars(&meshed.discretisation, &run, &case.displaced()).map_err(said)?;
        told(&mut text, &case.name, &meshed.discretisation.scene, &run, &found);
    }
    Ok(text)
}

/// Meshes and numbers of some random scenes of a family, of the first of them on fitted meshes too.
fn random(family: Family) -> Result<(), Failed> {
    let mut text = String::new();
    for site in family::chosen(family) {
        solved(&mut text, &site, &site.sample().map_err(said)?).map_err(said)?;
    }
    for site in family::unseen(family).take(FITTED) {
        fit(&mut text, &format!("{}, fitted", site.key()), &site.sample().map_err(said)?.scene)?;
    }
    freeze("random", Some(family.name()), text)
}

/// Lines of a scene on the mesh that its bars are tested with.
fn solved(text: &mut String, site: &Site, sample: &Sample) -> Result<(), Error> {
    let (scene, resolution, formulation) = setup(site, sample);
    let discretisation = Discretisation::of(scene, resolution)?;
    let scene = &discretisation.scene;
    moments(text, &site.key(), scene, &discretisation.mesh);
    let run = Run::of(&discretisation, &formulation)?;
    let found = bars(&discretisation, &run, &sample.displaced())?;
    told(text, &site.key(), scene, &run, &found);
    Ok(())
}

/// Lines of a run.
fn told(text: &mut String, name: &str, scene: &Scene, run: &Run, found: &Bars) {
    let (iterations, outcome) = (run.solution.work.iterations, &run.solution.outcome);
    let _ = writeln!(text, "{name}, {}: {outcome}, {iterations} iterations, {} dofs", run.formulation.name(), run.dofs);
    let named: Vec<(Told, f64, f64)> =
        found.all.iter().map(|one| (Told::of(scene, run, one), one.value, one.bar.total())).collect();
    for (told, value, bar) in &named {
        let alike = named.iter().filter(|(other, ..)| other.unit == told.unit);
        let size = alike.map(|(_, value, _)| value.abs()).filter(|value| value.is_finite()).fold(0.0, f64::max);
        let [value, bar] = [(*value, DIGITS[1]), (*bar, DIGITS[2])].map(|(one, digits)| rounded(one, size, digits));
        let _ = writeln!(text, "  {}, {}: {value} ± {bar}", told.of, told.quantity);
    }
}

/// A number by its digits; 0 where it is round-off of others.
fn rounded(value: f64, size: f64, digits: usize) -> String {
    if value.abs() <= ROUND_OFF * size { "0".into() } else { significant(value, digits) }
}

fn said(error: Error) -> Failed {
    Failed::from(error.to_string())
}
