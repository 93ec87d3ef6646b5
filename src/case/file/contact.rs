//! The contacts from their tables.

use crate::case::file::side::Side;
use crate::case::file::tables::{BodyTable, ContactTable, Keyed, Name, Pair};
use crate::case::file::units::Units;
use crate::case::file::{Source, compared, gap};
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Body, Circle, ContactPair, DrawnGap, Ends, Line, Path, Profile};

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
    tables: &[Keyed<BodyTable>],
    bodies: &[Body],
    contacts: &[ContactTable],
) -> Result<Vec<ContactPair>, Error> {
    let mut pairs: Vec<ContactPair> = Vec::new();
    for table in contacts {
        refuse_blank(source, table)?;
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
            return Err(source.refused(name.span(), message, "leave it out, or name it in a contact"));
        }
    }
    Ok(pairs)
}

/// Refuses a name that no line of a table could show.
fn refuse_blank(source: Source, table: &ContactTable) -> Result<(), Error> {
    let blank = |name: &&Name| name.get_ref().trim().is_empty() || name.get_ref().contains(char::is_control);
    match table.name.as_ref().filter(blank) {
        Some(name) => {
            Err(source.refused(name.span(), "the contact's `name` is blank, or not one line", "give it words"))
        }
        None => Ok(()),
    }
}

/// One contact, its path and its gap.
fn pair(
    source: Source,
    units: &Units,
    tables: &[Keyed<BodyTable>],
    bodies: &[Body],
    table: &ContactTable,
) -> Result<ContactPair, Error> {
    let (first, second) = touching(source, tables, table)?;
    let across = table.has_both_sides();
    refuse_mirrored(source, table)?;
    let (path, stretch) = way(source, units, table)?;
    let other = second.zip(table.second.as_ref()).map(|(body, name)| (body, name, &table.second_side));
    let named: Vec<_> = [(first, &table.first, &table.first_side)].into_iter().chain(other).collect();
    let side =
        |&(body, name, boundary): &(usize, _, _)| named_side(source, &bodies[body], (name, boundary), &path, stretch);
    let sides = named.iter().map(side).collect::<Result<Vec<Side>, Error>>()?;
    let above = sides[0].outward.unwrap_or(true);
    let drawn = DrawnGap { sides: sides.iter().map(|side| side.curves.clone()).collect(), path, above };
    let profile = gap::profile(source, units, &table.gap, across, &drawn)?;
    gap::refuse_strange(source, &path, &profile, &table.gap)?;
    for (k, (side, (_, name, _))) in sides.iter().zip(&named).enumerate() {
        side.refuse_misfit(source, units, name, (&path, &profile), k == 0)?;
        side.refuse_short(source, units, name, &path, (stretch, &table.stretch))?;
    }
    refuse_one_way(source, table, &sides)?;
    gap::refuse_ended(source, &profile, stretch, &table.gap)?;
    refuse_other_side_of_hole(source, table, &profile, above)?;
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
        ends: Ends::default(),
    };
    refuse_overlap(source, units, table, &pair, &sides)?;
    compared::refuse_other(source, units, table, &pair, &drawn)?;
    Ok(pair)
}

/// Refuses a gap that is measured on the pin where the first body has the hole, and the other way round.
fn refuse_other_side_of_hole(
    source: Source,
    table: &ContactTable,
    profile: &Profile,
    above: bool,
) -> Result<(), Error> {
    let [message, remedy] = match profile {
        Profile::Hole { .. } if !above => [
            "is the hole, and a gap `hole` is measured on the pin",
            "name the pin as `first`, or measure the gap on the hole, as `gap = { pin = … }`",
        ],
        Profile::Pin { .. } if above => [
            "is the pin, and a gap `pin` is measured on the hole",
            "name the body with the hole as `first`, or measure the gap on the pin, as `gap = { hole = … }`",
        ],
        _ => return Ok(()),
    };
    Err(source.refused(table.first.span(), format!("`{}` {message}", table.first.get_ref()), remedy))
}

/// Indices of the secondary body, and of the primary one where it is elastic.
fn touching(
    source: Source,
    tables: &[Keyed<BodyTable>],
    table: &ContactTable,
) -> Result<(usize, Option<usize>), Error> {
    let known: Vec<_> = tables.iter().enumerate().map(|(k, body)| (body.name.get_ref().as_str(), k)).collect();
    let first = source.choice("body", &table.first, &known)?;
    let second = table.second.as_ref().map(|name| source.choice("body", name, &known)).transpose()?;
    if let Some(name) = table.second.as_ref().filter(|_| second == Some(first)) {
        let message = format!("`{}` would touch itself", name.get_ref());
        return Err(source.refused(name.span(), message, "name another body, or leave `second` out for a rigid one"));
    }
    if let (None, Some(side)) = (second, &table.second_side) {
        let remedy = "leave it out, or name the primary body as `second`";
        return Err(source.refused(side.span(), "`second-side` without `second`", remedy));
    }
    Ok((first, second))
}

/// The path, and how far the candidates lie along it.
fn way(source: Source, units: &Units, table: &ContactTable) -> Result<(Path, f64), Error> {
    let path = match &table.arc {
        None => Path::Straight(Line { origin: origin(source, units, table)?, both_sides: table.has_both_sides() }),
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
    Ok((path, stretch))
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
    Ok(source.pair("origin", given)?.map(|x| units.length * x))
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
    // Off the symmetry line of a half scene a contact has both its sides, and an image.
    let at_0 = |origin: &Pair| origin.get_ref().first().is_none_or(|x| *x.get_ref() == 0.0);
    let on_line = table.origin.as_ref().is_none_or(at_0);
    match table.symmetric.as_ref().filter(|symmetric| on_line && *symmetric.get_ref()) {
        Some(symmetric) => {
            let message = "the contact lies on both sides of x = 0 and is not half of a symmetric one";
            Err(source.refused(symmetric.span(), message, "leave `symmetric` or `both-sides` out"))
        }
        None => Ok(()),
    }
}

/// Refuses two sides that look the same way.
fn refuse_one_way(source: Source, table: &ContactTable, sides: &[Side]) -> Result<(), Error> {
    let down = |k: usize| sides.get(k).and_then(|side| side.outward);
    match (down(0), down(1), &table.second) {
        (Some(first), Some(second), Some(name)) if first == second => {
            let way = if first { "down, or outwards" } else { "up, or inwards" };
            let message =
                format!("the contact sides of `{}` and `{}` both look {way}", table.first.get_ref(), name.get_ref());
            Err(source.refused(name.span(), message, "let one look down (or outwards) and the other up (or inwards)"))
        }
        _ => Ok(()),
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
    if !matches!(pair.profile, Profile::Drawn | Profile::Bodies(_)) {
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
