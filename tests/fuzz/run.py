#!/usr/bin/env python3
"""Runs the fuzz targets of the readers by libFuzzer and records what they found in snapshots/fuzz.json.

Run as `python3 tests/fuzz/run.py [TARGET…]` with a stable toolchain and a C++ compiler; a million executions of each target,
`--executions N` for another number. `--old` tries those alone whose readers have changed since, the oldest first,
`--minutes` for so long once the first is built: what was not executed often enough is not recorded, and goes on the next time. `--keep` then copies the smallest input of each kind of answer into the corpus.
"""
import argparse
import hashlib
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from digest import date, digest

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / "tests/fuzz"
WORK = ROOT / "target/fuzz"
RECORD = ROOT / "snapshots/fuzz.json"
# What an entry is bound to: the reader that a target calls, and the target.
READERS = {
    "scene": ["src/case/file", "src/solver/scene", "src/solver/mesh"],
    "mesh": ["src/case/file/mesh_file", "src/solver/mesh/given.rs", "src/solver/scene/given.rs"],
    "answers": ["src/oracle/cross_code/frozen.rs", "src/study/differences.rs"],
    "curve": ["src/oracle/digitised"],
    "handed": ["src/referee"],
}
# Seeds besides the corpus, and the longest input in bytes.
TARGETS = {
    "scene": (["tests/cases"], 3000),
    "mesh": (["tests/cases/meshes/rings-coarse.msh"], 6000),
    "answers": ([], 3000),
    "curve": (["tests/data/digitised-synthetic/semi-ellipse.csv"], 2000),
    "handed": ([], 24000),
}
# What `cargo fuzz` gives rustc for libFuzzer, but for what needs another toolchain.
COVERAGE = ["--cfg", "fuzzing", "-Cpasses=sancov-module", "-Ccodegen-units=1"] + [
    f"-Cllvm-args=-sanitizer-coverage-{what}"
    for what in ("level=4", "inline-8bit-counters", "pc-table", "trace-compares")
]
# Seconds after which an input is called a hang, and megabytes after which it takes too much memory.
PATIENCE, MEMORY = 10, 2048
# Seconds that are left where a target is begun.
LEAST = 10
# Crashes after which a target is given up.
ENOUGH = 20
# Files of the corpus by --keep, of a target.
KEPT = 20


def bound(target):
    """What an entry is bound to: the reader, and the function that calls it."""
    [head] = re.findall(rf"^pub fn {target}\(.*$", (HERE / "read.rs").read_text(), re.MULTILINE)
    return [*READERS[target], f"tests/fuzz/read.rs: {head}"]


def build(targets):
    host = re.search(r"host: (\S+)", output("rustc", "-vV"))[1]
    environment = os.environ | {"RUSTFLAGS": " ".join(COVERAGE), "CARGO_TARGET_DIR": str(WORK / "build")}
    # With a target named, build scripts are compiled without coverage.
    only = [word for target in targets for word in ("--bin", target)]
    subprocess.run(["cargo", "build", "--release", "--quiet", "--target", host, *only], cwd=HERE, env=environment, check=True)
    return WORK / "build" / host / "release"


def output(*command):
    return subprocess.run(command, cwd=HERE, check=True, capture_output=True, text=True).stdout


def seeds(target):
    """Files that a run begins with: the corpus, and files that are in the repository anyway."""
    paths = [HERE / "corpus" / target] + [ROOT / name for name in TARGETS[target][0]]
    files = [file for path in paths for file in (sorted(path.iterdir()) if path.is_dir() else [path])]
    return [file for file in files if file.is_file() and file.name != "README.md"]


def told_by(command, **more):
    """What a target prints; the files it writes are in memory where there is such a place, and gone afterwards."""
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as place:
        return subprocess.run(command, cwd=WORK, env=os.environ | {"TMPDIR": place} | more, capture_output=True, text=True,
                              errors="replace")


def dictionary(target):
    """A file of the words that the seeds and the README of scene files use."""
    texts = [file.read_text(errors="replace") for file in seeds(target)]
    texts += re.findall(r"```toml\n(.*?)```", (ROOT / "tests/cases/README.md").read_text(), re.DOTALL) if target == "scene" else []
    words = sorted({word for text in texts for word in re.findall(r"[a-zA-Z$][a-zA-Z-]+", text)})
    file = WORK / f"{target}.words"
    file.write_text("".join(f'"{word}"\n' for word in words + [" = ", "[[body]]\\x0a", "{ ", " }", "[", "]", "1e308", "-1", "nan"]))
    return file


def fuzz(program, target, executions, seed, until, made):
    """Runs a target until it has made so many executions, or up to a time; every input that broke it is kept beside the corpus."""
    grown, broken = WORK / "corpus" / target, WORK / "broken" / target
    for folder in (grown, broken):
        folder.mkdir(parents=True, exist_ok=True)
    for file in seeds(target):
        (grown / hashlib.sha256(file.read_bytes()).hexdigest()).write_bytes(file.read_bytes())
    breaks = []
    while made < executions and len(breaks) < ENOUGH and (seconds := until - time.monotonic()) > 1:
        command = [program / target, grown, f"-runs={executions - made}", f"-seed={seed + len(breaks)}",
                   f"-max_len={TARGETS[target][1]}", f"-timeout={PATIENCE}", f"-rss_limit_mb={MEMORY}",
                   f"-dict={dictionary(target)}", f"-artifact_prefix={broken}/", "-print_final_stats=1", "-close_fd_mask=1",
                   *([f"-max_total_time={int(seconds)}"] if seconds < math.inf else [])]
        run = told_by(command)
        counted = re.search(r"stat::number_of_executed_units:\s+(\d+)", run.stderr)
        if not counted:
            sys.exit(f"{target} ended with {run.returncode}:\n{run.stderr[-2000:]}")
        made += int(counted[1])
        found = re.findall(r"Test unit written to (\S+)", run.stderr)
        breaks += found
        for file in found:
            print(f"{target}: {file}\n{reason(run.stderr)}", flush=True)
        if not found and run.returncode:
            sys.exit(f"{target} ended with {run.returncode} and no input that broke it:\n{run.stderr[-2000:]}")
    last = re.findall(r"cov: (\d+) ft: (\d+) corp: (\d+)", run.stderr)[-1]
    edges = re.search(r"Loaded 1 PC tables \((\d+) PCs\)", run.stderr)[1]
    keys = ["edges_covered", "features", "corpus", "edges_instrumented"]
    return {"target": target, "executions": made, "seed": seed} | dict(zip(keys, map(int, [*last, edges]))) | {
        "broke": len(breaks)}


def reason(text):
    """What the program said when it broke."""
    lines = [line for line in text.splitlines() if "panicked" in line or "ERROR: libFuzzer" in line]
    at = text.find("panicked")
    return text[at:at + 400] if at >= 0 else "\n".join(lines)


def keep(program, target):
    """Copies the smallest input of each kind of answer into the corpus: answers that differ in numbers and names are of a kind."""
    files = sorted((WORK / "corpus" / target).iterdir(), key=lambda file: (file.stat().st_size, file.name))
    smallest = {}
    for begin in range(0, len(files), 500):
        some = files[begin:begin + 500]
        run = told_by([program / target, *some], CONTACT_VV_TELL="1")
        told = re.findall(r"^told: (.*)$", run.stdout, re.MULTILINE)
        if len(told) != len(some):
            sys.exit(f"{target}: {len(told)} answers to {len(some)} inputs")
        for file, answer in zip(some, told):
            smallest.setdefault(re.sub(r"`[^`]*`|\"[^\"]*\"|[-+]?[0-9][0-9.e+-]*", "…", answer), file)
    folder = HERE / "corpus" / target
    # What is read, and refusals of short and of long inputs.
    refused = [file for kind, file in smallest.items() if kind != "read"]
    chosen = [smallest[kind] for kind in ("read",) if kind in smallest] + refused[::-(-len(refused) // KEPT)]
    for old in folder.iterdir():
        if re.fullmatch("[0-9a-f]{16}", old.name):
            old.unlink()
    for file in chosen:
        name = hashlib.sha256(file.read_bytes()).hexdigest()[:16]
        if not any(seed.read_bytes() == file.read_bytes() for seed in seeds(target)):
            (folder / name).write_bytes(file.read_bytes())
    print(f"{target}: {len(files)} inputs, {len(smallest)} kinds of answers, {len(list(folder.iterdir()))} files in the corpus")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("targets", nargs="*", choices=[[], *TARGETS])
    parser.add_argument("--executions", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--old", action="store_true", help="only targets whose readers have changed since")
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--keep", action="store_true", help="only choose files of the corpus from what a run has grown")
    wanted = parser.parse_args()
    chosen = wanted.targets or list(TARGETS)
    if wanted.keep:
        program = build(chosen)
        for target in chosen:
            keep(program, target)
        return
    kept = {one["target"]: one for one in json.loads(RECORD.read_text())["record"]} if RECORD.exists() else {}
    version = re.search(r'name = "libfuzzer-sys"\nversion = "(.*)"', (HERE / "Cargo.lock").read_text())[1]
    by = {"program": f"libFuzzer of libfuzzer-sys {version}", "rustc": output("rustc", "--version").split()[1]}
    if wanted.old:
        chosen = [target for target in chosen if kept.get(target, {}).get("sources") != digest(bound(target))]
        chosen.sort(key=lambda target: kept.get(target, {}).get("date") or "")
    if not chosen:
        return print("none is old")
    tried, until = [], None
    for target in chosen:
        if until and until - time.monotonic() < LEAST:
            break
        program = build([target])
        until = until or time.monotonic() + 60 * wanted.minutes
        tried.append(target)
        begun, sources = WORK / f"{target}.begun.json", digest(bound(target))
        before = json.loads(begun.read_text()) if begun.exists() else {}
        made = before["executions"] if before.get("sources") == sources else 0
        found = fuzz(program, target, wanted.executions, wanted.seed, until, made)
        if found["executions"] < wanted.executions and not found["broke"]:
            begun.write_text(json.dumps({"executions": found["executions"], "sources": sources}))
            print(f"{target}: {found['executions']} of {wanted.executions} executions, which go on the next time", flush=True)
            continue
        begun.unlink(missing_ok=True)
        kept[target] = found | by | {"bound": bound(target), "sources": digest(bound(target)), "date": date()}
        print(f"{target}: {found}", flush=True)
        record = [kept[target] for target in TARGETS if target in kept]
        RECORD.write_text(json.dumps({"record": record}, indent=1, ensure_ascii=False) + "\n")
    if any(kept.get(target, {}).get("broke") for target in tried):
        sys.exit(f"inputs that broke a reader are in {WORK / 'broken'}: mend it and keep them in tests/fuzz/corpus")


if __name__ == "__main__":
    main()
