//! What other codes answered for bodies of revolution, held against the closed forms; `oracles/revolution/freeze.py`
//! asks them.

use std::f64::consts::TAU;

use contact_vv::error::Error;
use contact_vv::measure::Quantity;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::oracle::analytic::revolution::sphere::Sphere;
use contact_vv::oracle::cross_code::PhysicalScene;
use contact_vv::oracle::cross_code::frozen::{Asked, hash_of};
use contact_vv::oracle::cross_code::revolution::{Answer, RENEW, Revolution, folder};
use contact_vv::scene::{Material, Scene};
use contact_vv::solve::{Discretisation, Formulation, Run};

fn frozen() -> Revolution {
    Revolution::built_in().unwrap_or_else(|error| panic!("{error}"))
}

/// A scene and the finest answers, by script.
fn finest<'a>(frozen: &'a Revolution, case: &str) -> (&'a PhysicalScene, Vec<(&'a str, &'a Answer)>) {
    let Asked { scene, answers } = &frozen.scenes[case];
    (scene, answers.iter().map(|(script, of)| (script.as_str(), &of.series[of.series.len() - 1])).collect())
}

/// Sphere and material of a scene.
fn sphere(scene: &PhysicalScene) -> (Sphere, Material) {
    let number = |name: &str| scene.numbers[name];
    let material = Material { young: number("young"), poisson: number("poisson") };
    let (radius, modulus) = (number("radius"), material.young / (1.0 - material.poisson.powi(2)));
    let load = Sphere::load_for(number("a_over_r") * radius, radius, modulus);
    (Sphere { load, radius, modulus }, material)
}

/// Means over the rings round the stations.
fn around(stations: &[f64], pressure: impl Fn(f64) -> f64) -> Vec<f64> {
    let width = stations[1] - stations[0];
    let mean = |at: &f64| (0..2000).map(|k| pressure(at + width * ((f64::from(k) + 0.5) / 2000.0 - 0.5))).sum::<f64>();
    stations.iter().map(|at| mean(at) / 2000.0).collect()
}

/// An error within what it may be, with its name.
fn within(name: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value / reference - 1.0).abs();
    assert!(error <= tolerance, "{name}: {value} against {reference}, error {error:.1e}");
}

#[test]
fn frozen_answers_of_revolution_are_those_of_the_scripts() {
    let scripts = hash_of(&folder()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(frozen().scripts, scripts, "{RENEW}");
}

#[test]
fn other_codes_find_hertz_in_a_truncated_sphere() {
    let frozen = frozen();
    let (scene, answers) = finest(&frozen, "truncated-sphere");
    let (hertz, material) = sphere(scene);
    let expected = around(&scene.stations, |r| hertz.pressure(r));
    // The far face, a whole number of contact radii away, comes nearer by less than the half-space's infinity does.
    let side = scene.numbers["size"] * hertz.contact_radius();
    let sunk: f64 = (0..400)
        .map(|k| (f64::from(k) + 0.5) / 400.0 * side)
        .map(|r| TAU * r * side / 400.0 * hertz.potential(r, side).displacement(material)[1])
        .sum::<f64>()
        / (0.5 * TAU * side * side);

    assert_eq!(answers.len(), 4);
    for (script, answer) in answers {
        within(&format!("{script}, radius"), answer.physical.half_width, hertz.contact_radius(), RADIUS);
        within(&format!("{script}, peak"), answer.physical.peak, hertz.peak_pressure(), PEAK);
        within(&format!("{script}, load"), answer.physical.resultant, hertz.load, EQUILIBRIUM);
        // The boundary method has no far face.
        let approach = if script == "half_space" { hertz.approach() } else { hertz.approach() - sunk };
        within(&format!("{script}, approach"), answer.approach, approach, APPROACH);
        for (found, expected) in answer.physical.pressure.iter().zip(&expected) {
            let error = (found - expected).abs() / hertz.peak_pressure();
            assert!(error <= PROFILE, "{script}: {found} against {expected}, error {error:.1e}");
        }
    }
}

/// Radius by second moment: an edge in 24 elements on it, and penalties of 1e-4 of the approach.
const RADIUS: f64 = 2e-4;
/// Peak: fits to elements that are linear in the strain.
const PEAK: f64 = 1e-3;
/// Resultants: pulls of open gap elements, round-off elsewhere.
const EQUILIBRIUM: f64 = 1e-7;
/// Approach: flexibility of meshes eight radii wide.
const APPROACH: f64 = 2e-4;
/// Means over a tenth of the radius, over the peak: the last one has the edge in it.
const PROFILE: f64 = 5e-3;

#[test]
fn boundary_method_finds_sneddons_cone() {
    let frozen = frozen();
    let (scene, answers) = finest(&frozen, "cone");
    let [(script, answer)] = answers[..] else { panic!("one script") };
    let (hertz, slope) = (sphere(scene).0, scene.numbers["slope"]);
    let cone = Indentation::smooth(hertz.modulus, hertz.contact_radius(), vec![[slope, 1.0]]);
    let expected = around(&scene.stations, |r| cone.pressure(r));

    assert_eq!(script, "half_space");
    within("radius", answer.physical.half_width, cone.second_moment_radius(), 2e-5);
    within("load", answer.physical.resultant, cone.load(), EQUILIBRIUM);
    within("approach", answer.approach, cone.approach(), 1e-5);
    // But for the first, where it is without limit, and pixels have means of squares.
    for (found, expected) in answer.physical.pressure.iter().zip(&expected).skip(1) {
        let error = (found - expected).abs() / cone.pressure(0.5 * cone.radius);
        assert!(error <= 2e-3, "{found} against {expected}, error {error:.1e}");
    }
}

#[test]
fn other_codes_and_ours_agree_on_a_whole_sphere_beside_hertz() -> Result<(), Error> {
    let frozen = frozen();
    let (scene, answers) = finest(&frozen, "sphere");
    let (hertz, material) = sphere(scene);
    let whole = Scene::sphere_on_plane(hertz.radius, material, hertz.contact_radius());
    let resolution = Resolution { elements: 12, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(whole, resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let (measures, approach) = (run.measures(), discretisation.number(&run, 0, &Quantity::Approach)?);
    let ours = [measures.second_moment_width, measures.peak.pressure, run.transmitted(), approach];

    assert_eq!(answers.len(), 3);
    for (script, answer) in answers {
        let theirs = [answer.physical.half_width, answer.physical.peak, answer.physical.resultant, answer.approach];
        // Meshes of 12 and of 24 elements on the radius.
        let within_of = [("radius", 1e-3), ("peak", 1e-3), ("load", EQUILIBRIUM), ("approach", 5e-4)];
        for (((name, tolerance), ours), theirs) in within_of.into_iter().zip(ours).zip(theirs) {
            within(&format!("{script}, {name}"), theirs, ours, tolerance);
        }
    }
    // Half a sphere is no half-space: at a/R = 0.05 a few parts in a thousand.
    within("radius", ours[0], hertz.contact_radius(), 5e-3);
    within("peak", ours[1], hertz.peak_pressure(), 5e-3);
    Ok(())
}
