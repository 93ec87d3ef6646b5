//! A file of another code, by its ending.

use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use flate2::read::GzDecoder;

use crate::case::Case;
use crate::case::file::text_of;
use crate::error::Error;
use crate::markdown::significant;
use crate::referee::answer::{Answer, Handed, without_pull};
use crate::referee::asked::Asked;
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::{calculix, document, foreign, frd, grid, pvd, table};
use crate::scene::Scene;

/// Largest file that is read \[bytes\].
const LARGEST_FILE: u64 = 256 << 20;
/// What can be handed in.
const KNOWN: &str =
    "hand in .csv, .tsv, .txt, .rpt, .lis, .json, .vtu, .vtk, .pvd, .frd or .dat, or one of them compressed as .gz";

/// The answer in a file.
pub fn read(file: &Path, case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let bytes = bytes(file)?;
    parse(file, &bytes, case, asked)
}

/// The answer in the bytes of a file, which is only named; one that ends in .gz is decompressed. Refuses radii below 0.
pub fn parse(file: &Path, bytes: &[u8], case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let mut answer = by_ending(file, bytes, case, asked)?;
    answer.mirror(&case.scene);
    // What is negative in compression is a stress.
    for handed in answer.contacts.iter_mut().filter(|handed| asked.tension_positive && !handed.forces) {
        answer.read.extend(without_pull(handed.points.iter_mut().map(|point| &mut point.value)));
    }
    let around = answer.contacts.iter().filter(|handed| case.scene.is_around_axis(handed.contact));
    let ends = |handed: &Handed| Some([handed.points.first()?.position, handed.points.last()?.position]);
    let beyond = |[least, most]: &[f64; 2]| *least < 0.0 - ROUNDING * most.abs();
    match around.filter_map(ends).find(beyond) {
        None => Ok(answer),
        Some([least, _]) => {
            let message = format!(
                "it has a point at {} mm, and positions on bodies of revolution are radii from the axis on",
                significant(least, 4)
            );
            Err(Error::file(file, message, "hand in the points of one side of the axis, at r ≥ 0"))
        }
    }
}

/// Part of the largest radius that rounding explains.
const ROUNDING: f64 = 1e-9;

fn by_ending(file: &Path, bytes: &[u8], case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    if ending == "gz" {
        let within = file.with_extension("");
        // Twice compressed, it would be read without end.
        if within.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gz")) {
            return Err(Error::file(file, "it is compressed twice", KNOWN));
        }
        return parse(&within, &decompressed(file, bytes)?, case, asked);
    }
    let piece = if ending == "pvtu" { pvd::only_piece(file, &text(file, bytes)?) } else { None };
    if let Some(piece) = piece {
        return parse(&piece, &self::bytes(&piece)?, case, asked);
    }
    if asked.has_state() && matches!(ending.as_str(), "json" | "vtu" | "vtk") {
        return Err(State::only(file));
    }
    match ending.as_str() {
        "csv" | "tsv" | "txt" | "rpt" | "lis" => of_table(file, &text(file, bytes)?, &case.scene, asked),
        "json" => document::parse(file, &text(file, bytes)?, &case.name, &case.scene, asked),
        "vtu" | "vtk" => grid::parse(file, bytes, &case.scene, asked),
        "pvd" => of_collection(file, &text(file, bytes)?, case, asked),
        "frd" => frd::parse(file, &text(file, bytes)?, &case.scene, asked),
        "dat" if !calculix::has_forces(&text(file, bytes)?) => of_table(file, &text(file, bytes)?, &case.scene, asked),
        "dat" => exported(file, &text(file, bytes)?, &case.scene, asked),
        _ => Err(foreign::by_ending(file, &ending).unwrap_or_else(|| {
            Error::file(file, format!("its ending `{ending}` names no format that is read"), KNOWN)
        })),
    }
}

/// The answer of a table, or what a text is that is none.
fn of_table(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    table::parse(file, text, scene, asked).map_err(|error| foreign::by_text(file, text).unwrap_or(error))
}

/// The grid of a collection that is judged.
fn of_collection(file: &Path, text: &str, case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let (own, state, all) = pvd::chosen(file, text, asked)?;
    let mut answer = parse(&own, &bytes(&own)?, case, &Asked { time: None, step: None, ..asked.clone() })?;
    answer.read.push(format!("{} of {state}", own.display()));
    answer.notes.extend(state.notes(&all));
    Ok(answer)
}

/// Nodal forces of an exported deck, and the displacements of the same time of the file of fields of the same name,
/// where it has them.
fn exported(file: &Path, table: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let deck = deck_of(file)?;
    let (mut answer, state) = calculix::forces_at(file, table, &deck, scene, asked)?;
    let fields = file.with_extension("frd");
    if fields.exists() {
        let read = bytes(&fields)?;
        let source = Source { file: &fields, text: &text(&fields, &read)? };
        let places = calculix::nodes_of_deck(&Source { file: &file.with_extension("inp"), text: &deck })?;
        let of_deck = (calculix::is_ours(&deck).then_some("mm"), &places);
        answer.field = frd::displacements((&source, scene), asked, of_deck, state)?;
        answer.read.extend(answer.field.is_some().then(|| "displacements from the .frd of the same name".into()));
    }
    Ok(answer)
}

/// The input deck of the same name, which holds the places of the nodes that a table of CalculiX names.
fn deck_of(file: &Path) -> Result<String, Error> {
    let deck = file.with_extension("inp");
    if !deck.exists() {
        let remedy = "put the deck that was run beside the .dat: it has the places of the nodes";
        return Err(Error::missing_file(&deck, remedy));
    }
    let read = bytes(&deck)?;
    Ok(text(&deck, &read)?.into_owned())
}

/// What a file compressed by gzip holds.
fn decompressed(file: &Path, bytes: &[u8]) -> Result<Vec<u8>, Error> {
    let mut plain = Vec::new();
    let read = GzDecoder::new(bytes).take(LARGEST_FILE + 1).read_to_end(&mut plain);
    read.map_err(|error| Error::unreadable(file, error, "compress it by gzip, or hand it in as it is"))?;
    limited(file, plain)
}

/// The text in bytes.
fn text<'a>(file: &Path, bytes: &'a [u8]) -> Result<Cow<'a, str>, Error> {
    let refused = || Error::unreadable(file, "it is no text", "write it as text, in UTF-8 and not in binary");
    text_of(bytes).ok_or_else(refused)
}

fn bytes(file: &Path) -> Result<Vec<u8>, Error> {
    let remedy = "name the file of an answer; `contact-vv judge --help` says what is read";
    if !file.exists() {
        return Err(Error::missing_file(file, remedy));
    }
    let failed = |error: std::io::Error| Error::unreadable(file, error, remedy);
    if !std::fs::metadata(file).map_err(failed)?.is_file() {
        return Err(Error::unreadable(file, "this is no file", remedy));
    }
    let mut bytes = Vec::new();
    File::open(file).map_err(failed)?.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(failed)?;
    limited(file, bytes)
}

/// Refuses what is larger than is read.
fn limited(file: &Path, bytes: Vec<u8>) -> Result<Vec<u8>, Error> {
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(Error::file(
            file,
            format!("it has more than {LARGEST_FILE} bytes"),
            "hand in the contact side only, as .csv",
        ));
    }
    Ok(bytes)
}
