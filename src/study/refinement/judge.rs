//! Orders of accuracy, how the model error falls, and whether two orders of cells tend to one limit.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::measure::order::observed;
use crate::mesh::Order;
use crate::study::refinement::run::{Errors, ModelError, Numbers, Orders, PinLevel, PinRod, Ratio};

/// Uncertainty that a series of the pin–rod may have.
const OWN: f64 = 3e-3;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Orders(orders) => accuracy(orders),
        Numbers::ModelError(model) => model_error(model),
        Numbers::PinRod(pin) => pin_rod(pin),
    })
}

fn accuracy(orders: &Orders) -> Vec<Judged> {
    let order = |quantity: &'static str, origin, bound, because: &'static str, of: fn(&Errors) -> f64| {
        Check::at_least(quantity, Reference::analytic(origin, bound), because).judge(orders.order_of(of))
    };
    let slope = "least-squares slope over four meshes";
    let edge = "square-root edge (Drouet & Hild 2015; Belhachmi & Ben Belgacem 2003): capped near 1";
    let profile = match orders.order {
        Order::Linear => 0.6,
        Order::Quadratic => 0.9,
    };
    let load = orders.levels.iter().map(|level| level.load).fold(0.0, larger);
    vec![
        order("observed order of the pressure of the centre node", "second order", 1.8, slope, |level| level.peak),
        order("observed order of the half-width", "second order", 1.8, "the edge lies on a node", |level| {
            level.half_width
        }),
        order("observed order of the pressure profile in L2", "first order", profile, edge, |level| level.l2),
        Check::error(
            "largest error of the assembled load",
            Reference::analytic("Hertz", 0.0),
            1e-7,
            "16-point Gauss on every edge",
        )
        .judge(load),
    ]
}

/// A number by name.
type Named<N> = (&'static str, fn(&N) -> f64);

/// Numbers of the cylinder over those of Hertz.
const RATIOS: [Named<Ratio>; 2] =
    [("peak pressure over that of Hertz", |ratio| ratio.peak), ("half-width over that of Hertz", |ratio| ratio.half_width)];
/// How near the smallest contact must come to Hertz's.
const SMALL: f64 = 2e-4;

/// The smallest contact is Hertz's; with growing contact the difference grows by (a/R)².
fn model_error(model: &ModelError) -> Vec<Judged> {
    let [first, others @ ..] = &model.ratios;
    let small = RATIOS.map(|(quantity, of)| {
        let because = "model error about 2e-5; 48 8-node cells per half-width";
        let at = format!("a/R = {}", first.a_over_r);
        Check::near(Quantity::at(quantity, at), Reference::analytic("Hertz", 1.0), SMALL, because).judge(of(first))
    });
    let sizes: Vec<f64> = others.iter().map(|ratio| ratio.a_over_r).collect();
    let growth = RATIOS.map(|(name, of)| {
        let because = "least-squares slope over the larger contacts, where discretisation is a tenth of the difference";
        let errors: Vec<f64> = others.iter().map(|ratio| of(ratio) - 1.0).collect();
        Check::near(
            Quantity::at("power of a/R by which the cylinder departs from Hertz", name),
            Reference::analytic("far field", 2.0),
            0.1,
            because,
        )
        .judge(observed(&sizes, &errors))
    });
    small.into_iter().chain(growth).collect()
}

/// Numbers of the pin–rod.
const MEASURED: [Named<PinLevel>; 2] =
    [("peak", |level| level.peak), ("second-moment angle", |level| level.angle)];

/// The pin–rod has no closed form: its refinement series gives its own uncertainty.
fn pin_rod(pin: &PinRod) -> Vec<Judged> {
    let [linear, quadratic] = &pin.series;
    let own = pin.series.iter().flat_map(|series| {
        MEASURED.map(|(name, of)| {
            let at = format!("{name}, {}-node", series.order.nodes_per_cell());
            let quantity = Quantity::at("uncertainty of the pin–rod on the finest mesh", at);
            let because = "three finest of four nested meshes, factor of safety 1.25";
            Check::error(quantity, Reference::own("Richardson", 0.0), OWN, because).judge(series.limit(of).uncertainty)
        })
    });
    let limits = MEASURED.map(|(name, of)| {
        let (a, b) = (linear.limit(of), quadratic.limit(of));
        let because = "combined uncertainty of both series, at least the 0.3 % asked of each";
        let quantity = Quantity::at("extrapolated value of 4-node cells", name);
        let [ours, theirs] = [a, b].map(|series| Some(series.uncertainty * series.limit.abs()));
        let reference = Reference { uncertainty: theirs, ..Reference::own("8-node, extrapolated", b.limit) };
        let tolerance = larger(a.uncertainty.hypot(b.uncertainty), OWN);
        Judged { uncertainty: ours, ..Check::near(quantity, reference, tolerance, because).judge(a.limit) }
    });
    let curve = Check::error(
        "difference of the profile of 4-node cells in L2",
        Reference::own("8-node", 0.0),
        1e-2,
        "edge means on the finest mesh; the contact edge moves by a fraction of an element",
    );
    own.chain(limits).chain([curve.judge(pin.difference)]).collect()
}
