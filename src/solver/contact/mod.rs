//! How bodies touch: each contact element turns the candidate edges into a list of contact points.
//!
//! * [`point`] — what a contact element makes.
//! * [`interface`] — nodes and edges of the candidate stretch, and where on an edge conditions are enforced.
//! * `dual` — from the candidates of both bodies to an interface, also where meshes do not match.
//! * [`primary`] — projection on to the edges of the other body.
//! * [`node`] — one spring per node pair (paper, Fig. 5).
//! * [`mod@line`] — distributed springs between two element edges (Fig. 3).
//! * [`layer`] — a thin element of fictitious material (Fig. 4).
//! * [`element`] — the choice of the contact element.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::contact::{Interface, node};
//! use signorini::elasticity::ElasticSystem;
//! use signorini::mesh::{Mesh, Order, Resolution};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let mesh = Mesh::of(&scene, Resolution { elements: 8, refinement: 0, order: Order::Linear })?;
//! let condensed = ElasticSystem::assemble(&scene, &mesh)?.condense()?;
//! let interfaces = Interface::all(&scene, &mesh, &condensed)?;
//! // The areas of the points are that of the candidates.
//! let area: f64 = node::points(&interfaces[0]).iter().map(|point| point.weight).sum();
//! let whole = scene.contact().stretch * scene.thickness;
//! assert!((area - whole).abs() <= 1e-9 * whole);
//! # Ok::<(), signorini::error::Error>(())
//! ```

mod dual;
pub mod element;
pub mod interface;
pub mod layer;
pub mod line;
pub mod node;
pub mod point;
pub mod primary;

pub use element::Element;
pub use interface::{Interface, Quadrature};
pub use point::{ContactEdge, ContactPoint};
