//! Shell completions and manual pages, made of the command line itself.

use std::path::{Path, PathBuf};

use clap::Command;
use clap_complete::Shell;

use crate::cli::terminal::say;
use crate::cli::writable::{self, Output};
use crate::error::Error;

/// Name of the program.
const NAME: &str = "contact-vv";

/// The completions for a shell.
pub fn completions(shell: Shell, mut command: Command) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, NAME, &mut script);
    String::from_utf8_lossy(&script).trim_end().into()
}

/// Prints the page of the program, or writes those of all its commands into a folder.
pub fn man(folder: Option<&Path>, command: Command, force: bool) -> Result<(), Error> {
    let Some(folder) = folder else {
        let mut page = Vec::new();
        let made = clap_mangen::Man::new(command).render(&mut page);
        made.map_err(|error| Error::at("man", error.to_string(), "name a folder to write the pages into"))?;
        say(String::from_utf8_lossy(&page).trim_end());
        return Ok(());
    };
    writable::folder(folder, "name a folder that may be written")?;
    let pages = if folder.is_dir() { pages(NAME, &command) } else { vec![] };
    let pages: Vec<PathBuf> = pages.iter().map(|page| folder.join(page)).collect();
    let is_page = |there: &[u8]| std::str::from_utf8(there).is_ok_and(|text| text.contains("\n.TH contact-vv"));
    let pages = pages.iter().map(|path| Some(Output { option: "page", path, is_earlier: Box::new(is_page) }));
    writable::refuse("man", pages, &[], force)?;
    let unwritable = |error: std::io::Error| Error::unwritable(folder, error);
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    clap_mangen::generate_to(command, folder).map_err(unwritable)?;
    say(format!(
        "written: the manual pages to {}; `man {NAME}` finds them where MANPATH names that folder",
        folder.display()
    ));
    Ok(())
}

/// The names of a command's page and of those of its own commands.
fn pages(name: &str, command: &Command) -> Vec<String> {
    let below = command.get_subcommands().filter(|own| !own.is_hide_set());
    let below = below.flat_map(|own| pages(&format!("{name}-{}", own.get_name()), own));
    std::iter::once(format!("{name}.1")).chain(below).collect()
}
