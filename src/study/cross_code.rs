//! The solver against other finite element codes on the same discrete problem: our mesh, loads, supports and line
//! elements, assembled and solved by another code; agreement to round-off, a code check. Below is our discretisation as
//! plain numbers, for the other code.

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference, library};
use crate::contact::Quadrature;
use crate::elasticity::{BodySystem, Dofs};
use crate::error::Error;
use crate::mesh::{BodyMesh, Order, Resolution, candidates};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, changed_versions, file};
use crate::oracle::cross_code::live::Live;
use crate::oracle::cross_code::{Code, DiscreteAnswer, DiscreteProblem, SET_UP};
use crate::scene::{Action, Load, Path, Profile, Scene};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::differences::{relative_difference, reproduced, suffix, worst_difference};

/// All trials, against answers that are frozen, or of the codes themselves.
pub fn against(live: Option<Live>) -> Vec<Planned<Numbers>> {
    let of_both = |(name, order): (&'static str, Order)| {
        Code::TWINS.map(|code| {
            let title = format!("{name}, {}-node, {}{}", order.nodes_per_cell(), code.name(), suffix(live));
            Planned::new("same discrete problem", title, move || compare(name, order, code, live))
        })
    };
    problems().into_iter().flat_map(of_both).collect()
}

/// A discrete problem in another code: what is judged of it.
pub type Numbers = Vec<Judged>;

impl Study for Numbers {
    const NAME: &'static str = "cross_code";
    const ABOUT: About = About {
        title: "Against other codes: the same problem assembled twice",
        asked: "Whether other codes, given the same mesh, find the same numbers.",
        limits: "Errors of the mesh, of the supports and of the contact rows are common to all; independent codes \
            share none of them.",
    };

    /// All trials, against frozen answers.
    fn plan() -> Vec<Planned<Self>> {
        against(None)
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(self.clone())
    }

    /// The versions that the frozen answers came from, and who assembles what.
    fn section(_: &[Found<Self>]) -> Result<String, Error> {
        let mut text = String::new();
        for code in Code::TWINS {
            text += &frozen(code, &Frozen::read(code)?);
        }
        Ok(format!(
            "{text}\nTo ask the codes themselves, {SET_UP} and `cargo test --release --workspace`.\n\n\
             Each code takes our mesh and assembles stiffness, loads and edge functions for itself; supports and \
             penalty line elements (two Gauss points an edge) are put together from these in Python, condensed \
             nowhere.\n\n"
        ))
    }
}

/// A scene and order in another code: whether it finds what was frozen where it is asked now, and the same as we.
fn compare(name: &str, order: Order, code: Code, live: Option<Live>) -> Result<Numbers, Error> {
    let twin = Twin::of(name, order)?;
    let (frozen, kept) = frozen_answer(code, &twin)?;
    let Some(live) = live else { return Ok(differences(code, &twin.digest(), &kept)) };
    let answer = (live.discrete)(code, &twin.problem)?;
    let digest = twin.digest_of_other(&answer);
    let changed = changed_versions(&frozen.versions, &(live.versions)()?);
    let mut judged = vec![reproduced(code.name(), &digest.numbers(), &kept.numbers(), &changed)];
    judged.extend(differences(code, &twin.digest(), &digest));
    judged.extend(twin.in_full(code, &answer));
    Ok(judged)
}

/// Ours against another code's, by their digests.
pub fn differences(code: Code, ours: &Digest, theirs: &Digest) -> Vec<Judged> {
    let forms = relative_difference(&ours.forms.concat(), &theirs.forms.concat());
    let work = relative_difference(&ours.work, &theirs.work);
    let mut all =
        vec![alike(code, STIFFNESS, "vᵢᵀ K vⱼ, ten vectors", forms), alike(code, LOADS, "vᵢ · f, ten vectors", work)];
    for (index, kappa) in KAPPA.iter().enumerate() {
        let of = |list: &Vec<Vec<f64>>| list.get(index).cloned().unwrap_or_default();
        let pressure = relative_difference(&of(&ours.pressure), &of(&theirs.pressure));
        let moved = relative_difference(&of(&ours.moved), &of(&theirs.moved));
        all.push(alike(code, CONTACT, format!("p at the Gauss points, κ = {kappa:e}"), pressure));
        all.push(alike(code, CONTACT, format!("vᵢ · u, κ = {kappa:e}"), moved));
    }
    all
}

/// A code's frozen answers, and of them that to our discrete problem; refused where it is of another mesh.
fn frozen_answer(code: Code, twin: &Twin) -> Result<(Frozen, Digest), Error> {
    let name = &twin.problem.name;
    let frozen = Frozen::read(code)?;
    let absent = || Error::missing_key(&file(code), name, "the frozen results", REFREEZE);
    let kept = frozen.discrete.get(name).cloned().ok_or_else(absent)?;
    let nodes = twin.problem.points.len();
    if kept.nodes != nodes {
        let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
        return Err(Error::refused(&file(code), name, found, REFREEZE));
    }
    Ok((frozen, kept))
}

/// Scenes and elements per half-width, or per 10 mm of arc.
const SCENES: [(&str, usize); 3] = [("cylinder", 8), ("truncated-hertz", 8), ("pin-rod", 6)];
/// A fixed vector for the stiffness to be multiplied with, from the square root of each.
const PRIMES: [f64; 10] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0];

/// Scenes and orders.
pub fn problems() -> Vec<(&'static str, Order)> {
    SCENES.iter().flat_map(|(name, _)| [Order::Linear, Order::Quadratic].map(|order| (*name, order))).collect()
}

/// Our discrete problem, our answer, and the way between node-by-node vectors and our numbering.
pub struct Twin {
    /// What the other code is given.
    pub problem: DiscreteProblem,
    /// What we answer; products and load in our own numbering.
    pub ours: DiscreteAnswer,
    /// The fixed vectors in our own numbering.
    pub unknowns: Vec<Vec<f64>>,
    discretisation: Discretisation,
}

impl Twin {
    /// A scene of the library on a mesh of an order, solved by us.
    pub fn of(name: &str, order: Order) -> Result<Self, Error> {
        let problem = library::find(name, None)?;
        let Some((_, elements)) = SCENES.into_iter().find(|(known, _)| *known == name) else {
            return Err(not_handed_over(name, "this scene"));
        };
        let resolution = Resolution { elements, refinement: 0, order };
        Self::on(Discretisation::of(problem.scene, resolution)?)
    }

    /// The same from a discretisation at hand.
    pub fn on(discretisation: Discretisation) -> Result<Self, Error> {
        let bodies = &discretisation.system.bodies;
        let vectors: Vec<Vec<Vec<f64>>> =
            PRIMES.iter().map(|p| bodies.iter().map(|body| fixed_vector(*p, &body.dofs)).collect()).collect();
        let on_nodes = |v: &Vec<Vec<f64>>| discretisation.system.nodal_displacements(1.0, v).as_flattened().to_vec();
        let problem = handed_over(&discretisation, vectors.iter().map(on_nodes).collect())?;
        let product = |v: &Vec<Vec<f64>>| bodies.iter().zip(v).flat_map(|(body, x)| body.product(x)).collect();
        let mut ours = DiscreteAnswer {
            products: vectors.iter().map(product).collect(),
            load: bodies.iter().flat_map(|body| body.force.clone()).collect(),
            pressure: Vec::new(),
            displacement: Vec::new(),
        };
        for kappa in KAPPA {
            let solution = discretisation.solve(&penalty(kappa, discretisation.mesh.order))?;
            let converged = solution.converged();
            ours.pressure.push(solution.points.iter().map(|p| if converged { p.pressure } else { f64::NAN }).collect());
            ours.displacement.push(discretisation.recover(&solution)?.displacement.as_flattened().to_vec());
        }
        let unknowns = vectors.into_iter().map(|v| v.concat()).collect();
        Ok(Self { problem, ours, unknowns, discretisation })
    }

    /// Our answer, digested.
    pub fn digest(&self) -> Digest {
        Digest::of(&self.ours, &self.unknowns, &self.problem.vectors)
    }

    /// Another code's answer, digested.
    pub fn digest_of_other(&self, answer: &DiscreteAnswer) -> Digest {
        Digest::of(answer, &self.problem.vectors, &self.problem.vectors)
    }

    /// Every component of products, load and displacements of a code, not only their digest.
    fn in_full(&self, code: Code, answer: &DiscreteAnswer) -> [Judged; 3] {
        let reduced: Vec<Vec<f64>> = answer.products.iter().map(|product| self.along_unknowns(product)).collect();
        let load = relative_difference(&self.ours.load, &self.along_unknowns(&answer.load));
        let moved = worst_difference(&self.ours.displacement, &answer.displacement);
        let product = worst_difference(&self.ours.products, &reduced);
        [
            alike(code, STIFFNESS, "K v in every component, ten vectors", product),
            alike(code, LOADS, "f in every component", load),
            alike(code, CONTACT, "u in every component, κ = 1e2 and 1e4", moved),
        ]
    }

    /// `Tᵀ f` of nodal forces: their components along our unknowns.
    pub fn along_unknowns(&self, force: &[f64]) -> Vec<f64> {
        let (system, mesh) = (&self.discretisation.system, &self.discretisation.mesh);
        let of_body = |(body, part): (&BodySystem, &BodyMesh)| {
            let mut out = vec![0.0; body.force.len()];
            for node in part.nodes.clone() {
                body.dofs.add_force(node, [force[2 * node], force[2 * node + 1]], &mut out);
            }
            out
        };
        system.bodies.iter().zip(&mesh.bodies).flat_map(of_body).collect()
    }
}

/// Line elements with two Gauss points an edge, and springs that stay as they are.
fn penalty(kappa: f64, order: Order) -> Formulation {
    let quadrature = match order {
        Order::Linear => Quadrature::GaussFull,
        _ => Quadrature::Gauss,
    };
    let rule = StiffnessRule::Penalty;
    let base = Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-10);
    Formulation { rule, stiffness: kappa, quadrature, ..base }
}

/// Weyl's sequence `2 {i √p} − 1`: equally distributed between −1 and 1, independent for different primes, the same on
/// every machine.
fn fixed_vector(prime: f64, dofs: &Dofs) -> Vec<f64> {
    let mut vector = vec![f64::NAN; dofs.equations];
    for (i, equation) in dofs.in_mesh_order().into_iter().enumerate() {
        vector[equation] = 2.0 * ((i + 1) as f64 * prime.sqrt()).fract() - 1.0;
    }
    vector
}

/// What both codes make of the same mesh, how far they may be apart, and why: assembly differs by the order of sums,
/// and two direct solvers work on a system of condition 1e6 and more.
type Part = (&'static str, f64, &'static str);
const STIFFNESS: Part = ("difference of the stiffness on the same mesh", 1e-11, "the order of sums only");
const LOADS: Part = ("difference of the loads on the same mesh", 1e-11, "the order of sums only");
const CONTACT: Part = (
    "difference of the contact by penalty line elements on the same mesh",
    1e-8,
    "two direct solvers, condensed and not",
);

/// Another code assembles, or finds, the same on our mesh: a relative difference by some numbers.
fn alike(code: Code, (name, tolerance, because): Part, by: impl Into<String>, difference: f64) -> Judged {
    let theirs = Reference { name: code.name().into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    Check::error(Quantity::at(name, by), theirs, tolerance, because).judge(difference)
}

fn frozen(code: Code, frozen: &Frozen) -> String {
    let versions: Vec<String> = frozen.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let hash: String = frozen.scripts.chars().take(12).collect();
    let code = code.name();
    format!("* {code}: frozen results under `oracles/frozen`, from {}; scripts {hash}….\n", versions.join(", "))
}

/// Stiffness of the springs.
const KAPPA: [f64; 2] = [1e2, 1e4];

/// Our discretisation as plain numbers, and displacements, node by node, to multiply the stiffness with.
fn handed_over(discretisation: &Discretisation, vectors: Vec<Vec<f64>>) -> Result<DiscreteProblem, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let contact = scene.contact();
    let side = |body: usize| candidates::candidate_edges(mesh, scene, contact, body);
    let (profile, radius, clearance) = profile(scene)?;
    let mut problem = DiscreteProblem {
        name: format!("{}, {}-node", scene.name, mesh.order.nodes_per_cell()),
        plane: scene.plane.name(),
        thickness: scene.thickness,
        points: mesh.points.clone(),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        body: mesh.bodies.iter().enumerate().flat_map(|(b, part)| part.cells.clone().map(move |_| b)).collect(),
        young: scene.bodies.iter().map(|body| body.material.young).collect(),
        poisson: scene.bodies.iter().map(|body| body.material.poisson).collect(),
        contact_first: side(contact.first)?,
        contact_second: contact.second.map_or(Ok(Vec::new()), side)?,
        profile,
        radius,
        clearance,
        arc: matches!(contact.path, Path::Arc(_)),
        length: scene.reference.length,
        kappa: KAPPA.into(),
        vectors,
        ..Default::default()
    };
    for index in 0..scene.bodies.len() {
        supports_and_loads(discretisation, index, &mut problem)?;
    }
    Ok(problem)
}

/// Name, radius and clearance of the gap.
fn profile(scene: &Scene) -> Result<(&'static str, f64, f64), Error> {
    match scene.contact().profile {
        _ if scene.contact().clearance > 0.0 => Err(not_handed_over(&scene.name, "a clearance beside a profile")),
        Profile::Circle { radius } => Ok(("circle", radius, 0.0)),
        Profile::Parabola { radius } => Ok(("parabola", radius, 0.0)),
        Profile::Hole { radius, clearance } => Ok(("hole", radius, clearance)),
        Profile::Uniform(_) | Profile::Punch { .. } => Err(not_handed_over(&scene.name, "a uniform gap")),
        _ => Err(not_handed_over(&scene.name, "this rigid profile")),
    }
}

/// Adds the fixed components and the loads of a body.
fn supports_and_loads(
    discretisation: &Discretisation,
    index: usize,
    problem: &mut DiscreteProblem,
) -> Result<(), Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    for support in &scene.bodies[index].supports {
        let nodes = mesh.nodes_at(scene, index, &support.at)?;
        problem.held.extend(nodes.into_iter().map(|node| [node, support.component.index()]));
    }
    for load in &scene.bodies[index].loads {
        match load {
            Load::OnSide { boundary, part: None, action: Action::Uniform(traction) } => {
                problem.load_edges.extend_from_slice(mesh.boundary(scene, index, boundary)?);
                problem.traction = *traction;
            }
            Load::OnSide { boundary, part: None, action: Action::Stress(_) } => {
                problem.load_edges.extend_from_slice(mesh.boundary(scene, index, boundary)?);
                problem.hertz_load = true;
            }
            Load::RigidFace { boundary, force, .. } => {
                problem.tied = mesh.boundary(scene, index, boundary)?.iter().flatten().copied().collect();
                problem.tied.sort_unstable();
                problem.tied.dedup();
                problem.tied_force = *force;
            }
            Load::OnSide { .. } | Load::BodyForce(_) | Load::Force { .. } => {
                return Err(not_handed_over(&scene.name, "such a load"));
            }
        }
    }
    Ok(())
}

/// The refusal of what another code is not taught to take.
fn not_handed_over(scene: &str, what: &str) -> Error {
    let remedy = "choose another scene, or teach oracles/python/discrete.py to take it";
    Error::at(scene, format!("{what} is not handed over to other codes"), remedy)
}
