//! Our discrete problem as it is handed to another code, with our own answer.

use crate::algorithm::StiffnessRule;
use crate::case::library;
use crate::contact::Quadrature;
use crate::elasticity::Dofs;
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::frozen::Digest;
use crate::oracle::cross_code::{DiscreteAnswer, DiscreteProblem};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::handed_over::{self, KAPPA, not_handed_over};

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
