//! What is run: three scenes, each to three accuracies, beside the cheapest meshes made by hand.

use crate::mesh::Order;
use crate::study::Planned;
use crate::study::accuracy::by_hand::ByHand;
use crate::study::accuracy::run::{self, Numbers};
use crate::study::accuracy::subject::Subject;

/// Errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 3e-3, 1e-3];

const fn by_hand(order: Order, elements: usize, end: f64, first: f64, growth: [f64; 3]) -> ByHand {
    ByHand { order, elements, beyond: 1, end, first, growth }
}

/// The cheapest meshes found by hand, for 1 %, 0.3 % and 0.1 %.
///
/// Of about 5,000 meshes a scene: 4-node and 8-node cells; 1 to 12 elements (16 on the pin) in the half-width; 1 to 3 beyond
/// it; candidates equal, or ending at a half or a quarter of the first; first rows of 1 or 2 sizes; growths 1.5/1.4 to 4/3.5;
/// coarsest element 0.3, 0.5 or 1 body. Kept is the one of fewest degrees of freedom whose worst errors of peak and second-moment width against
/// the closed form, over eight loads that move the contact edge across one element, are both within the asked one.
const BY_HAND: [(Subject, [ByHand; 3]); 3] = [
    (
        Subject::Truncated,
        [
            by_hand(Order::Quadratic, 3, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 6, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 8, 0.5, 2.0, [2.0, 1.8, 0.5]),
        ],
    ),
    (
        Subject::Cylinder,
        [
            by_hand(Order::Linear, 5, 0.5, 1.0, [2.5, 2.2, 0.3]),
            by_hand(Order::Quadratic, 5, 1.0, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 0.3]),
        ],
    ),
    (
        Subject::Pin,
        [
            by_hand(Order::Quadratic, 4, 0.5, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 6, 0.25, 1.0, [4.0, 3.5, 1.0]),
            by_hand(Order::Quadratic, 10, 1.0, 1.0, [4.0, 3.5, 1.0]),
        ],
    ),
];

/// One trial a scene and an accuracy.
pub fn plan() -> Vec<Planned<Numbers>> {
    let of = |(subject, meshes): (Subject, [ByHand; 3])| {
        ASKED.into_iter().zip(meshes).map(move |(asked, mesh)| {
            let name = format!("{}, {} %", subject.name(), 100.0 * asked);
            Planned::new("accuracy asked", name, move || run::numbers(subject, asked, mesh))
        })
    };
    BY_HAND.into_iter().flat_map(of).collect()
}
