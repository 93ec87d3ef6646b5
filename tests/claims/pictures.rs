//! The picture of a run: it draws what was solved, whatever came out; and a solve as one HTML file.

use std::process::Command;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::Case;
use contact_vv::clock::{Clock, Stage};
use contact_vv::drawing::{Chart, Direction, Mark, Slope};
use contact_vv::report::pictures::{deformed, solve};
use contact_vv::solve::{Discretisation, Run};

use crate::balance::solved_as_it_says;
use crate::figures::covered;
use crate::outputs::{contact_vv, json, refuses};
use crate::program::{Folder, ended};
use crate::scene_file::{self, text_of};

struct Solved {
    problem: Case,
    discretisation: Discretisation,
    run: Run,
}

fn solved(name: &str) -> Solved {
    let problem = scene_file::case(name);
    let (discretisation, run) = solved_as_it_says(&problem);
    Solved { problem, discretisation, run }
}

impl Solved {
    fn svg(&self) -> String {
        let sheet = solve::sheet(&self.problem, &self.discretisation, &self.run).expect("composed");
        sheet.drawing().expect("drawn")
    }
}

#[test]
fn no_text_of_a_sheet_covers_a_sign_or_another_text() {
    let mut found = Vec::new();
    for name in ["cylinder-on-block", "whole-disc", "three-rings", "moment", "rigid-pin", "roller-between-plates"] {
        found.extend(covered(&solved(name).svg()).into_iter().map(|one| format!("{name}: {one}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Closed outlines in all paths of an SVG.
fn areas(svg: &str) -> usize {
    let paths = svg.split("<path d=\"").skip(1).filter_map(|rest| rest.split('"').next());
    paths.map(|path| path.matches('Z').count()).sum()
}

#[test]
fn picture_has_shape_pressure_and_iteration_error_and_is_valid() {
    for name in ["blocks", "press-fit", "cylinder-on-block", "flat-punch"] {
        let svg = solved(name).svg();
        assert_eq!((ill_formed(&svg), svg.matches("<svg").count()), (None, 1), "{name}");
        assert!(areas(&svg) > 20, "{name}: no bands");
        assert!(
            svg.contains("role=\"img\"") && svg.split('<').nth(2).is_some_and(|tag| tag.starts_with("title")),
            "{name}: no name for those who hear it"
        );
        for text in ["von Mises stress", "Contact pressure", "Iteration error", "tolerance", "Displacements ×"] {
            assert!(svg.contains(text), "{name}: no `{text}`");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    }
}

#[test]
fn factor_on_displacements_is_round_and_makes_the_largest_a_twentieth_of_the_bodies() {
    for (factor, round) in [(1.0, 1.0), (1.3, 1.0), (1.5, 2.0), (3.0, 2.0), (3.3, 5.0), (7.2, 10.0), (0.0021, 0.002)] {
        assert_abs_diff_eq!(deformed::round_factor(factor), round, epsilon = 0.0);
    }
    for nothing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_abs_diff_eq!(deformed::round_factor(nothing), 1.0, epsilon = 0.0);
    }
    for name in ["blocks", "press-fit", "cylinder-on-block", "rigid-cosine"] {
        let Solved { discretisation, run, .. } = solved(name);
        let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
        let ends = |pick: fn(&(f64, f64)) -> f64| {
            let of = || field.points.iter().map(pick);
            of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min)
        };
        let largest = field.displacements.iter().map(|shift| shift.0.hypot(shift.1)).fold(0.0, f64::max);
        let share = field.magnification * largest / ends(|p| p.0).max(ends(|p| p.1));
        // A factor 1, 2, 5, 10 … is at most √2.5 away from any number.
        assert!((0.05 / 1.59..0.05 * 1.59).contains(&share), "{name}: {share}");
    }
}

#[test]
fn drawn_fields_are_those_of_the_solution() {
    let Solved { discretisation, run, .. } = solved("cylinder-on-block");
    let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
    let fields = discretisation.recover(&run.solution).expect("recovered");
    let stresses = discretisation.von_mises(&fields);
    assert_eq!(field.values.len(), stresses.len());
    for (node, &[x, y]) in fields.displacement.iter().enumerate() {
        assert_eq!(field.displacements[node], (x, y));
        assert_eq!(field.values[node].to_bits(), stresses[node].to_bits());
    }
}

#[test]
fn detail_holds_the_contact_as_truly_displaced_and_is_marked_where_the_whole_draws_it() {
    let Solved { discretisation, run, .. } = solved("cylinder-on-block");
    let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
    let zoom = field.details.first().expect("a contact of a twentieth of the radius is enlarged").clone();
    assert_abs_diff_eq!(zoom.magnification, 1.0, epsilon = 0.0);
    let within = |(from, to): (f64, f64), x: f64| from <= x && x <= to;
    let candidates = discretisation.mesh.bodies.iter().flat_map(|body| &body.candidates);
    let touching: Vec<_> = candidates.filter(|candidate| candidate.coordinate <= run.measures().edge()).collect();
    assert!(touching.len() > 20);
    for candidate in touching {
        let (point, shift) = (field.points[candidate.node], field.displacements[candidate.node]);
        let drawn = |factor: f64| (point.0 + factor * shift.0, point.1 + factor * shift.1);
        for (window, (x, y)) in [(zoom.window, drawn(1.0)), (zoom.marked, drawn(field.magnification))] {
            assert!(within(window.x, x) && within(window.y, y), "node {}: {x}, {y} in {window:?}", candidate.node);
        }
    }
    // The middle of the contact stands at the same place in both frames.
    let first = discretisation.mesh.bodies[discretisation.scene.contact().first].candidates.iter();
    let first: Vec<usize> = first.filter(|at| at.coordinate <= run.measures().edge()).map(|at| at.node).collect();
    let middle = |factor: f64, pick: fn((f64, f64)) -> f64| {
        let drawn = first.iter().map(|&node| pick(field.points[node]) + factor * pick(field.displacements[node]));
        drawn.sum::<f64>() / first.len() as f64
    };
    let by = |pick: fn((f64, f64)) -> f64| middle(field.magnification, pick) - middle(1.0, pick);
    assert_abs_diff_eq!(zoom.marked.x.0 - zoom.window.x.0, by(|p| p.0), epsilon = 1e-12);
    assert_abs_diff_eq!(zoom.marked.y.1 - zoom.window.y.1, by(|p| p.1), epsilon = 1e-12);
    assert!(by(|p| p.1).abs() > 0.1);

    let Solved { discretisation, run, .. } = solved("press-fit");
    let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
    assert!(field.details.is_empty(), "contact all around is not enlarged");
    let Solved { discretisation, run, .. } = solved("roller-between-plates");
    let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
    let named: Vec<&str> = field.details.iter().map(|detail| detail.name.as_str()).collect();
    assert_eq!(named, ["above", "below"], "every contact has its detail");
}

/// Points of the curve of a name.
fn curve(chart: &Chart, label: &str) -> Vec<(f64, f64)> {
    let series = chart.series.iter().find(|series| series.label == label);
    series.unwrap_or_else(|| panic!("no `{label}`")).points.clone()
}

#[test]
fn charts_hold_the_pressures_and_the_iteration_error_of_every_step() {
    let Solved { problem, run, .. } = solved("press-fit");
    let chart = solve::pressure(&problem, &run, 0);
    for (drawn, point) in curve(&chart, "node · kinematic").into_iter().zip(&run.solution.points) {
        assert_relative_eq!(drawn.0, point.position.to_degrees(), max_relative = 1e-14);
        assert_abs_diff_eq!(drawn.1, point.pressure, epsilon = 0.0);
    }
    let (low, high) = chart.y.range.expect("a range");
    assert!(low.abs() <= 0.0 && high > run.measures().peak.pressure, "a uniform pressure looks uniform");

    let mut run = solved("cylinder-on-block").run;
    let last = run.solution.history.len() - 1;
    run.solution.history[0].error.force = f64::NAN;
    run.solution.history[1].error.force = f64::INFINITY;
    let chart = solve::iteration_error(&run);
    let force = curve(&chart, "force");
    assert!(force[0].1.is_nan() && force[1].1.is_nan());
    for (label, of) in [
        ("peak", (|iteration| iteration.error.peak) as fn(&contact_vv::solution::Iterated) -> f64),
        ("force", |iteration| iteration.error.force),
    ] {
        for (k, (step, drawn)) in run.solution.history.iter().zip(curve(&chart, label)).enumerate() {
            assert_abs_diff_eq!(drawn.0, (k + 1) as f64, epsilon = 0.0);
            let value = of(step);
            if value.is_finite() && value > 0.0 {
                assert_abs_diff_eq!(drawn.1, value, epsilon = 0.0);
            } else {
                assert!(drawn.1.is_nan(), "{label}, step {k}");
            }
        }
        assert_eq!(curve(&chart, label).len(), last + 1);
    }
    let [guide] = chart.guides.as_slice() else { panic!("one guide") };
    assert_eq!(guide.direction, Direction::Horizontal);
    assert_abs_diff_eq!(guide.at, run.formulation.settings.tolerance, epsilon = 0.0);
    assert_eq!(ill_formed(&chart.drawing().expect("drawn")), None);
}

#[test]
fn run_without_numbers_without_steps_or_without_contact_is_drawn() {
    let mut broken = solved("cylinder-on-block");
    broken.problem.name = "a & b < c".into();
    broken.run.solution.displacement.fill(f64::NAN);
    broken.run.solution.points.iter_mut().for_each(|point| point.pressure = f64::NAN);
    let svg = broken.svg();
    assert_eq!(ill_formed(&svg), None);
    assert!(svg.contains("no finite displacements") && !svg.contains("von Mises"), "nothing to draw is said");
    broken.run.solution.history.clear();
    assert_eq!(ill_formed(&broken.svg()), None);

    let mut open = solved("blocks");
    open.run.solution.points.iter_mut().for_each(|point| point.pressure = 0.0);
    open.run.contacts[0].measures.active = 0;
    open.run.contacts[0].open = Some(true);
    let svg = open.svg();
    assert_eq!(ill_formed(&svg), None);
    assert!(svg.contains("No contact: every candidate is open."), "no contact is said");
}

#[test]
fn command_draws_what_did_not_converge_and_shows_no_progress_where_there_is_no_terminal() {
    let folder = Folder::made();
    let text = text_of("cylinder-in-metres.toml");
    let solve = |text: &str| contact_vv(&["solve", &folder.with("few.toml", text), "--plot", &folder.at("few.svg")]);
    let (sound, _, error) = solve(&text);
    assert!(sound && error.is_empty(), "{error}");
    assert!(!solve(&text.replace("[solve]", "[solve]\nmax-iterations = 2")).0);
    let svg = folder.read("few.svg");
    assert_eq!(ill_formed(&svg), None);
    assert!(svg.contains("not converged after 2 iterations"));
}

#[test]
fn stages_are_announced_in_their_order() {
    let Solved { problem, .. } = solved("blocks");
    let heard = std::cell::RefCell::new(Vec::new());
    let begins = |stage| heard.borrow_mut().push(stage);
    let discretisation = Discretisation::timed(problem.scene, problem.resolution, Clock::telling(&begins));
    // Each body is condensed on its own; its seconds are told with those of the others.
    let seconds = discretisation.expect("discretised").seconds;
    let timed: Vec<Stage> = seconds.iter().map(|(stage, _)| *stage).collect();
    assert_eq!(timed, Stage::ALL[..=Stage::Interface as usize]);
    let mut heard = heard.into_inner();
    assert_eq!([heard[0], heard[heard.len() - 1]], [Stage::Mesh, Stage::Interface]);
    heard.sort_unstable();
    heard.dedup();
    assert_eq!(heard, timed);
}

#[test]
fn a_slope_triangle_has_the_slope_of_its_order_and_legs_along_the_axes() {
    for (order, above) in [(1.0, false), (2.0, true)] {
        let [start, end, corner] = Slope { ends: [0.04, 0.09], value: 3e-4, order, above }.corners();
        assert_relative_eq!((end.1 / start.1).ln() / (end.0 / start.0).ln(), order, max_relative = 1e-12);
        let expected = if above { (start.0, end.1) } else { (end.0, start.1) };
        assert_relative_eq!(corner.0, expected.0);
        assert_relative_eq!(corner.1, expected.1);
    }
}

#[test]
fn supports_loads_rigid_sides_and_the_undeformed_outline_are_drawn_where_a_scene_has_them() {
    let meant =
        ["triangles: fixed", "arrows: loads and prescribed displacements", "hatched: rigid", "dashed: undeformed"];
    for (name, shown) in [
        ("blocks", [true, true, false, true]),
        ("cylinder-to-accuracy", [true, true, true, true]),
        ("press-fit", [true, false, false, true]),
    ] {
        let svg = solved(name).svg().to_lowercase().replace('\n', " ");
        let told = meant.map(|text| svg.contains(text));
        assert_eq!(told, shown, "{name}");
    }
}

#[test]
fn marks_lie_on_the_sides_that_are_held_loaded_and_rigid() {
    let Solved { discretisation, run, .. } = solved("cylinder-to-accuracy");
    let field = deformed::field(&discretisation, &run).expect("recovered").expect("finite");
    let (mut fixed, mut pushed, mut rigid) = (0, 0, 0);
    for mark in &field.marks {
        match mark {
            Mark::Fixed(node, along) => {
                assert!(field.points[*node].0.abs() < 1e-9 && along.0 < 0.0, "the axis is held from its left");
                fixed += 1;
            }
            Mark::Pushed(_, along) => {
                assert!(along.1 < -0.99, "the load acts downwards");
                pushed += 1;
            }
            Mark::Rigid(points) => {
                for [at, into] in points {
                    assert_abs_diff_eq!(at.1, points[0][0].1, epsilon = 1e-3);
                    assert!(into.1 < 0.0, "the plane lies below");
                }
                rigid += points.len();
            }
        }
    }
    assert!(fixed > 5 && pushed > 5 && rigid > 5, "{fixed}, {pushed}, {rigid}");
}

/// Tags that are opened and not closed, or closed and not opened; what is no markup at all.
pub fn ill_formed(text: &str) -> Option<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut pieces = text.split('<');
    pieces.next()?;
    for piece in pieces {
        let Some((tag, rest)) = piece.split_once('>') else { return Some(format!("no end: {piece:.60}")) };
        let entities = rest
            .split('&')
            .skip(1)
            .all(|one| ["amp;", "lt;", "gt;", "quot;", "apos;", "#"].iter().any(|e| one.starts_with(e)));
        let is_style = open.last() == Some(&"style");
        if !is_style && (rest.contains('>') || !entities) {
            return Some(format!("not escaped: {rest:.60}"));
        }
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        match name.strip_prefix('/') {
            _ if name.starts_with('!') || tag.ends_with('/') => {}
            Some(name) if open.pop() == Some(name) => {}
            Some(_) => return Some(format!("closed: {name}")),
            None => open.push(name),
        }
    }
    (!open.is_empty()).then(|| format!("open: {open:?}"))
}

/// A browser that shows no window, where one is installed.
fn browser() -> Option<&'static str> {
    let all = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    all.into_iter().find(|name| Command::new(name).arg("--version").output().is_ok_and(|told| told.status.success()))
}

#[test]
fn a_solve_is_one_html_file_that_needs_nothing_else() {
    let folder = Folder::made();
    let title = "steel < 5 mm & \"{{input}}\"";
    let text = text_of("two-cylinders.toml");
    let line = text.lines().find(|line| line.starts_with("title")).expect("a title");
    let mine = folder.with("mine.toml", text.replace(line, &format!("title = '{title}'")));
    let html = folder.at("run.html");
    let (sound, _, error) = contact_vv(&["solve", &mine, "--html", &html]);
    assert!(sound, "{error}");
    let page = folder.read("run.html");
    assert_eq!(ill_formed(&page), None);
    assert!(page.contains("<p>steel &lt; 5 mm &amp; &quot;{{input}}&quot;</p>"), "escaped, and not filled in again");
    for outside in ["<script", " src=", "href=\"http", "url(http", "@import"] {
        assert!(!page.contains(outside), "{outside}");
    }
    let document = json(&["solve", &mine]);
    for list in ["error_bars", "checks"] {
        let key = if list == "checks" { "requirement" } else { "quantity" };
        for one in document[list].as_array().expect("a list") {
            let told = one[key].as_str().expect("a text").replace('<', "&lt;");
            assert!(page.contains(&told), "{told}");
        }
    }
    // Verdict, requirement, value, reference and error, in this order.
    for one in document["checks"].as_array().expect("checks") {
        let told = one["requirement"].as_str().expect("a text").replace('<', "&lt;");
        let [_, row] = page.split(&format!("<td>{told}</td>")).collect::<Vec<_>>()[..] else { panic!("{told}") };
        let cells: Vec<&str> = row.split("</td>").map(|cell| cell.trim_start_matches("<td>")).take(3).collect();
        let number = |k: usize| cells[k].split(' ').next().and_then(|word| word.parse::<f64>().ok());
        for (k, key) in ["value", "reference"].into_iter().enumerate() {
            let [found, wanted] = [number(k), one[key].as_f64()];
            assert!(
                found.zip(wanted).is_some_and(|(a, b)| (a - b).abs() <= 1e-5 * b.abs() + 1e-12),
                "{key}: {cells:?}, {one}"
            );
        }
    }
    assert!(page.contains("<svg") && page.contains("prefers-color-scheme: dark") && page.contains("[[body]]"));
    // Written once more it replaces itself, and nothing else.
    assert!(contact_vv(&["solve", &mine, "--html", &html, "--no-error-bar"]).0);
    refuses(&["solve", &mine, "--html", &mine], &[".html"]);
    match browser() {
        None => println!("no Chromium is installed: the page was not opened in a browser"),
        Some(browser) => {
            let options = ["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", &format!("file://{html}")];
            let (_, shown, _) = ended(Command::new(browser).args(options));
            assert!(["peak pressure", "</svg>", "</html>"].iter().all(|part| shown.contains(part)), "{shown:.500}");
        }
    }
}
