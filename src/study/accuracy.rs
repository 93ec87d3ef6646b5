//! What an accuracy costs against meshes made by hand, and whether it is kept.

use serde::Serialize;

use crate::accuracy::{self, Answer, Asked};
use crate::case::library::{Cylinder, PinPlate, TruncatedHertz};
use crate::case::solved::estimated;
use crate::case::{Case, Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::oracle;
use crate::scene::{Grading, Scene};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::about::About;
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "An accuracy asked for instead of a mesh",
    asked: "What an accuracy costs that is asked for, beside a mesh made by hand.",
    limits: "Peak pressure and second-moment width, which meshes made by hand are chosen by; `--accuracy` alone asks for the half-width instead.",
};

/// Errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 3e-3, 1e-3];

const fn by_hand(order: Order, elements: usize, end: f64, first: f64, growth: [f64; 3]) -> ByHand {
    ByHand { order, elements, beyond: 1, end, first, growth }
}

/// The cheapest meshes found by hand, for 1 %, 0.3 % and 0.1 %.
///
/// Of about 5,000 meshes a scene: 4-node and 8-node cells; 1 to 12 elements (16 on the pin) in the half-width; 1 to 3 beyond
/// it; candidates equal, or ending at a half or a quarter of the first; first rows of 1 or 2 sizes; growths 1.5/1.4 to 4/3.5;
/// coarsest element 0.3, 0.5 or 1 body. Kept is the one of fewest degrees of freedom whose worst errors of peak and second-moment width against
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
pub fn plan() -> Vec<Planned<Numbers>> {
    let of = |(subject, meshes): (Subject, [ByHand; 3])| {
        ASKED.into_iter().zip(meshes).map(move |(asked, mesh)| {
            let name = format!("{}, {} %", subject.name(), 100.0 * asked);
            Planned::new("accuracy asked", name, move || numbers(subject, asked, mesh))
        })
    };
    BY_HAND.into_iter().flat_map(of).collect()
}

/// Contact half-angle of the pin \[degrees\].
const ANGLE: f64 = 60.0;

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
    pub fn loaded(self, ratio: f64) -> Case {
        match self {
            Self::Truncated => {
                let nominal = TruncatedHertz::default();
                let (a_over_r, size) = (nominal.a_over_r * ratio, nominal.size / ratio);
                let numbers = TruncatedHertz { a_over_r, size, stretch: nominal.stretch / ratio, ..nominal };
                numbers.case()
            }
            Self::Cylinder => {
                let nominal = Cylinder { a_over_r: 0.005, ..Default::default() };
                let (a_over_r, stretch) = (nominal.a_over_r * ratio, nominal.stretch / ratio);
                Cylinder { a_over_r, stretch, ..nominal }.case()
            }
            Self::Pin => PinPlate::of_half_angle(ANGLE * ratio).case(),
        }
    }

    /// Nominal half-width \[mm\], or half-angle \[rad\].
    pub fn nominal(self) -> f64 {
        match self {
            Self::Truncated => TruncatedHertz::default().half_width(),
            Self::Cylinder => Cylinder { a_over_r: 0.005, ..Default::default() }.half_width(),
            Self::Pin => ANGLE.to_radians(),
        }
    }
}

/// Peak pressure and second-moment width, or second-moment angle, by the closed form.
pub fn closed_form(case: &Case) -> [f64; 2] {
    [oracle::Quantity::PeakPressure, oracle::Quantity::SecondMoment].map(|quantity| case.reading(quantity).value)
}

/// Larger relative error of peak and second-moment width; NaN where either is or the run did not converge.
pub fn error(run: &Run, truth: [f64; 2]) -> f64 {
    let measures = run.measures();
    let found = [measures.peak.pressure, measures.second_moment_width];
    let [peak, half_width] = [0, 1].map(|k| (found[k] / truth[k] - 1.0).abs());
    if run.solution.converged() { larger(peak, half_width) } else { f64::NAN }
}

/// Loads under which a mesh made by hand must keep its error.
const LOADS: usize = 8;
/// Tolerance of the iterations on meshes made by hand.
const TOLERANCE: f64 = 1e-6;
/// Elements within the contact of the mesh that stands for the truth, and its growth.
const TRUTH: (usize, [f64; 3]) = (32, [1.2, 1.15, 0.08]);

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

/// What a mesh made by hand costs, and what it keeps.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Price {
    /// Degrees of freedom.
    pub dofs: usize,
    /// Worst error over the loads against the closed form.
    pub worst: f64,
}

impl ByHand {
    /// Worst error over the loads against the closed form, and the degrees of freedom.
    pub fn price(&self, subject: Subject) -> Result<Price, Error> {
        let mut price = Price { dofs: 0, worst: 0.0 };
        for k in 0..LOADS {
            let place = (k as f64 - 0.5 * (LOADS - 1) as f64) / LOADS as f64;
            let case = subject.loaded(1.0 + place / self.elements as f64);
            let run = self.solved(&case.scene, subject.nominal())?;
            price.worst = larger(price.worst, error(&run, closed_form(&case)));
            price.dofs = run.dofs;
        }
        Ok(price)
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

/// Peak and second-moment width of the same scene on a mesh far finer than any that is answered.
pub fn truth(subject: Subject) -> Result<[f64; 2], Error> {
    let (elements, growth) = TRUTH;
    let fine = ByHand { order: Order::Quadratic, elements, beyond: elements / 8, end: 1.0, first: 1.0, growth };
    let run = fine.solved(&subject.loaded(1.0).scene, subject.nominal())?;
    Ok([run.measures().peak.pressure, run.measures().second_moment_width])
}

/// What an accuracy costs, and whether it is kept; errors are relative, the larger ones of peak and second-moment width.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Numbers {
    /// Error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Error estimated.
    pub estimate: f64,
    /// Error against the closed form.
    pub closed_form: f64,
    /// Error against a mesh far finer.
    pub finer: f64,
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
    /// Those of all meshes solved.
    pub dofs_in_all: usize,
    /// The mesh made by hand.
    pub by_hand: Price,
}

/// The engine's answer beside the mesh made by hand.
pub fn numbers(subject: Subject, asked: f64, by_hand: ByHand) -> Result<Numbers, Error> {
    let case = subject.loaded(1.0);
    let plain = Formulation::new(Element::Node, Iteration::Kinematic);
    let quantities = vec![accuracy::Quantity::PeakPressure, accuracy::Quantity::SecondMomentWidth];
    let answer = accuracy::solve(&case.scene, &plain, &Asked { quantities, ..Asked::new(asked) })?;
    Ok(Numbers::of(&answer, asked, [closed_form(&case), truth(subject)?], by_hand.price(subject)?))
}

impl Numbers {
    /// Of an answer, given peak and second-moment width by the closed form and by the finer mesh.
    pub fn of(answer: &Answer, asked: f64, [exact, finer]: [[f64; 2]; 2], by_hand: Price) -> Self {
        Self {
            asked,
            met: answer.unmet.is_none(),
            estimate: answer.estimate(),
            closed_form: error(&answer.run, exact),
            finer: error(&answer.run, finer),
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
            by_hand,
        }
    }
}

/// Degrees of freedom allowed over those of the mesh made by hand: bars are some times the errors, and of order 3/2 or 2 in the elements.
const ALLOWED: f64 = 4.0;
/// The same for all meshes together.
const IN_ALL: f64 = 20.0;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let &Numbers { asked, met, estimate, by_hand, .. } = numbers;
    let closed_form = || Reference::analytic("the closed form", 0.0);
    let own = |name: &str, value: f64| Reference::own(name, value);
    let larger = |name: &'static str| Quantity::at(name, "larger one of peak and second-moment width");
    let promised = if met { estimate } else { f64::NAN };
    let most = |times: f64| {
        own(&format!("{times} times those of the mesh made by hand"), (times * by_hand.dofs as f64).floor())
    };
    let in_all = Quantity::at("degrees of freedom of all meshes solved", "");
    let shown = "the accuracy asked; the finer mesh shows what the closed form leaves out";
    let loads = "eight loads move the contact edge across one element";
    Ok(vec![
        estimated(promised, asked),
        Check::error(larger("true error"), closed_form(), asked, shown).judge(numbers.closed_form),
        Check::error(larger("true error"), own("a mesh far finer", 0.0), promised, "the estimate").judge(numbers.finer),
        Check::error(larger("error of the mesh made by hand"), closed_form(), asked, loads).judge(by_hand.worst),
        Check::at_most(Quantity::Dofs, most(ALLOWED), "the price of not knowing the error").judge(numbers.dofs as f64),
        Check::at_most(in_all, most(IN_ALL), "the price of not knowing the contact").judge(numbers.dofs_in_all as f64),
    ])
}

/// Columns beside the name of the trial.
const HEAD: [&str; 8] = [
    "scene, asked",
    "estimated",
    "against closed form",
    "against finer mesh",
    "dofs",
    "dofs of all meshes",
    "by hand",
    "worst by hand",
];

/// One row a scene and an accuracy.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let rows: Vec<Vec<String>> = findings.iter().map(|found| row(found.name, found.numbers)).collect();
    Ok(format!(
        "`accuracy = \"0.1 %\"` in a scene file, or `--accuracy`, chooses elements, growth and candidates of 8-node cells, from 0.1 % on \
         the order of cells fitted to the contact. Errors are the \
         larger ones of peak pressure and second-moment width (second-moment angle). A mesh made by hand is the cheapest found whose worst \
         error over eight loads is within the asked one. The estimate is the error bar of every solve: *dofs of all \
         meshes* counts those of the meshes before the one answered, and of the coarser ones of their bars.\n\n{}\n",
        markdown::table(&HEAD.map(String::from), &rows)
    ))
}

fn row(name: &str, numbers: &Numbers) -> Vec<String> {
    let percent = |error: f64| format!("{:.3} %", 100.0 * error);
    vec![
        name.into(),
        percent(numbers.estimate),
        percent(numbers.closed_form),
        percent(numbers.finer),
        numbers.dofs.to_string(),
        numbers.dofs_in_all.to_string(),
        numbers.by_hand.dofs.to_string(),
        percent(numbers.by_hand.worst),
    ]
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
