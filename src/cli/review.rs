//! `report diff`: what moved between two commits, for whoever reviews the change.

use std::fs;
use std::path::Path;

use clap::Args;

use crate::cli::exit::Exit;
use crate::cli::terminal::say;
use crate::error::Error;
use crate::report::diff::tree::Tree;
use crate::report::diff::{Difference, LINES, tree};

/// Where charts of commits are written to be seen, below the project folder.
const SEEN: &str = "target/report-diff";

/// What is compared, and how it is told.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Commit to compare with; without it, where the branch left `main`.
    base: Option<String>,
    /// Commit that is compared with it; without it, the working tree.
    commit: Option<String>,
    /// Fail too where a tolerance was loosened that no error bar explains, a check is gone, asked of fewer runs or held
    /// against this code alone, or the record of checks cannot be read.
    #[arg(long)]
    strict: bool,
    /// Write Markdown, with charts before and after side by side.
    #[arg(long)]
    markdown: bool,
    /// Lines that are told at most; every heading is among them.
    #[arg(long, value_name = "N", default_value_t = LINES)]
    limit: usize,
    /// Address below which `COMMIT/PATH` is a file of a commit, for the charts of `--markdown`; without it they are
    /// written to target/report-diff.
    #[arg(long, value_name = "ADDRESS", requires = "markdown")]
    images: Option<String>,
}

/// Prints the difference and tells whether a verdict got worse.
pub fn run(arguments: &Arguments, root: &Path) -> Result<Exit, Error> {
    let base = arguments.base.clone().map_or_else(|| tree::merge_base(root), Ok)?;
    let before = tree::of_commit(root, &base)?;
    let after =
        arguments.commit.as_deref().map_or_else(|| Tree::on_disk(root), |commit| tree::of_commit(root, commit))?;
    let difference = Difference::of(&before, &after);
    if arguments.markdown {
        let addresses = [
            address(arguments, root, &difference, (&before, Some(&base)), "before")?,
            address(arguments, root, &difference, (&after, arguments.commit.as_deref()), "after")?,
        ];
        say(difference.markdown(arguments.limit, &addresses).trim_end());
    } else {
        say(difference.text(arguments.limit).trim_end());
    }
    Ok(Exit::checked(!(difference.worse || arguments.strict && difference.laxer)))
}

/// Where the charts of a tree are: at an address, in the working tree, or written out.
fn address(
    arguments: &Arguments,
    root: &Path,
    difference: &Difference,
    (tree, commit): (&Tree, Option<&str>),
    side: &str,
) -> Result<String, Error> {
    let Some(commit) = commit else { return Ok(String::new()) };
    if let Some(address) = &arguments.images {
        return Ok(format!("{}/{}/", address.trim_end_matches('/'), tree::commit(root, commit)?));
    }
    for path in difference.told.iter().flat_map(|told| &told.charts) {
        let Some(text) = tree.text(path) else { continue };
        let file = root.join(SEEN).join(side).join(path);
        let written = file.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&file, text));
        written.map_err(|error| Error::unwritable(&file, error))?;
    }
    Ok(format!("{SEEN}/{side}/"))
}
