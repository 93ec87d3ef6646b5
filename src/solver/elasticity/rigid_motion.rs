//! Rigid motions that no support stops: of one body, or of all bodies with their contacts closed; and the refusal of a
//! body that could move as a rigid one although its supports and contact nodes are fixed.

use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

use crate::elasticity::dofs::Dofs;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Load, Scene};

/// Below this fraction of the largest eigenvalue a rigid motion counts as free.
const FREE: f64 = 1e-10;
/// Rigid motions of a body.
pub const MOTIONS: [&str; 3] = ["slide along x", "slide along y", "rotate"];
/// What stops each of them.
pub const STOPPED_BY: [&str; 3] = [
    "a support along x",
    "a support along y",
    "a support that stops the rotation, as a whole side or a second node does",
];

/// The interior stiffness is positive definite ⇔ no rigid motion `(a, b, ω)` leaves every fixed component at rest.
///
/// Fixed are prescribed components, the normals of contact candidates, and the rotation of rigid faces. A body of
/// revolution can slide along its axis only.
pub fn refuse_free(scene: &Scene, mesh: &Mesh, body: usize, dofs: &Dofs) -> Result<(), Error> {
    let frame = Frame::of(mesh, &[body]);
    let rows = stopped(scene, mesh, body, (dofs, frame), |equation| dofs.retained.contains(&equation))?;
    let gram: Matrix3<f64> = rows.into_iter().map(Vector3::from).map(|row| row * row.transpose()).sum();
    let eigen = SymmetricEigen::new(gram);
    let weakest = eigen.eigenvalues.imin();
    if eigen.eigenvalues[weakest] > FREE * eigen.eigenvalues.max() {
        return Ok(());
    }
    let motion = eigen.eigenvectors.column(weakest).map(f64::abs).imax();
    let message =
        format!("it is free to {}: no support holds it that way, and its contacts do not act there", MOTIONS[motion]);
    let own = scene.bodies[body].shape.boundaries().into_iter().filter(|name| name != CONTACT);
    let names: Vec<String> = own.map(|name| format!("`{name}`")).collect();
    let places = if names.is_empty() { String::new() } else { format!(" on a boundary ({}) or", names.join(", ")) };
    let remedy = format!("add {},{places} at a node `[x, y]`", STOPPED_BY[motion]);
    Err(Error::at(scene.place_of_body(body), message, remedy))
}

/// A rigid motion of some bodies, about a common centre.
#[derive(Clone, Debug)]
pub struct FreeMotion {
    /// The bodies.
    pub bodies: Vec<usize>,
    /// Their translations along x and y, and their rotations, counter-clockwise, times the size.
    pub components: Vec<[f64; 3]>,
    frame: Frame,
}

/// What motions are measured by.
#[derive(Clone, Copy, Debug)]
struct Frame {
    /// Centre of rotations \[mm\].
    centre: [f64; 2],
    /// Largest distance of a node from it \[mm\].
    size: f64,
}

/// A component below this part of the largest of a motion is none.
const SMALL: f64 = 1e-6;

impl FreeMotion {
    /// The motions of some bodies that no support of theirs stops, all others at rest; where contacts are `closed`,
    /// those that change no gap between candidates either.
    pub fn all(scene: &Scene, mesh: &Mesh, dofs: &[&Dofs], bodies: &[usize], closed: bool) -> Result<Vec<Self>, Error> {
        let frame = Frame::of(mesh, bodies);
        let mut rows = Vec::new();
        for (place, &body) in bodies.iter().enumerate() {
            let own = stopped(scene, mesh, body, (dofs[body], frame), |_| false)?;
            rows.extend(own.into_iter().map(|row| vec![(place, row)]));
        }
        if closed {
            rows.extend(gaps(scene, mesh, bodies, frame));
        }
        let mut gram: DMatrix<f64> = DMatrix::zeros(3 * bodies.len(), 3 * bodies.len());
        for row in rows {
            let mut all: DVector<f64> = DVector::zeros(gram.nrows());
            for (place, own) in row {
                (0..3).for_each(|k| all[3 * place + k] += own[k]);
            }
            gram += &all * all.transpose();
        }
        let eigen = SymmetricEigen::new(gram);
        let largest = eigen.eigenvalues.max();
        let pairs = eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter());
        let free = pairs.filter(|(value, _)| **value <= FREE * largest);
        let motion = |(_, vector): (&f64, nalgebra::DVectorView<f64>)| Self {
            bodies: bodies.to_vec(),
            components: (0..bodies.len()).map(|place| [0, 1, 2].map(|k| vector[3 * place + k])).collect(),
            frame,
        };
        Ok(free.map(motion).collect())
    }

    /// The motions of one body among these that slide it along x, along y, or turn it, both ways: those that lie in
    /// their span, and the only one there is.
    pub fn simple(all: &[Self]) -> Vec<Self> {
        let Some(first) = all.first() else { return Vec::new() };
        let of = |components: [f64; 3]| Self { components: vec![components], ..first.clone() };
        let along = |k: usize| [0, 1, 2].map(|other| if other == k { 1.0 } else { 0.0 });
        let lies = |wanted: &[f64; 3]| {
            let dot = |motion: &Self| (0..3).map(|k| motion.components[0][k] * wanted[k]).sum::<f64>().powi(2);
            all.iter().map(dot).sum::<f64>() >= 1.0 - SMALL
        };
        let mut found: Vec<[f64; 3]> = (0..3).map(along).filter(lies).collect();
        if let ([only], true) = (all, found.is_empty()) {
            found.push(only.components[0]);
        }
        found.into_iter().flat_map(|components| [of(components), of(components.map(|c| 0.0 - c))]).collect()
    }

    /// Displacement of a point of the body at a place in the list \[mm\].
    pub fn at(&self, place: usize, point: [f64; 2]) -> [f64; 2] {
        let [a, b, turn] = self.components[place];
        let [x, y] = self.frame.arm(point);
        [a - turn * y, b + turn * x]
    }

    /// The bodies that move.
    pub fn moving(&self) -> Vec<usize> {
        let largest = self.components.iter().flatten().map(|c| c.abs()).fold(0.0, f64::max);
        let moves = |components: &[f64; 3]| components.iter().any(|c| c.abs() > SMALL * largest);
        let all = self.bodies.iter().zip(&self.components);
        all.filter(|(_, components)| moves(components)).map(|(body, _)| *body).collect()
    }

    /// What the motion is for the most part, as its index in [`MOTIONS`].
    pub fn kind(&self) -> usize {
        let size = |k: usize| self.components.iter().map(|components| components[k].abs()).fold(0.0, f64::max);
        (1..3).fold(0, |most, k| if size(k) > size(most) { k } else { most })
    }

    /// Its name.
    pub fn name(&self) -> &'static str {
        MOTIONS[self.kind()]
    }
}

impl Frame {
    fn of(mesh: &Mesh, bodies: &[usize]) -> Self {
        let points = || bodies.iter().flat_map(|&body| mesh.bodies[body].nodes.clone()).map(|node| mesh.points[node]);
        let count = points().count() as f64;
        let centre = [0, 1].map(|k| points().map(|point| point[k]).sum::<f64>() / count);
        let size = points().map(|[x, y]| (x - centre[0]).hypot(y - centre[1])).fold(0.0, f64::max);
        Self { centre, size }
    }

    fn arm(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (point[k] - self.centre[k]) / self.size)
    }

    /// The displacement along an axis at a point as a row on (a, b, ω).
    fn row(&self, point: [f64; 2], axis: [f64; 2]) -> [f64; 3] {
        let [x, y] = self.arm(point);
        [axis[0], axis[1], axis[1] * x - axis[0] * y]
    }
}

/// What the supports and the rigid faces of a body stop, the axis of a body of revolution, and other equations that are
/// held.
fn stopped(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    (dofs, frame): (&Dofs, Frame),
    is_held: impl Fn(usize) -> bool,
) -> Result<Vec<[f64; 3]>, Error> {
    let mut rows = Vec::new();
    for node in mesh.bodies[body].nodes.clone() {
        let components = dofs.of_node(node).into_iter().zip(dofs.frame(node));
        let fixed = components.filter(|(dof, _)| dof.equation().is_none_or(&is_held));
        rows.extend(fixed.map(|(_, axis)| frame.row(mesh.points[node], axis)));
    }
    for load in &scene.bodies[body].loads {
        if let Load::RigidFace { boundary, component, .. } = load {
            let mut axis = [0.0; 2];
            axis[component.index()] = 1.0;
            let edge = &mesh.boundary(scene, body, boundary)?[0];
            let [a, b] = [edge[0], edge[1]].map(|node| frame.row(mesh.points[node], axis));
            rows.push([0, 1, 2].map(|k| a[k] - b[k]));
        }
    }
    if let Some(radial) = scene.plane.radial() {
        rows.extend([radial, 2].map(|held| [0, 1, 2].map(|k| if k == held { 1.0 } else { 0.0 })));
    }
    Ok(rows)
}

/// How the gap at every candidate closes, on the bodies that are listed.
fn gaps(scene: &Scene, mesh: &Mesh, bodies: &[usize], frame: Frame) -> Vec<Vec<(usize, [f64; 3])>> {
    let place = |body: usize| bodies.iter().position(|other| *other == body);
    let mut rows = Vec::new();
    for (contact, pair) in scene.contacts.iter().enumerate() {
        let first = &mesh.bodies[pair.first];
        for candidate in &first.candidates[first.candidates_of(contact)] {
            let own = frame.row(mesh.points[candidate.node], candidate.normal);
            let both = [(Some(pair.first), own), (pair.second, own.map(|x| 0.0 - x))];
            rows.push(both.into_iter().filter_map(|(body, row)| Some((place(body?)?, row))).collect());
        }
    }
    rows
}
