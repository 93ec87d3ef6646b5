//! Springs lost in the round-off of the bodies' stiffness: told with file and key, and recorded by the atlas.

use contact_vv::case::Case;
use contact_vv::solve::Discretisation;
use contact_vv::study::atlas::Plane;
use contact_vv::study::atlas::run::Ground;
use contact_vv::study::method::Class;

use crate::scene_file::{folder, text_of};

/// Springs that nothing of a stiffness in digits is left of.
const LOST: f64 = 1e-12;

#[test]
fn springs_too_soft_name_the_line_of_their_stiffness() {
    let file = folder().join("soft.toml");
    let soft = text_of("cylinder-on-block.toml").replace("[solve]\n", &format!("[solve]\nstiffness = {LOST:e}\n"));
    let error = Case::parse(&file, &soft).expect("sound").solve().map(|_| ()).expect_err("too soft").to_string();
    let line = 1 + soft[..soft.find("stiffness = ").expect("a place")].matches('\n').count();
    assert!(error.starts_with(&format!("{}:{line}: ", file.display())), "line {line}: {error}");
    assert!(error.contains("round-off") && error.contains("raise `stiffness`"), "{error}");
}

#[test]
fn atlas_records_springs_too_soft_as_unsupported() {
    let (site, method) = Plane::Cylinder.rows()[0];
    let case = site.case();
    let discretisation = Discretisation::of(case.scene, case.resolution).expect("meshed");
    let record = Ground::of(&discretisation, site, method).record(method, LOST).expect("a record");
    assert_eq!((record.class, record.iterations), (Class::Unsupported, 0));
}
