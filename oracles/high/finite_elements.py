"""Contacts of a cylinder and of pins by NGSolve: curved cells of high order, a mesh vertex at the end of the contact, Lagrange multipliers.

Cells crowd towards the end of the contact, re-entrant corners and forces at points. Between the middle and the end the gap is closed against
polynomials on the edges of the first body, which are the pressure; both sides are integrated over the parts that the vertices of both cut. The
end is sought until the opening beyond it does not begin as a root, which is its stress intensity. Units mm, N, MPa, rad.
"""

import pathlib
import sys

import numpy as np
from numpy.polynomial import Chebyshev, Legendre, legendre
from scipy.sparse import bmat, csc_matrix, csr_matrix
from scipy.sparse.linalg import splu

# NGSolve is there where oracles/peers/setup.sh has put it.
sys.path.extend(map(str, pathlib.Path(__file__).resolve().parents[1].glob(".python/ngsolve/**/dist-packages")))
import ngsolve as ng
from netgen.geom2d import SplineGeometry

ng.SetNumThreads(1)
STEPS, SAME = 20, 1e-9  # of the secant: most steps, and a change of the end over the end
FACTOR = 0.15  # by which cells shrink towards a singular point
TERMS, REACH = 8, 0.3  # of the opening beyond the end over the root: powers, and how far it is read, over the end
SOUND = 1e-6  # part of the largest mean pressure of an edge, or of the largest opening, that one may be of the other sign

MIDDLE = 1e-3  # of the end: where a peak is in the middle


class Outline:
    """Straight and circular pieces of an outline, the body on their left."""

    def __init__(self):
        self.geometry, self.points = SplineGeometry(), {}

    def point(self, z, singular=False):
        """Number of a point; cells crowd towards it where it is singular."""
        key = round(z.real, 11) + 0.0, round(z.imag, 11) + 0.0
        if key not in self.points:
            self.points[key] = self.geometry.AppendPoint(z.real, z.imag, hpref=float(singular))
        return self.points[key]

    def line(self, a, b, name):
        """A straight piece."""
        self.geometry.Append(["line", self.point(a), self.point(b)], bc=name)

    def arc(self, radius, begin, end, name, size=1e9):
        """A piece of a circle about the origin between angles from the downward vertical, in parts of a right angle at most."""
        angles = np.linspace(begin, end, 1 + int(np.ceil(abs(end - begin) / (0.5 * np.pi) - 1e-9)))
        for a, b in zip(angles, angles[1:]):
            pole = bottom(radius / np.cos(0.5 * (b - a)), 0.5 * (a + b))  # where its tangents meet
            spline = [self.point(bottom(radius, a)), self.geometry.AppendPoint(pole.real, pole.imag), self.point(bottom(radius, b))]
            self.geometry.Append(["spline3", *spline], bc=name, maxh=size)


def bottom(radius, angle):
    """A point of a circle about the origin by its angle from the downward vertical."""
    return -1j * radius * np.exp(1j * angle)


class Body:
    """A body on its mesh: stiffness of its free displacements without those of the insides of cells; how the contact coordinate follows from a place."""

    def __init__(self, outline, mesh, lame, fixed_x, fixed_y, coordinate, size=1e9):
        order, layers, _ = mesh
        self.mesh, self.coordinate = ng.Mesh(outline.geometry.GenerateMesh(maxh=size, grading=0.4)), coordinate
        self.mesh.RefineHP(levels=layers, factor=FACTOR)
        self.mesh.Curve(order)
        self.scalar = ng.H1(self.mesh, order=order)
        self.space = ng.H1(self.mesh, order=order, dirichlet=fixed_x) * ng.H1(self.mesh, order=order, dirichlet=fixed_y)
        (u, v), (p, q) = ((ng.grad(f) for f in functions) for functions in self.space.TnT())
        bulk, shear = lame
        form = ng.BilinearForm(self.space, symmetric=True, condense=True)
        normal = (bulk + 2 * shear) * (u[0] * p[0] + v[1] * q[1]) + bulk * (u[0] * q[1] + v[1] * p[0])
        form += (normal + shear * (u[1] + v[0]) * (p[1] + q[0])) * ng.dx(bonus_intorder=4)
        value, column, start = form.Assemble().mat.CSR()
        whole = csr_matrix((np.array(value), np.array(column), np.array(start)), (self.space.ndof, self.space.ndof))
        free = np.flatnonzero(list(self.space.FreeDofs(True)))
        self.number = np.full(self.space.ndof, -1)
        self.number[free] = np.arange(len(free))
        self.stiffness, self.load = whole[free][:, free], np.zeros(len(free))
        edges = []
        for edge in self.mesh.Boundaries("contact|beyond").Elements():
            along = self.mesh.GetTrafo(edge)
            place = Chebyshev.interpolate(lambda x: np.array([complex(*along(t, 0.0).point) for t in x]), order, [0, 1])
            edges.append((*sorted(coordinate(place(np.array([0.0, 1.0])))), edge, place))
        self.edges = sorted(edges, key=lambda edge: edge[0])  # begin, end, edge, and the place along it

    def pulled(self, form):
        """Adds a load: a linear form of the vertical displacement."""
        linear = ng.LinearForm(self.space)
        linear += form(self.space.TestFunction()[1])
        self.load += linear.Assemble().vec.FV().NumPy()[self.number >= 0]

    def rows(self, normal, places):
        """Displacements along the normal at contact coordinates by the free ones; a sparse matrix."""
        owner = np.clip(np.searchsorted([edge[0] for edge in self.edges], places, side="right") - 1, 0, None)
        parts = []
        for k, (s, own) in enumerate(zip(places, owner)):
            _, _, edge, place = self.edges[own]
            shape, dofs, n = np.array(self.scalar.GetFE(edge).CalcShape(self.local(place, s))), np.array(self.scalar.GetDofNrs(edge)), normal(s)
            for number, part in (self.number[dofs], n.real), (self.number[dofs + self.scalar.ndof], n.imag):
                parts += [(part * value, k, column) for value, column in zip(shape, number) if column >= 0]
        value, row, column = zip(*parts)
        return csr_matrix((value, (row, column)), (len(places), len(self.load)))

    def local(self, place, s):
        """The local coordinate of an edge at a contact coordinate, by a secant."""
        last, x = 0.0, 0.5
        before = self.coordinate(place(last))
        for _ in range(30):
            now = self.coordinate(place(x))
            if now == before:
                break
            last, x, before = x, x + (s - now) * (x - last) / (now - before), now
        return x


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
    order, layers, fine = mesh
    radius, young, nu = numbers["radius"], numbers["young"], numbers["poisson"]
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
    order, layers, fine = mesh
    radius, c, load = numbers["pin_radius"], numbers["clearance"], numbers["force"] / numbers["thickness"]
    hole, beyond, size = radius + c, 1.4 * end, radius * end / fine
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


def solve(scene, mesh, guess=None):
    """The numbers of a scene on a mesh: order, layers, and edges along the contact."""
    numbers, case, order = scene["numbers"], scene["case"], mesh[0]
    if case.startswith("cylinder"):
        made, first = lambda end: cylinder(numbers, end, mesh, case == "cylinder-between-plates"), numbers["a_over_r"] * numbers["radius"]
    else:
        made, first = lambda end: pins(numbers, end, mesh, case == "pin-rod"), np.pi / 3
    ends, roots = [], []
    for step in range(STEPS):
        end = (guess or first) * (1 + 1e-4 * step) if step < 2 else ends[-1] - roots[-1] * (ends[-1] - ends[-2]) / (roots[-1] - roots[-2])
        contact = made(end)
        pressures, integral, approach, root, opening = contact.close(end, order)
        ends, roots = ends + [end], roots + [root]
        if step > 1 and abs(ends[-1] - ends[-2]) <= SAME * end:
            break
    else:
        raise RuntimeError(f"the end of the contact still moves after {STEPS} steps: {ends[-2:]}")
    found = measures(pressures, end) | {"approach": approach}
    places, weights = integral
    pressure = np.concatenate([own(places[(places > a) & (places < b)]) for own, (a, b) in ((own, own.domain) for own in pressures)])
    means = np.array([own.coef[0] for own in pressures])
    if not (means.min() > -SOUND * means.max() and opening.min() > -SOUND * opening.max()):
        raise RuntimeError(f"pressures from {means.min()}, openings from {opening.min()}: not a contact")
    if not case.startswith("cylinder"):
        found["force across the load, of one half"] = weights @ (pressure * np.sin(places))
    if case == "pin-plate":
        del found["approach"]  # of a point where a force acts
    found["second-moment-width"] = 2 * np.sqrt(weights @ (pressure * places**2) / (weights @ pressure))
    return {name: float(value) for name, value in found.items()}


def measures(pressures, end):
    """Pressures, their largest, where that is but in the middle, and the end."""
    best = (-np.inf, 0.0)
    for own in pressures:
        inside = [float(s.real) for s in own.deriv().roots() if abs(s.imag) < 1e-9 and own.domain[0] < s.real < own.domain[1]]
        best = max([best] + [(own(s), s) for s in [*own.domain, *inside]])
    found = {"pressure at s = 0": pressures[0](0.0), "peak-pressure": best[0], "end": end}
    return found | ({"peak-place": best[1]} if best[1] > MIDDLE * end else {})
