//! What is told of a run: the peak where it is, edges, quantities beside references of the same, and how a command ended.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::{Scope, Verdict};
use contact_vv::oracle::analytic::even_gap::EvenGap;
use contact_vv::solve::Run;

use crate::outputs::{contact_vv, json, scene};
use crate::program::{Folder, ended, program};
use crate::scene_file::{scene_alone, text_of};
use crate::workbench::{block_text, parsed};

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
