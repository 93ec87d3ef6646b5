//! The gap given in a contact and the gap between the drawn bodies are one, or the file says that they need not be;
//! what a table of gaps is.

use std::f64::consts::{FRAC_PI_2, SQRT_2};
use std::path::Path;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy;
use contact_vv::case::{Case, library};
use contact_vv::mesh::{Mesh, Resolution, candidates};
use contact_vv::scene::{Circle, Curve, DrawnGap, MonotoneCubic, Profile, Scene};

use crate::balance::solved_as_it_says;
use crate::scene_file::{changed, folder, scene_alone, text_of, with_key};
use crate::workbench::{parsed, refused};

/// What a file gets in place of what it has.
type Change = (&'static str, &'static str);

fn text_with(name: &str, changes: &[Change]) -> String {
    changed(&scene_alone(&text_of(&format!("{name}.toml"))), changes)
}

fn read(name: &str, changes: &[Change]) -> Result<Case, String> {
    Case::parse(&folder().join(format!("{name}.toml")), &text_with(name, changes)).map_err(|error| error.to_string())
}

fn profile(name: &str, changes: &[Change], contact: usize) -> Profile {
    let file = read(name, changes).unwrap_or_else(|error| panic!("{error}"));
    file.scene.contacts[contact].profile.clone()
}

/// Height of a circle's lower arc above its lowest point.
fn arc(radius: f64, s: f64) -> f64 {
    radius - (radius * radius - s * s).sqrt()
}

const HOLE: &[Change] = &[
    ("inner = 40, outer = 70", "inner = 40.05, outer = 70"),
    ("gap = { uniform = -0.02 }", "gap = { hole = { radius = 40, clearance = 0.05 } }"),
    ("ring = { centre = [0, 0], inner = 40.05", "ring = { centre = [0, 0.05], inner = 40.05"),
];
/// A lower block whose upper side falls from 0 to −0.1 at x = 10.
const INCLINED: Change = (
    "{ rectangle = { x = [0, 10], y = [-5, 0], contact = \"top\" } }",
    "{ blocks = [{ corners = [[0, -5], [10, -5], [10, -0.1], [0, 0]], elements = [8, 4], bottom = \"far\", \
     right = \"right\", top = \"contact\", left = \"left\" }] }",
);

#[test]
fn gap_other_than_the_drawn_one_is_taken_where_that_is_said_and_refused_where_it_is_not() {
    // What is said of one change alone stands in tests/data/refused.toml.
    for (name, changes, wanted) in [
        ("blocks", &[INCLINED, ("uniform = 0.01", "wedge = 0.02")][..], ["at s = 10", "the gap is 0.2"]),
        ("press-fit", &[HOLE[0], HOLE[1]], ["at s = 0", "and 0.05 between"]),
        // s²/100 but for the left side; a tenth less curved.
        (
            "whole-disc",
            &[("{ circle = 50 }", "{ table = [[-1.5, 0.03], [-0.75, 0.011], [0, 0], [0.75, 0.0056], [1.5, 0.0225]] }")],
            ["at s = -1.26", "and 0.016"],
        ),
        ("two-cylinders", &[("gap = \"drawn\"", "gap = { parabola = 20 }")], ["at s = ", "between the drawn bodies"]),
    ] {
        let error = read(name, changes).map(|_| ()).expect_err(name);
        assert!(wanted.iter().chain(&["`gap-only = true`"]).all(|part| error.contains(part)), "{error}");
        read(name, &[changes, &[("gap = ", "gap-only = true\ngap = ")]].concat())
            .unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn gap_alike_and_drawings_that_tell_no_gap_are_taken() {
    for (name, changes) in [
        // A parabola with the curvature of both circles.
        ("two-cylinders", &[("gap = \"drawn\"", "gap = { parabola = 18.75 }")][..]),
        ("blocks", &[("y = [-5, 0]", "y = [-5, -0.01]")]),
        ("blocks", &[INCLINED, ("uniform = 0.01", "wedge = 0.01")]),
        // Flat sides on one another, or on the line of the contact.
        ("blocks", &[("uniform = 0.01", "parabola = 300")]),
        ("rigid-cosine", &[]),
        // Rings drawn on one circle.
        ("press-fit", &[]),
        ("press-fit", &[HOLE[1]]),
        ("press-fit", HOLE),
    ] {
        read(name, changes).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn gap_from_the_bodies_is_that_of_their_circles() {
    let cylinders = profile("two-cylinders", &[("gap = \"drawn\"", "gap = { from = \"bodies\" }")], 0);
    let whole = profile("whole-disc", &[("{ circle = 50 }", "{ from = \"bodies\" }")], 0);
    // A second contact: at the highest point, the plate above.
    let above = profile("roller-between-plates", &[("{ circle = 50 }", "{ from = \"bodies\" }")], 0);
    for s in [0.0, 1e-3, 0.4, 1.1, 1.2] {
        for (gap, wanted) in [
            (cylinders.gap(s), arc(50.0, s) + arc(30.0, s)),
            (whole.gap(s), arc(50.0, s)),
            (whole.gap(-s), arc(50.0, s)),
            (above.gap(s), arc(50.0, s)),
        ] {
            assert_relative_eq!(gap, wanted, epsilon = 1e-13);
        }
    }
    // No other side where the block has ended.
    let block = profile("cylinder-on-block", &[("{ circle = 50 }", "{ from = \"bodies\" }")], 0);
    assert!(block.gap(50.1).is_infinite());
    let hole = profile("press-fit", &[HOLE[0], HOLE[2], ("{ uniform = -0.02 }", "{ from = \"bodies\" }")], 0);
    let wanted = Profile::Hole { radius: 40.0, clearance: 0.05 };
    for angle in [0.0, 0.3, 1.0, 1.5] {
        assert_relative_eq!(hole.gap(angle), wanted.gap(angle), epsilon = 1e-13);
    }
}

#[test]
fn gap_from_meshes_and_blocks_is_that_of_their_curves() {
    // Rings of a mesh with edges that do not face one another: interference everywhere, no sag of the edges in it.
    let rings = profile("rings-from-gmsh", &[("gap = \"drawn\"", "gap = { from = \"bodies\" }")], 0);
    for k in 0..=60 {
        assert_relative_eq!(rings.gap(f64::from(k) / 60.0 * FRAC_PI_2), -0.02, epsilon = 1e-6);
    }
    let inclined = profile("blocks", &[INCLINED, ("{ uniform = 0.01 }", "{ from = \"bodies\" }")], 0);
    for s in [0.0, 2.5, 10.0] {
        assert_relative_eq!(inclined.gap(s), 0.01 * s, epsilon = 1e-14);
    }
}

#[test]
fn gap_from_the_bodies_needs_no_reference_and_gives_hertz() {
    let file =
        read("two-cylinders", &[("gap = \"drawn\"", "gap = { from = \"bodies\" }"), ("pressure = 1562", "gap = 1562")]);
    let scene = file.expect("sound").scene;
    let without = text_with("two-cylinders", &[("gap = \"drawn\"", "gap = { from = \"bodies\" }")])
        .replace("[reference]\nlength = 1.0\npressure = 1562.80524\n", "");
    let file = parsed(&without);
    assert!(file.scene.reference.gap < scene.reference.gap);
    for scene in [file.scene.clone(), file.scene.mirrored()] {
        let (_, run) = solved_as_it_says(&Case { scene, ..file.clone() });
        assert_relative_eq!(run.measures().peak.pressure, 1562.80524, max_relative = 2e-3);
        assert_relative_eq!(run.measures().second_moment_width, 1.0, max_relative = 2e-3);
    }
}

#[test]
fn gaps_are_the_same_in_metres_and_mirrored() {
    let bodies = |name: &str, gap: &str| {
        let text = scene_alone(&text_of(&format!("{name}.toml"))).replace("uniform = -0.02", "uniform = -0.01");
        let text = text.replace("inner = 40, outer = 70", "inner = 39.99, outer = 70");
        parsed(&text.replacen(gap, "{ from = \"bodies\" }", 1)).scene
    };
    let smooth = "{ table = [[-10, 1], [-3, 0.1], [1, 0], [12, 1]], smooth = true, clearance = 0.02 }";
    for (scene, places) in [
        (bodies("whole-disc", "{ circle = 50 }"), &[-1.3, -0.7, -0.1, 0.1, 0.7, 1.3][..]),
        (bodies("press-fit", "{ uniform = -0.01 }"), &[0.1, 0.7, 1.3]),
        (gapped("eccentric-load", smooth, &[]).scene, &[-9.5, -2.0, 0.3, 8.0]),
    ] {
        let (metres, mirrored, path) = (scene.in_metres(), scene.mirrored(), &scene.contact().path);
        let unit = if path.is_straight() { 1e-3 } else { 1.0 };
        for &s in places {
            let gap = scene.contact().gap(s);
            assert!(gap.abs() > 0.0 && gap.is_finite(), "{}: {gap}", scene.name);
            assert_relative_eq!(metres.contact().gap(unit * s), 1e-3 * gap, epsilon = 1e-15);
            let image = if path.has_both_sides() { -s } else { s };
            assert_relative_eq!(mirrored.contact().gap(image), gap, epsilon = 1e-13);
        }
    }
}

#[test]
fn circles_of_both_sides_are_exact_and_lose_no_digits() {
    for (radii, s, wanted) in [
        ([50.0, 30.0], 1.1, arc(50.0, 1.1) + arc(30.0, 1.1)),
        ([50.0, -60.0], 2.5, arc(50.0, 2.5) - arc(60.0, 2.5)),
        ([-60.0, 50.0], -40.0, arc(50.0, 40.0) - arc(60.0, 40.0)),
        ([50.0, -60.0], 50.0, arc(50.0, 50.0) - arc(60.0, 50.0)),
    ] {
        assert_relative_eq!(Profile::Circles { radii }.gap(s), wanted, max_relative = 1e-12);
    }
    // Radii that differ by a billionth: s²/2 (1/R1 − 1/R2) but for (s/R)², where the difference of both arcs has no
    // digit left.
    let (s, radii) = (0.01_f64, [50.0_f64, -50.000_000_05]);
    let parabola = 0.5 * s * s * (radii[0] + radii[1]).abs() / (50.0 * 50.000_000_05);
    assert_relative_eq!(Profile::Circles { radii }.gap(s), parabola, max_relative = 1e-6);
}

#[test]
fn circles_given_are_held_against_the_drawn_ones_and_refused_where_they_overlap_or_end() {
    let with = |gap: &'static str| read("two-cylinders", &[("gap = \"drawn\"", gap)]);
    let given = with("gap = { circles = [50, 30] }").expect("the drawn ones").scene;
    let drawn = profile("two-cylinders", &[("gap = \"drawn\"", "gap = { from = \"bodies\" }")], 0);
    for s in [0.0, 0.4, 1.5] {
        assert_relative_eq!(given.contact().profile.gap(s), drawn.gap(s), epsilon = 1e-13);
        let metres = given.in_metres().contact().profile.gap(1e-3 * s);
        assert_relative_eq!(metres, 1e-3 * drawn.gap(s), epsilon = 1e-16);
    }
}

const KINKED: &str = "{ table = [[0, 0], [1.3, 0.01], [2.9, 0.04], [3, 0.05], [20, 2]] }";

/// A file with another gap, and other changes.
fn gapped(name: &str, gap: &str, changes: &[(&str, &str)]) -> Case {
    let text = with_key(&scene_alone(&text_of(&format!("{name}.toml"))), "gap", gap);
    parsed(&changed(&text, changes))
}

/// Contact coordinates at which the candidate edges of a body begin and end.
fn ends(scene: &Scene, resolution: Resolution, body: usize) -> Vec<[f64; 2]> {
    let mesh = Mesh::of(scene, resolution).expect("meshed");
    let pair = scene.contact();
    let edges = candidates::candidate_edges(&mesh, scene, pair, body).expect("edges");
    let of = |node: usize| pair.path.coordinate(mesh.points[node]);
    edges.iter().map(|edge| [of(edge[0]).min(of(edge[1])), of(edge[0]).max(of(edge[1]))]).collect()
}

#[test]
fn no_edge_of_either_body_straddles_a_kink() {
    let gap_only = ("stretch = ", "gap-only = true\nstretch = ");
    for (name, gap, changes, kinks) in [
        ("rigid-cosine", KINKED, &[][..], &[1.3, 2.9, 3.0][..]),
        ("rigid-cosine", KINKED, &[("elements = 16", "elements = 2")], &[1.3, 2.9, 3.0]),
        ("rigid-cosine", KINKED, &[("per = 8", "per = 8\ngrowth = { end = 4 }")], &[1.3, 2.9, 3.0]),
        ("cylinder-on-block", KINKED, &[gap_only], &[1.3, 2.9, 3.0]),
        ("whole-disc", "{ table = [[-2, 1], [-1.1, 0.2], [0.4, 0], [2, 1]] }", &[gap_only], &[-1.1, 0.4]),
        ("eccentric-load", "{ table = [[0, 0], [3.3, 0.01], [12, 1]] }", &[], &[3.3, -3.3]),
        // Two contacts on one side of a body.
        ("plate-on-two-supports", "{ table = [[0, 0], [0.33, 0.01], [3, 1]] }", &[], &[0.33, -0.33]),
    ] {
        let file = gapped(name, gap, changes);
        let (scene, resolution) = (&file.scene, file.resolution);
        for body in scene.contact().bodies() {
            let ends = ends(scene, resolution, body);
            for kink in kinks {
                let within = |[a, b]: &&[f64; 2]| *a < kink - 1e-9 && *b > kink + 1e-9;
                assert_eq!(ends.iter().find(within), None, "{name}: {kink}");
                assert!(ends.iter().flatten().any(|end| (end - kink).abs() < 1e-9), "{name}: no node at {kink}");
            }
        }
    }
}

#[test]
fn elements_are_about_as_many_as_asked_and_no_longer() {
    let asked = gapped("rigid-cosine", "{ wedge = 0.1 }", &[]);
    let longest = |file: &Case| {
        let ends = ends(&file.scene, file.resolution, 0);
        (ends.len(), ends.iter().map(|[a, b]| b - a).fold(0.0, f64::max))
    };
    let (count, size) = longest(&asked);
    for (gap, more) in [(KINKED, 3), ("{ table = [[0, 0], [7, 0.1], [20, 0.4]] }", 1)] {
        let (kinked, longest) = longest(&gapped("rigid-cosine", gap, &[]));
        assert!(kinked >= count && kinked <= count + more, "{kinked} edges for {count}");
        assert!(longest <= 1.06 * size, "{longest} for {size}");
    }
    // Points in line are no kinks.
    assert_eq!(longest(&gapped("rigid-cosine", "{ table = [[0, 0], [7.1, 0.71], [20, 2]] }", &[])), (count, size));
}

/// Points of a parabola of this radius.
fn parabola(radius: f64, step: f64, count: u32) -> String {
    let points = (0..=count).map(|k| f64::from(k) * step).map(|s| format!("[{s}, {}]", s * s / (2.0 * radius)));
    points.collect::<Vec<_>>().join(", ")
}

fn peak(file: &Case, elements: usize) -> f64 {
    let resolution = Resolution { elements, ..file.resolution };
    solved_as_it_says(&Case { resolution, ..file.clone() }).1.measures().peak.pressure
}

#[test]
fn smooth_table_of_a_parabola_is_pressed_as_the_parabola() {
    let points = parabola(2000.0, 2.0, 10);
    let exact = gapped("rigid-cosine", "{ parabola = 2000 }", &[]);
    let smooth = gapped("rigid-cosine", &format!("{{ table = [{points}], smooth = true }}"), &[]);
    for elements in [8, 16] {
        assert_relative_eq!(peak(&smooth, elements), peak(&exact, elements), max_relative = 1e-9);
    }
    assert!(smooth.scene.contact().profile.kinks().is_empty());
}

#[test]
fn smooth_table_goes_through_its_points_with_a_continuous_slope_and_never_beyond_them() {
    let points = [[-4.0, 3.0], [-2.5, 2.9], [-2.0, 0.5], [-0.5, 0.0], [1.0, 0.0], [1.1, 0.3], [3.0, 0.35], [4.0, 9.0]];
    let cubic = MonotoneCubic::through(&points);
    let step = 1e-6;
    for ends in points.windows(2) {
        let [[a, g], [b, h]] = [ends[0], ends[1]];
        assert_abs_diff_eq!(cubic.gap(a), g, epsilon = 1e-14);
        assert_abs_diff_eq!(cubic.gap(b), h, epsilon = 1e-14);
        let between: Vec<f64> = (0..=200).map(|k| cubic.gap(a + (b - a) * f64::from(k) / 200.0)).collect();
        let rises = between.windows(2).all(|two| (two[1] - two[0]) * (h - g).signum() >= -1e-13);
        assert!(rises, "not monotone from {a} to {b}");
    }
    for (point, slope) in points.iter().zip(&cubic.slopes).skip(1).take(points.len() - 2) {
        let one_sided = [-step, step].map(|d| (cubic.gap(point[0] + d) - cubic.gap(point[0])) / d);
        one_sided.iter().for_each(|found| assert_abs_diff_eq!(found, slope, epsilon = 1e-3));
    }
    assert!(cubic.gap(4.1).is_infinite() && cubic.gap(-4.1).is_infinite());
}

#[test]
fn curvature_leaps_where_an_arc_goes_over_into_a_line_and_nowhere_among_points_of_a_wave() {
    let arc = |s: f64| if s < 0.4 { [0.5 * s * s / 0.4, s / 0.4] } else { [s - 0.2, 1.0] };
    let through = |places: &[f64], of: &dyn Fn(f64) -> [f64; 2]| MonotoneCubic {
        points: places.iter().map(|&s| [s, of(s)[0]]).collect(),
        slopes: places.iter().map(|&s| of(s)[1]).collect(),
    };
    let few = through(&[0.0, 0.2, 0.4, 1.0, 3.0], &arc);
    assert_eq!(few.leaps(), [0.4]);
    let places: Vec<f64> = (0..=64).map(|k| f64::from(k) / 20.0).collect();
    assert!(through(&places, &|s| [1.0 + 0.5 * s * s - s.cos(), s + s.sin()]).leaps().is_empty());
    // On both sides of an even gap, within the known ends of the contact alone.
    let mut pair = library::find("truncated-hertz", None).expect("known").scene.contacts.remove(0);
    pair.profile = Profile::Smooth(std::sync::Arc::new(few));
    assert_eq!(pair.profile.leaps(), [-0.4, 0.4]);
    for (end, leaps) in [(0.7, &[0.4][..]), (0.3, &[]), (0.4001, &[])] {
        pair.ends.places = vec![end];
        assert_eq!(pair.leaps(), leaps, "{end}");
    }
    pair.ends.places.clear();
    assert!(pair.leaps().is_empty());
}

#[test]
fn drawn_corner_leaps_by_its_angle_whatever_is_curved_beside_it_and_however_far_the_other_side_goes() {
    let path = contact_vv::scene::Path::Straight { origin: [0.0, 0.0], both_sides: false };
    // A flat of 2 mm, then a fillet whose tangent turns away by an angle at once, over a block of 1 m.
    for (radius, angle) in [(2.0, 0.0), (0.05, 0.0), (2.0, 0.01), (0.05, 0.3)] {
        let (sin, cos) = f64::sin_cos(angle);
        let centre = [2.0 - radius * sin, radius * cos];
        let end = [centre[0] + radius * f64::sin(angle + 0.5), centre[1] - radius * f64::cos(angle + 0.5)];
        let punch = vec![Curve::Line([[0.0, 0.0], [2.0, 0.0]]), Curve::Arc { centre, ends: [[2.0, 0.0], end] }];
        let block = vec![Curve::Line([[0.0, 0.0], [1000.0, 0.0]])];
        let tips = Profile::Bodies(DrawnGap { sides: vec![punch, block], path, above: true }.into()).tips();
        let wanted = if angle > 0.0 { vec![[2.0, angle.tan()]] } else { vec![] };
        let tips = tips.expect("curves tell");
        assert_eq!(tips.len(), wanted.len(), "{radius} {angle}: {tips:?}");
        for (found, wanted) in tips.iter().zip(&wanted) {
            assert_abs_diff_eq!(found[0], wanted[0], epsilon = 1e-12);
            assert_relative_eq!(found[1], wanted[1], max_relative = 1e-6);
        }
    }
}

#[test]
fn arcs_whose_ends_are_rounded_by_their_file_meet_and_turn_by_no_more_than_that() {
    let centre = [0.0, 0.0];
    let path = contact_vv::scene::Path::Arc(Circle { centre, radius: 40.02 });
    for digits in 8..=12_i32 {
        let rounded = |x: f64| format!("{x:.*e}", digits as usize - 1).parse::<f64>().expect("a number");
        let side = |radius: f64, count: u32| {
            let at = |k: u32| {
                let (sin, cos) = (FRAC_PI_2 * f64::from(k) / f64::from(count)).sin_cos();
                [radius * sin, -radius * cos].map(rounded)
            };
            (0..count).map(|k| Curve::Arc { centre, ends: [at(k), at(k + 1)] }).collect::<Vec<_>>()
        };
        let sides = vec![side(40.02, 18), side(40.0, 13)];
        let tips = Profile::Bodies(DrawnGap { sides, path, above: true }.into()).tips();
        // Half a unit of the last digit at both coordinates of three ends, the middle one twice.
        let most = 4.0 * SQRT_2 * 0.5 * 10_f64.powi(2 - digits) / (FRAC_PI_2 / 18.0);
        for [s, leap] in tips.expect("curves tell") {
            assert!(leap <= most, "{digits} digits at {s}: {leap}");
        }
    }
}

#[test]
fn smooth_table_that_begins_at_0_is_even_and_flat_there() {
    let cubic = Profile::Smooth(std::sync::Arc::new(MonotoneCubic::through(&[[0.0, 0.0], [1.0, 0.3], [2.0, 0.7]])));
    assert_relative_eq!(cubic.gap(-0.6), cubic.gap(0.6));
    assert_abs_diff_eq!(cubic.gap(1e-4), 0.0, epsilon = 1e-7);
}

#[test]
fn accuracy_is_not_promised_where_kinks_fix_the_mesh() {
    let text = |smooth: &str| {
        let gap = format!("gap = {{ table = [{}]{smooth} }}", parabola(2000.0, 2.0, 10));
        let text =
            scene_alone(&text_of("rigid-cosine.toml")).replace("elements = 16\nper = 8\n", "accuracy = \"5 %\"\n");
        text.replace("gap = { cosine = { amplitude = 0.01, wavelength = 40 } }", &gap)
    };
    let error = Case::parse(Path::new("kinks.toml"), &text("")).map(|_| ()).expect_err("kinks").to_string();
    let line = 1 + text("")[..text("").find("accuracy = ").expect("a place")].matches('\n').count();
    assert!(error.starts_with(&format!("kinks.toml:{line}: ")), "{error}");
    assert!(error.contains("has kinks") && error.contains("`smooth = true`"), "{error}");
    let smooth = parsed(&text(", smooth = true"));
    let asked = smooth.accuracy.clone().expect("an accuracy");
    let kinked = gapped("rigid-cosine", KINKED, &[]).scene;
    let error = accuracy::solve(&kinked, smooth.formulation(), &asked).map(|_| ()).expect_err("kinks").to_string();
    assert!(error.contains("has kinks"), "{error}");
    assert!(accuracy::solve(&smooth.scene, smooth.formulation(), &asked).expect("solved").unmet.is_none());
}

#[test]
fn table_of_too_many_kinks_is_refused_with_what_has_none() {
    let waves = (0..3000).map(|k| format!("[{}, {}]", 0.006 * f64::from(k), 0.1 + 0.01 * f64::from(k % 2)));
    let gap = format!("gap = {{ table = [{}] }}", waves.collect::<Vec<_>>().join(", "));
    let text = text_of("rigid-cosine.toml").replace("gap = { cosine = { amplitude = 0.01, wavelength = 40 } }", &gap);
    refused(Case::parse(Path::new("many.toml"), &text), &["candidate elements", "`smooth = true` for the table"]);
}
