#!/usr/bin/env python3
"""Spoils the solver by a random sample of mutants and records what catches each.

Run as `python3 tests/mutants/run.py --sample 40 --seed 1`; it takes cargo-mutants, which lists the mutants of .cargo/mutants.toml.
Each is tried by the tests, up to the first that fails (some ten seconds), then by the checks of the program, up to the first that
turns red against a closed form, another code or a measurement (up to some minutes; `--truths 0` tries those only that passed the
tests). Writes snapshots/mutants.json. With `--in-diff FILE` it tries all mutants of the lines that a diff changes, records nothing
and fails where one is missed.
"""
import argparse
import collections
import hashlib
import itertools
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
# Of the suite, whose checks the program makes too, the snapshots.
TESTS = [("claims", []), ("suite", ["snapshot"])]
# Seconds of silence after which tests are called endless.
PATIENCE = 240
# Outcomes that are no catch.
PASSED, UNVIABLE = "passed", "unviable"
# Of the normal distribution, for an interval of 95 %.
SPREAD = 1.96


def listing(*options):
    """Mutants of all crates as cargo-mutants lists them."""
    command = ["cargo", "mutants", "--workspace", "--list", "--json", *options]
    told = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
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


def by_tests(copy):
    """What the tests say of the copy as it is: an outcome, and what showed it."""
    if not copy.program():
        return UNVIABLE, None
    for target, words in TESTS:
        if red := test(copy, target, words):
            return target, red
    return PASSED, None


def by_checks(copy):
    """The same of the checks of the program."""
    if not copy.program():
        return UNVIABLE, None
    checks, ended = copy.failures(enough=is_truth)
    if checks:
        return "truth" if is_truth(checks[0]) else "check", copy.here(f"{checks[0]['trial']}: {checks[0]['requirement']}")
    return ("ended", ended) if ended else (PASSED, None)


def each(copy, mutants, judge):
    """Tries some mutants in one way, which must find nothing on the sound copy; yields name, outcome and what showed it."""
    if mutants and (found := judge(copy))[0] != PASSED:
        sys.exit(f"the tree without a mutant is not green: {found}")
    for name, mutant in mutants.items():
        path, sound = spoil(copy, mutant)
        try:
            found = judge(copy)
        finally:
            path.write_text(sound)
        print(f"{name}: {', '.join(filter(None, found))}", flush=True)
        yield name, *found


def is_viable(one):
    return UNVIABLE not in (one.get("tests"), one.get("checks"))


def is_caught(one):
    """Whether anything has caught it; none where that is not decided."""
    found = [one.get("tests"), one.get("checks")]
    if any(outcome not in (None, PASSED) for outcome in found):
        return True
    return None if None in found else False


def wilson(caught, of):
    """A part with its 95 % interval by Wilson's score."""
    if not of:
        return {"caught": caught, "of": of}
    part, square = caught / of, SPREAD**2 / of
    middle, half = part + square / 2, SPREAD * math.sqrt(part * (1 - part) / of + square / of / 4)
    interval = [round((middle + sign * half) / (1 + square), 3) for sign in (-1, 1)]
    return {"caught": caught, "of": of, "part": round(part, 3), "interval": interval}


def scores(record, listed):
    """Parts of the viable mutants that are caught, without those that the list has as beyond any test."""
    counted = [one for one in record if is_viable(one) and one["mutant"] not in listed]
    tested = [one for one in counted if "tests" in one]
    # In the order in which they are drawn: what the checks were asked about for passing the tests would be no fair sample.
    checked = list(itertools.takewhile(lambda one: "checks" in one, counted))
    return {
        "by_anything": wilson(sum(is_caught(one) is True for one in tested), len(tested)),
        "by_anything_at_first": wilson(sum(one.get("at_first") is True for one in tested), len(tested)),
        "by_truths": wilson(sum(one["checks"] == "truth" for one in checked), len(checked)),
    }


def write(about, record, listed):
    missed = [one["mutant"] for one in record if is_caught(one) is False and one["mutant"] not in listed]
    shown = [listed[one["mutant"]] for one in record if one["mutant"] in listed]
    unviable = sum(not is_viable(one) for one in record)
    # What room.py has found of whole folders stays.
    rooms = {"rooms": json.loads(RECORD.read_text()).get("rooms", [])} if RECORD.exists() else {}
    told = about | {"unviable": unviable, "scores": scores(record, listed), "missed": missed, "survivors": shown} | rooms | {"record": record}
    RECORD.write_text(json.dumps(told, indent=1, ensure_ascii=False) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", type=int, default=40, help="mutants drawn among all")
    parser.add_argument("--truths", type=int, help="so many of them are tried by the checks in any case; by default all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="0/1", help="every so many-th of them only")
    parser.add_argument("--again", choices=["missed", "old"], help="try those again that were missed, or all of other sources")
    parser.add_argument("--in-diff", help="try the mutants of changed lines instead")
    asked = parser.parse_args()
    every = mutants()
    listed = survivors(every)
    # A larger sample of the same seed begins with the smaller one, and an edit elsewhere draws no others.
    order = lambda name: hashlib.sha256(f"{asked.seed} {name}".encode()).digest()
    drawn = sorted(every, key=order)
    if asked.in_diff:
        changed = {one["name"] for one in listing("--in-diff", asked.in_diff)}
        drawn, asked.truths = [name for name in drawn if every[name]["name"] in changed], 0
    else:
        drawn = drawn[:asked.sample]
    shard, shards = map(int, asked.shard.split("/"))
    drawn = drawn[shard::shards]
    copy = Copy("mutants")
    sources = digest(SOURCES, copy.tree)
    # What was found of a line that has changed since is dropped.
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() and not asked.in_diff else []
    known = {one["mutant"]: one for one in kept if one["mutant"] in every}
    again = {"missed": lambda one: is_caught(one) is False, "old": lambda one: one["sources"] != sources}.get(asked.again)
    for name in filter(lambda name: again and name in known and again(known[name]), drawn):
        known[name] = {key: known[name][key] for key in ["mutant", "at_first"] if key in known[name]}
    program = subprocess.run(["cargo", "mutants", "--version"], check=True, capture_output=True, text=True).stdout.strip()
    about = {"sources": SOURCES, "program": program, "mutants": len(every), "seed": asked.seed}

    def run(way, judge, names):
        left = {name: every[name] for name in names if way not in known.get(name, {}) and is_viable(known.get(name, {}))}
        for name, outcome, by in each(copy, left, judge):
            # An entry is as old as the older of its findings.
            one = known[name] = {"mutant": name, "sources": sources} | known.get(name, {}) | {way: outcome, f"{way}_by": by}
            if is_viable(one) and is_caught(one) is not None:
                one.setdefault("at_first", is_caught(one))
            if not asked.in_diff:  # after each: what is interrupted keeps what it found
                write(about, [known[name] for name in sorted(known, key=order)], listed)

    run("tests", by_tests, drawn)
    run("checks", by_checks, [name for name in drawn if is_caught(known[name]) is None])
    run("checks", by_checks, drawn[:asked.truths])
    record = [known[name] for name in sorted(known, key=order)]
    if asked.in_diff:
        missed = [one["mutant"] for one in record if is_caught(one) is False and one["mutant"] not in listed]
        sys.exit("\n".join(["missed:", *missed]) if missed else None)
    write(about, record, listed)
    print(json.dumps(scores(record, listed), indent=1))


if __name__ == "__main__":
    main()
