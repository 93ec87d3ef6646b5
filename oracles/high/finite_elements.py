"""Contacts of a cylinder and of pins by NGSolve: a mesh vertex at the end of the contact, and Lagrange multipliers.

Between the middle and the end the gap is closed against polynomials on the edges of the first body, which are the pressure; both sides are
integrated over the parts that the vertices of both cut. The end is sought until the opening beyond it does not begin as a root, which is its
stress intensity. Units mm, N, MPa, rad.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/high/freeze.py, which imports this module")

import numpy as np
from numpy.polynomial import Legendre, legendre
from scipy.sparse import bmat, csc_matrix, csr_matrix
from scipy.sparse.linalg import splu

from curved_cells import Body, Outline, bottom, ng

STEPS, SAME = 20, 1e-9  # of the secant: most steps, and a change of the end over the end
TERMS, REACH = 8, 0.3  # of the opening beyond the end over the root: powers, and how far it is read, over the end
SOUND = 1e-6  # part of the largest mean pressure of an edge, or of the largest opening, that one may be of the other sign
MIDDLE = 1e-3  # of the end: where a peak is in the middle
ACROSS = "force across the load, of one half"


class Contact:
    """Two bodies, or one and a rigid profile: normal, initial gap, length per coordinate, part of the pressure that carries the load; a rigid
    approach under the load, where loads of the bodies do not make it."""

    def __init__(self, bodies, normal, gap, length, carrying, approach, load):
        self.bodies, self.normal, self.gap, self.length, self.carrying = bodies, normal, gap, length, carrying
        self.approach, self.load = float(approach), load

    def close(self, end, order):
        """Pressures as polynomials, edge by edge; integrals of theirs; the approach; and the coefficient of the root in the opening beyond."""
        edges = [edge[:2] for edge in self.bodies[0].edges if edge[1] <= end * (1 + 1e-9)]
        cuts = np.sort([s for body in self.bodies for edge in body.edges for s in edge[:2] if s <= end * (1 + 1e-9)])
        cuts = cuts[np.append(True, np.diff(cuts) > 1e-10 * end)]
        x, w = legendre.leggauss(order + 6)
        places = (cuts[:-1, None] + 0.5 * np.diff(cuts)[:, None] * (1 + x)).ravel()
        weights = self.length * (0.5 * np.diff(cuts)[:, None] * w).ravel()
        tests = []
        for begin, finish in edges:
            inside = (places > begin) & (places < finish)
            tests += list((legendre.legvander(2 * (places - begin) / (finish - begin) - 1, order - 2) * (inside * weights)[:, None]).T)
        tests = csr_matrix(np.array(tests))
        signs, carried = [1, -1][: len(self.bodies)], csr_matrix(tests @ self.carrying(places)[:, None])
        rows = bmat([[sign * (tests @ body.rows(self.normal, places)) for sign, body in zip(signs, self.bodies)]])
        stiffness = bmat([[body.stiffness if own is body else None for own in self.bodies] for body in self.bodies])
        tied = csr_matrix([[1.0 - self.approach]])
        matrix = csc_matrix(bmat([[stiffness, rows.T, None], [rows, None, self.approach * carried], [None, self.approach * carried.T, tied]]))
        right = np.concatenate([body.load for body in self.bodies] + [tests @ self.gap(places), [self.approach * self.load]])
        factor = splu(matrix)
        found = factor.solve(right)
        found += factor.solve(right - matrix @ found)
        moved, multipliers, approach = np.split(found, [rows.shape[1], len(found) - 1])
        pressures = [Legendre(own, edge) for own, edge in zip(multipliers.reshape(len(edges), -1), edges)]
        if not self.approach:  # of the load, as its work tells it
            approach = self.bodies[0].load @ moved[: len(self.bodies[0].load)] / self.load
        r = REACH * (0.5 - 0.5 * np.cos(np.pi * (np.arange(3 * TERMS) + 0.5) / (3 * TERMS)))
        beyond = end * (1 + r)
        rows = bmat([[sign * body.rows(self.normal, beyond) for sign, body in zip(signs, self.bodies)]])
        opening = self.gap(beyond) - self.approach * approach * self.carrying(beyond) - rows @ moved
        root = np.polynomial.polynomial.polyfit(r, opening / np.sqrt(r), TERMS - 1)[0]
        return pressures, (places, weights), float(np.squeeze(approach)), root, opening


def cylinder(numbers, end, mesh, flat):
    """The lower half of a disc on a rigid plane; its cut stays flat, or takes the load evenly."""
    radius, young, nu, fine = numbers["radius"], numbers["young"], numbers["poisson"], mesh[2]
    load = np.pi * (numbers["a_over_r"] * radius) ** 2 * young / (1 - nu**2) / (4 * radius)  # Hertz's
    outline, edge, beyond = Outline(), np.arcsin(end / radius), np.arcsin(2 * end / radius)
    outline.point(bottom(radius, edge), singular=True)
    outline.point(radius + 0j, singular=not flat)
    outline.line(0j, -1j * radius, "axis")
    outline.arc(radius, 0, edge, "contact", end / fine)
    outline.arc(radius, edge, beyond, "beyond", end / fine)
    outline.arc(radius, beyond, np.pi / 2, "free")
    outline.line(radius + 0j, 0j, "cut")
    lame = young * nu / (1 + nu) / (1 - 2 * nu), young / 2 / (1 + nu)  # plane strain
    body = Body(outline, mesh, lame, "axis", "cut" if flat else "", np.real, radius / 3)
    if not flat:
        body.pulled(lambda v: -load / (2 * radius) * v * ng.ds("cut"))
    gap = lambda s: radius - np.sqrt(radius**2 - s**2)
    return Contact([body], lambda s: -1j, gap, 1.0, np.ones_like, flat, load / 2)


def pins(numbers, end, mesh, rod):
    """A pin whose horizontal diameter is at rest, in the eye of a rod; or one that is pushed at its centre, in a plate."""
    radius, c, load = numbers["pin_radius"], numbers["clearance"], numbers["force"] / numbers["thickness"]
    hole, beyond, size = radius + c, 1.4 * end, radius * end / mesh[2]
    reach = lambda s: np.sqrt(hole**2 - (c * np.sin(s)) ** 2) - c * np.cos(s)  # to the hole, from the centre of the pin
    on_hole = lambda s: s and float(np.angle(reach(s) * np.exp(1j * s) + c))

    def lame(name):  # plane stress
        young, nu = numbers[name + "young"], numbers[name + "poisson"]
        return young * nu / (1 - nu**2), young / 2 / (1 + nu)

    outline, top = Outline(), np.pi / 2 if rod else np.pi
    outline.point(bottom(radius, end), singular=True)
    outline.point(0j, singular=not rod)
    outline.line(0j, -1j * radius, "axis")
    outline.arc(radius, 0, end, "contact", size)
    outline.arc(radius, end, beyond, "beyond", size)
    outline.arc(radius, beyond, top, "free")
    outline.line(bottom(radius, top), 0j, "cut" if rod else "axis")
    pin = Body(outline, mesh, lame("pin_" if rod else ""), "axis", "cut" if rod else "", lambda z: np.angle(1j * z), 0.3 * radius)
    outline = Outline()
    outline.point(bottom(hole, on_hole(end)), singular=True)
    if rod:
        far, half, top = numbers["eye_outer_radius"], numbers["shank_width"] / 2, 1j * numbers["shank_end"]
        notch, fixed, size_of_other = half + 1j * np.sqrt(far**2 - half**2), ("axis", "end"), 0.5 * half
        outline.point(notch, singular=True)
        outline.arc(far, 0, float(np.angle(1j * notch)), "free")
        outline.line(notch, half + top, "free")
        outline.line(half + top, top, "end")
    else:
        far, fixed, size_of_other = numbers["rim_radius"], ("axis|rim", "rim"), 1e9
        top = 1j * far
        outline.arc(far, 0, np.pi, "rim")
    outline.line(top, 1j * hole, "axis")
    outline.arc(hole, np.pi, on_hole(beyond), "free", 4 * size)
    outline.arc(hole, on_hole(beyond), on_hole(end), "beyond", size)
    outline.arc(hole, on_hole(end), 0, "contact", size)
    outline.line(-1j * hole, -1j * far, "axis")
    other = Body(outline, mesh, lame("rod_" if rod else ""), *fixed, lambda z: np.angle(1j * z - c), size_of_other)
    if not rod:
        centre = next(vertex.nr for vertex in pin.mesh.vertices if max(map(abs, vertex.point)) < 1e-9)
        pin.load[pin.number[pin.scalar.ndof + centre]] = -load / 2
    return Contact([pin, other], lambda s: bottom(1.0, s), lambda s: reach(s) - radius, radius, np.cos, rod, load / 2)


def solve(scene, mesh):
    """The numbers of a scene on a mesh: order, layers of cells towards singular points, and edges along the contact."""
    numbers, case = scene["numbers"], scene["case"]
    straight = case.startswith("cylinder")
    if straight:
        made, guess = lambda end: cylinder(numbers, end, mesh, case == "cylinder-between-plates"), numbers["a_over_r"] * numbers["radius"]
    else:
        made, guess = lambda end: pins(numbers, end, mesh, case == "pin-rod"), np.pi / 3
    ends, roots = [], []
    for step in range(STEPS):
        end = guess * (1 + 1e-4 * step) if step < 2 else ends[-1] - roots[-1] * (ends[-1] - ends[-2]) / (roots[-1] - roots[-2])
        pressures, integral, approach, root, opening = made(end).close(end, mesh[0])
        ends, roots = ends + [end], roots + [root]
        if step > 1 and abs(ends[-1] - ends[-2]) <= SAME * end:
            break
    else:
        raise RuntimeError(f"the end of the contact still moves after {STEPS} steps: {ends[-2:]}")
    means = np.array([own.coef[0] for own in pressures])
    if not (means.min() > -SOUND * means.max() and opening.min() > -SOUND * opening.max()):
        raise RuntimeError(f"pressures from {means.min()}, openings from {opening.min()}: not a contact")
    found = measures(pressures, integral, end) | ({} if case == "pin-plate" else {"approach": approach})  # a force acts where that one would be read
    if straight:
        del found[ACROSS]
    return {name: float(value) for name, value in found.items()}


def measures(pressures, integral, end):
    """The numbers of pressures, edge by edge, up to an end."""
    best = (-np.inf, 0.0)
    for own in pressures:
        inside = [float(s.real) for s in own.deriv().roots() if abs(s.imag) < 1e-9 and own.domain[0] < s.real < own.domain[1]]
        best = max([best] + [(own(s), s) for s in [*own.domain, *inside]])
    s, weights = integral
    force = weights * np.piecewise(s, [(s > own.domain[0]) & (s < own.domain[1]) for own in pressures], pressures)
    found = {"pressure at s = 0": pressures[0](0.0), "peak-pressure": best[0], "end": end, ACROSS: force @ np.sin(s)}
    found["second-moment-width"] = 2 * np.sqrt(force @ s**2 / force.sum())
    return found | ({"peak-place": best[1]} if best[1] > MIDDLE * end else {})
