//! A mesh as Gmsh has it: format 4.1, ASCII; a physical surface a body, a physical curve a side of a body, called
//! `BODY SIDE`.

use std::fmt::Write;

use crate::mesh::{BodyMesh, Edge, Mesh, Order};
use crate::scene::Scene;

/// The text of the file.
pub fn text(scene: &Scene, mesh: &Mesh) -> String {
    let sides: Vec<Side> = sides(scene, mesh);
    let mut text = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    names(&mut text, scene, &sides);
    entities(&mut text, scene, mesh, &sides);
    nodes(&mut text, mesh);
    elements(&mut text, mesh, &sides);
    text
}

/// A side of a body: its name, the body, and its edges.
type Side<'a> = (String, usize, &'a [Edge]);

/// All sides of all bodies, and the lines inside them.
fn sides<'a>(scene: &Scene, mesh: &'a Mesh) -> Vec<Side<'a>> {
    let of = |(body, part): (usize, &'a BodyMesh)| {
        let all = part.boundaries.iter().chain(&part.lines).filter(|(_, edges)| !edges.is_empty());
        let named = |name: &str| format!("{} {name}", scene.bodies[body].name);
        all.map(|(name, edges)| (named(name), body, &edges[..])).collect::<Vec<_>>()
    };
    mesh.bodies.iter().enumerate().flat_map(of).collect()
}

/// Physical numbers of sides and bodies by their names: curves are numbered from 1 on, surfaces behind them.
pub fn numbers(scene: &Scene, mesh: &Mesh) -> Vec<(String, usize)> {
    let names = sides(scene, mesh).into_iter().map(|(name, ..)| name);
    names.chain(scene.bodies.iter().map(|body| body.name.clone())).zip(1..).collect()
}

/// The names, as [`numbers`] tells.
fn names(text: &mut String, scene: &Scene, sides: &[Side]) {
    let _ = writeln!(text, "$PhysicalNames\n{}", sides.len() + scene.bodies.len());
    for (k, (name, ..)) in sides.iter().enumerate() {
        let _ = writeln!(text, "1 {} \"{name}\"", k + 1);
    }
    for (k, body) in scene.bodies.iter().enumerate() {
        let _ = writeln!(text, "2 {} \"{}\"", sides.len() + k + 1, body.name);
    }
    text.push_str("$EndPhysicalNames\n");
}

fn entities(text: &mut String, scene: &Scene, mesh: &Mesh, sides: &[Side]) {
    let _ = writeln!(text, "$Entities\n0 {} {} 0", sides.len(), scene.bodies.len());
    for (k, (.., edges)) in sides.iter().enumerate() {
        let within = around(edges.iter().flatten().map(|&node| mesh.points[node]));
        let _ = writeln!(text, "{} {within} 1 {} 0", k + 1, k + 1);
    }
    for (k, part) in mesh.bodies.iter().enumerate() {
        let within = around(mesh.points[part.nodes.clone()].iter().copied());
        let own: Vec<String> = (0..sides.len()).filter(|&s| sides[s].1 == k).map(|s| (s + 1).to_string()).collect();
        let _ = writeln!(text, "{} {within} 1 {} {} {}", k + 1, sides.len() + k + 1, own.len(), own.join(" "));
    }
    text.push_str("$EndEntities\n");
}

/// The box around some points.
fn around(points: impl Iterator<Item = [f64; 2]>) -> String {
    let start = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    let grown = |(low, high): ([f64; 2], [f64; 2]), point: [f64; 2]| {
        ([0, 1].map(|k| low[k].min(point[k])), [0, 1].map(|k| high[k].max(point[k])))
    };
    let ([x, y], [to_x, to_y]) = points.fold(start, grown);
    format!("{x:e} {y:e} 0 {to_x:e} {to_y:e} 0")
}

fn nodes(text: &mut String, mesh: &Mesh) {
    let count = mesh.points.len();
    let _ = writeln!(text, "$Nodes\n{} {count} 1 {count}", mesh.bodies.len());
    for (k, part) in mesh.bodies.iter().enumerate() {
        let _ = writeln!(text, "2 {} 0 {}", k + 1, part.nodes.len());
        text.extend(part.nodes.clone().map(|node| format!("{}\n", node + 1)));
        text.extend(mesh.points[part.nodes.clone()].iter().map(|[x, y]| format!("{x:e} {y:e} 0\n")));
    }
    text.push_str("$EndNodes\n");
}

fn elements(text: &mut String, mesh: &Mesh, sides: &[Side]) {
    let (line, cell) = match mesh.order {
        Order::Linear => (1, 3),
        Order::Biquadratic => (8, 10),
        _ => (8, 16),
    };
    let count = sides.iter().map(|(.., edges)| edges.len()).sum::<usize>() + mesh.cells();
    let _ = writeln!(text, "$Elements\n{} {count} 1 {count}", sides.len() + mesh.bodies.len());
    let mut tag = 0;
    let mut write = |text: &mut String, nodes: &[usize]| {
        tag += 1;
        let numbers: String = nodes.iter().map(|node| format!(" {}", node + 1)).collect();
        let _ = writeln!(text, "{tag}{numbers}");
    };
    for (k, (.., edges)) in sides.iter().enumerate() {
        let _ = writeln!(text, "1 {} {line} {}", k + 1, edges.len());
        edges.iter().for_each(|edge| write(text, edge));
    }
    for (k, part) in mesh.bodies.iter().enumerate() {
        let _ = writeln!(text, "2 {} {cell} {}", k + 1, part.cells.len());
        part.cells.clone().for_each(|index| write(text, mesh.cell(index)));
    }
    text.push_str("$EndElements\n");
}
