//! Files as people have them: what they hold is read, whatever its widths, marks and names; what they lack is no zero,
//! and a part is not judged.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use approx::assert_relative_eq;
use contact_vv::accuracy::Quantity;
use contact_vv::case::library::find;
use contact_vv::case::{Case, Judged, Quantity as Asks};
use contact_vv::checkout::root;
use contact_vv::cli::vtu;
use contact_vv::error::Error;
use contact_vv::mesh::Order;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, Truth, Verdicts, read, verdicts};

use crate::ellipse::{self, Hertz, RIGHT};
use crate::foreign::{Frd, fixed, record, vtk};
use crate::handed::{PRESSURES, failed, in_units, judged_as, judged_rows, read, table};
use crate::outputs::{UNITS, contact_vv};
use crate::program::Folder;
use crate::scene_file::text_of;
use crate::workbench;

fn folder() -> PathBuf {
    root().join("tests/data/wild")
}

/// A block pressed by a rigid parabola, by Hertz: a = 2 mm, p₀ = 100 MPa.
pub fn tiny() -> Case {
    Case::read(&folder().join("tiny.toml")).expect("a case")
}

pub static TRUTH: LazyLock<Truth> = LazyLock::new(|| Truth::of(tiny()).expect("solved"));

/// As the inputs are read.
pub fn usual() -> Asked {
    in_units(&[(Role::Position, "mm"), (Role::X, "mm"), (Role::Y, "mm"), (Role::Pressure, "MPa"), (Role::Gap, "mm")])
}

fn naming(columns: &[(Role, &str)]) -> Asked {
    Asked { columns: columns.iter().map(|(role, name)| (*role, (*name).to_owned())).collect(), ..usual() }
}

pub fn parsed(name: &str, text: impl AsRef<[u8]>, asked: &Asked) -> Result<Answer, Error> {
    read(&TRUTH.case, name, text, asked)
}

pub fn judged(answer: Answer) -> Result<Verdicts, Error> {
    verdicts(&TRUTH, answer, ENGINEERING)
}

fn peak_of(answer: Answer) -> f64 {
    judged(answer).expect("judged").ruled[0].measures.peak.pressure
}

/// That it is refused, or not judged, for what is named; what is said.
pub fn refused(name: &str, text: impl AsRef<[u8]>, asked: &Asked, parts: &[&str]) -> String {
    workbench::refused(parsed(name, text, asked).and_then(judged), &[&[name], parts].concat())
}

#[test]
fn files_of_the_wild_are_judged_as_what_they_hold() {
    let handed = |file: &str, asked: &Asked| read::read(&folder().join(file), &TRUTH.case, asked);
    let refused = |file: &str, asked: &Asked, parts: &[&str]| workbench::refused(handed(file, asked), parts);
    for (file, wanted) in [("8_frd_three_digit_exponents.frd", 99.92), ("6_vtk_5.1.vtk", 100.0)] {
        assert_relative_eq!(peak_of(handed(file, &usual()).expect(file)), wanted, max_relative = 2e-3);
    }
    let of_six = "15_field_of_six.vtk";
    let third = naming(&[(Role::Pressure, "CONTACT:3"), (Role::Gap, "CONTACT:0")]);
    assert_relative_eq!(peak_of(handed(of_six, &third).expect(of_six)), 100.0, max_relative = 2e-3);
    let whole = naming(&[(Role::Pressure, "CONTACT")]);
    refused(of_six, &whole, &["`CONTACT` has 6 components", "3 of CPRESS", "pressure=CONTACT:3"]);
    let gap = naming(&[(Role::Pressure, "CONTACT:3"), (Role::Gap, "CONTACT")]);
    refused(of_six, &gap, &["of which gap is one", "gap=CONTACT:0"]);
    let components = "METADATA\nCOMPONENT_NAMES\nCOPEN\nCSLIP1\nCSLIP2\nCPRESS\nCSHEAR1\nCSHEAR2\n\n";
    let named = std::fs::read_to_string(folder().join(of_six)).expect(of_six) + components;
    workbench::refused(parsed("theirs.vtk", &named, &whole), &["name it, such as --column pressure=CONTACT:CPRESS"]);
    let by_name = naming(&[(Role::Pressure, "CONTACT:CPRESS"), (Role::Gap, "CONTACT:COPEN")]);
    assert_relative_eq!(peak_of(parsed("theirs.vtk", &named, &by_name).expect("named")), 100.0, max_relative = 2e-3);
    let parts = ["values at 11 nodes, 11 of which the file does not have", "25 of the 25 nodes", "OUTPUT=3D"];
    refused("1_frd_nodes_not_in_file.frd", &usual(), &parts);
    let early = judged(handed("5_frd_last_increment_0.4.frd", &usual()).expect("read")).expect("judged");
    assert!(
        !early.met() && early.notes.iter().any(|note| note.contains("increment 1, time 0.4, which is not the end"))
    );
    assert!(early.answer.read.iter().any(|how| how.contains("block CONTACT of step 1, increment 1, time 0.4")));
}

#[test]
fn tables_of_the_wild_are_read_and_met() {
    let files = std::fs::read_dir(folder().join("tables")).expect("tables");
    let files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    assert_eq!(files.len(), 9);
    for file in files {
        // What is named for others, with which most agree.
        let asked = if file.ends_with("inch_psi.csv") { Asked::default() } else { usual() };
        let answer = read::read(&file, &TRUTH.case, &asked).unwrap_or_else(|error| panic!("{error}"));
        let found = judged(answer).expect("judged");
        assert_relative_eq!(found.ruled[0].measures.peak.pressure, 100.0, max_relative = 2e-3);
        assert!(found.met(), "{}", file.display());
    }
}

#[test]
fn the_pressure_of_a_contact_goes_before_that_of_a_body() {
    let rows = ellipse::rows(",", |x| format!("{x:.6}")).replace('\n', ",-7\n");
    for name in ["CPRESS", "contact_pressure", "Contact pressure"] {
        let text = format!("position [mm],{name} [MPa],pressure [MPa]\n{rows}");
        assert_relative_eq!(peak_of(parsed("both.csv", text, &usual()).expect(name)), 100.0, max_relative = 2e-3);
    }
}

#[test]
fn tables_say_the_same_whatever_their_marks_numbers_and_names() {
    let row = |separator: &str, number: fn(f64) -> String| ellipse::rows(separator, number);
    let plain: fn(f64) -> String = |x| format!("{x:.6}");
    let comma: fn(f64) -> String = |x| format!("{x:.6}").replace('.', ",");
    let fortran: fn(f64) -> String = |x| format!("{x:.6E}").replace('E', "d");
    let heads = [
        "x [mm],pressure [MPa]\n",
        "\u{feff}position / mm,contact pressure / MPa\n",
        "X Location (mm),Pressure (N / mm^2)\n",
        "Position in mm,Contact pressure in MPa\n",
        "position,pressure\n[mm],[N/mm²]\n",
        "position,pressure\nmm,MPa\n",
        "// solved by hand\n! twice\nposition (mm),Tn (MPa)\n",
        "x/mm,p/N/mm2\n",
        "x_mm,contact_pressure_MPa\n",
        "LOCX [mm],PRES [MPa]\n",
        "arc_length [mm],contact_pressure [MPa]\n",
        "Length [mm],Pressure [MPa]\n",
        "# position,pressure\n# mm,MPa\n",
        "# x [mm] CPRESS [MPa]\n",
        "x [mm],p [MPa]\nmm,MPa\n",
        "n,97\n0.3,210000\nposition [mm],pressure [MPa]\n",
    ];
    let commas = heads.map(|head| format!("{head}{}", row(",", plain)));
    let others = [
        format!("position [mm];pressure [MPa]\r\n{}", row(" ; ", comma).replace('\n', "\r\n")),
        format!("Position;pressure\nmm;MPa\n{}", row(";", comma).replace('\n', ";\n")),
        format!("position [mm]\tpressure [MPa]\n{}", row("\t", comma)),
        format!("position [mm]   pressure [MPa]\n{}", row("   ", comma)),
        format!("# x [mm] p [MPa]\n{}", row(" ", fortran)),
        format!("x in mm p in MPa\n{}", row(" ", plain)),
        format!("x [mm],p [MPa]\n\"{}\"\n", row("\",\"", comma).trim_end().replace('\n', "\"\n\"")),
        // A list in a column that is not read.
        format!("x [mm],p [MPa],nodes\n{}\n", row(",", plain).trim_end().replace('\n', ",\"2,3\"\n") + ",\"2,3\""),
        format!("$ x (mm)  Contact Pressure (MPa)\n{}", row("  ", plain)),
        format!(
            "***\nField Output Report, written Mon Nov 23 10:21:07\n\n  Node    COORD.COOR1 [mm]    CPRESS [MPa]\n  \
            Label              @Loc 1          @Loc 1\n-----\n{}\n\n  Minimum 0.  0.\n      At Node 4\n",
            row("  ", plain).lines().enumerate().map(|(k, line)| format!("  {}  {line}\n", k + 1)).collect::<String>()
        ),
    ];
    for text in commas.iter().chain(&others) {
        let answer = parsed("theirs.rpt", text, &Asked::default()).unwrap_or_else(|error| panic!("{text}: {error}"));
        ellipse::assert(&answer, 1e-5);
    }
    // Single rows that are set apart are rows of the same table.
    let apart = format!("# x [mm] p [MPa]\n{}", row(" ", plain).replace('\n', "\n\n"));
    ellipse::assert(&parsed("theirs.csv", apart, &Asked::default()).expect("read"), 1e-5);
    // Columns without a head by their numbers; a .dat that is no file of CalculiX.
    let numbered = naming(&[(Role::Position, "1"), (Role::Pressure, "2")]);
    ellipse::assert(&parsed("savetxt.dat", row(" ", plain), &numbered).expect("read"), 1e-5);
    // Zeros that ParaView masks are no pressures.
    let masked = row(",", plain).lines().map(|line| format!("{line},1\n")).collect::<String>();
    let masked = format!("Position [mm],Pressure [MPa],vtkValidPointMask\n{masked}0.001,0,0\n");
    ellipse::assert(&parsed("theirs.csv", masked, &Asked::default()).expect("read"), 1e-5);
    // Of a line that begins elsewhere than the contact does, coordinates go before the length.
    let begun = row(",", plain).lines().enumerate().map(|(k, line)| format!("{k},{line},0\n")).collect::<String>();
    for names in ["arc_length,Points:0 [mm],contact_pressure [MPa],Points:1", "Length,LOCX [mm],PRES [MPa],LOCY"] {
        ellipse::assert(&parsed("theirs.csv", format!("{names}\n{begun}"), &Asked::default()).expect(names), 1e-5);
    }
    // A column that is not used needs no unit.
    let more = row(",", plain).lines().map(|line| format!("{line},7,0\n")).collect::<String>();
    let more = format!("position [mm],pressure [MPa],force,Points:1\n{more}");
    ellipse::assert(&parsed("theirs.csv", more, &Asked::default()).expect("read"), 1e-5);
}

#[test]
fn radius_and_axis_are_those_of_the_scene_whichever_way_it_is_turned() {
    let case = Case::read(&root().join("tests/cases/shrunk-ring.toml")).expect("a case");
    let read = |head: &str, row: fn(f64) -> String| {
        let rows: String = [-15.0, 0.0, 15.0].into_iter().map(row).collect();
        read(&case, "ring.csv", format!("{head},pressure [MPa]\n{rows}"), &Asked::default())
    };
    for found in [read("r [mm],z [mm]", |z| format!("20,{z},41\n")), read("z [mm]", |z| format!("{z},41\n"))] {
        let places: Vec<f64> = found.expect("read").contacts[0].points.iter().map(|point| point.position).collect();
        assert_eq!(places, [-15.0, 0.0, 15.0]);
    }
    let turned = read("r [mm],z [mm]", |z| format!("{z},20,41\n"));
    workbench::refused(turned, &["the point 20, -15 mm, by the column `r [mm]`, lies 35.000 mm off"]);
    workbench::refused(read("r [mm]", |z| format!("{z},41\n")), &["no column is called `position` or `x`"]);
}

#[test]
fn gaps_of_0_beyond_the_contact_are_counted() {
    // The gap 0.002 mm (ξ √(ξ² − 1) − arcosh ξ), ξ = s / 2 mm, is over 1 % of P/E* = 0.00314 mm at 2.1 mm and beyond:
    // 28 of the places.
    let rows = ellipse::rows(",", |x| x.to_string()).replace('\n', ",0\n");
    let found = parsed("gaps.csv", format!("position [mm],pressure [MPa],gap [mm]\n{rows}"), &usual()).and_then(judged);
    let missing = &found.expect("judged").ruled[0].missing;
    assert!(missing.iter().any(|[what, _]| what.starts_with("gaps of 0 at 28 points beyond")), "{missing:?}");
}

#[test]
fn nodes_of_the_contact_without_a_value_are_counted_and_no_zeros() {
    let whole = Frd::plain();
    let full = peak_of(parsed("theirs.frd", whole.text(), &usual()).expect("read"));
    // Those that are listed reach to where nothing presses: the rest is beyond the contact.
    let pressed = Frd { listed: (0..=20).collect(), ..Frd::plain() };
    assert_relative_eq!(peak_of(parsed("theirs.frd", pressed.text(), &usual()).expect("read")), full);
    for (listed, lacking) in [((1..49).collect::<Vec<_>>(), 1), ((0..49).filter(|k| k % 4 != 3).collect(), 12)] {
        let holes: Frd = Frd { listed, ..Frd::plain() };
        let count = format!("{lacking} of the 49 nodes");
        refused("theirs.frd", holes.text(), &usual(), &[&count, "none is no zero", "up to where nothing presses"]);
    }
    // Where they stop under pressure the rest is no zero either.
    let begun = Frd { listed: (0..8).collect(), ..Frd::plain() };
    let found = judged(parsed("theirs.frd", begun.text(), &usual()).expect("read"));
    workbench::refused(found, &["stop at 0.7", "of the force lies beyond"]);
    for nan in ["nan", "-nan(ind)", "NaN"] {
        // In the middle of the file: what stands behind it is read too.
        let text =
            vtk::ascii(&|s| if (s - 0.6).abs() < 1e-9 { nan.into() } else { format!("{:e}", ellipse::pressure(s)) });
        let part = if nan == "-nan(ind)" { "`-nan(ind)` is no number" } else { "1 of the 49 nodes" };
        refused("theirs.vtk", text, &usual(), &[part]);
    }
}

#[test]
fn nodes_of_an_expanded_slice_are_judged_as_those_of_the_plane() {
    for expanded in [Frd { slice: true, ..Frd::plain() }, Frd { slice: true, layer: 1, ..Frd::plain() }] {
        let answer = parsed("theirs.frd", expanded.text(), &usual()).expect("read");
        ellipse::assert(&answer, 1e-5);
        assert!(judged(answer).expect("judged").met());
    }
    // Where the contact's nodes are there, at the same place, though the cells are plane.
    ellipse::assert(&parsed("theirs.frd", Frd { layer: 1, ..Frd::plain() }.text(), &usual()).expect("read"), 1e-5);
    // Where the contact names nodes that neither has, the other way of writing is advised.
    for (slice, advised) in
        [(true, "leave OUTPUT=3D out"), (false, "write *CONTACT FILE and *NODE FILE with OUTPUT=3D")]
    {
        let text = Frd { slice, layer: 2, ..Frd::plain() }.text();
        refused("theirs.frd", text, &usual(), &["values at 49 nodes, 49 of which the file does not have", advised]);
    }
    let skew = Frd { slice: true, skew: 0.05, ..Frd::plain() };
    refused("theirs.frd", skew.text(), &usual(), &["do not lie in pairs at the same x and y"]);
}

#[test]
fn pressure_at_nodes_that_a_frd_lacks_is_refused_and_none_there_is_counted() {
    let with = |pressure: f64| {
        let rows: String = (901..906).map(|node| record(node, &fixed([0.0, 0.0, 0.0, pressure, 0.0, 0.0]))).collect();
        Frd::plain().text().replace(" -3\n 9999", &format!("{rows} -3\n 9999"))
    };
    let parts =
        ["54 nodes, 5 of which the file does not have", "5 of them under pressure", "0 of the 49 nodes", "OUTPUT=3D"];
    refused("theirs.frd", with(50.0), &usual(), &parts);
    let answer = parsed("theirs.frd", with(0.0), &usual()).expect("read");
    assert!(
        answer.notes.iter().any(|note| note.contains("not have 5 nodes of its contact block")),
        "{:?}",
        answer.notes
    );
    ellipse::assert(&answer, 1e-5);
}

#[test]
fn layers_of_a_slice_that_are_pressed_unlike_are_refused() {
    let layer = |share: f64| {
        let row = |node: usize| {
            let s = ellipse::place(node);
            record(node + 101, &fixed([ellipse::gap(s), 7.0, 5.0, share * ellipse::pressure(s), 3.0, 2.0]))
        };
        let rows: String = (0..ellipse::NODES).map(row).collect();
        Frd { slice: true, ..Frd::plain() }.text().replace(" -3\n 9999", &format!("{rows} -3\n 9999"))
    };
    ellipse::assert(&parsed("theirs.frd", layer(1.0 - 1e-4), &usual()).expect("read"), 1e-4);
    refused("theirs.frd", layer(0.5), &usual(), &["nodes 1 and 101 of its contact block", "pressures 100 and 50"]);
}

#[test]
fn numbers_of_a_frd_are_read_whatever_their_width_and_no_part_of_one_is() {
    let widths: [fn(f64) -> String; 5] = [
        |x| format!("{x:>12.5E}"),
        |x| format!(" {x:.5E}"),
        |x| Frd::exponent(x, 3),
        |x| format!(" {x:.3}"),
        |x| format!("{x:>20.12E}"),
    ];
    for width in widths {
        ellipse::assert(
            &parsed("theirs.frd", Frd { number: width, ..Frd::plain() }.text(), &usual()).expect("read"),
            2e-3,
        );
    }
    let text = Frd::plain().text();
    let line = text.lines().position(|line| line.contains("9.94987E1")).expect("a row") + 1;
    for wrong in ["9.94987E1X", "9.94987E1 7.0", "--1", "nan", "9.94987E", "9.94987E1E2", "9.9.4", "9,94987E1"] {
        let spoiled = text.replacen("9.94987E1", wrong, 1);
        refused("theirs.frd", spoiled, &usual(), &[&format!("theirs.frd:{line}"), "this line is cut, or holds no"]);
    }
}

#[test]
fn a_node_of_a_frd_that_is_written_twice_has_one_place_and_one_pressure() {
    let text = Frd::plain().text();
    for part in ["1.00000E-1", "9.98749E1"] {
        let row = text.lines().find(|line| line.starts_with(" -1") && line.contains(part)).expect("a row");
        let twice = |second: &str| text.replacen(row, &format!("{row}\n{second}"), 1);
        ellipse::assert(&parsed("theirs.frd", twice(row), &usual()).expect("read"), 1e-5);
        let line = text.lines().position(|line| line == row).expect("a row") + 2;
        let other = twice(&row.replace(&part[..6], "5.0000"));
        refused("theirs.frd", other, &usual(), &[&format!("theirs.frd:{line}"), "has other numbers of node"]);
    }
}

#[test]
fn the_state_that_is_judged_is_printed_named_and_chosen() {
    let two = Frd { states: vec![(1, 4, 1.0, 0.5), (2, 3, 1.7, 0.8), (2, 5, 2.0, 1.0)], ..Frd::plain() };
    let at = |asked: Asked| judged(parsed("theirs.frd", two.text(), &asked).expect("read")).expect("judged");
    let says = |found: &Verdicts, part: &str| found.notes.iter().any(|note| note.contains(part));
    let last = at(usual());
    assert!(last.met() && last.notes.is_empty(), "{:?}", last.notes);
    for state in ["step 1, increment 4, time 1", "step 2, increment 3, time 1.7", "step 2, increment 5, time 2"] {
        assert!(last.answer.read.contains(&format!("block CONTACT of {state}")), "{:?}", last.answer.read);
    }
    for first in [at(Asked { time: Some(1.0), ..usual() }), at(Asked { step: Some(1), ..usual() })] {
        assert_relative_eq!(first.ruled[0].measures.peak.pressure, 0.5 * RIGHT.peak(), max_relative = 2e-3);
        assert!(!first.met() && says(&first, "its file goes on to time 2"), "{:?}", first.notes);
    }
    let within = at(Asked { time: Some(1.7), step: Some(2), ..usual() });
    assert_relative_eq!(within.ruled[0].measures.peak.pressure, 0.8 * RIGHT.peak(), max_relative = 2e-3);
    assert!(says(&within, "time 1.7, which is not the end of a step"));
    refused("theirs.frd", two.text(), &Asked { time: Some(3.0), ..usual() }, &["--time or --step", "time 1.7"]);
    for asked in [Asked { step: Some(1), ..usual() }, Asked { time: Some(1.0), ..usual() }] {
        refused("theirs.csv", ellipse::text(), &asked, &["it has one state"]);
        let grid = vtk::plain();
        refused("theirs.vtk", grid, &asked, &["it has one state"]);
    }
}

#[test]
fn a_contact_that_is_there_in_part_is_not_judged_and_what_is_dropped_is_said() {
    // Beyond s the ellipse has 1 − 2/π (asin s/a + s/a √(1 − s²/a²)) of its force.
    let within = |from: f64, to: f64| {
        let places = (-30..=30).map(|k| 0.1 * f64::from(k)).filter(|s| from - 1e-9 <= *s && *s <= to + 1e-9);
        rows(places)
    };
    for (from, to, parts) in [
        (0.0, 1.0, ["stop at 1", "39.1 % of the force"]),
        (0.0, 1.8, ["stop at 1.8", "3.7 % of the force"]),
        (0.6, 3.0, ["stop at 0.6", "37.6 % of the force"]),
        (-0.6, 3.0, ["stop at -0.6", "31.2 % of the force"]),
    ] {
        refused("theirs.csv", within(from, to), &Asked::default(), &parts);
    }
    for (from, to) in [(0.0, 2.0), (-2.0, 2.0), (-3.0, 3.0)] {
        judged(parsed("theirs.csv", within(from, to), &Asked::default()).expect("read")).expect("judged");
    }
}

/// Rows of the ellipse at some places.
fn rows(places: impl IntoIterator<Item = f64>) -> String {
    table(PRESSURES, places.into_iter().map(|s| [s, ellipse::pressure(s.abs())]))
}

#[test]
fn a_table_with_holes_is_not_judged_and_the_widest_is_named_with_the_force_in_it_wherever_it_is() {
    let even = |from: i32, step: f64| (from..=60).map(move |k| step * f64::from(k));
    let without = |from: i32, holes: &[[f64; 2]]| {
        let kept: Vec<f64> = even(from, 0.05)
            .filter(|s| !holes.iter().any(|[begin, end]| begin - 1e-9 < *s && *s < end + 1e-9))
            .collect();
        rows(kept)
    };
    // Between s₁ and s₂ the ellipse has (F(s₂) − F(s₁))/F(a) of its force, F = asin s/a + s/a √(1 − s²/a²), where a = 2
    // mm.
    for (from, hole, parts) in [
        // In the middle of a half, at its peak, beside its end.
        (0, [0.5, 1.1], ["no point from 0.4500 to 1.150 mm", "14 times", "40.5 % of the force"]),
        (0, [0.05, 0.6], ["no point from 0 to 0.6500 mm", "13 times", "40.6 % of the force"]),
        (0, [1.3, 1.9], ["no point from 1.250 to 1.950 mm", "14 times", "25.5 % of the force"]),
        // Of one side alone, and over the peak.
        (-60, [0.05, 0.6], ["no point from 0 to 0.6500 mm", "13 times", "20.3 % of the force"]),
        (-60, [-0.3, 0.3], ["no point from -0.3500 to 0.3500 mm", "14 times", "22.2 % of the force"]),
    ] {
        let said = refused("theirs.csv", without(from, &[hole]), &Asked::default(), &parts);
        assert!(!said.contains("more like it"), "{said}");
    }
    // Four points in a row of a coarse table, also far from x = 0.
    for (hole, parts) in [
        (0.5..1.3, ["no point from 0.4000 to 1.400 mm", "5 times", "55.9 % of the force"]),
        (0.9..1.7, ["no point from 0.8000 to 1.800 mm", "5 times", "46.7 % of the force"]),
    ] {
        let coarse = even(0, 0.2).filter(|s| *s <= 3.0 && !hole.contains(s));
        refused("theirs.csv", rows(coarse), &Asked::default(), &parts);
    }
    // With a point left in it, and two of which the second is the wider one.
    for (holes, part) in [
        ([[0.5, 0.75], [0.85, 1.1]], "7 times as far apart"),
        ([[0.5, 0.7], [0.85, 1.1]], "no point from 0.8000 to 1.150 mm"),
    ] {
        refused("theirs.csv", without(0, &holes), &Asked::default(), &["7 times", part, "and in 1 more like it"]);
    }
    // Even tables that are coarse, graded to the middle or to the end, with pairs of points, with a small hole or one
    // beyond the contact.
    let graded = |ratio: f64, to: f64| {
        let step = |k: i32| 0.02 * ratio.powi(k);
        let places: Vec<f64> = (0..).map(|k| (0..k).map(step).sum::<f64>()).take_while(|s| *s < to).collect();
        places
    };
    let pairs = || even(0, 0.1).flat_map(|s| [s, s + 1e-3]).take_while(|s| *s < 3.0);
    for (name, table) in [
        ("coarse", rows(even(-20, 0.25).filter(|s| *s <= 3.0))),
        ("from the middle", rows(graded(1.5, 3.0))),
        ("steeply from the middle", rows(graded(1.8, 3.0))),
        ("to the end", rows(graded(1.6, 2.1).into_iter().map(|s| 2.1 - s).chain([0.0, 2.3, 2.5]))),
        ("pairs", rows(pairs())),
        ("a small hole", without(0, &[[1.0, 1.05]])),
        ("beyond", without(0, &[[2.1, 2.9]])),
    ] {
        let answer = parsed("theirs.csv", table, &Asked::default()).expect(name);
        judged(answer).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn a_unit_that_is_named_against_the_one_of_the_file_is_refused() {
    let text = rows((0..ellipse::NODES).map(ellipse::place));
    let units = text.replace("position [mm],pressure [MPa]", "position,pressure\nmm,MPa");
    for (units, parts) in [
        (&[(Role::Pressure, "Pa")][..], ["`pressure [MPa]`", "is in MPa by the file, but in Pa by --unit pressure=Pa"]),
        (&[(Role::Position, "m")], ["`position [mm]`", "is in mm by the file, but in m by --unit position=m"]),
        // Both are 1 of ours.
        (&[(Role::Position, "rad")], ["`position [mm]`", "leave out --unit position=rad"]),
    ] {
        refused("theirs.csv", &text, &in_units(units), &parts);
    }
    refused(
        "theirs.csv",
        units,
        &in_units(&[(Role::Pressure, "Pa")]),
        &["`pressure [MPa]`", "leave out --unit pressure=Pa"],
    );
    let document =
        r#"{"units":{"position":"mm","pressure":"MPa"},"contacts":[{"position":[0,1,2,3],"pressure":[100,86.6,0,0]}]}"#;
    let parts = ["`contacts[0].pressure`", "is in MPa by the file, but in Pa by --unit pressure=Pa"];
    refused("theirs.json", document, &in_units(&[(Role::Pressure, "Pa")]), &parts);
    let field = vtk::plain().replace("contact_pressure", "CPRESS[kPa]");
    let asked = Asked { columns: vec![(Role::Pressure, "CPRESS[kPa]".into())], ..usual() };
    refused("theirs.vtk", field, &asked, &["`CPRESS[kPa]`", "is in kPa by the file"]);
    // Two names of one unit, and what is no unit.
    for (text, units) in [
        (text.clone(), [(Role::Position, "mm"), (Role::Pressure, "N/mm2")]),
        (text.replace("[MPa]", "(nodal)"), [(Role::Position, "mm"), (Role::Pressure, "MPa")]),
    ] {
        ellipse::assert(&parsed("theirs.csv", text, &in_units(&units)).expect("read"), 1e-9);
    }
}

#[test]
fn a_mesh_that_lies_partly_off_the_path_is_not_judged_and_its_unit_is_questioned() {
    let warped = vtk::points(&|x, y| if y == 0.0 && (0.7..1.5).contains(&x) { [x, 0.02] } else { [x, y] });
    refused("theirs.vtk", warped, &usual(), &["of the edges that are pressed lie off", "undeformed", "% of the force"]);
    let warped = Frd { warp: 0.03, ..Frd::plain() };
    refused("theirs.frd", warped.text(), &usual(), &["of the edges that are pressed lie off"]);
    // Metres called mm: on a straight side a usual mistake, on a circle no side at all.
    let metres = vtk::points(&|x, y| [1e-3 * x, 1e-3 * y]);
    let found = judged(parsed("theirs.vtk", metres, &usual()).expect("read")).expect("judged");
    assert!(found.mistakes.iter().any(|says| says.contains("positions in m are called mm")), "{:?}", found.mistakes);
    for name in ["cylinder", "pin-rod"] {
        let case = find(name, None).expect("a case");
        let (meshed, run) = case.solve().expect("solved");
        let text = vtu::text(&meshed.discretisation, &run).expect("written");
        for (unit, factor) in [("m", "0.001"), ("um", "1000")] {
            let mut asked = usual();
            asked.units[0].1 = unit.into();
            let parts = [&format!("times {factor}"), "it would lie there"];
            workbench::refused(read(&case, "ours.vtu", &text, &asked), &parts);
        }
    }
    let far = refused("theirs.vtk", vtk::points(&|x, y| [x, y + 7.0]), &usual(), &["y = 7.0000 to 7.5000 mm"]);
    // A grid elsewhere is not one in another unit.
    assert!(!far.contains("times"), "{far}");
    let beside = refused("theirs.vtk", vtk::points(&|x, y| [x + 7.0, y]), &usual(), &["x = 7.0000 to"]);
    assert!(!beside.contains("times"), "{beside}");
    let far = Frd { below: 7.0, ..Frd::plain() }.text();
    refused("theirs.frd", far, &usual(), &["its points lie at x = 0.0000 to 4.8000"]);
}

#[test]
fn of_a_collection_the_last_grid_is_judged_or_that_of_a_time() {
    let folder = Folder::made();
    let case = find("cylinder", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let text = vtu::text(&meshed.discretisation, &run).expect("written");
    folder.with("last.vtu", &text);
    let entry =
        |time: &str, file: &str| format!("<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{file}\"/>\n");
    let whole = |entries: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" \
            version=\"0.1\">\n<Collection>\n{entries}</Collection>\n</VTKFile>\n"
        )
    };
    let file = folder.path().join("series.pvd");
    let read = |entries: &str, asked: &Asked| read::parse(&file, whole(entries).as_bytes(), &case, asked);
    let refused = |entries: &str, asked: &Asked, parts: [&str; 2]| workbench::refused(read(entries, asked), &parts);
    let series = entry("0.5", "first.vtu") + &entry("1", "last.vtu");
    // What is commented out is none of them.
    let commented = format!("{series}<!-- {}{} -->\n", entry("2", "other.vtu"), entry("1", "part.vtu"));
    let at = |time: f64| Asked { time: Some(time), ..usual() };
    let own = read::parse(&folder.path().join("last.vtu"), text.as_bytes(), &case, &usual()).expect("read");
    for (entries, asked) in [
        (series.clone(), usual()),
        (series.clone(), at(1.0)),
        (series.replace("timestep", "time"), usual()),
        // The largest time counts, whatever its place.
        (entry("1", "last.vtu") + &entry("0.5", "first.vtu"), usual()),
        (commented, usual()),
    ] {
        let answer = read(&entries, &asked).unwrap_or_else(|error| panic!("{error}"));
        let [found, wanted] =
            [&answer, &own].map(|one| one.contacts[0].points.iter().map(|point| point.value).collect::<Vec<_>>());
        assert_eq!(found, wanted);
        assert!(answer.read.iter().any(|line| line.contains("last.vtu of time")), "{:?}", answer.read);
        assert!(answer.notes.is_empty() || entries.contains(" time="), "{:?}", answer.notes);
    }
    // A grid in pieces that has one, by itself and in a collection.
    let pieces = |all: &str| {
        format!("<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>{all}</PUnstructuredGrid></VTKFile>")
    };
    let whole_grid = folder.with("whole.pvtu", pieces("<Piece Source=\"last.vtu\"/>"));
    let whole_grid = Path::new(&whole_grid);
    for answer in [read::read(whole_grid, &case, &usual()), read(&entry("1", "whole.pvtu"), &usual())] {
        let points = &answer.unwrap_or_else(|error| panic!("{error}")).contacts[0].points;
        assert_eq!(*points, own.contacts[0].points);
    }
    for several in ["<Piece Source=\"last.vtu\"/>".repeat(2), "<Piece Source=\"whole.pvtu\"/>".into()] {
        folder.with("whole.pvtu", pieces(&several));
        workbench::refused(read::read(whole_grid, &case, &usual()), &["no unstructured grid in one file", "ParaView"]);
    }
    let early = read(&(series.clone() + &entry("2", "other.vtu")), &at(1.0)).expect("read");
    assert!(early.notes.iter().any(|note| note.contains("goes on to time 2")), "{:?}", early.notes);
    refused(&series, &at(0.5), ["first.vtu` of this grid is missing", "series.pvd:4"]);
    refused(&series, &at(0.7), ["no results of the time", "time 0.5; time 1"]);
    refused(&(series.clone() + &entry("1", "part.vtu")), &usual(), ["2 files of time 1", "one .vtu"]);
    refused(&entry("1", "series.pvd"), &usual(), ["another collection", ".vtu"]);
    refused(&entry("1", "series.pvd.gz"), &usual(), ["another collection", ".vtu"]);
    // Times may be short.
    let short = entry("1e-6", "last.vtu") + &entry("2e-6", "first.vtu");
    assert!(read(&short, &at(1e-6)).expect("read").notes.iter().any(|note| note.contains("goes on to")));
    refused(&short, &usual(), ["first.vtu", "missing"]);
    refused("", &usual(), ["names no grid", ".vtu"]);
    for time in ["one", "nan", "inf"] {
        refused(&entry(time, "last.vtu"), &usual(), ["series.pvd:4", "no number"]);
    }
    refused("<DataSet timestep=\"1\"/>", &usual(), ["series.pvd:4", "has no file"]);
}

/// The row of a quantity.
fn row(found: &Verdicts, asked: &Asks) -> Judged {
    found.ruled[0].judged.iter().find(|one| one.check.quantity == *asked).expect("judged").clone()
}

#[test]
fn a_resultant_without_a_load_is_that_of_one_solve_with_its_bar() {
    let text = std::fs::read_to_string(folder().join("2_displacement_driven.toml")).expect("a scene");
    let rows = std::fs::read_to_string(folder().join("2_answer.csv")).expect("an answer");
    let driven = |elements: &str| {
        Case::parse(&folder().join("driven.toml"), &text.replace("elements = 3", elements)).expect("read")
    };
    let mut found = Vec::new();
    for elements in ["elements = 3", "elements = 5"] {
        let truth = Truth::of(driven(elements)).expect("solved");
        assert!(!truth.is_told_by_loads(0));
        let judged = judged_as(&truth, "a.csv", &rows, &Asked::default());
        let reference = row(&judged, &Quantity::Resultant.into()).reference;
        assert_ne!(reference.name, "equilibrium with the load");
        found.push((reference.value, truth.ours(0, &Quantity::Resultant).bar));
    }
    let files = contact_vv::cli::export::files(&driven("elements = 3"), false).expect("exported");
    let sheet = std::str::from_utf8(&files[0].1).expect("text");
    let line = sheet.lines().find(|line| line.contains("| resultant")).expect("a resultant");
    assert!(line.contains("66.8656"), "{line}");
    for (value, bar) in &found {
        assert!((value - 66.86566).abs() <= 1e-4 && *bar <= 1e-3, "{value} ± {bar}");
    }
    assert!((found[0].0 - found[1].0).abs() <= found[0].1 + found[1].1, "{found:?}");
    let loaded = judged(parsed("a.csv", ellipse::text(), &Asked::default()).expect("read")).expect("judged");
    assert_eq!(row(&loaded, &Quantity::Resultant.into()).reference.name, "equilibrium with the load");
}

#[test]
fn loads_tell_the_force_of_a_contact_where_its_body_is_free_along_them_and_its_other_contacts_are_told() {
    let cases = root().join("tests/cases");
    let told = |file: &str, wanted: &[bool]| {
        let truth = Truth::of(Case::read(&cases.join(file)).expect("a case")).expect("solved");
        let found: Vec<bool> = (0..wanted.len()).map(|contact| truth.is_told_by_loads(contact)).collect();
        assert_eq!(found, wanted, "{file}");
    };
    assert!(TRUTH.is_told_by_loads(0));
    // From the upper plate to the roller and on to the lower one; not of a plate on two supports, nor of rings that
    // press each other.
    told("roller-between-plates.toml", &[true, true]);
    told("plate-on-two-supports.toml", &[false, false]);
    told("press-fit.toml", &[false]);
}

/// The scene `tiny` with a check of its own.
fn with_check(check: &str) -> Truth {
    let text = std::fs::read_to_string(folder().join("tiny.toml")).expect("a scene");
    let text = format!("{text}\n[[check]]\nbecause = \".\"\n{check}");
    Truth::of(Case::parse(&folder().join("stated.toml"), &text).expect("read")).expect("solved")
}

#[test]
fn a_stated_model_error_counts_for_every_quantity_it_is_stated_for() {
    for (quantity, asked) in [
        ("resultant", Quantity::Resultant),
        ("peak-pressure", Quantity::PeakPressure),
        ("half-width", Quantity::HalfWidth),
        ("contact-half-width", Quantity::HalfWidth),
        ("second-moment-width", Quantity::SecondMomentWidth),
    ] {
        let truth = with_check(&format!("quantity = \"{quantity}\"\ntolerance = 0.5\nmodel-error = 0.07\n"));
        assert_relative_eq!(truth.model(&asked), 0.07);
        let known = truth.known(0, &asked);
        assert_relative_eq!(known.bar, 0.07 * known.reference.value, max_relative = 1e-12);
    }
    // Of the pressure at the middle, where a peak has no limit.
    let stated = "[[check]]\nquantity = \"pressure\"\nat = 0\ntolerance = 0.5\nmodel-error = 0.05\nbecause = \".\"\n";
    let truth = Truth::of(workbench::parsed(&(text_of("flat-punch.toml") + stated))).expect("solved");
    let rows = (0..=20).map(|k| 0.05 * f64::from(k)).map(|s| [s, truth.pressure(0, s.min(0.98))]);
    let found = judged_rows(&truth, PRESSURES, rows);
    let middle = Quantity::Pressure { at: 0.0 };
    let judged = found.ruled[0].judged.iter().find(|one| one.check.quantity.number() == Some(&middle));
    assert_relative_eq!(judged.expect("judged").check.tolerance, ENGINEERING + 0.05, max_relative = 1e-9);
}

#[test]
fn declared_check_asks_no_more_than_its_model_error_leaves_and_the_tolerance_asked_for() {
    // Off Hertz everywhere by so much; the tolerance, what the check states, and whether it is met.
    for (off, tolerance, stated, met) in [
        (1.012, ENGINEERING, "", false),
        (1.012, ENGINEERING, "model-error = 0.02\n", true),
        (1.005, ENGINEERING, "", true),
        (1.005, 1e-3, "", false),
        (1.03, 0.05, "", true),
    ] {
        let rows = (0..=44).map(|k| 0.05 * f64::from(k)).map(|x| [x, off * RIGHT.pressure(x)]);
        for (quantity, number) in [
            ("quantity = \"peak-pressure\"", Quantity::PeakPressure),
            ("quantity = \"pressure\"\nat = 0.8", Quantity::Pressure { at: 0.8 }),
            ("quantity = \"resultant\"", Quantity::Resultant),
        ] {
            let truth = with_check(&format!("{quantity}\ntolerance = 1e-3\n{stated}"));
            let answer = read(&truth.case, "theirs.csv", table(PRESSURES, rows.clone()), &usual()).expect("read");
            let found = verdicts(&truth, answer, tolerance).expect("judged");
            let mut declared = found.ruled[0].judged.iter().rev();
            let last = declared.find(|one| one.check.quantity.number() == Some(&number)).expect("declared");
            let is_met = last.verdict == contact_vv::case::Verdict::Pass;
            assert_eq!(is_met, met, "{off}, {tolerance}, {stated}: {last:?}");
        }
    }
}

#[test]
fn declared_widths_are_read_of_straight_lines_as_those_above_them() {
    // Ten points on the half-width: 0.9 % by straight lines, next to nothing by roots.
    let truth = with_check("quantity = \"second-moment-width\"\ntolerance = 1e-3\n");
    let rows = (0..=12).map(|k| 0.2 * f64::from(k)).map(|x| [x, RIGHT.pressure(x)]);
    let answer = read(&truth.case, "theirs.csv", table(PRESSURES, rows), &usual()).expect("read");
    let found = verdicts(&truth, answer, 2e-3).expect("judged");
    assert_eq!(failed(&found), [""; 0]);
}

/// A cylinder on a plane, without a closed form, on a mesh of so few elements that our own run tells no bar of its
/// peak, or one of a part of it.
fn coarse(elements: usize) -> Truth {
    let text = format!(
        "title = \"cylinder on a rigid plane\"\nplane = \"strain\"\nthickness = 1\n[[body]]\nname = \
        \"cylinder\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ disc = {{ centre = [0, 50], radius = 50 }} }}\nsupports = [{{ at = \"axis\", component = \"x\" \
         }}]\n\
         loads = [{{ traction = {{ at = \"cut\", value = [0, -23] }} }}]\n[contact]\nfirst = \"cylinder\"\ngap = {{ \
         circle = 50 }}\nstretch = 5\n\
         [mesh]\nelements = {elements}\nper = 2.5\n"
    );
    Truth::of(workbench::parsed(&text)).expect("solved")
}

/// Where a mesh can be fitted to the contact, its peak and its profile are known however coarse the mesh of the scene
/// is.
#[test]
fn profiles_are_held_against_the_mesh_fitted_to_the_contact() {
    // a = √(4 P R/(π E*)), p₀ = 2P/(πa).
    let half_width = (4.0 * 2300.0 * 50.0 / (std::f64::consts::PI * 210e3 / 0.91)).sqrt();
    let peak = 2.0 * 2300.0 / (std::f64::consts::PI * half_width);
    let places = || (0..=160).map(|k| 0.01 * f64::from(k));
    let hertz = |s: f64| peak * (1.0 - (s / half_width).powi(2)).max(0.0).sqrt();
    // Of the same force and second moment.
    let wider = 0.5 * 5f64.sqrt() * half_width;
    let parabola = |s: f64| 0.75 * 2300.0 / wider * (1.0 - (s / wider).powi(2)).max(0.0);
    for truth in [2, 4].map(coarse) {
        assert_eq!(failed(&judged_rows(&truth, PRESSURES, places().map(|s| [s, hertz(s)]))), [""; 0]);
        let wrong = failed(&judged_rows(&truth, PRESSURES, places().map(|s| [s, parabola(s)])));
        assert!(wrong.iter().any(|one| one.starts_with("peak pressure")), "{wrong:?}");
    }
}

#[test]
fn the_formula_of_a_sphere_used_for_a_cylinder_is_a_usual_mistake() {
    // a₃ = ∛(3FR/4E*) and 3F/2πa²: 314.1593 N on R = 1000 mm, E* = 100 GPa.
    let Hertz { force, radius, modulus, .. } = RIGHT;
    for a in [(0.75 * force * radius / modulus).cbrt(), RIGHT.half_width()] {
        let p = 1.5 * force / (std::f64::consts::PI * a * a);
        let at = |k: u32| [0.05 * f64::from(k) * a, p * (1.0 - (0.05 * f64::from(k)).powi(2)).max(0.0).sqrt()];
        let found = judged_rows(&TRUTH, PRESSURES, (0..=26).map(at));
        assert!(
            !found.met() && found.mistakes.iter().any(|says| says.contains("that of a sphere")),
            "{a}: {:?}",
            found.mistakes
        );
    }
}

/// A grid of one row of quadrilaterals of VTK's type 70, of order 2 or 3, with the pressures of the ellipse on y = 0.
fn lagrange(order: usize) -> String {
    let places: &[[usize; 2]] = match order {
        2 => &[[0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1], [1, 1]],
        _ => &[
            [0, 0],
            [3, 0],
            [3, 3],
            [0, 3],
            [1, 0],
            [2, 0],
            [3, 1],
            [3, 2],
            [1, 3],
            [2, 3],
            [0, 1],
            [0, 2],
            [1, 1],
            [2, 1],
            [1, 2],
            [2, 2],
        ],
    };
    let columns = ellipse::NODES / order * order;
    let point = |k: usize| [ellipse::place(k / (order + 1)), 0.2 * (k % (order + 1)) as f64];
    let count = (columns + 1) * (order + 1);
    let points: String = (0..count).map(point).map(|[x, y]| format!("{x} {y} 0\n")).collect();
    let cell = |k: usize| {
        let nodes = places.iter().map(|[i, j]| ((order * k + i) * (order + 1) + j).to_string());
        format!("{} {}\n", places.len(), nodes.collect::<Vec<_>>().join(" "))
    };
    let (cells, size) = (columns / order, places.len() + 1);
    let pressure = |[x, y]: [f64; 2]| if y > 0.0 { 0.0 } else { ellipse::pressure(x) };
    let pressures: String = (0..count).map(|k| format!("{}\n", pressure(point(k)))).collect();
    format!(
        "# vtk DataFile Version 3.0\n-\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {count} double\n{points}CELLS {cells} \
        {}\n{}CELL_TYPES {cells}\n{}\
         POINT_DATA {count}\nSCALARS contact_pressure double 1\nLOOKUP_TABLE default\n{pressures}",
        cells * size,
        (0..cells).map(cell).collect::<String>(),
        "70\n".repeat(cells)
    )
}

#[test]
fn cells_of_any_order_are_read_and_so_is_what_we_write_of_fitted_meshes() {
    for order in [2, 3] {
        let answer = parsed("theirs.vtk", lagrange(order), &usual()).unwrap_or_else(|error| panic!("{error}"));
        ellipse::assert(&answer, 1e-9);
        assert!(judged(answer).expect("judged").met(), "{order}");
    }
    let curved = lagrange(2).replace("70\n", "71\n");
    refused("theirs.vtk", curved, &usual(), &["VTK's type 71", "5, 22, 9, 23, 28 and 70"]);
    let folder = Folder::made();
    let (scene, fields) = (self::folder().join("tiny.toml").display().to_string(), folder.at("ours.vtu"));
    let (solved, _, error) = contact_vv(&["solve", &scene, "--fitted", "--vtu", &fields]);
    assert!(solved && folder.read("ours.vtu").contains("70"), "{error}");
    let (met, text, error) = contact_vv(&[&["judge", &scene, &fields][..], &UNITS].concat());
    assert!(met, "{text}{error}");
}

#[test]
fn pressures_that_alternate_from_point_to_point_are_no_answer() {
    // The means over edges of either order stay what they are: of parabolas (c + 4 m + c)/6.
    for (order, [corner, middle]) in [(Order::Linear, [1.0, -1.0]), (Order::Quadratic, [-2.0, 1.0])] {
        let failed = |share: f64| {
            let row = |k: i32| {
                let s = 3.0 * f64::from(k) / 120.0;
                let turn = 1.0 + share * if k % 2 == 0 { corner } else { middle };
                [s, 100.0 * turn * (1.0 - s * s / 4.0).max(0.0).sqrt()]
            };
            let asked = Asked { order: Some(order), ..usual() };
            failed(&judged_as(&TRUTH, "turns.csv", &table(PRESSURES, (0..=120).map(row)), &asked))
        };
        assert_eq!(failed(0.0), Vec::<String>::new());
        assert_eq!(failed(0.05), Vec::<String>::new());
        for share in [0.3, -0.3] {
            let named = failed(share);
            assert!(
                named[0] == "alternation of the pressures from point to point over the peak",
                "{order:?}: {named:?}"
            );
        }
    }
}

#[test]
fn one_point_that_departs_from_those_beside_it_is_named() {
    // 100 MPa over 2 mm, by 161 points of which one is off, and by 41 with a corner and a mid-side by turns.
    let failed = |off: &dyn Fn(i32) -> f64, step: f64, order: Order| {
        let row = |k: i32| {
            let s = step * f64::from(k);
            [s, off(k) * 100.0 * (1.0 - s * s / 4.0).max(0.0).sqrt()]
        };
        let last = (3.0 / step).round() as i32;
        let asked = Asked { order: Some(order), ..usual() };
        failed(&judged_as(&TRUTH, "one.csv", &table(PRESSURES, (0..=last).map(row)), &asked))
    };
    let alone = |at: i32, by: f64| failed(&|k| if k == at { by } else { 1.0 }, 0.0125, Order::Linear);
    // √(1 − 0.25), and √(1 − 0.81).
    for (at, by, said) in [
        (0, 1.15, "at 0 mm: 115.0 for 100.0 MPa"),
        (80, 1.15, "at 1.000 mm: 99.59 for 86.60 MPa"),
        (80, 0.85, "at 1.000 mm: 73.61 for 86.60 MPa"),
        (144, 1.5, "at 1.800 mm: 65.38 for 43.59 MPa"),
    ] {
        let named = alone(at, by);
        assert!(named.iter().any(|one| one.contains(said)), "{at}: {named:?}");
    }
    assert_eq!(alone(80, 1.03), Vec::<String>::new());
    let corners = |by: f64| failed(&|k| if k % 2 == 0 { 1.0 - 2.0 * by } else { 1.0 + by }, 0.05, Order::Quadratic);
    assert_eq!(corners(0.04), Vec::<String>::new());
}

#[test]
fn points_off_the_side_and_pressures_that_begin_behind_the_middle_are_refused() {
    let along = |head: &str, from: usize, y: &dyn Fn(f64) -> f64| {
        let row = |s: f64| format!("{s},{},{}\n", y(s), ellipse::pressure(s));
        format!("{head}\n{}", (from..ellipse::NODES).map(ellipse::place).map(row).collect::<String>())
    };
    let table = |head: &str, from: usize, y: f64| along(head, from, &|_| y);
    let plain = |head: &str, y: f64| table(head, 0, y);
    let head = "x [mm],y [mm],pressure [MPa]";
    // The other side lies off by the gap s²/2R, beside which a twentieth of the stretch of 4.8 mm is near.
    for (near, is_taken) in [(0.239, true), (0.241, false)] {
        let other = along(head, 0, &|s| 0.0 - near - s * s / 2000.0);
        assert_eq!(parsed("sides.csv", other, &usual()).is_ok(), is_taken, "{near}");
    }
    assert!(judged(parsed("sides.csv", plain(head, 0.0), &usual()).expect("read")).expect("judged").met());
    refused("sides.csv", plain(head, -0.3), &usual(), &["0.300 mm off the side", "leave the column out"]);
    // r and z are places of bodies of revolution alone.
    refused(
        "sides.csv",
        plain("r [mm],z [mm],pressure [MPa]", 0.0),
        &usual(),
        &["no column is called `position` or `x`"],
    );
    // A y without a unit has that of x.
    refused("sides.csv", plain("x [mm],y,pressure [MPa]", -0.3), &Asked::default(), &["0.300 mm off the side"]);
    let of_x = in_units(&[(Role::X, "mm"), (Role::Pressure, "MPa")]);
    refused("sides.csv", plain("Points:0,Points:1,CPRESS", 0.3), &of_x, &["`Points:1, in mm`, lies 0.300 mm off"]);
    let quadratic = Asked { order: Some(Order::Quadratic), ..usual() };
    assert!(judged(parsed("sides.csv", table(head, 0, 0.0), &quadratic).expect("read")).expect("judged").met());
    refused("sides.csv", table(head, 2, 0.0), &quadratic, &["stop at 0.2", "of the force lies beyond"]);
}

#[test]
fn a_check_of_a_scene_that_names_no_kind_is_asked_of_answers_too() {
    let with = |peak: f64| {
        let truth = with_check(&format!("quantity = \"peak-pressure\"\nvalue = {peak}\ntolerance = 0.01\n"));
        judged_as(&truth, "theirs.csv", &ellipse::text(), &usual()).met()
    };
    assert!(with(RIGHT.peak()) && !with(1.02 * RIGHT.peak()));
}
