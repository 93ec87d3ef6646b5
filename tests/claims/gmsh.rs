//! Bodies from Gmsh meshes and from blocks: read exactly, refused clearly, and solved as the same bodies meshed here.

use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::case::Case;
use contact_vv::case::{notes, plausible};
use contact_vv::error::Error;
use contact_vv::mesh::Mesh;
use contact_vv::scene::{GivenMesh, Shape};

use crate::balance::{scene, solved_as_it_says as solved};
use crate::program::Folder;
use crate::scene_mistakes::assert_told;
use crate::workbench;

/// Two 4-node cells on 0 … 2 × 0 … 1, with tags neither dense nor in order.
const TWO_CELLS: &str = include_str!("../data/scenes/two-cells.msh");

/// A scene of that body, pressed on a rigid plane.
const SCENE: &str = include_str!("../data/scenes/two-cells.toml");

/// A scene beside a mesh.
fn read_as(scene: &str, mesh: &str) -> Result<Case, Error> {
    let folder = Folder::made();
    folder.with("mesh.msh", mesh);
    Case::parse(&folder.path().join("scene.toml"), scene)
}

fn read(mesh: &str) -> Result<Case, Error> {
    read_as(SCENE, mesh)
}

/// What is said of a mesh that is refused.
fn refused(mesh: &str) -> String {
    workbench::refused(read(mesh), &[""])
}

fn given(file: &Case) -> &GivenMesh {
    match &file.scene.bodies[0].shape {
        Shape::Given(mesh) => mesh,
        other => panic!("{other:?}"),
    }
}

#[test]
fn mesh_across_the_middle_is_solved_on_both_sides_of_it() {
    let shifted = TWO_CELLS.replace("\n2 0 0\n0 0 0\n1 0 0\n", "\n1 0 0\n-1 0 0\n0 0 0\n");
    let shifted = shifted.replace("\n0 1 0\n2 1 0\n1 1 0\n", "\n-1 1 0\n1 1 0\n0 1 0\n");
    workbench::refused(read(&shifted), &["does not begin on the symmetry line", "both-sides = true"]);
    let law = "y = { polynomial = { along = \"x\", coefficients = [-5, -1] } }";
    let scene = SCENE.replace("value = [0, -5]", law).replace("stretch = 2", "both-sides = true\nstretch = 1");
    // A side held in x would turn the body back.
    let scene = scene.replace("at = \"axis\"", "at = [-1, 0]");
    let (discretisation, run) = solved(&read_as(&scene, &shifted).expect("sound"));
    assert_eq!(run.solution.points.len(), 3);
    assert_relative_eq!(discretisation.interfaces[0].nodes[0].coordinate, -1.0);
    // ∫ (5 + x) and its moment over −1 … 1.
    assert_relative_eq!(run.transmitted(), 10.0, max_relative = 1e-9);
    assert_relative_eq!(run.measures().centre, 2.0 / 30.0, max_relative = 1e-6);
}

#[test]
fn tags_groups_and_sides_are_read_whatever_their_order() {
    let file = read(TWO_CELLS).expect("sound");
    let mesh = given(&file);
    assert_eq!((mesh.points.len(), mesh.cells.len()), (6, 2));
    let corners: Vec<Vec<[f64; 2]>> =
        mesh.cells.iter().map(|cell| cell.iter().map(|&node| mesh.points[node]).collect()).collect();
    assert_eq!(corners[0], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(corners[1], [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]]);
    let names: Vec<&str> = mesh.boundaries.keys().map(AsRef::as_ref).collect();
    assert_eq!(names, ["axis", "contact", "high side", "low side"]);
    // The second line of the low side is listed backwards; the body lies to the left of both all the same.
    for edge in &mesh.boundaries["contact"] {
        assert!(mesh.points[edge[0]][0] < mesh.points[edge[1]][0]);
    }
    let (_, run) = solved(&file);
    for point in &run.solution.points {
        assert_relative_eq!(point.pressure, 5.0, max_relative = 1e-9);
    }
}

#[test]
fn cells_listed_clockwise_are_turned_one_by_one_and_that_is_noted() {
    let one = ("6 3 40 5 11", "6 3 11 5 40");
    let both = TWO_CELLS.replace(one.0, one.1).replace("7 40 7 12 5", "7 40 5 12 7");
    let of = |mesh: &str| {
        let (discretisation, run) = solved(&read(mesh).expect("sound"));
        (
            run.measures().peak.pressure,
            [notes::of(&run, 0), plausible::doubts(&discretisation, &run).remove(0)].concat().join("; "),
        )
    };
    let (pressure, notes) = of(TWO_CELLS);
    assert_eq!(notes, "");
    for (mesh, turned) in [(TWO_CELLS.replace(one.0, one.1), 1), (both, 2)] {
        let (other, notes) = of(&mesh);
        assert_relative_eq!(other, pressure, max_relative = 1e-12);
        assert!(notes.contains(&format!("{turned} of 2 cells of the mesh of `body` were clockwise")), "{notes}");
    }
}

#[test]
fn every_mistake_in_a_mesh_names_its_line() {
    assert_told("two-cells", TWO_CELLS, "mesh.msh", refused);
}

#[test]
fn groups_of_an_entity_are_few_and_have_short_names() {
    let surface = "1 0 0 0 2 1 0 1 4 3 1 2 3";
    assert_eq!(TWO_CELLS.matches(surface).count(), 1);
    let of_groups = |groups: &[String]| {
        let listed = format!("1 0 0 0 2 1 0 {} {} 3 1 2 3", groups.len(), groups.join(" "));
        read(&TWO_CELLS.replace(surface, &listed)).map(|_| ())
    };
    // Where the surface is turned over its group has a sign; no number is left without its opposite.
    assert!(of_groups(&["-4".into()]).is_ok());
    let least = of_groups(&[i64::MIN.to_string()]);
    workbench::refused(least, &["no physical surface `body`", &i64::MIN.unsigned_abs().to_string()]);
    // Copies of every cell for every group would take memory by the product of both.
    let some: Vec<String> = (4..20).map(|group| group.to_string()).collect();
    assert!(of_groups(&some).is_ok());
    let many: Vec<String> = (4..30_000).map(|group| group.to_string()).collect();
    let line = 1 + TWO_CELLS[..TWO_CELLS.find(surface).expect("a place")].matches('\n').count();
    for groups in [&many[..17], &many] {
        let line = format!("mesh.msh:{line}: ");
        workbench::refused(of_groups(groups), &["entity 1 belongs to more than 16 physical groups", &line]);
    }
    for (characters, fits) in [(127, true), (128, false)] {
        let name = "é".repeat(characters);
        let mesh = TWO_CELLS.replace("1 3 \"axis\"", &format!("1 3 \"axis\"\n1 5 \"{name}\""));
        let told = read(&mesh.replace("$PhysicalNames\n4", "$PhysicalNames\n5"))
            .map(|_| ())
            .map_err(|error| error.to_string());
        assert_eq!(told.is_ok(), fits, "{told:?}");
        assert!(fits || told.is_err_and(|told| told.contains("this name has 128 characters")));
    }
}

/// The block of `two_blocks` as two blocks that meet at x = 1, one of them turned by its corners, and the same as one.
fn of_blocks(shape: &str) -> Result<Case, Error> {
    let gmsh = "{ gmsh = { file = \"mesh.msh\", group = \"body\", contact = \"low side\" } }";
    let text = SCENE.replace(gmsh, shape).replace("[0, -5]", "[0.5, -5]").replace("high side", "roof");
    Case::parse(Path::new("blocks.toml"), &text)
}

const ONE_BLOCK: &str = "{ blocks = [{ corners = [[0, 0], [2, 0], [2, 1], [0, 1]], elements = [8, 4], \
     bottom = \"contact\", top = \"roof\", left = \"axis\" }] }";

#[test]
fn chain_of_blocks_is_the_body_they_make() {
    let (_, one) = solved(&of_blocks(ONE_BLOCK).expect("sound"));
    // Cells of a block that is turned by its corners are as many and grow as asked along its own sides.
    let turned = "elements = [4, 4], left = \"contact\"";
    for (is, alike) in [
        (turned, true),
        (&turned.replace("4, 4]", "4, 5]"), false),
        (&turned.replace("4]", "4], growth = [1, 1.2]"), false),
    ] {
        let (_, two) = solved(&scene("two-blocks", &[[turned, is]]));
        let apart = one.solution.points.iter().zip(&two.solution.points).map(|(a, b)| (a.pressure - b.pressure).abs());
        assert_eq!(one.dofs == two.dofs && apart.fold(0.0, f64::max) <= 1e-8, alike, "{is}");
    }
    // Cells that grow along the side that both share.
    let along = ["4], bottom", "4], growth = [1, 1.2], bottom"];
    let (_, one) = solved(&of_blocks(&ONE_BLOCK.replace(along[0], along[1])).expect("sound"));
    let (_, two) = solved(&scene("two-blocks", &[along, ["4], left", "4], growth = [1.2, 1], left"]]));
    for (a, b) in one.solution.points.iter().zip(&two.solution.points) {
        assert!((a.pressure - b.pressure).abs() <= 1e-8 && one.dofs == two.dofs, "{a:?} {b:?}");
    }
}

#[test]
fn arcs_of_blocks_lie_on_their_circles() {
    let shape = "{ blocks = [{ corners = [[0, 0], [1, 1], [0.5, 1], [0, 0.5]], elements = [6, 3], growth = [1.0, 1.4], \
         bottom = \"contact\", arcs = { bottom = [0, 1], top = [0, 1] }, right = \"axis\" }] }";
    let text = SCENE.replace("{ gmsh = { file = \"mesh.msh\", group = \"body\", contact = \"low side\" } }", shape);
    let text = text.replace("loads = [{ traction = { at = \"high side\", value = [0, -5] } }]", "");
    let text = text.replace("gap = { uniform = 0 }\nstretch = 2", "gap = { circle = 1 }\nstretch = 0.4");
    let file = Case::parse(Path::new("arcs.toml"), &text).expect("sound");
    let mesh = Mesh::of(&file.scene, file.resolution).expect("meshed");
    for &node in mesh.bodies[0].boundaries["contact"].iter().flatten() {
        let [x, y] = mesh.points[node];
        assert_relative_eq!(x.hypot(y - 1.0), 1.0, max_relative = 1e-14);
    }
    assert_eq!(mesh.cells(), 18);
}

#[test]
fn arcs_of_blocks_turn_by_less_than_half_a_turn_whichever_way_they_lie() {
    // Half the chord of a horizontal and of a vertical side, and the circle's centre at a distance from its middle.
    let centre_of_top = |distance: f64| format!("arcs = {{ top = [1, {}] }}, ", 1.0 - distance);
    let centre_of_right = |distance: f64| format!("arcs = {{ right = [{}, 0.5] }}, ", 2.0 - distance);
    for (half, arc) in [(1.0, &centre_of_top as &dyn Fn(f64) -> String), (0.5, &centre_of_right)] {
        for (degrees, fits) in [(60.0_f64, true), (120.0, true), (170.0, true), (179.0, false), (180.0, false)] {
            let arcs = arc(half / (0.5 * degrees).to_radians().tan());
            let read = of_blocks(&ONE_BLOCK.replace("bottom = ", &(arcs.clone() + "bottom = ")));
            let told = read.map(|_| ()).map_err(|error| error.to_string());
            let turned = matches!(&told, Err(error) if error.contains("less than half a turn apart"));
            assert!(told.is_ok() == fits && turned != fits, "{arcs}{degrees}°: {told:?}");
        }
    }
}

/// A block as wide as 10 and 5 high, of two cells, with its right half on nodes of its own.
fn split(common: bool, seam: f64) -> String {
    let second = if common { [2, 3] } else { [7, 8] };
    let text = TWO_CELLS.split("$Nodes").next().expect("a head");
    let [low, high] = second;
    format!(
        "{text}$Nodes\n1 8 1 8\n2 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n{seam} 0 0\n\
         {seam} 1 0\n$EndNodes\n$Elements\n4 7 1 7\n1 1 1 2\n1 1 2\n2 {low} 5\n1 2 1 2\n3 6 {high}\n4 3 4\n1 3 1 1\n5 \
         4 1\n\
         2 1 3 2\n6 1 2 3 4\n7 {low} 5 6 {high}\n$EndElements\n"
    )
}

#[test]
fn mesh_that_does_not_hang_together_is_refused() {
    assert!(read(&split(true, 1.0)).expect("sound").solve().is_ok());
    let hanging = "{ blocks = [{ corners = [[0, 0], [2, 0], [2, 1], [0, 1]], elements = [2, 1], bottom = \"contact\", \
         left = \"axis\" }, { corners = [[0, 1], [2, 1], [2, 2], [0, 2]], elements = [3, 1], top = \"roof\" }] }";
    assert!(of_blocks(hanging).is_err(), "other elements along a common side");
    for (seam, found) in [(1.0, "two nodes stand at (1.0"), (1.001, "in several pieces")] {
        let file = read(&split(false, seam)).expect("read");
        workbench::refused(file.solve(), &[found, "scene.toml:4: ", "Coherence"]);
    }
    // A node inside a side: three cells, two of which meet the third's upper side at its middle.
    let text = TWO_CELLS.split("$Nodes").next().expect("a head");
    let hanging = format!(
        "{text}$Nodes\n1 8 1 8\n2 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n2 2 \
        0\n\
         $EndNodes\n$Elements\n4 7 1 7\n1 1 1 1\n1 1 2\n1 2 1 2\n3 8 7\n4 7 6\n1 3 1 2\n5 6 4\n6 4 1\n2 1 3 3\n7 1 2 3 \
         4\n\
         8 4 5 7 6\n9 5 3 8 7\n$EndElements\n"
    );
    workbench::refused(read(&hanging).expect("read").solve(), &["hangs inside a side of another cell at (1.0"]);
}
