//! Where a contact ends on a mesh that has lines there: at the line, moved as the pressures near it ask.
//!
//! Read from pressures alone, as on any mesh, an end is ten times less accurate than the line that was laid on it, on cells of order 5 and
//! more: on those of order 4 the series near the end is as rough.

use super::closed::{Closed, apart};
use crate::measure::{Measures, Stretch};
use crate::mesh::Order;
use crate::solve::Discretisation;

/// Distance of an end from its line, over the half-width, beyond which it is not the one that the line was laid on.
const NEAR: f64 = 0.1;

/// Puts the ends of all stretches where the lines of their mesh tell them; leaves them as they were read where a line, or how far it
/// lies from the end, is not known.
pub(in crate::solve) fn of_lines(discretisation: &Discretisation, measures: &mut [&mut Measures]) {
    let pairs = &discretisation.scene.contacts;
    let is_told = discretisation.resolution.order > Order::Quartic;
    if !is_told || pairs.iter().all(|pair| pair.ends.places.is_empty()) {
        return;
    }
    let on_lines = |(contact, measures): (usize, &&mut Measures)| {
        let places = &pairs[contact].ends.places;
        measures.stretches.iter().map(|one| on_lines(one, places)).collect::<Option<Vec<Stretch>>>()
    };
    let Some(stretches) = measures.iter().enumerate().map(on_lines).collect::<Option<Vec<_>>>() else { return };
    let mut closed = Closed { stretches };
    let Ok(moves) = closed.moves(discretisation) else { return };
    closed.moved(&discretisation.scene, &moves);
    for ((own, stretches), moves) in measures.iter_mut().zip(closed.stretches).zip(&moves) {
        own.ends_apart = apart(&stretches, moves);
        own.stretches = stretches;
    }
}

/// A stretch whose ends lie on the lines next to them; none where one has no line.
fn on_lines(one: &Stretch, places: &[f64]) -> Option<Stretch> {
    let near = NEAR * (one.end - one.begin);
    let nearest = |end: f64| places.iter().copied().find(|place| (place - end).abs() <= near);
    let on_symmetry_line = one.begin.abs() <= f64::EPSILON * one.end.abs();
    let begin = if one.reaches[0] || on_symmetry_line { Some(one.begin) } else { nearest(one.begin) };
    let end = if one.reaches[1] { Some(one.end) } else { nearest(one.end) };
    Some(Stretch { begin: begin?, end: end?, reaches: one.reaches })
}
