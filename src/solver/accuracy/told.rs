//! How a quoted number is told: of what, its name, and its unit.

use crate::accuracy::bar::Barred;
use crate::measure::Quantity;
use crate::scene::{Displaced, Scene};
use crate::solve::Run;

/// How one number is told.
pub struct Told {
    /// The contact, or the body.
    pub of: String,
    /// What it is.
    pub quantity: String,
    /// The unit it is shown in.
    pub unit: &'static str,
    /// From its unit to the one it is shown in.
    pub factor: f64,
}

impl Told {
    /// A number of a run on a scene.
    pub fn of(scene: &Scene, run: &Run, one: &Barred) -> Self {
        let pair = &scene.contacts[one.contact];
        let (unit, factor) = one.quantity.unit(!pair.path.is_straight());
        let key = one.quantity.key();
        let below = |what: &str| match scene.contacts.len() {
            1 => what.to_owned(),
            _ => format!("{what} below {}", pair.name),
        };
        let of_body = |body: usize| scene.bodies[body].name.clone();
        let (of, quantity) = match &one.quantity {
            Quantity::Reaction { body, support } => {
                let support = &scene.bodies[*body].supports[*support];
                (of_body(*body), format!("{key} at {}, {}", support.at, support.component))
            }
            Quantity::Displacement(Displaced { body, at, component }) => {
                (of_body(*body), format!("{key} at {at}, {component}"))
            }
            Quantity::Shear { body } => (of_body(*body), below("largest shear")),
            Quantity::ShearDepth { body } => (of_body(*body), below("depth of largest shear")),
            Quantity::VonMises { body } => (of_body(*body), "largest von Mises".into()),
            Quantity::Begin(k) | Quantity::End(k) if run.contacts[one.contact].measures.stretches.len() > 1 => {
                (pair.name.clone(), format!("{key} of stretch {}", k + 1))
            }
            _ => (pair.name.clone(), key.into_owned()),
        };
        Self { of, quantity, unit, factor }
    }
}
