//! Predicted against measured, one iteration at a time; in a folder, since its four predictions have little in common.
//!
//! * `rates` — asymptotic rates of constant and varying stiffness, a posteriori and by Hertz's closed form alone.
//! * `springs` — constant stiffness towards given springs, varying stiffness next to the contact.
//!
//! Below is the page, whose text is `page.md`. Each prediction is made and measured by a function, judged by `judge_…`
//! and shown by `table_of_…`. Rules that fail, and the halving law of kinematic load, are those of the atlas.

pub mod rates;
pub mod springs;

use crate::case::Judged;
use crate::error::Error;
use crate::markdown;
use crate::solve::{Element, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::method::Method;
use rates::{Before, Rate, SCENES};
use springs::{Basin, Towards};

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Rates of a method.
    Rates(Vec<Rate>),
    /// Rates of varying stiffness before anything is solved.
    Before(Vec<Before>),
    /// Constant stiffness towards fixed springs.
    Towards(Vec<Towards>),
    /// Varying stiffness with `correction`.
    Basin(Vec<Basin>),
}

impl Study for Numbers {
    const NAME: &'static str = "stability";
    const ABOUT: About = About {
        title: "Predicted against measured",
        asked: "Whether rates and iterations are those that the matrices predict.",
        limits: "What is called a posteriori needs the solved contact, and is no help before it.",
    };

    /// All trials of the predictions.
    fn plan() -> Vec<Planned<Self>> {
        let mut trials = Vec::new();
        for element in Element::ALL {
            for algorithm in [Iteration::Constant, Iteration::Varying] {
                let method = Method::usual(element, algorithm);
                let run = move || rates::rates(method).map(Numbers::Rates);
                trials.push(Planned::new("predicted rate of convergence", method.to_string(), run));
            }
        }
        trials.extend(SCENES.map(|(name, stretched)| {
            let run = move || rates::before(stretched).map(Numbers::Before);
            Planned::new("rate of varying stiffness before the contact is solved", name, run)
        }));
        trials.extend(by_element("constant stiffness, fixed target springs", |e| {
            springs::towards(e).map(Numbers::Towards)
        }));
        trials.extend(by_element("varying stiffness with correction, next to the contact", |e| {
            springs::basin(e).map(Numbers::Basin)
        }));
        trials
    }

    /// The predictions hold.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Rates(starts) => rates::judge_rates(starts),
            Numbers::Before(meshes) => vec![rates::judge_before(meshes)],
            Numbers::Towards(starts) => springs::judge_towards(starts),
            Numbers::Basin(starts) => vec![springs::judge_basin(starts)],
        })
    }

    /// A subsection for each prediction.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let (mut rates, mut before, mut basin) = (Vec::new(), Vec::new(), Vec::new());
        let mut towards = String::new();
        for Found { case, name, numbers, .. } in findings {
            match numbers {
                Numbers::Rates(starts) => rates.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Before(meshes) => before.extend(meshes.iter().map(|mesh| (*name, mesh))),
                Numbers::Basin(starts) => basin.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Towards(starts) => {
                    let title = format!("{case}, {name}: starts κ₀ from 1e-6 to 1e6 by how they end");
                    towards += &markdown::folded(&title, &springs::table_of_towards(starts), false);
                }
            }
        }
        Ok(format!(
            include_str!("page.md"),
            towards = towards,
            rates = rates::table_of_rates(&rates),
            before = rates::table_of_before(&before),
            basin = springs::table_of_basin(&basin)
        ))
    }
}

/// One trial an element.
fn by_element(case: &str, run: fn(Element) -> Result<Numbers, Error>) -> [Planned<Numbers>; 3] {
    Element::ALL.map(|element| Planned::new(case, element.name(), move || run(element)))
}
