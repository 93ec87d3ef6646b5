//! A case as an input deck of CalculiX or Abaqus: nodes, cells, sets, surfaces, supports, loads as nodal forces, and
//! contact by gap elements on the undeformed surface.
//!
//! The approach of a contact node, `w = b·u`, is a dof of a node of its own, by an `*EQUATION`; a `GAPUNI` of the
//! initial gap lies between that node and a fixed one at the same place, whose reaction along 1 is the contact force,
//! turned round. Contact pairs of these codes follow the deformed surfaces, which is another model; the surfaces for
//! them are there too. Where the gaps of a contact are open everywhere, nothing holds a body before the first contact,
//! and ccx would diverge, as in the case `patch`: weak springs do. It makes bricks of plane cells, and those in plane
//! stress are too stiff where they are smaller than the thickness (the rigid pin: 2.8 % in the peak). Such decks have a
//! slice as thin as the smallest contact edge, and a modulus as much larger, so that forces and displacements stay what
//! they are.
//!
//! Of bodies of revolution ccx makes bricks of a sector of 2°. Loads on nodes of cells are whole forces, as in Abaqus;
//! forces in gap elements, whose nodes belong to no cell, are those of the sector.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;
use std::fmt::Write;

use crate::contact::interface::ContactNode;
use crate::error::Error;
use crate::mesh::{Edge, Order};
use crate::referee::export::rows::{approach, forces, on_axis};
use crate::scene::{Component, Load, Place, PlaneHypothesis, ReferenceValues, Scene};
use crate::solve::Discretisation;

/// Stiffness of a closed gap element, over E t.
const STIFFNESS: f64 = 1e4;
/// Pull of an open one, over the reference force.
const TAIL: f64 = 1e-7;
/// Stiffness of springs that hold a body before its first contact, over E t.
const WEAK: f64 = 1e-7;
/// Sectors of ccx in the circumference of bodies of revolution: by so much forces between nodes of no cell are smaller
/// than the whole ones.
pub const SECTORS: f64 = 180.0;
/// Set of the fixed nodes behind the gap elements of a contact, before its name.
pub const GAPS: &str = "GAPS_";
/// Sets of all nodes, of weak springs, and of a gap element before its number; and a material that nothing is of.
const ALL: &str = "ALL";
const WEAK_SET: &str = "WEAK";
const GAP: &str = "GAP";
const UNUSED: &str = "UNUSED";
/// Set of the nodes of a body on the axis of revolution, before its name.
const AXIS: &str = "AXIS";

/// The text of the file; nodes and cells are numbered from 1 on, as in the mesh.
pub fn text(discretisation: &Discretisation) -> Result<String, Error> {
    let kind = kind(discretisation)?;
    let mut deck = Deck {
        discretisation,
        names: names_of_bodies(discretisation),
        text: String::new(),
        nodes: discretisation.mesh.points.len(),
        elements: discretisation.mesh.cells(),
    };
    deck.head();
    deck.bodies(kind);
    deck.sets();
    let held = deck.supports()?;
    let faces = deck.rigid_faces(&held)?;
    deck.gaps();
    deck.step(&faces)?;
    Ok(deck.text)
}

/// What both codes call the cells.
pub(super) fn kind(discretisation: &Discretisation) -> Result<&'static str, Error> {
    Ok(match (discretisation.scene.plane, discretisation.mesh.order) {
        (PlaneHypothesis::Strain, Order::Linear) => "CPE4",
        (PlaneHypothesis::Strain, Order::Quadratic) => "CPE8",
        (PlaneHypothesis::Stress, Order::Linear) => "CPS4",
        (PlaneHypothesis::Stress, Order::Quadratic) => "CPS8",
        (PlaneHypothesis::Axisymmetric, Order::Linear) => "CAX4",
        (PlaneHypothesis::Axisymmetric, Order::Quadratic) => "CAX8",
        (PlaneHypothesis::AxisymmetricAboutX, _) => {
            let message =
                "bodies of revolution about y = 0 have no deck and no script: other codes turn them about x = 0";
            return Err(Error::at(
                "export",
                message,
                "exchange x and y in your code's own mesh, and hand in CSV or JSON to `judge`",
            ));
        }
        (_, order) => {
            let message =
                format!("its cells have {} nodes, and other codes read those of 4 and 8", order.nodes_per_cell());
            return Err(Error::at("export", message, "give `order = 1` or `order = 2` in [mesh]"));
        }
    })
}

/// Part of the thickness that the deck has: in plane stress no more than the shortest distance between contact nodes.
fn slice(discretisation: &Discretisation) -> f64 {
    if discretisation.scene.plane != PlaneHypothesis::Stress {
        return 1.0;
    }
    let apart = |two: &[ContactNode]| {
        let ([a, b], [c, d]) = (two[0].point, two[1].point);
        (a - c).hypot(b - d)
    };
    let all = discretisation.interfaces.iter().flat_map(|interface| interface.nodes.windows(2).map(apart));
    all.fold(discretisation.scene.thickness, f64::min) / discretisation.scene.thickness
}

/// A name that both codes take.
fn named(parts: &[&str]) -> String {
    let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter.to_ascii_uppercase() } else { '_' };
    parts.join("_").chars().map(plain).collect()
}

/// Names with their numbers before them where two of all that a deck has are the same in it, as those in other letters
/// than ASCII are: it would join their materials, supports and forces.
fn apart(names: Vec<String>, all: &[String]) -> Vec<String> {
    if all.iter().collect::<BTreeSet<_>>().len() == all.len() {
        return names;
    }
    names.into_iter().enumerate().map(|(k, name)| format!("N{}_{name}", k + 1)).collect()
}

/// Names of the bodies: no two of them, of their sides, or of what a deck has of its own are the same.
fn names_of_bodies(Discretisation { scene, mesh, .. }: &Discretisation) -> Vec<String> {
    let names: Vec<String> = scene.bodies.iter().map(|body| named(&[&body.name])).collect();
    let sides = names
        .iter()
        .zip(&mesh.bodies)
        .flat_map(|(name, part)| part.boundaries.iter().chain(&part.lines).map(move |(side, _)| named(&[name, side])));
    let gaps = (0..scene.contacts.len()).map(|contact| gaps_of(scene, contact));
    let axis = names.iter().map(|name| named(&[AXIS, name]));
    let own = [ALL, WEAK_SET, UNUSED].map(str::to_owned).into_iter().chain(gaps).chain(axis);
    let is_gap = |name: &String| name.strip_prefix(GAP).is_some_and(|rest| rest.parse::<usize>().is_ok());
    let twice = names.iter().filter(|name| is_gap(name)).cloned();
    let all: Vec<String> = sides.chain(own).chain(names.clone()).chain(twice).collect();
    apart(names, &all)
}

/// Set of the fixed nodes behind the gap elements of a contact.
pub fn gaps_of(scene: &Scene, contact: usize) -> String {
    let names: Vec<String> = scene.contacts.iter().map(|pair| named(&[&pair.name])).collect();
    format!("{GAPS}{}", apart(names.clone(), &names)[contact])
}

/// A deck being written.
struct Deck<'a> {
    discretisation: &'a Discretisation,
    /// Names of the bodies.
    names: Vec<String>,
    text: String,
    /// Last number of a node.
    nodes: usize,
    /// Last number of an element.
    elements: usize,
}

impl Deck<'_> {
    fn line(&mut self, line: impl AsRef<str>) {
        self.text.push_str(line.as_ref());
        self.text.push('\n');
    }

    fn head(&mut self) {
        let scene = &self.discretisation.scene;
        let name = scene.name.clone();
        let of = match scene.is_of_revolution() {
            true => {
                "Loads are whole forces; reactions behind gap elements are those of a sector of 2 degrees, 1/180 of \
                them."
            }
            false => "Forces are those of the modelled part.",
        };
        self.line(format!("** {name}: mm, N, MPa. {of}"));
        for (contact, pair) in scene.contacts.iter().enumerate() {
            let set = gaps_of(scene, contact);
            self.line(format!(
                "** contact `{}`: reactions of the set {set} along 1 are the contact forces, turned round.",
                pair.name
            ));
        }
        self.line(format!("*NODE, NSET={ALL}"));
        for (k, [x, y]) in self.discretisation.mesh.points.iter().enumerate() {
            let _ = writeln!(self.text, "{}, {x:.12e}, {y:.12e}", k + 1);
        }
    }

    /// Cells with their materials.
    fn bodies(&mut self, kind: &str) {
        let Discretisation { scene, mesh, .. } = self.discretisation;
        let slice = slice(self.discretisation);
        if slice < 1.0 {
            self.line(format!(
                "** Thickness times {slice:.6e}, moduli divided by it: stresses are to be multiplied by \
                it, forces are not."
            ));
        }
        for (index, (body, part)) in scene.bodies.iter().zip(&mesh.bodies).enumerate() {
            let name = self.names[index].clone();
            self.line(format!("*ELEMENT, TYPE={kind}, ELSET={name}"));
            for cell in part.cells.clone() {
                let nodes: Vec<String> = mesh.cell(cell).iter().map(|node| (node + 1).to_string()).collect();
                self.line(format!("{}, {}", cell + 1, nodes.join(", ")));
            }
            self.line(format!(
                "*MATERIAL, NAME={name}\n*ELASTIC\n{:.12e}, {:.12e}",
                body.material.young / slice,
                body.material.poisson
            ));
            self.line(format!("*SOLID SECTION, ELSET={name}, MATERIAL={name}"));
            if !scene.is_of_revolution() {
                self.line(format!("{:.12e}", scene.thickness * slice));
            }
        }
    }

    /// A set of nodes and a surface for every side of every body.
    fn sets(&mut self) {
        let mesh = &self.discretisation.mesh;
        for (index, part) in mesh.bodies.iter().enumerate() {
            let faces = faces(mesh, part.cells.clone());
            for (side, edges) in part.boundaries.iter().chain(&part.lines) {
                let name = named(&[&self.names[index], side]);
                self.set(&name, edges.iter().flatten().map(|node| node + 1).collect());
                self.line(format!("*SURFACE, NAME=S_{name}, TYPE=ELEMENT"));
                for edge in edges {
                    if let Some((cell, face)) = faces.get(&key(edge)) {
                        self.line(format!("{}, S{}", cell + 1, face + 1));
                    }
                }
            }
        }
    }

    fn set(&mut self, name: &str, mut nodes: Vec<usize>) {
        nodes.sort_unstable();
        nodes.dedup();
        self.line(format!("*NSET, NSET={name}"));
        nodes.iter().for_each(|node| self.line(format!("{node},")));
    }

    /// Prescribed displacements; returns the nodes that are held, with the component.
    fn supports(&mut self) -> Result<Vec<(usize, usize)>, Error> {
        let Discretisation { scene, mesh, .. } = self.discretisation;
        let mut held = Vec::new();
        for (index, body) in scene.bodies.iter().enumerate() {
            for support in &body.supports {
                let axis = support.component.index();
                let nodes = mesh.nodes_at(scene, index, &support.at)?;
                let at = match &support.at {
                    Place::Boundary(side) => named(&[&self.names[index], side]),
                    Place::Point(_) => (nodes[0] + 1).to_string(),
                };
                self.line(format!("*BOUNDARY\n{at}, {0}, {0}, {1:.12e}", axis + 1, support.value));
                held.extend(nodes.into_iter().map(|node| (node, axis)));
            }
            let axis = on_axis(self.discretisation, index, |at| held.contains(at));
            if !axis.is_empty() {
                let name = named(&[AXIS, &self.names[index]]);
                self.set(&name, axis.iter().map(|node| node + 1).collect());
                self.line(format!("*BOUNDARY\n{name}, 1, 1"));
                held.extend(axis.into_iter().map(|node| (node, 0)));
            }
        }
        Ok(held)
    }

    /// Sides that stay flat: a node that all of theirs follow, and its force.
    fn rigid_faces(&mut self, held: &[(usize, usize)]) -> Result<Vec<(usize, Component, f64)>, Error> {
        let Discretisation { scene, mesh, .. } = self.discretisation;
        let mut faces = Vec::new();
        for (index, body) in scene.bodies.iter().enumerate() {
            for load in &body.loads {
                let Load::RigidFace { boundary, component, force } = load else { continue };
                let nodes = mesh.nodes_at(scene, index, &Place::Boundary(boundary.clone()))?;
                let axis = component.index();
                let free = nodes.iter().filter(|node| !held.contains(&(**node, axis)));
                // Of bodies of revolution it is one of theirs, on which a load is a whole force.
                let followed = free.clone().next().filter(|_| scene.is_of_revolution());
                let common = followed.map_or(self.nodes + 1, |node| node + 1);
                if followed.is_none() {
                    let [x, y] = mesh.points[nodes[0]];
                    self.nodes += 1;
                    self.line(format!("*NODE\n{common}, {x:.12e}, {y:.12e}\n*BOUNDARY\n{common}, {0}, {0}", 2 - axis));
                }
                for node in free.filter(|node| **node + 1 != common) {
                    self.equation(&[(node + 1, axis, 1.0), (common, axis, -1.0)]);
                }
                faces.push((common, *component, *force));
            }
        }
        Ok(faces)
    }

    /// A linear equation of displacements; the first is eliminated.
    fn equation(&mut self, terms: &[(usize, usize, f64)]) {
        self.line(format!("*EQUATION\n{}", terms.len()));
        terms.iter().for_each(|(node, axis, factor)| self.line(format!("{node}, {}, {factor:.12e}", axis + 1)));
    }

    /// A gap element for every contact node that has another side.
    fn gaps(&mut self) {
        let discretisation = self.discretisation;
        let scene = &discretisation.scene;
        let ReferenceValues { pressure, length, .. } = scene.reference;
        // Of a sector the arc through the node, and of nodes near the axis that of a punch as wide as the reference
        // length.
        let across = |radius: f64| match scene.is_of_revolution() {
            true => 2.0 * length.max(PI * radius) / SECTORS,
            false => scene.thickness,
        };
        let young = scene.bodies.iter().map(|body| body.material.young).fold(0.0, f64::max);
        let mut held = false;
        for (contact, interface) in discretisation.interfaces.iter().enumerate() {
            let (mut fixed, open) = (Vec::new(), interface.nodes.iter().all(|node| node.gap > 0.0));
            for node in interface.nodes.iter().filter(|node| node.gap.is_finite()) {
                let (moved, still) = (self.nodes + 1, self.nodes + 2);
                (self.nodes, self.elements) = (still, self.elements + 1);
                let [x, y] = node.point;
                let (stiffness, tail) = (STIFFNESS * young * across(x), TAIL * pressure * length * across(x));
                self.line(format!("*NODE\n{moved}, {x:.12e}, {y:.12e}\n{still}, {x:.12e}, {y:.12e}"));
                self.equation(&[vec![(moved, 0, -1.0)], approach(discretisation, node)].concat());
                self.line(format!("*BOUNDARY\n{moved}, 2, 3\n{still}, 1, 3"));
                self.line(format!("*ELEMENT, TYPE=GAPUNI, ELSET={GAP}{moved}\n{}, {moved}, {still}", self.elements));
                self.line(format!(
                    "*GAP, ELSET={GAP}{moved}\n{:.12e}, 1., 0., 0., , {stiffness:.6e}, {tail:.6e}",
                    node.gap
                ));
                if open {
                    self.elements += 1;
                    self.line(format!("*ELEMENT, TYPE=SPRING1, ELSET={WEAK_SET}\n{}, {moved}", self.elements));
                }
                fixed.push(still);
            }
            held |= open && !fixed.is_empty();
            self.set(&gaps_of(scene, contact), fixed);
        }
        if held {
            self.line(format!("*SPRING, ELSET={WEAK_SET}\n1\n{:.6e}", WEAK * young * across(0.0)));
        }
    }

    /// Loads, and what is printed.
    fn step(&mut self, faces: &[(usize, Component, f64)]) -> Result<(), Error> {
        let scene = &self.discretisation.scene;
        self.line(
            "** Under gap elements alone ccx takes a step for linear; a plastic material, though nothing is of \
            it, makes it iterate.",
        );
        self.line(format!("*MATERIAL, NAME={UNUSED}\n*ELASTIC\n1., 0.\n*PLASTIC\n1e20, 0.\n2e20, 1."));
        self.line(
            "*STEP, INC=1000\n*STATIC, DIRECT\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-7, , , , , ,\n*CLOAD",
        );
        for (node, axis, value) in forces(self.discretisation)? {
            self.line(format!("{}, {}, {value:.12e}", node + 1, axis + 1));
        }
        for (node, component, force) in faces {
            self.line(format!("{node}, {}, {force:.12e}", component.index() + 1));
        }
        for contact in 0..scene.contacts.len() {
            self.line(format!("*NODE PRINT, NSET={}\nRF", gaps_of(scene, contact)));
        }
        self.line("*NODE FILE, OUTPUT=2D\nU\n*EL FILE, OUTPUT=2D\nS\n*END STEP");
        Ok(())
    }
}

/// Cell and number of every face, by its ends.
fn faces(mesh: &crate::mesh::Mesh, cells: std::ops::Range<usize>) -> BTreeMap<[usize; 2], (usize, usize)> {
    let of = |cell: usize| {
        (0..4).map(move |k| {
            let nodes = mesh.cell(cell);
            ([nodes[k].min(nodes[(k + 1) % 4]), nodes[k].max(nodes[(k + 1) % 4])], (cell, k))
        })
    };
    cells.flat_map(of).collect()
}

fn key(edge: &Edge) -> [usize; 2] {
    [edge[0].min(edge[1]), edge[0].max(edge[1])]
}
