//! Error over seconds, code by code.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing};
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::scoreboard::run::{Ended, Numbers};
use crate::study::scoreboard::setting::Code;

/// File of the chart.
pub const FILE: &str = "scoreboard.svg";
/// Errors below this are drawn there.
pub const FLOOR: f64 = 1e-6;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut chart = Chart::new(
        "Other codes on exported cases",
        Axis::log("seconds over one sparse Cholesky solve [–]"),
        Axis::log("larger relative error of p₀ and a [–]"),
    );
    for (code, first) in Code::ALL.into_iter().flat_map(|code| [(code, true), (code, false)]) {
        let mut curve = Curve::default();
        for found in findings {
            let best = found.numbers.best(|setting| setting.code == code).map(|row| row.setting);
            let rows = found.numbers.rows.iter().filter(|row| row.setting().code == code);
            for row in rows.filter(|row| if first { row.setting().first } else { Some(row.setting) == best }) {
                match row.ended {
                    Ended::Judged { .. } => curve.points.push([row.seconds, row.error().max(FLOOR)]),
                    Ended::Failed { .. } => curve.failed.push(row.seconds),
                }
            }
        }
        let name = if first { "first choice" } else { "best setting" };
        chart.series.push(curve.drawn(format!("{}, {name}", code.name()), style(code, first)));
    }
    Ok(vec![(FILE.into(), chart.drawing()?)])
}

/// Colour = code, sign = setting.
fn style(code: Code, first: bool) -> Style {
    let colour = match code {
        Code::Calculix => palette::ORANGE,
        Code::Getfem => palette::PURPLE,
        Code::Ngsolve => palette::NODE,
        Code::Sfepy => palette::SKY,
        Code::Kratos => palette::INK,
        Code::Akantu => palette::WINE,
        Code::Felupe => palette::GREY,
        Code::ScikitFem => palette::LINE,
        Code::Dolfinx => palette::LAYER,
    };
    Style::run(colour, Dash::Absent, if first { Marker::Square } else { Marker::Circle })
}
