//! What is exported is the case: its mesh for Gmsh is read back as it was, and its answers are judged as what `solve`
//! says.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output};

use contact_vv::case::Case;
use contact_vv::case::library::{NAMES, find};
use contact_vv::checkout::root;
use contact_vv::cli::new::Template;
use contact_vv::cli::vtu;
use contact_vv::elasticity::loads;
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::referee::export::{deck, gmsh};
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::{Asked, Truth, read, verdicts};
use contact_vv::scene::{Load, Place, Shape};
use contact_vv::solve::{Discretisation, Formulation, Run};
use contact_vv::study::described;

use crate::balance::{self, solved, text};
use crate::handed::{failed, judged_as, moved, read};
use crate::outputs::{contact_vv, refuses, scene};
use crate::program::Folder;
use crate::scene_file::text_of;
use crate::workbench::{every_case, parsed, refused, truth};

/// A scene file of one body of an exported mesh, held by nothing: it is only read.
fn scene_of([body, contact]: [&str; 2], file: &str, path: &str) -> String {
    format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"{body}\"\nyoung = 1000\npoisson = 0.3\n\
         shape = {{ mesh = {{ file = \"{file}\", group = \"{body}\", contact = \"{contact}\" }} }}\n\
         [contact]\nfirst = \"{body}\"\ngap = {{ uniform = 0 }}\ngap-only = true\n{path}\nstretch = \
         1e-1\n[reference]\npressure = 5\n"
    )
}

#[test]
fn surfaces_of_an_exported_mesh_are_bounded_by_the_sides_of_their_bodies() {
    let case = find("pin-rod", None).expect("a case");
    let mesh = Mesh::of(&case.scene, case.resolution).expect("meshed");
    let (text, numbers) = (gmsh::text(&case.scene, &mesh), gmsh::numbers(&case.scene, &mesh));
    let (_, entities) = text.split_once("$Entities\n").expect("entities");
    let sides = numbers.len() - case.scene.bodies.len();
    // Behind the head and the sides: a tag, a box of six numbers, one group, then how many sides and which.
    for (body, line) in case.scene.bodies.iter().zip(entities.lines().skip(1 + sides)) {
        let bounds: Vec<usize> = line.split(' ').skip(10).map(|word| word.parse().expect("a side")).collect();
        let own = numbers[..sides].iter().filter(|(name, _)| name.starts_with(&format!("{} ", body.name)));
        assert_eq!(bounds, own.map(|(_, number)| *number).collect::<Vec<_>>(), "{line}");
    }
}

#[test]
fn exported_meshes_are_read_back_by_our_own_gmsh_reader_as_they_were() {
    let folder = Folder::made();
    for (name, _) in NAMES {
        for order in [Order::Linear, Order::Quadratic, Order::Biquadratic] {
            let case = find(name, None).expect("a case");
            let mesh = Mesh::of(&case.scene, Resolution { order, ..case.resolution }).expect("meshed");
            folder.with("mesh.msh", gmsh::text(&case.scene, &mesh));
            for (body, part) in case.scene.bodies.iter().zip(&mesh.bodies) {
                let nodes = part.boundaries["contact"].iter().flatten().map(|&node| mesh.points[node]);
                let path = &case.scene.contact().path;
                let along = |point: &[f64; 2]| path.coordinate(*point);
                let origin = nodes.min_by(|a, b| along(a).total_cmp(&along(b))).expect("a side");
                let ([x, y], depth) = (path.origin(), path.depth(origin));
                let path = match path.is_straight() {
                    true => format!("origin = {origin:?}"),
                    false => format!("arc = {{ centre = [{x}, {y}], radius = {depth} }}"),
                };
                let contact = format!("{} contact", body.name);
                let text = scene_of([&body.name, &contact], "mesh.msh", &path);
                let read = Case::parse(&folder.path().join("scene.toml"), &text).expect("read");
                let Shape::Given(given) = &read.scene.bodies[0].shape else { panic!("{name}: no mesh") };
                assert_eq!(given.cells.len(), part.cells.len(), "{name}");
                for (cell, own) in part.cells.clone().zip(&given.cells) {
                    let wanted: Vec<[f64; 2]> = mesh.cell(cell).iter().map(|&node| mesh.points[node]).collect();
                    let found: Vec<[f64; 2]> = own.iter().map(|&node| given.points[node]).collect();
                    assert_eq!(found, wanted, "{name}, `{}`, cell {cell}", body.name);
                }
                assert_eq!(given.points.len(), part.nodes.len(), "{name}");
                for (side, edges) in part.boundaries.iter().chain(&part.lines).filter(|(_, edges)| !edges.is_empty()) {
                    let found = &given.boundaries[format!("{} {side}", body.name).as_str()];
                    let ends = |points: &[[f64; 2]], edges: &[Vec<usize>]| {
                        let mut all: Vec<String> =
                            edges.iter().flatten().map(|&node| format!("{:?}", points[node])).collect();
                        all.sort();
                        all
                    };
                    assert_eq!(ends(&given.points, found), ends(&mesh.points, edges), "{name}, {side}");
                }
            }
        }
    }
}

#[test]
fn exported_deck_is_read_back_with_all_that_joins_its_nodes() {
    let folder = Folder::made();
    let case = find("cylinder", None).expect("a case");
    let discretisation = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    folder.with("mesh.inp", deck::text(&discretisation).expect("written"));
    let text = scene_of(["CYLINDER", "S_CYLINDER_CONTACT"], "mesh.inp", "arc = { centre = [0, 50], radius = 50 }");
    let read = Case::parse(&folder.path().join("scene.toml"), &text).expect("read");
    let Shape::Given(given) = &read.scene.bodies[0].shape else { panic!("no mesh") };
    let mesh = &discretisation.mesh;
    assert_eq!((given.cells.len(), given.points.len()), (mesh.cells(), mesh.points.len()));
    for (cell, own) in given.cells.iter().enumerate() {
        for (&node, &wanted) in own.iter().zip(mesh.cell(cell)) {
            let [found, wanted] = [given.points[node], mesh.points[wanted]];
            assert!((0..2).all(|k| (found[k] - wanted[k]).abs() < 1e-9), "cell {cell}: {found:?}, {wanted:?}");
        }
    }
    let contact = &mesh.bodies[0].boundaries["contact"];
    assert_eq!(given.boundaries["S_CYLINDER_CONTACT"].len(), contact.len());
}

#[test]
fn pressures_of_every_case_and_scene_file_are_read_back_from_our_own_fields() {
    for case in every_case() {
        let name = &case.name;
        let (discretisation, run) = solved(&case, &Formulation::verification());
        let text = vtu::text(&discretisation, &run).expect("written");
        let answer = read(&case, "ours.vtu", text, &moved()).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(answer.contacts.len(), case.scene.contacts.len(), "{name}");
        for (contact, handed) in answer.contacts.iter().enumerate() {
            let ours = run.solution.points_of(contact);
            // The node on the axis of a body of revolution has a pressure, but no area, and is no contact point.
            let on_axis = usize::from(case.scene.is_around_axis(contact));
            assert_eq!(handed.points.len(), ours.len() + on_axis, "{name}, contact {contact}");
            let largest = ours.iter().map(|point| point.pressure.abs()).fold(0.0, f64::max);
            for (theirs, ours) in handed.points[on_axis..].iter().zip(ours) {
                let stretch = case.scene.contacts[contact].stretch;
                assert!((theirs.position - ours.position).abs() <= 1e-9 * stretch, "{name}: {theirs:?} {ours:?}");
                assert!((theirs.value - ours.pressure).abs() <= 1e-9 * largest, "{name}: {theirs:?} {ours:?}");
            }
        }
    }
}

#[test]
fn pressures_of_stresses_and_gaps_of_displacements_are_taken_where_no_field_tells_them() {
    let case = find("cylinder", None).expect("a case");
    let (discretisation, run) = solved(&case, &Formulation::verification());
    let truth = truth("cylinder");
    let text = vtu::text(&discretisation, &run).expect("written").replace("contact_gap", "other");
    let found = judged_as(truth, "ours.vtu", &text, &moved());
    assert!(found.met(), "{:?}", failed(&found));
    let all: Vec<String> = found.ruled[0].judged.iter().map(|one| one.check.quantity.to_string()).collect();
    assert!(all.iter().any(|name| name.contains("penetration")), "{all:?}");
    // Displacements without their load leave the bodies apart.
    let apart = text.replace("displacement", "another");
    let apart = judged_as(truth, "ours.vtu", &apart, &moved());
    assert!(apart.ruled[0].missing.iter().any(|[what, _]| what.contains("penetration")));
    let nothing = text.replace("contact_pressure", "another");
    let read = read(&truth.case, "ours.vtu", nothing, &moved());
    refused(read, &["no nodal field is called contact_pressure", "von_mises"]);
}

#[test]
fn export_writes_all_that_is_needed_and_its_answers_are_met() {
    let folder = Folder::made();
    let scene = scene("cylinder-on-block");
    for (case, stem) in [("cylinder", "cylinder"), (scene.as_str(), "cylinder-on-block")] {
        let to = folder.at(stem);
        let (sound, printed, error) = contact_vv(&["export", case, &to]);
        assert!(sound, "{error}");
        for name in [".md", ".msh", ".inp", ".vtu"].map(|end| format!("{stem}{end}")) {
            assert!(printed.contains(&name) && Path::new(&to).join(&name).is_file(), "{name}: {printed}");
        }
        let [json, csv, empty] = ["ours.json", "ours.csv", "answer.json"].map(|name| format!("{to}/{name}"));
        let (sound, table, error) = contact_vv(&["judge", case, &json, &csv, "--order", "2"]);
        assert!(sound && table.matches("meets all").count() == 2, "{table}{error}");
        refuses(&["judge", case, &empty], &["neither pressures nor forces"]);
    }
}

#[test]
fn files_of_a_scene_whose_name_no_code_can_type_are_called_case() {
    let folder = Folder::made();
    let (scene, to) = (folder.with("цилиндр.toml", Template::Cylinder.text()), folder.at("to"));
    let (sound, printed, error) = contact_vv(&["export", &scene, &to]);
    assert!(sound && printed.contains("case.inp") && !printed.contains("/-"), "{printed}{error}");
    let (sound, table, error) = contact_vv(&["judge", &scene, &format!("{to}/ours.csv")]);
    assert!(sound && table.contains("meets all"), "{table}{error}");
}

#[test]
fn our_answer_to_contacts_along_an_arc_and_a_line_is_read_back_in_their_own_units() {
    let folder = Folder::made();
    let (scene, to) = (folder.with("mixed.toml", text("arc-and-line")), folder.at("to"));
    let (sound, _, error) = contact_vv(&["export", &scene, &to]);
    assert!(sound, "{error}");
    for (name, options) in [("ours.json", &[][..]), ("ours.csv", &["--order", "2"])] {
        let (sound, table, error) = contact_vv(&[&["judge", &scene, &format!("{to}/{name}")], options].concat());
        assert!(sound && table.contains("meets all") && table.contains("contact `ü`"), "{name}: {table}{error}");
    }
    refuses(&["judge", &scene, &format!("{to}/answer.json")], &["neither pressures nor forces"]);
}

#[test]
fn bodies_and_contacts_whose_names_a_deck_cannot_tell_apart_have_their_numbers_in_it() {
    let case = balance::scene("arc-and-line", &[]);
    let discretisation = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    let text = deck::text(&discretisation).expect("written");
    let deck = blocks(&text);
    let named = |begin: &str| {
        let heads = deck.iter().filter_map(|(head, _)| head.strip_prefix(begin));
        heads.map(str::to_owned).collect::<Vec<String>>()
    };
    let [mut materials, mut sets] = ["MATERIAL, NAME=", "NSET, NSET="].map(named);
    // Three bodies, and the material that none is of; a body called as the set of the springs is none of these.
    assert_eq!(materials.len(), 4);
    assert!(named("ELEMENT, TYPE=CPS8, ELSET=").iter().all(|name| name != "WEAK" && materials.contains(name)));
    for all in [&mut materials, &mut sets] {
        let count = all.len();
        all.sort();
        all.dedup();
        assert_eq!(all.len(), count, "{all:?}");
    }
    // Lamé's pressure of the rings, plane stress, and N/A of the block: 2 · 1000 N on 2 · 20 mm².
    let folder = Folder::made();
    folder.with("mixed.inp", text);
    if ccx(folder.path(), "mixed").is_none() {
        return;
    }
    let answer = read::read(&folder.path().join("mixed.dat"), &case, &Asked::default()).expect("read");
    let found = verdicts(&Truth::of(case).expect("solved"), answer, ENGINEERING).expect("judged");
    let bore = |r: f64, outer: f64| (outer * outer + r * r) / (outer * outer - r * r);
    let compliance = 40.0 * ((bore(40.0, 55.0) + 0.34) / 120e3 + (bore(20.0, 40.0) - 0.3) / 210e3);
    for (ruled, peak) in found.ruled.iter().zip([0.02 / compliance, 50.0]) {
        let own = ruled.measures.peak.pressure;
        assert!((own - peak).abs() <= 1e-3 * peak, "{own} for {peak}");
    }
    assert!(found.ruled.len() == 2 && found.met(), "{:?}", failed(&found));
}

/// The blocks of a deck: a keyword with its options, and rows of words.
pub fn blocks(deck: &str) -> Vec<(&str, Vec<Vec<&str>>)> {
    let mut all: Vec<(&str, Vec<Vec<&str>>)> = Vec::new();
    for line in deck.lines().filter(|line| !line.starts_with("**")) {
        match (line.strip_prefix('*'), all.last_mut()) {
            (Some(head), _) => all.push((head, vec![])),
            (None, last) => last.expect("a keyword").1.push(line.split(',').map(str::trim).collect()),
        }
    }
    all
}

fn number<T: std::str::FromStr>(word: &str) -> T {
    word.parse().unwrap_or_else(|_| panic!("`{word}` is no number"))
}

/// A number of every node, from 1 on, and component that a deck prescribes: displacements, or forces.
fn prescribed(deck: &[(&str, Vec<Vec<&str>>)], keyword: &str) -> BTreeMap<[usize; 2], f64> {
    let nodes = |name: &str| {
        let set = deck.iter().find(|(head, _)| *head == format!("NSET, NSET={name}"));
        set.map_or_else(
            || vec![number(name)],
            |(_, rows)| rows.iter().map(|row| number(row[0])).collect::<Vec<usize>>(),
        )
    };
    let mut all = BTreeMap::new();
    for row in deck.iter().filter(|(head, _)| *head == keyword).flat_map(|(_, rows)| rows) {
        let (last, value) = if keyword == "CLOAD" { (1, 2) } else { (2, 3) };
        let value = row.get(value).map_or(0.0, |word| number(word));
        for axis in number::<usize>(row[1])..=number(row[last]) {
            all.extend(nodes(row[0]).into_iter().map(|node| ([node, axis], value)));
        }
    }
    all
}

#[test]
fn a_deck_in_plane_stress_is_as_thin_as_its_contact_nodes_are_near() {
    // 16 elements on 0.8 mm, each with a corner and a middle; the contacts lie off x = 0.
    let text = text_of("plate-on-two-supports.toml").replace("plane = \"strain\"", "plane = \"stress\"");
    let case = parsed(&text);
    let text = deck::text(&Discretisation::of(case.scene, case.resolution).expect("meshed")).expect("written");
    let deck = blocks(&text);
    let (_, rows) = deck.iter().find(|(head, _)| head.starts_with("SOLID SECTION")).expect("a section");
    assert!((number::<f64>(rows[0][0]) - 0.025).abs() <= 1e-9, "{rows:?}");
}

#[test]
fn exported_decks_prescribe_what_the_scene_does_and_their_equations_hold_of_our_own_displacements() {
    for case in every_case() {
        let order = case.resolution.order.min(Order::Quadratic);
        let on = Discretisation::of(case.scene.clone(), Resolution { order, ..case.resolution }).expect("meshed");
        // Those of bodies of revolution have sectors, and claims of their own.
        let Ok(text) = deck::text(&on) else { continue };
        if case.scene.is_of_revolution() {
            continue;
        }
        let (scene, name, count, deck) = (&case.scene, &case.name, on.mesh.points.len(), blocks(&text));
        let rows = |begin: &'static str| {
            deck.iter().filter(move |(head, _)| head.starts_with(begin)).flat_map(|(_, rows)| rows)
        };
        let run = Run::of(&on, &Formulation::verification()).expect("solved");
        let moved = on.displacement_under(run.share(), &run.solution);
        let [mut held, mut forces] = [const { BTreeMap::new() }; 2];
        let near = |a: f64, b: f64, size: f64| assert!((a - b).abs() <= 1e-8 * size, "{name}: {a} for {b}");
        // A contact node follows the approach of both sides, and a gap element lies between it and a fixed node.
        let size = moved.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut follow: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        for (_, terms) in deck.iter().filter(|(head, _)| *head == "EQUATION") {
            assert_eq!(terms.len() - 1, number::<usize>(terms[0][0]), "{name}");
            let terms = || {
                terms[1..].iter().map(|row| (number::<usize>(row[0]), number::<usize>(row[1]), number::<f64>(row[2])))
            };
            let (own, _, factor) = terms().find(|(node, ..)| *node > count).expect("a node beside the mesh");
            let sum: f64 = terms()
                .filter(|(node, ..)| *node <= count)
                .map(|(node, axis, one)| one * moved[node - 1][axis - 1])
                .sum();
            follow.entry(own).or_default().push(0.0 - sum / factor);
        }
        let (stiffness, springs) = (rows("GAP,").map(|row| number::<f64>(row[5])), rows("SPRING,").collect::<Vec<_>>());
        let young = scene.bodies.iter().map(|body| body.material.young).fold(0.0, f64::max);
        stiffness.for_each(|own| near(own, 1e4 * young * scene.thickness, 100.0 * own));
        let gaps: Vec<(usize, f64)> = deck
            .iter()
            .filter_map(|(head, rows)| Some((number(head.strip_prefix("GAP, ELSET=GAP")?), number(rows[0][0]))))
            .collect();
        let mut gap = gaps.iter();
        let mut sprung = 0;
        for (contact, interface) in on.interfaces.iter().enumerate() {
            let own =
                interface.nodes.iter().zip(run.solution.points_of(contact)).filter(|(node, _)| node.gap.is_finite());
            for (node, point) in own {
                let (of, width) = *gap.next().expect("a gap element");
                near(width, node.gap, node.gap.abs());
                near(follow.remove(&of).expect("an equation")[0], node.gap - point.gap, size);
                held.extend([[of, 2], [of, 3], [of + 1, 1], [of + 1, 2], [of + 1, 3]].map(|key| (key, 0.0)));
                sprung += usize::from(interface.nodes.iter().all(|node| node.gap > 0.0));
            }
        }
        assert!(gap.next().is_none() && rows("ELEMENT, TYPE=SPRING1").count() == sprung, "{name}");
        assert_eq!(springs.is_empty(), sprung == 0, "{name}");
        springs
            .iter()
            .skip(1)
            .for_each(|row| near(number(row[0]), 1e-7 * young * scene.thickness, 1e-7 * young * 100.0));
        for (index, body) in scene.bodies.iter().enumerate() {
            for support in &body.supports {
                let nodes = on.mesh.nodes_at(scene, index, &support.at).expect("nodes");
                held.extend(nodes.into_iter().map(|node| ([node + 1, support.component.index() + 1], support.value)));
            }
            for (node, force) in
                on.mesh.bodies[index].nodes.clone().zip(loads::at_nodes(scene, &on.mesh, index).expect("loads"))
            {
                forces.extend(
                    [0, 1].map(|axis| ([node + 1, axis + 1], force[axis])).into_iter().filter(|(_, x)| x.abs() > 0.0),
                );
            }
            for load in &body.loads {
                let Load::RigidFace { boundary, component, force } = load else { continue };
                let nodes = on.mesh.nodes_at(scene, index, &Place::Boundary(boundary.clone())).expect("nodes");
                let (common, all) = follow.pop_first().expect("a node that the face follows");
                all.iter().for_each(|one| near(*one, moved[nodes[0]][component.index()], size));
                held.insert([common, 2 - component.index()], 0.0);
                forces.insert([common, component.index() + 1], *force);
            }
        }
        for (keyword, wanted) in [("BOUNDARY", held), ("CLOAD", forces)] {
            let found = prescribed(&deck, keyword);
            assert!(found.keys().eq(wanted.keys()), "{name}, {keyword}");
            found.values().zip(wanted.values()).for_each(|(a, b)| near(*a, *b, b.abs()));
        }
        // Every node and element has a number of its own, from 1 on.
        for keyword in ["NODE", "ELEMENT"] {
            let own = deck.iter().filter(|(head, _)| head.split(',').next() == Some(keyword));
            let mut numbers: Vec<usize> = own.flat_map(|(_, rows)| rows).map(|row| number(row[0])).collect();
            numbers.sort_unstable();
            assert!(numbers.iter().copied().eq(1..=numbers.len()), "{name}, {keyword}");
        }
    }
}

/// What ccx prints of a deck; none where it is not installed.
pub fn ccx(folder: &Path, job: &str) -> Option<()> {
    let run = Command::new("ccx").arg(job).current_dir(folder).env("OMP_NUM_THREADS", "1").output().ok()?;
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(said.contains("Job finished"), "{said}");
    Some(())
}

#[test]
fn exported_decks_are_solved_by_calculix_where_it_is_installed_and_meet_the_truth() {
    let folder = Folder::made();
    // Of cells much smaller than the thickness in plane stress; of a body that nothing holds before the first contact.
    for (name, coarser) in [("cylinder", 1), ("bars", 1), ("patch", 1), ("rigid-pin", 4)] {
        let truth = truth(name);
        let elements = truth.case.resolution.elements / coarser;
        let resolution = Resolution { elements, ..truth.case.resolution };
        let discretisation = Discretisation::of(truth.case.scene.clone(), resolution).expect("meshed");
        folder.with(&format!("{name}.inp"), deck::text(&discretisation).expect("written"));
        if ccx(folder.path(), name).is_none() {
            return;
        }
        let file = folder.path().join(format!("{name}.dat"));
        let answer = read::read(&file, &truth.case, &Asked::default()).expect("read");
        let found = verdicts(truth, answer, ENGINEERING).expect("judged");
        assert!(found.met(), "{name}: {:?}", failed(&found));
    }
}

#[test]
fn exported_scripts_solve_the_case_where_their_codes_are_installed_and_meet_its_truth() {
    let mixed = Truth::of(balance::scene("pin-in-a-ring-on-a-plane", &[])).expect("a truth");
    let hertz = [("run_getfem.py", "basic"), ("run_dolfinx.py", "active-set"), ("run_calculix.py", "gaps")];
    let solved = [truth("truncated-hertz"), &mixed]
        .into_iter()
        .zip([&hertz[..], &[("run_dolfinx.py", "active-set"), ("run_scikit_fem.py", "active-set")]]);
    for (truth, scripts) in solved {
        let folder = exported(&truth.case);
        for (script, method) in scripts {
            let Some(run) = run(&folder, script, method) else { continue };
            let told: serde_json::Value = serde_json::from_slice(&run.stdout)
                .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&run.stderr)));
            let file = folder.path().join(told["file"].as_str().expect("a file"));
            let answer = read::read(&file, &truth.case, &Asked::default()).expect("read");
            assert!(verdicts(truth, answer, ENGINEERING).expect("judged").met(), "{script}");
        }
    }
}

/// What is exported of a case, in a folder.
fn exported(case: &Case) -> Folder {
    let folder = Folder::made();
    for (name, text, _) in contact_vv::cli::export::files(case, false).expect("exported") {
        folder.with(&name, text);
    }
    folder
}

/// What a script of a folder ends with by a method; none where its code is not installed, by exit code 3.
fn run(folder: &Folder, script: &str, method: &str) -> Option<Output> {
    let mut run = Command::new("/usr/bin/python3");
    run.arg("-sB").env("PYTHONPATH", root().join("oracles/.python/site"));
    run.arg(folder.path().join(script)).arg(folder.path()).arg(method);
    run.output().ok().filter(|run| run.status.code() != Some(3))
}

#[test]
fn scripts_of_codes_that_find_gaps_themselves_refuse_those_that_meshes_do_not_have() {
    // An interference of two rings that are drawn as they touch.
    let folder = exported(&truth("press-fit-strain").case);
    for (script, method) in [("run_calculix.py", "pair"), ("run_getfem.py", "integral")] {
        let Some(run) = run(&folder, script, method) else { continue };
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(!run.status.success() && said.contains("takes them from the file"), "{script}: {said}");
    }
}

#[test]
fn codes_in_plane_strain_are_told_the_plane_stress_of_a_scene_and_the_sides_of_its_contact_by_number() {
    let case = Case::read(&root().join("tests/cases/press-fit.toml")).expect("a case");
    let mesh = Mesh::of(&case.scene, case.resolution).expect("meshed");
    let told = described::elsewhere("press-fit", &case.scene, &mesh);
    let after = |before: &str, from: &str| -> f64 {
        let (_, rest) = told.split_once(from).unwrap_or_else(|| panic!("{from}: {told}"));
        let (_, rest) = rest.split_once(before).unwrap_or_else(|| panic!("{before}: {rest}"));
        let own = rest.split(|mark: char| mark.is_whitespace() || ",;".contains(mark)).next();
        own.and_then(|word| word.trim_end_matches('.').parse().ok()).unwrap_or_else(|| panic!("{before}: {rest:.40}"))
    };
    for body in &case.scene.bodies {
        // Plane stress is σ_x = E/(1 − ν²) (ε_x + ν ε_y), plane strain (λ + 2μ) ε_x + λ ε_y; of that E = μ(3λ + 2μ)/(λ
        // + μ), ν = λ/2(λ + μ).
        let (young, poisson) = (body.material.young, body.material.poisson);
        let [lambda, shear] = [young * poisson / (1.0 - poisson * poisson), 0.5 * young / (1.0 + poisson)];
        let own = format!("`{}`: λ", body.name);
        assert!((after("= ", &own) - lambda).abs() <= 1e-3, "{told}");
        assert!((after("μ = ", &own) - shear).abs() <= 1e-3, "{told}");
        let of_moose = format!("[{}]\n    type = Compute", body.name);
        let wanted = [shear * (3.0 * lambda + 2.0 * shear) / (lambda + shear), 0.5 * lambda / (lambda + shear)];
        for (key, wanted) in ["youngs_modulus = ", "poissons_ratio = "].into_iter().zip(wanted) {
            assert!((after(key, &of_moose) / wanted - 1.0).abs() <= 1e-12, "{key}: {told}");
        }
    }
    let numbers = gmsh::numbers(&case.scene, &mesh);
    for (key, side) in [("secondary = ", "inner contact"), ("primary = ", "outer contact")] {
        let (_, number) = numbers.iter().find(|(name, _)| name == side).expect("a side");
        assert_eq!(after(key, "[Contact]") as usize, *number, "{side}");
    }
    let words = described::scene(&case.scene).concat();
    assert!(words.contains("counter-clockwise through 90 °") && words.contains("|s| ≤ 90 °"), "{words}");
}
