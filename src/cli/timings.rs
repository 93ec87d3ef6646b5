//! Measures speed against accuracy with a progress bar.

use std::collections::BTreeMap;
use std::process::Command;
use std::time::Instant;

use indicatif::ProgressBar;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::promised::met;
use crate::study::seconds::{Machine, Spread};
use crate::study::timings::growth::{self, Growth};
use crate::study::timings::precision::{self, Point, Series};
use crate::study::timings::record::{Beside, FOLDER, Measured, Record, seconds_of_ours};

/// Measures everything on one thread and writes the record.
pub fn run() -> Result<(), Error> {
    writable::in_checkout(FOLDER)?;
    let record = growth::on(1, measure)?;
    record.measured.absent.iter().for_each(|(code, why)| say(format!("skipped: {code}: {why}")));
    written(&record)
}

fn measure() -> Result<Record, Error> {
    let bar = progress(growth::MESHES.len() + precision::meshes().len() + Series::CODES.len() + 2);
    let mut growth = Vec::new();
    for mesh in growth::MESHES {
        step(&bar, &format!("growth, {} × 2^{}", mesh.0, mesh.1));
        growth.push(growth::measure(growth::CYLINDER, mesh, memory(mesh.0, mesh.1)?)?);
    }
    let revolved = of_revolution()?;
    let (machine, report, beside, absent) = (Machine::here(), f64::NAN, vec![], BTreeMap::new());
    let measured = Measured { machine, growth, revolved, report, beside, absent };
    let mut record = Record { measured, points: own_points(&bar)? };
    for code in Series::CODES {
        step(&bar, code.name());
        if let Err(why) = asked(&mut record, code)? {
            record.measured.absent.insert(code.name().into(), why);
        }
    }
    step(&bar, "the report");
    // In a process of its own, which writes nothing.
    let clock = Instant::now();
    itself(&["verdicts"])?;
    record.measured.report = clock.elapsed().as_secs_f64();
    bar.finish_and_clear();
    Ok(record)
}

fn step(bar: &ProgressBar, what: &str) {
    bar.inc(1);
    bar.set_message(what.to_owned());
}

/// Our points of speed against accuracy; what searches for an accuracy take is measured and recorded beside them.
fn own_points(bar: &ProgressBar) -> Result<Vec<Point>, Error> {
    let mut points = Vec::new();
    for (series, mesh) in precision::meshes() {
        step(bar, &format!("{}, {mesh}", series.name()));
        points.extend(precision::measure(series, mesh)?);
    }
    step(bar, "searches for an accuracy");
    met::time_beside()?;
    Ok(points)
}

/// Measures our own points of speed against accuracy and the searches for an accuracy again; other codes keep what our
/// solve took beside them.
pub fn points() -> Result<(), Error> {
    writable::in_checkout(FOLDER)?;
    let mut record = of_this_processor()?;
    let bar = progress(precision::meshes().len() + 1);
    let own = growth::on(1, || own_points(&bar))?;
    bar.finish_and_clear();
    record.points.retain(|point| Series::CODES.contains(&point.series));
    record.points.splice(0..0, own);
    written(&record)
}

/// Measures the sphere's contact solve over a plain one again; all else stays.
pub fn revolved() -> Result<(), Error> {
    writable::in_checkout(FOLDER)?;
    let mut record = of_this_processor()?;
    record.measured.revolved = growth::on(1, of_revolution)?;
    written(&record)
}

/// The record, of which a part is measured again; refused on another processor, whose seconds are others.
fn of_this_processor() -> Result<Record, Error> {
    let record = Record::read()?;
    let [was, is] = [&record.measured.machine, &Machine::here()].map(|machine| machine.processor.clone());
    let message = format!("the record is of {was}, and this is {is}");
    let remedy = "run `contact-vv timings`, which measures everything on one machine";
    if was == is { Ok(record) } else { Err(Error::at("timings", message, remedy)) }
}

fn of_revolution() -> Result<Vec<Growth>, Error> {
    let (case, meshes) = growth::SPHERE;
    growth::MESHES[..meshes].iter().map(|mesh| growth::measure(case, *mesh, None)).collect()
}

/// Asks one code and writes its part of the record.
pub fn ask(code: Series) -> Result<(), Error> {
    writable::in_checkout(FOLDER)?;
    let mut record = Record::read()?;
    let answer = growth::on(1, || asked(&mut record, code))?;
    let remedy = "bash oracles/peers/setup.sh installs it; the record stays as it was";
    answer.map_err(|why| Error::at("timings", why, remedy))?;
    written(&record)
}

/// Takes in what a code answers, with our own cheapest solve before and after it; the reason where it does not answer.
fn asked(record: &mut Record, code: Series) -> Result<Result<(), String>, Error> {
    let mut own = seconds_of_ours(&record.points)?;
    let lines = match precision::precision(code)? {
        Ok(lines) => lines,
        Err(why) => return Ok(Err(why)),
    };
    own.extend(seconds_of_ours(&record.points)?);
    let version = lines.first().map_or_else(String::new, precision::version);
    let points = lines.iter().enumerate().map(|(mesh, line)| precision::answered(code, mesh, line)).collect();
    record.renew(points, Beside { code, version, seconds: Spread::of(&own), machine: Machine::here() });
    Ok(Ok(()))
}

fn written(record: &Record) -> Result<(), Error> {
    record.write()?;
    say(format!("written: {FOLDER}; `cargo run --release` draws it"));
    Ok(())
}

/// Largest memory of a process that solves this mesh and does nothing else \[bytes\]; none where it does not tell.
fn memory(elements: usize, refinement: u32) -> Result<Option<f64>, Error> {
    let output = itself(&["timings", "--memory", &elements.to_string(), &refinement.to_string()])?;
    Ok(output.trim().parse().ok().filter(|bytes: &f64| bytes.is_finite()))
}

/// What this program prints when it is started with some arguments.
fn itself(arguments: &[&str]) -> Result<String, Error> {
    let remedy = "leave the program where it was started: it measures itself";
    let failed = |error: std::io::Error| Error::at("contact-vv", error.to_string(), remedy);
    let program = std::env::current_exe().map_err(failed)?;
    let output = Command::new(program).args(arguments).output().map_err(failed)?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
