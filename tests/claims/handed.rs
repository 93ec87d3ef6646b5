//! An answer that is handed in: a table, its units, and how it is read, refused and judged.

use std::path::Path;

use contact_vv::case::{Case, Verdict};
use contact_vv::error::Error;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, Truth, Verdicts, read, verdicts};
use serde_json::{Value, json};

/// Columns of a table of pressures.
pub const PRESSURES: &str = "position [mm],pressure [MPa]";

/// A table of two columns.
pub fn table<const N: usize>(columns: &str, rows: impl IntoIterator<Item = [f64; N]>) -> String {
    let line = |row: [f64; N]| row.map(|value| format!("{value:e}")).join(",") + "\n";
    let rows: String = rows.into_iter().map(line).collect();
    format!("{columns}\n{rows}")
}

/// A document of a contact, in our units.
pub fn document(contact: Value) -> String {
    let units = json!({ "position": "mm", "pressure": "MPa", "area": "mm2", "gap": "mm", "force": "N" });
    json!({ "units": units, "contacts": [contact] }).to_string()
}

/// As a file is read whose units are named.
pub fn in_units(all: &[(Role, &str)]) -> Asked {
    Asked { units: all.iter().map(|(role, unit)| (*role, (*unit).to_owned())).collect(), ..Asked::default() }
}

/// As grids with displacements are read, in our units.
pub fn moved() -> Asked {
    in_units(&[(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Gap, "mm"), (Role::Displacement, "mm")])
}

/// The answer to a case in a file of a name.
pub fn read(case: &Case, name: &str, text: impl AsRef<[u8]>, asked: &Asked) -> Result<Answer, Error> {
    read::parse(Path::new(name), text.as_ref(), case, asked)
}

/// The verdicts on an answer.
pub fn judged(truth: &Truth, answer: Answer) -> Verdicts {
    verdicts(truth, answer, ENGINEERING).expect("judged")
}

/// Those on a file of a name.
pub fn judged_as(truth: &Truth, name: &str, text: &str, asked: &Asked) -> Verdicts {
    judged(truth, read(&truth.case, name, text, asked).expect("read"))
}

/// Those on a table of columns.
pub fn judged_rows<const N: usize>(truth: &Truth, columns: &str, rows: impl IntoIterator<Item = [f64; N]>) -> Verdicts {
    judged_as(truth, "theirs.csv", &table(columns, rows), &Asked::default())
}

/// Names of what is not met.
pub fn failed(found: &Verdicts) -> Vec<String> {
    let all = found.ruled.iter().flat_map(|ruled| &ruled.judged);
    all.filter(|one| one.verdict == Verdict::Fail).map(|one| one.check.quantity.to_string()).collect()
}
