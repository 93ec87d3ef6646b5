//! The error bar of an answer: what mesh, iteration and penalty may leave in each number.
//!
//! The mesh's part comes from the same scene on coarser meshes of the same family. With the finest value f₀ and those of meshes
//! of the sizes `rᵢ h`,
//!
//! `u = F max |f₀ − fᵢ| / (rᵢ^q − 1) + C (h/a)^s + D`,
//!
//! where `counted` has the constants of each kind of number. It takes the worst of four neighbours instead of extrapolating: the
//! end of a contact lies at another place of its element on each mesh, and two of them may agree by accident. A series that
//! oscillates or has not begun to converge makes it wider. Where a maximum lies is known no better than how high it is:
//! it may be wherever the pressure comes near it.
//!
//! The parts of iteration and penalty are differences to the solution of the same discrete problem, which is exact.

use rayon::prelude::*;

use crate::accuracy::coarser::coarser;
use crate::accuracy::counted::Counted;
use crate::accuracy::reading::{self, Quantity, Reading, Subject, of_supports};
use crate::algorithm::StiffnessRule;
use crate::error::Error;
use crate::measure::{Measures, larger};
use crate::mesh::Order;
use crate::solve::{Change, Discretisation, Formulation, Iteration, Origin, Run, Settings};

/// Part of a number's scale that round-off may leave.
const ROUND_OFF: f64 = 1e-9;
/// Fewest coarser meshes that say something, and the factor where there is one only (Roache's 3 for two meshes over 1.25).
const FEWEST: (usize, f64) = (2, 2.4);
/// Tolerance of the runs on coarser meshes.
const TOLERANCE: f64 = 1e-9;
/// Part of the peak's bar within which the pressures elsewhere may be the true peak: their errors are alike.
const FLAT: f64 = 0.5;
/// Factor on the distance between two readings of a peak.
const READINGS: f64 = 1.8;
/// Elements are larger on a coarser mesh than by this factor, or it is none.
const LARGER: f64 = 1.1;

/// How far a number may be from the truth of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug)]
pub struct Barred {
    /// What was measured.
    pub subject: Subject,
    /// Its value; NaN for a peak without a limit.
    pub value: f64,
    /// How far it may be off.
    pub bar: Bar,
}

/// The bars of all numbers of a run.
#[derive(Clone, Debug)]
pub struct Bars {
    /// Contact by contact, then support by support.
    pub all: Vec<Barred>,
    /// Coarser meshes that tell something.
    pub meshes: usize,
    /// Degrees of freedom of all of them.
    pub dofs: usize,
}

impl Bars {
    /// The bar of a number; none where it has none.
    pub fn of(&self, subject: Subject) -> Option<Bar> {
        self.all.iter().find(|one| one.subject == subject).map(|one| one.bar)
    }

    /// That of a number of a contact.
    pub fn of_contact(&self, contact: usize, quantity: Quantity) -> Option<Bar> {
        self.of(Subject::Contact(contact, quantity))
    }
}

/// The bars of a run on its mesh.
pub fn bars(discretisation: &Discretisation, run: &Run) -> Result<Bars, Error> {
    let family = Family::of(discretisation, run);
    let mut all = of_pressures(discretisation, run, &family);
    all.extend(of_reactions(discretisation, run, &family)?);
    Ok(family.bars(all))
}

/// The bars of what pressures alone tell.
pub(super) fn of_contacts(discretisation: &Discretisation, run: &Run) -> Bars {
    let family = Family::of(discretisation, run);
    family.bars(of_pressures(discretisation, run, &family))
}

/// Numbers of the contacts.
fn of_pressures(discretisation: &Discretisation, run: &Run, family: &Family) -> Vec<Barred> {
    let measured: Vec<&Measures> = run.contacts.iter().map(|contact| &contact.measures).collect();
    let [target, rigid] = [0, 1].map(|k| of_discrete(discretisation, run, k));
    let readings = reading::of_contacts(discretisation, &measured);
    let flat = |contact: usize| {
        let peak = readings.iter().find(|one| one.subject == Subject::Contact(contact, Quantity::PeakPressure));
        peak.map_or(f64::NAN, |peak| farthest(run, contact, family.mesh(run, peak, value_of(&rigid, peak.subject))))
    };
    let one = |reading: &Reading| {
        let [ended, discrete] = [&target, &rigid].map(|readings| value_of(readings, reading.subject));
        let mesh = match reading.subject {
            Subject::Contact(contact, Quantity::PeakPlace) if !family.is_at_end(run, contact) => {
                family.mesh(run, reading, discrete) + flat(contact)
            }
            _ => larger(family.mesh(run, reading, discrete), beyond(run, reading.subject, &family.sizes)),
        };
        let bar = Bar { mesh, iteration: (reading.value - ended).abs(), penalty: (ended - discrete).abs() };
        let value = if is_unbounded(run, reading.subject) { f64::NAN } else { reading.value };
        Barred { subject: reading.subject, value, bar }
    };
    readings.iter().map(one).collect()
}

/// How far the peak is from the outermost end of an edge whose mean comes near it.
fn farthest(run: &Run, contact: usize, bar: f64) -> f64 {
    let edges = &run.solution.edges[run.solution.contacts[contact].edges.clone()];
    let peak = &run.contacts[contact].measures.peak;
    let near = edges.iter().filter(|edge| edge.pressure >= peak.pressure - FLAT * bar);
    let farthest = near.flat_map(|edge| edge.ends).map(|end| (end - peak.position).abs()).fold(0.0, f64::max);
    if bar.is_nan() { f64::NAN } else { farthest }
}

/// Forces of the supports, whose discrete solutions are solved for: what is recorded of those has no displacements.
fn of_reactions(discretisation: &Discretisation, run: &Run, family: &Family) -> Result<Vec<Barred>, Error> {
    let of = |formulation: &Formulation| -> Result<Vec<Reading>, Error> {
        match Run::from_origin(Origin::From(&run.solution), discretisation, formulation, Change::NONE) {
            Ok(run) if run.solution.converged() => of_supports(discretisation, &run),
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
    let one = |reading: Reading| {
        let [ended, discrete] = [&target, &rigid].map(|readings| value_of(readings, reading.subject));
        let mesh = family.mesh(run, &reading, discrete);
        let bar = Bar { mesh, iteration: (reading.value - ended).abs(), penalty: (ended - discrete).abs() };
        Barred { subject: reading.subject, value: reading.value, bar }
    };
    Ok(of_supports(discretisation, run)?.into_iter().map(one).collect())
}

/// The coarser meshes of a run.
struct Family {
    /// What finds the discrete solution of the run's own contact element, without a penalty.
    formulation: Formulation,
    order: Order,
    /// Mean candidate element of each contact.
    sizes: Vec<f64>,
    cells: usize,
    /// Whether a body is one element deep below a contact, which no coarser mesh tells from a finer one.
    shallow: bool,
    coarse: Vec<Coarse>,
}

/// What a coarser mesh says.
struct Coarse {
    /// Mean candidate element of each contact.
    sizes: Vec<f64>,
    cells: usize,
    dofs: usize,
    readings: Vec<Reading>,
}

impl Family {
    fn of(discretisation: &Discretisation, run: &Run) -> Self {
        let Formulation { element, layer_thickness, settings, .. } = run.formulation;
        let settings = Settings { tolerance: TOLERANCE.min(settings.tolerance), ..Settings::default() };
        let formulation = Formulation { layer_thickness, settings, ..Formulation::new(element, Iteration::Kinematic) };
        let coarse = coarser(&discretisation.scene, discretisation.resolution).into_par_iter();
        // A mesh too coarse to hold the contact says nothing.
        let said = |(scene, resolution)| {
            let coarse = Discretisation::of(scene, resolution).ok()?;
            let run = Run::of(&coarse, &formulation).ok()?;
            said(&coarse, &run)
        };
        let coarse = coarse.filter_map(said).collect();
        let (sizes, cells) = (sizes(discretisation), discretisation.mesh.cells());
        let order = discretisation.resolution.order;
        Self { formulation, order, sizes, cells, shallow: is_shallow(discretisation), coarse }
    }

    /// Bars beside what the coarser meshes cost.
    fn bars(&self, all: Vec<Barred>) -> Bars {
        let meshes = if self.shallow { 0 } else { self.coarse.len() };
        Bars { all, meshes, dofs: self.coarse.iter().map(|one| one.dofs).sum() }
    }

    /// The mesh's part of a number whose value in the discrete solution is given; NaN where no mesh tells.
    fn mesh(&self, run: &Run, reading: &Reading, discrete: f64) -> f64 {
        let subject = reading.subject;
        let contact = match subject {
            Subject::Contact(contact, _) => contact,
            Subject::Reaction(..) => 0,
        };
        // Wherever the iteration ended.
        let measures = match &run.contacts[contact].exact {
            Some([_, discrete]) => discrete,
            None => &run.contacts[contact].measures,
        };
        let ends_at_candidates = measures.stretches.iter().any(|stretch| stretch.reaches.contains(&true));
        let counted = Counted::of(subject, self.formulation.element, self.order, ends_at_candidates);
        let along = |other: &Coarse| other.sizes[contact] / self.sizes[contact];
        // Where all of the mesh counts alike, and not the elements at the end of a contact, cells tell how much coarser it is:
        // one that has one element across a ring has no coarser neighbours in that direction.
        let of_cells = |other: &Coarse| (self.cells as f64 / other.cells as f64).sqrt();
        let ratio = |other: &Coarse| match counted.hidden > 0.0 && !ends_at_candidates {
            true => along(other),
            false => along(other).min(of_cells(other)),
        };
        let apart = |other: &Coarse| {
            (discrete - value_of(&other.readings, subject)).abs() / (ratio(other).powf(counted.exponent) - 1.0)
        };
        let coarser = self.coarse.iter().filter(|other| ratio(other) > LARGER);
        // Where a coarser contact has other stretches, there is nothing to compare.
        let known: Vec<f64> = coarser.map(apart).filter(|apart| apart.is_finite()).collect();
        let (fewest, alone) = FEWEST;
        let factor = match known.len() {
            _ if self.shallow => f64::NAN,
            0 => f64::NAN,
            few if few < fewest => alone * counted.factor,
            _ => counted.factor,
        };
        let hidden = counted.hidden * (self.sizes[contact] / measures.half_width).powf(counted.power);
        let [scale, read] = match subject {
            Subject::Contact(_, Quantity::PeakPressure) => {
                [measures.peak.pressure, READINGS * (measures.peak_by_parabola - measures.peak.pressure).abs()]
            }
            Subject::Contact(_, quantity) => [quantity.scale(measures), 0.0],
            Subject::Reaction(..) => [reading.scale, 0.0],
        };
        factor * known.into_iter().fold(0.0, f64::max) + (hidden + ROUND_OFF) * scale.abs() + read
    }

    /// Whether the peak lies in the last element before the end of the candidates: a corner, and no flat top.
    fn is_at_end(&self, run: &Run, contact: usize) -> bool {
        let Measures { peak, stretches, .. } = &run.contacts[contact].measures;
        let near = |end: f64| (peak.position - end).abs() < self.sizes[contact];
        stretches.iter().any(|one| (one.reaches[0] && near(one.begin)) || (one.reaches[1] && near(one.end)))
    }
}

/// Numbers of what the iteration shall end in, or of the discrete solution.
fn of_discrete(discretisation: &Discretisation, run: &Run, which: usize) -> Vec<Reading> {
    let measures = run.contacts.iter().map(|contact| contact.exact.as_ref().map(|exact| &exact[which]));
    measures
        .collect::<Option<Vec<_>>>()
        .map_or_else(Vec::new, |measures| reading::of_contacts(discretisation, &measures))
}

fn value_of(readings: &[Reading], subject: Subject) -> f64 {
    readings.iter().find(|reading| reading.subject == subject).map_or(f64::NAN, |reading| reading.value)
}

/// What a converged run on a coarser mesh says.
fn said(coarse: &Discretisation, run: &Run) -> Option<Coarse> {
    let mut readings = of_discrete(coarse, run, 1);
    readings.extend(of_supports(coarse, run).ok()?);
    run.solution.converged().then(|| Coarse {
        sizes: sizes(coarse),
        cells: coarse.mesh.cells(),
        dofs: run.dofs,
        readings,
    })
}

/// Whether a body has no more cells than candidate edges of one of its contacts.
fn is_shallow(discretisation: &Discretisation) -> bool {
    let pairs = discretisation.scene.contacts.iter().zip(&discretisation.interfaces);
    let bodies = &discretisation.mesh.bodies;
    pairs
        .into_iter()
        .any(|(pair, interface)| pair.bodies().any(|body| bodies[body].cells.len() <= interface.edges.len()))
}

/// Mean candidate element of each contact, in its coordinate.
fn sizes(discretisation: &Discretisation) -> Vec<f64> {
    let each = discretisation.interfaces.iter().map(|interface| {
        let nodes = &interface.nodes;
        let [begin, end] = [nodes.first(), nodes.last()].map(|node| node.map_or(f64::NAN, |node| node.coordinate));
        (end - begin) / interface.edges.len() as f64
    });
    each.collect()
}

/// Whether it is a peak without a limit, which is no number.
fn is_unbounded(run: &Run, subject: Subject) -> bool {
    match subject {
        Subject::Contact(contact, Quantity::PeakPressure) => run.contacts[contact].unbounded.is_some(),
        _ => false,
    }
}

/// Where a contact goes on to its outermost candidate, the mesh does not tell where it ends within that.
fn beyond(run: &Run, subject: Subject, size: &[f64]) -> f64 {
    let Subject::Contact(contact, quantity) = subject else { return 0.0 };
    let reaches =
        |k: usize, side: usize| run.contacts[contact].measures.stretches.get(k).is_some_and(|s| s.reaches[side]);
    let cut = match quantity {
        Quantity::Begin(k) => reaches(k, 0),
        Quantity::End(k) => reaches(k, 1),
        _ => false,
    };
    if cut { 0.5 * size[contact] } else { 0.0 }
}
