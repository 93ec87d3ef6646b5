//! What no contact point and no coarser mesh sees: surfaces that meet elsewhere, sharp tops, places on large cells, widths.

use contact_vv::accuracy::Quantity;
use contact_vv::case::notes;
use contact_vv::error::Kind;
use contact_vv::solve::{Discretisation, Run};

use crate::balance::{barred, scene, solved};
use crate::workbench::kinematic;

#[test]
fn second_place_that_touches_between_nodes_beyond_the_candidates_is_refused() {
    let case = scene("far", &[]);
    let discretisation = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    let error = Run::of(&discretisation, &kinematic()).expect_err("it touches at s = 12, too");
    let Kind::ContactBeyondCandidates { deepest: Some((at, depth)), .. } = error.kind else { panic!("{error}") };
    assert!((at.value() - 12.0).abs() < 0.2 && depth > 1e-3, "{error}");
    let (_, seen) = solved(&scene("far-seen", &[]), &kinematic());
    assert!(seen.solution.converged() && seen.measures().stretches.len() == 2);
}

#[test]
fn asperity_narrower_than_an_element_is_noted() {
    let gap = "gap = { table = [[0, 0], [0.3, 0.0005], [0.59, 0.0017], [0.6, 0], [0.61, 0.0018], [2, 0.02], [20, 2]], smooth = true }";
    let was = "gap = { even = [0.001, -1.388888888888889e-05, 4.822530864197531e-08] }";
    for (elements, told) in [("elements = 3", true), ("elements = 25", false)] {
        let case = scene("far", &[[was, gap], ["elements = 6", elements]]);
        let (_, run) = solved(&case, &kinematic());
        let notes = notes::of(&run, 0);
        let found = notes.iter().any(|note| note.contains("between contact points, at s = 0.600000 mm"));
        assert_eq!(found, told, "{elements}: {notes:?}");
    }
}

#[test]
fn bar_of_a_peak_contains_a_sharp_top_that_all_meshes_miss_alike() {
    let (_, bars) = barred(&scene("flat", &[]), &kinematic());
    let one = bars.all.iter().find(|one| one.quantity == Quantity::PeakPressure).expect("a bar");
    let error = (one.value - 45.154570).abs();
    // It is about as large as the number itself: a bar that holds it says nothing.
    let why = one.unknown.unwrap_or("known");
    assert!(
        error > 0.9 * one.value && one.bar.total().is_nan() && why.contains("larger than the number"),
        "{error}, {why}"
    );
    // On smaller elements it is a number, and the bar holds its error.
    let (run, bars) = barred(&scene("flat", &[["elements = 4", "elements = 40"]]), &kinematic());
    let bar = bars.of(0, &Quantity::PeakPressure).expect("a bar").total();
    let error = (run.measures().peak.pressure - 45.154570).abs();
    assert!(error <= bar, "{error} against {bar}");
}

#[test]
fn bar_of_the_place_of_a_flat_peak_contains_where_it_lies() {
    let (run, bars) = barred(&scene("place", &[]), &kinematic());
    let bar = bars.of(0, &Quantity::PeakPlace).expect("a bar").total();
    let error = (run.measures().peak.position - 1.0).abs();
    assert!(error <= bar && bar < 0.2, "{error} against {bar}");
}

#[test]
fn half_width_is_half_of_begin_to_end_and_no_second_moment() {
    // A flat of 10 mm with rounded edges: the contact ends at 5.34 mm, where its second moment says 7.37.
    let (run, bars) = barred(&scene("rounded-punch", &[]), &kinematic());
    let measures = run.measures();
    // Its top at the rounding is narrower than the elements.
    for (quantity, found, right) in
        [(Quantity::PeakPressure, measures.peak.pressure, 1522.4), (Quantity::HalfWidth, measures.half_width(), 5.343)]
    {
        let bar = bars.of(0, &quantity).expect("a bar").total();
        assert!((found - right).abs() <= bar && bar < 0.36 * right, "{found} ± {bar}, {right}");
    }
    assert!((measures.half_width() - 5.343).abs() < 0.12, "{}", measures.half_width());
    assert!(measures.second_moment_width > 7.0, "{}", measures.second_moment_width);
    assert!((measures.half_width() - measures.edge()).abs() <= 0.0);
}

#[test]
fn peak_on_one_point_is_unresolved_and_not_without_limit() {
    let case = scene("hardly-touching", &[]);
    let (discretisation, run) = solved(&case, &kinematic());
    let run = run.with_limits(&discretisation).expect("coarser meshes");
    assert!(run.contacts[0].unbounded.is_none());
    assert!(notes::of(&run, 0).iter().any(|note| note.contains("rests on 1 of")), "{:?}", notes::of(&run, 0));
}
