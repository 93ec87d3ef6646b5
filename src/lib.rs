//! Égert's 1999 comparison of contact elements and iterations for frictionless elastic contact in 2D, implemented and verified.
//!
//! The code is one chain, read in this order:
//!
//! * [`scene`] — what is asked.
//! * [`mesh`] — where.
//! * [`elasticity`] — how bodies resist.
//! * [`condensation`] — what the contact sees of the bodies.
//! * [`contact`] — how bodies touch: line, layer and node elements as lists of contact points.
//! * [`measure`] — the numbers one quotes.
//! * [`algorithm`] — how to find it: varying stiffness, constant stiffness, kinematic load.
//! * [`solution`] — what came out.
//! * [`stability`] — where it must fail, before it is run.
//! * [`solve`] — one way from a scene to a solution, by any formulation: element × algorithm × rule × stiffness.
//! * [`accuracy`] — the cheapest mesh for an accuracy asked.
//! * [`oracle`] — independent truth.
//! * [`mod@case`] — claims: problems and checks.
//! * [`referee`] — the answers of other codes, judged.
//! * [`study`] — what is found out over many solves.
//! * [`report`] — the page.
//! * [`cli`] — what the user types.
//!
//! Beside the chain stand [`error`], what was wrong, [`clock`], what each stage took, `named`, enums of named members, [`checkout`],
//! where the project's files are, [`uncertainty`], what ± means, and
//! [`figure`] and [`markdown`], how results are drawn and written.
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
//! Contact conditions (Hertz–Signorini–Moreau): `h ≥ 0`, `p ≥ 0`, `p h = 0`, with `w = u_n^A + u_n^B` and `u_n` a body's
//! displacement along its own outward normal. Normals, areas and gaps belong to the undeformed surface.
//! Stresses are positive in tension.

pub mod accuracy;
pub mod algorithm;
pub mod case;
pub mod checkout;
pub mod cli;
pub mod clock;
pub mod condensation;
pub mod contact;
pub mod elasticity;
pub mod error;
pub mod figure;
pub mod markdown;
pub mod measure;
pub mod mesh;
mod named;
pub mod oracle;
pub mod referee;
pub mod report;
pub mod scene;
pub mod solution;
pub mod solve;
pub mod stability;
pub mod study;
pub mod uncertainty;
