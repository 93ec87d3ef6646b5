//! What a solve found in some eight lines: the numbers one quotes, rounded to their error bars.

use comfy_table::ColumnConstraint;

use crate::accuracy::Barred;
use crate::case::{self, Judged, Verdict};
use crate::cli::json::{OracleReading, oracle};
use crate::cli::solve::found::Found;
use crate::cli::terminal::{say, table_on, width};
use crate::cli::{accuracy, verify};
use crate::markdown::{self, EXACT, significant, to_bound, unsigned};
use crate::measure::Quantity;
use crate::solve::VonMises;
use crate::solve::run::BALANCED;
use crate::solve::run::Unbounded;

/// What a note is about.
pub const NOTE: &str = "note";
/// Columns, where the terminal has as many.
const COLUMNS: u16 = 80;
/// A place below this part of the half-width is round-off, told as 0.
const ROUND_OFF: f64 = 1e-9;
/// Length within which a corner is told \[mm\].
const FINE: f64 = 1e-3;
/// Difference of pressures over the largest within which they are uniform.
const EVEN: f64 = 1e-2;
/// A number below this has an exponent.
const SMALL: f64 = 1e-4;
/// Digits of a number of which no bar is known.
const DIGITS: usize = 3;
/// What is quoted of a closed form.
const COMPARED: [&str; 2] = ["peak_pressure", "half_width"];

/// Prints the lines, their words whole.
pub fn print(found: &Found) {
    let mut table = table_on(width().min(COLUMNS), [""; 0]);
    table.add_rows(rows(found));
    if let Some(names) = table.column_mut(0) {
        names.set_constraint(ColumnConstraint::ContentWidth);
    }
    table.lines().for_each(|line| say(line.trim_end()));
}

/// What each line is about, and what it says.
pub fn rows(found: &Found) -> Vec<[String; 2]> {
    let Found { problem, run, .. } = found;
    let cells = problem.resolution.order.nodes_per_cell();
    let (outcome, iterations) = (&run.solution.outcome, run.solution.work.iterations);
    let ended = format!(
        "{outcome} after {iterations} iterations: {}, {} dofs of {cells}-node cells",
        run.formulation.name(),
        run.dofs
    );
    let mut rows = vec![[problem.name.clone(), problem.title.clone()], ["outcome".into(), ended]];
    for contact in 0..run.contacts.len() {
        rows.extend(of_contact(found, contact));
    }
    let stresses = found.stresses.iter().zip(std::iter::once("von Mises stress").chain(std::iter::repeat("")));
    rows.extend(stresses.map(|(stress, name)| [name.into(), of_body(found, stress)]));
    rows.extend(found.accurate.iter().map(|accurate| ["accuracy".into(), accuracy::outcome(accurate)]));
    rows.extend(of_oracles(found));
    // That of the accuracy, the last one, is told already.
    rows.extend(of_checks(&found.checks[..found.checks.len() - usize::from(found.accurate.is_some())]));
    let of_contacts = (0..run.contacts.len()).flat_map(|contact| found.notes_of(contact));
    let notes = of_contacts.chain(found.notes()).chain(unknown(found));
    rows.extend(notes.map(|note| [NOTE.into(), note]));
    rows
}

/// Peak, half-width, ends, resultant and approach of a contact.
fn of_contact(found: &Found, contact: usize) -> Vec<[String; 2]> {
    let (scene, measured) = (&found.problem.scene, &found.run.contacts[contact]);
    let (pair, measures) = (&scene.contacts[contact], &measured.measures);
    let number = |quantity: &Quantity| Number::of(found, contact, quantity);
    let mut rows = Vec::new();
    if scene.contacts.len() > 1 {
        rows.push(["contact".into(), format!("`{}`", pair.name)]);
    }
    let place = number(&Quantity::PeakPlace);
    // A uniform pressure has its peak anywhere.
    let pressures = || found.run.solution.points_of(contact).iter().map(|point| point.pressure);
    let [least, most] = [f64::min, f64::max].map(|of| pressures().filter(|p| *p > 0.0).reduce(of).unwrap_or(f64::NAN));
    let is_anywhere =
        most - least <= EVEN * most || place.bar.is_some_and(|bar| bar >= place.factor * measures.half_width());
    let at = if is_anywhere { String::new() } else { format!(" at {}", place.told()) };
    let peak = match measured.unbounded {
        Some(Unbounded { position, .. }) => {
            format!("without limit at {} {}", markdown::bound(place.factor * position.value()), place.unit)
        }
        None => number(&Quantity::PeakPressure).told() + &at,
    };
    rows.push(["peak pressure".into(), peak]);
    let half_width = case::Quantity::on(scene, contact, Quantity::HalfWidth);
    rows.push([half_width.name().into(), number(&Quantity::HalfWidth).told()]);
    let (stretches, across) = (&measures.stretches, pair.path.has_both_sides());
    // From the line of symmetry to the half-width.
    let is_half = stretches.len() == 1 && !across && stretches[0].begin <= 0.0;
    if !is_half && !stretches.is_empty() {
        let ends = (0..stretches.len()).map(|k| {
            let begin =
                if across || stretches[k].begin > 0.0 { number(&Quantity::Begin(k)).told() } else { "0".into() };
            format!("from {begin} to {}", number(&Quantity::End(k)).told())
        });
        rows.push(["ends".into(), ends.collect::<Vec<_>>().join(", ")]);
    }
    rows.push(["resultant".into(), number(&Quantity::Resultant).told()]);
    let approach = number(&Quantity::Approach);
    if approach.value.is_finite() {
        rows.push(["approach".into(), approach.told()]);
    }
    rows
}

/// The largest von Mises stress of a body, its place to a cell, and where it has none.
fn of_body(found: &Found, VonMises { body, largest, without_limit }: &VonMises) -> String {
    let scene = &found.problem.scene;
    let nowhere = without_limit.first().map(|first| {
        let others = match without_limit.len() {
            0 | 1 => String::new(),
            many => format!(" and {} more", many - 1),
        };
        format!("{} at {}{others}", first.because, place(first.at, FINE))
    });
    let name = &scene.bodies[*body].name;
    match (largest, nowhere) {
        (None, None) => format!("`{name}` unknown"),
        (None, Some(nowhere)) => format!("`{name}` without limit: {nowhere}"),
        (Some(largest), nowhere) => {
            let quantity = Quantity::VonMises { body: *body };
            let contact = found.barred().iter().find(|one| one.quantity == quantity).map_or(0, |one| one.contact);
            let told = Number::valued(found, contact, &quantity, largest.stress).told();
            let beside = nowhere.map_or(String::new(), |nowhere| format!(", but without limit beside {nowhere}"));
            format!("`{name}` {told} at {}{beside}", place(largest.at, largest.within))
        }
    }
}

/// A point as exactly as a length within which it lies.
fn place([x, y]: [f64; 2], within: f64) -> String {
    let places = (0.0 - within.log10().floor()).clamp(0.0, 6.0) as usize;
    let rounded = |x: f64| {
        let tens = 10_f64.powi(places as i32);
        ((x * tens).round() / tens + 0.0).to_string()
    };
    format!("({}, {}) mm", rounded(x), rounded(y))
}

/// How far the numbers quoted are from closed forms.
fn of_oracles(found: &Found) -> impl Iterator<Item = [String; 2]> + '_ {
    let several = found.run.contacts.len() > 1;
    let all = oracle::readings(&found.problem, &found.run);
    let names: Vec<[String; 2]> = all.iter().map(|one| [one.contact.clone(), one.name.clone()]).collect();
    let mut told = Vec::new();
    for [contact, name] in names {
        let own = all.iter().filter(|one| one.contact == contact && one.name == name);
        let own = own.filter(|one| COMPARED.contains(&one.quantity));
        let off: Vec<String> = own.map(|one| beside(found, one)).collect();
        let of = if several { format!("`{contact}`, ") } else { String::new() };
        let row = ["closed form".into(), format!("{of}{name}: {}", off.join("; "))];
        if !off.is_empty() && !told.contains(&row) {
            told.push(row);
        }
    }
    told.into_iter()
}

/// A number of a closed form, and how far ours is from it: as exactly as its bar tells.
fn beside(
    found: &Found,
    OracleReading { called, reference, error, of: (contact, quantity), .. }: &OracleReading,
) -> String {
    let ours = Number::of(found, *contact, quantity);
    let theirs = ours.factor * reference;
    let bar = ours.bar.filter(|bar| bar.is_finite() && *bar > EXACT * ours.value.abs());
    let digits = bar.filter(|bar| *bar < theirs.abs());
    let value = digits.map_or_else(|| markdown::value(theirs), |bar| to_bound(theirs, bar));
    let away = match bar {
        Some(bar) if (ours.value - theirs).abs() <= bar => "within the bar".into(),
        _ if *error <= ROUND_OFF => "met to round-off".into(),
        _ => markdown::error(*error) + " off",
    };
    format!("{called}: {value} {}, {away}", ours.unit)
}

/// Checks that do not pass, and how many do.
fn of_checks(checks: &[Judged]) -> Vec<[String; 2]> {
    let passed = checks.iter().filter(|check| check.verdict == Verdict::Pass).count();
    let open = checks.iter().filter(|check| check.verdict != Verdict::Pass);
    let mut rows: Vec<[String; 2]> = open.map(|check| ["check".into(), verify::verdict(check)]).collect();
    if !checks.is_empty() {
        rows.push(["checks".into(), format!("{passed} of {} pass", checks.len())]);
    }
    rows
}

/// Why bars of what is quoted are not known, where they are not.
fn unknown(found: &Found) -> Vec<String> {
    let Some(bars) = &found.bars else { return Vec::new() };
    let is_quoted = |one: &&Barred| {
        use Quantity::{Approach, Begin, End, HalfWidth, PeakPressure, Resultant, VonMises};
        let is_number = !found.run.is_unbounded(one.contact, &one.quantity);
        let is_of_contact = matches!(one.quantity, PeakPressure | HalfWidth | Begin(_) | End(_) | Resultant | Approach);
        is_number && (is_of_contact || matches!(one.quantity, VonMises { .. }))
    };
    let mut reasons: Vec<&str> = bars.all.iter().filter(is_quoted).filter_map(|one| one.unknown).collect();
    reasons.sort_unstable();
    reasons.dedup();
    let mut told: Vec<String> =
        reasons.into_iter().map(|why| format!("bars that are missing are unknown, since {why}")).collect();
    if bars.meshes == 0 && found.run.imbalance() <= BALANCED {
        told.push("give more elements, or for a mesh made elsewhere `--accuracy`, which halves it".into());
    }
    told
}

/// A number in the unit that it is shown in, and its bar where bars were asked for.
struct Number {
    value: f64,
    bar: Option<f64>,
    unit: &'static str,
    factor: f64,
}

impl Number {
    /// That of a contact.
    fn of(found: &Found, contact: usize, quantity: &Quantity) -> Self {
        let Found { discretisation, run, displacement, .. } = found;
        let measures = &run.contacts[contact].measures;
        // Displacements of all bodies are recovered once, for however many contacts.
        let value = match quantity {
            Quantity::Approach => discretisation.of_displacement(displacement, measures, contact, quantity),
            other => discretisation.number(run, contact, other).map(Some),
        };
        let value = value.ok().flatten().unwrap_or(f64::NAN);
        let width = measures.second_moment_width;
        let is_round_off = *quantity == Quantity::PeakPlace && value.abs() <= ROUND_OFF * width;
        Self::valued(found, contact, quantity, if is_round_off { 0.0 } else { value })
    }

    /// The same whose value is given.
    fn valued(found: &Found, contact: usize, quantity: &Quantity, value: f64) -> Self {
        let (unit, factor) = quantity.unit(!found.problem.scene.contacts[contact].path.is_straight());
        let bar = found.bars.as_ref().and_then(|bars| bars.of(contact, quantity)).map(|bar| factor * bar.total());
        Self { value: factor * value, bar, unit, factor }
    }

    /// Value ± bar with its unit; without the bar where that touches no digit.
    fn told(&self) -> String {
        let Self { value, bar, unit, .. } = *self;
        let told = match bar {
            _ if value.is_nan() => "unknown".into(),
            None => markdown::value(value),
            Some(bar) if bar.is_nan() => significant(value, DIGITS),
            Some(bar) if bar <= EXACT * value.abs() => markdown::value(value),
            Some(bar) if bar.max(value.abs()) < SMALL => {
                let exponent = bar.max(value.abs()).log10().floor() as i32;
                let [value, bar] = [value, bar].map(|number| number / 10_f64.powi(exponent));
                format!("({} ± {})e{exponent}", unsigned(to_bound(value, bar)), to_bound(bar, bar))
            }
            Some(bar) => format!("{} ± {}", unsigned(to_bound(value, bar)), to_bound(bar, bar)),
        };
        format!("{told} {unit}")
    }
}
