"""An exported case by GetFEM: run_getfem.py FOLDER integral|basic [--times N]; writes getfem-METHOD.vtu, or .json, there.

integral: GetFEM's contact bricks in integral form, augmented Lagrangian in its default version, r = N E, multiplier linear on the contact side:
with a rigid obstacle, or of large sliding by rays between two meshes, whose gaps GetFEM finds itself.
basic: its basic contact brick on the exported rows and gaps, multiplier a nodal force. Displacements have the nodes of the exported cells. MUMPS.
"""

import time

import exported  # first: one thread

import numpy as np
from scipy.spatial import cKDTree

try:
    import getfem as gf
except ModuleNotFoundError:
    exported.missing("GetFEM", "apt install python3-getfem")

# GetFEM counts the nodes of a cell row by row from the lower left.
KINDS = {4: ("GT_QK(2,1)", "FEM_QK(2,1)", [0, 1, 3, 2]), 8: ("GT_Q2_INCOMPLETE(2)", "FEM_Q2_INCOMPLETE(2)", [0, 4, 1, 7, 5, 3, 6, 2])}
CONTACT, STEPS, TOLERANCE = 1, 100, 2e-10
RAY = 0.05  # longest ray over the size of the scene


class Body:
    """Mesh and displacement of a body, far from the other one: nodes at one place would be merged."""

    def __init__(self, problem, body, model):
        given = np.array(problem.data["cells"])
        transformation, element, order = KINDS[given.shape[1]]
        self.name, self.mesh = f"u{body}", gf.Mesh("empty", 2)
        corners = problem.points[given[problem.body == body][:, order]].transpose(2, 1, 0)
        self.mesh.add_convex(gf.GeoTrans(transformation), np.asfortranarray(corners))
        self.rule = gf.MeshIm(self.mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,5)"))
        self.space = gf.MeshFem(self.mesh, 2)
        self.space.set_fem(gf.Fem(element))
        self.nodes = np.unique(given[problem.body == body])
        away, found = cKDTree(self.space.basic_dof_nodes()[:, ::2].T).query(problem.points[self.nodes])
        if away.max() > 1e-9 * np.ptp(problem.points):
            raise RuntimeError("GetFEM took over another mesh than the exported one")
        # Dof of GetFEM of a node's component 0.
        self.dof = np.full(len(problem.points), -1)
        self.dof[self.nodes] = 2 * found
        model.add_fem_variable(self.name, self.space)
        model.add_initialized_data(f"E{body}", problem.data["young"][body])
        model.add_initialized_data(f"nu{body}", problem.data["poisson"][body])
        brick = {"strain": model.add_isotropic_linearized_elasticity_pstrain_brick,
                 "stress": model.add_isotropic_linearized_elasticity_pstress_brick}[problem.data["plane"]]
        brick(self.rule, self.name, f"E{body}", f"nu{body}")

    def side(self, edges):
        """Makes the contact side a region."""
        number = self.mesh.pid_from_coords(self.edge_points(edges))
        self.mesh.set_region(CONTACT, self.mesh.faces_from_pid(np.unique(number)))

    def edge_points(self, edges):
        return np.asfortranarray(self.points_of(np.unique(edges)))

    def points_of(self, nodes):
        return self.space.basic_dof_nodes()[:, self.dof[nodes]]


def supported(problem, model, bodies):
    """Loads and supports per unit of thickness; the latter are linear constraints."""
    force = problem.load() / problem.data["thickness"]
    for k, body in enumerate(bodies):
        own = np.zeros(body.space.nbdof())
        for c in range(2):
            own[body.dof[body.nodes] + c] = force[2 * body.nodes + c]
        model.add_explicit_rhs(body.name, own)
        rows = [([(node, c, 1.0)], value) for node, c, value in problem.data["held"] if body.dof[node] >= 0]
        for side in problem.data["tied"]:
            first, c = side["nodes"][0], side["component"]
            held = {node for node, component, _ in problem.data["held"] if component == c}
            rows += [([(node, c, 1.0), (first, c, -1.0)], 0.0) for node in side["nodes"][1:]
                     if body.dof[node] >= 0 and node not in held]
        if rows:
            matrix = gf.Spmat("empty", len(rows), body.space.nbdof())
            for i, (terms, _) in enumerate(rows):
                for node, c, factor in terms:
                    matrix.add(i, int(body.dof[node]) + c, factor)
            model.add_variable(f"held{k}", len(rows))
            model.add_constraint_with_multipliers(body.name, f"held{k}", matrix, np.array([value for _, value in rows]))


def started(problem, model, bodies):
    """Moves the body that contact alone holds until the widest gap is closed."""
    moved = problem.started(1.0)
    for body in bodies:
        own = np.zeros(body.space.nbdof())
        for c in range(2):
            own[body.dof[body.nodes] + c] = moved[2 * body.nodes + c]
        model.set_variable(body.name, own)


def integral(problem, model, bodies, times):
    """The bricks in integral form; returns a function to the pressures at the nodes of the first body."""
    if len(problem.data["contacts"]) > 1:
        raise ValueError("scenes with one contact are served")
    contact = problem.data["contacts"][0]
    if contact["second"] is not None:
        problem.drawn("run_getfem.py FOLDER basic")
    first = bodies[contact["first"]]
    first.side(np.array(contact["edges"]))
    linear, size = gf.MeshFem(first.mesh, 1), 1 if contact["second"] is None else 2
    linear.set_fem(gf.Fem("FEM_QK(2,1)"))
    multiplier = gf.MeshFem(first.mesh, size)
    multiplier.set_fem(gf.Fem("FEM_QK(2,1)"))
    model.add_filtered_fem_variable("p", multiplier, CONTACT)
    model.add_initialized_data("r", times * max(problem.data["young"]))
    if contact["second"] is None:
        if contact["arc"]:
            raise ValueError("the rigid obstacle of an arc is not set up")
        scalar = gf.MeshFem(first.mesh, 1)
        scalar.set_fem(gf.Fem(KINDS[len(problem.data["cells"][0])][1]))
        nodes = [node for node in contact["nodes"] if node["gap"] is not None]
        if len(nodes) < len(contact["nodes"]):
            raise ValueError("an obstacle with an edge has no smooth distance")
        places = scalar.basic_dof_nodes()
        normal, origin = np.array(contact["normal"]), np.array(contact["origin"])
        depth = -normal @ (places - origin[:, None])
        at = np.array([problem.points[node["node"]] for node in nodes])
        along = np.array([-normal[1], normal[0]])
        s, order = (at - origin) @ along, np.argsort((at - origin) @ along)
        above = np.array([node["gap"] for node in nodes]) + (at - origin) @ normal
        model.add_initialized_fem_data("away", scalar, depth + np.interp(along @ (places - origin[:, None]), s[order], above[order]))
        model.add_integral_contact_with_rigid_obstacle_brick(first.rule, first.name, "p", "away", "r", CONTACT, 1)
    else:
        second = bodies[contact["second"]]
        second.side(np.array(contact["opposite_edges"]))
        ray = RAY * np.ptp(problem.points)
        brick = model.add_integral_large_sliding_contact_brick_raytracing("r", ray)
        model.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, first.rule, CONTACT, first.name, "p")
        model.add_master_contact_boundary_to_large_sliding_contact_brick(brick, second.rule, CONTACT, second.name)

    def written(file):
        found = -model.variable("p").reshape(-1, size)
        dofs = np.sort(linear.basic_dof_on_region(CONTACT))
        if size == 2:
            at = np.array([problem.points[node["node"]] for node in contact["nodes"]])
            nearest = cKDTree(at).query(linear.basic_dof_nodes()[:, dofs].T)[1]
            found = (found * np.array([contact["nodes"][k]["normal"] for k in nearest])).sum(axis=1)
        pressure = np.zeros(linear.nbdof())
        pressure[dofs] = found.ravel()
        first.space.export_to_vtu(file, "ascii", first.space, model.variable(first.name), "displacement", linear, pressure, "contact_pressure")

    return written


def main(folder, method, times):
    """Solves, and writes the answer."""
    problem = exported.Problem(folder)
    gf.util_trace_level(0)
    begin = time.perf_counter()
    model = gf.Model("real")
    bodies = [Body(problem, k, model) for k in range(len(problem.data["young"]))]
    supported(problem, model, bodies)
    written = {"integral": integral, "basic": basic}[method](problem, model, bodies, times)
    started(problem, model, bodies)
    scale = np.abs(problem.load().reshape(-1, 2).sum(axis=0)).max() or 1.0
    # What the load asks, and what rounding leaves of the forces that a motion across the gap makes.
    gaps = np.abs(problem.gap[np.isfinite(problem.gap)]).max()
    residual = TOLERANCE * scale + 1e-12 * max(problem.data["young"]) * gaps
    steps, converged = model.solve("max_res", residual, "max_iter", STEPS, "lsolver", "mumps")
    seconds = time.perf_counter() - begin
    if not converged:
        raise RuntimeError(f"GetFEM has not converged in {steps} iterations")
    file = f"getfem-{method}." + ("vtu" if method == "integral" else "json")
    written(str(problem.folder / file))
    version = gf.getfem_env("version")
    exported.report(code="getfem", version=version, file=file, iterations=int(steps), seconds=seconds)


def basic(problem, model, bodies, times):
    """The basic brick: nodal forces against the exported rows, for all bodies in one variable by constraints of w."""
    known = np.isfinite(problem.gap)
    rows = problem.rows[known].tocoo()
    count = int(known.sum())
    # w = sum of the rows of all bodies; the brick takes one variable, which w is.
    model.add_variable("w", count)
    model.add_variable("force", count)
    minus = gf.Spmat("empty", count, count)
    for k in range(count):
        minus.add(k, k, -1.0)
    model.add_linear_term(bodies[0].rule, "0*force(1)*Test_force(1)")
    model.add_explicit_matrix("force", "w", minus, False, False)
    model.add_explicit_matrix("w", "force", minus, False, False)
    for body in bodies:
        matrix = gf.Spmat("empty", count, body.space.nbdof())
        for i, j, value in zip(rows.row, rows.col, rows.data):
            if body.dof[j // 2] >= 0:
                matrix.add(int(i), int(body.dof[j // 2]) + int(j % 2), value)
        model.add_explicit_matrix("force", body.name, matrix, False, False)
        matrix.transpose()
        model.add_explicit_matrix(body.name, "force", matrix, False, False)
    unit = gf.Spmat("empty", count, count)
    for k in range(count):
        unit.add(k, k, 1.0)
    model.add_variable("contact", count)
    model.add_initialized_data("r", times * max(problem.data["young"]))
    model.add_initialized_data("gap", problem.gap[known])
    model.add_basic_contact_brick("w", "contact", "r", unit, "gap", "", 1)

    def written(file):
        pressure, gap = np.zeros(len(known)), np.full(len(known), np.inf)
        pressure[known] = -problem.data["thickness"] * model.variable("contact") / problem.area[known]
        gap[known] = problem.gap[known] - model.variable("w")
        exported.write_json(problem, file.rsplit("/", 1)[-1], f"GetFEM {gf.getfem_env('version')}", pressure, gap)

    return written


if __name__ == "__main__":
    exported.run(main, __doc__, ["integral", "basic"], "GetFEM 5.4.2", "r")
