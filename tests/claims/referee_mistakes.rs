//! Every usual mistake, made in a closed form, is named as what it is.

use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::measure::Quantity;
use contact_vv::mesh::Order;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::{Asked, Truth, verdicts};

use crate::ellipse::{Hertz, RIGHT};
use crate::handed::{PRESSURES, judged_as, judged_rows, read, table};
use crate::workbench;

/// The scene `tiny`, in another plane hypothesis and thickness.
fn scene(plane: &str, thickness: f64) -> Truth {
    let path = root().join("tests/data/wild/tiny.toml");
    let text = std::fs::read_to_string(&path).expect("a scene");
    let text = text.replace("\"strain\"", &format!("\"{plane}\""));
    let text = text.replace("thickness = 1.0", &format!("thickness = {thickness:?}"));
    Truth::of(Case::parse(&path, &text).expect("a case")).expect("solved")
}

/// E of the same material.
const STRESS: Hertz = Hertz { modulus: 91000.0, ..RIGHT };

/// Places up to 1.3 a and the pressures there, times a factor each.
fn profile(of: &Hertz, [place, pressure]: [f64; 2]) -> Vec<[f64; 2]> {
    let at = |x: f64| [place * of.half_width() * x, pressure * of.peak() * (1.0 - x * x).max(0.0).sqrt()];
    (0..=52).map(|k| at(0.025 * f64::from(k))).collect()
}

fn named(truth: &Truth, column: &str, rows: &[[f64; 2]], asked: &Asked) -> Vec<String> {
    let text = table(&format!("position [mm],{column}"), rows.iter().copied());
    let found = judged_as(truth, "theirs.csv", &text, asked);
    assert_eq!(found.met(), found.mistakes.is_empty(), "{text}");
    found.mistakes
}

/// That the mistakes named begin with these words, one each.
fn assert_named(found: &[String], wanted: &[&str], of: &str) {
    let same = found.len() == wanted.len() && found.iter().zip(wanted).all(|(own, part)| own.starts_with(part));
    assert!(same, "{of}: {found:#?} for {wanted:?}");
}

const RADIUS: &str = "the radius is twice the scene's";
const FLATTER: &str = "the radius is half of the scene's";

#[test]
fn every_wrong_input_of_hertz_is_named_by_what_it_does_to_width_and_pressure() {
    let [strain, stress] = ["strain", "stress"].map(|plane| scene(plane, 1.0));
    let half = "the load is half of the scene's";
    let twice = "the load is twice the scene's";
    let mut table: Vec<(&Truth, Hertz, [f64; 2], Vec<String>)> = vec![
        (&strain, RIGHT, [1.0, 1.0], vec![]),
        (&stress, STRESS, [1.0, 1.0], vec![]),
        (&strain, RIGHT, [1.0, -1.0], vec!["pressures are negative in compression".into()]),
        (&strain, Hertz { force: 0.5 * RIGHT.force, ..RIGHT }, [1.0, 1.0], vec![half.into()]),
        (&strain, Hertz { force: 2.0 * RIGHT.force, ..RIGHT }, [1.0, 1.0], vec![twice.into()]),
        // A load moves the width with the pressures.
        (&strain, RIGHT, [1.0, 0.5], vec!["pressures are half of the scene's over the scene's width".into()]),
        (&strain, RIGHT, [1.0, 2.0], vec!["pressures are twice the scene's over the scene's width".into()]),
        (&strain, Hertz { radius: 2.0 * RIGHT.radius, ..RIGHT }, [1.0, 1.0], vec![RADIUS.into()]),
        (&strain, Hertz { radius: 0.5 * RIGHT.radius, ..RIGHT }, [1.0, 1.0], vec![FLATTER.into()]),
        (&strain, Hertz { modulus: 0.5 * RIGHT.modulus, ..RIGHT }, [1.0, 1.0], vec![RADIUS.into()]),
        (&strain, RIGHT, [2.0, 1.0], vec!["positions are doubled".into()]),
        (&strain, RIGHT, [0.5, 1.0], vec!["positions are halved".into()]),
        (&strain, STRESS, [1.0, 1.0], vec!["plane stress was solved".into()]),
        (&stress, RIGHT, [1.0, 1.0], vec!["plane strain was solved".into()]),
        // Where the width is that of the scene, pressures alone are in proportion to E*.
        (&strain, RIGHT, [1.0, 0.91], vec!["plane stress was solved".into()]),
        (&stress, STRESS, [1.0, 1.0 / 0.91], vec!["plane strain was solved".into()]),
    ];
    let places = [("", 1.0), ("positions in m are called mm", 1e-3), ("positions in um are called mm", 1e3)];
    let pressures = [
        ("", 1.0),
        ("pressures in Pa are called MPa", 1e6),
        ("pressures in kPa are called MPa", 1e3),
        ("pressures in GPa are called MPa", 1e-3),
    ];
    for (place, by) in places {
        for (pressure, times) in
            pressures.into_iter().filter(|(pressure, _)| !(place.is_empty() && pressure.is_empty()))
        {
            let both = [place, pressure].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ");
            table.push((&strain, RIGHT, [by, times], vec![format!("units: {both}")]));
        }
    }
    let [bar, psi, inch] = [10.0, 145.037_737_730_209_22, 1.0 / 25.4];
    let (peak, a) = (100.0, 2.0);
    for (factors, wanted) in [
        ([1.0, bar], "units: pressures in bar are called MPa"),
        ([1.0, 1e-6], "units: pressures in MPa were taken for Pa, and converted"),
        ([1.0, 1.0 / bar], "units: pressures in MPa were taken for bar, and converted"),
        ([1.0, psi], "units: pressures in psi are called MPa"),
        ([1.0, 1e-3 * psi], "units: pressures in ksi are called MPa"),
        ([1.0, 1.0 / psi], "units: pressures in MPa were taken for psi, and converted"),
        ([inch, 1.0], "units: positions in inch are called mm"),
        ([1.0 / inch, 1.0], "units: positions in mm were taken for inch, and converted"),
        ([0.1, 1.0], "units: positions in cm are called mm"),
        ([inch, psi], "units: positions in inch are called mm, pressures in psi are called MPa"),
        ([0.1, bar], "units: positions in cm are called mm, pressures in bar are called MPa"),
        ([1.0, 1.0 / peak], "pressures are over their peak: hand"),
        ([1.0 / a, 1.0 / peak], "pressures are over their peak, and positions over the half-width"),
    ] {
        table.push((&strain, RIGHT, factors, vec![wanted.into()]));
    }
    for (k, (truth, wrong, factors, wanted)) in table.iter().enumerate() {
        let found = named(truth, "pressure [MPa]", &profile(wrong, *factors), &Asked::default());
        let wanted: Vec<&str> = wanted.iter().map(String::as_str).collect();
        assert_named(&found, &wanted, &format!("row {k}"));
    }
}

/// Forces of nodes: pressures times what of two edges belongs to each, by 1/2, 1/2, or by 1/6, 4/6, 1/6.
fn forces(profile: &[[f64; 2]], shares: &[f64], thickness: f64) -> Vec<[f64; 2]> {
    let mut forces: Vec<[f64; 2]> = profile.iter().map(|[s, _]| [*s, 0.0]).collect();
    let steps = shares.len() - 1;
    for first in (0..profile.len() - 1).step_by(steps) {
        let length = profile[first + steps][0] - profile[first][0];
        for (k, share) in shares.iter().enumerate() {
            forces[first + k][1] += share * length * thickness * profile[first + k][1];
        }
    }
    forces
}

#[test]
fn forces_of_another_thickness_are_named_and_those_of_every_order_are_right() {
    let (thin, thick) = (scene("strain", 1.0), scene("strain", 2.0));
    let [linear, quadratic]: [&[f64]; 2] = [&[0.5, 0.5], &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]];
    let [of_two, of_three] =
        [Order::Linear, Order::Quadratic].map(|order| Asked { order: Some(order), ..Asked::default() });
    let thicker = Hertz { thickness: 2.0, ..RIGHT };
    let [one, two] = [RIGHT, thicker].map(|own| profile(&own, [1.0, 1.0]));
    for (truth, rows, asked, wanted) in [
        (&thin, forces(&one, linear, 1.0), &of_two, vec![]),
        (&thin, forces(&one, quadratic, 1.0), &of_three, vec![]),
        // What is read by the shares of another order sways about the right pressures.
        (&thin, forces(&one, linear, 1.0), &of_three, vec!["every point is a corner"]),
        (&thin, forces(&one, quadratic, 1.0), &of_two, vec!["every second point is a mid-side"]),
        (&thin, forces(&one, quadratic, 1.0), &Asked::default(), vec![]),
        (&thick, forces(&two, linear, 2.0), &of_two, vec![]),
        (
            &thick,
            forces(&two, linear, 1.0),
            &of_two,
            vec![
                "forces are per unit thickness, but the scene is 2 mm thick",
                "forces are half of the scene's over the scene's width",
            ],
        ),
    ] {
        let found = named(truth, "force [N]", &rows, asked);
        assert_named(&found, &wanted, &format!("{wanted:?}"));
    }
}

#[test]
fn forces_are_what_they_are_where_their_positions_are_others() {
    // Of a half-width of 2 mm positions over it would be halved as well: this one is 2/√3.
    let (truth, thicker) = (scene("strain", 3.0), Hertz { thickness: 3.0, ..RIGHT });
    let right = forces(&profile(&thicker, [1.0, 1.0]), &[0.5, 0.5], 3.0);
    let scaled = |[place, force]: [f64; 2]| right.iter().map(|[s, f]| [place * s, force * f]).collect::<Vec<_>>();
    for (factors, wanted) in [
        ([2.0, 1.0], vec!["positions are doubled"]),
        ([0.5, 1.0], vec!["positions are halved"]),
        ([1.0 / thicker.half_width(), 1.0], vec!["positions are over the half-width"]),
        ([1.0, 2.0], vec!["forces are twice the scene's over the scene's width"]),
    ] {
        let found = named(&truth, "force [N]", &scaled(factors), &Asked::default());
        assert_named(&found, &wanted, &format!("{factors:?}"));
    }
    // Twice the force over twice the width is no mistake of positions.
    for factors in [[2.0, 2.0], [0.5, 0.5]] {
        let found = judged_rows(&truth, "position [mm],force [N]", scaled(factors));
        assert!(!found.met() && found.mistakes.is_empty(), "{factors:?}: {:?}", found.mistakes);
    }
}

#[test]
fn twice_the_pressure_is_twice_the_load_where_that_does_not_change_the_width() {
    let truth = workbench::truth("flat-punch");
    let end = truth.run.contacts[0].measures.edge();
    let row = |k: i32| {
        let s = end * f64::from(k) / 160.0;
        [s, 2.0 * truth.pressure(0, s.min(0.998 * end))]
    };
    let text = table(PRESSURES, (0..=160).map(row));
    let found = verdicts(truth, read(&truth.case, "theirs.csv", text, &Asked::default()).expect("read"), 5e-2);
    assert_named(&found.expect("judged").mistakes, &["the load is twice the scene's"], "punch");
}

#[test]
fn mistakes_are_found_in_a_great_many_points() {
    let (truth, a) = (scene("strain", 1.0), RIGHT.half_width());
    let row = |k: u32| {
        let x = 1.3 * f64::from(k) / 70_000.0;
        [2.0 * a * x, RIGHT.pressure(a * x)]
    };
    let found = named(&truth, "pressure [MPa]", &(0..70_000).map(row).collect::<Vec<_>>(), &Asked::default());
    assert_named(&found, &["positions are doubled"], "many");
}

#[test]
fn profiles_that_are_moved_or_of_which_half_is_missing_are_named_with_the_way() {
    let truth = scene("strain", 1.0);
    let right = profile(&RIGHT, [1.0, 1.0]);
    let whole: Vec<[f64; 2]> = right.iter().skip(1).rev().map(|[s, p]| [-s, *p]).chain(right.iter().copied()).collect();
    let shifted = |rows: &[[f64; 2]], by: usize| -> Vec<[f64; 2]> {
        let coarse: Vec<[f64; 2]> = rows.iter().step_by(2).copied().collect();
        let value = |k: usize| coarse[(k + by).saturating_sub(1).min(coarse.len() - 1)][1];
        coarse.iter().enumerate().map(|(k, [s, _])| [*s, value(k)]).collect()
    };
    let sign = |right: bool| if right { 1.0 } else { -1.0 };
    let moved = |by: f64| whole.iter().map(|[s, p]| [s + by, *p]).collect::<Vec<_>>();
    let one_half = |right: bool| {
        whole.iter().map(|[s, p]| [*s, if sign(right) * *s >= 0.0 { *p } else { 0.0 }]).collect::<Vec<_>>()
    };
    for (rows, wanted) in [
        (whole.clone(), vec![]),
        (shifted(&right, 0), vec!["pressures are shifted by one node: each belongs to the node before"]),
        (shifted(&right, 2), vec!["pressures are shifted by one node: each belongs to the node behind"]),
        (moved(0.4), vec!["all positions are off by about 0.4"]),
        (moved(-0.3), vec!["all positions are off by about -0.3"]),
        (one_half(true), vec!["the left half of the profile is missing"]),
        (one_half(false), vec!["the right half of the profile is missing"]),
    ] {
        let found = named(&truth, "pressure [MPa]", &rows, &Asked::default());
        assert_named(&found, &wanted, &format!("{wanted:?}"));
    }
}

#[test]
fn angles_and_pressures_of_a_press_fit_in_other_units_are_named() {
    let truth = workbench::truth("press-fit");
    let pressure = truth.pressure(0, 0.5);
    let rows = |place: f64, times: f64| -> Vec<[f64; 2]> {
        (0..=18).map(|k| [place * 5.0 * f64::from(k), times * pressure]).collect()
    };
    let degrees = std::f64::consts::PI / 180.0;
    for (rows, wanted) in [
        (rows(1.0, 1.0), ""),
        (rows(1.0, 1e6), "units: pressures in Pa are called MPa"),
        (rows(degrees, 1.0), "units: angles in rad are called deg"),
        (rows(1.0 / degrees, 1.0), "units: angles in deg were taken for rad, and converted"),
    ] {
        let text = table("position [deg],pressure [MPa]", rows);
        let answer = read(&truth.case, "theirs.csv", text, &Asked::default()).expect("read");
        // What ends under pressure is refused, with what explains it.
        let named = match verdicts(truth, answer, ENGINEERING) {
            Ok(found) => found.mistakes.join("; "),
            Err(error) => error.to_string(),
        };
        assert!(if wanted.is_empty() { named.is_empty() } else { named.contains(wanted) }, "{wanted}: {named}");
    }
}

#[test]
fn every_number_that_is_judged_has_the_value_of_its_closed_form() {
    let (thin, thick) = (scene("strain", 1.0), scene("strain", 2.0));
    let thicker = Hertz { thickness: 2.0, ..RIGHT };
    let (a, force) = (RIGHT.half_width(), RIGHT.force);
    let sides = |own: &Hertz, sides: [bool; 2]| -> Vec<[f64; 2]> {
        let half = profile(own, [1.0, 1.0]);
        let on = |side: bool, p: f64| if side { p } else { 0.0 };
        let left = half.iter().skip(1).rev().map(|[s, p]| [-s, on(sides[0], *p)]);
        left.chain(half.iter().map(|[s, p]| [*s, on(sides[1], *p)])).collect()
    };
    let scaled = |[place, pressure]: [f64; 2]| -> Vec<[f64; 2]> {
        sides(&RIGHT, [true; 2]).iter().map(|[s, p]| [s + place, p * pressure]).collect()
    };
    let pulled = |by: f64| -> Vec<[f64; 2]> {
        let own = sides(&RIGHT, [true; 2]);
        own.iter().enumerate().map(|(k, [s, p])| [*s, if k == 2 { -by * RIGHT.peak() } else { *p }]).collect()
    };
    // What a force of its own makes of the approach, F/E*t.
    let approach = |own: &Hertz, force: f64| force / (own.modulus * own.thickness);
    let (none, deep, open) = (0.0, -1e-3, 1e-3);
    let (right, depth) = (scaled([0.0, 1.0]), 1e-3 / approach(&RIGHT, force));
    let rows = [
        (
            "right",
            &thin,
            right.clone(),
            none,
            vec![
                ("second-moment width", a),
                ("peak pressure", RIGHT.peak()),
                ("error of the mean pressures", 0.0),
                ("begin of the contact", -a),
                ("end of the contact", a),
                ("resultant", force),
                ("largest tension", 0.0),
                ("moment of the pressures", 0.0),
                ("difference of both halves", 0.0),
                ("largest penetration", 0.0),
                ("gap under pressure", 0.0),
            ],
        ),
        ("stronger", &thin, scaled([0.0, 1.03]), none, vec![("error of the mean", 0.03), ("resultant", 1.03 * force)]),
        (
            "moved",
            &thin,
            scaled([0.4, 1.0]),
            none,
            vec![("moment of the pressures", 0.4 / a), ("begin", 0.4 - a), ("end of the contact", 0.4 + a)],
        ),
        // The centre of half an ellipse lies at 4a/3π.
        (
            "right half",
            &thin,
            sides(&RIGHT, [false, true]),
            none,
            vec![
                ("moment of the pressures", 4.0 / (3.0 * std::f64::consts::PI)),
                ("difference of both halves", 2f64.sqrt()),
            ],
        ),
        ("pulled", &thin, pulled(0.05), none, vec![("largest tension", 0.05)]),
        ("deep", &thin, right.clone(), deep, vec![("largest penetration", depth), ("gap under", depth)]),
        ("open", &thin, right.clone(), open, vec![("largest penetration", 0.0), ("gap under", depth)]),
        (
            "deep and thick",
            &thick,
            sides(&thicker, [true; 2]),
            deep,
            vec![
                ("largest penetration", 1e-3 / approach(&thicker, force)),
                ("resultant", force),
                ("second-moment", thicker.half_width()),
            ],
        ),
        (
            "one half, deep",
            &thin,
            profile(&RIGHT, [1.0, 1.0]),
            deep,
            vec![("largest penetration", 1e-3 / approach(&RIGHT, 0.5 * force)), ("resultant", force)],
        ),
    ];
    let mut wrong = Vec::new();
    for (of, truth, rows, gap, wanted) in rows {
        let found =
            judged_rows(truth, "position [mm],pressure [MPa],gap [mm]", rows.iter().map(|[s, p]| [*s, *p, gap]));
        for (name, value) in wanted {
            let judged = &found.ruled[0].judged;
            let own = judged.iter().find(|one| one.check.quantity.to_string().contains(name));
            let own = own.unwrap_or_else(|| panic!("{of}: no {name}")).value;
            // Straight lines between 41 points of a half ellipse, which end within an edge of 0.025 a.
            if (own - value).abs() <= 2e-2 * value.abs().max(1.0) {
                continue;
            }
            wrong.push(format!("{of}, {name}: {own} for {value}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn an_end_is_that_of_the_closed_form_to_one_edge_of_the_mesh_around_it() {
    let (truth, a) = (scene("strain", 1.0), RIGHT.half_width());
    // Edges of 0.2 a, and from 0.8 a on those of 0.02 a, or the other way round.
    for (end, inner, outer) in [(0.02, 10, 100), (0.1, 100, 10)] {
        let inside = (0..inner).map(|k| 0.8 * f64::from(k) / f64::from(inner));
        let places = inside.chain((0..=outer).map(|k| 0.8 + f64::from(k) * end)).take_while(|x| *x <= 1.5);
        let found = judged_rows(&truth, PRESSURES, places.map(|x| [a * x, RIGHT.pressure(a * x)]));
        let all = &found.ruled[0].judged;
        let own = all.iter().find(|one| one.check.quantity.to_string().contains("end of the contact")).expect("judged");
        assert_eq!(own.reference.name, truth.closed(&Quantity::HalfWidth).expect("Hertz").name);
        let allowed = ENGINEERING * a + end * a + truth.known(0, &Quantity::End(0)).bar;
        assert!((own.check.tolerance - allowed).abs() <= 1e-9, "{} for {allowed}", own.check.tolerance);
    }
}

#[test]
fn radii_of_a_ring_that_touches_off_its_axis_are_named() {
    let text = "title = \"ring on a flat\"\nplane = \"axisymmetric\"\n[[body]]\nname = \"ring\"\nyoung = \
        210e3\npoisson = 0.3\n\
                shape = { rectangle = { x = [30, 50], y = [0, 25], contact = \"bottom\" } }\nloads = [{ traction = { \
                at = \"far\", value = [0, -50] } }]\n\
                [contact]\nfirst = \"ring\"\norigin = [40, 0]\ngap = { circle = 200 }\nstretch = 6\nboth-sides = \
                true\n[mesh]\nelements = 16\nper = 2\n";
    let truth = Truth::of(workbench::parsed(text)).expect("solved");
    for (from, wanted) in
        [(0.0, &[][..]), (40.0, &["positions are radii: count them from the middle of the contact, at r = 40.00 mm"])]
    {
        let rows: Vec<[f64; 2]> =
            (-60..=60).map(|k| 0.05 * f64::from(k)).map(|s| [from + s, truth.pressure(0, s)]).collect();
        assert_named(&named(&truth, "pressure [MPa]", &rows, &Asked::default()), wanted, "a ring");
    }
}

#[test]
fn points_of_another_contact_and_forces_and_pressures_that_are_called_the_other_are_named() {
    let between = workbench::truth("roller-between-plates");
    let rows = (0..=60).map(|k| 0.04 * f64::from(k)).map(|s| format!("{s},{},above\n", between.pressure(1, s)));
    let text = format!("{PRESSURES},contact\n{}", rows.collect::<String>());
    let found = judged_as(between, "theirs.csv", &text, &Asked::default());
    assert_named(&found.mistakes, &["the points of contact `above` are those of contact `below`"], "roller");
    let thin = scene("strain", 1.0);
    let pressures = profile(&RIGHT, [1.0, 1.0]);
    let forces = forces(&pressures, &[0.5, 0.5], 1.0);
    for (column, rows, wanted) in [
        ("pressure [MPa]", forces, "nodal forces are called pressures"),
        ("force [N]", pressures.clone(), "pressures are called forces"),
    ] {
        assert_named(&named(&thin, column, &rows, &Asked::default()), &[wanted], column);
    }
    for (times, wanted) in [
        (1.0 / 9.806_65, "units: pressures in kgf/mm2 are called MPa"),
        (1.0 / 0.098_066_5, "units: pressures in kgf/cm2 are called MPa"),
    ] {
        let found = named(&thin, "pressure [MPa]", &profile(&RIGHT, [1.0, times]), &Asked::default());
        assert!(found[0].starts_with(wanted), "{found:?}");
    }
}
