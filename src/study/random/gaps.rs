//! Gaps of any kind, drawn until they make a contact of the half-plane.

use std::sync::Arc;

use crate::oracle::boundary::HalfPlane;
use crate::scene::{Material, MonotoneCubic, PlaneHypothesis, Profile};
use crate::study::random::blocks;
use crate::study::random::family::{Draw, Sample};

/// How far a profile through points goes, over the expected end of the contact.
const REACH: f64 = 3.2;
/// Part of it within which the contact must lie.
const WITHIN: f64 = 0.9;
/// Points of a profile on each side.
const POINTS: usize = 64;
/// Points on a wave.
const ON_WAVE: f64 = 16.0;
/// Elements on the tip of a wedge: on fewer, no coarser mesh sees it.
const ON_TIP: f64 = 4.0;
/// Points on half of a contact at which a drawn polynomial is looked at.
const LOOKED_AT: usize = 200;
/// Largest even power, halved.
const HIGHEST: f64 = 15.0;
/// Powers of the distance.
const POWERS: [f64; 2] = [1.5, 30.0];

/// A gap and how it is pressed.
pub struct Gap {
    /// The gap.
    profile: Profile,
    /// Half of the contact, about \[mm\].
    half_width: f64,
    /// Load over E* \[mm\]; none where it is that of a contact as long on both sides.
    load: Option<f64>,
    /// Whether both sides of s = 0 are shown.
    whole: bool,
}

/// `g = c₂ s² + c₄ s⁴ + c₆ s⁶` by the parts of its slope at the half-width.
pub fn even_gap([a, slope]: [f64; 2], parts: [f64; 3]) -> Profile {
    let coefficients = [0, 1, 2].map(|k| slope * parts[k] / (2.0 * (k + 1) as f64 * a.powi(2 * k as i32 + 1)));
    Profile::Even { coefficients: coefficients.into() }
}

/// Half-widths and slopes, over which all gaps are drawn.
pub fn size(draw: &mut Draw) -> [f64; 2] {
    [draw.decades(0.01, 100.0), draw.decades(1e-4, 1e-2)]
}

impl Gap {
    /// A gap whose length is given, shown on one side or both.
    fn of(profile: Profile, half_width: f64, whole: bool) -> Self {
        Self { profile, half_width, load: None, whole }
    }

    /// The contact that it makes; none where it makes none that is known.
    fn pressed(&self, modulus: f64) -> Option<HalfPlane> {
        let a = self.half_width;
        let as_long = || HalfPlane { modulus, profile: self.profile.clone(), stretches: vec![[-a, a]] }.load();
        let load = self.load.map_or_else(as_long, |load| modulus * load);
        let within = WITHIN * REACH * a;
        (load > 0.0).then(|| HalfPlane::of_load(modulus, self.profile.clone(), load, [-within, within])).flatten()
    }
}

/// A block, or two, under gaps drawn until one makes a contact.
pub fn pressed(draw: &mut Draw, materials: &[Material], guess: f64, drawn: impl Fn(&mut Draw) -> Gap) -> Sample {
    let compliance: f64 = materials.iter().map(|m| 1.0 / m.plane_modulus(PlaneHypothesis::Strain)).sum();
    loop {
        let gap = drawn(draw);
        let size = [draw.between(4.0, 14.0), draw.between(4.0, 14.0)];
        if let Some(contact) = gap.pressed(1.0 / compliance) {
            return blocks::sample(contact, materials, gap.whole, size, guess);
        }
    }
}

/// A cubic with the values and slopes of a function without units, `g = slope · a · f(s/a)`, `[f, f']` at some places.
///
/// With slopes of neighbouring points its curvature would leap at each of them by enough to ripple the pressure by 1 %.
fn smooth([a, slope]: [f64; 2], places: impl Iterator<Item = f64>, of: impl Fn(f64) -> [f64; 2]) -> Profile {
    let (points, slopes) = places.map(|u| ([a * u, slope * a * of(u)[0]], slope * of(u)[1])).unzip();
    Profile::Smooth(Arc::new(MonotoneCubic { points, slopes }))
}

/// So many places on one side, or on both.
fn places(number: usize, whole: bool) -> impl Iterator<Item = f64> {
    let first = if whole { -(number as i32) } else { 0 };
    (first..=number as i32).map(move |k| REACH * f64::from(k) / number as f64)
}

/// `|s|^n`, even powers exactly, every second time with a parabola; other ones through points.
pub fn power(draw: &mut Draw, even: bool) -> Gap {
    let [a, slope] = size(draw);
    if even {
        let half = draw.decades(1.0, HIGHEST + 0.5).round() as usize;
        let mut coefficients = vec![0.0; half];
        coefficients[0] = slope * draw.between(-0.2, 0.2).max(0.0) / a;
        coefficients[half - 1] += slope / (2.0 * half as f64 * a.powi(2 * half as i32 - 1));
        return Gap::of(Profile::Even { coefficients: coefficients.into() }, a, false);
    }
    let power = draw.decades(POWERS[0], POWERS[1]);
    Gap::of(
        smooth([a, slope / power], places(POINTS, false), |u| [u.powf(power), power * u.powf(power - 1.0)]),
        a,
        false,
    )
}

/// A flat bottom with shoulders of a radius.
pub fn flat(draw: &mut Draw) -> Gap {
    let [a, slope] = size(draw);
    let width = draw.between(0.2, 0.97);
    let beyond = (0..).map(|k| width + (1.0 - width) * 0.5 * f64::powi(2.0, k)).take_while(|u| *u < REACH);
    let places = [0.0, 0.5 * width, width].into_iter().chain(beyond).chain([REACH]);
    let shoulder = |u: f64| {
        let beyond = (u - width).max(0.0);
        [0.5 * beyond * beyond, beyond].map(|part| part / (1.0 - width))
    };
    Gap::of(smooth([a, slope], places, shoulder), a, false)
}

/// Different powers on both sides.
pub fn skew(draw: &mut Draw) -> Gap {
    let [a, slope] = size(draw);
    let [right, left] = [0, 1].map(|_| draw.decades(1.5, 6.0));
    let steepness = draw.decades(0.2, 5.0);
    let of = |u: f64| match u > 0.0 {
        true => [u.powf(right) / right, u.powf(right - 1.0)],
        false => [u.abs().powf(left) / left, -u.abs().powf(left - 1.0)].map(|part| steepness * part),
    };
    Gap::of(smooth([a, slope], places(POINTS, true), of), a, true)
}

/// Two humps `(s² − c²)²/8c²`, whose curvature on top is that of `s²/2`; alike and one of them shown, or of different
/// heights.
pub fn humps(draw: &mut Draw, whole: bool) -> Gap {
    let [a, slope] = size(draw);
    let top = draw.between(0.5, 1.0) * a;
    let curvature = slope / a;
    // Half-width of each, as Hertz has it.
    let half_width = top * draw.decades(0.12, 0.6);
    let load = Some(0.5 * std::f64::consts::PI * half_width * half_width * curvature);
    if !whole {
        let coefficients = [-0.25 * curvature, 0.125 * curvature / (top * top)];
        return Gap { profile: Profile::Even { coefficients: coefficients.into() }, half_width: a, load, whole };
    }
    let higher = draw.between(-0.4, 0.4) * half_width * half_width / (top * a);
    let of = |u: f64| {
        let over = (u * a / top).powi(2) - 1.0;
        [over * over * 0.125 * (top / a).powi(2) + higher * u, 0.5 * over * u + higher]
    };
    Gap { profile: smooth([a, slope], places(POINTS, true), of), half_width: a, load, whole }
}

/// Waves on a parabola.
pub fn ripples(draw: &mut Draw) -> Gap {
    let [a, slope] = size(draw);
    let wave = 2.0 * std::f64::consts::PI / draw.between(0.5, 1.6);
    let amplitude = draw.decades(0.3, 5.0) / (wave * wave);
    let phase = if draw.between(0.0, 2.0) < 1.0 { 1.0 } else { -1.0 };
    let of = |u: f64| {
        let (sin, cos) = (wave * u).sin_cos();
        [0.5 * u * u + phase * amplitude * (1.0 - cos), u + phase * amplitude * wave * sin]
    };
    let number = (REACH * wave * ON_WAVE / (2.0 * std::f64::consts::PI)).ceil() as usize;
    Gap::of(smooth([a, slope], places(number, false), of), a, false)
}

/// A polygon; its pressure has no limit at the corners.
pub fn kinks(draw: &mut Draw, whole: bool) -> Gap {
    let [a, slope] = size(draw);
    let corners = draw.between(1.0, 4.0) as usize;
    let mut side = |sign: f64| {
        let mut points = vec![[0.0, 0.0]];
        let (mut place, mut gap, mut steepness) = (0.0, 0.0, slope * draw.between(-0.3, 0.3).max(0.0));
        for _ in 0..corners {
            let length = a * draw.between(0.2, 0.8);
            (place, gap) = (place + length, gap + steepness * length);
            points.push([sign * place, gap]);
            steepness += slope * draw.between(0.2, 1.0);
        }
        let rest = (REACH * a - place).max(0.2 * a);
        points.push([sign * (place + rest), gap + steepness * rest]);
        points
    };
    let right = side(1.0);
    if !whole {
        return Gap::of(Profile::Table(right.into()), a, whole);
    }
    let mut points: Vec<[f64; 2]> = side(-1.0).into_iter().skip(1).rev().collect();
    points.extend(right);
    Gap::of(Profile::Table(points.into()), a, whole)
}

/// Two blocks, between which the gap is of any of these kinds.
pub fn blocks(draw: &mut Draw, upper: Material, guess: f64, number: usize) -> Sample {
    let lower = Material { young: upper.young * draw.decades(0.1, 10.0), poisson: draw.between(0.0, 0.45) };
    pressed(draw, &[upper, lower], guess, |draw| match number % 4 {
        0 => power(draw, true),
        1 => flat(draw),
        2 => skew(draw),
        _ => humps(draw, number % 8 == 7),
    })
}

/// `g = c₂ s² + c₄ s⁴ + c₆ s⁶`, drawn until it is pressed all over the contact, and open all over the block beyond it.
pub fn polynomial(draw: &mut Draw, material: Material, guess: f64, off_centre: bool) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let ([a, slope], size) = (size(draw), draw.between(4.0, 14.0));
    loop {
        let parts = [draw.between(0.0, 1.0), draw.between(-0.5, 1.0), draw.between(-0.5, 1.0)];
        let contact = HalfPlane { modulus, profile: even_gap([a, slope], parts), stretches: vec![[-a, a]] };
        // b₁ of the slope, whose load is πaE*b₁/4.
        let mean = parts[0] + 0.75 * parts[1] + 0.625 * parts[2];
        let place = |k: usize| (std::f64::consts::FRAC_PI_2 * (k as f64 + 0.5) / LOOKED_AT as f64).cos();
        let least = |x: f64| 0.05 * modulus * slope * mean * (1.0 - x * x).sqrt();
        let beyond = |k: usize| a * (1.0 + (size - 1.0) * (k as f64 + 1.0) / LOOKED_AT as f64);
        if mean > 0.1
            && (0..LOOKED_AT).all(|k| contact.opening(beyond(k)) > 0.0)
            && (0..LOOKED_AT).all(|k| contact.pressure(a * place(k)) > least(place(k)))
            && off_centre == (contact.peak()[0] > 1.01 * contact.pressure(0.0))
        {
            return blocks::sample(contact, &[material], false, [size, size], guess);
        }
    }
}

/// `g' = s/R` up to a tenth to eight tenths of the contact, and constant beyond.
pub fn wedge(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let ([a, slope], size) = (size(draw), draw.between(4.0, 14.0));
    let round = draw.between(0.1, 0.8);
    let gap = |u: f64| if u < round { [0.5 * u * u / round, u / round] } else { [u - 0.5 * round, 1.0] };
    let profile = smooth([a, slope], [0.0, round, size].into_iter(), gap);
    let contact = HalfPlane { modulus, profile, stretches: vec![[-a, a]] };
    blocks::sample(contact, &[material], false, [size, size], guess).seen_by(ON_TIP / round)
}
