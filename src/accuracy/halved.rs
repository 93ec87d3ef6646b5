//! Bodies whose mesh is given, and several contacts: from mesh to mesh all elements are halved.
//!
//! Cells that are given are cut both ways. Where all bodies are meshed here, the elements on the contacts are halved and the
//! growth follows them, which needs far fewer cells. No ladder fits such meshes to the ends of the contact, so that the
//! error of the half-width wanders with the place of the end within its element. The estimate of a mesh is what all finer
//! ones say of it, and it needs two of them.

use crate::accuracy::answer::largest;
use crate::accuracy::confirmed::{SAFETY, UNCONFIRMED};
use crate::accuracy::estimate::{envelope, richardson};
use crate::accuracy::longest::longest;
use crate::accuracy::{Answer, Asked, Quantity, Quoted, Tried, ends, sizes};
use crate::error::{Error, Kind, Place};
use crate::measure::larger;
use crate::mesh::size::{MOST, expected};
use crate::mesh::{Order, Resolution};
use crate::scene::{ContactPair, Grading, Scene, Shape};
use crate::solve::run::Run;
use crate::solve::{Change, Discretisation, Formulation, Origin};

/// Elements of the first mesh on the shortest candidate stretch, then on the shortest half-contact.
const FIRST: usize = 4;
/// Growth of the first mesh along the surface and into the depth, and the coarsest element over the body.
const GROWTH: [f64; 3] = [1.7, 1.6, 0.3];
/// Candidates over a half-contact that has been found.
const MARGIN: f64 = 1.25;
/// By how much candidates are lengthened where the contact reaches their end.
const LONGER: f64 = 1.5;
/// Cells of a mesh that only looks where the contacts end.
const CHEAP: f64 = 5e4;
/// Elements in a contact from which on a mesh tells where it ends.
const TOLD: usize = 3;
/// First meshes, and ladders begun again because a contact reached the end of its candidates.
const TRIES: usize = 16;
/// Most halvings.
const HALVINGS: u32 = 6;
/// Finer meshes that speak of one that is answered.
const FINER: usize = 2;

/// Whether the mesh of a scene is chosen in this way.
pub(super) fn applies(scene: &Scene) -> bool {
    scene.contacts.len() > 1 || scene.bodies.iter().any(|body| body.shape.has_given_mesh())
}

/// The scene on its first mesh: candidates as they are guessed, growth as usual, cells of the order that is given.
pub(super) fn first(scene: &Scene) -> (Scene, Resolution) {
    let mut first = scene.clone();
    let [along, depth, coarsest] = GROWTH;
    first.grading = Grading { unit: 1.0, along, depth, first: 1.0, coarsest, end: 1.0 };
    sizes::fit(&mut first, 1.0);
    let given = scene.bodies.iter().find_map(|body| match &body.shape {
        Shape::Given(mesh) => Some(mesh.order()),
        _ => None,
    });
    (first, Resolution { elements: FIRST, refinement: 0, order: given.unwrap_or(Order::Quadratic) })
}

/// The coarsest mesh that meets what is asked, or the best that was found, with the reason.
pub(super) fn solve(scene: &Scene, formulation: &Formulation, asked: &Asked) -> Result<Answer, Error> {
    let (first, resolution) = first(scene);
    let longest = scene.contacts.iter().map(|pair| longest(scene, pair)).collect();
    let mut halving =
        Halving { scene: first, resolution, formulation, asked, longest, runs: Vec::new(), tried: Vec::new() };
    halving.find_contacts()?;
    let mut why = "halving the mesh leaves too large an error".to_owned();
    let mut tries = 0;
    while halving.runs.len() <= HALVINGS as usize {
        match halving.next()? {
            Next::Solved => {}
            Next::Longer if tries < TRIES => {
                tries += 1;
                halving.runs.clear();
                continue;
            }
            Next::Longer => {
                why = "the contact reaches the end of the candidate surface".into();
                break;
            }
            Next::Stopped(reason) => {
                why = reason;
                break;
            }
        }
        if (0..halving.scene.contacts.len()).all(|contact| halving.is_open(contact)) {
            return Ok(halving.answer(0, vec![], Some("no contact: every candidate is open".into())));
        }
        for level in 0..halving.runs.len().saturating_sub(FINER) {
            let quoted = halving.quoted(level);
            if largest(&quoted) <= asked.relative {
                return Ok(halving.answer(level, quoted, None));
            }
        }
    }
    let told: Vec<Vec<Quoted>> = (0..halving.runs.len()).map(|level| halving.quoted(level)).collect();
    let smallest = |level: &usize| Some(largest(&told[*level])).filter(|error| error.is_finite());
    let best = (0..told.len()).min_by(|a, b| {
        let [a, b] = [a, b].map(|level| smallest(level).unwrap_or(f64::INFINITY));
        a.total_cmp(&b)
    });
    match best {
        None => {
            let remedy = "give `elements` and `per` instead of the accuracy";
            Err(Error::at(Place::Solve(scene.name.clone()), why, remedy))
        }
        Some(level) => {
            let quoted = told[level].clone();
            let met = largest(&quoted) <= asked.relative;
            let unmet = if met { None } else { Some(why) };
            Ok(halving.answer(level, quoted, unmet))
        }
    }
}

/// What became of the next mesh.
enum Next {
    Solved,
    /// Candidates are longer now, and the ladder is to be begun again.
    Longer,
    /// It was not solved, for this reason.
    Stopped(String),
}

/// A ladder under way.
struct Halving<'a> {
    /// With the candidates and the growth of the first mesh.
    scene: Scene,
    resolution: Resolution,
    formulation: &'a Formulation,
    asked: &'a Asked,
    /// Longest candidates of each contact.
    longest: Vec<f64>,
    /// Of the first mesh, and of each halving of it.
    runs: Vec<Run>,
    tried: Vec<Tried>,
}

impl Halving<'_> {
    /// Finds where the contacts end on cheap meshes, and lays out candidates for them.
    fn find_contacts(&mut self) -> Result<(), Error> {
        if self.brought().all(|brought| brought) {
            return Ok(());
        }
        for attempt in 0..TRIES {
            self.look_from_afar();
            if let Some(what) = self.too_large(0) {
                let remedy =
                    "guess the candidate stretches better, or give `elements` and `per` instead of the accuracy";
                return Err(Error::at(Place::Solve(self.scene.name.clone()), what, remedy));
            }
            match self.solve(0, "contact length") {
                Err(error) if attempt + 1 == TRIES || !self.lengthens(&error) => return Err(error),
                Err(_) => {}
                Ok(run) => {
                    let stretches = |scene: &Scene| scene.contacts.iter().map(|pair| pair.stretch).collect::<Vec<_>>();
                    let before = stretches(&self.scene);
                    if self.fits(&run) || stretches(&self.scene) == before {
                        break;
                    }
                }
            }
        }
        Ok(())
    }

    /// Lengthens the candidates guessed shortest, by which elements are sized, until a first mesh is a cheap one.
    fn look_from_afar(&mut self) {
        let length = |pair: &ContactPair| pair.stretch * pair.path.metric();
        while expected(&self.scene, self.resolution)[0] > CHEAP {
            let pairs = self.scene.contacts.iter_mut().zip(&self.longest);
            let may = pairs.filter(|(pair, longest)| pair.stretch < **longest * (1.0 - 1e-9));
            let Some((pair, longest)) = may.min_by(|(a, _), (b, _)| length(a).total_cmp(&length(b))) else { return };
            pair.stretch = (2.0 * pair.stretch).min(*longest);
            sizes::fit(&mut self.scene, 1.0);
        }
    }

    /// Whether the mesh of each body is given.
    fn brought(&self) -> impl Iterator<Item = bool> {
        self.scene.bodies.iter().map(|body| body.shape.has_given_mesh())
    }

    /// The scene on a mesh halved so many times.
    fn halved(&self, times: u32) -> (Scene, Resolution) {
        let mut scene = self.scene.clone();
        if self.brought().any(|brought| brought) {
            return (scene, Resolution { refinement: times, ..self.resolution });
        }
        let parts = 1 << times;
        scene.grading = self.resolution.order.refined(&scene.grading, parts as f64);
        (scene, Resolution { elements: parts * self.resolution.elements, ..self.resolution })
    }

    /// Fits the candidates of bodies that are meshed here to the contacts found; whether they are known well enough.
    fn fits(&mut self, run: &Run) -> bool {
        let mut known = true;
        for contact in 0..self.scene.contacts.len() {
            let part = run.solution.part(contact);
            let pair = &mut self.scene.contacts[contact];
            let [begin, end] = ends::ends(part, pair);
            let [pressed, _] = ends::pressed(part, pair);
            let brought = |body: usize| self.scene.bodies[body].shape.has_given_mesh();
            if pressed == 0 || pair.bodies().all(brought) {
                continue;
            }
            let filled = ends::filled(part, pair).contains(&true);
            let wanted = if filled { LONGER * pair.stretch } else { MARGIN * end.max(-begin) };
            known &= pressed >= TOLD || filled && pair.stretch >= self.longest[contact];
            pair.stretch = wanted.min(self.longest[contact]);
        }
        sizes::fit(&mut self.scene, MARGIN);
        let elements = self.resolution.elements as f64;
        for (pair, longest) in self.scene.contacts.iter_mut().zip(&self.longest) {
            let size = self.scene.grading.unit / (self.scene.bodies[pair.first].density * elements);
            let whole = (pair.stretch * pair.path.metric() / size - 1e-9).ceil() * size / pair.path.metric();
            pair.stretch = whole.min(*longest);
        }
        known
    }

    /// Lengthens the candidates of a contact that reaches their end; whether that is why a mesh was not solved.
    fn lengthens(&mut self, error: &Error) -> bool {
        let (Kind::ContactBeyondCandidates { .. } | Kind::EmptyStretch) = error.kind else { return false };
        let Place::Contact { contact, .. } = error.place else { return false };
        let (pair, longest) = (&mut self.scene.contacts[contact], self.longest[contact]);
        let longer = pair.stretch < longest * (1.0 - 1e-9);
        pair.stretch = (LONGER * pair.stretch).min(longest);
        longer
    }

    /// Why a mesh is too large to be solved.
    fn too_large(&self, times: u32) -> Option<String> {
        let (scene, resolution) = self.halved(times);
        let [cells, candidates] = expected(&scene, resolution);
        let [most_cells, most] = [self.asked.most_cells, MOST[1]];
        (!(cells <= most_cells && candidates <= most)).then(|| {
            format!("the next mesh would have about {cells:.1e} cells and {candidates:.0} candidate elements, more than {most_cells:.0e} or {most}")
        })
    }

    /// Solves on the next halving.
    fn next(&mut self) -> Result<Next, Error> {
        let times = self.runs.len() as u32;
        if let Some(reason) = self.too_large(times) {
            return Ok(Next::Stopped(reason));
        }
        match self.solve(times, if times == 0 { "first mesh" } else { "halved" }) {
            Ok(run) if run.solution.converged() => {
                self.runs.push(run);
                Ok(Next::Solved)
            }
            Ok(run) => {
                let reason = format!("the iteration ended so on the last mesh: {}", run.solution.outcome);
                // Without another one it is what is answered.
                if self.runs.is_empty() {
                    self.runs.push(run);
                }
                Ok(Next::Stopped(reason))
            }
            Err(error) if self.lengthens(&error) => Ok(Next::Longer),
            Err(error @ Error { kind: Kind::DegenerateCell, .. }) => Ok(Next::Stopped(error.to_string())),
            Err(error) => Err(error),
        }
    }

    /// Solves on a mesh, from the active set of the one before.
    fn solve(&mut self, times: u32, purpose: &'static str) -> Result<Run, Error> {
        let (scene, resolution) = self.halved(times);
        let growth = scene.grading.along.powf(0.5_f64.powi(resolution.refinement as i32));
        let discretisation = Discretisation::of(scene, resolution)?;
        let run = match self.runs.last() {
            Some(before) => {
                Run::from_origin(Origin::From(&before.solution), &discretisation, self.formulation, Change::NONE)?
            }
            None => Run::of(&discretisation, self.formulation)?,
        };
        let pressed = |(contact, pair)| ends::pressed(run.solution.part(contact), pair)[1];
        self.tried.push(Tried {
            purpose,
            order: resolution.order,
            elements: self.scene.contacts.iter().enumerate().map(pressed).min().unwrap_or(0),
            growth: if self.brought().all(|brought| brought) { f64::NAN } else { growth },
            dofs: run.dofs,
            iterations: run.solution.work.iterations,
            contacts: Tried::contacts(&self.scene, &run),
            estimate: f64::NAN,
        });
        Ok(run)
    }

    /// What all finer meshes say of one; of the finest with a factor, as none confirms it.
    fn quoted(&self, level: usize) -> Vec<Quoted> {
        let finest = self.runs.len() - 1;
        let one = |contact: usize, quantity: Quantity| {
            let values: Vec<f64> = self.runs.iter().map(|run| quantity.of(&run.contacts[contact].measures)).collect();
            let (order, elements, check) = match *values {
                [.., coarse, medium, fine] => {
                    let estimate = richardson(Some(coarse), medium, fine, 2.0);
                    let distance = envelope(values[level..].iter().copied(), estimate.limit);
                    let elements = (distance + estimate.uncertainty) / estimate.limit.abs();
                    (estimate.order, elements, SAFETY * ((values[level] - fine) / fine).abs())
                }
                _ => [f64::NAN; 3].into(),
            };
            let elements = if level == finest { UNCONFIRMED * elements } else { elements };
            let iteration = quantity.iterated(&self.runs[level].contacts[contact]);
            let relative = larger(elements, check) + iteration;
            let [growth, growth_order] = [f64::NAN; 2];
            Quoted { contact, quantity, relative, elements, growth, check, iteration, order, growth_order }
        };
        let touching = (0..self.scene.contacts.len()).filter(|&contact| !self.is_open(contact));
        touching
            .flat_map(|contact| self.asked.quantities.iter().map(move |&q| (contact, q)))
            .map(|(c, q)| one(c, q))
            .collect()
    }

    /// Whether a contact is open on every mesh.
    fn is_open(&self, contact: usize) -> bool {
        self.runs.iter().all(|run| run.contacts[contact].open == Some(true))
    }

    fn answer(mut self, level: usize, estimates: Vec<Quoted>, unmet: Option<String>) -> Answer {
        // Those of the last ladder stand at the end.
        let from = self.tried.len() - self.runs.len();
        for level in 0..self.runs.len() {
            self.tried[from + level].estimate = largest(&self.quoted(level));
        }
        let (scene, resolution) = self.halved(level as u32);
        let run = self.runs.swap_remove(level);
        Answer { scene, resolution, run, estimates, unmet, tried: self.tried }
    }
}
