//! A scene file written from nothing: each one printed is understood, explained, and solved.

use std::collections::BTreeSet;

use contact_vv::case::{Case, Verdict};
use contact_vv::cli::new::Template;
use serde_json::Value as Schema;

use crate::outputs::contact_vv;
use crate::scene_file::{files, text_of};

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
    let folder = tempfile::tempdir().expect("a folder");
    // The mesh of a scene file, once more, since a package holds no file of another one.
    let of_cases = std::fs::read_to_string(crate::scene_file::folder().join("meshes/rings-coarse.msh"));
    assert_eq!(Template::Mesh.text(), of_cases.expect("a mesh"));
    std::fs::write(folder.path().join("rings.msh"), Template::Mesh.text()).expect("written");
    for template in scenes() {
        let name = template.name();
        let (_, text, _) = contact_vv(&["new", name]);
        assert!(text.starts_with("#:schema ./scene.schema.json\n"), "{name}");
        assert!(text.trim_end().ends_with(template.text().trim_end()), "{name}");
        let file = folder.path().join(name).with_extension("toml");
        std::fs::write(&file, text).expect("written");
        let case = Case::read(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (meshed, run) = case.solve().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(run.solution.converged(), "{name}: {}", run.solution.outcome);
        let judged = case.judge(&meshed, &run).expect("judged");
        let (exported, _, error) = contact_vv(&[
            "export",
            &file.display().to_string(),
            &folder.path().join("out").join(name).display().to_string(),
        ]);
        assert!(exported, "{name}: {error}");
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
