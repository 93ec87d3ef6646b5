//! Peaks without a limit: under the corner of a punch, the tip of a wedge. They are known by where they lie, and by how they grow with
//! refinement: the growth of a sharp but finite top alone does not tell it from one without a limit until the mesh resolves it.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, LN_2, PI};

use crate::error::Error;
use crate::mesh::Resolution;
use crate::mesh::size::expected;
use crate::scene::{ContactPair, Profile};
use crate::solution::EdgeState;
use crate::solve::run::{Run, Unbounded};
use crate::solve::{Discretisation, Element, Formulation, Iteration};

/// The last growth over the one before it from which on a series has no limit: 1 for a logarithm, `2^α` for `h^−α`, 1/4 for
/// a value that converges with second order.
pub const STEADY: f64 = 0.7;
/// The same where the side of a body ends: `2^α`, α from 0.2 to ½; a finite pressure that is largest there shows less than 1.
const CORNER: f64 = 1.0;
/// Edges between a corner and the peak that is found next to it.
const NEAR: f64 = 2.0;
/// Difference of contact coordinates, over them, that rounding explains.
const ROUNDING: f64 = 1e-9;
/// Most cells of a mesh that is given and refined to tell whether a peak has a limit.
const REFINED: f64 = 20e3;
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

/// Which peaks of a run have no limit: under a tip of the gap, or the corner of a rigid punch, which the scene tells; else where a side ends
/// and the peak grows as under a corner, told from three meshes, each of half the elements of the next. None of the latter where these
/// cannot be made or do not hold the contact.
pub fn of(discretisation: &Discretisation, run: &Run) -> Result<Vec<Option<Unbounded>>, Error> {
    let told = |contact: usize| told(discretisation, run, contact);
    let told: Vec<Option<Unbounded>> = (0..run.contacts.len()).map(told).collect();
    if !run.solution.converged() {
        return Ok(vec![None; run.contacts.len()]);
    }
    // A limit is a matter of the scene, whatever the contact element; this one oscillates least.
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let Ok(own) = Run::of(discretisation, &formulation) else { return Ok(told) };
    if (0..told.len()).all(|contact| told[contact].is_some() || steady(discretisation, &own, contact).is_none()) {
        return Ok(told);
    }
    let Some(meshes) = halved(discretisation) else { return Ok(told) };
    let on = |resolution: Resolution| match resolution == discretisation.resolution {
        true => Ok(own.clone()),
        false => Run::of(&Discretisation::of(discretisation.scene.clone(), resolution)?, &formulation),
    };
    let [Ok(coarse), Ok(medium), Ok(fine)] = meshes.map(on) else { return Ok(told) };
    let runs = [&coarse, &medium, &fine];
    if runs.iter().any(|run| !run.solution.converged()) {
        return Ok(told);
    }
    let each = told.into_iter().enumerate().map(|(contact, told)| {
        let peaks = runs.map(|run| run.contacts[contact].measures.peak);
        let grown = || {
            let growth = grows(peaks.map(|peak| peak.pressure), steady(discretisation, &own, contact)?)?;
            Some(Unbounded { position: peaks[2].position, growth })
        };
        told.or_else(grown)
    });
    Ok(each.collect())
}

/// Whether a peak may be one without a limit: the scene tells it, or only meshes do, or a contact goes on to where a side may end.
pub fn may_be(discretisation: &Discretisation, run: &Run) -> bool {
    let one = |(contact, pair): (usize, &ContactPair)| {
        let reaches = run.contacts[contact].measures.stretches.iter().any(|one| one.reaches.contains(&true));
        reaches || pair.profile.tips().is_none() || told(discretisation, run, contact).is_some()
    };
    discretisation.scene.contacts.iter().enumerate().any(one)
}

/// Three meshes, each of half the elements of the next: with the mesh at hand as the finest; of bodies whose mesh is given, which is the
/// coarsest there is, that and two refinements where they are small. None where these cannot be made.
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

/// What the scene itself tells of a peak without a limit: under a pressed tip `p ∝ E* Δ/2π · ln 1/d`, Δ the leap of the slope there, so that
/// every halving adds `E* Δ ln 2/2π`; under the corner of a rigid punch `p ∝ d^−½`. Tips that add less than a hundredth, as those of the
/// straight lines of a table of many points, are as good as smooth.
fn told(discretisation: &Discretisation, run: &Run, contact: usize) -> Option<Unbounded> {
    let (scene, measures) = (&discretisation.scene, &run.contacts[contact].measures);
    let pair = &scene.contacts[contact];
    let holds = |s: f64| measures.stretches.iter().any(|one| one.begin <= s && s < one.end);
    let per_halving = scene.modulus_of(pair) * LN_2 / (2.0 * PI * pair.path.metric() * measures.peak.pressure);
    let tips = pair.profile.tips().unwrap_or_default().into_iter();
    // A cone, `p = ½ E* tan β arcosh a/r`, adds `E* Δ ln 2/4`; an edge around the axis is as good as straight.
    let is_cone = |position: f64| scene.is_of_revolution() && position.abs() <= 0.0;
    let growth = |position: f64, leap: f64| per_halving * leap * if is_cone(position) { FRAC_PI_2 } else { 1.0 };
    let tips = tips.map(|[position, leap]| Unbounded { position, growth: growth(position, leap) });
    let sharpest = tips.filter(|tip| holds(tip.position)).max_by(|a, b| a.growth.total_cmp(&b.growth));
    if let Some(tip) = sharpest.filter(|tip| tip.growth > SMALL) {
        return Some(tip);
    }
    let Profile::Punch { half_width } = pair.profile else { return None };
    let reaches = measures
        .stretches
        .iter()
        .any(|one| (one.reaches[0] || one.reaches[1]) && one.end >= half_width * (1.0 - ROUNDING));
    reaches.then_some(Unbounded { position: half_width, growth: 1.0 - FRAC_1_SQRT_2 })
}

/// The last growth over the one before it that a corner or tip shows next to the peak; none where there is neither, so that it has a limit.
fn steady(discretisation: &Discretisation, run: &Run, contact: usize) -> Option<f64> {
    // Only the meshes of the bodies tell where they have corners.
    if discretisation.scene.contacts[contact].profile.tips().is_none() {
        return Some(STEADY);
    }
    let measures = &run.contacts[contact].measures;
    let ends = measures.stretches.iter().flat_map(|one| [one.begin, one.end].into_iter().zip(one.reaches));
    let mut places = ends.filter(|(_, reaches)| *reaches).map(|(s, _)| s);
    let edges = run.solution.edges_of(contact);
    let is_near = places.any(|place| {
        let away = |edge: &&EdgeState| (edge.position() - place).abs();
        let nearest = edges.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        let near = NEAR * nearest.map_or(f64::NAN, EdgeState::length);
        [measures.peak.position, measures.largest.position].into_iter().any(|own| (own - place).abs() <= near)
    });
    is_near.then_some(CORNER)
}

/// Growth of the last of three values at halved elements, coarse to fine, over it; none where they have a limit, since they do not grow as
/// steadily as asked.
pub fn grows([coarse, medium, fine]: [f64; 3], steady: f64) -> Option<f64> {
    let [before, last] = [medium - coarse, fine - medium];
    (last > SMALL * fine && last >= steady * before && before > 0.0).then_some(last / fine)
}
