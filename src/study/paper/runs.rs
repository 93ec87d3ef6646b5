//! Iterations from every initial stiffness: when each criterion would have stopped them, and how far off they were then.

use rayon::prelude::*;

use crate::algorithm::Criterion;
use crate::case::library::{Cylinder, PinRod};
use crate::error::{Error, Kind};
use crate::mesh::{Order, Resolution};
use crate::named::named_enum;
use crate::solution::{Iterated, Outcome, Solution};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run, Settings};
use crate::study::paper::reading::{Candidates, Mesh, Reading, Rule, Stop};
use crate::study::paper::sentence::{Met, Seen, Starts};

named_enum! {
    /// One of the paper's two examples.
    pub enum Example {
        /// Elastic cylinder on a rigid plane.
        Cylinder = "cylinder",
        /// Pin in a connecting rod.
        PinRod = "pin–rod",
    }
}

/// What iterates: an element with an algorithm on a mesh, however it is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Example.
    pub example: Example,
    /// How far the candidates reach.
    pub candidates: Candidates,
    /// Mesh.
    pub mesh: Mesh,
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: Rule,
    /// Thickness of a layer element over the length of its edge.
    pub thickness: f64,
}

/// All starts of a site.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// The site.
    pub site: Site,
    /// Dofs of the condensed system.
    pub retained: usize,
    /// Every stop that a reading asks of it.
    pub stops: Vec<Stop>,
    /// By start, when each stop was met.
    pub met: Vec<Vec<Option<Met>>>,
    /// Of some starts when a stop was met: as a run without it tells, and by a run that it stops.
    pub alone: Vec<[Option<Met>; 2]>,
}

/// Initial stiffnesses κ₀: whole decades.
pub fn starts() -> Vec<f64> {
    (-3..=6).map(|k| 10f64.powi(k)).collect()
}

/// The smallest iteration error that may be asked for: what no visible criterion waits for.
const LEAST: f64 = 1e-13;
/// Of the nearest reading one start in so many is run once more, by all stops in turn.
const AGAIN: usize = 3;

/// The paper's elements with its algorithms.
pub fn shown() -> impl Iterator<Item = (Element, Iteration)> {
    Formulation::nine().into_iter().filter(Formulation::is_in_the_paper).map(|one| (one.element, one.algorithm))
}

/// Every start of every site of some readings, on meshes that are made once.
pub fn courses(readings: &[Reading]) -> Result<Vec<Course>, Error> {
    let mut sites: Vec<(Site, Vec<Stop>)> = Vec::new();
    for reading in readings {
        for site in Example::ALL.into_iter().flat_map(|example| Site::all(reading, example)) {
            match sites.iter_mut().find(|(own, _)| *own == site) {
                Some((_, stops)) if stops.contains(&reading.stop) => {}
                Some((_, stops)) => stops.push(reading.stop),
                None => sites.push((site, vec![reading.stop])),
            }
        }
    }
    let ground = |(site, _): &(Site, Vec<Stop>)| (site.example, site.candidates, site.mesh);
    sites.sort_by_key(ground);
    let parts: Vec<&[(Site, Vec<Stop>)]> = sites.chunk_by(|a, b| ground(a) == ground(b)).collect();
    let on = |part: &&[(Site, Vec<Stop>)]| {
        let discretisation = part[0].0.discretised()?;
        part.par_iter().map(|(site, stops)| site.course(&discretisation, stops)).collect::<Result<Vec<_>, Error>>()
    };
    Ok(parts.par_iter().map(on).collect::<Result<Vec<_>, _>>()?.concat())
}

impl Site {
    /// All of an example under a reading; line and node elements have no thickness.
    fn all(reading: &Reading, example: Example) -> impl Iterator<Item = Self> {
        let Reading { candidates, mesh, .. } = *reading;
        shown().map(move |(element, algorithm)| {
            let thickness = if element == Element::Layer { reading.thickness } else { Reading::nearest().thickness };
            Self { example, candidates, mesh, element, algorithm, rule: reading.rule(algorithm), thickness }
        })
    }

    /// The mesh with its condensed system; candidates that end with a contact without a closed form have to be looked for.
    fn discretised(&self) -> Result<Discretisation, Error> {
        let elements = match self.example {
            Example::Cylinder => 8,
            Example::PinRod => 12,
        };
        let (elements, order) = match self.mesh {
            Mesh::Sweep => (elements, Order::Quadratic),
            Mesh::Linear => (elements, Order::Linear),
            Mesh::Finer => (elements + elements / 2, Order::Quadratic),
        };
        let resolution = Resolution { elements, refinement: 0, order };
        let scene = match (self.example, self.candidates) {
            (Example::Cylinder, Candidates::Wide) => Cylinder::default().scene(),
            (Example::Cylinder, Candidates::AtEdge) => Cylinder { stretch: 1.0, ..Default::default() }.scene(),
            (Example::PinRod, Candidates::Wide) => PinRod::default().scene(),
            (Example::PinRod, Candidates::AtEdge) => {
                let wide = Discretisation::of(PinRod::default().scene(), resolution)?;
                let stretch = Run::of(&wide, &Formulation::verification())?.measures().edge();
                PinRod { stretch, ..Default::default() }.scene()
            }
        };
        Discretisation::of(scene, resolution)
    }

    /// All starts; kinematic load looks at the tolerance, and is run for each stop. Of the others one run tells of all.
    fn course(&self, discretisation: &Discretisation, stops: &[Stop]) -> Result<Course, Error> {
        let is_kinematic = self.algorithm == Iteration::Kinematic;
        let met = |stiffness: f64| match is_kinematic {
            true => stops.iter().map(|stop| self.alone(discretisation, stiffness, stop)).collect(),
            false => self.together(discretisation, stiffness, stops),
        };
        let met = starts().into_iter().map(met).collect::<Result<Vec<Vec<Option<Met>>>, Error>>()?;
        let is_nearest = Self::all(&Reading::nearest(), self.example).any(|site| site == *self);
        let again = if is_nearest && !is_kinematic { starts() } else { Vec::new() };
        let pair = |(start, stiffness): (usize, f64)| {
            let stop = (start + self.element as usize) % stops.len();
            Ok([met[start][stop], self.alone(discretisation, stiffness, &stops[stop])?])
        };
        let alone = again.into_iter().enumerate().step_by(AGAIN).map(pair).collect::<Result<_, Error>>()?;
        Ok(Course { site: *self, retained: discretisation.condensed.retained(), stops: stops.into(), met, alone })
    }

    /// One run, and where it passed each stop: it ends by the hardest of them where they are of one criterion, else by nothing visible.
    fn together(&self, on: &Discretisation, stiffness: f64, stops: &[Stop]) -> Result<Vec<Option<Met>>, Error> {
        let least = stops.iter().map(|stop| stop.tolerance).fold(f64::INFINITY, f64::min);
        let hardest = match stops.chunk_by(|a, b| a.criterion == b.criterion).count() {
            1 => Stop { tolerance: least, ..stops[0] },
            _ => Stop { criterion: Criterion::Error, tolerance: LEAST },
        };
        let history = self.solved(on, stiffness, &hardest)?.map_or(Vec::new(), |solution| solution.history);
        let met = |stop: &Stop| {
            let is_met = |one: &Iterated| stop.criterion.of(&one.seen).is_some_and(|seen| seen <= stop.tolerance);
            let at = history.iter().position(is_met)?;
            Some(Met { iterations: at + 1, error: history[at].error.peak })
        };
        Ok(stops.iter().map(met).collect())
    }

    /// A run of its own that stops by a criterion.
    fn alone(&self, on: &Discretisation, stiffness: f64, stop: &Stop) -> Result<Option<Met>, Error> {
        let ended = |solution: &Solution| [Outcome::Converged, Outcome::Stopped].contains(&solution.outcome);
        let solution = self.solved(on, stiffness, stop)?.filter(ended);
        Ok(solution.map(|one| Met { iterations: one.work.iterations, error: one.error().peak }))
    }

    /// A solution; none where no spring holds, the named error.
    fn solved(&self, on: &Discretisation, stiffness: f64, stop: &Stop) -> Result<Option<Solution>, Error> {
        let Self { element, algorithm, rule: Rule { rule, leeway }, thickness: layer_thickness, .. } = *self;
        let plain = Formulation::new(element, algorithm);
        let settings = Settings { criterion: stop.criterion, tolerance: stop.tolerance, ..plain.settings };
        match on.solve(&Formulation { rule, leeway, stiffness, layer_thickness, settings, ..plain }) {
            Err(Error { kind: Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft, .. }) => Ok(None),
            solution => solution.map(Some),
        }
    }
}

/// What the paper shows of an example under a reading; no start of a site or a stop that was not run.
pub fn seen(courses: &[Course], reading: &Reading, example: Example) -> Seen {
    let starts = |site: Site| {
        let course = courses.iter().find(|course| course.site == site);
        let asked = course.and_then(|own| Some((own, own.stops.iter().position(|stop| *stop == reading.stop)?)));
        let (retained, met) = asked.map_or((0, Vec::new()), |(own, at)| {
            let met = own.met.iter().map(|met| met[at].filter(|met| met.iterations <= reading.cap));
            (own.retained, met.collect())
        });
        Starts { element: site.element, algorithm: site.algorithm, retained, met }
    };
    Seen { of: Site::all(reading, example).map(starts).collect() }
}
