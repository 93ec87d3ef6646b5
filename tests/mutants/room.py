#!/usr/bin/env python3
"""Tries all mutants of a folder by the claims that reach them, compiled at once (`switch.py`): seconds each instead of minutes.

Run as `python3 tests/mutants/room.py src/referee src/solver/accuracy`; it takes cargo-mutants, tree-sitter and tree-sitter-rust. What it found
before stays while the file of a mutant does, what was missed is tried again; `--fresh` forgets all. Writes `rooms` into snapshots/mutants.json.
"""
import argparse
import collections
import concurrent.futures
import functools
import hashlib
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

from run import RECORD, SOURCES, mutants, survivors, wilson
from switch import plant, refused

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import digest
from spoiled import ROOT, Run

PLACE = ROOT / "target/switched"
TREE, BUILD, KEPT = PLACE / "tree", PLACE / "build", PLACE / "kept.json"
CRATES = ["src/lib.rs", "src/solver/lib.rs"]
OPTIONS = {"cwd": TREE, "env": os.environ | {"CARGO_TARGET_DIR": str(BUILD), "INSTA_UPDATE": "no"}}
# What is compiled quicker than it saves time, for a few claims of each mutant.
SETTINGS = {"contact-vv.opt-level": 0, "contact-vv-drawing.opt-level": 0, "signorini.opt-level": 2, "signorini.codegen-units": 16}
QUICK = [word for key, value in SETTINGS.items() for word in ("--config", f"profile.release.package.{key}={value}")]
# Silence after which a claim is called endless, and seconds of claims that are run together.
PATIENCE, TOGETHER = 300, [2, 10, 60, 1e9]
# Bytes and seconds of a processor that a mutant may take: seconds of a clock are many where others work.
MEMORY, PROCESSOR = 6 << 30, 60


def needed(modules):
    """The modules of claims whose names begin so, with those that they use."""
    own = {path.stem: path.read_text() for path in (ROOT / "tests/claims").glob("*.rs")}
    modules = tuple(name.split("::")[0] for name in modules)
    found, left = set(), [name for name in own if name.startswith(modules) and name != "main"]
    while left:
        name = left.pop()
        if name in own and name not in found:
            found.add(name)
            left += re.findall(r"\bcrate::\{?(\w+)", own[name])
    return found


def written(chosen, modules):
    """The tree with all mutants, of which only files that changed are written; and their sources."""
    staged = PLACE / "staged"
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True)
    files = [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]
    for name in files:
        (staged / name).parent.mkdir(parents=True, exist_ok=True)
        (staged / name).write_bytes((ROOT / name).read_bytes())
    sources = plant(staged, chosen, CRATES)
    # Of the claims only what is asked for is compiled.
    main, wanted = staged / "tests/claims/main.rs", needed(modules)
    left_out = lambda one: one[1] not in wanted and modules != ("",)
    main.write_text(re.sub(r"(?:#\[.*\]\n)*mod (\w+);\n", lambda one: "" if left_out(one) else one[0], main.read_text()))
    for name in files:
        new, to = (staged / name).read_bytes(), TREE / name
        to.parent.mkdir(parents=True, exist_ok=True)
        if not to.exists() or to.read_bytes() != new:
            to.write_bytes(new)
    return sources


def compiled(all_of_them, kept, modules):
    """Compiles what can be of some mutants; returns the program of claims, and the mutants in it by number."""
    command = ["cargo", *QUICK, "test", "--release", "--no-run", "--test", "claims"]
    while True:
        chosen = {number: one for number, one in all_of_them.items() if one["key"] not in kept["refused"]}
        sources = written(chosen, modules)
        done = set().union(*(source.done for source in sources.values()))
        found = refused(command, OPTIONS, sources)
        for numbers, why in zip(found or (), ["unviable", "left out"]):
            kept["refused"].update({chosen[number]["key"]: why for number in numbers})
        if found is None:
            break
        print(f"refused: {len(found[0])} mutants, {len(found[1])} for their place", flush=True)
        save(kept)
    told = subprocess.run([*command, "--message-format=json"], **OPTIONS, check=True, capture_output=True, text=True)
    built = map(json.loads, told.stdout.splitlines())
    program = next(one["executable"] for one in built if one.get("target", {}).get("name") == "claims" and one.get("executable"))
    # What is compiled meanwhile does not change it.
    program = shutil.copy2(program, PLACE / f"claims-{os.getpid()}")
    return program, {number: one for number, one in chosen.items() if number in done}


def save(kept):
    KEPT.write_text(json.dumps(kept, indent=0))


def limited(processor):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (processor, processor))


def claim(program, names, processor=PROCESSOR, **environment):
    """The first of some claims that fails, or how they broke off; none where all pass."""
    options = OPTIONS | {"env": OPTIONS["env"] | environment, "preexec_fn": lambda: limited(processor)}
    run = Run([program, "--exact", "--test-threads=1", *names], PATIENCE, **options)
    last = None
    for line in run.lines():
        if told := re.match(r"test (\S+) ", line):
            last = told[1]
        if failed := re.match(r"test (.*?)\s.*FAILED$|^FAILED$", line.strip()):
            return failed[1] or last
    return f"{last}: {run.broken()}" if run.broken() else ("it broke off" if run.process.returncode else None)


def reach(program, by_number, kept, pool, modules, longest):
    """Which mutants each claim reaches and in what time; of those that are known only what has changed is run."""
    listed = subprocess.run([program, "--list"], **OPTIONS, check=True, capture_output=True, text=True)
    names = [line.removesuffix(": test") for line in listed.stdout.splitlines() if line.endswith(": test")]
    text = lambda name: ROOT / "tests/claims" / f"{name.split('::')[0]}.rs"
    mark = lambda name: hashlib.sha256(text(name).read_bytes()).hexdigest()[:16] if text(name).exists() else ""

    def record(name):
        with tempfile.NamedTemporaryFile("r", suffix=".reached") as log:
            begin = time.monotonic()
            red = claim(program, [name], longest, MUTANT_LOG=log.name)
            seconds = time.monotonic() - begin
            numbers = {int(number) for number in log.read().split()}
        return {"mark": mark(name), "seconds": seconds, "red": red, "reached": sorted(by_number[n]["key"] for n in numbers if n in by_number)}

    known = kept["reach"] = {name: one for name, one in kept["reach"].items() if name in names and one["mark"] == mark(name) and not one["red"]}
    left = [name for name in names if name not in known and name.startswith(modules) and not name.startswith("architecture")]
    for name, one in zip(left, pool.map(record, left)):
        known[name] = one
        save(kept)
    return {name: one for name, one in known.items() if not one["red"]}


def caught_by(program, number, claims):
    """The first claim that turns red by a mutant, of those that reach it, quick ones first."""
    begin, spent, together = time.monotonic(), 0.0, []
    limits = iter(TOGETHER)
    limit = next(limits)
    for name, seconds in [*claims, (None, 0.0)]:
        if together and (name is None or spent + seconds > limit):
            if red := claim(program, [name for name, _ in together], MUTANT=str(number)):
                return red, time.monotonic() - begin
            spent, together, limit = 0.0, [], next(limits, 1e9)
        together.append((name, seconds))
        spent += seconds
    return None, time.monotonic() - begin


def tried(program, by_number, kept, claims, pool, order, until):
    """Tries every mutant that is not known as caught, up to a time."""
    reaching = collections.defaultdict(list)
    for name, one in sorted(claims.items(), key=lambda item: item[1]["seconds"]):
        for key in one["reached"]:
            reaching[key].append((name, one["seconds"]))
    left = [number for number, one in by_number.items() if not kept["found"].get(one["key"], {}).get("by")]
    # By chance: what is interrupted has tried a fair sample.
    left.sort(key=lambda number: order(by_number[number]["key"]))
    late = lambda: time.monotonic() > until
    results = pool.map(lambda number: None if late() else caught_by(program, number, reaching[by_number[number]["key"]]), left)
    for number, result in zip(left, results):
        if result is None:
            continue
        key, (red, seconds) = by_number[number]["key"], result
        kept["found"][key] = {"by": red, "seconds": round(seconds, 1), "claims": len(reaching[key])}
        print(f"{key}: {red or 'MISSED'} ({seconds:.1f} s, {len(reaching[key])} claims)", flush=True)
        save(kept)


def told(room, every, kept, listed):
    """The score of a folder."""
    own = [key for key in every if key.startswith(room + "/")]
    refusals = collections.Counter(kept["refused"].get(key) for key in own)
    found = [key for key in own if key in kept["found"]]
    counted = [key for key in found if kept["found"][key]["by"] or key not in listed]
    missed = [key for key in counted if not kept["found"][key]["by"]]
    return {
        "room": room, "sources": digest(SOURCES), "mutants": len(own), "unviable": refusals["unviable"],
        "not_tried": len(own) - len(found) - refusals["unviable"], "equivalent": len(found) - len(counted),
        "by_claims": wilson(len(counted) - len(missed), len(counted)), "missed": missed,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+", help="folders, or files")
    parser.add_argument("--sample", type=int, help="so many of them, by chance")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fresh", action="store_true", help="forget what was found before")
    parser.add_argument("--claims", default="", help="only claims whose names, with those of their modules, begin so, separated by commas")
    parser.add_argument("--longest", type=int, default=20, help="leave out claims that take more seconds of a processor")
    parser.add_argument("--minutes", type=float, default=math.inf, help="try no more mutants after this time")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    until = time.monotonic() + 60 * asked.minutes
    PLACE.mkdir(parents=True, exist_ok=True)
    kept = {"refused": {}, "reach": {}, "found": {}, "files": {}}
    if KEPT.exists() and not asked.fresh:
        kept = json.loads(KEPT.read_text())
    every = mutants()
    listed = survivors(every)
    order = lambda key: hashlib.sha256(f"{asked.seed} {key}".encode()).digest()
    rooms = [room.rstrip("/") for room in asked.rooms]
    drawn = sorted((key for key in every if key.startswith(tuple(rooms)) and key not in listed), key=order)[:asked.sample]
    now = functools.cache(lambda file: hashlib.sha256((ROOT / file).read_bytes()).hexdigest())
    for key in list(kept["found"]):
        if key not in every or kept["files"].get(every[key]["file"]) != now(every[key]["file"]):
            del kept["found"][key]
    changed = tuple(f"{file}:" for file, mark in kept["files"].items() if not (ROOT / file).exists() or now(file) != mark)
    kept["reach"] = {name: one for name, one in kept["reach"].items() if not any(key.startswith(changed) for key in one["reached"])}
    kept["files"] = {every[key]["file"]: now(every[key]["file"]) for key in drawn} | {
        file: mark for file, mark in kept["files"].items() if (ROOT / file).exists() and now(file) == mark}
    modules = tuple(asked.claims.split(","))
    program, by_number = compiled({number: every[key] | {"key": key} for number, key in enumerate(sorted(drawn), 1)}, kept, modules)
    print(f"{len(drawn)} mutants, of which {len(by_number)} are compiled", flush=True)
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        claims = reach(program, by_number, kept, pool, modules, asked.longest)
        tried(program, by_number, kept, claims, pool, order, until)
    pathlib.Path(program).unlink()
    record = json.loads(RECORD.read_text())
    others = [one for one in record.get("rooms", []) if one["room"] not in rooms]
    record["rooms"] = sorted([*others, *(told(room, every, kept, listed) for room in rooms)], key=lambda one: one["room"])
    RECORD.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n")
    print(json.dumps([{key: one[key] for key in one if key != "missed"} for one in record["rooms"]], indent=1))


if __name__ == "__main__":
    main()
