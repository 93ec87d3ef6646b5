//! A search goes on where it pays, and solves nothing twice.

use std::sync::LazyLock;

use contact_vv::accuracy::{self, Answer, Asked};
use contact_vv::case::library;
use contact_vv::mesh::Order;
use contact_vv::oracle::Quantity;
use contact_vv::solve::Formulation;
use contact_vv::study::promised::met::{Record, record};
use contact_vv::study::random::{Family, Sample, Site};

use crate::workbench::told;

const SITE: Site = Site { family: Family::Cosine, number: 90_001 };

/// Waves that take 34,300 dofs of 8-node cells, answered to 1e-4.
static ANSWERED: LazyLock<(Sample, Answer)> = LazyLock::new(|| {
    let sample = SITE.sample().expect("a scene");
    let answer = accuracy::solve(&sample.scene, &Formulation::verification(), &Asked::new(1e-4)).expect("solved");
    (sample, answer)
});

#[test]
fn order_that_does_not_halve_a_bar_once_is_followed_by_smaller_cells() {
    let (sample, answer) = &*ANSWERED;
    assert!(answer.unmet.is_none() && answer.resolution.order > Order::Quadratic, "{:?}", answer.unmet);
    assert!(answer.run.dofs <= 9_000, "{}", answer.run.dofs);
    let found = Record::of(&SITE, 1e-4, sample, answer);
    assert!(found.met && !found.is_falsely_met(), "{found:?}");
}

#[test]
fn ends_known_from_one_mesh_are_not_sought_on_coarse_ones_for_the_next() {
    let (_, answer) = &*ANSWERED;
    let orders = answer.tried.iter().skip_while(|tried| tried.purpose != "order");
    let (meshes, coarse): (Vec<_>, Vec<_>) = orders.partition(|tried| tried.order > Order::Quartic);
    assert!(meshes.len() > 1 && coarse.is_empty(), "{coarse:?}");
    // A mesh is one in the list, and one in the sum of dofs.
    let last = answer.tried.last().expect("solved");
    let alike = answer.tried.iter().filter(|tried| (tried.dofs, tried.order) == (last.dofs, last.order));
    assert_eq!(alike.count(), 1, "{:?}", answer.tried);
}

#[test]
fn wedge_whose_arc_goes_over_into_a_line_has_a_mesh_line_there() {
    // 8-node cells took 48,325 dofs, and cells of high order across the leap of the curvature do not converge.
    let site = Site { family: Family::Wedge, number: 90_002 };
    let sample = site.sample().expect("a scene");
    let answer = accuracy::solve(&sample.scene, &Formulation::verification(), &Asked::new(3e-4)).expect("solved");
    assert!(answer.resolution.order > Order::Quadratic && answer.scene.contact().leaps().len() == 1);
    let found = record(&site, 3e-4, &sample).expect("solved");
    assert!(found.met && !found.is_falsely_met() && found.dofs <= 8_000, "{found:?}");
}

#[test]
fn contacts_of_several_bodies_are_each_fitted() {
    // 8-node cells took 61,361 dofs in the middle of such scenes.
    let site = Site { family: Family::Pair, number: 90_002 };
    let sample = site.sample().expect("a scene");
    let found = record(&site, 1e-3, &sample).expect("solved");
    assert!(found.met && !found.is_falsely_met() && found.dofs <= 8_000, "{found:?}");
}

#[test]
fn mesh_that_judges_one_is_the_next_that_is_judged() {
    let sample = Site { family: Family::Polynomial, number: 90_016 }.sample().expect("a scene");
    let answer = accuracy::solve(&sample.scene, &Formulation::verification(), &Asked::new(1e-3)).expect("solved");
    let orders: Vec<_> = answer.tried.iter().filter(|tried| tried.purpose == "order").collect();
    assert!(orders.len() > 2 && orders.iter().all(|tried| tried.coarser == 0), "{orders:?}");
    // The last one judges the answer.
    assert_eq!(orders[orders.len() - 2].dofs, answer.run.dofs);
}

#[test]
fn sphere_that_a_cheap_mesh_takes_for_a_smaller_one_is_met_by_few_dofs() {
    let case = library::find("truncated-sphere", None).expect("known");
    for (asked, most) in [(1e-3, 900), (1e-5, 5_000)] {
        let answer = accuracy::solve(&case.scene, &Formulation::verification(), &Asked::new(asked)).expect("solved");
        assert!(answer.unmet.is_none() && answer.run.dofs <= most, "{asked}: {} {:?}", answer.run.dofs, answer.unmet);
        let found = [answer.run.measures().half_width(), answer.run.measures().peak.pressure];
        for (found, quantity) in found.into_iter().zip([&Quantity::HalfWidth, &Quantity::PeakPressure]) {
            let value = told(&case, quantity);
            assert!((found / value - 1.0).abs() <= asked, "{asked}, {quantity:?}: {found} for {value}");
        }
    }
}
