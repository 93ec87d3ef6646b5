//! Cells of high order fitted to the end of the contact: how many digits of peak, second-moment width and half-width
//! they give, for how many degrees of freedom.

use rayon::prelude::*;

use crate::case::library::{Indented, PinPlate, TruncatedHertz};
use crate::case::{self, Case, Check, Judged, Reference};
use crate::checkout::root;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::{Quantity, larger, relative_error};
use crate::mesh::Order;
use crate::scene::Scene;
use crate::solve::{Fitted, Formulation, Run};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::random::{Family, Site};

/// What is asked: digits that order and layers are chosen for, relative error of peak and second-moment width.
pub const ASKED: [(usize, f64); 3] = [(4, 1e-4), (5, 1e-5), (6, 1e-6)];
/// The same of the truncated sphere.
pub const ASKED_OF_REVOLUTION: [(usize, f64); 4] = [(3, 1e-3), ASKED[0], ASKED[1], ASKED[2]];
/// Times that error within which the half-width is: it is the place of the mesh line, which the search leaves before
/// peak and second-moment width, which depend on it in second order, are at rest.
pub const OF_END: f64 = 3.0;
/// Relative error that is asked of other scenes.
const ASKED_ELSEWHERE: f64 = 1e-5;
/// Fitted meshes of which nothing is asked.
const OTHERS: [Fitted; 2] = [fitted(Order::Quartic, 1), fitted(Order::Quintic, 1)];
/// Half-widths of the loads over that which block and candidates are drawn for.
pub const LOADS: [f64; 8] = [1.0, 0.97, 0.94, 0.91, 0.89, 0.88, 0.87, 0.85];
/// Part of a number that rounding decides.
const ROUND_OFF: f64 = 1e-9;
/// Mesh whose numbers are taken for right where no closed form is.
const BEST: Fitted = fitted(Order::Octic, 3);
/// Move of an end, over the half-width, at which it is at rest on meshes of other scenes.
const AT_REST: f64 = 1e-5;
/// A scene of the random ones whose peak lies off the centre of the contact.
const OFF_CENTRE: usize = 90003;

const fn fitted(order: Order, layers: usize) -> Fitted {
    Fitted { order, layers }
}

/// All meshes.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// Of truncated Hertz, each under the worst of all loads.
    pub meshes: Vec<Mesh>,
    /// The same of the truncated sphere.
    pub revolved: Vec<Mesh>,
    /// Of other scenes, and their names.
    pub scenes: Vec<(String, Mesh)>,
}

impl Study for Numbers {
    const NAME: &'static str = "fitted";
    const ABOUT: About = About {
        title: "Meshes fitted to the contact",
        asked: "How many degrees of freedom an accuracy costs where cells of high order end with the contact.",
        limits: "Order and layers of the other scenes are chosen by hand, knowing what they give.",
    };

    fn plan() -> Vec<Planned<Self>> {
        vec![Planned::new("fitted to the contact, truncated hertz", "node.kinematic", numbers)]
    }

    /// The checks; a mesh that was not solved has no number that could pass.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let asked = |meshes: &[Mesh], asked: &[(usize, f64)], body: &str, hertz: &'static str| {
            let own = asked.iter().flat_map(|&(digits, error)| {
                let fitted = Fitted::of_digits(digits);
                let mesh = meshes.iter().find(|mesh| mesh.fitted == fitted);
                let at = format!("{body}order {}, layers {}", fitted.order.number(), fitted.layers);
                let because = "what the order and the layers are chosen for; the worst of all loads";
                of(mesh, &at, Reference::analytic(hertz, 0.0), (error, because))
            });
            own.collect::<Vec<_>>()
        };
        let own = asked(&self.meshes, &ASKED, "", "Hertz").into_iter();
        let revolved = asked(&self.revolved, &ASKED_OF_REVOLUTION, "truncated sphere, ", "Hertz's sphere");
        let elsewhere = self.scenes.iter().flat_map(|(scene, mesh)| {
            let reference = match mesh.exact {
                true => Reference::analytic("its closed form", 0.0),
                false => Reference::own("cells of order 8, three layers", 0.0),
            };
            let because = "five digits of a contact that no mesh knew the ends of";
            // Of peak and second-moment width.
            of(Some(mesh), scene, reference, (ASKED_ELSEWHERE, because)).into_iter().take(2)
        });
        Ok(own.chain(revolved).chain(elsewhere).collect())
    }

    /// A row a mesh.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let scenes = findings.iter().flat_map(|found| &found.numbers.scenes);
        Ok(format!(
            include_str!("fitted.md"),
            loads = LOADS.len(),
            of_end = OF_END,
            meshes = markdown::columns(&MESHES, findings.iter().flat_map(|found| &found.numbers.meshes)),
            revolved = markdown::columns(&MESHES, findings.iter().flat_map(|found| &found.numbers.revolved)),
            dofs = scenes.map(|(_, mesh)| mesh.dofs).max().unwrap_or_default()
        ) + "\n")
    }
}

/// A mesh, and what it gives.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Order of its cells, and their layers.
    pub fitted: Fitted,
    /// Degrees of freedom, the most under any load.
    pub dofs: usize,
    /// Those of all meshes that were solved on the way, with its own.
    pub in_all: usize,
    /// Relative errors of peak pressure, second-moment width and half-width; NaN where a run did not converge.
    pub errors: [f64; 3],
    /// Whether a closed form says so, and not the best mesh.
    pub exact: bool,
}

fn numbers() -> Result<Numbers, Error> {
    let asked = ASKED.map(|(digits, ..)| Fitted::of_digits(digits));
    let on_all = |drawn: Drawn| -> Result<Vec<Mesh>, Error> {
        OTHERS.into_iter().chain(asked).map(|fitted| worst(fitted, drawn)).collect()
    };
    let plane = |factor: f64| {
        let drawn = TruncatedHertz::default().under(factor);
        let hertz = drawn.closed_form();
        (drawn.scene(), [hertz.peak_pressure(), hertz.half_width(), hertz.half_width()])
    };
    let of_revolution = |factor: f64| {
        let full = Indented::by_sphere(TruncatedHertz::default().a_over_r);
        let drawn = full.contact.radius;
        let block = Indented { drawn, ..Indented::by_sphere(factor * TruncatedHertz::default().a_over_r) };
        (block.scene(), [block.contact.peak_pressure(), block.contact.radius, block.contact.radius])
    };
    Ok(Numbers { meshes: on_all(plane)?, revolved: on_all(of_revolution)?, scenes: elsewhere()? })
}

/// A scene under a part of the load that it is drawn for, by its half-width, with its peak pressure and both widths,
/// which are one there.
type Drawn = fn(f64) -> (Scene, [f64; 3]);

/// A mesh under the worst of all loads.
fn worst(fitted: Fitted, drawn: Drawn) -> Result<Mesh, Error> {
    let all =
        LOADS.into_par_iter().map(|factor| solved(fitted, drawn(factor))).collect::<Result<Vec<Mesh>, Error>>()?;
    let worse = |one: Mesh, other: Mesh| Mesh {
        dofs: one.dofs.max(other.dofs),
        in_all: one.in_all.max(other.in_all),
        errors: [0, 1, 2].map(|k| larger(one.errors[k], other.errors[k])),
        ..one
    };
    Ok(all.into_iter().reduce(worse).expect("there are loads"))
}

/// A mesh under one load.
fn solved(fitted: Fitted, (scene, truth): (Scene, [f64; 3])) -> Result<Mesh, Error> {
    let answer = fitted.solve(&scene, &Formulation::verification())?;
    let errors = errors(&answer.run, truth).map(|error| (error / ROUND_OFF).round() * ROUND_OFF);
    let in_all = answer.tried.iter().map(|one| one.dofs).sum();
    Ok(Mesh { fitted, dofs: answer.run.dofs, in_all, errors, exact: true })
}

/// Other scenes, each on a mesh of which five digits are asked.
fn elsewhere() -> Result<Vec<(String, Mesh)>, Error> {
    let pin = |degrees: f64| {
        let scene = PinPlate::of_half_angle(degrees).scene();
        (format!("pin in a plate, ε = {degrees}°"), scene, fitted(Order::Quintic, 2), None)
    };
    let drawn = |file: &str| Case::read(&root().join("tests/cases").join(file)).map(|case| case.scene);
    let cylinders = drawn("two-cylinders.toml")?;
    let eccentric = drawn("eccentric-to-accuracy.toml")?;
    let off_centre = Site { family: Family::Polynomial, number: OFF_CENTRE }.sample()?;
    let truth = QUANTITIES.map(|quantity| off_centre.truth(0, &quantity));
    let peak_off = "block under a pressure with its peak off the centre";
    let all: Vec<(String, Scene, Fitted, Option<[f64; 3]>)> = vec![
        pin(30.0),
        pin(60.0),
        pin(80.0),
        ("two cylinders of different moduli".into(), cylinders, fitted(Order::Quintic, 2), None),
        ("block under an eccentric load".into(), eccentric, fitted(Order::Sextic, 2), None),
        (peak_off.into(), off_centre.scene, fitted(Order::Octic, 3), Some(truth)),
    ];
    let solved = all.into_par_iter().map(|(name, scene, fitted, truth)| {
        let on = |fitted: Fitted| fitted.solve_with_ends(&scene, &Formulation::verification(), AT_REST);
        let run = on(fitted)?.run;
        let right = truth.map_or_else(|| on(BEST).map(|best| found(&best.run)), Ok)?;
        let errors = errors(&run, right);
        Ok((name, Mesh { fitted, dofs: run.dofs, in_all: run.dofs, errors, exact: truth.is_some() }))
    });
    solved.collect()
}

/// What is asked of a mesh.
const QUANTITIES: [Quantity; 3] = [Quantity::PeakPressure, Quantity::SecondMomentWidth, Quantity::HalfWidth];

/// Those of a run; NaN, which no check passes, where it did not converge.
fn found(run: &Run) -> [f64; 3] {
    QUANTITIES.map(|one| if run.solution.converged() { one.of(run.measures()) } else { f64::NAN })
}

/// Their relative errors.
fn errors(run: &Run, truth: [f64; 3]) -> [f64; 3] {
    let found = found(run);
    [0, 1, 2].map(|k| relative_error(found[k], truth[k]))
}

/// The errors of a mesh.
fn of(mesh: Option<&Mesh>, at: &str, reference: Reference, (most, because): (f64, &'static str)) -> [Judged; 3] {
    let error = |name: &'static str, k: usize| {
        let most = if k == 2 { OF_END * most } else { most };
        let check = Check::error(case::Quantity::at(name, at), reference.clone(), most, because);
        check.judge(mesh.map_or(f64::NAN, |mesh| mesh.errors[k]))
    };
    [
        error("relative error of the peak pressure on a mesh fitted to the contact", 0),
        error("relative error of the second-moment width on a mesh fitted to the contact", 1),
        error("relative error of the half-width on a mesh fitted to the contact", 2),
    ]
}

/// Columns of the meshes of truncated Hertz.
const MESHES: [Column<Mesh>; 6] = [
    ("cells", |Mesh { fitted, .. }| format!("fitted, order {}, layers {}", fitted.order.number(), fitted.layers)),
    ("degrees of freedom", |mesh| mesh.dofs.to_string()),
    ("those of all meshes on the way", |mesh| mesh.in_all.to_string()),
    ("error of p₀, worst load", |mesh| markdown::error(mesh.errors[0])),
    ("error of the second-moment width, worst load", |mesh| markdown::error(mesh.errors[1])),
    ("error of the half-width, worst load", |mesh| markdown::error(mesh.errors[2])),
];
