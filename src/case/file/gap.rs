//! The gap of a contact from its table.

use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::gap_keys::GapTable;
use crate::case::file::tables::Pair;
use crate::case::file::units::Units;
use crate::error::Error;
use crate::scene::{DrawnGap, MonotoneCubic, Path, Profile, ROUNDING};

/// Refuses gaps that are functions of a length on an arc, and of an angle on a line.
pub(super) fn refuse_strange(
    source: Source,
    path: &Path,
    profile: &Profile,
    gap: &Spanned<GapTable>,
) -> Result<(), Error> {
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
        (Path::Straight(_), Profile::Hole { .. }) => "a hole needs the pin's circle as `arc`",
        (Path::Straight(_), Profile::Pin { .. }) => "a pin needs the hole's circle as `arc`",
        (Path::Straight(_), _) => return Ok(()),
    };
    Err(source.refused(gap.span(), "this gap cannot be used on the path of the contact", remedy))
}

/// The gap in mm as a function of the contact coordinate, on one side of s = 0 or across it, or the drawn one.
pub(super) fn profile(
    source: Source,
    units: &Units,
    table: &Spanned<GapTable>,
    across: bool,
    drawn: &DrawnGap,
) -> Result<Profile, Error> {
    let length = |key: &str, value: &Spanned<f64>| Ok::<f64, Error>(units.length * source.positive(key, value)?);
    Ok(match table.get_ref() {
        GapTable::Drawn => Profile::Drawn,
        GapTable::From(name) => {
            source.choice("source of a gap", name, &[("bodies", ())])?;
            Profile::Bodies(Arc::new(drawn.clone()))
        }
        GapTable::Uniform(gap) => Profile::Uniform(units.length * source.finite("uniform", gap)?),
        GapTable::Punch(half_width) => Profile::Punch { half_width: length("punch", half_width)? },
        GapTable::Circle(radius) => Profile::Circle { radius: length("circle", radius)? },
        GapTable::Circles(pair) => circles(source, units, pair)?,
        GapTable::Parabola(radius) => Profile::Parabola { radius: length("parabola", radius)? },
        GapTable::Even(list) => even(source, units, table.span(), list)?,
        GapTable::Table { points, smooth } => {
            let points = points_of(source, units, table.span(), points, across)?;
            if *smooth { Profile::Smooth(Arc::new(MonotoneCubic::through(&points))) } else { Profile::Table(points) }
        }
        GapTable::Wedge(slope) => Profile::Wedge { slope: source.positive("wedge", slope)? },
        GapTable::Cosine(cosine) => Profile::Cosine {
            amplitude: length("amplitude", &cosine.amplitude)?,
            wavelength: length("wavelength", &cosine.wavelength)?,
        },
        GapTable::Hole(hole) => {
            Profile::Hole { radius: length("radius", &hole.radius)?, clearance: length("clearance", &hole.clearance)? }
        }
        GapTable::Pin(pin) => {
            let radius = source.positive("radius", &pin.radius)?;
            let expected = format!("a number above 0 and below the radius, {radius}");
            let clearance = source.number("clearance", &pin.clearance, &expected, |c| c > 0.0 && c < radius)?;
            Profile::Pin { radius: units.length * radius, clearance: units.length * clearance }
        }
    })
}

/// Circles of both sides, which touch at s = 0 and part from there.
fn circles(source: Source, units: &Units, pair: &Pair) -> Result<Profile, Error> {
    for given in source.entries::<_, 2>("circles", pair)? {
        source.positive("circles", &Spanned::new(given.span(), given.get_ref().abs()))?;
    }
    let [first, second] = source.pair("circles", pair)?;
    let curvature = 1.0 / first + 1.0 / second;
    if curvature < 0.0 {
        let message = format!("circles of the radii {first} and {second} overlap beside s = 0");
        let remedy =
            "give a hollow side, whose radius is negative, the larger radius, and the other side a positive one";
        return Err(source.refused(pair.span(), message, remedy));
    }
    if curvature <= 0.0 {
        let message = format!("circles of the radii {first} and {second} lie on one another");
        return Err(source.refused(pair.span(), message, "give `gap = { uniform = 0 }`"));
    }
    Ok(Profile::Circles { radii: [first, second].map(|radius| units.length * radius) })
}

/// Most points of a table.
const MOST_POINTS: usize = 10_000;

/// Points of a table: ascending from s = 0 on, or across it from below 0.
fn points_of(
    source: Source,
    units: &Units,
    place: Range<usize>,
    list: &[Pair],
    across: bool,
) -> Result<Arc<[[f64; 2]]>, Error> {
    if !(2..=MOST_POINTS).contains(&list.len()) {
        let message = format!("the table has {} points", list.len());
        return Err(source.refused(place, message, format!("give 2 to {MOST_POINTS} points [s, g]")));
    }
    let points = list.iter().map(|pair| Ok(source.pair("table", pair)?.map(|x| units.length * x)));
    let points = points.collect::<Result<Vec<[f64; 2]>, Error>>()?;
    let begins = |s: f64| if across { s <= 0.0 } else { s == 0.0 };
    let wrong = |k: usize| if k == 0 { !begins(points[0][0]) } else { points[k][0] <= points[k - 1][0] };
    if let Some(k) = (0..points.len()).find(|k| wrong(*k)) {
        let remedy = match across {
            true => "sort its points by s, beginning at 0 for a gap that is even, else below 0",
            false => "sort its points by s, beginning at 0",
        };
        return Err(source.refused(list[k].span(), "the table does not ascend from s = 0", remedy));
    }
    Ok(points.into())
}

/// Coefficients of an even polynomial at most; a shape that needs more is a table.
const MOST_COEFFICIENTS: usize = 16;

/// Even polynomial; the coefficient of s^n has the unit of length^(1−n).
fn even(source: Source, units: &Units, place: Range<usize>, list: &[Spanned<f64>]) -> Result<Profile, Error> {
    if !(1..=MOST_COEFFICIENTS).contains(&list.len()) {
        let message = format!("`even` has {} coefficients", list.len());
        return Err(source.refused(
            place,
            message,
            format!("give one to {MOST_COEFFICIENTS}: of s², s⁴, s⁶, and so on"),
        ));
    }
    let read = list.iter().zip(0..).map(|(given, k)| Ok(source.finite("even", given)? / units.length.powi(1 + 2 * k)));
    Ok(Profile::Even { coefficients: read.collect::<Result<_, Error>>()? })
}

/// Refuses a gap that tells nothing of the last candidates.
pub(super) fn refuse_ended(
    source: Source,
    profile: &Profile,
    stretch: f64,
    gap: &Spanned<GapTable>,
) -> Result<(), Error> {
    let points: &[[f64; 2]] = match profile {
        Profile::Table(points) => points,
        Profile::Smooth(cubic) => &cubic.points,
        _ => &[],
    };
    if let [[from, _], .., [to, _]] = *points
        && (to < stretch || from < 0.0 && from > -stretch)
    {
        return Err(source.refused(gap.span(), "the table ends before the candidates do", "shorten `stretch`"));
    }
    if profile.reach().is_some_and(|reach| stretch > reach * (1.0 + ROUNDING)) {
        let what = match profile {
            Profile::Circle { .. } => "circle",
            Profile::Circles { .. } => "smaller circle",
            _ => "punch",
        };
        let remedy = "shorten `stretch` to there: nothing can touch beyond it";
        return Err(source.refused(gap.span(), format!("the {what} ends before the candidates do"), remedy));
    }
    Ok(())
}
