//! Which meshes are solved, and which one is answered.

use crate::accuracy::answer::largest;
use crate::accuracy::depth::Depth;
use crate::accuracy::ends;
use crate::accuracy::fitted::{self, LEVELS, Plan};
use crate::accuracy::halved;
use crate::accuracy::rungs::{ORDER, Rung, Search};
use crate::accuracy::{Answer, Asked, Tried};
use crate::error::{Error, Kind, Part};
use crate::mesh::Resolution;
use crate::scene::Scene;
use crate::solve::{Formulation, Start};

/// Elements of the first mesh, over the candidate stretch that the scene guesses.
const FIRST: usize = 8;
/// Pressed elements on a side from which on a first mesh tells where the contact ends.
const TOLD: usize = 3;
/// Most elements of a first mesh on a side.
const FINEST: usize = 128;
/// Guesses of the stretch: each is twice as long, or as short as what was pressed.
const GUESSES: usize = 16;
/// Ladders that may fail to settle, each on gentler growth than the one before.
const PATIENCE: usize = 3;
/// Iteration tolerance over the error asked for.
const ITERATION: f64 = 0.01;

/// The mesh by kinematic load.
pub(super) fn solve(scene: &Scene, formulation: &Formulation, asked: &Asked) -> Result<Answer, Error> {
    let mut formulation = Formulation { start: Start::Closed, ..formulation.clone() };
    let settings = &mut formulation.settings;
    settings.tolerance = settings.tolerance.min(ITERATION * asked.relative).max(1e-12);
    if halved::applies(scene) {
        return halved::solve(scene, &formulation, asked);
    }
    let mut search = Search::new(scene, formulation, asked);
    if let Some(why) = search.first()? {
        return Ok(search.answer(0, vec![], Some(why)));
    }
    search.refine()
}

/// The scene on the first mesh of the search.
pub(super) fn first(scene: &Scene) -> (Scene, Resolution) {
    if halved::applies(scene) {
        return halved::first(scene);
    }
    let plan = Plan::even(ORDER, FIRST, scene.contact().stretch, 0);
    (plan.scene(scene), plan.resolution())
}

/// What is next after a first mesh.
enum Guess {
    /// The contact is known well enough.
    Known,
    /// So many elements on a stretch of this length.
    Again(usize, f64),
    /// Nothing, for this reason.
    Stopped(String),
}

impl Search<'_> {
    /// Finds where the contact ends on a cheap mesh; says why where it cannot.
    fn first(&mut self) -> Result<Option<String>, Error> {
        let mut stretch = self.scene.contact().stretch.min(self.longest);
        let (mut elements, mut level) = (FIRST, 0);
        for _ in 0..GUESSES {
            match self.solve(Plan::even(ORDER, elements, stretch, level), "contact length") {
                Err(Error { kind: Kind::DegenerateCell, .. }) if level < LEVELS => level += 2,
                Err(error) if stretch < self.longest && self.is_short(&error) => {
                    self.tried.push(Tried::beyond(ORDER, elements, stretch));
                    stretch = (2.0 * stretch).min(self.longest);
                }
                // A contact shorter than two elements.
                Err(Error { kind: Kind::NoSpringLeft { .. }, .. }) if elements < FINEST && self.turns() => {
                    elements *= 2
                }
                Err(error) => return Err(error),
                Ok(at) => match self.guess(at) {
                    Guess::Known => {
                        self.look(at);
                        return Ok(None);
                    }
                    Guess::Stopped(reason) => return Ok(Some(reason)),
                    Guess::Again(finer, other) => (elements, stretch) = (finer, other),
                },
            }
        }
        match self.rungs.len() {
            0 => Err(Error::value(
                self.scene.place_of(0, Part::Stretch),
                "candidate stretch",
                self.scene.contact().stretch,
                format!("no contact length was found in {GUESSES} guesses"),
                "give a stretch a little longer than the contact",
            )),
            _ => Ok(Some(format!("no contact length was found in {GUESSES} guesses"))),
        }
    }

    /// Whether longer candidates may be solved: contact reaches their end, or all of it lies there and across x = 0
    /// nothing holds a body against turning.
    fn is_short(&self, error: &Error) -> bool {
        match error.kind {
            Kind::ContactBeyondCandidates { .. } => true,
            Kind::NoSpringLeft { .. } => self.turns(),
            _ => false,
        }
    }

    /// Whether nothing but contact fixes a body against turning, as across x = 0.
    fn turns(&self) -> bool {
        self.scene.contact().path.has_both_sides()
    }

    /// What a first mesh tells of the contact.
    fn guess(&self, at: usize) -> Guess {
        let Rung { plan: Plan { elements, stretch, .. }, run } = &self.rungs[at];
        let (solution, pair) = (&run.solution, self.scene.contact());
        let [pressed, outermost] = ends::pressed(solution.part(0), pair);
        let filled = ends::filled(solution.part(0), pair).contains(&true);
        let across = pair.path.has_both_sides();
        let told = pressed >= if across { 2 * TOLD } else { TOLD };
        // Across x = 0 one or two points hold no body against turning.
        if !solution.converged() && (told || !across) {
            return Guess::Stopped(format!("the first iteration ended so: {}", solution.outcome));
        }
        if pressed == 0 {
            return Guess::Stopped("no candidate is pressed".into());
        }
        if filled && *stretch < self.longest * (1.0 - 1e-9) {
            return Guess::Again(*elements, (2.0 * stretch).min(self.longest));
        }
        if solution.converged() && (told || filled) {
            return Guess::Known;
        }
        match outermost + 1 {
            enough if enough < *elements => Guess::Again(*elements, stretch * enough as f64 / *elements as f64),
            // A shorter stretch would end within the contact.
            _ if *elements < FINEST => Guess::Again(2 * elements, *stretch),
            _ => Guess::Stopped(format!(
                "the contact takes {pressed} of {} candidate elements, far from x = 0: put x = 0 nearer to it",
                2 * elements
            )),
        }
    }

    /// From growth to growth: on each the ladder along the contact, then gentler growth on the surface meshes it chose, and a
    /// mesh finer in both directions for the one that is answered.
    fn refine(mut self) -> Result<Answer, Error> {
        let mut level = fitted::level(self.asked.relative);
        let mut best = (self.rungs.len() - 1, vec![]);
        let mut why = String::new();
        let (mut unsettled, mut finest) = (0, None);
        while level <= LEVELS && unsettled < PATIENCE {
            let along = self.along(level)?;
            if let Some(reason) = along.unmet {
                (why, finest) = (reason, along.finest.or(finest));
                level += 2;
                unsettled += 1;
                continue;
            }
            let mut next = u32::MAX;
            for fine in &along.chosen {
                match self.on_gentler_growth(fine)? {
                    Depth::Met(quoted) => {
                        let quoted = self.confirmed(fine, quoted)?;
                        if largest(&quoted) <= self.asked.relative {
                            return Ok(self.answer(fine.rung, quoted, None));
                        }
                        why = "a mesh finer in both directions differs by more than was asked".into();
                        self.least = self.rungs[fine.rung].plan.elements + 1;
                        best = (fine.rung, quoted);
                    }
                    Depth::From(gentler, quoted) => {
                        why = "the growth away from the contact leaves too large an error".into();
                        best = (fine.rung, quoted);
                        next = next.min(gentler);
                    }
                    Depth::Stopped(reason) => {
                        if best.1.is_empty() {
                            best = (fine.rung, self.quoted(fine, None));
                        }
                        return Ok(self.answer(best.0, best.1, Some(reason)));
                    }
                }
            }
            level = if next < u32::MAX { next.max(level + 1) } else { level + 1 };
        }
        let Some(finest) = finest.filter(|_| best.1.is_empty()) else {
            return Ok(self.answer(best.0, best.1, Some(why)));
        };
        // The ladder did not settle, and its finest mesh may be fine enough all the same.
        let mut quoted = self.told(&finest)?;
        if largest(&quoted) <= self.asked.relative {
            quoted = self.confirmed(&finest, quoted)?;
        }
        let unmet = if largest(&quoted) <= self.asked.relative { None } else { Some(why) };
        Ok(self.answer(finest.rung, quoted, unmet))
    }
}
