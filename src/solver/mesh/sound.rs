//! Whether the mesh of a body hangs together: one piece, no two nodes at one place, no node inside a side of a cell.

use super::{Edge, Mesh};
use crate::error::Error;
use crate::scene::Scene;

/// Distance over the length of a side below which points are one.
const SAME: f64 = 1e-6;

/// What to do about a mesh that does not hang together.
const JOINED: &str = "let neighbouring cells share their nodes (Coherence in Gmsh, common curves of neighbouring \
    surfaces, whole common sides of blocks)";
/// The same about one that is cut into layers here, whose lines nearly coincide.
const LINES: &str = "take cells of a lower order, whose nodes lie farther apart";

/// Refuses bodies that do not hang together: given cell by cell or block by block, or cut into layers towards the ends
/// of contacts.
pub(super) fn refuse_loose(mesh: &Mesh, scene: &Scene) -> Result<(), Error> {
    for (index, body) in scene.bodies.iter().enumerate() {
        let is_layered = scene.contacts_of(index).any(|pair| !pair.ends.places.is_empty());
        if !body.shape.has_given_mesh() && !is_layered {
            continue;
        }
        let refused = |what: &str, node: usize| {
            let [x, y] = mesh.points[node];
            let message = format!("the mesh does not hang together: {what} ({x:.6}, {y:.6}) mm");
            let remedy = if body.shape.has_given_mesh() { JOINED } else { LINES };
            Err(Error::at(scene.place_of_body(index), message, remedy))
        };
        let outline = mesh.outline(index);
        let at_end = |along: f64| along.abs() <= SAME || (along - 1.0).abs() <= SAME;
        if let Some(node) = on_side(mesh, &outline, &by_x(mesh, &outline, usize::MAX), at_end) {
            return refused("two nodes stand at", node);
        }
        // A corner inside another side.
        let inside = |along: f64| along > SAME && along < 1.0 - SAME;
        if let Some(node) = on_side(mesh, &outline, &by_x(mesh, &outline, 2), inside) {
            return refused("a node hangs inside a side of another cell at", node);
        }
        if let Some(node) = apart(mesh, index) {
            return refused("it is in several pieces, one of them at", node);
        }
    }
    Ok(())
}

/// Nodes of the outline by ascending x: of every edge so many.
fn by_x(mesh: &Mesh, outline: &[Edge], taken: usize) -> Vec<usize> {
    let mut nodes: Vec<usize> = outline.iter().flat_map(|edge| edge.iter().take(taken).copied()).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes.sort_by(|&a, &b| mesh.points[a][0].total_cmp(&mesh.points[b][0]));
    nodes
}

/// The first of some nodes by ascending x that lies on a side without being one of its own, where its place along that,
/// over the side's length, passes a test.
fn on_side(mesh: &Mesh, outline: &[Edge], nodes: &[usize], is_it: impl Fn(f64) -> bool) -> Option<usize> {
    for edge in outline {
        let [a, b] = [mesh.points[edge[0]], mesh.points[edge[1]]];
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let square = dx * dx + dy * dy;
        let room = SAME * square.sqrt();
        let (low, high) = (a[0].min(b[0]) - room, a[0].max(b[0]) + room);
        let from = nodes.partition_point(|&node| mesh.points[node][0] < low);
        let beside = nodes[from..].iter().take_while(|&&node| mesh.points[node][0] <= high);
        for &node in beside.filter(|node| !edge.contains(node)) {
            let (x, y) = (mesh.points[node][0] - a[0], mesh.points[node][1] - a[1]);
            let (along, across) = ((x * dx + y * dy) / square, (x * dy - y * dx).abs() / square);
            if across <= SAME && is_it(along) {
                return Some(node);
            }
        }
    }
    None
}

/// A node that no chain of cells joins to the first cell of the body.
fn apart(mesh: &Mesh, body: usize) -> Option<usize> {
    let part = &mesh.bodies[body];
    let mut leader: Vec<usize> = part.nodes.clone().map(|node| node - part.nodes.start).collect();
    fn find(leader: &mut [usize], mut node: usize) -> usize {
        while leader[node] != node {
            leader[node] = leader[leader[node]];
            node = leader[node];
        }
        node
    }
    for cell in part.cells.clone() {
        let nodes = mesh.cell(cell);
        let first = find(&mut leader, nodes[0] - part.nodes.start);
        for node in &nodes[1..] {
            let other = find(&mut leader, node - part.nodes.start);
            leader[other] = first;
        }
    }
    let first = find(&mut leader, 0);
    (0..leader.len()).find(|&node| find(&mut leader, node) != first).map(|node| node + part.nodes.start)
}
