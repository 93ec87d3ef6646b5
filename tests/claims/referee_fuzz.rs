//! One answer in every format is judged alike, and refused where it is cut; what mutations do to it is asked by the
//! fuzz target `handed`.

use std::path::Path;

use contact_vv::case::library::find;
use contact_vv::cli::vtu;
use contact_vv::error::Error;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::referee::export::{deck, own};
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::{Answer, Asked, Truth, calculix, read, verdicts};
use contact_vv::solve::Formulation;

use crate::balance::solved_on;
use crate::foreign::forces;
use crate::handed::moved;

/// Our own answer to a coarse cylinder, in every format that is read; tables of CalculiX stand behind their deck.
fn formats() -> (Truth, Vec<(&'static str, String)>, String) {
    let case = find("truncated-hertz", None).expect("a case");
    let resolution = Resolution { elements: 4, refinement: 0, order: Order::Quadratic };
    let (discretisation, run) = solved_on(case.scene.clone(), resolution, &Formulation::verification());
    let json = serde_json::to_string_pretty(&own::answer("truncated-hertz", &discretisation, &run)).expect("JSON");
    let points = run.solution.points_of(0);
    let rows = points.iter().map(|p| format!("{},{},{},{}\n", p.position, p.pressure, p.gap, p.weight));
    let csv = format!("position [mm],pressure [MPa],gap [mm],area [mm2]\n{}", rows.collect::<String>());
    let vtu = vtu::text(&discretisation, &run).expect("written");
    let deck = deck::text(&discretisation).expect("written");
    let first = discretisation.mesh.points.len();
    let rows = points.iter().enumerate().map(|(k, p)| (first + 2 * k + 2, -p.pressure * p.weight));
    let dat = forces("GAPS_CONTACT", "0.1000000E+01", rows);
    let formats = vec![
        ("a.csv", csv),
        ("a.json", json),
        ("a.vtu", vtu),
        ("a.frd", crate::referee_calculix::frd(&discretisation, &run)),
        ("a.dat", dat),
    ];
    (Truth::of(case).expect("solved"), formats, deck)
}

fn parsed(truth: &Truth, name: &str, text: &str, deck: &str) -> Result<Answer, Error> {
    let (file, asked) = (Path::new(name), Asked { order: Some(Order::Quadratic), ..moved() });
    match name {
        "a.dat" => calculix::forces(file, text, deck, &truth.case.scene, &asked),
        _ => read::parse(file, text.as_bytes(), &truth.case, &asked),
    }
}

#[test]
fn one_answer_in_every_format_is_judged_alike() {
    let (truth, formats, deck) = formats();
    let measured = |(name, text): &(&str, String)| {
        let answer = parsed(&truth, name, text, &deck).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found = verdicts(&truth, answer, ENGINEERING).expect("judged");
        let measures = &found.ruled[0].measures;
        [measures.peak.pressure, measures.second_moment_width, measures.resultant, measures.edge()]
    };
    let [wanted, others @ ..] = &formats.iter().map(measured).collect::<Vec<_>>()[..] else { panic!("formats") };
    for (other, (name, _)) in others.iter().zip(&formats[1..]) {
        for (found, wanted) in other.iter().zip(wanted) {
            // Six digits of tables and fields.
            assert!((found - wanted).abs() <= 3e-5 * wanted.abs(), "{name}: {other:?} for {wanted:?}");
        }
    }
}

#[test]
fn truncated_files_are_refused_in_every_format() {
    let (truth, formats, deck) = formats();
    for (name, text) in formats.iter().filter(|(name, _)| *name != "a.csv") {
        for part in [0.3, 0.7] {
            let cut: String = text.chars().take((part * text.len() as f64) as usize).collect();
            let refused = parsed(&truth, name, cut.trim_end_matches(|c: char| c != ' '), &deck);
            let met = refused.and_then(|answer| verdicts(&truth, answer, ENGINEERING)).is_ok_and(|found| found.met());
            assert!(!met, "{name}, cut at {part}");
        }
    }
}
