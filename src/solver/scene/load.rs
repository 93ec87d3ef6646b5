//! What acts on a body: supports and loads, on sides and on parts of them.

use std::f64::consts::{PI, TAU};
use std::fmt;
use std::sync::Arc;

use crate::scene::place::{BoundaryName, Component, Place};

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

/// A field on the plane: a stress `(x, y) ↦ [σ_x, σ_y, τ_xy]`, tension positive, or a traction `(x, y) ↦ [t_x, t_y]`
/// \[MPa\].
#[derive(Clone)]
pub struct VectorField<const N: usize>(pub Arc<dyn Fn([f64; 2]) -> [f64; N] + Send + Sync>);

impl<const N: usize> VectorField<N> {
    /// That of a function.
    pub fn of(field: impl Fn([f64; 2]) -> [f64; N] + Send + Sync + 'static) -> Self {
        Self(Arc::new(field))
    }
}

impl<const N: usize> fmt::Debug for VectorField<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("VectorField")
    }
}

/// A load on a body.
#[derive(Clone, Debug)]
pub enum Load {
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

impl Load {
    /// What acts on all of a boundary.
    pub fn on(boundary: impl Into<BoundaryName>, action: Action) -> Self {
        Self::OnSide { boundary: boundary.into(), part: None, action }
    }
}

/// What acts on a side.
#[derive(Clone, Debug)]
pub enum Action {
    /// The same traction everywhere \[MPa\].
    Uniform([f64; 2]),
    /// A traction that depends on the place.
    Field(VectorField<2>),
    /// The traction `t = σ n` of a stress field.
    Stress(VectorField<3>),
    /// The traction, the same everywhere, of a total force on the modelled part \[N\].
    Total([f64; 2]),
    /// A couple on the modelled part, counter-clockwise \[N mm\]: `t = M/(t J) e_z × (r − r̄)` with the centroid r̄ of
    /// the side and `J = ∫|r − r̄|² ds`, so that its resultant vanishes; on a straight side a pressure linear in the
    /// coordinate along it.
    Moment(f64),
}

/// A part of a side: where a coordinate of its points lies between two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidePart {
    /// The coordinate.
    pub along: Along,
    /// Where the part begins \[mm, or rad\].
    pub from: f64,
    /// Where it ends, above `from`.
    pub to: f64,
}

/// A coordinate along a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// x or y \[mm\].
    Axis(Component),
    /// Angle from the downward vertical about a point, counter-clockwise \[rad\].
    Angle {
        /// The point \[mm\].
        centre: [f64; 2],
    },
}

impl SidePart {
    /// The coordinate of a point; an angle is the one nearest to the middle of the part.
    pub fn coordinate(&self, point: [f64; 2]) -> f64 {
        match self.along {
            Along::Axis(component) => point[component.index()],
            Along::Angle { centre } => {
                let middle = 0.5 * (self.from + self.to);
                let angle = (point[0] - centre[0]).atan2(centre[1] - point[1]);
                middle + (angle - middle + PI).rem_euclid(TAU) - PI
            }
        }
    }

    /// How fast the coordinate changes along a direction at a point, but for a positive factor.
    pub fn slope(&self, point: [f64; 2], direction: [f64; 2]) -> f64 {
        match self.along {
            Along::Axis(component) => direction[component.index()],
            Along::Angle { centre } => (point[0] - centre[0]) * direction[1] - (point[1] - centre[1]) * direction[0],
        }
    }

    /// A coordinate as messages give it.
    pub fn shown(&self, coordinate: f64) -> String {
        match self.along {
            Along::Axis(component) => format!("{component} = {coordinate} mm"),
            Along::Angle { .. } => format!("{:.6}°", coordinate.to_degrees()),
        }
    }
}
