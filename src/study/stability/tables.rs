//! The tables of the predictions.

use crate::case::{Judged, Verdict};
use crate::markdown;
use crate::study::Found;
use crate::study::stability::basin::Far;
use crate::study::stability::fixed_target::{End, Target, end};
use crate::study::stability::halving::{Law, Mesh, Scene};
use crate::study::stability::judge::{asymptotic, followed, is_measurable, off};
use crate::study::stability::{Numbers, basin, before, failing, rates};

/// A table of all trials: the rows that each of them has there.
fn table(head: &[&str], findings: &[Found<Numbers>], rows: impl Fn(&Found<Numbers>) -> Vec<Vec<String>>) -> String {
    let head: Vec<String> = head.iter().map(|text| text.to_string()).collect();
    markdown::table(&head, &findings.iter().flat_map(rows).collect::<Vec<_>>())
}

/// Starts by how they end, a folded table for each element.
pub fn fixed_target(findings: &[Found<Numbers>]) -> String {
    let head = ["largest κ*", "converges", "crawls", "diverges"].map(String::from);
    let row = |target: &Target| {
        let ending = |of: End| target.starts.iter().filter(|start| end(start.observed) == of).count();
        let counts = [End::Converges, End::Crawls, End::Diverges].map(ending);
        [vec![target.largest.to_string()], counts.map(|count| count.to_string()).into()].concat()
    };
    let folded = |found: &Found<Numbers>| {
        let Numbers::FixedTarget(targets) = found.numbers else { return None };
        let title = format!("{}, {}: starts κ₀ from 1e-6 to 1e6 by how they end", found.case, found.name);
        let rows: Vec<Vec<String>> = targets.iter().map(row).collect();
        Some(markdown::folded(&title, &markdown::table(&head, &rows), false))
    };
    findings.iter().filter_map(folded).collect()
}

/// Every start, predicted and measured.
pub fn rates(findings: &[Found<Numbers>]) -> String {
    let head = [
        "method",
        "κ₀",
        "measured",
        "predicted ρ",
        "ln ρ off",
        "verdict",
        "linearised, same errors",
        "ln ρ off",
        "verdict",
    ];
    table(&head, findings, |found| match found.numbers {
        Numbers::Rates(starts) => starts.iter().map(|start| rate(found.name, start)).collect(),
        _ => Vec::new(),
    })
}

fn rate(method: &str, start: &rates::Start) -> Vec<String> {
    let optional = |rate: Option<f64>| rate.map_or("–".into(), |rate| format!("{rate:.6}"));
    let off = |predicted: Option<f64>| {
        let off = predicted.zip(start.measured).map(|(predicted, measured)| off(predicted, measured));
        off.map_or("–".into(), |off| format!("{:.1} %", 100.0 * off))
    };
    let verdict = |judged: Option<Judged>, without: &str| match judged {
        _ if !is_measurable(start) => "not measurable".to_string(),
        Some(judged) if judged.verdict == Verdict::Pass => "✓".into(),
        Some(_) => "✗".into(),
        None => without.into(),
    };
    vec![
        method.into(),
        start.stiffness.to_string(),
        optional(start.measured),
        format!("{:.6}", start.predicted),
        off(Some(start.predicted)),
        verdict(asymptotic(start), "not alone above round-off"),
        optional(start.linearised),
        off(start.linearised),
        verdict(followed(start), "–"),
    ]
}

/// Every mesh, predicted by the closed form and measured.
pub fn before(findings: &[Found<Numbers>]) -> String {
    let head = [
        "scene",
        "L/a",
        "elements per a",
        "first node outside, x/a",
        "ρ by Hertz",
        "measured ρ",
        "ln ρ: measured / Hertz",
    ];
    let row = |scene: &str, start: &before::Start| {
        vec![
            scene.into(),
            start.stretch.to_string(),
            start.elements.to_string(),
            format!("{:.4}", start.place),
            format!("{:.5}", start.predicted),
            start.measured.map_or("–".into(), |measured| format!("{measured:.5}")),
            start.ratio().map_or("–".into(), |ratio| format!("{ratio:.2}")),
        ]
    };
    table(&head, findings, |found| match found.numbers {
        Numbers::Before(starts) => starts.iter().map(|start| row(found.name, start)).collect(),
        _ => Vec::new(),
    })
}

/// Both rules from every start.
pub fn failing(findings: &[Found<Numbers>]) -> String {
    let head = [
        "element",
        "κ₀",
        "largest κ*/2",
        "secant: predicted ρ",
        "secant: outcome",
        "literal: outcome",
        "literal: force left in open points, over the peak",
    ];
    let row = |element: &str, start: &failing::Start| {
        let rate = start.predicted;
        vec![
            element.into(),
            format!("{:e}", start.stiffness),
            format!("{:.1e}", start.needed),
            if rate > 10.0 { format!("{rate:.0}") } else { format!("{rate:.6}") },
            start.secant.to_string(),
            start.literal.to_string(),
            format!("{:.1e}", start.left),
        ]
    };
    table(&head, findings, |found| match found.numbers {
        Numbers::Failing(starts) => starts.iter().map(|start| row(found.name, start)).collect(),
        _ => Vec::new(),
    })
}

/// Every start, next to the contact and from afar.
pub fn basin(findings: &[Found<Numbers>]) -> String {
    let head = ["element", "κ₀", "predicted ρ", "next to the contact", "from equal springs"];
    let row = |element: &str, start: &basin::Start| {
        let far = match start.far {
            Far::Ended(outcome, iterations) => format!("{outcome} after {iterations}"),
            Far::NoSpringLeft(iterations) => format!("no spring left after {iterations}"),
        };
        let near = if start.stays { "stays" } else { "leaves" };
        vec![element.into(), start.stiffness.to_string(), format!("{:.3}", start.predicted), near.into(), far]
    };
    table(&head, findings, |found| match found.numbers {
        Numbers::Basin(starts) => starts.iter().map(|start| row(found.name, start)).collect(),
        _ => Vec::new(),
    })
}

/// Predicted and measured iterations, a folded table for each scene.
pub fn halving(findings: &[Found<Numbers>]) -> String {
    let folded = |found: &Found<Numbers>| {
        let Numbers::Halving(law) = found.numbers else { return None };
        let title = format!("{}: {}", found.case, found.name);
        Some(markdown::folded(&title, &law_table(law), false))
    };
    findings.iter().filter_map(folded).collect()
}

fn law_table(law: &Law) -> String {
    let pin_rod = law.scene == Scene::PinRod;
    let [stretch, elements] =
        if pin_rod { ["L / last closed point", "elements per 10 mm"] } else { ["L/a", "elements per a"] };
    let starts = law.meshes.first().into_iter().flat_map(|mesh| mesh.iterations);
    let starts = starts.map(|iterations| format!("predicted / measured, κ₀ = {:e}", iterations.stiffness));
    let head: Vec<String> = [stretch, elements].map(String::from).into_iter().chain(starts).collect();
    let row = |mesh: &Mesh| {
        let stretch = if pin_rod { format!("{:.2}", mesh.stretch) } else { mesh.stretch.to_string() };
        let iterations = mesh.iterations.map(|iterations| {
            let measured = iterations.measured.map_or("not converged".into(), |measured| measured.to_string());
            format!("{} / {measured}", iterations.predicted)
        });
        [stretch, mesh.elements.to_string()].into_iter().chain(iterations).collect()
    };
    markdown::table(&head, &law.meshes.iter().map(row).collect::<Vec<_>>())
}
