//! Other codes, asked in two senses that must not be mixed.
//!
//! * *The same discrete problem* ([`DiscreteProblem`]): our mesh, assembled and solved by scikit-fem and dolfinx
//!   through Python files under `oracles/python`; agreement to round-off.
//! * *The same physical problem* ([`PhysicalScene`]): scripts in `oracles/dolfinx`, `scikit_fem`, `boundary`, `getfem`
//!   and `calculix` that share the scene and the few formulas that [`independent`] names; agreement within the
//!   discretisation errors of both. Those of `oracles/high` are of high order ([`high`]).
//!
//! Bodies of revolution have scripts of their own ([`revolution`]).
//!
//! Both are read from what a live run left under `oracles/frozen` ([`frozen`]), or asked live ([`live`]).

pub mod frozen;
pub mod high;
pub mod independent;
pub mod live;
pub mod process;
pub mod revolution;

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::named::named_enum;

/// What installs the Python side.
pub const SET_UP: &str = "run `bash oracles/setup.sh`";

named_enum! {
    /// A finite element code that is not ours.
    pub enum Code {
        /// CalculiX.
        Calculix = "CalculiX",
        /// GetFEM.
        Getfem = "GetFEM",
        /// NGSolve.
        Ngsolve = "NGSolve",
        /// SfePy.
        Sfepy = "SfePy",
        /// Kratos.
        Kratos = "Kratos",
        /// Akantu.
        Akantu = "Akantu",
        /// FElupe.
        Felupe = "FElupe",
        /// scikit-fem (Gustafsson & McBain 2020).
        ScikitFem = "scikit-fem",
        /// dolfinx, the solver of FEniCSx (Baratta et al. 2023).
        Dolfinx = "dolfinx",
    }
}

impl Code {
    /// Those that assemble our mesh.
    pub const TWINS: [Self; 2] = [Self::ScikitFem, Self::Dolfinx];
}

/// A mesh with everything that makes a discrete contact problem of it, as plain numbers; see
/// `oracles/python/discrete.py`.
///
/// The contact is that of line elements with two Gauss points an edge and springs `k_n = κ E*/ℓ` that open and close.
#[derive(Clone, Debug, Default, Serialize)]
pub struct DiscreteProblem {
    /// Name, as in the frozen files.
    pub name: String,
    /// `strain` or `stress`.
    pub plane: &'static str,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Nodes of each cell: corners counter-clockwise, then mid-sides.
    pub cells: Vec<Vec<usize>>,
    /// Body of each cell.
    pub body: Vec<usize>,
    /// Young's modulus of each body \[MPa\].
    pub young: Vec<f64>,
    /// Poisson's ratio of each body.
    pub poisson: Vec<f64>,
    /// Node and component of each displacement at rest.
    pub held: Vec<[usize; 2]>,
    /// Nodes whose vertical displacement is common.
    pub tied: Vec<usize>,
    /// Total vertical force on them \[N\].
    pub tied_force: f64,
    /// Loaded edges: first node, last node, middle; the body lies to their left.
    pub load_edges: Vec<Vec<usize>>,
    /// Constant traction on them \[MPa\].
    pub traction: [f64; 2],
    /// Load them by the stresses of Hertz's half-space instead.
    pub hertz_load: bool,
    /// Candidate edges of the first body.
    pub contact_first: Vec<Vec<usize>>,
    /// Candidate edges of the second body; none where it is rigid.
    pub contact_second: Vec<Vec<usize>>,
    /// `circle`, `parabola` or `hole`.
    pub profile: &'static str,
    /// Radius of the profile \[mm\].
    pub radius: f64,
    /// Radial clearance \[mm\].
    pub clearance: f64,
    /// Contact along an arc about the origin instead of a horizontal line.
    pub arc: bool,
    /// Reference length ℓ \[mm\].
    pub length: f64,
    /// Spring stiffnesses κ.
    pub kappa: Vec<f64>,
    /// Displacements \[mm\], node by node, to multiply the stiffness with; they respect the supports.
    pub vectors: Vec<Vec<f64>>,
}

/// What a code answers to a [`DiscreteProblem`]; vectors are node by node, x before y.
#[derive(Clone, Debug, Deserialize)]
pub struct DiscreteAnswer {
    /// Stiffness times each of the vectors \[N\].
    pub products: Vec<Vec<f64>>,
    /// Load vector \[N\].
    pub load: Vec<f64>,
    /// Contact pressures at the Gauss points for each κ \[MPa\], in the order of the contact coordinate.
    pub pressure: Vec<Vec<f64>>,
    /// Displacements for each κ \[mm\].
    pub displacement: Vec<Vec<f64>>,
}

/// A scene in numbers, for a code to mesh in its own way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PhysicalScene {
    /// `cylinder`, `truncated-hertz`, `pin-rod` or `pin-plate`.
    pub case: String,
    /// Lengths \[mm\], angles \[rad\], moduli \[MPa\] and forces \[N\] by name.
    pub numbers: BTreeMap<String, f64>,
    /// Contact coordinates at which the profile is asked \[mm, or rad\]; none where numbers alone are.
    #[serde(default)]
    pub stations: Vec<f64>,
}

/// What a code answers to a [`PhysicalScene`] on one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PhysicalAnswer {
    /// Half-width by second moment \[mm, or rad\].
    pub half_width: f64,
    /// Peak pressure \[MPa\].
    pub peak: f64,
    /// Contact force on the whole contact along the load line \[N\].
    pub resultant: f64,
    /// Pressure at the stations \[MPa\].
    pub pressure: Vec<f64>,
    /// Displacement components of the mesh.
    pub dofs: usize,
}

/// Where the Python files are.
pub fn scripts() -> PathBuf {
    root().join("oracles/python")
}
