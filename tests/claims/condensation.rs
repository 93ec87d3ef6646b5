//! The condensed system against the same elimination done densely.

use contact_vv::case::library::{Cylinder, Patch, PinPlate, PinRod};
use contact_vv::elasticity::{BodySystem, ElasticSystem};
use contact_vv::error::Place;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Circle, Component, Face, Load, Path, Scene, Sector, Shape};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use crate::workbench::{ORDERS, block, dense, distance, held, held_at, of_shape, resolution};

fn system(scene: &Scene, elements: usize, order: Order) -> ElasticSystem {
    let mesh = Mesh::of(scene, resolution(elements, 0, order)).expect("mesh");
    ElasticSystem::assemble(scene, &mesh).expect("system")
}

/// `S = K_cc − K_ci K_ii⁻¹ K_ic` and `f̂ = f_c − K_ci K_ii⁻¹ f_i`, densely.
fn eliminated(body: &BodySystem) -> (DMatrix<f64>, DVector<f64>) {
    let k = dense(body);
    let inner: Vec<usize> = (0..k.nrows()).filter(|e| !body.retained.contains(e)).collect();
    let retained: Vec<usize> = body.retained.clone().collect();
    let pick = |rows: &[usize], columns: &[usize]| {
        DMatrix::from_fn(rows.len(), columns.len(), |i, j| k[(rows[i], columns[j])])
    };
    let force = |rows: &[usize]| DVector::from_iterator(rows.len(), rows.iter().map(|&i| body.force[i]));
    let inverse = pick(&inner, &inner).cholesky().expect("interior is definite");
    let coupling = pick(&inner, &retained);
    let schur = pick(&retained, &retained) - coupling.transpose() * inverse.solve(&coupling);
    (schur, force(&retained) - coupling.transpose() * inverse.solve(&force(&inner)))
}

/// Supported by its lower half's diameter, supported by contact alone, two bodies, and one pushed by a displacement.
fn samples() -> Vec<(&'static str, ElasticSystem)> {
    let pushed = block([4.0, 3.0], vec![held("left", Component::X, 0.0), held("far", Component::Y, -0.01)], vec![]);
    let mut all = Vec::new();
    for order in ORDERS {
        all.push(("cylinder", system(&Cylinder::default().scene(), 1, order)));
        all.push(("patch", system(&Patch { pressure: 3.0, ..Patch::default() }.scene(), 3, order)));
        all.push(("pin-rod", system(&PinRod::default().scene(), 2, order)));
        all.push(("pushed", system(&pushed, 3, order)));
    }
    all
}

#[test]
fn condensed_stiffness_and_load_are_those_of_dense_elimination() {
    for (name, system) in samples() {
        let condensed = system.condense().expect("condensed");
        assert_eq!(condensed.offsets.len(), system.bodies.len() + 1);
        for (body, &at) in system.bodies.iter().zip(&condensed.offsets) {
            let (schur, load) = eliminated(body);
            let m = body.retained.len();
            let found = DMatrix::from_fn(m, m, |i, j| condensed.stiffness[(at + i, at + j)]);
            // No body is coupled with another.
            let others = (0..condensed.retained()).filter(|j| !(at..at + m).contains(j));
            let coupling = others.flat_map(|j| (at..at + m).map(move |i| (i, j)));
            assert!(coupling.into_iter().all(|place| condensed.stiffness[place].abs() <= 0.0), "{name}");
            // Both eliminations lose digits to the condition of K_ii (1e4 on these meshes).
            assert!((&found - &schur).amax() <= 1e-10 * schur.amax(), "{name}: {:e}", (&found - &schur).amax());
            let scale = load.amax().max(body.force.iter().fold(0.0, |a: f64, f| a.max(f.abs())));
            assert!(distance(&condensed.load[at..at + m], load.as_slice()) <= 1e-9 * scale, "{name}");
        }
    }
}

#[test]
fn body_held_by_contact_alone_leaves_exactly_its_rigid_motion_without_stiffness() {
    for (scene, elements) in [(Cylinder::default().scene(), 2), (PinPlate::default().scene(), 3)] {
        let mesh = Mesh::of(&scene, resolution(elements, 0, Order::Quadratic)).expect("mesh");
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        let condensed = system.condense().expect("condensed");
        let m = condensed.offsets[1];
        let schur = DMatrix::from_fn(m, m, |i, j| condensed.stiffness[(i, j)]);
        // Rigid motion downwards: its normal component at each candidate.
        let rigid = DVector::from_iterator(m, mesh.bodies[0].candidates.iter().map(|c| -c.normal[1]));

        let force = &schur * &rigid;
        let mut eigenvalues: Vec<f64> = SymmetricEigen::new(schur.clone()).eigenvalues.iter().copied().collect();
        eigenvalues.sort_by(f64::total_cmp);

        // The shift of the order of the diagonal is taken off again: what is left is its round-off.
        assert!(force.amax() <= 1e-10 * schur.amax(), "{}: {:e}", scene.name, force.amax() / schur.amax());
        assert!(eigenvalues[0].abs() <= 1e-10 * schur.amax());
        assert!(eigenvalues[1] >= 1e-4 * schur.amax(), "{}: {eigenvalues:?}", scene.name);
    }
}

#[test]
fn each_motion_that_nothing_holds_is_told_by_body_and_direction() {
    let corner = |component| held_at([0.0, 0.0], component, 0.0);
    let pinned = || vec![corner(Component::X), corner(Component::Y)];
    let face = Load::RigidFace { boundary: "far".into(), component: Component::Y, force: 0.0 };
    let circle = Circle { centre: [0.0, 0.0], radius: 5.0 };
    let disc =
        Shape::Disc { centre: circle.centre, radius: circle.radius, sector: Sector::Quarter, contact: Face::Bottom };
    let on_arc = |support| of_shape(disc.clone(), Path::Arc(circle), 1.2, vec![support], vec![]);
    let of_block = |supports, loads| block([4.0, 3.0], supports, loads);
    // Whether the contact holds along its normals.
    let (held_there, not_there) = (true, false);
    for (scene, contact, motion) in [
        (of_block(vec![], vec![]), held_there, Some("slide along x")),
        (of_block(pinned(), vec![]), not_there, Some("rotate")),
        // A side held along itself lets the body turn about its points.
        (of_block(vec![corner(Component::X), held("left", Component::Y, 0.0)], vec![]), not_there, Some("rotate")),
        (of_block(vec![held("left", Component::X, 0.0)], vec![]), not_there, Some("slide along y")),
        (of_block(vec![held("far", Component::Y, 0.0)], vec![]), not_there, Some("slide along x")),
        (
            of_block(vec![held("far", Component::Y, 0.0), held_at([4.0, 0.0], Component::X, 0.0)], vec![]),
            not_there,
            None,
        ),
        (of_block(pinned(), vec![face]), not_there, None),
        // Normals that meet in one point leave the rotation about it free.
        (on_arc(corner(Component::X)), held_there, Some("rotate")),
        (on_arc(held("cut", Component::Y, 0.0)), held_there, None),
    ] {
        let mut mesh = Mesh::of(&scene, resolution(6, 0, Order::Linear)).expect("mesh");
        if !contact {
            mesh.bodies[0].candidates.clear();
        }
        let found = ElasticSystem::assemble(&scene, &mesh).err();
        assert_eq!(found.is_some(), motion.is_some(), "{found:?}");
        if let (Some(error), Some(motion)) = (found, motion) {
            let text = error.to_string();
            assert!(matches!(error.place, Place::Body { body: 0, .. }), "{text}");
            assert!(["`body`", motion, "add a support"].iter().all(|part| text.contains(part)), "{text}, not {motion}");
        }
    }
}
