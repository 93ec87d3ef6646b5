//! The part of the chapter on where methods fail that holds predictions against measurements.

use crate::error::Error;
use crate::study::Found;
use crate::study::stability::{Numbers, tables};

/// A subsection for each prediction.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    Ok([
        FIXED_TARGET,
        &tables::fixed_target(findings),
        RATES,
        &tables::rates(findings),
        BEFORE,
        &tables::before(findings),
        FAILING,
        &tables::failing(findings),
        BASIN,
        &tables::basin(findings),
        HALVING,
        &tables::halving(findings),
    ]
    .concat())
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}

const FIXED_TARGET: &str = "## Constant stiffness towards fixed springs\n\n\
`(S + K₀) u⁺ = f̂ + (K₀ − K*) u` converges if and only if S + K* and S + 2K₀ − K* are positive definite: in effect k₀ ≥ k*/2. \
Softer springs diverge, stiffer ones crawl. The condition is known before the run for any given springs; those tried here carry the \
contact's own pressure without a gap, cut off at the κ* given, and are thus known *a posteriori*.\n\n";

const RATES: &str = "## Rates of constant and varying stiffness\n\n\
*A posteriori*: the asymptotic rate of an iteration is the spectral radius of its error's matrix on the final active set, made of the \
flexibility of the contact and of its springs, and needs the solved contact; – where too few iterations lie between the final active set \
and round-off. Truncated Hertz, contact edge between two nodes. Constant stiffness is also followed from its start as a linear iteration \
on that set, over the same errors: where the start hardly holds the slowest mode, round-off comes before that is alone, and by the \
linear iteration's own slope no spectral radius is to be measured there. Each prediction has a check of its own.\n\n";

const BEFORE: &str = "\n## Varying stiffness: the rate before anything is solved\n\n\
*A priori*: the slowest spring to let go is the one next to the contact edge, by w/g an iteration, and Hertz's closed form says w/g at the \
first node outside. The bound of the factor plays no part in it: near the edge w/g is next to 1. Where in its element the discrete contact \
ends the closed form does not know. Nodes only: line and layer elements are slowed by an alternating mode of their points inside the \
contact, which only the solved contact tells.\n\n";

const FAILING: &str = "\n## `secant` and `literal` with constant stiffness\n\n\
`secant` wants every closed spring to reach p/g: at the contact's centre, where g → 0, that is without bound, and the start must \
have half of it. `literal` adds up changes of stiffness times approach, which is not the change of the force: what is missing \
remains in points that open.\n\n";

const BASIN: &str = "\n## Varying stiffness with `correction`\n\n\
*A posteriori.* Next to the contact it is stable while 2 (S + K*) − max(K*, K₀) is positive definite on the closed points: near the edge, where \
k* → 0, κ₀ must remain below about twice the stiffness of the bodies. From equal springs, farther away, that is no promise.\n\n";

const HALVING: &str = "\n## Kinematic load: the halving law\n\n\
Started with every candidate closed it shrinks the contact by halving L² − a²: *a priori* where the half-width is known, as on the \
cylinder and on truncated Hertz; on the pin-rod the last closed point is taken from the solved contact. From which κ₀ on a start is soft, and \
takes one iteration more, is read off truncated Hertz, and soft starts are judged on the cylinder. By that law the paper's *two iterations for any initial \
stiffness* need candidates that end at the contact edge, L = a; elsewhere each halving of the mesh costs one iteration more. It is a law \
of nodes: the Gauss points of line and layer elements have an alternating mode that it does not know.\n\n";
