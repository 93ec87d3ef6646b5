//! One parameter pushed until something fails: what was found at every value, and how the page says it.

use std::borrow::Cow;

use crate::case::{Check, Judged, Quantity, Reference, notes};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::largest;
use crate::mesh::{Order, Resolution};
use crate::scene::{ReferenceValues, Scene};
use crate::solve::run::{Errors, Run};
use crate::solve::{Discretisation, Formulation};

/// Cells of four and of eight nodes.
pub(super) const ORDERS: [Order; 2] = [Order::Linear, Order::Quadratic];

/// A row of the table of limits, its checks, and the values behind it.
#[derive(Clone, Debug)]
pub struct Limit {
    /// What is pushed.
    pub pushed: &'static str,
    /// From where to where.
    pub range: String,
    /// Where it began to fail.
    pub onset: String,
    /// What the program said there.
    pub seen: String,
    /// What to do instead.
    pub instead: String,
    /// The checks.
    pub judged: Vec<Judged>,
    /// A folded table of the values tried, one by one; empty where the row says all.
    pub table: String,
}

/// What was found at every value of a parameter, in some ways each: with every kind of cells, on every mesh, by every
/// algorithm.
pub(super) struct Push<T, const WAYS: usize> {
    /// Name of the parameter where its onset is told.
    pub name: &'static str,
    /// The values, from where it holds to where it fails.
    pub tried: Vec<(f64, [T; WAYS])>,
}

impl<T, const WAYS: usize> Push<T, WAYS> {
    /// Every value in every way.
    pub fn of<W: Copy>(
        name: &'static str,
        values: &[f64],
        ways: [W; WAYS],
        at: impl Fn(f64, W) -> Result<T, Error>,
    ) -> Result<Self, Error> {
        let in_all = |&value: &f64| {
            let found = ways.into_iter().map(|way| at(value, way)).collect::<Result<Vec<T>, Error>>()?;
            Ok((value, found.try_into().ok().expect("one for each way")))
        };
        Ok(Self { name, tried: values.iter().map(in_all).collect::<Result<_, Error>>()? })
    }

    /// What was found, value by value.
    pub fn all(&self) -> impl DoubleEndedIterator<Item = &T> {
        self.tried.iter().flat_map(|(_, found)| found)
    }

    /// What was found at the last value, where it fails.
    pub fn last(&self) -> &[T; WAYS] {
        &self.tried.last().expect("a value that is tried").1
    }

    /// The first and the last value.
    pub fn range(&self, name: &str) -> String {
        format!("{name} = {} … {}", number(self.tried[0].0), number(self.tried[self.tried.len() - 1].0))
    }

    /// The first value from which on a criterion holds, and the one before it.
    pub fn onset(&self, holds: impl Fn(&[T; WAYS]) -> bool) -> String {
        let (name, value) = (self.name, |index: usize| number(self.tried[index].0));
        match self.tried.iter().position(|(_, found)| holds(found)) {
            None => format!("none up to {name} = {}", value(self.tried.len() - 1)),
            Some(0) => format!("from {name} = {} on, the first tried", value(0)),
            Some(i) => format!("between {name} = {} and {}", value(i - 1), value(i)),
        }
    }

    /// The last value before the first at which a criterion holds; NaN where that is the first of all.
    pub fn last_before(&self, holds: impl Fn(&[T; WAYS]) -> bool) -> f64 {
        self.tried.iter().take_while(|(_, found)| !holds(found)).last().map_or(f64::NAN, |(value, _)| *value)
    }

    /// The folded table of all values.
    pub fn table(&self, title: &str, columns: &[Column<(f64, [T; WAYS])>]) -> String {
        folded(title, &self.tried, columns)
    }
}

/// A folded table.
pub(super) fn folded<T>(title: &str, rows: &[T], columns: &[Column<T>]) -> String {
    markdown::folded(title, &markdown::columns(columns, rows), false)
}

/// A run, and the values of the scene that it is held against.
pub(super) struct Solved {
    /// Half-width and peak of the closed form.
    pub reference: ReferenceValues,
    /// The run.
    pub run: Run,
}

impl Solved {
    /// The verification formulation on a discretisation.
    pub fn on(discretisation: &Discretisation) -> Result<Self, Error> {
        Self::by(&Formulation::verification(), discretisation)
    }

    /// A formulation on a discretisation.
    pub fn by(formulation: &Formulation, discretisation: &Discretisation) -> Result<Self, Error> {
        Ok(Self { reference: discretisation.scene.reference, run: Run::of(discretisation, formulation)? })
    }

    /// Relative errors of p₀ and a against the closed form; NaN where the run did not converge.
    pub fn errors(&self) -> Errors {
        let converged = self.run.solution.converged();
        let error = |found: f64, wanted: f64| if converged { found / wanted - 1.0 } else { f64::NAN };
        let measures = self.run.measures();
        Errors {
            peak: error(measures.peak.pressure, self.reference.pressure),
            half_width: error(measures.second_moment_width, self.reference.length),
        }
    }

    /// Whether p₀ or a is off by more than a bound, or no number.
    pub fn is_off(&self, bound: f64) -> bool {
        exceeds(self.errors().largest(), bound)
    }

    /// The same errors as percentages.
    pub fn percents(&self) -> [String; 2] {
        let Errors { peak, half_width } = self.errors();
        [peak, half_width].map(percent)
    }

    /// What the user sees: how it ended, with what must be known before it is quoted.
    pub fn seen(&self) -> String {
        let (outcome, notes) = (self.run.solution.outcome, notes::of(&self.run, 0));
        if notes.is_empty() { outcome.to_string() } else { format!("{outcome}, note: {}", notes.join("; ")) }
    }
}

/// The check of an error against Hertz.
pub(super) fn against_hertz(
    quantity: impl Into<Quantity>,
    error: f64,
    tolerance: f64,
    because: impl Into<Cow<'static, str>>,
) -> Judged {
    Check::error(quantity, Reference::analytic("Hertz", 0.0), tolerance, because).judge(error)
}

/// A scene on a mesh of `elements` per half-width.
pub(super) fn meshed(scene: Scene, elements: usize, order: Order) -> Result<Discretisation, Error> {
    Discretisation::of(scene, Resolution { elements, refinement: 0, order })
}

/// The error that a result must be; an error that says so where it is none.
pub(super) fn refused<T>(result: Result<T, Error>, what: &str) -> Result<Error, Error> {
    match result {
        Err(error) => Ok(error),
        Ok(_) => Err(Error::at("limits", format!("{what} was accepted"), "it shall be refused")),
    }
}

/// What the user sees of an error.
pub(super) fn told(error: &Error) -> String {
    format!("error: {}", error.finding())
}

/// What the user sees of an error that may not have come, and what remedies it.
pub(super) fn told_with_remedy(error: Option<&Error>) -> [String; 2] {
    error.map_or(["no error".into(), "–".into()], |error| [told(error), error.remedy.clone()])
}

/// The largest error of p₀ and a of some runs; NaN if any is.
pub(super) fn worst<'a>(runs: impl IntoIterator<Item = &'a Solved>) -> f64 {
    largest(runs.into_iter().map(|solved| solved.errors().largest()))
}

/// Whether an error is above a bound, or no number.
pub(super) fn exceeds(error: f64, bound: f64) -> bool {
    error.is_nan() || error > bound
}

/// A fraction as a percentage of two decimals.
pub(super) fn percent(x: f64) -> String {
    match x {
        x if x.is_nan() => "–".into(),
        x if x.abs() < 1e-4 => "< 0.01 %".into(),
        x => format!("{:+.2} %", 100.0 * x),
    }
}

/// The size of a fraction as a percentage.
pub(super) fn size(x: f64) -> String {
    if x >= 0.1 { format!("{:.0} %", 100.0 * x) } else { format!("{:.2} %", 100.0 * x) }
}

/// Below a bound, or the size of what is not; NaN is not.
pub(super) fn within(error: f64, bound: f64) -> String {
    if error <= bound { format!("below {bound:e}") } else { format!("{error:.0e}") }
}

/// A number as people write it: eight digits, powers of ten where it is large or small.
pub(super) fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.7e}").parse().unwrap_or(x);
    if x.abs() > 0.0 && !(1e-3..1e4).contains(&x.abs()) { format!("{rounded:e}") } else { rounded.to_string() }
}
