//! Peaks without a limit: under the corner of a punch, the tip of a wedge. They are known by how they grow with refinement.

use crate::error::Error;
use crate::mesh::Resolution;
use crate::solve::run::{Run, Unbounded};
use crate::solve::{Discretisation, Element, Formulation, Iteration};

/// The last growth over the one before it from which on a series has no limit: 1 for a logarithm, `2^α` for `h^−α`, 1/4 for
/// a value that converges with second order.
const STEADY: f64 = 0.7;
/// Growth at the last halving, over the peak, below which a series is as good as at its limit.
const SMALL: f64 = 0.01;

impl Run {
    /// The same run, told which of its peaks have no limit, from coarser meshes.
    pub fn with_limits(mut self, discretisation: &Discretisation) -> Result<Self, Error> {
        let found = of(discretisation, &self)?;
        self.contacts.iter_mut().zip(found).for_each(|(contact, unbounded)| contact.unbounded = unbounded);
        Ok(self)
    }
}

/// Whether the peaks of a run grow without a limit: told from meshes of half and a quarter of the elements. None where these
/// cannot be made or do not hold the contact, and for bodies whose mesh is given.
pub fn of(discretisation: &Discretisation, run: &Run) -> Result<Vec<Option<Unbounded>>, Error> {
    let nothing = Ok(vec![None; run.contacts.len()]);
    let Resolution { elements, .. } = discretisation.resolution;
    if elements < 4
        || !run.solution.converged()
        || discretisation.scene.bodies.iter().any(|body| body.shape.has_given_mesh())
    {
        return nothing;
    }
    // A limit is a matter of the scene, whatever the contact element; this one oscillates least.
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let coarser = |part: usize| {
        let resolution = Resolution { elements: elements / part, ..discretisation.resolution };
        Run::of(&Discretisation::of(discretisation.scene.clone(), resolution)?, &formulation)
    };
    let (Ok(coarse), Ok(medium), Ok(fine)) = (coarser(4), coarser(2), Run::of(discretisation, &formulation)) else {
        return nothing;
    };
    let runs = [&coarse, &medium, &fine];
    if runs.iter().any(|run| !run.solution.converged()) {
        return nothing;
    }
    let each = (0..run.contacts.len()).map(|contact| {
        let peaks = runs.map(|run| run.contacts[contact].measures.peak);
        grows(peaks.map(|peak| peak.pressure)).map(|growth| Unbounded { position: peaks[2].position, growth })
    });
    Ok(each.collect())
}

/// Growth of the last of three values at halved elements, coarse to fine, over it; none where they have a limit.
pub fn grows([coarse, medium, fine]: [f64; 3]) -> Option<f64> {
    let [before, last] = [medium - coarse, fine - medium];
    (last > SMALL * fine && last >= STEADY * before && before > 0.0).then_some(last / fine)
}
