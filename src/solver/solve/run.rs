//! One problem solved by one formulation, measured; and how that ended: by the outcome of its iteration, or by the
//! error that broke it off.

use crate::algorithm::StiffnessRule;
use crate::clock::{Clock, Seconds, Stage};
use crate::contact::Interface;
use crate::error::{Coordinate, Error, Kind};
use crate::measure::{Measures, larger, largest, whole};
use crate::named::named_enum;
use crate::solution::{Outcome, Part, Solution, States};
use crate::solve::{Change, Discretisation, Equilibrium, Formulation, edge_fitted};

/// Imbalance of a body that the round-off of its stiffness may leave, whatever the tolerance: 2e-7 of a ring fifty
/// times as large as thick.
pub const BALANCED: f64 = 1e-6;

/// A point that carries so many times the peak is no part of the profile around it.
const ABOVE: f64 = 1.2;

/// Part of the contact in which oscillation is looked for: nearer its end a smooth pressure bends as strongly.
pub const INSIDE: f64 = 0.8;

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
    /// Measures of what the iteration shall end in, and of the discrete solution itself, which differ where springs of
    /// the rule `penalty` are the target; none where they were not found.
    pub exact: Option<[Measures; 2]>,
    /// What is known of a peak without a limit; none where it has one, or was not asked about.
    pub unbounded: Option<Unbounded>,
    /// Whether the contact is open in the discrete solution; none where that was not found.
    pub open: Option<bool>,
}

/// A peak that grows with every halving of the elements.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Unbounded {
    /// Where.
    #[serde(skip)]
    pub position: Coordinate,
    /// Growth at the last halving, over the peak.
    pub growth: f64,
    /// 1 − λ of `p ∝ r^(λ−1)` at a corner; none elsewhere.
    pub exponent: Option<f64>,
}

/// Relative errors, with sign.
#[derive(Clone, Copy, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Errors {
    /// Of the peak pressure.
    #[serde(rename = "peak_pressure")]
    pub peak: f64,
    /// Of the half-width.
    pub half_width: f64,
}

impl Errors {
    /// Of some measures against others that have a pressure.
    fn between(found: &Measures, wanted: &Measures) -> Self {
        let error = |found: f64, wanted: f64| (found - wanted) / wanted;
        // On one point the second moment about it vanishes.
        let half_width = if wanted.second_moment_width > 0.0 {
            error(found.second_moment_width, wanted.second_moment_width)
        } else {
            0.0
        };
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
    /// What is left over of the forces on each body.
    pub equilibrium: Vec<Equilibrium>,
    /// Operations of the sparse factorisation that condensed the bodies.
    pub sparse_operations: f64,
    /// What its stages took.
    pub seconds: Seconds,
}

impl Run {
    /// Whether every contact is open in the discrete solution: nothing presses.
    pub fn is_open(&self) -> bool {
        self.contacts.iter().all(|contact| contact.open == Some(true))
    }

    /// Solves a discretised scene by a formulation, from its own start, and measures the result.
    pub fn of(discretisation: &Discretisation, formulation: &Formulation) -> Result<Self, Error> {
        Self::from(None, discretisation, formulation, Change::NONE)
    }

    /// The same from the active set of an earlier solution, after a change of load or clearance.
    pub fn from(
        earlier: Option<&Solution>,
        discretisation: &Discretisation,
        formulation: &Formulation,
        change: Change,
    ) -> Result<Self, Error> {
        let mut clock = Clock::silent().after(&discretisation.seconds);
        let solution = clock.time(Stage::Iteration, || discretisation.solve_from(earlier, formulation, change))?;
        let mut run = Self {
            formulation: formulation.clone(),
            dofs: discretisation.system.dofs(),
            retained: discretisation.condensed.retained(),
            sparse_operations: discretisation.condensed.operations(),
            contacts: measured(discretisation, &solution),
            equilibrium: Vec::new(),
            solution,
            seconds: clock.seconds,
        };
        run.equilibrium = discretisation.equilibrium(change.load * run.share(), &run.solution)?;
        // Its iteration error is that of the condensed bodies: where these have lost the forces in round-off, it does
        // not see that.
        let is_balanced = run.imbalance() <= formulation.settings.tolerance.max(BALANCED);
        if run.solution.converged() && !is_balanced {
            run.solution.outcome = Outcome::Stalled;
        }
        Ok(run)
    }

    /// Whether the iteration has converged, though round-off may leave so much of the balance of a body.
    pub fn is_found(&self, most: f64) -> bool {
        let within = self.iteration_error() <= self.formulation.settings.tolerance && self.imbalance() <= most;
        self.solution.converged() || within
    }

    /// What is left over of the forces on a body, at the worst one; NaN where that is not known.
    pub fn imbalance(&self) -> f64 {
        largest(self.equilibrium.iter().map(Equilibrium::largest))
    }

    /// Whether a point of a contact carries more than the peak through its neighbours: a corner, or too coarse a mesh.
    pub fn stands_out(&self, contact: usize) -> bool {
        let Measures { largest, peak, .. } = &self.contacts[contact].measures;
        largest.pressure > ABOVE * peak.pressure
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

    /// Largest iteration error of peak and second-moment width over all contacts, of those that are open in the
    /// discrete solution the force that they carry; NaN where it is not known.
    pub fn iteration_error(&self) -> f64 {
        let of = |contact: &Contact| match contact.open {
            Some(true) => self.solution.error().force,
            _ => contact.iteration.map_or(f64::NAN, |errors| errors.largest()),
        };
        largest(self.contacts.iter().map(of))
    }

    /// Largest error of peak and second-moment width that a penalty makes; 0 without one, NaN where it is not known.
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
}

named_enum! {
    /// How a run ended, in the words of records and legends, from good to bad.
    pub enum Ended {
        /// Within the limit of iterations.
        Converged = "converged",
        /// Stopped by its criterion, above the tolerance.
        Stopped = "stopped",
        /// Not converged when the cap of iterations was reached.
        Capped = "capped",
        /// Nothing changes any more, and the error is above the tolerance.
        Stalled = "stalled",
        /// Returned to an earlier state.
        Cycling = "cycling",
        /// The error grows without end, or is no number.
        Diverged = "diverged",
        /// No spring left to hold a body, or springs too soft to: the named error.
        Unsupported = "unsupported",
        /// Converged with contact beyond the candidates: the named error.
        Beyond = "beyond",
    }
}

impl Ended {
    /// How a run ended, and after how many iterations; the error where that is of the input, and not of an iteration.
    pub fn of(run: &Result<Run, Error>) -> Result<(Self, usize), Error> {
        let error = match run {
            Ok(Run { solution, .. }) => {
                let ended = match solution.outcome {
                    Outcome::Converged => Self::Converged,
                    Outcome::Stopped => Self::Stopped,
                    Outcome::Capped => Self::Capped,
                    Outcome::Cycling { .. } => Self::Cycling,
                    Outcome::Diverged => Self::Diverged,
                    Outcome::Stalled => Self::Stalled,
                };
                return Ok((ended, solution.work.iterations));
            }
            Err(error) => error,
        };
        match error.kind {
            Kind::NoSpringLeft { iterations } => Ok((Self::Unsupported, iterations)),
            Kind::SpringsTooSoft => Ok((Self::Unsupported, 0)),
            Kind::ContactBeyondCandidates { .. } => Ok((Self::Beyond, 0)),
            _ => Err(error.clone()),
        }
    }
}

/// What was found of every contact.
fn measured(discretisation: &Discretisation, solution: &Solution) -> Vec<Contact> {
    let scene = &discretisation.scene;
    let with_lines = |parts: Vec<Part>| {
        let mut all: Vec<Measures> =
            parts.iter().enumerate().map(|(contact, part)| Measures::of(scene, contact, *part)).collect();
        edge_fitted::of_lines(discretisation, &mut all, &parts);
        all
    };
    let of = |states: &States| with_lines(solution.contacts.iter().map(|share| states.part(share)).collect());
    let measures = with_lines((0..scene.contacts.len()).map(|contact| solution.part(contact)).collect());
    let [target, rigid] = [&solution.target, &solution.rigid].map(|states| states.as_ref().map(of));
    let one = |(interface, measures): (&Interface, Measures)| {
        let found = |all: &Option<Vec<Measures>>| all.as_ref().map(|all| all[interface.contact].clone());
        contact(interface, solution, measures, [found(&target), found(&rigid)])
    };
    discretisation.interfaces.iter().zip(measures).map(one).collect()
}

/// What was found of one contact, given its measures, those of what the iteration shall end in, and of the discrete
/// solution.
fn contact(
    interface: &Interface,
    solution: &Solution,
    measures: Measures,
    [target, rigid]: [Option<Measures>; 2],
) -> Contact {
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
