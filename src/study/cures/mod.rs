//! Cures of what fails or is slow: options beside the paper's algorithms, off by default.
//!
//! * [`reach`] — over which initial stiffnesses constant stiffness converges, plain and accelerated.
//! * [`record`] — its runs, measured and recorded.
//! * [`nested`] — steps of kinematic load from every candidate closed, and from the contact set of coarser meshes.

pub mod nested;
pub mod reach;
pub mod record;

use crate::solve::Element;
use crate::study::unsorted::Trial;

/// Name of the trials of accelerated constant stiffness.
pub const REACH: &str = "reach of constant stiffness, accelerated";
/// Name of the trial of accelerated rules.
pub const RULES: &str = "accelerated rules";
/// Name of the trials of nested starts.
pub const NESTED: &str = "nested start of kinematic load";
/// Picture of steps against initial stiffness.
pub const PICTURE: &str = "cures";

/// Trials of the cures.
pub fn trials() -> Vec<Trial> {
    let mut trials: Vec<Trial> =
        Element::ALL.map(|element| Trial::new(REACH, element.name(), move || reach::reach(element))).into();
    trials.push(Trial::new(RULES, "node.constant", reach::rules));
    for (name, scene) in nested::scenes() {
        trials.push(Trial::new(NESTED, name, move || nested::steps(name, &scene)));
    }
    trials
}
