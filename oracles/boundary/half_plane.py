"""Contact of a rigid parabola with the elastic half-plane by a boundary method: no elements, no mesh of the body.

Surface displacement under a pressure p(t): u(x) = -2/(pi E*) int p(t) ln|x - t| dt + const (Flamant; Johnson 1985, section 2.8).
Pressures are linear between equally spaced nodes; the pressure that presses the gap to a constant on an active set and carries the
load is found by a linear system, the set by dropping nodes that pull. Nothing of Hertz's answer enters. Units mm, N, MPa.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np

NODES = 100  # on one side of the middle, on the coarsest level
STEPS = 60


def solve(scene, level, _method):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and unknowns of a scene on the nodes of a level."""
    if scene["case"] != "truncated-hertz":
        raise ValueError(f"case {scene['case']!r}: use truncated-hertz")
    radius, modulus = scene["radius"], scene["young"] / (1 - scene["poisson"] ** 2)
    half_width = scene["a_over_r"] * radius
    load = np.pi * half_width**2 * modulus / (4 * radius)
    count = NODES * 2**level
    x = np.linspace(0.0, scene["stretch"] * half_width, count + 1)
    pressure = pressed(influence(x, modulus), x**2 / (2 * radius), hats(x), load)
    if pressure[-1] > 0.0:
        raise RuntimeError("the contact reaches its last node; lengthen the stretch")
    return measures(x, pressure, np.asarray(scene["stations"]))


def influence(x, modulus):
    """Displacement at the nodes by unit pressures, linear about each node and its mirror image."""
    step = x[1] - x[0]

    def triangle(distance):
        """Integral of ln|s - t| times the hat function of unit height about t = 0, in units of the step."""
        s = distance / step
        second = sum(weight * power_log(s + shift) for shift, weight in ((-1, 1.0), (0, -2.0), (1, 1.0)))
        return step * (second + np.log(step))

    apart, mirrored = x[:, None] - x[None, :], x[:, None] + x[None, :]
    both = triangle(apart) + np.where(x[None, :] > 0, triangle(mirrored), 0.0)
    return -2 / (np.pi * modulus) * both


def power_log(s):
    """Second antiderivative of ln|s|: s^2/2 ln|s| - 3 s^2/4."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(s == 0.0, 0.0, s**2 / 2 * np.log(np.abs(s)) - 3 * s**2 / 4)


def hats(x):
    """Integrals of the hat functions over both sides."""
    step = x[1] - x[0]
    return np.where(x > 0, 2 * step, step)


def pressed(influence, gap, weights, load):
    """Pressures of an active set that none pulls in and none penetrates beyond."""
    active = np.ones(len(gap), bool)
    for _ in range(STEPS):
        on = np.flatnonzero(active)
        matrix = np.zeros((len(on) + 1, len(on) + 1))
        matrix[:-1, :-1], matrix[:-1, -1], matrix[-1, :-1] = influence[np.ix_(on, on)], -1.0, weights[on]
        answer = np.linalg.solve(matrix, np.append(-gap[on], load))
        pressure = np.zeros(len(gap))
        pressure[on] = answer[:-1]
        opening = influence @ pressure + gap - answer[-1]
        new = np.where(active, pressure > 0.0, opening < 0.0)
        if (new == active).all():
            return pressure
        active = new
    raise RuntimeError(f"the active set still changes after {STEPS} iterations")


def measures(x, pressure, stations):
    """The quantities that are asked for; integrals of the piecewise linear pressure are exact."""
    step = x[1] - x[0]
    a, b, p, q = x[:-1], x[1:], pressure[:-1], pressure[1:]
    force = step * (p + q) / 2
    moment = step * (p * (3 * a**2 + 2 * a * b + b**2) + q * (a**2 + 2 * a * b + 3 * b**2)) / 12
    half_width = 2 * np.sqrt(moment.sum() / force.sum())
    width = stations[1] - stations[0]
    fine = stations[:, None] + width * (np.arange(400) - 199.5) / 400
    return {
        "half_width": float(half_width),
        "peak": float(pressure.max()),
        "resultant": float(2 * force.sum()),
        "pressure": np.interp(fine, x, pressure).mean(axis=1),
        "dofs": int(len(x)),
    }
