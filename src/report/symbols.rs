//! The page of symbols, which every page links.

use crate::markdown::{self, Column};
use crate::report::links;
use crate::study::Finding;
use crate::study::promised::{self, bars};

/// Name of the file.
pub const FILE: &str = "symbols.md";

/// Symbols with what they stand for.
pub const SYMBOLS: [[&str; 2]; 30] = [
    [
        "κ₀ = k ℓ/E*",
        "initial stiffness k of the contact springs per area, made a pure number by the length ℓ of the scene \
        (Hertz's half-width, or the radius of the pin) and the contact modulus E* (1/E* = Σ (1−ν²)/E in plane strain, \
        Σ 1/E in plane stress)",
    ],
    ["κ = k ℓ/E*", "the same of any spring"],
    ["k₀, k*", "spring stiffness at the start and at the end"],
    ["K₀, K*, S", "the matrices of these springs; that of the bodies as the contact sees them"],
    ["w, g, p", "approach, initial gap and pressure of a contact point; h = g − w what remains of the gap"],
    ["n_a, A_a", "unit normal and area of a contact node; N_a its shape function, n the normal beside it"],
    [
        "C",
        "how far the approaches of contact points follow their pressures, of the bodies with the springs of the start",
    ],
    ["k_b", "what both bodies resist at a contact point, over its area, while its neighbours stay"],
    [
        "f̂, q",
        "loads, condensed to the displacements of contact nodes; in the paper q is these displacements, in the patch \
        test the pressure",
    ],
    ["p₀", "largest pressure"],
    ["a", "half-width of the contact"],
    ["ε", "half-angle of the contact"],
    ["θ, φ", "angle from the load line, of the pin in the rod and of the one in the wide plate"],
    ["s", "contact coordinate: a length along the path, an angle on an arc"],
    ["second-moment width", "half-width of the semi-ellipse that has the second moment of the pressure"],
    ["by counting", "half-width by the lengths, or areas, that belong to the contact points that press"],
    ["last active point", "where the last stretch of contact points that press ends"],
    ["E, ν", "Young's modulus and Poisson's ratio"],
    ["ℓ, E*", "length and modulus that κ is told by, see there"],
    ["ρ", "rate of convergence: the factor on the error from one iteration to the next"],
    ["R", "radius"],
    ["L", "how far candidates reach"],
    ["h/a, t₀/h", "h the size of an element wherever it stands beside another length"],
    ["F, t, c", "load, thickness, clearance"],
    ["L2(p)", "error of the pressure profile, relative in the L2 norm"],
    ["u, u/g", "displacement, and the same over the gap"],
    [
        "±",
        "error bar: an estimate of what a value may be off; *What is promised* counts how many hold. Of a standard \
        uncertainty it is twice that. No bound",
    ],
    ["… to …", "range: the least and the largest of what was found"],
    ["u_val", "standard uncertainty, from all sources, of the difference of two values (ASME V&V 20)"],
    ["dofs", "degrees of freedom"],
];

/// How many error bars hold in the survey of true errors; nothing where it is not among the findings.
fn held(findings: &[Finding]) -> String {
    let surveyed = findings.iter().find_map(|finding| match finding.numbers() {
        Some(promised::Numbers::Bars(recorded)) => Some(bars::meant(recorded, |_, _| true)),
        _ => None,
    });
    let told = |numbers: Vec<[f64; 2]>| {
        format!(
            "\nOf {} true errors of random scenes {} % lie within their error bar; where that is not known they count \
            as outside.\n",
            numbers.len(),
            markdown::significant(100.0 * bars::share_within(&numbers, 1.0), 3)
        )
    };
    surveyed.map_or_else(String::new, told)
}

/// The page.
pub fn page(findings: &[Finding]) -> String {
    let columns: [Column<[&str; 2]>; 2] =
        [("symbol", |[symbol, _]| (*symbol).into()), ("what it stands for", |[_, what]| (*what).into())];
    let table = markdown::columns(&columns, &SYMBOLS);
    links::page("Symbols", "What letters stand for on every page.", &[], &(table + &held(findings)))
}
