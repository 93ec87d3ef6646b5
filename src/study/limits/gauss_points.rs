//! Limit of quadrature: more conditions on an edge than its displacements can meet.

use serde::Serialize;

use crate::algorithm::StiffnessRule;
use crate::case::library::{Cylinder, PinRod};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::contact::Quadrature;
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::solve::run::{INSIDE, Run};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::{exceeds, largest, meshed};
use crate::study::limits::written::{bracket, number, percent, range, size};

/// Stiffnesses of the springs.
const STIFFNESSES: [f64; 6] = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
/// Points on an edge.
const RULES: [(&str, Quadrature); 3] =
    [("3-point Gauss", Quadrature::GaussFull), ("2-point Gauss", Quadrature::Gauss), ("Lobatto", Quadrature::Lobatto)];
/// Departure over the peak that counts as oscillation.
const VISIBLE: f64 = 0.05;
/// Indices of the two hardest springs.
const HARDEST: [usize; 2] = [4, 5];

/// Pressures of stiff line elements with three, two and Lobatto points on their quadratic edges.
#[derive(Clone, Debug, Serialize)]
pub struct ThreeGaussPoints {
    /// On the pin–rod, by stiffness.
    pub pin_rod: Vec<[Departure; 3]>,
    /// On the cylinder.
    pub cylinder: Vec<[Departure; 3]>,
}

/// A run and how rough its pressure is.
#[derive(Clone, Debug, Serialize)]
pub struct Departure {
    /// Largest departure of a pressure from its neighbours' line inside the contact, over the peak.
    pub size: f64,
    /// How the run ended.
    pub seen: Seen,
}

/// Both scenes.
pub(super) fn run() -> Result<ThreeGaussPoints, Error> {
    Ok(ThreeGaussPoints {
        pin_rod: departures(&meshed(PinRod::default().scene(), 8, Order::Quadratic)?)?,
        cylinder: departures(&meshed(Cylinder::default().scene(), 8, Order::Quadratic)?)?,
    })
}

fn departures(discretisation: &Discretisation) -> Result<Vec<[Departure; 3]>, Error> {
    let base = Formulation { rule: StiffnessRule::Penalty, ..Formulation::new(Element::Line, Iteration::Kinematic) };
    let at = |stiffness: f64| {
        let [three, two, nodes] = RULES.map(|(_, quadrature)| {
            let run = Run::of(discretisation, &Formulation { stiffness, quadrature, ..base.clone() })?;
            Ok::<_, Error>(Departure { size: departure(&run), seen: Seen::of(&Ok(run)) })
        });
        Ok([three?, two?, nodes?])
    };
    STIFFNESSES.into_iter().map(at).collect()
}

fn departure(run: &Run) -> f64 {
    profile::oscillation(&run.solution.points, INSIDE * run.measures().edge()) / run.measures().peak.pressure
}

impl Departure {
    fn cell(&self) -> String {
        if self.seen.is(Outcome::Converged) { percent(self.size) } else { self.seen.to_string() }
    }
}

impl ThreeGaussPoints {
    pub(super) fn judge(&self) -> Vec<Judged> {
        let [[three, two, _], [_, harder, _]] = HARDEST.map(|i| self.pin_rod[i].each_ref().map(|found| found.size));
        let at_nodes = self.pin_rod.iter().chain(&self.cylinder).map(|[_, _, nodes]| nodes.size);
        let visible = || Reference::own("visible", VISIBLE);
        vec![
            Check::at_least(
                Quantity::at("departure over the peak at three Gauss points", "pin–rod, κ = 1e5"),
                visible(),
                "three conditions on an edge that adds two displacements: a finding, locked",
            )
            .judge(three),
            Check::near(
                Quantity::at("departure over the peak at two Gauss points", "pin–rod, κ = 1e6"),
                Reference::own("that at κ = 1e5", two),
                0.1,
                "their alternating mode does no work on the inner nodes, so stiffness does not feed it",
            )
            .judge(harder),
            Check::at_most(
                Quantity::at("departure over the peak at Lobatto points", "both scenes, every κ"),
                visible(),
                "Lobatto points are the nodes: one condition for each displacement",
            )
            .judge(largest(at_nodes)),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let [before, last] = HARDEST;
        let onset = bracket(&STIFFNESSES, |i| exceeds(self.pin_rod[i][0].size, VISIBLE), "κ");
        Limit {
            pushed: "3-point Gauss on stiff quadratic line elements",
            range: range(&STIFFNESSES, "κ"),
            onset: format!(
                "departure of {} {onset} on the pin–rod; 2-point Gauss reaches {} there and {} on the cylinder",
                size(VISIBLE),
                size(self.pin_rod[last][1].size),
                size(self.cylinder[last][1].size)
            ),
            seen: format!("κ = 1e5: {}; κ = 1e6: {}", self.pin_rod[before][0].seen, self.pin_rod[last][0].seen),
            instead: "Lobatto points, or node elements; with Gauss points quote means over edges".into(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let scenes = ["pin–rod", "cylinder"];
        let columns = scenes.into_iter().flat_map(|scene| RULES.map(|(rule, _)| format!("{scene}, {rule}")));
        let head: Vec<String> = std::iter::once("κ".into()).chain(columns).collect();
        let row = |(i, stiffness): (usize, f64)| {
            let both = self.pin_rod[i].iter().chain(&self.cylinder[i]);
            std::iter::once(number(stiffness)).chain(both.map(Departure::cell)).collect()
        };
        Some(Detail {
            title: "Line element on 8-node cells, springs fixed at κ: largest departure of a pressure from the line through its neighbours, over the peak",
            head,
            rows: STIFFNESSES.into_iter().enumerate().map(row).collect(),
        })
    }
}
