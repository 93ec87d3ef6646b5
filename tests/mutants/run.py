#!/usr/bin/env python3
"""Spoils the solver by a random sample of mutants and records which tests and which truths catch each.

Run as `python3 tests/mutants/run.py --sample 40 --seed 1`, on several machines with `--shard 0/4` and so on; it takes
cargo-mutants, which lists the mutants of .cargo/mutants.toml, and some minutes a mutant. Writes snapshots/mutants.json. Two scores:
mutants that any test turns red on, and those that a check against a closed form, another code or a measurement turns red on,
without snapshots and without what the code says of itself.
"""
import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import digest
from spoiled import ROOT, Copy

RECORD = ROOT / "snapshots/mutants.json"
# All that tests and checks are computed from.
SOURCES = ["Cargo.lock", "Cargo.toml", "oracles", "src", "tests"]
# Kinds of references that are not the code's own.
TRUTHS = ["analytic", "cross-code", "measured"]
# Seconds after which the tests are called endless, and names of tests that are recorded of a mutant.
PATIENCE, NAMED = 1800, 5


def listed():
    """All mutants, with a name each, and the version of what lists them."""
    told = subprocess.run(["cargo", "mutants", "--list", "--json"], cwd=ROOT, check=True, capture_output=True, text=True)
    version = subprocess.run(["cargo", "mutants", "--version"], check=True, capture_output=True, text=True)
    return json.loads(told.stdout), version.stdout.strip()


def spoil(copy, mutant):
    """Puts the mutant into the copy; returns the file and its sound text."""
    path = copy.tree / mutant["file"]
    sound = path.read_text()
    lines = sound.splitlines(keepends=True)
    at = lambda place: sum(map(len, lines[:place["line"] - 1])) + place["column"] - 1
    begin, end = at(mutant["span"]["start"]), at(mutant["span"]["end"])
    path.write_text(sound[:begin] + mutant["replacement"] + sound[end:])
    return path, sound


def tests(copy):
    """Tests that fail on the copy; none where it cannot be compiled."""
    built = copy.cargo("test", "--release", "--no-run", "--tests", "--quiet", capture_output=True)
    if built.returncode:
        return None
    try:
        run = copy.cargo("test", "--release", "--no-fail-fast", "--tests", capture_output=True, text=True, errors="replace",
                         timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return [f"no end within {PATIENCE} s"]
    red = re.findall(r"^test (.*?)\s+\.\.\. FAILED$", run.stdout, re.MULTILINE)
    return sorted(red) or (["the run broke off"] if run.returncode else [])


def judge(copy, mutant, sources):
    path, sound = spoil(copy, mutant)
    try:
        red = tests(copy)
        checks, ended = copy.failures() if red is not None else ([], None)
    finally:
        path.write_text(sound)
    kinds = collections.Counter(check["kind"] for check in checks if check.get("kind") in TRUTHS)
    outcome = "unviable" if red is None else "caught" if red else "missed"
    return {"mutant": mutant["name"], "sources": sources, "outcome": outcome, "tests": len(red or []),
            "for_instance": (red or [])[:NAMED], "truths": kinds, "ended": ended}


def scores(record):
    viable = [one for one in record if one["outcome"] != "unviable"]
    return {"viable": len(viable), "caught_by_tests": sum(one["outcome"] == "caught" for one in viable),
            "caught_by_truths": sum(bool(one["truths"]) for one in viable)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", type=int, default=40, help="mutants drawn among all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="0/1", help="every so many-th of them only")
    asked = parser.parse_args()
    mutants, program = listed()
    # A larger sample of the same seed begins with the smaller one.
    random.Random(asked.seed).shuffle(mutants)
    drawn = mutants[:asked.sample]
    shard, shards = map(int, asked.shard.split("/"))
    drawn = drawn[shard::shards]
    copy = Copy("mutants")
    sources = digest(SOURCES, copy.tree)
    if drawn:
        red, (checks, ended) = tests(copy), copy.failures()
        if red or red is None or checks or ended:
            sys.exit(f"the tree without a mutant is not green: {red or ended or checks[0]}")
    # Lines of other sources are other lines: their mutants are dropped.
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() else []
    known = {one["mutant"]: one for one in kept if one["sources"] == sources}
    about = {"sources": SOURCES, "program": program, "mutants": len(mutants), "sample": asked.sample, "seed": asked.seed}
    write(about, known)
    for mutant in drawn:
        if mutant["name"] not in known:
            one = known[mutant["name"]] = judge(copy, mutant, sources)
            print(f"{one['mutant']}: {one['outcome']} by {one['tests']} tests, {dict(one['truths'])}", flush=True)
            write(about, known)  # after each: what is interrupted keeps what it found
    print(scores(list(known.values())))


def write(about, known):
    record = [known[name] for name in sorted(known)]
    told = about | {"scores": scores(record), "record": record}
    RECORD.write_text(json.dumps(told, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
