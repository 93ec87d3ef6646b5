//! Options of `solve`, and what they change in a scene's own formulation and mesh.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::accuracy::{self, Asked};
use crate::algorithm::{Acceleration, Criterion, Spring, StiffnessRule, StiffnessUnit};
use crate::case::Case;
use crate::cli::choice::{self, choice};
use crate::cli::solve::{curve, html};
use crate::cli::writable::{self, Output, STDOUT};
use crate::cli::{json, vtu};
use crate::drawing;
use crate::error::Error;
use crate::mesh::size::solvable;
use crate::mesh::{Order, Resolution};
use crate::scene::Body;
use crate::solve::{Element, Fitted, Formulation, Iteration};

/// Arguments of `solve`.
#[derive(Clone, Debug, Default, Args)]
pub struct Arguments {
    /// Case of the library (`list` names them), or a scene file (tests/cases/README.md describes its keys).
    pub case: String,
    /// Contact element: node unless the file says otherwise.
    #[arg(long, value_parser = choice(Element::TOLD))]
    element: Option<Element>,
    /// Iteration algorithm: kinematic unless the file says otherwise.
    #[arg(long, value_parser = choice(Iteration::TOLD))]
    algorithm: Option<Iteration>,
    /// Rule; the algorithm's own by default.
    #[arg(long, value_parser = choice(StiffnessRule::TOLD))]
    rule: Option<StiffnessRule>,
    /// Largest factor by which an iteration of the varying algorithm changes a stiffness, 100 by default; `inf` is
    /// none.
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    bound: Option<f64>,
    /// What has a stiffness of its own under the varying algorithm; point by default.
    #[arg(long, value_parser = choice(Spring::TOLD))]
    spring: Option<Spring>,
    /// Thickness of the layer element over the length of its edge.
    #[arg(long, value_name = "PART", allow_negative_numbers = true)]
    layer_thickness: Option<f64>,
    /// Acceleration: by default newton of the varying and the constant algorithm under their own rules, none under
    /// others; with none they are those of the paper.
    #[arg(long, value_parser = choice(Acceleration::TOLD))]
    acceleration: Option<Acceleration>,
    /// Initial stiffness κ₀ = k_n ℓ/E*: by default 1 for varying and constant, and for kinematic 1e6 (node) or that of
    /// 10 √(E*/L · s), L the candidate stretch and s what the bodies resist at a point (line, layer).
    #[arg(long, value_name = "KAPPA", allow_negative_numbers = true)]
    stiffness: Option<f64>,
    /// Hertz half-width over the radius (Hertz scenes only).
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    a_over_r: Option<f64>,
    /// Element order.
    #[arg(long, value_parser = choice(Order::TOLD))]
    order: Option<Order>,
    /// Elements per half-width, or per 10 mm of arc on pins; in a scene file per the length it names. Growth away from
    /// the contact gets gentler with more of them.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    resolution: Option<usize>,
    /// Put mesh lines on the ends of the contact, with layers of cells towards them; order 6 is the default then,
    /// chosen for four digits, 8 for six.
    #[arg(long)]
    fitted: bool,
    /// Relative error that peak and half-width may have, such as "0.1 %": chooses cells, elements, growth and
    /// candidates.
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true)]
    accuracy: Option<String>,
    /// Most degrees of freedom of a mesh that is solved for the accuracy, those of error bars among them.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    max_dofs: Option<usize>,
    /// What shall fall below the tolerance; error by default, which alone says something of the answer.
    #[arg(long, value_parser = choice(Criterion::TOLD))]
    criterion: Option<Criterion>,
    /// Load increments.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    increments: Option<usize>,
    /// Largest error accepted of peak, profile, width and approach against the solution of the same discrete problem:
    /// 1e-3 unless the file says otherwise for its own element and algorithm.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Most iterations, over all increments; 2000 by default.
    #[arg(long, value_name = "N", alias = "max-steps", allow_negative_numbers = true)]
    max_iterations: Option<usize>,
    /// Print every number, bar and check, and what the supports exert; without it the lines that one quotes.
    #[arg(long)]
    pub all: bool,
    /// Do not solve coarser meshes for error bars.
    #[arg(long)]
    pub no_error_bar: bool,
    /// Write the result as JSON to a file, or to standard output with `-`.
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Write the profile as CSV: position (mm, on arcs degrees), pressure, gap, area, contact.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Write resultant, approach, half-width and peak at every load increment as .csv or .json.
    #[arg(long, value_name = "FILE")]
    pub curve: Option<PathBuf>,
    /// Write displacement, stresses, contact pressure and gap on the mesh as VTK for ParaView.
    #[arg(long, value_name = "FILE.vtu")]
    pub vtu: Option<PathBuf>,
    /// Draw the deformed shape with its stresses, the pressure and the iteration error of every iteration as SVG.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Write input, pictures, numbers with bars, checks and notes as one file for a browser, which needs no other.
    #[arg(long, value_name = "FILE.html")]
    pub html: Option<PathBuf>,
    /// Replace files that are not earlier outputs of the same option; files that are read, and other outputs, are never
    /// replaced.
    #[arg(long)]
    force: bool,
}

/// An option that asks for a file, where that goes, and whether a text is an earlier output of the same kind.
type Asking<'a> = (&'static str, &'a Option<PathBuf>, fn(&str) -> bool);

impl Arguments {
    /// The case of the library or of a file.
    pub fn named(&self) -> Result<Case, Error> {
        let case = choice::case("solve", &self.case, self.a_over_r)?;
        Ok(match &case.places {
            Some(_) => case,
            None => Case { formulations: vec![Formulation::new(Element::Node, Iteration::Kinematic)], ..case },
        })
    }

    /// The accuracy asked for here, else that of the file; the mesh is then chosen by it alone.
    pub fn asked(&self, of_file: Option<Asked>) -> Result<Option<Asked>, Error> {
        let asked = match &self.accuracy {
            None => of_file,
            Some(text) => Some(
                accuracy::percentage(text)
                    .map_err(|expected| Error::value("solve", "--accuracy", text, expected, accuracy::remedy()))?,
            )
            .map(|relative| Asked { relative, ..of_file.unwrap_or_else(|| Asked::new(relative)) }),
        };
        let asked = match (asked, self.max_dofs) {
            (None, Some(_)) => {
                let message = "--max-dofs cannot be used: it bounds the search for an accuracy, and none is asked for";
                return Err(Error::at("solve", message, "leave it out, or give --accuracy"));
            }
            (asked, most_dofs) => asked.map(|asked| Asked { most_dofs, ..asked }),
        };
        let order = self.order.is_some() && !self.fitted;
        let given = [("--resolution", self.resolution.is_some()), ("--order", order)];
        refuse_beside(asked.is_some(), &given, "the accuracy chooses the mesh")?;
        Ok(asked)
    }

    /// What the options change in a formulation; another element or algorithm begins from its own defaults.
    pub fn formulation(&self, base: Formulation) -> Formulation {
        let element = self.element.unwrap_or(base.element);
        let algorithm = self.algorithm.unwrap_or(base.algorithm);
        let mut formulation = if (element, algorithm) == (base.element, base.algorithm) {
            let rule = self.rule.unwrap_or(base.rule);
            let kept = if rule == base.rule { base.acceleration } else { Acceleration::None };
            Formulation { rule, acceleration: self.acceleration.unwrap_or(kept), ..base }
        } else {
            Formulation::with(element, algorithm, self.rule, self.acceleration).in_place_of(&base)
        };
        let settings = &mut formulation.settings;
        settings.criterion = self.criterion.unwrap_or(settings.criterion);
        settings.tolerance = self.tolerance.unwrap_or(settings.tolerance);
        settings.increments = self.increments.unwrap_or(settings.increments);
        settings.max_iterations = self.max_iterations.unwrap_or(settings.max_iterations);
        formulation.leeway.bound = self.bound.unwrap_or(formulation.leeway.bound);
        if let Some(spring) = self.spring {
            formulation = formulation.with_springs(spring, self.acceleration);
        }
        formulation.layer_thickness = self.layer_thickness.unwrap_or(formulation.layer_thickness);
        if let Some(stiffness) = self.stiffness {
            (formulation.stiffness, formulation.stiffness_unit) = (stiffness, StiffnessUnit::Reference);
        }
        formulation
    }

    /// The same for the same mesh and load, by an element and an algorithm from their own defaults.
    pub fn by(&self, element: Element, algorithm: Iteration, tolerance: Option<f64>) -> Self {
        let Self { case, a_over_r, order, resolution, increments, .. } = self.clone();
        let (element, algorithm) = (Some(element), Some(algorithm));
        Self { case, a_over_r, order, resolution, increments, element, algorithm, tolerance, ..Self::default() }
    }

    /// What one would type: case, load, mesh, element and algorithm, and the tolerance where one is asked for.
    pub fn typed(&self) -> String {
        let options = [
            ("a-over-r", self.a_over_r.map(|ratio| ratio.to_string())),
            ("order", self.order.map(|order| order.number().to_string())),
            ("resolution", self.resolution.map(|elements| elements.to_string())),
            ("element", self.element.map(|element| element.name().into())),
            ("algorithm", self.algorithm.map(|algorithm| algorithm.name().into())),
            ("increments", self.increments.map(|increments| increments.to_string())),
            ("tolerance", self.tolerance.map(|tolerance| format!("{tolerance:e}"))),
        ];
        choice::typed(&self.case, options)
    }

    /// The mesh fitted to the contact that is asked for; none where it is not.
    pub fn fitted(&self) -> Result<Option<Fitted>, Error> {
        let given = [
            ("--resolution", self.resolution.is_some()),
            ("--accuracy", self.accuracy.is_some()),
            ("--max-dofs", self.max_dofs.is_some()),
        ];
        if !self.fitted {
            return Ok(None);
        }
        refuse_beside(true, &given, "--fitted chooses the mesh by --order alone")?;
        let order = self.order.unwrap_or(Order::Sextic);
        let digits = usize::from(order.number()).saturating_sub(2);
        let expected = "cells fitted to the contact have order 4 to 8";
        let refused = || Error::value("solve", "--order", order.number(), expected, "give 4 to 8");
        order.is_high().then(|| Some(Fitted::of_digits(digits))).ok_or_else(refused)
    }

    /// A formulation that iterates to half a unit of the last digit of a fitted mesh, where no tolerance is asked for.
    ///
    /// The tolerance of a file or of the library is one for 8-node cells, and would leave nothing of the digits.
    pub fn as_exact_as(&self, fitted: Fitted, formulation: Formulation) -> Formulation {
        let own = formulation.settings.tolerance;
        let tolerance = self.tolerance.unwrap_or(own.min(Fitted::misfit(fitted.order)));
        formulation.tolerance(tolerance)
    }

    /// Gives the problem the mesh asked for, if it can be solved; growth follows the elements.
    pub fn refine(&self, problem: &mut Case) -> Result<(), Error> {
        let order = self.order.unwrap_or(problem.resolution.order);
        let brought = |body: &Body| body.shape.has_given_mesh();
        if let (Some(elements), true) = (self.resolution, problem.scene.bodies.iter().all(brought)) {
            let remedy = "leave it out, and refine those meshes";
            return Err(Error::value("solve", "--resolution", elements, "the meshes of all bodies are given", remedy));
        }
        let elements = self.resolution.unwrap_or(problem.resolution.elements);
        let times = elements as f64 / problem.resolution.elements as f64;
        problem.scene.grading = order.refined(&problem.scene.grading, times);
        problem.resolution = Resolution { elements, refinement: 0, order };
        solvable(&problem.scene, problem.resolution)
            .map_err(|(message, remedy)| Error::value("solve", "--resolution", elements, message, remedy))
    }

    /// Refuses outputs that cannot be written, or by which something would be lost, before anything is solved.
    pub fn refuse_unwritable(&self, case: &Case) -> Result<(), Error> {
        let files = self.outputs().map(|(option, path, is_earlier)| Output::of(option, path, is_earlier));
        writable::refuse("solve", files, &case.read_files(), self.force)
    }

    /// The options that ask for a file.
    fn outputs(&self) -> [Asking<'_>; 6] {
        [
            ("--json", &self.json, json::is_result),
            ("--csv", &self.csv, curve::is_profile),
            ("--curve", &self.curve, curve::is_curve),
            ("--vtu", &self.vtu, vtu::is_ours),
            ("--plot", &self.plot, drawing::is_drawing),
            ("--html", &self.html, html::is_ours),
        ]
    }

    /// Refuses names of outputs that would not tell their format.
    pub fn refuse_endings(&self) -> Result<(), Error> {
        let [_, others @ ..] = self.outputs();
        let to_stdout = |path: &Option<PathBuf>| path.as_deref() == Some(Path::new(STDOUT));
        if let Some((option, ..)) = others.into_iter().find(|(_, path, _)| to_stdout(path)) {
            let remedy = "name a file; `--json -` writes to standard output";
            return Err(Error::value("solve", option, STDOUT, "this output goes to a file", remedy));
        }
        writable::refuse_plot("solve", &self.plot)?;
        writable::refuse_ending("solve", "--html", &self.html, ["html", "pages are HTML", ""])?;
        let told = ["vtu", "fields are VTK unstructured grids", ", by which ParaView knows the format"];
        writable::refuse_ending("solve", "--vtu", &self.vtu, told)
    }
}

/// Refuses the first of some options that is given, where something else chooses what it would.
fn refuse_beside(is_chosen: bool, options: &[(&str, bool)], chooses: &str) -> Result<(), Error> {
    match options.iter().find(|(_, given)| is_chosen && *given) {
        Some((option, _)) => {
            Err(Error::at("solve", format!("{option} cannot be used: {chooses}"), "leave one of them out"))
        }
        None => Ok(()),
    }
}
