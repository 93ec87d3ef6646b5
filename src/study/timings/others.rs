//! Other codes in processes of their own, if they are installed: scikit-fem, dolfinx and NGSolve on truncated Hertz with their
//! own meshes, GetFEM and CalculiX on our mesh of the cylinder.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::case::library::{Cylinder, TruncatedHertz};
use crate::checkout::root;
use crate::clock::Stage;
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::cross_code::process::{Told, run};
use crate::solve::{Discretisation, Formulation};
use crate::study::handed_over;
use crate::study::timings::answers::Answers;
use crate::study::timings::code::Code;
use crate::study::timings::growth;
use crate::study::timings::precision::{Family, Laps, half_widths};
use crate::study::timings::statistics::Spread;

/// Elements per half-width across one of which their loads move the edge, as ours do.
const ACROSS: usize = 8;
/// Meshes of the cylinder handed to the peers: elements per half-width, times halved, repeats.
pub const SHARED: [(usize, u32, usize); 3] = [(8, 0, 5), (8, 1, 3), (8, 2, 1)];

/// A point of the work–precision chart by another code.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OtherPoint {
    /// Code.
    pub code: Code,
    /// Version.
    pub version: String,
    /// Mesh as it was asked for.
    pub mesh: String,
    /// Displacement components.
    pub dofs: usize,
    /// Seconds, median over the loads.
    pub seconds: f64,
    /// What of them went where.
    pub stages: Stages,
    /// Error of p₀, median and worst.
    pub peak: f64,
    /// Worst.
    pub peak_worst: f64,
    /// Error of a, median and worst.
    pub half_width: f64,
    /// Worst.
    pub half_width_worst: f64,
    /// L2(p), median and worst.
    pub l2: f64,
    /// Worst.
    pub l2_worst: f64,
}

/// Seconds of what every code does, medians over the loads.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Stages {
    /// Cells integrated and assembled.
    pub stiffness: f64,
    /// Ordering, factorisation and solution of the sparse system, as often as it is done.
    pub linear: f64,
    /// Contact rows, iterations, and all else; with us the mesh too.
    pub rest: f64,
}

impl OtherPoint {
    /// Worst errors of p₀ and a, the larger; NaN where either is.
    pub fn worst(&self) -> f64 {
        larger(self.peak_worst, self.half_width_worst)
    }
}

impl Stages {
    /// Of our own stages, load by load.
    pub fn of(laps: &[Laps]) -> Self {
        let linear =
            [Stage::Ordering, Stage::Analysis, Stage::Factorisation, Stage::ForwardElimination, Stage::SchurComplement];
        let median = |wanted: &dyn Fn(&Stage) -> bool| {
            let of = |laps: &Laps| -> f64 {
                laps.iter().filter(|(stage, _)| wanted(stage)).map(|(_, seconds)| seconds).sum()
            };
            Spread::of(&laps.iter().map(of).collect::<Vec<_>>()).median
        };
        Self {
            stiffness: median(&|stage| *stage == Stage::Assembly),
            linear: median(&|stage| linear.contains(stage)),
            rest: median(&|stage| *stage != Stage::Assembly && !linear.contains(stage)),
        }
    }
}

/// One mesh of the cylinder by a peer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct PeerPoint {
    /// Code.
    pub code: Peer,
    /// Version.
    pub version: String,
    /// Elements per half-width.
    pub elements: usize,
    /// Times halved.
    pub refinement: u32,
    /// Our degrees of freedom.
    pub dofs: usize,
    /// Iterations it took.
    pub iterations: usize,
    /// Seconds by its own account.
    pub seconds: Spread,
    /// What they count.
    pub counted: String,
    /// Our contact solve on the same mesh \[s\].
    pub ours: Spread,
    /// Error of p₀ and of a against the converged answer of the scene.
    pub errors: [f64; 2],
    /// Ours.
    pub our_errors: [f64; 2],
}

/// Work and precision of a code on truncated Hertz, under the loads of our own meshes with so many elements; the reason
/// where it is not installed.
pub fn precision(code: Code) -> Result<Result<Vec<OtherPoint>, String>, Error> {
    let nominal = TruncatedHertz::default();
    let request = json!({
        "scene": {
            "a_over_r": nominal.a_over_r, "poisson": nominal.poisson, "radius": nominal.radius,
            "size": nominal.size, "stretch": nominal.stretch, "young": nominal.young,
        },
        "half_widths": half_widths(Family::Truncated.nominal(), ACROSS),
        "meshes": code.meshes(),
        "repeats": 3,
    });
    let (script, arguments) = code.script();
    let lines = match run(script, &arguments, &request.to_string())? {
        Told::Lines(lines) => lines,
        Told::Absent(why) => return Ok(Err(why)),
    };
    Ok(Ok(lines.iter().map(|line| answered(code, line)).collect()))
}

/// What a code printed of one mesh.
pub fn answered(code: Code, line: &Value) -> OtherPoint {
    let list = |line: &Value, key: &str| -> Vec<f64> {
        line[key].as_array().into_iter().flatten().map(|x| x.as_f64().unwrap_or(f64::NAN)).collect()
    };
    let of = |key: &str| Spread::of(&list(line, key));
    let [peak, half_width, l2] = ["peak_error", "half_width_error", "l2_error"].map(of);
    let [seconds, stiffness, linear] = ["seconds", "stiffness", "linear"].map(|key| of(key).median);
    OtherPoint {
        code,
        version: line["version"].as_str().unwrap_or("unknown").into(),
        mesh: line["mesh"].to_string(),
        dofs: line["freedoms"].as_u64().unwrap_or(0) as usize,
        seconds,
        stages: Stages { stiffness, linear, rest: seconds - stiffness - linear },
        peak: peak.median,
        peak_worst: peak.most,
        half_width: half_width.median,
        half_width_worst: half_width.most,
        l2: l2.median,
        l2_worst: l2.most,
    }
}

/// A code that solves on our own mesh of the cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Peer {
    /// GetFEM.
    #[serde(rename = "GetFEM")]
    GetFem,
    /// CalculiX.
    CalculiX,
}

impl Peer {
    /// Both.
    pub const ALL: [Self; 2] = [Self::GetFem, Self::CalculiX];

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::GetFem => "GetFEM",
            Self::CalculiX => "CalculiX",
        }
    }

    /// What runs it.
    fn script(self) -> &'static str {
        match self {
            Self::GetFem => "getfem_peer.py",
            Self::CalculiX => "calculix_peer.py",
        }
    }
}

/// The cylinder by a peer on our meshes; the reason where it is not installed.
pub fn cylinder(peer: Peer) -> Result<Result<Vec<PeerPoint>, String>, Error> {
    let numbers = Cylinder::default();
    let hertz = [2.0 * numbers.load() / (std::f64::consts::PI * numbers.half_width()), numbers.half_width()];
    let over_hertz = Answers::of(Family::Cylinder)?.at(1.0);
    let answer = [0, 1].map(|k| over_hertz[k] * hertz[k]);
    let mut points = Vec::new();
    for (elements, refinement, repeats) in SHARED {
        let (file, ours, our_errors, dofs) = exported(elements, refinement, answer)?;
        let told = run(peer.script(), &[file.display().to_string(), repeats.to_string()], "");
        // The file is in the build's own folder: nothing is lost if it cannot be removed.
        let _ = std::fs::remove_file(&file);
        let line = match told? {
            Told::Absent(why) => return Ok(Err(why)),
            Told::Lines(lines) => lines.into_iter().next().unwrap_or(Value::Null),
        };
        let number = |key: &str| line[key].as_f64().unwrap_or(f64::NAN);
        let seconds: Vec<f64> =
            line["seconds"].as_array().into_iter().flatten().map(|x| x.as_f64().unwrap_or(f64::NAN)).collect();
        points.push(PeerPoint {
            code: peer,
            version: line["version"].as_str().unwrap_or("unknown").into(),
            elements,
            refinement,
            dofs,
            iterations: line["steps"].as_u64().unwrap_or(0) as usize,
            seconds: Spread::of(&seconds),
            counted: line["counted"].as_str().unwrap_or_default().into(),
            ours,
            errors: [0, 1].map(|k| (number(["peak", "half_width"][k]) / answer[k] - 1.0).abs()),
            our_errors,
        });
    }
    Ok(Ok(points))
}

/// Our mesh of the cylinder in a file, our own contact solve on it, its errors against p₀ and a, and its degrees of freedom.
fn exported(
    elements: usize,
    refinement: u32,
    [peak, half_width]: [f64; 2],
) -> Result<(PathBuf, Spread, [f64; 2], usize), Error> {
    let scene = Cylinder::default().scene();
    let discretisation = Discretisation::of(scene, growth::resolution(elements, refinement))?;
    let run = crate::solve::Run::of(&discretisation, &Formulation::verification())?;
    let measures = run.measures();
    let errors = [(measures.peak.pressure / peak - 1.0).abs(), (measures.second_moment_width / half_width - 1.0).abs()];
    let file = root().join("target").join(format!("cylinder-{elements}-{refinement}.json"));
    handed_over::export(&discretisation, &file)?;
    let ours = growth::contact_seconds(elements, refinement, 5)?;
    Ok((file, ours, errors, run.dofs))
}
