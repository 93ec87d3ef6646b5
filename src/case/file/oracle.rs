//! `oracle = { hertz = { … } }` of a contact: the closed form that its checks are held against.
//!
//! Forces are those on the whole contact; moduli, Poisson's ratios and the plane hypothesis are the scene's own.

use std::sync::Arc;

use serde::Deserialize;

use crate::case::file::Source;
use crate::case::file::units::Units;
use crate::case::file::values::{Keyed, Number, Pair};
use crate::error::Error;
use crate::oracle::SharedOracle;
use crate::oracle::analytic::even_gap::EvenGap;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::lame::{PressFit, RingMaterial};
use crate::oracle::analytic::on_arc::OnArc;
use crate::oracle::analytic::persson::PinInHole;
use crate::oracle::analytic::punch::FlatPunch;
use crate::oracle::analytic::uniform::Uniform;
use crate::oracle::analytic::waves::Waves;
use crate::oracle::analytic::{bars, weight};
use crate::scene::{ContactPair, Path, Scene};

/// Terms of the series of a rounded wedge.
const TERMS: usize = 400;
/// Half-widths between which that of a load is looked for \[mm\].
const HALF_WIDTHS: [f64; 2] = [1e-9, 1e9];

/// A closed form by its name.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum OracleTable {
    /// Hertz's line contact; on truncated bodies too.
    Hertz(Keyed<HertzTable>),
    /// A pin in a hole with clearance.
    Persson(Keyed<PerssonTable>),
    /// A press fit.
    Lame(Keyed<LameTable>),
    /// A rigid flat punch.
    FlatPunch(Keyed<PunchTable>),
    /// A uniform pressure.
    Uniform(Keyed<UniformTable>),
    /// Two bars closing a gap: the first body is the moved one.
    Bars(Keyed<BarsTable>),
    /// A block under its own weight.
    OwnWeight(Keyed<WeightTable>),
    /// The gap `c₂ s² + c₄ s⁴ + c₆ s⁶`.
    Polynomial(Keyed<PolynomialTable>),
    /// A wedge with a round tip.
    Wedge(Keyed<WedgeTable>),
    /// A sinusoidal gap.
    Cosine(Keyed<CosineTable>),
}

/// `{ load = F, radius = R }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HertzTable {
    pub(super) load: Number,
    pub(super) radius: Number,
}

/// `{ load = F, radius = R, clearance = c }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerssonTable {
    pub(super) load: Number,
    pub(super) radius: Number,
    pub(super) clearance: Number,
}

/// `{ radii = [a, b, c], interference = d }`: the bore, where the rings meet, and the outside.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LameTable {
    pub(super) radii: Pair,
    pub(super) interference: Number,
}

/// `{ load = F, half-width = a }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct PunchTable {
    pub(super) load: Number,
    pub(super) half_width: Number,
}

/// `{ pressure = q, width = B }`: the whole width.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UniformTable {
    pub(super) pressure: Number,
    pub(super) width: Number,
}

/// `{ lengths = [L1, L2], width = B, gap = g, push = u }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BarsTable {
    pub(super) lengths: Pair,
    pub(super) width: Number,
    pub(super) gap: Number,
    pub(super) push: Number,
}

/// `{ weight = w, height = H, width = B }`: force per volume.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeightTable {
    pub(super) weight: Number,
    pub(super) height: Number,
    pub(super) width: Number,
}

/// `{ load = F, coefficients = [c2, c4, c6] }`, as `gap = { even = … }` has them.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PolynomialTable {
    pub(super) load: Number,
    pub(super) coefficients: Pair,
}

/// `{ load = F, radius = R, round = b }`: the gap has the slope s/R up to b, and b/R beyond.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WedgeTable {
    pub(super) load: Number,
    pub(super) radius: Number,
    pub(super) round: Number,
}

/// `{ load = F, amplitude = D, wavelength = l }`: the force on a whole wave.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CosineTable {
    pub(super) load: Number,
    pub(super) amplitude: Number,
    pub(super) wavelength: Number,
}

/// What turns the numbers of a table into those of a closed form.
struct Reader<'a> {
    source: Source<'a>,
    units: &'a Units,
    scene: &'a Scene,
    contact: usize,
}

impl OracleTable {
    /// The closed form for a contact of the scene.
    pub fn read(&self, source: Source, units: &Units, scene: &Scene, contact: usize) -> Result<SharedOracle, Error> {
        let reader = Reader { source, units, scene, contact };
        let closed: SharedOracle = match self {
            Self::Hertz(t) => Arc::new(Hertz {
                load: reader.load(&t.load)?,
                radius: reader.length("radius", &t.radius)?,
                modulus: reader.modulus(),
            }),
            Self::Persson(t) => Arc::new(reader.persson(t)?),
            Self::Lame(t) => Arc::new(reader.lame(t)?),
            Self::FlatPunch(t) => Arc::new(FlatPunch {
                load: reader.load(&t.load)?,
                half_width: reader.length("half-width", &t.half_width)?,
            }),
            Self::Uniform(t) => Arc::new(Uniform {
                applied: units.stress * source.positive("pressure", &t.pressure)?,
                width: reader.length("width", &t.width)?,
            }),
            Self::Bars(t) => Arc::new(reader.bars(t)?),
            Self::OwnWeight(t) => Arc::new(weight::OwnWeight {
                specific_weight: units.force / units.length.powi(3) * source.positive("weight", &t.weight)?,
                height: reader.length("height", &t.height)?,
                width: reader.length("width", &t.width)?,
            }),
            Self::Polynomial(t) => {
                let [c2, c4, c6] = source.entries("coefficients", &t.coefficients)?;
                let coefficient = |c: &Number, power: i32| -> Result<f64, Error> {
                    Ok(source.finite("coefficients", c)? * units.length.powi(1 - power))
                };
                let coefficients = [coefficient(c2, 2)?, coefficient(c4, 4)?, coefficient(c6, 6)?];
                reader.even(&t.load, |modulus, a| EvenGap::polynomial(modulus, a, coefficients))?
            }
            Self::Wedge(t) => {
                let (radius, round) = (reader.length("radius", &t.radius)?, reader.length("round", &t.round)?);
                reader.even(&t.load, |modulus, a| match a > round {
                    true => EvenGap::rounded_wedge(modulus, a, radius, round, TERMS),
                    false => EvenGap::polynomial(modulus, a, [0.5 / radius, 0.0, 0.0]),
                })?
            }
            Self::Cosine(t) => {
                let wavelength = reader.length("wavelength", &t.wavelength)?;
                Arc::new(Waves {
                    modulus: reader.modulus(),
                    amplitude: reader.length("amplitude", &t.amplitude)?,
                    wavelength,
                    mean: reader.load(&t.load)? / wavelength,
                })
            }
        };
        Ok(match (&scene.contacts[contact].path, self.is_of_a_line()) {
            (Path::Arc(arc), true) => Arc::new(OnArc { straight: closed, radius: arc.radius }),
            _ => closed,
        })
    }

    /// Whether its coordinate is a length along a straight line.
    fn is_of_a_line(&self) -> bool {
        matches!(self, Self::Hertz(_) | Self::FlatPunch(_) | Self::Polynomial(_) | Self::Wedge(_) | Self::Cosine(_))
    }
}

impl Reader<'_> {
    fn length(&self, key: &str, value: &Number) -> Result<f64, Error> {
        Ok(self.units.length * self.source.positive(key, value)?)
    }

    /// Force per thickness \[N/mm\].
    fn load(&self, value: &Number) -> Result<f64, Error> {
        Ok(self.units.force * self.source.positive("load", value)? / self.scene.thickness)
    }

    fn modulus(&self) -> f64 {
        self.scene.modulus_of(&self.scene.contacts[self.contact])
    }

    /// The contact of an even gap under a load.
    fn even(&self, load: &Number, of: impl Fn(f64, f64) -> EvenGap) -> Result<SharedOracle, Error> {
        let modulus = self.modulus();
        Ok(Arc::new(EvenGap::of_load(self.load(load)?, HALF_WIDTHS, |a| of(modulus, a))))
    }

    fn persson(&self, t: &PerssonTable) -> Result<PinInHole, Error> {
        let material = self.scene.bodies[self.scene.contacts[self.contact].first].material;
        Ok(PinInHole {
            radius: self.length("radius", &t.radius)?,
            clearance: self.length("clearance", &t.clearance)?,
            load: self.load(&t.load)?,
            modulus: material.plane_modulus(self.scene.plane),
            poisson: material.poisson,
            plane: self.scene.plane.into(),
        })
    }

    fn lame(&self, t: &LameTable) -> Result<PressFit, Error> {
        let [bore, interface, outside] = self.source.entries("radii", &t.radii)?;
        let [inner, outer] = rings(&self.scene.contacts[self.contact]);
        let material = |body: usize| {
            let material = self.scene.bodies[body].material;
            RingMaterial { young: material.young, poisson: material.poisson }
        };
        let not_negative = self.source.number("radii", bore, "a radius of 0 or more", |radius| radius >= 0.0)?;
        Ok(PressFit {
            bore: self.units.length * not_negative,
            interface: self.length("radii", interface)?,
            outside: self.length("radii", outside)?,
            interference: self.length("interference", &t.interference)?,
            inner: material(inner),
            outer: material(outer),
            plane: self.scene.plane.into(),
        })
    }

    fn bars(&self, t: &BarsTable) -> Result<bars::Bars, Error> {
        let [moved, fixed] = self.source.entries("lengths", &t.lengths)?;
        Ok(bars::Bars {
            young: self.scene.bodies[self.scene.contacts[self.contact].first].material.young,
            section: self.length("width", &t.width)?,
            moved_length: self.length("lengths", moved)?,
            fixed_length: self.length("lengths", fixed)?,
            gap: self.units.length * self.source.number("gap", &t.gap, "a gap of 0 or more", |gap| gap >= 0.0)?,
            displacement: self.length("push", &t.push)?,
        })
    }
}

/// The inner and the outer ring of a contact.
pub(super) fn rings(pair: &ContactPair) -> [usize; 2] {
    let second = pair.second.unwrap_or(pair.first);
    if pair.above { [pair.first, second] } else { [second, pair.first] }
}
