"""Frictionless contact as a user of scikit-fem would write it: 9-node quadrilaterals, contact terms as forms on facets.

By a penalty, p = k_n <w - g>+, or by Nitsche's method without one, p = <gamma (w - g) - sigma_n>+ (Chouly, Hild, Renard 2015,
theta = 0); w = (u1 - u2).n is the approach along the first body's outward normal n, g the gap, sigma_n = n.sigma(u1)n.
Newton's active set is that of the integration points. Units mm, N, MPa, rad.
"""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np
from scipy.sparse import block_diag, bmat, csr_matrix
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementQuad2, ElementVector, FacetBasis, LinearForm
from skfem.helpers import ddot, dot, mul, sym_grad

import models

KAPPA = 1e4  # k_n = KAPPA E*/l: a softer spring costs more, with a harder one Newton cycles
GAMMA = 10.0  # gamma = GAMMA E*/h: any that is large enough; far larger ones are a penalty
# Order of quadrature on the candidates: two points an edge keep a stiff penalty from oscillating within it.
ORDERS = {"penalty": 3, "nitsche": 7}
STEPS = 60
ELEMENT = ElementVector(ElementQuad2())


def solve(scene, level, method="penalty"):
    """Half-width, peak, resultant, mean pressures round scene["stations"] and dofs of a scene on the mesh of a level."""
    if method not in ORDERS:
        raise ValueError(f"method {method!r}: use one of {', '.join(ORDERS)}")
    model = models.model(scene, level)
    bases = [Basis(mesh, ELEMENT, intorder=5) for mesh in model.meshes]
    stiffness, load = elastic(model, bases)
    free = free_motions(model, bases)
    contact = Contact(model, method)
    active = contact.place < 1.5 * model.start  # well beyond the contact, which is not known
    for _ in range(STEPS):
        tangent, force = contact.linearised(active)
        matrix = (free.T @ (stiffness + tangent) @ free).tocsc()
        u = free @ splu(matrix, permc_spec="MMD_AT_PLUS_A").solve(free.T @ (load + force))
        pressure = contact.pressure(np.split(u, np.cumsum([basis.N for basis in bases])[:-1]))
        if ((pressure > 0.0) == active).all():
            return measures(contact, np.maximum(pressure, 0.0), model, np.asarray(scene["stations"]), free.shape[1])
        active = pressure > 0.0
    raise RuntimeError(f"{scene['case']}: the active set still changes after {STEPS} iterations; start nearer to the contact")


def stress(u, material):
    """Stress of a displacement field [MPa]; material: Young's modulus, Poisson's ratio, plane hypothesis."""
    young, poisson, plane = material
    below = (1 - 2 * poisson) if plane == "strain" else (1 - poisson)
    strain = sym_grad(u)
    across = young * poisson / ((1 + poisson) * below) * (strain[0, 0] + strain[1, 1])
    sigma = young / (1 + poisson) * strain
    return np.array([[sigma[0, 0] + across, sigma[0, 1]], [sigma[1, 0], sigma[1, 1] + across]])


def elastic(model, bases):
    """Stiffness and load of all bodies, thickness included."""
    matrices, loads = [], []
    for body, (basis, material) in enumerate(zip(bases, model.materials)):
        energy = BilinearForm(lambda u, v, _: ddot(stress(u, material), sym_grad(v)))
        matrices.append(model.thickness * energy.assemble(basis))
        load = np.zeros(basis.N)
        for facets, traction in model.tractions if body == 0 else []:
            side = FacetBasis(basis.mesh, ELEMENT, facets=facets, intorder=9)
            load += model.thickness * LinearForm(lambda v, w: dot(traction(w.x), v)).assemble(side)
        loads.append(load)
    load = np.concatenate(loads)
    for where, force in model.forces:
        load[dofs_at(bases, *where)[0]] += force
    return block_diag(matrices, format="csr"), load


def dofs_at(bases, body, component, at):
    """Dofs of a body in one component where `at(x)` holds, in the numbering of all bodies."""
    start = sum(basis.N for basis in bases[:body])
    basis = bases[body]
    own = np.concatenate([basis.nodal_dofs[component], basis.facet_dofs[component], basis.interior_dofs[component]])
    return start + own[at(basis.doflocs[:, own])]


def free_motions(model, bases):
    """Matrix T of u = T q: fixed dofs have no column, those of a rigid face share one."""
    size = sum(basis.N for basis in bases)
    column, kept = np.arange(size), np.ones(size, bool)
    for where in model.rigid:
        face = dofs_at(bases, *where)
        column[face] = face[0]
    for where in model.fixed:
        kept[dofs_at(bases, *where)] = False
    used, place = np.unique(column[kept], return_inverse=True)
    return csr_matrix((np.ones(kept.sum()), (np.flatnonzero(kept), place)), (size, len(used)))


class Contact:
    """The candidates: facets of the first body, and those of the second that face them one by one."""

    def __init__(self, model, method):
        pairs = zip(model.meshes, model.candidates)
        self.sides = [FacetBasis(mesh, ELEMENT, facets=facets, intorder=ORDERS[method]) for mesh, facets in pairs]
        first, x = self.sides[0], self.sides[0].global_coordinates().value
        self.place, self.normal, self.gap = model.coordinate(x), model.normal(x), model.gap(x)
        facing = model.coordinate(self.sides[-1].global_coordinates().value)
        if not np.allclose(facing, self.place, atol=1e-3 * model.start):
            raise RuntimeError("the candidates of the bodies do not face one another point by point")
        # On a plane areas are those of the plane below: dA = |n_y| ds.
        share = np.abs(first.normals.value[1]) if model.above_plane else 1.0
        self.area = model.thickness * share * first.dx
        length = np.broadcast_to(first.dx.sum(axis=1, keepdims=True), first.dx.shape)
        nitsche = method == "nitsche"
        self.spring = GAMMA * model.modulus / length if nitsche else KAPPA * model.modulus / model.length + 0 * length
        self.material = model.materials[0] if nitsche else None

    def share(self, u, body):
        """What a displacement of a body adds to the pressure where that is positive [MPa]."""
        towards = self.spring * dot(u, self.normal)
        if body > 0:
            return -towards
        if self.material is None:
            return towards
        return towards - dot(self.normal, mul(stress(u, self.material), self.normal))

    def linearised(self, active):
        """Tangent and nodal forces of the active points: the contact's forces are `forces - tangent @ u`."""
        weight = active * self.area

        def tangent(test, trial):
            sign = 1.0 if test == 0 else -1.0
            form = BilinearForm(
                lambda u, v, _: sign * weight / self.sides[trial].dx * self.share(u, trial) * dot(v, self.normal)
            )
            return form.assemble(self.sides[trial], self.sides[test])

        def force(test):
            sign = 1.0 if test == 0 else -1.0
            given = sign * weight / self.sides[test].dx * self.spring * self.gap
            return LinearForm(lambda v, _: given * dot(v, self.normal)).assemble(self.sides[test])

        bodies = range(len(self.sides))
        rows = [[tangent(test, trial) for trial in bodies] for test in bodies]
        return bmat(rows, format="csr"), np.concatenate([force(test) for test in bodies])

    def pressure(self, displacements):
        """Pressures at the integration points, before they are cut off at zero [MPa]."""
        fields = [side.interpolate(u) for side, u in zip(self.sides, displacements)]
        return sum(self.share(u, body) for body, u in enumerate(fields)) - self.spring * self.gap


def measures(contact, pressure, model, stations, dofs):
    """The quantities that are asked for."""
    place, force = contact.place, contact.area * pressure
    if pressure[place >= place.max() - 1e-12].max() > 0.0:
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    half_width = 2.0 * np.sqrt((force * place**2).sum() / force.sum())
    half = 0.5 * (stations[1] - stations[0])
    fine = stations[:, None] + half * (np.arange(200) + 0.5 - 100) / 100
    return {
        "half_width": float(half_width),
        "peak": float(peak(place, pressure, contact.area, half_width)),
        "resultant": float(2.0 * (force * -contact.normal[1]).sum()),
        "pressure": along(place, pressure, fine).mean(axis=1),
        "dofs": int(dofs),
    }


def along(place, pressure, at):
    """Pressure at any places, linear between the integration points."""
    order = np.argsort(place.ravel())
    return np.interp(at, place.ravel()[order], pressure.ravel()[order])


def peak(place, pressure, area, half_width):
    """Largest value of an even sextic about 0, or, where that is not largest there, of a quintic about the largest edge mean.

    Means of the powers go with means of the pressure, edge by edge: a mode alternating within edges is not seen.
    """
    weight = area.sum(axis=1)
    means = (area * pressure).sum(axis=1) / weight
    top = place.mean(axis=1)[np.argmax(means)]
    even = top < 0.3 * half_width
    powers, centre, reach = ([0, 2, 4, 6], 0.0, 0.5) if even else (range(6), top, 0.25)
    t = (place - centre) / half_width
    # Two edges as far to either side are both in or both out, whatever rounding makes of them.
    near = np.abs(t.mean(axis=1)) < max(reach, np.sort(np.abs(t.mean(axis=1)))[len(powers)]) * (1.0 - 1e-9)
    terms = np.array([(area * t**k).sum(axis=1) / weight for k in powers]).T
    root = np.sqrt(weight[near])
    found = np.linalg.lstsq(root[:, None] * terms[near], root * means[near], rcond=None)[0]
    fine = np.linspace(0.0 if even else -reach, reach, 2001)
    return (np.array([fine**k for k in powers]).T @ found).max()
