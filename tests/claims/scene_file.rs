//! A user's scene file is read exactly, refused clearly, and judged by its own checks.

use std::path::{Path, PathBuf};

use approx::assert_relative_eq;
use contact_vv::case::{Run, SceneFile, Verdict};
use contact_vv::formulation::{Discretisation, Formulation};
use contact_vv::scene::library::Cylinder;
use contact_vv::scene::{Load, Profile};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenes")
}

pub fn files() -> Vec<(PathBuf, String)> {
    let entries = std::fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).expect("text"))).collect()
}

fn text_of(name: &str) -> String {
    std::fs::read_to_string(folder().join(name)).expect("text")
}

fn solved(file: &SceneFile) -> (Discretisation, Run) {
    let (discretisation, run, _) = file.solve().expect("solved");
    (discretisation, run)
}

#[test]
fn every_scene_file_passes_its_own_checks() {
    let files = files();
    assert!(files.len() >= 6, "{} files", files.len());
    for (path, text) in files {
        let file = SceneFile::parse(&path, &text).expect("sound");
        let (discretisation, run) = solved(&file);
        let checks = file.checks(&discretisation, &run).expect("judged");
        let own = checks.iter().filter(|check| check.requirement.starts_with("The file's own")).count();
        assert!(own > 0, "{} asks nothing", path.display());
        for check in checks {
            assert_eq!(check.verdict, Verdict::Pass, "{}: {} {:e}", path.display(), check.quantity, check.error);
        }
    }
}

#[test]
fn check_of_another_value_fails_and_so_does_a_run_that_does_not_converge() {
    let text = text_of("blocks.toml");
    for (was, is, failing) in [
        ("value = 4000", "value = 4001", 1),
        ("at = 3\nvalue = 100", "at = 3\nvalue = 100.001", 1),
        ("tolerance = 1e-8\n\n[[check]]", "tolerance = 1e-8\nmax-steps = 1\n\n[[check]]", 3),
    ] {
        assert_eq!(text.matches(was).count(), 1, "{was}");
        let file = SceneFile::parse(Path::new("blocks.toml"), &text.replace(was, is)).expect("sound");
        let (discretisation, run) = solved(&file);
        let checks = file.checks(&discretisation, &run).expect("judged");
        let failed = checks.iter().filter(|check| check.verdict == Verdict::Fail).count();
        assert_eq!(failed, failing, "{is}");
    }
}

#[test]
fn reaction_is_judged_with_its_sign_and_at_its_own_support() {
    let text = text_of("press-fit.toml");
    let support = "at = \"start\", component = \"x\" }\nvalue = -5081.2";
    assert_eq!(text.matches(support).count(), 1);
    for (is, verdict) in [
        (support, Verdict::Pass),
        ("at = \"start\", component = \"x\" }\nvalue = 5081.2", Verdict::Fail),
        ("at = \"end\", component = \"y\" }\nvalue = -5081.2", Verdict::Fail),
        ("at = \"end\", component = \"y\" }\nvalue = 5081.2", Verdict::Pass),
    ] {
        let file = SceneFile::parse(Path::new("press-fit.toml"), &text.replace(support, is)).expect("sound");
        let (discretisation, run) = solved(&file);
        let checks = file.checks(&discretisation, &run).expect("judged");
        let reaction = checks.iter().find(|check| check.quantity == "reaction [N]").expect("a reaction");
        assert_eq!(reaction.verdict, verdict, "{is}: {:e}", reaction.error);
    }
}

#[test]
fn scene_in_metres_is_the_librarys_cylinder() {
    let file = SceneFile::parse(Path::new("m.toml"), &text_of("cylinder-in-metres.toml")).expect("sound");
    let formulation = Formulation::verification();
    let own = Discretisation::of(Cylinder::default().scene(), file.problem.resolution).expect("meshed");
    let read = Discretisation::of(file.problem.scene.clone(), file.problem.resolution).expect("meshed");
    let [own, read] = [own, read].map(|one| Run::of(&one, &formulation).expect("solved"));
    assert_eq!(own.freedoms, read.freedoms);
    assert_relative_eq!(read.measures.peak.pressure, own.measures.peak.pressure, max_relative = 1e-9);
    assert_relative_eq!(read.measures.half_width, own.measures.half_width, max_relative = 1e-9);
    assert_relative_eq!(read.transmitted, own.transmitted, max_relative = 1e-9);
}

#[test]
fn every_unit_has_its_factor() {
    let text = text_of("blocks.toml");
    let scaled = |units: &str| {
        let file = format!("units = {units}\n{text}");
        SceneFile::parse(Path::new("u.toml"), &file).expect("sound").problem.scene
    };
    for (name, millimetres) in [("m", 1e3), ("cm", 10.0), ("mm", 1.0), ("um", 1e-3), ("in", 25.4)] {
        let scene = scaled(&format!("{{ length = \"{name}\" }}"));
        assert_relative_eq!(scene.thickness, 2.0 * millimetres, max_relative = 1e-14);
        assert_relative_eq!(scene.contact.stretch, 10.0 * millimetres, max_relative = 1e-14);
        assert_relative_eq!(scene.contact.profile.gap(0.0), 0.01 * millimetres, max_relative = 1e-14);
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
        ("{ wedge = 0.05 }", |s| 0.05 * s),
        ("{ cosine = { amplitude = 0.3, wavelength = 7 } }", |s| 0.3 * (1.0 - (std::f64::consts::TAU * s / 7.0).cos())),
        ("{ parabola = 9 }", |s| s * s / 18.0),
        ("{ circle = 9 }", |s| 9.0 - (81.0 - s * s).sqrt()),
        ("{ table = [[0, 0], [1, 0.1], [3, 0.5], [5, 2]] }", |s| if s <= 1.0 { 0.1 * s } else { 0.2 * s - 0.1 }),
    ];
    let text = text_of("rigid-cosine.toml");
    let (was, stretch) = ("{ cosine = { amplitude = 0.01, wavelength = 40 } }", "stretch = 16");
    assert!(text.contains(was) && text.contains(stretch));
    for (gap, wanted) in cases {
        for (unit, factor) in [("mm", 1.0), ("m", 1e3), ("in", 25.4)] {
            let file = text.replace(was, gap).replace(stretch, "stretch = 4");
            let file = format!("units = {{ length = \"{unit}\" }}\n{file}");
            let profile = SceneFile::parse(Path::new("p.toml"), &file).expect("sound").problem.scene.contact.profile;
            for s in [0.0, 0.3, 1.0, 2.9] {
                assert_relative_eq!(profile.gap(factor * s), factor * wanted(s), max_relative = 1e-11, epsilon = 1e-15);
            }
        }
    }
    assert!(Profile::Punch { half_width: 1.0 }.gap(1.1).is_infinite());
}

#[test]
fn pressures_are_their_laws_and_press_inwards() {
    let text = text_of("rigid-cosine.toml");
    let start = text.find("loads = ").expect("the key");
    let end = start + text[start..].find('\n').expect("a line");
    let with = |law: &str, units: &str| {
        let load = format!("loads = [{{ pressure = {{ at = \"far\", law = {law} }} }}]");
        let file = format!("{units}{}{load}{}", &text[..start], &text[end..]);
        SceneFile::parse(Path::new("law.toml"), &file).expect("sound")
    };
    let at = |file: &SceneFile, point: [f64; 2]| match &file.problem.scene.bodies[0].loads[0] {
        Load::Stress { field, .. } => (field.0)(point),
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
    assert_relative_eq!(run.transmitted, 2.0 * (40.0 * 20.0 + 0.15 * 400.0), max_relative = 1e-8);
    let (_, run) = solved(&with("{ uniform = 62.5 }", ""));
    assert_relative_eq!(run.transmitted, 2.0 * 62.5 * 20.0, max_relative = 1e-8);
}

#[test]
fn tractions_have_a_law_for_each_component_in_any_unit() {
    let text = text_of("rigid-cosine.toml");
    let start = text.find("loads = ").expect("the key");
    let end = start + text[start..].find('\n').expect("a line");
    let with = |traction: &str, units: &str| {
        let load = format!("loads = [{{ traction = {{ at = \"far\", {traction} }} }}]");
        let file = format!("{units}{}{load}{}", &text[..start], &text[end..]);
        SceneFile::parse(Path::new("law.toml"), &file)
    };
    let laws = "x = { polynomial = { along = \"x\", coefficients = [0, 2] } }, y = { uniform = -3 }";
    for (units, unit, stress) in [("", 1.0, 1.0), ("units = { length = \"cm\", stress = \"GPa\" }\n", 10.0, 1e3)] {
        let file = with(laws, units).expect("sound");
        let Load::TractionField { field, .. } = &file.problem.scene.bodies[0].loads[0] else { panic!("a field") };
        let [x, y] = (field.0)([unit * 5.0, unit * 7.0]);
        assert_relative_eq!(x, stress * 10.0, max_relative = 1e-12);
        assert_relative_eq!(y, -stress * 3.0, max_relative = 1e-12);
    }
    // One law alone is that component; the resultant is its integral, both halves.
    let series = "y = { cosine = { centre = [0, 0], coefficients = [-20, 0] } }";
    let (_, run) = solved(&with(series, "").expect("sound"));
    assert_relative_eq!(run.transmitted, 2.0 * 20.0 * 20.0, max_relative = 1e-8);
    let sloping = "y = { polynomial = { along = \"x\", coefficients = [-40, -0.3] } }";
    let (_, run) = solved(&with(sloping, "").expect("sound"));
    assert_relative_eq!(run.transmitted, 2.0 * (40.0 * 20.0 + 0.15 * 400.0), max_relative = 1e-8);
    for wrong in ["value = [0, -1], y = { uniform = 1 }", ""] {
        let error = with(wrong, "").map(|_| ()).expect_err("no value, or two").to_string();
        assert!(error.contains("no value, or two") && error.contains("give `value"), "{error}");
    }
}

/// What is spoiled in which file so that only meshing or solving it shows; the line the message must name; what it says.
const LATER: &[(&str, &str, &str, &str, &str)] = &[
    (
        "blocks",
        "supports = [{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }]",
        "supports = []",
        "name = \"upper\"",
        "is free to",
    ),
    ("blocks", "value = [0, -100]", "value = [0, 100]", "first = \"upper\"", "pulls the bodies apart"),
    ("blocks", "value = [0, -100]", "value = [0, 0]", "first = \"upper\"", "nothing presses"),
    ("cylinder-on-block", "stretch = 5.0", "stretch = 2.0", "stretch = 2.0", "contact goes on beyond the candidates"),
    (
        "cylinder-on-block",
        "{ at = \"axis\", component = \"x\" }",
        "{ at = [1, 2], component = \"x\" }",
        "name = \"cylinder\"",
        "no node at",
    ),
    // Waves touch again beyond candidates that end in a trough, where the last of them is open.
    (
        "rigid-cosine",
        "wavelength = 40 } }\nstretch = 16",
        "wavelength = 10 } }\nstretch = 5",
        "stretch = 5",
        "contact goes on beyond the candidates",
    ),
    (
        "blocks",
        "{ at = \"right\", component = \"x\" }]\nloads = [{ traction = { at = \"far\", value = [0, -100] } }]",
        "{ at = [10, 10], component = \"y\" }]\nloads = [{ rigid-face = { at = \"far\", component = \"y\", force = -9 } }]",
        "name = \"upper\"",
        "of the rigid face `far` is held",
    ),
    ("whole-disc", "{ at = [0, 50], component = \"x\" }", "", "name = \"cylinder\"", "is free to slide along x"),
    ("eccentric-load", "{ at = [0, 8], component = \"x\" }", "", "name = \"block\"", "is free to slide along x"),
    ("whole-disc", "at = [0, 50]", "at = [0, 49]", "name = \"cylinder\"", "no node at"),
    ("whole-disc", "stretch = 1.5", "stretch = 0.8", "stretch = 0.8", "beyond the candidates, which end at s = -0.8"),
    ("cylinder-on-block", "poisson = 0.33", "poisson = 0.4999", "name = \"block\"", "lock"),
    (
        "press-fit",
        "component = \"y\" }]\n\n[[body]]",
        "component = \"x\" }]\n\n[[body]]",
        "name = \"inner\"",
        "oblique",
    ),
];

#[test]
fn mistakes_that_show_only_when_solving_name_the_line_of_their_body_or_contact() {
    for (name, was, is, anchor, found) in LATER {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}");
        let spoiled = text.replacen(was, is, 1);
        let file = SceneFile::parse(Path::new("later.toml"), &spoiled).unwrap_or_else(|error| panic!("{is}: {error}"));
        let error = file.solve().map(|_| ()).expect_err(is).to_string();
        let line = 1 + spoiled[..spoiled.find(anchor).expect("a place")].matches('\n').count();
        assert!(error.starts_with(&format!("later.toml:{line}: ")), "line {line}: {error}");
        assert!(error.contains(found) && error.contains("; "), "`{found}` is not in {error}");
    }
}

/// What is spoiled in which file; what stands in the line that the message must name, what it must say was found, and what to do.
const MISTAKES: &[(&str, &str, &str, [&str; 3])] = &[
    (
        "whole-disc",
        "both-sides = true",
        "both-sides = false",
        ["whole = true", "a whole disc touches on both sides of x = 0", "add `both-sides = true` to [contact]"],
    ),
    ("whole-disc", "whole = true", "half = true", ["half = true", "touches on one side", "`whole = true`"]),
    (
        "whole-disc",
        "whole = true",
        "half = true, whole = true",
        ["half = true, whole = true", "`half` and `whole`", "leave one of them out"],
    ),
    ("whole-disc", "both-sides = true", "both-sides = 1", ["both-sides = 1", "invalid type: integer", "every key"]),
    (
        "whole-disc",
        "at = [0, 50], component",
        "at = \"axis\", component",
        ["at = \"axis\"", "no boundary `axis`: with `both-sides`", "{ at = [0, 50], component = \"x\" }"],
    ),
    ("whole-disc", "centre = [0, 50]", "centre = [1, 50]", ["first = ", "does not touch at x = 0", "centre at x = 0"]),
    (
        "whole-disc",
        "both-sides = true",
        "both-sides = true\nsymmetric = true",
        ["symmetric = true", "not half of a symmetric one", "leave `symmetric` or `both-sides` out"],
    ),
    (
        "whole-disc",
        "gap = { circle = 50 }",
        "gap = \"drawn\"\narc = { centre = [0, 50], radius = 50 }",
        ["both-sides = true", "not along an arc", "model one half"],
    ),
    (
        "whole-disc",
        "gap = { circle = 50 }",
        "gap = { table = [[0.1, 0], [2, 1]] }",
        ["gap = { table", "does not ascend from s = 0", "else below 0"],
    ),
    (
        "whole-disc",
        "gap = { circle = 50 }",
        "gap = { table = [[-1, 0], [2, 1]] }",
        ["gap = { table", "the table ends before the candidates do", "shorten `stretch`"],
    ),
    (
        "whole-disc",
        "elements = 12\nper = 1.0",
        "accuracy = \"1 %\"",
        ["accuracy = \"1 %\"", "contact that begins at x = 0", "give `elements` and `per`"],
    ),
    (
        "whole-disc",
        "quantity = \"pressure\"\nat = -0.5",
        "quantity = \"pressure\"\nat = -1.6",
        ["at = -1.6", "`at` is -1.6", "from -1.5 to 1.5"],
    ),
    (
        "cylinder-on-block",
        "quantity = \"half-width\"",
        "quantity = \"centre\"",
        ["quantity = \"centre\"", "begins at x = 0 has no `centre`", "`both-sides = true`"],
    ),
    (
        "eccentric-load",
        "x = [-10, 10]",
        "x = [0, 10]",
        ["first = ", "does not lie on both sides of x = 0", "left and right of x = 0"],
    ),
    (
        "eccentric-load",
        "x = [-10, 10]",
        "x = [-9, 10]",
        ["stretch = 10", "goes only as far as |x| = 9", "give at most 9"],
    ),
    ("eccentric-load", "both-sides = true\n", "", ["first = ", "does not begin at x = 0", "give `both-sides = true`"]),
    ("cylinder-on-block", "stretch = 5.0", "strech = 5.0", ["strech = 5.0", "unknown field `strech`", "`stretch`"]),
    (
        "cylinder-on-block",
        "thickness = 1.0\n",
        "",
        ["# A long", "missing field `thickness`", "add it; tests/scenes/README.md"],
    ),
    ("cylinder-on-block", "young = 70e3", "young = -70e3", ["young = -70e3", "`young` is -70000", "above 0"]),
    ("cylinder-on-block", "young = 70e3", "young = nan", ["young = nan", "`young` is NaN", "above 0"]),
    ("cylinder-on-block", "young = 70e3", "young = \"70 GPa\"", ["young = \"70 GPa\"", "invalid type: string", "key"]),
    (
        "cylinder-on-block",
        "poisson = 0.33",
        "poisson = 0.5",
        ["poisson = 0.5", "`poisson` is 0.5", "between -1 and 0.5"],
    ),
    (
        "cylinder-on-block",
        "plane = \"strain\"",
        "plane = \"strian\"",
        ["plane = \"strian\"", "no plane hypothesis `strian`", "`strain`, `stress`"],
    ),
    (
        "cylinder-on-block",
        "at = \"cut\"",
        "at = \"cutt\"",
        ["at = \"cutt\"", "no boundary `cutt`", "`axis`, `cut`, `contact`"],
    ),
    ("cylinder-on-block", "at = \"far\"", "at = \"top\"", ["at = \"top\"", "no boundary `top`", "`far`"]),
    (
        "cylinder-on-block",
        "\"axis\", component = \"x\"",
        "\"axis\", component = \"z\"",
        ["\"axis\", component = \"z\"", "no component `z`", "`x`, `y`"],
    ),
    (
        "cylinder-on-block",
        "second = \"block\"",
        "second = \"bloc\"",
        ["second = \"bloc\"", "no body `bloc`", "`cylinder`, `block`"],
    ),
    (
        "cylinder-on-block",
        "second = \"block\"",
        "second = \"cylinder\"",
        ["second = \"cylinder\"", "would touch itself", "leave `second` out"],
    ),
    ("cylinder-on-block", "second = \"block\"\n", "", ["name = \"block\"", "`block` takes no part", "leave it out"]),
    (
        "cylinder-on-block",
        "name = \"block\"",
        "name = \"cylinder\"",
        ["name = \"cylinder\"", "second body", "name of its own"],
    ),
    ("cylinder-on-block", "x = [0, 80]", "x = [80, 0]", ["x = [80, 0]", "no area", "[smaller, larger]"]),
    ("cylinder-on-block", "stretch = 5.0", "stretch = 0", ["stretch = 0", "`stretch` is 0", "above 0"]),
    ("cylinder-on-block", "stretch = 5.0", "stretch = 90", ["stretch = 90", "beyond `cylinder`", "give at most 35.3"]),
    (
        "cylinder-on-block",
        "gap = { circle = 50 }",
        "gap = { sphere = 50 }",
        ["gap = { sphere = 50 }", "unknown variant `sphere`", "`circle`"],
    ),
    ("cylinder-on-block", "elements = 24", "elements = 0", ["elements = 0", "`elements` is 0", "8 to 32"]),
    ("cylinder-on-block", "per = 2.5", "per = 1e-7", ["elements = 24", "candidate elements", "fewer `elements`"]),
    ("cylinder-on-block", "order = 1", "order = 3", ["order = 3", "`order` is 3", "4-node"]),
    (
        "cylinder-on-block",
        "kind = \"analytic\"",
        "kind = \"gut feeling\"",
        ["kind = \"gut feeling\"", "no kind of reference", "`measured`"],
    ),
    (
        "cylinder-in-metres",
        "stress = \"GPa\"",
        "stress = \"psi\"",
        ["stress = \"psi\"", "no unit of stress `psi`", "`GPa`"],
    ),
    (
        "cylinder-in-metres",
        "element = \"line\"",
        "element = \"mortar\"",
        ["element = \"mortar\"", "no contact element `mortar`", "`layer`"],
    ),
    ("press-fit", "at = 45\n", "", ["quantity = \"pressure\"", "without a place", "add `at`"]),
    (
        "press-fit",
        "support = { body = \"outer\", at = \"start\", component = \"x\" }\n",
        "",
        ["quantity = \"reaction\"", "a reaction without its support", "add `support = {"],
    ),
    (
        "press-fit",
        "at = \"start\", component = \"x\" }\nvalue",
        "at = \"start\", component = \"y\" }\nvalue",
        ["support = { body", "`outer` has no support at `start` along y", "known: `start` along x, `end` along y"],
    ),
    (
        "press-fit",
        "support = { body = \"outer\"",
        "support = { body = \"middle\"",
        ["support = { body", "there is no body `middle`", "known: `inner`, `outer`"],
    ),
    (
        "press-fit",
        "at = 45\n",
        "at = 45\nsupport = { body = \"outer\", at = \"start\", component = \"x\" }\n",
        ["support = { body", "only a `reaction` has a support", "leave `support` out"],
    ),
    (
        "blocks",
        "y = [-5, 0], contact = \"top\"",
        "y = [0, 5], contact = \"bottom\"",
        ["second = ", "both look down, or outwards", "let one look down"],
    ),
    ("blocks", "y = [-5, 0]", "y = [-55, -50]", ["second = ", "does not lie at y = 0", "move the bodies"]),
    ("blocks", "y = [0, 10]", "y = [-5, 5]", ["first = ", "does not lie at y = 0", "move the bodies"]),
    (
        "blocks",
        "x = [0, 10], y = [-5, 0]",
        "x = [-10, 0], y = [-5, 0]",
        ["second = ", "does not begin at x = 0", "symmetry line"],
    ),
    (
        "blocks",
        "gap = { uniform = 0.01 }",
        "gap = { hole = { radius = 10, clearance = 0.1 } }",
        ["gap = ", "does not go with the path", "as `arc`"],
    ),
    (
        "cylinder-in-metres",
        "centre = [0, 0.05]",
        "centre = [0.02, 0.05]",
        ["first = ", "does not begin at x = 0", "centre at x = 0"],
    ),
    (
        "cylinder-in-metres",
        "centre = [0, 0.05]",
        "centre = [0, 0.07]",
        ["first = ", "does not touch y = 0", "one radius above"],
    ),
    ("press-fit", "radius = 40", "radius = 4", ["first = ", "does not lie on `arc`", "circle of the first body"]),
    (
        "press-fit",
        "inner = 40, outer = 70",
        "inner = 50, outer = 70",
        ["second = ", "does not lie on `arc`", "a gap apart"],
    ),
    (
        "press-fit",
        "arc = { centre = [0, 0]",
        "arc = { centre = [0, 3]",
        ["first = ", "does not lie on `arc`", "circle"],
    ),
    (
        "press-fit",
        "gap = { uniform = -0.02 }",
        "gap = { circle = 40 }",
        ["gap = ", "does not go with the path", "or a `hole`"],
    ),
    (
        "press-fit",
        "outer = 40, sweep = 90",
        "outer = 40, sweep = 60",
        ["stretch = ", "beyond `inner`", "give at most 60"],
    ),
    (
        "press-fit",
        "at = \"start\", component = \"x\"",
        "at = 3, component = \"x\"",
        ["at = 3", "name of a boundary or a point", "README.md"],
    ),
    (
        "blocks",
        "{ at = \"right\", component = \"x\" }]",
        "{ at = \"left\", component = \"x\" }]",
        ["supports = ", "already held", "leave one"],
    ),
    (
        "cylinder-on-block",
        "traction = { at = \"cut\", value = [0, -57.5] }",
        "pressure = { at = \"cut\", law = { polynomial = { along = \"x\", coefficients = [] } } }",
        ["loads = ", "0 coefficients", "give 1 to 16"],
    ),
    (
        "rigid-cosine",
        "gap = { cosine = { amplitude = 0.01, wavelength = 40 } }",
        "gap = { table = [[0, 0], [9, 0.1]] }",
        ["gap = ", "the table ends before the candidates", "shorten `stretch`"],
    ),
    (
        "rigid-cosine",
        "gap = { cosine = { amplitude = 0.01, wavelength = 40 } }",
        "gap = { table = [[0, 0], [9, 0.1], [8, 0.2]] }",
        ["gap = ", "does not ascend", "sort its points"],
    ),
    (
        "two-cylinders",
        "contact = \"top\" } }",
        "contact = \"side\" } }",
        ["shape = { disc = { centre = [0, -30]", "no side of a disc `side`", "`top`"],
    ),
    ("two-cylinders", "centre = [0, -30]", "centre = [0, -25]", ["gap = ", "overlap by 5", "move them apart"]),
    ("two-cylinders", "pressure = 1562.80524\n", "", ["gap = ", "no reference pressure", "[reference] pressure"]),
    (
        "two-cylinders",
        "young = 70e3",
        "young = 70e3\ndensity = 100",
        ["density = 100", "`density` is 100", "from 0.05 to 20"],
    ),
    (
        "rings-from-gmsh",
        "group = \"inner\"",
        "group = \"ring\"",
        ["group = \"ring\"", "no physical surface `ring`", "known: inner, outer"],
    ),
    (
        "rings-from-gmsh",
        "file = \"meshes/rings.msh\", group = \"inner\"",
        "file = \"rings.msh\", group = \"inner\"",
        ["file = \"rings.msh\"", "cannot be read", "folder of the scene file"],
    ),
    (
        "cylinder-to-accuracy",
        "accuracy = \"0.1 %\"",
        "accuracy = \"0.1\"",
        ["accuracy = \"0.1\"", "`accuracy` is \"0.1\"", "such as \"0.1 %\""],
    ),
    (
        "cylinder-to-accuracy",
        "accuracy = \"0.1 %\"",
        "accuracy = \"90 %\"",
        ["accuracy = \"90 %\"", "`accuracy` is \"90 %\"", "between 0.001 % and 20 %"],
    ),
    (
        "cylinder-to-accuracy",
        "accuracy = \"0.1 %\"",
        "accuracy = 0.001",
        ["accuracy = 0.001", "invalid type: floating point", "README.md"],
    ),
    (
        "cylinder-to-accuracy",
        "[mesh]\n",
        "[mesh]\nelements = 12\n",
        ["elements = 12", "`accuracy` chooses the mesh, and `elements` too", "leave `elements` out"],
    ),
    (
        "cylinder-to-accuracy",
        "[mesh]\n",
        "[mesh]\norder = 2\n",
        ["order = 2", "`accuracy` chooses the mesh, and `order` too", "or `accuracy`"],
    ),
    (
        "cylinder-to-accuracy",
        "[mesh]\n",
        "[mesh]\nquantity = [\"resultant\"]\n",
        ["quantity = [\"resultant\"]", "no quantity with an accuracy `resultant`", "`half-width`"],
    ),
    (
        "cylinder-on-block",
        "order = 1",
        "order = 1\nquantity = [\"half-width\"]",
        ["quantity = ", "`quantity` without `accuracy`", "leave it out"],
    ),
    ("cylinder-on-block", "elements = 24\n", "", ["[mesh]", "missing field `elements`", "or an `accuracy`"]),
];

#[test]
fn every_mistake_names_file_line_finding_and_remedy() {
    for (name, was, is, wanted) in MISTAKES {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}");
        let file = folder().join(format!("{name}.toml"));
        let spoiled = text.replacen(was, is, 1);
        let error = SceneFile::parse(&file, &spoiled).map(|_| ()).expect_err(is).to_string();
        let [anchor, found, remedy] = wanted;
        let place = if anchor == is && !is.is_empty() { text.find(was) } else { spoiled.find(anchor) };
        let line = 1 + spoiled[..place.expect("a place")].matches('\n').count();
        assert!(error.starts_with(&format!("{}:{line}: ", file.display())), "line {line}: {error}");
        for part in [found, remedy] {
            assert!(error.contains(part), "{is}: `{part}` is not in: {error}");
        }
    }
}

#[test]
fn page_on_scene_files_is_true() {
    let page = std::fs::read_to_string(folder().join("README.md")).expect("the page");
    let example = page.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    SceneFile::parse(Path::new("README.toml"), example).expect("the example is sound");
    let accurate = page.split("```toml").nth(2).and_then(|rest| rest.split("```").next()).expect("a second example");
    let (before, after) = (example.find("[mesh]").expect("a table"), example.find("[solve]").expect("a table"));
    let file = format!("{}{accurate}\n{}", &example[..before], &example[after..]);
    let file = SceneFile::parse(Path::new("README.toml"), &file).expect("the example is sound");
    assert_eq!(file.accuracy.expect("asked").quantities.len(), 2);
    let commented = example.replace("# second", "second");
    let error = SceneFile::parse(Path::new("README.toml"), &commented).map(|_| ()).expect_err("no such body");
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
    assert_eq!(gaps.len(), 9);
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
        let coefficient = text.replace("c1, c2, c3, c4", "1e-3, 0, 0, 0").replace("[x, y]", "[0, 50]");
        let spans = coefficient.replace("[left, right]", "[0, 80]").replace("[lower, upper]", "[0, 50]");
        named.iter().fold(spans, |text, (name, value)| {
            text.replace(&format!("= {name} "), &format!("= {value} "))
                .replace(&format!("= {name},"), &format!("= {value},"))
        })
    };
    for gap in gaps {
        let arc = "stretch = 5.0\narc = { centre = [0, 50], radius = 50 }";
        let path = if gap.contains("hole") { arc } else { "stretch = 5.0" };
        let file = example.replace("gap = { circle = 50 }", &format!("gap = {}", number(&gap)));
        SceneFile::parse(Path::new("gap.toml"), &file.replace("stretch = 5.0", path))
            .unwrap_or_else(|error| panic!("{gap}: {error}"));
    }
    let block = text_of("rigid-cosine.toml");
    let supports = "supports = [{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }]";
    assert!(block.contains(supports));
    let list = rows("Supports and loads");
    assert_eq!(list.len(), 10);
    for line in list {
        let key = if line.contains("component") && !line.contains("rigid-face") { "supports" } else { "loads" };
        let start = block.find(&format!("{key} = ")).expect("the key");
        let end = start + block[start..].find('\n').expect("a line");
        let file = format!("{}{key} = [{line}]{}", &block[..start], &block[end..]);
        SceneFile::parse(Path::new("load.toml"), &file).unwrap_or_else(|error| panic!("{line}: {error}"));
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
            _ if shape.contains("gmsh") => without_mesh(onto),
            _ if shape.contains("blocks") => without_mesh(file),
            _ if shape.contains("ring") => curved,
            _ => file,
        };
        SceneFile::parse(&folder().join("shape.toml"), &file).unwrap_or_else(|error| panic!("{shape}: {error}"));
    }
}
