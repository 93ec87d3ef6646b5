//! What the referee cannot read it refuses, naming the file, what was found and the remedy.

use contact_vv::case::library::{TruncatedHertz, find};
use contact_vv::referee::Asked;
use contact_vv::referee::units::Role;

use crate::handed::{in_units, read};
use crate::workbench::refused;

#[test]
fn what_is_unknown_is_asked_for_with_file_found_and_remedy() {
    let case = TruncatedHertz::default().case();
    let arc = find("pin-rod", None).expect("a case");
    let good = "position [mm],pressure [MPa]\n0,3\n1,2\n2,1\n";
    assert!(read(&case, "theirs.csv", good, &Asked::default()).is_ok());
    let plain = Asked::default();
    let named = Asked { columns: vec![(Role::Pressure, "cpress".into())], ..Asked::default() };
    let megapascals = in_units(&[(Role::Pressure, "MPa")]);
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
        (
            &case,
            "position [mm],position [mm],pressure [MPa]\n0,0,3\n1,2,2\n2,4,1\n",
            &plain,
            ["more than one column is called position", "name it by --column"],
        ),
        (
            &case,
            "position [mm],pressure [MPa],pressure [MPa]\n0,3,4\n1,2,3\n2,1,2\n",
            &plain,
            ["more than one column is called pressure", "name it by --column"],
        ),
        // Metres called mm.
        (
            &arc,
            "x [mm],y [mm],pressure [MPa]\n0,-0.01,3\n0.001,-0.00995,2\n0.002,-0.0098,1\n",
            &plain,
            ["mm off the side of contact", "in the coordinates of the scene"],
        ),
        (&case, "position [mm],pressure [torr]\n0,3\n", &plain, ["the unit `torr`", "MPa, N/mm2, kPa, Pa, GPa"]),
        // What --unit names is none in place of what stands in brackets, and no remedy.
        (
            &case,
            "position [mm],pressure [N/mm]\n0,3\n",
            &megapascals,
            ["the unit `N/mm`", "write a known one in its place"],
        ),
        (&case, good, &named, ["there is no column `cpress`", "--column"]),
        (
            &case,
            "position [mm],pressure [MPa]\n0,3\n1,nan\n2,1\n",
            &plain,
            ["theirs.csv:3", "`nan`, which is no number"],
        ),
        (&case, "position [mm],pressure [MPa]\n0,3\n1\n", &plain, ["theirs.csv:3", "the file is cut"]),
        (&case, "position[mm] pressure[MPa]\n0 0 3\n1 1 2\n2 2 1\n", &plain, ["theirs.csv:2", "numbers of its rows"]),
        // The first rows are no second line of the head.
        (
            &case,
            "x [mm],p [MPa]\n0 mm,3 MPa\n1 mm,2 MPa\n2,1\n3,0\n4,0\n",
            &plain,
            ["theirs.csv:2", "`0 mm`, which is no number"],
        ),
        (&case, "x [mm],p [MPa]\nx0,n/a\n1,2\n2,1\n3,0\n", &plain, ["theirs.csv:2", "`x0`, which is no number"]),
        (
            &case,
            "  X[mm]   P[MPa]\n 0.0E+00-3.0E+00\n 1.0E+00 2.0E+00\n 2.0E+00 1.0E+00\n 3.0E+00 0.0E+00\n",
            &plain,
            ["theirs.csv:2", "1 cells, but the head names 2"],
        ),
        // UTF-16 without its mark.
        (&case, "x\x00,\x00p\x00\n\x0000\x00,\x0003\x00\n\x00", &plain, ["it is no text", "UTF-8"]),
        (&case, " \n\n", &plain, ["it holds nothing", "position [mm],pressure [MPa]"]),
        (&case, "position [mm],pressure [MPa]\n", &plain, ["no line behind its head", "the file is cut"]),
        (&case, "position [mm],pressure [MPa]\n0,3\n1,2\n", &plain, ["2 points were handed in", "needs 3"]),
        (
            &case,
            "position [mm],pressure [MPa]\n0,3\n1,2\n1,1\n",
            &plain,
            ["two points lie at one place, 1", "each once"],
        ),
        (
            &case,
            "position [mm],pressure [MPa]\n0,0\n1,0\n2,0\n",
            &plain,
            ["nothing presses: all 3 values of contact", "under the load of the scene"],
        ),
        (&case, "position [deg],pressure [MPa]\n0,3\n1,2\n", &plain, ["along a straight line", "mm, m or um"]),
        (&arc, good, &plain, ["along an arc", "deg or rad"]),
        (&arc, "x [mm],pressure [MPa]\n0,3\n", &plain, ["no column `y`", "position [deg]"]),
    ] {
        refused(read(case, "theirs.csv", text, asked), &[&["theirs.csv"], &parts[..]].concat());
    }
}

#[test]
fn documents_that_are_none_are_refused_with_key_and_remedy() {
    let case = find("cylinder", None).expect("a case");
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
        refused(read(&case, "theirs.json", text, &Asked::default()), &[part]);
    }
}

#[test]
fn files_that_are_no_answer_are_named_with_what_to_hand_in_instead() {
    let case = TruncatedHertz::default().case();
    let print = |of: &str| {
        format!(
            " contact stress (slave {of},press,tang1,tang2) for all contact elements and time 0.1000000E+01\n\n         1  9.9E+01  0.0E+00  0.0E+00\n         \
             2  9.8E+01  0.0E+00  0.0E+00\n"
        )
    };
    let job = "SUMMARY OF JOB INFORMATION\n  STEP  INC  ATT  ITRS\n     1    1    1    4\n     1    2    1    4\n";
    let printed = " displacements (vx,vy,vz) for set NALL and time  0.1000000E+01\n\n 1 0. 0. 0.\n 2 0. 0. 0.\n";
    let log = "*****\n\nCalculiX Version 2.21, Copyright(C) 1998-2023 Guido Dhondt\n\n iteration 1\n";
    let listing =
        "   Abaqus 2023\n  The Abaqus Software is a product of:\n  NODE FOOT-  CPRESS\n 1  99.9  0.\n 2  99.8  0.\n";
    for (name, text, parts) in [
        ("a.dat", print("node"), ["slave nodes that are pressed, and no places", "*CONTACT FILE"]),
        ("a.dat", print("element+face"), ["faces of slave elements", "hand in the .frd"]),
        ("a.dat", printed.into(), ["*NODE PRINT", "*CONTACT FILE"]),
        ("a.dat", listing.into(), ["listing (.dat) of a run of Abaqus", "COORD and CPRESS"]),
        ("a.sta", job.into(), ["increments and iterations, and no pressures", ".frd of CalculiX"]),
        ("a.txt", job.into(), ["increments and iterations, and no pressures", ".frd of CalculiX"]),
        ("a.txt", log.into(), ["the log of a run", ".frd of CalculiX"]),
        ("a.cvg", String::new(), ["increments and iterations", ".frd of CalculiX"]),
        ("a.odb", String::new(), ["database of Abaqus", "(.rpt)"]),
        ("a.rst", String::new(), ["database of Ansys", ".txt"]),
        ("a.pvtu", String::new(), ["no unstructured grid in one file", "ParaView"]),
        ("a.xlsx", String::new(), ["a workbook", ".csv"]),
        ("a.INP", String::new(), ["the input of a run", ".frd"]),
        ("a.what", String::new(), ["its ending `what` names no format", ".csv"]),
    ] {
        refused(read(&case, name, text, &Asked::default()), &[&[name], &parts[..]].concat());
    }
    // What a table says in a comment does not make it a listing.
    let table = "# CalculiX Version 2.21\nposition [mm],sigma [MPa]\n0,3\n1,2\n";
    refused(read(&case, "a.csv", table, &Asked::default()), &["no column is called `pressure`"]);
}
