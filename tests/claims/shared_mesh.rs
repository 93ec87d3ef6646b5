//! Bodies in several contacts: their meshes are fine at each, and every stretch ends on a node.

use std::path::Path;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::Case;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::size::expected;
use contact_vv::scene::Scene;

use crate::scene_file::{case, text_of};
use crate::workbench::parsed;

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
    let error = Case::parse(Path::new("large.toml"), &text).map(|_| ()).expect_err("too large").to_string();
    assert!(error.contains("the mesh would have about"), "{error}");
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
