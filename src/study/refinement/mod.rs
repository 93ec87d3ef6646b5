//! Refinement: observed orders pair by pair, the cylinder against Hertz and against the whole of it, and the pin–rod's
//! dimensionless family. Four questions of one page; those of nested meshes, of curved sides and of the family are
//! files of their own:
//!
//! * [`curved`] — rings on meshes that do not match.
//! * [`nested`] — truncated Hertz on nested meshes.
//! * [`family`] — the pin–rod by three dimensionless numbers.
//!
//! Below are the page, and the quarter cylinder under uniform load: how far it is from Hertz, and from the half
//! cylinder.

pub mod curved;
pub mod family;
pub mod nested;

use crate::accuracy::{self, Asked};
use crate::case::library::{Cylinder, CylinderModel};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::drawing::Drawing;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::order::{Observed, pairs};
use crate::measure::{larger, relative_error};
use crate::mesh::Order;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::differences::peak_and_width;
use crate::study::drawn::picture;
use crate::study::refinement::nested::told;
use crate::uncertainty::standard;
use family::Curve;
use nested::Series;

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Truncated Hertz by cells of one order.
    Orders(Series),
    /// Rings on meshes of cells of one order that do not match.
    Rings(Order, curved::Curved),
    /// The cylinder beside Hertz, from the smallest contact to the largest.
    ModelError(Vec<Ratio>),
    /// The half cylinder against the quarter, from the smallest contact to the largest.
    Quarter(Vec<Change>),
    /// The family over the clearance.
    Family {
        /// By the radius of the eye, then by the width of the shank.
        curves: Vec<Curve>,
        /// Pressure and angle of the default scene, and of another pin of the same three numbers.
        same_place: [[f64; 2]; 2],
        /// Half-angle in a wide plate at the largest clearance (Persson) \[rad\].
        wide_plate: f64,
    },
}

/// The case of the paper's upper quarter.
pub const QUARTER: &str = "half cylinder against quarter";

impl Study for Numbers {
    const NAME: &'static str = "refinement";
    const ABOUT: About = About {
        title: "Refinement",
        asked: "How fast errors fall on finer meshes, how far the cylinder of the paper is from the half-plane of \
            Hertz, whether its top quarter may be left out, as the paper says, and where a published figure of a pin \
            in an eye belongs, whatever its dimensions.",
        limits: "Orders are read on smooth contacts; where a contact has corners they are lower. The half against the \
            quarter: one cylinder, one material, one way of loading it from above. The family: eyes of the shape drawn \
            here; no friction, no plate of another outline.",
    };

    fn plan() -> Vec<Planned<Self>> {
        let cells = [("4-node", Order::Linear), ("8-node", Order::Quadratic)];
        let orders = cells.map(|(name, order)| {
            let run = move || nested::truncated(order).map(Numbers::Orders);
            Planned::new("order of accuracy, truncated hertz", name, run)
        });
        let rings = cells.map(|(name, order)| {
            let run = move || Ok(Numbers::Rings(order, curved::rings(order)?));
            Planned::new("order of accuracy, rings", name, run)
        });
        let others = [
            Planned::new("model error, cylinder", "node.kinematic", || model_error().map(Numbers::ModelError)),
            Planned::new(QUARTER, "node.kinematic", || changes().map(Numbers::Quarter)),
            Planned::new("dimensionless family, pin-rod", "clearance and thickness", || {
                let (curves, same_place) = (family::curves()?, family::same_place()?);
                Ok(Numbers::Family { curves, same_place, wide_plate: family::in_wide_plate() })
            }),
        ];
        orders.into_iter().chain(rings).chain(others).collect()
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Orders(series) => nested::judge_orders(series),
            Numbers::Rings(order, rings) => curved::judge(*order, rings),
            Numbers::ModelError(ratios) => judge_model_error(ratios),
            Numbers::Quarter(changes) => changes.iter().flat_map(judge_change).collect(),
            Numbers::Family { curves, same_place, wide_plate } => family::judge(curves, same_place, *wide_plate),
        })
    }

    /// Tables of the nested meshes and of the model error; the quarter; the family.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let [mut orders, mut rings, mut ratios, mut quarter, mut family] = [const { String::new() }; 5];
        for found in findings {
            match found.numbers {
                Numbers::Orders(series) => orders += &nested::table_of_orders(series),
                Numbers::Rings(order, found) => rings += &curved::table(*order, found),
                Numbers::ModelError(found) => ratios += &table_of_ratios(found),
                Numbers::Quarter(changes) => quarter += &table_of_changes(changes),
                Numbers::Family { curves, .. } => family += &family::table_of_curves(curves),
            }
        }
        Ok(format!(
            include_str!("page.md"),
            chart = picture(nested::FILE, "Observed orders of accuracy"),
            orders = orders,
            ratios = ratios,
            rings = rings,
            quarter = quarter,
            family = family
        ))
    }

    /// Errors over the mesh size.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let series = findings.iter().filter_map(|found| match found.numbers {
            Numbers::Orders(series) => Some(series),
            _ => None,
        });
        Ok(vec![(nested::FILE.into(), nested::chart(&series.collect::<Vec<_>>()))])
    }
}

/// What the front page says of elements on meshes that do not match.
pub fn in_front<'a>(found: impl Iterator<Item = &'a Numbers>) -> String {
    curved::in_front(found.filter_map(|numbers| match numbers {
        Numbers::Rings(_, found) => Some(found),
        _ => None,
    }))
}

/// Relative error that may remain in the cylinder beside Hertz, and in what.
const SOLVED_TO: f64 = 1e-7;
const BOTH: [accuracy::Quantity; 2] = [accuracy::Quantity::PeakPressure, accuracy::Quantity::SecondMomentWidth];
/// Ratios a/R of the cylinder beside Hertz.
const BESIDE_HERTZ: [f64; 4] = [0.005, 0.05, 0.1, 0.2];
/// Ratios a/R of the half cylinder.
const HALVES: [f64; 4] = [0.0125, 0.025, 0.05, 0.1];

/// The cylinder beside Hertz at one a/R.
#[derive(Clone, Debug)]
pub struct Ratio {
    /// Half-width of Hertz over the radius.
    pub a_over_r: f64,
    /// How far peak pressure and second-moment width depart from those of Hertz, relative to them, and their error
    /// bars.
    pub departures: [[f64; 2]; 2],
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
}

/// Peak pressure \[MPa\] and half-width \[mm\] of each model at one a/R.
#[derive(Clone, Debug)]
pub struct Change {
    /// Half-width of Hertz over the radius.
    pub a_over_r: f64,
    /// The lower quarter, loaded on its horizontal cut.
    pub quarter: [f64; 2],
    /// The half cylinder, loaded on the same line.
    pub half: [f64; 2],
    /// The half cylinder, loaded on its upper arc.
    pub above: [f64; 2],
}

impl Change {
    /// Larger relative change of peak and second-moment width when the half loaded on the same line is modelled instead
    /// of the quarter.
    pub fn largest(&self) -> f64 {
        let [peak, width] = [0, 1].map(|k| relative_error(self.half[k], self.quarter[k]));
        larger(peak, width)
    }
}

/// Powers of a/R by which a departure falls, from the largest contact to the smallest; nothing below five error bars
/// has one.
fn powers(ratios: &[Ratio], number: usize) -> Vec<Observed> {
    let floor = ratios.iter().map(|ratio| ratio.departures[number][1]).fold(0.0, larger);
    let falling = || ratios.iter().rev();
    let sizes: Vec<f64> = falling().map(|ratio| ratio.a_over_r).collect();
    pairs(&sizes, &falling().map(|ratio| ratio.departures[number][0]).collect::<Vec<_>>(), floor)
}

/// What the quarter cylinder differs from Hertz by, on cells that end with the contact.
pub fn model_error() -> Result<Vec<Ratio>, Error> {
    let ratio = |a_over_r| {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let asked = Asked { quantities: BOTH.into(), ..Asked::new(SOLVED_TO) };
        let answer = accuracy::solve(&numbers.scene(), &Formulation::verification(), &asked)?;
        let hertz = [numbers.scene().reference.pressure, numbers.half_width()];
        let found = peak_and_width(&answer.run);
        let departures = [0, 1].map(|number| {
            let own = answer.estimates.iter().find(|one| one.is_of(0, &BOTH[number]));
            let bar = own.map_or(f64::NAN, |one| one.bar.total());
            [found[number] / hertz[number] - 1.0, bar / hertz[number]]
        });
        Ok(Ratio { a_over_r, departures, dofs: answer.run.dofs })
    };
    BESIDE_HERTZ.into_iter().map(ratio).collect()
}

/// Every model at every a/R.
pub fn changes() -> Result<Vec<Change>, Error> {
    let change = |a_over_r| {
        let contact = |model| {
            let case = Cylinder { a_over_r, model, ..Default::default() }.case();
            let made = Discretisation::of(case.scene, case.resolution)?;
            Ok::<_, Error>(peak_and_width(&Run::of(&made, &Formulation::verification())?))
        };
        let quarter = contact(CylinderModel::Quarter)?;
        let half = contact(CylinderModel::Half)?;
        Ok(Change { a_over_r, quarter, half, above: contact(CylinderModel::HalfLoadedAbove)? })
    };
    HALVES.into_iter().map(change).collect()
}

/// Numbers of the cylinder over those of Hertz.
const OVER_HERTZ: [&str; 2] = ["peak pressure over that of Hertz", "second-moment width over the half-width of Hertz"];

/// The smallest contact is Hertz's; with growing contact the difference grows by (a/R)².
pub fn judge_model_error(ratios: &[Ratio]) -> Vec<Judged> {
    let small = [0, 1].map(|number| {
        let (Ratio { a_over_r, departures, .. }, hertz) = (&ratios[0], Reference::analytic("Hertz", 1.0));
        let ([departure, bar], at) = (departures[number], format!("a/R = {a_over_r}"));
        let because = "what a half-plane leaves out is below (a/R)²";
        let check = Check::near(Quantity::at(OVER_HERTZ[number], at), hertz, a_over_r.powi(2), because);
        Judged { uncertainty: Some(standard(bar)), ..check.judge(1.0 + departure) }
    });
    let growth = [0, 1].into_iter().flat_map(|number| {
        let pairs = ratios.windows(2).rev().zip(powers(ratios, number));
        let judged = pairs.map(move |(two, power)| {
            let at = format!("{}, a/R = {} to {}", OVER_HERTZ[number], two[0].a_over_r, two[1].a_over_r);
            let quantity = Quantity::at("power of a/R by which the cylinder departs from Hertz", at);
            let because = "the next power of a/R changes it by (a/R)² of the larger contact";
            let check = Check::near(quantity, Reference::analytic("far field", 2.0), two[1].a_over_r.powi(2), because);
            check.judge(power.unwrap_or(f64::NAN))
        });
        judged.collect::<Vec<_>>()
    });
    small.into_iter().chain(growth).collect()
}

/// Change of peak and second-moment width below which the top quarter may be left out.
pub const LEFT_OUT: f64 = 1e-3;
/// Largest a/R at which that is required.
const JUDGED: f64 = 0.025;

/// The top quarter changes nothing where the contact is small.
pub fn judge_change(change: &Change) -> Vec<Judged> {
    let near = |quantity: &'static str, number: usize| {
        let at = format!("a/R = {}", change.a_over_r);
        let half = Reference::own("half cylinder", change.half[number]);
        Check::near(Quantity::at(quantity, at), half, LEFT_OUT, "far field: of the order of (a/R)²")
            .judge(change.quarter[number])
    };
    if change.a_over_r > JUDGED {
        return Vec::new();
    }
    vec![near("peak pressure of the quarter cylinder [MPa]", 0), near("half-width of the quarter cylinder [mm]", 1)]
}

/// The cylinder beside Hertz.
pub fn table_of_ratios(ratios: &[Ratio]) -> String {
    type Row<'a> = (&'a Ratio, [String; 2]);
    let columns: [Column<Row>; 8] = [
        ("a/R", |(ratio, _)| ratio.a_over_r.to_string()),
        ("p₀ / Hertz − 1", |(ratio, _)| format!("{:+.3e}", ratio.departures[0][0])),
        ("error bar", |(ratio, _)| format!("{:.0e}", ratio.departures[0][1])),
        ("power", |(_, powers)| powers[0].clone()),
        ("a / Hertz − 1", |(ratio, _)| format!("{:+.3e}", ratio.departures[1][0])),
        ("error bar", |(ratio, _)| format!("{:.0e}", ratio.departures[1][1])),
        ("power", |(_, powers)| powers[1].clone()),
        ("dofs", |(ratio, _)| ratio.dofs.to_string()),
    ];
    let powers = [0, 1].map(|number| powers(ratios, number));
    let rows =
        ratios.iter().rev().enumerate().map(|(k, ratio)| (ratio, powers.each_ref().map(|powers| told(powers, k))));
    format!(
        "**Cylinder: model error against Hertz, and the power of a/R by which it falls (solved to {} %)**\n\n{}\n",
        accuracy::in_percent(SOLVED_TO),
        markdown::columns(&columns, &rows.collect::<Vec<_>>())
    )
}

/// Changes of peak and second-moment width.
pub fn table_of_changes(changes: &[Change]) -> String {
    let columns: [Column<Change>; 5] = [
        ("a/R", |change| change.a_over_r.to_string()),
        ("p₀, loaded on the same line", |change| percent(change.half[0], change.quarter[0])),
        ("a, same line", |change| percent(change.half[1], change.quarter[1])),
        ("p₀, loaded on the upper arc", |change| percent(change.above[0], change.quarter[0])),
        ("a, upper arc", |change| percent(change.above[1], change.quarter[1])),
    ];
    let table = markdown::columns(&columns, changes);
    format!("Change of the contact when the half cylinder is modelled instead of the quarter.\n\n{table}\n")
}

fn percent(half: f64, quarter: f64) -> String {
    format!("{:+.3} %", 100.0 * (half / quarter - 1.0))
}
