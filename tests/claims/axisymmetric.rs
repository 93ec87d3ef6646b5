//! Bodies of revolution: uniform stresses exact to round-off, Lamé's cylinder, means over rings.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use contact_vv::algorithm::Iteration;
use contact_vv::case::library::Indented;
use contact_vv::contact::Element;
use contact_vv::elasticity::element::{CellStiffness, Tabulated};
use contact_vv::elasticity::loads;
use contact_vv::measure::{Measures, larger};
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::{
    Action, BlockShape, Component, Face, Load, Material, Path as Way, PlaneHypothesis, Profile, Scene, Shape,
};
use contact_vv::solution::{EdgeState, Part, PointState};
use contact_vv::solve::{Discretisation, Formulation, Run};

use crate::workbench::{held, meshed, turned};

const ORDERS: [Order; 7] =
    [Order::Linear, Order::Quadratic, Order::Quartic, Order::Quintic, Order::Sextic, Order::Septic, Order::Octic];

/// A body from x to 3 mm, 0 to 2 mm high, of the given shape, on a rigid plane under the traction of a stress.
fn block(shape: Shape, stress: [f64; 3], loaded: &[&'static str]) -> Scene {
    turned(PlaneHypothesis::Axisymmetric, shape, Way::HORIZONTAL, 3.0, stress, loaded)
}

fn rectangle(inner: f64) -> Shape {
    Shape::Rectangle { x: [inner, 3.0], y: [0.0, 2.0], contact: Face::Bottom }
}

/// Four skewed blocks about a point that is no centre.
fn skewed() -> Shape {
    let [a, b, c, d] = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
    let [south, east, north, west, middle] = [[1.2, 0.0], [3.0, 0.9], [1.8, 2.0], [0.0, 1.2], [1.4, 0.8]];
    let block = |corners: [[f64; 2]; 4], names: [Option<&'static str>; 4]| BlockShape {
        corners,
        arcs: [None; 4],
        names: names.map(|name| name.map(Into::into)),
        elements: [2, 2],
        growth: [1.0; 2],
    };
    Shape::Blocks(vec![
        block([a, south, middle, west], [Some("contact"), None, None, None]),
        block([south, b, east, middle], [Some("contact"), Some("right"), None, None]),
        block([middle, east, c, north], [None, Some("right"), Some("far"), None]),
        block([west, middle, north, d], [None, None, Some("far"), None]),
    ])
}

#[test]
fn uniform_stresses_of_bodies_of_revolution_are_exact() {
    for (name, stress, loaded) in
        [("axial", [0.0, -7.0, 0.0], &["far"][..]), ("hydrostatic", [-7.0, -7.0, 0.0], &["far", "right"])]
    {
        for (poisson, order) in ORDERS.into_iter().flat_map(|order| [(0.3, order), (0.499, order)]) {
            for shape in [rectangle(0.0), skewed()] {
                let mut scene = block(shape, stress, loaded);
                scene.bodies[0].material.poisson = poisson;
                let discretisation = meshed(scene, 2, order);
                let run =
                    Run::of(&discretisation, &Formulation::new(Element::Line, Iteration::Kinematic)).expect("solved");
                let fields = discretisation.recover(&run.solution).expect("recovered");
                let hoop = discretisation.stress_across(&fields);
                let case = format!("{name}, ν = {poisson}, {order:?}");
                for (found, hoop) in fields.stress.iter().zip(hoop) {
                    for (found, wanted) in found.iter().chain([&hoop]).zip([stress[0], stress[1], 0.0, stress[0]]) {
                        assert!(
                            (found - wanted).abs() <= 1e-9 * 7.0 / (1.0 - 2.0 * poisson),
                            "{case}: {found} {wanted}"
                        );
                    }
                }
                for point in &run.solution.points {
                    assert_relative_eq!(point.pressure, 7.0, max_relative = 1e-9);
                }
                let whole = PI * 9.0 * 7.0;
                assert_relative_eq!(run.transmitted(), whole, max_relative = 1e-9);
                assert!(run.imbalance() <= 1e-9, "{case}");
            }
        }
    }
}

#[test]
fn a_whole_force_is_spread_evenly_over_the_area_of_its_side() {
    let (radius, pressure) = (3.0, 7.0);
    let area = PI * radius * radius;
    for (order, element) in ORDERS.into_iter().flat_map(|order| Element::ALL.map(|element| (order, element))) {
        let mut scene = block(skewed(), [0.0; 3], &[]);
        let action = Action::Total([0.0, -pressure * area]);
        scene.bodies[0].loads = vec![Load::OnSide { boundary: "far".into(), part: None, action }];
        let discretisation = meshed(scene, 2, order);
        // The springs of layers differ from edge to edge, and are iterated.
        let formulation = Formulation::new(element, Iteration::Kinematic).tolerance(1e-11);
        let run = Run::of(&discretisation, &formulation).expect("solved");
        let case = format!("{element:?}, {order:?}");
        assert_relative_eq!(run.transmitted(), pressure * area, max_relative = 1e-9);
        for point in &run.solution.points {
            assert!((point.pressure / pressure - 1.0).abs() <= 1e-9, "{case}: {point:?}");
            // None without an area: a node on the axis has one in linear cells alone, a third of that of its ring.
            assert!(point.weight > 1e-3 * area / run.solution.points.len() as f64, "{case}: {point:?}");
        }
        let counted = run.measures().half_width_nodes;
        assert!((counted / radius - 1.0).abs() <= 1e-9, "{case}: counted {counted}");
    }
}

#[test]
fn the_weight_of_a_body_of_revolution_is_that_of_its_volume_about_either_axis() {
    // Guldin: 2π times the radius of the section's centroid times its area.
    let shape = || Shape::Rectangle { x: [1.0, 3.0], y: [4.0, 9.0], contact: Face::Bottom };
    for (plane, along, radius) in
        [(PlaneHypothesis::Axisymmetric, 1, 2.0), (PlaneHypothesis::AxisymmetricAboutX, 0, 6.5)]
    {
        let path = Way::Straight { origin: [2.0, 4.0], both_sides: true };
        let mut scene = turned(plane, shape(), path, 1.0, [0.0; 3], &[]);
        let mut density = [0.0; 2];
        density[along] = -1e-3;
        scene.bodies[0].loads = vec![Load::BodyForce(density)];
        for order in ORDERS {
            let mesh = Mesh::of(&scene, Resolution { elements: 2, refinement: 0, order }).expect("meshed");
            let forces = loads::at_nodes(&scene, &mesh, 0).expect("forces");
            let weight: f64 = forces.iter().map(|force| force[along]).sum();
            assert_relative_eq!(weight, -1e-3 * TAU * radius * 10.0, max_relative = 1e-12);
        }
    }
}

#[test]
fn hoop_strain_on_the_axis_is_the_radial_one() {
    // Of u_r = εr: σ_r = Eε/((1 + ν)(1 − 2ν)) and σ_z = 2νσ_r, wherever r is.
    let (material, strain) = (Material::STEEL, 1e-3);
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
    let moved = points.map(|[r, _]| [strain * r, 0.0]);
    let nu = material.poisson;
    let radial = material.young * strain / ((1.0 + nu) * (1.0 - 2.0 * nu));
    let kernel = CellStiffness::of(Order::Linear, &material, PlaneHypothesis::Axisymmetric, 1.0);
    let places = [[-1.0, 0.3], [0.4, 0.3]].map(|at| Tabulated::of(points.len(), at));
    for stress in kernel.stresses(&points, &moved, &places).expect("a sound cell") {
        assert_relative_eq!(stress[0], radial, max_relative = 1e-12);
        assert_relative_eq!(stress[1], 2.0 * nu * radial, max_relative = 1e-12);
    }
}

#[test]
fn the_axis_exerts_nothing_on_a_body_of_revolution() {
    // Hoop stresses press on the axis from all sides, which cancel.
    for order in ORDERS {
        let discretisation = meshed(Indented::by_sphere(0.05).scene(), 2, order);
        let run = Run::of(&discretisation, &Formulation::new(Element::Node, Iteration::Kinematic)).expect("solved");
        let reactions = discretisation.reactions(1.0, &run.solution).expect("reactions");
        assert_eq!(reactions.len(), 1, "the support of the axis");
        assert!(reactions[0].force.abs() <= 1e-9 * run.transmitted(), "{order:?}: {:?}", reactions[0]);
    }
}

/// Measures of so many rings on a radius with the means of a pressure over their areas; `force(r)` is that within r,
/// over 2π.
fn of_rings(count: usize, radius: f64, force: impl Fn(f64) -> f64) -> Measures {
    let ends = |k: usize| [k, k + 1].map(|k| radius * k as f64 / count as f64);
    let ring = |k: usize| {
        let [a, b] = ends(k);
        let area = 0.5 * (b - a) * (b + a);
        EdgeState { ends: [a, b], weight: TAU * area, pressure: (force(b) - force(a)) / area, axis: Some(0.0) }
    };
    let edges: Vec<EdgeState> = (0..count).map(ring).collect();
    let point = |edge: &EdgeState| PointState {
        position: edge.position(),
        weight: edge.weight,
        pressure: edge.pressure,
        gap: 0.0,
    };
    let points: Vec<PointState> = edges.iter().map(point).collect();
    Measures::of(&block(rectangle(0.0), [0.0; 3], &[]), 0, Part { points: &points, edges: &edges, nodes: 3 })
}

#[test]
fn means_over_rings_are_means_over_their_areas() {
    // p = 1 + r − r², ∫ p r dr = r²/2 + r³/3 − r⁴/4: 1 on the axis, 1.25 at r = 0.5.
    let humped = of_rings(30, 1.5, |r| r * r * (0.5 + r / 3.0 - 0.25 * r * r));
    assert_relative_eq!(humped.peak.pressure, 1.25, max_relative = 1e-10);
    assert_relative_eq!(humped.peak.position, 0.5, max_relative = 1e-6);

    // p = 3/2 √(1 − r)/r up to 1: the force beyond r is (1 − r)^{3/2}, whose 2/3-th power falls along a line to 0.
    let smooth = of_rings(43, 2.0, |r| 1.0 - (1.0 - r).max(0.0).powf(1.5));
    assert_relative_eq!(smooth.edge(), 1.0, max_relative = 1e-9);

    // A semi-ellipsoid of radius 1.
    let force = |r: f64| (1.0 - (1.0 - r * r).max(0.0).powf(1.5)) / 3.0;
    let hertz = of_rings(43, 2.0, force);
    assert_relative_eq!(hertz.peak.pressure, 1.0, max_relative = 1e-5);
    assert_relative_eq!(hertz.pressure_at_origin, 1.0, max_relative = 1e-5);
    // The force beyond r is (1 − r²)^{3/2}, whose 2/3-th power falls along a line over r² from the axis on, however few
    // the rings.
    for (count, radius) in [(43, 2.0), (5, 1.6), (6, 1.3), (8, 1.3)] {
        assert_relative_eq!(of_rings(count, radius, force).edge(), 1.0, max_relative = 1e-9);
    }
}

/// Largest errors of `[σ_r, σ_θ, σ_z]` of a ring under inner pressure, of so many cells across, over the pressure.
fn errors_of_lame(cells: usize, order: Order) -> [f64; 3] {
    // σ_r = A − B/r², σ_θ = A + B/r², A = p a²/(b² − a²), B = A b², and σ_z = 0 at the free ends.
    let (inner, outer, pressure): (f64, f64, f64) = (1.5, 3.0, 10.0);
    let ring = Shape::Blocks(vec![BlockShape {
        corners: [[inner, 0.0], [outer, 0.0], [outer, 2.0], [inner, 2.0]],
        arcs: [None; 4],
        names: [Some("contact".into()), None, Some("far".into()), Some("left".into())],
        elements: [cells, 1],
        growth: [1.0; 2],
    }]);
    let mut scene = block(ring, [-pressure, 0.0, 0.0], &["left"]);
    scene.bodies[0].supports = vec![held("far", Component::Y, 0.0)];
    scene.contacts[0].profile = Profile::Uniform(1.0);
    let discretisation = meshed(scene, 2, order);
    let run = Run::of(&discretisation, &Formulation::new(Element::Line, Iteration::Kinematic)).expect("solved");
    let fields = discretisation.recover(&run.solution).expect("recovered");
    let hoop = discretisation.stress_across(&fields);
    let mean = inner * inner / (outer * outer - inner * inner);
    let mut errors = [0.0_f64; 3];
    for ((point, stress), hoop) in discretisation.mesh.points.iter().zip(&fields.stress).zip(hoop) {
        let varying = mean * (outer / point[0]).powi(2);
        let exact = [mean - varying, mean + varying, 0.0];
        for ((error, found), exact) in errors.iter_mut().zip([stress[0], hoop, stress[1]]).zip(exact) {
            *error = larger(*error, (found / pressure - exact).abs());
        }
    }
    errors
}

#[test]
fn a_thick_cylinder_under_inner_pressure_is_lames() {
    let [coarse, fine] = [4, 8].map(|cells| errors_of_lame(cells, Order::Quadratic));
    let octic = errors_of_lame(4, Order::Octic);
    for k in 0..3 {
        // Stresses of 8-node cells at nodes fall nearly with the square of the cells.
        assert!(coarse[k] >= 3.0 * fine[k] && fine[k] <= 0.02, "{coarse:?} {fine:?}");
        assert!(octic[k] <= 1e-5, "{octic:?}");
    }
}

#[test]
fn a_sphere_costs_what_a_cylinder_does() {
    // On the same mesh: the matrix has the same entries, for a node on the axis moves along it alone in both.
    let of = |scene: Scene| {
        let resolution = Resolution { elements: 8, refinement: 2, order: Order::Quadratic };
        let discretisation = Discretisation::of(scene, resolution).expect("meshed");
        let solution = discretisation.solve(&Formulation::verification()).expect("solved");
        let condensed = &discretisation.condensed;
        let sizes = [discretisation.system.dofs(), condensed.retained(), condensed.factor_entries()];
        (sizes, condensed.operations(), solution.work.iterations)
    };
    let plane = of(Scene::cylinder_on_plane(50.0, Material::STEEL, 0.5));
    let turned = of(Scene::sphere_on_plane(50.0, Material::STEEL, 0.5));
    assert_eq!(turned.0, plane.0);
    assert_relative_eq!(turned.1, plane.1, max_relative = 1e-12);
    assert!(turned.2 <= plane.2 + 2, "{} iterations for {}", turned.2, plane.2);
}
