//! Displacements on another code's mesh, brought to the nodes of ours: from there equilibrium, energy and all else
//! follow by our own formulas.

use crate::elasticity::point::Cells;
use crate::referee::side::Cell;
use crate::solve::Discretisation;

/// Displacements of the nodes of a mesh of plane cells.
#[derive(Clone, Debug)]
pub struct Field {
    /// Nodes \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Cells.
    pub cells: Vec<Cell>,
    /// Displacements \[mm\].
    pub displacement: Vec<[f64; 2]>,
}

/// How far outside a cell, over its size, a point still belongs to it: the edges of coarse triangles miss a curved
/// outline by as much.
const OUTSIDE: f64 = 0.08;
/// The same of one that lies within, but for round-off.
const WITHIN: f64 = 1e-9;

impl Field {
    /// The displacement at every node of our mesh; why not, where it does not reach one.
    pub fn at_nodes(&self, own: &Discretisation) -> Result<Vec<[f64; 2]>, String> {
        let bodies = own.mesh.bodies.iter().enumerate();
        let ours: Vec<Cells> = bodies.clone().map(|(body, _)| Cells::of_body(&own.mesh, body)).collect();
        let theirs: Vec<Option<usize>> = self.cells.iter().map(|cell| self.body(&ours, cell)).collect();
        let mut found = vec![[0.0; 2]; own.mesh.points.len()];
        for (body, part) in bodies {
            let cells: Vec<&Cell> =
                self.cells.iter().zip(&theirs).filter_map(|(cell, of)| (*of == Some(body)).then_some(cell)).collect();
            let places = |cell: &Cell| cell.nodes.iter().map(|&node| self.points[node]).collect();
            let placed = Cells::of(cells.iter().map(|cell| (cell.corners, places(cell))));
            for node in part.nodes.clone() {
                let point = own.mesh.points[node];
                let name = &own.scene.bodies[body].name;
                let missing = || format!("no cell of `{name}` holds the point ({:.4}, {:.4})", point[0], point[1]);
                let (place, shapes) = placed.shapes_at(point, OUTSIDE).ok_or_else(missing)?;
                for (&of, value) in cells[place].nodes.iter().zip(shapes) {
                    (0..2).for_each(|k| found[node][k] += value * self.displacement[of][k]);
                }
            }
        }
        Ok(found)
    }

    /// The body of the scene that a cell belongs to: the one it lies in, or else beside.
    fn body(&self, ours: &[Cells], cell: &Cell) -> Option<usize> {
        let of = |axis: usize| cell.nodes.iter().map(|&node| self.points[node][axis]).sum::<f64>();
        let middle = [0, 1].map(|axis| of(axis) / cell.nodes.len() as f64);
        let holding = |outside| ours.iter().position(|cells| cells.shapes_at(middle, outside).is_some());
        holding(WITHIN).or_else(|| holding(OUTSIDE))
    }
}
