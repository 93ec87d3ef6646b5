"""An exported case by FElupe: run_felupe.py FOLDER contact [--times N]; writes felupe-contact.vtu there.

contact: FElupe's contact knows rigid planes only (ContactRigidPlane): the force of a node is a multiplier times its overlap with a plane that
moves with one point. By its documentation's best practice the multiplier is the mean nodal stiffness of the body at these nodes, here N times
that. A flat rigid side is one plane for all nodes. All other sides are ours: each node of the first side has a plane of its own, square to the
exported normal, with a multiplier of that node's stiffness. It is fixed at the exported gap or, with a second body, moves with the node that
faces it there: these pairs are found by us, not by FElupe, and where no node faces a node, the case is refused.
Cells with 8 or 4 nodes, laws for small strain and Newton's method are FElupe's; sides that stay flat, an overlap to start with where contact
alone holds a body, and the residual over all forces are ours. SuperLU. Pressures are FElupe's contact forces over the areas of the nodes.
"""

import pathlib
import sys
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse.linalg import spsolve

# FElupe is there where oracles/peers/setup.sh has put it.
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / ".python/felupe"))

try:
    import felupe
    import meshio  # what FElupe writes by
except ModuleNotFoundError as absent:
    exported.missing(f"FElupe ({absent.name})", "python3 -m pip install felupe meshio")

LAWS = {"strain": "LinearElasticPlaneStrain", "stress": "LinearElasticPlaneStress"}
CELLS = {4: ("quad", "RegionQuad"), 8: ("quad8", "RegionQuadraticQuad")}
STEPS, TOLERANCE = 100, 1e-6  # of the residual over all forces; FElupe rounds stresses as those of strains beside 1
MOVED = 0.2  # part of the way to the widest gap that it starts at
FACING = 1e-4  # part of the shortest contact edge by which nodes that face one another may miss
SAME = 1e-9  # lengths are the same, over the size of the scene


class Scene:
    """The scene in FElupe, per unit of thickness: nodes, then the points that hold rigid planes."""

    def __init__(self, problem, multiplier):
        data = problem.data
        self.points, self.size = problem.points, np.ptp(problem.points)
        planes = [self.of_contact(contact) for contact in data["contacts"]]
        kind, name = CELLS[problem.cells.shape[1]]
        region, law = getattr(felupe, name), getattr(felupe.constitution, LAWS[data["plane"]])
        self.solids = []
        for body, (young, poisson) in enumerate(zip(data["young"], data["poisson"])):
            mesh = felupe.Mesh(self.points, problem.cells[problem.body == body], kind)
            field = felupe.FieldContainer([felupe.Field(region(mesh), dim=2)])
            self.solids.append(felupe.SolidBody(law(young, poisson), field))
            self.solids[-1].assemble.matrix()  # of which contacts take the mean
        self.field = self.solids[0].field
        self.contacts = []
        for contact, own in zip(data["contacts"], planes):
            body = [self.solids[contact["first"]]]
            self.contacts += [felupe.ContactRigidPlane(self.field, nodes, centre, normal, multiplier=multiplier, items=body)
                              for nodes, centre, normal in own]

    def of_contact(self, contact):
        """Nodes, centre and normal of each plane of a contact."""
        across = -np.array(contact["normal"])
        nodes = [node for node in contact["nodes"] if node["gap"] is not None]
        places = np.array([self.points[node["node"]] + node["gap"] * np.array(node["normal"]) for node in nodes])
        if contact["second"] is None and not contact["arc"] and np.ptp(places @ across) < SAME * self.size:
            return [([node["node"] for node in nodes], self.added(places[0]), across)]
        centres = self.facing(contact, places) if contact["second"] is not None else [self.added(place) for place in places]
        return [([node["node"]], centre, -np.array(node["normal"])) for node, centre in zip(nodes, centres)]

    def facing(self, contact, places):
        """Nodes of the second body at these places."""
        others = np.unique(contact["opposite_edges"])
        away = np.linalg.norm(places[:, None] - self.points[others], axis=2)
        if away.min(axis=1).max() > FACING * np.linalg.norm(np.diff(places, axis=0), axis=1).min():
            sys.exit("FElupe's planes move with one point: a case whose nodes face edges of another body is not set up")
        return others[away.argmin(axis=1)]

    def added(self, place):
        """A point that is held."""
        self.points = np.vstack([self.points, place])
        return len(self.points) - 1


def solved(problem, scene):
    """Displacements of all points by FElupe's Newton method, and iterations."""
    motions, given, force, start = problem.system(MOVED)
    planes = len(scene.points) - len(problem.points)  # which do not move by themselves
    scene.field[0].values[:] = np.pad((motions @ start + given).reshape(-1, 2), ((0, planes), (0, 0)))
    motions.resize(2 * len(scene.points), motions.shape[1])
    load = felupe.PointLoad(scene.field, np.arange(len(problem.points)), force.reshape(-1, 2))

    def solve(matrix, left):
        return motions @ spsolve((motions.T @ matrix @ motions).tocsc(), motions.T @ left)

    def check(dx, f, ftol, **_):
        out = np.linalg.norm(motions.T @ f) / np.linalg.norm(f)
        return np.linalg.norm(dx), out, out < ftol

    items = [*scene.solids, *scene.contacts, load]
    found = felupe.newtonraphson(scene.field, items=items, solve=solve, check=check, tol=TOLERANCE, maxiter=STEPS, verbose=0)
    return found.x[0].values, found.iterations


def main(folder, method, times):
    """Solves, and writes the answer."""
    problem = exported.Problem(folder, centres=False)
    begin = time.perf_counter()
    scene = Scene(problem, times)
    u, steps = solved(problem, scene)
    pushed = -problem.data["thickness"] * sum(plane.results.force for plane in scene.contacts).toarray().ravel()[: 2 * len(problem.points)]
    pressure = problem.pressures(pushed)
    seconds = time.perf_counter() - begin
    file, whole = f"felupe-{method}.vtu", felupe.Mesh(problem.points, problem.cells, CELLS[problem.cells.shape[1]][0])
    fields = {"displacement": np.pad(u[: len(problem.points)], ((0, 0), (0, 1))), "contact_pressure": pressure}
    whole.write(str(problem.folder / file), point_data=fields)
    exported.report(code="felupe", version=felupe.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["contact"], "FElupe 11.3.0", "the multiplier")
