//! Finer and finer meshes of one family, until the error bars of one are within what is asked.

use crate::accuracy::evenly::{self, Evenly};
use crate::accuracy::fitted::{self, Fitted};
use crate::accuracy::rungs::{Rung, Rungs, percent_rounded_up};
use crate::accuracy::{Answer, Asked, Tell, by_order, length};
use crate::error::{Error, Kind, Place};
use crate::measure::Stretch;
use crate::mesh::Resolution;
use crate::scene::Scene;
use crate::solve::{Discretisation, Formulation, Run};

/// Iteration tolerance over the error asked for.
const ITERATION: f64 = 0.01;
/// Order with which bars are expected to fall; the next mesh is judged by its own.
const ORDER: f64 = 1.7;
/// Least and largest ratio of the elements of two meshes that follow one another, and the one where no bar is known.
const RATIO: [f64; 2] = [1.15, 2.5];
/// The ratio where no bar is known.
const UNKNOWN: f64 = 1.6;
/// A bar over the smallest one before, from which on it is taken not to fall, and meshes in a row after which a search
/// ends.
const IDLE: (f64, usize) = (0.9, 3);
/// What 8-node cells begin with where cells of high order do not meet a smaller error.
const BESIDE: f64 = 1e-3;
/// Bar over that of cells of high order, from which on 8-node cells are given up that have more dofs than those.
const HOPELESS: f64 = 30.0;
/// Dofs of the mesh that bars foresee from which on a search gives up after two in a row; and those of meshes whose
/// bars tell that, and of meshes that have none.
const FORESEEN: f64 = 5e6;
const TOLD: [f64; 2] = [5e3, 5e4];
/// Most meshes, with those on which the candidates were too short.
const MOST: usize = 24;

/// The mesh by kinematic load.
pub(super) fn solve(scene: &Scene, formulation: &Formulation, asked: &Asked, tell: Tell) -> Result<Answer, Error> {
    let mut formulation = formulation.clone();
    let settings = &mut formulation.settings;
    settings.tolerance = settings.tolerance.min(ITERATION * asked.relative).max(1e-12);
    let mut rungs = Rungs::new(formulation, asked, tell);
    let layout = match Layout::found(scene, &mut rungs)? {
        Ok(layout) => layout,
        Err((rung, why)) => return rungs.answer(rung, None, Some(why)),
    };
    let begins = match at_once(&mut rungs)? {
        Ok(begins) => begins,
        Err((discretisation, rung)) => return rungs.answer(rung, Some((discretisation, None)), None),
    };
    let by_order = match by_order::applies(scene, &rungs.formulation, asked) {
        true => by_order::found(&layout.held(scene), &mut rungs)?,
        false => None,
    };
    match by_order {
        Some((rung, held)) if rung.error <= asked.relative => rungs.answer(rung, held, None),
        best => refine(layout, begins, rungs, scene, best.map(|(best, _)| best)),
    }
}

/// Elements with which contacts that go on to all ends of their candidates begin, by the bars of the first mesh, which
/// is the answer where these are within what is asked: they have no end that cells hide.
fn at_once(rungs: &mut Rungs) -> Result<Result<Option<usize>, (Discretisation, Rung)>, Error> {
    let goes_on = |one: &Stretch| (!one.begins_within() || one.reaches[0]) && one.reaches[1];
    let has_no_end = |rung: &Rung| rung.run.contacts.iter().all(|one| one.measures.stretches.iter().all(goes_on));
    let Some((discretisation, mut rung)) = rungs.first.take_if(|(_, first)| has_no_end(first)) else {
        return Ok(Ok(None));
    };
    rungs.look(&discretisation, &mut rung)?;
    if rung.error <= rungs.asked.relative {
        return Ok(Err((discretisation, rung)));
    }
    let begins = rung.resolution.elements as f64 * ratio(rung.error / rungs.asked.relative);
    rungs.first = Some((discretisation, rung));
    Ok(Ok(Some(begins.ceil() as usize)))
}

/// The scene on the first mesh of the search.
pub(super) fn first(scene: &Scene) -> (Scene, Resolution) {
    if evenly::applies(scene) { evenly::first(scene) } else { length::first(scene) }
}

/// Meshes of a layout, each as much finer as the bars of the one before ask for; where none of them is enough, the best
/// of them and of another one.
fn refine(
    mut layout: Layout,
    begins: Option<usize>,
    mut rungs: Rungs,
    scene: &Scene,
    other: Option<Rung>,
) -> Result<Answer, Error> {
    // What cells of high order do not meet, 8-node cells meet on a coarse mesh or not at all.
    let loose = if other.is_some() { BESIDE } else { 0.0 };
    let elements = layout.begins(rungs.asked.relative.max(loose));
    let mut elements = begins.map_or(elements, |begins| elements.min(begins.max(fitted::FEWEST)));
    let mut course = Course::default();
    let mut why = "the mesh leaves too large an error".to_owned();
    for _ in 0..MOST {
        let laid = layout.laid(elements);
        let solved = match rungs.too_large(&laid) {
            Some(reason) => Err(reason),
            None => match rungs.solve(laid, "mesh") {
                Err(error @ Error { kind: Kind::DegenerateCell, .. }) => {
                    why = error.to_string();
                    break;
                }
                // The candidates are longer now.
                Err(error) if layout.lengthens(&error) => continue,
                Err(error) if !rungs.is_refused(&error) => return Err(error),
                other => other.map_err(|error| error.message),
            },
        };
        let (discretisation, mut rung) = match solved {
            Ok(solved) => solved,
            Err(_) if course.best.is_none() && elements > fitted::FEWEST => {
                elements = (elements / 2).max(fitted::FEWEST);
                continue;
            }
            Err(reason) => {
                why = reason;
                break;
            }
        };
        if !rung.run.solution.converged() {
            why = format!("the iteration ended so on the last mesh: {}", rung.run.solution.outcome);
            course.best = course.best.or(Some(rung));
            break;
        }
        if layout.looks(&rung.scene, &rung.run) {
            continue;
        }
        rungs.look(&discretisation, &mut rung)?;
        let is_open = rung.is_open();
        if is_open || rung.error <= rungs.asked.relative {
            let unmet = is_open.then(|| "no contact: every candidate is open".into());
            return rungs.answer(rung, Some((discretisation, None)), unmet);
        }
        elements = layout.finer(elements, ratio(rung.error / rungs.asked.relative));
        if let Some(reason) = course.ends_with(rung, other.as_ref(), rungs.asked.relative) {
            why = reason;
            break;
        }
    }
    let best = course.best;
    let is_better = |other: &Rung| best.as_ref().is_none_or(|best| best.error.is_nan() || other.error < best.error);
    match other.filter(is_better).or(best).or_else(|| rungs.first.take().map(|(_, first)| first)) {
        Some(best) => rungs.answer(best, None, Some(why)),
        None => {
            let remedy = "give `elements` and `per` instead of the accuracy";
            Err(Error::at(Place::Solve(scene.name.clone()), why, remedy))
        }
    }
}

/// What finer and finer meshes have come to, none of which was enough.
struct Course {
    best: Option<Rung>,
    /// Meshes in a row whose bars are no smaller.
    idle: usize,
    /// Meshes in a row whose bars tell that far larger ones would be needed.
    far: usize,
    /// Dofs and largest relative bar of the last one.
    last: [f64; 2],
}

impl Default for Course {
    fn default() -> Self {
        Self { best: None, idle: 0, far: 0, last: [f64::NAN; 2] }
    }
}

impl Course {
    /// Takes a mesh beside the best one of high order; why it is the last one, if it is.
    fn ends_with(&mut self, rung: Rung, other: Option<&Rung>, asked: f64) -> Option<String> {
        let (error, dofs) = (rung.error, rung.run.dofs as f64);
        let before = self.best.as_ref().map_or(f64::NAN, |best| best.error);
        let (falls, patience) = IDLE;
        self.idle = if before.is_nan() || error < falls * before { 0 } else { self.idle + 1 };
        self.far = if is_far(self.last, [dofs, error], asked) { self.far + 1 } else { 0 };
        self.last = [dofs, error];
        // Numbers that a finer mesh moves by more than their bars, or does not know, were too coarse to tell how far
        // they are off.
        let is_refuted = |best: &Rung| best.is_refuted_by(&rung);
        if before.is_nan() || error.is_nan() || error < before || self.best.as_ref().is_some_and(is_refuted) {
            self.best = Some(rung);
        }
        if other.is_some_and(|other| dofs > other.run.dofs as f64 && error > HOPELESS * other.error) {
            let left = percent_rounded_up(error);
            return Some(format!("cells of high order leave less than 8-node cells, which leave {left} %"));
        }
        if self.idle >= patience {
            return Some("on finer meshes the error bars are no smaller".into());
        }
        (self.far > 1).then(|| match error.is_nan() {
            true => "large meshes tell no error bar either".into(),
            false => "as its bars fall from mesh to mesh, one that is fine enough would be far too large".into(),
        })
    }
}

/// Whether no mesh that is solved in a minute will do, by the dofs and bars of two in a row that are not the coarsest;
/// where no bar is known, by the dofs alone.
fn is_far([less, before]: [f64; 2], [dofs, error]: [f64; 2], asked: f64) -> bool {
    let rate = (before / error).ln() / (dofs / less).ln();
    let [coarse, large] = TOLD;
    match error.is_nan() {
        true => dofs > large,
        false => dofs > coarse && rate > 0.0 && dofs * (error / asked).powf(1.0 / rate) > FORESEEN,
    }
}

/// By how much the elements must be smaller for bars that are so many times what is asked.
fn ratio(excess: f64) -> f64 {
    let [least, most] = RATIO;
    if excess.is_nan() { UNKNOWN } else { excess.powf(1.0 / ORDER).clamp(least, most) }
}

/// Family of meshes.
enum Layout {
    /// Fitted to one contact.
    Fitted(Fitted),
    /// Of equal candidates on several contacts, or halved from one that is given.
    Evenly(Evenly),
}

impl Layout {
    /// The layout of a scene, by cheap meshes that show where its contacts are; where one is not found, the last mesh
    /// with the reason.
    fn found(scene: &Scene, rungs: &mut Rungs) -> Result<Result<Self, (Rung, String)>, Error> {
        match evenly::applies(scene) {
            true => Ok(Ok(Self::Evenly(Evenly::found(scene, rungs)?))),
            false => Ok(length::found(scene, rungs)?.map(Self::Fitted)),
        }
    }

    /// The scene with candidates that hold its contacts.
    fn held(&self, scene: &Scene) -> Scene {
        match self {
            Self::Fitted(fitted) => fitted.plan(fitted::FEWEST).laid(scene).0,
            Self::Evenly(evenly) => evenly.held(scene),
        }
    }

    /// The scene with so many elements within the contact.
    fn laid(&self, elements: usize) -> (Scene, Resolution) {
        match self {
            Self::Fitted(fitted) => fitted.plan(elements).laid(&fitted.scene),
            Self::Evenly(evenly) => evenly.laid(elements),
        }
    }

    /// Elements of the first mesh whose bars are looked at.
    fn begins(&self, asked: f64) -> usize {
        match self {
            Self::Fitted(_) => fitted::elements(asked),
            Self::Evenly(evenly) => evenly.begins(asked),
        }
    }

    /// Elements of the next mesh.
    fn finer(&self, elements: usize, ratio: f64) -> usize {
        match self {
            Self::Evenly(evenly) if evenly.is_halved() => 2 * elements,
            _ => ((elements as f64 * ratio).ceil() as usize).max(elements + 1),
        }
    }

    /// Lengthens candidates that an error tells are too short; whether it does.
    fn lengthens(&mut self, error: &Error) -> bool {
        match self {
            Self::Fitted(fitted) => {
                let is_short = matches!(error.kind, Kind::ContactBeyondCandidates { .. });
                is_short && fitted.widens()
            }
            Self::Evenly(evenly) => evenly.lengthens(error),
        }
    }

    /// Takes what a run tells of the contact; whether its candidates were too short, and are longer now.
    fn looks(&mut self, scene: &Scene, run: &Run) -> bool {
        match self {
            Self::Fitted(fitted) => fitted.looks(scene, run),
            Self::Evenly(_) => false,
        }
    }
}
