//! Blocks of revolution that carry the tractions of a half-space: every closed form without model error.

use std::f64::consts::TAU;

use contact_vv::case::library::Indented;
use contact_vv::error::Error;
use contact_vv::measure::Quantity;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::oracle::analytic::revolution::sphere::Sphere;
use contact_vv::scene::{Component, Displaced, Material, Place, Profile};
use contact_vv::solve::{Discretisation, Formulation, Run};

use crate::balance::scene;
use crate::workbench::told;

/// Radius of the contacts \[mm\].
const A: f64 = 2.5;
/// Height and radius of the blocks over it.
const SIZE: f64 = 8.0;

/// Profiles by their powers, and what they are in a scene.
fn profiles() -> [(&'static str, Vec<[f64; 2]>, Profile); 5] {
    let even = |coefficients: &[f64]| Profile::Even { coefficients: coefficients.into() };
    [
        ("paraboloid", vec![[0.01, 2.0]], Profile::Parabola { radius: 50.0 }),
        ("circle", Indentation::circle(50.0, 20), Profile::Circle { radius: 50.0 }),
        ("r² + r⁴", vec![[0.005, 2.0], [4e-4, 4.0]], even(&[0.005, 4e-4])),
        ("r^2.7", vec![[4e-3, 2.7]], Profile::Powers { terms: [[4e-3, 2.7]].into() }),
        ("cone", vec![[0.02, 1.0]], Profile::Wedge { slope: 0.02 }),
    ]
}

#[test]
fn truncated_blocks_of_revolution_are_their_closed_forms() -> Result<(), Error> {
    for (name, powers, profile) in profiles() {
        let indented = Indented::to(A, powers, profile);
        let (contact, side) = (&indented.contact, SIZE * A);
        let sunk = |r: f64| contact.potential(r, side).displacement(Material::STEEL)[1];
        let mean = (0..40).map(|k| (f64::from(k) + 0.5) / 40.0 * side).map(|r| TAU * r * side / 40.0 * sunk(r));
        let sunk = mean.sum::<f64>() / (0.5 * TAU * side * side);
        let resolution = Resolution { elements: 16, refinement: 0, order: Order::Quadratic };
        let discretisation = Discretisation::of(indented.scene(), resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;

        assert!(run.solution.converged(), "{name}");
        let measures = run.measures();
        // The far face comes nearer by less than the half-space's infinity does.
        let far = Displaced { body: 0, at: Place::Boundary("far".into()), component: Component::Y };
        let approach = -discretisation.number(&run, 0, &Quantity::Displacement(far))?;
        // 8-node cells, 16 on the radius.
        let numbers = [
            ("load", run.transmitted(), contact.load(), 1e-9),
            ("radius", measures.second_moment_width, contact.second_moment_radius(), 5e-4),
            ("peak", measures.peak.pressure, contact.peak_pressure(), 5e-4),
            ("approach", approach, contact.approach() - sunk, 1e-4),
        ];
        for (what, value, reference, tolerance) in numbers {
            let error = (value / reference - 1.0).abs();
            // Below the tip of a cone the pressure is without limit.
            assert!(reference == f64::INFINITY || error <= tolerance, "{name}, {what}: {value} against {reference}");
        }
    }
    Ok(())
}

#[test]
fn stresses_on_the_axis_below_a_solved_sphere_are_hubers() -> Result<(), Error> {
    let paraboloid = Profile::Parabola { radius: 50.0 };
    let indented = Indented::to(A, vec![[0.01, 2.0]], paraboloid);
    let contact = &indented.contact;
    let sphere = Sphere { load: contact.load(), radius: 50.0, modulus: contact.modulus };
    let resolution = Resolution { elements: 8, refinement: 0, order: Order::Sextic };
    let discretisation = Discretisation::of(indented.scene(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let fields = discretisation.recover(&run.solution)?;
    let hoop = discretisation.stress_across(&fields);
    let mut seen = 0;
    for ((point, stress), hoop) in discretisation.mesh.points.iter().zip(&fields.stress).zip(hoop) {
        let [r, depth] = *point;
        // Closer to the surface stresses at nodes feel the end of the contact, and farther away they are small.
        if r > 0.0 || !(0.2 * A..3.0 * A).contains(&depth) {
            continue;
        }
        seen += 1;
        let [axial, radial] = sphere.on_axis(depth, Material::STEEL.poisson);
        for (found, wanted) in [(stress[1], axial), (stress[0], radial), (hoop, radial), (stress[2], 0.0)] {
            let error = (found - wanted).abs() / sphere.peak_pressure();
            assert!(error <= 2e-3, "{depth}: {found} for {wanted}, {error:e}");
        }
    }
    assert!(seen > 20, "{seen} nodes");
    Ok(())
}

#[test]
fn powers_of_a_scene_file_are_their_transform() {
    let case = scene("power", &[]);
    let a = told(&case, &Quantity::HalfWidth);
    // δ = w(a) = a ∫ g'(a sin φ) dφ and F = 2E* ∫ (δ − w) dt, by the midpoint rule.
    let slope = |r: f64| 0.01 * 2.5 * r.powf(1.5) + 0.002 * 1.5 * r.sqrt();
    let w = |t: f64| {
        let at = |k: i32| (std::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5) / 400.0).sin();
        t * (0..400).map(|k| slope(t * at(k))).sum::<f64>() * std::f64::consts::FRAC_PI_2 / 400.0
    };
    let modulus = 210e3 / 0.91;
    let under = (0..2000).map(|k| w(a) - w(a * (f64::from(k) + 0.5) / 2000.0)).sum::<f64>() * a / 2000.0;
    assert!((2.0 * modulus * under / 500.0 - 1.0).abs() <= 1e-4, "{under}");
    assert!((told(&case, &Quantity::Approach) / w(a) - 1.0).abs() <= 1e-4);

    // In metres the same: c has the unit of length^(1 − n).
    let c = |c: f64, n: f64| c * 1e-3_f64.powf(1.0 - n);
    let terms = format!("[[{:e}, 2.5], [{:e}, 1.5]]", c(0.01, 2.5), c(0.002, 1.5));
    let metres = scene(
        "power",
        &[
            ["[[0.01, 2.5], [0.002, 1.5]]", &terms],
            ["plane = ", "units = { length = \"m\" }\nplane = "],
            ["[0, 20]", "[0, 0.02]"],
            ["stretch = 2", "stretch = 0.002"],
            ["per = 1", "per = 0.001"],
        ],
    );
    assert!((told(&metres, &Quantity::HalfWidth) / a - 1.0).abs() <= 1e-9);
    assert!((metres.scene.contacts[0].gap(1.3) / case.scene.contacts[0].gap(1.3) - 1.0).abs() <= 1e-12);
}
