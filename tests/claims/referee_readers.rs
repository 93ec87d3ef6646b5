//! Every reader, quantity by quantity and unit by unit, on files with two states, cells of both orientations and every column; numbers from the
//! closed form of Hertz.

use std::io::Write;
use std::path::Path;

use approx::assert_relative_eq;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use contact_vv::case::library::find;
use contact_vv::referee::export::deck;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, calculix, norm, read};
use contact_vv::solution::EdgeState;
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};

use crate::referee_wild::{parsed, tiny, usual};
use crate::workbench::refused;

/// Force, radius and E* of the scene `tiny`.
const LOAD: [f64; 3] = [314.1593, 1000.0, 91000.0 / 0.91];

/// `a = √(4PR/πE*)` \[mm\].
pub fn half_width() -> f64 {
    let [force, radius, modulus] = LOAD;
    (4.0 * force * radius / (std::f64::consts::PI * modulus)).sqrt()
}

/// `p₀ = 2P/πa` \[MPa\].
pub fn peak() -> f64 {
    2.0 * LOAD[0] / (std::f64::consts::PI * half_width())
}

/// The contact side of the small meshes: 49 nodes, 0.1 mm apart.
pub mod ellipse {
    use super::*;

    pub const NODES: usize = 49;

    pub fn place(k: usize) -> f64 {
        0.1 * k as f64
    }

    pub fn pressure(s: f64) -> f64 {
        peak() * (1.0 - (s / half_width()).powi(2)).max(0.0).sqrt()
    }

    /// The gap beyond the contact of a half-plane, `(a²/2R) (ξ √(ξ² − 1) − ln(ξ + √(ξ² − 1)))`, ξ = s/a.
    pub fn gap(s: f64) -> f64 {
        let x = (s / half_width()).max(1.0);
        let root = (x * x - 1.0).sqrt();
        half_width().powi(2) / (2.0 * LOAD[1]) * (x * root - (x + root).ln())
    }

    /// Lines of two numbers.
    pub fn rows(separator: &str, number: impl Fn(f64) -> String) -> String {
        let row = |k| format!("{}{separator}{}\n", number(place(k)), number(pressure(place(k))));
        (0..NODES).map(row).collect()
    }

    /// A number of every node.
    pub fn list(of: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..NODES).map(|k| of(place(k))).collect()
    }

    /// The edges of a document, with means of straight lines between so many times the pressures.
    pub fn edges(times: f64) -> serde_json::Value {
        let edge = |k: usize| {
            let [from, to] = [k, k + 1].map(place);
            let mean = 0.5 * times * (pressure(from) + pressure(to));
            serde_json::json!({ "from": from, "to": to, "area": to - from, "pressure": mean })
        };
        (0..NODES - 1).map(edge).collect()
    }

    pub fn text() -> String {
        format!("position [mm],pressure [MPa]\n{}", rows(",", |x| x.to_string()))
    }

    /// That an answer holds every node with its pressure and, where it was handed in, its gap; `share` of them.
    pub fn assert(answer: &Answer, digits: f64) {
        assert_share(answer, digits, 1.0);
    }

    pub fn assert_share(answer: &Answer, digits: f64, share: f64) {
        let points = &answer.contacts[0].points;
        assert_eq!(points.len(), NODES);
        for (k, point) in points.iter().enumerate() {
            let s = place(k);
            assert!((point.position - s).abs() <= 5.0 * digits, "{point:?} at {s}");
            assert!((point.value - share * pressure(s)).abs() <= 100.0 * digits, "{point:?} at {s}");
            assert!(point.gap.is_none_or(|own| (own - gap(s)).abs() <= 0.3 * digits), "{point:?} at {s}");
        }
    }
}

use ellipse::{NODES, gap, place, pressure};

/// Nodes of two rows, and cells between them; every second one is turned round.
fn mesh() -> (Vec<[f64; 2]>, Vec<[usize; 4]>) {
    let points = (0..2 * NODES).map(|k| [place(k % NODES), 0.5 * (k / NODES) as f64]).collect();
    let cell = |k: usize| {
        let [a, b, c, d] = [k, k + 1, k + 1 + NODES, k + NODES];
        if k.is_multiple_of(2) { [a, b, c, d] } else { [a, d, c, b] }
    };
    (points, (0..NODES - 1).map(cell).collect())
}

/// Legacy VTK files.
pub mod vtk {
    use super::*;

    /// The ellipse in version 5.1.
    pub fn plain() -> String {
        points(&|x, y| [x, y])
    }

    /// With pressures as they are written.
    pub fn ascii(written: &dyn Fn(f64) -> String) -> String {
        text(true, &|x, y| [x, y], written)
    }

    /// With points elsewhere.
    pub fn points(moved: &dyn Fn(f64, f64) -> [f64; 2]) -> String {
        text(true, moved, &|s| format!("{:e}", pressure(s)))
    }

    /// What of a node the two rows have: the lower one is the contact side.
    fn of(k: usize, own: &dyn Fn(f64) -> String) -> String {
        if k < NODES { own(place(k)) } else { "0".into() }
    }

    pub fn text(new: bool, moved: &dyn Fn(f64, f64) -> [f64; 2], written: &dyn Fn(f64) -> String) -> String {
        let (points, cells) = mesh();
        let list = |all: Vec<String>| all.join("\n") + "\n";
        let places = points.iter().map(|[x, y]| moved(*x, *y)).map(|[x, y]| format!("{x:e} {y:e} 0")).collect();
        let nodes: Vec<String> = cells.iter().map(|cell| cell.map(|node| node.to_string()).join(" ")).collect();
        let (count, number) = (cells.len(), points.len());
        let cells = match new {
            true => {
                let ends = (0..=count).map(|k| (4 * k).to_string()).collect::<Vec<_>>().join(" ");
                let sizes = format!("CELLS {} {}\n", count + 1, 4 * count);
                format!("{sizes}OFFSETS vtktypeint64\n{ends}\nCONNECTIVITY vtktypeint64\n{}", list(nodes))
            }
            false => format!(
                "CELLS {count} {}\n{}",
                5 * count,
                list(nodes.iter().map(|nodes| format!("4 {nodes}")).collect())
            ),
        };
        let head = format!("# vtk DataFile Version {}\nof two rows\nASCII\n", if new { "5.1" } else { "3.0" });
        let grid = format!("DATASET UNSTRUCTURED_GRID\nPOINTS {number} double\n{}{cells}", list(places));
        let types = format!("CELL_TYPES {count}\n{}", "9\n".repeat(count));
        let pressures = list((0..number).map(|k| of(k, written)).collect());
        // Stresses of six and nine components, of which −σ_yy is the pressure; a vector, and a gap behind them.
        let six =
            list((0..number).map(|k| format!("7 {} 5 3 2 1", of(k, &|s| format!("{:e}", -pressure(s))))).collect());
        let gaps = list((0..number).map(|k| of(k, &|s| format!("{:e}", gap(s)))).collect());
        let before =
            format!("CELL_DATA {count}\nSCALARS pressure double\nLOOKUP_TABLE default\n{}", "3\n".repeat(count));
        let meta = "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n";
        format!(
            "{head}{grid}{types}{before}POINT_DATA {number}\nSCALARS contact_pressure double 1\nLOOKUP_TABLE default\n{pressures}{meta}\
             VECTORS moved float\n{}FIELD FieldData 2\nS 6 {number} double\n{six}{meta}contact%20gap 1 {number} float\n{gaps}",
            "1 2 3\n".repeat(number)
        )
    }

    /// The same in binary, of either version.
    pub fn binary(new: bool) -> Vec<u8> {
        let (points, cells) = mesh();
        let (count, number) = (cells.len(), points.len());
        let mut all = format!("# vtk DataFile Version {}\n-\nBINARY\n", if new { "5.1" } else { "3.0" }).into_bytes();
        let line = |all: &mut Vec<u8>, line: String| all.extend(format!("\n{line}\n").bytes());
        line(&mut all, format!("DATASET UNSTRUCTURED_GRID\nPOINTS {number} float"));
        all.extend(points.iter().flat_map(|[x, y]| [*x as f32, *y as f32, 0.0]).flat_map(f32::to_be_bytes));
        if new {
            line(&mut all, format!("CELLS {} {}\nOFFSETS vtktypeint64", count + 1, 4 * count));
            all.extend((0..=count as i64).flat_map(|k| (4 * k).to_be_bytes()));
            line(&mut all, "CONNECTIVITY vtktypeint64".into());
            all.extend(cells.iter().flatten().flat_map(|node| (*node as i64).to_be_bytes()));
        } else {
            line(&mut all, format!("CELLS {count} {}", 5 * count));
            let ints = cells.iter().flat_map(|cell| std::iter::once(4).chain(cell.map(|node| node as i32)));
            all.extend(ints.flat_map(i32::to_be_bytes));
        }
        line(&mut all, format!("CELL_TYPES {count}"));
        all.extend((0..count).flat_map(|_| 9_i32.to_be_bytes()));
        line(&mut all, format!("POINT_DATA {number}\nSCALARS contact_pressure double\nLOOKUP_TABLE default"));
        let of = |k: usize, own: fn(f64) -> f64| if k < NODES { own(place(k)) } else { 0.0 };
        all.extend((0..number).flat_map(|k| of(k, pressure).to_be_bytes()));
        line(&mut all, format!("FIELD FieldData 1\ngap 1 {number} double"));
        all.extend((0..number).flat_map(|k| of(k, gap).to_be_bytes()));
        all
    }
}

/// A file of fields of CalculiX on the same mesh.
pub struct Frd {
    /// How numbers are written.
    pub number: fn(f64) -> String,
    /// Nodes of the contact side that its block lists.
    pub listed: Vec<usize>,
    /// Whether cells are expanded into bricks.
    pub slice: bool,
    /// The layer whose nodes the contact block names: those of the plane, or those behind them.
    pub layer: usize,
    /// How far the nodes behind lie off along x.
    pub skew: f64,
    /// How far some nodes of the contact side lie off the path.
    pub warp: f64,
    /// How far all nodes lie off along y.
    pub below: f64,
    /// Step, increment, time and share of the pressures.
    pub states: Vec<(usize, usize, f64, f64)>,
}

impl Frd {
    pub fn plain() -> Self {
        Self {
            number: |x| format!("{x:>12.5E}"),
            listed: (0..NODES).collect(),
            slice: false,
            layer: 0,
            skew: 0.0,
            warp: 0.0,
            below: 0.0,
            states: vec![(1, 1, 1.0, 1.0)],
        }
    }

    /// A number as C writes it, with so many digits of the exponent, and no blank before it.
    pub fn exponent(x: f64, digits: usize) -> String {
        let text = format!("{x:.5E}");
        let (mantissa, exponent) = text.split_once('E').expect("an exponent");
        let exponent: i32 = exponent.parse().expect("a number");
        format!("{mantissa}E{}{:0digits$}", if exponent < 0 { '-' } else { '+' }, exponent.abs())
    }

    pub fn text(&self) -> String {
        let (points, cells) = mesh();
        let row = |node: usize, numbers: &[f64]| {
            format!(" -1{node:>10}{}\n", numbers.iter().map(|x| (self.number)(*x)).collect::<String>())
        };
        let mut text =
            String::from("    1C\n    2C                           100                                     1\n");
        for layer in 0..if self.slice || self.layer > 0 { 2 } else { 1 } {
            for (k, [x, y]) in points.iter().enumerate() {
                let off = if k < NODES && (0.7..1.5).contains(x) { self.warp } else { 0.0 };
                text += &row(k + 1 + 100 * layer, &[x + layer as f64 * self.skew, y + off + self.below, layer as f64]);
            }
        }
        text += " -3\n    3C                            24                                     1\n";
        for (k, cell) in cells.iter().enumerate() {
            let nodes = cell.map(|node| format!("{:>10}", node + 1)).concat();
            let behind =
                if self.slice { cell.map(|node| format!("{:>10}", node + 101)).concat() } else { String::new() };
            text += &format!(" -1{:>10}{:>5}    0    1\n -2{nodes}{behind}\n", k + 1, if self.slice { 1 } else { 9 });
        }
        text += " -3\n";
        for (k, (step, increment, time, share)) in self.states.iter().enumerate() {
            text += &format!("    1PSTEP{:>26}{increment:>12}{step:>12}\n", k + 1);
            text += &format!("  100CL  101{time:>12.5E}{:>12}{:>22}{:>5}           1\n", 50, 0, k + 1);
            text += " -4  CONTACT     6    1\n";
            let names = ["COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"];
            text += &names.map(|name| format!(" -5  {name:<12}1    4    1    1\n")).concat();
            for node in &self.listed {
                let s = place(*node);
                text += &row(node + 1 + 100 * self.layer, &[gap(s), 7.0, 5.0, share * pressure(s), 3.0, 2.0]);
            }
            text += " -3\n";
        }
        text + " 9999\n"
    }
}

/// What a unit is in ours, by its definition.
const UNITS: [(Role, &str, f64); 30] = [
    (Role::Position, "mm", 1.0),
    (Role::Position, "m", 1000.0),
    (Role::Position, "um", 0.001),
    (Role::Position, "µm", 0.001),
    (Role::Position, "cm", 10.0),
    (Role::Position, "in", 25.4),
    (Role::Pressure, "MPa", 1.0),
    (Role::Pressure, "N/mm2", 1.0),
    (Role::Pressure, "N/mm²", 1.0),
    (Role::Pressure, "N/mm^2", 1.0),
    (Role::Pressure, "kPa", 0.001),
    (Role::Pressure, "Pa", 0.000_001),
    (Role::Pressure, "N/m^2", 0.000_001),
    (Role::Pressure, "GPa", 1000.0),
    (Role::Pressure, "bar", 0.1),
    (Role::Pressure, "psi", 0.006_894_757_293),
    (Role::Pressure, "ksi", 6.894_757_293),
    (Role::Gap, "mm", 1.0),
    (Role::Gap, "m", 1000.0),
    (Role::Gap, "um", 0.001),
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

/// A grid and a file of CalculiX with numbers in a unit.
fn fields_in_a_unit(asked: Role, unit: &str, ours: f64) {
    let mut units = usual();
    units.units.iter_mut().filter(|(role, _)| *role == asked).for_each(|(_, own)| *own = unit.into());
    let factor = |role: Role| if role == asked { ours } else { 1.0 };
    for (name, text) in [("a.vtk", vtk::plain()), ("a.frd", Frd::plain().text())] {
        let scaled = parsed(name, &text, &units);
        // Only where places are as in the file they lie on the contact side.
        if asked == Role::Position && (ours - 1.0).abs() > 0.0 {
            let points = vtk::points(&|x, y| [x / ours, y / ours]);
            ellipse::assert(&parsed("a.vtk", points, &units).expect(unit), 1e-6);
            continue;
        }
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
                let mut asked = Asked { tension_positive: role == Role::Pressure, ..usual.clone() };
                asked.columns = vec![(role, column.to_owned())];
                asked.units.push((Role::Stress, "MPa".into()));
                let answer = parsed("a.vtk", &without, &asked).unwrap_or_else(|error| panic!("{column}: {error}"));
                ellipse::assert(&answer, 1e-6);
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
        let row =
            |k: usize| format!("{:>10} {:>13.6E}  0.000000E0  0.000000E0\n", first + 2 * k, -share * (k + 1) as f64);
        let rows: String = (0..nodes.len()).map(row).collect();
        format!(" forces (fx,fy,fz) for set GAPS_BLOCK_ON_RIGID and time  {time}\n\n{rows}\n")
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

/// A grid whose arrays are coded in one of VTK's ways: appended or in line, raw or in base64, compressed or not, headers of 4 or 8 bytes.
fn coded(appended: bool, raw: bool, zlib: bool, wide: bool, ints: &str) -> Vec<u8> {
    let (points, cells) = mesh();
    let at = |own: fn(f64) -> f64| (0..2 * NODES).map(|k| if k < NODES { own(place(k)) } else { 0.0 }).collect();
    let floats = |all: Vec<f64>| all.into_iter().flat_map(f64::to_le_bytes).collect::<Vec<u8>>();
    let whole = |all: Vec<usize>| {
        let bytes = |node: usize| match ints {
            "UInt16" => (node as u16).to_le_bytes().to_vec(),
            "Int16" => (node as i16).to_le_bytes().to_vec(),
            "UInt32" => (node as u32).to_le_bytes().to_vec(),
            "UInt64" => (node as u64).to_le_bytes().to_vec(),
            _ => (node as i32).to_le_bytes().to_vec(),
        };
        all.into_iter().flat_map(bytes).collect::<Vec<u8>>()
    };
    let ends = (1..=cells.len()).map(|k| 4 * k).collect();
    let arrays = [
        ("<PointData>", "contact_pressure", "Float64", 1, floats(at(pressure))),
        ("", "gap", "Float64", 1, floats(at(gap))),
        (
            "</PointData><Points>",
            "Points",
            "Float64",
            3,
            floats(points.iter().flat_map(|[x, y]| [*x, *y, 0.0]).collect()),
        ),
        ("</Points><Cells>", "connectivity", ints, 1, whole(cells.iter().flatten().copied().collect())),
        ("", "offsets", ints, 1, whole(ends)),
        ("", "types", "Int8", 1, vec![9; cells.len()]),
    ];
    let word =
        |word: usize| if wide { (word as u64).to_le_bytes().to_vec() } else { (word as u32).to_le_bytes().to_vec() };
    let code = |bytes: &[u8]| {
        // Two blocks, of which the last is not full; or so small ones that each is longer when it is compressed.
        let size = if wide { 7 } else { bytes.len() / 8 / 2 * 8 + 8 };
        let packed: Vec<Vec<u8>> = bytes
            .chunks(size)
            .map(|block| {
                let mut all = ZlibEncoder::new(Vec::new(), Compression::default());
                all.write_all(block).and_then(|()| all.finish()).expect("compressed")
            })
            .collect();
        let sizes: Vec<usize> = packed.iter().map(Vec::len).collect();
        let (head, body) = match zlib {
            true => ([vec![packed.len(), size, bytes.len() % size], sizes].concat(), packed.concat()),
            false => (vec![bytes.len()], bytes.to_vec()),
        };
        let head: Vec<u8> = head.into_iter().flat_map(word).collect();
        match (raw, zlib) {
            (true, _) => [head, body].concat(),
            (false, true) => (STANDARD.encode(head) + &STANDARD.encode(body)).into_bytes(),
            (false, false) => STANDARD.encode([head, body].concat()).into_bytes(),
        }
    };
    let [width, packer] =
        [if wide { "UInt64" } else { "UInt32" }, if zlib { " compressor=\"vtkZLibDataCompressor\"" } else { "" }];
    let mut text = format!(
        "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"{width}\"{packer}><UnstructuredGrid>\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
        points.len(),
        cells.len()
    )
    .into_bytes();
    let mut behind = Vec::new();
    for (before, name, kind, components, bytes) in arrays {
        let own = code(&bytes);
        let head = format!("{before}<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\"");
        match appended {
            true => text.extend(format!("{head} format=\"appended\" offset=\"{}\"/>", behind.len()).bytes()),
            false => text.extend([format!("{head} format=\"binary\">").as_bytes(), &own, b"</DataArray>"].concat()),
        }
        behind.extend(own);
    }
    text.extend(b"</Cells></Piece></UnstructuredGrid>");
    if appended {
        let encoding = if raw { "raw" } else { "base64" };
        text.extend(
            [format!("<AppendedData encoding=\"{encoding}\">_").as_bytes(), &behind, b"</AppendedData>"].concat(),
        );
    }
    text.extend(b"</VTKFile>");
    text
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
