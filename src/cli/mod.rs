//! What the user types.
//!
//! * [`accuracy`] — what `solve` says of an accuracy that was asked for.
//! * [`survey`] — runs recorded surveys with a progress bar, and asks other codes for exported cases.
//! * [`exit`] — how a command ended, as its exit code tells.
//! * [`timings`] — measures speed against accuracy.
//! * [`review`] — what moved between two commits.
//! * [`suite`] — runs all trials with a progress bar, and tells what they found.
//! * [`solve`] — one case, with its outputs.
//! * [`compare`] — one case by all nine formulations.
//! * [`verify`] — scene files with their checks.
//! * [`judge`] — answers of other codes; [`export`] — what they need to run a case.
//! * `bars` — how far each number may be from the truth.
//! * [`json`] — all that is printed as JSON, and its schema.
//! * `terminal` — lines, tables, errors and a bar of progress; `choice` — cases and values by name.
//! * [`vtu`] — its fields for ParaView.
//! * [`new`] — scene files to begin with.
//! * [`manual`] — shell completions and manual pages.
//! * [`writable`] — whether results can be written, and whether nothing is lost by it.

pub mod accuracy;
mod bars;
mod choice;
pub mod compare;
pub mod exit;
pub mod export;
pub mod json;
pub mod judge;
pub mod manual;
pub mod new;
pub mod review;
pub mod solve;
pub mod suite;
pub mod survey;
mod terminal;
pub mod timings;
pub mod verify;
pub mod vtu;
pub mod writable;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;

use crate::case::file;
use crate::case::library::NAMES;
use crate::cli::choice::choice;
use crate::cli::exit::Exit;
use crate::cli::json::{Answer, Listed};
use crate::cli::terminal::{say, show};
use crate::error::Error;
use crate::referee::document;
use crate::report;
use crate::study::sheet::{self, SHEETS};
use crate::study::timings::growth;
use crate::study::timings::precision::Series;
use crate::study::{self, promised};

/// Contact elements and iterations for frictionless elastic contact in 2D, verified.
///
/// Without a command: solves every case of the suite, prints the verdicts and writes VALIDATION.md with its pages and
/// charts.
#[derive(Debug, Parser)]
#[command(name = "contact-vv", bin_name = "contact-vv", version, after_help = examples(&[
    "list",
    "solve cylinder --plot cylinder.svg",
    "new press-fit > mine.toml",
    "solve mine.toml --csv profile.csv --vtu fields.vtu",
    "verify tests/cases",
    "report --check",
]) + "\n\nIn a checkout, `cargo run --release --` stands for `contact-vv`.")]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Solve the suite and write VALIDATION.md, snapshots/pages and snapshots/charts (the default).
    #[command(after_help = examples(&[
        "report",
        "report --only cylinder",
        "report --check",
    ]), args_conflicts_with_subcommands = true)]
    Report {
        /// Write nothing; show what differs and fail when the page, a chart or the record is stale.
        #[arg(long)]
        check: bool,
        /// Solve one case or one study alone, write its page and its charts, and print the page.
        #[arg(long, value_name = "CASE|STUDY", conflicts_with = "check")]
        only: Option<String>,
        #[command(subcommand)]
        part: Option<Part>,
    },
    /// Solve one case of the library, or a scene file of your own.
    #[command(after_help = examples(&[
        "solve cylinder",
        "solve cylinder --element line --algorithm constant --json -",
        "solve cylinder --a-over-r 0.1 --resolution 32 --plot cylinder.svg",
        "solve tests/cases/press-fit.toml --csv profile.csv --vtu fields.vtu",
        "solve tests/cases/cylinder-on-block.toml --accuracy \"0.3 %\"",
    ]))]
    Solve(Box<solve::Arguments>),
    /// Solve one case by all nine formulations, a line each, the fewest operations first; 3 where none of them
    /// converges.
    #[command(after_help = examples(&[
        "compare cylinder",
        "compare mine.toml --json - --plot compared.svg",
        "compare pin-rod --formulations line.varying,line.varying+newton",
    ]))]
    Compare(compare::Arguments),
    /// Solve scene files and judge them by their own checks; fails where one fails.
    #[command(after_help = examples(&["verify tests/cases", "verify mine.toml other.toml --json"]))]
    Verify {
        /// Scene files (*.toml), or folders with some.
        #[arg(required = true, value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// Print every check with its verdict, a line of JSON each, instead of the table.
        #[arg(long)]
        json: bool,
    },
    /// Write all that is needed to run a case with another code: sheet, mesh, input deck, what is wanted back.
    #[command(after_help = examples(&[
        "export cylinder elsewhere",
        "export mine.toml elsewhere",
        "export cylinder elsewhere --condensed",
    ]))]
    Export(export::Arguments),
    /// Judge the answer of another code, on its own mesh, by the truth of a case; 1 where something is not met or
    /// a contact is missing.
    #[command(after_help = examples(&[
        "judge cylinder theirs.csv",
        "judge cylinder theirs.csv --column pressure=CPRESS --unit pressure=MPa --unit position=mm",
        "judge mine.toml forces.csv --order 2 --tolerance \"0.5 %\"",
        "judge cylinder theirs.json --markdown",
        "judge cylinder results/one.csv results/two.csv --junit verdicts.xml",
    ]))]
    Judge(judge::Arguments),
    /// Solve the suite and print every check with its verdict, a line of JSON each; trials that break off fail too.
    #[command(after_help = examples(&["verdicts > verdicts.jsonl"]))]
    Verdicts,
    /// Survey the stability atlas and write snapshots/atlas; interrupted, it resumes.
    Atlas,
    /// Survey what is called converged and write snapshots/converged.csv; interrupted, it resumes.
    Converged(survey::Arguments),
    /// Survey whether accuracies called met are met and write snapshots/met.csv; interrupted, it resumes.
    Met(survey::Arguments),
    /// Survey whether error bars hold and write snapshots/coverage.csv; interrupted, it resumes.
    Coverage(survey::Arguments),
    /// Survey what the constants of error bars are derived from and write snapshots/counted.csv; interrupted, it
    /// resumes.
    Counted(survey::Arguments),
    /// Measure speed against accuracy on one thread and write snapshots/timings; other codes are asked where installed.
    Timings {
        /// Solve one mesh, elements per half-width and refinement, and print the largest memory of the process in
        /// bytes.
        #[arg(long, hide = true, num_args = 2)]
        memory: Option<Vec<u32>>,
        /// Measure only our own points of speed against accuracy; other codes keep what our solve took beside them.
        #[arg(long)]
        points: bool,
        /// Measure only the sphere's contact solve over a plain one.
        #[arg(long, conflicts_with = "points")]
        revolved: bool,
        /// Ask only this code on meshes of its own, and renew its part of the record.
        #[arg(long, conflicts_with_all = ["points", "revolved"], value_parser = choice(Series::ASKED))]
        ask: Option<Series>,
    },
    /// Ask CalculiX, GetFEM, NGSolve, SfePy, Kratos, Akantu, FElupe, scikit-fem and dolfinx for exported cases, and
    /// keep what they write in oracles/frozen/scoreboard.
    #[command(after_help = examples(&["scoreboard"]))]
    Scoreboard,
    /// Name the cases of the library.
    #[command(after_help = examples(&["list", "list --json", "list --references > references.json"]))]
    List {
        /// Print them as JSON.
        #[arg(long)]
        json: bool,
        /// Print their reference values as JSON: value, bar, unit, how it was found, and by whom it is confirmed.
        #[arg(long, conflicts_with = "json")]
        references: bool,
    },
    /// Print a commented scene file for a shape of problem, to begin with.
    #[command(after_help = examples(&[
        "new",
        "new cylinder > mine.toml",
        "new gmsh > mine.toml && contact-vv new mesh > rings.msh",
    ]))]
    New {
        /// The shape of problem; left out, all are listed.
        #[arg(value_parser = choice(new::Template::TOLD))]
        shape: Option<new::Template>,
    },
    /// Print the JSON Schema of all that is printed as JSON, or of what is read.
    #[command(after_help = examples(&[
        "schema > schema.json",
        "schema answer > answer-schema.json",
        "schema scene > scene.schema.json",
        "schema references > references-schema.json",
    ]))]
    Schema {
        /// What it is the schema of.
        #[arg(value_parser = choice(&SCHEMAS), default_value = SCHEMAS[0].1)]
        of: Shown,
    },
    /// Print the completions for a shell.
    #[command(after_help = examples(&[
        "completions bash > ~/.local/share/bash-completion/completions/contact-vv",
        "completions zsh > ~/.zfunc/_contact-vv",
    ]))]
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: Shell,
    },
    /// Print the manual page, or write those of all commands into a folder.
    #[command(after_help = examples(&["man > contact-vv.1", "man ~/.local/share/man/man1"]))]
    Man {
        /// Folder to write into; left out, the page of the program is printed.
        folder: Option<PathBuf>,
        /// Replace files there that are no manual pages of this program.
        #[arg(long)]
        force: bool,
    },
}

/// Makes what is shown.
type Shown = fn() -> String;

/// What a schema may be of: how it is made, its name, and what that is.
const SCHEMAS: [(Shown, &str, &str); 4] = [
    (json::schema, "printed", "All that is printed as JSON"),
    (document::schema, "answer", "An answer that `judge` reads"),
    (file::schema, "scene", "A scene file, for editors"),
    (sheet::schema, "references", "The reference values that `list --references` prints"),
];

/// Examples that the help of a command ends with, each as what follows the name of the program.
fn examples(all: &[&str]) -> String {
    all.iter().fold("Examples:".into(), |text, one| format!("{text}\n  contact-vv {one}"))
}

#[derive(Debug, Subcommand)]
enum Part {
    /// Tell what moved between two commits: verdicts, tolerances, checks, bars, work, surveys, timings, charts; 1 where
    /// a verdict got worse.
    Diff(review::Arguments),
}

/// Runs the command line. Exit codes: 0 all is well, 1 a check failed or the page is stale, 2 the input is wrong, 3 a
/// run did not converge or holds no contact.
pub fn main() -> ExitCode {
    let well = |()| Exit::Well;
    let tell = |text: String| {
        say(text);
        Ok(Exit::Well)
    };
    let outcome = match Cli::parse().command.unwrap_or(Command::Report { check: false, only: None, part: None }) {
        Command::Report { part: Some(Part::Diff(arguments)), .. } => {
            writable::checkout().and_then(|root| review::run(&arguments, &root))
        }
        Command::Report { only: Some(name), .. } => only_command(&name).map(Exit::checked),
        Command::Report { check, .. } => report_command(check).map(Exit::checked),
        Command::Verdicts => writable::checkout().map(|_| Exit::checked(suite::verdicts())),
        Command::Atlas => survey::atlas().map(well),
        Command::Converged(of) => survey::run(&promised::converged::SURVEY, of).map(well),
        Command::Met(of) => survey::run(&promised::met::SURVEY, of).map(well),
        Command::Coverage(of) => survey::run(&promised::bars::SURVEY, of).map(well),
        Command::Counted(of) => survey::run(&promised::counted::SURVEY, of).map(well),
        Command::Timings { memory: Some(mesh), .. } => {
            growth::memory_of_one_solve(mesh[0] as usize, mesh[1]).map(say).map(well)
        }
        Command::Timings { points: true, .. } => timings::points().map(well),
        Command::Timings { revolved: true, .. } => timings::revolved().map(well),
        Command::Timings { ask: Some(code), .. } => timings::ask(code).map(well),
        Command::Timings { .. } => timings::run().map(well),
        Command::Scoreboard => survey::scoreboard().map(well),
        Command::Verify { paths, json } => verify::run(&paths, json),
        Command::Export(arguments) => export::run(&arguments).map(well),
        Command::Judge(arguments) => judge::run(&arguments),
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::List { references: true, .. } => tell(sheet::BUILT_IN.trim_end().into()),
        Command::List { json: true, .. } => {
            tell(Answer::Listed(NAMES.map(|(name, title)| Listed { name, title }).into()).document())
        }
        Command::List { .. } => tell(terminal::named(&NAMES)),
        Command::New { shape } => tell(new::file(shape)),
        Command::Schema { of } => tell(of()),
        Command::Completions { shell } => tell(manual::completions(shell, command())),
        Command::Man { folder, force } => manual::man(folder.as_deref(), command(), force).map(well),
    };
    match outcome {
        Ok(ended) => ended.into(),
        Err(error) => {
            show(&error);
            ExitCode::from(exit::WRONG_INPUT)
        }
    }
}

/// The command line as data.
pub fn command() -> clap::Command {
    Cli::command()
}

/// Whether all checks pass and, with `check`, the committed page is up to date.
fn report_command(check: bool) -> Result<bool, Error> {
    let root = writable::checkout()?;
    if !check {
        refuse_read_only(&root)?;
    }
    let findings = suite::run()?;
    suite::print(&findings);
    let sound = suite::all_pass(&findings);
    let page = report::compose(&findings)?;
    if !check {
        report::write(&page, &root)?;
        say(format!("written: {} and {} files behind it", report::page::PAGE, page.len() - 1));
        return Ok(sound);
    }
    let difference = report::difference(&page, &root)?;
    match &difference {
        None => say("the page is up to date"),
        Some(difference) => {
            say(difference.text(report::diff::LINES).trim_end());
            say("the page is stale: run `cargo run --release`");
        }
    }
    Ok(sound && difference.is_none())
}

/// Whether all checks of a case or a study pass; its page and its charts are written, and the page is printed. How many
/// trials that takes, and the seconds of the last time in this checkout, are told before.
fn only_command(name: &str) -> Result<bool, Error> {
    let root = writable::checkout()?;
    refuse_read_only(&root)?;
    let only = report::Only::named(name)?;
    let (trials, kept) = (only.trials(), root.join("target/only").join(name.replace('/', "-")));
    let last =
        std::fs::read_to_string(&kept).map_or_else(|_| String::new(), |last| format!(", {last} s the last time"));
    eprintln!("{name}: {} trials{last}", trials.len());
    let clock = Instant::now();
    let mut findings = suite::of(&trials)?;
    if only.shows_bars() {
        findings.push(study::on_bars(&findings)?);
    }
    let seconds = format!("{:.1}", clock.elapsed().as_secs_f64());
    // What cannot be kept is not told the next time.
    kept.parent().and_then(|folder| std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&kept, seconds)).ok());
    let files = only.files(&findings)?;
    report::page::write_all(&files, &root)?;
    files.first().iter().for_each(|(_, page)| say(page.trim_end()));
    say(format!("written: {}", files.iter().map(|(path, _)| path.as_str()).collect::<Vec<_>>().join(", ")));
    Ok(suite::all_pass(&findings))
}

/// Refuses a checkout that the page cannot be written to.
fn refuse_read_only(root: &Path) -> Result<(), Error> {
    let remedy = "give the right to write to it, or use `report --check`, which writes nothing";
    let [page, record @ ..] =
        [report::page::PAGE, report::record::CHECKS, report::record::RUNS, report::record::STATEMENTS];
    writable::file(&root.join(page), remedy)?;
    record.iter().try_for_each(|file| writable::file(&root.join(file), remedy))?;
    [report::links::PAGES, report::links::CHARTS, SHEETS]
        .into_iter()
        .try_for_each(|folder| writable::folder(&root.join(folder), remedy))
}
