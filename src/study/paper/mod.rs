//! The paper: what it says of iterations, what it leaves open, misprints. It leaves open how stiffnesses are changed, what has one,
//! when a run ends and when it is given up: its sentences are held against the reading nearest to its text, every single departure
//! from it, and a few pairs. Above 400 lines, so a folder; the report puts the judged statements in front, which need the findings of
//! other studies too.
//!
//! * `reading` — one choice on every axis; the designed set.
//! * `sentence` — what the paper says, and whether it holds.
//! * `statement` — iterations from every start, and when each criterion would have stopped them; which departures flip a sentence,
//!   and what is made of it.
//!
//! Below are the page, and its prose whose numbers come from the code: misprints, decisions where the paper is silent, what is not
//! covered, sources.

pub mod reading;
pub mod sentence;
pub mod statement;

use crate::case::library::{Cylinder, PinRod};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::solve::{Element, Formulation, Iteration, LIMITS, Settings};
use crate::study::about::{About, Found, Planned, Study};
use reading::Reading;
use sentence::{GOOD, Met, STRONG};
use statement::{Course, Fared, starts};

/// What was run.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// Every start of every site of the designed set.
    pub courses: Vec<Course>,
}

impl Study for Numbers {
    const NAME: &'static str = "paper";
    const ABOUT: About = About {
        title: "The paper",
        asked: "What of János Égert's paper of 1999 is reproduced, and what had to be decided.",
        limits: "A reading that nobody thought of is not tried, and of departures together only a few pairs.",
    };

    fn plan() -> Vec<Planned<Self>> {
        let run = || Ok(Numbers { courses: statement::courses(&Reading::designed())? });
        vec![Planned::new("readings of the paper", "designed set", run)]
    }

    /// Whether a run that a criterion stops ends where the course of a run without it tells.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let Numbers { courses } = self;
        let stopped: Vec<&[Option<Met>; 2]> = courses.iter().flat_map(|course| &course.alone).collect();
        let is_told = |[told, own]: &[Option<Met>; 2]| match (told, own) {
            (Some(told), Some(own)) => told.iterations == own.iterations && (told.error - own.error).abs() <= SAME,
            (None, None) => true,
            _ => false,
        };
        let wrong = stopped.iter().filter(|pair| !is_told(pair)).count();
        let at = format!("of {}", stopped.len());
        let check = Check::at_most(
            Quantity::at("run that stops elsewhere than the course of one tells", at),
            Reference::own("runs of their own", 0.0),
            "the same iterations, stopped or not",
        );
        Ok(vec![check.judge(if stopped.iter().any(|pair| pair[1].is_some()) { wrong as f64 } else { f64::NAN })])
    }

    /// What is told of it besides its statements.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let own: Vec<String> =
            Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
        let readings: String = findings.iter().map(|found| readings(&found.numbers.courses)).collect();
        let sources: String = REFERENCES.iter().map(|item| format!("* {item}\n")).collect();
        Ok(format!(
            "The paper itself shows {} of the nine formulations: {}. The others are ours.\n\n\
             ## How it is read\n\n{readings}\
             ## Where it is silent\n\nThe figures of the paper are not at hand: none of its dimensions, loads or plotted values is known.\n\n{}\n\
             ## Misprints and gaps\n\n{}\n## Sources\n\n{sources}",
            own.len(),
            own.join(", "),
            open_points(),
            misprints(),
        ))
    }
}

/// Difference of two errors that is round-off.
const SAME: f64 = 1e-9;

/// The designed set, and which departures do not count.
fn readings(courses: &[Course]) -> String {
    let [departures, pairs] = [Reading::departures().len(), Reading::pairs().len()];
    let (starts, agreement) = (starts(), Fared::agreement(courses));
    format!(
        "The paper leaves open by which rule stiffnesses change (its reference 12), what has one, how thick layers are, how far the \
         candidates reach, its meshes, when a run has converged and when it is given up. The reading nearest to its text: {}. Beside it: \
         {departures} single departures, and {pairs} pairs of candidates that end where the contact does with another stop; with the tolerances that \
         each is judged at these are {} readings. {} courses from {} initial stiffnesses each, κ₀ = {:e} to {:e} by decades, tell of all of them. \
         Criteria are those that can be had without the discrete solution: the contact conditions (penetration, tension, pressure across a gap), \
         the residuals (change of displacements, penetration, tension), the change of displacements alone, the contact state alone.\n\n\
         A sentence holds where it does in both examples, with the elements and algorithms that the paper shows. Agreement is a peak \
         within {} % of the discrete solution whenever a run ends, a strong dependence {STRONG} times as many iterations from one start as \
         from another; constant stiffness can save a great deal where it takes {STRONG} times fewer operations than varying stiffness from \
         some start, kinematic load saves where it does from every start. Under a reading it holds where it \
         does at each tolerance; under one with another stop, at that.\n\n\
         Only departures under which every combination still agrees are counted: the paper's do, so that others are not the paper's. \
         Every combination is in good agreement with the exact solution (Figs 10, 14, 15) under the nearest reading: this {}; it {}.\n\n",
        Reading::nearest().name(),
        Reading::designed().len(),
        courses.len(),
        starts.len(),
        starts[0],
        starts[starts.len() - 1],
        100.0 * GOOD,
        agreement.at(),
        agreement.told(),
    )
}

/// Misprints and gaps of the paper, and what is read instead.
const MISPRINTS: [[&str; 3]; 11] = [
    ["§1", "V^A ∩ V^B = 0", "the empty set"],
    ["(1.1a)", "dV under the integral over A_t", "dA"],
    ["(1.1b)", "dV under the integral over A_c", "dA, as in its last integral"],
    ["(3.4)", "K_C2 + K_C3", "K_c0 + K_c1"],
    ["(3.9)", "Δq_i and Δf_i", "Δq_j and Δf_j"],
    ["(3.10)", "Δq_(j+1) in the last term", "Δq_(j−1)"],
    ["(3.11)", "Δf_0 on the right", "Δf: the load increment does not change within it"],
    ["§2, layer element", "refers to (1.1b)", "(2.2)"],
    ["§1", "A^A = A_c ∪ A_u", "A_c ∪ A_u ∪ A_t, as for body B"],
    ["(2.2)", "no (2.1) before it; k_t and G are left open", "as it stands; zero: frictionless"],
    [
        "(3.3), (3.5)",
        "the choice of K_cj is left to ref. [12], not at hand",
        "named rules: secant, correction, squared, step, doubling, literal, switching, penalty",
    ],
];

/// Table of misprints.
pub fn misprints() -> String {
    let columns: [Column<[&str; 3]>; 3] =
        [("where", |row| row[0].into()), ("printed", |row| row[1].into()), ("read as", |row| row[2].into())];
    markdown::columns(&columns, &MISPRINTS)
}

/// Decisions where the source is silent, and what each changes.
pub fn open_points() -> String {
    let (cylinder, rod) = (Cylinder::default(), PinRod::default());
    let settings = Settings::default();
    let of = |element, algorithm| Formulation::new(element, algorithm);
    let hard = of(Element::Node, Iteration::Kinematic).stiffness;
    let gauss = of(Element::Line, Iteration::Kinematic).stiffness;
    let soft = of(Element::Node, Iteration::Varying).stiffness;
    let bound = of(Element::Node, Iteration::Varying).leeway.bound;
    let layer = of(Element::Layer, Iteration::Varying).layer_thickness;
    let rows = [
        ["Dimensions of the cylinder".to_string(),
         format!("R = {} mm, E = {} MPa, ν = {}, a/R = {}, candidates up to {} a", cylinder.radius, cylinder.young, cylinder.poisson, cylinder.a_over_r, cylinder.stretch),
         "the model error against Hertz, shown by a/R".into()],
        ["Dimensions of the pin–rod".into(),
         format!("R = {} mm, c = {} mm, eye radius {} mm, shank {} mm wide up to {} mm, t = {} mm, F = {} N, candidates up to {:.0}°",
            rod.pin_radius, rod.clearance, rod.eye_outer_radius, rod.shank_width, rod.shank_end, rod.thickness, rod.force, rod.stretch.to_degrees()),
         "every curve of the pin–rod; the dimensionless family shows how".into()],
        ["The rigid end face of the shank".into(), "u_y common to all its nodes, u_x free".into(), "nothing at the eye (Saint-Venant)".into()],
        ["The rule that changes the stiffness".into(),
         format!("(a) secant, by no more than {bound} times an iteration, (b) correction, (c) its own switching; others selectable"),
         "whether and how fast (a) and (b) converge, as the readings show; unbounded, a stiff start raises every other Gauss point, which no node feels".into()],
        ["What has a stiffness".into(), "every contact point; `spring = \"element\"` gives one to every element".into(), "with one an element, the pressures of its points cannot differ as they shall".into()],
        ["Tangential dofs of external nodes".into(), "condensed with the interior ones: without friction they carry no force".into(), "nothing in the result; half the retained dofs".into()],
        ["Factorisations of constant stiffness".into(), "one a run; the paper says one an increment, whose K_c0 here stays".into(), "operations of runs in several increments".into()],
        ["Constant stiffness keeps forces".into(),
         "K_cj q in (3.10) is read as the change of the spring force p⁺ − p; the literal sum is the rule `literal`".into(),
         "only where that rule is chosen; *Where methods fail* has its runs".into()],
        ["Initial stiffness κ₀ = k_n ℓ/E*".into(),
         format!("(a), (b): {soft}; (c): {hard:e} with node elements, {gauss} with line and layer elements; as the program takes them, (c) with line and layer elements by the bodies; springs within {:e} … {:e} E*/ℓ", LIMITS[0], LIMITS[1]),
         "with line and layer elements, hard springs let an alternating pressure mode grow between Gauss points that no node feels".into()],
        ["Acceleration".into(),
         "none in the paper; as the program takes them, under their own rules, (a) Newton's method on ln k, (b) Newton's method on the carried forces, and their names say so".into(),
         "iterations only: *Where methods fail* has both side by side; the readings and the rates are of the paper's own".into()],
        ["Penetration of hard springs".into(),
         "(c): where p/k exceeds the tolerance at the stiffest spring, hard points carry their force over to the next iteration".into(),
         "tolerances below the stiffest spring's penetration can be reached; nothing at the default tolerance".into()],
        ["Quadrature of line and layer elements".into(),
         "Gauss, one point fewer than the edge has nodes; as many as nodes, and Lobatto, selectable".into(),
         "as many Gauss points as nodes over-constrain the edge: pressures are not unique (patch test) and oscillate".into()],
        ["Volume of the layer element".into(),
         "its strain across, w/t(ξ), does not change across: ∫ E ε² dV over the volume is ∫ (E/t) w² dA, the same rows".into(),
         "nothing: a layer of real thickness integrated over its volume is the element here, but for how it starts, k₀ = E/t".into()],
        ["Thickness of the layer element".into(),
         format!("t(ξ) = t₀ + g(ξ), t₀ = {layer} of the edge length; tangential parts of a wedge-shaped layer are dropped; t₀ alone where bodies interfere"),
         "its initial stiffness only: narrow gaps start stiff".into()],
        ["Areas of node elements on arcs".into(),
         "A_a = ∫ N_a (n·n_a) ds: a uniform pressure gives equal nodal pressures".into(),
         "without n·n_a corner and mid-side pressures differ by 0.3 Δ², Δ half the angle of an edge".into()],
        ["Load increments".into(), "increment n of N applies (n/N) f̂; the gap enters whole, once".into(), "nothing in the result; iterations".into()],
        ["When to stop".into(),
         format!("errors of peak, profile, width and approach against the discrete solution ≤ {}; at most {} iterations; contact conditions, residuals, change of displacements and contact state selectable", settings.tolerance, settings.max_iterations),
         "all iteration counts; stopped by another criterion, an answer is called converged only where its error is within the tolerance too".into()],
        ["Comparing profiles of different elements".into(),
         "means over the candidate edges".into(),
         "free of the alternating mode and of interpolation between different points".into()],
        ["Gap of the patch test".into(),
         "a uniform clearance q ℓ/E* between the blocks".into(),
         "the secant rule has a finite stiffness to find; without it its ceiling limits the penetration".into()],
        ["Load of the half cylinder".into(),
         "on the same horizontal line as on the quarter; on its upper arc shown beside it".into(),
         "terms of the order of (a/R)²".into()],
    ];
    let rows: Vec<Vec<String>> = rows.into_iter().map(Vec::from).collect();
    markdown::table(&["open in the paper", "decided", "what it changes"].map(String::from), &rows)
}

/// What is deliberately not covered.
pub const NOT_COVERED: [&str; 7] = [
    "friction",
    "three dimensions",
    "large sliding and large deformation: areas, normals and gaps belong to the undeformed surface",
    "plasticity",
    "dynamics",
    "calibrated experiments: no measured pressure, load or width is at hand",
    "wall-clock times as requirements: seconds are recorded on one machine and shown, the suite judges errors and work counts only",
];

/// Sources.
pub const REFERENCES: [&str; 14] = [
    "J. Égert, Comparison of some contact elements and iterative algorithms for the solution of frictionless contact problems, 1999 (the paper).",
    "K. L. Johnson, Contact Mechanics, Cambridge 1985, §4.2 (Hertz line contact); interior stresses after McEwen 1949.",
    "B. G. A. Persson 1964; M. Ciavarella, P. Decuzzi, Int. J. Solids Struct. 38, 2001 (pin in a hole; re-derived, originals not at hand).",
    "G. Lamé (press fit of rings, any textbook on elasticity).",
    "J. T. Stadter, R. O. Weiss, Analysis of contact through finite element gaps, Comput. & Struct. 10, 1979 (secant rule).",
    "G. Drouet, P. Hild 2015; Z. Belhachmi, F. Ben Belgacem 2003 (orders of convergence in contact).",
    "P. J. Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids Eng. 116, 1994.",
    "K. J. Bathe, Finite Element Procedures, Prentice Hall 1996 (elements); J. Barlow, Int. J. Numer. Meth. Eng. 10, 1976 (stress points).",
    "T. Gustafsson, G. D. McBain, scikit-fem: A Python package for finite element assembly, J. Open Source Softw. 5, 2020.",
    "I. A. Baratta et al., DOLFINx: the next generation FEniCS problem solving environment, 2023.",
    "A. George, Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10, 1973.",
    "P. R. Amestoy, T. A. Davis, I. S. Duff, An approximate minimum degree ordering algorithm, SIAM J. Matrix Anal. Appl. 17, 1996.",
    "S. El Kazdadi, faer: a linear algebra library for Rust (sparse and dense Cholesky factorisations).",
    "R. Gaertner, Investigation of plane elastic contact allowing for friction, Comput. & Struct. 7, 1977, 59–63 (not at hand).",
];
