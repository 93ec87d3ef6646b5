#!/usr/bin/env python3
"""Digest of files, folders and functions of the checkout: what an entry of a record is bound to. `src/checkout.rs` computes the same.

Run as `python3 tests/digest.py src tests/cases`; the first 16 digits of the SHA-256 of the lines `hash  name` that `sha256sum` would print of files. `path: line` is the text
of the functions that begin with this line, up to the brace that closes them.
"""
import hashlib
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Folders that hold no sources.
LEFT_BEHIND = ("__pycache__", "target")
# Digits that are kept: what changes by chance to the same 64 bits need not be told apart.
KEPT = 16


def digest(names, root=ROOT):
    """Digest of functions, files and all files below folders, whose paths begin below `root`; hidden ones do not count."""
    files = sorted({file for name in names for file in collect(root, name)}, key=str.encode)
    lines = (f"{hashlib.sha256(content(root, file)).hexdigest()}  {file}\n" for file in files)
    return hashlib.sha256("".join(lines).encode()).hexdigest()[:KEPT]


def content(root, name):
    """Bytes of a file, or of the functions in it that begin with a line; lines of Rust that are comments do not count."""
    file, _, head = name.partition(": ")
    whole = (root / file).read_bytes()
    if file.endswith(".rs"):
        whole = b"\n".join(line for line in whole.split(b"\n") if not line.lstrip().startswith(b"//"))
    if not head:
        return whole
    lines, found = whole.decode().split("\n"), []
    for at, line in enumerate(lines):
        if line.strip() == head:
            closing = line[:len(line) - len(line.lstrip())] + "}"
            length = next((k for k, other in enumerate(lines[at:]) if other == closing), 0)
            found += lines[at:at + length + 1]
    return "\n".join(found).encode()


def date():
    """Day of the last commit: the date of the sources."""
    return subprocess.run(["git", "log", "-1", "--format=%cs"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def changed_since(base):
    """Files that differ from a commit."""
    told = subprocess.run(["git", "diff", "--name-only", base], cwd=ROOT, check=True, capture_output=True, text=True)
    return told.stdout.splitlines()


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
