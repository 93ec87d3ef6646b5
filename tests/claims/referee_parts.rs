//! What is left out of an answer, stands there of another contact, or hides behind something else is named, and never
//! judged as the whole.

use std::ops::RangeInclusive;
use std::path::Path;

use contact_vv::accuracy::{Bar, Quantity};
use contact_vv::case::{Case, Judged};
use contact_vv::checkout::root;
use contact_vv::cli::vtu;
use contact_vv::mesh::Order;
use contact_vv::referee::export::deck;
use contact_vv::referee::judge::{ENGINEERING, TENSION};
use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, Truth, calculix, verdicts};
use contact_vv::solve::{Discretisation, Fitted, Formulation, Run};
use serde_json::{Value, json};

use crate::balance::solved_as_it_says;
use crate::ellipse;
use crate::foreign::{self, Frd, vtk};
use crate::handed::{PRESSURES, document, failed, in_units, judged_as, judged_rows, moved, read, table};
use crate::referee_export::blocks;
use crate::referee_wild::{judged, parsed, refused, usual};
use crate::scene_file::{scene_alone, text_of};
use crate::workbench::{self, truth};

#[test]
fn a_table_goes_on_behind_a_comment_where_its_places_go_on() {
    let rows = ellipse::rows(",", |x| x.to_string());
    let lines: Vec<&str> = rows.lines().collect();
    let (near, far) = (lines[..20].join("\n"), lines[20..].join("\n"));
    for between in ["# beyond the middle", "", "\n\n"] {
        let text = format!("position [mm],pressure [MPa]\n{near}\n{between}\n{far}\n");
        ellipse::assert(&parsed("parts.csv", text, &usual()).expect("read"), 1e-9);
    }
    // Rows of numbers may be called as what other reports end with.
    let called: String = lines.iter().map(|line| format!("at {},{line}\n", line.len())).collect();
    let text = format!("point,position [mm],pressure [MPa]\n{called}");
    ellipse::assert(&parsed("parts.csv", text, &usual()).expect("read"), 1e-9);
    let again =
        format!("position [mm],pressure [MPa]\n{near}\n# another\n{}\n{far}\n", lines[19].replace("1.9", "1.85"));
    refused("parts.csv", &again, &usual(), &["begins another table"]);
    // The same in blocks of a line each, and of two contacts in turn; two halves make one table.
    let apart = again.replace('\n', "\n\n");
    refused("parts.csv", &apart, &usual(), &["begins another table"]);
    let mirrored: String = lines[1..].iter().map(|line| format!("-{line}\n")).collect();
    for halves in [format!("{rows}\n# left\n{mirrored}"), format!("{mirrored}\n# right\n{rows}")] {
        let points = parsed("parts.csv", format!("position [mm],pressure [MPa]\n{halves}"), &usual()).expect("read");
        assert_eq!(points.contacts[0].points.len(), 2 * ellipse::NODES - 1);
    }
    // Of several times the last one is judged, or the one that is asked for.
    let timed = |share: f64, time: &str| -> String {
        (0..ellipse::NODES)
            .map(|k| format!("{},{},{time}\n", ellipse::place(k), share * ellipse::pressure(ellipse::place(k))))
            .collect()
    };
    let text = format!("position [mm],pressure [MPa],Time\n{}{}", timed(0.5, "0.5"), timed(1.0, "1"));
    ellipse::assert(&parsed("parts.csv", &text, &usual()).expect("read"), 1e-9);
    let early = Asked { time: Some(0.5), ..usual() };
    let found = parsed("parts.csv", &text, &early).expect("read");
    ellipse::assert_share(&found, 1e-9, 0.5);
    assert_eq!(found.read.last().expect("said"), "the rows of time 0.5");
    assert!(found.notes[0].ends_with("its file goes on to time 1"), "{:?}", found.notes);
    refused(
        "parts.csv",
        &text,
        &Asked { time: Some(0.7), ..usual() },
        &["no results of the time", "time 0.5", "time 1"],
    );
    for none in ["", "nan", "1.0 s", "10:21:07"] {
        let spoiled = text.replacen(",1\n", &format!(",{none}\n"), 1);
        let said = format!("`Time` is `{none}`, which is no number");
        refused("parts.csv", spoiled, &usual(), &["parts.csv:51", &said, "leave the column out"]);
    }
    let own: String = lines.iter().enumerate().map(|(k, line)| format!("{line},{k}\n")).collect();
    let own = format!("position [mm],pressure [MPa],Time\n{own}");
    refused("parts.csv", own, &usual(), &["1 of its rows are of time 48, and a profile needs 3"]);
}

#[test]
fn tables_of_two_contacts_in_two_frames_are_two_tables() {
    let case = Case::read(&root().join("tests/cases/roller-between-plates.toml")).expect("a case");
    let names: Vec<&str> = case.scene.contacts.iter().map(|pair| pair.name.as_str()).collect();
    let rows = |share: f64, name: &str| -> String {
        (0..6)
            .map(|k| format!("{},{},{name}\n", 0.1 * (f64::from(k) + 0.5 * share), share * f64::from(5 - k)))
            .collect()
    };
    let frame = |share: f64| format!("# frame\n{}\n{}", rows(share, names[0]), rows(share, names[1]));
    let read = |frames: &str, asked: &Asked| {
        read(&case, "frames.csv", format!("position [mm],pressure [MPa],contact\n{frames}"), asked)
    };
    let of = |name: &str| Asked { contact: Some(name.into()), ..usual() };
    let two = frame(1.0) + &frame(0.9);
    for asked in [usual(), of(names[0]), of(names[1])] {
        assert_eq!(read(&frame(1.0), &asked).expect("read").contacts[0].points.len(), 6);
        workbench::refused(read(&two, &asked), &["begins another table"]);
    }
    // Rows of contacts by turns, with no line between.
    let [a, b] = [rows(1.0, names[0]), rows(1.0, names[1])];
    let turns: String = a.lines().rev().zip(b.lines()).map(|(a, b)| format!("{a}\n{b}\n")).collect();
    assert!(read(&turns, &of(names[0])).is_ok() && read(&turns, &usual()).is_ok());
}

#[test]
fn a_comma_that_may_stand_between_thousands_is_not_taken_for_a_decimal_one() {
    let table = |places: [&str; 3]| {
        let rows: String = places.iter().zip(["5,769", "5,123", "1,000"]).map(|(s, p)| format!("{s};{p}\n")).collect();
        format!("position [mm];pressure [MPa]\n{rows}")
    };
    refused("theirs.csv", table(["0", "1", "2"]), &usual(), &["`5,769`", "between thousands", "decimal point"]);
    for places in [["0,0", "1,0", "2,0"], ["0,000", "1,000", "2,000"], ["0", "1,25", "2"]] {
        let points = parsed("theirs.csv", table(places), &usual()).expect("read").contacts[0].points.clone();
        assert!((points[0].value - 5.769).abs() <= 1e-12);
    }
}

#[test]
fn areas_where_something_presses_are_positive() {
    let table = |area: &str| format!("position [mm],pressure [MPa],area [mm2]\n0,3,{area}\n1,2,{area}\n2,0,0\n");
    assert!(parsed("theirs.csv", table("1"), &usual()).is_ok());
    for (area, named) in [("-1", "the area at 0 mm is -1"), ("0", "the area at 1.000 mm is 0")] {
        refused("theirs.csv", table(area), &usual(), &[named, "positive"]);
        let area: f64 = area.parse().expect("a number");
        let text = document(json!({ "position": [0, 1, 2], "pressure": [3, 2, 0], "area": [area, area, 0.0] }));
        refused("theirs.json", &text, &usual(), &[named, "positive"]);
    }
}

#[test]
fn of_several_contacts_the_one_that_is_asked_for_is_read() {
    let asked = |name: &str| Asked { contact: Some(name.into()), ..usual() };
    let rows: String =
        ellipse::rows(",", |x| x.to_string()).lines().map(|row| format!("{row},block on rigid\n")).collect();
    let text = format!("position [mm],pressure [MPa],contact\n0,7,other\n{rows}1,5,other\n");
    ellipse::assert(&parsed("theirs.csv", &text, &asked("block on rigid")).expect("read"), 1e-9);
    refused("theirs.csv", &text, &usual(), &["there is no contact `other`"]);
    refused("theirs.csv", &text, &asked("other"), &["there is no contact `other`"]);
    let text = "position [mm],pressure [MPa],contact\n0,7,other\n1,5,other\n2,0,other\n";
    refused("theirs.csv", text, &asked("block on rigid"), &["no line of contact `block on rigid`"]);
    let text = document(json!({ "name": "other", "position": [0, 1, 2], "pressure": [3, 2, 0] }));
    refused("theirs.json", &text, &asked("block on rigid"), &["there is none of the name `block on rigid`"]);
}

#[test]
fn edges_of_a_document_reach_from_its_first_point_to_its_last() {
    let text = |edges: &[[f64; 2]]| {
        let edge = |[from, to]: &[f64; 2]| json!({ "from": from, "to": to, "area": to - from, "pressure": 2 });
        let edges: Value = edges.iter().map(edge).collect();
        document(json!({ "position": [0, 1, 2], "pressure": [3, 2, 1], "edges": edges }))
    };
    assert!(parsed("theirs.json", text(&[[0.0, 1.0], [1.0, 2.0]]), &usual()).is_ok());
    for (edges, named) in [
        (&[[0.0, 0.5], [0.5, 1.0]][..], "reaches from 1.000 to 2.000 mm"),
        (&[[1.0, 1.5], [1.5, 2.0]], "reaches from 0 to 1.000 mm"),
        (&[[0.0, 0.5], [1.0, 2.0]], "reaches from 0.5000 to 1.000 mm"),
        (&[[0.0, 1.0], [0.0, 1.0], [1.0, 2.0]], "reaches from 1.000 to 0 mm"),
        (&[[-1.0, 0.0], [0.0, 1.0], [1.0, 2.0]], "reaches from 0 to -1.000 mm"),
        (&[[0.0, 1.0], [1.0, 2.0], [2.0, 3.0]], "reaches from 3.000 to 2.000 mm"),
    ] {
        refused("theirs.json", text(edges), &usual(), &["contacts[0].edges", named]);
    }
    let twice = text(&[[0.0, 1.0], [1.0, 2.0]]).replace("\"area\":1.0", "\"area\":2.0");
    refused("theirs.json", &twice, &usual(), &["contacts[0].edges", "the area of the one from 0 is 2"]);
}

#[test]
fn a_grid_without_some_of_the_cells_along_the_contact_is_not_judged() {
    let whole = Frd::plain().text();
    let without = |cells: &[usize]| {
        let heads: Vec<String> = cells.iter().map(|cell| format!(" -1{cell:>10}    9    0    1")).collect();
        let mut left_out = false;
        let mut is_kept = |line: &&str| {
            left_out = heads.iter().any(|head| *line == head) || left_out && line.starts_with(" -2");
            !left_out
        };
        whole.lines().filter(|line| is_kept(line)).map(|line| format!("{line}\n")).collect::<String>()
    };
    assert!(parsed("theirs.frd", without(&[]), &usual()).is_ok());
    // Beyond the contact, a = 2 mm, nothing presses.
    assert!(parsed("theirs.frd", without(&[33, 40]), &usual()).is_ok());
    for cells in [&[5][..], &[5, 11], &[5, 6]] {
        let parts =
            ["no edge of its cells lies on contact `block on rigid` from 0.4000", "all cells along the contact"];
        refused("theirs.frd", without(cells), &usual(), &parts);
    }
}

#[test]
fn displacements_that_are_no_numbers_are_named_with_their_node() {
    let columns = vec![(Role::Displacement, "moved".to_owned())];
    let units = [usual().units, vec![(Role::Displacement, "mm".to_owned())]].concat();
    let asked = Asked { columns, units, ..usual() };
    let text = vtk::plain();
    assert!(parsed("theirs.vtk", &text, &asked).is_ok());
    let spoiled = text.replacen("VECTORS moved float\n1 2 3\n1 2 3\n", "VECTORS moved float\n1 2 3\n1 nan 3\n", 1);
    refused("theirs.vtk", &spoiled, &asked, &["`moved` is NaN at node 1"]);
}

#[test]
fn pressures_without_a_limit_that_alternate_are_no_answer() {
    let case = Case::read(&root().join("tests/cases/flat-punch.toml")).expect("a case");
    let truth = Truth::of(case).expect("solved");
    let end = truth.run.contacts[0].measures.edge();
    // One point beside the end, in the last fifth of the contact, is among them.
    let failed_by = |turn: &dyn Fn(i32) -> f64| {
        let place = |k: i32| end * (f64::from(k) / 160.0);
        // The last ones lie beside the end, where the pressure has no limit.
        let row = |k: i32| [place(k), turn(k) * truth.pressure(0, place(k).min(0.998 * end))];
        failed(&judged_as(&truth, "theirs.csv", &table(PRESSURES, (0..=160).map(row)), &usual()))
    };
    let alternates = |turn: &dyn Fn(i32) -> f64| failed_by(turn).iter().any(|one| one.starts_with("alternation"));
    let by = |share: f64| alternates(&|k| if k % 2 == 0 { 1.0 + share } else { 1.0 - share });
    assert!(!by(0.0) && !by(0.05) && by(0.15) && by(-0.15), "{:?}", failed_by(&|_| 1.0));
    assert!(alternates(&|k| if k == 150 { 0.0 } else { 1.0 }));
}

#[test]
fn pressures_alternate_no_more_than_a_tighter_tolerance_allows() {
    let parabola = truth("truncated-hertz");
    let failed_by = |tolerance: f64, times: &dyn Fn(i32) -> f64| {
        let place = |k: i32| 0.025 * f64::from(k);
        let row = |k: i32| [place(k), times(k) * parabola.pressure(0, place(k))];
        let text = table(PRESSURES, (0..=104).map(row));
        let answer = read(&parabola.case, "turns.csv", &text, &Asked::default()).expect("read");
        let found = verdicts(parabola, answer, tolerance).expect("judged");
        let says = found.ruled[0]
            .missing
            .iter()
            .any(|[what, remedy]| what.starts_with("the means over edges") && remedy.contains("`edges`"));
        let names = failed(&found);
        let fails = names.iter().any(|one| one.starts_with("alternation"));
        assert_eq!(says, fails, "{names:?}");
        let alternation = |judged: &&Judged| judged.check.quantity.to_string().starts_with("alternation");
        let swing = found.ruled[0].judged.iter().find(alternation).expect("alternation").value;
        let noted = found.ruled[0].missing.iter().any(|[what, _]| what.starts_with("single points to"));
        assert_eq!(noted, !fails && swing > tolerance, "{swing}: {:?}", found.ruled[0].missing);
        names
    };
    let turn = |share: f64| move |k: i32| if k % 2 == 0 { 1.0 + share } else { 1.0 - share };
    assert_eq!(failed_by(1e-2, &turn(0.09)), [""; 0]);
    assert_eq!(failed_by(1e-3, &turn(0.0)), [""; 0]);
    assert_eq!(failed_by(1e-3, &turn(0.009)), [""; 0]);
    for share in [0.09, -0.09, 0.011] {
        let named = failed_by(1e-3, &turn(share));
        assert!(named.iter().any(|one| one.starts_with("alternation")), "{share}: {named:?}");
    }
    // One point alone, too.
    let one = |share: f64| move |k: i32| if k == 40 { 1.0 + share } else { 1.0 };
    assert_eq!(failed_by(1e-2, &one(0.03)), [""; 0]);
    assert_eq!(failed_by(1e-3, &one(0.004)), [""; 0]);
    let named = failed_by(1e-3, &one(0.03));
    assert!(named.iter().any(|one| one.starts_with("departure of one point alone")), "{named:?}");
}

#[test]
fn a_cone_is_judged_by_its_profile_though_its_tip_has_no_limit() {
    let truth = truth("cone");
    let places: Vec<f64> = (1..=160).map(|k| 2.5 * f64::from(k) / 80.0).collect();
    let judged = |pressure: &dyn Fn(f64) -> f64| {
        let rows = places.iter().map(|&r| [r, if r < 2.5 { pressure(r) } else { 0.0 }]);
        failed(&judged_rows(truth, PRESSURES, rows))
    };
    assert_eq!(judged(&|r| truth.pressure(0, r)), [""; 0]);
    // A paraboloid of pressures with the same force and radius.
    let mean = truth.run.transmitted() / (std::f64::consts::PI * 2.5 * 2.5);
    let other = judged(&|r| 2.0 * mean * (1.0 - (r / 2.5).powi(2)));
    assert!(other.iter().any(|name| name.starts_with("error of the mean pressures")), "{other:?}");
    let is_odd = |r: f64| (80.0 * r / 2.5).round() % 2.0 > 0.5;
    let swaying = judged(&|r| if is_odd(r) { 1.3 } else { 0.7 } * truth.pressure(0, r));
    assert!(swaying.iter().any(|name| name.starts_with("alternation")), "{swaying:?}");
}

#[test]
fn forces_and_pressures_of_the_pressed_nodes_alone_are_those_of_all() {
    let truth = truth("truncated-hertz");
    for step in [0.05, 0.1, 0.125, 0.2] {
        let nodes = (0..=50).map(|k| [step * f64::from(k), truth.pressure(0, step * f64::from(k))]);
        let pressed: Vec<[f64; 2]> = nodes.filter(|[_, pressure]| *pressure > 0.0).collect();
        let force = |[s, p]: &[f64; 2]| [*s, p * step * if *s > 0.0 { 1.0 } else { 0.5 }];
        let forces = judged_rows(truth, "position [mm],force [N]", pressed.iter().map(force));
        assert_eq!(failed(&forces), [""; 0], "{step}");
        // On both sides, with the first point a rounding off the line, or without.
        let whole =
            pressed.iter().rev().filter(|[s, _]| *s > 0.0).map(|[s, p]| [-s, *p]).chain(pressed.iter().copied());
        let whole = judged_rows(truth, "position [mm],force [N]", whole.map(|[s, p]| [s, p * step]));
        assert_eq!(failed(&whole), [""; 0], "{step}");
        for beside in [-1e-8, 1e-8] {
            let rows = pressed.iter().map(|&[s, p]| [if s > 0.0 { s } else { beside }, p]);
            assert_eq!(failed(&judged_rows(truth, PRESSURES, rows)), [""; 0], "{step}, {beside}");
        }
    }
}

#[test]
fn pressed_nodes_of_which_the_next_one_lies_at_the_end_are_those_of_all() {
    for (name, peak) in [("cylinder", 5769.23), ("sphere", 7345.61)] {
        let truth = truth(name);
        for edges in [24, 32, 48] {
            let place = |k: i32| 2.5 * f64::from(k) / f64::from(edges);
            let hertz = |s: f64| peak * (1.0 - (s / 2.5).powi(2)).sqrt();
            let both = if name == "sphere" { None } else { Some(1 - edges) };
            for first in both.into_iter().chain([0]) {
                let found = judged_rows(truth, PRESSURES, (first..edges).map(|k| [place(k), hertz(place(k))]));
                assert_eq!(failed(&found), [""; 0], "{name}, {edges}");
            }
        }
    }
}

#[test]
fn points_of_another_order_and_areas_of_others_are_named_and_single_points_are_no_matter_of_order() {
    let said = |truth: &Truth, columns: &str, rows: String| {
        let found = judged_as(truth, "theirs.csv", &format!("{columns}\n{rows}"), &Asked::default());
        assert!(!found.met());
        found.mistakes.join("; ")
    };
    let punch = truth("flat-punch");
    let mesh = Discretisation::of(punch.case.scene.clone(), punch.case.resolution).expect("meshed");
    let run = Run::of(&mesh, &Formulation::verification()).expect("solved");
    let rows =
        run.solution.points_of(0).iter().map(|point| format!("{},{}\n", point.position, point.pressure)).collect();
    let by_order = "every second point is a mid-side: hand them in with --order 2";
    assert_eq!(said(punch, PRESSURES, rows), by_order);
    let hertz = truth("cylinder");
    let rows = |of: &dyn Fn(usize, f64) -> String| -> String {
        let place = |k: usize| 5.0 * k as f64 / 48.0;
        let pressure = |s: f64| 5769.23 * (1.0 - (s / 2.5).powi(2)).max(0.0).sqrt();
        (0..=48).map(|k| format!("{},{}\n", place(k), of(k, pressure(place(k))))).collect()
    };
    // Shares of 8-node cells: 1/6, 4/6, 1/6.
    let shares = |k: usize| {
        5.0 / 24.0
            * if k % 2 == 1 {
                4.0 / 6.0
            } else if k.is_multiple_of(48) {
                1.0 / 6.0
            } else {
                2.0 / 6.0
            }
    };
    let forces = rows(&|k, p| format!("{}", shares(k) * p));
    let found = judged_as(hertz, "theirs.csv", &format!("position [mm],force [N]\n{forces}"), &Asked::default());
    assert!(found.met() || found.mistakes == [by_order], "{:?}", found.mistakes);
    assert_eq!(said(hertz, PRESSURES, rows(&|k, p| format!("{}", if k == 7 { 1.15 * p } else { p }))), "");
    for area in [1.0, 2.0 * 5.0 / 48.0] {
        let areas = said(hertz, &format!("{PRESSURES},area [mm2]"), rows(&|_, p| format!("{p},{area}")));
        assert!(areas.starts_with("areas are not those of the points"), "{areas}");
    }
}

#[test]
fn forces_by_turns_are_those_of_8_node_cells_where_no_order_is_told_which_is_said() {
    let truth = truth("patch");
    let quadratic = |k: usize| {
        if k % 2 == 1 {
            400.0 / 6.0
        } else if k.is_multiple_of(8) {
            100.0 / 6.0
        } else {
            200.0 / 6.0
        }
    };
    let linear = |k: usize| if k.is_multiple_of(8) { 25.0 } else { 50.0 };
    let scene = &truth.case.scene;
    let share = truth.pressure(0, 0.0) * scene.contact().stretch * scene.thickness / 400.0;
    let of = |order: Option<Order>, force: &dyn Fn(usize) -> f64| {
        let end = truth.case.scene.contact().stretch;
        let row = |k: usize| [end * k as f64 / 8.0, share * force(k)];
        let text = table("position [mm],force [N]", (0..=8).map(row));
        let answer = read(&truth.case, "forces.csv", &text, &Asked { order, ..Asked::default() }).expect("read");
        let found = verdicts(truth, answer, ENGINEERING).expect("judged");
        let is_said = found.notes.iter().any(|note| note.contains("taken as of 8-node cells"));
        (found.met(), is_said, failed(&found))
    };
    for (order, force, wanted) in [
        (None, &quadratic as &dyn Fn(usize) -> f64, [true, true]),
        (Some(Order::Quadratic), &quadratic, [true, false]),
        (Some(Order::Linear), &quadratic, [false, false]),
        (None, &linear, [true, false]),
        (Some(Order::Linear), &linear, [true, false]),
        (Some(Order::Quadratic), &linear, [false, false]),
    ] {
        let (met, is_said, failing) = of(order, force);
        assert_eq!([met, is_said], wanted, "{order:?}: {failing:?}");
    }
}

#[test]
fn areas_of_corners_and_mid_sides_tell_that_edges_have_three_nodes() {
    // N/A of a block under its own weight, by consistent pressures: a third of 0.94 and two of 1.03.
    let truth = truth("own-weight");
    let rows = |share: [f64; 3]| {
        let area = |k: usize| {
            5.0 * if !k.is_multiple_of(2) {
                share[1]
            } else if k.is_multiple_of(8) {
                share[0]
            } else {
                share[0] + share[2]
            }
        };
        let row = |k: usize| [2.5 * k as f64, 0.4 * if k % 2 == 1 { 1.03 } else { 0.94 }, area(k)];
        judged_rows(truth, "position [mm],pressure [MPa],area [mm2]", (0..=8).map(row))
    };
    let found = rows([1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]);
    assert!(
        found.met() && found.answer.read.iter().any(|how| how.contains("mid-sides by turns")),
        "{:?}",
        failed(&found)
    );
    // By halves they are those of edges with two nodes.
    assert!(!rows([0.25, 0.5, 0.25]).met());
}

/// Σ F s² of four edges of a pressure that is the same everywhere is 5.6 % larger than the ∫ p s² ds they stand for,
/// the half-width 2.8 %: of four edges of 5 mm whose two end nodes have half an area, (2·½·10² + 2·5² + 0)/4 = 37.5
/// where 10²/3 is true.
#[test]
fn second_moments_of_forces_along_a_few_edges_are_those_of_what_lies_between() {
    let truth = truth("patch");
    let pressure = truth.run.contacts[0].measures.peak.pressure;
    let thickness = truth.case.scene.thickness;
    let area = |k: usize| 5.0 * thickness * if k.is_multiple_of(4) { 0.5 } else { 1.0 };
    let place = |k: usize| 5.0 * k as f64 - 10.0;
    let forces = |off: f64| (0..=4).map(move |k| [place(k), off * pressure * area(k)]);
    let pressures = |off: f64| (0..=4).map(move |k| [place(k), pressure, off * area(k)]);
    let of_forces = |off| judged_rows(truth, "position [mm],force [N]", forces(off));
    let of_pressures = |off| judged_rows(truth, "position [mm],pressure [MPa],area [mm2]", pressures(off));
    for found in [of_forces(1.0), of_pressures(1.0)] {
        assert!(found.met(), "{:?}", failed(&found));
    }
    // What is between makes no force that is not there, nor another width of areas that are not those of the points,
    // whose sum is right.
    assert!(!of_forces(1.02).met() && !of_pressures(1.02).met());
    let equal = (0..=4).map(|k| [place(k), pressure, 4.0 * thickness]);
    let found = judged_rows(truth, "position [mm],pressure [MPa],area [mm2]", equal);
    assert!(failed(&found).iter().any(|told| told.contains("width")), "{:?}", failed(&found));
    // Nor another moment.
    let turned = (0..=4).map(|k| [place(k), pressure * area(k) * (1.0 + 0.05 * (k as f64 - 2.0) / 2.0)]);
    assert!(!judged_rows(truth, "position [mm],force [N]", turned).met());
}

#[test]
fn tension_that_stresses_have_beside_a_contact_is_none_whatever_they_are_read_from() {
    let stress = |pull: f64| -> String {
        let value = |s: f64| if s > 2.0 && s < 2.3 { pull } else { 0.0 - ellipse::pressure(s) };
        let rows = (0..ellipse::NODES).map(ellipse::place).map(|s| format!("{s},{}\n", value(s)));
        format!("x [mm],S22 [MPa]\n{}", rows.collect::<String>())
    };
    let asked = Asked { columns: vec![(Role::Pressure, "S22".into())], tension_positive: true, ..usual() };
    let found = judged(parsed("stress.csv", stress(2.0), &asked).expect("read")).expect("judged");
    assert!(found.met() && found.answer.read.iter().any(|how| how.contains("tension of up to 2.0 %")));
    assert!(!judged(parsed("stress.csv", stress(8.0), &asked).expect("read")).expect("judged").met());
    // A contact pressure has none.
    let plain = stress(2.0).replace(",-", ",").replace(",2\n", ",-2\n").replace("S22", "CPRESS");
    let found = failed(&judged(parsed("stress.csv", plain, &usual()).expect("read")).expect("judged"));
    assert!(found.iter().any(|one| one == TENSION), "{found:?}");
}

#[test]
fn points_beside_means_over_edges_are_said_not_to_be_judged_and_no_gap_is_none_beyond_a_pressed_node() {
    let found = |share: f64, name: &str, more: Value| {
        let mut pressures = ellipse::list(ellipse::pressure);
        pressures.iter_mut().enumerate().for_each(|(k, p)| *p *= if k % 2 == 0 { 1.0 + share } else { 1.0 - share });
        let mut contact = json!({ "position": ellipse::list(|s| s), "pressure": pressures });
        contact[name] = more;
        judged(parsed("theirs.json", document(contact), &usual()).expect("read")).expect("judged")
    };
    let is_said = |one: &[String; 2]| one[0] == "pressures at single points";
    assert!(found(0.3, "edges", ellipse::edges(1.0)).ruled[0].missing.iter().any(is_said));
    // Beyond the contact, at 2 mm, there is no other side.
    let none = ellipse::list(|s| if ellipse::pressure(s) > 0.0 { 0.0 } else { f64::NAN });
    let plain = found(0.0, "gap", json!(none));
    assert!(!plain.ruled[0].missing.iter().any(is_said));
    assert_eq!(failed(&plain), [""; 0]);
}

#[test]
fn tables_of_code_aster_are_judged_at_their_last_time() {
    let rows = |share: f64, time: &str| -> String {
        let row = |s: f64| format!(" N{s} 1 {time} {s:.9E} {s:.9E} 0.0E+00 {:.9E}\n", -share * ellipse::pressure(s));
        (0..ellipse::NODES).map(ellipse::place).map(row).collect()
    };
    let head = "#\n#ASTER 15.04.00 CONCEPT tab CALCULE LE 28/11/2025\n#TABLE_SDASTER\n NOEUD NUME_ORDRE INST ABSC_CURV \
        COOR_X COOR_Y LAGS_C\n";
    let text = format!("{head}{}{}", rows(0.5, "5.0E-01"), rows(1.0, "1.0E+00"));
    let found = parsed("tab.txt", &text, &Asked { tension_positive: true, ..usual() }).expect("read");
    ellipse::assert(&found, 1e-6);
    assert_eq!(found.read.last().expect("said"), "the rows of time 1");
}

#[test]
fn a_column_that_is_named_for_one_role_has_no_other() {
    let named = |role: Role, name: &str, asked: Asked| Asked { columns: vec![(role, name.into())], ..asked };
    let hertz = truth("truncated-hertz");
    let step = 0.05;
    let places = || (0..=60).map(|k| step * f64::from(k));
    // Nodal forces called as pressures usually are.
    let share = |s: f64| if s > 0.0 { step } else { 0.5 * step };
    let forces = table("x,p", places().map(|s| [s, hertz.pressure(0, s) * share(s)]));
    let asked = named(Role::Force, "p", in_units(&[(Role::X, "mm"), (Role::Force, "N")]));
    let found = judged_as(hertz, "forces.csv", &forces, &asked);
    assert_eq!(failed(&found), [""; 0]);
    // Pressures called as a coordinate usually is.
    let pressures = table("x,y", places().map(|s| [s, hertz.pressure(0, s)]));
    let asked = named(Role::Pressure, "y", in_units(&[(Role::X, "mm"), (Role::Pressure, "MPa")]));
    assert_eq!(failed(&judged_as(hertz, "xy.csv", &pressures, &asked)), [""; 0]);
    // Two of one title are told apart by their numbers, and so are those of a report that names them otherwise.
    let twice = table("x [mm],p [MPa],p [MPa]", places().map(|s| [s, 50.0, hertz.pressure(0, s)]));
    let said = read(&hertz.case, "twice.csv", &twice, &usual());
    workbench::refused(said, &["more than one column is called pressure", "--column pressure=2"]);
    let asked = named(Role::Pressure, "3", usual());
    assert_eq!(failed(&judged_as(hertz, "twice.csv", &twice, &asked)), [""; 0]);
    let rows: String = places().enumerate().map(|(k, s)| format!("{k} {s} 0 {}\n", hertz.pressure(0, s))).collect();
    let report = format!("*Step  = 10\n*Time  = 1\n*Data  = x;y;contact pressure\n{rows}");
    let asked = in_units(&[(Role::X, "mm"), (Role::Pressure, "MPa")]);
    let asked = Asked { columns: vec![(Role::X, "2".into()), (Role::Pressure, "4".into())], ..asked };
    assert_eq!(failed(&judged_as(hertz, "report.txt", &report, &asked)), [""; 0]);
}

#[test]
fn uniform_and_linear_pressures_are_judged_by_few_points_on_either_side() {
    let fit = truth("press-fit");
    // Degrees, and so many times the pressure of the fit.
    let of_fit = |degrees: &mut dyn Iterator<Item = f64>, times: f64| {
        judged_rows(fit, "position [deg],pressure [MPa]", degrees.map(|degrees| [degrees, times * 12.7065]))
    };
    let even = |places: RangeInclusive<i32>| places.map(|k| 3.0 * f64::from(k));
    assert_eq!(failed(&of_fit(&mut even(-30..=30), 1.0)), [""; 0]);
    for places in [-60..=60, 0..=60, 0..=120] {
        let said = of_fit(&mut even(places), 1.0).mistakes;
        let part = "the scene has a part of the ring: hand in its points up to 90.0000°";
        assert!(said.iter().any(|one| one == part) && !said.iter().any(|one| one.contains("doubled")), "{said:?}");
    }
    // Its edges end where the last candidates are, half a step behind their middles.
    for places in [-9..9, 0..9] {
        let found = of_fit(&mut places.map(|k| 5.0 + 10.0 * f64::from(k)), 1.0);
        assert_eq!(failed(&found), [""; 0]);
    }
    // A column `contact` of one contact may tell its status; twice the pressure is no load where there is none, and 2 %
    // more is no shift.
    let hertz = truth("truncated-hertz");
    let places = || (0..=60).map(|k| 0.05 * f64::from(k));
    let rows: String = places().map(|s| format!("{s},{},Sticking\n", hertz.pressure(0, s))).collect();
    let sticking = format!("{PRESSURES},contact\n{rows}");
    assert_eq!(failed(&judged_as(hertz, "status.csv", &sticking, &Asked::default())), [""; 0]);
    let said = judged_rows(hertz, PRESSURES, places().map(|s| [1.02 * s, hertz.pressure(0, s)])).mistakes;
    assert!(!said.iter().any(|one| one.contains("shifted")), "{said:?}");
    let said = of_fit(&mut even(0..=30), 2.0).mistakes;
    assert!(said.iter().any(|one| one.starts_with("the interference is twice")), "{said:?}");
    assert!(!said.iter().any(|one| one.contains("load")), "{said:?}");
    let linear = [[-10.0, 60.0], [0.0, 100.0], [10.0, 140.0]];
    let found = failed(&judged_rows(truth("eccentric-load"), PRESSURES, linear));
    assert!(!found.iter().any(|name| name.starts_with("peak")), "{found:?}");
}

#[test]
fn reports_of_several_columns_end_with_their_extremes_and_where_these_are() {
    let rows: String = (0..ellipse::NODES)
        .map(|k| {
            format!(
                "{:9} {:13.6e} {:13.6e} {:13.6e} {:13.6e}\n",
                k + 1,
                ellipse::place(k),
                0.0,
                ellipse::pressure(ellipse::place(k)),
                ellipse::gap(ellipse::place(k))
            )
        })
        .collect();
    let text = format!(
        "Node COORD.COOR1 COORD.COOR2 CPRESS COPEN\n{rows}\n  Minimum              0.             0.             \
        0.             0.\n\
        \x20     At Node          1              1             60              1\n"
    );
    ellipse::assert(&parsed("abaqus.rpt", text, &usual()).expect("read"), 1e-6);
}

#[test]
fn the_order_of_an_answer_is_that_which_is_asked_for_or_that_of_its_cells() {
    let orders = [Order::Linear, Order::Quadratic];
    for order in orders {
        let asked = Asked { order: Some(order), ..usual() };
        for (name, text) in [("theirs.frd", Frd::plain().text()), ("theirs.vtk", vtk::plain())] {
            assert_eq!(parsed(name, text, &asked).expect("read").contacts[0].order, order, "{name}");
        }
    }
    let case = &truth("truncated-hertz").case;
    let forces = foreign::forces("GAPS_CONTACT", "0.1000000E+01", (1..=3).map(|node| (node, -100.0)));
    let of = |cells: &str, order: Option<Order>| {
        let deck = format!(
            "** truncated-hertz: mm, N, MPa.\n*NODE\n1, 0, 0\n2, 2, 0\n3, 4, 0\n*ELEMENT, TYPE={cells}\n*NSET, \
            NSET=GAPS_CONTACT\n1, 2, 3\n"
        );
        let asked = Asked { order, ..Asked::default() };
        calculix::forces(Path::new("a.dat"), &forces, &deck, &case.scene, &asked).expect("read").contacts[0].order
    };
    for (cells, order) in ["4", "8"].into_iter().zip(orders) {
        for kind in ["CPE", "CPS", "CAX"] {
            assert_eq!(of(&format!("{kind}{cells}"), None), order, "{kind}{cells}");
        }
        orders.into_iter().for_each(|asked| assert_eq!(of(&format!("CPE{cells}"), Some(asked)), asked));
    }
}

#[test]
fn a_gap_that_is_missing_under_pressure_is_no_open_one() {
    let read = |from: f64| {
        let gap = |s: f64| if s < from { ellipse::gap(s).to_string() } else { "nan".into() };
        let gaps: String = (0..2 * ellipse::NODES).map(|k| gap(ellipse::place(k % ellipse::NODES)) + "\n").collect();
        let asked = Asked { columns: vec![(Role::Gap, "COPEN".into())], ..usual() };
        parsed("theirs.vtk", vtk::plain() + &format!("SCALARS COPEN double 1\nLOOKUP_TABLE default\n{gaps}"), &asked)
    };
    // The contact ends at 2 mm.
    assert!(read(2.05).is_ok());
    workbench::refused(read(1.55), &["`COPEN`"]);
}

#[test]
fn pressures_a_fortieth_too_large_are_not_those_of_a_mesh_and_one_that_is_a_tenth_off_is_alone() {
    let hertz = truth("truncated-hertz");
    let end = hertz.run.contacts[0].measures.edge();
    let told = |of: &dyn Fn(i32) -> f64, begin: &str| {
        let rows = (0..=60).map(|k| 0.025 * end * f64::from(k)).enumerate();
        let rows = rows.map(|(k, s)| [s, of(k as i32) * hertz.pressure(0, s)]);
        failed(&judged_rows(hertz, PRESSURES, rows)).iter().any(|one| one.starts_with(begin))
    };
    let profile = "error of the mean pressures";
    assert!(told(&|_| 1.025, profile) && !told(&|_| 1.005, profile));
    let alone = "departure of one point alone";
    assert!(told(&|k| if k == 11 { 1.1 } else { 1.0 }, alone) && !told(&|k| if k == 11 { 1.03 } else { 1.0 }, alone));
}

#[test]
fn gaps_a_tenth_too_large_beyond_the_contact_are_not_met() {
    let found = |times: f64| {
        let rows = (0..ellipse::NODES).map(ellipse::place).map(|s| [s, ellipse::pressure(s), times * ellipse::gap(s)]);
        failed(
            &judged(
                parsed("theirs.csv", table("position [mm],pressure [MPa],gap [mm]", rows), &usual()).expect("read"),
            )
            .expect("judged"),
        )
    };
    assert_eq!(found(1.0), [""; 0]);
    assert!(found(1.1).iter().any(|one| one.starts_with("error of the gaps")), "{:?}", found(1.1));
}

#[test]
fn an_answer_that_stops_before_a_hundredth_of_its_force_is_refused_and_so_is_one_whose_last_point_hardly_presses() {
    let hertz = truth("truncated-hertz");
    let place = |k: i32| 0.0125 * hertz.run.contacts[0].measures.edge() * f64::from(k);
    // 1 − 2/π (asin x + x √(1 − x²)) of the force lies beyond x half-widths.
    for (stops, hardly, beyond) in [(76, 1.0, "1.3 %"), (64, 0.1, "10.4 %")] {
        let share = |k: i32| if k == stops { hardly } else { 1.0 };
        let rows = (0..=stops).map(|k| [place(k), share(k) * hertz.pressure(0, place(k))]);
        let answer = read(&hertz.case, "theirs.csv", table(PRESSURES, rows), &usual()).expect("read");
        workbench::refused(verdicts(hertz, answer, ENGINEERING), &[&format!("{beyond} of the force lies beyond")]);
    }
}

#[test]
fn a_number_that_we_know_to_a_twentieth_is_not_judged_by_and_what_is_has_half_its_bar_for_uncertainty() {
    let case = workbench::parsed(&scene_alone(&text_of("whole-disc.toml")));
    let mut truth = Truth::of(case).expect("solved");
    for (share, is_judged) in [(0.05, false), (0.004, true)] {
        let own = truth.bars.iter_mut().find(|one| one.is_of(0, &Quantity::SecondMomentWidth)).expect("a width");
        own.bar = Bar { mesh: share * own.value, iteration: 0.0, penalty: 0.0 };
        let (value, rows) = (own.value, (-60..=60).map(|k| 0.025 * f64::from(k)));
        let rows: Vec<[f64; 2]> = rows.map(|s| [s, truth.pressure(0, s)]).collect();
        let found = judged_rows(&truth, PRESSURES, rows);
        let width = &found.ruled[0].judged[0];
        assert_eq!(width.check.quantity.number(), Some(&Quantity::SecondMomentWidth));
        assert_eq!(!matches!(width.verdict, contact_vv::case::Verdict::NotRun(_)), is_judged, "{width:?}");
        let uncertainty = width.reference.uncertainty.filter(|_| is_judged);
        assert!(uncertainty.is_none_or(|one| (one / (0.5 * share * value) - 1.0).abs() <= 1e-9), "{width:?}");
    }
}

#[test]
fn a_truth_is_of_half_the_elements_and_has_nothing_beyond_its_candidates() {
    let fit = truth("press-fit");
    assert_eq!(fit.discretisation.resolution.refinement, fit.case.resolution.refinement + 1);
    let stretch = fit.case.scene.contact().stretch;
    let [within, beyond] = [0.99, 1.01].map(|share| fit.pressure(0, share * stretch));
    assert!(within > 0.0 && beyond.abs() <= 0.0, "{within}, {beyond}");
}

#[test]
fn a_force_that_a_file_declares_is_judged_but_for_our_own_round_off() {
    let judged = |tolerance: &str| {
        let check = format!(
            "[[check]]\nquantity = \"resultant\"\nvalue = 7\ntolerance = {tolerance}\nkind = \
            \"self-consistency\"\nsource = \"statics\"\nbecause = \".\"\n"
        );
        let scene = scene_alone(&text_of("whole-disc.toml"));
        let truth = Truth::of(workbench::parsed(&(scene + &check))).expect("solved");
        let rows: Vec<[f64; 2]> = (-60..=60).map(|k| 0.025 * f64::from(k)).map(|s| [s, truth.pressure(0, s)]).collect();
        judged_rows(&truth, PRESSURES, rows).ruled[0].judged.iter().any(|one| one.reference.name == "statics")
    };
    assert!(judged("1e-3") && !judged("1e-8"));
}

#[test]
fn a_deck_has_the_modulus_of_its_slice_and_pulls_and_springs_along_its_gaps() {
    let text = |case: &Case| {
        deck::text(&Discretisation::of(case.scene.clone(), case.resolution).expect("meshed")).expect("written")
    };
    let rows = |deck: &str, begin: &str| -> Vec<Vec<f64>> {
        let all = blocks(deck).into_iter().filter(|(head, _)| head.starts_with(begin)).flat_map(|(_, rows)| rows);
        all.map(|row| row.iter().map(|word| word.parse().unwrap_or(0.0)).collect()).collect()
    };
    // As stiff as the whole: modulus times thickness.
    let stress = text_of("plate-on-two-supports.toml").replace("plane = \"strain\"", "plane = \"stress\"");
    let case = workbench::parsed(&stress);
    let thin = text(&case);
    let (young, section) = (rows(&thin, "ELASTIC")[0][0], rows(&thin, "SOLID SECTION")[0][0]);
    let wanted = case.scene.bodies[0].material.young * case.scene.thickness;
    assert!((young * section / wanted - 1.0).abs() <= 1e-9, "{young}, {section}");
    // Stiffness and pull of every gap are of one width, around an axis that of its ring.
    let gaps = rows(&text(&truth("sphere").case), "GAP, ");
    let share = |row: &[f64]| row[6] / row[5];
    assert!(gaps.len() > 10 && gaps.iter().all(|row| (share(row) / share(&gaps[0]) - 1.0).abs() <= 1e-5), "{gaps:?}");
    // Along the component whose equation is the approach.
    let open = text(&truth("patch").case);
    let moved = rows(&open, "EQUATION");
    assert!(moved.iter().any(|row| row.len() == 3 && row[1] == 1.0 && row[2] == -1.0));
    assert_eq!(rows(&open, "SPRING, ")[0], [1.0]);
}

#[test]
fn gaps_of_displacements_on_an_arc_are_those_along_its_normal() {
    let case = Case::read(&root().join("tests/cases/rigid-pin.toml")).expect("a case");
    let (made, run) = solved_as_it_says(&case);
    let text = vtu::text(&made, &run).expect("written").replace("contact_gap", "other");
    let points = &read(&case, "ours.vtu", text, &moved()).expect("read").contacts[0].points;
    let ours = run.solution.points_of(0);
    assert_eq!(points.len(), ours.len());
    let largest = ours.iter().map(|one| one.gap).fold(0.0, f64::max);
    for (theirs, ours) in points.iter().zip(ours) {
        assert!((theirs.gap.expect("a gap") - ours.gap).abs() <= 1e-6 * largest, "{theirs:?}, {ours:?}");
    }
}

#[test]
fn nodal_forces_that_alternate_or_of_which_one_is_off_are_no_answer() {
    let uniform: fn(f64) -> f64 = |_| 100.0;
    let hertz: fn(f64) -> f64 = |s| 5769.23 * (1.0 - (s / 2.5).powi(2)).max(0.0).sqrt();
    let alternate = |k: usize, share: f64| if k.is_multiple_of(2) { 1.0 + share } else { 1.0 - share };
    for (name, end, pressure) in [("patch", 10.0, uniform), ("truncated-hertz", 4.0, hertz)] {
        let length = end / 80.0;
        let failed = |shares: &[f64], times: &dyn Fn(usize) -> f64| {
            let steps = shares.len() - 1;
            let share = |k: usize| match k % steps {
                0 if k == 0 => shares[0],
                0 if k == 80 => shares[steps],
                0 => shares[0] + shares[steps],
                at => shares[at],
            };
            let row = |k: usize| {
                let s = length * k as f64;
                [s, pressure(s) * share(k) * length * steps as f64 * times(k)]
            };
            failed(&judged_rows(truth(name), "position [mm],force [N]", (0..=80).map(row)))
        };
        // Of edges with two nodes, and with three of which nothing is said.
        for shares in [&[0.5, 0.5][..], &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]] {
            assert_eq!(failed(shares, &|_| 1.0), [""; 0], "{name}");
            for share in [0.5, -0.9] {
                let named = failed(shares, &|k| alternate(k, share));
                assert!(named.iter().any(|one| one.starts_with("alternation")), "{name}: {named:?}");
            }
            for (at, times) in [(0, 0.5), (7, 0.6), (8, 1.4)] {
                let named = failed(shares, &|k| if k == at { times } else { 1.0 });
                assert!(named.iter().any(|one| one.starts_with("departure")), "{name}, {at}: {named:?}");
            }
            // A third goes to the neighbour.
            let moved = failed(shares, &|k| [1.0, 0.7, 1.3].get(k.saturating_sub(5)).copied().unwrap_or(1.0));
            assert_ne!(moved, [""; 0], "{name}");
        }
    }
    // Nodes of cells of order 8 have areas of their own.
    let truth = truth("truncated-hertz");
    let answer = Fitted::of_digits(6).solve(&truth.case.scene, &Formulation::verification()).expect("solved");
    let rows = answer.run.solution.points.iter().map(|p| format!("{},{}\n", p.position, p.pressure * p.weight));
    let text = format!("position [mm],force [N]\n{}", rows.collect::<String>());
    let asked = Asked { order: Some(Order::Octic), ..Asked::default() };
    assert_eq!(failed(&judged_as(truth, "eight.csv", &text, &asked)), [""; 0]);
}

#[test]
fn the_point_on_an_axis_and_the_last_ones_before_an_end_are_judged() {
    for (name, peak) in [("truncated-sphere", 7345.6), ("truncated-hertz", 5769.2)] {
        let named = |edges: usize, at: usize, times: f64| {
            let row = |k: usize| {
                let s = 4.0 * k as f64 / edges as f64;
                [s, peak * (1.0 - (s / 2.5).powi(2)).max(0.0).sqrt() * if k == at { times } else { 1.0 }]
            };
            failed(&judged_rows(truth(name), PRESSURES, (0..=edges).map(row)))
        };
        for (edges, at, times) in
            [(64, 0, 0.7), (64, 0, 0.9), (64, 39, 1.45), (64, 38, 0.7), (64, 36, 1.2), (24, 14, 1.3)]
        {
            assert_eq!(named(edges, at, 1.0), [""; 0], "{name}");
            let named = named(edges, at, times);
            let is_told = |one: &String| one.starts_with("departure") || one.starts_with("pressure beside an end");
            assert!(named.iter().any(is_told), "{name}, {at}: {named:?}");
        }
    }
    let flat = truth("flat-punch");
    let rows = (0..40).map(|k| f64::from(k) / 40.0).map(|s| [s, flat.pressure(0, s)]);
    let missing = &judged_rows(flat, PRESSURES, rows).ruled[0].missing;
    assert!(missing.iter().any(|[what, _]| what.contains("before an end")), "{missing:?}");
}

#[test]
fn points_of_another_contact_far_beyond_the_candidates_are_refused() {
    let supported = truth("plate-on-two-supports");
    let rows = |from: f64| -> String {
        let row = |k: i32| {
            let s = 0.05 * f64::from(k);
            format!("{},0,{}\n", from + s, supported.pressure(if from < 0.0 { 0 } else { 1 }, s))
        };
        (-20..=20).map(row).collect()
    };
    let asked = Asked { contact: Some("left".into()), ..Asked::default() };
    let found =
        |text: String| read(&supported.case, "theirs.csv", format!("x [mm],y [mm],pressure [MPa]\n{text}"), &asked);
    assert!(found(rows(-30.0)).is_ok());
    workbench::refused(found(rows(-30.0) + &rows(30.0)), &["lies on contact `right`, beyond the stretch of `left`"]);
}
