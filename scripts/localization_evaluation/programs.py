"""Runs the package's programs: shows what they are at, and tells how much memory they take."""

import contextlib
import os
import subprocess
import sys
import tempfile
import time

from localization_evaluation.errors import EvaluationError

PERIOD_S = 0.2  # between two looks at a program
BURN = "import os\nparent = os.getppid()\nwhile os.getppid() == parent:\n    for _ in range(1000000):\n        pass"


class Progress:
    """A line on stderr: rewritten on a terminal, else written once when the work begins."""

    def __init__(self, title):
        self._title = title
        self._is_terminal = sys.stderr.isatty()
        if not self._is_terminal:
            print(title, file=sys.stderr, flush=True)

    def update(self, text):
        if self._is_terminal:
            print(f"\r{self._title}: {text}\033[K", end="", file=sys.stderr, flush=True)

    def close(self):
        if self._is_terminal:
            print(file=sys.stderr, flush=True)


def wait(process, progress, describe):
    """Waits for the end; returns the largest resident memory [MB]. `describe(seconds)` says how far it is."""
    begin = time.monotonic()
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage.ru_maxrss * 1024 / 1e6
        progress.update(describe(time.monotonic() - begin))
        time.sleep(PERIOD_S)


def run(program, arguments, title, describe=lambda seconds: f"{seconds:.0f} s"):
    """Runs a program to its end and returns its largest resident memory [MB]. Raises EvaluationError with its last
    line if it fails."""
    progress = Progress(title)
    with tempfile.TemporaryFile("w+") as errors:
        process = start([program, *arguments], stdout=subprocess.DEVNULL, stderr=errors)
        try:
            memory_mb = wait(process, progress, describe)
        finally:
            progress.close()
            stop(process)
        if process.returncode != 0:
            errors.seek(0)
            said = errors.read().strip().splitlines() or [f"{program.name} ended with {process.returncode}"]
            raise EvaluationError(said[-1])
    return memory_mb


def start(command, **options):
    try:
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, **options)
    except OSError as error:
        raise EvaluationError(f"{command[0]}: {error.strerror}; build the package or give --programs") from None


def stop(process):
    if process.returncode is None:
        process.kill()
        process.wait()


def ask(program, *arguments):
    """What a program that takes no time prints. Raises EvaluationError with its last line if it fails."""
    with start([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        output, errors = process.communicate()
    if process.returncode != 0:
        raise EvaluationError((errors.strip().splitlines() or [f"{program.name} ended with {process.returncode}"])[-1])
    return output


@contextlib.contextmanager
def load(count):
    """Keeps `count` cores busy meanwhile."""
    with contextlib.ExitStack() as stack:
        for _ in range(count):
            stack.callback(stop, start([sys.executable, "-c", BURN]))
        yield
