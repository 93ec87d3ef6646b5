//! Answers as VTK unstructured grids (`.vtu`, or `.vtk` of the legacy format): nodal pressure, or stress, on the mesh of the other code.

use std::path::Path;

use vtkio::Vtk;
use vtkio::model::{Attribute, CellType, Cells, DataSet, Piece, UnstructuredGridPiece};

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, Handed, Point, contact_named, joined, ordered, signed_coordinate};
use crate::referee::asked::Asked;
use crate::referee::field::Field as Displaced;
use crate::referee::side::{self, Cell};
use crate::referee::units::Role;
use crate::referee::vtu::{self, AGAIN};
use crate::scene::{ContactPair, Scene};

/// Names that fields have without being named, by what they hold.
const USUAL: [(Role, &[&str]); 4] = [
    (Role::Pressure, &["contact_pressure", "pressure"]),
    (Role::Gap, &["contact_gap", "gap"]),
    (Role::Displacement, &["displacement"]),
    (Role::Stress, &["stress"]),
];

/// The answer in the bytes of a file.
pub fn parse(file: &Path, bytes: &[u8], scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let wanted = match (&asked.contact, scene.contacts.len()) {
        (None, several) if several > 1 => (0..several).collect(),
        (name, _) => {
            vec![contact_named(scene, name.as_deref(), |message, remedy| Error::file(file, message, remedy))?]
        }
    };
    let grid = Grid::of(file, bytes)?;
    let length = grid.factor(Role::Position, "the points", asked)?;
    let points: Vec<[f64; 2]> =
        grid.points.chunks_exact(3).map(|point| [length * point[0], length * point[1]]).collect();
    let cells = cells(file, &grid.cells, points.len())?;
    let (mut contacts, mut read) = (Vec::new(), Vec::new());
    for contact in wanted {
        let (handed, how) = grid.contact(scene, contact, &points, &cells, asked)?;
        contacts.push(handed);
        read.extend(how);
    }
    read.sort();
    read.dedup();
    let field = grid.displaced(length, cells, asked)?;
    Ok(Answer { file: file.into(), code: None, read, contacts, field })
}

/// The grid of a file.
struct Grid<'a> {
    file: &'a Path,
    points: Vec<f64>,
    cells: Cells,
    fields: Vec<Field>,
}

/// Numbers at the nodes.
struct Field {
    name: String,
    components: usize,
    data: Vec<f64>,
}

impl<'a> Grid<'a> {
    fn of(file: &'a Path, bytes: &[u8]) -> Result<Self, Error> {
        let refused = |why: String| Error::unreadable(file, why, AGAIN);
        let xml = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vtu"));
        let parsed = if xml { Vtk::parse_xml(&*vtu::as_text(file, bytes)?) } else { Vtk::parse_legacy_be(bytes) };
        let vtk = parsed.map_err(|error| refused(error.to_string()))?;
        let DataSet::UnstructuredGrid { pieces, .. } = vtk.data else {
            return Err(refused("it is no unstructured grid".into()));
        };
        let mut inline =
            pieces.into_iter().filter_map(|piece| if let Piece::Inline(piece) = piece { Some(*piece) } else { None });
        let (Some(piece), None) = (inline.next(), inline.next()) else {
            return Err(refused("it has not one piece".into()));
        };
        let UnstructuredGridPiece { points, cells, data } = piece;
        let points: Vec<f64> = points.cast_into().ok_or_else(|| refused("its points are no numbers".into()))?;
        if points.iter().any(|x| !x.is_finite()) || !points.len().is_multiple_of(3) {
            return Err(refused("its points are not three finite numbers each".into()));
        }
        let mut fields = Vec::new();
        for attribute in data.point {
            match attribute {
                Attribute::DataArray(array) => {
                    let (name, components) = (array.name.clone(), array.num_comp());
                    fields.extend(array.data.cast_into().map(|data| Field { name, components, data }));
                }
                Attribute::Field { data_array, .. } => fields.extend(data_array.into_iter().filter_map(|array| {
                    let (name, components) = (array.name.clone(), array.elem as usize);
                    array.data.cast_into().map(|data| Field { name, components, data })
                })),
            }
        }
        let count = points.len() / 3;
        fields.retain(|field| field.components > 0 && field.data.len() == field.components * count);
        Ok(Self { file, points, cells, fields })
    }

    /// One contact, and what was read as what.
    fn contact(
        &self,
        scene: &Scene,
        contact: usize,
        points: &[[f64; 2]],
        cells: &[Cell],
        asked: &Asked,
    ) -> Result<(Handed, Vec<String>), Error> {
        let (file, pair) = (self.file, &scene.contacts[contact]);
        let edges = side::edges(scene, contact, points, cells);
        if edges.is_empty() {
            let name = &pair.name;
            let message =
                format!("no edge of its cells lies on the side of contact `{name}`, within the candidate stretch");
            return Err(Error::file(
                file,
                message,
                "hand in the mesh in the coordinates of the scene, undeformed, in plane cells; --contact names one of several",
            ));
        }
        let mut nodes: Vec<usize> = edges.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let quadratic = edges.iter().all(|edge| edge.len() == 3);
        let order = asked.order.unwrap_or(if quadratic { Order::Quadratic } else { Order::Linear });
        let (value, mut read) = self.pressures(&nodes, points, scene, contact, asked)?;
        let gaps = self.gaps(&nodes, points, pair, &value, asked, &mut read)?;
        let point = |(k, node): (usize, &usize)| Point {
            position: signed_coordinate(pair, points[*node]),
            value: asked.sign() * value[k],
            area: None,
            gap: gaps.as_ref().map(|gaps| gaps[k]),
        };
        let mut points: Vec<Point> = nodes.iter().enumerate().map(point).collect();
        if side::have_own_points(cells) {
            let all = points.len();
            points = joined(points);
            read.push(format!("means of {all} points of cells at {} places of the contact side", points.len()));
        }
        let points = ordered(points, order, |message, remedy| {
            Error::file(file, format!("its contact side: {message}"), remedy)
        })?;
        Ok((Handed { contact, points, order, edges: vec![], forces: false }, read))
    }

    /// What turns numbers of a role into ours: no grid says its units.
    fn factor(&self, role: Role, what: &str, asked: &Asked) -> Result<f64, Error> {
        let remedy = format!("give --unit {}=UNIT, with one of {}", role.name(), role.known_units());
        let Some(unit) = asked.unit(role) else {
            return Err(Error::file(self.file, format!("it does not say the unit of {what}"), remedy));
        };
        role.factor(unit).ok_or_else(|| Error::file(self.file, format!("the unit `{unit}` is not known"), remedy))
    }

    /// The field of a role; none where there is none of its usual names, and none was named.
    fn field(&self, role: Role, asked: &Asked) -> Result<Option<&Field>, Error> {
        let first = |is_it: &dyn Fn(&str) -> bool| self.fields.iter().find(|field| is_it(&field.name));
        let found = |name: &str| first(&|own| own == name).or_else(|| first(&|own| own.eq_ignore_ascii_case(name)));
        let usual = USUAL.iter().find(|(known, _)| *known == role).map_or(&[][..], |(_, names)| *names);
        let Some(name) = asked.column(role) else { return Ok(usual.iter().find_map(|name| found(name))) };
        let known: Vec<&str> = self.fields.iter().map(|field| field.name.as_str()).collect();
        let refused = || {
            Error::file(
                self.file,
                format!("it has no nodal field `{name}` among {}", known.join(", ")),
                "name one of them by --column",
            )
        };
        found(name).map(Some).ok_or_else(refused)
    }

    /// Pressures of some nodes, of a field or from the stresses; and what was read.
    fn pressures(
        &self,
        nodes: &[usize],
        points: &[[f64; 2]],
        scene: &Scene,
        contact: usize,
        asked: &Asked,
    ) -> Result<(Vec<f64>, Vec<String>), Error> {
        if let Some(field) = self.field(Role::Pressure, asked)?.filter(|field| field.components == 1) {
            let factor = self.factor(Role::Pressure, &format!("`{}`", field.name), asked)?;
            let values = nodes.iter().map(|&node| self.finite(field, node, 0).map(|value| factor * value));
            return Ok((values.collect::<Result<_, Error>>()?, vec![format!("`{}` as pressure", field.name)]));
        }
        let known: Vec<&str> = self.fields.iter().map(|field| field.name.as_str()).collect();
        let places = self.field(Role::Stress, asked)?.and_then(|field| match field.components {
            9 => Some((field, [0, 4, 1])),
            6 => Some((field, [0, 1, 3])),
            _ => None,
        });
        let Some((field, at)) = places else {
            let message = format!(
                "no nodal field is called contact_pressure, pressure or stress (of 6 or 9 components), but {}",
                known.join(", ")
            );
            return Err(Error::file(self.file, message, "name one by --column pressure=NAME or --column stress=NAME"));
        };
        let factor = self.factor(Role::Stress, &format!("`{}`", field.name), asked)?;
        let pair = &scene.contacts[contact];
        let pressure = |&node: &usize| -> Result<f64, Error> {
            let [x, y, xy] = at.map(|k| self.finite(field, node, k));
            let (n, [x, y, xy]) = (pair.normal(points[node]), [x?, y?, xy?]);
            Ok(0.0 - factor * (n[0] * n[0] * x + n[1] * n[1] * y + 2.0 * n[0] * n[1] * xy))
        };
        let read = format!("−n·σn of `{}` as pressure, {} components", field.name, field.components);
        Ok((nodes.iter().map(pressure).collect::<Result<_, Error>>()?, vec![read]))
    }

    /// Remaining gaps of some nodes: a field, or from the displacements where the other side is rigid and its gap a formula.
    fn gaps(
        &self,
        nodes: &[usize],
        points: &[[f64; 2]],
        pair: &ContactPair,
        pressures: &[f64],
        asked: &Asked,
        read: &mut Vec<String>,
    ) -> Result<Option<Vec<f64>>, Error> {
        if let Some(field) = self.field(Role::Gap, asked)?.filter(|field| field.components == 1) {
            let factor = self.factor(Role::Gap, &format!("`{}`", field.name), asked)?;
            read.push(format!("`{}` as gap", field.name));
            // Where nothing presses, NaN says that there is no other side.
            let none = |node: usize, pressure: f64| field.data[node].is_nan() && pressure.abs() <= 0.0;
            return nodes
                .iter()
                .zip(pressures)
                .map(|(&node, &pressure)| match none(node, pressure) {
                    true => Ok(f64::INFINITY),
                    false => self.finite(field, node, 0).map(|value| factor * value),
                })
                .collect::<Result<_, Error>>()
                .map(Some);
        }
        let Some(field) = self.field(Role::Displacement, asked)?.filter(|field| field.components >= 2) else {
            return Ok(None);
        };
        let initial = |node: usize| pair.profile.gap(pair.path.coordinate(points[node]));
        if pair.second.is_some() || nodes.iter().any(|&node| initial(node).is_nan()) {
            return Ok(None);
        }
        let factor = self.factor(Role::Displacement, &format!("`{}`", field.name), asked)?;
        read.push(format!("initial gap less `{}` along the normal as gap", field.name));
        let gap = |&node: &usize| -> Result<f64, Error> {
            let [u, v] = [self.finite(field, node, 0)?, self.finite(field, node, 1)?];
            let n = pair.normal(points[node]);
            Ok(initial(node) - factor * (n[0] * u + n[1] * v))
        };
        nodes.iter().map(gap).collect::<Result<_, Error>>().map(Some)
    }

    /// Displacements of all nodes, where they are there and their unit is named.
    fn displaced(&self, length: f64, cells: Vec<Cell>, asked: &Asked) -> Result<Option<Displaced>, Error> {
        let Some(field) = self.field(Role::Displacement, asked)?.filter(|field| field.components >= 2) else {
            return Ok(None);
        };
        if asked.unit(Role::Displacement).is_none() {
            return Ok(None);
        }
        let factor = self.factor(Role::Displacement, &format!("`{}`", field.name), asked)?;
        let points = self.points.chunks_exact(3).map(|point| [length * point[0], length * point[1]]).collect();
        let moved = field.data.chunks_exact(field.components).map(|moved| [factor * moved[0], factor * moved[1]]);
        Ok(Some(Displaced { points, cells, displacement: moved.collect() }))
    }

    fn finite(&self, field: &Field, node: usize, component: usize) -> Result<f64, Error> {
        let value = field.data[node * field.components + component];
        let refused = || {
            Error::file(
                self.file,
                format!("`{}` is {value} at node {node}, on the contact side", field.name),
                "hand in finite numbers there",
            )
        };
        if value.is_finite() { Ok(value) } else { Err(refused()) }
    }
}

/// Plane cells of the grid; others are refused.
fn cells(file: &Path, cells: &Cells, points: usize) -> Result<Vec<Cell>, Error> {
    let refused = |message: String| Error::file(file, message, AGAIN);
    let (connectivity, offsets) = cells.cell_verts.clone().into_xml();
    if offsets.len() != cells.types.len() {
        return Err(refused(format!("it has {} cells, but {} types", offsets.len(), cells.types.len())));
    }
    let mut found = Vec::new();
    let mut begin = 0;
    for (end, kind) in offsets.into_iter().zip(&cells.types) {
        let range = begin..end as usize;
        begin = end as usize;
        let corners = match kind {
            CellType::Triangle | CellType::QuadraticTriangle => 3,
            CellType::Quad | CellType::QuadraticQuad | CellType::BiquadraticQuad => 4,
            CellType::Vertex | CellType::Line | CellType::QuadraticEdge => continue,
            other => return Err(refused(format!("it has cells of the type {other:?}, and scenes are plane"))),
        };
        let nodes: Option<Vec<usize>> =
            connectivity.get(range).map(|nodes| nodes.iter().map(|&node| node as usize).collect());
        match nodes {
            Some(nodes) if nodes.len() >= corners && nodes.iter().all(|&node| node < points) => {
                found.push(Cell { nodes, corners })
            }
            _ => return Err(refused("its cells name nodes that are not there".into())),
        }
    }
    Ok(found)
}
