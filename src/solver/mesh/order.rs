//! Element order: the nodes of a cell, and what it asks of the grading; how fine a mesh is.

use crate::mesh::lobatto;
use crate::named::named_enum;
use crate::scene::Grading;

named_enum! {
    /// Element order.
    pub enum Order {
        /// 4-node quadrilaterals.
        Linear = "1",
        /// 9-node quadrilaterals, of meshes made elsewhere.
        Biquadratic = "2-lagrange",
        /// 8-node (serendipity) quadrilaterals.
        Quadratic = "2",
        /// 25-node quadrilaterals.
        Quartic = "4",
        /// 36-node quadrilaterals.
        Quintic = "5",
        /// 49-node quadrilaterals.
        Sextic = "6",
        /// 64-node quadrilaterals.
        Septic = "7",
        /// 81-node quadrilaterals.
        Octic = "8",
    }
}

impl Order {
    /// The order as users write it: the degree of the polynomials along an edge.
    pub fn number(self) -> u8 {
        match self {
            Self::Linear => 1,
            Self::Biquadratic | Self::Quadratic => 2,
            Self::Quartic => 4,
            Self::Quintic => 5,
            Self::Sextic => 6,
            Self::Septic => 7,
            Self::Octic => 8,
        }
    }

    /// The order of a number; none where no cells have it. Of order 2 are 8-node cells unless a mesh has others.
    pub fn numbered(number: usize) -> Option<Self> {
        Self::ALL.into_iter().rev().find(|order| usize::from(order.number()) == number)
    }

    /// The order of cells of so many nodes; none where no cells have them.
    pub fn of_nodes(nodes: usize) -> Option<Self> {
        Self::ALL.into_iter().find(|order| order.nodes_per_cell() == nodes)
    }

    /// Whether cells are tensor products on Gauss–Lobatto–Legendre points: 9-node ones, and from order 4 on.
    pub fn is_tensor(self) -> bool {
        self == Self::Biquadratic || self.is_high()
    }

    /// Whether it is 4 or more.
    pub fn is_high(self) -> bool {
        self > Self::Quadratic
    }

    /// Nodes per cell: 4, 8, or `(p + 1)²`.
    pub fn nodes_per_cell(self) -> usize {
        match self {
            Self::Linear => 4,
            Self::Quadratic => 8,
            tensor => (usize::from(tensor.number()) + 1).pow(2),
        }
    }

    /// Intervals of the lattice on each side of a cell: two, mid-side nodes or not, or p.
    pub fn intervals(self) -> usize {
        usize::from(self.number()).max(2)
    }

    /// Lattice positions on a side of a cell, from 0 to 1.
    pub fn fractions(self) -> Vec<f64> {
        lobatto::points(self.intervals() + 1).iter().map(|x| 0.5 * (1.0 + x)).collect()
    }

    /// Where on the lattice of a cell its nodes lie, as VTK numbers them.
    pub fn places(self) -> Vec<[usize; 2]> {
        Self::lattice(self.intervals()).take(self.nodes_per_cell()).collect()
    }

    /// The nodes of a lattice of so many intervals a side as VTK numbers them: corners counter-clockwise, then the
    /// inner nodes of the bottom, right, top and left side, each along its axis, then the inside row by row.
    pub fn lattice(m: usize) -> impl Iterator<Item = [usize; 2]> {
        let inner = move || 1..m;
        let corners = [[0, 0], [m, 0], [m, m], [0, m]];
        let bottom_and_right = inner().map(|i| [i, 0]).chain(inner().map(move |j| [m, j]));
        let sides = bottom_and_right.chain(inner().map(move |i| [i, m])).chain(inner().map(|j| [0, j]));
        let inside = inner().flat_map(move |j| inner().map(move |i| [i, j]));
        corners.into_iter().chain(sides).chain(inside)
    }

    /// Nodes of the four sides of a cell, by their number in it, counter-clockwise: first, last, then those between.
    pub fn sides(self) -> [Vec<usize>; 4] {
        let inner = if self == Self::Linear { 0 } else { self.intervals() - 1 };
        std::array::from_fn(|k| {
            let between = 4 + k * inner..4 + (k + 1) * inner;
            let ends = [k, (k + 1) % 4].into_iter();
            // Top and left are numbered along their axes, which is backwards.
            if k < 2 { ends.chain(between).collect() } else { ends.chain(between.rev()).collect() }
        })
    }

    /// The grading of a mesh with n times as many elements: growth `q^(n^−e)`, and the coarsest element over n^e,
    /// `e = 1/p`.
    ///
    /// Refinement goes to the solution only if elements get smaller everywhere. 4-node cells err with the square of the
    /// growth's logarithm as with that of the element, e = 1; 8-node ones with its fourth power, e = ½. Fewer elements
    /// leave the grading as it is.
    pub fn refined(self, grading: &Grading, times: f64) -> Grading {
        self.regraded(grading, 1.0 / times.max(1.0))
    }

    /// The grading of a mesh of the same family whose elements on the contact are larger by a ratio: all others grow
    /// with them.
    pub fn coarsened(self, grading: &Grading, ratio: f64) -> Grading {
        Grading { unit: ratio * grading.unit, ..self.regraded(grading, ratio) }
    }

    /// Growth `q^(r^e)` and coarsest element times r^e.
    fn regraded(self, grading: &Grading, ratio: f64) -> Grading {
        let faster = ratio.powf(1.0 / f64::from(self.number()));
        let [along, depth] = [grading.along, grading.depth].map(|growth| growth.powf(faster));
        Grading { along, depth, coarsest: grading.coarsest * faster, ..*grading }
    }
}

/// How fine a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// Elements per half-width, or per 10 mm of arc on pins.
    pub elements: usize,
    /// Times every element of that mesh is halved both ways.
    pub refinement: u32,
    /// Element order.
    pub order: Order,
}

impl Resolution {
    /// Most elements, and most times that they are halved.
    pub const MOST: (usize, u32) = (4096, 6);

    /// Whether a mesh may be so fine.
    pub fn is_allowed(self) -> bool {
        let (elements, refinement) = Self::MOST;
        (1..=elements).contains(&self.elements) && self.refinement <= refinement
    }
}
