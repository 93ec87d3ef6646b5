//! Facing nodes and edges of the candidate stretch.

use crate::condensation::Condensed;
use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::mesh::{Mesh, candidates};
use crate::scene::{ContactPair, Scene};

/// The candidate stretch: stations (facing nodes) and the edges between them.
#[derive(Clone, Debug)]
pub struct Interface {
    /// Facing nodes, in the order of the contact coordinate.
    pub stations: Vec<Station>,
    /// Edges as station indices: first, last and, on 3-node edges, the middle.
    pub edges: Vec<Vec<usize>>,
    /// Path, gap and symmetry of the contact.
    pub pair: ContactPair,
    /// Thickness \[mm\].
    pub thickness: f64,
}

/// A node of the first body and, unless the other side is rigid, the node of the second body facing it.
#[derive(Clone, Debug)]
pub struct Station {
    /// Contact coordinate.
    pub coordinate: f64,
    /// Position on the first body \[mm\].
    pub point: [f64; 2],
    /// Outward normal of the first body.
    pub normal: [f64; 2],
    /// Initial gap \[mm\].
    pub gap: f64,
    /// Retained freedoms of the normal displacements, first body and second.
    pub freedoms: Vec<usize>,
}

impl Interface {
    /// Pairs the candidate nodes of the bodies in contact; stations of both must agree.
    pub fn between(scene: &Scene, mesh: &Mesh, condensed: &Condensed) -> Result<Self, Error> {
        let pair = &scene.contact;
        let first = &mesh.bodies[pair.first];
        let mut stations: Vec<Station> = first
            .candidates
            .iter()
            .enumerate()
            .map(|(index, candidate)| Station {
                coordinate: candidate.coordinate,
                point: mesh.points[candidate.node],
                normal: candidate.normal,
                gap: pair.profile.gap(candidate.coordinate),
                freedoms: vec![condensed.offsets[pair.first] + index],
            })
            .collect();
        if stations.len() < 2 {
            return Err(Error::value(
                &scene.name,
                "candidate stretch",
                pair.stretch,
                "it must hold at least one element edge",
                "lengthen it or refine the mesh",
            ));
        }
        if let Some(second) = pair.second {
            face(scene, mesh, second, condensed.offsets[second], &mut stations)?;
        }
        let index = |node: usize| first.candidate_index(node);
        let mut edges: Vec<Vec<usize>> = candidates::candidate_edges(mesh, scene, pair.first)?
            .iter()
            .filter_map(|edge| edge.iter().map(|&n| index(n)).collect())
            .collect();
        edges.sort_by_key(|edge| edge[0].min(edge[1]));
        Ok(Self { stations, edges, pair: pair.clone(), thickness: scene.thickness })
    }

    /// At a natural coordinate of an edge: shape functions `N_a`, contact coordinate `s`, and length per ξ \[mm\].
    pub fn at(&self, edge: &[usize], xi: f64) -> (Vec<f64>, f64, f64) {
        let shapes = shape_functions::edge(edge.len(), xi);
        let of = |pick: fn(&(f64, f64)) -> f64| -> f64 {
            shapes.iter().zip(edge).map(|(shape, &a)| pick(shape) * self.stations[a].coordinate).sum()
        };
        let position = of(|shape| shape.0);
        let length = of(|shape| shape.1).abs() * self.pair.path.metric();
        (shapes.iter().map(|shape| shape.0).collect(), position, length)
    }

    /// Row that picks the approach interpolated by `N_a` between the stations of an edge.
    pub fn interpolated_row(&self, edge: &[usize], shapes: &[f64]) -> Vec<(usize, f64)> {
        let terms = edge.iter().zip(shapes);
        terms.flat_map(|(&a, &value)| self.stations[a].freedoms.iter().map(move |&f| (f, value))).collect()
    }
}

/// Adds the facing nodes of the second body, and refuses those that do not face.
fn face(scene: &Scene, mesh: &Mesh, second: usize, offset: usize, stations: &mut [Station]) -> Result<(), Error> {
    let facing = &mesh.bodies[second].candidates;
    let mismatch = |index: usize, at: f64, other: f64| Error::NotFacing {
        first: scene.bodies[scene.contact.first].name.clone(),
        second: scene.bodies[second].name.clone(),
        index,
        at,
        facing: other,
    };
    if facing.len() != stations.len() {
        let last = stations.len().min(facing.len());
        return Err(mismatch(last, stations.len() as f64, facing.len() as f64));
    }
    for (index, (station, candidate)) in stations.iter_mut().zip(facing).enumerate() {
        let apart = (station.coordinate - candidate.coordinate).abs();
        if apart.is_nan() || apart > 1e-9 * scene.contact.stretch {
            return Err(mismatch(index, station.coordinate, candidate.coordinate));
        }
        station.freedoms.push(offset + index);
    }
    Ok(())
}
