//! What a profile is judged with: the truth, the measures taken, and the forms of a verdict.

use crate::case::{self, Check, Judged};
use crate::markdown;
use crate::measure::{Measures, Quantity};
use crate::referee::between::STRAIGHT;
use crate::referee::profile::Profile;
use crate::referee::truth::{Known, Truth};
use crate::solution::{Part, PointState};
use crate::uncertainty::standard;

/// What judges one contact.
pub struct Bench<'a> {
    /// The truth of its case.
    pub truth: &'a Truth,
    /// What was handed in.
    pub profile: &'a Profile,
    /// Its measures.
    pub measures: &'a Measures,
    /// The tolerance asked for.
    pub tolerance: f64,
}

/// Why.
const BECAUSE: &str = "engineering tolerance, or the one asked for; with what the reference may itself be off";

/// What a reference may be off, relative, to be judged by where the tolerance is smaller.
pub const KNOWN: f64 = 1e-2;

impl Bench<'_> {
    /// A number against what is known of it, relative to that, within the tolerance and its bar.
    pub fn near(&self, number: Quantity, value: f64, known: Known) -> Judged {
        let quantity = case::Quantity::on(&self.profile.scene, self.profile.contact, number);
        let factor = quantity.factor();
        let known = Known { reference: known.reference.times(factor), bar: factor * known.bar };
        let share = known.bar / known.reference.value.abs();
        let check = Check::near(quantity, known.reference.clone(), self.tolerance + share, BECAUSE);
        self.ruled(check, factor * value, known)
    }

    /// A number that follows from all pressures: by straight lines between those at points alone, by the sum where
    /// forces are known. Where this is farther from the truth than is allowed, and what is drawn between the points is
    /// not, it is that: an answer is judged, not a rule of integration. Forces that are known give the resultant and
    /// its moment, whatever lies between.
    pub fn read(
        &self,
        number: &Quantity,
        of: impl Fn(&Measures, &[PointState]) -> f64,
        truth: f64,
        allowed: f64,
    ) -> f64 {
        let Profile { scene, contact, between, points, has_forces, .. } = self.profile;
        let value = of(self.measures, points);
        let is_off = |value: &f64| (value - truth).abs() > allowed;
        let is_of_statics = matches!(number, Quantity::Resultant | Quantity::Centre);
        let is_told = between.is_empty() || *has_forces && is_of_statics;
        let drawn = || of(&Measures::of(scene, *contact, Part { points: between, edges: &[], nodes: 2 }), between);
        let drawn = (is_off(&value) && !is_told).then(drawn);
        drawn.filter(|drawn| !is_off(drawn)).unwrap_or(value)
    }

    /// The same against what is known of it, as [`Self::near`].
    pub fn read_near(&self, number: Quantity, of: impl Fn(&Measures) -> f64, known: Known) -> Judged {
        let allowed = self.tolerance * known.reference.value.abs() + known.bar;
        let value = self.read(&number, |measures, _| of(measures), known.reference.value, allowed);
        self.near(number, value, known)
    }

    /// The largest pressure of what was handed in \[MPa\]: two straight lines have no top between their points.
    pub fn peak_pressure(&self) -> f64 {
        match self.profile.alone.len() {
            1..=FEW => self.measures.largest.pressure,
            _ => self.measures.peak.pressure,
        }
    }

    /// The verdict; not run where the reference is not known well enough to judge by.
    pub fn ruled(&self, check: Check, value: f64, Known { reference, bar }: Known) -> Judged {
        let scale = if reference.value.abs() > 0.0 { reference.value.abs() } else { 1.0 };
        let name = reference.name.clone();
        let is_known = bar / scale <= KNOWN.max(self.tolerance);
        if !is_known {
            let kind = reference.kind;
            let why = format!("{name} is itself known to {} only", markdown::error(bar / scale));
            return Judged { value, ..check.not_run(kind, &name, why) };
        }
        let mut judged = check.judge_by(value, reference);
        judged.reference.uncertainty = Some(standard(bar));
        judged
    }

    /// What the contact is scaled by: the half-width of the truth \[mm, or rad\].
    pub fn half_width_known(&self) -> Known {
        self.truth.known(self.profile.contact, &Quantity::SecondMomentWidth)
    }

    /// Where the truth ends, from the middle \[mm, or rad\].
    pub fn reach(&self) -> f64 {
        let measures = &self.truth.run.contacts[self.profile.contact].measures;
        measures.edge().abs().max(measures.begin().abs())
    }

    /// The longest edge around the ends of what was handed in \[mm, or rad\].
    pub fn size_at_end(&self) -> f64 {
        self.longest(self.profile.edges.iter().map(|edge| edge.ends))
    }

    /// The same, of samples along a line the longest straight one of those within the contact, as far as edges of an
    /// answer go. It is an edge only where the truth bends along it: where that is as straight, points are as far apart
    /// as they say.
    pub fn size_of_lines(&self) -> f64 {
        let [begin, end] = [self.measures.begin(), self.measures.edge()];
        let lines = self.profile.lines.windows(2).map(|two| [two[0], two[1]]);
        let is_within = |[from, to]: &[f64; 2]| (begin..=end).contains(&(0.5 * (from + to)));
        let within = lines.filter(|line| is_within(line) && self.bends(*line));
        let most = WIDEST * self.half_width_known().reference.value;
        self.longest(within).min(most).max(self.size_at_end())
    }

    /// Whether the pressure of the truth departs from a straight line along a stretch, by more than it may itself be
    /// off.
    fn bends(&self, [from, to]: [f64; 2]) -> bool {
        let contact = self.profile.contact;
        let known = |share: f64| self.truth.pressure(contact, from + share * (to - from));
        let [first, last] = [0.0, 1.0].map(known);
        let bar = self.truth.of_profile(contact).bar;
        let peak = self.truth.known(contact, &Quantity::PeakPressure).reference.value;
        let is_straight = |part: usize| {
            let share = part as f64 / ALONG as f64;
            // A pressure without limit bends.
            (known(share) - (first + share * (last - first))).abs() <= (STRAIGHT + bar) * peak
        };
        !(1..ALONG).all(is_straight)
    }

    fn longest(&self, edges: impl Iterator<Item = [f64; 2]>) -> f64 {
        let ends = [self.measures.begin(), self.measures.edge()];
        let near = |[from, to]: [f64; 2]| {
            let length = to - from;
            ends.iter().any(|end| from - length <= *end && *end <= to + length).then_some(length)
        };
        edges.filter_map(near).fold(0.0, f64::max)
    }
}

/// Points up to which the largest pressure is that of one of them.
const FEW: usize = 4;
/// Edges of an answer that is sampled are no wider, over the half-width: four on it.
const WIDEST: f64 = 0.25;
/// Parts of a stretch between which it is seen whether the truth bends along it.
const ALONG: usize = 8;

/// Linear between places that rise, each with what is known there.
pub fn along(known: &[(f64, f64)], at: f64) -> f64 {
    let after = known.partition_point(|(place, _)| *place < at).clamp(1, known.len().max(2) - 1);
    let [Some((a, x)), Some((b, y))] = [known.get(after - 1), known.get(after)] else { return f64::NAN };
    x + (y - x) * (at - a) / (b - a)
}
