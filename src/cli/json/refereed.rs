//! The verdicts on an answer as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::measure::display_factor;
use crate::referee::{Handed, Profile, Ruled, Truth, Verdicts};
use crate::solution::PointState;

use super::Checked;

/// The verdicts on an answer: a line of `judge --json`.
#[derive(Serialize, JsonSchema)]
pub struct Refereed {
    /// The file of the answer.
    answer: String,
    /// Name of the case.
    case: String,
    /// The code, where the answer says so.
    code: Option<String>,
    /// Whether nothing that could be judged failed.
    met: bool,
    /// Every check, contact by contact.
    checks: Vec<Checked>,
    /// The contacts that were handed in, as they are judged.
    contacts: Vec<Held>,
    /// Usual mistakes that explain what is not met.
    mistakes: Vec<String>,
    /// What could not be judged.
    missing: Vec<Missing>,
    /// What the closed forms of the case say that our own run contradicts, and what makes the answer another one than
    /// may be meant.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// Checks, mistakes, what is missing and notes as they are printed, no wider than 100 columns.
    table: String,
}

/// The pressures of a contact on the truth.
#[derive(Serialize, JsonSchema)]
struct Held {
    /// Its name.
    name: String,
    /// Unit of its positions: mm on a straight path, ° on an arc.
    unit: &'static str,
    /// Its points, and the middles of straight lines between them.
    profile: Vec<Point>,
}

/// A point of a contact.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "HeldPoint")]
struct Point {
    /// Contact coordinate.
    position: f64,
    /// Contact pressure that was handed in, or follows from the forces; in MPa.
    pressure: f64,
    /// That of the reference there in MPa; null where it has no limit.
    reference: f64,
}

/// Something that could not be judged.
#[derive(Serialize, JsonSchema)]
struct Missing {
    /// What.
    what: String,
    /// What to hand in for it.
    hand_in: String,
}

impl Refereed {
    /// What was found of an answer.
    pub fn of(truth: &Truth, found: &Verdicts, table: String) -> Self {
        let of = |[what, hand_in]: [String; 2]| Missing { what, hand_in };
        let missing = found.ruled.iter().flat_map(|ruled| ruled.missing.clone()).map(of);
        let absent = found.absent.iter().map(|name| of([format!("contact `{name}`"), "its points".into()]));
        Self {
            answer: found.answer.file.display().to_string(),
            case: truth.case.name.clone(),
            code: found.answer.code.clone(),
            met: found.met(),
            checks: found.ruled.iter().flat_map(|ruled| checks(truth, ruled)).collect(),
            contacts: found.answer.contacts.iter().map(|handed| Held::of(truth, handed)).collect(),
            mistakes: found.mistakes.clone(),
            missing: missing.chain(absent).collect(),
            notes: found.notes.clone(),
            table,
        }
    }
}

/// The checks of a contact, with its name.
fn checks(truth: &Truth, ruled: &Ruled) -> Vec<Checked> {
    let name = &truth.case.scene.contacts[ruled.contact].name;
    ruled.judged.iter().map(|judged| Checked::of(judged).of_contact(name)).collect()
}

impl Held {
    fn of(truth: &Truth, handed: &Handed) -> Self {
        let profile = Profile::of(&truth.case.scene, handed);
        let pair = profile.pair();
        let point = |point: &PointState| Point {
            position: display_factor(&pair.path) * point.position,
            pressure: point.pressure,
            reference: truth.pressure(handed.contact, point.position),
        };
        let unit = if pair.path.is_straight() { "mm" } else { "°" };
        Self { name: pair.name.clone(), unit, profile: profile.points.iter().map(point).collect() }
    }
}
