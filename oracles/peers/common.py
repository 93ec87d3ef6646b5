"""What the peers share: one thread, and the object they print. Units mm, N, MPa.

Importing this first makes every library loaded later, and every process started, keep to one thread.
"""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/peers/ask.py FOLDER MODULE METHOD LEVELS < scene, which imports this module")

import json
import os
import sys

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

MISSING = 3  # exit code


def missing(what):
    """Ends the process: the code is not installed."""
    print(f"{what} is missing: bash oracles/peers/setup.sh", file=sys.stderr)
    sys.exit(MISSING)


try:
    import numpy  # noqa: F401  reads the number of threads when loaded, and every peer needs it
except ModuleNotFoundError:
    missing("numpy (package python3-numpy)")


def report(**result):
    """Prints the one object."""
    print(json.dumps(result))
