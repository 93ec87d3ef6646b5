//! Limits of quadrature: more conditions on an edge than its displacements can meet.

use super::{Limit, bracket, largest, meshed, number, percent, range, seen, size};
use crate::algorithm::StiffnessRule;
use crate::case::library::{Cylinder, PinRod};
use crate::case::{Judged, Reference};
use crate::contact::Quadrature;
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::Order;
use crate::solve::run::{INSIDE, Run};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::{Finding, Table};

/// Points on an edge.
const RULES: [(&str, Quadrature); 3] =
    [("3-point Gauss", Quadrature::GaussFull), ("2-point Gauss", Quadrature::Gauss), ("Lobatto", Quadrature::Lobatto)];
/// Departure over the peak that counts as oscillation.
const VISIBLE: f64 = 0.05;

/// Pressure of stiff line elements against the number of points on their quadratic edges.
pub(super) fn three_gauss_points() -> Result<Finding, Error> {
    let kappas = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    let discretisation = meshed(PinRod::default().scene(), 8, Order::Quadratic)?;
    let pins = departures(&discretisation, &kappas)?;
    let plane = departures(&meshed(Cylinder::default().scene(), 8, Order::Quadratic)?, &kappas)?;
    let [of_three, of_two, of_nodes] =
        [0, 1, 2].map(|rule| pins.iter().map(move |row| row[rule].0).collect::<Vec<_>>());
    let (onset, _) = bracket(&kappas, |i| of_three[i] > VISIBLE, "κ");
    let checks = vec![
        Judged::at_least(
            "Three Gauss points on a quadratic edge shall be seen to make the pressure oscillate",
            "departure over peak, κ = 1e5",
            of_three[4],
            Reference::own("visible", VISIBLE),
            "three conditions on an edge that adds two displacements: a finding, locked",
        ),
        Judged::relative(
            "The oscillation of two Gauss points shall level off as springs harden",
            "departure over peak, κ = 1e6",
            of_two[5],
            Reference::own("κ = 1e5", of_two[4]),
            0.1,
            "their alternating mode does no work on the inner nodes, so stiffness does not feed it",
        ),
        Judged::at_most(
            "Pressures at Lobatto points shall not oscillate however stiff the springs are",
            "largest departure over peak, both scenes",
            largest(&of_nodes.into_iter().chain(plane.iter().map(|row| row[2].0)).collect::<Vec<_>>()),
            Reference::own("visible", VISIBLE),
            "Lobatto points are the nodes: one condition for each displacement",
        ),
    ];
    let cells =
        |found: &(f64, String)| if found.1.starts_with("converged") { percent(found.0) } else { found.1.clone() };
    let row = |(i, kappa): (usize, &f64)| {
        std::iter::once(number(*kappa)).chain(pins[i].iter().chain(&plane[i]).map(cells)).collect()
    };
    let scenes =
        ["pin–rod", "cylinder"].into_iter().flat_map(|scene| RULES.map(|(rule, _)| format!("{scene}, {rule}")));
    let head: Vec<String> = std::iter::once("κ".into()).chain(scenes).collect();
    let rows = kappas.iter().enumerate().map(row).collect();
    let title = "Line element on 8-node cells, springs fixed at κ: largest departure of a pressure from the line through its neighbours, over the peak";
    let limit = Limit {
        pushed: "3-point Gauss on stiff quadratic line elements",
        range: range(&kappas, "κ"),
        onset: format!(
            "departure of {} {onset} on the pin–rod; 2-point Gauss levels off at {} there and {} on the cylinder",
            size(VISIBLE),
            size(of_two[5]),
            size(plane[5][1].0)
        ),
        seen: format!("κ = 1e5: {}; κ = 1e6: {}", pins[4][0].1, pins[5][0].1),
        instead: "Lobatto points, or node elements; with Gauss points quote means over edges".into(),
    };
    Ok(limit.finding(vec![Table { title: title.into(), head, rows }], checks))
}

/// Departure and what the user sees of each rule at each stiffness.
fn departures(discretisation: &Discretisation, kappas: &[f64]) -> Result<Vec<[(f64, String); 3]>, Error> {
    let base = Formulation { rule: StiffnessRule::Penalty, ..Formulation::new(Element::Line, Iteration::Kinematic) };
    let mut rows = Vec::new();
    for &stiffness in kappas {
        let mut row: [(f64, String); 3] = Default::default();
        for (slot, (_, quadrature)) in row.iter_mut().zip(RULES) {
            let run = Run::of(discretisation, &Formulation { stiffness, quadrature, ..base.clone() })?;
            *slot = (departure(&run), seen(&Ok(run)));
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Largest departure of a pressure from its neighbours' line inside the contact, over the peak.
fn departure(run: &Run) -> f64 {
    profile::oscillation(&run.solution.points, INSIDE * run.measures().edge()) / run.measures().peak.pressure
}
