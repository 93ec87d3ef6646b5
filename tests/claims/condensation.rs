//! The condensed system against the same elimination done densely, and what is solved on it where it is exported.

use std::io::{Cursor, Read};

use contact_vv::case::library::{Cylinder, Patch, PinPlate, PinRod, find};
use contact_vv::cli::export::files;
use contact_vv::elasticity::{BodySystem, ElasticSystem};
use contact_vv::error::Place;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::referee::export::condensed;
use contact_vv::scene::{Circle, Component, Face, Load, Path, Scene, Sector, Shape};
use contact_vv::study::sheet::BUILT_IN;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde_json::Value;

use crate::outputs::json;
use crate::workbench::{ORDERS, block, dense, distance, held, held_at, of_shape, resolution};

fn system(scene: &Scene, elements: usize, order: Order) -> ElasticSystem {
    let mesh = Mesh::of(scene, resolution(elements, 0, order)).expect("mesh");
    ElasticSystem::assemble(scene, &mesh).expect("system")
}

/// `S = K_cc − K_ci K_ii⁻¹ K_ic` and `f̂ = f_c − K_ci K_ii⁻¹ f_i`, densely.
fn eliminated(body: &BodySystem) -> (DMatrix<f64>, DVector<f64>) {
    let k = dense(body);
    let inner: Vec<usize> = (0..k.nrows()).filter(|e| !body.dofs.retained.contains(e)).collect();
    let retained: Vec<usize> = body.dofs.retained.clone().collect();
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
            let m = body.dofs.retained.len();
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

/// An array of the file.
fn array(bytes: &[u8], name: &str) -> Vec<f64> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("an archive");
    let mut text = Vec::new();
    archive.by_name(&format!("{name}.npy")).expect(name).read_to_end(&mut text).expect("read");
    npyz::NpyFile::new(&text[..]).expect("an array").into_vec().expect("numbers")
}

/// Pressures by an active set: points that pull open, points that penetrate close.
fn solved(s: &[f64], f: &[f64], b: &[f64], g: &[f64], area: &[f64]) -> Vec<f64> {
    let (n, m) = (f.len(), g.len());
    let (stiffness, rows) = (DMatrix::from_row_slice(n, n, s), DMatrix::from_row_slice(m, n, b));
    let mut closed: Vec<usize> = (0..m).filter(|&k| g[k].is_finite()).collect();
    for _ in 0..m {
        let c = closed.len();
        let own = DMatrix::from_fn(c, n, |row, column| rows[(closed[row], column)]);
        let mut system = DMatrix::zeros(n + c, n + c);
        system.view_mut((0, 0), (n, n)).copy_from(&stiffness);
        system.view_mut((0, n), (n, c)).copy_from(&own.transpose());
        system.view_mut((n, 0), (c, n)).copy_from(&own);
        let right = DVector::from_iterator(n + c, f.iter().copied().chain(closed.iter().map(|&k| g[k])));
        let found = system.lu().solve(&right).expect("regular");
        let approach = &rows * found.rows(0, n);
        let mut force = vec![0.0; m];
        closed.iter().zip(found.rows(n, c).iter()).for_each(|(&k, &own)| force[k] = own);
        let largest = force.iter().copied().fold(0.0, f64::max);
        let stays = |k: usize| match closed.contains(&k) {
            true => force[k] > -1e-10 * largest,
            false => approach[k] > g[k] + 1e-12,
        };
        let next: Vec<usize> = (0..m).filter(|&k| stays(k)).collect();
        if next == closed {
            return force.iter().zip(area).map(|(force, area)| force / area).collect();
        }
        closed = next;
    }
    panic!("no set stands");
}

#[test]
fn condensed_matrices_solved_by_a_few_lines_give_the_pressures_and_the_peak_that_solve_tells() {
    for name in ["cylinder", "pin-rod", "flat-punch"] {
        let all = files(&find(name, None).expect("a case"), true).expect("exported");
        let (_, bytes, _) = all.iter().find(|(file, ..)| file == condensed::FILE).expect("written");
        let [s, f, b, g, area, pressure] = ["S", "f", "B", "g", "A", "p"].map(|name| array(bytes, name));
        let found = solved(&s, &f, &b, &g, &area);
        let largest = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
        let told = json(&["solve", name, "--no-error-bar", "--tolerance", "1e-10"]);
        let peak = told["contacts"][0]["largest_point_pressure"].as_f64().expect("a peak");
        assert!((largest(&found) - peak).abs() <= 1e-8 * peak, "{name}: {} instead of {peak}", largest(&found));
        // The report's peak, of cells of high order; that of a punch has no limit.
        let cases: Vec<Value> = serde_json::from_str(BUILT_IN).expect("JSON");
        let values = cases.iter().filter(|one| one["case"] == name).flat_map(|one| one["values"].as_array());
        let known = values.flatten().find(|one| one["quantity"] == "peak-pressure").expect("a peak")["value"].as_f64();
        assert!(known.is_none_or(|known| (peak - known).abs() <= 1e-3 * known), "{name}: {peak}, {known:?}");
        for (k, (one, ours)) in found.iter().zip(&pressure).enumerate() {
            assert!((one - ours).abs() <= 1e-7 * peak, "{name}, point {k}: {one} instead of {ours}");
        }
        // Matrices that are 1 % too stiff are seen.
        let stiff: Vec<f64> = s.iter().map(|entry| 1.01 * entry).collect();
        let moved = solved(&stiff, &f, &b, &g, &area);
        let apart = moved.iter().zip(&pressure).map(|(one, ours)| (one - ours).abs()).fold(0.0, f64::max);
        assert!(name == "flat-punch" || apart > 1e-3 * peak, "{name}: {apart}");
        let sheet = String::from_utf8(all[0].1.clone()).expect("text");
        assert!(sheet.ends_with(condensed::TEXT), "{name}");
    }
}
