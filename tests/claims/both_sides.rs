//! Contact on both sides of x = 0: a symmetric scene gives what its half gives, any other one what equilibrium asks.

use approx::assert_relative_eq;
use contact_vv::case::Verdict;
use contact_vv::case::library::Patch;
use contact_vv::case::notes::{self, RESOLVED};
use contact_vv::error::Kind;
use contact_vv::measure::profile;
use contact_vv::mesh::Order;
use contact_vv::solution::PointState;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

use crate::balance;
use crate::scene_file::{changed, scene_alone, text_of, with_key};
use crate::workbench::{block_text, meshed, parsed, resolution};

/// A symmetric scene told by its right half, and whole.
struct Twin {
    name: &'static str,
    half: String,
    whole: String,
}

/// Its right half is the whole without what lies left of x = 0, held there by the first body's side.
fn twin(name: &'static str, whole: String, held: &str, changes: &[(&str, &str)]) -> Twin {
    let half = with_key(&whole, "supports", &format!("[{{ at = \"{held}\", component = \"x\" }}]"));
    let half = changed(&changed(&half, &[("both-sides = true\n", "")]), changes);
    Twin { name, half, whole }
}

fn twins() -> Vec<Twin> {
    let on_block = |gap: &str, stretch: f64| {
        let [stretch, per] = [format!("stretch = {stretch}"), format!("per = {stretch}")];
        let given = [("{ punch = 4 }", gap), ("stretch = 4", &stretch), ("per = 4", &per)];
        let whole = changed(&balance::text("block-on-punch"), &given);
        twin("block", whole, "left", &[("x = [-20, 20]", "x = [0, 20]")])
    };
    let mut all = vec![
        on_block("{ punch = 4 }", 4.0),
        on_block("{ parabola = 500 }", 4.0),
        on_block("{ wedge = 0.004 }", 4.0),
        on_block("{ table = [[0, 0], [2, 0.002], [6, 0.06]] }", 4.0),
        on_block("{ cosine = { amplitude = 0.004, wavelength = 9 } }", 20.0),
    ];
    let disc = changed(
        &scene_alone(&text_of("whole-disc.toml")),
        &[("-36.2491511", "-40"), ("elements = 12", "elements = 6")],
    );
    let turned =
        disc.replace("[0, 50]", "[0, -50]").replace("= true }", "= true, contact = \"top\" }").replace("-40", "40");
    for whole in [disc.clone(), turned] {
        // Cut off at the height of its centre.
        let below = changed(&whole, &[(", whole = true", ""), ("\"middle\"", "\"cut\"")]);
        all.push(twin("disc", below, "axis", &[]));
        all.push(twin("disc", whole, "axis", &[("whole = true", "half = true")]));
    }
    // A disc on a block whose nodes do not face its own, drawn.
    let block = "[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\ndensity = 0.7\n\
        shape = { rectangle = { x = [-30, 30], y = [-30, 0], contact = \"top\" } }\n\
        supports = [{ at = [0, -30], component = \"x\" }, { at = \"far\", component = \"y\" }]\n\n[contact]\nsecond = \
        \"block\"\n";
    let drawn = [("[contact]\n", block), ("{ circle = 50 }", "\"drawn\""), ("stretch = 1.5", "stretch = 2")];
    let halves = [("whole = true", "half = true"), ("[-30, 30]", "[0, 30]"), ("[0, -30]", "\"left\"")];
    all.push(twin("disc on block", changed(&disc, &drawn), "axis", &halves));
    all
}

fn solved(text: &str, element: Element, order: Order) -> (Discretisation, Run) {
    let file = parsed(text);
    let scene = file.scene.clone();
    let resolution = resolution(file.resolution.elements, 0, order);
    let discretisation = Discretisation::of(scene, resolution).expect("meshed");
    let formulation =
        Formulation { settings: file.formulation().settings, ..Formulation::new(element, Iteration::Kinematic) };
    let run = Run::of(&discretisation, &formulation).unwrap_or_else(|error| panic!("{error}\n{text}"));
    (discretisation, run)
}

#[test]
fn symmetric_scene_on_both_sides_gives_what_its_half_gives() {
    for Twin { name, half, whole } in twins() {
        for (element, order) in
            Element::ALL.into_iter().flat_map(|element| [Order::Linear, Order::Quadratic].map(|order| (element, order)))
        {
            let place = format!("{name}, {element:?}, {order:?}:\n{whole}");
            let [(_, half), (whole_scene, whole)] = [&half, &whole].map(|text| solved(text, element, order));
            assert!(half.solution.converged() && whole.solution.converged(), "{place}");
            assert_eq!(half.solution.work.iterations, whole.solution.work.iterations, "{place}");
            for of in [
                |run: &Run| run.measures().second_moment_width,
                |run: &Run| run.measures().half_width_nodes,
                |run: &Run| run.measures().peak.pressure,
                |run: &Run| run.measures().edge(),
                |run: &Run| run.measures().resultant,
                |run: &Run| run.transmitted(),
            ] {
                let error = (of(&whole) / of(&half) - 1.0).abs();
                assert!(error <= 1e-9, "{error:e} of {} in {place}", of(&half));
            }
            let (ours, theirs) = (&whole.solution.points, &half.solution.points);
            let right = ours.len() - theirs.len();
            for (k, (own, of_half)) in ours[right..].iter().zip(theirs).enumerate() {
                let left = &ours[ours.len() - 1 - (right + k)];
                let scale = 1e-9 * half.measures().peak.pressure;
                assert!((own.position - of_half.position).abs() <= 1e-9, "{place}");
                assert!((own.pressure - of_half.pressure).abs() <= scale, "{k}: {place}");
                assert!((left.position + own.position).abs() <= 1e-9, "{place}");
                assert!((left.pressure - own.pressure).abs() <= scale, "{k}: {place}");
            }
            assert!(whole.measures().centre.abs() <= 1e-9 * whole.measures().second_moment_width, "{place}");
            assert!(whole_scene.scene.contact().begin() < 0.0);
        }
    }
}

/// A block under `100 + slope x` on a rigid plane.
fn eccentric(slope: f64) -> String {
    let text = include_str!("../cases/eccentric-load.toml");
    assert!(text.contains("coefficients = [100, 4]"));
    text.replace("coefficients = [100, 4]", &format!("coefficients = [100, {slope}]"))
}

/// A block whose upper side stays flat on a rigid wedge with its edge at `x`, its slopes 0.01.
fn wedge(x: f64, stretch: f64) -> String {
    let [left, right] = [0.01 * (x + 5.0), 0.01 * (5.0 - x)];
    let contact = format!(
        "both-sides = true\nstretch = {stretch}\ngap = {{ table = [[-5, {left}], [{x}, 0], [5, {right}]] \
        }}\n[reference]\n\
         length = 1\npressure = 2000\n[mesh]\nelements = 40\nper = 4\ngrowth = {{ coarsest = 0.1 \
         }}\n[solve]\ntolerance = 1e-8"
    );
    let face = "rigid-face = { at = \"far\", component = \"y\", force = -4615.3846 }";
    block_text([-40.0, 40.0], 40.0, face, &contact)
}

#[test]
fn wedge_off_the_centre_presses_as_one_at_the_centre_and_its_mirror_image_mirrored() {
    // Wedge on a half-plane: P = E* a tan β, p = (E* tan β / π) arccosh(a/|x|), second moment 2a/√6; a = 2 mm.
    let [right, left] = [1.0, -1.0].map(|x| solved(&wedge(x, 4.0), Element::Node, Order::Quadratic).1);
    let pressure = |x: f64| 210e3 / 0.91 * 0.01 / std::f64::consts::PI * (2.0_f64 / x.abs()).acosh();
    assert_relative_eq!(right.measures().centre, 1.0, max_relative = 0.005);
    assert_relative_eq!(right.measures().second_moment_width, 4.0 / 6.0_f64.sqrt(), max_relative = 0.005);
    for x in [-1.5, -1.0, -0.5, 0.5, 1.0, 1.5] {
        let found = profile::interpolate(&right.solution.points, 4.0, 1.0 + x);
        assert_relative_eq!(found, pressure(x), max_relative = 0.01);
    }
    assert!((right.measures().peak.position - 1.0).abs() <= 0.05, "{:?}", right.measures().peak);
    let mirrored = left.solution.points.iter().rev();
    for (own, other) in right.solution.points.iter().zip(mirrored) {
        assert!((own.position + other.position).abs() <= 1e-9);
        assert!((own.pressure - other.pressure).abs() <= 1e-9 * right.measures().peak.pressure);
    }
    assert_relative_eq!(left.measures().centre, -right.measures().centre, max_relative = 1e-9);
    assert_relative_eq!(left.measures().second_moment_width, right.measures().second_moment_width, max_relative = 1e-9);
    assert_relative_eq!(left.measures().begin(), -right.measures().edge(), max_relative = 1e-9);
}

#[test]
fn contact_beyond_the_candidates_is_refused_on_either_side() {
    // The contact of half-width 2 mm about the edge of the wedge reaches 3 mm to one side.
    for x in [1.0, -1.0] {
        let file = parsed(&wedge(x, 2.5));
        let error = Discretisation::of(file.scene.clone(), file.resolution)
            .and_then(|discretisation| discretisation.solve(file.formulation()))
            .map(|_| ())
            .expect_err("candidates end in the contact");
        let Kind::ContactBeyondCandidates { end, deepest } = error.kind else { panic!("{error}") };
        if let Some((position, _)) = deepest {
            assert!(position.value() * x > end.value() * x, "{position} lies beyond {end}");
        }
        assert_relative_eq!(end.value(), 2.5 * x, max_relative = 1e-9);
    }
}

#[test]
fn contact_on_few_points_is_noted_by_those_on_each_side() {
    for (elements, noted) in [(2, true), (3, false), (12, false)] {
        for Twin { half, whole, .. } in &twins()[5..6] {
            let [half, whole] = [half, whole].map(|text| {
                let text = text.replace("elements = 6", &format!("elements = {elements}\norder = 1"));
                let (_, run) = parsed(&text).solve().expect("solved");
                (notes::of(&run, 0).iter().any(|note| note.contains("refine before quoting")), run.measures().active)
            });
            assert_eq!((half.0, whole.0), (noted, noted), "{} and {} points", half.1, whole.1);
            assert_eq!(whole.1, 2 * half.1 - 1);
        }
    }
    // A patch of two edges rests on all it has.
    let patch = meshed(Patch::default().scene(), 2, Order::Linear);
    let patch = Run::of(&patch, &Formulation::verification()).expect("solved");
    assert!(patch.measures().active < RESOLVED[0] && notes::of(&patch, 0).is_empty(), "{:?}", notes::of(&patch, 0));
}

#[test]
fn pressures_that_oscillate_are_noted_within_the_contact_wherever_it_lies() {
    // The load lifts one side of the block off.
    for slope in [15.0, -15.0] {
        let text = eccentric(slope).replace("elements = 4\n", "elements = 16\n");
        let (_, run) = parsed(&text).solve().expect("solved");
        let [begin, end] = [run.measures().begin(), run.measures().edge()];
        let [middle, reach] = [0.5 * (begin + end), 0.5 * (end - begin)];
        assert!(middle.abs() > 1.0 && notes::of(&run, 0).is_empty(), "{middle}: {:?}", notes::of(&run, 0));
        for (part, noted) in [(-0.95, false), (-0.7, true), (0.0, true), (0.7, true), (0.95, false)] {
            let mut bent = run.clone();
            let away = |point: &PointState| (point.position - middle - part * reach).abs();
            let at = bent.solution.points.iter_mut().min_by(|a, b| away(a).total_cmp(&away(b))).expect("points");
            at.pressure += 0.2 * run.measures().peak.pressure;
            let notes = notes::of(&bent, 0);
            assert_eq!(
                notes.iter().any(|note| note.contains("quote means over edges, or refine the mesh")),
                noted,
                "{slope}, {part}"
            );
        }
    }
}

#[test]
fn blocks_that_cross_the_middle_are_the_rectangle() {
    let rectangle = parsed(&eccentric(4.0));
    let blocks = eccentric(4.0).replace(
        "{ rectangle = { x = [-10, 10], y = [0, 8], contact = \"bottom\" } }",
        "{ blocks = [{ corners = [[-10, 0], [4, 0], [4, 8], [-10, 8]], elements = [7, 4], bottom = \"contact\", top = \
        \"far\" }, { corners = [[4, 0], [10, 0], [10, 8], [4, 8]], elements = [3, 4], bottom = \"contact\", top = \
        \"far\" }] }",
    );
    let blocks = blocks.replace("elements = 4\nper = 10\n", "").replace("at = [0, 8]", "at = [4, 8]");
    let (_, run) = parsed(&blocks).solve().expect("solved");
    let (_, plain) = rectangle.solve().expect("solved");
    for point in &run.solution.points {
        assert_relative_eq!(point.pressure, 100.0 + 4.0 * point.position, max_relative = 1e-7);
    }
    assert_relative_eq!(run.transmitted(), plain.transmitted(), max_relative = 1e-9);
    assert_eq!(run.solution.points.len(), 21);
}

#[test]
fn pressure_at_the_ends_of_the_candidates_is_on_the_line_through_the_last_two_points() {
    let text = text_of("eccentric-load.toml").replace("[solve]", "[solve]\nelement = \"line\"");
    let file = parsed(&text);
    let (meshed, run) = file.solve().expect("solved");
    let [first, .., last] = run.solution.points[..] else { panic!("points") };
    assert!(first.position > -10.0 && last.position < 10.0);
    let checks = file.judge(&meshed, &run).expect("judged");
    let error = |place: &str| {
        checks.iter().find(|check| check.check.quantity.to_string().contains(place)).expect("a check").error
    };
    // Navier's 60 and 140 MPa, beyond every point.
    assert!((first.pressure - 60.0).abs() > 1.0 && (last.pressure - 140.0).abs() > 1.0);
    for place in ["s = -10 mm", "s = 10 mm"] {
        assert!(error(place) < 1e-8, "{place}: {}", error(place));
    }
}

#[test]
fn point_far_above_the_peak_is_noted() {
    let kinked = text_of("eccentric-load.toml")
        .replace("coefficients = [100, 4]", "coefficients = [100, -12]")
        .replace("gap = { uniform = 0 }", "gap = { table = [[-10, 0], [0, 0], [10, 0.05]] }");
    for (text, wanted) in [(text_of("eccentric-load.toml"), false), (kinked, true)] {
        let file = parsed(&text);
        let (_, run) = file.solve().expect("solved");
        assert_eq!(
            notes::of(&run, 0).iter().any(|note| note.contains("more than the peak")),
            wanted,
            "{:?}",
            notes::of(&run, 0)
        );
    }
}

#[test]
fn check_of_zero_is_judged_by_an_absolute_tolerance_in_the_unit_of_the_file() {
    let in_metres = [
        ("thickness = 2.0", "thickness = 0.002"),
        ("x = [-10, 10], y = [0, 8]", "x = [-0.01, 0.01], y = [0, 0.008]"),
        ("at = [0, 8]", "at = [0, 0.008]"),
        ("coefficients = [100, 4]", "coefficients = [100, 4000]"),
        ("stretch = 10", "stretch = 0.01"),
        ("length = 8", "length = 0.008"),
        ("per = 10", "per = 0.01"),
    ];
    let alone = scene_alone(&text_of("eccentric-load.toml"));
    let metres = "units = { length = \"m\" }\n".to_owned() + &changed(&alone, &in_metres);
    // The centre lies 4/3 mm off.
    for (text, tolerance, verdict) in [
        (&alone, "1.3", Verdict::Fail),
        (&alone, "1.4", Verdict::Pass),
        (&metres, "1.3e-3", Verdict::Fail),
        (&metres, "1.4e-3", Verdict::Pass),
    ] {
        let file = parsed(&format!("{text}\n[[check]]\nquantity = \"centre\"\nvalue = 0\ntolerance = {tolerance}\n"));
        let (meshed, run) = file.solve().expect("solved");
        let judged = file.own(&meshed.discretisation, &run).expect("judged");
        assert_eq!(judged[0].verdict, verdict, "{tolerance}");
    }
}
