"""Stiffness and edge functions of dolfinx 0.5 to 0.11, factorised by MUMPS."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

from mpi4py import MPI  # before PETSc, which would otherwise start it with fewer threads allowed

import inspect

import basix
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import assemble_matrix
from dolfinx.mesh import create_mesh
from petsc4py import PETSc
from scipy.sparse import coo_matrix, csr_matrix

QUADRATURE = 6
# dolfinx: corners, then the middles opposite to corner 0, 1, 2; the mesh: middles of 01, 12, 20.
ORDER = [0, 1, 2, 4, 5, 3]
# the same element everywhere, so that the compiled forms are found again
if hasattr(ufl, "VectorElement"):
    QUADRATIC = ufl.VectorElement("Lagrange", ufl.triangle, 2, variant="equispaced")
else:  # dolfinx 0.7 or later
    import basix.ufl

    QUADRATIC = basix.ufl.element("Lagrange", "triangle", 2, lagrange_variant=basix.LagrangeVariant.equispaced, shape=(2,))


def stiffness(mesh, plane_matrix):
    """Stiffness of a mesh of 6-node triangles, thickness 1 [N/mm]."""
    cells = mesh.triangles[:, ORDER].astype(np.int64)
    # From dolfinx 0.10 on the element goes before the points.
    order = list(inspect.signature(create_mesh).parameters)[2:4]
    solid = create_mesh(MPI.COMM_SELF, cells, *(mesh.points if name == "x" else ufl.Mesh(QUADRATIC) for name in order))
    space = (fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace)(solid, QUADRATIC)
    material = fem.Constant(solid, plane_matrix)
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    dx = ufl.dx(metadata={"quadrature_degree": QUADRATURE})
    matrix = assemble_matrix(fem.form(ufl.inner(material * strain(u), strain(v)) * dx))
    matrix.assemble()
    start, column, entry = matrix.getValuesCSR()
    found = csr_matrix((entry, column, start)).tocoo()
    # dolfinx numbers anew; cell by cell its freedoms name the nodes of its geometry, and those the given ones
    geometry, dofs = (np.ravel(getattr(table, "array", table)) for table in (solid.geometry.dofmap, space.dofmap.list))
    own = np.empty(len(mesh.points), int)
    own[dofs] = np.asarray(solid.geometry.input_global_indices)[geometry]
    freedom = (2 * own[:, None] + np.arange(2)).ravel()
    return coo_matrix((found.data, (freedom[found.row], freedom[found.col])), found.shape).tocsr()


def strain(u):
    """(eps_x, eps_y, gamma)."""
    grad = ufl.grad(u)
    return ufl.as_vector([grad[0, 0], grad[1, 1], grad[0, 1] + grad[1, 0]])


def edge_functions(xi):
    """Functions and slopes of the 3-node edge at xi in -1..1."""
    edge = basix.create_element(
        basix.ElementFamily.P, basix.CellType.interval, 2, basix.LagrangeVariant.equispaced
    )
    shape, slope = edge.tabulate(1, 0.5 * (xi[:, None] + 1.0))[..., 0]
    return shape, 0.5 * slope


def linear_solution(matrix, load):
    """Direct solution by MUMPS, of one load, or of one a column."""
    matrix = matrix.tocsr()
    entries = (matrix.indptr, matrix.indices, matrix.data)
    operator = PETSc.Mat().createAIJ(matrix.shape, csr=entries, comm=MPI.COMM_SELF)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(operator)
    solver.setType("preonly")
    factors = solver.getPC()
    factors.setType("lu")
    factors.setFactorSolverType("mumps")
    solver.setUp()
    loads = load.reshape(len(load), -1)
    given, found = (
        PETSc.Mat().createDense(loads.shape, array=array, comm=MPI.COMM_SELF)
        for array in (np.asfortranarray(loads), np.zeros(loads.shape, order="F"))
    )
    factors.getFactorMatrix().matSolve(given, found)
    return found.getDenseArray().reshape(load.shape).copy()
