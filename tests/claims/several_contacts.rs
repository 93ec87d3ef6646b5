//! Several contacts in one scene: each is what it would be alone where they do not meet, and all of them balance.

use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::{self, Asked};
use contact_vv::algorithm::ContactProblem;
use contact_vv::case::{Against, Case, Check, Quantity, Verdict, notes};
use contact_vv::condensation::stiffness::Stiffness;
use contact_vv::measure::Measures;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::size::{cells_of, expected};
use contact_vv::scene::Scene;
use contact_vv::solution::Work;
use contact_vv::solve::{Change, Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::study::timings::growth::largest_memory;

use crate::balance::{scene, solved_as_it_says};
use crate::program::{Folder, program};
use crate::scene_file::{case, text_of};
use crate::workbench::{parsed, refused, spoiled};

fn discretised(file: &Case) -> Discretisation {
    Discretisation::of(file.scene.clone(), file.resolution).expect("discretised")
}

#[test]
fn profile_of_a_contact_is_held_against_its_own_closed_form() {
    let mut case = case("roller-between-plates");
    case.oracles[0] = None;
    let of_second = |quantity| Check { contact: 1, ..Check::error(quantity, Against::Oracle, 0.1, "the mesh") };
    case.checks = vec![of_second(Quantity::Profile), of_second(Quantity::Departure)];
    let (meshed, run) = case.solve().expect("a run");
    for one in case.own(&meshed.discretisation, &run).expect("judged") {
        assert_eq!((&one.verdict, one.reference.name.as_str()), (&Verdict::Pass, "Hertz"), "{one:?}");
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
fn stretches_that_are_guessed_far_too_short_are_lengthened_until_they_hold_the_contacts() {
    let text = text_of("plate-on-two-supports.toml");
    for [left, right] in [["0.001", "0.001"], ["0.00001", "5.0"]] {
        let guessed = |text: &str, guess: &str| text.replacen("stretch = 1.0", &format!("stretch = {guess}"), 1);
        let scene = parsed(&guessed(&guessed(&text, left), right)).scene;
        let asked = Asked { high_order: false, ..Asked::new(1e-2) };
        let answer = accuracy::solve(&scene, &Formulation::verification(), &asked).expect("solved");
        assert!(answer.unmet.is_none(), "{left}: {:?}", answer.unmet);
        let [first, .., last] = &answer.tried[..] else { panic!("{:?}", answer.tried) };
        for k in [0, 1] {
            let (load, looked, contact) = ([300.0, 600.0][k], first.contacts[k], last.contacts[k]);
            // a = √(4PR/πE*), and candidates a quarter longer than it was found, by whole elements.
            let a: f64 = (4.0 * load * 25.0 / (std::f64::consts::PI * 70e3 / (1.0 - 0.33 * 0.33))).sqrt();
            assert!((contact.half_width / a - 1.0).abs() < 0.02, "{left}: {contact:?}, {a}");
            assert!((1.2 * a..2.0 * a).contains(&contact.stretch), "{left}: {contact:?}, {a}");
            assert!(looked.stretch < 4.0 * a || looked.stretch <= 5.0 && k == 1, "{left}: {looked:?}, {a}");
        }
    }
}

#[test]
fn elements_of_bodies_that_do_not_touch_are_sized_by_their_own_contacts() {
    let [one, other] = [roller("one", -70.0, -30.0, 210e3), roller("other", 55.0, -18.0, 120e3)];
    let other = other.map(|text| text.replace("stretch = 2.5", "stretch = 10"));
    let (first, _) = accuracy::first(&of_parts(&[one, other]).scene);
    let densities: Vec<f64> = first.bodies.iter().map(|body| body.density).collect();
    assert_eq!((first.grading.unit, densities), (10.0, vec![4.0, 1.0]));
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
        solved_as_it_says(&parsed(&text)).1
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
    let file = case("roller-between-plates");
    let discretisation = discretised(&file);
    let formulation = Formulation::verification();
    let run = Run::of(&discretisation, &formulation).expect("run");
    // The set is at hand: an iteration that confirms it, or two.
    let carried = discretisation.solve_from(Some(&run.solution), &formulation, Change::NONE).expect("carried");
    assert!(carried.work.iterations <= 2, "{} iterations", carried.work.iterations);
    assert_eq!(carried.contacts.len(), run.solution.contacts.len());
    for (own, other) in carried.contacts.iter().zip(&run.solution.contacts) {
        assert_eq!((&own.points, &own.edges), (&other.points, &other.edges));
    }
    for (a, b) in carried.points.iter().zip(&run.solution.points) {
        assert_abs_diff_eq!(a.pressure, b.pressure, epsilon = 1e-5);
    }
}

#[test]
fn contact_off_the_symmetry_line_counts_twice_where_it_is_said() {
    // A half plate on a support in the middle and on one of two beside it; 1000 on the half.
    let forces = |symmetric: &str| {
        let file = scene("plate-on-three", &[["symmetric = true\n", symmetric]]);
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
    refused(parsed(&open).solve(), &["nothing presses"]);
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
    // A floor with a step of 0.005 between two neighbouring nodes: either level goes on below the candidates of the
    // other.
    let (_, run) = scene("step-below", &[]).solve().unwrap_or_else(|error| panic!("{error}"));
    let [high, low] = [run.contacts[0].transmitted, run.contacts[1].transmitted];
    assert!(low > 0.0 && high > low, "{high}, {low}");
    assert_relative_eq!(high + low, 40000.0, max_relative = 1e-3);
}

#[test]
fn scene_without_a_contact_is_refused() {
    let file = case("three-rings");
    let error =
        Mesh::of(&spoiled(&file.scene, |scene| scene.contacts.clear()), file.resolution).expect_err("none").to_string();
    assert!(error.contains("`contacts` = 0"), "{error}");
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
fn scene_of_many_bodies_is_solved_where_it_fits_and_refused_with_the_bytes_where_not() {
    let read = |blocks, upright, elements| Case::parse(Path::new("row.toml"), &text_of_many(blocks, upright, elements));
    let fits = read(400, true, 8).expect("so many cells are solved");
    // Counted to the last one, where the estimate has several times as many.
    let cells = Mesh::of(&fits.scene, fits.resolution).expect("meshed").cells() as f64;
    let [estimated, _] = expected(&fits.scene, fits.resolution);
    assert!(estimated > 500e3 && (cells_of(&fits.scene, fits.resolution) - cells).abs() < 0.5, "{estimated}, {cells}");
    // One dense matrix of all dofs, and that of one body: bytes bound a scene, and not the number of its contacts.
    for (blocks, upright, elements, says) in [
        (400, true, 32, ["e10 bytes", "fewer `elements`"]),
        (3, false, 160, ["2400 candidate elements in all 3 contacts", "scenes of fewer contacts"]),
        (400, false, 24, ["48000 candidate", "scenes of fewer contacts"]),
    ] {
        let refused = read(blocks, upright, elements).map(|_| ()).expect_err("too many").to_string();
        assert!(says.iter().all(|part| refused.contains(part)) && refused.contains("bytes"), "{refused}");
    }
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
        // Factors that are made again recover what those that are kept do, whatever was recovered before.
        let kept = discretisation.system.condense().expect("condensed");
        let twice: Vec<f64> = one.iter().map(|u| 2.0 * u).collect();
        for (share, retained) in [(1.0, &one), (1.0, &one), (0.5, &one), (0.5, &twice), (1.0, &one)] {
            let [again, plain] =
                [&discretisation.condensed, &kept].map(|bodies| bodies.recover(share, retained).concat());
            let size = plain.iter().fold(0.0_f64, |size, u| size.max(u.abs()));
            again.iter().zip(&plain).for_each(|(a, b)| assert_abs_diff_eq!(a, b, epsilon = 1e-12 * size));
        }
        // Without springs nothing holds the bodies.
        let open = vec![0.0; points.len()];
        assert!([sparse, &dense].into_iter().all(|stiffness| solve(stiffness, &open).is_none()), "{upright}");
    }
}

/// Memory of 400 contacts of two bodies each, with bars \[bytes\].
const OF_400: f64 = 2e9;

#[test]
fn memory_of_many_contacts_of_two_bodies_each_is_bounded() {
    const CONTACTS: usize = 100;
    let pair = |k: usize| {
        let body = |name: &str, young: &str, [from, to]: [i32; 2], side: &str, more: &str| {
            format!(
                "[[body]]\nname = \"{name}{k}\"\nyoung = {young}\npoisson = 0.3\n\
                 shape = {{ rectangle = {{ x = [{}, {}], y = [{from}, {to}], contact = \"{side}\" }} }}\n\
                 supports = [{{ at = \"left\", component = \"x\" }}{more}\n",
                20 * k,
                20 * k + 10
            )
        };
        let pressed = "]\nloads = [{ traction = { at = \"far\", value = [0, -1] } }]";
        let upper = body("b", "1e5", [0, 10], "bottom", pressed);
        let lower = body("g", "2e5", [-10, 0], "top", ", { at = \"far\", component = \"y\" }]");
        format!(
            "{upper}{lower}[[contact]]\nname = \"c{k}\"\nfirst = \"b{k}\"\nsecond = \"g{k}\"\norigin = [{}, 0]\n\
             gap = {{ parabola = 500 }}\nstretch = 5\n",
            20 * k
        )
    };
    let pairs: String = (0..CONTACTS).map(pair).collect();
    let folder = Folder::made();
    let text = format!("plane = \"strain\"\nthickness = 1\n{pairs}[mesh]\nelements = 8\nper = 1\n");
    let scene = folder.with("pairs.toml", text);
    let mut solve = program(&["solve", &scene]);
    // Every thread solves a mesh of the bars.
    let mut solve = solve.env("RAYON_NUM_THREADS", "2").stdout(Stdio::null()).spawn().expect("started");
    let (process, mut most) = (solve.id().to_string(), None);
    let ended = loop {
        most = largest_memory(&process).or(most);
        match solve.try_wait().expect("it runs") {
            Some(ended) => break ended,
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    };
    assert!(ended.success(), "{ended}");
    match most {
        Some(bytes) => assert!(bytes <= OF_400 * CONTACTS as f64 / 400.0, "{bytes:.2e} bytes"),
        None => eprintln!("skipped: the system does not tell the memory of a process"),
    }
}

#[test]
fn work_grows_with_the_number_of_bodies() {
    for upright in [false, true] {
        let of = |blocks| many(blocks, upright).condensed.stiffness.operations();
        for (more, fewer) in of(60).into_iter().zip(of(30)) {
            assert!((1.9..2.1).contains(&(more / fewer)), "{more} {fewer}");
        }
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

#[test]
fn meshes_are_fine_at_every_contact_of_a_body() {
    let sizes = |scene: &Scene, mesh: &Mesh, contact: usize| -> Vec<f64> {
        let pair = &scene.contacts[contact];
        let part = &mesh.bodies[pair.first];
        let own = &part.candidates[part.candidates_of(contact)];
        own.windows(3).step_by(2).map(|three| three[2].coordinate - three[0].coordinate).collect()
    };
    for (name, fine, along) in
        [("plate-on-two-supports", 0.05, [-30.0, 30.0]), ("roller-between-plates", 0.8 / 12.0, [0.0; 2])]
    {
        let file = case(name);
        let (scene, resolution) = (&file.scene, file.resolution);
        let mesh = Mesh::of(scene, resolution).expect("mesh");
        for (contact, origin) in along.into_iter().enumerate() {
            assert_relative_eq!(scene.contacts[contact].path.origin()[0], origin);
            let sizes = sizes(scene, &mesh, contact);
            assert!(sizes.len() >= 18, "{name}: {} elements", sizes.len());
            sizes.iter().for_each(|size| assert_relative_eq!(*size, fine, max_relative = 0.03));
        }
        // And coarse away from them, as foretold.
        let [cells, candidates] = expected(scene, resolution);
        assert!(mesh.cells() < 6000, "{name}: {} cells", mesh.cells());
        assert!((1.0..6.0).contains(&(cells / mesh.cells() as f64)), "{name}: {cells} for {}", mesh.cells());
        let most = mesh.bodies.iter().map(|body| body.candidates.len() / 2).max().expect("bodies") as f64;
        assert!((0.9..1.1).contains(&(candidates / most)), "{name}: {candidates} candidates for {most}");
    }
}

/// A plate between punches above and below, with the stretches of both about places of their own.
pub fn between_punches(places: [f64; 2], stretches: [f64; 2], growth: &str) -> String {
    let contact = |k: usize, name: &str, side: &str, y: f64| {
        format!(
            "[[contact]]\nname = \"{name}\"\nfirst = \"plate\"\nfirst-side = \"{side}\"\norigin = [{}, {y}]\n\
             both-sides = true\ngap = {{ parabola = 80 }}\nstretch = {}\n",
            places[k], stretches[k]
        )
    };
    format!(
        "plane = \"strain\"\nthickness = 1.0\n[[body]]\nname = \"plate\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [-40, 40], y = [0, 30], contact = \"bottom\" }} }}\n\
         supports = [{{ at = [-40, 30], component = \"x\" }}]\nloads = [{{ body-force = [0, -1] }}]\n{}{}\
         [mesh]\nelements = 5\nper = 1\ngrowth = {{ along = {growth} }}\n[reference]\npressure = 300\n",
        contact(0, "below", "contact", 0.0),
        contact(1, "above", "far", 30.0)
    )
}

#[test]
fn every_stretch_begins_and_ends_on_a_node_whichever_contacts_share_the_body() {
    let overlapping =
        [([0.0, 0.0], [3.0, 1.3]), ([0.0, 0.0], [0.7, 9.9]), ([-1.0, 2.4], [2.0, 2.0]), ([5.0, 4.1], [4.0, 0.35])];
    let plates = overlapping.map(|(places, stretches)| between_punches(places, stretches, "1.7"));
    let roller = text_of("roller-between-plates.toml").replace("stretch = 1.2", "stretch = 0.77");
    let thick = text_of("three-rings.toml")
        .replace("outer = 55, sweep = 90", "outer = 155, sweep = 90")
        .replace("inner = 55, outer = 80", "inner = 155, outer = 180")
        .replace("radius = 55", "radius = 155")
        .replacen("stretch = 90", "stretch = 50", 1);
    for text in plates.iter().chain([&roller, &thick]) {
        let file = parsed(text);
        let (scene, resolution) = (&file.scene, file.resolution);
        let mesh = Mesh::of(scene, resolution).expect("mesh");
        for (contact, pair) in scene.contacts.iter().enumerate() {
            let part = &mesh.bodies[pair.first];
            let own = &part.candidates[part.candidates_of(contact)];
            assert_relative_eq!(own[own.len() - 1].coordinate, pair.stretch, max_relative = 1e-9);
            assert_abs_diff_eq!(own[0].coordinate, pair.begin(), epsilon = 1e-9 * pair.stretch);
            let asked = scene.grading.unit / resolution.elements as f64;
            let longest = own.windows(3).step_by(2).map(|three| three[2].coordinate - three[0].coordinate);
            let longest = longest.fold(0.0, f64::max) * pair.path.metric();
            assert!(longest < 1.35 * asked, "{}: elements of {longest} for {asked}", pair.name);
        }
    }
}

#[test]
fn mesh_of_a_short_stretch_without_growth_is_refused_before_it_is_built() {
    let text = between_punches([-10.0, 10.0], [2.0, 1e-5], "1.0");
    refused(Case::parse(Path::new("large.toml"), &text), &["the mesh would have about"]);
}

/// Sizes of the elements along the left side of the first body, from below.
fn heights(scene: &Scene, mesh: &Mesh) -> Vec<f64> {
    let left = mesh.boundary(scene, 0, "left").expect("a side");
    let mut ends: Vec<f64> = left.iter().flat_map(|edge| [edge[0], edge[1]]).map(|node| mesh.points[node][1]).collect();
    ends.sort_by(f64::total_cmp);
    ends.windows(2).map(|pair| pair[1] - pair[0]).filter(|size| *size > 1e-9).collect()
}

#[test]
fn plate_between_two_contacts_is_fine_at_both_and_within_its_coarsest_between() {
    // Elements that would soon outgrow it.
    let plate = between_punches([0.0, 0.0], [2.0, 2.0], "1.3").replace("growth = {", "growth = { depth = 3.0,");
    let file = parsed(&plate);
    let mesh = Mesh::of(&file.scene, file.resolution).expect("mesh");
    let sizes = heights(&file.scene, &mesh);
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    assert!(largest <= 1.01 * 30.0 * file.scene.grading.coarsest, "{largest}");
    assert_relative_eq!(sizes[0], sizes[sizes.len() - 1], max_relative = 1e-6);
    assert!(sizes[0] < 0.2 * largest, "{sizes:?}");
}

#[test]
fn cells_are_foretold_within_a_margin_where_a_body_is_deep_between_its_contacts() {
    let tall = between_punches([-20.0, 20.0], [2.0, 2.0], "1.3")
        .replace("y = [0, 30]", "y = [0, 3000]")
        .replace("30]", "3000]");
    let file = parsed(&tall.replace("growth = {", "growth = { depth = 1.01,"));
    let [cells, _] = expected(&file.scene, file.resolution);
    let made = Mesh::of(&file.scene, file.resolution).expect("mesh").cells() as f64;
    assert!((2.0..4.0).contains(&(cells / made)), "{cells} for {made}");
}

#[test]
fn contacts_of_different_widths_on_one_disc_are_met_to_a_millionth() {
    let asked = Asked { most_dofs: Some(40_000), ..Asked::new(1e-6) };
    let scene = case("roller-between-plates").scene;
    let answer = accuracy::solve(&scene, &Formulation::verification(), &asked).expect("solved");
    assert_eq!(answer.unmet, None);
    assert!(answer.run.dofs <= 13_500, "{} dofs", answer.run.dofs);
    // Where bodies in contact have their nodes at different places, the ends were 2e-6 off whatever the order.
    let mesh = Discretisation::of(answer.scene.clone(), answer.resolution).expect("discretised").mesh;
    for (pair, contact) in answer.scene.contacts.iter().zip(&answer.run.contacts) {
        let [disc, plate] = [Some(pair.first), pair.second].map(|body| {
            let body = body.expect("an elastic body");
            let edges = mesh.boundary(&answer.scene, body, pair.side(body)).expect("the side");
            edges.iter().flatten().map(|&node| mesh.points[node][0]).collect::<Vec<_>>()
        });
        let end = contact.measures.half_width();
        for x in disc.iter().filter(|x| **x <= 1.4 * end) {
            let nearest = plate.iter().map(|other| (x - other).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest <= 1e-9 * end, "{x}: {nearest}");
        }
    }
}

#[test]
fn a_whole_roller_beside_the_middle_of_its_plates_has_cells_fitted_to_both_contacts() {
    let scene = scene("roller-beside-the-middle", &[]).scene;
    let [coarse, fine] = [1e-3, 1e-4].map(|asked| {
        let asked = Asked { most_dofs: Some(25_000), ..Asked::new(asked) };
        let answer = accuracy::solve(&scene, &Formulation::verification(), &asked).expect("solved");
        assert_eq!(answer.unmet, None);
        answer.run
    });
    assert!(coarse.dofs <= 8_000, "{} dofs", coarse.dofs);
    for (coarse, fine) in coarse.contacts.iter().zip(&fine.contacts) {
        assert_relative_eq!(coarse.measures.half_width(), fine.measures.half_width(), max_relative = 1.1e-3);
        assert_relative_eq!(coarse.measures.peak.pressure, fine.measures.peak.pressure, max_relative = 1.1e-3);
        // Half-plane on half-plane: Hertz but for what discs and plates of such size leave out.
        assert_relative_eq!(
            fine.measures.half_width(),
            (8.0 * 1000.0 * 10.0 / std::f64::consts::PI / (210e3 / 0.91)).sqrt(),
            max_relative = 0.02
        );
    }
}
