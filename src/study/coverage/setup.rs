//! On which mesh a random scene is solved, and by which formulation.

use crate::accuracy::Quantity;
use crate::accuracy::longest::longest;
use crate::algorithm::StiffnessRule;
use crate::mesh::{Order, Resolution};
use crate::scene::{Profile, Scene};
use crate::solve::{Element, Formulation, Iteration};
use crate::study::random::{Draw, Sample, Site};

/// Fewest and most elements on half of the contact.
pub const ELEMENTS: [f64; 2] = [3.0, 30.0];
/// Growth of the elements along the surface, and into the depth.
const GROWTH: [[f64; 2]; 2] = [[1.2, 1.6], [1.2, 1.5]];
/// Candidate stretch over half of the contact.
const STRETCH: [f64; 2] = [1.3, 2.5];
/// Most candidate elements on a side: a contact far from s = 0 has them all the way from there.
const CANDIDATES: f64 = 160.0;
/// Of iterations that end early, the tolerance.
const EARLY: f64 = 1e-2;
/// Of those that end late.
const LATE: f64 = 1e-8;
/// Stiffness of penalties, over E*/a.
const PENALTY: [f64; 2] = [1e2, 1e4];
/// What tells the numbers of a mesh from those of the scene.
const SEED: u64 = 31_000_000;

/// A random scene on a random mesh.
pub struct Setup {
    /// The scene with its candidates and growth.
    pub scene: Scene,
    /// The mesh.
    pub resolution: Resolution,
    /// The formulation.
    pub formulation: Formulation,
    /// Elements on half of the contact; its end lies within one of them, but where the candidates end with it.
    pub per: f64,
}

impl Setup {
    /// Order, element and the way to end go in turn; all else is drawn.
    pub fn of(site: &Site, sample: &Sample) -> Self {
        let mut draw = Draw::new(SEED + 100_000 * site.family as u64 + site.number as u64);
        // The first number of a seed is like that of the next one.
        draw.between(0.0, 1.0);
        let mut scene = sample.scene.clone();
        let pair = &scene.contacts[0];
        let ends_there = matches!(pair.profile, Profile::Uniform(_) | Profile::Punch { .. });
        // A symmetric contact begins as far before s = 0 as it ends after it.
        let end = sample.end(0);
        let begin = Some(sample.truth(0, Quantity::Begin(0))).filter(|begin| begin.is_finite()).unwrap_or(-end);
        let (half, outer) = (0.5 * (end - begin), end.max(-begin));
        let [fewest, most] = ELEMENTS;
        let most = most.min(CANDIDATES * half / (STRETCH[1] * outer)).max(fewest);
        let per = draw.decades(fewest.max(sample.fewest.min(most)), most);
        let (per, elements) = if ends_there { (per.ceil(), per.ceil()) } else { (per, per.ceil()) };
        if !ends_there {
            let stretch = (draw.between(STRETCH[0], STRETCH[1]) * outer).min(longest(&scene, pair));
            scene.grading.unit = half * pair.path.metric() * elements / per;
            scene.contacts[0].stretch = stretch;
        }
        // Scenes whose elements are all alike stay so.
        if scene.grading.along > 1.0 {
            let [along, depth] = GROWTH.map(|[low, high]| draw.between(low, high));
            (scene.grading.along, scene.grading.depth) = (along, depth);
        }
        let turn = site.number;
        let order = if turn.is_multiple_of(2) { Order::Linear } else { Order::Quadratic };
        let formulation = Formulation::new(Element::ALL[turn / 2 % 3], Iteration::Kinematic);
        let formulation = match turn / 6 % 3 {
            0 => formulation.tolerance(LATE),
            1 => formulation.tolerance(EARLY),
            _ => Formulation {
                rule: StiffnessRule::Penalty,
                stiffness: draw.decades(PENALTY[0], PENALTY[1]),
                ..formulation.tolerance(LATE)
            },
        };
        let resolution = Resolution { elements: elements as usize, refinement: 0, order };
        Self { scene, resolution, formulation, per }
    }
}
