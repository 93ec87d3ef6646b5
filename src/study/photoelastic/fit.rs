//! Five constants from the fringes at one end: half-width, a constant of each channel, and the place of the loaded edge.

use serde::Serialize;

use crate::oracle::digitised::fringes::{Channel, Fringe};
use crate::study::photoelastic::field::Field;

/// Places of the loaded edge that are tried, over the radius.
const EDGE: [f64; 2] = [-0.03, 0.05];
/// Part of an interval that golden sections leave.
const GOLDEN: f64 = 0.618_033_988_749_895;
const SECTIONS: usize = 28;

/// Constants of a field that are fitted to fringes.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Constants {
    /// Fringe order at the centre of the disc, by channel.
    pub orders: [f64; 3],
    /// How far the loaded edge lies above the end of the diameter in the picture, over the radius.
    pub edge: f64,
}

impl Constants {
    /// Constants with the least sum of squares, and that.
    pub fn fitted(field: &Field, fringes: &[Fringe]) -> (Self, f64) {
        let of = |edge: f64| {
            let constants = Self { orders: orders(field, fringes, edge), edge };
            (constants, constants.sum_of_squares(field, fringes))
        };
        let edge = golden(EDGE, |edge| of(edge).1);
        of(edge)
    }

    /// Computed order less the measured one.
    pub fn residual(&self, field: &Field, fringe: &Fringe) -> f64 {
        self.order_at(field, fringe.channel, [fringe.half_spacing, fringe.depth]) - fringe.order
    }

    /// Computed order of a channel at `[x, z]` of the picture.
    pub fn order_at(&self, field: &Field, channel: Channel, [x, z]: [f64; 2]) -> f64 {
        self.orders[channel as usize] * field.at([x, z + self.edge])
    }

    /// Sum of the squares of the residuals.
    pub fn sum_of_squares(&self, field: &Field, fringes: &[Fringe]) -> f64 {
        fringes.iter().map(|fringe| self.residual(field, fringe).powi(2)).sum()
    }
}

/// `N_c = Σ f N / Σ f²` over the fringes of each channel.
fn orders(field: &Field, fringes: &[Fringe], edge: f64) -> [f64; 3] {
    Channel::ALL.map(|channel| {
        let own = fringes.iter().filter(|fringe| fringe.channel == channel);
        let sums = own.fold([0.0; 2], |[above, below], fringe| {
            let f = field.at([fringe.half_spacing, fringe.depth + edge]);
            [above + f * fringe.order, below + f * f]
        });
        sums[0] / sums[1]
    })
}

/// Where a function of one minimum is least.
pub fn golden([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let [mut left, mut right] = inner(low, high);
    let [mut at_left, mut at_right] = [of(left), of(right)];
    for _ in 0..SECTIONS {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = inner(low, high)[0];
            at_left = of(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = inner(low, high)[1];
            at_right = of(right);
        }
    }
    0.5 * (low + high)
}
