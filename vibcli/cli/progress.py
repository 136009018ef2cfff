"""The line on a terminal that tells how far long work has come, and how long it will take at its own pace."""

import sys
from time import monotonic

import click

FIRST, OFTEN = 1.0, 0.2     # seconds: until anything is told, and between two tellings
LEAST = 1e-3                # of the whole, before a pace is known


def teller() -> "Progress | None":
    """What tells of long work (vibcli/base/work.py) on stderr; None where that is no terminal."""
    return Progress() if sys.stderr.isatty() else None


class Progress:
    """started: when the present task began; told: when it was last told of."""

    started: float | None

    def __init__(self) -> None:
        self.started, self.told, self.shown = None, 0.0, False

    def __call__(self, what: str | None, part: float, known: bool) -> None:
        now = monotonic()
        if what is None:
            self.started = None
            self._show("")
            return
        if self.started is None:
            self.started = now
        if now - self.started > FIRST and now - self.told > OFTEN:
            self.told = now
            self._show(words(what, part, known, now - self.started))

    def hide(self) -> None:
        """Leave the line to what is printed; it is told again later."""
        self._show("")

    def _show(self, text: str) -> None:
        if text or self.shown:
            click.echo("\r\x1b[K" + text, nl=False, err=True, color=True)
        self.shown = bool(text)


def words(what: str, part: float, known: bool, spent: float) -> str:
    """How far the work is: `part` of all of it, or, where that is not `known`, of what it may take at most."""
    if part < LEAST:
        return f"{what}: {spent:.0f} s"
    left = spent * (1 / part - 1)
    at_most = "" if known else "at most "
    return f"{what}: {at_most and 'up to '}{100 * part:.3g} % done, {at_most}{duration(left)} left"


def duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min" if seconds < 6000 else (
        f"{seconds / 3600:.0f} h")
