//! Asking the codes now, and renewing the frozen files.

use crate::error::{Error, Kind};
use crate::oracle::cross_code::frozen::{Frozen, script_hash};
use crate::oracle::cross_code::{Code, live};
use crate::study::cross_code::twin::{Twin, problems};
use crate::study::differences::changes;

/// Asks both codes for everything, writes the frozen files once both have answered, and tells what changed.
pub fn freeze() -> Result<Vec<String>, Error> {
    let answers: Vec<(Code, Frozen)> =
        Code::ALL.into_iter().map(|code| Ok((code, ask_all(code)?))).collect::<Result<_, Error>>()?;
    let mut lines = Vec::new();
    for (code, new) in answers {
        match Frozen::load(code) {
            Ok(old) => lines.extend(changes(code, &old, &new)),
            Err(Error { kind: Kind::MissingFile, .. }) => lines.push(format!("{code}: frozen for the first time")),
            Err(unreadable) => lines.push(format!("{code}: frozen again, as {unreadable}")),
        }
        new.write(code)?;
    }
    Ok(lines)
}

fn ask_all(code: Code) -> Result<Frozen, Error> {
    let mut all = Frozen { scripts: script_hash()?, versions: live::versions()?, discrete: Default::default() };
    for (name, order) in problems() {
        let twin = Twin::of(name, order)?;
        let answer = live::discrete(code, &twin.problem)?;
        all.discrete.insert(twin.problem.name.clone(), twin.digest_of_other(&answer));
    }
    Ok(all)
}
