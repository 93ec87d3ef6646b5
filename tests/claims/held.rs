//! Bodies that are held at corners, at points and by two supports at a node: what each support takes, and how well that
//! is known.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use contact_vv::accuracy::{self, Asked, Barred, Quantity, bars};
use contact_vv::case::Case;
use contact_vv::mesh::Order;
use contact_vv::scene::{Component, Place};
use contact_vv::solve::{Displaced, Fitted};

use crate::balance::{self, solved_as_it_says};
use crate::workbench::{kinematic, parsed};

/// A scene of one body under a pressure of 10 MPa, or as it is loaded, on a rigid profile.
fn scene(body: &str, contact: &str, mesh: &str) -> Case {
    parsed(&format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"b\"\n{body}\n[contact]\nfirst = \
        \"b\"\n{contact}\n[reference]\npressure = 10\n\
         [mesh]\n{mesh}\n[solve]\ntolerance = 1e-8\n"
    ))
}

/// The numbers of a case on its own mesh with their bars, the displacements of a side among them.
fn barred(case: &Case, side: &str) -> Vec<Barred> {
    let (discretisation, run) = solved_as_it_says(case);
    let of = |component| Displaced { body: 0, at: Place::Boundary(side.to_owned().into()), component };
    let wanted = [Component::X, Component::Y].map(of);
    bars(&discretisation, &run, &wanted).expect("bars").all
}

/// Walls on both sides and a far side that cannot slide: both hold the node where they meet, and no shear acts on
/// either.
#[test]
fn a_node_that_two_supports_hold_leans_on_the_one_that_faces_it_whichever_is_listed_first() {
    for supports in [["left", "right", "far"], ["far", "right", "left"]] {
        let listed = supports.map(|at| format!("{{ at = \"{at}\", component = \"x\" }}")).join(", ");
        let body = format!(
            "young = 1000\npoisson = 0.3\nshape = {{ rectangle = {{ x = [0, 10], y = [0, 10], contact = \"bottom\" }} \
            }}\n\
             supports = [{listed}]\nloads = [{{ traction = {{ at = \"far\", value = [0, -10] }} }}]"
        );
        for elements in [3, 8] {
            let mesh = format!("elements = {elements}\nper = 10");
            let (discretisation, run) = solved_as_it_says(&scene(&body, "gap = { uniform = 0 }\nstretch = 10", &mesh));
            let reactions = discretisation.reactions(1.0, &run.solution).expect("recovered");
            let of = |name: &str| reactions[supports.iter().position(|at| *at == name).expect("held")].force;
            // ν/(1−ν) p H, pushed inwards.
            assert_relative_eq!(of("left"), 0.3 / 0.7 * 100.0, max_relative = 1e-7);
            assert_relative_eq!(of("right"), 0.3 / -0.7 * 100.0, max_relative = 1e-7);
            assert!(of("far").abs() <= 1e-5, "{supports:?}, {elements}: {}", of("far"));
        }
    }
}

/// Candidates that end before the body does are fewer than its cells, though these lie in one row.
#[test]
fn a_layer_of_one_row_of_cells_has_no_bars_however_far_it_goes_beyond_the_candidates() {
    let body = "young = 60e3\npoisson = 0.38\nshape = { rectangle = { x = [0, 33], y = [0, 1], contact = \"bottom\" } \
        }\n\
                supports = [{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"x\" }]\n\
                loads = [{ rigid-face = { at = \"far\", component = \"y\", force = -216 } }]";
    let contact = "gap = { parabola = 2e5 }\nstretch = 28";
    let growth = "growth = { along = 1.2, depth = 1.2, coarsest = 1.0 }";
    let all = barred(&scene(body, contact, &format!("elements = 16\nper = 13.5\n{growth}")), "far");
    let peak = balance::told_of(&all, &Quantity::PeakPressure);
    assert!(peak.bar.total().is_nan(), "{peak:?}");
}

/// Where a side that is held meets a free one displacements converge as the stresses there have it, and not with the
/// order of the cells.
#[test]
fn bars_of_reactions_and_displacements_hold_where_a_body_is_clamped_beside_a_free_side() {
    let case = balance::scene("clamped-beside-a-free-side", &[]);
    let all = barred(&case, "far");
    // By cells of order 4 and by graded ones of order 2: -0.189711 and -0.189716 mm, 86.1322 and 86.1325 N.
    let told = |wanted: &dyn Fn(&Quantity) -> bool, truth: f64| {
        let one = all.iter().find(|one| wanted(&one.quantity)).expect("told");
        let bar = one.bar.total();
        assert!((one.value - truth).abs() <= 2.0 * bar && bar <= 0.05 * truth.abs(), "{one:?}");
    };
    told(&|one| matches!(one, Quantity::Displacement(of) if of.component == Component::Y), -0.189715);
    told(&|one| matches!(one, Quantity::Reaction { body: 1, support: 1 }), 86.133);
}

/// A block that is held at a point of its far side, by which a contact nearly begins, and one whose coarse mesh reads
/// the begin at 0.
#[test]
fn contacts_that_begin_beside_the_origin_are_fitted_to_where_they_begin() {
    let beside = |slope: f64| {
        let body = format!(
            "young = 210e3\npoisson = 0.3\nshape = {{ rectangle = {{ x = [-80, 80], y = [0, 80], contact = \"bottom\" \
            }} }}\n\
             supports = [{{ at = [0, 80], component = \"x\" }}]\n\
             loads = [{{ pressure = {{ at = \"far\", law = {{ polynomial = {{ along = \"x\", coefficients = [40, \
             {slope}] }} }} }} }}]"
        );
        scene(&body, "both-sides = true\ngap = { parabola = 500 }\nstretch = 14", "elements = 8\nper = 3")
    };
    // Hertz of the same force, rolled aside: the half-width is that of no moment, but for the block's size.
    let hertz = (4.0 * 40.0 * 160.0 * 500.0 / (PI * 210e3 / (1.0 - 0.09))).sqrt();
    let begin = |slope: f64, order| {
        let case = beside(slope);
        let answer = Fitted::of(order, 3).solve(&case.scene, &kinematic()).expect("solved");
        let measures = &answer.run.contacts[0].measures;
        (measures.begin(), measures.half_width())
    };
    for slope in [0.07839086380980628, 0.0782] {
        let [seven, eight] = [Order::Septic, Order::Octic].map(|order| begin(slope, order));
        assert!((seven.0 - eight.0).abs() <= 1e-4 && (seven.1 - eight.1).abs() <= 1e-4, "{seven:?}, {eight:?}");
        assert!((eight.1 / hertz - 1.0).abs() <= 2e-3, "{eight:?}");
    }
}

/// Two rectangles that touch beside their symmetry line.
#[test]
fn a_contact_that_begins_near_its_symmetry_line_is_not_met_as_one_that_begins_on_it() {
    let case = balance::scene("beside-its-line", &[]);
    // By order 8, and unfitted on 32 elements: 1.80865 and 1.797.
    for asked in [3e-2, 1e-2] {
        let answer = accuracy::solve(&case.scene, &kinematic(), &Asked::new(asked)).expect("solved");
        let half_width = answer.run.contacts[0].measures.half_width();
        assert!(answer.unmet.is_none() && (half_width / 1.80865 - 1.0).abs() <= asked, "{asked}: {half_width}");
    }
}

/// Whether the bar of a number of a case on its own mesh reaches the truth, and is itself no larger than a part of it.
fn reaches(case: &Case, quantity: &Quantity, truth: f64, part: f64) -> bool {
    let (discretisation, run) = solved_as_it_says(case);
    let all = bars(&discretisation, &run, &[]).expect("bars").all;
    let found = all.iter().find(|one| one.quantity == *quantity).expect("the number");
    (found.value - truth).abs() <= found.bar.total() && found.bar.total() <= part * truth
}

/// A disc and a ball weigh what their volume does; the cells far from the contact are chords on every mesh that its own
/// is compared with.
#[test]
fn own_weight_of_round_bodies_is_within_its_bar() {
    let of = |plane: &str, thickness: &str, weight: f64, order: usize| {
        parsed(&format!(
            "plane = \"{plane}\"\n{thickness}[[body]]\nname = \"b\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ disc = {{ centre = [0, 50], radius = 50, half = true }} }}\nsupports = [{{ at = \"axis\", \
             component = \"x\" }}]\n\
             loads = [{{ body-force = [0, {}] }}]\n[contact]\nfirst = \"b\"\ngap = {{ circle = 50 }}\nstretch = 2\n\
             [mesh]\nelements = 12\nper = 1\norder = {order}\n[reference]\nlength = 1\n[solve]\ntolerance = 1e-9\n",
            0.0 - weight
        ))
    };
    let [of_disc, of_ball] = [2000.0, 20_000.0];
    for (plane, thickness, force, volume, part) in [
        ("strain", "thickness = 1\n", of_disc, PI * 2500.0, [0.1, 1e-3]),
        ("axisymmetric", "", of_ball, 4.0 / 3.0 * PI * 125e3, [0.2, 2e-3]),
    ] {
        for (order, part) in [1, 2].into_iter().zip(part) {
            let case = of(plane, thickness, force / volume, order);
            assert!(reaches(&case, &Quantity::Resultant, force, part), "{plane}, order {order}");
        }
    }
}

/// Westergaard's wave a ten-thousandth before it is pressed flat, as it is, and beyond: near where it ends it presses
/// by less than what counts.
#[test]
fn a_contact_that_fades_out_ends_within_its_bar() {
    let (modulus, wavelength, amplitude) = (70e3 / (1.0 - 0.33 * 0.33), 20.0, 0.01);
    let flat = PI * modulus * amplitude / wavelength;
    for share in [0.9999, 1.0, 1.0001] {
        let pressure = share * flat;
        let body = format!(
            "young = 70e3\npoisson = 0.33\nshape = {{ rectangle = {{ x = [0, 10], y = [0, 60], contact = \"bottom\" }} \
            }}\n\
             supports = [{{ at = \"left\", component = \"x\" }}, {{ at = \"right\", component = \"x\" }}]\n\
             loads = [{{ pressure = {{ at = \"far\", law = {{ uniform = {pressure} }} }} }}]"
        );
        let contact = "symmetric = true\ngap = { cosine = { amplitude = 0.01, wavelength = 20 } }\nstretch = 10";
        let half_width = wavelength / PI * f64::min(share, 1.0).sqrt().asin();
        for elements in [16, 256] {
            let case = scene(&body, contact, &format!("elements = {elements}\nper = 10"));
            assert!(reaches(&case, &Quantity::HalfWidth, half_width, 0.15), "{share}, {elements}");
        }
    }
}
