//! One road from a scene to a solution, and what a formulation of it is: contact element × algorithm × rule ×
//! stiffness.
//!
//! * [`formulation`] — one way of solving a contact problem.
//! * [`discretisation`] — a scene meshed, assembled and condensed; on it formulations solve, after a change of load or
//!   clearance too.
//! * `road` — from a discretisation to a solution, from the active set of another one.
//! * `unheld` — what no support holds and contact cannot.
//! * `refusals` — what formulations are not defined for, and problems that have no solution.
//! * [`candidate_end`] — surfaces that meet beyond the candidates, or between contact points.
//! * [`edge_fitted`] — meshes whose lines lie on the ends of the contact, found on the way.
//! * [`fields`] — displacements and stresses of a solution.
//! * [`mod@equilibrium`] — of every body: loads, contact and reactions.
//! * [`mod@reactions`] — what the supports exert.
//! * [`mod@displaced`] — displacements of sides and points, the approach of bodies.
//! * [`mod@shear`] — the largest shear stress below a contact.
//! * [`mod@von_mises`] — the largest von Mises stress of a body; [`mod@without_limit`] — places at which it has none.
//! * `largest` — where inside cells the largest stress is looked for.
//! * [`mod@number`] — how every number that one quotes is taken from a solution.
//! * `uncondensed` — its pressures once more without condensation.
//! * [`curve`] — what every load increment came to.
//! * [`run`] — one scene solved by one formulation, measured, and how that ended.
//! * [`unbounded`] — peaks without a limit.
//! * `corner` — those at a corner that is pressed, of the `outline` of a body.
//! * [`wedge`] — how the pressure grows towards it.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::solve::{Discretisation, Formulation};
//!
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let discretisation = Discretisation::of(Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5), resolution)?;
//! for formulation in Formulation::nine() {
//!     assert!(discretisation.solve(&formulation)?.converged(), "{}", formulation.name());
//! }
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod candidate_end;
mod corner;
pub mod curve;
pub mod discretisation;
pub mod displaced;
pub mod edge_fitted;
pub mod equilibrium;
pub mod fields;
pub mod formulation;
mod largest;
pub mod number;
mod outline;
pub mod reactions;
mod refusals;
mod road;
pub mod run;
pub mod shear;
pub mod unbounded;
mod uncondensed;
mod unheld;
pub mod von_mises;
pub mod wedge;
pub mod without_limit;

pub use crate::algorithm::problem::LIMITS;
pub use crate::algorithm::{Acceleration, Iteration, Settings};
pub use crate::contact::Element;
pub use crate::elasticity::shape_functions::values as shapes;
pub use crate::scene::Displaced;
pub use discretisation::{Change, Discretisation, Permits};
pub use edge_fitted::Fitted;
pub use equilibrium::Equilibrium;
pub use fields::Fields;
pub use formulation::Formulation;
pub use reactions::Reaction;
pub use run::{Ended, Run};
pub use shear::Shear;
pub use von_mises::VonMises;
pub use without_limit::WithoutLimit;
