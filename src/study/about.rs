//! What a study is: its name, what it asks, its trials, and what is made of what they found.

use crate::case::Judged;
use crate::drawing::Drawing;
use crate::error::Error;

/// What a trial of a study found, judged and shown.
///
/// A study is this trait for its numbers, and a line in [`Room::ALL`](crate::study::Room::ALL).
pub trait Study: Clone + Send + Sync + 'static {
    /// Name of its module, which its page has too.
    const NAME: &'static str;
    /// What its page is called, what it asks, and what it cannot tell.
    const ABOUT: About;

    /// What is run.
    fn plan() -> Vec<Planned<Self>>;

    /// The checks with their verdicts.
    fn judge(&self) -> Result<Vec<Judged>, Error>;

    /// Its part of the page in Markdown, without the table of its checks.
    fn section(findings: &[Found<Self>]) -> Result<String, Error>;

    /// File names and charts.
    fn pictures(_: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        Ok(Vec::new())
    }
}

/// What the page of a study says of it: no number, no judgement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct About {
    /// Title of its page.
    pub title: &'static str,
    /// What it asks, as a clause: whether, how, which.
    pub asked: &'static str,
    /// What it cannot tell.
    pub limits: &'static str,
}

/// A trial: one piece of a study that can run alone.
pub struct Planned<N> {
    /// Name of the case or study.
    pub case: String,
    /// What tells the trial from its neighbours: a formulation, a scene, a mesh.
    pub name: String,
    run: Box<dyn Fn() -> Result<N, Error> + Send + Sync>,
}

/// A finding as its own study sees it.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a, N> {
    /// Name of the case or study.
    pub case: &'a str,
    /// Name of the trial.
    pub name: &'a str,
    /// Its numbers.
    pub numbers: &'a N,
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

/// The checks of a trial; refused where one does not say against what it is held and why.
pub fn complete(title: &str, judged: Vec<Judged>) -> Result<Vec<Judged>, Error> {
    match judged.iter().find(|one| one.check.because.is_empty() || one.reference.name.is_empty()) {
        Some(one) => {
            let message = format!("the check of `{}` has no reason or reference", one.check.quantity);
            Err(Error::at(title, message, "give both"))
        }
        None => Ok(judged),
    }
}
