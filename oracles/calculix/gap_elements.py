"""Pins in holes in CalculiX: plane stress elements, and a gap element between each two nodes that face one another.

ccx has contact pairs, but they follow the deformed surfaces, which is another model. Here the approach w = (u - v).n of facing nodes along
the pin's normal n is the freedom of a node of its own, by an *EQUATION, and a GAPUNI of clearance g, the gap along n, lies between that
node and a fixed one, whose reaction is the contact force. Units mm, N, MPa, rad.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import os
import re
import subprocess
import tempfile

import numpy as np

import rings

COUNT = 16  # elements of level 0 on 90 degrees
STIFFNESS, TAIL = 1e4, 1e-7  # of a gap element: closed, over E t [N/mm]; pull of an open one, over the force
# ccx makes bricks of plane elements, which shear as the thickness changes from place to place: thin ones do so less. Forces go with it.
THIN = 0.01  # over the thickness
FITTED = 0.2  # stretch on either side of the largest pressure that its peak is read from [rad]
JOB = "pins"


def solve(scene, level, _method):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and dofs of a scene on the meshes of a level."""
    if scene["case"] not in ("pin-rod", "pin-plate"):
        raise ValueError(f"case {scene['case']!r}: use one of pin-rod, pin-plate")
    whole, scene = scene, {**scene, "thickness": THIN * scene["thickness"], "force": THIN * scene["force"]}
    count, in_rod = COUNT * 2**level, scene["case"] == "pin-rod"
    bodies = [rings.pin(scene, count, 1 if in_rod else 2), (rings.rod if in_rod else rings.plate)(scene, count)]
    # Corners and middles of whole elements within the stretch.
    step = np.pi / 4 / count
    angles = step * np.arange(2 * int(scene["stretch"] / (2 * step) + 1e-6) + 1)
    sizes = [len(body.nodes) for body in bodies]
    pairs = [
        (bodies[0].node(*rings.around(scene["pin_radius"], angle)), sizes[0] + bodies[1].node(*rings.around(rings.hole_at(scene, angle), angle)))
        for angle in angles
    ]
    if [len(body.nodes) for body in bodies] != sizes:
        raise RuntimeError("the nodes of pin and hole do not face one another")
    deck, fixed = written(scene, bodies, angles, pairs)
    printed, equations = run(deck)
    return {**measures(whole, angles, reactions(printed, fixed) / THIN), "dofs": equations}


def written(scene, bodies, angles, pairs):
    """The input deck, and the numbers of the fixed nodes behind the gap elements."""
    nodes, start = bodies[0].nodes + bodies[1].nodes, len(bodies[0].nodes)
    approach = len(nodes) + 1 + np.arange(len(pairs))
    fixed, end = approach + len(pairs), len(nodes) + 1 + 2 * len(pairs)
    lines = ["*NODE", *(f"{n},{x:.12e},{y:.12e}" for n, (x, y) in enumerate(nodes, 1)), *(f"{n},0.,0." for n in range(approach[0], end + 1))]
    element, stiffness = 0, 0.0
    for body, shift, name in zip(bodies, (0, start), ("pin", "rod")):
        for kind in ("CPS8", "CPS6"):
            lines += [f"*ELEMENT,TYPE={kind},ELSET={name}"] if any(of == kind for of, _ in body.elements) else []
            for numbers in (numbers for of, numbers in body.elements if of == kind):
                element += 1
                lines += [",".join(str(n) for n in [element, *(shift + number for number in numbers)])]
        young, poisson = (scene.get(f"{name}_{what}", scene.get(what)) for what in ("young", "poisson"))
        stiffness = max(stiffness, STIFFNESS * young * scene["thickness"])
        lines += [f"*MATERIAL,NAME={name}", "*ELASTIC", f"{young:.12e},{poisson:.12e}"]
        lines += [f"*SOLID SECTION,ELSET={name},MATERIAL={name}", f"{scene['thickness']}"]
    for (on_pin, on_hole), angle, moved, still in zip(pairs, angles, approach, fixed):
        element += 1
        clearance, n = rings.hole_at(scene, angle) - scene["pin_radius"], (np.sin(angle), -np.cos(angle))
        lines += [f"*ELEMENT,TYPE=GAPUNI,ELSET=GAP{moved}", f"{element},{moved},{still}"]
        lines += [f"*GAP,ELSET=GAP{moved}", f"{clearance:.12e},1.,0.,0.,,{stiffness:.6e},{TAIL * scene['force']:.6e}"]
        terms = [(moved, 1, -1.0)] + [(node, k + 1, sign * n[k]) for node, sign in ((on_pin, 1), (on_hole, -1)) for k in (0, 1)]
        lines += equation([term for term in terms if abs(term[2]) > 1e-12])
    lines += named("FIXED", fixed) + named("APPROACH", approach) + supports(scene, bodies, end)
    lines += ["*BOUNDARY", "FIXED,1,3", "APPROACH,2,3"]
    # Under contact by gap elements alone ccx takes a step for linear; a plastic material, though no element is of it, makes it iterate.
    lines += ["*MATERIAL,NAME=UNUSED", "*ELASTIC", "1.,0.", "*PLASTIC", "1e20,0.", "2e20,1."]
    half, up = 0.5 * scene["force"], scene["case"] == "pin-rod"
    load = f"{end},2,{half:.12e}" if up else f"{bodies[0].node(0.0, 0.0)},2,{-half:.12e}"
    lines += ["*STEP", "*STATIC,DIRECT", "1.,1.", "*CONTROLS,PARAMETERS=FIELD", "1e-7,1e-7,,,,,,", "*CLOAD", load, "*NODE PRINT,NSET=FIXED", "RF", "*END STEP", ""]
    return "\n".join(lines), fixed


def supports(scene, bodies, end):
    """Symmetry, what is held, and the end face that moves as the node `end`."""
    start, up = len(bodies[0].nodes), scene["clearance"]
    lines = named("AXIS", [shift + n for body, shift in zip(bodies, (0, start)) for n in body.where(lambda x, y: abs(x) < 1e-9)])
    if scene["case"] == "pin-rod":
        for n in bodies[1].where(lambda x, y: y > up + scene["shank_end"] - 1e-6):
            lines += equation([(start + n, 2, 1.0), (end, 2, -1.0)])
        lines += named("HELD", bodies[0].where(lambda x, y: abs(y) < 1e-9)) + ["*BOUNDARY", "HELD,2,2"]
    else:
        rim = bodies[1].where(lambda x, y: np.hypot(x, y - up) > scene["rim_radius"] * (1 - 1e-9))
        lines += named("HELD", [start + n for n in rim]) + ["*BOUNDARY", "HELD,1,2"]
    return lines + ["*BOUNDARY", "AXIS,1,1"]


def named(name, numbers):
    """A set of nodes."""
    return [f"*NSET,NSET={name}", *(str(n) for n in numbers)]


def equation(terms):
    """A linear equation of freedoms; ccx eliminates the first."""
    return ["*EQUATION", str(len(terms)), *(f"{node},{freedom},{factor:.12e}" for node, freedom, factor in terms)]


def run(deck):
    """What ccx prints of a deck, and its number of equations."""
    with tempfile.TemporaryDirectory(prefix="calculix-") as folder:
        path = os.path.join(folder, JOB)
        with open(path + ".inp", "w", encoding="ascii") as file:
            file.write(deck)
        alone = {**os.environ, "OMP_NUM_THREADS": "1"}
        done = subprocess.run(["ccx", JOB], cwd=folder, capture_output=True, text=True, check=False, env=alone)
        if done.returncode or "*ERROR" in done.stdout or "Job finished" not in done.stdout:
            raise RuntimeError("ccx did not solve the scene:\n" + done.stdout[-1500:])
        with open(path + ".dat", encoding="ascii") as file:
            return file.read(), int(re.search(r"number of equations\s+(\d+)", done.stdout)[1])


def version():
    """Of ccx."""
    told = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout
    return re.search(r"Version (\S+)", told)[1]


def reactions(printed, fixed):
    """Contact forces [N] of the pairs: reactions of the fixed nodes, against the approach."""
    force = {int(node): -float(along) for node, along in re.findall(r"^ +(\d+) +(\S+) +\S+ +\S+$", printed, re.MULTILINE)}
    return np.array([force[node] for node in fixed])


def measures(scene, angles, forces):
    """The quantities that are asked for: sums of the forces, and pressures that are forces over nodal areas."""
    if forces[-1] > 1e-4 * forces.max():
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    size = angles[2] - angles[0]
    share = np.where(np.arange(len(angles)) % 2, 4, 2)
    share[[0, -1]] = 1
    pressure = forces / (share / 6 * size * scene["thickness"] * scene["pin_radius"])
    width = scene["stations"][1] - scene["stations"][0]
    fine = scene["stations"][:, None] + width * (np.arange(400) - 199.5) / 400
    return {
        "half_width": float(2 * np.sqrt((forces * angles**2).sum() / forces.sum())),
        "peak": float(top(angles, pressure)),
        "resultant": float(2 * (forces * np.cos(angles)).sum()),
        "pressure": along(angles, pressure, fine).mean(axis=1),
    }


def top(angles, pressure):
    """Largest value of the polynomial of degree 4 nearest to the pressures round the largest; even about 0."""
    away = np.concatenate([-angles[:0:-1], angles]) - angles[pressure.argmax()]
    near = np.abs(away) < FITTED
    fit = np.polyfit(away[near], np.concatenate([pressure[:0:-1], pressure])[near], 4)
    return np.polyval(fit, np.linspace(-FITTED, FITTED, 2001)).max()


def along(angles, pressure, at):
    """Pressure at any angles, quadratic on every edge."""
    size = angles[2] - angles[0]
    edge = np.clip((at / size).astype(int), 0, len(angles) // 2 - 1)
    t = 2 * (at / size - edge) - 1
    a, b, c = (pressure[2 * edge + k] for k in range(3))
    return np.where(at <= angles[-1], a * t * (t - 1) / 2 + b * (1 - t**2) + c * t * (t + 1) / 2, 0.0)
