//! What no mesh is fitted to, what does not go with `--fitted`, and how far it iterates.

use contact_vv::case::library::Bars;
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::{Place, Scene};
use contact_vv::solve::{Fitted, Formulation};

use crate::outputs::contact_vv;
use crate::scene_file::case;

/// What is said of a scene that no mesh can be fitted to.
fn refusal(scene: &Scene) -> String {
    let error = Fitted::of_digits(4).solve(scene, &Formulation::verification()).expect_err("refused");
    format!("{} {}: {}", error.place, error.message, error.remedy)
}

/// A block held at a point of its right side, where the mesh of the scene has a node.
fn held_on_a_side() -> Scene {
    let mut scene = case("eccentric-to-accuracy").scene;
    let mesh = Mesh::of(&scene, Resolution { elements: 3, refinement: 0, order: Order::Quadratic }).expect("mesh");
    let right = mesh.boundary(&scene, 0, "right").expect("side");
    scene.bodies[0].supports[0].at = Place::Point(mesh.points[right[1][0]]);
    scene
}

#[test]
fn what_no_mesh_is_fitted_to_is_refused_with_its_place_and_the_remedy() {
    let open = Bars { push: 0.9, ..Bars::default() }.scene();
    let refused = [
        (open, "bar", "no candidate is closed"),
        (Bars::default().scene(), "bar", "ends where its candidates end"),
        (case("three-rings").scene, "inner fit", "ends where its candidates end"),
        (case("rings-from-gmsh").scene, "inner", "the mesh of this body is given"),
        (case("blocks").scene, "upper", "ends where its candidates end"),
        (held_on_a_side(), "block", "there is no node at"),
    ];
    for (scene, place, message) in refused {
        let told = refusal(&scene);
        assert!(told.contains(place) && told.contains(message), "{}: {told}", scene.name);
        assert!(told.contains("leave out --fitted"), "{}: {told}", scene.name);
    }
}

#[test]
fn fitted_meshes_are_iterated_to_their_last_digit_unless_a_tolerance_is_asked_for() {
    let error = |order: &str, more: &[&str]| {
        let asked = ["solve", "pin-plate", "--fitted", "--order", order, "--no-error-bar", "--json", "-"];
        let (sound, told, error) = contact_vv(&[&asked, more].concat());
        assert!(sound, "{error}");
        let document: serde_json::Value = serde_json::from_str(&told).expect("JSON");
        document["contacts"][0]["iteration_error"]["half_width"].as_f64().expect("a number")
    };
    for order in [Order::Sextic, Order::Octic] {
        let own = error(&order.number().to_string(), &[]);
        assert!(own <= Fitted::misfit(order), "{order:?}: {own}");
    }
    let loose = error("8", &["--tolerance", "1e-3"]);
    assert!(loose > Fitted::misfit(Order::Octic), "{loose}");
}
