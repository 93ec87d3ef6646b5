"""Contact with the elastic half-space in three dimensions by a boundary method: tamaas, pressures on square pixels, Fourier transforms.

Nothing of revolution enters but the profile, a paraboloid or a cone on a grid in x and y; the influence is Boussinesq's over pixels without
periodic images, and the pressure is found by conjugate gradients (Polonsky and Keer 1999). Units mm, N, MPa.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/revolution/freeze.py, which imports this module")

import numpy as np
import tamaas
from scipy.ndimage import map_coordinates

PIXELS = 64  # on a side of the square, coarsest level
TOLERANCE = 1e-10  # of conjugate gradients, which stagnate below 1e-12 on fine grids
NODES = 48  # angles that a pressure round the axis is averaged over


def version():
    """Of tamaas."""
    return tamaas.__version__


def solve(scene, level, _method="boundary"):
    """Contact radius, peak, resultant, mean pressures round scene["stations"], approach and pixels of a scene on the grid of a level."""
    modulus = scene["young"] / (1 - scene["poisson"] ** 2)
    a = scene["a_over_r"] * scene["radius"]
    if scene["case"] == "truncated-sphere":
        load, profile = 4 * modulus * a**3 / (3 * scene["radius"]), lambda r: r**2 / (2 * scene["radius"])
    elif scene["case"] == "cone":
        load, profile = np.pi / 2 * modulus * scene["slope"] * a**2, lambda r: scene["slope"] * r
    else:
        raise ValueError(f"case {scene['case']!r}: use one of truncated-sphere, cone")
    count, side = PIXELS * 2**level, 2 * scene["stretch"] * a
    step = side / count
    along = step * (np.arange(count) - 0.5 * (count - 1))
    r = np.hypot(*np.meshgrid(along, along))
    pressure, displacement = pressed(profile(r), side, modulus, load)
    if pressure[[0, -1]].max() > 0 or pressure[:, [0, -1]].max() > 0:
        raise RuntimeError("the contact reaches the edge of the grid; lengthen the stretch")
    touching = pressure > 0
    approach = (displacement + profile(r))[touching].mean()
    return {**measures(r, pressure, step, np.asarray(scene["stations"])), "approach": float(approach), "dofs": int(count**2)}


def pressed(gap, side, modulus, load):
    """Pressures and displacements of the pixels."""
    tamaas.initialize(1)
    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [side, side], list(gap.shape))
    model.E, model.nu = modulus, 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "alone")
    solver = tamaas.PolonskyKeerRey(model, -gap, TOLERANCE)
    solver.setIntegralOperator("alone")
    left = solver.solve(load / side**2)
    if not left <= TOLERANCE:
        raise RuntimeError(f"conjugate gradients end with an error of {left:.1e}")
    pressure = np.array(model.traction).reshape(gap.shape)
    model.operators["alone"](model.traction, model.displacement)
    return pressure, np.array(model.displacement).reshape(gap.shape)


def measures(r, pressure, step, stations):
    """The quantities that are asked for; the contact radius by second moment, a^2 = 5/2 of the mean of r^2 below Hertz's pressure.

    The peak is the value at 0 of the even sextic in r nearest to the pixels on the inner half: it means nothing below a cone.
    """
    radius = np.sqrt(2.5 * (pressure * (r**2 + step**2 / 6)).sum() / pressure.sum())
    inner = r < 0.5 * radius
    terms = np.array([(r[inner] / radius) ** k for k in (0, 2, 4, 6)]).T
    peak = np.linalg.lstsq(terms, pressure[inner], rcond=None)[0][0]
    # Means round rings, linear between the pixels.
    width, turn = stations[1] - stations[0], np.pi / 4 * (np.arange(NODES) + 0.5) / NODES
    fine = (stations[:, None] + width * (np.arange(40) - 19.5) / 40)[:, :, None]
    places = [fine * f(turn) / step + 0.5 * (len(r) - 1) for f in (np.cos, np.sin)]
    rings = map_coordinates(pressure, np.array(places), order=1).mean(axis=(1, 2))
    return {"half_width": float(radius), "peak": float(peak), "resultant": float(pressure.sum() * step**2), "pressure": rings}
