//! Codes that are timed on meshes of their own: who is asked for which meshes.

use std::fmt;

use serde_json::{Value, json};

use crate::named::named_enum;

named_enum! {
    /// A code on meshes of its own.
    pub enum Code {
        /// By exact active sets.
        ScikitFem = "scikit-fem",
        /// By a penalty.
        Dolfinx = "dolfinx",
        /// At high order, by an augmented Lagrangian.
        Ngsolve = "NGSolve",
    }
}

/// Meshes of scikit-fem and dolfinx: cells per candidate stretch, and times cut into four.
const TRIANGLES: [[usize; 2]; 8] = [[8, 0], [12, 0], [16, 0], [17, 0], [32, 0], [17, 1], [32, 1], [64, 1]];
/// Meshes of NGSolve: order, and cells per candidate stretch.
const HIGH_ORDER: [[usize; 2]; 7] = [[3, 6], [4, 9], [6, 9], [4, 18], [4, 27], [6, 27], [4, 81]];

impl Code {
    /// Script that asks it, and what it is called with.
    pub fn script(self) -> (&'static str, Vec<String>) {
        match self {
            Self::ScikitFem | Self::Dolfinx => ("work_precision.py", vec![self.name().into()]),
            Self::Ngsolve => ("ngsolve_precision.py", vec![]),
        }
    }

    /// Meshes that it is asked for.
    pub fn meshes(self) -> Value {
        match self {
            Self::ScikitFem | Self::Dolfinx => json!(TRIANGLES),
            Self::Ngsolve => json!(HIGH_ORDER),
        }
    }

    /// What its meshes are, in a few words.
    pub fn cells(self) -> String {
        match self {
            Self::ScikitFem | Self::Dolfinx => "meshes of its own".into(),
            Self::Ngsolve => {
                let orders = || HIGH_ORDER.into_iter().map(|[order, _]| order);
                let [least, most] = [orders().min(), orders().max()].map(Option::unwrap_or_default);
                format!("orders {least} to {most}, contact edge unknown to its mesh")
            }
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
