"""Contact of bodies of revolution in CalculiX: CAX8 elements, and a gap element between each candidate node and the rigid surface.

The approach w = -u_z of a node is the freedom of a node of its own, by an *EQUATION, and a GAPUNI of clearance g lies between that node and
a fixed one, whose reaction is the contact force. Forces are those of the whole circumference. A sphere on a rigid plane, loaded on its cut,
and a block with the tractions of Hertz's half-space on its other faces. Units mm, N, MPa.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/revolution/freeze.py, which imports this module")

import os
import re
import subprocess
import tempfile

import numpy as np

ELEMENTS, GROWTH = 6, 1.5  # on the radius of the contact, level 0, and growth away from it
STIFFNESS, TAIL = 1e3, 1e-9  # of a gap element: closed, over E*a [N/mm]; pull of an open one, over the force
SECTORS = 180  # ccx makes bricks of a sector of 2 degrees; its loads are those of the circumference, its reactions those of the sector
JOB = "revolution"
GAUSS = np.polynomial.legendre.leggauss(8)


def solve(scene, level, _method="gaps"):
    """Contact radius, peak, resultant, mean pressures round scene["stations"], approach and dofs of a scene on the mesh of a level."""
    if scene["case"] not in MESHES:
        raise ValueError(f"case {scene['case']!r}: use one of {', '.join(MESHES)}")
    radius, a = scene["radius"], scene["a_over_r"] * scene["radius"]
    modulus = scene["young"] / (1 - scene["poisson"] ** 2)
    load = 4 * modulus * a**3 / (3 * radius)
    nodes, elements, candidates, far, loads = MESHES[scene["case"]](scene, level, load)
    r = nodes[candidates, 0]
    gap = radius - np.sqrt(radius**2 - r**2) if scene["case"] == "sphere" else r**2 / (2 * radius)
    printed, equations = run(written(scene, nodes, elements, candidates, gap, loads, STIFFNESS * modulus * a, TAIL * load, far))
    values = np.array([[float(x) for x in row] for row in re.findall(r"^ +(\d+) +(\S+) +(\S+) +\S+$", printed, re.MULTILINE)])
    first = len(nodes) + len(candidates)
    forces = -SECTORS * values[values[:, 0] > first, 1]
    weight = areas(nodes[far, 0]) @ np.ones(len(far))
    fallen = -(weight * values[values[:, 0] <= first, 2]).sum() / weight.sum()
    return {**measures(r, forces, np.asarray(scene["stations"])), "approach": float(fallen), "dofs": equations}


def written(scene, nodes, elements, candidates, gap, loads, stiffness, pull, far):
    """The input deck; behind the nodes come those of the approaches, and the fixed ones."""
    count, pairs = len(nodes), len(candidates)
    approach, fixed = count + 1 + np.arange(pairs), count + pairs + 1 + np.arange(pairs)
    lines = ["*NODE", *(f"{n},{x:.12e},{y:.12e}" for n, (x, y) in enumerate(nodes, 1)), *(f"{n},0.,0." for n in range(count + 1, fixed[-1] + 1))]
    for kind, size in (("CAX8", 8), ("CAX6", 6)):
        lines += [f"*ELEMENT,TYPE={kind},ELSET=BODY"] if any(len(e) == size for e in elements) else []
        lines += [",".join(str(n + 1) for n in [k, *e]) for k, e in enumerate(elements) if len(e) == size]
    lines += ["*MATERIAL,NAME=ELASTIC", "*ELASTIC", f"{scene['young']:.12e},{scene['poisson']:.12e}", "*SOLID SECTION,ELSET=BODY,MATERIAL=ELASTIC"]
    for k, (node, moved, still) in enumerate(zip(candidates, approach, fixed), len(elements) + 1):
        lines += [f"*ELEMENT,TYPE=GAPUNI,ELSET=GAP{k}", f"{k},{moved},{still}"]
        lines += [f"*GAP,ELSET=GAP{k}", f"{gap[k - len(elements) - 1]:.12e},1.,0.,0.,,{stiffness:.6e},{pull:.6e}"]
        lines += ["*EQUATION", "2", f"{moved},1,1.,{node + 1},2,1."]
    for name, numbers in (("AXIS", np.flatnonzero(nodes[:, 0] < 1e-9) + 1), ("APPROACH", approach), ("FIXED", fixed), ("FAR", far + 1)):
        lines += [f"*NSET,NSET={name}", *(str(n) for n in numbers)]
    lines += ["*BOUNDARY", "AXIS,1,1", "APPROACH,2,3", "FIXED,1,3"]
    # Under contact by gap elements alone ccx takes a step for linear; a plastic material, though no element is of it, makes it iterate.
    lines += ["*MATERIAL,NAME=UNUSED", "*ELASTIC", "1.,0.", "*PLASTIC", "1e20,0.", "2e20,1."]
    lines += ["*STEP", "*STATIC,DIRECT", "1.,1.", "*CONTROLS,PARAMETERS=FIELD", "1e-7,1e-7,,,,,,", "*CLOAD"]
    lines += [f"{node + 1},{k + 1},{loads[node, k]:.12e}" for node, k in zip(*np.nonzero(loads))]
    return "\n".join([*lines, "*NODE PRINT,NSET=FIXED", "RF", "*NODE PRINT,NSET=FAR", "U", "*END STEP", ""])


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


def shapes(xi):
    """Quadratic shape functions at xi from -1 to 1."""
    return np.array([xi * (xi - 1) / 2, 1 - xi**2, xi * (xi + 1) / 2])


def areas(r, of=None):
    """Matrix of the integrals of N_i N_j 2 pi r dr along a line of quadratic edges, or of N_i f(r) 2 pi r dr."""
    xi, weight = GAUSS
    matrix = np.zeros((len(r), len(r) if of is None else 1))
    for k in range(0, len(r) - 2, 2):
        place, half = r[k : k + 3] @ shapes(xi), 0.5 * (r[k + 2] - r[k])
        other = shapes(xi) if of is None else of(place)[None, :]
        matrix[k : k + 3, slice(k, k + 3) if of is None else slice(0, 1)] += (shapes(xi) * (2 * np.pi * place * half * weight)) @ other.T
    return matrix


def measures(r, forces, stations):
    """The quantities that are asked for; the contact radius by second moment, a^2 = 5/2 of the mean of r^2 below Hertz's pressure."""
    if forces[-1] > 1e-4 * forces.max():
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    radius = np.sqrt(2.5 * (forces * r**2).sum() / forces.sum())
    # Value at 0 of the even sextic whose nodal forces are nearest to those on the inner half.
    inner = r < 0.5 * radius
    terms = np.hstack([areas(r, lambda x, k=k: (x / radius) ** k) for k in (0, 2, 4, 6)])
    peak = np.linalg.lstsq(terms[inner], forces[inner], rcond=None)[0][0]
    pressure = np.linalg.solve(areas(r), forces)
    fine = stations[:, None] + (stations[1] - stations[0]) * (np.arange(200) - 99.5) / 200
    edge = np.clip((np.searchsorted(r[::2], fine) - 1), 0, len(r) // 2 - 1)
    xi = (fine - r[2 * edge]) / (r[2 * edge + 2] - r[2 * edge]) * 2 - 1
    along = sum(pressure[2 * edge + k] * shape for k, shape in enumerate(shapes(xi)))
    return {"half_width": float(radius), "peak": float(peak), "resultant": float(forces.sum()), "pressure": along.mean(axis=1)}


def ticks(level, *parts):
    """Corners along parts (start, end, number, growth), halved so many times, and the middles between them."""
    places = np.array([0.0])
    for start, end, count, growth in parts:
        sums = np.cumsum(growth ** np.arange(count, dtype=float))
        places = np.append(places, start + (end - start) * sums / sums[-1])
    return np.interp(np.arange((len(places) - 1) * 2 ** (level + 1) + 1) / 2 ** (level + 1), np.arange(len(places)), places)


def growing(length, first):
    """Number of distances that grow from the first to a length."""
    return max(1, int(np.ceil(np.log1p(length * (GROWTH - 1) / first) / np.log(GROWTH))))


def grid(s, t, at):
    """Nodes `at(s, t)` and 8-node elements between two lists of ticks; node numbers by place in the lists."""
    number = -np.ones((len(s), len(t)), int)
    used = (np.arange(len(s))[:, None] % 2 == 0) | (np.arange(len(t)) % 2 == 0)
    number[used] = np.arange(used.sum())
    i, j = np.nonzero(used)
    c = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    elements = [[number[a + p, b + q] for p, q in c] for a in range(0, len(s) - 2, 2) for b in range(0, len(t) - 2, 2)]
    return np.array([at(s[k], t[m]) for k, m in zip(i, j)]), elements, number


def truncated(scene, level, load):
    """Block on z = 0, with the nodal forces of the half-space's tractions."""
    a = scene["a_over_r"] * scene["radius"]
    side, reach, first = scene["size"] * a, scene["stretch"] * a, a / ELEMENTS
    near = round(ELEMENTS * scene["stretch"])
    r = ticks(level, (0, reach, near, 1.0), (reach, side, growing(side - reach, GROWTH * first), GROWTH))
    z = ticks(level, (0, side, growing(side, first), GROWTH))
    nodes, elements, number = grid(r, z, lambda r, z: (r, z))
    loads, p0 = np.zeros_like(nodes), 1.5 * load / (np.pi * a**2)
    for k, part in ((0, 2), (1, 1)):
        loads[number[:, -1], k] += areas(r, lambda x, part=part: p0 * huber(x / a, side / a, scene["poisson"])[part])[:, 0]
    for k, part in ((0, 0), (1, 2)):
        # 2 pi side dz, by the rule of 2 pi r dr
        loads[number[-1], k] += areas(z, lambda x, part=part: p0 * huber(side / a, x / a, scene["poisson"])[part] * side / x)[:, 0]
    return nodes, elements, number[r <= reach * (1 + 1e-9), 0], number[:, -1], loads


def huber(r, z, poisson):
    """(sigma_r, sigma_z, tau_rz)/p0 below Hertz's pressure, a = 1 (Huber 1904; Fischer-Cripps, Contact Mechanics, 2007, eq. 5.4)."""
    u = 0.5 * (r**2 + z**2 - 1 + np.sqrt((r**2 + z**2 - 1) ** 2 + 4 * z**2))
    part, turn, below = z / np.sqrt(u), np.arctan(1 / np.sqrt(u)), u**2 + z**2
    radial = (1 - 2 * poisson) / (3 * r**2) * (1 - part**3) + part**3 * u / below
    radial += part * (u * (1 - poisson) / (1 + u) + (1 + poisson) * np.sqrt(u) * turn - 2)
    return radial, -(part**3) * u / below, -r * z**2 * np.sqrt(u) / (below * (1 + u))


def sphere(scene, level, load):
    """Lower half of a sphere about (0, R): rings round a fan at its centre, and the uniform load on its cut."""
    radius, a = scene["radius"], scene["a_over_r"] * scene["radius"]
    reach, first, core = np.arcsin(scene["stretch"] * a / radius), a / ELEMENTS, 0.2 * radius
    near = round(ELEMENTS * scene["stretch"])
    angle = ticks(level, (0, reach, near, 1.0), (reach, np.pi / 2, growing(np.pi / 2 - reach, GROWTH * first / radius), GROWTH))
    depth = ticks(level, (0, radius - core, growing(radius - core, first), GROWTH))
    nodes, elements, number = grid(angle, depth, lambda s, t: ((radius - t) * np.sin(s), radius - (radius - t) * np.cos(s)))
    middle = len(nodes) + np.arange(len(angle[::2]))
    nodes = np.vstack([nodes, [(0.5 * core * np.sin(s), radius - 0.5 * core * np.cos(s)) for s in angle[::2]], [(0.0, radius)]])
    centre, rim = len(nodes) - 1, number[:, -1]
    elements += [[centre, rim[k], rim[k + 2], middle[k // 2], rim[k + 1], middle[k // 2 + 1]] for k in range(0, len(angle) - 2, 2)]
    cut = np.array([centre, middle[-1], *number[-1, ::-1]])
    loads = np.zeros_like(nodes)
    loads[cut, 1] = areas(nodes[cut, 0], lambda x: 0 * x - load / (np.pi * radius**2))[:, 0]
    return nodes, elements, number[angle <= reach * (1 + 1e-9), 0], cut, loads


MESHES = {"sphere": sphere, "truncated-sphere": truncated}
