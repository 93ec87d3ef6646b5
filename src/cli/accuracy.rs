//! What `solve` says of an accuracy that was asked for.

use comfy_table::{Table, presets};
use serde::Serialize;

use crate::accuracy::{Answer, Asked, Quoted, Tried, TriedContact};
use crate::cli::terminal::say;
use crate::markdown;
use crate::measure::display_factor;

/// The same as JSON; an estimate that is not known is null.
#[derive(Serialize)]
pub struct Document {
    asked: f64,
    met: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    unmet: Option<String>,
    estimate: f64,
    #[serde(rename = "freedoms")]
    dofs: usize,
    #[serde(rename = "freedoms_in_all")]
    dofs_in_all: usize,
    stretches: Vec<f64>,
    growth: [f64; 2],
    quantities: Vec<OneQuantity>,
    tried: Vec<OneMesh>,
}

#[derive(Serialize)]
struct OneQuantity {
    contact: String,
    quantity: &'static str,
    estimate: f64,
    from_mesh: f64,
    from_iteration: f64,
    from_penalty: f64,
}

#[derive(Serialize)]
struct OneMesh {
    purpose: &'static str,
    order: u8,
    elements: usize,
    growth: f64,
    #[serde(rename = "freedoms")]
    dofs: usize,
    #[serde(rename = "steps")]
    iterations: usize,
    contacts: Vec<OneContact>,
    estimate: f64,
}

#[derive(Serialize)]
struct OneContact {
    stretch: f64,
    peak_pressure: f64,
    half_width: f64,
}

impl Document {
    /// What was asked and what came out.
    pub fn of((asked, answer): &(Asked, Answer)) -> Self {
        let quantity = |quoted: &Quoted| OneQuantity {
            contact: answer.scene.contacts[quoted.contact].name.clone(),
            quantity: quoted.quantity.name(),
            estimate: quoted.relative(),
            from_mesh: parts(quoted)[0],
            from_iteration: parts(quoted)[1],
            from_penalty: parts(quoted)[2],
        };
        let contact = |found: &TriedContact| OneContact {
            stretch: found.stretch,
            peak_pressure: found.peak,
            half_width: found.half_width,
        };
        let mesh = |tried: &Tried| OneMesh {
            purpose: tried.purpose,
            order: tried.order.number(),
            elements: tried.elements,
            growth: tried.growth,
            dofs: tried.dofs,
            iterations: tried.iterations,
            contacts: tried.contacts.iter().map(contact).collect(),
            estimate: tried.estimate,
        };
        Self {
            asked: asked.relative,
            met: answer.unmet.is_none(),
            unmet: answer.unmet.clone(),
            estimate: answer.estimate(),
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
            stretches: answer.scene.contacts.iter().map(|pair| pair.stretch).collect(),
            growth: [answer.scene.grading.along, answer.scene.grading.depth],
            quantities: answer.estimates.iter().map(quantity).collect(),
            tried: answer.tried.iter().map(mesh).collect(),
        }
    }
}

/// Prints what was asked, what is estimated, and what was tried.
pub fn print((asked, answer): &(Asked, Answer)) {
    let contacts = &answer.scene.contacts;
    say(format!("accuracy asked: {} %", 100.0 * asked.relative));
    for quoted in &answer.estimates {
        let of = if contacts.len() > 1 { format!("{}, ", contacts[quoted.contact].name) } else { String::new() };
        say(of + &sentence(quoted));
    }
    match &answer.unmet {
        None => say(format!(
            "met with {} dofs; {} meshes were tried, with {} dofs in all, those of the coarser ones of their bars among them",
            answer.run.dofs,
            answer.tried.len(),
            answer.dofs_in_all()
        )),
        Some(why) => say(format!("NOT met: {why}; the result is the best that was found")),
    }
    say(meshes(answer));
}

/// Mesh, iteration and penalty over the value.
fn parts(Quoted { value, bar, .. }: &Quoted) -> [f64; 3] {
    [bar.mesh, bar.iteration, bar.penalty].map(|part| (part / value).abs())
}

/// What is estimated of a quantity, and from what.
fn sentence(quoted: &Quoted) -> String {
    let [mesh, iteration, penalty] = parts(quoted).map(|part| known(part, markdown::error));
    let (name, bar) = (quoted.quantity.name(), known(quoted.relative(), markdown::error));
    format!("{name}: error bar {bar}: {mesh} from the mesh, {iteration} from the iteration, {penalty} from the penalty")
}

/// A row for each mesh that was solved, in it a line for each contact.
fn meshes(answer: &Answer) -> Table {
    let factors: Vec<f64> = answer.scene.contacts.iter().map(|pair| display_factor(&pair.path)).collect();
    let unit = match factors.iter().filter(|factor| **factor > 1.0).count() {
        0 => "mm",
        arcs if arcs == factors.len() => "°",
        _ => "mm, °",
    };
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    let [stretch, half_width] = ["stretch", "half-width"].map(|length| format!("{length} [{unit}]"));
    let head = ["tried for", "cells", "elements", "growth", &stretch, "dofs", "iterations", "peak [MPa]", &half_width];
    table.set_header(head.into_iter().chain(["estimate"]));
    let lines = |tried: &Tried, of: fn(&TriedContact, f64) -> String| -> String {
        let each: Vec<String> = tried.contacts.iter().zip(&factors).map(|(found, factor)| of(found, *factor)).collect();
        each.join("\n")
    };
    for tried in &answer.tried {
        table.add_row([
            tried.purpose.to_owned(),
            format!("{}-node", tried.order.nodes_per_cell()),
            tried.elements.to_string(),
            known(tried.growth, |growth| format!("{growth:.3}")),
            lines(tried, |found, factor| markdown::value(factor * found.stretch)),
            if tried.dofs == 0 { "contact beyond".into() } else { tried.dofs.to_string() },
            tried.iterations.to_string(),
            lines(tried, |found, _| known(found.peak, markdown::value)),
            lines(tried, |found, factor| known(factor * found.half_width, markdown::value)),
            known(tried.estimate, markdown::error),
        ]);
    }
    table
}

fn known(value: f64, shown: impl Fn(f64) -> String) -> String {
    if value.is_finite() { shown(value) } else { "–".into() }
}
