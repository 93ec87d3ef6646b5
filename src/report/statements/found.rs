//! Look-ups in what was found.

use crate::case::judged::worst;
use crate::case::{Quantity, Verdict};
use crate::measure::larger;
use crate::solve::{Element, Iteration, Run};
use crate::study::readings::runs::Course;
use crate::study::{Finding, Numbers};

/// The findings of all studies.
pub struct Findings<'a>(pub &'a [Finding]);

impl<'a> Findings<'a> {
    /// Findings of a case.
    pub fn case(&self, case: &'a str) -> impl Iterator<Item = &'a Finding> + use<'a> {
        self.0.iter().filter(move |finding| finding.case == case)
    }

    /// Runs of a case.
    pub fn runs(&self, case: &'a str) -> Vec<&'a Run> {
        let run = |finding: &'a Finding| match &finding.numbers {
            Numbers::Cases(numbers) => Some(&numbers.run),
            _ => None,
        };
        self.case(case).filter_map(run).collect()
    }

    /// The run of a case by an element and algorithm.
    pub fn run(&self, case: &'a str, element: Element, algorithm: Iteration) -> Option<&'a Run> {
        self.runs(case).into_iter().find(|r| r.formulation.element == element && r.formulation.algorithm == algorithm)
    }

    /// Whether a case was run and every check of it passed.
    pub fn passes(&self, case: &'a str) -> bool {
        worst(self.case(case).flat_map(|finding| &finding.judged)) == Some(&Verdict::Pass)
    }

    /// Largest error of a quantity over all runs of a case; NaN where none was judged.
    pub fn error(&self, case: &'a str, quantity: &Quantity) -> f64 {
        let judged = self.case(case).flat_map(|finding| &finding.judged);
        let errors = judged.filter(|judged| judged.check.quantity == *quantity).map(|judged| judged.error);
        errors.reduce(larger).unwrap_or(f64::NAN)
    }

    /// The courses of the readings of the paper; none where they were not asked.
    pub fn readings(&self) -> Option<&'a [Course]> {
        self.0.iter().find_map(|finding| match &finding.numbers {
            Numbers::Readings(numbers) => Some(numbers.courses.as_slice()),
            _ => None,
        })
    }
}

/// The smallest and the largest of some numbers; NaN where one is.
pub fn extremes(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, 0.0], |[low, high], x| [-larger(-low, -x), larger(high, x)])
}
