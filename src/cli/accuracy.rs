//! What `solve` says of an accuracy that was asked for.

use comfy_table::{Table, presets};
use serde::Serialize;

use crate::case::accuracy::{Answer, Asked, Quoted, Tried};
use crate::cli::say;
use crate::report::format;
use crate::scene::Path;

/// The same as JSON; an estimate that is not known is null.
#[derive(Serialize)]
pub struct Document {
    asked: f64,
    met: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    unmet: Option<String>,
    estimate: f64,
    freedoms: usize,
    freedoms_in_all: usize,
    stretch: f64,
    growth: [f64; 2],
    quantities: Vec<OneQuantity>,
    tried: Vec<OneMesh>,
}

#[derive(Serialize)]
struct OneQuantity {
    quantity: &'static str,
    estimate: f64,
    from_elements: f64,
    from_growth: f64,
    from_finer_mesh: f64,
    from_iteration: f64,
    observed_order: f64,
    observed_order_of_growth: f64,
}

#[derive(Serialize)]
struct OneMesh {
    purpose: &'static str,
    order: u8,
    elements: usize,
    growth: f64,
    stretch: f64,
    freedoms: usize,
    steps: usize,
    peak_pressure: f64,
    half_width: f64,
    estimate: f64,
}

impl Document {
    /// What was asked and what came out.
    pub fn of((asked, answer): &(Asked, Answer)) -> Self {
        let quantity = |quoted: &Quoted| OneQuantity {
            quantity: quoted.quantity.name(),
            estimate: quoted.relative,
            from_elements: quoted.elements,
            from_growth: quoted.growth,
            from_finer_mesh: quoted.check,
            from_iteration: quoted.iteration,
            observed_order: quoted.order,
            observed_order_of_growth: quoted.growth_order,
        };
        let mesh = |tried: &Tried| OneMesh {
            purpose: tried.purpose,
            order: tried.order.number(),
            elements: tried.elements,
            growth: tried.growth,
            stretch: tried.stretch,
            freedoms: tried.freedoms,
            steps: tried.steps,
            peak_pressure: tried.peak,
            half_width: tried.half_width,
            estimate: tried.estimate,
        };
        Self {
            asked: asked.relative,
            met: answer.unmet.is_none(),
            unmet: answer.unmet.clone(),
            estimate: answer.estimate(),
            freedoms: answer.run.freedoms,
            freedoms_in_all: in_all(answer),
            stretch: answer.scene.contact().stretch,
            growth: [answer.scene.grading.along, answer.scene.grading.depth],
            quantities: answer.estimates.iter().map(quantity).collect(),
            tried: answer.tried.iter().map(mesh).collect(),
        }
    }
}

fn in_all(answer: &Answer) -> usize {
    answer.tried.iter().map(|tried| tried.freedoms).sum()
}

/// Prints what was asked, what is estimated, and what was tried.
pub fn print((asked, answer): &(Asked, Answer), path: &Path) {
    let factor = crate::measure::display_factor(path);
    let unit = if factor > 1.0 { "°" } else { "mm" };
    say(format!("accuracy asked: {} %", 100.0 * asked.relative));
    for quoted in &answer.estimates {
        say(format!(
            "{}: estimated error {}: {} from the elements, {} from growth, {} from the iteration, and at least {} by a finer mesh; observed order {} along the contact, {} of growth",
            quoted.quantity.name(),
            known(quoted.relative, format::error),
            known(quoted.elements, format::error),
            known(quoted.growth, format::error),
            known(quoted.iteration, format::error),
            known(quoted.check, format::error),
            known(quoted.order, |order| format!("{order:.1}")),
            known(quoted.growth_order, |order| format!("{order:.1}"))
        ));
    }
    match &answer.unmet {
        None => say(format!(
            "met with {} freedoms; {} meshes were solved, with {} freedoms in all, the finer ones for the estimate",
            answer.run.freedoms,
            answer.tried.len(),
            in_all(answer)
        )),
        Some(why) => say(format!("NOT met: {why}; the result is the best that was found")),
    }
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    let stretch = format!("stretch [{unit}]");
    let half_width = format!("half-width [{unit}]");
    let head = ["tried for", "cells", "elements", "growth", &stretch, "freedoms", "steps", "peak [MPa]", &half_width];
    table.set_header(head.into_iter().chain(["estimate"]));
    for tried in &answer.tried {
        table.add_row([
            tried.purpose.to_owned(),
            format!("{}-node", tried.order.nodes_per_cell()),
            tried.elements.to_string(),
            format!("{:.3}", tried.growth),
            format::value(factor * tried.stretch),
            if tried.freedoms == 0 { "contact beyond".into() } else { tried.freedoms.to_string() },
            tried.steps.to_string(),
            known(tried.peak, format::value),
            known(factor * tried.half_width, format::value),
            known(tried.estimate, format::error),
        ]);
    }
    say(table);
}

fn known(value: f64, shown: impl Fn(f64) -> String) -> String {
    if value.is_finite() { shown(value) } else { "–".into() }
}
