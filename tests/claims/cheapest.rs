//! A search goes on where it pays, solves nothing twice, is bounded by `--max-dofs`, and tells of every mesh before it
//! is solved.

use std::sync::{LazyLock, Mutex};

use contact_vv::accuracy::{self, Answer, Asked, Next};
use contact_vv::case::library::{self, TruncatedHertz};
use contact_vv::error::Kind;
use contact_vv::measure::relative_error;
use contact_vv::mesh::Order;
use contact_vv::oracle::Quantity;
use contact_vv::scene::Scene;
use contact_vv::solve::{Element, Formulation, Iteration, Run};
use contact_vv::study::promised::met::Record;
use contact_vv::study::random::{Family, Sample, Site, family};

use crate::accuracy::error;
use crate::balance::scene;
use crate::outputs::{contact_vv, json};
use crate::program::Folder;
use crate::scene_file::case;
use crate::workbench::{kinematic, parsed};

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

/// The iteration of line elements ends by round-off before its last digit on meshes of some hundred elements: what they
/// find is the discrete solution all the same.
#[test]
fn line_elements_on_fine_meshes_tell_their_bars() {
    let text = "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
        shape = { rectangle = { x = [0, 5], y = [0, 5], contact = \"bottom\" } }\nsupports = [\
        { at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }, \
        { at = \"far\", component = \"x\" }, { at = \"far\", component = \"y\", value = -0.00485 }]\n\
        [contact]\nfirst = \"block\"\ngap = { circle = 166 }\nstretch = 1.3\n[mesh]\nelements = 10\nper = 1\n";
    let scene = parsed(text).scene;
    let answer = |formulation: &Formulation, asked: f64| {
        let answer = accuracy::solve(&scene, formulation, &Asked::new(asked)).expect("solved");
        assert_eq!(answer.unmet, None);
        answer
    };
    let line = Formulation { element: Element::Line, ..kinematic() };
    let (truth, found) = (answer(&kinematic(), 1e-4), answer(&line, 3e-3));
    let [wanted, found] = [truth, found].map(|answer| answer.run.measures().clone());
    assert!(relative_error(found.peak.pressure, wanted.peak.pressure) <= 3e-3, "{found:?}");
    assert!(relative_error(found.half_width(), wanted.half_width()) <= 3e-3, "{found:?}");
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
fn cells_of_8_nodes_are_given_up_where_those_of_high_order_leave_far_less() {
    let sample = Site { family: Family::Layer, number: family::FIRST + 200 }.sample().expect("a scene");
    let answer = accuracy::solve(&sample.scene, &kinematic(), &Asked::new(1e-6)).expect("solved");
    let said = answer.unmet.as_deref().expect("not met");
    assert!(said.starts_with("cells of high order leave less"), "{said}");
    // They went on to 1.4 million, and left a hundred times as much.
    assert!(answer.tried.iter().all(|tried| tried.dofs <= 300_000), "{:?}", answer.tried);
    assert!(answer.estimate() <= 5e-6);
}

/// The same scene to six digits, and to five by another order of cells.
#[test]
fn pin_in_a_rod_has_six_digits_that_another_mesh_finds_too() {
    let pin = library::find("pin-rod", None).expect("known");
    let [six, five] = [1e-6, 1e-5].map(|asked| {
        let answer = accuracy::solve(&pin.scene, &Formulation::verification(), &Asked::new(asked)).expect("solved");
        assert_eq!(answer.unmet, None);
        answer
    });
    assert!(six.run.dofs <= 30_000 && five.run.dofs <= 12_000, "{} and {}", six.run.dofs, five.run.dofs);
    for quantity in [Quantity::PeakPressure, Quantity::HalfWidth] {
        let [six, five] = [&six, &five].map(|answer| quantity.of(answer.run.measures()));
        assert!(relative_error(five, six) <= 1.1e-5, "{quantity:?}: {five} of {six}");
    }
}

#[test]
fn scenes_that_are_hard_are_met_by_few_dofs() {
    for (family, number, asked, most) in [
        // Three coarse meshes agree by accident.
        (Family::Cosine, 41, 1e-3, usize::MAX),
        // 8-node cells took 48,325 dofs, and cells of high order across the leap of the curvature do not converge.
        (Family::Wedge, 90_002, 3e-4, 8_000),
        // Contacts of several bodies: 8-node cells took 61,361 dofs in the middle of such scenes.
        (Family::Pair, 90_002, 1e-3, 8_000),
    ] {
        let site = Site { family, number };
        let sample = site.sample().expect("a scene");
        let answer = accuracy::solve(&sample.scene, &kinematic(), &Asked::new(asked)).expect("solved");
        let found = Record::of(&site, asked, &sample, &answer);
        assert!(found.met && !found.is_falsely_met() && found.dofs <= most, "{found:?}");
        // An arc that goes over into a line has a mesh line there.
        let fitted = || answer.resolution.order > Order::Quadratic && answer.scene.contact().leaps().len() == 1;
        assert!(family != Family::Wedge || fitted(), "{:?}", answer.resolution);
    }
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

/// A face that stays straight under a force is one that a support pushes as far: both have a corner towards the free
/// side.
#[test]
fn a_straight_face_that_does_not_slide_has_the_corners_of_a_held_side() {
    let text = |pushed: &str| {
        format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"up\"\nyoung = 1000\npoisson = 0.34\n\
             shape = {{ rectangle = {{ x = [0, 10], y = [0, 6.4467], contact = \"bottom\" }} }}\n{pushed}\n\
             [contact]\nfirst = \"up\"\ngap = {{ parabola = 902.5 }}\nstretch = 9.5\nsymmetric = true\n\
             [mesh]\nelements = 20\nper = 4\n[reference]\nlength = 4\n"
        )
    };
    let held = "{ at = \"far\", component = \"x\" }, { at = \"left\", component = \"x\" }";
    let answered =
        |pushed: &str| accuracy::solve(&parsed(&text(pushed)).scene, &kinematic(), &Asked::new(1e-5)).expect("solved");
    let by_force = answered(&format!(
        "supports = [{held}]\nloads = [{{ rigid-face = {{ at = \"far\", component = \"y\", force = -34 }} }}]"
    ));
    let own = by_force.discretisation.as_ref().expect("held");
    let node = own.mesh.points.iter().position(|at| *at == [0.0, 6.4467]).expect("a corner");
    let value = own.displacement_under(1.0, &by_force.run.solution)[node][1];
    let by_support = answered(&format!("supports = [{held}, {{ at = \"far\", component = \"y\", value = {value} }}]"));
    for (one, other) in by_force.estimates.iter().zip(&by_support.estimates) {
        let bars = one.bar.total() + other.bar.total();
        assert!((one.value - other.value).abs() <= bars, "{one:?} beside {other:?}");
        assert!(bars <= 2e-5 * one.value, "{one:?} beside {other:?}");
    }
}

/// What was too coarse by the bars that the next mesh told is good enough by the distance from a finer one.
#[test]
fn mesh_that_a_finer_one_shows_to_be_good_enough_is_answered() {
    for (family, asked, most) in [
        (Family::Wedge, 1e-2, 1_000),
        (Family::Wedge, 1e-3, 2_000),
        (Family::Skew, 1e-2, 3_000),
        (Family::Skew, 1e-3, 5_000),
        (Family::Skew, 1e-4, 7_000),
    ] {
        let site = Site { family, number: family::FIRST + 1 };
        let sample = site.sample().expect("a scene");
        let answer = accuracy::solve(&sample.scene, &Formulation::verification(), &Asked::new(asked)).expect("solved");
        let record = Record::of(&site, asked, &sample, &answer);
        assert!(record.met && !record.is_falsely_met() && record.error() <= answer.estimate(), "{record:?}");
        let (judge, last) = (&answer.judge.as_ref().expect("held").1, answer.tried.last().expect("solved"));
        assert!(judge.dofs < last.dofs && record.dofs <= most, "{} of {}, {record:?}", judge.dofs, last.dofs);
    }
}

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
        let truth = Quantity::ASKED.map(|quantity| hertz.reading(0, &quantity).value);
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
fn every_mesh_is_as_much_finer_as_the_bars_before_it_ask_for_and_those_are_told() {
    let hertz = TruncatedHertz::default().case().scene;
    let told = Mutex::new(Vec::new());
    let tell = |next: &Next| told.lock().expect("nobody panicked").push((next.dofs, next.estimate));
    let asked = Asked { high_order: false, ..Asked::new(1.5e-3) };
    let answer = accuracy::solve_telling(&hertz, &kinematic(), &asked, &tell).expect("solved");
    let told = told.into_inner().expect("nobody panicked");
    let meshes: Vec<_> = answer.tried.iter().filter(|tried| tried.purpose == "mesh").collect();
    assert!(answer.unmet.is_none() && meshes.len() > 2, "{meshes:?}");
    // The first has 0.2/√error elements in the contact; bars fall with them to the power of 1.7, and none is more than
    // 2.5 times as fine.
    let (mut elements, mut by_bars) = ((0.2 / 1.5e-3_f64.sqrt()).ceil(), 0);
    for (k, mesh) in meshes.iter().enumerate() {
        // One that is hardly pressed is counted as well.
        assert!((mesh.elements as f64 - elements).abs() <= 1.0, "{elements}: {mesh:?}");
        let finer = (mesh.estimate / 1.5e-3).powf(1.0 / 1.7);
        by_bars += usize::from((1.2..2.4).contains(&finer));
        elements = (elements * finer.clamp(1.15, 2.5)).ceil();
        let (_, estimate) = told.iter().find(|(dofs, _)| *dofs == mesh.dofs).expect("told");
        assert!(k == 0 || (estimate - meshes[k - 1].estimate).abs() <= 0.0, "{estimate} before {mesh:?}");
    }
    assert!(by_bars > 0, "{meshes:?}");
    // The first mesh with bars would have 0.2/√(1e-4) elements: a quarter of them are few enough.
    let few = Asked { most_cells: 300.0, relative: 1e-4, ..asked };
    let answer = accuracy::solve(&hertz, &kinematic(), &few).expect("solved");
    let first = answer.tried.iter().find(|tried| tried.purpose == "mesh").expect("one");
    assert!([5, 6].contains(&first.elements), "{first:?}");
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

#[test]
fn corners_of_a_held_side_are_resolved_and_tighter_answers_lie_within_the_bars_of_others() {
    let scene = scene("rubber-cup", &[]).scene;
    let found = |asked: f64| {
        let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(asked)).expect("solved");
        assert!(answer.unmet.is_none() && answer.run.dofs <= 15_000, "{:?}: {}", answer.unmet, answer.run.dofs);
        answer.estimates
    };
    let [coarse, fine] = [3e-4, 5e-5].map(found);
    assert_eq!(coarse.len(), 2);
    for (coarse, fine) in coarse.iter().zip(&fine) {
        let (off, bars) = ((coarse.value - fine.value).abs(), coarse.bar.total() + fine.bar.total());
        assert!(off <= bars, "{}: {off:e} of {bars:e}", fine.quantity.key());
    }
}

#[test]
fn plates_pressed_in_part_take_few_freedoms() {
    // Without layers towards the ends of the pressure the first took 219,000, and the second more than a minute.
    for part in ["from = 0, to = 5", "from = 10, to = 13"] {
        let plate = scene("plate-pressed-in-part", &[["from = 0, to = 5", part]]).scene;
        let answer = accuracy::solve(&plate, &Formulation::verification(), &Asked::new(1e-4)).expect("solved");
        assert!(answer.unmet.is_none() && answer.run.dofs <= 20_000, "{:?}: {}", answer.unmet, answer.run.dofs);
    }
}

#[test]
fn a_higher_order_is_tried_before_8_node_cells_whatever_is_asked() {
    // On an annulus the order after that whose bar hardly falls has a thousandth of it.
    let powers = "powers = [[0.0001, 2.0], [0.002, 6.0]]";
    let found = |gap: &str| {
        let scene = scene("annulus", &[[powers, gap]]).scene;
        accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-4)).expect("solved")
    };
    let answer = found(powers);
    assert!(answer.unmet.is_none() && answer.run.dofs <= 6_000, "{:?}: {}", answer.unmet, answer.run.dofs);
    // By w = ∫ g'(r) / √(a² − r²) dr: F = 2 E* (4 c a³ / 3 + 96 d a⁷ / 35), with g = c r² + d r⁶.
    let radius = answer.run.measures().half_width();
    let [modulus, a] = [3.0 / (1.0 - 0.49 * 0.49), radius];
    let force = 2.0 * modulus * (4.0 / 3.0 * 1e-4 * a.powi(3) + 96.0 / 35.0 * 2e-3 * a.powi(7));
    assert!(relative_error(force, 0.0058011) <= 3e-3, "{force}");
    let answer = found("wedge = 0.003");
    let said = answer.unmet.as_deref().expect("not met");
    assert!(said.contains("no limit") && answer.tried.iter().all(|tried| tried.dofs <= 6_000), "{said}");
}

/// Without an end that cells hide, coarse meshes tell what is met: looked at on as many elements as the accuracy asks
/// for elsewhere, these took 76,125, 66,400 and 206,552 dofs.
#[test]
fn contacts_without_an_end_are_answered_as_coarse_as_their_bars_allow() {
    for (file, most) in [("eccentric-load", 500), ("press-fit", 16_000), ("three-rings", 45_000)] {
        let scene = case(file).scene;
        let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-6)).expect("solved");
        assert!(answer.unmet.is_none() && answer.run.dofs <= most, "{file}: {:?}, {}", answer.unmet, answer.run.dofs);
    }
}

/// Three rollers under a plate: cells of order 8 were given up at 27,521 dofs, for 8-node cells of 1.3 million that did
/// not meet it either.
#[test]
fn rows_of_contacts_are_met_to_a_millionth() {
    let row = [-40.0, 0.0, 40.0].map(|x| {
        format!(
            "[[contact]]\nname = \"at {x}\"\nfirst = \"plate\"\norigin = [{x}, 0]\nboth-sides = true\ngap = {{ \
            parabola = 25 }}\nstretch = 1\n"
        )
    });
    let plate = "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"plate\"\nyoung = 70e3\npoisson = 0.33\n\
        shape = { rectangle = { x = [-60, 60], y = [0, 20], contact = \"bottom\" } }\n\
        supports = [{ at = [-60, 20], component = \"x\" }]\nloads = [{ traction = { at = \"far\", force = [0, -1500] } \
        }]\n";
    let scene = parsed(&format!("{plate}{}[mesh]\nelements = 12\nper = 1\n", row.concat())).scene;
    let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-6)).expect("solved");
    assert!(answer.unmet.is_none(), "{:?}", answer.unmet);
    assert!(answer.tried.iter().all(|tried| tried.dofs <= 100_000), "{:?}", answer.tried);
}

/// The mesh answered and the one that judges it are held for what is read of them afterwards.
#[test]
fn the_mesh_answered_and_the_one_that_judges_it_are_solved_once() {
    let case = library::find("truncated-hertz", None).expect("known");
    let answer = accuracy::solve(&case.scene, &Formulation::verification(), &Asked::new(1e-3)).expect("solved");
    let own = answer.discretisation.as_ref().expect("held");
    assert_eq!((own.resolution, own.system.dofs()), (answer.resolution, answer.run.dofs));
    let (finer, judge) = answer.judge.as_ref().expect("held");
    let last = answer.tried.last().expect("solved");
    assert_eq!((finer.system.dofs(), judge.dofs), (last.dofs, last.dofs));
    // From the contact that the cheap mesh shows.
    let first = answer.tried.iter().find(|tried| tried.purpose == "order").expect("solved");
    let cold = Run::of(own, &answer.run.formulation).expect("solved").solution.work.iterations;
    assert!(first.iterations < cold, "{} of {cold}", first.iterations);
}
