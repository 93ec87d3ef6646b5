//! What a mesh file holds, whatever its format: nodes, elements, and the groups by which they are named.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::error::Error;

/// What Gmsh needs to be told for meshes of quadrilaterals.
pub const OPTIONS: &str = "mesh with Mesh.RecombineAll = 1, or transfinite surfaces and Recombine; 8-node cells come \
    from Mesh.ElementOrder = 2 and Mesh.SecondOrderIncomplete = 1";
/// What makes quadrilaterals of triangles.
pub const SUBDIVISION: &str = "mesh with quadrilaterals: Gmsh cuts all cells into them with Mesh.SubdivisionAlgorithm \
    = 1 and Mesh.RecombineAll = 1, where it has the geometry; else a script of the lines `Merge \"old.msh\";`, \
    `RecombineMesh;`, `Mesh.SubdivisionAlgorithm = 1;`, `RefineMesh;` and `Save \"new.msh\";` cuts the cells of a \
    mesh";
/// What to do with a mesh of solids.
pub const PLANE: &str = "scenes are plane: mesh the surfaces only (gmsh -2), in the plane z = 0, of quadrilaterals";

/// Elements that are read: Gmsh's type, nodes, corners. Triangles are known to be refused by their name; the others are
/// of three dimensions or higher order.
pub const KINDS: [(i64, usize, usize); 10] = [
    (15, 1, 1),
    (1, 2, 2),
    (8, 3, 2),
    (26, 4, 2),
    (2, 3, 3),
    (9, 6, 3),
    (21, 10, 3),
    (3, 4, 4),
    (16, 8, 4),
    (10, 9, 4),
];

/// What the numbers of the nodes and elements of the first instance of a part begin behind, those of the second behind
/// its double.
pub const INSTANCE: u64 = 1 << 40;

/// The number of a node or element in its part.
pub fn number(tag: u64) -> u64 {
    tag % INSTANCE
}

/// An element.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Its number in the file.
    pub tag: u64,
    /// Numbers of its nodes: corners, then mid-sides, then the middle.
    pub nodes: Vec<u64>,
    /// How many of them are corners: two of a line.
    pub corners: usize,
}

/// Elements of each group by its name, as ranges of all.
pub type Groups = BTreeMap<String, Vec<Range<usize>>>;

/// Nodes and elements of a file.
#[derive(Debug, Default)]
pub struct Elements {
    /// Position of each node by its number, in the file's unit.
    pub nodes: BTreeMap<u64, [f64; 2]>,
    /// Nodes off the plane and their z: points of reference, and no nodes of cells.
    pub off: BTreeMap<u64, f64>,
    /// Most digits that a coordinate has, and the power of ten of the largest one.
    pub written: (usize, i32),
    /// All elements.
    pub pieces: Vec<Piece>,
    /// Groups of cells.
    pub surfaces: Groups,
    /// Groups of lines.
    pub curves: Groups,
    /// Groups of nodes: their curves are the sides all of whose nodes belong to them.
    pub sets: BTreeMap<String, Vec<u64>>,
    /// What groups of cells and of sides are called in files of this format.
    pub called: [&'static str; 2],
    /// How such groups are made.
    pub made: &'static str,
    /// What is said of elements of bodies of revolution in a scene of the plane; none where the file has none.
    pub of_revolution: Option<Error>,
}

/// Digits that coordinates are taken to have at least: shorter ones may be exact.
const DIGITS: usize = 7;

impl Elements {
    /// Counts the digits of the coordinates of a node as they are in the file.
    pub fn count_digits(&mut self, [x, y, _]: [f64; 3]) {
        for x in [x, y].into_iter().filter(|x| x.abs() > 0.0) {
            let written = format!("{x:e}");
            let Some((digits, power)) = written.split_once('e') else { continue };
            let count = digits.bytes().filter(u8::is_ascii_digit).count();
            self.written.0 = self.written.0.max(count);
            self.written.1 = self.written.1.max(power.parse().unwrap_or_default());
        }
    }

    /// Half a unit of the last digit of the largest coordinates, in the file's unit.
    pub fn rounding(&self) -> f64 {
        let (digits, power) = self.written;
        0.5 * 10_f64.powi(power + 1 - digits.max(DIGITS) as i32)
    }

    /// Adds a node; it must lie in the plane z = 0.
    pub fn add_node(
        &mut self,
        tag: u64,
        [x, y, z]: [f64; 3],
        refused: impl Fn(String, &str) -> Error,
    ) -> Result<(), Error> {
        for (name, value) in [("x", x), ("y", y), ("z", z)] {
            if value.is_nan() || value.abs() > 1e13 {
                return Err(refused(format!("{name} is {value}"), "repair the mesh"));
            }
        }
        if is_off([x, y, z]) {
            return Err(refused(format!("node {} lies at z = {z}", number(tag)), PLANE));
        }
        match self.nodes.insert(tag, [x, y]) {
            Some(_) => Err(refused(format!("node {} stands twice", number(tag)), "save the mesh again")),
            None => Ok(()),
        }
    }

    /// Adds an element, whose nodes must be there, and those of a cell in the plane z = 0; its index.
    pub fn add_piece(&mut self, piece: Piece, refused: impl Fn(String, &str) -> Error) -> Result<usize, Error> {
        if let Some(missing) = piece.nodes.iter().find(|node| !self.nodes.contains_key(node)) {
            let message = format!("element {} names node {}, which does not exist", piece.tag, number(*missing));
            return Err(refused(message, "save the mesh again, with its nodes first"));
        }
        let off = piece.nodes.iter().find_map(|node| Some((node, self.off.get(node)?)));
        if let Some((node, z)) = off.filter(|_| piece.corners > 2) {
            let message = format!("element {} has node {}, which lies at z = {z}", piece.tag, number(*node));
            return Err(refused(message, PLANE));
        }
        self.pieces.push(piece);
        Ok(self.pieces.len() - 1)
    }

    /// The elements of a group.
    pub fn of<'a>(&'a self, group: &'a [Range<usize>]) -> impl Iterator<Item = &'a Piece> {
        group.iter().flat_map(|range| &self.pieces[range.clone()])
    }
}

/// Whether a node lies off the plane z = 0.
pub fn is_off([x, y, z]: [f64; 3]) -> bool {
    z.abs() > 1e-9 * (1.0 + x.abs().max(y.abs()))
}

/// Adds an element to a group, to its last range where it follows it.
pub fn add_to(group: &mut Vec<Range<usize>>, index: usize) {
    match group.last_mut() {
        Some(last) if last.end == index => last.end += 1,
        _ => group.push(index..index + 1),
    }
}
