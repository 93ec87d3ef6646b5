"""Answers scenes with the modules of a folder, imported anew for each: a line of JSON in, a line of JSON out.

A line in names folder, module, method, scene and the number of meshes; a line out has the answers, or what was raised instead.
"""
import importlib
import json
import pathlib
import sys

root = sys.argv[1]
sys.path.insert(0, root + "/oracles/python")

import environment

environment.prepare(root + "/oracles/.python")
import numpy


def answers(folder, module, method, scene, levels):
    """The answers on the meshes, coarse to fine."""
    for path in pathlib.Path(folder).glob("*.py"):
        sys.modules.pop(path.stem, None)
    sys.path.insert(0, folder)
    try:
        solve = importlib.import_module(module).solve
        given = {"case": scene["case"], **scene["numbers"], "stations": numpy.array(scene["stations"])}
        found = [solve(given, level, method) for level in range(levels)]
    finally:
        sys.path.remove(folder)
    return [{**one, "pressure": list(one["pressure"])} for one in found]


# What a code prints besides is no answer.
told, sys.stdout = sys.stdout, sys.stderr
for line in sys.stdin:
    try:
        line = {"answers": answers(**json.loads(line))}
    except Exception as error:
        line = {"raised": f"{type(error).__name__}: {error}"}
    print(json.dumps(line), file=told, flush=True)
