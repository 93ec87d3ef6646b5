//! Every mistake in a scene file is told with its file, its line, what was found and what to do.

use contact_vv::case::Case;

use crate::scene_file::{folder, scene_alone, text_of};

/// What is spoiled in which file so that only meshing or solving it shows; the line the message must name; what it says.
const LATER: &[(&str, &str, &str, &str, &str)] = &[
    (
        "plate-on-two-supports",
        "origin = [30, 0]",
        "origin = [-29, 0]",
        "stretch = 1.0\n\n[mesh]",
        "would be a candidate of two contacts",
    ),
    (
        "cylinder-between-blocks",
        "stretch = 1.5",
        "stretch = 0.001",
        "stretch = 0.001",
        "it must hold at least one element edge",
    ),
    (
        "blocks",
        "supports = [{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\" }]",
        "supports = []",
        "name = \"upper\"",
        "is free to",
    ),
    ("blocks", "value = [0, -100]", "value = [0, 100]", "name = \"upper\"", "moves `upper` out of its contact"),
    ("blocks", "value = [0, -100]", "value = [0, 0]", "name = \"upper\"", "nothing presses `upper`"),
    (
        "cylinder-on-block",
        "stretch = 5.0",
        "stretch = 2.0",
        "stretch = 2.0",
        "the contact reaches the end of the candidate surface",
    ),
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
        "the contact reaches the end of the candidate surface",
    ),
    (
        "blocks",
        "{ at = \"right\", component = \"x\" }]\nloads = [{ traction = { at = \"far\", value = [0, -100] } }]",
        "{ at = [10, 10], component = \"y\" }]\nloads = [{ rigid-face = { at = \"far\", component = \"y\", force = -9 } }]",
        "name = \"upper\"",
        "of the rigid face `far` is fixed",
    ),
    ("whole-disc", "{ at = [0, 50], component = \"x\" }", "", "name = \"cylinder\"", "is free to slide along x"),
    ("eccentric-load", "{ at = [0, 8], component = \"x\" }", "", "name = \"block\"", "is free to slide along x"),
    ("whole-disc", "at = [0, 50]", "at = [0, 49]", "name = \"cylinder\"", "no node at"),
    (
        "whole-disc",
        "stretch = 1.5",
        "stretch = 0.8",
        "stretch = 0.8",
        "reaches the end of the candidate surface at s = -0.8",
    ),
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
    let later = folder().join("later.toml");
    for (name, was, is, anchor, found) in LATER {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}");
        let spoiled = scene_alone(&text.replacen(was, is, 1));
        let file = Case::parse(&later, &spoiled).unwrap_or_else(|error| panic!("{is}: {error}"));
        let error = file.solve().map(|_| ()).expect_err(is).to_string();
        let line = 1 + spoiled[..spoiled.find(anchor).expect("a place")].matches('\n').count();
        assert!(error.starts_with(&format!("{}:{line}: ", later.display())), "line {line}: {error}");
        assert!(error.contains(found) && error.contains("; "), "`{found}` is not in {error}");
    }
}

/// What is spoiled in which file; what stands in the line that the message must name, what it must say was found, and
/// what to do. The file, what is spoiled in it, how, and the line, finding and remedy that the message must name.
type Mistake = (&'static str, &'static str, &'static str, [&'static str; 3]);

const MISTAKES: &[Mistake] = &[
    (
        "flat-punch",
        "stretch = 1\n",
        "stretch = 1.5\n",
        ["gap = { punch = 1 }", "the punch ends before the candidates do", "shorten `stretch`"],
    ),
    (
        "rigid-cosine",
        "{ cosine = { amplitude = 0.01, wavelength = 40 } }",
        "{ even = [] }",
        ["gap = { even", "`even` has 0 coefficients", "give one to 16"],
    ),
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
        "quantity = \"pressure\"\nat = -0.5",
        "quantity = \"pressure\"\nat = -1.6",
        ["at = -1.6", "`at` is -1.6", "from -1.5 to 1.5"],
    ),
    (
        "cylinder-on-block",
        "quantity = \"second-moment-width\"",
        "quantity = \"centre\"",
        ["quantity = \"centre\"", "begins at x = 0 has no `centre`", "`both-sides = true`"],
    ),
    (
        "eccentric-load",
        "x = [-10, 10]",
        "x = [0, 10]",
        ["first = ", "does not lie on both sides of x = 0", "left and right of x = 0"],
    ),
    ("eccentric-load", "x = [-10, 10]", "x = [-9, 10]", ["stretch = 10", "ends at |s| = 9", "give at most 9"]),
    ("eccentric-load", "both-sides = true\n", "", ["first = ", "does not begin at x = 0", "give `both-sides = true`"]),
    ("cylinder-on-block", "stretch = 5.0", "strech = 5.0", ["strech = 5.0", "unknown field `strech`", "`stretch`"]),
    (
        "cylinder-on-block",
        "tolerance = 1e-6\n",
        "start = \"nested\"\n",
        ["start = \"nested\"", "unknown field `start`", "`stiffness`"],
    ),
    (
        "cylinder-on-block",
        "thickness = 1.0\n",
        "",
        ["# A long", "missing field `thickness`", "add or correct it; tests/cases/README.md"],
    ),
    ("cylinder-on-block", "young = 70e3", "young = -70e3", ["young = -70e3", "`young` is -70000", "above 0"]),
    ("cylinder-on-block", "young = 70e3", "young = nan", ["young = nan", "`young` is NaN", "above 0"]),
    ("cylinder-on-block", "young = 70e3", "young = \"70 GPa\"", ["young = \"70 GPa\"", "invalid type: string", "key"]),
    (
        "cylinder-on-block",
        "poisson = 0.33",
        "poisson = 0.5",
        ["poisson = 0.5", "`poisson` is 0.5", "above -1 and at most 0.4999"],
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
        ["gap = { sphere = 50 }", "unknown field `sphere`", "`circle`"],
    ),
    ("cylinder-on-block", "elements = 24", "elements = 0", ["elements = 0", "`elements` is 0", "8 to 32"]),
    ("cylinder-on-block", "per = 2.5", "per = 1e-7", ["elements = 24", "candidate elements", "fewer `elements`"]),
    ("cylinder-on-block", "order = 1", "order = 3", ["order = 3", "`order` is 3", "4-node"]),
    (
        "blocks",
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
        "element = \"node\"",
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
        "two-cylinders",
        "model-error = 0.0028",
        "model-error = -1",
        ["model-error = -1", "`model-error` is -1", "give a number above 0"],
    ),
    (
        "eccentric-load",
        "of = { body = \"block\", at = \"far\", component = \"y\" }\n",
        "",
        ["quantity = \"displacement\"", "a displacement without its place", "add `of = {"],
    ),
    (
        "eccentric-load",
        "of = { body = \"block\", at = \"far\", component = \"y\" }\n",
        "of = [\"block\", \"far\", \"y\"]\n",
        ["of = [", "invalid type: sequence, expected a table with its keys", "README.md"],
    ),
    (
        "eccentric-load",
        "of = { body = \"block\", at = \"far\", component = \"y\" }\n",
        "of = 2020-01-01\n",
        ["of = 2020", "invalid type: map, expected a table with its keys", "README.md"],
    ),
    (
        "eccentric-load",
        "of = { body = \"block\"",
        "of = { body = \"bloc\"",
        ["of = { body", "there is no body `bloc`", "known: `block`"],
    ),
    (
        "eccentric-load",
        "at = \"far\", component = \"y\" }\nvalue",
        "at = \"top\", component = \"y\" }\nvalue",
        ["of = { body", "there is no boundary `top`", "known: `left`, `right`, `contact`, `far`"],
    ),
    (
        "eccentric-load",
        "at = \"far\", component = \"y\" }\nvalue",
        "at = \"far\", component = \"z\" }\nvalue",
        ["of = { body", "there is no component `z`", "known: `x`, `y`"],
    ),
    (
        "eccentric-load",
        "quantity = \"centre\"\n",
        "quantity = \"centre\"\nof = { body = \"block\", at = \"far\", component = \"y\" }\n",
        ["of = { body", "only a `displacement` is that of a place", "leave `of` out"],
    ),
    (
        "eccentric-load",
        "quantity = \"centre\"\n",
        "quantity = \"centre\"\nbody = \"block\"\n",
        ["body = \"block\"\nvalue", "only `shear` and `shear-depth` are taken in one body", "leave `body` out"],
    ),
    (
        "press-fit",
        "quantity = \"pressure\"\nat = 45",
        "quantity = \"approach\"",
        ["quantity = \"approach\"", "has no `approach`", "ask for the `displacement`"],
    ),
    (
        "two-cylinders",
        "quantity = \"shear\"\nbody = \"aluminium\"",
        "quantity = \"shear\"",
        ["quantity = \"shear\"", "two elastic bodies", "one of `aluminium`, `steel`"],
    ),
    (
        "two-cylinders",
        "quantity = \"shear\"\nbody = \"aluminium\"",
        "quantity = \"shear\"\nbody = \"middle\"",
        ["body = \"middle\"", "there is no body of the contact `middle`", "known: `aluminium`, `steel`"],
    ),
    (
        "two-cylinders",
        "quantity = \"shear\"\nbody = \"aluminium\"",
        "quantity = \"shear-stress\"\nbody = \"aluminium\"",
        ["quantity = \"shear-stress\"", "there is no quantity `shear-stress`", "`shear-depth`"],
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
        ["gap = ", "cannot be used on the path", "as `arc`"],
    ),
    (
        "cylinder-in-metres",
        "centre = [0, 0.05]",
        "centre = [0.02, 0.05]",
        ["first = ", "does not touch at x = 0", "centre at x = 0"],
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
        ["gap = ", "cannot be used on the path", "a `hole` or a `pin`"],
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
        ["supports = ", "already fixed", "leave one"],
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
        ["accuracy = \"90 %\"", "`accuracy` is \"90 %\"", "between 0.0001 % and 20 %"],
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
        ["elements = 12", "`elements` cannot be used: `accuracy` chooses the mesh", "leave `elements` out"],
    ),
    (
        "cylinder-to-accuracy",
        "[mesh]\n",
        "[mesh]\norder = 2\n",
        ["order = 2", "`order` cannot be used: `accuracy` chooses the mesh", "or `accuracy`"],
    ),
    (
        "cylinder-to-accuracy",
        "[mesh]\n",
        "[mesh]\nquantity = [\"resultant\"]\n",
        ["quantity = [\"resultant\"]", "no quantity with an accuracy `resultant`", "`contact-half-width`"],
    ),
    (
        "cylinder-on-block",
        "order = 1",
        "order = 1\nquantity = [\"half-width\"]",
        ["quantity = ", "`quantity` without `accuracy`", "leave it out"],
    ),
    ("cylinder-on-block", "elements = 24\n", "", ["[mesh]", "missing field `elements`", "or an `accuracy`"]),
];

/// The same of files with several contacts.
const SEVERAL_CONTACTS: &[Mistake] = &[
    (
        "three-rings",
        "first-side = \"outer\"",
        "first-side = \"rim\"",
        ["first-side = ", "no contact can lie on a side `rim` of `middle`", "known: `outer`, `contact`"],
    ),
    (
        "three-rings",
        "first-side = \"outer\"",
        "first-side = \"start\"",
        ["first-side = ", "no contact can lie on a side `start` of `middle`", "known: `outer`, `contact`"],
    ),
    (
        "three-rings",
        "first-side = \"outer\"",
        "origin = [0, 0]\nfirst-side = \"outer\"",
        ["origin = ", "`origin` is for straight paths", "below the centre of `arc`"],
    ),
    (
        "three-rings",
        "first-side = \"outer\" ",
        "",
        [
            "first = \"middle\"",
            "the contact side of `middle` does not lie on `arc`",
            "the circle of the first body's side",
        ],
    ),
    (
        "plate-on-two-supports",
        "origin = [-30, 0]",
        "second-side = \"far\"\norigin = [-30, 0]",
        ["second-side = ", "`second-side` without `second`", "leave it out"],
    ),
    (
        "plate-on-two-supports",
        "name = \"right\"",
        "name = \"left\"",
        [
            "name = \"left\"\nfirst = \"plate\"\norigin = [30",
            "a second contact is called `left`",
            "a `name` of its own",
        ],
    ),
    ("plate-on-two-supports", "name = \"right\"", "name = \" \"", ["name = \" \"", "`name` is blank", "give it words"]),
    (
        "plate-on-two-supports",
        "origin = [30, 0]",
        "origin = [30, 1]",
        ["first = \"plate\"\norigin = [30", "does not lie at y = 1", "give its `origin`"],
    ),
    (
        "plate-on-two-supports",
        "origin = [30, 0]",
        "origin = [49.5, 0]",
        ["stretch = 1.0\n\n[mesh]", "ends at |s| = 0.5", "give at most 0.5"],
    ),
    (
        "plate-on-two-supports",
        "contact = \"left\"\nquantity",
        "quantity",
        ["quantity = ", "the check does not say which it means", "one of `left`, `right`"],
    ),
    (
        "plate-on-two-supports",
        "contact = \"left\"\nquantity",
        "contact = \"middle\"\nquantity",
        ["contact = \"middle\"", "there is no contact `middle`", "known: `left`, `right`"],
    ),
    (
        "three-rings",
        "[[check]]\nquantity = \"reaction\"",
        "[[check]]\ncontact = \"outer fit\"\nquantity = \"reaction\"",
        ["contact = \"outer fit\"\nquantity = \"reaction\"", "a reaction belongs to a support", "leave `contact` out"],
    ),
    (
        "roller-between-plates",
        "half = true }",
        "whole = true }",
        ["whole = true", "a whole disc touches on both sides of x = 0", "`both-sides = true`"],
    ),
    (
        "roller-between-plates",
        "gap = { circle = 50 }\nstretch = 1.2",
        "both-sides = true\ngap = { circle = 50 }\nstretch = 1.2",
        ["first = \"roller\"\nfirst-side", "lies on one side of s = 0, the contact on both", "leave `half` out"],
    ),
    (
        "roller-between-plates",
        "second = \"lower\"\n",
        "",
        ["name = \"lower\"", "body `lower` takes no part in the contact", "leave it out"],
    ),
    (
        "roller-between-plates",
        "first-side = \"top\"\nsecond = \"upper\"",
        "first-side = \"top\"\nsecond = \"lower\"",
        ["second = \"lower\"", "does not lie at y = 100", "`origin`"],
    ),
];

#[test]
fn every_mistake_names_file_line_finding_and_remedy() {
    for (name, was, is, wanted) in MISTAKES.iter().chain(SEVERAL_CONTACTS) {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}");
        let file = folder().join(format!("{name}.toml"));
        let spoiled = text.replacen(was, is, 1);
        let error = Case::parse(&file, &spoiled).map(|_| ()).expect_err(is).to_string();
        let [anchor, found, remedy] = wanted;
        let place = if anchor == is && !is.is_empty() { text.find(was) } else { spoiled.find(anchor) };
        let line = 1 + spoiled[..place.expect("a place")].matches('\n').count();
        assert!(error.starts_with(&format!("{}:{line}: ", file.display())), "line {line}: {error}");
        for part in [found, remedy] {
            assert!(error.contains(part), "{is}: `{part}` is not in: {error}");
        }
    }
}
