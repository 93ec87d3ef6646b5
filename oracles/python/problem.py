"""A scene as a discrete problem, solved with the stiffness, edge functions and linear solver of one code.

Own meshes, own loads, own contact; the code under test is a module with
    stiffness(mesh, plane_matrix)  dofs 2 node + component of the mesh's own numbering, thickness 1
    edge_functions(xi)             (N, dN/dxi), each (n, 3): first, last, middle
    linear_solution(matrix, load)  one load, or one a column
"""

import numpy as np
from scipy.sparse import block_diag, csr_matrix

import hertz_scenes
import measures
import pin_scenes
from closing import multipliers, penalty
from contact import contact_points

# k_n = KAPPA E*/l: costs 0.3/KAPPA of p0; Newton starts to cycle three decades higher.
KAPPA = 1e4


CASES = {
    "cylinder": hertz_scenes.cylinder,
    "truncated-hertz": hertz_scenes.truncated_hertz,
    "pin-rod": pin_scenes.pin_rod,
    "pin-plate": pin_scenes.pin_plate,
}


def build(scene, level):
    """The model of a scene at a level."""
    if scene["case"] not in CASES:
        raise ValueError(f"case {scene['case']!r}: use one of {', '.join(CASES)}")
    return CASES[scene["case"]](scene, level)


def solve(scene, level, method, code):
    """Contact of a scene at a level, with mean pressures round scene["stations"] [mm, or rad on pins].

    Coarser levels are solved first, to start the iteration well placed.
    """
    if method not in ("penalty", "active-set"):
        raise ValueError(f"method {method!r}: use 'penalty' or 'active-set'")
    start = None
    for finer in range(level + 1):
        model = build(scene, finer)
        start = model.start if start is None else start
        points, pressure, dofs, steps = closed(model, method, start, code)
        start = contact_edge(points, pressure)
    if pressure[-1] > 0.0:
        raise RuntimeError(f"{scene['case']}: the contact reaches its last candidate; lengthen the stretch")
    width = measures.half_width(points, pressure)
    return {
        "half_width": float(width),
        "peak": float(measures.peak(points, pressure, width)),
        "resultant": float(measures.resultant(points, pressure)),
        "pressure": measures.profile(points, pressure, np.asarray(scene["stations"]), model.pair.metric()),
        "dofs": int(dofs),
    }


def closed(model, method, start, code):
    """Contact points, their pressures, the number of free dofs, and the steps of the iteration."""
    meshes = [body.mesh for body in model.bodies]
    thickness = model.pair.thickness
    each = [thickness * code.stiffness(body.mesh, body.plane_matrix) for body in model.bodies]
    full = block_diag(each, format="csr")
    points = contact_points(meshes, model.pair, code.edge_functions)
    free = free_motions(full.shape[0], model.fixed, model.tied)
    load = model.force.copy()
    for traction in model.tractions:
        load += thickness * traction_load(meshes[0], *traction, code.edge_functions)
    points.rows = (points.rows @ free).tocsr()
    reduced = [(free.T @ full @ free).tocsr(), free.T @ load]
    if method == "penalty":
        spring = KAPPA * model.contact_modulus / model.length
        pressure, steps = penalty(*reduced, points, spring, start, code.linear_solution)
    else:
        pressure, steps = multipliers(*reduced, points, start, code.linear_solution)
    return points, pressure, free.shape[1], steps


def free_motions(size, fixed, tied):
    """Matrix T of u = T q: fixed dofs have no column, tied ones share one."""
    kept = np.ones(size, bool)
    kept[fixed] = False
    column = np.cumsum(kept) - 1
    if len(tied):
        others = kept.copy()
        others[tied] = False
        column = np.cumsum(others) - 1
        column[tied] = others.sum()
    rows = np.flatnonzero(kept)
    return csr_matrix((np.ones(len(rows)), (rows, column[rows])), (size, column[rows].max() + 1))


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
