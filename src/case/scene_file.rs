//! A user's scene file: a case with its mesh, its formulation and its checks.

use std::f64::consts::PI;
use std::ops::Range;
use std::path::Path;

use serde::Deserialize;
use toml::Spanned;

use crate::algorithm::{Acceleration, StiffnessRule};
use crate::case::check::{Check, Reference};
use crate::case::problem::Problem;
use crate::case::run::Run;
use crate::case::universal;
use crate::error::Error;
use crate::formulation::{Discretisation, Element, Formulation, Iteration, Start};
use crate::measure::{display_factor, profile};
use crate::mesh::{Order, Resolution};
use crate::oracle::ReferenceKind;
use crate::scene::file::tables::{BodyTable, ContactTable, GrowthTable, Name, Number, ReferenceTable, UnitsTable};
use crate::scene::file::units::Units;
use crate::scene::file::{Source, Tables};
use crate::scene::{Path as ContactPath, Scene, Shape};

/// Largest file that is read \[bytes\].
const LARGEST_FILE: u64 = 1 << 20;
/// Most cells and most candidate elements that are meshed: a solve then stays within about 4 GB.
pub const MOST: [f64; 2] = [500e3, 2e3];

/// A scene with everything needed to solve and judge it.
#[derive(Clone)]
pub struct SceneFile {
    /// Scene and mesh.
    pub problem: Problem,
    /// How it is solved.
    pub formulation: Formulation,
    wanted: Vec<Wanted>,
}

/// What a check asks.
#[derive(Clone, Debug)]
struct Wanted {
    quantity: Quantity,
    /// Contact coordinate \[mm, or rad\].
    at: f64,
    value: f64,
    tolerance: f64,
    kind: ReferenceKind,
    source: String,
    because: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    PeakPressure,
    HalfWidth,
    Resultant,
    Pressure,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    title: Option<String>,
    plane: Name,
    thickness: Number,
    units: Option<UnitsTable>,
    body: Spanned<Vec<BodyTable>>,
    contact: ContactTable,
    reference: Option<ReferenceTable>,
    mesh: MeshTable,
    #[serde(default)]
    solve: SolveTable,
    #[serde(default)]
    check: Vec<CheckTable>,
}

/// `[mesh]`: `elements` of the candidate stretch on every length `per`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MeshTable {
    elements: Spanned<usize>,
    per: Number,
    order: Option<Spanned<u8>>,
    growth: Option<GrowthTable>,
}

/// `[solve]`: everything optional.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct SolveTable {
    element: Option<Name>,
    algorithm: Option<Name>,
    rule: Option<Name>,
    stiffness: Option<Number>,
    acceleration: Option<Name>,
    start: Option<Name>,
    increments: Option<Spanned<usize>>,
    tolerance: Option<Number>,
    max_steps: Option<Spanned<usize>>,
}

/// `[[check]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CheckTable {
    quantity: Name,
    at: Option<Number>,
    value: Number,
    tolerance: Number,
    kind: Name,
    source: String,
    because: String,
}

const QUANTITIES: [(&str, Quantity); 4] = [
    ("peak-pressure", Quantity::PeakPressure),
    ("half-width", Quantity::HalfWidth),
    ("resultant", Quantity::Resultant),
    ("pressure", Quantity::Pressure),
];
const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];
const RULES: [StiffnessRule; 5] = [
    StiffnessRule::Secant,
    StiffnessRule::Correction,
    StiffnessRule::Literal,
    StiffnessRule::Switching,
    StiffnessRule::Penalty,
];

impl SceneFile {
    /// Reads a file; what is wrong in it is told with its line.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let unreadable = |reason: String| Error::File {
            path: file.into(),
            reason,
            remedy: "give a scene file; `solve --help` tells where its keys are described".into(),
        };
        let size = std::fs::metadata(file).map_err(|error| unreadable(error.to_string()))?.len();
        if size > LARGEST_FILE {
            return Err(unreadable(format!("{size} bytes are no scene; at most {LARGEST_FILE} are read")));
        }
        let text = std::fs::read_to_string(file).map_err(|error| unreadable(error.to_string()))?;
        Self::parse(file, &text)
    }

    /// The same from a text; the file is only named.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        let source = Source { file, text };
        let document: Document = toml::from_str(text).map_err(|error| {
            let place = error.span().unwrap_or(0..0);
            source.refused(place, error.message().trim(), "correct this key; the page on scene files names all of them")
        })?;
        let name = file.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned());
        document.read(source, name)
    }

    /// The checks of a run: that it converged, what every converged run must satisfy, and those of the file.
    pub fn checks(&self, discretisation: &Discretisation, run: &Run) -> Result<Vec<Check>, Error> {
        let tolerance = self.formulation.settings.tolerance;
        let mut checks = vec![Check::norm(
            "The iteration shall converge",
            "residual",
            if run.solution.converged() { run.solution.residual() } else { f64::NAN },
            Reference::own("contact conditions", 0.0),
            tolerance,
            "the tolerance asked for",
        )];
        if run.solution.converged() {
            checks.extend(universal::checks(discretisation, run)?);
        }
        checks.extend(self.wanted.iter().map(|wanted| wanted.check(run)));
        Ok(checks)
    }
}

impl Wanted {
    fn check(&self, run: &Run) -> Check {
        let points = &run.solution.points;
        let (name, value) = match self.quantity {
            Quantity::PeakPressure => ("peak pressure [MPa]".into(), run.measures.peak.pressure),
            Quantity::HalfWidth => ("half-width [mm or rad]".into(), run.measures.half_width),
            Quantity::Resultant => ("resultant [N]".into(), run.transmitted),
            Quantity::Pressure => {
                (format!("pressure at s = {:.6} [MPa]", self.at), profile::interpolate(points, self.at))
            }
        };
        // A run that broke off has no value to be judged.
        let value = if run.solution.converged() { value } else { f64::NAN };
        let reference = Reference { name: self.source.clone(), kind: self.kind, value: self.value };
        let requirement = format!("The file's own check: {}", self.source);
        Check::relative(requirement, name, value, reference, self.tolerance, self.because.clone())
    }
}

impl Document {
    fn read(&self, source: Source, name: String) -> Result<SceneFile, Error> {
        let units = Units::of(source, self.units.as_ref())?;
        let bodies = self.body.get_ref();
        if bodies.is_empty() {
            return Err(source.refused(self.body.span(), "there is no body", "add one as [[body]]"));
        }
        let tables = Tables {
            name: &name,
            units,
            plane: &self.plane,
            thickness: &self.thickness,
            bodies,
            contact: &self.contact,
            reference: self.reference.as_ref(),
            per: &self.mesh.per,
            growth: self.mesh.growth.as_ref(),
        };
        let scene = tables.scene(source)?;
        let resolution = self.mesh.resolution(source)?;
        refuse_large(source, self.mesh.elements.span(), &scene, resolution)?;
        let formulation = self.solve.formulation(source)?;
        formulation.validate(&scene)?;
        let factor = display_factor(&scene.contact.path);
        let along = if factor > 1.0 { 1.0 / factor } else { units.length };
        let wanted = self.check.iter().map(|check| check.wanted(source, &units, along));
        let wanted = wanted.collect::<Result<_, _>>()?;
        let title = self.title.clone().unwrap_or_else(|| "a scene file".into());
        Ok(SceneFile { problem: Problem { name, title, scene, resolution, oracle: None }, formulation, wanted })
    }
}

impl MeshTable {
    fn resolution(&self, source: Source) -> Result<Resolution, Error> {
        let elements = *self.elements.get_ref();
        if !(1..=4096).contains(&elements) {
            let message = format!("`elements` is {elements}");
            return Err(source.refused(self.elements.span(), message, "give 1 to 4096; 8 to 32 are usual"));
        }
        let order = match self.order.as_ref().map(|order| (*order.get_ref(), order.span())) {
            Some((1, _)) => Order::Linear,
            Some((2, _)) | None => Order::Quadratic,
            Some((other, place)) => {
                let remedy = "give 1 for 4-node or 2 for 8-node cells";
                return Err(source.refused(place, format!("`order` is {other}"), remedy));
            }
        };
        Ok(Resolution { elements, refinement: 0, order })
    }
}

/// Refuses meshes beyond [`MOST`], before anything is allocated for them.
fn refuse_large(source: Source, place: Range<usize>, scene: &Scene, resolution: Resolution) -> Result<(), Error> {
    let (pair, grading) = (&scene.contact, &scene.grading);
    let length = pair.stretch * pair.path.metric();
    let candidates = (resolution.elements as f64 * length / grading.unit).round().max(1.0);
    // The smallest of the candidates, as a length and in the contact coordinate.
    let even = grading.end.min(1.0 / grading.end);
    let [size, step] = [length, pair.stretch].map(|whole| even * whole / candidates);
    let counted = |length: f64, first: f64, ratio: f64, coarsest: f64| {
        let until = if ratio > 1.0 { (coarsest / first).ln().max(0.0) / ratio.ln() } else { f64::INFINITY };
        (length / first).min(until + length / coarsest.max(first)) + 2.0
    };
    // Rows of the arcs' blocks share the size of the surface, whatever the radius of the body.
    let arc = |radius: f64, deep: f64| {
        let angle = if matches!(pair.path, ContactPath::Arc(_)) { step } else { size / radius };
        let first = angle * radius * grading.first;
        let along = counted(PI, angle, grading.along, 1.6 * grading.coarsest);
        [along, counted(deep, first, grading.depth, grading.coarsest * deep)]
    };
    let cells = |shape: &Shape| {
        let [along, depth] = match *shape {
            Shape::Rectangle { x, y, .. } => [(x, size, grading.along), (y, size * grading.first, grading.depth)]
                .map(|([from, to], first, ratio)| counted(to - from, first, ratio, grading.coarsest * (to - from))),
            Shape::Disc { radius, .. } => arc(radius, radius),
            Shape::Ring { inner, outer, .. } => arc(inner.radius, outer.radius - inner.radius),
            Shape::Eye { outer_radius, .. } => arc(outer_radius, outer_radius),
        };
        (candidates + along) * (candidates.min(along) + depth)
    };
    let total: f64 = scene.bodies.iter().map(|body| cells(&body.shape)).sum();
    let [most, along] = MOST;
    if total <= most && candidates <= along {
        return Ok(());
    }
    let message = format!("the mesh would have about {total:.1e} cells and {candidates:.0} candidate elements");
    let remedy =
        format!("ask for fewer `elements`, a longer `stretch` or faster growth: {most:.0e} and {along} are solved");
    Err(source.refused(place, message, remedy))
}

impl SolveTable {
    fn formulation(&self, source: Source) -> Result<Formulation, Error> {
        let elements = Element::ALL.map(|element| (element.name(), element));
        let algorithms = Iteration::ALL.map(|algorithm| (algorithm.name(), algorithm));
        let element = named(source, "contact element", &self.element, &elements)?.unwrap_or(Element::Node);
        let algorithm = named(source, "algorithm", &self.algorithm, &algorithms)?.unwrap_or(Iteration::Kinematic);
        let mut formulation = Formulation::new(element, algorithm);
        let rules = RULES.map(|rule| (rule.name(), rule));
        formulation.rule = named(source, "rule", &self.rule, &rules)?.unwrap_or(formulation.rule);
        let accelerations = Acceleration::ALL.map(|acceleration| (acceleration.name(), acceleration));
        formulation.acceleration =
            named(source, "acceleration", &self.acceleration, &accelerations)?.unwrap_or(Acceleration::None);
        let starts = [Start::Closed, Start::Nested].map(|start| (start.name(), start));
        formulation.start = named(source, "start", &self.start, &starts)?.unwrap_or(Start::Closed);
        if let Some(stiffness) = &self.stiffness {
            formulation.stiffness = source.positive("stiffness", stiffness)?;
        }
        if let Some(tolerance) = &self.tolerance {
            formulation.settings.tolerance = source.positive("tolerance", tolerance)?;
        }
        let count = |key: &str, value: &Option<Spanned<usize>>, most: usize, default: usize| match value {
            Some(value) if !(1..=most).contains(value.get_ref()) => {
                let message = format!("`{key}` is {}", value.get_ref());
                Err(source.refused(value.span(), message, format!("give 1 to {most}")))
            }
            Some(value) => Ok(*value.get_ref()),
            None => Ok(default),
        };
        let settings = &mut formulation.settings;
        settings.increments = count("increments", &self.increments, 1000, settings.increments)?;
        settings.max_steps = count("max-steps", &self.max_steps, 1_000_000, settings.max_steps)?;
        Ok(formulation)
    }
}

/// What a name stands for; none where it is left out.
fn named<T: Copy>(source: Source, what: &str, name: &Option<Name>, known: &[(&str, T)]) -> Result<Option<T>, Error> {
    name.as_ref().map(|name| source.choice(what, name, known)).transpose()
}

impl CheckTable {
    /// `along` turns a contact coordinate of the file into mm or rad.
    fn wanted(&self, source: Source, units: &Units, along: f64) -> Result<Wanted, Error> {
        let quantity = source.choice("quantity", &self.quantity, &QUANTITIES)?;
        let unit = match quantity {
            Quantity::PeakPressure | Quantity::Pressure => units.stress,
            Quantity::Resultant => units.force,
            Quantity::HalfWidth => along,
        };
        let at = match (&self.at, quantity) {
            (Some(at), Quantity::Pressure) => {
                along * source.number("at", at, "a coordinate from 0 on", |s| s >= 0.0)?
            }
            (None, Quantity::Pressure) => {
                return Err(source.refused(self.quantity.span(), "a pressure without a place", "add `at`"));
            }
            (Some(at), _) => {
                return Err(source.refused(at.span(), "only `pressure` is taken at a place", "leave `at` out"));
            }
            (None, _) => f64::NAN,
        };
        let value = source.number("value", &self.value, "a finite number that is not 0", |x| x.abs() > 0.0)?;
        Ok(Wanted {
            quantity,
            at,
            value: unit * value,
            tolerance: source.positive("tolerance", &self.tolerance)?,
            kind: source.choice("kind of reference", &self.kind, &KINDS)?,
            source: self.source.clone(),
            because: self.because.clone(),
        })
    }
}
