//! Which check of one record is which of another: by its key, or, where that was changed, by its numbers.

use std::collections::BTreeMap;

use super::words::differ;
use crate::report::record::CheckRow;

/// A check before and after.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    /// Before.
    pub before: &'a CheckRow,
    /// After.
    pub after: &'a CheckRow,
}

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
        for after in after {
            match left.remove(&after.key()) {
                Some(before) => pairs.both.push(Pair { before, after }),
                None => pairs.came.push(after),
            }
        }
        pairs.gone = left.into_values().collect();
        // First those of the same tolerance, then those that were renamed and loosened at once.
        pairs.rename(|pair| alike(pair) && !differ(pair.before.tolerance, pair.after.tolerance));
        pairs.rename(alike);
        pairs.both.extend(pairs.renamed.clone());
        pairs
    }

    /// Matches what is left over, those with the most parts of the key in common first.
    fn rename(&mut self, is_one: impl Fn(&Pair) -> bool) {
        let mut found: Vec<(usize, Pair)> = Vec::new();
        for &before in &self.gone {
            let all = self.came.iter().map(|&after| Pair { before, after }).filter(&is_one);
            found.extend(all.map(|pair| (pair.parts_kept(), pair)).filter(|(kept, pair)| *kept >= pair.parts_needed()));
        }
        found.sort_by_key(|(kept, _)| std::cmp::Reverse(*kept));
        for (_, pair) in found {
            let is_left = |rows: &[&CheckRow], row: &CheckRow| rows.iter().any(|one| std::ptr::eq(*one, row));
            if is_left(&self.gone, pair.before) && is_left(&self.came, pair.after) {
                self.gone.retain(|one| !std::ptr::eq(*one, pair.before));
                self.came.retain(|one| !std::ptr::eq(*one, pair.after));
                self.renamed.push(pair);
            }
        }
    }
}

impl Pair<'_> {
    fn parts_kept(&self) -> usize {
        self.before.key().iter().zip(self.after.key()).filter(|(old, new)| **old == *new).count()
    }

    /// Numbers that many checks have tell nobody apart.
    fn parts_needed(&self) -> usize {
        let says = |x: f64| x.is_finite() && x.fract().abs() > 0.0;
        KEPT[usize::from(!says(self.after.value) && !says(self.after.error))]
    }

    /// Whether any of its numbers moved.
    pub fn moved(&self) -> bool {
        let numbers = |row: &CheckRow| [row.value, row.reference, row.error];
        numbers(self.before).into_iter().zip(numbers(self.after)).any(|(old, new)| differ(old, new))
    }
}

/// The same numbers, held in the same way.
fn alike(pair: &Pair) -> bool {
    let (before, after) = (pair.before, pair.after);
    !pair.moved() && before.kind == after.kind && before.relation == after.relation && before.verdict == after.verdict
}
