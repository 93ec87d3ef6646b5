"""Own meshes of curved quadratic triangles, and pressures along their candidates."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np

ELEMENTS = 6  # on the half-width, level 0
GROWTH = 1.5


def ticks(start, end, first):
    """Places from start to end whose distances grow from `first`."""
    places = [start]
    while places[-1] + 1.5 * first < end:
        places.append(places[-1] + first)
        first *= GROWTH
    return np.array(places + [end])


def refined(places, level):
    """Places with all distances halved so many times."""
    for _ in range(level):
        places = np.interp(np.arange(2 * len(places) - 1) / 2, np.arange(len(places)), places)
    return places


def triangles(rows, columns):
    """Corners and middles (0, 1, 2, 12, 02, 01) of the triangles of a grid of nodes (2 rows + 1) x (2 columns + 1)."""
    node = np.arange((2 * rows + 1) * (2 * columns + 1)).reshape(2 * rows + 1, 2 * columns + 1)
    a, b, c, d = node[:-2:2, :-2:2], node[2::2, :-2:2], node[2::2, 2::2], node[:-2:2, 2::2]
    ab, bc, cd, da, middle = node[1::2, :-2:2], node[2::2, 1::2], node[1::2, 2::2], node[:-2:2, 1::2], node[1::2, 1::2]
    cells = [[a, b, c, bc, middle, ab], [a, c, d, cd, da, middle]]
    return np.concatenate([np.array(one).reshape(6, -1).T for one in cells]).astype(np.int64)


def block(scene, level):
    """Square block on y = 0; sides: candidates, right, top."""
    a = scene["a_over_r"] * scene["radius"]
    side, reach = scene["size"] * a, scene["stretch"] * a
    near = np.linspace(0, reach, round(scene["stretch"] * ELEMENTS) + 1)
    x = refined(np.concatenate([near, ticks(reach, side, GROWTH * near[1])[1:]]), level + 1)
    y = refined(ticks(0, side, near[1]), level + 1)
    points = np.array(np.meshgrid(x, y, indexing="ij")).reshape(2, -1).T
    sides = [
        lambda p: (p[1] < 1e-9) & (p[0] < reach + 1e-9),
        lambda p: p[0] > side - 1e-9,
        lambda p: p[1] > side - 1e-9,
    ]
    return points, triangles(len(x) // 2, len(y) // 2), sides


def quarter(scene, level):
    """Lower quarter of a cylinder, rings round a fan at its centre (0, R); sides: candidates, cut."""
    radius, a = scene["radius"], scene["a_over_r"] * scene["radius"]
    reach = scene["stretch"] * a
    near = np.arcsin(np.linspace(0, reach, round(scene["stretch"] * ELEMENTS) + 1) / radius)
    angle = np.concatenate([near, ticks(near[-1], np.pi / 2, GROWTH * (near[-1] - near[-2]))[1:]])
    depth = ticks(0, 0.75 * radius, a / ELEMENTS)
    angle, depth = refined(angle, level + 1), refined(depth, level + 1)
    s, t = np.meshgrid(angle, radius - depth, indexing="ij")
    points = np.array([t * np.sin(s), radius - t * np.cos(s)]).reshape(2, -1).T
    cells = triangles(len(angle) // 2, len(depth) // 2)
    rings = max(2**level, 1)
    points, cells = core(points, cells, angle, radius, radius - depth[-1], rings, len(depth))
    sides = [
        lambda p: (np.abs(np.hypot(p[0], p[1] - radius) - radius) < 1e-6) & (p[0] < reach * (1 + 1e-9)),
        lambda p: p[1] > radius - 1e-9,
    ]
    return points, cells, sides


def core(points, cells, angle, radius, inner, rings, deep):
    """Adds rings of triangles between the innermost radius and the centre, and a fan on the last one."""
    last = np.arange(len(angle)) * deep + deep - 1  # nodes of the innermost ring
    for share in np.linspace(1, 0, 2 * rings + 1)[1:].reshape(-1, 2):
        rows = []
        for part in share:
            ring = inner * part * np.array([np.sin(angle), -np.cos(angle)]) + np.array([[0.0], [radius]])
            if part > 0:
                rows.append(len(points) + np.arange(len(angle)))
                points = np.vstack([points, ring.T])
            else:
                rows.append(np.full(len(angle), len(points)))
                points = np.vstack([points, [[0.0, radius]]])
        middle, end = rows
        a, b, ab = last[:-2:2], last[2::2], last[1::2]
        c, d, cd = end[2::2], end[:-2:2], end[1::2]
        if share[1] > 0:
            cells = np.vstack([cells, np.array([a, b, c, middle[2::2], middle[1::2], ab]).T])
            cells = np.vstack([cells, np.array([a, c, d, cd, middle[:-2:2], middle[1::2]]).T])
        else:
            cells = np.vstack([cells, np.array([a, b, c, middle[2::2], middle[:-2:2], ab]).T])
        last = end
    return points, cells.astype(np.int64)


MESHES = {"cylinder": quarter, "truncated-hertz": block}


def height(case, radius, x):
    """Height of the undeformed candidates above y = 0 [mm], numbers or arrays."""
    return radius - np.sqrt(radius**2 - x**2) if case == "cylinder" else 0 * x


def on_edges(body, u, spring):
    """Places and pressures at the two integration points of each candidate edge, in the order of x."""
    nodes, radius = body.space.tabulate_dof_coordinates(), body.radius
    near = np.flatnonzero(nodes[:, 0] <= body.reach * (1 + 1e-9))
    on = near[np.abs(nodes[near, 1] - height(body.case, radius, nodes[near, 0])) < 1e-9 * radius]
    on = on[np.argsort(nodes[on, 0])]
    table = np.array([nodes[on, 0], u.x.array[1::2][on]])
    xi = np.array([-1, 1]) / np.sqrt(3)
    shape = np.array([xi * (xi - 1) / 2, 1 - xi**2, xi * (xi + 1) / 2])
    x, v = np.einsum("cie,iq->ceq", np.array([table[:, :-2:2], table[:, 1::2], table[:, 2::2]]).swapaxes(0, 1), shape)
    gap = x**2 / (2 * radius) if body.case == "truncated-hertz" else height(body.case, radius, x)
    return x, spring * np.maximum(-v - gap, 0)


def means(x, pressure, stations):
    """Means over equal stretches round the stations, the pressure linear between the integration points [MPa]."""
    fine = stations[:, None] + (stations[1] - stations[0]) * (np.arange(100) - 49.5) / 100
    return np.interp(fine, x.ravel(), pressure.ravel()).mean(axis=1)


def peak(x, pressure, half_width):
    """Value at 0 of the even sextic whose edge means are nearest to those of the pressure on the inner half of the contact [MPa]."""
    near = x.mean(axis=1) < 0.5 * half_width
    terms = np.array([((x[near] / half_width) ** k).mean(axis=1) for k in (0, 2, 4, 6)]).T
    return np.linalg.lstsq(terms, pressure[near].mean(axis=1), rcond=None)[0][0]
