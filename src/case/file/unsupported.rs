//! Physics that this code does not do: what a key or a name in a file asks for, and what to use instead.

/// Something that is not done here.
#[derive(Clone, Copy, Debug)]
pub struct Unsupported {
    /// Words that ask for it, in lower case and with hyphens.
    words: &'static [&'static str],
    /// What holds here.
    pub holds: &'static str,
    /// What to use instead.
    pub instead: &'static str,
}

/// All of them; the codes named are free and of general purpose.
const UNSUPPORTED: [Unsupported; 11] = [
    Unsupported {
        words: &["friction", "friction-coefficient", "coefficient-of-friction", "mu", "cof", "tangential", "stick"],
        holds: "contact has no friction here",
        instead: "leave it out, or use CalculiX or code_aster",
    },
    Unsupported {
        words: &["temperature", "thermal", "expansion", "thermal-expansion", "heat", "conductivity"],
        holds: "there are no temperatures here",
        instead: "give a shrink fit its interference, as in `gap = { uniform = -0.02 }`; else use CalculiX or \
            code_aster",
    },
    Unsupported {
        words: &["dimension", "dimensions", "3d", "z", "solid", "shell"],
        holds: "scenes have two coordinates: every point and vector has two components",
        instead: "leave it out, and give `thickness`; solids are for CalculiX or code_aster",
    },
    Unsupported {
        words: &["axisymmetric", "axisymmetry", "axisym", "revolution"],
        holds: "bodies of revolution are asked for as a plane hypothesis",
        instead: "give `plane = \"axisymmetric\"`, and leave `thickness` out",
    },
    Unsupported {
        words: &["periodic", "periodicity", "cyclic"],
        holds: "no boundaries are tied to one another as periodic",
        instead: "model half a period between two symmetry lines, its sides fixed in x; else use CalculiX or \
            code_aster",
    },
    Unsupported {
        words: &["bonded", "bond", "tied", "tie", "glue", "glued", "adhesion", "cohesive"],
        holds: "bodies that touch slide and part freely here",
        instead: "draw parts of one material as one body, of `blocks` or from Gmsh; else use CalculiX or code_aster",
    },
    Unsupported {
        words: &["dynamic", "dynamics", "transient", "time", "velocity", "damping", "inertia"],
        holds: "scenes are static",
        instead: "use CalculiX or code_aster",
    },
    Unsupported {
        words: &["density", "mass", "mass-density", "rho", "gravity"],
        holds: "bodies have no mass here",
        instead: "give weight as a load `body-force`; a `density` of elements belongs in [[body]]",
    },
    Unsupported {
        words: &["plastic", "plasticity", "yield", "yield-stress", "yield-strength", "hardening", "creep"],
        holds: "bodies are linearly elastic here",
        instead: "use CalculiX or code_aster",
    },
    Unsupported {
        words: &["nlgeom", "large-displacement", "large-displacements", "finite-strain", "large-strain"],
        holds: "displacements and strains are small here",
        instead: "use CalculiX or code_aster",
    },
    Unsupported {
        words: &["triangle", "triangles", "tri", "tetrahedron", "hexahedron"],
        holds: "cells are quadrilaterals here",
        instead: "leave it out; Gmsh cuts triangles into quadrilaterals with Mesh.SubdivisionAlgorithm = 1",
    },
];

impl Unsupported {
    /// What a key or a name asks for; none where it is no physics known here.
    pub fn asked_by(word: &str) -> Option<Self> {
        let word = word.trim_matches(['"', '\'', ' ']).to_lowercase().replace(['_', ' '], "-");
        UNSUPPORTED.into_iter().find(|one| one.words.contains(&word.as_str()))
    }

    /// The message about the word that asks for it.
    pub fn message(&self, word: &str) -> String {
        format!("`{}` is not supported: {}", word.trim_matches(['"', '\'']), self.holds)
    }
}
