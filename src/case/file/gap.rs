//! `gap` of a contact, as a function of the contact coordinate s; against the gap between the bodies as they are drawn.

use std::sync::Arc;

use toml::de::DeValue;

use crate::case::file::form::Form::{Flag, List, Number, Own, Table, Text};
use crate::case::file::form::{Form, PAIR, may, must, unexpected, unknown};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::{ContactPair, DrawnGap, MonotoneCubic, Path, Profile, ROUNDING};

/// `"drawn"`, as the meshes of the bodies are drawn, or one of [`KEYS`].
pub(super) const GAP: Form = Own(&[Text, KEYS], |value| match value.get_ref() {
    DeValue::String(word) if word == DRAWN => Ok(()),
    DeValue::String(word) => Err((value.span(), unknown("variant", word, [DRAWN].into_iter()))),
    DeValue::Table(table) => {
        KEYS.check(value)?;
        let count = table.keys().filter(|key| ![SMOOTH, CLEARANCE].contains(&key.get_ref().as_ref())).count();
        let wrong = |message: &str| Err((value.span(), message.into()));
        match count {
            _ if table.contains_key(SMOOTH) && !table.contains_key("table") => {
                wrong("`smooth` goes with a `table` only")
            }
            1 if table.contains_key(CLEARANCE) && OF_ITSELF.iter().any(|key| table.contains_key(*key)) => wrong(
                "`clearance` goes beside a profile that begins with none, as in { circle = 50, clearance = 0.02 }",
            ),
            0 => wrong("the gap has no key, and needs one, as in { circle = 50 }"),
            1 => Ok(()),
            _ => wrong("the gap has two keys, and takes one, as in { circle = 50 }"),
        }
    }
    _ => Err(unexpected(value, "\"drawn\" or a table, as in { circle = 50 }")),
});

const DRAWN: &str = "drawn";
const SMOOTH: &str = "smooth";
const CLEARANCE: &str = "clearance";
/// Keys of gaps that tell their clearance themselves.
const OF_ITSELF: [&str; 4] = ["from", "uniform", "hole", "pin"];

/// The keys of a gap: one of them, `smooth` beside `table`, and `clearance` beside a profile.
const KEYS: Form = Table(&[
    // "bodies": as their shapes are drawn.
    may("from", Text),
    // The same everywhere; negative is interference.
    may("uniform", Number),
    // Half-width of a flat punch, nothing beyond.
    may("punch", Number),
    // Radius of a circle on a plane.
    may("circle", Number),
    // Circles of both sides: radius of the first and of the second, negative where it is hollow.
    may("circles", PAIR),
    // R of s²/2R.
    may("parabola", Number),
    // Coefficients of s², s⁴, s⁶, and so on.
    may("even", List(&Number)),
    // Coefficients and powers [c, n] of Σ c |s|ⁿ.
    may("powers", POWERS),
    // A slope.
    may("wedge", Number),
    // Points [s, g]: straight between them, or a monotone cubic through them where it is `smooth`.
    may("table", List(&PAIR)),
    may(SMOOTH, Flag),
    // Added everywhere.
    may(CLEARANCE, Number),
    // Δ (1 − cos 2πs/λ) of amplitude Δ, half the height, and wavelength λ.
    may("cosine", Table(&[must("amplitude", Number), must("wavelength", Number)])),
    // Pin in a hole, measured on the pin; `pin` is the same measured on the hole. The radius is the pin's.
    may("hole", Table(&[must("radius", Number), must("clearance", Number)])),
    may("pin", Table(&[must("radius", Number), must("clearance", Number)])),
]);

/// Refuses gaps that are functions of a length on an arc, and of an angle on a line.
pub(super) fn refuse_strange(path: &Path, profile: &Profile, gap: Value) -> Result<(), Error> {
    let remedy = match (path, profile) {
        (_, Profile::Drawn | Profile::Bodies(_)) | (Path::Arc(_), Profile::Uniform(_)) => return Ok(()),
        (Path::Arc(arc), Profile::Hole { radius, .. }) if (radius / arc.radius - 1.0).abs() <= 1e-9 => return Ok(()),
        (Path::Arc(_), Profile::Hole { .. }) => "give the hole's `radius` as that of `arc`: it is the pin's",
        (Path::Arc(arc), Profile::Pin { radius, clearance })
            if ((radius + clearance) / arc.radius - 1.0).abs() <= 1e-9 =>
        {
            return Ok(());
        }
        (Path::Arc(_), Profile::Pin { .. }) => "give `arc` the radius of the hole, that of the pin and the clearance",
        (Path::Arc(_), _) => "on an arc the gap is `uniform`, `drawn`, from the bodies, a `hole` or a `pin`",
        (Path::Straight { .. }, Profile::Hole { .. }) => "a hole needs the pin's circle as `arc`",
        (Path::Straight { .. }, Profile::Pin { .. }) => "a pin needs the hole's circle as `arc`",
        (Path::Straight { .. }, _) => return Ok(()),
    };
    Err(gap.refused("this gap cannot be used on the path of the contact", remedy))
}

/// The gap in mm as a function of the contact coordinate, on one side of s = 0 or across it, or the drawn one.
pub(super) fn profile(gap: Value, across: bool, drawn: &DrawnGap) -> Result<Profile, Error> {
    if gap.word().is_some() {
        return Ok(Profile::Drawn);
    }
    if let Some(points) = gap.get("table") {
        let points = points_of(gap, points, across)?;
        let is_smooth = gap.asked(SMOOTH).is_some();
        return Ok(if is_smooth {
            Profile::Smooth(Arc::new(MonotoneCubic::through(&points)))
        } else {
            Profile::Table(points)
        });
    }
    let (name, value) = gap.only_but(CLEARANCE);
    Ok(match name {
        "from" => {
            value.choice("source of a gap", &[("bodies", ())])?;
            Profile::Bodies(Arc::new(drawn.clone()))
        }
        "uniform" => Profile::Uniform(gap.units.length * value.finite()?),
        "punch" => Profile::Punch { half_width: value.length()? },
        "circle" => Profile::Circle { radius: value.length()? },
        "circles" => circles(value)?,
        "parabola" => Profile::Parabola { radius: value.length()? },
        "even" => even(gap, value)?,
        "powers" => Profile::Powers { terms: powers(value)?.into() },
        "wedge" => Profile::Wedge { slope: value.positive()? },
        "cosine" => {
            Profile::Cosine { amplitude: value.at("amplitude").length()?, wavelength: value.at("wavelength").length()? }
        }
        "hole" => Profile::Hole { radius: value.at("radius").length()?, clearance: value.at("clearance").length()? },
        "pin" => {
            let radius = value.at("radius").positive()?;
            let expected = format!("a number above 0 and below the radius, {radius}");
            let clearance = value.at("clearance").within(&expected, |c| c > 0.0 && c < radius)?;
            let [radius, clearance] = [radius, clearance].map(|length| gap.units.length * length);
            Profile::Pin { radius, clearance }
        }
        _ => value.unknown(),
    })
}

/// Clearance beside a profile \[mm\].
pub(super) fn clearance(gap: Value) -> Result<f64, Error> {
    let Some(given) = gap.get(CLEARANCE) else { return Ok(0.0) };
    if given.number() >= 0.0 && given.number().is_finite() {
        return Ok(given.units.length * given.number());
    }
    let message = format!("`clearance` is {}, and a gap begins with 0 or more", given.number());
    Err(given.refused(message, "give a length; bodies are pressed into one another by a support with a `value`"))
}

/// Circles of both sides, which touch at s = 0 and part from there.
fn circles(pair: Value) -> Result<Profile, Error> {
    for given in pair.exactly::<2>()? {
        given.above_zero(given.number().abs())?;
    }
    let [first, second] = pair.pair()?;
    let curvature = 1.0 / first + 1.0 / second;
    let message = format!("circles of the radii {first} and {second} overlap beside s = 0");
    let remedy = "give a hollow side, whose radius is negative, the larger radius, and the other side a positive one";
    pair.refuse_if(curvature < 0.0, message, remedy)?;
    let message = format!("circles of the radii {first} and {second} lie on one another");
    pair.refuse_if(curvature <= 0.0, message, "give `gap = { uniform = 0 }`")?;
    Ok(Profile::Circles { radii: [first, second].map(|radius| pair.units.length * radius) })
}

/// Most points of a table.
const MOST_POINTS: usize = 10_000;

/// Points of a table: ascending from s = 0 on, or across it from below 0.
fn points_of(gap: Value, table: Value, across: bool) -> Result<Arc<[[f64; 2]]>, Error> {
    let list = table.entries();
    let message = format!("the table has {} points", list.len());
    gap.refuse_if(!(2..=MOST_POINTS).contains(&list.len()), message, format!("give 2 to {MOST_POINTS} points [s, g]"))?;
    let points = list.iter().map(|pair| pair.point()).collect::<Result<Vec<[f64; 2]>, Error>>()?;
    let begins = |s: f64| if across { s <= 0.0 } else { s == 0.0 };
    let wrong = |k: usize| if k == 0 { !begins(points[0][0]) } else { points[k][0] <= points[k - 1][0] };
    if let Some(k) = (0..points.len()).find(|k| wrong(*k)) {
        let remedy = match across {
            true => "sort its points by s, beginning at 0 for a gap that is even, else below 0",
            false => "sort its points by s, beginning at 0",
        };
        return Err(list[k].refused("the table does not ascend from s = 0", remedy));
    }
    Ok(points.into())
}

/// Coefficients of an even polynomial at most; a shape that needs more is a table.
const MOST_COEFFICIENTS: usize = 16;

/// Even polynomial; the coefficient of s^n has the unit of length^(1−n).
fn even(gap: Value, list: Value) -> Result<Profile, Error> {
    let list = list.entries();
    let message = format!("`even` has {} coefficients", list.len());
    let remedy = format!("give one to {MOST_COEFFICIENTS}: of s², s⁴, s⁶, and so on");
    gap.refuse_if(!(1..=MOST_COEFFICIENTS).contains(&list.len()), message, remedy)?;
    let read = list.iter().zip(0..).map(|(given, k)| Ok(given.finite()? / gap.units.length.powi(1 + 2 * k)));
    Ok(Profile::Even { coefficients: read.collect::<Result<_, Error>>()? })
}

/// Terms `[c, n]` of `Σ c |s|ⁿ`, as gaps and closed forms have them.
pub(super) const POWERS: Form = List(&PAIR);

/// Largest power: a steeper gap is as good as a flat punch.
const STEEPEST: f64 = 100.0;

/// Such terms in mm; c has the unit of length^(1−n).
pub(super) fn powers(list: Value) -> Result<Vec<[f64; 2]>, Error> {
    let terms = list.entries();
    let message = format!("the gap has {} terms", terms.len());
    let remedy = format!("give one to {MOST_COEFFICIENTS} pairs [c, n]");
    list.refuse_if(!(1..=MOST_COEFFICIENTS).contains(&terms.len()), message, remedy)?;
    let read = terms.into_iter().map(|term| {
        let [c, n] = term.exactly::<2>()?;
        let expected = format!("a power above 1 and up to {STEEPEST}; a slope at s = 0 is a `wedge`, or a `cone`");
        let n = n.within(&expected, |n| n > 1.0 && n <= STEEPEST)?;
        Ok([c.finite()? * list.units.length.powf(1.0 - n), n])
    });
    read.collect()
}

/// Refuses a gap that tells nothing of the last candidates.
pub(super) fn refuse_ended(profile: &Profile, stretch: f64, gap: Value) -> Result<(), Error> {
    let points: &[[f64; 2]] = match profile {
        Profile::Table(points) => points,
        Profile::Smooth(cubic) => &cubic.points,
        _ => &[],
    };
    if let [[from, _], .., [to, _]] = *points
        && (to < stretch || from < 0.0 && from > -stretch)
    {
        return Err(gap.refused("the table ends before the candidates do", "shorten `stretch`"));
    }
    if profile.reach().is_some_and(|reach| stretch > reach * (1.0 + ROUNDING)) {
        let what = match profile {
            Profile::Circle { .. } => "circle",
            Profile::Circles { .. } => "smaller circle",
            _ => "punch",
        };
        let remedy = "shorten `stretch` to there: nothing can touch beyond it";
        return Err(gap.refused(format!("the {what} ends before the candidates do"), remedy));
    }
    Ok(())
}

/// Difference, over the largest gap given on the stretch, up to which both are one.
const ALIKE: f64 = 0.02;
/// Gap, over the length of the stretch, up to which sides are drawn on one another: such a drawing tells no gap.
const FLAT: f64 = 1e-6;
/// Places along one side of s = 0 at which gaps are compared.
const PLACES: i32 = 64;

/// Refuses a gap that differs from the drawn one, unless the contact says that the drawing tells none.
pub(super) fn refuse_other_than_drawn(table: Value, pair: &ContactPair, drawn: &DrawnGap) -> Result<(), Error> {
    let length = table.units.length;
    let is_drawn = matches!(pair.profile, Profile::Drawn | Profile::Bodies(_));
    let given = table.asked("gap-only");
    let message = "`gap-only` is true, and the gap is that of the drawn bodies";
    Value::refuse(given.filter(|_| is_drawn), message, "leave it out, or give the gap as a function")?;
    if is_drawn || given.is_some() {
        return Ok(());
    }
    let first = if pair.path.has_both_sides() { -PLACES } else { 0 };
    let places = (first..=PLACES).map(|k| pair.stretch * f64::from(k) / f64::from(PLACES));
    // Bodies may be drawn with the clearance between them, or touching.
    let is_touching = (drawn.gap(0.0) - pair.profile.gap(0.0)).abs() <= ALIKE * pair.clearance;
    let clearance = if is_touching { 0.0 } else { pair.clearance };
    let gaps: Vec<[f64; 3]> = places.map(|s| [s, pair.profile.gap(s) + clearance, drawn.gap(s)]).collect();
    let told: Vec<&[f64; 3]> = gaps.iter().filter(|[_, given, drawn]| given.is_finite() && drawn.is_finite()).collect();
    let largest = |k: usize| told.iter().map(|gap| gap[k].abs()).fold(0.0, f64::max);
    let flat = FLAT * pair.stretch * pair.path.metric();
    let apart = |gap: &[f64; 3]| (gap[1] - gap[2]).abs();
    let Some([s, given, drawn]) = told.iter().max_by(|a, b| apart(a).total_cmp(&apart(b))) else { return Ok(()) };
    if largest(2) <= flat || (given - drawn).abs() <= ALIKE * (largest(1) - clearance).max(0.0) + flat {
        return Ok(());
    }
    let [given, drawn] = [given, drawn].map(|gap| rounded(gap / length));
    let place = if pair.path.is_straight() { rounded(s / length) } else { rounded(s.to_degrees()) };
    let (between, other) = match pair.second {
        Some(_) => ("between the drawn bodies", "where the drawing shall not tell it"),
        None => ("between the drawn body and a flat rigid side", "where the rigid side is not flat"),
    };
    let message = format!("at s = {place} the gap is {given} as given, and {drawn} {between}");
    let remedy = format!("correct it, give `gap = {{ from = \"bodies\" }}`, or add `gap-only = true` {other}");
    Err(table.at("gap").refused(message, remedy))
}

/// Five significant digits.
pub(super) fn rounded(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}
