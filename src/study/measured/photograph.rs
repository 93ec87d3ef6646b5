//! The disc between two plates against a photograph of its isochromatics: measured, shape only, uncalibrated. The
//! fringe orders of our disc are its principal stress difference; both ends of the photograph in fringe orders: fitted
//! at the bottom, predicted at the top.

use crate::case::library::{Cylinder, CylinderModel};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series, panels};
use crate::elasticity::point::Cells;
use crate::error::Error;
use crate::markdown::{self, Column, significant};
use crate::measure::larger;
use crate::mesh::{Mesh, Order, Resolution};
use crate::oracle::ReferenceKind;
use crate::oracle::digitised::fringes::{Channel, End, Fringe};
use crate::scene::Grading;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::drawn::picture;

/// Half-widths over the radius at which the disc is solved; the best lies on the parabola through the least three.
const WIDTHS: [f64; 10] = [0.030, 0.035, 0.040, 0.045, 0.050, 0.055, 0.060, 0.065, 0.070, 0.075];
/// Halvings of the mesh, and of the one twice as coarse that says what ours is worth.
const REFINEMENTS: [u32; 2] = [1, 0];
/// Constants that are fitted.
const CONSTANTS: usize = 5;
/// Depths at which computed fringes are looked for, over the radius, and halvings of their place.
const DEPTHS: usize = 27;
const HALVINGS: usize = 40;

/// What the photograph says of our disc.
#[derive(Clone, Debug)]
pub struct Photograph {
    /// Half-width by Hertz over the radius, fitted, and its standard deviation if readings were independent.
    pub half_width: [f64; 2],
    /// The other constants.
    pub constants: Constants,
    /// Each end: points, and root mean square in fringe orders.
    pub ends: [(End, usize, f64); 2],
    /// Half-widths over the radius, and the root mean square at the bottom with all other constants held, and with them
    /// fitted.
    pub widths: Vec<[f64; 3]>,
    /// Root mean square of what a mesh twice as coarse changes at all points, and the largest of it.
    pub mesh: [f64; 2],
    /// Fringes.
    pub lines: Vec<Line>,
}

/// A fringe of an end in a channel, as read and as computed: `[x, z]` over the radius.
pub type Line = (End, Channel, [Vec<[f64; 2]>; 2]);

/// Fits at the bottom, predicts the top.
pub fn compare(fringes: &[Fringe]) -> Result<Photograph, Error> {
    let of = |end: End| fringes.iter().copied().filter(|fringe| fringe.end == end).collect::<Vec<_>>();
    let ends = [End::Bottom, End::Top].map(|end| (end, of(end)));
    let bottom = &ends[0].1;
    let fields: Vec<Field> = WIDTHS.into_iter().map(|a| Field::of(a, REFINEMENTS[0])).collect::<Result<_, _>>()?;
    let sums: Vec<f64> = fields.iter().map(|field| Constants::fitted(field, bottom).1).collect();
    let (best, least, curvature) = parabola(&sums);
    let freedom = (bottom.len() - CONSTANTS) as f64;
    let deviation = (2.0 * least / freedom / curvature).sqrt();

    let field = Field::of(best, REFINEMENTS[0])?;
    let (constants, _) = Constants::fitted(&field, bottom);
    let width = |((a_over_r, other), fitted): ((&f64, &Field), &f64)| {
        [*a_over_r, constants.rms(other, bottom), (fitted / bottom.len() as f64).sqrt()]
    };
    let coarse = Field::of(best, REFINEMENTS[1])?;
    let changed = |fringe: &Fringe| (constants.residual(&coarse, fringe) - constants.residual(&field, fringe)).abs();
    let squares: f64 = fringes.iter().map(|fringe| changed(fringe).powi(2)).sum();
    Ok(Photograph {
        half_width: [best, deviation],
        ends: ends.each_ref().map(|(end, own)| (*end, own.len(), constants.rms(&field, own))),
        widths: WIDTHS.iter().zip(&fields).zip(&sums).map(width).collect(),
        mesh: [(squares / fringes.len() as f64).sqrt(), fringes.iter().map(changed).fold(0.0, larger)],
        lines: ends.iter().flat_map(|(end, own)| lines(&field, &constants, *end, own)).collect(),
        constants,
    })
}

/// Place, value and second derivative of the minimum of a parabola through the least of the sums and its neighbours.
fn parabola(sums: &[f64]) -> (f64, f64, f64) {
    let least = (1..sums.len() - 1).min_by(|&a, &b| sums[a].total_cmp(&sums[b])).unwrap_or(1);
    let step = WIDTHS[1] - WIDTHS[0];
    let [before, at, after] = [sums[least - 1], sums[least], sums[least + 1]];
    let (slope, curvature) = ((after - before) / (2.0 * step), (after - 2.0 * at + before) / (step * step));
    let shift = -slope / curvature;
    (WIDTHS[least] + shift, at + 0.5 * slope * shift, curvature)
}

/// The fringes of an end.
fn lines(field: &Field, constants: &Constants, end: End, own: &[Fringe]) -> Vec<Line> {
    let mut all = Vec::new();
    for channel in Channel::ALL {
        for order in [1.0, 2.0, 3.0, 4.0] {
            let same = |fringe: &&Fringe| fringe.channel == channel && (fringe.order - order).abs() < 0.5;
            let measured: Vec<[f64; 2]> = own.iter().filter(same).map(|f| [f.half_spacing, f.depth]).collect();
            let Some(deepest) = measured.iter().map(|point| point[1]).reduce(f64::max) else { continue };
            let shallowest = measured.iter().map(|point| point[1]).fold(deepest, f64::min);
            let depths = (0..=DEPTHS).map(|k| shallowest + (deepest - shallowest) * k as f64 / DEPTHS as f64);
            let around = |z: f64| {
                measured.iter().min_by(|a, b| (a[1] - z).abs().total_cmp(&(b[1] - z).abs())).map_or(0.1, |p| p[0])
            };
            let over = |x: f64, z: f64| constants.order_at(field, channel, [x, z]) - order;
            let computed = depths.filter_map(|z| Some([place(|x| over(x, z), around(z))?, z])).collect();
            all.push((end, channel, [measured, computed]));
        }
    }
    all
}

/// Where a falling function is zero, between half and one and a half times a place near it; none where it is not.
fn place(over: impl Fn(f64) -> f64, near: f64) -> Option<f64> {
    let [mut inner, mut outer] = [0.5 * near, 1.5 * near];
    if !(over(inner) > 0.0 && over(outer) < 0.0) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inner + outer);
        if over(middle) > 0.0 { inner = middle } else { outer = middle }
    }
    Some(0.5 * (inner + outer))
}

/// Root mean square of reading, and that which is accepted, in fringe orders.
const READ: f64 = 0.03;
const ACCEPTED: f64 = 0.035;
/// Half-widths over the fitted one that reading alone must not explain.
const WRONG: [f64; 2] = [0.7, 1.3];
/// Root mean square that our mesh may cost: a third of that of reading.
const MESH: f64 = 0.01;

/// Within what is asked at both ends; and reading alone does not explain a width that is plainly wrong.
pub fn judge(photograph: &Photograph) -> Vec<Judged> {
    let ends = photograph.ends.iter().map(|(end, points, rms)| {
        let reference = Reference {
            name: "photograph, shape only, uncalibrated".into(),
            kind: ReferenceKind::Measured,
            value: 0.0,
            uncertainty: None,
        };
        let quantity =
            Quantity::at("root mean square of the fringe orders", format!("{}, {points} points", end.name()));
        let because = format!("read to about {READ} orders; five constants fitted at the bottom, none at the top");
        Check::absolute(quantity, reference, ACCEPTED, because).judge(*rms)
    });
    let wrong = WRONG.map(|times| {
        let what = "root mean square with a wrong half-width and all else refitted";
        let quantity = Quantity::at(what, format!("{times} of the fitted one"));
        let because = "more than reading explains, though not always more than is accepted: the width is told roughly";
        // At the half-width solved next to it.
        let far = |width: &&[f64; 3]| (width[0] - times * photograph.half_width[0]).abs();
        let next = photograph.widths.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        Check::at_least(quantity, Reference::own("what reading leaves", READ), because)
            .judge(next.map_or(f64::NAN, |width| width[2]))
    });
    let mesh = Check::at_most(
        "root mean square of the fringe orders that a mesh twice as coarse changes",
        Reference::own("accepted", MESH),
        "our own error shall be at most a third of that of reading",
    );
    ends.chain(wrong).chain([mesh.judge(photograph.mesh[0])]).collect()
}

/// File of the chart.
const FRINGES: &str = "photoelastic-fringes.svg";

/// Columns of the half-widths.
const COLUMNS: [Column<[f64; 3]>; 3] = [
    ("a/R", |[a_over_r, ..]| significant(*a_over_r, 3)),
    ("rms, all else held", |[_, held, _]| significant(*held, 2)),
    ("rms, all else fitted", |[.., fitted]| significant(*fitted, 3)),
];

/// What the photograph can show, what it says, and what it cannot show.
pub fn section(photograph: &Photograph) -> String {
    let [a, deviation] = photograph.half_width;
    let [red, green, blue] = photograph.constants.orders.map(|order| significant(order, 3));
    let passing = photograph.widths.iter().filter(|[.., fitted]| *fitted <= ACCEPTED).map(|[a_over_r, ..]| *a_over_r);
    let [narrow, wide] = passing.fold([f64::INFINITY, 0.0], |[least, most], x| [x.min(least), x.max(most)]);
    let end = |(end, points, rms): &(End, usize, f64)| {
        format!("{}: {} orders ({points} points)", end.name(), significant(*rms, 3))
    };
    format!(
        include_str!("photograph.md"),
        half_width = significant(a, 3),
        deviation = significant(deviation, 2),
        red = red,
        green = green,
        blue = blue,
        edge = significant(photograph.constants.edge, 2),
        ends = photograph.ends.each_ref().map(end).join(", "),
        changed = significant(photograph.mesh[0], 2),
        most = significant(photograph.mesh[1], 2),
        widths = markdown::columns(&COLUMNS, &photograph.widths),
        narrow = significant(narrow, 2),
        wide = significant(wide, 2),
        accepted = ACCEPTED,
        reading = READ
    ) + "\n"
        + &picture(
            FRINGES,
            "Dark fringes near both loaded ends: read from the photograph (points) and computed (lines)",
        )
}

/// Fringes measured and computed.
pub fn picture_of(photograph: &Photograph) -> (String, Drawing) {
    let ends = [(End::Bottom, "bottom, fitted"), (End::Top, "top, predicted")];
    let ends = ends.map(|(end, title)| fringes(photograph, end, title));
    (FRINGES.into(), panels("Isochromatics of a disc between two plates", &ends, 2))
}

fn fringes(photograph: &Photograph, end: End, title: &str) -> Chart {
    let mut chart = Chart::new(
        title,
        Axis::linear("x / R [–]").over(0.0, 0.3),
        Axis::linear("distance from the loaded end / R [–]").over(0.0, 0.35),
    );
    for (_, channel, [measured, computed]) in photograph.lines.iter().filter(|line| line.0 == end) {
        let (colour, name, marker) = match channel {
            Channel::R => (palette::LAYER, "red", Marker::Square),
            Channel::G => (palette::NODE, "green", Marker::Circle),
            Channel::B => (palette::LINE, "blue", Marker::Diamond),
        };
        let mut draw = |points: &[[f64; 2]], label: String, dash, marker| {
            chart.series.push(Series::new(label, points.iter().copied(), Style::run(colour, dash, marker)));
        };
        draw(computed, format!("{name}, computed"), Dash::Solid, Marker::Absent);
        draw(measured, format!("{name}, read"), Dash::Absent, marker);
    }
    chart
}

/// Elements on the half-width before they are halved.
const ELEMENTS: usize = 8;
/// Growth of the elements away from the contact, and the coarsest: fringes reach far into the disc.
const GROWTH: f64 = 1.15;
const COARSEST: f64 = 0.05;
/// How far outside a cell, over its size, a point still belongs to it: edges only approach a curved outline.
const OUTSIDE: f64 = 0.02;

/// Stresses at the nodes of our disc.
pub struct Field {
    mesh: Mesh,
    cells: Cells,
    stress: Vec<[f64; 3]>,
    radius: f64,
    centre: f64,
}

impl Field {
    /// The disc under the load that Hertz needs for a half-width over the radius, its mesh halved so many times.
    pub fn of(a_over_r: f64, refinement: u32) -> Result<Self, Error> {
        let disc = Cylinder { a_over_r, model: CylinderModel::BetweenPlates, ..Default::default() };
        let mut scene = disc.scene();
        scene.grading = Grading { along: GROWTH, depth: GROWTH, coarsest: COARSEST, ..scene.grading };
        let resolution = Resolution { elements: ELEMENTS, refinement, order: Order::Quadratic };
        let discretisation = Discretisation::of(scene, resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let stress = discretisation.recover(&run.solution)?.stress;
        let mesh = discretisation.mesh;
        let mut field = Self { cells: Cells::of_body(&mesh, 0), stress, radius: disc.radius, centre: 1.0, mesh };
        field.centre = if run.solution.converged() { field.at([0.0, 1.0]) } else { f64::NAN };
        Ok(field)
    }

    /// `(σ₁ − σ₂)` at a point `[x, z]` over the radius, z from the loaded end, over that at the centre; NaN outside the
    /// disc's lower quarter.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        let at = point.map(|x| self.radius * x);
        let Some((cell, shapes)) = self.cells.shapes_at(at, OUTSIDE) else { return f64::NAN };
        let mut tensor = [0.0; 3];
        for (&node, shape) in self.mesh.cell(cell).iter().zip(shapes) {
            (0..3).for_each(|k| tensor[k] += shape * self.stress[node][k]);
        }
        let [x, y, xy] = tensor;
        (x - y).hypot(2.0 * xy) / self.centre
    }
}

/// Places of the loaded edge that are tried, over the radius.
const EDGE: [f64; 2] = [-0.03, 0.05];
/// Part of an interval that golden sections leave.
const GOLDEN: f64 = 0.618_033_988_749_895;
const SECTIONS: usize = 28;

/// Constants of a field that are fitted to fringes.
#[derive(Clone, Copy, Debug)]
pub struct Constants {
    /// Fringe order at the centre of the disc, by channel.
    pub orders: [f64; 3],
    /// How far the loaded edge lies above the end of the diameter in the picture, over the radius.
    pub edge: f64,
}

impl Constants {
    /// Constants with the least sum of squares, and that.
    pub fn fitted(field: &Field, fringes: &[Fringe]) -> (Self, f64) {
        let of = |edge: f64| {
            let found: Vec<f64> =
                fringes.iter().map(|fringe| field.at([fringe.half_spacing, fringe.depth + edge])).collect();
            // `N_c = Σ f N / Σ f²` over the fringes of each channel.
            let orders = Channel::ALL.map(|channel| {
                let own = fringes.iter().zip(&found).filter(|(fringe, _)| fringe.channel == channel);
                let sums = own.fold([0.0; 2], |[above, below], (fringe, f)| [above + f * fringe.order, below + f * f]);
                sums[0] / sums[1]
            });
            let residual = |(fringe, f): (&Fringe, &f64)| orders[fringe.channel as usize] * f - fringe.order;
            (Self { orders, edge }, fringes.iter().zip(&found).map(|one| residual(one).powi(2)).sum::<f64>())
        };
        let edge = golden(EDGE, |edge| of(edge).1);
        of(edge)
    }

    /// Computed order less the measured one.
    pub fn residual(&self, field: &Field, fringe: &Fringe) -> f64 {
        self.order_at(field, fringe.channel, [fringe.half_spacing, fringe.depth]) - fringe.order
    }

    /// Computed order of a channel at `[x, z]` of the picture.
    pub fn order_at(&self, field: &Field, channel: Channel, [x, z]: [f64; 2]) -> f64 {
        self.orders[channel as usize] * field.at([x, z + self.edge])
    }

    /// Root mean square of the residuals.
    pub fn rms(&self, field: &Field, fringes: &[Fringe]) -> f64 {
        let squares = fringes.iter().map(|fringe| self.residual(field, fringe).powi(2));
        (squares.sum::<f64>() / fringes.len() as f64).sqrt()
    }
}

/// Where a function of one minimum is least.
fn golden([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..SECTIONS {
        let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if of(left) < of(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}
