"""Measures of a pressure profile."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

import numpy as np


def half_width(points, pressure):
    """2 sqrt(sum A p s^2 / sum A p) [mm], exact for a semi-ellipse."""
    force = points.weight * pressure
    return 2.0 * np.sqrt((force * points.position**2).sum() / force.sum())


def peak(points, pressure, width):
    """Peak pressure [MPa] by least squares on the edge means, weighted with the edges' areas.

    Value at 0 of c0 + c1 s^2 + c2 s^4 on the edges with s < width/4, at least three. Means of s^2 and s^4 go with means
    of p, so that a quartic is reproduced exactly.
    """
    near = edge_means(points, points.position) < 0.25 * width
    near[:3] = True
    mean, second, fourth = (edge_means(points, of)[near] for of in (pressure, points.position**2, points.position**4))
    return fit(mean, np.bincount(points.edge, points.weight)[near], second, fourth)[0]


def fit(values, weights, *terms):
    """Coefficients c of c0 + c1 t1 + c2 t2 ... nearest to the values, by least squares with weights."""
    root = np.sqrt(weights)
    basis = np.column_stack([np.ones_like(values), *terms])
    return np.linalg.lstsq(root[:, None] * basis, root * values, rcond=None)[0]


def edge_means(points, values):
    """A-weighted mean of each candidate edge, without the mode alternating on edges that no node feels."""
    return np.bincount(points.edge, points.weight * values) / np.bincount(points.edge, points.weight)
