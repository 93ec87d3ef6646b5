//! The meshes of a search, solved and remembered.

use crate::accuracy::answer::{largest, quoted};
use crate::accuracy::bar::{judged, of_pressures};
use crate::accuracy::family::Family;
use crate::accuracy::watch::{Tell, Watch};
use crate::accuracy::{Answer, Asked, Bar, Barred, Quantity, Tried, TriedContact, fitted};
use crate::error::{Error, Kind};
use crate::measure::larger;
use crate::mesh::Resolution;
use crate::mesh::size::{MOST, cells_of, dense, expected};
use crate::scene::{ContactPair, Scene};
use crate::solution::Solution;
use crate::solve::run::{Contact, Run};
use crate::solve::{Change, Discretisation, Formulation, edge_fitted};

/// Meshes in a row whose peak has no limit, from which on none is sought for it: on a coarse one a sharp top may look
/// like that.
const WITHOUT_LIMIT: usize = 2;
/// Why no mesh meets an accuracy of a peak without a limit, where the scene tells that and where only meshes do.
const UNBOUNDED: &str = "the peak has no limit, so that no mesh meets an accuracy of it";
const GROWS: &str =
    "the peak grows with every halving of the elements: it has no limit, or is narrower than these meshes show";

/// A mesh solved.
pub(super) struct Rung {
    pub(super) scene: Scene,
    pub(super) resolution: Resolution,
    pub(super) run: Run,
    /// Its place in the list of meshes.
    number: usize,
    /// What its bars say of the quantities asked for; empty where they were not looked at.
    pub(super) estimates: Vec<Barred>,
    /// What the meshes say that told them, where no finer one did.
    family: Option<Family>,
    /// Largest relative bar of those that some mesh may meet; NaN where one is not known, or none was looked at.
    pub(super) error: f64,
}

/// A mesh that is held, and the finer one that judges it.
pub(super) type Held = (Discretisation, Option<(Discretisation, Run)>);

/// A search under way: what is asked, and every mesh solved.
pub(super) struct Rungs<'a> {
    pub(super) formulation: Formulation,
    pub(super) asked: &'a Asked,
    pub(super) tried: Vec<Tried>,
    /// Which meshes are solved.
    pub(super) watch: Watch<'a>,
    /// Dofs of the smallest mesh that was refused for them.
    next: Option<usize>,
    /// The mesh on which the contact was found.
    pub(super) first: Option<(Discretisation, Rung)>,
    /// State of the last mesh, from which the next one starts.
    last: Option<Solution>,
    /// Meshes in a row on which the peak of each contact had no limit.
    without_limit: Vec<usize>,
}

impl Rung {
    /// Whether no contact touches.
    pub(super) fn is_open(&self) -> bool {
        self.run.is_open()
    }

    /// Whether a finer mesh moves a number by more than its bar.
    pub(super) fn is_refuted_by(&self, finer: &Self) -> bool {
        self.estimates.iter().any(|one| {
            let finer = finer.estimates.iter().find(|other| other.is_of(one.contact, &one.quantity));
            finer.is_some_and(|finer| (finer.value - one.value).abs() > one.bar.total())
        })
    }
}

impl<'a> Rungs<'a> {
    /// Nothing is known yet.
    pub(super) fn new(formulation: Formulation, asked: &'a Asked, tell: Tell<'a>) -> Self {
        let watch = Watch::new(asked.relative, asked.most_dofs, tell);
        Self {
            formulation,
            asked,
            tried: Vec::new(),
            watch,
            next: None,
            first: None,
            last: None,
            without_limit: Vec::new(),
        }
    }

    /// Looks at the bars of a mesh, and at whether its peaks have a limit.
    pub(super) fn look(&mut self, discretisation: &Discretisation, rung: &mut Rung) -> Result<(), Error> {
        self.limit(discretisation, rung)?;
        // Of meshes that end with the contact the next one tells what pressures do, and others what is wanted besides:
        // only once that is asked for.
        let on_ends = rung.scene.contacts.iter().any(|pair| !pair.ends.places.is_empty());
        let wanted = if on_ends { None } else { Some(&self.asked.wanted[..]) };
        let permits = |dofs| self.watch.permits(dofs);
        let family = Family::permitted(discretisation, &rung.run.formulation, wanted, None, &permits);
        self.tried[rung.number].coarser = family.dofs();
        self.take(&of_pressures(discretisation, &rung.run, &family), rung);
        rung.family = wanted.is_some().then_some(family);
        Ok(())
    }

    /// The same where a finer mesh tells them; without one coarser ones do.
    pub(super) fn judge(
        &mut self,
        (discretisation, rung): (&Discretisation, &mut Rung),
        finer: Option<&(Discretisation, Rung)>,
    ) -> Result<(), Error> {
        let Some((finer, judge)) = finer else { return self.look(discretisation, rung) };
        self.limit(discretisation, rung)?;
        self.take(&judged(discretisation, &rung.run, (finer, &judge.run)), rung);
        Ok(())
    }

    /// Whether a mesh is good enough by its distance from a finer one, to which the bar there is added; its estimates
    /// are these then.
    pub(super) fn is_enough(&mut self, rung: &mut Rung, finer: &Rung) -> bool {
        // A contact that is closed on the finer mesh alone has no number here.
        let by_finer = |judge: &Barred| {
            let one = rung.estimates.iter().find(|one| one.is_of(judge.contact, &judge.quantity))?;
            let mesh = (one.value - judge.value).abs() + judge.bar.total();
            Some(Barred { bar: Bar { mesh, ..one.bar }, unknown: None, ..one.clone() })
        };
        let Some(estimates) = finer.estimates.iter().map(by_finer).collect::<Option<Vec<Barred>>>() else {
            return false;
        };
        let error = largest(&estimates);
        let is_enough = error <= self.asked.relative;
        if is_enough {
            (rung.estimates, rung.error) = (estimates, error);
            self.tried[rung.number].estimate = error;
        }
        is_enough
    }

    /// Looks at whether the peaks of a mesh have a limit.
    fn limit(&mut self, discretisation: &Discretisation, rung: &mut Rung) -> Result<(), Error> {
        if self.asks_for_peak() {
            rung.run = rung.run.clone().with_limits(discretisation)?;
        }
        self.without_limit.resize(rung.run.contacts.len(), 0);
        for (meshes, contact) in self.without_limit.iter_mut().zip(&rung.run.contacts) {
            *meshes = if contact.unbounded.is_some() { *meshes + 1 } else { 0 };
        }
        Ok(())
    }

    /// Takes what bars say of a mesh.
    fn take(&mut self, bars: &[Barred], rung: &mut Rung) {
        rung.estimates = quoted(bars, &rung.run, self.asked);
        self.tried[rung.number].estimate = largest(&rung.estimates);
        let no_mesh =
            |one: &Barred| one.quantity == Quantity::PeakPressure && self.without_limit[one.contact] >= WITHOUT_LIMIT;
        let relative = rung.estimates.iter().filter(|one| !no_mesh(one)).map(Barred::relative);
        rung.error = if rung.estimates.is_empty() { f64::NAN } else { relative.fold(0.0, larger) };
        self.watch.estimated(rung.error);
    }

    /// Takes why a mesh was not solved; whether it has more dofs than are allowed.
    pub(super) fn is_refused(&mut self, error: &Error) -> bool {
        let Kind::TooManyDofs { dofs } = error.kind else { return false };
        self.next = Some(self.next.map_or(dofs, |next| next.min(dofs)));
        true
    }

    fn asks_for_peak(&self) -> bool {
        self.asked.quantities.contains(&Quantity::PeakPressure)
    }

    /// Why a mesh is too large to be solved.
    pub(super) fn too_large(&self, (scene, resolution): &(Scene, Resolution)) -> Option<String> {
        let (cells, [_, candidates]) = (cells_of(scene, *resolution), expected(scene, *resolution));
        let (most_cells, [_, most]) = (self.asked.most_cells, MOST);
        if !resolution.is_allowed() {
            let (elements, halved) = Resolution::MOST;
            let what = format!(
                "the next mesh would have more than {elements} elements, or be halved more than {halved} times"
            );
            return Some(what);
        }
        let fits = cells <= most_cells && dense(scene, *resolution) <= most;
        (!fits).then(|| {
            format!(
                "the next mesh would have about {cells:.1e} cells and {candidates:.0} candidate elements, more \
                than {most_cells:.0e} or {most}"
            )
        })
    }

    /// Solves on a mesh from the active set of the one before.
    pub(super) fn solve(
        &mut self,
        (scene, resolution): (Scene, Resolution),
        purpose: &'static str,
    ) -> Result<(Discretisation, Rung), Error> {
        let discretisation = self.watch.discretised(scene, resolution)?;
        let run = Run::from(self.last.as_ref(), &discretisation, &self.formulation, Change::NONE)?;
        let rung = self.remember(&discretisation, run, purpose);
        Ok((discretisation, rung))
    }

    /// Takes a mesh that was solved into the list.
    pub(super) fn remember(&mut self, discretisation: &Discretisation, run: Run, purpose: &'static str) -> Rung {
        self.watch.took(&run);
        self.last = Some(run.solution.clone());
        let (scene, resolution) = (discretisation.scene.clone(), discretisation.resolution);
        self.tried.push(Tried {
            elements: (0..scene.contacts.len()).map(|contact| fitted::pressed(&run, contact)[1]).min().unwrap_or(0),
            growth: growth(&scene, resolution),
            dofs: run.dofs,
            iterations: run.solution.work.iterations,
            contacts: Tried::contacts(&scene, &run),
            ..Tried::unsolved(purpose, resolution.order, f64::NAN)
        });
        Rung { scene, resolution, run, number: self.tried.len() - 1, estimates: vec![], family: None, error: f64::NAN }
    }

    /// Takes a mesh on which the ends of a contact were sought into the list.
    pub(super) fn sought(&mut self, on: &edge_fitted::Tried) {
        let unsolved = Tried::unsolved("ends of the contact", on.order, f64::NAN);
        self.tried.push(Tried { dofs: on.dofs, iterations: 1, ..unsolved });
    }

    /// Answers with a mesh and what judges it, or with one that is no longer held; a peak that was not looked at may
    /// have no limit.
    pub(super) fn answer(self, rung: Rung, held: Option<Held>, unmet: Option<String>) -> Result<Answer, Error> {
        let Rung { scene, resolution, mut run, estimates, family, .. } = rung;
        let of_peak = self.asks_for_peak();
        let (mut discretisation, judge) = held.map_or((None, None), |(own, judge)| (Some(own), judge));
        if estimates.is_empty() || !of_peak {
            let own = match discretisation {
                Some(own) => own,
                None => Discretisation::of(scene.clone(), resolution)?,
            };
            run = run.with_limits(&own)?;
            discretisation = Some(own);
        }
        let without_limit = scene.contacts.iter().zip(&run.contacts).find(|(_, contact)| contact.unbounded.is_some());
        let unbounded = without_limit.filter(|_| of_peak).map(|(pair, _)| match pair.profile.tips() {
            Some(_) => UNBOUNDED,
            None => GROWS,
        });
        let next = self.next.filter(|_| unmet.is_some() && !run.is_open());
        let unmet = match next.zip(self.asked.most_dofs) {
            _ if let Some(unbounded) = unbounded => Some(unbounded.to_owned()),
            Some((next, most)) => {
                let until = largest(&estimates);
                let until = match until.is_nan() {
                    true => "no error is known".into(),
                    false => format!("{} % is met", percent_rounded_up(until)),
                };
                Some(format!("the next mesh would have {next} dofs, more than the {most} allowed; until then {until}"))
            }
            None => unmet,
        };
        Ok(Answer { scene, resolution, run, estimates, unmet, next, tried: self.tried, discretisation, judge, family })
    }
}

/// Growth of a mesh along the surface; NaN where that of every body is given.
fn growth(scene: &Scene, resolution: Resolution) -> f64 {
    let is_given = scene.bodies.iter().all(|body| body.shape.has_given_mesh());
    if is_given { f64::NAN } else { scene.grading.along.powf(0.5_f64.powf(f64::from(resolution.refinement))) }
}

/// A relative error in percent, rounded up to two digits.
pub(super) fn percent_rounded_up(error: f64) -> String {
    let percent = 100.0 * error;
    let places = (1.0 - percent.max(f64::MIN_POSITIVE).log10().floor()).clamp(0.0, 15.0);
    let tens = 10_f64.powf(places);
    format!("{:.*}", places as usize, (percent * tens).ceil() / tens)
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
