//! The cases of the suite, each solved by its formulations; with pictures of the two examples: the schemes of their
//! scenes, and contact pressure as in the paper's Figs 10 and 14, of all nine formulations with their differences to
//! the reference.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use crate::case::library::{self, Cylinder, PinRod, cylinder, pin_rod};
use crate::case::{Case, Judged, Meshed, Quantity, file};
use crate::checkout::root;
use crate::drawing::palette::Style;
use crate::drawing::{Axis, Chart, Drawing, Series, panels, schematic};
use crate::error::Error;
use crate::markdown::{self, Column, significant};
use crate::measure::{Quantity as Number, display_factor};
use crate::scene::ReferenceValues;
use crate::solution::EdgeState;
use crate::solve::{Formulation, Run};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::described;
use crate::study::drawn::{WITHOUT_GAERTNER, how_stopped, label, picture, style};
use crate::study::grouped::in_order;

/// Folder of the scene files of the checkout.
const FILES: &str = "tests/cases";

/// Name of a scene file, and its case where that can be read.
type File = (String, Result<Case, Error>);

/// The scene files by their names, each as a case of that name.
fn files() -> Result<Vec<File>, Error> {
    let of = |path: PathBuf| {
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let case = Case::read(&path).map(|case| case.named(name.clone()));
        (name, case)
    };
    Ok(file::files_in(&root().join(FILES))?.into_iter().map(of).collect())
}

/// Names by which a case may be asked for, and the page that it is on: its own, that of the page, and the path of its
/// file.
pub fn names() -> Result<Vec<[String; 2]>, Error> {
    let built_in = library::all().into_iter().map(|case| (case.name.clone(), page(&case)));
    let files = files()?.into_iter().filter_map(|(name, case)| Some((name, page(&case.ok()?))));
    let all = built_in.chain(files);
    let of = |(name, page): (String, String)| {
        [name.clone(), page.clone(), format!("{FILES}/{name}")].map(|name| [name, page.clone()])
    };
    Ok(all.flat_map(of).collect())
}

/// The trials of the cases that share a page.
pub fn of_page(name: &str) -> Vec<Planned<Numbers>> {
    let files = files().unwrap_or_default().into_iter().filter_map(|(_, case)| case.ok());
    library::all().into_iter().chain(files).filter(|case| page(case) == name).flat_map(trials).collect()
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

impl Study for Numbers {
    const NAME: &'static str = "cases";
    const ABOUT: About = About {
        title: "Cases",
        asked: "Whether each case, under each of its formulations, is what its reference says.",
        limits: "A case shows its own scene only; what a page of a case calls its limits is said there.",
    };

    /// All cases of the library, then the scene files of the checkout.
    fn plan() -> Vec<Planned<Self>> {
        let built_in = library::all().into_iter().flat_map(trials);
        let of = |(name, case): File| match case {
            Ok(case) => trials(case),
            Err(error) => vec![broken(&name, error)],
        };
        let files = files().map(|files| files.into_iter().flat_map(of).collect());
        built_in.chain(files.unwrap_or_else(|error| vec![broken("scene files", error)])).collect()
    }

    /// The checks of the case, and those of every run.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(self.judged.clone())
    }

    /// What each problem is, what it is held against, and where that comes from: a row a page.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let columns: [Column<(String, &Numbers)>; 4] = [
            ("case", |(name, _)| format!("[{name}](case-{name}.md)")),
            ("what it is", |(_, numbers)| numbers.case.title.clone()),
            ("reference", |(_, numbers)| {
                numbers.case.oracle().map_or("its own checks".into(), |oracle| oracle.name().to_owned())
            }),
            ("source", |(_, numbers)| described::sources(&numbers.case).join("; ")),
        ];
        let pages = in_order(findings.iter().map(|found| (page(&found.numbers.case), found.numbers)));
        let pages: Vec<_> = pages.into_iter().map(|(name, numbers)| (name, numbers[0])).collect();
        Ok(markdown::columns(&columns, &pages) + "\n")
    }

    /// Pressure of the two examples, with the schemes of their scenes.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let nine = |case: &str| -> Vec<&Run> {
            findings.iter().filter(|found| found.case == case).map(|found| &found.numbers.run).collect()
        };
        Ok(vec![
            ("scene-cylinder.svg".into(), cylinder_scheme()),
            ("scene-pin-rod.svg".into(), pin_rod_scheme()),
            ("pressure-cylinder.svg".into(), on_cylinder(&nine(cylinder::NINE))),
            ("pressure-pin-rod.svg".into(), on_pin(&nine(pin_rod::NINE))),
        ])
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
    if formulation.is_like(case.formulation()) {
        judged.extend(case.held_to_closed_forms(meshed, &run)?);
    }
    Ok(Numbers { case: case.clone(), run, judged })
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
    let is_endless = quantity.as_ref().is_some_and(|quantity| numbers.run.is_unbounded(0, quantity));
    let quantity = quantity.map(Quantity::from);
    let is_own = |one: &&Judged| Some(&one.check.quantity) == quantity.as_ref() && one.check.contact == 0;
    let bar = judged.iter().find(is_own).and_then(|one| one.bar).filter(|bar| bar.is_finite());
    let value = factor * of(&numbers.run);
    match bar {
        _ if !numbers.run.solution.converged() || value.is_nan() => "–".into(),
        _ if is_endless => "without limit".into(),
        Some(bar) => markdown::with_bar(value, Some(factor * bar)),
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

/// The chart of a page; none where there is none.
pub fn charts(page: &str) -> Option<String> {
    let (file, caption) = match page {
        "cylinder" => {
            ("pressure-cylinder.svg", "As Fig. 10: pressure of all nine formulations, and their difference to Hertz")
        }
        "pin-rod" => (
            "pressure-pin-rod.svg",
            "As Fig. 14, without Gaertner's curves: pressure of all nine formulations, and their difference to one of \
            them",
        ),
        _ => return None,
    };
    Some(picture(file, caption) + &how_stopped() + "\n\n")
}

/// What is to be known of the scene of a page beside its title; empty where that is all.
pub fn remark(page: &str) -> &'static str {
    match page {
        "cylinder" => concat!(include_str!("cases/cylinder.md"), "\n"),
        "truncated-hertz" => concat!(include_str!("cases/truncated-hertz.md"), "\n"),
        "sphere" => concat!(include_str!("cases/sphere.md"), "\n"),
        "truncated-sphere" | "cone" => concat!(include_str!("cases/truncated-sphere.md"), "\n"),
        "pin-rod" => concat!(include_str!("cases/pin-rod.md"), "\n"),
        _ => "",
    }
}

/// Intervals into which the closed form is drawn.
const INTERVALS: usize = 200;
/// Parts of an edge over which the closed form is averaged.
const PARTS: usize = 20;
/// Where the pictures of the cylinder end, over the half-width.
const END: f64 = 1.5;

/// The cylinder on its rigid plane with its load and supports (the paper's Fig. 8).
fn cylinder_scheme() -> Drawing {
    let numbers = Cylinder::default();
    let (a, load) = (numbers.half_width(), numbers.load() / (2.0 * numbers.radius));
    let shown = [("R", numbers.radius), ("a", a), ("L", numbers.stretch * a), ("q", load.round())];
    schematic("cylinder", include_str!("cases/cylinder.svg"), &shown)
}

/// The pin in the connecting-rod eye with its load and supports (the paper's Fig. 12).
fn pin_rod_scheme() -> Drawing {
    let numbers = PinRod::default();
    let shown = [
        ("R", numbers.pin_radius),
        ("c", numbers.clearance),
        ("R + c", numbers.pin_radius + numbers.clearance),
        ("outer", numbers.eye_outer_radius),
        ("half width", 0.5 * numbers.shank_width),
        ("height", numbers.shank_end),
        ("F/2", 0.5 * numbers.force),
        ("candidates", numbers.stretch.to_degrees()),
    ];
    schematic("pin-rod", include_str!("cases/pin-rod.svg"), &shown)
}

/// A curve a run over the middles of its edges; one that did not converge stands hollow at the frame.
fn curves(runs: &[&Run], place: f64, of: &dyn Fn(usize, &EdgeState) -> f64) -> Vec<Series> {
    let curve = |run: &&Run| {
        let (converged, edges) = (run.solution.converged(), run.solution.edges.iter().enumerate());
        let points = edges.map(|(k, edge)| (edge.position() * place, of(k, edge))).filter(|_| converged);
        let hollow = if converged { vec![] } else { vec![0.0] };
        Series { hollow, ..Series::new(label(&run.formulation), points, style(&run.formulation)) }
    };
    runs.iter().map(curve).collect()
}

/// Pressure over p₀ along x/a on the cylinder beside Hertz's, and the difference of edge means.
fn on_cylinder(runs: &[&Run]) -> Drawing {
    let problem = Cylinder::default().case();
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let exact = |x: f64| problem.reference_pressure(0, x * a) / p0;
    let mean = |edge: &EdgeState| {
        let half = 0.5 * edge.weight / problem.scene.thickness / a;
        let part = |k: usize| edge.position() / a + half * (2.0 * (k as f64 + 0.5) / PARTS as f64 - 1.0);
        (0..PARTS).map(|k| exact(part(k))).sum::<f64>() / PARTS as f64
    };
    let place = Axis::linear("place over half-width x / a [–]").over(0.0, END);
    let mut pressure = Chart::new("Pressure", place.clone(), Axis::linear("pressure p / p₀ [–]").over(0.0, 1.1));
    pressure.series = curves(runs, 1.0 / a, &|_, edge| edge.pressure / p0);
    let places = (0..=INTERVALS).map(|k| END * k as f64 / INTERVALS as f64);
    pressure.series.push(Series::new("Hertz", places.map(|x| (x, exact(x))), Style::reference()));
    let mut difference = Chart::new("Difference to Hertz", place, Axis::linear("(p − p_Hertz) / p₀ [%]"));
    difference.series = curves(&converged(runs), 1.0 / a, &|_, edge| 100.0 * (edge.pressure / p0 - mean(edge)));
    panels("Cylinder on a rigid plane: all nine formulations", &[pressure, difference], 2)
}

/// Pressure against angle on the pin, and its difference to the formulation that verification uses: there is no closed
/// form.
fn on_pin(runs: &[&Run]) -> Drawing {
    let own = Formulation::verification();
    let is_own = |run: &&&Run| run.formulation.is_like(&own);
    let edges = runs.iter().find(is_own).map(|run| run.solution.edges.as_slice()).unwrap_or_default();
    let largest = edges.iter().map(|edge| edge.pressure).fold(f64::NAN, f64::max);
    let to_own = |k: usize, edge: &EdgeState| {
        edges.get(k).map_or(f64::NAN, |own| 100.0 * (edge.pressure - own.pressure) / largest)
    };
    let scene = PinRod::default().scene();
    let (degrees, scale) = (display_factor(&scene.contact().path), scene.reference.pressure);
    let angle = Axis::linear("θ from the load line [°]").over(0.0, PinRod::default().stretch.to_degrees());
    let mut pressure = Chart::new("Pressure", angle.clone(), Axis::linear("pressure R t p / F [–]").over(0.0, 0.9));
    pressure.series = curves(runs, degrees, &|_, edge| edge.pressure / scale);
    pressure.notes.push(WITHOUT_GAERTNER.into());
    let axis = Axis::linear("difference of R t p / F [% of its largest]");
    let mut difference = Chart::new(&format!("Difference to {}", label(&own)), angle, axis);
    difference.series = curves(&converged(runs), degrees, &to_own);
    panels("Pin in a connecting-rod eye: all nine formulations", &[pressure, difference], 2)
}

fn converged<'a>(runs: &[&'a Run]) -> Vec<&'a Run> {
    runs.iter().copied().filter(|run| run.solution.converged()).collect()
}
