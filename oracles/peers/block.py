"""The truncated Hertz block: a square on a rigid parabola, meshed and loaded; plane strain, thickness 1.

Scene: radius [mm], young [MPa], poisson, a_over_r (it sets the load P = pi a^2 E*/4R), stretch of the
candidates over a, side over a, size. The block is symmetric about x = 0 and held upwards by contact alone.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

from dataclasses import dataclass
from functools import partial
from typing import Callable

import numpy as np

import closed_forms
from triangles import Line, Mesh, graded

# Edges may be as long as those of the contact and half the distance from it.
GROWTH = 0.5


@dataclass
class Model:
    """The block at one level; freedoms are 2 node + component."""

    mesh: Mesh
    plane_matrix: np.ndarray
    gap: Callable  # of x [mm]
    stretch: float  # candidates lie between 0 and this x [mm]
    contact_modulus: float  # [MPa]
    length: float  # of the scene, turns k_n into kappa [mm]
    start: float  # x below which the iteration starts closed [mm]
    fixed: np.ndarray  # freedoms held at zero
    tractions: list  # (boundary, traction of points)


def hertz(scene):
    """Plane-strain modulus [MPa], half-width [mm] and load [N/mm] of the scene."""
    modulus = closed_forms.plane_modulus(scene["young"], scene["poisson"], "strain")
    half_width = scene["a_over_r"] * scene["radius"]
    load = closed_forms.hertz_load(half_width, modulus, scene["radius"])
    return {"modulus": modulus, "half_width": half_width, "load": load}


def truncated_hertz(scene, edges, level, steep=1):
    """The half-space's tractions on the two sides away from parabola and axis: exactly Hertz; `edges` on the candidates at level 0.

    Cells grow `steep` times as fast as GROWTH says."""
    if not scene["size"] > scene["stretch"]:
        raise ValueError(f"block size {scene['size']} must exceed the stretch {scene['stretch']}")
    modulus, half_width, load = hertz(scene).values()
    stretch = scene["stretch"] * half_width
    mesh = square(scene["size"] * half_width, stretch, edges, level, GROWTH * steep)
    bulk, shear = closed_forms.lame(scene["young"], scene["poisson"], "strain")
    matrix = np.array([[bulk + 2.0 * shear, bulk, 0.0], [bulk, bulk + 2.0 * shear, 0.0], [0.0, 0.0, shear]])

    def stress(points):
        return closed_forms.hertz_stress(points[:, 0], points[:, 1], half_width, 2.0 * load / (np.pi * half_width))

    def right(points):
        across, _, along = stress(points)
        return np.column_stack([across, along])

    def top(points):
        _, down, along = stress(points)
        return np.column_stack([along, down])

    gap = partial(closed_forms.parabola_gap, radius=scene["radius"])
    loads = [("right", right), ("top", top)]
    return Model(mesh, matrix, gap, stretch, modulus, half_width, half_width, 2 * mesh.nodes("axis"), loads)


def square(side, stretch, elements, level, growth=GROWTH):
    """Square 0..side whose contact is on y = 0, with `elements` uniform edges on x = 0..stretch."""
    cells = int(np.ceil(side / stretch - 1e-9))
    far = np.linspace(stretch, side, cells) if cells > 1 else []
    stations = np.concatenate([[0.0, 0.5 * stretch], far])
    curves = {"contact": Line(1, 0.0), "right": Line(0, side), "top": Line(1, side), "axis": Line(0, 0.0)}

    def size(points):
        away = np.hypot(np.maximum(points[:, 0] - stretch, 0.0), points[:, 1])
        return stretch / elements + growth * away

    return graded(*grid(stations), curves, size, level)


def grid(stations):
    """Points and triangles of a square grid, every second diagonal turned."""
    count = len(stations)
    index = np.arange(count**2).reshape(count, count)
    triangles = []
    for i in range(count - 1):
        for j in range(count - 1):
            a, b, c, d = index[i, j], index[i, j + 1], index[i + 1, j + 1], index[i + 1, j]
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return [(x, y) for y in stations for x in stations], triangles
