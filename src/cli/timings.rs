//! Measures speed against accuracy with a progress bar.

use std::process::Command;
use std::time::Instant;

use indicatif::ProgressBar;

use crate::checkout::root;
use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::timings::answers::Answers;
use crate::study::timings::code::Code;
use crate::study::timings::compared::apart;
use crate::study::timings::machine::Machine;
use crate::study::timings::others::{self, OtherPoint, Peer};
use crate::study::timings::precision::{Family, Point};
use crate::study::timings::record::{Absent, Beside, FOLDER, Measured, Record};
use crate::study::timings::{digits, growth, precision, targets};

/// Repeats of the comparison of nine formulations with one.
const REPEATS: usize = 5;

/// So many threads; 0 for as many as the processor offers.
fn pool(threads: usize) -> Result<rayon::ThreadPool, Error> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| {
        Error::at("timings", format!("no thread can be started: {error}"), "free memory, or raise the limit of threads")
    })
}

/// Measures everything on one thread and writes the record.
pub fn run() -> Result<(), Error> {
    writable::folder(&root().join(FOLDER), writable::CHECKOUT)?;
    let record = pool(1)?.install(measure)?;
    record.write()?;
    for target in targets::targets(&record) {
        let met = target.met.map_or("—", |met| if met { "✓" } else { "✗" });
        say(format!("{met} {}: {} (asked: {})", target.what, target.measured, target.asked));
    }
    record.measured.skipped().into_iter().for_each(|what| say(format!("skipped: {what}")));
    say(format!("written: {FOLDER}; `cargo run --release` draws it"));
    Ok(())
}

fn measure() -> Result<Record, Error> {
    let meshes = precision::meshes();
    let bar =
        progress(growth::MESHES.len() + meshes.len() + digits::MESHES.len() + Code::ALL.len() + Peer::ALL.len() + 2);
    let step = |what: &str| {
        bar.inc(1);
        bar.set_message(what.to_owned());
    };
    bar.set_message("nine formulations");
    let nine = growth::NINE.map(|mesh| growth::nine(mesh, REPEATS)).into_iter().collect::<Result<_, _>>()?;
    let mut measured = Vec::new();
    for mesh in growth::MESHES {
        step(&format!("growth, {} × 2^{}", mesh.0, mesh.1));
        measured.push(growth::measure(mesh, memory(mesh.0, mesh.1)?)?);
    }
    let (mut points, answers) = (Vec::new(), Answers::of(Family::Cylinder)?);
    for (family, order, elements) in meshes {
        step(&format!("{}, {}-node, {elements} elements", family.name(), order.nodes_per_cell()));
        let answers = if family == Family::Cylinder { &answers } else { &Answers::HERTZ };
        points.extend(precision::measure(family, order, elements, answers)?);
    }
    let mut more = Vec::new();
    for (cells, repeats) in digits::MESHES {
        step(&format!("more digits, {cells:?}"));
        more.push(digits::measure(cells, repeats)?);
    }
    let (mut others, mut peers, mut absent) = (Vec::new(), Vec::new(), Vec::new());
    let mut beside = Vec::new();
    for code in Code::ALL {
        step(code.name());
        let (answer, own) = asked(code, &points)?;
        answer.map_or_else(|why| absent.push(Absent { code: code.name().into(), why }), |found| others.extend(found));
        beside.push(own);
    }
    for peer in Peer::ALL {
        step(peer.name());
        others::cylinder(peer)?
            .map_or_else(|why| absent.push(Absent { code: peer.name().into(), why }), |found| peers.extend(found));
    }
    step("the report");
    let report = report_seconds(&bar)?;
    bar.finish_and_clear();
    let floor = Answers::unsettled()?;
    let measured = Measured {
        machine: Machine::here(),
        growth: measured,
        nine,
        report,
        floor,
        others,
        beside,
        peers,
        absent,
        digits: more,
    };
    Ok(Record { measured, points })
}

/// Measures our own points of speed against accuracy again, and marks what other codes took as of another run.
pub fn points() -> Result<(), Error> {
    writable::folder(&root().join(FOLDER), writable::CHECKOUT)?;
    let mut record = Record::read()?;
    record.points = pool(1)?.install(|| {
        let meshes = precision::meshes();
        let (bar, answers) = (progress(meshes.len()), Answers::of(Family::Cylinder)?);
        let mut points = Vec::new();
        for (family, order, elements) in meshes {
            bar.inc(1);
            let answers = if family == Family::Cylinder { &answers } else { &Answers::HERTZ };
            points.extend(precision::measure(family, order, elements, answers)?);
        }
        bar.finish_and_clear();
        Ok::<_, Error>(points)
    })?;
    let machine = record.measured.machine.clone();
    record.measured.beside.iter_mut().for_each(|beside| {
        beside.apart.get_or_insert_with(|| machine.clone());
    });
    record.write()?;
    apart(&record).into_iter().for_each(say);
    say(format!("written: {FOLDER}; `cargo run --release` draws it"));
    Ok(())
}

/// What a code answers, or why it does not; and our own cheapest solve before and after it.
fn asked(code: Code, points: &[Point]) -> Result<(Result<Vec<OtherPoint>, String>, Beside), Error> {
    let mut own = targets::cheapest_laps(points)?;
    let answer = others::precision(code)?;
    own.extend(targets::cheapest_laps(points)?);
    Ok((answer, Beside::of(code, &own)))
}

/// Asks one code and writes its part of the record, marked as a run of its own.
pub fn ask(code: Code) -> Result<(), Error> {
    writable::folder(&root().join(FOLDER), writable::CHECKOUT)?;
    let mut record = Record::read()?;
    let (answer, beside) = pool(1)?.install(|| asked(code, &record.points))?;
    let remedy = "bash oracles/peers/setup.sh installs it; the record stays as it was";
    record.measured.renew(answer.map_err(|why| Error::at("timings", why, remedy))?, beside);
    record.write()?;
    apart(&record).into_iter().for_each(say);
    say(format!("written: {FOLDER}; `cargo run --release` draws it"));
    Ok(())
}

/// Largest memory of a process that solves this mesh and does nothing else \[bytes\]; none where it does not tell.
fn memory(elements: usize, refinement: u32) -> Result<Option<f64>, Error> {
    let output = itself(&["timings", "--memory", &elements.to_string(), &refinement.to_string()])?;
    Ok(output.trim().parse().ok().filter(|bytes: &f64| bytes.is_finite()))
}

/// Seconds of the whole report in a process of its own; it writes nothing.
fn report_seconds(bar: &ProgressBar) -> Result<f64, Error> {
    let clock = Instant::now();
    bar.tick();
    itself(&["verdicts"])?;
    Ok(clock.elapsed().as_secs_f64())
}

/// What this program prints when it is started with some arguments.
fn itself(arguments: &[&str]) -> Result<String, Error> {
    let remedy = "leave the program where it was started: it measures itself";
    let failed = |error: std::io::Error| Error::at("contact-vv", error.to_string(), remedy);
    let program = std::env::current_exe().map_err(failed)?;
    let output = Command::new(program).args(arguments).output().map_err(failed)?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
