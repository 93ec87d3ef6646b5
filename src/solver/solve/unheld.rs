//! What no support holds and contact cannot: the reason why a scene has no solution.

use crate::elasticity::Dofs;
use crate::elasticity::rigid_motion::{FreeMotion, STOPPED_BY};
use crate::error::Error;
use crate::solve::Discretisation;

/// Part of a motion, or of the work of a load on it, that is round-off.
const ROUND_OFF: f64 = 1e-9;

impl Discretisation {
    /// A body that moves out of its contacts, or bodies that move together whether they touch or not, with the support
    /// that is missing, under `load` times the load; none where contact holds every body.
    ///
    /// There is no solution unless the load works against every motion that only opens gaps (Fichera 1964).
    pub fn unheld(&self, load: f64) -> Result<Option<Error>, Error> {
        let dofs: Vec<&Dofs> = self.system.bodies.iter().map(|body| &body.dofs).collect();
        let all: Vec<usize> = (0..dofs.len()).collect();
        if let Some(motion) = FreeMotion::all(&self.scene, &self.mesh, &dofs, &all, true)?.first() {
            return Ok(Some(self.together(motion)));
        }
        for body in all {
            let free = FreeMotion::all(&self.scene, &self.mesh, &dofs, &[body], false)?;
            let unheld = FreeMotion::simple(&free).into_iter().find_map(|motion| self.leaves(body, &motion, load));
            if unheld.is_some() {
                return Ok(unheld);
            }
        }
        Ok(None)
    }

    /// Bodies that no contact stops, closed or not.
    fn together(&self, motion: &FreeMotion) -> Error {
        let moving = motion.moving();
        let names: Vec<String> = moving.iter().map(|&body| format!("`{}`", self.scene.bodies[body].name)).collect();
        let (names, one) = (names.join(" and "), moving.len() == 1);
        let message = format!(
            "{names} {} free to {}{}: no support holds {} that way, and contact only holds bodies by one another",
            if one { "is" } else { "are" },
            motion.name(),
            if one { "" } else { " together" },
            if one { "it" } else { "any of them" },
        );
        let remedy = format!("add {} to {}", STOPPED_BY[motion.kind()], if one { "it" } else { "one of them" });
        Error::at(self.scene.place_of_body(moving.first().copied().unwrap_or(0)), message, remedy)
    }

    /// The error of a motion that opens gaps only, and that the load does not work against; none of any other.
    fn leaves(&self, body: usize, motion: &FreeMotion, load: f64) -> Option<Error> {
        let closing = self.mesh.bodies[body].candidates.iter().map(|candidate| {
            let [u, v] = motion.at(0, self.mesh.points[candidate.node]);
            u * candidate.normal[0] + v * candidate.normal[1]
        });
        if !closing.into_iter().all(|rate| rate <= ROUND_OFF) {
            return None;
        }
        let [work, terms] = self.system.bodies[body].work_of_load(&|node| motion.at(0, self.mesh.points[node]));
        let (work, round_off) = (load * work, ROUND_OFF * (load * terms).abs());
        if work < -round_off {
            return None;
        }
        let name = &self.scene.bodies[body].name;
        let [direction, stopped_by] = [motion.name(), STOPPED_BY[motion.kind()]];
        let (cause, remedy) = match work > round_off {
            true => (format!("the load moves `{name}` out of its contact, which cannot pull"), "reverse the load, or"),
            false => {
                (format!("nothing presses `{name}` into its contact, which pushes one way only"), "apply a load or")
            }
        };
        let message = format!("{cause}: it is free to {direction}, and no support holds it that way");
        let remedy = format!("{remedy} add {stopped_by}");
        Some(Error::at(self.scene.place_of_body(body), message, remedy))
    }
}
