"""An exported case by CalculiX: run_calculix.py FOLDER pair|gaps [--times N]; writes calculix-METHOD.frd or .dat there.

pair: contact as its manual describes it: surface to surface, pressure = K overlap, K = N 50 E per mm, the most that it recommends, linear
kinematics, one increment. A rigid body is a row of fully held cells along it. The other side of a body that contact alone holds is moved
towards it: at mere touching ccx diverges.
gaps: the exported deck, with gap elements on the undeformed surface.
"""

import pathlib
import re
import shutil
import subprocess
import tempfile
import time

import exported  # first: one thread

import numpy as np

STIFFNESS = 50.0  # K/E [1/mm]
MOVED = 0.1  # part of the widest gap


def rigid(contact, points, first_node, first_cell, kind):
    """Nodes and cells of a rigid body along the contact, and its surface."""
    if contact["arc"]:
        raise ValueError("the rigid body of an arc is not set up")
    normal, origin = np.array(contact["normal"]), np.array(contact["origin"])
    along = np.array([-normal[1], normal[0]])
    at = np.array([points[node["node"]] for node in contact["nodes"] if node["gap"] is not None])
    s = (at - origin) @ along
    above = np.array([node["gap"] for node in contact["nodes"] if node["gap"] is not None]) + (at - origin) @ normal
    order = np.argsort(s)
    s, above = s[order], above[order]
    depth, n, step = 2.0 * (s[-1] - s[0]), len(s), 2 if kind[3] == "8" else 1
    lines = [origin + s[:, None] * along + (above[:, None] + part * depth) * normal for part in (0.0, 0.5, 1.0)]
    number = first_node + np.arange(3 * n).reshape(3, n)
    cells = []
    for k in range(0, n - step, step):
        corners = [number[0, k], number[2, k], number[2, k + step], number[0, k + step]]
        middles = [number[1, k], number[2, k + 1], number[1, k + step], number[0, k + 1]]
        cells.append(corners + (middles if step == 2 else []))
    return np.vstack(lines), cells, [f"{first_cell + k},S4" for k in range(len(cells))]


def deck(problem, stiffness):
    """The deck with a contact pair."""
    data = problem.data
    if len(data["contacts"]) > 1:
        raise ValueError("scenes with one contact are served")
    contact, given = data["contacts"][0], np.array(data["cells"])
    if contact["second"] is not None:
        problem.drawn("run_calculix.py FOLDER gaps")
    points, count = problem.points[: given.max() + 1].copy(), len(given)
    kind = ("CPE" if data["plane"] == "strain" else "CPS") + str(given.shape[1])
    moved = np.zeros(2)
    if problem.hanging()[0] is not None:
        moved -= MOVED * max(node["gap"] for node in contact["nodes"] if node["gap"] is not None) * np.array(contact["normal"])
    if contact["second"] is not None:
        points[np.unique(given[problem.body == contact["second"]])] += moved
    face = {frozenset((cell[k], cell[(k + 1) % 4])): f"{number},S{k + 1}" for number, cell in enumerate(given.tolist(), 1) for k in range(4)}

    def surface(edges):
        return [face[frozenset(edge[:2])] for edge in edges]

    text = ["*NODE", *(f"{n},{x:.12e},{y:.12e},0." for n, (x, y) in enumerate(points, 1))]
    for body, (young, poisson) in enumerate(zip(data["young"], data["poisson"])):
        own = np.flatnonzero(problem.body == body)
        text += [f"*ELEMENT,TYPE={kind},ELSET=B{body}", *(",".join(map(str, [k + 1, *(given[k] + 1)])) for k in own),
                 f"*MATERIAL,NAME=B{body}", "*ELASTIC", f"{young},{poisson}", f"*SOLID SECTION,ELSET=B{body},MATERIAL=B{body}", str(data["thickness"])]
    text += ["*SURFACE,NAME=FIRST,TYPE=ELEMENT", *surface(contact["edges"])]
    if contact["second"] is None:
        more, cells, faces = rigid(contact, problem.points, len(points) + 1, count + 1, kind)
        text += ["*NODE,NSET=RIGID", *(f"{len(points) + 1 + n},{x:.12e},{y:.12e},0." for n, (x, y) in enumerate(more + moved)),
                 f"*ELEMENT,TYPE={kind},ELSET=RIGID", *(",".join(map(str, [count + 1 + k, *cell])) for k, cell in enumerate(cells)),
                 "*SOLID SECTION,ELSET=RIGID,MATERIAL=B0", str(data["thickness"]),
                 "*SURFACE,NAME=SECOND,TYPE=ELEMENT", *faces, "*BOUNDARY", "RIGID,1,2"]
    else:
        text += ["*SURFACE,NAME=SECOND,TYPE=ELEMENT", *surface(contact["opposite_edges"])]
    text += ["*BOUNDARY", *(f"{node + 1},{c + 1},{c + 1},{value}" for node, c, value in data["held"])]
    fixed = {(node, c) for node, c, _ in data["held"]}
    for side in data["tied"]:
        c, free = side["component"], [node for node in side["nodes"] if (node, side["component"]) not in fixed]
        for node in free[1:]:
            text += ["*EQUATION", "2", f"{node + 1},{c + 1},1.,{free[0] + 1},{c + 1},-1."]
    text += ["*SURFACE INTERACTION,NAME=NORMAL", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", str(stiffness * max(data["young"])),
             "*CONTACT PAIR,INTERACTION=NORMAL,TYPE=SURFACE TO SURFACE", "FIRST,SECOND", "*STEP", "*STATIC", "1.,1.", "*CLOAD",
             *(f"{node + 1},{c + 1},{value:.12e}" for node, c, value in data["forces"])]
    for side in data["tied"]:
        free = [node for node in side["nodes"] if (node, side["component"]) not in fixed]
        text.append(f"{free[0] + 1},{side['component'] + 1},{side['force']:.12e}")
    return "\n".join([*text, "*CONTACT FILE,OUTPUT=2D", "CDIS,CSTR", "*END STEP", ""])


def run(text, folder, name, ending):
    """Seconds and iterations of ccx on a deck; what it writes with an ending goes into the folder.

    Of the seconds those are taken off in which it reads the same deck without its step: it does not tell those of its solution.
    """
    with tempfile.TemporaryDirectory(prefix="calculix-") as place:
        path, seconds = pathlib.Path(place), 0.0
        for job, part, sign in ("read", text[: text.index("\n*STEP") + 1], -1.0), ("job", text, 1.0):
            (path / f"{job}.inp").write_text(part, encoding="ascii")
            begin = time.perf_counter()
            done = subprocess.run(["ccx", job], cwd=place, capture_output=True, text=True, check=False)
            seconds += sign * (time.perf_counter() - begin)
        if done.returncode or "*ERROR" in done.stdout or "Job finished" not in done.stdout:
            said = [line.strip() for line in done.stdout.splitlines() if "*ERROR" in line or "diverge" in line]
            raise RuntimeError("ccx: " + (said[0] if said else f"ended with {done.returncode}"))
        attempts = [line.split() for line in (path / "job.sta").read_text(encoding="ascii").splitlines()[2:] if line.strip()]
        shutil.copyfile(path / f"job.{ending}", folder / f"{name}.{ending}")
    return seconds, sum(int(line[3]) for line in attempts)


def main(folder, method, times):
    """Solves, and keeps what ccx writes."""
    if not shutil.which("ccx"):
        exported.missing("CalculiX", "apt install calculix-ccx")
    problem = exported.Problem(folder)
    if method == "pair":
        text, ending = deck(problem, times * STIFFNESS), "frd"
    else:
        own = [path for path in problem.folder.glob("*.inp") if not path.name.startswith("calculix-")]
        text, ending = own[0].read_text(encoding="ascii"), "dat"
        (problem.folder / "calculix-gaps.inp").write_text(text, encoding="ascii")
    seconds, steps = run(text, problem.folder, f"calculix-{method}", ending)
    version = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout
    exported.report(code="calculix", version=re.search(r"Version (\S+)", version)[1], file=f"calculix-{method}.{ending}",
                    iterations=steps, seconds=seconds)


if __name__ == "__main__":
    exported.run(main, __doc__, ["pair", "gaps"], "CalculiX 2.20", "K")
