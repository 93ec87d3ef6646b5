//! The error bar of an answer: what mesh, iteration and penalty may leave in each number.
//!
//! The mesh's part comes from the same scene on coarser meshes of the same family. With the finest value f₀ and those
//! of meshes of the sizes `rᵢ h`,
//!
//! `u = F max |f₀ − fᵢ| / (rᵢ^q − 1) + C (h/a)^s + D`,
//!
//! where `counted` has the constants of each kind of number, and with it what the growth leaves where a body bends, and
//! what the error of its force leaves in the other numbers of a contact (`evidence`). It takes the worst of four
//! neighbours instead of extrapolating: the end of a contact lies at another place of its element on each mesh, and two
//! of them may agree by accident. A series that oscillates or has not begun to converge makes it wider. On cells of
//! order 4 to 8 that end with the contact errors fall from order to order, and the next finer mesh tells them:
//! `u = F |f₀ − f₁| + D`, F of a peak and of what else pressures tell, under smooth gaps and others, being
//! `evidence::BY_NEXT`. Where a maximum lies is known no better than how high it is: it may be wherever the pressure
//! comes near it.
//!
//! The parts of iteration and penalty are differences to the solution of the same discrete problem, which is exact.

use crate::accuracy::evidence::Evidence;
use crate::accuracy::family::{Family, LOST, discrete_of, lost_balance};
use crate::accuracy::longest::longest;
use crate::accuracy::reading::{self, Reading, of_discrete, recovered, value_of};
use crate::accuracy::watch::up_to;
use crate::algorithm::StiffnessRule;
use crate::error::Error;
use crate::measure::{Measures, Quantity, larger};
use crate::scene::Scene;
use crate::solution::PointState;
use crate::solve::run::BALANCED;
use crate::solve::{Change, Discretisation, Displaced, Element, Formulation, Run};

/// Part of the bar of a largest value within which those elsewhere may be the true one: their errors are alike.
const FLAT: f64 = 0.5;
/// Penetration between points, over the approach of the contact, from which on coarser meshes tell nothing of a peak
/// beside a point that carries more: 7 % hid half of a peak.
const DEEP: f64 = 0.05;
/// Part of the largest displacement, and of the largest force, that may lie between two runs which are one: a tenth of
/// what a bar leaves for round-off.
const SAME: f64 = 1e-10;

/// Mean pressure of the outermost edge over that of the edge before, from which on a contact goes on to the end of its
/// candidates: one that ends there or before as `√(a − s)` has `1/(2^{3/2} − 1) = 0.55` at most.
const GOES_ON: f64 = 0.8;

/// Why a bar is not known.
const NOT_FOUND: &str = "the discrete solution was not found";
const TOO_WIDE: &str = "the bar would be larger than the number itself";
const PASSED_OVER: &str =
    "surfaces penetrate one another between points, one of which carries more than the peak: refine the mesh";
const AT_POINT: &str = "a support at a point takes a part that vanishes as the mesh is refined: hold a side instead";
const TORN: &str = "two supports prescribe unlike displacements of one node, which takes forces without limit: let \
    them agree where they meet";

/// How far a number may be from the truth of the scene.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Bar {
    /// For the mesh is not infinitely fine; NaN where it is not known.
    pub mesh: f64,
    /// For the iteration ended; NaN where the discrete solution was not found.
    pub iteration: f64,
    /// For springs of the rule `penalty` are not rigid.
    pub penalty: f64,
}

impl Bar {
    /// All of it; NaN where a part is not known.
    pub fn total(&self) -> f64 {
        self.mesh + self.iteration + self.penalty
    }
}

/// A number with its bar.
#[derive(Clone, Debug)]
pub struct Barred {
    /// Index of the contact that it is of; 0 of reactions and displacements.
    pub contact: usize,
    /// What was measured.
    pub quantity: Quantity,
    /// Its value; NaN for a peak without a limit.
    pub value: f64,
    /// How far it may be off.
    pub bar: Bar,
    /// Why that is not known; none where it is.
    pub unknown: Option<&'static str>,
    /// What tells the mesh's part; none of what is prescribed, nor of an end where the candidates end.
    pub told: Option<Evidence>,
}

/// The bars of all numbers of a run.
#[derive(Clone, Debug)]
pub struct Bars {
    /// Contact by contact, then support by support, displacements, and shear stresses.
    pub all: Vec<Barred>,
    /// Coarser meshes that tell something.
    pub meshes: usize,
    /// Degrees of freedom of all of them.
    pub dofs: usize,
}

impl Barred {
    /// A number as the iteration left it, the mesh's part of its bar, and its value where the iteration should end, and
    /// in the discrete solution.
    fn of(
        reading: &Reading,
        (told, mesh): (Option<Evidence>, f64),
        [ended, discrete]: [f64; 2],
        (run, family): (&Run, &Family),
    ) -> Self {
        let measures = discrete_of(run, reading.contact);
        let bar = Bar { mesh, iteration: (reading.value - ended).abs(), penalty: (ended - discrete).abs() };
        let Reading { contact, quantity, value, .. } = reading.clone();
        let one = Self { contact, quantity, value, bar, unknown: None, told };
        match () {
            _ if (bar.iteration + bar.penalty).is_nan() => {
                Self { unknown: Some(if lost_balance(run) > BALANCED { LOST } else { NOT_FOUND }), ..one }
            }
            _ if mesh.is_nan() => Self { unknown: Some(family.why_unknown(&reading.quantity, measures, run)), ..one },
            // It says nothing.
            _ if bar.total() > reading.size() => {
                Self { unknown: Some(TOO_WIDE), bar: Bar { mesh: f64::NAN, ..bar }, ..one }
            }
            _ if reading.quantity == Quantity::PeakPressure && passes_over(run, reading.contact) => {
                Self { unknown: Some(PASSED_OVER), bar: Bar { mesh: f64::NAN, ..bar }, ..one }
            }
            _ => one,
        }
    }

    /// Whether it depends on what a support at a point takes.
    pub(super) fn is_at_point(&self) -> bool {
        self.unknown == Some(AT_POINT)
    }

    /// Leaves it unknown for that.
    pub(super) fn yields(&mut self) {
        (self.unknown, self.told, self.bar.mesh) = (Some(AT_POINT), None, f64::NAN);
    }

    /// Whether it is of this number of this contact.
    pub fn is_of(&self, contact: usize, quantity: &Quantity) -> bool {
        self.contact == contact && self.quantity == *quantity
    }

    /// Takes the mesh's part from what is known of the same number on the same mesh.
    pub(super) fn take_mesh_of(&mut self, known: &[Self]) {
        let Some(known) = known.iter().find(|one| one.is_of(self.contact, &self.quantity)) else { return };
        (self.bar.mesh, self.told) = (known.bar.mesh, known.told);
        if self.unknown != Some(NOT_FOUND) {
            self.unknown = known.unknown;
        }
    }

    /// The bar over the value; NaN where it is not known.
    pub fn relative(&self) -> f64 {
        (self.bar.total() / self.value).abs()
    }
}

impl Bars {
    /// The bar of a number; none where it has none.
    pub fn of(&self, contact: usize, quantity: &Quantity) -> Option<Bar> {
        self.all.iter().find(|one| one.is_of(contact, quantity)).map(|one| one.bar)
    }

    /// The same where a search has estimated some of the numbers by a mesh of its own; an end that is the half-width
    /// has its bar.
    pub fn estimated(mut self, estimates: &[Barred]) -> Self {
        for one in &mut self.all {
            let of = |quantity: &Quantity| estimates.iter().find(|other| other.is_of(one.contact, quantity));
            let half_width = of(&Quantity::HalfWidth).filter(|half| half.value.to_bits() == one.value.to_bits());
            let same = if matches!(one.quantity, Quantity::End(_)) { half_width } else { None };
            if let Some(estimate) = of(&one.quantity).or(same) {
                *one = Barred { quantity: one.quantity.clone(), ..estimate.clone() };
            }
        }
        self
    }
}

/// The bars of a run on its mesh; displacements are those of loaded sides, and what is wanted besides.
pub fn bars(discretisation: &Discretisation, run: &Run, wanted: &[Displaced]) -> Result<Bars, Error> {
    bars_up_to(None, None, discretisation, run, wanted)
}

/// The same by meshes of so many dofs at most, and by a finer one where that was solved.
pub fn bars_up_to(
    most_dofs: Option<usize>,
    judge: Option<(&Discretisation, &Run)>,
    discretisation: &Discretisation,
    run: &Run,
    wanted: &[Displaced],
) -> Result<Bars, Error> {
    let family = Family::permitted(discretisation, &run.formulation, Some(wanted), judge, &up_to(most_dofs));
    let all = of_family(discretisation, run, &family, Some(wanted))?;
    Ok(Bars { all, meshes: family.meshes(), dofs: family.dofs() })
}

/// The bars of what pressures alone tell, by a finer mesh of those that end with the contact.
pub(super) fn judged(discretisation: &Discretisation, run: &Run, finer: (&Discretisation, &Run)) -> Vec<Barred> {
    of_pressures(discretisation, run, &Family::judged(discretisation, &run.formulation, finer))
}

/// The same given what coarser meshes say; of the contacts alone where no displacements are wanted, which need another
/// solution.
pub fn of_family(
    discretisation: &Discretisation,
    run: &Run,
    family: &Family,
    wanted: Option<&[Displaced]>,
) -> Result<Vec<Barred>, Error> {
    let mut all = of_pressures(discretisation, run, family);
    if let Some(wanted) = wanted {
        all.extend(of_displacements(discretisation, run, family, wanted)?);
        yield_at_points(&discretisation.scene, &mut all);
    }
    Ok(all)
}

/// Whether a mesh is too coarse for the gap where the contact presses most.
fn passes_over(run: &Run, contact: usize) -> bool {
    let deep = DEEP * run.solution.contacts[contact].approach;
    let mut unseen = run.solution.unseen.get(contact).into_iter().flatten();
    run.stands_out(contact) && unseen.any(|one| one.is_candidate && one.penetration > deep)
}

/// Bar of a contact's force over that, up to which what a point takes of it has settled: it vanishes by the logarithm
/// of the elements alone, which on meshes within reach is no more than that.
const SETTLED: f64 = 0.01;

/// Leaves numbers unknown of contacts that share their force with a support at a point, whose part vanishes as the mesh
/// is refined: those of the body that it holds, and of others that touch this one, directly or through others.
fn yield_at_points(scene: &Scene, all: &mut [Barred]) {
    let is_reaction = |one: &Barred| matches!(one.quantity, Quantity::Reaction { .. });
    let held = all.iter().filter(|one| one.is_at_point()).filter_map(|one| match one.quantity {
        Quantity::Reaction { body, .. } => Some(body),
        _ => None,
    });
    let mut reached: Vec<usize> = held.collect();
    for _ in &scene.contacts {
        let touching = scene.contacts.iter().filter(|pair| pair.bodies().any(|body| reached.contains(&body)));
        let more: Vec<usize> = touching.flat_map(|pair| pair.bodies()).collect();
        reached.extend(more);
        reached.sort_unstable();
        reached.dedup();
    }
    let touches = |contact: usize| scene.contacts[contact].bodies().any(|body| reached.contains(&body));
    let is_shared = |one: &&Barred| {
        one.quantity == Quantity::Resultant && touches(one.contact) && one.bar.mesh > SETTLED * one.value.abs()
    };
    let contacts: Vec<usize> = all.iter().filter(is_shared).map(|one| one.contact).collect();
    for one in all.iter_mut().filter(|one| !is_reaction(one) && contacts.contains(&one.contact)) {
        one.yields();
    }
}

/// Numbers of the contacts.
pub(super) fn of_pressures(discretisation: &Discretisation, run: &Run, family: &Family) -> Vec<Barred> {
    let measured: Vec<&Measures> = run.contacts.iter().map(|contact| &contact.measures).collect();
    let [target, rigid] = [0, 1].map(|k| of_discrete(discretisation, run, k));
    let readings = reading::of_contacts(discretisation, &measured);
    let flat = |contact: usize| {
        let peak = readings.iter().find(|one| one.contact == contact && one.quantity == Quantity::PeakPressure);
        let discrete = value_of(&rigid, contact, &Quantity::PeakPressure);
        peak.map_or(f64::NAN, |peak| farthest(run, contact, family.mesh(run, peak, discrete)))
    };
    let one = |reading: &Reading| {
        let Reading { contact, quantity, .. } = reading;
        let contact = *contact;
        let [ended, discrete] = [&target, &rigid].map(|readings| value_of(readings, contact, quantity));
        let told = family.told(run, reading, discrete);
        let told = match quantity {
            Quantity::PeakPlace if family.rises_to_end(discrete_of(run, contact)) => {
                told.and(2.0 * family.sizes[contact])
            }
            // A pressed corner without limit has its peak there.
            Quantity::PeakPlace if family.is_at_end(run, contact) && run.contacts[contact].unbounded.is_some() => told,
            Quantity::PeakPlace => told.and(flat(contact)),
            _ => told,
        };
        let (told, mesh) = match of_candidates(&discretisation.scene, run, contact, quantity, &family.sizes) {
            None => (Some(told), told.bar()),
            Some(0.0) => (None, 0.0),
            Some(least) => (None, larger(told.bar(), least)),
        };
        let barred = Barred::of(reading, (told, mesh), [ended, discrete], (run, family));
        let value = if run.is_unbounded(contact, quantity) { f64::NAN } else { reading.value };
        Barred { value, ..barred }
    };
    readings.iter().map(one).collect()
}

/// How far the peak is from the outermost end of an edge, or from a point, whose pressure comes near it; and where
/// between that and the next point the parabola through the peak still does, since a cell may be wider than the top.
fn farthest(run: &Run, contact: usize, bar: f64) -> f64 {
    if bar.is_nan() {
        return f64::NAN;
    }
    let part = run.solution.part(contact);
    let peak = &run.contacts[contact].measures.peak;
    let away = |s: f64| (s - peak.position).abs();
    let near = part.edges.iter().filter(|edge| edge.pressure >= peak.pressure - FLAT * bar);
    let of_edges = near.flat_map(|edge| edge.ends).map(away).fold(0.0, f64::max);
    if run.formulation.element != Element::Node {
        return of_edges;
    }
    let of_point = |point: &PointState| match peak.pressure - point.pressure {
        below if below <= FLAT * bar => away(point.position),
        below => away(point.position) * (FLAT * bar / below).sqrt(),
    };
    part.points.iter().map(of_point).fold(of_edges, f64::max)
}

/// Numbers of the displacements, whose discrete solutions are solved for: what is recorded of those has none.
fn of_displacements(
    discretisation: &Discretisation,
    run: &Run,
    family: &Family,
    wanted: &[Displaced],
) -> Result<Vec<Barred>, Error> {
    let (readings, shears) = recovered(discretisation, run, wanted)?;
    let of = |formulation: &Formulation| -> Result<Vec<Reading>, Error> {
        match Run::from(Some(&run.solution), discretisation, formulation, Change::NONE) {
            Ok(other) if family.is_found(&other) && is_same(&other, run) => Ok(readings.clone()),
            Ok(other) if family.is_found(&other) => Ok(recovered(discretisation, &other, wanted)?.0),
            // Not found: its numbers are unknown.
            _ => Ok(Vec::new()),
        }
    };
    let rigid = of(&family.formulation)?;
    let target = match run.formulation.rule {
        StiffnessRule::Penalty => {
            of(&Formulation { settings: family.formulation.settings, ..run.formulation.clone() })?
        }
        _ => rigid.clone(),
    };
    let flat = |contact: usize, body: usize| {
        let stress = readings.iter().find(|one| one.contact == contact && one.quantity == Quantity::Shear { body });
        let bar = stress.map_or(f64::NAN, |one| family.mesh(run, one, value_of(&rigid, contact, &one.quantity)));
        let shear = shears.iter().find(|(of, _)| *of == [contact, body]);
        shear.map_or(f64::NAN, |(_, shear)| shear.farthest(FLAT * bar))
    };
    let scene = &discretisation.scene;
    let is_prescribed = |reading: &Reading| match &reading.quantity {
        Quantity::Displacement(side) => scene.prescribes(side),
        Quantity::Approach => {
            let sides = scene.pressed_sides(reading.contact).unwrap_or_default();
            !sides.is_empty() && sides.iter().all(|side| scene.prescribes(side))
        }
        _ => false,
    };
    let yields = |body: usize| readings.iter().any(|one| one.is_force_at_point(scene, body));
    let torn = (0..scene.bodies.len()).map(|body| discretisation.torn(body));
    let torn = torn.collect::<Result<Vec<[bool; 2]>, Error>>()?;
    let is_torn = |body: usize, support: usize| torn[body][scene.bodies[body].supports[support].component.index()];
    let one = |reading: &Reading| {
        let Reading { contact, quantity, .. } = reading;
        if is_prescribed(reading) {
            return Barred::of(reading, (None, 0.0), [reading.value; 2], (run, family));
        }
        let [ended, discrete] = [&target, &rigid].map(|readings| value_of(readings, *contact, quantity));
        let told = family.told(run, reading, discrete);
        let told = match quantity {
            Quantity::ShearDepth { body } => told.and(flat(*contact, *body)),
            Quantity::Shear { body } | Quantity::VonMises { body } => {
                let place = Quantity::ShearDepth { body: *body };
                let least = family.misplaced(run, *contact, &place, value_of(&rigid, *contact, &place));
                told.and(larger(least * discrete.abs() - told.bar(), 0.0))
            }
            _ => told,
        };
        let is_shared = |body: usize| told.is_of_mesh(reading.scale) && yields(body);
        let without_limit = match quantity {
            Quantity::Reaction { body, support } if is_torn(*body, *support) => Some(TORN),
            Quantity::VonMises { body } if torn[*body].contains(&true) => Some(TORN),
            Quantity::Reaction { body, .. } if is_shared(*body) => Some(AT_POINT),
            _ => None,
        };
        match without_limit {
            Some(_) => Barred {
                unknown: without_limit,
                ..Barred::of(reading, (None, f64::NAN), [ended, discrete], (run, family))
            },
            None => Barred::of(reading, (Some(told), told.bar()), [ended, discrete], (run, family)),
        }
    };
    Ok(readings.iter().map(one).collect())
}

/// Whether two runs on a mesh are apart by round-off only.
fn is_same(one: &Run, other: &Run) -> bool {
    let near = |a: &[f64], b: &[f64]| {
        let largest = a.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * largest)
    };
    let (own, theirs) = (&one.solution, &other.solution);
    (one.share() - other.share()).abs() <= SAME
        && near(&own.displacement, &theirs.displacement)
        && near(&own.contact_force, &theirs.contact_force)
}

/// Within what an end of a contact lies, whatever coarser meshes say; none where they tell.
///
/// A contact that goes on to its outermost candidate ends there. Only where its pressure falls towards that, it may end
/// anywhere within the last element; where it does not, though the surfaces go on, that is not known.
fn of_candidates(scene: &Scene, run: &Run, contact: usize, quantity: &Quantity, sizes: &[f64]) -> Option<f64> {
    let edges = run.solution.part(contact).edges;
    let falls = |side: usize| match edges {
        [first, second, ..] if side == 0 => first.pressure < GOES_ON * second.pressure,
        [.., before, last] if side == 1 => last.pressure < GOES_ON * before.pressure,
        _ => true,
    };
    let pair = &scene.contacts[contact];
    let goes_on = pair.stretch < longest(scene, pair) * (1.0 - SAME);
    let stretches = &run.contacts[contact].measures.stretches;
    let within = |k: usize, side: usize| {
        let reaches = stretches.get(k).is_some_and(|one| one.reaches[side]);
        reaches.then(|| match falls(side) {
            true => 0.5 * sizes[contact],
            false if goes_on => f64::NAN,
            false => 0.0,
        })
    };
    match quantity {
        Quantity::Begin(k) => within(*k, 0),
        Quantity::End(k) => within(*k, 1),
        Quantity::HalfWidth => {
            let end = within(stretches.len().checked_sub(1)?, 1)?;
            let begins = run.contacts[contact].measures.across || stretches.first()?.begins_within();
            let begin = if begins { within(0, 0)? } else { end };
            Some(0.5 * (begin + end))
        }
        _ => None,
    }
}

/// How one number is told.
pub struct Told {
    /// The contact, or the body.
    pub of: String,
    /// What it is.
    pub quantity: String,
    /// The unit it is shown in.
    pub unit: &'static str,
    /// From its unit to the one it is shown in.
    pub factor: f64,
}

impl Told {
    /// A number of a run on a scene.
    pub fn of(scene: &Scene, run: &Run, one: &Barred) -> Self {
        let pair = &scene.contacts[one.contact];
        let (unit, factor) = one.quantity.unit(!pair.path.is_straight());
        let key = one.quantity.key();
        let below = |what: &str| match scene.contacts.len() {
            1 => what.to_owned(),
            _ => format!("{what} below {}", pair.name),
        };
        let of_body = |body: usize| scene.bodies[body].name.clone();
        let (of, quantity) = match &one.quantity {
            Quantity::Reaction { body, support } => {
                let support = &scene.bodies[*body].supports[*support];
                (of_body(*body), format!("{key} at {}, {}", support.at, support.component))
            }
            Quantity::Displacement(Displaced { body, at, component }) => {
                (of_body(*body), format!("{key} at {at}, {component}"))
            }
            Quantity::Shear { body } => (of_body(*body), below("largest shear")),
            Quantity::ShearDepth { body } => (of_body(*body), below("depth of largest shear")),
            Quantity::VonMises { body } => (of_body(*body), "largest von Mises".into()),
            Quantity::Begin(k) | Quantity::End(k) if run.contacts[one.contact].measures.stretches.len() > 1 => {
                (pair.name.clone(), format!("{key} of stretch {}", k + 1))
            }
            _ => (pair.name.clone(), key.into_owned()),
        };
        Self { of, quantity, unit, factor }
    }
}
