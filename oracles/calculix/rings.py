"""Pins and the bodies round them as rings of 8-node quadrilaterals and 6-node triangles, numbered for CalculiX from 1."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np


class Mesh:
    """Nodes [mm] and elements by type; places that coincide are one node."""

    def __init__(self):
        self.number, self.nodes, self.elements = {}, [], []

    def node(self, x, y):
        """Number of the node at a place, from 1."""
        key = (round(x * 1e8), round(y * 1e8))
        if key not in self.number:
            self.nodes.append((x, y))
            self.number[key] = len(self.nodes)
        return self.number[key]

    def ring(self, angles, shares, at):
        """Quadrilaterals between angles and shares (0 inside, 1 outside); `at(angle, share)` is (x, y)."""
        for a, c in zip(angles[:-1], angles[1:]):
            for s, u in zip(shares[:-1], shares[1:]):
                b, t = 0.5 * (a + c), 0.5 * (s + u)
                eight = [(a, s), (a, u), (c, u), (c, s), (a, t), (b, u), (c, t), (b, s)]
                self.elements.append(("CPS8", [self.node(*at(*place)) for place in eight]))

    def centre(self, angles, radius):
        """Triangles from the origin to a circle."""
        for a, c in zip(angles[:-1], angles[1:]):
            six = [(0, a), (1, a), (1, c), (0.5, a), (1, 0.5 * (a + c)), (0.5, c)]
            self.elements.append(("CPS6", [self.node(*around(share * radius, angle)) for share, angle in six]))

    def where(self, holds):
        """Numbers of the nodes at which it holds."""
        return [number for number, place in enumerate(self.nodes, 1) if holds(*place)]


def around(away, angle, up=0.0):
    """Place at a distance from (0, up) and an angle from the downward vertical [rad]."""
    return away * np.sin(angle), up - away * np.cos(angle)


def spread(count, ratio):
    """Shares of `count` sizes that grow to `ratio` times the first."""
    sizes = ratio ** np.linspace(0.0, 1.0, count)
    return np.concatenate([[0.0], np.cumsum(sizes)]) / sizes.sum()


def pin(scene, per_right_angle, right_angles):
    """Sector of a disc about the origin."""
    mesh, radius, core = Mesh(), scene["pin_radius"], 0.2 * scene["pin_radius"]
    angles = np.linspace(0.0, right_angles * np.pi / 2, right_angles * per_right_angle + 1)
    layers = 1 - spread(per_right_angle, 5.0)[::-1]
    mesh.ring(angles, layers, lambda angle, share: around(core + share * (radius - core), angle))
    mesh.centre(angles, core)
    return mesh


def hole_at(scene, angle):
    """Distance from the pin's centre to the hole along a ray, the hole's centre a clearance above."""
    up = scene["clearance"]
    return -up * np.cos(angle) + np.sqrt((scene["pin_radius"] + up) ** 2 - (up * np.sin(angle)) ** 2)


def round_hole(scene, mesh, angles, shares, outer):
    """Ring between the hole, its nodes on rays from the pin's centre, and a circle about the hole's centre."""

    def at(angle, share):
        inside, outside = around(hole_at(scene, angle), angle), around(outer, angle, scene["clearance"])
        return tuple(i + share * (o - i) for i, o in zip(inside, outside))

    mesh.ring(angles, shares, at)


def rod(scene, count):
    """Half an eye and its shank."""
    mesh, outer, up = Mesh(), scene["eye_outer_radius"], scene["clearance"]
    corner = np.pi - np.arcsin(0.5 * scene["shank_width"] / outer)
    middle, upper = (np.linspace(*ends, 1 + 2 * count // 3) for ends in ((np.pi / 2, corner), (corner, np.pi)))
    right = np.linspace(0.0, np.pi / 2, count + 1)
    round_hole(scene, mesh, np.concatenate([right, middle[1:], upper[1:]]), spread(count, 1.0), outer)

    def shank(angle, share):
        x, y = around(outer, angle, up)
        return x, y + share * (up + scene["shank_end"] - y)

    mesh.ring(upper, spread(count, 8.0), shank)
    return mesh


def plate(scene, count):
    """Half a plate with a round rim."""
    mesh, rim = Mesh(), scene["rim_radius"]
    hole = scene["pin_radius"] + scene["clearance"]
    layers = 2 * count
    shares = np.expm1(np.linspace(0.0, np.log(rim / hole), layers + 1)) / (rim / hole - 1.0)
    round_hole(scene, mesh, np.linspace(0.0, np.pi, 2 * count + 1), shares, rim)
    return mesh
