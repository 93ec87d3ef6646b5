"""An exported case of bodies of revolution: run_revolution.py FOLDER METHOD; writes revolution-METHOD.json or .dat there.

scikit-fem, dolfinx: forms weighted by 2 pi r on the exported mesh (Q1, or Q2 with a node in the middle of the 8-node cells), strains those of the
plane and u_r/r; active sets with Lagrange multipliers act on the exported rows. Solved by SuperLU.
felupe: its own axisymmetric field and law of small strain on the same cells; its axis is x, so that both coordinates are exchanged.
ngsolve: the same form in NGSolve, on cells of order 2 without functions of their inside, which are the exported ones with 8 nodes.
calculix: the exported deck, CAX4 or CAX8, with gap elements on the undeformed surface.
Forces and areas are those of the whole circumference.
"""

import inspect
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

METHODS = ["scikit-fem", "dolfinx", "felupe", "ngsolve", "calculix"]
POINTS = 3  # of Gauss each way
# dolfinx counts the nodes of a cell corner 0 1 3 2, then the middles of 01, 03, 12, 32.
NODES = {4: [0, 1, 3, 2], 9: [0, 1, 3, 2, 4, 7, 5, 6, 8]}


def moduli(young, poisson):
    """Shear modulus and Lame's first constant."""
    return young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))


def by_scikit_fem(points, cells, young, poisson, _plane):
    """Matrix of one body, dofs 2 node + component."""
    import skfem
    from skfem.helpers import ddot, sym_grad, trace

    corners, compact = np.unique(cells[:, :4], return_inverse=True)
    flat = skfem.MeshQuad(points[corners].T, compact.reshape(-1, 4).T)
    element, mesh, quadratic = skfem.ElementQuad1(), flat, cells.shape[1] == 9
    if quadratic:
        middle = {frozenset((cell[k], cell[(k + 1) % 4])): cell[4 + k] for cell in cells for k in range(4)}
        facets = np.array([middle[frozenset(pair)] for pair in corners[flat.facets].T.tolist()])
        order = np.concatenate([corners, facets, cells[:, 8]])
        element, mesh = skfem.ElementQuad2(), skfem.MeshQuad2(points[order].T, skfem.MeshQuad2.from_mesh(flat).t)
    basis = skfem.Basis(mesh, skfem.ElementVector(element), intorder=2 * POINTS - 1)
    shear, lame = moduli(young, poisson)

    @skfem.BilinearForm
    def energy(u, v, w):
        r, e, d = w.x[0], sym_grad(u), sym_grad(v)
        volume = (trace(e) + u[0] / r) * (trace(d) + v[0] / r)
        return 2 * np.pi * r * (2 * shear * (ddot(e, d) + u[0] * v[0] / r**2) + lame * volume)

    dof = np.full(basis.N, -1)
    for component in range(2):
        dof[basis.nodal_dofs[component]] = 2 * corners + component
        if quadratic:
            dof[basis.facet_dofs[component]] = 2 * facets + component
            dof[basis.interior_dofs[component]] = 2 * cells[:, 8] + component
    matrix = energy.assemble(basis).tocoo()
    matrix.row, matrix.col = dof[matrix.row], dof[matrix.col]
    return matrix


def by_dolfinx(points, cells, young, poisson, _plane):
    """Matrix of one body, dofs 2 node + component; for dolfinx 0.5 to 0.11."""
    from mpi4py import MPI  # before PETSc
    import ufl
    from dolfinx import fem
    from dolfinx.fem import petsc
    from dolfinx.mesh import create_mesh
    from petsc4py import PETSc

    degree = 2 if cells.shape[1] == 9 else 1
    if hasattr(ufl, "VectorElement"):
        element = ufl.VectorElement("Lagrange", ufl.quadrilateral, degree)
    else:
        import basix.ufl

        element = basix.ufl.element("Lagrange", "quadrilateral", degree, shape=(2,))
    # From dolfinx 0.10 on the element of a mesh goes before its points.
    given = [points if name == "x" else ufl.Mesh(element) for name in list(inspect.signature(create_mesh).parameters)[2:4]]
    mesh = create_mesh(MPI.COMM_SELF, cells[:, NODES[cells.shape[1]]], *given)
    space = (fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace)(mesh, element)
    shear, lame = (fem.Constant(mesh, PETSc.ScalarType(value)) for value in moduli(young, poisson))
    u, v, r = ufl.TrialFunction(space), ufl.TestFunction(space), ufl.SpatialCoordinate(mesh)[0]

    def strain(w):
        plane = ufl.sym(ufl.grad(w))
        return ufl.as_tensor([[plane[0, 0], plane[0, 1], 0], [plane[0, 1], plane[1, 1], 0], [0, 0, w[0] / r]])

    stress = 2 * shear * strain(u) + lame * ufl.tr(strain(u)) * ufl.Identity(3)
    form = ufl.inner(stress, strain(v)) * 2 * np.pi * r * ufl.dx(metadata={"quadrature_degree": 2 * POINTS - 1})
    matrix = petsc.assemble_matrix(fem.form(form))
    matrix.assemble()
    away, node = cKDTree(points).query(space.tabulate_dof_coordinates()[:, :2])
    if away.max() > 1e-6 * np.ptp(points):
        raise RuntimeError("dolfinx took over another mesh than the exported one")
    dof = np.column_stack([2 * node, 2 * node + 1]).ravel()
    start, column, value = matrix.getValuesCSR()
    found = csr_matrix((value, column, start)).tocoo()
    found.row, found.col = dof[found.row], dof[found.col]
    return found


def by_felupe(points, cells, young, poisson, _plane):
    """Matrix of one body, dofs 2 node + component."""
    import felupe

    # Exchanged, cells run the other way round.
    order = [0, 3, 2, 1, 7, 6, 5, 4, 8][: cells.shape[1]]
    kind, region = {4: ("quad", felupe.RegionQuad), 9: ("quad9", felupe.RegionBiQuadraticQuad)}[cells.shape[1]]
    mesh = felupe.Mesh(points[:, ::-1], cells[:, order], kind)
    field = felupe.FieldContainer([felupe.FieldAxisymmetric(region(mesh), dim=2)])
    matrix = felupe.SolidBody(felupe.LinearElastic(E=young, nu=poisson), field).assemble.matrix().tocoo()
    matrix.row, matrix.col = matrix.row ^ 1, matrix.col ^ 1
    return matrix


def by_ngsolve(problem):
    """Matrix of all bodies, for cells with 4 or 8 nodes."""
    import ngsolve as ng
    import run_ngsolve

    class Turned(run_ngsolve.Discretised):
        """The scene with the energy of bodies of revolution."""

        def energy(self):
            data, u = self.problem.data, self.space.TrialFunction()
            both = zip(*(moduli(*one) for one in zip(data["young"], data["poisson"])))
            shear, lame = (self.mesh.MaterialCF({f"body{k}": value for k, value in enumerate(values)}) for values in both)
            strain, hoop = ng.Sym(ng.Grad(u)), u[0] / ng.x
            density = shear * (ng.InnerProduct(strain, strain) + hoop**2) + 0.5 * lame * (ng.Trace(strain) + hoop) ** 2
            form = ng.BilinearForm(self.space)
            form += ng.Variation(2 * np.pi * ng.x * density * ng.dx)
            return form, u

    ng.SetNumThreads(1)
    return Turned(problem).stiffness()


def by_calculix(problem):
    """Version, iterations and seconds of ccx on the exported deck, whose tables go into the folder beside it."""
    if not shutil.which("ccx"):
        exported.missing("CalculiX", "apt install calculix-ccx")
    (own,) = [path for path in problem.folder.glob("*.inp") if path.stem != "revolution-calculix"]
    with tempfile.TemporaryDirectory(prefix="calculix-") as place:
        job = pathlib.Path(place) / "job"
        shutil.copyfile(own, f"{job}.inp")
        begin = time.perf_counter()
        done = subprocess.run(["ccx", "job"], cwd=place, capture_output=True, text=True, check=False)
        seconds = time.perf_counter() - begin
        if done.returncode or "*ERROR" in done.stdout or "Job finished" not in done.stdout:
            raise RuntimeError("ccx did not solve the deck: " + done.stdout[-500:])
        for ending in ("inp", "dat", "frd"):
            shutil.copyfile(f"{job}.{ending}", problem.folder / f"revolution-calculix.{ending}")
        attempts = [line.split() for line in pathlib.Path(f"{job}.sta").read_text(encoding="ascii").splitlines()[2:] if line.strip()]
    told = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout
    return re.search(r"Version (\S+)", told)[1], sum(int(line[3]) for line in attempts), seconds


def main(folder, method):
    """Solves, and writes the answer; compiling a form is not counted."""
    problem = exported.Problem(folder, centres=method != "ngsolve")
    if problem.data["plane"] != "axisymmetric":
        sys.exit(f"{folder} is a plane scene: run the script of one code, run_{method.replace('-', '_')}.py")
    if method == "calculix":
        version, steps, seconds = by_calculix(problem)
        exported.report(code=method, version=version, file="revolution-calculix.dat", iterations=steps, seconds=seconds)
        return
    # FElupe and NGSolve are there where oracles/peers/setup.sh has put them.
    installed = pathlib.Path(__file__).resolve().parents[1] / ".python"
    sys.path.extend(map(str, [installed / "felupe", *installed.glob("ngsolve/**/dist-packages")]))
    try:
        if method == "dolfinx":
            import mpi4py.MPI  # noqa: F401  # first: the MPI of a wheel
        version = __import__({"scikit-fem": "skfem"}.get(method, method)).__version__
    except ModuleNotFoundError:
        exported.missing(method, "python3 -m pip install " + {"dolfinx": "dolfinx-solver-real"}.get(method, method))
    of_body = {"scikit-fem": by_scikit_fem, "dolfinx": by_dolfinx, "felupe": by_felupe}

    def stiffness():
        return by_ngsolve(problem) if method == "ngsolve" else problem.stiffness(of_body[method])

    stiffness()
    begin = time.perf_counter()
    matrix = stiffness()
    pressure, gap, steps = exported.solve(problem, matrix, "active-set", lambda a, b: splu(a.tocsc()).solve(b))
    seconds = time.perf_counter() - begin
    file = f"revolution-{method}.json"
    exported.write_json(problem, file, f"{method} {version}", pressure, gap)
    exported.report(code=method, version=version, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, METHODS, "scikit-fem 12.0.2, dolfinx 0.5.2 and 0.11, FElupe 11.3.0, NGSolve 6.2.2608 and CalculiX 2.20")
