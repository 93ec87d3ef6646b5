//! Functionals of pressure profiles, on profiles whose values are known in closed form.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::library::{Cylinder, PinRod};
use contact_vv::measure::order::{Why, bar_of_two, pairs, richardson, slope};
use contact_vv::measure::profile::{
    centre, means, misplaced, relative_l2, resultant, second_moment_width, weighted_line,
};
use contact_vv::measure::{Measures, Peak, Quantity, display_factor, nodal, peak, whole};
use contact_vv::mesh::Order;
use contact_vv::scene::{Circle, Path};
use contact_vv::solution::{EdgeState, Part, PointState};
use contact_vv::solve::{Formulation, Run};
use contact_vv::uncertainty::{Comparison, standard};

use crate::workbench::meshed;

/// Points in the middle of `n` equal intervals of `0 … end`.
fn sampled(end: f64, n: usize, pressure: impl Fn(f64) -> f64) -> Vec<PointState> {
    let h = end / n as f64;
    (0..n)
        .map(|i| {
            let position = (i as f64 + 0.5) * h;
            PointState { position, weight: h, pressure: pressure(position), gap: 0.0 }
        })
        .collect()
}

/// Means over `n` equal edges of `from … end`, from the force `∫p` up to each place.
fn edges(from: f64, end: f64, n: usize, force: impl Fn(f64) -> f64) -> Vec<EdgeState> {
    let h = (end - from) / n as f64;
    (0..n)
        .map(|i| {
            let ends = [from + h * i as f64, from + h * (i as f64 + 1.0)];
            EdgeState { ends, weight: h, pressure: (force(ends[1]) - force(ends[0])) / h, axis: None }
        })
        .collect()
}

/// `∫ p₀ √(1 − s²/a²)` from the centre.
fn force_of_semi_ellipse(peak: f64, a: f64) -> impl Fn(f64) -> f64 {
    move |s: f64| {
        let x = (s / a).clamp(-1.0, 1.0);
        0.5 * peak * a * (x * (1.0 - x * x).sqrt() + x.asin())
    }
}

fn semi_ellipse(peak: f64, a: f64) -> impl Fn(f64) -> f64 {
    move |s: f64| peak * (1.0 - (s / a).powi(2)).max(0.0).sqrt()
}

#[test]
fn second_moment_gives_the_half_width_of_a_semi_ellipse_in_the_limit() {
    let a = 1.7;
    let error = |n: usize| (second_moment_width(&sampled(3.0, n, semi_ellipse(5.0, a)), 0.0) - a).abs() / a;
    // The midpoint rule at a square-root end errs by O(h^1.5): 3e-6 here at 10,000 intervals.
    assert!(error(10_000) <= 3e-6, "{}", error(10_000));
    assert!(error(10_000) < error(1_000) && error(1_000) < error(100));
}

#[test]
fn second_moment_is_that_of_areas_and_pressures_about_the_centre() {
    // ∫s² / ∫1 over 0 … b is b²/3, so that the functional is 2b/√3; the midpoint rule errs by 1/(8 n²) relative on s².
    let found = second_moment_width(&sampled(3.0, 1000, |_| 4.0), 0.0);
    assert_relative_eq!(found, 2.0 * 3.0 / 3f64.sqrt(), max_relative = 1e-6);
    let point = |position: f64, weight: f64, pressure: f64| PointState { position, weight, pressure, gap: 0.0 };
    // (3·0 + 1·4)/4 = 1, twice its root.
    assert_relative_eq!(second_moment_width(&[point(0.0, 3.0, 2.0), point(2.0, 1.0, 2.0)], 0.0), 2.0);
    for at in [0.1, 0.7, -17.3, 1e-9] {
        let points = [point(at - 1.0, 0.3, 0.0), point(at, 0.3, 0.7), point(at + 1.0, 0.3, 0.0)];
        assert_eq!(second_moment_width(&points, centre(&points)), 0.0, "one point at {at}");
    }
}

#[test]
fn peak_of_a_polynomial_of_fourth_degree_is_its_top_wherever_it_lies() {
    // p = 9 − 2 (s − c)² + 0.1 (s − c)⁴, whose means over edges are exact.
    for (top, n) in [(0.0, 16), (0.3, 16), (0.617, 40), (-0.8, 40), (0.05, 400)] {
        let force = |s: f64| 9.0 * s - 2.0 / 3.0 * (s - top).powi(3) + 0.02 * (s - top).powi(5);
        let found = peak::of(&edges(-2.0, 2.0, n, force), 0.0);
        // The fit solves a 5 × 5 system on 0.04 of the peak.
        assert_relative_eq!(found.pressure, 9.0, max_relative = 1e-11);
        assert_abs_diff_eq!(found.position, top, epsilon = 1e-5);
    }
}

#[test]
fn peak_of_a_semi_ellipse_is_not_biased_by_the_fit() {
    // On a half that begins on the symmetry line and on both sides, on two meshes.
    let force = force_of_semi_ellipse(5.0, 1.0);
    for (from, n) in [(0.0, 24), (0.0, 100), (-1.5, 48), (-1.5, 200)] {
        let found = peak::of(&edges(from, 1.5, n, &force), 0.0);
        assert_relative_eq!(found.pressure, 5.0, max_relative = 5e-6);
        assert_abs_diff_eq!(found.position, 0.0, epsilon = 1e-6);
    }
}

#[test]
fn peak_off_the_centre_of_an_even_profile_is_found_there() {
    // p = 1 + 0.5 s² − 0.2 s⁴: 1 at the centre, 1.3125 at √1.25.
    let force = |s: f64| s + s.powi(3) / 6.0 - 0.04 * s.powi(5);
    let profile = edges(0.0, 2.0, 40, force);
    let found = peak::of(&profile, 0.0);
    assert_relative_eq!(found.pressure, 1.3125, max_relative = 1e-9);
    assert_relative_eq!(found.position.abs(), 1.25_f64.sqrt(), max_relative = 1e-6);
    assert_relative_eq!(peak::pressure_at(&profile, 0.0), 1.0, max_relative = 1e-9);
    assert_relative_eq!(peak::pressure_at(&profile, 0.5), 1.1125, max_relative = 1e-9);
    assert_abs_diff_eq!(peak::pressure_at(&profile, 2.5), 0.0, epsilon = 0.0);
}

#[test]
fn peak_does_not_see_pressures_that_alternate_from_edge_to_edge() {
    let mut profile = edges(-1.5, 1.5, 60, force_of_semi_ellipse(5.0, 1.0));
    for (k, edge) in profile.iter_mut().enumerate() {
        edge.pressure += if edge.pressure <= 0.0 {
            0.0
        } else if k % 2 == 0 {
            0.2
        } else {
            -0.2
        };
    }
    assert_relative_eq!(peak::of(&profile, 0.0).pressure, 5.0, max_relative = 2e-5);
}

#[test]
fn peak_of_few_edges_is_a_parabola_or_their_mean_and_that_of_nan_none() {
    // Four edges make three pairs: the parabola that they hold.
    let parabola = edges(-2.0, 2.0, 4, |s: f64| 9.0 * s - 2.0 / 3.0 * s.powi(3));
    assert_relative_eq!(peak::of(&parabola, 0.0).pressure, 9.0, max_relative = 1e-12);
    let one = [EdgeState { ends: [1.0, 2.0], weight: 1.0, pressure: 4.0, axis: None }];
    assert_relative_eq!(peak::of(&one, 1.5).pressure, 4.0);
    for lost in [0, 7, 23] {
        let mut edges = edges(-1.5, 1.5, 24, force_of_semi_ellipse(5.0, 1.0));
        edges[lost].pressure = f64::NAN;
        assert!(peak::of(&edges, 0.0).pressure.is_nan(), "edge {lost}");
    }
    // That of a uniform pressure lies at its centre.
    let uniform = peak::of(&edges(-1.0, 1.0, 20, |s| 7.0 * s), 0.1);
    assert_relative_eq!(uniform.pressure, 7.0, max_relative = 1e-12);
    assert_abs_diff_eq!(uniform.position, 0.1, epsilon = 0.0);
    let Peak { position, pressure } = peak::of(&[], 0.0);
    assert!(position.is_nan() && pressure.is_nan());
}

#[test]
fn parabola_through_the_highest_means_is_exact_for_one_and_ends_where_the_contact_does() {
    for (top, n) in [(0.0, 8), (0.3, 16), (-0.8, 40)] {
        let force = |s: f64| 9.0 * s - 2.0 / 3.0 * (s - top).powi(3);
        assert_relative_eq!(peak::by_parabola(&edges(-2.0, 2.0, n, force), 9.0), 9.0, max_relative = 1e-11);
    }
    // p = s² on 1 … 2, and its mirror image: the highest place is an end.
    for force in [|s: f64| s.powi(3) / 3.0, |s: f64| (s - 3.0).powi(3) / 3.0] {
        let profile = edges(1.0, 2.0, 10, force);
        assert_relative_eq!(peak::by_parabola(&profile, 4.0), 4.0, max_relative = 1e-11);
        assert_relative_eq!(peak::of(&profile, 1.5).pressure, 4.0, max_relative = 1e-11);
    }
    // Three pairs hold four edges: the others are not seen where they make no second hump, whether the highest place is
    // an end or not.
    for (centre, seen) in [(1.95, 6..10), (1.05, 0..4), (1.5, 3..7)] {
        let profile = edges(1.0, 2.0, 10, |s| 9.0 * s - (s - centre).powi(3) / 3.0);
        for k in (0..10).filter(|k| !seen.contains(k)) {
            let mut bent = profile.clone();
            let outer = |j: &usize| if k < seen.start { *j <= k } else { *j >= k };
            (0..10).filter(outer).for_each(|j| bent[j].pressure -= 0.1 * (1 + j.abs_diff(k)) as f64);
            assert_relative_eq!(peak::by_parabola(&bent, 9.0), peak::by_parabola(&profile, 9.0), max_relative = 1e-12);
        }
    }
    // Two edges make one pair: its mean.
    assert_relative_eq!(peak::by_parabola(&edges(1.0, 2.0, 2, |s| 7.0 * s), 7.0), 7.0, max_relative = 1e-14);
    assert!(peak::by_parabola(&[], 1.0).is_nan());
}

#[test]
fn parabola_of_a_second_hump_is_taken_where_it_is_farther_above_the_peak() {
    // 8 − 0.1 (s − 5)² up to s = 10, then 8.1 − 0.9 (s − 15)²: the second top is the higher, of the lower mean.
    let hump = |top: f64, curvature: f64, centre: f64| move |s: f64| top * s - curvature / 3.0 * (s - centre).powi(3);
    let (first, second) = (hump(8.0, 0.1, 5.0), hump(8.1, 0.9, 15.0));
    let force = |s: f64| if s <= 10.0 { first(s) } else { first(10.0) + second(s) - second(10.0) };
    let profile = edges(1.0, 19.0, 18, force);
    for (peak, taken) in [(7.9, 8.1), (8.0, 8.1), (8.06, 8.0), (8.2, 8.0)] {
        assert_relative_eq!(peak::by_parabola(&profile, peak), taken, max_relative = 1e-11);
    }
}

#[test]
fn share_of_force_elsewhere_is_what_moved() {
    let wanted = edges(0.0, 4.0, 4, |s| 2.0 * s);
    let mut found = wanted.clone();
    // One of eight newtons went from the first edge to the last.
    (found[0].pressure, found[3].pressure) = (1.0, 3.0);
    assert_relative_eq!(misplaced(&found, &wanted), 1.0 / 8.0, max_relative = 1e-15);
    assert_abs_diff_eq!(misplaced(&wanted, &wanted), 0.0, epsilon = 0.0);
    found[1].pressure = f64::NAN;
    assert!(misplaced(&found, &wanted).is_nan());
    assert!(misplaced(&found[1..], &wanted).is_nan());
}

#[test]
fn weighted_line_passes_through_points_on_a_line_and_counts_a_weight_of_two_as_two_points() {
    let (intercept, slope) = weighted_line(&[[0.0, 3.0, 1.0], [1.0, 5.0, 7.0], [4.0, 11.0, 0.2]]);
    assert_relative_eq!(intercept, 3.0, max_relative = 1e-14);
    assert_relative_eq!(slope, 2.0, max_relative = 1e-14);
    let rest = [[0.0, 1.0, 1.0], [2.0, 0.0, 1.0]];
    let once = weighted_line(&[&[[1.0, 4.0, 2.0]], &rest[..]].concat());
    let twice = weighted_line(&[&[[1.0, 4.0, 1.0]; 2], &rest[..]].concat());
    assert_relative_eq!(once.0, twice.0, max_relative = 1e-14);
    assert_relative_eq!(once.1, twice.1, max_relative = 1e-14);
}

#[test]
fn l2_error_of_a_scaled_profile_is_the_scale_less_one() {
    let reference = semi_ellipse(5.0, 1.7);
    let points = sampled(3.0, 50, |s| 1.03 * reference(s));
    assert_relative_eq!(relative_l2(&points, &reference, 2.55), 0.03, max_relative = 1e-12);
}

#[test]
fn l2_error_is_weighted_and_stops_at_the_limit() {
    let point = |position: f64, weight: f64, pressure: f64| PointState { position, weight, pressure, gap: 0.0 };
    let points = [point(0.0, 3.0, 2.0), point(1.0, 1.0, 1.0), point(9.0, 1.0, 100.0)];
    // Σ A (p − 1)² = 3, Σ A = 4, the point at 9 lying beyond.
    assert_relative_eq!(relative_l2(&points, |_| 1.0, 2.0), 0.75_f64.sqrt(), max_relative = 1e-15);
}

#[test]
fn resultant_on_an_arc_counts_the_part_along_the_load_line() {
    let (radius, pressure) = (10.0, 3.0);
    let arc = Path::Arc(Circle { centre: [0.0, 0.0], radius });
    let mut points = sampled(PI / 2.0, 1000, |_| pressure);
    points.iter_mut().for_each(|p| p.weight *= radius);
    // ∫ p cos θ R dθ over a quarter is p R; the midpoint rule errs by h²/24 = 1e-7.
    assert_relative_eq!(resultant(&points, &arc), pressure * radius, max_relative = 2e-7);
    assert_relative_eq!(resultant(&points, &Path::HORIZONTAL), pressure * radius * PI / 2.0, max_relative = 1e-12);
}

#[test]
fn measures_of_a_symmetric_half_count_both_halves() {
    let mut scene = Cylinder::default().scene();
    scene.thickness = 2.0;
    let profile = |s: f64| if s < 1.2 { 6.0 - s * s } else { 0.0 };
    let mut points = sampled(3.0, 100, profile);
    points.iter_mut().for_each(|p| p.weight *= scene.thickness);

    let edges = edges(0.0, 3.0, 100, |s| if s < 1.2 { 6.0 * s - s.powi(3) / 3.0 } else { 7.2 - 0.576 });
    let measures = Measures::of(&scene, 0, Part { points: &points, edges: &edges, nodes: 3 });

    // ∫ (6 − s²) over 0 … 1.2 on both sides, 2 mm thick; the midpoint rule errs by h²/24 · 2.4 = 1e-4 · 0.9.
    assert_relative_eq!(measures.resultant, 2.0 * 2.0 * (7.2 - 1.728 / 3.0), max_relative = 1e-4);
    assert_relative_eq!(measures.half_width_nodes, 1.2, max_relative = 1e-12);
    // A profile that breaks off: the end lies within the edge after the last pressed one.
    assert!((1.2..=1.23).contains(&measures.edge()), "{}", measures.edge());
    assert_abs_diff_eq!(measures.begin(), -measures.edge(), epsilon = 0.0);
    assert_relative_eq!(measures.peak.pressure, 6.0, max_relative = 1e-12);
    assert_relative_eq!(measures.pressure_at_origin, 6.0, max_relative = 1e-12);
    assert_eq!((measures.active, measures.pressed_edges, measures.stretches.len()), (40, 40, 1));
    assert_relative_eq!(whole(scene.contact()), 2.0);
    scene.contacts[0].symmetric = false;
    assert_relative_eq!(whole(scene.contact()), 1.0);
}

#[test]
fn counted_half_width_on_an_arc_is_an_angle() {
    let mut scene = PinRod::default().scene();
    scene.thickness = 2.0;
    let mut points = sampled(1.0, 100, |s| if s < 0.4 { 6.0 } else { 0.0 });
    points.iter_mut().for_each(|p| p.weight *= 2.0 * 10.0);
    let edges = edges(0.0, 1.0, 100, |s| 6.0 * s.min(0.4));
    let measures = Measures::of(&scene, 0, Part { points: &points, edges: &edges, nodes: 3 });
    assert_relative_eq!(measures.half_width_nodes, 0.4, max_relative = 1e-12);
    assert_relative_eq!(display_factor(&scene.contact().path), 180.0 / PI);
    assert_relative_eq!(display_factor(&Path::HORIZONTAL), 1.0);
}

#[test]
fn order_is_the_exponent_of_a_manufactured_series_pair_by_pair_but_near_the_floor() {
    let sizes = [0.4, 0.2, 0.1, 0.05];
    for order in [0.5, 1.0, 2.0, 3.7] {
        let errors: Vec<f64> = sizes.iter().map(|h: &f64| -0.3 * h.powf(order)).collect();
        assert_relative_eq!(slope(&sizes, &errors), order, max_relative = 1e-12);
        for pair in pairs(&sizes, &errors, 0.0) {
            assert_relative_eq!(pair.unwrap_or(f64::NAN), order, max_relative = 1e-12);
        }
    }
    // A pair sees the mesh that a slope averages: the finest, whose error does not fall as it should.
    let errors = [0.16, 0.04, 0.01, 0.008];
    let found: Vec<f64> = pairs(&sizes, &errors, 0.0).into_iter().map(|pair| pair.unwrap_or(f64::NAN)).collect();
    assert_relative_eq!(found[2], (10.0_f64 / 8.0).log2(), max_relative = 1e-12);
    assert!(slope(&sizes, &errors) > 1.4);
    // Within five times the floor an error says nothing, whatever its sign.
    let found = pairs(&sizes, &[1.6e-7, 4e-8, 4.9e-9, -1e-9], 1e-9);
    assert_relative_eq!(found[0].unwrap_or(f64::NAN), 2.0, max_relative = 1e-12);
    assert_eq!(found[1..], [Err(Why::Floor); 2]);
}

#[test]
fn a_series_that_is_not_monotone_has_no_order_anywhere() {
    let sizes = [0.25, 0.125, 0.0625, 0.03125];
    let withheld = [Err(Why::NotMonotone); 3];
    for (what, errors) in [
        ("a growing error", [1.3e-3, 5.3e-5, 5.7e-5, 1.9e-5]),
        ("a change of sign", [1.3e-3, -5.3e-5, -2e-5, -1e-5]),
        ("an error that stays", [4.0, 2.0, 2.0, 1.0]),
        ("NaN", [4.0, f64::NAN, 1.0, 0.5]),
        ("infinity", [f64::INFINITY, 2.0, 1.0, 0.5]),
    ] {
        let found = pairs(&sizes, &errors, 0.0);
        assert_eq!(found, withheld, "{what}");
        assert!(found.iter().all(|pair| pair.unwrap_or(f64::NAN).is_nan()), "{what}");
    }
    assert_eq!(pairs(&sizes, &[4.0, 2.0, 1.0, 0.5], f64::NAN), withheld);
}

#[test]
fn richardson_finds_order_limit_and_error_of_a_manufactured_series() {
    for (order, amplitude) in [(0.7, 0.2), (1.0, 0.2), (1.5, -0.3), (2.0, 0.1)] {
        let value = |h: f64| 7.0 + amplitude * h.powf(order);
        let found = richardson([value(0.4), value(0.2), value(0.1)]);
        let error = (amplitude * 0.1_f64.powf(order)).abs();
        assert_relative_eq!(found.order, order, max_relative = 1e-11);
        assert_relative_eq!(found.limit, 7.0, max_relative = 1e-13);
        // Factor of safety 1.25 (Roache 1994); half of a bar that covers 95 % is standard.
        assert_relative_eq!(found.bar, 1.25 * error, max_relative = 1e-10);
        assert_relative_eq!(found.uncertainty(), 0.5 * found.bar, max_relative = 1e-15);
    }
}

#[test]
fn richardson_never_extrapolates_an_oscillation() {
    for series in [[1.0, 2.0, 1.5], [2.0, 1.0, 1.2], [1.0, 2.0, -3.0], [1.0, 3.0, 3.0], [3.0, 3.0, 2.0]] {
        let found = richardson(series);
        assert!(found.order.is_nan(), "{series:?}");
        assert_abs_diff_eq!(found.limit, series[2], epsilon = 0.0);
        let [least, most] = [f64::min, f64::max].map(|of| series.into_iter().reduce(of).expect("three"));
        assert_relative_eq!(found.bar, most - least, max_relative = 1e-12);
    }
    assert_abs_diff_eq!(richardson([2.0; 3]).bar, 0.0, epsilon = 0.0);
    // Of two meshes: three times what second order tells.
    assert_relative_eq!(bar_of_two([7.3, 7.1]), 3.0 * 0.2 / 3.0, max_relative = 1e-12);
    assert!(bar_of_two([f64::NAN, 7.1]).is_nan());
}

#[test]
fn richardson_is_cautious_beyond_the_orders_of_its_elements() {
    let series = |order: f64| [0.4, 0.2, 0.1].map(|h: f64| 7.0 + h.powf(order));
    let of = |order: f64| (richardson(series(order)), (series(order)[1] - series(order)[2]).abs());
    let (faster, change) = of(2.6);
    assert_relative_eq!(faster.order, 2.6, max_relative = 1e-10);
    assert_relative_eq!(faster.bar, 1.25 * change / 3.0, max_relative = 1e-12);
    // A last change that is small by accident is neither extrapolated nor trusted.
    for order in [3.2, 6.0] {
        let (accident, change) = of(order);
        let range = series(order)[0] - series(order)[2];
        assert_relative_eq!(accident.bar, (3.0 * change).max(1.25 * range / 15.0), max_relative = 1e-12);
        assert_abs_diff_eq!(accident.limit, series(order)[2], epsilon = 0.0);
    }
    // Slow: the bar covers at least the error that the observed order tells.
    for order in [0.45, 0.2, 0.05] {
        let (slow, change) = of(order);
        let observed = 1.25 * change / (2f64.powf(order) - 1.0);
        assert!(slow.bar >= observed * (1.0 - 1e-9) && slow.bar >= 6.0 * change, "{order}: {}", slow.bar);
        assert_abs_diff_eq!(slow.limit, series(order)[2], epsilon = 0.0);
    }
    // Changes that do not fall tell nothing, and what is no number neither.
    for series in
        [[1.0, 2.0, 3.0], [1.0, 2.0, 4.0], [f64::NAN, 2.0, 1.5], [1.0, 2.0, f64::NAN], [f64::INFINITY, 2.0, 1.5]]
    {
        assert!(richardson(series).bar.is_nan(), "{series:?}");
    }
}

#[test]
fn a_comparison_is_covered_by_what_all_its_sources_make() {
    let compared = Comparison::of(5.0, 2.0, [1.0, 2.0, 2.0]);
    assert_relative_eq!(compared.error, 3.0);
    assert_relative_eq!(compared.uncertainty, 3.0);
    assert_relative_eq!(compared.ratio(), 1.0);
    assert_relative_eq!(standard(5.0), 2.5);
    for spoiled in [f64::NAN, f64::INFINITY] {
        assert!(Comparison::of(5.0, 2.0, [1.0, spoiled]).ratio().is_nan());
        assert!(Comparison::of(spoiled, 2.0, [1.0]).ratio() > 1e9 || spoiled.is_nan());
    }
    assert!(Comparison::of(f64::NAN, 2.0, [1.0]).ratio().is_nan());
    assert!(Comparison::of(2.0, 2.0, []).ratio().is_nan());
}

#[test]
fn means_over_stretches_are_exact_where_the_pressure_is_constant_on_edges_and_keep_the_force() {
    // 10, 9 and half of 8 a millimetre, then nothing.
    let force = |s: f64| 10.0 * s.min(1.0) + 9.0 * (s - 1.0).clamp(0.0, 1.0) + 8.0 * (s - 2.0).clamp(0.0, 0.5);
    let profile = edges(0.0, 4.0, 8, force);
    let stations: Vec<f64> = (0..4).map(|k| k as f64 + 0.5).collect();
    assert_abs_diff_eq!(means(&profile, &stations)[..], [10.0, 9.0, 4.0, 0.0], epsilon = 1e-12);
    // Stretches that cut through edges keep the force, also where they reach beyond the candidates.
    let uneven: Vec<f64> = (0..3).map(|k| 1.7 * (k as f64 + 0.5)).collect();
    let force: f64 = means(&profile, &uneven).iter().map(|p| 1.7 * p).sum();
    assert_relative_eq!(force, 23.0, max_relative = 1e-12);
    assert!(means(&edges(0.0, 4.0, 8, |_| f64::NAN), &stations).iter().all(|p| p.is_nan()));
}

/// Measures of points and edges of a block that touches on both sides of s = 0.
fn measures(profile: &[EdgeState]) -> Measures {
    let mut scene = Cylinder::default().scene();
    scene.contacts[0].symmetric = false;
    let points: Vec<PointState> = profile
        .iter()
        .map(|edge| PointState { position: edge.position(), weight: edge.weight, pressure: edge.pressure, gap: 0.0 })
        .collect();
    Measures::of(&scene, 0, Part { points: &points, edges: profile, nodes: 3 })
}

#[test]
fn how_well_elements_draw_a_top_is_its_fourth_difference() {
    // 3 (h/a)⁴ in the middle of a semi-ellipse.
    let [coarse, fine] = [10, 20].map(|n| measures(&edges(-1.0, 1.0, n, force_of_semi_ellipse(5.0, 1.0))).drawn);
    assert_relative_eq!(fine.rough, 3.0 * 0.1_f64.powi(4), max_relative = 0.2);
    assert!(coarse.rough > 14.0 * fine.rough && fine.from_end == 9, "{coarse:?}, {fine:?}");
    // As high as the edges beside it are not.
    let spike = |k: usize| if k == 12 { 5.0 } else { 1.0 };
    let rises = |k: usize| if k < 13 { 2.0_f64.powi(k as i32 - 12) } else { 0.0 };
    let of = |pressure: &dyn Fn(usize) -> f64| {
        let profile = edges(-1.0, 1.0, 20, |_| 0.0).into_iter().enumerate();
        measures(&profile.map(|(k, edge)| EdgeState { pressure: pressure(k), ..edge }).collect::<Vec<_>>()).drawn
    };
    let (spike, rises) = (of(&spike), of(&rises));
    assert!(spike.rough > 1.0 && spike.from_end == 7, "{spike:?}");
    assert!(rises.rough > 1.0 && rises.from_end == 0, "{rises:?}");
    assert!(of(&|_| f64::NAN).rough.is_nan());
}

#[test]
fn every_closed_stretch_is_told_with_both_its_ends() {
    // Two humps of half-width 1 at 3 and 8, nothing between them.
    let hump = |s: f64, centre: f64| force_of_semi_ellipse(5.0, 1.0)(s - centre);
    let found = measures(&edges(0.0, 10.0, 400, |s| hump(s, 3.0) + 2.0 * hump(s, 8.0)));
    let ends: Vec<[f64; 2]> = found.stretches.iter().map(|stretch| [stretch.begin, stretch.end]).collect();
    assert_eq!(ends.len(), 2, "{ends:?}");
    for (found, wanted) in ends.iter().flatten().zip([2.0, 4.0, 7.0, 9.0]) {
        assert_abs_diff_eq!(*found, wanted, epsilon = 2e-3);
    }
    assert_abs_diff_eq!(found.begin(), 2.0, epsilon = 2e-3);
    assert_abs_diff_eq!(found.edge(), 9.0, epsilon = 2e-3);
    // The higher hump has the peak; nothing presses at s = 0.
    assert_relative_eq!(found.peak.pressure, 10.0, max_relative = 1e-5);
    assert_abs_diff_eq!(found.peak.position, 8.0, epsilon = 1e-5);
    assert_abs_diff_eq!(found.pressure_at_origin, 0.0, epsilon = 0.0);
}

#[test]
fn pressure_between_points_is_linear_and_that_of_the_outermost_up_to_the_ends_of_the_stretch() {
    use contact_vv::measure::profile::interpolate;
    let point = |position: f64, pressure: f64| PointState { position, weight: 1.0, pressure, gap: 0.0 };
    let across = [point(-3.0, 10.0), point(1.0, 30.0), point(3.0, 20.0)];
    for (s, wanted) in [(-4.1, 0.0), (-4.0, 10.0), (-3.0, 10.0), (0.0, 25.0), (2.0, 25.0), (3.5, 20.0), (4.0, 20.0)] {
        assert_abs_diff_eq!(interpolate(&across, 4.0, s), wanted, epsilon = 1e-12);
    }
    assert_abs_diff_eq!(interpolate(&across, 4.0, 4.1), 0.0, epsilon = 0.0);
    assert_abs_diff_eq!(interpolate(&across[1..], 4.0, 0.0), 30.0, epsilon = 1e-12);
    assert_abs_diff_eq!(interpolate(&[], 4.0, 0.0), 0.0, epsilon = 0.0);
    assert!(interpolate(&[point(0.0, f64::NAN), point(1.0, 1.0)], 4.0, 0.5).is_nan());
}

#[test]
fn cell_of_many_nodes_is_read_by_its_polynomial_where_all_press_and_is_open_on_the_line_where_its_first_does_not() {
    let nodes = [0.0, 0.6, 2.0, 3.4, 4.0];
    let cubic = |s: f64| 1.0 + 0.5 * s - 0.1 * s * s + 0.01 * s * s * s;
    let edge = EdgeState { ends: [0.0, 4.0], weight: 4.0, pressure: 1.0, axis: None };
    let all = nodes.map(|position| PointState { position, weight: 0.8, pressure: cubic(position), gap: 0.0 });
    let part = |points| Part { points, edges: std::slice::from_ref(&edge), nodes: 5 };
    for s in [0.0, 0.3, 1.1, 2.9, 4.0] {
        assert_relative_eq!(nodal::pressure_at(part(&all), 4.0, s), cubic(s), max_relative = 1e-12);
    }
    assert_eq!(nodal::pressure_at(part(&all), 4.0, 4.1), 0.0);
    // Open on the symmetry line: a straight line between points, and a stretch that does not begin there.
    let mut open = all;
    open[..2].iter_mut().for_each(|point| point.pressure = 0.0);
    assert_relative_eq!(nodal::pressure_at(part(&open), 4.0, 1.3), 0.5 * cubic(2.0), max_relative = 1e-12);
    let scene = Cylinder::default().scene();
    let rooted = open.map(|point| PointState { pressure: (point.position - 1.5).max(0.0).sqrt(), ..point });
    let begin = Measures::of(&scene, 0, part(&rooted)).stretches[0].begin;
    assert_relative_eq!(begin, 1.5, max_relative = 1e-9);
    assert_eq!(Measures::of(&scene, 0, part(&all)).stretches[0].begin, 0.0);
}

#[test]
fn hoop_stress_is_that_of_a_node_and_none_between_two() {
    let discretisation = meshed(PinRod::default().scene(), 12, Order::Quadratic);
    let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
    let along =
        discretisation.hoop_stresses(&discretisation.recover(&run.solution).expect("fields"), 0).expect("stresses");
    let read = |at: f64| discretisation.number(&run, 0, &Quantity::HoopStress { at }).expect("a number");
    let [[first, stress], [second, _]] = [along[4], along[5]];
    assert!((read(first) - stress).abs() <= 0.0 && second - first > 1e-3, "{first}, {second}");
    assert!(read(first + 1e-3).is_nan(), "{}", read(first + 1e-3));
}
