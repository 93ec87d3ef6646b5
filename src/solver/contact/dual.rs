//! From the candidates of both bodies to an interface, whose nodes are given what they face: where the meshes do not
//! match, the mean of the primary displacement, weighted by the node's dual shape function.

use nalgebra::DMatrix;

use crate::condensation::Condensed;
use crate::contact::Interface;
use crate::contact::primary::PrimarySurface;
use crate::elasticity::quadrature;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// Fewest Gauss points on each piece of an edge: products of two shape functions of 3-node edges are polynomials of
/// degree four.
const FEWEST: usize = 4;

impl Interface {
    /// The interface of every contact of a scene.
    pub fn all(scene: &Scene, mesh: &Mesh, condensed: &Condensed) -> Result<Vec<Self>, Error> {
        (0..scene.contacts.len()).map(|contact| Self::between(scene, mesh, condensed, contact)).collect()
    }

    /// Projects the candidates of the first body of a contact on to the second; their nodes need not match.
    pub fn between(scene: &Scene, mesh: &Mesh, condensed: &Condensed, contact: usize) -> Result<Self, Error> {
        let mut interface = Self::projected(scene, mesh, condensed, contact)?;
        if let Some(primary) = &interface.primary {
            let rows = rows(&interface, primary);
            interface.nodes.iter_mut().zip(rows).for_each(|(node, row)| node.opposite = row);
        }
        Ok(interface)
    }
}

/// For each node the primary dofs with `(1/D_a) ∫ φ_a N_b ds`, `D_a = ∫ N_a ds`.
///
/// The dual shape functions `φ = D M⁻¹ N`, `M_ac = ∫ N_a N_c ds` edge by edge, satisfy `∫ φ_a N_c ds = δ_ac D_a` and
/// `Σ φ_a = 1` (Wohlmuth 2000); lengths of bodies of revolution are times `2πr`, and a node on the axis that has none
/// meets what is there. Where every node faces a node this is that node alone; elsewhere equal pressures at the
/// nodes are a uniform pressure on both sides, and the patch test holds.
fn rows(interface: &Interface, primary: &PrimarySurface) -> Vec<Vec<(usize, f64)>> {
    let nodes = interface.nodes.len();
    if let Some(pairs) = pairs(interface, primary) {
        return pairs;
    }
    let mut rows = vec![Vec::new(); nodes];
    let mut areas = vec![0.0; nodes];
    for edge in &interface.edges {
        let n = edge.len();
        let points = interface.on_pieces(edge, &quadrature::gauss(n.max(FEWEST)));
        let at = points.iter().map(|&(xi, weight)| {
            let (shapes, position, length) = interface.at(edge, xi);
            ((shapes, position, length * interface.circumference(position)), weight)
        });
        let at: Vec<_> = at.collect();
        let mut mass = DMatrix::<f64>::zeros(n, n);
        for ((shapes, _, length), weight) in &at {
            for (a, c) in (0..n).flat_map(|a| (0..n).map(move |c| (a, c))) {
                mass[(a, c)] += shapes[a] * shapes[c] * length * weight;
            }
        }
        let own: Vec<f64> = (0..n).map(|a| mass.row(a).sum()).collect();
        let Some(inverse) = mass.try_inverse() else { continue };
        for ((shapes, position, length), weight) in &at {
            for (k, &node) in edge.iter().enumerate() {
                let dual = own[k] * (0..n).map(|c| inverse[(k, c)] * shapes[c]).sum::<f64>();
                let nodes = primary.at(*position).into_iter().flatten();
                rows[node].extend(nodes.map(|(node, value)| (node.dof, dual * value * length * weight)));
            }
        }
        edge.iter().zip(own).for_each(|(&node, area)| areas[node] += area);
    }
    let each = rows.into_iter().zip(areas).zip(&interface.nodes);
    each.map(|((row, area), node)| {
        if interface.has_no_area(node) {
            let nodes = primary.at(node.coordinate).into_iter().flatten();
            return nodes.map(|(node, value)| (node.dof, value)).collect();
        }
        let mean = super::interface::summed(row).into_iter().map(|(dof, value)| (dof, value / area));
        mean.collect()
    })
    .collect()
}

/// The primary node that every contact node meets, where the nodes of both sides are the same.
fn pairs(interface: &Interface, primary: &PrimarySurface) -> Option<Vec<Vec<(usize, f64)>>> {
    let whole = |edge: &Vec<usize>| interface.on_pieces(edge, &[(0.0, 2.0)]).len() == 1;
    let alone = |s: f64| match primary.at(s)?[..] {
        [(node, value)] => Some(vec![(node.dof, value)]),
        _ => None,
    };
    let pairs = interface.nodes.iter().map(|node| alone(node.coordinate));
    pairs.collect::<Option<Vec<_>>>().filter(|_| interface.edges.iter().all(whole))
}
