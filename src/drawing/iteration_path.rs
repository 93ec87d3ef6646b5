//! The walk of each algorithm at one contact point, in the plane of approach and pressure.
//!
//! Between two states lies first the change of the spring at a fixed approach (upright), then the return to
//! equilibrium along the new spring (slanted): `p = p_j + k_j (w − w_j)`.

use super::canvas::Canvas;
use super::chart::{Axis, Chart, Series};
use super::drawing::Drawing;
use super::frame::{Point, distance};
use super::multiples::grid;
use super::palette::{CARD, Dash, GREY, INK, Marker, SKY, Style, tint};
use super::pen::Lettering;
use super::plot::Plot;
use super::signs;
use super::theme::Colour;

/// A state of the iteration at the contact point: approach `w`, pressure `p`, and stiffness `k` of the spring that holds it.
pub type State = [f64; 3];

/// The states of one algorithm.
#[derive(Clone, Debug)]
pub struct Path {
    /// The algorithm, as the title of its panel.
    pub algorithm: String,
    /// Dash of the algorithm.
    pub dash: Dash,
    /// States in order.
    pub states: Vec<State>,
    /// False draws the last state hollow.
    pub converged: bool,
}

/// The walks of several algorithms to one solution.
#[derive(Clone, Debug)]
pub struct IterationPaths {
    /// What is shown, in a few words.
    pub title: String,
    /// Names and units of approach and pressure.
    pub axes: [String; 2],
    /// Two points of the elastic bodies' load line, approach and pressure.
    pub load_line: [(f64, f64); 2],
    /// Initial gap at the point.
    pub gap: f64,
    /// The solution, approach and pressure.
    pub target: (f64, f64),
    /// Colour of the contact element.
    pub colour: Colour,
    /// One panel each.
    pub paths: Vec<Path>,
}

/// Room from a number to the next one, and to a state.
const CLEAR: f64 = 17.0;
const BESIDE: f64 = 12.5;

impl IterationPaths {
    /// The panels, drawn, on the same axes.
    pub fn drawing(&self) -> Drawing {
        let charts: Vec<Chart> = self.paths.iter().map(|path| self.chart(path)).collect();
        let mut canvas = Canvas::new();
        let (plots, corner) = grid(&mut canvas, &charts, charts.len())?;
        for (path, plot) in self.paths.iter().zip(&plots) {
            // Larger than the states, so that a state on it leaves its corners visible.
            signs::filled(&mut canvas, plot.place(self.target), Marker::Diamond, 5.4, INK);
            states(&mut canvas, plot, path, self.colour);
        }
        canvas.drawing(&self.title, corner, &[])
    }

    fn chart(&self, path: &Path) -> Chart {
        let (width, height) = self.extent();
        let x = Axis::linear(&self.axes[0]).over(0.0, width);
        let y = Axis::linear(&self.axes[1]).over(0.0, height);
        let mut chart = Chart::new(&path.algorithm, x, y);
        let law = vec![(0.0, 0.0), (self.gap, 0.0), (self.gap, height)];
        let springs = path.states.iter().flat_map(|state| spring(state, width));
        let elastic = line_through(self.load_line, width);
        chart.series = vec![
            Series::new("spring of a step", springs, Style::run(tint(GREY, 0.75), Dash::Solid, Marker::Absent)),
            Series::new("contact: open, or closed at w = g", law, Style::run(SKY, Dash::Solid, Marker::Absent)),
            Series::new("elastic bodies", elastic, Style::reference()),
            Series::new("iterations", path.walk(), Style::run(self.colour, path.dash, Marker::Absent)),
            Series::new("solution", vec![self.target], Style::run(INK, Dash::Absent, Marker::Diamond)),
        ];
        chart
    }

    /// Upper ends of both axes, the same in every panel.
    fn extent(&self) -> (f64, f64) {
        let states = || self.paths.iter().flat_map(|path| &path.states);
        let width = states().map(|[approach, ..]| *approach).fold(self.gap.max(self.target.0), f64::max);
        let height = states().map(|[_, pressure, _]| *pressure).fold(self.target.1, f64::max);
        (1.15 * width, 1.25 * height)
    }
}

/// Pressure on the spring of a state at an approach.
fn pressure_at([approach, pressure, stiffness]: State, at: f64) -> f64 {
    pressure + stiffness * (at - approach)
}

/// The spring from zero pressure to the state, closed by an interruption.
fn spring(state: &State, width: f64) -> [(f64, f64); 3] {
    let [approach, pressure, stiffness] = *state;
    let relaxed = if stiffness > 0.0 { approach - pressure / stiffness } else { -width };
    let start = relaxed.max(-width);
    [(start, pressure_at(*state, start)), (approach, pressure), (f64::NAN, f64::NAN)]
}

impl Path {
    /// The states joined over the corners between them.
    fn walk(&self) -> Vec<(f64, f64)> {
        let place = |[approach, pressure, _]: State| (approach, pressure);
        let corners = self.states.windows(2).map(|two| (two[0][0], pressure_at(two[1], two[0][0])));
        let mut walk: Vec<(f64, f64)> = self.states.first().copied().map(place).into_iter().collect();
        walk.extend(corners.zip(self.states.iter().skip(1)).flat_map(|(corner, state)| [corner, place(*state)]));
        walk
    }
}

fn line_through([a, b]: [(f64, f64); 2], width: f64) -> Vec<(f64, f64)> {
    let slope = (b.1 - a.1) / (b.0 - a.0);
    [0.0, width].map(|approach| (approach, a.1 + slope * (approach - a.0))).to_vec()
}

/// Discs on the states, numbered where there is room; the last always is.
fn states(canvas: &mut Canvas, plot: &Plot<'_>, path: &Path, colour: Colour) {
    let places: Vec<Point> = path.states.iter().map(|state| plot.place((state[0], state[1]))).collect();
    let last = places.len().saturating_sub(1);
    let mut numbered: Vec<Point> = Vec::new();
    for (n, &place) in places.iter().enumerate() {
        if n == last && !path.converged {
            signs::ring(canvas, place, 4.0, colour);
        } else {
            canvas.disc(place, 4.0, colour, None);
        }
    }
    // The last first, so that it has its number.
    for n in std::iter::once(last).chain(0..last).filter(|n| *n < places.len()) {
        let (x, y) = places[n];
        let around =
            [(x, y + 14.0), (x, y - 14.0), (x + 15.0, y), (x - 15.0, y), (x + 15.0, y + 15.0), (x + 15.0, y - 15.0)];
        let free = |at: &Point| {
            let off = |others: &[Point], least: f64| others.iter().all(|other| distance(*other, *at) > least);
            plot.frame.holds(*at) && off(&places, BESIDE) && off(&numbered, CLEAR)
        };
        let Some(at) = around.into_iter().find(free).or((n == last).then_some(around[0])) else { continue };
        canvas.disc(at, 6.5, CARD, None);
        canvas.label(at, &(n + 1).to_string(), Lettering::middle(10.5).bold());
        numbered.push(at);
    }
    plot.outline(canvas);
}
