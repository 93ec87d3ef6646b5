//! The condensed contact problem of a mesh, and our solution of it, as arrays of NumPy: matrices to test other
//! algorithms on.

use std::io::{Cursor, Seek, Write};

use npyz::{AutoSerialize, WriterBuilder};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::contact::ContactPoint;
use crate::referee::export::rows::retained;
use crate::solution::PointState;
use crate::solve::{Discretisation, Run};

/// Name of the file.
pub const FILE: &str = "condensed.npz";

/// What is in the file, for the sheet.
pub const TEXT: &str = "\
## Condensed problem

`condensed.npz` has the contact problem of the exported mesh (node contact element), condensed to the n normal \
displacements u of the candidate
contact nodes, and our solution of it. In numpy: `S, B, f, g, A, p = (numpy.load(\"condensed.npz\")[k] for k in \
\"SBfgAp\")`.

With the contact forces F = A p, compressive ones positive, at m contact points: find u and F with

    S u + Bᵀ F = f,    h = g − B u ≥ 0,    F ≥ 0,    F·h = 0.

It has one u, of least ½ uᵀ S u − fᵀ u over B u ≤ g. S is symmetric, and positive definite on all u that supports \
hold; a motion that contact alone
holds is in its null space. Where there is none, it is the linear complementarity problem 0 ≤ F ⟂ B S⁻¹ Bᵀ F + g − B \
S⁻¹ f ≥ 0. Of a symmetric scene
all is of the modelled half.

| array | shape | unit | what |
|---|---|---|---|
| `S` | n × n | N/mm | condensed stiffness |
| `f` | n | N | condensed load |
| `B` | m × n | – | approach w = B u, positive closing |
| `g` | m | mm | initial gap; negative is interference, infinite where there is no other side |
| `A` | m | mm² | area of the point |
| `s` | m | mm, or rad on an arc | contact coordinate |
| `contact` | m | – | index of the contact, from 0 |
| `x`, `n` | n × 2 | mm, – | place and outward normal of the node of each u |
| `u`, `p`, `h` | n, m, m | mm, MPa, mm | our solution: displacement along the normal, pressure, remaining gap |
";

/// The file: arrays of a mesh and of a run on it.
pub fn npz(discretisation: &Discretisation, run: &Run) -> Vec<u8> {
    let condensed = &discretisation.condensed;
    let points = discretisation.points(&run.formulation);
    let (n, m) = (condensed.retained(), points.len());
    let mut rows = vec![0.0; m * n];
    rows.chunks_mut(n).zip(&points).for_each(|(row, point)| point.add_row(1.0, row));
    let nodes: Vec<(usize, [f64; 2])> = (0..n).map(|dof| retained(discretisation, dof)).collect();
    let of = |number: fn(&ContactPoint) -> f64| points.iter().map(number).collect::<Vec<f64>>();
    let found = |number: fn(&PointState) -> f64| run.solution.points.iter().map(number).collect::<Vec<f64>>();
    let arrays: [(&str, Vec<usize>, Vec<f64>); 11] = [
        ("S", vec![n, n], (0..n * n).map(|k| condensed.stiffness[(k / n, k % n)]).collect()),
        ("f", vec![n], condensed.load.clone()),
        ("B", vec![m, n], rows),
        ("g", vec![m], of(|point| point.gap)),
        ("A", vec![m], of(|point| point.weight)),
        ("s", vec![m], of(|point| point.position)),
        ("x", vec![n, 2], nodes.iter().flat_map(|(node, _)| discretisation.mesh.points[*node]).collect()),
        ("n", vec![n, 2], nodes.iter().flat_map(|(_, normal)| *normal).collect()),
        ("u", vec![n], run.solution.displacement.clone()),
        ("p", vec![m], found(|point| point.pressure)),
        ("h", vec![m], found(|point| point.gap)),
    ];
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    arrays.into_iter().for_each(|(name, shape, values)| add(&mut archive, name, &shape, values));
    add(&mut archive, "contact", &[m], points.iter().map(|point| point.contact as i64).collect());
    archive.finish().expect("memory can be written to").into_inner()
}

/// Adds an array.
fn add<T: AutoSerialize>(archive: &mut ZipWriter<impl Write + Seek>, name: &str, shape: &[usize], values: Vec<T>) {
    let shape: Vec<u64> = shape.iter().map(|&length| length as u64).collect();
    let written = archive
        .start_file(npyz::npz::file_name_from_array_name(name), SimpleFileOptions::default())
        .map_err(std::io::Error::from)
        .and_then(|()| npyz::WriteOptions::new().default_dtype().shape(&shape).writer(archive).begin_nd())
        .and_then(|mut array| array.extend(values).and_then(|()| array.finish()));
    written.expect("memory can be written to");
}
