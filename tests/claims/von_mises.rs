//! The largest von Mises stress of a body against closed forms with its bar, and places at which it is no number.

use std::f64::consts::{LN_2, PI};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::{self, Asked, Barred, Quantity, bars};
use contact_vv::case::Case;
use contact_vv::case::library::{self, PressFit};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::scene::{Action, Load, Material, PlaneHypothesis, Scene, VectorField};
use contact_vv::solve::{Discretisation, Formulation, Run, VonMises, shapes};
use contact_vv::study::promised::bars::setup;
use contact_vv::study::random::{Family, Site};
use rayon::prelude::*;

use crate::balance::{scene, solved_on};
use crate::scene_file::case;
use crate::workbench::{block_text, kinematic, parsed, resolution};

/// `√(3/2 s : s)` of the deviator s \[MPa\]: von Mises 1913.
fn von_mises([x, y, xy]: [f64; 3], z: f64) -> f64 {
    let mean = (x + y + z) / 3.0;
    let normal: f64 = [x, y, z].iter().map(|stress| (stress - mean).powi(2)).sum();
    (1.5 * (normal + 2.0 * xy * xy)).sqrt()
}

/// Stress across the plane \[MPa\]: none, or what keeps the thickness by Hooke's law.
fn across([x, y, _]: [f64; 3], plane: PlaneHypothesis, material: &Material) -> f64 {
    match plane {
        PlaneHypothesis::Stress => 0.0,
        _ => material.poisson * (x + y),
    }
}

/// A run of a scene, told which of its peaks have no limit.
fn solved(scene: Scene, resolution: Resolution, formulation: &Formulation) -> (Discretisation, Run) {
    let (discretisation, run) = solved_on(scene, resolution, formulation);
    let run = run.with_limits(&discretisation).expect("told");
    (discretisation, run)
}

/// The largest stress of a body among all numbers with their bars; none where it has none.
fn of_body(all: &[Barred], body: usize) -> Option<&Barred> {
    all.iter().find(|one| one.quantity == Quantity::VonMises { body })
}

#[test]
fn largest_stresses_of_pressed_rings_are_those_of_lame() {
    for plane in [PlaneHypothesis::Stress, PlaneHypothesis::Strain] {
        let case = PressFit { plane, ..PressFit::default() };
        let PressFit { inner, interface, outer, materials, .. } = case;
        let [a, b, c] = [inner, interface, outer].map(|radius| radius.powi(2));
        for (order, elements) in [(Order::Linear, 24), (Order::Quadratic, 8), (Order::Quadratic, 12)] {
            let resolution = Resolution { elements, refinement: 0, order };
            let (discretisation, run) = solved(case.scene(), resolution, &Formulation::verification());
            let all = bars(&discretisation, &run, &[]).expect("bars").all;
            let pressure = run.contacts[0].measures.peak.pressure;
            // Radial and hoop stress at the bore of the inner ring, and at that of the outer one.
            let states = [[0.0, -2.0 * pressure * b / (b - a)], [-pressure, pressure * (c + b) / (c - b)]];
            for (body, [radial, hoop]) in states.into_iter().enumerate() {
                let plane_state = [radial, hoop, 0.0];
                let truth = von_mises(plane_state, across(plane_state, plane, &materials[body]));
                let found = of_body(&all, body).expect("told");
                let (error, bar) = ((found.value - truth).abs(), found.bar.total());
                assert!(
                    error <= bar && bar <= 0.3 * truth,
                    "{plane:?} {order:?} {elements} {body}: {error} of {bar}, {truth}"
                );
            }
        }
    }
}

/// The largest von Mises stress that a field has in a body, at places of its cells.
fn of_field(discretisation: &Discretisation, body: usize, VectorField(field): &VectorField<3>) -> f64 {
    const PARTS: usize = 8;
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let natural = |k: usize| 2.0 * (k as f64 + 0.5) / PARTS as f64 - 1.0;
    let nodes = mesh.order.nodes_per_cell();
    let places = (0..PARTS).flat_map(|i| (0..PARTS).map(move |j| [natural(i), natural(j)]));
    let weights: Vec<Vec<f64>> = places.map(|place| shapes(nodes, place)).collect();
    let value = |point: [f64; 2]| {
        let tensor = field(point);
        von_mises(tensor, across(tensor, scene.plane, &scene.bodies[body].material))
    };
    let inside = |cell: &[usize], weights: &[f64]| {
        [0, 1].map(|k| cell.iter().zip(weights).map(|(&node, weight)| weight * mesh.points[node][k]).sum())
    };
    // Where the cell has nothing large at its middle, there is nothing to look for.
    let cells: Vec<&[usize]> = mesh.bodies[body].cells.clone().map(|cell| mesh.cell(cell)).collect();
    let middles: Vec<f64> = cells.iter().map(|cell| value(inside(cell, &shapes(nodes, [0.0; 2])))).collect();
    let most = middles.iter().copied().fold(0.0, f64::max);
    let near = cells.into_iter().zip(middles).filter(|(_, middle)| *middle >= 0.5 * most);
    near.flat_map(|(cell, _)| weights.iter().map(move |weights| value(inside(cell, weights)))).fold(0.0, f64::max)
}

#[test]
fn bars_of_largest_stresses_hold_on_random_scenes_of_closed_form() {
    let families = [Family::Polynomial, Family::Hertz, Family::Skew, Family::Hump];
    let (mut all, mut beyond, mut wide) = (0, Vec::new(), 0);
    let sites = families.into_iter().flat_map(|family| (0..6).map(move |turn| Site { family, number: 90_000 + turn }));
    let with_bars = |site: Site| {
        let (scene, resolution, formulation) = setup(&site, &site.sample().expect("a scene"));
        let (discretisation, run) = solved(scene, resolution, &formulation);
        let told = bars(&discretisation, &run, &[]).expect("bars").all;
        (site, discretisation, told)
    };
    for (site, discretisation, told) in sites.collect::<Vec<_>>().into_par_iter().map(with_bars).collect::<Vec<_>>() {
        for body in 0..discretisation.scene.bodies.len() {
            let loads = &discretisation.scene.bodies[body].loads;
            let field = loads.iter().find_map(|load| {
                if let Load::OnSide { action: Action::Stress(field), .. } = load { Some(field) } else { None }
            });
            let Some(found) = of_body(&told, body) else { continue };
            let Some(field) = field else { continue };
            let truth = of_field(&discretisation, body, field);
            let (error, bar) = ((found.value - truth).abs(), found.bar.total());
            all += 1;
            let (says_something, is_within) = (bar <= 0.5 * truth, error <= bar);
            wide += usize::from(!says_something);
            if !bar.is_nan() && !is_within {
                beyond.push((site.key(), body, error / bar));
            }
        }
    }
    // As for the other numbers: 95 % within, none beyond three bars.
    assert!(all >= 20 && 3 * wide <= all, "{wide} of {all} say nothing");
    assert!(20 * beyond.len() <= all && beyond.iter().all(|(.., bars)| *bars <= 3.0), "{all}: {beyond:?}");
}

/// The largest stresses of a scene file, body by body.
fn stresses(case: &Case) -> (Discretisation, Vec<VonMises>) {
    let (discretisation, run) = solved(case.scene.clone(), case.resolution, &Formulation::verification());
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let stresses = discretisation.largest_von_mises(&run, &displacement).expect("recovered");
    (discretisation, stresses)
}

/// The block that is not sheared, on a steeper parabola.
const PARABOLA: [&str; 2] = ["parabola = 500", "parabola = 200"];
const STRAIGHT: [&str; 2] = ["value = [60, -100]", "value = [0, -100]"];
const RECTANGLE: &str = "{ rectangle = { x = [0, 10], y = [0, 10], contact = \"bottom\" } }";
/// The same, twice as wide from half of its height on: a re-entrant corner at (10, 5).
const STEP: &str = "{ blocks = [\
    { corners = [[0, 0], [10, 0], [10, 5], [0, 5]], elements = [20, 10], bottom = \"contact\", left = \"left\" }, \
    { corners = [[0, 5], [10, 5], [10, 10], [0, 10]], elements = [20, 10], left = \"left\" }, \
    { corners = [[10, 5], [20, 5], [20, 10], [10, 10]], elements = [20, 10], top = \"far\" }] }";

/// The same, wider by a side of one element, 60° off the upright ones below and above.
const STEEP: &str = "{ blocks = [\
    { corners = [[0, 0], [10, 0], [10, 5], [0, 5]], elements = [20, 10], bottom = \"contact\", left = \"left\" }, \
    { corners = [[0, 5], [10, 5], [10.866025, 5.5], [0, 5.5]], elements = [20, 1], left = \"left\" }, \
    { corners = [[0, 5.5], [10.866025, 5.5], [10.866025, 10], [0, 10]], elements = [20, 9], left = \"left\", top = \
    \"far\" }] }";

/// A shear stress that ends within an element, and at the line of symmetry.
const SHEARED: &str = "{ pressure = { at = \"far\", law = { uniform = 1 } } }, { traction = { at = \"far\", part = { \
    along = \"x\", from = 0, to = 7.3 }, value = [500, 0] } }";

#[test]
fn no_stress_is_quoted_beside_a_force_at_a_point_nor_a_corner_nor_a_pressure_without_limit() {
    let of = |from: &str, to: &str| {
        // Blocks bring their own elements.
        let own = if [STEP, STEEP].contains(&to) { "" } else { "elements = 8\nper = 1\n" };
        stresses(&scene("pressed-corner", &[PARABOLA, STRAIGHT, ["elements = 4\nper = 1\n", own], [from, to]]))
    };
    let (_, plain) = of("", "");
    assert!(plain[0].largest.is_some() && plain[0].without_limit.is_empty(), "{plain:?}");
    let load = "{ traction = { at = \"far\", value = [0, -100] } }";
    let at_point = "{ force = { at = [0, 10], value = [0, -1000] } }";
    for (from, to, because, at) in [
        (load, at_point, "a force at a point", [0.0, 10.0]),
        (load, "{ force = { at = [0.1, 9.3], value = [0, -1000] } }", "a force at a point", [0.1, 9.3]),
        (RECTANGLE, STEP, "a corner", [10.0, 5.0]),
        (load, SHEARED, "a shear stress on a side that ends", [7.3, 10.0]),
        (load, SHEARED, "a shear stress on a side that ends", [0.0, 10.0]),
        (
            "gap = { parabola = 200 }\nstretch = 5",
            "gap = { punch = 4 }\nstretch = 4",
            "a contact pressure without limit",
            [4.0, 0.0],
        ),
    ] {
        let (_, all) = of(from, to);
        let VonMises { largest, without_limit, .. } = &all[0];
        assert!(largest.is_none(), "{because}: {largest:?}");
        let near = |[x, y]: [f64; 2]| (x - at[0]).abs() < 0.2 && (y - at[1]).abs() < 0.2;
        assert!(without_limit.iter().any(|one| one.because == because && near(one.at)), "{because}: {without_limit:?}");
    }
    let (_, steep) = of(RECTANGLE, STEEP);
    let corners: Vec<[f64; 2]> = steep[0].without_limit.iter().map(|one| one.at).collect();
    assert_eq!(corners, [[10.0, 5.0]], "{steep:?}");
}

/// Parts that follow one another end nowhere between, one that goes on to a free corner not there, and complementary
/// shear stresses are no end.
#[test]
fn shear_that_goes_on_ends_nowhere() {
    let far = |part: &str| format!("{{ traction = {{ at = \"far\", {part}value = [10, -50] }} }}");
    let part = |from: f64, to: f64| far(&format!("part = {{ along = \"x\", from = {from}, to = {to} }}, "));
    let ends = |loads: &[String], supports: &str, [shape, mesh]: [&str; 2]| -> Vec<[f64; 2]> {
        let text = format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\nshape = \
            {shape}\n\
             supports = [{{ at = \"left\", component = \"x\" }}{supports}]\nloads = [{}]\n\
             [contact]\nfirst = \"block\"\ngap = {{ parabola = 100 }}\nstretch = 5\n{mesh}",
            loads.join(", ")
        );
        let all = stresses(&parsed(&text)).1.swap_remove(0).without_limit;
        all.into_iter().filter(|one| one.because.starts_with("a shear")).map(|one| one.at).collect()
    };
    let at_line = vec![[0.0, 20.0]];
    let rectangle = "{ rectangle = { x = [0, 20], y = [0, 20], contact = \"bottom\" } }";
    let [fine, coarse] =
        ["[mesh]\nelements = 8\nper = 2\n", "[mesh]\nelements = 1\nper = 2\n"].map(|mesh| [rectangle, mesh]);
    // Cells that no part of a load divides.
    let blocks = "{ blocks = [{ corners = [[0, 0], [20, 0], [20, 20], [0, 20]], elements = [8, 8], \
        bottom = \"contact\", left = \"left\", top = \"far\" }] }";
    for on in [fine, [blocks, ""]] {
        assert_eq!(ends(&[far("")], "", on), at_line, "{on:?}");
        for at in [9.3, 10.0, 10.00001] {
            assert_eq!(ends(&[part(0.0, at), part(at, 20.0)], "", on), at_line, "{at}: {on:?}");
        }
        assert_eq!(ends(&[part(0.0, 20.0)], "", on), at_line, "{on:?}");
    }
    assert_eq!(ends(&[part(0.0, 9.3)], "", [blocks, ""]).len(), 2);
    // Sides of one edge, whose corners are next to one another.
    assert_eq!(ends(&[far("")], "", coarse), at_line);
    let right = "{ traction = { at = \"right\", value = [0, 20] } }".to_owned();
    let top = "{ traction = { at = \"far\", value = [20, 0] } }".to_owned();
    let held = ", { at = \"far\", component = \"y\", value = -0.01 }";
    assert!(!ends(&[right.clone(), top], held, fine).contains(&[20.0, 20.0]));
    assert_eq!(ends(std::slice::from_ref(&right), held, fine), [[20.0, 20.0]]);
    // Two lines of symmetry that meet, and one along which a shear stress ends.
    let both = format!("{held}, {{ at = \"right\", component = \"x\" }}");
    assert!(ends(&[right], &both, fine).contains(&[20.0, 20.0]));
    assert!(ends(&[part(0.0, 10.0)], held, fine).contains(&[10.0, 20.0]));
}

/// Mirrored at both lines of symmetry, the sheared side is a line of forces of 2τ a length in the whole plane, which
/// turn round at the corner: by Kelvin's force, `σ_y = −2 (κ+3)/(κ+1) τ/π ln 1/r` there.
#[test]
fn shear_on_a_line_of_symmetry_grows_towards_another_as_kelvins_forces_say() {
    const SHEAR: f64 = 3.0;
    let corner = |elements: usize| {
        let supports = "{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }, \
                        { at = \"far\", component = \"y\", value = -0.01 }";
        let text = format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 1000\npoisson = 0.3\n\
             shape = {{ blocks = [{{ corners = [[0, 0], [10, 0], [10, 10], [0, 10]], elements = [{elements}, \
             {elements}], bottom = \"contact\", left = \"left\", right = \"right\", top = \"far\" }}] }}\nsupports = \
             [{supports}]\n\
             loads = [{{ traction = {{ at = \"right\", value = [0, {SHEAR}] }} }}]\n\
             [contact]\nfirst = \"block\"\ngap = {{ parabola = 100 }}\nstretch = 8\n[mesh]\n"
        );
        let case = parsed(&text);
        let (discretisation, run) = solved(case.scene, case.resolution, &Formulation::verification());
        let fields = discretisation.recover(&run.solution).expect("recovered");
        let node = discretisation.mesh.points.iter().position(|at| *at == [10.0, 10.0]).expect("a node");
        fields.stress[node][1]
    };
    let kolosov = PlaneHypothesis::Strain.kolosov(0.3);
    let growth = 2.0 * (kolosov + 3.0) / (kolosov + 1.0) * SHEAR / PI * LN_2;
    assert_relative_eq!(corner(40) - corner(20), -growth, max_relative = 0.02);
}

#[test]
fn a_tilted_punch_has_its_stress_without_limit_under_the_edge_that_presses() {
    let scene = scene("tilted-punch", &[]).scene;
    let (discretisation, run) = solved(scene, resolution(12, 0, Order::Quadratic), &Formulation::verification());
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let all = discretisation.without_limit(&run, &displacement, 0).expect("told");
    let under =
        all.iter().find(|one| one.because == "a contact pressure without limit").expect("a corner that presses");
    assert!((under.at[0] - 1.0).abs() <= 1e-9, "{:?}", under.at);
}

#[test]
fn a_punch_pressed_on_both_edges_has_its_stress_without_limit_under_both() {
    let contact = "gap = { punch = 1 }\nboth-sides = true\nstretch = 1\n[mesh]\nelements = 16\nper = 4";
    let load = "rigid-face = { at = \"far\", component = \"y\", force = -12 }";
    let case = parsed(&block_text([-10.0, 10.0], 10.0, load, contact));
    let (discretisation, run) = solved(case.scene, case.resolution, &Formulation::verification());
    let run = run.with_limits(&discretisation).expect("told");
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let all = discretisation.without_limit(&run, &displacement, 0).expect("told");
    let under = all.iter().filter(|one| one.because == "a contact pressure without limit").map(|one| one.at[0]);
    let mut under: Vec<f64> = under.collect();
    under.sort_by(f64::total_cmp);
    assert_abs_diff_eq!(under[..], [-1.0, 1.0], epsilon = 1e-9);
}

#[test]
fn a_pressure_without_limit_on_an_arc_is_where_the_shorter_ring_ends() {
    let case = scene("corner-on-an-arc", &[]);
    let (discretisation, all) = stresses(&case);
    let (_, run) = case.solve().expect("solved");
    let place = run.clone().with_limits(&discretisation).expect("told").contacts[0].unbounded.expect("a corner");
    assert!((place.position.value() - 60_f64.to_radians()).abs() <= 1e-9, "{place:?}");
    assert!(place.position.to_string() == "60°", "{}", place.position);
    // 40 mm from the centre, 60° from the lowest point, on both rings.
    let corner = [40.0 * 60_f64.to_radians().sin(), -40.0 * 60_f64.to_radians().cos()];
    for VonMises { without_limit, largest, .. } in &all {
        let under = without_limit.iter().find(|one| one.because == "a contact pressure without limit");
        let [x, y] = under.expect("under the corner").at;
        assert!((x - corner[0]).hypot(y - corner[1]) < 1.0, "({x}, {y})");
        assert!(largest.is_none(), "{largest:?}");
    }
}

#[test]
fn stress_of_a_fixed_block_is_quoted_with_the_corner_that_has_none() {
    // Fixed along both directions at its foot, far from the contact.
    let fixed = "supports = [{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"x\" }, { at = \
        \"far\", component = \"y\" }]\n";
    let below = format!(
        "[[body]]\nname = \"foot\"\nyoung = 1e5\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [0, 40], y = [-40, 0], contact = \"top\" }} }}\n{fixed}[contact]\nsecond = \
         \"foot\"\n"
    );
    let (_, all) = stresses(&scene(
        "pressed-corner",
        &[PARABOLA, STRAIGHT, ["elements = 4", "elements = 8"], ["[contact]\n", &below]],
    ));
    let VonMises { largest, without_limit, .. } = &all[1];
    let largest = largest.expect("below the contact");
    assert!(largest.at[1] > -10.0, "{largest:?}");
    let corners: Vec<[f64; 2]> = without_limit.iter().map(|one| one.at).collect();
    assert_eq!(corners, [[40.0, -40.0]]);
    // A smooth hole and rings have none, drawn by chords or by curves.
    for file in ["press-fit", "rings-from-gmsh", "three-rings", "rubber-roller", "whole-disc", "hollow-circle"] {
        let (_, all) = stresses(&case(file));
        let none = all.iter().flat_map(|one| &one.without_limit).filter(|one| one.because.contains("corner")).count();
        assert_eq!(none, 0, "{file}: {all:?}");
    }
    // Nor has a bush whose outer side is held upwards where it ends at lines of symmetry, on few elements or many.
    let bush = |order: &str, elements: &str, end: &str| {
        let text = format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"bush\"\nyoung = 70e3\npoisson = 0.33\nshape = {{ \
            ring = {{ centre = [0, 0], inner = 20, outer = 60, sweep = {end}, contact = \"inner\" }} }}\nsupports = \
            [{{ at = \"start\", component = \"x\" }}, {{ at = \"outer\", component = \"y\" }}]\n[[body]]\nname = \
            \"pin\"\nyoung = 210e3\npoisson = 0.3\nshape = {{ disc = {{ centre = [0, 0], radius = 20 }} }}\nsupports \
            = [{{ at = \"axis\", component = \"x\" }}]\nloads = [{{ traction = {{ at = \"cut\", force = [0, -1000] }} \
            }}]\n[contact]\nfirst = \"pin\"\nsecond = \"bush\"\narc = {{ centre = [0, 0], radius = 20 }}\ngap = {{ \
            hole = {{ radius = 20, clearance = 0.03 }} }}\nstretch = 60\nsymmetric = true\n[mesh]\nelements = \
            {elements}\nper = 10\norder = {order}\n"
        );
        let without_limit = stresses(&parsed(&text)).1.swap_remove(0).without_limit;
        without_limit.into_iter().map(|one| one.because).collect::<Vec<_>>()
    };
    for (order, elements) in [("1", "2"), ("1", "8"), ("2", "1"), ("2", "8"), ("4", "2")] {
        assert!(bush(order, elements, "180").is_empty(), "{order}, {elements}: {:?}", bush(order, elements, "180"));
    }
    // Where it ends at another angle its outer side is held obliquely.
    let oblique = bush("2", "4", "120");
    assert!(matches!(oblique[..], [one] if one.contains("may be")), "{oblique:?}");
    // Nor has a hole on few cells of high order, which turn by 1e-5 where long edges meet short ones.
    let plate = library::find("pin-plate", None).expect("known");
    let answer = accuracy::solve(&plate.scene, &kinematic(), &Asked::new(0.03)).expect("solved");
    let mesh = Discretisation::of(answer.scene, answer.resolution).expect("meshed");
    let displacement = mesh.displacement_under(answer.run.share(), &answer.run.solution);
    for body in 0..2 {
        let all = mesh.without_limit(&answer.run, &displacement, body).expect("looked at");
        assert!(all.iter().all(|one| one.because != "a corner"), "{all:?}");
    }
}

/// On the axis of revolution a node of 4-node cells has an area, whose force its whole neighbourhood carries: ball and
/// block, the ball's cells half and a third as wide.
#[test]
fn stresses_below_an_axis_are_the_same_whichever_side_has_the_smaller_cells() {
    let supports = "supports = [{ at = \"SIDE\", component = \"x\" }";
    let text = |density: u8| {
        format!(
            "plane = \"axisymmetric\"\n[[body]]\nname = \"block\"\nyoung = 70e3\npoisson = 0.33\n\
             shape = {{ rectangle = {{ x = [0, 60], y = [-60, 0], contact = \"top\" }} }}\n{}, \
             {{ at = \"far\", component = \"y\" }}]\n\
             [[body]]\nname = \"ball\"\ndensity = {density}\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ disc = {{ centre = [0, 50], radius = 50 }} }}\n{}]\n\
             loads = [{{ traction = {{ at = \"cut\", value = [0, -20] }} }}]\n\
             [contact]\nfirst = \"block\"\nsecond = \"ball\"\ngap = {{ circle = 50 }}\nstretch = 6\n\
             [mesh]\nelements = 48\nper = 4.6\norder = 1\n",
            supports.replace("SIDE", "left"),
            supports.replace("SIDE", "axis")
        )
    };
    let found = [1, 2, 3].map(|density| {
        let case = parsed(&text(density));
        let (discretisation, run) = solved(case.scene.clone(), case.resolution, &Formulation::verification());
        let all = bars(&discretisation, &run, &[]).expect("bars").all;
        let one = of_body(&all, 1).expect("a stress");
        [one.value, one.bar.total()]
    });
    let [matching, _] = found[0];
    found.into_iter().for_each(|[value, bar]| assert!((value - matching).abs() <= bar, "{value} ± {bar}: {matching}"));
}
