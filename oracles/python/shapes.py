"""The shapes of the scenes as coarse triangulations with size functions.

Edges may be `finest + growth * distance from the contact` long: coarse where nothing happens. Lengths in mm,
angles from the downward vertical in rad.
"""

import numpy as np

from triangles import Circle, Line, graded

# At level 2 these give sixteen to forty-five thousand freedoms. Round the pins the finest edges are finer, so
# they grow faster, and fastest in the wide plate, up to sectors of 30 degrees.
PLANE_GROWTH, PIN_GROWTH, PLATE_GROWTH = 0.5, 0.8, 1.0


def grid(rows):
    """Points and triangles of rows of points (each row as long as the next), every second diagonal turned."""
    rows = np.array(rows, float)
    high, wide = rows.shape[:2]
    index = np.arange(high * wide).reshape(high, wide)
    triangles = []
    for i in range(high - 1):
        for j in range(wide - 1):
            a, b, c, d = index[i, j], index[i, j + 1], index[i + 1, j + 1], index[i + 1, j]
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return rows.reshape(-1, 2), triangles


def from_arc(circle, end, finest, growth):
    """Size function growing with the distance from an arc between the lowest point and the angle `end`."""

    def size(points):
        ray = points - circle.centre
        nearest = circle.at(np.clip(np.arctan2(ray[:, 0], -ray[:, 1]), 0.0, end))
        return finest + growth * np.linalg.norm(points - nearest, axis=1)

    return size


def rectangle(side, stretch, elements, level):
    """Square 0..side whose contact is on y = 0, with `elements` uniform edges on x = 0..stretch."""
    cells = int(np.ceil(side / stretch - 1e-9))
    far = np.linspace(stretch, side, cells) if cells > 1 else []
    stations = np.concatenate([[0.0, 0.5 * stretch], far])
    points, triangles = grid([[(x, y) for x in stations] for y in stations])
    curves = {"contact": Line(1, 0.0), "right": Line(0, side), "top": Line(1, side), "axis": Line(0, 0.0)}

    def size(points):
        away = np.hypot(np.maximum(points[:, 0] - stretch, 0.0), points[:, 1])
        return stretch / elements + PLANE_GROWTH * away

    return graded(points, triangles, curves, size, level)


def disc(circle, sweep, stretch, finest, level, growth=PIN_GROWTH, move=None):
    """Disc sector x >= 0 of 90 or 180 degrees from the lowest point; its centre is point 0."""
    parts = round(sweep / (np.pi / 4))
    points = np.vstack([[circle.centre], circle.at(np.linspace(0.0, sweep, parts + 1))])
    triangles = [(0, k, k + 1) for k in range(1, parts + 1)]
    curves = {"contact": circle, "axis": Line(0, circle.centre[0])}
    if parts == 2:
        curves["cut"] = Line(1, circle.centre[1])
    return graded(points, triangles, curves, from_arc(circle, stretch, finest, growth), level, move)


def lying_quarter(radius, stretch, elements, level):
    """Quarter disc on the plane y = 0, with `elements` edges of one horizontal length on x = 0..stretch.

    Bisection finds fractions 1/2^m of the right angle only; the nearest is moved to the wanted angle.
    """
    circle = Circle((0.0, radius), radius)
    end = np.arcsin(stretch / radius)
    found = np.pi / 2 / 2.0 ** round(np.log2(np.pi / 2 / end))

    def move(points):
        ray = points - circle.centre
        away, angle = np.hypot(ray[:, 0], ray[:, 1]), np.arctan2(ray[:, 0], -ray[:, 1])
        inside = np.arcsin(np.minimum(angle / found, 1.0) * stretch / radius)
        outside = end + (angle - found) / (np.pi / 2 - found) * (np.pi / 2 - end)
        moved = np.where(angle <= found, inside, outside)
        sine, cosine = np.sin(moved), np.where(np.isclose(moved, np.pi / 2), 0.0, np.cos(moved))
        return np.asarray(circle.centre) + away[:, None] * np.column_stack([sine, -cosine])

    return disc(circle, np.pi / 2, found, found * radius / elements, level, PLANE_GROWTH, move)


def ring(hole, rim_radius, stretch, finest, level):
    """Half ring x >= 0 between a hole and a concentric rim, coarse rows in geometric progression."""
    rows = round(np.log(rim_radius / hole.radius) / np.log(1.7)) + 1
    angles = np.linspace(0.0, np.pi, 7)
    radii = np.geomspace(rim_radius, hole.radius, rows)
    points, triangles = grid([Circle(hole.centre, r).at(angles) for r in radii])
    curves = {"contact": hole, "rim": Circle(hole.centre, rim_radius), "axis": Line(0, hole.centre[0])}
    return graded(points, triangles, curves, from_arc(hole, stretch, finest, PLATE_GROWTH), level)


def eye(hole, outer_radius, half_width, end, stretch, finest, level):
    """Half rod x >= 0: the disc round the hole joined with a shank whose flat end is `end` above the centre.

    The mesh is fine at the re-entrant corner between disc and shank, too: coarse there, it costs 0.1-0.3 % of
    the second-moment angle of the contact, however fine the contact itself.
    """
    outer = Circle(hole.centre, outer_radius)
    corner = np.pi - np.arcsin(half_width / outer_radius)
    sectors = max(2, round(corner / (np.pi / 6)))
    angles = np.append(np.linspace(0.0, corner, sectors + 1), np.pi)
    radii = np.linspace(outer_radius, hole.radius, 3)
    points, triangles = grid([Circle(hole.centre, r).at(angles) for r in radii])
    side, top = outer.at(np.array([corner, np.pi]))
    flat = hole.centre[1] + end
    rows = max(2, round((flat - side[1]) / half_width)) + 1
    right, left = np.linspace(side, (half_width, flat), rows), np.linspace(top, (0.0, flat), rows)
    shank, more = grid(np.stack([right, left], axis=1))
    # the first two points of the shank are the last two of the disc's outer row
    number = np.concatenate([[len(angles) - 2, len(angles) - 1], len(points) + np.arange(len(shank) - 2)])
    triangles = np.vstack([triangles, number[np.array(more)][:, ::-1]])
    points = np.vstack([points, shank[2:]])
    curves = {
        "contact": hole, "outer": outer, "shank": Line(0, half_width), "end": Line(1, flat),
        "axis": Line(0, hole.centre[0]),
    }
    contact = from_arc(hole, stretch, finest, PIN_GROWTH)

    def size(points):
        return np.minimum(contact(points), finest + PIN_GROWTH * np.linalg.norm(points - side, axis=1))

    return graded(points, triangles, curves, size, level)
