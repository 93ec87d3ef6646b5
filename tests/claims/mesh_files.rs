//! Meshes of other programs: one mesh is one body in every format, 9-node cells are what they are, and a file that is
//! spoiled is refused.

use std::fmt::Display;

use approx::assert_relative_eq;
use contact_vv::accuracy::{self, Asked};
use contact_vv::case::Case;
use contact_vv::error::Error;
use contact_vv::mesh::Order;
use contact_vv::scene::{Curve, Shape};
use contact_vv::solve::{Discretisation, Formulation};

use crate::balance::solved_as_it_says;
use crate::program::Folder;
use crate::scene_fuzz::mutated;
use crate::scene_mistakes::assert_told;
use crate::workbench::{self, noise, parsed};

/// A body of 3 × 2 cells on 0 … 2 × 0 … 1, none of them a rectangle, every other one listed clockwise, with sparse
/// numbers.
pub struct Body {
    pub nodes: Vec<(u64, [f64; 2])>,
    pub cells: Vec<(u64, Vec<u64>)>,
    /// Sides by name: the nodes of their edges, ends first.
    pub sides: Vec<(&'static str, Vec<Vec<u64>>)>,
}

impl Body {
    /// Of cells of 4, 8 or 9 nodes.
    fn of(count: usize) -> Self {
        let step = if count == 4 { 1 } else { 2 };
        let [columns, rows] = [3 * step, 2 * step];
        let corner = |i: usize, j: usize| {
            let inside = i > 0 && i < 3 && j == 1;
            let moved = if inside { [0.11, if i == 1 { 0.07 } else { -0.09 }] } else { [0.0, 0.0] };
            // Edges of the sole are not of one length.
            [2.0 * [0.0, 0.3, 0.62, 1.0][i] + moved[0], 0.5 * j as f64 + moved[1]]
        };
        let mean = |points: &[[f64; 2]]| {
            [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64)
        };
        let place = |i: usize, j: usize| {
            let around = |n: usize| if n.is_multiple_of(step) { vec![n / step] } else { vec![n / step, n / step + 1] };
            let corners = around(i).into_iter().flat_map(|i| around(j).into_iter().map(move |j| corner(i, j)));
            mean(&corners.collect::<Vec<_>>())
        };
        let tag = |i: usize, j: usize| 5 + 17 * ((3 * i + 11 * j) % 29) as u64 + 1000 * (j as u64 % 3);
        let all = (0..=columns).flat_map(|i| (0..=rows).map(move |j| (i, j)));
        let is_node = |(i, j): &(usize, usize)| count == 9 || step == 1 || i % 2 == 0 || j % 2 == 0;
        let nodes = all.filter(is_node).map(|(i, j)| (tag(i, j), place(i, j))).collect();
        let cell = |(i, j): (usize, usize)| {
            let at = |[x, y]: [usize; 2]| tag(step * i + x, step * j + y);
            let natural = if step == 1 {
                vec![[0, 0], [1, 0], [1, 1], [0, 1]]
            } else {
                vec![[0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1], [1, 1]]
            };
            let listed: Vec<usize> = if (i + j) % 2 == 0 { (0..9).collect() } else { vec![0, 3, 2, 1, 7, 6, 5, 4, 8] };
            listed.into_iter().filter(|k| *k < count).map(|k| at(natural[k])).collect::<Vec<u64>>()
        };
        let cells = (0..3).flat_map(|i| (0..2).map(move |j| (i, j)));
        let cells = cells.enumerate().map(|(k, at)| (90 + 7 * k as u64, cell(at))).collect();
        let along = |edges: usize, at: &dyn Fn(usize) -> u64| -> Vec<Vec<u64>> {
            let ends = (0..edges).map(|k| [step * k, step * (k + 1)]);
            ends.map(|[from, to]| if step == 1 { vec![at(from), at(to)] } else { vec![at(from), at(to), at(from + 1)] })
                .collect()
        };
        let sides = vec![
            ("sole", along(3, &|k| tag(k, 0))),
            ("roof", along(3, &|k| tag(k, rows))),
            ("axis", along(2, &|k| tag(0, k))),
        ];
        Self { nodes, cells, sides }
    }

    fn types(&self) -> [i32; 2] {
        match self.cells[0].1.len() {
            4 => [1, 3],
            8 => [8, 16],
            _ => [8, 10],
        }
    }
}

/// How the numbers of a Gmsh file are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coding {
    Text,
    Little,
    Big,
}

struct Written {
    coding: Coding,
    bytes: Vec<u8>,
}

impl Written {
    fn line(&mut self, text: impl Display) {
        self.bytes.extend(format!("{text}\n").bytes());
    }

    fn number<const N: usize>(&mut self, text: impl Display, little: [u8; N]) {
        let mut own = little;
        match self.coding {
            Coding::Text => self.bytes.extend(format!("{text} ").bytes()),
            Coding::Little => self.bytes.extend(own),
            Coding::Big => {
                own.reverse();
                self.bytes.extend(own);
            }
        }
    }

    fn ints(&mut self, numbers: &[i32]) {
        numbers.iter().for_each(|number| self.number(number, number.to_le_bytes()));
    }

    fn sizes(&mut self, numbers: &[u64]) {
        numbers.iter().for_each(|number| self.number(number, number.to_le_bytes()));
    }

    fn reals(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.number(format!("{number:e}"), number.to_le_bytes()));
    }
}

/// The body as Gmsh writes it, by its reference manual.
pub fn msh(body: &Body, version: &str, coding: Coding) -> Vec<u8> {
    let (version, more) = version.split_once(' ').unwrap_or((version, ""));
    let mut file = Written { coding, bytes: vec![] };
    file.line(format!("$MeshFormat\n{version} {} 8", i32::from(coding != Coding::Text)));
    if coding != Coding::Text {
        file.ints(&[1]);
        file.line("");
    }
    file.line(format!("$EndMeshFormat\n$PhysicalNames\n{}", body.sides.len() + 1));
    body.sides.iter().enumerate().for_each(|(k, (name, _))| file.line(format!("1 {} \"{name}\"", k + 1)));
    file.line("2 9 \"body\"\n$EndPhysicalNames");
    let [line, cell] = body.types();
    let edges = body.sides.iter().map(|(_, edges)| edges.len()).sum::<usize>();
    let all = (edges + body.cells.len()) as u64;
    if version == "4.1" {
        let sides = body.sides.len() as u64;
        file.line("$Entities");
        file.sizes(&[0, sides, 1, 0]);
        // Entities that are cut into parts go by other numbers.
        let shift = if more == "in parts" { 10 } else { 0 };
        for shift in std::collections::BTreeSet::from([0, shift]) {
            if shift > 0 {
                file.line("\n$EndEntities\n$PartitionedEntities");
                file.sizes(&[2, 1]);
                file.ints(&[77, 2]);
                file.sizes(&[0, sides, 1, 0]);
            }
            for (dimension, tag, group) in (0..body.sides.len() as i32).map(|k| (1, k + 1, k + 1)).chain([(2, 4, 9)]) {
                file.ints(&[tag + shift]);
                if shift > 0 {
                    file.ints(&[dimension, tag]);
                    file.sizes(&[2]);
                    file.ints(&[1, 2]);
                }
                file.reals(&[0.0, 0.0, 0.0, 2.0, 1.0, 0.0]);
                file.sizes(&[1]);
                // The sign of a group tells which way its entity runs.
                file.ints(&[if dimension == 1 { -group } else { group }]);
                file.sizes(&[1]);
                file.ints(&[tag + shift]);
            }
        }
        file.line(if shift > 0 { "\n$EndPartitionedEntities\n$Nodes" } else { "\n$EndEntities\n$Nodes" });
        file.sizes(&[2, body.nodes.len() as u64, 1, 10_000]);
        for part in body.nodes.chunks(body.nodes.len() - 2) {
            file.ints(&[2, 4, 1]);
            file.sizes(&[part.len() as u64]);
            part.iter().for_each(|(tag, _)| file.sizes(&[*tag]));
            // Each with its two parameters on the surface.
            part.iter().for_each(|(_, [x, y])| file.reals(&[*x, *y, 0.0, 0.5, 0.5]));
        }
        file.line("\n$EndNodes\n$Elements");
        file.sizes(&[sides + 1, all, 1, 10_000]);
        let mut tag = 1000;
        for (k, (_, edges)) in body.sides.iter().enumerate() {
            file.ints(&[1, k as i32 + 1 + shift, line]);
            file.sizes(&[edges.len() as u64]);
            for edge in edges {
                tag += 1;
                file.sizes(&[tag]);
                file.sizes(edge);
            }
        }
        file.ints(&[2, 4 + shift, cell]);
        file.sizes(&[body.cells.len() as u64]);
        for (tag, nodes) in &body.cells {
            file.sizes(&[*tag]);
            file.sizes(nodes);
        }
        file.line("\n$EndElements\n$NodeData\nanything\n$EndNodeData");
        return file.bytes;
    }
    let nodes = if more == "with parameters" { "ParametricNodes" } else { "Nodes" };
    file.line(format!("${nodes}\n{}", body.nodes.len()));
    for (tag, [x, y]) in &body.nodes {
        file.ints(&[*tag as i32]);
        file.reals(&[*x, *y, 0.0]);
        if nodes != "Nodes" {
            // As many parameters as the entity has dimensions, none in a volume.
            let dimension = (*tag % 4) as i32;
            file.ints(&[dimension, 1]);
            file.reals(&[0.5, 0.25][..(dimension % 3) as usize]);
        }
    }
    file.line(format!("\n$End{nodes}\n$Elements\n{all}"));
    let short = |nodes: &[u64]| nodes.iter().map(|node| *node as i32).collect::<Vec<i32>>();
    let mut list = |kind: i32, group: i32, of: &[(u64, Vec<u64>)]| {
        if coding != Coding::Text {
            file.ints(&[kind, of.len() as i32, 2]);
        }
        for (tag, nodes) in of {
            match coding {
                Coding::Text => file.ints(&[*tag as i32, kind, 2, group, 3]),
                _ => file.ints(&[*tag as i32, group, 3]),
            }
            file.ints(&short(nodes));
        }
    };
    for (k, (_, edges)) in body.sides.iter().enumerate() {
        let edges = edges.iter().enumerate().map(|(j, nodes)| (1000 + 10 * k as u64 + j as u64, nodes.clone()));
        list(line, k as i32 + 1, &edges.collect::<Vec<_>>());
    }
    // Some in one block and some in another.
    list(cell, 9, &body.cells[..2]);
    list(cell, 9, &body.cells[2..]);
    file.line("\n$EndElements");
    file.bytes
}

/// The body as a deck: its sole a surface of element sides, its roof one of lines, its axis a set of nodes.
fn inp(body: &Body) -> String {
    let count = body.cells[0].1.len();
    let listed = |nodes: &[u64]| nodes.iter().map(u64::to_string).collect::<Vec<_>>().join(", ");
    let nodes: String = body.nodes.iter().map(|(tag, [x, y])| format!("{tag}, {x:e}, {y:e}\n")).collect();
    let mut cells = String::new();
    for (tag, nodes) in &body.cells {
        // Long ones go on in the next line.
        let (first, last) = nodes.split_at(nodes.len() - 2);
        cells += &format!(" {tag},{},\n  {}\n", listed(first), listed(last));
    }
    let side = |edge: &Vec<u64>| {
        let find = |(tag, nodes): &(u64, Vec<u64>)| {
            let at = |k: usize| [nodes[k], nodes[(k + 1) % 4]];
            let k = (0..4).find(|&k| at(k).iter().all(|node| edge[..2].contains(node)))?;
            Some(format!("{tag}, s{}\n", k + 1))
        };
        body.cells.iter().find_map(find).expect("a side")
    };
    let sole: String = body.sides[0].1.iter().map(side).collect();
    let lines = body.sides[1].1.iter().enumerate().map(|(k, edge)| {
        // The middle node stands between the ends.
        let nodes = [&edge[..1], edge.get(2..).unwrap_or_default(), &edge[1..2]].concat();
        format!("{}, {}\n", 500 + 2 * k, listed(&nodes))
    });
    let lines: String = lines.collect();
    let mut axis: Vec<u64> = body.sides[2].1.concat();
    axis.sort_unstable();
    axis.dedup();
    let (first, last) = axis.split_at(2);
    format!(
        "** A deck of a pre-processor.\n*Heading\n a body, 1, 2\n*NODE, NSET=Nall\n{nodes}**\n*element , \
        type=cpe{count}R, elset = body\n{cells}\
         *ELEMENT, TYPE=T3D{}\n{lines}*ELSET, ELSET=roof, GENERATE\n500, 505, 2\n*NSET, NSET=\"Some\"\n{},\n*nset, \
         nset=axis\n SOME\n{}\n\
         *SURFACE, NAME=sole, TYPE=ELEMENT\n{sole}*MATERIAL, NAME=steel\n*ELASTIC\n210000., 0.3\n*STEP\n*STATIC\n*NODE \
         PRINT, NSET=axis\nU\n*END STEP\n",
        if count == 4 { 2 } else { 3 },
        listed(first),
        listed(last),
    )
}

/// A scene of a body of a mesh file on a rigid plane, with its supports and loads.
fn on_plane(plane: &str, [file, group, contact]: [&str; 3], more: &str) -> String {
    format!(
        "{plane}\n[[body]]\nname = \"body\"\nyoung = 1000\npoisson = 0.3\n\
         shape = {{ mesh = {{ file = \"{file}\", group = \"{group}\", contact = \"{contact}\" }} }}\n{more}\
         [contact]\nfirst = \"body\"\ngap = {{ uniform = 0 }}\nstretch = 2\n[reference]\npressure = 5\n"
    )
}

/// A scene of the body, pressed by a traction on its roof, with a support.
fn scene(file: &str, load: &str, support: &str) -> String {
    let more = format!(
        "supports = [{{ at = {support}, component = \"x\" }}]\nloads = [{{ pressure = {{ at = \"roof\", law = {load} \
        }} }}]\n"
    );
    on_plane("plane = \"stress\"\nthickness = 1", [file, "body", "sole"], &more)
}

const UNIFORM: &str = "{ uniform = 5 }";
const LINEAR: &str = "{ polynomial = { along = \"x\", coefficients = [5, 1] } }";

/// A scene beside a file.
fn beside(file: &str, bytes: &[u8], scene: &str) -> Result<Case, Error> {
    let folder = Folder::made();
    folder.with(file, bytes);
    Case::parse(&folder.path().join("scene.toml"), scene)
}

/// The body of a file under a uniform pressure.
fn read(file: &str, bytes: &[u8]) -> Result<Case, Error> {
    beside(file, bytes, &scene(file, UNIFORM, "\"axis\""))
}

fn of_deck(deck: &str) -> Case {
    read("a.inp", deck.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

/// What is said of a deck that is refused, which holds some parts.
fn refused(deck: &str, parts: &[impl AsRef<str>]) -> String {
    workbench::refused(read("a.inp", deck.as_bytes()), parts)
}

/// That its sole has the pressure on its roof.
fn assert_uniform(case: &Case) {
    for [_, pressure] in pressures(case) {
        assert_relative_eq!(pressure, 5.0, max_relative = 1e-11);
    }
}

/// Where the contact points of a case are, and their pressures.
fn pressures(case: &Case) -> Vec<[f64; 2]> {
    solved_as_it_says(case).1.solution.points.iter().map(|point| [point.position, point.pressure]).collect()
}

/// A deck with another sole.
fn with_sole(deck: &str, sole: &str) -> String {
    let [begin, end] = ["*SURFACE", "*MATERIAL"].map(|what| deck.find(what).expect("a block"));
    format!("{}{sole}{}", &deck[..begin], &deck[end..])
}

/// A set of nodes that is the sole.
fn set(nodes: impl IntoIterator<Item = u64>) -> String {
    let nodes: String = nodes.into_iter().map(|node| format!("{node},\n")).collect();
    format!("*NSET, NSET=sole\n{nodes}")
}

/// The body in every format.
fn formats(body: &Body) -> Vec<(String, Vec<u8>)> {
    let codings = [Coding::Text, Coding::Little, Coding::Big];
    let of_gmsh =
        |version: &'static str| codings.map(|coding| (format!("{version}-{coding:?}.msh"), msh(body, version, coding)));
    let mut all: Vec<(String, Vec<u8>)> =
        ["4.1", "2.2", "4.1 in parts", "2.2 with parameters"].into_iter().flat_map(of_gmsh).collect();
    let marked = |bytes: &[u8]| [b"\xEF\xBB\xBF", bytes].concat();
    all.push(("mark.msh".into(), marked(&all[0].1)));
    all.push(("deck.inp".into(), inp(body).into_bytes()));
    // CalculiX GraphiX calls decks so.
    all.push(("deck.msh".into(), marked(inp(body).replace('\n', "\r\n").as_bytes())));
    all
}

#[test]
fn one_mesh_in_every_format_has_one_answer_to_the_last_digit() {
    for (count, order) in [(4, Order::Linear), (8, Order::Quadratic), (9, Order::Biquadratic)] {
        let mut first = None;
        for (name, bytes) in formats(&Body::of(count)) {
            let case = read(&name, &bytes).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(case.resolution.order, order, "{name}");
            let Shape::Given(mesh) = &case.scene.bodies[0].shape else { panic!("no mesh") };
            assert_eq!((mesh.cells.len(), mesh.turned), (6, 3), "{name}");
            assert_uniform(&case);
            let found = pressures(&case);
            assert_eq!(*first.get_or_insert_with(|| found.clone()), found, "{name} of {count} nodes");
        }
    }
}

#[test]
fn nine_node_cells_bend_exactly_on_distorted_meshes_and_eight_node_ones_do_not() {
    // σ_y = −(5 + x), all others 0: displacements are of second order, u_x = ν (5x + x²/2)/E + y²/2E.
    let worst = |count: usize| {
        let bytes = msh(&Body::of(count), "4.1", Coding::Text);
        let case = beside("body.msh", &bytes, &scene("body.msh", LINEAR, "[0, 0]")).expect("read");
        let (_, run) = solved_as_it_says(&case);
        // With that of the half beyond x = 0.
        assert_relative_eq!(run.transmitted(), 2.0 * 12.0, max_relative = 1e-9);
        pressures(&case).iter().map(|[x, pressure]| (pressure / (5.0 + x) - 1.0).abs()).fold(0.0, f64::max)
    };
    let [nine, eight] = [9, 8].map(worst);
    assert!(nine < 1e-10 && eight > 1e-4, "{nine:e} {eight:e}");
}

#[test]
fn sides_of_a_deck_are_named_by_surfaces_sets_of_elements_and_sets_of_nodes() {
    let body = Body::of(8);
    let deck = inp(&body);
    let glued: Vec<String> = body.cells[0].1[..2].iter().map(u64::to_string).collect();
    let wanted = pressures(&of_deck(&deck));
    let nodes: String = body.sides[0].1.concat().iter().map(|node| format!("{node},\n")).collect();
    let lines: String = body.sides[0]
        .1
        .iter()
        .enumerate()
        .map(|(k, edge)| format!("{},{},{},{}\n", 700 + k, edge[0], edge[1], edge[2]))
        .collect();
    let cells: Vec<u64> = body.cells.iter().step_by(2).map(|(tag, _)| *tag).collect();
    let last = cells.last().expect("cells");
    for other in [
        format!("*SURFACE, NAME=sole, TYPE=NODE\n{nodes}"),
        format!("*NSET, NSET=low\n{nodes}*SURFACE, TYPE=NODE,\nNAME=sole\nLOW, 1.\n"),
        format!("*NSET, NSET=sole, UNSORTED\n{nodes}"),
        format!("*ELEMENT, TYPE=B32, ELSET=sole\n{lines}"),
        format!("*ELEMENT, TYPE=B32, ELSET=low\n{lines}*SURFACE, NAME=sole\nLow, SPOS\n"),
        format!("*ELEMENT, TYPE=COH2D4, ELSET=glue\n900, {0}, {0}\n*NSET, NSET=sole\n{nodes}", glued.join(", ")),
        // The lower cells are every second one; the middle one is listed clockwise, so that its lower side is its last.
        format!(
            "*ELSET, ELSET=low, GENERATE\n{}, {last}, 28,,\n*ELSET, ELSET=mid\n{}\n*SURFACE, NAME=sole\nlow, S1\nmid, \
            S4\n",
            cells[0], cells[1]
        ),
    ] {
        let found = pressures(&of_deck(&with_sole(&deck, &other)));
        for (own, other) in wanted.iter().zip(found) {
            assert_relative_eq!(own[0], other[0], max_relative = 1e-12);
            assert_relative_eq!(own[1], other[1], max_relative = 1e-11);
        }
    }
    let free = with_sole(&deck, &format!("*ELSET, ELSET=low\n{}\n*SURFACE, NAME=sole\nlow\n", cells[0]));
    refused(&free, &["`low` has no side behind it", "name a side of S1 to S4"]);
    // All cells are a group, and a set of all nodes is the outline.
    let all = scene("a.inp", UNIFORM, "\"axis\"").replace("\"body\", contact", "\"Eall\", contact");
    let all = beside("a.inp", deck.as_bytes(), &all).expect("read");
    assert_eq!(pressures(&all), wanted);
    let case = of_deck(&deck);
    let Shape::Given(mesh) = &case.scene.bodies[0].shape else { panic!("no mesh") };
    assert!(mesh.boundaries["Nall"].len() == 10 && !mesh.inner.contains("Nall"));
}

/// The deck as a pre-processor of Abaqus writes it: nodes and cells in a part, sides by sets of the assembly, a point
/// of reference off the plane.
fn assembled(body: &Body) -> String {
    let deck = inp(body);
    let [begin, sets] = ["*NODE", "*ELEMENT, TYPE=T3D"].map(|what| deck.find(what).expect("a block"));
    let nodes = |k: usize| {
        let own: Vec<String> = body.sides[k].1.concat().iter().map(u64::to_string).collect();
        own.chunks(16).map(|line| line.join(", ") + "\n").collect::<String>()
    };
    format!(
        "*Heading\n*Part, name=Part-1\n*End Part\n*Part, name=Block\n{}*Nset, nset=roof\n{}*End Part\n*Assembly, \
        name=Assembly\n\
         *Instance, name=Block-1, part=BLOCK\n*End Instance\n*Node\n 5, 0., 0., 9.\n*Nset, nset=point\n 5,\n\
         *Nset, nset=axis, internal, instance=Block-1\n{}*Nset, nset=low, instance=block-1\n{}*Surface, type=NODE, \
         name=sole, internal\n\
         low, 1.\n*End Assembly\n*Step\n*Boundary\nBlock-1.roof, 1\n*End Step\n",
        &deck[begin..sets],
        nodes(1),
        nodes(2),
        nodes(0)
    )
}

#[test]
fn parts_are_read_where_their_instances_place_them_and_their_sets_by_instance() {
    let body = Body::of(8);
    let answer = |deck: &str, change: &dyn Fn(String) -> String| {
        let text = change(scene("a.inp", UNIFORM, "\"axis\""));
        let case = beside("a.inp", deck.as_bytes(), &text).unwrap_or_else(|error| panic!("{error}"));
        pressures(&case)
    };
    let deck = assembled(&body);
    // Moved by (1, -3) and turned by a quarter, (x, y) comes to (3 - y, x + 1).
    let nodes: Vec<String> = body.nodes.iter().map(|(tag, [x, y])| format!("{tag}, {x:e}, {y:e}\n")).collect();
    let turned: Vec<String> =
        body.nodes.iter().map(|(tag, [x, y])| format!("{tag}, {:e}, {:e}\n", y - 1.0, 3.0 - x)).collect();
    let placed = deck
        .replace(&nodes.concat(), &turned.concat())
        .replace("part=BLOCK\n", "part=BLOCK\n1., -3., \n0., 0., 0., 0., 0., 1., 90.\n");
    // Against the axis that points down a turn is the other one.
    let from_below = placed.replace("0., 0., 1., 90.", "0., 0., -1., -90.");
    assert_ne!(placed, from_below);
    let twice = deck
        .replace("*End Instance\n", "*End Instance\n*Instance, name=Other, part=Block\n50., 0., 0.\n*End Instance\n");
    let by_name = |text: String| {
        text.replace("\"body\", contact", "\"Block-1.body\", contact").replace("\"roof\"", "\"Block-1.roof\"")
    };
    let plainly = [&deck, &placed, &from_below].map(|deck| answer(deck, &|text| text));
    for found in plainly.into_iter().chain([&deck, &twice].map(|deck| answer(deck, &by_name))) {
        assert_eq!(found.len(), 7);
        for [_, pressure] in found {
            assert_relative_eq!(pressure, 5.0, max_relative = 1e-9);
        }
    }
    assert_told("assembled", &deck, "a.inp", |spoiled| refused(spoiled, &[""]));
}

#[test]
fn decks_may_leave_blank_what_is_zero_and_list_corners_alone() {
    let body = Body::of(8);
    let wanted = inp(&body);
    let sides = &body.sides[0].1;
    let corners = || sides.iter().flat_map(|side| side[..2].to_vec());
    for deck in [wanted.replace(", 0e0", ", "), wanted.replace("e0", "d0"), with_sole(&wanted, &set(corners()))] {
        assert_uniform(&of_deck(&deck));
    }
    let [few, half_told] = [
        ["the set `sole` has node 5, but not all nodes", "or the corners alone"],
        ["the set `sole` has node", "but not all nodes of a side with it"],
    ];
    let hole = sides.concat().into_iter().filter(|node| *node != sides[1][1]);
    for (sole, parts) in [
        // Of no side all nodes: one middle, and the ends.
        (set([sides[0][0], sides[0][2], sides[2][1]]), few),
        // Corners of all sides, and one middle; all nodes but a corner within.
        (set(corners().chain([sides[0][2]])), half_told),
        (set(hole), half_told),
    ] {
        refused(&with_sole(&wanted, &sole), &parts);
    }
    // A corner in the middle of its cell.
    let inverted = wanted.replace("\n5, 0e0, 0e0\n", "\n5, 3e-1, 3e-1\n");
    refused(&inverted, &["cell 90 of `body` is turned inside out", "a corner is not convex"]);
    // Megabytes of what is not read.
    let long = format!("{}{}", "*A\n".repeat(200_000), wanted);
    of_deck(&long);
}

/// A deck of a strip of 4-node cells on 0 … 2 × 0 … 1: node 10 i + j + 1 is the j-th of column i. Sets of nodes as they
/// are given.
fn strip(columns: usize, sets: &[(&str, Vec<usize>)]) -> String {
    let tag = |i: usize, j: usize| 10 * i + j + 1;
    let nodes = (0..=columns).flat_map(|i| (0..2).map(move |j| (i, j)));
    let nodes: String =
        nodes.map(|(i, j)| format!("{}, {}, {j}\n", tag(i, j), 2.0 * i as f64 / columns as f64)).collect();
    let cell = |i: usize| format!("{}, {}, {}, {}, {}\n", i + 1, tag(i, 0), tag(i + 1, 0), tag(i + 1, 1), tag(i, 1));
    let cells: String = (0..columns).map(cell).collect();
    let list = |own: &[usize]| own.iter().map(|node| format!("{node},\n")).collect::<String>();
    let sets: String = sets.iter().map(|(name, own)| format!("*NSET, NSET={name}\n{}", list(own))).collect();
    format!("*NODE\n{nodes}*ELEMENT, TYPE=CPE4, ELSET=body\n{cells}{sets}")
}

#[test]
fn a_set_with_a_hole_of_a_few_nodes_is_refused_with_the_number_of_the_first_whatever_it_is_used_for() {
    let row = |columns: usize, j: usize| (0..=columns).map(|i| 10 * i + j + 1).collect::<Vec<usize>>();
    let without = |own: Vec<usize>, lost: &[usize]| own.into_iter().filter(|node| !lost.contains(node)).collect();
    let usual = |sole: Vec<usize>, roof: Vec<usize>, axis: Vec<usize>| {
        strip(6, &[("sole", sole), ("roof", roof), ("axis", axis)])
    };
    assert_uniform(&of_deck(&usual(row(6, 0), row(6, 1), vec![1, 2])));
    let lacks = |name: &str, node: usize| {
        [format!("the set `{name}` lacks node {node}, between two of its sides"), "list that node too".into()]
    };
    let has = |name: &str, node: usize| {
        [format!("the set `{name}` has node {node}, but not all nodes of a side"), "all nodes of every side".into()]
    };
    let eight = {
        let body = Body::of(8);
        let lost = body.sides[0].1[1][2];
        let nodes = body.sides[0].1.concat().into_iter().filter(|node| *node != lost);
        (with_sole(&inp(&body), &set(nodes)), lacks("sole", lost as usize))
    };
    for (deck, parts) in [
        (usual(without(row(6, 0), &[31]), row(6, 1), vec![1, 2]), lacks("sole", 31)),
        (usual(row(6, 0), without(row(6, 1), &[22]), vec![1, 2]), lacks("roof", 22)),
        (usual(row(6, 0), without(row(6, 1), &[52]), vec![1, 2]), has("roof", 62)),
        (usual(row(6, 0), row(6, 1), vec![2]), has("axis", 2)),
        // Three of fourteen sides, and four of sixteen.
        (
            strip(14, &[("sole", without(row(14, 0), &[31, 41])), ("roof", row(14, 1)), ("axis", vec![1, 2])]),
            lacks("sole", 31),
        ),
        (
            strip(16, &[("sole", row(16, 0)), ("roof", without(row(16, 1), &[102, 112, 122])), ("axis", vec![1, 2])]),
            lacks("roof", 122),
        ),
        eight,
    ] {
        assert!(refused(&deck, &parts).contains("scene.toml:"));
    }
    // Half of the sides are a part that is left out, and so is what lies between two sides that turn.
    for deck in [
        usual(row(6, 0), without(row(6, 1), &[32, 42]), vec![1, 2]),
        strip(2, &[("sole", row(2, 0)), ("roof", row(2, 1)), ("axis", vec![1, 2]), ("ends", vec![1, 2, 21, 22])]),
    ] {
        let case = of_deck(&deck);
        let Shape::Given(mesh) = &case.scene.bodies[0].shape else { panic!("no mesh") };
        let sides = |name: &str| mesh.boundaries[name].len();
        assert!(if mesh.cells.len() == 2 { sides("ends") == 2 } else { sides("roof") == 3 }, "{:?}", mesh.boundaries);
    }
}

#[test]
fn every_mistake_in_a_deck_names_its_line() {
    let deck = inp(&Body::of(8));
    assert_told("deck", &deck, "a.inp", |spoiled| refused(spoiled, &[""]));
    let triangles = "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*ELEMENT, TYPE=CPS3, ELSET=body\n1, 1, 2, 3\n";
    for (kind, nodes) in [("CPS3", ""), ("CPE3", ""), ("S3", ""), ("CPS6", ",1,2,3"), ("CPE6", ",1,2,3")] {
        let parts = ["cell 1 of `body` is a triangle", "Mesh.RecombineAll = 1", "`RecombineMesh;`", "`RefineMesh;`"];
        refused(&triangles.replace("CPS3", kind).replace("1, 2, 3", &format!("1, 2, 3{nodes}")), &parts);
    }
    let empty = refused("", &[""]);
    assert!(empty.contains("there are no nodes") || empty.contains("$MeshFormat"));
}

#[test]
fn meshes_that_meshio_writes_are_read() {
    // Every quadrilateral as an element of revolution, lines as beams of two nodes; names as meshio takes them from
    // Gmsh.
    for (count, kind) in [(4, "CAX4P"), (8, "S8R5"), (9, "S9R5")] {
        let deck = inp(&Body::of(count))
            .replace(&format!("cpe{count}R"), kind)
            .replace("T3D2", "B31H")
            .replace("T3D3", "B33H")
            + "*ELSET, ELSET=gmsh:bounding_entities\n90,-1\n";
        // Edges of shells are called otherwise.
        let deck = if kind.starts_with('S') { deck.replace(", s", ", e") } else { deck };
        assert_uniform(&of_deck(&deck));
    }
}

#[test]
fn groups_of_decks_go_by_names_in_quotes_in_latin_1_and_in_whatever_case_only_one_is_written() {
    let body = Body::of(8);
    let deck = inp(&body);
    let quoted = deck
        .replace("elset = body", "elset = \"body, left\"")
        .replace("NAME=sole", "NAME=\"sole, of 3\"")
        .replace("NSET=\"Some\"", "NSET=\"a, few\"")
        .replace(" SOME\n", " \"A, FEW\"\n");
    let (few, latin) = (quoted.replace("\"a, few\"", "\"a few\""), deck.replace("body", "Körper"));
    let capitals = deck.to_uppercase();
    let of = |[group, sole, axis, roof]: [&str; 4]| {
        scene("a.inp", UNIFORM, &format!("\"{axis}\""))
            .replace("\"body\", contact = \"sole\"", &format!("\"{group}\", contact = \"{sole}\""))
            .replace("at = \"roof\"", &format!("at = \"{roof}\""))
    };
    let in_latin = |text: &str| text.chars().map(|letter| letter as u8).collect::<Vec<u8>>();
    let usual = ["body", "sole", "axis", "roof"];
    for (bytes, names) in [
        (quoted.clone().into_bytes(), ["body, left", "sole, of 3", "axis", "roof"]),
        (in_latin(&latin), ["Körper", "sole", "axis", "roof"]),
        (in_latin(&latin.replace('\n', "\r")), ["Körper", "sole", "axis", "roof"]),
        (in_latin(&format!("** Körper\n{deck}")), usual),
        (capitals.clone().into_bytes(), usual),
        (deck.clone().into_bytes(), ["BODY", "Sole", "aXis", "ROOF"]),
    ] {
        assert_uniform(&beside("a.inp", &bytes, &of(names)).unwrap_or_else(|error| panic!("{error}")));
    }
    let told = |deck: &str, names: [&str; 4], parts: &[&str]| {
        workbench::refused(beside("a.inp", deck.as_bytes(), &of(names)), parts)
    };
    told(&few, ["body, left", "sole, of 3", "axis", "roof"], &["there is no node or set of nodes `A, FEW`", "a.inp:"]);
    told(&capitals, ["bodies", "sole", "axis", "roof"], &["there is no element set `bodies`", "known: BODY, Eall"]);
    // Gmsh tells names apart by their case: of two neither is meant by a third.
    let mut twice = body;
    twice.sides[2].0 = "Roof";
    let twice = msh(&twice, "2.2", Coding::Text);
    let of = |roof: &str| of(["BODY", "sole", "Roof", roof]).replace("a.inp", "a.msh");
    assert_uniform(&beside("a.msh", &twice, &of("roof")).unwrap_or_else(|error| panic!("{error}")));
    workbench::refused(beside("a.msh", &twice, &of("ROOF")), &["no boundary `ROOF`", "`Roof`, `contact`, `roof`"]);
    // One place by two names is one.
    let support = "{ at = \"axis\", component = \"x\" }";
    let fixed = scene("a.inp", UNIFORM, "\"axis\"")
        .replace(support, &format!("{support}, {}", support.replace("axis", "Axis")));
    assert_ne!(fixed, scene("a.inp", UNIFORM, "\"axis\""));
    workbench::refused(beside("a.inp", deck.as_bytes(), &fixed), &["already fixed there"]);
}

#[test]
fn counts_that_a_header_states_take_no_memory_and_no_time() {
    let [body, huge] = [Body::of(4), Body::of(4)];
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    let of = |version: &str| text(msh(&body, version, Coding::Text));
    let nodes = huge.nodes.len();
    for (file, spoiled) in [
        ("a.msh", of("4.1").replace(&format!("2 {nodes} 1"), &format!("{} {nodes} 1", u64::MAX))),
        ("a.msh", of("2.2").replace(&format!("$Nodes\n{nodes}"), &format!("$Nodes\n{}", u64::MAX))),
        ("a.msh", of("2.2").replace("$Elements\n14", &format!("$Elements\n{}", u64::MAX))),
        ("a.inp", inp(&body).replace("500, 505, 2", &format!("1, {}, 1\n0, {}, 1", u64::MAX, u64::MAX - 1))),
    ] {
        let begun = std::time::Instant::now();
        let told = read(file, spoiled.as_bytes()).map(|_| ());
        assert!(begun.elapsed().as_secs() < 2, "{told:?}");
        assert!(told.is_err() || file == "a.inp", "{spoiled}");
    }
    for coding in [Coding::Little, Coding::Big] {
        for version in ["4.1", "2.2"] {
            let bytes = msh(&body, version, coding);
            // Every twenty-third byte of the counts and numbers, one after the other, as large as it can be.
            for k in (0..bytes.len()).step_by(23) {
                let mut spoiled = bytes.clone();
                spoiled[k] = 255;
                let _ = read("a.msh", &spoiled);
            }
        }
    }
    // Sets of sets by the product of their numbers.
    let sets: String = (0..3000).map(|k| format!("*NSET, NSET=s{k}\n{}\n", "Nall\n".repeat(400))).collect();
    let deck = inp(&body).replace("*MATERIAL", &format!("{sets}*MATERIAL"));
    refused(&deck, &["more than 10000000 members"]);
}

#[test]
fn files_that_are_cut_are_refused_and_spoiled_ones_are_assembled_or_refused() {
    let mut number = noise(41);
    for (name, bytes) in [4, 9].into_iter().flat_map(|count| formats(&Body::of(count))) {
        for length in (0..bytes.len()).step_by(17) {
            // What stands behind the elements may be missing; a deck has no end.
            let is_whole = length + 60 > bytes.len() || name.starts_with("deck");
            assert!(read(&name, &bytes[..length]).is_err() || is_whole, "{name} cut at {length}");
        }
        // What is not read is asked by the fuzz target `mesh`.
        for _ in 0..16 {
            let spoiled = mutated(&String::from_utf8_lossy(&bytes), &mut number);
            if let Ok(case) = read(&name, spoiled.as_bytes()) {
                let _ = Discretisation::of(case.scene, case.resolution);
            }
        }
    }
}

/// A block of 2 × 1 cells of a type, with `BOTTOM` as a set of its nodes, and what else a deck says.
fn deck_of(kind: &str, more: &str) -> String {
    format!(
        "*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1\n6, 2, 1\n*ELEMENT, TYPE={kind}, ELSET=BLOCK\n\
         10, 1, 2, 5, 4\n11, 2, 3, 6, 5\n*NSET, NSET=BOTTOM\n1, 2, 3\n{more}"
    )
}

const STRAIN: &str = "plane = \"strain\"\nthickness = 1";

/// The nodes of the edges of the side `X` of a deck.
fn side(text: &str) -> Result<Vec<[f64; 2]>, String> {
    let scene = on_plane(STRAIN, ["mesh.inp", "BLOCK", "BOTTOM"], "");
    let case = beside("mesh.inp", text.as_bytes(), &scene).map_err(|error| error.to_string())?;
    let Shape::Given(given) = &case.scene.bodies[0].shape else { panic!("no mesh") };
    let edges = given.boundaries.get("X").ok_or("no `X`")?;
    Ok(edges.iter().flat_map(|edge| edge.iter().map(|&node| given.points[node])).collect())
}

#[test]
fn sides_of_decks_are_counted_once_and_are_those_that_both_codes_mean() {
    let (below, right, top) = ([[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0]], [[2.0, 0.0], [2.0, 1.0]], 4);
    let surface = |rows: &str| format!("*SURFACE, NAME=X, TYPE=ELEMENT\n{rows}\n");
    let all = "*ELSET, ELSET=ALL\n10, 11\n";
    for (kind, more, wanted) in [
        ("CPS4", format!("{all}{}", surface("ALL, S1\n10, S1\n11, S1")), &below[..]),
        ("CPS4", surface("10, S1\n11, S1").repeat(2), &below),
        ("CPE4R", surface("11, S2"), &right),
        // Of shells and membranes S1 and S2 are faces.
        ("S4", surface("11, S4"), &right),
        ("S4R", surface("11, E2"), &right),
        ("M3D4", surface("10, S3\n11, S3"), &below),
        // A surface of nodes is no set of nodes.
        ("CPS4", "*NSET, NSET=X\n4, 5, 6\n*SURFACE, NAME=X, TYPE=NODE\n3\n6\n".into(), &right),
        // What nobody asks for is passed over.
        ("CPS4", format!("{}*SURFACE, NAME=R, TYPE=SEGMENTS\nSTART, 0, 0\nLINE, 1, 0\n", surface("11, S2")), &right),
        ("CPS4", format!("{}*SURFACE, NAME=U, COMBINE=UNION\nX, Y\n", surface("11, S2")), &right),
        ("S4", format!("{}*SURFACE, NAME=F, TYPE=ELEMENT\nBLOCK, SPOS\n", surface("11, E2")), &right),
        (
            "CPS4",
            format!("*ELEMENT, TYPE=MASS, ELSET=M\n90, 1\n91, 2\n*ELEMENT, TYPE=SPRING1\n92, 3\n{}", surface("11, S2")),
            &right,
        ),
        ("CPS4", format!("*END INSTANCE\n*NODE\n1, 7, 7, 3\n{}", surface("11, S2")), &right),
    ] {
        let mut found = side(&deck_of(kind, &more)).unwrap_or_else(|error| panic!("{kind}, {more}: {error}"));
        found.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        assert_eq!(found, wanted, "{kind}: {more}");
    }
    assert_eq!(side(&deck_of("CPS4", &surface("10, S3\n11, S3"))).expect("a side").len(), top);
    let refused = side(&deck_of("S4", &surface("11, S2"))).expect_err("a face");
    assert!(refused.contains("mesh.inp:14") && refused.contains("E1 to E4"), "{refused}");
}

#[test]
fn section_of_a_mesh_with_more_rows_than_it_counts_is_refused() {
    let text = String::from_utf8(msh(&Body::of(4), "2.2", Coding::Text)).expect("text");
    let fewer = text.replacen("$Elements\n14", "$Elements\n13", 1);
    assert_ne!(fewer, text);
    let parts = ["behind the last row of `$Elements`", "counts fewer"];
    workbench::refused(read("mesh.msh", fewer.as_bytes()), &parts);
}

#[test]
fn a_circle_is_seen_in_coordinates_of_nine_digits_however_short_its_edges_and_few_digits_are_exact() {
    // Edges of a rim of radius 50 mm that grow from 0.06 mm by a quarter each.
    let angles = std::iter::successors(Some(0.0012), |step| Some(1.25 * step)).take(19);
    let angles = angles.scan(0.0, |sum, step| Some(std::mem::replace(sum, *sum + step)));
    let angles: Vec<f64> = angles.collect();
    for digits in [5, 8, 9, 12] {
        let mut deck = String::from("*PART, NAME=P\n*NODE\n");
        for (k, angle) in angles.iter().enumerate() {
            for (tag, radius) in [(2 * k + 1, 50.0), (2 * k + 2, 40.0)] {
                let [x, y] = [radius * angle.sin(), -radius * angle.cos()].map(|x| format!("{x:.*e}", digits - 1));
                deck += &format!("{tag}, {x}, {y}\n");
            }
        }
        deck += "*ELEMENT, TYPE=CPE4, ELSET=BLOCK\n";
        for k in 1..angles.len() {
            deck += &format!("{k}, {}, {}, {}, {}\n", 2 * k - 1, 2 * k + 1, 2 * k + 2, 2 * k);
        }
        let rim: String = (0..angles.len()).map(|k| format!("{},\n", 2 * k + 1)).collect();
        deck += &format!("*NSET, NSET=BOTTOM\n{rim}*END PART\n*INSTANCE, NAME=I, PART=P\n0, 50, 0\n*END INSTANCE\n");
        let scene = on_plane(STRAIN, ["mesh.inp", "BLOCK", "BOTTOM"], "").replace("uniform = 0", "from = \"bodies\"");
        let case = beside("mesh.inp", deck.as_bytes(), &scene).unwrap_or_else(|error| panic!("{error}"));
        let Shape::Given(given) = &case.scene.bodies[0].shape else { panic!("no mesh") };
        let curves = given.curves("BOTTOM").expect("a side");
        for curve in &curves {
            match curve {
                Curve::Arc { centre, .. } if digits > 5 => assert!((centre[1] - 50.0).abs() < 1e-3, "{centre:?}"),
                curve => assert!(digits == 5, "{digits} digits: {curve:?}"),
            }
        }
    }
}

/// The block of a deck of a type, pressed on a rigid plane in a scene of a plane hypothesis.
fn pressed_block(kind: &str, plane: &str, change: [&str; 2]) -> Result<Case, Error> {
    let deck = deck_of(kind, "*NSET, NSET=roof\n4, 5, 6\n*NSET, NSET=axis\n1, 4\n").replace(change[0], change[1]);
    // On the axis nodes stay by themselves.
    let supports = if plane.contains("axi") { "" } else { "supports = [{ at = \"axis\", component = \"x\" }]\n" };
    let more = format!("{supports}loads = [{{ pressure = {{ at = \"roof\", law = {UNIFORM} }} }}]\n");
    beside("a.inp", deck.as_bytes(), &on_plane(plane, ["a.inp", "BLOCK", "BOTTOM"], &more))
}

#[test]
fn decks_of_bodies_of_revolution_are_read_in_scenes_of_such_bodies_alone() {
    let around = "plane = \"axisymmetric\"";
    for (kind, plane) in [("CAX4", around), ("CAX4R", around), ("CPE4", STRAIN)] {
        let case = pressed_block(kind, plane, ["", ""]).unwrap_or_else(|error| panic!("{error}"));
        for point in &case.solve().expect("solved").1.solution.points {
            assert_relative_eq!(point.pressure, 5.0, max_relative = 1e-6);
        }
    }
    let parts = ["CAX4 are of bodies of revolution", "axisymmetric"];
    workbench::refused(pressed_block("CAX4", STRAIN, ["", ""]), &parts);
}

#[test]
fn quadrilaterals_with_a_node_twice_are_triangles_and_files_that_are_no_mesh_say_what_to_give() {
    let twice = pressed_block("CPE4", STRAIN, ["11, 2, 3, 6, 5", "11, 2, 3, 6, 6"]);
    workbench::refused(twice, &["cell 11 of `BLOCK` is degenerate", "a node twice"]);
    for (name, text) in [
        ("a.bdf", "GRID,1,,0.,0.,0.\n"),
        ("a.unv", "    -1\n  2411\n"),
        ("a.vtk", "# vtk DataFile\n"),
        ("b.bdf", "$ Made by hand\nGRID,1\n"),
        ("a.key", "$# LS-DYNA\n*KEYWORD\n"),
    ] {
        workbench::refused(read(name, text.as_bytes()), &["meshio convert", name]);
    }
}

/// Halving keeps how much coarser the other side is: its cells are made no longer than those of the mesh from the
/// start, and no shorter where it presses.
#[test]
fn a_mesh_of_4_node_cells_is_answered_on_a_body_that_is_meshed_beside_it() {
    let deck = |columns: usize, rows: usize| {
        let tag = |i: usize, j: usize| 100 * i + j + 1;
        let all = || (0..=columns).flat_map(|i| (0..=rows).map(move |j| (i, j)));
        let place = |i: usize, j: usize| [40.0 * i as f64 / columns as f64 - 20.0, 24.0 * j as f64 / rows as f64];
        let node = |(i, j)| format!("{}, {}, {}\n", tag(i, j), place(i, j)[0], place(i, j)[1]);
        let cell = |(i, j)| {
            let corners = [tag(i, j), tag(i + 1, j), tag(i + 1, j + 1), tag(i, j + 1)];
            format!("{}, {}\n", tag(i, j), corners.map(|corner| corner.to_string()).join(", "))
        };
        let set = |name: &str, j: usize| {
            let own: String = (0..=columns).map(|i| format!("{},\n", tag(i, j))).collect();
            format!("*NSET, NSET={name}\n{own}")
        };
        let nodes: String = all().map(node).collect();
        let cells: String = all().filter(|(i, j)| *i < columns && *j < rows).map(cell).collect();
        let sides = set("down", 0) + &set("up", rows);
        format!("*NODE\n{nodes}*ELEMENT, TYPE=CPS4, ELSET=plate\n{cells}{sides}")
    };
    let scene = |shape: &str, far: &str, guess: f64, [first, second]: [&str; 2]| {
        format!(
            "plane = \"stress\"\nthickness = 2.5\n[[body]]\nname = \"plate\"\nyoung = 70e3\npoisson = 0.33\nshape = \
            {shape}\n\
             supports = [{{ at = [-20, 24], component = \"x\" }}]\n\
             loads = [{{ pressure = {{ at = \"{far}\", law = {{ polynomial = {{ along = \"x\", coefficients = [60, 1] \
             }} }} }} }}]\n\
             [[body]]\nname = \"base\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ rectangle = {{ x = [-40, 40], y = [-50, 0], contact = \"top\" }} }}\n\
             supports = [{{ at = \"far\", component = \"y\" }}, {{ at = \"left\", component = \"x\" }}]\n\
             [contact]\nfirst = \"{first}\"\nsecond = \"{second}\"\nboth-sides = true\n\
             gap = {{ parabola = 900 }}\nstretch = {guess}\n\
             [mesh]\naccuracy = \"1 %\"\n"
        )
    };
    let answer = |case: &Case, asked: f64| {
        let answer = accuracy::solve(&case.scene, &Formulation::verification(), &Asked::new(asked)).expect("solved");
        assert_eq!(answer.unmet, None);
        answer
    };
    let ours = parsed(&scene(
        "{ rectangle = { x = [-20, 20], y = [0, 24], contact = \"bottom\" } }",
        "far",
        18.0,
        ["plate", "base"],
    ));
    let truth = answer(&ours, 1e-3).run.measures().peak.pressure;
    // Whether the contact is longer or shorter than guessed, and whichever side presses.
    let (fine, coarse, of_given) = (deck(72, 42), deck(16, 6), ["plate", "base"]);
    let of_other = (&coarse, 18.0, ["base", "plate"]);
    for (deck, guess, sides) in [(&fine, 12.0, of_given), (&fine, 18.0, of_given), (&fine, 20.0, of_given), of_other] {
        let shape = "{ mesh = { file = \"a.inp\", group = \"plate\", contact = \"down\" } }";
        let given = scene(shape, "up", guess, sides);
        let found = answer(&beside("a.inp", deck.as_bytes(), &given).expect("a case"), 3e-2);
        assert!(found.run.dofs < 60_000, "{guess}: {}", found.run.dofs);
        assert_relative_eq!(found.run.measures().peak.pressure, truth, max_relative = 5e-3);
    }
}
