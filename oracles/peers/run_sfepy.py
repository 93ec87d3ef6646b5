"""An exported case by SfePy: run_sfepy.py FOLDER contact [--times N]; writes sfepy-contact.vtu there.

contact: SfePy's term dw_contact, pressure = K overlap at the points of integration of both sides, each against the nearest edge of the other
one that SfePy finds on the deformed mesh; K = N 10 E per mm, and up to N = 1 order 10, the numbers of its own example, else order 30. A rigid
body is a row of fully held cells along the contact. In the plane the term has edges with 2 nodes alone, so that cells with 8 nodes are cut into
4 with 4 nodes. A body that contact alone holds starts with an overlap: at mere touching the tangent is singular, and much more of it makes
Newton's method wander. Newton's method with SfePy's residuals and tangents, SuperLU. Pressures are SfePy's contact forces on the nodes of the
first side over their lengths; it integrates each side for itself, so that the forces on the other one differ a little.
"""

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
    exported.missing(f"SfePy ({absent.name})", "python3 -m pip install sfepy")

STIFFNESS, ORDERS = 10.0, [10, 30]  # K/E [1/mm], order of the quadrature along the contact: up to the first choice, beyond it
STEPS, TOLERANCE = 200, 1e-8  # of the residual over the load
MOVED = 0.2  # part of the way to the widest gap that it starts at


def unknown(field):
    """Displacement and its test function, of one problem: SfePy numbers them anew for each."""
    return FieldVariable("u", "unknown", field), FieldVariable("v", "test", field, primary_var_name="u")


class Discretised:
    """The scene in SfePy: elastic stiffness, and contact forces and their tangent, unknowns 2 node + component, per unit of thickness."""

    def __init__(self, scene, stiffness, order):
        self.mesh = Mesh.from_data("scene", scene.points, None, [scene.cells.astype(np.int32)], [scene.body], ["2_4"])
        domain = FEDomain("domain", self.mesh)
        field = Field.from_args("displacement", np.float64, "vector", domain.create_region("all", "all"), approx_order=1)
        u, v = unknown(field)
        terms = []
        for body, law in enumerate(scene.materials()):
            solid = Material(f"solid{body}", D=stiffness_from_youngpoisson(2, *law, plane=scene.problem.data["plane"]))
            region = domain.create_region(f"body{body}", f"cells of group {body}")
            arguments = {solid.name: solid, "u": u, "v": v}
            terms.append(Term.new(f"dw_lin_elastic({solid.name}.D, v, u)", Integral("of cells", order=2), region, **arguments))
        self.elastic = Problem("elastic", equations=Equations([Equation("balance", sum(terms[1:], terms[0]))]))
        pairs, (u, v) = [], unknown(field)
        spring = Material("spring", values={".K": stiffness})
        for k, sides in enumerate(scene.contacts):
            nodes = ",".join(map(str, np.unique(np.concatenate(sides))))
            region = domain.create_region(f"contact{k}", f"vertex {nodes}", "facet")
            pairs.append(Term.new("dw_contact(spring.K, v, u)", Integral("of edges", order=order), region, spring=spring, u=u, v=v))
        self.contact = Problem("contact", equations=Equations([Equation("balance", sum(pairs[1:], pairs[0]))]))
        for part in self.elastic, self.contact:
            part.time_update()
            part.update_materials()
            if hasattr(part.equations, "init_state"):  # SfePy 2022 or later keeps the unknowns there
                part.equations.init_state()
        self.stiffness = self.elastic.get_evaluator().eval_tangent_matrix(np.zeros(scene.points.size), mtx=self.elastic.mtx_a).copy()

    def pressed(self, u):
        """Contact forces on the nodes, and their tangent with the sign of a stiffness."""
        evaluate = self.contact.get_evaluator()
        return -evaluate.eval_residual(u), evaluate.eval_tangent_matrix(u, mtx=csr_matrix(self.stiffness.shape))


def solved(scene, code):
    """Displacements by SfePy's Newton method, and iterations."""
    motions, given, force, q = scene.system(MOVED)

    def residual(q):
        u = motions @ q + given
        return motions.T @ (code.stiffness @ u - force - code.pressed(u)[0])

    def tangent(q):
        return (motions.T @ (code.stiffness + code.pressed(motions @ q + given)[1]) @ motions).tocsr()

    scale, status = scene.problem.scale(), {}
    settings = {"i_max": STEPS, "eps_a": TOLERANCE * scale}
    q = Newton(settings, fun=residual, fun_grad=tangent, lin_solver=ScipyDirect({}), status=status)(q)
    if status["condition"] != 0:
        raise RuntimeError(f"SfePy has not converged in {status['n_iter']} iterations: residual {status['err'] / scale:.1e} of the load")
    return motions @ q + given, status["n_iter"]


def main(folder, method, times):
    """Solves, and writes the answer."""
    output.set_output(quiet=True)
    problem = exported.Problem(folder)
    begin = time.perf_counter()
    scene = exported.Linear(problem)
    code = Discretised(scene, times * STIFFNESS * max(problem.data["young"]), ORDERS[times > 1.0])
    u, steps = solved(scene, code)
    pressure = problem.pressures(code.pressed(u)[0], scene.lengths())
    fields = {"displacement": u.reshape(-1, 2), "contact_pressure": pressure[:, None]}
    seconds = time.perf_counter() - begin
    file = f"sfepy-{method}.vtu"
    code.mesh.write(str(problem.folder / file), out={name: Struct(mode="vertex", data=data) for name, data in fields.items()})
    exported.report(code="sfepy", version=sfepy.__version__, file=file, iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["contact"], "SfePy 2021.4 and 2026.3", "K")
