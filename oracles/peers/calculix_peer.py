"""The scene `cylinder` in CalculiX, timed: calculix_peer.py PROBLEM.json [REPEATS]; prints one JSON object.

What a user of ccx would set up, on the given mesh:
- CPE8: 8-node plane strain elements. ccx has no plane elements inside: it expands each to one 20-node brick (C3D20)
  across the thickness and ties the faces, so it assembles in 3D and solves with the freedoms it reports here;
- contact: face-to-face penalty, pressure = K overlap, K = 50 E per mm (CalculiX's own Hertz example has 1e7 MPa/mm),
  slave the candidate edges, master the top of one fully held CPE8 element, the rigid plane;
- linear kinematics (no NLGEOM), one increment, SPOOLES, stops at ccx's own tolerances.

The plane is held a tenth of the candidates' largest clearance above y = 0: at mere touching ccx finds no contact and
diverges; the body, free to rise, takes this as a rigid displacement.

peak: largest nodal CPRESS [MPa], which ccx extrapolates from the integration points; half_width:
2 sqrt(int p x^2 / int p) [mm], p quadratic between the nodal values; resultant: 2 x the reaction of the plane, both
halves [N/mm for thickness 1], positive in compression. steps: iterations, each one factorisation, those of
unfinished attempts included.
"""

import os
import re
import shutil
import subprocess
import tempfile
import time

import common  # first: one thread

import numpy as np

STIFFNESS = 50.0  # K/E [1/mm]
RAISED = 0.1  # height of the plane over the largest clearance of the candidates
JOB = "cylinder"


def deck(problem):
    """The input deck; node and element numbers are the given ones plus 1, the plane's come last."""
    points, cells = problem["points"], problem["cells"] + 1
    (across, pressed), edges = -problem["traction"], problem["contact_first"]
    if across or np.ptp(points[problem["load_edges"].ravel(), 1]) > 1e-9:
        raise ValueError("only a pressure on a horizontal edge is served")
    top, wide = RAISED * common.facing(problem)[1], 1.25 * points[edges, 0].max()
    square = np.array([[0, -1], [1, -1], [1, 0], [0, 0], [0.5, -1], [1, -0.5], [0.5, 0], [0, -0.5]])
    nodes = np.vstack([points, wide * square + [0.0, top]])
    plane = np.arange(len(points) + 1, len(nodes) + 1)
    side = {frozenset((c[s], c[(s + 1) % 4])): (e, s + 1) for e, c in enumerate(cells, 1) for s in range(4)}

    def faces(of):
        return [side[frozenset(edge)] for edge in (of[:, :2] + 1).tolist()]

    return "\n".join([
        # ccx reads twenty characters a number
        "*NODE", *(f"{n},{x:.12e},{y:.12e},0." for n, (x, y) in enumerate(nodes, 1)),
        "*ELEMENT,TYPE=CPE8,ELSET=ALL", *(numbers(e, *cell) for e, cell in enumerate([*cells, plane], 1)),
        "*SURFACE,NAME=BODY,TYPE=ELEMENT", *(f"{e},S{s}" for e, s in faces(edges)),
        "*SURFACE,NAME=TOP,TYPE=ELEMENT", f"{len(cells) + 1},S3",
        "*NSET,NSET=AXIS", *map(str, problem["held"][:, 0] + 1),
        "*NSET,NSET=PLANE", *map(str, plane),
        "*BOUNDARY", "AXIS,1,1", "PLANE,1,2",
        "*MATERIAL,NAME=ELASTIC", "*ELASTIC", numbers(problem["young"][0], problem["poisson"][0]),
        "*SOLID SECTION,ELSET=ALL,MATERIAL=ELASTIC", numbers(problem["thickness"]),
        "*SURFACE INTERACTION,NAME=NORMAL", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR",
        numbers(STIFFNESS * problem["young"][0]),
        "*CONTACT PAIR,INTERACTION=NORMAL,TYPE=SURFACE TO SURFACE", "BODY,TOP",
        "*STEP", "*STATIC", "1.,1.",
        "*DLOAD", *(f"{e},P{s},{pressed:.12e}" for e, s in faces(problem["load_edges"])),
        "*NODE PRINT,NSET=PLANE,TOTALS=ONLY", "RF", "*CONTACT FILE,OUTPUT=2D", "CSTR", "*END STEP", "",
    ])  # fmt: skip


def numbers(*values):
    """A line of numbers."""
    return ",".join(map(str, values))


def run(text):
    """Wall time of ccx on a deck [s], and what it wrote, by the ending of the file's name."""
    with tempfile.TemporaryDirectory(prefix="calculix-peer-") as folder:
        path = os.path.join(folder, JOB)
        with open(path + ".inp", "w", encoding="ascii") as file:
            file.write(text)
        begin = time.perf_counter()
        done = subprocess.run(["ccx", JOB], cwd=folder, capture_output=True, text=True, check=False)
        seconds = time.perf_counter() - begin
        written = {"log": done.stdout}
        for ending in ("sta", "dat", "frd"):
            if os.path.exists(f"{path}.{ending}"):
                with open(f"{path}.{ending}", encoding="ascii") as file:
                    written[ending] = file.read()
    if done.returncode or "*ERROR" in done.stdout or "total force" not in written.get("dat", ""):
        raise RuntimeError("ccx did not solve the problem:\n" + done.stdout[-1500:])
    return seconds, written


def nodal_pressures(frd, count):
    """CPRESS [MPa] of every node, 0 where ccx names none: columns of twelve after a number of ten."""
    pressure = np.zeros(count)
    for line in frd.split(" -4  CONTACT")[-1].splitlines():
        if line.startswith(" -3"):
            break
        if line.startswith(" -1") and int(line[3:13]) <= count:
            pressure[int(line[3:13]) - 1] = float(line[49:61])
    return pressure


def half_width(x, pressure):
    """2 sqrt(int p x^2 / int p) over edges (first, last, middle), both quadratic on them, 5 Gauss points each."""
    xi, weight = np.polynomial.legendre.leggauss(5)
    shape = np.array([xi * (xi - 1) / 2, xi * (xi + 1) / 2, 1 - xi**2])
    slope = np.array([xi - 0.5, xi + 0.5, -2 * xi])
    force = (pressure @ shape) * (x @ slope) * weight
    return 2.0 * np.sqrt((force * (x @ shape) ** 2).sum() / force.sum())


def main():
    """Runs ccx as often as asked."""
    if not shutil.which("ccx"):
        common.missing("CalculiX (package calculix-ccx)")
    problem, repeats = common.arguments("calculix_peer.py")
    text, edges = deck(problem), problem["contact_first"]
    seconds, written = zip(*(run(text) for _ in range(repeats)))
    found = written[-1]
    pressure = nodal_pressures(found["frd"], len(problem["points"]))
    reaction = float(re.search(r"total force.*\n\s*\n\s*\S+\s+(\S+)", found["dat"])[1])
    attempts = [line.split() for line in found["sta"].splitlines()[2:] if line.strip()]
    version = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout
    common.report(
        code="calculix",
        version=re.search(r"Version (\S+)", version)[1],
        freedoms=int(re.search(r"number of equations\s+(\d+)", found["log"])[1]),
        steps=sum(int(line[3]) for line in attempts),
        seconds=list(seconds),
        counted="the whole process ccx: reading the deck, expansion to 3D, contact search, assembly and factorisation "
        "by SPOOLES in each iteration, stresses, writing the results; not counted: writing the deck, reading results",
        peak=float(pressure[edges].max()),
        half_width=float(half_width(problem["points"][edges, 0], pressure[edges])),
        resultant=2.0 * reaction,
    )


if __name__ == "__main__":
    main()
