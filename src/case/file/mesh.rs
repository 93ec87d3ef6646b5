//! `[mesh]`: elements on a length, or an accuracy that chooses them.

use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;

use crate::accuracy::{self, Asked, KINKED, Quantity, UNKINKED};
use crate::case::file::Source;
use crate::case::file::tables::{GrowthTable, Keyed, Name, Number};
use crate::case::file::wanted::{self, HALF_WIDTH, SECOND_MOMENT_WIDTH};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::scene::{Body, Scene, Shape};

/// Elements up to which the default growth is as it is described; beyond, it follows them.
const USUAL: f64 = 16.0;

/// `[mesh]`: `elements` of the candidate stretch on every length `per`, or an `accuracy`; bodies whose mesh is given need
/// neither.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshTable {
    elements: Option<Spanned<usize>>,
    per: Option<Number>,
    order: Option<Spanned<u8>>,
    growth: Option<Spanned<Keyed<GrowthTable>>>,
    accuracy: Option<Name>,
    quantity: Option<Spanned<Vec<Name>>>,
}

impl MeshTable {
    /// The length that holds the elements; where an accuracy chooses the mesh, any: the stretch as it is written.
    pub(super) fn per<'a>(&'a self, stretch: &'a Number) -> Option<&'a Number> {
        if self.accuracy.is_some() { Some(stretch) } else { self.per.as_ref() }
    }

    /// How the mesh grows, where it is said.
    pub(super) fn growth(&self) -> Option<&GrowthTable> {
        self.growth.as_ref().map(|growth| &**growth.get_ref())
    }

    /// What is asked; none where the mesh is given.
    pub(super) fn asked(&self, source: Source) -> Result<Option<Asked>, Error> {
        let Some(accuracy) = &self.accuracy else {
            return match &self.quantity {
                None => Ok(None),
                Some(quantity) => Err(source.refused(
                    quantity.span(),
                    "`quantity` without `accuracy`",
                    "leave it out, or give `accuracy`",
                )),
            };
        };
        let given = [
            ("elements", self.elements.as_ref().map(Spanned::span)),
            ("per", self.per.as_ref().map(Spanned::span)),
            ("order", self.order.as_ref().map(Spanned::span)),
            ("growth", self.growth.as_ref().map(Spanned::span)),
        ];
        if let Some((key, Some(place))) = given.into_iter().find(|(_, place)| place.is_some()) {
            let remedy = format!("leave `{key}` out, or `accuracy`");
            return Err(source.refused(place, format!("`{key}` cannot be used: `accuracy` chooses the mesh"), remedy));
        }
        let relative = accuracy::percentage(accuracy.get_ref()).map_err(|expected| {
            let message = format!("`accuracy` is \"{}\", but {expected}", accuracy.get_ref());
            source.refused(accuracy.span(), message, accuracy::remedy())
        })?;
        let mut asked = Asked::new(relative);
        if let Some(list) = &self.quantity {
            let known = [
                ("peak-pressure", Quantity::PeakPressure),
                (HALF_WIDTH, Quantity::HalfWidth),
                (SECOND_MOMENT_WIDTH, Quantity::SecondMomentWidth),
            ];
            let names = list.get_ref().iter().map(|name| {
                wanted::refuse_old(source, name)?;
                source.choice("quantity with an accuracy", name, &known)
            });
            asked.quantities = names.collect::<Result<_, _>>()?;
            if asked.quantities.is_empty() {
                return Err(source.refused(
                    list.span(),
                    "no `quantity` is named",
                    "name one, or leave it out for both",
                ));
            }
        }
        Ok(Some(asked))
    }

    /// Scene and mesh: those given, or the first ones of the search for an accuracy; `place` is that of the table.
    pub(super) fn resolution(
        &self,
        source: Source,
        place: &Range<usize>,
        scene: Scene,
    ) -> Result<(Scene, Resolution), Error> {
        let brought = |body: &Body| body.shape.has_given_mesh();
        if let Some(accuracy) = &self.accuracy {
            if scene.contacts.iter().any(|pair| !pair.profile.kinks().is_empty()) {
                return Err(source.refused(accuracy.span(), KINKED, UNKINKED));
            }
            // Refuses given meshes of several orders.
            self.order(source, place, &scene)?;
            return Ok(accuracy::first(&scene));
        }
        let needed = scene.bodies.iter().any(|body| !brought(body));
        let unused = [
            ("elements", self.elements.as_ref().map(Spanned::span)),
            ("per", self.per.as_ref().map(Spanned::span)),
            ("growth", self.growth.as_ref().map(Spanned::span)),
        ];
        if let Some((key, Some(place))) = unused.into_iter().find(|(_, place)| !needed && place.is_some()) {
            let message = format!("`{key}` cannot be used: the meshes of all bodies are given");
            return Err(source.refused(place, message, "leave it out, and refine those meshes"));
        }
        let missing = |key: &str| {
            let remedy = "give `elements` and `per`, or an `accuracy` that chooses the mesh";
            Err(source.refused(place.clone(), format!("missing field `{key}`"), remedy))
        };
        let elements = match &self.elements {
            Some(given) if !(1..=4096).contains(given.get_ref()) => {
                let message = format!("`elements` is {}", given.get_ref());
                return Err(source.refused(given.span(), message, "give 1 to 4096; 8 to 32 are usual"));
            }
            Some(given) => *given.get_ref(),
            None if needed => return missing("elements"),
            None => 1,
        };
        if needed && self.per.is_none() {
            return missing("per");
        }
        let order = self.order(source, place, &scene)?;
        let mut scene = scene;
        if self.growth.is_none() {
            scene.grading = order.refined(&scene.grading, elements as f64 / USUAL);
        }
        Ok((scene, Resolution { elements, refinement: 0, order }))
    }

    /// The order asked for, else that of a mesh that is given; refuses meshes of another one.
    fn order(&self, source: Source, place: &Range<usize>, scene: &Scene) -> Result<Order, Error> {
        let given = scene.bodies.iter().filter_map(|body| match &body.shape {
            Shape::Given(mesh) => Some(mesh.order()),
            _ => None,
        });
        let given: Vec<Order> = given.collect();
        let order = match self.order.as_ref().map(|order| (*order.get_ref(), order.span())) {
            None => given.first().copied().unwrap_or(Order::Quadratic),
            Some((number, place)) => Order::numbered(number.into()).ok_or_else(|| {
                let remedy = "give 1 for 4-node or 2 for 8-node cells, or 4 to 8 for cells of high order";
                source.refused(place, format!("`order` is {number}"), remedy)
            })?,
        };
        let Some(other) = given.iter().find(|given| **given != order) else { return Ok(order) };
        let [own, others] = [other, &order].map(|order| order.nodes_per_cell());
        let message = format!("a mesh has cells of {own} nodes, others have {others}");
        let place = self.order.as_ref().map_or(place.clone(), Spanned::span);
        Err(source.refused(place, message, "mesh all bodies with one order, and leave `order` out or give the same"))
    }

    /// Where a mesh that is too large was asked for; `table` is the place of the table.
    pub(super) fn place(&self, table: &Range<usize>) -> Range<usize> {
        let elements = self.elements.as_ref().map(Spanned::span);
        elements.or_else(|| self.accuracy.as_ref().map(Spanned::span)).unwrap_or(table.clone())
    }
}
