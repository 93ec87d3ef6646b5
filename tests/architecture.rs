//! The chain holds: every module imports only the links before it, no files of a folder import one another in a circle,
//! and three traits are all there are.

#[path = "architecture/imports.rs"]
mod imports;
#[path = "architecture/source.rs"]
mod source;

use std::collections::BTreeSet;

use contact_vv::study::Room;

use May::{AllAboveBut, Only};
use imports::{Tree, circles, from_root};
use source::Source;

/// What a module may import from the crate besides itself.
enum May {
    /// These, which come before it.
    Only(&'static [&'static str]),
    /// All that come before it, but for these.
    AllAboveBut(&'static [&'static str]),
}

/// Modules in the order in which they are read, and what each may import from the crate besides itself.
const ALLOWED: [(&str, May); 26] = [
    ("error", Only(&[])),
    ("named", Only(&[])),
    ("clock", Only(&["named"])),
    ("checkout", Only(&[])),
    ("drawing", Only(&[])),
    ("markdown", Only(&[])),
    ("uncertainty", Only(&[])),
    ("scene", Only(&["error"])),
    ("mesh", Only(&["error", "named", "scene"])),
    ("elasticity", Only(&["error", "scene", "mesh"])),
    ("condensation", Only(&["error", "clock", "mesh", "elasticity"])),
    ("contact", Only(&["error", "named", "scene", "mesh", "elasticity", "condensation"])),
    ("solution", Only(&["error"])),
    ("measure", Only(&["scene", "mesh", "solution", "uncertainty"])),
    ("algorithm", Only(&["error", "named", "condensation", "contact", "solution", "measure"])),
    ("stability", Only(&["error", "condensation", "contact", "solution", "measure", "algorithm"])),
    ("solve", AllAboveBut(&["checkout", "drawing", "markdown", "stability"])),
    ("accuracy", Only(&["error", "named", "scene", "mesh", "solution", "measure", "algorithm", "solve"])),
    ("oracle", Only(&["error", "named", "checkout", "scene", "measure", "uncertainty"])),
    ("case", AllAboveBut(&["named", "drawing"])),
    ("referee", AllAboveBut(&[])),
    ("study", AllAboveBut(&[])),
    (
        "report",
        AllAboveBut(&["named", "clock", "elasticity", "condensation", "contact", "algorithm", "stability", "accuracy"]),
    ),
    ("cli", AllAboveBut(&[])),
    ("main", AllAboveBut(&[])),
    ("live", Only(&["error", "checkout", "oracle", "study", "cli"])),
];

/// Links whose types are the product's own: no matrix type of a library appears there.
const WITHOUT_MATRICES: [&str; 5] = ["solution", "case", "study", "report", "cli"];

/// Other modules that a file imports from.
fn imported(source: &Source) -> BTreeSet<String> {
    let all = source.all_paths().filter_map(|path| from_root(&source.module, path)?.into_iter().next());
    all.filter(|name| name != source.link()).collect()
}

/// What a module imports and may not.
fn forbidden(source: &Source) -> Vec<String> {
    let module = source.link();
    let Some(row) = ALLOWED.iter().position(|(name, _)| *name == module) else {
        return vec![format!("`{module}` has no row in the table of the chain")];
    };
    // Whatever a row names, only what comes before it may be imported: the table allows no circle.
    let is_above = |name: &str| ALLOWED[..row].iter().any(|(above, _)| *above == name);
    let may = |name: &str| match &ALLOWED[row].1 {
        Only(allowed) => allowed.contains(&name),
        AllAboveBut(refused) => !refused.contains(&name),
    };
    let wrong = imported(source).into_iter().filter(|name| !is_above(name) || !may(name));
    wrong.map(|name| format!("`{module}` imports `{name}`")).collect()
}

#[test]
fn every_import_points_back_along_the_chain() {
    let sources = source::all();
    assert!(sources.len() > 30, "only {} files were found", sources.len());
    let modules = sources.iter().filter(|source| !source.file.ends_with("lib.rs"));
    let wrong = modules.flat_map(|source| forbidden(source).into_iter().map(|what| format!("{}: {what}", source.file)));
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn import_check_bites() {
    for (module, snippet, wrong) in [
        ("mesh", "use crate::elasticity::element;", 1),
        ("mesh", "use crate::{scene::Scene, elasticity::{element, loads}, error::Error, contact};", 2),
        ("algorithm", "fn f(scene: &crate::scene::Scene) {}", 1),
        ("solution", "use crate::contact::ContactPoint;", 1),
        ("report", "fn f() { let a = crate::condensation::factor::dense(&m); }", 1),
        ("report", "fn f() { println!(\"{}\", crate::algorithm::CAP); }", 1),
        ("report", "#[derive(Args)] struct A { #[arg(value_parser = crate::algorithm::parsed)] cap: u32 }", 1),
        ("mesh", "use super::contact::Element;", 1),
        ("mesh", "fn f() { super::contact::node() }", 1),
        ("atlas", "", 1),
        ("mesh", "use crate::{scene::{Scene, Place}, error::Error};", 0),
        ("mesh", "use crate::mesh::block::Block; use crate::error::Error; use self::spacing;", 0),
        ("mesh", "/// See [`x`](crate::contact::Element).\n// crate::contact\n/* crate::contact */ struct A;", 0),
        ("mesh", "fn f() { let text = \"crate::contact \\\" crate::contact\"; let raw = r#\"crate::contact\"#; }", 0),
        ("mesh", "pub(crate) fn f() {} pub(super) fn g() {}", 0),
        ("case", "use crate::{algorithm::Settings, solve::Formulation};", 0),
    ] {
        let found = forbidden(&Source::new(&format!("{module}.rs"), snippet));
        assert_eq!(found.len(), wrong, "{module}: {snippet}: {found:?}");
    }
}

/// What a study imports from another; what is shared lies beside the studies. What stands in the folder of no study is
/// shared.
fn of_another_study(source: &Source, studies: &BTreeSet<String>) -> Vec<String> {
    let own = source.module.get(1).filter(|own| source.link() == "study" && studies.contains(*own));
    let Some(own) = own else { return Vec::new() };
    let paths = source.all_paths().filter_map(|path| from_root(&source.module, path));
    let others =
        paths.filter(|path| path.first().is_some_and(|link| link == "study")).filter_map(|path| path.get(1).cloned());
    let others = others.filter(|other| other != own && studies.contains(other));
    others.map(|other| format!("{}: `{own}` imports `{other}`", source.file)).collect()
}

#[test]
fn no_study_imports_another() {
    let studies: BTreeSet<String> = Room::ALL.iter().map(|room| room.name.to_owned()).collect();
    assert!(studies.len() > 9, "{studies:?}");
    let found: Vec<String> = source::all().iter().flat_map(|source| of_another_study(source, &studies)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    for (snippet, wrong) in [
        ("use crate::study::limits::Numbers;", 1),
        ("fn f() { crate::study::limits::plan() }", 1),
        ("use super::super::limits::plan;", 1),
        ("use crate::study::atlas::run::Numbers; use crate::study::drawn::label; use super::plane::Plane;", 0),
    ] {
        let source = Source::new("study/atlas/judge.rs", snippet);
        assert_eq!(of_another_study(&source, &studies).len(), wrong, "{snippet}");
    }
}

#[test]
fn files_of_a_folder_import_one_another_in_no_circle() {
    let graph = Tree::new(source::all()).graph();
    let found: Vec<String> = circles(&graph).iter().map(|circle| circle.join(", ")).collect();
    assert!(found.is_empty(), "these files import one another:\n{}", found.join("\n"));
}

#[test]
fn check_of_circles_bites() {
    let block = ("mesh/block.rs", "use crate::mesh::Edge;");
    let guide = ("mesh/mod.rs", "pub mod block;\npub mod edge;\npub use edge::Edge;");
    let edge = ("mesh/edge.rs", "pub struct Edge;");
    for (files, wanted) in [
        (vec![guide, block, edge], ""),
        (vec![guide, block, ("mesh/edge.rs", "use super::block::Block;")], "mesh/block.rs mesh/edge.rs"),
        (
            vec![guide, block, ("mesh/edge.rs", "use crate::mesh::block; fn f() { block::f() }")],
            "mesh/block.rs mesh/edge.rs",
        ),
        (vec![guide, block, ("mesh/edge.rs", "fn f() { g!(crate::mesh::block::f()) }")], "mesh/block.rs mesh/edge.rs"),
        (
            vec![("mesh/mod.rs", "pub mod block; use block::Block; pub struct Edge;"), block],
            "mesh/block.rs mesh/mod.rs",
        ),
        (vec![("mesh/mod.rs", "pub use block::Block; pub struct Edge(Block);"), block], "mesh/block.rs mesh/mod.rs"),
        (vec![("mesh/mod.rs", "mod block; struct Edge; fn f() { block::f() }"), block], "mesh/block.rs mesh/mod.rs"),
        (vec![("mesh/mod.rs", "pub use block::Block; pub struct Edge;"), block], ""),
        (vec![("mesh/mod.rs", "mod block; fn f(block: Block) { block.f() } struct Edge;"), block], ""),
        (vec![guide, block, ("mesh/edge.rs", "use std::mesh::block; pub(super) struct Edge; // super::block")], ""),
        (
            vec![
                ("mesh/mod.rs", "mod deep; fn f() { deep::f() } pub struct Edge;"),
                ("mesh/deep/mod.rs", "mod one; pub use one::f;"),
                ("mesh/deep/one.rs", "use super::super::Edge;"),
            ],
            "mesh/deep/one.rs mesh/mod.rs",
        ),
    ] {
        let sources: Vec<Source> = files.iter().map(|(file, text)| Source::new(file, text)).collect();
        let graph = Tree::new(&sources).graph();
        let found: Vec<String> = circles(&graph).iter().map(|circle| circle.join(" ")).collect();
        assert_eq!(found.join("; "), wanted, "{files:?}");
    }
}

#[test]
fn three_traits_are_all_there_are() {
    let mut all: Vec<&str> = source::all().iter().flat_map(|source| &source.traits).map(String::as_str).collect();
    all.sort();
    assert_eq!(all, ["Algorithm", "Oracle", "Study"]);
    let text = "/// A trait Hidden.\npub(crate) trait Shown: Copy {}\nfn f() { trait Inside {} }";
    assert_eq!(Source::new("mesh.rs", text).traits, ["Shown", "Inside"]);
}

fn matrix_types(source: &Source) -> Vec<&str> {
    source.words.iter().map(String::as_str).filter(|word| ["faer", "nalgebra"].contains(word)).collect()
}

#[test]
fn matrix_types_of_libraries_stay_inside_the_numerics() {
    for source in source::all().iter().filter(|source| WITHOUT_MATRICES.contains(&source.link())) {
        let found = matrix_types(source);
        assert!(found.is_empty(), "{}: {found:?}", source.file);
    }
    assert_eq!(matrix_types(&Source::new("mesh.rs", "use faer::Mat; // nalgebra")), ["faer"]);
}

/// Lines that a room may have; raised only by a commit that says what for.
const BUDGETS: [(&str, usize); 9] = [
    ("solver", 24_713),
    ("drawing", 2_758),
    ("case", 8_358),
    ("oracle", 1_450),
    ("study", 15_183),
    ("referee", 8_313),
    ("report", 3_190),
    ("cli", 4_717),
    ("live", 421),
];

#[test]
fn rooms_keep_to_their_budgets() {
    for (room, most) in BUDGETS {
        let inside = format!("{room}/");
        let own = source::all().iter().filter(|source| source.file.starts_with(&inside));
        let lines: usize = own.map(|source| source.lines).sum();
        assert!(lines > most / 2 && lines <= most, "{room} has {lines} lines of {most}");
    }
}

/// Files and types that the studies may have together.
const STUDIES: [usize; 2] = [57, 120];

#[test]
fn studies_keep_to_their_files_and_types() {
    let own: Vec<&Source> = source::all().iter().filter(|source| source.link() == "study").collect();
    let words = own.iter().flat_map(|source| &source.words);
    let types = words.filter(|word| ["struct", "enum", "trait"].contains(&word.as_str())).count();
    let [files, most] = STUDIES;
    assert!(own.len() > files / 2 && own.len() <= files, "the studies have {} files of {files}", own.len());
    assert!(types > most / 2 && types <= most, "the studies define {types} types of {most}");
}
