//! The meshes of a search: how they are laid out, solved and remembered.

use crate::accuracy::ends;
use crate::accuracy::fitted::Plan;
use crate::accuracy::longest::longest;
use crate::accuracy::{Answer, Asked, Quantity, Quoted, Tried, TriedContact};
use crate::error::{Error, Kind};
use crate::mesh::Order;
use crate::mesh::size::{MOST, expected};
use crate::scene::{ContactPair, Scene};
use crate::solve::run::{Contact, Run};
use crate::solve::{Change, Discretisation, Formulation, Origin};

/// Order of the cells of every answer.
pub(super) const ORDER: Order = Order::Quadratic;

/// A mesh solved.
pub(super) struct Rung {
    pub(super) plan: Plan,
    pub(super) run: Run,
}

/// What became of a mesh that was to be solved.
pub(super) enum Attempt {
    /// It stands among the rungs here.
    Solved(usize),
    /// Contact reaches the end of its candidates.
    Short,
    /// It was not solved, for this reason.
    Stopped(String),
}

/// A search under way: what is asked, what is known of the contact, and every mesh solved.
pub(super) struct Search<'a> {
    pub(super) scene: &'a Scene,
    pub(super) formulation: Formulation,
    pub(super) asked: &'a Asked,
    /// Longest candidate stretch that the bodies allow.
    pub(super) longest: f64,
    /// Where the contact begins and ends.
    pub(super) ends: [f64; 2],
    /// Fewest elements of an answer: fewer did not agree with a finer mesh.
    pub(super) least: usize,
    pub(super) rungs: Vec<Rung>,
    pub(super) tried: Vec<Tried>,
}

impl<'a> Search<'a> {
    /// Nothing is known yet.
    pub(super) fn new(scene: &'a Scene, formulation: Formulation, asked: &'a Asked) -> Self {
        let longest = longest(scene, scene.contact());
        let (rungs, tried) = (Vec::new(), Vec::new());
        Self { scene, formulation, asked, longest, ends: [-longest, longest], least: 1, rungs, tried }
    }

    pub(super) fn quantities(&self) -> impl Iterator<Item = Quantity> {
        self.asked.quantities.iter().copied()
    }

    /// A mesh with so many elements within the contact as it is known so far.
    pub(super) fn plan(&self, elements: usize, level: u32) -> Plan {
        Plan::around(self.ends, self.longest, elements, ORDER, level)
    }

    /// Takes the ends of the contact from a rung.
    pub(super) fn look(&mut self, at: usize) {
        let Rung { plan, run } = &self.rungs[at];
        self.ends = ends::ends(run.solution.part(0), plan.scene(self.scene).contact());
    }

    /// Makes the contact known a tenth longer.
    pub(super) fn widen(&mut self) {
        let [begin, edge] = self.ends;
        let more = 0.05 * (edge - begin);
        self.ends = [(begin - more).max(-self.longest), (edge + more).min(self.longest)];
    }

    /// Whether an outermost candidate is pressed although the bodies allow more: the penetration beyond it is seen at nodes
    /// only, and the next one may lie where the surfaces have parted again.
    pub(super) fn cut_off(&self, at: usize) -> bool {
        let Rung { plan, run } = &self.rungs[at];
        let shorter = plan.stretch < self.longest * (1.0 - 1e-9);
        run.solution.converged() && shorter && ends::filled(run.solution.part(0), self.scene.contact()).contains(&true)
    }

    /// Solves on a mesh within the limits.
    pub(super) fn attempt(&mut self, plan: Plan, purpose: &'static str) -> Result<Attempt, Error> {
        let [cells, candidates] = expected(&plan.scene(self.scene), plan.resolution());
        let most = self.asked.most_cells;
        if !(cells <= most && candidates <= MOST[1]) {
            return Ok(Attempt::Stopped(format!(
                "the next mesh would have about {cells:.1e} cells, more than {most:.0e}"
            )));
        }
        match self.solve(plan, purpose) {
            Ok(at) if self.cut_off(at) => Ok(Attempt::Short),
            Ok(at) if self.rungs[at].run.solution.converged() => Ok(Attempt::Solved(at)),
            Ok(_) => Ok(Attempt::Stopped("the iteration does not converge on the last mesh".into())),
            Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => Ok(Attempt::Short),
            Err(error @ Error { kind: Kind::DegenerateCell, .. }) => Ok(Attempt::Stopped(error.to_string())),
            Err(error) => Err(error),
        }
    }

    /// Solves on a mesh from the active set of the one before; where it stands among the rungs.
    pub(super) fn solve(&mut self, plan: Plan, purpose: &'static str) -> Result<usize, Error> {
        let discretisation = Discretisation::of(plan.scene(self.scene), plan.resolution())?;
        let run = match self.rungs.last() {
            Some(before) => {
                Run::from_origin(Origin::From(&before.run.solution), &discretisation, &self.formulation, Change::NONE)?
            }
            None => Run::of(&discretisation, &self.formulation)?,
        };
        self.tried.push(Tried {
            purpose,
            order: plan.order,
            elements: plan.elements,
            growth: plan.growth()[0],
            dofs: run.dofs,
            iterations: run.solution.work.iterations,
            contacts: Tried::contacts(&plan.scene(self.scene), &run),
            estimate: f64::NAN,
        });
        self.rungs.push(Rung { plan, run });
        Ok(self.rungs.len() - 1)
    }

    /// Writes an estimate beside the mesh it is of.
    pub(super) fn note(&mut self, at: usize, estimate: f64) {
        let solved = self.tried.iter_mut().filter(|tried| tried.dofs > 0);
        if let Some(tried) = solved.into_iter().nth(at) {
            tried.estimate = estimate;
        }
    }

    pub(super) fn answer(mut self, at: usize, estimates: Vec<Quoted>, unmet: Option<String>) -> Answer {
        let Rung { plan, run } = self.rungs.swap_remove(at);
        Answer {
            scene: plan.scene(self.scene),
            resolution: plan.resolution(),
            run,
            estimates,
            unmet,
            tried: self.tried,
        }
    }
}

impl Tried {
    /// A stretch beyond which contact went on.
    pub(super) fn beyond(order: Order, elements: usize, stretch: f64) -> Self {
        let [dofs, iterations] = [0; 2];
        let growth = Plan::even(order, elements, stretch, 0).growth()[0];
        let contacts = vec![TriedContact { stretch, peak: f64::NAN, half_width: f64::NAN }];
        let purpose = "contact length";
        Self { purpose, order, elements, growth, dofs, iterations, contacts, estimate: f64::NAN }
    }

    /// What a run says of each contact of its scene.
    pub(super) fn contacts(scene: &Scene, run: &Run) -> Vec<TriedContact> {
        let one = |(pair, contact): (&ContactPair, &Contact)| {
            let (peak, half_width) = (contact.measures.peak.pressure, contact.measures.half_width);
            TriedContact { stretch: pair.stretch, peak, half_width }
        };
        scene.contacts.iter().zip(&run.contacts).map(one).collect()
    }
}
