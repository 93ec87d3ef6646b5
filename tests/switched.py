"""A tree in which many changes are compiled at once, each behind a switch that the environment turns, and the tests that reach them.

Mutants (`mutants/room.py`) and planted faults (`faults/plant.py`) are both tried so: one build, then seconds each. A test is a claim where its
name has `::`, else a trial of the suite.
"""
import collections
import hashlib
import itertools
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
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "mutants"))
from watched import ROOT, Run
from switch import MOST, SWITCH, refused

CRATES = ["src/lib.rs", "src/solver/lib.rs", "src/drawing/lib.rs"]
# What is compiled quicker than it saves time, for a few tests of each change.
SETTINGS = {"contact-vv.opt-level": 0, "contact-vv-drawing.opt-level": 0, "signorini.opt-level": 2, "signorini.codegen-units": 16}
QUICK = [word for key, value in SETTINGS.items() for word in ("--config", f"profile.release.package.{key}={value}")]
# Silence after which a test is called endless, and seconds of claims that are run together.
PATIENCE, TOGETHER = 300, [2, 10, 60, 1e9]
# Bytes and seconds of a processor that a change may take: seconds of a clock are many where others work.
MEMORY, PROCESSOR = 6 << 30, 120
# Kinds of references that are not the code's own.
TRUTHS = ["analytic", "cross-code", "measured"]
# Which claims hold a number against a truth, and which.
OF_CLAIMS = {claim: kind for kind, claims in tomllib.loads((ROOT / "tests/truths.toml").read_text()).items() for claim in claims}


def is_claim(name):
    return "::" in name


def limited(processor):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (processor, processor))


class Switched:
    """A copy under target/switched/NAME, and what is known of it; `planted` writes changes into a tree and returns their sources."""

    def __init__(self, name, planted, targets, modules=("",), fresh=False):
        self.place, self.planted, self.targets, self.modules = ROOT / "target/switched" / name, planted, targets, modules
        # Claims start the program that lies where it was built.
        self.tree, self.build, self.file = self.place / "tree", self.place / "build", self.place / "kept.json"
        self.place.mkdir(parents=True, exist_ok=True)
        self.kept = {"refused": {}, "reach": {}, "found": {}, "files": {}}
        if self.file.exists() and not fresh:
            self.kept = json.loads(self.file.read_text())
        self.options = {"cwd": self.tree, "env": os.environ | {"CARGO_TARGET_DIR": str(self.build), "INSTA_UPDATE": "no"}}

    def save(self):
        self.file.write_text(json.dumps(self.kept, indent=0))

    def needed(self):
        """The modules of claims whose names begin as is asked, with those that they use."""
        own = {path.stem: path.read_text() for path in (ROOT / "tests/claims").glob("*.rs")}
        modules = tuple(name.split("::")[0] for name in self.modules)
        found, left = set(), [name for name in own if name.startswith(modules) and name != "main"]
        while left:
            name = left.pop()
            if name in own and name not in found:
                found.add(name)
                left += re.findall(r"\bcrate::\{?(\w+)", own[name])
        return found

    def written(self, chosen):
        """Writes the tree with all changes, of which only files that differ are touched; returns their sources."""
        staged = self.place / "staged"
        listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True)
        files = [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]
        for place in [staged, self.tree]:
            gone = {path.relative_to(place).as_posix() for path in place.rglob("*.rs")} - set(files)
            [(place / name).unlink() for name in gone]
        for name in files:
            (staged / name).parent.mkdir(parents=True, exist_ok=True)
            (staged / name).write_bytes((ROOT / name).read_bytes())
        sources = self.planted(staged, chosen)
        for crate in CRATES:
            (staged / crate).write_text((staged / crate).read_text() + SWITCH.replace("MUTANTS]", f"{MOST}]"))
        # Of the claims only what is asked for is compiled.
        main, wanted = staged / "tests/claims/main.rs", self.needed()
        left_out = lambda one: one[1] not in wanted and self.modules != ("",)
        main.write_text(re.sub(r"(?:#\[.*\]\n)*mod (\w+);\n", lambda one: "" if left_out(one) else one[0], main.read_text()))
        for name in files:
            new, to = (staged / name).read_bytes(), self.tree / name
            to.parent.mkdir(parents=True, exist_ok=True)
            if not to.exists() or to.read_bytes() != new:
                to.write_bytes(new)
        return sources

    def compile(self, all_of_them):
        """Compiles what can be of some changes by number; returns those in it."""
        if not self.build.exists() and (ROOT / "target/release").exists():
            # Dependencies are compiled the same way.
            self.build.mkdir()
            subprocess.run(["cp", "-al", ROOT / "target/release", self.build], check=True)
            # One lock for both would let each wait for the other.
            (self.build / "release/.cargo-lock").unlink(missing_ok=True)
        tests = [word for target in self.targets for word in ("--test", target)]
        command = ["cargo", *QUICK, "test", "--release", "--no-run", *tests]
        while True:
            chosen = {number: one for number, one in all_of_them.items() if one["key"] not in self.kept["refused"]}
            sources = self.written(chosen)
            done = set().union(*(source.done for source in sources.values()))
            found = refused(command, self.options, sources)
            for numbers, why in zip(found or (), ["unviable", "left out"]):
                self.kept["refused"].update({chosen[number]["key"]: why for number in numbers})
            if found is None:
                break
            print(f"refused: {len(found[0])} of themselves, {len(found[1])} for their place", flush=True)
            self.save()
        told = subprocess.run([*command, "--message-format=json"], **self.options, check=True, capture_output=True, text=True)
        built = [json.loads(line) for line in told.stdout.splitlines()]
        # What is compiled meanwhile does not change them.
        self.programs = {
            one["target"]["name"]: shutil.copy2(one["executable"], self.place / f"{one['target']['name']}-{os.getpid()}")
            for one in built if one.get("executable") and one["target"]["name"] in self.targets
        }
        return {number: one for number, one in chosen.items() if number in done}

    def clear(self):
        for program in self.programs.values():
            pathlib.Path(program).unlink()

    def names(self):
        """All tests that may tell something of a change."""
        listed = []
        for program in self.programs.values():
            told = subprocess.run([program, "--list"], **self.options, check=True, capture_output=True, text=True)
            listed += [line.removesuffix(": test") for line in told.stdout.splitlines() if line.endswith(": test")]
        return [name for name in listed if name.startswith(self.modules) and not name.startswith(("architecture", "faults::", "planted faults"))
                and name != "every snapshot belongs to a run of the suite"]

    def red(self, names, processor=PROCESSOR, **environment):
        """The first of some tests that fails, or how they broke off, and by the kind of its reference what it says and of which quantity; none where all pass."""
        options = self.options | {"env": self.options["env"] | environment, "preexec_fn": lambda: limited(processor)}
        program = self.programs["claims" if is_claim(names[0]) else "suite"]
        run = Run([program, "--exact", "--test-threads=1", *names], PATIENCE, **options)
        last, failed, said = None, None, []
        for line in run.lines():
            said.append(line.rstrip())
            if told := re.match(r"test (.*?)\s+\.\.\.", line):
                last = told[1]
            if re.search(r"(\.\.\. |^)FAILED\s*$", line):
                failed = last
                if is_claim(failed):
                    return failed, {OF_CLAIMS.get(failed, "claim"): ("", None)}
        if failed:
            kinds = {}
            for line, next_line in itertools.pairwise(said):
                if told := re.match(rf"({'|'.join(TRUTHS)}|self-consistency): (.*)", line):
                    kinds.setdefault(told[1], (told[2], next_line.strip().removeprefix("quantity: ")))
            at = said.index(f"---- {failed} ----") if f"---- {failed} ----" in said else -1
            kind = "snapshot" if failed.startswith("snapshot") else "broken off"
            return failed, kinds or {kind: (said[at + 1].replace(f"{self.tree}/", ""), None)}
        if run.broken() or run.process.returncode:
            return last or names[0], {"broken off": ((run.broken() or "it broke off").replace(f"{self.tree}/", ""), None)}
        return None

    def reach(self, by_number, pool, longest, until=math.inf):
        """Which changes each test reaches and in what time; none where there is no time to know. What is known is not run again."""
        names = self.names()
        text = lambda name: ROOT / "tests/claims" / f"{name.split('::')[0]}.rs"
        mark = lambda name: hashlib.sha256(text(name).read_bytes()).hexdigest()[:16] if text(name).exists() else ""

        def record(name):
            if time.monotonic() > until:
                return None
            with tempfile.NamedTemporaryFile("r", suffix=".reached") as log:
                begin = time.monotonic()
                red = self.red([name], longest, MUTANT_LOG=log.name)
                seconds = time.monotonic() - begin
                numbers = {int(number) for number in log.read().split()}
            return {"mark": mark(name), "seconds": seconds, "red": red and str(red), "reached": sorted(by_number[n]["key"] for n in numbers if n in by_number)}

        if keys := {one["key"] for one in by_number.values()} - set(self.kept.get("keys", [])):
            self.kept |= {"reach": {}, "keys": sorted(keys | set(self.kept.get("keys", [])))}
        known = self.kept["reach"] = {
            name: one for name, one in self.kept["reach"].items() if name in names and one["mark"] == mark(name) and not one["red"]}
        left = [name for name in names if name not in known]
        for name, one in zip(left, pool.map(record, left)):
            if one:
                known[name] = one
                self.save()
        if len(known) < len(names):
            return None
        reaching = collections.defaultdict(list)
        for name, one in sorted(known.items(), key=lambda item: item[1]["seconds"]):
            for key in () if one["red"] else one["reached"]:
                reaching[key].append((name, one["seconds"]))
        return reaching

    def caught_by(self, number, tests):
        """The first test that turns red by a change, quick ones first, what it says, and the seconds it took."""
        begin, spent, together = time.monotonic(), 0.0, []
        limits = iter(TOGETHER)
        limit = next(limits)
        for name, seconds in [*tests, (None, 0.0)]:
            alone = together and not (name and is_claim(name) and is_claim(together[-1][0]))
            if together and (alone or spent + seconds > limit):
                if found := self.red([name for name, _ in together], MUTANT=str(number)):
                    return *found, time.monotonic() - begin
                spent, together, limit = 0.0, [], next(limits, 1e9) if not alone else limit
            together.append((name, seconds))
            spent += seconds
        return None, {}, time.monotonic() - begin
