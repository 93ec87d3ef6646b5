//! Physics that this code does not do is named as such, with what to use instead, wherever a file asks for it.

use contact_vv::case::Case;

use crate::scene_file::text_of;

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
fn refusal(mesh: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("mesh.msh"), mesh).expect("written");
    let rectangle = "{ rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
    let text = text_of("rigid-cosine.toml");
    assert!(text.contains(rectangle));
    let given = "{ gmsh = { file = \"mesh.msh\", group = \"4\", contact = \"1\" } }";
    let error = Case::parse(&folder.path().join("scene.toml"), &text.replace(rectangle, given)).map(|_| ());
    error.expect_err("refused").to_string()
}

#[test]
fn triangles_and_solids_of_gmsh_name_the_option_that_helps() {
    let square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    let triangle = refusal(&mesh(square, "2 1 2 1\n2 1 2 3\n"));
    for part in ["cell 2 of `4` is a triangle", "Mesh.SubdivisionAlgorithm = 1", "Mesh.RecombineAll = 1"] {
        assert!(triangle.contains(part), "`{part}` is not in: {triangle}");
    }
    // A flat one: solids with a height are refused by their first node off the plane.
    let flat = refusal(&mesh(square, "3 1 4 1\n2 1 2 3 4\n"));
    assert!(flat.contains("type 4 are solids") && flat.contains("scenes are plane: mesh the surfaces only"), "{flat}");
    let high = refusal(&mesh(&format!("{square}0 0 1\n"), "3 1 4 1\n2 1 2 3 5\n"));
    assert!(high.contains("node 5 lies at z = 1") && high.contains("scenes are plane"), "{high}");
}
