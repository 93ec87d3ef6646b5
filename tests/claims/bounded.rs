//! A search is bounded by `--max-dofs`, and tells of every mesh before it is solved.

use std::sync::Mutex;

use contact_vv::accuracy::{self, Answer, Asked, Next};
use contact_vv::case::library::{self, TruncatedHertz};
use contact_vv::error::Kind;
use contact_vv::scene::Scene;
use contact_vv::solve::{Element, Formulation, Iteration};
use contact_vv::study::random::{Family, Site};

use crate::accuracy::error;
use crate::outputs::{contact_vv, json};
use crate::program::Folder;
use crate::workbench::kinematic;

/// The answer to an accuracy with so many dofs at most, and the dofs of all meshes that were told of.
fn bounded(scene: &Scene, formulation: &Formulation, relative: f64, most: usize) -> (Answer, Vec<usize>) {
    let told = Mutex::new(Vec::new());
    let tell = |next: &Next| told.lock().expect("nobody panicked").push(next.dofs);
    let asked = Asked { most_dofs: Some(most), ..Asked::new(relative) };
    let answer = accuracy::solve_telling(scene, formulation, &asked, &tell).expect("solved");
    (answer, told.into_inner().expect("nobody panicked"))
}

#[test]
fn search_solves_no_mesh_of_more_dofs_than_are_allowed_and_says_what_is_met_until_then() {
    let hertz = TruncatedHertz::default().case();
    let pair = Site { family: Family::Pair, number: 90_003 }.sample().expect("a scene").scene;
    let press_fit = library::find("press-fit", None).expect("known").scene;
    let [node, line] = [Element::Node, Element::Line].map(|element| Formulation::new(element, Iteration::Kinematic));
    let varying = Formulation::new(Element::Node, Iteration::Varying);
    for (name, scene, formulation, relative, most) in [
        ("truncated Hertz", &hertz.scene, &node, 1e-6, 1_500),
        ("line elements", &hertz.scene, &line, 1e-5, 5_000),
        ("varying stiffness", &hertz.scene, &varying, 1e-5, 1_500),
        ("two contacts", &pair, &node, 1e-4, 9_000),
        ("press fit", &press_fit, &node, 1e-6, 700),
    ] {
        let (answer, told) = bounded(scene, formulation, relative, most);
        let next = answer.next.unwrap_or_else(|| panic!("{name}: {:?}", answer.unmet));
        let why = answer.unmet.clone().unwrap_or_default();
        assert!(next > most && why.contains(&format!("{next} dofs, more than the {most} allowed")), "{name}: {why}");
        let met = why.split("until then ").nth(1).and_then(|rest| rest.strip_suffix(" % is met"));
        let over = met.expect("a percentage").parse::<f64>().expect("a number") / (100.0 * answer.estimate());
        assert!((1.0..1.1).contains(&over), "{name}: {why}, {over}");
        assert!(told.iter().chain([&answer.run.dofs]).all(|dofs| *dofs <= most), "{name}: {told:?}");
        let untold = answer.tried.iter().filter(|tried| tried.dofs > 0 && !told.contains(&tried.dofs));
        assert_eq!(untold.count(), 0, "{name}");
        // What is met until then is so.
        let truth = accuracy::Quantity::ASKED.map(|quantity| hertz.reading(0, &quantity).value);
        let is_so = || error(&answer.run, truth) <= answer.estimate();
        assert!(name != "truncated Hertz" || is_so(), "{name}: {:e}", answer.estimate());
    }
}

#[test]
fn bound_that_is_not_reached_changes_nothing() {
    let hertz = TruncatedHertz::default().case().scene;
    let node = kinematic();
    let free = accuracy::solve(&hertz, &node, &Asked::new(1e-3)).expect("solved");
    let (bounded, told) = bounded(&hertz, &node, 1e-3, 1_000_000);
    assert!(bounded.next.is_none() && bounded.unmet.is_none());
    assert_eq!((bounded.run.dofs, bounded.dofs_in_all()), (free.run.dofs, free.dofs_in_all()));
    // One dof less than the largest mesh, and it is.
    let largest = told.into_iter().max().expect("told");
    let (short, told) = self::bounded(&hertz, &node, 1e-3, largest - 1);
    assert!(told.iter().all(|dofs| *dofs < largest));
    // It is that of the error bars, which have only coarser ones then.
    let of_bars = |answer: &Answer| {
        let alike = answer.tried.iter().filter(|tried| tried.dofs == free.run.dofs);
        alike.map(|tried| tried.coarser).max()
    };
    assert_eq!(free.tried.last().map(|tried| tried.dofs), Some(largest), "{:?}", free.tried);
    assert_eq!(of_bars(&free), Some(0), "{:?}", free.tried);
    assert!(of_bars(&short).is_some_and(|dofs| 0 < dofs && dofs < largest), "{:?}", short.tried);
}

#[test]
fn first_mesh_above_the_dofs_allowed_is_refused() {
    let hertz = TruncatedHertz::default().case().scene;
    let asked = Asked { most_dofs: Some(10), ..Asked::new(1e-2) };
    let formulation = kinematic();
    let refused = accuracy::solve(&hertz, &formulation, &asked).expect_err("too few");
    assert!(matches!(refused.kind, Kind::TooManyDofs { dofs } if dofs > 10), "{refused:?}");
    assert!(refused.message.contains("more than the 10 allowed"), "{}", refused.message);
}

#[test]
fn meshes_above_200_000_dofs_or_ten_seconds_are_long() {
    let next = |dofs, seconds| Next { dofs, seconds, estimate: f64::NAN, asked: 1e-3 };
    assert!(next(200_001, f64::NAN).is_long() && next(1_000, 10.1).is_long());
    assert!(!next(200_000, f64::NAN).is_long() && !next(199_999, 9.9).is_long());
}

#[test]
fn bound_is_an_option_and_its_outcome_is_in_the_document() {
    let bounded = ["solve", "truncated-hertz", "--accuracy", "0.0001%", "--max-dofs", "1500"];
    let folder = Folder::made();
    let (met, table, error) = contact_vv(&[&bounded[..], &["--json", &folder.at("run.json")]].concat());
    let document = &serde_json::from_str::<serde_json::Value>(&folder.read("run.json")).expect("JSON")["accuracy"];
    assert_eq!(document["freedoms_at_most"], 1500);
    assert!(document["freedoms_of_next"].as_u64().is_some_and(|next| next > 1500), "{document}");
    assert_eq!(document["met"], false);
    assert!(!met && table.contains("more than the 1500 allowed"), "{table}");
    assert!(error.is_empty(), "nothing is long: {error}");
    let free = &json(&["solve", "truncated-hertz", "--accuracy", "1%"])["accuracy"];
    assert!(free.get("freedoms_at_most").is_none() && free.get("freedoms_of_next").is_none());
}
