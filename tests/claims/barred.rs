//! Checks beside the error bars of what they judge, and that bars which do not hold would be seen.

use contact_vv::accuracy::bars;
use contact_vv::case::{Judged, Scope, Verdict};
use contact_vv::measure::Quantity;
use contact_vv::oracle::ReferenceKind;
use contact_vv::study::Study;
use contact_vv::study::promised::Numbers;

use crate::scene_file;

/// The judged checks of a scene file, with the bars of `solve`.
fn judged(file: &str) -> (Vec<Judged>, Vec<(usize, Quantity, f64)>) {
    let case = scene_file::case(file);
    let (meshed, run) = case.solve().expect("a run");
    let bars = bars(&meshed.discretisation, &run, &case.displaced()).expect("bars");
    let bars = bars.all.into_iter().map(|one| (one.contact, one.quantity, one.bar.total())).collect();
    (case.judge(&meshed, &run).expect("judged"), bars)
}

#[test]
fn checks_carry_the_bars_that_solve_prints() {
    for file in ["two-cylinders", "eccentric-load", "press-fit"] {
        let (judged, bars) = judged(file);
        let mut carried = 0;
        for one in judged.iter().filter(|one| one.check.scope == Scope::Own) {
            let Some(number) = one.barred() else {
                assert!(one.bar.is_none(), "{file}: {}", one.check.quantity);
                continue;
            };
            let bar = one.bar.expect("a bar");
            let wanted = bars.iter().find(|(contact, other, _)| *contact == one.check.contact && other == number);
            let wanted = one.check.quantity.factor() * wanted.expect("a bar of solve").2;
            // The coarser meshes are iterated to another tolerance, of which round-off is left.
            let size = one.value.abs();
            assert!((bar - wanted).abs() <= 1e-6 * bar + 1e-7 * size, "{file}, {number:?}: {bar}, {wanted}");
            carried += 1;
        }
        assert!(carried > 0, "{file}");
    }
}

#[test]
fn too_many_errors_beyond_their_bars_turn_the_claim_red_and_are_listed() {
    let all: Vec<Judged> =
        ["two-cylinders", "eccentric-load", "press-fit"].iter().flat_map(|file| judged(file).0).collect();
    let of = |spoil: &dyn Fn(f64) -> f64| {
        let spoiled: Vec<Judged> = all.iter().map(|one| Judged { bar: one.bar.map(spoil), ..one.clone() }).collect();
        let numbers = Numbers::of_checks(spoiled.iter().map(|one| ("a trial".to_string(), one)));
        let verdict = numbers.judge().expect("judged")[0].verdict.clone();
        match numbers {
            Numbers::Checks(all, outside) => (verdict, outside.len(), all),
            other => panic!("{other:?}"),
        }
    };
    // One shear stress is 1.04 bars off.
    let (verdict, outside, counted) = of(&|bar| 1.1 * bar);
    assert_eq!((verdict, outside), (Verdict::Pass, 0));
    let analytic = |one: &&Judged| one.reference.kind == ReferenceKind::Analytic;
    assert_eq!(counted, all.iter().filter(analytic).filter(|one| one.barred().is_some()).count());
    let (verdict, outside, _) = of(&|bar| 1e-3 * bar);
    assert!(verdict == Verdict::Fail && outside > 0, "{outside}");
    assert_eq!(of(&|_| f64::NAN).1, counted, "what is not known is outside");
    // What the closed form is off itself is no error of the number.
    let one = all.iter().find(|one| one.bar.is_some()).expect("a bar").clone();
    let narrow = Judged { bar: Some(0.0), error: 1e-3, ..one };
    let excused = |model: f64| Judged { check: narrow.check.clone().leaving(model), ..narrow.clone() }.is_within_bar();
    assert_eq!([excused(1e-4), excused(2e-3)], [Some(false), Some(true)]);
    let none = Numbers::of_checks(std::iter::empty());
    assert_eq!(none.judge().expect("judged")[0].verdict, Verdict::Fail);
}
