//! Element order, and what it asks of the grading.

use crate::named::named_enum;
use crate::scene::Grading;

named_enum! {
    /// Element order.
    pub enum Order {
        /// 4-node quadrilaterals.
        Linear = "1",
        /// 8-node (serendipity) quadrilaterals.
        Quadratic = "2",
    }
}

impl Order {
    /// Nodes per cell: 4 or 8.
    pub fn nodes_per_cell(self) -> usize {
        match self {
            Self::Linear => 4,
            Self::Quadratic => 8,
        }
    }

    /// The grading of a mesh with n times as many elements: growth `q^(n^−e)`, and the coarsest element over n^e.
    ///
    /// Refinement goes to the solution only if elements get smaller everywhere. 4-node cells err with the square of the
    /// growth's logarithm as with that of the element, e = 1; 8-node ones with its fourth power, e = ½. Fewer elements leave
    /// the grading as it is.
    pub fn refined(self, grading: &Grading, times: f64) -> Grading {
        self.regraded(grading, 1.0 / times.max(1.0))
    }

    /// The grading of a mesh of the same family whose elements on the contact are larger by a ratio: all others grow with them.
    pub fn coarsened(self, grading: &Grading, ratio: f64) -> Grading {
        Grading { unit: ratio * grading.unit, ..self.regraded(grading, ratio) }
    }

    /// Growth `q^(r^e)` and coarsest element times r^e.
    fn regraded(self, grading: &Grading, ratio: f64) -> Grading {
        let exponent = match self {
            Self::Linear => 1.0,
            Self::Quadratic => 0.5,
        };
        let faster = ratio.powf(exponent);
        let [along, depth] = [grading.along, grading.depth].map(|growth| growth.powf(faster));
        Grading { along, depth, coarsest: grading.coarsest * faster, ..*grading }
    }

    /// 1 or 2, as users write it.
    pub fn number(self) -> u8 {
        match self {
            Self::Linear => 1,
            Self::Quadratic => 2,
        }
    }
}
