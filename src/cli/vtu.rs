//! Displacement, stress, pressure and gap as a VTK unstructured grid (`.vtu`), which ParaView opens.

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version, VertexNumbers, Vtk,
};

use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::{Mesh, Order};
use crate::solution::PointState;
use crate::solve::Discretisation;
use crate::solve::Run;

/// The text of the file. Lengths in mm, stresses in MPa, tension positive; pressure is 0 and the gap NaN away from the
/// candidates.
pub fn text(discretisation: &Discretisation, run: &Run) -> Result<String, Error> {
    let mesh = &discretisation.mesh;
    let fields = discretisation.recover_under(run.share(), &run.solution)?;
    let in_space =
        |plane: &[[f64; 2]]| -> Vec<f64> { evenly(mesh, plane).iter().flat_map(|[x, y]| [*x, *y, 0.0]).collect() };
    let scalars = |values: Vec<f64>| -> Vec<f64> {
        evenly(mesh, &values.into_iter().map(|value| [value]).collect::<Vec<_>>()).into_flattened()
    };
    let [pressure, gap] = on_candidates(discretisation, run);
    let nodes = mesh.order.nodes_per_cell();
    let count = mesh.cells();
    let kind = match mesh.order {
        Order::Linear => CellType::Quad,
        Order::Quadratic => CellType::QuadraticQuad,
        _ => CellType::LagrangeQuadrilateral,
    };
    let bodies = mesh.bodies.iter().enumerate().flat_map(|(k, body)| vec![k as u32; body.cells.len()]);
    let piece = UnstructuredGridPiece {
        points: in_space(&mesh.points).into(),
        cells: Cells {
            cell_verts: VertexNumbers::XML {
                connectivity: mesh.connectivity.iter().map(|&node| node as u64).collect(),
                offsets: (1..=count).map(|k| (k * nodes) as u64).collect(),
            },
            types: vec![kind; count],
        },
        data: Attributes {
            point: vec![
                Attribute::vectors("displacement [mm]").with_data(in_space(&fields.displacement)),
                Attribute::generic("stress x, y, xy [MPa]", 3).with_data(evenly(mesh, &fields.stress).into_flattened()),
                Attribute::scalars("von Mises [MPa]", 1).with_data(scalars(discretisation.von_mises(&fields))),
                Attribute::scalars("pressure [MPa]", 1).with_data(scalars(pressure)),
                Attribute::scalars("gap [mm]", 1).with_data(scalars(gap)),
            ],
            cell: vec![Attribute::scalars("body", 1).with_data(bodies.collect::<Vec<u32>>())],
        },
    };
    let file = Vtk {
        version: Version { major: 1, minor: 0 },
        title: discretisation.scene.name.clone(),
        byte_order: ByteOrder::LittleEndian,
        file_path: None,
        data: DataSet::inline(piece),
    };
    let mut text = Vec::new();
    file.write_xml(&mut text)
        .map_err(|error| Error::at("--vtu", format!("the fields cannot be written: {error}"), "leave --vtu out"))?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// Nodal values as VTK wants them: the nodes of its Lagrange cells lie evenly on the lattice of a cell, those of ours on
/// Gauss–Lobatto–Legendre points; the polynomials are the same.
fn evenly<const N: usize>(mesh: &Mesh, values: &[[f64; N]]) -> Vec<[f64; N]> {
    let mut out = values.to_vec();
    if !mesh.order.is_tensor() {
        return out;
    }
    let (n, m) = (mesh.order.nodes_per_cell(), mesh.order.intervals() as f64);
    let natural = |k: usize| 2.0 * k as f64 / m - 1.0;
    let shapes = |place: [usize; 2]| shape_functions::cell(n, place.map(natural));
    let shapes: Vec<_> = mesh.order.places().into_iter().map(shapes).collect();
    for cell in 0..mesh.cells() {
        let nodes = mesh.cell(cell);
        for (&node, shapes) in nodes.iter().zip(&shapes) {
            // Nodes that take no part may have no value.
            let taking = || nodes.iter().zip(shapes).filter(|(_, (shape, _))| shape.abs() > NOTHING);
            out[node] = std::array::from_fn(|k| taking().map(|(&other, (shape, _))| shape * values[other][k]).sum());
        }
    }
    out
}

/// A shape function that is zero but for rounding.
const NOTHING: f64 = 1e-12;

/// Pressure and gap at the candidate nodes of all bodies, linear between the contact points.
fn on_candidates(discretisation: &Discretisation, run: &Run) -> [Vec<f64>; 2] {
    let mesh = &discretisation.mesh;
    let (mut pressure, mut gap) = (vec![0.0; mesh.points.len()], vec![f64::NAN; mesh.points.len()]);
    for (contact, pair) in discretisation.scene.contacts.iter().enumerate() {
        let points = run.solution.points_of(contact);
        let gaps: Vec<PointState> = points.iter().map(|point| PointState { pressure: point.gap, ..*point }).collect();
        for body in pair.bodies() {
            let part = &mesh.bodies[body];
            for candidate in &part.candidates[part.candidates_of(contact)] {
                // Of the primary body an edge may reach beyond the stretch, where there is no gap to tell.
                if candidate.coordinate.abs() <= pair.stretch * (1.0 + 1e-9) {
                    pressure[candidate.node] = profile::interpolate(points, pair.stretch, candidate.coordinate);
                    gap[candidate.node] = profile::interpolate(&gaps, pair.stretch, candidate.coordinate);
                }
            }
        }
    }
    [pressure, gap]
}
