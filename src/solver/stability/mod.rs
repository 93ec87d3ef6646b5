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
//! use signorini::scene::{Material, Scene};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::solve::{Discretisation, Element, Formulation, Iteration};
//! use signorini::stability::{Limit, rate};
//!
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let discretisation = Discretisation::of(Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5), resolution)?;
//! let formulation = Formulation::new(Element::Line, Iteration::Constant);
//! let points = discretisation.points(&formulation);
//! let problem = discretisation.problem(&formulation, &points);
//! let limit = Limit::of(&problem).expect("the cylinder is supported and pressed");
//! // Below 1 the iteration converges.
//! assert!(rate::correction(&problem, &limit.closed).is_some_and(|rate| rate < 1.0));
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod conditioning;
pub mod halving;
pub mod limit;
pub mod linear;
pub mod rate;
pub mod release;

pub use limit::Limit;
