//! Refinement: observed orders pair by pair, the cylinder against Hertz and against the whole of it, the pin–rod's own
//! uncertainty and its dimensionless family. Four questions of one page, a file each but for the two of nested meshes
//! and the two of the cylinder:
//!
//! * [`nested`] — truncated Hertz and the pin–rod on nested meshes.
//! * [`cylinder`] — the model error of the cylinder, and the half cylinder against the quarter.
//! * [`family`] — the pin–rod by three dimensionless numbers.

pub mod cylinder;
pub mod family;
pub mod nested;

use crate::case::Judged;
use crate::drawing::Drawing;
use crate::error::Error;
use crate::mesh::Order;
use crate::study::about::About;
use crate::study::drawn::picture;
use crate::study::{Found, Planned};

use cylinder::{Change, Ratio};
use family::{Curve, Slope};
use nested::Series;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Refinement",
    asked: "How fast errors fall on finer meshes, how far the cylinder of the paper is from the half-plane of Hertz, \
        whether its top quarter may be left out, as the paper says, and where a published figure of a pin in an eye \
        belongs, whatever its dimensions.",
    limits: "Orders are read on smooth contacts; where a contact has corners they are lower. The half against the \
        quarter: one cylinder, one material, one way of loading it from above. The family: eyes of the shape drawn \
        here; no friction, no plate of another outline.",
};

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Truncated Hertz by cells of one order.
    Orders {
        /// Relative errors with their signs.
        series: Series,
        /// Largest relative error of the assembled load.
        load: f64,
    },
    /// The cylinder beside Hertz, from the smallest contact to the largest.
    ModelError([Ratio; 4]),
    /// The pin–rod.
    PinRod {
        /// By 4-node cells, and by 8-node cells.
        series: [Series; 2],
        /// Difference of their profiles on the finest mesh, relative in L2.
        difference: f64,
    },
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
    /// Slopes of the family at the default scene, by clearance, eye and shank.
    Slopes([Slope; 3]),
}

/// All trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    let orders = [("4-node", Order::Linear), ("8-node", Order::Quadratic)];
    let orders = orders.map(|(name, order)| {
        Planned::new("order of accuracy, truncated hertz", name, move || {
            nested::truncated(order).map(|(series, load)| Numbers::Orders { series, load })
        })
    });
    let family = "dimensionless family, pin-rod";
    let others = [
        Planned::new("model error, cylinder", "node.kinematic", || cylinder::model_error().map(Numbers::ModelError)),
        Planned::new("refinement, pin-rod", "4-node and 8-node", || {
            nested::pin_rod().map(|(series, difference)| Numbers::PinRod { series, difference })
        }),
        Planned::new("half cylinder against quarter", "node.kinematic", || cylinder::changes().map(Numbers::Quarter)),
        Planned::new(family, "clearance and thickness", || {
            let [first, other] = family::same_place()?;
            let (curves, wide_plate) = (family::curves()?, family::in_wide_plate());
            Ok(Numbers::Family { curves, same_place: [first, other], wide_plate })
        }),
        Planned::new(family, "sensitivities", || family::slopes().map(Numbers::Slopes)),
    ];
    orders.into_iter().chain(others).collect()
}

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Orders { series, load } => nested::judge_orders(series, *load),
        Numbers::ModelError(ratios) => cylinder::judge_model_error(ratios),
        Numbers::PinRod { series, difference } => nested::judge_pin_rod(series, *difference),
        Numbers::Quarter(changes) => changes.iter().flat_map(cylinder::judge_change).collect(),
        Numbers::Family { curves, same_place, wide_plate } => family::judge(curves, same_place, *wide_plate),
        Numbers::Slopes(slopes) => slopes.iter().flat_map(family::judge_slope).collect(),
    })
}

/// Tables of the nested meshes and of the model error; the quarter; the family.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let [mut refinement, mut quarter, mut family] = [
        picture(nested::FILE, "Observed orders of accuracy") + nested::INTRODUCTION,
        "## Half cylinder against quarter\n\n".to_owned(),
        "## The dimensionless family of the pin–rod\n\n".to_owned() + &family::introduction(),
    ];
    for found in findings {
        match found.numbers {
            Numbers::Orders { series, load } => refinement += &nested::table_of_orders(series, *load),
            Numbers::ModelError(ratios) => refinement += &cylinder::table_of_ratios(ratios),
            Numbers::PinRod { series, .. } => refinement += &nested::table_of_pin_rod(series),
            Numbers::Quarter(changes) => quarter += &cylinder::table_of_changes(changes),
            Numbers::Family { curves, .. } => family += &family::table_of_curves(curves),
            Numbers::Slopes(slopes) => family += &family::table_of_slopes(slopes),
        }
    }
    Ok(refinement + &quarter + &family)
}

/// Errors over the mesh size, and the family over the clearance.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let numbers = || findings.iter().map(|found| found.numbers);
    let orders: Vec<&Series> = numbers()
        .filter_map(|one| if let Numbers::Orders { series, .. } = one { Some(series) } else { None })
        .collect();
    let curves: Vec<&[Curve]> = numbers()
        .filter_map(|one| if let Numbers::Family { curves, .. } = one { Some(curves.as_slice()) } else { None })
        .collect();
    Ok(vec![(nested::FILE.into(), nested::chart(&orders)), (family::FILE.into(), family::chart(&curves))])
}
