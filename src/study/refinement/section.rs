//! Tables of the meshes.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::refinement::run::{ModelError, Numbers, Orders, PinRod};

/// Orders, model error, and the series of the pin–rod.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::from("## Refinement\n\n");
    text += &picture("orders.svg", "Observed orders of accuracy");
    for found in findings {
        let (title, table) = match found.numbers {
            Numbers::Orders(numbers) => orders(numbers),
            Numbers::ModelError(numbers) => model_error(numbers),
            Numbers::PinRod(numbers) => pin_rod(numbers),
        };
        let _ = write!(text, "**{title}**\n\n{table}\n");
    }
    Ok(text)
}

fn orders(numbers: &Orders) -> (String, String) {
    let orders = [numbers.order_of(|l| l.peak), numbers.order_of(|l| l.half_width), numbers.order_of(|l| l.l2)];
    let title = format!(
        "Truncated Hertz, {}-node: errors on nested meshes (orders: p₀ {:.2}, a {:.2}, L2 {:.2})",
        numbers.order.nodes_per_cell(),
        orders[0],
        orders[1],
        orders[2]
    );
    let rows = numbers.levels.iter().map(|level| {
        let errors = [level.peak, level.half_width, level.l2].map(|error| format!("{error:.2e}"));
        [format!("{:.4}", level.size), level.dofs.to_string()].into_iter().chain(errors).collect()
    });
    let head = ["h / a", "dofs", "p₀", "a", "L2(p)"].map(String::from);
    (title, markdown::table(&head, &rows.collect::<Vec<_>>()))
}

fn model_error(numbers: &ModelError) -> (String, String) {
    let rows = numbers.ratios.iter().map(|ratio| {
        let ratios = [ratio.peak, ratio.half_width].map(|ratio| format!("{ratio:.4}"));
        [ratio.a_over_r.to_string()].into_iter().chain(ratios).chain([ratio.dofs.to_string()]).collect()
    });
    let head = ["a/R", "p₀ / Hertz", "a / Hertz", "dofs"].map(String::from);
    let title = format!("Cylinder: model error against Hertz ({} elements per half-width)", numbers.elements);
    (title, markdown::table(&head, &rows.collect::<Vec<_>>()))
}

fn pin_rod(numbers: &PinRod) -> (String, String) {
    let rows = numbers.series.iter().flat_map(|series| {
        series.levels.iter().map(|level| {
            vec![
                format!("{}-node", series.order.nodes_per_cell()),
                level.elements.to_string(),
                level.dofs.to_string(),
                format!("{:.3}", level.peak),
                format!("{:.3}", level.angle.to_degrees()),
            ]
        })
    });
    let head = ["cells", "elements / 10 mm", "dofs", "peak [MPa]", "2 √(∫pθ²/∫p) [°]"].map(String::from);
    ("Pin–rod: refinement series".into(), markdown::table(&head, &rows.collect::<Vec<_>>()))
}
