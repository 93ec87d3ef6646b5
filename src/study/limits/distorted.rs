//! Limit of the cells: inner nodes are moved until cells turn inside out.

use serde::Serialize;

use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::Errors;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::{Refusal, Seen, Why, told};
use crate::study::limits::solved::{hertz_errors, on_even_cells, unchecked, with_both_orders, worst};
use crate::study::limits::written::{bracket, number, percents, range, size};

/// Largest moves of inner nodes over their shortest edge.
const FRACTIONS: [f64; 8] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];

/// Truncated Hertz on shaken meshes.
#[derive(Clone, Debug, Serialize)]
pub struct Distorted {
    /// By move, on 4-node and 8-node cells.
    pub moves: Vec<[Shaken; 2]>,
}

/// A run on a shaken mesh.
#[derive(Clone, Debug, Serialize)]
pub struct Shaken {
    /// What the user sees.
    pub seen: Seen,
    /// Errors against Hertz; none where the mesh is refused.
    pub errors: Option<Errors>,
}

/// Every move on both kinds of cells.
pub(super) fn run() -> Result<Distorted, Error> {
    let scene = on_even_cells(TruncatedHertz::default());
    Ok(Distorted { moves: with_both_orders(&FRACTIONS, |fraction, order| shaken(&scene, fraction, order))? })
}

fn shaken(scene: &Scene, fraction: f64, order: Order) -> Result<Shaken, Error> {
    let resolution = Resolution { elements: 8, refinement: 0, order };
    let result = unchecked(scene, Mesh::of(scene, resolution)?.shaken(fraction), resolution);
    Ok(Shaken { errors: result.as_ref().ok().map(|run| hertz_errors(scene, run)), seen: Seen::of(&result) })
}

impl Shaken {
    fn cell(&self) -> String {
        self.errors.map_or(self.seen.to_string(), |errors| {
            let [peak, width] = percents(errors);
            format!("p₀ {peak}, a {width}")
        })
    }
}

impl Distorted {
    fn worst(&self) -> f64 {
        worst(self.moves.iter().flatten().filter_map(|shaken| shaken.errors))
    }

    fn refusals(&self) -> impl DoubleEndedIterator<Item = &Refusal> {
        self.moves.iter().flatten().filter_map(|shaken| shaken.seen.refusal())
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let others = self.refusals().filter(|refusal| refusal.why != Why::InvertedCell).count();
        vec![
            Check::error(
                "largest error of p₀ and a on cells that are distorted but not inverted",
                Reference::analytic("Hertz", 0.0),
                1e-2,
                "isoparametric cells keep linear fields; engineering tolerance of the paper's comparison",
            )
            .judge(self.worst()),
            Check::none(
                Quantity::at("refusal that does not name an inverted cell", format!("of {}", self.refusals().count())),
                "the Jacobian determinant is looked at in every cell",
            )
            .judge(others as f64),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let onset = |k: usize| bracket(&FRACTIONS, |i| self.moves[i][k].errors.is_none(), "fraction");
        let [seen, instead] = told(self.refusals().next_back());
        Limit {
            pushed: "distorted and inverted cells",
            range: range(&FRACTIONS, "move of the inner nodes over their shortest edge"),
            onset: format!(
                "4-node: inverted {}; 8-node: inverted {}; before, errors of p₀ and a are at most {}",
                onset(0),
                onset(1),
                size(self.worst())
            ),
            seen,
            instead,
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(fraction, cells): (f64, &[Shaken; 2])| {
            std::iter::once(number(fraction)).chain(cells.iter().map(Shaken::cell)).collect()
        };
        Detail::of(
            "Truncated Hertz on shaken meshes (errors against Hertz)",
            &["move / shortest edge", "4-node", "8-node"],
            FRACTIONS.into_iter().zip(&self.moves).map(row),
        )
    }
}
