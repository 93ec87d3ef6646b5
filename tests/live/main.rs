//! Other programs, asked now: the codes that the suite is held against, faults in their scripts, and what reads our
//! outputs.

mod newest;
mod planted;
mod readers;
mod revolution;
#[path = "../truth.rs"]
mod truth;

use contact_vv::study;
use contact_vv::study::independent::run::ASKED;
use contact_vv_live::LIVE;
use contact_vv_live::interpreter::with_python;
use libtest_mimic::Arguments;
use truth::{Findings, counted, truth};

fn main() {
    let arguments = Arguments::from_args();
    let findings = Findings::default();
    let mut tests = planted::trials();
    tests.push(newest::trial());
    tests.extend(study::live(LIVE).into_iter().map(|trial| truth(trial, findings.clone())));
    tests.extend(revolution::trials());
    tests.extend(readers::trials());
    if !arguments.list {
        // Python and its MPI set environment variables as they start: a process started meanwhile would be handed an
        // environment in motion, and sometimes does not start. Where Python cannot start, each trial that asks it says
        // so.
        let _ = with_python(|_| Ok(()));
    }
    let conclusion = libtest_mimic::run(&arguments, tests);
    if !arguments.list {
        let counted = counted(&findings.lock().expect("no test panics while keeping"));
        println!("{counted}, asked now on meshes of up to {ASKED} dofs; finer ones are as they were frozen");
    }
    conclusion.exit();
}
