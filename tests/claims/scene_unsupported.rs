//! Physics that this code does not do is named as such, with what to use instead, wherever a file asks for it.

use std::path::PathBuf;

use contact_vv::case::Case;

use crate::scene_file::{folder, text_of};

/// What stands in a file, what a user may add or write there, the word on whose line the message points, and two parts of it.
const ASKED: &[(&str, &str, &str, [&str; 2])] = &[
    ("[contact]\n", "[contact]\nfriction = 0.3\n", "friction", ["`friction` is not supported", "CalculiX"]),
    ("[contact]\n", "[contact]\nmu = 0.3\n", "mu = ", ["no friction here", "leave it out"]),
    ("[contact]\n", "[contact]\nFriction_Coefficient = 0.3\n", "Friction_C", ["no friction here", "code_aster"]),
    ("[contact]\n", "[contact]\n\"coefficient-of-friction\" = 0.3\n", "\"coeff", ["no friction here", "CalculiX"]),
    ("[contact]\n", "[contact]\nfriction = { mu = 0.3 }\n", "friction", ["no friction here", "CalculiX"]),
    ("[contact]\n", "[contact]\ntied = true\n", "tied", ["slide and part freely", "as one body"]),
    ("[contact]\n", "[contact]\nbonded = true\n", "bonded", ["slide and part freely", "`blocks`"]),
    ("[contact]\n", "[contact]\nperiodic = true\n", "periodic", ["tied to one another as periodic", "half a period"]),
    ("[contact]\n", "[friction]\nmu = 0.3\n[contact]\n", "friction", ["no friction here", "CalculiX"]),
    ("thickness = 1.0\n", "thickness = 1.0\ndimension = 3\n", "dimension", ["scenes are plane", "`thickness`"]),
    ("thickness = 1.0\n", "thickness = 1.0\ntemperature = 80\n", "temperature", ["no temperatures", "interference"]),
    (
        "plane = \"strain\"",
        "plane = \"axisymmetric\"",
        "plane",
        ["no plane hypothesis", "not of revolution: use CalculiX"],
    ),
    ("young = 70e3\n", "young = 70e3\nexpansion = 2.3e-5\n", "expansion", ["no temperatures", "CalculiX"]),
    ("young = 70e3\n", "young = 70e3\nyield-stress = 300\n", "yield", ["linearly elastic", "CalculiX"]),
    ("young = 70e3\n", "young = 70e3\nplastic = { yield = 300 }\n", "plastic", ["linearly elastic", "code_aster"]),
    ("young = 70e3\n", "young = 70e3\nrho = 2.7e-9\n", "rho", ["no mass", "`body-force`"]),
    ("young = 70e3\n", "young = 70e3\ndensity = 2.7e-9\n", "density", ["`density` is 0.0000000027", "not mass"]),
    ("[solve]\n", "[solve]\ndynamic = true\n", "dynamic", ["scenes are static", "CalculiX"]),
    ("[solve]\n", "[solve]\nnlgeom = true\n", "nlgeom", ["are small here", "CalculiX"]),
    ("[mesh]\n", "[mesh]\ndensity = 2.7e-9\n", "density = ", ["no mass", "`body-force`"]),
    ("[mesh]\n", "[mesh]\ntriangles = true\n", "triangles", ["quadrilaterals", "Mesh.SubdivisionAlgorithm = 1"]),
    ("component = \"x\"", "component = \"z\"", "component = \"z\"", ["no component `z`", "two components"]),
    ("{ traction = { at = \"cut\"", "{ temperature = { at = \"cut\"", "temperature", ["no temperatures", "CalculiX"]),
];

#[test]
fn what_is_not_supported_is_named_with_what_to_use_instead() {
    let text = text_of("cylinder-on-block.toml");
    let file = folder().join("cylinder-on-block.toml");
    for (was, is, anchor, wanted) in ASKED {
        assert!(text.contains(was), "{was}");
        let asking = text.replacen(was, is, 1);
        let error = Case::parse(&file, &asking).map(|_| ()).expect_err(is).to_string();
        let at = asking.find(is).expect("the change") + is.find(anchor).expect("the word");
        let line = 1 + asking[..at].matches('\n').count();
        assert!(error.starts_with(&format!("{}:{line}: ", file.display())), "line {line}: {error}");
        wanted.iter().for_each(|part| assert!(error.contains(part), "{is}: `{part}` is not in: {error}"));
    }
}

/// A mesh of one cell on the unit square: its nodes, and its block of cells.
fn mesh(nodes: &str, cells: &str) -> String {
    let count = nodes.lines().count();
    let tags: String = (1..=count).map(|tag| format!("{tag}\n")).collect();
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 1\n1 0 0 0 1 0 0 1 1 0\n1 0 0 0 1 1 0 1 4 0\n\
         1 0 0 0 1 1 1 1 5 0\n$EndEntities\n$Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n{tags}{nodes}$EndNodes\n\
         $Elements\n2 2 1 2\n1 1 1 1\n1 1 2\n{cells}$EndElements\n"
    )
}

/// What a scene says of a body from that mesh.
fn refusal(name: &str, mesh: &str) -> String {
    let folder: PathBuf = std::env::temp_dir().join(format!("contact-vv-unsupported-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("mesh.msh"), mesh).expect("written");
    let rectangle = "{ rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
    let text = text_of("rigid-cosine.toml");
    assert!(text.contains(rectangle));
    let given = "{ gmsh = { file = \"mesh.msh\", group = \"4\", contact = \"1\" } }";
    let error = Case::parse(&folder.join("scene.toml"), &text.replace(rectangle, given)).map(|_| ());
    std::fs::remove_dir_all(&folder).expect("removed");
    error.expect_err(name).to_string()
}

#[test]
fn triangles_and_solids_of_gmsh_name_the_option_that_helps() {
    let square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    let triangle = refusal("triangle", &mesh(square, "2 1 2 1\n2 1 2 3\n"));
    for part in ["cell 2 of `4` is a triangle", "Mesh.SubdivisionAlgorithm = 1", "Mesh.RecombineAll = 1"] {
        assert!(triangle.contains(part), "`{part}` is not in: {triangle}");
    }
    // A flat one: solids with a height are refused by their first node off the plane.
    let flat = refusal("flat", &mesh(square, "3 1 4 1\n2 1 2 3 4\n"));
    assert!(flat.contains("type 4 are solids") && flat.contains("scenes are plane: mesh the surfaces only"), "{flat}");
    let high = refusal("high", &mesh(&format!("{square}0 0 1\n"), "3 1 4 1\n2 1 2 3 5\n"));
    assert!(high.contains("node 5 lies at z = 1") && high.contains("scenes are plane"), "{high}");
}
