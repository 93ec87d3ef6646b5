//! What holds whatever the truth is: no penetration, pressure or gap but not both, and symmetry.

use crate::case::{Check, Judged, Reference};
use crate::measure::{Quantity, larger};
use crate::referee::bench::{Bench, along};
use crate::referee::norm;
use crate::referee::profile::Profile;
use crate::referee::truth::Truth;
use crate::solution::{EdgeState, PointState};

/// What penetration is told by.
pub const PENETRATION: &str = "largest penetration over the approach that the contact makes";
/// What gaps under pressure are told by.
const UNDER_PRESSURE: &str = "gap under pressure, weighted by force, over the approach that the contact makes";

/// Penetration, and gap where there is pressure, over the approach that the contact makes.
pub(super) fn of_gaps(bench: &Bench, missing: &mut Vec<[String; 2]>) -> Vec<Judged> {
    if !bench.profile.has_gaps {
        let what = "penetration, and pressure across an open gap".into();
        missing.push([what, "the remaining gap of every point: a column `gap [mm]`".into()]);
        return vec![];
    }
    let (approach, points) = (approach(bench.truth, bench.profile), &bench.profile.points);
    let force: f64 = points.iter().map(|point| point.weight * point.pressure.abs()).sum();
    let deepest = points.iter().map(|point| 0.0 - point.gap).fold(0.0, larger);
    let product = |gap: f64, pressure: f64| if pressure.abs() > 0.0 { (gap * pressure).abs() } else { 0.0 };
    let stored: f64 = points.iter().map(|point| point.weight * product(point.gap, point.pressure)).sum();
    let because = "the tolerance; a penetration of this part costs about as much of the pressure";
    let [overlap, closed] =
        ["bodies do not overlap", "pressure only where closed"].map(|name| Reference::own(name, 0.0));
    let mut judged = vec![
        Check::error(PENETRATION, overlap, bench.tolerance, because).judge(deepest / approach),
        Check::error(UNDER_PRESSURE, closed, bench.tolerance, because).judge(stored / (force * approach)),
    ];
    judged.extend(open_gaps(bench, approach, missing));
    judged
}

/// The approach that a contact makes by its own force \[mm\], `Σ A p/(E* t)`; around an axis of revolution that of a
/// flat punch of the contact radius, `Σ A p/(2E* a)`.
pub(super) fn approach(truth: &Truth, profile: &Profile) -> f64 {
    let (scene, pair) = (&profile.scene, profile.pair());
    let force: f64 = profile.points.iter().map(|point| point.weight * point.pressure.abs()).sum();
    let across = match scene.is_around_axis(profile.contact) {
        true => 2.0 * truth.known(profile.contact, &Quantity::SecondMomentWidth).reference.value,
        false => scene.depth(pair.path.point(0.0)),
    };
    force / (scene.modulus_of(pair) * across)
}

/// What gaps beyond the contact are told by.
const OPEN: &str = "error of the gaps beyond the contact, over them and the approach, in L2";

/// `√(Σ A (g − g_ref)² / Σ A max(g_ref, δ)²)` with the approach δ that the contact makes, over the points that are open
/// in our fine answer, within its candidates, between whose nodes its gap is linear; none where none is by more than
/// the tolerance of the approach. A gap of 0 there is passed over, and this is said: some codes write 0 where they do
/// not search.
fn open_gaps(bench: &Bench, approach: f64, missing: &mut Vec<[String; 2]>) -> Option<Judged> {
    let (contact, profile) = (bench.profile.contact, bench.profile);
    let is_half = !bench.truth.case.scene.contacts[contact].path.has_both_sides();
    let ours = bench.truth.run.solution.part(contact).points.iter();
    let ours: Vec<(f64, f64)> = ours.map(|point| (point.position, point.gap)).collect();
    let ends = [ours.first()?.0, ours.last()?.0];
    let open = |point: &PointState| {
        let s = if is_half { point.position.abs() } else { point.position };
        let is_told = ends[0] <= s && s <= ends[1] * (1.0 + SAME) && point.gap.is_finite();
        let gap = along(&ours, s);
        (is_told && gap > bench.tolerance * approach).then_some((point.weight, point.gap - gap, gap))
    };
    let (told, zeros): (Vec<&PointState>, Vec<_>) = profile.points.iter().partition(|point| point.gap.abs() > 0.0);
    // Middles between points that were handed in are none of these.
    let place = |point: &&PointState| profile.alone.binary_search_by(|[s, _]| s.total_cmp(&point.position)).is_ok();
    let zeros = zeros.into_iter().filter(|point| profile.alone.is_empty() || place(point)).filter_map(open).count();
    let sums = told.into_iter().filter_map(open).fold([0.0; 2], |[error, size], (weight, off, gap)| {
        [error + weight * off * off, size + weight * larger(gap, approach).powi(2)]
    });
    let reference = bench.truth.ours(contact, &Quantity::SecondMomentWidth).reference;
    let allowed = bench.tolerance + OPENS * bench.size_at_end() / bench.half_width_known().reference.value;
    let because = "the tolerance, and what the end of the contact leaves within an edge of this mesh";
    let [error, size] = sums;
    if zeros > 0 {
        let what = format!("gaps of 0 at {zeros} points beyond the contact, as of codes that do not search there");
        missing.push([what, "the gaps that remain there, `inf` where there is no other side".into()]);
    } else if size <= 0.0 {
        missing.push([OPEN.into(), "the remaining gap of points beyond the contact, `inf` where there is none".into()]);
    }
    let check = Check::error(OPEN, Reference { value: 0.0, ..reference }, allowed, because);
    (size > 0.0).then(|| check.judge((error / size).sqrt()))
}

/// Part of the edge length over the half-width that gaps may be off beyond the end: our own coarse meshes of both
/// orders take two thirds of it.
const OPENS: f64 = 0.6;
/// Part of the largest position that rounding explains.
const SAME: f64 = 1e-9;

/// Symmetry of a symmetric scene, and the moment about the middle, of answers that lie on both sides.
pub(super) fn of_sides(bench: &Bench, missing: &mut Vec<[String; 2]>) -> Vec<Judged> {
    let (contact, profile) = (bench.profile.contact, bench.profile);
    let own = &bench.truth.case.scene.contacts[contact];
    if profile.scene.is_around_axis(contact) {
        return vec![];
    }
    if !profile.across {
        let what = "symmetry and moment".into();
        missing.push([what, "both halves of the contact, with negative positions on the other one".into()]);
        return vec![];
    }
    let half_width = bench.half_width_known().reference.value;
    let symmetric = !own.path.has_both_sides();
    let (wanted, bar) = match symmetric {
        true => (0.0, 0.0),
        false => {
            let ours = bench.truth.ours(contact, &Quantity::Centre);
            (ours.reference.value, ours.bar)
        }
    };
    let named = if symmetric { "symmetry" } else { "our fine answer" };
    let allowed = bench.tolerance + bar / half_width;
    let centre = bench.read(&Quantity::Centre, |measures, _| measures.centre, wanted, allowed * half_width);
    let check = Check::error(
        "moment of the pressures about the middle, over force and half-width",
        Reference::own(named, 0.0),
        allowed,
        "the tolerance of the half-width",
    );
    let mut judged = vec![check.judge((centre - wanted).abs() / half_width)];
    if symmetric {
        let mirrored: Vec<EdgeState> = profile.edges.iter().rev().map(EdgeState::mirrored).collect();
        let odd = norm::of_means(&profile.edges, |s| mean_at(&mirrored, s));
        let because = "the tolerance, and half an edge at the end on either side";
        let allowed = bench.tolerance + bench.size_at_end() / half_width;
        let symmetry = Reference::own("symmetry", 0.0);
        judged.push(Check::error("difference of both halves, relative in L2", symmetry, allowed, because).judge(odd));
    }
    judged
}

/// The mean over the edge that holds a place; 0 where none does.
fn mean_at(edges: &[EdgeState], place: f64) -> f64 {
    let after = edges.partition_point(|edge| edge.ends[1] < place);
    edges.get(after).filter(|edge| edge.ends[0] <= place).map_or(0.0, |edge| edge.pressure)
}
