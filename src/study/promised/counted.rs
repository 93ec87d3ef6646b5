//! How far bars count on differences between meshes: random scenes of closed form, none of those that judge the bars. A
//! claim derives the constants from them.

use serde::{Deserialize, Serialize};

use super::bars::{self, ROUND_OFF};
use crate::accuracy::counted::{Kind, Row};
use crate::error::Error;
use crate::study::random::Site;
use crate::study::random::family::JUDGED;
use crate::study::records::{Millionths, Survey};

/// The survey.
pub const SURVEY: Survey<Site, Record> = Survey {
    name: "counted",
    head: || COLUMNS.map(String::from).into(),
    sites: || Ok(JUDGED.iter().flat_map(|&family| (1..=EACH).map(move |number| Site { family, number })).collect()),
    key: Site::key,
    of: |record| record.site.key(),
    run: record,
};

/// Scenes of a family: five of each cells, element, and way to end.
pub const EACH: usize = 90;

const COLUMNS: [&str; 8] = ["family", "number", "kind", "ends_at_candidates", "error", "apart", "hidden", "rest"];

/// A number of a scene, over the size of such a number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The scene.
    pub site: Site,
    kind: Kind,
    ends_at_candidates: bool,
    /// True error.
    pub error: Millionths,
    /// Worst difference to a coarser mesh over `r^q − 1`.
    pub apart: Millionths,
    /// Element over contact, `(h/a)^s`.
    pub hidden: Millionths,
    /// What the bar holds besides.
    pub rest: Millionths,
}

impl Record {
    /// What it is counted on as.
    pub fn row(&self) -> Row {
        Row::of(self.kind, bars::element(self.site.number), bars::order(self.site.number), self.ends_at_candidates)
    }
}

/// The numbers of a scene that a bar holds an estimate of, but for those whose error is round-off.
fn record(site: &Site) -> Result<Vec<Record>, Error> {
    let each = bars::barred(site)?.into_iter().filter_map(|(one, error, size)| {
        let told = one.told?;
        let rest = told.rest + one.bar.iteration + one.bar.penalty;
        let over = |value: f64| Millionths(value / size);
        let is_told = told.bar().is_finite() && rest.is_finite() && error.is_finite() && error > ROUND_OFF * size;
        is_told.then(|| Record {
            site: *site,
            kind: told.row.kind,
            ends_at_candidates: told.row.ends_at_candidates,
            error: over(error),
            apart: over(told.apart),
            hidden: over(told.hidden),
            rest: over(rest),
        })
    });
    Ok(each.collect())
}
