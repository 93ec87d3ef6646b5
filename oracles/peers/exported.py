"""What scripts for exported cases share: the problem that `contact-vv export` writes, its iterations, and answers that `contact-vv judge` reads.

A problem (problem.json, units mm, N, MPa, rad) has points, cells (4 corners counter-clockwise, then for order 2 the middles of 01, 12, 23, 30),
the body of each cell, young, poisson, plane, thickness, held (node, component, value), forces (node, component, value), tied (sides that stay
flat: nodes, component, force), and contacts. A contact node has a position along the contact, an area, an initial gap (null without another
side) and a row (node, component, factor) whose product with the displacements is the approach w; remaining gap = gap - w.
"""

import argparse
import csv
import json
import os
import pathlib
import sys
import traceback

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"  # before any library is loaded

MISSING = 3  # exit code
SOFT = 10.0  # penalty over the largest Young's modulus and the smallest contact edge, as one would choose it first
STEPS = 100
ALIKE = 1e-3  # part of the widest gap
START = 1e-6  # overlap to begin with at least, over the size of the scene
PARTS = [[0, 4, 8, 7], [4, 1, 5, 8], [8, 5, 2, 6], [7, 8, 6, 3]]  # of a cell with 9 nodes


def missing(what, install):
    """Ends the process: a package is not installed, which a command installs."""
    checkout = "bash oracles/setup.sh && bash oracles/peers/setup.sh"
    print(f"{what} is missing in {sys.executable}: {install}; or, in a checkout on Debian 12, {checkout}", file=sys.stderr)
    sys.exit(MISSING)


# scikit-fem is there where oracles/setup.sh has put it.
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / ".python/site"))

try:
    import numpy as np
    from scipy.sparse import bmat, coo_matrix, diags
except ModuleNotFoundError as absent:
    missing(absent.name, "python3 -m pip install numpy scipy")


class Problem:
    """The problem in a folder; cells with 8 nodes get a ninth one in their middle, where it is wanted."""

    def __init__(self, folder, centres=True):
        self.folder = pathlib.Path(folder)
        self.data = json.loads((self.folder / "problem.json").read_text(encoding="utf-8"))
        self.points = np.array(self.data["points"])
        self.cells = np.array(self.data["cells"])
        self.body = np.array(self.data["body"])
        if centres and self.cells.shape[1] == 8:
            self.add_centres()
        nodes = [node for contact in self.data["contacts"] for node in contact["nodes"]]
        self.gap = np.array([np.inf if node["gap"] is None else node["gap"] for node in nodes])
        self.area = np.array([node["area"] for node in nodes])
        terms = np.array([(k, 2 * n + c, f) for k, node in enumerate(nodes) for n, c, f in node["row"]])
        shape = len(nodes), 2 * len(self.points)
        self.rows = coo_matrix((terms[:, 2], terms[:, :2].T.astype(int)), shape).tocsr()

    def drawn(self, method):
        """Refuses gaps that two meshes do not have between them, such as an interference, where a code finds them itself."""
        between, known = -(self.rows @ self.points.ravel()), np.isfinite(self.gap)
        off, widest = np.abs(between - self.gap)[known].max(), np.abs([between, self.gap])[:, known].max()
        if off > ALIKE * widest + 1e-9 * np.ptp(self.points):
            raise ValueError(f"the gaps of problem.json are off by up to {off:.4g} mm from those between the meshes, of which alone this method"
                             f" knows: {method} takes them from the file")

    def add_centres(self):
        """Makes the cells such with 9 nodes, of the same shape."""
        corners, middles = self.points[self.cells[:, :4]], self.points[self.cells[:, 4:]]
        centres = 0.5 * middles.sum(axis=1) - 0.25 * corners.sum(axis=1)
        self.cells = np.column_stack([self.cells, len(self.points) + np.arange(len(self.cells))])
        self.points = np.vstack([self.points, centres])

    def of_body(self, body):
        """Nodes of a body, and its cells in their numbers."""
        nodes, cells = np.unique(self.cells[self.body == body], return_inverse=True)
        return nodes, cells.reshape(-1, self.cells.shape[1])

    def stiffness(self, of_body):
        """Matrix of all bodies from `of_body(points, cells, young, poisson, plane)`, dofs 2 node + component."""
        parts = []
        for body, (young, poisson) in enumerate(zip(self.data["young"], self.data["poisson"])):
            nodes, cells = self.of_body(body)
            part = of_body(self.points[nodes], cells, young, poisson, self.data["plane"]).tocoo()
            dofs = np.column_stack([2 * nodes, 2 * nodes + 1]).ravel()
            parts.append((part.data, dofs[part.row], dofs[part.col]))
        data, row, column = (np.concatenate(list) for list in zip(*parts))
        size = 2 * len(self.points)
        return self.data["thickness"] * coo_matrix((data, (row, column)), (size, size)).tocsr()

    def load(self):
        """Nodal forces."""
        force = np.zeros(2 * len(self.points))
        for node, component, value in self.data["forces"]:
            force[2 * node + component] += value
        for side in self.data["tied"]:
            force[2 * side["nodes"][0] + side["component"]] += side["force"]
        return force

    def motions(self):
        """T and u0 of u = T q + u0: held components are given, those of a tied side are one."""
        size = 2 * len(self.points)
        column, given, kept = np.arange(size), np.zeros(size), np.ones(size, bool)
        for side in self.data["tied"]:
            dofs = 2 * np.array(side["nodes"]) + side["component"]
            column[dofs] = dofs[0]
        for node, component, value in self.data["held"]:
            kept[2 * node + component], given[2 * node + component] = False, value
        used, place = np.unique(column[kept], return_inverse=True)
        return coo_matrix((np.ones(kept.sum()), (np.flatnonzero(kept), place)), (size, len(used))).tocsr(), given

    def hanging(self):
        """The body that contact alone holds across the first contact, and which way it closes the gap; none where supports hold all."""
        contact = self.data["contacts"][0]
        normal = np.array(contact["normal"])
        axis = int(np.argmax(np.abs(normal)))
        held = {int(self.body[(self.cells == node).any(axis=1)][0]) for node, c, _ in self.data["held"] if c == axis}
        for body, towards in (contact["first"], normal), (contact["second"], -normal):
            if body is not None and body not in held:
                return body, towards
        return None, np.zeros(2)

    def started(self, part):
        """Displacements by which a body that contact alone holds overlaps: at mere touching tangents are singular.

        It is moved over the narrowest gap, a part of the way to the widest one, and a little.
        """
        gap = self.gap[: len(self.data["contacts"][0]["nodes"])]
        gap, moved, (body, towards) = gap[np.isfinite(gap)], np.zeros((len(self.points), 2)), self.hanging()
        if body is not None:
            moved[self.of_body(body)[0]] = (gap.min() + part * np.ptp(gap) + START * np.ptp(self.points)) * towards
        return moved.ravel()

    def system(self, part):
        """T and u0 as of `motions`, forces per unit of thickness, and q to start with: as `started`, sides that are tied in the mean."""
        motions, given = self.motions()
        count = np.asarray(motions.sum(axis=0)).ravel()
        return motions, given, self.load() / self.data["thickness"], motions.T @ (self.started(part) - given) / count

    def scale(self):
        """Size of the forces per unit of thickness: of the load or, without one, of what given displacements make."""
        load = np.abs(self.load().reshape(-1, 2).sum(axis=0)).max() / self.data["thickness"]
        return load or max(self.data["young"]) * max(abs(value) for _, _, value in self.data["held"])

    def pressures(self, pushed, lengths=None):
        """Pressures of nodes, 0 beside the contacts, by the contact forces on them over their areas or, by contact, over given lengths."""
        pressure, pushed = np.zeros(len(pushed) // 2), pushed.reshape(-1, 2)
        for k, contact in enumerate(self.data["contacts"]):
            for node in contact["nodes"]:
                n = node["node"]
                pressure[n] = -pushed[n] @ node["normal"] / (node["area"] if lengths is None else lengths[k][n])
        return pressure

    def spring(self):
        """Penalty of the first choice [MPa/mm]."""
        places = [self.points[[node["node"] for node in contact["nodes"]]] for contact in self.data["contacts"]]
        edge = min(np.linalg.norm(np.diff(at, axis=0), axis=1).min() for at in places)
        return SOFT * max(self.data["young"]) / edge


class Linear:
    """The scene in cells with 4 nodes: points, cells, body of each cell, and the edges of both sides of each contact."""

    def __init__(self, problem):
        self.problem, self.points, self.body = problem, problem.points, problem.body
        self.cells, self.contacts = problem.cells[:, :4], []
        cut = problem.cells.shape[1] == 9
        if cut:
            self.cells, self.body = problem.cells[:, PARTS].reshape(-1, 4), np.repeat(problem.body, 4)
        for contact in problem.data["contacts"]:
            first, second = (self.halves(contact[side], cut) for side in ("edges", "opposite_edges"))
            self.contacts.append((first, self.wall(contact) if contact["second"] is None else second))

    @staticmethod
    def halves(edges, cut):
        """Edges with 2 nodes."""
        return [pair for edge in edges for pair in ([(edge[0], edge[2]), (edge[2], edge[1])] if cut else [tuple(edge[:2])])]

    def wall(self, contact):
        """Adds a row of cells behind the nodes of the contact, a gap away; returns its edges."""
        if contact["arc"]:
            raise ValueError("the rigid body of an arc is not set up")
        if any(node["gap"] is None for node in contact["nodes"]):
            raise ValueError("an obstacle with an edge has no smooth distance")
        normal = np.array(contact["normal"])
        along = np.array([-normal[1], normal[0]])
        nodes = sorted((self.points[node["node"]] @ along, node["node"], node["gap"]) for node in contact["nodes"])
        near = np.array([self.points[node] + gap * normal for _, node, gap in nodes])
        n, k = len(near), len(self.points) + np.arange(len(near) - 1)
        self.points = np.vstack([self.points, near, near + np.ptp(near @ along) * normal])
        self.cells = np.vstack([self.cells, np.column_stack([k, k + n, k + n + 1, k + 1])])
        self.body = np.append(self.body, np.full(n - 1, self.body.max() + 1))
        return [(a, a + 1) for a in k]

    def materials(self):
        """Young's modulus and Poisson's ratio of each body; a rigid one, which is held, has those of the first."""
        given = list(zip(self.problem.data["young"], self.problem.data["poisson"]))
        return given + given[:1] * (int(self.body.max()) + 1 - len(given))

    def lengths(self):
        """Length of the first side that belongs to each node, by contact."""
        lengths = np.zeros((len(self.contacts), len(self.points)))
        for length, (edges, _) in zip(lengths, self.contacts):
            for edge in edges:
                length[list(edge)] += 0.5 * np.linalg.norm(self.points[edge[1]] - self.points[edge[0]])
        return lengths

    def system(self, part):
        """The system of the problem, with the nodes of rigid bodies, which do not move."""
        motions, given, force, start = self.problem.system(part)
        rigid = 2 * len(self.points) - len(given)
        motions.resize(len(given) + rigid, motions.shape[1])
        return motions, np.pad(given, (0, rigid)), np.pad(force, (0, rigid)), start


def solve(problem, stiffness, method, direct):
    """Pressures, remaining gaps and iterations, by springs (`penalty`) or exactly (`active-set`); `direct(A, b)` solves A x = b."""
    motions, given = problem.motions()
    known = np.isfinite(problem.gap)
    rows = problem.rows[known] @ motions
    gap = problem.gap[known] - problem.rows[known] @ given
    matrix = motions.T @ stiffness @ motions
    force = motions.T @ (problem.load() - stiffness @ given)
    spring, active = problem.spring() * problem.area[known], np.ones(known.sum(), bool)
    for step in range(1, STEPS + 1):
        closed = rows[active]
        if method == "penalty":
            weight = diags(spring[active])
            q = direct(matrix + closed.T @ weight @ closed, force + closed.T @ (weight @ gap[active]))
            pushed = spring * (rows @ q - gap)
            after = pushed > 0
        else:
            none = coo_matrix((active.sum(), active.sum()))
            found = direct(bmat([[matrix, closed.T], [closed, none]]), np.concatenate([force, gap[active]]))
            q, pushed = found[: matrix.shape[0]], np.zeros(len(gap))
            pushed[active] = found[matrix.shape[0] :]
            after = pushed + spring * (rows @ q - gap) > 0
        if (after == active).all():
            pressure, left = np.zeros(len(known)), np.full(len(known), np.inf)
            pressure[known] = np.where(active, pushed, 0.0) / problem.area[known]
            left[known] = gap - rows @ q
            return pressure, left, step
        active = after
    raise RuntimeError(f"the active set still changes after {STEPS} iterations")


def units(contact):
    """Units of the lists of a contact: along an arc positions are angles."""
    return {"position": "rad" if contact["arc"] else "mm", "pressure": "MPa", "gap": "mm", "area": "mm2"}


def write_json(problem, file, code, pressure, gap):
    """The answer by the schema that `contact-vv schema answer` prints; angles in rad."""
    own, contacts, k = units(problem.data["contacts"][0]), [], 0
    for contact in problem.data["contacts"]:
        n = len(contact["nodes"])
        left = [value if np.isfinite(value) else None for value in gap[k : k + n].tolist()]
        other = {} if units(contact) == own else {"units": units(contact)}
        contacts.append({"name": contact["name"]} | other | {
            "order": problem.data["order"], "position": [node["position"] for node in contact["nodes"]],
            "pressure": pressure[k : k + n].tolist(), "gap": left, "area": problem.area[k : k + n].tolist()})
        k += n
    text = json.dumps({"case": problem.data["case"], "code": code, "units": own, "contacts": contacts})
    (problem.folder / file).write_text(text + "\n", encoding="utf-8")


def write_csv(problem, file, pressure, gap):
    """The answer as a table; angles have a column of their own beside lengths."""
    contacts = problem.data["contacts"]
    kinds = sorted({units(contact)["position"] for contact in contacts})
    nodes = [(contact, node["position"]) for contact in contacts for node in contact["nodes"]]
    with open(problem.folder / file, "w", encoding="utf-8", newline="") as table:
        rows = csv.writer(table, lineterminator="\n")
        rows.writerow(["contact", *(f"position [{kind}]" for kind in kinds), "pressure [MPa]", "gap [mm]", "area [mm2]"])
        for (contact, at), *numbers in zip(nodes, pressure.tolist(), gap.tolist(), problem.area.tolist()):
            places = [repr(at) if kind == units(contact)["position"] else "" for kind in kinds]
            rows.writerow([contact["name"], *places, *(repr(number) for number in numbers)])


def report(**told):
    """Prints what is told of a run: code, version, file, iterations, seconds."""
    print(json.dumps(told))


def run(main, description, methods, versions, searched=None):
    """Calls `main` with what the command line tells; what breaks off tells where, and the versions the code shall be of.

    That is the folder, the method and, where the code's own contact has a parameter, its multiple of the first choice."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="folder with the problem.json that `contact-vv export CASE FOLDER` writes; the answer goes there")
    parser.add_argument("method", choices=list(methods), help="the contact, see above")
    if searched:
        parser.add_argument("--times", type=float, default=1.0, help=f"multiple of the first choice of {searched} (1)")
    asked = parser.parse_args()
    if not (pathlib.Path(asked.folder) / "problem.json").is_file():
        parser.error(f"{asked.folder} has no problem.json: write it by `contact-vv export CASE {asked.folder}`")
    try:
        main(**vars(asked))
    except Exception as other:  # of a code of another version, any
        at = traceback.extract_tb(other.__traceback__)[-1]
        sys.exit(f"{pathlib.Path(at.filename).name}:{at.lineno}: {type(other).__name__}: {other}\n"
                 f"This script is written for {versions}, and has been run with these.")
