//! Whether error bars hold: shares by family and number.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::coverage::group::{CELLS, Group};
use crate::study::coverage::run::{Kind, Numbers, Record};
use crate::study::coverage::setup::ELEMENTS;
use crate::study::coverage::sites::FAMILIES;
use crate::study::drawn::picture;
use crate::study::random::Family;

/// Columns.
const HEAD: [&str; 7] = [
    "scenes",
    "number",
    "numbers",
    "within, 4-node",
    "within, 8-node",
    "bar over error, median",
    "largest error over bar",
];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let recorded: Vec<Record> = findings.iter().flat_map(|found| found.numbers.recorded.clone()).collect();
    let by_family = FAMILIES.into_iter().flat_map(|family| {
        let kinds = Kind::ALL.into_iter();
        let rows: Vec<_> = kinds.filter_map(|kind| row(&recorded, Some(family), kind)).collect();
        rows
    });
    let all = Kind::ALL.into_iter().filter_map(|kind| row(&recorded, None, kind));
    let rows: Vec<Vec<String>> = all.chain(by_family).collect();
    let [fewest, most] = ELEMENTS;
    Ok(format!(
        "`solve` prints every number with a bar: what the mesh, the iteration and a penalty may leave in it \
         (`src/solver/accuracy/bar.rs`). Here they are held against random scenes whose true errors are known, by closed forms or a boundary method, on random \
         meshes: {fewest} to {most} elements on half of the contact, which ends anywhere within one of them, and enough \
         for the tip of a wedge and the thickness of a ring (what is smaller than the elements no coarser mesh sees); random growth; 4- and 8-node cells, line, layer and node \
         elements, iterations that end late, early, or with a penalty. The constants of the bars were chosen on other scenes. Where the pressure rises up \
         to the last element of a contact, neither its peak nor the shear stress below has a bar. `cargo run --release -- coverage` renews the record; the report recomputes a part of it.\n\n{}\n\n{}{}\n\
         Errors of the peak are relative to it, of places and widths to the half-width, of forces to the force; *bar over error* leaves \
         out errors that are round-off.\n",
        summary(&recorded),
        picture(
            "coverage.svg",
            "True error against the bar claimed: in each range of bars the median, the 95th of 100 and the largest error; below the diagonal a bar holds; errors that are round-off are left out"
        ),
        markdown::table(&HEAD.map(String::from), &rows)
    ))
}

/// How many lie where.
fn summary(recorded: &[Record]) -> String {
    let all = Group::of(recorded, |_| true);
    let beyond = |bars: f64| recorded.iter().filter(|record| record.error > bars * record.bar).count();
    format!(
        "Of {} numbers {} are beyond their bar, {} beyond three times it, and {} have none; the median bar is {} times the error.",
        recorded.len(),
        beyond(1.0),
        beyond(3.0),
        all.unknown(),
        markdown::significant(all.median(), 2)
    )
}

/// A number of a family, or of all; none where there is no such number.
fn row(recorded: &[Record], family: Option<Family>, kind: Kind) -> Option<Vec<String>> {
    let is_meant = |record: &Record| record.kind == kind && family.is_none_or(|family| record.family == family);
    let group = Group::of(recorded, is_meant);
    let within = |cell: usize| {
        let own = Group::of(recorded, |record| is_meant(record) && record.cell == cell);
        format!("{:.1} %", 100.0 * own.within(1.0))
    };
    let unknown = match group.unknown() {
        0 => String::new(),
        number => format!("; {number} not known"),
    };
    let or_none = |x: f64| if x.is_nan() { "–".into() } else { markdown::significant(x, 2) };
    (!group.records.is_empty()).then(|| {
        vec![
            family.map_or("**all**".into(), |family| family.title().to_string()),
            kind.title().into(),
            group.records.len().to_string(),
            within(CELLS[0]),
            within(CELLS[1]),
            or_none(group.median()),
            markdown::significant(group.worst(), 2) + &unknown,
        ]
    })
}
