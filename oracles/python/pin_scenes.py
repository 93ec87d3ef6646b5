"""A pin in a connecting-rod eye, and a pin in a wide plate; plane stress, contact round the lowest point.

Scenes: pin_radius, clearance, thickness [mm], force on the whole [N], stretch of the candidates [rad];
pin-rod: eye_outer_radius, shank_width, shank_end [mm], pin_young, rod_young [MPa], pin_poisson, rod_poisson;
pin-plate: rim_radius [mm], young [MPa], poisson.
"""

from functools import partial

import numpy as np

import closed_forms
import shapes
from contact import Pair
from model import Body, Model
from triangles import Circle

# Contact edges of level 0 per right angle. Pin and hole share no nodes, on purpose: nothing may rest on
# matching meshes.
PIN_EDGES, HOLE_EDGES = 32, 48


def pin_rod(scene, level):
    """Quarter pin held on its horizontal diameter; half a rod pulled upwards by a rigid end face."""
    radius, clearance = scene["pin_radius"], scene["clearance"]
    hole = Circle((0.0, clearance), radius + clearance)
    pin = pin_mesh(scene, np.pi / 2, level)
    rod = shapes.eye(
        hole, scene["eye_outer_radius"], 0.5 * scene["shank_width"], scene["shank_end"], scene["stretch"],
        finest(hole, HOLE_EDGES), level,
    )
    materials = [(scene["pin_young"], scene["pin_poisson"]), (scene["rod_young"], scene["rod_poisson"])]
    model = pin_model(scene, [pin, rod], materials)
    shift = 2 * len(pin.points)
    held = [2 * pin.nodes("axis"), 2 * pin.nodes("cut") + 1, shift + 2 * rod.nodes("axis")]
    model.fixed = np.concatenate(held)
    model.tied = shift + 2 * rod.nodes("end") + 1
    model.force[model.tied[0]] = 0.5 * scene["force"]
    return model


def pin_plate(scene, level):
    """Half pin pressed down at its centre node and held by contact alone; half plate with a fixed rim."""
    hole = Circle((0.0, scene["clearance"]), scene["pin_radius"] + scene["clearance"])
    pin = pin_mesh(scene, np.pi, level)
    plate = shapes.ring(hole, scene["rim_radius"], scene["stretch"], finest(hole, HOLE_EDGES), level)
    model = pin_model(scene, [pin, plate], [(scene["young"], scene["poisson"])] * 2)
    shift = 2 * len(pin.points)
    rim = shift + 2 * plate.nodes("rim")
    model.fixed = np.concatenate([2 * pin.nodes("axis"), shift + 2 * plate.nodes("axis"), rim, rim + 1])
    model.force[1] = -0.5 * scene["force"]
    return model


def pin_mesh(scene, sweep, level):
    """Sector of the pin, its centre at the origin."""
    circle = Circle((0.0, 0.0), scene["pin_radius"])
    return shapes.disc(circle, sweep, scene["stretch"], finest(circle, PIN_EDGES), level)


def finest(circle, edges):
    """Length of one of `edges` equal arcs of a right angle [mm]."""
    return np.pi / 2 * circle.radius / edges


def pin_model(scene, meshes, materials):
    """Two bodies in plane stress touching round a pin, not yet held or loaded."""
    radius, clearance, thickness = scene["pin_radius"], scene["clearance"], scene["thickness"]
    matrices = [closed_forms.plane_matrix(*material, "stress") for material in materials]
    bodies = [Body(mesh, matrix) for mesh, matrix in zip(meshes, matrices)]
    modulus = closed_forms.contact_modulus([young for young, _ in materials])
    gap = partial(closed_forms.hole_gap, radius=radius, clearance=clearance)
    pair = Pair(gap, scene["stretch"], thickness, radius)
    start = closed_forms.hole_half_angle(2.0 * modulus, clearance, scene["force"] / thickness)
    force = np.zeros(2 * sum(len(m.points) for m in meshes))
    none = np.zeros(0, int)
    return Model(bodies, pair, modulus, radius, start, force, none, none)
