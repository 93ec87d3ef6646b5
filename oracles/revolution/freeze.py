"""Asks the scripts beside this one for their scenes, and writes what they answer: freeze.py > ../frozen/revolution.json.

Needs ../setup.sh and setup.sh. Every script runs in a process of its own, of the newest dolfinx where that is installed.
"""

import hashlib
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
INSTALLED = HERE.parent / ".python"
LEVELS = 3
RADIUS, A_OVER_R = 50.0, 0.05
NUMBERS = {"radius": RADIUS, "young": 210e3, "poisson": 0.3, "a_over_r": A_OVER_R, "size": 8.0, "stretch": 2.0}
SCENES = {
    "sphere": NUMBERS,
    "truncated-sphere": NUMBERS,
    "cone": {**NUMBERS, "slope": 0.05, "stretch": 1.5},
}
SCRIPTS = {  # module: method, scenes
    "skfem_forms": ("penalty", ["sphere", "truncated-sphere"]),
    "ufl_forms": ("penalty", ["sphere", "truncated-sphere"]),
    "calculix_gaps": ("gaps", ["sphere", "truncated-sphere"]),
    "half_space": ("boundary", ["truncated-sphere", "cone"]),
}


def digest():
    """SHA-256 of the scripts of this folder, names and lengths included."""
    files = sorted(HERE.glob("*.py"))
    return hashlib.sha256(b"".join(f"{f.name}\0{f.stat().st_size}\0".encode() + f.read_bytes() for f in files)).hexdigest()


def asked(module, method, scene):
    """What a script answers, and the version of its code."""
    newest = INSTALLED / "newest/bin/python"
    python = newest if module == "ufl_forms" and newest.exists() else "/usr/bin/python3"
    around = {**os.environ, "XDG_CACHE_HOME": str(INSTALLED / "cache"), "OMPI_MCA_ess_singleton_isolated": "1"}
    if python != newest:
        around["PYTHONPATH"] = os.pathsep.join(str(INSTALLED / folder) for folder in ("site", "tamaas"))
    command = [str(python), "-B", str(HERE.parent / "peers/ask.py"), str(HERE), module, method, str(LEVELS)]
    told = subprocess.run(command, input=json.dumps(scene), stdout=subprocess.PIPE, text=True, check=True, env=around).stdout
    return json.loads(told.splitlines()[-1])


def main():
    """Prints the answers of all."""
    stations = [(k + 0.5) / 10 * A_OVER_R * RADIUS for k in range(10)]
    scenes, versions = {}, {}
    for case, numbers in SCENES.items():
        scene = {"case": case, "numbers": numbers, "stations": stations}
        series = {}
        for module, (method, cases) in SCRIPTS.items():
            if case in cases:
                print(case, module, file=sys.stderr, flush=True)
                told = asked(module, method, scene)
                versions[module], series[module] = told["version"], told["series"]
        scenes[case] = {"scene": scene, "series": series}
    print(json.dumps({"scripts": digest(), "versions": versions, "scenes": scenes}, indent=2))


if __name__ == "__main__":
    main()
