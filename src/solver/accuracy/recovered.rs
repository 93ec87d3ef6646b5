//! Numbers of a run that take the displacement of every node: reactions, displacements, approach, shear stress below a contact, von Mises
//! stress of a body.

use crate::accuracy::reading::Reading;
use crate::error::Error;
use crate::measure::Quantity;
use crate::scene::{ContactPair, Place};
use crate::solve::{Discretisation, Displaced, Reaction, Run, Shear};

/// Part of the largest force that a support at a point may exert: with more, the displacement there has no limit, and with it
/// those of all that it holds.
const AT_POINT: f64 = 1e-6;

/// Shear stresses by contact and body.
type Shears = Vec<([usize; 2], Shear)>;

/// The numbers of a run, displacements of loaded sides and those that are wanted besides; and the shear stresses that some of them are the
/// largest of.
pub(super) fn recovered(
    discretisation: &Discretisation,
    run: &Run,
    wanted: &[Displaced],
) -> Result<(Vec<Reading>, Shears), Error> {
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let reactions = discretisation.reactions_of(run.share(), &displacement)?;
    let pressed = run.contacts.iter().map(|contact| contact.transmitted.abs());
    let force = reactions.iter().map(|reaction| reaction.force.abs()).chain(pressed).fold(0.0, f64::max);
    let is_at_point = |one: &Reaction| {
        let support = &discretisation.scene.bodies[one.body].supports[one.support];
        matches!(support.at, Place::Point(_)) && one.force.abs() > AT_POINT * force
    };
    let has_limit = !reactions.iter().any(is_at_point);
    let of_support = |one: &Reaction| {
        let quantity = Quantity::Reaction { body: one.body, support: one.support };
        Reading { contact: 0, quantity, value: one.force, scale: force }
    };
    let mut readings: Vec<Reading> = reactions.iter().map(of_support).collect();
    if has_limit {
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
