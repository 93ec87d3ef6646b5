//! How far differences between meshes tell the error: the constants derived again from the recorded sample, and bars by
//! them computed again from meshes that are solved here.

use std::collections::BTreeMap;
use std::ops::Range;

use contact_vv::accuracy::coarser::coarser;
use contact_vv::accuracy::counted::Row;
use contact_vv::accuracy::{Bars, Quantity, bars, bars_up_to};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::scene::{BlockShape, Component, Place, Scene, Shape};
use contact_vv::solve::{Discretisation, Displaced, Fitted, Formulation, Run};
use contact_vv::study::promised::counted::{Record, SURVEY};
use contact_vv::study::random::Family;

use crate::balance::{scene, solved, solved_on, told_of};
use crate::workbench::{block_text, kinematic, parsed};

/// Mantissas of the constants: those of the series E24 (IEC 60063).
const MANTISSAS: [f64; 24] = [
    1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0, 3.3, 3.6, 3.9, 4.3, 4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2,
    9.1,
];
/// Decades of F and of C: no bar is below the error that the differences tell.
const DECADES: [Range<i32>; 2] = [0..1, -3..1];
/// Share of the numbers of each family that may be beyond their bars, and bars beyond which none is.
const BEYOND: (f64, f64) = (0.01, 2.0);

/// The constants F or C that are tried, from the smallest on.
fn tried(decades: Range<i32>) -> impl Iterator<Item = f64> {
    let decade = |k: i32| MANTISSAS.map(|mantissa| format!("{mantissa}e{k}").parse().unwrap_or(f64::NAN));
    decades.flat_map(decade)
}

/// The bar of a number by some constants.
fn bar(one: &Record, [factor, hidden]: [f64; 2]) -> f64 {
    factor * one.apart.0 + hidden * one.hidden.0 + one.rest.0
}

/// Whether bars by some constants hold in each family.
fn hold(sample: &[&Record], constants: [f64; 2]) -> bool {
    let (share, most) = BEYOND;
    let mut families: BTreeMap<Family, [usize; 2]> = BTreeMap::new();
    for one in sample {
        let bar = bar(one, constants);
        // A bar that is no number holds nothing.
        let is_within = |bars: f64| one.error.0 <= bars * bar;
        if !is_within(most) {
            return false;
        }
        let [all, beyond] = families.entry(one.site.family).or_default();
        *all += 1;
        *beyond += usize::from(!is_within(1.0));
    }
    families.values().all(|[all, beyond]| *beyond as f64 <= share * *all as f64)
}

/// F and C of the narrowest bars that hold, by the mean of their logarithms: for each F the least C; NaN where none
/// hold.
fn narrowest(sample: &[&Record]) -> [f64; 2] {
    let width = |constants: [f64; 2]| sample.iter().map(|one| bar(one, constants).ln()).sum::<f64>();
    let [factors, hidden] = DECADES;
    let hidden: Vec<f64> = std::iter::once(0.0).chain(tried(hidden)).collect();
    let holding = tried(factors).filter_map(|factor| {
        let least = hidden.partition_point(|hidden| !hold(sample, [factor, *hidden]));
        Some([factor, *hidden.get(least)?])
    });
    let narrower = |a: [f64; 2], b: [f64; 2]| if width(b) < width(a) { b } else { a };
    holding.reduce(narrower).unwrap_or([f64::NAN; 2])
}

/// The constants of every row, derived from a record, with the numbers that they are from.
fn derived(recorded: &[Record]) -> Vec<(Row, usize, [f64; 2])> {
    let mut rows: BTreeMap<Row, Vec<&Record>> = BTreeMap::new();
    recorded.iter().for_each(|one| rows.entry(one.row()).or_default().push(one));
    rows.into_iter().map(|(row, own)| (row, own.len(), narrowest(&own))).collect()
}

#[test]
fn constants_of_the_bars_are_the_narrowest_that_hold_on_the_recorded_sample() {
    let recorded = SURVEY.read().expect("a record");
    let derived = derived(&recorded);
    assert_eq!(derived.len(), 28);
    for (row, numbers, constants) in derived {
        assert_eq!(row.constants(), constants, "{row:?}, from {numbers} numbers");
    }
}

/// A mesh and its run to the last digit.
fn to_the_last_digit((scene, resolution): (Scene, Resolution)) -> (Discretisation, Run) {
    solved_on(scene, resolution, &kinematic().tolerance(1e-9))
}

/// Length of a candidate element, of as many nodes as a middle and two ends are.
fn element(mesh: &Discretisation) -> f64 {
    let nodes = &mesh.interfaces[0].nodes;
    2.0 * (nodes[nodes.len() - 1].coordinate - nodes[0].coordinate) / (nodes.len() - 1) as f64
}

/// A number of a run: of its pressures, or a displacement.
fn value((mesh, run): &(Discretisation, Run), quantity: &Quantity) -> f64 {
    match quantity {
        Quantity::Displacement(side) => {
            let displacement = mesh.displacement_under(run.share(), &run.solution);
            mesh.displaced(&displacement, side).expect("a place of the body")
        }
        of_pressures => of_pressures.of(run.measures()),
    }
}

/// Least and largest `|f₀ − fᵢ| / (rᵢ^q − 1)`, by coarser meshes whose elements are so many times as long.
fn apart(
    own: &(Discretisation, Run),
    coarse: &[(Discretisation, Run)],
    quantity: &Quantity,
) -> impl Fn(f64) -> [f64; 2] {
    let of = |other: &(Discretisation, Run)| {
        (element(&other.0) / element(&own.0), (value(own, quantity) - value(other, quantity)).abs())
    };
    let all: Vec<(f64, f64)> = coarse.iter().map(of).collect();
    move |order| {
        let each = || all.iter().map(|(ratio, apart)| apart / (ratio.powf(order) - 1.0));
        [each().fold(f64::INFINITY, f64::min), each().fold(0.0, f64::max)]
    }
}

#[test]
fn bars_are_what_their_formula_says_of_meshes_solved_here() {
    let rows = (0..=60).map(|k| f64::from(k) / 3.0).map(|s| format!("[{s}, {:e}]", s * s / 200.0));
    let by_points = format!("{{ table = [{}], smooth = true }}", rows.collect::<Vec<_>>().join(", "));
    let cusp = "{ powers = [[0.01, 2], [0.004, 1.5]] }";
    let block = |gap: &str| {
        let contact = format!("gap = {gap}\nstretch = 4\n[mesh]\nelements = 6\nper = 2.5");
        parsed(&block_text([0.0, 20.0], 20.0, "traction = { at = \"far\", value = [0, -300] }", &contact))
    };
    // What hides in a fourth difference, beyond that of a smooth top; what of the peak is a cusp, in E*.
    for (gap, smooth, cusp) in [("{ parabola = 100 }", 0.1, 0.0), (&by_points, 0.0, 0.0), (cusp, 0.1, 0.004)] {
        let case = block(gap);
        let own = to_the_last_digit((case.scene.clone(), case.resolution));
        let coarse: Vec<_> = coarser(&case.scene, case.resolution).into_iter().map(to_the_last_digit).collect();
        let at = |x: f64, y: f64| Displaced { body: 0, at: Place::Point([x, y]), component: Component::Y };
        let measures = own.1.measures();
        let bars = bars(&own.0, &own.1, &[at(18.0, 20.0), at(20.0, 0.0)]).expect("bars");
        let (size, width) = (element(&own.0), measures.second_moment_width);
        let (peak, rough) = (measures.peak.pressure, (measures.drawn.rough - smooth).max(0.0));
        let read = 1.8 * (measures.peak_by_parabola - peak).abs() + (measures.largest.pressure - 1.01 * peak).max(0.0);
        // c n (2 − n)/(n − 1) √(h/2) of n = 3/2.
        let cusp = cusp * 210e3 / 0.91 * 1.5 * (0.5 * size).sqrt();
        let moved = own.0.displacement_under(own.1.share(), &own.1.solution);
        let farthest = moved.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        let within = (size / width).powi(2);
        for (quantity, factor, hidden, rest) in [
            (Quantity::PeakPressure, 1.0, 0.0068 * within * peak, read + 0.3 * rough * peak + cusp),
            (Quantity::SecondMomentWidth, 1.0, 0.075 * within * width, 0.08 * rough * size),
            (Quantity::HalfWidth, 3.3, 0.0, 0.8 * rough * size),
            (Quantity::Displacement(at(18.0, 20.0)), 2.0, 0.0013 * within * farthest, 0.0),
            (Quantity::Displacement(at(20.0, 0.0)), 2.0, 0.0013 * within * farthest, 0.0),
        ] {
            let apart = apart(&own, &coarse, &quantity);
            // Within an edge of the corner at which a load ends, the order that is seen there.
            let spread = |order: f64| apart(order)[1] / apart(order)[0];
            let order = match quantity == Quantity::Displacement(at(18.0, 20.0)) {
                true => (0..=10).map(|k| 2.0 - 0.1 * f64::from(k)).min_by(|a, b| spread(*a).total_cmp(&spread(*b))),
                false => Some(2.0),
            };
            let told = factor * apart(order.expect("one"))[1] + hidden + rest;
            let least = if quantity == Quantity::HalfWidth { 0.05 * size } else { 0.0 };
            let bar = bars.of(0, &quantity).expect("a bar").mesh;
            assert!((bar - told.max(least)).abs() <= 1e-3 * bar, "{gap}, {quantity:?}: {bar:e} and {told:e}");
        }
    }
}

#[test]
fn end_that_mesh_lines_tell_may_be_missed_by_what_two_series_and_the_layers_leave() {
    let block = scene("pressed-corner", &[]).scene;
    let fitted = Fitted::of(Order::Quintic, 1);
    let answer = fitted.solve(&block, &Formulation::verification()).expect("solved");
    let own = (answer.discretisation, answer.run);
    // No finer mesh is allowed, and of the coarser ones of order 4 and more there is one.
    let Bars { all, meshes, .. } = bars_up_to(Some(own.1.dofs), None, &own.0, &own.1, &[]).expect("bars");
    assert_eq!(meshes, 1);
    let coarse: Vec<_> = coarser(&own.0.scene, own.0.resolution).into_iter().map(to_the_last_digit).collect();
    let (half_width, ends_apart) = (own.1.measures().half_width(), own.1.measures().ends_apart);
    let missed = ends_apart + (2e-6 * 100.0 + Fitted::misfit(Order::Quintic)) * half_width;
    let told = 2.4 * 3.3 * apart(&own, &coarse, &Quantity::HalfWidth)(2.0)[1] + missed;
    let bar = told_of(&all, &Quantity::HalfWidth).bar.mesh;
    assert!((bar - told).abs() <= 1e-3 * bar, "{bar:e} and {told:e}");
}

#[test]
fn place_of_a_peak_is_told_by_what_is_as_high_within_its_bar() {
    // Half of the bar below the top of an ellipse: a √(bar/p₀) away from it.
    let (mesh, run) = solved(&scene("pressed-corner", &[["elements = 4", "elements = 8"]]), &kinematic());
    let told = bars(&mesh, &run, &[]).expect("bars");
    let [peak, place] = [Quantity::PeakPressure, Quantity::PeakPlace].map(|one| told.of(0, &one).expect("a bar").mesh);
    let measures = run.measures();
    let away = measures.half_width() * (peak / measures.peak.pressure).sqrt();
    assert!((0.9 * away..1.5 * away).contains(&place), "{place} and {away}");
    // Candidates that are filled, with the peak in their middle.
    let contact = "gap = { parabola = 1e5 }\nstretch = 10\n[mesh]\nelements = 8\nper = 10";
    let full = parsed(&block_text([0.0, 10.0], 10.0, "traction = { at = \"far\", value = [0, -100] }", contact));
    let (mesh, run) = solved(&full, &kinematic());
    let told = bars(&mesh, &run, &[]).expect("bars");
    let place = told.of(0, &Quantity::PeakPlace).expect("a bar").mesh;
    assert!(run.measures().stretches[0].reaches[1] && place > 0.1, "{place}");
}

#[test]
fn a_bar_that_no_mesh_tells_says_so() {
    let (mesh, run) = solved(&scene("pressed-corner", &[]), &kinematic());
    let Bars { all, meshes, .. } = bars_up_to(Some(1), None, &mesh, &run, &[]).expect("bars");
    let peak = told_of(&all, &Quantity::PeakPressure);
    assert_eq!((meshes, peak.unknown), (0, Some("no coarser mesh of this scene holds the contact")));
}

#[test]
fn blocks_of_fewer_elements_grow_as_far_as_those_of_more() {
    let block = "{ blocks = [{ corners = [[0, 0], [10, 0], [10, 10], [0, 10]], elements = [8, 20], growth = [1.0, \
        1.3], bottom = \"contact\", top = \"far\", left = \"left\" }] }";
    let shape = "{ rectangle = { x = [0, 10], y = [0, 10], contact = \"bottom\" } }";
    let case = scene("pressed-corner", &[[shape, block], ["[mesh]\nelements = 4\nper = 1", ""]]);
    for (coarse, _) in coarser(&case.scene, case.resolution) {
        let Shape::Blocks(blocks) = &coarse.bodies[0].shape else { panic!("{:?}", coarse.bodies[0].shape) };
        let BlockShape { elements: [across, deep], growth: [along, depth], .. } = blocks[0];
        let over = depth.powi(deep as i32) / 1.3_f64.powi(20);
        assert!(deep < 20 && across < 8 && (along - 1.0).abs() <= 1e-12 && (over - 1.0).abs() <= 1e-9, "{blocks:?}");
    }
}
