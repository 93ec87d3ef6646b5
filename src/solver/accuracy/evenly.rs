//! Several contacts, and bodies whose mesh is given.
//!
//! Cells that are given are cut both ways, and so is all of the mesh beside them. Where all bodies are meshed here, the
//! elements on the contacts are made smaller by any ratio and the growth follows them, which needs far fewer cells.

use crate::accuracy::fitted;
use crate::accuracy::longest::longest;
use crate::accuracy::rungs::Rungs;
use crate::error::{Error, Kind, Place};
use crate::mesh::size::expected;
use crate::mesh::{Order, Resolution};
use crate::scene::{ContactPair, Grading, Scene, Shape};
use crate::solve::run::Run;

/// Elements of the first mesh on the shortest candidate stretch, then on the shortest half-contact.
const FIRST: usize = 4;
/// Growth of the first mesh along the surface and into the depth, and the coarsest element over the body.
const GROWTH: [f64; 3] = [1.7, 1.6, 0.3];
/// Candidates over a half-contact that has been found.
const MARGIN: f64 = 1.25;
/// By how much candidates are lengthened where the contact reaches their end.
const LONGER: f64 = 1.5;
/// Cells of a mesh that only looks where the contacts end.
const CHEAP: f64 = 1e4;
/// Elements in a contact from which on a mesh tells where it ends.
const TOLD: usize = 3;
/// First meshes.
const TRIES: usize = 48;

/// Whether the mesh of a scene is chosen in this way.
pub(super) fn applies(scene: &Scene) -> bool {
    scene.contacts.len() > 1 || scene.bodies.iter().any(|body| body.shape.has_given_mesh())
}

/// The scene on its first mesh: candidates as they are guessed, growth as usual, cells of the order that is given.
pub(super) fn first(scene: &Scene) -> (Scene, Resolution) {
    let mut first = scene.clone();
    let [along, depth, coarsest] = GROWTH;
    first.grading = Grading { unit: 1.0, along, depth, first: 1.0, coarsest, end: 1.0 };
    fit(&mut first, &densities(scene), 1.0);
    let given = scene.bodies.iter().find_map(|body| match &body.shape {
        Shape::Given(mesh) => Some(mesh.order()),
        _ => None,
    });
    (first, Resolution { elements: FIRST, refinement: 0, order: given.unwrap_or(Order::Quadratic) })
}

/// A family of such meshes.
pub(super) struct Evenly {
    /// With the candidates and the growth of the first mesh.
    scene: Scene,
    resolution: Resolution,
    /// Densities of the bodies as they were asked for.
    densities: Vec<f64>,
    /// Longest candidates of each contact.
    longest: Vec<f64>,
    /// Longest candidates of each contact that it was seen to reach the end of: on a given mesh they end with a cell.
    too_short: Vec<f64>,
}

impl Evenly {
    /// Finds where the contacts end on cheap meshes, and lays out candidates for them.
    pub(super) fn found(scene: &Scene, rungs: &mut Rungs) -> Result<Self, Error> {
        let longest = scene.contacts.iter().map(|pair| longest(scene, pair)).collect();
        let too_short = vec![0.0; scene.contacts.len()];
        let densities = densities(scene);
        let (scene, resolution) = first(scene);
        let mut found = Self { scene, resolution, densities, longest, too_short };
        if found.given().all(|given| given) {
            return Ok(found);
        }
        for attempt in 0..TRIES {
            found.look_from_afar();
            let laid = found.laid(FIRST);
            if let Some(what) = rungs.too_large(&laid) {
                let remedy =
                    "guess the candidate stretches better, or give `elements` and `per` instead of the accuracy";
                return Err(Error::at(Place::Solve(found.scene.name.clone()), what, remedy));
            }
            match rungs.solve(laid, "contact length") {
                Err(error) if rungs.first.is_some() && rungs.is_refused(&error) => break,
                Err(error) if attempt + 1 == TRIES || !found.lengthens(&error) => return Err(error),
                Err(_) => {}
                Ok(solved) => {
                    let (_, rung) = rungs.first.insert(solved);
                    let stretches = |scene: &Scene| scene.contacts.iter().map(|pair| pair.stretch).collect::<Vec<_>>();
                    let before = stretches(&found.scene);
                    if found.fits(&rung.run) || stretches(&found.scene) == before {
                        break;
                    }
                }
            }
        }
        Ok(found)
    }

    /// A scene with the candidates that hold its contacts, and bodies of its own density.
    pub(super) fn held(&self, scene: &Scene) -> Scene {
        let mut held = self.scene.clone();
        held.bodies.iter_mut().zip(&scene.bodies).for_each(|(body, own)| body.density = own.density);
        held
    }

    /// Elements with which to begin: those of a given mesh, though nothing is coarser.
    pub(super) fn begins(&self, asked: f64) -> usize {
        if self.is_halved() { FIRST } else { fitted::elements(asked).max(FIRST) }
    }

    /// Whether its meshes are halved from a given one.
    pub(super) fn is_halved(&self) -> bool {
        self.given().any(|given| given)
    }

    /// Whether the mesh of each body is given.
    fn given(&self) -> impl Iterator<Item = bool> {
        self.scene.bodies.iter().map(|body| body.shape.has_given_mesh())
    }

    /// The scene with so many elements on the shortest half-contact; a given mesh is halved for as many.
    pub(super) fn laid(&self, elements: usize) -> (Scene, Resolution) {
        let (mut scene, Self { resolution, .. }) = (self.scene.clone(), self);
        let ratio = elements as f64 / resolution.elements as f64;
        if self.is_halved() {
            let refinement = ratio.log2().round().max(0.0) as u32;
            return (scene, Resolution { refinement, ..*resolution });
        }
        scene.grading = resolution.order.refined(&scene.grading, ratio);
        (scene, Resolution { elements, ..*resolution })
    }

    /// Lengthens the candidates guessed shortest, by which elements are sized, until a first mesh is a cheap one.
    fn look_from_afar(&mut self) {
        let length = |pair: &ContactPair| pair.stretch * pair.path.metric();
        while expected(&self.scene, self.resolution)[0] > CHEAP {
            let pairs = self.scene.contacts.iter_mut().zip(&self.longest);
            let may = pairs.filter(|(pair, longest)| pair.stretch < **longest * (1.0 - 1e-9));
            let Some((pair, longest)) = may.min_by(|(a, _), (b, _)| length(a).total_cmp(&length(b))) else { return };
            pair.stretch = (2.0 * pair.stretch).min(*longest);
            fit(&mut self.scene, &self.densities, 1.0);
        }
    }

    /// Fits the candidates of bodies that are meshed here to the contacts found; whether they are known well enough.
    fn fits(&mut self, run: &Run) -> bool {
        let mut known = true;
        for contact in 0..self.scene.contacts.len() {
            let pair = &mut self.scene.contacts[contact];
            let [begin, end] = fitted::ends(run, contact);
            let [pressed, _] = fitted::pressed(run, contact);
            let given = |body: usize| self.scene.bodies[body].shape.has_given_mesh();
            if pressed == 0 || pair.bodies().all(given) {
                continue;
            }
            let filled = fitted::is_filled(run, contact);
            let wanted = if filled { LONGER * pair.stretch } else { MARGIN * end.max(-begin) };
            known &= pressed >= TOLD || filled && pair.stretch >= self.longest[contact];
            if wanted > self.too_short[contact] {
                pair.stretch = wanted.min(self.longest[contact]);
            }
        }
        self.shorten_open(run);
        fit(&mut self.scene, &self.densities, MARGIN);
        let elements = self.resolution.elements as f64;
        for (pair, longest) in self.scene.contacts.iter_mut().zip(&self.longest) {
            let size = self.scene.grading.unit / (self.scene.bodies[pair.first].density * elements);
            let whole = (pair.stretch * pair.path.metric() / size - 1e-9).ceil() * size / pair.path.metric();
            pair.stretch = whole.min(*longest);
        }
        known
    }

    /// Gives contacts that are open candidates no longer than the shortest of those that press.
    fn shorten_open(&mut self, run: &Run) {
        let length = |pair: &ContactPair| pair.stretch * pair.path.metric();
        let presses = |contact: usize| fitted::pressed(run, contact)[0] > 0;
        let pressed = self.scene.contacts.iter().enumerate().filter(|(contact, _)| presses(*contact));
        let shortest = pressed.map(|(_, pair)| length(pair)).fold(f64::INFINITY, f64::min);
        for (contact, pair) in self.scene.contacts.iter_mut().enumerate() {
            if !presses(contact) && length(pair) > shortest {
                pair.stretch = shortest / pair.path.metric();
            }
        }
    }

    /// Lengthens the candidates of a contact that reaches their end; whether that is why a mesh was not solved.
    pub(super) fn lengthens(&mut self, error: &Error) -> bool {
        let (Kind::ContactBeyondCandidates { .. } | Kind::EmptyStretch) = error.kind else { return false };
        let Place::Contact { contact, .. } = error.place else { return false };
        let (pair, longest) = (&mut self.scene.contacts[contact], self.longest[contact]);
        let longer = pair.stretch < longest * (1.0 - 1e-9);
        self.too_short[contact] = self.too_short[contact].max(pair.stretch);
        pair.stretch = (LONGER * pair.stretch).min(longest);
        longer
    }
}

/// Gives all contacts of bodies that touch, directly or through others, elements of one size, that of the shortest of
/// them: nodes of both sides then face one another, and other bodies have the size that they need. The grading unit is
/// the longest of these lengths; candidates are `margin` times as long as what they are sized for. Bodies beside a
/// given mesh have elements no longer than its own there, and no shorter where their own nodes are those that press:
/// halving keeps the ratio of both, and the nodes of a coarser side show in the pressures of the finer one.
fn fit(scene: &mut Scene, asked: &[f64], margin: f64) {
    let groups = touching(scene);
    let shortest = |group: usize| {
        let own = scene.contacts.iter().filter(|pair| groups[pair.first] == group);
        own.map(|pair| pair.stretch * pair.path.metric()).fold(f64::INFINITY, f64::min) / margin
    };
    let coarsest = |group: usize| {
        let own = asked.iter().zip(&groups).filter(|(_, other)| **other == group);
        own.map(|(density, _)| *density).fold(f64::INFINITY, f64::min)
    };
    let unit = scene.contacts.iter().map(|pair| shortest(groups[pair.first])).fold(0.0, f64::max);
    // Bodies that a user made denser than the others they touch stay so.
    let density = |(body, group): (usize, &usize)| match shortest(*group) {
        length if length.is_finite() => asked[body] / coarsest(*group) * unit / length,
        _ => asked[body],
    };
    let densities: Vec<f64> = groups.iter().enumerate().map(density).collect();
    scene.bodies.iter_mut().zip(densities).for_each(|(body, density)| body.density = density);
    scene.grading.unit = unit;
    for pair in &scene.contacts {
        let [ours, given]: [Vec<usize>; 2] = [false, true].map(|is_given| {
            pair.bodies().filter(|body| scene.bodies[*body].shape.has_given_mesh() == is_given).collect()
        });
        if let ([ours], [given]) = (&ours[..], &given[..]) {
            let density = unit / (FIRST as f64 * edge(pair, &scene.bodies[*given].shape, pair.side(*given)));
            let body = &mut scene.bodies[*ours];
            body.density = if *ours == pair.first { density } else { body.density.max(density) };
        }
    }
}

/// Densities of the bodies of a scene.
fn densities(scene: &Scene) -> Vec<f64> {
    scene.bodies.iter().map(|body| body.density).collect()
}

/// Mean length of the edges of a mesh made elsewhere on a side, of those beside the candidates of a contact \[mm\]; NaN
/// where there are none.
fn edge(pair: &ContactPair, shape: &Shape, side: &str) -> f64 {
    let Shape::Given(mesh) = shape else { return f64::NAN };
    let (from, reach) = (pair.path.point(0.0), pair.stretch * pair.path.metric());
    let away = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let ends = |edge: &Vec<usize>| [edge[0], edge[1]].map(|node| mesh.points[node]);
    let is_beside = |[a, b]: &[[f64; 2]; 2]| away(from, *a).min(away(from, *b)) <= reach;
    let edges: Vec<f64> =
        mesh.boundaries.get(side).into_iter().flatten().map(ends).filter(is_beside).map(|[a, b]| away(a, b)).collect();
    edges.iter().sum::<f64>() / edges.len() as f64
}

/// For each body the first of those that it touches, directly or through others.
fn touching(scene: &Scene) -> Vec<usize> {
    let mut groups: Vec<usize> = (0..scene.bodies.len()).collect();
    for pair in &scene.contacts {
        let joined: Vec<usize> = pair.bodies().map(|body| groups[body]).collect();
        let first = joined.iter().copied().min().unwrap_or(0);
        groups.iter_mut().filter(|group| joined.contains(group)).for_each(|group| *group = first);
    }
    groups
}
