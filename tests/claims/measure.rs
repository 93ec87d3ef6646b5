//! Functionals of pressure profiles, on profiles whose values are known in closed form.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::measure::order::{observed, richardson};
use contact_vv::measure::profile::{
    half_width_of, means, peak, peak_of, relative_l2, relative_l2_between, resultant, second_moment_half_width,
    weighted_line,
};
use contact_vv::measure::{Measures, display_factor, relative_error, whole};
use contact_vv::scene::library::{Cylinder, PinRod};
use contact_vv::scene::{Circle, Path};
use contact_vv::solution::{Outcome, PointState, Share, Solution, Work};

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

fn semi_ellipse(peak: f64, a: f64) -> impl Fn(f64) -> f64 {
    move |s: f64| peak * (1.0 - (s / a).powi(2)).max(0.0).sqrt()
}

#[test]
fn second_moment_gives_the_half_width_of_a_semi_ellipse_in_the_limit() {
    let a = 1.7;
    let error = |n: usize| (second_moment_half_width(&sampled(3.0, n, semi_ellipse(5.0, a))) - a).abs() / a;
    // The midpoint rule at a square-root end errs by O(h^1.5): 3e-6 here at 10,000 intervals.
    assert!(error(10_000) <= 3e-6, "{}", error(10_000));
    assert!(error(10_000) < error(1_000) && error(1_000) < error(100));
}

#[test]
fn second_moment_of_a_uniform_pressure_is_its_radius_of_gyration() {
    // ∫s² / ∫1 over 0 … b is b²/3, so that the functional is 2b/√3.
    let n = 1000;
    let found = second_moment_half_width(&sampled(3.0, n, |_| 4.0));
    // The midpoint rule errs by 1/(8 n²) relative on s².
    assert_relative_eq!(found, 2.0 * 3.0 / 3f64.sqrt(), max_relative = 1.0 / (n * n) as f64);
}

#[test]
fn half_width_weighs_points_by_their_area() {
    let point = |position: f64, weight: f64| PointState { position, weight, pressure: 2.0, gap: 0.0 };
    let found = second_moment_half_width(&[point(0.0, 3.0), point(2.0, 1.0)]);
    // (3·0 + 1·4)/4 = 1, twice its root.
    assert_relative_eq!(found, 2.0, max_relative = 1e-15);
}

#[test]
fn functionals_of_a_reference_are_taken_at_the_same_points() {
    let points = sampled(3.0, 37, |s| s);
    let profile = semi_ellipse(5.0, 1.7);
    let direct = sampled(3.0, 37, semi_ellipse(5.0, 1.7));
    assert_relative_eq!(half_width_of(&points, &profile), second_moment_half_width(&direct));
    assert_relative_eq!(peak_of(&points, 1.7, &profile).pressure, peak(&direct, 1.7).pressure);
}

#[test]
fn peak_recovers_an_even_parabola_exactly() {
    for n in [8, 40, 400] {
        let found = peak(&sampled(2.0, n, |s| 9.0 - 2.0 * s * s), 1.6);
        assert_relative_eq!(found.pressure, 9.0, max_relative = 1e-13);
        assert_abs_diff_eq!(found.position, 0.0, epsilon = 0.0);
    }
}

#[test]
fn peak_uses_the_points_within_a_quarter_of_the_half_width_only() {
    // Beyond a/4 = 0.5 the profile departs from the parabola; the fit must not notice.
    let profile = |s: f64| if s < 0.5 { 9.0 - 2.0 * s * s } else { 1.0 };
    assert_relative_eq!(peak(&sampled(2.0, 40, profile), 2.0).pressure, 9.0, max_relative = 1e-13);
}

#[test]
fn peak_away_from_the_centre_is_the_top_of_the_local_parabola() {
    let top = 1.234;
    let found = peak(&sampled(2.0, 40, |s| 9.0 - 2.0 * (s - top).powi(2)), 2.0);
    // The local fit solves a 3 × 3 system; 1e-10 leaves room for its condition.
    assert_relative_eq!(found.position, top, max_relative = 1e-10);
    assert_relative_eq!(found.pressure, 9.0, max_relative = 1e-10);
}

#[test]
fn consistent_weights_average_out_the_saw_tooth_of_nodal_pressures() {
    // Corner values too high by 2δ, mid-side values too low by δ: the weights 1/3 and 2/3 leave their mean.
    let points: Vec<PointState> = (0..9)
        .map(|i| {
            let corner = i % 2 == 0;
            let weight = match i {
                0 | 8 => 1.0,
                _ if corner => 2.0,
                _ => 4.0,
            };
            PointState { position: 0.01 * i as f64, weight, pressure: if corner { 5.2 } else { 4.9 }, gap: 0.0 }
        })
        .collect();
    // What is left of the ±δ by correlation with s² on nine points is below δ/3.
    assert_abs_diff_eq!(peak(&points, 1.0).pressure, 5.0, epsilon = 0.1 / 3.0 * 2.0);
    let unweighted: f64 = points.iter().map(|p| p.pressure).sum::<f64>() / 9.0;
    assert!((unweighted - 5.0).abs() > 0.05);
}

#[test]
fn weighted_line_passes_through_points_on_a_line_whatever_their_weights() {
    let points = [[0.0, 3.0, 1.0], [1.0, 5.0, 7.0], [4.0, 11.0, 0.2]];
    let (intercept, slope) = weighted_line(&points);
    assert_relative_eq!(intercept, 3.0, max_relative = 1e-14);
    assert_relative_eq!(slope, 2.0, max_relative = 1e-14);
}

#[test]
fn weighted_line_counts_a_point_of_weight_two_as_two_points() {
    let (heavy, light) = ([1.0, 4.0, 2.0], [1.0, 4.0, 1.0]);
    let rest = [[0.0, 1.0, 1.0], [2.0, 0.0, 1.0]];
    let once = weighted_line(&[heavy, rest[0], rest[1]]);
    let twice = weighted_line(&[light, light, rest[0], rest[1]]);
    assert_relative_eq!(once.0, twice.0, max_relative = 1e-14);
    assert_relative_eq!(once.1, twice.1, max_relative = 1e-14);
}

#[test]
fn l2_error_of_a_scaled_profile_is_the_scale_less_one() {
    let reference = semi_ellipse(5.0, 1.7);
    let points = sampled(3.0, 50, |s| 1.03 * reference(s));
    assert_relative_eq!(relative_l2(&points, &reference, 2.55), 0.03, max_relative = 1e-12);
    let exact = sampled(3.0, 50, &reference);
    assert_relative_eq!(relative_l2_between(&points, &exact), 0.03, max_relative = 1e-12);
    assert!(relative_l2_between(&points, &exact[1..]).is_nan());
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

fn solution(points: Vec<PointState>) -> Solution {
    Solution {
        outcome: Outcome::Converged,
        spring_pressures: points.iter().map(|p| p.pressure).collect(),
        contacts: vec![Share { points: 0..points.len(), edges: 0..0 }],
        points,
        edges: vec![],
        displacement: vec![],
        contact_force: vec![],
        history: vec![],
        coarser: Work::default(),
        work: Work::default(),
    }
}

#[test]
fn measures_of_a_symmetric_half_count_both_halves() {
    let mut scene = Cylinder::default().scene();
    scene.thickness = 2.0;
    let profile = |s: f64| if s < 1.2 { 6.0 - s * s } else { 0.0 };
    let mut points = sampled(3.0, 100, profile);
    points.iter_mut().for_each(|p| p.weight *= scene.thickness);

    let measures = Measures::of(&scene, &solution(points), 0, 0.1);

    // ∫ (6 − s²) over 0 … 1.2 on both sides, 2 mm thick; the midpoint rule errs by h²/24 · 2.4 = 1e-4 · 0.9.
    assert_relative_eq!(measures.resultant, 2.0 * 2.0 * (7.2 - 1.728 / 3.0), max_relative = 1e-4);
    assert_relative_eq!(measures.half_width_nodes, 1.2, max_relative = 1e-12);
    assert_relative_eq!(measures.edge, 1.185, max_relative = 1e-12);
    assert_relative_eq!(measures.peak.pressure, 6.0, max_relative = 1e-12);
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
    let measures = Measures::of(&scene, &solution(points), 0, 0.1);
    assert_relative_eq!(measures.half_width_nodes, 0.4, max_relative = 1e-12);
    assert_relative_eq!(display_factor(&scene.contact().path), 180.0 / PI);
    assert_relative_eq!(display_factor(&Path::HORIZONTAL), 1.0);
}

#[test]
fn observed_order_is_the_exponent_of_a_manufactured_series() {
    let sizes = [0.4, 0.2, 0.1, 0.05];
    for order in [0.5, 1.0, 2.0, 3.7] {
        let errors: Vec<f64> = sizes.iter().map(|h: &f64| -0.3 * h.powf(order)).collect();
        assert_relative_eq!(observed(&sizes, &errors), order, max_relative = 1e-12);
    }
}

#[test]
fn richardson_finds_order_limit_and_error_of_a_manufactured_series() {
    for (order, amplitude) in [(1.0, 0.2), (1.5, -0.3), (2.0, 0.1)] {
        let value = |h: f64| 7.0 + amplitude * h.powf(order);
        let found = richardson([value(0.4), value(0.2), value(0.1)]);
        let error = (amplitude * 0.1_f64.powf(order)).abs();
        assert_relative_eq!(found.order, order, max_relative = 1e-11);
        assert_relative_eq!(found.limit, 7.0, max_relative = 1e-13);
        // Factor of safety 1.25 (Roache 1994).
        assert_relative_eq!(found.uncertainty, 1.25 * error / value(0.1), max_relative = 1e-10);
    }
}

#[test]
fn richardson_trusts_no_order_above_two_and_no_oscillation() {
    let value = |h: f64| 7.0 + h.powi(4);
    let [coarse, medium, fine] = [value(0.4), value(0.2), value(0.1)];
    let found = richardson([coarse, medium, fine]);
    assert_relative_eq!(found.order, 4.0, max_relative = 1e-10);
    assert_relative_eq!(found.uncertainty, 1.25 * (medium - fine) / 3.0 / fine, max_relative = 1e-12);
    let oscillating = richardson([1.0, 2.0, 1.5]);
    assert!(oscillating.order.is_nan());
    assert_relative_eq!(oscillating.uncertainty, 1.0 / 1.5, max_relative = 1e-12);
}

#[test]
fn relative_error_is_measured_by_the_reference_and_nan_stays_nan() {
    assert_relative_eq!(relative_error(3.0, -2.0), 2.5);
    assert!(relative_error(f64::NAN, 1.0).is_nan());
}

#[test]
fn means_over_stretches_are_exact_where_the_pressure_is_constant_on_edges_and_keep_the_force() {
    let edges = sampled(4.0, 8, |s| if s < 2.5 { 10.0 - s.floor() } else { 0.0 });
    let stations: Vec<f64> = (0..4).map(|k| k as f64 + 0.5).collect();
    assert_abs_diff_eq!(means(&edges, 4.0, &stations)[..], [10.0, 9.0, 4.0, 0.0], epsilon = 1e-12);
    // Stretches that cut through edges keep the force, also where they reach beyond the candidates.
    let uneven: Vec<f64> = (0..3).map(|k| 1.7 * (k as f64 + 0.5)).collect();
    let force: f64 = means(&edges, 4.0, &uneven).iter().map(|p| 1.7 * p).sum();
    assert_relative_eq!(force, 23.0, max_relative = 1e-12);
    assert!(means(&sampled(4.0, 8, |_| f64::NAN), 4.0, &stations).iter().all(|p| p.is_nan()));
}

#[test]
fn peak_of_waves_is_the_top_of_the_highest_not_the_centre() {
    use contact_vv::measure::profile;
    // Four waves, the last one highest: p = (1 + s/20) cos²(π s/10) where it is above a half, 0 elsewhere.
    let pressure = |s: f64| {
        let wave = (1.0 + s / 20.0) * (std::f64::consts::PI * s / 10.0).cos().powi(2);
        if wave > 0.5 { wave } else { 0.0 }
    };
    let points: Vec<PointState> = (0..=400)
        .map(|k| {
            let position = 0.05 * f64::from(k);
            PointState { position, weight: 0.05, pressure: pressure(position), gap: 0.0 }
        })
        .collect();
    let peak = profile::peak(&points, profile::second_moment_half_width(&points));
    assert!((peak.pressure - 2.0).abs() < 0.01 && (peak.position - 20.0).abs() < 0.2, "{peak:?}");
    // A ring of contact: nothing at the centre.
    let ring: Vec<PointState> = points
        .iter()
        .map(|point| PointState { pressure: (1.0 - ((point.position - 8.0) / 2.0).powi(2)).max(0.0), ..*point })
        .collect();
    let peak = profile::peak(&ring, profile::second_moment_half_width(&ring));
    assert!((peak.pressure - 1.0).abs() < 1e-3 && (peak.position - 8.0).abs() < 0.1, "{peak:?}");
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
