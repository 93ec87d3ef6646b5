//! The number one quotes: its name, its unit, and what the measures of a contact say of it.

use std::borrow::Cow;

use crate::measure::Measures;
use crate::scene::{ContactPair, Displaced};

/// A number that one quotes of a contact, or of a body or a support beside it.
///
/// Places and widths lie along the contact: they are lengths on a straight path \[mm\] and angles on an arc \[rad\].
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// Largest pressure of the profile \[MPa\].
    PeakPressure,
    /// Where it lies.
    PeakPlace,
    /// Half-width: half of what lies between where the contact begins and ends.
    HalfWidth,
    /// Second-moment width `2 √(∫p (s − c)² / ∫p)`; on arcs the same functional of the angle.
    SecondMomentWidth,
    /// Centre of pressure of a contact on both sides of s = 0.
    Centre,
    /// Where a closed stretch begins.
    Begin(usize),
    /// Where it ends.
    End(usize),
    /// Force on the whole contact along the load line \[N\], positive in compression.
    Resultant,
    /// Moment of the pressures about s = 0, of a straight contact on both sides of it \[N mm\].
    Moment,
    /// Force across the load line, of one half of a contact on an arc \[N\].
    Across,
    /// Contact pressure \[MPa\], positive in compression.
    Pressure {
        /// Contact coordinate.
        at: f64,
    },
    /// Circumferential stress of the secondary body's contact side \[MPa\], tension positive.
    HoopStress {
        /// Angle from the load line \[rad\].
        at: f64,
    },
    /// The same of the primary body, such as the pin in a hole \[MPa\].
    PinHoopStress {
        /// Angle from the load line \[rad\].
        at: f64,
    },
    /// Force of a support \[N\].
    Reaction {
        /// Index of the body.
        body: usize,
        /// Index of the support among those of the body.
        support: usize,
    },
    /// Displacement of a side, as its mean, or of a point \[mm\].
    Displacement(Displaced),
    /// Approach of the bodies of the contact, positive where they have come nearer \[mm\].
    Approach,
    /// Largest in-plane shear stress below the contact \[MPa\].
    Shear {
        /// Index of the body.
        body: usize,
    },
    /// Its depth below the surface \[mm\].
    ShearDepth {
        /// Index of the body.
        body: usize,
    },
    /// Largest von Mises stress of a body \[MPa\].
    VonMises {
        /// Index of the body.
        body: usize,
    },
}

/// The unit of a place or a width: of a length on a straight path, of an angle on an arc.
const ALONG: &str = "along the contact";

impl Quantity {
    /// Name in scene files and results, noun phrase, and unit.
    const fn told(&self) -> [&'static str; 3] {
        const ACROSS: &str = "force across the load, of one half";
        match self {
            Self::PeakPressure => ["peak-pressure", "peak pressure", "MPa"],
            Self::PeakPlace => ["peak-place", "place of the peak pressure", ALONG],
            Self::HalfWidth => ["half-width", "half-width", ALONG],
            Self::SecondMomentWidth => ["second-moment-width", "second-moment width", ALONG],
            Self::Centre => ["centre", "centre of pressure", ALONG],
            Self::Begin(_) => ["begin", "begin of the contact", ALONG],
            Self::End(_) => ["end", "end of the contact", ALONG],
            Self::Resultant => ["resultant", "contact resultant", "N"],
            Self::Moment => ["moment", "moment of the pressures", "N mm"],
            Self::Across => [ACROSS, ACROSS, "N"],
            Self::Pressure { .. } => ["pressure", "contact pressure", "MPa"],
            Self::HoopStress { .. } => ["hoop-stress", "hoop stress", "MPa"],
            Self::PinHoopStress { .. } => ["pin-hoop-stress", "hoop stress of the pin", "MPa"],
            Self::Reaction { .. } => ["reaction", "reaction", "N"],
            Self::Displacement(_) => ["displacement", "displacement", "mm"],
            Self::Approach => ["approach", "approach", "mm"],
            Self::Shear { .. } => ["shear", "largest shear stress below the contact", "MPa"],
            Self::ShearDepth { .. } => ["shear-depth", "depth of the largest shear stress", "mm"],
            Self::VonMises { .. } => ["von-mises", "largest von Mises stress", "MPa"],
        }
    }

    /// Name in scene files and results, a pressure's with its place.
    pub fn key(&self) -> Cow<'static, str> {
        match self {
            Self::Pressure { at } => format!("pressure at s = {at}").into(),
            _ => self.told()[0].into(),
        }
    }

    /// The noun phrase, without the place; on an arc a half-width is an angle.
    pub fn name(&self, on_arc: bool) -> &'static str {
        if on_arc && *self == Self::HalfWidth { "half-angle" } else { self.told()[1] }
    }

    /// The unit that it is shown in, and the factor from ours to that: angles are shown in degrees.
    pub fn unit(&self, on_arc: bool) -> (&'static str, f64) {
        match self.told()[2] {
            ALONG if on_arc => ("°", 1f64.to_degrees()),
            ALONG => ("mm", 1.0),
            unit => (unit, 1.0),
        }
    }

    /// Whether the pressures of a contact tell it, without displacements.
    pub fn is_of_pressures(&self) -> bool {
        use Quantity::{Begin, Centre, End, HalfWidth, Moment, PeakPlace, PeakPressure, Resultant, SecondMomentWidth};
        matches!(self, PeakPressure | PeakPlace | HalfWidth | SecondMomentWidth | Centre | Begin(_) | End(_))
            || matches!(self, Resultant | Moment)
    }

    /// The number by which closed forms and checks know it: a contact that is symmetric about s = 0 ends at its
    /// half-width.
    pub fn known_by(&self, pair: &ContactPair) -> &Self {
        match self {
            Self::End(_) if !pair.path.has_both_sides() => &Self::HalfWidth,
            own => own,
        }
    }

    /// Whether closed forms in the plane give it per unit thickness.
    pub fn grows_with_thickness(&self) -> bool {
        matches!(self, Self::Resultant | Self::Moment | Self::Across | Self::Reaction { .. })
    }

    /// Its value in the measures of a contact; NaN where there is no such stretch, and of what pressures do not tell.
    pub fn of(&self, measures: &Measures) -> f64 {
        let stretch = |k: usize| measures.stretches.get(k);
        match *self {
            Self::PeakPressure => measures.peak.pressure,
            Self::PeakPlace => measures.peak.position,
            Self::HalfWidth => measures.half_width(),
            Self::SecondMomentWidth => measures.second_moment_width,
            Self::Centre => measures.centre,
            Self::Begin(k) => stretch(k).map_or(f64::NAN, |stretch| stretch.begin),
            Self::End(k) => stretch(k).map_or(f64::NAN, |stretch| stretch.end),
            Self::Resultant => measures.resultant,
            Self::Moment => measures.resultant * measures.centre,
            _ => f64::NAN,
        }
    }

    /// What measures tell of a contact: what a symmetry line fixes is none of it.
    pub fn all(pair: &ContactPair, measures: &Measures) -> Vec<Self> {
        let across = pair.path.has_both_sides();
        let mut all =
            vec![Self::PeakPressure, Self::PeakPlace, Self::HalfWidth, Self::SecondMomentWidth, Self::Resultant];
        if across {
            all.push(Self::Centre);
        }
        if across && pair.path.is_straight() {
            all.push(Self::Moment);
        }
        for (k, stretch) in measures.stretches.iter().enumerate() {
            if across || stretch.begin > 0.0 {
                all.push(Self::Begin(k));
            }
            all.push(Self::End(k));
        }
        all
    }
}
