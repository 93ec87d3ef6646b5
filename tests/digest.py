#!/usr/bin/env python3
"""Digest of files and folders of the checkout: what a record was made on. `src/checkout.rs` computes the same.

Run as `python3 tests/digest.py src tests/cases`; SHA-256 of the lines `hash  path` that `sha256sum` would print.
"""
import hashlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Folders that hold no sources.
LEFT_BEHIND = ("__pycache__", "target")


def digest(names, root=ROOT):
    """SHA-256 of files and of all files below folders, whose paths begin below `root`; hidden ones do not count."""
    files = sorted({file for name in names for file in collect(root, name)}, key=str.encode)
    lines = (f"{hashlib.sha256((root / file).read_bytes()).hexdigest()}  {file}\n" for file in files)
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def collect(root, path):
    """Paths of the files at or below a path."""
    if not (root / path).is_dir():
        yield path
        return
    for entry in (root / path).iterdir():
        if not entry.name.startswith(".") and entry.name not in LEFT_BEHIND:
            yield from collect(root, f"{path}/{entry.name}")


if __name__ == "__main__":
    print(digest(sys.argv[1:], pathlib.Path.cwd()))
