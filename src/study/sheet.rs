//! A benchmark sheet: what is on it, its page, and its values as data: `snapshots/references.json` and `.csv`.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;

use crate::case::{self, Check, Judged, Reference, Verdict};
use crate::markdown::{self, Column, significant, to_bound};
use crate::measure::Quantity;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::high::Way;
use crate::scene::{ContactPair, Scene};

macro_rules! made {
    ($($name:literal),* $(,)?) => { [$(($name, include_str!(concat!("../../snapshots/sheets/", $name, ".md")))),*] };
}

/// The folder of the sheets.
pub const SHEETS: &str = "snapshots/sheets";
/// The values of all sheets.
pub const JSON: &str = "snapshots/references.json";
/// The same as a table.
pub const CSV: &str = "snapshots/references.csv";
/// The values of all sheets as they were when the program was built, for which no checkout is needed.
pub const BUILT_IN: &str = include_str!("../../snapshots/references.json");
/// The sheets of the library, as they were then too: to make one anew takes references of high order.
const MADE: &[(&str, &str)] = &made![
    "bars",
    "cone",
    "cylinder",
    "cylinder-between-plates",
    "cylinder-half",
    "flat-punch",
    "own-weight",
    "patch",
    "pin-plate",
    "pin-rod",
    "press-fit",
    "press-fit-strain",
    "sphere",
    "truncated-hertz",
    "truncated-sphere",
];
/// Identifier of the schema of the values; another one where a reader of this would be misled.
const ID: &str = "https://github.com/contact-vv/contact-vv/references-1.schema.json";

/// A case of the library with its reference values.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sheet {
    /// Name on the command line.
    #[serde(rename = "case")]
    pub name: String,
    /// What it is.
    pub title: String,
    /// The scene in words and numbers, a paragraph or list each.
    #[serde(skip)]
    pub scene: Vec<String>,
    /// Where scene and closed form come from.
    pub sources: Vec<String>,
    /// Plane `strain` or `stress`, or `axisymmetric` of bodies of revolution.
    pub plane: &'static str,
    /// Thickness \[mm\]: forces are of all of it; 1 of bodies of revolution, whose forces are of the whole
    /// circumference.
    pub thickness: f64,
    /// Whether the scene is one half of a symmetric one: resultants are of the whole, loads and reactions of that half.
    pub half_of_symmetric: bool,
    /// Degrees of freedom of the mesh of 8-node cells.
    pub dofs: usize,
    /// The values.
    pub values: Vec<Value>,
}

/// A reference value.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Value {
    /// The contact, or the body.
    pub of: String,
    /// The number.
    #[serde(skip)]
    pub number: Quantity,
    /// What it is.
    pub quantity: String,
    /// Unit.
    pub unit: &'static str,
    /// What is meant by it, with its sign.
    pub definition: &'static str,
    /// The value; null of a peak without a limit.
    #[schemars(with = "Option<f64>")]
    pub value: f64,
    /// How far it may be off; 0 of a closed form of the very scene, null where it is not known.
    #[schemars(with = "Option<f64>")]
    pub bar: f64,
    /// How it was found.
    pub found: FoundBy,
    /// What the closed form says, which may be of an idealised scene: a half-plane, an infinite plate.
    pub closed_form: Option<f64>,
    /// What scripts of other codes found, in the unit of ours.
    #[serde(skip)]
    pub others: Vec<Other>,
    /// Who else found it; known where values are data.
    pub confirmed_by: Vec<Confirmed>,
}

/// What a script of another code found of a number.
#[derive(Clone, Debug)]
pub struct Other {
    /// Code and method.
    pub by: &'static str,
    /// What it found.
    pub value: f64,
    /// How far it may be off.
    pub bar: f64,
    /// Whether it is one of those that reference answers are held against.
    pub of_high_order: bool,
}

/// How a value was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FoundBy {
    /// By a closed form that no number of the scene departs from by more than its bar.
    ClosedForm,
    /// By our cells of order 8 fitted to the contact.
    FittedCells,
    /// By our 8-node cells.
    EightNodeCells,
}

/// A code that found a value too, with a mesh and a contact of its own; or our cells, where the value is that of a
/// closed form.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Confirmed {
    /// Code and method.
    pub by: String,
    /// What it found.
    pub value: f64,
    /// How far that may be off: three standard uncertainties of a refinement series and what springs leave; twice the
    /// largest difference between settings of a method of high order; or our bar.
    pub bar: f64,
    /// What the value is confirmed to: difference and that bar, relative.
    pub to: f64,
}

impl FoundBy {
    fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::FittedCells => "order 8",
            Self::EightNodeCells => "8-node",
        }
    }
}

/// What springs of the scripts with a penalty may leave, relative.
const PENALTY: f64 = 2e-4;
/// Standard uncertainties of another code that its value may be off: two hold for 95 of 100, and there are thirty
/// comparisons.
const SPREAD: f64 = 3.0;
/// Part of the largest value of a unit that is as good as nothing.
const SMALL: f64 = 1e-3;
/// Relative bar within which our value tells a closed form of the very scene from one of an idealised scene.
const TELLS: f64 = 1e-5;

impl Other {
    /// On the finest mesh of a series, with its standard uncertainty: thrice that, what springs leave, and round-off.
    pub fn of_series(by: &'static str, has_penalty: bool, [value, uncertainty]: [f64; 2]) -> Self {
        let penalty = if has_penalty { PENALTY * value.abs() } else { 0.0 };
        Self { by, value, bar: SPREAD * uncertainty + penalty + 1e-9 * value.abs(), of_high_order: false }
    }

    /// Of high order, with how far it may be off.
    pub fn of_high_order(way: Way, [value, bar]: [f64; 2]) -> Self {
        Self { by: way.title(), value, bar, of_high_order: true }
    }

    /// In another unit.
    pub fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, bar: factor * self.bar, ..self }
    }

    /// It, as what a difference is held against.
    pub fn reference(&self) -> Reference {
        Reference { name: self.by.into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None }
    }

    /// A value of ours within its bar and this one's.
    pub fn meets(&self, value: f64, bar: f64, at: String, because: &'static str) -> Judged {
        let quantity = case::Quantity::at("difference over what both may be off", at);
        Check::error(quantity, self.reference(), 1.0, because).judge((value - self.value).abs() / (bar + self.bar))
    }

    /// What it confirms a value to: difference and bar, over a scale.
    pub fn confirms(&self, value: f64, scale: f64) -> f64 {
        ((self.value - value).abs() + self.bar) / scale.abs()
    }
}

impl Value {
    /// Another code within our bar and its own.
    pub fn met(&self, other: &Other) -> Judged {
        let because = "our error bar and theirs, in which are meshes and springs";
        other.meets(self.value, self.bar, format!("{}, {}", self.quantity, self.of), because)
    }

    /// What another code confirms this one to.
    fn confirmed(&self, other: &Other) -> Confirmed {
        let to = other.confirms(self.value, self.value);
        Confirmed { by: other.by.into(), value: other.value, bar: other.bar, to }
    }

    /// The closed form, where it is of the very scene, else our value; who found it too; no digits but those that are
    /// known.
    fn published(&self, is_exact: bool) -> Self {
        let mut one = self.clone();
        if let Some(closed) = self.closed_form.filter(|_| is_exact) {
            (one.value, one.bar, one.found) = (closed, 0.0, FoundBy::ClosedForm);
            let Self { value, bar, found, .. } = *self;
            let to = ((one.value - value).abs() + bar) / one.value.abs();
            one.confirmed_by = vec![Confirmed { by: format!("our {} cells", found.name()), value, bar, to }];
        }
        let met = self.others.iter().filter(|other| self.met(other).verdict == Verdict::Pass);
        let theirs: Vec<_> = met.map(|other| one.confirmed(other)).collect();
        one.confirmed_by.extend(theirs);
        one.confirmed_by.retain(|confirmed| confirmed.to.is_finite());
        for Confirmed { value, bar, to, .. } in &mut one.confirmed_by {
            (*value, *bar, *to) = (rounded(*value, *bar), digits(*bar, 2), digits(*to, 2));
        }
        (one.value, one.bar) = (rounded(one.value, one.bar), digits(one.bar, 2));
        one.closed_form = one.closed_form.map(|closed| rounded(closed, 0.0));
        one
    }

    /// Whether its closed form, where there is one, is within its bar, and that of a peak or a second-moment width
    /// narrow.
    fn holds_closed_form(&self) -> bool {
        let is_telling = matches!(self.number, Quantity::PeakPressure | Quantity::SecondMomentWidth);
        let tells = !is_telling || self.bar <= TELLS * self.value.abs();
        self.closed_form.is_none_or(|closed| (closed - self.value).abs() <= self.bar && tells)
    }
}

/// A value to the second digit of its bar; without one to six digits, and to those that all machines agree on where it
/// is exact.
fn rounded(value: f64, bar: f64) -> f64 {
    match bar {
        bar if bar.is_nan() => digits(value, 6),
        bar if bar > 0.0 => to_place(value, 1.0 - bar.log10().floor()),
        _ => digits(value, 12),
    }
}

/// A number with so many significant digits.
fn digits(number: f64, count: i32) -> f64 {
    to_place(number, f64::from(count - 1) - number.abs().max(1e-12).log10().floor())
}

/// A number with so many decimal places; what rounds to nothing has no sign.
fn to_place(number: f64, places: f64) -> f64 {
    let tens = 10_f64.powi(places.clamp(0.0, 15.0) as i32);
    (number * tens).round() / tens + 0.0
}

impl Sheet {
    /// Its values as data.
    pub fn published(&self) -> Self {
        let is_exact = self.values.iter().all(Value::holds_closed_form);
        // The place of the peak of a uniform pressure may be anywhere.
        let says_something = |one: &&Value| {
            let sizes = self.values.iter().filter(|other| other.unit == one.unit).map(|other| other.value.abs());
            let largest = sizes.fold(0.0, f64::max);
            one.bar.is_nan() || one.bar < 0.5 * one.value.abs() || one.bar <= SMALL * largest
        };
        let values = self.values.iter().filter(says_something);
        Self { values: values.map(|value| value.published(is_exact)).collect(), ..self.clone() }
    }
}

/// Sheets as JSON.
pub fn json(sheets: &[Sheet]) -> String {
    serde_json::to_string_pretty(sheets).expect("numbers, strings and lists can be written as JSON") + "\n"
}

/// The schema of [`JSON`] (JSON Schema, draft 7).
pub fn schema() -> String {
    let generator = SchemaSettings::draft07().for_serialize().into_generator();
    let mut schema = generator.into_root_schema_for::<Vec<Sheet>>();
    schema.insert("$id".into(), ID.into());
    schema.insert("title".into(), "Reference values of contact-vv".into());
    serde_json::to_string_pretty(&schema).expect("a schema can be written as JSON")
}

/// Columns of [`CSV`]: a row a value, behind what its case is.
pub fn columns<'a>() -> [Column<(&'a Sheet, &'a Value)>; 13] {
    [
        ("case", |(sheet, _)| sheet.name.clone()),
        ("plane", |(sheet, _)| sheet.plane.into()),
        ("thickness [mm]", |(sheet, _)| sheet.thickness.to_string()),
        ("half of symmetric", |(sheet, _)| sheet.half_of_symmetric.to_string()),
        ("of", |(_, one)| one.of.clone()),
        ("quantity", |(_, one)| one.quantity.clone()),
        ("unit", |(_, one)| one.unit.into()),
        ("value", |(_, one)| number(one.value)),
        ("bar", |(_, one)| number(one.bar)),
        ("found by", |(_, one)| one.found.name().into()),
        ("closed form", |(_, one)| number(one.closed_form.unwrap_or(f64::NAN))),
        ("confirmed by", |(_, one)| {
            let confirmed = one.confirmed_by.iter().map(|own| format!("{} to {}", own.by, significant(own.to, 2)));
            confirmed.collect::<Vec<_>>().join("; ")
        }),
        ("definition", |(_, one)| one.definition.into()),
    ]
}

/// What is meant by a number of a contact.
pub fn definition(quantity: &Quantity, scene: &Scene, pair: &ContactPair) -> &'static str {
    let is_circle = pair.path.is_around_axis(scene.plane);
    match quantity {
        Quantity::SecondMomentWidth if is_circle => {
            "√(5/2 ∫p r² dA / ∫p dA), the radius of a semi-ellipsoid of pressures"
        }
        Quantity::Resultant if is_circle => {
            "force on the whole circle of the contact along the axis, positive in compression"
        }
        Quantity::PeakPressure => "largest pressure, positive in compression, per area of the undeformed path",
        Quantity::Pressure { .. } => {
            "pressure at a contact coordinate, positive in compression, per area of the undeformed path"
        }
        Quantity::PeakPlace => "contact coordinate of the largest pressure",
        Quantity::HalfWidth => "half of what lies between the ends of the contact",
        Quantity::SecondMomentWidth => "2 √(∫p (s − c)² ds / ∫p ds) about the centre of pressure c",
        Quantity::Centre => "centre of pressure c = ∫p s ds / ∫p ds",
        Quantity::Begin(_) => "contact coordinate at which the contact begins",
        Quantity::End(_) => "contact coordinate at which the contact ends",
        Quantity::Resultant if pair.symmetric => {
            "force on both halves of the contact along the load line, positive in compression"
        }
        Quantity::Resultant => "force on the contact along the load line, positive in compression",
        Quantity::Moment => "moment of the pressures about s = 0",
        Quantity::Across => "force of one half of the contact on the second body across the load line, towards s > 0",
        Quantity::HoopStress { .. } | Quantity::PinHoopStress { .. } => "circumferential stress, positive in tension",
        Quantity::Reaction { .. } if pair.symmetric => {
            "force of the support on the half that is modelled, positive along the axis"
        }
        Quantity::Reaction { .. } => "force of the support on the body, positive along the axis",
        Quantity::Displacement(_) => "mean displacement of the side, or that of the point, positive along the axis",
        Quantity::Approach => "approach of the bodies, positive where they have come nearer",
        Quantity::Shear { .. } => "largest in-plane shear stress (σ₁ − σ₂)/2 below the contact",
        Quantity::ShearDepth { .. } => "depth of the largest shear stress below the surface",
        Quantity::VonMises { .. } => "largest von Mises stress of the body, with the stress across the plane",
    }
}

fn number(number: f64) -> String {
    if number.is_nan() { String::new() } else { number.to_string() }
}

/// Columns of the reference values of a sheet.
const VALUES: [Column<Value>; 7] = [
    ("of", |value| value.of.clone()),
    ("quantity", |value| value.quantity.clone()),
    ("unit", |value| value.unit.into()),
    ("value ± error bar", |value| quoted(value.value, value.bar)),
    ("cells", |value| value.found.name().into()),
    ("closed form", |value| value.closed_form.map_or("–".into(), |value| format!("{value:.7}"))),
    ("other codes ± error bar (confirm it to)", |value| {
        let told = |other: &Other| {
            let to = other.confirms(value.value, value.value);
            format!("{}: {} ({})", other.by, quoted(other.value, other.bar), markdown::error(to))
        };
        match &value.others[..] {
            [] => "–".into(),
            some => some.iter().map(told).collect::<Vec<_>>().join("; "),
        }
    }),
];

fn quoted(value: f64, bar: f64) -> String {
    match value.is_nan() {
        true => "without limit".into(),
        false if bar.is_nan() => format!("{}, error bar unknown", markdown::value(value)),
        false => bounded(value, bar),
    }
}

/// Name of the file of a sheet, and its text.
pub fn file(sheet: &Sheet) -> (String, String) {
    let Sheet { name, title, scene, sources, dofs, values, .. } = sheet;
    let sources = if sources.is_empty() { "none but this sheet".into() } else { sources.join("\n* ") };
    let text = format!(
        include_str!("sheet.md"),
        name = name,
        title = title,
        scene_text = scene.join("\n\n"),
        dofs = dofs,
        values_table = markdown::columns(&VALUES, values),
        sources = sources
    );
    (format!("{name}.md"), text)
}

/// The text of the sheet of a case of the library, as it was when the program was built.
pub fn of_library(name: &str) -> Option<&'static str> {
    MADE.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

/// A value with its bar.
pub fn bounded(value: f64, bar: f64) -> String {
    format!("{} ± {}", to_bound(value, bar), significant(bar, 2))
}
