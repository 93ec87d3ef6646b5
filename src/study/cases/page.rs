//! Which page shows a case, and with which pictures.

use crate::case::Case;
use crate::study::drawn::picture;

/// Name of the page: a scene file has one of its own, cases of the library share that of their scene.
pub fn page(case: &Case) -> String {
    let name = if case.places.is_some() { &case.name } else { &case.scene.name };
    name.replace('.', "-")
}

/// The sketch of the scene of a page; none where there is none.
pub fn sketch(page: &str) -> Option<String> {
    let (file, caption) = match page {
        "cylinder" => (
            "scene-cylinder.svg",
            "As Fig. 8. The scene: lower quarter, half by symmetry, uniform load on the horizontal cut",
        ),
        "pin-rod" => (
            "scene-pin-rod.svg",
            "As Fig. 12. The scene: pin fixed on its horizontal diameter, rod pulled by a rigid end face",
        ),
        _ => return None,
    };
    Some(picture(file, caption))
}

/// The charts of a page; none where there are none.
pub fn charts(page: &str) -> Option<String> {
    let charts = match page {
        "cylinder" => [
            (
                "figure-10.svg",
                "Fig. 10: Hertz's exact solution and the five combinations of elements and algorithms that the paper shows",
            ),
            ("pressure-cylinder.svg", "As Fig. 10 with all nine formulations, and their difference to Hertz"),
        ],
        "pin-rod" => [
            (
                "figure-14.svg",
                "Fig. 14: pressure against angle of the five combinations that the paper shows; the place of Gaertner's curves is empty",
            ),
            ("pressure-pin-rod.svg", "As Fig. 14 with all nine formulations"),
        ],
        _ => return None,
    };
    Some(charts.map(|(file, caption)| picture(file, caption)).concat())
}

/// What is to be known of the scene of a page beside its title; empty where that is all.
pub fn remark(page: &str) -> &'static str {
    match page {
        "cylinder" => {
            "The quarter cylinder under uniform load is not quite Hertz's problem: the model error falls with a/R, see \
             [Refinement](refinement.md). Stresses on the deformed shape: [Fields](fields.md).\n\n"
        }
        "truncated-hertz" => {
            "A block between the closed-form tractions of Hertz's half-space and a rigid parabola: all errors are discretisation errors.\n\n"
        }
        "pin-rod" => {
            "No closed form: the formulations are held against one another, the [refinement series](refinement.md) gives its own \
             uncertainty, and [independent codes](independent.md) solve the same problem. A [pin in a wide plate](case-pin-plate.md) is the \
             same contact with a closed form. Stresses on the deformed shapes: [Fields](fields.md).\n\n"
        }
        _ => "",
    }
}
