//! What was handed in, drawn on the truth, and the differences beside it.

use crate::drawing::palette::{INK, LINE};
use crate::drawing::{Axis, Chart, Dash, Marker, Series, Sheet, Style};
use crate::measure::display_factor;
use crate::referee::answer::Answer;
use crate::referee::profile::Profile;
use crate::referee::truth::Truth;

/// Intervals into which the truth is drawn.
const INTERVALS: usize = 400;
/// Upper end of the axis of pressures over the largest.
const HEADROOM: f64 = 1.15;

/// A row a contact: pressures on the truth, and what they differ from it.
pub fn sheet(truth: &Truth, answer: &Answer) -> Sheet {
    let scene = &truth.case.scene;
    let profiles =
        (0..scene.contacts.len()).filter_map(|contact| answer.of(contact)).map(|handed| Profile::of(scene, handed));
    let name = answer.file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let title = format!("{name}, held against {}", truth.case.name);
    Sheet { title, field: None, charts: profiles.map(|profile| row(truth, &profile)).collect(), notes: vec![] }
}

fn row(truth: &Truth, profile: &Profile) -> Vec<Chart> {
    let (contact, pair) = (profile.contact, profile.pair());
    let factor = display_factor(&pair.path);
    let from = profile.points.first().map_or(0.0, |point| point.position.min(0.0));
    let to = profile.points.last().map_or(pair.stretch, |point| point.position);
    let axis = || Axis::linear(if factor > 1.0 { "θ [°]" } else { "s [mm]" }).over(factor * from, factor * to);
    let theirs = Style::run(LINE, Dash::Solid, Marker::Circle);
    let finite = |p: f64| if p.is_finite() { p } else { f64::NAN };
    let points = |of: &dyn Fn(f64, f64) -> f64| {
        profile.points.iter().map(|p| (factor * p.position, of(p.position, p.pressure))).collect()
    };
    let curve = (0..=INTERVALS).map(|k| from + (to - from) * k as f64 / INTERVALS as f64);
    let curve: Vec<(f64, f64)> = curve.map(|s| (factor * s, finite(truth.pressure(contact, s)))).collect();
    let named = truth.of_profile(contact).reference.name;
    let series = |label: &str, points: Vec<(f64, f64)>, style: Style| Series::new(label, points, style);
    let mut pressures = Chart::new("Contact pressure", axis(), Axis::linear("contact pressure [MPa]"));
    pressures.series = vec![
        series("handed in", points(&|_, p| p), theirs),
        series(&named, curve, Style { colour: INK, ..Style::reference() }),
    ];
    let drawn =
        pressures.series.iter().flat_map(|series| &series.points).map(|point| point.1).filter(|p| p.is_finite());
    let (low, high) = drawn.fold((0.0_f64, 0.0_f64), |(low, high), p| (low.min(p), high.max(p)));
    pressures.y.range = Some((HEADROOM * low, if high > low { HEADROOM * high } else { 1.0 }));
    let mut differences = Chart::new("Difference from the truth", axis(), Axis::linear("difference [MPa]"));
    differences.series = vec![series("handed in", points(&|s, p| finite(p - truth.pressure(contact, s))), theirs)];
    vec![pressures, differences]
}
