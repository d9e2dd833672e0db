"""What goes wrong for reasons that the user can mend."""

import pathlib
import sys


class TrainingError(Exception):
    """One line that names the thing, its value and what was expected."""


def one_line(error):
    """An error's message; of one in a process that reads images, which comes as a traceback, the last line."""
    last = str(error).strip().splitlines()[-1]
    return last.removeprefix(f"{TrainingError.__module__}.{TrainingError.__name__}: ")


def run_command(main):
    """Runs a command's `main`; a TrainingError ends it with one line and exit code 1."""
    name = pathlib.Path(sys.argv[0]).name
    try:
        main()
    except (TrainingError, OSError) as error:
        sys.exit(f"{name}: {one_line(error)}")
    except KeyboardInterrupt:
        sys.exit(f"{name}: interrupted")
