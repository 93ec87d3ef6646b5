"""An exported case by scikit-fem: run_scikit_fem.py FOLDER penalty|active-set; writes scikit-fem-METHOD.csv there.

scikit-fem assembles the stiffness on the exported mesh (Q1, or Q2 with a node in the middle of the 8-node cells); it has no contact of its
own: springs, or active sets with Lagrange multipliers, act on the exported rows. Solved by SuperLU.
"""

import time

import exported  # first: one thread

import numpy as np
from scipy.sparse.linalg import splu

try:
    import skfem
    from skfem.helpers import ddot, sym_grad
except ModuleNotFoundError:
    exported.missing("scikit-fem", "python3 -m pip install scikit-fem")


def stiffness(points, cells, young, poisson, plane):
    """Matrix of one body per unit of thickness, dofs 2 node + component."""
    corners, compact = np.unique(cells[:, :4], return_inverse=True)
    flat = skfem.MeshQuad(points[corners].T, compact.reshape(-1, 4).T)
    element, mesh, quadratic = skfem.ElementQuad1(), flat, cells.shape[1] == 9
    if quadratic:
        element, mesh = skfem.ElementQuad2(), skfem.MeshQuad2.from_mesh(flat)
        middle = {frozenset((cell[k], cell[(k + 1) % 4])): cell[4 + k] for cell in cells for k in range(4)}
        facets = np.array([middle[frozenset(pair)] for pair in corners[flat.facets].T.tolist()])
        order = np.concatenate([corners, facets, cells[:, 8]])
        mesh = skfem.MeshQuad2(points[order].T, mesh.t)
    basis = skfem.Basis(mesh, skfem.ElementVector(element), intorder=4 if quadratic else 2)
    shear, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    if plane == "stress":
        lame = 2 * shear * lame / (lame + 2 * shear)

    @skfem.BilinearForm
    def energy(u, v, _):
        strain, virtual = sym_grad(u), sym_grad(v)
        return 2 * shear * ddot(strain, virtual) + lame * (strain[0, 0] + strain[1, 1]) * (virtual[0, 0] + virtual[1, 1])

    dof = np.full(basis.N, -1)
    for component in range(2):
        dof[basis.nodal_dofs[component]] = 2 * corners + component
        if quadratic:
            dof[basis.facet_dofs[component]] = 2 * facets + component
            dof[basis.interior_dofs[component]] = 2 * cells[:, 8] + component
    matrix = energy.assemble(basis).tocoo()
    matrix.row, matrix.col = dof[matrix.row], dof[matrix.col]
    return matrix


def main(folder, method):
    """Solves, and writes the answer."""
    problem = exported.Problem(folder)
    begin = time.perf_counter()
    matrix = problem.stiffness(stiffness)
    pressure, gap, steps = exported.solve(problem, matrix, method, lambda a, b: splu(a.tocsc()).solve(b))
    seconds = time.perf_counter() - begin
    file = f"scikit-fem-{method}.csv"
    exported.write_csv(problem, file, pressure, gap)
    exported.report(code="scikit-fem", version=skfem.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["penalty", "active-set"], "scikit-fem 12.0.2")
