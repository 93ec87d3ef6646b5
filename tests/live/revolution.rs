//! scikit-fem and dolfinx answer of bodies of revolution what was frozen.

use contact_vv::error::Error;
use contact_vv::oracle::cross_code::frozen::Asked;
use contact_vv::oracle::cross_code::revolution::{Answer, Revolution};
use contact_vv_live::asked;
use libtest_mimic::{Failed, Trial};

/// Scripts whose codes the set-up of the tests installs.
const SCRIPTS: [&str; 2] = ["skfem_forms", "ufl_forms"];
/// Meshes that are asked: the finest takes as long as both of these ten times.
const LEVELS: usize = 2;
/// Largest relative difference by other versions and other direct solvers.
const SAME: f64 = 1e-6;

/// A trial a script and scene.
pub fn trials() -> Vec<Trial> {
    let of = |script: &'static str| {
        ["sphere", "truncated-sphere"].map(|case| {
            let name = format!("{script} answers of a {case} of revolution what is frozen");
            Trial::test(name, move || answers(script, case).map_err(|error| Failed::from(error.to_string())))
        })
    };
    SCRIPTS.into_iter().flat_map(of).collect()
}

fn answers(script: &str, case: &str) -> Result<(), Error> {
    let Asked { scene, answers } = &Revolution::built_in()?.scenes[case];
    for (level, kept) in answers[script].series.iter().take(LEVELS).enumerate() {
        let now = asked::revolution(script, scene, level)?;
        assert_eq!(now.physical.dofs, kept.physical.dofs, "{script}, {case}, mesh {level}");
        let scale = kept.physical.peak;
        for ((name, now), (_, kept)) in numbers(&now, scale).into_iter().zip(numbers(kept, scale)) {
            let change = (now - kept).abs() / kept.abs().max(1e-3);
            assert!(change <= SAME, "{script}, {case}, mesh {level}, {name}: {now} for {kept}, {change:e}");
        }
    }
    Ok(())
}

/// All that is told, pressures over the peak.
fn numbers(answer: &Answer, peak: f64) -> Vec<(&'static str, f64)> {
    let Answer { physical, approach } = answer;
    let all = [
        ("radius", physical.half_width),
        ("peak", physical.peak),
        ("resultant", physical.resultant),
        ("approach", *approach),
    ];
    all.into_iter().chain(physical.pressure.iter().map(|p| ("pressure", p / peak))).collect()
}
