//! Limits of the reference: Hertz's parabola on a half-space.

use super::{
    Limit, bracket, hertz_errors, largest, meshed, percent, range, refusal, said, seen, size, table, verified, worse,
};
use crate::case::library::Cylinder;
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::study::unsorted::Finding;

const RATIOS: [f64; 7] = [0.005, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5];
/// Difference to Hertz that counts as its failure.
const FAILS: f64 = 0.01;

/// Contacts of up to half the radius: the difference to Hertz grows, the change by refinement does not.
pub(super) fn large_contact() -> Result<Finding, Error> {
    let (mut rows, mut differences, mut changes) = (Vec::new(), Vec::new(), Vec::new());
    let mut last = String::new();
    for a_over_r in RATIOS {
        let errors = |elements| -> Result<([f64; 2], String), Error> {
            let discretisation =
                meshed(Cylinder { a_over_r, ..Default::default() }.scene(), elements, Order::Quadratic)?;
            let run = verified(&discretisation)?;
            Ok((hertz_errors(&discretisation.scene, &run), seen(&Ok(run))))
        };
        let ((coarse, _), (fine, outcome)) = (errors(12)?, errors(24)?);
        let change = [0, 1].map(|k| fine[k] - coarse[k]);
        rows.push([vec![a_over_r.to_string()], fine.iter().chain(&change).map(|x| percent(*x)).collect()].concat());
        differences.push(worse(fine[0], fine[1]));
        changes.push(worse(change[0], change[1]));
        last = outcome;
    }
    let worst = largest(&changes);
    let large = RATIOS.iter().position(|ratio| *ratio > 0.15).unwrap_or(0);
    let share = differences[large..].iter().zip(&changes[large..]).map(|(d, c)| d / c).fold(f64::INFINITY, f64::min);
    let checks = vec![
        Judged::norm(
            "The solution shall be settled whatever a/R",
            "largest change of p₀ and a from 12 to 24 elements per half-width",
            worst,
            Reference::own("twice as fine", 0.0),
            1e-3,
            "a tenth of the difference that is blamed on the reference",
        ),
        Judged::at_least(
            "Where the contact is large it shall be the reference that fails, not the mesh",
            "difference to Hertz over change by refinement, a/R ≥ 0.2",
            share,
            Reference::own("ten times", 10.0),
            "parabola for circle, half-space for cylinder: of the order of (a/R)²",
        ),
        Judged::norm(
            "Where the contact is small Hertz shall hold",
            "difference to Hertz, a/R = 0.005",
            differences[0],
            Reference::analytic("Hertz", 0.0),
            1e-3,
            "(a/R)² is 2.5e-5; 24 8-node cells per half-width",
        ),
    ];
    let beyond = refusal(problem::problem("cylinder", Some(0.6)), "a contact of more than half the radius")?;
    let limit = Limit {
        pushed: "a/R of the cylinder: Hertz's own limit",
        range: range(&RATIOS, "a/R"),
        onset: format!(
            "Hertz is off by {} {}; refinement changes nothing beyond {}",
            size(FAILS),
            bracket(&RATIOS, |i| differences[i] > FAILS, "a/R").0,
            size(worst)
        ),
        seen: format!("{last}; beyond, {}", said(&beyond).0),
        instead: "trust the solution, not Hertz; verify at a/R ≤ 0.05".into(),
    };
    let head = ["a/R", "p₀ against Hertz", "a against Hertz", "p₀, change by refinement", "a, change by refinement"];
    Ok(limit.finding(vec![table("Cylinder: what fails at large a/R", &head, rows)], checks))
}
