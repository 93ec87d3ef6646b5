//! What `solve` says of an accuracy that was asked for.

use std::borrow::Cow;

use comfy_table::Table;
use schemars::JsonSchema;
use serde::Serialize;

use crate::accuracy::{Answer, Asked, Barred, Tried, TriedContact, in_percent};
use crate::cli::terminal::{say, say_in_lines, table, whole};
use crate::markdown;
use crate::measure::display_factor;

/// What came of an accuracy that was asked for; an estimate that is not known is null, and angles are in radians.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Accuracy")]
pub struct Document<'a> {
    /// The relative error accepted.
    asked: f64,
    /// Whether it is met.
    met: bool,
    /// Why it is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    unmet: Option<&'a str>,
    /// The largest estimate of the quantities asked for.
    estimate: f64,
    /// Most degrees of freedom that a mesh may have; left out where that is not bounded.
    #[serde(rename = "freedoms_at_most", skip_serializing_if = "Option::is_none")]
    most_dofs: Option<usize>,
    /// Those of the mesh that would have been next, where that bound ended the search.
    #[serde(rename = "freedoms_of_next", skip_serializing_if = "Option::is_none")]
    next: Option<usize>,
    /// Degrees of freedom of the mesh chosen.
    #[serde(rename = "freedoms")]
    dofs: usize,
    /// Those of all meshes that were solved.
    #[serde(rename = "freedoms_in_all")]
    dofs_in_all: usize,
    /// Candidate stretch of every contact.
    stretches: Vec<f64>,
    /// Growth along the contact and into the depth.
    growth: [f64; 2],
    /// What is estimated of each quantity.
    quantities: Vec<OneQuantity<'a>>,
    /// Every mesh that was solved.
    tried: &'a [Tried],
}

/// What is estimated of a quantity, relative to it.
#[derive(Serialize, JsonSchema)]
struct OneQuantity<'a> {
    /// Name of the contact.
    contact: &'a str,
    /// The quantity.
    quantity: Cow<'static, str>,
    /// Its error bar.
    estimate: f64,
    /// What the mesh leaves.
    from_mesh: f64,
    /// What the iteration leaves.
    from_iteration: f64,
    /// What the springs of a penalty leave.
    from_penalty: f64,
}

impl<'a> Document<'a> {
    /// What was asked and what came out.
    pub fn of((asked, answer): &'a (Asked, Answer)) -> Self {
        let quantity = |quoted: &Barred| {
            let [from_mesh, from_iteration, from_penalty] = parts(quoted);
            let contact = &answer.scene.contacts[quoted.contact].name;
            let (quantity, estimate) = (quoted.quantity.key(), quoted.relative());
            OneQuantity { contact, quantity, estimate, from_mesh, from_iteration, from_penalty }
        };
        Self {
            asked: asked.relative,
            met: answer.unmet.is_none(),
            unmet: answer.unmet.as_deref(),
            most_dofs: asked.most_dofs,
            next: answer.next,
            estimate: answer.estimate(),
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
            stretches: answer.scene.contacts.iter().map(|pair| pair.stretch).collect(),
            growth: [answer.scene.grading.along, answer.scene.grading.depth],
            quantities: answer.estimates.iter().map(quantity).collect(),
            tried: &answer.tried,
        }
    }
}

/// Prints what was asked, what is estimated, and what was tried.
pub fn print((asked, answer): &(Asked, Answer)) {
    let contacts = &answer.scene.contacts;
    say(format!("accuracy asked: {} %", in_percent(asked.relative)));
    for quoted in &answer.estimates {
        let of = if contacts.len() > 1 { format!("{}, ", contacts[quoted.contact].name) } else { String::new() };
        let [mesh, iteration, penalty] = parts(quoted).map(|part| known(part, markdown::error));
        let (name, bar) = (quoted.quantity.key(), known(quoted.relative(), markdown::error));
        say_in_lines(&format!("{of}{name}: error bar {bar}: mesh {mesh}, iteration {iteration}, penalty {penalty}"));
    }
    say_in_lines(&ended(answer));
    say(whole(meshes(answer)));
}

/// What was asked, and whether it is met, in a line.
pub fn outcome((asked, answer): &(Asked, Answer)) -> String {
    format!("{} % asked, {}", in_percent(asked.relative), ended(answer))
}

/// Whether what was asked is met.
fn ended(answer: &Answer) -> String {
    match &answer.unmet {
        None => format!(
            "met with {} dofs; {} tried, with {} dofs in all, those of the coarser ones of their bars among them",
            answer.run.dofs,
            if answer.tried.len() == 1 { "one mesh was".into() } else { format!("{} meshes were", answer.tried.len()) },
            answer.dofs_in_all()
        ),
        Some(why) => format!("NOT met: {why}; the result is the best that was found"),
    }
}

/// Mesh, iteration and penalty over the value.
fn parts(Barred { value, bar, .. }: &Barred) -> [f64; 3] {
    [bar.mesh, bar.iteration, bar.penalty].map(|part| (part / value).abs())
}

/// A row for each mesh that was solved, in it a line for each contact.
fn meshes(answer: &Answer) -> Table {
    let factors: Vec<f64> = answer.scene.contacts.iter().map(|pair| display_factor(&pair.path)).collect();
    let unit = match factors.iter().filter(|factor| **factor > 1.0).count() {
        0 => "mm",
        arcs if arcs == factors.len() => "°",
        _ => "mm, °",
    };
    let [stretch, half_width] = ["stretch", "half-width"].map(|length| format!("{length} [{unit}]"));
    let head = ["tried for", "cells", "elements", &stretch, "dofs", "peak [MPa]", &half_width];
    let mut table = table(head.into_iter().chain(["estimate"]));
    let lines = |tried: &Tried, of: fn(&TriedContact, f64) -> String| -> String {
        let each: Vec<String> = tried.contacts.iter().zip(&factors).map(|(found, factor)| of(found, *factor)).collect();
        each.join("\n")
    };
    for tried in &answer.tried {
        table.add_row([
            tried.purpose.to_owned(),
            format!("{}-node", tried.order.nodes_per_cell()),
            if tried.elements == 0 { "–".into() } else { tried.elements.to_string() },
            lines(tried, |found, factor| markdown::value(factor * found.stretch)),
            if tried.dofs == 0 { "contact beyond".into() } else { tried.dofs.to_string() },
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
