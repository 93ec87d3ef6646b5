"""An exported case by SfePy: run_sfepy.py FOLDER contact|stiff-contact; writes sfepy-METHOD.vtu there.

contact: SfePy's term dw_contact, pressure = K overlap at the points of integration of both sides, each against the nearest edge of the other
one that SfePy finds on the deformed mesh; K = 10 E per mm and order 10, the numbers of its own example (stiff-contact: 100 E, order 30). A
rigid body is a row of fully held cells along the contact. In the plane the term has edges with 2 nodes alone, so that cells with 8 nodes are
cut into 4 with 4 nodes. A body that contact alone holds starts with an overlap: at mere touching the tangent is singular, and much more of it
makes Newton's method wander. Newton's method with SfePy's residuals and tangents, SuperLU. Pressures are SfePy's contact forces on the nodes
of the first side over their lengths; it integrates each side for itself, so that the forces on the other one differ a little.
"""

import sys
import time

import exported  # first: one thread

import numpy as np
from scipy.sparse import csr_matrix

try:
    import sfepy
    from sfepy.base.base import Struct, output
    from sfepy.discrete import Equation, Equations, FieldVariable, Integral, Material, Problem
    from sfepy.discrete.fem import FEDomain, Field, Mesh
    from sfepy.mechanics.matcoefs import stiffness_from_youngpoisson
    from sfepy.solvers.ls import ScipyDirect
    from sfepy.solvers.nls import Newton
    from sfepy.terms import Term
except ModuleNotFoundError as absent:
    exported.missing(f"SfePy ({absent.name})")

SETTINGS = {"contact": (10.0, 10), "stiff-contact": (100.0, 30)}  # K/E [1/mm], order of the quadrature along the contact
STEPS, TOLERANCE = 200, 1e-8  # of the residual over the load
MOVED = 0.2  # part of the widest gap
START = 1e-6  # overlap to begin with where there is no gap, over the size of the scene


def unknown(field):
    """Displacement and its test function, of one problem: SfePy numbers them anew for each."""
    return FieldVariable("u", "unknown", field), FieldVariable("v", "test", field, primary_var_name="u")


class Discretised:
    """The scene in SfePy: elastic stiffness, and contact forces and their tangent, unknowns 2 node + component, per unit of thickness."""

    def __init__(self, problem, scene, stiffness, order):
        self.used, cells = np.unique(scene.cells, return_inverse=True)
        cells = cells.reshape(-1, 4).astype(np.int32)
        self.mesh = Mesh.from_data("scene", scene.points[self.used], None, [cells], [scene.body], ["2_4"])
        domain = FEDomain("domain", self.mesh)
        self.place = {int(node): k for k, node in enumerate(self.used)}
        field = Field.from_args("displacement", np.float64, "vector", domain.create_region("all", "all"), approx_order=1)
        u, v = unknown(field)
        terms = []
        for body in range(scene.body.max() + 1):
            k = min(body, len(problem.data["young"]) - 1)
            young, poisson = problem.data["young"][k], problem.data["poisson"][k]
            solid = Material(f"solid{body}", D=stiffness_from_youngpoisson(2, young, poisson, plane=problem.data["plane"]))
            region = domain.create_region(f"body{body}", f"cells of group {body}")
            arguments = {solid.name: solid, "u": u, "v": v}
            terms.append(Term.new(f"dw_lin_elastic({solid.name}.D, v, u)", Integral("of cells", order=2), region, **arguments))
        self.elastic = Problem("elastic", equations=Equations([Equation("balance", sum(terms[1:], terms[0]))]))
        pairs, (u, v) = [], unknown(field)
        spring = Material("spring", values={".K": stiffness})
        for k, sides in enumerate(scene.contacts):
            nodes = ",".join(str(self.place[int(node)]) for node in np.unique(np.concatenate(sides)))
            region = domain.create_region(f"contact{k}", f"vertex {nodes}", "facet")
            pairs.append(Term.new("dw_contact(spring.K, v, u)", Integral("of edges", order=order), region, spring=spring, u=u, v=v))
        self.contact = Problem("contact", equations=Equations([Equation("balance", sum(pairs[1:], pairs[0]))]))
        for part in self.elastic, self.contact:
            part.time_update()
            part.update_materials()
        self.stiffness = self.elastic.get_evaluator().eval_tangent_matrix(np.zeros(2 * len(self.used)), mtx=self.elastic.mtx_a).copy()

    def pressed(self, u):
        """Contact forces on the nodes, and their tangent with the sign of a stiffness."""
        evaluate = self.contact.get_evaluator()
        return -evaluate.eval_residual(u), evaluate.eval_tangent_matrix(u, mtx=csr_matrix(self.stiffness.shape))


def started(problem, scene):
    """Displacements by which the body that contact alone holds overlaps."""
    contact = problem.data["contacts"][0]
    normal, widest = np.array(contact["normal"]), max(node["gap"] for node in contact["nodes"])
    axis = int(np.argmax(np.abs(normal)))
    held = {int(problem.body[(problem.cells == node).any(axis=1)][0]) for node, c, _ in problem.data["held"] if c == axis}
    moved = np.zeros((len(scene.points), 2))
    for sign, body in (1.0, contact["first"]), (-1.0, contact["second"]):
        if body is not None and body not in held:
            moved[np.unique(scene.cells[scene.body == body])] = sign * (MOVED * widest + START * np.ptp(problem.points)) * normal
            break
    return moved.ravel()


def solved(problem, scene, code):
    """Displacements of SfePy's nodes by its Newton method, and iterations."""
    motions, given = problem.motions()
    # Of all nodes to those of SfePy; a rigid body does not move.
    dofs = np.column_stack([2 * code.used, 2 * code.used + 1]).ravel()
    more = 2 * len(scene.points) - motions.shape[0]
    motions.resize(motions.shape[0] + more, motions.shape[1])
    motions, given = motions[dofs], np.append(given, np.zeros(more))[dofs]
    motions = motions[:, np.flatnonzero(np.asarray(motions.sum(axis=0)).ravel())]
    force = np.append(problem.load() / problem.data["thickness"], np.zeros(more))[dofs]
    q = motions.T @ (started(problem, scene)[dofs] - given) / np.asarray(motions.sum(axis=0)).ravel()

    def residual(q):
        u = motions @ q + given
        return motions.T @ (code.stiffness @ u - force - code.pressed(u)[0])

    def tangent(q):
        return (motions.T @ (code.stiffness + code.pressed(motions @ q + given)[1]) @ motions).tocsr()

    scale = np.abs(force.reshape(-1, 2).sum(axis=0)).max() or max(problem.data["young"]) * np.abs(given).max()
    status, settings = {}, {"i_max": STEPS, "eps_a": TOLERANCE * scale}
    q = Newton(settings, fun=residual, fun_grad=tangent, lin_solver=ScipyDirect({}), status=status)(q)
    if status["condition"] != 0:
        raise RuntimeError(f"SfePy has not converged in {status['n_iter']} iterations: residual {status['err'] / scale:.1e} of the load")
    return motions @ q + given, status["n_iter"]


def pressures(problem, scene, code, u):
    """Pressures at SfePy's nodes: contact forces of the first side along the normal, over the lengths of the nodes."""
    pushed, pressure = code.pressed(u)[0].reshape(-1, 2), np.zeros(len(code.used))
    for contact, (edges, _) in zip(problem.data["contacts"], scene.contacts):
        length = np.zeros(len(scene.points))
        for edge in edges:
            length[list(edge)] += 0.5 * np.linalg.norm(scene.points[edge[1]] - scene.points[edge[0]])
        for node in contact["nodes"]:
            k = code.place[node["node"]]
            pressure[k] = -pushed[k] @ node["normal"] / length[node["node"]]
    return pressure


def main(folder, method):
    """Solves, and writes the answer."""
    output.set_output(quiet=True)
    problem = exported.Problem(folder)
    begin = time.perf_counter()
    scene = exported.Linear(problem)
    stiffness, order = SETTINGS[method]
    code = Discretised(problem, scene, stiffness * max(problem.data["young"]), order)
    u, steps = solved(problem, scene, code)
    fields = {"displacement": u.reshape(-1, 2), "contact_pressure": pressures(problem, scene, code, u)[:, None]}
    seconds = time.perf_counter() - begin
    file = f"sfepy-{method}.vtu"
    code.mesh.write(str(problem.folder / file), out={name: Struct(mode="vertex", data=data) for name, data in fields.items()})
    exported.report(code="sfepy", version=sfepy.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    main(*sys.argv[1:])
