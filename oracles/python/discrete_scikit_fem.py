"""The same discrete problem in scikit-fem: its quadrilaterals, mappings and forms on the mesh it is given."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np
import scipy.sparse as sparse
from skfem import Basis, BilinearForm, Dofs, FacetBasis, LinearForm, MeshQuad, MeshQuad2
from skfem import ElementLineP1, ElementLineP2, ElementQuad1, ElementQuad2, ElementQuadS2, ElementVector
from skfem.helpers import ddot, eye, sym_grad, trace

import discrete
from closed_forms import lame


def solve(problem):
    """What `discrete.solve` returns, with stiffness, load and edge functions of scikit-fem."""
    cells = problem["cells"]
    quadratic = cells.shape[1] == 8
    mesh = _mesh(problem["points"], cells)
    element = ElementVector(ElementQuadS2() if quadratic else ElementQuad1())
    basis = Basis(mesh, element, quadrature=_square(3 if quadratic else 2))
    to_nodes = _numbering(basis, cells, problem["points"].size)
    stiffness = to_nodes.T @ _stiffness(problem, basis) @ to_nodes
    load = to_nodes.T @ _load(problem, mesh, element)
    line = ElementLineP2() if quadratic else ElementLineP1()
    return discrete.solve(problem, stiffness.tocsr(), load, _edge_functions(line))


def _mesh(points, cells):
    """The corners make a mesh of straight cells; mid-sides, and as centre the 8-node map's own, curve it."""
    corners = np.unique(cells[:, :4])
    straight = MeshQuad(points[corners].T, np.searchsorted(corners, cells[:, :4]).T)
    if cells.shape[1] == 4:
        return straight
    nodes = Dofs(straight, ElementQuad2()).element_dofs
    places = np.zeros((2, nodes.max() + 1))
    places[:, nodes[:8]] = points[cells].transpose(2, 1, 0)
    centres = 0.5 * points[cells[:, 4:]].sum(axis=1) - 0.25 * points[cells[:, :4]].sum(axis=1)
    places[:, nodes[8]] = centres.T
    return MeshQuad2(places, straight.t)


def _square(n):
    """Gauss rule with n x n points on the unit square."""
    x, w = discrete.GAUSS(n)
    x, w = (x + 1) / 2, w / 2
    return np.array([np.tile(x, n), np.repeat(x, n)]), np.outer(w, w).ravel()


def _numbering(basis, cells, size):
    """Matrix from node-by-node components to the freedoms of the basis."""
    rows = basis.element_dofs
    columns = np.stack([2 * cells.T, 2 * cells.T + 1], axis=1).reshape(rows.shape)
    rows, first = np.unique(rows, return_index=True)
    return sparse.csr_matrix((np.ones(rows.size), (rows, columns.ravel()[first])), shape=(rows.size, size))


def _stiffness(problem, basis):
    lam, mu = (c[problem["body"]][:, None] for c in lame(problem["young"], problem["poisson"], problem["plane"]))

    @BilinearForm
    def energy(u, v, w):
        strain = sym_grad(u)
        return ddot(w.lam * eye(trace(strain), 2) + 2 * w.mu * strain, sym_grad(v))

    points = basis.X.shape[1]
    fields = {"lam": np.repeat(lam, points, axis=1), "mu": np.repeat(mu, points, axis=1)}
    return problem["thickness"] * energy.assemble(basis, **fields)


def _load(problem, mesh, element):
    @LinearForm
    def work(v, w):
        t = discrete.traction(problem, np.moveaxis(w.x, 0, -1), np.moveaxis(w.n, 0, -1))
        return t[..., 0] * v[0] + t[..., 1] * v[1]

    edges = problem["load_edges"]
    if not edges.size:
        return np.zeros(Dofs(mesh, element).N)
    corners = np.unique(problem["cells"][:, :4])
    ends = np.sort(np.searchsorted(corners, edges[:, :2]), axis=1)
    known = {tuple(facet): index for index, facet in enumerate(np.sort(mesh.facets.T, axis=1))}
    facets = np.array([known[tuple(pair)] for pair in ends])
    x, w = discrete.GAUSS(16)
    basis = FacetBasis(mesh, element, facets=facets, quadrature=((x[None] + 1) / 2, w / 2))
    return problem["thickness"] * work.assemble(basis)


def _edge_functions(line):
    """Tabulated functions of the line element of the same order: first, last, middle; `xi` from -1 to 1."""

    def at(xi):
        local = [line.lbasis(np.array([[(xi + 1) / 2]]), i) for i in range(line.doflocs.shape[0])]
        return np.array([value[0] for value, _ in local]), np.array([slope[0, 0] / 2 for _, slope in local])

    return at
