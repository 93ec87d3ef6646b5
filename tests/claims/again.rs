//! What of recorded surveys is run again, and when that is as recorded.

use contact_vv::error::Error;
use contact_vv::study::grouped::sorted;
use contact_vv::study::promised::{bars, converged, counted, met};
use contact_vv::study::random::{Site, family};
use contact_vv::study::records::{Millionths, Survey, are_like};
use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A survey with what of it is run again.
pub struct Again<S, R> {
    /// The survey.
    pub survey: Survey<S, R>,
    /// Whether a site is run again.
    pub is_chosen: fn(&S) -> bool,
    /// Whether a fresh line is the recorded one.
    pub is_as_recorded: fn(&R, &R) -> bool,
}

impl<S: Sync + Send, R: Serialize + DeserializeOwned + Clone + Sync + Send> Again<S, R> {
    /// Runs the chosen part again: how many lines that are, and how many of them are not as recorded.
    pub fn recomputed(&self) -> Result<[usize; 2], Error> {
        let again: Vec<S> = (self.survey.sites)()?.into_iter().filter(self.is_chosen).collect();
        let run = |site: &S| Ok(((self.survey.key)(site), (self.survey.run)(site)?));
        let fresh = again.par_iter().map(run).collect::<Result<Vec<_>, Error>>()?;
        Ok(self.compared(&self.survey.read()?, &fresh))
    }

    /// A record held against sites run again, each by its name with its lines, in the order of the record: lines, and
    /// those that moved.
    pub fn compared(&self, recorded: &[R], fresh: &[(String, Vec<R>)]) -> [usize; 2] {
        let of_site = sorted(recorded.iter().map(|line| ((self.survey.of)(line), line)));
        let (mut again, mut moved) = (0, 0);
        for (site, fresh) in fresh {
            let kept = of_site.get(site).map_or(&[][..], Vec::as_slice);
            again += fresh.len().max(kept.len());
            moved += fresh.len().abs_diff(kept.len());
            moved += kept.iter().zip(fresh).filter(|(kept, fresh)| !(self.is_as_recorded)(kept, fresh)).count();
        }
        [again, moved]
    }
}

/// The cheapest of each kind of body, profile and load; outcome and iterations as recorded always, the error where it
/// is above round-off.
pub const CONVERGED: Again<converged::Site, converged::Record> = Again {
    survey: converged::SURVEY,
    is_chosen: |site| CHEAPEST.iter().any(|&(scene, stretch)| site.scene == scene && site.stretch == stretch),
    is_as_recorded: |kept, fresh| {
        let key = |record: &converged::Record| [record.load, record.tolerance].map(f64::to_bits);
        key(kept) == key(fresh)
            && kept.classes == fresh.classes
            && kept.iterations == fresh.iterations
            && are_like(&kept.errors, &fresh.errors, converged::ROUND_OFF * kept.tolerance)
    },
};

/// Scenes that are run again, each on a stretch.
const CHEAPEST: [(&str, f64); 22] = [
    ("truncated-hertz", 0.0),
    ("press-fit", 0.0),
    ("patch", 0.0),
    ("own-weight", 0.0),
    ("flat-punch", 0.0),
    ("eccentric-load.toml", 0.0),
    ("pressed-patch.toml", 0.0),
    ("load-approach.toml", 0.0),
    ("cylinder-half", 1.05),
    ("cylinder-between-plates", 1.05),
    ("cylinder-between-blocks.toml", 1.05),
    ("cylinder-on-block.toml", 1.05),
    ("hollow-circle.toml", 1.05),
    ("moment.toml", 1.05),
    ("rigid-cosine.toml", 1.05),
    ("rigid-pin.toml", 1.05),
    ("cylinder", 2.0),
    ("bars", 5.0),
    ("cylinder-to-accuracy.toml", 5.0),
    ("cylinder-to-accuracy.toml", 20.0),
    ("rings-to-accuracy.toml", 50.0),
    ("blocks.toml", 150.0),
];

/// Of each family of closed form the six chosen, of others, whose truth takes longer than the solution, one with cells
/// of either kind.
pub const BARS: Again<Site, bars::Record> = Again {
    survey: bars::SURVEY,
    is_chosen: |site| match family::JUDGED.contains(&site.family) {
        true => family::chosen(site.family).any(|one| one.number == site.number),
        false => (8..10).contains(&(site.number - family::FIRST)),
    },
    is_as_recorded: |kept, fresh| {
        kept.site == fresh.site
            && are_like(&kept.errors, &fresh.errors, bars::ROUND_OFF)
            && are_like(&kept.bars, &fresh.bars, bars::ROUND_OFF)
    },
};

/// One scene of each family.
pub const COUNTED: Again<Site, counted::Record> = Again {
    survey: counted::SURVEY,
    is_chosen: |site| site.number % counted::EACH == 1,
    is_as_recorded: |kept, fresh| {
        let numbers = |one: &counted::Record| [one.error, one.apart, one.hidden, one.rest].map(Some);
        kept.row() == fresh.row() && are_like(&numbers(kept), &numbers(fresh), bars::ROUND_OFF)
    },
};

/// One scene of each family to the first of the accuracies, of those of closed form in turn to that and the third, or
/// to the second and the fourth; mesh and verdict as recorded always, errors but for the iteration.
pub const MET: Again<(Site, f64), met::Record> = Again {
    survey: met::SURVEY,
    is_chosen: |(site, asked)| {
        let accuracies = match family::JUDGED.iter().position(|family| *family == site.family) {
            Some(turn) if turn % 2 == 1 => [met::ASKED[1], met::ASKED[3]],
            Some(_) => [met::ASKED[0], met::ASKED[2]],
            None => [met::ASKED[0]; 2],
        };
        site.number == family::FIRST + 10 && accuracies.contains(asked)
    },
    is_as_recorded: |kept, fresh| {
        let key = |record: &met::Record| (record.site, record.asked.to_bits());
        let found = |record: &met::Record| (record.met, record.dofs, record.most_dofs, record.dofs_in_all);
        let alike = |of: fn(&met::Record) -> Millionths| of(kept).is_like(of(fresh), ITERATED * kept.asked);
        let errors =
            [|one: &met::Record| one.estimate, |one: &met::Record| one.peak, |one: &met::Record| one.half_width];
        key(kept) == key(fresh) && found(kept) == found(fresh) && errors.into_iter().all(alike)
    },
};

/// Errors below this part of the one asked for may differ: they hang on the iteration.
const ITERATED: f64 = 0.01;
