"""What every reader is given: a file to read, and packages to read it with."""

if __name__ == "__main__":
    raise SystemExit("usage: python3 oracles/readers/fields.py FILE, which imports this module")

import argparse
import os
import sys


def file(description):
    """The file that the command line names."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("file")
    path = parser.parse_args().file
    if not os.path.isfile(path):
        parser.error(f"{path} is no file")
    return path


def missing(package):
    """Ends the process: a package is not installed, which a command installs."""
    sys.exit(f"{package} is missing in {sys.executable}: python3 -m pip install --requirement oracles/readers/requirements.txt")
