//! Two rings pressed into one another on meshes that do not match: the orders in L2 of the pressure, and of the
//! displacements of both.
//!
//! Their interference is `δ + Δ cos 2θ`, and by Lamé and Michell so is the pressure, `p₀ + p₂ cos 2θ`, all around: no
//! end of the contact limits the orders, as it does on a half-plane.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::case::Judged;
use crate::case::library::PressFit;
use crate::elasticity::{element, quadrature, shape_functions};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::measure::order::Observed;
use crate::measure::profile::relative_l2;
use crate::mesh::{Mesh, Order, Resolution};
use crate::oracle::analytic::michell::Harmonic;
use crate::oracle::analytic::shell;
use crate::scene::{Profile, Scene, Shape};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::refinement::nested::{Level, orders, reach};

/// Elements of the inner and of the outer ring along the fit, on the coarsest mesh.
const COARSEST: [usize; 2] = [6, 9];
/// Nested meshes.
const LEVELS: u32 = 4;
/// Δ over δ.
const WAVE: f64 = 0.4;
/// Tolerance of the iteration, far below what the meshes leave.
const TOLERANCE: f64 = 1e-8;
/// Gauss points of a cell in each direction.
const POINTS: usize = 5;

/// The rings: closed form and scene.
struct Rings {
    numbers: PressFit,
    uniform: shell::PressFit,
    /// Of the inner and of the outer ring, per MPa.
    harmonics: [Harmonic; 2],
    /// p₂ \[MPa\].
    wave: f64,
}

impl Rings {
    fn new() -> Self {
        let numbers = PressFit::default();
        let &PressFit { inner: bore, interface, outer: outside, interference, materials, plane } = &numbers;
        let ([inner, outer], uniform) = (materials, numbers.closed_form());
        let harmonics = [
            Harmonic::pressed(2, 1, [bore, interface], inner, plane),
            Harmonic::pressed(2, 0, [interface, outside], outer, plane),
        ];
        let [inwards, outwards] = harmonics.map(|one| one.displacement(interface)[0]);
        let wave = WAVE * interference / (outwards - inwards);
        Self { numbers, uniform, harmonics, wave }
    }

    /// Pressure at an angle \[MPa\].
    fn pressure(&self, angle: f64) -> f64 {
        self.uniform.pressure() + self.wave * (2.0 * angle).cos()
    }

    /// Displacement of a ring at a point \[mm\].
    fn displacement(&self, ring: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        let (radius, angle) = (x.hypot(y), x.atan2(-y));
        let lame = self.uniform.fitted()[ring].displacement(radius);
        let [outwards, along] = self.harmonics[ring].displacement(radius).map(|one| self.wave * one);
        let (outwards, along) = (lame + outwards * (2.0 * angle).cos(), along * (2.0 * angle).sin());
        let (sine, cosine) = angle.sin_cos();
        [outwards * sine + along * cosine, along * sine - outwards * cosine]
    }

    /// The scene on meshes of the rings that do not match.
    fn scene(&self, order: Order) -> Result<Scene, Error> {
        let mut scene = self.numbers.scene();
        let wave = WAVE * self.numbers.interference;
        scene.contacts[0].profile = Profile::Cosine { amplitude: wave, wavelength: PI };
        scene.contacts[0].clearance = -self.numbers.interference - wave;
        let plain = scene.clone();
        for (body, elements) in COARSEST.into_iter().enumerate() {
            let mesh = Mesh::of(&plain, Resolution { elements, refinement: 0, order })?;
            scene.bodies[body].shape = Shape::Given(mesh.given(body).into());
        }
        Ok(scene)
    }

    /// Error of the displacements of both rings, relative in L2.
    fn relative_error(&self, mesh: &Mesh, displacement: &[[f64; 2]]) -> Result<f64, Error> {
        let [mut error, mut scale] = [0.0; 2];
        for (ring, body) in mesh.bodies.iter().enumerate() {
            for cell in body.cells.clone().map(|cell| mesh.cell(cell)) {
                let points: Vec<[f64; 2]> = cell.iter().map(|&node| mesh.points[node]).collect();
                for (at, weight) in quadrature::gauss_square(POINTS) {
                    let shapes = shape_functions::values(cell.len(), at);
                    let sum =
                        |of: &dyn Fn(usize) -> f64| shapes.iter().enumerate().map(|(k, n)| n * of(k)).sum::<f64>();
                    let area =
                        weight * element::gradients(&points, at).map_or(f64::NAN, |(_, determinant)| determinant);
                    let exact = self.displacement(ring, [0, 1].map(|axis| sum(&|k| points[k][axis])));
                    for axis in [0, 1] {
                        let found = sum(&|k| displacement[cell[k]][axis]);
                        error += area * (found - exact[axis]).powi(2);
                        scale += area * exact[axis].powi(2);
                    }
                }
            }
        }
        Ok((error / scale).sqrt())
    }
}

/// Errors of a contact element on nested meshes of cells of one order, coarse to fine.
fn levels(order: Order, element: Element) -> Result<Vec<Level<2>>, Error> {
    let rings = Rings::new();
    let scene = rings.scene(order)?;
    let on_mesh = |refinement| {
        let elements = COARSEST[0] << refinement;
        let made = Discretisation::of(scene.clone(), Resolution { elements, refinement, order })?;
        let run = Run::of(&made, &Formulation::new(element, Iteration::Kinematic).tolerance(TOLERANCE))?;
        let displacement = made.displacement_under(1.0, &run.solution);
        let errors = [
            relative_l2(&run.solution.points, |angle| rings.pressure(angle), FRAC_PI_2),
            rings.relative_error(&made.mesh, &displacement)?,
        ];
        let errors = if run.solution.converged() { errors } else { [f64::NAN; 2] };
        Ok(Level { elements, dofs: run.dofs, errors })
    };
    (0..LEVELS).map(on_mesh).collect()
}

/// Contact elements, each on meshes from coarse to fine: errors of the pressure and of the displacements, relative in
/// L2.
pub type Curved = [(Element, Vec<Level<2>>); 3];

/// Both rings by every contact element on cells of one order.
pub fn rings(order: Order) -> Result<Curved, Error> {
    let [line, layer, node] = Element::ALL.map(|element| levels(order, element).map(|levels| (element, levels)));
    Ok([line?, layer?, node?])
}

/// Orders expected of the node element on 4-node and on 8-node cells, of the pressure and of the displacements.
const EXPECTED: [[(f64, &str); 2]; 2] = [
    [(1.5, "linear cells, and no end of a contact in between"), (2.0, "linear cells")],
    [
        (2.0, "the pressure of a node is its force over its area: not the 2.5 of pressures drawn as the cells are"),
        (3.0, "quadratic cells"),
    ],
];

/// What the orders are of.
const NUMBERS: [&str; 2] = ["observed order of the pressure in L2", "observed order of the displacements in L2"];

/// The order between each two successive meshes reaches the one expected.
pub fn judge(cells: Order, [.., (_, levels)]: &Curved) -> Vec<Judged> {
    let expected = EXPECTED[usize::from(cells != Order::Linear)];
    let judged = NUMBERS.into_iter().zip(expected).enumerate().flat_map(|(number, (name, (order, because)))| {
        let between = |a: usize, b: usize| format!("{a} to {b} elements");
        reach((name, "order", order, because), (levels, number, TOLERANCE), between)
    });
    judged.collect()
}

/// How far the pressures of each element are off on meshes that do not match, at best of line and layer elements, at
/// worst of node elements.
pub fn in_front<'a>(all: impl IntoIterator<Item = &'a Curved>) -> String {
    let [mut least, mut largest] = [f64::NAN, 0.0];
    for [others @ .., (_, own)] in all {
        let of = |levels: &'a [Level<2>]| levels.iter().map(|level| level.errors[0]);
        least = others.iter().flat_map(|(_, levels)| of(levels)).fold(least, f64::min);
        largest = of(own).fold(largest, larger);
    }
    format!(
        "Where meshes of curved sides do not match, the pressures of line and layer elements are off by {} or more on \
        every mesh on which they converge, those of node elements by {} or less.",
        markdown::error(least),
        markdown::error(largest)
    )
}

/// Errors and orders by each contact element.
pub fn table(order: Order, curved: &Curved) -> String {
    let of_each = |number: usize| {
        let name = ["L2(p)", "L2(u)"][number];
        curved.each_ref().map(|(element, levels)| {
            (format!("{name}, {}", element.name()), levels, number, orders(levels, number, TOLERANCE))
        })
    };
    let all = [of_each(0), of_each(1)].concat();
    let cell = |k: usize, levels: &[Level<2>], number: usize, orders: &[Observed]| {
        let error = levels[k].errors[number];
        match k.checked_sub(1).and_then(|before| orders.get(before)) {
            _ if error.is_nan() => "–".into(),
            Some(Ok(order)) => format!("{error:.2e} ({order:.2})"),
            _ => format!("{error:.2e}"),
        }
    };
    let [others @ .., (_, own)] = curved;
    let head = ["elements", "dofs"].map(String::from).into_iter().chain(all.iter().map(|(name, ..)| name.clone()));
    let row = |(k, level): (usize, &Level<2>)| {
        let cells = all.iter().map(|(_, levels, number, orders)| cell(k, levels, *number, orders));
        [level.elements, level.dofs].map(|count| count.to_string()).into_iter().chain(cells).collect()
    };
    let rows: Vec<Vec<String>> = own.iter().enumerate().map(row).collect();
    let of_others = || others.iter().flat_map(|(_, levels)| levels.iter().zip(own));
    let off = of_others().map(|(level, _)| level.errors[0]).fold(f64::NAN, f64::min);
    let beside = of_others().map(|(level, own)| level.errors[1] / own.errors[1]).fold(f64::NAN, f64::max);
    format!(
        "**Rings, {}-node cells**\n\n{}\nOn every mesh the pressures at the points of the line and the layer element \
        are off by {} or more, and their displacements by {} times those of the node element or less.\n\n",
        order.nodes_per_cell(),
        markdown::table(&head.collect::<Vec<_>>(), &rows),
        markdown::error(off),
        markdown::significant(beside, 2),
    )
}
