//! On what the seconds were measured.

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
