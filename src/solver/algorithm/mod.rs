//! How to find it: the three iterations, their rules, and one loop that counts, stops and judges.
//!
//! * [`problem`] — what an algorithm sees: matrices, points, springs and scales, no geometry; what an iteration finds.
//! * [`rule`] — how the springs' strain drives their stiffness or force, and what its start is a multiple of.
//! * [`varying`], [`constant`], [`kinematic`] — equations (3.1)–(3.14), one iteration each.
//! * [`logarithms`], [`forces`] — Newton's method for varying and for constant stiffness: not of the paper, and named.
//! * [`kept`], [`settling`] — their factors, where few springs change and where most come to rest.
//! * [`exact`] — the discrete solution that all of them shall end in.
//! * [`target`] — how far an iterate is from it.
//! * [`bound`] — a bound on that, in the energy norm.
//! * [`parts`] — points and edges contact by contact, and the means over edges.
//! * [`criterion`] — what else an iteration can be stopped by.
//! * [`mod@iterate`] — the loop; `ending` — how it ends short of its criterion; [`iteration`] — the choice of the
//!   algorithm.
//!
//! ```
//! use signorini::algorithm::{Constant, Settings, StiffnessRule, iterate};
//! use signorini::scene::{Material, Scene};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::solve::{Discretisation, Element, Formulation, Iteration};
//!
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let discretisation = Discretisation::of(Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5), resolution)?;
//! let formulation = Formulation::new(Element::Line, Iteration::Constant);
//! let points = discretisation.points(&formulation);
//! let problem = discretisation.problem(&formulation, &points);
//! let solution = iterate(&problem, &mut Constant::new(StiffnessRule::Correction), Settings::default())?;
//! assert!(solution.converged());
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod bound;
pub mod constant;
pub mod criterion;
mod ending;
pub mod exact;
pub mod forces;
pub mod iterate;
pub mod iteration;
pub mod kept;
pub mod kinematic;
pub mod logarithms;
pub mod parts;
pub mod problem;
pub mod rule;
pub mod settling;
pub mod target;
pub mod varying;

use crate::solution::Work;

pub use constant::Constant;
pub use criterion::Criterion;
pub use exact::{Exact, Law};
pub use iterate::{Settings, iterate, iterate_from};
pub use iteration::Iteration;
pub use kinematic::Kinematic;
pub use problem::{ContactProblem, Iterate, Scale, Springs};
pub use rule::{Acceleration, Leeway, Spring, StiffnessRule, StiffnessUnit};
pub use target::Target;
pub use varying::Varying;

/// An iteration algorithm: one iteration from springs to an iterate and to the next springs.
pub trait Algorithm {
    /// Solves with the present springs, then lets the rule change them.
    ///
    /// None where `S + K_c` is not positive definite: no spring is left to hold a body.
    fn next(&mut self, problem: &ContactProblem, springs: &mut Springs, work: &mut Work) -> Option<Iterate>;

    /// Told before the first iteration of each load increment: the load is no longer what it was. It may change the
    /// springs.
    fn reload(&mut self, _problem: &ContactProblem, _springs: &mut Springs) {}

    /// What closed points do where it ends: penetration may be the springs' own law (penalty) instead of an error to be
    /// iterated away.
    fn law(&self) -> Law {
        Law::Rigid
    }
}
