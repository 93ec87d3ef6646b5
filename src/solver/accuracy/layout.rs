//! How the meshes of a search are laid out.

use crate::accuracy::evenly::{self, Evenly};
use crate::accuracy::fitted::{self, Fitted};
use crate::accuracy::length;
use crate::accuracy::rungs::{Rung, Rungs};
use crate::error::{Error, Kind};
use crate::mesh::Resolution;
use crate::scene::Scene;
use crate::solve::run::Run;

/// Family of meshes.
pub(super) enum Layout {
    /// Fitted to one contact.
    Fitted(Fitted),
    /// Of equal candidates on several contacts, or halved from one that is given.
    Evenly(Evenly),
}

impl Layout {
    /// The layout of a scene, by cheap meshes that show where its contacts are; where one is not found, the last mesh with the reason.
    pub(super) fn found(scene: &Scene, rungs: &mut Rungs) -> Result<Result<Self, (Rung, String)>, Error> {
        match evenly::applies(scene) {
            true => Ok(Ok(Self::Evenly(Evenly::found(scene, rungs)?))),
            false => Ok(length::found(scene, rungs)?.map(Self::Fitted)),
        }
    }

    /// The scene with candidates that hold its contacts.
    pub(super) fn held(&self, scene: &Scene) -> Scene {
        match self {
            Self::Fitted(fitted) => fitted.plan(fitted::FEWEST).laid(scene).0,
            Self::Evenly(evenly) => evenly.held(scene),
        }
    }

    /// The scene with so many elements within the contact.
    pub(super) fn laid(&self, elements: usize) -> (Scene, Resolution) {
        match self {
            Self::Fitted(fitted) => fitted.plan(elements).laid(&fitted.scene),
            Self::Evenly(evenly) => evenly.laid(elements),
        }
    }

    /// Elements of the first mesh whose bars are looked at.
    pub(super) fn begins(&self, asked: f64) -> usize {
        match self {
            Self::Fitted(_) => fitted::elements(asked),
            Self::Evenly(evenly) => evenly.begins(asked),
        }
    }

    /// Elements of the next mesh.
    pub(super) fn finer(&self, elements: usize, ratio: f64) -> usize {
        match self {
            Self::Evenly(evenly) if evenly.is_halved() => 2 * elements,
            _ => ((elements as f64 * ratio).ceil() as usize).max(elements + 1),
        }
    }

    /// Lengthens candidates that an error tells are too short; whether it does.
    pub(super) fn lengthens(&mut self, error: &Error) -> bool {
        match self {
            Self::Fitted(fitted) => {
                let is_short = matches!(error.kind, Kind::ContactBeyondCandidates { .. });
                is_short && fitted.widens()
            }
            Self::Evenly(evenly) => evenly.lengthens(error),
        }
    }

    /// Takes what a run tells of the contact; whether its candidates were too short, and are longer now.
    pub(super) fn looks(&mut self, scene: &Scene, run: &Run) -> bool {
        match self {
            Self::Fitted(fitted) => fitted.looks(scene, run),
            Self::Evenly(_) => false,
        }
    }
}
