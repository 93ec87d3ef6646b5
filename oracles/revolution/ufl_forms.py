"""Contact of bodies of revolution as a user of FEniCSx would write it: forms in UFL in (r, z), weighted by 2 pi r; for dolfinx 0.5 to 0.11.

F(u; v) = int [sigma(u):eps(v) + sigma_t u_r/r] 2 pi r dA - int t.v 2 pi r ds + int k_n <w - g>+ w(v) |n_z| 2 pi r ds, w(u) = -u_z the
approach, g the gap; its derivative by UFL, Newton's iteration here, MUMPS. A sphere on a rigid plane, loaded on its cut, and a block with
the tractions of Hertz's half-space on its other faces. Curved quadratic triangles. Units mm, N, MPa.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/revolution/freeze.py, which imports this module")

from mpi4py import MPI  # before PETSc, which would otherwise start it with fewer threads allowed

import inspect

import dolfinx
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from dolfinx.mesh import create_mesh, locate_entities_boundary, meshtags
from petsc4py import PETSc

KAPPA = 1e4  # k_n = KAPPA E*/a
ELEMENTS, GROWTH = 6, 1.5  # on the radius of the contact, level 0, and growth away from it
STEPS, SETTLED = 60, 1e-10  # of Newton; largest change over the largest displacement that ends it
CANDIDATES, FIRST, SECOND = 1, 2, 3  # tags of the boundary: contact, and the loaded sides
if hasattr(ufl, "VectorElement"):
    QUADRATIC = ufl.VectorElement("Lagrange", ufl.triangle, 2, variant="equispaced")
else:  # dolfinx 0.7 or later
    import basix.ufl

    QUADRATIC = basix.ufl.element("Lagrange", "triangle", 2, lagrange_variant=basix.LagrangeVariant.equispaced, shape=(2,))


def version():
    """Of dolfinx."""
    return dolfinx.__version__


def solve(scene, level, method="penalty"):
    """Contact radius, peak, resultant, mean pressures round scene["stations"], approach and dofs of a scene on the mesh of a level."""
    if method != "penalty" or scene["case"] not in MESHES:
        raise ValueError(f"{scene['case']!r} by {method!r}: use one of {', '.join(MESHES)} by 'penalty'")
    radius, young, poisson = scene["radius"], scene["young"], scene["poisson"]
    a, modulus = scene["a_over_r"] * radius, young / (1 - poisson**2)
    load, spring = 4 * modulus * a**3 / (3 * radius), KAPPA * modulus / a
    points, cells, sides = MESHES[scene["case"]](scene, level)
    # From dolfinx 0.10 on the element goes before the points.
    order = list(inspect.signature(create_mesh).parameters)[2:4]
    mesh = create_mesh(MPI.COMM_SELF, cells, *(points if name == "x" else ufl.Mesh(QUADRATIC) for name in order))
    space = (fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace)(mesh, QUADRATIC)
    found = [locate_entities_boundary(mesh, 1, holds) for holds in sides]
    facets, values = np.concatenate(found), np.repeat(np.arange(1, len(found) + 1, dtype=np.int32), [len(f) for f in found])
    tags = meshtags(mesh, 1, facets[np.argsort(facets)], values[np.argsort(facets)])
    of = {"young": young, "poisson": poisson, "R": radius, "a": a, "spring": spring, "load": load}
    of = {name: fem.Constant(mesh, PETSc.ScalarType(value)) for name, value in of.items()}
    u, v, x = fem.Function(space), ufl.TestFunction(space), ufl.SpatialCoordinate(mesh)

    def on(tag, degree, f):
        return 2 * ufl.pi * x[0] * f * ufl.Measure("ds", mesh, subdomain_data=tags, metadata={"quadrature_degree": degree})(tag)

    def on_contact(f):
        # Two points an edge: more would over-constrain it, and the pressure oscillate.
        return on(CANDIDATES, 3, abs(ufl.FacetNormal(mesh)[1]) * f)

    gap = of["R"] - ufl.sqrt(of["R"] ** 2 - x[0] ** 2) if scene["case"] == "sphere" else x[0] ** 2 / (2 * of["R"])
    pressure = of["spring"] * ufl.conditional(ufl.gt(-u[1] - gap, 0), -u[1] - gap, 0)
    form = elastic(u, v, x, of) - on_contact(pressure * v[1])
    if scene["case"] == "sphere":
        form += on(FIRST, 4, of["load"] / (ufl.pi * of["R"] ** 2) * v[1])
    else:
        radial, axial, shear = huber(x, of)
        form -= on(FIRST, 12, radial * v[0] + shear * v[1]) + on(SECOND, 12, shear * v[0] + axial * v[1])
    axis = fem.locate_dofs_geometrical((space.sub(0), space.sub(0).collapse()[0]), lambda p: p[0] < 1e-9)
    held = [fem.dirichletbc(fem.Function(space.sub(0).collapse()[0]), axis, space.sub(0))]
    u.x.array[1::2] = -((1.5 * a) ** 2) / (2 * radius)  # touching well beyond the contact: from u = 0 the tangent would be singular
    newton(form, u, held)
    total, second = (fem.assemble_scalar(fem.form(on_contact(f))) for f in (pressure, pressure * x[0] ** 2))
    half_width = np.sqrt(2.5 * second / total)  # a^2 = 5/2 of the mean of r^2 below Hertz's pressure
    fallen, far = (fem.assemble_scalar(fem.form(on(len(sides), 4, f))) for f in (-u[1], 1 + 0 * x[0]))
    peak, pressures = along(space.tabulate_dof_coordinates(), u.x.array[1::2], scene, spring, half_width)
    return {"half_width": float(half_width), "peak": float(peak), "resultant": float(total), "pressure": pressures,
            "approach": float(fallen / far), "dofs": int(2 * space.dofmap.index_map.size_global)}


def elastic(u, v, x, of):
    """Virtual work of the stresses."""
    shear, lame = of["young"] / (2 * (1 + of["poisson"])), of["young"] * of["poisson"] / ((1 + of["poisson"]) * (1 - 2 * of["poisson"]))

    def strain(w):
        plane = ufl.sym(ufl.grad(w))
        return ufl.as_tensor([[plane[0, 0], plane[0, 1], 0], [plane[1, 0], plane[1, 1], 0], [0, 0, w[0] / x[0]]])

    stress = 2 * shear * strain(u) + lame * ufl.tr(strain(u)) * ufl.Identity(3)
    return ufl.inner(stress, strain(v)) * 2 * ufl.pi * x[0] * ufl.dx(metadata={"quadrature_degree": 6})


def huber(x, of):
    """(sigma_r, sigma_z, tau_rz) below Hertz's pressure (Huber 1904; Fischer-Cripps, Contact Mechanics, 2007, eq. 5.4)."""
    (r, z), a, nu = x, of["a"], of["poisson"]
    inner = r**2 + z**2 - a**2
    u = (inner + ufl.sqrt(inner**2 + 4 * a**2 * z**2)) / 2
    root, p0 = ufl.sqrt(u), 3 * of["load"] / (2 * ufl.pi * a**2)
    turn, deep = z / root, (z / root) ** 3 * a**2 * u / (u**2 + a**2 * z**2)
    radial = (1 - 2 * nu) / 3 * a**2 / r**2 * (1 - turn**3) + deep
    radial += turn * (u * (1 - nu) / (a**2 + u) + (1 + nu) * root / a * ufl.atan(a / root) - 2)
    return p0 * radial, -p0 * deep, -p0 * r * z**2 / (u**2 + a**2 * z**2) * a**2 * root / (a**2 + u)


def newton(form, u, held):
    """Makes the form vanish."""
    vector = u.x.petsc_vec if hasattr(u.x, "petsc_vec") else u.vector  # the latter up to dolfinx 0.8
    residual, tangent = fem.form(form), fem.form(ufl.derivative(form, u))
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    for _ in range(STEPS):
        matrix, force = petsc.assemble_matrix(tangent, held), petsc.assemble_vector(residual)
        matrix.assemble()
        petsc.apply_lifting(force, [tangent], [held], [vector], -1.0)
        petsc.set_bc(force, held, vector, -1.0)
        solver.setOperators(matrix)
        change = matrix.createVecRight()
        solver.solve(force, change)
        u.x.array[:] -= change.array
        if np.abs(change.array).max() <= SETTLED * np.abs(u.x.array).max():
            return
    raise RuntimeError(f"Newton has not ended after {STEPS} iterations; lower KAPPA")


def along(nodes, down, scene, spring, half_width):
    """Peak and means round the stations, of pressures at two points an edge; the peak by the even sextic nearest to the edge means."""
    radius = scene["radius"]
    near = nodes[:, 0] <= scene["stretch"] * scene["a_over_r"] * radius * (1 + 1e-9)
    height = radius - np.sqrt(radius**2 - np.where(near, nodes[:, 0], 0) ** 2) if scene["case"] == "sphere" else 0 * nodes[:, 0]
    on = np.flatnonzero(near & (np.abs(nodes[:, 1] - height) < 1e-9 * radius))
    on = on[np.argsort(nodes[on, 0])]
    xi = np.array([-1, 1]) / np.sqrt(3)
    shape = np.array([xi * (xi - 1) / 2, 1 - xi**2, xi * (xi + 1) / 2])
    r, w = (np.array([f[on][:-2:2], f[on][1::2], f[on][2::2]]).T @ shape for f in (nodes[:, 0], down))
    gap = radius - np.sqrt(radius**2 - r**2) if scene["case"] == "sphere" else r**2 / (2 * radius)
    pressure = spring * np.maximum(-w - gap, 0)
    if pressure[-1].max() > 0:
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    weight, inner = r.sum(axis=1), r.mean(axis=1) < 0.5 * half_width
    terms, means = np.array([(r * (r / half_width) ** k).sum(axis=1) / weight for k in (0, 2, 4, 6)]).T, (r * pressure).sum(axis=1) / weight
    peak = np.linalg.lstsq(terms[inner], means[inner], rcond=None)[0][0]
    stations = np.asarray(scene["stations"])
    fine = stations[:, None] + (stations[1] - stations[0]) * (np.arange(100) - 49.5) / 100
    return peak, np.interp(fine, r.ravel(), pressure.ravel()).mean(axis=1)


def ticks(level, *parts):
    """Places along parts (start, end, first distance), distances growing from the first, then halved; every second is a corner."""
    places = np.array([0.0])
    for start, end, first, growth in parts:
        count = max(1, int(np.ceil(np.log1p((end - start) * (growth - 1 + 1e-12) / first) / np.log(growth + 1e-12))))
        sums = np.cumsum(first * growth ** np.arange(count))
        places = np.append(places, start + (end - start) * sums / sums[-1])
    return np.interp(np.arange((len(places) - 1) * 2 ** (level + 1) + 1) / 2 ** (level + 1), np.arange(len(places)), places)


def triangles(rows, columns):
    """Corners and middles (0, 1, 2, 12, 02, 01) of the triangles of a grid of nodes (2 rows + 1) x (2 columns + 1)."""
    node = np.arange((2 * rows + 1) * (2 * columns + 1)).reshape(2 * rows + 1, -1)
    a, b, c, d, middle = node[:-2:2, :-2:2], node[2::2, :-2:2], node[2::2, 2::2], node[:-2:2, 2::2], node[1::2, 1::2]
    ab, bc, cd, da = node[1::2, :-2:2], node[2::2, 1::2], node[1::2, 2::2], node[:-2:2, 1::2]
    cells = [[a, b, c, bc, middle, ab], [a, c, d, cd, da, middle]]
    return np.concatenate([np.array(one).reshape(6, -1).T for one in cells]).astype(np.int64)


def truncated(scene, level):
    """Block on z = 0; sides: candidates, round, far."""
    a = scene["a_over_r"] * scene["radius"]
    side, reach, first = scene["size"] * a, scene["stretch"] * a, a / ELEMENTS
    r = ticks(level, (0, reach, first, 1.0), (reach, side, GROWTH * first, GROWTH))
    z = ticks(level, (0, side, first, GROWTH))
    sides = [lambda p: (p[1] < 1e-9) & (p[0] < reach + 1e-9), lambda p: p[0] > side - 1e-9, lambda p: p[1] > side - 1e-9]
    return np.array(np.meshgrid(r, z, indexing="ij")).reshape(2, -1).T, triangles(len(r) // 2, len(z) // 2), sides


def sphere(scene, level):
    """Lower half of a sphere about (0, R), rings that end in its centre; sides: candidates, cut."""
    radius, a = scene["radius"], scene["a_over_r"] * scene["radius"]
    reach = np.arcsin(scene["stretch"] * a / radius)
    angle = ticks(level, (0, reach, a / ELEMENTS / radius, 1.0), (reach, np.pi / 2, GROWTH * a / ELEMENTS / radius, GROWTH))
    left = radius - ticks(level, (0, radius, a / ELEMENTS, GROWTH))
    points = np.array([np.outer(np.sin(angle), left), radius - np.outer(np.cos(angle), left)]).reshape(2, -1).T
    cells, last = triangles(len(angle) // 2, len(left) // 2), len(left) - 1
    # Of two triangles that share a square next to the centre one is left, its edge 02 on the ray of its corner 0.
    at_centre = cells % len(left) == last
    cells = cells[at_centre[:, :3].sum(axis=1) < 2]
    at_centre = cells % len(left) == last
    cells[at_centre[:, 2], 4] = cells[at_centre[:, 2], 0] + 1
    cells[at_centre] = last
    used, cells = np.unique(cells, return_inverse=True)
    sides = [lambda p: (np.abs(np.hypot(p[0], p[1] - radius) - radius) < 1e-6) & (p[0] < scene["stretch"] * a * (1 + 1e-9)),
             lambda p: p[1] > radius - 1e-9]
    return points[used], cells.reshape(-1, 6), sides


MESHES = {"sphere": sphere, "truncated-sphere": truncated}
