"""Contact of bodies of revolution as a user of scikit-fem would write it: 9-node quadrilaterals in (r, z), forms weighted by 2 pi r.

Strains are those of the plane and u_r/r; contact is a penalty p = k_n <w - g>+ on facets, w = -u_z the approach, g the gap. Newton's
active set is that of the integration points. A sphere on a rigid plane, loaded on its cut; and a block with the tractions of Hertz's
half-space (Huber 1904) on its other faces. Units mm, N, MPa.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/revolution/freeze.py, which imports this module")

from importlib.metadata import version as version_of

import numpy as np
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementQuad2, ElementVector, FacetBasis, LinearForm, MeshQuad, MeshQuad2
from skfem.helpers import ddot, dot, sym_grad, trace

KAPPA = 1e4  # k_n = KAPPA E*/a
ELEMENTS, GROWTH = 6, 1.6  # on the radius of the contact, level 0, and growth away from it
STEPS = 60
ELEMENT = ElementVector(ElementQuad2())
CORE = 0.45  # of the square inside the sphere's rings, over its radius


def version():
    """Of scikit-fem."""
    return version_of("scikit-fem")


def solve(scene, level, method="penalty"):
    """Contact radius, peak, resultant, mean pressures round scene["stations"], approach and dofs of a scene on the mesh of a level."""
    if method != "penalty" or scene["case"] not in MESHES:
        raise ValueError(f"{scene['case']!r} by {method!r}: use one of {', '.join(MESHES)} by 'penalty'")
    a, modulus, load = hertz(scene)
    mesh, tractions = MESHES[scene["case"]](scene, level, load)
    basis = Basis(mesh, ELEMENT, intorder=7)
    young, poisson = scene["young"], scene["poisson"]
    shear, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))

    @BilinearForm
    def energy(u, v, w):
        r = w.x[0]
        e, d = sym_grad(u), sym_grad(v)
        volume = lame * (trace(e) + u[0] / r) * (trace(d) + v[0] / r)
        return 2 * np.pi * r * (volume + 2 * shear * (ddot(e, d) + u[0] * v[0] / r**2))

    stiffness, force = energy.assemble(basis), np.zeros(basis.N)
    for facets, traction in tractions:
        side = FacetBasis(mesh, ELEMENT, facets=facets, intorder=12)
        force += LinearForm(lambda v, w: 2 * np.pi * w.x[0] * dot(traction(w.x), v)).assemble(side)
    free = np.setdiff1d(np.arange(basis.N), basis.get_dofs(lambda x: x[0] < 1e-9).all("u^1"))
    # Two points an edge: more would over-constrain it, and the pressure oscillate.
    below = (0.5 if scene["case"] == "sphere" else 1e-9) * scene["radius"]
    candidates = facets_on(mesh, lambda p: p[1] < below, scene["stretch"] * a)
    contact = FacetBasis(mesh, ELEMENT, facets=candidates, intorder=3)
    place, ny = contact.global_coordinates().value[0], np.abs(contact.normals.value[1])
    area, spring = 2 * np.pi * place * ny, KAPPA * modulus / a
    gap = scene["radius"] - np.sqrt(scene["radius"] ** 2 - place**2) if scene["case"] == "sphere" else place**2 / (2 * scene["radius"])
    active = place < 1.5 * a  # well beyond the contact, which is not known
    for _ in range(STEPS):
        weight = spring * active * area
        tangent = BilinearForm(lambda u, v, w: weight * u[1] * v[1]).assemble(contact)
        push = LinearForm(lambda v, w: -weight * gap * v[1]).assemble(contact)
        u = np.zeros(basis.N)
        u[free] = splu((stiffness + tangent)[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A").solve((force + push)[free])
        pressure = spring * (-contact.interpolate(u)[1] - gap)
        if ((pressure > 0) == active).all():
            answer = measures(place, area * contact.dx, np.maximum(pressure, 0), scene["stations"])
            # Mean over the last loaded side, the cut or the far face.
            r, weight = side.global_coordinates().value[0], side.dx
            fallen = -(r * weight * side.interpolate(u)[1]).sum() / (r * weight).sum()
            return {**answer, "approach": float(fallen), "dofs": len(free)}
        active = pressure > 0
    raise RuntimeError(f"{scene['case']}: the active set still changes after {STEPS} iterations; start nearer to the contact")


def hertz(scene):
    """Contact radius [mm], E* [MPa] and load F = 4E*a^3/3R [N]."""
    a, modulus = scene["a_over_r"] * scene["radius"], scene["young"] / (1 - scene["poisson"] ** 2)
    return a, modulus, 4 * modulus * a**3 / (3 * scene["radius"])


def growing(start, end, first):
    """Ticks whose distances grow from `first`, stretched to end where they shall."""
    count = max(1, int(np.ceil(np.log1p((end - start) * (GROWTH - 1) / first) / np.log(GROWTH))))
    sums = np.concatenate([[0], np.cumsum(first * GROWTH ** np.arange(count))])
    return start + (end - start) * sums / sums[-1]


def refined(ticks, level):
    """Ticks with every distance halved so many times."""
    return np.interp(np.arange((len(ticks) - 1) * 2**level + 1) / 2**level, np.arange(len(ticks)), ticks)


def near(scene):
    """Ticks along the candidates."""
    return np.linspace(0, scene["stretch"] * scene["a_over_r"] * scene["radius"], round(ELEMENTS * scene["stretch"]) + 1)


def facets_on(mesh, holds, limit=np.inf):
    """Facets of the boundary whose ends lie where it holds, off the axis, up to a radius."""
    ends = mesh.p[:, mesh.facets[:, mesh.boundary_facets()]]
    return mesh.boundary_facets()[holds(ends).all(axis=0) & (ends[0].max(axis=0) > 1e-9) & (ends[0] <= limit * (1 + 1e-9)).all(axis=0)]


def truncated(scene, level, load):
    """A block above z = 0, and the tractions of the half-space on its sides."""
    a, x = scene["a_over_r"] * scene["radius"], near(scene)
    side, p0 = scene["size"] * a, 1.5 * load / (np.pi * a**2)
    r = refined(np.concatenate([x, growing(x[-1], side, GROWTH * x[1])[1:]]), level)
    mesh = MeshQuad2.from_mesh(MeshQuad.init_tensor(r, refined(growing(0, side, x[1]), level)))

    def stress(x):
        return huber(x[0] / a, x[1] / a, scene["poisson"]) * p0

    right, top = facets_on(mesh, lambda p: p[0] > side - 1e-9), facets_on(mesh, lambda p: p[1] > side - 1e-9)
    return mesh, [(right, lambda x: stress(x)[[0, 2]]), (top, lambda x: stress(x)[[2, 1]])]


def huber(r, z, poisson):
    """(sigma_r, sigma_z, tau_rz)/p0 below Hertz's pressure, a = 1 (Huber 1904; Fischer-Cripps, Contact Mechanics, 2007, eq. 5.4)."""
    difference = r**2 + z**2 - 1
    u = 0.5 * (difference + np.sqrt(difference**2 + 4 * z**2))
    root, below = np.sqrt(u), u**2 + z**2
    part, turn = z / root, np.arctan(1 / root)
    radial = (1 - 2 * poisson) / (3 * r**2) * (1 - part**3) + part**3 * u / below
    radial += part * (u * (1 - poisson) / (1 + u) + (1 + poisson) * root * turn - 2)
    return np.array([radial, -(part**3) * u / below, -r * z**2 * root / (below * (1 + u))])


def sphere(scene, level, load):
    """The lower half of a sphere about (0, R), rings round a square, and the uniform load on its cut."""
    radius, x = scene["radius"], near(scene)
    lower = np.arcsin(x / radius)
    lower = np.concatenate([lower, growing(lower[-1], np.pi / 4, GROWTH * lower[1])[1:]])
    angles = refined(np.concatenate([lower, np.linspace(np.pi / 4, np.pi / 2, 5)[1:]]), level)
    depth = refined(growing(0, 1, x[1] / ((1 - CORE) * radius)), level)
    share = angles / (np.pi / 4)
    rim = CORE * radius * np.array([np.minimum(share, 1), np.maximum(share - 2, -1)])
    arc = radius * np.array([np.sin(angles), -np.cos(angles)])
    rings = arc[:, :, None] * (1 - depth) + rim[:, :, None] * depth
    square = np.array(np.meshgrid(rim[0, share <= 1 + 1e-9], rim[1, share >= 1 - 1e-9], indexing="ij"))
    mesh = joined([rings, square])
    places = mesh.doflocs.copy()
    outer = np.flatnonzero(np.isclose(np.hypot(*mesh.p[:, mesh.facets]), radius, rtol=1e-9).all(axis=0))
    middle = places[:, mesh.nvertices + outer]
    places[:, mesh.nvertices + outer] = radius * middle / np.hypot(*middle)
    mesh = MeshQuad2(places + [[0], [radius]], mesh.t)
    cut = facets_on(mesh, lambda p: p[1] > radius - 1e-9)
    return mesh, [(cut, lambda x: np.stack([0 * x[0], 0 * x[0] - load / (np.pi * radius**2)]))]


def joined(grids):
    """Mesh of grids of places, what coincides being one node."""
    meshes = []
    for grid in grids:
        number = np.arange(grid[0].size).reshape(grid[0].shape)
        cells = np.array([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]).reshape(4, -1)
        meshes.append(MeshQuad(grid.reshape(2, -1), cells))
    return MeshQuad2.from_mesh(meshes[0] + meshes[1])


MESHES = {"sphere": sphere, "truncated-sphere": truncated}


def measures(place, area, pressure, stations):
    """The quantities that are asked for; the contact radius by second moment, a^2 = 5/2 of the mean of r^2 below Hertz's pressure."""
    if pressure[place >= place.max() - 1e-12].max() > 0:
        raise RuntimeError("the contact reaches its last candidate; lengthen the stretch")
    force = area * pressure
    radius = np.sqrt(2.5 * (force * place**2).sum() / force.sum())
    # Value at 0 of the even sextic whose means are nearest to those of the pressure, edge by edge on the inner half.
    weight = area.sum(axis=1)
    inner = place.mean(axis=1) < 0.5 * radius
    terms = np.array([((area * (place / radius) ** k).sum(axis=1) / weight)[inner] for k in (0, 2, 4, 6)]).T
    peak = np.linalg.lstsq(terms, (force.sum(axis=1) / weight)[inner], rcond=None)[0][0]
    order = np.argsort(place.ravel())
    fine = np.asarray(stations)[:, None] + (stations[1] - stations[0]) * (np.arange(200) - 99.5) / 200
    pressures = np.interp(fine, place.ravel()[order], pressure.ravel()[order]).mean(axis=1)
    return {"half_width": float(radius), "peak": float(peak), "resultant": float(force.sum()), "pressure": pressures}
