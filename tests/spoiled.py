"""A copy of the tree that is spoiled one place at a time, and which checks of the program then turn red."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Only what is spoiled is compiled again: 3 s, of which optimisation across units takes 30 s; the checks then take twice as long.
QUICK = ["--config", "profile.release.incremental=true", "--config", "profile.release.lto=\"off\""]
# The worked scene files and the suite, each with the seconds of silence after which it is called endless.
COMMANDS = [(["verify", "tests/cases", "--json"], 120), (["verdicts"], 180)]
# Exit code of a panic.
PANIC = 101


class Copy:
    """A copy under target/NAME/tree, built into target/NAME/build."""

    def __init__(self, name):
        self.tree, self.build = ROOT / "target" / name / "tree", ROOT / "target" / name / "build"
        shutil.rmtree(self.tree, ignore_errors=True)
        listed = subprocess.run(
            ["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True
        )
        for name in filter(lambda name: (ROOT / name).is_file(), listed.stdout.splitlines()):
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, self.tree / name)  # with new times: cargo compiles what was left over

    def command(self, *arguments):
        return ["cargo", *QUICK, *arguments]

    def options(self):
        return {"cwd": self.tree, "env": os.environ | {"CARGO_TARGET_DIR": str(self.build), "INSTA_UPDATE": "no"}}

    def compiles(self, *arguments):
        return subprocess.run(self.command(*arguments), **self.options(), capture_output=True).returncode == 0

    def program(self):
        """Compiles the program; tells whether it could be."""
        return self.compiles("build", "--release", "--quiet", "--bin", "contact-vv")

    def failures(self, enough=lambda check: False):
        """Checks of the compiled program that fail, or the first that is enough, and how it ended if not by itself."""
        failing, ended = [], None
        for arguments, patience in COMMANDS:
            run = Run([self.build / "release/contact-vv", *arguments], patience, **self.options())
            told = False
            for line in run.lines():
                told, check = True, json.loads(line)
                # The trial that reads the record of planted faults says nothing about the code.
                if check["verdict"] == "fail" and not check["trial"].startswith("planted faults"):
                    failing.append(check)
                    if enough(check):
                        return [check], ended
            broken = run.broken() or (None if told else "no answer")
            ended = ended or (broken and self.here(broken))
            if run.late:
                break
        # They are printed as the trials end.
        return sorted(failing, key=lambda check: (check["trial"], check["requirement"])), ended

    def here(self, text):
        """A message without the folder of the copy."""
        return text.replace(f"{self.tree}/", "")


class Run:
    """A command that is read line by line as it prints, and stopped where no more is asked of it or it falls silent."""

    def __init__(self, command, patience, **options):
        self.patience, self.late, self.heard, self.over = patience, False, time.monotonic(), threading.Event()
        self.errors = tempfile.TemporaryFile("w+", errors="replace")
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=self.errors, text=True, errors="replace", start_new_session=True, **options
        )

    def lines(self):
        threading.Thread(target=self.watch, daemon=True).start()
        try:
            for line in self.process.stdout:
                self.heard = time.monotonic()
                yield line
            self.process.wait()
        finally:
            self.over.set()
            self.stop()

    def watch(self):
        while not self.over.wait(1):
            if time.monotonic() > self.heard + self.patience:
                self.late = True
                return self.stop()

    def stop(self):
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()

    def broken(self):
        """How it ended if not by itself: silent, by a panic or by a signal."""
        if self.late:
            return f"silent for {self.patience} s"
        if 0 <= self.process.returncode != PANIC:
            return None
        self.errors.seek(0)
        said = [line for line in self.errors.read().splitlines() if line.strip()]
        # Numbers of threads and processes differ from run to run.
        return re.sub(r" \(\d+\)", "", said[0]) if said else f"signal {-self.process.returncode}"
