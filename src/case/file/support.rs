//! A support by the names under which its body lists it.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::{BodyTable, Keyed, Name, PlaceTable, SupportTable};
use crate::error::Error;

/// `support = { body = "…", at = "…", component = "…" }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SupportName {
    body: Name,
    at: Spanned<PlaceTable>,
    component: Name,
}

impl SupportName {
    /// Index of the body, and of the support in it; what does not exist is told with its line and what there is.
    pub(super) fn find(&self, source: Source, bodies: &[Keyed<BodyTable>]) -> Result<[usize; 2], Error> {
        let names: Vec<_> =
            bodies.iter().enumerate().map(|(index, body)| (body.name.get_ref().as_str(), index)).collect();
        let body = source.choice("body", &self.body, &names)?;
        let supports = &bodies[body].supports;
        let is_it = |support: &Keyed<SupportTable>| {
            support.at.get_ref() == self.at.get_ref() && support.component.get_ref() == self.component.get_ref()
        };
        supports.iter().position(is_it).map(|support| [body, support]).ok_or_else(|| {
            let shown = |at: &PlaceTable, component: &str| match at {
                PlaceTable::Boundary(name) => format!("`{name}` along {component}"),
                PlaceTable::Point(point) => format!("{point:?} along {component}"),
            };
            let known: Vec<String> =
                supports.iter().map(|support| shown(support.at.get_ref(), support.component.get_ref())).collect();
            let message = format!(
                "`{}` has no support at {}",
                self.body.get_ref(),
                shown(self.at.get_ref(), self.component.get_ref())
            );
            let remedy = if known.is_empty() { "it has none".into() } else { format!("known: {}", known.join(", ")) };
            source.refused(self.at.span(), message, remedy)
        })
    }
}
