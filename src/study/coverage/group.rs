//! What some errors and bars say together.

use crate::measure::larger;
use crate::study::coverage::run::Record;

/// Errors below are round-off, which no bar needs to follow.
const ROUND_OFF: f64 = 1e-7;
/// Nodes of a cell.
pub const CELLS: [usize; 2] = [4, 8];

/// Some numbers of the record.
pub struct Group<'a> {
    /// The numbers.
    pub records: Vec<&'a Record>,
}

impl<'a> Group<'a> {
    /// Those that are meant.
    pub fn of(records: &'a [Record], is_meant: impl Fn(&Record) -> bool) -> Self {
        Self { records: records.iter().filter(|record| is_meant(record)).collect() }
    }

    /// Share of the errors within so many bars; one that is not known is outside, NaN of none.
    pub fn within(&self, bars: f64) -> f64 {
        let inside = self.records.iter().filter(|record| record.error <= bars * record.bar).count();
        inside as f64 / self.records.len() as f64
    }

    /// Those whose error is more than round-off.
    pub fn above_round_off(&self) -> impl Iterator<Item = &'a Record> {
        self.records.iter().copied().filter(|record| record.error > ROUND_OFF)
    }

    /// Median of bar over error, of errors above round-off; NaN where there is none.
    pub fn median(&self) -> f64 {
        let mut ratios: Vec<f64> = self.above_round_off().map(|record| record.bar / record.error).collect();
        ratios.sort_by(f64::total_cmp);
        ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN)
    }

    /// Largest error over its bar, of the bars that are known.
    pub fn worst(&self) -> f64 {
        let known = self.records.iter().filter(|record| !record.bar.is_nan());
        known.map(|record| record.error / record.bar).fold(0.0, larger)
    }

    /// How many bars are not known.
    pub fn unknown(&self) -> usize {
        self.records.iter().filter(|record| record.bar.is_nan()).count()
    }
}
