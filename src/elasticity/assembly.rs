//! Lower triangle of the stiffness matrix, straight into compressed columns.

use std::collections::BTreeMap;
use std::ops::Range;

use faer::sparse::{SparseColMat, SymbolicSparseColMat};

use crate::elasticity::element::CellStiffness;
use crate::elasticity::{Freedom, Freedoms, Index, NodeGraph};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// Cells that a thread of its own pays for; fewer are assembled in one piece.
const PAYS: usize = 512;

/// `K = Σ Tᵀ k T` of a body, every cell's `k` times a factor of its index; prescribed displacements move to the load,
/// `f ← f − k u_p`.
///
/// Large bodies are assembled in two halves, which are then added: the same sums on any number of threads.
pub fn stiffness(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    (graph, freedoms): (&NodeGraph, &Freedoms),
    factor: &(dyn Fn(usize) -> f64 + Sync),
    force: &mut [f64],
) -> Result<SparseColMat<Index, f64>, Error> {
    let material = &scene.bodies[body].material;
    let kernel = CellStiffness::new(mesh.order, &material.stiffness(scene.plane), scene.thickness);
    let pattern = pattern(graph, freedoms);
    let sum = |cells: Range<usize>| {
        let mut sum = Sum { values: vec![0.0; pattern.row_idx().len()], force: vec![0.0; freedoms.equations] };
        let mut k = vec![0.0; kernel.entries()];
        for cell in cells {
            let nodes = mesh.cell(cell);
            kernel
                .integrate(nodes.iter().map(|&node| mesh.points[node]), &mut k)
                .map_err(|jacobian| Error::DegenerateCell { cell, body: scene.bodies[body].name.clone(), jacobian })?;
            let factor = factor(cell);
            k.iter_mut().for_each(|entry| *entry *= factor);
            freedoms.rotate(nodes, &mut k);
            sum.add(nodes, &k, freedoms, &pattern);
        }
        Ok(sum)
    };
    let Range { start, end } = mesh.bodies[body].cells.clone();
    let middle = start + (end - start) / 2;
    let total = if end - start < 2 * PAYS {
        sum(start..end)?
    } else {
        let (first, second) = rayon::join(|| sum(start..middle), || sum(middle..end));
        first?.with(&second?)
    };
    force.iter_mut().zip(&total.force).for_each(|(f, change)| *f += change);
    Ok(SparseColMat::new(pattern, total.values))
}

/// Where the lower triangle can have entries: equations of nodes that share a cell.
///
/// Rows are handed to their columns in ascending order, so that the rows of every column ascend.
fn pattern(graph: &NodeGraph, freedoms: &Freedoms) -> SymbolicSparseColMat<Index> {
    let n = freedoms.equations;
    let of_node = |pair: &[Freedom; 2]| pair.map(|freedom| freedom.equation().map_or(Index::MAX, |e| e as Index));
    let equations: Vec<[Index; 2]> = freedoms.components.iter().map(of_node).collect();
    // The node of each equation; the common equation of a tied face has several.
    let (mut owner, mut further) = (vec![usize::MAX; n], BTreeMap::<usize, Vec<usize>>::new());
    for (node, pair) in freedoms.components.iter().enumerate() {
        for equation in pair.iter().filter_map(Freedom::equation) {
            if owner[equation] == usize::MAX {
                owner[equation] = node;
            } else {
                further.entry(equation).or_default().push(node);
            }
        }
    }
    let none = Vec::new();
    // The columns of every row, row by row, while those of every column are counted.
    let (mut row_ends, mut columns) = (Vec::with_capacity(n), Vec::new());
    let (mut starts, mut last) = (vec![0 as Index; n + 1], vec![Index::MAX; n]);
    for row in 0..n as Index {
        for &node in std::iter::once(&owner[row as usize]).chain(further.get(&(row as usize)).unwrap_or(&none)) {
            for other in graph.neighbours(node) {
                for column in equations[other] {
                    if column <= row && last[column as usize] != row {
                        last[column as usize] = row;
                        starts[column as usize + 1] += 1;
                        columns.push(column);
                    }
                }
            }
        }
        row_ends.push(columns.len());
    }
    (0..n).for_each(|column| starts[column + 1] += starts[column]);
    let (mut rows, mut filled) = (vec![0; columns.len()], starts.clone());
    let mut from = 0;
    for (row, &end) in row_ends.iter().enumerate() {
        for &column in &columns[from..end] {
            let at = &mut filled[column as usize];
            rows[*at as usize] = row as Index;
            *at += 1;
        }
        from = end;
    }
    SymbolicSparseColMat::new_checked(n, n, starts, None, rows)
}

/// Values of the lower triangle, and what prescribed displacements add to the load.
struct Sum {
    values: Vec<f64>,
    force: Vec<f64>,
}

impl Sum {
    /// Both sums.
    fn with(mut self, other: &Self) -> Self {
        self.values.iter_mut().zip(&other.values).for_each(|(a, b)| *a += b);
        self.force.iter_mut().zip(&other.force).for_each(|(a, b)| *a += b);
        self
    }

    /// Adds the stiffness of a cell, its rows one after the other.
    fn add(&mut self, nodes: &[usize], k: &[f64], freedoms: &Freedoms, pattern: &SymbolicSparseColMat<Index>) {
        let (starts, rows) = (pattern.col_ptr(), pattern.row_idx());
        let side = 2 * nodes.len();
        let of_cell = || nodes.iter().flat_map(|&node| freedoms.of_node(node)).enumerate();
        let mut ascending = [(0, 0); 16];
        let mut count = 0;
        for (i, freedom) in of_cell() {
            if let Freedom::Equation(equation) = freedom {
                ascending[count] = (equation as Index, i);
                count += 1;
            }
        }
        let ascending = &mut ascending[..count];
        ascending.sort_unstable();
        for (first, &(column, j)) in ascending.iter().enumerate() {
            let mut at = starts[column as usize] as usize;
            // A tied equation occurs at several places of a cell: all of them meet on the diagonal.
            let above = ascending[..first].iter().rev().take_while(|(row, _)| *row == column);
            above.for_each(|&(_, i)| self.values[at] += k[j * side + i]);
            for &(row, i) in &ascending[first..] {
                while rows[at] < row {
                    at += 1;
                }
                self.values[at] += k[j * side + i];
            }
        }
        for (j, freedom) in of_cell() {
            if let Freedom::Prescribed(u) = freedom
                && u.abs() > 0.0
            {
                ascending.iter().for_each(|&(row, i)| self.force[row as usize] -= k[i * side + j] * u);
            }
        }
    }
}
