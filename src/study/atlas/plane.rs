//! The planes of the atlas, initial stiffness against one other number; what was measured at each point, as it is kept
//! under `snapshots/atlas`, and the chart of a plane that it makes; and what charts say of each method: where every run
//! ends right, how the others end, and which to use from where.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::algorithm::{StiffnessRule, StiffnessUnit};
use crate::case::Case;
use crate::case::library::{Cylinder, Indented, PinRod, TruncatedHertz};
use crate::error::Error;
use crate::markdown;
use crate::mesh::Resolution;
use crate::named::named_enum;
use crate::solve::{Element, Ended, Formulation, Iteration};
use crate::study::grouped::in_order;
use crate::study::method::Method;
use crate::study::records::{self, rounded};

/// Candidate stretch over the half-width at the centre: no node lies on the contact edge.
pub const STRETCH: f64 = 1.9;
/// Elements per half-width at the centre.
const ELEMENTS: usize = 8;
/// Elements per 10 mm of arc of the pin-rod.
const PIN_ROD_ELEMENTS: usize = 12;

named_enum! {
    /// Initial stiffness against one other number, all else at the centre: truncated Hertz, candidates to 1.9
    /// half-widths, 8 elements per half-width. The full planes first, then the scenes of the paper; the name is that of
    /// the record.
    pub enum Plane {
        /// Candidate stretch over the half-width.
        Stretch = "stretch",
        /// Elements per half-width.
        Mesh = "mesh",
        /// Candidate stretch over the radius of the contact, of the truncated sphere.
        Sphere = "sphere",
        /// The cylinder.
        Cylinder = "cylinder",
        /// The pin-rod.
        PinRod = "pin-rod",
    }
}

impl Plane {
    /// The scenes of the paper.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// What the other number is, and its values.
    fn axis(self) -> (&'static str, &'static [f64]) {
        match self {
            Self::Stretch => ("L/a", &[1.0, 1.3, 1.6, STRETCH, 2.4, 3.1, 4.0]),
            Self::Mesh => ("elements per a", &[4.0, 6.0, 8.0, 12.0, 16.0]),
            Self::Sphere => ("L/a", &[1.3, STRETCH, 3.1]),
            Self::Cylinder => ("elements per a", &[ELEMENTS as f64]),
            Self::PinRod => ("elements per 10 mm", &[PIN_ROD_ELEMENTS as f64]),
        }
    }

    /// What the other number is.
    pub fn label(self) -> &'static str {
        self.axis().0
    }

    /// Whether it has many values of both numbers.
    pub fn is_full(self) -> bool {
        !Self::PAPER.contains(&self)
    }

    /// Initial stiffnesses over twelve decades, by halves of them.
    pub fn stiffnesses() -> Vec<f64> {
        (-12..=12).map(|k| 10f64.powf(0.5 * f64::from(k))).collect()
    }

    /// Its meshes, in the order of the record.
    pub fn sites(self) -> Vec<Site> {
        self.axis().1.iter().map(|&ordinate| Site { plane: self, ordinate }).collect()
    }

    /// Its lines, all but the initial stiffness fixed, in the order of the record.
    pub fn rows(self) -> Vec<(Site, Method)> {
        self.sites().into_iter().flat_map(|site| Method::all().into_iter().map(move |method| (site, method))).collect()
    }

    /// The case that the library has of it, or truncated Hertz or sphere with such candidates.
    pub fn case(self, stretch: f64) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
            Self::Sphere => {
                Indented { stretch, ..Indented::by_sphere(0.05) }.case("truncated-sphere", "truncated sphere")
            }
            _ => TruncatedHertz { stretch, ..Default::default() }.case(),
        }
    }
}

/// A plane at one of its ordinates: all that is solved on one mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// The plane.
    pub plane: Plane,
    /// The other number.
    pub ordinate: f64,
}

impl Site {
    /// Name among the unfinished ones.
    pub fn key(&self) -> String {
        format!("{}-{}", self.plane.name(), self.ordinate)
    }

    /// The case on its mesh.
    pub fn case(&self) -> Case {
        let (stretch, elements) = match self.plane {
            Plane::Stretch | Plane::Sphere => (self.ordinate, ELEMENTS),
            Plane::Mesh | Plane::Cylinder | Plane::PinRod => (STRETCH, self.ordinate as usize),
        };
        let case = self.plane.case(stretch);
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }
}

/// Error of p₀ and a that a run within the default tolerance may have.
pub const RIGHT: f64 = 3e-3;

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- atlas` and review the diff of snapshots/atlas";

/// One point.
#[derive(Clone, Debug)]
pub struct Record {
    /// What was run.
    pub method: Method,
    /// The plane's other number.
    pub ordinate: f64,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// How it ended.
    pub class: Ended,
    /// Iterations made; zero where an error keeps them.
    pub iterations: usize,
    /// Larger error of p₀ and a against the solution of the same discrete problem; NaN where an error keeps them.
    pub error: f64,
    /// Larger error of p₀ and a that the springs of a penalty make; none without one.
    pub penalty: Option<f64>,
    /// Iterations predicted, infinite where it shall not converge; none where none are.
    pub predicted_iterations: Option<f64>,
}

impl Record {
    /// Error of p₀ and a with that of a penalty, which may stop far from the solution.
    pub fn off(&self) -> f64 {
        self.error + self.penalty.unwrap_or_default()
    }

    /// Whether the run stopped where it shall.
    pub fn is_right(&self) -> bool {
        self.class == Ended::Converged && self.off() <= RIGHT
    }
}

/// Equal but for the digits a text file leaves out.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
}

/// A line of a record: a method, the plane's other number, and from each initial stiffness class, iterations, error,
/// penalty and predicted iterations.
pub type Line = (Method, f64, Vec<(Ended, usize, f64, Option<f64>, Option<f64>)>);

/// Columns of a record: the formulation and the other number, then what is kept of each initial stiffness.
pub fn head() -> Vec<String> {
    let of = |k: f64| {
        let kept = ["class", "iterations", "error", "penalty", "predicted"];
        kept.map(|what| format!("{what} {:e}", rounded(k)))
    };
    records::named(["formulation", "ordinate"])
        .into_iter()
        .chain(Plane::stiffnesses().into_iter().flat_map(of))
        .collect()
}

/// The lines of points in the order of the plan.
pub fn lines(records: &[Record]) -> Vec<Line> {
    let kept = |r: &Record| (r.class, r.iterations, r.error, r.penalty, r.predicted_iterations);
    let rows = records.chunk_by(|a, b| a.method == b.method && same(a.ordinate, b.ordinate));
    rows.map(|row| (row[0].method, row[0].ordinate, row.iter().map(kept).collect())).collect()
}

/// The records of a plane, a line per row of the plan.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The plane.
    pub plane: Plane,
    /// Records by row, then by initial stiffness.
    pub rows: Vec<Vec<Record>>,
}

impl Chart {
    /// The records in the order of the plan.
    pub fn of(plane: Plane, records: &[Record]) -> Self {
        Self { plane, rows: records.chunks(Plane::stiffnesses().len()).map(<[Record]>::to_vec).collect() }
    }

    /// The record of a plane; refused where it does not hold exactly the points of the plan.
    pub fn read(plane: Plane) -> Result<Self, Error> {
        Self::read_from(&file(plane), plane)
    }

    /// The same from another file.
    pub fn read_from(path: &Path, plane: Plane) -> Result<Self, Error> {
        let lines: Vec<Line> = records::read(path, &head(), RENEW)?;
        let planned = plane.rows();
        let is_at = |((method, ordinate, _), (site, planned)): (&Line, &(Site, Method))| {
            method == planned && same(*ordinate, site.ordinate)
        };
        if lines.len() != planned.len() || !lines.iter().zip(&planned).all(is_at) {
            let found = format!("{} lines that are not the {} of the plan", lines.len(), planned.len());
            return Err(Error::refused(path, "lines", found, RENEW));
        }
        let of_line = |(method, ordinate, kept): Line| {
            let kept = kept.into_iter().zip(Plane::stiffnesses());
            kept.map(move |((class, iterations, error, penalty, predicted_iterations), k)| Record {
                method,
                ordinate,
                stiffness: rounded(k),
                class,
                iterations,
                error,
                penalty,
                predicted_iterations,
            })
        };
        let records: Vec<Record> = lines.into_iter().flat_map(of_line).collect();
        Ok(Self::of(plane, &records))
    }

    /// Rows of a method, by growing ordinate.
    pub fn of_method(&self, method: Method) -> impl Iterator<Item = &[Record]> {
        self.rows.iter().map(Vec::as_slice).filter(move |row| row[0].method == method)
    }
}

/// The record of a plane.
pub fn file(plane: Plane) -> PathBuf {
    records::file(&format!("atlas/{}", plane.name()))
}

/// What the planes say of a method.
#[derive(Clone, Debug)]
pub struct Digest {
    /// What was run.
    pub method: Method,
    /// Where every run ends right.
    pub safe: Option<Safe>,
    /// Runs that had a prediction.
    pub predicted: usize,
    /// Plane by plane, runs that did not end right, of all.
    pub wrong: Vec<(Plane, [usize; 2])>,
}

/// The longest range of initial stiffnesses from which every run ends right.
#[derive(Clone, Copy, Debug)]
pub struct Safe {
    /// Softest start of the range.
    pub from: f64,
    /// Hardest start of the range.
    pub to: f64,
    /// Most iterations of any run in the range.
    pub iterations: usize,
    /// The start with the fewest iterations in the worst case.
    pub best: f64,
    /// Most iterations of any run from there.
    pub best_iterations: usize,
}

/// Digests of every method, element by element.
pub fn digests(charts: &[&Chart]) -> Vec<Digest> {
    Method::all().into_iter().map(|method| digest(charts, method)).collect()
}

fn digest(charts: &[&Chart], method: Method) -> Digest {
    let rows: Vec<&[Record]> = charts.iter().flat_map(|chart| chart.of_method(method)).collect();
    let all = || rows.iter().flat_map(|row| row.iter());
    Digest {
        method,
        safe: safe(&rows, method.algorithm.default_stiffness()),
        predicted: all().filter(|record| record.predicted_iterations.is_some()).count(),
        wrong: charts.iter().map(|chart| (chart.plane, wrong(chart.of_method(method)))).collect(),
    }
}

/// Runs that did not end right, of all.
fn wrong<'a>(rows: impl Iterator<Item = &'a [Record]>) -> [usize; 2] {
    rows.flatten().fold([0, 0], |[wrong, all], record| [wrong + usize::from(!record.is_right()), all + 1])
}

/// The range, from rows with the same initial stiffnesses; of equal starts the one nearest to the algorithm's own is
/// the best.
fn safe(rows: &[&[Record]], usual: f64) -> Option<Safe> {
    let columns = rows.first().map_or(0, |row| row.len());
    let column = |c: usize| rows.iter().map(move |row| &row[c]);
    let right: Vec<usize> = (0..columns).filter(|&c| column(c).all(Record::is_right)).collect();
    // Of equally long ranges the first.
    let range = right.chunk_by(|a, b| a + 1 == *b).rev().max_by_key(|range| range.len())?;
    let stiffness = |c: usize| rows[0][c].stiffness;
    let worst = |c: usize| column(c).map(|record| record.iterations).max().unwrap_or(0);
    let away = |c: usize| (stiffness(c) / usual).ln().abs();
    let better = |a: &usize, b: &usize| worst(*a).cmp(&worst(*b)).then(away(*a).total_cmp(&away(*b)));
    let best = range.iter().copied().min_by(better)?;
    Some(Safe {
        from: stiffness(range[0]),
        to: stiffness(range[range.len() - 1]),
        iterations: range.iter().copied().map(worst).max()?,
        best: stiffness(best),
        best_iterations: worst(best),
    })
}

/// A row of the advice: what is needed, the method that serves it with the κ₀ to set where that matters, and its range.
type Advice = (&'static str, Method, Option<f64>, Safe);

/// The table of the advice.
const ADVICE: [markdown::Column<Advice>; 6] = [
    ("need", |(need, ..)| (*need).into()),
    ("use", |(_, method, ..)| format!("`{method}`")),
    ("κ₀", |(_, method, stiffness, _)| told_stiffness(*method, *stiffness)),
    ("iterations, at most", |(.., stiffness, safe)| {
        stiffness.map_or(safe.iterations, |_| safe.best_iterations).to_string()
    }),
    ("every surveyed run ends right for κ₀", |(.., Safe { from, to, .. })| format!("{from:e} to {to:e}")),
    ("command", |(_, method, stiffness, _)| format!("`contact-vv solve CASE{}`", options(*method, *stiffness))),
];

/// Which element and algorithm to use from which initial stiffness, and which not.
pub fn recommendation(digests: &[Digest]) -> String {
    let points: usize = digests.iter().flat_map(|digest| &digest.wrong).map(|(_, [_, all])| all).sum();
    let of = |is_own: &dyn Fn(&Digest) -> bool| -> usize {
        digests.iter().filter(|digest| is_own(digest)).map(|digest| digest.predicted).sum()
    };
    let predicted = of(&|_| true);
    let reliable = reliable(digests);
    let served = |need: &'static str, serves: &dyn Fn(&Method) -> bool| {
        let (method, safe) = reliable.iter().find(|(method, _)| serves(method))?;
        Some((need, *method, Some(safe.best), *safe))
    };
    let fewest = served("fewest iterations of the paper's own rules", &|method| !method.is_accelerated());
    let constant = served("one factorisation only", &|method| method.algorithm == Iteration::Constant);
    let decades = |range: &Safe| (range.to / range.from).log10();
    let is_wider = |one: f64, other: f64| one > other && !same(one, other);
    let is_widest = |safe: &Safe| !reliable.iter().any(|(_, other)| is_wider(decades(other), decades(safe)));
    let any = reliable.iter().filter(|(_, safe)| is_widest(safe)).min_by_key(|(_, safe)| safe.iterations);
    let any = any.map(|(method, safe)| ("nothing known of the stiffness", *method, None, *safe));
    let rows: Vec<Advice> = any.into_iter().chain(fewest).chain(constant).collect();
    let mut text = format!(
        "Names are `element.algorithm.rule`: what is pressed, how its stiffness changes, and by which formula; `+` is \
        what the program adds to the paper's. From {points} runs over candidate surface, mesh, a body of revolution \
        and both paper scenes, {predicted} of them beside a prediction, {} of these on nodes, the only element of \
        which predicted iterations are judged; a run *ends right* that converges with p₀ and a within {} % of the \
        discrete solution:\n\n{}",
        of(&|digest| digest.method.element == Element::Node),
        100.0 * RIGHT,
        markdown::columns(&ADVICE, &rows)
    );
    let nowhere = digests.iter().filter(|digest| digest.safe.is_none());
    let failing = in_order(nowhere.map(|digest| (failures(digest), digest.method)));
    if !failing.is_empty() {
        let row = |(failures, methods): &([String; 2], Vec<Method>)| {
            let names: Vec<String> = methods.iter().map(|method| format!("`{method}`")).collect();
            let obstacles = in_order(methods.iter().map(|method| (obstacle(*method), method.rule.name())));
            let of_rules = |(why, rules): &(&str, Vec<&str>)| match obstacles.len() {
                1 => (*why).to_owned(),
                _ => format!("{}: {why}", rules[0]),
            };
            let why: Vec<String> = obstacles.iter().map(of_rules).collect();
            [vec![names.join(", ")], failures.to_vec(), vec![why.join("; ")]].concat()
        };
        let head = ["what fails", "runs that end right", "runs that do not, by plane", "why"].map(String::from);
        let rows: Vec<Vec<String>> = failing.iter().map(row).collect();
        let _ = write!(
            text,
            "\nFrom no initial stiffness do all runs of these end right, over all planes of the survey:\n\n{}",
            markdown::table(&head, &rows)
        );
    }
    text
}

/// What a rule has to overcome, by its own formula.
pub fn obstacle(method: Method) -> &'static str {
    match (method.algorithm, method.rule) {
        (Iteration::Varying, _) if method.is_accelerated() => {
            "points that part from the contact one by one: until those that press stand still, the rule goes alone"
        }
        (Iteration::Constant, _) if method.is_accelerated() => "which points press is found step by step",
        (Iteration::Varying, StiffnessRule::Secant) if method.element == Element::Node => {
            "an open point loses its force by w/g an iteration, and w/g → 1 at the contact edge"
        }
        (Iteration::Varying, StiffnessRule::Secant) => {
            "an alternating mode of Gauss points, which the bodies hardly feel: it dies out in iterations that grow \
            with the square of the number of edges"
        }
        (Iteration::Varying, StiffnessRule::Correction) => {
            "springs never softer than at the start, where p/w is small near the edge: from hard ones the correction \
            is too large, and points there swing"
        }
        (Iteration::Constant, StiffnessRule::Correction) => {
            "a closed point keeps 1 − k₀ C of an error at each iteration, nearly all where κ₀ is soft; an open one k₀ \
            C, nearly all where it is hard"
        }
        (Iteration::Constant, StiffnessRule::Secant) => "the spring asked for, p/g, has no bound where g → 0",
        (Iteration::Constant, StiffnessRule::Literal) => {
            "Σ Δk w is not the change of k w: what is missing stays in points that open"
        }
        (Iteration::Kinematic, StiffnessRule::Switching) => {
            "the alternating mode of Gauss points, which the halving law of nodes does not know"
        }
        (Iteration::Kinematic, StiffnessRule::Penalty) => {
            "the penetration p/k, which is its own law; soft springs let the contact reach the end of the candidate \
            surface"
        }
        _ => "not offered",
    }
}

/// How many runs of a method end right, and where the others are.
fn failures(digest: &Digest) -> [String; 2] {
    let [wrong, all] = digest.wrong.iter().fold([0, 0], |sum, (_, own)| [sum[0] + own[0], sum[1] + own[1]]);
    let places = digest.wrong.iter().filter(|(_, [wrong, _])| *wrong > 0);
    let places: Vec<String> =
        places.map(|(plane, [wrong, all])| format!("{}: {wrong} of {all}", plane.name())).collect();
    [format!("{} of {all}", all - wrong), places.join(", ")]
}

/// The κ₀ of a method, or that it need not be set.
fn told_stiffness(method: Method, stiffness: Option<f64>) -> String {
    match stiffness {
        None => "any".into(),
        Some(stiffness) if is_default(method, stiffness) => format!("{stiffness:e} (the default: nothing to set)"),
        Some(stiffness) => format!("{stiffness:e}"),
    }
}

/// Whether a method starts from a stiffness if nothing is said.
fn is_default(method: Method, stiffness: f64) -> bool {
    let taken = Formulation::accelerated(method.element, method.algorithm);
    taken.stiffness_unit == StiffnessUnit::Reference && same(taken.stiffness, stiffness)
}

/// The options of the command line that choose a method and where it starts, without those that stand if nothing is
/// said.
fn options(method: Method, stiffness: Option<f64>) -> String {
    let Method { element, algorithm, rule, acceleration } = method;
    let usual = Formulation::verification();
    let own = Formulation::accelerated(element, algorithm);
    let stiffness = stiffness.filter(|stiffness| !is_default(method, *stiffness));
    let options = [
        ("element", (element != usual.element).then(|| element.name().to_string())),
        ("algorithm", (algorithm != usual.algorithm).then(|| algorithm.name().to_string())),
        ("rule", (rule != own.rule).then(|| rule.name().to_string())),
        ("acceleration", (acceleration != own.acceleration).then(|| acceleration.name().to_string())),
        ("stiffness", stiffness.map(|stiffness| format!("{stiffness:e}"))),
    ];
    options.into_iter().filter_map(|(name, value)| Some(format!(" --{name} {}", value?))).collect()
}

/// The method to use, of those to which nothing is added; none where there is none of which every surveyed run ends
/// right.
pub fn recommended(digests: &[Digest]) -> Option<Method> {
    reliable(digests).into_iter().map(|(method, _)| method).find(|method| !method.is_accelerated())
}

/// Methods with a range, fewest iterations first; a penalty stops at a penetration of its own and is not among them.
fn reliable(digests: &[Digest]) -> Vec<(Method, Safe)> {
    let exact = digests.iter().filter(|digest| digest.method.rule != StiffnessRule::Penalty);
    let mut reliable: Vec<(Method, Safe)> =
        exact.filter_map(|digest| digest.safe.map(|safe| (digest.method, safe))).collect();
    reliable.sort_by_key(|(_, safe)| safe.best_iterations);
    reliable
}
