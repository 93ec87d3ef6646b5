"""Own meshes of curved quadratic triangles of a pin and of what is round it: facing arcs have nodes on the same rays from (0, 0); and peaks."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np

import fan
from fan import refined, triangles

ARC = 14  # edges on 90 degrees of the arcs, level 0
GROWTH = 1.4
CORNER = 0.2  # size where eye and shank meet, over that on the arcs


def between(start, end, first, last):
    """Places whose distances grow from those at both ends."""
    left, right = [first], [last]
    while sum(left) + sum(right) < end - start:
        short = min(left, right, key=lambda side: side[-1])
        short.append(GROWTH * short[-1])
    places = np.cumsum([0.0, *left, *right[::-1]])
    return start + (end - start) * places / places[-1]


def polar(away, theta, up=0.0):
    """Places at a distance from (0, up) and an angle from the downward vertical [rad]."""
    return np.array([away * np.sin(theta), up - away * np.cos(theta)])


def grid(s, t, place):
    """Points and triangles of a grid, `place(s, t)`; the middles of its cells are every other place."""
    points = place(*np.meshgrid(s, t, indexing="ij")).reshape(2, -1).T
    return points, triangles(len(s) // 2, len(t) // 2)


def joined(parts):
    """One mesh of parts that meet node on node."""
    counts = np.cumsum([0] + [len(points) for points, _ in parts])
    points = np.vstack([points for points, _ in parts])
    _, first, same = np.unique(np.round(points / np.abs(points).max(), 10), axis=0, return_index=True, return_inverse=True)
    return points[first], same.ravel()[np.vstack([cells + count for (_, cells), count in zip(parts, counts)])]


def pin(scene, level):
    """Quarter pin of `pin-rod`, half pin of `pin-plate`: rings round a fan at its centre."""
    size, radius = np.pi / 2 / ARC, scene["pin_radius"]
    theta = refined(np.concatenate(arcs(scene)[:-1] if scene["case"] == "pin-rod" else arcs(scene)), level + 1)
    core = 0.1 * radius
    away = refined(core * np.exp(between(0, np.log(radius / core), size, size)), level + 1)
    a, b, c = theta[:-2:2], theta[1::2], theta[2::2]
    six = [polar(0 * a, a), polar(core, a), polar(core, c), polar(core, b), polar(core / 2, c), polar(core / 2, a)]
    inmost = np.array(six).transpose(2, 0, 1).reshape(-1, 2)
    return joined([grid(theta, away, lambda s, t: polar(t, s)), (inmost, np.arange(len(inmost)).reshape(-1, 6))])


def arcs(scene):
    """Angles of the hole's nodes, piece after piece: where contact may be, to the shank if there is one, and to the top."""
    size = np.pi / 2 / ARC
    lower = np.linspace(0, np.pi / 2, ARC + 1)
    if scene["case"] == "pin-plate":
        return lower, between(np.pi / 2, np.pi, size, 2 * size)[1:]
    corner = np.pi - np.arcsin(0.5 * scene["shank_width"] / scene["eye_outer_radius"])
    upper = between(np.pi / 2, corner, size, CORNER * size)
    return lower, np.concatenate([upper[1:], between(corner, np.pi, CORNER * size, size)[1:]])


def body(scene, level):
    """Half plate, or half a rod's eye with its shank; the hole's centre is a clearance above the pin's."""
    up, size = scene["clearance"], np.pi / 2 / ARC
    hole, is_plate = scene["pin_radius"] + up, scene["case"] == "pin-plate"
    outer = scene["rim_radius"] if is_plate else scene["eye_outer_radius"]
    first = np.log(outer / hole)
    share = (np.exp(between(0, first, size, 2 * size if is_plate else CORNER * size)) - 1) / (outer / hole - 1)

    def round_hole(theta, share):
        # The ray from (0, 0) meets the hole at this distance.
        away = np.sqrt(hole**2 - (up * np.sin(theta)) ** 2) - up * np.cos(theta)
        return (1 - share) * polar(away, theta) + share * polar(outer, theta, up)

    theta = refined(np.concatenate(arcs(scene)), level + 1)
    eye = grid(theta, refined(share, level + 1), round_hole)
    if is_plate:
        return eye
    end = up + scene["shank_end"]
    corner = np.pi - np.arcsin(0.5 * scene["shank_width"] / outer)
    above = theta[theta > corner - 1e-9]

    def shank(theta, share):
        x, y = polar(outer, theta, up)
        return np.array([x, y + share * (end - y)])

    return joined([eye, grid(above, refined(between(0, 1, CORNER * size, 4 * size), level + 1), shank)])


def peak(places, pressure, half_width):
    """Value on top: at 0 by the sextic of fan.py, else of the quintic about the largest edge mean whose edge means are nearest [MPa]."""
    means = pressure.mean(axis=1)
    top = places.mean(axis=1)[np.argmax(means)]
    if top < 0.3 * half_width:
        return fan.peak(places, pressure, half_width)
    t = (places - top) / half_width
    near = np.abs(t.mean(axis=1)) < 0.25
    terms = np.array([(t[near] ** k).mean(axis=1) for k in range(6)]).T
    found = np.linalg.lstsq(terms, means[near], rcond=None)[0]
    return np.polyval(found[::-1], np.linspace(-0.25, 0.25, 2001)).max()


def angle(x):
    """Angle from the downward vertical [rad]."""
    return np.arctan2(x[0], -x[1])
