"""The same discrete problem: what is common to the codes once they have assembled stiffness and load.

A problem is a dict of numpy arrays, lengths in mm, forces in N, moduli and tractions in MPa:
`points` (n, 2); `cells` (m, 4 or 8), corners counter-clockwise, then mid-sides; `body` (m,), the body of each
cell; `young`, `poisson` of each body; `plane`; `thickness`; `held` (k, 2), node and component at rest;
`tied` (k,), nodes whose vertical displacement is common, under `tied_force`;
`load_edges` (k, 2 or 3), the body to their left, under `traction` (2,) or, if `hertz_load`, under the stresses
of Hertz's half-space; `contact_first`, `contact_second` (k, 2 or 3), facing candidate edges (first node, last
node, middle; no second: rigid); `profile`, `radius`, `clearance` of the gap; `arc`: contact is radial about the
origin, not vertical; `length` and `kappa`: springs `k_n = kappa E*/length`; `vectors` (10, 2n) to multiply.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

import closed_forms

GAUSS = np.polynomial.legendre.leggauss
STEPS = 100
GAPS = {
    "circle": lambda s, problem: closed_forms.circle_gap(s, problem["radius"]),
    "parabola": lambda s, problem: closed_forms.parabola_gap(s, problem["radius"]),
    "hole": lambda s, problem: closed_forms.hole_gap(s, problem["radius"], problem["clearance"]),
}


def traction(problem, points, normals):
    """Traction [MPa] at points (..., 2) with outward unit normals: the given one, or Hertz's `sigma n`."""
    if not problem["hertz_load"]:
        return np.broadcast_to(problem["traction"], points.shape)
    x, y, xy = closed_forms.hertz_stress(points[..., 0], points[..., 1], *hertz(problem))
    n = normals
    return np.stack([x * n[..., 0] + xy * n[..., 1], xy * n[..., 0] + y * n[..., 1]], axis=-1)


def hertz(problem):
    """Half-width [mm] and peak pressure [MPa] of the Hertz contact whose stresses are the load."""
    half_width = problem["length"]
    load = closed_forms.hertz_load(half_width, _modulus(problem), problem["radius"])
    return half_width, 2 * load / (np.pi * half_width)


def _modulus(problem):
    return closed_forms.contact_modulus(
        closed_forms.plane_modulus(young, poisson, problem["plane"])
        for young, poisson in zip(problem["young"], problem["poisson"])
    )


def line_element(problem, edge_functions):
    """Rows `B` (w = B u), areas and gaps of the line element with two Gauss points an edge.

    `w = sum N_a (u_n^A + u_n^B)_a`, `A = |ds/dxi| w t`, both with the edge functions `xi -> (N, dN/dxi)` of the code.
    """
    coordinate, metric = _coordinates(problem)
    rows, areas, places = [], [], []
    second = problem["contact_second"]
    sides = [_ordered(edges, coordinate) for edges in (problem["contact_first"], second) if edges.size]
    for edges in zip(*sides):
        for xi, weight in zip(*GAUSS(2)):
            values, slopes = edge_functions(xi)
            s = coordinate[edges[0]]
            row = np.zeros(problem["points"].size)
            for edge, sign in zip(edges, (1, -1)):
                for node, value in zip(edge, values):
                    row[2 * node : 2 * node + 2] += sign * value * _outward(problem, node)
            rows.append(sparse.csr_matrix(row))
            areas.append(abs(slopes @ s) * metric * weight * problem["thickness"])
            places.append(values @ s)
    places = np.array(places)
    gaps = GAPS[problem["profile"]](places, problem)
    return sparse.vstack(rows).tocsr(), np.array(areas), gaps


def _coordinates(problem):
    x, y = problem["points"].T
    if problem["arc"]:
        return np.arctan2(np.abs(x), -y), problem["radius"]
    return np.abs(x), 1.0


def _ordered(edges, coordinate):
    def turned(edge):
        forwards = coordinate[edge[0]] < coordinate[edge[1]]
        return edge if forwards else edge[[1, 0, *range(2, len(edge))]]

    return sorted(map(turned, edges), key=lambda edge: coordinate[edge[0]])


def _outward(problem, node):
    """Outward normal of the first body: downwards, or away from the centre of the arc."""
    point = problem["points"][node]
    return point / np.hypot(*point) if problem["arc"] else np.array([0.0, -1.0])


def solve(problem, stiffness, load, edge_functions):
    """Products of K, load, and pressures and displacements of the penalty line element for each `kappa`."""
    load = load.copy()
    if problem["tied"].size:
        load[2 * problem["tied"][0] + 1] += problem["tied_force"]
    held = 2 * problem["held"][:, 0] + problem["held"][:, 1]
    t = free_motions(load.size, held, 2 * problem["tied"] + 1)
    b, areas, gaps = line_element(problem, edge_functions)
    unit = _modulus(problem) / problem["length"]
    system = [t.T @ stiffness @ t, t.T @ load, b @ t, areas, gaps]
    found = [penalty(*system, kappa * unit) for kappa in problem["kappa"]]
    return {
        "products": np.array([stiffness @ v for v in problem["vectors"]]),
        "load": load,
        "pressure": np.array([p for _, p in found]),
        "displacement": np.array([t @ q for q, _ in found]),
    }


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
    return sparse.csr_matrix((np.ones(len(rows)), (rows, column[rows])), (size, column[rows].max() + 1))


def penalty(stiffness, load, b, areas, gaps, k_n):
    """Unknowns and pressures of `p = k_n (B q - g)+`: springs closed where w > g, all closed at the start.

    Each solution is refined once, unknowns and pressures together: `k_n (w - g)` is a difference of near equals.
    """
    closed = np.ones(len(gaps), dtype=bool)
    for _ in range(STEPS):
        k = sparse.diags(np.where(closed, k_n, 0.0))
        force = sparse.diags(areas)
        factor = splu((stiffness + b.T @ force @ k @ b).tocsc())
        q = factor.solve(load + b.T @ (force @ (k @ gaps)))
        p = k @ (b @ q - gaps)
        change = factor.solve(load - stiffness @ q - b.T @ (force @ p))
        q, p = q + change, p + k @ (b @ change)
        if np.array_equal(closed, b @ q > gaps):
            return q, p
        closed = b @ q > gaps
    raise RuntimeError(f"the closed set still changes after {STEPS} steps")
