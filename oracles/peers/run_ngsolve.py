"""An exported case by NGSolve: run_ngsolve.py FOLDER contact|active-set [--times N]; writes ngsolve-METHOD.vtu, or .json, there.

contact: NGSolve's contact boundary with an energy of overlap, pressure = K overlap, as its documentation has it, without a number: K = N 50 E
per mm, as of CalculiX; a rigid side is the same energy on the boundary alone, with the exported gap. The normals are those of the exported
nodes, the pairs of points those that NGSolve finds on the undeformed mesh. Newton's method, sparse Cholesky.
active-set: NGSolve's elasticity, active sets with Lagrange multipliers on the exported rows, UMFPACK.
Cells are quadrilaterals of order 1, or of order 2 without functions of their inside, which are the exported cells with 8 nodes, curved by a
deformation of the mesh. Pressures are what the load leaves of the elastic forces of the contact nodes, over their exported areas.
"""

import pathlib
import sys
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix

# NGSolve is there where oracles/peers/setup.sh has put it.
sys.path.extend(map(str, pathlib.Path(__file__).resolve().parents[1].glob(".python/ngsolve/**/dist-packages")))

try:
    import netgen.meshing as netgen
    import ngsolve as ng
except ModuleNotFoundError as absent:
    exported.missing(f"NGSolve ({absent.name})", "python3 -m pip install ngsolve")

STIFFNESS = 50.0  # K/E [1/mm]
STEPS, TOLERANCE = 100, 1e-9  # of the change over the displacement
INTEGRATION = 6  # order of the quadrature along the contact
REACH = 0.05  # longest distance of a pair over the size of the scene
OTHER = "other"  # name of edges without contact


def meshed(problem):
    """The mesh of straight cells, its vertices the corners, and the number of each corner's node."""
    corners, vertex = np.unique(problem.cells[:, :4], return_inverse=True)
    mesh = netgen.Mesh(dim=2)
    for x, y in problem.points[corners]:
        mesh.Add(netgen.MeshPoint(netgen.Pnt(x, y, 0.0)))
    names = [OTHER]
    for contact in range(len(problem.data["contacts"])):
        names += [f"first{contact}", f"second{contact}"]
    for body in range(len(problem.data["young"])):
        mesh.Add(netgen.FaceDescriptor(surfnr=body + 1, domin=body + 1, bc=body + 1))
        mesh.SetMaterial(body + 1, f"body{body}")
    number = {frozenset(edge[:2]): 2 * k + side + 1 for k, contact in enumerate(problem.data["contacts"])
              for side, edges in enumerate([contact["edges"], contact["opposite_edges"]]) for edge in edges}
    seen = {}
    for cell, (own, body) in enumerate(zip(vertex.reshape(-1, 4), problem.body)):
        mesh.Add(netgen.Element2D(int(body) + 1, [int(v) + 1 for v in own]))
        for k in range(4):
            pair = int(own[k]), int(own[(k + 1) % 4])
            seen.setdefault(frozenset(pair), []).append(pair)
    for pairs in seen.values():
        if len(pairs) == 1:
            index = number.get(frozenset(int(corners[v]) for v in pairs[0]), 0)
            mesh.Add(netgen.Element1D([v + 1 for v in pairs[0]], index=index + 1))
    for index, name in enumerate(names):
        mesh.SetBCName(index, name)
    return ng.Mesh(mesh), corners


def at_middle():
    """Value of NGSolve's second function of an edge at its middle."""
    mesh = netgen.Mesh(dim=2)
    points = [mesh.Add(netgen.MeshPoint(netgen.Pnt(x, y, 0.0))) for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]]
    mesh.Add(netgen.FaceDescriptor(surfnr=1, domin=1, bc=1))
    mesh.Add(netgen.Element2D(1, points))
    for k in range(4):
        mesh.Add(netgen.Element1D([points[k], points[(k + 1) % 4]], index=1))
    mesh = ng.Mesh(mesh)
    function = ng.GridFunction(ng.H1(mesh, order=2))
    bottom = next(edge for edge in mesh.edges if sorted(vertex.nr for vertex in edge.vertices) == [0, 1])
    (dof,) = function.space.GetDofNrs(bottom)
    function.vec[dof] = 1.0
    return function(mesh(0.5, 0.0))


def from_nodes(problem, mesh, corners, space):
    """Matrix from nodal values to those of NGSolve's functions of one component; those of the insides of cells are zero."""
    vertex = np.full(len(problem.points), -1)
    vertex[corners] = np.arange(len(corners))
    terms = {(vertex[node], node): 1.0 for node in corners}
    if problem.cells.shape[1] == 8:
        middle = at_middle()
        edges = {frozenset(v.nr for v in edge.vertices): space.GetDofNrs(edge)[0] for edge in mesh.edges}
        for cell in problem.cells:
            for k in range(4):
                a, b, m = cell[k], cell[(k + 1) % 4], cell[4 + k]
                dof = edges[frozenset((vertex[a], vertex[b]))]
                terms |= {(dof, m): 1.0 / middle, (dof, a): -0.5 / middle, (dof, b): -0.5 / middle}
    row, column = zip(*terms)
    return coo_matrix((list(terms.values()), (row, column)), (space.ndof, len(problem.points))).tocsr()


class Discretised:
    """The scene in NGSolve: space, elastic energy, and the matrix T from nodal displacements (2 node + component) to its unknowns."""

    def __init__(self, problem):
        self.problem = problem
        self.mesh, corners = meshed(problem)
        order = 2 if problem.cells.shape[1] == 8 else 1
        self.scalar, self.space = ng.H1(self.mesh, order=order), ng.VectorH1(self.mesh, order=order)
        self.of_values = from_nodes(problem, self.mesh, corners, self.scalar)
        size, nodes = self.scalar.ndof, len(problem.points)
        pick = [coo_matrix((np.ones(nodes), (np.arange(nodes), 2 * np.arange(nodes) + c)), (nodes, 2 * nodes)) for c in range(2)]
        parts = [self.space.Range(c) for c in range(2)]
        place = [coo_matrix((np.ones(size), (np.arange(part.start, part.stop), np.arange(size))), (2 * size, size)) for part in parts]
        self.of_nodes = sum(place[c] @ self.of_values @ pick[c] for c in range(2)).tocsr()
        if order == 2:
            flat = problem.points.copy()
            flat[problem.cells[:, 4:8]] = 0.5 * (flat[problem.cells[:, :4]] + flat[np.roll(problem.cells[:, :4], -1, axis=1)])
            self.bend = self.vector(problem.points - flat)
            self.mesh.SetDeformation(self.bend)

    def vector(self, nodal):
        """Function with these vectors at the nodes."""
        function = ng.GridFunction(self.space)
        function.vec.FV().NumPy()[:] = self.of_nodes @ nodal.ravel()
        return function

    def function(self, nodal):
        """Function with these values at the nodes."""
        function = ng.GridFunction(self.scalar)
        function.vec.FV().NumPy()[:] = self.of_values @ nodal
        return function

    def energy(self):
        """Form with the elastic energy per unit of thickness."""
        data = self.problem.data
        shear = [young / (2 * (1 + poisson)) for young, poisson in zip(data["young"], data["poisson"])]
        lame = [2 * g * nu / (1 - 2 * nu) for g, nu in zip(shear, data["poisson"])]
        if data["plane"] == "stress":
            lame = [2 * g * l / (l + 2 * g) for g, l in zip(shear, lame)]
        g, l = (self.mesh.MaterialCF({f"body{k}": value for k, value in enumerate(values)}) for values in (shear, lame))
        u = self.space.TrialFunction()
        strain = ng.Sym(ng.Grad(u))
        form = ng.BilinearForm(self.space)
        form += ng.Variation((g * ng.InnerProduct(strain, strain) + 0.5 * l * ng.Trace(strain) ** 2) * ng.dx)
        return form, u

    def stiffness(self):
        """Elastic stiffness for nodal displacements, with the thickness."""
        form, _ = self.energy()
        form.AssembleLinearization(ng.GridFunction(self.space).vec)
        return self.problem.data["thickness"] * (self.of_nodes.T @ plain(form.mat) @ self.of_nodes)


def plain(matrix):
    """A matrix of NGSolve in scipy."""
    value, column, start = matrix.CSR()
    return csr_matrix((np.array(value), np.array(column), np.array(start)), (matrix.height, matrix.width))


def direct(kind):
    """Solution of A x = b by NGSolve's sparse Cholesky or by UMFPACK."""

    def solve(matrix, force):
        matrix = matrix.tocoo()
        own = ng.la.SparseMatrixd.CreateFromCOO(matrix.row.tolist(), matrix.col.tolist(), matrix.data, *matrix.shape)
        right, solution = own.CreateColVector(), own.CreateColVector()
        right.FV().NumPy()[:] = force
        solution.data = own.Inverse(inverse=kind) * right
        return solution.FV().NumPy().copy()

    return solve


def overlaps(scene, form, u, stiffness):
    """Adds the energies of overlap; returns the contact boundaries, which must live as long as the form."""
    kept = []
    place = ng.CF((ng.x, ng.y))
    for k, contact in enumerate(scene.problem.data["contacts"]):
        normal, gap = np.zeros((len(scene.problem.points), 2)), np.zeros(len(scene.problem.points))
        for node in contact["nodes"]:
            if node["gap"] is None:
                raise ValueError("an obstacle with an edge has no smooth distance")
            normal[node["node"]], gap[node["node"]] = node["normal"], node["gap"]
        n = scene.vector(normal)
        if contact["second"] is None:
            overlap = u * n - scene.function(gap)
            form += ng.Variation(0.5 * stiffness * ng.IfPos(overlap, overlap**2, 0.0) * ng.ds(f"first{k}", bonus_intorder=2))
        else:
            pair = ng.ContactBoundary(scene.mesh.Boundaries(f"first{k}"), scene.mesh.Boundaries(f"second{k}"))
            overlap = (place + u - place.Other() - u.Other()) * n
            pair.AddEnergy(0.5 * stiffness * ng.IfPos(overlap, overlap**2, 0.0))
            pair.Update(bf=form, intorder=INTEGRATION, maxdist=REACH * np.ptp(scene.problem.points))
            kept.append(pair)
    return kept


def pressed(problem, stiffness):
    """Displacements of the nodes by Newton's method, and iterations."""
    scene = Discretised(problem)
    form, u = scene.energy()
    kept = overlaps(scene, form, u, stiffness * max(problem.data["young"]))
    motions, given, force, q = problem.system(1.0)
    of_motions, force = scene.of_nodes @ motions, motions.T @ force
    state, residual = ng.GridFunction(scene.space), ng.GridFunction(scene.space)
    for step in range(1, STEPS + 1):
        state.vec.FV().NumPy()[:] = of_motions @ q + scene.of_nodes @ given
        form.Apply(state.vec, residual.vec)
        form.AssembleLinearization(state.vec)
        missing = force - of_motions.T @ residual.vec.FV().NumPy()
        change = direct("sparsecholesky")(of_motions.T @ plain(form.mat) @ of_motions, missing)
        q += change
        if np.abs(change).max() <= TOLERANCE * np.abs(q).max():
            del kept
            return scene, motions @ q + given, step
    raise RuntimeError(f"NGSolve has not converged in {STEPS} iterations")


def main(folder, method, times):
    """Solves, and writes the answer."""
    ng.SetNumThreads(1)  # of its sparse Cholesky
    problem = exported.Problem(folder, centres=False)
    begin = time.perf_counter()
    if method == "active-set":
        matrix = Discretised(problem).stiffness()
        pressure, gap, steps = exported.solve(problem, matrix, method, direct("umfpack"))
        file = f"ngsolve-{method}.json"
        seconds = time.perf_counter() - begin
        exported.write_json(problem, file, f"NGSolve {ng.__version__}", pressure, gap)
    else:
        scene, u, steps = pressed(problem, times * STIFFNESS)
        pressure = problem.pressures(scene.stiffness() @ u - problem.load())
        seconds = time.perf_counter() - begin
        file = f"ngsolve-{method}.vtu"
        fields = [scene.vector(u.reshape(-1, 2)), scene.function(pressure)]
        order = 2 if problem.cells.shape[1] == 8 else 1
        ng.VTKOutput(scene.mesh, fields, ["displacement", "contact_pressure"], str(problem.folder / file)[:-4], order=order).Do()
    exported.report(code="ngsolve", version=ng.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["contact", "active-set"], "NGSolve 6.2.2608", "K")
