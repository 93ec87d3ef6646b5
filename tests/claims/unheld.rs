//! A missing support is named by its body and direction, and the contact is not blamed for it.

use contact_vv::case::Case;

use crate::scene_file::{folder, text_of};

/// What a file says and what it gets instead, the line the message must name, and parts of it.
const MISSING: &[(&str, &str, &str, &str, &[&str])] = &[
    // No contact acts along the motion.
    (
        "cylinder-on-block",
        "supports = [{ at = \"left\", component = \"x\" }, ",
        "supports = [",
        "name = \"block\"",
        &[
            "free to slide along x",
            "its contacts do not act there",
            "add a support along x, on a boundary (`left`, `right`, `far`)",
        ],
    ),
    // Two bodies hold one another, and nothing holds both.
    (
        "cylinder-on-block",
        ", { at = \"far\", component = \"y\" }]",
        "]",
        "name = \"cylinder\"",
        &["`cylinder` and `block` are free to slide along y together", "add a support along y to one of them"],
    ),
    (
        "two-cylinders",
        ", { at = \"cut\", component = \"y\" }",
        "",
        "name = \"steel\"",
        &["`steel` and `aluminium` are free to slide along y together", "add a support along y to one of them"],
    ),
    // Interference pushes the inner ring up, and nothing brings it back.
    (
        "press-fit",
        "{ at = \"start\", component = \"x\" }, { at = \"end\", component = \"y\" }]\n",
        "{ at = \"start\", component = \"x\" }]\n",
        "name = \"inner\"",
        &["nothing presses `inner` into its contact", "free to slide along y", "add a support along y"],
    ),
    // The load pulls.
    (
        "blocks",
        "value = [0, -100]",
        "value = [0, 100]",
        "name = \"upper\"",
        &[
            "no contact spring is left",
            "the load moves `upper` out of its contact",
            "reverse the load, or add a support along y",
        ],
    ),
];

#[test]
fn missing_support_is_named_by_body_and_direction_whatever_the_algorithm() {
    for (name, was, is, anchor, wanted) in MISSING {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}");
        for algorithm in ["kinematic", "varying"] {
            if *name == "press-fit" && algorithm == "varying" {
                // Interference is not defined for it.
                continue;
            }
            let spoiled =
                text.replacen(was, is, 1).replacen("[solve]\n", &format!("[solve]\nalgorithm = \"{algorithm}\"\n"), 1);
            let case = Case::parse(&folder().join(format!("{name}.toml")), &spoiled).expect("sound");
            let error = case.solve().map(|_| ()).expect_err(name);
            let error = case.places.as_ref().expect("a file").locate(error).to_string();
            let line = 1 + spoiled[..spoiled.find(anchor).expect("the line")].matches('\n').count();
            assert!(error.contains(&format!("{name}.toml:{line}: ")), "line {line}: {error}");
            wanted.iter().for_each(|part| assert!(error.contains(part), "{algorithm}: `{part}` is not in: {error}"));
            for blamed in ["raise `stiffness`", "raise the initial stiffness", "NaN", "refine the mesh", "initial gap"]
            {
                assert!(!error.contains(blamed), "{algorithm}: {error}");
            }
        }
    }
}

#[test]
fn scenes_that_hold_are_not_said_to_miss_a_support() {
    for name in
        ["cylinder-on-block", "two-cylinders", "press-fit", "eccentric-load", "rigid-pin", "roller-between-plates"]
    {
        let case =
            Case::parse(&folder().join(format!("{name}.toml")), &text_of(&format!("{name}.toml"))).expect("sound");
        let discretisation = contact_vv::solve::Discretisation::of(case.scene, case.resolution).expect("meshed");
        let found = discretisation.unheld(1.0).expect("motions");
        assert!(found.is_none(), "{name}: {found:?}");
        // Pulled instead of pressed, a body that contact alone holds leaves it.
        let pulled = discretisation.unheld(-1.0).expect("motions");
        let alone = ["cylinder-on-block", "eccentric-load", "rigid-pin"].contains(&name);
        assert!(pulled.is_some() || !alone, "{name}");
    }
}
