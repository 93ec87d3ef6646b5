//! Asks the other codes for everything again, writes `oracles/frozen` and prints what changed.

use std::process::ExitCode;

use contact_vv::cli::{exit, writable};
use contact_vv::error::Error;
use contact_vv_live::freeze::{discrete, independent};

fn main() -> ExitCode {
    match freeze() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(exit::WRONG_INPUT)
        }
    }
}

fn freeze() -> Result<(), Error> {
    writable::in_checkout("oracles/frozen")?;
    for renew in [discrete, independent] {
        renew()?.iter().for_each(|line| println!("{line}"));
    }
    Ok(())
}
