//! The command line of `contact-vv`.

use std::process::ExitCode;

fn main() -> ExitCode {
    contact_vv::cli::main()
}
