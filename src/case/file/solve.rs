//! `[solve]`: how the scene is solved.

use crate::algorithm::{Acceleration, Criterion, Spring, StiffnessRule, StiffnessUnit};
use crate::case::file::form::Form::{Count, Number, Own, Table, Word};
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
    may("element", Word(|| Element::NAMES.into())).told("contact element; node by default"),
    may("algorithm", Word(|| Iteration::NAMES.into())).told("how springs change; kinematic by default"),
    may("rule", Word(|| StiffnessRule::NAMES.into())).told("by which formula; the algorithm's own by default"),
    may("bound", Number).told("largest factor on a stiffness in an iteration; inf is none"),
    may("spring", Word(|| Spring::NAMES.into())).told("what has a stiffness of its own; point by default"),
    may("stiffness", Number).told("initial spring stiffness in units of E*/l"),
    may("layer-thickness", Number).told("of the layer element, over the length of its edge"),
    may("acceleration", Word(|| Acceleration::NAMES.into())).told("what is added to the algorithm"),
    may("increments", Count).told("load increments; 1 by default"),
    may("criterion", Word(|| Criterion::NAMES.into())).told("what shall fall below the tolerance; error by default"),
    may("tolerance", Number).told("1e-3 by default"),
    may("max-iterations", Count).told("iterations after which it ends without convergence"),
    may("max-steps", Count),
]);

/// What a table says; what it leaves out is the program's own.
pub(super) fn formulation(table: Value) -> Result<Formulation, Error> {
    let element = named(table.get("element"), "contact element", Element::ALL, Element::name)?.unwrap_or(Element::Node);
    let algorithm = named(table.get("algorithm"), "algorithm", Iteration::ALL, Iteration::name)?;
    let rule = named(table.get("rule"), "rule", StiffnessRule::ALL, StiffnessRule::name)?;
    let acceleration = named(table.get("acceleration"), "acceleration", Acceleration::ALL, Acceleration::name)?;
    let mut formulation = Formulation::with(element, algorithm.unwrap_or(Iteration::Kinematic), rule, acceleration);
    if let Some(spring) = named(table.get("spring"), "spring", Spring::ALL, Spring::name)? {
        formulation = formulation.with_springs(spring, acceleration);
    }
    if let Some(bound) = table.get("bound") {
        formulation.leeway.bound = bound.factor()?;
    }
    if let Some(thickness) = table.get("layer-thickness") {
        formulation.layer_thickness = thickness.positive()?;
    }
    if let Some(stiffness) = table.get("stiffness") {
        formulation.stiffness = stiffness.positive()?;
        formulation.stiffness_unit = StiffnessUnit::Reference;
    }
    let settings = &mut formulation.settings;
    settings.criterion =
        named(table.get("criterion"), "criterion", Criterion::ALL, Criterion::name)?.unwrap_or(Criterion::Error);
    if let Some(tolerance) = table.get("tolerance") {
        settings.tolerance = tolerance.positive()?;
    }
    if let Some(increments) = table.get("increments") {
        settings.increments = increments.count(1000, "")?;
    }
    if let Some(most) = table.first(["max-iterations", "max-steps"]) {
        settings.max_iterations = most.called("max-iterations").count(1_000_000, "")?;
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
