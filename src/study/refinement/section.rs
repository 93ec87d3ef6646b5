//! Tables of the meshes, with the orders between each two of them.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::measure::order::{Observed, Why};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::refinement::run::{
    Departure, Errors, ModelError, Numbers, Orders, PinLevel, PinRod, PinSeries, Ratio,
};

/// How far the contact's edge may move within its element from mesh to mesh and still be said to stay \[elements\].
const STAYS: f64 = 0.1;

/// Orders, model error, and the series of the pin–rod.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::new();
    text += &picture("orders.svg", "Observed orders of accuracy");
    text += "Orders are read between each two successive meshes. Those of a series whose errors, or changes, do not keep their sign \
             and fall are withheld, as are those of errors near what no mesh removes. The edge is where the contact ends: its distance \
             from the nearest node, outwards positive, in elements.\n\n";
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

/// An order in a table.
fn cell(observed: Option<&Observed>) -> String {
    match observed {
        None => "–".into(),
        Some(Observed::Order(order)) => format!("{order:.2}"),
        Some(Observed::Withheld(Why::NotMonotone)) => "withheld".into(),
        Some(Observed::Withheld(Why::Floor)) => "withheld: floor".into(),
    }
}

fn is_withheld(pairs: &[Observed]) -> bool {
    pairs.iter().any(|pair| matches!(pair, Observed::Withheld(Why::NotMonotone)))
}

/// A length in elements; round-off has no sign.
fn elements(length: f64) -> String {
    if length.abs() < 0.005 { "0.00".into() } else { format!("{length:+.2}") }
}

fn orders(numbers: &Orders) -> (String, String) {
    let errors: [fn(&Errors) -> f64; 3] = [|level| level.peak, |level| level.half_width, |level| level.l2];
    let pairs = errors.map(|of| numbers.pairs(of));
    let rows = numbers.levels.iter().enumerate().map(|(k, level)| {
        let read = |series: usize| cell(k.checked_sub(1).and_then(|before| pairs[series].get(before)));
        let error = |series: usize| match errors[series](level) {
            norm if series == 2 => format!("{norm:.2e}"),
            error => format!("{error:+.2e}"),
        };
        let own = (0..3).flat_map(|series| [error(series), read(series)]);
        let start = [format!("{:.4}", level.size), level.dofs.to_string()];
        start.into_iter().chain(own).chain([elements(level.edge)]).collect()
    });
    let head = ["h / a", "dofs", "p₀", "order", "a", "order", "L2(p)", "order", "edge"].map(String::from);
    let mut table = markdown::table(&head, &rows.collect::<Vec<_>>());
    if is_withheld(&pairs[1]) {
        let edges: Vec<f64> = numbers.levels.iter().map(|level| level.edge).collect();
        table += &format!("\n{}\n", why_withheld("the error of the second-moment width", &edges));
    }
    let title = format!("Truncated Hertz, {}-node: errors on nested meshes", numbers.order.nodes_per_cell());
    (title, table)
}

/// Whether the contact's edge wanders within its element, where a series is not monotone.
fn why_withheld(series: &str, edges: &[f64]) -> String {
    let most = edges.iter().copied().fold(f64::NAN, f64::max);
    let moves = most - edges.iter().copied().fold(f64::NAN, f64::min);
    let told = markdown::significant(moves, 2);
    if moves <= STAYS {
        format!(
            "No order can be read from {series}, which is not monotone. It is not that the contact's edge wanders within its element, \
             where it moves by {told} of an element: terms of different order and sign cancel."
        )
    } else {
        format!(
            "No order can be read from {series}, which is not monotone: the contact's edge wanders by {told} of an element from mesh to mesh."
        )
    }
}

fn model_error(numbers: &ModelError) -> (String, String) {
    let departures: [fn(&Ratio) -> Departure; 2] = [|ratio| ratio.peak, |ratio| ratio.half_width];
    let powers = departures.map(|of| numbers.powers(of));
    let rows = numbers.ratios.iter().rev().enumerate().map(|(k, ratio)| {
        let own = (0..2).flat_map(|series| {
            let Departure { value, bound } = departures[series](ratio);
            let read = cell(k.checked_sub(1).and_then(|before| powers[series].get(before)));
            [format!("{value:+.2e}"), format!("{bound:.0e}"), read]
        });
        [ratio.a_over_r.to_string()].into_iter().chain(own).chain([ratio.dofs.to_string()]).collect()
    });
    let head =
        ["a/R", "p₀ / Hertz − 1", "bound of the mesh", "power", "a / Hertz − 1", "bound of the mesh", "power", "dofs"];
    let title = format!(
        "Cylinder: model error against Hertz, and the power of a/R by which it falls ({} elements per half-width)",
        numbers.elements
    );
    (title, markdown::table(&head.map(String::from), &rows.collect::<Vec<_>>()))
}

fn pin_rod(numbers: &PinRod) -> (String, String) {
    let rows: Vec<Vec<String>> = numbers.series.iter().flat_map(pin_rows).collect();
    let head = ["cells", "elements / 10 mm", "dofs", "peak [MPa]", "order", "2 √(∫pθ²/∫p) [°]", "order", "edge"]
        .map(String::from);
    let mut table = markdown::table(&head, &rows);
    for series in &numbers.series {
        let withheld =
            is_withheld(&series.pairs(|level| level.peak)) || is_withheld(&series.pairs(|level| level.angle));
        if withheld {
            let edges = series.levels.each_ref().map(|level| level.edge);
            table += &format!(
                "\n{}\n",
                why_withheld(&format!("the series of {}-node cells", series.order.nodes_per_cell()), &edges)
            );
        }
    }
    ("Pin–rod: refinement series, orders between successive changes".into(), table)
}

fn pin_rows(series: &PinSeries) -> Vec<Vec<String>> {
    let read: [fn(&PinLevel) -> f64; 2] = [|level| level.peak, |level| level.angle];
    let pairs = read.map(|of| series.pairs(of));
    let rows = series.levels.iter().enumerate().map(|(k, level)| {
        let order = |number: usize| cell(k.checked_sub(2).and_then(|before| pairs[number].get(before)));
        vec![
            format!("{}-node", series.order.nodes_per_cell()),
            level.elements.to_string(),
            level.dofs.to_string(),
            format!("{:.3}", level.peak),
            order(0),
            format!("{:.3}", level.angle.to_degrees()),
            order(1),
            elements(level.edge),
        ]
    });
    rows.collect()
}
