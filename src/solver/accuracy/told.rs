//! How a quoted number is told: of what, its name, and its unit.

use crate::accuracy::bar::Barred;
use crate::accuracy::reading::{Quantity, Subject};
use crate::measure::display_factor;
use crate::scene::Scene;
use crate::solve::{Displaced, Run};

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
        match one.subject.clone() {
            Subject::Contact(contact, quantity) => {
                let pair = &scene.contacts[contact];
                let factor = display_factor(&pair.path);
                let place = if factor > 1.0 { "°" } else { "mm" };
                let (unit, factor) = match quantity {
                    Quantity::PeakPressure => ("MPa", 1.0),
                    Quantity::Resultant => ("N", 1.0),
                    Quantity::Moment => ("N mm", 1.0),
                    _ => (place, factor),
                };
                let stretches = run.contacts[contact].measures.stretches.len();
                let number = match quantity {
                    Quantity::Begin(k) | Quantity::End(k) if stretches > 1 => format!(" of stretch {}", k + 1),
                    _ => String::new(),
                };
                Self { of: pair.name.clone(), quantity: format!("{}{number}", quantity.name()), unit, factor }
            }
            Subject::Reaction(body, support) => {
                let body = &scene.bodies[body];
                let support = &body.supports[support];
                let quantity = format!("reaction at {}, {}", support.at, support.component);
                Self { of: body.name.clone(), quantity, unit: "N", factor: 1.0 }
            }
            Subject::Displacement(Displaced { body, at, component }) => {
                let quantity = format!("displacement at {at}, {component}");
                Self { of: scene.bodies[body].name.clone(), quantity, unit: "mm", factor: 1.0 }
            }
            Subject::Approach(contact) => {
                let of = scene.contacts[contact].name.clone();
                Self { of, quantity: "approach".into(), unit: "mm", factor: 1.0 }
            }
            Subject::Shear(contact, body) => Self::below(scene, "largest shear", [contact, body], "MPa"),
            Subject::ShearDepth(contact, body) => Self::below(scene, "depth of largest shear", [contact, body], "mm"),
        }
    }
}

impl Told {
    /// A number of a body below one of its contacts, which is named where there are several.
    fn below(scene: &Scene, name: &str, [contact, body]: [usize; 2], unit: &'static str) -> Self {
        let below = match scene.contacts.len() {
            1 => String::new(),
            _ => format!(" below {}", scene.contacts[contact].name),
        };
        Self { of: scene.bodies[body].name.clone(), quantity: format!("{name}{below}"), unit, factor: 1.0 }
    }
}
