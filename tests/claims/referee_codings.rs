//! Files as other programs code, name and cut them: letters of Windows and of old Macs, what VTK and COMSOL write
//! beside numbers, left halves.

use approx::assert_relative_eq;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, verdicts};
use serde_json::json;

use crate::ellipse;
use crate::foreign::{Frd, vtk, vtu};
use crate::handed::{PRESSURES, document, failed, table};
use crate::referee_wild::{TRUTH, judged, parsed, refused, usual};
use crate::workbench::refused as refused_as;

fn read(name: &str, text: impl AsRef<[u8]>) -> Answer {
    parsed(name, text, &usual()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn texts_are_read_as_windows_and_old_macs_code_them_and_what_is_no_text_is_refused() {
    let text = ellipse::text().replace("[MPa]", "[N/mm²]");
    let words = |of: fn(u16) -> [u8; 2]| format!("\u{feff}{text}").encode_utf16().flat_map(of).collect::<Vec<u8>>();
    let latin: Vec<u8> = text.chars().map(|letter| u8::try_from(u32::from(letter)).expect("a letter")).collect();
    for bytes in [words(u16::to_le_bytes), words(u16::to_be_bytes), latin, text.replace('\n', "\r").into_bytes()] {
        ellipse::assert(&read("theirs.csv", bytes), 1e-5);
    }
    let named = Frd::plain().text().replacen("    1C", "    1UUSER  J\u{fc}rgen\n    1C", 1);
    let latin: Vec<u8> = named.chars().map(|letter| u8::try_from(u32::from(letter)).expect("a letter")).collect();
    ellipse::assert(&read("theirs.frd", latin), 1e-4);
    for bytes in [&b"PK\x03\x04\x14\x00\xb2"[..], b"\xff\xfe\x00\xd8", b"\x89HDF\r\n\x1a\n"] {
        refused("theirs.csv", bytes, &usual(), &["it is no text", "UTF-8"]);
    }
}

/// A grid of two rows of nodes.
fn grid(place: impl Fn(f64, f64) -> [f64; 3], pressure: impl Fn(f64) -> String) -> String {
    let nodes = || (0..2 * ellipse::NODES).map(|k| (ellipse::place(k % ellipse::NODES), (k / ellipse::NODES) as f64));
    let points: Vec<[f64; 3]> = nodes().map(|(x, y)| place(x, y)).collect();
    let cell = |k: usize| vec![k, k + 1, k + 1 + ellipse::NODES, k + ellipse::NODES];
    let cells: Vec<Vec<usize>> = (0..ellipse::NODES - 1).map(cell).collect();
    // Far from the contact nothing presses.
    let pressures: Vec<String> = nodes().map(|(x, y)| pressure(if y > 0.0 { 2.1 } else { x })).collect();
    vtu::text(&points, &cells, &vtu::array("Float64", "contact_pressure", 1, &pressures.join(" ")))
}

fn written(s: f64) -> String {
    ellipse::pressure(s).to_string()
}

#[test]
fn what_vtk_knows_of_an_array_is_none_of_its_numbers_and_text_is_compressed_by_nothing() {
    let text = grid(|x, y| [x, y, 0.0], written);
    // Nor have numbers that are written out an order of bytes.
    for text in [text.replace("LittleEndian", "BigEndian"), text] {
        ellipse::assert(&read("theirs.vtu", text), 1e-9);
    }
}

#[test]
fn nodes_beyond_the_contact_may_have_no_number_in_grids_as_in_files_of_calculix() {
    let beyond = |s: f64| if s > 2.15 { "nan".into() } else { written(s) };
    let answer = read("theirs.vtu", grid(|x, y| [x, y, 0.0], beyond));
    assert_eq!(answer.contacts[0].points.len(), 22);
    assert!(judged(answer).expect("judged").met());
    let within = |s: f64| if s > 1.55 { "nan".into() } else { written(s) };
    // Where the last one is pressed they are beyond what is handed in, as in a table that ends there: as far as the
    // contact does.
    let found = judged(read("theirs.vtu", grid(|x, y| [x, y, 0.0], within)));
    // √(1 − 0.75²) of the largest, and 1 − (2/π)(asin 0.75 + 0.75 √(1 − 0.75²)) of the force.
    refused_as(found, &["stop at 1.5", "with 66 % of the largest, and 14.4 % of the force lies beyond"]);
    let active = |s: f64| if s > 1.95 { "nan".into() } else { written(s) };
    let listed = table(PRESSURES, (0..20).map(ellipse::place).map(|s| [s, ellipse::pressure(s)]));
    let pressed = Frd { listed: (0..20).collect(), ..Frd::plain() };
    let answers = [
        read("theirs.csv", listed),
        read("theirs.vtu", grid(|x, y| [x, y, 0.0], active)),
        read("theirs.frd", pressed.text()),
    ];
    for answer in answers {
        let found = judged(answer).expect("judged");
        assert!(found.met(), "{:?}", failed(&found));
    }
    let between = |s: f64| if (0.55..0.65).contains(&s) { "nan".into() } else { written(s) };
    refused("theirs.vtu", grid(|x, y| [x, y, 0.0], between), &usual(), &["1 of the 49 nodes", "none is no zero"]);
    let at_line = |s: f64| if s < 0.05 { "nan".into() } else { written(s) };
    refused("theirs.vtu", grid(|x, y| [x, y, 0.0], at_line), &usual(), &["1 of the 49 nodes", "none is no zero"]);
    let infinite = |s: f64| if s > 2.15 { "inf".into() } else { written(s) };
    refused("theirs.vtu", grid(|x, y| [x, y, 0.0], infinite), &usual(), &["of the 49 nodes", "none is no zero"]);
}

#[test]
fn pixels_are_quadrilaterals_whose_corners_are_listed_row_by_row() {
    let legacy = vtk::ascii(&written);
    let (head, rest) = legacy.split_once("CONNECTIVITY vtktypeint64\n").expect("cells");
    let (cells, rest) = rest.split_once("CELL_TYPES").expect("types");
    let by_rows = |line: &str| {
        let [a, b, c, d] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        format!("{a} {b} {d} {c}\n")
    };
    let by_rows: String = cells.lines().map(by_rows).collect();
    let types = rest.replace("\n9\n", "\n8\n").replace("\n9\n", "\n8\n");
    let pixels = format!("{head}CONNECTIVITY vtktypeint64\n{by_rows}CELL_TYPES{types}");
    let mut asked = usual();
    asked.columns.push((Role::Displacement, "moved".into()));
    asked.units.push((Role::Displacement, "mm".into()));
    let cells = |text: &str| {
        let field = parsed("theirs.vtk", text, &asked).expect("read").field.expect("displacements");
        field.cells.into_iter().map(|cell| cell.nodes).collect::<Vec<_>>()
    };
    assert_eq!(cells(&pixels), cells(&legacy));
}

#[test]
fn components_of_a_stress_are_those_that_the_file_names() {
    for (names, row) in [
        (["XX", "XY", "XZ", "YY", "YZ", "ZZ"], [7, 5, 1, 0, 2, 3]),
        (["S11", "S12", "S13", "S22", "S23", "S33"], [7, 5, 1, 0, 2, 3]),
        (["SX", "SXY", "SXZ", "SY", "SYZ", "SZ"], [7, 5, 1, 0, 2, 3]),
        (["sigma_y", "sigma_x", "sigma_z", "tau_xy", "tau_yz", "tau_xz"], [0, 7, 3, 5, 2, 1]),
        (["22", "11", "33", "12", "23", "13"], [0, 7, 3, 5, 2, 1]),
        // Numbers are no names.
        (["0", "1", "2", "3", "4", "5"], [7, 0, 3, 5, 2, 1]),
        (["S_XX", "S_YY", "S_ZZ", "S_YZ", "S_XZ", "S_XY"], [7, 0, 3, 2, 1, 5]),
        // Without names the order is that of VTK.
        ([""; 6], [7, 0, 3, 5, 2, 1]),
    ] {
        let stress =
            |s: f64| row.map(|k| if k == 0 { (0.0 - ellipse::pressure(s)).to_string() } else { k.to_string() });
        let called: String = (0..6).map(|k| format!("ComponentName{k}=\"{}\" ", names[k])).collect();
        let head = format!("Name = \"stress\" NumberOfComponents=\"6\" {called}");
        let text = grid(|x, y| [x, y, 0.0], |s| stress(s).join(" "));
        let mut asked = usual();
        asked.units.push((Role::Stress, "MPa".into()));
        let answer = parsed("theirs.vtu", text.replace("Name=\"contact_pressure\"", &head), &asked).expect("read");
        ellipse::assert(&answer, 1e-9);
        let place = |own: i32| row.iter().position(|k| *k == own).expect("one").to_string();
        let said = format!("of which xx, yy and xy are {}, {} and {}", place(7), place(0), place(5));
        assert!(answer.read.iter().any(|how| how.contains(&said)), "{:?}", answer.read);
    }
}

#[test]
fn components_whose_names_are_not_known_are_not_taken_by_their_order() {
    let legacy = vtk::ascii(&written);
    let named = |names: &str| legacy.replace("METADATA\n", &format!("METADATA\nCOMPONENT_NAMES\n{names}"));
    let mut asked = Asked { columns: vec![(Role::Stress, "S".into())], ..usual() };
    asked.units.push((Role::Stress, "MPa".into()));
    let legacy = |names: &str| parsed("theirs.vtk", named(names).replace("contact_pressure", "other"), &asked);
    refused_as(legacy("a\nb\nc\nd\ne\nf\n"), &["which components of `S` are xx, yy and xy is not known: a, b, c"]);
    // The first number of every row is 7: as σ_yy, it is tension.
    let first = legacy("S22\nS11\nS33\nS12\nS23\nS13\n").expect("read");
    assert!(first.contacts[0].points.iter().all(|point| (point.value + 7.0).abs() <= 1e-9));
}

#[test]
fn what_stands_beside_the_numbers_of_a_grid_is_passed_over() {
    let legacy = vtk::ascii(&written);
    let count = 2 * ellipse::NODES;
    let title = "DATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\ntitle 1 2 string\nrun%205\n7\n";
    let mut titled = vtk::binary(true);
    let at = titled.windows(7).position(|window| window == b"\nPOINTS").expect("points");
    // Six letters behind their number, of which the two first bits say that it is one byte.
    titled.splice(at..at, b"\nFIELD FieldData 2\ntitle 1 1 string\n\xc6run\n 5\nids 1 2 vtkIdType\n".iter().copied());
    // Numbers of points and cells have four bytes each.
    let at = titled.windows(7).position(|window| window == b"\nPOINTS").expect("points");
    titled.splice(at..at, [0, 0, 0, 1, 0, 0, 0, 2]);
    ellipse::assert(&read("theirs.vtk", titled), 1e-5);
    for (head, what) in [
        ("DATASET UNSTRUCTURED_GRID\n", title.to_owned()),
        ("VECTORS", format!("TEXTURE_COORDINATES tc 2 float\n{}VECTORS", "0 1\n".repeat(count))),
        ("VECTORS", format!("COLOR_SCALARS rgb 3\n{}VECTORS", "0 0.5 1\n".repeat(count))),
    ] {
        ellipse::assert(&read("theirs.vtk", legacy.replacen(head, &what, 1)), 1e-5);
    }
    let fewer = legacy.replacen(&format!("POINT_DATA {count}"), &format!("POINT_DATA {}", count - 1), 1);
    refused("theirs.vtk", fewer, &usual(), &["it has data of 97 points, and 98 points"]);
    let plain = grid(|x, y| [x, y, 0.0], written);
    // Names with marks of XML, blanks around the sign, and cells of other kinds with the same corners.
    let named = plain.replace("Name=\"contact_pressure\"", "Name = 'p &amp; q'");
    let asked = Asked { columns: vec![(Role::Pressure, "p & q".into())], ..usual() };
    ellipse::assert(&parsed("theirs.vtu", named, &asked).expect("read"), 1e-9);
    let of_type = |kind: &str| legacy.replace("\n9\n", kind).replace("\n9\n", kind);
    ellipse::assert(&read("theirs.vtk", of_type("\n7\n")), 1e-5);
    refused("theirs.vtk", of_type("\n5\n"), &usual(), &["a cell of VTK's type 5 has 3 nodes, and one here has 4"]);
    refused("theirs.vtk", of_type("\n3\n"), &usual(), &["it has no plane cells", "or the points with their pressures"]);
    let vector = grid(|x, y| [x, y, 0.0], |s| format!("{} 0 0", written(s)));
    let vector = vector.replace("\"contact_pressure\"", "\"contact_pressure\" NumberOfComponents=\"3\"");
    refused("theirs.vtu", vector, &usual(), &["`contact_pressure` has 3 components, of which pressure is one"]);
}

#[test]
fn cells_upright_on_the_plane_of_the_scene_are_refused() {
    for place in [|x: f64, y: f64| [x, 0.0, y], |x: f64, y: f64| [0.0, x, y]] {
        refused("theirs.vtu", grid(place, written), &usual(), &["none of its 48 plane cells has an area in x and y"]);
    }
}

#[test]
fn the_left_half_of_a_symmetric_contact_is_judged_as_the_right_one() {
    let table = table(PRESSURES, (0..ellipse::NODES).map(ellipse::place).map(|s| [-s, ellipse::pressure(s)]));
    for (name, text) in [("theirs.csv", table), ("theirs.vtu", grid(|x, y| [0.0 - x, y, 0.0], written))] {
        let answer = read(name, text);
        ellipse::assert(&answer, 1e-9);
        let found = judged(answer).expect("judged");
        assert!(
            found.met() && found.answer.read.iter().any(|how| how.contains("left half")),
            "{:?}",
            found.answer.read
        );
    }
}

#[test]
fn pressures_that_are_missing_at_mid_sides_are_named() {
    let k = |s: f64| (10.0 * s).round() as usize;
    let zero = |s: f64| if k(s) % 2 == 1 { "0".into() } else { written(s) };
    // Corners 0.2 mm apart leave 2 % of the width.
    let found = verdicts(&TRUTH, read("theirs.vtu", grid(|x, y| [x, y, 0.0], zero)), 3e-2).expect("judged");
    assert!(!found.met() && found.mistakes.iter().any(|says| says.contains("mid-side")), "{:?}", found.mistakes);
}

#[test]
fn no_half_of_a_half_is_missing_and_no_mistake_takes_means_over_edges_away() {
    let found = |times: f64| {
        let [places, pressures] = [ellipse::list(|s| s), ellipse::list(ellipse::pressure)];
        let contact = json!({ "position": places, "pressure": pressures, "edges": ellipse::edges(times) });
        judged(read("theirs.json", document(contact))).expect("judged")
    };
    assert!(found(1.0).met());
    let found = found(2.0);
    assert!(!found.met() && !found.mistakes.iter().any(|says| says.contains("missing")), "{:?}", found.mistakes);
}

#[test]
fn tables_are_read_as_comsol_excel_and_fortran_write_them() {
    let row = |separator: &str, end: &str| ellipse::rows(separator, |x| x.to_string()).replace('\n', end);
    for text in [
        format!("% x (mm)    Contact pressure, contact pair p1 (MPa)\n{}", row("    ", "\n")),
        format!("% x-coordinate (mm)    solid.Tn_p1 (MPa)\n{}", row("    ", "\n")),
        format!("position [mm],pressure [MPa]\n{}", row(",", ",\n")),
        format!("position [mm],pressure [MPa]\n−{}", row(",", "\n−")).trim_end_matches('−').to_owned(),
    ] {
        ellipse::assert(&read("theirs.txt", text), 1e-9);
    }
    // Units of columns that are not read need not be known, and 1 is none.
    let numbered: String = row(",", "\n").lines().map(|line| format!("1,{line},closed\n")).collect();
    for head in ["Time,x,p,status\ns,mm,MPa,closed/open\n", "node,x,p,status\n1,mm,N/mm^2,-\n"] {
        ellipse::assert(&read("theirs.csv", format!("{head}{numbered}")), 1e-9);
    }
    let strange = format!("node,x,p,status\n1,mm,torr,-\n{numbered}");
    refused("theirs.csv", strange, &Asked::default(), &["theirs.csv:2", "this row of units has `torr`"]);
    // One blank between names of several words, each with its unit.
    let spaced = format!("# position [mm] contact pressure [MPa]\n{}", row(" ", "\n"));
    ellipse::assert(&read("theirs.txt", spaced), 1e-9);
    let inches = ellipse::rows(",", |x| x.to_string());
    let inches =
        parsed("theirs.csv", format!("position [inch],pressure [MPa]\n{inches}"), &Asked::default()).expect("read");
    assert_relative_eq!(inches.contacts[0].points[1].position, 25.4 * ellipse::place(1));
    let commas = "position [mm],pressure [MPa]\n0,0,100,0\n1,0,86,6\n2,0,0,0\n";
    refused("theirs.csv", commas, &usual(), &["theirs.csv:2", "4 cells", "decimal commas need semicolons"]);
    refused("theirs.json", "{\"units\":{},\"contacts\":[{\"position\":[NaN]}]}", &usual(), &["numbers are finite"]);
    refused("theirs.vtk", &vtk::ascii(&written)[..2000], &usual(), &["it is cut"]);
}

#[test]
fn numbers_that_fill_their_columns_have_no_blanks_between_in_a_frd() {
    let moved = |line: &str| {
        let number = |text: &str| format!("{:>10}", text.trim().parse::<u64>().expect("a number") + 1_000_000_000);
        match line.get(..3) {
            Some(" -1") if line.contains('.') => format!("{}{}{}\n", &line[..3], number(&line[3..13]), &line[13..]),
            Some(" -2") => {
                let nodes = line.as_bytes()[3..].chunks(10).map(|own| number(std::str::from_utf8(own).expect("text")));
                format!(" -2{}\n", nodes.collect::<String>())
            }
            _ => format!("{line}\n"),
        }
    };
    ellipse::assert(&read("theirs.frd", Frd::plain().text().lines().map(moved).collect::<String>()), 1e-4);
}

#[test]
fn the_time_of_a_grid_is_said_and_that_pressures_are_read_where_forces_stand_beside_them() {
    let number = |s: f64| written(s);
    let legacy = vtk::ascii(&number);
    for (time, notes) in [("0", 0), ("0.5", 1), ("1", 0)] {
        let field = format!("DATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTIME 1 1 double\n{time}\n");
        let array = format!(
            "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time}</DataArray>"
        );
        let head = format!("<UnstructuredGrid>\n<FieldData>\n{array}\n</FieldData>\n");
        for (name, text) in [
            ("theirs.vtk", legacy.replacen("DATASET UNSTRUCTURED_GRID\n", &field, 1)),
            ("theirs.vtu", grid(|x, y| [x, y, 0.0], written).replacen("<UnstructuredGrid>\n", &head, 1)),
        ] {
            let found = read(name, text);
            ellipse::assert(&found, 1e-5);
            assert!(found.read.contains(&format!("the grid of time {time}")), "{name}: {:?}", found.read);
            assert_eq!(found.notes.len(), notes, "{name}: {:?}", found.notes);
        }
    }
    let [places, pressures, forces] = [|s| s, ellipse::pressure, |_| 1.0].map(ellipse::list);
    let contact = json!({ "position": places, "pressure": pressures, "force": forces });
    let found = read("theirs.json", document(contact));
    ellipse::assert(&found, 1e-9);
    assert!(found.read.iter().any(|how| how == "the pressures, not the forces beside them"), "{:?}", found.read);
}
