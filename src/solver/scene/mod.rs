//! What is asked: bodies, supports, loads and the contact between them, as data.
//!
//! * [`material`] — elastic constants and the plane hypothesis.
//! * [`shape`] — the outlines the mesher knows.
//! * [`place`] — boundaries, points and directions.
//! * [`load`] — supports and loads of a body, on a side or a part of it.
//! * [`contact_pair`] — who touches whom, along which path, with which initial gap.
//! * [`path`] — the curve along which contact runs, and circles.
//! * [`drawn`] — the gap between sides as they are drawn.
//! * [`spline`] — a monotone cubic through points.
//! * [`given`] — a mesh made elsewhere.
//! * `revolution` — what bodies of revolution cannot have.
//! * [`variant`] — the same scene in other units, mirrored, or with its bodies swapped.
//!
//! Units are millimetre, newton and megapascal throughout.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//!
//! let mut scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! assert!(scene.validate().is_ok());
//! scene.thickness = 0.0;
//! assert!(scene.validate().is_err());
//! ```

pub mod contact_pair;
pub mod drawn;
pub mod given;
mod hertz;
pub mod load;
pub mod material;
pub mod path;
pub mod place;
pub mod revolution;
pub mod shape;
pub mod spline;
pub mod variant;

use std::f64::consts::TAU;

use crate::error::{self, Error, Part, positive};

pub use contact_pair::{ContactPair, Ends, Profile, ROUNDING};
pub use drawn::{Curve, DrawnGap};
pub use given::{GivenMesh, HalfTold};
pub use load::{Action, Along, Load, SidePart, Support, VectorField};
pub use material::{LARGEST_POISSON, Material, PlaneHypothesis};
pub use path::{Circle, Path};
pub use place::{BoundaryName, Component, Displaced, Place};
pub use shape::{BlockShape, Face, Grading, Sector, Shape};
pub use spline::MonotoneCubic;

/// A contact problem: everything that is asked, nothing about how it is solved.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Name, as used on the command line and in snapshots.
    pub name: String,
    /// Plane strain, plane stress, or bodies of revolution.
    pub plane: PlaneHypothesis,
    /// Thickness of all bodies \[mm\]; 1 where they are of revolution.
    pub thickness: f64,
    /// The elastic bodies.
    pub bodies: Vec<Body>,
    /// The contacts of the bodies with one another, or with rigid profiles; at least one.
    pub contacts: Vec<ContactPair>,
    /// Reference values: they turn initial stiffnesses into pure numbers.
    pub reference: ReferenceValues,
    /// How the mesh coarsens away from the contact.
    pub grading: Grading,
}

/// Length, pressure and gap that make stiffnesses dimensionless and that springs start from; what has converged does
/// not depend on them.
#[derive(Clone, Copy, Debug)]
pub struct ReferenceValues {
    /// `ℓ` in `κ = k_n ℓ / E*` \[mm\].
    pub length: f64,
    /// `p_ref` \[MPa\].
    pub pressure: f64,
    /// `g_ref` \[mm\].
    pub gap: f64,
}

/// An elastic body with its supports and loads.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name used in messages and results.
    pub name: String,
    /// Outline.
    pub shape: Shape,
    /// Elastic constants.
    pub material: Material,
    /// Candidate elements of this body over those of the mesh: 1 where the nodes of both bodies shall face one another.
    pub density: f64,
    /// Prescribed displacements.
    pub supports: Vec<Support>,
    /// Loads.
    pub loads: Vec<Load>,
}

impl Body {
    /// Whether a boundary is held along x and along y, by supports or as a face that stays straight.
    pub fn held(&self, boundary: &BoundaryName) -> [bool; 2] {
        let supports = self.supports.iter().filter_map(|support| match &support.at {
            Place::Boundary(name) => Some((name, support.component)),
            Place::Point(_) => None,
        });
        let faces = self.loads.iter().filter_map(|load| match load {
            Load::RigidFace { boundary, component, .. } => Some((boundary, *component)),
            _ => None,
        });
        let own: Vec<Component> =
            supports.chain(faces).filter(|(name, _)| *name == boundary).map(|(_, along)| along).collect();
        [0, 1].map(|k| own.iter().any(|along| along.index() == k))
    }

    /// Whether a boundary is held in both directions.
    pub fn is_clamped(&self) -> bool {
        let is_clamped = |support: &Support| match &support.at {
            Place::Boundary(name) => self.held(name) == [true; 2],
            Place::Point(_) => false,
        };
        self.supports.iter().any(is_clamped)
    }
}

impl Scene {
    /// Whether a body bends far away from its contacts.
    pub fn bends(&self) -> bool {
        self.bodies.iter().any(|body| body.shape.bends())
    }

    /// Whether the bodies are of revolution.
    pub fn is_of_revolution(&self) -> bool {
        self.plane.is_of_revolution()
    }

    /// What the model stands for across its plane at a point: the thickness, or the circumference `2πr` of a body of
    /// revolution \[mm\].
    pub fn depth(&self, point: [f64; 2]) -> f64 {
        self.plane.radial().map_or(self.thickness, |radial| TAU * point[radial])
    }

    /// Whether a contact of bodies of revolution begins on their axis, so that it is a circle, and no ring.
    pub fn is_around_axis(&self, contact: usize) -> bool {
        self.contacts[contact].path.is_around_axis(self.plane)
    }

    /// The first contact, which is the only one of most scenes.
    pub fn contact(&self) -> &ContactPair {
        &self.contacts[0]
    }

    /// Contact modulus `1/E* = Σ 1/E'` over the elastic bodies of a contact, `E' = E/(1−ν²)` in plane strain and of
    /// bodies of revolution, `E` in plane stress; the largest where there are several contacts \[MPa\].
    pub fn contact_modulus(&self) -> f64 {
        self.contacts.iter().map(|pair| self.modulus_of(pair)).fold(0.0, f64::max)
    }

    /// Contact modulus of one contact \[MPa\].
    pub fn modulus_of(&self, pair: &ContactPair) -> f64 {
        let compliance: f64 = pair.bodies().map(|b| 1.0 / self.bodies[b].material.plane_modulus(self.plane)).sum();
        1.0 / compliance
    }

    /// The contact that a body is meshed for: the first on its side `contact`, else the first that it takes part in.
    pub fn contact_of(&self, body: usize) -> &ContactPair {
        let on_side = self.contacts_of(body).find(|pair| pair.side(body) == contact_pair::CONTACT);
        on_side.or_else(|| self.contacts_of(body).next()).unwrap_or(self.contact())
    }

    /// The contacts that a body takes part in.
    pub fn contacts_of(&self, body: usize) -> impl Iterator<Item = &ContactPair> {
        self.contacts.iter().filter(move |pair| pair.bodies().any(|other| other == body))
    }

    /// A body, as errors name it.
    pub fn place_of_body(&self, body: usize) -> error::Place {
        error::Place::Body { body, name: format!("{}, body `{}`", self.name, self.bodies[body].name).into() }
    }

    /// A load of a body, as errors name it.
    pub fn place_of_load(&self, body: usize, load: usize) -> error::Place {
        error::Place::Load {
            body: body as u32,
            load: load as u32,
            name: format!("{}, body `{}`", self.name, self.bodies[body].name).into(),
        }
    }

    /// A contact, as errors name it: by its bodies, and by its own name where there are several.
    pub fn place_of(&self, contact: usize, part: Part) -> error::Place {
        let pair = &self.contacts[contact];
        let own = if self.contacts.len() == 1 { String::new() } else { format!(" `{}`", pair.name) };
        let bodies: Vec<String> = pair.bodies().map(|body| format!("`{}`", self.bodies[body].name)).collect();
        error::Place::Contact {
            contact,
            part,
            name: format!("{}, contact{own} of {}", self.name, bodies.join(" and ")).into(),
        }
    }

    /// Refuses what cannot be solved, naming scene, body, key, value and remedy.
    pub fn validate(&self) -> Result<(), Error> {
        let scene = error::Place::from(self.name.as_str());
        positive(&scene, "thickness", self.thickness)?;
        positive(&scene, "reference length", self.reference.length)?;
        positive(&scene, "reference pressure", self.reference.pressure)?;
        positive(&scene, "reference gap", self.reference.gap)?;
        self.refuse_beside_revolution()?;
        if self.contacts.is_empty() {
            return Err(Error::value(scene, "contacts", 0, "at least one is needed", "add one"));
        }
        for (contact, pair) in self.contacts.iter().enumerate() {
            positive(&self.place_of(contact, Part::Stretch), "candidate stretch", pair.stretch)?;
            self.refuse_ended(contact)?;
        }
        for (index, body) in self.bodies.iter().enumerate() {
            body.material.validate(&self.place_of_body(index), self.plane)?;
        }
        Ok(())
    }

    /// Refuses candidates where a body, or the rigid profile that it meets, has ended.
    fn refuse_ended(&self, contact: usize) -> Result<(), Error> {
        let pair = &self.contacts[contact];
        let reach = |body: usize| self.bodies[body].shape.reach(pair.side(body), &pair.path);
        let reaches = pair.bodies().map(|body| (format!("`{}`", self.bodies[body].name), reach(body)));
        let all = reaches.chain([("the rigid profile".to_string(), pair.profile.reach())]);
        for (name, reach) in all {
            if let Some(reach) = reach.filter(|reach| pair.stretch > reach * (1.0 + ROUNDING)) {
                let [stretch, reach] = [pair.stretch, reach].map(|s| pair.path.reported(s));
                let (place, expected) = (self.place_of(contact, Part::Stretch), format!("{name} ends at {reach}"));
                return Err(Error::value(place, "candidate stretch", stretch, expected, "shorten it to there"));
            }
        }
        Ok(())
    }
}
