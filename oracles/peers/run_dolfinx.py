"""An exported case by dolfinx: run_dolfinx.py FOLDER penalty|active-set; writes dolfinx-METHOD.json there.

dolfinx assembles the stiffness on the exported mesh (Q1, or Q2 with a node in the middle of the 8-node cells); it has no contact of its own:
springs, or active sets with Lagrange multipliers, act on the exported rows. Solved by MUMPS.
"""

import inspect
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

try:
    from mpi4py import MPI  # before PETSc
    import dolfinx
    import ufl
    from dolfinx import fem
    from dolfinx.fem import petsc
    from dolfinx.mesh import create_mesh
    from petsc4py import PETSc
except ModuleNotFoundError as absent:
    install = "python3 -m pip install dolfinx-solver-real with Python 3.12 or newer, or on Debian 12 apt install python3-dolfinx"
    exported.missing(f"dolfinx ({absent.name})", install)

# dolfinx counts the nodes of a cell corner 0 1 3 2, then the middles of 01, 03, 12, 32.
NODES = {4: [0, 1, 3, 2], 9: [0, 1, 3, 2, 4, 7, 5, 6, 8]}


def lagrange(degree):
    """The element with two components on quadrilaterals: of UFL up to dolfinx 0.6, then of basix."""
    if hasattr(ufl, "VectorElement"):
        return ufl.VectorElement("Lagrange", ufl.quadrilateral, degree)
    import basix.ufl

    return basix.ufl.element("Lagrange", "quadrilateral", degree, shape=(2,))


def meshed(cells, points, element):
    """The mesh; from dolfinx 0.10 on its element goes before its points."""
    given = [points if name == "x" else ufl.Mesh(element) for name in list(inspect.signature(create_mesh).parameters)[2:4]]
    return create_mesh(MPI.COMM_SELF, cells, *given)


def stiffness(points, cells, young, poisson, plane):
    """Matrix of one body per unit of thickness, dofs 2 node + component."""
    element = lagrange(2 if cells.shape[1] == 9 else 1)
    mesh = meshed(cells[:, NODES[cells.shape[1]]], points, element)
    space = (fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace)(mesh, element)
    shear, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    if plane == "stress":
        lame = 2 * shear * lame / (lame + 2 * shear)
    # Constants, so that the form is compiled once.
    shear, lame = (fem.Constant(mesh, PETSc.ScalarType(value)) for value in (shear, lame))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = ufl.sym(ufl.grad(u))
    stress = 2 * shear * strain + lame * ufl.tr(strain) * ufl.Identity(2)
    form = fem.form(ufl.inner(stress, ufl.sym(ufl.grad(v))) * ufl.dx(metadata={"quadrature_degree": 4}))
    matrix = petsc.assemble_matrix(form)
    matrix.assemble()
    away, node = cKDTree(points).query(space.tabulate_dof_coordinates()[:, :2])
    if away.max() > 1e-6 * np.ptp(points):
        raise RuntimeError("dolfinx took over another mesh than the exported one")
    dof = np.column_stack([2 * node, 2 * node + 1]).ravel()
    start, column, value = matrix.getValuesCSR()
    found = csr_matrix((value, column, start)).tocoo()
    found.row, found.col = dof[found.row], dof[found.col]
    return found


def direct(matrix, force):
    """Solution by MUMPS."""
    matrix = matrix.tocsr()
    matrix.sort_indices()
    solver, size = PETSc.KSP().create(MPI.COMM_SELF), matrix.shape
    solver.setOperators(PETSc.Mat().createAIJ(size, csr=(matrix.indptr, matrix.indices, matrix.data), comm=MPI.COMM_SELF))
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    right, solution = PETSc.Vec().createWithArray(force, comm=MPI.COMM_SELF), np.zeros(size[0])
    solver.solve(right, PETSc.Vec().createWithArray(solution, comm=MPI.COMM_SELF))
    if solver.getConvergedReason() < 0:
        raise RuntimeError("MUMPS could not factorise the matrix")
    return solution


def main(folder, method):
    """Solves, and writes the answer; compiling the form is not counted."""
    problem = exported.Problem(folder)
    problem.stiffness(stiffness)
    begin = time.perf_counter()
    matrix = problem.stiffness(stiffness)
    pressure, gap, steps = exported.solve(problem, matrix, method, direct)
    seconds = time.perf_counter() - begin
    file = f"dolfinx-{method}.json"
    exported.write_json(problem, file, f"dolfinx {dolfinx.__version__}", pressure, gap)
    exported.report(code="dolfinx", version=dolfinx.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["penalty", "active-set"], "dolfinx 0.5.2 and 0.11.0")
