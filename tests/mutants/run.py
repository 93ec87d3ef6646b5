#!/usr/bin/env python3
"""Spoils the solver by a random sample of mutants and records what catches each.

Run as `python3 tests/mutants/run.py --sample 40 --seed 1`; it takes cargo-mutants, which lists the mutants of
.cargo/mutants.toml, and one to four minutes a mutant. Each is tried by the checks of the program first, up to the first that is
held against a closed form, another code or a measurement; where no check turns red, by the tests, up to the first that does.
Writes snapshots/mutants.json. With `--in-diff FILE` it tries all mutants of the lines that a diff changes, records nothing and
fails where one is missed.
"""
import argparse
import collections
import hashlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import digest
from spoiled import ROOT, Copy, Run

RECORD = ROOT / "snapshots/mutants.json"
LIST = ROOT / "tests/mutants/survivors.toml"
# All that tests and checks are computed from.
SOURCES = ["Cargo.lock", "Cargo.toml", "oracles", "src", "tests/architecture", "tests/architecture.rs", "tests/cases", "tests/claims",
           "tests/data", "tests/fuzz/corpus", "tests/suite.rs"]
# Kinds of references that are not the code's own.
TRUTHS = ["analytic", "cross-code", "measured"]
# What tries a mutant that no check has caught: of the suite, whose checks have been run, the snapshots.
TESTS = [("claims", []), ("suite", ["snapshot"])]
# Seconds of silence after which tests are called endless.
PATIENCE = 600
# Outcome of a mutant that no check has caught and no test has tried yet.
OPEN = "open"
# Of the normal distribution, for an interval of 95 %.
SPREAD = 1.96


def listing(*options):
    """Mutants as cargo-mutants lists them."""
    told = subprocess.run(["cargo", "mutants", "--list", "--json", *options], cwd=ROOT, check=True, capture_output=True, text=True)
    return json.loads(told.stdout)


def mutants():
    """All mutants, each by a name that stays while its line does."""
    found, counts = {}, collections.Counter()
    for one in listing():
        what = re.sub(r"^(.*?):\d+:\d+:", r"\1:", one["name"])
        line = (ROOT / one["file"]).read_text().splitlines()[one["span"]["start"]["line"] - 1].strip()
        counts[what, line] += 1
        # The same change of the same text: which of them.
        again = f" ({counts[what, line]})" if counts[what, line] > 1 else ""
        found[f"{what}: {line}{again}"] = one
    return found


def survivors(known):
    """The list of mutants that no test can catch, with their reasons; refused where one is no mutant."""
    listed = tomllib.loads(LIST.read_text()).get("survivor", [])
    for one in listed:
        if set(one) != {"mutant", "kind", "because"} or one["kind"] not in ["equivalent", "speed"]:
            sys.exit(f"{LIST.name}: give `mutant`, `kind` (equivalent or speed) and `because`: {one}")
        if one["mutant"] not in known:
            sys.exit(f"{LIST.name}: no such mutant: {one['mutant']}")
    return {one["mutant"]: one for one in listed}


def spoil(copy, mutant):
    """Puts the mutant into the copy; returns the file and its sound text."""
    path = copy.tree / mutant["file"]
    sound = path.read_text()
    lines = sound.splitlines(keepends=True)
    at = lambda place: sum(map(len, lines[:place["line"] - 1])) + place["column"] - 1
    begin, end = at(mutant["span"]["start"]), at(mutant["span"]["end"])
    path.write_text(sound[:begin] + mutant["replacement"] + sound[end:])
    return path, sound


def is_truth(check):
    return check.get("kind") in TRUTHS


def test(copy, target, words):
    """The first test that fails on the copy; none where all pass."""
    if not copy.compiles("test", "--release", "--quiet", "--no-run", "--test", target):
        return "tests cannot be compiled"
    run = Run(copy.command("test", "--release", "--test", target, "--", *words), PATIENCE, **copy.options())
    for line in run.lines():
        if failed := re.match(r"test (.*?)\s+\.\.\. FAILED$", line):
            return failed[1]
    return run.broken() or ("it broke off" if run.process.returncode else None)


def by_checks(copy):
    """What the checks of the program say of the copy as it is: an outcome and what showed it, none where they hold."""
    if not copy.program():
        return "unviable", None
    checks, ended = copy.failures(enough=is_truth)
    if checks:
        return "truth" if is_truth(checks[0]) else "check", copy.here(f"{checks[0]['trial']}: {checks[0]['requirement']}")
    return ("ended", ended) if ended else (OPEN, None)


def by_tests(copy):
    """The same of the tests."""
    for target, words in TESTS:
        if red := test(copy, target, words):
            return target, red
    return "missed", None


def run(copy, mutants, judge, keep):
    """Tries some mutants in one way, which must find nothing on the sound copy."""
    if mutants:
        outcome, red = judge(copy)
        if outcome not in ["missed", OPEN]:
            sys.exit(f"the tree without a mutant is not green: {outcome}, {red}")
    for name, mutant in mutants.items():
        path, sound = spoil(copy, mutant)
        try:
            outcome, red = judge(copy)
        finally:
            path.write_text(sound)
        keep(name, outcome, red)


def wilson(caught, of):
    """A part with its 95 % interval by Wilson's score."""
    if not of:
        return {"caught": caught, "of": of}
    part, square = caught / of, SPREAD**2 / of
    middle, half = part + square / 2, SPREAD * math.sqrt(part * (1 - part) / of + square / of / 4)
    interval = [round((middle + sign * half) / (1 + square), 3) for sign in (-1, 1)]
    return {"caught": caught, "of": of, "part": round(part, 3), "interval": interval}


def scores(record, listed):
    """Parts of the viable mutants that are caught, without those that the list has as beyond any test; open ones are not."""
    tried = [one for one in record if one["outcome"] != "unviable" and one["mutant"] not in listed]
    part = lambda holds: wilson(sum(map(holds, tried)), len(tried))
    return {
        "by_anything": part(lambda one: one["outcome"] not in ["missed", OPEN]),
        "by_anything_at_first": part(lambda one: one["at_first"] not in ["missed", OPEN]),
        "by_truths": part(lambda one: one["outcome"] == "truth"),
    }


def write(about, record, listed):
    counts = collections.Counter(one["outcome"] for one in record)
    shown = [listed[one["mutant"]] for one in record if one["mutant"] in listed]
    told = about | {"outcomes": dict(sorted(counts.items())), "scores": scores(record, listed), "survivors": shown, "record": record}
    RECORD.write_text(json.dumps(told, indent=1, ensure_ascii=False) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", type=int, default=40, help="mutants drawn among all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="0/1", help="every so many-th of them only")
    parser.add_argument("--again", choices=["missed", "old"], help="try those again that were missed, or all of other sources")
    parser.add_argument("--in-diff", help="try the mutants of changed lines instead")
    asked = parser.parse_args()
    every = mutants()
    listed = survivors(every)
    drawn = list(every)
    if asked.in_diff:
        changed = {one["name"] for one in listing("--in-diff", asked.in_diff)}
        drawn = [name for name in drawn if every[name]["name"] in changed]
    else:
        # A larger sample of the same seed begins with the smaller one, and an edit elsewhere draws no others.
        drawn = sorted(drawn, key=lambda name: hashlib.sha256(f"{asked.seed} {name}".encode()).digest())[:asked.sample]
    shard, shards = map(int, asked.shard.split("/"))
    drawn = drawn[shard::shards]
    copy = Copy("mutants")
    sources = digest(SOURCES, copy.tree)
    # What was found of a line that has changed since is dropped.
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() and not asked.in_diff else []
    known = {one["mutant"]: one for one in kept if one["mutant"] in every}
    again = {"missed": lambda one: one["outcome"] == "missed", "old": lambda one: one["sources"] != sources}.get(asked.again)
    tried = [name for name in drawn if name not in known or again and again(known[name]) and name not in listed]
    program = subprocess.run(["cargo", "mutants", "--version"], check=True, capture_output=True, text=True).stdout.strip()
    about = {"sources": SOURCES, "program": program, "mutants": len(every), "seed": asked.seed}

    def keep(name, outcome, by):
        first = known.get(name, {}).get("at_first", OPEN)
        known[name] = {"mutant": name, "sources": sources, "outcome": outcome, "by": by, "at_first": outcome if first == OPEN else first}
        print(f"{name}: {outcome}, {by}", flush=True)
        if not asked.in_diff:  # after each: what is interrupted keeps what it found
            write(about, [known[name] for name in sorted(known)], listed)

    # The checks need no tests compiled: first all mutants by these, then what is left by the tests.
    run(copy, {name: every[name] for name in tried}, by_checks, keep)
    left = [name for name in drawn if name in known and known[name]["outcome"] == OPEN and name not in listed]
    run(copy, {name: every[name] for name in left}, by_tests, keep)
    if not asked.in_diff:
        write(about, [known[name] for name in sorted(known)], listed)
    print(json.dumps(scores(list(known.values()), listed), indent=1))
    missed = [one["mutant"] for one in known.values() if one["outcome"] == "missed" and one["mutant"] not in listed]
    sys.exit("\n".join(["missed:", *missed]) if missed and asked.in_diff else None)


if __name__ == "__main__":
    main()
