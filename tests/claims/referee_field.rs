//! Displacements that are handed in with their mesh are judged by equilibrium, energy and what a scene file declares.

use contact_vv::case::library::{NAMES, find};
use contact_vv::case::{Case, Verdict};
use contact_vv::cli::vtu;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::referee::answer::Point;
use contact_vv::referee::field::Field;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::side::Cell;
use contact_vv::referee::{Answer, Truth};
use contact_vv::solve::Discretisation;

use crate::handed::{failed, judged, moved, read};
use crate::scene_file::{self, text_of};
use crate::workbench::parsed;

/// Our own fields on the mesh of a case, as a text.
fn own(case: &Case) -> String {
    let (meshed, run) = case.solve().expect("solved");
    vtu::text(&meshed.discretisation, &run).expect("written")
}

fn answer(case: &Case, text: &str) -> Answer {
    read(case, "ours.vtu", text, &moved()).expect("read")
}

fn spoiled(truth: &Truth, text: &str, spoil: impl Fn(&mut Field)) -> Vec<String> {
    let mut answer = answer(&truth.case, text);
    spoil(answer.field.as_mut().expect("displacements"));
    failed(&judged(truth, answer))
}

#[test]
fn our_own_displacements_are_in_equilibrium_and_have_our_energy_on_every_case() {
    for (name, _) in NAMES {
        let truth = crate::workbench::truth(name);
        let text = own(&truth.case);
        let found = judged(truth, answer(&truth.case, &text));
        assert_eq!(failed(&found), Vec::<String>::new(), "{name}");
        let named = |part: &str| {
            let all = found.ruled[0].judged.iter();
            all.filter(|one| one.check.quantity.to_string().contains(part)).cloned().collect::<Vec<_>>()
        };
        // A force at a point: the pin's centre.
        let lost = found.ruled[0].missing.iter().any(|[_, why]| why.contains("force at a point"));
        assert_eq!(lost, name == "pin-plate", "{name}: {:?}", found.ruled[0].missing);
        assert_eq!(named("departure of the supports").len(), 1, "{name}");
        assert!(!named("stresses against").is_empty(), "{name}");
        let energy = named("strain energy").pop().expect("judged");
        assert_eq!(energy.verdict, Verdict::Pass, "{name}");
        if lost {
            // That of the plate is judged, and its own work.
            let scaled =
                spoiled(truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u *= 1.045));
            assert!(scaled.iter().any(|one| one.contains("strain energy")), "{scaled:?}");
            continue;
        }
        // It may be off by what it changes from our mesh to the finer one.
        let energies = &truth.exported.get().expect("solved").energies;
        let [fine, coarse] = [0, 1].map(|which| energies.iter().map(|own| own[which]).sum::<f64>());
        let allowed = ENGINEERING + (fine - coarse).abs() / fine;
        assert!((energy.check.tolerance - allowed).abs() <= 1e-9, "{name}: {}", energy.check.tolerance);
        // Its supports along x lie at x = 0, and the side that stays flat moves along y.
        if name == "pin-rod" {
            assert_eq!(named("stretched along x").len(), 1);
        }
    }
}

#[test]
fn displacements_that_are_wrong_are_found_by_equilibrium_and_energy() {
    let truth = crate::workbench::truth("cylinder");
    let text = own(&truth.case);
    let energy = |failed: &[String]| failed.iter().any(|one| one.contains("strain energy"));
    let balance = |failed: &[String]| failed.iter().any(|one| one.contains("stresses against loads and pressures"));
    let scaled = spoiled(truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u *= 1.03));
    assert!(energy(&scaled) && balance(&scaled), "{scaled:?}");
    let turned = spoiled(truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u = 0.0 - *u));
    assert!(balance(&turned), "{turned:?}");
    let poisson = spoiled(truth, &text, |field| field.displacement.iter_mut().for_each(|u| u[0] *= 1.1));
    assert!(balance(&poisson), "{poisson:?}");
    let none = spoiled(truth, &text, |field| field.displacement[700] = [f64::NAN; 2]);
    assert!(energy(&none) && balance(&none), "{none:?}");
    let one = spoiled(truth, &text, |field| field.displacement[700][1] += 0.05);
    assert!(energy(&one), "{one:?}");
}

/// The energy is even in the displacements, and of both bodies together nothing works where no load does.
#[test]
fn bodies_that_pull_apart_and_supports_that_move_are_found_without_any_load() {
    for (name, moved) in [("bars", true), ("press-fit", false)] {
        let truth = crate::workbench::truth(name);
        let text = own(&truth.case);
        let has = |failed: &[String], what: &str| failed.iter().any(|one| one.contains(what));
        let turned = spoiled(truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u = 0.0 - *u));
        assert!(has(&turned, "stresses against loads and pressures"), "{name}: {turned:?}");
        assert_eq!(has(&turned, "departure of the supports"), moved, "{name}: {turned:?}");
        let shifted =
            spoiled(truth, &text, |field| field.displacement.iter_mut().for_each(|u| *u = u.map(|x| x + 1.0)));
        assert!(has(&shifted, "departure of the supports"), "{name}: {shifted:?}");
    }
}

/// The wrong sign of one body, or of a model of which one contact is handed in, and what moves as a whole: no energy
/// and no support tells.
#[test]
fn displacements_of_the_wrong_sign_or_through_the_other_body_are_found_whatever_is_held_or_missing() {
    let strains = "departure of the strains";
    let overlap = "gap or overlap of the displacements";
    let ring = |name: &str, radii: [u8; 2], side: &str, supports: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nyoung = 70e3\npoisson = 0.3\nshape = {{ ring = {{ centre = [0, 0], inner = \
            {}, outer = {}, sweep = 90, contact = \"{side}\" }} }}\nsupports = [{{ at = \"start\", component = \"x\" \
            }}, {{ at = \"end\", component = \"y\" }}{supports}]\n",
            radii[0], radii[1]
        )
    };
    let outer = ", { at = \"outer\", component = \"x\" }, { at = \"outer\", component = \"y\" }";
    let held = format!(
        "title = \"ring in a held ring\"\nplane = \"strain\"\nthickness = 1\n{}{}[contact]\nfirst = \"inner\"\nsecond \
        = \"outer\"\n\
         arc = {{ centre = [0, 0], radius = 40 }}\ngap = {{ uniform = -0.02 }}\nstretch = 90\n[mesh]\nelements = \
         8\nper = 62.8\n",
        ring("inner", [20, 40], "outer", ""),
        ring("outer", [40, 70], "inner", outer)
    );
    let turned = |moved: [f64; 2]| moved.map(|u| 0.0 - u);
    // The scene, its contact that is handed in alone, the body that is moved, all where none is named, how, and what
    // tells.
    type Row<'a> = (String, Option<usize>, Option<usize>, &'a dyn Fn([f64; 2]) -> [f64; 2], &'a [&'a str]);
    let roller = text_of("roller-between-plates.toml");
    // Rubber, whose strains are not looked at, in a ring that has next to none of the energy.
    let rubber = held.replacen("young = 70e3\npoisson = 0.3\n", "young = 5\npoisson = 0.49\n", 1);
    let rows: [Row; 5] = [
        (held, None, Some(1), &turned, &[strains, overlap]),
        (rubber, None, Some(1), &turned, &[strains]),
        (roller.clone(), Some(0), None, &turned, &[strains, "stresses against"]),
        (roller, Some(0), Some(2), &turned, &[strains]),
        (text_of("two-cylinders.toml"), None, Some(0), &|[u, v]| [u, v - 1.0], &[overlap]),
    ];
    for (text, alone, body, spoil, tells) in rows {
        let truth = Truth::of(parsed(&scene_file::scene_alone(&text))).expect("a truth");
        let mut ours = answer(&truth.case, &own(&truth.case));
        ours.contacts.retain(|handed| alone.is_none_or(|contact| handed.contact == contact));
        ours.contacts.iter_mut().flat_map(|handed| &mut handed.points).for_each(|point| point.gap = None);
        assert_eq!(failed(&judged(&truth, ours.clone())), [""; 0], "{}", truth.case.title);
        let displacement = &mut ours.field.as_mut().expect("displacements").displacement;
        let mesh = truth.case.meshed().expect("meshed").discretisation.mesh;
        let nodes = body.map_or(0..displacement.len(), |body| mesh.bodies[body].nodes.clone());
        displacement[nodes].iter_mut().for_each(|moved| *moved = spoil(*moved));
        let found = judged(&truth, ours);
        for part in tells {
            assert!(failed(&found).iter().any(|one| one.contains(part)), "{}: {:?}", truth.case.title, failed(&found));
        }
        let missing = found.ruled[0].missing.iter().any(|[what, _]| what == "equilibrium of the stresses of `lower`");
        assert_eq!(missing, alone.is_some());
    }
}

#[test]
fn right_displacements_of_a_nearly_incompressible_body_are_not_called_wrong() {
    for (poisson, judged_too) in [(0.44, true), (0.4999, false)] {
        let text = scene_file::scene_alone(&text_of("cylinder-on-block.toml"));
        let text =
            text.replace("poisson = 0.33", "poisson = 0.3").replace("poisson = 0.3", &format!("poisson = {poisson}"));
        let truth = Truth::of(parsed(&text)).expect("a truth");
        let mut finer = truth.case.clone();
        finer.resolution.elements = 17;
        let found = judged(&truth, answer(&truth.case, &own(&finer)));
        assert_eq!(failed(&found), [""; 0], "{poisson}");
        let lost = found.ruled[0].missing.iter().any(|[_, why]| why.contains("nearly incompressible"));
        assert_eq!(lost, !judged_too, "{poisson}: {:?}", found.ruled[0].missing);
        // Motions that keep the volume tell all the same.
        let text = own(&finer);
        for by in [-1.0, 1.03] {
            let wrong = spoiled(&truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u *= by));
            assert!(wrong.iter().any(|one| one.contains("stresses against")), "{poisson}, {by}: {wrong:?}");
        }
    }
}

#[test]
fn no_other_load_or_radius_explains_pressures_beside_displacements_of_the_scene() {
    let truth = crate::workbench::truth("cylinder");
    let text = own(&truth.case);
    let mistakes = |spoil: &dyn Fn(&mut Answer)| {
        let mut answer = answer(&truth.case, &text);
        answer.contacts[0].points.iter_mut().for_each(|point| point.value *= 2.0);
        spoil(&mut answer);
        judged(truth, answer).mistakes
    };
    assert_eq!(mistakes(&|_| ()), Vec::<String>::new());
    assert!(mistakes(&|answer| answer.field = None).iter().any(|says| says.starts_with("pressures are twice")));
}

#[test]
fn a_mesh_with_a_hole_is_not_judged_and_the_place_is_named() {
    let truth = crate::workbench::truth("bars");
    let text = own(&truth.case);
    let mut answer = answer(&truth.case, &text);
    answer.field.as_mut().expect("displacements").cells.truncate(20);
    let found = judged(truth, answer);
    let missing = &found.ruled[0].missing;
    assert!(
        missing.iter().any(|[what, how]| what.contains("strain energy") && how.contains("holds the point")),
        "{missing:?}"
    );
}

#[test]
fn cells_of_every_kind_carry_a_motion_of_their_degree_to_our_nodes() {
    let case = find("truncated-hertz", None).expect("a case");
    let mesh = |order| {
        let resolution = Resolution { order, elements: 4, ..case.resolution };
        Discretisation::of(case.scene.clone(), resolution).expect("meshed")
    };
    let target = mesh(Order::Quadratic);
    let motion =
        |[x, y]: [f64; 2], square: f64| [0.2 * x - 0.1 * y + square * x * y, 0.3 * y + square * (x * x - y * y)];
    for (kind, square) in [("3", 0.0), ("6", 0.01), ("4", 0.0), ("8", 0.01), ("9", 0.01)] {
        let source = mesh(if matches!(kind, "3" | "4") { Order::Linear } else { Order::Quadratic });
        let mut points = source.mesh.points.clone();
        let mut cells = Vec::new();
        for cell in 0..source.mesh.cells() {
            let nodes = source.mesh.cell(cell).to_vec();
            let mut at = |pair: [usize; 2]| {
                let [a, b] = pair.map(|node| points[node]);
                points.push([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
                points.len() - 1
            };
            match kind {
                "3" => cells.extend([[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(|k| nodes[k]).to_vec())),
                "6" => {
                    let middle = at([nodes[0], nodes[2]]);
                    cells.push(vec![nodes[0], nodes[1], nodes[2], nodes[4], nodes[5], middle]);
                    cells.push(vec![nodes[0], nodes[2], nodes[3], middle, nodes[6], nodes[7]]);
                }
                "9" => {
                    let centre = at([nodes[0], nodes[2]]);
                    cells.push([&nodes[..], &[centre]].concat());
                }
                _ => cells.push(nodes),
            }
        }
        let corners = if matches!(kind, "3" | "6") { 3 } else { 4 };
        let cells = cells.into_iter().map(|nodes| Cell { nodes, corners }).collect();
        let displacement = points.iter().map(|point| motion(*point, square)).collect();
        let found = Field { points, cells, displacement }.at_nodes(&target).expect("reached");
        for (found, place) in found.iter().zip(&target.mesh.points) {
            let wanted = motion(*place, square);
            let off = (found[0] - wanted[0]).hypot(found[1] - wanted[1]);
            assert!(off <= 1e-9 * (1.0 + wanted[0].hypot(wanted[1])), "{kind}: {off} at {place:?}");
        }
    }
}

#[test]
fn thin_cells_beside_another_body_move_their_own_body() {
    let case = find("patch", None).expect("a case");
    let target = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    // Each body by itself: rows of cells that are as thin as cells fitted to a contact, at all of its ends.
    let (mut field, thin) =
        (Field { points: vec![], cells: vec![], displacement: vec![] }, [0.0, 1e-6, 0.5, 1.0 - 1e-6, 1.0]);
    // What the outermost rows alone tell.
    let outermost = |y: f64, ends: [f64; 2]| if ends.contains(&y) { 1.0 } else { 0.0 };
    let motion =
        |body: usize, [x, y]: [f64; 2], ends| [0.1 * x + body as f64 + outermost(y, ends), 0.2 * y - body as f64];
    let mut all_ends = Vec::new();
    for (body, part) in target.mesh.bodies.iter().enumerate() {
        let of = |axis: usize| target.mesh.points[part.nodes.clone()].iter().map(move |point| point[axis]);
        let ends =
            [0, 1].map(|axis| [of(axis).fold(f64::INFINITY, f64::min), of(axis).fold(f64::NEG_INFINITY, f64::max)]);
        all_ends.push(ends[1]);
        let first = field.points.len();
        for share in thin.iter().flat_map(|&x| thin.map(|y| [x, y])) {
            let point = [0, 1].map(|axis| ends[axis][0] + share[axis] * (ends[axis][1] - ends[axis][0]));
            field.displacement.push(motion(body, point, ends[1]));
            field.points.push(point);
        }
        let corner = |i: usize, j: usize| first + thin.len() * i + j;
        let cells = (0..thin.len() - 1).flat_map(|i| (0..thin.len() - 1).map(move |j| (i, j)));
        field.cells.extend(cells.map(|(i, j)| Cell {
            nodes: vec![corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)],
            corners: 4,
        }));
    }
    let found = field.at_nodes(&target).expect("reached");
    for (body, part) in target.mesh.bodies.iter().enumerate() {
        for node in part.nodes.clone() {
            let wanted = motion(body, target.mesh.points[node], all_ends[body]);
            let off = (found[node][0] - wanted[0]).hypot(found[node][1] - wanted[1]);
            assert!(off <= 1e-9 * (1.0 + wanted[0].hypot(wanted[1])), "{off} at {:?}", target.mesh.points[node]);
        }
    }
}

#[test]
fn displacements_approaches_and_shears_that_a_scene_file_declares_are_judged_and_found_wrong() {
    for (file, what) in [
        ("eccentric-load", "displacement"),
        ("two-cylinders", "largest shear stress"),
        ("press-fit", "reaction"),
        ("roller-between-plates", "strain energy"),
    ] {
        assert_judged(scene_file::case(file), what);
    }
    let mut blocks = parsed(&format!("{}\n{APPROACH}", text_of("blocks.toml")));
    blocks.name = "approach".into();
    assert_judged(blocks, "approach");
}

/// Blocks that cannot widen come nearer by their gap and `p (h₁/M₁ + h₂/M₂)`, `M = E (1 − ν)/((1 + ν)(1 − 2ν))`.
const APPROACH: &str = "[[check]]\nquantity = \"approach\"\nvalue = 0.018358310488\ntolerance = 1e-8\nkind = \
    \"analytic\"\n\
                        source = \"uniform state\"\nbecause = \"cells of any order are exact\"\n";

/// What a case declares is met by our own displacements, and not by ones that are 1.2 times as large.
fn assert_judged(case: Case, what: &str) {
    let name = case.name.clone();
    let text = own(&case);
    let truth = Truth::of(case).expect("a truth");
    let right = judged(&truth, answer(&truth.case, &text));
    assert_eq!(failed(&right), Vec::<String>::new(), "{name}");
    let names: Vec<String> =
        right.ruled.iter().flat_map(|ruled| &ruled.judged).map(|one| one.check.quantity.to_string()).collect();
    assert!(names.iter().any(|name| name.contains(what)), "{name}: {names:?}");
    let times =
        |by: f64| spoiled(&truth, &text, |field| field.displacement.iter_mut().flatten().for_each(|u| *u *= by));
    // What is declared to more digits is judged to those that are asked for, 1 %.
    let [near, wrong] = [1.002, 1.2].map(|by| times(by).iter().any(|name| name.contains(what)));
    assert_eq!([near, wrong], [false, true], "{name}");
}

/// Of a whole model of a half scene the half that is ours carries its half of the pressures.
#[test]
fn both_halves_of_a_symmetric_model_are_judged_as_one_is() {
    for name in ["truncated-hertz", "press-fit"] {
        let truth = crate::workbench::truth(name);
        let mut answer = answer(&truth.case, &own(&truth.case));
        let field = answer.field.as_mut().expect("displacements");
        let first = field.points.len();
        for node in 0..first {
            let ([x, y], [u, v]) = (field.points[node], field.displacement[node]);
            field.points.push([0.0 - x, y]);
            field.displacement.push([0.0 - u, v]);
        }
        let images: Vec<Cell> = field.cells.iter().map(|cell| mirrored(cell, first)).collect();
        field.cells.extend(images);
        for handed in &mut answer.contacts {
            let left = handed.points.iter().rev().filter(|point| point.position > 0.0);
            let left: Vec<_> = left.map(|point| Point { position: 0.0 - point.position, ..*point }).collect();
            handed.points.splice(0..0, left);
        }
        let found = judged(truth, answer);
        assert_eq!(failed(&found), [""; 0], "{name}");
        assert!(
            found.ruled[0].judged.iter().any(|one| one.check.quantity.to_string().contains("symmetry")
                || one.check.quantity.to_string().contains("halves")),
            "{name}"
        );
    }
}

/// A cell seen in the mirror, whose nodes follow those of all others: counter-clockwise again.
fn mirrored(Cell { nodes, corners }: &Cell, first: usize) -> Cell {
    let turned = |part: &[usize]| -> Vec<usize> { part.iter().rev().map(|node| first + node).collect() };
    let (outer, mut middles) = (turned(&nodes[..*corners]), turned(&nodes[*corners..]));
    // Behind a corner lies the middle that lay before it.
    let count = middles.len();
    middles.rotate_left(1.min(count));
    Cell { nodes: [outer, middles].concat(), corners: *corners }
}
