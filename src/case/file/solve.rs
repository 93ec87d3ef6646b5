//! `[solve]`: how the scene is solved.

use crate::algorithm::{Acceleration, Criterion, Spring, StiffnessRule, StiffnessUnit};
use crate::case::file::form::Form::{Count, Number, Own, Table, Text};
use crate::case::file::form::{Form, may};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::solve::{Element, Formulation, Iteration};

/// `[solve]`; `max-steps` was the name of `max-iterations`.
pub(super) const SOLVE: Form = Own(&[KEYS], |value| {
    KEYS.check(value)?;
    match ["max-iterations", "max-steps"].map(|key| value.get_ref().get(key)) {
        [Some(_), Some(_)] => Err((value.span(), "duplicate field `max-iterations`".into())),
        _ => Ok(()),
    }
});

const KEYS: Form = Table(&[
    may("element", Text),
    may("algorithm", Text),
    may("rule", Text),
    may("bound", Number),
    may("spring", Text),
    may("stiffness", Number),
    may("layer-thickness", Number),
    may("acceleration", Text),
    may("increments", Count),
    may("criterion", Text),
    may("tolerance", Number),
    may("max-iterations", Count),
    may("max-steps", Count),
]);

/// What a table says; what it leaves out is the program's own.
pub(super) fn formulation(table: Option<Value>) -> Result<Formulation, Error> {
    let get = |key| table.and_then(|table| table.get(key));
    let element = named(get("element"), "contact element", Element::ALL, Element::name)?.unwrap_or(Element::Node);
    let algorithm = named(get("algorithm"), "algorithm", Iteration::ALL, Iteration::name)?;
    let rule = named(get("rule"), "rule", StiffnessRule::ALL, StiffnessRule::name)?;
    let acceleration = named(get("acceleration"), "acceleration", Acceleration::ALL, Acceleration::name)?;
    let mut formulation = Formulation::with(element, algorithm.unwrap_or(Iteration::Kinematic), rule, acceleration);
    if let Some(spring) = named(get("spring"), "spring", Spring::ALL, Spring::name)? {
        formulation = formulation.with_springs(spring, acceleration);
    }
    if let Some(bound) = get("bound") {
        formulation.leeway.bound = bound.factor()?;
    }
    if let Some(thickness) = get("layer-thickness") {
        formulation.layer_thickness = thickness.positive()?;
    }
    if let Some(stiffness) = get("stiffness") {
        formulation.stiffness = stiffness.positive()?;
        formulation.stiffness_unit = StiffnessUnit::Reference;
    }
    let settings = &mut formulation.settings;
    settings.criterion =
        named(get("criterion"), "criterion", Criterion::ALL, Criterion::name)?.unwrap_or(Criterion::Error);
    if let Some(tolerance) = get("tolerance") {
        settings.tolerance = tolerance.positive()?;
    }
    if let Some(increments) = get("increments") {
        settings.increments = count("increments", increments, 1000)?;
    }
    if let Some(most) = get("max-iterations").or(get("max-steps")) {
        settings.max_iterations = count("max-iterations", most, 1_000_000)?;
    }
    Ok(formulation)
}

/// What a name stands for; none where it is left out.
fn named<T: Copy, const N: usize>(
    given: Option<Value>,
    what: &str,
    all: [T; N],
    name: impl Fn(T) -> &'static str,
) -> Result<Option<T>, Error> {
    given.map(|given| given.choice(what, &all.map(|one| (name(one), one)))).transpose()
}

fn count(key: &str, given: Value, most: usize) -> Result<usize, Error> {
    match given.read() {
        count if (1..=most).contains(&count) => Ok(count),
        count => Err(given.refused(format!("`{key}` is {count}"), format!("give 1 to {most}"))),
    }
}
