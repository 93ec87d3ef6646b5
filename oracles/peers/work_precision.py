"""Work and precision of scikit-fem and dolfinx on truncated Hertz: work_precision.py CODE < request; JSON lines.

CODE is scikit-fem or dolfinx. Request, one JSON object:
    scene        numbers of a truncated-hertz scene as in block.py; its a_over_r is nominal: it grades the mesh,
                 places the candidates (stretch) and starts the iteration
    half_widths  a_k [mm], below the last candidate: load P_k = pi a_k^2 E*/4R, as Hertz's tractions on the far sides
    meshes       sizes n, [n, level] or [n, level, steep]: cells are at most stretch/n long at the candidates, within 5 %,
                 and grow away with steep/2 times the distance; `level` cuts every triangle into four. Triangles are bisected, so that the
                 candidates have 2^m >= n edges, and the sizes in between differ in how soon the cells grow
    repeats      solutions a load (3)
    methods      of "active-set" and "penalty" those that are asked, one after the other (both)
Answer, a line a mesh as soon as done: code, version, method, mesh (as asked), freedoms, contact_edges, and over loads:
    seconds           median over the repeats, from meshes to pressures: assembly, contact points, factorisations, all
                      steps, coarser meshes included; not imports, compiled forms, mesh generation
    stiffness, linear medians of what of these went into the code's stiffness and into its linear solutions
    steps             iterations, each mesh of the chain apart
    peak_error        |peak/p0 - 1|, p0 = E* a_k/2R, peak by measures.peak
    half_width_error  |a/a_k - 1|, a = 2 sqrt(int p x^2 / int p)
    l2_error          |p - p_H|/|p_H| in L2, p_H = p0 sqrt(1 - x^2/a_k^2): p linear on each edge through its two
                      points, not cut at zero; 12 Gauss points an edge; |p_H|^2 = 2 a_k p0^2/3

Exact active sets take one factorisation in all, the penalty one a step. Both start from the nominal contact: active sets on
the mesh itself, the penalty, unless that is SMALL, on one with a quarter of the contact edges; on a fine mesh it would take 38
steps. Which is the faster one to an error is for whoever asks to see.
"""

import importlib
import json
import os
import statistics
import sys
import time
from dataclasses import replace

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, os.pardir, "python"))
sys.dont_write_bytecode = True  # nothing is written beside the oracles

import environment  # noqa: E402, a file of the oracles

CODES = ["scikit-fem", "dolfinx"]
METHODS = ["active-set", "penalty"]
COARSEST = 8  # contact edges of the coarsest mesh of a chain
SMALL = 1200  # nodes up to which a coarser mesh costs as much as the steps it saves
MISSING = 3  # exit code


def main(name):
    """Answers the request on stdin."""
    if name not in CODES:
        sys.exit(f"usage: work_precision.py CODE < request.json, CODE one of {', '.join(CODES)}")
    try:
        environment.prepare(os.path.join(HERE, os.pardir, ".python"))
    except ModuleNotFoundError as lacking:
        print(f"{name}: module {lacking.name} is missing: bash oracles/setup.sh", file=sys.stderr)
        sys.exit(MISSING)
    request = asked(METHODS)
    scene = request["scene"]
    code = Timed(importlib.import_module("assembled_" + name.replace("-", "_")))
    for method in request["methods"]:
        solved([model(scene, COARSEST, 0)], method, code)  # warm-up
        for mesh in request["meshes"]:
            chain, edges = models(scene, *(mesh if isinstance(mesh, list) else [mesh, 0]), method=method)
            rows = [row(scene, half_width, chain, method, code, request) for half_width in request["half_widths"]]
            tell(name, environment.versions()[name], method, mesh, edges, rows)


def asked(methods):
    """The request on stdin, its methods and repeats filled in."""
    try:
        request = {"methods": methods, "repeats": 3} | json.load(sys.stdin)
        scene, half_widths = request["scene"], request["half_widths"]
        last = scene["stretch"] * scene["a_over_r"] * scene["radius"]
    except (KeyError, TypeError, ValueError) as error:
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} … < request.json, of which work_precision.py tells: {error!r}")
    if not set(request["methods"]) <= set(methods):
        sys.exit(f"methods are {', '.join(methods)}")
    if not all(0.0 < half_width < last for half_width in half_widths):
        sys.exit(f"half-widths must lie between 0 and the last candidate, {last} mm")
    return request


def tell(name, version, method, mesh, edges, rows):
    """Prints the line of a mesh, of a row for each half-width."""
    answer = {"code": name, "version": version, "method": method, "mesh": mesh}
    answer |= {"freedoms": rows[0]["freedoms"], "contact_edges": edges}
    answer |= {key: [found[key] for found in rows] for key in rows[0] if key != "freedoms"}
    print(json.dumps(answer), flush=True)


class Clock:
    """Adds up the seconds of stages."""

    def __init__(self):
        self.seconds = {}

    def timed(self, stage, function, *arguments):
        """Value of a function, its seconds counted."""
        begin = time.perf_counter()
        value = function(*arguments)
        self.seconds[stage] = self.seconds.get(stage, 0.0) + time.perf_counter() - begin
        return value

    def laps(self, repeats, solve):
        """What a solve found last, and the medians of its seconds, of those for the stiffness and for linear solutions."""
        laps = []
        for _ in range(repeats):
            self.seconds = {}
            found = self.timed("seconds", solve)
            laps.append(self.seconds)
        stages = "seconds", "stiffness", "linear"
        return found, {stage: statistics.median(lap[stage] for lap in laps) for stage in stages}


class Timed(Clock):
    """A code whose stages are timed."""

    def __init__(self, code):
        super().__init__()
        self.code, self.edge_functions = code, code.edge_functions

    def stiffness(self, *arguments):
        """Stiffness of a mesh."""
        return self.timed("stiffness", self.code.stiffness, *arguments)

    def linear_solution(self, *arguments):
        """Solution of a linear system."""
        return self.timed("linear", self.code.linear_solution, *arguments)


def model(scene, size, level, steep=1):
    """Truncated Hertz with a number of edges on the candidates at level 0."""
    import block

    return block.truncated_hertz(scene, size, level, steep)


def models(scene, size, level, steep=1, *, method):
    """The chain of models, coarsest first, and the contact edges of the last; active sets need no other."""
    import contact

    chain = [model(scene, size, level, steep)]
    edges = len(contact.contact_edges(chain[0].mesh, chain[0].stretch))
    coarser = edges // 4
    while method == "penalty" and coarser >= COARSEST and len(chain[0].mesh.points) > SMALL:
        chain.insert(0, model(scene, coarser, 0, steep))
        coarser //= 4
    return chain, edges


def solved(chain, method, code):
    """Contact points, pressures and freedoms of the last model, steps of all."""
    import problem

    start, steps = chain[0].start, []
    for each in chain:
        points, pressure, freedoms, taken = problem.closed(each, method, start, code)
        start = problem.contact_edge(points, pressure)
        steps.append(taken)
    return points, pressure, freedoms, steps


def row(scene, half_width, chain, method, code, request):
    """Times and errors under the load of one half-width, on meshes that do not know it."""
    import block
    import measures

    ratio = half_width / block.hertz(scene)["half_width"]
    # the same block in millimetres: only its tractions are used
    loaded = {"a_over_r": scene["a_over_r"] * ratio} | {key: scene[key] / ratio for key in ("stretch", "size")}
    tractions = model(scene | loaded, COARSEST, 0).tractions
    chain = [replace(each, tractions=tractions) for each in chain]
    (points, pressure, freedoms, steps), seconds = code.laps(request["repeats"], lambda: solved(chain, method, code))
    peak = block.hertz(scene)["modulus"] * half_width / (2.0 * scene["radius"])
    width = measures.half_width(points, pressure)
    return {
        "freedoms": int(freedoms),
        **seconds,
        "steps": [int(taken) for taken in steps],
        "peak_error": float(abs(measures.peak(points, pressure, width) / peak - 1.0)),
        "half_width_error": float(abs(width / half_width - 1.0)),
        "l2_error": float(l2_error(points, pressure, half_width, peak)),
    }


def l2_error(points, pressure, half_width, peak):
    """Relative L2 distance from Hertz's pressure; the contact is straight, so x is linear on each edge."""
    import numpy as np

    xi, weight = np.polynomial.legendre.leggauss(12)
    place, x, p = (values.reshape(-1, 2) for values in (points.local, points.position, pressure))
    share = (xi - place[:, :1]) / (place[:, 1:] - place[:, :1])
    position, found = (value[:, :1] + share * (value[:, 1:] - value[:, :1]) for value in (x, p))
    exact = peak * np.sqrt(np.maximum(1.0 - (position / half_width) ** 2, 0.0))
    rate = (x[:, 1:] - x[:, :1]) / (place[:, 1:] - place[:, :1])
    squared = ((found - exact) ** 2 * rate * weight).sum()
    return np.sqrt(squared / (2.0 / 3.0 * half_width * peak**2))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) == 2 else "")
