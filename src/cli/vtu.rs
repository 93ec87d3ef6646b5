//! Displacement, stresses, contact pressure and gap as a VTK unstructured grid (`.vtu`), which ParaView opens.
//!
//! Names are those that its calculator takes: letters, digits and underscores. Lengths are in mm, stresses in MPa,
//! tension positive.
//!
//! | field | at | what |
//! |---|---|---|
//! | `displacement` | nodes | a vector |
//! | `stress_xx`, `stress_yy`, `stress_xy` | nodes | components in the plane |
//! | `stress_zz` | nodes | out of the plane; of bodies of revolution the hoop stress |
//! | `principal_1`, `principal_2`, `principal_3` | nodes | principal stresses, the largest first |
//! | `von_mises` | nodes | equivalent stress |
//! | `contact_pressure` | nodes | 0 away from the candidates |
//! | `contact_gap` | nodes | not a number away from the candidates |
//! | `contact` | nodes | number of the contact that a candidate belongs to, from 0; −1 elsewhere |
//! | `body` | cells | number of the body, from 0 |
//! | `body_NAME` | cells | 1 in the body of that name, 0 elsewhere; other characters are underscores |

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version, VertexNumbers, Vtk,
};

use crate::elasticity::{shape_functions, stress};
use crate::error::Error;
use crate::measure::{nodal, profile};
use crate::mesh::{Mesh, Order};
use crate::solution::PointState;
use crate::solve::fields::Fields;
use crate::solve::{Discretisation, Run};

/// Components of the stress in the plane, by name.
const IN_PLANE: [&str; 3] = ["stress_xx", "stress_yy", "stress_xy"];
/// Principal stresses, the largest first.
const PRINCIPAL: [&str; 3] = ["principal_1", "principal_2", "principal_3"];

/// The text of the file.
pub fn text(discretisation: &Discretisation, run: &Run) -> Result<String, Error> {
    let mesh = &discretisation.mesh;
    let fields = discretisation.recover_under(run.share(), &run.solution)?;
    let (displacement, stress) = (evenly(mesh, &fields.displacement), evenly(mesh, &fields.stress));
    let fields = Fields { displacement, stress, ..fields };
    let points = evenly(mesh, &mesh.points);
    let mut point = of_stress(discretisation, &fields);
    point.insert(0, Attribute::vectors("displacement").with_data(in_space(&fields.displacement)));
    point.extend(on_candidates(discretisation, run, &points));
    let piece = UnstructuredGridPiece {
        points: in_space(&points).into(),
        cells: cells(discretisation),
        data: Attributes { point, cell: of_bodies(discretisation) },
    };
    let file = Vtk {
        version: Version::new_xml(1, 0),
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

/// Whether a text is such a file.
pub fn is_ours(text: &str) -> bool {
    text.starts_with("<VTKFile type=\"UnstructuredGrid\"") && text.contains("Name=\"contact_pressure\"")
}

fn in_space(plane: &[[f64; 2]]) -> Vec<f64> {
    plane.iter().flat_map(|[x, y]| [*x, *y, 0.0]).collect()
}

/// Nodal values as VTK wants them: the nodes of its Lagrange cells lie evenly on the lattice of a cell, those of ours
/// on Gauss–Lobatto–Legendre points; the polynomials are the same.
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
            let terms = || nodes.iter().zip(shapes);
            out[node] = std::array::from_fn(|k| terms().map(|(&other, (shape, _))| shape * values[other][k]).sum());
        }
    }
    out
}

fn cells(discretisation: &Discretisation) -> Cells {
    let mesh = &discretisation.mesh;
    let (nodes, count) = (mesh.order.nodes_per_cell(), mesh.cells());
    let kind = match mesh.order {
        Order::Linear => CellType::Quad,
        Order::Biquadratic => CellType::BiquadraticQuad,
        Order::Quadratic => CellType::QuadraticQuad,
        _ => CellType::LagrangeQuadrilateral,
    };
    Cells {
        cell_verts: VertexNumbers::XML {
            connectivity: mesh.connectivity.iter().map(|&node| node as u64).collect(),
            offsets: (1..=count).map(|k| (k * nodes) as u64).collect(),
        },
        types: vec![kind; count],
    }
}

/// Stresses at the nodes: components, principal ones, von Mises.
fn of_stress(discretisation: &Discretisation, fields: &Fields) -> Vec<Attribute> {
    let across = discretisation.stress_across(fields);
    let principal: Vec<[f64; 3]> =
        fields.stress.iter().zip(&across).map(|(plane, across)| stress::principal(*plane, *across)).collect();
    let column = |name: &str, of: &[[f64; 3]], k: usize| scalar(name, of.iter().map(|row| row[k]).collect());
    let in_plane = IN_PLANE.iter().enumerate().map(|(k, name)| column(name, &fields.stress, k));
    let principal = PRINCIPAL.iter().enumerate().map(|(k, name)| column(name, &principal, k));
    let equivalent = scalar("von_mises", discretisation.von_mises(fields));
    in_plane.chain([scalar("stress_zz", across.clone())]).chain(principal).chain([equivalent]).collect()
}

fn scalar(name: &str, data: Vec<f64>) -> Attribute {
    Attribute::scalars(name, 1).with_data(data)
}

/// The number of the body of every cell, and for each body by its name which cells are its own.
fn of_bodies(discretisation: &Discretisation) -> Vec<Attribute> {
    let mesh = &discretisation.mesh;
    let numbers: Vec<u32> =
        mesh.bodies.iter().enumerate().flat_map(|(k, body)| vec![k as u32; body.cells.len()]).collect();
    let mut names: Vec<String> = Vec::new();
    for (k, body) in discretisation.scene.bodies.iter().enumerate() {
        let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '_' };
        let name = format!("body_{}", body.name.chars().map(plain).collect::<String>());
        // Names that differ in other characters only.
        names.push(if names.contains(&name) { format!("{name}_{k}") } else { name });
    }
    let own = |(k, name): (usize, &String)| {
        let inside: Vec<u32> = numbers.iter().map(|&body| u32::from(body == k as u32)).collect();
        Attribute::scalars(name, 1).with_data(inside)
    };
    let all = names.iter().enumerate().map(own).collect::<Vec<_>>();
    std::iter::once(Attribute::scalars("body", 1).with_data(numbers)).chain(all).collect()
}

/// Pressure, gap and number of the contact at the candidate nodes of all bodies, at their places in the file; between
/// contact points the pressure is that of the edge's polynomial, the gap linear.
fn on_candidates(discretisation: &Discretisation, run: &Run, places: &[[f64; 2]]) -> [Attribute; 3] {
    let mesh = &discretisation.mesh;
    let (mut pressure, mut gap) = (vec![0.0; mesh.points.len()], vec![f64::NAN; mesh.points.len()]);
    let mut of_contact = vec![-1_i32; mesh.points.len()];
    for (contact, pair) in discretisation.scene.contacts.iter().enumerate() {
        let points = run.solution.points_of(contact);
        let gaps: Vec<PointState> = points.iter().map(|point| PointState { pressure: point.gap, ..*point }).collect();
        for body in pair.bodies() {
            let part = &mesh.bodies[body];
            for candidate in &part.candidates[part.candidates_of(contact)] {
                let coordinate = pair.path.coordinate(places[candidate.node]);
                // Of the primary body an edge may reach beyond the stretch, where there is no gap to tell.
                if coordinate.abs() <= pair.stretch * (1.0 + 1e-9) {
                    pressure[candidate.node] = nodal::pressure_at(run.solution.part(contact), pair.stretch, coordinate);
                    gap[candidate.node] = profile::interpolate(&gaps, pair.stretch, coordinate);
                    of_contact[candidate.node] = contact as i32;
                }
            }
        }
    }
    let number = Attribute::scalars("contact", 1).with_data(of_contact);
    [scalar("contact_pressure", pressure), scalar("contact_gap", gap), number]
}
