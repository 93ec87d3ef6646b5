//! A scene in words and numbers, where a case comes from; and how a scene is run by codes that no script of ours
//! starts, MOOSE and MFEM, in their own words.
//!
//! What is said of these codes is from their documentation and sources: MOOSE's `Contact` action and its tests,
//! libMesh's reader of Gmsh files, MFEM's mesh formats and its miniapp `miniapps/tribol/contact-patch-test.cpp`.

use std::f64::consts::PI;

use crate::case::Case;
use crate::mesh::Mesh;
use crate::oracle::Source;
use crate::referee::export::gmsh;
use crate::scene::{
    Action, Body, ContactPair, Face, Load, Material, Path, Place, PlaneHypothesis, Profile, Scene, Sector, Shape,
    SidePart, Support,
};

/// Geometry, materials, supports, loads, contacts and equations.
pub fn scene(scene: &Scene) -> Vec<String> {
    let mut text = vec![format!("## Scene\n\n{}", hypothesis(scene, ""))];
    text.extend(scene.bodies.iter().map(body));
    text.extend(scene.contacts.iter().map(|pair| contact(scene, pair)));
    text.push(equations(scene.plane));
    text
}

/// What the two coordinates stand for, with the thickness in a unit.
pub fn hypothesis(scene: &Scene, unit: &str) -> String {
    match scene.plane {
        PlaneHypothesis::Axisymmetric => {
            "Bodies of revolution about x = 0: x is the radius, loads and resultants are whole forces.".into()
        }
        PlaneHypothesis::AxisymmetricAboutX => {
            "Bodies of revolution about y = 0: y is the radius, loads and resultants are whole forces.".into()
        }
        plane => format!("Plane {}, thickness {}{unit}.", plane.name(), scene.thickness),
    }
}

fn body(body: &Body) -> String {
    let supports =
        body.supports.iter().map(|Support { at, component, value }| format!("u_{component} = {value} at `{at}`"));
    let loads = body.loads.iter().map(load);
    let listed = |name: &str, all: Vec<String>| match &all[..] {
        [] => format!("* {name}: none"),
        some => format!("* {name}: {}", some.join("; ")),
    };
    format!(
        "**Body `{}`**\n\n* shape: {}\n* material: E = {}, ν = {}\n{}\n{}",
        body.name,
        shape(&body.shape),
        body.material.young,
        body.material.poisson,
        listed("supports", supports.collect()),
        listed("loads", loads.collect()),
    )
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::Rectangle { x, y, contact } => format!(
            "rectangle {} ≤ x ≤ {}, {} ≤ y ≤ {}; `contact` is its {} side, `far` the opposite one, `left` and `right` \
            the others",
            x[0],
            x[1],
            y[0],
            y[1],
            match contact {
                Face::Bottom => "lower",
                Face::Top => "upper",
            }
        ),
        Shape::Disc { centre, radius, sector, contact } => format!(
            "{} of a disc of radius {radius} about {centre:?}; `contact` is its {} arc, `axis` x = {}, `cut` or \
            `middle` the horizontal diameter",
            match sector {
                Sector::Quarter => "lower right quarter",
                Sector::RightHalf => "right half",
                Sector::LowerHalf => "lower half",
                Sector::Whole => "all",
            },
            match contact {
                Face::Bottom => "lower",
                Face::Top => "upper",
            },
            centre[0]
        ),
        Shape::Ring { inner, outer, sweep, both_sides, contact, .. } => format!(
            "ring from the downward vertical {} through {} °, inner circle of radius {} about {:?}, outer circle of \
            radius {} about {:?}; `contact` is its {} arc, `start` and `end` the straight sides",
            if *both_sides { "to either side" } else { "counter-clockwise" },
            sweep.to_degrees(),
            inner.radius,
            inner.centre,
            outer.radius,
            outer.centre,
            match contact {
                Face::Bottom => "inner",
                Face::Top => "outer",
            }
        ),
        Shape::Eye { hole, outer_radius, shank_half_width, shank_end, .. } => format!(
            "right half (x ≥ 0) of a rod's eye: hole of radius {} about {:?} (`contact`), outer radius {outer_radius} \
            about the same point, shank of half-width {shank_half_width} upwards with a flat `end` {shank_end} above \
            that point, joined without a fillet; `axis` is x = 0",
            hole.radius, hole.centre
        ),
        Shape::Blocks(blocks) => format!("{} quadrilateral blocks", blocks.len()),
        Shape::Given(_) => "a mesh made elsewhere".into(),
    }
}

/// A load in words.
pub fn load(load: &Load) -> String {
    match load {
        Load::OnSide { boundary, part, action } => on_side(boundary, part.as_ref(), action),
        Load::BodyForce(force) => format!("force {force:?} N/mm³ in its volume"),
        Load::Force { at, force } => format!("force {force:?} N at {at:?}"),
        Load::RigidFace { boundary, component, force } => {
            format!("`{boundary}` stays flat: u_{component} is common to it, and takes {force} N in all")
        }
    }
}

fn on_side(boundary: &str, part: Option<&SidePart>, action: &Action) -> String {
    let what = match action {
        Action::Uniform(traction) => format!("traction {traction:?} MPa"),
        Action::Field(_) => "the traction of the closed form".into(),
        Action::Stress(_) if part.is_none() => "traction σ n of the closed form's stresses in the half-plane".into(),
        Action::Stress(_) => "traction σ n of the closed form's stresses".into(),
        Action::Total(force) => format!("force {force:?} N, spread evenly,"),
        Action::Moment(moment) => {
            format!("couple {moment} N mm, counter-clockwise, as a traction linear in the distance from the middle,")
        }
    };
    let between = |part: &SidePart| format!(" from {} to {}", part.shown(part.from), part.shown(part.to));
    format!("{what} on `{boundary}`{}", part.map_or_else(String::new, between))
}

fn contact(scene: &Scene, pair: &ContactPair) -> String {
    let first = &scene.bodies[pair.first].name;
    let other = pair.second.map_or("a rigid profile".into(), |body| format!("`{}`", scene.bodies[body].name));
    let (along, unit, per_unit) = match &pair.path {
        Path::Straight { origin, both_sides: true } => (format!("x from {origin:?}, on both sides"), "mm", 1.0),
        Path::Straight { origin, .. } if scene.plane.radial() == Some(0) => {
            (format!("the radius x from {origin:?}"), "mm", 1.0)
        }
        Path::Straight { origin, .. } => (format!("|x| from {origin:?}"), "mm", 1.0),
        Path::Arc(circle) => {
            let along = format!(
                "the angle from the downward vertical about {:?}, on the circle of radius {}",
                circle.centre, circle.radius
            );
            (along, "°", 180.0 / PI)
        }
    };
    let half = if pair.symmetric { " The scene is one half of a symmetric one; resultants are of both." } else { "" };
    let clearance =
        if pair.clearance > 0.0 { format!(", and {} more everywhere", pair.clearance) } else { String::new() };
    format!(
        "**Contact `{}`** of `{first}` with {other}, without friction. Coordinate s: {along}. Initial normal gap: {}. \
        Contact may occur for |s| ≤ {} {unit}.{half}",
        pair.name,
        gap(&pair.profile) + &clearance,
        // Without what conversion to degrees leaves in its last digits.
        (per_unit * pair.stretch * 1e9).round() / 1e9
    )
}

fn gap(profile: &Profile) -> String {
    match profile {
        Profile::Uniform(gap) => format!("g = {gap}"),
        Profile::Drawn | Profile::Bodies(_) => "as the bodies are drawn".into(),
        Profile::Punch { half_width } => format!("g = 0 for |s| ≤ {half_width}, no other side beyond"),
        Profile::Circle { radius } => format!("g = R − √(R² − s²), R = {radius}"),
        Profile::Circles { radii } => format!("g = Σ (R − sgn(R) √(R² − s²)), R = {radii:?}"),
        Profile::Parabola { radius } => format!("g = s²/2R, R = {radius}"),
        Profile::Powers { terms } => format!("g = Σ c |s|ⁿ, [c, n] = {terms:?}"),
        Profile::Even { coefficients } => format!("g = Σ c_k s^(2k+2), c = {coefficients:?}"),
        Profile::Wedge { slope } => format!("g = {slope} |s|"),
        Profile::Table(points) => format!("straight lines between [s, g] = {points:?}"),
        Profile::Smooth(cubic) => format!("a monotone cubic through [s, g] = {:?}", cubic.points),
        Profile::Cosine { amplitude, wavelength } => format!("g = {amplitude} (1 − cos 2πs/{wavelength})"),
        Profile::Hole { radius, clearance } => {
            format!("g = √((R+c)² − c² sin²s) − c cos s − R, R = {radius}, c = {clearance}")
        }
        Profile::Pin { radius, clearance } => {
            format!("g = R + c − c cos s − √(R² − c² sin²s), R = {radius}, c = {clearance}")
        }
    }
}

/// What is solved.
pub fn equations(plane: PlaneHypothesis) -> String {
    let lame = match plane {
        PlaneHypothesis::Stress => "λ = Eν/(1−ν²)",
        _ => "λ = Eν/((1+ν)(1−2ν))",
    };
    let [hoop, width] = match plane.is_of_revolution() {
        true => [
            match plane.radial() {
                Some(1) => "sym ∇u in (r, z) = (y, x) and ε_θ = u_r/r, all integrals with 2πr",
                _ => "sym ∇u in (r, z) = (x, y) and ε_θ = u_r/r, all integrals with 2πr",
            },
            "The second-moment radius is √(5/2 ∫p r² dA / ∫p dA), dA = 2πr dr: that of a semi-ellipsoid is its \
            radius; the contact radius is where the contact ends.",
        ],
        false => [
            "sym ∇u",
            "The second-moment width is 2 √(∫p s²/∫p) about the centre of pressure, on an arc the same of the angle; \
            the half-width is half of what lies between the ends of the contact.",
        ],
    };
    format!(
        "## Equations\n\nSmall strain: ε = {hoop}, σ = λ tr ε I + 2μ ε with {lame} and μ = E/(2(1+ν)), div σ + b = 0. \
        On the contact n is the outward normal of the first body on its undeformed path, and w = (u₁ − u₂)·n, with u₂ \
        = 0 where the other side is rigid. There h = g − w ≥ 0, p = −n·σn ≥ 0, p h = 0, and there is no shear. p is \
        per area of the undeformed path. {width}"
    )
}

/// Where a case and its closed form come from.
pub fn sources(case: &Case) -> Vec<String> {
    let closed_form = case.oracle().map(|oracle| oracle.source());
    let cited = closed_form.map(|Source { name, citation, note }| format!("{name}: {citation} ({note})"));
    std::iter::once(case.source.clone()).filter(|source| !source.is_empty()).chain(cited).collect()
}

/// What is typed into both codes: numbers of sides and bodies, elastic constants, supports, loads, contacts, and what
/// is to be printed.
pub fn elsewhere(name: &str, scene: &Scene, mesh: &Mesh) -> String {
    let numbers = gmsh::numbers(scene, mesh);
    let listed: Vec<String> = numbers.iter().map(|(name, number)| format!("`{name}` {number}")).collect();
    let lame = |body: &Body| {
        let Material { young, poisson } = in_plane_strain(body.material, scene.plane);
        let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
        format!("`{}`: λ = {lambda:.3}, μ = {:.3}", body.name, young / (2.0 * (1.0 + poisson)))
    };
    let plane = match scene.plane {
        PlaneHypothesis::Strain => "In two dimensions both solve plane strain, as the scene is",
        PlaneHypothesis::Stress => {
            "In two dimensions both solve plane strain, which E' = E (1 + 2ν)/(1 + ν)² and ν' = ν/(1 + ν), as below, \
            make the plane stress of the scene"
        }
        PlaneHypothesis::Axisymmetric | PlaneHypothesis::AxisymmetricAboutX => {
            "MOOSE has bodies of revolution by `coord_type = RZ` in `[Mesh]`; MFEM's `ElasticityIntegrator` has no \
            hoop strain, so that it needs the whole body in three dimensions"
        }
    };
    let forces = match scene.is_of_revolution() {
        true => "whole forces, all around".into(),
        false => format!("per thickness {}", scene.thickness),
    };
    let rigid = match scene.contacts.iter().any(|pair| pair.second.is_none()) {
        true => {
            "The rigid other side is a body of your own with the initial gap of the scene, fixed in all its nodes; \
            `RIGID` is its contact side. "
        }
        false => "",
    };
    let pressed = |pair: &ContactPair| match pair.profile {
        Profile::Uniform(gap) if gap < 0.0 && pair.second.is_some() => Some(format!(
            "The mesh has no interference: both sides of `{}` lie on one another, and the {} mm by which they overlap \
            are to be given beside it, as by moving the nodes of one body. ",
            pair.name, -gap
        )),
        _ => None,
    };
    let pressed: String = scene.contacts.iter().filter_map(pressed).collect();
    let page = format!(
        include_str!("elsewhere.md"),
        name = name,
        numbers = listed.join(", "),
        forces = forces,
        plane = plane,
        rigid = rigid,
        pressed = pressed,
        moose = moose(scene, &numbers),
        judged = format!(
            "`--column pressure={}_normal_lm --unit pressure=MPa --unit x=mm --unit y=mm`",
            plain(&scene.contact().name)
        ),
        lame = scene.bodies.iter().map(lame).collect::<Vec<_>>().join("; "),
    );
    page.trim_end().to_owned()
}

/// The material by which plane strain is what a hypothesis makes of another.
fn in_plane_strain(material: Material, plane: PlaneHypothesis) -> Material {
    let Material { young, poisson } = material;
    match plane {
        PlaneHypothesis::Stress => Material {
            young: young * (1.0 + 2.0 * poisson) / (1.0 + poisson).powi(2),
            poisson: poisson / (1.0 + poisson),
        },
        _ => material,
    }
}

/// The parts of an input file of MOOSE that are of the scene.
fn moose(scene: &Scene, numbers: &[(String, usize)]) -> String {
    let number = |name: &str| numbers.iter().find(|(known, _)| known == name).map_or(0, |(_, number)| *number);
    let [mut materials, mut conditions, mut contacts, mut profiles] = [const { String::new() }; 4];
    for body in &scene.bodies {
        let on_side = |kind: &str, side: &str, axis: &str, value: f64| {
            let (boundary, variable) = (number(&format!("{} {side}", body.name)), format!("disp_{axis}"));
            let lines = [("type", kind), ("variable", &variable), ("boundary", &boundary.to_string())];
            block(&[&body.name, side, axis], &[&lines[..], &[("value", &value.to_string())]].concat())
        };
        for support in &body.supports {
            conditions += &match &support.at {
                Place::Boundary(side) => on_side("DirichletBC", side, support.component.name(), support.value),
                Place::Point(_) => format!("  # u_{} = {} at {}\n", support.component, support.value, support.at),
            };
        }
        for one in &body.loads {
            match one {
                Load::OnSide { boundary, part: None, action: Action::Uniform(traction) } => {
                    let both = ["x", "y"].into_iter().zip(traction).filter(|(_, value)| value.abs() > 0.0);
                    conditions.extend(both.map(|(axis, value)| on_side("NeumannBC", boundary, axis, *value)));
                }
                other => conditions += &format!("  # `{}`: {}\n", body.name, load(other)),
            }
        }
        let Material { young, poisson } = in_plane_strain(body.material, scene.plane);
        let constants = [("youngs_modulus", &*young.to_string()), ("poissons_ratio", &poisson.to_string())];
        let of = [("type", "ComputeIsotropicElasticityTensor"), ("block", &number(&body.name).to_string())];
        materials += &block(&[&body.name], &[of, constants].concat());
    }
    for pair in &scene.contacts {
        let side = |body: usize, side: usize| number(&format!("{} {}", scene.bodies[body].name, pair.sides[side]));
        let primary = pair.second.map_or("RIGID".into(), |body| side(body, 1).to_string());
        let sides = [("secondary", &*side(pair.first, 0).to_string()), ("primary", &primary)];
        let name = plain(&pair.name);
        contacts += &block(&[&name], &[sides, [("model", "frictionless"), ("formulation", "mortar")]].concat());
        let [multiplier, where_it_is] = [format!("{name}_normal_lm"), format!("{name}_secondary_subdomain")];
        let sampled = [("variable", &*multiplier), ("block", &where_it_is), ("sort_by", "x")];
        profiles += &block(&[&name], &[&[("type", "NodalValueSampler")], &sampled[..]].concat());
    }
    let all =
        [("Materials", materials), ("BCs", conditions), ("Contact", contacts), ("VectorPostprocessors", profiles)];
    all.map(|(name, inside)| format!("[{name}]\n{inside}[]\n")).concat()
}

/// A block of an input file, called by the parts of its name.
fn block(name: &[&str], given: &[(&str, &str)]) -> String {
    let lines: String = given.iter().map(|(key, value)| format!("    {key} = {value}\n")).collect();
    format!("  [{}]\n{lines}  []\n", plain(&name.join(" ")))
}

/// A name that MOOSE takes.
fn plain(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
}
