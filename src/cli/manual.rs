//! Shell completions and manual pages, made of the command line itself.

use std::path::Path;

use clap::Command;
use clap_complete::Shell;

use crate::cli::terminal::say;
use crate::cli::writable;
use crate::error::Error;

/// Name of the program.
const NAME: &str = "contact-vv";

/// Prints the completions for a shell.
pub fn completions(shell: Shell, mut command: Command) {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, NAME, &mut script);
    say(String::from_utf8_lossy(&script).trim_end());
}

/// Prints the page of the program, or writes those of all its commands into a folder.
pub fn man(folder: Option<&Path>, command: Command) -> Result<(), Error> {
    let Some(folder) = folder else {
        let mut page = Vec::new();
        let made = clap_mangen::Man::new(command).render(&mut page);
        made.map_err(|error| Error::at("man", error.to_string(), "name a folder to write the pages into"))?;
        say(String::from_utf8_lossy(&page).trim_end());
        return Ok(());
    };
    writable::folder(folder, "name a folder that may be written")?;
    let unwritable = |error: std::io::Error| Error::unwritable(folder, error);
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    clap_mangen::generate_to(command, folder).map_err(unwritable)?;
    say(format!(
        "written: the manual pages to {}; `man {NAME}` finds them where MANPATH names that folder",
        folder.display()
    ));
    Ok(())
}
