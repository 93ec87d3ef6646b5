//! The numbers that are quoted of a run, each with the scale of its round-off: those that pressures tell, and those
//! that take the displacement of every node, as reactions, displacements, approach, shear stress below a contact and
//! von Mises stress of a body do.

use crate::error::Error;
use crate::measure::{Measures, Quantity};
use crate::scene::{ContactPair, Place, Scene};
use crate::solve::{Discretisation, Displaced, Reaction, Run, Shear};

/// A number, and the size that round-off of it is judged by.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Index of the contact that it is of; 0 of reactions and displacements.
    pub contact: usize,
    /// What is measured.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// What its round-off is relative to.
    pub scale: f64,
}

impl Reading {
    /// What its bar must stay below to say anything: the number itself; of what may vanish, as ends, centres, moments,
    /// reactions and displacements do, its scale. Where a maximum lies is told within whatever it may be: where values
    /// come near the largest.
    pub(super) fn size(&self) -> f64 {
        use Quantity::{HalfWidth, PeakPlace, PeakPressure, Resultant, SecondMomentWidth, Shear, ShearDepth, VonMises};
        match self.quantity {
            PeakPressure | HalfWidth | SecondMomentWidth | Resultant | Shear { .. } | VonMises { .. } => {
                self.value.abs()
            }
            PeakPlace | ShearDepth { .. } => f64::INFINITY,
            _ => self.scale.abs(),
        }
    }

    /// Whether it is a force that a support of a body exerts at a point, where the displacement has no limit.
    pub(super) fn is_force_at_point(&self, scene: &Scene, body: usize) -> bool {
        let Quantity::Reaction { body: own, support } = self.quantity else { return false };
        let at = &scene.bodies[own].supports[support].at;
        own == body && matches!(at, Place::Point(_)) && self.value.abs() > AT_POINT * self.scale
    }
}

/// Part of the largest force that a support at a point may exert: with more, the displacement there has no limit, and
/// with it those of all that it holds.
const AT_POINT: f64 = 1e-6;

impl Quantity {
    /// Those that an accuracy may be asked for.
    pub const ASKED: [Self; 2] = [Self::PeakPressure, Self::HalfWidth];

    /// What round-off of a number of the pressures is relative to.
    pub(super) fn scale(&self, measures: &Measures) -> f64 {
        match self {
            Self::PeakPressure => measures.peak.pressure,
            Self::Resultant => measures.resultant,
            Self::Moment => measures.resultant * measures.second_moment_width,
            _ => measures.second_moment_width,
        }
    }
}

/// The numbers of some measures, contact by contact.
pub fn of_contacts(discretisation: &Discretisation, measures: &[&Measures]) -> Vec<Reading> {
    let pairs = discretisation.scene.contacts.iter().zip(measures).enumerate();
    let of = |(contact, (pair, measures)): (usize, (&ContactPair, &&Measures))| {
        let one = |quantity: Quantity| {
            let (value, scale) = (quantity.of(measures), quantity.scale(measures));
            Reading { contact, quantity, value, scale }
        };
        Quantity::all(pair, measures).into_iter().map(one).collect::<Vec<_>>()
    };
    pairs.flat_map(of).collect()
}

/// Numbers of what the iteration shall end in, or of the discrete solution.
pub(super) fn of_discrete(discretisation: &Discretisation, run: &Run, which: usize) -> Vec<Reading> {
    let measures = run.contacts.iter().map(|contact| contact.exact.as_ref().map(|exact| &exact[which]));
    measures.collect::<Option<Vec<_>>>().map_or_else(Vec::new, |measures| of_contacts(discretisation, &measures))
}

/// The value of a number among some; NaN where it is none of them.
pub(super) fn value_of(readings: &[Reading], contact: usize, quantity: &Quantity) -> f64 {
    let found = readings.iter().find(|one| one.contact == contact && one.quantity == *quantity);
    found.map_or(f64::NAN, |one| one.value)
}

/// Shear stresses by contact and body.
type Shears = Vec<([usize; 2], Shear)>;

/// The numbers of a run, displacements of loaded sides and those that are wanted besides; and the shear stresses that
/// some of them are the largest of.
pub(super) fn recovered(
    discretisation: &Discretisation,
    run: &Run,
    wanted: &[Displaced],
) -> Result<(Vec<Reading>, Shears), Error> {
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let reactions = discretisation.reactions_of(run.share(), &displacement)?;
    let pressed = run.contacts.iter().map(|contact| contact.transmitted.abs());
    let force = reactions.iter().map(|reaction| reaction.force.abs()).chain(pressed).fold(0.0, f64::max);
    let of_support = |one: &Reaction| {
        let quantity = Quantity::Reaction { body: one.body, support: one.support };
        Reading { contact: 0, quantity, value: one.force, scale: force }
    };
    let mut readings: Vec<Reading> = reactions.iter().map(of_support).collect();
    let scene = &discretisation.scene;
    let yields = |body: usize| readings.iter().any(|one| one.is_force_at_point(scene, body));
    if !(0..scene.bodies.len()).any(yields) {
        readings.extend(displacements(discretisation, &displacement, wanted)?);
    }
    let shears = shears(discretisation, run, &displacement)?;
    for &([contact, body], ref shear) in &shears {
        let measures = &run.contacts[contact].measures;
        let width = measures.second_moment_width * discretisation.scene.contacts[contact].path.metric();
        let [stress, depth] = [Quantity::Shear { body }, Quantity::ShearDepth { body }];
        readings.push(Reading { contact, quantity: stress, value: shear.stress, scale: measures.peak.pressure });
        readings.push(Reading { contact, quantity: depth, value: shear.depth, scale: width });
    }
    for stress in discretisation.largest_von_mises(run, &displacement)? {
        let body = stress.body;
        // Elements and peak are those of the first contact that it takes part in.
        let takes_part = |pair: &ContactPair| pair.bodies().any(|own| own == body);
        let contact = discretisation.scene.contacts.iter().position(takes_part).unwrap_or(0);
        let scale = run.contacts[contact].measures.peak.pressure;
        let reading = |value: f64| Reading { contact, quantity: Quantity::VonMises { body }, value, scale };
        readings.extend(stress.largest.map(|largest| reading(largest.stress)));
    }
    Ok((readings, shears))
}

/// Those of loaded sides, those wanted, and the approach of every contact that has one.
fn displacements(
    discretisation: &Discretisation,
    displacement: &[[f64; 2]],
    wanted: &[Displaced],
) -> Result<Vec<Reading>, Error> {
    let scene = &discretisation.scene;
    let scale = displacement.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let mut sides = scene.loaded_sides();
    sides.extend(wanted.iter().filter(|side| !sides.contains(side)).cloned().collect::<Vec<_>>());
    let mut readings = Vec::new();
    for side in sides {
        let value = discretisation.displaced(displacement, &side)?;
        readings.push(Reading { contact: 0, quantity: Quantity::Displacement(side), value, scale });
    }
    for contact in 0..scene.contacts.len() {
        let approach = discretisation.approach(displacement, contact)?;
        readings.extend(approach.map(|value| Reading { contact, quantity: Quantity::Approach, value, scale }));
    }
    Ok(readings)
}

/// The largest shear stress below every contact whose peak has a limit, in each of its bodies that has one.
fn shears(discretisation: &Discretisation, run: &Run, displacement: &[[f64; 2]]) -> Result<Shears, Error> {
    let mut all = Vec::new();
    for (contact, pair) in discretisation.scene.contacts.iter().enumerate() {
        let found = &run.contacts[contact];
        for body in pair.bodies().filter(|_| found.unbounded.is_none()) {
            let shear = discretisation.shear_below(displacement, &found.measures, [contact, body])?;
            all.extend(shear.map(|shear| ([contact, body], shear)));
        }
    }
    Ok(all)
}
