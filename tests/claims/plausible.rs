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
