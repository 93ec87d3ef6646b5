//! The same scene told differently: in metres, mirrored, or with its bodies in another order. Results must not notice.

use std::sync::Arc;

use crate::scene::{
    Action, Along, Circle, Load, MonotoneCubic, Path, Place, Profile, Scene, Shape, SidePart, VectorField,
};

/// Metres per millimetre.
const METRE: f64 = 1e-3;

impl Scene {
    /// The scene in metres and pascals instead of millimetres and megapascals; forces stay in newtons.
    pub fn in_metres(&self) -> Self {
        self.told([METRE; 2], 1.0 / (METRE * METRE))
    }

    /// The scene seen in a mirror on x = 0; its mesh is [`Mesh::mirrored`](crate::mesh::Mesh::mirrored), so that shapes
    /// stay as they are.
    pub fn mirrored(&self) -> Self {
        self.told([-1.0, 1.0], 1.0)
    }

    /// The scene with x and y times factors, equal but for the sign of the first, and pressures times another.
    fn told(&self, factors: [f64; 2], pressure: f64) -> Self {
        let [_, length] = factors;
        let mut scene = self.clone();
        scene.thickness *= if scene.is_of_revolution() { 1.0 } else { length };
        scene.grading.unit *= length;
        scene.reference.length *= length;
        scene.reference.gap *= length;
        scene.reference.pressure *= pressure;
        for pair in &mut scene.contacts {
            if pair.path.is_straight() {
                pair.stretch *= length;
                scale(&mut pair.ends.places, length);
            }
            pair.path = told_path(&pair.path, factors);
            scale_profile(&mut pair.profile, length);
            pair.clearance *= length;
            if factors[0] < 0.0 && pair.path.has_both_sides() {
                pair.profile = mirrored_profile(&pair.profile);
                pair.ends.places = pair.ends.places.iter().rev().map(|place| -place).collect();
            }
        }
        for body in &mut scene.bodies {
            scale_shape(&mut body.shape, length);
            body.material.young *= pressure;
            for support in &mut body.supports {
                support.value *= factors[support.component.index()];
                if let Place::Point(point) = &mut support.at {
                    *point = told_point(*point, factors);
                }
            }
            body.loads.iter_mut().for_each(|load| tell_load(load, factors, pressure));
        }
        scene
    }

    /// The scene with its bodies listed in the other order; none where there is only one.
    pub fn swapped(&self) -> Option<Self> {
        let last = self.bodies.len().checked_sub(1).filter(|last| *last > 0)?;
        let mut scene = self.clone();
        scene.bodies.reverse();
        for pair in &mut scene.contacts {
            pair.first = last - pair.first;
            pair.second = pair.second.map(|second| last - second);
        }
        Some(scene)
    }
}

fn told_point(point: [f64; 2], factors: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|k| 0.0 + point[k] * factors[k])
}

fn tell_load(load: &mut Load, factors: [f64; 2], pressure: f64) {
    let [x, length] = factors;
    // A vector along x turns round in a mirror.
    let turned = [x / length, 1.0];
    let told = |vector: [f64; 2], factor: f64| [0, 1].map(|k| vector[k] * factor * turned[k]);
    match load {
        Load::OnSide { part, action, .. } => {
            *part = part.map(|part| told_part(part, factors));
            match action {
                Action::Uniform(traction) => *traction = told(*traction, pressure),
                Action::Field(field) => *field = told_field(field, factors, turned.map(|sign| sign * pressure)),
                Action::Stress(field) => {
                    *field = told_field(field, factors, [1.0, 1.0, turned[0]].map(|sign| sign * pressure));
                }
                Action::Total(force) => *force = told(*force, 1.0),
                Action::Moment(moment) => *moment *= x,
            }
        }
        Load::BodyForce(density) => *density = told(density.map(|b| b * pressure / length), 1.0),
        Load::Force { at, force } => (*at, *force) = (told_point(*at, factors), told(*force, 1.0)),
        Load::RigidFace { component, force, .. } => *force *= turned[component.index()],
    }
}

/// A field at the places that it had, each component times a factor.
fn told_field<const N: usize>(field: &VectorField<N>, [x, y]: [f64; 2], by: [f64; N]) -> VectorField<N> {
    let inner = field.0.clone();
    VectorField::of(move |at| {
        let own = inner([at[0] / x, at[1] / y]);
        std::array::from_fn(|k| own[k] * by[k])
    })
}

fn told_part(part: SidePart, factors: [f64; 2]) -> SidePart {
    let (along, factor) = match part.along {
        Along::Axis(component) => (part.along, factors[component.index()]),
        Along::Angle { centre } => (Along::Angle { centre: told_point(centre, factors) }, factors[0] / factors[1]),
    };
    let [from, to] = [part.from * factor, part.to * factor];
    let [from, to] = if factor < 0.0 { [to, from] } else { [from, to] };
    SidePart { along, from, to }
}

/// Tables and drawn sides may be no even functions of s; a table that begins at 0 stands for both sides.
fn mirrored_profile(profile: &Profile) -> Profile {
    match profile {
        Profile::Table(points) if points.first().is_some_and(|[s, _]| *s < 0.0) => {
            Profile::Table(points.iter().rev().map(|[s, gap]| [-s, *gap]).collect())
        }
        Profile::Smooth(cubic) if cubic.points.first().is_some_and(|[s, _]| *s < 0.0) => {
            let points = cubic.points.iter().rev().map(|[s, gap]| [-s, *gap]).collect();
            let slopes = cubic.slopes.iter().rev().map(|slope| -slope).collect();
            Profile::Smooth(Arc::new(MonotoneCubic { points, slopes }))
        }
        Profile::Bodies(drawn) => {
            let factors = [-1.0, 1.0];
            let path = told_path(&drawn.path, factors);
            Profile::Bodies(Arc::new(drawn.moved(path, |point| told_point(point, factors))))
        }
        other => other.clone(),
    }
}

fn told_path(path: &Path, factors: [f64; 2]) -> Path {
    let moved = path.moved_to(told_point(path.origin(), factors));
    match moved {
        Path::Arc(Circle { centre, radius }) => Path::Arc(Circle { centre, radius: radius * factors[1] }),
        straight => straight,
    }
}

fn scale_profile(profile: &mut Profile, length: f64) {
    match profile {
        Profile::Drawn | Profile::Wedge { .. } => {}
        Profile::Uniform(one)
        | Profile::Punch { half_width: one }
        | Profile::Circle { radius: one }
        | Profile::Parabola { radius: one } => *one *= length,
        Profile::Circles { radii: [one, other] }
        | Profile::Cosine { amplitude: one, wavelength: other }
        | Profile::Hole { radius: one, clearance: other }
        | Profile::Pin { radius: one, clearance: other } => scale([one, other], length),
        Profile::Table(points) => *points = points.iter().map(|point| point.map(|x| x * length)).collect(),
        Profile::Smooth(cubic) => scale(Arc::make_mut(cubic).points.as_flattened_mut(), length),
        Profile::Bodies(drawn) => {
            let path = told_path(&drawn.path, [length; 2]);
            *drawn = Arc::new(drawn.moved(path, |point| point.map(|x| x * length)));
        }
        Profile::Even { coefficients } => {
            *coefficients = coefficients.iter().zip(0..).map(|(c, k)| c / length.powi(1 + 2 * k)).collect();
        }
        Profile::Powers { terms } => {
            *terms = terms.iter().map(|&[c, n]| [c * length.powf(1.0 - n), n]).collect();
        }
    }
}

fn scale_shape(shape: &mut Shape, length: f64) {
    match shape {
        Shape::Rectangle { x, y, .. } => scale([x, y].into_iter().flatten(), length),
        Shape::Disc { centre, radius, .. } => scale(centre.iter_mut().chain([radius]), length),
        Shape::Ring { pole, inner, outer, .. } => {
            let circles = [inner, outer].into_iter().flat_map(lengths_of);
            scale(pole.iter_mut().chain(circles), length);
        }
        Shape::Eye { pole, hole, outer_radius, shank_half_width, shank_end } => {
            let own = [outer_radius, shank_half_width, shank_end];
            scale(pole.iter_mut().chain(lengths_of(hole)).chain(own), length);
        }
        Shape::Blocks(blocks) => {
            for block in blocks {
                let centres = block.arcs.iter_mut().flatten();
                scale(block.corners.iter_mut().chain(centres).flatten(), length);
            }
        }
        Shape::Given(mesh) => scale(Arc::make_mut(mesh).points.as_flattened_mut(), length),
    }
}

fn lengths_of(Circle { centre, radius }: &mut Circle) -> impl Iterator<Item = &mut f64> {
    centre.iter_mut().chain([radius])
}

fn scale<'a>(lengths: impl IntoIterator<Item = &'a mut f64>, factor: f64) {
    lengths.into_iter().for_each(|length| *length *= factor);
}
