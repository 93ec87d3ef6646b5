//! The order of the sections of `VALIDATION.md`.

use std::fmt::Write;

use crate::case::{hertz, pin};
use crate::error::Error;
use crate::markdown;
use crate::report::{
    accuracy, atlas, checks, converged, cross_code, cures, decisions, limits, matrix, pictures, timings,
};
use crate::solve::Formulation;
use crate::study::drawn::picture;
use crate::study::unsorted::Finding;
use crate::study::{self, Numbers, Room};
use crate::study::{statements, sweep};

/// The page and its charts.
#[derive(Clone, Debug)]
pub struct Page {
    /// Text of `VALIDATION.md`.
    pub markdown: String,
    /// File names and SVG texts of the charts.
    pub charts: Vec<(String, String)>,
}

/// Makes the page from the findings of the whole suite.
pub fn compose(all: &[study::Finding]) -> Result<Page, Error> {
    let findings = &unsorted(all)[..];
    let mut charts = pictures::all(findings)?;
    let mut text = String::new();
    let sections = [
        head(all, findings),
        paper(findings),
        verdicts(findings),
        cylinder(findings),
        pin_rod(findings),
        other_codes(findings)?,
        exact(findings),
        behaviour(findings),
        timings::section(findings)?,
        converged::section(findings),
        accuracy::section(findings),
        atlas::section(findings)?,
        cures::section(findings),
        limits::section(findings),
        silent(),
        closing(),
    ];
    for section in sections {
        text += &section;
    }
    for room in Room::ALL {
        text += &room.section(all)?;
        charts.extend(room.pictures(all)?);
        if *room != Room::Unsorted {
            let own = all.iter().filter(|finding| finding.room == *room);
            let named = own.map(|finding| (finding.name.as_str(), &finding.judged[..]));
            text += &checks::of(&named.collect::<Vec<_>>());
        }
    }
    Ok(Page { markdown: text, charts })
}

/// Findings of studies without a room.
pub fn unsorted(all: &[study::Finding]) -> Vec<Finding> {
    let of = |finding: &study::Finding| match &finding.numbers {
        Numbers::Unsorted(old) => Some(old.clone()),
        #[allow(unreachable_patterns)]
        _ => None,
    };
    all.iter().filter_map(of).collect()
}

fn head(all: &[study::Finding], findings: &[Finding]) -> String {
    let [pass, fail, not_run] = matrix::counts(all);
    let runs = findings.iter().filter(|finding| finding.run.is_some()).count();
    format!(
        "# Validation report\n\n\
         Three contact elements × three iterations for frictionless elastic contact in 2D (Égert 1999), held against closed forms and other codes.\n\
         **Nothing here has yet been compared with an experiment**: Gaertner's figures are not at hand.\n\n\
         {runs} runs, {} checks: {pass} passed, {fail} failed, {not_run} not run. Generated; do not edit.\n\n\
         *Verification* holds the code against closed forms and orders of accuracy (kind *analytic*); *benchmarking* \
         holds it against other codes (*cross-code*); *self-consistency* asks it the same in another way; *validation* would \
         compare with measurement.\n\n",
        pass + fail + not_run
    )
}

fn paper(findings: &[Finding]) -> String {
    let rows: Vec<Vec<String>> = statements::judge(findings)
        .into_iter()
        .map(|s| vec![s.text.into(), s.measured, format!("**{}**", s.judgement)])
        .collect();
    let own: Vec<String> = Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
    format!(
        "## The paper's statements\n\n{}\nThe paper itself shows {} of the nine formulations: {}. The others are ours.\n\n",
        markdown::table(&["statement", "measured", "judgement"].map(String::from), &rows),
        own.len(),
        own.join(", ")
    )
}

fn verdicts(findings: &[Finding]) -> String {
    format!(
        "## Verdicts\n\nSteps to convergence; ✓ all checks of the run pass, ✗ some fail, · reported only. Several numbers: several load increments.\n\n{}\n{}\n{}\n{}\n",
        matrix::verdict_matrix(findings),
        cross_code::by_kind(findings),
        matrix::study_table(findings),
        checks::universal(findings.iter().flat_map(|finding| &finding.checks))
    )
}

fn cylinder(findings: &[Finding]) -> String {
    let mut text = String::from("## Elastic cylinder on a rigid plane\n\n");
    text += &picture(
        "scene-cylinder.svg",
        "The scene: lower quarter, half by symmetry, uniform load on the horizontal cut",
    );
    text += &picture("field-cylinder.svg", "Mesh and vertical stress on the deformed shape");
    text += "Reference: Hertz line contact. The quarter cylinder under uniform load is not quite Hertz's problem; the model error is shown by a/R.\n\n";
    text += &case(findings, &["cylinder, verification", "cylinder, a/R = 0.005", hertz::CYLINDER]);
    text += &measures(findings, hertz::CYLINDER, 1.0, "mm");
    text += &picture(
        "pressure-cylinder.svg",
        "Contact pressure of all nine formulations against Hertz, and the difference",
    );
    text += &tables(findings, &["model error, cylinder", "half cylinder against quarter"]);
    text += "### Truncated Hertz: the same contact without model error\n\nA block between the closed-form tractions of Hertz's half-space and a rigid parabola: all errors are discretisation errors.\n\n";
    text += &case(findings, &["truncated hertz, verification", hertz::TRUNCATED]);
    text += &studies(findings, &["order of accuracy, truncated hertz"]);
    text += &picture("orders.svg", "Observed orders of accuracy");
    text
}

fn pin_rod(findings: &[Finding]) -> String {
    let mut text = String::from("## Pin in a connecting-rod eye\n\n");
    text +=
        &picture("scene-pin-rod.svg", "The scene: pin held on its horizontal diameter, rod pulled by a rigid end face");
    text += &picture("field-pin-rod.svg", "Mesh and vertical stress on the deformed shape");
    text += "No closed form: the nine formulations are held against one another, the refinement series gives its own uncertainty, and \
         other codes solve the same problem below.\n\n";
    text += &case(findings, &[pin::PIN_ROD]);
    text += &measures(findings, pin::PIN_ROD, 180.0 / std::f64::consts::PI, "°");
    text += &picture("pressure-pin-rod.svg", "Pressure against angle; the place of the measured curves is empty");
    text += &picture("along-the-pin.svg", "Hoop stress and displacement along pin and rod");
    text += &studies(findings, &["refinement, pin-rod"]);
    text += "### Against Gaertner\n\n";
    text += &studies(findings, &["gaertner 1977"]);
    text += "What can be given before the figures are at hand is the dimensionless family, by which any figure can be placed the day it appears.\n\n";
    text += &picture("family-pin-rod.svg", "Peak pressure and second-moment angle against dimensionless clearance");
    text += &tables(findings, &["dimensionless family, pin-rod"]);
    text += "### Pin in a wide plate: the same contact with a closed form\n\n";
    let plates: Vec<&str> =
        matrix::cases(findings).iter().map(|(name, _)| *name).filter(|name| name.starts_with("pin in plate")).collect();
    text += &case(findings, &plates);
    text
}

fn other_codes(findings: &[Finding]) -> Result<String, Error> {
    let mut text = cross_code::section(findings)?;
    text += &picture("pressure-cross-code.svg", "Contact pressure of the same physical problem in three codes");
    text += &picture("difference-cross-code.svg", "Difference of each code to the closed form");
    Ok(text)
}

fn exact(findings: &[Finding]) -> String {
    let starts = ["patch", "bars", "own weight", "press fit", "flat punch"];
    let is_exact = |name: &str| starts.iter().any(|start| name.starts_with(start));
    let names: Vec<&str> =
        matrix::cases(findings).iter().map(|(name, _)| *name).filter(|name| is_exact(name)).collect();
    format!("## Exact solutions\n\n{}", case(findings, &names))
}

fn behaviour(findings: &[Finding]) -> String {
    let mut text = String::from("## Elements and iterations\n\n");
    text += &picture("contact-elements.svg", "The three contact elements");
    text += &picture("iteration-paths.svg", "The path of the iterations");
    text += &picture(
        "steps-against-stiffness.svg",
        "Steps against initial stiffness; runs that do not converge stand hollow above the frame",
    );
    text += &tables(findings, &[sweep::RULES]);
    text
}

fn silent() -> String {
    format!(
        "## Where the source is silent\n\nThe figures of the paper are not at hand: none of its dimensions, loads or plotted values is known.\n\n{}\n### Misprints and gaps\n\n{}\n",
        decisions::open_points(),
        decisions::misprints()
    )
}

fn closing() -> String {
    let list = |items: &[&str]| items.iter().map(|item| format!("* {item}\n")).collect::<String>();
    format!(
        "## Deliberately not covered\n\n{}\n## References\n\n{}",
        list(&decisions::NOT_COVERED),
        list(&decisions::REFERENCES)
    )
}

/// Judged tables of some cases, one table each, with their requirements above.
fn case(findings: &[Finding], names: &[&str]) -> String {
    let mut text = String::new();
    for name in names {
        let members: Vec<&Finding> = findings.iter().filter(|f| f.case == *name && !f.checks.is_empty()).collect();
        if members.is_empty() {
            continue;
        }
        let _ = write!(text, "**{name}**\n\n{}\n", checks::table(&members));
    }
    text
}

/// Checks and tables of some studies.
fn studies(findings: &[Finding], names: &[&str]) -> String {
    case(findings, names) + &tables(findings, names)
}

fn tables(findings: &[Finding], names: &[&str]) -> String {
    let of =
        |name: &&str| findings.iter().filter(move |f| f.case == **name).flat_map(|f| &f.tables).collect::<Vec<_>>();
    names.iter().flat_map(of).map(|table| crate::study::unsorted::titled(table) + "\n").collect()
}

/// What one quotes of every run of a case; `factor` turns the contact coordinate into `unit`.
fn measures(findings: &[Finding], case: &str, factor: f64, unit: &str) -> String {
    let head =
        ["formulation", "outcome", "steps", "factorisations", "back-substitutions", "peak [MPa]"].map(String::from);
    let head: Vec<String> = head
        .into_iter()
        .chain([
            format!("half-width by moment [{unit}]"),
            format!("by counting [{unit}]"),
            format!("last active point [{unit}]"),
            "resultant [N]".into(),
        ])
        .collect();
    let runs = findings.iter().filter(|f| f.case == case).filter_map(|f| f.run.as_ref());
    let rows: Vec<Vec<String>> = runs
        .map(|run| {
            let (work, measures) = (&run.solution.work, &run.measures());
            let quoted = [
                measures.peak.pressure,
                factor * measures.half_width,
                factor * measures.half_width_nodes,
                factor * measures.edge(),
                run.transmitted(),
            ];
            let counts = [work.steps, work.factorisations, work.back_substitutions].map(|n| n.to_string());
            let quoted =
                quoted.map(|x| if run.solution.converged() { markdown::significant(x, 5) } else { "–".into() });
            let first = [run.formulation.name(), run.solution.outcome.to_string()];
            first.into_iter().chain(counts).chain(quoted).collect()
        })
        .collect();
    format!("**{case}: measures**\n\n{}\n", markdown::table(&head, &rows))
}
