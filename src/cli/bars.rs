//! The error bars of a solve, as a table and as JSON.

use comfy_table::{Table, presets};
use serde::Serialize;

use crate::accuracy::{Bar, Barred, Bars, Quantity, Subject};
use crate::cli::found::Found;
use crate::cli::reactions;
use crate::cli::terminal::say;
use crate::markdown;
use crate::measure::display_factor;
use crate::scene::Scene;
use crate::solve::Displaced;

/// The same as JSON; what is not known is null, and angles are in radians.
#[derive(Serialize)]
pub struct Document {
    of: String,
    quantity: String,
    value: f64,
    bound: f64,
    mesh: f64,
    iteration: f64,
    penalty: f64,
}

impl Document {
    /// Every bar of a solve.
    pub fn all(found: &Found) -> Vec<Self> {
        let one = |one: &Barred| {
            let Line { of, quantity, .. } = Line::of(found, one);
            let Bar { mesh, iteration, penalty } = one.bar;
            Self { of, quantity, value: one.value, bound: one.bar.total(), mesh, iteration, penalty }
        };
        found.bars.iter().flat_map(|bars| bars.all.iter()).map(one).collect()
    }
}

/// How one number is told.
struct Line {
    /// The contact, or the body.
    of: String,
    quantity: String,
    unit: &'static str,
    /// From its unit to the one it is shown in.
    factor: f64,
}

impl Line {
    fn of(found: &Found, one: &Barred) -> Self {
        let scene = &found.problem.scene;
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
                let stretches = found.run.contacts[contact].measures.stretches.len();
                let number = match quantity {
                    Quantity::Begin(k) | Quantity::End(k) if stretches > 1 => format!(" of stretch {}", k + 1),
                    _ => String::new(),
                };
                Self { of: pair.name.clone(), quantity: format!("{}{number}", quantity.name()), unit, factor }
            }
            Subject::Reaction(body, support) => {
                let body = &scene.bodies[body];
                let support = &body.supports[support];
                let component = reactions::component(support.component);
                let quantity = format!("reaction at {}, {component}", reactions::at(&support.at));
                Self { of: body.name.clone(), quantity, unit: "N", factor: 1.0 }
            }
            Subject::Displacement(Displaced { body, at, component }) => {
                let component = reactions::component(component);
                let quantity = format!("displacement at {}, {component}", reactions::at(&at));
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

impl Line {
    /// A number of a body below one of its contacts, which is named where there are several.
    fn below(scene: &Scene, name: &str, [contact, body]: [usize; 2], unit: &'static str) -> Self {
        let below = match scene.contacts.len() {
            1 => String::new(),
            _ => format!(" below {}", scene.contacts[contact].name),
        };
        Self { of: scene.bodies[body].name.clone(), quantity: format!("{name}{below}"), unit, factor: 1.0 }
    }
}

/// Prints every number with its bar.
pub fn print(found: &Found) {
    let Some(Bars { all, meshes, .. }) = &found.bars else { return };
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.set_header(["of", "quantity", "value ± bound", "unit", "mesh", "iteration", "penalty"]);
    for one in all {
        let Line { of, quantity, unit, factor } = Line::of(found, one);
        let Bar { mesh, iteration, penalty } = one.bar;
        let part = |part: f64| if part.is_nan() { "unknown".into() } else { markdown::significant(factor * part, 2) };
        let value = match one.value {
            _ if is_unbounded(found, &one.subject) => "without limit".into(),
            value if value.is_nan() => "unknown".into(),
            value => format!("{} ± {}", markdown::value(factor * value), part(one.bar.total())),
        };
        table.add_row([of, quantity, value, unit.into(), part(mesh), part(iteration), part(penalty)]);
    }
    say(table);
    if *meshes == 0 {
        say(
            "the mesh's part is unknown: no coarser mesh of this scene holds the contact, or a body is one element deep; give more elements, or for a mesh made elsewhere `--accuracy`, which halves it",
        );
    }
}

/// Whether it is a peak that has no limit.
fn is_unbounded(found: &Found, subject: &Subject) -> bool {
    matches!(subject, Subject::Contact(contact, Quantity::PeakPressure) if found.run.contacts[*contact].unbounded.is_some())
}
