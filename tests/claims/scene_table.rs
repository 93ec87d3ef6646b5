//! A gap given as a table: no element edge straddles one of its kinks, and `smooth = true` leaves it none.

use std::path::Path;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy;
use contact_vv::case::{Case, library};
use contact_vv::mesh::{Mesh, Resolution, candidates};
use contact_vv::scene::{MonotoneCubic, Profile, Scene};
use contact_vv::solve::{Discretisation, Run};

use crate::scene_file::{changed, scene_alone, text_of, with_key};
use crate::workbench::parsed;

const KINKED: &str = "{ table = [[0, 0], [1.3, 0.01], [2.9, 0.04], [3, 0.05], [20, 2]] }";

/// A file with another gap, and other changes.
fn read(name: &str, gap: &str, changes: &[(&str, &str)]) -> Case {
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
        let file = read(name, gap, changes);
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
    let asked = read("rigid-cosine", "{ wedge = 0.1 }", &[]);
    let longest = |file: &Case| {
        let ends = ends(&file.scene, file.resolution, 0);
        (ends.len(), ends.iter().map(|[a, b]| b - a).fold(0.0, f64::max))
    };
    let (count, size) = longest(&asked);
    for (gap, more) in [(KINKED, 3), ("{ table = [[0, 0], [7, 0.1], [20, 0.4]] }", 1)] {
        let (kinked, longest) = longest(&read("rigid-cosine", gap, &[]));
        assert!(kinked >= count && kinked <= count + more, "{kinked} edges for {count}");
        assert!(longest <= 1.06 * size, "{longest} for {size}");
    }
    // Points in line are no kinks.
    assert_eq!(longest(&read("rigid-cosine", "{ table = [[0, 0], [7.1, 0.71], [20, 2]] }", &[])), (count, size));
}

/// Points of a parabola of this radius.
fn parabola(radius: f64, step: f64, count: u32) -> String {
    let points = (0..=count).map(|k| f64::from(k) * step).map(|s| format!("[{s}, {}]", s * s / (2.0 * radius)));
    points.collect::<Vec<_>>().join(", ")
}

fn peak(file: &Case, elements: usize) -> f64 {
    let resolution = Resolution { elements, ..file.resolution };
    let discretisation = Discretisation::of(file.scene.clone(), resolution).expect("meshed");
    Run::of(&discretisation, file.formulation()).expect("solved").measures().peak.pressure
}

#[test]
fn smooth_table_of_a_parabola_is_pressed_as_the_parabola() {
    let points = parabola(2000.0, 2.0, 10);
    let exact = read("rigid-cosine", "{ parabola = 2000 }", &[]);
    let smooth = read("rigid-cosine", &format!("{{ table = [{points}], smooth = true }}"), &[]);
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
fn smooth_table_that_begins_at_0_is_even_and_flat_there() {
    let cubic = Profile::Smooth(std::sync::Arc::new(MonotoneCubic::through(&[[0.0, 0.0], [1.0, 0.3], [2.0, 0.7]])));
    assert_relative_eq!(cubic.gap(-0.6), cubic.gap(0.6));
    assert_abs_diff_eq!(cubic.gap(1e-4), 0.0, epsilon = 1e-7);
}

#[test]
fn smooth_table_is_the_same_in_metres_and_mirrored() {
    let file = read("eccentric-load", "{ table = [[-10, 1], [-3, 0.1], [1, 0], [12, 1]], smooth = true }", &[]);
    let scene = &file.scene;
    let (metres, mirrored) = (scene.in_metres(), scene.mirrored());
    for s in [-9.5, -2.0, 0.3, 8.0] {
        let gap = scene.contact().profile.gap(s);
        assert_relative_eq!(metres.contact().profile.gap(1e-3 * s), 1e-3 * gap, max_relative = 1e-12);
        assert_relative_eq!(mirrored.contact().profile.gap(-s), gap, max_relative = 1e-12);
    }
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
    let kinked = read("rigid-cosine", KINKED, &[]).scene;
    let error = accuracy::solve(&kinked, smooth.formulation(), &asked).map(|_| ()).expect_err("kinks").to_string();
    assert!(error.contains("has kinks"), "{error}");
    assert!(accuracy::solve(&smooth.scene, smooth.formulation(), &asked).expect("solved").unmet.is_none());
}

#[test]
fn table_of_too_many_kinks_is_refused_with_what_has_none() {
    let waves = (0..3000).map(|k| format!("[{}, {}]", 0.006 * f64::from(k), 0.1 + 0.01 * f64::from(k % 2)));
    let gap = format!("gap = {{ table = [{}] }}", waves.collect::<Vec<_>>().join(", "));
    let text = text_of("rigid-cosine.toml").replace("gap = { cosine = { amplitude = 0.01, wavelength = 40 } }", &gap);
    let error = Case::parse(Path::new("many.toml"), &text).map(|_| ()).expect_err("kinks").to_string();
    assert!(error.contains("candidate elements") && error.contains("`smooth = true` for the table"), "{error}");
}
