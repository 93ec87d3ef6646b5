//! Two bodies that end side by side, one of whose sides is sheared: the pressure has no limit there, and grows on
//! meshes as the scene tells.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use contact_vv::elasticity::stress;
use contact_vv::mesh::{Order, Resolution};

use crate::balance::solved_on;
use crate::workbench::{kinematic, parsed};

const BLOCKS: &str = r#"
plane = "strain"
thickness = 1
[[body]]
name = "upper"
young = 210e3
poisson = 0.3
shape = { rectangle = { x = [0, 20], y = [0, 30], contact = "bottom" } }
supports = [{ at = "left", component = "x" }]
loads = [{ traction = { at = "far", value = [0, -100] } }, { traction = { at = "right", value = [0, -20] } }]
[[body]]
name = "lower"
young = 70e3
poisson = 0.2
shape = { rectangle = { x = [0, 20], y = [-30, 0], contact = "top" } }
supports = [{ at = "left", component = "x" }, { at = "far", component = "y" }]
[contact]
first = "upper"
second = "lower"
gap = { uniform = 0 }
stretch = 20
[mesh]
per = 20
elements = 8
"#;

/// `p = c ln 1/r` with `c = (4τ/π) (1/E₁)/(1/E₁ + 1/E₂)` of the plane moduli, so that every halving adds `c ln 2`.
#[test]
fn the_pressure_beside_a_sheared_side_of_one_of_two_bodies_grows_by_its_share_of_the_compliance() {
    let case = parsed(BLOCKS);
    let compliances = [(1.0 - 0.3 * 0.3) / 210e3, (1.0 - 0.2 * 0.2) / 70e3];
    let truth = 80.0 / PI * 2.0_f64.ln() * compliances[0] / (compliances[0] + compliances[1]);
    let [coarse, fine] = [16, 32].map(|elements| {
        let resolution = Resolution { elements, refinement: 0, order: Order::Quartic };
        let (discretisation, run) = solved_on(case.scene.clone(), resolution, &kinematic());
        let peak = run.measures().peak.pressure;
        let found = run.with_limits(&discretisation).expect("meshes").contacts[0].unbounded.expect("no limit");
        assert_abs_diff_eq!(found.growth * peak, truth, epsilon = 1e-9);
        peak
    });
    assert_abs_diff_eq!(fine - coarse, truth, epsilon = 0.1);
}

/// `σ = (2τ/π) ln 1/r` along a side on which a shear stress τ ends, and twice that beside a line of symmetry, so that
/// every halving adds that times ln 2; a leap as on the side it is.
#[test]
fn the_stress_where_a_shear_stress_ends_grows_by_its_leap() {
    let ending = BLOCKS.replace(
        r#"{ traction = { at = "right", value = [0, -20] } }"#,
        r#"{ traction = { at = "far", part = { along = "x", from = 0, to = 10 }, value = [30, 0] } }"#,
    );
    let case = parsed(&ending);
    let ends = [([10.0, 30.0], 60.0 / PI), ([0.0, 30.0], 120.0 / PI)];
    let of = |refinement: u32| {
        let resolution = Resolution { elements: 8, refinement, order: Order::Quartic };
        let (discretisation, run) = solved_on(case.scene.clone(), resolution, &kinematic());
        let displacement = discretisation.displacement_under(run.share(), &run.solution);
        let told = discretisation.without_limit(&run, &displacement, 0).expect("told");
        let stress = stress::at_nodes(&discretisation.scene, &discretisation.mesh, &displacement).expect("stress");
        ends.map(|(at, _)| {
            let end = told.iter().find(|one| one.at == at).expect("told");
            assert_eq!(end.because, "a shear stress on a side that ends");
            stress[end.nodes[0]][0]
        })
    };
    let [coarse, fine] = [1, 2].map(of);
    for (k, (_, c)) in ends.into_iter().enumerate() {
        let grown = (fine[k] - coarse[k]).abs();
        assert_abs_diff_eq!(grown, c * 2.0_f64.ln(), epsilon = 0.02);
    }
}
