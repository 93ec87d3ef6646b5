//! What the referee cannot read it refuses, naming the file, what was found and the remedy: the answers of
//! tests/data/refused-answers.toml.

use std::collections::BTreeMap;

use contact_vv::case::library::{TruncatedHertz, find};
use contact_vv::checkout::root;
use contact_vv::referee::Asked;
use contact_vv::referee::units::Role;

use crate::handed::{in_units, read};
use crate::workbench::refused;

#[test]
fn what_is_unknown_is_asked_for_with_file_found_and_remedy() {
    let text = std::fs::read_to_string(root().join("tests/data/refused-answers.toml")).expect("the answers");
    let cases: BTreeMap<String, Vec<Vec<String>>> = toml::from_str(&text).expect("TOML");
    for (case, rows) in cases {
        let case = find(&case, None).expect("a case");
        for row in rows {
            let [name, text, says @ ..] = &row[..] else { panic!("{row:?}") };
            refused(read(&case, name, text, &Asked::default()), &[std::slice::from_ref(name), says].concat());
        }
    }
    let case = TruncatedHertz::default().case();
    let good = "position [mm],pressure [MPa]\n0,3\n1,2\n2,1\n";
    assert!(read(&case, "theirs.csv", good, &Asked::default()).is_ok());
    let named = Asked { columns: vec![(Role::Pressure, "cpress".into())], ..Asked::default() };
    refused(read(&case, "theirs.csv", good, &named), &["theirs.csv", "there is no column `cpress`", "--column"]);
    // What --unit names is none in place of what stands in brackets, known or not, and no remedy.
    let megapascals = in_units(&[(Role::Pressure, "MPa")]);
    for unit in ["[N/mm]", "(kN/cm^2)", "[mPa]", "/ kN / cm^2", "[torr]", "(1e3 MPa)", "[10^3*Pa] (nodal)"] {
        let read = read(&case, "theirs.csv", good.replace("[MPa]", unit), &megapascals);
        refused(read, &["theirs.csv", "the unit", "write a known one in its place"]);
    }
}
