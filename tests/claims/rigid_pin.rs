//! A rigid pin in an elastic plate: no closed form but that of small angles, so it is held by geometry, equilibrium, that limit,
//! a very stiff pin, and refinement.

use approx::assert_relative_eq;
use contact_vv::scene::{Circle, Profile};
use contact_vv::solve::Run;

use crate::scene_file::{changed, text_of};
use crate::workbench::parsed;

fn text() -> String {
    text_of("rigid-pin.toml")
}

fn run(text: &str) -> Run {
    let case = parsed(text);
    case.solve().unwrap_or_else(|error| panic!("{error}")).1
}

/// The file with the force on a half, and mesh and stretch for the contact that Hertz gives there, times `times` its own.
fn under(times: f64) -> String {
    let root = times.sqrt();
    let [force, stretch, per] = [
        format!("force = [0, {}]", 0.32955 * times),
        format!("stretch = {}", 2.0 * root),
        format!("per = {}", 0.2 * root),
    ];
    changed(&text(), &[("force = [0, 0.32955]", &force), ("stretch = 2", &stretch), ("per = 0.2", &per)])
}

#[test]
fn gap_of_a_pin_is_the_distance_along_the_radius_of_the_hole() {
    for (radius, clearance) in [(10.0, 0.01), (10.0, 3.0), (7.0, 1e-7)] {
        let pin = Circle { centre: [0.0, -clearance], radius };
        for angle in [0.0, 1e-3, 0.3, 1.0, 1.5] {
            let gap = Profile::Pin { radius, clearance }.gap(angle);
            assert_relative_eq!(gap, radius + clearance - pin.along_ray([0.0, 0.0], angle), epsilon = 1e-14);
        }
    }
}

#[test]
fn rigid_pin_comes_to_hertz_as_its_angle_falls() {
    let (load, radius) = (0.6591, 10.0 * 10.01 / 0.01);
    let errors = [0.25, 1.0, 4.0].map(|times: f64| {
        let run = run(&under(times));
        assert_relative_eq!(run.transmitted(), times * load, max_relative = 1e-8);
        // p0 = √(P E*/(π R)), E* that of the plate alone: E in plane stress.
        let hertz = (times * load * 210e3 / (std::f64::consts::PI * radius)).sqrt();
        1.0 - run.measures().peak.pressure / hertz
    });
    let [quarter, whole, fourfold] = errors;
    assert!(fourfold.abs() <= 0.007 && whole.abs() <= 0.004 && quarter.abs() <= 0.002, "{errors:?}");
    // What Hertz leaves out goes with the angle, and that with the root of the load.
    for ratio in [fourfold / whole, whole / quarter] {
        assert!((1.6..=2.4).contains(&ratio), "{errors:?}");
    }
}

#[test]
fn very_stiff_pin_is_a_rigid_one() {
    let pin = "[[body]]\nname = \"pin\"\nyoung = 210e8\npoisson = 0.3\n\
               shape = { disc = { centre = [0, -0.01], radius = 10, half = true } }\n\
               supports = [{ at = \"axis\", component = \"x\" }, { at = \"middle\", component = \"y\" }]\n\n[contact]\n";
    let rigid = run(&text());
    let stiff = |young: &str| {
        let second = "first = \"plate\"\nsecond = \"pin\"";
        run(&changed(&text(), &[("[contact]\n", &pin.replace("210e8", young)), ("first = \"plate\"", second)]))
    };
    let (near, far) = (stiff("210e8"), stiff("210e3"));
    let [wanted, found] = [&rigid, &near].map(|run| run.measures());
    assert_relative_eq!(found.peak.pressure, wanted.peak.pressure, max_relative = 1e-4);
    assert_relative_eq!(found.second_moment_width, wanted.second_moment_width, max_relative = 1e-4);
    // And one of the plate's own material is not: about √2 wider.
    assert!(far.measures().second_moment_width > 1.3 * wanted.second_moment_width);
}
