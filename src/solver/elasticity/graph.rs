//! Which nodes of a body share a cell, and the order in which they are best eliminated.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use crate::mesh::Mesh;

/// Equation numbers inside sparse matrices: half the memory of `usize`, and more equations than fit any memory here.
pub type Index = u32;

/// The nodes each node of a body shares a cell with, itself included; nodes count from the body's first.
#[derive(Clone, Debug)]
pub struct NodeGraph {
    starts: Vec<usize>,
    neighbours: Vec<Index>,
}

impl NodeGraph {
    /// The graph of a body.
    pub fn of(mesh: &Mesh, body: usize) -> Self {
        let (first, count) = (mesh.bodies[body].nodes.start, mesh.bodies[body].nodes.len());
        let cells = mesh.bodies[body].cells.clone();
        let (cell_starts, cells_of) = cells_of_nodes(cells.clone().map(|cell| mesh.cell(cell)), first, count);
        let (mut starts, mut neighbours) = (vec![0], Vec::with_capacity(14 * count));
        let mut seen = vec![usize::MAX; count];
        for node in 0..count {
            for &cell in &cells_of[cell_starts[node]..cell_starts[node + 1]] {
                for &other in mesh.cell(cells.start + cell) {
                    let other = other - first;
                    if seen[other] != node {
                        seen[other] = node;
                        neighbours.push(other as Index);
                    }
                }
            }
            starts.push(neighbours.len());
        }
        Self { starts, neighbours }
    }

    /// The nodes that share a cell with a node, itself included.
    pub fn neighbours(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        self.neighbours[self.starts[node]..self.starts[node + 1]].iter().map(|&other| other as usize)
    }

    /// Entries that the lower triangle of a matrix of two dofs per node has.
    pub fn entries_of_lower_triangle(&self) -> usize {
        2 * self.neighbours.len() + (self.starts.len() - 1)
    }

    /// Approximate minimum degree order of the nodes that take part (Amestoy, Davis & Duff 1996).
    ///
    /// Nodes instead of dofs: a quarter of the entries. Ties are broken by the numbering the ordering is given; the
    /// mesh's own backwards costs a third fewer operations than forwards (quarter cylinder, 1e5 dofs).
    pub fn minimum_degree(&self, takes_part: &[bool]) -> Vec<usize> {
        let nodes: Vec<usize> = (0..takes_part.len()).rev().filter(|&node| takes_part[node]).collect();
        let mut number = vec![0; takes_part.len()];
        nodes.iter().enumerate().for_each(|(new, &node)| number[node] = new as Index);
        let (mut starts, mut others) = (vec![0], Vec::with_capacity(self.neighbours.len()));
        for &node in &nodes {
            let apart = self.neighbours(node).filter(|&other| other != node && takes_part[other]);
            others.extend(apart.map(|other| number[other]));
            starts.push(others.len() as Index);
        }
        let n = nodes.len();
        let graph = SymbolicSparseColMatRef::new_unsorted_checked(n, n, &starts, None, &others);
        let (mut forward, mut inverse) = (vec![0; n], vec![0; n]);
        let mut memory = MemBuffer::new(amd::order_maybe_unsorted_scratch::<Index>(n, others.len()));
        let control = amd::Control::default();
        match amd::order_maybe_unsorted(&mut forward, &mut inverse, graph, control, MemStack::new(&mut memory)) {
            Ok(_) => forward.into_iter().map(|new| nodes[new as usize]).collect(),
            // Any order will do: it only costs more.
            Err(_) => nodes,
        }
    }
}

/// Cells of each node in compressed form, cells and nodes counted from the body's first.
fn cells_of_nodes<'a>(
    cells: impl Iterator<Item = &'a [usize]> + Clone,
    first: usize,
    count: usize,
) -> (Vec<usize>, Vec<usize>) {
    let mut starts = vec![0; count + 1];
    cells.clone().flatten().for_each(|node| starts[node - first + 1] += 1);
    (0..count).for_each(|node| starts[node + 1] += starts[node]);
    let mut filled = starts.clone();
    let mut cells_of = vec![0; starts[count]];
    for (cell, nodes) in cells.enumerate() {
        for node in nodes {
            cells_of[filled[node - first]] = cell;
            filled[node - first] += 1;
        }
    }
    (starts, cells_of)
}
