"""Stiffness and edge functions of scikit-fem, factorised by scipy."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementLineP2, ElementTriP2, ElementVector, MeshTri2

QUADRATURE = 6


def stiffness(mesh, plane_matrix):
    """Stiffness of a mesh of 6-node triangles, thickness 1 [N/mm]."""
    solid = MeshTri2(mesh.points.T, mesh.triangles.T)
    basis = Basis(solid, ElementVector(ElementTriP2()), intorder=QUADRATURE)

    @BilinearForm
    def energy(u, v, _):
        return np.einsum("i...,ij,j...->...", strain(v), plane_matrix, strain(u))

    matrix = energy.assemble(basis).tocoo()
    # scikit-fem numbers anew; element by element both numberings name the same nodes
    own = np.empty(basis.N, int)
    own[basis.element_dofs.T] = (2 * mesh.triangles[:, :, None] + np.arange(2)).reshape(-1, 12)
    return coo_matrix((matrix.data, (own[matrix.row], own[matrix.col])), matrix.shape).tocsr()


def strain(u):
    """(eps_x, eps_y, gamma)."""
    return np.stack([u.grad[0, 0], u.grad[1, 1], u.grad[0, 1] + u.grad[1, 0]])


def edge_functions(xi):
    """Functions and slopes of the 3-node edge at xi in -1..1."""
    values = [ElementLineP2().lbasis(0.5 * (xi[None, :] + 1.0), i) for i in range(3)]
    shape = np.column_stack([value for value, _ in values])
    return shape, 0.5 * np.column_stack([slope[0] for _, slope in values])


def linear_solution(matrix, load):
    """Direct solution; the matrices are symmetric and positive definite, so pivots stay on the diagonal."""
    symmetric = {"permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    return splu(matrix.tocsc(), **symmetric).solve(load)
