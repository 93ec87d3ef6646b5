//! Answers on bodies of revolution: judged by rings, usual mistakes named, spoiled ones refused; what `export` writes
//! of them.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::case::Case;
use contact_vv::cli::export;
use contact_vv::cli::new::Template;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::referee::export::{deck, own};
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::source::Source;
use contact_vv::referee::{Asked, Truth, calculix, frd, read, verdicts};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

use crate::foreign::{self, cell_of, fixed, record};
use crate::handed::{self, PRESSURES, failed, judged, judged_as, moved, table};
use crate::program::Folder;
use crate::referee_export::{blocks, ccx};
use crate::workbench::{parsed, refused};

fn sphere() -> Case {
    Case::parse(Path::new("sphere.toml"), Template::Sphere.text()).expect("a case")
}

/// The case, what it is judged by, and our run on the mesh that is exported.
fn solved() -> (Truth, Discretisation, Run) {
    let case = sphere();
    let discretisation = case.meshed().expect("meshed").discretisation;
    let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
    (Truth::of(case).expect("solved"), discretisation, run)
}

/// Nodal forces of a run, with that of the axis, as a table.
fn forces(run: &Run, of: impl Fn(f64, f64) -> f64) -> String {
    let own = run
        .solution
        .points_of(0)
        .iter()
        .map(|point| [point.position, of(point.position, point.weight * point.pressure)]);
    table("position [mm],force [N]", std::iter::once([0.0; 2]).chain(own))
}

fn pressures(run: &Run, place: f64, pressure: f64) -> String {
    let own = run.solution.points_of(0).iter();
    table(PRESSURES, own.map(|point| [place * point.position, pressure * point.pressure]))
}

/// An answer by nodes of 8-node cells.
fn by_nodes() -> Asked {
    Asked { order: Some(Order::Quadratic), ..Asked::default() }
}

#[test]
fn our_own_answer_of_a_sphere_is_judged_as_what_solve_says() {
    let (truth, discretisation, _) = solved();
    for (element, order) in [
        (Element::Node, Order::Quadratic),
        (Element::Line, Order::Quadratic),
        (Element::Node, Order::Linear),
        (Element::Node, Order::Sextic),
    ] {
        let resolution = Resolution { order, ..truth.case.resolution };
        let own = match order {
            Order::Quadratic => None,
            _ => Some(Discretisation::of(truth.case.scene.clone(), resolution).expect("meshed")),
        };
        let discretisation = own.as_ref().unwrap_or(&discretisation);
        let run = Run::of(discretisation, &Formulation::new(element, Iteration::Kinematic).tolerance(1e-8));
        let run = run.expect("solved");
        let text = serde_json::to_string(&own::answer("sphere", discretisation, &run)).expect("JSON");
        let found = judged_as(
            &truth,
            "ours.json",
            &text.replace("\"sphere\"", &format!("{:?}", truth.case.name)),
            &Asked::default(),
        );
        // The peak of line elements, or on 4-node cells, is off by more than the tolerance on this mesh.
        let meets = found.met() || element == Element::Line || order == Order::Linear;
        assert!(meets && found.mistakes.is_empty(), "{element:?}, {order:?}: {:?}", failed(&found));
        let (theirs, ours) = (&found.ruled[0].measures, &run.contacts[0].measures);
        for (theirs, ours) in [
            (theirs.peak.pressure, ours.peak.pressure),
            (theirs.second_moment_width, ours.second_moment_width),
            (theirs.resultant, ours.resultant),
            (theirs.edge(), ours.edge()),
        ] {
            assert_relative_eq!(theirs, ours, max_relative = 1e-9);
        }
    }
}

#[test]
fn forces_and_pressures_of_rings_add_up_to_the_whole_load() {
    let (truth, _, run) = solved();
    for (text, asked) in [(forces(&run, |_, force| force), by_nodes()), (pressures(&run, 1.0, 1.0), Asked::default())] {
        let found = judged_as(&truth, "theirs.csv", &text, &asked);
        assert!(found.met() && found.mistakes.is_empty(), "{:?}", failed(&found));
        let named: Vec<String> = found.ruled[0].judged.iter().map(|one| one.check.quantity.to_string()).collect();
        for name in ["second-moment radius [mm]", "contact resultant [N]"] {
            assert!(named.iter().any(|own| own == name), "{name}: {named:?}");
        }
        // Pressures at nodes alone are joined by straight lines.
        assert_relative_eq!(found.ruled[0].measures.resultant, 750.0, max_relative = 6e-3);
    }
    let found = judged_as(&truth, "theirs.csv", &forces(&run, |_, force| force), &by_nodes());
    assert_relative_eq!(found.ruled[0].measures.resultant, 750.0, max_relative = 1e-9);
}

#[test]
fn a_node_on_the_axis_that_has_no_area_has_no_pressure_to_judge() {
    let (truth, _, run) = solved();
    let own = run.solution.points_of(0).iter().map(|point| [point.position, point.pressure, point.weight]);
    // Scripts divide its force by nothing, and write 0.
    let text = table("position [mm],pressure [MPa],area [mm2]", std::iter::once([0.0; 3]).chain(own));
    let found = judged_as(&truth, "theirs.csv", &text, &by_nodes());
    assert!(found.met() && found.mistakes.is_empty(), "{:?}", failed(&found));
    // One with an area of its own presses with nothing.
    let spoiled = text.replacen("\n0e0,0e0,0e0\n", "\n0e0,0e0,1e-3\n", 1);
    assert!(spoiled != text && !judged_as(&truth, "theirs.csv", &spoiled, &by_nodes()).met());
}

#[test]
fn usual_mistakes_on_bodies_of_revolution_are_named() {
    let (truth, _, run) = solved();
    let cube = TAU.cbrt();
    for (text, asked, says) in [
        (forces(&run, |_, force| force / TAU), by_nodes(), "2π is forgotten"),
        (forces(&run, |r, force| force / (TAU * r)), by_nodes(), "2πr is forgotten"),
        (forces(&run, |_, force| force / 180.0), by_nodes(), "sector of 2°"),
        (forces(&run, |_, force| force / 2.0), by_nodes(), "sector of 180°"),
        (pressures(&run, 1.0, 2.0), Asked::default(), "pressures are twice the scene's over the scene's width"),
        (pressures(&run, cube, cube), Asked::default(), "the whole force is given per radian"),
        (pressures(&run, cube.recip(), cube.recip()), Asked::default(), "it is given per radian"),
        (pressures(&run, 2f64.cbrt(), 4f64.cbrt().recip()), Asked::default(), "a diameter for a radius"),
        (pressures(&run, 1.0, -1.0), Asked::default(), "--tension-positive"),
        (pressures(&run, 1.0, 1e6), Asked::default(), "Pa are called MPa"),
    ] {
        let found = judged_as(&truth, "theirs.csv", &text, &asked);
        assert!(!found.met(), "{says}");
        assert!(found.mistakes.iter().any(|told| told.contains(says)), "{says}: {:?}", found.mistakes);
    }
}

#[test]
fn spoiled_answers_on_bodies_of_revolution_are_refused_by_name() {
    let (truth, _, run) = solved();
    let text = pressures(&run, 1.0, 1.0);
    let third = text.lines().take(8).collect::<Vec<_>>().join("\n");
    let mirrored = text.clone() + "-0.5,0\n";
    let strange = text.replacen(",1", ",NaN", 1);
    for (text, says) in [
        (third, "stop at"),
        (mirrored, "radii from the axis on"),
        (strange, "no number"),
        (text.replace("[MPa]", "[N/mm]"), "the unit `N/mm`"),
        (forces(&run, |_, force| force).replace("[N]", "[N/mm]"), "the unit `N/mm`"),
    ] {
        let read = handed::read(&truth.case, "theirs.csv", text, &Asked::default());
        refused(read.and_then(|answer| verdicts(&truth, answer, ENGINEERING)), &[says]);
    }
}

#[test]
fn exported_decks_of_revolution_have_whole_loads_and_give_whole_forces() {
    let (truth, discretisation, run) = solved();
    let text = deck::text(&discretisation).expect("a deck");
    assert!(text.contains("TYPE=CAX8") && !text.contains("TYPE=CP"), "cells of revolution");
    assert!(text.contains("*NSET, NSET=AXIS_SPHERE") && text.contains("AXIS_SPHERE, 1, 1"), "the axis stays");
    let loads = text.lines().skip_while(|line| *line != "*CLOAD").skip(1).take_while(|line| !line.starts_with('*'));
    let whole: f64 =
        loads.map(|line| line.rsplit(", ").next().expect("a force").parse::<f64>().expect("a number")).sum();
    assert_relative_eq!(whole, -750.0, max_relative = 1e-9);
    // What ccx prints of the set behind the gap elements: reactions of a sector of 2°, that of the axis first.
    let set = "GAPS_SPHERE_ON_RIGID";
    let listed = text.lines().skip_while(|line| *line != format!("*NSET, NSET={set}")).skip(1);
    let numbers = listed.take_while(|line| !line.starts_with('*')).map(|line| line.trim_end_matches(','));
    let own = std::iter::once(0.0).chain(run.solution.points_of(0).iter().map(|point| point.weight * point.pressure));
    let numbers = numbers.map(|number| number.parse().expect("a node"));
    let table = foreign::forces(set, "0.1000000E+01", numbers.zip(own.map(|force| -force / 180.0)));
    let answer = calculix::forces(Path::new("s.dat"), &table, &text, &truth.case.scene, &Asked::default());
    let found = judged(&truth, answer.expect("read"));
    assert!(found.met() && found.mistakes.is_empty(), "{:?}", failed(&found));
    assert_relative_eq!(found.ruled[0].measures.resultant, 750.0, max_relative = 1e-9);
}

/// A torus of 200 mm about the axis on a rigid plane.
const TORUS: &str = "plane = \"axisymmetric\"\n[[body]]\nname = \"torus\"\nyoung = 210e3\npoisson = 0.3\n\
     shape = { disc = { centre = [200, 5], radius = 5 } }\nloads = [{ traction = { at = \"cut\", force = [0, -1.6e6] } \
     }]\n\
     [contact]\nfirst = \"torus\"\norigin = [200, 0]\nboth-sides = true\ngap = { circle = 5 }\nstretch = 0.38\n\
     [mesh]\nelements = 12\nper = 0.2\n";

#[test]
fn gap_elements_of_rings_are_as_stiff_as_the_arcs_of_their_sector() {
    for (case, off_axis) in [(parsed(TORUS), 200.0), (sphere(), 0.0)] {
        let (length, young) = (case.scene.reference.length, case.scene.bodies[0].material.young);
        let text = deck::text(&case.meshed().expect("meshed").discretisation).expect("a deck");
        let deck = blocks(&text);
        let nodes =
            deck.iter().filter(|(head, _)| ["NODE", "NODE, NSET=ALL"].contains(head)).flat_map(|(_, rows)| rows);
        let radii: BTreeMap<&str, f64> = nodes.map(|row| (row[0], row[1].parse().expect("a radius"))).collect();
        let gaps = deck.iter().filter_map(|(head, rows)| Some((head.strip_prefix("GAP, ELSET=GAP")?, rows)));
        let springs: Vec<(f64, f64)> =
            gaps.map(|(node, rows)| (radii[node], rows[0][5].parse().expect("a stiffness"))).collect();
        assert!(
            springs.len() > 20 && springs.iter().all(|(radius, _)| (radius - off_axis).abs() <= 1.0),
            "{springs:?}"
        );
        for (radius, stiffness) in springs {
            // Within the reference length the whole circle is no shorter than twice that.
            let arc = 2f64.to_radians() * radius.max(length / PI);
            assert_relative_eq!(stiffness, 1e4 * young * arc, max_relative = 1e-6);
        }
    }
}

#[test]
fn a_torus_far_off_the_axis_is_solved_by_calculix_where_it_is_installed() {
    let folder = Folder::made();
    let truth = Truth::of(parsed(TORUS)).expect("solved");
    let discretisation = truth.case.meshed().expect("meshed").discretisation;
    folder.with("torus.inp", deck::text(&discretisation).expect("a deck"));
    if ccx(folder.path(), "torus").is_none() {
        return;
    }
    let answer = read::read(&folder.path().join("torus.dat"), &truth.case, &Asked::default()).expect("read");
    let found = judged(&truth, answer);
    assert!(found.met() && found.mistakes.is_empty(), "{:?}", failed(&found));
    // Springs as soft as those of a punch as wide as the reference length make it 2.5 % wider.
    let (theirs, ours) = (&found.ruled[0].measures, &truth.run.contacts[0].measures);
    assert_relative_eq!(theirs.second_moment_width, ours.second_moment_width, max_relative = 1e-3);
    // Of displacements as ccx writes them in the plane it is 1.3 % more.
    let energy = found.ruled[0].judged.iter().find(|one| one.check.quantity.to_string().starts_with("strain energy"));
    assert!(energy.expect("an energy").error <= 3e-4, "{energy:?}");
}

#[test]
fn export_writes_of_bodies_of_revolution_what_can_solve_them_alone() {
    let files = export::files(&sphere(), true).expect("exported");
    let named = |name: &str| files.iter().find(|(own, ..)| own == name);
    for plane_alone in ["run_getfem.py", "run_sfepy.py", "run_kratos.py", "run_felupe.py", "run_calculix.py"] {
        assert!(named(plane_alone).is_none(), "{plane_alone}");
    }
    let (.., what) = named("run_revolution.py").expect("a script");
    assert!(what.contains("scikit-fem, dolfinx, FElupe, NGSolve or CalculiX"));
    // Its form for NGSolve stands on that of plane scenes.
    assert!(named("run_ngsolve.py").is_some());
    let problem: serde_json::Value =
        serde_json::from_slice(&named("problem.json").expect("a problem").1).expect("JSON");
    assert_eq!(problem["plane"], "axisymmetric");
    let nodes = problem["contacts"][0]["nodes"].as_array().expect("nodes");
    let area: f64 = nodes.iter().map(|node| node["area"].as_f64().expect("an area")).sum();
    assert_relative_eq!(area, PI, max_relative = 1e-4);
    // The node on the axis has no area, and no other side.
    assert!(nodes[0]["gap"].is_null() && nodes[1]["gap"].is_number());
    let force: f64 = problem["forces"].as_array().expect("forces").iter().map(|row| row[2].as_f64().expect("N")).sum();
    assert_relative_eq!(force, -750.0, max_relative = 1e-9);
    let sheet = String::from_utf8(files[0].1.clone()).expect("text");
    assert!(sheet.contains("whole forces") && sheet.contains("2πr") && sheet.contains("coord_type = RZ"));
    let of_force = |line: &&str| line.contains("resultant") || line.contains("reaction");
    assert!(
        !sheet.contains("per thickness") && !sheet.lines().filter(of_force).any(|line| line.contains("N/mm")),
        "{sheet}"
    );
}

/// A file of one cell with displacements, as ccx writes it.
fn file_of(cell: &str, nodes: impl IntoIterator<Item = [[f64; 3]; 2]>) -> Source<'static> {
    let [mut places, mut moved] = [const { String::new() }; 2];
    let mut count = 0;
    for (k, [place, vector]) in nodes.into_iter().enumerate() {
        places += &record(k + 1, &fixed(place));
        moved += &record(k + 1, &fixed(vector));
        count = k + 1;
    }
    let text = format!(
        "    1C\n    2C{count:>30}                                     1\n{places} -3\n    \
        3C                             1\n{cell} -3\n\
        \x20 100CL  101 1.000000000{count:>12}                     0    1           1\n -4  DISP        4    1\n -5  \
        D1          1    2    1    0\n\
        \x20-5  D2          1    2    2    0\n -5  D3          1    2    3    0\n -5  ALL         1    2    0    0    \
        1ALL\n{moved} -3\n 9999\n"
    );
    Source { file: Path::new("one.frd"), text: text.leak() }
}

/// Corners of a cell about the axis.
const CORNERS: [[f64; 2]; 4] = [[5.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0]];

/// The cell with OUTPUT=3D: nodes at −1° and 1°.
fn sector(stretch: f64) -> Source<'static> {
    let node = |[r, y]: [f64; 2], angle: f64| {
        let [x, z] = [r * angle.cos(), r * angle.sin()];
        [[x, y, z], [stretch * x, 0.0, stretch * z]]
    };
    let angle = 1f64.to_radians();
    let nodes = CORNERS.into_iter().flat_map(|corner| [-angle, angle].map(|angle| node(corner, angle)));
    file_of(&cell_of(1, 1, &[1, 3, 5, 7, 2, 4, 6, 8]), nodes)
}

/// The cell of 8 nodes with OUTPUT=2D: means along x over the sector, in which corners have a node in the middle and
/// mid-sides have none.
fn section(stretch: f64) -> Source<'static> {
    let ends = 1f64.to_radians().cos();
    let node = |[r, y]: [f64; 2], part: f64| [[r, y, 1e-17 * r], [stretch * r * part, 0.0, 1e-21]];
    let mids = [[7.5, 0.0], [10.0, 2.5], [7.5, 5.0], [5.0, 2.5]].map(|mid| node(mid, ends));
    let nodes = CORNERS.map(|corner| node(corner, (ends + 4.0 + ends) / 6.0)).into_iter().chain(mids);
    file_of(&cell_of(1, 10, &[1, 2, 3, 4, 5, 6, 7, 8]), nodes)
}

#[test]
fn sectors_of_ccx_are_turned_into_the_plane() {
    let case = sphere();
    for (source, count) in [(sector(0.01), 4), (section(0.01), 8)] {
        // Places of a deck are more exact than those of the file, and say nothing where they are others.
        let deck = BTreeMap::from([(1, [5.00001, 0.0]), (2, [30.0, 0.0])]);
        let field = frd::displacements((&source, &case.scene), &moved(), (None, &deck), None);
        let field = field.expect("read").expect("a field");
        assert_eq!((field.points.len(), field.cells.len()), (count, 1));
        for (point, moved) in field.points.iter().zip(&field.displacement) {
            assert_relative_eq!(moved[0], 0.01 * point[0], max_relative = 5e-6);
            assert!(moved[1].abs() <= 1e-12 && [5.0, 7.5, 10.0].iter().any(|r| (point[0] - r).abs() <= 1e-4));
        }
        assert!(field.points.iter().any(|point| (point[0] - 5.00001).abs() <= 1e-9), "{:?}", field.points);
    }
}

/// A node on the axis has no area, and a force of 0 whatever presses there: answers that leave it out are as right as
/// those that have it.
#[test]
fn nodes_without_that_on_the_axis_are_read_with_it() {
    let (truth, _, run) = solved();
    let all = forces(&run, |_, force| force);
    let text = all.replacen("\n0e0,0e0\n", "\n", 1);
    assert!(text != all, "{text}");
    let found = judged_as(&truth, "theirs.csv", &text, &by_nodes());
    assert!(found.met() && found.mistakes.is_empty(), "{:?}", failed(&found));
    // Where the order is not told they are taken for corners, and the order is named.
    let found = judged_as(&truth, "theirs.csv", &text, &Asked::default());
    assert!(!found.met() && found.mistakes.iter().any(|told| told.contains("--order 2")), "{:?}", found.mistakes);
    // Pressures have none there that anything could be made of either.
    let points = run.solution.points_of(0).iter().filter(|point| point.position > 0.0);
    let pressures =
        |factor: f64| table(PRESSURES, points.clone().map(|point| [point.position, factor * point.pressure]));
    let of_pressures = |factor| judged_as(&truth, "theirs.csv", &pressures(factor), &by_nodes());
    assert!(of_pressures(1.0).met() && !of_pressures(1.03).met(), "{:?}", failed(&of_pressures(1.0)));
    // Nodes that are lacking besides are not made up.
    let lines: Vec<&str> = text.lines().collect();
    let fewer = [&lines[..1], &lines[3..]].concat().join("\n") + "\n";
    refused(handed::read(&truth.case, "theirs.csv", fewer, &by_nodes()), &["no whole number of edges"]);
    // A corner that is lacking elsewhere is none of the axis.
    let spoiled: String =
        all.lines().enumerate().filter(|(k, _)| *k != 3).map(|(_, line)| format!("{line}\n")).collect();
    refused(handed::read(&truth.case, "theirs.csv", spoiled, &by_nodes()), &["no whole number of edges"]);
}

#[test]
fn nodal_forces_of_rings_that_are_those_of_a_sector_are_named() {
    let truth = Truth::of(parsed(TORUS)).expect("solved");
    let run = truth.case.solve().expect("solved").1;
    let own = run.solution.points_of(0).iter().map(|point| [point.position, point.weight * point.pressure]);
    let own: Vec<[f64; 2]> = own.collect();
    for (by, says) in [
        (TAU, "2π is forgotten"),
        (360.0, "sector of 1°"),
        (180.0, "sector of 2°"),
        (4.0, "sector of 90°"),
        (2.0, "sector of 180°"),
    ] {
        let text = table("position [mm],force [N]", own.iter().map(|[place, force]| [*place, force / by]));
        let found = judged_as(&truth, "theirs.csv", &text, &by_nodes());
        assert!(!found.met() && found.mistakes.iter().any(|told| told.contains(says)), "{says}: {:?}", found.mistakes);
    }
}
