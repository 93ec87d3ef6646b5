//! Meshes fitted to the contact: mesh lines on the ends of every closed stretch, with layers of cells towards them.
//!
//! The solution is analytic but for the square root in which the pressure ends. On a mesh that ends a cell there, cells of high
//! order see nothing of it: the error falls with the order as if it were not there. Where the contact ends is found on the way: all points up to an expected end
//! are closed, and the pressure there tells how far off that is (`root`). The error of peak and width is of second order in it.
//!
//! * `root` — where a contact ends, from its pressures near an expected end.

mod root;

use crate::algorithm::Exact;
use crate::contact::ContactPoint;
use crate::error::{Error, Part};
use crate::measure::Stretch;
use crate::mesh::{Order, Resolution};
use crate::scene::{Ends, Grading, Scene};
use crate::solve::{Discretisation, Formulation, Run};

/// Cells and layers of a fitted mesh.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Fitted {
    /// Element order.
    pub order: Order,
    /// Layers of cells towards each end.
    pub layers: usize,
}

/// A mesh on which an end was sought.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Tried {
    /// Its order.
    pub order: Order,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Cells.
    pub cells: usize,
    /// Largest move of an end that it asked for, over the half-width; NaN for the first mesh, which knows of no end.
    pub moved: f64,
}

/// An answer on a fitted mesh.
#[derive(Debug)]
pub struct Answer {
    /// The mesh, assembled and condensed.
    pub discretisation: Discretisation,
    /// The solution with its contact conditions, and its measures.
    pub run: Run,
    /// Where every stretch begins and ends, contact by contact: on the last mesh, and moved as that asks.
    pub stretches: Vec<Vec<[f64; 2]>>,
    /// All meshes, in the order in which they were solved.
    pub tried: Vec<Tried>,
}

/// Mesh that finds about where the contact is: 8-node cells, so many on the grading's unit of length.
const FIRST: Resolution = Resolution { elements: 3, refinement: 0, order: Order::Quadratic };
/// Growth, and the coarsest cell over the body, of meshes that know where the contact ends.
const GROWTH: f64 = 2.0;
/// Mesh on which its ends are sought first.
const COARSE: Fitted = Fitted { order: Order::Quartic, layers: 1 };
/// Move of an end, over the half-width, from which on the last mesh is worth while.
const NEAR: f64 = 2e-2;
/// Most meshes of each kind.
const MESHES: usize = 5;

impl Fitted {
    /// For so many digits of peak and half-width: order `digits + 2`; a layer up to four digits, one more for each beyond.
    pub fn of_digits(digits: usize) -> Self {
        let order = Order::numbered(digits + 2).unwrap_or(if digits < 4 { Order::Quartic } else { Order::Octic });
        Self { order, layers: digits.saturating_sub(3).clamp(1, 3) }
    }

    /// Move of an end, over the half-width, that no longer matters.
    fn at_rest(self) -> f64 {
        (0.5 * Self::misfit(self.order)).sqrt()
    }

    /// Relative error that ends at rest may leave on cells of an order, half a unit of its last digit.
    ///
    /// An end that is off by δ half-widths makes errors of `δ²/2` in the peak and `2δ²` in the half-width: at the end the
    /// potential energy is the least, and both are of second order.
    pub fn misfit(order: Order) -> f64 {
        0.5 * 10f64.powi(2 - i32::from(order.number()))
    }

    /// Solves a scene on such a mesh, whose ends are found on the way.
    pub fn solve(self, scene: &Scene, formulation: &Formulation) -> Result<Answer, Error> {
        let made = Discretisation::of(scene.clone(), FIRST)?;
        let first = Run::of(&made, formulation)?;
        let cells = made.mesh.cells();
        let mut tried = vec![Tried { order: FIRST.order, dofs: first.dofs, cells, moved: f64::NAN }];
        let found = |contact: &crate::solve::run::Contact| contact.measures.stretches.clone();
        let mut ends = Closed { stretches: first.contacts.iter().map(found).collect() };
        ends.refuse_none(scene)?;
        for (mesh, enough) in [(COARSE, NEAR), (self, self.at_rest())] {
            let last = mesh == self;
            for _ in 0..MESHES {
                let discretisation = ends.discretised(scene, mesh)?;
                let moves = ends.moves(&discretisation, formulation)?;
                let moved = moves.iter().flatten().flatten().fold(0.0_f64, |most, delta| most.max(delta.abs()));
                let (dofs, cells) = (discretisation.system.dofs(), discretisation.mesh.cells());
                tried.push(Tried { order: mesh.order, dofs, cells, moved });
                let resting = moved <= enough;
                if last && resting {
                    let run = Run::of(&discretisation, formulation)?;
                    ends.moved(&moves);
                    let stretches = ends.stretches.iter();
                    let stretches = stretches.map(|all| all.iter().map(|one| [one.begin, one.end]).collect()).collect();
                    return Ok(Answer { discretisation, run, stretches, tried });
                }
                ends.moved(&moves);
                if resting {
                    break;
                }
            }
        }
        let moved = tried.last().map_or(f64::NAN, |last| last.moved);
        Err(Error::at(
            scene.name.as_str(),
            format!("the ends of the contact still move by {moved:.1e} half-widths after {MESHES} meshes"),
            "solve it on a mesh that is not fitted",
        ))
    }
}

/// The closed stretches of every contact, as far as they are known.
struct Closed {
    stretches: Vec<Vec<Stretch>>,
}

impl Closed {
    /// Refuses contacts that do not touch.
    fn refuse_none(&self, scene: &Scene) -> Result<(), Error> {
        match self.stretches.iter().position(Vec::is_empty) {
            None => Ok(()),
            Some(contact) => Err(Error::at(
                scene.place_of(contact, Part::Stretch),
                "no candidate is closed on the first mesh: there is no contact to fit a mesh to",
                "increase the load, or solve it on a mesh that is not fitted",
            )),
        }
    }

    /// The scene with mesh lines on the ends, on a mesh that grows fast away from them.
    fn discretised(&self, scene: &Scene, mesh: Fitted) -> Result<Discretisation, Error> {
        let mut scene = scene.clone();
        for (pair, stretches) in scene.contacts.iter_mut().zip(&self.stretches) {
            let begins = stretches.iter().filter(|one| !one.reaches[0] && begins_within(one)).map(|one| one.begin);
            let ends = stretches.iter().filter(|one| !one.reaches[1]).map(|one| one.end);
            let mut places: Vec<f64> = begins.chain(ends).collect();
            places.sort_by(f64::total_cmp);
            pair.ends = Ends { places, layers: mesh.layers };
        }
        scene.grading = Grading { along: GROWTH, depth: GROWTH, first: 1.0, coarsest: 1.0, end: 1.0, ..scene.grading };
        let made = Discretisation::of(scene, Resolution { elements: 1, refinement: 0, order: mesh.order })?;
        for (pair, interface) in made.scene.contacts.iter().zip(&made.interfaces) {
            let corners: Vec<f64> = interface.contact_edges().flat_map(|edge| edge.ends).collect();
            let has = |place: f64| corners.iter().any(|corner| (corner - place).abs() <= SAME * pair.stretch);
            if let Some(missed) = pair.ends.places.iter().copied().find(|place| !has(*place)) {
                let place = pair.path.reported(missed);
                let message = format!("no mesh line can be laid on the end of the contact at s = {place}");
                let remedy = "solve it on a mesh that is not fitted: bodies with one contact, discs with one that is symmetric, can be";
                return Err(Error::at(made.scene.place_of(interface.contact, Part::Stretch), message, remedy));
            }
        }
        Ok(made)
    }

    /// How far each end shall move outwards, with all points between the ends closed and all others open.
    fn moves(&self, made: &Discretisation, formulation: &Formulation) -> Result<Vec<Vec<[f64; 2]>>, Error> {
        let points = made.points(formulation);
        let problem = made.problem(formulation, &points);
        let closed: Vec<bool> = points.iter().map(|point| self.holds(point)).collect();
        let refused =
            |what: &str| Error::at(made.scene.name.as_str(), what.to_string(), "solve it on a mesh that is not fitted");
        let iterate = Exact::bilateral(&problem, &closed)
            .ok_or_else(|| refused("the closed stretches do not hold the bodies"))?;
        let at_end = |contact: usize, one: &Stretch, end: f64, inwards: f64| -> Result<f64, Error> {
            let half_width = if begins_within(one) { 0.5 * (one.end - one.begin) } else { one.end };
            let own = points.iter().zip(&closed).zip(&iterate.pressure);
            let own = own.filter(|((point, closed), _)| **closed && point.contact == contact);
            let near: Vec<[f64; 2]> = own.map(|((point, _), p)| [(point.position - end) * inwards, *p]).collect();
            let moved = root::beyond(&near, half_width);
            let moved = moved.ok_or_else(|| refused("the pressure does not fall towards an end of the contact"))?;
            Ok(moved / half_width)
        };
        let of_stretch = |contact: usize, one: &Stretch| -> Result<[f64; 2], Error> {
            let begin = if one.reaches[0] || !begins_within(one) { 0.0 } else { at_end(contact, one, one.begin, 1.0)? };
            let end = if one.reaches[1] { 0.0 } else { at_end(contact, one, one.end, -1.0)? };
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

    /// Moves every end, given outwards over the half-width of its stretch.
    fn moved(&mut self, moves: &[Vec<[f64; 2]>]) {
        for (one, [begin, end]) in self.stretches.iter_mut().flatten().zip(moves.iter().flatten()) {
            let half_width = if begins_within(one) { 0.5 * (one.end - one.begin) } else { one.end };
            one.begin -= begin * half_width;
            one.end += end * half_width;
        }
    }
}

/// Difference of contact coordinates, over the width, that rounding explains.
const SAME: f64 = 1e-9;

/// Whether a stretch begins at an end of its own, and not on a symmetry line.
fn begins_within(one: &Stretch) -> bool {
    one.begin.abs() > SAME * one.end.abs()
}
