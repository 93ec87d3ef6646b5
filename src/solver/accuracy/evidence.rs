//! What the meshes of a family tell of the mesh's part of a bar, number by number.

use crate::accuracy::counted::{Kind, Row};
use crate::accuracy::elements::is_near;
use crate::accuracy::family::{Family, LOST, Other, UNBALANCED, discrete_of, lost_balance};
use crate::accuracy::reading::{Reading, value_of};
use crate::measure::{Measures, Quantity, Stretch, larger, relative_error};
use crate::mesh::Order;
use crate::scene::{Place, Profile};
use crate::solve::run::BALANCED;
use crate::solve::{Displaced, Element, Fitted, Run};

/// Part of a number's scale that round-off may leave.
const ROUND_OFF: f64 = 1e-9;
/// How often that may be in a force that statics give.
const STATICS: f64 = 10.0;
/// Fewest coarser meshes that say something, and the factor where there is one only (Roache's 3 for two meshes over
/// 1.25).
const FEWEST: (usize, f64) = (2, 2.4);
/// Factor on the distance between two readings of a peak.
const READINGS: f64 = 1.8;
/// Factor on the distance between two series that tell an end; part of the half-width that both may miss with three
/// layers of cells (order 5), and what every further layer leaves of that.
const SERIES: (f64, f64) = (1.0, 2e-6);
const LAYERS: usize = 3;
const LEFT: f64 = 0.1;
/// What a fourth difference at the top of the pressure that is larger by one than that of a smooth top on three
/// elements may hide: of the peak and of the largest shear stress over themselves, of an end and of the second-moment
/// width over an element. Under a gap that points tell, whose curvature may leap, any fourth difference hides
/// something.
const UNDRAWN: [f64; 4] = [0.3, 0.5, 0.8, 0.08];
const SMOOTH: f64 = 0.1;
/// Part of an element that an end within a cell of high order may be off, whatever coarser meshes say (plane powers,
/// orders 5 to 8).
const WITHIN: f64 = 0.5;
/// Part of an element that an end may be off where meshes agree on it: they may read it at a node that they share.
const AT_NODE: f64 = 0.05;
/// Fourth difference from which on a top in the last edge of its stretch is not told, by node elements one edge
/// farther.
const RISES: f64 = 1.0;
/// Largest pressure at a node over the peak that consistent nodal pressures of smooth contacts show: those of corners
/// and middles of 3-node edges differ by 0.5 % on four elements.
const ALTERNATES: f64 = 1.01;
/// The same of a point of a line or a layer element on a mesh made elsewhere, whose sides need not match: beyond this
/// means over edges swing with the points, alike on every mesh that it is halved to.
const SWINGS: f64 = 1.15;
/// On cells of high order that end with the contact: factor on the difference to the next finer mesh, where the gap is
/// smooth and where it is not, of a peak and of what else pressures tell: of an end under a smooth gap that mesh leaves
/// a tenth, under others it may be as far off.
const BY_NEXT: [[f64; 2]; 2] = [[2.0, 4.8], [1.6, 9.6]];
/// Part of the distance between two readings of a peak that is added, and of that between two series for an end that is
/// the least: a gap that is steep at the end (s^8 to s^22 on a parabola) has series that are as far off on the next
/// mesh.
const READ: [f64; 2] = [0.5, 0.5];
/// Where the gap is not smooth, of the relative difference of the half-width what the peak may be off, and of the
/// peak's what an end may be: order by order either agrees by chance.
const ROUGH: [f64; 2] = [2.4, 0.5];
/// Factor on the difference to the mesh of gentler growth, on which what far cells leave is a quarter as large, and
/// half as large or more where a side is clamped or interference alone presses.
const FAR: [f64; 2] = [1.5, 3.0];
/// Of the relative bar of a contact's force, the part that it adds to its other numbers: pressures and lengths grow
/// with the root of the force (Hertz).
const FORCE: f64 = 0.5;
/// Factor, of 4-node cells and of others, on what tells a largest von Mises stress, over what tells a largest shear
/// stress inside: it may lie on the surface of a body, where stresses extrapolated to nodes are less accurate.
const SURFACE: [f64; 2] = [3.0, 2.0];
/// Factor on what tells a peak by node elements on 4-node cells around an axis of revolution: the node on the axis has
/// a third of the area of its ring, and of spheres on 3 to 30 elements half of the bars were up to 1.7 times too small
/// without it.
const ON_AXIS: f64 = 2.0;
/// Factor on what tells a peak on an axis of revolution by cells of high order whose dilatation is smoothed: orders 5
/// and 6 are off by the same 1e-4, by 1.3 to 3.6 of what they tell.
const SMOOTHED: f64 = 4.0;
/// From which multiple of the first body's elements on those of the second hide a part of their own, and the factor on
/// its exponent: what they leave falls faster (half-width, peak and second-moment width of two cylinders, one to four
/// elements of the second on the half-width).
const UNEVEN: f64 = 2.0;
const UNSEEN: f64 = 2.0;
/// Depth over width up to which cells made elsewhere count as square.
const SQUARE: f64 = 1.25;
/// Of 4-node cells made elsewhere and of others: of an end what cells that are deeper than wide move it by, over the
/// half-width and the square of their depth over that.
const SUNK: [f64; 2] = [0.25, 0.05];
/// By how much a depth in cells may grow from mesh to mesh and still follow them; and what of a largest stress may be
/// missed then, over the depth of a cell on the half-width: 8-node cells missed 4 to 20 % of that.
const FOLLOWS: [f64; 2] = [1.05, 0.2];
/// Elements are larger on a coarser mesh than by this factor, or it is none.
const LARGER: f64 = 1.1;

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

    /// Whether meshes find a force otherwise, which statics alone do not give then; round-off of it is relative to a
    /// force.
    pub(super) fn is_of_mesh(&self, scale: f64) -> bool {
        self.apart > STATICS * ROUND_OFF * scale.abs()
    }

    /// The same with more that is known otherwise.
    pub(super) fn and(self, more: f64) -> Self {
        Self { rest: self.rest + more, ..self }
    }
}

/// A number that meshes are asked about.
struct Number<'a> {
    /// As the run has it.
    reading: &'a Reading,
    /// Its value in the discrete solution.
    discrete: f64,
    /// What else its contact has there.
    measures: &'a Measures,
    /// What it is counted on as.
    row: Row,
}

impl Family {
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

    /// What tells the mesh's part of a number whose value in the discrete solution is given.
    pub(super) fn told(&self, run: &Run, reading: &Reading, discrete: f64) -> Evidence {
        let far = match &self.gentler {
            Some(Some(gentler)) => {
                let is_slow = self.held_at_corner == [true; 2] || self.profiles.iter().any(Profile::interferes);
                FAR[usize::from(is_slow)]
                    * (discrete - value_of(&gentler.readings, reading.contact, &reading.quantity)).abs()
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
        let own = self.of_meshes(run, reading, discrete);
        // What statics give is the same wherever the contact ends.
        let scale = reading.scale.abs();
        let is_of_statics = own.rest <= STATICS * ROUND_OFF * scale;
        let lines = match reading.quantity {
            Quantity::Resultant if self.next.is_some() && !is_of_statics => self.misfit * scale,
            _ => 0.0,
        };
        own.and(far + self.of_force(run, reading, discrete) + lost + lines)
    }

    /// What a largest stress may be off over itself, at least, on cells made elsewhere: where the depth of the largest
    /// shear stress is no more of them than on the finest of the coarser meshes, it follows them, and the values of two
    /// places may agree.
    pub(super) fn misplaced(&self, run: &Run, contact: usize, place: &Quantity, depth: f64) -> f64 {
        let [most, missed] = FOLLOWS;
        let follows = |other: &Other| {
            depth / self.sizes[contact] <= most * value_of(&other.readings, contact, place) / other.sizes[contact]
        };
        if self.beneath[contact].is_empty() || !self.coarse.first().is_some_and(follows) {
            return 0.0;
        }
        let measures = discrete_of(run, contact);
        missed * self.sizes[contact] * self.deeper(contact, measures) / measures.second_moment_width
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
        let bar = self.of_meshes(run, &Reading { contact, quantity, value: force, scale: force }, force).bar();
        FORCE * size * (bar / force).abs()
    }

    /// What the next mesh says of what pressures tell, and coarser ones of others.
    fn of_meshes(&self, run: &Run, reading: &Reading, discrete: f64) -> Evidence {
        let measures = discrete_of(run, reading.contact);
        let kind = Kind::of(&reading.quantity);
        let row = Row::of(kind, self.formulation.element, self.order, fills_candidates(measures));
        let number = Number { reading, discrete, measures, row };
        let own = match &self.next {
            Some(next) if reading.quantity.is_of_pressures() => self.of_next(next, &number),
            _ => self.of_coarser(&number),
        };
        own.and(larger(self.of_width(run, &number) - own.bar(), 0.0))
    }

    /// What a centre or a moment may be off on meshes that end with the contact, by what its second-moment width may
    /// be: both are moments of one pressure, and a number with a sign agrees by chance from order to order. Nothing
    /// where every mesh has the same, which statics or symmetry give.
    fn of_width(&self, run: &Run, number: &Number) -> f64 {
        let &Number { reading: &Reading { contact, ref quantity, scale, .. }, measures, .. } = number;
        let arm = match quantity {
            Quantity::Centre => 1.0,
            Quantity::Moment => measures.resultant.abs(),
            _ => return 0.0,
        };
        let is_given = self.errors(number).iter().all(|error| *error <= ROUND_OFF * scale.abs());
        if !self.on_ends || is_given {
            return 0.0;
        }
        let (quantity, width) = (Quantity::SecondMomentWidth, measures.second_moment_width);
        let of_width = Reading { contact, quantity, value: width, scale: width };
        arm * (self.of_meshes(run, &of_width, width).bar() + self.of_force(run, &of_width, width))
    }

    /// What the next mesh says: `F |f₀ − f₁|`, with what the reading misses and, where the gap is not smooth, what peak
    /// and half-width say of one another.
    fn of_next(&self, next: &Other, number: &Number) -> Evidence {
        let &Number { reading: &Reading { contact, ref quantity, .. }, discrete, measures, row } = number;
        let of_next = |quantity: &Quantity| value_of(&next.readings, contact, quantity);
        let (peak, half_width) = (measures.peak.pressure, measures.half_width());
        let is_rough = !self.profiles[contact].is_smooth(half_width);
        let apart = (discrete - of_next(quantity)).abs();
        let factor = BY_NEXT[usize::from(row.kind != Kind::Peak)][usize::from(is_rough)];
        let [of_top, of_end] = READ;
        let read = match row.kind {
            Kind::Peak => of_top * self.missed_by_reading(row.kind, measures),
            Kind::End => larger(of_end * measures.ends_apart - factor * apart, 0.0),
            _ => 0.0,
        };
        let of_other = match row.kind {
            Kind::Peak if is_rough => ROUGH[0] * peak * relative_error(of_next(&Quantity::HalfWidth), half_width),
            Kind::End if is_rough => ROUGH[1] * half_width * relative_error(of_next(&Quantity::PeakPressure), peak),
            _ => 0.0,
        };
        let scale = quantity.scale(measures).abs();
        let misfit = if *quantity == Quantity::Resultant { 0.0 } else { self.misfit };
        let is_top = row.kind == Kind::Peak && self.circles[contact] && self.smoothed[contact];
        let [factor, read] = [factor, read].map(|told| if is_top { SMOOTHED * told } else { told });
        let rest = factor * apart + (misfit + ROUND_OFF) * scale + read + self.cusp(number) + of_other;
        Evidence { row, apart: 0.0, hidden: 0.0, rest }
    }

    /// What coarser meshes say.
    fn of_coarser(&self, number: &Number) -> Evidence {
        let &Number { reading: reading @ &Reading { contact, ref quantity, .. }, discrete, measures, row } = number;
        let errors = self.errors(number);
        let (fewest, alone) = FEWEST;
        let factor = match errors.len() {
            _ if self.shallow => f64::NAN,
            0 => f64::NAN,
            few if few < fewest => alone,
            _ => 1.0,
        };
        let [hidden, missed] = self.hidden(number, &errors);
        let [scale, read] = match row.kind {
            // Where the contact goes on by pressures that do not count as such, every mesh has its end where they begin
            // to.
            Kind::End => [width_of(quantity, measures), self.missed_by_end(measures) + measures.faint],
            // Below a sharp top the shear stress is missed as its pressure is.
            Kind::Shear => [reading.scale, reading.value.abs() * self.above(measures) / measures.peak.pressure],
            kind if quantity.is_of_pressures() => [quantity.scale(measures), self.missed_by_reading(kind, measures)],
            _ => [reading.scale, 0.0],
        };
        let read = read + self.undrawn(reading, measures) + self.cusp(number);
        let surface = match quantity {
            Quantity::VonMises { .. } => SURFACE[usize::from(self.order != Order::Linear)],
            Quantity::PeakPressure if self.stands_on_axis(contact) => ON_AXIS,
            _ => 1.0,
        };
        let apart = surface * factor * errors.into_iter().fold(0.0, f64::max);
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

    /// The error of a number by every mesh that tells it, `|f₀ − fᵢ| / (rᵢ^q − 1)`; of cells of order 4, below which
    /// there are 8-node cells only, the distance to the next mesh.
    fn errors(&self, number: &Number) -> Vec<f64> {
        let &Number { reading: &Reading { contact, ref quantity, .. }, discrete, measures, row } = number;
        // Where a contact has other stretches there, there is nothing to compare.
        let apart = |other: &Other| {
            Some((discrete - value_of(&other.readings, contact, quantity)).abs()).filter(|apart| apart.is_finite())
        };
        if let Some(next) = self.next.as_ref().filter(|_| self.order == Order::Quartic) {
            return apart(next).into_iter().collect();
        }
        let is_held = match quantity {
            Quantity::Displacement(Displaced { component, .. }) => self.held_at_corner[component.index()],
            Quantity::Approach | Quantity::Reaction { .. } => self.held_at_corner == [true; 2],
            _ => false,
        };
        // Where all of the mesh counts alike, and not the elements at the end of a contact, cells tell how much coarser
        // it is: one that has one element across a ring has no coarser neighbours in that direction.
        let is_of_contact = self.on_ends || !is_held && row.kind != Kind::Force && !fills_candidates(measures);
        let ratio = |other: &Other| {
            let along = other.sizes[contact] / self.sizes[contact];
            let of_cells = (self.cells as f64 / other.cells as f64).sqrt();
            if is_of_contact { along } else { along.min(of_cells) }
        };
        let coarser = self.coarse.iter().filter(|other| ratio(other) > LARGER);
        let differences: Vec<[f64; 2]> = coarser.filter_map(|other| Some([ratio(other), apart(other)?])).collect();
        let order = match quantity {
            // There errors may be of the first order.
            Quantity::Displacement(Displaced { body, at: Place::Point(at), .. })
                if is_near(&self.corners, *body, *at) =>
            {
                observed(&differences, row.exponent())
            }
            // What a corner of a held side leaves in a contact falls as slowly, once that is more than what its ends
            // leave.
            _ if is_held || self.held_at_corner == [true; 2] => observed(&differences, row.exponent()),
            _ => row.exponent(),
        };
        by_order(&differences, order)
    }

    /// What the end of a contact may hide, as it lies somewhere within an element of each mesh, `(h/a)^s`, and what is
    /// missed besides, both over the scale of the number.
    fn hidden(&self, number: &Number, errors: &[f64]) -> [f64; 2] {
        let &Number { reading: &Reading { contact, ref quantity, scale, .. }, measures, row, .. } = number;
        match self.on_ends {
            // What statics give is the same wherever the contact ends.
            true if row.kind == Kind::Force && errors.iter().all(|error| *error <= ROUND_OFF * scale.abs()) => [0.0; 2],
            true => [0.0, Fitted::misfit(self.order)],
            false => {
                let [own, other] = [&self.sizes, &self.others].map(|all| all[contact] / width_of(quantity, measures));
                let spacings = if self.order == Order::Linear { 2.0 } else { 1.0 };
                let is_uneven = other > spacings * UNEVEN * own;
                let of_other = if is_uneven { other.powf(UNSEEN * row.power()) } else { 0.0 };
                let swings = of_other > 0.0 && !fills_candidates(measures);
                let swings = if swings { self.swings(row.kind) * other } else { 0.0 };
                let deep = own * self.deeper(contact, measures);
                let sunk = SUNK[usize::from(self.order != Order::Linear)] * (deep * deep - own * own);
                let (own, missed) = match row.kind {
                    Kind::End => (own, swings + sunk),
                    Kind::Peak | Kind::Shear => (deep, swings),
                    Kind::Moment if *quantity == Quantity::SecondMomentWidth => (deep, swings),
                    _ => (own, swings),
                };
                [own.powf(row.power()) + of_other, missed]
            }
        }
    }

    /// By how much the deepest cell made elsewhere below a contact is deeper than wide; 1 where none is.
    fn deeper(&self, contact: usize, measures: &Measures) -> f64 {
        let is_closed = |from: f64, to: f64| measures.stretches.iter().any(|one| one.begin < to && from < one.end);
        let below = self.beneath[contact].iter().filter(|([from, to], _)| is_closed(*from, *to));
        let deeper = below.map(|([from, to], deep)| deep / larger(to - from, self.sizes[contact]));
        deeper.filter(|deeper| *deeper > SQUARE).fold(1.0, f64::max)
    }

    /// What of a peak at s = 0 lies above what the nodes beside it carry.
    fn cusp(&self, number: &Number) -> f64 {
        if number.row.kind == Kind::Peak { self.cusps[number.reading.contact] } else { 0.0 }
    }

    /// Error over the elements of a much coarser second body, on the half-width: pressures swing from one of its nodes
    /// to the next. That is of a disc on a block of a tenth of its modulus, of 0.1 to 0.35 of its elements; of equal
    /// moduli far less is left.
    fn swings(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Peak if self.order == Order::Linear => 2.5,
            Kind::Peak => 0.3,
            Kind::End => 1.0,
            _ => 0.0,
        }
    }

    /// What the reading of a number may miss, on this mesh and on all coarser ones alike: of a peak how far two
    /// readings of it are apart, and a point that stands above it, as under a sharp top; of an end that a mesh line
    /// tells how far two series are apart.
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

    /// What elements too wide to draw the top hide in a number, on this mesh and on all coarser ones alike; NaN where
    /// the pressure rises up to the end, so that its largest value lies in the last element.
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
        let usual = match self.formulation.element {
            Element::Node => ALTERNATES,
            _ if self.given => SWINGS,
            _ => f64::INFINITY,
        };
        (measures.largest.pressure - usual * measures.peak.pressure).max(0.0)
    }

    /// Whether the peak lies in the last element before the end of the candidates: a corner, and no flat top.
    pub(super) fn is_at_end(&self, run: &Run, contact: usize) -> bool {
        let Measures { peak, stretches, .. } = &run.contacts[contact].measures;
        let near = |end: f64| (peak.position - end).abs() < self.sizes[contact];
        stretches.iter().any(|one| (one.reaches[0] && near(one.begin)) || (one.reaches[1] && near(one.end)))
    }
}

/// Differences to coarser meshes over `r^q − 1` of their ratios r: the error of the mesh, where errors fall with the
/// order q.
fn by_order(differences: &[[f64; 2]], order: f64) -> Vec<f64> {
    differences.iter().map(|[ratio, apart]| apart / (ratio.powf(order) - 1.0)).collect()
}

/// The order, down to the first, on which differences to coarser meshes agree best, where that is below the one counted
/// on.
fn observed(differences: &[[f64; 2]], counted: f64) -> f64 {
    const TRIED: usize = 10;
    let spread = |order: f64| {
        let errors = by_order(differences, order);
        errors.iter().copied().fold(0.0, f64::max) / errors.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let orders = (1..=TRIED).map(|k| counted + (1.0 - counted) * k as f64 / TRIED as f64);
    orders.fold(counted, |best, order| if spread(order) < spread(best) { order } else { best })
}

/// What elements are small beside: of an end half of its own stretch, of the half-width that of the shortest one, of
/// others the second-moment width.
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
