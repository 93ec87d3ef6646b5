//! The meshes of a search, solved and remembered.

use crate::accuracy::answer::{largest, quoted};
use crate::accuracy::bar::of_contacts;
use crate::accuracy::laid::Laid;
use crate::accuracy::{Answer, Asked, Barred, Quantity, Tried, TriedContact, ends};
use crate::error::Error;
use crate::mesh::Resolution;
use crate::scene::{ContactPair, Scene};
use crate::solution::Solution;
use crate::solve::edge_fitted;
use crate::solve::run::{Contact, Run};
use crate::solve::{Change, Discretisation, Formulation, Origin};

/// Why no mesh meets an accuracy of a peak without a limit.
const UNBOUNDED: &str = "the peak has no limit, so that no mesh meets an accuracy of it";

/// A mesh solved.
pub(super) struct Rung {
    pub(super) scene: Scene,
    pub(super) resolution: Resolution,
    pub(super) run: Run,
    /// What its bars say of the quantities asked for; empty where they were not looked at.
    pub(super) estimates: Vec<Barred>,
}

/// A search under way: what is asked, and every mesh solved.
pub(super) struct Rungs<'a> {
    pub(super) formulation: Formulation,
    pub(super) asked: &'a Asked,
    pub(super) tried: Vec<Tried>,
    /// The mesh on which the contact was found.
    pub(super) first: Option<Rung>,
    /// State of the last mesh, from which the next one starts.
    last: Option<Solution>,
}

impl Rung {
    /// Whether no contact touches.
    pub(super) fn is_open(&self) -> bool {
        self.run.is_open()
    }
}

impl<'a> Rungs<'a> {
    /// Nothing is known yet.
    pub(super) fn new(formulation: Formulation, asked: &'a Asked) -> Self {
        Self { formulation, asked, tried: Vec::new(), first: None, last: None }
    }

    /// Looks at the bars of the mesh solved last.
    pub(super) fn look(&mut self, discretisation: &Discretisation, rung: &mut Rung) {
        let bars = of_contacts(discretisation, &rung.run);
        rung.estimates = quoted(&bars, &rung.run, self.asked);
        if let Some(tried) = self.tried.last_mut() {
            tried.coarser = bars.dofs;
            tried.estimate = largest(&rung.estimates);
        }
    }

    /// Solves on a mesh from the active set of the one before.
    pub(super) fn solve(&mut self, laid: Laid, purpose: &'static str) -> Result<(Discretisation, Rung), Error> {
        let Laid { scene, resolution, growth } = laid;
        let discretisation = Discretisation::of(scene, resolution)?;
        let run = match &self.last {
            Some(before) => Run::from_origin(Origin::From(before), &discretisation, &self.formulation, Change::NONE)?,
            None => Run::of(&discretisation, &self.formulation)?,
        };
        self.last = Some(run.solution.clone());
        let rung = self.remember(&discretisation, run, purpose);
        if let Some(tried) = self.tried.last_mut() {
            tried.growth = growth;
        }
        Ok((discretisation, rung))
    }

    /// Takes a mesh that was solved into the list.
    pub(super) fn remember(&mut self, discretisation: &Discretisation, run: Run, purpose: &'static str) -> Rung {
        let (scene, resolution) = (discretisation.scene.clone(), discretisation.resolution);
        let pressed = |(contact, pair)| ends::pressed(run.solution.part(contact), pair)[1];
        self.tried.push(Tried {
            purpose,
            order: resolution.order,
            elements: scene.contacts.iter().enumerate().map(pressed).min().unwrap_or(0),
            growth: scene.grading.along,
            dofs: run.dofs,
            coarser: 0,
            iterations: run.solution.work.iterations,
            contacts: Tried::contacts(&scene, &run),
            estimate: f64::NAN,
        });
        Rung { scene, resolution, run, estimates: vec![] }
    }

    /// Takes a mesh on which the ends of a contact were sought into the list.
    pub(super) fn sought(&mut self, on: &edge_fitted::Tried) {
        let nothing = TriedContact { stretch: f64::NAN, peak: f64::NAN, half_width: f64::NAN };
        self.tried.push(Tried {
            purpose: "ends of the contact",
            order: on.order,
            elements: 0,
            growth: f64::NAN,
            dofs: on.dofs,
            coarser: 0,
            iterations: 1,
            contacts: vec![nothing],
            estimate: f64::NAN,
        });
    }

    /// Answers with a mesh; a peak whose bar was not looked at, or did not fall, may have no limit.
    pub(super) fn answer(self, rung: Rung, unmet: Option<String>) -> Result<Answer, Error> {
        let Rung { scene, resolution, mut run, estimates } = rung;
        let of_peak = self.asked.quantities.contains(&Quantity::PeakPressure);
        if unmet.is_some() || !of_peak {
            run = run.with_limits(&Discretisation::of(scene.clone(), resolution)?)?;
        }
        let unbounded = of_peak && run.contacts.iter().any(|contact| contact.unbounded.is_some());
        let unmet = unmet.map(|why| if unbounded { UNBOUNDED.to_owned() } else { why });
        Ok(Answer { scene, resolution, run, estimates, unmet, tried: self.tried })
    }
}

impl Tried {
    /// What a run says of each contact of its scene.
    pub(super) fn contacts(scene: &Scene, run: &Run) -> Vec<TriedContact> {
        let one = |(pair, contact): (&ContactPair, &Contact)| {
            let (peak, half_width) = (contact.measures.peak.pressure, contact.measures.half_width());
            TriedContact { stretch: pair.stretch, peak, half_width }
        };
        scene.contacts.iter().zip(&run.contacts).map(one).collect()
    }
}
