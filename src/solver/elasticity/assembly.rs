//! Lower triangle of the stiffness matrix, straight into compressed columns.

use std::collections::BTreeMap;
use std::ops::Range;

use faer::sparse::{SparseColMat, SymbolicSparseColMat};

use crate::elasticity::element::{CellStiffness, degenerate};
use crate::elasticity::{Dofs, Freedom, Index, NodeGraph};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// Cells that a thread of its own pays for; fewer are assembled in one piece.
const PAYS: usize = 2048;

/// `K = Σ Tᵀ k T` of a body, every cell's `k` times a factor of its index; prescribed displacements move to the load,
/// `f ← f − k u_p`.
///
/// Large bodies are assembled in two halves, which are then added: the same sums on any number of threads.
pub fn stiffness(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    (graph, dofs): (&NodeGraph, &Dofs),
    factor: &(dyn Fn(usize) -> f64 + Sync),
    force: &mut [f64],
) -> Result<SparseColMat<Index, f64>, Error> {
    let material = &scene.bodies[body].material;
    let kernel = CellStiffness::of(mesh.order, material, scene.plane, scene.thickness);
    let pattern = Pattern::of(graph, dofs);
    let sum = |cells: Range<usize>| {
        let values = vec![0.0; pattern.columns.row_idx().len()];
        let mut sum = Sum { values, force: vec![0.0; dofs.equations], ascending: vec![], places: vec![] };
        let mut k = vec![0.0; kernel.entries()];
        for cell in cells {
            let nodes = mesh.cell(cell);
            kernel
                .integrate(nodes.iter().map(|&node| mesh.points[node]), &mut k)
                .map_err(|jacobian| degenerate(scene, body, cell, jacobian))?;
            let factor = factor(cell);
            k.iter_mut().for_each(|entry| *entry *= factor);
            dofs.rotate(nodes, &mut k);
            sum.add(nodes, &k, dofs, &pattern);
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
    Ok(SparseColMat::new(pattern.columns, total.values))
}

/// Where the lower triangle can have entries: equations of nodes that share a cell.
struct Pattern {
    /// Rows of every column, ascending.
    columns: SymbolicSparseColMat<Index>,
    /// Whether a column has the rows of the column before without the first of them, as the second equation of a node.
    follows: Vec<bool>,
}

impl Pattern {
    /// Rows are handed to their columns in ascending order, so that the rows of every column ascend.
    fn of(graph: &NodeGraph, dofs: &Dofs) -> Self {
        let n = dofs.equations;
        let of_node = |pair: &[Freedom; 2]| pair.map(|dof| dof.equation().map_or(Index::MAX, |e| e as Index));
        let equations: Vec<[Index; 2]> = dofs.components.iter().map(of_node).collect();
        // The node of each equation; the common equation of a tied face has several.
        let (mut owner, mut further) = (vec![usize::MAX; n], BTreeMap::<usize, Vec<usize>>::new());
        for (node, pair) in dofs.components.iter().enumerate() {
            for equation in pair.iter().filter_map(Freedom::equation) {
                if owner[equation] == usize::MAX {
                    owner[equation] = node;
                } else {
                    further.entry(equation).or_default().push(node);
                }
            }
        }
        let alone = |equation: usize| further.is_empty() || !further.contains_key(&equation);
        let follows: Vec<bool> =
            (0..n).map(|e| e > 0 && owner[e] == owner[e - 1] && alone(e) && alone(e - 1)).collect();
        let none = Vec::new();
        // The columns of every row, row by row, while those of every column are counted.
        let (mut row_ends, mut columns) =
            (Vec::with_capacity(n), Vec::with_capacity(graph.entries_of_lower_triangle()));
        let (mut starts, mut last) = (vec![0 as Index; n + 1], vec![Index::MAX; n]);
        let mut from = 0;
        for row in 0..n {
            let of_row = columns.len();
            if follows[row] {
                columns.extend_from_within(from..);
                columns.push(row as Index);
            } else {
                for &node in std::iter::once(&owner[row]).chain(further.get(&row).unwrap_or(&none)) {
                    for column in graph.neighbours(node).flat_map(|other| equations[other]) {
                        if column <= row as Index && last[column as usize] != row as Index {
                            last[column as usize] = row as Index;
                            columns.push(column);
                        }
                    }
                }
            }
            columns[of_row..].iter().for_each(|&column| starts[column as usize + 1] += 1);
            row_ends.push(columns.len());
            from = of_row;
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
        Self { columns: SymbolicSparseColMat::new_checked(n, n, starts, None, rows), follows }
    }
}

/// Values of the lower triangle, and what prescribed displacements add to the load.
struct Sum {
    values: Vec<f64>,
    force: Vec<f64>,
    /// Equations of the cell at hand with their place in it, ascending.
    ascending: Vec<(Index, usize)>,
    /// Where the rows of these stand in the column at hand.
    places: Vec<usize>,
}

impl Sum {
    /// Both sums.
    fn with(mut self, other: &Self) -> Self {
        self.values.iter_mut().zip(&other.values).for_each(|(a, b)| *a += b);
        self.force.iter_mut().zip(&other.force).for_each(|(a, b)| *a += b);
        self
    }

    /// Adds the stiffness of a cell, its rows one after the other.
    fn add(&mut self, nodes: &[usize], k: &[f64], dofs: &Dofs, pattern: &Pattern) {
        let (starts, rows) = (pattern.columns.col_ptr(), pattern.columns.row_idx());
        let side = 2 * nodes.len();
        let of_cell = || nodes.iter().flat_map(|&node| dofs.of_node(node)).enumerate();
        let Self { values, ascending, places, .. } = self;
        ascending.clear();
        ascending.extend(of_cell().filter_map(|(i, dof)| Some((dof.equation()? as Index, i))));
        ascending.sort_unstable();
        places.resize(ascending.len(), 0);
        for (first, &(column, j)) in ascending.iter().enumerate() {
            let start = starts[column as usize] as usize;
            let rest = places[first..].iter_mut().zip(&ascending[first..]);
            if first > 0 && pattern.follows[column as usize] && ascending[first - 1].0 + 1 == column {
                let shift = start - starts[column as usize - 1] as usize - 1;
                rest.for_each(|(place, _)| *place += shift);
            } else {
                let mut at = start;
                for (place, &(row, _)) in rest {
                    while rows[at] < row {
                        at += 1;
                    }
                    *place = at;
                }
            }
            // A tied equation occurs at several places of a cell: all of them meet on the diagonal.
            let above = ascending[..first].iter().rev().take_while(|(row, _)| *row == column);
            above.for_each(|&(_, i)| values[start] += k[j * side + i]);
            for (&place, &(_, i)) in places[first..].iter().zip(&ascending[first..]) {
                values[place] += k[j * side + i];
            }
        }
        for (j, dof) in of_cell() {
            if let Freedom::Prescribed(u) = dof
                && u.abs() > 0.0
            {
                ascending.iter().for_each(|&(row, i)| self.force[row as usize] -= k[i * side + j] * u);
            }
        }
    }
}
