"""The scene `cylinder` in GetFEM, timed: getfem_peer.py PROBLEM.json [REPEATS]; prints one JSON object.

What GetFEM's own contact demonstrations do in small strain, on the given mesh:
- displacement u: 8-node serendipity elements (FEM_Q2_INCOMPLETE) on 8-node cells, 3 x 3 Gauss points;
- contact: integral contact brick with the rigid obstacle y, signed distance of the undeformed surface, so that
  the gap is y + u_y >= 0; augmented Lagrangian, unsymmetric Alart-Curnier (option 1, GetFEM's default), r = E;
- multiplier lambda [MPa], p = -lambda: trace of the 4-node element on the candidate edges, linear between corners,
  stable under quadratic displacements; p swings below zero by up to 1.5 % of its peak beyond the contact;
- u_x = 0 on the axis: multipliers on the normal component;
- GetFEM's own Newton iteration, a factorisation by MUMPS each step.

The iteration starts from the whole body moved down until the last candidate touches: it does not know the answer, and
from u = 0 the tangent would be singular. It stops at a residual of 1e-10 of the load.

peak: largest nodal p [MPa]; half_width: 2 sqrt(int p x^2 / int p) [mm]; resultant: 2 t int p dx, both halves, t the
thickness [N/mm for t = 1], positive in compression. Integrals by GetFEM over the deformable edges, p as it is.
"""

import time

import common  # first: one thread

import numpy as np

try:
    import getfem as gf
except ModuleNotFoundError:
    common.missing("GetFEM (package python3-getfem)")

# GetFEM counts the nodes of a cell row by row from the lower left; ours: corners, then middles of 01, 12, 23, 30
ORDER = [0, 4, 1, 7, 5, 3, 6, 2]
CONTACT, LOAD, AXIS = 1, 2, 3
QUADRATIC, LINEAR, GAUSS = "FEM_Q2_INCOMPLETE(2)", "FEM_QK(2,1)", "IM_GAUSS_PARALLELEPIPED(2,5)"
TOLERANCE, MOST_STEPS = 1e-10, 60


def imported(problem):
    """The mesh in GetFEM with its three boundary regions."""
    points = problem["points"]
    mesh = gf.Mesh("empty", 2)
    corners = points[problem["cells"][:, ORDER]].transpose(2, 1, 0)
    mesh.add_convex(gf.GeoTrans("GT_Q2_INCOMPLETE(2)"), np.asfortranarray(corners))
    number = mesh.pid_from_coords(points.T)
    nodes = {CONTACT: problem["contact_first"], LOAD: problem["load_edges"], AXIS: problem["held"][:, 0]}
    for region, of in nodes.items():
        mesh.set_region(region, mesh.faces_from_pid(np.unique(number[of.ravel()])))
    if mesh.nbpts() != len(points) or mesh.region(CONTACT).shape[1] != len(problem["contact_first"]):
        raise RuntimeError("GetFEM took over another mesh than the given one")
    return mesh


def element(mesh, size, name):
    """Finite element space of `size` components."""
    space = gf.MeshFem(mesh, size)
    space.set_fem(gf.Fem(name))
    return space


def assembled(problem, mesh, rule):
    """The model with everything assembled that does not change from step to step, moved to the start."""
    space, scalar = element(mesh, 2, QUADRATIC), element(mesh, 1, QUADRATIC)
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    model.add_initialized_data("E", problem["young"][0])
    model.add_initialized_data("nu", problem["poisson"][0])
    model.add_isotropic_linearized_elasticity_pstrain_brick(rule, "u", "E", "nu")
    model.add_initialized_data("traction", problem["traction"])
    model.add_source_term_brick(rule, "u", "traction", LOAD)
    model.add_normal_Dirichlet_condition_with_multipliers(rule, "u", scalar, AXIS)
    model.add_filtered_fem_variable("lambda", element(mesh, 1, LINEAR), CONTACT)
    model.add_initialized_fem_data("obstacle", scalar, scalar.eval("y"))
    model.add_initialized_data("r", problem["young"][0])
    model.add_integral_contact_with_rigid_obstacle_brick(rule, "u", "lambda", "obstacle", "r", CONTACT, 1)
    start = np.zeros(space.nbdof())
    start[1::2] = -common.facing(problem)[1]
    model.set_variable("u", start)
    model.assembly("build_all")
    return model


def main():
    """Solves as often as asked, each time from a new model."""
    problem, repeats = common.arguments("getfem_peer.py")
    gf.util_trace_level(0)
    mesh = imported(problem)
    rule = gf.MeshIm(mesh, gf.Integ(GAUSS))
    assembly, seconds = [], []
    for _ in range(repeats):
        begin = time.perf_counter()
        model = assembled(problem, mesh, rule)
        ready = time.perf_counter()
        steps, converged = model.solve("max_res", TOLERANCE, "max_iter", MOST_STEPS, "lsolver", "mumps")
        pressure = -model.variable("lambda")
        seconds.append(time.perf_counter() - ready)
        assembly.append(ready - begin)
        if not converged:
            raise RuntimeError(f"GetFEM did not converge in {steps} steps")
    force, moment = (gf.asm_generic(rule, 0, f"-lambda{by}", CONTACT, model) for by in ("", "*X(1)*X(1)"))
    common.report(
        code="getfem",
        version=gf.getfem_env("version"),
        freedoms=int(model.nbdof()),
        steps=int(steps),
        seconds=seconds,
        assembly_seconds=assembly,
        counted="Newton iteration of GetFEM with MUMPS: contact terms, factorisations, line search, pressures; "
        "assembly_seconds apart: model, stiffness, load, first contact terms; not counted: import of the mesh",
        peak=float(pressure.max()),
        half_width=float(2.0 * np.sqrt(moment / force)),
        resultant=float(2.0 * problem["thickness"] * force),
    )


if __name__ == "__main__":
    main()
