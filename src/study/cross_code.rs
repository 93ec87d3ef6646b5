//! The solver against other finite element codes on the same discrete problem: our mesh, loads, supports and line elements, assembled and
//! solved by another code; agreement to round-off, a code check.

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference, library};
use crate::contact::Quadrature;
use crate::elasticity::Dofs;
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, file};
use crate::oracle::cross_code::{Code, DiscreteAnswer, DiscreteProblem, SET_UP};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::answers::{Answers, reproduced};
use crate::study::differences::{relative_difference, worst_difference};
use crate::study::handed_over::{self, KAPPA, not_handed_over};

/// All trials, against answers that are frozen, or of the codes themselves.
pub fn against(answers: Answers) -> Vec<Planned<Numbers>> {
    let of_both = |(name, order): (&'static str, Order)| {
        Code::ALL.map(|code| {
            let title = format!("{name}, {}-node, {code}{}", order.nodes_per_cell(), answers.suffix());
            Planned::new("same discrete problem", title, move || compare(name, order, code, answers))
        })
    };
    problems().into_iter().flat_map(of_both).collect()
}

/// A discrete problem in another code.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// The code.
    pub code: Code,
    /// Whether it finds what was frozen; none where it was not asked.
    pub reproduced: Option<Judged>,
    /// Ours against its answer.
    pub differences: Vec<Difference>,
}

impl Study for Numbers {
    const NAME: &'static str = "cross_code";
    const ABOUT: About = About {
        title: "Against other codes: the same problem assembled twice",
        asked: "Whether other codes, given the same mesh, find the same numbers.",
        limits: "Errors of the mesh, of the supports and of the contact rows are common to all; independent codes share none of them.",
    };

    /// All trials, against frozen answers.
    fn plan() -> Vec<Planned<Self>> {
        against(Answers::Frozen)
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(self
            .reproduced
            .iter()
            .cloned()
            .chain(self.differences.iter().map(|one| assembled_alike(self.code, one)))
            .collect())
    }

    /// The versions that the frozen answers came from, and who assembles what.
    fn section(_: &[Found<Self>]) -> Result<String, Error> {
        let mut text = String::new();
        for code in Code::ALL {
            text += &frozen(code, &Frozen::read(code)?);
        }
        Ok(format!(
            "{text}\nTo ask the codes themselves, {SET_UP} and `cargo test --release --workspace`.\n\n\
             Each code takes our mesh and assembles stiffness, loads and edge functions for itself; supports and penalty line elements \
             (two Gauss points an edge) are put together from these in Python, condensed nowhere.\n\n"
        ))
    }
}

/// A relative difference from another code.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Of what.
    pub part: Part,
    /// By which numbers.
    pub by: String,
    /// The difference, over the largest of them.
    pub error: f64,
}

/// What both codes make of the same mesh.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    /// The stiffness.
    Stiffness,
    /// The loads.
    Loads,
    /// The contact by penalty line elements.
    Contact,
}

impl Difference {
    fn new(part: Part, by: impl Into<String>, error: f64) -> Self {
        Self { part, by: by.into(), error }
    }
}

/// A scene and order in another code.
fn compare(name: &str, order: Order, code: Code, answers: Answers) -> Result<Numbers, Error> {
    let twin = Twin::of(name, order)?;
    let (digest, live) = answered(answers, code, &twin)?;
    let mut differences = differences(&twin.digest(), &digest);
    differences.extend(live.iter().flat_map(|(answer, _)| twin.in_full(answer)));
    Ok(Numbers { code, reproduced: live.map(|(_, reproduced)| reproduced), differences })
}

/// Ours against another code's, by their digests.
pub fn differences(ours: &Digest, theirs: &Digest) -> Vec<Difference> {
    let forms = relative_difference(&ours.forms.concat(), &theirs.forms.concat());
    let mut all = vec![
        Difference::new(Part::Stiffness, "vᵢᵀ K vⱼ, ten vectors", forms),
        Difference::new(Part::Loads, "vᵢ · f, ten vectors", relative_difference(&ours.work, &theirs.work)),
    ];
    for (index, kappa) in KAPPA.iter().enumerate() {
        let of = |list: &Vec<Vec<f64>>| list.get(index).cloned().unwrap_or_default();
        let pressure = relative_difference(&of(&ours.pressure), &of(&theirs.pressure));
        let moved = relative_difference(&of(&ours.moved), &of(&theirs.moved));
        all.push(Difference::new(Part::Contact, format!("p at the Gauss points, κ = {kappa:e}"), pressure));
        all.push(Difference::new(Part::Contact, format!("vᵢ · u, κ = {kappa:e}"), moved));
    }
    all
}

impl Twin {
    /// Every component of products, load and displacements, not only their digest.
    pub fn in_full(&self, answer: &DiscreteAnswer) -> [Difference; 3] {
        let reduced: Vec<Vec<f64>> = answer.products.iter().map(|product| self.along_unknowns(product)).collect();
        let product = worst_difference(&self.ours.products, &reduced);
        let load = relative_difference(&self.ours.load, &self.along_unknowns(&answer.load));
        let moved = worst_difference(&self.ours.displacement, &answer.displacement);
        [
            Difference::new(Part::Stiffness, "K v in every component, ten vectors", product),
            Difference::new(Part::Loads, "f in every component", load),
            Difference::new(Part::Contact, "u in every component, κ = 1e2 and 1e4", moved),
        ]
    }
}

/// A code's answer to our discrete problem: in short, in full where it was asked, and whether that is what was frozen.
type Answered = (Digest, Option<(DiscreteAnswer, Judged)>);

fn answered(answers: Answers, code: Code, twin: &Twin) -> Result<Answered, Error> {
    let name = &twin.problem.name;
    let frozen = Frozen::read(code)?;
    let absent = || Error::missing_key(&file(code), name, "the frozen results", REFREEZE);
    let kept = frozen.discrete.get(name).cloned().ok_or_else(absent)?;
    let nodes = twin.problem.points.len();
    if kept.nodes != nodes {
        let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
        return Err(Error::refused(&file(code), name, found, REFREEZE));
    }
    match answers {
        Answers::Frozen => Ok((kept, None)),
        Answers::Live(live) => {
            let answer = (live.discrete)(code, &twin.problem)?;
            let digest = twin.digest_of_other(&answer);
            let changed = frozen.changed_versions(&(live.versions)()?);
            let reproduced = reproduced(code.name(), &digest.numbers(), &kept.numbers(), &changed);
            Ok((digest, Some((answer, reproduced))))
        }
    }
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
        let on_nodes = |v: &Vec<Vec<f64>>| discretisation.system.nodal_displacements(v).as_flattened().to_vec();
        let problem = handed_over::problem(&discretisation, vectors.iter().map(on_nodes).collect())?;
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

    /// `Tᵀ f` of nodal forces: their components along our unknowns.
    pub fn along_unknowns(&self, force: &[f64]) -> Vec<f64> {
        let (system, mesh) = (&self.discretisation.system, &self.discretisation.mesh);
        let of_body = |(body, part): (_, &crate::mesh::BodyMesh)| {
            let body: &crate::elasticity::BodySystem = body;
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

/// Assembly differs by the order of sums only.
const ASSEMBLED: f64 = 1e-11;
/// Two direct solvers on a system of condition 1e6 and more.
const SOLVED: f64 = 1e-8;

/// Another code assembles, and finds, the same on our mesh.
pub fn assembled_alike(code: Code, difference: &Difference) -> Judged {
    let (name, tolerance, because) = match difference.part {
        Part::Stiffness => ("difference of the stiffness on the same mesh", ASSEMBLED, "the order of sums only"),
        Part::Loads => ("difference of the loads on the same mesh", ASSEMBLED, "the order of sums only"),
        Part::Contact => (
            "difference of the contact by penalty line elements on the same mesh",
            SOLVED,
            "two direct solvers, condensed and not",
        ),
    };
    let quantity = Quantity::at(name, difference.by.clone());
    let theirs = Reference { name: code.name().into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    Check::error(quantity, theirs, tolerance, because).judge(difference.error)
}

fn frozen(code: Code, frozen: &Frozen) -> String {
    let versions: Vec<String> = frozen.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let hash: String = frozen.scripts.chars().take(12).collect();
    format!("* {code}: frozen results under `oracles/frozen`, from {}; scripts {hash}….\n", versions.join(", "))
}
