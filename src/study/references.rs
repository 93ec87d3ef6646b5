//! Reference answers to five digits where no closed form exists: cells of high order fitted to the contact, confirmed by other meshes and by
//! 8-node cells.

use std::fmt::Write;

use serde::Serialize;

use crate::accuracy::reference::{self, Answer, Known, MESHES};
use crate::accuracy::{Barred, Subject, bars};
use crate::case::library::{Cylinder, find};
use crate::case::{Case, Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{significant, table, to_bound};
use crate::mesh::Resolution;
use crate::scene::Path;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::About;
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Reference answers",
    asked: "Which numbers of scenes without a closed form are known to five digits.",
    limits: "The bound is drawn from differences between meshes of this code; other codes confirm it to three or four digits only.",
};

/// Cases of the library.
const NAMED: [&str; 3] = ["cylinder", "pin-rod", "pin-plate"];

/// One trial a scene: those of the library, and the cylinder with a contact twice as wide.
pub fn plan() -> Vec<Planned<Numbers>> {
    let wide = Cylinder { a_over_r: 0.1, ..Cylinder::default() }.case().named("cylinder, a/R = 0.1");
    let known = NAMED.map(|name| find(name, None));
    let trial = |name: String, case: Result<Case, Error>| {
        Planned::new("reference answers", name, move || numbers(case.as_ref().map_err(Clone::clone)?))
    };
    let named = NAMED.iter().zip(known).map(|(name, case)| trial((*name).into(), case));
    named.chain([trial(wide.name.clone(), Ok(wide.clone()))]).collect()
}

/// A scene.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Its case.
    pub case: String,
    /// Path of its contact.
    #[serde(skip)]
    pub path: Path,
    /// Degrees of freedom of the answer, of the other meshes, and of the 8-node cells.
    pub dofs: [usize; 5],
    /// What is known of it, and what 8-node cells say with the error bar of that; none of what has no bar there.
    pub known: Vec<(Known, Option<[f64; 2]>)>,
}

/// A scene on all meshes, in the units that its numbers are shown in.
pub fn numbers(case: &Case) -> Result<Numbers, Error> {
    let Answer { known, dofs: [answer, order, layers, cells] } = reference::answer(&case.scene)?;
    let made = Discretisation::of(case.scene.clone(), Resolution { refinement: 1, ..case.resolution })?;
    let run = Run::of(&made, &Formulation::verification())?;
    let barred = bars(&made, &run, &[])?;
    let row = |one: Known| {
        let (_, factor) = one.measured.unit(&case.scene.contact().path);
        let is_it =
            |barred: &&Barred| one.measured.quantity().is_some_and(|own| barred.subject == Subject::Contact(0, own));
        let eight = barred.all.iter().find(is_it).map(|of| [factor * of.value, factor * of.bar.total()]);
        (one.times(factor), eight)
    };
    let dofs = [answer, order, layers, cells, run.dofs];
    Ok(Numbers {
        case: case.name.clone(),
        path: case.scene.contact().path,
        dofs,
        known: known.into_iter().map(row).collect(),
    })
}

/// Bound of a number over its scale.
const DIGITS: f64 = 1e-5;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(numbers.known.iter().flat_map(of).collect())
}

fn of((one, eight): &(Known, Option<[f64; 2]>)) -> Vec<Judged> {
    let at = |name: &'static str| Quantity::at(name, one.measured.name());
    let because = "what other codes are measured against has five digits";
    let meshes = Reference::own("the other meshes", 0.0);
    let bound =
        Check::error(at("relative bound of a reference answer"), meshes, DIGITS, because).judge(one.bound / one.scale);
    let eight = eight.map(|[value, bar]| {
        let because = "the error bar of 8-node cells, and the bound";
        let quantity = at("difference of 8-node cells over what both may be off");
        Check::error(quantity, Reference::own("8-node cells", 0.0), 1.0, because)
            .judge((value - one.value).abs() / (bar + one.bound))
    });
    [bound].into_iter().chain(eight).collect()
}

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
