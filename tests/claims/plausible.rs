//! What of a result is hardly meant is noted with the number that shows it, and only that.

use contact_vv::case::{notes, plausible};

use crate::workbench::parsed;

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
        supports = [{ at = \"left\", component = \"x\" }]\nloads = [{ traction = { at = \"far\", value = [0, -0.5] } }]\n\
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
