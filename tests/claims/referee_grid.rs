//! Grids whose cells have points of their own, as codes with discontinuous fields write them.

use std::path::Path;

use contact_vv::case::Case;
use contact_vv::case::library::find;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, Truth, read, verdicts};
use contact_vv::solve::{Discretisation, Run};

/// Our own answer, every cell with points of its own; `offset` is added to and taken from the pressures of every second cell in turn.
fn grid(discretisation: &Discretisation, run: &Run, offset: f64, share: bool) -> String {
    let mesh = &discretisation.mesh;
    let moved = discretisation.displacement_under(run.share(), &run.solution);
    let mut pressure = vec![0.0; mesh.points.len()];
    for (node, point) in mesh.bodies[0].candidates.iter().zip(run.solution.points_of(0)) {
        pressure[node.node] = point.pressure;
    }
    let mut times = vec![0_usize; mesh.points.len()];
    let [mut points, mut fields, mut vectors, mut cells, mut ends, mut types] = [const { String::new() }; 6];
    let mut count = 0;
    for cell in 0..mesh.cells() {
        for &node in mesh.cell(cell) {
            let [x, y] = mesh.points[node];
            let sign = if times[node].is_multiple_of(2) { 1.0 } else { -1.0 };
            times[node] += 1;
            points += &format!("{x:e} {y:e} 0 ");
            fields += &format!("{:e} ", pressure[node] + sign * offset);
            vectors += &format!("{:e} {:e} 0 ", moved[node][0], moved[node][1]);
            // With `share`, one cell takes a point of another one.
            let number = if share && count == 1 { 0 } else { count };
            cells += &format!("{number} ");
            count += 1;
        }
        ends += &format!("{count} ");
        types += "23 ";
    }
    let array = |name: &str, kind: &str, components: usize, data: &str| {
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">{data}</DataArray>"
        )
    };
    format!(
        "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"{count}\" \
         NumberOfCells=\"{}\"><PointData>{}{}</PointData><Points>{}</Points><Cells>{}{}{}</Cells></Piece></UnstructuredGrid></VTKFile>",
        mesh.cells(),
        array("contact_pressure", "Float64", 1, &fields),
        array("displacement", "Float64", 3, &vectors),
        array("points", "Float64", 3, &points),
        array("connectivity", "Int64", 1, &cells),
        array("offsets", "Int64", 1, &ends),
        array("types", "UInt8", 1, &types),
    )
}

fn units() -> Asked {
    let units = [(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Displacement, "mm")];
    Asked { units: units.map(|(role, unit)| (role, unit.to_owned())).into(), ..Asked::default() }
}

fn read(case: &Case, text: &str) -> Result<contact_vv::referee::Answer, contact_vv::error::Error> {
    read::parse(Path::new("theirs.vtu"), text.as_bytes(), case, &units())
}

#[test]
fn cells_with_points_of_their_own_are_judged_by_the_means_at_each_place() {
    // Two bodies that touch: points of both lie at one place.
    for name in ["truncated-hertz", "bars"] {
        let case = find(name, None).expect("a case");
        let (meshed, run) = case.solve().expect("solved");
        let (discretisation, truth) = (&meshed.discretisation, Truth::of(case.clone()).expect("a truth"));
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
        assert!(verdicts(&truth, answer, ENGINEERING).expect("judged").met(), "{name}");
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
    let error = read(&case, &grid(&meshed.discretisation, &run, 0.0, true)).map(|_| ()).expect_err("refused");
    assert!(error.to_string().contains("two points lie at one place"), "{error}");
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
    let other = format!(
        "<DataArray type=\"Float64\" Name=\"Contact_Pressure\" NumberOfComponents=\"1\" format=\"ascii\">{sevens}</DataArray>"
    );
    assert_eq!(values(&format!("{before}{other}<DataArray{field}")), own);
}
