#!/usr/bin/env python3
"""Plants the faults of faults.toml one at a time on a copy of the tree and records which checks turn red.

Run as `python3 tests/faults/plant.py` (about one minute a fault); writes snapshots/faults.json, which the page prints.
Names given on the command line select the faults whose name contains one of them, `--old` those that were planted on other
sources than the present ones; the record keeps the others. Each carries the digest of the sources it was planted on.
"""
import collections
import json
import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import digest
from spoiled import ROOT, Copy

LIST = ROOT / "tests/faults/faults.toml"
RECORD = ROOT / "snapshots/faults.json"
# Of a fault in the list.
KEYS = ["name", "file", "was", "is"]
# All that the verdicts are computed from, but for records, which no truth is read from.
SOURCES = ["Cargo.lock", "Cargo.toml", "oracles", "src", "tests/cases"]


def plant(copy, fault, sources):
    path = copy.tree / fault["file"]
    sound = path.read_text()
    if sound.count(fault["was"]) != 1:
        sys.exit(f"{fault['file']} holds `{fault['was']}` {sound.count(fault['was'])} times, not once: update {LIST.name}")
    path.write_text(sound.replace(fault["was"], fault["is"]))
    try:
        if not copy.program():
            sys.exit(f"{fault['name']} cannot be compiled: update {LIST.name}")
        red, ended = copy.failures()
    finally:
        path.write_text(sound)
    kinds = collections.Counter(check.get("kind") or "broken off" for check in red)
    # One example of each kind of reference, truths first.
    examples = {}
    for check in red:
        examples.setdefault(check.get("kind") or "broken off", copy.here(f"{check['trial']}: {check['requirement']}"))
    return fault | {"sources": sources, "red": kinds, "examples": examples, "ended": ended}


def main(wanted):
    faults = tomllib.loads(LIST.read_text())["fault"]
    copy = Copy("faults")
    sources = digest(SOURCES, copy.tree)
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() else []
    # What was planted as the list has it now.
    known = {old["name"]: old for old in kept if {key: old.get(key) for key in KEYS} in faults}
    chosen = [fault for fault in faults if not wanted or any(word in fault["name"] for word in wanted)]
    if wanted == ["--old"]:
        chosen = [fault for fault in faults if known.get(fault["name"], {}).get("sources") != sources]
    if not chosen:
        sys.exit("no such fault")
    sound, ended = copy.failures() if copy.program() else ([], "it cannot be compiled")
    if sound or ended:
        sys.exit(f"the tree without a fault is not green: {ended or sound[0]}")
    for number, fault in enumerate(chosen, 1):
        planted = known[fault["name"]] = plant(copy, fault, sources)
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
