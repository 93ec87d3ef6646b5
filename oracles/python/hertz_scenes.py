"""Elastic cylinder on a rigid plane, and its exact twin, the truncated Hertz block; plane strain.

Scene: radius [mm], young [MPa], poisson, a_over_r (it sets the load P = pi a^2 E*/4R), stretch of the
candidates over a, and for the block its side over a, size.
"""

from functools import partial

import numpy as np

import closed_forms
import shapes
from contact import Pair
from model import Body, Model

# Contact edges of level 0 on the candidate stretch: 8 per half-width where that is 2a, with a node at a.
EDGES = 16


def cylinder(scene, level):
    """Quarter of an elastic cylinder on a rigid plane, uniform q = P/2R on its horizontal cut."""
    radius, load = scene["radius"], hertz(scene)["load"]
    stretch = scene["stretch"] * hertz(scene)["half_width"]
    mesh = shapes.lying_quarter(radius, stretch, EDGES, level)

    def traction(points):
        return np.broadcast_to([0.0, -load / (2.0 * radius)], points.shape)

    gap = partial(closed_forms.circle_gap, radius=radius)
    return hertz_model(scene, mesh, Pair(gap, stretch, 1.0), [("cut", traction)])


def truncated_hertz(scene, level):
    """Square block on a rigid parabola, the half-space's tractions on its other two sides: exactly Hertz."""
    if not scene["size"] > scene["stretch"]:
        raise ValueError(f"block size {scene['size']} must exceed the stretch {scene['stretch']}")
    half_width = hertz(scene)["half_width"]
    stretch = scene["stretch"] * half_width
    mesh = shapes.rectangle(scene["size"] * half_width, stretch, EDGES, level)
    peak = 2.0 * hertz(scene)["load"] / (np.pi * half_width)

    def stress(points):
        return closed_forms.hertz_stress(points[:, 0], points[:, 1], half_width, peak)

    def right(points):
        across, _, shear = stress(points)
        return np.column_stack([across, shear])

    def top(points):
        _, down, shear = stress(points)
        return np.column_stack([shear, down])

    gap = partial(closed_forms.parabola_gap, radius=scene["radius"])
    return hertz_model(scene, mesh, Pair(gap, stretch, 1.0), [("right", right), ("top", top)])


def hertz(scene):
    """Plane-strain modulus [MPa], half-width [mm] and load [N/mm] of a Hertz scene."""
    modulus = closed_forms.plane_modulus(scene["young"], scene["poisson"], "strain")
    half_width = scene["a_over_r"] * scene["radius"]
    load = closed_forms.hertz_load(half_width, modulus, scene["radius"])
    return {"modulus": modulus, "half_width": half_width, "load": load}


def hertz_model(scene, mesh, pair, tractions):
    """One body on a rigid plane, symmetric about x = 0, held upwards by contact alone."""
    known = hertz(scene)
    body = Body(mesh, closed_forms.plane_matrix(scene["young"], scene["poisson"], "strain"))
    start, none = known["half_width"], np.zeros(0, int)
    force = np.zeros(2 * len(mesh.points))
    fixed = 2 * mesh.nodes("axis")
    return Model([body], pair, known["modulus"], start, start, force, fixed, none, tractions)
