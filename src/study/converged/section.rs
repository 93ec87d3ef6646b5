//! The section on what is called converged.

use crate::error::Error;
use crate::markdown;
use crate::solve::Settings;
use crate::study::Found;
use crate::study::converged::run::{Energy, Numbers, Record};
use crate::study::converged::share::{same, share};
use crate::study::converged::sites::{BOUNDED, LOADS, SIZE, STRETCHES, TOLERANCES};
use crate::study::drawn;
use crate::study::pairing::Pairing;

/// Squares of errors below this part of the stored energy are round-off, of which no bound says anything.
const ROUND_OFF: f64 = 1e-18;

/// The section: criterion, how loose the bound in the energy norm is, and shares that converge.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let recorded: Vec<_> = findings.iter().flat_map(|found| &found.numbers.recorded).collect();
    let energies: Vec<_> = findings.iter().flat_map(|found| &found.numbers.energies).collect();
    let text = format!(
        "A run stops by its error against the solution of its own discrete problem, which an active set finds beside it, and \
         not by a residual, whose scale someone must guess. Per contact, relative to that solution: the *peak*, the share of \
         the *force* at the wrong place, half-width and centre as *width*, and the *approach* over the one that the \
         contact's own force makes. The largest of the four, over all contacts, is the iteration error; converged is an \
         iteration error within the tolerance. The algorithms do not see it. `src/solver/algorithm/target.rs` has the formulas.\n\n\
         {}\
         Every scene file and library scene, and a block of {SIZE} half-widths, under every element and algorithm; candidates as \
         long as the scene has them and of {stretches} half-widths, where the bodies allow it; loads of {loads} of the scene's own; \
         tolerances of {tolerances}. A run that does not converge is reported so, and is not wrong.\n\n{}",
        bound(&energies),
        drawn::picture(
            "converged.svg",
            "Share of the runs that converge at the default tolerance, by candidate stretch, over all scenes and loads"
        ),
        stretches = list(&STRETCHES[1..]),
        loads = list(&LOADS),
        tolerances = list(&TOLERANCES),
    );
    Ok(text + &by_stretch(&recorded) + &by_load(&recorded))
}

/// Numbers one after the other.
fn list(numbers: &[f64]) -> String {
    let each: Vec<String> = numbers.iter().map(|x| if *x < 0.1 { format!("{x:e}") } else { x.to_string() }).collect();
    each.join(", ")
}

/// How far the bound `‖u − u*‖²_S ≤ Σ P h + Σ F* v + Σ T (h* − h)` is above what it bounds.
fn bound(energies: &[&Option<Energy>]) -> String {
    let above = energies.iter().filter_map(|energy| energy.as_ref()).filter(|energy| energy.error > ROUND_OFF);
    let mut ratios: Vec<f64> = above.map(|energy| (energy.bound / energy.error).sqrt()).collect();
    ratios.sort_by(f64::total_cmp);
    let [least, median, largest] = [ratios.first(), ratios.get(ratios.len() / 2), ratios.last()]
        .map(|ratio| markdown::significant(ratio.copied().unwrap_or(f64::NAN), 3));
    format!(
        "Without that solution a bound can be had in the energy norm, from a run's own forces, gaps and penetrations alone \
         (`src/solver/algorithm/bound.rs`). That it holds is a check of every run. On {} under all nine formulations it is {least} to \
         {largest} times the error, {median} in the median of the {} runs of {} whose error is above round-off: an energy does not \
         tell the peak, and so it is shown and not stopped by.\n\n",
        BOUNDED.join(", "),
        ratios.len(),
        energies.len()
    )
}

/// Shares that converge, by formulation and stretch.
fn by_stretch(recorded: &[&Record]) -> String {
    let mut rows = Vec::new();
    for tolerance in TOLERANCES {
        for pairing in Pairing::all() {
            let own = |record: &&&Record| record.formulation == pairing && same(record.tolerance, tolerance);
            let at = |stretch: f64| recorded.iter().filter(own).filter(move |record| same(record.stretch, stretch));
            let cells = STRETCHES.map(|stretch| percent(share(at(stretch).copied())));
            rows.push([vec![pairing.to_string(), format!("{tolerance:e}")], cells.into()].concat());
        }
    }
    let stretches = STRETCHES.map(|stretch| if stretch > 0.0 { format!("{stretch} a") } else { "own".into() });
    let head = [vec!["formulation".into(), "tolerance".into()], stretches.into()].concat();
    let limit = Settings::default().max_iterations;
    let title = format!("Share of the runs that converge within {limit} iterations, by candidate stretch, all loads");
    markdown::folded(&title, &markdown::table(&head, &rows), false)
}

/// Shares that converge, by formulation and load.
fn by_load(recorded: &[&Record]) -> String {
    let pairs = || TOLERANCES.into_iter().flat_map(|tolerance| LOADS.map(|load| [tolerance, load]));
    let row = |pairing: Pairing| {
        let own = |[tolerance, load]: [f64; 2]| {
            let is_own = |record: &&Record| {
                record.formulation == pairing && same(record.tolerance, tolerance) && same(record.load, load)
            };
            percent(share(recorded.iter().copied().filter(is_own)))
        };
        std::iter::once(pairing.to_string()).chain(pairs().map(own)).collect()
    };
    let rows: Vec<Vec<String>> = Pairing::all().into_iter().map(row).collect();
    let columns = pairs().map(|[tolerance, load]| format!("{tolerance:e}, load × {load:e}"));
    let head: Vec<String> = std::iter::once("formulation".into()).chain(columns).collect();
    markdown::folded("The same by load, all stretches", &markdown::table(&head, &rows), false)
}

/// A share; – without a run.
fn percent(share: Option<f64>) -> String {
    share.map_or("–".into(), |share| format!("{:.0} %", 100.0 * share))
}
