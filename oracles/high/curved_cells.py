"""Bodies of curved cells of high order in NGSolve, their cells crowding towards points where stresses are singular."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/high/freeze.py, which imports this module")

import pathlib
import sys

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.sparse import csr_matrix

# NGSolve is there where oracles/peers/setup.sh has put it.
sys.path.extend(map(str, pathlib.Path(__file__).resolve().parents[1].glob(".python/ngsolve/**/dist-packages")))
import ngsolve as ng
from netgen.geom2d import SplineGeometry

ng.SetNumThreads(1)
FACTOR = 0.15  # by which cells shrink towards a singular point


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
