//! Blocks of revolution that carry the tractions of a half-space: every closed form without model error.

use std::f64::consts::TAU;

use contact_vv::case::library::Indented;
use contact_vv::error::Error;
use contact_vv::measure::Quantity;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::scene::{Component, Displaced, Material, Place, Profile};
use contact_vv::solve::{Discretisation, Formulation, Run};

/// Radius of the contacts \[mm\].
const A: f64 = 2.5;
/// Height and radius of the blocks over it.
const SIZE: f64 = 8.0;

/// Profiles by their powers, and what they are in a scene.
fn profiles() -> [(&'static str, Vec<[f64; 2]>, Profile); 4] {
    let even = |coefficients: &[f64]| Profile::Even { coefficients: coefficients.into() };
    [
        ("paraboloid", vec![[0.01, 2.0]], Profile::Parabola { radius: 50.0 }),
        ("circle", Indentation::circle(50.0, 20), Profile::Circle { radius: 50.0 }),
        ("r² + r⁴", vec![[0.005, 2.0], [4e-4, 4.0]], even(&[0.005, 4e-4])),
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
