"""A command that is read while it runs, and stopped where it falls silent."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Exit code of a panic.
PANIC = 101


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
