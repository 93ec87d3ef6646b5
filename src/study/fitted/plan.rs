//! Which meshes, and what is asked of them.

use crate::mesh::Order;
use crate::solve::Fitted;
use crate::study::Planned;
use crate::study::fitted::run::{self, Numbers};

/// What is asked of a mesh fitted to the contact.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Digits that its order and layers are chosen for.
    pub digits: usize,
    /// Relative error of peak and second-moment width.
    pub error: f64,
    /// Degrees of freedom.
    pub dofs: usize,
}

/// All that is asked.
pub const ASKED: [Asked; 3] = [
    Asked { digits: 4, error: 1e-4, dofs: 1000 },
    Asked { digits: 5, error: 1e-5, dofs: 1700 },
    Asked { digits: 6, error: 1e-6, dofs: 2700 },
];

/// Fitted meshes of which nothing is asked.
const OTHERS: [Fitted; 2] = [Fitted { order: Order::Quartic, layers: 1 }, Fitted { order: Order::Quintic, layers: 1 }];
/// Relative errors that `--accuracy` is asked for.
const CHOSEN: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// 8-node cells on the half-width that the block is drawn for.
const PLAIN: [usize; 5] = [2, 4, 8, 16, 32];

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    let asked = ASKED.map(|asked| Fitted::of_digits(asked.digits));
    let fitted: Vec<Fitted> = OTHERS.into_iter().chain(asked).collect();
    vec![Planned::new("fitted to the contact, truncated hertz", "node.kinematic", move || {
        run::numbers(&fitted, &CHOSEN, &PLAIN)
    })]
}
