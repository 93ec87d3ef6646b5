"""Answers in a process of its own, of any Python: apart.py INSTALLED; a line of JSON in, a line of JSON out, the versions first.

A line in is a discrete problem as in discrete.py, with lists for arrays, or names the folder and module of a script, imported anew for each,
its method, the scene and the number of meshes; a line out has the answers, or what was raised instead.
"""
import argparse
import importlib
import json
import pathlib
import sys

import environment


def answers(request):
    """What a discrete problem is answered, or a scene on its meshes, coarse to fine."""
    if "module" not in request:
        import discrete_dolfinx

        arrays = {name: array(value) if isinstance(value, list) else value for name, value in request.items()}
        return plain(discrete_dolfinx.solve(arrays))
    for path in pathlib.Path(request["folder"]).glob("*.py"):
        sys.modules.pop(path.stem, None)
    sys.path.insert(0, request["folder"])
    try:
        solve, scene = importlib.import_module(request["module"]).solve, request["scene"]
        given = {"case": scene["case"], **scene["numbers"], "stations": array(scene["stations"])}
        return [plain(solve(given, level, request["method"])) for level in range(request["levels"])]
    finally:
        sys.path.remove(request["folder"])


def array(values):
    """An array; an empty one is a table of two columns."""
    import numpy as np

    return np.array(values) if values else np.zeros((0, 2), int)


def plain(answer):
    """The answer with lists for arrays."""
    return {name: value.tolist() if hasattr(value, "tolist") else value for name, value in answer.items()}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("installed", help="folder that oracles/setup.sh has filled")
    try:
        environment.prepare(parser.parse_args().installed)
    except ModuleNotFoundError as missing:
        sys.exit(f"module `{missing.name}` is missing in {sys.executable}: run oracles/setup.sh on Debian 12")
    # What a code prints besides is no answer.
    told, sys.stdout = sys.stdout, sys.stderr
    print(json.dumps(environment.versions()), file=told, flush=True)
    for line in sys.stdin:
        try:
            line = {"answers": answers(json.loads(line))}
        except Exception as error:
            line = {"raised": f"{type(error).__name__}: {error}"}
        print(json.dumps(line), file=told, flush=True)
