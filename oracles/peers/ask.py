"""A refinement series of a scene by a script of its own folder: ask.py FOLDER MODULE METHOD LEVELS < scene; prints one JSON object.

The scene is a JSON object: case, numbers by name, stations. Printed: version of the code, series coarse to fine.
"""

import argparse
import importlib
import json
import sys

import common  # first: one thread

import numpy as np


def main(asked, wrong):
    """Answers on every mesh; `wrong` is told of what is asked."""
    sys.path.insert(0, asked.folder)
    try:
        script = importlib.import_module(asked.module)
        version = script.version()
    except ModuleNotFoundError as absent:
        common.missing(f"module {absent.name}")
    except FileNotFoundError as absent:
        common.missing(f"program {absent.filename}")
    try:
        given = json.load(sys.stdin)
        scene = {"case": given["case"], **given["numbers"], "stations": np.array(given["stations"])}
    except (KeyError, TypeError, ValueError) as error:
        wrong(f"no scene is on stdin: {error!r}")
    answers = [script.solve(scene, level, asked.method) for level in range(asked.levels)]
    common.report(version=version, series=[{**answer, "pressure": list(answer["pressure"])} for answer in answers])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("folder", "module", "method"):
        parser.add_argument(name)
    parser.add_argument("levels", type=int)
    main(parser.parse_args(), parser.error)
