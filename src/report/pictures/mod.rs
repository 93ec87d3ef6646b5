//! The charts by name, each from the findings that made it.
//!
//! * [`convergence`] — steps against initial stiffness, orders, iteration paths.
//! * [`fields`] — stress on the deformed meshes.
//! * [`cross_code`] — profiles of all codes and their differences.
//! * [`solve`] and [`deformed`] — the picture of one run.
//! * [`pins`] — hoop stress and displacement along the pin, the dimensionless family.

pub mod convergence;
pub mod cross_code;
pub mod deformed;
pub mod fields;
pub mod pins;
pub mod solve;

use crate::error::Error;
use crate::figure::palette::Style;
use crate::figure::{self, Chart};
use crate::study::drawn::{label, style};
use crate::study::unsorted::{Finding, Series};

/// All charts: file name and SVG.
pub fn all(findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let mut charts = vec![("contact-elements.svg".to_string(), figure::contact_elements()?)];
    for (name, chart) in [
        ("orders.svg", convergence::orders(findings).svg()?),
        ("iteration-paths.svg", convergence::paths(findings)?),
        ("field-cylinder.svg", fields::cylinder(findings)?),
        ("field-pin-rod.svg", fields::pin_rod(findings)?),
        ("along-the-pin.svg", pins::along(findings)?),
        ("pressure-cross-code.svg", cross_code::pressure(findings)?),
        ("difference-cross-code.svg", cross_code::difference(findings)?),
        ("family-pin-rod.svg", pins::family(findings)?),
    ] {
        charts.push((name.into(), chart));
    }
    Ok(charts)
}

/// A chart's curve from a study's.
fn curve(series: &Series, label: String, style: Style) -> figure::Series {
    let points = series.points.iter().map(|&[x, y]| (x, y)).collect();
    figure::Series { label, points, style, hollow: series.failed.clone() }
}

/// Series of one picture over all findings.
fn of_picture<'a>(findings: &'a [Finding], picture: &'a str) -> impl Iterator<Item = &'a Series> {
    findings.iter().flat_map(|finding| &finding.series).filter(move |series| series.picture == picture)
}

/// A chart with its curves.
fn with(mut chart: Chart, series: Vec<figure::Series>) -> Chart {
    chart.series = series;
    chart
}
