"""Work and precision of NGSolve at high order on truncated Hertz: ngsolve_precision.py < request; JSON lines.

Request and answer are those of work_precision.py, but for
    meshes     [order, n] or [order, n, steep]: quadrilaterals of that order of H1, n equal ones along the candidates; as often as n divides by
               three, a row of them joins three to one, and from there on cells grow geometrically to the far sides, by `steep` times the
               factor of their order. They know no load.
    methods    of "augmented-lagrangian" and "penalty" those that are asked (both)
    peak       by least squares of c0 + c1 x^2 + c2 x^4 where x < a/4
    l2_error   and all integrals of p are sums over the Gauss points of the contact, twice the order an edge, where p is found
Newton's method minimises the energy of overlap on the contact boundary, K max(0, overlap + multiplier/K)^2 / 2 at the Gauss points, from a
rigid approach by a^2/2R, a nominal; the multipliers, none at first, then take its pressures, and it is minimised once more. NGSolve condenses
the cells and by one sparse Cholesky factorisation all but the vertical displacements of the candidates, in which Newton's steps are dense.
"""

import pathlib
import sys

import common  # first: one thread
import work_precision  # then: what it shares, and the oracles

import closed_forms
import measures
import numpy as np

# NGSolve is there where oracles/peers/setup.sh has put it.
sys.path.extend(map(str, pathlib.Path(__file__).resolve().parents[1].glob(".python/ngsolve/**/dist-packages")))
try:
    import netgen.meshing as netgen
    import ngsolve as ng
    from ngsolve.comp import IntegrationRuleSpaceSurface as Points
except ModuleNotFoundError as absent:
    common.missing(f"NGSolve ({absent.name})")

ng.SetNumThreads(1)  # its Cholesky starts threads of its own
METHODS = {"augmented-lagrangian": [1e3, 1e3], "penalty": [1e4]}  # K over E*/a, round by round
FAR = 23  # Gauss points of an edge under tractions
STEPS, TOLERANCE = 60, 1e-10  # of a change over the displacement


def square(stretch, growth, size):
    """Corners of the cells of the unit square."""
    columns, rows, cells = np.linspace(0.0, stretch, size + 1), [0.0], []

    def grown(first, length):
        powers = growth ** np.arange(1 + max(1, round(np.log1p((growth - 1.0) * (1.0 - first) / length) / np.log(growth))))
        return [*first + (1.0 - first) * (powers - 1.0) / (powers[-1] - 1.0)]

    while (len(columns) - 1) % 3 == 0:
        low, middle, high = (rows[-1] + k * columns[1] for k in range(3))
        for a, b, c, d in zip(columns[:-1:3], columns[1::3], columns[2::3], columns[3::3]):
            cells += [[(a, low), (b, low), (b, middle), (a, high)], [(b, low), (c, low), (c, middle), (b, middle)]]
            cells += [[(c, low), (d, low), (d, high), (c, middle)], [(b, middle), (c, middle), (d, high), (a, high)]]
        columns, rows = columns[::3], [*rows, high]
    upper, outer = grown(rows[-1], columns[1]), grown(stretch, stretch)
    for across, up in (columns, upper), (outer, rows[:-1] + upper):
        for x, right in zip(across, across[1:]):
            cells += [[(x, low), (right, low), (right, high), (x, high)] for low, high in zip(up, up[1:])]
    return np.array(cells).round(14)


class Block(work_precision.Clock):
    """The block on a mesh; it counts the seconds of its solutions."""

    def __init__(self, scene, order, size, steep=1):
        super().__init__()
        self.modulus = closed_forms.plane_modulus(scene["young"], scene["poisson"], "strain")
        self.scene, self.order, self.half_width = scene, order, scene["a_over_r"] * scene["radius"]
        self.edge, stretch, mesh = scene["stretch"] * self.half_width / size, scene["stretch"] / scene["size"], netgen.Mesh(dim=2)
        corners = square(stretch, steep * (2.0 if order < 6 else 9.0), size).reshape(-1, 2)
        points, cells = np.unique(corners, axis=0, return_inverse=True)
        for x, y in scene["size"] * self.half_width * points:
            mesh.Add(netgen.MeshPoint(netgen.Pnt(x, y, 0.0)))
        mesh.Add(netgen.FaceDescriptor(surfnr=1, domin=1, bc=1))
        for own in cells.reshape(-1, 4):
            mesh.Add(netgen.Element2D(1, [int(v) + 1 for v in own]))
            for pair in zip(own, np.roll(own, -1)):
                x, y = points[list(pair)].mean(axis=0)
                on = [y == 0.0 and x < stretch, x == 1.0, y == 1.0, x == 0.0, y == 0.0]
                if any(on):
                    mesh.Add(netgen.Element1D([int(v) + 1 for v in pair], index=on.index(True) + 1))
        for index, name in enumerate(["contact", "right", "top", "axis", "other"]):
            mesh.SetBCName(index, name)
        self.mesh = ng.Mesh(mesh)

    def solved(self, half_width, method):
        """Freedoms; places, weights and pressures of the contact points; steps of each round."""
        space = ng.H1(self.mesh, order=self.order, dirichlet="axis") * ng.H1(self.mesh, order=self.order)
        (u, v), (p, q) = ((ng.grad(f) for f in functions) for functions in space.TnT())
        bulk, shear = closed_forms.lame(self.scene["young"], self.scene["poisson"], "strain")
        normal = (bulk + 2.0 * shear) * (u[0] * p[0] + v[1] * q[1]) + bulk * (u[0] * q[1] + v[1] * p[0])
        elastic = ng.BilinearForm(space, symmetric=True, condense=True)
        elastic += (normal + shear * (u[1] + v[0]) * (p[1] + q[0])) * ng.dx
        self.timed("stiffness", elastic.Assemble)
        touching, vertical = space.GetDofs(self.mesh.Boundaries("contact")), space.Range(1)
        contact = np.array([dof for dof in range(vertical.start, vertical.stop) if touching[dof]])
        reduced = self.timed("linear", condensed, elastic.mat, space.FreeDofs(True), contact, self.force(space, half_width))
        return space.FreeDofs().NumSet(), *self.closed(space, contact, *reduced, METHODS[method])

    def force(self, space, half_width):
        """Hertz's tractions on the far sides."""
        far, (p, q), form = self.mesh.Boundaries("right|top"), space.TestFunction(), ng.LinearForm(space)
        at = Points(self.mesh, order=FAR - 1, definedon=far)
        rules, stress = at.GetIntegrationRules(), [ng.GridFunction(at) for _ in range(3)]
        x, y = ng.CF((ng.x, ng.y))(self.mesh.MapToAllElements(rules, far)).T
        peak = self.modulus * half_width / (2.0 * self.scene["radius"])
        for function, values in zip(stress, closed_forms.hertz_stress(x, y, half_width, peak)):
            function.vec.FV().NumPy()[:] = values
        across, down, shear = stress
        form += (across * p + shear * q) * ng.ds("right", intrules=rules) + (shear * p + down * q) * ng.ds("top", intrules=rules)
        return form.Assemble().vec

    def closed(self, space, contact, stiffness, force, springs):
        """Places, weights and pressures of the contact points, and steps."""
        side, gap = self.mesh.Boundaries("contact"), ng.x**2 / (2.0 * self.scene["radius"])
        at = Points(self.mesh, order=2 * self.order - 1, definedon=side)
        rules, multiplier, state, spring = at.GetIntegrationRules(), ng.GridFunction(at), ng.GridFunction(space), ng.Parameter(1.0)
        overlap = multiplier / spring - space.TrialFunction()[1] - gap
        form, residual = ng.BilinearForm(space, check_unused=False), state.vec.CreateVector()
        form += ng.Variation(0.5 * spring * ng.IfPos(overlap, overlap**2, 0.0) * ng.ds("contact", intrules=rules))
        places, values, pressure = self.mesh.MapToAllElements(rules, side), state.vec.FV().NumPy(), multiplier.vec.FV().NumPy()
        rigid = state.components[1].vec.FV().NumPy()[: self.mesh.nv]  # the functions of the vertices come first
        rigid[:], taken = -self.half_width**2 / (2.0 * self.scene["radius"]), []
        for soft in springs:
            spring.Set(soft * self.modulus / self.half_width)
            for step in range(1, STEPS + 1):
                form.Apply(state.vec, residual)
                form.AssembleLinearization(state.vec)
                missing = force - stiffness @ values[contact] - residual.FV().NumPy()[contact]
                change = self.timed("linear", np.linalg.solve, stiffness + dense(form.mat, contact, contact), missing)
                values[contact] += change
                if np.abs(change).max() <= TOLERANCE * np.abs(values[contact]).max():
                    break
            else:
                raise RuntimeError(f"Newton's method has not converged in {STEPS} steps")
            taken.append(step)
            pressure[:] = np.maximum(pressure - spring.Get() * (state.components[1] + gap)(places).ravel(), 0.0)
        weights = self.edge * np.array(rules[ng.SEGM].weights)
        return ng.x(places).ravel(), np.tile(weights, len(pressure) // len(weights)), pressure.copy(), taken


def dense(matrix, rows, columns):
    """A part of a sparse matrix."""
    value, column, start = (np.asarray(part) for part in matrix.CSR())
    row, place = np.full((2, matrix.height), -1)
    row[rows], place[columns] = np.arange(len(rows)), np.arange(len(columns))
    row, place = np.repeat(row, np.diff(start.astype(int))), place[column]
    part, kept = np.zeros((len(rows), len(columns))), (row >= 0) & (place >= 0)
    part[row[kept], place[kept]] = value[kept]
    return part


def condensed(matrix, free, contact, force):
    """Stiffness and forces of the contact displacements alone."""
    inside = ng.BitArray(free)
    for dof in contact:
        inside.Clear(int(dof))
    inverse, right, moved = matrix.Inverse(inside, inverse="sparsecholesky"), force.CreateVector(), force.CreateVector()
    columns = dense(matrix, np.arange(matrix.height), contact)
    near = np.flatnonzero(columns.any(axis=1))
    answers = []
    for column in [force.FV().NumPy(), *columns.T]:
        right.FV().NumPy()[:] = column
        moved.data = inverse * right
        answers.append(moved.FV().NumPy()[near])
    products = np.array(answers) @ columns[near]
    return columns[contact] - products[1:], force.FV().NumPy()[contact] - products[0]


def row(on, half_width, method, request):
    """Times and errors under the load of one half-width, on a mesh that does not know it."""
    (freedoms, x, weight, pressure, steps), seconds = on.laps(request["repeats"], lambda: on.solved(half_width, method))
    peak = on.modulus * half_width / (2.0 * on.scene["radius"])
    width = 2.0 * np.sqrt((weight * pressure * x**2).sum() / (weight * pressure).sum())
    near = x < 0.25 * width
    top = measures.fit(pressure[near], weight[near], x[near] ** 2, x[near] ** 4)[0]
    exact = peak * np.sqrt(np.maximum(1.0 - (x / half_width) ** 2, 0.0))
    apart = np.sqrt((weight * (pressure - exact) ** 2).sum() / (2.0 / 3.0 * half_width * peak**2))
    errors = {"peak_error": abs(top / peak - 1.0), "half_width_error": abs(width / half_width - 1.0), "l2_error": apart}
    return {"freedoms": freedoms, **seconds, "steps": steps} | {name: float(error) for name, error in errors.items()}


def main():
    """Answers the request on stdin."""
    if sys.argv[1:]:
        sys.exit("usage: python3 oracles/peers/ngsolve_precision.py < request.json")
    request = work_precision.asked(list(METHODS))
    for method in request["methods"]:
        Block(request["scene"], 4, 9).solved(request["half_widths"][0], method)  # warm-up
        for order, size, *steep in request["meshes"]:
            on = Block(request["scene"], order, size, *steep)
            rows = [row(on, half_width, method, request) for half_width in request["half_widths"]]
            work_precision.tell("ngsolve", ng.__version__, method, [order, size, *steep], size, rows)


if __name__ == "__main__":
    main()
