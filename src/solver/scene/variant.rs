//! The same scene told differently: in metres, mirrored, or with its bodies in another order. Results must not notice.

use std::sync::Arc;

use crate::scene::{
    Action, Along, BlockShape, Circle, GivenMesh, Load, MonotoneCubic, Path, Place, Profile, Scene, Shape, SidePart,
    VectorField,
};

/// Metres per millimetre.
const METRE: f64 = 1e-3;

impl Scene {
    /// The scene in metres and pascals instead of millimetres and megapascals; forces stay in newtons.
    pub fn in_metres(&self) -> Self {
        self.told([METRE; 2], 1.0 / (METRE * METRE))
    }

    /// The scene seen in a mirror on x = 0; its mesh is [`Mesh::mirrored`](crate::mesh::Mesh::mirrored), so that shapes stay as they are.
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
                pair.ends.places.iter_mut().for_each(|place| *place *= length);
            }
            pair.path = told_path(&pair.path, factors);
            pair.profile = scaled_profile(&pair.profile, length);
            pair.clearance *= length;
            if factors[0] < 0.0 && pair.path.has_both_sides() {
                pair.profile = mirrored_profile(&pair.profile);
                pair.ends.places = pair.ends.places.iter().rev().map(|place| -place).collect();
            }
        }
        for body in &mut scene.bodies {
            body.shape = scaled_shape(&body.shape, length);
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

fn scaled_circle(circle: Circle, length: f64) -> Circle {
    Circle { centre: circle.centre.map(|x| x * length), radius: circle.radius * length }
}

fn scaled_profile(profile: &Profile, length: f64) -> Profile {
    match *profile {
        Profile::Uniform(gap) => Profile::Uniform(gap * length),
        Profile::Drawn => Profile::Drawn,
        Profile::Table(ref points) => Profile::Table(points.iter().map(|point| point.map(|x| x * length)).collect()),
        Profile::Smooth(ref cubic) => {
            let points = cubic.points.iter().map(|point| point.map(|x| x * length)).collect();
            Profile::Smooth(Arc::new(MonotoneCubic { points, slopes: cubic.slopes.clone() }))
        }
        Profile::Bodies(ref drawn) => {
            let path = told_path(&drawn.path, [length; 2]);
            Profile::Bodies(Arc::new(drawn.moved(path, |point| point.map(|x| x * length))))
        }
        Profile::Punch { half_width } => Profile::Punch { half_width: half_width * length },
        Profile::Circle { radius } => Profile::Circle { radius: radius * length },
        Profile::Circles { radii } => Profile::Circles { radii: radii.map(|radius| radius * length) },
        Profile::Parabola { radius } => Profile::Parabola { radius: radius * length },
        Profile::Even { ref coefficients } => {
            let scaled = coefficients.iter().zip(0..).map(|(c, k)| c / length.powi(1 + 2 * k));
            Profile::Even { coefficients: scaled.collect() }
        }
        Profile::Powers { ref terms } => {
            Profile::Powers { terms: terms.iter().map(|&[c, n]| [c * length.powf(1.0 - n), n]).collect() }
        }
        Profile::Wedge { slope } => Profile::Wedge { slope },
        Profile::Cosine { amplitude, wavelength } => {
            Profile::Cosine { amplitude: amplitude * length, wavelength: wavelength * length }
        }
        Profile::Hole { radius, clearance } => Profile::Hole { radius: radius * length, clearance: clearance * length },
        Profile::Pin { radius, clearance } => Profile::Pin { radius: radius * length, clearance: clearance * length },
    }
}

fn scaled_shape(shape: &Shape, length: f64) -> Shape {
    let scaled = |values: [f64; 2]| values.map(|x| x * length);
    match *shape {
        Shape::Rectangle { x, y, contact } => Shape::Rectangle { x: scaled(x), y: scaled(y), contact },
        Shape::Disc { centre, radius, sector, contact } => {
            Shape::Disc { centre: scaled(centre), radius: radius * length, sector, contact }
        }
        Shape::Ring { pole, inner, outer, sweep, both_sides, contact } => Shape::Ring {
            pole: scaled(pole),
            inner: scaled_circle(inner, length),
            outer: scaled_circle(outer, length),
            sweep,
            both_sides,
            contact,
        },
        Shape::Eye { pole, hole, outer_radius, shank_half_width, shank_end } => Shape::Eye {
            pole: scaled(pole),
            hole: scaled_circle(hole, length),
            outer_radius: outer_radius * length,
            shank_half_width: shank_half_width * length,
            shank_end: shank_end * length,
        },
        Shape::Blocks(ref blocks) => {
            let each = blocks.iter().map(|block| BlockShape {
                corners: block.corners.map(scaled),
                arcs: block.arcs.map(|centre| centre.map(scaled)),
                ..block.clone()
            });
            Shape::Blocks(each.collect())
        }
        Shape::Given(ref mesh) => {
            let points = mesh.points.iter().copied().map(scaled).collect();
            Shape::Given(Arc::new(GivenMesh { points, ..GivenMesh::clone(mesh) }))
        }
    }
}
