//! Charts are read on light and on dark pages, and by those who see no green.

use std::collections::BTreeSet;

use contact_vv::checkout::root;
use contact_vv::drawing::palette::{self, CARD, CLASSES, CURVES, Dash, INK, Marker, ON_CLASSES};
use contact_vv::drawing::theme::Rgb;
use contact_vv::drawing::{
    Axis, Bars, Cell, Chart, ClassMap, Colour, ColourMap, Detail, Direction, Drawing, Field, Guide, MapPanel, Remark,
    Series, Style, Theme, Window, panels, schematic,
};
use contact_vv::markdown::significant;
use contact_vv::study::fields::walk;
use contact_vv::study::timings::precision::Point;
use contact_vv::study::timings::record::{Record, cheapest, front, sound};
use contact_vv::study::timings::{COMPARED_CODES, conclusion, front_of};
use svg::node::element::path::{Command, Data};

use crate::letters;

/// Linear red, green and blue (IEC 61966-2-1, as in WCAG 2.1).
fn linear(Rgb(red, green, blue): Rgb) -> [f64; 3] {
    [red, green, blue].map(|channel| {
        let share = f64::from(channel) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    })
}

/// What deuteranopes see: Machado, Oliveira & Fernandes 2009, severity 1, on linear channels.
fn deuteranopia(seen: [f64; 3]) -> [f64; 3] {
    let rows =
        [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]];
    rows.map(|row: [f64; 3]| row.iter().zip(seen).map(|(a, b)| a * b).sum::<f64>().clamp(0.0, 1.0))
}

fn luminance([red, green, blue]: [f64; 3]) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Contrast ratio of WCAG 2.1.
fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [a, b] = [a, b].map(|colour| luminance(colour) + 0.05);
    a.max(b) / a.min(b)
}

#[test]
fn contrast_is_that_of_the_published_examples() {
    let of = |a: Rgb, b: Rgb| contrast(linear(a), linear(b));
    let (black, white, grey) = (Rgb(0, 0, 0), Rgb(255, 255, 255), Rgb(0x76, 0x76, 0x76));
    assert!((of(black, white) - 21.0).abs() < 1e-9);
    assert!((of(grey, white) - 4.54).abs() < 5e-3, "{}", of(grey, white));
}

#[test]
fn any_two_classes_of_a_map_differ_in_brightness_for_deuteranopes_too() {
    for theme in Theme::ALL {
        for (k, first) in CLASSES.iter().enumerate() {
            for (l, second) in CLASSES.iter().enumerate().skip(k + 1) {
                let [a, b] = [first, second].map(|colour| linear(colour.on(theme)));
                let ratios = [contrast(a, b), contrast(deuteranopia(a), deuteranopia(b))];
                assert!(ratios.iter().all(|ratio| *ratio >= 1.5), "{theme:?}: classes {k} and {l}: {ratios:.2?}");
            }
        }
        for (k, (class, text)) in CLASSES.iter().zip(ON_CLASSES).enumerate() {
            let ratio = contrast(linear(class.on(theme)), linear(text.on(theme)));
            assert!(ratio >= 4.5, "{theme:?}: text on class {k}: {ratio:.2}");
        }
    }
}

/// A chart with everything that a chart can hold.
fn full() -> Chart {
    let mut chart = Chart::new("everything", Axis::log("x [mm]"), Axis::log("y [MPa]"));
    let points = vec![(1.0, 1.0), (10.0, 100.0), (1000.0, 30.0)];
    for (k, colour) in CURVES.into_iter().enumerate() {
        let style = Style::run(colour, Dash::Dashed, if k % 2 == 0 { Marker::Circle } else { Marker::Dot });
        chart.series.push(Series { label: format!("curve {k}"), points: points.clone(), style, hollow: vec![3.0] });
    }
    chart.guides.push(Guide { direction: Direction::Horizontal, at: 10.0, label: "a guide".into() });
    chart.bars.push(Bars { label: "bars".into(), ends: vec![[(2.0, 1.0), (2.0, 9.0)]], colour: palette::PURPLE });
    let at = (10.0, 100.0);
    chart.remarks.push(Remark { at, text: "7 ms".into(), ring: Some("rings".into()), colour: palette::ORANGE });
    chart.notes.push("A note.".into());
    chart
}

/// A map with every class, and a boundary.
fn map() -> ClassMap {
    let cell = |class: usize| Cell { class, label: format!("{class}"), predicted: Some(class < 3) };
    let rows = vec![("1".to_string(), (0..CLASSES.len()).map(cell).collect())];
    ClassMap {
        title: "every class".into(),
        axes: ["across [–]".into(), "up".into()],
        panels: vec![MapPanel { title: "a panel".into(), rows }],
        columns: 1,
        ticks: vec![(0, "10⁻⁶".into())],
        classes: (0..CLASSES.len()).map(|class| format!("class {class}")).collect(),
        boundary: Some("the boundary".into()),
        notes: vec![],
    }
}

fn drawings() -> Vec<Drawing> {
    let problem = schematic("problem", include_str!("../../src/report/pictures/contact-problem.svg"), &[]);
    let elements = schematic("elements", include_str!("../../src/report/pictures/contact-elements.svg"), &[]);
    vec![problem, elements, full().drawing(), map().drawing()]
}

/// The value of an attribute in a tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
    rest.split('"').next()
}

fn colour(text: &str) -> Rgb {
    let channel = |k: usize| u8::from_str_radix(&text[k..k + 2], 16).expect("a colour");
    Rgb(channel(1), channel(3), channel(5))
}

/// What a colour of a light page becomes on a dark one, by the style sheet of a drawing.
fn dark(svg: &str, light: &str) -> String {
    let rule = |what: &str| svg.split_once(&format!("[{what}=\"{light}\"]{{{what}:")).map(|(_, rest)| &rest[..7]);
    assert_eq!(rule("fill"), rule("stroke"), "{light}");
    rule("fill").unwrap_or(light).to_owned()
}

#[test]
fn text_and_lines_of_written_charts_stand_out_on_their_card() {
    for (number, drawing) in drawings().iter().enumerate() {
        let svg = drawing.as_ref().expect("drawn");
        assert!(svg.contains("<style>\n@media(prefers-color-scheme:dark){\n["), "{number}");
        for theme in Theme::ALL {
            let on = |light: &str| if theme == Theme::Light { light.to_owned() } else { dark(svg, light) };
            let card = CARD.on(theme);
            assert_eq!(on(&CARD.on(Theme::Light).to_string()), card.to_string());
            let tags = || svg.split('<').filter_map(|part| part.split_once('>')).map(|(tag, _)| tag);
            // The numbers on the cells of the map are held against the cells above.
            let cells: BTreeSet<String> = ON_CLASSES.iter().map(|colour| colour.on(theme).to_string()).collect();
            let ink = INK.on(Theme::Light).to_string();
            let texts = tags().filter(|tag| tag.starts_with("text"));
            let texts: Vec<String> = texts.map(|tag| on(attribute(tag, "fill").unwrap_or(&ink))).collect();
            assert!(!texts.is_empty());
            for fill in texts.iter().filter(|fill| !cells.contains(*fill)) {
                let ratio = contrast(linear(colour(fill)), linear(card));
                let coloured = CURVES.iter().any(|curve| curve.on(theme).to_string() == *fill);
                assert!(ratio >= 4.5 || (coloured && ratio >= 3.0), "{number} {theme:?}: text {fill}: {ratio:.2}");
            }
            let lines = tags().filter(|tag| tag.starts_with("path") && attribute(tag, "fill") == Some("none"));
            let wide = |tag: &&str| {
                attribute(tag, "stroke-width")
                    .and_then(|width| width.parse().ok())
                    .is_some_and(|width: f64| width >= 0.9)
            };
            // The rim of the card that a line over cells has is no line of its own.
            let strokes = lines.filter(wide).filter_map(|tag| attribute(tag, "stroke")).map(on);
            for stroke in strokes.filter(|stroke| *stroke != card.to_string()) {
                let ratio = contrast(linear(colour(&stroke)), linear(card));
                assert!(ratio >= 3.0, "{number} {theme:?}: a line {stroke}: {ratio:.2}");
            }
        }
    }
}

#[test]
fn colour_that_would_be_two_on_dark_pages_is_refused() {
    let mut chart = full();
    chart.remarks[0].colour = Colour::new(0x0072B2, 0x112233);
    let refused = chart.drawing().expect_err("two partners").to_string();
    assert!(refused.contains("#0072B2 is both #112233 and #5AA9E6 on dark pages"), "{refused}");
}

#[test]
fn numbers_of_a_schematic_stand_where_it_asks_for_them() {
    let svg = "<svg><text fill=\"#222222\">R = {R} mm</text></svg>";
    let drawn = schematic("one", svg, &[("R", -0.1 - 0.2)]).expect("drawn");
    assert!(drawn.ends_with("<text fill=\"#222222\">R = −0.3 mm</text></svg>"), "{drawn}");
    assert_eq!(dark(&drawn, "#222222"), "#E8E8E5");
    let refused = |svg: &str, numbers: &[(&str, f64)]| schematic("one", svg, numbers).expect_err("refused").to_string();
    assert!(refused(svg, &[]).contains("`R` has no number"));
    assert!(refused(svg, &[("R", f64::NAN)]).contains("`R` = NaN has no place"));
    assert!(refused(svg, &[("R", 1.0), ("q", 1.0)]).contains("`q` = 1 has no place"));
    assert!(refused("<svg fill=\"#123456\"/>", &[]).contains("#123456 has no dark partner"));
}

#[test]
fn everything_that_is_drawn_is_in_the_legend() {
    let svg = full().drawing().expect("drawn");
    for text in ["curve 0", "curve 5", "a guide", "bars", "rings", "7 ms", "hollow: not converged", "A note."] {
        assert!(svg.contains(&format!("\n{text}\n")), "no `{text}`");
    }
    let svg = map().drawing().expect("drawn");
    for text in ["class 0", "class 6", "the boundary", "across [–]", "up", "10⁻⁶"] {
        assert!(svg.contains(&format!("\n{text}\n")), "no `{text}`");
    }
}

#[test]
fn no_point_is_both_cheaper_and_as_exact_as_one_of_the_front() {
    let points = Record::read().expect("the committed record").points;
    let own = sound(&points);
    let cost = |point: &Point| point.seconds;
    let worst = Point::worst;
    let front = front(&own, cost);
    assert!(front.len() > 3);
    let beats = |a: &Point, b: &Point| cost(a) < cost(b) && worst(a) <= worst(b);
    assert!(front.iter().all(|kept| own.iter().all(|other| !beats(other, kept))));
    for other in own.iter().filter(|other| !front.iter().any(|kept| std::ptr::eq(*kept, **other))) {
        assert!(
            front.iter().any(|kept| cost(kept) <= cost(other) && worst(kept) <= worst(other)),
            "left out for nothing"
        );
    }
    let within = |most: f64| cheapest(own.iter().copied(), worst, most);
    let best = within(1e-3).expect("within 0.1 %");
    assert!(front.iter().any(|kept| std::ptr::eq(*kept, best)));
    assert!(own.iter().filter(|point| worst(point) <= 1e-3).all(|point| cost(point) >= cost(best)));
    assert!(within(0.0).is_none() && within(f64::NAN).is_none());
}

#[test]
fn whoever_is_cheaper_at_an_accuracy_is_said_to_be_and_the_table_has_the_seconds_of_the_chart() {
    // As the page tells it: other codes may have been asked on another machine, with ours beside them.
    let mut record = Record::read().expect("the committed record").in_one_run();
    let said = conclusion(&record);
    for (name, series, _) in COMPARED_CODES {
        let within = front_of(&record, series).into_iter().find(|point| point.worst() <= 1e-3).expect("within 0.1 %");
        let [seconds, off] = [1e3 * within.seconds, 100.0 * within.worst()].map(|number| significant(number, 2));
        let told = format!(" {seconds} ms, {off} % off ");
        assert!(said.contains(name) && said.contains(&told), "{name}: {told} in {said}");
    }
    let ours = COMPARED_CODES[0].1;
    assert!(said.starts_with("The fastest on truncated Hertz: **ours, 8-node cells** to 0.1"), "{said}");
    record.points.iter_mut().filter(|point| ours.contains(&point.series)).for_each(|point| point.seconds *= 1e3);
    let slower = conclusion(&record);
    assert!(slower.contains("NGSolve everywhere, down to ") && !slower.contains("**ours, 8-node"), "{slower}");
}

/// A rectangle: left, top, right, bottom.
type Bounds = [f64; 4];

fn number(tag: &str, name: &str) -> Option<f64> {
    attribute(tag, name)?.parse().ok()
}

/// The boxes of the signs of a drawing: discs, and small filled outlines.
fn signs(svg: &str) -> Vec<Bounds> {
    let tags = svg.split('<').filter_map(|part| part.split_once('>')).map(|(tag, _)| tag);
    let of = |tag: &str| {
        if tag.starts_with("circle") {
            let [x, y, r] = ["cx", "cy", "r"].map(|name| number(tag, name).expect("a number"));
            // What lies under a number to hide lines is no sign.
            return (attribute(tag, "fill") != Some(&CARD.on(Theme::Light).to_string())).then_some([
                x - r,
                y - r,
                x + r,
                y + r,
            ]);
        }
        let outline = attribute(tag, "d")
            .filter(|d| tag.starts_with("path") && d.ends_with('Z') && d.matches('M').count() == 1)?;
        let places = outlines(outline).concat();
        let ends = |k: usize| {
            let all = || places.iter().map(|at| at[k]);
            [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
        };
        let ([left, right], [top, bottom]) = (ends(0), ends(1));
        (right - left < 14.0 && bottom - top < 14.0).then_some([left, top, right, bottom])
    };
    // What a frame cuts off is not seen.
    let (mut window, mut clip): (Option<Bounds>, Option<Bounds>) = (None, None);
    let mut all: Vec<Bounds> = Vec::new();
    for tag in tags {
        if tag.starts_with("rect") {
            let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(tag, name).unwrap_or(0.0));
            window = Some([x, y, x + width, y + height]);
        } else if tag.starts_with("g clip-path") {
            clip = window;
        } else if tag == "/g" {
            clip = None;
        } else if let Some([left, top, right, bottom]) = of(tag) {
            let [a, b, c, d] = clip.unwrap_or([f64::NEG_INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY]);
            let seen = [left.max(a), top.max(b), right.min(c), bottom.min(d)];
            all.extend((seen[0] < seen[2] && seen[1] < seen[3]).then_some(seen));
        }
    }
    all
}

/// The boxes of the texts of a drawing with the texts.
fn texts(svg: &str) -> Vec<(String, Bounds)> {
    let parts = svg.split("<text").skip(1).filter_map(|part| part.split_once('>'));
    let of = |(tag, rest): (&str, &str)| {
        let words = rest.split('<').next().unwrap_or_default().trim().replace("&gt;", ">");
        let [x, y] = ["x", "y"].map(|name| number(tag, name).expect("a number"));
        let size = number(tag, "font-size").unwrap_or(11.0);
        let (width, half) = (letters::width(&words, attribute(tag, "font-weight").is_some()) * size, 0.35 * size);
        let (from, to) = match attribute(tag, "text-anchor") {
            Some("middle") => (-0.5 * width, 0.5 * width),
            Some(_) => (-width, 0.0),
            None => (0.0, width),
        };
        let upright = attribute(tag, "transform").is_some();
        let bounds =
            if upright { [x - half, y - to, x + half, y - from] } else { [x + from, y - half, x + to, y + half] };
        (words, bounds)
    };
    parts.map(of).collect()
}

/// Texts that cover a sign, or one another, or go beyond the card.
pub fn covered(svg: &str) -> Vec<String> {
    let overlap = |a: &Bounds, b: &Bounds| a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
    let (signs, texts) = (signs(svg), texts(svg));
    let [across, down] = ["width", "height"].map(|name| number(svg, name).expect("a size"));
    let mut covered = Vec::new();
    for (k, (words, bounds)) in texts.iter().enumerate() {
        if signs.iter().any(|sign| overlap(sign, bounds)) {
            covered.push(format!("`{words}` on a sign"));
        }
        if bounds[0] < 0.0 || bounds[1] < 0.0 || bounds[2] > across || bounds[3] > down {
            covered.push(format!("`{words}` beyond the card"));
        }
        let others = texts[k + 1..].iter().filter(|(_, other)| overlap(other, bounds));
        covered.extend(others.map(|(other, _)| format!("`{words}` on `{other}`")));
    }
    covered
}

#[test]
fn no_text_of_a_committed_chart_covers_a_sign_or_another_text() {
    let folder = root().join("snapshots/charts");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("charts are committed").flatten() {
        let svg = std::fs::read_to_string(entry.path()).expect("read");
        found.extend(covered(&svg).into_iter().map(|one| format!("{}: {one}", entry.file_name().display())));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn words_beside_points_give_way_to_signs_and_to_one_another() {
    let mut chart = Chart::new("crowded", Axis::linear("x"), Axis::linear("y"));
    let points: Vec<(f64, f64)> = (0..12).map(|k| (f64::from(k), 0.1 * f64::from(k * k))).collect();
    chart.series.push(Series::new("", points.clone(), Style::run(palette::LINE, Dash::Solid, Marker::Circle)));
    for at in [points[5], points[6], points[7], points[11]] {
        chart.remarks.push(Remark { at, text: "some words".into(), ring: None, colour: palette::LAYER });
    }
    let svg = chart.drawing().expect("drawn");
    assert_eq!(svg.matches("some words").count(), 4);
    assert!(covered(&svg).is_empty(), "{:?}", covered(&svg));
    // A sign where the words stand is seen.
    let (_, [left, top, right, bottom]) =
        texts(&svg).into_iter().find(|(words, _)| words == "some words").expect("set");
    let [x, y] = [0.5 * (left + right), 0.5 * (top + bottom)];
    let spoiled = svg.replace("</svg>", &format!("<circle cx=\"{x}\" cy=\"{y}\" fill=\"#0072B2\" r=\"4\"/></svg>"));
    assert_eq!(covered(&spoiled), ["`some words` on a sign"]);
    let narrower = svg.replacen(&format!("width=\"{}\"", number(&svg, "width").expect("a size")), "width=\"300\"", 1);
    assert!(covered(&narrower).iter().any(|one| one.ends_with("beyond the card")));
}

/// The outlines of a path that moves from point to point.
fn outlines(path: &str) -> Vec<Vec<[f64; 2]>> {
    let (mut all, mut at): (Vec<Vec<[f64; 2]>>, _) = (vec![], [0.0; 2]);
    for command in Data::parse(path).expect("a path").iter() {
        let steps: Vec<[f32; 2]> = match command {
            Command::Move(_, steps) | Command::Line(_, steps) => {
                steps.chunks(2).map(|step| [step[0], step[1]]).collect()
            }
            Command::HorizontalLine(_, steps) => steps.iter().map(|x| [*x, 0.0]).collect(),
            Command::VerticalLine(_, steps) => steps.iter().map(|y| [0.0, *y]).collect(),
            _ => vec![],
        };
        if let Command::Move(..) = command {
            all.push(vec![]);
        }
        for step in steps {
            at = [0, 1].map(|k| at[k] + f64::from(step[k]));
            all.last_mut().expect("a move").push(at);
        }
        if let Command::Close = command {
            at = all[all.len() - 1][0];
        }
    }
    all
}

/// How often some outlines go round a place.
fn winding(outlines: &[Vec<[f64; 2]>], [x, y]: [f64; 2]) -> i32 {
    let of = |outline: &Vec<[f64; 2]>| {
        let sides = outline.iter().zip(outline.iter().cycle().skip(1));
        let crossing = |([x0, y0], [x1, y1]): (&[f64; 2], &[f64; 2])| match (*y0 <= y, *y1 <= y) {
            (below, after) if below != after && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0) => i32::from(after) * 2 - 1,
            _ => 0,
        };
        sides.map(crossing).sum::<i32>()
    };
    outlines.iter().map(of).sum()
}

/// The middle of a text of a drawing, and its left end.
fn place_of(svg: &str, words: &str) -> ([f64; 2], f64) {
    let found = texts(svg).into_iter().find(|(text, _)| text == words);
    let (_, [left, top, right, bottom]) = found.unwrap_or_else(|| panic!("no `{words}`"));
    ([0.5 * (left + right), 0.5 * (top + bottom)], left)
}

/// The middles of the discs of a colour.
fn discs(svg: &str, of: Colour) -> Vec<[f64; 2]> {
    let tags = svg.split('<').filter(|part| part.starts_with("circle"));
    let own = tags.filter(|tag| attribute(tag, "fill").map(colour) == Some(of.on(Theme::Light)));
    own.map(|tag| ["cx", "cy"].map(|name| number(tag, name).expect("a number"))).collect()
}

/// Places are written to tenths of a pixel, and texts are set a little below the middle of their line.
const SET: f64 = 1.5;

#[test]
fn points_stand_where_the_numbers_on_linear_and_logarithmic_axes_say() {
    let mut chart = Chart::new("places", Axis::log("x"), Axis::linear("y"));
    // Half and two thirds of three decades; one below zero.
    let points = [(1.0, -2.0), (1000_f64.sqrt(), -1.0), (100.0, 1.0), (1000.0, 2.0)];
    chart.series.push(Series::new("", points, Style::run(palette::LINE, Dash::Solid, Marker::Circle)));
    let svg = chart.drawing().expect("drawn");
    let discs = discs(&svg, palette::LINE);
    let across = ["1", "10", "100", "1000"].map(|label| {
        // The number that stands lowest is that of the axis across.
        let all = texts(&svg).into_iter().filter(|(text, _)| text == label);
        let lowest = all.max_by(|(_, a), (_, b)| a[3].total_cmp(&b[3])).unwrap_or_else(|| panic!("no `{label}`"));
        0.5 * (lowest.1[0] + lowest.1[2])
    });
    let decade = (across[3] - across[0]) / 3.0;
    for (k, label) in across.iter().enumerate() {
        assert!((label - across[0] - k as f64 * decade).abs() < SET, "{across:?}");
    }
    for (disc, decades) in discs.iter().zip([0.0, 1.5, 2.0, 3.0]) {
        assert!((disc[0] - across[0] - decades * decade).abs() < SET, "{discs:?} over {across:?}");
    }
    for (disc, label) in [(&discs[0], "−2.0"), (&discs[1], "−1.0"), (&discs[3], "2.0")] {
        assert!((disc[1] - place_of(&svg, label).0[1]).abs() < SET, "{label}: {discs:?}");
    }
}

#[test]
fn an_iteration_walks_upright_to_its_next_spring_and_along_that_to_its_next_state() {
    // From (1, 1) to (2, 4) on a spring of stiffness 2, whose pressure at w = 1 is 4 − 2 (2 − 1) = 2.
    assert_eq!(walk(&[[1.0, 1.0, 1.0], [2.0, 4.0, 2.0]]), [(1.0, 1.0), (1.0, 2.0), (2.0, 4.0)]);
}

#[test]
fn a_text_of_the_legend_stands_beside_the_sign_of_its_own_curve() {
    let mut chart = Chart::new("legend", Axis::linear("x"), Axis::linear("y"));
    let named = [("the first", palette::LINE), ("the second", palette::NODE), ("the third", palette::PURPLE)];
    for (k, (label, colour)) in named.into_iter().enumerate() {
        let points = [(0.0, k as f64), (1.0, k as f64 + 0.5)];
        chart.series.push(Series::new(label, points, Style::run(colour, Dash::Solid, Marker::Circle)));
    }
    let svg = chart.drawing().expect("drawn");
    for (label, colour) in named {
        let ([_, y], left) = place_of(&svg, label);
        let beside = |disc: &[f64; 2]| (disc[1] - y).abs() < SET && (0.0..60.0).contains(&(left - disc[0]));
        let signs: Vec<Colour> =
            named.map(|(_, own)| own).into_iter().filter(|own| discs(&svg, *own).iter().any(beside)).collect();
        assert_eq!(signs, [colour], "{label}");
    }
}

#[test]
fn a_place_of_a_field_has_the_colour_that_the_bar_has_between_the_numbers_around_its_value() {
    let bilinear = |_: usize, [x, y]: [f64; 2]| {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[a, b]| 0.25 * (1.0 + a * x) * (1.0 + b * y)).to_vec()
    };
    // From 0 on the left side of a square to 10 on the right.
    let field = Field {
        title: "a slope".into(),
        quantity: "height".into(),
        points: vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
        cells: vec![vec![0, 1, 2, 3]],
        shapes: bilinear,
        values: vec![0.0, 10.0, 10.0, 0.0],
        displacements: vec![(0.0, 0.0); 4],
        magnification: 0.0,
        map: ColourMap::Sequential,
        range: Some((0.0, 10.0)),
        details: vec![],
        marks: vec![],
        notes: vec![],
    };
    let svg = field.drawing().expect("drawn");
    let filled = svg.split('<').filter(|part| part.starts_with("path")).filter_map(|tag| {
        let fill = attribute(tag, "fill").filter(|fill| *fill != "none")?;
        Some((fill.to_owned(), outlines(attribute(tag, "d")?)))
    });
    let filled: Vec<(String, Vec<Vec<[f64; 2]>>)> = filled.collect();
    let (painted, bar) = filled.split_at(filled.len() - 10);
    let ends = |areas: &[(String, Vec<Vec<[f64; 2]>>)]| {
        let all = areas.iter().flat_map(|(_, outlines)| outlines.concat()).map(|at| at[0]);
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let on = |areas: &[(String, Vec<Vec<[f64; 2]>>)], at: [f64; 2]| {
        let top = areas.iter().rev().find(|(_, outlines)| winding(outlines, at) != 0);
        top.unwrap_or_else(|| panic!("nothing at {at:?}")).0.clone()
    };
    let ([left, right], beside) = (ends(painted), ends(bar));
    let y = painted[0].1[0][0][1] + 100.0;
    for k in 0..10 {
        let [below, above] = [k, k + 1].map(|n| place_of(&svg, &n.to_string()).0[1]);
        let at = [left + (right - left) * (f64::from(k) + 0.5) / 10.0, y];
        assert_eq!(
            on(painted, at),
            on(bar, [0.5 * (beside[0] + beside[1]), 0.5 * (below + above)]),
            "between {k} and {}",
            k + 1
        );
    }
    // A detail is as many times as large as what is framed in the whole.
    let window = Window { x: (0.4, 0.6), y: (0.4, 0.6) };
    let svg = Field { details: vec![Detail::of(window, 0.0)], ..field }.drawing().expect("drawn");
    let frame = |pen: &str| {
        let mut tags = svg.split('<').filter(|tag| attribute(tag, "stroke-width") == Some(pen));
        let own = tags.find_map(|tag| Some(outlines(attribute(tag, "d")?).concat())).expect("a frame");
        own.iter().map(|at| at[0]).fold(f64::NEG_INFINITY, f64::max) - own[0][0].min(own[1][0]).min(own[2][0])
    };
    let (_, told) = svg.split_once("framed ×").expect("a name");
    let told: f64 = told.split('<').next().and_then(|text| text.trim().parse().ok()).expect("a number");
    assert!((told - frame("1.2") / frame("1.4")).abs() < 0.1 && told > 2.0, "{told}");
}

#[test]
fn cells_of_a_class_are_one_area_with_its_holes() {
    // A ring, a hole that touches it at a corner, an island.
    let classes = [[0, 0, 0, 0, 1], [0, 1, 0, 0, 0], [0, 0, 1, 1, 0], [0, 0, 1, 0, 0], [2, 0, 0, 0, 0]];
    let cell = |class: usize| Cell { class, label: String::new(), predicted: None };
    let rows = classes.map(|row| ("1".to_string(), row.map(cell).to_vec())).to_vec();
    let panels = vec![MapPanel { title: "a panel".into(), rows }];
    let svg = ClassMap { panels, ..map() }.drawing().expect("drawn");
    let paths = |class: usize| {
        let own = format!("\" fill=\"{0}\" stroke=\"{0}\"", CLASSES[class].on(Theme::Light));
        let before = svg.split(&own).next().expect("a path").rsplit("<path d=\"").next().expect("a path");
        outlines(before)
    };
    let areas = [0, 1, 2].map(paths);
    let ends = |k: usize| {
        let all = || areas.iter().flatten().flatten().map(|at| at[k]);
        [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([left, right], [top, bottom]) = (ends(0), ends(1));
    for (row, cells) in classes.iter().enumerate() {
        for (column, class) in cells.iter().enumerate() {
            let [x, y] = [(column as f64 + 0.5) / 5.0, (row as f64 + 0.5) / 5.0];
            let at = [left + x * (right - left), bottom - y * (bottom - top)];
            let found = areas.each_ref().map(|area| winding(area, at) != 0);
            assert_eq!(found, [0, 1, 2].map(|one| one == *class), "{row}, {column}: {svg}");
        }
    }
    // Corners at which nothing turns are none.
    assert!(areas[2] == [areas[2][0].clone()] && areas[2][0].len() == 4 && areas[0].len() <= 4, "{areas:?}");
}

#[test]
fn note_that_several_charts_share_is_written_once() {
    let notes = |charts: &[Chart]| panels("charts", charts, 2).expect("drawn").to_string().matches("A note.").count();
    assert!(notes(&[full()]) > 0);
    assert_eq!(notes(&[full(), full()]), notes(&[full()]));
}
