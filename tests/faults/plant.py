#!/usr/bin/env python3
"""Plants the faults of faults.toml in a copy of the tree, compiled all at once behind a switch, and records what turns red by each.

Run as `python3 tests/faults/plant.py` (it takes tree-sitter and tree-sitter-rust): what caught a fault before is asked first, seconds each; where
that does not catch it any more, all claims and trials that reach it are, truths first. Names on the command line select the faults whose name
contains one of them, `--old` those that are not of the present sources and tests: of files that differ from `--base` first, then the oldest, for so long as
`--minutes` says once all are compiled. Writes snapshots/faults.json, which the page prints; an entry is bound to its file and those of the claims that caught it.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import sys
import threading
import time
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import changed_since, date, digest
from watched import ROOT
from switched import OF_CLAIMS, TRUTHS, Switched, is_claim
from switch import Spoiled, plant

LIST = ROOT / "tests/faults/faults.toml"
RECORD = ROOT / "snapshots/faults.json"
# Of a fault in the list.
KEYS = ["name", "file", "was", "is", "within"]
# Seconds of a processor beyond which a test is not asked.
LONGEST = 20


def listed():
    faults = tomllib.loads(LIST.read_text())["fault"]
    for fault in faults:
        count = (ROOT / fault["file"]).read_text().count(fault["was"])
        if count != 1:
            sys.exit(f"{fault['file']} holds `{fault['was']}` {count} times, not once: update {LIST.name}")
    return faults


def about(fault):
    return {key: fault[key] for key in KEYS if key in fault}


def bound(fault, by):
    """The file that a fault is planted in, and those of what caught it."""
    of = lambda one: f"tests/cases/{one['case']}" if "case" in one else f"tests/claims/{one['test'].split('::')[0]}.rs"
    files = set(map(of, by))
    return [fault["file"], *sorted(file for file in files if (ROOT / file).is_file())]


def is_there(one):
    """Whether what caught a fault is still asked, as `Caught::is_there` of src/study/faults.rs has it."""
    if one["kind"] not in [*TRUTHS, "self-consistency", "claim"]:
        return True
    if is_claim(one["test"]):
        module, name = one["test"].split("::", 1)
        text = ROOT / f"tests/claims/{module}.rs"
        return OF_CLAIMS.get(one["test"], "claim") == one["kind"] and text.exists() and f"\nfn {name}(" in text.read_text()
    with open(ROOT / "snapshots/checks.csv", newline="") as rows:
        return any(row["case"] in ("every run", one["case"]) and row["quantity"] == one["quantity"] for row in csv.DictReader(rows))


def found(switched, number, tests):
    """The first of some tests that a fault turns red, with what it says by the kind of its reference."""
    test, told, _ = switched.caught_by(number, tests)
    case = {} if test is None or is_claim(test) else {"case": test.split(" × ")[0]}
    asked = lambda quantity: {} if quantity is None else {"quantity": quantity}
    return [{"test": test, "kind": kind, "told": said} | case | asked(quantity) for kind, (said, quantity) in told.items()]


def search(switched, number, reaching, known):
    """What catches a fault: what did before, else the first truth and the first claim."""
    by = [one for name in dict.fromkeys(one["test"] for one in known) for one in found(switched, number, [(name, 0.0)])]
    is_truth = lambda: any(one["kind"] in TRUTHS for one in by)
    if is_truth() or by and known and not any(one["kind"] in TRUTHS for one in known):
        return by
    tests = reaching()
    told = {one["test"] for one in by}
    truths = [one for one in tests if (one[0] in OF_CLAIMS or not is_claim(one[0]) and not one[0].startswith("snapshot")) and one[0] not in told]
    while truths and not is_truth():
        new = found(switched, number, truths)
        by += new
        # A trial may show the code's own contradiction alone: further ones are asked.
        at = next((k for k, one in enumerate(truths) if new and one[0] == new[0]["test"]), len(truths) - 1)
        truths = truths[at + 1:]
    if not by:
        by = found(switched, number, tests)
    return by


def most_telling(by):
    """One test of each kind, the quick ones that were found first."""
    kinds = {}
    for one in by:
        kinds.setdefault(one["kind"], one)
    return list(kinds.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help="parts of names of faults")
    parser.add_argument("--old", action="store_true", help="only those that are not of the present sources")
    parser.add_argument("--base", default="HEAD", help="commit that changed files differ from")
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", type=pathlib.Path, default=LIST, help="another list, of which nothing is recorded")
    asked = parser.parse_args()
    globals()["LIST"] = asked.list
    faults = listed()
    kept = json.loads(RECORD.read_text())["record"] if RECORD.exists() else []
    known = {old["name"]: old for old in kept if about(old) in map(about, faults)}
    is_as_it_was = lambda one: one["sources"] == digest(one["bound"]) and all(map(is_there, one["by"]))
    is_old = lambda fault: fault["name"] not in known or not is_as_it_was(known[fault["name"]])
    chosen = [fault for fault in faults if not asked.names or any(word in fault["name"] for word in asked.names)]
    chosen = [fault for fault in chosen if not asked.old or is_old(fault)]
    if not chosen:
        return print("none is old" if asked.old else "no such fault")
    changed = changed_since(asked.base)
    chosen.sort(key=lambda fault: (fault["file"] not in changed, known.get(fault["name"], {}).get("date") or ""))
    switched = Switched("faults", lambda tree, some: plant(tree, some, Spoiled), ["claims", "suite"])
    switched.kept["refused"] = {}
    by_number = switched.compile({number: fault | {"key": fault["name"]} for number, fault in enumerate(faults, 1)})
    if switched.kept["refused"]:
        sys.exit(f"cannot be compiled: {', '.join(switched.kept['refused'])}")
    until = time.monotonic() + 60 * asked.minutes
    number_of = {one["name"]: number for number, one in by_number.items()}
    red = lambda name: switched.red([name])
    before = sorted({one["test"] for fault in chosen for one in known.get(fault["name"], {}).get("by", [])})
    missed, table, tabling = [], None, threading.Lock()
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        if spoilt := [name for name, one in zip(before, pool.map(red, before)) if one]:
            sys.exit(f"red without a fault: {spoilt}")

        def reaching(fault):
            nonlocal table
            with tabling:
                if table is None:
                    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as others:
                        table = switched.reach(by_number, others, LONGEST)
            return table[fault["name"]]

        if any(not known.get(fault["name"], {}).get("by") for fault in chosen):
            reaching(chosen[0])

        def one(fault):
            if time.monotonic() > until:
                return None
            begin = time.monotonic()
            by = search(switched, number_of[fault["name"]], lambda: reaching(fault), known.get(fault["name"], {}).get("by", []))
            return most_telling(by), time.monotonic() - begin

        for fault, result in zip(chosen, pool.map(one, chosen)):
            if result is None:
                continue
            by, seconds = result
            told = "; ".join(f"{one['kind']}: {one['test']}" for one in by) or "NOT CAUGHT"
            print(f"{fault['name']} ({seconds:.0f} s): {told}", flush=True)
            missed += [] if by else [fault["name"]]
            own = bound(fault, by)
            known[fault["name"]] = about(fault) | {"bound": own, "sources": digest(own), "date": date(), "by": by}
            if not [fault for fault in faults if fault["name"] not in known]:  # after each: what is interrupted keeps what it found
                write([known[fault["name"]] for fault in faults])
    switched.clear()
    if left := [fault["name"] for fault in faults if fault["name"] not in known]:
        print(f"never planted, so nothing is recorded: {', '.join(left)}")
    if missed:
        sys.exit(f"not caught: {', '.join(missed)}")


def write(record):
    if LIST != ROOT / "tests/faults/faults.toml":
        return
    lines = ",\n".join("  " + json.dumps(one, ensure_ascii=False) for one in record)
    RECORD.write_text(f'{{"record": [\n{lines}\n]}}\n')


if __name__ == "__main__":
    main()
