"""The same discrete problem in dolfinx 0.5 to 0.11: Lagrange cells on the mesh it is given, 8-node ones inside 9-node ones."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import inspect

from mpi4py import MPI

import basix
import numpy as np
import scipy.sparse as sparse
import ufl
from dolfinx import fem, mesh as meshes
from dolfinx.fem import petsc
from petsc4py import PETSc
from scipy.spatial import cKDTree

import discrete
from closed_forms import lame

# Corners and mid-sides of our cells in the order of the tensor product; the centre last.
ORDER = {4: [0, 1, 3, 2], 8: [0, 1, 3, 2, 4, 7, 5, 6, 8]}


def solve(problem):
    """What `discrete.solve` returns, with stiffness, load and edge functions of dolfinx."""
    stiffness, load = assembled(problem)
    return discrete.solve(problem, stiffness, load, _edge_functions(2 if problem["cells"].shape[1] == 8 else 1))


def assembled(problem):
    """Stiffness [N/mm] and load [N], node by node: `K8 = P^T K9 P` of the 8-node cells in the 9-node ones."""
    cells, points = problem["cells"], problem["points"]
    degree = 2 if cells.shape[1] == 8 else 1
    nodes, embedding = _lagrange(points, cells)
    places = embedding @ points
    mesh, space = _mesh(places, nodes, degree)
    to_nodes = _numbering(mesh, space, nodes, 2 * len(places))
    both = sparse.kron(embedding, sparse.identity(2)).tocsr()
    chosen = to_nodes @ both
    stiffness = chosen.T @ _stiffness(problem, mesh, space, degree) @ chosen
    return stiffness.tocsr(), chosen.T @ _load(problem, mesh, space)


def _lagrange(points, cells):
    """Nodes of the Lagrange cells, and the matrix that gives them the values of the serendipity ones.

    The centre of an 8-node cell has half the sum of its mid-sides less a quarter of the sum of its corners.
    """
    count, corners = len(points), cells.shape[1]
    if corners == 4:
        return cells[:, ORDER[4]], sparse.identity(count).tocsr()
    centres = count + np.arange(len(cells))
    rows = np.repeat(np.arange(len(cells)), 8)
    weights = np.tile([-0.25] * 4 + [0.5] * 4, len(cells))
    extra = sparse.csr_matrix((weights, (rows, cells.ravel())), shape=(len(cells), count))
    return np.column_stack([cells, centres])[:, ORDER[8]], sparse.vstack([sparse.identity(count), extra]).tocsr()


# What makes a space has had another name up to dolfinx 0.6.
_space = fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace


def _mesh(places, nodes, degree):
    """The mesh, and the space of its own element; its variant is named, so that every process finds the same compiled forms."""
    if hasattr(ufl, "VectorElement"):
        element = ufl.VectorElement("Lagrange", "quadrilateral", degree, variant="equispaced")
    else:  # dolfinx 0.7 or later
        from basix.ufl import element as of

        element = of("Lagrange", "quadrilateral", degree, lagrange_variant=basix.LagrangeVariant.equispaced, shape=(2,))
    # From dolfinx 0.10 on the element goes before the places.
    order = list(inspect.signature(meshes.create_mesh).parameters)[2:4]
    given = (places if name == "x" else ufl.Mesh(element) for name in order)
    mesh = meshes.create_mesh(MPI.COMM_SELF, nodes.astype(np.int64), *given)
    return mesh, _space(mesh, element)


def _numbering(mesh, space, nodes, size):
    """Matrix from node-by-node components to the freedoms of the space."""
    original = np.asarray(mesh.topology.original_cell_index)
    dofs = np.array([space.dofmap.cell_dofs(cell) for cell in range(len(original))])
    dofs, first = np.unique(dofs, return_index=True)
    node = nodes[original].ravel()[first]
    rows = np.concatenate([2 * dofs, 2 * dofs + 1])
    columns = np.concatenate([2 * node, 2 * node + 1])
    return sparse.csr_matrix((np.ones(rows.size), (rows, columns)), shape=(rows.size, size))


def _stiffness(problem, mesh, space, degree):
    constants = _space(mesh, ("DG", 0))
    body = problem["body"][np.asarray(mesh.topology.original_cell_index)]
    lam, mu = fem.Function(constants), fem.Function(constants)
    lam.x.array[:], mu.x.array[:] = (c[body] for c in lame(problem["young"], problem["poisson"], problem["plane"]))
    thickness = fem.Constant(mesh, PETSc.ScalarType(problem["thickness"]))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = ufl.sym(ufl.grad(u))
    stress = lam * ufl.tr(strain) * ufl.Identity(2) + 2 * mu * strain
    dx = ufl.dx(metadata={"quadrature_degree": 2 * degree + 1})
    matrix = petsc.assemble_matrix(fem.form(thickness * ufl.inner(stress, ufl.grad(v)) * dx))
    matrix.assemble()
    pointers, columns, values = matrix.getValuesCSR()
    return sparse.csr_matrix((values, columns, pointers), shape=matrix.size)


def _load(problem, mesh, space):
    """`f_a = int N_a t ds` over the loaded facets, 16 Gauss points each."""
    tags = meshes.meshtags(mesh, 1, *_loaded_facets(problem, mesh))
    ds = ufl.Measure("ds", mesh, subdomain_data=tags, metadata={"quadrature_degree": 31})
    thickness = fem.Constant(mesh, PETSc.ScalarType(problem["thickness"]))
    if problem["hertz_load"]:
        half_width, peak = (fem.Constant(mesh, PETSc.ScalarType(value)) for value in discrete.hertz(problem))
        traction = _hertz_stress(ufl.SpatialCoordinate(mesh), half_width, peak) * ufl.FacetNormal(mesh)
    else:
        traction = fem.Constant(mesh, PETSc.ScalarType(tuple(problem["traction"])))
    work = ufl.inner(traction, ufl.TestFunction(space))
    return petsc.assemble_vector(fem.form(thickness * work * ds(1))).array.copy()


def _loaded_facets(problem, mesh):
    """Facets with the middle of a loaded edge, sorted, and their tag, 1."""
    mesh.topology.create_connectivity(1, 2)
    facets = meshes.exterior_facet_indices(mesh.topology)
    middles = problem["points"][problem["load_edges"][:, :2]].mean(axis=1)
    away, found = cKDTree(meshes.compute_midpoints(mesh, 1, facets)[:, :2]).query(middles)
    if (away > 1e-9 * np.ptp(problem["points"])).any():
        raise RuntimeError("dolfinx took over another mesh than the given one")
    chosen = np.sort(facets[found])
    return chosen, np.ones(len(chosen), dtype=np.int32)


def _hertz_stress(place, half_width, peak):
    """Stress tensor [MPa] below a Hertz contact in McEwen's form; the smaller of m and n from `m n = x y`."""
    x, y = place[0], place[1]
    difference = half_width**2 - x**2 + y**2
    both = ufl.sqrt(difference**2 + 4 * x**2 * y**2)
    larger = ufl.sqrt((both + abs(difference)) / 2)
    m = ufl.conditional(difference > 0, larger, x * y / larger)
    n = ufl.conditional(difference > 0, x * y / larger, larger)
    share = (y**2 + n**2) / (m**2 + n**2)
    across, down = m * (1 + share) - 2 * y, m * (1 - share)
    shear = n * (m**2 - y**2) / (m**2 + n**2)
    return -peak / half_width * ufl.as_matrix([[across, shear], [shear, down]])


def _edge_functions(degree):
    """Tabulated functions of the interval of the same degree: first, last, middle; `xi` from -1 to 1."""
    line = basix.create_element(
        basix.ElementFamily.P, basix.CellType.interval, degree, basix.LagrangeVariant.equispaced
    )

    def at(xi):
        values, slopes = line.tabulate(1, np.array([[(xi + 1) / 2]]))[:, 0, :, 0]
        return values, slopes / 2

    return at
