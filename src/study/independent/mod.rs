//! The same physical problem in other codes that share the scene and the definitions of its quantities, and no line:
//! mesh, forms of the contact and iteration are each script's own. A folder, since what is asked and what is held are
//! more than a file.
//!
//! * `run` — one trial a scene: the scene as numbers, and what every script found of it, beside ours.
//!
//! Below is how near the scripts must come: within the uncertainties of both, and within three times what is found
//! where that is more than these; and the page.

pub mod run;

use std::fmt::Write;

use crate::case::{Check, Judged, Quantity, Reference, covered};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series};
use crate::error::Error;
use crate::markdown;
use crate::measure::{display_factor, larger};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::independent::{Folder, Independent, Script};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::independent::run::{Compared, KAPPA, Other, STATIONS, Scene};
use crate::uncertainty::{COVERAGE, Comparison};

pub use run::Compared as Numbers;

impl Study for Compared {
    const NAME: &'static str = "independent";
    const ABOUT: About = About {
        title: "Against independent codes",
        asked: "Whether codes that share the scene and the definitions of its numbers, and no line, find the same.",
        limits: "That codes agree is no measurement.",
    };

    /// All scenes, against frozen answers.
    fn plan() -> Vec<Planned<Self>> {
        run::against(None)
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(self.others.iter().flat_map(|other| of_script(self, other)).collect())
    }

    /// The scripts, and their profiles beside ours.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let frozen = Independent::read()?;
        let mut text = String::new();
        for folder in Folder::ALL {
            let hash: String = frozen.scripts.get(&folder).map_or("", String::as_str).chars().take(12).collect();
            let version = frozen.apart.get(&folder).or_else(|| frozen.versions.get(folder.title()));
            let live = if folder.is_set_up() {
                "asked again by `cargo test --workspace`"
            } else {
                "asked when the answers were frozen"
            };
            let _ =
                writeln!(text, "* {} {}: script {hash}…, {live}.", folder.title(), version.map_or("", String::as_str));
        }
        let entered = |found: &Found<Self>| {
            let of = found.numbers;
            let spring = of.scene.benchmark().spring();
            format!("{} ({})", markdown::significant(of.ours.measured[0][0] / spring, 2), found.name)
        };
        let entered: Vec<String> = findings.iter().map(entered).collect();
        text += "\n";
        text += &format!(
            include_str!("page.md"),
            coverage = COVERAGE,
            tight = TIGHT,
            kappa = KAPPA,
            entered = entered.join(", ")
        );
        text += "\n";
        text += &picture(PICTURE, "Relative difference of independent codes to ours, a sign a scene");
        Ok(text)
    }

    /// How far each script is from us, a row a script and a sign a scene.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        Ok(vec![(PICTURE.into(), apart(findings).drawing())])
    }
}

/// The chart of differences.
const PICTURE: &str = "difference-independent.svg";

/// Peak and width as they are told: noun, unit with the symbol where that differs from scene to scene, factor from MPa,
/// mm or rad to it.
fn numbers(scene: Scene) -> [(&'static str, &'static str, f64); 2] {
    let scene = scene.benchmark().case.scene;
    let path = &scene.contact().path;
    let unit = if path.is_straight() { "a [mm]" } else { "2 √(∫pθ²/∫p) [°]" };
    [("peak pressure", "[MPa]", 1.0), ("second-moment width", unit, display_factor(path))]
}

fn of_script(compared: &Compared, other: &Other) -> Vec<Judged> {
    let (scene, script) = (compared.scene, other.script);
    let (demanded, of_profile) = demanded(scene, script);
    let theirs = |value: f64| Reference {
        name: script.title().into(),
        kind: ReferenceKind::CrossCode,
        value,
        uncertainty: None,
    };
    let because = format!("at most {TIGHT} times what is found; {COVERAGE} u_val is asked beside it");
    let mut judged: Vec<Judged> = other.reproduced.iter().cloned().collect();
    for (k, (noun, unit, factor)) in numbers(scene).into_iter().enumerate() {
        let [[mine, own], [value, uncertainty]] =
            [&compared.ours, &other.found].map(|found| found.measured[k].map(|one| factor * one));
        let reference = || Reference { uncertainty: Some(uncertainty), ..theirs(value) };
        judged.extend(demanded[k].map(|tolerance| {
            let near = Check::near(Quantity::at(noun, unit), reference(), tolerance, because.clone()).judge(mine);
            Judged { uncertainty: Some(own), ..near }
        }));
        let (springs, sources) = match script.has_penalty() {
            true => (factor * compared.penalty[k], "both meshes; theirs without what its springs add"),
            false => (0.0, "both meshes"),
        };
        let comparison = Comparison::of(mine, value - springs, [own, uncertainty]);
        judged.push(covered(&format!("{noun}, {unit}"), reference(), comparison, sources));
    }
    let difference = l2(&compared.ours.profile, &other.found.profile);
    let quantity = Quantity::at("difference of the profile", format!("L2(p) over {STATIONS} stretches"));
    judged.push(Check::error(quantity, theirs(0.0), of_profile, because).judge(difference));
    judged.push(carried(compared, other));
    let resultant =
        Check::near("resultant [N]", theirs(other.found.resultant), RESULTANT, "equilibrium on either mesh");
    judged.push(resultant.judge(compared.ours.resultant));
    judged
}

/// The profile of a script shall carry the force that its contact transmits: areas and pressures belong together.
fn carried(compared: &Compared, other: &Other) -> Judged {
    let carries = compared.scene.benchmark().carries();
    let same = other.found.profile.len() == carries.len();
    let force: f64 = other.found.profile.iter().zip(&carries).map(|(pressure, carries)| pressure * carries).sum();
    let quantity = Quantity::at("force of the profile [N]", other.script.title());
    let reference = Reference::own("resultant of the same script", other.found.resultant);
    let because = "means over stretches, linear between integration points; at most three times what is found";
    Check::near(quantity, reference, CARRIED, because).judge(if same { force } else { f64::NAN })
}

/// `√( Σ (p − q)² / Σ q² )`; NaN where the lengths differ.
fn l2(p: &[f64], q: &[f64]) -> f64 {
    if p.len() != q.len() {
        return f64::NAN;
    }
    let error: f64 = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum();
    (error / q.iter().map(|q| q * q).sum::<f64>()).sqrt()
}

/// The most a tolerance may exceed what is found.
const TIGHT: f64 = 3.0;
/// Difference of the force of a profile to the resultant that is accepted.
const CARRIED: f64 = 4e-4;
/// Difference of resultants that is accepted: equilibrium to the tolerance of their iterations.
const RESULTANT: f64 = 1e-5;

/// Relative agreement of peak, width and profile: at most three times what is found; none of a peak or a width where
/// that is below u_val of both meshes, which leaves room for more, but for facet pairs, whose springs may otherwise be
/// ten times as soft unseen.
fn demanded(scene: Scene, script: Script) -> ([Option<f64>; 2], f64) {
    match (script, scene) {
        // Springs soften the cylinders by 1e-4; the square-root edge lies within one stretch of the profile.
        (Script::Ufl, Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz) => ([None, Some(1.7e-4)], 1e-2),
        (Script::Facets, Scene::WiderCylinder) => ([Some(1.8e-4), Some(1.6e-4)], 4.5e-3),
        (Script::Facets, Scene::Cylinder | Scene::TruncatedHertz) => ([None, Some(1.6e-4)], 4.5e-3),
        (Script::Pairs, Scene::PinRod) => ([Some(1.2e-4), Some(8e-5)], 5e-3),
        (Script::Pairs, Scene::PinPlate) => ([Some(2e-5), Some(2.5e-5)], 2.8e-3),
        (Script::Facets, Scene::PinRod | Scene::PinPlate) => ([None; 2], 5e-3),
        // Nitsche's method has no springs: only meshes differ.
        (Script::Nitsche, Scene::Cylinder) => ([None; 2], 6.5e-4),
        (Script::Nitsche, Scene::WiderCylinder) => ([Some(4e-5), Some(4e-5)], 1.7e-3),
        (Script::Nitsche, Scene::TruncatedHertz) => ([None, Some(2.7e-5)], 7e-4),
        (Script::Nitsche, Scene::PinRod) => ([None; 2], 9e-4),
        (Script::Nitsche, Scene::PinPlate) => ([None; 2], 4e-3),
        // Pressures are linear between the nodes of the boundary, and an edge of the contact moves within a node's
        // distance.
        (Script::HalfPlane, Scene::TruncatedHertz) => ([Some(5e-6), Some(5e-5)], 1e-3),
        // Edges move within elements: widths wander by 1e-4 from mesh to mesh.
        (Script::Augmented, Scene::PinRod) => ([None, Some(5e-5)], 3e-3),
        (Script::Augmented, Scene::PinPlate) => ([Some(6e-5), None], 3e-3),
        (Script::Gaps, Scene::PinRod) => ([Some(2e-4), Some(2.5e-4)], 3e-3),
        (Script::Gaps, Scene::PinPlate) => ([Some(8e-5), None], 3e-3),
        // Not served.
        (Script::Ufl | Script::HalfPlane, Scene::PinRod | Scene::PinPlate)
        | (Script::HalfPlane, Scene::Cylinder | Scene::WiderCylinder)
        | (
            Script::Pairs | Script::Augmented | Script::Gaps,
            Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz,
        ) => ([None; 2], f64::NAN),
    }
}

/// Relative differences to ours: of the profile, the peak, and the width.
fn differences(compared: &Compared, other: &Other) -> [f64; 3] {
    let of = |k: usize| (other.found.measured[k][0] / compared.ours.measured[k][0] - 1.0).abs();
    [l2(&compared.ours.profile, &other.found.profile), of(0), of(1)]
}

/// The largest of each is told, and every one drawn.
fn apart(findings: &[Found<Compared>]) -> Chart {
    let all = || findings.iter().flat_map(|found| found.numbers.others.iter().map(move |one| (found.numbers, one)));
    let mut rows: Vec<Script> =
        Script::ALL.into_iter().filter(|script| all().any(|(_, one)| one.script == *script)).collect();
    rows.reverse();
    let most = |of: fn([f64; 3]) -> f64| {
        markdown::error(all().map(|(ours, one)| of(differences(ours, one))).fold(0.0, f64::max))
    };
    let [profile, numbers] = [most(|[profile, ..]| profile), most(|[_, peak, width]| larger(peak, width))];
    let title = format!("Other codes differ from ours by up to {numbers} in peak and width, {profile} in the profile");
    let names = rows.iter().map(|script| script.title().to_owned()).collect();
    let mut chart = Chart::new(&title, Axis::log("relative difference to ours [–]"), Axis::rows(names));
    let signs = [
        ("profile, root mean square", palette::LAYER, Marker::Square),
        ("peak", palette::NODE, Marker::Diamond),
        ("second-moment width", palette::LINE, Marker::Circle),
    ];
    for (k, (label, colour, marker)) in signs.into_iter().enumerate() {
        let place =
            |script: Script| rows.iter().position(|one| *one == script).map_or(f64::NAN, |row| row as f64 + 1.0);
        let points =
            all().map(|(ours, one)| (differences(ours, one)[k], place(one.script) + BESIDE * (1.0 - k as f64)));
        chart.series.push(Series::new(label, points, Style::run(colour, Dash::Absent, marker)));
    }
    chart
}

/// Between the signs of a row.
const BESIDE: f64 = 0.22;
