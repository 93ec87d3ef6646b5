//! What is handed over to a code, and what it answers, both as JSON.

use std::collections::BTreeMap;

use contact_vv::error::Error;
use contact_vv::oracle::cross_code::independent::Script;
use contact_vv::oracle::cross_code::revolution::Answer;
use contact_vv::oracle::cross_code::{Code, DiscreteAnswer, DiscreteProblem, PhysicalAnswer, PhysicalScene};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::interpreter::with_python;

/// Solves our discrete problem by another code.
pub fn discrete(code: Code, problem: &DiscreteProblem) -> Result<DiscreteAnswer, Error> {
    let (size, vectors, stiffnesses) = (2 * problem.points.len(), problem.vectors.len(), problem.kappa.len());
    let fits = move |DiscreteAnswer { products, load, pressure, displacement }: &DiscreteAnswer| {
        let are_whole = products.iter().chain(displacement).chain([load]).all(|vector| vector.len() == size);
        are_whole && [products, pressure, displacement].map(Vec::len) == [vectors, stiffnesses, stiffnesses]
    };
    solved(format!("discrete_{}", code.name().replace('-', "_")), json!(problem), vec![], fits)
}

/// Solves a scene on the mesh of a level by a script that shares nothing.
pub fn independent(script: Script, scene: &PhysicalScene, level: usize) -> Result<PhysicalAnswer, Error> {
    solved(script.module().into(), given(scene), vec![json!(level), json!(script.method())], |_| true)
}

/// Solves a scene of bodies of revolution on the mesh of a level by a script of `oracles/revolution`, by the name of
/// its module.
pub fn revolution(module: &str, scene: &PhysicalScene, level: usize) -> Result<Answer, Error> {
    solved(module.into(), given(scene), vec![json!(level)], |_| true)
}

/// Case, numbers and stations of a scene, side by side.
fn given(scene: &PhysicalScene) -> Value {
    let mut given = json!(scene.numbers);
    (given["case"], given["stations"]) = (json!(scene.case), json!(scene.stations));
    given
}

/// What the function `solve` of a module answers to what is given, with arrays for its lists, and to what else it is
/// asked; refused where the answer does not fit.
fn solved<T: DeserializeOwned + Send + 'static>(
    module: String,
    given: Value,
    more: Vec<Value>,
    fits: impl Fn(&T) -> bool + Send + 'static,
) -> Result<T, Error> {
    with_python(move |py| {
        let (json, apart) = (py.import("json")?, py.import("apart")?);
        let read = |value: &Value| json.call_method1("loads", (value.to_string(),));
        let given = read(&given)?.cast_into::<PyDict>()?;
        for (name, list) in given.copy()?.iter().filter(|(_, value)| value.is_instance_of::<PyList>()) {
            given.set_item(name, apart.call_method1("array", (list,))?)?;
        }
        let asked = std::iter::once(Ok(given.into_any())).chain(more.iter().map(read));
        let asked = PyTuple::new(py, asked.collect::<PyResult<Vec<_>>>()?)?;
        let answer = py.import(&*module)?.call_method1("solve", asked)?;
        let text: String = json.call_method1("dumps", (apart.call_method1("plain", (answer,))?,))?.extract()?;
        let answer = serde_json::from_str(&text).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let other = || PyValueError::new_err(format!("`{module}` answers in another shape than asked for"));
        if fits(&answer) { Ok(answer) } else { Err(other()) }
    })
}

/// Versions of Python and of the packages, by name.
pub fn versions() -> Result<BTreeMap<String, String>, Error> {
    with_python(|py| py.import("environment")?.call_method0("versions")?.extract())
}
