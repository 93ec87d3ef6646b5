//! `[mesh]`: elements on a length, or an accuracy that chooses them.

use serde::Deserialize;
use toml::Spanned;

use crate::case::accuracy::{self, Asked, Quantity, fitted::Plan, search::FIRST};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::scene::file::Source;
use crate::scene::file::tables::{GrowthTable, Name, Number};

/// `[mesh]`: `elements` of the candidate stretch on every length `per`, or an `accuracy`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshTable {
    elements: Option<Spanned<usize>>,
    per: Option<Number>,
    order: Option<Spanned<u8>>,
    growth: Option<Spanned<GrowthTable>>,
    accuracy: Option<Name>,
    quantity: Option<Spanned<Vec<Name>>>,
}

impl MeshTable {
    /// The length that holds the elements; where an accuracy chooses the mesh, any: the stretch as it is written.
    pub(super) fn per<'a>(
        &'a self,
        source: Source,
        table: &Spanned<Self>,
        stretch: &'a Number,
    ) -> Result<&'a Number, Error> {
        let missing = |key: &str| {
            let remedy = "give `elements` and `per`, or an `accuracy` that chooses the mesh";
            source.refused(table.span(), format!("missing field `{key}`"), remedy)
        };
        match (&self.accuracy, &self.elements, &self.per) {
            (Some(_), _, _) => Ok(stretch),
            (None, None, _) => Err(missing("elements")),
            (None, _, None) => Err(missing("per")),
            (None, Some(_), Some(per)) => Ok(per),
        }
    }

    /// How the mesh grows, where it is said.
    pub(super) fn growth(&self) -> Option<&GrowthTable> {
        self.growth.as_ref().map(Spanned::get_ref)
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
            return Err(source.refused(place, format!("`accuracy` chooses the mesh, and `{key}` too"), remedy));
        }
        let Some(relative) = accuracy::percentage(accuracy.get_ref()) else {
            let message = format!("`accuracy` is \"{}\"", accuracy.get_ref());
            return Err(source.refused(accuracy.span(), message, accuracy::remedy()));
        };
        let mut asked = Asked::new(relative);
        if let Some(list) = &self.quantity {
            let known = Quantity::ALL.map(|quantity| (quantity.name(), quantity));
            let names = list.get_ref().iter().map(|name| source.choice("quantity with an accuracy", name, &known));
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

    /// Scene and mesh: those given, or the first ones of the search for an accuracy.
    pub(super) fn resolution(&self, source: Source, scene: Scene) -> Result<(Scene, Resolution), Error> {
        let Some(given) = &self.elements else {
            let first = Plan::even(Order::Quadratic, FIRST, scene.contact.stretch, 0);
            return Ok((first.scene(&scene), first.resolution()));
        };
        let elements = *given.get_ref();
        if !(1..=4096).contains(&elements) {
            let message = format!("`elements` is {elements}");
            return Err(source.refused(given.span(), message, "give 1 to 4096; 8 to 32 are usual"));
        }
        let order = match self.order.as_ref().map(|order| (*order.get_ref(), order.span())) {
            Some((1, _)) => Order::Linear,
            Some((2, _)) | None => Order::Quadratic,
            Some((other, place)) => {
                let remedy = "give 1 for 4-node or 2 for 8-node cells";
                return Err(source.refused(place, format!("`order` is {other}"), remedy));
            }
        };
        Ok((scene, Resolution { elements, refinement: 0, order }))
    }

    /// Where a mesh that is too large was asked for.
    pub(super) fn place(&self) -> std::ops::Range<usize> {
        let elements = self.elements.as_ref().map(Spanned::span);
        elements.or_else(|| self.accuracy.as_ref().map(Spanned::span)).unwrap_or(0..0)
    }
}
