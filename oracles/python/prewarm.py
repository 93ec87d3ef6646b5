"""Compiles every form of the dolfinx oracles once and says what is installed; run by the set-up script."""
import argparse
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1] / "dolfinx"))

import environment


def main(installed):
    environment.prepare(installed)
    import numpy as np

    import discrete_dolfinx
    import ufl_penalty

    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0], [1, 0.5], [0.5, 1], [0, 0.5]])
    one_cell = {
        "body": np.array([0]),
        "young": np.array([1.0]),
        "poisson": np.array([0.3]),
        "plane": "strain",
        "thickness": 1.0,
        "load_edges": np.array([[2, 3]]),
        "traction": np.array([0.0, 1.0]),
        "length": 1.0,
        "radius": 1.0,
    }
    for nodes in (4, 8):
        for load in (False, True):
            mesh = {"points": square[:nodes], "cells": np.arange(nodes)[None], "hertz_load": load}
            discrete_dolfinx.assembled(one_cell | mesh)
    hertz = {"radius": 1.0, "young": 1.0, "poisson": 0.3, "a_over_r": 0.05, "stretch": 1.6, "size": 8.0, "stations": [0.01, 0.03]}
    for case in ufl_penalty.fan.MESHES:
        ufl_penalty.solve(hertz | {"case": case}, 0)
    print("oracles:", ", ".join(f"{name} {version}" for name, version in environment.versions().items()))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("installed", help="folder that oracles/setup.sh has filled")
    try:
        main(parser.parse_args().installed)
    except ModuleNotFoundError as missing:
        sys.exit(f"module `{missing.name}` is missing in {sys.executable}: run oracles/setup.sh on Debian 12")
