//! The predictions hold.

use crate::case::{Check, Judged, Quantity, Reference, Verdict};
use crate::error::Error;
use crate::measure::larger;
use crate::solution::Outcome;
use crate::study::stability::fixed_target::{NEAR, Target, end, progress};
use crate::study::stability::halving::{Law, Mesh, PIN_ELEMENTS, Scene, Iterations};
use crate::study::stability::{Numbers, basin, failing, fixed_target, rates};

/// Rates between which prediction and measurement are compared: faster ones leave no iterations to measure.
const MEASURABLE: [f64; 2] = [0.05, 0.999];
/// Where the slope of the linearised iteration over the measured errors differs from ln ρ by more than this, the start
/// hardly holds the slowest mode and round-off comes before it is alone: the linearised slope is the prediction.
const ALONE: f64 = 0.02;
/// Starts that must be compared for each element and algorithm.
const COMPARED: f64 = 3.0;
/// Error of ln ρ that is accepted.
const ACCEPTED: f64 = 0.05;
/// Towards fixed springs a start is not judged that ends about where the limit of iterations is: [`progress`] between these.
const CRAWLING: std::ops::Range<f64> = 0.98..1.02;
/// Iterations within which the halving law is met.
const HALVINGS: f64 = 1.0;

/// The checks of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Rates(starts) => rates(starts),
        Numbers::FixedTarget(targets) => fixed_target(targets),
        Numbers::Basin(starts) => vec![basin(starts)],
        Numbers::Failing(starts) => failing(starts),
        Numbers::Halving(law) if law.scene == Scene::PinRod => vec![twice_the_elements(law)],
        Numbers::Halving(law) => law.meshes.iter().flat_map(halved).collect(),
    })
}

/// A share of nothing is not a number.
fn count(wrong: usize, of: usize) -> f64 {
    if of == 0 { f64::NAN } else { wrong as f64 }
}

fn rates(starts: &[rates::Start]) -> Vec<Judged> {
    let mut judged: Vec<Judged> = starts.iter().filter(|start| is_measurable(start)).map(rate).collect();
    judged.push(
        Check::at_least(
            "number of starts compared with the prediction",
            Reference::own("at least", COMPARED),
            "a prediction that is compared with nothing predicts nothing",
        )
        .judge(judged.len() as f64),
    );
    judged
}

/// Whether there is enough of a start to measure.
pub fn is_measurable(start: &rates::Start) -> bool {
    start.measured.is_some() && (MEASURABLE[0]..=MEASURABLE[1]).contains(&start.predicted)
}

/// A start against ρ; where that fails and the linearised iteration departs from ρ over the same errors too, against its slope.
fn rate(start: &rates::Start) -> Judged {
    let asymptotic = asymptotic(start);
    if asymptotic.verdict == Verdict::Pass { asymptotic } else { followed(start).unwrap_or(asymptotic) }
}

/// A start against its spectral radius.
pub fn asymptotic(start: &rates::Start) -> Judged {
    rate_check(start.stiffness, start.predicted, start.measured.unwrap_or(f64::NAN))
}

/// A start against the linearised iteration, where that departs from its spectral radius.
pub fn followed(start: &rates::Start) -> Option<Judged> {
    let slope = start.linearised.filter(|slope| (slope.ln() / start.predicted.ln() - 1.0).abs() > ALONE);
    slope.map(|slope| against("linearised iteration", start.stiffness, slope, start.measured.unwrap_or(f64::NAN)))
}

/// Measured against predicted rate, by their logarithms: the iterations a decade takes.
pub fn rate_check(stiffness: f64, predicted: f64, measured: f64) -> Judged {
    against("spectral radius", stiffness, predicted, measured)
}

fn against(prediction: &str, stiffness: f64, predicted: f64, measured: f64) -> Judged {
    Check::error(
        Quantity::at("error of ln ρ, ρ the rate of convergence", format!("κ₀ = {stiffness}")),
        Reference::own(prediction, 0.0),
        ACCEPTED,
        "asymptotic: slope of the last errors against what the condensed matrices say on the final active set",
    )
    .judge(off(predicted, measured))
}

/// Error of a predicted rate, by the logarithm.
pub fn off(predicted: f64, measured: f64) -> f64 {
    (measured.ln() - predicted.ln()).abs() / predicted.ln().abs()
}

fn fixed_target(targets: &[Target]) -> Vec<Judged> {
    let is_judged =
        |start: &&fixed_target::Start| !start.near_the_boundary && !CRAWLING.contains(&progress(start.predicted).abs());
    let judged: Vec<&fixed_target::Start> =
        targets.iter().flat_map(|target| &target.starts).filter(is_judged).collect();
    let ends_otherwise = |start: &&&fixed_target::Start| {
        (start.predicted < 1.0) != start.definite || end(start.observed) != end(start.predicted)
    };
    let compared = judged.iter().filter(|start| (MEASURABLE[0]..MEASURABLE[1]).contains(&start.predicted));
    let errors: Vec<f64> = compared.map(|start| (start.observed.ln() / start.predicted.ln() - 1.0).abs()).collect();
    vec![
        Check::none(
            Quantity::at(
                "start towards fixed springs that does not converge although S + K* and S + 2K₀ − K* are positive definite, or \
                 converges although they are not",
                format!("of {}", judged.len()),
            ),
            format!("at every start farther than a factor of {NEAR} from the boundary; where it merely crawls, predicted iterations against the limit"),
        )
        .judge(count(judged.iter().filter(ends_otherwise).count(), judged.len())),
        Check::error(
            Quantity::at(
                "largest error of ln ρ, ρ the rate towards fixed springs",
                format!("{} points", errors.len()),
            ),
            Reference::own("spectral radius", 0.0),
            ACCEPTED,
            "over forty iterations, once the slowest mode is alone",
        )
        .judge(errors.into_iter().reduce(larger).unwrap_or(f64::NAN)),
    ]
}

fn basin(starts: &[basin::Start]) -> Judged {
    let is_wrong = |start: &&basin::Start| start.predicted.is_nan() || start.stays != (start.predicted < 1.0);
    Check::none(
        Quantity::at(
            "start next to the contact, with varying stiffness and correction, that stays although its spectral radius is above 1, \
             or leaves although it is below",
            format!("of {}", starts.len()),
        ),
        "the boundary is where 2 (S + K*) − max(K*, K₀) ceases to be positive definite on the closed points",
    )
    .judge(count(starts.iter().filter(is_wrong).count(), starts.len()))
}

fn failing(starts: &[failing::Start]) -> Vec<Judged> {
    let outcomes = starts.iter().flat_map(|start| [start.secant, start.literal]);
    let converged = outcomes.filter(|outcome| *outcome == Outcome::Converged).count();
    let smaller = |a: f64, b: f64| -larger(-a, -b);
    let least = starts.iter().map(|start| start.left).reduce(smaller).unwrap_or(f64::NAN);
    vec![
        Check::none(
            "start from which secant or literal converges with constant stiffness",
            "secant needs springs of half what the gap-free point asks for; literal forgets Σ k Δw in its forces",
        )
        .judge(if least.is_nan() { f64::NAN } else { converged as f64 }),
        Check::at_least(
            "least force that the literal sum leaves in open points, over the peak",
            Reference::own("error accepted", 1e-3),
            "Σ (k⁺ − k) w is not the change of k w: what is missing stays in the point",
        )
        .judge(least),
    ]
}

fn halved(mesh: &Mesh) -> [Judged; 2] {
    let Mesh { stretch, elements, iterations } = mesh;
    iterations.map(|Iterations { stiffness, predicted, measured }| {
        let measured = measured.map_or(f64::NAN, |iterations| iterations as f64);
        Check::error(
            Quantity::at(
                "number of iterations of kinematic load off the halving law",
                format!("L/a = {stretch}, {elements} per half-width, κ₀ = {stiffness:e}"),
            ),
            Reference::own("halving of L² − a²", 0.0),
            HALVINGS,
            "the law counts halvings; the last one may end anywhere within a node spacing",
        )
        .judge((measured - predicted as f64).abs())
    })
}

/// The pin-rod, whose contact is no Hertz contact: the law is not asked how many iterations, but how many more on a finer mesh.
fn twice_the_elements(law: &Law) -> Judged {
    let measured = |mesh: &Mesh| mesh.iterations.map(|iterations| iterations.measured.map_or(f64::NAN, |iterations| iterations as f64));
    let more = law.meshes.chunks_exact(PIN_ELEMENTS.len()).flat_map(|pair| {
        let [coarse, fine] = [measured(&pair[0]), measured(&pair[1])];
        [fine[0] - coarse[0], fine[1] - coarse[1]]
    });
    let more: Vec<f64> = more.collect();
    Check::at_most(
        Quantity::at(
            "largest number of iterations of kinematic load that twice the elements cost",
            format!("{} pairs of meshes", more.len()),
        ),
        Reference::own("halving of L² − a²", HALVINGS),
        "half the node spacing is one halving more, whatever the pressure of the contact",
    )
    .judge(more.into_iter().reduce(larger).unwrap_or(f64::NAN))
}
