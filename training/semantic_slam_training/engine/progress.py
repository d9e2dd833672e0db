"""Says how far training is: a line that is rewritten on a terminal, else a line now and then."""

import sys
import time

BAR_WIDTH = 20
LINE_EVERY_S = 60.0


def duration(seconds):
    minutes = int(seconds // 60)
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes}:{int(seconds % 60):02d} min"


class Progress:
    """Of the steps from `first` to `last`."""

    def __init__(self, first, last, out=None):
        self.first, self.last = first, last
        self.out = out or sys.stderr
        self.begin = time.monotonic()
        self.last_line = self.begin
        self.on_terminal = self.out.isatty()

    def text(self, step, words):
        seconds = (time.monotonic() - self.begin) / max(step - self.first, 1)
        filled = BAR_WIDTH * step // max(self.last, 1)
        bar = "#" * filled + "." * (BAR_WIDTH - filled)
        return (f"[{bar}] step {step}/{self.last}  {words}  {seconds:.2f} s/step, "
                f"{duration(seconds * (self.last - step))} left")

    def show(self, step, words):
        if self.on_terminal:
            print(f"\r{self.text(step, words)}\033[K", end="", file=self.out, flush=True)
        elif time.monotonic() - self.last_line >= LINE_EVERY_S:
            self.last_line = time.monotonic()
            print(self.text(step, words), file=self.out, flush=True)

    def say(self, line):
        """A line that stays."""
        print(f"\r{line}\033[K" if self.on_terminal else line, file=self.out, flush=True)
