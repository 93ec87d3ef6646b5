//! From the candidates of both bodies to an interface: every node of the first is given what it faces on the second.

use crate::condensation::Condensed;
use crate::contact::dual;
use crate::contact::interface::Interface;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

impl Interface {
    /// The interface of every contact of a scene.
    pub fn all(scene: &Scene, mesh: &Mesh, condensed: &Condensed) -> Result<Vec<Self>, Error> {
        (0..scene.contacts.len()).map(|contact| Self::between(scene, mesh, condensed, contact)).collect()
    }

    /// Projects the candidates of the first body of a contact on to the second; their nodes need not match.
    pub fn between(scene: &Scene, mesh: &Mesh, condensed: &Condensed, contact: usize) -> Result<Self, Error> {
        let mut interface = Self::projected(scene, mesh, condensed, contact)?;
        if let Some(primary) = &interface.primary {
            let rows = dual::rows(&interface, primary);
            interface.nodes.iter_mut().zip(rows).for_each(|(node, row)| node.opposite = row);
        }
        Ok(interface)
    }
}
