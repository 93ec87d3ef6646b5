//! Other codes in processes of their own, if they are installed: scikit-fem, dolfinx and NGSolve on truncated Hertz with their
//! own meshes, GetFEM and CalculiX on our mesh of the cylinder.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::case::library::TruncatedHertz;
use crate::checkout::root;
use crate::error::Error;
use crate::named::named_enum;
use crate::oracle::cross_code::process::{Told, run};
use crate::study::handed_over;
use crate::study::timings::growth::{contact_seconds, discretised};
use crate::study::timings::precision::{ACROSS, LOADS, Point, half_widths};
use crate::study::timings::series::Series;
use crate::study::timings::statistics::Spread;

/// Meshes of scikit-fem and dolfinx: cells per candidate stretch, and times cut into four.
const TRIANGLES: [[usize; 2]; 8] = [[8, 0], [12, 0], [16, 0], [17, 0], [32, 0], [17, 1], [32, 1], [64, 1]];
/// Meshes of NGSolve: order, and cells per candidate stretch.
const HIGH_ORDER: [[usize; 2]; 7] = [[3, 6], [4, 9], [6, 9], [4, 18], [4, 27], [6, 27], [4, 81]];
/// Meshes of the cylinder handed to the peers: elements per half-width, times halved, repeats.
const SHARED: [(usize, u32, usize); 3] = [(8, 0, 5), (8, 1, 3), (8, 2, 1)];

/// What the meshes of a code are, in a few words.
pub fn cells(code: Series) -> String {
    if code != Series::Ngsolve {
        return "meshes of its own".into();
    }
    let orders = || HIGH_ORDER.into_iter().map(|[order, _]| order);
    let [least, most] = [orders().min(), orders().max()].map(Option::unwrap_or_default);
    format!("orders {least} to {most}, contact edge unknown to its mesh")
}

/// Asks a code for truncated Hertz on all its meshes, under the loads of our own; the reason where it is not installed.
pub fn precision(code: Series) -> Result<Result<Vec<Value>, String>, Error> {
    let (script, arguments, meshes) = if code == Series::Ngsolve {
        ("ngsolve_precision.py", vec![], &HIGH_ORDER[..])
    } else {
        ("work_precision.py", vec![code.name().into()], &TRIANGLES[..])
    };
    let nominal = TruncatedHertz::default();
    let request = json!({
        "scene": {
            "a_over_r": nominal.a_over_r, "poisson": nominal.poisson, "radius": nominal.radius,
            "size": nominal.size, "stretch": nominal.stretch, "young": nominal.young,
        },
        "half_widths": half_widths(ACROSS),
        "meshes": meshes,
        "repeats": 3,
    });
    Ok(match run(script, &arguments, &request.to_string())? {
        Told::Lines(lines) => Ok(lines),
        Told::Absent(why) => Err(why),
    })
}

/// What a code printed of one of its meshes.
pub fn answered(code: Series, mesh: usize, line: &Value) -> Point {
    let [peak, half_width, seconds] = ["peak_error", "half_width_error", "seconds"].map(|key| spread(line, key));
    let converged = if peak.most.is_finite() { LOADS } else { 0 };
    Point {
        series: code,
        mesh,
        formulation: None,
        dofs: line["freedoms"].as_u64().unwrap_or(0) as usize,
        operations: f64::NAN,
        converged,
        seconds: seconds.median,
        peak: peak.median,
        peak_worst: peak.most,
        half_width: half_width.median,
        half_width_worst: half_width.most,
    }
}

/// Version of the code that printed a line.
pub fn version(line: &Value) -> String {
    line["version"].as_str().unwrap_or("unknown").into()
}

/// Numbers of a list in a line; NaN where one is missing.
fn spread(line: &Value, key: &str) -> Spread {
    let list = line[key].as_array().into_iter().flatten().map(|x| x.as_f64().unwrap_or(f64::NAN));
    Spread::of(&list.collect::<Vec<_>>())
}

named_enum! {
    /// A code that solves on our own mesh of the cylinder.
    pub enum Peer {
        /// GetFEM.
        GetFem = "GetFEM",
        /// CalculiX.
        CalculiX = "CalculiX",
    }
}

/// One mesh of the cylinder by a peer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct PeerPoint {
    /// Code.
    pub code: Peer,
    /// Version.
    pub version: String,
    /// Our degrees of freedom.
    pub dofs: usize,
    /// Seconds by its own account.
    pub seconds: Spread,
    /// What they count.
    pub counted: String,
    /// Our contact solve on the same mesh \[s\].
    pub ours: Spread,
}

/// The cylinder by a peer on our meshes; the reason where it is not installed.
pub fn cylinder(peer: Peer) -> Result<Result<Vec<PeerPoint>, String>, Error> {
    let script = match peer {
        Peer::GetFem => "getfem_peer.py",
        Peer::CalculiX => "calculix_peer.py",
    };
    let mut points = Vec::new();
    for (elements, refinement, repeats) in SHARED {
        let discretisation = discretised(elements, refinement)?;
        let file = root().join("target").join(format!("cylinder-{elements}-{refinement}.json"));
        handed_over::export(&discretisation, &file)?;
        let told = run(script, &[file.display().to_string(), repeats.to_string()], "");
        // The file is in the build's own folder: nothing is lost if it cannot be removed.
        let _ = std::fs::remove_file(&file);
        let line = match told? {
            Told::Absent(why) => return Ok(Err(why)),
            Told::Lines(lines) => lines.into_iter().next().unwrap_or(Value::Null),
        };
        points.push(PeerPoint {
            code: peer,
            version: version(&line),
            dofs: discretisation.system.dofs(),
            seconds: spread(&line, "seconds"),
            counted: line["counted"].as_str().unwrap_or_default().into(),
            ours: contact_seconds(elements, refinement, 5)?,
        });
    }
    Ok(Ok(points))
}
