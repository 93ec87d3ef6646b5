//! A contact of a scene file names a closed form, and checks without a value are held against it; what contradicts it,
//! or is hardly meant, is refused, or noted with its numbers.

use approx::assert_relative_eq;
use contact_vv::accuracy::bars;
use contact_vv::case::library::{self, FlatPunch};
use contact_vv::case::{Against, Case, Verdict, notes, plausible};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::oracle::{Quantity, ReferenceKind};
use contact_vv::referee::Truth;

use crate::balance::scene;
use crate::scene_file::{self, changed, failures, text_of};
use crate::workbench::{block_text, parsed, told};

/// Values that checks of a file are held against, with the kinds of their references.
fn references(text: &str) -> Vec<(f64, ReferenceKind)> {
    let case = parsed(text);
    let value = |against: &Against| match against {
        Against::Value(reference) => (reference.value, reference.kind),
        other => panic!("{other:?}"),
    };
    case.checks.iter().map(|check| value(&check.against)).collect()
}

/// A block on a rigid profile with an oracle and a check of its peak and second-moment width.
fn block(gap: &str, oracle: &str) -> String {
    let contact = format!("gap = {gap}\nstretch = 4\noracle = {oracle}\n[mesh]\nelements = 4\nper = 4");
    let check = |quantity: &str| format!("[[check]]\nquantity = \"{quantity}\"\ntolerance = 0.1\n");
    let checks = ["peak-pressure", "second-moment-width", "resultant"].map(check).concat();
    let text = block_text([0.0, 20.0], 20.0, "traction = { at = \"far\", value = [0, -1] }", &contact) + &checks;
    text.replace("thickness = 1", "thickness = 2")
}

const MODULUS: f64 = 210e3 / 0.91;

#[test]
fn hertz_and_the_polynomial_of_one_term_are_the_same() {
    // a = 2 mm on R = 100 mm: P = π E* a² / 4R per thickness, p₀ = 2P/πa.
    let load = std::f64::consts::PI * MODULUS * 4.0 / 400.0;
    let hertz =
        references(&block("{ parabola = 100 }", &format!("{{ hertz = {{ load = {}, radius = 100 }} }}", 2.0 * load)));
    let even = format!("{{ polynomial = {{ load = {}, coefficients = [0.005, 0, 0] }} }}", 2.0 * load);
    let wedge = format!("{{ wedge = {{ load = {}, radius = 100, round = 3 }} }}", 2.0 * load);
    for values in
        [references(&block("{ parabola = 100 }", &even)), references(&block("{ parabola = 100 }", &wedge)), hertz]
    {
        assert!(values.iter().all(|(_, kind)| *kind == ReferenceKind::Analytic));
        assert_relative_eq!(values[0].0, load / std::f64::consts::PI, max_relative = 1e-12);
        assert_relative_eq!(values[1].0, 2.0, max_relative = 1e-9);
        assert_relative_eq!(values[2].0, 2.0 * load, max_relative = 1e-12);
    }
}

#[test]
fn waves_have_the_load_that_was_given_and_the_pressure_of_their_formula() {
    let load = 2504.75438564;
    let oracle = format!("{{ cosine = {{ load = {}, amplitude = 0.01, wavelength = 40 }} }}", 2.0 * load);
    let values = references(&block("{ cosine = { amplitude = 0.01, wavelength = 40 } }", &oracle));
    let complete = std::f64::consts::PI * MODULUS * 0.01 / 40.0;
    assert_relative_eq!(values[0].0, 2.0 * complete * (0.2 * std::f64::consts::PI).sin(), max_relative = 1e-9);
    assert_relative_eq!(values[2].0, 2.0 * load, max_relative = 1e-12);
    // Between the half-width of a small contact and that of the pressed wave.
    assert!((7.5..8.0).contains(&values[1].0), "{}", values[1].0);
}

#[test]
fn closed_forms_of_a_file_have_its_numbers_in_their_places() {
    // ρgH.
    let weight = block("{ uniform = 0 }", "{ own-weight = { weight = 2, height = 20, width = 40 } }");
    let changes = [
        ("[[check]]\nquantity = \"second-moment-width\"\ntolerance = 0.1\n", ""),
        ("traction = { at = \"far\", value = [0, -1] }", "body-force = [0, -2]"),
    ];
    assert_relative_eq!(references(&changed(&weight, &changes))[0].0, 2.0 * 20.0, max_relative = 1e-12);
    // Persson's half-angle is that of E_p ΔR/P, E_p = E/(1 − ν²) in plane strain.
    let half_angle = |plane: &str, load: f64| {
        let oracle = format!("load = {load}");
        let case = scene("pin-in-plate", &[["plane = \"stress\"", plane], ["load = 40000", &oracle]]);
        told(&case, &Quantity::HalfWidth)
    };
    let stress = half_angle("plane = \"stress\"", 40000.0);
    assert_relative_eq!(half_angle("plane = \"strain\"", 40000.0 / 0.91), stress, max_relative = 1e-9);
}

#[test]
fn closed_forms_of_the_library_are_those_of_files() {
    let lame = references(&text_of("press-fit.toml"))[0].0;
    assert_relative_eq!(lame, 12.703010, max_relative = 1e-6);
    let punch = references(&text_of("flat-punch.toml"))[0].0;
    assert_relative_eq!(punch, 1000.0 / (std::f64::consts::PI * 0.75_f64.sqrt()), max_relative = 1e-9);
    // A scene that is built in and a file of it are one scene.
    let hertz = references(&text_of("cylinder-in-metres.toml"))[0].0;
    for (file, name, at) in [(lame, "press-fit", 0.0), (punch, "flat-punch", 0.5), (hertz, "cylinder", 0.0)] {
        let built_in = library::find(name, None).expect(name).reference_pressure(0, at);
        assert_relative_eq!(file, built_in, max_relative = 1e-9);
    }
}

#[test]
fn truncated_hertz_of_a_file_has_no_model_error_above_or_below_its_contact() {
    // a = 2 mm on R = 100 mm: p₀ = E* a / 2R, P = π a p₀ / 2 per thickness.
    let peak = MODULUS * 2.0 / 200.0;
    let load = std::f64::consts::PI * 2.0 * peak / 2.0;
    let oracle = format!("{{ hertz = {{ load = {}, radius = 100 }} }}", 2.0 * load);
    let stress = |at: &str| format!("{{ hertz = {{ at = \"{at}\", peak-pressure = {peak}, half-width = 2 }} }}");
    let above = block("{ parabola = 100 }", &oracle)
        .replace("{ traction = { at = \"far\", value = [0, -1] } }", &format!("{}, {}", stress("far"), stress("right")))
        .replace("elements = 4\nper = 4", "elements = 12\nper = 2")
        .replace("tolerance = 0.1", "tolerance = 5e-3");
    let below = above.replace("y = [0, 20], contact = \"bottom\"", "y = [-20, 0], contact = \"top\"");
    let beside = above
        .replace("x = [0, 20]", "x = [7, 27]")
        .replace("gap = {", "origin = [7, 0]\ngap = {")
        .replace("half-width = 2 }", "half-width = 2, centre = [7, 0] }");
    for text in [&above, &below, &beside] {
        assert_eq!(failures(text), 0);
    }
    // Other stresses are another problem.
    assert_ne!(failures(&above.replace("half-width = 2 }", "half-width = 1.9 }")), 0);
}

/// A block of revolution, 20 times as large as its contact of 2 mm, pressed on a rigid profile, with checks against an
/// oracle.
fn of_revolution(gap: &str, oracle: &str, load: f64, mesh: &str) -> String {
    let check = |quantity: &str| format!("[[check]]\nquantity = \"{quantity}\"\ntolerance = 0.01\n");
    let checks = ["pressure", "second-moment-width", "resultant"].map(check).concat();
    let checks = checks.replace("\"pressure\"", "\"pressure\"\nat = 1");
    format!(
        "title = \"block\"\nplane = \"axisymmetric\"\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [0, 40], y = [0, 40], contact = \"bottom\" }} }}\n\
         loads = [{{ traction = {{ at = \"far\", force = [0, {}] }} }}]\n\
         [contact]\nfirst = \"block\"\ngap = {gap}\noracle = {oracle}\n{mesh}\n\
         [reference]\npressure = 1000\nlength = 2\ngap = 0.02\n{checks}",
        -load
    )
}

#[test]
fn closed_forms_of_revolution_of_a_file_are_met() {
    let load = |powers: &[[f64; 2]]| Indentation::smooth(MODULUS, 2.0, powers.to_vec()).load();
    let [cone, even] = [load(&[[0.02, 1.0]]), load(&[[5e-3, 2.0], [4e-4, 4.0]])];
    let smooth = "stretch = 4\n[mesh]\nelements = 12\nper = 2";
    let sharp = "stretch = 2\n[mesh]\nelements = 12\nper = 2\ngrowth = { along = 1.4, depth = 1.4, coarsest = 0.1, end \
        = 0.02 }";
    for (gap, oracle, load, mesh) in [
        ("{ punch = 2 }", "{ flat-punch = { load = 1e4, half-width = 2 } }".to_owned(), 1e4, sharp),
        ("{ wedge = 0.02 }", format!("{{ cone = {{ load = {cone}, slope = 0.02 }} }}"), cone, smooth),
        (
            "{ even = [5e-3, 4e-4] }",
            format!("{{ polynomial = {{ load = {even}, coefficients = [5e-3, 4e-4, 0] }} }}"),
            even,
            smooth,
        ),
    ] {
        assert_eq!(failures(&of_revolution(gap, &oracle, load, mesh)), 0, "{gap}");
    }
}

#[test]
fn truncated_sphere_of_a_file_has_no_model_error_above_or_below_its_contact() {
    // a = 2 mm on R = 100 mm: p₀ = 2 E* a / πR, F = 2πa² p₀ / 3.
    let peak = 2.0 * MODULUS * 2.0 / (100.0 * std::f64::consts::PI);
    let load = 2.0 * std::f64::consts::PI * 4.0 * peak / 3.0;
    let smooth = "stretch = 4\n[mesh]\nelements = 12\nper = 2";
    let text =
        of_revolution("{ parabola = 100 }", &format!("{{ hertz = {{ load = {load}, radius = 100 }} }}"), load, smooth);
    let stress = |at: &str| format!("{{ hertz = {{ at = \"{at}\", peak-pressure = {peak}, half-width = 2 }} }}");
    let (begin, rest) = text.split_once("loads = [").expect("loads");
    let (_, end) = rest.split_once("]\n").expect("their end");
    let above = format!("{begin}loads = [{}, {}]\n{end}", stress("far"), stress("right"))
        .replace("x = [0, 40], y = [0, 40]", "x = [0, 8], y = [0, 8]")
        .replace("tolerance = 0.01", "tolerance = 5e-3");
    let below = above.replace("y = [0, 8], contact = \"bottom\"", "y = [-8, 0], contact = \"top\"");
    assert_eq!([failures(&above), failures(&below)], [0; 2]);
}

/// What is noted of a scene that is solved.
fn noted(case: &Case) -> Vec<String> {
    let (meshed, run) = case.solve().expect("solved");
    case.notes(&run, &bars(&meshed.discretisation, &run, &[]).expect("bars").all)
}

#[test]
fn hertz_on_an_arc_speaks_of_angles() {
    let case = scene_file::case("rigid-pin");
    let read = |quantity: Quantity| told(&case, &quantity);
    let parabola = "{ polynomial = { load = 0.6591, coefficients = [4.995004995004995e-5, 0, 0] } }";
    let parabola = changed(&text_of("rigid-pin.toml"), &[("{ hertz = { load = 0.6591, radius = 10010 } }", parabola)]);
    assert_relative_eq!(told(&parsed(&parabola), &Quantity::HalfWidth), read(Quantity::HalfWidth), max_relative = 1e-6);
    let radius = case.scene.contact().path.metric();
    let half_width = (4.0 * 0.6591 * 10010.0 / (std::f64::consts::PI * 210e3)).sqrt();
    assert_relative_eq!(read(Quantity::HalfWidth), half_width / radius, max_relative = 1e-12);
    assert_relative_eq!(read(Quantity::SecondMomentWidth), half_width / radius, max_relative = 1e-12);
    let [top, side] = [0.0, 0.5 * half_width / radius].map(|at| read(Quantity::Pressure { at }));
    assert_relative_eq!(side, top * 0.75f64.sqrt(), max_relative = 1e-12);
    // The referee knows it to what the closed form leaves out.
    let truth = Truth::of(case).expect("solved");
    let known = truth.known(0, &Quantity::HalfWidth);
    assert!(known.bar <= 0.01 * known.reference.value, "{known:?}");
    assert!(truth.notes().is_empty(), "{:?}", truth.notes());
}

#[test]
fn one_gap_told_in_another_way_has_the_same_closed_form() {
    // A cylinder and its parabola are one, and so is a table of it.
    for gap in ["{ circle = 100 }", "{ even = [0.005] }", "{ table = [[0, 0], [0.5, 0.00125], [1, 0.005], [2, 0.02]] }"]
    {
        scene("block-on-parabola", &[["{ parabola = 100 }", gap]]);
    }
}

#[test]
fn loads_that_the_contact_does_not_carry_are_noted_with_both_numbers() {
    let with = |load: &str| noted(&scene("block-on-parabola", &[["load = 5000", load]]));
    assert!(with("load = 5000").is_empty(), "{:?}", with("load = 5000"));
    for load in ["2500", "4900", "6500"] {
        let notes = with(&format!("load = {load}"));
        assert!(notes[0].contains(&format!("load of {load}")) && notes[0].contains("5000.00"), "{notes:?}");
    }
    // Without bars a hundredth of the force is, and a twentieth of peak and half-width, which grow with its root.
    let without = |load: &str| {
        let case = scene("block-on-parabola", &[["load = 5000", load]]);
        let (_, run) = case.solve().expect("solved");
        case.notes(&run, &[]).len()
    };
    assert_eq!(["load = 5010", "load = 4900", "load = 4000"].map(without), [0, 1, 3]);
    // Whether a half is left out is said as the scene has it.
    for (half, whole) in [("", "both halves of a symmetric one"), ("\nsymmetric = false", "the whole of it")] {
        let notes = noted(&scene(
            "block-on-parabola",
            &[["load = 5000", "load = 4000"], ["[contact]", &format!("[contact]{half}")]],
        ));
        assert!(notes.iter().any(|note| note.contains("load of 4000") && note.ends_with(whole)), "{notes:?}");
    }
    let notes = noted(&scene("pin-in-plate", &[["load = 40000", "load = 20000"]]));
    let persson = |note: &String| note.contains("Persson has a load of 20000") && note.contains("40000.0");
    assert!(notes.iter().any(persson), "{notes:?}");
    // Of the second contact too.
    let text = text_of("roller-between-plates.toml").replacen(
        "load = 2000, radius = 50 } }\n\n[mesh]",
        "load = 1000, radius = 50 } }\n\n[mesh]",
        1,
    );
    let notes = noted(&parsed(&text));
    assert!(notes.iter().any(|note| note.contains("`below`") && note.contains("2000.00")), "{notes:?}");
    assert!(notes.iter().all(|note| !note.contains("`above`")), "{notes:?}");
}

#[test]
fn cases_are_off_their_closed_forms_by_no_more_than_they_say() {
    let held = |case: &Case| {
        let (meshed, run) = case.solve().expect("solved");
        case.held_to_closed_forms(&meshed, &run).expect("judged")
    };
    let mut case = scene_file::case("rigid-pin");
    let judged = held(&case);
    assert_eq!(judged.len(), 3);
    assert!(judged.iter().all(|one| one.verdict == Verdict::Pass), "{judged:?}");
    // Nor is many times as much stated: errors are over that and the bar.
    let of_library = ["cylinder", "pin-plate"].map(|name| library::find(name, None).expect("known"));
    for case in of_library.iter().chain([&FlatPunch { size: 20.0, ..Default::default() }.case()]) {
        let most = held(case).iter().map(|one| one.error).fold(0.0, f64::max);
        assert!(most >= 0.05, "{}: {most} of what is stated", case.name);
    }
    // What is not stated is seen.
    case.checks.iter_mut().for_each(|check| check.model = 0.0);
    assert!(held(&case).iter().any(|one| one.verdict == Verdict::Fail));
    let mut punch = FlatPunch { size: 20.0, ..Default::default() }.case();
    assert!(held(&punch).iter().all(|one| one.verdict == Verdict::Pass), "a finite block, as the case says");
    punch.model = 0.0;
    assert!(held(&punch).iter().any(|one| one.verdict == Verdict::Fail), "a finite block, and nothing says so");
}

/// A block of 10 mm on another, pressed from above.
pub const BLOCKS: &str = include_str!("../data/scenes/pressed-blocks.toml");

/// The notes on the first contact of a scene.
fn notes(text: &str) -> Vec<String> {
    let (meshed, run) = parsed(text).solve().expect("solved");
    [notes::of(&run, 0), plausible::doubts(&meshed.discretisation, &run).remove(0)].concat()
}

#[test]
fn what_is_hardly_meant_is_noted_with_its_number() {
    assert_eq!(notes(BLOCKS), Vec::<String>::new());
    let gpa = BLOCKS.replace("young = 200000", "young = 200");
    let pa = BLOCKS.replace("young = 200000", "young = 200e9");
    let deep = BLOCKS.replace("gap = { parabola = 1000 }", "gap = { uniform = -1.5 }");
    let apart = BLOCKS.replace("x = [0, 20], y = [-20, 0]", "x = [0, 20000], y = [-20000, 0]");
    let apart = apart.replace("elements = 8\n", "elements = 4\n");
    let squeezed = BLOCKS.replace("{ traction = { at = \"far\", value = [0, -100] } }", "");
    let squeezed = squeezed.replace("loads = []\n", "");
    let squeezed = squeezed.replacen(
        "{ at = \"left\", component = \"x\" }]",
        "{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\", value = -2 }]",
        1,
    );
    for (text, wanted) in [
        (&gpa, ["of the contact modulus", "is `young` of `upper`, 200 MPa, in GPa?"]),
        (&gpa, ["`upper` moves by up to", "% of its size"]),
        (&pa, ["pressure is only", "2.00e11 MPa, in Pa?"]),
        (&deep, ["the bodies begin 1.50 mm within one another", "15 % of the size of `upper`"]),
        (&apart, ["`lower` is 20000 mm large and `upper` 10.0 mm", "2000 times less"]),
        (&squeezed, ["`upper` moves by up to 2.0", "20 % of its size"]),
    ] {
        let found = notes(text);
        let holds = |note: &String| wanted.iter().all(|part| note.contains(part));
        assert!(found.iter().any(holds), "{wanted:?} in {found:?}");
    }
}

#[test]
fn a_punch_without_a_limit_is_doubted_by_its_load_over_its_own_area() {
    // Half-width or radius 2 below a block of 10, 0.5 MPa on top: 0.5 · 10/2, or 0.5 · 10²/2², over E/(1 − ν²).
    const PUNCH: &str = "[[body]]\nname = \"block\"\nyoung = 20\npoisson = 0.3\n\
        shape = { rectangle = { x = [0, 10], y = [0, 10], contact = \"bottom\" } }\n\
        supports = [{ at = \"left\", component = \"x\" }]\nloads = [{ traction = { at = \"far\", value = [0, -0.5] } \
        }]\n\
        [contact]\nfirst = \"block\"\ngap = { punch = 2 }\nstretch = 2\n[mesh]\nelements = 8\nper = 1\n";
    let around = PUNCH.replace("supports = [{ at = \"left\", component = \"x\" }]\n", "");
    for (text, pressure) in [
        (format!("plane = \"strain\"\nthickness = 2\n{PUNCH}"), 2.5),
        (format!("plane = \"axisymmetric\"\n{around}"), 12.5),
    ] {
        let found = notes(&text);
        let strain: f64 = pressure * (1.0 - 0.3 * 0.3) / 20.0;
        let told =
            found.iter().find_map(|note| note.strip_prefix("the mean pressure is ")?.split(' ').next()?.parse().ok());
        let told: f64 = told.unwrap_or_else(|| panic!("{found:?}"));
        assert!((told / strain - 1.0).abs() < 5e-3, "{told} for {strain}: {found:?}");
    }
}
