"""Own meshes of 6-node triangles: graded towards the contact, nested from level to level.

A coarse triangulation written by hand is refined red-green-blue (longest edge first, so that angles stay
bounded) until no edge is longer than a size function allows. Each level above that cuts every triangle into
four.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

from dataclasses import dataclass

import numpy as np


@dataclass
class Line:
    """Straight line on which one coordinate (0: x, 1: y) has a value [mm]."""

    axis: int
    value: float

    def holds(self, points):
        """Which points lie on the line."""
        return abs(points[:, self.axis] - self.value) < 1e-9 * (1.0 + abs(self.value))


@dataclass
class Mesh:
    """Points (n, 2); triangles (m, 6): corners 0 1 2, middles of 01, 12, 20; boundary edges (k, 3) by the
    names of their lines: first, last, middle."""

    points: np.ndarray
    triangles: np.ndarray
    boundary: dict

    def nodes(self, name):
        """Nodes of a boundary."""
        return np.unique(self.boundary[name])


def graded(points, triangles, curves, size, level):
    """Mesh whose edges are at most `size(points)` long at level 0, halved `level` times; `curves` names the boundary lines."""
    points, triangles = np.array(points, float), np.array(triangles)
    while True:
        edges, _, _ = edges_of(triangles)
        ends = points[edges]
        long = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > 1.05 * size(ends.mean(axis=1))
        if not long.any():
            break
        points, triangles = cut(points, triangles, long)
    for _ in range(level):
        points, triangles = cut(points, triangles, np.ones(len(edges_of(triangles)[0]), bool))
    return with_middles(points, triangles, curves)


def edges_of(triangles):
    """Edges (k, 2), the edges 01, 12, 20 of each triangle (m, 3), and which edges are on the boundary."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, index, count = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    return edges, index.reshape(-1, 3), count == 1


def cut(points, triangles, marked):
    """Cuts the marked edges, and the longest edge of every triangle that has one: green, blue or red."""
    edges, of, _ = edges_of(triangles)
    length = np.linalg.norm(points[edges[:, 1]] - points[edges[:, 0]], axis=1)
    # a hair of preference by index decides between equal edges, the same way in both neighbours
    longest = np.argmax(length[of] * (1.0 + 1e-9 * of / len(edges)), axis=1)
    turn = (longest[:, None] + np.arange(3)) % 3
    triangles, of = np.take_along_axis(triangles, turn, 1), np.take_along_axis(of, turn, 1)
    marked = marked.copy()
    while True:
        missing = marked[of].any(axis=1) & ~marked[of[:, 0]]
        if not missing.any():
            break
        marked[of[missing, 0]] = True

    number = np.full(len(edges), -1)
    number[marked] = len(points) + np.arange(marked.sum())
    points = np.vstack([points, points[edges[marked]].mean(axis=1)])
    corner, middle, split = triangles.T, number[of].T, marked[of].T
    names = {"a": corner[0], "b": corner[1], "c": corner[2], "p": middle[0], "q": middle[1], "r": middle[2]}
    patterns = [
        (~split[0], ["abc"]),
        (split[0] & ~split[1] & ~split[2], ["apc", "pbc"]),
        (split[0] & split[1] & ~split[2], ["apc", "pbq", "pqc"]),
        (split[0] & ~split[1] & split[2], ["apr", "rpc", "pbc"]),
        (split.all(axis=0), ["apr", "pbq", "rqc", "pqr"]),
    ]
    chosen = [(which, child) for which, children in patterns for child in children]
    return points, np.vstack([np.column_stack([names[k][which] for k in child]) for which, child in chosen])


def with_middles(points, triangles, curves):
    """The 6-node mesh of 3-node triangles, its boundary edges sorted by the lines that hold them."""
    edges, of, outer = edges_of(triangles)
    numbered = np.column_stack([edges, len(points) + np.arange(len(edges))])
    boundary = {
        name: numbered[outer & curve.holds(points)[edges].all(axis=1)] for name, curve in curves.items()
    }
    everywhere = np.vstack([points, points[edges].mean(axis=1)])
    return Mesh(everywhere, np.hstack([triangles, len(points) + of]), boundary)
