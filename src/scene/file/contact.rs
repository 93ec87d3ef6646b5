//! The contact pair from its table.

use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;

use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::file::Source;
use crate::scene::file::side::Side;
use crate::scene::file::tables::{BodyTable, ContactTable, GapTable, Name, Pair, ReferenceTable};
use crate::scene::file::units::Units;
use crate::scene::{Body, Circle, ContactPair, Line, Path, Profile, ReferenceValues, Scene};

/// Largest stretch on an arc \[°\].
const QUARTER: f64 = 90.0;

/// Whether a body lies on both sides of the line s = 0: the contact that it is meshed for has both.
pub fn is_across(contacts: &[ContactTable], body: &BodyTable) -> bool {
    let name = body.name.get_ref();
    let is_side = |side: &Option<Name>| side.as_ref().is_none_or(|side| side.get_ref() == CONTACT);
    let own = |table: &&ContactTable| {
        table.first.get_ref() == name && is_side(&table.first_side)
            || table.second.as_ref().is_some_and(|second| second.get_ref() == name) && is_side(&table.second_side)
    };
    let any = |table: &&ContactTable| {
        table.first.get_ref() == name || table.second.as_ref().is_some_and(|second| second.get_ref() == name)
    };
    contacts.iter().find(own).or_else(|| contacts.iter().find(any)).is_some_and(ContactTable::has_both_sides)
}

/// The contacts; every body takes part in one of them, and no two have one name.
pub fn pairs(
    source: Source,
    units: &Units,
    tables: &[BodyTable],
    bodies: &[Body],
    contacts: &[ContactTable],
) -> Result<Vec<ContactPair>, Error> {
    let mut pairs: Vec<ContactPair> = Vec::new();
    for table in contacts {
        let pair = pair(source, units, tables, bodies, table)?;
        if pairs.iter().any(|other| other.name == pair.name) {
            let place = table.name.as_ref().unwrap_or(&table.first).span();
            let message = format!("a second contact is called `{}`", pair.name);
            return Err(source.refused(place, message, "give every contact a `name` of its own"));
        }
        pairs.push(pair);
    }
    for (index, table) in tables.iter().enumerate() {
        if !pairs.iter().flat_map(ContactPair::bodies).any(|body| body == index) {
            let name = &table.name;
            let message = format!("body `{}` takes no part in the contact", name.get_ref());
            return Err(source.refused(name.span(), message, "leave it out, or name it in `contact`"));
        }
    }
    Ok(pairs)
}

/// One contact, its path and its gap.
fn pair(
    source: Source,
    units: &Units,
    tables: &[BodyTable],
    bodies: &[Body],
    table: &ContactTable,
) -> Result<ContactPair, Error> {
    let known: Vec<_> = tables.iter().enumerate().map(|(k, body)| (body.name.get_ref().as_str(), k)).collect();
    let first = source.choice("body", &table.first, &known)?;
    let second = table.second.as_ref().map(|name| source.choice("body", name, &known)).transpose()?;
    if let Some(name) = table.second.as_ref().filter(|_| second == Some(first)) {
        let message = format!("`{}` would touch itself", name.get_ref());
        return Err(source.refused(name.span(), message, "name another body, or leave `second` out for a rigid one"));
    }
    let across = table.has_both_sides();
    refuse_mirrored(source, table)?;
    let path = match &table.arc {
        None => Path::Straight(Line { origin: origin(source, units, table)?, both_sides: across }),
        Some(arc) => Path::Arc(Circle {
            centre: source.pair("centre", &arc.centre)?.map(|x| units.length * x),
            radius: units.length * source.positive("radius", &arc.radius)?,
        }),
    };
    let stretch = match path {
        Path::Straight(_) => units.length * source.positive("stretch", &table.stretch)?,
        Path::Arc(_) => {
            let expected = format!("an angle above 0 and up to {QUARTER}");
            source.number("stretch", &table.stretch, &expected, |x| x > 0.0 && x <= QUARTER)?.to_radians()
        }
    };
    let profile = profile(source, units, &table.gap, across)?;
    refuse_strange_gap(source, &path, &profile, &table.gap)?;
    let named =
        [(Some(first), Some(&table.first), &table.first_side), (second, table.second.as_ref(), &table.second_side)];
    if let (None, Some(side)) = (second, &table.second_side) {
        let remedy = "leave it out, or name the facing body as `second`";
        return Err(source.refused(side.span(), "`second-side` without `second`", remedy));
    }
    let mut sides = Vec::new();
    for (k, (body, name, boundary)) in named.into_iter().enumerate() {
        let (Some(body), Some(name)) = (body, name) else { continue };
        let side = named_side(source, &bodies[body], (name, boundary), &path, stretch)?;
        side.refuse_misfit(source, units, name, (&path, &profile), k == 0)?;
        side.refuse_short(source, units, name, &path, (stretch, &table.stretch))?;
        sides.push(side);
    }
    let above = looks_down(source, table, &sides)?;
    if let Profile::Table(points) = &profile
        && let [[from, _], .., [to, _]] = points[..]
        && (to < stretch || from < 0.0 && from > -stretch)
    {
        return Err(source.refused(table.gap.span(), "the table ends before the candidates do", "shorten `stretch`"));
    }
    if let Profile::Circle { radius } = profile
        && stretch >= radius
    {
        return Err(source.refused(table.gap.span(), "the circle ends before the candidates do", "shorten `stretch`"));
    }
    if let Profile::Punch { half_width } = profile
        && stretch > half_width * (1.0 + 1e-9)
    {
        let remedy = "shorten `stretch` to the end of the punch: nothing can touch beyond it";
        return Err(source.refused(table.gap.span(), "the punch ends before the candidates do", remedy));
    }
    if matches!(profile, Profile::Hole { .. }) && !above {
        let message = format!("`{}` is the hole, and a gap `hole` is measured on the pin", table.first.get_ref());
        return Err(source.refused(table.first.span(), message, "name the pin as `first`"));
    }
    let symmetric = table.symmetric.as_ref().map_or(!across, |given| *given.get_ref());
    let boundary = |given: &Option<Name>| given.as_ref().map_or(CONTACT.into(), |name| name.get_ref().clone().into());
    let pair = ContactPair {
        name: name_of(table),
        first,
        above,
        second,
        sides: [boundary(&table.first_side), boundary(&table.second_side)],
        path,
        profile,
        stretch,
        symmetric,
    };
    refuse_overlap(source, units, table, &pair, &sides)?;
    Ok(pair)
}

/// The side of a body that is named, `contact` where none is.
fn named_side(
    source: Source,
    body: &Body,
    (name, boundary): (&Name, &Option<Name>),
    path: &Path,
    stretch: f64,
) -> Result<Side, Error> {
    let wanted = boundary.as_ref().map_or(CONTACT, |side| side.get_ref());
    Side::of(&body.shape, wanted, path, stretch).ok_or_else(|| {
        let names = body.shape.boundaries().into_iter();
        let able = names.filter(|other| Side::of(&body.shape, other, path, stretch).is_some());
        let able: Vec<String> = able.map(|name| format!("`{name}`")).collect();
        let place = boundary.as_ref().unwrap_or(name).span();
        let message = format!("no contact can lie on a side `{wanted}` of `{}`", body.name);
        source.refused(place, message, format!("known: {}", able.join(", ")))
    })
}

/// The name given, or one made of the bodies.
fn name_of(table: &ContactTable) -> String {
    let second = table.second.as_ref().map_or("rigid", |second| second.get_ref());
    let made = || format!("{} on {second}", table.first.get_ref());
    table.name.as_ref().map_or_else(made, |name| name.get_ref().clone())
}

/// Where s = 0 lies on a straight path.
fn origin(source: Source, units: &Units, table: &ContactTable) -> Result<[f64; 2], Error> {
    let Some(given) = &table.origin else { return Ok([0.0, 0.0]) };
    Ok(source.pair("origin", given.get_ref())?.map(|x| units.length * x))
}

/// Refuses a contact on both sides that would be mirrored there, or runs along an arc.
fn refuse_mirrored(source: Source, table: &ContactTable) -> Result<(), Error> {
    if let (Some(origin), Some(_)) = (&table.origin, &table.arc) {
        let remedy = "leave `origin` out: s = 0 lies below the centre of `arc`";
        return Err(source.refused(origin.span(), "`origin` is for straight paths", remedy));
    }
    let Some(given) = table.both_sides.as_ref().filter(|given| *given.get_ref()) else { return Ok(()) };
    if table.arc.is_some() {
        let remedy = "leave `both-sides` out and model one half, or leave `arc` out and give the gap along y = 0";
        return Err(source.refused(given.span(), "`both-sides` is for contact along y = 0, not along an arc", remedy));
    }
    match table.symmetric.as_ref().filter(|symmetric| *symmetric.get_ref()) {
        Some(symmetric) => {
            let message = "the scene shows both sides of x = 0, and is not half of a symmetric one";
            Err(source.refused(symmetric.span(), message, "leave `symmetric` or `both-sides` out"))
        }
        None => Ok(()),
    }
}

/// Whether the first body is the upper or inner one; refuses two sides that look the same way.
fn looks_down(source: Source, table: &ContactTable, sides: &[Side]) -> Result<bool, Error> {
    let down = |k: usize| sides.get(k).and_then(|side| side.outward);
    match (down(0), down(1), &table.second) {
        (Some(first), Some(second), Some(name)) if first == second => {
            let way = if first { "down, or outwards" } else { "up, or inwards" };
            let message =
                format!("the contact sides of `{}` and `{}` both look {way}", table.first.get_ref(), name.get_ref());
            Err(source.refused(name.span(), message, "let one look down (or outwards) and the other up (or inwards)"))
        }
        (first, ..) => Ok(first.unwrap_or(true)),
    }
}

/// Refuses bodies that are drawn into one another, deeper than an interference goes.
fn refuse_overlap(
    source: Source,
    units: &Units,
    table: &ContactTable,
    pair: &ContactPair,
    sides: &[Side],
) -> Result<(), Error> {
    if !matches!(pair.profile, Profile::Drawn) {
        return Ok(());
    }
    let depth = |k: usize| sides.get(k).map_or(pair.path.own_depth(), |side| side.depth(&pair.path));
    let gap = pair.drawn(depth(0), depth(1));
    if gap < -DEEPEST * pair.stretch * pair.path.metric() {
        let message = format!("the bodies overlap by {} at s = 0", -gap / units.length);
        return Err(source.refused(table.gap.span(), message, "move them apart; a small interference may be drawn"));
    }
    Ok(())
}

/// Deepest interference that may be drawn, over the length of the stretch.
const DEEPEST: f64 = 0.1;

/// Refuses gaps that are functions of a length on an arc, and of an angle on a line.
fn refuse_strange_gap(source: Source, path: &Path, profile: &Profile, gap: &Spanned<GapTable>) -> Result<(), Error> {
    let remedy = match (path, profile) {
        (_, Profile::Drawn) | (Path::Arc(_), Profile::Uniform(_)) => return Ok(()),
        (Path::Arc(arc), Profile::Hole { radius, .. }) if (radius / arc.radius - 1.0).abs() <= 1e-9 => return Ok(()),
        (Path::Arc(_), Profile::Hole { .. }) => "give the hole's `radius` as that of `arc`: it is the pin's",
        (Path::Arc(_), _) => "on an arc the gap is `uniform`, `drawn` or a `hole`",
        (Path::Straight(_), Profile::Hole { .. }) => "a hole needs the pin's circle as `arc`",
        (Path::Straight(_), _) => return Ok(()),
    };
    Err(source.refused(gap.span(), "this gap does not go with the path of the contact", remedy))
}

fn profile(source: Source, units: &Units, table: &Spanned<GapTable>, across: bool) -> Result<Profile, Error> {
    let length = |key: &str, value: &Spanned<f64>| Ok::<f64, Error>(units.length * source.positive(key, value)?);
    Ok(match table.get_ref() {
        GapTable::Drawn => Profile::Drawn,
        GapTable::Uniform(gap) => Profile::Uniform(units.length * source.finite("uniform", gap)?),
        GapTable::Punch(half_width) => Profile::Punch { half_width: length("punch", half_width)? },
        GapTable::Circle(radius) => Profile::Circle { radius: length("circle", radius)? },
        GapTable::Parabola(radius) => Profile::Parabola { radius: length("parabola", radius)? },
        GapTable::Even(list) => even(source, units, table.span(), list)?,
        GapTable::Table(points) => Profile::Table(points_of(source, units, table.span(), points, across)?),
        GapTable::Wedge(slope) => Profile::Wedge { slope: source.positive("wedge", slope)? },
        GapTable::Cosine(cosine) => Profile::Cosine {
            amplitude: length("amplitude", &cosine.amplitude)?,
            wavelength: length("wavelength", &cosine.wavelength)?,
        },
        GapTable::Hole(hole) => {
            Profile::Hole { radius: length("radius", &hole.radius)?, clearance: length("clearance", &hole.clearance)? }
        }
    })
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
        let place = list[k][0].span().start..list[k][1].span().end;
        let remedy = match across {
            true => "sort its points by s, beginning at 0 for a gap that is even, else below 0",
            false => "sort its points by s, beginning at 0",
        };
        return Err(source.refused(place, "the table does not ascend from s = 0", remedy));
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

/// Reference values, those not given by the scene itself: ℓ half the candidate stretch, `g_ref = |g(ℓ)|` and
/// `p_ref = E* g_ref/ℓ`, which on Hertz scenes is p₀ for a = ℓ.
///
/// Where the gap vanishes at ℓ nothing tells a pressure, and one must be given.
pub fn reference(
    source: Source,
    units: &Units,
    scene: &Scene,
    table: Option<&ReferenceTable>,
    gap: &Spanned<GapTable>,
) -> Result<ReferenceValues, Error> {
    let none = ReferenceTable::default();
    let table = table.unwrap_or(&none);
    let given = |key: &str, value: &Option<Spanned<f64>>, unit: f64| {
        value.as_ref().map(|value| Ok::<f64, Error>(unit * source.positive(key, value)?)).transpose()
    };
    let (pair, modulus) = (scene.contact(), scene.contact_modulus());
    let half = 0.5 * pair.stretch;
    let length = given("length", &table.length, units.length)?.unwrap_or(half * pair.path.metric());
    let pressure = given("pressure", &table.pressure, units.stress)?;
    let widest = (0..=8).map(|k| pair.profile.gap(0.125 * f64::from(k) * pair.stretch).abs()).fold(0.0, f64::max);
    let ends: &[f64] = if pair.path.has_both_sides() { &[half, -half] } else { &[half] };
    // Waves may return to zero there, but for round-off.
    let own = Some(ends.iter().map(|s| pair.profile.gap(*s).abs()).fold(0.0, f64::max))
        .filter(|own| own.is_finite() && *own > 1e-6 * widest);
    let opening = given("gap", &table.gap, units.length)?.or_else(|| pressure.map(|p| p * length / modulus)).or(own);
    let Some(opening) = opening else {
        let remedy = "give the pressure to expect: [reference] pressure = …";
        return Err(source.refused(gap.span(), "the gap vanishes and tells no reference pressure", remedy));
    };
    Ok(ReferenceValues { length, pressure: pressure.unwrap_or(modulus * opening / length), gap: opening })
}
