//! The same scene told differently: in metres, mirrored, or with its bodies in another order. Results must not notice.

use std::sync::Arc;

use crate::scene::{
    Action, Along, BlockShape, Body, Circle, Component, GivenMesh, Load, MonotoneCubic, Path, Place, Profile, Scene,
    Shape, SidePart, VectorField,
};

/// Metres per millimetre.
const METRE: f64 = 1e-3;

impl Scene {
    /// The scene in metres and pascals instead of millimetres and megapascals; forces stay in newtons.
    pub fn in_metres(&self) -> Self {
        let (length, pressure) = (METRE, 1.0 / (METRE * METRE));
        let mut scene = self.clone();
        scene.thickness *= if scene.is_of_revolution() { 1.0 } else { length };
        scene.grading.unit *= length;
        scene.reference.length *= length;
        scene.reference.gap *= length;
        scene.reference.pressure *= pressure;
        for pair in &mut scene.contacts {
            match pair.path {
                Path::Arc(_) => {}
                Path::Straight { .. } => {
                    pair.stretch *= length;
                    pair.ends.places.iter_mut().for_each(|place| *place *= length);
                }
            }
            pair.path = scaled_path(&pair.path, length);
            pair.profile = scaled_profile(&pair.profile, length);
            pair.clearance *= length;
        }
        for body in &mut scene.bodies {
            body.shape = scaled_shape(&body.shape, length);
            body.material.young *= pressure;
            for support in &mut body.supports {
                support.value *= length;
                if let Place::Point(point) = &mut support.at {
                    *point = point.map(|x| x * length);
                }
            }
            body.loads.iter_mut().for_each(|load| scale_load(load, length, pressure));
        }
        scene
    }

    /// The scene seen in a mirror on x = 0; its mesh is [`Mesh::mirrored`](crate::mesh::Mesh::mirrored).
    pub fn mirrored(&self) -> Self {
        let mut scene = self.clone();
        for body in &mut scene.bodies {
            mirror_body(body);
        }
        for pair in &mut scene.contacts {
            pair.path = mirrored_path(&pair.path);
            if pair.path.has_both_sides() {
                pair.profile = mirrored_profile(&pair.profile);
                pair.ends.places = pair.ends.places.iter().rev().map(|place| -place).collect();
            }
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

fn scale_load(load: &mut Load, length: f64, pressure: f64) {
    match load {
        Load::OnSide { part, action, .. } => {
            *part = part.map(|part| scaled_part(part, length));
            match action {
                Action::Uniform(traction) => *traction = traction.map(|t| t * pressure),
                Action::Field(field) => *field = scaled_field(field, length, pressure),
                Action::Stress(field) => *field = scaled_field(field, length, pressure),
                Action::Total(_) => {}
                Action::Moment(moment) => *moment *= length,
            }
        }
        Load::BodyForce(density) => *density = density.map(|b| b * pressure / length),
        Load::Force { at, .. } => *at = at.map(|x| x * length),
        Load::RigidFace { .. } => {}
    }
}

fn scaled_field<const N: usize>(field: &VectorField<N>, length: f64, pressure: f64) -> VectorField<N> {
    let inner = field.0.clone();
    VectorField::of(move |at| inner(at.map(|x| x / length)).map(|t| t * pressure))
}

fn scaled_part(part: SidePart, length: f64) -> SidePart {
    match part.along {
        Along::Axis(_) => SidePart { from: part.from * length, to: part.to * length, ..part },
        Along::Angle { centre } => SidePart { along: Along::Angle { centre: centre.map(|x| x * length) }, ..part },
    }
}

fn mirror_body(body: &mut Body) {
    for support in &mut body.supports {
        if support.component == Component::X {
            support.value = -support.value;
        }
        if let Place::Point(point) = &mut support.at {
            point[0] = -point[0];
        }
    }
    for load in &mut body.loads {
        match load {
            Load::OnSide { part, action, .. } => {
                *part = part.map(mirrored_part);
                match action {
                    Action::Uniform(vector) | Action::Total(vector) => vector[0] = -vector[0],
                    Action::Field(field) => *field = mirrored_field(field, [-1.0, 1.0]),
                    Action::Stress(field) => *field = mirrored_field(field, [1.0, 1.0, -1.0]),
                    Action::Moment(moment) => *moment = -*moment,
                }
            }
            Load::BodyForce(density) => density[0] = -density[0],
            Load::Force { at, force } => (at[0], force[0]) = (-at[0], -force[0]),
            Load::RigidFace { component, force, .. } => {
                if *component == Component::X {
                    *force = -*force;
                }
            }
        }
    }
}

/// A field seen in the mirror, each component with its sign there.
fn mirrored_field<const N: usize>(field: &VectorField<N>, signs: [f64; N]) -> VectorField<N> {
    let inner = field.0.clone();
    VectorField::of(move |[x, y]| {
        let seen = inner([-x, y]);
        std::array::from_fn(|k| signs[k] * seen[k])
    })
}

fn mirrored_part(part: SidePart) -> SidePart {
    let turned = SidePart { from: -part.to, to: -part.from, ..part };
    match part.along {
        Along::Axis(Component::X) => turned,
        Along::Axis(Component::Y) => part,
        Along::Angle { centre: [x, y] } => SidePart { along: Along::Angle { centre: [-x, y] }, ..turned },
    }
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
            let path = mirrored_path(&drawn.path);
            Profile::Bodies(Arc::new(drawn.moved(path, |[x, y]| [0.0 - x, y])))
        }
        other => other.clone(),
    }
}

fn mirrored_path(path: &Path) -> Path {
    let [x, y] = path.origin();
    path.moved_to([0.0 - x, y])
}

fn scaled_path(path: &Path, length: f64) -> Path {
    match *path {
        Path::Arc(circle) => Path::Arc(scaled_circle(circle, length)),
        line => line.moved_to(line.origin().map(|x| x * length)),
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
            let path = scaled_path(&drawn.path, length);
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
