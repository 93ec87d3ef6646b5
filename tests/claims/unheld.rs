//! A missing support is named by its body and direction, and the contact is not blamed for it.

use contact_vv::case::Case;

use crate::scene_file::{folder, text_of};
use crate::scene_mistakes::mistakes;

#[test]
fn missing_support_is_named_by_body_and_direction_whatever_the_algorithm() {
    for mistake in mistakes("unheld") {
        // Interference is not defined for varying stiffness.
        let algorithms = if mistake.file == "press-fit" { &["kinematic"][..] } else { &["kinematic", "varying"] };
        for algorithm in algorithms {
            let with = format!("[solve]\nalgorithm = \"{algorithm}\"\n");
            let (error, line) = mistake.told(&mistake.sound(), |text| text.replacen("[solve]\n", &with, 1));
            assert_eq!(mistake.unlike(&error, line, 0), None, "{algorithm}");
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
