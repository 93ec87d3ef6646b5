//! Displacements of sides and points, and the approach of the two bodies of a contact.

use crate::elasticity::{point, quadrature, shape_functions};
use crate::error::Error;
use crate::mesh::Edge;
use crate::scene::{Action, Body, Component, ContactPair, Displaced, Load, Place, Scene, Support};
use crate::solve::Discretisation;

/// Gauss points of an edge: exact for straight ones of any order; the length of a curved one is no polynomial.
const EDGE_POINTS: usize = 8;

/// Nodes with their weights.
type Weights = Vec<(usize, f64)>;

impl Discretisation {
    /// Mean `∫ u t ds / ∫ t ds` over a side, t the thickness or 2πr, or `Σ N_a u_a` at a point \[mm\], of the
    /// displacement of every node.
    pub fn displaced(&self, displacement: &[[f64; 2]], of: &Displaced) -> Result<f64, Error> {
        let weights = match &of.at {
            Place::Boundary(name) => self.mean_over(self.mesh.boundary(&self.scene, of.body, name)?),
            Place::Point(at) => point::shapes_at(&self.scene, &self.mesh, of.body, *at)?,
        };
        let component = of.component.index();
        Ok(weights.iter().map(|&(node, weight)| weight * displacement[node][component]).sum())
    }

    /// `∫ N_a t ds / ∫ t ds`, edge by edge; on the axis of a body of revolution that of lengths.
    fn mean_over(&self, edges: &[Edge]) -> Weights {
        let rule = quadrature::gauss(EDGE_POINTS);
        let mut weights = Weights::new();
        let radial = self.scene.plane.radial();
        let radius = |node: usize| radial.map_or(0.0, |radial| self.mesh.points[node][radial].abs());
        let revolves = edges.iter().flatten().any(|&node| radius(node) > 0.0);
        for edge in edges {
            for &(xi, weight) in &rule {
                let (shapes, _, [dx, dy]) = shape_functions::on_edge(&self.mesh, edge, xi);
                let around = match revolves {
                    true => edge.iter().zip(&shapes).map(|(&node, (value, _))| value * radius(node)).sum(),
                    false => 1.0,
                };
                let length = weight * dx.hypot(dy) * around;
                weights.extend(edge.iter().zip(&shapes).map(|(&node, (value, _))| (node, value * length)));
            }
        }
        let length: f64 = weights.iter().map(|(_, weight)| weight).sum();
        weights.iter().map(|&(node, weight)| (node, weight / length)).collect()
    }

    /// Approach of the bodies of a contact \[mm\], positive where they have come nearer: how much more the upper
    /// (inner) body has moved down than the other one, each at the side by which it is pressed; a rigid one does not
    /// move.
    ///
    /// None where it is not defined ([`Scene::pressed_sides`]).
    pub fn approach(&self, displacement: &[[f64; 2]], contact: usize) -> Result<Option<f64>, Error> {
        let Some(sides) = self.scene.pressed_sides(contact) else { return Ok(None) };
        let pair = &self.scene.contacts[contact];
        let mut approach = 0.0;
        for side in &sides {
            let down = if (side.body == pair.first) == pair.above { -1.0 } else { 1.0 };
            approach += down * self.displaced(displacement, side)?;
        }
        Ok(Some(approach))
    }
}

impl Scene {
    /// Sides that carry a load, along each component of it that is known and not prescribed there.
    ///
    /// Concentrated forces are none: the displacement under them has no limit.
    pub fn loaded_sides(&self) -> Vec<Displaced> {
        let mut sides: Vec<Displaced> = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let loaded = body.loads.iter().flat_map(loaded);
            let all = loaded.map(|(at, component)| Displaced { body: index, at, component });
            for side in all.filter(|side| is_boundary(&side.at) && !is_prescribed(body, &side.at, side.component)) {
                if !sides.contains(&side) {
                    sides.push(side);
                }
            }
        }
        sides
    }

    /// Whether supports prescribe a displacement.
    pub fn prescribes(&self, of: &Displaced) -> bool {
        is_prescribed(&self.bodies[of.body], &of.at, of.component)
    }

    /// By which side each elastic body of a contact is pressed along the load line, which is vertical: the only place
    /// where a load or a support acts along y.
    ///
    /// None where a body has no such place, several of them, a point, or only the side that touches; and where all of
    /// them are fixed, so that nothing approaches.
    pub fn pressed_sides(&self, contact: usize) -> Option<Vec<Displaced>> {
        let pair = &self.contacts[contact];
        let sides = pair.bodies().map(|body| {
            let at = pressed_at(&self.bodies[body], pair, body)?;
            Some(Displaced { body, at, component: Component::Y })
        });
        let sides = sides.collect::<Option<Vec<_>>>()?;
        let is_fixed = |side: &Displaced| is_fixed(&self.bodies[side.body], &side.at);
        (!sides.iter().all(is_fixed)).then_some(sides)
    }
}

/// The only side of a body, but for that which touches, where something acts along y.
fn pressed_at(body: &Body, pair: &ContactPair, index: usize) -> Option<Place> {
    let loads = body.loads.iter().flat_map(loaded).filter(|(_, component)| *component == Component::Y);
    let supports = body.supports.iter().filter(|support| support.component == Component::Y);
    let mut all = loads.map(|(at, _)| at).chain(supports.map(|support| support.at.clone()));
    let only = all.next().filter(|first| all.all(|other| other == *first))?;
    let touches = Place::Boundary(pair.side(index).to_string().into());
    (is_boundary(&only) && only != touches).then_some(only)
}

/// Where a load acts, and along what; a field along both.
fn loaded(load: &Load) -> Vec<(Place, Component)> {
    let both = [Component::X, Component::Y];
    let along = |at: Place, vector: [f64; 2]| {
        let own = both.into_iter().filter(|component| vector[component.index()].abs() > 0.0);
        own.map(|component| (at.clone(), component)).collect()
    };
    match load {
        Load::OnSide { boundary, action, .. } => match action {
            Action::Uniform(vector) | Action::Total(vector) => along(Place::Boundary(boundary.clone()), *vector),
            Action::Field(_) | Action::Stress(_) => along(Place::Boundary(boundary.clone()), [1.0; 2]),
            // It turns its side: the mean displacement says nothing of that.
            Action::Moment(_) => Vec::new(),
        },
        Load::Force { at, force } => along(Place::Point(*at), *force),
        Load::RigidFace { boundary, component, .. } => vec![(Place::Boundary(boundary.clone()), *component)],
        Load::BodyForce(_) => Vec::new(),
    }
}

fn is_boundary(at: &Place) -> bool {
    matches!(at, Place::Boundary(_))
}

/// Whether a place is fixed along y.
fn is_fixed(body: &Body, at: &Place) -> bool {
    let holds =
        |support: &Support| support.at == *at && support.component == Component::Y && support.value.abs() <= 0.0;
    body.supports.iter().any(holds)
}

fn is_prescribed(body: &Body, at: &Place, component: Component) -> bool {
    body.supports.iter().any(|support| support.at == *at && support.component == component)
}
