//! One problem solved by one formulation, measured.

use crate::algorithm::StiffnessRule;
use crate::clock::{Clock, Seconds, Stage};
use crate::contact::Interface;
use crate::error::Error;
use crate::measure::{Measures, larger, nodal, profile, whole};
use crate::solution::{Solution, States};
use crate::solve::{Change, Discretisation, Formulation, Origin};

/// Active points and pressed edges on a half-width from which on it is worth quoting.
pub const RESOLVED: [usize; 2] = [4, 3];

/// A point that carries so many times the peak is no part of the profile around it.
const ABOVE: f64 = 1.2;

/// Part of the contact in which oscillation is looked for: nearer its end a smooth pressure bends as strongly.
pub const INSIDE: f64 = 0.8;
/// Departure of a pressure from its neighbours' line, over the peak, that no smooth contact on a usable mesh shows.
const ROUGH: f64 = 0.1;

/// The numbers one quotes of a contact.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Contact {
    /// Half-width, peak and the like.
    pub measures: Measures,
    /// Force that the reported pressures exert on the upper (inner) body along the load line, both halves \[N\].
    pub transmitted: f64,
    /// Errors against the solution of the same discrete problem; none where that was not found, or is open.
    pub iteration: Option<Errors>,
    /// What springs of the rule `penalty` cost: their solution against that of the contact conditions.
    pub penalty: Option<Errors>,
    /// Measures of what the iteration shall end in, and of the discrete solution itself, which differ where springs of the rule
    /// `penalty` are the target; none where they were not found.
    pub exact: Option<[Measures; 2]>,
    /// What is known of a peak without a limit; none where it has one, or was not asked about.
    pub unbounded: Option<Unbounded>,
    /// Whether the contact is open in the discrete solution; none where that was not found.
    pub open: Option<bool>,
}

/// A peak that grows with every halving of the elements.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Unbounded {
    /// Contact coordinate \[mm, or rad on an arc\].
    pub position: f64,
    /// Growth at the last halving, over the peak.
    pub growth: f64,
}

/// Relative errors, with sign.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Errors {
    /// Of the peak pressure.
    pub peak: f64,
    /// Of the half-width.
    pub half_width: f64,
}

impl Errors {
    /// Of some measures against others that have a pressure.
    fn between(found: &Measures, wanted: &Measures) -> Self {
        let error = |found: f64, wanted: f64| (found - wanted) / wanted;
        // On one point the second moment about it vanishes.
        let half_width = if wanted.half_width > 0.0 { error(found.half_width, wanted.half_width) } else { 0.0 };
        Self { peak: error(found.peak.pressure, wanted.peak.pressure), half_width }
    }

    /// The larger size of both; NaN if either is.
    pub fn largest(&self) -> f64 {
        larger(self.peak.abs(), self.half_width.abs())
    }
}

/// A finished run.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Run {
    /// The formulation.
    pub formulation: Formulation,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Retained normal dofs.
    pub retained: usize,
    /// What came out.
    pub solution: Solution,
    /// The numbers one quotes, contact by contact.
    pub contacts: Vec<Contact>,
    /// Operations of the sparse factorisation that condensed the bodies.
    pub sparse_operations: f64,
    /// What its stages took.
    pub seconds: Seconds,
}

impl Run {
    /// Solves a discretised scene by a formulation, from its own start, and measures the result.
    pub fn of(discretisation: &Discretisation, formulation: &Formulation) -> Result<Self, Error> {
        Self::from_origin(Origin::Own, discretisation, formulation, Change::NONE)
    }

    /// The same from some start, after a change of load or clearance.
    pub fn from_origin(
        origin: Origin,
        discretisation: &Discretisation,
        formulation: &Formulation,
        change: Change,
    ) -> Result<Self, Error> {
        let mut clock = Clock::silent().after(&discretisation.seconds);
        let solution = clock.time(Stage::Iteration, || discretisation.solve_from(origin, formulation, change))?;
        Ok(Self {
            formulation: formulation.clone(),
            dofs: discretisation.system.dofs(),
            retained: discretisation.condensed.retained(),
            sparse_operations: discretisation.condensed.operations(),
            contacts: discretisation.interfaces.iter().map(|one| measured(discretisation, one, &solution)).collect(),
            solution,
            seconds: clock.seconds,
        })
    }

    /// The numbers of the first contact, which is the only one of most scenes.
    pub fn measures(&self) -> &Measures {
        &self.contacts[0].measures
    }

    /// Force that the first contact transmits along the load line, both halves \[N\].
    pub fn transmitted(&self) -> f64 {
        self.contacts[0].transmitted
    }

    /// Share of loads and prescribed displacements that the last iteration was made under: 1 at the last increment.
    pub fn share(&self) -> f64 {
        let increments = self.formulation.settings.increments;
        self.solution.history.last().map_or(1.0, |iteration| iteration.increment as f64 / increments as f64)
    }

    /// Largest iteration error of peak and half-width over all contacts, of those that are open in the discrete solution the
    /// force that they carry; NaN where it is not known.
    pub fn iteration_error(&self) -> f64 {
        let of = |contact: &Contact| match contact.open {
            Some(true) => self.solution.error().force,
            _ => contact.iteration.map_or(f64::NAN, |errors| errors.largest()),
        };
        largest(self.contacts.iter().map(of))
    }

    /// Largest error of peak and half-width that a penalty makes; 0 without one, NaN where it is not known.
    pub fn penalty_error(&self) -> f64 {
        if self.formulation.rule != StiffnessRule::Penalty {
            return 0.0;
        }
        let of = |contact: &Contact| match contact.open {
            Some(true) => 0.0,
            _ => contact.penalty.map_or(f64::NAN, |errors| errors.largest()),
        };
        largest(self.contacts.iter().map(of))
    }

    /// What a user must know before quoting a contact of a converged run: no contact, contact on too few points, pressures
    /// that oscillate, an open middle, what a penalty costs.
    pub fn note(&self, contact: usize) -> Option<String> {
        let points = self.solution.points_of(contact);
        let all = [points.len(), self.solution.edges_of(contact).len()];
        let Contact { measures, penalty, open, unbounded, .. } = &self.contacts[contact];
        let (begin, edge) = (measures.begin(), measures.edge());
        let (middle, reach) = (0.5 * (begin + edge), 0.5 * (edge - begin));
        let rough = profile::oscillation(&profile::about(points, middle), INSIDE * reach) / measures.peak.pressure;
        let highest = measures.largest.pressure;
        // As many on each side of x = 0, where the point there may be common to both.
        let across = points.first().is_some_and(|point| point.position < 0.0);
        let resolved = RESOLVED.map(|number| if across { 2 * number - 1 } else { number });
        match measures.active {
            _ if !self.solution.converged() => None,
            _ if *open == Some(true) => Some("no contact: every candidate is open".into()),
            _ if let Some(errors) = penalty => Some(format!(
                "the springs of the penalty cost {:+.2} % of the peak and {:+.2} % of the half-width",
                100.0 * errors.peak,
                100.0 * errors.half_width
            )),
            _ if let Some(Unbounded { growth, .. }) = unbounded => Some(format!(
                "the peak has grown by {:.0} % with the last halving of the elements: it has no limit, or is narrower than the mesh shows",
                100.0 * growth
            )),
            n if n < resolved[0].min(all[0]) => {
                Some(format!("contact rests on {n} of {} candidate points: refine before quoting it", all[0]))
            }
            // An edge of many nodes is as good as several.
            _ if !nodal::are_many(self.solution.part(contact)) && measures.pressed_edges < resolved[1].min(all[1]) => {
                Some(format!(
                    "contact rests on {} of {} candidate edges: refine before quoting it",
                    measures.pressed_edges, all[1]
                ))
            }
            _ if rough > ROUGH => Some(format!(
                "pressures of neighbouring points depart from one another by {:.0} % of the peak: quote means over edges, or use the node element",
                100.0 * rough
            )),
            _ if highest > ABOVE * measures.peak.pressure => Some(format!(
                "a point carries {highest:.4} MPa, more than the peak through its neighbours: a corner, or too coarse a mesh"
            )),
            _ if measures.stretches.len() > 1 => Some(format!(
                "the contact is closed on {} stretches and open between them: the half-width is that of all together",
                measures.stretches.len()
            )),
            _ => None,
        }
    }

    /// Decades between the last iteration error and the tolerance, and between the last but one and the tolerance.
    pub fn decision_margin(&self) -> [f64; 2] {
        let tolerance = self.formulation.settings.tolerance;
        let mut last = self.solution.history.iter().rev().map(|iteration| iteration.error.largest());
        let mut decades = || last.next().map_or(f64::NAN, |error| (error.max(1e-99) / tolerance).log10());
        let end = decades();
        [end, decades()]
    }
}

/// The largest of some errors; NaN where one is not known.
fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, larger)
}

/// What was found of one contact.
fn measured(discretisation: &Discretisation, interface: &Interface, solution: &Solution) -> Contact {
    let (scene, contact) = (&discretisation.scene, interface.contact);
    let of = |states: &States| Measures::of(scene, contact, states.part(&solution.contacts[contact]));
    let measures = Measures::of(scene, contact, solution.part(contact));
    let target = solution.target.as_ref().map(of);
    let rigid = solution.rigid.as_ref().map(of);
    let presses = |measures: &&Measures| measures.largest.pressure > 0.0;
    let (pressing, rigidly) = (target.as_ref().filter(presses), rigid.as_ref().filter(presses));
    let discrete = rigid.as_ref().or(target.as_ref());
    Contact {
        transmitted: transmitted(interface, &solution.contact_force),
        iteration: pressing.map(|target| Errors::between(&measures, target)),
        penalty: pressing.zip(rigidly).map(|(target, rigid)| Errors::between(target, rigid)),
        unbounded: None,
        open: discrete.map(|discrete| discrete.largest.pressure <= 0.0),
        exact: target.clone().map(|target| [target.clone(), rigid.unwrap_or(target)]),
        measures,
    }
}

/// Sum of the nodal contact forces on the upper (inner) body along the load line, both halves \[N\].
pub(super) fn transmitted(interface: &Interface, contact_force: &[f64]) -> f64 {
    let along = interface.nodes.iter().map(|s| contact_force[s.dof] * s.normal[1]);
    let upwards = if interface.pair.above { 1.0 } else { -1.0 };
    upwards * whole(&interface.pair) * along.sum::<f64>()
}
