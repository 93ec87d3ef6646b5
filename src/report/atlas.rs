//! The section on where methods fail: predictions, maps, what to do instead, and a recommendation made of the records.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::report::checks;
use crate::solve::{Element, Iteration};
use crate::study::atlas::plan::STRETCH;
use crate::study::atlas::summary::{self, Digest};
use crate::study::atlas::{ATLAS, Chart, Class, Plane, Record};
use crate::study::stability::{basin, failing, fixed_target, halving, rates};
use crate::study::unsorted::{Finding, Table};

/// The whole section.
pub fn section(findings: &[Finding]) -> Result<String, Error> {
    let charts = summary::charts()?;
    let digests = summary::digests(&charts);
    let mut text = String::from("## Where methods fail\n\n");
    text += &recommendation(&digests);
    let _ = write!(
        text,
        "\n![Steps against initial stiffness with the predicted curves](snapshots/charts/steps-predicted.svg)\n\
         *Fig. 11 once more: measured points on curves predicted from the condensed matrices; truncated Hertz, candidates to {STRETCH} \
         half-widths; colours tell the rules apart. Hollow signs above the frame: how the others ended.*\n\n"
    );
    text += LAWS;
    let _ = writeln!(text, "{}", methods(&digests));
    text += "![Maps over the candidate surface](snapshots/charts/atlas-stretch.svg)\n\
         *How every run ends over initial stiffness and candidate surface, with the predicted boundary.*\n\n\
         ![Maps over the mesh](snapshots/charts/atlas-mesh.svg)\n\
         *The same over initial stiffness and mesh.*\n\n";
    text += &slices(&charts);
    text += &predictions(findings);
    let _ = write!(text, "\n{}\n", crate::study::unsorted::titled(&summary::findings(&charts)));
    text += EXPLAINED;
    let own = |finding: &&Finding| CASES.contains(&finding.case.as_str());
    Ok(text + &checks::table(&findings.iter().filter(own).collect::<Vec<_>>()))
}

/// Trials of the section.
const CASES: [&str; 6] =
    [ATLAS, fixed_target::FIXED_TARGET, rates::RATES, failing::FAILING, basin::BASIN, halving::HALVING];

/// Which element and algorithm to use, and from which initial stiffness, from the records.
fn recommendation(digests: &[Digest]) -> String {
    let mut reliable: Vec<(&Digest, f64, usize)> = digests
        .iter()
        .filter(|digest| !digest.name.ends_with("penalty"))
        .filter_map(|digest| digest.best.map(|(stiffness, steps)| (digest, stiffness, steps)))
        .collect();
    reliable.sort_by_key(|(_, _, steps)| *steps);
    let sentence = |(digest, stiffness, steps): &(&Digest, f64, usize)| {
        let range = digest.safe.map_or(String::new(), |[from, to]| format!("{from:e} to {to:e}"));
        format!(
            "`{}` from κ₀ = {stiffness:e} (at most {steps} steps; every surveyed run converges for κ₀ from {range})",
            digest.name
        )
    };
    let pick = |algorithm: &str| reliable.iter().find(|(digest, ..)| digest.name.contains(algorithm));
    let points: usize = digests.iter().flat_map(|digest| &digest.ends).map(|(_, count)| count).sum();
    let predicted: usize = digests.iter().map(|digest| digest.predicted).sum();
    let mut text = format!(
        "From {points} runs over candidate surface, mesh and both paper scenes, {predicted} of them predicted before they were run:\n\n"
    );
    if let Some(first) = reliable.first() {
        let _ = writeln!(text, "* **Use** {}.", sentence(first));
    }
    if let Some(constant) = pick(".constant.") {
        let _ = writeln!(
            text,
            "* **Where one factorisation must do**: {}; or an acceleration (below).",
            sentence(constant)
        );
    }
    if let Some(varying) = pick(".varying.secant") {
        let _ = writeln!(
            text,
            "* **Where nothing is known of the stiffness**: {}: slow, and nearly the same from any start.",
            sentence(varying)
        );
    }
    let nowhere: Vec<String> =
        digests.iter().filter(|digest| digest.safe.is_none()).map(|digest| format!("`{}`", digest.name)).collect();
    if !nowhere.is_empty() {
        let _ =
            writeln!(text, "* **Do not use** {}: at no initial stiffness do all runs converge.", nowhere.join(", "));
    }
    text
}

/// What to do instead, by algorithm and rule.
const INSTEAD: [(&str, &str, &str); 7] = [
    (
        "varying.secant",
        "steps grow as w/g → 1 just outside the contact",
        "kinematic load; or a looser tolerance, as the points outside decide",
    ),
    (
        "varying.correction",
        "the error that no spring is left, or a cycle of period 2, 4, 8 … as κ₀ grows",
        "the range before this, or `secant`",
    ),
    (
        "constant.correction",
        "errors that fall by the same small factor at each step",
        "the range before this, at best near its middle; or an acceleration",
    ),
    ("constant.secant", "stiffest spring asked for grows with the mesh; the error stands", "`correction`"),
    ("constant.literal", "forces left in open points; the error stands or grows", "`correction`, which keeps forces"),
    ("kinematic.switching", "more steps than the halving law on line and layer elements", "node elements"),
    (
        "kinematic.penalty",
        "soft springs let the contact spread beyond the candidates; else penetration p/k remains, which is their own law",
        "`switching`",
    ),
];

/// Method → where it fails → how one sees it → what to do instead.
fn methods(digests: &[Digest]) -> String {
    let head = [
        "method",
        "every run converges for κ₀ from … to",
        "how the runs ended",
        "how one sees it",
        "what to do instead",
    ];
    let mut rows = Vec::new();
    for (method, seen, instead) in INSTEAD {
        let own: Vec<&Digest> = Element::ALL
            .iter()
            .filter_map(|element| digests.iter().find(|digest| digest.name == format!("{}.{method}", element.name())))
            .collect();
        let safe = own.iter().map(|digest| {
            let range = digest.safe.map_or("nowhere".into(), |[from, to]| format!("{from:e} … {to:e}"));
            format!("{}: {range}", digest.name.split('.').next().unwrap_or_default())
        });
        let mut ends: Vec<(&str, usize)> = Vec::new();
        for (class, count) in own.iter().flat_map(|digest| &digest.ends) {
            match ends.iter_mut().find(|(name, _)| *name == class.name()) {
                Some((_, total)) => *total += count,
                None => ends.push((class.name(), *count)),
            }
        }
        let ends: Vec<String> = ends.iter().map(|(name, count)| format!("{count} {name}")).collect();
        let safe: Vec<String> = safe.collect();
        rows.push(vec![method.into(), safe.join("; "), ends.join(", "), seen.into(), instead.into()]);
    }
    markdown::table(&head.map(String::from), &rows)
}

/// Steps along the slices, at the default initial stiffness of each algorithm.
fn slices(charts: &[Chart]) -> String {
    let mut text =
        String::from("Slices through the centre, at the surveyed initial stiffness next to each algorithm's own:\n\n");
    for chart in
        charts.iter().filter(|chart| [Plane::Increments, Plane::Thickness, Plane::Quadrature].contains(&chart.plane))
    {
        let ordinates = chart.plane.ordinates();
        let mut rows = Vec::new();
        for element in Element::ALL {
            for algorithm in Iteration::ALL {
                let rule = algorithm.rules()[0].name();
                let name = format!("{}.{}.{rule}", element.name(), algorithm.name());
                let near = |record: &&Record| (record.stiffness / algorithm.default_stiffness()).log10().abs() < 0.5;
                let cells: Vec<String> = chart
                    .of_formulation(&name)
                    .filter_map(|row| row.iter().find(near))
                    .map(|r| match r.class {
                        Class::Converged => {
                            format!("{} steps, L2 {}", r.steps, markdown::error(r.error))
                        }
                        class => class.name().into(),
                    })
                    .collect();
                if !cells.is_empty() {
                    let at = chart.of_formulation(&name).flat_map(|row| row.iter().find(near)).next();
                    let name = at.map_or(name.clone(), |record| format!("{name}, κ₀ = {:e}", record.stiffness));
                    rows.push(std::iter::once(name).chain(cells).collect());
                }
            }
        }
        let head: Vec<String> =
            std::iter::once(chart.plane.label().to_string()).chain(ordinates.iter().map(f64::to_string)).collect();
        let _ = writeln!(text, "{}", markdown::table(&head, &rows));
    }
    text
}

fn predictions(findings: &[Finding]) -> String {
    let of =
        |case: &str| -> Vec<&Table> { findings.iter().filter(|f| f.case == case).flat_map(|f| &f.tables).collect() };
    let joined = |case: &str, head: &[&str]| {
        let rows: Vec<Vec<String>> = of(case).into_iter().flat_map(|table| table.rows.clone()).collect();
        markdown::table(&head.iter().map(|text| text.to_string()).collect::<Vec<_>>(), &rows)
    };
    let each = |case: &str| of(case).into_iter().map(crate::study::unsorted::folded_table).collect::<String>();
    [
        "### Constant stiffness towards fixed springs\n\n`(S + K₀) u⁺ = f̂ + (K₀ − K*) u` converges if and only if S + K* and S + 2K₀ − K* are positive definite: in effect k₀ ≥ k*/2. \
         Softer springs diverge, stiffer ones crawl. Target springs carry the contact's own pressure without a gap, cut off at the κ* given.\n\n".to_string(),
        each(fixed_target::FIXED_TARGET),
        "### Rates of constant and varying stiffness\n\n\
         The asymptotic rate of an iteration is the spectral radius of its error's matrix on the final contact set, made of the \
         flexibility of the contact and of its springs; – where too few steps lie between the final contact set and round-off. \
         Truncated Hertz, contact edge between two nodes. Where a start hardly holds the slowest mode, round-off comes before that is \
         alone: there the spectral radius fails, and what holds is the iteration linearised on the final contact set and followed from its start over the same errors.\n\n"
            .into(),
        joined(rates::RATES, &rates::RATES_HEAD),
        "\n### Why `secant` and `literal` fail with constant stiffness\n\n\
         `secant` wants every closed spring to reach p/g: at the contact's centre, where g → 0, that is without bound, and the start must \
         have half of it. `literal` adds up changes of stiffness times approach, which is not the change of the force: what is \
         missing stays in points that open.\n\n"
            .into(),
        joined(failing::FAILING, &failing::HEAD),
        "\n### When varying stiffness with `correction` fails\n\n\
         Next to the contact it is stable while 2 (S + K*) − max(K*, K₀) is positive definite on the closed points: near the edge, where \
         k* → 0, κ₀ must stay below about twice the stiffness of the bodies. From equal springs it falls into a cycle somewhat \
         earlier, whose period doubles as κ₀ grows.\n\n"
            .into(),
        joined(basin::BASIN, &basin::HEAD),
        "\n### Kinematic load: the halving law\n\n\
         Started with every candidate closed it shrinks the contact by halving L² − a². The paper's *two steps for any initial \
         stiffness* hold exactly where the candidates end at the contact edge, L = a; elsewhere each halving of the mesh costs one more. \
         The law is one of nodes: on the Gauss points of line and layer elements their alternating mode costs more steps (table below).\n\n"
            .into(),
        each(halving::HALVING),
    ]
    .concat()
}

const LAWS: &str = "\
The curves, from the condensed matrices and the final contact set alone: *constant stiffness with correction* is followed as a \
linear iteration from its start to the tolerance, and takes no fewer steps than hard springs need to work off their gaps, \
k₀ g/p̄; *varying stiffness* is as slow as the slowest point near the contact edge, whose force falls by w/g, or by κ (w − g), a step; \
*kinematic load* halves L² − a². Derivations stand beside the formulas in `src/stability`.\n\n";

const EXPLAINED: &str = "\
What is behind the rows: *line and layer elements* have an alternating pressure mode that hard springs raise and soft ones \
hardly feel, so that their runs end earlier or later than the limit's rates say, and varying stiffness does not converge from \
hard starts. *Varying stiffness with correction* falls into its cycle from afar where the contact itself still attracts. \
*Constant stiffness with secant* may pass where the whole gap of the point nearest the centre, in which \
its instability sits, is below the tolerance: the error does not see it swing.\n\n";
