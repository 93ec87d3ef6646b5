//! How far differences between meshes are counted on to tell the error of a number.
//!
//! `u = F max |f₀ − fᵢ| / (rᵢ^q − 1) + C (h/a)^s + D`: the finest value f₀, those of meshes of the sizes `rᵢ h`, the part C that
//! the end of a contact may hide, as it lies somewhere within an element of each mesh and all of them may agree by accident, and
//! of a peak how far two readings of it are apart on the mesh itself, and what a top narrower than its elements hides (`family`).
//!
//! The numbers were chosen on random scenes of closed form for the narrowest bars that hold in each of their families, and that no
//! error is far beyond; the study *coverage* tests them on others. q is no claim of an order: pressures at the points of line and
//! layer elements oscillate, and what cells of 8 nodes gain on the coarser meshes is lost where the end of the contact decides.
//! Numbers below the surface have a C too, for coarse meshes that agree by accident.

use crate::measure::Quantity;
use crate::mesh::Order;
use crate::solve::Element;

/// The constants of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counted {
    /// Exponent q of the element size.
    pub exponent: f64,
    /// Factor F on the worst difference.
    pub factor: f64,
    /// C of the element size h over the half-width a, relative to the peak, to the half-width of the contact, or to the largest
    /// displacement.
    pub hidden: f64,
    /// Its exponent s.
    pub power: f64,
}

impl Counted {
    /// Those of a number of a contact that ends within an element, or where its candidates end.
    pub fn of(quantity: &Quantity, element: Element, order: Order, ends_at_candidates: bool) -> Self {
        let is_node = element == Element::Node;
        let [exponent, factor, hidden, power] = match (quantity, order) {
            (Quantity::Resultant | Quantity::Reaction { .. }, Order::Linear) => [1.5, 2.0, 0.0, 0.0],
            (Quantity::Resultant | Quantity::Reaction { .. }, _) => [1.5, 3.0, 0.0, 0.0],
            // A contact that hides no end.
            (Quantity::PeakPressure | Quantity::PeakPlace, Order::Linear) if ends_at_candidates => {
                [1.5, 1.0, 0.25, 2.0]
            }
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, Order::Linear)
                if ends_at_candidates =>
            {
                [1.5, 1.5, 0.15, 2.0]
            }
            (Quantity::PeakPressure | Quantity::PeakPlace, _) if ends_at_candidates => [1.5, 1.6, 0.0, 0.0],
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, _) if ends_at_candidates => {
                [1.5, 1.6, 0.0, 0.0]
            }
            (Quantity::PeakPressure, Order::Linear) if is_node => [1.5, 0.85, 0.035, 2.0],
            (Quantity::PeakPressure, Order::Linear) => [1.0, 0.5, 0.45, 2.0],
            (Quantity::PeakPressure, _) if is_node => [1.5, 0.3, 0.02, 2.0],
            (Quantity::PeakPressure, _) => [1.0, 1.3, 0.05, 2.0],
            (Quantity::PeakPlace, Order::Linear) if is_node => [1.5, 0.6, 0.05, 2.0],
            (Quantity::PeakPlace, Order::Linear) => [1.0, 0.8, 0.22, 2.0],
            (Quantity::PeakPlace, _) if is_node => [1.5, 0.7, 0.06, 2.0],
            (Quantity::PeakPlace, _) => [1.0, 0.9, 0.2, 2.0],
            (Quantity::HalfWidth | Quantity::Begin(_) | Quantity::End(_), Order::Linear) if is_node => {
                [2.5, 0.4, 0.24, 1.0]
            }
            (Quantity::HalfWidth | Quantity::Begin(_) | Quantity::End(_), Order::Linear) => [2.5, 1.2, 1.6, 1.0],
            (Quantity::HalfWidth | Quantity::Begin(_) | Quantity::End(_), _) if is_node => [3.0, 6.5, 0.45, 2.0],
            (Quantity::HalfWidth | Quantity::Begin(_) | Quantity::End(_), _) => [2.5, 3.5, 0.12, 1.0],
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, Order::Linear) if is_node => {
                [1.5, 0.9, 0.15, 2.0]
            }
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, Order::Linear) => [1.5, 0.6, 0.5, 2.0],
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, _) if is_node => [2.0, 0.8, 0.07, 2.0],
            (Quantity::SecondMomentWidth | Quantity::Centre | Quantity::Moment, _) => [2.0, 0.95, 0.09, 2.0],
            // Below the surface.
            (Quantity::Shear { .. }, Order::Linear) => [1.5, 1.4, 0.13, 2.0],
            (Quantity::Shear { .. }, _) => [1.5, 3.2, 0.4, 2.0],
            (Quantity::ShearDepth { .. }, Order::Linear) => [1.5, 0.45, 0.03, 2.0],
            (Quantity::ShearDepth { .. }, _) => [1.5, 1.0, 0.3, 2.0],
            // Displacements.
            (_, Order::Linear) => [1.5, 1.05, 0.01, 2.0],
            (_, _) => [2.0, 1.8, 0.01, 2.0],
        };
        Self { exponent, factor, hidden, power }
    }
}
