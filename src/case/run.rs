//! One problem solved by one formulation, measured.

use std::time::Instant;

use crate::contact::Interface;
use crate::error::Error;
use crate::formulation::{Discretisation, Formulation};
use crate::measure::{Measures, profile, whole};
use crate::solution::Solution;

/// Active points on a half-width from which on it is worth quoting.
pub const RESOLVED: usize = 4;

/// A point that carries so many times the peak is no part of the profile around it.
const ABOVE: f64 = 1.2;

/// Part of the contact in which oscillation is looked for: nearer its end a smooth pressure bends as strongly.
pub const INSIDE: f64 = 0.8;
/// Departure of a pressure from its neighbours' line, over the peak, that no smooth contact on a usable mesh shows.
const ROUGH: f64 = 0.1;

/// The numbers one quotes of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Half-width, peak and the like.
    pub measures: Measures,
    /// Force that the reported pressures exert on the upper (inner) body along the load line, both halves \[N\].
    pub transmitted: f64,
}

/// Part of its largest pressure from which on a point of a weak contact counts as active, and above which pressures that
/// the tolerance leaves open are no small part of it.
const WEAK: f64 = 0.05;
/// Pressure over that of the tolerance that rounding explains.
const ROUND_OFF: f64 = 1e-6;

/// A finished run.
#[derive(Clone, Debug)]
pub struct Run {
    /// The formulation.
    pub formulation: Formulation,
    /// Unknown displacement components.
    pub freedoms: usize,
    /// Retained normal freedoms.
    pub retained: usize,
    /// What came out.
    pub solution: Solution,
    /// The numbers one quotes, contact by contact.
    pub contacts: Vec<Contact>,
    /// Pressure that the tolerance leaves open, tolerance times the reference pressure \[MPa\].
    pub told: f64,
    /// Operations of the sparse factorisation that condensed the bodies.
    pub sparse_operations: f64,
    /// Seconds by stage.
    pub seconds: Vec<(&'static str, f64)>,
}

impl Run {
    /// Solves a discretised scene by a formulation and measures the result.
    pub fn of(discretisation: &Discretisation, formulation: &Formulation) -> Result<Self, Error> {
        Self::solved(discretisation, formulation, || discretisation.solve(formulation))
    }

    /// The same from the contact set of a solution on another mesh.
    pub fn carrying(
        discretisation: &Discretisation,
        formulation: &Formulation,
        earlier: &Solution,
    ) -> Result<Self, Error> {
        Self::solved(discretisation, formulation, || discretisation.solve_carrying(formulation, earlier))
    }

    fn solved(
        discretisation: &Discretisation,
        formulation: &Formulation,
        solve: impl FnOnce() -> Result<Solution, Error>,
    ) -> Result<Self, Error> {
        let clock = Instant::now();
        let solution = solve()?;
        let mut seconds = discretisation.seconds.clone();
        seconds.push(("iteration", clock.elapsed().as_secs_f64()));
        let scene = &discretisation.scene;
        let floor = formulation.settings.tolerance * scene.reference.pressure;
        Ok(Self {
            formulation: formulation.clone(),
            freedoms: discretisation.system.freedoms(),
            retained: discretisation.condensed.retained(),
            sparse_operations: discretisation.condensed.operations(),
            contacts: (discretisation.interfaces.iter())
                .map(|interface| Contact {
                    measures: Measures::of(scene, &solution, interface.contact, own_floor(&solution, interface, floor)),
                    transmitted: transmitted(interface, &solution),
                })
                .collect(),
            told: floor,
            solution,
            seconds,
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

    /// Share of loads and prescribed displacements that the last step was made under: 1 at the last increment.
    pub fn share(&self) -> f64 {
        let increments = self.formulation.settings.increments;
        self.solution.history.last().map_or(1.0, |step| step.increment as f64 / increments as f64)
    }

    /// What a user must know before quoting a contact of a converged run: no contact, contact on too few points, pressures
    /// that oscillate.
    pub fn note(&self, contact: usize) -> Option<String> {
        let points = self.solution.points_of(contact);
        let (all, several) = (points.len(), self.contacts.len() > 1);
        let measures = &self.contacts[contact].measures;
        let Measures { begin, edge, .. } = *measures;
        let (middle, reach) = (0.5 * (begin + edge), 0.5 * (edge - begin));
        let rough = profile::oscillation(&profile::about(points, middle), INSIDE * reach) / measures.peak.pressure;
        let highest = points.iter().map(|point| point.pressure).fold(0.0, f64::max);
        // As many on each side of x = 0, where the point there may be common to both.
        let across = points.first().is_some_and(|point| point.position < 0.0);
        let resolved = if across { 2 * RESOLVED - 1 } else { RESOLVED };
        match measures.active {
            _ if !self.solution.converged() => None,
            0 => Some("no contact: every candidate is open".into()),
            _ if highest > 0.0 && self.told > WEAK * highest && several => Some(format!(
                "the tolerance leaves {:.2e} MPa open, {:.0} % of the largest pressure here: ask for a smaller one",
                self.told,
                100.0 * self.told / highest
            )),
            n if n < resolved.min(all) => {
                Some(format!("contact rests on {n} of {all} candidate points: refine before quoting it"))
            }
            _ if rough > ROUGH => Some(format!(
                "pressures depart from their neighbours by {:.0} % of the peak: quote means over edges",
                100.0 * rough
            )),
            _ if highest > ABOVE * measures.peak.pressure => Some(format!(
                "a point carries {highest:.4} MPa, more than the peak through its neighbours: a corner, or too coarse a mesh"
            )),
            _ => None,
        }
    }

    /// Decades between the last residual and the tolerance, and between the last but one and the tolerance.
    pub fn decision_margin(&self) -> [f64; 2] {
        let tolerance = self.formulation.settings.tolerance;
        let mut last = self.solution.history.iter().rev().map(|step| step.residuals.largest());
        let mut decades = || last.next().map_or(f64::NAN, |residual| (residual.max(1e-99) / tolerance).log10());
        let end = decades();
        [end, decades()]
    }
}

/// The pressure from which on a point counts as active: `tolerance · p_ref`, or where a weaker one of several contacts has
/// no such pressure the same part of its largest one; what is round-off of the reference counts nowhere \[MPa\].
fn own_floor(solution: &Solution, interface: &Interface, floor: f64) -> f64 {
    let pressures = solution.points_of(interface.contact).iter().map(|point| point.pressure);
    let largest = pressures.fold(0.0, f64::max);
    let weaker = solution.contacts.len() > 1 && largest < floor / WEAK && largest > ROUND_OFF * floor;
    if weaker { WEAK * largest } else { floor }
}

/// Sum of the nodal contact forces on the upper (inner) body along the load line, both halves \[N\].
fn transmitted(interface: &Interface, solution: &Solution) -> f64 {
    let along = interface.stations.iter().map(|s| solution.contact_force[s.freedom] * s.normal[1]);
    let upwards = if interface.pair.above { 1.0 } else { -1.0 };
    upwards * whole(&interface.pair) * along.sum::<f64>()
}
