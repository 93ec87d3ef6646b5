//! What is handed over to a code, and what it answers.

use std::collections::BTreeMap;

use contact_vv::error::Error;
use contact_vv::oracle::cross_code::independent::Script;
use contact_vv::oracle::cross_code::revolution::Answer;
use contact_vv::oracle::cross_code::{Code, DiscreteAnswer, DiscreteProblem, PhysicalAnswer, PhysicalScene};
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::interpreter::with_python;

/// Solves our discrete problem by another code.
pub fn discrete(code: Code, problem: &DiscreteProblem) -> Result<DiscreteAnswer, Error> {
    let problem = problem.clone();
    with_python(move |py| {
        let answer = py.import(module(code))?.call_method1("solve", (handed_over(py, &problem)?,))?;
        let (size, stiffnesses) = (2 * problem.points.len(), problem.kappa.len());
        let table = |name: &str, count: usize, length: Option<usize>| {
            let rows = rows(&answer.get_item(name)?)?;
            let fits = rows.len() == count && rows.iter().all(|row| length.is_none_or(|length| row.len() == length));
            if fits {
                Ok(rows)
            } else {
                Err(PyValueError::new_err(format!("`{name}` has another shape than asked for")))
            }
        };
        let load = answer.get_item("load")?.extract::<PyReadonlyArray1<'_, f64>>()?.as_array().to_vec();
        if load.len() != size {
            return Err(PyValueError::new_err(format!("`load` has {} components instead of {size}", load.len())));
        }
        Ok(DiscreteAnswer {
            products: table("products", problem.vectors.len(), Some(size))?,
            load,
            pressure: table("pressure", stiffnesses, None)?,
            displacement: table("displacement", stiffnesses, Some(size))?,
        })
    })
}

/// Solves a scene on the mesh of a level by a script that shares nothing.
pub fn independent(script: Script, scene: &PhysicalScene, level: usize) -> Result<PhysicalAnswer, Error> {
    let scene = scene.clone();
    with_python(move |py| {
        let given = given(py, &scene)?;
        physical(&py.import(script.module())?.call_method1("solve", (given, level, script.method()))?)
    })
}

/// Solves a scene of bodies of revolution on the mesh of a level by a script of `oracles/revolution`, by the name of its module.
pub fn revolution(module: &str, scene: &PhysicalScene, level: usize) -> Result<Answer, Error> {
    let (module, scene) = (module.to_owned(), scene.clone());
    with_python(move |py| {
        let answer = py.import(module)?.call_method1("solve", (given(py, &scene)?, level))?;
        Ok(Answer { physical: physical(&answer)?, approach: answer.get_item("approach")?.extract()? })
    })
}

/// The numbers of a scene.
fn given<'py>(py: Python<'py>, scene: &PhysicalScene) -> PyResult<Bound<'py, PyDict>> {
    let given = PyDict::new(py);
    given.set_item("case", &scene.case)?;
    for (name, number) in &scene.numbers {
        given.set_item(name, number)?;
    }
    given.set_item("stations", PyArray1::from_slice(py, &scene.stations))?;
    Ok(given)
}

fn physical(answer: &Bound<'_, PyAny>) -> PyResult<PhysicalAnswer> {
    Ok(PhysicalAnswer {
        half_width: answer.get_item("half_width")?.extract()?,
        peak: answer.get_item("peak")?.extract()?,
        resultant: answer.get_item("resultant")?.extract()?,
        pressure: answer.get_item("pressure")?.extract::<PyReadonlyArray1<'_, f64>>()?.as_array().to_vec(),
        dofs: answer.get_item("dofs")?.extract()?,
    })
}

/// Versions of Python and of the packages, by name.
pub fn versions() -> Result<BTreeMap<String, String>, Error> {
    with_python(|py| py.import("environment")?.call_method0("versions")?.extract())
}

fn module(code: Code) -> String {
    format!("discrete_{}", code.name().replace('-', "_"))
}

fn handed_over<'py>(py: Python<'py>, problem: &DiscreteProblem) -> PyResult<Bound<'py, PyDict>> {
    let given = PyDict::new(py);
    given.set_item("plane", problem.plane)?;
    given.set_item("thickness", problem.thickness)?;
    let points: Vec<Vec<f64>> = problem.points.iter().map(|point| point.to_vec()).collect();
    given.set_item("points", PyArray2::from_vec2(py, &points)?)?;
    given.set_item("young", PyArray1::from_slice(py, &problem.young))?;
    given.set_item("poisson", PyArray1::from_slice(py, &problem.poisson))?;
    given.set_item("tied_force", problem.tied_force)?;
    given.set_item("traction", PyArray1::from_slice(py, &problem.traction))?;
    given.set_item("hertz_load", problem.hertz_load)?;
    given.set_item("profile", problem.profile)?;
    given.set_item("radius", problem.radius)?;
    given.set_item("clearance", problem.clearance)?;
    given.set_item("arc", problem.arc)?;
    given.set_item("length", problem.length)?;
    given.set_item("kappa", PyArray1::from_slice(py, &problem.kappa))?;
    given.set_item("vectors", PyArray2::from_vec2(py, &problem.vectors)?)?;
    let held: Vec<Vec<usize>> = problem.held.iter().map(|pair| pair.to_vec()).collect();
    for (name, table) in [
        ("cells", &problem.cells),
        ("held", &held),
        ("load_edges", &problem.load_edges),
        ("contact_first", &problem.contact_first),
        ("contact_second", &problem.contact_second),
    ] {
        given.set_item(name, indices(py, table)?)?;
    }
    for (name, list) in [("body", &problem.body), ("tied", &problem.tied)] {
        given.set_item(name, PyArray1::from_iter(py, list.iter().map(|&index| index as i64)))?;
    }
    Ok(given)
}

/// A table of indices as an integer array; an empty one has two columns.
fn indices<'py>(py: Python<'py>, table: &[Vec<usize>]) -> PyResult<Bound<'py, PyArray2<i64>>> {
    if table.is_empty() {
        return Ok(PyArray2::zeros(py, [0, 2], false));
    }
    let signed: Vec<Vec<i64>> = table.iter().map(|row| row.iter().map(|&index| index as i64).collect()).collect();
    Ok(PyArray2::from_vec2(py, &signed)?)
}

fn rows(array: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<f64>>> {
    let array: PyReadonlyArray2<'_, f64> = array.extract()?;
    Ok(array.as_array().outer_iter().map(|row| row.to_vec()).collect())
}
