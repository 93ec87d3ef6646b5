"""Closed forms the oracles need: moduli, gaps, the Hertz load and the stress under it. Units mm, N, MPa."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import numpy as np


def lame(young, poisson, plane):
    """(lambda, mu) [MPa] of sigma = lambda tr(eps) I + 2 mu eps in the plane; "strain" or "stress".

    mu = E/2(1+nu) and lambda = E nu/((1+nu)(1-2nu)); plane stress takes 2 lambda mu/(lambda + 2 mu) for lambda.
    """
    shear = young / (2.0 * (1.0 + poisson))
    bulk = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    return (2.0 * bulk * shear / (bulk + 2.0 * shear) if plane == "stress" else bulk), shear


def plane_modulus(young, poisson, plane):
    """E/(1 - nu^2) in plane strain, E in plane stress [MPa]."""
    return young / (1.0 - poisson**2) if plane == "strain" else young


def contact_modulus(moduli):
    """E*: 1/E* = sum 1/E' over the plane moduli of the elastic sides [MPa]."""
    return 1.0 / sum(1.0 / modulus for modulus in moduli)


def hertz_load(half_width, modulus, radius):
    """Full load per thickness P = pi a^2 E*/4R [N/mm]."""
    return np.pi * half_width**2 * modulus / (4.0 * radius)


def circle_gap(x, radius):
    """g = R - sqrt(R^2 - x^2) [mm], written without cancellation."""
    return x**2 / (radius + np.sqrt(radius**2 - x**2))


def parabola_gap(x, radius):
    """g = x^2/2R [mm]."""
    return x**2 / (2.0 * radius)


def hole_gap(angle, radius, clearance):
    """Gap along the pin's radius [mm], pin centre at the origin, the hole's a clearance c above it:
    g = rho - c cos - R with rho = sqrt((R + c)^2 - c^2 sin^2), written without cancellation as
    (rho^2 - (R + c cos)^2)/(rho + R + c cos), the numerator being 2 R c (1 - cos).
    """
    far = np.sqrt((radius + clearance) ** 2 - (clearance * np.sin(angle)) ** 2)
    return 4.0 * radius * clearance * np.sin(0.5 * angle) ** 2 / (far + radius + clearance * np.cos(angle))


def hertz_stress(x, depth, half_width, pressure):
    """Stresses (sigma_x, sigma_depth, tau) [MPa] below the Hertz pressure p0 sqrt(1 - x^2/a^2), tension > 0.

    Westergaard's form for a straight boundary without shear; zeta = x + i y, x >= 0, y the depth:
        s = sqrt(zeta^2 - a^2),  Z = -i p0 a/(zeta + s),  Z' = i p0 a/((zeta + s) s),
        sigma_x = Re Z - y Im Z',  sigma_y = Re Z + y Im Z',  tau = -y Re Z'.
    Z' is factored out and s - i y = x - a^2/(zeta + s) used, so that nothing cancels far away.
    """
    zeta = x + 1j * depth
    root = np.sqrt((x - half_width) * (x + half_width) - depth**2 + 2j * x * depth)
    slope = 1j * pressure * half_width / ((zeta + root) * root)
    shifted = x - half_width**2 / (zeta + root)
    across = -(slope * shifted).real
    down = -(slope * (shifted + 2j * depth)).real
    return across, down, -depth * slope.real
