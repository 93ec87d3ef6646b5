"""Two ways to close contact points: a penalty law by Newton, and exact conditions by active sets."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/work_precision.py CODE < request.json, which imports this module")

import numpy as np
from scipy.sparse import csr_matrix, diags

# Well placed starts take one to three steps, one off by a factor of two up to twenty.
STEPS = 60


def penalty(stiffness, load, points, spring, start, solve):
    """Pressures of p = k_n <w - g>+ by semismooth Newton from the points below `start`, and the steps taken.

    Started from u = 0 no point would be active, and the stiffness singular.
    """
    active = points.position < start
    for step in range(1, STEPS + 1):
        on = diags(spring * points.weight * active)
        u = solve(stiffness + points.rows.T @ on @ points.rows, load + points.rows.T @ (on @ points.gap))
        overlap = points.rows @ u - points.gap
        if ((overlap > 0.0) == active).all():
            return spring * np.maximum(overlap, 0.0), step
        active = still_closed(overlap > 0.0, step)
    raise RuntimeError(f"penalty: the active set still changes after {STEPS} Newton steps; lower kappa")


def multipliers(stiffness, load, points, start, solve):
    """Pressures without penalty by primal-dual active sets from the corners below `start`, and the steps.

    Pressure p = sum lambda_i H_i, H_i the hat functions on the corners of the candidate edges, lambda_i >= 0,
    integral of H_i (g - w) >= 0, product zero. Hats under quadratic displacements are a stable pair; a
    multiplier for each point would leave undetermined the mode alternating within edges that no node feels.
    """
    corner = np.column_stack([points.edge, points.edge + 1]).ravel()
    value = 0.5 * np.column_stack([1.0 - points.local, 1.0 + points.local]).ravel()
    hats = csr_matrix((value, (np.repeat(np.arange(len(points.edge)), 2), corner)))
    area = hats.T @ points.weight
    mean = diags(1.0 / area) @ hats.T @ diags(points.weight)
    rows, gap = mean @ points.rows, mean @ points.gap
    active = mean @ points.position < start

    # One factorisation: springs s on all rows hold the body, and forces q on the rows take them off again.
    # With S the flexibility of the rows, w = w_f + S q: closed rows have w = g, open ones no force, q = s w.
    spring = 1e-3 * stiffness.diagonal().mean()  # soft, or taking it off costs digits
    held = stiffness + spring * rows.T @ rows
    moved = rows @ solve(held, np.column_stack([load, rows.T.toarray()]))
    free, flexibility = moved[:, 0], moved[:, 1:]
    for step in range(1, STEPS + 1):
        matrix = np.where(active[:, None], flexibility, np.eye(len(gap)) - spring * flexibility)
        q = np.linalg.solve(matrix, np.where(active, gap - free, spring * free))
        force = np.where(active, spring * gap - q, 0.0)
        closed = np.where(active, force > 0.0, free + flexibility @ q > gap)
        if (closed == active).all():
            return hats @ (force / area), step
        active = still_closed(closed, step)
    raise RuntimeError(f"active sets: they still change after {STEPS} steps; start nearer to the contact")


def still_closed(closed, step):
    """The closed set, refused when empty: the stiffness would be singular."""
    if not closed.any():
        raise RuntimeError(f"contact was lost at step {step}: start nearer to the contact")
    return closed
