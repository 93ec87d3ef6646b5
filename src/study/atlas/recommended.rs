//! Which element and algorithm to use, and from which initial stiffness: made of the records.

use std::fmt::Write;

use crate::algorithm::StiffnessRule;
use crate::markdown;
use crate::solve::{Element, Iteration};
use crate::study::atlas::summary::{Digest, Safe};
use crate::study::class::Class;
use crate::study::method::Method;

/// What to use, and what not.
pub fn recommendation(digests: &[Digest]) -> String {
    let points: usize = digests.iter().flat_map(|digest| &digest.ends).map(|(_, count)| count).sum();
    let predicted: usize = digests.iter().map(|digest| digest.predicted).sum();
    let mut text = format!(
        "From {points} runs over candidate surface, mesh and both paper scenes, {predicted} of them predicted before they were run:\n\n"
    );
    let reliable = reliable(digests);
    let constant = reliable.iter().find(|(method, _)| method.algorithm == Iteration::Constant);
    if let Some(first) = reliable.iter().find(|(method, _)| !method.is_accelerated()) {
        let _ = writeln!(text, "* **Use** {}.", sentence(first));
    }
    if let Some(constant) = constant {
        let _ = writeln!(text, "* **Where one factorisation must do**: {}.", sentence(constant));
    }
    let widest = widest(&reliable);
    if !widest.is_empty() {
        let _ = writeln!(text, "* **Where nothing is known of the stiffness**: {}.", widest.join(", "));
    }
    let nowhere = digests.iter().filter(|digest| digest.safe.is_none());
    let nowhere: Vec<String> = nowhere.map(|digest| format!("`{}`", digest.method)).collect();
    if !nowhere.is_empty() {
        let _ =
            writeln!(text, "* **Do not use** {}: at no initial stiffness do all runs end right.", nowhere.join(", "));
    }
    text
}

/// The method to use, of those to which nothing is added; none where there is none of which every surveyed run ends right.
pub fn recommended(digests: &[Digest]) -> Option<Method> {
    reliable(digests).into_iter().map(|(method, _)| method).find(|method| !method.is_accelerated())
}

/// Methods with a range, fewest iterations first; a penalty stops at a penetration of its own and is not among them.
fn reliable(digests: &[Digest]) -> Vec<(Method, Safe)> {
    let exact = digests.iter().filter(|digest| digest.method.rule != StiffnessRule::Penalty);
    let mut reliable: Vec<(Method, Safe)> =
        exact.filter_map(|digest| digest.safe.map(|safe| (digest.method, safe))).collect();
    reliable.sort_by_key(|(_, safe)| safe.best_iterations);
    reliable
}

fn sentence((method, safe): &(Method, Safe)) -> String {
    let Safe { from, to, best, best_iterations, .. } = safe;
    format!(
        "`{method}` from κ₀ = {best:e} (at most {best_iterations} iterations; every surveyed run ends right for κ₀ from {from:e} to {to:e})"
    )
}

/// The methods whose range no other's exceeds.
fn widest(reliable: &[(Method, Safe)]) -> Vec<String> {
    let is_widest = |safe: &Safe| !reliable.iter().any(|(_, other)| other.is_wider_than(Some(*safe)));
    let widest = reliable.iter().filter(|(_, safe)| is_widest(safe));
    widest
        .map(|(method, Safe { from, to, iterations, .. })| {
            format!("`{method}` (at most {iterations} iterations from any κ₀ from {from:e} to {to:e})")
        })
        .collect()
}

/// Method → where it works → how its runs end → why → which rule does better.
pub fn methods(digests: &[Digest]) -> String {
    let head = [
        "method",
        "every run ends right for κ₀ from … to",
        "how the runs ended",
        "what stands in its way",
        "what else of the same algorithm has a wider range",
    ];
    let rows: Vec<Vec<String>> = Method::of(Element::Node).into_iter().map(|method| row(digests, method)).collect();
    markdown::table(&head.map(String::from), &rows)
}

/// What the digests say of a method on each element.
fn row(digests: &[Digest], method: Method) -> Vec<String> {
    let is_own = |digest: &&Digest| digest.method == Method { element: digest.method.element, ..method };
    let own: Vec<&Digest> = digests.iter().filter(is_own).collect();
    let range = |digest: &&Digest| {
        let range = digest.safe.map_or("nowhere".into(), |Safe { from, to, .. }| format!("{from:e} … {to:e}"));
        format!("{}: {range}", digest.method.element.name())
    };
    let ranges: Vec<String> = own.iter().map(range).collect();
    vec![method.way(), ranges.join("; "), ends(&own), obstacle(method).into(), wider(digests, method)]
}

/// Runs by how they ended.
fn ends(own: &[&Digest]) -> String {
    let all = || own.iter().flat_map(|digest| &digest.ends);
    let total = |class: Class| all().filter(|(other, _)| *other == class).map(|(_, count)| count).sum::<usize>();
    let counted = Class::ALL.map(|class| (class, total(class))).into_iter().filter(|(_, count)| *count > 0);
    counted.map(|(class, count)| format!("{count} {}", class.name())).collect::<Vec<_>>().join(", ")
}

/// Other methods of the algorithm, with the elements on which their range is wider.
fn wider(digests: &[Digest], method: Method) -> String {
    let safe = |element, method| {
        let method = Method { element, ..method };
        digests.iter().find(|digest| digest.method == method).and_then(|digest| digest.safe)
    };
    let mut found = Vec::new();
    for other in Method::of(method.element).into_iter().filter(|other| other.algorithm == method.algorithm) {
        let is_wider =
            |element: &Element| safe(*element, other).is_some_and(|range| range.is_wider_than(safe(*element, method)));
        let elements: Vec<&str> = Element::ALL.iter().filter(|e| is_wider(e)).map(|e| e.name()).collect();
        if !elements.is_empty() {
            found.push(format!("`{}` ({})", other.way(), elements.join(", ")));
        }
    }
    if found.is_empty() { "–".into() } else { found.join("; ") }
}

/// What a rule has to overcome, by its own formula.
fn obstacle(method: Method) -> &'static str {
    match (method.algorithm, method.rule) {
        (Iteration::Varying, _) if method.is_accelerated() => {
            "points that part from the contact one by one: until those that press stand still, the rule goes alone"
        }
        (Iteration::Constant, _) if method.is_accelerated() => "which points press is found step by step",
        (Iteration::Varying, StiffnessRule::Secant) => {
            "an open point loses its force by w/g an iteration, and w/g → 1 at the contact edge"
        }
        (Iteration::Varying, StiffnessRule::Correction) => {
            "a correction by κ ≥ k₀ of points near the edge, where p/w is small: of hard κ₀ it is too large, and they swing"
        }
        (Iteration::Constant, StiffnessRule::Correction) => {
            "a closed point keeps 1 − k₀ C of an error at each iteration, nearly all where κ₀ is soft; an open one k₀ C, nearly all where it is hard"
        }
        (Iteration::Constant, StiffnessRule::Secant) => "the spring asked for, p/g, has no bound where g → 0",
        (Iteration::Constant, StiffnessRule::Literal) => {
            "Σ Δk w is not the change of k w: what is missing stays in points that open"
        }
        (Iteration::Kinematic, StiffnessRule::Switching) => {
            "the alternating mode of Gauss points, which the halving law of nodes does not know"
        }
        (Iteration::Kinematic, StiffnessRule::Penalty) => {
            "the penetration p/k, which is its own law; soft springs let the contact reach the end of the candidate surface"
        }
        _ => "not offered",
    }
}
