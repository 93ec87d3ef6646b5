//! Random scenes, and what is true of them by closed forms or a boundary method: the same ones for every study that
//! asks.
//!
//! * [`family`] — kinds of scenes, the random numbers, a scene and the truths about it, and scenes that bars and
//!   accuracies are tested with.
//! * `blocks` — blocks under parabolas, waves and punches, and those that are cut out of the half-plane that they
//!   press.
//! * `gaps` — gaps of all other kinds, whose truth is that of the boundary method.
//! * `round` — cylinders, pins and rings; layers and rows; bodies of revolution.
//!
//! Below is a scene of each family; such scenes with a coarse mesh given, and two of them in one.
//!
//! Sizes, materials, loads and guesses of the candidate stretch are drawn. What the scene is and the closed form is not
//! must stay far below the errors that are looked at: blocks carry the stresses of the half-plane on their sides, and
//! leave nothing out; waves are pressed on blocks at least two waves high, e^(−8π) of which nothing is left; cylinders
//! have a/R ≤ 0.005 and pins clearances of 1e-6 radii in plates of 1000 radii, which leaves 1e-5; of spheres a
//! half-space leaves out up to a fifth of a/R (tests measure all three).

mod blocks;
pub mod family;
mod gaps;
pub mod round;

use std::sync::Arc;

use crate::accuracy::longest::longest;
use crate::error::Error;
use crate::measure::Quantity;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{ContactPair, Material, Shape};
use crate::solve::Displaced;

pub use family::{Draw, Family, GUESS, Sample, Site, Truth};

impl Site {
    /// The scene.
    pub fn sample(&self) -> Result<Sample, Error> {
        let mut draw = Draw::new((1000 * self.family as usize + self.number) as u64);
        self.family.sample(&mut draw, self.number)
    }
}

impl Family {
    /// A scene of the family.
    fn sample(self, draw: &mut Draw, number: usize) -> Result<Sample, Error> {
        let material = Material { young: draw.decades(1e3, 4e5), poisson: draw.between(0.0, 0.45) };
        // The first number of a seed is like that of the next one.
        let guess = draw.decades(GUESS[0], GUESS[1]);
        let (block, odd) = (&[material][..], number % 2 == 1);
        Ok(match self {
            Self::Polynomial => gaps::polynomial(draw, material, guess, odd),
            Self::Wedge => gaps::wedge(draw, material, guess),
            Self::Cosine => blocks::cosine(draw, material, guess),
            Self::Cylinder => round::cylinder(draw, material, guess),
            Self::Pin => round::pin(draw, material, guess),
            Self::Mesh => return meshed(draw, number),
            Self::Pair => return pair(draw, number),
            Self::Hertz => blocks::hertz(draw, material, guess),
            Self::Cylinders => round::cylinders(draw, material, guess),
            Self::PressFit => round::press_fit(draw, material),
            Self::Eccentric => blocks::eccentric(draw, material),
            Self::Punch => blocks::flat_punch(draw, material),
            Self::Rolling => blocks::rolling(draw, material, guess),
            Self::Power => gaps::pressed(draw, block, guess, |draw| gaps::power(draw, !odd)),
            Self::Flat => gaps::pressed(draw, block, guess, gaps::flat),
            Self::Skew => gaps::pressed(draw, block, guess, gaps::skew),
            Self::Hump => gaps::pressed(draw, block, guess, |draw| gaps::humps(draw, odd)),
            Self::Ripple => gaps::pressed(draw, block, guess, gaps::ripples),
            Self::Kink => gaps::pressed(draw, block, guess, |draw| gaps::kinks(draw, odd)).without_peak(),
            Self::Blocks => gaps::blocks(draw, material, guess, number),
            Self::Ring => round::ring(draw, material, guess),
            Self::Layer => round::layer(draw, material, guess, number),
            Self::Row => round::row(draw, material, guess),
            Self::Sphere => round::sphere(draw, material, guess),
            Self::Indented => round::power(draw, material, guess),
            Self::Spheres => round::spheres(draw, material, guess),
        })
    }
}

/// A scene of another family with a mesh given for its body: of 4- or 8-node cells, two to six of them on the
/// half-width, its inner nodes shaken.
fn meshed(draw: &mut Draw, number: usize) -> Result<Sample, Error> {
    let of = [Family::Polynomial, Family::Wedge, Family::Cosine, Family::Cylinder][number % 4];
    let (elements, shake) = (draw.between(2.0, 7.0) as usize, draw.between(0.0, 0.2));
    let order = if draw.between(0.0, 2.0) < 1.0 { Order::Linear } else { Order::Quadratic };
    let mut sample = of.sample(draw, number)?;
    let scene = &mut sample.scene;
    let guess = scene.contacts[0].stretch;
    // Its cells have the size of a part of the contact, whatever the guess.
    scene.contacts[0].stretch = (1.5 * scene.grading.unit).min(longest(scene, scene.contact()));
    let mesh = Mesh::of(scene, Resolution { elements, refinement: 0, order })?;
    // Shaken, a line inside would no longer be straight, and its load another one.
    let straight = mesh.bodies[0].lines.is_empty();
    let mesh = if straight { mesh.shaken(shake) } else { mesh };
    scene.bodies[0].shape = Shape::Given(Arc::new(mesh.given(0)));
    scene.contacts[0].stretch = guess;
    Ok(sample)
}

/// Two scenes of other families in one.
fn pair(draw: &mut Draw, number: usize) -> Result<Sample, Error> {
    let families = [Family::Polynomial, Family::Wedge, Family::Cosine, Family::Cylinder];
    let Sample { mut scene, mut truths, fewest } = families[number % 4].sample(draw, number)?;
    let other = families[number / 4 % 4].sample(draw, number)?;
    let bodies = scene.bodies.len();
    scene.bodies.extend(other.scene.bodies);
    scene.contacts.extend(other.scene.contacts.into_iter().map(|pair| ContactPair {
        first: pair.first + bodies,
        second: pair.second.map(|second| second + bodies),
        ..pair
    }));
    let second = |Truth { quantity, value, .. }: Truth| {
        let (contact, quantity) = match quantity {
            Quantity::Reaction { body, support } => (0, Quantity::Reaction { body: body + bodies, support }),
            Quantity::Displacement(one) => (0, Quantity::Displacement(Displaced { body: one.body + bodies, ..one })),
            Quantity::Shear { body } => (1, Quantity::Shear { body: body + bodies }),
            Quantity::VonMises { body } => (1, Quantity::VonMises { body: body + bodies }),
            Quantity::ShearDepth { body } => (1, Quantity::ShearDepth { body: body + bodies }),
            of_contact => (1, of_contact),
        };
        Truth { contact, quantity, value }
    };
    truths.extend(other.truths.into_iter().map(second));
    Ok(Sample { scene, truths, fewest: fewest.max(other.fewest) })
}
