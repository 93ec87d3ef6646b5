//! The program as it is started, and folders of files for it.

use std::path::{Path, PathBuf};
use std::process::Command;

use contact_vv::checkout::root;
use tempfile::TempDir;

/// The program with its arguments.
pub fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_contact-vv-tested"));
    command.args(arguments);
    command
}

/// How a command ends, what it prints, and what it says of what is wrong.
pub fn ended(command: &mut Command) -> (Option<i32>, String, String) {
    let output = command.output().expect("started");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// A folder that is there as long as it is held.
pub struct Folder(TempDir);

impl Folder {
    pub fn made() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// The path of a file in it.
    pub fn at(&self, name: &str) -> String {
        self.path().join(name).display().to_string()
    }

    /// The path of a file that is written into it.
    pub fn with(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        std::fs::write(self.path().join(name), bytes).expect("written");
        self.at(name)
    }

    /// The paths of files that end so, copied from a folder of the checkout into the same one in it.
    pub fn copied(&self, inside: &str, ending: &str) -> Vec<PathBuf> {
        let to = self.path().join(inside);
        std::fs::create_dir_all(&to).expect("made");
        let files = std::fs::read_dir(root().join(inside)).expect("a folder").map(|file| file.expect("a file").path());
        let copy = |file: PathBuf| {
            let copy = to.join(file.file_name().expect("a name"));
            std::fs::copy(&file, &copy).expect("copied");
            copy
        };
        files.filter(|file| file.extension().is_some_and(|own| own == ending)).map(copy).collect()
    }

    /// The text of a file in it.
    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }
}
