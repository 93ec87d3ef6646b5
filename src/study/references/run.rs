//! Reference answers beside 8-node cells.

use serde::Serialize;

use crate::accuracy::reference::{self, Answer, Known};
use crate::accuracy::{Barred, Subject, bars};
use crate::case::Case;
use crate::error::Error;
use crate::mesh::Resolution;
use crate::scene::Path;
use crate::solve::{Discretisation, Formulation, Run};

/// A scene.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Its case.
    pub case: String,
    /// Path of its contact.
    #[serde(skip)]
    pub path: Path,
    /// Degrees of freedom of the answer, of the other meshes, and of the 8-node cells.
    pub dofs: [usize; 5],
    /// What is known of it, and what 8-node cells say with the error bar of that; none of what has no bar there.
    pub known: Vec<(Known, Option<[f64; 2]>)>,
}

/// A scene on all meshes, in the units that its numbers are shown in.
pub fn numbers(case: &Case) -> Result<Numbers, Error> {
    let Answer { known, dofs: [answer, order, layers, cells] } = reference::answer(&case.scene)?;
    let made = Discretisation::of(case.scene.clone(), Resolution { refinement: 1, ..case.resolution })?;
    let run = Run::of(&made, &Formulation::verification())?;
    let barred = bars(&made, &run, &[])?;
    let row = |one: Known| {
        let (_, factor) = one.measured.unit(&case.scene.contact().path);
        let is_it =
            |barred: &&Barred| one.measured.quantity().is_some_and(|own| barred.subject == Subject::Contact(0, own));
        let eight = barred.all.iter().find(is_it).map(|of| [factor * of.value, factor * of.bar.total()]);
        (one.times(factor), eight)
    };
    let dofs = [answer, order, layers, cells, run.dofs];
    Ok(Numbers {
        case: case.name.clone(),
        path: case.scene.contact().path,
        dofs,
        known: known.into_iter().map(row).collect(),
    })
}
