//! What a scene of bodies of revolution cannot have.

use crate::error::{self, Error, Part};
use crate::scene::contact_pair::ROUNDING;
use crate::scene::{Path, Place, Scene};

impl Scene {
    /// Refuses a thickness, and contacts that are not where bodies of revolution have them, or are halves that are
    /// none.
    pub(super) fn refuse_beside_revolution(&self) -> Result<(), Error> {
        let Some(radial) = self.plane.radial() else { return Ok(()) };
        if (self.thickness - 1.0).abs() > 0.0 {
            let expected = "bodies of revolution have none: loads are whole forces";
            return Err(Error::value(
                error::Place::from(self.name.as_str()),
                "thickness",
                self.thickness,
                expected,
                "use 1",
            ));
        }
        for (index, body) in self.bodies.iter().enumerate() {
            for support in &body.supports {
                let Place::Point(at) = support.at else { continue };
                let is_on_axis = at[radial].abs() <= ROUNDING * self.contact_of(index).stretch;
                if is_on_axis && support.component.index() != radial && support.value.abs() > 0.0 {
                    let key = format!("value of the support at {at:?}");
                    let expected = "a point on the axis gives way to any force: no body follows it";
                    let remedy = "prescribe it on a side, or give its force on a `rigid-face`";
                    return Err(Error::value(self.place_of_body(index), &key, support.value, expected, remedy));
                }
            }
        }
        for (contact, pair) in self.contacts.iter().enumerate() {
            let refused =
                |[message, remedy]: [&str; 2]| Err(Error::at(self.place_of(contact, Part::Stretch), message, remedy));
            if let Some(refusal) = beside(&pair.path, radial, pair.stretch) {
                return refused(refusal);
            }
            if pair.symmetric && radial == 0 {
                return refused(NO_HALF);
            }
        }
        Ok(())
    }
}

/// A section of bodies of revolution about x = 0 that shall be one half of a symmetric scene.
pub const NO_HALF: [&str; 2] = [
    "bodies of revolution are modelled whole: their section is no half of a symmetric scene",
    "leave `symmetric` out, or make it false",
];

/// Why bodies of revolution cannot touch along a path, and the remedy.
pub fn beside(path: &Path, radial: usize, stretch: f64) -> Option<[&'static str; 2]> {
    let [x, _] = path.origin();
    match path {
        Path::Straight { both_sides: true, .. } if radial == 0 && x - stretch < 0.0 - ROUNDING * stretch => Some([
            "the candidates go on beyond x = 0: bodies of revolution lie on one side of their axis, and so does their \
            contact",
            "around the axis leave `both-sides` out; off it give an `origin` that lies farther out than `stretch`",
        ]),
        Path::Straight { both_sides: false, .. } if radial == 0 && x.abs() > 0.0 => Some([
            "off the axis the contact of bodies of revolution is a ring, and has both sides",
            "give `both-sides = true` and an `origin` within the ring, or let the path begin on the axis, at x = 0",
        ]),
        Path::Straight { .. } if radial == 1 && path.point(0.0)[1] <= 0.0 => Some([
            "the contact lies on the axis of revolution y = 0, where a side has no area",
            "give an `origin` at the radius of the contact",
        ]),
        Path::Arc(_) if radial == 0 && x.abs() > 0.0 => Some([
            "on an arc the contact is the same on both sides of its centre, and a ring about x = 0 is not",
            "put the centre of `arc` on the axis, or turn the bodies about y = 0, `axis = \"x\"`",
        ]),
        Path::Arc(circle) if radial == 1 && circle.centre[1] < circle.radius => {
            Some(["the arc goes on beyond the axis y = 0", "put its centre at least one radius above the axis"])
        }
        _ => None,
    }
}
