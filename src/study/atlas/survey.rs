//! The whole atlas, row by row; a survey that was interrupted resumes.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use rayon::prelude::*;

use crate::error::Error;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::point::{Ground, Site, share_ground};
use crate::study::atlas::record::{self, Record};
use crate::study::atlas::row::Row;

/// Rows of some planes by the mesh they share, in groups that also share their contact points.
pub fn sites(planes: &[Plane]) -> Vec<Vec<Vec<Row>>> {
    let mut sites: Vec<Vec<Row>> = Vec::new();
    for row in planes.iter().flat_map(|plane| plane.rows()) {
        match sites.iter_mut().find(|rows| rows[0].mesh() == row.mesh()) {
            Some(rows) => rows.push(row),
            None => sites.push(vec![row]),
        }
    }
    sites.into_iter().map(grounds).collect()
}

/// Neighbours that share their contact points.
fn grounds(rows: Vec<Row>) -> Vec<Vec<Row>> {
    let mut groups: Vec<Vec<Row>> = Vec::new();
    for row in rows {
        match groups.last_mut() {
            Some(group) if share_ground(&group[0], &row) => group.push(row),
            _ => groups.push(vec![row]),
        }
    }
    groups
}

/// Points of all planes.
pub fn size() -> usize {
    Plane::ALL.iter().map(|plane| plane.rows().len() * plane.stiffnesses().len()).sum()
}

/// Surveys planes and writes their records into a folder; `done` is told how many points more are ready.
///
/// Finished rows are kept in the folder `unfinished`, from which a survey that was broken off goes on.
pub fn survey(planes: &[Plane], unfinished: &Path, records: &Path, done: impl Fn(usize) + Sync) -> Result<(), Error> {
    let sites = sites(planes);
    let writing = Mutex::new(());
    sites.par_iter().try_for_each(|grounds| -> Result<(), Error> {
        // Entered by the first ground that is not finished: what was surveyed before needs no condensation.
        let site = OnceLock::new();
        grounds.par_iter().try_for_each(|rows| rows_of_a_ground(rows, &site, unfinished, &writing, &done))
    })?;
    for plane in planes {
        let found = kept(&file(unfinished, *plane));
        let points = plane.rows().into_iter().flat_map(|row| plane.stiffnesses().into_iter().map(move |k| (row, k)));
        let ordered: Vec<Record> =
            points.filter_map(|(row, k)| found.iter().find(|record| record.is_at(&row, k)).cloned()).collect();
        record::write(&file(records, *plane), &ordered)?;
    }
    Ok(())
}

/// The rows that are not yet kept, one after the other on their common ground.
fn rows_of_a_ground(
    rows: &[Row],
    site: &OnceLock<Result<Site, Error>>,
    unfinished: &Path,
    writing: &Mutex<()>,
    done: &(impl Fn(usize) + Sync),
) -> Result<(), Error> {
    let lock = || writing.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut ground = None;
    for row in rows {
        let (path, stiffnesses) = (file(unfinished, row.plane), row.plane.stiffnesses());
        let before = {
            let _alone = lock();
            kept(&path)
        };
        if stiffnesses.iter().all(|k| before.iter().any(|record| record.is_at(row, *k))) {
            done(stiffnesses.len());
            continue;
        }
        let ground = match &mut ground {
            Some(ground) => ground,
            none => none.insert(Ground::of(entered(site, row)?, row)?),
        };
        let mut fresh = Vec::new();
        for k in stiffnesses {
            fresh.push(ground.record(row, k)?);
            done(1);
        }
        let _alone = lock();
        record::write(&path, &[kept(&path), fresh].concat())?;
    }
    Ok(())
}

/// The site, condensed by whoever comes first.
fn entered<'a>(site: &'a OnceLock<Result<Site, Error>>, row: &Row) -> Result<&'a Site, Error> {
    site.get_or_init(|| Site::of(row)).as_ref().map_err(Error::clone)
}

/// Finished rows; a file that cannot be read holds none, and is surveyed again.
fn kept(path: &Path) -> Vec<Record> {
    record::points(path).unwrap_or_default()
}

fn file(folder: &Path, plane: Plane) -> PathBuf {
    folder.join(plane.name()).with_extension("csv")
}
