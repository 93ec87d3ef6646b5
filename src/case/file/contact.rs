//! `[contact]`, or one of several `[[contact]]`.

use toml::de::DeValue;

use crate::case::file::form::Form::{Flag, List, Number, Own, Table, Text};
use crate::case::file::form::{Form, PAIR, listed, may, must, unexpected};
use crate::case::file::gap::GAP;
use crate::case::file::oracle::ORACLE;
use crate::case::file::side::Side;
use crate::case::file::value::Value;
use crate::case::file::{gap, mesh_file, named};
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Body, BoundaryName, Circle, ContactPair, DrawnGap, Ends, Path, PlaneHypothesis, Profile, Shape};

/// One table, or several.
pub(super) const CONTACTS: Form = Own(&[ONE, List(&ONE)], |value| match value.get_ref() {
    DeValue::Table(_) => ONE.check(value),
    DeValue::Array(several) => several.iter().try_for_each(|one| ONE.check(one)),
    _ => Err(unexpected(value, "a table [contact], or several [[contact]]")),
});

const ONE: Form = Table(&[
    may("name", Text).told("in messages, results and checks: of its bodies where it is left out"),
    must("first", Text).told("the body on which positions and areas are measured"),
    may("first-side", Text).told("its boundary that touches: `contact` by default"),
    may("second", Text).told("the primary body; a rigid one where it is left out"),
    may("second-side", Text).told("the boundary of that one"),
    must("gap", GAP).told("initial gap along the contact coordinate s"),
    may("gap-only", Flag).told("the gap holds even where the bodies are drawn with another"),
    may("arc", Table(&[must("centre", PAIR), must("radius", Number)]))
        .told("the path is an arc: contact coordinates are angles from the downward vertical [degrees]"),
    may("origin", PAIR).told("where s = 0 lies on a straight path; [0, 0] by default"),
    must("stretch", Number).told("candidates lie from s = 0 to here: a length, or degrees on an arc"),
    may("both-sides", Flag).told("the contact lies on both sides of s = 0"),
    may("symmetric", Flag).told("the scene is half of a symmetric one; true by default where the contact has one side"),
    may("oracle", ORACLE).told("the closed form that checks without a value are held against"),
]);

/// Largest stretch on an arc \[°\].
const QUARTER: f64 = 90.0;
/// Deepest interference that may be drawn, over the length of the stretch.
const DEEPEST: f64 = 0.1;

/// The tables of the contacts: the one given, which has a gap, or those of a list.
pub(super) fn tables(given: Value) -> Vec<Value> {
    if given.get("gap").is_some() { vec![given] } else { given.entries() }
}

/// Whether a body lies on both sides of the line s = 0: the contact that it is meshed for has both.
pub(super) fn is_across<'a>(contacts: &[Value<'a>], body: &str) -> bool {
    let sides = |contact: &Value<'a>| {
        let takes_part = |key: &str| contact.get(key).is_some_and(|name| name.text() == body);
        let side = |key| contact.get(key).map_or(CONTACT, Value::text);
        [takes_part("first").then(|| side("first-side")), takes_part("second").then(|| side("second-side"))]
    };
    let own = contacts.iter().find(|contact| sides(contact).contains(&Some(CONTACT)));
    let any = || contacts.iter().find(|contact| sides(contact).iter().any(Option::is_some));
    own.or_else(any).is_some_and(|contact| contact.asked("both-sides").is_some())
}

/// The contacts; every body takes part in one of them, and no two have one name.
pub(super) fn pairs(
    plane: PlaneHypothesis,
    tables: &[Value],
    bodies: &[Body],
    contacts: &[Value],
) -> Result<Vec<ContactPair>, Error> {
    let mut pairs: Vec<ContactPair> = Vec::new();
    for &table in contacts {
        refuse_blank(table)?;
        let pair = pair(plane, bodies, table)?;
        let is_second = pairs.iter().any(|other| other.name == pair.name);
        let message = format!("a second contact is called `{}`", pair.name);
        let place = table.get("name").unwrap_or(table.at("first"));
        place.refuse_if(is_second, message, "give every contact a `name` of its own")?;
        pairs.push(pair);
    }
    for (index, table) in tables.iter().enumerate() {
        let name = table.at("name");
        let takes_part = pairs.iter().flat_map(ContactPair::bodies).any(|body| body == index);
        let message = format!("body `{}` takes no part in the contact", name.text());
        name.refuse_if(!takes_part, message, "leave it out, or name it in a contact")?;
    }
    Ok(pairs)
}

/// Refuses a name that no line of a table could show.
fn refuse_blank(table: Value) -> Result<(), Error> {
    let is_blank = |name: &Value| name.text().trim().is_empty() || name.text().contains(char::is_control);
    let blank = table.get("name").filter(is_blank);
    Value::refuse(blank, "the contact's `name` is blank, or not one line", "give it words")
}

/// One contact, its path and its gap.
fn pair(plane: PlaneHypothesis, bodies: &[Body], table: Value) -> Result<ContactPair, Error> {
    let (first, second) = touching(bodies, table)?;
    let across = table.asked("both-sides").is_some();
    let given = table.at("gap");
    refuse_mirrored(table)?;
    let (path, stretch) = way(table)?;
    let other = second.map(|body| (body, table.at("second"), table.get("second-side")));
    let named: Vec<_> = [(first, table.at("first"), table.get("first-side"))].into_iter().chain(other).collect();
    let side = |&(body, name, boundary): &(usize, _, _)| named_side(&bodies[body], (name, boundary), &path, stretch);
    let (names, sides): (Vec<BoundaryName>, Vec<Side>) =
        named.iter().map(side).collect::<Result<Vec<_>, Error>>()?.into_iter().unzip();
    let above = sides[0].outward.unwrap_or(true);
    let drawn = DrawnGap { sides: sides.iter().map(|side| side.curves.clone()).collect(), path, above };
    let profile = gap::profile(given, across, &drawn)?;
    let clearance = gap::clearance(given)?;
    gap::refuse_strange(&path, &profile, given)?;
    for (k, (side, (_, name, _))) in sides.iter().zip(&named).enumerate() {
        side.refuse_misfit(*name, (&path, &profile, clearance), (k == 0, plane))?;
        side.refuse_short(*name, &path, (stretch, table.at("stretch")))?;
    }
    refuse_one_way(table, &sides)?;
    gap::refuse_ended(&profile, stretch, given)?;
    refuse_other_side_of_hole(table.at("first"), &profile, above)?;
    let pair = ContactPair {
        name: name_of(table),
        first,
        above,
        second,
        sides: [0, 1].map(|k| names.get(k).cloned().unwrap_or(CONTACT.into())),
        path,
        profile,
        clearance,
        stretch,
        symmetric: table.get("symmetric").map_or(!across, Value::read),
        ends: Ends::default(),
    };
    refuse_overlap(given, &pair, &sides)?;
    gap::refuse_other_than_drawn(table, &pair, &drawn)?;
    Ok(pair)
}

/// Refuses a gap that is measured on the pin where the first body has the hole, and the other way round.
fn refuse_other_side_of_hole(first: Value, profile: &Profile, above: bool) -> Result<(), Error> {
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
    Err(first.refused(format!("`{}` {message}", first.text()), remedy))
}

/// Indices of the secondary body, and of the primary one where it is elastic.
fn touching(bodies: &[Body], table: Value) -> Result<(usize, Option<usize>), Error> {
    let first = named::body(table.at("first"), bodies)?;
    let second = table.get("second").map(|name| named::body(name, bodies)).transpose()?;
    if let Some(name) = table.get("second").filter(|_| second == Some(first)) {
        let message = format!("`{}` would touch itself", name.text());
        return Err(name.refused(message, "name another body, or leave `second` out for a rigid one"));
    }
    let side = table.get("second-side").filter(|_| second.is_none());
    Value::refuse(side, "`second-side` without `second`", "leave it out, or name the primary body as `second`")?;
    Ok((first, second))
}

/// The path, and how far the candidates lie along it.
pub(super) fn way(table: Value) -> Result<(Path, f64), Error> {
    let stretch = table.at("stretch");
    let Some(arc) = table.get("arc") else {
        let origin = table.get("origin").map_or(Ok([0.0; 2]), Value::point)?;
        let path = Path::Straight { origin, both_sides: table.asked("both-sides").is_some() };
        return Ok((path, stretch.length()?));
    };
    let path = Path::Arc(Circle { centre: arc.at("centre").point()?, radius: arc.at("radius").length()? });
    let expected = format!("an angle above 0 and up to {QUARTER}");
    Ok((path, stretch.within(&expected, |x| x > 0.0 && x <= QUARTER)?.to_radians()))
}

/// The side of a body that is named, `contact` where none is, and its name.
fn named_side(
    body: &Body,
    (name, boundary): (Value, Option<Value>),
    path: &Path,
    stretch: f64,
) -> Result<(BoundaryName, Side), Error> {
    let wanted = match (&body.shape, boundary) {
        (Shape::Given(mesh), Some(boundary)) => mesh_file::boundary(mesh, boundary)?,
        _ => None,
    };
    let wanted = wanted.unwrap_or_else(|| boundary.map_or(CONTACT, Value::text).to_owned().into());
    let side = Side::of(&body.shape, &wanted, path, stretch).ok_or_else(|| {
        let names = body.shape.boundaries().into_iter();
        let able: Vec<_> = names.filter(|other| Side::of(&body.shape, other, path, stretch).is_some()).collect();
        let message = format!("no contact can lie on a side `{wanted}` of `{}`", body.name);
        boundary.unwrap_or(name).refused(message, format!("known: {}", listed(able.iter().map(AsRef::as_ref))))
    })?;
    Ok((wanted, side))
}

/// The name given, or one made of the bodies.
fn name_of(table: Value) -> String {
    let second = table.get("second").map_or("rigid", Value::text);
    let made = || format!("{} on {second}", table.at("first").text());
    table.get("name").map_or_else(made, |name| name.text().into())
}

/// Refuses a contact on both sides that would be mirrored there, or runs along an arc.
fn refuse_mirrored(table: Value) -> Result<(), Error> {
    let is_arc = table.get("arc").is_some();
    let remedy = "leave `origin` out: s = 0 lies below the centre of `arc`";
    Value::refuse(table.get("origin").filter(|_| is_arc), "`origin` is for straight paths", remedy)?;
    let Some(given) = table.asked("both-sides") else { return Ok(()) };
    let remedy = "leave `both-sides` out and model one half, or leave `arc` out and give the gap along y = 0";
    given.refuse_if(is_arc, "`both-sides` is for contact along y = 0, not along an arc", remedy)?;
    // Off the symmetry line of a half scene a contact has both its sides, and an image.
    let at_0 = |origin: Value| origin.entries().first().is_none_or(|x| x.number() == 0.0);
    let on_line = table.get("origin").is_none_or(at_0);
    let message = "the contact lies on both sides of x = 0 and is not half of a symmetric one";
    let symmetric = table.asked("symmetric").filter(|_| on_line);
    Value::refuse(symmetric, message, "leave `symmetric` or `both-sides` out")
}

/// Refuses two sides that look the same way.
fn refuse_one_way(table: Value, sides: &[Side]) -> Result<(), Error> {
    let down = |k: usize| sides.get(k).and_then(|side| side.outward);
    match (down(0), down(1), table.get("second")) {
        (Some(first), Some(second), Some(name)) if first == second => {
            let way = if first { "down, or outwards" } else { "up, or inwards" };
            let bodies = [table.at("first"), name].map(|name| format!("`{}`", name.text()));
            let message = format!("the contact sides of {} both look {way}", bodies.join(" and "));
            Err(name.refused(message, "let one look down (or outwards) and the other up (or inwards)"))
        }
        _ => Ok(()),
    }
}

/// Refuses bodies that are drawn into one another, deeper than an interference goes.
fn refuse_overlap(gap: Value, pair: &ContactPair, sides: &[Side]) -> Result<(), Error> {
    if !matches!(pair.profile, Profile::Drawn | Profile::Bodies(_)) {
        return Ok(());
    }
    let depth = |k: usize| sides.get(k).map_or(pair.path.own_depth(), |side| side.depth(&pair.path));
    let drawn = pair.drawn(depth(0), depth(1));
    let is_deep = drawn < -DEEPEST * pair.stretch * pair.path.metric();
    let message = format!("the bodies overlap by {} at s = 0", -drawn / gap.units.length);
    gap.refuse_if(is_deep, message, "move them apart; a small interference may be drawn")
}
