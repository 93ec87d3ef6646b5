//! Coordinates along a line, and the lattice that a block spans between four of them.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::mesh::block::{Block, Side};
use contact_vv::mesh::{Order, spacing};

fn sizes(coordinates: &[f64]) -> Vec<f64> {
    coordinates.windows(2).map(|two| two[1] - two[0]).collect()
}

#[test]
fn uniform_stretched_and_fitted_spacings_are_geometric_progressions_that_end_exactly() {
    let uniform = [1, 2, 7].map(|n| (n, spacing::uniform(-1.0, 2.0, n), 3.0 / n as f64, 1.0));
    let stretched = [(2, 3.0), (5, 0.2), (9, 0.02), (12, 1.0)].map(|(n, end)| {
        let ratio = f64::powf(end, 1.0 / (n as f64 - 1.0));
        let first = 3.0 / (0..n).map(|k| ratio.powi(k)).sum::<f64>();
        (n as usize, spacing::stretched(-1.0, 2.0, n as usize, end), first, ratio)
    });
    let fitted = [(4, 0.15), (6, 0.3), (8, 0.9), (3, 1.8)].map(|(n, first)| {
        let coordinates = spacing::fitted(-1.0, 2.0, n, first);
        let ratio = (coordinates[2] - coordinates[1]) / (coordinates[1] - coordinates[0]);
        (n, coordinates, first, ratio)
    });
    for (n, coordinates, first, ratio) in uniform.into_iter().chain(stretched).chain(fitted) {
        assert_eq!([coordinates[0], coordinates[n]], [-1.0, 2.0], "{coordinates:?}");
        assert_eq!(coordinates.len(), n + 1);
        for (k, size) in sizes(&coordinates).into_iter().enumerate() {
            assert_relative_eq!(size, first * ratio.powi(k as i32), max_relative = 1e-8);
        }
    }
}

#[test]
fn growing_spacing_keeps_its_ratio_up_to_the_coarsest_and_ends_exactly() {
    for (length, first, ratio, coarsest) in
        [(10.0, 0.1, 1.3, 2.0), (1.0, 0.3, 1.0, 1.0), (5.0, 0.01, 2.0, 0.5), (1.0, 3.0, 1.5, 0.1)]
    {
        let coordinates = spacing::growing(2.0, 2.0 + length, first, ratio, coarsest);
        let sizes = sizes(&coordinates);
        assert!(
            (coordinates[0] - 2.0).abs() <= 0.0 && (coordinates[coordinates.len() - 1] - 2.0 - length).abs() <= 0.0
        );
        // The law is scaled as a whole so that it ends at the end: all sizes by one factor.
        let scale = sizes[0] / first;
        let mut wanted = first;
        for size in &sizes {
            assert_relative_eq!(*size, scale * wanted, max_relative = 1e-9);
            wanted = (wanted * ratio).min(coarsest.max(first));
        }
        // At most half of the last interval is squeezed in or stretched away.
        let last = sizes[sizes.len() - 1];
        assert!(sizes.len() == 1 || (length - length / scale).abs() <= 0.5 * last / scale + 1e-9, "scale {scale}");
    }
}

#[test]
fn growing_from_both_ends_is_fine_at_both_and_never_jumps() {
    for (ends, ratio, coarsest) in [([0.1, 0.02], 1.3, 0.5), ([0.05, 0.05], 1.5, 0.2), ([0.2, 0.1], 1.2, 0.3)] {
        let coordinates = spacing::growing_from_both(1.0, 3.0, ends, ratio, coarsest);
        let sizes = sizes(&coordinates);
        assert_eq!((coordinates[0], coordinates[coordinates.len() - 1]), (1.0, 3.0));
        // Scaled to fit: no size is farther from what was asked than one interval allows.
        let scale = sizes[0] / ends[0];
        assert!((0.5..=1.0 + 1e-12).contains(&scale), "{scale}");
        assert_relative_eq!(sizes[sizes.len() - 1] / ends[1], scale, max_relative = 1e-9);
        for pair in sizes.windows(2) {
            let jump = (pair[0] / pair[1]).max(pair[1] / pair[0]);
            assert!(jump <= ratio * ratio + 1e-9, "{jump}");
        }
        assert!(sizes.iter().all(|size| *size <= coarsest.max(ends[0]) + 1e-12));
    }
}

#[test]
fn lists_share_the_place_at_which_they_meet_are_halved_by_level_and_end_exactly() {
    assert_eq!(spacing::joined(&[vec![0.0, 1.0], vec![1.0, 3.0], vec![3.0, 4.0]]), vec![0.0, 1.0, 3.0, 4.0]);
    assert_eq!(spacing::lattice(&[0.0, 1.0, 3.0], 0, Order::Quadratic), vec![0.0, 0.5, 1.0, 2.0, 3.0]);
    let fine = spacing::lattice(&[0.0, 1.0, 3.0], 1, Order::Linear);
    assert_eq!(fine, vec![0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0]);
    // Intervals that fill the length exactly are not followed by another.
    let even = [0.0, 0.25, 0.5, 0.75, 1.0];
    assert_eq!(spacing::growing(0.0, 1.0, 0.25, 1.0, 1.0), even);
    assert_eq!(spacing::growing_from_both(0.0, 1.0, [0.25, 0.25], 1.0, 1.0), even);
}

#[test]
fn transfinite_block_with_straight_sides_is_the_bilinear_map() {
    let corners = [[0.0, 0.0], [4.0, 1.0], [3.0, 5.0], [-1.0, 2.0]];
    let line = |a: [f64; 2], b: [f64; 2], coordinates: &[f64]| -> Vec<[f64; 2]> {
        coordinates.iter().map(|t| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]).collect()
    };
    let (xi, eta) = ([0.0, 0.1, 0.35, 0.6, 1.0], [0.0, 0.4, 1.0]);
    let block = Block {
        bottom: Side::inner(line(corners[0], corners[1], &xi)),
        right: Side::named("right", line(corners[1], corners[2], &eta)),
        top: Side::inner(line(corners[3], corners[2], &xi)),
        left: Side::inner(line(corners[0], corners[3], &eta)),
    };
    let lattice = block.lattice(Order::Quadratic);
    assert_eq!(block.size(), [5, 3]);
    for (j, v) in eta.iter().enumerate() {
        for (i, u) in xi.iter().enumerate() {
            for k in 0..2 {
                let wanted = (1.0 - u) * (1.0 - v) * corners[0][k]
                    + u * (1.0 - v) * corners[1][k]
                    + u * v * corners[2][k]
                    + (1.0 - u) * v * corners[3][k];
                assert_abs_diff_eq!(lattice[j][i][k], wanted, epsilon = 1e-14 * 5.0);
            }
        }
    }
}

#[test]
fn transfinite_block_keeps_coordinates_that_differ_on_opposite_sides_on_straight_lines() {
    let (lower, upper) = ([0.0, 0.2, 0.5, 1.0], [0.0, 0.5, 0.8, 1.0]);
    let heights = [0.0, 0.3, 1.0];
    let block = Block {
        bottom: Side::inner(lower.map(|x| [x, 0.0]).to_vec()),
        right: Side::inner(heights.map(|y| [1.0, y]).to_vec()),
        top: Side::inner(upper.map(|x| [x, 1.0]).to_vec()),
        left: Side::inner(heights.map(|y| [0.0, y]).to_vec()),
    };
    let lattice = block.lattice(Order::Quadratic);
    for i in 0..4 {
        assert_abs_diff_eq!(lattice[1][i][1], 0.3, epsilon = 1e-15);
        assert_abs_diff_eq!(lattice[1][i][0], lower[i] + 0.3 * (upper[i] - lower[i]), epsilon = 1e-15);
    }
}

#[test]
fn fine_stretches_end_on_coordinates_and_sizes_grow_away_from_them() {
    let fine = [[-3.0, 3.0, 0.5], [-1.0, 0.2, 0.1], [7.0, 8.0, 0.25]];
    let coordinates = spacing::fine_within([-10.0, 20.0], &fine, 1.5, 4.0);
    assert!(coordinates.windows(2).all(|two| two[0] < two[1]));
    assert_eq!((coordinates[0], coordinates[coordinates.len() - 1]), (-10.0, 20.0));
    for end in fine.iter().flat_map(|one| [one[0], one[1]]) {
        assert!(coordinates.iter().any(|at| (at - end).abs() < 1e-12), "{end} is no coordinate");
    }
    for two in coordinates.windows(2) {
        let [middle, size] = [0.5 * (two[0] + two[1]), two[1] - two[0]];
        for one in fine.iter().filter(|one| one[0] < middle && middle < one[1]) {
            assert!(size <= one[2] * 1.06, "{size} at {middle}");
        }
        assert!(size <= 4.0);
    }
    // Neighbours differ by the ratio, and what fitting the last of a stretch takes.
    let sizes = sizes(&coordinates);
    assert!(sizes.windows(2).all(|two| two[0] / two[1] < 2.0 && two[1] / two[0] < 2.0), "{sizes:?}");
}

#[test]
fn spacing_depends_neither_on_the_unit_of_length_nor_on_where_it_begins() {
    // Breaks and ends of stretches so close that they share a position, and some that only just do not.
    let laws = |unit: f64, from: f64| {
        let place = |x: f64| from + unit * x;
        let ends = [from, place(10.0)];
        let fine = [[2.0, 3.0, 0.5], [3.0 + 1e-9, 4.0, 0.1], [5.0, 5.0 + 1e-6, 1.0]];
        let fine = fine.map(|[a, b, size]| [place(a), place(b), unit * size]);
        let breaks = [3.0, 3.0 + 5e-6, 7.0, 7.0 + 5e-5, 10.0 - 5e-6].map(place);
        [
            spacing::broken(from, place(10.0), 6, 2.0, &breaks),
            spacing::fine_within(ends, &fine, 1.5, 4.0 * unit),
            spacing::stretched(from, place(10.0), 6, 2.0),
            spacing::growing(from, place(10.0), 0.1 * unit, 1.3, 2.0 * unit),
            spacing::growing_from_both(from, place(10.0), [0.1 * unit, 0.3 * unit], 1.3, 2.0 * unit),
            spacing::fitted(from, place(10.0), 6, 0.1 * unit),
        ]
    };
    let plain = laws(1.0, 0.0);
    assert!(plain[0].windows(2).all(|two| two[1] - two[0] > 4e-5), "{:?}", plain[0]);
    let near = |list: &[f64], at: f64| list.iter().filter(|x| (*x - at).abs() < 1e-5).count();
    assert_eq!([near(&plain[0], 7.0), near(&plain[1], 3.0), near(&plain[1], 5.0)], [1, 1, 2]);
    let [small, large] = [2.0_f64.powi(-20), 2.0_f64.powi(20)];
    for (unit, from) in [(small, 0.0), (large, 0.0), (1.0, -20.0), (1.0, -10.0), (1.0, -3.5), (1.0, 64.0)] {
        for (law, (one, other)) in plain.iter().zip(laws(unit, from)).enumerate() {
            assert_eq!(one.len(), other.len(), "law {law} in units of {unit} from {from}");
            for (a, b) in one.iter().zip(other) {
                assert_abs_diff_eq!(*a, (b - from) / unit, epsilon = 1e-10);
            }
        }
    }
}
