"""Contact points on the candidate edges of the first body: approach, area, gap.

Conventions of model.md: approach w > 0 closes, gap g >= 0, pressure p >= 0; areas, normals and gaps belong to
the undeformed surface. Edge functions come from the code under test: `functions(xi) -> (N, dN)`, xi in -1..1,
each (n, 3) in the order first, last, middle.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy.sparse import csr_matrix, diags

# Two points per quadratic edge: three over-constrain it, and the pressure oscillates.
GAUSS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
# Places and weights of the fine rule that integrates across the kinks of the facing body.
FINE = np.polynomial.legendre.leggauss(12)


@dataclass
class Pair:
    """Where contact may happen: below a plane body (coordinate x) or round a pin at the origin (angle)."""

    gap: Callable  # of the contact coordinate [mm]
    stretch: float  # candidates lie between 0 and this coordinate
    thickness: float  # [mm]
    radius: float | None = None  # of the pin [mm]; None on a plane

    def coordinate(self, x):
        """Contact coordinate s: x [mm], or the angle from the downward vertical [rad]."""
        return x[..., 0] if self.radius is None else np.arctan2(x[..., 0], -x[..., 1])

    def metric(self):
        """Area per contact coordinate, dA/ds [mm, or mm^2/rad]."""
        return self.thickness * (1.0 if self.radius is None else self.radius)

    def normal(self, s):
        """Outward normals of the first body."""
        plane = self.radius is None
        return np.column_stack([np.zeros_like(s), -np.ones_like(s)] if plane else [np.sin(s), -np.cos(s)])

    def rate(self, x, dx):
        """ds/dxi along an edge."""
        if self.radius is None:
            return dx[..., 0]
        return (x[..., 0] * dx[..., 1] - x[..., 1] * dx[..., 0]) / (x**2).sum(axis=-1)

    def edges(self, mesh, limit=np.inf):
        """Contact edges up to a coordinate, each in the sense of growing s, sorted by it."""
        edges = mesh.boundary["contact"].copy()
        turned = self.coordinate(mesh.points[edges[:, 0]]) > self.coordinate(mesh.points[edges[:, 1]])
        edges[turned, :2] = edges[turned, 1::-1]
        ends = self.coordinate(mesh.points[edges[:, 1]])
        order = np.argsort(ends)
        return edges[order][ends[order] <= limit * (1.0 + 1e-9)]


@dataclass
class Points:
    """Contact points: rows of w = rows @ u, areas A [mm^2], gaps [mm], coordinates, edges, places on them."""

    rows: csr_matrix
    weight: np.ndarray
    gap: np.ndarray
    position: np.ndarray
    share: np.ndarray  # of a pressure along the load line: cos of the angle, 1 on planes
    edge: np.ndarray
    local: np.ndarray
    middles: np.ndarray  # coordinates of the edges' mid-side nodes


def contact_points(meshes, pair, functions):
    """Two points on each candidate edge of the first mesh, facing the second mesh, if any, along the radius.

    Gap and approach are integrated finely and projected on to the linear functions L of the edge, L being 1
    at one Gauss point and 0 at the other. On one body that is the 2-point rule; where edges do not match,
    sampling at the points alone presses on the facing body like single forces, and the pressures scatter: the
    penalty peak of the pin-rod then moves away with refinement, by 4 % at level 2.
    """
    mesh = meshes[0]
    edges = pair.edges(mesh, pair.stretch)
    edge, local = np.repeat(np.arange(len(edges)), len(FINE[0])), np.tile(FINE[0], len(edges))
    shape, x, dx = on_edges(mesh, edges[edge], functions, local)
    s = pair.coordinate(x)
    size, normal = 2 * sum(len(m.points) for m in meshes), pair.normal(s)
    rows = approach(edges[edge], shape, normal, 0, size)
    if len(meshes) == 2:
        facing, shape = face(meshes[1], pair, functions, s)
        rows = rows + approach(facing, shape, -normal, 2 * len(mesh.points), size)

    metric = 1.0 if pair.radius is None else pair.radius
    area = np.tile(FINE[1], len(edges)) * pair.rate(x, dx) * metric * pair.thickness
    linear = 0.5 + 1.5 * local[:, None] * GAUSS
    to = 2 * edge[:, None] + np.arange(2)
    entry = (area[:, None] * linear).ravel()
    share = csr_matrix((entry, (to.ravel(), np.repeat(np.arange(len(s)), 2))), (2 * len(edges), len(s)))
    weight = share @ np.ones(len(s))
    mean = diags(1.0 / weight) @ share
    middles = pair.coordinate(mesh.points[edges[:, 2]])
    owner, place = np.repeat(np.arange(len(edges)), 2), np.tile(GAUSS, len(edges))
    along = -normal[:, 1]
    rows, gap = (mean @ rows).tocsr(), mean @ pair.gap(s)
    return Points(rows, weight, gap, mean @ s, mean @ along, owner, place, middles)


def on_edges(mesh, edges, functions, local):
    """Edge functions, points and their slopes at one place on each of some edges."""
    shape, slope = functions(local)
    x, dx = (np.einsum("pa,pai->pi", f, mesh.points[edges]) for f in (shape, slope))
    return shape, x, dx


def approach(nodes, values, normal, start, size):
    """Rows of N . u for the displacement interpolated by `values` between `nodes`."""
    n = len(nodes)
    entry = (values[:, :, None] * normal[:, None, :]).ravel()
    column = start + 2 * nodes[:, :, None] + np.arange(2)
    return csr_matrix((entry, (np.repeat(np.arange(n), 6), column.ravel())), (n, size))


def face(mesh, pair, functions, s):
    """Edges of the facing body at the coordinates `s`, and their functions there."""
    edges = pair.edges(mesh)
    ends = pair.coordinate(mesh.points[edges[:, 1]])
    found = edges[np.minimum(np.searchsorted(ends, s), len(edges) - 1)]
    local = np.zeros(len(s))
    for _ in range(6):  # nearly linear: three steps reach round-off
        _, x, dx = on_edges(mesh, found, functions, local)
        local = local - (pair.coordinate(x) - s) / pair.rate(x, dx)
    return found, functions(local)[0]
