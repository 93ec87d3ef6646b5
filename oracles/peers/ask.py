"""A refinement series of a scene by a script of its own folder: ask.py FOLDER MODULE METHOD LEVELS < scene; prints one JSON object.

The scene is a JSON object: case, numbers by name, stations. Printed: version of the code, series coarse to fine.
"""

import importlib
import json
import sys

import common  # first: one thread

try:
    import numpy as np

    sys.path.insert(0, sys.argv[1])
    script = importlib.import_module(sys.argv[2])
except ModuleNotFoundError as absent:
    common.missing(f"module {absent.name}")


def main(method, levels):
    """Answers on every mesh."""
    try:
        version = script.version()
    except FileNotFoundError as absent:
        common.missing(f"program {absent.filename}")
    given = json.load(sys.stdin)
    scene = {"case": given["case"], **given["numbers"], "stations": np.array(given["stations"])}
    answers = [script.solve(scene, level, method) for level in range(levels)]
    common.report(version=version, series=[{**answer, "pressure": list(answer["pressure"])} for answer in answers])


if __name__ == "__main__":
    main(sys.argv[3], int(sys.argv[4]))
