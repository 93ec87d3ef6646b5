//! Two bodies that end side by side, one of whose sides is sheared: the pressure has no limit there, and grows on meshes as the scene tells.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
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
