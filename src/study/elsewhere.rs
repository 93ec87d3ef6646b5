//! How a scene is run by codes that no script of ours starts, MOOSE and MFEM, in their own words.
//!
//! Numbers and names are those of the scene. What is said of the codes is from their documentation and sources: MOOSE's `Contact` action
//! and its tests, libMesh's reader of Gmsh files, MFEM's mesh formats and its miniapp `miniapps/tribol/contact-patch-test.cpp`.

use crate::mesh::Mesh;
use crate::referee::export::gmsh;
use crate::scene::{Action, Body, ContactPair, Load, Material, Place, PlaneHypothesis, Profile, Scene};
use crate::study::described;

/// What is typed into both codes: numbers of sides and bodies, elastic constants, supports, loads, contacts, and what is to be printed.
pub fn paragraph(name: &str, scene: &Scene, mesh: &Mesh) -> String {
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
            "In two dimensions both solve plane strain, which E' = E (1 + 2ν)/(1 + ν)² and ν' = ν/(1 + ν), as below, make the plane stress of the scene"
        }
        PlaneHypothesis::Axisymmetric | PlaneHypothesis::AxisymmetricAboutX => {
            "MOOSE has bodies of revolution by `coord_type = RZ` in `[Mesh]`; MFEM's `ElasticityIntegrator` has no hoop strain, so that it needs the whole \
             body in three dimensions"
        }
    };
    let forces = match scene.is_of_revolution() {
        true => "whole forces, all around".into(),
        false => format!("per thickness {}", scene.thickness),
    };
    let rigid = match scene.contacts.iter().any(|pair| pair.second.is_none()) {
        true => {
            "The rigid other side is a body of your own with the initial gap of the scene, fixed in all its nodes; `RIGID` is its contact side. "
        }
        false => "",
    };
    let pressed = |pair: &ContactPair| match pair.profile {
        Profile::Uniform(gap) if gap < 0.0 && pair.second.is_some() => Some(format!(
            "The mesh has no interference: both sides of `{}` lie on one another, and the {} mm by which they overlap are to be given beside it, as by \
             moving the nodes of one body. ",
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
        for load in &body.loads {
            match load {
                Load::OnSide { boundary, part: None, action: Action::Uniform(traction) } => {
                    let both = ["x", "y"].into_iter().zip(traction).filter(|(_, value)| value.abs() > 0.0);
                    conditions.extend(both.map(|(axis, value)| on_side("NeumannBC", boundary, axis, *value)));
                }
                other => conditions += &format!("  # `{}`: {}\n", body.name, described::load(other)),
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
