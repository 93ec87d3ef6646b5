//! How far differences between meshes are counted on to tell the error of a number.
//!
//! `u = F max |f₀ − fᵢ| / (rᵢ^q − 1) + C (h/a)^s + D`: the finest value f₀, those of meshes of the sizes `rᵢ h`, the
//! part C that the end of a contact may hide, as it lies somewhere within an element of each mesh and all of them may
//! agree by accident, and what is known otherwise, D: of a peak how far two readings of it are apart on the mesh
//! itself, what a top narrower than its elements hides (`evidence`).
//!
//! F and C are the narrowest that hold on random scenes of closed form: the study *coverage* records those scenes, a
//! test derives the constants from the record again, and other scenes judge them. q is no claim of an order: pressures
//! at the points of line and layer elements oscillate, and what cells of 8 nodes gain on the coarser meshes is lost
//! where the end of the contact decides. Numbers below the surface have a C too, for coarse meshes that agree by
//! accident. A largest von Mises stress is counted on as a largest shear stress, by two or three times as much: the
//! records hold none, and a test holds its bars against the same closed forms.

use crate::measure::Quantity;
use crate::mesh::Order;
use crate::named::named_enum;
use crate::solve::Element;

named_enum! {
    /// Numbers whose differences between meshes are counted on alike.
    pub enum Kind {
        /// peak pressure.
        Peak = "peak",
        /// place of the peak.
        Place = "place",
        /// half-width and ends of the contact.
        End = "end",
        /// second-moment width, centre and moment.
        Moment = "moment",
        /// forces.
        Force = "force",
        /// displacement and approach.
        Displacement = "displacement",
        /// largest shear stress below the contact, and largest von Mises stress.
        Shear = "shear",
        /// its depth.
        Depth = "depth",
    }
}

impl Kind {
    /// The one of a number.
    pub fn of(quantity: &Quantity) -> Self {
        use Quantity::{Begin, Centre, End, HalfWidth, Moment, PeakPlace, PeakPressure, Reaction, Resultant};
        match quantity {
            PeakPressure => Self::Peak,
            PeakPlace => Self::Place,
            HalfWidth | Begin(_) | End(_) => Self::End,
            Quantity::SecondMomentWidth | Centre | Moment => Self::Moment,
            Resultant | Reaction { .. } => Self::Force,
            Quantity::Shear { .. } | Quantity::VonMises { .. } => Self::Shear,
            Quantity::ShearDepth { .. } => Self::Depth,
            _ => Self::Displacement,
        }
    }
}

/// Numbers of one kind that a formulation finds on cells of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Row {
    /// Of what the numbers are.
    pub kind: Kind,
    /// Whether cells have four nodes.
    pub linear: bool,
    /// Whether pressures are those of node elements, where that matters.
    pub node: bool,
    /// Whether the contact ends where its candidates do, and hides no end, where that matters.
    pub ends_at_candidates: bool,
}

impl Row {
    /// Those of a contact that ends within an element, or where its candidates end.
    pub fn of(kind: Kind, element: Element, order: Order, ends_at_candidates: bool) -> Self {
        let of_pressures = matches!(kind, Kind::Peak | Kind::Place | Kind::End | Kind::Moment);
        let ends_at_candidates = of_pressures && kind != Kind::End && ends_at_candidates;
        let node = of_pressures && !ends_at_candidates && element == Element::Node;
        Self { kind, linear: order == Order::Linear, node, ends_at_candidates }
    }

    /// Exponent q of the element size.
    pub fn exponent(self) -> f64 {
        if self.linear || self.ends_at_candidates { 1.5 } else { 2.0 }
    }

    /// Exponent s of the element size h over the half-width a: an end is hidden within a part of its element, what that
    /// leaves elsewhere falls with the square.
    pub fn power(self) -> f64 {
        if self.kind == Kind::End { 1.0 } else { 2.0 }
    }

    /// Factor F on the worst difference; and C, relative to the peak, to the half-width of the contact, or to the
    /// largest displacement.
    pub fn constants(self) -> [f64; 2] {
        let Self { kind, linear, node, ends_at_candidates } = self;
        match (kind, linear) {
            (Kind::Peak, true) if ends_at_candidates => [1.6, 0.0],
            (Kind::Peak, true) if node => [1.0, 0.12],
            (Kind::Peak, true) => [1.0, 0.011],
            (Kind::Peak, false) if ends_at_candidates => [1.0, 0.0],
            (Kind::Peak, false) if node => [1.0, 0.0068],
            (Kind::Peak, false) => [4.7, 0.075],
            (Kind::End, true) if node => [1.0, 0.18],
            (Kind::End, true) => [1.0, 1.5],
            (Kind::End, false) if node => [3.3, 0.0],
            (Kind::End, false) => [1.0, 0.36],
            (Kind::Moment, true) if ends_at_candidates => [1.0, 0.27],
            (Kind::Moment, true) if node => [1.0, 0.13],
            (Kind::Moment, true) => [1.0, 0.091],
            (Kind::Moment, false) if ends_at_candidates => [1.0, 0.0],
            (Kind::Moment, false) if node => [1.0, 0.075],
            (Kind::Moment, false) => [1.0, 0.1],
            (Kind::Shear, true) => [1.1, 0.22],
            (Kind::Shear, false) => [3.9, 0.036],
            (Kind::Displacement, true) => [1.1, 0.0068],
            (Kind::Displacement, false) => [2.0, 0.0013],
            (Kind::Force | Kind::Place | Kind::Depth, _) => [1.0, 0.0],
        }
    }
}
