"""The block as a discrete problem, solved with the stiffness, edge functions and linear solver of one code.

Own meshes, own loads, own contact; the code under test is a module with
    stiffness(mesh, plane_matrix)  dofs 2 node + component of the mesh's own numbering, thickness 1
    edge_functions(xi)             (N, dN/dxi), each (n, 3): first, last, middle
    linear_solution(matrix, load)  one load, or one a column
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

import numpy as np
from scipy.sparse import identity

from closing import multipliers, penalty
from contact import contact_points

# k_n = KAPPA E*/l: costs 0.3/KAPPA of p0; Newton starts to cycle three decades higher.
KAPPA = 1e4


def closed(model, method, start, code):
    """Contact points, their pressures, the number of free dofs, and the steps of the iteration."""
    full = code.stiffness(model.mesh, model.plane_matrix)
    points = contact_points(model.mesh, model.gap, model.stretch, code.edge_functions)
    kept = np.ones(full.shape[0], bool)
    kept[model.fixed] = False
    free = identity(len(kept), format="csr")[:, kept]
    load = sum(traction_load(model.mesh, *traction, code.edge_functions) for traction in model.tractions)
    points.rows = (points.rows @ free).tocsr()
    reduced = [(free.T @ full @ free).tocsr(), free.T @ load]
    if method == "penalty":
        spring = KAPPA * model.contact_modulus / model.length
        pressure, steps = penalty(*reduced, points, spring, start, code.linear_solution)
    else:
        pressure, steps = multipliers(*reduced, points, start, code.linear_solution)
    return points, pressure, free.shape[1], steps


def traction_load(mesh, name, traction, functions):
    """Nodal forces per thickness of a traction, a function of points, on a boundary; 16 Gauss points each."""
    load = np.zeros(2 * len(mesh.points))
    edges = mesh.boundary[name]
    for xi, weight in zip(*np.polynomial.legendre.leggauss(16)):
        shape, slope = functions(np.array([xi]))
        x, dx = (np.einsum("a,eai->ei", f[0], mesh.points[edges]) for f in (shape, slope))
        force = traction(x) * (weight * np.linalg.norm(dx, axis=1))[:, None]
        for component in range(2):
            np.add.at(load, 2 * edges + component, shape[0] * force[:, component, None])
    return load


def contact_edge(points, pressure):
    """Middle between the last closed point and the first open one after it."""
    last = np.flatnonzero(pressure > 0.0)[-1]
    after = min(last + 1, len(pressure) - 1)
    return 0.5 * (points.position[last] + points.position[after]) + 1e-12
