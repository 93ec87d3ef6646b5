//! Usual mistakes: what turns an answer that does not meet its truth into one that does is named.
//!
//! A mistake is a correction of positions and pressures. Loads, radii and moduli enter by the powers of Hertz's
//! contact, `a ∝ √(PR/E*)`, `p ∝ √(PE*/R)`, of bodies of revolution `a ∝ ∛(FR/E*)`, `p ∝ ∛(FE*²/R²)`, and by those of a
//! contact whose width is given.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::case::Verdict;
use crate::measure::Quantity;
use crate::mesh::Order;
use crate::referee::answer::{Handed, Point, places};
use crate::referee::judge::{fails_by_width, judge};
use crate::referee::norm;
use crate::referee::profile::{HALF, Profile, ended, from_axis, tributary};
use crate::referee::truth::Truth;
use crate::referee::units::{Role, Units, is_angle};
use crate::scene::{ContactPair, PlaneHypothesis, Scene};
use crate::solution::EdgeState;

/// What a correction says, and the answer that it makes.
type Correction = (String, Handed);

/// The mistakes that explain an answer: each turns what fails into what passes. Gaps take no part.
///
/// `beside` are its units, as the file or --unit calls them, and whether its displacements have the strain energy of
/// the scene: loads, radii and moduli are right then.
pub fn explain(truth: &Truth, handed: &Handed, beside: (&Units, bool), tolerance: f64) -> Vec<String> {
    let plain = thinned(handed);
    let failed = |profile: &Profile| {
        let judged = judge(truth, profile, tolerance).judged.into_iter();
        judged.filter(|judged| judged.verdict == Verdict::Fail).collect::<Vec<_>>()
    };
    let meets = |one: &Handed| {
        let profile = Profile::of(&truth.case.scene, &ended(truth, one));
        !fails_by_width(truth, &profile, tolerance) && failed(&profile).is_empty()
    };
    let own = failed(&Profile::of(&truth.case.scene, &ended(truth, &plain)));
    if own.is_empty() {
        return vec![];
    }
    // What is off at single points is no matter of how they are summed.
    let is_sum =
        |number: &Quantity| matches!(number, Quantity::Resultant | Quantity::SecondMomentWidth | Quantity::Centre);
    let are_sums = || own.iter().all(|judged| judged.check.quantity.number().is_some_and(is_sum));
    let may_have = plain.order == Order::Linear && plain.edges.is_empty() && (plain.forces || are_sums());
    let quadratic = || {
        let points = from_axis((&truth.case.scene, plain.contact), plain.points.clone(), Order::Quadratic);
        Handed { order: Order::Quadratic, points, ..plain.clone() }
    };
    let has_told = plain.order == Order::Quadratic && plain.forces && plain.is_told;
    let corners = has_told.then(|| (CORNERS.into(), Handed { order: Order::Linear, ..plain.clone() }));
    let mid_sides = may_have.then(|| (MID_SIDES.into(), quadratic())).or(corners);
    let is_it = |(says, corrected): Correction| (sound(&corrected) && meets(&corrected)).then_some(says);
    let others = truth.case.scene.contacts.iter().enumerate().filter(|(contact, _)| *contact != plain.contact);
    let own_name = &truth.case.scene.contacts[plain.contact].name;
    let swapped = others.map(|(contact, pair)| {
        (
            format!("the points of contact `{own_name}` are those of contact `{}`", pair.name),
            Handed { contact, ..plain.clone() },
        )
    });
    let of_others: Vec<String> = swapped.filter_map(is_it).collect();
    if !of_others.is_empty() {
        return of_others;
    }
    let found: Vec<String> = corrections(truth, &plain, beside).chain(mid_sides).filter_map(is_it).collect();
    if !found.is_empty() || plain.points.iter().map(|point| point.value).sum::<f64>() >= 0.0 {
        return found;
    }
    let turned = scaled(&plain, -1.0, 1.0, 1.0);
    let both = corrections(truth, &turned, beside).filter_map(is_it);
    both.map(|says| format!("{NEGATIVE}; and {says}")).collect()
}

/// Every correction that is tried, most of them made one by one.
fn corrections<'a>(
    truth: &'a Truth,
    handed: &'a Handed,
    beside: (&Units, bool),
) -> impl Iterator<Item = Correction> + use<'a> {
    let is_circle = truth.case.scene.is_around_axis(handed.contact);
    let scales = scales(truth, handed, beside).into_iter();
    let scaled = scales.map(move |(says, [pressure, place])| {
        (says, scaled(handed, pressure, place, if is_circle { place * place } else { place }))
    });
    scaled.chain(of_points(truth, handed))
}

/// Corrections of the points one by one. What moves values among them says nothing of means over edges that were handed
/// in beside them.
fn of_points(truth: &Truth, handed: &Handed) -> Vec<Correction> {
    let (scene, pair) = (&truth.case.scene, &truth.case.scene.contacts[handed.contact]);
    let (is_circle, has_both_sides) = (scene.is_around_axis(handed.contact), pair.path.has_both_sides());
    let is_half = handed.points[0].position >= 0.0 && !has_both_sides;
    let are_alone = handed.edges.is_empty();
    let mut all: Vec<Correction> = Vec::new();
    let mut tried = |says: &str, corrected: Handed| all.push((says.to_owned(), corrected));
    if scene.is_of_revolution() && handed.forces {
        let around = |point: &Point| scene.depth(pair.path.point(point.position)) * point.value;
        let corrected = moved(handed, |point| Point { value: around(point), ..*point });
        // Of nodes or of the edges between them.
        tried("nodal forces are pressures times lengths: 2πr is forgotten", Handed { edges: vec![], ..corrected });
    }
    if are_alone {
        let before = off(truth, handed);
        let shifts = shifts(scene, handed).into_iter().filter(|(_, moved)| off(truth, moved) <= EXPLAINED * before);
        shifts.for_each(|(says, shifted)| tried(&says, shifted));
        let [corners, between] = [0, 1].map(|first| handed.points.iter().copied().skip(first).step_by(2));
        let is_middle = |three: &[Point]| {
            HALF.contains(&((three[1].position - three[0].position) / (three[2].position - three[0].position)))
        };
        let are_middles = || handed.points.windows(3).step_by(2).all(is_middle);
        if !handed.forces && between.clone().all(|point| point.value.abs() <= 0.0) && are_middles() {
            let corrected = Handed { order: Order::Linear, ..with(handed, corners) };
            tried("every second node is a mid-side with a pressure of 0: hand in the corners alone", corrected);
        }
        if !is_circle && !is_half {
            halves(handed).into_iter().for_each(|(says, half)| tried(&says, half));
        }
    }
    if are_alone {
        let says = match handed.forces {
            true => "pressures are called forces",
            false => "nodal forces are called pressures",
        };
        tried(says, Handed { forces: !handed.forces, ..handed.clone() });
    }
    if handed.points.iter().any(|point| point.area.is_some()) {
        let says = "areas are not those of the points: leave them out, they follow from the places";
        tried(says, moved(handed, |point| Point { area: None, ..*point }));
    }
    if are_alone && !pair.path.is_straight() {
        let is_within = |point: &Point| point.position.abs() <= pair.stretch * (1.0 + ALIKE);
        let stretch = pair.stretch.to_degrees();
        let says = format!("the scene has a part of the ring: hand in its points up to {stretch:.4}°");
        tried(&says, with(handed, handed.points.iter().copied().filter(is_within)));
        from_other_lines(handed).into_iter().for_each(|(says, turned)| tried(&says, turned));
    }
    let middle = pair.path.origin()[0];
    if are_alone && pair.path.is_straight() && scene.plane.radial() == Some(0) && middle > 0.0 {
        let says = format!(
            "positions are radii: count them from the middle of the contact, at r = {}",
            places(pair, &[middle])
        );
        tried(&says, moved(handed, |point| Point { position: point.position - middle, ..*point }));
    }
    if has_both_sides {
        let edges = handed.edges.iter().rev().map(EdgeState::mirrored).collect();
        let turned = moved(handed, |point| Point { position: 0.0 - point.position, ..*point });
        tried("positions run the other way: change their sign", Handed { edges, ..turned });
    }
    if handed.forces && are_alone && is_half && !is_circle && handed.points[0].position.abs() <= 0.0 {
        let mut one = handed.clone();
        one.points[0].value *= 0.5;
        // Of a model of both halves, of which one half of the nodes is handed in.
        tried("the force on the symmetry line is that of both halves: halve it", one);
    }
    all
}

/// The answer with other points, in the order of the contact coordinate.
fn with(handed: &Handed, points: impl Iterator<Item = Point>) -> Handed {
    let mut points: Vec<Point> = points.collect();
    points.sort_by(|a, b| a.position.total_cmp(&b.position));
    Handed { points, ..handed.clone() }
}

/// The answer with each of its points made another.
fn moved(handed: &Handed, other: impl Fn(&Point) -> Point) -> Handed {
    with(handed, handed.points.iter().map(other))
}

/// Angles of one half of a contact that are counted from another line than the load line, either way round.
fn from_other_lines(handed: &Handed) -> Vec<Correction> {
    let turned = |(quarters, sign): (u16, f64)| {
        let off = f64::from(quarters) * FRAC_PI_2;
        let turned = moved(handed, |point| Point { position: sign * (point.position - off), ..*point });
        let says = format!("angles are counted from a line {}° off the load line", 90 * quarters);
        (turned.points[0].position >= 0.0 - ALIKE).then_some((says, turned))
    };
    (1..4).flat_map(|quarters| [(quarters, 1.0), (quarters, -1.0)]).filter_map(turned).collect()
}

/// Factors on pressures and on positions: numbers that are called others, then, unless the scene was solved, another
/// scene; units that are called others, and numbers without, where nothing else has the same.
fn scales(truth: &Truth, handed: &Handed, (own, is_of_scene): (&Units, bool)) -> Vec<(String, [f64; 2])> {
    let scene = &truth.case.scene;
    let is_circle = scene.is_around_axis(handed.contact);
    let mut all = called(scene, handed);
    if !is_of_scene {
        let others = if is_circle { of_revolution(truth, handed) } else { of_strips(truth, handed) };
        all.extend(others.into_iter().map(|(says, by)| (says.to_owned(), by)));
    }
    let others = units(&scene.contacts[handed.contact], handed, own, is_circle).into_iter();
    for (says, [times, by]) in others.chain(normalised(truth, handed)) {
        let is_alike = |known: &[f64; 2]| (times / known[0] - 1.0).hypot(by / known[1] - 1.0) < ALIKE;
        if !all.iter().any(|(_, known)| is_alike(known)) {
            all.push((says, [times, by]));
        }
    }
    all
}

/// Error of the profile that is left by what explains it: any shift of about as much as positions are off is near.
const EXPLAINED: f64 = 0.2;

/// Error of the mean pressures over edges, relative in L2.
fn off(truth: &Truth, handed: &Handed) -> f64 {
    let profile = Profile::of(&truth.case.scene, handed);
    norm::of_means(&profile.edges, |s| truth.pressure(handed.contact, s))
}

/// What is said of another order.
const MID_SIDES: &str = "every second point is a mid-side: hand them in with --order 2";
const CORNERS: &str = "every point is a corner: hand them in with --order 1";
/// What is said of the other sign.
const NEGATIVE: &str =
    "pressures are negative in compression: hand them in with --tension-positive, or without it where it was given";
/// Difference of factors that no answer tells apart.
const ALIKE: f64 = 1e-3;
/// Points by which mistakes are told.
const ENOUGH: usize = 20_000;
/// Part of the half-width at which the sides are apart where the contact widens.
const NEAR_END: f64 = 0.9;

/// Angles of the sectors that are modelled of bodies of revolution \[°\]: 2 by CalculiX, 180 as one half.
const SECTORS: [f64; 10] = [1.0, 2.0, 3.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0];

/// Signs, diameters and parts of the whole: numbers of the scene that are called others.
fn called(scene: &Scene, handed: &Handed) -> Vec<(String, [f64; 2])> {
    let is_circle = scene.is_around_axis(handed.contact);
    let [doubled, halved] = match is_circle {
        true => ["a diameter for a radius", "a radius for a diameter"],
        false => ["a width for a half-width", "a half-width for a width"],
    };
    let mut all = vec![(NEGATIVE.to_owned(), [-1.0, 1.0])];
    if scene.contacts[handed.contact].path.is_straight() {
        all.push((format!("positions are doubled: {doubled}"), places_alone(handed, is_circle, 0.5)));
        all.push((format!("positions are halved: {halved}"), places_alone(handed, is_circle, 2.0)));
    }
    if scene.is_of_revolution() && handed.forces {
        all.push(("nodal forces are per radian: 2π is forgotten".into(), [TAU, 1.0]));
        all.extend(SECTORS.map(|angle| {
            let by = 360.0 / angle;
            (format!("nodal forces are those of a sector of {angle}°: they are to be multiplied by {by}"), [by, 1.0])
        }));
    }
    if handed.forces && (scene.thickness - 1.0).abs() > 0.0 {
        let text = format!("forces are per unit thickness, but the scene is {} mm thick", scene.thickness);
        all.push((text, [scene.thickness, 1.0]));
    }
    all
}

/// Positions times a factor: forces are what they are wherever they act, so that pressures are less by the area.
fn places_alone(handed: &Handed, is_circle: bool, by: f64) -> [f64; 2] {
    [if handed.forces { by.powi(if is_circle { -2 } else { -1 }) } else { 1.0 }, by]
}

/// Whether a larger load makes the contact wider: its sides are farther apart at its ends than in its middle.
fn widens(truth: &Truth, contact: usize) -> bool {
    let measures = &truth.run.contacts[contact].measures;
    let [middle, half] = [1.0, -1.0].map(|sign| 0.5 * (measures.edge() + sign * measures.begin()));
    let gap = |at: f64| truth.case.scene.contacts[contact].gap(middle + at * half);
    (gap(-NEAR_END).max(gap(NEAR_END)) - gap(0.0)) > ALIKE * ALIKE * half
}

/// What is said where twice the scene's, or half of it, presses over the scene's width: of the load only where it does
/// not change the width.
fn of_amount(truth: &Truth, handed: &Handed, of_load: [&'static str; 2]) -> [&'static str; 2] {
    match (widens(truth, handed.contact), handed.forces) {
        (false, _) => of_load,
        (true, false) => [
            "pressures are half of the scene's over the scene's width: they were halved",
            "pressures are twice the scene's over the scene's width: those of two halves, or of two sides, were added",
        ],
        (true, true) => [
            "forces are half of the scene's over the scene's width: they are of one half",
            "forces are twice the scene's over the scene's width: those of two halves, or of two sides, were added",
        ],
    }
}

/// What turns the answer of a scene with so many times the load, radius and E* of ours into that of ours.
fn of_hertz(is_circle: bool, [load, radius, modulus]: [f64; 3]) -> [f64; 2] {
    let [pressure, width] = match is_circle {
        true => [load * (modulus / radius).powi(2), load * radius / modulus].map(f64::cbrt),
        false => [load * modulus / radius, load * radius / modulus].map(f64::sqrt),
    };
    [pressure.recip(), width.recip()]
}

/// Those of bodies of revolution: of a load so many times the scene's `a` and `p₀` are `∛` of it, of a contact of given
/// radius p alone.
fn of_revolution(truth: &Truth, handed: &Handed) -> Vec<(&'static str, [f64; 2])> {
    let scene = &truth.case.scene;
    let half = "the load is half of the scene's: that is of the whole body of revolution";
    let twice = "the load is twice the scene's: that is of the whole body of revolution";
    let [of_half, of_twice] = of_amount(truth, handed, [half, twice]);
    let whole =
        "the load is 1/2π of the scene's: it is given per radian, and the scene's is that of the whole circumference";
    let per_radian = "the load is 2π times the scene's: the whole force is given per radian";
    let sector = "the load is 1/180 of the scene's: that of a sector of 2° for the whole one";
    // What is said of a contact of given radius; nodal forces per radian, or of a sector, are named as such.
    let of_pressures = |says: &'static str| (!handed.forces).then_some(says);
    let loads = [
        (per_radian, TAU, Some(per_radian)),
        (whole, TAU.recip(), of_pressures(whole)),
        (half, 0.5, of_pressures(of_half)),
        (twice, 2.0, Some(of_twice)),
        (sector, 1.0 / 180.0, of_pressures(sector)),
    ];
    let plane = Scene { plane: PlaneHypothesis::Stress, ..scene.clone() };
    let pair = &scene.contacts[handed.contact];
    let of_plane = plane.modulus_of(pair) / scene.modulus_of(pair);
    let hertz = |(says, times): (&'static str, [f64; 3])| (says, of_hertz(true, times));
    let of_load = |(says, times, of_given_radius): (&'static str, f64, Option<&'static str>)| {
        let of_given_radius = of_given_radius.map(|says| (says, [times.recip(), 1.0]));
        std::iter::once(hertz((says, [times, 1.0, 1.0]))).chain(of_given_radius)
    };
    let others = [
        ("the radius is twice the scene's (a diameter for a radius)", [1.0, 2.0, 1.0]),
        ("the radius is half of the scene's (a radius for a diameter)", [1.0, 0.5, 1.0]),
        ("E* is half of the scene's (an elastic other side for a rigid one)", [1.0, 1.0, 0.5]),
        ("E* is twice the scene's (a rigid other side for an elastic one)", [1.0, 1.0, 2.0]),
    ];
    let plane = ("E for E/(1−ν²): the modulus of the contact is that of plane stress", [1.0, 1.0, of_plane]);
    others.map(hertz).into_iter().chain(loads.into_iter().flat_map(of_load)).chain([hertz(plane)]).collect()
}

/// Those of strips.
fn of_strips(truth: &Truth, handed: &Handed) -> Vec<(&'static str, [f64; 2])> {
    let scene = &truth.case.scene;
    let pair = &scene.contacts[handed.contact];
    let [half, twice] = match scene.bodies.iter().any(|body| !body.loads.is_empty()) {
        true => [
            "the load is half of the scene's: that is of the whole contact, not of one half",
            "the load is twice the scene's: the load of the whole acts on one half",
        ],
        false => [
            "the interference is half of the scene's (of a radius for a diameter)",
            "the interference is twice the scene's (of a diameter for a radius)",
        ],
    };
    let [of_half, of_twice] = of_amount(truth, handed, [half, twice]);
    let wider = "the radius is twice the scene's (a diameter for a radius), or E* half of it (an elastic other side \
        for a rigid one)";
    let narrower = "the radius is half of the scene's (a radius for a diameter), or E* twice as large (a rigid other \
        side for an elastic one)";
    let sphere =
        "p₀ = 3F/2πa² is that of a sphere, whose a = ∛(3FR/4E*): of a cylinder p₀ = 2F/πat and a = √(4FR/πE*t)";
    let (other, plane) = match scene.plane {
        PlaneHypothesis::Stress => {
            (PlaneHypothesis::Strain, "plane strain was solved, but the scene is in plane stress: E/(1−ν²) for E")
        }
        _ => (PlaneHypothesis::Stress, "plane stress was solved, but the scene is in plane strain: E for E/(1−ν²)"),
    };
    let of_plane = Scene { plane: other, ..scene.clone() }.modulus_of(pair) / scene.modulus_of(pair);
    let hertz = |load: f64, radius: f64, modulus: f64| of_hertz(false, [load, radius, modulus]);
    let [with_width, alone] = of_spheres(truth, handed);
    vec![
        (half, hertz(0.5, 1.0, 1.0)),
        (of_half, [2.0, 1.0]),
        (twice, hertz(2.0, 1.0, 1.0)),
        (of_twice, [0.5, 1.0]),
        (wider, hertz(1.0, 2.0, 1.0)),
        (narrower, hertz(1.0, 0.5, 1.0)),
        (sphere, with_width),
        (sphere, alone),
        (plane, hertz(1.0, 1.0, of_plane)),
        (plane, [of_plane.recip(), 1.0]),
    ]
}

/// Units that are called others: positions, pressures or forces, or both. Forces do not change with the unit of
/// positions.
fn units(pair: &ContactPair, handed: &Handed, units: &Units, is_circle: bool) -> Vec<(String, [f64; 2])> {
    let role = if handed.forces { Role::Force } else { Role::Pressure };
    let [places, values] = [(Role::Position, pair.path.is_straight()), (role, true)].map(|(role, are_lengths)| {
        let own = units.of(role).map_or_else(Vec::new, |own| others(role, own, are_lengths));
        [vec![(String::new(), 1.0, true)], own].concat()
    });
    let mut all = Vec::new();
    for (place, by, is_plain) in &places {
        for (value, times, may_both) in &values {
            let both = [&**place, value].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>();
            if both.len() == 1 || both.len() == 2 && *is_plain && *may_both {
                let [alone, _] = places_alone(handed, is_circle, *by);
                all.push((format!("units: {}", both.join(", ")), [times * alone, *by]));
            }
        }
    }
    all
}

/// What numbers of a role in a unit may be, each with its factor: in another unit, then in that unit, and converted to
/// it from another once more; and whether they are in another. Lengths or angles, the first of a size.
fn others(role: Role, own: &str, are_lengths: bool) -> Vec<(String, f64, bool)> {
    let Some(ours) = role.factor(own) else { return vec![] };
    let what = if are_lengths { format!("{}s", role.name()) } else { "angles".into() };
    let name = |unit: &str| if unit == "in" { "inch".to_owned() } else { unit.to_owned() };
    let units = || role.units().iter().filter(|(unit, _)| is_angle(unit) != are_lengths);
    let called = units()
        .map(|(unit, factor)| (format!("{what} in {} are called {}", name(unit), name(own)), factor / ours, true));
    let converted = units().map(|(unit, factor)| {
        (format!("{what} in {} were taken for {}, and converted", name(own), name(unit)), ours / factor, false)
    });
    let mut all: Vec<(String, f64, bool)> = Vec::new();
    for one in called.chain(converted) {
        let is_new = |known: f64| (one.1 / known - 1.0).abs() > ALIKE;
        if is_new(1.0) && all.iter().all(|(_, known, _)| is_new(*known)) {
            all.push(one);
        }
    }
    all
}

/// Pressures over the peak, and places over the half-width.
fn normalised(truth: &Truth, handed: &Handed) -> Vec<(String, [f64; 2])> {
    let contact = handed.contact;
    let [peak, width] =
        [Quantity::PeakPressure, Quantity::HalfWidth].map(|one| truth.known(contact, &one).reference.value);
    let places = places_alone(handed, truth.case.scene.is_around_axis(contact), width);
    let mut all = vec![("positions are over the half-width", places)];
    if !handed.forces {
        all.insert(0, ("pressures are over their peak", [peak, 1.0]));
        all.push(("pressures are over their peak, and positions over the half-width", [peak, width]));
    }
    let says = |text: &str| format!("{text}: hand them in with their units");
    all.into_iter().filter(|(_, by)| by.iter().all(|x| x.is_normal())).map(|(text, by)| (says(text), by)).collect()
}

/// What turns a sphere's peak into that of a cylinder, with its half-width and without: since `a² = 4PR/πE*`, the
/// sphere has `a₃³ = 3πta²/16`, and its peak is `3ta/4a₃²` times that of the cylinder.
fn of_spheres(truth: &Truth, handed: &Handed) -> [[f64; 2]; 2] {
    let known = truth.known(handed.contact, &Quantity::SecondMomentWidth);
    let (a, thickness) = (known.reference.value, truth.case.scene.thickness);
    let of_sphere = (3.0 * PI * thickness * a * a / 16.0).cbrt();
    let peak = |own: f64| 4.0 * own * own / (3.0 * thickness * a);
    [[peak(of_sphere), a / of_sphere], [peak(a), 1.0]]
}

/// Pressures times one factor, positions times another, areas times a third; forces follow.
fn scaled(handed: &Handed, pressure: f64, place: f64, area: f64) -> Handed {
    let value = if handed.forces { pressure * area } else { pressure };
    let point = |point: &Point| Point {
        position: place * point.position,
        value: value * point.value,
        area: point.area.map(|own| area * own),
        gap: point.gap,
    };
    let edge = |edge: &EdgeState| EdgeState {
        ends: edge.ends.map(|end| place * end),
        weight: area * edge.weight,
        pressure: pressure * edge.pressure,
        axis: edge.axis,
    };
    Handed {
        points: handed.points.iter().map(point).collect(),
        edges: handed.edges.iter().map(edge).collect(),
        ..handed.clone()
    }
}

/// The values moved by one point, the end filled up; and all positions moved so that the centre of pressure lies in the
/// middle.
fn shifts(scene: &Scene, handed: &Handed) -> Vec<Correction> {
    let values: Vec<f64> = handed.points.iter().map(|point| point.value).collect();
    let last = values.len() - 1;
    let with_values = |values: Vec<f64>| {
        with(handed, handed.points.iter().zip(values).map(|(point, value)| Point { value, ..*point }))
    };
    let outwards = [&values[1..], &[0.0][..]].concat();
    let inwards = [&values[..1], &values[..last]].concat();
    // Forces are what they are; pressures count by the area that belongs to them.
    let areas = match handed.forces {
        true => vec![1.0; values.len()],
        false => tributary(scene, &scene.contacts[handed.contact], &handed.points, handed.order),
    };
    let forces: Vec<f64> = values.iter().zip(&areas).map(|(value, area)| value * area).collect();
    let moment: f64 = forces.iter().zip(&handed.points).map(|(force, point)| force * point.position).sum();
    let centre = moment / forces.iter().sum::<f64>();
    let offset = format!("all positions are off by about {}", places(&scene.contacts[handed.contact], &[centre]));
    let by_one = "pressures are shifted by one node";
    vec![
        (format!("{by_one}: each belongs to the node before"), with_values(outwards)),
        (format!("{by_one}: each belongs to the node behind"), with_values(inwards)),
        (offset, moved(handed, |point| Point { position: point.position - centre, ..*point })),
    ]
}

/// Pressures of a half over those of the other, from which on it is there.
const MISSING: f64 = 0.1;

/// The half that is there, and its mirror image for the other.
fn halves(handed: &Handed) -> Vec<Correction> {
    let beyond = |sign: f64| handed.points.iter().copied().filter(move |point| sign * point.position > 0.0);
    let carried = |sign: f64| beyond(sign).map(|point| point.value.abs()).sum::<f64>();
    let half = |sign: f64| {
        let own = handed.points.iter().copied().filter(|point| sign * point.position >= 0.0);
        with(handed, own.chain(beyond(sign).map(|point| Point { position: 0.0 - point.position, ..point })))
    };
    let lacks = |sign: f64| carried(sign) <= MISSING * carried(0.0 - sign);
    let both = [("left", -1.0), ("right", 1.0)].into_iter().filter(|(_, sign)| lacks(*sign));
    both.map(|(name, sign)| (format!("the {name} half of the profile is missing"), half(0.0 - sign))).collect()
}

/// Without gaps, and of a great many pressures at points alone by so many only that mistakes are told by: corners and
/// mid-sides by turns still.
fn thinned(handed: &Handed) -> Handed {
    let [last, step] = [handed.points.len() - 1, (handed.points.len() / ENOUGH) | 1];
    let may_be = handed.order == Order::Linear && !handed.forces && handed.edges.is_empty();
    let step = if may_be && handed.points.iter().all(|point| point.area.is_none()) { step } else { 1 };
    let kept = handed.points.iter().enumerate().filter(|(k, _)| k % step == 0 || *k == last);
    Handed { points: kept.map(|(_, point)| Point { gap: None, ..*point }).collect(), ..handed.clone() }
}

/// Whether it is a profile still.
fn sound(handed: &Handed) -> bool {
    let apart = handed.points.windows(2).all(|two| two[1].position > two[0].position);
    apart && handed.points.len() > 2 && (handed.points.len() - 1).is_multiple_of(handed.order.number().into())
}
