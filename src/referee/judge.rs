//! An answer held against the truth of its case, quantity by quantity.

use crate::case::{self, Check, Judged, Reference, Verdict};
use crate::markdown::{self, significant};
use crate::measure::{ACTIVE, Measures, Quantity, display_factor, larger, peak};
use crate::referee::answer::places;
use crate::referee::bench::Bench;
use crate::referee::profile::Profile;
use crate::referee::truth::{Known, Truth};
use crate::referee::{contact_laws, declared, norm};
use crate::solution::{EdgeState, Part};
use crate::uncertainty::standard;

/// What is accepted where nothing else is asked for.
pub const ENGINEERING: f64 = 1e-2;
/// What tension is told by.
pub const TENSION: &str = "largest tension over the largest pressure";

/// Why points beside means over edges are not judged one by one: those of springs along an edge sway.
const MEANS: &str = "nothing: the means over edges beside them are judged";
/// What of answers whose points sway may still be right, and how it is handed in.
const SWAYING: [&str; 2] = [
    "the means over edges by themselves, as of springs along an edge, whose points sway on any mesh",
    "the means: `edges` of `schema answer`",
];
/// What alternating pressures are told by.
const ALTERNATION: &str = "alternation of the pressures from point to point over the peak";

/// What was found of one contact.
#[derive(Clone, Debug)]
pub struct Ruled {
    /// Index of the contact.
    pub contact: usize,
    /// Measures of what was handed in.
    pub measures: Measures,
    /// Every check with its verdict.
    pub judged: Vec<Judged>,
    /// What could not be judged, and what to hand in for it.
    pub missing: Vec<[String; 2]>,
}

/// Whether the half-width of a profile fails, which takes no fit of a peak and tells most answers that are wrong.
pub fn fails_by_width(truth: &Truth, profile: &Profile, tolerance: f64) -> bool {
    let measures = Measures::of(&profile.scene, profile.contact, Part { edges: &[], ..profile.part() });
    Bench { truth, profile, measures: &measures, tolerance }.half_width().verdict == Verdict::Fail
}

/// Judges a profile.
pub fn judge(truth: &Truth, profile: &Profile, tolerance: f64) -> Ruled {
    let measures = Measures::of(&profile.scene, profile.contact, profile.part());
    let bench = Bench { truth, profile, measures: &measures, tolerance };
    let mut missing = Vec::new();
    let mut judged = vec![bench.half_width()];
    judged.extend(bench.peak(&mut missing));
    judged.extend(bench.profile_norm(&mut missing));
    let alternation = bench.alternation();
    let swing = alternation.as_ref().map_or(0.0, |alternation| alternation.value);
    if alternation.as_ref().is_some_and(|alternation| alternation.verdict == Verdict::Fail) {
        missing.push(SWAYING.map(str::to_owned));
    } else if swing > tolerance {
        let [swing, asked] = [swing, tolerance].map(markdown::error);
        let what = format!("single points to {asked}: their pressures alternate by {swing} of the peak");
        missing.push([what, SWAYING[1].into()]);
    }
    judged.extend(alternation);
    judged.extend(bench.lone());
    judged.extend(bench.beside_ends(swing, &mut missing));
    if profile.has_means {
        missing.push(["pressures at single points".into(), MEANS.into()]);
    }
    judged.extend(bench.ends());
    judged.push(bench.resultant());
    judged.push(bench.tension());
    judged.extend(contact_laws::of_sides(&bench, &mut missing));
    judged.extend(contact_laws::of_gaps(&bench, &mut missing));
    judged.extend(declared::checks(&bench, &mut missing));
    Ruled { contact: profile.contact, judged, missing, measures }
}

impl Bench<'_> {
    fn half_width(&self) -> Judged {
        let number = Quantity::SecondMomentWidth;
        self.read_near(number, |measures| measures.second_moment_width, self.half_width_known())
    }

    /// The peak; where that has no limit the pressure at the middle.
    fn peak(&self, missing: &mut Vec<[String; 2]>) -> Option<Judged> {
        let contact = self.profile.contact;
        if !self.truth.is_unbounded(contact) {
            let known = self.truth.known(contact, &Quantity::PeakPressure);
            return Some(self.near(Quantity::PeakPressure, self.peak_pressure(), known));
        }
        missing.push(["peak pressure".into(), "nothing: it has no limit, and grows with every mesh".into()]);
        let at_origin = Quantity::Pressure { at: 0.0 };
        let reference = self.truth.closed(&at_origin)?;
        let bar = self.truth.model(&at_origin) * reference.value.abs();
        // Where the first point lies within an edge, its pressure holds up to the middle.
        let first = self.profile.edges.first().map_or(0.0, |edge| edge.ends[0].max(0.0));
        let value = peak::pressure_at(&self.profile.edges, first);
        Some(self.near(at_origin, value, Known { reference, bar }))
    }

    fn profile_norm(&self, missing: &mut Vec<[String; 2]>) -> Option<Judged> {
        let contact = self.profile.contact;
        let edges = match self.truth.is_unbounded(contact) {
            false => within(&self.profile.edges, COMPARED * self.reach()),
            true => {
                self.profile.edges.iter().filter(|edge| edge.ends.iter().all(|s| self.has_limit(*s))).copied().collect()
            }
        };
        if edges.is_empty() {
            missing.push([
                "error of the profile".into(),
                "edges within the contact, away from where the pressure has no limit".into(),
            ]);
            return None;
        }
        let error = norm::of_means(&edges, |s| self.truth.pressure(contact, s));
        let known = self.truth.of_profile(contact);
        let edge = if self.profile.scene.is_around_axis(contact) { OF_RINGS * EDGE } else { EDGE };
        let allowed = self.tolerance + edge * self.size_of_lines() / self.half_width_known().reference.value;
        let quantity = "error of the mean pressures over its edges, relative in L2";
        let because = "the tolerance, the bar of the reference, and what the end of the contact leaves within an edge \
            of this mesh";
        let check = Check::error(quantity, known.reference.clone(), allowed + known.bar, because);
        Some(self.ruled(check, error, known))
    }

    /// How far pressures alternate from point to point, which means over edges do not show.
    ///
    /// Largest `|e_i − (e_{i−1} + e_{i+1})/2| / 2` of the errors e of three points in a row well within the contact,
    /// over the peak; where the pressure has no limit, of errors over the pressure itself: up to the last points before
    /// an end where it has none. It is no more than the largest error among them.
    ///
    /// Allowed is [`ALTERNATE`] at 1 % and in proportion to a tolerance that is tighter: what fails has a point that is
    /// off by ten times that. Pressures at nodes of our own meshes of every order, from 8 edges on, alternate by less
    /// wherever all else is met; points of springs along an edge sway by 1 % to 10 %, on fine meshes too, as do nodes
    /// beside an end where the pressure has no limit, of which no more is asked than at 1 %.
    fn alternation(&self) -> Option<Judged> {
        let contact = self.profile.contact;
        let is_unbounded = self.truth.is_unbounded(contact);
        let is_at_ends = is_unbounded && self.truth.pressure(contact, 0.0).is_finite();
        let points: Vec<[f64; 2]> =
            self.profile.alone.iter().filter(|[s, _]| s.abs() < self.reach()).copied().collect();
        let far = if self.profile.across { AT_END } else { 0 }..points.len().saturating_sub(AT_END);
        let is_inside = |(k, [s, _]): &(usize, &[f64; 2])| self.has_limit(*s) || is_at_ends && far.contains(k);
        let inside = points.iter().enumerate().filter(is_inside).map(|(_, point)| point);
        let peak = self.truth.known(contact, &Quantity::PeakPressure).reference.value;
        let error = |&[s, p]: &[f64; 2]| {
            let known = self.truth.pressure(contact, s);
            (p - known) / if is_unbounded { known } else { peak }
        };
        let errors: Vec<[f64; 2]> = inside.map(|point| [point[0], error(point)]).collect();
        // A middle that is left out lies between no three points in a row.
        let is_row = |three: &&[[f64; 2]]| three[0][0] * three[2][0] > 0.0 || self.has_limit(0.0);
        let asked = self.by_tolerance(ALTERNATE) + self.truth.of_profile(contact).bar;
        let judged = |three: &[[f64; 2]]| {
            let has_limit = three.iter().all(|[s, _]| self.has_limit(*s));
            let allowed = if has_limit { asked.min(ALTERNATE) } else { ALTERNATE };
            (0.5 * (three[1][1] - 0.5 * (three[0][1] + three[2][1])).abs(), allowed)
        };
        let rows = errors.windows(3).filter(is_row).map(judged);
        let (largest, allowed) = rows.max_by(|(a, of), (b, most)| (a / of).total_cmp(&(b / most)))?;
        let because = "what an answer may alternate by that is quoted at its points";
        let check = Check::error(ALTERNATION, Reference::own("neighbouring points", 0.0), allowed, because);
        Some(check.judge(largest))
    }

    /// What is allowed at 1 %, in proportion to a tolerance that is tighter.
    fn by_tolerance(&self, allowed: f64) -> f64 {
        allowed * (self.tolerance / ENGINEERING).min(1.0)
    }

    /// The few points in a row whose pressures depart most from the truth while those of two on either side do not,
    /// where one is off by more than is allowed: the peak that is fitted passes them by, and of many points the norm.
    /// Not the last ones before an end, nor where the truth bends as much from point to point.
    fn lone(&self) -> Option<Judged> {
        let contact = self.profile.contact;
        let peak = self.truth.known(contact, &Quantity::PeakPressure).reference.value;
        let known = |&[s, p]: &[f64; 2]| [s, p, self.truth.pressure(contact, s)];
        let is_inside = |[s, _]: &&[f64; 2]| s.abs() < self.reach();
        let mut points: Vec<[f64; 3]> = self.profile.alone.iter().filter(is_inside).map(known).collect();
        points.truncate(points.len().saturating_sub(AT_END));
        points.drain(..if self.profile.across { AT_END.min(points.len()) } else { 0 });
        let is_half = !self.profile.across && !self.profile.pair().path.has_both_sides();
        if is_half {
            let behind = points.iter().filter(|[s, ..]| *s > 0.0).take(GROUP + 2);
            let mirrored: Vec<[f64; 3]> = behind.map(|[s, p, wanted]| [-s, *p, *wanted]).collect();
            points.splice(0..0, mirrored.into_iter().rev());
        }
        let is_unbounded = self.truth.is_unbounded(contact);
        let error = |[_, p, wanted]: &[f64; 3]| (p - wanted).abs() / if is_unbounded { *wanted } else { peak };
        let bend = |three: &[[f64; 3]]| {
            (three[1][2] - 0.5 * (three[0][2] + three[2][2])).abs() / if is_unbounded { three[1][2] } else { peak }
        };
        let off = |row: &[[f64; 3]]| {
            let own = &row[2..row.len() - 2];
            let count = own.iter().filter(|[s, ..]| !is_half || *s >= 0.0).count();
            if !(1..=GROUP).contains(&count) {
                return None;
            }
            let worst = own.iter().max_by(|a, b| error(a).total_cmp(&error(b)))?;
            let beside = row[..2].iter().chain(&row[row.len() - 2..]).map(error);
            let beside = beside.chain(row[1..row.len() - 1].windows(3).map(bend)).fold(0.0, larger);
            (LONE * beside..f64::INFINITY).contains(&error(worst)).then_some((error(worst), *worst, count))
        };
        // Of mirrored points the last are those that were handed in; of rows with the same one the shortest tells.
        let rows = (1..=if is_half { 2 * GROUP } else { GROUP })
            .flat_map(|count| points.windows(count + 4).rev())
            .filter_map(off);
        let (error, [s, p, wanted], count) = rows.reduce(|most, next| if next.0 > most.0 { next } else { most })?;
        let known = self.truth.of_profile(contact);
        let (place, [p, wanted]) = (places(self.profile.pair(), &[s]), [p, wanted].map(|one| significant(one, 4)));
        let who = if count == 1 { "one point alone".to_owned() } else { format!("{count} points in a row, most") };
        let quantity = format!("departure of {who}, at {place}: {p} for {wanted} MPa, over the peak");
        let because = "the tolerance, the bar of the reference, and what one point of an answer may be off";
        let allowed = self.tolerance + self.by_tolerance(SPIKE) + known.bar;
        let check = Check::error(case::Quantity::at(quantity, ""), known.reference.clone(), allowed, because);
        Some(self.ruled(check, error, known)).filter(|judged| judged.verdict == Verdict::Fail)
    }

    /// The worst of the last points before an end, which [`Self::lone`] passes by, where its pressure is none that the
    /// truth has within a quarter of an edge of there, by more than one point may be off and those within the contact
    /// swing, which is judged there. Where the pressure has no limit they are not judged.
    fn beside_ends(&self, swing: f64, missing: &mut Vec<[String; 2]>) -> Option<Judged> {
        let Profile { contact, alone, across, order, lines, .. } = self.profile;
        // Pressures alone have middles of straight lines between them.
        let (nodes, reach) = (if lines.is_empty() { usize::from(order.number()) } else { 1 }, self.reach());
        if self.truth.is_unbounded(*contact) && !alone.is_empty() {
            let what = format!("pressures of the last {} points before an end", AT_END + 2);
            missing.push([what, "nothing: a pressure without a limit differs from mesh to mesh".into()]);
            return None;
        }
        let peak = self.truth.known(*contact, &Quantity::PeakPressure).reference.value;
        // Our own mesh may end before the truth does, where that comes to nothing.
        let is_low = |s: f64| (f64::MIN_POSITIVE..0.5 * peak).contains(&self.truth.pressure(*contact, s));
        let within = || (0..alone.len()).filter(|&k| alone[k][0].abs() < reach || is_low(alone[k][0]));
        let last = within().rev().take(AT_END + 2);
        let first = within().take(if *across { AT_END + 2 } else { 0 });
        let off = |k: usize| {
            let [s, p] = alone[k];
            let beside = |other: Option<usize>| other.and_then(|other| alone.get(other)).map(|[other, _]| other - s);
            let [before, behind] = [k.checked_sub(nodes), Some(k + nodes)].map(beside);
            let [from, to] = [before.or(behind.map(|length| -length))?, behind.or(before.map(|length| -length))?];
            let parts = (0..=PARTS).map(|part| s + QUARTER * (from + (to - from) * part as f64 / PARTS as f64));
            let end = reach.max(s.abs());
            let truth = parts.chain([s]).map(|place| self.truth.pressure(*contact, place.clamp(-end, end)));
            let [low, high] = truth.fold([f64::INFINITY, 0.0], |[low, high], p| [p.min(low), p.max(high)]);
            Some(([low - p, p - high].into_iter().fold(0.0, larger) / peak, [s, p, low, high]))
        };
        let (error, [s, p, low, high]) =
            last.chain(first).filter_map(off).reduce(|most, next| if next.0 > most.0 { next } else { most })?;
        let known = self.truth.of_profile(*contact);
        let (place, [p, low, high]) =
            (places(self.profile.pair(), &[s]), [p, low, high].map(|one| significant(one, 4)));
        let quantity = format!(
            "pressure beside an end, at {place}: {p}, where the truth has {low} to {high} MPa within a quarter of an \
            edge, over the peak"
        );
        let because = "the tolerance, the bar of the reference, and what one point of an answer may be off";
        // Corners of 8-node cells have a third of an edge.
        let allowed = self.tolerance + SPIKE * nodes as f64 + swing + known.bar;
        let check = Check::error(case::Quantity::at(quantity, ""), known.reference.clone(), allowed, because);
        Some(self.ruled(check, error, known)).filter(|judged| judged.verdict == Verdict::Fail)
    }

    /// Whether a place lies well within the contact, and not where the pressure has no limit: at its ends, or at s = 0
    /// under a cone.
    fn has_limit(&self, s: f64) -> bool {
        let contact = self.profile.contact;
        let ends = &self.truth.run.contacts[contact].measures;
        let (middle, reach) = (0.5 * (ends.begin() + ends.edge()), 0.5 * (ends.edge() - ends.begin()));
        let is_beside = || s.abs() < BESIDE * reach && !self.truth.pressure(contact, 0.0).is_finite();
        (s - middle).abs() <= INSIDE * reach && !is_beside()
    }

    /// Where the contact begins and ends, to within one edge of the mesh that was handed in.
    fn ends(&self) -> Vec<Judged> {
        let contact = self.profile.contact;
        let ours = &self.truth.run.contacts[contact].measures;
        let Some(last) = ours.stretches.len().checked_sub(1) else { return vec![] };
        let symmetric = !self.truth.case.scene.contacts[contact].path.has_both_sides();
        let end = match self.truth.ours(contact, &Quantity::End(last)) {
            ours if ours.reference.value.is_nan() => return vec![],
            ours if symmetric && ours.bar.is_finite() => self.truth.known(contact, &Quantity::End(last)),
            ours => ours,
        };
        let begin = match (symmetric, ours.stretches[0].begin > 0.0) {
            (true, true) => Some(self.truth.ours(contact, &Quantity::Begin(0))),
            (true, false) if self.profile.across => {
                Some(Known { reference: end.reference.clone().times(-1.0), bar: end.bar })
            }
            (true, false) => None,
            (false, _) => Some(self.truth.ours(contact, &Quantity::Begin(0))),
        };
        let found =
            [self.measures.stretches.first().map(|one| one.begin), self.measures.stretches.last().map(|one| one.end)];
        let both = [begin, Some(end)].into_iter().zip(found).zip(["begin", "end"]);
        both.filter_map(|((known, found), name)| Some(self.end(name, found.unwrap_or(f64::NAN), known?))).collect()
    }

    fn end(&self, name: &str, value: f64, known: Known) -> Judged {
        let path = &self.profile.pair().path;
        let (factor, unit) = if path.is_straight() { (1.0, "mm") } else { (display_factor(path), "°") };
        let size = self.half_width_known().reference.value;
        let allowed = factor * (self.tolerance * size + self.size_of_lines() + known.bar);
        let reference = known.reference.clone().times(factor);
        let because = "the tolerance of the half-width, the bar of the reference, and one edge of this mesh";
        let quantity = case::Quantity::at(format!("{name} of the contact [{unit}]"), "");
        let check = Check::absolute(quantity, reference.clone(), allowed, because);
        // How well it is known on the scale of the half-width.
        let scale = if reference.value.abs() > 0.0 { reference.value.abs() } else { 1.0 };
        let bar = known.bar / size * scale;
        let mut judged = self.ruled(check, factor * value, Known { reference, bar });
        judged.reference.uncertainty = Some(standard(factor * known.bar));
        judged
    }

    fn resultant(&self) -> Judged {
        let contact = self.profile.contact;
        let known = if self.truth.is_told_by_loads(contact) {
            let ours = self.truth.ours(contact, &Quantity::Resultant);
            let transmitted = self.truth.run.contacts[contact].transmitted;
            let reference = Reference::own("equilibrium with the load", transmitted);
            Known { reference, bar: if ours.bar.is_finite() { ours.bar } else { 0.0 } }
        } else {
            self.truth.known(contact, &Quantity::Resultant)
        };
        self.read_near(Quantity::Resultant, |measures| measures.resultant, known)
    }

    fn tension(&self) -> Judged {
        let lowest = self.profile.points.iter().map(|point| 0.0 - point.pressure).fold(0.0, larger);
        let highest = self.profile.points.iter().map(|point| point.pressure.abs()).fold(0.0, larger);
        let because = "what counts as no pressure everywhere here";
        Check::error(TENSION, Reference::own("contact cannot pull", 0.0), ACTIVE, because).judge(lowest / highest)
    }
}

/// Part of the contact, from its middle on, in which pressures must not alternate, and by how much of the peak.
const INSIDE: f64 = 0.8;
/// Part beside the middle in which they may, where the pressure has no limit.
const BESIDE: f64 = 0.2;
/// Points at an end where the pressure has no limit in which they may.
const AT_END: usize = 3;
/// Part of an edge to either side within which right answers have the pressures of the truth beside an end, on meshes
/// of 6 edges or more, and parts of both at whose ends it is read.
const QUARTER: f64 = 0.25;
const PARTS: usize = 8;
const ALTERNATE: f64 = 0.1;
/// What one point may be off over the peak at 1 %, and times what those beside it are off from which on it is alone in
/// that.
const SPIKE: f64 = 0.05;
const LONE: f64 = 4.0;
/// Points in a row that may be off while those beside them are not.
const GROUP: usize = 4;
/// Half-widths over which profiles are compared.
const COMPARED: f64 = 1.5;
/// Part of the edge length over the half-width that the profile may be off: our own coarse meshes of both orders stay
/// within it.
const EDGE: f64 = 0.3;

/// Times that around an axis of revolution, whose outer rings weigh more.
const OF_RINGS: f64 = 1.5;

/// The edges within a reach.
fn within(edges: &[EdgeState], reach: f64) -> Vec<EdgeState> {
    edges.iter().filter(|edge| edge.position().abs() <= reach).copied().collect()
}
