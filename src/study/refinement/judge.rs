//! Orders of accuracy pair by pair, how the model error falls, and whether two orders of cells tend to one limit.

use crate::case::{Check, Judged, Quantity, Reference, covered};
use crate::error::Error;
use crate::measure::larger;
use crate::measure::order::{Observed, Richardson};
use crate::mesh::Order;
use crate::study::refinement::run::{Departure, Errors, ModelError, Numbers, Orders, PinLevel, PinRod, Ratio};
use crate::uncertainty::{COVERAGE, Comparison, standard};

/// What is below the formal order and passes: pairs approach it from both sides.
const SLACK: f64 = 0.1;
/// Relative standard uncertainty that a series of the pin–rod may have.
const OWN: f64 = 7e-4;
/// How near the limits of both orders of cells must come.
const LIMITS: f64 = 3.5e-4;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Orders(orders) => accuracy(orders),
        Numbers::ModelError(model) => model_error(model),
        Numbers::PinRod(pin) => pin_rod(pin),
    })
}

fn accuracy(orders: &Orders) -> Vec<Judged> {
    let half_width = match orders.order {
        Order::Linear => below_second_order(orders),
        _ => reaches(orders, "observed order of the second-moment width", 2.0, "the edge lies on a node", |level| {
            level.half_width
        }),
    };
    let edge = "square-root edge (Drouet & Hild 2015; Belhachmi & Ben Belgacem 2003): capped near 1";
    let load = Check::error(
        "largest error of the assembled load",
        Reference::analytic("Hertz", 0.0),
        1e-7,
        "16-point Gauss on every edge",
    );
    let largest = orders.levels.iter().map(|level| level.load).fold(0.0, larger);
    reaches(orders, "observed order of the pressure of the centre node", 2.0, "every pair of meshes", |level| {
        level.peak
    })
    .into_iter()
    .chain(half_width)
    .chain(reaches(orders, "observed order of the pressure profile in L2", 1.0, edge, |level| level.l2))
    .chain([load.judge(largest)])
    .collect()
}

/// The order between each two successive meshes reaches the formal one; one that is withheld does not.
fn reaches(
    orders: &Orders,
    name: &'static str,
    formal: f64,
    because: &'static str,
    of: fn(&Errors) -> f64,
) -> Vec<Judged> {
    let origin = format!("formal order {formal}, a tenth less");
    let pairs = orders.levels.windows(2).zip(orders.pairs(of));
    let judged = pairs.map(|(two, pair)| {
        let quantity = Quantity::at(name, format!("h/a = {} to {}", two[0].size, two[1].size));
        Check::at_least(quantity, Reference::analytic(&origin, formal - SLACK), because).judge(pair.value())
    });
    judged.collect()
}

/// Without an order that could be read, the half-width must lie below a line of second order on every mesh.
///
/// A pressure that stands for its surroundings of length h has the error `h²/24` of the midpoint rule.
fn below_second_order(orders: &Orders) -> Vec<Judged> {
    let readable = orders.pairs(|level| level.half_width).into_iter().all(|pair| matches!(pair, Observed::Order(_)));
    let because = if readable {
        "the midpoint rule's h²/24"
    } else {
        "the midpoint rule's h²/24; errors that change their sign or do not fall have no order"
    };
    let judged = orders.levels.iter().map(|level| {
        let quantity = Quantity::at("error of the second-moment width over (h/a)²", format!("h/a = {}", level.size));
        Check::error(quantity, Reference::analytic("Hertz", 0.0), 1.0 / 24.0, because)
            .judge(level.half_width.abs() / level.size.powi(2))
    });
    judged.collect()
}

/// A number by name.
type Named<N, T> = (&'static str, fn(&N) -> T);

/// Numbers of the cylinder over those of Hertz.
const RATIOS: [Named<Ratio, Departure>; 2] = [
    ("peak pressure over that of Hertz", |ratio| ratio.peak),
    ("second-moment width over the half-width of Hertz", |ratio| ratio.half_width),
];
/// How near peak and second-moment width of the smallest contact must come to Hertz's.
const SMALL: [f64; 2] = [1e-4, 1.5e-4];
/// How near the powers must come to 2, relative to that.
const POWER: f64 = 0.1;

/// The smallest contact is Hertz's; with growing contact the difference grows by (a/R)².
fn model_error(model: &ModelError) -> Vec<Judged> {
    let [first, others @ ..] = &model.ratios;
    let small = [0, 1].map(|number| {
        let (quantity, of) = RATIOS[number];
        let because = format!("no model error is left, but the mesh: {} 8-node cells per half-width", model.elements);
        let at = format!("a/R = {}", first.a_over_r);
        let check = Check::near(Quantity::at(quantity, at), Reference::analytic("Hertz", 1.0), SMALL[number], because);
        Judged { uncertainty: Some(standard(of(first).bound)), ..check.judge(1.0 + of(first).value) }
    });
    let growth = RATIOS.into_iter().flat_map(|(name, of)| {
        let pairs = others.windows(2).rev().zip(model.powers(of));
        let judged = pairs.map(move |(two, power)| {
            let at = format!("{name}, a/R = {} to {}", two[0].a_over_r, two[1].a_over_r);
            let quantity = Quantity::at("power of a/R by which the cylinder departs from Hertz", at);
            let because = "the next power of a/R, and what the mesh still changes";
            Check::near(quantity, Reference::analytic("far field", 2.0), POWER, because).judge(power.value())
        });
        judged.collect::<Vec<_>>()
    });
    small.into_iter().chain(growth).collect()
}

/// Numbers of the pin–rod.
const MEASURED: [Named<PinLevel, f64>; 2] =
    [("peak [MPa]", |level| level.peak), ("second-moment angle [°]", |level| level.angle.to_degrees())];

/// The pin–rod has no closed form: its refinement series gives its own uncertainty.
fn pin_rod(pin: &PinRod) -> Vec<Judged> {
    let [linear, quadratic] = &pin.series;
    let own = pin.series.iter().flat_map(|series| {
        MEASURED.map(|(name, of)| {
            let at = format!("{name}, {}-node", series.order.nodes_per_cell());
            let quantity = Quantity::at("relative standard uncertainty of the pin–rod on the finest mesh", at);
            let because = "three finest of four nested meshes, standard";
            let series = series.limit(of);
            Check::error(quantity, Reference::own("Richardson", 0.0), OWN, because)
                .judge(series.uncertainty() / series.limit.abs())
        })
    });
    let limits = MEASURED.into_iter().flat_map(|(name, of)| one_limit(name, linear.limit(of), quadratic.limit(of)));
    let curve = Check::error(
        "difference of the profile of 4-node cells in L2",
        Reference::own("8-node", 0.0),
        6e-3,
        "edge means on the finest mesh; the contact edge moves by a fraction of an element",
    );
    own.chain(limits).chain([curve.judge(pin.difference)]).collect()
}

/// Both orders of cells tend to one limit: near each other, and within what their own uncertainties cover.
pub fn one_limit(name: &str, linear: Richardson, quadratic: Richardson) -> [Judged; 2] {
    let sources = [linear.uncertainty(), quadratic.uncertainty()];
    let reference = || {
        let reference = Reference::own("8-node, limit", quadratic.limit);
        Reference { uncertainty: Some(sources[1]), ..reference }
    };
    let because = format!("three finest of four nested meshes; {COVERAGE} u_val is asked beside it");
    let near = Check::near(Quantity::at("limit of 4-node cells", name), reference(), LIMITS, because);
    let near = Judged { uncertainty: Some(sources[0]), ..near.judge(linear.limit) };
    let comparison = Comparison::of(linear.limit, quadratic.limit, sources);
    let of = format!("limit of 4-node cells, {name}");
    [near, covered(&of, reference(), comparison, "4-node mesh ⊕ 8-node mesh")]
}
