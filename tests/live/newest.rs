//! Today's dolfinx in a process of its own answers what was frozen, as Debian's does in this one: both versions answer
//! the same.

use std::path::Path;

use contact_vv::error::Error;
use contact_vv::oracle::cross_code::Code;
use contact_vv::oracle::cross_code::frozen::{Frozen, changed_versions};
use contact_vv::oracle::cross_code::independent::{Asked, Folder, Independent};
use contact_vv::study::cross_code::{Twin, problems};
use contact_vv::study::differences::largest_change;
use contact_vv::study::independent::run::ASKED;
use contact_vv_live::newest;
use libtest_mimic::{Completion, Failed, Trial};

/// Largest relative difference of contact pressures and displacements by two direct solvers.
const SOLVED: f64 = 1e-8;

/// The trial.
pub fn trial() -> Trial {
    Trial::ignorable_test("today's dolfinx answers what is frozen", || match newest::python() {
        Some(python) => answers(&python).map_err(|error| Failed::from(error.to_string())),
        None => Ok(Completion::ignored_with("`bash oracles/setup.sh` has found no Python from 3.12 on")),
    })
}

fn answers(python: &Path) -> Result<Completion, Error> {
    let frozen = Frozen::read(Code::Dolfinx)?;
    let twins = problems().into_iter().map(|(name, order)| Twin::of(name, order)).collect::<Result<Vec<_>, _>>()?;
    let (now, answers) = newest::discrete(python, &twins)?;
    let same = |change: f64, name: &str| {
        let differ = changed_versions(&frozen.versions, &now);
        assert!(change <= SOLVED, "{name}: dolfinx {} answers otherwise by {change:e}; {differ}", now["dolfinx"]);
    };
    for (twin, answer) in twins.iter().zip(&answers) {
        let (name, digest) = (&twin.problem.name, twin.digest_of_other(answer));
        same(largest_change(&digest.numbers(), &frozen.discrete[name].numbers()), name);
    }
    for (name, Asked { scene, answers }) in &Independent::read()?.scenes {
        for (script, kept) in answers.iter().filter(|(script, _)| script.folder() == Folder::Dolfinx) {
            let asked = kept.iter().filter(|one| one.dofs <= ASKED).count();
            let (_, found) = newest::series(python, *script, scene, asked)?;
            same(largest_change(&Asked::numbers(&found), &Asked::numbers(&kept[..asked])), name);
        }
    }
    Ok(Completion::Completed)
}
