//! The chain holds: every module imports only the links before it, and three traits are all there are.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Modules and what each may import from the crate, besides itself.
const ALLOWED: [(&str, &[&str]); 22] = [
    ("error", &[]),
    ("named", &[]),
    ("clock", &["named"]),
    ("figure", &["error"]),
    ("markdown", &[]),
    ("scene", &["error"]),
    ("mesh", &["error", "named", "scene"]),
    ("elasticity", &["error", "scene", "mesh"]),
    ("condensation", &["error", "clock", "elasticity"]),
    ("contact", &["error", "named", "scene", "mesh", "condensation", "elasticity"]),
    ("solution", &[]),
    ("measure", &["scene", "mesh", "solution"]),
    ("algorithm", &["error", "named", "condensation", "contact", "solution", "measure"]),
    ("stability", &["error", "condensation", "contact", "algorithm", "solution"]),
    ("solve", CHAIN),
    ("accuracy", &["error", "scene", "mesh", "solution", "measure", "algorithm", "solve", "case"]),
    ("oracle", &["error", "scene"]),
    ("case", CLAIMS),
    ("study", ROOMS),
    (
        "report",
        &["error", "scene", "mesh", "solution", "measure", "solve", "oracle", "case", "study", "figure", "markdown"],
    ),
    ("cli", EVERYTHING),
    ("main", EVERYTHING),
];

const CHAIN: &[&str] = &[
    "error",
    "named",
    "clock",
    "scene",
    "mesh",
    "elasticity",
    "condensation",
    "contact",
    "solution",
    "measure",
    "algorithm",
];

const ROOMS: &[&str] = &[
    "error",
    "clock",
    "figure",
    "markdown",
    "scene",
    "mesh",
    "elasticity",
    "condensation",
    "contact",
    "solution",
    "algorithm",
    "stability",
    "solve",
    "accuracy",
    "measure",
    "oracle",
    "case",
];

const CLAIMS: &[&str] = &[
    "error",
    "clock",
    "markdown",
    "scene",
    "mesh",
    "elasticity",
    "condensation",
    "contact",
    "solution",
    "algorithm",
    "stability",
    "solve",
    "accuracy",
    "measure",
    "oracle",
];

const EVERYTHING: &[&str] = &[
    "error",
    "clock",
    "scene",
    "mesh",
    "elasticity",
    "condensation",
    "contact",
    "solution",
    "measure",
    "algorithm",
    "stability",
    "solve",
    "accuracy",
    "oracle",
    "case",
    "study",
    "figure",
    "markdown",
    "report",
    "cli",
];

/// Links whose types are the product's own: no matrix type of a library appears there.
const WITHOUT_MATRICES: [&str; 5] = ["solution", "case", "study", "report", "cli"];

/// Source text without comments, and with string literals emptied.
fn code_of(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some(next) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(hashes) = raw_string(rest) {
            let close = format!("\"{}", "#".repeat(hashes));
            let body = hashes + 2;
            rest[body..].find(&close).map_or(rest.len(), |end| body + end + close.len())
        } else if next == '"' {
            string_length(rest)
        } else if rest.starts_with("'\"'") || rest.starts_with("'\\\"'") {
            rest[1..].find('\'').map_or(rest.len(), |end| end + 2).max(3)
        } else {
            code.push(next);
            rest = &rest[next.len_utf8()..];
            continue;
        };
        rest = &rest[skipped..];
    }
    code
}

/// Number of hashes of a raw string that starts here.
fn raw_string(text: &str) -> Option<usize> {
    let inner = text.strip_prefix('r')?;
    let hashes = inner.len() - inner.trim_start_matches('#').len();
    inner[hashes..].starts_with('"').then_some(hashes)
}

fn string_length(text: &str) -> usize {
    let mut escaped = false;
    for (index, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return index + 1,
            _ => {}
        }
    }
    text.len()
}

/// Modules named after every `crate::`, groups in braces included; `own` is how the binary names the library.
fn imported(code: &str, own: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (at, _) in code.match_indices(own) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let Some(after) = code[at + own.len()..].trim_start().strip_prefix("::") else { continue };
        let after = after.trim_start();
        match after.strip_prefix('{') {
            Some(group) => found.extend(first_names(group)),
            None => found.extend(name_at(after)),
        }
    }
    found
}

/// First path segments of the entries of a group, up to its closing brace.
fn first_names(group: &str) -> Vec<String> {
    let mut names = Vec::new();
    let (mut depth, mut start) = (0, 0);
    for (index, c) in group.char_indices() {
        let ends = match c {
            '{' => {
                depth += 1;
                false
            }
            '}' if depth == 0 => true,
            '}' => {
                depth -= 1;
                false
            }
            ',' => depth == 0,
            _ => false,
        };
        if ends {
            names.extend(name_at(group[start..index].trim_start()));
            start = index + 1;
            if c == '}' {
                break;
            }
        }
    }
    names
}

fn name_at(text: &str) -> Option<String> {
    let name: String = text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    (!name.is_empty()).then_some(name)
}

/// What a module imports and may not.
fn forbidden(module: &str, code: &str) -> Vec<String> {
    let Some((_, allowed)) = ALLOWED.iter().find(|(name, _)| *name == module) else {
        return vec![format!("`{module}` has no row in the table of the chain")];
    };
    let mut names = imported(code, "crate");
    names.extend(imported(code, "contact_vv"));
    let wrong = names.into_iter().filter(|name| name != module && !allowed.contains(&name.as_str()));
    wrong.map(|name| format!("`{module}` imports `{name}`")).collect()
}

/// Rust files under src with the module each belongs to and their code.
fn sources() -> Vec<(PathBuf, String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("src can be read") {
            let path = entry.expect("an entry can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    let module = |path: &Path| {
        let first = path.strip_prefix(&root).ok().and_then(|inside| inside.components().next());
        let name = first.map(|part| part.as_os_str().to_string_lossy().into_owned()).unwrap_or_default();
        name.trim_end_matches(".rs").to_owned()
    };
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a source can be read");
        (path.clone(), module(&path), code_of(&text))
    };
    files.into_iter().map(read).collect()
}

#[test]
fn every_import_points_back_along_the_chain() {
    let sources = sources();
    assert!(sources.len() > 30, "only {} files were found", sources.len());
    let mut wrong = Vec::new();
    for (path, module, code) in sources.iter().filter(|(_, module, _)| module != "lib") {
        wrong.extend(forbidden(module, code).into_iter().map(|what| format!("{}: {what}", path.display())));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn table_allows_no_circle() {
    // Rows may only name rows above them, with `solution` known to all.
    for (index, (module, allowed)) in ALLOWED.iter().enumerate() {
        for name in *allowed {
            let at = ALLOWED.iter().position(|(row, _)| row == name);
            assert!(
                name == module || at.is_some_and(|at| at < index),
                "`{module}` may import `{name}`, which does not come before it"
            );
        }
    }
}

#[test]
fn import_check_bites() {
    for (module, snippet, wrong) in [
        ("mesh", "use crate::elasticity::element;", 1),
        ("mesh", "use crate::{scene::Scene, elasticity::{element, loads}, error::Error, contact};", 2),
        ("algorithm", "fn f(scene: &crate::scene::Scene) {}", 1),
        ("oracle", "pub use crate :: {\n    mesh,\n};", 1),
        ("solution", "use crate::contact::ContactPoint;", 1),
        ("report", "let a = crate::condensation::factor::dense(&m);", 1),
        ("report", "use contact_vv::algorithm::Settings;", 1),
        ("atlas", "", 1),
        ("mesh", "use crate::{scene::{Scene, Place}, error::Error};", 0),
        ("mesh", "use crate::mesh::block::Block; use crate::error::Error;", 0),
        ("mesh", "/// See [`x`](crate::contact::Node).\n// crate::contact\n/* crate::contact */", 0),
        ("mesh", "let text = \"crate::contact \\\" crate::contact\"; let raw = r#\"crate::contact\"#;", 0),
        ("mesh", "use other_crate::contact;", 0),
        ("case", "use crate::{algorithm::Settings, solve::Formulation};", 0),
        ("case", "use crate::figure;", 1),
        ("error", "use crate::solution::Outcome;", 1),
    ] {
        let found = forbidden(module, &code_of(snippet));
        assert_eq!(found.len(), wrong, "{module}: {snippet}: {found:?}");
    }
}

/// Words of code: identifiers and keywords in order.
fn words(code: &str) -> Vec<&str> {
    code.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| !word.is_empty()).collect()
}

fn traits(code: &str) -> Vec<String> {
    words(code).windows(2).filter(|two| two[0] == "trait").map(|two| two[1].to_owned()).collect()
}

#[test]
fn three_traits_are_all_there_are() {
    let mut all: Vec<String> = sources().iter().flat_map(|(_, _, code)| traits(code)).collect();
    all.sort();
    assert_eq!(all, ["Algorithm", "ContactElement", "Oracle"]);
    assert_eq!(traits(&code_of("/// A trait Hidden.\npub(crate) trait Shown: Copy {}")), ["Shown"]);
}

/// What code must not contain anywhere.
fn banned(code: &str) -> Vec<&'static str> {
    let tight: String = code.chars().filter(|c| !c.is_whitespace()).collect();
    let mut found: Vec<&str> =
        [".unwrap()", "todo!", "unimplemented!", "dbg!"].into_iter().filter(|b| tight.contains(b)).collect();
    found.extend(words(code).contains(&"unsafe").then_some("unsafe"));
    found
}

#[test]
fn nothing_unwraps_nothing_is_unsafe_and_nothing_is_left_to_do() {
    for (path, module, code) in sources() {
        let found = banned(&code);
        // Starting Python from a configuration of its own has no safe interface.
        let exempt = path.ends_with("oracle/cross_code/interpreter.rs") && found == ["unsafe"];
        assert!(module == "main" || found.is_empty() || exempt, "{}: {found:?}", path.display());
    }
    assert_eq!(banned(&code_of("let x = y\n    .unwrap();")), [".unwrap()"]);
    assert_eq!(banned(&code_of("unsafe { todo!() }")), ["todo!", "unsafe"]);
    assert!(banned(&code_of("x.unwrap_or(1); // todo! unsafe .unwrap()\nlet s = \"unsafe\";")).is_empty());
}

fn matrix_types(code: &str) -> Vec<&str> {
    words(code).into_iter().filter(|word| ["faer", "nalgebra"].contains(word)).collect()
}

#[test]
fn matrix_types_of_libraries_stay_inside_the_numerics() {
    for (path, module, code) in sources() {
        let found = matrix_types(&code);
        assert!(!WITHOUT_MATRICES.contains(&module.as_str()) || found.is_empty(), "{}: {found:?}", path.display());
    }
    assert_eq!(matrix_types(&code_of("use faer::Mat; // nalgebra")), ["faer"]);
}
