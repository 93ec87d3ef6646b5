//! The cases of the suite, each solved by its formulations; a folder for the length of its pictures.
//!
//! * `pictures` — schemes of the examples, and pressure of all nine against the reference.

mod pictures;

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use crate::case::{Case, Judged, Meshed, Quantity, file, library};
use crate::checkout::root;
use crate::error::Error;
use crate::markdown::{self, Column, significant};
use crate::measure::{Quantity as Number, display_factor};
use crate::solve::{Formulation, Run};
use crate::study::about::About;
use crate::study::drawn::picture;
use crate::study::{Found, Planned};

pub use pictures::pictures;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Cases",
    asked: "Whether each case, under each of its formulations, is what its reference says.",
    limits: "A case shows its own scene only; what a page of a case calls its limits is said there.",
};

/// All cases of the library, then the scene files of the checkout.
pub fn plan() -> Vec<Planned<Numbers>> {
    let built_in = library::all().into_iter().flat_map(trials);
    built_in.chain(files().unwrap_or_else(|error| vec![broken("scene files", error)])).collect()
}

fn files() -> Result<Vec<Planned<Numbers>>, Error> {
    let files = file::files_in(&root().join("tests/cases"))?;
    let of = |path: PathBuf| {
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        match Case::read(&path) {
            Ok(case) => trials(case.named(name)),
            Err(error) => vec![broken(&name, error)],
        }
    };
    Ok(files.into_iter().flat_map(of).collect())
}

/// A trial that ends in an error: what could not be read is not left out.
fn broken(case: &str, error: Error) -> Planned<Numbers> {
    Planned::new(case, "reading", move || Err(error.clone()))
}

/// The trials of one case.
fn trials(case: Case) -> Vec<Planned<Numbers>> {
    let (case, mesh) = (Arc::new(case), Shared::default());
    let trial = |formulation: &Formulation| {
        let (case, mesh, formulation) = (case.clone(), mesh.clone(), formulation.clone());
        Planned::new(case.name.clone(), title(&formulation), move || run(&case, &mesh, &formulation))
    };
    case.formulations.iter().map(trial).collect()
}

/// Name of a trial: the formulation, and its increments where there are several.
fn title(formulation: &Formulation) -> String {
    match formulation.settings.increments {
        0 | 1 => formulation.name(),
        several => format!("{}, {several} increments", formulation.name()),
    }
}

/// A case solved by one formulation.
#[derive(Clone)]
pub struct Numbers {
    /// The case.
    pub case: Arc<Case>,
    /// The run.
    pub run: Run,
    /// Its checks; they need the mesh, which is not kept.
    judged: Vec<Judged>,
}

impl std::fmt::Debug for Numbers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Numbers").field("case", &self.case.name).field("run", &self.run).finish_non_exhaustive()
    }
}

/// The mesh of a case, made by whichever formulation comes first.
type Shared = Arc<OnceLock<Result<Meshed, Error>>>;

/// Runs and judges a formulation.
fn run(case: &Arc<Case>, mesh: &Shared, formulation: &Formulation) -> Result<Numbers, Error> {
    let meshed = mesh.get_or_init(|| case.meshed()).as_ref().map_err(Error::clone)?;
    let run = case.run(meshed, formulation)?;
    let mut judged = case.judge(meshed, &run)?;
    // Once for all formulations: the closed form is that of the scene.
    if formulation.name() == case.formulation().name() {
        judged.extend(case.held_to_closed_forms(meshed, &run)?);
    }
    Ok(Numbers { case: case.clone(), run, judged })
}

/// The checks of the case, and those of every run.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(numbers.judged.clone())
}

/// What each problem is, what it is held against, and where that comes from: a row a page.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let columns: [Column<(String, &Numbers)>; 4] = [
        ("case", |(name, _)| format!("[{name}](case-{name}.md)")),
        ("what it is", |(_, numbers)| numbers.case.title.clone()),
        ("reference", |(_, numbers)| {
            numbers.case.oracle().map_or("its own checks".into(), |oracle| oracle.name().to_owned())
        }),
        ("source", |(_, numbers)| sources(numbers).join("; ")),
    ];
    let mut pages: Vec<(String, &Numbers)> = Vec::new();
    for Found { numbers, .. } in findings {
        let name = page(&numbers.case);
        if pages.iter().all(|(known, _)| *known != name) {
            pages.push((name, numbers));
        }
    }
    Ok(markdown::columns(&columns, &pages) + "\n")
}

/// Where a case and its closed form come from.
pub fn sources(numbers: &Numbers) -> Vec<String> {
    let cited = numbers.case.oracle().into_iter().map(|oracle| {
        let source = oracle.source();
        format!("{}: {} ({})", oracle.name(), source.citation, source.note)
    });
    std::iter::once(numbers.case.source.clone()).filter(|source| !source.is_empty()).chain(cited).collect()
}

/// A run by the name given, with its checks.
type Row<'a> = (String, &'a Numbers, &'a [Judged]);

/// What one quotes of every run, with its bar where that is known.
pub fn results(runs: &[Row]) -> String {
    let straight = runs.iter().all(|(_, numbers, _)| numbers.case.scene.contact().path.is_straight());
    let [width, counted, last] = match straight {
        true => ["second-moment width [mm]", "by counting [mm]", "last active point [mm]"],
        false => ["second-moment width [°]", "by counting [°]", "last active point [°]"],
    };
    let columns: [Column<Row>; 10] = [
        ("run", |(name, ..)| name.clone()),
        ("outcome", |(_, numbers, _)| numbers.run.solution.outcome.to_string()),
        ("iterations", |(_, numbers, _)| numbers.run.solution.work.iterations.to_string()),
        ("factorisations", |(_, numbers, _)| numbers.run.solution.work.factorisations.to_string()),
        ("back-substitutions", |(_, numbers, _)| numbers.run.solution.work.back_substitutions.to_string()),
        ("peak [MPa]", |row| quoted(row, 1.0, |run| run.measures().peak.pressure, Some(Number::PeakPressure))),
        (width, |row| {
            quoted(row, factor(row), |run| run.measures().second_moment_width, Some(Number::SecondMomentWidth))
        }),
        (counted, |row| quoted(row, factor(row), |run| run.measures().half_width_nodes, None)),
        (last, |row| quoted(row, factor(row), |run| run.measures().edge(), None)),
        ("resultant [N]", |row| quoted(row, 1.0, Run::transmitted, Some(Number::Resultant))),
    ];
    markdown::columns(&columns, runs)
}

/// From a contact coordinate to what is shown of it.
fn factor((_, numbers, _): &Row) -> f64 {
    display_factor(&numbers.case.scene.contact().path)
}

/// A number of a run times a factor, with the bar of the check on its quantity.
fn quoted((_, numbers, judged): &Row, factor: f64, of: fn(&Run) -> f64, quantity: Option<Number>) -> String {
    let quantity = quantity.map(Quantity::from);
    let is_own = |one: &&Judged| Some(&one.check.quantity) == quantity.as_ref() && one.check.contact == 0;
    let bar = judged.iter().find(is_own).and_then(|one| one.bar).filter(|bar| bar.is_finite());
    let value = factor * of(&numbers.run);
    match bar {
        _ if !numbers.run.solution.converged() => "–".into(),
        Some(bar) => format!("{} ± {}", significant(value, 6), significant(factor * bar, 2)),
        None => significant(value, 5),
    }
}

/// Name of the page: a scene file has one of its own, cases of the library share that of their scene.
pub fn page(case: &Case) -> String {
    let name = if case.places.is_some() { &case.name } else { &case.scene.name };
    name.replace('.', "-")
}

/// The sketch of the scene of a page; none where there is none.
pub fn sketch(page: &str) -> Option<String> {
    let (file, caption) = match page {
        "cylinder" => (
            "scene-cylinder.svg",
            "As Fig. 8. The scene: lower quarter, half by symmetry, uniform load on the horizontal cut",
        ),
        "pin-rod" => (
            "scene-pin-rod.svg",
            "As Fig. 12. The scene: pin fixed on its horizontal diameter, rod pulled by a rigid end face",
        ),
        _ => return None,
    };
    Some(picture(file, caption))
}

/// The charts of a page; none where there are none.
pub fn charts(page: &str) -> Option<String> {
    let charts = match page {
        "cylinder" => [
            (
                "figure-10.svg",
                "Fig. 10: Hertz's exact solution and the five combinations of elements and algorithms that the paper shows",
            ),
            ("pressure-cylinder.svg", "As Fig. 10 with all nine formulations, and their difference to Hertz"),
        ],
        "pin-rod" => [
            (
                "figure-14.svg",
                "Fig. 14: pressure against angle of the five combinations that the paper shows; the place of Gaertner's curves is empty",
            ),
            ("pressure-pin-rod.svg", "As Fig. 14 with all nine formulations"),
        ],
        _ => return None,
    };
    Some(charts.map(|(file, caption)| picture(file, caption)).concat())
}

/// What is to be known of the scene of a page beside its title; empty where that is all.
pub fn remark(page: &str) -> &'static str {
    match page {
        "cylinder" => {
            "The quarter cylinder under uniform load is not quite Hertz's problem: the model error falls with a/R, see \
             [Refinement](refinement.md). Stresses on the deformed shape: [Fields](fields.md).\n\n"
        }
        "truncated-hertz" => {
            "A block between the closed-form tractions of Hertz's half-space and a rigid parabola: all errors are discretisation errors.\n\n"
        }
        "pin-rod" => {
            "No closed form: the formulations are held against one another, the [refinement series](refinement.md) gives its own \
             uncertainty, and [independent codes](independent.md) solve the same problem. A [pin in a wide plate](case-pin-plate.md) is the \
             same contact with a closed form. Stresses on the deformed shapes: [Fields](fields.md).\n\n"
        }
        _ => "",
    }
}
