//! Whether an accuracy called met is met: random scenes whose truth is known, solved to several accuracies, from
//! guesses of the candidate stretch up to ten times too long or three times too short.

use std::time::Instant;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::accuracy::{self, Answer, Asked};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::checkout::root;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::larger;
use crate::mesh::Order;
use crate::solve::edge_fitted::Sought;
use crate::solve::{Element, Fitted, Formulation, Iteration, Run};
use crate::study::random::round::{OF_SPHERES, WIDEST};
use crate::study::random::{Family, GUESS, Sample, Site, family};
use crate::study::records::{self, Millionths, Survey, rounded};
use crate::study::seconds::quantile;
use crate::study::target::{self, Target};

/// The survey.
pub const SURVEY: Survey<(Site, f64), Record> = Survey {
    name: "met",
    head: || records::named(HEAD),
    sites: || Ok(sites().collect()),
    key,
    of: |record| key(&(record.site, record.asked)),
    run: |(site, asked)| Ok(vec![record(site, *asked, &site.sample()?)?]),
};

/// Columns of the record.
const HEAD: [&str; 10] =
    ["family", "number", "asked", "met", "estimate", "peak", "half-width", "dofs", "largest dofs", "all dofs"];

/// Relative errors asked for.
pub const ASKED: [f64; 5] = [3e-2, 1e-2, 3e-3, 1e-3, 3e-4];
/// Those asked for besides where a closed form has all digits, of the first scenes of a family.
const FINE: ([f64; 3], usize) = ([1e-4, 1e-5, 1e-6], 20);
const EXACT: [Family; 7] = [
    Family::Hertz,
    Family::Polynomial,
    Family::Wedge,
    Family::Rolling,
    Family::PressFit,
    Family::Eccentric,
    Family::Sphere,
];
/// Families whose mesh is halved or made evenly finer.
const EVENLY: [Family; 2] = [Family::Mesh, Family::Pair];
/// All families but those whose peak has no limit.
pub fn families() -> impl Iterator<Item = Family> {
    let has_limit = |family: &Family| !matches!(family, Family::Punch | Family::Kink);
    family::FAMILIES.into_iter().filter(has_limit).chain(EVENLY)
}

/// Every scene with every accuracy: fewer of the families that take large meshes.
pub fn sites() -> impl Iterator<Item = (Site, f64)> {
    let each = |family: Family| match family {
        Family::Mesh | Family::Pair => 20,
        Family::Power | Family::Flat | Family::Skew | Family::Hump | Family::Ripple | Family::Blocks => 30,
        Family::Layer | Family::Row | Family::Sphere | Family::Spheres | Family::Indented => 30,
        _ => 90,
    };
    let to_fine =
        |family: Family| family::unseen(family).take(FINE.1).flat_map(|site| FINE.0.map(|asked| (site, asked)));
    families()
        .flat_map(move |family| family::unseen(family).take(each(family)))
        .flat_map(|site| ASKED.map(|asked| (site, asked)))
        .chain(EXACT.into_iter().flat_map(to_fine))
}

fn key((site, asked): &(Site, f64)) -> String {
    format!("{}-{asked}", site.key())
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The scene.
    pub site: Site,
    /// Relative error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Estimated relative error, the larger one of peak and half-width; NaN where there is none.
    pub estimate: Millionths,
    /// Relative error of the peak, with sign; the larger one of several contacts.
    pub peak: Millionths,
    /// Relative error of the half-width, with sign.
    pub half_width: Millionths,
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
    /// Those of the largest mesh solved.
    pub most_dofs: usize,
    /// Those of all meshes solved.
    pub dofs_in_all: usize,
}

impl Record {
    /// Of an answer.
    pub fn of(&site: &Site, asked: f64, sample: &Sample, answer: &Answer) -> Self {
        let [peak, half_width] = errors(sample, &answer.run).map(Millionths);
        let (met, estimate) = (answer.unmet.is_none(), Millionths(answer.estimate()));
        let (dofs, most_dofs, dofs_in_all) = (answer.run.dofs, answer.most_dofs(), answer.dofs_in_all());
        Self { site, asked, met, estimate, peak, half_width, dofs, most_dofs, dofs_in_all }
    }

    /// Dofs of all meshes over those of the largest one, in most searches the one that judges the answer.
    fn search(&self) -> f64 {
        self.dofs_in_all as f64 / self.most_dofs as f64
    }

    /// The same over those of the answer.
    fn search_over_answer(&self) -> f64 {
        self.dofs_in_all as f64 / self.dofs as f64
    }

    /// The larger error of peak and half-width; NaN where either is.
    pub fn error(&self) -> f64 {
        larger(self.peak.0.abs(), self.half_width.0.abs())
    }

    /// Said to be met, and not so.
    pub fn is_falsely_met(&self) -> bool {
        let within = self.error() <= self.asked && self.estimate.0 <= self.asked;
        self.met && !within
    }
}

/// Relative errors of peak and half-width, with sign; the largest ones of several contacts.
fn errors(sample: &Sample, run: &Run) -> [f64; 2] {
    accuracy::Quantity::ASKED.map(|quantity| {
        let each = run.contacts.iter().enumerate();
        let errors = each.map(|(at, one)| quantity.of(&one.measures) / sample.truth(at, &quantity) - 1.0);
        errors.reduce(|a, b| if a.abs() >= b.abs() || a.is_nan() { a } else { b }).unwrap_or(f64::NAN)
    })
}

/// A scene solved to one accuracy.
pub fn record(site: &Site, asked: f64, sample: &Sample) -> Result<Record, Error> {
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let answer = accuracy::solve(&sample.scene, &formulation, &Asked::new(asked))?;
    Ok(Record::of(site, asked, sample, &answer))
}

/// Share of what is called met that may not be so.
const WRONG: f64 = 0.01;
/// Error over what was asked, of what is called met.
const FARTHEST: f64 = 1.5;
/// The checks.
pub(super) fn judge(recorded: &[Record]) -> Vec<Judged> {
    vec![right(recorded), near(recorded), consistent(recorded)]
}

/// What is called met is so, but for a small share.
pub fn right(recorded: &[Record]) -> Judged {
    let met = recorded.iter().filter(|record| record.met).count();
    let wrong = recorded.iter().filter(|record| record.is_falsely_met()).count();
    let quantity = "share of the accuracies called met with a peak or a half-width off by more than was asked";
    let because = "bars are held by nineteen of twenty and more, and an answer seldom uses all of its own";
    Check::error(quantity, Reference::analytic("closed forms", 0.0), WRONG, because)
        .asked_of(met)
        .judge(wrong as f64 / met as f64)
}

/// Nothing that is called met is far from it.
pub fn near(recorded: &[Record]) -> Judged {
    let over = recorded.iter().filter(|record| record.met).map(|record| record.error() / record.asked);
    let quantity = Quantity::at("largest error over what was asked, of what is called met", "peak or half-width");
    let because = "who asks for 1 % may be given 1.5 %, and never twice as much";
    Check::at_most(quantity, Reference::analytic("closed forms", FARTHEST), because)
        .judge(over.reduce(larger).unwrap_or(f64::NAN))
}

/// Nothing is called not met whose estimates are all within what was asked.
pub fn consistent(recorded: &[Record]) -> Judged {
    let wrong = recorded.iter().filter(|record| !record.met && record.estimate.0 <= record.asked).count();
    let quantity = "accuracy called not met beside estimates that are all within it";
    let because = "an estimate beyond what was asked is the reason why it is not met";
    Check::at_most(quantity, Reference::own("the estimate", 0.0), because).asked_of(recorded.len()).judge(wrong as f64)
}

/// The answers of a family to an accuracy.
type Row = (Family, f64, Vec<Record>);

/// An answer with cells of any kind, and one with 8-node cells alone, to one accuracy.
#[derive(Clone, Debug)]
pub struct Beside {
    title: &'static str,
    asked: f64,
    /// Both, each with the order of its cells.
    answers: [(Record, Order); 2],
    /// Dofs of the cheapest mesh that the truth allows.
    cheapest: Option<usize>,
    /// What both searches took when that was measured \[s\].
    seconds: [f64; 2],
}

impl Beside {
    fn own(&self) -> &Record {
        &self.answers[0].0
    }

    fn cheapest(&self) -> usize {
        self.cheapest.unwrap_or(self.own().dofs)
    }
}

/// A scene, the accuracy asked for, and what the searches took, with cells of any kind and with 8-node cells alone
/// \[s\], as it is recorded.
type Took = (String, f64, f64, f64);

/// Scenes that are solved beside 8-node cells, and what each stands for.
const BESIDE: [(&str, Family, usize); 8] = [
    ("half of a symmetric contact", Family::Hertz, 0),
    ("peak beside the middle", Family::Polynomial, 1),
    ("arc that goes over into a line", Family::Wedge, 1),
    ("both sides, unlike", Family::Skew, 1),
    ("beside x = 0", Family::Rolling, 0),
    ("elastic on elastic", Family::Cylinders, 0),
    ("pin in a plate", Family::Pin, 0),
    ("two contacts", Family::Pair, 0),
];
/// Relative errors asked for there, and most dofs of a mesh.
const ASKED_BESIDE: [f64; 3] = [1e-2, 1e-3, 1e-4];
const MOST_BESIDE: usize = 30_000;

/// What renews that.
const RENEW: &str = "run `cargo run --release -- timings --points` and review the diff of snapshots/timings";
/// How often each search is measured, and where what it took is recorded.
const REPEATS: usize = 3;
const TOOK: (&str, [&str; 4]) =
    ("snapshots/timings/searches.csv", ["scene", "asked", "seconds", "seconds of 8-node cells"]);

/// Scenes, each with an accuracy.
fn asked_beside() -> impl Iterator<Item = (&'static str, Site, f64)> {
    let site = |family, number| Site { family, number: family::FIRST + number };
    let of = move |(title, family, number)| ASKED_BESIDE.map(|asked| (title, site(family, number), asked));
    BESIDE.into_iter().flat_map(of)
}

/// A scene solved to an accuracy, by cells of any kind or by 8-node cells alone.
fn searched(sample: &Sample, asked: f64, high_order: bool) -> Result<Answer, Error> {
    let asked = Asked { high_order, most_dofs: Some(MOST_BESIDE), ..Asked::new(asked) };
    accuracy::solve(&sample.scene, &Formulation::new(Element::Node, Iteration::Kinematic), &asked)
}

/// Measures what the searches take, and records it.
pub fn time_beside() -> Result<(), Error> {
    let took = |(title, site, asked): (&str, Site, f64)| -> Result<Took, Error> {
        let sample = site.sample()?;
        let of = |high_order: bool| -> Result<f64, Error> {
            let once = |_| {
                let clock = Instant::now();
                searched(&sample, asked, high_order).map(|_| clock.elapsed().as_secs_f64())
            };
            Ok(rounded(quantile(&(0..REPEATS).map(once).collect::<Result<Vec<_>, _>>()?, 0.5)))
        };
        Ok((title.into(), asked, of(true)?, of(false)?))
    };
    let (file, columns) = TOOK;
    let all = asked_beside().map(took).collect::<Result<Vec<_>, Error>>()?;
    records::write(&root().join(file), &records::named(columns), &all)
}

/// Such scenes to each of these accuracies, with what the searches took when that was measured.
pub fn beside() -> Result<Vec<Beside>, Error> {
    let (file, columns) = TOOK;
    let file = root().join(file);
    let took: Vec<Took> = records::read(&file, &records::named(columns), RENEW)?;
    let one = |(title, site, asked): (&'static str, Site, f64)| {
        let sample = site.sample()?;
        let [own, other] = [true, false].map(|high_order| searched(&sample, asked, high_order));
        let [own, other] = [own?, other?];
        let cheapest = cheapest(asked, &sample, &own);
        let recorded = took.iter().find(|(scene, of, ..)| scene == title && of.to_bits() == asked.to_bits());
        let missing = || Error::unreadable(&file, format!("it has no seconds of `{title}` to {asked}"), RENEW);
        let seconds = recorded.map(|(.., own, other)| [*own, *other]).ok_or_else(missing)?;
        let answers = [&own, &other].map(|one| (Record::of(&site, asked, &sample, one), one.resolution.order));
        Ok(Beside { title, asked, answers, cheapest, seconds })
    };
    asked_beside().collect::<Vec<_>>().into_par_iter().map(one).collect()
}

/// Orders, and most layers, among which the cheapest mesh is sought.
const CHEAPEST: ([Order; 3], usize) = ([Order::Quartic, Order::Quintic, Order::Sextic], 4);

/// Move of an end on such a mesh that no longer matters, over what is asked.
const AT_REST: f64 = 0.1;

/// Dofs of the cheapest fitted mesh, of those that have fewer than the one answered, whose true error is within what is
/// asked.
fn cheapest(asked: f64, sample: &Sample, answer: &Answer) -> Option<usize> {
    let (orders, layers) = CHEAPEST;
    let Answer { scene, run, .. } = answer;
    let meshes = orders.into_iter().flat_map(|order| (0..=layers).map(move |layers| Fitted::of(order, layers)));
    // One with as many dofs is not solved.
    let permits = |dofs: usize| match dofs < run.dofs {
        true => Ok(()),
        false => Err(Error::at(scene.name.as_str(), "it has as many dofs", "take a coarser mesh")),
    };
    let near = Sought { is_near: true, permits: &permits, ..Sought::new(scene, &run.formulation, AT_REST * asked) };
    let within = meshes.filter_map(|mesh| {
        let run = mesh.around(run, &near).ok()?.run;
        errors(sample, &run).iter().all(|error| error.abs() <= asked).then_some(run.dofs)
    });
    within.min()
}

/// The table of them.
const COLUMNS_BESIDE: [Column<Beside>; 12] = [
    ("scene", |one| one.title.into()),
    ("asked", |one| format!("{} %", accuracy::in_percent(one.asked))),
    ("met", |one| answered(one.own())),
    ("cells", |one| format!("{}-node", one.answers[0].1.nodes_per_cell())),
    ("error over asked", |one| format!("{:.2}", one.own().error() / one.asked)),
    ("dofs", |one| one.own().dofs.to_string()),
    ("of the cheapest mesh that the truth allows", |one| one.cheapest().to_string()),
    ("of all meshes", |one| one.own().dofs_in_all.to_string()),
    ("s", |one| format!("{:.3}", one.seconds[0])),
    ("8-node cells: met", |one| answered(&one.answers[1].0)),
    ("dofs of theirs, of all meshes", |one| {
        let other = &one.answers[1].0;
        format!("{}, {}", other.dofs, other.dofs_in_all)
    }),
    ("their s", |one| format!("{:.3}", one.seconds[1])),
];

fn answered(own: &Record) -> String {
    if own.met { "yes".into() } else { "no".into() }
}

/// The table of answers.
const COLUMNS: [Column<Row>; 10] = [
    ("scenes", |(family, ..)| family.title().into()),
    ("asked", |(_, asked, _)| format!("{} %", accuracy::in_percent(*asked))),
    ("answers", |(.., own)| own.len().to_string()),
    ("called met", |(.., own)| format!("{:.0} %", 100.0 * met(own).count() as f64 / own.len() as f64)),
    ("falsely met", |(.., own)| own.iter().filter(|record| record.is_falsely_met()).count().to_string()),
    ("largest error called met, over asked", |(.., own)| largest(met(own).map(|one| one.error() / one.asked))),
    ("largest error over its estimate", |(.., own)| largest(met(own).map(|one| one.error() / one.estimate.0))),
    ("dofs, median", |(.., own)| median(own, |one| one.dofs)),
    ("of all meshes, median", |(.., own)| median(own, |one| one.dofs_in_all)),
    ("these over the largest mesh, median", |(.., own)| {
        format!("{:.1}", quantile(&own.iter().map(Record::search).collect::<Vec<_>>(), 0.5))
    }),
];

fn met(own: &[Record]) -> impl Iterator<Item = &Record> {
    own.iter().filter(|record| record.met)
}

fn median(own: &[Record], of: fn(&Record) -> usize) -> String {
    format!("{:.0}", quantile(&own.iter().map(|one| of(one) as f64).collect::<Vec<_>>(), 0.5))
}

fn largest(ratios: impl Iterator<Item = f64>) -> String {
    ratios.reduce(larger).map_or("–".into(), |worst| format!("{worst:.2}"))
}

/// The section: answers by family and accuracy.
pub(super) fn section(recorded: &[Record], beside: &[Beside]) -> String {
    let [shortest, longest] = GUESS;
    let row = |(family, asked): (Family, f64)| -> Row {
        let is_own = |record: &&Record| record.site.family == family && record.asked.to_bits() == asked.to_bits();
        (family, asked, recorded.iter().filter(is_own).cloned().collect())
    };
    let wrong = |family: Option<Family>| {
        let own = recorded.iter().filter(|record| family.is_none_or(|family| record.site.family == family));
        own.filter(|record| record.is_falsely_met()).count()
    };
    let over_cheapest: Vec<f64> = beside.iter().map(|one| one.own().dofs as f64 / one.cheapest() as f64).collect();
    let searches = |of: fn(&Record) -> f64| met(recorded).map(of).collect::<Vec<f64>>();
    let targets = [
        ("dofs of the answer over those of the cheapest mesh that the truth allows", over_cheapest, [1.5, 4.0]),
        (
            "dofs of the whole search over those of its largest mesh, which judges the answer",
            searches(Record::search),
            [3.0, 10.0],
        ),
        ("the same over those of the answer", searches(Record::search_over_answer), [3.0, 10.0]),
    ]
    .map(|(what, all, [usual, most])| {
        let worst = all.iter().copied().fold(0.0, larger);
        [
            Target::at_most(format!("{what}, median of {}", all.len()), usual, quantile(&all, 0.5)),
            Target::at_most(format!("{what}, at worst"), most, worst),
        ]
    });
    let over_asked: Vec<f64> = beside.iter().map(|one| one.own().error() / one.asked).collect();
    let asked = |family: Family| {
        let fine = FINE.0.into_iter().filter(move |_| EXACT.contains(&family));
        ASKED.into_iter().chain(fine).map(move |asked| (family, asked))
    };
    let rows: Vec<Row> = families().flat_map(asked).map(row).collect();
    format!(
        include_str!("met.md"),
        shortest = shortest,
        longest = longest,
        surveyed = SURVEY.told(recorded),
        wrong = wrong(None),
        of_spheres = wrong(Some(Family::Spheres)),
        share = OF_SPHERES,
        most = 100.0 * OF_SPHERES * WIDEST,
        families = markdown::columns(&COLUMNS, &rows),
        most_beside = MOST_BESIDE,
        repeats = REPEATS,
        orders = CHEAPEST.0.map(|order| order.number().to_string()).join(", "),
        layers = CHEAPEST.1,
        targets = markdown::columns(&target::COLUMNS, targets.as_flattened()),
        better = 1.0 / quantile(&over_asked, 0.5),
        fine = FINE.0.map(|asked| format!("{} %", accuracy::in_percent(asked))).join(", "),
        first = FINE.1,
        beside = markdown::columns(&COLUMNS_BESIDE, beside)
    ) + "\n"
}
