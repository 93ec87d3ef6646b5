//! The stability atlas: outcome, iterations and error of every element × algorithm × rule, and of what the program
//! makes of the first of them, over initial stiffness and one other number; the plain ones predicted before they are
//! run. Above 400 lines, so a folder:
//!
//! * `plane` — initial stiffness against which other number, and what lies on one mesh; what is kept under
//!   `snapshots/atlas`, and its chart of classes with their boundaries; what the records say of each method, and what
//!   to use.
//! * `run` — a point predicted and run; the paper's scenes before and after
//!   acceleration; and predictions against runs.
//! * `picture` — charts.
//!
//! Below is the page (its text is `page.md` and `iterations.md`): recommendation, predicted curves and their laws,
//! methods, maps, predictions against runs; and the iterations of the paper's elements and algorithms on its scenes.

mod picture;
pub mod plane;
pub mod run;

use crate::algorithm::logarithms::STOOD;
use crate::case::{Judged, Verdict};
use crate::drawing::Drawing;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::atlas::plane::{Digest, STRETCH, Safe, digests, obstacle};
use crate::study::atlas::run::{ENOUGH, FACTOR, HALVINGS, HARD, agreement, averaged, charts, halved};
use crate::study::drawn::picture;
use crate::study::method::Method;

pub use plane::{Chart, Plane, Record, Site, recommendation, recommended};
pub use run::{Numbers, Saved};

impl Study for Numbers {
    const NAME: &'static str = "atlas";
    const ABOUT: About = About {
        title: "Where methods fail",
        asked: "How many iterations every method takes from each initial stiffness, and from which it ends right, \
            over candidates, meshes and scenes.",
        limits: "Scenes of one contact, without friction, in the plane and of one body of revolution. Beyond the \
            surveyed range nothing is known.",
    };

    /// One trial a plane, and one a scene of the paper.
    fn plan() -> Vec<Planned<Self>> {
        let planes = Plane::ALL.map(|plane| {
            Planned::new("stability atlas", plane.name(), move || Chart::read(plane).map(Numbers::Surveyed))
        });
        let saved = Plane::PAPER.map(|scene| {
            Planned::new(format!("before and after, {}", scene.name()), "all nine", move || run::saved(scene))
        });
        planes.into_iter().chain(saved).collect()
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Self::Surveyed(chart) => run::judge_chart(chart),
            Self::Saved(scene, saved) => run::taken(scene.name(), saved),
        })
    }

    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let charts = charts(findings);
        let digests = digests(&charts);
        let iterations = format!(
            "As Fig. 11, predicted: measured points beside curves predicted from the condensed matrices; truncated \
            Hertz, candidates to {STRETCH} half-widths; colours tell the rules apart. Hollow markers above the frame: \
            how the others ended"
        );
        let stretch = "How every run ends over initial stiffness and candidate surface, with the predicted boundary";
        let page = format!(
            include_str!("page.md"),
            recommendation = recommendation(&digests),
            iterations = picture("iterations-predicted.svg", &iterations),
            methods = methods(&digests),
            stretch = picture("atlas-stretch.svg", stretch),
            mesh = picture("atlas-mesh.svg", "The same over initial stiffness and mesh"),
            sphere = picture(
                "atlas-sphere.svg",
                "The same on a body of revolution, over initial stiffness and candidate surface"
            ),
            revolution = revolution(&charts),
            predictions = predictions(&charts)
        );
        Ok(page + "\n\n" + &in_the_paper(findings))
    }

    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        Ok(picture::pictures(&charts(findings)))
    }
}

/// Method → where it works → what stands in its way; the maps have how its runs end.
fn methods(all: &[Digest]) -> String {
    let columns: [Column<(&[Digest], Method)>; 3] = [
        ("method", |(_, method)| method.way()),
        ("every run ends right for κ₀ from … to", |(all, method)| ranges(all, *method)),
        ("what stands in its way", |(_, method)| obstacle(*method).into()),
    ];
    let rows: Vec<(&[Digest], Method)> = Method::of(Element::Node).into_iter().map(|method| (all, method)).collect();
    markdown::columns(&columns, &rows)
}

fn ranges(all: &[Digest], method: Method) -> String {
    let range = |digest: &Digest| {
        let range = digest.safe.map_or("nowhere".into(), |Safe { from, to, .. }| format!("{from:e} … {to:e}"));
        format!("{}: {range}", digest.method.element.name())
    };
    let own = all.iter().filter(|digest| digest.method == Method { element: digest.method.element, ..method });
    own.map(range).collect::<Vec<_>>().join("; ")
}

/// Whether what is told of plane scenes holds of bodies of revolution.
pub fn revolution(charts: &[&Chart]) -> String {
    let (revolved, plane): (Vec<&Chart>, Vec<&Chart>) = charts.iter().partition(|chart| chart.plane == Plane::Sphere);
    let [own, others] = [&revolved, &plane].map(|charts| digests(charts));
    let Some((own_advice, advice)) = recommended(&own).zip(recommended(&others)) else { return String::new() };
    let follow = match own_advice == advice {
        true => format!("*Bodies of revolution* have the recommendation of plane scenes, `{advice}`"),
        false => format!(
            "*Bodies of revolution* have another recommendation than plane scenes, `{own_advice}` for `{advice}`"
        ),
    };
    let range = |digests: &[Digest]| {
        let safe = digests.iter().find(|digest| digest.method == advice).and_then(|digest| digest.safe);
        safe.map_or("no κ₀".into(), |Safe { from, to, .. }| format!("κ₀ from {from:e} to {to:e}"))
    };
    let hold = |judge: fn(&Chart) -> Judged| revolved.iter().all(|chart| judge(chart).verdict == Verdict::Pass);
    let holds = |law: &str, does: bool| format!("{law} {}", if does { "holds" } else { "does not hold" });
    format!(
        "{follow}: every run of it ends right for {}, where those of plane scenes do for {}. Of them too {} from hard \
        starts on, κ₀ ≥ {HARD}, and {} of constant stiffness with correction, none of whose runs may diverge or \
        cycle.",
        range(&own),
        range(&others),
        holds("the halving law", hold(halved)),
        holds("the averaged map", hold(averaged))
    )
}

/// How often each prediction fails, by method.
fn predictions(charts: &[&Chart]) -> String {
    let head = [
        "method".into(),
        "converged against the prediction".into(),
        "failed against it".into(),
        format!("iterations off by a factor above {FACTOR}, or under kinematic load by more than {HALVINGS}"),
    ];
    let cell = |[count, of]: [usize; 2]| if of == 0 { "–".into() } else { format!("{count} of {of}") };
    let row = |method: Method| {
        let shares = agreement(charts, method)?;
        Some(std::iter::once(method.to_string()).chain(shares.map(cell)).collect())
    };
    markdown::table(&head, &Method::all().into_iter().filter_map(row).collect::<Vec<Vec<String>>>())
}

/// Pictures of the paper's elements and iterations.
const PICTURES: [[&str; 2]; 3] = [
    ["contact-problem.svg", "As Figs 1 and 2: bodies in contact, and contact elements on the potential contact area"],
    ["contact-elements.svg", "As Figs 3, 4 and 5: line, layer and node contact element"],
    [
        "iterations-against-stiffness.svg",
        "As Fig. 11 with all nine formulations, by the iteration error: iterations against initial stiffness, as they \
        stand in the paper and, dash-dotted, accelerated; runs that did not converge are drawn as hollow markers above \
        the chart",
    ],
];

/// Iterations of the paper's formulations, and of what the program takes in their place, on both scenes.
fn in_the_paper(findings: &[Found<Numbers>]) -> String {
    let saved = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Saved(scene, saved) => Some((scene.name(), saved)),
        Numbers::Surveyed(_) => None,
    });
    let scenes: Vec<(&str, &Vec<Saved>)> = saved.collect();
    let Some((_, first)) = scenes.first() else { return String::new() };
    let head = ["in the paper", "as the program takes it"].into_iter().chain(scenes.iter().map(|(name, _)| *name));
    let cell = |[(_, before), (_, after)]: &Saved| {
        let [before, after] = [before, after].map(|iterations| iterations.map(|count| count.to_string()));
        let before = before.unwrap_or_else(|| format!("not converged in {ENOUGH}"));
        format!("{before} → {}", after.unwrap_or_else(|| "not converged".into()))
    };
    let row = |(k, one): (usize, &Saved)| {
        let cells = scenes.iter().map(|(_, saved)| cell(&saved[k]));
        one.each_ref().map(|(name, _)| name.clone()).into_iter().chain(cells).collect()
    };
    let rows: Vec<Vec<String>> = first.iter().enumerate().map(row).collect();
    let kinematic = Formulation::accelerated(Element::Line, Iteration::Kinematic).stiffness;
    format!(
        include_str!("iterations.md"),
        pictures = PICTURES.map(|[file, caption]| picture(file, caption)).concat(),
        tolerance = Settings::default().tolerance,
        table = markdown::table(&head.map(String::from).collect::<Vec<_>>(), &rows),
        stood = STOOD,
        kinematic = kinematic
    ) + "\n"
}
