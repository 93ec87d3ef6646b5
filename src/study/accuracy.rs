//! What an accuracy costs against meshes made by hand, and whether it is kept.

use crate::accuracy::{self, Answer, Asked};
use crate::case::library::{Cylinder, TruncatedHertz};
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::Quantity;
use crate::scene::{Grading, Scene};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the study.
pub const ACCURACY: &str = "accuracy asked";
/// Errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 3e-3, 1e-3];
/// Freedoms allowed over those of the mesh made by hand.
const ALLOWED: f64 = 2.0;
/// Loads under which a mesh made by hand must keep its error.
const LOADS: usize = 8;
/// Tolerance of the iterations on meshes made by hand.
const TOLERANCE: f64 = 1e-6;
/// Contact half-angle of the pin \[degrees\].
const ANGLE: f64 = 60.0;
/// Elements within the contact of the mesh that stands for the truth, and its growth.
const TRUTH: (usize, [f64; 3]) = (32, [1.2, 1.15, 0.08]);

/// A scene of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Truncated Hertz.
    Truncated,
    /// The cylinder at a/R = 0.005.
    Cylinder,
    /// The pin in a wide plate.
    Pin,
}

/// A mesh made by hand: uniform or graded candidates that reach so many elements beyond the nominal contact.
#[derive(Clone, Copy, Debug)]
pub struct ByHand {
    /// Element order.
    pub order: Order,
    /// Elements within the nominal contact, were they equal.
    pub elements: usize,
    /// Elements beyond it.
    pub beyond: usize,
    /// Last candidate element over the first.
    pub end: f64,
    /// First row over the size along the surface.
    pub first: f64,
    /// Growth along and into the depth, coarsest element over the body.
    pub growth: [f64; 3],
}

const fn by_hand(order: Order, elements: usize, end: f64, first: f64, growth: [f64; 3]) -> ByHand {
    ByHand { order, elements, beyond: 1, end, first, growth }
}

/// The cheapest meshes found by hand, for 1 %, 0.3 % and 0.1 %.
///
/// Of about 5,000 meshes a scene: 4-node and 8-node cells; 1 to 12 elements (16 on the pin) in the half-width; 1 to 3 beyond
/// it; candidates equal, or ending at a half or a quarter of the first; first rows of 1 or 2 sizes; growths 1.5/1.4 to 4/3.5;
/// coarsest element 0.3, 0.5 or 1 body. Kept is the one of fewest freedoms whose worst errors of peak and half-width against
/// the closed form, over eight loads that move the contact edge across one element, are both within the asked one.
const BY_HAND: [(Subject, [ByHand; 3]); 3] = [
    (
        Subject::Truncated,
        [
            by_hand(Order::Quadratic, 3, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 6, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 8, 0.5, 2.0, [2.0, 1.8, 0.5]),
        ],
    ),
    (
        Subject::Cylinder,
        [
            by_hand(Order::Linear, 5, 0.5, 1.0, [2.5, 2.2, 0.3]),
            by_hand(Order::Quadratic, 5, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 0.3]),
        ],
    ),
    (
        Subject::Pin,
        [
            by_hand(Order::Quadratic, 4, 0.5, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 6, 0.25, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 1.0]),
        ],
    ),
];

/// One trial a scene and an accuracy.
pub fn trials() -> Vec<Trial> {
    let of = |(subject, meshes): (Subject, [ByHand; 3])| {
        ASKED.into_iter().zip(meshes).map(move |(asked, mesh)| {
            let name = format!("{}, {} %", subject.name(), 100.0 * asked);
            Trial::new(ACCURACY, name, move || judged(subject, asked, mesh))
        })
    };
    BY_HAND.into_iter().flat_map(of).collect()
}

impl Subject {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Truncated => "truncated hertz",
            Self::Cylinder => "cylinder, a/R = 0.005",
            Self::Pin => "pin in plate, ε = 60°",
        }
    }

    /// The scene under the load that makes the contact so many times as long as the nominal one, on the outline of that one.
    pub fn loaded(self, ratio: f64) -> Problem {
        match self {
            Self::Truncated => {
                let nominal = TruncatedHertz::default();
                let (a_over_r, size) = (nominal.a_over_r * ratio, nominal.size / ratio);
                let numbers = TruncatedHertz { a_over_r, size, stretch: nominal.stretch / ratio, ..nominal };
                Problem::new("truncated-hertz", self.name(), problem::truncated_hertz(numbers))
            }
            Self::Cylinder => {
                let nominal = Cylinder { a_over_r: 0.005, ..Default::default() };
                let (a_over_r, stretch) = (nominal.a_over_r * ratio, nominal.stretch / ratio);
                Problem::new("cylinder", self.name(), problem::cylinder(Cylinder { a_over_r, stretch, ..nominal }))
            }
            Self::Pin => Problem::new("pin-plate", self.name(), problem::pin_plate(ANGLE * ratio)),
        }
    }

    /// Nominal half-width \[mm\], or half-angle \[rad\].
    fn nominal(self) -> f64 {
        match self {
            Self::Truncated => TruncatedHertz::default().half_width(),
            Self::Cylinder => Cylinder { a_over_r: 0.005, ..Default::default() }.half_width(),
            Self::Pin => ANGLE.to_radians(),
        }
    }
}

/// Peak pressure and half-width, or second-moment angle, by the closed form.
pub fn closed_form(problem: &Problem) -> [f64; 2] {
    let Some(oracle) = &problem.oracle else { return [f64::NAN; 2] };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity).value;
    [Quantity::PeakPressure, Quantity::SecondMoment].map(read)
}

/// Larger relative error of peak and half-width; NaN where either is or the run did not converge.
pub fn error(run: &Run, truth: [f64; 2]) -> f64 {
    let found = [run.measures().peak.pressure, run.measures().half_width];
    let [peak, half_width] = [0, 1].map(|k| (found[k] / truth[k] - 1.0).abs());
    let known = run.solution.converged() && !peak.is_nan() && !half_width.is_nan();
    if known { peak.max(half_width) } else { f64::NAN }
}

impl ByHand {
    /// Worst error over the loads against the closed form, and the freedoms.
    pub fn worst(&self, subject: Subject) -> Result<(f64, usize), Error> {
        let (mut worst, mut freedoms) = (0.0_f64, 0);
        for k in 0..LOADS {
            let place = (k as f64 - 0.5 * (LOADS - 1) as f64) / LOADS as f64;
            let problem = subject.loaded(1.0 + place / self.elements as f64);
            let run = self.solved(&problem.scene, subject.nominal())?;
            let error = error(&run, closed_form(&problem));
            worst = if error.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(error) };
            freedoms = run.freedoms;
        }
        Ok((worst, freedoms))
    }

    fn solved(&self, scene: &Scene, nominal: f64) -> Result<Run, Error> {
        let mut scene = scene.clone();
        let [along, depth, coarsest] = self.growth;
        let unit = nominal * scene.contact().path.metric();
        scene.contacts[0].stretch = nominal * (self.elements + self.beyond) as f64 / self.elements as f64;
        scene.grading = Grading { unit, along, depth, first: self.first, coarsest, end: self.end };
        let resolution = Resolution { elements: self.elements, refinement: 0, order: self.order };
        Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification().tolerance(TOLERANCE))
    }
}

/// Peak and half-width of the same scene on a mesh far finer than any that is answered.
pub fn truth(subject: Subject) -> Result<[f64; 2], Error> {
    let (elements, growth) = TRUTH;
    let fine = ByHand { order: Order::Quadratic, elements, beyond: elements / 8, end: 1.0, first: 1.0, growth };
    let run = fine.solved(&subject.loaded(1.0).scene, subject.nominal())?;
    Ok([run.measures().peak.pressure, run.measures().half_width])
}

fn judged(subject: Subject, asked: f64, by_hand: ByHand) -> Result<Finding, Error> {
    let problem = subject.loaded(1.0);
    let plain = Formulation::new(Element::Node, Iteration::Kinematic);
    let wanted = Asked::new(asked);
    let answer = accuracy::solve(&problem.scene, &plain, &wanted)?;
    let (worst, freedoms) = by_hand.worst(subject)?;
    let finer = truth(subject)?;
    Ok(Finding {
        checks: checks(&answer, &wanted, closed_form(&problem), finer, (worst, freedoms)),
        tables: vec![table(&answer, [closed_form(&problem), finer], (worst, freedoms))],
        ..Default::default()
    })
}

/// The checks of an answer, given the closed form, the finer solution, and error and freedoms of the mesh made by hand.
pub fn checks(
    answer: &Answer,
    asked: &Asked,
    closed_form: [f64; 2],
    finer: [f64; 2],
    (worst, freedoms): (f64, usize),
) -> Vec<Judged> {
    let own = Reference::own;
    let within = |requirement: &str, quantity: &str, error: f64, reference: Reference, because: &str| {
        Judged::norm(requirement, quantity, error, reference, asked.relative, because)
    };
    let larger = "larger error of peak and half-width";
    let at_most = (ALLOWED * freedoms as f64).floor();
    let covered = if answer.unmet.is_none() { answer.estimate() } else { f64::NAN };
    vec![
        answer.check(asked),
        within(
            "The true error shall be within the one asked",
            larger,
            error(&answer.run, closed_form),
            Reference::analytic("the closed form", 0.0),
            "the accuracy asked; the finer mesh shows what the closed form leaves out",
        ),
        Judged::norm(
            "The true error shall be within the estimated one",
            larger,
            error(&answer.run, finer),
            own("a mesh far finer", 0.0),
            covered,
            "the estimate",
        ),
        within(
            "The mesh made by hand shall keep the error asked under every load",
            larger,
            worst,
            Reference::analytic("the closed form", 0.0),
            "eight loads move the contact edge across one element",
        ),
        Judged::at_most(
            "The mesh shall not need more than twice the freedoms of the one made by hand",
            "freedoms",
            answer.run.freedoms as f64,
            own("twice those made by hand", at_most),
            "the price of not knowing the contact",
        ),
    ]
}

fn table(answer: &Answer, [closed_form, finer]: [[f64; 2]; 2], (worst, freedoms): (f64, usize)) -> Table {
    let percent = |error: f64| format!("{:.3} %", 100.0 * error);
    let head =
        ["estimated", "against closed form", "against finer mesh", "freedoms", "in all", "by hand", "worst by hand"];
    Table {
        title: String::new(),
        head: head.map(String::from).into(),
        rows: vec![vec![
            percent(answer.estimate()),
            percent(error(&answer.run, closed_form)),
            percent(error(&answer.run, finer)),
            answer.run.freedoms.to_string(),
            answer.tried.iter().map(|tried| tried.freedoms).sum::<usize>().to_string(),
            freedoms.to_string(),
            percent(worst),
        ]],
    }
}
