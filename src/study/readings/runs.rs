//! Iterations from every initial stiffness: when each criterion would have stopped them, and how far off they were then.

use rayon::prelude::*;
use serde::Serialize;

use crate::case::library::{Cylinder, PinRod};
use crate::error::{Error, Kind};
use crate::mesh::{Order, Resolution};
use crate::named::named_enum;
use crate::scene::Scene;
use crate::solution::{Iterated, Outcome, Solution};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run, Settings};
use crate::study::readings::reading::{Candidates, Mesh, Reading, Rule, Stop};
use crate::study::readings::sentence::{End, Met, Seen};

named_enum! {
    /// One of the paper's two examples.
    pub enum Example {
        /// Elastic cylinder on a rigid plane.
        Cylinder = "cylinder",
        /// Pin in a connecting rod.
        PinRod = "pin–rod",
    }
}

/// Initial stiffnesses κ₀: whole decades.
pub fn starts() -> Vec<f64> {
    (-3..=6).map(|k| 10f64.powi(k)).collect()
}

/// The smallest iteration error that may be asked for: what no visible criterion waits for.
const LEAST: f64 = 1e-13;

/// The meshes of a reading.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ground {
    /// Example.
    pub example: Example,
    /// How far the candidates reach.
    pub candidates: Candidates,
    /// Mesh.
    pub mesh: Mesh,
}

/// What iterates: an element with an algorithm on a mesh, however it is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Site {
    /// Its mesh.
    pub ground: Ground,
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: Rule,
    /// Thickness of a layer element over the length of its edge.
    pub thickness: f64,
}

/// One start of a site.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Start {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Dofs of the condensed system.
    pub retained: usize,
    /// When each [`Stop`] of all was met.
    pub met: Vec<Option<Met>>,
}

/// All starts of a site.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Course {
    /// The site.
    pub site: Site,
    /// Its starts.
    pub starts: Vec<Start>,
}

/// The paper's elements with its algorithms.
pub fn shown() -> impl Iterator<Item = (Element, Iteration)> {
    Formulation::nine().into_iter().filter(Formulation::is_in_the_paper).map(|one| (one.element, one.algorithm))
}

impl Ground {
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
        Discretisation::of(self.scene(resolution)?, resolution)
    }

    fn scene(&self, resolution: Resolution) -> Result<Scene, Error> {
        Ok(match (self.example, self.candidates) {
            (Example::Cylinder, Candidates::Wide) => Cylinder::default().scene(),
            (Example::Cylinder, Candidates::AtEdge) => Cylinder { stretch: 1.0, ..Default::default() }.scene(),
            (Example::PinRod, Candidates::Wide) => PinRod::default().scene(),
            (Example::PinRod, Candidates::AtEdge) => {
                let wide = Discretisation::of(PinRod::default().scene(), resolution)?;
                let stretch = Run::of(&wide, &Formulation::verification())?.measures().edge();
                PinRod { stretch, ..Default::default() }.scene()
            }
        })
    }
}

impl Site {
    /// That of a reading; line and node elements have no thickness.
    pub fn of(reading: &Reading, example: Example, element: Element, algorithm: Iteration) -> Self {
        let Reading { candidates, mesh, .. } = *reading;
        let thickness = if element == Element::Layer { reading.thickness } else { Reading::nearest().thickness };
        let ground = Ground { example, candidates, mesh };
        Self { ground, element, algorithm, rule: reading.rule(algorithm), thickness }
    }

    /// All of some readings, once each.
    pub fn all(readings: &[Reading]) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for reading in readings {
            for example in Example::ALL {
                for site in shown().map(|(element, algorithm)| Self::of(reading, example, element, algorithm)) {
                    if !all.contains(&site) {
                        all.push(site);
                    }
                }
            }
        }
        all
    }

    fn formulation(&self, stiffness: f64) -> Formulation {
        let Self { element, algorithm, rule: Rule { rule, leeway }, thickness: layer_thickness, .. } = *self;
        Formulation { rule, leeway, stiffness, layer_thickness, ..Formulation::new(element, algorithm) }
    }

    /// One start; kinematic load looks at the tolerance, and is run for each stop. Of the others one run tells of all.
    fn start(&self, discretisation: &Discretisation, stiffness: f64) -> Result<Start, Error> {
        let met = match self.algorithm {
            Iteration::Kinematic => {
                Stop::all().iter().map(|stop| self.alone(discretisation, stiffness, stop)).collect::<Result<_, _>>()?
            }
            _ => self.together(discretisation, stiffness)?,
        };
        Ok(Start { stiffness, retained: discretisation.condensed.retained(), met })
    }

    /// One run that nothing visible stops, and where it passed each stop.
    fn together(&self, discretisation: &Discretisation, stiffness: f64) -> Result<Vec<Option<Met>>, Error> {
        let base = self.formulation(stiffness);
        let settings = Settings { tolerance: LEAST, ..base.settings };
        let solution = solved(discretisation, &Formulation { settings, ..base })?;
        let history = solution.map_or(Vec::new(), |solution| solution.history);
        let met = |stop: &Stop| {
            let is_met = |one: &Iterated| stop.criterion.of(&one.seen).is_some_and(|seen| seen <= stop.tolerance);
            let at = history.iter().position(is_met)?;
            Some(Met { iterations: at + 1, error: history[at].error.peak })
        };
        Ok(Stop::all().iter().map(met).collect())
    }

    /// A run of its own that stops by a criterion.
    fn alone(&self, discretisation: &Discretisation, stiffness: f64, stop: &Stop) -> Result<Option<Met>, Error> {
        let base = self.formulation(stiffness);
        let settings = Settings { criterion: stop.criterion, tolerance: stop.tolerance, ..base.settings };
        let solution = solved(discretisation, &Formulation { settings, ..base })?;
        let ended = solution.filter(|solution| [Outcome::Converged, Outcome::Stopped].contains(&solution.outcome));
        Ok(ended.map(|one| Met { iterations: one.work.iterations, error: one.error().peak }))
    }
}

/// A solution; none where no spring holds, the named error.
fn solved(discretisation: &Discretisation, formulation: &Formulation) -> Result<Option<Solution>, Error> {
    match discretisation.solve(formulation) {
        Err(Error { kind: Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft, .. }) => Ok(None),
        solution => solution.map(Some),
    }
}

/// Every start of every site of some readings.
pub fn courses(readings: &[Reading]) -> Result<Vec<Course>, Error> {
    on_grounds(Site::all(readings), |site, discretisation| {
        let starts =
            starts().into_iter().map(|stiffness| site.start(discretisation, stiffness)).collect::<Result<_, _>>()?;
        Ok(Course { site: *site, starts })
    })
}

/// One start in so many is run once more.
const AGAIN: usize = 3;

/// Of starts of the nearest reading of which one run told all: when a criterion was met, all of them in turn, as that run told and by a
/// run that stops by it.
pub fn stopped(courses: &[Course]) -> Result<Vec<[Option<Met>; 2]>, Error> {
    let mut sites = Site::all(&[Reading::nearest()]);
    sites.retain(|site| site.algorithm != Iteration::Kinematic);
    let stops = Stop::all();
    let found = on_grounds(sites, |site, discretisation| {
        let told = courses.iter().find(|course| course.site == *site).map_or(&[][..], |course| &course.starts);
        let pair =
            |(start, k): (&Start, usize)| Ok([start.met[k], site.alone(discretisation, start.stiffness, &stops[k])?]);
        let chosen = told.iter().zip((0..stops.len()).cycle().skip(site.element as usize)).step_by(AGAIN);
        chosen.map(pair).collect::<Result<Vec<_>, Error>>()
    })?;
    Ok(found.concat())
}

/// What is made of each site, on meshes that are made once.
fn on_grounds<T: Send>(
    mut sites: Vec<Site>,
    of: impl Fn(&Site, &Discretisation) -> Result<T, Error> + Sync,
) -> Result<Vec<T>, Error> {
    sites.sort_by_key(|site| (site.ground.example, site.ground.candidates, site.ground.mesh));
    let parts = sites.chunk_by(|a, b| a.ground == b.ground).collect::<Vec<_>>();
    let on = |part: &&[Site]| {
        let discretisation = part[0].ground.discretised()?;
        part.par_iter().map(|site| of(site, &discretisation)).collect::<Result<Vec<T>, Error>>()
    };
    Ok(parts.par_iter().map(on).collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// What the paper shows of an example under a reading; nothing of a site that was not run.
pub fn seen(courses: &[Course], reading: &Reading, example: Example) -> Seen {
    let at = Stop::all().iter().position(|stop| *stop == reading.stop);
    let end = |start: &Start| {
        let met = at.and_then(|at| start.met.get(at).copied().flatten()).filter(|met| met.iterations <= reading.cap);
        End { retained: start.retained, met }
    };
    let of = |(element, algorithm)| {
        let site = Site::of(reading, example, element, algorithm);
        let course = courses.iter().find(|course| course.site == site);
        (element, algorithm, course.map_or(Vec::new(), |course| course.starts.iter().map(end).collect()))
    };
    Seen { of: shown().map(of).collect() }
}
