//! What is told of a run: the peak where it is, edges, quantities beside references of the same, how run and command
//! ended, what either cost or needs; and what `solve` prints where nothing else is asked for.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::library::Cylinder;
use contact_vv::case::{Scope, Verdict};
use contact_vv::markdown::to_bound;
use contact_vv::mesh::Order;
use contact_vv::oracle::analytic::even_gap::EvenGap;
use contact_vv::solution::Outcome;
use contact_vv::solve::{Element, Formulation, Iteration, Run};

use crate::balance::solved;
use crate::outputs::{contact_vv, json, refuses, scene};
use crate::program::{Folder, ended, program};
use crate::scene_file::{case, scene_alone, text_of};
use crate::workbench::{block_text, meshed, parsed};

/// A block under a rigid profile, pressed by `load` N/mm on its half.
fn pressed(gap: &str, load: f64, stretch: f64) -> String {
    let size = 24.0 * stretch;
    let traction = format!("traction = {{ at = \"far\", value = [0, {}] }}", -load / size);
    let mesh = "elements = 24\nper = 2\ngrowth = { along = 1.3, depth = 1.25, coarsest = 0.05 }";
    let contact = format!("gap = {gap}\nstretch = {stretch}\n[mesh]\n{mesh}");
    block_text([0.0, size], size, &traction, &contact)
}

fn run_of(text: &str) -> Run {
    parsed(text).solve().expect("solved").1
}

#[test]
fn peak_off_the_centre_of_an_even_gap_is_the_peak_and_the_pressure_at_the_centre_is_told_apart() {
    let [c2, c4, c6] = [3e-4, -5e-5, 2e-5];
    let form = EvenGap::polynomial(210e3 / 0.91, 2.0, [c2, c4, c6]);
    let (place, centre) = (2.0 * form.peak_place().cos(), form.pressure(0.5 * PI));
    assert!(place > 1.0 && form.peak_pressure() > 1.1 * centre);
    for order in [1, 2] {
        let text = pressed(&format!("{{ even = [{c2}, {c4}, {c6}] }}"), 0.5 * form.load(), 3.0);
        let run = run_of(&text.replace("per = 2\n", &format!("per = 2\norder = {order}\n")));
        let found = run.measures();
        assert_relative_eq!(found.peak.pressure, form.peak_pressure(), max_relative = 0.01);
        assert_abs_diff_eq!(found.peak.position, place, epsilon = 0.05);
        assert_relative_eq!(found.pressure_at_origin, centre, max_relative = 0.01);
        assert_relative_eq!(found.edge(), 2.0, max_relative = 0.01);
    }
}

#[test]
fn contact_with_an_open_middle_is_told_with_both_its_ends() {
    let text = pressed("{ table = [[0, 0.02], [6, 0.02], [10, 0], [14, 0.02], [336, 9]] }", 200.0, 14.0);
    let run = run_of(&text.replace("elements = 24\nper = 2", "elements = 60\nper = 14"));
    let found = run.measures();
    let [stretch] = found.stretches[..] else { panic!("{:?}", found.stretches) };
    assert!(6.0 < stretch.begin && stretch.begin < 10.0 && 10.0 < stretch.end && stretch.end < 14.0, "{stretch:?}");
    assert!((found.peak.position - 10.0).abs() < 0.5 && found.pressure_at_origin <= 0.0);
    assert_abs_diff_eq!(found.begin(), stretch.begin, epsilon = 0.0);
}

#[test]
fn peak_without_a_limit_is_told_as_such_and_fails_a_check_of_it() {
    let (_, table, _) = contact_vv(&["solve", &scene("flat-punch"), "--all"]);
    assert!(table.lines().any(|line| line.contains("peak-pressure") && line.contains("without limit")), "{table}");
    let solved = json(&["solve", &scene("flat-punch")]);
    let contact = &solved["contacts"][0];
    assert!(contact["peak_pressure"].is_null() && contact["peak_growth"].as_f64().is_some_and(|growth| growth > 0.05));
    let text = text_of("flat-punch.toml") + "\n[[check]]\nquantity = \"peak-pressure\"\nvalue = 800\ntolerance = 10\n";
    let file = parsed(&text);
    let (meshed, run) = file.solve().expect("solved");
    let judged = file.judge(&meshed, &run).expect("judged");
    let own = judged.iter().rfind(|one| one.check.scope == Scope::Own).expect("the check");
    assert!(own.error.is_nan() && own.verdict == Verdict::Fail);
    // A smooth one has a limit.
    let solved = json(&["solve", &scene("two-cylinders")]);
    let contact = &solved["contacts"][0];
    assert!(contact["peak_pressure"].is_f64() && contact["peak_growth"].is_null(), "{contact}");
}

#[test]
fn checks_of_every_run_scale_with_the_digits_of_the_scene() {
    // Contact on both sides, off the middle, and a layer that recedes: right scenes that a fixed 1e-9 called wrong.
    let receding = text_of("plate-on-two-supports.toml");
    let eccentric = text_of("eccentric-load.toml").replace("coefficients = [100, 4]", "coefficients = [100, -7.3]");
    let unchecked = text_of("eccentric-load.toml").split("[[check]]").next().expect("a head").to_string();
    let punch =
        unchecked.replace("gap = { uniform = 0 }", "gap = { punch = 9.5 }").replace("stretch = 10", "stretch = 9.5");
    for text in [receding, eccentric, punch, text_of("whole-disc.toml")] {
        let file = parsed(&text);
        let (meshed, run) = file.solve().expect("solved");
        let judged = file.judge(&meshed, &run).expect("judged");
        let universal: Vec<_> = judged.iter().filter(|one| one.check.scope == Scope::Universal).collect();
        assert!(universal.len() >= 9);
        for check in universal {
            assert!(
                check.error <= check.check.tolerance || check.check.tolerance <= 0.0,
                "{}: {:e}",
                check.requirement(),
                check.error
            );
            assert!(check.check.tolerance < 1e-4, "{}: {:e}", check.requirement(), check.check.tolerance);
        }
    }
}

#[test]
fn exit_codes_tell_how_a_command_ended() {
    let folder = Folder::made();
    let blocks = text_of("blocks.toml");
    let failing = folder.with("failing.toml", blocks.replace("value = 4000", "value = 4100"));
    let broken = folder.with("broken.toml", blocks.replace("young = 70e3", "young = 0"));
    let slow = folder.with("slow.toml", text_of("cylinder-in-metres.toml"));
    let open =
        folder.with("open.toml", scene_alone(&text_of("press-fit.toml")).replace("uniform = -0.02", "uniform = 0.02"));
    for (arguments, wanted) in [
        (vec!["solve", &scene("blocks")], 0),
        (vec!["verify", &scene("blocks")], 0),
        (vec!["solve", &failing], 1),
        (vec!["verify", &failing], 1),
        (vec!["verify", &scene("blocks"), &failing], 1),
        (vec!["solve", &broken], 2),
        (vec!["verify", &broken], 2),
        (vec!["solve", "no-such-file.toml"], 2),
        (vec!["solve", "cylinder", "--no-such-option"], 2),
        (vec!["solve", &slow, "--max-iterations", "2"], 3),
        (vec!["solve", &open], 3),
    ] {
        assert_eq!(ended(&mut program(&arguments)).0, Some(wanted), "{arguments:?}");
    }
}

/// What is printed on 80 columns.
fn printed(arguments: &[&str]) -> String {
    ended(program(arguments).env("COLUMNS", "80")).1
}

/// The numbers of a text, and what follows ± where something does.
fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn solve_prints_the_numbers_one_quotes_rounded_to_their_bars_on_80_columns() {
    for case in ["cylinder", "sphere", "press-fit", "flat-punch", "roller-between-plates", "eccentric-load", "pin-rod"]
    {
        let of_library = ["cylinder", "sphere", "pin-rod"].contains(&case);
        let case = if of_library { case.to_owned() } else { scene(case) };
        let (text, document) = (printed(&["solve", &case]), json(&["solve", &case]));
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
        // Words are whole: those of the title stand in a line each, or beside one another.
        let words: Vec<&str> = text.split_whitespace().collect();
        let (_, all, _) = contact_vv(&["solve", &case, "--all"]);
        let title = all.lines().next().and_then(|line| line.split_once(": ")).expect("a title").1;
        assert!(title.split_whitespace().all(|word| words.contains(&word)), "{title}: {text}");
        assert!(text.lines().count() < all.lines().count() && all.contains("equilibrium: "), "{text}");
        assert!(!text.contains(" 0 off"), "what is not off at all is met: {text}");
        // No power of ten, no digit beyond a bar, no line twice within a contact.
        assert!(
            !words.iter().any(|word| word.contains("e-") && word.parse::<f64>().is_ok_and(|x| x.abs() < 1e-6)),
            "{text}"
        );
        let contacts = document["contacts"].as_array().expect("contacts");
        let rows = |name: &str| {
            text.lines().filter(|line| line.trim_start().starts_with(&format!("{name} "))).collect::<Vec<_>>()
        };
        let peaks = rows("peak pressure");
        assert_eq!(peaks.len(), contacts.len(), "{text}");
        for (line, contact) in peaks.into_iter().zip(contacts) {
            let Some(peak) = contact["peak_pressure"].as_f64() else {
                assert!(line.contains("without limit"), "{line}");
                continue;
            };
            let [told, bar, ..] = numbers(line)[..] else { panic!("{line}") };
            assert!((told - peak).abs() <= 0.1 * bar && bar < 0.1 * peak, "{line}: {peak}");
        }
        for body in document["bodies"].as_array().expect("bodies") {
            let name = format!("`{}` ", body["name"].as_str().expect("a name"));
            let (_, line) = text.split_once(&name).expect("a line of the body");
            match body["von_mises"].as_f64() {
                None => assert!(line.starts_with("without limit"), "{line}"),
                Some(stress) => {
                    let [told, bar, ..] = numbers(line)[..] else { panic!("{line}") };
                    assert!((told - stress).abs() <= 0.1 * bar && bar < 0.2 * stress, "{line}: {stress}");
                }
            }
        }
    }
}

#[test]
fn numbers_are_told_to_the_second_digit_of_their_bars_whatever_their_size() {
    for (value, bar, told) in [
        (34_200_975.0, 34_195_275.0, "34000000"),
        (5769.23, 240.0, "5770"),
        (5769.23, 24.0, "5769"),
        (5769.23, 0.24, "5769.23"),
        (-1.5e-3, 2e-5, "-0.001500"),
    ] {
        assert_eq!(to_bound(value, bar), told);
    }
    // A closed form is told by its own digits where the bar is larger than it.
    let literal = ["--element", "line", "--algorithm", "constant", "--rule", "literal"];
    let text = printed(&[&["solve", "truncated-hertz"][..], &literal].concat());
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("peak pressure: 5769.23 MPa"), "{text}");
}

#[test]
fn penalty_tells_what_its_springs_cost() {
    let discretisation = meshed(Cylinder::default().scene(), 8, Order::Quadratic);
    let with = |stiffness: f64| {
        let (element, rule) = (Element::Node, StiffnessRule::Penalty);
        let formulation = Formulation { stiffness, rule, ..Formulation::new(element, Iteration::Kinematic) };
        let run = Run::of(&discretisation, &formulation).expect("solved");
        assert!(run.solution.converged());
        (run.contacts[0].penalty.expect("told"), run)
    };
    let exact = Run::of(&discretisation, &Formulation::verification().tolerance(1e-9)).expect("solved");
    for stiffness in [0.3, 30.0, 3e4] {
        let (told, run) = with(stiffness);
        let error = |of: fn(&Run) -> f64| of(&run) / of(&exact) - 1.0;
        assert_abs_diff_eq!(told.peak, error(|run| run.measures().peak.pressure), epsilon = 1e-6);
        assert_abs_diff_eq!(told.half_width, error(|run| run.measures().second_moment_width), epsilon = 1e-6);
        assert_eq!(run.penalty_error() > 0.1, stiffness < 1.0);
    }
    let penalty = ["solve", "cylinder", "--rule", "penalty", "--algorithm", "kinematic", "--stiffness", "0.3"];
    let told = &json(&penalty)["contacts"][0]["penalty_error"]["half_width"];
    assert!(told.as_f64().is_some_and(|error| error > 0.5), "{told}");
    let (_, table, _) = contact_vv(&[&penalty[..], &["--element", "node", "--all"]].concat());
    assert!(table.contains("springs of the penalty cost -36.58 % of the peak"), "{table}");
}

#[test]
fn table_of_bars_has_a_column_of_the_penalty_where_there_is_one() {
    for (options, is_there) in [(&[][..], false), (&["--rule", "penalty", "--stiffness", "100"], true)] {
        let (_, table, _) = contact_vv(&[&["solve", "truncated-hertz", "--all"], options].concat());
        let head = table.lines().find(|line| line.contains("value ± error bar")).expect("a head");
        assert_eq!(head.contains("penalty"), is_there, "{head}");
    }
}

#[test]
fn bar_that_is_unknown_is_named_and_not_every_number() {
    let (_, table, _) = contact_vv(&["solve", "flat-punch", "--all"]);
    assert!(table.contains("itself: peak-pressure of `contact`") && !table.contains("every number"), "{table}");
}

#[test]
fn peak_of_uneven_pressures_has_a_place_and_an_error_above_round_off_is_told() {
    let pressure = |slope: f64| {
        let law = format!("law = {{ polynomial = {{ along = \"x\", coefficients = [100, {slope}] }} }}");
        let contact = "gap = { uniform = 0 }\nstretch = 20\n[mesh]\nelements = 8\nper = 20";
        block_text([0.0, 20.0], 20.0, &format!("pressure = {{ at = \"far\", {law} }}"), contact)
    };
    let folder = Folder::made();
    for (slope, has_place) in [(0.25, true), (0.0, false)] {
        let told = printed(&["solve", &folder.with("s.toml", pressure(slope))]);
        let peak = told.lines().find(|line| line.contains("peak pressure")).expect("a peak");
        assert_eq!(peak.contains(" at "), has_place, "{told}");
    }
    let loose = ["solve", "press-fit", "--tolerance", "1e-5", "--no-error-bar"];
    let error = json(&loose)["oracles"][0]["error"].as_f64().expect("an error");
    assert!((1e-9..1e-6).contains(&error) && !printed(&loose).contains("round-off"), "{error}");
}

#[test]
fn round_off_is_named_where_it_is_the_limit_and_not_the_iterations() {
    // Pressures of line elements on meshes that do not match hang on penetrations of the size of rounding.
    let formulation = Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-12);
    let (_, run) = solved(&case("three-rings"), &formulation);
    assert_eq!(run.solution.outcome, Outcome::Stalled);
    assert!(run.solution.work.iterations < 500 && run.iteration_error() < 1e-4, "{:e}", run.iteration_error());
    let line = ["--element", "line", "--algorithm", "kinematic", "--tolerance", "1e-12"];
    refuses(&[&["solve", &scene("three-rings")][..], &line].concat(), &["as was tried", "--tolerance 1e-12"]);
}

#[test]
fn more_steps_are_asked_for_with_an_option_that_is_offered() {
    let slow = ["solve", "cylinder", "--element", "line", "--algorithm", "constant", "--resolution", "4"];
    // Where an accuracy chose the mesh no other command is tried.
    let path = scene("cylinder-to-accuracy");
    refuses(&["solve", &path, "--accuracy", "5 %", "--max-iterations", "1"], &["--max-iterations"]);
    let json = json(&[&slow[..], &["--max-iterations", "3"]].concat());
    assert_eq!((json["steps"].as_u64(), json["outcome"].as_str()), (Some(3), Some("not converged")));
}
