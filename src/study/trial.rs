//! A trial: one piece of a study that can run alone, and what its own room sees of it.

use crate::case::Judged;
use crate::error::Error;

/// A trial as its room plans it.
pub struct Planned<N> {
    /// Name of the case or study.
    pub case: String,
    /// What tells the trial from its neighbours: a formulation, a scene, a mesh.
    pub name: String,
    run: Box<dyn Fn() -> Result<N, Error> + Send + Sync>,
}

/// A finding as its own room sees it.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a, N> {
    /// Name of the case or study.
    pub case: &'a str,
    /// Name of the trial.
    pub name: &'a str,
    /// Its numbers.
    pub numbers: &'a N,
    /// Checks with their verdicts.
    pub judged: &'a [Judged],
}

impl<N: 'static> Planned<N> {
    /// A trial from its work.
    pub fn new(
        case: impl Into<String>,
        name: impl Into<String>,
        run: impl Fn() -> Result<N, Error> + Send + Sync + 'static,
    ) -> Self {
        Self { case: case.into(), name: name.into(), run: Box::new(run) }
    }

    /// Runs the trial.
    pub fn run(&self) -> Result<N, Error> {
        (self.run)()
    }

    /// `case × name`, as printed by tests.
    pub fn title(&self) -> String {
        format!("{} × {}", self.case, self.name)
    }
}

/// The checks of a trial; refused where there is none, or one that does not say against what it is held and why.
pub fn complete(title: &str, judged: Vec<Judged>) -> Result<Vec<Judged>, Error> {
    let refused = |message: String, remedy: &str| Err(Error::at(title, message, remedy));
    if judged.is_empty() {
        return refused("the trial yields no check".into(), "let its study judge something");
    }
    match judged.iter().find(|one| one.check.because.is_empty() || one.reference.name.is_empty()) {
        Some(one) => refused(format!("the check of `{}` has no reason or reference", one.check.quantity), "give both"),
        None => Ok(judged),
    }
}
