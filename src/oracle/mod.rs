//! Independent truth: what a result is held against, where it comes from, and how far it can be trusted.
//!
//! * [`analytic`] and [`boundary`]: closed forms and boundary methods, which are the solver's ([`signorini::oracle`]).
//! * [`cross_code`]: other finite element codes, run through Python or read from what such a run left.
//! * [`digitised`]: curves read off published figures, admitted only with their provenance.

pub mod cross_code;
pub mod digitised;

pub use signorini::oracle::{Oracle, Quantity, Reading, ReferenceKind, SharedOracle, Source, analytic, boundary};
