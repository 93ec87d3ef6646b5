"""A copy of the tree that is spoiled one place at a time, and which checks of the program then turn red."""
import json
import os
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Only what is spoiled is compiled again.
QUICK = ["--config", "profile.release.incremental=true"]
PATIENCE = 600
# The suite, and the worked scene files.
COMMANDS = [["verdicts"], ["verify", "tests/cases", "--json"]]


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

    def cargo(self, *arguments, **options):
        environment = os.environ | {"CARGO_TARGET_DIR": str(self.build), "INSTA_UPDATE": "no"}
        return subprocess.run(["cargo", *QUICK, *arguments], cwd=self.tree, env=environment, **options)

    def failures(self):
        """The checks that fail on the copy, and how the run ended if not by itself."""
        self.cargo("build", "--release", "--quiet", "--bin", "contact-vv", check=True)
        program = self.build / "release/contact-vv"
        checks = []
        for command in COMMANDS:
            try:
                run = subprocess.run([program, *command], cwd=self.tree, capture_output=True, text=True, timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                return [], f"no end within {PATIENCE} s"
            told = [json.loads(line) for line in run.stdout.splitlines()]
            if not told:
                return [], self.here(run.stderr.strip().splitlines()[0]) if run.stderr.strip() else "no answer"
            checks += told
        # The trial that reads the record of planted faults says nothing about the code.
        told = [check for check in checks if not check["trial"].startswith("planted faults")]
        return [check for check in told if check["verdict"] == "fail"], None

    def here(self, text):
        """A message without the folder of the copy."""
        return text.replace(f"{self.tree}/", "")
