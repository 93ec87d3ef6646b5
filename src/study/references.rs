//! Reference answers to five digits where no closed form exists, by cells of high order fitted to the contact,
//! confirmed by other meshes and by 8-node cells; and a benchmark sheet a case of the library: all that somebody with
//! another code needs to run it.

use std::fmt::Write;
use std::sync::{Arc, OnceLock};

use crate::accuracy::reference::{self, Known, MESHES};
use crate::accuracy::{Barred, Told, bars};
use crate::case::library::{Cylinder, NAMES, find};
use crate::case::{self, Case, Check, Judged, Reference};
use crate::error::Error;
use crate::markdown::{self, significant, to_bound};
use crate::measure::Quantity;
use crate::mesh::Resolution;
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::high::High;
use crate::oracle::cross_code::independent::Independent;
use crate::oracle::cross_code::revolution::{Called, Revolution};
use crate::scene::{ContactPair, Scene};
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::described;
use crate::study::differences::on_finest;
use crate::study::sheet::{FoundBy, Other, SHEETS, Sheet, Value, bounded, definition};

/// Scenes with an answer: cases of the library, and its cylinder with a contact twice as wide.
const NAMED: [&str; 4] = ["cylinder", "pin-rod", "pin-plate", WIDE];
const WIDE: &str = "cylinder, a/R = 0.1";

/// Halvings of the case's own mesh of 8-node cells.
const REFINEMENT: u32 = 1;

/// Cases of bodies of revolution that other codes have solved.
const AROUND: [&str; 2] = ["sphere", "truncated-sphere"];

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Of a scene on all meshes.
    Answer {
        /// Degrees of freedom of the answer, of the other meshes, and of the 8-node cells.
        dofs: [usize; 5],
        /// What is known of it.
        known: Vec<Answered>,
    },
    /// What is on a sheet.
    Sheet(Sheet),
}

impl Study for Numbers {
    const NAME: &'static str = "references";
    const ABOUT: About = About {
        title: "Reference answers and benchmark sheets",
        asked: "Which numbers of scenes without a closed form are known to five digits, and what somebody with \
            another code needs to run the cases of the library.",
        limits: "The error bar of an answer is drawn from differences between meshes of this code; who found it too, \
            and what they confirm it to, stands beside it. A closed form may be of an idealised scene; the sheet says \
            where.",
    };

    /// A trial an answer, and a case of the library.
    fn plan() -> Vec<Planned<Self>> {
        let shared = NAMES.map(|(name, _)| (name, Shared::default()));
        let of =
            |name: &str| shared.iter().find(|(own, _)| *own == name).map_or_else(Shared::default, |own| own.1.clone());
        let answers = NAMED.map(|name| {
            let found = of(name);
            Planned::new("reference answers", name, move || answer(name, &found))
        });
        let sheets = NAMES.map(|(name, _)| {
            let found = of(name);
            Planned::new("benchmark sheets", name, move || solve_once(name, &found).map(Numbers::Sheet))
        });
        answers.into_iter().chain(sheets).collect()
    }

    /// The checks: answers are known to five digits; values of a sheet are met by the codes that solved the case, but
    /// for those that its reference answer is held against.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Answer { known, .. } => known.iter().flat_map(judge_answer).collect(),
            Numbers::Sheet(Sheet { name, values, .. }) => {
                let has_answer = NAMED.contains(&name.as_str());
                let others = values.iter().flat_map(|value| value.others.iter().map(move |other| (value, other)));
                let own = others.filter(|(_, other)| !(has_answer && other.of_high_order));
                own.map(|(value, other)| value.met(other)).collect()
            }
        })
    }

    /// A table an answer, and the list of the sheets.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let [(answer, answer_cells), (order, _), (layers, _), (_, other_cells)] = MESHES;
        let [mut answers, mut sheets] = [const { String::new() }; 2];
        for found in findings {
            match found.numbers {
                Numbers::Answer { dofs, known } => {
                    let _ = write!(answers, "\n## {}\n\n{}", found.name, table_of_answer(*dofs, known));
                }
                Numbers::Sheet(Sheet { name, title, .. }) => {
                    let _ = writeln!(sheets, "* [{name}]({SHEETS}/{name}.md): {title}");
                }
            }
        }
        Ok(format!(
            include_str!("references.md"),
            order = answer.order.number(),
            cells = answer_cells,
            layers = answer.layers,
            other_order = order.order.number(),
            fewer_layers = layers.layers,
            other_cells = other_cells,
            answers = answers,
            sheets = sheets
        ))
    }
}

/// A number of an answer, in the unit that it is shown in.
#[derive(Clone, Debug)]
pub struct Answered {
    /// The number.
    pub known: Known,
    /// Its unit.
    pub unit: &'static str,
    /// What 8-node cells say with the error bar of that; none of what has no bar there.
    pub eight: Option<[f64; 2]>,
    /// What scripts of high order found.
    pub others: Vec<Other>,
    /// What they shall confirm it to, over its scale.
    pub digits: f64,
}

/// A case on 8-node cells half as large as its own, with the error bars of its numbers.
fn on_8_node_cells(case: &Case) -> Result<(Discretisation, Run, Vec<Barred>), Error> {
    let resolution = Resolution { refinement: REFINEMENT, ..case.resolution };
    let made = Discretisation::of(case.scene.clone(), resolution)?;
    let run = Run::of(&made, &Formulation::verification())?.with_limits(&made)?;
    let barred = bars(&made, &run, &[])?.all;
    Ok((made, run, barred))
}

/// What is known of a scene, from whichever trial found it first; neither waits, for what it waits for may be its own
/// work.
pub type Shared = Arc<OnceLock<Result<reference::Answer, Error>>>;

fn once(found: &Shared, scene: &Scene) -> Result<reference::Answer, Error> {
    let answer = found.get().cloned().unwrap_or_else(|| reference::answer(scene));
    found.get_or_init(|| answer).clone()
}

/// A scene on all meshes, by the name of its trial.
fn answer(name: &str, found: &Shared) -> Result<Numbers, Error> {
    let case = match name {
        WIDE => Cylinder { a_over_r: 0.1, ..Cylinder::default() }.case().named(WIDE),
        _ => find(name, None)?,
    };
    let reference::Answer { known, dofs: [answer, order, layers, cells], .. } = once(found, &case.scene)?;
    let (_, run, barred) = on_8_node_cells(&case)?;
    let (high, on_arc) = (High::built_in()?, !case.scene.contact().path.is_straight());
    let answered = |one: Known| {
        let (unit, factor) = one.quantity.unit(on_arc);
        let eight = barred.iter().find(|barred| barred.is_of(0, &one.quantity));
        let eight = eight.map(|of| [factor * of.value, factor * of.bar.total()]);
        let digits = if on_arc { DIGITS } else { STRAIGHT };
        Answered { known: one.times(factor), unit, eight, others: others(&high, name, &one.quantity, factor), digits }
    };
    let dofs = [answer, order, layers, cells, run.dofs];
    Ok(Numbers::Answer { dofs, known: known.into_iter().map(answered).collect() })
}

/// What scripts of high order found of a number.
fn others(high: &High, scene: &str, quantity: &Quantity, factor: f64) -> Vec<Other> {
    high.of(scene, &quantity.key())
        .into_iter()
        .map(|(way, found)| Other::of_high_order(way, found).times(factor))
        .collect()
}

/// The sheet of a case of the library.
pub fn solve(name: &str) -> Result<Sheet, Error> {
    solve_once(name, &Shared::default())
}

fn solve_once(name: &str, found: &Shared) -> Result<Sheet, Error> {
    let case = find(name, None)?;
    let (discretisation, run, barred) = on_8_node_cells(&case)?;
    sheet(&case, &discretisation, &run, &barred, found)
}

/// The sheet of a case from a run, whose numbers have bars; or from cells fitted to the contact, where that can be and
/// tells more.
pub fn sheet(
    case: &Case,
    discretisation: &Discretisation,
    run: &Run,
    barred: &[Barred],
    found: &Shared,
) -> Result<Sheet, Error> {
    // A file may be called as a case of the library is.
    let name = if case.places.is_none() { case.name.as_str() } else { "" };
    let all = series(name)?;
    let value = |one: &Barred| {
        let Told { of, quantity, unit, factor } = Told::of(&discretisation.scene, run, one);
        let closed_form = case.reading(one.contact, &one.quantity).value;
        let closed_form = Some(closed_form).filter(|value| value.is_finite()).map(|value| factor * value);
        let others = all.iter().filter_map(|(by, has_penalty, series)| {
            Some(Other::of_series(by, *has_penalty, other(series, one)?).times(factor))
        });
        let sound = run.solution.converged() && !run.is_unbounded(one.contact, &one.quantity);
        let value = if sound { factor * one.value } else { f64::NAN };
        let (bar, others) = (factor * one.bar.total(), others.collect());
        Value {
            of,
            number: one.quantity.clone(),
            quantity,
            unit,
            definition: definition(&one.quantity, &case.scene, &case.scene.contacts[one.contact]),
            value,
            bar,
            found: FoundBy::EightNodeCells,
            closed_form,
            others,
            confirmed_by: vec![],
        }
    };
    let mut scene = described::scene(&case.scene);
    scene.push(described::elsewhere(&case.name, &case.scene, &discretisation.mesh));
    let mut sheet = Sheet {
        name: case.name.clone(),
        title: case.title.clone(),
        scene,
        sources: described::sources(case),
        plane: case.scene.plane.name(),
        thickness: case.scene.thickness,
        half_of_symmetric: case.scene.contacts.iter().any(|pair| pair.symmetric),
        dofs: run.dofs,
        values: barred.iter().map(value).collect(),
    };
    if let ([pair], Ok(answer)) = (&case.scene.contacts[..], once(found, &case.scene)) {
        let known = answer.known.iter().filter(|known| !run.is_unbounded(0, &known.quantity));
        known.for_each(|known| sheet.takes(&case.scene, pair, known));
        let high = High::built_in()?;
        for own in sheet.values.iter_mut().filter(|own| own.of == pair.name) {
            let (_, factor) = own.number.unit(!pair.path.is_straight());
            own.others.extend(others(&high, name, &own.number, factor));
        }
    }
    Ok(sheet)
}

/// What other codes answered of a case of the library: what each is called, whether its springs are felt, and its
/// answers from coarse to fine.
fn series(name: &str) -> Result<Vec<Called>, Error> {
    if AROUND.contains(&name) {
        return Ok(Revolution::built_in()?.of(name));
    }
    // Of both cylinders the narrower contact, which is that of the library, comes first.
    let asked = Independent::built_in()?.scenes.into_values().find(|asked| asked.scene.case == name);
    let each = asked.into_iter().flat_map(|asked| asked.answers);
    Ok(each.map(|(script, series)| (script.title(), script.has_penalty(), series)).collect())
}

/// What a script found of a number, and its standard uncertainty; none where it does not tell it.
fn other(series: &[PhysicalAnswer], one: &Barred) -> Option<[f64; 2]> {
    let of: fn(&PhysicalAnswer) -> f64 = match (one.contact, &one.quantity) {
        (0, Quantity::PeakPressure) => |answer| answer.peak,
        (0, Quantity::SecondMomentWidth) => |answer| answer.half_width,
        _ => return None,
    };
    on_finest(series, of)
}

impl Sheet {
    /// Takes a number of a contact that is known better; as the last of those of contacts where there was none of its
    /// name.
    fn takes(&mut self, scene: &Scene, pair: &ContactPair, known: &Known) {
        let (unit, factor) = known.quantity.unit(!pair.path.is_straight());
        let Known { value, bar, quantity: number, .. } = known.times(factor);
        match self.values.iter_mut().find(|own| own.of == pair.name && own.number == number) {
            Some(own) if bar <= own.bar => (own.value, own.bar, own.found) = (value, bar, FoundBy::FittedCells),
            Some(_) => {}
            None if value.is_finite() => {
                let place = self.values.iter().take_while(|own| own.of == pair.name).count();
                let row = Value {
                    of: pair.name.clone(),
                    quantity: number.key().into_owned(),
                    unit,
                    definition: definition(&number, scene, pair),
                    number,
                    value,
                    bar,
                    found: FoundBy::FittedCells,
                    closed_form: None,
                    others: vec![],
                    confirmed_by: vec![],
                };
                self.values.insert(place, row);
            }
            None => {}
        }
    }
}

/// Bound of a number of an answer over its scale, and what others shall confirm it to.
const DIGITS: f64 = 1e-5;
/// The second along a straight contact.
const STRAIGHT: f64 = 1e-6;

fn judge_answer(Answered { known, eight, others, digits, .. }: &Answered) -> Vec<Judged> {
    let at = |name: &'static str| case::Quantity::at(name, known.quantity.key());
    let because = "what other codes are measured against has five digits";
    let meshes = Reference::own("the other meshes", 0.0);
    let bar = Check::error(at("relative error bar of a reference answer"), meshes, DIGITS, because)
        .judge(known.bar / known.scale);
    let eight = eight.map(|[value, bar]| {
        let because = "the error bars of 8-node cells and of the answer";
        let quantity = at("difference of 8-node cells over what both may be off");
        Check::error(quantity, Reference::own("8-node cells", 0.0), 1.0, because)
            .judge((value - known.value).abs() / (bar + known.bar))
    });
    let others = others.iter().flat_map(|other| {
        let because =
            "what both may be off: the error bar, and twice the largest difference between settings of theirs";
        let meets = other.meets(known.value, known.bar, known.quantity.key().into_owned(), because);
        let because = "what is to be confirmed: six digits, of pins five";
        let to = Check::error(at("difference and error bar of theirs, relative"), other.reference(), *digits, because);
        [meets, to.judge(other.confirms(known.value, known.scale))]
    });
    [bar].into_iter().chain(eight).chain(others).collect()
}

fn table_of_answer([answer, order, layers, cells, eight]: [usize; 5], known: &[Answered]) -> String {
    let head = [
        "quantity".into(),
        "unit".into(),
        format!("answer ± error bar, {answer} dofs"),
        "error bar, relative".into(),
        format!("other order, {order}"),
        format!("fewer layers, {layers}"),
        format!("other cells, {cells}"),
        format!("8-node ± error bar, {eight}"),
        "found by others too (confirm it to)".into(),
    ];
    let row = |Answered { known, unit, eight, others, .. }: &Answered| {
        let [order, layers, cells] = known.others.map(|other| to_bound(other, known.bar));
        let name = known.quantity.key().into_owned();
        let relative = significant(known.bar / known.scale, 2);
        let eight = eight.map_or("–".into(), |[value, bar]| bounded(value, bar));
        let told = |other: &Other| {
            let to = significant(other.confirms(known.value, known.scale), 2);
            format!("{}: {} ({to})", other.by, bounded(other.value, other.bar))
        };
        let others = others.iter().map(told).collect::<Vec<_>>().join("; ");
        let others = if others.is_empty() { "–".into() } else { others };
        vec![name, (*unit).into(), bounded(known.value, known.bar), relative, order, layers, cells, eight, others]
    };
    markdown::table(&head, &known.iter().map(row).collect::<Vec<_>>())
}
