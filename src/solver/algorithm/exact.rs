//! The discrete solution itself: the one set of closed points under which nothing penetrates and nothing pulls.
//!
//! `S u + Σ A p b = f̂`, `p ≥ 0`, `w ≤ g`, `p (g − w) = 0` at every point are the conditions of least energy
//! `½ uᵀS u − f̂ᵀu` over all `w ≤ g`. They have one displacement, up to motions that contact does not feel, whatever
//! algorithm looks for it. S is small and dense, so that the set is found by changing it until it stands: every closed
//! point that pulls opens, every open one that penetrates closes (primal-dual active set; Hintermüller, Ito & Kunisch
//! 2002). Where a set returns, or leaves a body free, one point at a time is changed instead (the largest violation;
//! Murty 1974).
//!
//! Where points are more than displacements can follow, pressures are not unique: those of least `Σ A p²` are found,
//! the limit of equal springs that stiffen.

use crate::algorithm::{ContactProblem, Iterate, Springs};
use crate::solution::Work;

/// What a closed point does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// It touches: `w = g`.
    Rigid,
    /// Its initial spring carries `k₀ (w − g)`: what the rule `penalty` solves.
    Springs,
}

/// The discrete solution.
#[derive(Clone, Debug)]
pub struct Exact {
    /// Whether each point carries pressure.
    pub closed: Vec<bool>,
    /// Displacements, approaches, pressures.
    pub iterate: Iterate,
    /// Sets that were tried.
    pub sets: usize,
}

/// Springs that hold closed points of the mean area of their contact, over what both bodies resist there, one behind
/// the other. What they yield is carried over until it is round-off. Of a stiff body on a soft one that is the soft
/// one's: springs as stiff as the stiff one would leave the soft one's forces to round-off.
const HOLDING: f64 = 1e5;
/// Times what the springs carry is handed over: each leaves about `1/HOLDING` of the penetration before.
const HANDED: usize = 4;
/// Tension over the largest pressure of its contact that is round-off.
const PULLS: f64 = 1e-10;
/// Penetration over the largest lengths of its contact, of which it is the difference, that is round-off.
const PENETRATES: f64 = 1e-13;
/// Sets that are tried: changing one point at a time takes about one for each point that must change.
const SETS: usize = 1000;

impl Exact {
    /// The solution, looked for from a set of closed points; none where there is none, or it was not found.
    pub fn of(problem: &ContactProblem, law: Law, start: &[bool]) -> Option<Self> {
        let mut search = Search::of(problem, law);
        let all = vec![true; problem.points.len()];
        search.from(start.to_vec()).or_else(|| search.from(all))
    }

    /// Equilibrium with a set of points closed, whatever sign their pressures have; none where it leaves a body free.
    pub fn bilateral(problem: &ContactProblem, closed: &[bool]) -> Option<Iterate> {
        Search::of(problem, Law::Rigid).solved(closed)
    }
}

/// Springs of closed points [MPa/mm].
fn holding(problem: &ContactProblem, law: Law) -> Vec<f64> {
    if law == Law::Springs {
        return problem.initial.clone();
    }
    let mut sums = vec![[0.0; 2]; problem.compliance.len()];
    for point in problem.points {
        let [stiffness, area] = &mut sums[point.contact];
        *stiffness += problem.resistance(point);
        *area += point.weight;
    }
    problem.points.iter().map(|point| HOLDING * sums[point.contact][0] / sums[point.contact][1]).collect()
}

struct Search<'a> {
    problem: &'a ContactProblem<'a>,
    law: Law,
    holding: Vec<f64>,
    seen: Vec<Vec<bool>>,
}

impl<'a> Search<'a> {
    fn of(problem: &'a ContactProblem, law: Law) -> Self {
        Self { problem, law, holding: holding(problem, law), seen: Vec::new() }
    }

    /// Changes a set until it stands.
    fn from(&mut self, mut closed: Vec<bool>) -> Option<Exact> {
        self.seen.clear();
        let mut one_by_one = false;
        let mut violations: Vec<f64> = Vec::new();
        let mut held: Option<Vec<bool>> = None;
        for sets in 1..=SETS {
            let Some(iterate) = self.solved(&closed) else {
                // Too many points were opened at once.
                closed = held.take()?;
                one_by_one = true;
                flip_worst(&mut closed, &violations)?;
                continue;
            };
            violations = self.violations(&closed, &iterate)?;
            if violations.iter().all(|violation| *violation <= 0.0) {
                return Some(Exact { closed, iterate, sets });
            }
            one_by_one |= self.seen.contains(&closed);
            self.seen.push(closed.clone());
            held = Some(closed.clone());
            if one_by_one {
                flip_worst(&mut closed, &violations)?;
            } else {
                closed
                    .iter_mut()
                    .zip(&violations)
                    .filter(|(_, v)| **v > 0.0)
                    .for_each(|(closed, _)| *closed = !*closed);
            }
        }
        None
    }

    /// Equilibrium with a set of points closed; none where it leaves a body free.
    fn solved(&self, closed: &[bool]) -> Option<Iterate> {
        let work = &mut Work::default();
        let stiffness: Vec<f64> =
            self.holding.iter().zip(closed).map(|(k, closed)| if *closed { *k } else { 0.0 }).collect();
        let factor = self.problem.factorise(&stiffness, work)?;
        let mut springs = Springs { force: vec![0.0; stiffness.len()], stiffness };
        let handed = if self.law == Law::Rigid { HANDED } else { 0 };
        for _ in 0..handed {
            springs.force = self.problem.equilibrium(&factor, &springs, |point| point.gap, work).pressure;
        }
        Some(self.problem.equilibrium(&factor, &springs, |point| point.gap, work))
    }

    /// By how much each point is in the wrong state, over the largest pressure of its contact; 0 where it is right,
    /// none where numbers are none.
    fn violations(&self, closed: &[bool], iterate: &Iterate) -> Option<Vec<f64>> {
        let points = self.problem.points;
        let mut largest = vec![0.0_f64; self.problem.compliance.len()];
        points.iter().zip(&iterate.pressure).for_each(|(at, p)| largest[at.contact] = largest[at.contact].max(p.abs()));
        let overall = largest.iter().copied().fold(0.0, f64::max);
        let round_off = self.problem.round_off(&iterate.displacement);
        let mut longest = vec![0.0_f64; largest.len()];
        for point in points.iter().filter(|point| point.gap.is_finite()) {
            let length = point.gap.abs() + point.size_of_approach(&iterate.displacement);
            longest[point.contact] = longest[point.contact].max(length);
        }
        let each = (0..points.len()).map(|i| {
            let (pressure, depth) = (iterate.pressure[i], iterate.approach[i] - points[i].gap);
            let is_none = pressure.abs() * points[i].weight <= round_off[points[i].contact];
            let p = if is_none { 0.0 } else { pressure };
            let scale = largest[points[i].contact].max(PULLS * overall).max(f64::MIN_POSITIVE);
            // What it would take to close it.
            let pressing = depth * self.holding[i] / HOLDING;
            match closed[i] {
                true if p < -PULLS * scale => -p / scale,
                false
                    if pressing * points[i].weight > round_off[points[i].contact]
                        && depth > PENETRATES * longest[points[i].contact] =>
                {
                    pressing / scale
                }
                _ => 0.0,
            }
        });
        let each: Vec<f64> = each.collect();
        let finite = iterate.pressure.iter().chain(&iterate.approach).all(|x| x.is_finite());
        finite.then_some(each)
    }
}

/// Changes the point that is most wrong.
fn flip_worst(closed: &mut [bool], violations: &[f64]) -> Option<()> {
    let worst = (0..closed.len()).max_by(|&a, &b| violations[a].total_cmp(&violations[b]))?;
    closed[worst] = !closed[worst];
    Some(())
}
