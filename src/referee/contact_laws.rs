//! What holds whatever the truth is: no penetration, pressure or gap but not both, and symmetry.

use crate::case::{Check, Judged, Reference};
use crate::measure::{Quantity, larger};
use crate::referee::bench::Bench;
use crate::referee::norm;
use crate::solution::EdgeState;

/// What penetration is told by.
pub const PENETRATION: &str = "largest penetration over the approach that the contact makes";

/// Penetration, and gap where there is pressure, over the approach that the contact's own force makes, `Σ A p/(E* t)`; around an axis of
/// revolution that of a flat punch of the contact radius, `Σ A p/(2E* a)`.
pub(super) fn of_gaps(bench: &Bench, missing: &mut Vec<[String; 2]>) -> Vec<Judged> {
    if !bench.profile.has_gaps {
        let what = "penetration, and pressure across an open gap".into();
        missing.push([what, "the remaining gap of every point: a column `gap [mm]`".into()]);
        return vec![];
    }
    let (scene, pair, points) = (&bench.profile.scene, bench.profile.pair(), &bench.profile.points);
    let force: f64 = points.iter().map(|point| point.weight * point.pressure.abs()).sum();
    let across = match scene.is_around_axis(bench.profile.contact) {
        true => 2.0 * bench.half_width_known().reference.value,
        false => scene.depth(pair.path.point(0.0)),
    };
    let approach = force / (scene.modulus_of(pair) * across);
    let deepest = points.iter().map(|point| 0.0 - point.gap).fold(0.0, larger);
    let product = |gap: f64, pressure: f64| if pressure.abs() > 0.0 { (gap * pressure).abs() } else { 0.0 };
    let stored: f64 = points.iter().map(|point| point.weight * product(point.gap, point.pressure)).sum();
    let because = "the tolerance; a penetration of this part costs about as much of the pressure";
    let zero = || Reference::own("bodies do not overlap", 0.0);
    vec![
        bench.error(PENETRATION, zero(), bench.tolerance, because, deepest / approach),
        bench.error(
            "gap under pressure, weighted by force, over the approach that the contact makes",
            Reference::own("pressure only where closed", 0.0),
            bench.tolerance,
            because,
            stored / (force * approach),
        ),
    ]
}

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
    let arm: f64 = profile.points.iter().map(|point| point.weight * point.pressure * point.position).sum();
    let force: f64 = profile.points.iter().map(|point| point.weight * point.pressure).sum();
    let symmetric = !own.path.has_both_sides();
    let (wanted, bar) = match symmetric {
        true => (0.0, 0.0),
        false => {
            let ours = bench.truth.ours(contact, &Quantity::Centre);
            (ours.reference.value, ours.bar)
        }
    };
    let named = if symmetric { "symmetry" } else { "our fine answer" };
    let check = Check::error(
        "moment of the pressures about the middle, over force and half-width",
        Reference::own(named, 0.0),
        bench.tolerance + bar / half_width,
        "the tolerance of the half-width",
    );
    let mut judged = vec![check.judge((arm / force - wanted).abs() / half_width)];
    if symmetric {
        let mirrored: Vec<EdgeState> = profile.edges.iter().rev().map(EdgeState::mirrored).collect();
        let odd = norm::of_means(&profile.edges, |s| mean_at(&mirrored, s));
        let because = "the tolerance, and half an edge at the end on either side";
        let allowed = bench.tolerance + bench.size_at_end() / half_width;
        judged.push(bench.error(
            "difference of both halves, relative in L2",
            Reference::own("symmetry", 0.0),
            allowed,
            because,
            odd,
        ));
    }
    judged
}

/// The mean over the edge that holds a place; 0 where none does.
fn mean_at(edges: &[EdgeState], place: f64) -> f64 {
    let after = edges.partition_point(|edge| edge.ends[1] < place);
    edges.get(after).filter(|edge| edge.ends[0] <= place).map_or(0.0, |edge| edge.pressure)
}
