//! What acts on a body: supports and loads.

use std::fmt;
use std::sync::Arc;

use crate::scene::place::{BoundaryName, Component, Place};
use crate::scene::side_part::SidePart;

/// One displacement component prescribed on a boundary or at a point.
#[derive(Clone, Debug)]
pub struct Support {
    /// Where.
    pub at: Place,
    /// Which component.
    pub component: Component,
    /// Prescribed value \[mm\].
    pub value: f64,
}

/// A stress field `(x, y) ↦ [σ_x, σ_y, τ_xy]` \[MPa\], tension positive.
#[derive(Clone)]
pub struct StressField(pub Arc<dyn Fn([f64; 2]) -> [f64; 3] + Send + Sync>);

impl fmt::Debug for StressField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("StressField")
    }
}

/// A traction `(x, y) ↦ [t_x, t_y]` \[MPa\].
#[derive(Clone)]
pub struct TractionField(pub Arc<dyn Fn([f64; 2]) -> [f64; 2] + Send + Sync>);

impl fmt::Debug for TractionField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("TractionField")
    }
}

/// A load on a body.
#[derive(Clone, Debug)]
pub enum Load {
    /// Constant traction on a boundary \[MPa\].
    Traction {
        /// Boundary name.
        boundary: BoundaryName,
        /// Traction vector \[MPa\].
        traction: [f64; 2],
    },
    /// Traction on a boundary that depends on the place.
    TractionField {
        /// Boundary name.
        boundary: BoundaryName,
        /// The field.
        field: TractionField,
    },
    /// Traction `t = σ n` of a given stress field on a boundary.
    Stress {
        /// Boundary name.
        boundary: BoundaryName,
        /// The field.
        field: StressField,
    },
    /// What acts on a boundary, or on a part of it.
    OnSide {
        /// Boundary name.
        boundary: BoundaryName,
        /// The part; all of it where there is none.
        part: Option<SidePart>,
        /// What acts there.
        action: Action,
    },
    /// Force per volume [N/mm³].
    BodyForce([f64; 2]),
    /// Force at a point of the body \[N\].
    Force {
        /// The point \[mm\].
        at: [f64; 2],
        /// Force vector \[N\].
        force: [f64; 2],
    },
    /// A boundary that stays flat: one component is common to all its nodes and takes a total force.
    RigidFace {
        /// Boundary name.
        boundary: BoundaryName,
        /// The component that stays common.
        component: Component,
        /// Total force in that direction on the modelled part \[N\].
        force: f64,
    },
}

/// What acts on a side.
#[derive(Clone, Debug)]
pub enum Action {
    /// The same traction everywhere \[MPa\].
    Uniform([f64; 2]),
    /// A traction that depends on the place.
    Field(TractionField),
    /// The traction `t = σ n` of a stress field.
    Stress(StressField),
    /// The traction, the same everywhere, of a total force on the modelled part \[N\].
    Total([f64; 2]),
    /// A couple on the modelled part, counter-clockwise \[N mm\]: `t = M/(t J) e_z × (r − r̄)` with the centroid r̄ of the side and
    /// `J = ∫|r − r̄|² ds`, so that its resultant vanishes; on a straight side a pressure linear in the coordinate along it.
    Moment(f64),
}
