//! Peaks without a limit: at a corner, under the tip of a wedge. The scene tells them by where they lie; the growth
//! with refinement is looked at where only meshes tell the gap, since a sharp but finite top grows alike until the mesh
//! resolves it.

use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use crate::error::Error;
use crate::mesh::Resolution;
use crate::mesh::size::expected;
use crate::solve::corner::{self, SMALL};
use crate::solve::run::{Run, Unbounded};
use crate::solve::{Discretisation, Element, Formulation, Iteration};

/// The last growth over the one before it from which on a series has no limit: 1 for a logarithm, `2^α` for `h^−α`, 1/4
/// for a value that converges with second order.
const STEADY: f64 = 0.7;
/// Most cells of a mesh that is given and refined to tell whether a peak has a limit.
const REFINED: f64 = 20e3;

impl Run {
    /// The same run, told which of its peaks have no limit, from coarser meshes.
    pub fn with_limits(mut self, discretisation: &Discretisation) -> Result<Self, Error> {
        let found = of(discretisation, &self)?;
        self.contacts.iter_mut().zip(found).for_each(|(contact, unbounded)| contact.unbounded = unbounded);
        Ok(self)
    }
}

/// Which peaks of a run have no limit: under a tip of the gap, or at a corner that is pressed, which the scene tells;
/// where only the meshes of the bodies tell the gap, and with it tips, also those that grow on three meshes, each of
/// half the elements of the next. None of the latter where these cannot be made or do not hold the contact.
pub fn of(discretisation: &Discretisation, run: &Run) -> Result<Vec<Option<Unbounded>>, Error> {
    let contacts = 0..run.contacts.len();
    if !run.solution.converged() {
        return Ok(vec![None; contacts.len()]);
    }
    let strongest = |all: Vec<Unbounded>| all.into_iter().max_by(|a, b| a.growth.total_cmp(&b.growth));
    let told = contacts.map(|contact| told(discretisation, run, contact).map(strongest));
    let told = told.collect::<Result<Vec<_>, Error>>()?;
    let pairs = &discretisation.scene.contacts;
    let is_measured = |contact: usize| told[contact].is_none() && pairs[contact].profile.tips().is_none();
    if !(0..told.len()).any(is_measured) {
        return Ok(told);
    }
    let Some(meshes) = halved(discretisation) else { return Ok(told) };
    // A limit is a matter of the scene, whatever the contact element; this one oscillates least.
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let on = |resolution: Resolution| match resolution == discretisation.resolution {
        true => Run::of(discretisation, &formulation),
        false => Run::of(&Discretisation::of(discretisation.scene.clone(), resolution)?, &formulation),
    };
    let [Ok(coarse), Ok(medium), Ok(fine)] = meshes.map(on) else { return Ok(told) };
    let runs = [&coarse, &medium, &fine];
    if runs.iter().any(|run| !run.solution.converged()) {
        return Ok(told);
    }
    let measured = |contact: usize| {
        let peaks = runs.map(|run| run.contacts[contact].measures.peak);
        let growth = grows(peaks.map(|peak| peak.pressure))?;
        let position = discretisation.scene.contacts[contact].path.reported(peaks[2].position);
        Some(Unbounded { position, growth, exponent: None })
    };
    let each = (0..told.len()).map(|contact| if is_measured(contact) { measured(contact) } else { told[contact] });
    Ok(each.collect())
}

/// Three meshes, each of half the elements of the next: with the mesh at hand as the finest; of bodies whose mesh is
/// given, which is the coarsest there is, that and two refinements where they are small. None where these cannot be
/// made.
fn halved(discretisation: &Discretisation) -> Option<[Resolution; 3]> {
    let (scene, own) = (&discretisation.scene, discretisation.resolution);
    if scene.bodies.iter().any(|body| body.shape.has_given_mesh()) {
        let first = own.refinement.saturating_sub(2);
        let all = [0, 1, 2].map(|more| Resolution { refinement: first + more, ..own });
        let [cells, _] = expected(scene, all[2]);
        return (own.refinement >= 2 || cells <= REFINED).then_some(all);
    }
    (own.elements >= 4).then(|| [4, 2, 1].map(|part| Resolution { elements: own.elements / part, ..own }))
}

/// Where the scene itself tells that a pressure has no limit: under a pressed tip `p ∝ E* Δ/2π · ln 1/d`, Δ the leap of
/// the slope there, so that every halving adds `E* Δ ln 2/2π`; at a pressed corner `p ∝ d^(λ−1)`, or `p ∝ ln 1/d`
/// beside a side that is sheared. Tips that add less than a hundredth, as those of the straight lines of a table of
/// many points, are as good as smooth.
pub(super) fn told(discretisation: &Discretisation, run: &Run, contact: usize) -> Result<Vec<Unbounded>, Error> {
    let (scene, measures) = (&discretisation.scene, &run.contacts[contact].measures);
    let pair = &scene.contacts[contact];
    let holds = |s: f64| measures.stretches.iter().any(|one| one.begin <= s && s < one.end);
    let per_halving = scene.modulus_of(pair) * LN_2 / (2.0 * PI * pair.path.metric() * measures.peak.pressure);
    let tips = pair.profile.tips().unwrap_or_default().into_iter().filter(|[s, _]| holds(*s));
    // A cone, `p = ½ E* tan β arcosh a/r`, adds `E* Δ ln 2/4`; an edge around the axis is as good as straight.
    let is_cone = |s: f64| scene.is_around_axis(contact) && s.abs() <= 0.0;
    let tip = |[s, leap]: [f64; 2]| {
        let growth = per_halving * leap * if is_cone(s) { FRAC_PI_2 } else { 1.0 };
        Unbounded { position: pair.path.reported(s), growth, exponent: None }
    };
    let pressed = tips.map(tip).filter(|tip| tip.growth > SMALL);
    Ok(pressed.chain(corner::pressed(discretisation, run, contact)?).collect())
}

/// Growth of the last of three values at halved elements, coarse to fine, over it; none where they have a limit, since
/// they do not grow as steadily as one without it.
pub fn grows([coarse, medium, fine]: [f64; 3]) -> Option<f64> {
    let [before, last] = [medium - coarse, fine - medium];
    (last > SMALL * fine && last >= STEADY * before && before > 0.0).then_some(last / fine)
}
