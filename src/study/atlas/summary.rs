//! What the atlas says of each method: where every run converges, how the others end, and from where to start.

use crate::error::Error;
use crate::solve::{Element, Iteration, Settings};
use crate::study::atlas::chart::Chart;
use crate::study::atlas::judge;
use crate::study::atlas::plan::Plane;
use crate::study::atlas::record::{self, Class, Record};
use crate::study::unsorted::Table;

/// Planes over all scenes, meshes and candidate stretches, each with the same initial stiffnesses.
const SCENES: [Plane; 4] = [Plane::Stretch, Plane::Mesh, Plane::Cylinder, Plane::PinRod];

/// What the scenes say of one element × algorithm × rule.
#[derive(Clone, Debug)]
pub struct Digest {
    /// `element.algorithm.rule`.
    pub name: String,
    /// Initial stiffnesses from and to which every run ends right.
    pub safe: Option<[f64; 2]>,
    /// The initial stiffness with the fewest steps in the worst case, and these.
    pub best: Option<(f64, usize)>,
    /// Runs by how they ended.
    pub ends: Vec<(Class, usize)>,
    /// Runs that had a prediction.
    pub predicted: usize,
}

/// All recorded planes.
pub fn charts() -> Result<Vec<Chart>, Error> {
    Plane::ALL.into_iter().map(|plane| Ok(Chart::of(plane, &record::read(plane)?))).collect()
}

/// Digests of every formulation, element by element.
pub fn digests(charts: &[Chart]) -> Vec<Digest> {
    let mut digests = Vec::new();
    for element in Element::ALL {
        for algorithm in Iteration::ALL {
            for rule in algorithm.rules() {
                let name = format!("{}.{}.{}", element.name(), algorithm.name(), rule.name());
                digests.push(digest(charts, name, algorithm.default_stiffness()));
            }
        }
    }
    digests
}

fn digest(charts: &[Chart], name: String, usual: f64) -> Digest {
    let scenes = charts.iter().filter(|chart| SCENES.contains(&chart.plane));
    let rows: Vec<&[Record]> = scenes.flat_map(|chart| chart.of_formulation(&name)).collect();
    let columns = rows.first().map_or(0, |row| row.len());
    let column = |c: usize| rows.iter().map(move |row| &row[c]);
    let holds = |c: usize| column(c).all(Record::is_right);
    let safe = longest_run(columns, holds);
    let worst = |c: usize| column(c).map(|record| record.steps).max().unwrap_or(0);
    // Of equals the one nearest to the algorithm's own start.
    let away = |c: usize| (rows[0][c].stiffness / usual).ln().abs();
    let better = |a: &usize, b: &usize| worst(*a).cmp(&worst(*b)).then(away(*a).total_cmp(&away(*b)));
    let best = safe.and_then(|[from, to]| (from..=to).min_by(better)).map(|c| (rows[0][c].stiffness, worst(c)));
    let all = || rows.iter().flat_map(|row| row.iter());
    let count = |class: Class| (class, all().filter(|record| record.class == class).count());
    Digest {
        safe: safe.map(|ends| ends.map(|c| rows[0][c].stiffness)),
        best,
        ends: Class::ALL.map(count).into_iter().filter(|(_, number)| *number > 0).collect(),
        predicted: all().filter(|record| !record.predicted_steps.is_nan()).count(),
        name,
    }
}

/// First and last of the longest run of numbers that hold.
fn longest_run(count: usize, holds: impl Fn(usize) -> bool) -> Option<[usize; 2]> {
    let mut best: Option<[usize; 2]> = None;
    let mut start = None;
    for c in 0..=count {
        match (c < count && holds(c), start) {
            (true, None) => start = Some(c),
            (false, Some(from)) => {
                if best.is_none_or(|[a, b]| c - from > b - a + 1) {
                    best = Some([from, c - 1]);
                }
                start = None;
            }
            _ => {}
        }
    }
    best
}

/// Where the predictions fail, by formulation: runs that converge against them, runs that do not, and steps off by more than
/// the factor that holds on nodes, or by more than one under kinematic load.
pub fn findings(charts: &[Chart]) -> Table {
    let limit = Settings::default().max_steps as f64;
    let mut rows = Vec::new();
    for name in digests(charts).into_iter().map(|digest| digest.name) {
        let all: Vec<&Record> = charts.iter().flat_map(|chart| chart.of_formulation(&name)).flatten().collect();
        let kinematic = name.contains("kinematic");
        let predicted = |r: &&&Record| !r.predicted_steps.is_nan();
        let fails = |r: &&&Record| r.predicted_steps > judge::FACTOR * limit;
        let ends = |r: &&&Record| r.predicted_steps * judge::FACTOR <= limit;
        let long = |r: &&&Record| if kinematic { !r.predicted_steps.is_nan() } else { judge::is_long(r) };
        let off = |r: &&&Record| if kinematic { judge::steps_off(r) > 1.0 } else { judge::ratio(r) > judge::FACTOR };
        let converged = |r: &&&Record| r.class == Class::Converged;
        let counts = [
            [all.iter().filter(fails).filter(converged).count(), all.iter().filter(fails).count()],
            [all.iter().filter(ends).filter(|r| !converged(r)).count(), all.iter().filter(ends).count()],
            [all.iter().filter(long).filter(off).count(), all.iter().filter(long).count()],
        ];
        if all.iter().any(|r| predicted(&r)) {
            let cell =
                |[count, total]: [usize; 2]| if total == 0 { "–".into() } else { format!("{count} of {total}") };
            rows.push(std::iter::once(name).chain(counts.map(cell)).collect());
        }
    }
    let head = [
        "formulation",
        "converged against the prediction",
        "failed against it",
        "steps off by a factor above 2, or under kinematic load by more than 1",
    ];
    Table {
        title: "Predictions against runs, where they agree and where not".into(),
        head: head.map(String::from).into(),
        rows,
    }
}
