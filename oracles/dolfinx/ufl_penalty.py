"""Frictionless contact of one body with a rigid plane as a user of FEniCSx would write it: a penalty in UFL.

F(u; v) = int sigma(u):eps(v) dx - int t.v ds + int k_n <w - g>+ w(v) |n_y| ds,  w(u) = -u_y the approach, g the gap;
its derivative by UFL, Newton's iteration here, MUMPS. Curved quadratic triangles, made here. Units mm, N, MPa. For dolfinx 0.5 to 0.11.
Pins in holes are served by facet_pairs.py: dolfinx 0.5.2 couples no facets of two bodies.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

from mpi4py import MPI  # before PETSc, which would otherwise start it with fewer threads allowed

import inspect

import dolfinx
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from dolfinx.mesh import create_mesh, locate_entities_boundary, meshtags
from petsc4py import PETSc

import fan

KAPPA = 1e4  # k_n = KAPPA E*/a: a softer spring costs more, with a harder one Newton cycles
STEPS = 60
SETTLED = 1e-10  # largest change of a displacement over the largest one, from which on Newton has ended
# The same element everywhere, so that the compiled forms are found again.
if hasattr(ufl, "VectorElement"):
    QUADRATIC = ufl.VectorElement("Lagrange", ufl.triangle, 2, variant="equispaced")
else:  # dolfinx 0.7 or later
    import basix.ufl

    QUADRATIC = basix.ufl.element("Lagrange", "triangle", 2, lagrange_variant=basix.LagrangeVariant.equispaced, shape=(2,))
CANDIDATES, FIRST, SECOND = 1, 2, 3  # tags of the boundary: contact, and the loaded sides


def version():
    """Of dolfinx."""
    return dolfinx.__version__


def solve(scene, level, method="penalty"):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and dofs of a scene on the mesh of a level."""
    if method != "penalty":
        raise ValueError(f"method {method!r}: dolfinx serves 'penalty'")
    if scene["case"] not in fan.MESHES:
        raise ValueError(f"case {scene['case']!r}: use one of {', '.join(fan.MESHES)}")
    body = Body(scene, level)
    u = newton(body)
    return measures(body, u, np.asarray(scene["stations"]))


class Body:
    """Mesh, spaces and numbers of a scene; the symbols of its forms are constants, so that these are compiled once."""

    def __init__(self, scene, level):
        self.case, self.radius = scene["case"], scene["radius"]
        self.half_width = scene["a_over_r"] * self.radius
        modulus = scene["young"] / (1 - scene["poisson"] ** 2)
        load = np.pi * self.half_width**2 * modulus / (4 * self.radius)
        points, cells, sides = fan.MESHES[self.case](scene, level)
        # From dolfinx 0.10 on the element goes before the points.
        order = list(inspect.signature(create_mesh).parameters)[2:4]
        self.mesh = create_mesh(MPI.COMM_SELF, cells, *(points if name == "x" else ufl.Mesh(QUADRATIC) for name in order))
        self.space = (fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace)(self.mesh, QUADRATIC)
        self.reach = scene["stretch"] * self.half_width
        found = [locate_entities_boundary(self.mesh, 1, holds) for holds in sides]
        values = np.concatenate([np.full(len(f), k + 1, np.int32) for k, f in enumerate(found)])
        facets = np.concatenate(found)
        order = np.argsort(facets)
        self.tags = meshtags(self.mesh, 1, facets[order], values[order])
        names = {"young": scene["young"], "poisson": scene["poisson"], "radius": self.radius, "half_width": self.half_width,
                 "spring": KAPPA * modulus / self.half_width, "load": load}
        self.of = {name: fem.Constant(self.mesh, PETSc.ScalarType(value)) for name, value in names.items()}
        axis = fem.locate_dofs_geometrical((self.space.sub(0), self.space.sub(0).collapse()[0]), lambda x: x[0] < 1e-9)
        zero = fem.Function(self.space.sub(0).collapse()[0])
        self.held = [fem.dirichletbc(zero, axis, self.space.sub(0))]

    def ds(self, tag, degree):
        """Measure of a tagged part of the boundary."""
        return ufl.Measure("ds", self.mesh, subdomain_data=self.tags, metadata={"quadrature_degree": degree})(tag)

    def contact(self):
        """Measure of the candidates; two points an edge: more would over-constrain it, and the pressure oscillate."""
        return self.ds(CANDIDATES, 3)

    def pressure(self, u):
        """p = k_n <w - g>+ [MPa]."""
        x = ufl.SpatialCoordinate(self.mesh)[0]
        radius = self.of["radius"]
        gap = x**2 / (2 * radius) if self.case == "truncated-hertz" else radius - ufl.sqrt(radius**2 - x**2)
        overlap = -u[1] - gap
        return self.of["spring"] * ufl.conditional(ufl.gt(overlap, 0), overlap, 0)

    def share(self):
        """Area of the plane below over the area of the body, |n_y|."""
        return abs(ufl.FacetNormal(self.mesh)[1])

    def residual(self, u):
        """F(u; v)."""
        v = ufl.TestFunction(self.space)
        young, poisson = self.of["young"], self.of["poisson"]
        shear, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
        strain = ufl.sym(ufl.grad(u))
        stress = 2 * shear * strain + lame * ufl.tr(strain) * ufl.Identity(2)
        inside = ufl.inner(stress, ufl.sym(ufl.grad(v))) * ufl.dx(metadata={"quadrature_degree": 6})
        return inside + self.pressure(u) * -v[1] * self.share() * self.contact() - self.loads(v)

    def loads(self, v):
        """Work of the tractions: uniform on the cylinder's cut, those of Hertz's half-plane on the block's sides."""
        if self.case == "cylinder":
            return -self.of["load"] / (2 * self.of["radius"]) * v[1] * self.ds(FIRST, 4)
        across, along, shear = self.half_plane()
        return (across * v[0] + shear * v[1]) * self.ds(FIRST, 12) + (shear * v[0] + along * v[1]) * self.ds(SECOND, 12)

    def half_plane(self):
        """(sigma_x, sigma_y, tau_xy) below Hertz's pressure on y = 0, x >= 0 (Johnson 1985, eq. 4.49)."""
        x, y = ufl.SpatialCoordinate(self.mesh)
        a = self.of["half_width"]
        inner = a**2 - x**2 + y**2
        root = ufl.sqrt(inner**2 + 4 * x**2 * y**2)
        m, n = ufl.sqrt((root + inner) / 2), ufl.sqrt(abs(root - inner) / 2)
        q, scale = (y**2 + n**2) / (m**2 + n**2), -2 * self.of["load"] / (ufl.pi * a) / a
        return scale * (m * (1 + q) - 2 * y), scale * m * (1 - q), scale * n * (m**2 - y**2) / (m**2 + n**2)


def newton(body):
    """Displacement where F vanishes. Started touching well beyond the contact: from u = 0 the tangent would be singular."""
    u = fem.Function(body.space)
    u.x.array[1::2] = -((1.5 * body.half_width) ** 2) / (2 * body.radius)
    vector = u.x.petsc_vec if hasattr(u.x, "petsc_vec") else u.vector  # the latter up to dolfinx 0.8
    form = body.residual(u)
    residual, tangent = fem.form(form), fem.form(ufl.derivative(form, u))
    for _ in range(STEPS):
        matrix = petsc.assemble_matrix(tangent, body.held)
        matrix.assemble()
        force = petsc.assemble_vector(residual)
        petsc.apply_lifting(force, [tangent], [body.held], [vector], -1.0)
        petsc.set_bc(force, body.held, vector, -1.0)
        change = direct(matrix, force)
        u.x.array[:] -= change
        if np.abs(change).max() <= SETTLED * np.abs(u.x.array).max():
            return u
    raise RuntimeError(f"{body.case}: Newton has not ended after {STEPS} iterations; lower KAPPA")


def direct(matrix, force):
    """Solution by MUMPS."""
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    solution = matrix.createVecRight()
    solver.solve(force, solution)
    return solution.array.copy()


def measures(body, u, stations):
    """The quantities that are asked for: integrals of the pressure in UFL, the rest from its values on the edges."""
    x, p = ufl.SpatialCoordinate(body.mesh)[0], body.pressure(u)
    total, second = (fem.assemble_scalar(fem.form(f * body.share() * body.contact())) for f in (p, p * x**2))
    half_width = 2 * np.sqrt(second / total)
    places, pressure = fan.on_edges(body, u, float(body.of["spring"].value))
    if pressure[-1].max() > 0:
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    return {
        "half_width": float(half_width),
        "peak": float(fan.peak(places, pressure, half_width)),
        "resultant": float(2 * total),
        "pressure": fan.means(places, pressure, stations),
        "dofs": int(2 * body.space.dofmap.index_map.size_global),
    }
