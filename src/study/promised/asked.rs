//! What an accuracy costs against meshes made by hand, and whether it is kept.

use crate::accuracy::{self, Answer, Asked};
use crate::case::library::{Cylinder, PinPlate, TruncatedHertz};
use crate::case::solved::estimated;
use crate::case::{Case, Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::{Quantity as Number, larger};
use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Scene};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::Planned;

/// Errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 3e-3, 1e-3];

/// A mesh made by hand: elements within the nominal contact, and their growth in units of it.
type Mesh = (Resolution, Grading);

/// A mesh of an order with so many equal elements in the contact; the last candidate element over the first, the first row over the size
/// along the surface, growth along and into the depth, and the coarsest element over the body.
const fn mesh(order: Order, elements: usize, end: f64, first: f64, [along, depth, coarsest]: [f64; 3]) -> Mesh {
    (Resolution { elements, refinement: 0, order }, Grading { unit: 1.0, along, depth, first, coarsest, end })
}

/// The cheapest meshes found by hand.
///
/// Of about 5,000 meshes a scene: 4-node and 8-node cells; 1 to 12 elements (16 on the pin) in the half-width; 1 to 3 beyond
/// it; candidates equal, or ending at a half or a quarter of the first; first rows of 1 or 2 sizes; growths 1.5/1.4 to 4/3.5;
/// coarsest element 0.3, 0.5 or 1 body. Kept is the one of fewest degrees of freedom whose worst errors of peak and second-moment width against
/// the closed form, over eight loads that move the contact edge across one element, are both within the asked one.
const BY_HAND: [(Subject, f64, Mesh); 9] = [
    (Subject::Truncated, ASKED[0], mesh(Order::Quadratic, 3, 1.0, 1.0, [4.0, 3.5, 1.0])),
    (Subject::Truncated, ASKED[1], mesh(Order::Quadratic, 6, 1.0, 1.0, [4.0, 3.5, 1.0])),
    (Subject::Truncated, ASKED[2], mesh(Order::Quadratic, 8, 0.5, 2.0, [2.0, 1.8, 0.5])),
    (Subject::Cylinder, ASKED[0], mesh(Order::Linear, 5, 0.5, 1.0, [2.5, 2.2, 0.3])),
    (Subject::Cylinder, ASKED[1], mesh(Order::Quadratic, 5, 1.0, 1.0, [4.0, 3.5, 1.0])),
    (Subject::Cylinder, ASKED[2], mesh(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 0.3])),
    (Subject::Pin, ASKED[0], mesh(Order::Quadratic, 4, 0.5, 1.0, [4.0, 3.5, 1.0])),
    (Subject::Pin, ASKED[1], mesh(Order::Quadratic, 6, 0.25, 1.0, [4.0, 3.5, 1.0])),
    (Subject::Pin, ASKED[2], mesh(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 1.0])),
];
/// Elements of these beyond the contact.
const BEYOND: usize = 1;
/// The mesh that stands for the truth, and its elements beyond the contact.
const TRUTH: (Mesh, usize) = (mesh(Order::Quadratic, 32, 1.0, 1.0, [1.2, 1.15, 0.08]), 4);

/// Every scene with every accuracy.
pub fn plan() -> Vec<Planned<Answered>> {
    let of = |(subject, asked, mesh): (Subject, f64, Mesh)| {
        let name = format!("{}, {} %", subject.name(), 100.0 * asked);
        Planned::new("accuracy asked", name, move || answered(subject, asked, mesh))
    };
    BY_HAND.into_iter().map(of).collect()
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
    [Number::PeakPressure, Number::SecondMomentWidth].map(|quantity| case.reading(0, &quantity).value)
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

/// A scene solved on a mesh made by hand that reaches so many elements beyond the nominal contact.
fn solved(scene: &Scene, nominal: f64, (resolution, grading): Mesh, beyond: usize) -> Result<Run, Error> {
    let mut scene = scene.clone();
    let elements = resolution.elements;
    scene.contacts[0].stretch = nominal * (elements + beyond) as f64 / elements as f64;
    scene.grading = Grading { unit: nominal * scene.contact().path.metric(), ..grading };
    Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification().tolerance(TOLERANCE))
}

/// Degrees of freedom of a mesh made by hand, and its worst error over the loads against the closed form.
fn price(subject: Subject, mesh: Mesh) -> Result<(usize, f64), Error> {
    let mut price = (0, 0.0);
    for k in 0..LOADS {
        let place = (k as f64 - 0.5 * (LOADS - 1) as f64) / LOADS as f64;
        let case = subject.loaded(1.0 + place / mesh.0.elements as f64);
        let run = solved(&case.scene, subject.nominal(), mesh, BEYOND)?;
        price = (run.dofs, larger(price.1, error(&run, closed_form(&case))));
    }
    Ok(price)
}

/// Peak and second-moment width of the same scene on a mesh far finer than any that is answered.
fn truth(subject: Subject) -> Result<[f64; 2], Error> {
    let (mesh, beyond) = TRUTH;
    let run = solved(&subject.loaded(1.0).scene, subject.nominal(), mesh, beyond)?;
    Ok([run.measures().peak.pressure, run.measures().second_moment_width])
}

/// What an accuracy costs, and whether it is kept; errors are relative, the larger ones of peak and second-moment width.
#[derive(Clone, Copy, Debug)]
pub struct Answered {
    /// Error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Error estimated.
    pub estimate: f64,
    /// Errors against the closed form and against a mesh far finer.
    pub errors: [f64; 2],
    /// Degrees of freedom of the mesh answered, and of all meshes solved.
    pub dofs: [usize; 2],
    /// Degrees of freedom of the mesh made by hand, and its worst error.
    pub by_hand: (usize, f64),
}

/// The engine's answer beside the mesh made by hand.
fn answered(subject: Subject, asked: f64, mesh: Mesh) -> Result<Answered, Error> {
    let case = subject.loaded(1.0);
    let plain = Formulation::new(Element::Node, Iteration::Kinematic);
    let quantities = vec![Number::PeakPressure, Number::SecondMomentWidth];
    let answer = accuracy::solve(&case.scene, &plain, &Asked { quantities, ..Asked::new(asked) })?;
    Ok(Answered::of(&answer, asked, [closed_form(&case), truth(subject)?], price(subject, mesh)?))
}

impl Answered {
    /// Of an answer, given peak and second-moment width by the closed form and by the finer mesh.
    pub fn of(answer: &Answer, asked: f64, truths: [[f64; 2]; 2], by_hand: (usize, f64)) -> Self {
        let (met, estimate) = (answer.unmet.is_none(), answer.estimate());
        let errors = truths.map(|truth| error(&answer.run, truth));
        Self { asked, met, estimate, errors, dofs: [answer.run.dofs, answer.dofs_in_all()], by_hand }
    }
}

/// Degrees of freedom allowed over those of the mesh made by hand: bars are some times the errors, and of order 3/2 or 2 in the elements.
const ALLOWED: f64 = 4.0;
/// The same for all meshes together.
const IN_ALL: f64 = 20.0;

/// The checks.
pub fn judge(answered: &Answered) -> Vec<Judged> {
    let &Answered { asked, met, estimate, errors: [exact, finer], dofs: [dofs, in_all], by_hand: (least, worst) } =
        answered;
    let closed_form = || Reference::analytic("the closed form", 0.0);
    let own = |name: &str, value: f64| Reference::own(name, value);
    let larger = |name: &'static str| Quantity::at(name, "larger one of peak and second-moment width");
    let promised = if met { estimate } else { f64::NAN };
    let most =
        |times: f64| own(&format!("{times} times those of the mesh made by hand"), (times * least as f64).floor());
    let all_meshes = Quantity::at("degrees of freedom of all meshes solved", "");
    let shown = "the accuracy asked; the finer mesh shows what the closed form leaves out";
    let loads = "eight loads move the contact edge across one element";
    vec![
        estimated(promised, asked),
        Check::error(larger("true error"), closed_form(), asked, shown).judge(exact),
        Check::error(larger("true error"), own("a mesh far finer", 0.0), promised, "the estimate").judge(finer),
        Check::error(larger("error of the mesh made by hand"), closed_form(), asked, loads).judge(worst),
        Check::at_most(Quantity::Dofs, most(ALLOWED), "the price of not knowing the error").judge(dofs as f64),
        Check::at_most(all_meshes, most(IN_ALL), "the price of not knowing the contact").judge(in_all as f64),
    ]
}

/// The table of answers, each with the name of its trial.
const COLUMNS: [Column<(String, Answered)>; 8] = [
    ("scene, asked", |(name, _)| name.clone()),
    ("estimated", |(_, one)| percent(one.estimate)),
    ("against closed form", |(_, one)| percent(one.errors[0])),
    ("against finer mesh", |(_, one)| percent(one.errors[1])),
    ("dofs", |(_, one)| one.dofs[0].to_string()),
    ("dofs of all meshes", |(_, one)| one.dofs[1].to_string()),
    ("by hand", |(_, one)| one.by_hand.0.to_string()),
    ("worst by hand", |(_, one)| percent(one.by_hand.1)),
];

fn percent(error: f64) -> String {
    format!("{:.3} %", 100.0 * error)
}

/// The section: a row for a scene and an accuracy.
pub(super) fn section(answered: &[(String, Answered)]) -> String {
    format!(
        "## An accuracy asked for instead of a mesh\n\n\
         `accuracy = \"0.1 %\"` in a scene file, or `--accuracy`, chooses elements, growth and candidates of 8-node cells, from 0.1 % on \
         the order of cells fitted to the contact. Errors are the \
         larger ones of peak pressure and second-moment width (second-moment angle), which meshes made by hand are chosen by; \
         `--accuracy` alone asks for the half-width instead. A mesh made by hand is the cheapest found whose worst \
         error over eight loads is within the asked one. The estimate is the error bar of every solve: *dofs of all \
         meshes* counts those of the meshes before the one answered, and of the coarser ones of their bars.\n\n{}\n",
        markdown::columns(&COLUMNS, answered)
    )
}
