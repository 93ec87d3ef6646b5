//! Fringes measured and computed, and the root mean square over the half-width.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Colour, Direction, Drawing, Guide, panels};
use crate::oracle::digitised::fringes::{Channel, End};
use crate::study::Found;
use crate::study::drawn;
use crate::study::photoelastic::run::{Curve, Numbers, Width};

/// Both charts.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut charts = Vec::new();
    for found in findings {
        let ends = [(End::Bottom, "bottom, fitted"), (End::Top, "top, predicted")];
        let ends = ends.map(|(end, title)| fringes(found.numbers, end, title));
        charts
            .push(("photoelastic-fringes.svg".into(), panels("Isochromatics of a disc between two plates", &ends, 2)?));
        charts.push(("photoelastic-width.svg".into(), widths(found.numbers)?));
    }
    Ok(charts)
}

fn fringes(numbers: &Numbers, end: End, title: &str) -> Chart {
    let mut chart = Chart::new(
        title,
        Axis::linear("x / R [–]").over(0.0, 0.3),
        Axis::linear("distance from the loaded end / R [–]").over(0.0, 0.35),
    );
    for curve in numbers.curves.iter().filter(|curve| curve.end == end) {
        let Curve { channel, computed, measured, .. } = curve;
        let (colour, name, marker) = look(*channel);
        let drawn = |points: &[[f64; 2]]| drawn::Curve { points: points.to_vec(), failed: Vec::new() };
        chart
            .series
            .push(drawn(computed).drawn(format!("{name}, computed"), Style::run(colour, Dash::Solid, Marker::Absent)));
        chart.series.push(drawn(measured).drawn(format!("{name}, read"), Style::run(colour, Dash::Absent, marker)));
    }
    chart
}

fn look(channel: Channel) -> (Colour, &'static str, Marker) {
    match channel {
        Channel::R => (palette::LAYER, "red", Marker::Square),
        Channel::G => (palette::NODE, "green", Marker::Circle),
        Channel::B => (palette::LINE, "blue", Marker::Diamond),
    }
}

fn widths(numbers: &Numbers) -> Result<Drawing, Error> {
    let title = "Root mean square of the fringe orders at the bottom";
    let mut chart = Chart::new(title, Axis::linear("half-width a / R [–]"), Axis::linear("rms [fringe orders]"));
    let curve = |of: fn(&Width) -> f64| {
        let points = numbers.widths.iter().map(|width| [width.a_over_r, of(width)]).collect();
        drawn::Curve { points, failed: Vec::new() }
    };
    let style = |colour, dash| Style::run(colour, dash, Marker::Circle);
    chart.series.push(curve(|width| width.held).drawn("all else held", style(palette::LINE, Dash::Solid)));
    chart.series.push(curve(|width| width.fitted).drawn("all else fitted", style(palette::NODE, Dash::Dashed)));
    chart.guides.push(Guide { direction: Direction::Vertical, at: numbers.half_width[0], label: "fitted".into() });
    chart.drawing()
}
