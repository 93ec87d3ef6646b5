//! The whole file: a case with its mesh, its formulation and its checks.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use serde::Deserialize;
use toml::Spanned;

use crate::algorithm::{Acceleration, Criterion, Spring, StiffnessRule, StiffnessUnit};
use crate::case::definition::Case;
use crate::case::file::scene::Tables;
use crate::case::file::tables::{BodyTable, ContactTable, ContactTables, Keyed, Name, Number, ReferenceTable};
use crate::case::file::units::{Units, UnitsTable};
use crate::case::file::unsupported::Unsupported;
use crate::case::file::{Source, hypotheses, nearest_to};
use crate::error::Error;
use crate::mesh::size::solvable;
use crate::solve::{Element, Formulation, Iteration};

use super::mesh::MeshTable;
use super::places::{Places, PlacesOfContact};
use super::wanted::CheckTable;

/// Largest file that is read \[bytes\].
const LARGEST_FILE: u64 = 1 << 20;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    title: Option<String>,
    source: Option<String>,
    plane: Name,
    thickness: Number,
    units: Option<Keyed<UnitsTable>>,
    body: Spanned<Vec<Keyed<BodyTable>>>,
    contact: Spanned<ContactTables>,
    reference: Option<Keyed<ReferenceTable>>,
    mesh: Option<Spanned<Keyed<MeshTable>>>,
    solve: Option<Spanned<Keyed<SolveTable>>>,
    #[serde(default)]
    check: Vec<Keyed<CheckTable>>,
}

/// `[solve]`: everything optional.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct SolveTable {
    element: Option<Name>,
    algorithm: Option<Name>,
    rule: Option<Name>,
    bound: Option<Number>,
    spring: Option<Name>,
    stiffness: Option<Number>,
    layer_thickness: Option<Number>,
    acceleration: Option<Name>,
    increments: Option<Spanned<usize>>,
    criterion: Option<Name>,
    tolerance: Option<Number>,
    #[serde(alias = "max-steps")]
    max_iterations: Option<Spanned<usize>>,
}

impl Case {
    /// Reads a scene file; what is wrong in it is reported with its line.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let remedy = "give a scene file; `solve --help` says where its keys are described";
        let failed = |error: std::io::Error| Error::unreadable(file, error, remedy);
        let missing = || match nearest_to(file) {
            Some(meant) => Error::missing_file(file, format!("did you mean `{}`? {remedy}", meant.display())),
            None => Error::missing_file(file, remedy),
        };
        if !file.exists() {
            return Err(missing());
        }
        if !std::fs::metadata(file).map_err(failed)?.is_file() {
            return Err(Error::unreadable(file, "this is no file", remedy));
        }
        let mut text = String::new();
        let size =
            File::open(file).map_err(failed)?.take(LARGEST_FILE + 1).read_to_string(&mut text).map_err(failed)?;
        if size as u64 > LARGEST_FILE {
            let cause = format!("it has more than {LARGEST_FILE} bytes, which no scene needs");
            return Err(Error::unreadable(file, cause, remedy));
        }
        Self::parse(file, &text)
    }

    /// The same from a text; the file is only named.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        let source = Source { file, text };
        let document: Document = toml::from_str(text).map_err(|error| {
            let place = error.span().unwrap_or(0..0);
            let said = error.message().trim();
            let written = text.get(place.clone()).unwrap_or_default();
            match Unsupported::asked_by(written) {
                Some(asked) => source.refused(place, asked.message(written), asked.instead),
                None => source.refused(place, said, "add or correct it; tests/cases/README.md describes every key"),
            }
        })?;
        let name = file.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned());
        document.read(source, name)
    }
}

impl Document {
    fn places(&self, source: Source) -> Places {
        let contacts: Vec<_> = self.contact.get_ref().0.iter().map(PlacesOfContact::of).collect();
        let solve = self.solve.as_ref().map_or_else(|| self.contact.span(), Spanned::span);
        let stiffness = self.solve.as_ref().and_then(|table| table.get_ref().stiffness.as_ref());
        Places {
            file: source.file.into(),
            meshes: self.body.get_ref().iter().filter_map(|body| body.shape.get_ref().mesh(source.file)).collect(),
            text: source.text.into(),
            bodies: self.body.get_ref().iter().map(|body| body.name.span()).collect(),
            loads: self.body.get_ref().iter().map(|body| body.loads.iter().map(Spanned::span).collect()).collect(),
            stiffness: stiffness.map_or_else(|| solve.clone(), Spanned::span),
            solve,
            contacts,
        }
    }

    fn read(&self, source: Source, name: String) -> Result<Case, Error> {
        let units = Units::of(source, self.units.as_deref())?;
        let bodies = self.body.get_ref();
        if bodies.is_empty() {
            return Err(source.refused(self.body.span(), "there is no body", "add one as [[body]]"));
        }
        let contacts = &self.contact.get_ref().0[..];
        let Some(contact) = contacts.first() else {
            return Err(source.refused(self.contact.span(), "there is no contact", "add one as [contact]"));
        };
        let none = Spanned::new(self.body.span(), Keyed::default());
        let table = self.mesh.as_ref().unwrap_or(&none);
        let mesh = table.get_ref();
        let accuracy = mesh.asked(source)?;
        let tables = Tables {
            name: &name,
            units,
            plane: &self.plane,
            thickness: &self.thickness,
            bodies,
            contacts,
            reference: self.reference.as_deref(),
            per: mesh.per(&contact.stretch),
            growth: mesh.growth(),
        };
        let (scene, resolution) = mesh.resolution(source, &table.span(), tables.scene(source)?)?;
        if let Err((message, remedy)) = solvable(&scene, resolution) {
            return Err(source.refused(mesh.place(&table.span()), message, remedy));
        }
        let default = Keyed::default();
        let formulation = self.solve.as_ref().map_or(&default, Spanned::get_ref).formulation(source)?;
        let oracle = |(contact, table): (usize, &ContactTable)| {
            table.oracle.as_ref().map(|oracle| oracle.get_ref().read(source, &units, &scene, contact)).transpose()
        };
        let oracles = contacts.iter().enumerate().map(oracle).collect::<Result<Vec<_>, _>>()?;
        let checks = self.check.iter().map(|check| check.check(source, &units, bodies, &scene, &oracles));
        let checks = checks.collect::<Result<_, _>>()?;
        for (contact, (table, oracle)) in contacts.iter().zip(&oracles).enumerate() {
            if let (Some(given), Some(oracle)) = (&table.oracle, oracle) {
                hypotheses::refuse_other_scene(source, &units, given, (&scene, contact), oracle)?;
            }
        }
        let title = self.title.clone().unwrap_or_else(|| "a scene file".into());
        Ok(Case {
            resolution,
            accuracy,
            source: self.source.clone().unwrap_or_default(),
            formulations: vec![formulation],
            checks,
            oracles,
            places: Some(self.places(source)),
            ..Case::of(name, title, scene, resolution.elements)
        })
    }
}

impl SolveTable {
    fn formulation(&self, source: Source) -> Result<Formulation, Error> {
        let elements = Element::ALL.map(|element| (element.name(), element));
        let algorithms = Iteration::ALL.map(|algorithm| (algorithm.name(), algorithm));
        let element = named(source, "contact element", &self.element, &elements)?.unwrap_or(Element::Node);
        let algorithm = named(source, "algorithm", &self.algorithm, &algorithms)?.unwrap_or(Iteration::Kinematic);
        let rules = StiffnessRule::ALL.map(|rule| (rule.name(), rule));
        let rule = named(source, "rule", &self.rule, &rules)?;
        let accelerations = Acceleration::ALL.map(|acceleration| (acceleration.name(), acceleration));
        let acceleration = named(source, "acceleration", &self.acceleration, &accelerations)?;
        let mut formulation = Formulation::with(element, algorithm, rule, acceleration);
        let springs = Spring::ALL.map(|spring| (spring.name(), spring));
        if let Some(spring) = named(source, "spring", &self.spring, &springs)? {
            formulation = formulation.with_springs(spring, acceleration);
        }
        if let Some(bound) = &self.bound {
            formulation.leeway.bound = source.factor("bound", bound)?;
        }
        if let Some(thickness) = &self.layer_thickness {
            formulation.layer_thickness = source.positive("layer-thickness", thickness)?;
        }
        if let Some(stiffness) = &self.stiffness {
            formulation.stiffness = source.positive("stiffness", stiffness)?;
            formulation.stiffness_unit = StiffnessUnit::Reference;
        }
        let criteria = Criterion::ALL.map(|criterion| (criterion.name(), criterion));
        formulation.settings.criterion =
            named(source, "criterion", &self.criterion, &criteria)?.unwrap_or(Criterion::Error);
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
        settings.max_iterations = count("max-iterations", &self.max_iterations, 1_000_000, settings.max_iterations)?;
        Ok(formulation)
    }
}

/// What a name stands for; none where it is left out.
fn named<T: Copy>(source: Source, what: &str, name: &Option<Name>, known: &[(&str, T)]) -> Result<Option<T>, Error> {
    name.as_ref().map(|name| source.choice(what, name, known)).transpose()
}
