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
from digest import date, digest
from spoiled import ROOT, Copy, Run

RECORD = ROOT / "snapshots/mutants.json"
LIST = ROOT / "tests/mutants/survivors.toml"
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


def bound(mutant):
    """What an entry is bound to: the function, by its first line, or the file where it stands in none."""
    if not mutant.get("function"):
        return [mutant["file"]]
    lines = (ROOT / mutant["file"]).read_text().splitlines()
    at = mutant["function"]["span"]["start"]["line"] - 1
    # Attributes and comments in front of it are none of it.
    while not re.search(r"\bfn\b", lines[at]):
        at += 1
    return [f"{mutant['file']}: {lines[at].strip()}"]


def room(key):
    """The folder of a mutant."""
    parts = key.split(":")[0].split("/")[:-1]
    return "/".join(parts[:3] if parts[1:2] in (["solver"], ["oracle"]) else parts[:2])


def told(name, entries, every, listed):
    """The scores of a room, of the entries whose functions are as they were."""
    current = [one for one in entries if one["sources"] == digest(bound(every[one["mutant"]]))]
    viable = [one for one in current if is_viable(one)]
    counted = [one for one in viable if one["mutant"] not in listed]
    tested = [one for one in counted if "tests" in one]
    # In the order in which they are drawn: what the checks were asked about for passing the tests would be no fair sample.
    checked = list(itertools.takewhile(lambda one: "checks" in one, counted))
    return {
        "room": name, "mutants": sum(name == room(key) for key in every), "stale": len(entries) - len(current),
        "unviable": len(current) - len(viable), "equivalent": sum(one["mutant"] in listed for one in viable),
        "by_claims": wilson(sum(is_caught(one) is True for one in tested), len(tested)),
        "by_truths": wilson(sum(one["checks"] == "truth" for one in checked), len(checked)),
        "missed": [one["mutant"] for one in tested if is_caught(one) is not True],
    }


def read(every):
    """Entries of mutants that there still are, by their names."""
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() else []
    return {one["mutant"]: one for one in kept if one["mutant"] in every}


def write(record, every, listed, order):
    """Writes entries in the order in which they are drawn, and the scores of all rooms."""
    record = sorted((one for one in record if "tests" in one or "checks" in one), key=lambda one: order(one["mutant"]))
    by_room = {room(key): [] for key in every}
    for one in record:
        by_room[room(one["mutant"])].append(one)
    rooms = [told(name, own, every, listed) for name, own in sorted(by_room.items())]
    found = {"mutants": len(every), "rooms": rooms, "survivors": list(listed.values())}
    head = json.dumps(found, indent=1, ensure_ascii=False).removesuffix("\n}")
    lines = ",\n".join("  " + json.dumps(one, ensure_ascii=False) for one in record)
    RECORD.write_text(f'{head},\n "record": [\n{lines}\n ]\n}}\n')


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
    # What was found of a line that has changed since is dropped.
    known = {} if asked.in_diff else read(every)
    sources = {name: digest(bound(every[name]), copy.tree) for name in drawn}
    again = {"missed": lambda one: is_caught(one) is False, "old": lambda one: one["sources"] != sources[one["mutant"]]}.get(asked.again)
    for name in filter(lambda name: again and name in known and again(known[name]), drawn):
        del known[name]

    def run(way, judge, names):
        left = {name: every[name] for name in names if way not in known.get(name, {}) and is_viable(known.get(name, {}))}
        for name, outcome, by in each(copy, left, judge):
            about = {"mutant": name, "bound": bound(every[name]), "sources": sources[name], "date": date()}
            # An entry is as old as the older of its findings.
            known[name] = about | known.get(name, {}) | {way: outcome, f"{way}_by": by}
            if not asked.in_diff:  # after each: what is interrupted keeps what it found
                write(list(known.values()), every, listed, order)

    run("tests", by_tests, drawn)
    run("checks", by_checks, [name for name in drawn if is_caught(known[name]) is None])
    run("checks", by_checks, drawn[:asked.truths])
    record = [known[name] for name in sorted(known, key=order)]
    if asked.in_diff:
        missed = [one["mutant"] for one in record if is_caught(one) is False and one["mutant"] not in listed]
        sys.exit("\n".join(["missed:", *missed]) if missed else None)
    write(record, every, listed, order)


if __name__ == "__main__":
    main()
