//! Answers as VTK unstructured grids (`.vtu`, or `.vtk` of the legacy format): nodal pressure, or stress, on the mesh
//! of the other code.

use std::collections::HashMap;
use std::path::Path;

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, Handed, Point, contact_named, joined, without_gaps, without_pull};
use crate::referee::asked::Asked;
use crate::referee::field::Field as Displaced;
use crate::referee::profile::handed;
use crate::referee::side::{self, Cell, Side, signed_coordinate};
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::units::Role;
use crate::referee::unstructured::{Field, Grid};
use crate::referee::vtu::AGAIN;
use crate::referee::{table, vtk, vtu};
use crate::scene::{ContactPair, Scene};

/// Names that fields have without being named, by what they hold. Grids have fields inside bodies too: `p` may be a
/// mean stress there.
const USUAL: [(Role, &[&str]); 4] = [
    (Role::Pressure, &["contact_pressure", "contact pressure", "cpress", "pressure"]),
    (Role::Gap, &["contact_gap", "contact gap", "gap", "copen"]),
    (Role::Displacement, &["displacement", "displacements", "disp", "u"]),
    (Role::Stress, &["stress"]),
];

/// Numbers of components as CalculiX orders those of a contact in a `.frd`.
const CONTACT: &str = "which in CalculiX's order of six is 0 of COPEN, 1 of CSLIP1, 2 of CSLIP2, 3 of CPRESS, 4 of \
    CSHEAR1 and 5 of CSHEAR2";

/// The answer in the bytes of a file.
pub fn parse(file: &Path, bytes: &[u8], scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let source = Source { file, text: "" };
    let wanted = match &asked.contact {
        None => (0..scene.contacts.len()).collect(),
        name => vec![contact_named(scene, name.as_deref(), |message, remedy| source.refused(message, remedy))?],
    };
    let xml = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vtu"));
    let mut grid = if xml { vtu::parse(file, bytes)? } else { vtk::parse(file, bytes)? };
    if grid.points.iter().any(|x| !x.is_finite()) || !grid.points.len().is_multiple_of(3) {
        return Err(Error::unreadable(file, "its points are not three finite numbers each", AGAIN));
    }
    let count = grid.points.len() / 3;
    grid.fields.retain(|field| field.components > 0 && Some(field.data.len()) == count.checked_mul(field.components));
    let length = source.factor(Role::Position, "the place of a point", None, asked.unit(Role::Position))?;
    let points: Vec<[f64; 2]> =
        grid.points.chunks_exact(3).map(|point| [length * point[0], length * point[1]]).collect();
    let cells = grid.cells()?;
    let (mut contacts, mut read) = (Vec::new(), Vec::new());
    for contact in wanted {
        let (own, how) = grid.contact(scene, contact, &points, &cells, asked)?;
        contacts.push(own);
        read.extend(how);
    }
    read.sort();
    read.dedup();
    let state = grid.time.map(|time| State { step: None, time });
    read.extend(state.map(|state| format!("the grid of {state}")));
    // At time 0 stands what has none.
    let notes = state.filter(|state| state.time.abs() > 0.0).map_or_else(Vec::new, |state| state.notes(&[state]));
    let field = grid.displaced(points, cells, asked)?;
    Ok(Answer { file: file.into(), code: None, read, notes, units: asked.units(), contacts, field })
}

/// A quadrilateral of order p, whose nodes lie evenly, as cells of nine nodes, or of four where p is odd; none where no
/// order has so many nodes.
fn parts(nodes: &[usize]) -> Option<Vec<Cell>> {
    let p = nodes.len().isqrt().checked_sub(1).filter(|p| *p > 0 && (p + 1).pow(2) == nodes.len())?;
    let at: HashMap<[usize; 2], usize> = Order::lattice(p).zip(nodes.iter().copied()).collect();
    let step = if p.is_multiple_of(2) { 2 } else { 1 };
    let corners = (0..p).step_by(step).flat_map(|i| (0..p).step_by(step).map(move |j| [i, j]));
    let part = |[i, j]: [usize; 2]| {
        let nodes = Order::lattice(step).map(|[x, y]| at[&[i + x, j + y]]).collect();
        Cell { nodes, corners: 4 }
    };
    Some(corners.map(part).collect())
}

/// A component of a field.
type Part<'f> = (&'f Field, usize);
/// A number of a node, of stresses along a normal; without one along that of the contact.
type OfNode<'f> = Box<dyn Fn(usize, Option<[f64; 2]>) -> f64 + 'f>;

impl Grid<'_> {
    /// Plane cells; others are refused.
    fn cells(&self) -> Result<Vec<Cell>, Error> {
        let refused = |message: String| self.source.refused(message, AGAIN);
        if self.ends.len() != self.types.len() {
            return Err(refused(format!("it has {} cells, but {} types", self.ends.len(), self.types.len())));
        }
        let (mut found, mut begin) = (Vec::new(), 0);
        for (&end, kind) in self.ends.iter().zip(&self.types) {
            let range = begin..end;
            begin = end;
            let (corners, all) = match kind {
                5 => (3, 3),
                22 => (3, 6),
                8 | 9 => (4, 4),
                // Polygons with three nodes or four, and triangles of any order with three or six.
                7 if (3..5).contains(&range.len()) => (range.len(), range.len()),
                69 if [3, 6].contains(&range.len()) => (3, range.len()),
                23 => (4, 8),
                28 => (4, 9),
                // Quadrilaterals of any order.
                70 => (4, self.connectivity.get(range.clone()).map_or(0, <[usize]>::len)),
                // Vertices and lines.
                1..=4 | 21 | 68 => continue,
                other => {
                    let message = format!(
                        "it has cells of VTK's type {other}, and read are those of types 5, 22, 9, 23, 28 and 70, and \
                        7, 8 and 69 of as many nodes"
                    );
                    return Err(self.source.refused(
                        message,
                        "hand in the plane mesh, as triangles of 3 or 6 nodes, or quadrilaterals of 4, 8, 9 or (p + \
                        1)²",
                    ));
                }
            };
            match self.connectivity.get(range) {
                Some(nodes) if nodes.len() == all && nodes.iter().all(|&node| node < self.points.len() / 3) => {
                    let more = match (*kind, nodes) {
                        (70, _) => parts(nodes),
                        // A pixel goes row by row, and not around.
                        (8, &[a, b, c, d]) => Some(vec![Cell { nodes: vec![a, b, d, c], corners }]),
                        _ => Some(vec![Cell { nodes: nodes.to_vec(), corners }]),
                    };
                    let message =
                        || format!("a quadrilateral of VTK's type 70 has {all} nodes, and no square of a number");
                    found.extend(more.ok_or_else(|| refused(message()))?);
                }
                Some(nodes) if nodes.len() != all => {
                    let message =
                        format!("a cell of VTK's type {kind} has {all} nodes, and one here has {}", nodes.len());
                    return Err(refused(message));
                }
                _ => return Err(refused("its cells name nodes that are not there".into())),
            }
        }
        Ok(found)
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
        let (source, pair) = (self.source, &scene.contacts[contact]);
        let (along, how, is_of_stresses) = self.pressures(points, pair, asked)?;
        let pressure = |node: usize| along(node, None);
        let (side, other) = Side::of(&source, (scene, contact), points, cells, |node| Some(pressure(node)))?;
        let mut nodes = side.nodes();
        let place = |node: usize| signed_coordinate(pair, points[node]);
        let known = |&node: &usize| {
            let value = Some(pressure(node)).filter(|value| !value.is_nan());
            let point = |value| Point { position: place(node), value, area: None, gap: None };
            (place(node), value.map(point))
        };
        let infinite = nodes.iter().filter(|&&node| pressure(node).is_infinite()).count();
        let lacking = without_gaps(nodes.iter().map(known).collect()).1 + infinite;
        if lacking > 0 {
            let message = format!(
                "{how}: {lacking} of the {} nodes of contact `{}` have no number, and none is no zero",
                nodes.len(),
                pair.name
            );
            return Err(source.refused(message, "hand in a finite number at every node of the contact side"));
        }
        side.all_pressed(&source, (pair, scene.plane.radial()), points, |node, normal| Some(along(node, normal)))?;
        nodes.retain(|&node| !pressure(node).is_nan());
        let mut value: Vec<f64> = nodes.iter().map(|&node| pressure(node)).collect();
        let mut read = vec![how];
        read.extend(other);
        read.extend(is_of_stresses.then(|| without_pull(value.iter_mut())).flatten());
        let gaps = self.gaps(&nodes, points, pair, &value, asked, &mut read)?;
        let point = |(k, node): (usize, &usize)| Point {
            position: place(*node),
            value: value[k],
            area: None,
            gap: gaps.as_ref().map(|gaps| gaps[k]),
        };
        let mut points: Vec<Point> = nodes.iter().enumerate().map(point).collect();
        if side::have_own_points(cells) {
            let all = points.len();
            points = joined(points);
            read.push(format!("means of {all} points of cells at {} places of the contact side", points.len()));
        }
        let refused = |message, remedy: &str| source.refused(format!("its contact side: {message}"), remedy);
        let order = asked.order.unwrap_or(side.order());
        Ok((handed((scene, contact), points, Some(order), false, refused)?, read))
    }

    /// What turns a field into our unit: no grid says its units but in a name such as `CPRESS [Pa]`.
    fn factor(&self, role: Role, field: &Field, asked: &Asked) -> Result<f64, Error> {
        let written = table::split(&field.name).1.filter(|unit| role.factor(unit).is_some());
        self.source.factor(role, &format!("`{}`", field.name), written, asked.unit(role))
    }

    /// The field of a role, and its component where one is named, `NAME:COMPONENT`; none where there is none of its
    /// usual names, and none was named.
    fn field(&self, role: Role, asked: &Asked) -> Result<Option<(&Field, Option<usize>)>, Error> {
        let first = |is_it: &dyn Fn(&str) -> bool| self.fields.iter().find(|field| is_it(&field.name));
        let found = |name: &str| {
            let is_it = |own: &str| own.eq_ignore_ascii_case(name) || table::split(own).0.eq_ignore_ascii_case(name);
            first(&|own| own == name).or_else(|| first(&is_it))
        };
        let usual = USUAL.iter().find(|(known, _)| *known == role).map_or(&[][..], |(_, names)| *names);
        let Some(name) = asked.column(role) else {
            return Ok(usual.iter().find_map(|name| found(name)).map(|field| (field, None)));
        };
        if let Some(field) = found(name) {
            return Ok(Some((field, None)));
        }
        let part = name.rsplit_once(':').and_then(|(name, component)| Some((found(name)?, component)));
        let Some((field, component)) = part else {
            let known: Vec<&str> = self.fields.iter().map(|field| field.name.as_str()).collect();
            let message = format!("it has no nodal field `{name}` among {}", known.join(", "));
            return Err(self.source.refused(message, "name one of them by --column"));
        };
        match field.component(component) {
            Some(component) => Ok(Some((field, Some(component)))),
            None => Err(self.one_of(role, field)),
        }
    }

    /// What is to be named of a field with several components.
    fn one_of(&self, role: Role, field: &Field) -> Error {
        let names = if field.names.iter().all(String::is_empty) {
            String::new()
        } else {
            format!(" ({})", field.names.join(", "))
        };
        let message =
            format!("`{}` has {} components{names}, of which {} is one", field.name, field.components, role.name());
        let usual = |name: &&String| role.usual().contains(&&*name.to_lowercase());
        let last = field.components - 1;
        let (how, one) = match (field.has_names(), field.components, role) {
            (true, ..) => (String::new(), field.names.iter().find(usual).unwrap_or(&field.names[last]).clone()),
            (_, 6, Role::Pressure) => (format!(" by its number, {CONTACT}"), "3".into()),
            (_, 6, Role::Gap) => (format!(" by its number, {CONTACT}"), "0".into()),
            _ => (format!(" by its number from 0 to {last}, as ParaView does"), last.to_string()),
        };
        self.source.refused(message, format!("name it{how}, such as --column {}={}:{one}", role.name(), field.name))
    }

    /// The one component of a role: of a field that has one, or that is named with one.
    fn part(&self, role: Role, asked: &Asked) -> Result<Option<Part<'_>>, Error> {
        match self.field(role, asked)? {
            Some((field, Some(component))) => Ok(Some((field, component))),
            Some((field, None)) if field.components == 1 => Ok(Some((field, 0))),
            Some((field, None)) if asked.column(role).is_some() => Err(self.one_of(role, field)),
            _ => Ok(None),
        }
    }

    /// The pressure of a node in our unit, of a field or from the stresses; what was read, and whether it is of
    /// stresses.
    fn pressures<'g>(
        &'g self,
        points: &'g [[f64; 2]],
        pair: &'g ContactPair,
        asked: &Asked,
    ) -> Result<(OfNode<'g>, String, bool), Error> {
        if let Some((field, component)) = self.part(Role::Pressure, asked)? {
            let factor = asked.sign() * self.factor(Role::Pressure, field, asked)?;
            let of = if field.components > 1 { format!(", component {component}") } else { String::new() };
            return Ok((
                Box::new(move |node, _| factor * field.at(node, component)),
                format!("`{}`{of} as pressure", field.name),
                false,
            ));
        }
        let stress = self.field(Role::Stress, asked)?.map(|(field, _)| field);
        let places = stress.and_then(|field| {
            let [x, y, xy] = ["xx", "yy", "xy"].map(|name| field.component(name));
            Some((field, [x?, y?, xy?]))
        });
        let is_meant = asked.column(Role::Stress).is_some();
        if let (Some(field), None) = (stress.filter(|field| field.has_names() || is_meant), &places) {
            let known = if field.has_names() { field.names.join(", ") } else { format!("it has {}", field.components) };
            let message = format!("which components of `{}` are xx, yy and xy is not known: {known}", field.name);
            let remedy = "call them XX, YY and XY, S11, S22 and S12, or SX, SY and SXY; or name a pressure by --column \
                pressure=NAME";
            return Err(self.source.refused(message, remedy));
        }
        if self.fields.is_empty() {
            let remedy = "write the pressure of the contact side, or the stress, at its nodes: what a file has of \
                cells is not read";
            return Err(self.source.refused("it has no field at its nodes", remedy));
        }
        let Some((field, at)) = places else {
            if let Some((field, _)) = self.field(Role::Pressure, asked)? {
                return Err(self.one_of(Role::Pressure, field));
            }
            let known: Vec<String> =
                self.fields.iter().map(|field| format!("{} ({})", field.name, field.components)).collect();
            let message = format!(
                "no nodal field is called contact_pressure, pressure or stress (of 6 or 9 components), but {}",
                known.join(", ")
            );
            let remedy = "name one by --column pressure=NAME, pressure=NAME:COMPONENT or stress=NAME";
            return Err(self.source.refused(message, remedy));
        };
        let factor = self.factor(Role::Stress, field, asked)?;
        let pressure = move |node: usize, normal: Option<[f64; 2]>| {
            let n = normal.unwrap_or_else(|| pair.normal(points[node]));
            let [x, y, xy] = at.map(|k| field.at(node, k));
            0.0 - factor * (n[0] * n[0] * x + n[1] * n[1] * y + 2.0 * n[0] * n[1] * xy)
        };
        let how = format!(
            "−n·σn of `{}` as pressure, {} components, of which xx, yy and xy are {}, {} and {}",
            field.name, field.components, at[0], at[1], at[2]
        );
        Ok((Box::new(pressure), how, true))
    }

    /// Remaining gaps of some nodes: a field, or from the displacements where the other side is rigid and its gap a
    /// formula.
    fn gaps(
        &self,
        nodes: &[usize],
        points: &[[f64; 2]],
        pair: &ContactPair,
        pressures: &[f64],
        asked: &Asked,
        read: &mut Vec<String>,
    ) -> Result<Option<Vec<f64>>, Error> {
        if let Some((field, component)) = self.part(Role::Gap, asked)? {
            let factor = self.factor(Role::Gap, field, asked)?;
            read.push(format!("`{}` as gap", field.name));
            // Where nothing presses, NaN says that there is no other side.
            let none = |node: usize, pressure: f64| field.at(node, component).is_nan() && pressure.abs() <= 0.0;
            return nodes
                .iter()
                .zip(pressures)
                .map(|(&node, &pressure)| match none(node, pressure) {
                    true => Ok(f64::INFINITY),
                    false => self.finite(field, node, component).map(|value| factor * value),
                })
                .collect::<Result<_, Error>>()
                .map(Some);
        }
        let Some(field) = self.moved(asked)? else { return Ok(None) };
        let initial = |node: usize| pair.gap(pair.path.coordinate(points[node]));
        if pair.second.is_some() || nodes.iter().any(|&node| initial(node).is_nan()) {
            return Ok(None);
        }
        let factor = self.factor(Role::Displacement, field, asked)?;
        read.push(format!("initial gap less `{}` along the normal as gap", field.name));
        let gap = |&node: &usize| -> Result<f64, Error> {
            let [u, v] = [self.finite(field, node, 0)?, self.finite(field, node, 1)?];
            let n = pair.normal(points[node]);
            Ok(initial(node) - factor * (n[0] * u + n[1] * v))
        };
        nodes.iter().map(gap).collect::<Result<_, Error>>().map(Some)
    }

    /// The field of displacements, where it is there and its unit is named.
    fn moved(&self, asked: &Asked) -> Result<Option<&Field>, Error> {
        let found = self.field(Role::Displacement, asked)?.map(|(field, _)| field);
        Ok(found.filter(|field| field.components >= 2 && asked.unit(Role::Displacement).is_some()))
    }

    /// Displacements of all nodes.
    fn displaced(&self, points: Vec<[f64; 2]>, cells: Vec<Cell>, asked: &Asked) -> Result<Option<Displaced>, Error> {
        let Some(field) = self.moved(asked)? else { return Ok(None) };
        let factor = self.factor(Role::Displacement, field, asked)?;
        let of_cells = || cells.iter().flat_map(|cell| &cell.nodes);
        if let Some((node, k)) =
            of_cells().flat_map(|&node| [(node, 0), (node, 1)]).find(|&(node, k)| !field.at(node, k).is_finite())
        {
            let message = format!("`{}` is {} at node {node}", field.name, field.at(node, k));
            let remedy = "hand in finite numbers at every node of a cell, or leave out --unit displacement";
            return Err(self.source.refused(message, remedy));
        }
        let moved = field.data.chunks_exact(field.components).map(|moved| [factor * moved[0], factor * moved[1]]);
        Ok(Some(Displaced { points, cells, displacement: moved.collect() }))
    }

    fn finite(&self, field: &Field, node: usize, component: usize) -> Result<f64, Error> {
        let value = field.at(node, component);
        let refused = || {
            let message = format!("`{}` is {value} at node {node}, on the contact side", field.name);
            self.source.refused(message, "hand in finite numbers there")
        };
        if value.is_finite() { Ok(value) } else { Err(refused()) }
    }
}
