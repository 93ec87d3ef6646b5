//! What a closed form takes for granted of bodies, materials and gap: a scene that has something else is refused.
//!
//! What shows only when the scene is solved, as the force on the contact, is told beside the run
//! ([`Case::beside_closed_forms`](crate::case::Case::beside_closed_forms)).

use std::sync::Arc;

use crate::case::file::gap::{powers, rounded};
use crate::case::file::oracle::rings;
use crate::case::file::side::Side;
use crate::case::file::units::Units;
use crate::case::file::value::Value;
use crate::error::Error;
use crate::oracle::{Quantity, Reading, SharedOracle};
use crate::scene::{Circle, Component, ContactPair, DrawnGap, Load, Path, Profile, Scene, Shape};

/// Difference, over the larger number, up to which two are one: a circle is as good as its parabola.
const ALIKE: f64 = 0.01;
/// The same of gaps between points: chords of a circle lie inside it.
const SAMPLED: f64 = 0.02;
/// Difference of Poisson's ratios up to which they are one.
const POISSON: f64 = 0.005;
/// Places along a contact at which gaps are compared.
const PLACES: u32 = 64;
/// Difference of curvatures at two distances, over one of them, that chords of a parabola may have.
const PARABOLIC: f64 = 0.2;
/// Halvings of the stretch on which a curvature is looked for.
const HALVINGS: i32 = 6;

/// A scene held against the hypotheses of the closed form of one of its contacts.
struct Bench<'a> {
    units: Units,
    given: Value<'a>,
    /// Its name, its numbers, and what it is.
    name: &'a str,
    numbers: Value<'a>,
    oracle: &'a SharedOracle,
    scene: &'a Scene,
    pair: &'a ContactPair,
    /// The gap where a formula or the drawing tells it.
    profile: Profile,
}

/// Refuses a scene that is not that of the closed form named.
pub(super) fn refuse_other_scene(
    given: Value,
    (scene, contact): (&Scene, usize),
    oracle: &SharedOracle,
) -> Result<(), Error> {
    let pair = &scene.contacts[contact];
    let profile = match &pair.profile {
        Profile::Drawn => drawn(scene, pair),
        told => told.clone(),
    };
    let (name, numbers) = given.only();
    let bench = Bench { units: given.units, given, name, numbers, oracle, scene, pair, profile };
    match name {
        "hertz" => bench.curved(),
        "persson" => bench.persson(),
        "lame" => bench.lame(),
        "flat-punch" => bench.punch(),
        "bars" => bench.bars(),
        "own-weight" => bench.weight(),
        "polynomial" => {
            let list = numbers.list("coefficients").into_iter().zip(0..);
            let coefficients = list.map(|(c, k)| c.number() * given.units.length.powi(-1 - 2 * k)).collect();
            bench.shaped(&Profile::Even { coefficients })
        }
        "powers" => bench.shaped(&Profile::Powers { terms: powers(numbers.at("terms"))?.into() }),
        "wedge" => bench.wedge(),
        "cone" => bench.shaped(&Profile::Wedge { slope: numbers.at("slope").number() }),
        "cosine" => {
            let [amplitude, wavelength] = ["amplitude", "wavelength"].map(|key| bench.length(key));
            bench.shaped(&Profile::Cosine { amplitude, wavelength })
        }
        // The force tells a uniform pressure: pressure times width.
        "uniform" => Ok(()),
        _ => numbers.unknown(),
    }
}

/// The gap between the sides as their meshes draw them.
fn drawn(scene: &Scene, pair: &ContactPair) -> Profile {
    let side = |body: usize| Side::of(&scene.bodies[body].shape, pair.side(body), &pair.path, pair.stretch);
    match pair.bodies().map(side).collect::<Option<Vec<Side>>>() {
        Some(sides) => {
            let sides = sides.into_iter().map(|side| side.curves).collect();
            Profile::Bodies(Arc::new(DrawnGap { sides, path: pair.path, above: pair.above }))
        }
        None => Profile::Drawn,
    }
}

impl Bench<'_> {
    /// A length of the closed form \[mm\].
    fn length(&self, key: &'static str) -> f64 {
        self.units.length * self.numbers.at(key).number()
    }

    /// Refuses a length of the closed form that the scene has otherwise \[mm\].
    fn same(&self, key: &'static str, has: f64, what: &str) -> Result<(), Error> {
        self.same_number((&format!("`{key}`"), self.numbers.at(key)), has, self.units.length, what)
    }

    /// The same of a number in a unit.
    fn same_number(&self, (key, value): (&str, Value), has: f64, unit: f64, what: &str) -> Result<(), Error> {
        let given = unit * value.number();
        let allowed = self.allowed() * given.abs().max(has.abs());
        if !has.is_finite() || (given - has).abs() <= allowed {
            return Ok(());
        }
        let shown = rounded(has / unit);
        let message = format!("{key} is {}, and {what} is {shown}", value.number());
        let remedy = "a closed form is compared only with the scene it is of: correct one of the two, or leave \
            `oracle` out and give checks a `value`";
        Err(value.refused(message, format!("give {shown}; {remedy}")))
    }

    /// What is wrong with the closed form as a whole.
    fn refused(&self, message: impl Into<String>) -> Error {
        let remedy = "correct the `oracle` or the scene, or leave `oracle` out and give checks a `value`";
        self.given.refused(message, remedy)
    }

    fn allowed(&self) -> f64 {
        match self.profile {
            Profile::Bodies(_) | Profile::Drawn | Profile::Table(_) | Profile::Smooth(_) => SAMPLED,
            _ => ALIKE,
        }
    }

    /// Where the gap is smallest, and how far it can be looked at to both sides of there; none where that is not in the
    /// middle.
    fn vertex(&self) -> Option<[f64; 2]> {
        let stretch = self.pair.stretch;
        if !self.pair.path.has_both_sides() {
            let lowest = self.places(stretch).map(|s| self.profile.gap(s)).fold(f64::INFINITY, f64::min);
            let at_0 = self.profile.gap(0.0);
            let size = (self.profile.gap(stretch) - at_0).abs();
            return (at_0 - lowest <= ALIKE * size).then_some([0.0, stretch]);
        }
        let all = (-i64::from(PLACES)..=i64::from(PLACES)).map(|k| stretch * k as f64 / f64::from(PLACES));
        let told = all.map(|s| [s, self.profile.gap(s)]).filter(|[_, gap]| gap.is_finite());
        let [s, _] = told.min_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].abs().total_cmp(&b[0].abs())))?;
        let reach = stretch - s.abs();
        (reach > 0.25 * stretch).then_some([s, reach])
    }

    /// Places from 0 to an end.
    fn places(&self, end: f64) -> impl Iterator<Item = f64> + use<> {
        (1..=PLACES).map(move |k| end * f64::from(k) / f64::from(PLACES))
    }

    /// How much the gap grows from its vertex to a distance from there, the mean of both sides \[mm\].
    fn rise(&self, vertex: f64, s: f64) -> f64 {
        if !self.pair.path.has_both_sides() {
            return self.profile.gap(s) - self.profile.gap(0.0);
        }
        0.5 * (self.profile.gap(vertex + s) + self.profile.gap(vertex - s)) - self.profile.gap(vertex)
    }

    /// Refuses a radius that is not that of curvature of the gap, `1/R = g″(0)`, whatever part of the stretch it is
    /// taken on.
    fn curved(&self) -> Result<(), Error> {
        let Some([vertex, reach]) = self.vertex() else { return Ok(()) };
        let (radius, given) = (self.numbers.at("radius"), self.length("radius"));
        let curvature = |k: i32| {
            let s = reach * 0.5f64.powi(k);
            2.0 * self.rise(vertex, s) / (self.pair.path.metric() * s).powi(2)
        };
        let told: Vec<f64> = (0..=HALVINGS).map(curvature).filter(|curvature| curvature.is_finite()).collect();
        let Some(finest) = told.last() else { return Ok(()) };
        // The same at half the distance, roughly: a wedge has any radius somewhere.
        let fits = |two: &[f64]| {
            (two[0] * given - 1.0).abs() <= self.allowed() && (two[1] - two[0]).abs() <= PARABOLIC * two[0].abs()
        };
        if told.windows(2).any(fits) {
            return Ok(());
        }
        let sampled = self.allowed() > ALIKE;
        // A half of the stretch holds enough points of a table.
        let curvature = told.get(1).filter(|_| sampled).unwrap_or(finest);
        if (*curvature * given - 1.0).abs() <= ALIKE {
            let message =
                "`hertz` is of a gap that is a parabola where the bodies touch, and that of the contact is none";
            return Err(self.refused(message));
        }
        if *curvature <= ALIKE * ALIKE / given {
            let message = format!("`radius` is {}, and the gap is flat", radius.number());
            return Err(radius.refused(message, "leave `oracle` out, or give the gap that it is of"));
        }
        self.same("radius", 1.0 / curvature, "the radius of curvature of the gap")
    }

    /// Refuses a gap that differs from that of the closed form where the latter is in contact.
    fn shaped(&self, closed: &Profile) -> Result<(), Error> {
        let Some([vertex, reach]) = self.vertex() else { return Ok(()) };
        let end = match self.oracle.read(&Quantity::HalfWidth) {
            Reading::Value { value, .. } => reach.min(value),
            Reading::Silent | Reading::Unavailable(_) => reach,
        };
        // Holes are functions of the angle, all others of the length along the path.
        let is_angle = matches!(closed, Profile::Hole { .. });
        let metric = if is_angle { 1.0 } else { self.pair.path.metric() };
        let both = self.places(end).map(|s| [s, closed.gap(metric * s), self.rise(vertex, s)]);
        let told: Vec<[f64; 3]> = both.filter(|[_, _, has]| has.is_finite()).collect();
        let size = told.iter().map(|[_, gap, _]| gap.abs()).fold(0.0, f64::max);
        let apart = |one: &[f64; 3]| (one[1] - one[2]).abs();
        let Some(worst) = told.iter().max_by(|a, b| apart(a).total_cmp(&apart(b))) else { return Ok(()) };
        if apart(worst) <= self.allowed() * size {
            return Ok(());
        }
        let [given, has] = [worst[1], worst[2]].map(|gap| rounded(gap / self.units.length));
        let place = if !self.pair.path.is_straight() {
            rounded(worst[0].to_degrees())
        } else {
            rounded(worst[0] / self.units.length)
        };
        Err(self.refused(format!(
            "at s = {place} the gap of `{}` has grown to {given}, and that of the contact to {has}",
            self.name
        )))
    }

    fn wedge(&self) -> Result<(), Error> {
        let [radius, round] = ["radius", "round"].map(|key| self.length(key));
        if let Profile::Wedge { slope } = self.profile {
            let given = round / radius;
            if (given - slope).abs() <= ALIKE * slope {
                return Ok(());
            }
            let [given, slope] = [given, slope].map(rounded);
            return Err(self.refused(format!(
                "`round` over `radius`, the slope of `wedge`, is {given}, and that of the gap is {slope}"
            )));
        }
        let tip = |s: f64| if s <= round { 0.5 * s * s / radius } else { round / radius * (s - 0.5 * round) };
        let end = self.pair.stretch * self.pair.path.metric();
        let ends = [0.0].into_iter().chain(self.places(round)).chain(self.places(end).filter(|s| *s > round));
        let points: Vec<[f64; 2]> = ends.map(|s| [s, tip(s)]).collect();
        self.shaped(&Profile::Table(points.into()))
    }

    /// The arc between two elastic bodies.
    fn arc(&self, of: &str) -> Result<&Circle, Error> {
        let has = match (&self.pair.path, self.pair.second) {
            (Path::Arc(arc), Some(_)) => return Ok(arc),
            (_, Some(_)) => "a straight path",
            (_, None) => "a rigid other side",
        };
        Err(self.refused(format!("`{}` is of {of} on an `arc`, and the contact has {has}", self.name)))
    }

    fn persson(&self) -> Result<(), Error> {
        let arc = self.arc("an elastic pin in an elastic hole")?;
        self.refuse_other_materials("a pin and a plate")?;
        let [radius, clearance] = ["radius", "clearance"].map(|key| self.length(key));
        match self.profile {
            Profile::Hole { radius: own, clearance: free } | Profile::Pin { radius: own, clearance: free } => {
                self.same("radius", own, "the pin's radius in the gap")?;
                self.same("clearance", free, "that of the gap")
            }
            _ => {
                // The arc may be the pin's or the hole's.
                let own = if (radius - arc.radius).abs() <= clearance { radius } else { arc.radius };
                self.same("radius", own, "the radius of the arc")?;
                self.shaped(&Profile::Hole { radius, clearance })
            }
        }
    }

    /// Refuses bodies of two materials.
    fn refuse_other_materials(&self, of: &str) -> Result<(), Error> {
        let bodies: Vec<_> = self.pair.bodies().map(|body| &self.scene.bodies[body]).collect();
        let [first, .., last] = bodies.as_slice() else { return Ok(()) };
        let [a, b] = [first.material, last.material];
        if (a.young - b.young).abs() <= ALIKE * a.young.max(b.young) && (a.poisson - b.poisson).abs() <= POISSON {
            return Ok(());
        }
        let told = [first, last].map(|body| {
            let young = rounded(body.material.young / self.units.stress);
            format!("`{}` has `young` {young} and `poisson` {}", body.name, body.material.poisson)
        });
        Err(self.refused(format!("`{}` is of {of} of one material, and {}", self.name, told.join(", "))))
    }

    fn lame(&self) -> Result<(), Error> {
        // Rings about y = 0 meet along a line at their radius.
        let of = |shape: &Shape| match self.pair.path {
            Path::Straight { .. } => along_y(shape),
            Path::Arc(arc) => extent(shape, arc.centre),
        };
        let radius_of_fit = match (self.pair.path, self.pair.second) {
            (Path::Straight { origin, .. }, Some(_)) => origin[1],
            _ => self.arc("two elastic rings")?.radius,
        };
        let [bore, fit, outside] = self.numbers.at("radii").exactly()?;
        let [inner, outer] = rings(self.pair).map(|body| &self.scene.bodies[body]);
        let ([least, _], [_, most]) = (of(&inner.shape), of(&outer.shape));
        let told = [
            (("the bore in `radii`", bore), least, format!("the inner radius of `{}`", inner.name)),
            (("the fit in `radii`", fit), radius_of_fit, "the radius of the fit".into()),
            (("the outside in `radii`", outside), most, format!("the outer radius of `{}`", outer.name)),
        ];
        for (given, has, what) in told {
            let radius = self.units.length * given.1.number();
            // A bore of nothing is as good as one that is small beside the fit.
            if !has.is_finite() || (radius - has).abs() > ALIKE * ALIKE * radius_of_fit {
                self.same_number(given, has, self.units.length, &what)?;
            }
        }
        self.same("interference", 0.0 - self.profile.gap(0.5 * self.pair.stretch), "that of the gap")
    }

    fn punch(&self) -> Result<(), Error> {
        if let Profile::Punch { half_width } = self.profile {
            return self.same("half-width", half_width, "that of the gap");
        }
        let Some([vertex, reach]) = self.vertex() else { return Ok(()) };
        let metric = self.pair.path.metric();
        let load = self.units.force * self.numbers.at("load").number() / self.scene.thickness;
        let flat = ALIKE * load / self.scene.modulus_of(self.pair);
        match self.places(reach).find(|s| self.rise(vertex, *s).abs() > flat) {
            Some(s) if metric * s < (1.0 - ALIKE) * self.length("half-width") => {
                let width = self.numbers.at("half-width").number();
                let [place, gap] = [metric * s, self.rise(vertex, s)].map(|x| rounded(x / self.units.length));
                Err(self.refused(format!(
                    "`flat-punch` has no gap up to its `half-width` {width}, and at s = {place} \
                    that of the contact has grown by {gap}"
                )))
            }
            Some(_) => Ok(()),
            None => self.same("half-width", metric * reach, "the stretch on which the gap is flat"),
        }
    }

    fn bars(&self) -> Result<(), Error> {
        let Some(second) = self.pair.second else {
            return Err(self.refused("`bars` is of two elastic bars, and the other side of the contact is rigid"));
        };
        self.refuse_other_materials("two bars")?;
        let material = self.scene.bodies[self.pair.first].material;
        let plane = material.plane_modulus(self.scene.plane);
        if (plane - material.young).abs() > ALIKE * plane {
            return Err(self.refused(format!(
                "`bars` is of bars that are free sideways, and in plane strain `poisson` {} makes them stiffer",
                material.poisson
            )));
        }
        let lengths = self.numbers.at("lengths").exactly::<2>()?;
        for (given, body) in lengths.into_iter().zip([self.pair.first, second]) {
            self.height(("an entry of `lengths`", given), body, "length")?;
        }
        self.same("gap", self.profile.gap(0.0), "that of the contact")?;
        let pushed = |body: usize| {
            let supports = self.scene.bodies[body].supports.iter();
            let along = supports.filter(|support| support.component == Component::Y);
            along.map(|support| support.value.abs()).fold(0.0, f64::max)
        };
        match [self.pair.first, second].map(pushed) {
            [moved, other] if moved > 0.0 && other <= 0.0 => self.same("push", moved, "the displacement prescribed"),
            _ => Ok(()),
        }
    }

    fn weight(&self) -> Result<(), Error> {
        let body = &self.scene.bodies[self.pair.first];
        self.height(("`height`", self.numbers.at("height")), self.pair.first, "height")?;
        let weights = body.loads.iter().filter_map(|load| match load {
            Load::BodyForce(force) => Some(force[1].abs()),
            _ => None,
        });
        let has: f64 = weights.sum();
        if has <= 0.0 {
            let message = format!("`own-weight` is of a block that has weight, and `{}` has no such load", body.name);
            return Err(self.refused(message));
        }
        let given = ("`weight`", self.numbers.at("weight"));
        self.same_number(given, has, self.units.specific_weight(), "that of the load")
    }

    /// Refuses a height that is not that of a rectangle.
    fn height(&self, given: (&str, Value), body: usize, what: &str) -> Result<(), Error> {
        let body = &self.scene.bodies[body];
        let Shape::Rectangle { y, .. } = body.shape else { return Ok(()) };
        self.same_number(given, y[1] - y[0], self.units.length, &format!("the {what} of `{}`", body.name))
    }
}

/// Where a rectangle begins and ends along y \[mm\]; NaN of other shapes.
fn along_y(shape: &Shape) -> [f64; 2] {
    match shape {
        Shape::Rectangle { y, .. } => *y,
        _ => [f64::NAN; 2],
    }
}

/// Smallest and largest radius of a body about a centre \[mm\]; NaN where the outline does not tell.
fn extent(shape: &Shape, centre: [f64; 2]) -> [f64; 2] {
    let of = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let radii = points.map(|point| (point[0] - centre[0]).hypot(point[1] - centre[1]));
        radii.fold([f64::INFINITY, 0.0], |[least, most], radius| [least.min(radius), most.max(radius)])
    };
    match shape {
        Shape::Ring { inner, outer, .. } => [inner.radius, outer.radius],
        Shape::Disc { radius, .. } => [0.0, *radius],
        Shape::Given(mesh) => of(&mut mesh.points.iter().copied()),
        Shape::Blocks(blocks) => of(&mut blocks.iter().flat_map(|block| block.corners)),
        Shape::Rectangle { .. } | Shape::Eye { .. } => [f64::NAN; 2],
    }
}
