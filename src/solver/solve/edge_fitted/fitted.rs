//! Order and layers of a fitted mesh, for so many digits.

use crate::mesh::Order;

/// Cells and layers of a fitted mesh.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Fitted {
    /// Element order.
    pub order: Order,
    /// Layers of cells towards each end.
    pub layers: usize,
}

impl Fitted {
    /// For so many digits of peak and second-moment width: order `digits + 2`; a layer up to four digits, one more for each beyond.
    pub fn of_digits(digits: usize) -> Self {
        let order = Order::numbered(digits + 2).unwrap_or(if digits < 4 { Order::Quartic } else { Order::Octic });
        Self { order, layers: digits.saturating_sub(3).clamp(1, 3) }
    }

    /// Move of an end, over the half-width, that no longer matters.
    pub fn at_rest(self) -> f64 {
        (0.5 * Self::misfit(self.order)).sqrt()
    }

    /// Relative error that ends at rest may leave on cells of an order, half a unit of its last digit.
    ///
    /// An end that is off by δ half-widths makes errors of `δ²/2` in the peak and `2δ²` in the half-width: at the end the
    /// potential energy is the least, and both are of second order.
    pub fn misfit(order: Order) -> f64 {
        0.5 * 10f64.powi(2 - i32::from(order.number()))
    }
}
