//! Frictionless contact of linear elastic bodies in two dimensions by finite elements: from a scene to pressures with
//! error bars.
//!
//! The code is one chain, read in this order:
//!
//! * [`scene`] — what is asked: bodies, loads, supports, contacts with their gaps.
//! * [`mesh`] — where: structured meshes that grow away from the contact, or meshes made elsewhere.
//! * [`elasticity`] — how bodies resist.
//! * [`condensation`] — what the contact sees of the bodies.
//! * [`contact`] — how bodies touch: line, layer and node elements as lists of contact points.
//! * [`algorithm`] — how to find it: varying stiffness, constant stiffness, kinematic load.
//! * [`solution`] — what came out.
//! * [`measure`] — the numbers one quotes.
//! * [`solve`] — one way from a scene to a solution, by any formulation: element × algorithm × rule × stiffness.
//! * [`accuracy`] — how far these numbers may be from the truth, and the cheapest mesh for an accuracy asked.
//! * [`stability`] — where an iteration must fail, before it is run.
//! * [`oracle`] — closed forms and boundary methods, which share nothing with the chain but the scene.
//!
//! Beside the chain stand [`error`], what was wrong, [`clock`], what each stage took, [`named`](mod@named), enums of
//! named members, and [`uncertainty`], what ± means.
//!
//! ```
//! use signorini::accuracy::{self, Quantity};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::scene::{Material, Scene};
//! use signorini::solve::{Discretisation, Formulation, Run};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Quadratic };
//! let discretisation = Discretisation::of(scene, resolution)?;
//! let run = Run::of(&discretisation, &Formulation::verification())?;
//! let bar = accuracy::bars(&discretisation, &run, &[])?.of(0, &Quantity::PeakPressure).expect("a bar");
//! println!("p₀ = {:.1} ± {:.1} MPa, Hertz {:.1}", run.measures().peak.pressure, bar.total(), 5769.2);
//! // A cylinder is no half-plane: 0.062 % here.
//! assert!((run.measures().peak.pressure - 5769.2).abs() <= bar.total() + 0.00063 * 5769.2);
//! # Ok::<(), signorini::error::Error>(())
//! ```
//!
//! # Signs and units
//!
//! | symbol | meaning | sign, unit |
//! |---|---|---|
//! | `w` | approach: how far the two sides have moved towards each other along the contact normal | > 0 closing, mm |
//! | `g` | initial normal gap | ≥ 0; < 0 is interference, mm |
//! | `h = g − w` | remaining gap | ≥ 0 when the contact conditions hold |
//! | `p` | contact pressure | ≥ 0 compressive, MPa |
//! | `k_n` | spring stiffness per unit area | MPa/mm |
//! | `κ = k_n ℓ/E*` | the same without units | – |
//! | `E*` | contact modulus, `1/E* = Σ (1−ν²)/E` in plane strain, `Σ 1/E` in plane stress | MPa |
//!
//! Contact conditions (Hertz–Signorini–Moreau): `h ≥ 0`, `p ≥ 0`, `p h = 0`, with `w = u_n^A + u_n^B` and `u_n` a
//! body's displacement along its own outward normal. Normals, areas and gaps belong to the undeformed surface. Stresses
//! are positive in tension.

pub mod accuracy;
pub mod algorithm;
pub mod clock;
pub mod condensation;
pub mod contact;
pub mod elasticity;
pub mod error;
pub mod measure;
pub mod mesh;
pub mod named;
pub mod oracle;
pub mod scene;
pub mod solution;
pub mod solve;
pub mod stability;
pub mod uncertainty;
