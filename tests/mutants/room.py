#!/usr/bin/env python3
"""Tries mutants of folders by the tests that reach them, compiled at once (`../switched.py`): seconds each instead of minutes.

Run as `python3 tests/mutants/room.py src/referee src/solver/accuracy`; it takes cargo-mutants, tree-sitter and tree-sitter-rust. Each is tried by
claims, up to the first that fails; with `--truths N` the first N of them by what holds numbers against closed forms and other codes alone, claims
(`../truths.toml`) and trials of the suite. What was found stays while the function of a mutant does; what was missed is tried again. `--old` asks
those alone whose functions are others by now, of files that differ from `--base` first, then the oldest, and what caught each before first of all.
With `--in-diff FILE` the mutants of the lines that a diff changes are tried by all tests, nothing is recorded, and it fails where one is missed.
"""
import argparse
import concurrent.futures
import functools
import hashlib
import math
import pathlib
import sys
import time

from record import PASSED, UNVIABLE, bound, listing, mutants, read, survivors, write

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import changed_since, date, digest
from switch import plant
from switched import OF_CLAIMS, TRUTHS, Switched, is_claim


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="*", default=["src"], help="folders, or files")
    parser.add_argument("--sample", type=int, help="so many of them, by chance")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fresh", action="store_true", help="forget what was found before")
    parser.add_argument("--old", action="store_true", help="only those that were tried on other sources")
    parser.add_argument("--base", default="HEAD", help="commit that changed files differ from")
    parser.add_argument("--in-diff", help="only those of the lines that a diff changes, by all tests; nothing is recorded")
    parser.add_argument("--claims", default="", help="only claims whose names, with those of their modules, begin so, separated by commas")
    parser.add_argument("--truths", type=int, default=0, help="try the first so many by truths alone")
    parser.add_argument("--longest", type=int, default=20, help="leave out tests that take more seconds of a processor")
    parser.add_argument("--minutes", type=float, default=math.inf, help="try no more mutants after this time, once all are compiled")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    every = mutants()
    listed = survivors(every)
    order = lambda key: hashlib.sha256(f"{asked.seed} {key}".encode()).digest()
    known = {} if asked.fresh or asked.in_diff else read(every)
    before = dict(known)
    is_old = lambda key: before.get(key, {}).get("sources") != digest(bound(every[key]))
    rooms = tuple(room.rstrip("/") for room in asked.rooms)
    drawn = sorted((key for key in every if key.startswith(rooms)), key=order)
    if asked.old:
        drawn, changed = [key for key in drawn if key in before and is_old(key)], changed_since(asked.base)
        drawn.sort(key=lambda key: (every[key]["file"] not in changed, before[key]["date"] or ""))
    if asked.in_diff:
        changed = {one["name"] for one in listing("--in-diff", asked.in_diff)}
        drawn = [key for key in drawn if every[key]["name"] in changed and key not in listed]
    drawn = drawn[:asked.sample]
    if not drawn:
        return print("none is old" if asked.old else "no such mutant")
    targets = ["claims", "suite"] if asked.truths or asked.old or asked.in_diff else ["claims"]
    switched = Switched("mutants", plant, targets, tuple(asked.claims.split(",")), asked.fresh)
    by_number = switched.compile({number: every[key] | {"key": key} for number, key in enumerate(sorted(drawn), 1)})
    print(f"{len(drawn)} mutants, of which {len(by_number)} are compiled", flush=True)
    until = time.monotonic() + 60 * asked.minutes
    number_of = {one["key"]: number for number, one in by_number.items()}
    names = switched.names()

    def record(key, way, outcome, by):
        """Puts what was found into the entry of a mutant as its function is now."""
        own = {"mutant": key, "file": every[key]["file"], "bound": bound(every[key]), "sources": digest(bound(every[key])), "date": date()}
        old = known.get(key, {})
        known[key] = (old if old.get("sources") == own["sources"] else {}) | own | {way: outcome} | ({} if outcome == UNVIABLE else {f"{way}_by": by})

    def save():
        if not asked.in_diff:
            write(list(known.values()), every, listed, order)

    for key in drawn:
        if switched.kept["refused"].get(key) == UNVIABLE:
            record(key, "tests", UNVIABLE, None)

    def is_of(way, name):
        """Whether a test counts; a trial without a check against a truth tells nothing where truths are asked."""
        if way == "tests":
            return is_claim(name) or asked.in_diff
        return name in OF_CLAIMS or not is_claim(name) and not name.startswith("snapshot")

    is_sound = functools.cache(lambda name: switched.red([name]) is None)

    def caught(key, way, reaching):
        """What catches a mutant: what did before, else the first test that reaches it; none where nobody knows which do."""
        old = before.get(key, {}).get(f"{way}_by") or ""
        first = [(name, 0.0) for name in names if old == name or old.startswith(f"{name}: ")]
        if first and is_sound(first[0][0]):
            found = switched.caught_by(number_of[key], first)
            if found[0] and (way == "tests" or set(found[1]) & set(TRUTHS)):
                return found
        return None if reaching is None else switched.caught_by(number_of[key], [one for one in reaching[key] if is_of(way, one[0])])

    def tried(keys, ways, reaching):
        """Tries some mutants up to a time, each in all of its ways or not at all."""
        def one(key):
            found = {way: None if time.monotonic() > until else caught(key, way, reaching) for way in ways(key)}
            return {} if None in found.values() else found

        for key, found in zip(keys, pool.map(one, keys)):
            for way, (test, told, seconds) in found.items():
                print(f"{key}: {test or 'MISSED'} {', '.join(told)} ({seconds:.1f} s)", flush=True)
                if way == "tests":
                    record(key, way, "claims" if test else PASSED, test)
                else:
                    kind = "truth" if set(told) & set(TRUTHS) else PASSED
                    record(key, way, kind, test and f"{test}: {next(iter(told.values()))[0]}".rstrip(": "))
            save()

    def is_open(key, way):
        one = known.get(key, {})
        return key in number_of and key not in listed and (one.get("sources") != digest(bound(every[key])) or one.get(way) in (None, PASSED))

    # By chance: what is interrupted has tried a fair sample.
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        if asked.old:
            both = lambda key: [way for way in ("tests", "checks") if way in before[key]]
            left = lambda: [key for key in drawn if key in number_of and is_old(key) and known[key] is before[key]]
            tried(left(), both, None)
            if left() and (reaching := switched.reach(by_number, pool, asked.longest, until)) is not None:
                tried(left(), both, reaching)
            print(f"{len(left())} are of other sources still", flush=True)
        elif (reaching := switched.reach(by_number, pool, asked.longest, until)) is not None:
            tried([key for key in drawn if is_open(key, "tests")], lambda key: ["tests"], reaching)
            tried([key for key in drawn[:asked.truths] if is_open(key, "checks")], lambda key: ["checks"], reaching)
    switched.clear()
    save()
    if asked.in_diff:
        missed = [key for key, one in known.items() if one["tests"] == PASSED]
        left = [key for key in drawn if key not in known]
        sys.exit("\n".join(["missed:", *missed, "not tried:", *left]) if missed or left else None)


if __name__ == "__main__":
    main()
