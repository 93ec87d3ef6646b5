//! Every reader, quantity by quantity and unit by unit, on files with two states, cells of both orientations and every
//! column; numbers from the closed form of Hertz.

use std::io::Write;
use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::case::Case;
use contact_vv::case::library::find;
use contact_vv::checkout::root;
use contact_vv::referee::export::deck;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, calculix, norm, read};
use contact_vv::solution::EdgeState;
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::ellipse::{self, NODES, gap, place, pressure};
use crate::foreign::{Frd, coded, forces, vtk};
use crate::handed;
use crate::referee_wild::{judged, parsed, tiny, usual};
use crate::workbench::refused;

/// What a unit is in ours, by its definition.
const UNITS: [(Role, &str, f64); 40] = [
    (Role::Position, "mm", 1.0),
    (Role::Position, "m", 1000.0),
    (Role::Position, "um", 0.001),
    (Role::Position, "µm", 0.001),
    (Role::Position, "nm", 0.000_001),
    (Role::Position, "cm", 10.0),
    (Role::Position, "ft", 304.8),
    (Role::Position, "MM", 1.0),
    (Role::Position, "in", 25.4),
    (Role::Pressure, "MPa", 1.0),
    (Role::Pressure, "N/mm2", 1.0),
    (Role::Pressure, "N/mm²", 1.0),
    (Role::Pressure, "N/mm^2", 1.0),
    (Role::Pressure, "kPa", 0.001),
    (Role::Pressure, "Pa", 0.000_001),
    (Role::Pressure, "N/m^2", 0.000_001),
    (Role::Pressure, "GPa", 1000.0),
    (Role::Pressure, "kN/mm2", 1000.0),
    (Role::Pressure, "MN/m2", 1.0),
    (Role::Pressure, "MPA", 1.0),
    (Role::Pressure, "Mpa", 1.0),
    (Role::Pressure, "bar", 0.1),
    (Role::Pressure, "atm", 0.101_325),
    (Role::Pressure, "lbf/in2", 0.006_894_757_293),
    (Role::Pressure, "psi", 0.006_894_757_293),
    (Role::Pressure, "ksi", 6.894_757_293),
    (Role::Gap, "mm", 1.0),
    (Role::Gap, "m", 1000.0),
    (Role::Gap, "um", 0.001),
    (Role::Gap, "nm", 0.000_001),
    (Role::Gap, "cm", 10.0),
    (Role::Gap, "in", 25.4),
    (Role::Area, "mm2", 1.0),
    (Role::Area, "cm2", 100.0),
    (Role::Area, "m2", 1_000_000.0),
    (Role::Area, "m²", 1_000_000.0),
    (Role::Area, "in2", 645.16),
    (Role::Force, "N", 1.0),
    (Role::Force, "kN", 1000.0),
    (Role::Force, "lbf", 4.448_221_615),
];

/// A number of the k-th node: the areas are 0.2 mm² and more, the forces the pressures on them.
fn number(role: Role, k: usize) -> f64 {
    let area = 0.2 + 0.01 * k as f64;
    match role {
        Role::Position => place(k),
        Role::Pressure => pressure(place(k)),
        Role::Gap => gap(place(k)),
        Role::Area => area,
        _ => area * pressure(place(k)),
    }
}

/// The area of an edge, nearly its length \[mm²\].
fn area_of_edge(k: usize) -> f64 {
    0.1 + 1e-5 * k as f64
}

#[test]
fn every_unit_of_every_quantity_is_what_it_is_by_definition() {
    const OURS: [(Role, &str); 5] =
        [(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Gap, "mm"), (Role::Area, "mm2"), (Role::Force, "N")];
    let case = tiny();
    for (asked, unit, ours) in UNITS {
        let left = if asked == Role::Force { Role::Pressure } else { Role::Force };
        let columns: Vec<(Role, &str, f64)> = OURS
            .iter()
            .filter(|(role, _)| *role != left)
            .map(|(role, own)| if *role == asked { (*role, unit, ours) } else { (*role, *own, 1.0) })
            .collect();
        let line = |cells: Vec<String>| cells.join(",") + "\n";
        let head = line(columns.iter().map(|(role, unit, _)| format!("{} [{unit}]", role.name())).collect());
        let row = |k| line(columns.iter().map(|(role, _, one)| format!("{:e}", number(*role, k) / one)).collect());
        let table = head + &(0..NODES).map(row).collect::<String>();
        let lists: serde_json::Map<String, serde_json::Value> = columns
            .iter()
            .map(|(role, _, one)| {
                let list: Vec<f64> = (0..NODES).map(|k| number(*role, k) / one).collect();
                (role.name().to_owned(), list.into())
            })
            .collect();
        let units: serde_json::Map<String, serde_json::Value> =
            columns.iter().map(|(role, unit, _)| (role.name().to_owned(), (*unit).into())).collect();
        // Means over edges are in the same units.
        let mut lists = lists;
        let own =
            |role: Role, k: usize| number(role, k) / columns.iter().find(|one| one.0 == role).map_or(1.0, |one| one.2);
        let edge = |k: usize| {
            let [from, to] = [k, k + 1].map(|k| own(Role::Position, k));
            let area = area_of_edge(k) * own(Role::Area, k) / number(Role::Area, k);
            serde_json::json!({ "from": from, "to": to, "area": area, "pressure": own(Role::Pressure, k) })
        };
        if asked != Role::Force {
            lists.insert("edges".into(), (0..NODES - 1).rev().map(edge).collect::<Vec<_>>().into());
        }
        // As programs of Windows write it.
        let json = "\u{feff}".to_owned() + &serde_json::json!({ "units": units, "contacts": [lists] }).to_string();
        for (name, text) in [("a.csv", &table), ("a.json", &json)] {
            let answer = read::parse(Path::new(name), text.as_bytes(), &case, &Asked::default());
            let answer = answer.unwrap_or_else(|error| panic!("{unit}: {error}"));
            for (k, point) in answer.contacts[0].points.iter().enumerate() {
                let value = number(if asked == Role::Force { Role::Force } else { Role::Pressure }, k);
                for (found, wanted) in [
                    (point.position, number(Role::Position, k)),
                    (point.value, value),
                    (point.gap.expect("a gap"), number(Role::Gap, k)),
                    (point.area.expect("an area"), number(Role::Area, k)),
                ] {
                    assert_relative_eq!(found, wanted, max_relative = 1e-9, epsilon = 1e-12);
                }
            }
            for (k, edge) in answer.contacts[0].edges.iter().enumerate() {
                let [found, wanted] = [
                    [edge.ends[0], edge.ends[1], edge.weight, edge.pressure],
                    [place(k), place(k + 1), area_of_edge(k), pressure(place(k))],
                ];
                (0..4).for_each(|k| assert_relative_eq!(found[k], wanted[k], max_relative = 1e-9, epsilon = 1e-12));
            }
        }
        if [Role::Position, Role::Pressure, Role::Gap].contains(&asked) {
            fields_in_a_unit(asked, unit, ours);
        }
    }
}

#[test]
fn every_unit_of_places_is_one_of_coordinates_gaps_and_displacements() {
    let ring = Case::read(&root().join("tests/cases/shrunk-ring.toml")).expect("a case");
    for (_, unit, ours) in UNITS.iter().filter(|(role, ..)| *role == Role::Position) {
        let row = |z: f64| format!("{:e},{:e},41,{:e}\n", 20.0 / ours, z / ours, 7.0 / ours);
        let head = format!("r [{unit}],z [{unit}],pressure [MPa],gap [{unit}]\n");
        let answer = handed::read(&ring, "a.csv", head + &[-15.0, 0.0, 15.0].map(row).concat(), &Asked::default());
        let answer = answer.unwrap_or_else(|error| panic!("{unit}: {error}"));
        for (point, place) in answer.contacts[0].points.iter().zip([-15.0, 0.0, 15.0]) {
            assert_relative_eq!(point.position, place, max_relative = 1e-9, epsilon = 1e-12);
            assert_relative_eq!(point.gap.expect("a gap"), 7.0, max_relative = 1e-9);
        }
        let mut asked = Asked { columns: vec![(Role::Displacement, "moved".into())], ..usual() };
        asked.units.push((Role::Displacement, (*unit).to_owned()));
        let field = parsed("a.vtk", vtk::plain(), &asked).expect(unit).field.expect("displacements");
        let [u, v] = field.displacement[0];
        assert_relative_eq!(u / ours, 1.0, max_relative = 1e-9);
        assert_relative_eq!(v / ours, 2.0, max_relative = 1e-9);
    }
}

/// A grid and a file of CalculiX with numbers in a unit.
fn fields_in_a_unit(asked: Role, unit: &str, ours: f64) {
    let mut units = usual();
    units.units.iter_mut().filter(|(role, _)| *role == asked).for_each(|(_, own)| *own = unit.into());
    let factor = |role: Role| if role == asked { ours } else { 1.0 };
    // Places lie on the contact side in their own unit only.
    let length = factor(Role::Position);
    let grid = vtk::points(&|x, y| [x / length, y / length]);
    for (name, text) in [("a.vtk", grid), ("a.frd", Frd { length, ..Frd::plain() }.text())] {
        let scaled = parsed(name, &text, &units);
        for (k, point) in scaled.expect(unit).contacts[0].points.iter().enumerate() {
            let s = place(k);
            assert_relative_eq!(point.value, factor(Role::Pressure) * pressure(s), max_relative = 2e-5, epsilon = 1e-9);
            assert_relative_eq!(
                point.gap.expect("a gap"),
                factor(Role::Gap) * gap(s),
                max_relative = 2e-5,
                epsilon = 1e-9
            );
        }
    }
}

#[test]
fn angles_are_read_in_degrees_and_radians() {
    let arc = find("pin-rod", None).expect("a case");
    let text = |unit: &str, one: f64| {
        let rows: String = (0..5).map(|k| format!("{},{}\n", f64::from(k) * 10.0 / one, 5 - k)).collect();
        format!("position [{unit}],pressure [MPa]\n{rows}")
    };
    for (unit, one) in [("deg", 1.0), ("°", 1.0), ("rad", 57.295_779_513)] {
        let answer = read::parse(Path::new("a.csv"), text(unit, one).as_bytes(), &arc, &Asked::default()).expect(unit);
        assert_relative_eq!(answer.contacts[0].points[4].position, 40.0 / 57.295_779_513, max_relative = 1e-9);
    }
}

/// Stresses of nine components, of which −σ_yy is the pressure.
fn tensors() -> String {
    let pressed = |k: usize| if k < NODES { 0.0 - pressure(place(k)) } else { 0.0 };
    (0..2 * NODES).map(|k| format!("7 1 2 1 {:e} 4 2 4 5\n", pressed(k))).collect()
}

#[test]
fn legacy_grids_of_every_version_and_coding_say_the_same() {
    let usual = usual();
    for new in [true, false] {
        let text = vtk::text(new, &|x, y| [x, y], &|s| format!("{:e}", pressure(s)));
        ellipse::assert(&parsed("a.vtk", &text, &usual).expect("ASCII"), 1e-6);
        ellipse::assert(&parsed("a.vtk", vtk::binary(new), &usual).expect("binary"), 1e-6);
        // −n·σn of six and of nine components, and one of them by its name and by its number; tension is positive.
        let without = text.replace("contact_pressure", "other");
        let without = without.replace("VECTORS moved", &format!("TENSORS sigma double\n{}VECTORS moved", tensors()));
        for [whole, named, numbered] in [["S", "S:yy", "S:1"], ["sigma", "sigma:yy", "sigma:4"]] {
            for (role, column) in [(Role::Stress, whole), (Role::Pressure, named), (Role::Pressure, numbered)] {
                // Whole stresses are positive in tension, whatever is said of pressures.
                let told = if role == Role::Stress { vec![false, true] } else { vec![true] };
                for tension_positive in told {
                    let mut asked = Asked { tension_positive, ..usual.clone() };
                    asked.columns = vec![(role, column.to_owned())];
                    asked.units.push((Role::Stress, "MPa".into()));
                    let answer = parsed("a.vtk", &without, &asked).unwrap_or_else(|error| panic!("{column}: {error}"));
                    ellipse::assert(&answer, 1e-6);
                }
            }
        }
        for cut in [0.4, 0.8, 0.95] {
            let all = vtk::binary(new);
            assert!(parsed("a.vtk", &all[..(cut * all.len() as f64) as usize], &usual).is_err(), "{cut}");
        }
    }
    // What is announced is not made room for.
    for head in
        ["POINTS 1000000000000 double\n0 0 0\n", "POINTS 99999999999999999999 double\n", "CELLS 5 999999999999\n1 2\n"]
    {
        for coding in ["ASCII", "BINARY"] {
            let text = format!("# vtk DataFile Version 3.0\n-\n{coding}\nDATASET UNSTRUCTURED_GRID\n{head}");
            assert!(parsed("a.vtk", text, &usual).is_err());
        }
    }
}

#[test]
fn grids_of_vtk_are_read_where_the_crate_that_writes_ours_refuses_them() {
    let legacy = |text: &str| vtkio::Vtk::parse_legacy_be(text.as_bytes());
    let [plain, beyond] =
        [1e9, 2.15].map(|end| vtk::ascii(&|s| if s > end { "nan".into() } else { format!("{:e}", pressure(s)) }));
    let narrow = plain.replace("OFFSETS vtktypeint64", "OFFSETS vtktypeint32");
    assert!(legacy(&plain).is_ok() && legacy(&beyond).is_err() && legacy(&narrow).is_err());
    let [coded, raw] = [false, true].map(|is_raw| coded(is_raw, is_raw, false, false, "Int32"));
    let xml = |bytes: &[u8]| vtkio::Vtk::parse_xml(bytes).map(|_| ());
    assert!(xml(&coded).is_ok(), "{:?}", xml(&coded));
    assert!(xml(&raw).is_err(), "{:?}", xml(&raw));
    let ours = [("a.vtk", beyond.into_bytes()), ("a.vtk", narrow.into_bytes()), ("a.vtu", raw)];
    for (name, bytes) in ours {
        assert!(judged(parsed(name, bytes, &usual()).expect("read")).expect("judged").met());
    }
}

#[test]
fn fields_of_calculix_of_the_last_state_are_read_on_cells_of_both_orientations() {
    let two = Frd { states: vec![(1, 1, 0.5, 0.25), (1, 2, 1.0, 1.0)], ..Frd::plain() };
    ellipse::assert(&parsed("a.frd", two.text(), &usual()).expect("read"), 1e-5);
    let first = Asked { time: Some(0.5), ..usual() };
    ellipse::assert_share(&parsed("a.frd", two.text(), &first).expect("read"), 1e-5, 0.25);
    let other = Asked { columns: vec![(Role::Pressure, "CSHEAR1".into())], ..usual() };
    let answer = parsed("a.frd", two.text(), &other).expect("read");
    assert!(answer.contacts[0].points.iter().all(|point| (point.value - 3.0).abs() <= 1e-9));
    let pulled = Asked { tension_positive: true, ..usual() };
    ellipse::assert_share(&parsed("a.frd", two.text(), &pulled).expect("read"), 1e-5, -1.0);
}

#[test]
fn forces_of_the_last_table_of_calculix_are_read_and_those_of_a_time_that_is_named() {
    let case = tiny();
    let discretisation = case.meshed().expect("meshed").discretisation;
    let text = deck::text(&discretisation).expect("written");
    let nodes = &discretisation.interfaces[0].nodes;
    let table = |time: &str, share: f64| {
        let first = discretisation.mesh.points.len() + 2;
        let rows = (0..nodes.len()).map(|k| (first + 2 * k, -share * (k + 1) as f64));
        forces("GAPS_BLOCK_ON_RIGID", time, rows) + "\n"
    };
    let both = table("0.5000000E+00", 0.5) + &table("0.1000000E+01", 1.0);
    for (time, share, noted) in [(None, 1.0, false), (Some(0.5), 0.5, true)] {
        let asked = Asked { time, ..Asked::default() };
        let answer = calculix::forces(Path::new("a.dat"), &both, &text, &case.scene, &asked).expect("read");
        assert_eq!(answer.notes.is_empty(), !noted, "{:?}", answer.notes);
        for (k, point) in answer.contacts[0].points.iter().enumerate() {
            assert_relative_eq!(point.value, share * (k + 1) as f64, max_relative = 1e-5);
            assert_relative_eq!(point.position, nodes[k].coordinate, max_relative = 1e-9, epsilon = 1e-12);
        }
    }
}

#[test]
fn arrays_of_a_vtu_say_the_same_in_every_coding_and_kind_of_number() {
    for (appended, raw) in [(false, false), (true, false), (true, true)] {
        for (zlib, wide) in [(false, false), (false, true), (true, false), (true, true)] {
            for ints in ["Int16", "UInt16", "Int32", "UInt32", "UInt64"] {
                let text = coded(appended, raw, zlib, wide, ints);
                let how = format!("appended {appended}, raw {raw}, zlib {zlib}, wide {wide}, {ints}");
                ellipse::assert(
                    &parsed("a.vtu", &text, &usual()).unwrap_or_else(|error| panic!("{how}: {error}")),
                    1e-9,
                );
            }
        }
    }
}

#[test]
fn arrays_of_a_vtu_that_are_cut_compressed_otherwise_or_big_endian_are_refused() {
    let text = |zlib| String::from_utf8(coded(false, false, zlib, false, "Int32")).expect("base64");
    let (plain, packed) = (text(false), text(true));
    let array = packed.rfind("</DataArray").expect("an array");
    for cut in [1, 9, 40] {
        let text = format!("{}{}", &packed[..array - cut], &packed[array..]);
        assert!(parsed("a.vtu", text, &usual()).is_err(), "{cut}");
    }
    let other = packed.replace("vtkZLibDataCompressor", "vtkLZ4DataCompressor");
    refused(parsed("a.vtu", other, &usual()), &["vtkLZ4DataCompressor, and zlib is read"]);
    // One array written out among the others does not make them plain.
    let written_out = "<DataArray type=\"Float64\" Name=\"more\" format=\"ascii\"></DataArray></PointData>";
    let big = plain.replace("LittleEndian", "BigEndian");
    for text in [big.clone(), big.replace("</PointData>", written_out)] {
        refused(parsed("theirs.vtu", text, &usual()), &["theirs.vtu", "big endian", "little endian"]);
    }
}

#[test]
fn a_compressed_answer_is_the_answer_and_one_compressed_twice_is_refused() {
    let pack = |bytes: &[u8]| {
        let mut all = GzEncoder::new(Vec::new(), Compression::default());
        all.write_all(bytes).and_then(|()| all.finish()).expect("compressed")
    };
    let once = pack(ellipse::text().as_bytes());
    ellipse::assert(&parsed("a.csv.gz", &once, &Asked::default()).expect("read"), 1e-9);
    refused(parsed("a.csv.gz.gz", pack(&once), &Asked::default()), &["it is compressed twice"]);
}

#[test]
fn distance_of_edge_means_is_the_weighted_one_of_the_closed_form() {
    // Means of s over [0, 1] and [1, 3] are 1/2 and 2: √((1 · 1/4 + 2 · 1)/(1 · 1/4 + 2 · 4)).
    let edge = |ends: [f64; 2], pressure: f64| EdgeState { ends, weight: ends[1] - ends[0], pressure, axis: None };
    let found = norm::of_means(&[edge([0.0, 1.0], 1.0), edge([1.0, 3.0], 3.0)], |s| s);
    assert_relative_eq!(found, (2.25_f64 / 8.25).sqrt(), max_relative = 1e-12);
}
