//! Tables of several states, of more than the contact side, of other spellings: what they hold is read, or refused by
//! its column.

use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, Verdicts};

use crate::ellipse;
use crate::handed::{failed, in_units};
use crate::referee_wild::{judged, parsed, refused, usual};

/// Places 0.05 mm apart up to 3 mm.
fn places() -> impl Iterator<Item = f64> {
    (0..=60).map(|k| 0.05 * f64::from(k))
}

fn found(name: &str, text: &str, asked: &Asked) -> Verdicts {
    let read = parsed(name, text, asked).and_then(judged);
    read.unwrap_or_else(|error| panic!("{:?}: {error}", text.lines().next()))
}

#[test]
fn of_states_that_are_numbered_one_is_asked_for() {
    let of_state = |state: u32| -> String {
        let share = f64::from(state) / 4.0;
        let row =
            |s: f64| format!("{state},{},{}\n", s + 1e-3 * share, share.sqrt() * ellipse::pressure(s / share.sqrt()));
        places().map(row).collect()
    };
    let several: String = (1..=4).map(of_state).collect();
    for name in
        ["step", "Frame", "increment", "SUBSTEP", "NUME_ORDRE", "timestep", "load_step", "t", "Step Time", "state"]
    {
        let head = format!("{name},x,CPRESS\n");
        let said = format!("the column `{name}` has 1, 2, 3, 4");
        refused("theirs.csv", head.clone() + &several, &usual(), &[&said, "by --time"]);
        let last = Asked { time: Some(4.0), ..usual() };
        assert_eq!(failed(&found("theirs.csv", &(head.clone() + &several), &last)), [""; 0], "{name}");
        let first = Asked { time: Some(1.0), ..usual() };
        assert_ne!(failed(&found("theirs.csv", &(head.clone() + &several), &first)), [""; 0], "{name}");
        let second = Asked { step: Some(2), ..usual() };
        refused("theirs.csv", head.clone() + &several, &second, &["not the steps", "by --time: time 1; time 2"]);
        // One state alone, and what counts the rows.
        assert_eq!(failed(&found("theirs.csv", &(head.clone() + &of_state(4)), &usual())), [""; 0], "{name}");
        let counted: String =
            places().enumerate().map(|(k, s)| format!("{k},{s},{}\n", ellipse::pressure(s))).collect();
        assert_eq!(failed(&found("theirs.csv", &(head + &counted), &usual())), [""; 0], "{name}");
    }
    // Abaqus writes frames so.
    let frames =
        several.replace('\n', "\n\"Increment 7: Step Time = ").replacen("1,", "\"Increment 7: Step Time = 1,", 1);
    let frames: String = frames.lines().map(|row| format!("{}\n", row.replacen(',', ".000\",", 1))).collect();
    let frames = format!("Frame,x,CPRESS\n{}", frames.rsplit_once("\n\"").expect("rows").0);
    refused("theirs.csv", frames.clone(), &usual(), &["the column `Frame` has Increment 7", "by --time"]);
    for (time, fails) in [(4.0, false), (1.0, true)] {
        let one = Asked { time: Some(time), ..usual() };
        assert_eq!(!failed(&found("theirs.csv", &frames, &one)).is_empty(), fails, "{time}");
    }
    // Ansys writes times in a column of this name, of which the last one is judged.
    assert_eq!(failed(&found("theirs.csv", &format!("TIME/FREQ,x,CPRESS\n{several}"), &usual())), [""; 0]);
    // A time that begins anew with each step tells no state alone.
    let both: String =
        (3..=4).flat_map(|state| of_state(state).lines().map(|row| format!("1,{row}\n")).collect::<Vec<_>>()).collect();
    refused("theirs.csv", format!("time,step,x,CPRESS\n{both}"), &usual(), &["the column `step` has 3, 4"]);
}

#[test]
fn rows_of_another_side_or_of_inner_nodes_are_refused_by_the_column_that_tells_them() {
    let row = |name: &str, off: f64, share: f64| -> String {
        places().map(|s| format!("{name},{},{}\n", s + off, share * ellipse::pressure(s))).collect()
    };
    for (head, [own, other], part) in [
        ("part,x,CPRESS", ["A", "B"], "the column `part` is B of these, and A of the others"),
        ("y,x,CPRESS", ["0", "0.1"], "the column `y` is 0.1 of these, and 0 of the others"),
    ] {
        for off in [0.013, 0.025] {
            let text = format!("{head}\n{}{}", row(own, 0.0, 1.0), row(other, off, 0.0));
            refused("theirs.csv", &text, &usual(), &[part, "keep the rows that press alone"]);
            // Both have the pressures of the truth, or those of one are handed in.
            let right = |s: f64| format!("{other},{},{}\n", s + off, ellipse::pressure(s + off));
            let both = format!("{head}\n{}{}", row(own, 0.0, 1.0), places().map(right).collect::<String>());
            assert_eq!(failed(&found("theirs.csv", &both, &usual())), [""; 0], "{head}");
        }
        assert_eq!(failed(&found("theirs.csv", &format!("{head}\n{}", row(own, 0.0, 1.0)), &usual())), [""; 0]);
    }
    // Without a column that tells, they are no mid-sides unless they lie halfway.
    let mistakes = |off: f64| {
        let two = |s: f64| format!("{s},{}\n{},0\n", ellipse::pressure(s), s + off);
        found("theirs.csv", &format!("x,CPRESS\n{}", places().map(two).collect::<String>()), &usual()).mistakes
    };
    let is_named = |all: &[String]| all.iter().any(|one| one.contains("mid-side with a pressure of 0"));
    assert!(!is_named(&mistakes(0.013)), "{:?}", mistakes(0.013));
    assert!(is_named(&mistakes(0.025)), "{:?}", mistakes(0.025));
}

#[test]
fn units_are_found_in_any_brackets_of_a_title() {
    let text = |head: &str, times: f64| {
        let row = |s: f64| format!("{s},{}\n", times * ellipse::pressure(s));
        format!("x [mm],{head}\n{}", places().map(row).collect::<String>())
    };
    for (head, times) in [
        ("pressure [kPa] (nodal)", 1e3),
        ("CPRESS (nodal) [kPa]", 1e3),
        ("solid.Tn (MPa) @ t=1", 1.0),
        ("solid.Tn (Pa) @ t=[last]", 1e6),
        ("pressure (MPA)", 1.0),
    ] {
        let asked = Asked { columns: vec![(Role::Pressure, "2".into())], ..Asked::default() };
        assert_eq!(failed(&found("theirs.csv", &text(head, times), &asked)), [""; 0], "{head}");
        let wrong = found("theirs.csv", &text(head, 1e-3 * times), &asked);
        assert_ne!(failed(&wrong), [""; 0], "{head}");
        let against = in_units(&[(Role::Pressure, "GPa")]);
        let asked = Asked { units: against.units, ..asked };
        refused("theirs.csv", text(head, times), &asked, &["by the file, but in GPa by --unit pressure=GPa"]);
    }
    let plain = text("pressure [kPa] (nodal)", 1e3);
    assert_eq!(failed(&found("theirs.csv", &plain, &Asked::default())), [""; 0]);
}

#[test]
fn numbers_of_fortran_without_an_e_and_names_of_ansys_and_comsol_are_read() {
    let without = |value: f64| format!("{value:.9E}").replace("E-", "-0").replace('E', "+0");
    let row = |s: f64| format!("{} 0.0 {}\n", without(s), without(ellipse::pressure(s)));
    let rows: String = (0..ellipse::NODES).map(ellipse::place).map(row).collect();
    assert!(rows.contains("+02") && !rows.contains('E'), "{rows}");
    for head in ["XG YG PRES", "coord_x coord_y CONTPRES", "% x, y, solid.Tn (MPa)", "% X  Y  contact pressure [MPa]"] {
        ellipse::assert(&parsed("theirs.txt", format!("{head}\n{rows}"), &usual()).expect(head), 1e-8);
    }
    // COMSOL tells the unit of its lengths above them, Ansys the extremes below.
    let above = |unit: &str| format!("% Model: a.mph\n% Length unit:        {unit}\n% x  y  solid.Tn (MPa)\n{rows}");
    ellipse::assert(&parsed("theirs.txt", above("mm"), &Asked::default()).expect("a unit"), 1e-8);
    refused("theirs.txt", above("m"), &usual(), &["`x [m]` is in m by the file, but in mm by --unit"]);
    let below = "\n MAXIMUM ABSOLUTE VALUES\n NODE 1 1 1\n VALUE 2.0 0.0 100.0\n";
    let text =
        format!("LOCX LOCY CONTPRES\n{rows}{below}").replace("\n VALUE", "\n VALUE 0").replace("\n NODE", "\n NODE 0");
    let with_nodes: String = text
        .lines()
        .enumerate()
        .map(|(k, line)| match k {
            0 => format!("NODE {line}\n"),
            1..=ellipse::NODES => format!("{k} {line}\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    ellipse::assert(&parsed("theirs.txt", with_nodes, &usual()).expect("extremes"), 1e-8);
    // Two numbers, or a day, are no power of ten.
    for cell in ["1.5-2", "12-24", "3.5+1234"] {
        let text = format!("x [mm],p [MPa]\n0,3\n1,{cell}\n2,1\n3,0\n4,0\n");
        refused("theirs.csv", text, &usual(), &[&format!("`{cell}`, which is no number")]);
    }
}

#[test]
fn every_unit_is_what_its_definition_says() {
    // The inch, the pound and standard gravity are exact by the treaty of 1959 and the CGPM of 1901; the atmosphere by
    // that of 1954.
    let pound = 0.453_592_37 * 9.806_65;
    let lengths = [("mm", 1e-3), ("m", 1.0), ("um", 1e-6), ("nm", 1e-9), ("cm", 1e-2), ("in", 0.0254), ("ft", 0.3048)];
    let angles = [("rad", 1.0), ("deg", std::f64::consts::PI / 180.0), ("°", std::f64::consts::PI / 180.0)];
    let forces = [("N", 1.0), ("kN", 1e3), ("lbf", pound)];
    let areas = [("mm2", 1e-6), ("m2", 1.0), ("cm2", 1e-4), ("in2", 0.0254 * 0.0254)];
    let stresses = [
        ("MPa", 1e6),
        ("N/mm2", 1e6),
        ("kPa", 1e3),
        ("Pa", 1.0),
        ("GPa", 1e9),
        ("kN/mm2", 1e9),
        ("N/m2", 1.0),
        ("MN/m2", 1e6),
        ("bar", 1e5),
        ("atm", 101_325.0),
        ("kgf/mm2", 9_806_650.0),
        ("kgf/cm2", 98_066.5),
        ("psi", pound / (0.0254 * 0.0254)),
        ("ksi", 1e3 * pound / (0.0254 * 0.0254)),
        ("lbf/in2", pound / (0.0254 * 0.0254)),
    ];
    for (role, of_metres_and_newtons, ours) in [
        (Role::Position, &lengths[..], 1e-3),
        (Role::Position, &angles[..], 1.0),
        (Role::Gap, &lengths, 1e-3),
        (Role::Force, &forces, 1.0),
        (Role::Area, &areas, 1e-6),
        (Role::Pressure, &stresses, 1e6),
    ] {
        for (unit, size) in of_metres_and_newtons {
            let factor = role.factor(unit).expect("known");
            assert!((factor * ours / size - 1.0).abs() <= 1e-12, "{unit}: {factor}");
        }
    }
    for written in ["N/mm²", "N / mm^2", "N mm^-2", "N·mm⁻²"] {
        assert_eq!(Role::Pressure.factor(written), Some(1.0), "{written}");
    }
    assert_eq!(Role::Pressure.factor("N m^-2"), Role::Pressure.factor("Pa"));
    let named = |role: Role| role.units().len();
    let told = [Role::Position, Role::Gap, Role::Force, Role::Area, Role::Pressure].map(named);
    assert_eq!(
        told,
        [lengths.len() + angles.len(), lengths.len(), forces.len(), areas.len(), stresses.len()],
        "a unit is not asked here"
    );
}

#[test]
fn rows_that_begin_with_the_mark_of_a_comment_are_rows() {
    let text = |mark: &str| {
        let row = |(k, s): (usize, f64)| {
            let pressure = if k == 20 { mark.to_owned() } else { ellipse::pressure(s).to_string() };
            format!("{pressure};{s}\n")
        };
        let said = "# peak pressure;100\n# load [N];314.16";
        format!(
            "CPRESS;x\n# of step 2\n{said}\n{}# by hand\n#0.5;1e9\n",
            places().enumerate().map(row).collect::<String>()
        )
    };
    for mark in ["#N/A", "#NV", "#DIV/0!", "#REF!", "********", "!", "$"] {
        refused("theirs.csv", text(mark), &usual(), &[&format!("is `{mark}`, which is no number")]);
    }
    assert_eq!(failed(&found("theirs.csv", &text(&ellipse::pressure(1.0).to_string()), &usual())), [""; 0]);
    // A number of a node that needs more digits than the format has.
    let counted = |by: f64| {
        let row = |(k, s): (usize, f64)| {
            let [name, by] =
                if k == 20 { ["********".to_owned(), by.to_string()] } else { [k.to_string(), "1".into()] };
            format!("{name} {s} {}\n", ellipse::pressure(s) * by.parse::<f64>().unwrap_or(f64::NAN))
        };
        format!("node x CPRESS\n# printed 2 times\n{}", places().enumerate().map(row).collect::<String>())
    };
    assert_eq!(failed(&found("theirs.txt", &counted(1.0), &usual())), [""; 0]);
    assert_ne!(failed(&found("theirs.txt", &counted(0.6), &usual())), [""; 0]);
}

#[test]
fn rows_of_units_and_names_are_found_where_rows_hold_as_many_words_as_numbers() {
    let rows = |[first, between, behind]: [&str; 3], inch: f64| -> String {
        places().map(|s| format!("{first}{}{between}{}{behind}\n", s / inch, ellipse::pressure(s))).collect()
    };
    let of = |head: &str, marks: [&str; 3]| format!("{head}\n{}", rows(marks, 1.0));
    let latex = ["", " & ", r" \\"];
    for (name, text) in [
        ("words.csv", of("position;pressure;note;who\nmm;MPa;-;-", ["", ";", ";ok;me"])),
        ("first.csv", of("part;set;position;pressure;note\n;;mm;MPa;", ["B-1;S;", ";", ";ok"])),
        ("behind.csv", of("position;pressure;note;\nmm;MPa;-;", ["", ";", ";ok;"])),
        ("counts.txt", of("Results of job 7\n3 5 2024\nx pressure part set\nmm MPa - -", ["", " ", " B S"])),
        ("latex.txt", of(r"\hline x [mm] & p [MPa] \\", latex).replace(r"\hline ", "\\hline\n") + r"\hline"),
        ("close.txt", of("$x$ [mm]&$p$ [MPa]\\\\\\hline", ["", "&", r"\\[2pt]"]) + "\\hline\n\\end{tabular}"),
        ("commas.txt", of(r"x [mm]&p [MPa]\\", ["", "&", r"\\"]).replace('.', ",")),
        ("markdown.txt", of("| x [mm] | p [MPa] |\n|---:|---:|", ["| ", " | ", " |"])),
        ("dos.csv", of("x [mm],p [MPa]", ["", ",", ""]) + "\u{1a}"),
        ("block.csv", of("x [mm],p [MPa]", ["", ",", ""]) + &"\u{1a}".repeat(100)),
        ("inch.txt", format!("position pressure\nin MPa\n{}", rows(["", " ", ""], 25.4))),
        ("inches.txt", format!("note position pressure\n- in MPa\n{}", rows(["1 ", " ", ""], 25.4))),
    ] {
        assert_eq!(failed(&found(name, &text, &Asked::default())), [""; 0], "{name}");
    }
    let columns = vec![(Role::Position, "x".into()), (Role::Pressure, "s".into())];
    let asked = Asked { columns, ..in_units(&[(Role::Position, "in"), (Role::Pressure, "MPa")]) };
    let against = format!("z x s\nksi in MPa\n{}", rows(["0 ", " ", ""], 25.4));
    assert_eq!(failed(&found("inch.txt", &against, &asked)), [""; 0]);
    let other = Asked { units: in_units(&[(Role::Position, "mm"), (Role::Pressure, "MPa")]).units, ..asked };
    refused("inch.txt", against, &other, &["in in by the file, but in mm by --unit"]);
}
