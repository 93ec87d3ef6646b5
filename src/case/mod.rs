//! A claim: a problem, the formulations that solve it, and checks that hold the results against independent truth.
//!
//! * [`check`] — requirement, quantity, oracle, tolerance with its reason, verdict.
//! * [`problem`] — the problems of the suite by name: scene, default mesh and oracle.
//! * [`run`] — one problem solved by one formulation, measured.
//! * [`universal`] — what every converged run must satisfy, whatever the problem.
//! * [`suite`] — all cases and studies as a flat list of trials.
//! * [`exact`], [`hertz`], [`pin`] — the cases.
//! * [`refinement`], [`sweep`], [`family`], [`gaertner`] — studies over meshes, stiffnesses and dimensions.
//! * [`cross_code`] — the solver against scikit-fem and dolfinx.
//! * [`limits`] — where everything else breaks.
//! * [`faults`] — the record of planted faults.
//! * [`atlas`] — where each formulation converges, and where it was predicted to.
//! * [`accuracy`] — the cheapest mesh for an accuracy asked.
//! * [`converged`] — what is called converged.
//! * [`met`] — whether an accuracy called met is met.
//! * [`records`] — files of recorded surveys.
//! * [`unbounded`] — peaks without a limit.
//! * [`scene_file`] — a user's own scene, with its checks.
//! * [`stability`] — predicted rates and steps against measured ones.
//! * [`cures`] — acceleration of constant stiffness, nested starts of kinematic load.
//! * [`timings`] — what each accuracy costs.
//! * [`pictures`] — fields and iteration paths that are shown, not judged.
//! * [`statements`] — the paper's statements, judged from the findings.

pub mod accuracy;
pub mod atlas;
pub mod check;
pub mod converged;
pub mod cross_code;
pub mod cures;
pub mod exact;
pub mod family;
pub mod faults;
pub mod gaertner;
pub mod hertz;
pub mod limits;
pub mod met;
pub mod pictures;
pub mod pin;
pub mod problem;
pub mod records;
pub mod refinement;
pub mod run;
pub mod scene_file;
pub mod stability;
pub mod statements;
pub mod suite;
pub mod sweep;
pub mod timings;
pub mod unbounded;
pub mod universal;

pub use check::{Check, Reference, Verdict};
pub use problem::Problem;
pub use run::Run;
pub use scene_file::SceneFile;
pub use suite::{FieldData, Finding, Series, Table, Trial};
