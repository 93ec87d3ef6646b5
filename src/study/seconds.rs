//! Seconds: on what they were measured, and their medians and quantiles, which NaN spoils.

use std::collections::BTreeMap;
use std::process::Command;

use serde::{Deserialize, Serialize};

/// Processor, compiler, libraries.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Machine {
    /// Name of the processor.
    pub processor: String,
    /// Threads it offers.
    pub threads: usize,
    /// Operating system and architecture.
    pub system: String,
    /// Compiler.
    pub compiler: String,
    /// Versions of the libraries that do the work.
    pub versions: BTreeMap<String, String>,
}

/// Libraries that do the work.
const LIBRARIES: [&str; 5] = ["faer", "gemm", "nalgebra", "pulp", "rayon"];

impl Machine {
    /// This one.
    pub fn here() -> Self {
        let unknown = || "unknown".to_owned();
        let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
        let asked = Command::new("rustc").arg("--version").output().ok();
        let compiler =
            asked.and_then(|output| String::from_utf8(output.stdout).ok()).map(|text| text.trim().to_owned());
        Self {
            processor: model.map_or_else(unknown, |(_, name)| name.trim().to_owned()),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            compiler: compiler.filter(|text| !text.is_empty()).unwrap_or_else(unknown),
            versions: versions(include_str!("../../Cargo.lock")),
        }
    }
}

/// Versions of the libraries from the lock file.
fn versions(lock: &str) -> BTreeMap<String, String> {
    let quoted =
        |line: &str, key: &str| line.strip_prefix(key)?.trim().strip_prefix('"')?.strip_suffix('"').map(str::to_owned);
    let lines: Vec<&str> = lock.lines().collect();
    let pairs = lines.windows(2).filter_map(|two| Some((quoted(two[0], "name =")?, quoted(two[1], "version =")?)));
    pairs.filter(|(name, _)| LIBRARIES.contains(&name.as_str())).collect()
}

/// Median, least and most of repeated measurements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Median.
    pub median: f64,
    /// Least.
    pub least: f64,
    /// Most.
    pub most: f64,
}

impl Spread {
    /// Of some values; NaN where there is none, or one is NaN.
    pub fn of(values: &[f64]) -> Self {
        let [least, median, most] = [0.0, 0.5, 1.0].map(|share| quantile(values, share));
        Self { median, least, most }
    }
}

/// Quotients of two lists, pair by pair.
pub fn ratios(above: &[f64], below: &[f64]) -> Vec<f64> {
    above.iter().zip(below).map(|(a, b)| a / b).collect()
}

/// The value below which this share of some values is, on a straight line between the two around it; NaN where there is
/// no value, or one is NaN.
pub fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    if values.is_empty() || values.iter().any(|value| value.is_nan()) {
        return f64::NAN;
    }
    let place = share * (sorted.len() - 1) as f64;
    let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    below + place.fract() * (above - below)
}
