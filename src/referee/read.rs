//! A file of another code, by its ending.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::case::Case;
use crate::error::Error;
use crate::referee::answer::Answer;
use crate::referee::asked::Asked;
use crate::referee::{calculix, document, frd, grid, table};

/// Largest file that is read \[bytes\].
const LARGEST_FILE: u64 = 256 << 20;
/// What can be handed in.
const KNOWN: &str = "hand in .csv, .json, .vtu, .vtk, .frd or .dat";

/// The answer in a file.
pub fn read(file: &Path, case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let bytes = bytes(file)?;
    parse(file, &bytes, case, asked)
}

/// The answer in the bytes of a file, which is only named.
pub fn parse(file: &Path, bytes: &[u8], case: &Case, asked: &Asked) -> Result<Answer, Error> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "csv" | "tsv" | "txt" => table::parse(file, text(file, bytes)?, &case.scene, asked),
        "json" => document::parse(file, text(file, bytes)?, &case.name, &case.scene, asked),
        "vtu" | "vtk" => grid::parse(file, bytes, &case.scene, asked),
        "frd" => frd::parse(file, text(file, bytes)?, &case.scene, asked),
        "dat" => calculix::forces(file, text(file, bytes)?, &deck_of(file)?, &case.scene, asked),
        _ => Err(Error::file(file, format!("its ending `{ending}` names no format that is read"), KNOWN)),
    }
}

/// The input deck of the same name, which holds the places of the nodes that a table of CalculiX names.
fn deck_of(file: &Path) -> Result<String, Error> {
    let deck = file.with_extension("inp");
    let read = bytes(&deck)?;
    Ok(text(&deck, &read)?.to_owned())
}

fn text<'a>(file: &Path, bytes: &'a [u8]) -> Result<&'a str, Error> {
    let text = std::str::from_utf8(bytes);
    text.map_err(|error| {
        Error::unreadable(file, format!("byte {} is no text", error.valid_up_to()), "write it as UTF-8")
    })
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
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(Error::file(
            file,
            format!("it has more than {LARGEST_FILE} bytes"),
            "hand in the contact side only, as .csv",
        ));
    }
    Ok(bytes)
}
