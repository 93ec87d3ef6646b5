"""Pins in holes on own meshes, two bodies in plane stress: facing arcs have nodes at the same angles about the pin's centre."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np

from quadrilaterals import PIN, Model, angle, block, disc, facets_on, growing, halved, join, meshed, polar

# Growing sizes at the corner where eye and shank meet start with this part of the size on the arc.
CORNER = 0.3


def pin_rod(scene, level):
    """Quarter pin held on its horizontal cut; half a rod pulled upwards by a rigid end face."""
    radius, clearance, outer = scene["pin_radius"], scene["clearance"], scene["eye_outer_radius"]
    size = np.pi / 4 / PIN
    centre = np.array([0.0, clearance])
    half, end = 0.5 * scene["shank_width"], clearance + scene["shank_end"]
    corner = np.pi - np.arcsin(half / outer)
    lower = np.linspace(0.0, np.pi / 2, 2 * PIN + 1)
    upwards = join(lower, closing(np.pi / 2, corner, CORNER * size))
    rest = join(np.array([corner]), growing(corner, np.pi, CORNER * size))
    pin = meshed(disc((0.0, 0.0), radius, halved(lower, level), radius * size, level), [(np.zeros(2), radius)], angle)
    across = both_ends(radius * size / (outer - radius), CORNER * outer * size / (outer - radius))
    eye = ring(radius, centre, radius + clearance, outer, halved(join(upwards, rest), level), halved(across, level))
    foot = np.array(polar(centre, outer, halved(rest, level)))
    heights = halved(growing(0.0, 1.0, CORNER * outer * size / (end - foot[1].max())), level)
    shank = foot[:, :, None] + heights * (np.array([foot[0] * half / foot[0, 0], 0 * foot[0] + end])[:, :, None] - foot[:, :, None])
    rod = meshed([eye, shank], [(centre, radius + clearance), (centre, outer)], angle)
    materials = [(scene[f"{body}_young"], scene[f"{body}_poisson"], "stress") for body in ("pin", "rod")]
    face = (1, 1, lambda x: x[1] > end - 1e-9)
    fixed = [(0, 0, on_axis), (0, 1, lambda x: x[1] > -1e-9), (1, 0, on_axis)]
    return pinned(scene, [pin, rod], materials, 0.8, fixed, rigid=[face], forces=[(face, 0.5 * scene["force"])])


def pin_plate(scene, level):
    """Half pin pressed down at its centre and held by contact alone; half plate with a fixed rim."""
    radius, clearance, rim = scene["pin_radius"], scene["clearance"], scene["rim_radius"]
    size, centre = np.pi / 4 / PIN, np.array([0.0, clearance])
    angles = halved(np.linspace(0.0, np.pi, 4 * PIN + 1), level)
    pin = meshed(disc((0.0, 0.0), radius, angles, radius * size, level), [(np.zeros(2), radius)], angle)
    across = halved(growing(0.0, 1.0, radius * size / (rim - radius)), level)
    hole = radius + clearance
    plate = meshed([ring(radius, centre, hole, rim, angles, across)], [(centre, hole), (centre, rim)], angle)
    materials = [(scene["young"], scene["poisson"], "stress")] * 2

    def on_rim(x):
        return np.hypot(x[0], x[1] - clearance) > rim * (1 - 1e-9)

    fixed = [(0, 0, on_axis), (1, 0, on_axis), (1, 0, on_rim), (1, 1, on_rim)]
    middle = (0, 1, lambda x: np.hypot(*x) < 1e-9)
    return pinned(scene, [pin, plate], materials, 0.8, fixed, forces=[(middle, -0.5 * scene["force"])])


def on_axis(x):
    """Places on the line of symmetry."""
    return np.abs(x[0]) < 1e-9


def closing(start, end, last):
    """Ticks whose sizes shrink towards `last` at the end."""
    return start + end - growing(start, end, last)[::-1]


def both_ends(first, last):
    """Ticks on 0..1, fine at both ends."""
    return join(growing(0.0, 0.5, first), closing(0.5, 1.0, last))


def ring(pin_radius, centre, hole, outer, angles, across):
    """Block between a hole and a circle about the same centre; on the hole, angles are those about the pin's centre (0, 0)."""

    def at(theta, t):
        # The ray from the pin's centre meets the hole at this distance.
        down = -centre[1] * np.cos(theta)
        away = down + np.sqrt(down**2 + hole**2 - centre[1] ** 2)
        inner = np.array(polar((0.0, 0.0), away, theta))
        return inner + t * (np.array(polar(centre, outer, theta)) - inner)

    return block(angles, across, at)


def pinned(scene, meshes, materials, start, fixed, **loads):
    """Two bodies touching round a pin."""
    radius, clearance = scene["pin_radius"], scene["clearance"]
    hole = radius + clearance

    def on_pin(x):
        return np.abs(np.hypot(*x) - radius) < 1e-9 * radius

    def on_hole(x):
        return np.abs(np.hypot(x[0], x[1] - clearance) - hole) < 1e-9 * hole

    def gap(x):
        down = -clearance * np.cos(angle(x))
        return down + np.sqrt(down**2 + hole**2 - clearance**2) - radius

    candidates = [facets_on(mesh, on, angle, scene["stretch"]) for mesh, on in zip(meshes, [on_pin, on_hole])]
    modulus = 1.0 / sum(1.0 / young for young, _, _ in materials)
    return Model(
        meshes, materials, candidates, angle, lambda x: np.stack([np.sin(angle(x)), -np.cos(angle(x))]), gap,
        modulus, radius, start, scene["thickness"], False, fixed, **loads,
    )
