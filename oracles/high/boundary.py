"""Contacts of a cylinder and of pins by the boundary way in numpy alone: no elements; a pressure that is a root times a polynomial.

The end of the contact is sought until pressures that vanish there as a root, and close the gap up to it, carry the load. Discs and holes
are closed forms in the pressure (potentials.py); what else bounds a body is met by regular potentials in least squares. Units mm, N, MPa, rad.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/high/freeze.py, which imports this module")

import numpy as np

from potentials import Arc, Disc, Hole, Regular, force, least_squares, moved, symmetric

STEPS, SAME = 30, 1e-10  # of the secant: most steps, and a change of the end over the end


class Cylinder:
    """The lower half of a disc on a rigid plane; its cut stays flat (between two plates) or takes the load evenly. Coordinate and normal
    are those of the plane, and pressures are per its length."""

    def __init__(self, numbers, n, flat):
        self.arc, self.flat, self.radius = Arc(n), flat, numbers["radius"]
        nu, self.guess = numbers["poisson"], numbers["a_over_r"] * self.radius
        self.kappa, self.shear = 3 - 4 * nu, numbers["young"] / (2 * (1 + nu))
        self.load = np.pi * self.guess**2 * numbers["young"] / (1 - nu**2) / (4 * self.radius)  # Hertz's for the guess
        if not flat:
            s = np.linspace(0, 1, 4 * n + 200)
            s = np.unique([s, 1 - np.exp(-14 * s)])[:, None]  # from the middle, more and more towards the corner
            self.cut = self.radius * s[1:] + 0j
            powers, outward = [(k, self.radius, 0) for k in range(n + 10)], self.radius * np.exp(0.25j * np.pi)
            self.regular = Regular(self.kappa, powers, self.radius + 0j, outward, n // 2)
            free, cut = (self.regular.sides(z)[0] for z in (-1j * self.radius * np.exp(0.5j * np.pi * s), self.cut))
            self.rows = len(s)
            self.solved = least_squares(np.vstack([free.real, free.imag, cut.real, cut.imag]))

    def pressed(self, end):
        """Pressures up to an end, and how far the cut has come down."""
        x, at = end * self.arc.node, end * self.arc.place
        drop = [np.sqrt(self.radius**2 - s**2) for s in (x, at)]
        disc = Disc(self.arc, self.kappa, x - 1j * drop[0], at - 1j * drop[1], 1j * end + 0 * x)
        down, of_cut = -disc.moved().imag / (2 * self.shear), np.zeros_like(x)
        if not self.flat:
            up, of_cut = self.evenly(disc)
            down = down - up
        *pressure, approach = np.linalg.solve(np.column_stack([down, 1 + 0 * at]), self.radius - drop[1])
        return np.array(pressure), approach + of_cut @ pressure

    def evenly(self, disc):
        """What it adds that the load is even on the cut: to upward displacements at the places, and to the mean downward one of the cut."""
        evenly = symmetric(-disc.q.imag / (2 * self.radius) * self.cut.real)
        there = evenly - symmetric(force(self.cut, *disc.potentials(self.cut))).real
        none = np.zeros_like(there)
        found = self.solved(np.vstack([np.zeros((2 * self.rows, there.shape[1])), there, none])) / (2 * self.shear)
        x, w = np.polynomial.legendre.leggauss(60)
        mean = 0.5 * w @ self.regular.sides(0.5 * self.radius * (1 + x)[:, None] + 0j)[1].imag @ found
        return self.regular.sides(disc.z[:, None])[1].imag @ found, -mean

    def carried(self, end, pressure):
        """The load."""
        return end * self.arc.weight @ pressure


class Pin:
    """A pin in a hole; its middle is at rest, or it is pushed at its centre. Coordinate, normal and area are those of the pin."""

    def __init__(self, numbers, n, other, mirrored):
        self.arc, self.other, self.mirrored, self.guess = Arc(n), other, mirrored, np.pi / 3
        self.radius, self.clearance, self.load = numbers["pin_radius"], numbers["clearance"], numbers["force"] / numbers["thickness"]
        self.kappa, self.shear = plane_stress(numbers["pin_young" if mirrored else "young"], numbers["pin_poisson" if mirrored else "poisson"])

    def pressed(self, end):
        """Pressures up to an end, and how far the bodies have come nearer."""
        angles, c, big = [end * self.arc.node, end * self.arc.place], self.clearance, self.radius + self.clearance
        ray = [-1j * np.exp(1j * s) for s in angles]
        reach = [np.sqrt(big**2 - (c * np.sin(s)) ** 2) - c * np.cos(s) for s in angles]  # to the hole, from the centre of the pin
        pin = Disc(self.arc, self.kappa, self.radius * ray[0], self.radius * ray[1], -end * self.radius * ray[0])
        pin.mirrored = self.mirrored
        hole = Hole(self.arc, self.other.kappa, *(r * e - 1j * c for r, e in zip(reach, ray)), end * self.radius * ray[0])
        apart = pin.moved() / (2 * self.shear) - (hole.moved() + self.other.adds(hole)) / (2 * self.other.shear)
        rows = np.column_stack([(apart * ray[1].conj()[:, None]).real, np.cos(angles[1])])
        *pressure, approach = np.linalg.solve(rows, reach[1] - self.radius)
        return np.array(pressure), approach

    def carried(self, end, pressure):
        """The load."""
        return end * self.radius * (self.arc.weight * np.cos(end * self.arc.node)) @ pressure


def plane_stress(young, nu):
    """kappa and shear modulus."""
    return (3 - nu) / (1 + nu), young / (2 * (1 + nu))


class Plate:
    """A plate about the hole up to a fixed rim."""

    def __init__(self, numbers, _):
        self.kappa, self.shear = plane_stress(numbers["young"], numbers["poisson"])
        hole, right = numbers["pin_radius"] + numbers["clearance"], np.exp(1j * np.linspace(-np.pi / 2, np.pi / 2, 60))[:, None]
        self.rim = numbers["rim_radius"] * right
        self.regular = Regular(self.kappa, [(k, numbers["rim_radius"], 0) for k in range(6)] + [(-k, hole, 0) for k in range(1, 6)])
        free, fixed = self.regular.sides(hole * right)[0], self.regular.sides(self.rim)[1]
        self.solved = least_squares(np.vstack([free.real, free.imag, fixed.real, fixed.imag]))

    def adds(self, hole):
        """What the rim adds to 2 mu (u + iv) at the places of the hole."""
        there = -symmetric(moved(self.kappa, self.rim, *hole.potentials(self.rim)))
        right = np.vstack([0 * there.real, 0 * there.real, there.real, there.imag])
        return self.regular.sides(hole.z[:, None])[1] @ self.solved(right)


class Rod:
    """An eye about the hole and a shank above it with a flat end, from which displacements are counted; both have potentials of their own, which
    meet where the eye's circle crosses the shank. f is i c on all of the outer boundary; c is the last unknown."""

    def __init__(self, numbers, n):
        self.kappa, self.shear = plane_stress(numbers["rod_young"], numbers["rod_poisson"])
        hole, big = numbers["pin_radius"] + numbers["clearance"], numbers["eye_outer_radius"]
        half, top = numbers["shank_width"] / 2, numbers["shank_end"]
        notch = half + 1j * np.sqrt(big**2 - half**2)
        from_centre = np.angle(notch)
        corner = notch, half * np.exp(1j * (from_centre - np.pi / 6)), 3 * n // 2  # halfway between the circle's and the shank's outside
        eye = Regular(self.kappa, [(k, big, 0) for k in range(n)] + [(-k, hole, 0) for k in range(1, n)], *corner)
        shank = Regular(self.kappa, [(k, 0.6 * (top - notch.imag), 0.5j * (top + notch.imag)) for k in range(3 * n // 4)], *corner)
        s = np.linspace(0, 1, 6 * n)
        s = np.unique([s, 1 - np.exp(-30 * s)])[:, None]
        rim, joint = (big * np.exp(1j * (away + (from_centre - away) * s)) for away in (-np.pi / 2, np.pi / 2))
        side, end = half + 1j * (top + (notch.imag - top) * s), half * np.linspace(0, 1, 3 * n)[:, None] + 1j * top
        free = hole * np.exp(1j * np.linspace(-np.pi / 2, np.pi / 2, 4 * n))[:, None]
        none_e, none_s = np.zeros((1, eye.sides(free)[0].shape[1])), np.zeros((1, shank.sides(end)[0].shape[1]))
        self.eye, self.outline, self.size, rows = eye, (rim, side, end), none_e.size, []

        def conditions(of_eye, of_shank, of_constant, parts=("real", "imag")):
            for part in parts:
                first, second = getattr(of_eye, part), getattr(of_shank, part)
                count = max(len(first), len(second))
                filled = [np.broadcast_to(block, (count, block.shape[1])) for block in (first, second)]
                rows.append(np.hstack([*filled, np.full((count, 1), of_constant if part == "imag" else 0)]))

        conditions(eye.sides(rim)[0], none_s, -1)
        conditions(none_e, shank.sides(side)[0], -1)
        conditions(none_e, shank.sides(end)[0], -1, ["imag"])
        conditions(none_e, shank.sides(end)[1], 0, ["imag"])
        conditions(eye.sides(free)[0], none_s, 0)
        for own, other in zip(eye.sides(joint), shank.sides(joint)):
            conditions(own, -other, 0)
        self.rows = sum(map(len, rows))
        self.solved = least_squares(np.vstack(rows))

    def adds(self, hole):
        """What the outer boundary adds to 2 mu (u + iv) at the places of the hole."""
        *free, end = (symmetric(force(z, *hole.potentials(z))) for z in self.outline)
        level = symmetric(moved(self.kappa, self.outline[2], *hole.potentials(self.outline[2])))
        right = np.vstack([part for f in free for part in (f.real, f.imag)] + [end.imag, level.imag])
        right = np.vstack([-right, np.zeros((self.rows - len(right), right.shape[1]))])
        return self.eye.sides(hole.z[:, None])[1] @ self.solved(right)[: self.size]


def solve(scene, n):
    """The numbers of a scene with n pressures."""
    numbers, case = scene["numbers"], scene["case"]
    if case.startswith("cylinder"):
        contact = Cylinder(numbers, n, flat=case == "cylinder-between-plates")
    else:
        contact = Pin(numbers, n, (Plate if case == "pin-plate" else Rod)(numbers, n), mirrored=case == "pin-rod")
    ends, missing = [], []
    for step in range(STEPS):
        end = contact.guess * (1 + 1e-3 * step) if step < 2 else ends[-1] - missing[-1] * (ends[-1] - ends[-2]) / (missing[-1] - missing[-2])
        pressure, approach = contact.pressed(end)
        ends, missing = ends + [end], missing + [contact.carried(end, pressure) - contact.load]
        if step > 1 and abs(ends[-1] - ends[-2]) <= SAME * end:
            return measures(contact, end, pressure, approach)
    raise RuntimeError(f"the end of the contact still moves after {STEPS} steps: {ends[-2:]}")


def measures(contact, end, pressure, approach):
    """The numbers of a contact up to an end."""
    arc, series = contact.arc, contact.arc.series @ pressure
    at = lambda a: np.sin(np.outer(a, arc.order)) @ series
    angles = np.linspace(0, np.pi / 2, 4001)[1:]
    top = angles[np.argmax(at(angles))]
    for _ in range(6 if top < angles[-1] else 0):  # Newton's method for p' = 0
        first, second = (arc.order * series) @ np.cos(arc.order * top), -(arc.order**2 * series) @ np.sin(arc.order * top)
        top -= first / second
    middle, peak = at([np.pi / 2, top])
    second = arc.weight @ (pressure * (end * arc.node) ** 2) / (arc.weight @ pressure)
    found = {"pressure at s = 0": middle, "peak-pressure": peak, "second-moment-width": 2 * np.sqrt(second), "end": end}
    if not isinstance(contact, Pin) or contact.mirrored:  # else a force acts where the approach would be read
        found["approach"] = approach
    if top < angles[-1]:
        found["peak-place"] = end * np.cos(top)
    if isinstance(contact, Pin):
        x, w = (np.pi / 4 * own for own in np.polynomial.legendre.leggauss(100))
        a = np.pi / 4 + x
        found["force across the load, of one half"] = contact.radius * end * (w * np.sin(a) * at(a)) @ np.sin(end * np.cos(a))
    if at(angles).min() < 0:
        raise RuntimeError(f"a pressure of {at(angles).min()}: not a contact")
    return {name: float(value) for name, value in found.items()}
