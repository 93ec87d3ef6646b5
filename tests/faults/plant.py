#!/usr/bin/env python3
"""Plants the faults of faults.toml one at a time on a copy of the tree and records which checks turn red.

Run as `python3 tests/faults/plant.py` (about one minute a fault); writes snapshots/faults.json, which the page prints.
Names given on the command line select the faults whose name contains one of them, `--old` those that were planted on other
sources than the present ones; the record keeps the others. Each carries the digest of the sources it was planted on.
"""
import collections
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import digest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = ROOT / "tests/faults/faults.toml"
RECORD = ROOT / "snapshots/faults.json"
TREE = ROOT / "target/faults/tree"
# Only what a fault touches is compiled again.
QUICK = ["--config", "profile.release.incremental=true"]
PATIENCE = 600
# Of a fault in the list.
KEYS = ["name", "file", "was", "is"]
# The suite, and the worked scene files.
COMMANDS = [["verdicts"], ["verify", "tests/cases", "--json"]]
# All that their verdicts are computed from, but for records, which no truth is read from.
SOURCES = ["Cargo.lock", "Cargo.toml", "oracles", "src", "tests/cases"]


def copy_tree():
    shutil.rmtree(TREE, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True
    )
    for name in filter(lambda name: (ROOT / name).is_file(), listed.stdout.splitlines()):
        (TREE / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, TREE / name)  # with new times: cargo compiles what was left over


def failures():
    """The checks that fail on the copy, and how the run ended if not by itself."""
    environment = os.environ | {"CARGO_TARGET_DIR": str(ROOT / "target/faults/build")}
    build = ["cargo", *QUICK, "build", "--release", "--quiet", "--bin", "contact-vv"]
    subprocess.run(build, cwd=TREE, env=environment, check=True)
    program = ROOT / "target/faults/build/release/contact-vv"
    checks = []
    for command in COMMANDS:
        try:
            run = subprocess.run([program, *command], cwd=TREE, capture_output=True, text=True, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return [], f"no end within {PATIENCE} s"
        told = [json.loads(line) for line in run.stdout.splitlines()]
        if not told:
            return [], here(run.stderr.strip().splitlines()[0]) if run.stderr.strip() else "no answer"
        checks += told
    # The trial that reads the record written here says nothing about the code.
    told = [check for check in checks if not check["trial"].startswith("planted faults")]
    return [check for check in told if check["verdict"] == "fail"], None


def here(text):
    """A message without the folder of the copy."""
    return text.replace(f"{TREE}/", "")


def plant(fault, sources):
    path = TREE / fault["file"]
    sound = path.read_text()
    if sound.count(fault["was"]) != 1:
        sys.exit(f"{fault['file']} holds `{fault['was']}` {sound.count(fault['was'])} times, not once: update {LIST.name}")
    path.write_text(sound.replace(fault["was"], fault["is"]))
    try:
        red, ended = failures()
    finally:
        path.write_text(sound)
    kinds = collections.Counter(check.get("kind", "broken off") for check in red)
    # One example of each kind of reference, truths first.
    examples = {}
    for check in red:
        examples.setdefault(check.get("kind", "broken off"), here(f"{check['trial']}: {check['requirement']}"))
    return fault | {"sources": sources, "red": kinds, "examples": examples, "ended": ended}


def main(wanted):
    faults = tomllib.loads(LIST.read_text())["fault"]
    copy_tree()
    sources = digest(SOURCES, TREE)
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() else []
    # What was planted as the list has it now.
    known = {old["name"]: old for old in kept if {key: old.get(key) for key in KEYS} in faults}
    chosen = [fault for fault in faults if not wanted or any(word in fault["name"] for word in wanted)]
    if wanted == ["--old"]:
        chosen = [fault for fault in faults if known.get(fault["name"], {}).get("sources") != sources]
    if not chosen:
        sys.exit("no such fault")
    sound, ended = failures()
    if sound or ended:
        sys.exit(f"the tree without a fault is not green: {ended or sound[0]}")
    for number, fault in enumerate(chosen, 1):
        planted = known[fault["name"]] = plant(fault, sources)
        print(f"{number}/{len(chosen)} {fault['name']}: {dict(planted['red']) or planted['ended'] or 'NOT CAUGHT'}", flush=True)
        missing = [fault["name"] for fault in faults if fault["name"] not in known]
        if not missing:  # after each: what is interrupted keeps what it found
            write([known[fault["name"]] for fault in faults])
    if missing:
        sys.exit(f"never planted, so nothing is recorded: {', '.join(missing)}")


def write(record):
    RECORD.write_text(json.dumps({"sources": SOURCES, "record": record}, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
