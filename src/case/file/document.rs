//! The whole file: a case with its scene, its mesh, its formulation and its checks.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::case::definition::Case;
use crate::case::file::bodies::BODY;
use crate::case::file::contact::CONTACTS;
use crate::case::file::folder::nearest_to;
use crate::case::file::form::Form::{List, Number, Table, Text, Word};
use crate::case::file::form::{DESCRIBED, Form, Mistake, may, must, names};
use crate::case::file::mesh::MESH;
use crate::case::file::places::Places;
use crate::case::file::reference::REFERENCE;
use crate::case::file::revolution::PLANES;
use crate::case::file::solve::SOLVE;
use crate::case::file::source::{Source, text_of};
use crate::case::file::units::{FORCES, LENGTHS, STRESSES, Units};
use crate::case::file::unsupported::Unsupported;
use crate::case::file::value::Value;
use crate::case::file::wanted::CHECK;
use crate::case::file::{bodies, contact, hypotheses, mesh, oracle, reference, revolution, solve, wanted};
use crate::error::Error;
use crate::mesh::size::solvable;
use crate::scene::{Body, ReferenceValues, Scene};

/// Largest file that is read \[bytes\].
const LARGEST_FILE: u64 = 1 << 20;

const UNITS: Form = Table(&[
    may("length", Word(|| names(&LENGTHS))),
    may("force", Word(|| names(&FORCES))),
    may("stress", Word(|| names(&STRESSES))),
]);

const DOCUMENT: Form = Table(&[
    may("title", Text).told("what it is, in a sentence"),
    may("source", Text).told("where it comes from; that of its closed forms is known"),
    must("plane", Word(|| names(&PLANES))).told("plane strain, plane stress, or bodies of revolution"),
    may("axis", Word(|| vec!["y", "x"])).told("of bodies of revolution: what they are turned about; y by default"),
    may("thickness", Number).told("of plane bodies; bodies of revolution have none"),
    may("units", UNITS).told("of all numbers: mm, N and MPa by default"),
    must("body", List(&BODY)).told("the bodies that take part in contacts"),
    must("contact", CONTACTS).told("one contact, or several"),
    may("reference", REFERENCE).told("a start only: what makes `stiffness` a pure number"),
    may("mesh", MESH).told("elements on the contact, or an accuracy; bodies whose mesh is given need none"),
    may("solve", SOLVE).told("contact element, algorithm and when to stop"),
    may("check", List(&CHECK)).told("what shall hold: `solve` and `verify` judge it"),
]);

/// The schema of a scene file, for editors (JSON Schema, draft 7).
pub fn schema() -> String {
    let mut schema = DOCUMENT.schema();
    schema["$schema"] = "http://json-schema.org/draft-07/schema#".into();
    schema["title"] = "Scene of contact-vv".into();
    serde_json::to_string_pretty(&schema).expect("a schema can be written as JSON")
}

impl Case {
    /// Reads a scene file; what is wrong in it is reported with its line.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let remedy = "give a scene file; `solve --help` says where its keys are described";
        let failed = |error: std::io::Error| Error::unreadable(file, error, remedy);
        let missing = || match (std::fs::read_link(file), nearest_to(file)) {
            (Ok(to), _) => Error::missing_file(file, format!("it is a link to `{}`: correct it", to.display())),
            (_, Some(meant)) => Error::missing_file(file, format!("did you mean `{}`? {remedy}", meant.display())),
            (_, None) => Error::missing_file(file, remedy),
        };
        if !file.exists() {
            return Err(missing());
        }
        if !std::fs::metadata(file).map_err(failed)?.is_file() {
            return Err(Error::unreadable(file, "this is no file", remedy));
        }
        let mut bytes = Vec::new();
        let size = File::open(file).map_err(failed)?.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(failed)?;
        if size as u64 > LARGEST_FILE {
            let cause = format!("it has more than {LARGEST_FILE} bytes, which no scene needs");
            return Err(Error::unreadable(file, cause, remedy));
        }
        let text = text_of(&bytes).ok_or_else(|| Error::unreadable(file, "it is no text", remedy))?;
        Self::parse(file, &text)
    }

    /// The same from a text; the file is only named.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        let source = Source { file, text };
        let refused = |(place, said): Mistake| {
            let written = text.get(place.clone()).unwrap_or_default();
            match Unsupported::asked_by(written) {
                Some(asked) => source.refused(place, asked.message(written), asked.instead),
                None => source.refused(place, said, DESCRIBED),
            }
        };
        let parsed =
            source.parsed().map_err(|error| refused((error.span().unwrap_or(0..0), error.message().trim().into())))?;
        DOCUMENT.check(&parsed).map_err(refused)?;
        let name = file.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned());
        let file = Value::all(source, &parsed);
        case(file.with(units(file.table("units"))?), name)
    }
}

/// Units by their names; those of the scene where none is given.
fn units(table: Value) -> Result<Units, Error> {
    let factor = |key, known: &[(&str, f64)]| {
        table.get(key).map_or(Ok(1.0), |name| name.choice(&format!("unit of {key}"), known))
    };
    Ok(Units {
        length: factor("length", &LENGTHS)?,
        force: factor("force", &FORCES)?,
        stress: factor("stress", &STRESSES)?,
    })
}

fn case(file: Value, name: String) -> Result<Case, Error> {
    let bodies = file.list("body");
    file.at("body").refuse_if(bodies.is_empty(), "there is no body", "add one as [[body]]")?;
    let contacts = contact::tables(file.at("contact"));
    file.at("contact").refuse_if(contacts.is_empty(), "there is no contact", "add one as [contact]")?;
    let table = file.table("mesh");
    let accuracy = mesh::asked(table)?;
    let (scene, resolution) = mesh::resolution(table, scene(file, &name, &bodies, &contacts)?)?;
    if let Err((message, remedy)) = solvable(&scene, resolution) {
        return Err(mesh::size(table).refused(message, remedy));
    }
    let formulation = solve::formulation(file.table("solve"))?;
    let given: Vec<Option<Value>> = contacts.iter().map(|contact| contact.get("oracle")).collect();
    let read =
        |(contact, given): (usize, &Option<Value>)| given.map(|given| oracle::read(given, &scene, contact)).transpose();
    let oracles = given.iter().enumerate().map(read).collect::<Result<Vec<_>, _>>()?;
    let checks = file.list("check").into_iter().map(|check| wanted::check(check, &bodies, &scene, &oracles));
    let checks = checks.collect::<Result<_, _>>()?;
    for (contact, (given, oracle)) in given.into_iter().zip(&oracles).enumerate() {
        if let (Some(given), Some(oracle)) = (given, oracle) {
            hypotheses::refuse_other_scene(given, (&scene, contact), oracle)?;
        }
    }
    let text = |key, default: &str| file.get(key).map_or(default, Value::text).to_owned();
    Ok(Case {
        resolution,
        accuracy,
        source: text("source", ""),
        formulations: vec![formulation],
        checks,
        oracles,
        places: Some(Places::of(file)),
        ..Case::of(name, text("title", "a scene file"), scene, resolution.elements)
    })
}

/// The scene in mm, N, MPa and radians.
fn scene(file: Value, name: &str, tables: &[Value], contacts: &[Value]) -> Result<Scene, Error> {
    let plane = revolution::plane(file)?;
    let thickness = revolution::thickness(file, plane)?;
    revolution::refuse_other_contacts(plane, contacts)?;
    let body = |table: &Value| bodies::body(plane, contact::is_across(contacts, table.at("name").text()), *table);
    let bodies = tables.iter().map(body).collect::<Result<Vec<Body>, Error>>()?;
    bodies::refuse_equal_names(tables)?;
    let pairs = contact::pairs(plane, tables, &bodies, contacts)?;
    let mut scene = Scene {
        name: name.into(),
        plane,
        contacts: revolution::whole(plane, pairs),
        thickness,
        bodies,
        reference: ReferenceValues { length: 1.0, pressure: 1.0, gap: 1.0 },
        grading: mesh::grading(file.table("mesh"), contacts[0].at("stretch"))?,
    };
    scene.reference = reference::values(file.table("reference"), &scene)?;
    Ok(scene)
}
