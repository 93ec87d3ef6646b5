//! Growth follows the elements, so that refinement goes to the solution.

use contact_vv::case::library::TruncatedHertz;
use contact_vv::mesh::Order;
use contact_vv::scene::Grading;
use contact_vv::solve::{Formulation, Run};

use crate::scene_file::text_of;
use crate::workbench::{meshed, parsed};

#[test]
fn refinement_of_default_meshes_goes_to_the_solution() {
    let numbers = TruncatedHertz::default();
    let mut scene = TruncatedHertz::default().scene();
    // The growth that scene files have by default.
    scene.grading = Grading { along: 1.7, depth: 1.6, coarsest: 0.3, ..scene.grading };
    let peak = 2.0 * numbers.load() / (std::f64::consts::PI * numbers.half_width());
    for (order, most) in [(Order::Linear, 3e-4), (Order::Quadratic, 2e-4)] {
        let error = |elements: usize, follows: bool| {
            let mut scene = scene.clone();
            if follows {
                scene.grading = order.refined(&scene.grading, elements as f64 / 8.0);
            }
            let discretisation = meshed(scene, elements, order);
            let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
            (run.measures().peak.pressure / peak - 1.0).abs()
        };
        let [coarse, fine] = [error(8, true), error(48, true)];
        assert!(fine <= most && fine < 0.2 * coarse, "{order:?}: {coarse:e}, {fine:e}");
        if order == Order::Linear {
            let stays = error(48, false);
            assert!(stays > 3.0 * fine, "growth that stays leaves {stays:e}");
        }
    }
    // In scene files it follows the elements beyond sixteen, where none is given.
    let text = |elements: usize, growth: &str| {
        let text = text_of("two-cylinders.toml");
        text.replace("elements = 12\n", &format!("elements = {elements}\n{growth}"))
    };
    let grading = |elements: usize, growth: &str| {
        let file = parsed(&text(elements, growth));
        file.scene.grading
    };
    assert!((grading(16, "").along - 1.7).abs() < 1e-12 && (grading(64, "").along - 1.7_f64.sqrt()).abs() < 1e-12);
    assert!((grading(64, "growth = { along = 1.4 }\n").along - 1.4).abs() < 1e-12);
}
