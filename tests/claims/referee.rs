//! The referee finds what is wrong with an answer, and lets a right one pass, whatever its mesh.

use approx::assert_relative_eq;
use contact_vv::case::library::{NAMES, TruncatedHertz, find};
use contact_vv::measure::{Measures, Quantity};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::referee::export::own;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::{Asked, Profile, Truth, Verdicts, verdicts};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

use crate::balance::solved_on;
use crate::handed::{PRESSURES, failed, judged_as, read, table};
use crate::workbench::{every_case, truth};

/// The truth of truncated Hertz, whose closed form is exact.
fn hertz() -> &'static Truth {
    truth("truncated-hertz")
}

fn judged(truth: &Truth, text: &str, asked: &Asked) -> Verdicts {
    judged_as(truth, "theirs.csv", text, asked)
}

/// Those on our own answer as it is exported.
fn judged_ours(truth: &Truth, discretisation: &Discretisation, run: &Run) -> Verdicts {
    let text = serde_json::to_string(&own::answer(&truth.case.name, discretisation, run)).expect("JSON");
    judged_as(truth, "ours.json", &text, &Asked::default())
}

/// A profile on uneven places, finer on the right; from the middle on or on both sides.
struct Sampled {
    places: Vec<f64>,
    pressures: Vec<f64>,
}

impl Sampled {
    /// The closed form on edges that grow and shrink by turns.
    fn of(truth: &Truth, both: bool) -> Self {
        let a = TruncatedHertz::default().half_width();
        let mut right = vec![0.0];
        for k in 0..200 {
            let step = a * [0.04, 0.07, 0.05, 0.03][k % 4];
            right.push(right[k] + step);
            if right[k + 1] > 1.3 * a {
                break;
            }
        }
        let mut left: Vec<f64> = (1..20).map(|k| -0.07 * a * f64::from(k)).collect();
        left.reverse();
        let places = if both { [left, right].concat() } else { right };
        let pressures = places.iter().map(|s| truth.pressure(0, *s)).collect();
        Self { places, pressures }
    }

    fn text(&self) -> String {
        table(PRESSURES, self.places.iter().zip(&self.pressures).map(|(s, p)| [*s, *p]))
    }

    fn scaled(mut self, place: f64, pressure: f64) -> Self {
        self.places.iter_mut().for_each(|s| *s *= place);
        self.pressures.iter_mut().for_each(|p| *p *= pressure);
        self
    }
}

/// The verdicts on our own answer, which is met, and measured as what `solve` says.
fn judged_as_solved(truth: &Truth, discretisation: &Discretisation, run: &Run) -> Verdicts {
    let name = format!("{}, {}", truth.case.name, run.formulation.name());
    let found = judged_ours(truth, discretisation, run);
    assert!(found.met() && found.absent.is_empty(), "{name}: {:?}", failed(&found));
    for (ruled, contact) in found.ruled.iter().zip(&run.contacts) {
        let numbers = |own: &Measures| [own.peak.pressure, own.second_moment_width, own.resultant];
        for (theirs, ours) in numbers(&ruled.measures).into_iter().zip(numbers(&contact.measures)) {
            assert!((theirs - ours).abs() <= 1e-9 * ours.abs(), "{name}: {theirs} for {ours}");
        }
    }
    found
}

/// Straight lines are no edges of an answer where they are as long as the contact: a trapezoid of Hertz's force and
/// second moment is none of his.
#[test]
fn a_trapezoid_of_the_right_force_and_width_is_not_met_however_densely_it_is_sampled() {
    let a = TruncatedHertz::default().half_width();
    let peak = hertz().pressure(0, 0.0);
    let (flat, end) = (0.841 / 2.0 * a, 2.3006 / 2.0 * a);
    let trapezoid = |s: f64| peak * ((end - s) / (end - flat)).clamp(0.0, 1.0);
    let rows = table(PRESSURES, (0..1000).map(|k| 2e-3 * a * f64::from(k)).map(|s| [s, trapezoid(s)]));
    let found = failed(&judged(hertz(), &rows, &Asked::default()));
    assert!(found.iter().any(|one| one.contains("mean pressures")), "{found:?}");
}

/// As a line through the mesh of another code is sampled: an end is told to within an edge of that, and not within two
/// samples.
#[test]
fn samples_along_the_straight_lines_of_an_answer_are_met_as_its_nodes_are() {
    let a = TruncatedHertz::default().half_width();
    let edge = a / 9.7;
    let at_node = |k: usize| hertz().pressure(0, edge * k as f64);
    let sampled = |s: f64| {
        let (k, share) = ((s / edge).floor(), (s / edge).fract());
        at_node(k as usize) * (1.0 - share) + at_node(k as usize + 1) * share
    };
    for samples in [150, 1000] {
        let step = 2.0 * a / f64::from(samples);
        let rows =
            |by: f64| table(PRESSURES, (0..samples).map(|k| [step * f64::from(k), by * sampled(step * f64::from(k))]));
        assert_eq!(failed(&judged(hertz(), &rows(1.0), &Asked::default())), [""; 0], "{samples}");
        assert_ne!(failed(&judged(hertz(), &rows(0.97), &Asked::default())), [""; 0], "{samples}");
    }
}

/// What lies between points that press alone is not handed in: neither straight lines nor roots there are an answer's
/// fault.
#[test]
fn exact_pressures_at_few_points_are_met_and_two_percent_of_load_are_not() {
    let a = TruncatedHertz::default().half_width();
    let sampled = |points: usize, off: f64, both: bool, load: f64| {
        let step = a / points as f64;
        let first = if both { -2 * points as i32 } else { 0 };
        let places = (first..=2 * points as i32).map(|k| (f64::from(k) + off) * step);
        // Pressures and half-width both grow with the root of the load.
        let wider = load.sqrt();
        let rows = places.map(|s| [s, wider * hertz().pressure(0, s / wider)]);
        failed(&judged(hertz(), &table(PRESSURES, rows), &Asked::default()))
    };
    for points in [3, 4, 5, 8, 12] {
        for (off, both) in [(0.0, false), (0.25, false), (0.5, false), (0.0, true), (0.3, true)] {
            assert_eq!(sampled(points, off, both, 1.0), [""; 0], "{points} points, {off}, {both}");
            assert_ne!(sampled(points, off, both, 0.98), [""; 0], "{points} points, {off}, {both}");
            assert_ne!(sampled(points, off, both, 1.03), [""; 0], "{points} points, {off}, {both}");
        }
    }
}

#[test]
fn our_own_answer_is_judged_as_what_solve_says_on_every_case() {
    for (name, _) in NAMES {
        let truth = truth(name);
        let discretisation = Discretisation::of(truth.case.scene.clone(), truth.case.resolution).expect("meshed");
        // What it is judged by has elements half as large.
        assert_eq!(truth.discretisation.resolution.refinement, truth.case.resolution.refinement + 1, "{name}");
        for element in [Element::Node, Element::Line] {
            let run = Run::of(&discretisation, &Formulation::new(element, Iteration::Kinematic).tolerance(1e-8));
            let run = run.expect("solved");
            let found = judged_as_solved(truth, &discretisation, &run);
            assert!(found.mistakes.is_empty(), "{name}, {element:?}");
            let (theirs, ours) = (&found.ruled[0].measures, &run.contacts[0].measures);
            assert_relative_eq!(theirs.edge(), ours.edge(), max_relative = 1e-9);
            assert_relative_eq!(theirs.pressure_at_origin, ours.pressure_at_origin, max_relative = 1e-9);
        }
    }
}

#[test]
fn profile_of_a_run_by_nodes_and_by_points_alone_is_the_same() {
    // On straight edges, whose mid-sides lie in the middle.
    let case = find("truncated-hertz", None).expect("a case");
    for order in Order::ALL {
        let resolution = Resolution { order, ..case.resolution };
        let (_, run) = solved_on(case.scene.clone(), resolution, &Formulation::verification());
        let points = run.solution.points_of(0);
        let asked = Asked { order: Some(order), ..Asked::default() };
        let pressures = table(PRESSURES, points.iter().map(|p| [p.position, p.pressure]));
        let forces =
            table("position [mm],force [kN]", points.iter().map(|p| [p.position, 1e-3 * p.pressure * p.weight]));
        for text in [pressures, forces] {
            let answer = read(&case, "a.csv", text, &asked).expect("read");
            let profile = Profile::of(&case.scene, &answer.contacts[0]);
            for (own, edge) in profile.edges.iter().zip(run.solution.edges_of(0)) {
                assert_relative_eq!(own.pressure, edge.pressure, max_relative = 1e-9, epsilon = 1e-9);
                assert_relative_eq!(own.weight, edge.weight, max_relative = 1e-9);
            }
        }
    }
}

#[test]
fn right_answers_pass_on_ugly_meshes() {
    let truth = hertz();
    for both in [false, true] {
        let found = judged(truth, &Sampled::of(truth, both).text(), &Asked::default());
        assert!(found.met(), "both sides {both}: {:?}", failed(&found));
        assert!(found.mistakes.is_empty());
        // What only both halves tell.
        assert_eq!(found.ruled[0].missing.iter().any(|[what, _]| what.contains("symmetry")), !both);
    }
    // Solved on coarse cells of both orders, which end within an element.
    for (order, elements) in [(Order::Linear, 10), (Order::Linear, 16), (Order::Quadratic, 6), (Order::Quadratic, 9)] {
        let resolution = Resolution { elements, refinement: 0, order };
        let (discretisation, run) = solved_on(truth.case.scene.clone(), resolution, &Formulation::verification());
        let text = serde_json::to_string(&own::answer("truncated-hertz", &discretisation, &run)).expect("JSON");
        let answer = read(&truth.case, "ours.json", text, &Asked::default()).expect("read");
        let found = verdicts(truth, answer, 2.0 * ENGINEERING).expect("judged");
        assert!(found.met(), "{order:?}, {elements}: {:?}", failed(&found));
    }
}

#[test]
fn faults_of_a_profile_are_found_by_the_numbers_they_change_and_named() {
    let truth = hertz();
    let half = || Sampled::of(truth, false);
    let one_half = |mut own: Sampled| {
        own.places.iter().zip(&mut own.pressures).filter(|(s, _)| **s < 0.0).for_each(|(_, p)| *p = 0.0);
        own
    };
    let offset = |mut own: Sampled| {
        own.places.iter_mut().for_each(|s| *s += 0.4);
        own
    };
    for (fault, spoiled, what, named) in [
        ("pressure 3 % off", half().scaled(1.0, 1.03), "peak pressure", ""),
        ("wrong sign", half().scaled(1.0, -1.0), "tension", "--tension-positive"),
        ("width for half-width", half().scaled(2.0, 1.0), "second-moment width", "positions are doubled"),
        ("a missing half", one_half(Sampled::of(truth, true)), "moment", "left half of the profile is missing"),
        ("off the middle", offset(Sampled::of(truth, true)), "moment", "all positions are off by about 0.4"),
    ] {
        let found = judged(truth, &spoiled.text(), &Asked::default());
        let failed = failed(&found);
        assert!(failed.iter().any(|name| name.contains(what)), "{fault}: {failed:?}");
        let all: &[&str] = match fault {
            "width for half-width" => &["end of the contact", "error of the mean pressures"],
            "a missing half" => &["difference of both halves", "begin of the contact"],
            _ => &[],
        };
        assert!(all.iter().all(|part| failed.iter().any(|name| name.contains(part))), "{fault}: {failed:?}");
        match named {
            "" => assert!(found.mistakes.is_empty(), "{fault}: {:?}", found.mistakes),
            named => assert!(found.mistakes.iter().any(|says| says.contains(named)), "{fault}: {:?}", found.mistakes),
        }
    }
}

#[test]
fn tension_penetration_and_pressure_across_a_gap_are_found() {
    let truth = hertz();
    let own = Sampled::of(truth, false);
    let a = TruncatedHertz::default().half_width();
    let edge = own.places.iter().position(|s| *s > a).expect("a node beyond");
    let mut pulled = Sampled { places: own.places.clone(), pressures: own.pressures.clone() };
    pulled.pressures[edge] = -0.05 * own.pressures[0];
    let found = judged(truth, &pulled.text(), &Asked::default());
    assert!(failed(&found).iter().any(|name| name.contains("tension")), "{:?}", failed(&found));
    // Beyond the contact, Hertz on a half-plane: `g = (a²/2R) (ξ √(ξ² − 1) − ln(ξ + √(ξ² − 1)))`, ξ = s/a.
    let open = move |s: f64| {
        let (x, root) = (s / a, ((s / a).powi(2) - 1.0).max(0.0).sqrt());
        a * a / (2.0 * TruncatedHertz::default().radius) * (x * root - (x + root).ln())
    };
    let with_gaps = |gap: &dyn Fn(f64, f64) -> f64| {
        let rows = own.places.iter().zip(&own.pressures).map(|(s, p)| format!("{s},{p},{}\n", gap(*s, *p)));
        format!("position [mm],pressure [MPa],gap [mm]\n{}", rows.collect::<String>())
    };
    let beyond = |factor: f64| with_gaps(&|s, p| if p > 0.0 { 0.0 } else { factor * open(s) });
    let sound = judged(truth, &beyond(1.0), &Asked::default());
    assert!(sound.met(), "{:?}", failed(&sound));
    for factor in [1e3, 4.0, -1.0] {
        let off = judged(truth, &beyond(factor), &Asked::default());
        assert!(failed(&off).iter().any(|name| name.contains("gaps beyond")), "{factor}: {:?}", failed(&off));
    }
    // What a code writes that looks no farther is no gap: not judged, and said.
    let unseen = judged(truth, &beyond(0.0), &Asked::default());
    assert!(unseen.met() && unseen.ruled[0].missing.iter().any(|[what, _]| what.contains("gaps of 0 at")));
    let soft = judged(truth, &with_gaps(&|_, p| -1e-6 * p), &Asked::default());
    assert!(failed(&soft).iter().any(|name| name.contains("penetration")), "{:?}", failed(&soft));
    let apart = judged(truth, &with_gaps(&|_, p| 1e-6 * p), &Asked::default());
    assert!(failed(&apart).iter().any(|name| name.contains("gap under pressure")), "{:?}", failed(&apart));
}

#[test]
fn what_our_own_answer_departs_from_a_closed_form_lets_nobody_else_depart() {
    let mut truth = Truth::of(TruncatedHertz::default().case()).expect("solved");
    let own = Sampled::of(&truth, false);
    let pressures = own.pressures.iter().map(|p| 1.05 * p).collect();
    let high = Sampled { places: own.places.clone(), pressures }.text();
    let before = failed(&judged(&truth, &high, &Asked::default()));
    assert!(before.iter().any(|name| name.contains("peak pressure")), "{before:?}");
    // A fault of ours by as much.
    truth.bars.iter_mut().for_each(|one| one.value *= 1.05);
    truth.run.solution.edges.iter_mut().for_each(|edge| edge.pressure *= 1.05);
    assert_eq!(failed(&judged(&truth, &high, &Asked::default())), before);
}

#[test]
fn the_profile_of_a_contact_off_its_origin_is_not_held_against_a_closed_form_about_it() {
    let eccentric = truth("eccentric-to-accuracy");
    assert!(!eccentric.has_closed_profile() && hertz().has_closed_profile());
    let middle = eccentric.pressure(0, 5.0);
    assert!((middle - eccentric.ours(0, &Quantity::PeakPressure).reference.value).abs() <= 1e-2 * middle, "{middle}");
}

#[test]
fn our_own_answer_to_every_scene_file_is_judged_as_what_solve_says() {
    for case in every_case().into_iter().filter(|case| case.places.is_some()) {
        let discretisation = case.meshed().expect("meshed").discretisation;
        let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
        judged_as_solved(&Truth::of(case).expect("solved"), &discretisation, &run);
    }
}

#[test]
fn straight_lines_between_pressures_have_their_exact_second_moment_on_coarse_edges() {
    let truth = truth("bars");
    let to = |last: f64| table(PRESSURES, [0.0, 10.0, last].map(|s| [s, truth.pressure(0, s)]));
    assert_eq!(failed(&judged(truth, &to(25.0), &Asked::default())), Vec::<String>::new());
    assert!(!failed(&judged(truth, &to(24.0), &Asked::default())).is_empty());
}

/// Processor time of this thread \[s\].
#[cfg(target_os = "linux")]
fn seconds() -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/stat").expect("Linux tells");
    let fields: Vec<&str> = told[told.rfind(')').expect("a name") + 1..].split_whitespace().collect();
    // User and system time in hundredths.
    fields[11..13].iter().map(|ticks| ticks.parse::<f64>().expect("a number")).sum::<f64>() / 100.0
}

#[cfg(target_os = "linux")]
#[test]
fn seconds_grow_with_the_rows_of_a_table_whose_pressures_are_all_alike() {
    let truth = hertz();
    let half_width = TruncatedHertz::default().half_width();
    let taken = |count: usize| {
        let table = table(PRESSURES, (0..count).map(|k| [half_width * k as f64 / (count - 1) as f64, 100.0]));
        let before = seconds();
        let found = judged(truth, &table, &Asked::default());
        let taken = seconds() - before;
        assert_relative_eq!(found.ruled[0].measures.peak.pressure, 100.0, max_relative = 1e-9);
        taken
    };
    // In one run on one processor: ten times the rows, and not a hundred times the work.
    let [few, many] = [2_000, 20_000].map(taken);
    assert!(many <= 30.0 * few, "{few} s, {many} s");
}
