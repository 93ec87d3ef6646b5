//! A user's scene file is read exactly, refused clearly, and judged by its own checks.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use approx::assert_relative_eq;
use contact_vv::case::{Case, Meshed, Verdict};
use contact_vv::checkout::root;
use contact_vv::cli::new::Template;
use contact_vv::scene::{Action, Load, Profile};
use contact_vv::solve::Run;
use serde_json::Value as Schema;

use crate::outputs::contact_vv;
use crate::program::Folder;
use crate::scene_mistakes::rows;
use crate::workbench::{fails, parsed, refused};

pub fn folder() -> PathBuf {
    root().join("tests/cases")
}

pub fn files() -> Vec<(PathBuf, String)> {
    let entries = std::fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).expect("text"))).collect()
}

/// A case by the name of its file.
pub fn case(name: &str) -> Case {
    Case::read(&folder().join(format!("{name}.toml"))).unwrap_or_else(|error| panic!("{error}"))
}

pub fn text_of(name: &str) -> String {
    std::fs::read_to_string(folder().join(name)).expect("text")
}

/// The scene of a file without its closed forms and its checks, which would be of another one once it is changed.
pub fn scene_alone(text: &str) -> String {
    let scene = text.split("[[check]]").next().unwrap_or(text);
    scene.lines().filter(|line| !line.starts_with("oracle = ")).map(|line| format!("{line}\n")).collect()
}

fn solved(file: &Case) -> (Meshed, Run) {
    file.solve().expect("solved")
}

#[test]
fn checks_of_another_value_sign_or_place_fail_and_so_does_a_run_that_does_not_converge() {
    for (name, row) in rows("failing") {
        let [was, is, failing] = &row[..] else { panic!("{name}: {row:?}") };
        let text = changed(&text_of(&format!("{name}.toml")), &[(was, is)]);
        assert_eq!(failures(&text).to_string(), *failing, "{name}: {is}");
    }
}

/// Checks of a file that fail.
pub fn failures(text: &str) -> usize {
    let file = parsed(text);
    let (meshed, run) = solved(&file);
    fails(&file.own(&meshed.discretisation, &run).expect("judged"))
}

#[test]
fn displacement_of_a_point_outside_its_body_is_refused_at_its_line() {
    let spoiled = text_of("eccentric-load.toml")
        .replace("of = { body = \"block\", at = \"far\"", "of = { body = \"block\", at = [3, 9]");
    let file = parsed(&spoiled);
    let (meshed, run) = solved(&file);
    let error = file.own(&meshed.discretisation, &run).map(|_| ()).expect_err("outside").to_string();
    assert!(error.starts_with("scene.toml:9: ") && error.contains("no cell around `(3, 9)`"), "{error}");
}

#[test]
fn every_unit_has_its_factor() {
    let text = text_of("blocks.toml");
    let scaled = |units: &str| {
        let file = format!("units = {units}\n{text}");
        parsed(&file).scene
    };
    for (name, millimetres) in [("m", 1e3), ("cm", 10.0), ("mm", 1.0), ("um", 1e-3), ("in", 25.4)] {
        let scene = scaled(&format!("{{ length = \"{name}\" }}"));
        assert_relative_eq!(scene.thickness, 2.0 * millimetres, max_relative = 1e-14);
        assert_relative_eq!(scene.contact().stretch, 10.0 * millimetres, max_relative = 1e-14);
        assert_relative_eq!(scene.contact().profile.gap(0.0), 0.01 * millimetres, max_relative = 1e-14);
    }
    for (name, megapascals) in [("Pa", 1e-6), ("kPa", 1e-3), ("MPa", 1.0), ("GPa", 1e3)] {
        let scene = scaled(&format!("{{ stress = \"{name}\" }}"));
        assert_relative_eq!(scene.bodies[0].material.young, 210e3 * megapascals, max_relative = 1e-14);
        assert_relative_eq!(scene.reference.pressure, 100.0 * megapascals, max_relative = 1e-14);
    }
}

#[test]
fn rigid_profiles_are_their_formulas_in_any_unit() {
    let cases = [
        (
            "{ even = [0.1, 0.02, 0.003, 0.0004] }",
            (|s: f64| 0.1 * s * s + 0.02 * s.powi(4) + 0.003 * s.powi(6) + 4e-4 * s.powi(8)) as fn(f64) -> f64,
        ),
        ("{ even = [0.1, 0, 0, 0, 0, 2e-6] }", |s| 0.1 * s * s + 2e-6 * s.powi(12)),
        ("{ wedge = 0.05 }", |s| 0.05 * s),
        ("{ cosine = { amplitude = 0.3, wavelength = 7 } }", |s| 0.3 * (1.0 - (std::f64::consts::TAU * s / 7.0).cos())),
        ("{ parabola = 9 }", |s| s * s / 18.0),
        ("{ circle = 9 }", |s| 9.0 - (81.0 - s * s).sqrt()),
        ("{ circles = [9, -12] }", |s| (9.0 - (81.0 - s * s).sqrt()) - (12.0 - (144.0 - s * s).sqrt())),
        ("{ parabola = 9, clearance = 0.02 }", |s| s * s / 18.0 + 0.02),
        ("{ table = [[0, 0], [1, 0.1], [3, 0.5], [5, 2]] }", |s| if s <= 1.0 { 0.1 * s } else { 0.2 * s - 0.1 }),
    ];
    let text = scene_alone(&text_of("rigid-cosine.toml"));
    let (was, stretch) = ("{ cosine = { amplitude = 0.01, wavelength = 40 } }", "stretch = 16");
    assert!(text.contains(was) && text.contains(stretch));
    for (gap, wanted) in cases {
        for (unit, factor) in [("mm", 1.0), ("m", 1e3), ("in", 25.4)] {
            let file = text.replace(was, gap).replace(stretch, "stretch = 4");
            let file = format!("units = {{ length = \"{unit}\" }}\n{file}");
            let pair = parsed(&file).scene.contact().clone();
            for s in [0.0, 0.3, 1.0, 2.9] {
                assert_relative_eq!(pair.gap(factor * s), factor * wanted(s), max_relative = 1e-11, epsilon = 1e-15);
            }
        }
    }
    assert!(Profile::Punch { half_width: 1.0 }.gap(1.1).is_infinite());
}

/// A text with other words in place of some that it holds.
pub fn changed(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (was, is)| {
        assert!(text.contains(was), "`{was}` is not in:\n{text}");
        text.replacen(was, is, 1)
    })
}

/// A text with another value of a key that has a line of its own.
pub fn with_key(text: &str, key: &str, value: &str) -> String {
    let start = text.find(&format!("{key} = ")).expect("the key");
    let end = start + text[start..].find('\n').expect("a line");
    format!("{}{key} = {value}{}", &text[..start], &text[end..])
}

/// The block of a file under another load.
fn loaded(load: &str) -> String {
    with_key(&text_of("rigid-cosine.toml"), "loads", &format!("[{{ {load} }}]"))
}

#[test]
fn pressures_are_their_laws_and_press_inwards() {
    let with = |law: &str, units: &str| {
        parsed(&(units.to_owned() + &loaded(&format!("pressure = {{ at = \"far\", law = {law} }}"))))
    };
    let at = |file: &Case, point: [f64; 2]| match &file.scene.bodies[0].loads[0] {
        Load::OnSide { action: Action::Stress(field), .. } => (field.0)(point),
        other => panic!("{other:?}"),
    };
    let series = "{ cosine = { centre = [3, 4], coefficients = [7, 5, 2] } }";
    let angle = 0.7_f64;
    let place = |unit: f64| [unit * (3.0 + 2.0 * angle.sin()), unit * (4.0 - 2.0 * angle.cos())];
    let wanted = 7.0 + 5.0 * angle.cos() + 2.0 * (2.0 * angle).cos();
    for (units, unit, stress) in [("", 1.0, 1.0), ("units = { length = \"cm\", stress = \"GPa\" }\n", 10.0, 1e3)] {
        let [x, y, shear] = at(&with(series, units), place(unit));
        assert_relative_eq!(x, -stress * wanted, max_relative = 1e-12);
        assert!((x - y).abs() <= 0.0 && shear.abs() <= 0.0);
        let law = "{ polynomial = { along = \"y\", coefficients = [1, 0.5, -0.25] } }";
        let [x, _, _] = at(&with(law, units), [unit * 9.0, unit * 2.0]);
        assert_relative_eq!(x, -stress * (1.0 + 0.5 * 2.0 - 0.25 * 4.0), max_relative = 1e-12);
    }
    // ∫ (40 + 0.3 x) over half the width of 20 mm, both halves.
    let file = with("{ polynomial = { along = \"x\", coefficients = [40, 0.3] } }", "");
    let (_, run) = solved(&file);
    assert_relative_eq!(run.transmitted(), 2.0 * (40.0 * 20.0 + 0.15 * 400.0), max_relative = 1e-8);
    let (_, run) = solved(&with("{ uniform = 62.5 }", ""));
    assert_relative_eq!(run.transmitted(), 2.0 * 62.5 * 20.0, max_relative = 1e-8);
}

#[test]
fn tractions_have_a_law_for_each_component_in_any_unit() {
    let with = |traction: &str, units: &str| {
        parsed(&(units.to_owned() + &loaded(&format!("traction = {{ at = \"far\", {traction} }}"))))
    };
    let laws = "x = { polynomial = { along = \"x\", coefficients = [0, 2] } }, y = { uniform = -3 }";
    for (units, unit, stress) in [("", 1.0, 1.0), ("units = { length = \"cm\", stress = \"GPa\" }\n", 10.0, 1e3)] {
        let file = with(laws, units);
        let Load::OnSide { action: Action::Field(field), .. } = &file.scene.bodies[0].loads[0] else {
            panic!("a field")
        };
        let [x, y] = (field.0)([unit * 5.0, unit * 7.0]);
        assert_relative_eq!(x, stress * 10.0, max_relative = 1e-12);
        assert_relative_eq!(y, -stress * 3.0, max_relative = 1e-12);
    }
    // One law alone is that component; the resultant is its integral, both halves.
    let series = "y = { cosine = { centre = [0, 0], coefficients = [-20, 0] } }";
    let (_, run) = solved(&with(series, ""));
    assert_relative_eq!(run.transmitted(), 2.0 * 20.0 * 20.0, max_relative = 1e-8);
    let sloping = "y = { polynomial = { along = \"x\", coefficients = [-40, -0.3] } }";
    let (_, run) = solved(&with(sloping, ""));
    assert_relative_eq!(run.transmitted(), 2.0 * (40.0 * 20.0 + 0.15 * 400.0), max_relative = 1e-8);
}

#[test]
fn forces_and_displacements_are_their_numbers_in_any_unit() {
    let loads = "[{ traction = { at = \"far\", force = [2, -3] } }, { force = { at = [4, 5], value = [6, -7] } }, \
                 { rigid-face = { at = \"right\", component = \"x\", force = 8 } }]";
    let text = with_key(&scene_alone(&text_of("rigid-cosine.toml")), "loads", loads);
    let text = with_key(&text, "supports", "[{ at = \"left\", component = \"x\", value = 0.25 }]");
    for (units, length, newtons) in [("", 1.0, 1.0), ("units = { length = \"cm\", force = \"kN\" }\n", 10.0, 1e3)] {
        let scene = parsed(&(units.to_owned() + &text)).scene;
        let body = &scene.bodies[0];
        let [
            Load::OnSide { action: Action::Total(total), .. },
            Load::Force { at, force: point },
            Load::RigidFace { force, .. },
        ] = &body.loads[..]
        else {
            panic!("{:?}", body.loads)
        };
        let forces = [total[0], total[1], point[0], point[1], *force].map(|force| force / newtons);
        assert_eq!(forces, [2.0, -3.0, 6.0, -7.0, 8.0]);
        assert_eq!([at[0], at[1], body.supports[0].value].map(|x| x / length), [4.0, 5.0, 0.25]);
    }
}

#[test]
fn every_key_of_solve_is_taken() {
    let keys = "algorithm = \"varying\"\nelement = \"layer\"\nbound = 7\nlayer-thickness = 0.3\nstiffness = 5\n\
                criterion = \"residuals\"\nincrements = 3\nmax-iterations = 9\n";
    let text = changed(&text_of("rigid-cosine.toml"), &[("[solve]\n", &format!("[solve]\n{keys}"))]);
    let case = parsed(&text);
    let found = case.formulation();
    assert_eq!([found.leeway.bound, found.layer_thickness, found.stiffness], [7.0, 0.3, 5.0]);
    assert_eq!((found.stiffness_unit.name(), found.settings.criterion.name()), ("reference", "residuals"));
    assert_eq!([found.settings.increments, found.settings.max_iterations], [3, 9]);
    assert_eq!(found.settings.tolerance, 1e-8);
    // Of the kinematic algorithm the default has another unit.
    let kinematic = parsed(&changed(
        &text_of("rigid-cosine.toml"),
        &[("[solve]\n", "[solve]\nelement = \"layer\"\nstiffness = 5\n")],
    ));
    assert_eq!(kinematic.formulation().stiffness_unit.name(), "reference");
}

#[test]
fn page_on_scene_files_is_true() {
    let page = std::fs::read_to_string(folder().join("README.md")).expect("the page");
    let example = page.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    parsed(example);
    let accurate = page.split("```toml").nth(2).and_then(|rest| rest.split("```").next()).expect("a second example");
    let (before, after) = (example.find("[mesh]").expect("a table"), example.find("[solve]").expect("a table"));
    let file = format!("{}{accurate}\n{}", &example[..before], &example[after..]);
    let file = parsed(&file);
    assert_eq!(file.accuracy.expect("asked").quantities.len(), 2);
    let commented = example.replace("# second", "second");
    let error = Case::parse(Path::new("README.toml"), &commented).map(|_| ()).expect_err("no such body");
    assert!(error.to_string().contains("no body `block`"));
    // Every row of the tables is a value that is read.
    let rows = |key: &str| -> Vec<String> {
        let table =
            page.split(&format!("## {key}")).nth(1).and_then(|rest| rest.split("\n## ").next()).expect("a table");
        let quoted =
            table.lines().filter(|line| line.starts_with('|')).flat_map(|line| line.split('`').skip(1).step_by(2));
        quoted.filter(|text| text.starts_with('{')).map(String::from).collect()
    };
    let gaps = rows("Gaps");
    assert_eq!(gaps.len(), 15, "{gaps:?}");
    let number = |text: &str| {
        let named = [
            ("R1", "20"),
            ("R2", "30"),
            ("R", "50"),
            ("D", "0.1"),
            ("l", "40"),
            ("t", "0.1"),
            ("c", "0.01"),
            ("a", "9"),
        ];
        let coefficient = text.replace("c1, c2, c3", "1e-3, 0, 0").replace("[x, y]", "[0, 50]");
        let coefficient = coefficient.replace("[R1, R2]", "[50, -60]").replace("[[c, n], ...]", "[[1e-3, 2.5]]");
        let spans = coefficient.replace("[left, right]", "[0, 80]").replace("[lower, upper]", "[0, 50]");
        named.iter().fold(spans, |text, (name, value)| {
            text.replace(&format!("= {name} "), &format!("= {value} "))
                .replace(&format!("= {name},"), &format!("= {value},"))
        })
    };
    for gap in gaps {
        let arc = "stretch = 5.0\narc = { centre = [0, 50], radius = 50 }";
        // The example draws a disc, which has a gap of its own.
        let said = if gap.contains("bodies") { "" } else { "gap-only = true\n" };
        let path = format!("{said}{}", if gap.contains("hole") { arc } else { "stretch = 5.0" });
        // A pin is measured on the hole.
        let hole = "ring = { centre = [0, 50], inner = 50.01, outer = 90, sweep = 180, contact = \"inner\" }";
        let (file, path) = match gap.contains("pin") {
            true => (
                example
                    .replace("disc = { centre = [0, 50], radius = 50 }", hole)
                    .replace("\"axis\"", "\"start\"")
                    .replace("\"cut\"", "\"outer\""),
                path.replace("stretch = 5.0", "stretch = 5.0\narc = { centre = [0, 50], radius = 50.01 }"),
            ),
            false => (example.to_string(), path),
        };
        let file = file.replace("gap = { circle = 50 }", &format!("gap = {}", number(&gap)));
        parsed(&file.replace("stretch = 5.0", &path));
    }
    let block = text_of("rigid-cosine.toml");
    let supports = "supports = [{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }]";
    assert!(block.contains(supports));
    let list = rows("Supports and loads");
    assert_eq!(list.len(), 14);
    for line in list {
        let key = if line.contains("component") && !line.contains("rigid-face") { "supports" } else { "loads" };
        parsed(&with_key(&block, key, &format!("[{line}]")));
    }
    for shape in rows("Shapes and their boundaries") {
        let key = "shape = { disc = { centre = [0, 50], radius = 50 } }";
        let file = example.replace(key, &format!("shape = {}", number(&shape)));
        // The boundaries of other shapes have other names.
        let file = file.replace("supports = [{ at = \"axis\", component = \"x\" }]", "");
        let file = file.replace("loads = [{ traction = { at = \"cut\", value = [0, -57.5] } }]", "");
        let arc = "stretch = 5.0\narc = { centre = [0, 50], radius = 30 }\ngap = { uniform = 0.1 }";
        let curved = file.replace("gap = { circle = 50 }", "").replace("stretch = 5.0", arc);
        let drawn = file.replace("gap = { circle = 50 }", "gap = \"drawn\"");
        let drawn = drawn.replace("centre = [0, 50], radius = 50 }", "centre = [0, 0], radius = 40.02 }");
        let onto = drawn.replace("stretch = 5.0", "stretch = 5.0\narc = { centre = [0, 0], radius = 40.02 }");
        let without_mesh = |file: String| -> String {
            let of_mesh = |line: &&str| ["elements = ", "per = ", "growth = "].iter().any(|key| line.starts_with(key));
            file.split_inclusive('\n').filter(|line| !of_mesh(line)).collect()
        };
        let file = match shape {
            _ if shape.contains(".msh") => without_mesh(onto),
            _ if shape.contains("blocks") => without_mesh(file),
            _ if shape.contains("ring") => curved,
            _ => file,
        };
        Case::parse(&folder().join("shape.toml"), &file).unwrap_or_else(|error| panic!("{shape}: {error}"));
    }
}

/// Those that are scenes.
fn scenes() -> impl Iterator<Item = Template> {
    Template::ALL.into_iter().filter(|template| *template != Template::Mesh)
}

/// Names of all keys of a file.
fn keys(value: &toml::Value, found: &mut BTreeSet<String>) {
    match value {
        toml::Value::Table(table) => {
            for (key, value) in table {
                found.insert(key.clone());
                keys(value, found);
            }
        }
        toml::Value::Array(all) => all.iter().for_each(|one| keys(one, found)),
        _ => {}
    }
}

/// Words of the comments that stand in backquotes.
fn explained(text: &str) -> BTreeSet<String> {
    let comments = text.lines().filter_map(|line| line.split_once('#')).map(|(_, comment)| comment);
    let words = |comment: &str| comment.split('`').skip(1).step_by(2).map(String::from).collect::<Vec<_>>();
    comments.flat_map(words).collect()
}

#[test]
fn comments_of_a_new_scene_explain_every_key_it_uses() {
    for template in scenes() {
        let (mut used, text) = (BTreeSet::new(), template.text());
        keys(&toml::from_str(text).expect("TOML"), &mut used);
        let explained = explained(text);
        // The coordinates of a rectangle are those of the plane.
        let silent = used.iter().filter(|key| !explained.contains(*key) && !["x", "y"].contains(&key.as_str()));
        let silent: Vec<_> = silent.collect();
        assert!(silent.is_empty(), "{}: {silent:?}", template.name());
    }
}

#[test]
fn every_new_scene_is_solved_and_its_checks_hold() {
    let folder = Folder::made();
    // The mesh of a scene file, once more, since a package holds no file of another one.
    let of_cases = std::fs::read_to_string(crate::scene_file::folder().join("meshes/rings-coarse.msh"));
    assert_eq!(Template::Mesh.text(), of_cases.expect("a mesh"));
    folder.with("rings.msh", Template::Mesh.text());
    for template in scenes() {
        let name = template.name();
        let (_, text, _) = contact_vv(&["new", name]);
        assert!(text.starts_with("#:schema ./scene.schema.json\n"), "{name}");
        assert!(text.trim_end().ends_with(template.text().trim_end()), "{name}");
        let file = folder.with(&format!("{name}.toml"), text);
        let case = Case::read(file.as_ref()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (meshed, run) = case.solve().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(run.solution.converged(), "{name}: {}", run.solution.outcome);
        let judged = case.judge(&meshed, &run).expect("judged");
        // Other claims export cylinders and rollers, whose sheets take seconds each.
        if !["roller", "profile"].contains(&name) && !name.contains("cylinder") {
            let (exported, _, error) = contact_vv(&["export", &file, &folder.at(&format!("out/{name}"))]);
            assert!(exported, "{name}: {error}");
        }
        assert!(!case.checks.is_empty() && judged.iter().all(|one| one.verdict == Verdict::Pass), "{name}: {judged:?}");
    }
}

#[test]
fn shapes_of_new_scenes_are_listed_where_none_is_named() {
    let (sound, list, _) = contact_vv(&["new"]);
    let listed = |template: &Template| {
        list.lines().any(|line| line.starts_with(template.name()) && line.ends_with(template.title()))
    };
    assert!(sound && Template::ALL.iter().all(listed), "{list}");
}

/// Whether a value is what a schema says, as far as schemas of scenes go.
fn fits(schema: &Schema, value: &toml::Value) -> bool {
    if let Some(any) = schema["anyOf"].as_array() {
        return any.iter().any(|one| fits(one, value));
    }
    match (schema["type"].as_str().expect("a type"), value) {
        ("number", toml::Value::Integer(_) | toml::Value::Float(_)) => true,
        ("integer", toml::Value::Integer(number)) => *number >= 0,
        ("string", toml::Value::String(_)) | ("boolean", toml::Value::Boolean(_)) => true,
        ("array", toml::Value::Array(all)) => all.iter().all(|one| fits(&schema["items"], one)),
        ("object", toml::Value::Table(table)) => {
            let known = |(key, value): (&String, &toml::Value)| {
                schema["properties"].get(key).is_some_and(|one| fits(one, value))
            };
            let needed = schema["required"].as_array().into_iter().flatten();
            let most = schema["maxProperties"].as_u64().unwrap_or(u64::MAX);
            table.iter().all(known)
                && needed.into_iter().all(|key| table.contains_key(key.as_str().expect("a name")))
                && table.len() as u64 <= most
        }
        _ => false,
    }
}

#[test]
fn schema_of_scenes_takes_every_scene_file_and_refuses_wrong_keys_and_values() {
    let (_, text, _) = contact_vv(&["schema", "scene"]);
    let schema: Schema = serde_json::from_str(&text).expect("JSON");
    let read = |text: &str| toml::from_str::<toml::Value>(text).expect("TOML");
    let texts = files().into_iter().map(|(_, text)| text);
    let all: Vec<String> = texts.chain(scenes().map(|template| template.text().into())).collect();
    assert!(all.len() > 30 && all.iter().all(|text| fits(&schema, &read(text))));
    let sound = &text_of("two-cylinders.toml");
    for (from, to) in [
        ("plane =", "plan ="),
        ("thickness = ", "thickness = \"a\" # "),
        ("[contact]", "[contacts]"),
        ("gap = ", "gap = 1 # "),
    ] {
        let spoiled = sound.replacen(from, to, 1);
        assert!(spoiled != *sound && !fits(&schema, &read(&spoiled)), "{to}");
    }
}

#[test]
fn a_scene_file_in_latin_1_or_in_the_utf_16_of_windows_is_read_and_one_in_binary_is_none() {
    let (folder, text) = (Folder::made(), format!("# Körper\n{}", text_of("flat-punch.toml")));
    let latin: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    let wide: Vec<u8> = "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    for bytes in [latin, wide] {
        folder.with("mine.toml", bytes);
        let case = Case::read(&folder.path().join("mine.toml")).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(case.scene.bodies.len(), parsed(&text).scene.bodies.len());
    }
    folder.with("mine.toml", b"\x7fELF\x02\xff");
    refused(Case::read(&folder.path().join("mine.toml")), &["mine.toml", "it is no text", "scene file"]);
}
