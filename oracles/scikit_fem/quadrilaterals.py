"""Scenes as models on meshes of curved 9-node quadrilaterals, put together from blocks; facing arcs have nodes at the same angles."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

from dataclasses import dataclass, field
from typing import Callable

import numpy as np
from skfem import MeshQuad, MeshQuad2

# Elements of level 0: on the half-width of a Hertz contact, and on 45 degrees of a pin; growth away from the contact.
HERTZ, PIN = 6, 8
GROWTH = 1.6


@dataclass
class Model:
    """Bodies, supports and loads; `where` is (body, component, which places)."""

    meshes: list
    materials: list  # Young's modulus [MPa], Poisson's ratio, plane hypothesis
    candidates: list  # facets of each body, in the order of the contact coordinate
    coordinate: Callable  # of places: x [mm], or the angle from the downward vertical [rad]
    normal: Callable  # outward normals of the first body
    gap: Callable  # [mm]
    modulus: float  # 1/E* = sum of (1 - nu^2)/E, or of 1/E in plane stress [MPa]
    length: float  # [mm]
    start: float  # about where the contact ends
    thickness: float
    above_plane: bool
    fixed: list
    rigid: list = field(default_factory=list)
    tractions: list = field(default_factory=list)  # facets and traction [MPa], on the first body
    forces: list = field(default_factory=list)  # where, and force [N]


def growing(start, end, first):
    """Ticks from start to end, sizes growing from `first`; the last pieces are stretched to fit."""
    count = max(1, int(np.ceil(np.log1p((end - start) * (GROWTH - 1) / first) / np.log(GROWTH))))
    sizes = first * GROWTH ** np.arange(count)
    return start + (end - start) * np.concatenate([[0.0], np.cumsum(sizes)]) / sizes.sum()


def halved(ticks, level):
    """Ticks with every interval halved so many times."""
    for _ in range(level):
        ticks = np.sort(np.concatenate([ticks, 0.5 * (ticks[1:] + ticks[:-1])]))
    return ticks


def join(*ticks):
    """Ticks one after the other, each beginning where the last one ended."""
    return np.concatenate([ticks[0]] + [more[1:] for more in ticks[1:]])


def block(s, t, at):
    """Corners (2, n, m) of a block: `at(s, t)` on the grid of two lists of ticks."""
    return np.array(at(*np.meshgrid(s, t, indexing="ij")))


def meshed(grids, circles, order):
    """Mesh of blocks; vertices are numbered by `order`, so that facets run that way; boundary facets lie on their circles."""
    points, cells, count = [], [], 0
    for grid in grids:
        n, m = grid.shape[1:]
        number = count + np.arange(n * m).reshape(n, m)
        cells.append(np.array([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]).reshape(4, -1))
        points.append(grid.reshape(2, -1))
        count += n * m
    points, cells = np.hstack(points), np.hstack(cells)
    scale = np.abs(points).max()
    _, first, same = np.unique(np.round(points / scale, 10), axis=1, return_index=True, return_inverse=True)
    points, cells = points[:, first], same.ravel()[cells]
    rank = np.empty(points.shape[1], int)
    rank[np.argsort(order(points), kind="stable")] = np.arange(points.shape[1])
    points, cells = points[:, np.argsort(rank)], rank[cells]
    a, b, _, d = points[:, cells].transpose(1, 0, 2)
    turned = (b - a)[0] * (d - a)[1] - (b - a)[1] * (d - a)[0] < 0
    cells[:, turned] = cells[::-1, turned]
    flat = MeshQuad(points, cells)
    if flat.nvertices - flat.nfacets + flat.nelements != 1:
        raise RuntimeError("blocks do not meet node on node: give facing sides the same ticks")
    mesh = MeshQuad2.from_mesh(flat)
    places = mesh.doflocs.copy()
    for facet in mesh.boundary_facets():
        ends = mesh.p[:, mesh.facets[:, facet]]
        for centre, radius in circles:
            away = np.linalg.norm(ends - np.reshape(centre, (2, 1)), axis=0)
            if np.allclose(away, radius, rtol=1e-9):
                ray = ends.mean(axis=1) - centre
                places[:, mesh.nvertices + facet] = centre + radius * ray / np.linalg.norm(ray)
    return MeshQuad2(places, mesh.t)


def facets_on(mesh, holds, coordinate, limit=np.inf):
    """Boundary facets whose ends lie where `holds`, up to a coordinate, in its order."""
    facets = mesh.boundary_facets()
    ends = mesh.p[:, mesh.facets[:, facets]]
    place = coordinate(ends).max(axis=0)
    on = holds(ends).all(axis=0) & (place <= limit * (1 + 1e-9))
    return facets[on][np.argsort(place[on])]


def angle(x):
    """Angle from the downward vertical [rad]."""
    return np.arctan2(x[0], -x[1])


def polar(centre, radius, theta):
    """Places on a circle."""
    return centre[0] + radius * np.sin(theta), centre[1] - radius * np.cos(theta)


def disc(centre, radius, angles, first, level):
    """Blocks of a sector of a disc from the downward vertical, around a core; `angles` are the same above as below."""
    core = 0.45 * radius
    corner = [core * np.array(c) for c in ([0, -1], [1, -1], [1, 1], [0, 1])]
    ends = np.array([0, np.pi / 4, 3 * np.pi / 4, np.pi])
    inwards = halved(growing(0.0, 1.0, first / (radius - core)), level)

    def rim(theta):
        side = np.clip(np.searchsorted(ends, theta - 1e-9) - 1, 0, 2)
        # the same share of the core's side as of the angle
        share = (theta - ends[side]) / (ends[side + 1] - ends[side])
        a, b = np.array(corner)[side], np.array(corner)[side + 1]
        return np.moveaxis(a + share[..., None] * (b - a), -1, 0)

    def between(theta, t):
        outer, inner = np.array(polar((0, 0), radius, theta)), rim(theta)
        return np.reshape(centre, (2, 1, 1)) + (1 - t) * outer + t * inner

    lower = angles[angles <= ends[1] + 1e-9]
    right = angles[(angles >= ends[1] - 1e-9) & (angles <= ends[2] + 1e-9)]
    x, y = rim(lower)[0], rim(right)[1]
    middle = block(x, y, lambda x, y: (centre[0] + x, centre[1] + y))
    return [block(angles, inwards, between), middle]
