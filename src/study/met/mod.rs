//! Whether an accuracy called met is met: random scenes of closed form, solved to four accuracies, from guesses of the
//! candidate stretch up to ten times too long or three times too short.
//!
//! * `plan` — which scenes, and which accuracies.
//! * `draw` — the random numbers.
//! * `scenes` — a random scene of each family, and the truth about it.
//! * `run` — one scene solved to one accuracy, against the truth.
//! * `judge` — what the record must hold.
//! * `section` — what it shows.

pub mod draw;
pub mod judge;
pub mod plan;
pub mod run;
pub mod scenes;
mod section;

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "met";

pub use judge::judge;
pub use plan::{ASKED, Family, Site, plan, sites};
pub use run::{Numbers, Record};
pub use section::{pictures, section};
