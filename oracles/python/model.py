"""What a scene is to the solver: bodies, supports, loads and contact at one level of refinement."""

from dataclasses import dataclass, field

import numpy as np

from contact import Pair
from triangles import Mesh


@dataclass
class Body:
    """A mesh and its plane stiffness."""

    mesh: Mesh
    plane_matrix: np.ndarray


@dataclass
class Model:
    """A scene at one level; freedoms are 2 node + component, the second body's after the first's."""

    bodies: list
    pair: Pair
    contact_modulus: float  # [MPa]
    length: float  # of the scene, turns k_n into kappa [mm]
    start: float  # coordinate below which the iteration starts closed
    force: np.ndarray  # nodal forces [N]
    fixed: np.ndarray  # freedoms held at zero
    tied: np.ndarray  # freedoms that move as one
    tractions: list = field(default_factory=list)  # (boundary of the first body, traction of points)
