//! The gap given in a contact and the gap between the drawn bodies are one, or the file says that they need not be.

use approx::assert_relative_eq;
use contact_vv::case::Case;
use contact_vv::scene::Profile;
use contact_vv::solve::{Discretisation, Run};

use crate::scene_file::{changed, folder, scene_alone, text_of};
use crate::workbench::parsed;

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
        assert_relative_eq!(rings.gap(f64::from(k) / 60.0 * std::f64::consts::FRAC_PI_2), -0.02, epsilon = 1e-6);
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
        let discretisation = Discretisation::of(scene, file.resolution).expect("meshed");
        let run = Run::of(&discretisation, file.formulation()).expect("solved");
        assert_relative_eq!(run.measures().peak.pressure, 1562.80524, max_relative = 2e-3);
        assert_relative_eq!(run.measures().second_moment_width, 1.0, max_relative = 2e-3);
    }
}

#[test]
fn gap_from_the_bodies_is_the_same_in_metres_and_mirrored() {
    let tilted = ("gap = { uniform = -0.01 }", "gap = { from = \"bodies\" }");
    for (name, change) in [("whole-disc", ("{ circle = 50 }", "{ from = \"bodies\" }")), ("press-fit", tilted)] {
        let text = scene_alone(&text_of(&format!("{name}.toml"))).replace("uniform = -0.02", "uniform = -0.01");
        let text = text.replace("inner = 40, outer = 70", "inner = 39.99, outer = 70").replacen(change.0, change.1, 1);
        let scene = parsed(&text).scene;
        let (metres, mirrored) = (scene.in_metres(), scene.mirrored());
        let unit = if scene.contact().path.is_straight() { 1e-3 } else { 1.0 };
        let sides: &[f64] = if scene.contact().path.has_both_sides() { &[1.0, -1.0] } else { &[1.0] };
        for s in [0.1, 0.7, 1.3].iter().flat_map(|s| sides.iter().map(move |side| side * s)) {
            let gap = scene.contact().profile.gap(s);
            assert!(gap.abs() > 0.0 && gap.is_finite(), "{name}: {gap}");
            assert_relative_eq!(metres.contact().profile.gap(unit * s), 1e-3 * gap, epsilon = 1e-15);
            let image = if sides.len() > 1 { -s } else { s };
            assert_relative_eq!(mirrored.contact().profile.gap(image), gap, epsilon = 1e-13);
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
    // Radii that differ by a billionth: s²/2 (1/R1 − 1/R2) but for (s/R)², where the difference of both arcs has no digit left.
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
