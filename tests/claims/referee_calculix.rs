//! Fields of CalculiX: displacements are judged as those of a grid, from a `.frd` alone or beside the `.dat` of an
//! exported deck.

use contact_vv::case::library::find;
use contact_vv::case::{Case, Verdict};
use contact_vv::error::Error;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, Verdicts, read};
use contact_vv::solve::{Discretisation, Run};

use crate::foreign::{cell_of, fixed, forces, record};
use crate::handed::{self, in_units};
use crate::program::Folder;
use crate::workbench::{refused, truth};

/// Mesh, displacements and contact results as CalculiX writes them.
pub fn frd(discretisation: &Discretisation, run: &Run) -> String {
    let mesh = &discretisation.mesh;
    let mut text = String::from("    1C\n    2C                             9                                     1\n");
    text.extend(mesh.points.iter().enumerate().map(|(k, [x, y])| record(k + 1, &fixed([*x, *y, 0.0]))));
    text += " -3\n    3C                             9                                     1\n";
    let numbered = |cell: usize| mesh.cell(cell).iter().map(|node| node + 1).collect::<Vec<_>>();
    text.extend((0..mesh.cells()).map(|cell| cell_of(cell + 1, 10, &numbered(cell))));
    // A gap element.
    text += &cell_of(mesh.cells() + 1, 11, &[1, 2]);
    text += " -3\n  100CL  101 1.00000E+00\n -4  DISP        4    1\n -5  D1          1    2    1    0\n \
        -5  D2          1    2    2    0\n";
    text += " -5  D3          1    2    3    0\n -5  ALL         1    2    0    0    1ALL\n";
    let moved = discretisation.displacement_under(run.share(), &run.solution);
    text.extend(moved.iter().enumerate().map(|(k, [u, v])| record(k + 1, &fixed([*u, *v, 0.0]))));
    text += " -3\n -4  CONTACT     2    1\n -5  COPEN       1    4    1    1\n -5  CPRESS      1    4    1    2\n";
    let pressed = mesh.bodies[0].candidates.iter().zip(run.solution.points_of(0));
    text.extend(pressed.map(|(node, point)| record(node.node + 1, &fixed([point.gap, point.pressure]))));
    text + " -3\n 9999\n"
}

const PRESSED: [(Role, &str); 2] = [(Role::Position, "mm"), (Role::Pressure, "MPa")];
const MOVED: [(Role, &str); 3] = [(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Displacement, "mm")];

fn judged(case: &Case, answer: Answer) -> Verdicts {
    handed::judged(truth(&case.name), answer)
}

/// What of equilibrium and energy is judged, and whether it is met.
fn whole(found: &Verdicts) -> Vec<bool> {
    let all = found.ruled.iter().flat_map(|ruled| &ruled.judged);
    let of = all.filter(|one| {
        ["stresses against", "strain energy"].iter().any(|part| one.check.quantity.to_string().contains(part))
    });
    of.map(|one| one.verdict == Verdict::Pass).collect()
}

fn field(case: &Case, text: &str, asked: &Asked) -> Result<Answer, Error> {
    handed::read(case, "theirs.frd", text, asked)
}

#[test]
fn displacements_of_a_frd_are_judged_where_their_unit_is_named() {
    let case = find("truncated-hertz", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let text = frd(&meshed.discretisation, &run);
    let found = judged(&case, field(&case, &text, &in_units(&MOVED)).expect("read"));
    assert_eq!(whole(&found), [true; 4]);
    assert!(found.met());
    let without = judged(&case, field(&case, &text, &in_units(&PRESSED)).expect("read"));
    assert!(whole(&without).is_empty());
    let micrometres = field(&case, &text, &in_units(&[MOVED[0], MOVED[1], (Role::Displacement, "um")])).expect("read");
    assert!(whole(&judged(&case, micrometres)).contains(&false));
}

#[test]
fn cells_of_a_rigid_body_in_a_frd_move_no_node_of_the_scene() {
    let case = find("truncated-hertz", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let mut text = frd(&meshed.discretisation, &run);
    // A cell at rest below the contact, whose upper side is the rigid plane.
    let (first, cell) = (meshed.discretisation.mesh.points.len() + 1, meshed.discretisation.mesh.cells() + 2);
    let mut into = |before: &str, rows: String| text = text.replacen(before, &(rows + before), 1);
    let corners = [[-20.0, -40.0], [20.0, -40.0], [20.0, 0.0], [-20.0, 0.0]];
    let places = corners.iter().enumerate().map(|(k, [x, y])| record(first + k, &fixed([*x, *y, 0.0])));
    into(" -3\n    3C", places.collect());
    into(" -3\n  100CL", cell_of(cell, 9, &[0, 1, 2, 3].map(|k| first + k)));
    let still = (0..4).map(|k| record(first + k, &fixed([0.0; 3])));
    into(" -3\n -4  CONTACT", still.collect());
    let answer = field(&case, &text, &in_units(&MOVED)).expect("read");
    assert_eq!(answer.field.as_ref().map(|field| field.cells.len()), Some(cell - 1));
    assert_eq!(whole(&judged(&case, answer)), [true; 4]);
}

#[test]
fn a_block_of_displacements_that_is_cut_or_lacks_a_node_is_refused() {
    let case = find("truncated-hertz", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let text = frd(&meshed.discretisation, &run);
    let begin = text.find(" -4  DISP").expect("a block");
    let lines: Vec<&str> = text[begin..].lines().collect();
    let contact = text.find(" -3\n -4  CONTACT").expect("a block");
    for (spoiled, says) in [
        (text.replace(&format!("{}\n", lines[7]), ""), "has no node 3"),
        (text.replace(lines[7], &lines[7].replace("E-", "X-")), "holds no finite numbers"),
        (text[..begin].to_owned() + &text[contact + 4..] + &text[begin..contact], "its block DISP has no end"),
    ] {
        refused(field(&case, &spoiled, &in_units(&MOVED)), &["theirs.frd", says]);
    }
}

#[test]
fn the_frd_beside_the_dat_of_an_exported_deck_tells_its_displacements() {
    let case = find("cylinder", None).expect("a case");
    let (meshed, run) = case.solve().expect("solved");
    let folder = Folder::made();
    for (name, text, _) in contact_vv::cli::export::files(&case, false).expect("exported") {
        folder.with(&name, text);
    }
    let deck = folder.read("cylinder.inp");
    let first = deck.lines().skip_while(|line| !line.starts_with("*NSET, NSET=GAPS_CONTACT")).nth(1).expect("a set");
    let first: usize = first.split(',').next().and_then(|word| word.trim().parse().ok()).expect("a node");
    let rows = run.solution.points_of(0).iter().enumerate();
    let table = rows.map(|(k, point)| (first + 2 * k, 0.0 - point.pressure * point.weight));
    let table = forces("GAPS_CONTACT", "0.1000000E+01", table);
    let dat = folder.path().join("cylinder.dat");
    std::fs::write(&dat, table).expect("written");
    let alone = read::read(&dat, &case, &Asked::default()).expect("read");
    assert!(alone.field.is_none());
    std::fs::write(dat.with_extension("frd"), frd(&meshed.discretisation, &run)).expect("written");
    let both = read::read(&dat, &case, &Asked::default()).expect("read");
    assert!(both.read.iter().any(|how| how.contains(".frd of the same name")));
    let found = judged(&case, both);
    assert_eq!(whole(&found), [true; 4]);
    assert!(found.met());
    // Those of another time are of another state, as those that stand last may be.
    let fields = frd(&meshed.discretisation, &run);
    let (begin, end) = (fields.find(" -4  DISP").expect("a block"), fields.find(" -4  CONTACT").expect("its end"));
    let later = fields[begin..end].replace("E-", "E+");
    let later = fields.replace(" 9999\n", &format!("  100CL  102 2.00000E+00\n{later} 9999\n"));
    for (text, is_there) in [(later, true), (fields.replace("1.00000E+00\n -4", "2.00000E+00\n -4"), false)] {
        std::fs::write(dat.with_extension("frd"), text).expect("written");
        let of_its_time = read::read(&dat, &case, &Asked { time: Some(1.0), ..Asked::default() }).expect("read");
        assert_eq!(of_its_time.field.is_some(), is_there);
        assert!(judged(&case, of_its_time).met());
    }
    let by_step = read::read(&dat, &case, &Asked { step: Some(1), ..Asked::default() });
    refused(by_step, &["tells the times of its states, and not the steps", "by --time: time 1"]);
    // Of a deck that is not ours, units are asked for.
    std::fs::write(dat.with_extension("inp"), deck.replacen(": mm, N, MPa.", "", 1)).expect("written");
    let answer = read::read(&dat, &case, &in_units(&[(Role::X, "mm"), (Role::Force, "N")])).expect("read");
    assert!(answer.field.is_none());
}
