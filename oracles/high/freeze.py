"""Asks boundary.py and finite_elements.py for reference answers, and writes them to ../frozen/high.json; answers of the same scene,
script and settings are kept. The second needs ../peers/setup.sh. Numbers are [value, how far it may be off] in mm, MPa, N and rad.
"""

import argparse
import hashlib
import importlib
import json
import os
import pathlib
import sys
import time

os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")  # first: one thread

HERE = pathlib.Path(__file__).resolve().parent
FROZEN = HERE.parent / "frozen"
SHARED = {  # ours: those of ../frozen/independent.json, and another support
    "cylinder": ("cylinder, a/R = 0.05", "cylinder"),
    "cylinder, a/R = 0.1": ("cylinder, a/R = 0.1", "cylinder"),
    "cylinder-between-plates": ("cylinder, a/R = 0.05", "cylinder-between-plates"),
    "pin-rod": ("pin-rod", "pin-rod"),
    "pin-plate": ("pin in plate", "pin-plate"),
}
SCRIPTS = {  # files, packages, rough settings first, the answer's last
    "boundary": (["boundary.py", "potentials.py"], ["numpy"], [32, 64]),
    "finite_elements": (["curved_cells.py", "finite_elements.py"], ["ngsolve", "numpy", "scipy"], [[8, 5, 12], [7, 6, 16], [8, 6, 16]]),
}
FACTOR, ROUND_OFF = 2.0, 1e-10  # of the largest difference between settings, and of the value


def digest(files):
    """SHA-256 of files, names and lengths included."""
    return hashlib.sha256(b"".join(f"{f.name}\0{f.stat().st_size}\0".encode() + f.read_bytes() for f in files)).hexdigest()


def asked(script, scene):
    """What a script answers under its settings: the last with what the others differ by."""
    _, packages, settings = SCRIPTS[script]
    module, begin = importlib.import_module(script), time.perf_counter()
    *others, answer = (module.solve(scene, setting) for setting in settings)
    seconds = time.perf_counter() - begin
    off = {name: FACTOR * max(abs(value - other[name]) for other in others) + ROUND_OFF * abs(value) for name, value in answer.items()}
    return {
        "versions": {package: sys.modules[package].__version__ for package in packages},
        "settings": settings,
        "seconds": round(seconds, 1),
        "numbers": {name: [value, off[name]] for name, value in answer.items()},
    }


def main():
    """Asks what is not known, and writes after every answer."""
    file = FROZEN / "high.json"
    old = json.loads(file.read_text())["scenes"] if file.exists() else {}
    shared = json.loads((FROZEN / "independent.json").read_text())["scenes"]
    new = {"scripts": digest(sorted(HERE.glob("*.py"))), "scenes": {}}
    for name, (of, case) in SHARED.items():
        scene, known, answers = {"case": case, "numbers": shared[of]["scene"]["numbers"]}, old.get(name, {}), {}
        new["scenes"][name] = {"scene": scene, "answers": answers}
        for script, (files, _, settings) in SCRIPTS.items():
            own, kept = digest([HERE / own for own in files]), known.get("answers", {}).get(script, {})
            if kept.get("script") != own or kept.get("settings") != settings or known.get("scene") != scene:
                print(name, script, file=sys.stderr, flush=True)
                kept = {"script": own, **asked(script, scene)}
            answers[script] = kept
            file.write_text(json.dumps(new, indent=2) + "\n")


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    try:
        main()
    except ModuleNotFoundError as absent:
        sys.exit(f"{absent.name} is missing in {sys.executable}: bash oracles/peers/setup.sh installs it for /usr/bin/python3")
    except FileNotFoundError as absent:
        sys.exit(f"{absent.filename} is missing: cargo run --release -p contact-vv-live writes it")
