//! A row a number.

use std::fmt::Write;

use crate::accuracy::reference::{Known, MESHES};
use crate::error::Error;
use crate::markdown::{significant, table, to_bound};
use crate::scene::Path;
use crate::study::Found;
use crate::study::references::run::Numbers;

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let [answer, order, layers, cells] = MESHES;
    let mut text = format!(
        "The answer is that of cells of order {}, {} on every piece of the contact side, with {} layers towards the ends of the contact, \
         towards forces at points and re-entrant corners; its ends are found on the way, to a millionth of the half-width. Three other meshes \
         confirm it: cells of order {}; {} layers; {} cells on every piece. The bound is twice the largest difference to one of them. 8-node cells, \
         half as large as the case has them, stand beside it with their error bars; an end is there known to a part of an element only. The \
         [benchmark sheets](sheets.md) have the answers.\n",
        answer.fitted.order.number(),
        answer.cells,
        answer.fitted.layers,
        order.fitted.order.number(),
        layers.fitted.layers,
        cells.cells,
    );
    for found in findings {
        let Numbers { case, path, dofs: [answer, order, layers, cells, eight], known } = found.numbers;
        let _ = write!(text, "\n## {case}\n\n");
        let head = [
            "quantity".into(),
            "unit".into(),
            format!("answer ± bound, {answer} dofs"),
            "bound, relative".into(),
            format!("other order, {order}"),
            format!("fewer layers, {layers}"),
            format!("other cells, {cells}"),
            format!("8-node ± error bar, {eight}"),
        ];
        text += &table(&head, &known.iter().map(|one| row(path, one)).collect::<Vec<_>>());
    }
    Ok(text)
}

fn row(path: &Path, (one, eight): &(Known, Option<[f64; 2]>)) -> Vec<String> {
    let bounded = |value: f64, bound: f64| format!("{} ± {}", to_bound(value, bound), significant(bound, 2));
    let others = one.others.map(|other| to_bound(other, one.bound));
    let eight = eight.map_or("–".into(), |[value, bar]| bounded(value, bar));
    let start = [
        one.measured.name().into(),
        one.measured.unit(path).0.into(),
        bounded(one.value, one.bound),
        significant(one.bound / one.scale, 2),
    ];
    start.into_iter().chain(others).chain([eight]).collect()
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
