#!/usr/bin/env python3
"""Tries mutants of folders by the tests that reach them, compiled at once (`../switched.py`): seconds each instead of minutes.

Run as `python3 tests/mutants/room.py src/referee src/solver/accuracy`; it takes cargo-mutants, tree-sitter and tree-sitter-rust. Each is tried by
claims, up to the first that fails; with `--truths N` the first N of them by what holds numbers against closed forms and other codes alone, claims
(`../truths.toml`) and trials of the suite. What was found stays while the function of a mutant does; what was missed is tried again.
"""
import argparse
import concurrent.futures
import hashlib
import json
import math
import pathlib
import sys
import time

from run import PASSED, RECORD, UNVIABLE, bound, mutants, read, survivors, write

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import date, digest
from switch import plant
from switched import OF_CLAIMS, TRUTHS, Switched, is_claim


def tried(switched, left, by_number, tests, pool, until, found):
    """Tries some mutants, each by the tests that `tests` names, up to a time; tells `found` of each."""
    late = lambda: time.monotonic() > until
    results = pool.map(lambda number: None if late() else switched.caught_by(number, tests(by_number[number]["key"])), left)
    for number, result in zip(left, results):
        if result is not None:
            test, told, seconds = result
            key = by_number[number]["key"]
            print(f"{key}: {test or 'MISSED'} {', '.join(told)} ({seconds:.1f} s, {len(tests(key))} tests)", flush=True)
            found(key, test, told)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+", help="folders, or files")
    parser.add_argument("--sample", type=int, help="so many of them, by chance")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fresh", action="store_true", help="forget what was found before")
    parser.add_argument("--claims", default="", help="only claims whose names, with those of their modules, begin so, separated by commas")
    parser.add_argument("--truths", type=int, default=0, help="try the first so many by truths alone")
    parser.add_argument("--longest", type=int, default=20, help="leave out tests that take more seconds of a processor")
    parser.add_argument("--minutes", type=float, default=math.inf, help="try no more mutants after this time")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    until = time.monotonic() + 60 * asked.minutes
    every = mutants()
    listed = survivors(every)
    order = lambda key: hashlib.sha256(f"{asked.seed} {key}".encode()).digest()
    rooms = tuple(room.rstrip("/") for room in asked.rooms)
    drawn = sorted((key for key in every if key.startswith(rooms)), key=order)[:asked.sample]
    known = {} if asked.fresh else read(every)
    targets = ["claims", "suite"] if asked.truths else ["claims"]
    switched = Switched("mutants", plant, targets, tuple(asked.claims.split(",")), asked.fresh)
    by_number = switched.compile({number: every[key] | {"key": key} for number, key in enumerate(sorted(drawn), 1)})
    print(f"{len(drawn)} mutants, of which {len(by_number)} are compiled", flush=True)
    number_of = {one["key"]: number for number, one in by_number.items()}

    def of(key):
        """The entry of a mutant as its function is now."""
        own = {"mutant": key, "bound": bound(every[key]), "sources": digest(bound(every[key])), "date": date()}
        old = known.get(key, {})
        known[key] = (old if old.get("sources") == own["sources"] else {}) | own
        return known[key]

    def save():
        write(list(known.values()), every, listed, order)

    for key in drawn:
        if switched.kept["refused"].get(key) == UNVIABLE:
            of(key)["tests"] = UNVIABLE

    def by_claims(key, test, told):
        of(key).update({"tests": "claims" if test else PASSED, "tests_by": test})
        save()

    def by_truths(key, test, told):
        kind = "truth" if set(told) & set(TRUTHS) else PASSED
        of(key).update({"checks": kind, "checks_by": test and f"{test}: {next(iter(told.values()))}".rstrip(": ")})
        save()

    def is_open(key, way):
        one = known.get(key, {})
        return key in number_of and key not in listed and (one.get("sources") != digest(bound(every[key])) or one.get(way) in (None, PASSED))

    # By chance: what is interrupted has tried a fair sample.
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        reaching = switched.reach(by_number, pool, asked.longest)
        left = [number_of[key] for key in drawn if is_open(key, "tests")]
        tried(switched, left, by_number, lambda key: [one for one in reaching[key] if is_claim(one[0])], pool, until, by_claims)
        # A trial without a check against a truth tells nothing here.
        is_truth = lambda name: name in OF_CLAIMS or not is_claim(name) and not name.startswith("snapshot")
        left = [number_of[key] for key in drawn[:asked.truths] if is_open(key, "checks")]
        tried(switched, left, by_number, lambda key: [one for one in reaching[key] if is_truth(one[0])], pool, until, by_truths)
    switched.clear()
    save()
    print(json.dumps([{key: one[key] for key in one if key != "missed"} for one in json.loads(RECORD.read_text())["rooms"]], indent=1))


if __name__ == "__main__":
    main()
