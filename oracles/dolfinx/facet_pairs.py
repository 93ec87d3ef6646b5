"""Frictionless contact of two curved bodies as a user of FEniCSx may write it: a penalty in UFL on `dS` over pairs of facets.

F(u; v) = int sigma(u):eps(v) dx + int k_n <w - g>+ (v('+') - v('-')).n dS - f.v, w = (u('+') - u('-')).n the approach of pin '+' and hole '-'
along the pin's outward normal n, g the gap along n. The bodies are one mesh without a common node, dS runs over pairs (cell, facet, cell, facet)
of edges that face one another: of dolfinx 0.11, 0.5.2 couples no such pairs. Plane stress, per unit of thickness. Units mm, N, MPa, rad.
k_n = KAPPA E*/R, 1/E* the sum of 1/E: the bodies enter one another by p/k_n.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

from mpi4py import MPI  # before PETSc, which would otherwise start it with fewer threads allowed

import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from dolfinx.mesh import compute_midpoints, create_mesh, locate_entities_boundary
from petsc4py import PETSc

import fan
import pins
from pins import angle
from ufl_penalty import KAPPA, QUADRATIC, SETTLED, STEPS, direct

PIN, BODY, CANDIDATES = 1, 2, 3  # tags of cells, and of the pairs
POINTS = np.array([-1, 1]) / np.sqrt(3)  # two an edge: more would over-constrain it, and the pressure oscillate


def solve(scene, level, method="pairs"):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and dofs of a scene on the mesh of a level."""
    if method != "pairs":
        raise ValueError(f"method {method!r}: dolfinx serves 'pairs'")
    if scene["case"] not in ("pin-rod", "pin-plate"):
        raise ValueError(f"case {scene['case']!r}: use one of pin-rod, pin-plate")
    bodies = Bodies(scene, level)
    u = newton(bodies)
    return measures(bodies, u, np.asarray(scene["stations"]))


class Bodies:
    """Mesh of both, spaces and numbers of a scene; the symbols of the forms are constants, so that these are compiled once."""

    def __init__(self, scene, level):
        self.scene = scene
        (first, pin), (second, body) = pins.pin(scene, level), pins.body(scene, level)
        # Points of integration run along a facet from its lower vertex to the higher: with the cells so, both arcs are numbered downwards.
        cells = np.vstack([pin, body + len(first)])[::-1, [0, 2, 1, 3, 5, 4]]
        self.mesh = create_mesh(MPI.COMM_SELF, cells, ufl.Mesh(QUADRATIC), np.vstack([first, second]))
        self.space = fem.functionspace(self.mesh, QUADRATIC)
        is_pin = self.mesh.topology.original_cell_index >= len(body)
        self.cells = [(PIN, np.flatnonzero(is_pin).astype(np.int32)), (BODY, np.flatnonzero(~is_pin).astype(np.int32))]
        self.radius, self.hole = scene["pin_radius"], scene["pin_radius"] + scene["clearance"]
        self.pairs = np.hstack([self.facets(self.on_pin), self.facets(self.on_hole)]).ravel()
        young, poisson = ([scene.get(f"{body}_{name}", scene.get(name)) for body in ("pin", "rod")] for name in ("young", "poisson"))
        self.spring = KAPPA / (self.radius * sum(1 / one for one in young))
        names = {"radius": self.radius, "hole": self.hole, "up": scene["clearance"], "spring": self.spring}
        self.of = {name: self.constant(value) for name, value in names.items()}
        self.of |= {"young": [self.constant(value) for value in young], "poisson": [self.constant(value) for value in poisson]}
        apart = self.outward("+") - self.outward("-")
        # The square of the distance of points that shall face one another, over the radius.
        if fem.assemble_scalar(fem.form(ufl.dot(apart, apart) * self.contact())) > 1e-9 * self.radius:
            raise RuntimeError("points of integration do not face one another: list the cells so that both arcs are numbered alike")

    def constant(self, value):
        """A number that the compiled form does not know."""
        return fem.Constant(self.mesh, PETSc.ScalarType(value))

    def on_pin(self, x):
        """Candidates of the pin."""
        return (np.abs(np.hypot(x[0], x[1]) - self.radius) < 1e-9 * self.radius) & self.near(x)

    def on_hole(self, x):
        """Candidates of the hole."""
        return (np.abs(np.hypot(x[0], x[1] - self.scene["clearance"]) - self.hole) < 1e-9 * self.radius) & self.near(x)

    def near(self, x):
        """As far as contact may reach."""
        return angle(x) < self.scene["stretch"] + 1e-9

    def facets(self, holds):
        """Cell and local number of the boundary's facets where it holds, upwards."""
        topology = self.mesh.topology
        topology.create_connectivity(1, 2)
        found = locate_entities_boundary(self.mesh, 1, holds)
        found = found[np.argsort(angle(compute_midpoints(self.mesh, 1, found).T))]
        return fem.compute_integration_domains(fem.IntegralType.exterior_facet, topology, found).reshape(-1, 2)

    def contact(self):
        """Measure of the pairs."""
        return ufl.Measure("dS", self.mesh, subdomain_data=[(CANDIDATES, self.pairs)], metadata={"quadrature_degree": 3})(CANDIDATES)

    def outward(self, side="+"):
        """Normal of the pin at the points of integration, on the ray from (0, 0)."""
        place = ufl.SpatialCoordinate(self.mesh)(side)
        return place / ufl.sqrt(ufl.dot(place, place))

    def pressure(self, u):
        """p = k_n <w - g>+ [MPa]."""
        n, radius, hole, up = self.outward(), self.of["radius"], self.of["hole"], self.of["up"]
        gap = up * n[1] + ufl.sqrt(hole**2 - (up * n[0]) ** 2) - radius
        overlap = ufl.dot(u("+") - u("-"), n) - gap
        return self.of["spring"] * ufl.conditional(ufl.gt(overlap, 0), overlap, 0)

    def residual(self, u):
        """F(u; v) but for the force."""
        v = ufl.TestFunction(self.space)
        within = ufl.Measure("dx", self.mesh, subdomain_data=self.cells, metadata={"quadrature_degree": 6})
        strain, form = ufl.sym(ufl.grad(u)), self.pressure(u) * ufl.dot(v("+") - v("-"), self.outward()) * self.contact()
        for tag, young, poisson in zip((PIN, BODY), self.of["young"], self.of["poisson"]):
            stress = young / (1 + poisson) * strain + young * poisson / (1 - poisson**2) * ufl.tr(strain) * ufl.Identity(2)
            form += ufl.inner(stress, ufl.sym(ufl.grad(v))) * within(tag)
        return form

    def motions(self):
        """Matrix T of u = T q, and the forces on q: fixed dofs have no column, those of the rigid face share one."""
        x = self.space.tabulate_dof_coordinates().T
        pin, force = np.zeros(x.shape[1], bool), 0.5 * self.scene["force"] / self.scene["thickness"]
        pin[self.space.dofmap.list[self.cells[0][1]]] = True
        column = np.arange(2 * x.shape[1]).reshape(-1, 2)
        fixed = np.column_stack([np.abs(x[0]) < 1e-9, np.zeros(x.shape[1], bool)])
        if self.scene["case"] == "pin-rod":
            face = x[1] > self.scene["clearance"] + self.scene["shank_end"] - 1e-9
            fixed[:, 1] |= pin & (np.abs(x[1]) < 1e-9)
            column[face, 1] = loaded = column[face, 1].min()
        else:
            fixed[np.hypot(x[0], x[1] - self.scene["clearance"]) > self.scene["rim_radius"] * (1 - 1e-9)] = True
            loaded, force = column[pin & (np.hypot(x[0], x[1]) < 1e-9), 1][0], -force
        kept = np.flatnonzero(~fixed.ravel())
        used, place = np.unique(column.ravel()[kept], return_inverse=True)
        starts = np.concatenate([[0], np.cumsum(~fixed.ravel())]).astype(np.int32)
        matrix = PETSc.Mat().createAIJ((column.size, len(used)), csr=(starts, place.astype(np.int32), np.ones(len(kept))))
        return matrix, force * (used == loaded)

    def start(self):
        """Pin or hole moved so that they touch well beyond the contact; from u = 0 the tangent would be singular."""
        u = fem.Function(self.space)
        moves, by = (1, 1.8) if self.scene["case"] == "pin-rod" else (0, -1.8)
        u.x.array[2 * self.space.dofmap.list[self.cells[moves][1]].ravel() + 1] = by * self.scene["clearance"]
        return u


def newton(bodies):
    """Displacement where F vanishes."""
    u, (motions, force) = bodies.start(), bodies.motions()
    form = bodies.residual(u)
    residual, tangent = fem.form(form), fem.form(ufl.derivative(form, u))
    for _ in range(STEPS):
        matrix = petsc.assemble_matrix(tangent)
        matrix.assemble()
        out_of_balance, left = petsc.assemble_vector(residual), motions.createVecRight()
        motions.multTranspose(out_of_balance, left)
        left.array[:] -= force
        moved = motions.createVecRight()
        moved.array[:] = direct(matrix.PtAP(motions), left)
        change = (motions * moved).array
        u.x.array[:] -= change
        if np.abs(change).max() <= SETTLED * np.abs(u.x.array).max():
            return u
    raise RuntimeError(f"{bodies.scene['case']}: Newton has not ended after {STEPS} iterations; lower KAPPA")


def on_edges(bodies, u):
    """Angles and pressures at the two integration points of each candidate edge, upwards."""
    x = bodies.space.tabulate_dof_coordinates().T
    up, count = bodies.scene["clearance"], len(bodies.pairs) // 2 + 1
    tables = []
    for on in (bodies.on_pin(x), bodies.on_hole(x)):
        nodes = np.flatnonzero(on)
        # The lowest nodes of both are in one place.
        nodes = nodes[np.isin(nodes, bodies.space.dofmap.list[bodies.cells[len(tables)][1]])]
        nodes = nodes[np.argsort(angle(x[:, nodes]))][:count]
        tables.append(np.vstack([x[:2, nodes], u.x.array.reshape(-1, 2)[nodes].T]))
    shape = np.array([POINTS * (POINTS - 1) / 2, 1 - POINTS**2, POINTS * (POINTS + 1) / 2])
    pin, hole = (np.einsum("cie,iq->ceq", np.array([t[:, :-2:2], t[:, 1::2], t[:, 2::2]]).swapaxes(0, 1), shape) for t in tables)
    n = pin[:2] / np.hypot(*pin[:2])
    gap = up * n[1] + np.sqrt(bodies.hole**2 - (up * n[0]) ** 2) - bodies.radius
    return angle(n), bodies.spring * np.maximum(((pin[2:] - hole[2:]) * n).sum(axis=0) - gap, 0)


def measures(bodies, u, stations):
    """The quantities that are asked for: integrals of the pressure in UFL, the rest from its values on the edges."""
    n, p = bodies.outward(), bodies.pressure(u)
    theta = ufl.atan2(n[0], -n[1])
    total, second, lift = (fem.assemble_scalar(fem.form(f * bodies.contact())) for f in (p, p * theta**2, -p * n[1]))
    half_width = 2 * np.sqrt(second / total)
    places, pressure = on_edges(bodies, u)
    if pressure[-1].max() > 0:
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    return {
        "half_width": float(half_width),
        "peak": float(pins.peak(places, pressure, half_width)),
        "resultant": float(2 * bodies.scene["thickness"] * lift),
        "pressure": fan.means(places, pressure, stations),
        "dofs": int(2 * bodies.space.dofmap.index_map.size_global),
    }
