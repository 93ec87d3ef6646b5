//! The error bars of a solve, as a table and as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::accuracy::{Bar, Barred, Bars, Told};
use crate::cli::solve::found::Found;
use crate::cli::terminal::{say, say_in_lines, table, whole};
use crate::markdown::{self, EXACT, to_bound, unsigned};
use crate::report::grouped::in_order;

/// A number and how far it may be from the truth; what is not known is null, and angles are in radians.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ErrorBar")]
pub struct Document {
    /// The contact, or the body.
    of: String,
    /// What it is.
    quantity: String,
    /// The number.
    value: f64,
    /// How far it may be from the truth: the sum of the parts.
    bar: f64,
    #[serde(flatten)]
    parts: Bar,
    /// Why the bar is not known, where it is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    unknown: Option<&'static str>,
}

impl Document {
    /// Every bar of a solve.
    pub fn all(found: &Found) -> Vec<Self> {
        let one = |one: &Barred| {
            let Told { of, quantity, .. } = Told::of(&found.problem.scene, &found.run, one);
            let Barred { value, bar: parts, unknown, .. } = *one;
            Self { of, quantity, value, bar: parts.total(), parts, unknown }
        };
        found.barred().iter().map(one).collect()
    }
}

/// Heads of the columns of numbers with their bars.
pub const HEAD: [&str; 7] = ["of", "quantity", "value ± error bar", "unit", "mesh", "iteration", "penalty"];

/// Every number with its bar, and the parts of that.
pub fn rows(found: &Found) -> Vec<[String; 7]> {
    let row = |one: &Barred| {
        let Told { of, quantity, unit, factor } = Told::of(&found.problem.scene, &found.run, one);
        let Bar { mesh, iteration, penalty } = one.bar;
        let part = |part: f64| if part.is_nan() { "unknown".into() } else { markdown::significant(factor * part, 2) };
        let value = match one.value {
            _ if found.run.is_unbounded(one.contact, &one.quantity) => "without limit".into(),
            value if value.is_nan() => "unknown".into(),
            value => {
                let (value, bar) = (factor * value, factor * one.bar.total());
                let told =
                    if bar > EXACT * value.abs() { unsigned(to_bound(value, bar)) } else { markdown::value(value) };
                format!("{told} ± {}", part(one.bar.total()))
            }
        };
        [of, quantity, value, unit.into(), part(mesh), part(iteration), part(penalty)]
    };
    found.barred().iter().map(row).collect()
}

/// Prints every number with its bar.
pub fn print(found: &Found) {
    let Some(Bars { all, meshes, .. }) = &found.bars else { return };
    let rows = rows(found);
    // Few scenes have a penalty, and the lines of most fit 80 columns without.
    let columns = if rows.iter().all(|row| row[6] == "0") { 6 } else { 7 };
    let mut table = table(HEAD[..columns].iter().copied());
    let mut unknown: Vec<(&str, String)> = Vec::new();
    for (one, [of, quantity, ..]) in all.iter().zip(&rows) {
        unknown.extend(one.unknown.map(|why| (why, format!("{quantity} of `{of}`"))));
    }
    table.add_rows(rows.iter().map(|row| &row[..columns]));
    say(whole(table));
    for (why, numbers) in in_order(unknown) {
        let of = if numbers.len() == all.len() { "every number".into() } else { numbers.join(", ") };
        say_in_lines(&format!("unknown, since {why}: {of}"));
    }
    if *meshes == 0 {
        say("give more elements, or for a mesh made elsewhere `--accuracy`, which halves it");
    }
}
