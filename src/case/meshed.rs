//! A case on its mesh.

use std::sync::OnceLock;

use crate::accuracy::{Answer, Family};
use crate::solve::{Discretisation, Displaced, Element, Formulation, Iteration, Run};

/// A case on its mesh, which all its formulations share.
pub struct Meshed {
    /// Mesh, system and condensation.
    pub discretisation: Discretisation,
    /// How the mesh was found, where an accuracy chose it.
    pub answer: Option<Answer>,
    /// What coarser meshes say, once it was asked for.
    pub families: Families,
}

/// What coarser meshes say, a contact element each.
pub type Families = [OnceLock<Family>; Element::ALL.len()];

impl Meshed {
    /// What coarser meshes say of the contact element of a run, and of the displacements that are wanted: solved for once.
    pub(super) fn family(&self, run: &Run, wanted: &[Displaced]) -> &Family {
        let Formulation { element, layer_thickness, .. } = run.formulation;
        let cell = &self.families[element as usize];
        if let Some(known) = cell.get() {
            return known;
        }
        // Not within the cell: a thread that waits in there might be handed work that needs it.
        let formulation = Formulation { layer_thickness, ..Formulation::new(element, Iteration::Kinematic) };
        let family = Family::of(&self.discretisation, &formulation, Some(wanted));
        cell.get_or_init(|| family)
    }
}
