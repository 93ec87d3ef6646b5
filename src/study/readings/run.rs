//! The record, and a fixed twentieth of its sites once more.

use rayon::prelude::*;
use serde::Serialize;

use crate::error::Error;
use crate::study::readings::NAME;
use crate::study::readings::course::{Record, Site};
use crate::study::readings::courses::Courses;
use crate::study::readings::map;
use crate::study::readings::trial::{self, Trial};
use crate::study::records;

/// One of so many sites is run again.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 3;

/// Readings that are tried on other meshes.
const TRIED: usize = 3;

/// The record, and a part of it run again.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Every start recorded.
    pub recorded: Vec<Record>,
    /// Those of the fixed part as they are now.
    pub fresh: Vec<Record>,
    /// The readings that fit the first example best, on other meshes.
    pub trials: Vec<Trial>,
}

/// The record with its recomputed part.
pub fn numbers() -> Result<Numbers, Error> {
    let recorded = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let again: Vec<Site> = Site::all().into_iter().skip(FIRST).step_by(OF).collect();
    let fresh = again.par_iter().map(Site::records).collect::<Result<Vec<_>, Error>>()?.concat();
    let best = trial::chosen(&map::all(&Courses::of(&recorded)), TRIED);
    Ok(Numbers { trials: trial::trials(&best)?, recorded, fresh })
}
