//! What a scene of bodies of revolution cannot have.

use crate::error::{Error, Part, Place};
use crate::scene::{Path, Scene};

impl Scene {
    /// Refuses a thickness, contacts along an arc, off the axis or on both sides of it, and halves, where bodies are of
    /// revolution.
    pub(super) fn refuse_beside_revolution(&self) -> Result<(), Error> {
        if !self.is_of_revolution() {
            return Ok(());
        }
        if (self.thickness - 1.0).abs() > 0.0 {
            let expected = "bodies of revolution have none: loads are whole forces";
            return Err(Error::value(Place::from(self.name.as_str()), "thickness", self.thickness, expected, "use 1"));
        }
        for (contact, pair) in self.contacts.iter().enumerate() {
            let refused =
                |message: &str, remedy: &str| Err(Error::at(self.place_of(contact, Part::Stretch), message, remedy));
            match pair.path {
                Path::Arc(_) => {
                    let message = "contact along an arc is not computed for bodies of revolution";
                    return refused(
                        message,
                        "let the contact run along y = const from the axis on, or model it in the plane",
                    );
                }
                Path::Straight(line) if line.both_sides => {
                    let message = "bodies of revolution lie on one side of their axis, and so does their contact";
                    return refused(message, "leave `both-sides` out");
                }
                Path::Straight(line) if line.origin[0].abs() > 0.0 => {
                    let message = "the contact coordinate of bodies of revolution is the radius";
                    return refused(message, "let the path begin on the axis, at x = 0");
                }
                Path::Straight(_) if pair.symmetric => {
                    let message =
                        "bodies of revolution are modelled whole: their section is no half of a symmetric scene";
                    return refused(message, "leave `symmetric` out, or make it false");
                }
                Path::Straight(_) => {}
            }
        }
        Ok(())
    }
}
