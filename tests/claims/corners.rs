//! Corners that are pressed: the exponent of the pressure by contact mechanics, and on meshes; and what no point and no
//! coarser mesh sees.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_abs_diff_eq;
use contact_vv::accuracy::{self, Asked, Quantity};
use contact_vv::case::{Case, notes};
use contact_vv::error::Kind;
use contact_vv::solve::wedge::{Wedge, exponent};
use contact_vv::solve::{Discretisation, Run};

use crate::balance::{barred, scene, solved, told_of};
use crate::workbench::{block_text, kinematic, parsed};

const FREE: Wedge = Wedge { angle: FRAC_PI_2, modulus: 1.0, held: None };

#[test]
fn compliance_of_wedges_is_the_closed_form() {
    for (angle, lambda) in [(PI, 0.3_f64), (FRAC_PI_2, 0.6), (2.0, 0.45), (1.0, 0.9)] {
        let (double, single) = ((2.0 * lambda * angle).sin(), (lambda * angle).sin());
        let below = lambda * (single.powi(2) - (lambda * f64::sin(angle)).powi(2));
        let closed = -(double + lambda * f64::sin(2.0 * angle)) / below;
        assert_abs_diff_eq!(Wedge { angle, ..FREE }.compliance(lambda), closed, epsilon = 1e-10 * closed.abs());
        // A face on rollers is the line of symmetry of a wedge of twice the angle, pressed on both faces.
        let closed = 2.0 / lambda * (f64::cos(2.0 * angle) - f64::cos(2.0 * lambda * angle))
            / (double + lambda * f64::sin(2.0 * angle));
        let rollers = Wedge { angle, held: Some([0.0, 1.0]), ..FREE };
        assert_abs_diff_eq!(rollers.compliance(lambda), closed, epsilon = 1e-10 * closed.abs());
    }
}

#[test]
fn exponents_at_corners_are_the_known_ones() {
    let plane = Wedge::half_plane(1.0);
    let of = |wedges: &[Wedge]| exponent(wedges);
    assert_abs_diff_eq!(of(&[plane]).expect("a rigid punch"), 0.5, epsilon = 1e-12);
    assert_abs_diff_eq!(of(&[plane, Wedge::half_plane(70.0)]).expect("any moduli"), 0.5, epsilon = 1e-12);
    // A right angle on a half-plane of the same modulus (Dundurs & Lee 1972).
    assert_abs_diff_eq!(of(&[FREE, plane]).expect("a block"), 0.7740, epsilon = 1e-4);
    // On a half-plane stiffer by a hundred 1 − λ goes with 4/π² of the ratio.
    let stiff = of(&[FREE, Wedge::half_plane(100.0)]).expect("a stiff body");
    assert_abs_diff_eq!(1.0 - stiff, 0.04 / (PI * PI), epsilon = 5e-5);
    // Symmetry lines and corners of the same right angle leave a uniform pressure.
    let rollers = Wedge { held: Some([0.0, 1.0]), ..FREE };
    let other = Wedge { modulus: 70.0, ..FREE };
    for finite in [vec![FREE], vec![FREE, other], vec![rollers], vec![rollers, rollers]] {
        assert!(of(&finite).is_none(), "{finite:?}");
    }
    // On a rigid plane more than a right angle sticks out.
    assert!(of(&[Wedge { angle: 1.6, ..FREE }]).is_some() && of(&[Wedge { angle: 1.5, ..FREE }]).is_none());
    assert!(of(&[Wedge { modulus: f64::NAN, ..FREE }]).is_none() && of(&[Wedge { angle: f64::NAN, ..FREE }]).is_none());
}

/// `corner.toml` with other shapes and with a lower body of another modulus.
fn corner(shapes: &[[&str; 2]], young: &str) -> Case {
    scene("corner", &[&[["young = 2000", young]], shapes].concat())
}

/// The two blocks as rectangles, with so many elements on the contact.
fn rectangles(elements: &'static str) -> Vec<[&'static str; 2]> {
    vec![
        [UPPER, r#"{ rectangle = { x = [0, 10], y = [0, 10], contact = "bottom" } }"#],
        [LOWER, r#"{ rectangle = { x = [0, 20], y = [-10, 0], contact = "top" } }"#],
        ["\"sym-u\"", "\"left\""],
        ["\"load\"", "\"far\""],
        ["\"sym-l\"", "\"left\""],
        ["\"fix\"", "\"far\""],
        ["stretch = 10", elements],
    ]
}

const UPPER: &str = r#"{ gmsh = { file = "corner.msh", group = "upper", contact = "cu" } }"#;
const LOWER: &str = r#"{ gmsh = { file = "corner.msh", group = "lower", contact = "cl" } }"#;

#[test]
fn peak_under_a_corner_on_a_far_stiffer_body_has_no_limit_whatever_the_mesh_shows() {
    let on_rectangles = rectangles("stretch = 10\n[mesh]\nelements = 16\nper = 10");
    for shapes in [&[][..], &on_rectangles] {
        let case = corner(shapes, "young = 100000");
        let (discretisation, run) = solved(&case, &kinematic());
        let run = run.with_limits(&discretisation).expect("told");
        let found = run.contacts[0].unbounded.expect("no limit");
        assert_abs_diff_eq!(found.position.value(), 10.0, epsilon = 1e-9);
        assert_abs_diff_eq!(found.exponent.expect("a corner"), 0.004024, epsilon = 1e-6);
        assert!(notes::of(&run, 0).iter().any(|note| note.contains("r^-0.0040")), "{:?}", notes::of(&run, 0));
        let answer = accuracy::solve(&case.scene, &kinematic(), &Asked::new(3e-3)).expect("solved");
        assert!(answer.unmet.is_some_and(|why| why.contains("no limit")));
    }
}

#[test]
fn pressure_towards_a_corner_grows_on_meshes_as_its_exponent_says() {
    for (young, lambda) in [("young = 1000", 0.7740), ("young = 100", 0.5557)] {
        let at = |elements| {
            let (discretisation, run) = solved(&corner(&rectangles(elements), young), &kinematic());
            let run = run.with_limits(&discretisation).expect("told");
            let exponent = run.contacts[0].unbounded.and_then(|one| one.exponent).expect("a corner");
            let last = run.solution.edges_of(0).last().expect("edges").pressure;
            (last, exponent)
        };
        let (coarse, _) = at("stretch = 10\n[mesh]\nelements = 128\nper = 10");
        let (fine, exponent) = at("stretch = 10\n[mesh]\nelements = 256\nper = 10");
        assert_abs_diff_eq!(1.0 - exponent, lambda, epsilon = 1e-4);
        assert_abs_diff_eq!((fine / coarse).log2(), exponent, epsilon = 0.05);
    }
}

#[test]
fn corner_that_is_not_pressed_leaves_a_peak_its_limit() {
    // A crowned top touches inside its corners.
    let crowned = [["gap = { uniform = 0 }", "gap = { parabola = 20 }"]];
    let on_rectangles = rectangles("stretch = 10\n[mesh]\nelements = 32\nper = 10");
    for shapes in [crowned.to_vec(), [&crowned[..], &on_rectangles].concat()] {
        let (discretisation, run) = solved(&corner(&shapes, "young = 2000"), &kinematic());
        assert!(run.measures().edge() < 9.0, "{}", run.measures().edge());
        let run = run.with_limits(&discretisation).expect("told");
        assert!(run.contacts[0].unbounded.is_none());
    }
}

#[test]
fn peak_under_a_corner_has_no_limit_whatever_meshes_the_bodies() {
    let block = |[x, y]: [i32; 2], names: &str| {
        let corners = [[x, y], [x + 10, y], [x + 10, y + 10], [x, y + 10]];
        format!("{{ corners = {corners:?}, elements = [8, 8], {names} }}")
    };
    let blocks = |all: &[String]| format!("{{ blocks = [{}] }}", all.join(", "));
    let upper = blocks(&[block([0, 0], r#"bottom = "contact", top = "load", left = "sym-u""#)]);
    let left = block([0, -10], r#"bottom = "fix", top = "contact", left = "sym-l""#);
    let wide = blocks(&[left.clone(), block([10, -10], r#"bottom = "fix", top = "contact""#)]);
    let as_blocks = [[UPPER, &upper], [LOWER, &wide]];
    let as_rectangles = rectangles("stretch = 10\n[mesh]\nelements = 16\nper = 10");
    for case in [scene("corner", &[]), scene("corner", &as_blocks), scene("corner", &as_rectangles)] {
        let (discretisation, run) = solved(&case, &kinematic());
        let run = run.with_limits(&discretisation).expect("finer meshes");
        let corner = run.contacts[0].unbounded.expect("no limit");
        assert!((corner.position.value() - 10.0).abs() < 1e-9 && corner.growth > 0.05, "{corner:?}");
        let answer = accuracy::solve(&case.scene, &kinematic(), &Asked::new(1e-2)).expect("solved");
        assert!(answer.run.contacts[0].unbounded.is_some());
        // Known after a few cheap meshes, one of which meets what is asked of the half-width.
        assert!(answer.dofs_in_all() < 15_000, "{} dofs", answer.dofs_in_all());
        assert!(answer.estimates.iter().all(|one| one.relative() <= 1e-2 || one.value.is_nan()));
        assert!(answer.unmet.is_some_and(|why| why.contains("no limit")));
    }
    // With the blocks as wide as one another the pressure is the load, and has one.
    let case = scene("corner", &[[UPPER, &upper], [LOWER, &blocks(&[left])]]);
    let (discretisation, run) = solved(&case, &kinematic());
    assert!(run.with_limits(&discretisation).expect("finer meshes").contacts[0].unbounded.is_none());
}

#[test]
fn second_place_that_touches_between_nodes_beyond_the_candidates_is_refused() {
    let case = scene("far", &[]);
    let discretisation = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    let error = Run::of(&discretisation, &kinematic()).expect_err("it touches at s = 12, too");
    let Kind::ContactBeyondCandidates { deepest: Some((at, depth)), .. } = error.kind else { panic!("{error}") };
    assert!((at.value() - 12.0).abs() < 0.2 && depth > 1e-3, "{error}");
    let (_, seen) = solved(&scene("far-seen", &[]), &kinematic());
    assert!(seen.solution.converged() && seen.measures().stretches.len() == 2);
}

#[test]
fn asperity_narrower_than_an_element_is_noted() {
    let gap = "gap = { table = [[0, 0], [0.3, 0.0005], [0.59, 0.0017], [0.6, 0], [0.61, 0.0018], [2, 0.02], [20, 2]], \
        smooth = true }";
    let was = "gap = { even = [0.001, -1.388888888888889e-05, 4.822530864197531e-08] }";
    for (elements, told) in [("elements = 3", true), ("elements = 25", false)] {
        let case = scene("far", &[[was, gap], ["elements = 6", elements]]);
        let (_, run) = solved(&case, &kinematic());
        let notes = notes::of(&run, 0);
        let found = notes.iter().any(|note| note.contains("between contact points, at s = 0.6 mm"));
        assert_eq!(found, told, "{elements}: {notes:?}");
    }
}

#[test]
fn bar_of_a_peak_contains_a_sharp_top_that_all_meshes_miss_alike() {
    let (_, bars) = barred(&scene("flat", &[]), &kinematic());
    let one = told_of(&bars.all, &Quantity::PeakPressure);
    let error = (one.value - 45.154570).abs();
    // It is about as large as the number itself: a bar that holds it says nothing.
    let why = one.unknown.unwrap_or("known");
    assert!(
        error > 0.9 * one.value && one.bar.total().is_nan() && why.contains("larger than the number"),
        "{error}, {why}"
    );
    // On smaller elements it is a number, and the bar holds its error.
    let (run, bars) = barred(&scene("flat", &[["elements = 4", "elements = 40"]]), &kinematic());
    let bar = bars.of(0, &Quantity::PeakPressure).expect("a bar").total();
    let error = (run.measures().peak.pressure - 45.154570).abs();
    assert!(error <= bar, "{error} against {bar}");
}

#[test]
fn bar_of_a_peak_beside_points_between_which_surfaces_penetrate_is_unknown() {
    // The truth is 389.207 MPa; the coarser meshes pass over the top alike, and gave a bar of 151 MPa about 182.
    let (_, bars) = barred(&scene("flat-25", &[]), &kinematic());
    let one = told_of(&bars.all, &Quantity::PeakPressure);
    let why = one.unknown.unwrap_or("known");
    assert!(one.bar.total().is_nan() && why.contains("penetrate one another between points"), "{one:?}");
}

#[test]
fn bar_of_the_place_of_a_flat_peak_contains_where_it_lies() {
    let (run, bars) = barred(&scene("place", &[]), &kinematic());
    let bar = bars.of(0, &Quantity::PeakPlace).expect("a bar").total();
    let error = (run.measures().peak.position - 1.0).abs();
    assert!(error <= bar && bar < 0.2, "{error} against {bar}");
}

#[test]
fn half_width_is_half_of_begin_to_end_and_no_second_moment() {
    // A flat of 10 mm with rounded edges: the contact ends at 5.34 mm, where its second moment says 7.37.
    let (run, bars) = barred(&scene("rounded-punch", &[]), &kinematic());
    let measures = run.measures();
    // Its top at the rounding is narrower than the elements.
    for (quantity, found, right) in
        [(Quantity::PeakPressure, measures.peak.pressure, 1522.4), (Quantity::HalfWidth, measures.half_width(), 5.343)]
    {
        let bar = bars.of(0, &quantity).expect("a bar").total();
        assert!((found - right).abs() <= bar && bar < 0.36 * right, "{found} ± {bar}, {right}");
    }
    assert!((measures.half_width() - 5.343).abs() < 0.12, "{}", measures.half_width());
    assert!(measures.second_moment_width > 7.0, "{}", measures.second_moment_width);
    assert!((measures.half_width() - measures.edge()).abs() <= 0.0);
}

#[test]
fn peak_on_one_point_is_unresolved_and_not_without_limit() {
    let case = scene("hardly-touching", &[]);
    let (discretisation, run) = solved(&case, &kinematic());
    let run = run.with_limits(&discretisation).expect("coarser meshes");
    assert!(run.contacts[0].unbounded.is_none());
    assert!(notes::of(&run, 0).iter().any(|note| note.contains("rests on 1 of")), "{:?}", notes::of(&run, 0));
}

/// Mirrored at the rigid plane the side is a half-plane whose shear leaps by 2τ: `p = (4τ/π) ln 1/r`, `(4τ/π) ln 2`
/// more a halving.
#[test]
fn a_side_sheared_down_to_the_contact_leaves_its_peak_without_limit_and_one_that_is_pressed_does_not() {
    let of = |shear: f64, mesh: &str| {
        let load = format!(
            "traction = {{ at = \"far\", value = [0, -50] }} }}, {{ traction = {{ at = \"right\", value = [-7, \
            {shear}] }}"
        );
        parsed(&block_text(
            [0.0, 20.0],
            30.0,
            &load,
            &format!("gap = {{ uniform = 0 }}\nstretch = 20\n[mesh]\nper = 20\n{mesh}"),
        ))
    };
    for mesh in ["elements = 4", "elements = 32", "elements = 8\norder = 4"] {
        let case = of(-20.0, mesh);
        let (discretisation, run) = solved(&case, &kinematic());
        let found = run.with_limits(&discretisation).expect("meshes").contacts[0].clone();
        let growth = found.unbounded.expect("no limit").growth;
        assert_abs_diff_eq!(growth * found.measures.peak.pressure, 80.0 / PI * 2.0_f64.ln(), epsilon = 1e-9);
    }
    let answer = accuracy::solve(&of(-20.0, "elements = 4").scene, &kinematic(), &Asked::new(0.2)).expect("solved");
    assert!(answer.unmet.is_some_and(|why| why.contains("no limit")));
    // Sheared away from the contact it falls there, and opens.
    let [falls, none] = [20.0, 0.0].map(|shear| {
        let (discretisation, run) = solved(&of(shear, "elements = 8"), &kinematic());
        run.with_limits(&discretisation).expect("meshes").contacts[0].unbounded
    });
    assert!(falls.is_none() && none.is_none(), "{falls:?}, {none:?}");
    // On meshes it grows by as much.
    let [coarse, fine] = ["elements = 16\norder = 4", "elements = 32\norder = 4"].map(|mesh| {
        let (_, run) = solved(&of(-20.0, mesh), &kinematic());
        run.measures().peak.pressure
    });
    assert_abs_diff_eq!(fine - coarse, 80.0 / PI * 2.0_f64.ln(), epsilon = 0.2);
}

#[test]
fn a_peak_in_the_last_element_may_lie_anywhere_in_it() {
    let load = "pressure = { at = \"far\", law = { uniform = 10 } } }, { pressure = { at = \"far\", part = { along = \
        \"x\", from = 7, to = 8 }, law = { uniform = 10 } }";
    let place = |mesh: &str| {
        let contact = format!("gap = {{ uniform = 0 }}\nstretch = 10\n[mesh]\nper = 10\n{mesh}");
        let (_, bars) = barred(&parsed(&block_text([0.0, 10.0], 15.0, load, &contact)), &kinematic());
        let one = told_of(&bars.all, &Quantity::PeakPlace);
        (one.value, one.bar.total())
    };
    let (truth, near) = place("elements = 32\norder = 6");
    assert!(truth < 9.8 && near < 0.1, "{truth} ± {near}");
    for mesh in ["elements = 8", "elements = 16", "elements = 16\norder = 1"] {
        let (value, bar) = place(mesh);
        assert!((value - truth).abs() <= bar + near, "{mesh}: {value} ± {bar} beside {truth}");
    }
}
