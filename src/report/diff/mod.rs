//! What moved between two commits, for whoever reviews the change: what it means first, what it looks like last.
//!
//! * [`tree`] — committed results as texts by path; [`git`] — those of a commit.
//! * [`pairs`] — which check is which, renamed ones too; [`groups`] — like changes in one row.
//! * [`tolerances`], [`verdicts`], [`membership`], [`statements`], [`shares`], [`bars`], [`work`], [`surveys`], [`timings`],
//!   [`charts`], [`pages`] — one thing told each.
//! * [`table`] — recorded tables and documents as cells.
//! * [`told`] — a heading with rows; [`words`] — changes in words; [`written`] — all of it as text or Markdown.

pub mod bars;
pub mod charts;
pub mod git;
pub mod groups;
pub mod membership;
pub mod pages;
pub mod pairs;
pub mod shares;
pub mod statements;
pub mod surveys;
pub mod table;
pub mod timings;
pub mod told;
pub mod tolerances;
pub mod tree;
pub mod verdicts;
pub mod words;
pub mod work;
pub mod written;

use serde::de::DeserializeOwned;

use crate::report::record::{self, CHECKS, RUNS, STATEMENTS};
use pairs::Pairs;
use told::Told;
use tree::{Moved, Tree};

/// What moved from one tree to another.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Names of both.
    pub names: [String; 2],
    /// What could not be compared, and why.
    pub notes: Vec<String>,
    /// What moved, the most important first.
    pub told: Vec<Told>,
    /// Whether a verdict got worse, or a new check fails.
    pub worse: bool,
}

impl Difference {
    /// Compares two trees.
    pub fn of(before: &Tree, after: &Tree) -> Self {
        let mut notes = Vec::new();
        let trees = [before, after];
        let checks = both(trees, CHECKS, "checks, verdicts, tolerances and bars", &mut notes);
        let runs = both(trees, RUNS, "runs of the suite", &mut notes);
        let statements = both(trees, STATEMENTS, "statements of the paper", &mut notes);
        let pairs = Pairs::of(&checks[0], &checks[1]);
        let moved = tree::moved(before, after);
        let files = |kind: Kind| moved.iter().filter(|one| Kind::of(one) == kind).collect::<Vec<&Moved>>();
        let told = [
            tolerances::told(&pairs.both),
            verdicts::told(&pairs.both),
            membership::told(&pairs),
            statements::told(&statements[0], &statements[1]).into_iter().collect(),
            shares::told(&pairs.both).into_iter().collect(),
            bars::told(&pairs.both),
            work::told(runs.each_ref().map(Vec::as_slice), trees),
            surveys::told(&files(Kind::Survey)).into_iter().collect(),
            charts::told(&files(Kind::Chart)),
            pages::told(&files(Kind::Page)).into_iter().collect(),
            timings::told(&files(Kind::Timing)).into_iter().collect(),
        ];
        let worse = verdicts::worse(&pairs);
        Self { names: trees.map(|tree| tree.name.clone()), notes, told: told.concat(), worse }
    }
}

/// What a file is, as it is compared.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Compared,
    Survey,
    Timing,
    Chart,
    Page,
}

impl Kind {
    fn of((path, before, after): &Moved) -> Self {
        let recorded = path.ends_with(".csv") || path.ends_with(".json");
        let frozen = |text: &Option<&str>| text.is_some_and(|text| work::is_frozen_run(path, text));
        match path {
            path if [CHECKS, RUNS, STATEMENTS].contains(path) || frozen(before) || frozen(after) => Self::Compared,
            path if recorded && path.starts_with("snapshots/timings/") => Self::Timing,
            _ if recorded => Self::Survey,
            path if path.ends_with(".svg") => Self::Chart,
            _ => Self::Page,
        }
    }
}

/// The rows of both trees; none at all, and one note, where a tree has no such file or it cannot be read.
fn both<T: DeserializeOwned>(trees: [&Tree; 2], file: &str, what: &str, notes: &mut Vec<String>) -> [Vec<T>; 2] {
    let read = |tree: &Tree| match tree.text(file) {
        None => Err(format!("{} has no {file}", tree.name)),
        Some(text) => record::parsed(text).map_err(|why| format!("{file} of {} cannot be read: {why}", tree.name)),
    };
    match trees.map(read) {
        [Ok(before), Ok(after)] => [before, after],
        [before, after] => {
            let whys: Vec<String> = before.err().into_iter().chain(after.err()).collect();
            notes.push(format!("{}: {what} are not compared", whys.join(", ")));
            Default::default()
        }
    }
}
