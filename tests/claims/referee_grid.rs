//! Grids whose cells have points of their own, as codes with discontinuous fields write them.

use contact_vv::case::Case;
use contact_vv::case::library::find;
use contact_vv::checkout::root;
use contact_vv::error::Error;
use contact_vv::referee::Answer;
use contact_vv::referee::answer::Point;
use contact_vv::referee::units::Role;
use contact_vv::solve::{Discretisation, Run};

use crate::ellipse;
use crate::foreign::{vtk, vtu};
use crate::handed::{self, in_units, judged, moved};
use crate::referee_wild::{parsed, usual};
use crate::scene_file;
use crate::workbench::{refused, truth};

/// Our own answer, every cell with points of its own; `offset` is added to and taken from the pressures of every second
/// cell in turn.
fn grid(discretisation: &Discretisation, run: &Run, offset: f64, share: bool) -> String {
    grid_of(0, discretisation, run, offset, share)
}

/// The same with the pressures on the side of a body.
fn grid_of(body: usize, discretisation: &Discretisation, run: &Run, offset: f64, share: bool) -> String {
    let mesh = &discretisation.mesh;
    let moved = discretisation.displacement_under(run.share(), &run.solution);
    let mut pressure = vec![0.0; mesh.points.len()];
    for (node, point) in mesh.bodies[body].candidates.iter().zip(run.solution.points_of(0)) {
        pressure[node.node] = point.pressure;
    }
    let mut times = vec![0_usize; mesh.points.len()];
    let (mut points, mut cells, [mut pressures, mut vectors]) = (vec![], vec![], [const { String::new() }; 2]);
    for cell in 0..mesh.cells() {
        let first = points.len();
        for &node in mesh.cell(cell) {
            let [x, y] = mesh.points[node];
            let sign = if times[node].is_multiple_of(2) { 1.0 } else { -1.0 };
            times[node] += 1;
            points.push([x, y, 0.0]);
            pressures += &format!("{:e} ", pressure[node] + sign * offset);
            vectors += &format!("{:e} {:e} 0 ", moved[node][0], moved[node][1]);
        }
        cells.push((first..points.len()).collect::<Vec<usize>>());
    }
    // One cell takes a point of another one.
    if share {
        cells[0][1] = 0;
    }
    let fields =
        [vtu::array("Float64", "contact_pressure", 1, &pressures), vtu::array("Float64", "displacement", 3, &vectors)];
    vtu::text(&points, &cells, &fields.concat())
}

fn read(case: &Case, text: &str) -> Result<Answer, Error> {
    handed::read(case, "theirs.vtu", text, &moved())
}

#[test]
fn cells_with_points_of_their_own_are_judged_by_the_means_at_each_place() {
    // Two bodies that touch: points of both lie at one place.
    for name in ["truncated-hertz", "bars"] {
        let case = find(name, None).expect("a case");
        let (meshed, run) = case.solve().expect("solved");
        let discretisation = &meshed.discretisation;
        let answer = read(&case, &grid(discretisation, &run, 0.0, false)).expect("read");
        let own = run.solution.points_of(0);
        assert_eq!(answer.contacts[0].points.len(), own.len(), "{name}");
        for (theirs, ours) in answer.contacts[0].points.iter().zip(own) {
            assert!((theirs.value - ours.pressure).abs() <= 1e-9, "{name}");
        }
        let places = own.len();
        assert!(
            answer.read.iter().any(|how| how.contains(&format!("at {places} places"))),
            "{name}: {:?}",
            answer.read
        );
        assert!(judged(truth(name), answer).met(), "{name}");
        if case.scene.bodies.len() > 1 {
            let answer = read(&case, &grid_of(1, discretisation, &run, 0.0, false)).expect("read");
            assert!(answer.read.iter().any(|how| how.starts_with("the side of `")), "{:?}", answer.read);
            assert!(judged(truth(name), answer).met(), "{name}");
        }
        // Corners have the pressures of two cells each, of which one is too large and one too small.
        let swaying = read(&case, &grid(discretisation, &run, 0.1, false)).expect("read");
        let corners = swaying.contacts[0].points.iter().zip(own).step_by(2).skip(1);
        for (theirs, ours) in corners.take(own.len() / 2 - 1) {
            assert!((theirs.value - ours.pressure).abs() <= 1e-9, "{name}: {theirs:?}");
        }
    }
}

#[test]
fn points_at_one_place_are_refused_where_cells_share_points() {
    let case = find("truncated-hertz", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    refused(read(&case, &grid(&meshed.discretisation, &run, 0.0, true)), &["two points lie at one place"]);
}

#[test]
fn fields_are_known_by_their_names_in_any_case_and_by_the_very_name_first() {
    let case = find("bars", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let text = grid(&meshed.discretisation, &run, 0.0, false);
    let values = |text: &str| -> Vec<f64> {
        read(&case, text).expect("read").contacts[0].points.iter().map(|point| point.value).collect()
    };
    let own = values(&text);
    let loud = text.replace("\"contact_pressure\"", "\"PRESSURE\"").replace("\"displacement\"", "\"DISPLACEMENT\"");
    assert_eq!(values(&loud), own);
    // Another field before it has its name in other letters.
    let (before, field) = text.split_once("<DataArray").expect("a field");
    let numbers = field.split_once('>').and_then(|(_, rest)| rest.split_once('<')).expect("numbers").0;
    let sevens = "7 ".repeat(numbers.split_whitespace().count());
    let other = vtu::array("Float64", "Contact_Pressure", 1, &sevens);
    assert_eq!(values(&format!("{before}{other}<DataArray{field}")), own);
    // Nor is one that lacks numbers the pressure, whatever its name.
    let short = vtu::array("Float64", "contact_pressure", 1, "7 7");
    assert_eq!(values(&format!("{before}{short}<DataArray{field}")), own);
}

#[test]
fn stresses_on_a_slanted_side_are_taken_along_its_normal_in_every_unit() {
    // A quarter of a ring of 40 mm: σ = −p n⊗n + 20 t⊗t + 10 (n⊗t + t⊗n) with p = 60 + 30 sin 2φ.
    let case = find("press-fit", None).expect("a case");
    let angle = |k: usize| 5.0 * (k as f64).to_radians();
    let pressure = |angle: f64| 60.0 + 30.0 * (2.0 * angle).sin();
    let nodes = || [40.0, 35.0].into_iter().flat_map(|radius| (0..19).map(move |k| (radius, angle(k))));
    let stress = |angle: f64| {
        // Angles begin at the load line, which points down.
        let (n, t) = ([angle.sin(), -angle.cos()], [angle.cos(), angle.sin()]);
        let p = pressure(angle);
        let at = |i: usize, j: usize| 20.0 * t[i] * t[j] - p * n[i] * n[j] + 10.0 * (n[i] * t[j] + t[i] * n[j]);
        [at(0, 0), at(1, 1), at(0, 1)]
    };
    let cells: String = (0..18).map(|k| format!("4 {k} {} {} {}\n", k + 1, k + 20, k + 19)).collect();
    for (position, length, unit, size) in
        [("mm", 1.0, "MPa", 1.0), ("m", 1e-3, "Pa", 1e6), ("in", 1.0 / 25.4, "bar", 10.0)]
    {
        let points: String =
            nodes().map(|(r, a)| format!("{:e} {:e} 0\n", length * r * a.sin(), -length * r * a.cos())).collect();
        for components in [6, 9] {
            let row = |(_, a): (f64, f64)| {
                let [x, y, xy] = stress(a).map(|own| size * own);
                if components == 6 {
                    format!("{x:e} {y:e} 7 {xy:e} 8 9\n")
                } else {
                    format!("{x:e} {xy:e} 7 {xy:e} {y:e} 8 7 8 9\n")
                }
            };
            let rows: String = nodes().map(row).collect();
            let text = format!(
                "# vtk DataFile Version 3.0\nring\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 38 double\n{points}CELLS \
                18 90\n{cells}\
                 CELL_TYPES 18\n{}POINT_DATA 38\nFIELD FieldData 1\nstress {components} 38 double\n{rows}",
                "9\n".repeat(18)
            );
            let asked = in_units(&[(Role::Position, position), (Role::Stress, unit)]);
            let answer = handed::read(&case, "ring.vtk", text, &asked).expect("read");
            let points = &answer.contacts[0].points;
            assert_eq!(points.len(), 19);
            for (k, point) in points.iter().enumerate() {
                let same =
                    (point.position - angle(k)).abs() <= 1e-9 && (point.value - pressure(angle(k))).abs() <= 1e-6;
                assert!(same, "{position}, {unit}, {components} components, {k}: {point:?}");
            }
        }
    }
}

#[test]
fn pressures_on_the_side_of_the_second_body_alone_are_read_there() {
    // The lower side of the small mesh as the upper one of the block, on which the cylinder lies.
    let case = Case::read(&root().join("tests/cases/cylinder-on-block.toml")).expect("a case");
    let grid = vtk::points(&|x, y| [x, 0.0 - y]);
    ellipse::assert(&handed::read(&case, "theirs.vtk", &grid, &usual()).expect("read"), 1e-9);
    let none = vtk::text(true, &|x, y| [x, y], &|_| "0".into());
    refused(parsed("theirs.vtk", none, &usual()), &["nothing presses: all 49 values of contact"]);
}

#[test]
fn nodes_left_of_a_symmetry_line_have_negative_positions() {
    let text = vtk::points(&|x, y| [x - 2.4, y]);
    let answer = parsed("a.vtk", text, &usual()).expect("read");
    for (k, point) in answer.contacts[0].points.iter().enumerate() {
        let same = (point.position - (ellipse::place(k) - 2.4)).abs() <= 1e-9;
        assert!(same && (point.value - ellipse::pressure(ellipse::place(k))).abs() <= 1e-6, "{k}: {point:?}");
    }
}

/// Our own stresses on our own mesh, and nothing else.
fn of_stresses(discretisation: &Discretisation, run: &Run) -> String {
    let mesh = &discretisation.mesh;
    let fields = discretisation.recover_under(run.share(), &run.solution).expect("recovered");
    let stress = |[x, y, xy]: &[f64; 3]| format!("{x:e} {xy:e} 0 {xy:e} {y:e} 0 0 0 0 ");
    let stresses: String = fields.stress.iter().map(stress).collect();
    let points: Vec<[f64; 3]> = mesh.points.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    let cells: Vec<Vec<usize>> = (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect();
    vtu::text(&points, &cells, &vtu::array("Float64", "stress", 9, &stresses))
}

/// The hoop stress of a free arc, and what nodes of a corner carry beyond it, are no pressures.
#[test]
fn stresses_beside_a_contact_are_no_part_of_it() {
    let on_block = scene_file::case("cylinder-on-block");
    for (case, elements) in [(find("flat-punch", None).expect("a case"), 24), (on_block, 16)] {
        let mut case = case;
        case.resolution.elements = elements;
        let (meshed, run) = case.solve().expect("solved");
        let text = of_stresses(&meshed.discretisation, &run);
        let asked = in_units(&[(Role::Position, "mm"), (Role::Stress, "MPa")]);
        let answer = handed::read(&case, "stresses.vtu", &text, &asked).unwrap_or_else(|error| panic!("{error}"));
        assert!(answer.read.iter().any(|one| one.contains("−n·σn")), "{:?}", answer.read);
        // Trapezoids of pressures at the nodes miss 5 % at the end of a contact, and more at a corner.
        let of = |two: &[Point]| 0.5 * (two[1].position - two[0].position) * (two[0].value + two[1].value);
        let force: f64 = answer.contacts[0].points.windows(2).map(of).sum();
        let wanted = run.contacts[0].transmitted / 2.0 / case.scene.thickness;
        assert!((force / wanted - 1.0).abs() <= 0.2, "{force} of {wanted}");
    }
}
