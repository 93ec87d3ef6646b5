"""An exported case by Akantu: run_akantu.py FOLDER contact [--times N]; writes akantu-contact.vtu there.

contact: Akantu's solid and contact models coupled, implicit static, resolution penalty_linear: pressure = epsilon_n overlap at the nodes of the
first side, each against the nearest edge of the other one that Akantu finds on the deformed mesh; epsilon_n = N 400 E per mm, with N = 1 the
numbers of its documentation. In the plane its contact has edges with 2 nodes alone, so that cells with 8 nodes are cut into 4 with 4 nodes. A
rigid body is a row of fully held cells along the contact. A body that contact alone holds starts with an overlap: Akantu finds pairs only where
sides overlap. Stiffness, pairs, gaps, normals, areas and the forces on the first side are Akantu's. The rest is ours, since its contact in the
plane has faults in version 5.0.7:

* The forces on the other side are the reactions to those on the first, by the shape functions of the edge: with is_master_deformable = true
  Akantu halves all forces and, of several nodes on one edge, keeps the force of the last.
* The tangent of the contact, and Newton's loop, which also knows sides that stay flat: Akantu's counts entries off the diagonal twice.
* The scene is turned until the contact lies along x: Akantu's projection onto an edge diverges beyond 45 degrees from there.

SuperLU. Pressures are the contact forces on the nodes of the first side over their lengths.
"""

import os
import pathlib
import sys
import tempfile
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse import coo_matrix, diags, identity, kron
from scipy.sparse.linalg import splu

# Akantu is there where oracles/peers/setup.sh has put it.
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / ".python/akantu"))

try:
    import akantu
    import meshio
except ModuleNotFoundError as absent:
    exported.missing(f"Akantu ({absent.name})", "python3 -m pip install akantu meshio")

STIFFNESS = 400.0  # epsilon_n/E [1/mm]
STEPS, TOLERANCE = 200, 1e-8  # of the residual over the load
MOVED = 0.2  # part of the way to the widest gap that it starts at
DETECTOR = {"type": "explicit", "projection_tolerance": 1e-10, "max_iterations": 100, "extension_tolerance": 1e-3}
RESOLUTION = {"mu": 0.0, "epsilon_t": 0.0, "is_master_deformable": "false"}


def mesh(points, cells, body, sides):
    """The mesh; bodies, then sides of the contact, are groups by name."""
    names = {f"body{k}": np.array([k + 1, 2]) for k in range(body.max() + 1)}
    groups = [body + 1]
    for name, edges in sides.items():
        names[name] = np.array([len(names) + 1, 1])
        groups.append(np.full(len(edges), len(names)))
    parts = [("quad", cells), *(("line", np.array(edges)) for edges in sides.values())]
    return meshio.Mesh(np.pad(points, ((0, 0), (0, 1))), parts, field_data=names,
                       cell_data={"gmsh:physical": groups, "gmsh:geometrical": groups})


def section(head, **values):
    """Text of a section of the input."""
    return "\n".join([f"{head} [", *(f"  {name} = {value}" for name, value in values.items()), "]", ""])


def along_x(edges):
    """The turn that brings edges, from point to point, nearest to the direction of x."""
    x, y = (edges[:, 1] - edges[:, 0]).T
    angles = np.unwrap(2.0 * np.arctan2(y, x)) / 2.0
    angle = 0.5 * (angles.min() + angles.max())
    return np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])


def number(element):
    """Number of an element of its kind, which Akantu only prints."""
    return int(str(element).split(",")[1])


class Discretised:
    """The scene in Akantu: elastic stiffness, and contact forces and their tangent, unknowns 2 node + component, per unit of thickness."""

    def __init__(self, scene, stiffness, place):
        data, self.spring, self.points = scene.problem.data, stiffness, scene.points
        first, second = ([edge for sides in scene.contacts for edge in sides[k]] for k in range(2))
        self.turn = along_x(self.points[np.array(first)])
        text = section("contact_detector", master="second", slave="first", **DETECTOR)
        text += section("contact_resolution penalty_linear", name="first", epsilon_n=stiffness, **RESOLUTION)
        for body, (young, poisson) in enumerate(scene.materials()):
            law = {"E": young, "nu": poisson, "Plane_Stress": int(data["plane"] == "stress")}
            text += section("material elastic", name=f"body{body}", rho=1.0, **law)
        groups = mesh(self.points @ self.turn.T, scene.cells, scene.body, {"first": first, "second": second})
        groups.write(str(place / "scene.msh"), file_format="gmsh22", binary=False)
        (place / "scene.dat").write_text(text, encoding="ascii")
        akantu.parseInput(str(place / "scene.dat"))
        self.mesh = akantu.Mesh(2)
        self.mesh.read(str(place / "scene.msh"))
        self.coupler = akantu.CouplerSolidContact(self.mesh)
        self.solid, self.contact = self.coupler.getSolidMechanicsModel(), self.coupler.getContactMechanicsModel()
        self.solid.setMaterialSelector(akantu.MeshDataMaterialSelectorString("physical_names", self.solid))
        self.coupler.initFull(_analysis_method=akantu._static)
        self.contact.getContactDetector().setSurfaceSelector(akantu.PhysicalSurfaceSelector(self.mesh))
        self.solid.assembleStiffnessMatrix()
        back = kron(identity(len(self.points)), self.turn.T)
        self.stiffness = (back @ akantu.AkantuSparseMatrix(self.coupler.getDOFManager().getMatrix("K")) @ back.T).tocsr()
        self.edges = np.array(self.mesh.getConnectivity(akantu._segment_2))

    def pressed(self, u):
        """Contact forces on the nodes, and their tangent with the sign of a stiffness."""
        self.solid.getDisplacement()[:] = u.reshape(-1, 2) @ self.turn.T
        self.coupler.corrector()  # looks for pairs
        self.contact.assembleInternalForces()
        forces, normals = (np.array(values) @ self.turn for values in (self.contact.getInternalForce(), self.contact.getNormals()))
        gap, area = (np.array(values).ravel() for values in (self.contact.getGaps(), self.contact.getNodalArea()))
        pairs = [(pair.slave, *self.edges[number(pair.master)]) for pair in self.contact.getContactElements() if gap[pair.slave] > 0]
        nodes = np.array(pairs, int).reshape(-1, 3)
        s, a, b = (self.points + u.reshape(-1, 2))[nodes.T]
        along = ((s - a) * (b - a)).sum(axis=1) / ((b - a) ** 2).sum(axis=1)
        share, normal = np.column_stack([np.ones(len(nodes)), along - 1.0, -along]), normals[nodes[:, 0]]
        pushed = (forces[nodes[:, 0]] * normal).sum(axis=1)
        # A row a pair: how much its nodes move apart by their displacements.
        dofs = 2 * nodes[:, :, None] + np.arange(2)
        terms = (share[:, :, None] * normal[:, None]).ravel(), (np.repeat(np.arange(len(nodes)), 6), dofs.ravel())
        rows = coo_matrix(terms, (len(nodes), len(u))).tocsr()
        return rows.T @ pushed, rows.T @ diags(self.spring * area[nodes[:, 0]]) @ rows


def solved(scene, code):
    """Displacements, contact forces on the nodes, and iterations of Newton's method."""
    motions, given, force, q = scene.system(MOVED)
    for step in range(STEPS + 1):
        u = motions @ q + given
        pushed, tangent = code.pressed(u)
        residual = motions.T @ (force + pushed - code.stiffness @ u)
        left = np.linalg.norm(residual) / scene.problem.scale()
        if left <= TOLERANCE:
            return u, pushed, step
        q = q + splu((motions.T @ (code.stiffness + tangent) @ motions).tocsc()).solve(residual)
    raise RuntimeError(f"Akantu's contact has not converged in {STEPS} iterations: residual {left:.1e} of the load")


def main(folder, method, times):
    """Solves, and writes the answer."""
    sys.stdout = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # where Akantu itself writes
    problem = exported.Problem(folder)
    begin = time.perf_counter()
    scene = exported.Linear(problem)
    with tempfile.TemporaryDirectory(prefix="akantu-") as name:
        code = Discretised(scene, times * STIFFNESS * max(problem.data["young"]), pathlib.Path(name))
    u, pushed, steps = solved(scene, code)
    pressure = problem.pressures(pushed, scene.lengths())
    seconds = time.perf_counter() - begin
    file = f"akantu-{method}.vtu"
    # By meshio: in Akantu's own files every array has a size that is 4 bytes too large.
    fields = {"displacement": np.pad(u.reshape(-1, 2), ((0, 0), (0, 1))), "contact_pressure": pressure}
    meshio.write_points_cells(str(problem.folder / file), scene.points, [("quad", scene.cells)], point_data=fields)
    exported.report(code="akantu", version=akantu.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["contact"], "Akantu 5.0.7", "epsilon_n")
