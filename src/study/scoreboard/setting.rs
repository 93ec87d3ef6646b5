//! Codes of the scoreboard, and the contact that each is run with.

use crate::named::named_enum;

named_enum! {
    /// A code.
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
        /// scikit-fem.
        ScikitFem = "scikit-fem",
        /// dolfinx.
        Dolfinx = "dolfinx",
    }
}

impl Code {
    /// Its script under `oracles/peers`.
    pub fn script(self) -> &'static str {
        match self {
            Self::Calculix => "run_calculix.py",
            Self::Getfem => "run_getfem.py",
            Self::Ngsolve => "run_ngsolve.py",
            Self::Sfepy => "run_sfepy.py",
            Self::Kratos => "run_kratos.py",
            Self::Akantu => "run_akantu.py",
            Self::Felupe => "run_felupe.py",
            Self::ScikitFem => "run_scikit_fem.py",
            Self::Dolfinx => "run_dolfinx.py",
        }
    }
}

/// A code with one of its contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The code.
    pub code: Code,
    /// What its script calls the contact.
    pub method: &'static str,
    /// The same in words.
    pub says: &'static str,
    /// Whether it is what the code documents first or, where it has no contact of its own, what one writes first.
    pub first: bool,
}

impl Setting {
    /// All, the first choice of each code before the others.
    pub const ALL: [Self; 20] = [
        Self::of(Code::Calculix, "pair", "contact pair, surface to surface, K = 50 E per mm", true),
        Self::of(Code::Calculix, "stiff-pair", "the same with K = 1000 E per mm", false),
        Self::of(Code::Calculix, "gaps", "gap elements of the exported deck", false),
        Self::of(Code::Getfem, "integral", "integral contact brick, augmented Lagrangian", true),
        Self::of(Code::Getfem, "basic", "basic contact brick on the exported rows", false),
        Self::of(Code::Ngsolve, "contact", "contact boundary, energy of overlap, K = 50 E per mm", true),
        Self::of(Code::Ngsolve, "stiff-contact", "the same with K = 1000 E per mm", false),
        Self::of(Code::Ngsolve, "active-set", "active sets on the exported rows", false),
        Self::of(Code::Sfepy, "contact", "contact term on both sides, cells of 4 nodes, K = 10 E per mm", true),
        Self::of(Code::Sfepy, "stiff-contact", "the same with K = 100 E per mm, quadrature of order 30", false),
        Self::of(
            Code::Kratos,
            "contact",
            "mortar contact, augmented Lagrangian, cells of 4 nodes, one load step",
            true,
        ),
        Self::of(Code::Kratos, "contact-in-steps", "the same in 10 load steps", false),
        Self::of(
            Code::Akantu,
            "contact",
            "penalty contact, cells of 4 nodes, ε = 400 E per mm; reactions, tangent and turn of the scene are ours",
            true,
        ),
        Self::of(Code::Akantu, "stiff-contact", "the same with ε = 4000 E per mm", false),
        Self::of(
            Code::Felupe,
            "contact",
            "contact with rigid planes, its only one; facing nodes of two bodies are paired by us; k = mean nodal stiffness",
            true,
        ),
        Self::of(Code::Felupe, "stiff-contact", "the same with 100 times that k", false),
        Self::of(Code::ScikitFem, "penalty", "springs on the exported rows, k = 10 E/h", true),
        Self::of(Code::ScikitFem, "active-set", "active sets on the exported rows", false),
        Self::of(Code::Dolfinx, "penalty", "springs on the exported rows, k = 10 E/h", true),
        Self::of(Code::Dolfinx, "active-set", "active sets on the exported rows", false),
    ];

    const fn of(code: Code, method: &'static str, says: &'static str, first: bool) -> Self {
        Self { code, method, says, first }
    }

    /// The setting of a code by the name of its method.
    pub fn named(code: Code, method: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|one| one.code == code && one.method == method)
    }
}
