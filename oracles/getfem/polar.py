"""Pins and the bodies round them as GetFEM meshes: polar grids of curved quadrilaterals, triangles at the centre of a pin."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import getfem as gf
import numpy as np

ARC = 24  # elements of level 0 on 90 degrees of an arc
GROWTH = 1.4
CONTACT, AXIS, HELD, FACE = 1, 2, 3, 4


def nodes(start, end, first, last, level):
    """Ends and middles of intervals that grow from both ends towards the middle and are halved `level` times."""
    left, right = [first], [last]
    while sum(left) + sum(right) < end - start:
        short = min(left, right, key=lambda side: side[-1])
        short.append(GROWTH * short[-1])
    sizes = np.array(left + right[::-1])
    ticks = start + (end - start) * np.concatenate([[0.0], np.cumsum(sizes)]) / sizes.sum()
    for _ in range(level + 1):
        ticks = np.sort(np.concatenate([ticks, 0.5 * (ticks[1:] + ticks[:-1])]))
    return ticks


def evenly(start, end, count, level):
    """Ends and middles of equal intervals."""
    return np.linspace(start, end, count * 2 ** (level + 1) + 1)


def grid(mesh, s, t, place):
    """Adds the quadrilaterals of a grid; `place(s, t)` is (x, y)."""
    at = np.array(place(*np.meshgrid(s, t, indexing="ij")))
    nine = [at[:, i : at.shape[1] - 2 + i : 2, j : at.shape[2] - 2 + j : 2] for j in range(3) for i in range(3)]
    mesh.add_convex(gf.GeoTrans("GT_QK(2,2)"), np.asfortranarray(np.array(nine).reshape(9, 2, -1).transpose(1, 0, 2)))


def fan(mesh, theta, radius):
    """Adds the triangles round the centre (0, 0) up to a radius."""
    for a, b, c in zip(theta[:-2:2], theta[1::2], theta[2::2]):
        six = [(0, a), (0.5, a), (1, a), (0.5, c), (1, b), (1, c)]
        points = np.array([polar(share * radius, angle) for share, angle in six]).T
        mesh.add_convex(gf.GeoTrans("GT_PK(2,2)"), np.asfortranarray(points))


def polar(away, theta):
    """Place at a distance from the origin and an angle from the downward vertical [rad]."""
    return away * np.sin(theta), -away * np.cos(theta)


def named(mesh, number, holds):
    """Makes a region of the faces all of whose points lie where it holds."""
    mesh.set_region(number, mesh.faces_from_pid(mesh.pid()[holds(*mesh.pts())]))


def pin(scene, level):
    """Quarter pin of `pin-rod`, held on its horizontal cut, or half pin of `pin-plate`, its centre marked."""
    radius, half = scene["pin_radius"], scene["case"] == "pin-plate"
    theta = evenly(0.0, np.pi if half else np.pi / 2, 2 * ARC if half else ARC, level)
    core = 0.1 * radius
    out = nodes(core, radius, np.pi / 2 * core / ARC, np.pi / 2 * radius / ARC, level)
    mesh = gf.Mesh("empty", 2)
    grid(mesh, out, theta, polar)
    fan(mesh, theta, core)
    # The arc is a candidate as far as the scene stretches.
    end = scene["stretch"] + 1e-9
    named(mesh, CONTACT, lambda x, y: (np.hypot(x, y) > radius - 1e-9) & (np.arctan2(x, -y) < end))
    named(mesh, AXIS, lambda x, y: np.abs(x) < 1e-9)
    if not half:
        named(mesh, HELD, lambda x, y: np.abs(y) < 1e-9)
    return mesh


def body(scene, level):
    """Half rod with a rigid end face, or half plate with a held rim; the hole's centre is a clearance above the pin's."""
    hole, up = scene["pin_radius"] + scene["clearance"], scene["clearance"]
    size = np.pi / 2 / ARC
    mesh = gf.Mesh("empty", 2)

    def round_hole(away, theta):
        x, y = polar(away, theta)
        return x, y + up

    def off_axis(x, y):
        return np.hypot(x, y - up)

    if scene["case"] == "pin-plate":
        rim = scene["rim_radius"]
        grid(mesh, hole * np.exp(nodes(0, np.log(rim / hole), size, 2 * size, level)), evenly(0, np.pi, 2 * ARC, level), round_hole)
        named(mesh, HELD, lambda x, y: off_axis(x, y) > rim * (1 - 1e-9))
    else:
        outer, half, end = scene["eye_outer_radius"], 0.5 * scene["shank_width"], up + scene["shank_end"]
        corner = np.pi - np.arcsin(half / outer)
        # Eye and shank meet in a corner that sticks out by less than 180 degrees: finer there.
        lower, middle = evenly(0, np.pi / 2, ARC, level), nodes(np.pi / 2, corner, size, 0.2 * size, level)
        upper = nodes(corner, np.pi, 0.2 * size, size, level)
        across = nodes(hole, outer, hole * size, 0.2 * outer * size, level)
        grid(mesh, across, np.concatenate([lower, middle[1:], upper[1:]]), round_hole)

        def shank(theta, share):
            x, y = round_hole(outer, theta)
            return x, y + share * (end - y)

        grid(mesh, upper, nodes(0, 1, 0.2 * size, size, level), shank)
        named(mesh, FACE, lambda x, y: y > end - 1e-9)
    named(mesh, AXIS, lambda x, y: np.abs(x) < 1e-9)
    return mesh
