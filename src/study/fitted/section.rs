//! A row a mesh.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::fitted::picture::FILE;
use crate::study::fitted::run::{Cells, LOADS, Mesh, Numbers};
use crate::study::fitted::scenes::{self, Elsewhere};

/// Columns.
const HEAD: [&str; 5] = [
    "cells",
    "degrees of freedom",
    "those of all meshes on the way",
    "error of p₀, worst load",
    "error of a, worst load",
];

/// Columns of the other scenes.
const ELSEWHERE: [&str; 6] = ["scene", "order, layers", "degrees of freedom", "error of p₀", "error of a", "against"];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let meshes = findings
        .iter()
        .flat_map(|found| [&found.numbers.fitted, &found.numbers.chosen, &found.numbers.plain].into_iter().flatten());
    let rows: Vec<Vec<String>> = meshes.map(row).collect();
    Ok(format!(
        "Truncated Hertz under {} loads; p₀ is the peak pressure, a the half-width. Cells of order p have (p + 1)² nodes, at products of \
         Gauss–Lobatto–Legendre points. `solve --fitted` lays a mesh line on the end of the contact, and layers of cells towards it, each a \
         fixed part of the one before. It knows nothing of the end: a mesh of 8-node cells finds about where it is; then all points \
         up to an expected end e are closed, the pressure at the distance d from it is p √d = A₀ + B₀ d + C₀ d², and e moves by 2 A₀/B₀ \
         until that no longer matters. Beside them are the meshes that `--accuracy` chooses by their error bars, 8-node cells above 0.1 % and from \
         there on fitted ones, of higher order until the bars are within what is asked; and 8-node cells that are as fine on all candidates.\n\n{}\n{}\n\
         ## Other scenes\n\n\
         Peak and second-moment width to five digits with at most {} degrees of freedom. Rectangles have frames of ever larger cells around a contact, \
         discs too where the contact is small, and rings rows of cells whose radii grow in geometric progression.\n\n{}",
        LOADS.len(),
        markdown::table(&HEAD.map(String::from), &rows),
        picture(
            FILE,
            "Truncated Hertz: larger error of peak pressure and second-moment width, under the worst of all loads"
        ),
        scenes::ASKED.1,
        markdown::table(
            &ELSEWHERE.map(String::from),
            &findings.iter().flat_map(|found| found.numbers.scenes.iter().map(elsewhere)).collect::<Vec<_>>()
        ),
    ))
}

fn row(mesh: &Mesh) -> Vec<String> {
    let cells = match mesh.cells {
        Cells::Fitted(fitted) => format!("fitted, order {}, layers {}", fitted.order.number(), fitted.layers),
        Cells::Chosen(asked) => format!("`--accuracy` {} %", markdown::bound(100.0 * asked)),
        Cells::Plain(elements) => format!("8-node, {elements} per half-width"),
    };
    let errors = [mesh.peak, mesh.half_width].map(markdown::error);
    [cells, mesh.dofs.to_string(), mesh.in_all.to_string()].into_iter().chain(errors).collect()
}

fn elsewhere(one: &Elsewhere) -> Vec<String> {
    let best = scenes::BEST;
    let against = match one.exact {
        true => "closed form".into(),
        false => format!("order {}, {} layers", best.order.number(), best.layers),
    };
    let cells = format!("{}, {}", one.fitted.order.number(), one.fitted.layers);
    let [peak, half_width] = [one.peak, one.half_width].map(markdown::error);
    vec![one.scene.clone(), cells, one.dofs.to_string(), peak, half_width, against]
}
