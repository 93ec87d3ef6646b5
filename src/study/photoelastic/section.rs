//! What the photograph can show, what it says, and what it cannot show.

use crate::error::Error;
use crate::markdown::{significant, table};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::photoelastic::run::Numbers;

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    Ok(findings.iter().map(|found| of(found.numbers)).collect())
}

fn of(numbers: &Numbers) -> String {
    let [a, deviation] = numbers.half_width;
    let [red, green, blue] = numbers.constants.orders.map(|order| significant(order, 3));
    let ends = numbers
        .ends
        .iter()
        .map(|end| format!("{}: {} orders ({} points)", end.end, significant(end.rms, 3), end.points));
    let rows: Vec<Vec<String>> = numbers
        .widths
        .iter()
        .map(|width| vec![significant(width.a_over_r, 3), significant(width.held, 2), significant(width.fitted, 2)])
        .collect();
    let head = ["a/R", "rms, all else held", "rms, all else fitted"].map(String::from);
    format!(
        "A photoelastic disc squeezed between two plates (provenance in `oracles/digitised/photoelastic-disc`): *measured, shape only, \
         uncalibrated*. Load, material, diameter and friction are unknown. The difference of the principal stresses over that at the centre, \
         times a constant of each colour channel, is the fringe order. Five constants are fitted at the bottom; nothing is fitted at the top.\n\n\
         Fitted: a/R = {} ± {} (standard deviation if readings were independent), orders at the centre {red} (red), {green} (green), {blue} \
         (blue), loaded edge {} R above the end of the diameter. Root mean square: {}. Reading: about 0.03 orders. A mesh twice as coarse changes \
         {} orders (root mean square), at most {}.\n\n{}\n\
         It shows the stress field near a line contact, the transfer of the load from one contact to the other, and the second moment of the \
         pressure: far-off widths fail, near ones do not. It cannot show the shape of the pressure (uniform, Hertz and punch fit alike), the law \
         between load and width, E, ν, or anything about pins.\n\n{}{}",
        significant(a, 3),
        significant(deviation, 2),
        significant(numbers.constants.edge, 2),
        ends.collect::<Vec<_>>().join(", "),
        significant(numbers.mesh[0], 2),
        significant(numbers.mesh[1], 2),
        table(&head, &rows),
        picture(
            "photoelastic-fringes.svg",
            "Dark fringes near both loaded ends: read from the photograph (points) and computed (lines)"
        ),
        picture(
            "photoelastic-width.svg",
            "How sharply the photograph tells the half-width: root mean square at the bottom"
        ),
    )
}
