//! `solve CASE` or `solve SCENE.toml`: one scene by one formulation, with its outputs.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::algorithm::{Acceleration, StiffnessRule};
use crate::case::accuracy::{self, Asked};
use crate::case::problem::{Problem, problem};
use crate::case::{Run, SceneFile};
use crate::cli::{self, json, say, vtu};
use crate::error::Error;
use crate::formulation::{Discretisation, Element, Formulation, Iteration, Start};
use crate::measure::display_factor;
use crate::mesh::size::solvable;
use crate::mesh::{Order, Resolution};
use crate::report::figure::palette::{self, Dash, Marker, Style};
use crate::report::figure::{Axis, Chart, Series};
use crate::report::format;

/// Arguments of `solve`.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Case of the library (`list` names them), or a scene file (tests/scenes/README.md describes its keys).
    case: String,
    /// Contact element: node unless the file says otherwise.
    #[arg(long, value_enum)]
    element: Option<ElementName>,
    /// Iteration algorithm: kinematic unless the file says otherwise.
    #[arg(long, value_enum)]
    algorithm: Option<AlgorithmName>,
    /// Rule; the algorithm's own by default.
    #[arg(long, value_enum)]
    rule: Option<RuleName>,
    /// Acceleration of the constant algorithm; not the paper's.
    #[arg(long, value_enum)]
    acceleration: Option<AccelerationName>,
    /// Start of the kinematic algorithm: every candidate closed (the paper's) or the contact set of coarser meshes.
    #[arg(long, value_enum)]
    start: Option<StartName>,
    /// Initial stiffness κ₀ = k_n ℓ/E*.
    #[arg(long, value_name = "KAPPA", allow_negative_numbers = true)]
    stiffness: Option<f64>,
    /// Hertz half-width over the radius (Hertz scenes only).
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    a_over_r: Option<f64>,
    /// Element order: 1 (4-node) or 2 (8-node).
    #[arg(long)]
    order: Option<u8>,
    /// Elements per half-width, or per 10 mm of arc on pins; in a scene file per the length it names.
    #[arg(long, value_name = "N")]
    resolution: Option<usize>,
    /// Relative error that peak and half-width may have, such as "0.1 %": chooses order, resolution, growth and candidates.
    #[arg(long, value_name = "PERCENT")]
    accuracy: Option<String>,
    /// Load increments.
    #[arg(long, value_name = "N")]
    increments: Option<usize>,
    /// Largest residual accepted.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Write the result as JSON to a file, or to standard output with `-`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the profile as CSV: position, pressure, gap, area.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write displacement, stress, pressure and gap on the mesh as VTK for ParaView.
    #[arg(long, value_name = "FILE.vtu")]
    vtu: Option<PathBuf>,
    /// Draw the pressure profile as SVG.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ElementName {
    Line,
    Layer,
    Node,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum AlgorithmName {
    Varying,
    Constant,
    Kinematic,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum RuleName {
    Secant,
    Correction,
    Literal,
    Switching,
    Penalty,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum AccelerationName {
    None,
    CrossedSecant,
    Anderson,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum StartName {
    Closed,
    Nested,
}

/// Solves, prints a table unless JSON goes to standard output, and writes what was asked for; tells whether it converged.
pub fn run(arguments: &Arguments) -> Result<bool, Error> {
    let (mut problem, base, asked) = arguments.problem()?;
    if let Some(path) = arguments.plot.as_ref().filter(|path| path.extension().is_none_or(|end| end != "svg")) {
        return Err(Error::value("solve", "--plot", path.display(), "plots are SVG", "end the file name in .svg"));
    }
    if let Some(path) = arguments.vtu.as_ref().filter(|path| path.extension().is_none_or(|end| end != "vtu")) {
        let remedy = "end the file name in .vtu, by which ParaView knows the format";
        return Err(Error::value("solve", "--vtu", path.display(), "fields are VTK unstructured grids", remedy));
    }
    let formulation = arguments.formulation(base);
    formulation.validate(&problem.scene)?;
    let accurate = match arguments.asked(asked)? {
        None => None,
        Some(asked) => {
            let answer = accuracy::solve(&problem.scene, &formulation, &asked)?;
            (problem.scene, problem.resolution) = (answer.scene.clone(), answer.resolution);
            Some((asked, answer))
        }
    };
    let resolution = if accurate.is_some() { problem.resolution } else { arguments.resolution(&problem)? };
    let discretisation = Discretisation::of(problem.scene.clone(), resolution)?;
    let run = match &accurate {
        None => Run::of(&discretisation, &formulation)?,
        Some((_, answer)) => answer.run.clone(),
    };
    let to_stdout = arguments.json.as_deref() == Some(Path::new("-"));
    if let Some(path) = &arguments.json {
        let text = json::text(&problem, resolution, &run, accurate.as_ref().map(cli::accuracy::Document::of));
        if to_stdout { say(&text) } else { write(path, &text)? }
    }
    if let Some(path) = &arguments.csv {
        write(path, &profile(&run, path)?)?;
    }
    if let Some(path) = &arguments.vtu {
        write(path, &vtu::text(&discretisation, &run)?)?;
    }
    if let Some(path) = &arguments.plot {
        write(path, &plot(&problem, &run).svg()?)?;
    }
    if !to_stdout {
        print(&problem, resolution, &run);
        accurate.iter().for_each(|accurate| cli::accuracy::print(accurate, &problem.scene.contact.path));
    }
    if !run.solution.converged() {
        eprintln!(
            "not converged: these numbers are those of the last step; allow more steps, or choose another algorithm or start"
        );
    }
    Ok(run.solution.converged() && accurate.is_none_or(|(_, answer)| answer.unmet.is_none()))
}

impl Arguments {
    /// The problem of the library or of a file, and the formulation and the accuracy that it names.
    fn problem(&self) -> Result<(Problem, Formulation, Option<Asked>), Error> {
        let path = Path::new(&self.case);
        let is_file = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml")) || path.exists();
        if !is_file {
            let problem = problem(&self.case, self.a_over_r)?;
            return Ok((problem, Formulation::new(Element::Node, Iteration::Kinematic), None));
        }
        if self.a_over_r.is_some() {
            let remedy = "leave it out, and set the load in the file";
            return Err(Error::Combination { what: "a scene file has no a/R".into(), remedy: remedy.into() });
        }
        let file = SceneFile::read(path)?;
        Ok((file.problem, file.formulation, file.accuracy))
    }

    /// The accuracy asked for here, else that of the file; the mesh is then chosen by it alone.
    fn asked(&self, of_file: Option<Asked>) -> Result<Option<Asked>, Error> {
        let asked = match &self.accuracy {
            None => of_file,
            Some(text) => Some(accuracy::percentage(text).ok_or_else(|| {
                Error::value("solve", "--accuracy", text, "it must be a percentage", accuracy::remedy())
            })?)
            .map(|relative| Asked { relative, ..of_file.unwrap_or_else(|| Asked::new(relative)) }),
        };
        let given = [("--resolution", self.resolution.is_some()), ("--order", self.order.is_some())];
        match given.into_iter().find(|(_, given)| *given && asked.is_some()) {
            None => Ok(asked),
            Some((option, _)) => Err(Error::Combination {
                what: format!("the accuracy chooses the mesh, and {option} too"),
                remedy: "leave one of them out".into(),
            }),
        }
    }

    /// What the options change in a formulation; another element or algorithm begins from its own defaults.
    fn formulation(&self, base: Formulation) -> Formulation {
        let element = self.element.map_or(base.element, |element| match element {
            ElementName::Line => Element::Line,
            ElementName::Layer => Element::Layer,
            ElementName::Node => Element::Node,
        });
        let algorithm = self.algorithm.map_or(base.algorithm, |algorithm| match algorithm {
            AlgorithmName::Varying => Iteration::Varying,
            AlgorithmName::Constant => Iteration::Constant,
            AlgorithmName::Kinematic => Iteration::Kinematic,
        });
        let mut formulation = if (element, algorithm) == (base.element, base.algorithm) {
            base
        } else {
            Formulation { settings: base.settings, ..Formulation::new(element, algorithm) }
        };
        let settings = &mut formulation.settings;
        settings.tolerance = self.tolerance.unwrap_or(settings.tolerance);
        settings.increments = self.increments.unwrap_or(settings.increments);
        if let Some(acceleration) = self.acceleration {
            formulation.acceleration = match acceleration {
                AccelerationName::None => Acceleration::None,
                AccelerationName::CrossedSecant => Acceleration::CrossedSecant,
                AccelerationName::Anderson => Acceleration::Anderson,
            };
        }
        if let Some(start) = self.start {
            formulation.start = match start {
                StartName::Closed => Start::Closed,
                StartName::Nested => Start::Nested,
            };
        }
        if let Some(rule) = self.rule {
            formulation.rule = match rule {
                RuleName::Secant => StiffnessRule::Secant,
                RuleName::Correction => StiffnessRule::Correction,
                RuleName::Literal => StiffnessRule::Literal,
                RuleName::Switching => StiffnessRule::Switching,
                RuleName::Penalty => StiffnessRule::Penalty,
            };
        }
        formulation.stiffness = self.stiffness.unwrap_or(formulation.stiffness);
        formulation
    }

    fn resolution(&self, problem: &Problem) -> Result<Resolution, Error> {
        let order = match self.order {
            None => problem.resolution.order,
            Some(1) => Order::Linear,
            Some(2) => Order::Quadratic,
            Some(other) => {
                return Err(Error::value("solve", "--order", other, "it must be 1 or 2", "use 2 for 8-node cells"));
            }
        };
        let elements = self.resolution.unwrap_or(problem.resolution.elements);
        let resolution = Resolution { elements, refinement: 0, order };
        match solvable(&problem.scene, resolution) {
            Ok(()) => Ok(resolution),
            Err((message, remedy)) => Err(Error::value("solve", "--resolution", elements, message, remedy)),
        }
    }
}

fn print(problem: &Problem, resolution: Resolution, run: &Run) {
    let factor = display_factor(&problem.scene.contact.path);
    let unit = if factor > 1.0 { "°" } else { "mm" };
    let order = resolution.order.nodes_per_cell();
    say(format!("{}: {}", problem.name, problem.title));
    say(format!(
        "{}, {order}-node cells, {} freedoms, {} retained",
        run.formulation.name(),
        run.freedoms,
        run.retained
    ));
    let work = &run.solution.work;
    say(format!(
        "{} after {} steps, {} factorisations, residual {}",
        run.solution.outcome,
        work.steps,
        work.factorisations,
        format::error(run.solution.residual())
    ));
    if run.formulation.acceleration != Acceleration::None {
        say(format!("{} accelerated steps given up for the plain one", work.rejected));
    }
    if run.formulation.start == Start::Nested {
        let coarser = &run.solution.coarser;
        say(format!(
            "start found by {} steps and {} factorisations on coarser meshes",
            coarser.steps, coarser.factorisations
        ));
    }
    say(format!(
        "half-width by second moment {} {unit}, by counting {} {unit}",
        format::value(factor * run.measures.half_width),
        format::value(factor * run.measures.half_width_nodes)
    ));
    say(format!(
        "peak pressure {} MPa at {} {unit}, resultant {} N",
        format::value(run.measures.peak.pressure),
        format::value(factor * run.measures.peak.position),
        format::value(run.transmitted)
    ));
    if let Some(note) = run.note() {
        say(format!("note: {note}"));
    }
    for oracle in json::oracles(problem, run) {
        say(format!(
            "{} ({}) {}: {}, error {}",
            oracle.name,
            oracle.kind,
            oracle.quantity,
            format::value(oracle.reference),
            format::error(oracle.error)
        ));
    }
}

/// Position, pressure, gap and area of every contact point.
fn profile(run: &Run, path: &Path) -> Result<String, Error> {
    let failed = |reason: String| Error::File { path: path.into(), reason, remedy: "try another file".into() };
    let mut writer = csv::Writer::from_writer(Vec::new());
    let head = ["position [mm or rad]", "pressure [MPa]", "gap [mm]", "area [mm2]"];
    writer.write_record(head).map_err(|error| failed(error.to_string()))?;
    for point in &run.solution.points {
        let numbers = [point.position, point.pressure, point.gap, point.weight].map(|number| number.to_string());
        writer.write_record(numbers).map_err(|error| failed(error.to_string()))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(error.to_string()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Pressure against the contact coordinate, with the oracle's curve where there is one.
fn plot(problem: &Problem, run: &Run) -> Chart {
    let factor = display_factor(&problem.scene.contact.path);
    let label = if factor > 1.0 { "θ [°]" } else { "x [mm]" };
    let title = format!("{}: {}, {}", problem.name, run.formulation.name(), run.solution.outcome);
    let mut chart = Chart::new(&title, Axis::linear(label), Axis::linear("contact pressure [MPa]"));
    let points = |of: &dyn Fn(f64, f64) -> f64| {
        run.solution.points.iter().map(|p| (factor * p.position, of(p.position, p.pressure))).collect()
    };
    let style = Style::run(palette::NODE, Dash::Solid, Marker::Circle);
    chart.series.push(Series { label: run.formulation.name(), points: points(&|_, p| p), style, hollow: vec![] });
    if let Some(oracle) = &problem.oracle {
        let curve = points(&|s, _| problem.reference_pressure(s));
        chart.series.push(Series {
            label: oracle.name().into(),
            points: curve,
            style: Style::reference(),
            hollow: vec![],
        });
    }
    chart
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    std::fs::write(path, text).map_err(|error| Error::File {
        path: path.into(),
        reason: error.to_string(),
        remedy: "check that the folder exists and may be written".into(),
    })
}
