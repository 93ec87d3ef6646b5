"""Hertz's contact on own meshes: a cylinder's quarter on a rigid plane, and a block that carries the half-plane's tractions."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np

from quadrilaterals import HERTZ, GROWTH, Model, block, disc, facets_on, growing, halved, join, meshed


def truncated_hertz(scene, level):
    """A block on a rigid parabola, under Hertz's tractions on its other sides."""
    a, modulus, load = hertz(scene)
    side = scene["size"] * a
    near = np.linspace(0.0, scene["stretch"] * a, round(HERTZ * scene["stretch"]) + 1)
    x = halved(join(near, growing(near[-1], side, GROWTH * near[1])), level)
    y = halved(growing(0.0, side, near[1]), level)
    mesh = meshed([block(x, y, lambda x, y: (x, y))], [], lambda p: p[0])

    def stress(x):
        return half_plane(x[0], x[1], a, 2 * load / (np.pi * a))

    tractions = [
        (facets_on(mesh, lambda p: p[0] > side - 1e-9, lambda p: p[1]), lambda x: np.array(stress(x))[[0, 2]]),
        (facets_on(mesh, lambda p: p[1] > side - 1e-9, lambda p: p[0]), lambda x: np.array(stress(x))[[2, 1]]),
    ]
    return above_plane(scene, mesh, lambda x: x[0] ** 2 / (2 * scene["radius"]), tractions, lambda p: p[1] < 1e-9)


def cylinder(scene, level):
    """The lower quarter of a cylinder on a rigid plane, uniform load on its horizontal cut."""
    a, _, load = hertz(scene)
    radius = scene["radius"]
    near = np.arcsin(np.linspace(0.0, scene["stretch"] * a, round(HERTZ * scene["stretch"]) + 1) / radius)
    lower = join(near, growing(near[-1], np.pi / 4, GROWTH * (near[-1] - near[-2])))
    angles = halved(join(lower, np.linspace(np.pi / 4, np.pi / 2, 5)), level)
    mesh = meshed(disc((0.0, radius), radius, angles, a / HERTZ, level), [((0.0, radius), radius)], lambda p: p[0])
    cut = facets_on(mesh, lambda p: p[1] > radius - 1e-9, lambda p: p[0])
    pushed = [(cut, lambda x: np.stack([0 * x[0], 0 * x[0] - load / (2 * radius)]))]
    on_arc = lambda p: np.abs(np.hypot(p[0], p[1] - radius) - radius) < 1e-9 * radius  # noqa: E731
    return above_plane(scene, mesh, lambda x: radius - np.sqrt(radius**2 - x[0] ** 2), pushed, on_arc)


def hertz(scene):
    """Half-width [mm], E* [MPa] and load [N/mm] of a Hertz scene."""
    a, modulus = scene["a_over_r"] * scene["radius"], scene["young"] / (1 - scene["poisson"] ** 2)
    return a, modulus, np.pi * a**2 * modulus / (4 * scene["radius"])


def half_plane(x, y, a, p0):
    """(sigma_x, sigma_y, tau_xy) below Hertz's pressure on y = 0, body in y > 0 (Johnson 1985, eq. 4.49)."""
    inner = a**2 - x**2 + y**2
    root = np.sqrt(inner**2 + 4 * x**2 * y**2)
    m, n = np.sqrt(0.5 * (root + inner)), np.sign(x) * np.sqrt(np.maximum(0.5 * (root - inner), 0.0))
    q = (y**2 + n**2) / (m**2 + n**2)
    return -p0 / a * (m * (1 + q) - 2 * y), -p0 / a * m * (1 - q), -p0 / a * n * (m**2 - y**2) / (m**2 + n**2)


def above_plane(scene, mesh, gap, tractions, surface):
    """One body above a rigid profile, symmetric about x = 0, held up by contact alone."""
    a, modulus, _ = hertz(scene)
    candidates = facets_on(mesh, surface, lambda p: p[0], scene["stretch"] * a)
    return Model(
        [mesh], [(scene["young"], scene["poisson"], "strain")], [candidates], lambda x: x[0],
        lambda x: np.stack([0 * x[0], 0 * x[0] - 1]), gap, modulus, a, a, 1.0, True,
        [(0, 0, lambda x: x[0] < 1e-9)], tractions=tractions,
    )
