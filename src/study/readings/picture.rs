//! How many sentences hold under the readings, rules of varying stiffness against tolerances and caps; and the paper's Fig. 11 under
//! some of them.

use crate::algorithm::Criterion;
use crate::error::Error;
use crate::figure::{Axis, Cell, Chart, ClassMap, Drawing, MapPanel, panels};
use crate::solve::{Element, Formulation, Iteration};
use crate::study::Found;
use crate::study::drawn::{Curve, label, style};
use crate::study::readings::axes::{CAPS, Candidates, Example, Rule, Stop, TOLERANCES};
use crate::study::readings::courses::Courses;
use crate::study::readings::map::{self, Judged};
use crate::study::readings::reading::{End, Reading};
use crate::study::readings::run::Numbers;
use crate::study::readings::sentence::Sentence;

/// Classes of the map: from the most sentences that can hold down, one a class, and what is below the last.
const CLASSES: usize = 6;

/// The map.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut charts = Vec::new();
    for found in findings {
        let courses = Courses::of(&found.numbers.recorded);
        let all = map::all(&courses);
        charts.push(("readings.svg".to_string(), chart(&all)?));
        charts.push(("figure-11.svg".to_string(), iterations(&courses, &all)?));
    }
    Ok(charts)
}

/// Readings of the most sentences that are shown beside the nearest one.
const BESIDE: usize = 2;

/// Iterations against initial stiffness with line and layer elements under varying and constant stiffness, the four curves of the
/// paper: a row an example, a column a reading.
fn iterations(courses: &Courses, all: &[Judged]) -> Result<Drawing, Error> {
    let best = map::best(all).into_iter().take(BESIDE).map(|judged| judged.reading);
    let readings: Vec<Reading> = std::iter::once(Reading::nearest()).chain(best).collect();
    let panel = |example: Example, (number, reading): (usize, &Reading)| {
        let title = format!("{}, reading {}", example.name(), number + 1);
        let mut chart = Chart::new(
            &title,
            Axis::log("initial stiffness κ₀ [–]").over(1e-3, 1e6),
            Axis::log("iterations [–]").over(1.0, 3000.0),
        );
        let curves = [Iteration::Varying, Iteration::Constant].into_iter().flat_map(|algorithm| {
            [Element::Line, Element::Layer].map(|element| {
                let formulation = Formulation::new(element, algorithm);
                curve(&courses.ends(reading, example, element, algorithm))
                    .drawn(label(&formulation), style(&formulation))
            })
        });
        chart.series = curves.collect();
        chart.notes =
            readings.iter().enumerate().map(|(k, reading)| format!("{}: {}.", k + 1, reading.name())).collect();
        chart
    };
    let panels_of = |example| readings.iter().enumerate().map(move |numbered| panel(example, numbered));
    let charts: Vec<Chart> = Example::ALL.into_iter().flat_map(panels_of).collect();
    panels("Fig. 11: iterations against initial stiffness, by reading", &charts, readings.len())
}

fn curve(ends: &[End]) -> Curve {
    let mut curve = Curve::default();
    for end in ends {
        match end.iterations {
            Some(iterations) => curve.points.push([end.stiffness, iterations as f64]),
            None => curve.failed.push(end.stiffness),
        }
    }
    curve
}

fn chart(all: &[Judged]) -> Result<Drawing, Error> {
    let most = all.iter().map(Judged::count).max().unwrap_or(0);
    let criteria = [Criterion::Conditions, Criterion::Residuals, Criterion::Displacement];
    let pairs = criteria.into_iter().flat_map(|criterion| Candidates::ALL.map(|candidates| (candidates, criterion)));
    let panels = pairs.map(|(candidates, criterion)| panel(all, most, candidates, criterion)).collect();
    let class = |k: usize| match most.checked_sub(k as u32) {
        Some(number) if k + 1 < CLASSES => format!("{number} of {}", Sentence::ALL.len()),
        _ => "fewer".into(),
    };
    let ticks = TOLERANCES.iter().enumerate().map(|(k, tolerance)| (k * CAPS.len(), format!("{tolerance:.0e}")));
    ClassMap {
        title: "Sentences of the paper that hold in both examples, by rule of varying stiffness and tolerance".into(),
        axes: ["tolerance [–]".into(), "rule".into()],
        panels,
        columns: Candidates::ALL.len(),
        ticks: ticks.collect(),
        classes: (0..CLASSES).map(class).collect(),
        boundary: None,
        notes: vec![format!(
            "In each tolerance from left to right: given up after {} iterations. The most that hold under any rule of constant stiffness \
             and thickness of layers.",
            CAPS.map(|cap| cap.to_string()).join(", ")
        )],
    }
    .drawing()
}

fn panel(all: &[Judged], most: u32, candidates: Candidates, criterion: Criterion) -> MapPanel {
    let is_own =
        |judged: &&Judged| judged.reading.candidates == candidates && judged.reading.stop.criterion == criterion;
    let own: Vec<&Judged> = all.iter().filter(is_own).collect();
    let row = |varying: Rule| {
        let of_rule: Vec<&&Judged> = own.iter().filter(|judged| judged.reading.varying == varying).collect();
        let places = TOLERANCES.into_iter().flat_map(|tolerance| CAPS.map(|cap| (Stop { criterion, tolerance }, cap)));
        let cell = |(stop, cap): (Stop, usize)| {
            let here = of_rule.iter().filter(|judged| judged.reading.stop == stop && judged.reading.cap == cap);
            let held = here.map(|judged| judged.count()).max().unwrap_or(0);
            Cell { class: ((most - held) as usize).min(CLASSES - 1), label: held.to_string(), predicted: None }
        };
        (varying.name(), places.map(cell).collect())
    };
    let rows = Rule::varying().into_iter().map(row).collect();
    MapPanel { title: format!("{} · candidates {}", criterion.name(), candidates.name()), rows }
}
