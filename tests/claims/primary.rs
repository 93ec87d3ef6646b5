//! Meshes that do not match: projection on to the opposite edge, and what it balances.

use approx::assert_abs_diff_eq;
use contact_vv::case::library::{Patch, PinRod};
use contact_vv::contact::{Interface, node};
use contact_vv::elasticity::ElasticSystem;
use contact_vv::error::{Part, Place};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Profile, Scene};

use crate::contact::{elements, interface};
use crate::workbench::{ORDERS, resolution, spoiled};

#[test]
fn node_that_nothing_faces_is_refused_with_its_coordinate() {
    let scene = PinRod::default().scene();
    let mesh = Mesh::of(&scene, resolution(6, 0, Order::Linear)).expect("mesh");
    let condensed = ElasticSystem::assemble(&scene, &mesh).expect("system").condense().expect("condensed");
    let mut shorter = mesh.clone();
    shorter.bodies[1].candidates.pop();
    let late = spoiled(&mesh, |mesh| mesh.bodies[1].candidates[0].coordinate += 0.01);
    let end = format!("s = {}°", scene.contact().stretch.to_degrees().round());
    for (wrong, at) in [(shorter, end.as_str()), (late, "s = 0°")] {
        let error = Interface::between(&scene, &wrong, &condensed, 0).expect_err("nothing faces a node");
        let text = error.to_string();
        assert!(matches!(error.place, Place::Contact { contact: 0, part: Part::Second, .. }), "{text}");
        for part in ["`pin`", "`rod`", at, "shorten the candidate stretch"] {
            assert!(text.contains(part), "{text}, not {part}");
        }
    }
}

/// Truncated Hertz on a block with `density` times its elements.
fn on_a_block(density: f64) -> Scene {
    let mut scene = Patch::default().scene();
    scene.bodies[1].density = density;
    scene
}

#[test]
fn uniform_pressure_presses_consistently_on_both_sides_whatever_their_meshes() {
    for order in ORDERS {
        for density in [0.3, 0.8, 1.0, 1.7, 2.0, 5.0] {
            let scene = on_a_block(density);
            let mesh = Mesh::of(&scene, resolution(10, 0, order)).expect("mesh");
            let sample = interface(&scene, 10, order);
            let own = sample.nodes.len();
            let primary = &mesh.bodies[1].candidates;
            for (name, points_of) in elements() {
                let mut force = vec![0.0; own + primary.len()];
                points_of(&sample).iter().for_each(|point| point.add_row(point.weight, &mut force));
                for (body, forces) in [(0, &force[..own]), (1, &force[own..])] {
                    let mut alone = scene.clone();
                    alone.bodies[0].density = scene.bodies[body].density;
                    alone.contacts[0].second = None;
                    let areas = node::points(&interface(&alone, 10, order)).into_iter().map(|point| point.weight);
                    for (found, wanted) in forces.iter().zip(areas) {
                        assert!((found - wanted).abs() <= 1e-12, "{name}, {density}, body {body}: {found}, {wanted}");
                    }
                }
            }
        }
    }
}

#[test]
fn projection_finds_the_place_on_an_edge_whose_middle_lies_off_the_middle() {
    let scene = on_a_block(1.0);
    let mut mesh = Mesh::of(&scene, resolution(1, 0, Order::Quadratic)).expect("mesh");
    // Middle at 0.4 of the edge: s(ξ) = 4 + 5 ξ + ξ² on 0 … 10.
    mesh.bodies[1].candidates[1].coordinate = 4.0;
    let condensed = ElasticSystem::assemble(&scene, &mesh).expect("system").condense().expect("condensed");
    let sample = Interface::between(&scene, &mesh, &condensed, 0).expect("interface");
    let xi = 0.5 * (29.0_f64.sqrt() - 5.0);
    let wanted = [0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)];
    let middle = sample.primary.expect("two bodies").at(5.0).expect("an edge");
    assert_eq!(middle.len(), 3);
    for (node, value) in middle {
        assert_abs_diff_eq!(value, wanted[node.dof - 3], epsilon = 1e-14);
    }
}

#[test]
fn drawn_gap_is_the_distance_along_the_normal_whichever_side_carries_the_points() {
    let mut scene = PinRod::default().scene();
    let mesh = |scene: &Scene| Mesh::of(scene, resolution(6, 0, Order::Quadratic)).expect("mesh");
    let profile = scene.contact().profile.clone();
    scene.contacts[0].profile = Profile::Drawn;
    for above in [true, false] {
        let mut scene = scene.clone();
        if !above {
            (scene.contacts[0].first, scene.contacts[0].second) = (1, Some(0));
            scene.contacts[0].above = false;
        }
        let mesh = mesh(&scene);
        let condensed = ElasticSystem::assemble(&scene, &mesh).expect("system").condense().expect("condensed");
        let sample = Interface::between(&scene, &mesh, &condensed, 0).expect("interface");
        for node in &sample.nodes {
            assert_abs_diff_eq!(node.gap, profile.gap(node.coordinate), epsilon = 1e-9);
            let outward = node.point[0] * node.normal[0] + node.point[1] * node.normal[1];
            assert_eq!(outward > 0.0, above, "the pin's normal points away from its centre, the rod's towards it");
        }
    }
}
