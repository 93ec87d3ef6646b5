"""Contact points on the candidate edges of a body above a rigid profile: approach, area, gap.

Approach w > 0 closes, gap g >= 0, pressure p >= 0; areas, normals and gaps belong to the undeformed surface, y = 0.
Edge functions come from the code under test: `functions(xi) -> (N, dN)`, xi in -1..1, each (n, 3) in the order
first, last, middle.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix, diags

# Two points per quadratic edge: three over-constrain it, and the pressure oscillates.
GAUSS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
# Places and weights of the fine rule by which gap and approach are integrated.
FINE = np.polynomial.legendre.leggauss(12)


@dataclass
class Points:
    """Contact points: rows of w = rows @ u, areas A per thickness [mm], gaps [mm], positions x [mm], edges, places on them."""

    rows: csr_matrix
    weight: np.ndarray
    gap: np.ndarray
    position: np.ndarray
    edge: np.ndarray
    local: np.ndarray


def contact_edges(mesh, limit):
    """Contact edges up to a position, each in the sense of growing x, sorted by it."""
    edges = mesh.boundary["contact"].copy()
    x = mesh.points[:, 0]
    turned = x[edges[:, 0]] > x[edges[:, 1]]
    edges[turned, :2] = edges[turned, 1::-1]
    ends = x[edges[:, 1]]
    order = np.argsort(ends)
    return edges[order][ends[order] <= limit * (1.0 + 1e-9)]


def contact_points(mesh, gap, stretch, functions):
    """Two points on each candidate edge.

    Gap and approach are integrated finely and projected on to the linear functions L of the edge, L being 1
    at one Gauss point and 0 at the other.
    """
    edges = contact_edges(mesh, stretch)
    edge, local = np.repeat(np.arange(len(edges)), len(FINE[0])), np.tile(FINE[0], len(edges))
    shape, slope = functions(local)
    x, dx = (np.einsum("pa,pa->p", f, mesh.points[edges[edge], 0]) for f in (shape, slope))
    row, column = np.repeat(np.arange(len(x)), 3), (2 * edges[edge] + 1).ravel()
    rows = csr_matrix((-shape.ravel(), (row, column)), (len(x), 2 * len(mesh.points)))

    area = np.tile(FINE[1], len(edges)) * dx
    linear = 0.5 + 1.5 * local[:, None] * GAUSS
    to = 2 * edge[:, None] + np.arange(2)
    entry = (area[:, None] * linear).ravel()
    share = csr_matrix((entry, (to.ravel(), np.repeat(np.arange(len(x)), 2))), (2 * len(edges), len(x)))
    weight = share @ np.ones(len(x))
    mean = diags(1.0 / weight) @ share
    owner, place = np.repeat(np.arange(len(edges)), 2), np.tile(GAUSS, len(edges))
    return Points((mean @ rows).tocsr(), weight, mean @ gap(x), mean @ x, owner, place)
