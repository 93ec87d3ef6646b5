"""Measures of a pressure profile: the functionals of model.md section 7."""

import numpy as np


def half_width(points, pressure):
    """2 sqrt(sum A p s^2 / sum A p) [mm, or rad on an arc], exact for a semi-ellipse."""
    force = points.weight * pressure
    return 2.0 * np.sqrt((force * points.position**2).sum() / force.sum())


def peak(points, pressure, width):
    """Peak pressure [MPa] by least squares on the edge means, weighted with the edges' areas.

    Value at 0 of c0 + c1 s^2 on the edges with s < width/4, at least three; where that rises and the
    largest mean lies beyond width/4 (an eye in bending), the top of the parabola on the five edges around it.
    Means of s and s^2 go with means of p, so that a parabola is reproduced exactly.
    """
    mean = edge_means(points, pressure)
    first, second = edge_means(points, points.position), edge_means(points, points.position**2)
    weight = np.bincount(points.edge, points.weight)
    near = first < 0.25 * width
    near[:3] = True
    value, rise = fit(mean[near], weight[near], second[near])
    highest = int(np.argmax(mean))
    if rise <= 0.0 or first[highest] <= 0.25 * width:
        return value
    five = slice(max(highest - 2, 0), highest + 3)
    value, slope, bend = fit(mean[five], weight[five], first[five], second[five])
    return value - slope**2 / (4.0 * bend) if bend < 0.0 else mean[highest]


def fit(values, weight, *columns):
    """Least-squares coefficients of 1 and the columns, weighted."""
    root = np.sqrt(weight)
    basis = np.column_stack([np.ones_like(values), *columns])
    return np.linalg.lstsq(root[:, None] * basis, root * values, rcond=None)[0]


def resultant(points, pressure):
    """2 sum A p cos [N]: the component along the load line, of both halves."""
    return 2.0 * (points.weight * pressure * points.share).sum()


def edge_means(points, values):
    """A-weighted mean of each candidate edge, without the mode alternating on edges that no node feels."""
    return np.bincount(points.edge, points.weight * values) / np.bincount(points.edge, points.weight)


def profile(points, pressure, stations, per_length):
    """Mean pressures [MPa] over stretches of equal length, whose middles are the stations; `per_length` is dA/ds.

    From the force between 0 and s, linear within each edge: a mean feels the square-root end of a contact as force,
    where a value would feel how far it lies from the next node.
    """
    area = np.bincount(points.edge, points.weight)
    force = np.bincount(points.edge, points.weight * pressure)
    covered, carried = (np.concatenate([[0.0], np.cumsum(part)]) for part in (area, force))
    half = 0.5 * (stations[1] - stations[0])
    upper, lower = (np.interp((stations + side) * per_length, covered, carried) for side in (half, -half))
    return (upper - lower) / (2.0 * half * per_length)
