//! Predicted against measured, one iteration at a time; in a folder, since its five predictions have little in common.
//!
//! * `rates` — asymptotic rates of constant and varying stiffness, a posteriori and by Hertz's closed form alone.
//! * `revolution` — what the atlas says of plane scenes, on bodies of revolution.
//! * `springs` — constant stiffness towards given springs, varying stiffness next to the contact.
//!
//! Below is the page. Each prediction is made and measured by a function, judged by `judge_…` and shown by `table_of_…`. Rules that fail,
//! and the halving law of kinematic load, are those of the atlas.

pub mod rates;
pub mod revolution;
pub mod springs;

use crate::case::Judged;
use crate::error::Error;
use crate::markdown;
use crate::solve::{Element, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::method::Method;
use rates::{Before, Rate, SCENES};
use revolution::Revolved;
use springs::{Basin, Towards};

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Rates of a method.
    Rates(Vec<Rate>),
    /// Rates of varying stiffness before anything is solved.
    Before(Vec<Before>),
    /// Bodies of revolution.
    Revolved(Vec<Revolved>),
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
        trials.extend(revolution::SCENES.map(|(name, scene)| {
            let run = move || revolution::revolved(scene).map(Numbers::Revolved);
            Planned::new("laws of the plane on bodies of revolution", name, run)
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
            Numbers::Revolved(rows) => revolution::judge_revolved(rows),
            Numbers::Towards(starts) => springs::judge_towards(starts),
            Numbers::Basin(starts) => vec![springs::judge_basin(starts)],
        })
    }

    /// A subsection for each prediction.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let (mut rates, mut before, mut basin, mut revolved) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut towards = String::new();
        for Found { case, name, numbers, .. } in findings {
            match numbers {
                Numbers::Rates(starts) => rates.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Before(meshes) => before.extend(meshes.iter().map(|mesh| (*name, mesh))),
                Numbers::Revolved(rows) => revolved.extend(rows.iter().map(|row| (*name, row))),
                Numbers::Basin(starts) => basin.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Towards(starts) => {
                    let title = format!("{case}, {name}: starts κ₀ from 1e-6 to 1e6 by how they end");
                    towards += &markdown::folded(&title, &springs::table_of_towards(starts), false);
                }
            }
        }
        Ok([
            TOWARDS,
            &towards,
            RATES,
            &rates::table_of_rates(&rates),
            BEFORE,
            &rates::table_of_before(&before),
            BASIN,
            &springs::table_of_basin(&basin),
            REVOLVED,
            &revolution::table_of_revolved(&revolved),
        ]
        .concat())
    }
}

/// One trial an element.
fn by_element(case: &str, run: fn(Element) -> Result<Numbers, Error>) -> [Planned<Numbers>; 3] {
    Element::ALL.map(|element| Planned::new(case, element.name(), move || run(element)))
}

const TOWARDS: &str = "## Constant stiffness towards fixed springs\n\n\
`(S + K₀) u⁺ = f̂ + (K₀ − K*) u` converges if and only if S + K* and S + 2K₀ − K* are positive definite: in effect k₀ ≥ k*/2. \
Softer springs diverge, stiffer ones crawl. The condition is known before the run for any given springs; those tried here carry the \
contact's own pressure without a gap, cut off at the κ* given, and are thus known *a posteriori*.\n\n";

const RATES: &str = "## Rates of constant and varying stiffness\n\n\
*A posteriori*: the asymptotic rate of an iteration is the spectral radius of its error's matrix on the final active set, made of the \
flexibility of the contact and of its springs, and needs the solved contact; – where too few iterations lie between the final active set \
and round-off. Truncated Hertz, contact edge between two nodes. Constant stiffness is also followed from its start as a linear iteration \
on that set, over the same errors: where the start hardly holds the slowest mode, round-off comes before that is alone, and by the \
linear iteration's own slope no spectral radius is to be measured there. Each prediction has a check of its own.\n\n";

const BEFORE: &str = "\n## Varying stiffness: the rate before anything is solved\n\n\
*A priori*: the slowest spring to let go is the one next to the contact edge, by w/g an iteration, and Hertz's closed form says w/g at the \
first node outside. The bound of the factor plays no part in it: near the edge w/g is next to 1. Where in its element the discrete contact \
ends the closed form does not know. Nodes only: line and layer elements are slowed by an alternating mode of their points inside the \
contact, which only the solved contact tells.\n\n";

const BASIN: &str = "\n## Varying stiffness with `correction`\n\n\
*A posteriori.* Next to the contact it is stable while 2 (S + K*) − max(K*, K₀) is positive definite on the closed points: near the edge, where \
k* → 0, κ₀ must remain below about twice the stiffness of the bodies. From equal springs, farther away, that is no promise: *Where methods fail* has how such runs end.\n\n";

const REVOLVED: &str = "\n## Bodies of revolution\n\n\
What the [atlas](atlas.md) says of plane scenes, on blocks of revolution pressed by a paraboloid and by a cone. *A priori*: kinematic load \
starts with contact up to L, and each iteration opens what pulls. Contact kept up to L is the profile's own less a flat punch of that \
radius; under a paraboloid it presses up to √((2L³ + a³)/3L). Next to the contact this halves L² − a², as in the plane; from far it leaves \
two thirds of L². Starts κ₀ from 1e-6 to 1e6.\n\n";
