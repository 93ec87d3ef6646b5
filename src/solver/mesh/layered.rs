//! Layers of cells towards the ends of a contact, leaps of the curvature of its gap, the cusp of its pressure, and
//! forces at points: every cell with a corner there is cut into one like it, smaller, and two around that, and so
//! again.
//!
//! Neighbours that share the corner cut their common side at the same place, and sides that do not meet the corner stay
//! as they are: the mesh hangs together, whatever it was.

use super::block::{Block, Point, Side};
use super::outline::{eye, pressed};
use super::{Order, lobatto};
use crate::scene::contact_pair::LAYER;
use crate::scene::{Body, Scene};

/// Difference of contact coordinates, over the stretch, that rounding explains.
const SAME: f64 = 1e-9;

/// Layers towards the re-entrant corner of eye and shank, beyond those towards the ends.
const AT_CORNER: usize = 1;

/// Layers towards the cusp of the pressure under a gap sⁿ, times `n − 1`, without and for each of those towards the
/// ends: every layer leaves `LAYERⁿ⁻¹` of it, and `LAYER²` of an end. And the shortest distance of two nodes over the
/// cell that is cut: round-off takes what smaller rings around an axis carry, a 10⁻¹³th of the load.
const AT_CUSP: [f64; 2] = [4.0, 2.0];
const NEAREST: f64 = 3.5e-7;

/// The blocks of a body with layers towards the ends of its contacts and the leaps within, towards points at which it
/// is pressed, and towards corners between a side that is held and one that is free.
pub(super) fn towards_ends(mut blocks: Vec<Block>, scene: &Scene, body: usize, order: Order) -> Vec<Block> {
    for pair in scene.contacts_of(body) {
        let at_ends = pair.ends.places.iter().copied().chain(pair.leaps()).map(|s| (s, pair.ends.layers));
        let at_cusp = pair.power_at_cusp().map(|power| (0.0, layers_at_cusp(power, pair.ends.layers, order)));
        for (s, layers) in at_ends.chain(at_cusp) {
            let is_here = |point: &Point| (pair.path.coordinate(*point) - s).abs() <= SAME * pair.stretch;
            let own = blocks.iter().flat_map(Block::sides).filter(|side| side.is_on(pair.side(body)));
            let place = own.flat_map(|side| side.points.iter().step_by(order.intervals())).copied().find(is_here);
            blocks = layered(blocks, scene, place, layers, order);
        }
    }
    let layers = scene.contacts_of(body).filter(|pair| !pair.ends.places.is_empty()).map(|pair| pair.ends.layers).max();
    let Some(layers) = layers.filter(|layers| *layers > 0) else { return blocks };
    blocks = layered(blocks, scene, eye::corner(&scene.bodies[body].shape), layers + AT_CORNER, order);
    // The axis of revolution is a side, but no free one.
    let is_off_axis = |at: &Point| scene.plane.radial().is_none_or(|radial| at[radial] > 0.0);
    let near = SAME * scene.grading.unit;
    let corners = held_corners(&blocks, &scene.bodies[body], near).into_iter().filter(is_off_axis);
    for at in corners.chain(pressed(&scene.bodies[body])) {
        let cut = layered(blocks.clone(), scene, Some(at), layers, order);
        // The long cells of a thin ring bend too much to be cut like this.
        if !cut.iter().any(|block| folds(block, order)) {
            blocks = cut;
        }
    }
    blocks
}

/// Places where a side that is held in both directions meets one that is free, of the same block or of two.
fn held_corners(blocks: &[Block], body: &Body, near: f64) -> Vec<Point> {
    let components = |side: &Side| {
        let held: Vec<[bool; 2]> = side.names.iter().map(|name| body.held(name)).collect();
        [0, 1].into_iter().filter(|&k| held.iter().any(|held| held[k])).count()
    };
    let outer = blocks.iter().flat_map(Block::sides).filter(|side| !side.names.is_empty() && !side.inside);
    let ends: Vec<(Point, usize)> =
        outer.flat_map(|side| [0, side.points.len() - 1].map(|end| (side.points[end], components(side)))).collect();
    let is_here = |at: Point| move |other: &Point| (other[0] - at[0]).hypot(other[1] - at[1]) <= near;
    let mut corners: Vec<Point> = Vec::new();
    for (at, _) in ends.iter().filter(|(_, held)| *held == 2) {
        let is_free = ends.iter().any(|(other, held)| *held == 0 && is_here(*at)(other));
        if is_free && !corners.iter().any(is_here(*at)) {
            corners.push(*at);
        }
    }
    corners
}

/// Whether the lattice of a block is turned over somewhere.
fn folds(block: &Block, order: Order) -> bool {
    block.lattice(order).windows(2).any(|rows| {
        rows[0].windows(2).zip(rows[1].windows(2)).any(|(low, high)| {
            let [along, across] =
                [[low[0], high[1]], [low[1], high[0]]].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
            along[0] * across[1] <= along[1] * across[0]
        })
    })
}

/// The blocks with so many layers towards a place, if there is one.
fn layered(blocks: Vec<Block>, scene: &Scene, place: Option<Point>, layers: usize, order: Order) -> Vec<Block> {
    let Some(at) = place else { return blocks };
    let place = Singular { at, near: SAME * scene.grading.unit, layers };
    blocks.into_iter().flat_map(|block| place.layered(block, order)).collect()
}

/// Layers towards the cusp that a power below 2 leaves in the pressure, where so many lie towards the ends.
fn layers_at_cusp(power: f64, at_ends: usize, order: Order) -> usize {
    let [alone, each] = AT_CUSP;
    let most = (NEAREST / order.fractions()[1]).ln() / LAYER.ln();
    ((alone + each * at_ends as f64) / (power - 1.0)).ceil().min(most.floor()) as usize
}

/// A place where the stresses are singular: all cells with a corner there are cut, of whatever side, or the mesh would
/// tear.
struct Singular {
    at: Point,
    /// Distance below which a point is the place.
    near: f64,
    /// Times the cells there are cut.
    layers: usize,
}

impl Singular {
    fn is_here(&self, [x, y]: Point) -> bool {
        (x - self.at[0]).hypot(y - self.at[1]) <= self.near
    }

    /// A block, cut into its cells where one of them has its corner at the place.
    fn layered(&self, block: Block, order: Order) -> Vec<Block> {
        let touches = |side: &&Side| side.points.iter().step_by(order.intervals()).any(|corner| self.is_here(*corner));
        if !block.sides().iter().any(touches) {
            return vec![block];
        }
        let cells = cells(&block, order).into_iter();
        cells.flat_map(|cell| self.cut(cell, order, self.layers)).collect()
    }

    /// A cell, cut so many times where one of its corners is the place.
    fn cut(&self, cell: Block, order: Order, layers: usize) -> Vec<Block> {
        match self.corner(&cell) {
            Some(corner) if layers > 0 => {
                let [small, around @ ..] = Map::of(&cell, order).around(corner);
                self.cut(small, order, layers - 1).into_iter().chain(around).collect()
            }
            _ => vec![cell],
        }
    }

    /// The corner of a cell at the place, counter-clockwise from the lower left one.
    fn corner(&self, cell: &Block) -> Option<usize> {
        let corners = cell.corners();
        corners.iter().position(|corner| self.is_here(*corner))
    }
}

/// The cells of a block, each a block of its own.
fn cells(block: &Block, order: Order) -> Vec<Block> {
    let (lattice, m) = (block.lattice(order), order.intervals());
    let [columns, rows] = block.size();
    let cell = |i: usize, j: usize| {
        let of = |outer: &Side, is_outer: bool, points: Vec<Point>| match is_outer {
            true => Side { points, ..outer.clone() },
            false => Side::inner(points),
        };
        let row = |j: usize| lattice[j][i..=i + m].to_vec();
        let column = |i: usize| (j..=j + m).map(|j| lattice[j][i]).collect::<Vec<_>>();
        Block {
            bottom: of(&block.bottom, j == 0, row(j)),
            right: of(&block.right, i + m + 1 == columns, column(i + m)),
            top: of(&block.top, j + m + 1 == rows, row(j + m)),
            left: of(&block.left, i == 0, column(i)),
        }
    };
    let all = (0..rows - 1).step_by(m).flat_map(|j| (0..columns - 1).step_by(m).map(move |i| (i, j)));
    all.map(|(i, j)| cell(i, j)).collect()
}

/// The map of a cell from the unit square: the polynomials through its lattice points.
struct Map<'a> {
    cell: &'a Block,
    lattice: Vec<Vec<Point>>,
    order: Order,
}

impl<'a> Map<'a> {
    fn of(cell: &'a Block, order: Order) -> Self {
        Self { cell, lattice: cell.lattice(order), order }
    }

    /// The small cell at a corner (counter-clockwise from the lower left one), and the two around it.
    fn around(&self, corner: usize) -> [Block; 3] {
        let towards = |[x, y]: [f64; 2]| [[x, y], [1.0 - x, y], [1.0 - x, 1.0 - y], [x, 1.0 - y]][corner];
        let quadrilateral = |corners: [[f64; 2]; 4]| {
            let [a, b, c, d] = corners.map(towards);
            // Seen in one mirror a cell must be listed the other way round.
            if corner.is_multiple_of(2) { self.block([a, b, c, d]) } else { self.block([b, a, d, c]) }
        };
        let (f, inner) = (LAYER, [LAYER, LAYER]);
        [
            quadrilateral([[0.0, 0.0], [f, 0.0], inner, [0.0, f]]),
            quadrilateral([[f, 0.0], [1.0, 0.0], [1.0, 1.0], inner]),
            quadrilateral([[0.0, f], inner, [1.0, 1.0], [0.0, 1.0]]),
        ]
    }

    /// The image of a quadrilateral of the unit square.
    fn block(&self, [a, b, c, d]: [[f64; 2]; 4]) -> Block {
        Block { bottom: self.side(a, b), right: self.side(b, c), top: self.side(d, c), left: self.side(a, d) }
    }

    /// The image of a line, on the side of the cell that it lies on.
    fn side(&self, from: [f64; 2], to: [f64; 2]) -> Side {
        let at = |t: &f64| self.point([0, 1].map(|k| from[k] + (to[k] - from[k]) * t));
        let points = self.order.fractions().iter().map(at).collect();
        let on = |k: usize, value: f64| [from[k], to[k]].iter().all(|x| (x - value).abs() <= f64::EPSILON);
        let outer = match () {
            _ if on(1, 0.0) => &self.cell.bottom,
            _ if on(0, 1.0) => &self.cell.right,
            _ if on(1, 1.0) => &self.cell.top,
            _ if on(0, 0.0) => &self.cell.left,
            _ => return Side::inner(points),
        };
        Side { points, ..outer.clone() }
    }

    /// The image of a point.
    fn point(&self, at: [f64; 2]) -> Point {
        let nodes = lobatto::points(self.order.intervals() + 1);
        let [along, across] = at.map(|x| lobatto::lagrange(nodes, 2.0 * x - 1.0));
        let mut point = [0.0; 2];
        for (row, (m, _)) in self.lattice.iter().zip(&across) {
            for (place, (n, _)) in row.iter().zip(&along) {
                (0..2).for_each(|k| point[k] += n * m * place[k]);
            }
        }
        point
    }
}
