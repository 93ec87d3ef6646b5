//! What the referee cannot read it refuses, naming the file, what was found and the remedy.

use std::path::Path;

use contact_vv::case::Case;
use contact_vv::case::library::{TruncatedHertz, find};
use contact_vv::referee::units::Role;
use contact_vv::referee::{Asked, read};

#[test]
fn what_is_unknown_is_asked_for_with_file_found_and_remedy() {
    let case = TruncatedHertz::default().case();
    let arc = find("pin-rod", None).expect("a case");
    let refused = |case: &Case, text: &str, asked: &Asked| {
        let read = read::parse(Path::new("theirs.csv"), text.as_bytes(), case, asked);
        read.map(|_| ()).expect_err(text).to_string()
    };
    let good = "position [mm],pressure [MPa]\n0,3\n1,2\n2,1\n";
    assert!(read::parse(Path::new("theirs.csv"), good.as_bytes(), &case, &Asked::default()).is_ok());
    let plain = Asked::default();
    let named = Asked { columns: vec![(Role::Pressure, "cpress".into())], ..Asked::default() };
    for (case, text, asked, parts) in [
        (&case, "0,3\n1,2\n2,1\n", &plain, ["its first line holds no names", "position [mm],pressure [MPa]"]),
        (
            &case,
            "where,what\n0,3\n",
            &plain,
            ["no column is called `position` or `x`, but `where`, `what`", "--column"],
        ),
        (
            &case,
            "position [mm],sigma [MPa]\n0,3\n",
            &plain,
            ["no column is called `pressure` or `force`", "`sigma [MPa]`"],
        ),
        (
            &case,
            "position,pressure [MPa]\n0,3\n",
            &plain,
            ["the column `position` has no unit", "--unit position=UNIT"],
        ),
        (&case, "position [mm],pressure [torr]\n0,3\n", &plain, ["the unit `torr`", "MPa, N/mm2, kPa, Pa, GPa"]),
        (&case, good, &named, ["there is no column `cpress`", "--column"]),
        (
            &case,
            "position [mm],pressure [MPa]\n0,3\n1,nan\n2,1\n",
            &plain,
            ["theirs.csv:3", "`nan`, which is no number"],
        ),
        (&case, "position [mm],pressure [MPa]\n0,3\n1\n", &plain, ["theirs.csv:3", "the file is cut"]),
        (&case, "position [mm],pressure [MPa]\n", &plain, ["no line behind its head", "the file is cut"]),
        (&case, "position [mm],pressure [MPa]\n0,3\n1,2\n", &plain, ["2 points were handed in", "needs 3"]),
        (
            &case,
            "position [mm],pressure [MPa]\n0,3\n1,2\n1,1\n",
            &plain,
            ["two points lie at one place, 1", "each once"],
        ),
        (&case, "position [deg],pressure [MPa]\n0,3\n1,2\n", &plain, ["along a straight line", "mm, m or um"]),
        (&arc, good, &plain, ["along an arc", "deg or rad"]),
        (&arc, "x [mm],pressure [MPa]\n0,3\n", &plain, ["no column `y`", "position [deg]"]),
    ] {
        let error = refused(case, text, asked);
        assert!(parts.iter().all(|part| error.contains(part)) && error.contains("theirs.csv"), "{text}: {error}");
    }
}

#[test]
fn documents_that_are_none_are_refused_with_key_and_remedy() {
    let case = find("cylinder", None).expect("a case");
    let refused = |text: &str| {
        let read = read::parse(Path::new("theirs.json"), text.as_bytes(), &case, &Asked::default());
        read.map(|_| ()).expect_err(text).to_string()
    };
    let units = r#""units":{"position":"mm","pressure":"MPa"}"#;
    for (text, part) in [
        ("{".to_owned(), "schema answer"),
        (format!("{{{units}}}"), "missing field `contacts`"),
        (format!("{{{units},\"contacts\":[]}}"), "there is none"),
        (
            format!("{{{units},\"contacts\":[{{\"position\":[0,1,2],\"pressure\":[1,2]}}]}}"),
            "it has 2 entries, `position` 3",
        ),
        (format!("{{{units},\"contacts\":[{{\"position\":[0,1,2],\"pressure\":[1,NaN,2]}}]}}"), "theirs.json:1"),
        (format!("{{{units},\"contacts\":[{{\"position\":[0,1,2],\"force\":[1,2,2]}}]}}"), "add `units.force`"),
        (format!("{{{units},\"contacts\":[{{\"position\":[0,1,2]}}]}}"), "neither pressures nor forces"),
        (format!("{{\"case\":\"patch\",{units},\"contacts\":[]}}"), "the answer is of `patch`"),
        (
            format!("{{{units},\"contacts\":[{{\"name\":\"x\",\"position\":[0,1,2],\"pressure\":[1,2,3]}}]}}"),
            "there is no contact `x`",
        ),
        (
            format!("{{{units},\"contacts\":[{{\"order\":3,\"position\":[0,1,2],\"pressure\":[1,2,3]}}]}}"),
            "give 1, 2, or 4 to 8",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(part), "{text}: {error}");
    }
}
