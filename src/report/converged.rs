//! The section on what is called converged.

use crate::markdown;
use crate::report::checks;
use crate::study::converged::STUDY;
use crate::study::converged::plan::{LOADS, SIZE, STRETCHES, TOLERANCES};
use crate::study::unsorted::Finding;

/// Squares of errors below this part of the stored energy are round-off, of which no bound says anything.
const ROUND_OFF: f64 = 1e-18;

/// The section: criterion, shares that converge, and how loose the bound in the energy norm is.
pub fn section(findings: &[Finding]) -> String {
    let own: Vec<&Finding> = findings.iter().filter(|finding| finding.case == STUDY).collect();
    let mut text = format!(
        "## What is called converged\n\n\
         A run stops by its error against the solution of its own discrete problem, which an active set finds beside it, and \
         not by a residual, whose scale someone must guess. Per contact, relative to that solution: the *peak*, the share of \
         the *force* at the wrong place, half-width and centre as *width*, and the *approach* over the one that the \
         contact's own force makes. The largest of the four, over all contacts, is the iteration error; converged is an \
         iteration error within the tolerance. The algorithms do not see it. `src/algorithm/target.rs` has the formulas.\n\n\
         {}\
         Every scene file and library scene, and a block of {SIZE} half-widths, under every element and algorithm; candidates as \
         long as the scene has them and of {stretches} half-widths, where the bodies allow it; loads of {loads} of the scene's own; \
         tolerances of {tolerances}. A run that does not converge says so, and is not wrong.\n\n\
         ![Share of the runs that converge, by candidate stretch](snapshots/charts/converged.svg)\n\
         *Share of the runs that converge at the default tolerance, by candidate stretch, over all scenes and loads.*\n\n",
        bound(findings),
        stretches = list(&STRETCHES[1..]),
        loads = list(&LOADS),
        tolerances = list(&TOLERANCES),
    );
    for table in own.iter().flat_map(|finding| &finding.tables) {
        text += &crate::study::unsorted::folded_table(table);
    }
    text + &checks::table(&own)
}

/// Numbers one after the other.
fn list(numbers: &[f64]) -> String {
    let each: Vec<String> = numbers.iter().map(|x| if *x < 0.1 { format!("{x:e}") } else { x.to_string() }).collect();
    each.join(", ")
}

/// How far the bound `‖u − u*‖²_S ≤ Σ P h + Σ F* v + Σ T (h* − h)` is above what it bounds, over the runs of the suite.
fn bound(findings: &[Finding]) -> String {
    let energies = findings.iter().filter_map(|finding| finding.run.as_ref()?.solution.energy);
    let mut ratios: Vec<f64> =
        energies.filter(|energy| energy.error > ROUND_OFF).map(|energy| (energy.bound / energy.error).sqrt()).collect();
    ratios.sort_by(f64::total_cmp);
    let [Some(least), Some(median), Some(largest)] = [ratios.first(), ratios.get(ratios.len() / 2), ratios.last()]
        .map(|ratio| ratio.map(|x| markdown::significant(*x, 3)))
    else {
        return String::new();
    };
    format!(
        "Without that solution a bound can be had in the energy norm, from a run's own forces, gaps and penetrations alone \
         (`src/algorithm/bound.rs`). That it holds is a check of every run. It is {least} to {largest} times the \
         error, {median} in the median of {} runs: an energy does not tell the peak, and so it is shown and not stopped by.\n\n",
        ratios.len()
    )
}
