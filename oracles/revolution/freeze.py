"""Asks the scripts beside this one for their scenes, and writes what they answer to ../frozen/revolution.json.

Needs ../setup.sh and setup.sh. Every script runs in a process of its own, of the newest dolfinx where that is installed; answers to the
same scene of the same script are kept.
"""

import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
FROZEN = HERE.parent / "frozen/revolution.json"
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


def digest(files):
    """SHA-256 of files, names and lengths included."""
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
    """Asks what is not known, and writes after every answer."""
    old = json.loads(FROZEN.read_text()) if FROZEN.exists() else {"scenes": {}}
    stations = [(k + 0.5) / 10 * A_OVER_R * RADIUS for k in range(10)]
    new = {"scripts": digest(sorted(HERE.glob("*.py"))), "scenes": {}}
    for case, numbers in SCENES.items():
        scene, known = {"case": case, "numbers": numbers, "stations": stations}, old["scenes"].get(case, {})
        answers = {}
        new["scenes"][case] = {"scene": scene, "answers": answers}
        for module, (method, cases) in SCRIPTS.items():
            if case not in cases:
                continue
            script, kept = digest([HERE / f"{module}.py"]), known.get("answers", {}).get(module, {})
            if kept.get("script") != script or known.get("scene") != scene:
                print(case, module, file=sys.stderr, flush=True)
                kept = {"script": script, **asked(module, method, scene)}
            answers[module] = kept
            FROZEN.write_text(json.dumps(new, indent=2) + "\n")


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    try:
        main()
    except (FileNotFoundError, subprocess.CalledProcessError) as absent:
        sys.exit(f"{absent}; what the scripts need is installed by: bash oracles/setup.sh && bash oracles/revolution/setup.sh")
