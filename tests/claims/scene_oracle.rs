//! A contact of a scene file names a closed form, and checks without a value are held against it.

use approx::assert_relative_eq;
use contact_vv::case::{Against, library};
use contact_vv::oracle::ReferenceKind;
use contact_vv::oracle::analytic::revolution::indentation::Indentation;

use crate::scene_file::{failures, text_of};
use crate::workbench::{block_text, parsed};

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
    for text in [&above, &below] {
        assert_eq!(failures(text), 0);
    }
    // Other stresses are another problem.
    assert_ne!(failures(&above.replace("half-width = 2 }", "half-width = 1.9 }")), 0);
}

/// A block of revolution, 20 times as large as its contact of 2 mm, pressed on a rigid profile, with checks against an oracle.
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
    let sharp = "stretch = 2\n[mesh]\nelements = 12\nper = 2\ngrowth = { along = 1.4, depth = 1.4, coarsest = 0.1, end = 0.02 }";
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
