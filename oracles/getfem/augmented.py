"""Pins in holes in GetFEM, by an augmented Lagrangian written in its weak form language: two meshes that need not match.

Virtual work of the contact on the pin's arc: <p + r (w - g)>+ dw, and p = <p + r (w - g)>+ weakly; p is the pressure, w = (u - v).n the
approach of pin u and hole v along the pin's outward normal n, g the gap along n, r any positive stiffness (Alart and Curnier 1991). v is
read where the ray along n meets the hole. Displacements quadratic, p linear. Units mm, N, MPa, rad.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import getfem as gf
import numpy as np

import polar
from polar import AXIS, CONTACT, FACE, HELD

STIFFNESS = 10.0  # r = STIFFNESS E/R
TOLERANCE, STEPS = 1e-6, 60  # [N]
INSIDE = 1e-7  # how far below the hole's surface v is read, in radii: an element's edge leaves the circle by less


def solve(scene, level, _method):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and dofs of a scene on the meshes of a level."""
    if scene["case"] not in ("pin-rod", "pin-plate"):
        raise ValueError(f"case {scene['case']!r}: use one of pin-rod, pin-plate")
    gf.util_trace_level(0)
    pin, body = polar.pin(scene, level), polar.body(scene, level)
    model = gf.Model("real")
    elastic(model, "u", pin, scene.get("pin_young", scene.get("young")), scene.get("pin_poisson", scene.get("poisson")))
    elastic(model, "v", body, scene.get("rod_young", scene.get("young")), scene.get("rod_poisson", scene.get("poisson")))
    loaded(model, pin, body, scene)
    pressed(model, pin, body, scene)
    steps, converged = model.solve("max_res", TOLERANCE, "max_iter", STEPS, "lsolver", "mumps")
    if not converged:
        raise RuntimeError(f"{scene['case']}: GetFEM has not converged in {steps} steps")
    return measures(model, pin, scene)


def version():
    """Of GetFEM."""
    return gf.getfem_env("version")


def rule(mesh, degree=5):
    """Integration, exact for polynomials of a degree."""
    return gf.MeshIm(mesh, degree)


def space(mesh, size, degree):
    """Lagrange elements of `size` components."""
    elements = gf.MeshFem(mesh, size)
    elements.set_classical_fem(degree)
    return elements


def elastic(model, name, mesh, young, poisson):
    """A body in plane stress on its line of symmetry."""
    model.add_fem_variable(name, space(mesh, 2, 2))
    model.add_initialized_data("E" + name, young)
    model.add_initialized_data("nu" + name, poisson)
    model.add_isotropic_linearized_elasticity_pstress_brick(rule(mesh), name, "E" + name, "nu" + name)
    model.add_normal_Dirichlet_condition_with_multipliers(rule(mesh), name, space(mesh, 1, 2), AXIS)


def loaded(model, pin, body, scene):
    """Supports and half the force; per unit of thickness."""
    force = 0.5 * scene["force"] / scene["thickness"]
    if scene["case"] == "pin-rod":
        model.add_normal_Dirichlet_condition_with_multipliers(rule(pin), "u", space(pin, 1, 2), HELD)
        # The end face rises as one by `rise`.
        model.add_variable("rise", 1)
        model.add_filtered_fem_variable("q", space(body, 1, 2), FACE)
        model.add_linear_term(rule(body), "q*(Test_v(2)-Test_rise)+(v(2)-rise)*Test_q", FACE)
        model.add_explicit_rhs("rise", [force])
    else:
        model.add_Dirichlet_condition_with_multipliers(rule(body), "v", space(body, 2, 2), HELD)
        elements = model.mesh_fem_of_variable("u")
        places = elements.basic_dof_nodes()
        middle = np.flatnonzero(np.hypot(*places) < 1e-9)[1]
        weight = np.zeros(elements.nbdof())
        weight[middle] = -force
        model.add_explicit_rhs("u", weight)


def pressed(model, pin, body, scene):
    """The contact, and a start with the pin moved down by the clearance."""
    radius, up = scene["pin_radius"], scene["clearance"]
    hole = radius + up
    model.add_filtered_fem_variable("p", space(pin, 1, 1), CONTACT)
    modulus = min(model.variable("Eu")[0], model.variable("Ev")[0])
    model.add_initialized_data("r", STIFFNESS * modulus / radius)
    # On the ray at the angle a from the downward vertical, the hole is at -c cos a + sqrt(H^2 - c^2 sin^2 a).
    model.add_macro("n", "X/Norm(X)")
    model.add_macro("away", f"({up}*n(2)+sqrt({hole}*{hole}-{up}*{up}*n(1)*n(1)))")
    model.add_macro("gap", f"(away-{radius})")
    model.add_interpolate_transformation_from_expression("facing", pin, body, f"(away+{INSIDE * radius})*n")
    model.add_macro("approach", "((u-Interpolate(v,facing)).n)")
    model.add_macro("pressure", "pos_part(p+r*(approach-gap))")
    work = "pressure*((Test_u-Interpolate(Test_v,facing)).n)+(pressure-p)*Test_p/r"
    model.add_nonlinear_term(rule(pin, 9), work, CONTACT)
    start = np.zeros(model.mesh_fem_of_variable("u").nbdof())
    if scene["case"] == "pin-rod":
        lifted = np.zeros(model.mesh_fem_of_variable("v").nbdof())
        lifted[1::2] = up
        model.set_variable("v", lifted)
    else:
        start[1::2] = -up
    model.set_variable("u", start)


def measures(model, pin, scene):
    """The quantities that are asked for: integrals of p over the arc, and p along it, linear between the corners of the elements."""
    stations, thickness = scene["stations"], scene["thickness"]
    elements = model.mesh_fem_of_variable("p")
    theta = angle(*elements.basic_dof_nodes()[:, np.sort(elements.basic_dof_on_region(CONTACT))])
    order = np.argsort(theta)
    theta, p = theta[order], model.variable("p")[order]
    if p[-1] > 1e-2 * p.max():
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    force, moment, lift = (
        gf.asm_generic(rule(pin, 9), 0, f"p*{factor}", CONTACT, model) for factor in ("1", "sqr(atan2(X(1),-X(2)))", "(-X(2)/Norm(X))")
    )
    width = stations[1] - stations[0]
    fine = stations[:, None] + width * (np.arange(400) - 199.5) / 400
    return {
        "half_width": float(2 * np.sqrt(moment / force)),
        "peak": float(top(theta, p)),
        "resultant": float(2 * thickness * lift),
        "pressure": np.interp(fine, theta, p).mean(axis=1),
        "dofs": int(model.nbdof()),
    }


def top(theta, p):
    """Largest value of the parabola through the largest nodal pressure and its neighbours; even about 0."""
    theta, p = np.concatenate([-theta[1:2], theta]), np.concatenate([p[1:2], p])
    k = 1 + np.argmax(p[1:-1])
    a, b, c = np.polyfit(theta[k - 1 : k + 2] - theta[k], p[k - 1 : k + 2], 2)
    return c - b**2 / (4 * a)


def angle(x, y):
    """Angle from the downward vertical [rad]."""
    return np.arctan2(x, -y)
