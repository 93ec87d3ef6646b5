"""Displacements of discs, holes and other outlines under forces on an arc, by the potentials of Kolosov and Muskhelishvili.

2 mu (u + iv) = kappa phi - z conj(phi') - conj(psi), and along a boundary with the body on its left f = phi + z conj(phi') + conj(psi) is
i int (X + iY) ds (N. I. Muskhelishvili, Some basic problems of the mathematical theory of elasticity, sections 32, 41, 80 to 82). There
2 mu (u + iv) = (kappa + 1) phi - f: where tractions are known, phi alone is sought. Scenes are symmetric about x = 0; log(iz) has its cut above.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/high/freeze.py, which imports this module")

import numpy as np


class Arc:
    """Pressures p = sqrt(1 - xi^2) times a polynomial by their values at the zeros xi = cos(k pi/(n + 1)) of the Chebyshev polynomial U_n."""

    def __init__(self, n):
        at, between = np.arange(1, n + 1) * np.pi / (n + 1), (np.arange(n + 1) + 0.5) * np.pi / (n + 1)
        self.order = np.arange(1, n + 1)
        self.node, self.place = np.cos(at), np.cos(between)  # where pressures are sought, and where gaps are closed
        self.series = 2 / (n + 1) * np.sin(np.outer(self.order, at))  # p(cos a) = sum of b_m sin(m a) with b = series @ p
        self.weight = np.pi / (n + 1) * np.sin(at)  # of int p dxi
        logs = [-np.pi * np.log(2) + 0 * between] + [-np.pi / m * np.cos(m * between) for m in range(1, n + 2)]
        sums = [np.pi - between] + [-np.sin(m * between) / m for m in range(1, n + 2)]
        self.log = self.by_pressures(logs)  # of int p log|place - xi| dxi
        self.below = self.by_pressures(sums)  # of int p dxi from -1 to the place

    def by_pressures(self, of_cosines):
        """Weights of int sin(m a) K sin(a) da = int (cos (m-1)a - cos (m+1)a) K da / 2, by those of int cos(m a) K da."""
        return 0.5 * (np.array(of_cosines[:-2]) - np.array(of_cosines[2:])).T @ self.series


class Forced:
    """Forces p times `force` d(xi) on an arc at the bottom of a circle about the origin: their nodes t, and places z between these."""

    def __init__(self, arc, kappa, node, place, force):
        self.arc, self.kappa, self.t, self.z, self.force = arc, kappa, node, place, force
        self.radius, self.q = np.abs(node[0]), arc.weight * force

    def logs(self, sign):
        """int log(1 - z/t) dq at the places, or of t/z where the sign is -1: 1 - exp(ia) = 2 |sin(a/2)| exp(i(a - pi sgn a)/2)."""
        turn = np.angle(1j * self.z)[:, None] - np.angle(1j * self.t)
        near = np.log(np.abs(2 * np.sin(turn / 2) / (self.arc.place[:, None] - self.arc.node))) + 0.5j * sign * turn
        side = 2 * self.arc.below - self.arc.weight  # of int p sgn(place - xi) dxi
        return (self.arc.log + self.arc.weight * near - 0.5j * np.pi * sign * side) * self.force

    def passed(self):
        """i int dq from the middle of the forces to the places."""
        return 1j * (self.arc.below - 0.5 * self.arc.weight) * self.force


class Disc(Forced):
    """A disc under the forces, and either their mirror image at its top (then its middle is at rest) or their reaction at its centre."""

    mirrored = True

    def stretch(self):
        """phi'(0): half of int dq/t / 2 pi, a real number."""
        return (self.q / self.t).real / (4 * np.pi) * (2 if self.mirrored else 1)

    def moved(self):
        """2 mu (u + iv) at the places by each pressure."""
        z, t = self.z[:, None], self.t
        phi = -self.logs(1) / (2 * np.pi) - z * self.stretch()
        if self.mirrored:
            return (self.kappa + 1) * (phi - np.log(1 - z / t.conj()) * self.q.conj() / (2 * np.pi)) - self.passed()
        lead = 1 / (2 * np.pi * (1 + self.kappa))  # Kelvin's solution of -q at the centre, and what frees the rim of its tractions
        return (self.kappa + 1) * (phi + lead * (self.q * np.log(1j * z) - self.q.conj() * z**2 / self.radius**2)) - self.passed()

    def potentials(self, z):
        """phi, phi' and psi, but for a constant, of mirrored forces at points inside."""
        both = [(self.t, self.q), (self.t.conj(), self.q.conj())]
        phi = -z * self.stretch() - sum(q * np.log(1 - z / t) for t, q in both) / (2 * np.pi)
        slope = -self.stretch() + sum(q / (t - z) for t, q in both) / (2 * np.pi)
        psi = sum(q.conj() * np.log(1 - z / t) for t, q in both) / (2 * np.pi)
        return phi, slope, psi - self.radius**2 * (slope - self.stretch()) / z


class Hole(Forced):
    """A circular hole in an infinite plate under the forces."""

    def moved(self):
        """2 mu (u + iv) at the places by each pressure."""
        lead, rim = -self.q * np.log(1j * self.z[:, None]) / (2 * np.pi * (1 + self.kappa)), np.full((1, 1), self.radius + 0j)
        constant = symmetric(force(rim, *self.potentials(rim)) + 0.5j * self.q)  # of f, from a point away from the forces
        return (self.kappa + 1) * (lead - self.logs(-1) / (2 * np.pi)) + self.passed() - constant

    def potentials(self, z):
        """phi, phi' and psi at points of the plate."""
        lead, far, near = 1 / (2 * np.pi * (1 + self.kappa)), np.log(1j * z), np.log(1 - self.t / z) / (2 * np.pi)
        phi = -self.q * (lead * far + near)
        slope = -self.q * (lead / z + (1 / (z - self.t) - 1 / z) / (2 * np.pi))
        return phi, slope, self.q.conj() * (self.kappa * lead * far + near) - self.radius**2 * slope / z


def force(z, phi, slope, psi):
    """f, the force that a boundary has passed on."""
    return phi + z * slope.conj() + psi.conj()


def moved(kappa, z, phi, slope, psi):
    """2 mu (u + iv)."""
    return kappa * phi - z * slope.conj() - psi.conj()


def symmetric(by_pressure):
    """By each pressure and its mirror image, half of it each."""
    return 0.5 * (by_pressure + by_pressure[:, ::-1])


class Regular:
    """Potentials with real coefficients, those of phi before those of psi: symmetric powers of z, and poles that crowd towards a corner from
    outside the body (A. Gopal and L. N. Trefethen, SIAM J. Numer. Anal. 57, 2019)."""

    def __init__(self, kappa, powers, corner=0j, outward=1.0, poles=0):
        """Powers by (number, length, centre); a corner, and the vector from it to its farthest pole."""
        self.kappa, self.powers = kappa, powers
        self.poles = corner + outward * np.exp(4 * (np.sqrt(np.arange(1, poles + 1)) - np.sqrt(poles)))
        self.reach = np.abs(self.poles - corner)

    def functions(self, z):
        """The functions g(-conj z) = -conj(g(z)), a column each, and their derivatives."""
        value, slope = [], []
        for n, length, centre in self.powers:
            unit, y = 1 if n % 2 else 1j, (z - centre) / length
            value.append(unit * y**n)
            slope.append(unit * n / length * y ** (n - 1) if n else 0 * z)
        for pole, reach in zip(self.poles, self.reach):
            for unit in (1, 1j):
                images = [(unit, pole), (np.conj(unit), -np.conj(pole))]
                value.append(sum(reach * own / (z - at) for own, at in images))
                slope.append(sum(-reach * own / (z - at) ** 2 for own, at in images))
        return np.hstack(value), np.hstack(slope)

    def sides(self, z):
        """f and 2 mu (u + iv) at points, by each coefficient."""
        value, slope = self.functions(z)
        of_phi, of_psi = (value, slope, 0 * value), (0 * value, 0 * value, value)
        return [np.hstack([of(z, *of_phi), of(z, *of_psi)]) for of in (force, lambda *all: moved(self.kappa, *all))]


def least_squares(rows):
    """Solves rows @ coefficients = right for any right sides, by singular values, the smallest left out."""
    scale = np.linalg.norm(rows, axis=0)
    u, s, vt = np.linalg.svd(rows / scale, full_matrices=False)
    kept = s > 1e-14 * s[0]
    return lambda right: vt[kept].T @ ((u[:, kept].T @ right) / s[kept, None]) / scale[:, None]
