//! Several contacts in one scene: each is what it would be alone where they do not meet, and all of them balance.

use std::path::Path;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::ContactProblem;
use contact_vv::case::notes;
use contact_vv::case::{Against, Case, Check, Quantity, Verdict};
use contact_vv::condensation::stiffness::Stiffness;
use contact_vv::measure::Measures;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::size::{cells_of, expected};
use contact_vv::solution::Work;
use contact_vv::solve::{Change, Discretisation, Element, Formulation, Iteration, Origin, Run};

use crate::outputs::{contact_vv, scene};
use crate::scene_file::text_of;
use crate::shared_mesh::between_punches;
use crate::workbench::parsed;

fn discretised(file: &Case) -> Discretisation {
    Discretisation::of(file.scene.clone(), file.resolution).expect("discretised")
}

/// Three blocks one on another, 20 wide, pressed by 100 MPa; the middle one of another material and `density`.
fn stack(order: u8, density: &str) -> String {
    let body = |name: &str, y: [i32; 2], side: &str, more: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nshape = {{ rectangle = {{ x = [0, 20], y = {y:?}, contact = \"{side}\" }} }}\n{more}\n"
        )
    };
    let contact = |first: &str, second: &str, y: i32| {
        format!(
            "[[contact]]\nfirst = \"{first}\"\nsecond = \"{second}\"\norigin = [0, {y}]\ngap = {{ uniform = 0 }}\nstretch = 20\n"
        )
    };
    let steel = "young = 210e3\npoisson = 0.3\nsupports = [{ at = \"left\", component = \"x\" }";
    let middle = format!("density = {density}\n{}]", steel.replace("210e3", "70e3").replace("0.3", "0.33"));
    let lower = format!("{steel}, {{ at = \"far\", component = \"y\" }}]");
    [
        "plane = \"strain\"\nthickness = 1.0\n".into(),
        body(
            "upper",
            [20, 30],
            "bottom",
            &format!("{steel}]\nloads = [{{ traction = {{ at = \"far\", value = [0, -100] }} }}]"),
        ),
        body("middle", [10, 20], "top", &middle),
        body("lower", [0, 10], "top", &lower),
        contact("upper", "middle", 20),
        contact("middle", "lower", 10) + "first-side = \"far\"\n",
        format!(
            "[mesh]\nelements = 5\nper = 20\norder = {order}\n[reference]\npressure = 100\n[solve]\ntolerance = 1e-8\n"
        ),
    ]
    .concat()
}

#[test]
fn profile_of_a_contact_is_held_against_its_own_closed_form() {
    let mut case = parsed(&text_of("roller-between-plates.toml"));
    case.oracles[0] = None;
    let of_second = |quantity| Check { contact: 1, ..Check::error(quantity, Against::Oracle, 0.1, "the mesh") };
    case.checks = vec![of_second(Quantity::Profile), of_second(Quantity::Departure)];
    let (meshed, run) = case.solve().expect("a run");
    for one in case.own(&meshed.discretisation, &run).expect("judged") {
        assert_eq!((&one.verdict, one.reference.name.as_str()), (&Verdict::Pass, "Hertz"), "{one:?}");
    }
}

#[test]
fn stack_of_blocks_carries_one_pressure_through_both_contacts() {
    for (order, density) in [(1, "1.0"), (2, "1.0"), (2, "1.6")] {
        let file = parsed(&stack(order, density));
        let discretisation = discretised(&file);
        // Where nodes do not face one another the node element is the one to take.
        let serves = |formulation: &Formulation| density == "1.0" || formulation.element == Element::Node;
        for formulation in Formulation::nine().into_iter().filter(serves) {
            // Secant springs end at the stiffest, 1e6 E*/l.
            let formulation = formulation.tolerance(1e-5);
            let run = Run::of(&discretisation, &formulation).expect("run");
            assert!(run.solution.converged(), "{}", formulation.name());
            for (contact, found) in run.contacts.iter().enumerate() {
                for point in run.solution.points_of(contact) {
                    assert_relative_eq!(point.pressure, 100.0, max_relative = 1e-5);
                }
                assert_relative_eq!(found.transmitted, 4000.0, max_relative = 1e-5);
                assert!(notes::of(&run, contact).is_empty());
            }
        }
    }
}

/// Bodies, contact and the rest of a disc in a contact about `x`, on a block of its own where one is named.
fn roller(name: &str, x: f64, load: f64, young: f64) -> [String; 2] {
    let body = format!(
        "[[body]]\nname = \"{name}\"\nyoung = {young}\npoisson = 0.3\n\
         shape = {{ disc = {{ centre = [{x}, 50], radius = 50 }} }}\n\
         supports = [{{ at = [{x}, 50], component = \"x\" }}]\n\
         loads = [{{ traction = {{ at = \"cut\", value = [0, {load}] }} }}]\n"
    );
    let contact = format!(
        "[[contact]]\nname = \"below {name}\"\nfirst = \"{name}\"\norigin = [{x}, 0]\nboth-sides = true\n\
         gap = {{ circle = 50 }}\nstretch = 2.5\n"
    );
    [body, contact]
}

fn of_parts(parts: &[[String; 2]]) -> Case {
    let bodies: String = parts.iter().map(|[body, _]| body.as_str()).collect();
    let contacts: String = parts.iter().map(|[_, contact]| contact.as_str()).collect();
    let text = format!(
        "plane = \"strain\"\nthickness = 1.0\n{bodies}{contacts}[mesh]\nelements = 6\nper = 1.6\n\
         [reference]\nlength = 1.5\npressure = 1500\n[solve]\ntolerance = 1e-10\n"
    );
    parsed(&text)
}

#[test]
fn contacts_that_do_not_meet_are_what_each_is_alone() {
    let parts = [roller("one", -70.0, -30.0, 210e3), roller("other", 55.0, -18.0, 120e3)];
    let alone = parts.clone().map(|part| of_parts(&[part]));
    for formulation in Formulation::nine() {
        let formulation = formulation.tolerance(1e-8);
        let both = Run::of(&discretised(&of_parts(&parts)), &formulation).expect("both");
        for (contact, file) in alone.iter().enumerate() {
            let single = Run::of(&discretised(file), &formulation).expect("alone");
            let [together, apart] = [both.solution.points_of(contact), single.solution.points_of(0)];
            assert_eq!(together.len(), apart.len());
            let peak = single.measures().peak.pressure;
            // Iterations stop when the slower contact has converged.
            let accepted = if formulation.algorithm.name() == "kinematic" { 1e-8 } else { 2e-5 };
            for (a, b) in together.iter().zip(apart) {
                assert_abs_diff_eq!(a.position, b.position, epsilon = 1e-11);
                assert_abs_diff_eq!(a.pressure, b.pressure, epsilon = accepted * peak);
            }
            assert_relative_eq!(both.contacts[contact].transmitted, single.transmitted(), max_relative = 1e-6);
            let [edges, own] = [both.solution.edges_of(contact), single.solution.edges_of(0)];
            assert_eq!(edges.len(), own.len());
            for (a, b) in edges.iter().zip(own) {
                assert_abs_diff_eq!(a.pressure, b.pressure, epsilon = accepted * peak);
            }
        }
    }
}

#[test]
fn scene_moved_with_its_origin_has_the_same_pressures() {
    let at = |x: f64, y: f64, both: bool, gap: &str| {
        let (from, reach) = if both { (x - 20.0, "both-sides = true") } else { (x, "") };
        let held = format!("[{from}, {}]", y + 20.0);
        let text = format!(
            "plane = \"strain\"\nthickness = 1.0\n[[body]]\nname = \"block\"\nyoung = 70e3\npoisson = 0.3\n\
             shape = {{ rectangle = {{ x = [{from}, {}], y = [{y}, {}], contact = \"bottom\" }} }}\n\
             supports = [{{ at = {held}, component = \"x\" }}]\n\
             loads = [{{ rigid-face = {{ at = \"far\", component = \"y\", force = -900 }} }}]\n\
             [contact]\nfirst = \"block\"\norigin = [{x}, {y}]\n{reach}\ngap = {gap}\nstretch = 4\n\
             [mesh]\nelements = 6\nper = 2\n[reference]\npressure = 300\n[solve]\ntolerance = 1e-9\n",
            x + 20.0,
            y + 20.0
        );
        let file = parsed(&text);
        Run::of(&discretised(&file), file.formulation()).expect("run")
    };
    for both in [false, true] {
        for gap in ["{ parabola = 300 }", "{ wedge = 0.02 }"] {
            let [here, there] = [at(0.0, 0.0, both, gap), at(-37.0, 11.0, both, gap)];
            let peak = here.measures().peak.pressure;
            assert_eq!(here.solution.points.len(), there.solution.points.len());
            for (a, b) in here.solution.points.iter().zip(&there.solution.points) {
                assert_abs_diff_eq!(a.position, b.position, epsilon = 1e-12);
                assert_abs_diff_eq!(a.pressure, b.pressure, epsilon = 1e-9 * peak);
            }
        }
    }
}

#[test]
fn carried_sets_and_another_load_keep_the_contacts_apart() {
    let file = parsed(&text_of("roller-between-plates.toml"));
    let discretisation = discretised(&file);
    let formulation = Formulation::verification();
    let run = Run::of(&discretisation, &formulation).expect("run");
    let same = |solution: &contact_vv::solution::Solution| {
        for (own, other) in solution.contacts.iter().zip(&run.solution.contacts) {
            assert_eq!((&own.points, &own.edges), (&other.points, &other.edges));
        }
        assert_eq!(solution.contacts.len(), run.solution.contacts.len());
        for (a, b) in solution.points.iter().zip(&run.solution.points) {
            assert_abs_diff_eq!(a.pressure, b.pressure, epsilon = 1e-5);
        }
    };
    // The set is at hand: an iteration that confirms it, or two.
    let carried = discretisation.solve_from(Origin::From(&run.solution), &formulation, Change::NONE).expect("carried");
    same(&carried);
    assert!(carried.work.iterations < run.solution.work.iterations, "{} iterations", carried.work.iterations);
    let again = discretisation.solve_from(Origin::From(&run.solution), &formulation, Change::NONE).expect("again");
    same(&again);
    assert!(again.work.iterations <= 2, "{} iterations", again.work.iterations);
}

#[test]
fn contact_off_the_symmetry_line_counts_twice_where_it_is_said() {
    // A half plate on a support in the middle and on one of two beside it; 1000 on the half.
    let text = |symmetric: &str| {
        format!(
            "plane = \"strain\"\nthickness = 1.0\n[[body]]\nname = \"plate\"\nyoung = 70e3\npoisson = 0.33\n\
             shape = {{ rectangle = {{ x = [0, 30], y = [0, 20], contact = \"bottom\" }} }}\n\
             supports = [{{ at = \"left\", component = \"x\" }}]\n\
             loads = [{{ rigid-face = {{ at = \"far\", component = \"y\", force = -1000 }} }}]\n\
             [[contact]]\nname = \"middle\"\nfirst = \"plate\"\ngap = {{ parabola = 50 }}\nstretch = 2\n\
             [[contact]]\nname = \"beside\"\nfirst = \"plate\"\norigin = [15, 0]\nboth-sides = true\n{symmetric}\
             gap = {{ parabola = 50 }}\nstretch = 2\n[mesh]\nelements = 8\nper = 1\n[reference]\npressure = 600\n\
             [solve]\ntolerance = 1e-8\n"
        )
    };
    let forces = |symmetric: &str| {
        let file = parsed(&text(symmetric));
        let (meshed, run) = file.solve().expect("solved");
        let checks = file.judge(&meshed, &run).expect("judged");
        assert!(checks.iter().all(|check| check.verdict == Verdict::Pass));
        [run.contacts[0].transmitted, run.contacts[1].transmitted]
    };
    let ([middle, beside], [same, twice]) = (forces(""), forces("symmetric = true\n"));
    assert_relative_eq!(0.5 * middle + beside, 1000.0, max_relative = 1e-7);
    assert_relative_eq!(same, middle, max_relative = 1e-9);
    assert_relative_eq!(twice, 2.0 * beside, max_relative = 1e-9);
}

#[test]
fn weak_contact_beside_a_strong_one_is_converged_on_its_own_scale() {
    let parts = [roller("strong", -70.0, -30.0, 210e3), roller("weak", 70.0, -0.003, 5.0)];
    let file = of_parts(&parts);
    let at =
        |tolerance: f64| Run::of(&discretised(&file), &Formulation::verification().tolerance(tolerance)).expect("run");
    let (coarse, fine) = (at(1e-3), at(1e-9));
    // The strong one carries ten thousand times as much.
    let error =
        |of: fn(&Measures) -> f64| (of(&coarse.contacts[1].measures) / of(&fine.contacts[1].measures) - 1.0).abs();
    for error in [error(|weak| weak.peak.pressure), error(|weak| weak.second_moment_width)] {
        assert!(error <= 1e-3, "{error:e}");
    }
    for run in [coarse, fine] {
        assert!(run.solution.converged() && notes::of(&run, 0).is_empty() && notes::of(&run, 1).is_empty());
        let weak = &run.contacts[1];
        assert!(weak.measures.active > 10, "{} active points", weak.measures.active);
        assert_relative_eq!(weak.transmitted, 0.3, max_relative = 1e-2);
    }
}

#[test]
fn interference_that_nothing_opposes_presses_nothing() {
    // Both walls to the same side: the block steps back.
    let text = between_punches([0.0, 0.0], [3.0, 3.0], "1.7").replace("loads = [{ body-force = [0, -1] }]\n", "");
    let open = text.replacen("gap = { parabola = 80 }", "gap = { uniform = -0.01 }", 1);
    let open = open.replacen("gap = { parabola = 80 }", "gap = { uniform = 0.03 }", 1);
    let error = parsed(&open).solve().map(|_| ()).expect_err("free").to_string();
    assert!(error.contains("nothing presses"), "{error}");
}

#[test]
fn slab_wedged_between_walls_carries_its_compression_however_the_interference_is_shared() {
    // No load, no support along y: σ = E/(1 − ν²) (i₁ + i₂)/H in plane strain with free sides.
    let exact = 210e3 / (1.0 - 0.09) * 0.02 / 30.0;
    let slab = between_punches([0.0, 0.0], [40.0, 40.0], "1.0").replace("loads = [{ body-force = [0, -1] }]\n", "");
    for [below, above] in [[0.01, 0.01], [0.02, 0.0], [0.025, -0.005]] {
        let text = slab.replacen("parabola = 80", &format!("uniform = {}", -below), 1);
        let text =
            text.replacen("parabola = 80", &format!("uniform = {}", -above), 1).replace("per = 1\n", "per = 10\n");
        let file = parsed(&text);
        let run = Run::of(&discretised(&file), &Formulation::verification()).expect("run");
        for contact in [0, 1] {
            let points = run.solution.points_of(contact);
            points.iter().for_each(|point| assert_relative_eq!(point.pressure, exact, max_relative = 1e-6));
        }
    }
}

#[test]
fn what_another_contact_holds_is_no_contact_beyond_the_candidates() {
    // A floor with a step of 0.005 between two neighbouring nodes: either level goes on below the candidates of the other.
    let text = "plane = \"strain\"\nthickness = 1.0\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
        shape = { rectangle = { x = [0, 10], y = [0, 10], contact = \"bottom\" } }\n\
        supports = [{ at = \"left\", component = \"x\" }]\n\
        loads = [{ rigid-face = { at = \"far\", component = \"y\", force = -20000 } }]\n\
        [[contact]]\nname = \"high\"\nfirst = \"block\"\ngap = { uniform = 0 }\nstretch = 5\n\
        [[contact]]\nname = \"low\"\nfirst = \"block\"\norigin = [7.6, 0]\nboth-sides = true\nsymmetric = true\n\
        gap = { uniform = 0.005 }\nstretch = 2.4\n[mesh]\nelements = 4\nper = 1\norder = 1\n[reference]\npressure = 2000\n";
    let (_, run) = parsed(text).solve().unwrap_or_else(|error| panic!("{error}"));
    let [high, low] = [run.contacts[0].transmitted, run.contacts[1].transmitted];
    assert!(low > 0.0 && high > low, "{high}, {low}");
    assert_relative_eq!(high + low, 40000.0, max_relative = 1e-3);
}

#[test]
fn scene_without_a_contact_is_refused() {
    let file = parsed(&stack(2, "1.6"));
    let mut scene = file.scene.clone();
    scene.contacts.clear();
    let error = Mesh::of(&scene, file.resolution).expect_err("none").to_string();
    assert!(error.contains("`contacts` = 0"), "{error}");
}

#[test]
fn outputs_tell_every_contact_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (vtu, svg) = (path("f.vtu"), path("p.svg"));
    let file = scene("roller-between-plates");
    let (sound, json, error) = contact_vv(&["solve", &file, "--json", "-", "--vtu", &vtu, "--plot", &svg]);
    assert!(sound, "{error}");
    let document: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let contacts = document["contacts"].as_array().expect("a list");
    assert_eq!(contacts.iter().map(|c| c["name"].as_str().expect("a name")).collect::<Vec<_>>(), ["above", "below"]);
    let resultant = |k: usize| contacts[k]["resultant"].as_f64().expect("a number");
    assert_relative_eq!(resultant(0), 2000.0, max_relative = 1e-8);
    assert_relative_eq!(resultant(1), 2000.0, max_relative = 1e-8);
    let drawn = std::fs::read_to_string(&svg).expect("a picture");
    for title in ["Contact pressure, above", "Contact pressure, below", "Remaining gap, above", "Remaining gap, below"]
    {
        assert!(drawn.contains(title), "no `{title}`");
    }
    let (_, table, _) = contact_vv(&["solve", &file]);
    assert!(
        table.contains("contact `above`:\n  half-width") && table.contains("contact `below`:\n  half-width"),
        "{table}"
    );
}

/// Blocks on rigid ground, apart from one another or one upon the other, with 40 candidate elements each.
fn many(blocks: usize, upright: bool) -> Discretisation {
    discretised(&parsed(&text_of_many(blocks, upright, 8)))
}

fn text_of_many(blocks: usize, upright: bool, elements: usize) -> String {
    let block = |k: usize| {
        let ([x, y], last) = (if upright { [0, 10 * k] } else { [20 * k, 0] }, !upright || k + 1 == blocks);
        let load = if last { "loads = [{ traction = { at = \"far\", value = [0, -1] } }]\n" } else { "" };
        let below = match k {
            1.. if upright => format!("first-side = \"contact\"\nsecond = \"b{}\"\nsecond-side = \"far\"\n", k - 1),
            _ => String::new(),
        };
        format!(
            "[[body]]\nname = \"b{k}\"\nyoung = 1e5\npoisson = 0.3\n\
             shape = {{ rectangle = {{ x = [{x}, {}], y = [{y}, {}], contact = \"bottom\" }} }}\n\
             supports = [{{ at = \"left\", component = \"x\" }}]\n{load}\
             [[contact]]\nname = \"c{k}\"\nfirst = \"b{k}\"\n{below}origin = [{x}, {y}]\n\
             gap = {{ parabola = 500 }}\nstretch = 5\n",
            x + 10,
            y + 10
        )
    };
    let text: String = (0..blocks).map(block).collect();
    format!("plane = \"strain\"\nthickness = 1\n{text}[mesh]\nelements = {elements}\nper = 1\n")
}

#[test]
fn row_of_400_bodies_is_solved_where_it_fits_and_refused_with_the_bytes_where_not() {
    let read = |elements| Case::parse(Path::new("row.toml"), &text_of_many(400, true, elements));
    let fits = read(8).expect("so many cells are solved");
    // Counted to the last one, where the estimate has several times as many.
    let cells = Mesh::of(&fits.scene, fits.resolution).expect("meshed").cells() as f64;
    let [estimated, _] = expected(&fits.scene, fits.resolution);
    assert!(estimated > 500e3 && (cells_of(&fits.scene, fits.resolution) - cells).abs() < 0.5, "{estimated}, {cells}");
    let refused = read(32).map(|_| ()).expect_err("too many").to_string();
    assert!(refused.contains("e10 bytes") && refused.contains("fewer `elements`"), "{refused}");
}

#[test]
fn sparse_stiffness_of_many_bodies_gives_what_one_dense_matrix_gives() {
    for upright in [false, true] {
        let discretisation = many(30, upright);
        let sparse = &discretisation.condensed.stiffness;
        let formulation = Formulation::verification();
        let points = discretisation.points(&formulation);
        let problem = discretisation.problem(&formulation, &points);
        let dense = Stiffness::Dense(sparse.to_dense());
        assert!(!sparse.is_dense(), "{} dofs", problem.load.len());
        let solve = |stiffness, springs: &[f64]| {
            let problem = ContactProblem { stiffness, ..discretisation.problem(&formulation, &points) };
            problem.factorise(springs, &mut Work::default()).map(|factor| factor.solve(problem.load))
        };
        let [one, other] = [sparse, &dense].map(|stiffness| solve(stiffness, &problem.initial).expect("held"));
        let size = one.iter().fold(0.0_f64, |size, u| size.max(u.abs()));
        one.iter().zip(&other).for_each(|(a, b)| assert_abs_diff_eq!(a, b, epsilon = 1e-6 * size));
        let products = |stiffness: &Stiffness| [stiffness.times(&one), stiffness.terms(&one)];
        for (a, b) in products(sparse).iter().zip(products(&dense)) {
            let size = b.iter().fold(0.0_f64, |size, f| size.max(f.abs()));
            a.iter().zip(&b).for_each(|(a, b)| assert_abs_diff_eq!(a, b, epsilon = 1e-12 * size));
        }
        // Without springs nothing holds the bodies.
        let open = vec![0.0; points.len()];
        assert!([sparse, &dense].into_iter().all(|stiffness| solve(stiffness, &open).is_none()), "{upright}");
    }
}

#[test]
fn work_grows_with_the_number_of_bodies_and_each_is_what_it_would_be_alone() {
    for upright in [false, true] {
        let of = |blocks| many(blocks, upright).condensed.stiffness.operations();
        for (more, fewer) in of(60).into_iter().zip(of(30)) {
            assert!((1.9..2.1).contains(&(more / fewer)), "{more} {fewer}");
        }
    }
    let [alone, together] = [1, 40].map(|blocks| {
        let discretisation = many(blocks, false);
        let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
        assert!(run.solution.converged());
        run.contacts.into_iter().map(|contact| contact.measures).collect::<Vec<_>>()
    });
    for found in &together {
        assert_relative_eq!(found.peak.pressure, alone[0].peak.pressure, max_relative = 1e-8);
        assert_relative_eq!(found.half_width(), alone[0].half_width(), max_relative = 1e-8);
    }
}

#[test]
fn newtons_method_of_more_points_than_its_matrix_may_have_is_refused_with_the_bytes() {
    let discretisation = many(100, false);
    for algorithm in [Iteration::Varying, Iteration::Constant] {
        let run = Run::of(&discretisation, &Formulation::accelerated(Element::Node, algorithm));
        let refused = run.map(|_| ()).expect_err("too large");
        assert!(refused.message.contains("8100 contact points, 5.2e8 bytes"), "{refused}");
        assert!(refused.remedy.contains("kinematic"), "{refused}");
    }
}
