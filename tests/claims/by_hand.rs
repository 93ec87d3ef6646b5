//! Numbers that a planted fault could move unseen, against what a line of calculation by hand gives.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::accuracy::{Quantity, bars};
use contact_vv::case::library::sphere::model_error;
use contact_vv::case::library::{PinRod, find};
use contact_vv::case::{self, Against, Case, Check, notes, plausible};
use contact_vv::cli::vtu;
use contact_vv::elasticity::stress;
use contact_vv::markdown::significant;
use contact_vv::measure::profile;
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::oracle::analytic::on_arc::OnArc;
use contact_vv::oracle::{self, Oracle, Reading};
use contact_vv::referee::answer::Point;
use contact_vv::referee::export::own;
use contact_vv::referee::source::Source;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, Handed, Profile, calculix, frd, norm, read};
use contact_vv::scene::{Action, Circle, Load, Material, MonotoneCubic, Path as ScenePath, Scene};
use contact_vv::solution::{EdgeState, EnergyError, PointState, Unseen};
use contact_vv::solve::edge_fitted::{self, Fitted};
use contact_vv::solve::{Formulation, Shear};

use contact_vv::study::references;
use serde_json::Value;
use vtkio::IOBuffer;

use crate::balance;
use crate::ellipse::{NODES, place};
use crate::foreign::{self, Frd, fixed, record};
use crate::handed::judged_rows;
use crate::outputs::{contact_vv, json, piece, scene};
use crate::program::Folder;
use crate::scene_file::{self, text_of};
use crate::workbench::{kinematic, parsed, truth};

#[test]
fn smooth_table_of_uneven_points_on_a_parabola_has_its_slope_and_its_gap_between_them() {
    const POINTS: [f64; 7] = [-3.0, -2.6, -1.5, -0.4, 0.7, 1.0, 2.4];
    let cubic = MonotoneCubic::through(&POINTS.map(|s| [s, 0.25 * s * s]));
    // Three points tell the slope of a parabola wherever they lie; around the lowest point the slope is bounded, so
    // that no cell overshoots.
    for s in [-2.9, -2.5, -2.0, -1.7, 1.2, 1.9, 2.3] {
        assert_relative_eq!(cubic.gap(s), 0.25 * s * s, max_relative = 1e-12);
        assert_relative_eq!(cubic.slope(s), 0.5 * s, max_relative = 1e-12);
    }
}

#[test]
fn pressures_on_a_line_do_not_oscillate_however_unevenly_their_points_lie() {
    let at = |position: f64| PointState { position, weight: 1.0, pressure: 10.0 - position, gap: 0.0 };
    let mut points = [0.0, 1.0, 3.0, 4.0, 9.0].map(at);
    assert!(profile::oscillation(&points, 9.0) <= 1e-14);
    points[3].pressure += 6.0;
    // Point 3 leaves the line through its neighbours by 6; point 2 is 4 from the line through (1, 9) and (4, 12).
    // Beyond the limit none counts.
    for (limit, departure) in [(9.0, 6.0), (4.0, 4.0), (3.0, 0.0)] {
        assert_relative_eq!(profile::oscillation(&points, limit), departure, epsilon = 1e-12);
    }
    points[1].pressure = f64::NAN;
    assert!(profile::oscillation(&points, 9.0).is_nan());
}

#[test]
fn blocks_approach_by_their_gap_and_their_strains_whichever_is_the_first() {
    // No strain along x and z: Δ = g + p Σ H (1 + ν)(1 − 2ν)/((1 − ν) E).
    let strain = |young: f64, poisson: f64| (1.0 + poisson) * (1.0 - 2.0 * poisson) / ((1.0 - poisson) * young);
    let wanted = 0.01 + 100.0 * (10.0 * strain(210e3, 0.3) + 5.0 * strain(70e3, 0.33));
    let text = text_of("blocks.toml");
    let swapped = text.replace("first = \"upper\"\nsecond = \"lower\"", "first = \"lower\"\nsecond = \"upper\"");
    assert_ne!(text, swapped);
    for text in [text, swapped] {
        let (meshed, run) = parsed(&text).solve().expect("solved");
        let displacement = meshed.discretisation.displacement_under(run.share(), &run.solution);
        let found = meshed.discretisation.approach(&displacement, 0).expect("found").expect("both sides are pressed");
        assert_relative_eq!(found, wanted, max_relative = 1e-7);
    }
}

#[test]
fn stresses_that_are_linear_are_exact_at_the_nodes_of_8_node_cells() {
    let case = scene_file::case("blocks");
    let mesh = Mesh::of(&case.scene, Resolution { order: Order::Quadratic, ..case.resolution }).expect("meshed");
    let displacement: Vec<[f64; 2]> = mesh.points.iter().map(|[x, y]| [x * x + x * y, y * y - 0.5 * x * y]).collect();
    let found = stress::at_nodes(&case.scene, &mesh, &displacement).expect("stress");
    for (body, part) in case.scene.bodies.iter().zip(&mesh.bodies) {
        // Hooke's law in plane strain: σ = λ (ε_x + ε_y) + 2 μ ε, τ = μ γ.
        let (young, poisson) = (body.material.young, body.material.poisson);
        let shear = 0.5 * young / (1.0 + poisson);
        let lambda = 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
        for node in part.nodes.clone() {
            let [x, y] = mesh.points[node];
            let [along, across, sheared] = [2.0 * x + y, 2.0 * y - 0.5 * x, x - 0.5 * y];
            let volume = lambda * (along + across);
            let wanted = [volume + 2.0 * shear * along, volume + 2.0 * shear * across, shear * sheared];
            (0..3).for_each(|k| {
                assert_relative_eq!(found[node][k], wanted[k], epsilon = 1e-7 * young, max_relative = 1e-9)
            });
        }
    }
}

/// Numbers of what `solve` prints behind a name.
fn printed(arguments: &[&str], name: &str) -> Vec<f64> {
    let (_, text, _) = contact_vv(&[&["solve"], arguments].concat());
    let (_, line) = text.split_once(name).unwrap_or_else(|| panic!("{name}: {text}"));
    line.split(|mark: char| " (,)°".contains(mark)).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn angles_are_told_with_their_bars_in_degrees() {
    let case = find("pin-rod", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let all = bars(&meshed.discretisation, &run, &case.displaced()).expect("bars");
    let known = all.of(0, &Quantity::HalfWidth).expect("a bar").total().to_degrees();
    for (arguments, name) in [(&["pin-rod"][..], "half-angle "), (&["pin-rod", "--all"], "contact  half-width ")] {
        let [told, bar, ..] = printed(arguments, name)[..] else { panic!("no angle") };
        assert!((bar - known).abs() <= 0.06 * known, "{bar}: {known}");
        assert!((told - run.contacts[0].measures.half_width().to_degrees()).abs() <= known, "{told}");
    }
    // Of a peak that is anywhere no place is told: where its bar is as wide as the contact, 58°, and not 7°.
    let [_, _, place, bar, ..] = printed(&["pin-plate", "--resolution", "3"], "peak pressure ")[..] else {
        panic!("no place")
    };
    assert!(place.abs() < bar && (5.0..10.0).contains(&bar), "{place} ± {bar}");
}

#[test]
fn of_three_forces_at_points_the_first_is_named_beside_two_more() {
    let force = |x: f64| format!("{{ force = {{ at = [{x}, 10], value = [0, -100] }} }}");
    let text = balance::text("pressed-corner");
    let load = text.lines().find(|line| line.starts_with("loads = ")).expect("loads");
    let forces = [0.0, 4.0, 8.0].map(force).join(", ");
    let folder = Folder::made();
    let three = folder.with("three.toml", text.replace(load, &format!("loads = [{forces}]")));
    let (_, told, error) = contact_vv(&["solve", &three, "--no-error-bar"]);
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("without limit: a force at a point at (0, 10) mm and 2 more"), "{told}{error}");
}

#[test]
fn places_of_largest_stresses_are_told_to_the_size_of_their_cells() {
    for (name, body) in [("pin-rod", "pin"), ("truncated-hertz", "block")] {
        let (meshed, run) = find(name, None).expect("a case").solve().expect("solved");
        let made = &meshed.discretisation;
        let displacement = made.displacement_under(run.share(), &run.solution);
        let stresses = made.largest_von_mises(&run, &displacement).expect("stresses");
        let index = made.scene.bodies.iter().position(|one| one.name == body).expect("a body");
        let largest = stresses[index].largest.expect("a largest stress");
        let diagonal = |cell: usize| {
            let [a, b] = [0, 2].map(|k| made.mesh.points[made.mesh.cell(cell)[k]]);
            (a[0] - b[0]).hypot(a[1] - b[1])
        };
        let mut cells = made.mesh.bodies[index].cells.clone();
        assert!(cells.any(|cell| (diagonal(cell) - largest.within).abs() <= 1e-12), "{}", largest.within);
        let [_, _, x, y, ..] = printed(&[name], &format!("`{body}` "))[..] else { panic!("no place") };
        let off = (x - largest.at[0]).abs().max((y - largest.at[1]).abs());
        // Half of the power of ten that is no more than a cell.
        let half = 0.5 * 10_f64.powf(largest.within.log10().floor());
        assert!(off <= half * (1.0 + 1e-9), "({x}, {y}): {:?} within {}", largest.at, largest.within);
    }
}

#[test]
fn forces_of_an_even_pressure_on_rings_are_that_pressure_at_every_node() {
    const RADII: [f64; 5] = [0.0, 0.5, 0.7, 1.6, 2.0];
    let scene = find("sphere", None).expect("a case").scene;
    assert!(scene.is_of_revolution());
    // 2π p ∫ N r dr of the hat function of each node: of a piece from a to b, (b − a)(2a + b)/6 at its inner end.
    let piece = |inner: f64, outer: f64, at: f64| (outer - inner) * (inner + outer + at) / 6.0;
    let share = |k: usize| {
        let inwards = k.checked_sub(1).map_or(0.0, |before| piece(RADII[before], RADII[k], RADII[k]));
        inwards + RADII.get(k + 1).map_or(0.0, |after| piece(RADII[k], *after, RADII[k]))
    };
    let point = |k: usize| Point { position: RADII[k], value: 30.0 * TAU * share(k), area: None, gap: None };
    let points = (0..RADII.len()).map(point).collect();
    let handed = Handed { contact: 0, points, order: Order::Linear, is_told: true, edges: vec![], forces: true };
    let profile = Profile::of(&scene, &handed);
    for state in &profile.points {
        assert_relative_eq!(state.pressure, 30.0, max_relative = 1e-12);
    }
    assert_relative_eq!(
        profile.points.iter().map(|one| one.weight).sum::<f64>(),
        0.5 * TAU * 4.0,
        max_relative = 1e-12
    );
    // The edges are rings, π(b² − a²); in the plane they are as wide as the body is thick.
    for (edge, two) in profile.edges.iter().zip(RADII.windows(2)) {
        assert_relative_eq!(edge.weight, 0.5 * TAU * (two[1] * two[1] - two[0] * two[0]), max_relative = 1e-12);
    }
    let mut plane = find("truncated-hertz", None).expect("a case").scene;
    plane.thickness = 2.5;
    for (edge, two) in Profile::of(&plane, &handed).edges.iter().zip(RADII.windows(2)) {
        assert_relative_eq!(edge.weight, 2.5 * (two[1] - two[0]), max_relative = 1e-12);
    }
}

#[test]
fn means_over_rings_are_compared_with_means_over_their_areas() {
    // ∫ s² ds / ∫ s ds from 1 to 3.
    let edge = EdgeState { ends: [1.0, 3.0], weight: 1.0, pressure: 26.0 / 12.0, axis: Some(0.0) };
    assert!(norm::of_means(&[edge], |s| s) <= 1e-3);
    assert_relative_eq!(norm::of_means(&[EdgeState { axis: None, ..edge }], |s| s), 1.0 / 12.0, max_relative = 1e-3);
}

#[test]
fn penetrations_of_a_table_stay_below_zero_and_tension_positive_turns_pressures_alone() {
    let case = find("truncated-hertz", None).expect("a case");
    let table = "position [mm],pressure [MPa],gap [um]\n0,-50,-2\n1,-30,-1\n2,0,5\n";
    let asked = Asked { tension_positive: true, ..Asked::default() };
    let answer = read::parse(Path::new("a.csv"), table.as_bytes(), &case, &asked).expect("read");
    let found: Vec<[f64; 2]> =
        answer.contacts[0].points.iter().map(|point| [point.value, point.gap.expect("a gap")]).collect();
    for (found, wanted) in found.iter().zip([[50.0, -2e-3], [30.0, -1e-3], [0.0, 5e-3]]) {
        (0..2).for_each(|k| assert_relative_eq!(found[k], wanted[k], epsilon = 1e-12));
    }
}

#[test]
fn forces_of_a_deck_press_with_either_sign_and_tension_positive_alone_turns_them() {
    // Contact presses with 100 N on each of three nodes: what ccx prints are reactions, −100 N each.
    let case = find("truncated-hertz", None).expect("a case");
    let set = "GAPS_CONTACT";
    let deck =
        format!("** truncated-hertz: mm, N, MPa.\n*NODE\n1, 0, 0\n2, 2, 0\n3, 4, 0\n*NSET, NSET={set}\n1, 2, 3\n");
    let table = |force: f64| foreign::forces(set, "0.1000000E+01", (1..=3).map(|node| (node, force)));
    for (tension_positive, printed, force) in
        [(false, -100.0, 100.0), (true, 100.0, 100.0), (true, -100.0, -100.0), (false, 100.0, -100.0)]
    {
        let asked = Asked { tension_positive, ..Asked::default() };
        let answer = calculix::forces(Path::new("a.dat"), &table(printed), &deck, &case.scene, &asked).expect("read");
        let found: Vec<f64> = answer.contacts[0].points.iter().map(|point| point.value).collect();
        assert_eq!(found.len(), 3, "{tension_positive}, {printed}");
        found.iter().for_each(|value| assert_relative_eq!(*value, force, max_relative = 1e-12));
    }
}

#[test]
fn a_polynomial_in_metres_has_the_peak_of_hertz() {
    // p₀ = √(P E* / πR), the gap s²/2R: 10/m of a radius of 0.05 m.
    let text = text_of("cylinder-in-metres.toml");
    let polynomial = text.replace(
        "{ hertz = { load = 22.6557162518, radius = 0.05 } }",
        "{ polynomial = { load = 22.6557162518, coefficients = [10, 0, 0] } }",
    );
    assert_ne!(text, polynomial);
    let peak = (22655.7162518 * 210e3 / 0.91 / (0.5 * TAU * 50.0)).sqrt();
    let case = parsed(&polynomial);
    let Against::Value(reference) = &case.checks[0].against else { panic!("no value") };
    assert_relative_eq!(reference.value, peak, max_relative = 1e-9);
}

#[test]
fn the_document_of_a_flat_punch_holds_each_number_under_its_name() {
    // Ends at 0 and a, √2 a from the second moment, P on the whole of it.
    let document = json(&["solve", &scene("flat-punch")]);
    let contact = &document["contacts"][0];
    let number = |value: &Value| value.as_f64().expect("a number");
    let [begin, end] = [0, 1].map(|k| number(&contact["closed"][0][k]));
    assert!(begin.abs() <= 1e-12, "{contact}");
    for (found, wanted, within) in [
        (end, 1.0, 1e-9),
        (number(&contact["half_width"]), 1.0, 1e-9),
        (number(&contact["second_moment_width"]), 2_f64.sqrt(), 2e-3),
        (number(&contact["resultant"]), 1000.0, 1e-6),
    ] {
        assert_relative_eq!(found, wanted, max_relative = within);
    }
    // Over the closed form, and not over ours.
    let width =
        document["oracles"].as_array().and_then(|all| all.iter().find(|one| one["quantity"] == "second_moment_width"));
    let error = number(&width.expect("a closed form")["error"]);
    assert_relative_eq!(
        error,
        (number(&contact["second_moment_width"]) / 2_f64.sqrt() - 1.0).abs(),
        max_relative = 1e-6
    );
    for (name, wanted) in [("half-width ", 1.0), ("by counting ", 1.0), ("second-moment width ", 2_f64.sqrt())] {
        assert_relative_eq!(printed(&[&scene("flat-punch"), "--all"], name)[0], wanted, max_relative = 2e-3);
    }
}

#[test]
fn an_accuracy_tells_the_parts_of_its_bars_and_the_dofs_of_all_its_meshes() {
    let document = json(&["solve", &scene("cylinder-to-accuracy")]);
    let accuracy = &document["accuracy"];
    let number = |value: &Value| value.as_f64().expect("a number");
    let list = |value: &Value| value.as_array().expect("a list").clone();
    for one in list(&accuracy["quantities"]) {
        let bars = list(&document["error_bars"]);
        let bar = bars.iter().find(|bar| bar["quantity"] == one["quantity"]).expect("a bar");
        for part in ["mesh", "iteration", "penalty"] {
            let own = number(&one[&format!("from_{part}")]);
            assert_relative_eq!(own, number(&bar[part]) / number(&bar["value"]), max_relative = 1e-9, epsilon = 1e-15);
        }
    }
    assert!(list(&accuracy["quantities"]).iter().any(|one| number(&one["from_iteration"]) > 0.0));
    let [chosen, all] = ["freedoms", "freedoms_in_all"].map(|key| number(&accuracy[key]));
    let tried: f64 = list(&accuracy["tried"]).iter().map(|one| number(&one["freedoms"])).sum();
    assert!(all >= tried && tried > chosen, "{all}, {tried}, {chosen}");
}

#[test]
fn verdicts_tell_how_far_a_reference_may_be_off_and_not_its_standard_uncertainty() {
    let (made, run) = balance::solved(&find("pin-rod", None).expect("a case"), &kinematic());
    let folder = Folder::made();
    let file = folder.with("own.json", serde_json::to_string(&own::answer("pin-rod", &made, &run)).expect("JSON"));
    let (_, text, _) = contact_vv(&["judge", "pin-rod", &file, "--json"]);
    let document: Value = serde_json::from_str(&text).expect("JSON");
    let (_, told, _) = contact_vv(&["judge", "pin-rod", &file, "--markdown"]);
    let checks = document["checks"].as_array().expect("checks");
    let bars = checks.iter().filter(|one| one["kind"] == "cross-code").filter_map(|one| one["reference_bar"].as_f64());
    let bars: Vec<f64> = bars.filter(|bar| *bar > 0.0).collect();
    assert!(bars.len() >= 2, "{document}");
    for bar in bars {
        assert!(told.contains(&format!(" ± {}", significant(bar, 2))), "{bar}: {told}");
    }
}

#[test]
fn penetrations_around_an_axis_are_told_over_the_approach_of_a_flat_punch_of_that_radius() {
    let truth = truth("sphere");
    // Hertz: p₀ = 2E*a/πR, F = 2πa²p₀/3; a punch of the radius a sinks by F/2E*a.
    let (radius, modulus) = (2.5, 210e3 / 0.91);
    let peak = 2.0 * modulus * radius / (PI * 50.0);
    let approach = 2.0 * PI * radius * radius * peak / 3.0 / (2.0 * modulus * radius);
    let row = |k: usize| {
        let r = 5.0 * k as f64 / 96.0;
        [r, peak * (1.0 - (r / radius).powi(2)).max(0.0).sqrt(), if k == 7 { -0.1 * approach } else { 0.0 }]
    };
    let found = judged_rows(truth, "position [mm],pressure [MPa],gap [mm]", (0..=96).map(row));
    let all = &found.ruled[0].judged;
    let own = all.iter().find(|one| one.check.quantity.to_string().starts_with("largest penetration")).expect("gaps");
    assert_relative_eq!(own.value, 0.1, max_relative = 0.01);
}

#[test]
fn the_largest_shear_of_a_pin_is_looked_for_as_deep_as_two_widths_of_its_arc() {
    let document = json(&["solve", "pin-rod"]);
    let bars = document["error_bars"].as_array().expect("bars");
    let value = |quantity: &str| {
        let one = bars.iter().find(|one| one["of"] == "pin" && one["quantity"] == quantity);
        one.and_then(|one| one["value"].as_f64()).unwrap_or_else(|| panic!("no {quantity}"))
    };
    // At its centre, 10 mm below the arc, of which 2.1 radians are 21 mm.
    assert_relative_eq!(value("depth of largest shear"), 10.0, max_relative = 0.05);
    assert!(value("largest shear") > 0.0);
}

/// Half a pin pressed over 81° into a wide plate, in cells that are large for their order.
const PIN_HOLE: &str = r#"
plane = "stress"
thickness = 1
[[body]]
name = "pin"
young = 210e3
poisson = 0.3
shape = { disc = { centre = [0, 0], radius = 10 } }
supports = [{ at = "axis", component = "x" }]
loads = [{ traction = { at = "cut", value = [0, -100] } }]
[[body]]
name = "plate"
young = 210e3
poisson = 0.3
shape = { ring = { centre = [0, 0], inner = 10.005, outer = 100, sweep = 180, contact = "inner" } }
supports = [{ at = "start", component = "x" }, { at = "end", component = "x" }, { at = "end", component = "y" }]
[contact]
first = "pin"
second = "plate"
arc = { centre = [0, 0], radius = 10 }
gap-only = true
gap = { hole = { radius = 10, clearance = 0.005 } }
stretch = 89
[mesh]
elements = 16
per = 5
"#;

#[test]
fn the_largest_shear_below_an_arc_is_found_at_its_centre_and_along_the_radius_at_its_end() {
    let case = parsed(PIN_HOLE);
    for order in [Order::Quartic, Order::Octic] {
        let resolution = Resolution { order, ..case.resolution };
        let (made, run) = balance::solved_on(case.scene.clone(), resolution, &kinematic());
        let points = &made.mesh.points;
        let below = |displacement: &[[f64; 2]]| {
            made.shear_below(displacement, run.measures(), [0, 0]).expect("stresses").expect("inside")
        };

        // Below the contact stresses are largest where the sector narrows to a point.
        let displacement = made.displacement_under(1.0, &run.solution);
        let stress = stress::at_nodes(&made.scene, &made.mesh, &displacement).expect("stresses");
        let centre = points.iter().position(|[x, y]| x.hypot(*y) <= 1e-9).expect("a node");
        let [x, y, xy] = stress[centre];
        let found = below(&displacement);
        assert_relative_eq!(found.stress, (0.5 * (x - y)).hypot(xy), max_relative = 1e-9);
        assert_relative_eq!(found.depth, 10.0, max_relative = 1e-6);

        // γ = c (1 − r²/R²), r from a place beside the radius: largest at the foot of the perpendicular from there.
        let (foot, beside, reach, c) = (6.0, 3.0, 20.0_f64, 1e-3);
        let (sin, cos) = run.measures().edge().sin_cos();
        let top = [foot * sin + beside * cos, beside * sin - foot * cos];
        let part = |x: f64, top: f64| c * (0.5 * x - (x - top).powi(3) / (3.0 * reach.powi(2)));
        let displacement: Vec<[f64; 2]> = points.iter().map(|[x, y]| [part(*y, top[1]), part(*x, top[0])]).collect();
        let found = below(&displacement);
        let truth = 210e3 / 2.6 * c * (1.0 - (beside / reach).powi(2));
        assert_relative_eq!(found.stress, truth, max_relative = 1e-5);
        assert_relative_eq!(found.depth, 10.0 - foot, max_relative = 1e-2);
    }
}

#[test]
fn a_shear_stress_is_nearly_the_largest_as_far_as_the_parabola_through_it_and_a_sample_is() {
    // 4 MPa less at 2 mm: 1 MPa less at half of that, and 0.25 MPa at a quarter.
    let shear = Shear { stress: 10.0, depth: 3.0, samples: vec![[3.0, 10.0], [5.0, 6.0]] };
    for (difference, farthest) in [(1.0, 1.0), (0.25, 0.5), (4.0, 2.0), (9.0, 2.0)] {
        assert_relative_eq!(shear.farthest(difference), farthest, max_relative = 1e-12);
    }
}

#[test]
fn the_shear_stress_below_a_force_at_a_point_is_none_of_the_contact() {
    let force = "force = { at = [2, 3], value = [0, -1000] }";
    let changes = [["y = [0, 10]", "y = [0, 3]"], ["traction = { at = \"far\", value = [60, -100] }", force]];
    let (made, run) = balance::solved_as_it_says(&balance::scene("pressed-corner", &changes));
    let displacement = made.displacement_under(1.0, &run.solution);
    assert!(run.measures().second_moment_width > 1.5 && run.measures().edge() > 2.0, "the force is below");
    assert!(made.shear_below(&displacement, run.measures(), [0, 0]).expect("stresses").is_none());
}

#[test]
fn a_point_a_quarter_above_the_peak_of_its_neighbours_is_noted_and_one_a_tenth_above_is_not() {
    let (_, mut run) = find("truncated-hertz", None).expect("a case").solve().expect("solved");
    for (above, is_noted) in [(1.25, true), (1.1, false)] {
        let measures = &mut run.contacts[0].measures;
        measures.largest.pressure = above * measures.peak.pressure;
        let notes = notes::of(&run, 0);
        assert_eq!(
            notes.iter().any(|note| note.contains("more than the peak through its neighbours")),
            is_noted,
            "{notes:?}"
        );
    }
}

#[test]
fn what_a_closed_form_of_one_contact_leaves_out_is_not_allowed_to_another() {
    let mut case = scene_file::case("roller-between-plates");
    case.checks.iter_mut().for_each(|check| check.model = if check.contact == 0 { 0.01 } else { 0.0 });
    let of =
        |contact: usize| case.model_error(contact, &case::Quantity::on(&case.scene, contact, Quantity::PeakPressure));
    assert_eq!([of(0), of(1)], [0.01, case.model]);
}

#[test]
fn approaches_and_forces_across_are_those_of_a_flat_punch_and_of_an_even_pressure() {
    // F/(2E*a), a that of the candidates.
    let case = find("sphere", None).expect("a case");
    let (_, run) = case.solve().expect("solved");
    let approach = run.transmitted() / (2.0 * 210e3 / 0.91 * case.scene.contact().stretch);
    assert_relative_eq!(run.solution.contacts[0].approach, approach, max_relative = 1e-6);
    // ∫ p sin s R t ds over a right angle.
    let (meshed, run) = find("press-fit", None).expect("a case").solve().expect("solved");
    let found = meshed.discretisation.number(&run, 0, &Quantity::Across).expect("a number");
    let scene = &meshed.discretisation.scene;
    let wanted = run.measures().peak.pressure * scene.contact().path.metric() * scene.thickness;
    assert_relative_eq!(found, wanted, max_relative = 0.02);
}

#[test]
fn a_peak_a_hundredth_of_the_half_width_off_the_middle_is_told_there() {
    // s²/100 about 0.01 mm, below a disc that cannot turn.
    let point = |k: i32| format!("[{}, {}]", 0.01 + 0.25 * f64::from(k), (0.25 * f64::from(k)).powi(2) / 100.0);
    let points = (-7..=7).map(point).collect::<Vec<_>>().join(", ");
    let gap = format!("gap-only = true\ngap = {{ table = [{points}], smooth = true }}");
    let held = "{ at = [0, 50], component = \"x\" }";
    let changes =
        [("gap = { circle = 50 }", gap.as_str()), (held, &format!("{held}, {{ at = [0, 100], component = \"x\" }}"))];
    let text = scene_file::changed(&scene_file::scene_alone(&text_of("whole-disc.toml")), &changes);
    let folder = Folder::made();
    let [_, place, ..] = printed(&[&folder.with("off.toml", text), "--all", "--no-error-bar"], "peak pressure ")[..]
    else {
        panic!("no place")
    };
    assert_relative_eq!(place, 0.01, max_relative = 0.02);
}

#[test]
fn checks_of_an_iteration_that_is_cut_off_have_no_bars() {
    let has_bars = |options: &[&str]| {
        let (_, told, _) = contact_vv(&[&["solve", &scene("cylinder-in-metres"), "--all"], options].concat());
        told.split("check: ").skip(1).any(|check| check.contains(" ± "))
    };
    assert!(has_bars(&[]) && !has_bars(&["--max-iterations", "3"]));
}

#[test]
fn an_error_of_energy_a_tenth_above_its_bound_fails() {
    let (_, mut run) = find("patch", None).expect("a case").solve().expect("solved");
    // Squares: 1.21 times the bound is a tenth more in the norm of energy.
    for (error, excess) in [(1.21, 0.1), (1.0, 0.0)] {
        run.solution.energy = Some(EnergyError { error, bound: 1.0 });
        let judged = case::universal::bounded(&run).expect("an energy");
        assert_relative_eq!(judged.value, excess, epsilon = 1e-7);
        assert_eq!(judged.verdict == case::Verdict::Pass, excess <= 0.0);
    }
}

#[test]
fn a_force_along_the_surface_is_found_whichever_way_it_acts() {
    for along in [-1.0, 1.0] {
        let (mut meshed, run) = find("truncated-hertz", None).expect("a case").solve().expect("solved");
        let made = &mut meshed.discretisation;
        let node = made.mesh.bodies[0].candidates[3].node;
        let system = &mut made.system.bodies[0];
        let equation =
            system.dofs.of_node(node).into_iter().zip(system.dofs.frame(node)).find(|(_, axis)| axis[1].abs() < 0.5);
        let equation = equation.and_then(|(dof, _)| dof.equation()).expect("free along x");
        system.force[equation] += 1e-3 * along * run.transmitted();
        let judged = case::universal::checks(made, &run).expect("checked");
        let tangential =
            judged.iter().find(|one| one.check.quantity.to_string().contains("tangential")).expect("a check");
        assert_eq!(tangential.verdict, case::Verdict::Fail, "{tangential:?}");
    }
}

#[test]
fn hoop_stresses_lie_at_angles_in_degrees() {
    let quantity = case::Quantity::on_arc(Quantity::HoopStress { at: 0.25 * TAU });
    assert_eq!(quantity.place().as_deref(), Some("at 90°"));
}

#[test]
fn the_document_tells_the_highest_of_its_points_and_what_the_iteration_took() {
    let document = json(&["solve", "pin-rod", "--no-error-bar"]);
    let contact = &document["contacts"][0];
    let number = |value: &Value| value.as_f64().expect("a number");
    let points = contact["profile"].as_array().expect("points");
    let highest = points.iter().max_by(|a, b| number(&a["pressure"]).total_cmp(&number(&b["pressure"])));
    let highest = highest.expect("a point");
    assert_eq!(contact["largest_point_pressure"], highest["pressure"]);
    assert_eq!(contact["largest_point_position"], highest["position"]);
    assert_ne!(contact["peak_position"], highest["position"]);
    let (_, run) = balance::solved(&find("pin-rod", None).expect("a case"), &kinematic());
    let work = run.solution.work;
    for (key, count) in [
        ("steps", work.iterations),
        ("factorisations", work.factorisations),
        ("back_substitutions", work.back_substitutions),
        ("retained", run.retained),
        ("rejected", work.rejected),
    ] {
        assert_eq!(document[key].as_u64(), Some(count as u64), "{key}");
    }
    assert_ne!(work.factorisations, work.back_substitutions);
    let pressed = || points.iter().filter(|point| number(&point["pressure"]) > 0.0);
    assert_eq!(contact["active_points"].as_u64(), Some(pressed().count() as u64));
    for (key, value, other) in [
        ("pressure_at_zero", run.measures().pressure_at_origin, "peak_pressure"),
        ("half_width_nodes", run.measures().half_width_nodes, "second_moment_width"),
    ] {
        assert_relative_eq!(number(&contact[key]), value, max_relative = 1e-12);
        assert_ne!(contact[key], contact[other]);
    }
}

#[test]
fn points_of_a_cell_of_high_order_are_written_evenly_spaced() {
    let case = find("truncated-hertz", None).expect("a case");
    let resolution = Resolution { order: Order::Quartic, ..case.resolution };
    let (made, run) = balance::solved_on(case.scene, resolution, &Formulation::verification());
    let piece = piece(&vtu::text(&made, &run).expect("written"));
    let IOBuffer::F64(points) = &piece.points else { panic!("no points") };
    let cell = made.mesh.cell(0);
    let mut along: Vec<f64> = cell.iter().map(|&node| points[3 * node]).collect();
    along.sort_by(f64::total_cmp);
    along.dedup_by(|a, b| (*a - *b).abs() <= 1e-9);
    // A rectangle: five columns of nodes, the outer ones at its corners.
    let corners = || cell.iter().map(|&node| made.mesh.points[node][0]);
    let [begin, end] = [corners().fold(f64::INFINITY, f64::min), corners().fold(f64::NEG_INFINITY, f64::max)];
    assert_eq!(along.len(), 5, "{along:?}");
    (0..5).for_each(|k| assert_relative_eq!(along[k], begin + (end - begin) * k as f64 / 4.0, epsilon = 1e-9));
}

#[test]
fn displacements_of_a_frd_are_those_of_its_last_state() {
    // Every node moves by 1 and 2 µm in the first state, by 3 and 4 µm in the last; places are in metres.
    let plain = Frd { length: 1000.0, ..Frd::plain() }.text();
    let nodes = plain.lines().skip_while(|line| !line.starts_with("    2C")).skip(1);
    let numbers: Vec<&str> = nodes.take_while(|line| line.starts_with(" -1")).map(|line| line[3..13].trim()).collect();
    let block = |state: usize| {
        let names = ["D1", "D2", "D3"].map(|name| format!(" -5  {name:<12}1    2    1    0\n")).concat();
        let moved = fixed([1.0, 2.0, 0.0].map(|x| x + 2.0 * (state as f64 - 1.0)));
        let row = |node: &&str| record(node.parse().expect("a number"), &moved);
        let head = format!("    1PSTEP{state:>26}{:>12}{state:>12}\n  100CL  101{state:>12.5E}\n", 1);
        format!("{head} -4  DISP        3    1\n{names}{} -3\n", numbers.iter().map(row).collect::<String>())
    };
    let text = plain.replace(" 9999\n", &(block(1) + &block(2) + " 9999\n"));
    let case = find("truncated-hertz", None).expect("a case");
    let units = [(Role::Position, "m"), (Role::Displacement, "um")].map(|(role, unit)| (role, unit.to_owned()));
    let asked = Asked { units: units.into(), ..Asked::default() };
    let source = Source { file: Path::new("a.frd"), text: &text };
    let field = frd::displacements((&source, &case.scene), &asked, (None, &BTreeMap::new()), None)
        .expect("read")
        .expect("a field");
    for [x, y] in field.displacement {
        assert_relative_eq!(x, 3e-3, max_relative = 1e-12);
        assert_relative_eq!(y, 4e-3, max_relative = 1e-12);
    }
    let furthest = |along: usize| field.points.iter().map(|place| place[along]).fold(0.0, f64::max);
    assert_relative_eq!(furthest(0), place(NODES - 1), max_relative = 1e-5);
    assert_relative_eq!(furthest(1), 0.5, max_relative = 1e-5);
}

#[test]
fn weights_and_moments_in_kilonewtons_and_metres_are_in_newtons_and_millimetres() {
    // 1 kN/m³ = 1e-6 N/mm³, 1 kN m = 1e6 N mm.
    let text = text_of("cylinder-in-metres.toml");
    let more = ", { body-force = [0, -77] }, { moment = { at = \"cut\", value = 2 } }]";
    let loaded =
        text.replace("value = [0, -0.226557162518] } }]", &format!("value = [0, -0.226557162518] }} }}{more}"));
    assert_ne!(text, loaded);
    let scene = parsed(&loaded).scene;
    let [_, Load::BodyForce([along, down]), Load::OnSide { action: Action::Moment(moment), .. }] =
        &scene.bodies[0].loads[..]
    else {
        panic!("{:?}", scene.bodies[0].loads)
    };
    assert!(along.abs() <= 0.0);
    assert_relative_eq!(*down, -77e-6, max_relative = 1e-12);
    assert_relative_eq!(*moment, 2e6, max_relative = 1e-12);
}

#[test]
fn parts_of_an_arc_are_given_in_degrees() {
    let scene = balance::scene("thin-wheel", &[["from = 0", "from = 15"]]).scene;
    let [Load::OnSide { part: Some(part), .. }] = &scene.bodies[0].loads[..] else {
        panic!("{:?}", scene.bodies[0].loads)
    };
    assert_relative_eq!(part.from, TAU / 24.0, max_relative = 1e-12);
    assert_relative_eq!(part.to, TAU / 12.0, max_relative = 1e-12);
}

#[test]
fn a_mesh_that_is_too_large_is_refused_with_the_bytes_of_its_cells_and_of_the_squares_of_its_candidates() {
    let (_, _, told) = contact_vv(&["solve", &scene("cylinder-in-metres"), "--resolution", "4096"]);
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    let number = |before: &str| {
        let (_, rest) = told.split_once(before).unwrap_or_else(|| panic!("{before}: {told}"));
        rest.split(' ').next().and_then(|word| word.parse::<f64>().ok()).unwrap_or_else(|| panic!("{before}: {told}"))
    };
    let [cells, candidates, bytes] = ["would have about ", "cells and ", "which take some "].map(number);
    assert_relative_eq!(candidates, 8192.0);
    // Told to two digits.
    assert_relative_eq!(bytes, 12e3 * cells + 512.0 * candidates * candidates, max_relative = 0.06);
}

#[test]
fn penetrations_that_no_point_sees_are_told_in_per_cent_of_the_approach() {
    let (meshed, mut run) = find("truncated-hertz", None).expect("a case").solve().expect("solved");
    let penetration = 0.05 * run.solution.contacts[0].approach;
    for (is_candidate, place) in [(true, "between contact points, at s = 1.5 mm"), (false, "beyond the candidates")] {
        let position = meshed.discretisation.scene.contact().path.reported(1.5);
        run.solution.unseen = vec![vec![Unseen { position, penetration, is_candidate }]];
        let notes = notes::of(&run, 0).join("; ");
        assert!(notes.contains(place) && notes.contains(" mm, 5.0 % of the approach"), "{notes}");
    }
}

#[test]
fn an_interference_is_held_against_the_smaller_extent_of_a_body() {
    // 0.6 mm of the lower block's height of 5, whose width is 10; 0.4 mm is less than a tenth.
    for (gap, is_deep) in [("-0.6", true), ("-0.4", false)] {
        let text = text_of("blocks.toml").replace("uniform = 0.01", &format!("uniform = {gap}"));
        let (meshed, run) = parsed(&text).solve().expect("solved");
        let doubts = plausible::doubts(&meshed.discretisation, &run).concat();
        assert_eq!(doubts.iter().any(|doubt| doubt.contains("within one another")), is_deep, "{gap}: {doubts:?}");
    }
}

#[test]
fn a_pressure_that_departs_by_a_hundredth_is_judged_as_that() {
    let check = Check::error(case::Quantity::Departure, Against::Oracle, 1e-8, "exact in the discrete space");
    let case = Case { checks: vec![check], ..find("patch", None).expect("a case") };
    let (meshed, mut run) = case.solve().expect("solved");
    let peak = run.measures().peak.pressure;
    run.solution.points[0].pressure += 0.01 * peak;
    let judged = case.judge(&meshed, &run).expect("judged");
    let departure = judged.iter().find(|one| one.check.quantity == case::Quantity::Departure).expect("a check");
    assert_relative_eq!(departure.value, 0.01, max_relative = 1e-5);
}

/// What is said of a block of modulus [`MODULUS`], so wide and so high, its `sides` held, that is pressed on a rigid
/// gap: of a plane one, or one of revolution where no side is held.
fn pressed(
    ([wide, high], sides): ([f64; 2], &[&str]),
    gap: &str,
    [force, stretch]: [f64; 2],
    (mesh, options): (&str, &[&str]),
) -> Value {
    let plane = if sides.is_empty() { "plane = \"axisymmetric\"" } else { "plane = \"strain\"\nthickness = 1.0" };
    let supports: String = sides.iter().map(|side| format!("{{ at = \"{side}\", component = \"x\" }}, ")).collect();
    let text = format!(
        "{plane}\nmesh = {{ {mesh} }}\n[[body]]\nname = \"b\"\nyoung = 210000.0\npoisson = 0.2\n\
         shape = {{ rectangle = {{ x = [0, {wide}], y = [0, {high}], contact = \"bottom\" }} }}\nsupports = \
         [{supports}]\n\
         loads = [{{ traction = {{ at = \"far\", force = [0, {}] }} }}]\n\
         [contact]\nfirst = \"b\"\ngap = {{ {gap} }}\nstretch = {stretch}\n",
        0.0 - force
    );
    json(&[&["solve", &Folder::made().with("block.toml", text)], options].concat())
}

/// E* of such a block \[MPa\].
const MODULUS: f64 = 210_000.0 / (1.0 - 0.2 * 0.2);

#[test]
fn half_widths_and_peaks_under_other_powers_than_the_second_lie_within_their_bars() {
    // The contact radius of c rⁿ under F, by the transform of the profile: F = 2E* c κ n/(n + 1) aⁿ⁺¹, κ = √π/2 · n
    // Γ(n/2)/Γ((n + 1)/2), with κ n/(n + 1) by n as given.
    let fitted = [
        (0.000507917816, 4.93, 3662.63089, 1.380742),
        (0.0005, 4.0, 4.0 * 4.0 / 3.0 * 4.0 / 5.0 * MODULUS * 0.0005, 1.0),
    ];
    let of_powers = |sides: &[&str], powers: &str, [force, stretch]: [f64; 2], asked: (&str, &[&str])| {
        pressed(([100.0 * stretch; 2], sides), &format!("powers = {powers}"), [force, stretch], asked)
    };
    for (c, n, force, radius) in fitted {
        let asked = ("elements = 8, per = 1.0", &["--fitted", "--order", "6"][..]);
        let solved = of_powers(&[], &format!("[[{c}, {n}]]"), [force, 1.9 * radius], asked);
        within_its_bar(&solved, "half-width", radius);
    }
    // The pressure of r^1.95 has a cusp: E* c κ n/(n − 1)/π aⁿ⁻¹ at r = 0.
    let asked: (&str, &[&str]) = ("accuracy = \"0.3 %\"", &[]);
    let cusp = of_powers(&[], "[[0.0005, 1.95]]", [286.389234, 1.9], asked);
    within_its_bar(&cusp, "peak-pressure", 141.538709);
    // On equal cells the peak of r^1.6 converges with the 0.3rd power of the dofs: layers towards the axis have it with
    // few.
    let kappa = 1.839430255;
    let force = 2.0 * MODULUS * 1.6 / 2.6 * kappa * 0.01 * 2_f64.powf(2.6);
    let layered = of_powers(&[], "[[0.01, 1.6]]", [force, 3.4], ("accuracy = \"0.1 %\"", &[]));
    assert!(layered["accuracy"]["unmet"].is_null() && layered["freedoms"].as_u64().is_some_and(|dofs| dofs <= 8000));
    let peak = MODULUS * 0.01 * kappa * 1.6 / 0.6 / PI * 2_f64.powf(0.6);
    within_its_bar(&layered, "peak-pressure", peak);
    within_its_bar(&layered, "half-width", 2.0);
    // Of r^1.15 no layers do, which is told at once.
    let hopeless = of_powers(&[], "[[0.002, 1.15]]", [581.5, 1.7], ("accuracy = \"0.1 %\"", &[]));
    assert!(
        hopeless["accuracy"]["unmet"].is_string() && hopeless["freedoms"].as_u64().is_some_and(|dofs| dofs <= 200_000)
    );
    // The peak of r^3.04 lies at 0.562 of the radius: E* c κ n/π ∫ tⁿ⁻¹/√(t² − r²) dt from r to a, by quadrature.
    let ridge = of_powers(&[], "[[0.00033, 3.04]]", [257.405193, 2.5], asked);
    within_its_bar(&ridge, "peak-pressure", 98.0658054);
    // Of c s²ᵏ on a half-plane: F/t = E* π/2 · (2k)!/(k! 2ᵏ)² · 2k c a²ᵏ, half of which the half carries; cells of high
    // order whose lines do not know the end.
    let half = 0.5 * MODULUS * std::f64::consts::FRAC_PI_2;
    for order in [5, 8] {
        let mesh = format!("elements = 12, per = 0.83, order = {order}");
        let force = half * 5.0 / 16.0 * 6.0 * 0.0003;
        within_its_bar(&of_powers(&["left"], "[[0.0003, 6]]", [force, 1.9], (&mesh, &[])), "half-width", 1.0);
    }
    // Steep at the end, where the slope is four times that of the parabola and more.
    let force = half * (0.5 * 2.0 * 1e-4 + 48_620.0 / 262_144.0 * 18.0 * 5e-5);
    let steep = of_powers(&["left"], "[[1e-4, 2], [5e-5, 18]]", [force, 1.9], ("accuracy = \"0.03 %\"", &[]));
    within_its_bar(&steep, "half-width", 1.0);
}

#[test]
fn an_end_that_all_meshes_read_at_a_node_that_they_share_is_not_exact() {
    // Two spheres of Hertz, whose contact ends at a node that the coarser meshes have too, or three hundredths of an
    // element beyond it.
    let folder = Folder::made();
    for beyond in [0.0, 0.03] {
        let radius: f64 = 0.3 * (1.0 + beyond / 12.0);
        let load = 112.521_976_948_622_76 * (radius / 0.3).powi(3);
        let text = balance::text("two-spheres").replace("-112.52197694862276", &(0.0 - load).to_string());
        let solved = json(&["solve", &folder.with("two.toml", text)]);
        within_its_bar(&solved, "half-width", radius);
        // A node draws the end to itself within a twentieth of an element, of which the coarser meshes tell nothing.
        let bars = solved["error_bars"].as_array().expect("bars");
        let bar = bars.iter().find(|one| one["quantity"] == "half-width").and_then(|one| one["bar"].as_f64());
        assert!(bar.is_some_and(|bar| bar >= 0.05 * 0.3 / 12.0 * (1.0 - 1e-9)), "{bar:?}");
    }
}

#[test]
fn a_sphere_departs_from_hertz_as_its_poisson_ratio_has_it() {
    for (poisson, a_over_r) in [(0.0, 0.02), (0.3, 0.02), (0.3, 0.005), (0.45, 0.02), (-0.5, 0.01)] {
        let material = Material { poisson, ..Material::STEEL };
        let scene = Scene::sphere_on_plane(50.0, material, a_over_r * 50.0);
        let of_hertz = scene.reference.pressure;
        let run = Fitted::of(Order::Octic, 3).solve(&scene, &Formulation::verification()).expect("solved").run;
        let departure = run.measures().peak.pressure / of_hertz - 1.0;
        let model = model_error(a_over_r, poisson);
        assert!(departure.abs() <= model, "ν = {poisson}, a/R = {a_over_r}: {departure}, {model}");
        // The first power is that of the formula, to a tenth and the square.
        let first = a_over_r * (1.0 - 2.0 * poisson).powi(2) / (5.0 * (1.0 - poisson));
        assert!((departure + first).abs() <= 0.1 * first + a_over_r * a_over_r, "{departure}, {first}");
    }
}

#[test]
fn the_pressure_in_the_cell_at_the_axis_is_that_of_hertz_and_a_tip_there_has_none() {
    let found = |name: &str| {
        let case = find(name, None).expect("known");
        Fitted::of(Order::Octic, 3).solve(&case.scene, &Formulation::verification()).expect("solved")
    };
    let edge_fitted::Answer { discretisation, run, .. } = found("truncated-sphere");
    let pressure = |at: f64| discretisation.number(&run, 0, &Quantity::Pressure { at }).expect("a number");
    let peak = discretisation.scene.reference.pressure;
    for at in [0.0, 0.5, 1.25, 1.7] {
        assert_relative_eq!(pressure(at), peak * (1.0_f64 - (at / 2.5).powi(2)).sqrt(), max_relative = 1e-6);
    }
    let (_, said, _) = contact_vv(&["solve", "cone", "--fitted"]);
    assert_eq!(said.matches("without limit").count(), 3, "{said}");
    let sheet = references::solve("cone").expect("solved");
    let peaks = sheet.values.iter().filter(|one| ["peak-pressure", "pressure at s = 0"].contains(&&*one.quantity));
    assert!(peaks.into_iter().all(|one| one.value.is_nan()));
}

#[test]
fn a_closed_form_is_not_accused_where_the_bar_is_unknown() {
    let steep = "powers = [[1e-9, 20]]";
    let asked: (&str, &[&str]) = ("elements = 10, per = 2.0", &[]);
    let oracle = format!("{steep} }}\noracle = {{ powers = {{ load = 5231.784780002088, terms = [[1e-9, 20]] }}");
    let solved = pressed(([80.0; 2], &[]), &oracle, [5231.784780002088, 3.4], asked);
    assert!(!solved.to_string().contains("is not of this scene"), "{solved}");
}

/// A block pressed on waves by a share of what presses them flat, to an accuracy, and its end: p̄ = p* sin²(πa/λ) with
/// p* = πE*Δ/λ.
fn waves(share: f64, [amplitude, wavelength]: [f64; 2], size: [f64; 2], stretch: f64, accuracy: &str) -> (Value, f64) {
    let load = share * PI * MODULUS * amplitude / wavelength * size[0];
    let gap = format!("cosine = {{ amplitude = {amplitude}, wavelength = {wavelength} }}");
    let mesh = format!("accuracy = \"{accuracy}\"");
    let waves = pressed((size, &["left", "right"]), &gap, [load, stretch], (&mesh, &[]));
    (waves, wavelength / PI * share.sqrt().asin())
}

#[test]
fn waves_touch_as_westergaard_has_it_on_a_high_block_and_nearly_pressed_flat() {
    // Nearly flat, the edge in which the contact ends presses by less than a thousandth of the peak: without its force
    // the end was a third of an element off.
    for (waves, end) in
        [waves(0.5, [0.01, 4.0], [2.0, 20.0], 1.5, "0.3 %"), waves(0.995, [0.01, 40.0], [20.0, 60.0], 20.0, "0.1 %")]
    {
        within_its_bar(&waves, "half-width", end);
    }
}

#[test]
fn waves_whose_candidates_hold_several_crests_are_found_to_an_accuracy() {
    // Three halves of a wave: 2p̄/sin(πa/λ) below the crests.
    let (waves, end) = waves(0.3, [0.002, 10.0], [15.0, 60.0], 15.0, "0.1 %");
    assert!(waves["accuracy"]["unmet"].is_null(), "{}", waves["accuracy"]);
    within_its_bar(&waves, "peak-pressure", 2.0 * PI * MODULUS * 0.002 / 10.0 * 0.3_f64.sqrt());
    // The outermost end is that beyond the crest at a wavelength.
    within_its_bar(&waves, "half-width", 10.0 + end);
}

/// That the truth lies within the bar of a number.
fn within_its_bar(solved: &Value, quantity: &str, truth: f64) {
    let bars = solved["error_bars"].as_array().expect("bars");
    let one = bars.iter().find(|one| one["quantity"] == quantity).expect("a number");
    let [value, bar] = ["value", "bar"].map(|key| one[key].as_f64().expect("known"));
    assert!((value - truth).abs() <= bar, "{quantity}: {value} ± {bar}, {truth}");
    assert!(bar <= 0.1 * truth, "{bar} says nothing");
}

#[test]
fn arcs_are_circles_and_what_a_line_has_of_uncertainty_is_an_angle_on_them() {
    let path = ScenePath::Arc(Circle { centre: [1.0, 2.0], radius: 5.0 });
    for s in [0.0, 0.3, 1.2] {
        let [x, y] = path.point(s);
        assert_relative_eq!(x, 1.0 + 5.0 * s.sin(), max_relative = 1e-15);
        assert_relative_eq!(y, 2.0 - 5.0 * s.cos(), max_relative = 1e-14);
        assert_relative_eq!(path.coordinate([x, y]), s, epsilon = 1e-15);
    }
    let rod = PinRod::default();
    assert_eq!(rod.scene().reference.gap, rod.clearance, "the gap of a pin with a clearance is that");
    struct Line;
    impl Oracle for Line {
        fn source(&self) -> oracle::Source {
            oracle::Source::new("line", "made up", "of this test")
        }
        fn read(&self, _: &Quantity) -> Reading {
            Reading::Value { value: 3.0, uncertainty: 0.6 }
        }
    }
    let on_arc = OnArc { straight: std::sync::Arc::new(Line), radius: 4.0 };
    let Reading::Value { value, uncertainty } = on_arc.read(&Quantity::HalfWidth) else { panic!("a value") };
    assert_eq!([value, uncertainty], [0.75, 0.15]);
}
