//! Other scenes, each on a mesh of which five digits are asked.

use rayon::prelude::*;
use serde::Serialize;

use crate::accuracy::Quantity;
use crate::case::Case;
use crate::case::library::PinPlate;
use crate::checkout::root;
use crate::error::Error;
use crate::measure::relative_error;
use crate::mesh::Order;
use crate::scene::Scene;
use crate::solve::{Fitted, Formulation};
use crate::study::random::{Family, Site};

/// Relative error that is asked of peak and second-moment width, and the most degrees of freedom.
pub const ASKED: (f64, usize) = (1e-5, 3000);

/// Mesh whose numbers are taken for right where no closed form is.
pub const BEST: Fitted = Fitted { order: Order::Octic, layers: 3 };
/// Move of an end, over the half-width, at which it is at rest.
const AT_REST: f64 = 1e-5;

/// A scene on a mesh.
#[derive(Clone, Debug, Serialize)]
pub struct Elsewhere {
    /// The scene.
    pub scene: String,
    /// Order and layers of the mesh.
    pub fitted: Fitted,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Relative error of the peak pressure.
    pub peak: f64,
    /// Relative error of the second-moment width.
    pub half_width: f64,
    /// Whether a closed form says so, and not the best mesh.
    pub exact: bool,
}

/// A scene, its mesh, and peak and second-moment width where a closed form has them.
struct Asked {
    name: String,
    scene: Scene,
    fitted: Fitted,
    truth: Option<[f64; 2]>,
}

/// All scenes.
pub(super) fn numbers() -> Result<Vec<Elsewhere>, Error> {
    let mesh = |order, layers| Fitted { order, layers };
    let pin = |degrees: f64| Asked {
        name: format!("pin in a plate, ε = {degrees}°"),
        scene: PinPlate::of_half_angle(degrees).scene(),
        fitted: mesh(Order::Quintic, 2),
        truth: None,
    };
    let drawn = |file: &str, name: &str, fitted| {
        let case = Case::read(&root().join("tests/cases").join(file))?;
        Ok::<_, Error>(Asked { name: name.into(), scene: case.scene, fitted, truth: None })
    };
    let sample = Site { family: Family::Polynomial, number: OFF_CENTRE }.sample()?;
    let truth = [Quantity::PeakPressure, Quantity::SecondMomentWidth].map(|quantity| sample.truth(0, quantity));
    let name = "block under a pressure with its peak off the centre".into();
    let off_centre = Asked { name, scene: sample.scene, fitted: mesh(Order::Octic, 3), truth: Some(truth) };
    let asked = vec![
        pin(30.0),
        pin(60.0),
        pin(80.0),
        drawn("two-cylinders.toml", "two cylinders of different moduli", mesh(Order::Quintic, 2))?,
        drawn("eccentric-to-accuracy.toml", "block under an eccentric load", mesh(Order::Sextic, 2))?,
        off_centre,
    ];
    asked.into_par_iter().map(|one| one.solved()).collect()
}

/// A scene of the random ones whose peak lies off the centre of the contact.
const OFF_CENTRE: usize = 90003;

impl Asked {
    fn solved(self) -> Result<Elsewhere, Error> {
        let on = |fitted: Fitted| {
            let answer = fitted.solve_with_ends(&self.scene, &Formulation::verification(), AT_REST)?;
            let measures = answer.run.measures();
            let found = match answer.run.solution.converged() {
                true => [measures.peak.pressure, measures.second_moment_width],
                false => [f64::NAN; 2],
            };
            Ok::<_, Error>((answer.run.dofs, found))
        };
        let (dofs, found) = on(self.fitted)?;
        let right = self.truth.map_or_else(|| on(BEST).map(|(_, found)| found), Ok)?;
        let [peak, half_width] = [0, 1].map(|k| relative_error(found[k], right[k]));
        let exact = self.truth.is_some();
        Ok(Elsewhere { scene: self.name, fitted: self.fitted, dofs, peak, half_width, exact })
    }
}
