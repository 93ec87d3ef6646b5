"""The record of mutants: which there are, what an entry of `snapshots/mutants.json` says and is bound to, and the scores of folders."""
import collections
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
from watched import ROOT

RECORD = ROOT / "snapshots/mutants.json"
LIST = ROOT / "tests/mutants/survivors.toml"
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
        change = re.sub(r"^.*?:\d+:\d+: ", "", one["name"])
        what = f"{one['file']}: {change}"
        line = (ROOT / one["file"]).read_text().splitlines()[one["span"]["start"]["line"] - 1].strip()
        counts[what, line] += 1
        # The same change of the same text: which of them.
        again = f" ({counts[what, line]})" if counts[what, line] > 1 else ""
        found[f"{what}: {line}{again}"] = one | {"change": change}
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
        "room": name, "mutants": sum(name == room(key) for key in every),
        "unviable": len(current) - len(viable), "equivalent": sum(one["mutant"] in listed for one in viable),
        "by_claims": wilson(sum(is_caught(one) is True for one in tested), len(tested)),
        "by_truths": wilson(sum(one["checks"] == "truth" for one in checked), len(checked)),
        "missed": [[every[one["mutant"]][key] for key in ("file", "change")] for one in tested if is_caught(one) is not True],
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
