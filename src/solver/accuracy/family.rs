//! The same scene on other meshes, and what they say of the mesh's part of a bar.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::accuracy::coarser::{coarser, finer, gentler};
use crate::accuracy::counted::{Kind, Row};
use crate::accuracy::reading::{Reading, of_discrete, recovered, value_of};
use crate::measure::{Measures, Quantity, Stretch, larger, relative_error};
use crate::mesh::Order;
use crate::scene::{BoundaryName, ContactPair, Place, Profile, Scene};
use crate::solve::run::BALANCED;
use crate::solve::{Discretisation, Displaced, Element, Fitted, Formulation, Iteration, Permits, Run, Settings};

/// Part of a number's scale that round-off may leave.
const ROUND_OFF: f64 = 1e-9;
/// How often that may be in a force that statics give.
const STATICS: f64 = 10.0;
/// Imbalance of a body up to which a run whose iteration has converged says something, and how much of it a bar has: the stiffness of a
/// thin ring leaves forces no better than 1e-7 to 1e-5, whatever is iterated.
const UNBALANCED: (f64, f64) = (1e-4, 10.0);
/// Why a bar is not known where more than a little is out of balance.
pub(super) const LOST: &str =
    "round-off takes part of the forces, in cells that are too long and thin, or too stiff: try --fitted";
/// Fewest coarser meshes that say something, and the factor where there is one only (Roache's 3 for two meshes over 1.25).
const FEWEST: (usize, f64) = (2, 2.4);
/// Tolerance of the runs on coarser meshes.
const TOLERANCE: f64 = 1e-9;
/// The same where cells shrink towards a cusp of the pressure: on an axis of revolution round-off leaves a hundred-thousandth of what the smallest
/// rings carry.
const CUSPED: f64 = 1e-4;
/// Length of the edge at such a cusp over that that is counted on: of rⁿ, n from 1.15 to 1.98, peaks are off by a half of their bars.
const SHRUNK: f64 = 4.0;
/// Factor on the distance between two readings of a peak.
const READINGS: f64 = 1.8;
/// Factor on the distance between two series that tell an end; part of the half-width that both may miss with three layers of cells (order 5), and
/// what every further layer leaves of that.
const SERIES: (f64, f64) = (1.0, 2e-6);
const LAYERS: usize = 3;
const LEFT: f64 = 0.1;
/// What a fourth difference at the top of the pressure that is larger by one than that of a smooth top on three elements may hide: of the
/// peak and of the largest shear stress over themselves, of an end and of the second-moment width over an element. Under a gap that points
/// tell, whose curvature may leap, any fourth difference hides something.
const UNDRAWN: [f64; 4] = [0.3, 0.5, 0.8, 0.08];
const SMOOTH: f64 = 0.1;
/// Part of an element that an end within a cell of high order may be off, whatever coarser meshes say (plane powers, orders 5 to 8).
const WITHIN: f64 = 0.5;
/// Part of an element that an end may be off where meshes agree on it: they may read it at a node that they share.
const AT_NODE: f64 = 0.05;
/// Fourth difference from which on a top in the last edge of its stretch is not told, by node elements one edge farther.
const RISES: f64 = 1.0;
/// Largest pressure at a node over the peak that consistent nodal pressures of smooth contacts show: those of corners and middles of
/// 3-node edges differ by 0.5 % on four elements.
const ALTERNATES: f64 = 1.01;
/// On cells of high order that end with the contact: factor on the difference to the next finer mesh, where the gap is smooth and where it is not, of a
/// peak and of what else pressures tell: of an end under a smooth gap that mesh leaves a tenth, under others it may be as far off.
const BY_NEXT: [[f64; 2]; 2] = [[2.0, 4.8], [1.6, 9.6]];
/// Part of the distance between two readings of a peak that is added, and of that between two series for an end that is the least: a gap that is
/// steep at the end (s^8 to s^22 on a parabola) has series that are as far off on the next mesh.
const READ: [f64; 2] = [0.5, 0.5];
/// Where the gap is not smooth, of the relative difference of the half-width what the peak may be off, and of the peak's what an end may be:
/// order by order either agrees by chance.
const ROUGH: [f64; 2] = [2.4, 0.5];
/// Factor on the square of how far an end may be off, over the half-width: 2 tells the error of a half-width, 1/2 that of a peak, since at the
/// end the potential energy is the least; and half of 2 for that of the force, with whose root both grow.
const MISFIT: f64 = 3.0;
/// Factor on the difference to the mesh of gentler growth, on which what far cells leave is a quarter as large.
const FAR: f64 = 1.5;
/// Of the relative bar of a contact's force, the part that it adds to its other numbers: pressures and lengths grow with the root of the
/// force (Hertz).
const FORCE: f64 = 0.5;
/// Factor, of 4-node cells and of others, on what tells a largest von Mises stress, over what tells a largest shear stress inside: it may lie on the surface of a body, where
/// stresses extrapolated to nodes are less accurate.
const SURFACE: [f64; 2] = [3.0, 2.0];
/// Factor on what tells a peak by node elements on 4-node cells around an axis of revolution: the node on the axis has a third of the area of
/// its ring, and of spheres on 3 to 30 elements half of the bars were up to 1.7 times too small without it.
const ON_AXIS: f64 = 2.0;
/// Factor on what tells a peak on an axis of revolution by cells of high order whose dilatation is smoothed: orders 5 and 6 are off by the same
/// 1e-4, by 1.3 to 3.6 of what they tell.
const SMOOTHED: f64 = 4.0;
/// From which multiple of the first body's elements on those of the second hide a part of their own, and the factor on its exponent: what
/// they leave falls faster (half-width, peak and second-moment width of two cylinders, one to four elements of the second on the
/// half-width).
const UNEVEN: f64 = 2.0;
const UNSEEN: f64 = 2.0;
/// Elements are larger on a coarser mesh than by this factor, or it is none.
const LARGER: f64 = 1.1;

/// The coarser meshes of a run.
pub struct Family {
    /// What finds the discrete solution of the run's own contact element, without a penalty.
    pub(super) formulation: Formulation,
    order: Order,
    /// Mean candidate element of each contact.
    pub(super) sizes: Vec<f64>,
    /// The same of its second body.
    others: Vec<f64>,
    /// Ends of the sides that carry a load: body, place, and length of the outermost edge.
    corners: Vec<(usize, [f64; 2], f64)>,
    /// Along which components a body is held where it loses regularity.
    held_at_corner: [bool; 2],
    cells: usize,
    /// Whether mesh lines lie on the ends of the contacts.
    on_ends: bool,
    /// Layers of cells towards those.
    layers: usize,
    /// The gap of each contact. Where it is not smooth, errors fall less from order to order; where points tell it, its curvature may leap.
    profiles: Vec<Profile>,
    /// Whether a body is one element deep below a contact, which no coarser mesh tells from a finer one.
    shallow: bool,
    coarse: Vec<Other>,
    /// What the mesh of gentler growth says, if it does; none where no body bends.
    gentler: Option<Option<Other>>,
    /// What the next finer mesh says, where errors fall from order to order as those of an analytic solution do.
    next: Option<Other>,
    /// Relative error that mesh lines may leave, which do not lie on the ends of the contacts.
    misfit: f64,
    /// What of a peak at s = 0 lies above what the nodes beside it carry, of each contact \[MPa\].
    cusps: Vec<f64>,
    /// Whether each contact begins on the axis of revolution.
    circles: Vec<bool>,
    /// Whether cells of a body of each contact smooth its dilatation.
    smoothed: Vec<bool>,
}

/// What tells the mesh's part of a number, before it is said how far it is counted on.
#[derive(Clone, Copy, Debug)]
pub struct Evidence {
    /// What it is counted on as.
    pub row: Row,
    /// Worst difference to a coarser mesh, `|f₀ − fᵢ| / (rᵢ^q − 1)`.
    pub apart: f64,
    /// What an element is over the contact, `(h/a)^s`, times the scale of the number.
    pub hidden: f64,
    /// What is known otherwise; NaN where no mesh tells.
    pub rest: f64,
}

impl Evidence {
    /// The mesh's part: `F apart + C hidden + rest`.
    pub fn bar(&self) -> f64 {
        let [factor, hidden] = self.row.constants();
        factor * self.apart + hidden * self.hidden + self.rest
    }

    /// Whether meshes find a force otherwise, which statics alone do not give then; round-off of it is relative to a force.
    pub(super) fn is_of_mesh(&self, scale: f64) -> bool {
        self.apart > STATICS * ROUND_OFF * scale.abs()
    }

    /// The same with more that is known otherwise.
    pub(super) fn and(self, more: f64) -> Self {
        Self { rest: self.rest + more, ..self }
    }
}

/// What another mesh says.
struct Other {
    /// Mean candidate element of each contact.
    sizes: Vec<f64>,
    cells: usize,
    dofs: usize,
    readings: Vec<Reading>,
    /// What is left over of the forces on a body.
    imbalance: f64,
}

impl Family {
    /// What coarser meshes say of the numbers that a contact element finds on a mesh, with the settings of a formulation, and of the
    /// displacements that are wanted; without those of the contacts alone.
    pub fn of(discretisation: &Discretisation, formulation: &Formulation, wanted: Option<&[Displaced]>) -> Self {
        Self::permitted(discretisation, formulation, wanted, None, &|_| Ok(()))
    }

    /// The same by meshes that are permitted, and by the next one where that was solved.
    pub(super) fn permitted(
        discretisation: &Discretisation,
        formulation: &Formulation,
        wanted: Option<&[Displaced]>,
        judge: Option<(&Discretisation, &Run)>,
        permits: Permits,
    ) -> Self {
        let formulation = exact(formulation, &discretisation.scene);
        let (scene, resolution) = (&discretisation.scene, discretisation.resolution);
        let on_ends = scene.contacts.iter().any(|pair| !pair.ends.places.is_empty());
        // A mesh too coarse to hold the contact says nothing.
        let said = |(scene, resolution)| {
            let coarse = Discretisation::permitted(scene, resolution, permits).ok()?;
            let run = Run::of(&coarse, &formulation).ok()?;
            said((&coarse, &run), wanted, on_ends)
        };
        let by_next = on_ends && resolution.order >= Order::Quartic && formulation.element == Element::Node;
        let next = match judge {
            Some(judge) => self::said(judge, wanted, on_ends),
            None if by_next => said(finer(scene, resolution)),
            None => None,
        };
        let (gentler, coarse) = rayon::join(
            || gentler(scene, resolution).map(said),
            // Of the contacts alone the next mesh tells all; and of cells of order 4, below which there are 8-node cells only.
            || match (&next, wanted) {
                (Some(_), None) => Vec::new(),
                (Some(_), _) if resolution.order == Order::Quartic => Vec::new(),
                _ => coarser(scene, resolution).into_par_iter().filter_map(said).collect(),
            },
        );
        Self { coarse, gentler, next, ..Self::alone(discretisation, formulation) }
    }

    /// What a finer mesh of those that end with the contact says of the contacts.
    pub(super) fn judged(
        discretisation: &Discretisation,
        formulation: &Formulation,
        finer: (&Discretisation, &Run),
    ) -> Self {
        Self { next: said(finer, None, true), ..Self::alone(discretisation, exact(formulation, &discretisation.scene)) }
    }

    /// The mesh itself, beside no other.
    fn alone(discretisation: &Discretisation, formulation: Formulation) -> Self {
        let scene = &discretisation.scene;
        let contacts = &scene.contacts;
        let on_ends = contacts.iter().any(|pair| !pair.ends.places.is_empty());
        let off = contacts.iter().map(|pair| pair.ends.off).fold(0.0, larger);
        let sizes = sizes(discretisation);
        let order = discretisation.resolution.order;
        let spacings = spacings_at_vertex(discretisation);
        let cusp = |(pair, spacing): (&ContactPair, f64)| scene.modulus_of(pair) * pair.profile.cusp(spacing);
        let cusps = contacts.iter().zip(spacings).map(cusp).collect();
        let corners = corners(discretisation);
        Self {
            formulation,
            order,
            sizes,
            others: others(discretisation),
            held_at_corner: held_at_corner(discretisation, &corners),
            corners,
            cells: discretisation.mesh.cells(),
            on_ends,
            layers: contacts.iter().map(|pair| pair.ends.layers).min().unwrap_or(0),
            profiles: contacts.iter().map(|pair| pair.profile.clone()).collect(),
            shallow: !on_ends && is_shallow(discretisation),
            coarse: Vec::new(),
            gentler: None,
            next: None,
            misfit: MISFIT * off * off,
            cusps,
            circles: (0..contacts.len()).map(|contact| scene.is_around_axis(contact)).collect(),
            smoothed: contacts.iter().map(|pair| pair.bodies().any(|body| discretisation.is_smoothed(body))).collect(),
        }
    }

    /// Whether a run on the same mesh has found what its iteration ends at.
    pub(super) fn is_found(&self, run: &Run) -> bool {
        is_found(run, self.on_ends)
    }

    /// How many of them tell something.
    pub(super) fn meshes(&self) -> usize {
        if self.shallow { 0 } else { self.coarse.len() + usize::from(self.next.is_some()) }
    }

    /// Why they do not tell the mesh's part of a number.
    pub(super) fn why_unknown(&self, quantity: &Quantity, measures: &Measures, run: &Run) -> &'static str {
        let is_largest = matches!(Kind::of(quantity), Kind::Peak | Kind::Shear);
        match () {
            _ if is_largest && self.rises_to_end(measures) => {
                "the pressure rises up to the last element of the contact"
            }
            _ if self.shallow => "a body is one element deep",
            _ if lost_balance(run) > BALANCED => LOST,
            _ if self.meshes() == 0 => "no coarser mesh of this scene holds the contact",
            _ => "no coarser mesh has this number",
        }
    }

    /// Degrees of freedom of all meshes that tell.
    pub(super) fn dofs(&self) -> usize {
        self.coarse.iter().chain(self.gentler.iter().flatten()).chain(&self.next).map(|one| one.dofs).sum()
    }

    /// What tells the mesh's part of a number whose value in the discrete solution is given.
    pub(super) fn told(&self, run: &Run, reading: &Reading, discrete: f64) -> Evidence {
        let far = match &self.gentler {
            Some(Some(gentler)) => {
                FAR * (discrete - value_of(&gentler.readings, reading.contact, &reading.quantity)).abs()
            }
            Some(None) => f64::NAN,
            None => 0.0,
        };
        let own = lost_balance(run);
        let imbalance = self.coarse.iter().map(|other| other.imbalance).fold(own, larger);
        let lost = match reading.quantity {
            _ if imbalance.is_nan() || imbalance > BALANCED => UNBALANCED.1 * imbalance,
            Quantity::Resultant => own,
            _ => 0.0,
        };
        let lost = lost * reading.scale.abs();
        let own = self.of_coarser(run, reading, discrete);
        // What statics give is the same wherever the contact ends.
        let scale = reading.scale.abs();
        let is_of_statics = own.rest <= STATICS * ROUND_OFF * scale;
        let lines = match reading.quantity {
            Quantity::Resultant if self.next.is_some() && !is_of_statics => self.misfit * scale,
            _ => 0.0,
        };
        own.and(far + self.of_force(run, reading, discrete) + lost + lines)
    }

    /// The mesh's part of a number; NaN where no mesh tells.
    pub(super) fn mesh(&self, run: &Run, reading: &Reading, discrete: f64) -> f64 {
        self.told(run, reading, discrete).bar()
    }

    /// What the error of a contact's force leaves in its other numbers: nothing but round-off where statics give it.
    fn of_force(&self, run: &Run, reading: &Reading, discrete: f64) -> f64 {
        let contact = reading.contact;
        let measures = discrete_of(run, contact);
        let size = match reading.quantity {
            Quantity::PeakPressure
            | Quantity::HalfWidth
            | Quantity::SecondMomentWidth
            | Quantity::Shear { .. }
            | Quantity::ShearDepth { .. }
            | Quantity::VonMises { .. } => discrete.abs(),
            Quantity::Begin(_) | Quantity::End(_) => measures.half_width(),
            _ => return 0.0,
        };
        let (quantity, force) = (Quantity::Resultant, measures.resultant);
        if !force.is_normal() {
            return 0.0;
        }
        let bar = self.of_coarser(run, &Reading { contact, quantity, value: force, scale: force }, force).bar();
        FORCE * size * (bar / force).abs()
    }

    /// What coarser meshes say.
    fn of_coarser(&self, run: &Run, reading: &Reading, discrete: f64) -> Evidence {
        let &Reading { contact, ref quantity, .. } = reading;
        let measures = discrete_of(run, contact);
        let ends_at_candidates = fills_candidates(measures);
        let row = Row::of(Kind::of(quantity), self.formulation.element, self.order, ends_at_candidates);
        let along = |other: &Other| other.sizes[contact] / self.sizes[contact];
        // Where all of the mesh counts alike, and not the elements at the end of a contact, cells tell how much coarser it is:
        // one that has one element across a ring has no coarser neighbours in that direction.
        let of_cells = |other: &Other| (self.cells as f64 / other.cells as f64).sqrt();
        let is_held = match quantity {
            Quantity::Displacement(Displaced { component, .. }) => self.held_at_corner[component.index()],
            Quantity::Approach | Quantity::Reaction { .. } => self.held_at_corner == [true; 2],
            _ => false,
        };
        let ratio = |other: &Other| match self.on_ends || !is_held && row.kind != Kind::Force && !ends_at_candidates {
            true => along(other),
            false => along(other).min(of_cells(other)),
        };
        let apart = |other: &Other| [ratio(other), (discrete - value_of(&other.readings, contact, quantity)).abs()];
        let coarser = self.coarse.iter().filter(|other| ratio(other) > LARGER);
        // Where a coarser contact has other stretches, there is nothing to compare.
        let differences: Vec<[f64; 2]> = coarser.map(apart).filter(|[_, apart]| apart.is_finite()).collect();
        let order = match quantity {
            // There errors may be of the first order.
            Quantity::Displacement(Displaced { body, at: Place::Point(at), .. })
                if is_near(&self.corners, *body, *at) =>
            {
                observed(&differences, row.exponent())
            }
            _ if is_held => observed(&differences, row.exponent()),
            _ => row.exponent(),
        };
        let known = match self.next.as_ref().filter(|_| self.order == Order::Quartic) {
            Some(next) => {
                let apart = (discrete - value_of(&next.readings, contact, quantity)).abs();
                Some(apart).filter(|apart| apart.is_finite()).into_iter().collect()
            }
            None => by_order(&differences, order),
        };
        let (fewest, alone) = FEWEST;
        let factor = match known.len() {
            _ if self.shallow => f64::NAN,
            0 => f64::NAN,
            few if few < fewest => alone,
            _ => 1.0,
        };
        let cusp = if row.kind == Kind::Peak { self.cusps[contact] } else { 0.0 };
        if let Some(next) = self.next.as_ref().filter(|_| quantity.is_of_pressures()) {
            let is_rough = !self.profiles[contact].is_smooth(measures.half_width());
            let of_next = |quantity: &Quantity| value_of(&next.readings, contact, quantity);
            let apart = (discrete - of_next(quantity)).abs();
            let factor = BY_NEXT[usize::from(row.kind != Kind::Peak)][usize::from(is_rough)];
            let [of_top, of_end] = READ;
            let read = match row.kind {
                Kind::Peak => of_top * self.missed_by_reading(row.kind, measures),
                Kind::End => larger(of_end * measures.ends_apart - factor * apart, 0.0),
                _ => 0.0,
            };
            let half_width = measures.half_width();
            let of_other = match row.kind {
                Kind::Peak if is_rough => {
                    ROUGH[0] * measures.peak.pressure * relative_error(of_next(&Quantity::HalfWidth), half_width)
                }
                Kind::End if is_rough => {
                    ROUGH[1] * half_width * relative_error(of_next(&Quantity::PeakPressure), measures.peak.pressure)
                }
                _ => 0.0,
            };
            let scale = quantity.scale(measures).abs();
            let misfit = if *quantity == Quantity::Resultant { 0.0 } else { self.misfit };
            let is_top = row.kind == Kind::Peak && self.circles[contact] && self.smoothed[contact];
            let [factor, read] = [factor, read].map(|told| if is_top { SMOOTHED * told } else { told });
            let rest = factor * apart + (misfit + ROUND_OFF) * scale + read + cusp + of_other;
            return Evidence { row, apart: 0.0, hidden: 0.0, rest };
        }
        let [hidden, missed] = match self.on_ends {
            // What statics give is the same wherever the contact ends.
            true if row.kind == Kind::Force && known.iter().all(|apart| *apart <= ROUND_OFF * reading.scale.abs()) => {
                [0.0; 2]
            }
            true => [0.0, Fitted::misfit(self.order)],
            false => {
                let [own, other] = [&self.sizes, &self.others].map(|all| all[contact] / width_of(quantity, measures));
                let of_other = if other > UNEVEN * own { other.powf(UNSEEN * row.power()) } else { 0.0 };
                let swings = if of_other > 0.0 && !ends_at_candidates { self.swings(row.kind) * other } else { 0.0 };
                [own.powf(row.power()) + of_other, swings]
            }
        };
        let [scale, read] = match row.kind {
            Kind::End => [width_of(quantity, measures), self.missed_by_end(measures)],
            // Below a sharp top the shear stress is missed as its pressure is.
            Kind::Shear => [reading.scale, reading.value.abs() * self.above(measures) / measures.peak.pressure],
            kind if quantity.is_of_pressures() => [quantity.scale(measures), self.missed_by_reading(kind, measures)],
            _ => [reading.scale, 0.0],
        };
        let read = read + self.undrawn(reading, measures) + cusp;
        let surface = match quantity {
            Quantity::VonMises { .. } => SURFACE[usize::from(self.order != Order::Linear)],
            Quantity::PeakPressure if self.stands_on_axis(contact) => ON_AXIS,
            _ => 1.0,
        };
        let apart = surface * factor * known.into_iter().fold(0.0, f64::max);
        let hidden = surface * hidden * scale.abs();
        let told = Evidence { row, apart, hidden, rest: (missed + ROUND_OFF) * scale.abs() + read };
        // Meshes that read an end at a node that they share agree by that alone.
        let is_read = row.kind == Kind::End
            && (measures.across || discrete.abs() > 0.0)
            && !self.on_ends
            && !fills_candidates(measures);
        let least = if is_read { AT_NODE * self.sizes[contact] } else { 0.0 };
        told.and(larger(least - told.bar(), 0.0))
    }

    /// Error over the elements of a much coarser second body, on the half-width: pressures swing from one of its nodes to the next.
    /// That is of a disc on a block of a tenth of its modulus, of 0.1 to 0.35 of its elements; of equal moduli far less is left.
    fn swings(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Peak if self.order == Order::Linear => 2.5,
            Kind::Peak => 0.3,
            Kind::End => 1.0,
            _ => 0.0,
        }
    }

    /// What the reading of a number may miss, on this mesh and on all coarser ones alike: of a peak how far two readings of it are apart,
    /// and a point that stands above it, as under a sharp top; of an end that a mesh line tells how far two series are apart. Points of
    /// line and layer elements oscillate and say nothing of a top.
    fn missed_by_reading(&self, kind: Kind, measures: &Measures) -> f64 {
        match kind {
            Kind::Peak => READINGS * (measures.peak_by_parabola - measures.peak.pressure).abs() + self.above(measures),
            Kind::End => self.missed_by_end(measures),
            _ => 0.0,
        }
    }

    /// The same of an end; 0 where no mesh line tells it.
    fn missed_by_end(&self, measures: &Measures) -> f64 {
        let (factor, missed) = SERIES;
        let missed = missed * LEFT.powi(self.layers as i32 - LAYERS as i32);
        if self.on_ends { factor * measures.ends_apart + missed * measures.half_width() } else { 0.0 }
    }

    /// What elements too wide to draw the top hide in a number, on this mesh and on all coarser ones alike; NaN where the pressure rises up
    /// to the end, so that its largest value lies in the last element.
    fn undrawn(&self, &Reading { contact, ref quantity, value, .. }: &Reading, measures: &Measures) -> f64 {
        let kind = Kind::of(quantity);
        if self.on_ends || fills_candidates(measures) {
            return 0.0;
        }
        if self.order > Order::Quadratic {
            return if kind == Kind::End { WITHIN * self.sizes[contact] } else { 0.0 };
        }
        let smooth = if self.profiles[contact].is_by_points() { 0.0 } else { SMOOTH };
        let rough = larger(measures.drawn.rough - smooth, 0.0);
        let [peak, shear, end, width] = UNDRAWN.map(|part| part * rough);
        let rises = if self.rises_to_end(measures) { f64::NAN } else { 0.0 };
        match kind {
            Kind::Peak => peak * measures.peak.pressure + rises,
            Kind::Shear => shear * value.abs() + rises,
            Kind::End => end * self.sizes[contact],
            _ if *quantity == Quantity::SecondMomentWidth => width * self.sizes[contact],
            _ => 0.0,
        }
    }

    /// Whether a linear cell's node on the axis of revolution carries the peak by itself.
    fn stands_on_axis(&self, contact: usize) -> bool {
        self.circles[contact] && self.order == Order::Linear && self.formulation.element == Element::Node
    }

    /// Whether the pressure rises up to the last element of the contact.
    pub(super) fn rises_to_end(&self, measures: &Measures) -> bool {
        let within = if self.formulation.element == Element::Node { 1 } else { 0 };
        let draws = !self.on_ends && self.order <= Order::Quadratic && !fills_candidates(measures);
        draws && measures.drawn.rough > RISES && measures.drawn.from_end <= within
    }

    /// By how much a node stands above the peak, beyond what alternates \[MPa\].
    fn above(&self, measures: &Measures) -> f64 {
        match self.formulation.element {
            Element::Node => (measures.largest.pressure - ALTERNATES * measures.peak.pressure).max(0.0),
            Element::Line | Element::Layer => 0.0,
        }
    }

    /// Whether the peak lies in the last element before the end of the candidates: a corner, and no flat top.
    pub(super) fn is_at_end(&self, run: &Run, contact: usize) -> bool {
        let Measures { peak, stretches, .. } = &run.contacts[contact].measures;
        let near = |end: f64| (peak.position - end).abs() < self.sizes[contact];
        stretches.iter().any(|one| (one.reaches[0] && near(one.begin)) || (one.reaches[1] && near(one.end)))
    }
}

/// Differences to coarser meshes over `r^q − 1` of their ratios r: the error of the mesh, where errors fall with the order q.
fn by_order(differences: &[[f64; 2]], order: f64) -> Vec<f64> {
    differences.iter().map(|[ratio, apart]| apart / (ratio.powf(order) - 1.0)).collect()
}

/// The order, down to the first, on which differences to coarser meshes agree best, where that is below the one counted on.
fn observed(differences: &[[f64; 2]], counted: f64) -> f64 {
    const TRIED: usize = 10;
    let spread = |order: f64| {
        let errors = by_order(differences, order);
        errors.iter().copied().fold(0.0, f64::max) / errors.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let orders = (1..=TRIED).map(|k| counted + (1.0 - counted) * k as f64 / TRIED as f64);
    orders.fold(counted, |best, order| if spread(order) < spread(best) { order } else { best })
}

/// What elements are small beside: of an end half of its own stretch, of the half-width that of the shortest one, of others the
/// second-moment width.
fn width_of(quantity: &Quantity, measures: &Measures) -> f64 {
    let half = |one: &Stretch| if one.begin > 0.0 || measures.across { 0.5 * (one.end - one.begin) } else { one.end };
    let all = measures.stretches.iter();
    match quantity {
        Quantity::Begin(k) | Quantity::End(k) => all.map(half).nth(*k).unwrap_or(f64::NAN),
        Quantity::HalfWidth => all.map(half).reduce(f64::min).unwrap_or(f64::NAN),
        _ => measures.second_moment_width,
    }
}

/// Whether a stretch goes on to its outermost candidate.
fn fills_candidates(measures: &Measures) -> bool {
    measures.stretches.iter().any(|stretch| stretch.reaches.contains(&true))
}

/// The measures of a contact wherever the iteration ended.
pub(super) fn discrete_of(run: &Run, contact: usize) -> &Measures {
    match &run.contacts[contact].exact {
        Some([_, discrete]) => discrete,
        None => &run.contacts[contact].measures,
    }
}

/// Whether the iteration of a run has converged, though round-off may leave more of the balance of a body than a solve accepts: on meshes
/// fitted to the ends of a contact, since others leave more in a body that is as thin than coarser ones tell.
fn is_found(run: &Run, on_ends: bool) -> bool {
    if on_ends { run.is_found(UNBALANCED.0) } else { run.solution.converged() }
}

/// What of a body's balance round-off takes: what the iteration leaves is its own part.
pub(super) fn lost_balance(run: &Run) -> f64 {
    larger(run.imbalance() - run.iteration_error(), 0.0)
}

/// The formulation that finds the discrete solution of a contact element on meshes of a scene, with the settings of another one.
fn exact(formulation: &Formulation, scene: &Scene) -> Formulation {
    let Formulation { element, layer_thickness, settings, .. } = *formulation;
    let has_cusp = scene.contacts.iter().any(|pair| pair.power_at_cusp().is_some());
    let tolerance = if has_cusp { CUSPED } else { TOLERANCE.min(settings.tolerance) };
    let settings = Settings { tolerance, ..Settings::default() };
    Formulation { layer_thickness, settings, ..Formulation::new(element, Iteration::Kinematic) }
}

/// What a run on another mesh says; nothing where it was not found.
fn said((mesh, run): (&Discretisation, &Run), wanted: Option<&[Displaced]>, on_ends: bool) -> Option<Other> {
    if !is_found(run, on_ends) {
        return None;
    }
    let mut readings = of_discrete(mesh, run, 1);
    if let Some(wanted) = wanted {
        readings.extend(recovered(mesh, run, wanted).ok()?.0);
    }
    let (cells, dofs, imbalance) = (mesh.mesh.cells(), run.dofs, run.imbalance());
    Some(Other { sizes: sizes(mesh), cells, dofs, readings, imbalance })
}

/// Whether a body has no more cells than edges on one of the sides that touch.
fn is_shallow(Discretisation { scene, mesh, .. }: &Discretisation) -> bool {
    let is_row = |pair: &ContactPair, body: usize| {
        let edges = mesh.boundary(scene, body, pair.side(body)).map_or(0, <[_]>::len);
        mesh.bodies[body].cells.len() <= edges
    };
    scene.contacts.iter().any(|pair| pair.bodies().any(|body| is_row(pair, body)))
}

/// Along which components a body is held where it loses regularity: on a side that is held in both directions up to where a free one begins, or at
/// a point on the end of a side that carries a load.
fn held_at_corner(discretisation: &Discretisation, corners: &[(usize, [f64; 2], f64)]) -> [bool; 2] {
    let Discretisation { scene, mesh, .. } = discretisation;
    let held = |body: usize, name: &BoundaryName| {
        let own = scene.bodies[body].supports.iter();
        let own = own.filter(|support| matches!(&support.at, Place::Boundary(at) if at == name));
        own.map(|support| 1 << support.component.index()).fold(0, |all: u8, one| all | one)
    };
    let has_corner = |body: usize| {
        let mut at_nodes: BTreeMap<usize, [bool; 2]> = BTreeMap::new();
        for (name, edges) in &mesh.bodies[body].boundaries {
            let kind = match held(body, name) {
                0 => 0,
                3 => 1,
                _ => continue,
            };
            edges.iter().flat_map(|edge| &edge[..2]).for_each(|node| at_nodes.entry(*node).or_default()[kind] = true);
        }
        at_nodes.into_values().any(|[free, fixed]| free && fixed)
    };
    let at_point = |body: usize, k: usize| {
        let own = scene.bodies[body].supports.iter().filter(|support| support.component.index() == k);
        let mut points = own.filter_map(|support| if let Place::Point(at) = support.at { Some(at) } else { None });
        points.any(|at| is_near(corners, body, at))
    };
    [0, 1].map(|k| (0..scene.bodies.len()).any(|body| has_corner(body) || at_point(body, k)))
}

/// Whether a point of a body lies within an edge of one of some corners.
fn is_near(corners: &[(usize, [f64; 2], f64)], body: usize, [x, y]: [f64; 2]) -> bool {
    corners.iter().any(|(of, at, length)| *of == body && (x - at[0]).hypot(y - at[1]) <= *length)
}

/// Mean candidate element of each contact, in its coordinate.
fn sizes(discretisation: &Discretisation) -> Vec<f64> {
    let each = discretisation.interfaces.iter().map(|interface| {
        let nodes = &interface.nodes;
        let [begin, end] = [nodes.first(), nodes.last()].map(|node| node.map_or(f64::NAN, |node| node.coordinate));
        // As wide as the 8-node elements that have as many nodes.
        let wide = discretisation.resolution.order.intervals() as f64 / 2.0;
        (end - begin) / (interface.edges.len() as f64 * wide)
    });
    each.collect()
}

/// About the distance from s = 0 of each contact to the next node, by the candidate edge there, the widest of those that end with it; a
/// part of that edge where cells shrink towards it.
fn spacings_at_vertex(discretisation: &Discretisation) -> Vec<f64> {
    let order = discretisation.resolution.order;
    let of_8_nodes = order.intervals() as f64 / 2.0;
    let from_zero = |[a, b]: &[f64; 2]| if a * b <= 0.0 { 0.0 } else { a.abs().min(b.abs()) };
    let each = discretisation.interfaces.iter().zip(&discretisation.scene.contacts).map(|(interface, pair)| {
        let ends = |edge: &Vec<usize>| [0, 1].map(|end| interface.nodes[edge[end]].coordinate);
        let nearest = interface.edges.iter().map(ends).min_by(|a, b| from_zero(a).total_cmp(&from_zero(b)));
        let part = if pair.power_at_cusp().is_some() { SHRUNK } else { of_8_nodes * f64::from(order.number()) };
        nearest.map_or(f64::NAN, |[a, b]| (b - a).abs() / part)
    });
    each.collect()
}

/// Mean candidate element of the second body of each contact; 0 where that is rigid.
fn others(discretisation: &Discretisation) -> Vec<f64> {
    let of = |(contact, pair): (usize, &ContactPair)| {
        let body = &discretisation.mesh.bodies[pair.second?];
        let own = &body.candidates[body.candidates_of(contact)];
        Some(2.0 * (own.last()?.coordinate - own.first()?.coordinate) / (own.len() as f64 - 1.0))
    };
    discretisation.scene.contacts.iter().enumerate().map(|one| of(one).unwrap_or(0.0)).collect()
}

/// Ends of the sides that carry a load: body, place, and length of the outermost edge.
fn corners(discretisation: &Discretisation) -> Vec<(usize, [f64; 2], f64)> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let mut corners = Vec::new();
    for side in scene.loaded_sides() {
        let Place::Boundary(name) = &side.at else { continue };
        let edges = mesh.boundary(scene, side.body, name).map_or(&[][..], |edges| edges);
        let is_end = |node: usize| edges.iter().filter(|edge| edge[..2].contains(&node)).count() == 1;
        for edge in edges {
            let [a, b] = [edge[0], edge[1]].map(|node| mesh.points[node]);
            let length = (a[0] - b[0]).hypot(a[1] - b[1]);
            let ends = edge[..2].iter().filter(|node| is_end(**node));
            corners.extend(ends.map(|&node| (side.body, mesh.points[node], length)));
        }
    }
    corners
}
