//! The referee: another code's answer, on its own mesh, judged by the truths, measures and tolerances of a case.
//!
//! * [`units`] — units of what is handed in.
//! * [`source`] — a file that is handed in, and how it is refused.
//! * [`answer`] — what another code found.
//! * [`asked`] — how a file is to be read.
//! * [`table`], [`document`], [`grid`], [`calculix`], [`frd`] — answers as CSV, as JSON, of VTK and of CalculiX;
//!   [`mod@read`] — a file by its ending; `foreign` — what it is where it is none of them.
//! * [`state`] — which state of an analysis is judged.
//! * `unstructured` — a grid of VTK; `vtu`, `vtk` — one in XML, and in the legacy format; `pvd` — one of several.
//! * [`side`] — which nodes of a mesh lie on the contact side, and whether they are all that is pressed.
//! * `complete` — whether an answer holds the whole contact.
//! * [`profile`] — an answer as contact points and edge means, of which measures are taken.
//! * `between` — what pressures are between points.
//! * [`field`] — displacements brought to our mesh; `whole` — what they tell: equilibrium, energy, declared checks.
//! * [`norm`] — the distance of a profile from the truth.
//! * [`truth`] — what a case is judged by.
//! * [`mod@bench`] — what a profile is judged with.
//! * [`mod@judge`] — the verdicts; [`contact_laws`], `declared` — those of gaps and sides, and of a scene file's own
//!   checks.
//! * [`series`] — a refinement series of answers; [`picture`] — one drawn on the truth.
//! * [`export`] — all that is needed to run a case elsewhere.
//! * [`mistakes`] — what explains an answer that does not meet its truth.

pub mod answer;
pub mod asked;
pub mod bench;
mod between;
pub mod calculix;
mod complete;
pub mod contact_laws;
mod declared;
pub mod document;
pub mod export;
pub mod field;
mod foreign;
pub mod frd;
pub mod grid;
pub mod judge;
pub mod mistakes;
pub mod norm;
pub mod picture;
pub mod profile;
mod pvd;
pub mod read;
pub mod series;
pub mod side;
pub mod source;
pub mod state;
pub mod table;
pub mod truth;
pub mod units;
mod unstructured;
mod vtk;
mod vtu;
mod whole;

use crate::error::Error;

pub use answer::{Answer, Handed};
pub use asked::Asked;
pub use judge::Ruled;
pub use profile::Profile;
pub use truth::Truth;

/// An answer judged.
#[derive(Clone, Debug)]
pub struct Verdicts {
    /// The answer.
    pub answer: Answer,
    /// Its contacts, in the order of the scene.
    pub ruled: Vec<Ruled>,
    /// Usual mistakes that explain what is not met.
    pub mistakes: Vec<String>,
    /// Contacts of the scene that were not handed in.
    pub absent: Vec<String>,
    /// What the closed forms of the case say that our own run contradicts, and what makes the answer another one than
    /// may be meant.
    pub notes: Vec<String>,
}

impl Verdicts {
    /// Whether nothing is failed, and every contact was handed in.
    pub fn met(&self) -> bool {
        self.absent.is_empty() && !self.fails()
    }

    /// Whether something of what was handed in is failed.
    pub fn fails(&self) -> bool {
        let mut judged = self.ruled.iter().flat_map(|ruled| &ruled.judged);
        judged.any(|judged| judged.verdict == crate::case::Verdict::Fail)
    }
}

/// What is said of forces whose order was not told.
const BY_TURNS: &str = "the forces are taken as of 8-node cells, of which corners and mid-sides have a third and two \
    thirds of an edge by turns, since they vary less so; where cells have 4 nodes, say --order 1";

/// Judges an answer by the truth of its case.
pub fn verdicts(truth: &Truth, answer: Answer, tolerance: f64) -> Result<Verdicts, Error> {
    let scene = &truth.case.scene;
    let handed = || (0..scene.contacts.len()).filter_map(|contact| answer.of(contact));
    for handed in handed() {
        complete::all(truth, &answer, handed, &Profile::of(scene, handed), tolerance)?;
    }
    let profiles: Vec<Profile> = handed().map(|handed| Profile::of(scene, &profile::ended(truth, handed))).collect();
    let mut ruled: Vec<Ruled> = profiles.iter().map(|profile| judge::judge(truth, profile, tolerance)).collect();
    let is_of_scene = match &answer.field {
        Some(field) => whole::judge(truth, field, &profiles, &mut ruled, tolerance)?,
        None => {
            ruled[0].missing.push(whole::missing());
            false
        }
    };
    let beside = (&answer.units, is_of_scene);
    let mistakes = handed().flat_map(|handed| mistakes::explain(truth, handed, beside, tolerance)).collect();
    let names = scene.contacts.iter().enumerate().filter(|(contact, _)| answer.of(*contact).is_none());
    let absent = names.map(|(_, pair)| pair.name.clone()).collect();
    let turned = profiles.iter().filter(|profile| profile.is_by_turns).map(|_| BY_TURNS.to_owned());
    let notes = truth.notes().into_iter().chain(answer.notes.clone()).chain(turned).collect();
    Ok(Verdicts { ruled, mistakes, absent, notes, answer })
}
