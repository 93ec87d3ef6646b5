//! Order and layers of a fitted mesh, for so many digits; what no mesh is fitted to, and what to do.

use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Scene;

/// Cells and layers of a fitted mesh.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Fitted {
    /// Element order.
    pub order: Order,
    /// Layers of cells towards each end.
    pub layers: usize,
}

impl Fitted {
    /// Cells of an order in so many layers.
    pub const fn of(order: Order, layers: usize) -> Self {
        Self { order, layers }
    }

    /// For so many digits of peak and second-moment width: order `digits + 2`; a layer up to four digits, one more for
    /// each beyond.
    pub fn of_digits(digits: usize) -> Self {
        let order = Order::numbered(digits + 2).unwrap_or(if digits < 4 { Order::Quartic } else { Order::Octic });
        Self { order, layers: digits.saturating_sub(3).clamp(1, 3) }
    }

    /// Move of an end, over the half-width, that no longer matters.
    pub fn at_rest(self) -> f64 {
        4.0 * Self::misfit(self.order)
    }

    /// Relative error that ends at rest may leave on cells of an order, half a unit of its last digit.
    ///
    /// An end that is off by δ half-widths makes errors of `δ²/2` in the peak and `2δ²` in the half-width: at the end
    /// the potential energy is the least, and both are of second order.
    pub fn misfit(order: Order) -> f64 {
        0.5 * 10f64.powi(2 - i32::from(order.number()))
    }
}

/// What to do where a mesh cannot be fitted.
pub(super) const REMEDY: &str = "leave out --fitted";

/// Refuses meshes made elsewhere.
pub(super) fn refuse_given(scene: &Scene) -> Result<(), Error> {
    let given = scene.bodies.iter().position(|body| body.shape.has_given_mesh());
    given.map_or(Ok(()), |body| {
        let message = "--fitted cannot be used: the mesh of this body is given, and its lines stay where they are";
        Err(Error::at(scene.place_of_body(body), message, format!("{REMEDY}, or give the body another shape")))
    })
}

/// An error that another mesh than that of the scene brought about.
pub(super) fn on_fitted(error: Error) -> Error {
    let message = format!("{} (on a mesh that --fitted makes)", error.message);
    let remedy = format!("{}; or {REMEDY}", error.remedy);
    Error { message, remedy, ..error }
}
