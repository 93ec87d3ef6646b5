//! Where an iteration must fail, and how fast it goes, before it is run: read off the condensed matrices.
//!
//! * [`limit`] — the contact an iteration shall end in.
//! * [`linear`] — iterations of constant stiffness from its start, linearised on the final active set.
//! * [`rate`] — asymptotic rates of the iterations on their final active set.
//! * [`release`] — iterations of varying stiffness, from the points just outside the contact.
//! * [`conditioning`] — what stiff springs cost in digits.
//! * [`halving`] — iterations of kinematic load started with every candidate closed.
//!
//! ```
//! use contact_vv::case::library::Cylinder;
//! use contact_vv::mesh::{Order, Resolution};
//! use contact_vv::solve::{Discretisation, Element, Formulation, Iteration};
//! use contact_vv::stability::{Limit, rate};
//!
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let discretisation = Discretisation::of(Cylinder::default().scene(), resolution)?;
//! let formulation = Formulation::new(Element::Line, Iteration::Constant);
//! let points = discretisation.points(&formulation);
//! let problem = discretisation.problem(&formulation, &points);
//! let limit = Limit::of(&problem).expect("the cylinder is supported and pressed");
//! // Below 1 the iteration converges.
//! assert!(rate::correction(&problem, &limit.closed).is_some_and(|rate| rate < 1.0));
//! # Ok::<(), contact_vv::error::Error>(())
//! ```

pub mod conditioning;
pub mod halving;
pub mod limit;
pub mod linear;
pub mod rate;
pub mod release;

pub use limit::Limit;
