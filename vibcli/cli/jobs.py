"""Work on many files in processes of their own: what each prints is printed here, in the order of the files."""

import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from typing import Any, NamedTuple

import click

from vibcli.cli.common import colored


class Printed(NamedTuple):
    """What a process found of a file, and what it printed, with colours."""

    found: Any
    out: str
    err: str


def in_processes(work: Callable, files: Sequence[str], jobs: int) -> Iterator[Any]:
    """work(file) of each file, in their order, so many at a time. An interrupt ends the processes."""
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import active_children

    from vibcli.cli.progress import teller

    tell = teller()
    pool = ProcessPoolExecutor(jobs, initializer=_leave_interrupts)
    try:
        caught = Caught(work).__call__
        waiting = [pool.submit(caught, file) for file in files]
        for number, printed in enumerate((future.result() for future in waiting), 1):
            if tell is not None and (printed.err or printed.out):
                tell.hide()
            for text, err in ((printed.err, True), (printed.out, False)):
                if text:
                    click.echo(text if colored(sys.stderr if err else sys.stdout) else click.unstyle(text), nl=False,
                               err=err, color=True)
            yield printed.found
            if tell is not None:
                tell(f"{number} of {len(files)} files", number / len(files), True)
    except BaseException:
        for child in active_children():
            child.terminate()
        raise
    finally:
        if tell is not None:
            tell(None, 1.0, False)
        pool.shutdown()


class Caught(NamedTuple):
    """Calls `work` in a process, keeping what it prints."""

    work: Callable

    def __call__(self, file: str) -> Printed:
        out, err = StringIO(), StringIO()
        with redirect_stdout(out), redirect_stderr(err), click.Context(
                click.Command("file"), color=True):
            found = self.work(file)
        return Printed(found, out.getvalue(), err.getvalue())


def _leave_interrupts():
    """An interrupt from the terminal reaches all processes: the first of them ends the others."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
