//! What `uncertainty` means everywhere: a standard uncertainty u, one standard deviation, in the unit of its value.
//!
//! What a refinement series gives is a bound U that covers about 95 %. A bound is called one, and becomes a standard
//! uncertainty here and nowhere else: `u = U/k`, k = 2. ASME V&V 20-2009, section 2-4, leaves k between 1.15 (an error
//! distributed about the extrapolated value) and 2 (a normal error about the finest one); 2 gives the smallest u, and
//! hence the strictest comparison. Sources that are independent add as `√Σu²`; a known difference that is not corrected
//! for is a source, too (JCGM 100:2008, Guide to the expression of uncertainty, 5.1.2 and F.2.4.5).

/// Coverage factor k: two standard uncertainties cover about 95 % of a normal error (JCGM 100:2008, 6.3.3).
pub const COVERAGE: f64 = 2.0;

/// The standard uncertainty `U/k` of a bound U that covers about 95 %.
pub fn standard(bound: f64) -> f64 {
    bound / COVERAGE
}

/// Standard uncertainty `√Σu²` of independent sources; 0 of none.
pub fn combined(sources: impl IntoIterator<Item = f64>) -> f64 {
    sources.into_iter().map(|u| u * u).sum::<f64>().sqrt()
}

/// Two values of one quantity (ASME V&V 20-2009, 1-5): their difference, and the uncertainty of that.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Comparison {
    /// Comparison error `E = ours − theirs`, in the unit of the quantity.
    pub error: f64,
    /// Validation uncertainty `u_val = √(u_ours² + u_theirs² + u_input²)`, standard, in the same unit.
    pub uncertainty: f64,
}

impl Comparison {
    /// `ours − theirs`, with the standard uncertainties of all sources.
    pub fn of(ours: f64, theirs: f64, sources: impl IntoIterator<Item = f64>) -> Self {
        Self { error: ours - theirs, uncertainty: combined(sources) }
    }

    /// `|E|/u_val`; NaN, which no check passes, where either is not finite: an infinite uncertainty would cover
    /// anything.
    pub fn ratio(&self) -> f64 {
        if self.uncertainty.is_finite() { self.error.abs() / self.uncertainty } else { f64::NAN }
    }
}
