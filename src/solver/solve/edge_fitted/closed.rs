//! The closed stretches of every contact, a mesh with lines on their ends, and how far these shall move; where a
//! contact ends on such a mesh: at the line, moved as the pressures near it ask.
//!
//! Read from pressures alone, as on any mesh, an end is ten times less accurate than the line that was laid on it.

use super::fitted::{Fitted, REMEDY, on_fitted};
use super::tip::Tip;
use super::top;
use crate::algorithm::Exact;
use crate::contact::ContactPoint;
use crate::error::{self, Error};
use crate::measure::stretch::is_at_line;
use crate::measure::{Measures, Stretch, larger};
use crate::mesh::{Order, Resolution};
use crate::scene::{ContactPair, Ends, Grading, Scene, Shape};
use crate::solution::{Part, PointState};
use crate::solve::{Discretisation, Formulation, Permits};

/// Growth, and the coarsest cell over the body, of meshes that know where the contact ends.
const GROWTH: f64 = 4.0;

/// Most that an end moves at once, over the half-width.
const FARTHEST: f64 = 0.5;

/// How far each end shall move outwards, over the half-width of its stretch, and how far two series for it are apart.
pub(super) type Moves = Vec<Vec<[[f64; 2]; 2]>>;

/// The closed stretches of every contact, as far as they are known.
pub(super) struct Closed {
    /// Contact by contact.
    pub(super) stretches: Vec<Vec<Stretch>>,
}

impl Closed {
    /// Refuses a scene without any contact, and contacts that end where their candidates do.
    pub(super) fn refuse(&self, scene: &Scene) -> Result<(), Error> {
        let refused = |contact: usize, message: &str, remedy: String| {
            Err(Error::at(scene.place_of(contact, error::Part::Stretch), message, remedy))
        };
        if self.stretches.iter().all(Vec::is_empty) {
            let message = "no candidate is closed on the first mesh: there is no contact to fit a mesh to";
            return refused(0, message, format!("increase the load, or {REMEDY}"));
        }
        for (contact, all) in self.stretches.iter().enumerate().filter(|(_, all)| !all.is_empty()) {
            if places(all).is_empty() {
                let message =
                    "--fitted cannot be used: the contact ends where its candidates end, and any mesh has a line there";
                let remedy = "widen the candidate stretch where the surfaces go on; give more elements where a corner \
                    is pressed";
                return refused(contact, message, format!("{REMEDY}; {remedy}"));
            }
        }
        Ok(())
    }

    /// Lays ends of two contacts of one body on one line that lie within so many half-widths of one another: a body
    /// through which one force goes has ends that differ by what the mesh leaves, and cells between two lines for them
    /// would be as narrow. So are both ends of one contact below a round body, whose right half has lines on both.
    pub(super) fn join(&mut self, scene: &Scene, near: f64) {
        let pairs = &scene.contacts;
        let is_round = |body: usize| matches!(scene.bodies[body].shape, Shape::Disc { .. } | Shape::Ring { .. });
        for (pair, all) in pairs.iter().zip(&mut self.stretches) {
            if pair.path.has_both_sides() && pair.bodies().any(is_round) {
                mirror(all, near);
            }
        }
        for later in 1..pairs.len() {
            let (known, own) = self.stretches.split_at_mut(later);
            let share = |earlier: &usize| {
                let common = pairs[*earlier].bodies().any(|body| pairs[later].bodies().any(|other| other == body));
                common && pairs[*earlier].path.is_straight() && pairs[later].path.is_straight()
            };
            let places: Vec<f64> = (0..later)
                .filter(share)
                .flat_map(|earlier| {
                    let apart = pairs[earlier].path.origin()[0] - pairs[later].path.origin()[0];
                    places(&known[earlier]).into_iter().map(move |place| place + apart)
                })
                .collect();
            for one in &mut own[0] {
                let within = near * one.half_width();
                for (end, is_fixed) in [(&mut one.begin, one.reaches[0]), (&mut one.end, one.reaches[1])] {
                    let place = places.iter().find(|place| (**place - *end).abs() <= within);
                    *end = place.copied().filter(|_| !is_fixed).unwrap_or(*end);
                }
            }
        }
    }

    /// The scene with mesh lines on the ends, on a mesh that grows fast away from them.
    pub(super) fn discretised(
        &self,
        scene: &Scene,
        mesh: Fitted,
        elements: usize,
        permits: Permits,
    ) -> Result<Discretisation, Error> {
        let mut scene = scene.clone();
        for (pair, stretches) in scene.contacts.iter_mut().zip(&self.stretches) {
            pair.ends = Ends { places: places(stretches), layers: mesh.layers, off: 0.0 };
        }
        scene.grading = Grading { along: GROWTH, depth: GROWTH, first: 1.0, coarsest: 1.0, end: 1.0, ..scene.grading };
        let resolution = Resolution { elements, refinement: 0, order: mesh.order };
        let made = Discretisation::permitted(scene, resolution, permits).map_err(on_fitted)?;
        for (pair, interface) in made.scene.contacts.iter().zip(&made.interfaces) {
            let corners: Vec<f64> = interface.contact_edges().flat_map(|edge| edge.ends).collect();
            let has = |place: f64| corners.iter().any(|corner| (corner - place).abs() <= SAME * pair.stretch);
            if let Some(missed) = pair.ends.places.iter().copied().find(|place| !has(*place)) {
                let place = pair.path.reported(missed);
                let message = format!("no mesh line can be laid on the end of the contact at s = {place}");
                return Err(Error::at(made.scene.place_of(interface.contact, error::Part::Stretch), message, REMEDY));
            }
        }
        Ok(made)
    }

    /// The moves with all points between the ends closed and all others open.
    ///
    /// By node elements, whatever is solved with after: the end is the mesh's, and others have more points than
    /// displacements can follow.
    pub(super) fn moves(&self, made: &Discretisation) -> Result<Moves, Error> {
        let formulation = Formulation::verification();
        let points = made.points(&formulation);
        let problem = made.problem(&formulation, &points);
        let closed: Vec<bool> = points.iter().map(|point| self.holds(point)).collect();
        let refused = |what: &str| Error::at(made.scene.name.as_str(), what.to_string(), REMEDY);
        let iterate = Exact::bilateral(&problem, &closed)
            .ok_or_else(|| refused("the closed stretches do not hold the bodies"))?;
        let at_end = |contact: usize, one: &Stretch, end: f64, inwards: f64| -> Result<[f64; 2], Error> {
            let half_width = one.half_width();
            let own = points.iter().zip(&closed).zip(&iterate.pressure);
            let own = own.filter(|((point, closed), _)| **closed && point.contact == contact);
            let tip = Tip { end, inwards, half_width };
            // Beyond a leap of the curvature the pressure has another series.
            let leaps =
                made.scene.contacts[contact].leaps().into_iter().map(|leap| tip.away(leap)).filter(|d| *d > 0.0);
            let smooth = leaps.fold(half_width, f64::min);
            let forces: Vec<[f64; 2]> = own.map(|((point, _), p)| [point.position, point.weight * p]).collect();
            let moved = tip.moved(&made.interfaces[contact], &forces, smooth);
            moved.map(|[by, apart]| [by.clamp(-FARTHEST, FARTHEST), apart]).ok_or_else(|| {
                let pair = &made.scene.contacts[contact];
                let place = pair.path.reported(end);
                let message = format!(
                    "the end of the contact at s = {place} is not found: the pressure does not fall towards it"
                );
                Error::at(made.scene.place_of(contact, error::Part::Stretch), message, REMEDY)
            })
        };
        let of_stretch = |contact: usize, one: &Stretch| -> Result<[[f64; 2]; 2], Error> {
            let is_fixed = [one.reaches[0] || !one.begins_within(), one.reaches[1]];
            let begin = if is_fixed[0] { [0.0; 2] } else { at_end(contact, one, one.begin, 1.0)? };
            let end = if is_fixed[1] { [0.0; 2] } else { at_end(contact, one, one.end, -1.0)? };
            Ok([begin, end])
        };
        let of_contact =
            |(contact, all): (usize, &Vec<Stretch>)| all.iter().map(|one| of_stretch(contact, one)).collect();
        self.stretches.iter().enumerate().map(of_contact).collect()
    }

    /// Whether a point lies between the ends of a stretch.
    fn holds(&self, point: &ContactPoint) -> bool {
        self.stretches[point.contact].iter().any(|one| {
            let near = SAME * (one.end - one.begin);
            one.begin - near <= point.position && point.position <= one.end + near
        })
    }

    /// Moves every end, given outwards over the half-width of its stretch; none beyond a symmetry line.
    pub(super) fn moved(&mut self, scene: &Scene, moves: &[Vec<[[f64; 2]; 2]>]) {
        for ((pair, stretches), moves) in scene.contacts.iter().zip(&mut self.stretches).zip(moves) {
            let least = if pair.path.has_both_sides() { f64::NEG_INFINITY } else { 0.0 };
            for (one, [[begin, _], [end, _]]) in stretches.iter_mut().zip(moves) {
                let half_width = one.half_width();
                one.begin = (one.begin - begin * half_width).max(least);
                one.end += end * half_width;
                one.on_line = is_at_line(pair, one.begin);
            }
        }
    }
}

/// Puts ends on either side of s = 0 as far from it as one another, where they nearly are.
fn mirror(all: &mut [Stretch], near: f64) {
    for k in 0..all.len() {
        let image = all.len() - 1 - k;
        let [begin, end] = [all[k].begin, all[image].end];
        let is_fixed = all[k].reaches[0] || all[image].reaches[1];
        if !is_fixed && (begin + end).abs() <= near * all[k].half_width() {
            let away = 0.5 * (end - begin);
            (all[k].begin, all[image].end) = (-away, away);
        }
    }
}

/// Difference of contact coordinates, over the width, that rounding explains.
const SAME: f64 = 1e-9;

/// Where stretches end within the candidates, and not on a symmetry line.
pub(super) fn places(stretches: &[Stretch]) -> Vec<f64> {
    let begins = stretches.iter().filter(|one| !one.reaches[0] && one.begins_within()).map(|one| one.begin);
    let ends = stretches.iter().filter(|one| !one.reaches[1]).map(|one| one.end);
    let mut places: Vec<f64> = begins.chain(ends).collect();
    places.sort_by(f64::total_cmp);
    places
}

/// How far two readings of an end are said to be apart, over how far from it a point is astray: of two readings a half
/// is counted at least, and the true end may lie as far as the next point from that one.
const ASTRAY: f64 = 4.0;

/// How far from the nearest end of some stretches a point between is open, [near](NEAR) that end, or one beyond is
/// pressed, but for those on mesh lines: the contact ends elsewhere. Beside a leap of the curvature the pressures of
/// all points between, held closed, may fall towards a line that lies too far out.
pub(super) fn astray(stretches: &[[f64; 2]], lines: &[f64], points: &[PointState]) -> f64 {
    let within = |point: &PointState| {
        let of = |[begin, end]: &[f64; 2]| (point.position - begin).min(end - point.position);
        stretches.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
    };
    let near = |point: &PointState| SAME * point.position.abs();
    // Far inside round-off may open the points of smallest cells, as at a cusp.
    let width = stretches.iter().map(|[begin, end]| end - begin).fold(0.0, f64::max);
    let is_on_line = |point: &PointState| lines.iter().any(|line| (point.position - line).abs() <= near(point));
    let astray = |point: &PointState| match within(point) {
        within if within.abs() <= near(point) || (within > 0.0) == (point.pressure > 0.0) => 0.0,
        within if within > NEAR * width => 0.0,
        within => within.abs(),
    };
    let free = points.iter().filter(|point| point.weight > 0.0 && !is_on_line(point));
    free.map(astray).fold(0.0, f64::max)
}

/// Largest distance between two readings of the ends of some stretches.
pub(super) fn apart(stretches: &[Stretch], moves: &[[[f64; 2]; 2]]) -> f64 {
    let of = |(one, ends): (&Stretch, &[[f64; 2]; 2])| one.half_width() * ends[0][1].max(ends[1][1]);
    stretches.iter().zip(moves).map(of).fold(0.0, f64::max)
}

/// Distance of an end from its line, over the half-width, beyond which it is not the one that the line was laid on.
const NEAR: f64 = 0.1;

/// Puts the ends of all stretches where the lines of their mesh tell them, and reads the largest pressures between;
/// leaves them as they were read where a line, or how far it lies from the end, is not known.
pub(in crate::solve) fn of_lines(discretisation: &Discretisation, measures: &mut [Measures], parts: &[Part]) {
    let pairs = &discretisation.scene.contacts;
    let is_told = discretisation.resolution.order >= Order::Quartic;
    if !is_told || pairs.iter().all(|pair| pair.ends.places.is_empty()) {
        return;
    }
    let on_lines = |(contact, measures): (usize, &Measures)| {
        let places = &pairs[contact].ends.places;
        measures.stretches.iter().map(|one| on_lines(one, places)).collect::<Option<Vec<Stretch>>>()
    };
    let Some(stretches) = measures.iter().enumerate().map(on_lines).collect::<Option<Vec<_>>>() else { return };
    let mut closed = Closed { stretches };
    let Ok(moves) = closed.moves(discretisation) else { return };
    for (interface, part) in discretisation.interfaces.iter().zip(parts) {
        let contact = interface.contact;
        if let [one] = closed.stretches[contact][..]
            && discretisation.scene.is_around_axis(contact)
            && is_of_one_series(&pairs[contact], &one)
        {
            top::read(interface, &one, *part, &mut measures[contact]);
        }
    }
    closed.moved(&discretisation.scene, &moves);
    let each = measures.iter_mut().zip(pairs).zip(closed.stretches).zip(&moves).zip(parts);
    for ((((own, pair), stretches), moves), part) in each {
        let ends: Vec<[f64; 2]> = stretches.iter().map(|one| [one.begin, one.end]).collect();
        own.ends_apart = larger(apart(&stretches, moves), ASTRAY * astray(&ends, &pair.ends.places, part.points));
        own.stretches = stretches;
    }
}

/// Whether a stretch is a circle that ends before its candidates do, under an analytic gap.
fn is_of_one_series(pair: &ContactPair, one: &Stretch) -> bool {
    !one.begins_within() && one.reaches == [false; 2] && pair.profile.is_analytic()
}

/// A stretch whose ends lie on the lines next to them; none where one has no line.
fn on_lines(one: &Stretch, places: &[f64]) -> Option<Stretch> {
    let near = NEAR * (one.end - one.begin);
    let nearest = |end: f64| places.iter().copied().find(|place| (place - end).abs() <= near);
    let begin = if one.reaches[0] || one.on_line { Some(one.begin) } else { nearest(one.begin) };
    let end = if one.reaches[1] { Some(one.end) } else { nearest(one.end) };
    Some(Stretch { begin: begin?, end: end?, ..*one })
}
