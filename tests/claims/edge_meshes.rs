//! Meshes around contacts whose ends are known: discs in frames, rings in rows, and several contacts of a body.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use contact_vv::accuracy::{self, Asked};
use contact_vv::measure::{Quantity, relative_error};
use contact_vv::mesh::{Mesh, Order, spacing};
use contact_vv::scene::{Ends, Face, Path, Scene, Sector, Shape};
use contact_vv::solve::{Discretisation, Element, Fitted, Formulation, Iteration, Run};

use crate::balance;
use crate::outputs::scene;
use crate::scene_file::case;
use crate::workbench::{area, length, of_shape, parsed, resolution, ring};

/// A disc of radius 10 whose contact has ends that are known.
fn disc(sector: Sector, contact: Face, places: Vec<f64>, layers: usize) -> Scene {
    let shape = Shape::Disc { centre: [0.0, 10.0], radius: 10.0, sector, contact };
    let both_sides = sector.has_both_sides();
    let path = Path::Straight { origin: [0.0, 0.0], both_sides };
    let mut scene = of_shape(shape, path, 1.5, vec![], vec![]);
    scene.contacts[0].ends = Ends { places, layers, off: 0.0 };
    scene
}

#[test]
fn frames_fill_every_sector_of_a_disc_and_touch_all_its_sides() {
    // Two cells in the box, three in each of three frames, and two around each layer's corner on either side of the
    // end.
    let quarter = 2 + 3 * 3 + 4 * 2;
    for (sector, quarters, cells) in [
        (Sector::Quarter, 1.0, quarter),
        (Sector::LowerHalf, 2.0, 2 * quarter),
        // The upper quarter: two cells of the core, one beside it, two above.
        (Sector::RightHalf, 2.0, quarter + 5),
        (Sector::Whole, 4.0, 2 * (quarter + 5)),
    ] {
        for contact in [Face::Bottom, Face::Top] {
            let places = if sector.has_both_sides() { vec![-0.5, 0.5] } else { vec![0.5] };
            let scene = disc(sector, contact, places, 2);
            for (order, bound) in [(Order::Quartic, 1e-5), (Order::Octic, 1e-11)] {
                let case = format!("{sector:?} {contact:?} {order:?}");
                let mesh = Mesh::of(&scene, resolution(1, 0, order)).expect("mesh");
                assert_eq!(mesh.cells(), cells, "{case}");
                let off = relative_error(area(&mesh), quarters * FRAC_PI_4 * 100.0);
                assert!(off <= bound, "{case}: {off:.1e}");
                if !sector.has_both_sides() {
                    let axis = length(&mesh, &scene, "axis");
                    assert!(relative_error(axis, if quarters > 1.0 { 20.0 } else { 10.0 }) <= 1e-12, "{case}: {axis}");
                }
                if !sector.has_upper_part() {
                    let cut = length(&mesh, &scene, "cut");
                    assert!(relative_error(cut, 10.0 * quarters) <= 1e-12, "{case}: {cut}");
                }
                // The contact side of a half is its lower quarter of the circle, in chords.
                let arc = length(&mesh, &scene, "contact") / if sector.has_both_sides() { 2.0 } else { 1.0 };
                assert!(arc < 10.0 * FRAC_PI_2 && arc > 0.95 * 10.0 * FRAC_PI_2, "{case}: {arc}");
            }
        }
    }
}

#[test]
fn frames_of_a_disc_are_cut_as_often_as_is_asked() {
    let scene = disc(Sector::RightHalf, Face::Bottom, vec![0.5], 0);
    let cells = |parts: usize| Mesh::of(&scene, resolution(parts, 0, Order::Sextic)).expect("mesh").cells();
    assert_eq!([cells(2), cells(3)], [4 * cells(1), 9 * cells(1)]);
}

#[test]
fn nodes_of_a_ring_lie_evenly_in_the_logarithm_of_the_radius_where_the_end_is_known() {
    for contact in [Face::Bottom, Face::Top] {
        let mut scene = ring([10.0, 2000.0], contact, 0.9, vec![], vec![]);
        scene.contacts[0].ends = Ends { places: vec![0.4], layers: 0, off: 0.0 };
        let mesh = Mesh::of(&scene, resolution(1, 0, Order::Quintic)).expect("mesh");
        let wanted = FRAC_PI_4 * (2000f64.powi(2) - 10f64.powi(2));
        assert!(relative_error(area(&mesh), wanted) <= 1e-5, "{contact:?}: {}", area(&mesh));
        let fractions = Order::Quintic.fractions();
        let edges = mesh.boundary(&scene, 0, "start").expect("side");
        for edge in edges {
            let mut heights: Vec<f64> = edge.iter().map(|&node| mesh.points[node][1].abs().ln()).collect();
            heights.sort_by(f64::total_cmp);
            let [low, high] = [heights[0], heights[heights.len() - 1]];
            for (height, part) in heights.iter().zip(&fractions) {
                assert!((height - low - part * (high - low)).abs() <= 1e-9, "{contact:?}: {heights:?}");
            }
        }
        // As thick as the contact is wide at the face, and each next row 1.8 times as much, in the logarithm.
        let mut rows: Vec<f64> =
            edges.iter().map(|edge| (mesh.points[edge[0]][1] / mesh.points[edge[1]][1]).ln().abs()).collect();
        rows.sort_by(f64::total_cmp);
        assert!(
            rows.len() == 4 && (rows[1] / rows[0] - 1.8).abs() < 0.3 && (rows[3] / rows[2] - 1.8).abs() <= 1e-6,
            "{rows:?}"
        );
    }
}

#[test]
fn positions_are_moved_to_places_and_never_past_each_other() {
    let positions = vec![0.0, 1.0, 2.0, 4.0];
    assert_eq!(spacing::through(&positions, &[1.2]), [0.0, 1.2, 2.0, 4.0]);
    assert_eq!(spacing::through(&positions, &[0.0, 4.0]), positions);
    // The second one is nearest to the same position, or to one on the other side of the first.
    assert_eq!(spacing::through(&positions, &[1.2, 0.9]), [0.0, 0.9, 1.2, 2.0, 4.0]);
    assert_eq!(spacing::through(&positions, &[0.9, 1.2, 0.9]), [0.0, 0.9, 1.2, 2.0, 4.0]);
    assert_eq!(spacing::through(&positions, &[1.8, 1.2]), [0.0, 1.2, 1.8, 4.0]);
    assert_eq!(spacing::through(&[0.0, 1.0], &[0.5]), [0.0, 0.5, 1.0]);
    assert_eq!(spacing::through(&positions, &[-3.0, 7.0, f64::NAN]), positions);
}

#[test]
fn a_block_held_at_a_point_of_its_far_side_has_a_node_there() {
    let scene = drawn("eccentric-to-accuracy");
    let answer =
        Fitted { order: Order::Sextic, layers: 1 }.solve(&scene, &Formulation::verification()).expect("solved");
    assert!(answer.discretisation.mesh.points.contains(&[0.0, 80.0]));
}

fn drawn(name: &str) -> Scene {
    case(name).scene
}

/// Peak and second-moment width of all contacts.
fn measured(run: &Run) -> Vec<[f64; 2]> {
    run.contacts.iter().map(|one| [one.measures.peak.pressure, one.measures.second_moment_width]).collect()
}

#[test]
fn every_contact_of_a_body_is_found_alike_by_cells_of_neighbouring_orders() {
    for name in ["plate-on-two-supports", "roller-between-plates"] {
        let scene = drawn(name);
        let solved = |order| {
            let fitted = Fitted { order, layers: 3 };
            let answer = fitted.solve_with_ends(&scene, &Formulation::verification(), 1e-5).expect("solved");
            assert!(answer.run.solution.converged(), "{name}");
            measured(&answer.run)
        };
        let [septic, octic] = [Order::Septic, Order::Octic].map(solved);
        assert!(septic.len() == 2 && octic.len() == 2);
        for (one, other) in septic.iter().flatten().zip(octic.iter().flatten()) {
            assert!(relative_error(*one, *other) <= 1e-5, "{name}: {septic:?} {octic:?}");
        }
    }
}

/// A whole cylinder, pressed on a rigid plane by a force so far beside its middle: contact holds it, so that its
/// pressure is centred there.
fn beside_the_middle(shift: f64) -> Scene {
    let file = std::fs::read_to_string(scene("whole-disc")).expect("file");
    let force = "{ traction = { at = \"middle\", value = [0, -36.2491511] } }";
    let moment = -3624.91511 * shift;
    let text = file.split("[[check]]").next().expect("a scene");
    let text = text.replace(force, &format!("{force}, {{ moment = {{ at = \"middle\", value = {moment} }} }}"));
    parsed(&text).scene
}

#[test]
fn both_ends_of_a_contact_off_the_middle_of_a_disc_are_found() {
    for shift in [0.3, -0.2] {
        let scene = beside_the_middle(shift);
        let solved = |order| {
            let fitted = Fitted { order, layers: 3 };
            let answer = fitted.solve_with_ends(&scene, &Formulation::verification(), 1e-5).expect("solved");
            assert!(answer.run.solution.converged(), "{shift}");
            (answer.stretches[0][0], measured(&answer.run)[0])
        };
        let [(_, septic), (ends, octic)] = [Order::Septic, Order::Octic].map(solved);
        for (one, other) in septic.iter().zip(octic) {
            assert!(relative_error(*one, other) <= 1e-5, "{shift}: {septic:?} {octic:?}");
        }
        assert!((0.5 * (ends[0] + ends[1]) - shift).abs() <= 1e-2, "{shift}: {ends:?}");
    }
}

#[test]
fn a_sheet_between_two_contacts_hangs_together_wherever_they_end() {
    for height in [0.5, 1.0, 2.0] {
        for [top, bottom] in [[2.0, 2.0], [2.078, 2.218], [2.45, 2.92], [1.23, 1.46], [3.0, 1.1]] {
            let [y, origin] = [format!("y = [-{height}, 0]"), format!("origin = [0, -{height}]")];
            let mut scene = balance::scene("sheet", &[["y = [-1, 0]", &y], ["origin = [0, -1]", &origin]]).scene;
            for (pair, place) in scene.contacts.iter_mut().zip([top, bottom]) {
                pair.ends = Ends { places: vec![place], layers: 2, off: 0.0 };
            }
            for order in [Order::Quartic, Order::Sextic] {
                let mesh = Mesh::of(&scene, resolution(1, 0, order)).expect("a mesh that hangs together");
                // Euler: corners − sides + cells = 1 of a body without a hole, and 0 of one that is cut open.
                let (mut corners, mut sides) = (BTreeSet::<usize>::new(), BTreeSet::new());
                for cell in 0..mesh.cells() {
                    let nodes = &mesh.cell(cell)[..4];
                    corners.extend(nodes.iter().copied());
                    sides.extend((0..4).map(|k| [nodes[k], nodes[(k + 1) % 4]]).map(|[a, b]| [a.min(b), a.max(b)]));
                }
                let euler = corners.len() as i64 - sides.len() as i64 + mesh.cells() as i64;
                assert_eq!(euler, 1, "{height} {top} {bottom} {order:?}");
            }
        }
    }
}

#[test]
fn bodies_have_their_nodes_at_the_same_places_and_line_elements_do_not_oscillate_there() {
    for name in ["cylinder-on-block", "two-cylinders", "hollow-circle"] {
        let scene = drawn(name);
        let line = Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-6);
        let solved = |formulation: &Formulation| {
            let answer = Fitted { order: Order::Sextic, layers: 1 }.solve(&scene, formulation).expect("solved");
            assert!(answer.run.solution.converged(), "{name}");
            answer
        };
        let answer = solved(&Formulation::verification());
        let mesh = &answer.discretisation.mesh;
        let [_, end] = answer.stretches[0][0];
        let along = |body: usize| {
            let nodes = mesh.boundary(&answer.discretisation.scene, body, "contact").expect("side").iter().flatten();
            let mut x: Vec<f64> = nodes.map(|&node| mesh.points[node][0]).filter(|x| *x <= 1.01 * end).collect();
            x.sort_by(f64::total_cmp);
            x.dedup_by(|a, b| (*a - *b).abs() <= 1e-12 * end);
            x
        };
        let [one, other] = [0, 1].map(along);
        assert!(one.len() == other.len() && one.len() > 12, "{name}: {} {}", one.len(), other.len());
        assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() <= 1e-12 * end), "{name}: {one:?} {other:?}");
        let [node, line] = [measured(&answer.run)[0], measured(&solved(&line).run)[0]];
        let apart = [0, 1].map(|k| relative_error(line[k], node[k]));
        assert!(apart[0] <= 2e-3 && apart[1] <= 1e-4, "{name}: {apart:?}");
    }
}

/// A pin in a hole that is drawn where it touches it, the centre of the hole above that of the pin.
pub(crate) fn pin_in_hole() -> String {
    include_str!("../../src/cli/new/pin-in-hole.toml").into()
}

/// Contact coordinates of the nodes of a body's side, up to one of them.
fn places(discretisation: &Discretisation, body: usize, end: f64) -> Vec<f64> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let pair = scene.contact();
    let edges = mesh.boundary(scene, body, pair.side(body)).expect("a side");
    let all = edges.iter().flatten().map(|&node| pair.path.coordinate(mesh.points[node]));
    let mut within: Vec<f64> = all.filter(|s| *s <= end * (1.0 + 1e-9)).collect();
    within.sort_by(f64::total_cmp);
    within.dedup_by(|a, b| (*a - *b).abs() <= 1e-9);
    within
}

#[test]
fn bodies_on_arcs_of_different_centres_have_their_nodes_at_the_same_places() {
    let case = parsed(&pin_in_hole());
    let nine = Discretisation::of(case.scene.clone(), case.resolution).expect("discretised");
    let asked = Asked { most_dofs: Some(20_000), ..Asked::new(1e-4) };
    let answer = accuracy::solve(&case.scene, &Formulation::verification(), &asked).expect("solved");
    assert_eq!(answer.unmet, None);
    assert!(answer.run.dofs <= 2500, "{}", answer.run.dofs);
    let fitted = Discretisation::of(answer.scene.clone(), answer.resolution).expect("discretised");
    // Layers around an end are cut from cells by the polynomials that these are.
    for (meshed, off) in [(&nine, 1e-5), (&fitted, 1e-8)] {
        let [pin, hole] = [0, 1].map(|body| places(meshed, body, meshed.scene.contact().stretch));
        assert_eq!(pin.len(), hole.len());
        pin.iter().zip(&hole).for_each(|(pin, hole)| assert!((pin - hole).abs() <= off, "{pin} beside {hole}"));
    }

    // Elements between nodes that lie elsewhere alternate from one to the next, and some stall.
    let [half_width, peak] = [Quantity::HalfWidth, Quantity::PeakPressure].map(|of| of.of(answer.run.measures()));
    for formulation in Formulation::compared() {
        let run = Run::of(&nine, &formulation).expect("a run");
        assert!(run.solution.converged(), "{}: {}", formulation.name(), run.solution.outcome);
        assert!(relative_error(run.measures().half_width(), half_width) <= 0.015, "{}", formulation.name());
        assert!(relative_error(run.measures().peak.pressure, peak) <= 0.005, "{}", formulation.name());
    }

    // The same gap between circles about one point: another order, other meshes, and the drawing off by a thousandth.
    let concentric = pin_in_hole().replace("[0, 0.02], inner = 20.02", "[0, 0], inner = 20");
    let answer = accuracy::solve(&parsed(&concentric).scene, &Formulation::verification(), &asked).expect("solved");
    assert!(relative_error(answer.run.measures().half_width(), half_width) <= 1e-3);
    assert!(relative_error(answer.run.measures().peak.pressure, peak) <= 1e-3);
}
