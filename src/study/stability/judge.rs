//! The predictions hold.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::solution::Outcome;
use crate::stability::halving::SOFT;
use crate::study::stability::fixed_target::{NEAR, Target, end, progress};
use crate::study::stability::halving::{Iterations, Law, Mesh, PIN_ELEMENTS, Scene};
use crate::study::stability::{Numbers, basin, before, failing, fixed_target, rates};

/// Rates between which prediction and measurement are compared: faster ones leave no iterations to measure.
const MEASURABLE: [f64; 2] = [0.05, 0.999];
/// Where the slope of the linearised iteration over the measured errors differs from ln ρ by more than this, the start
/// hardly holds the slowest mode and round-off comes before it is alone: by prediction, no rate is to be measured there.
const ALONE: f64 = 0.02;
/// Starts that must be compared for each element and algorithm.
const COMPARED: f64 = 3.0;
/// Error of ln ρ that is accepted.
const ACCEPTED: f64 = 0.05;
/// Towards fixed springs a start is not judged that ends about where the limit of iterations is: [`progress`] between these.
const CRAWLING: std::ops::Range<f64> = 0.98..1.02;
/// Factor on ln ρ within which Hertz's closed form says the rate before the contact is solved: where in the contact edge's element
/// the discrete contact ends, it does not know.
const BEFORE: f64 = 2.0;
/// Iterations within which the halving law is met.
const HALVINGS: f64 = 1.0;
/// Factor within which the softness of a start is known: a tenth of a decade.
const TENTH: f64 = 1.26;

/// The checks of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Rates(starts) => rates(starts),
        Numbers::Before(starts) => vec![before(starts)],
        Numbers::FixedTarget(targets) => fixed_target(targets),
        Numbers::Basin(starts) => vec![basin(starts)],
        Numbers::Failing(starts) => failing(starts),
        Numbers::Halving(law) if law.scene == Scene::PinRod => vec![twice_the_elements(law)],
        Numbers::Halving(law) if law.scene == Scene::TruncatedHertz => {
            vec![threshold(law), halved(law, "hard starts", |k| k >= SOFT)]
        }
        Numbers::Halving(law) => vec![halved(law, "soft and hard starts", |_| true)],
    })
}

/// A share of nothing is not a number.
fn count(wrong: usize, of: usize) -> f64 {
    if of == 0 { f64::NAN } else { wrong as f64 }
}

/// Every start against each of its predictions.
fn rates(starts: &[rates::Start]) -> Vec<Judged> {
    let compared = starts.iter().filter(|start| is_measurable(start));
    let mut judged: Vec<Judged> = compared.flat_map(|start| [followed(start), asymptotic(start)]).flatten().collect();
    let compared = starts.iter().filter(|start| is_measurable(start)).count();
    judged.push(
        Check::at_least(
            "number of starts compared with the prediction",
            Reference::own("at least", COMPARED),
            "a prediction that is compared with nothing predicts nothing",
        )
        .judge(compared as f64),
    );
    judged
}

/// Whether there is enough of a start to measure.
pub fn is_measurable(start: &rates::Start) -> bool {
    start.measured.is_some() && (MEASURABLE[0]..=MEASURABLE[1]).contains(&start.predicted)
}

/// A start against its spectral radius; none where by the linearised iteration the slowest mode is not alone above round-off.
pub fn asymptotic(start: &rates::Start) -> Option<Judged> {
    let alone = start.linearised.is_none_or(|slope| (slope.ln() / start.predicted.ln() - 1.0).abs() <= ALONE);
    alone.then(|| rate_check(start.stiffness, start.predicted, start.measured.unwrap_or(f64::NAN)))
}

/// A start against the linearised iteration over the same errors, which constant stiffness has.
pub fn followed(start: &rates::Start) -> Option<Judged> {
    let measured = start.measured.unwrap_or(f64::NAN);
    start.linearised.map(|slope| against("linearised iteration", start.stiffness, slope, measured))
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

/// The rate that Hertz's closed form says, against the measured one.
fn before(starts: &[before::Start]) -> Judged {
    let factors: Vec<f64> =
        starts.iter().filter_map(before::Start::ratio).map(|ratio| larger(ratio, 1.0 / ratio)).collect();
    let enough = factors.len() as f64 >= COMPARED;
    Check::at_most(
        Quantity::at(
            "largest factor between ln ρ by Hertz's closed form and as measured",
            format!("{} of {} meshes can be measured", factors.len(), starts.len()),
        ),
        Reference::own("factor accepted", BEFORE),
        "nothing is solved for it: w/g of Hertz's contact at the first node outside; where in its element the discrete contact ends it does not know",
    )
    .judge(if enough { factors.into_iter().reduce(larger).unwrap_or(f64::NAN) } else { f64::NAN })
}

/// Where starts cease to be soft: the median over the meshes of the scene that the threshold is taken from.
fn threshold(law: &Law) -> Judged {
    let mut from = law.hard_from.clone();
    from.sort_by(f64::total_cmp);
    let ratio = from.get(from.len() / 2).map_or(f64::NAN, |median| median / SOFT);
    Check::at_most(
        Quantity::at(
            "factor between κ₀ below which a start counts as soft and the median of where it measurably is",
            format!("{} meshes", from.len()),
        ),
        Reference::own("a tenth of a decade", TENTH),
        "the threshold of the halving law is taken from this scene; soft starts are judged on others",
    )
    .judge(larger(ratio, 1.0 / ratio))
}

/// The starts of a scene that are judged, against the law.
fn halved(law: &Law, which: &str, is_judged: fn(f64) -> bool) -> Judged {
    let off = |one: &Iterations| {
        let measured = one.measured.map_or(f64::NAN, |iterations| iterations as f64);
        (measured - one.predicted as f64).abs()
    };
    let starts = law.meshes.iter().flat_map(|mesh| &mesh.iterations).filter(|one| is_judged(one.stiffness));
    let off: Vec<f64> = starts.map(off).collect();
    Check::at_most(
        Quantity::at(
            "largest number of iterations of kinematic load off the halving law",
            format!("{which}, {} runs", off.len()),
        ),
        Reference::own("halving of L² − a²", HALVINGS),
        "the law counts halvings; the last one may end anywhere within a node spacing",
    )
    .judge(off.into_iter().reduce(larger).unwrap_or(f64::NAN))
}

/// The pin-rod, whose contact is no Hertz contact: the law is not asked how many iterations, but how many more on a finer mesh.
fn twice_the_elements(law: &Law) -> Judged {
    let measured = |mesh: &Mesh| {
        mesh.iterations.map(|iterations| iterations.measured.map_or(f64::NAN, |iterations| iterations as f64))
    };
    let more = law.meshes.chunks_exact(PIN_ELEMENTS.len()).flat_map(|pair| {
        let [coarse, fine] = [measured(&pair[0]), measured(&pair[1])];
        fine.into_iter().zip(coarse).map(|(fine, coarse)| fine - coarse).collect::<Vec<_>>()
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
