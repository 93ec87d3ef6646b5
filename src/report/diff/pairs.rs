//! Which check of one record is which of another: by its key, or, where that was changed, by its numbers.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ptr;

use super::words::differ;
use crate::report::record::CheckRow;

/// A check before and after.
pub type Pair<'a> = [&'a CheckRow; 2];

/// The checks of two records, matched.
#[derive(Clone, Debug, Default)]
pub struct Pairs<'a> {
    /// In both, renamed ones too.
    pub both: Vec<Pair<'a>>,
    /// Of these the renamed ones.
    pub renamed: Vec<Pair<'a>>,
    /// Before only.
    pub gone: Vec<&'a CheckRow>,
    /// After only.
    pub came: Vec<&'a CheckRow>,
}

/// Parts of a key that a renamed check keeps at least, and where its numbers say nothing.
const KEPT: [usize; 2] = [2, 5];

impl<'a> Pairs<'a> {
    /// Matches two records.
    pub fn of(before: &'a [CheckRow], after: &'a [CheckRow]) -> Self {
        let mut left: BTreeMap<[&str; 6], &CheckRow> = before.iter().map(|row| (row.key(), row)).collect();
        let mut pairs = Self::default();
        for new in after {
            match left.remove(&new.key()) {
                Some(old) => pairs.both.push([old, new]),
                None => pairs.came.push(new),
            }
        }
        pairs.gone = left.into_values().collect();
        // First those of the same tolerance, then those that were renamed and loosened at once.
        pairs.rename(|pair| is_alike(pair) && !differ(pair.map(|row| row.tolerance)));
        pairs.rename(is_alike);
        pairs.both.extend(pairs.renamed.clone());
        pairs
    }

    /// Matches what is left over, those with the most parts of the key in common first.
    fn rename(&mut self, is_one: impl Fn(&Pair) -> bool) {
        let all = self.gone.iter().flat_map(|&old| self.came.iter().map(move |&new| [old, new]));
        let alike = all.filter(is_one).map(|pair| (parts_kept(&pair), pair));
        let mut found: Vec<(usize, Pair)> = alike.filter(|(kept, pair)| *kept >= parts_needed(pair)).collect();
        found.sort_by_key(|(kept, _)| Reverse(*kept));
        for (_, pair) in found {
            let place = |rows: &[&CheckRow], row: &CheckRow| rows.iter().position(|one| ptr::eq(*one, row));
            if let (Some(gone), Some(came)) = (place(&self.gone, pair[0]), place(&self.came, pair[1])) {
                self.gone.remove(gone);
                self.came.remove(came);
                self.renamed.push(pair);
            }
        }
    }
}

fn parts_kept([before, after]: &Pair) -> usize {
    before.key().iter().zip(after.key()).filter(|(old, new)| **old == *new).count()
}

/// Numbers that many checks have tell nobody apart.
fn parts_needed([_, after]: &Pair) -> usize {
    let says = |x: f64| x.is_finite() && x.fract().abs() > 0.0;
    KEPT[usize::from(!says(after.value) && !says(after.error))]
}

/// Whether any number of a check moved.
pub fn is_moved(pair: &Pair) -> bool {
    let numbers: [fn(&CheckRow) -> f64; 3] = [|row| row.value, |row| row.reference, |row| row.error];
    numbers.into_iter().any(|number| differ(pair.map(number)))
}

/// The same numbers, held in the same way.
fn is_alike(pair: &Pair) -> bool {
    let [before, after] = pair;
    !is_moved(pair) && before.kind == after.kind && before.relation == after.relation && before.verdict == after.verdict
}
