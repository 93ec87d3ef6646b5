//! A cylinder on a rigid plane: from the scene to its pressure, held against Hertz.
//!
//! `cargo run --release --example hertz`

use contact_vv::case::library::Cylinder;
use contact_vv::error::Error;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::scene::PlaneHypothesis;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

fn main() -> Result<(), Error> {
    let cylinder = Cylinder::default();
    let scene = cylinder.scene();
    let modulus = scene.bodies[0].material.plane_modulus(PlaneHypothesis::Strain);
    let hertz = Hertz { load: cylinder.load(), radius: cylinder.radius, modulus };

    let resolution = Resolution { elements: 16, refinement: 1, order: Order::Quadratic };
    let discretisation = Discretisation::of(scene, resolution)?;
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let run = Run::of(&discretisation, &formulation)?;

    println!("{}: {} after {} iterations", formulation.name(), run.solution.outcome, run.solution.work.iterations);
    println!("     x/a   p [MPa]     Hertz");
    for point in run.solution.points.iter().filter(|point| point.position <= hertz.half_width()).step_by(4) {
        let [x, p] = [point.position / hertz.half_width(), hertz.pressure(point.position)];
        println!("{x:8.3} {:9.1} {p:9.1}", point.pressure);
    }
    let measures = run.measures();
    for (name, ours, exact) in [
        ("peak pressure [MPa]", measures.peak.pressure, hertz.peak_pressure()),
        ("half-width [mm]", measures.half_width(), hertz.half_width()),
    ] {
        println!("{name}: {ours:.4}, Hertz {exact:.4} ({:+.2} %)", 100.0 * (ours / exact - 1.0));
    }
    Ok(())
}
