//! Which check of one record is which of another: by its key, or, where that was changed, by its numbers.

use std::cmp::Reverse;
use std::ptr;

use crate::report::grouped::joined;
use crate::report::record::CheckRow;

/// A check before and after.
pub type Pair<'a> = [&'a CheckRow; 2];

/// The checks of two records, matched.
#[derive(Clone, Debug, Default)]
pub struct Pairs<'a> {
    /// In both, renamed ones too.
    pub both: Vec<Pair<'a>>,
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
        let all = joined([before, after].map(|rows| rows.iter().map(|row| (row.key(), row))));
        let mut pairs = Self {
            both: all.values().filter_map(|[old, new]| Some([(*old)?, (*new)?])).collect(),
            gone: all.values().filter_map(|[old, new]| old.filter(|_| new.is_none())).collect(),
            came: all.values().filter_map(|[old, new]| new.filter(|_| old.is_none())).collect(),
        };
        pairs.rename();
        pairs
    }

    /// Matches what is left over: first those of the same tolerance, then those that were renamed and loosened at once; of these
    /// those with the most parts of the key in common first.
    fn rename(&mut self) {
        let all = self.gone.iter().flat_map(|&old| self.came.iter().map(move |&new| [old, new]));
        let mut found: Vec<Pair> = all.filter(|one| is_alike(one) && parts_kept(one) >= parts_needed(one)).collect();
        found.sort_by_key(|one| Reverse((!differ(one.map(|row| row.tolerance)), parts_kept(one))));
        for pair in found {
            let place = |rows: &[&CheckRow], row: &CheckRow| rows.iter().position(|one| ptr::eq(*one, row));
            if let (Some(gone), Some(came)) = (place(&self.gone, pair[0]), place(&self.came, pair[1])) {
                self.gone.remove(gone);
                self.came.remove(came);
                self.both.push(pair);
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

/// Whether two numbers of a record differ; what is no number is like what is no number.
pub fn differ([before, after]: [f64; 2]) -> bool {
    before.to_bits() != after.to_bits() && !(before.is_nan() && after.is_nan())
}
