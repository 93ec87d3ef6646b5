//! Kinds of random scenes, the random numbers that they are drawn from, what is true of a sample of them, and which
//! were not used to choose how far anything is counted on.

use serde::{Deserialize, Serialize};

use crate::measure::Quantity;
use crate::named::named_enum;
use crate::scene::{Component, Place, Scene};
use crate::solve::Displaced;

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014).
#[derive(Clone, Debug)]
pub struct Draw {
    state: u64,
}

impl Draw {
    /// The numbers of a seed.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// A number between two others, each as likely.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((z ^ (z >> 31)) as f64 / u64::MAX as f64)
    }

    /// A number whose logarithm lies between those of two others, each as likely.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

named_enum! {
    /// A kind of scene whose truth is known, by its name in records; the first line of each is its title in results.
    pub enum Family {
        /// even polynomial on a block, peak also off the centre.
        ///
        /// Up to the sixth power, every second one with its peak off the centre.
        Polynomial = "polynomial",
        /// wedge with a round tip on a block.
        Wedge = "wedge",
        /// waves on a block.
        Cosine = "cosine",
        /// cylinder on a plane.
        Cylinder = "cylinder",
        /// pin in a wide plate.
        Pin = "pin",
        /// body with a coarse mesh given.
        ///
        /// Profiles on blocks, and cylinders.
        Mesh = "mesh",
        /// two contacts.
        ///
        /// Two profiles on blocks, cylinders or waves in one scene, whatever their sizes.
        Pair = "pair",
        /// truncated Hertz.
        ///
        /// Parabolas on blocks: Hertz without model error.
        Hertz = "hertz",
        /// two cylinders of different moduli.
        Cylinders = "cylinders",
        /// press fit of two rings.
        PressFit = "press-fit",
        /// block under an eccentric load.
        Eccentric = "eccentric",
        /// flat punch on a block.
        ///
        /// With sharp corners.
        Punch = "punch",
        /// block that rolls on a parabola, contact beside its vertex.
        Rolling = "rolling",
        /// power of the distance, 1.5 to 30, on a block.
        Power = "power",
        /// flat bottom with round shoulders on a block.
        Flat = "flat",
        /// different powers on both sides of a block.
        Skew = "skew",
        /// one or two humps on a block.
        ///
        /// Beside the middle: one half of two that are alike, or two of different heights.
        Hump = "hump",
        /// waves on a parabola, on a block.
        ///
        /// One stretch or several.
        Ripple = "ripple",
        /// polygon on a block.
        ///
        /// The pressure has no limit at the corners.
        Kink = "kink",
        /// two blocks of different moduli.
        ///
        /// Gaps of all these kinds.
        Blocks = "blocks",
        /// ring on a rigid pin.
        Ring = "ring",
        /// layer, sliding or bonded.
        Layer = "layer",
        /// row of contacts.
        Row = "row",
        /// truncated sphere.
        ///
        /// Paraboloids on blocks of revolution: Hertz's sphere without model error.
        Sphere = "sphere",
        /// power of the radius, 1.5 to 30, on a block of revolution.
        Indented = "power-of-revolution",
        /// two spheres of different moduli.
        Spheres = "two-spheres",
    }
}

/// A scene of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Site {
    /// Its family.
    pub family: Family,
    /// Its number in the family.
    pub number: usize,
}

impl Site {
    /// Name of its own.
    pub fn key(&self) -> String {
        format!("{}-{}", self.family.name(), self.number)
    }
}

/// Guess of the candidate stretch over the length of the contact, where the bodies allow it.
pub const GUESS: [f64; 2] = [0.3, 10.0];

/// A scene and the truths about it.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The scene.
    pub scene: Scene,
    /// What its closed form says.
    pub truths: Vec<Truth>,
    /// Fewest elements on half of the contact that see all there is.
    pub fewest: f64,
}

/// The true value of a number.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Index of the contact that it is of; 0 of reactions and displacements.
    pub contact: usize,
    /// What is measured.
    pub quantity: Quantity,
    /// Its true value.
    pub value: f64,
}

impl Sample {
    /// A scene with one contact, that any mesh sees.
    pub fn of<const N: usize>(scene: Scene, truths: [(Quantity, f64); N]) -> Self {
        let truth = |(quantity, value)| Truth { contact: 0, quantity, value };
        let sample = Self { scene, truths: truths.map(truth).into(), fewest: 0.0 };
        let half_width = sample.half_width(0);
        if half_width.is_nan() { sample } else { sample.with(Quantity::HalfWidth, half_width) }
    }

    /// Half of what lies between where a contact begins and ends; NaN where the closed form does not say.
    fn half_width(&self, contact: usize) -> f64 {
        let end = self.end(contact);
        let begin = self.truth(contact, &Quantity::Begin(0));
        let on_symmetry_line = begin.is_nan() && !self.scene.contacts[contact].path.has_both_sides();
        let begin = if on_symmetry_line { -end } else { begin };
        0.5 * (end - begin)
    }

    /// The same with another number of its first contact.
    pub fn with(mut self, quantity: Quantity, value: f64) -> Self {
        self.truths.push(Truth { contact: 0, quantity, value });
        self
    }

    /// The same with a displacement component of a side or a point \[mm\].
    pub fn moved(self, body: usize, at: Place, component: Component, value: f64) -> Self {
        self.with(Quantity::Displacement(Displaced { body, at, component }), value)
    }

    /// The same with the largest shear stress below the contact in a body, and its depth \[MPa, mm\].
    pub fn sheared(self, body: usize, [stress, depth]: [f64; 2]) -> Self {
        self.with(Quantity::Shear { body }, stress).with(Quantity::ShearDepth { body }, depth)
    }

    /// The same where the pressure has no limit, so that nothing is known of its place nor of the shear stress.
    pub fn without_peak(mut self) -> Self {
        self.truths.retain_mut(|truth| match truth.quantity {
            Quantity::PeakPressure => {
                truth.value = f64::INFINITY;
                true
            }
            Quantity::PeakPlace | Quantity::Shear { .. } | Quantity::ShearDepth { .. } => false,
            _ => true,
        });
        self
    }

    /// The displacements that its truths are of.
    pub fn displaced(&self) -> Vec<Displaced> {
        let displaced = |truth: &Truth| match &truth.quantity {
            Quantity::Displacement(displaced) => Some(displaced.clone()),
            _ => None,
        };
        self.truths.iter().filter_map(displaced).collect()
    }

    /// The same where it takes some elements on half of the contact to see all there is.
    pub fn seen_by(self, fewest: f64) -> Self {
        Self { fewest, ..self }
    }

    /// Outermost end of a contact; NaN where the closed form does not say.
    pub fn end(&self, contact: usize) -> f64 {
        let ends = (0..).map(|k| self.truth(contact, &Quantity::End(k)));
        ends.take_while(|end| end.is_finite()).last().unwrap_or(f64::NAN)
    }

    /// The true value of a number of a contact; NaN where the closed form does not say.
    pub fn truth(&self, contact: usize, quantity: &Quantity) -> f64 {
        let own = self.truths.iter().find(|truth| truth.contact == contact && truth.quantity == *quantity);
        let known = own.map(|truth| truth.value);
        match quantity {
            Quantity::HalfWidth => known.unwrap_or_else(|| self.half_width(contact)),
            _ => known.unwrap_or(f64::NAN),
        }
    }
}

/// Scenes of a family.
pub const EACH: usize = 200;
/// Number of the first one: from scenes of lower numbers the constants of the bars were chosen.
pub const FIRST: usize = 90_000;
/// Families with one contact and a mesh made here; those of which every bar is judged first.
pub const FAMILIES: [Family; 24] = [
    Family::Hertz,
    Family::Polynomial,
    Family::Wedge,
    Family::Cosine,
    Family::Cylinder,
    Family::Cylinders,
    Family::Pin,
    Family::PressFit,
    Family::Eccentric,
    Family::Punch,
    Family::Rolling,
    Family::Sphere,
    Family::Spheres,
    Family::Indented,
    Family::Power,
    Family::Flat,
    Family::Skew,
    Family::Hump,
    Family::Ripple,
    Family::Kink,
    Family::Blocks,
    Family::Ring,
    Family::Layer,
    Family::Row,
];

/// Families of which every bar is judged; of the others those that are told: bodies of revolution, whose coarsest
/// meshes tell few, and any gap with its truth by the boundary method or a series.
pub const JUDGED: &[Family] = FAMILIES.split_at(11).0;

/// Six of a family: each kind of cells with each element once, each way to end twice; of three neighbouring families
/// every combination.
pub fn chosen(family: Family) -> impl Iterator<Item = Site> {
    let turn = FAMILIES.iter().position(|one| *one == family).unwrap_or(0);
    (0..6).map(move |k| Site { family, number: FIRST + 6 * ((k + turn) % 3) + k })
}

/// Those of a family.
pub fn unseen(family: Family) -> impl Iterator<Item = Site> {
    (FIRST..FIRST + EACH).map(move |number| Site { family, number })
}
