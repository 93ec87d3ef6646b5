"""What the peers share: one thread, the problem they read, the object they print. Units mm, N, MPa.

A problem is a JSON object: points, cells (8 nodes: corners counter-clockwise, then the middles of 01, 12, 23, 30),
young, poisson (lists, one body), plane "strain", thickness, held (node, component at rest), load_edges and
contact_first (first, last, middle; the latter in order of x), traction [MPa]; the rigid plane is y = 0, below the body.

Importing this first makes every library loaded later, and every process started, keep to one thread.
"""

import json
import os
import sys

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

MISSING = 3  # exit code


def missing(what):
    """Ends the process: the code is not installed."""
    print(f"{what} is missing: bash oracles/peers/setup.sh", file=sys.stderr)
    sys.exit(MISSING)


try:
    import numpy as np  # reads the number of threads when loaded
except ModuleNotFoundError:
    missing("numpy (package python3-numpy)")


def arguments(usage):
    """The problem named on the command line, numbers as arrays, and how often it is to be solved."""
    if len(sys.argv) not in (2, 3):
        sys.exit(f"usage: {usage} PROBLEM.json [REPEATS]")
    with open(sys.argv[1], encoding="utf-8") as file:
        problem = json.load(file)
    if len(problem["young"]) != 1 or problem["plane"] != "strain" or len(problem["cells"][0]) != 8:
        sys.exit(f"{sys.argv[1]}: one body of 8-node cells in plane strain is served")
    if any(component for _, component in problem["held"]):
        sys.exit(f"{sys.argv[1]}: only component 0 may be held")
    for name in ("points", "cells", "held", "load_edges", "contact_first", "traction"):
        problem[name] = np.array(problem[name])
    return problem, int(sys.argv[2]) if len(sys.argv) == 3 else 1


def facing(problem):
    """Clearance [mm] between the undeformed candidate edges and the plane y = 0: smallest, largest."""
    height = problem["points"][problem["contact_first"].ravel(), 1]
    return height.min(), height.max()


def report(**result):
    """Prints the one object."""
    print(json.dumps(result))
