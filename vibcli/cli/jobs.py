"""Work on many files in processes of their own; what each finds comes in the order of the files."""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")


def in_processes(work: "Callable[[str], T]", files: Sequence[str], jobs: int, said: "Callable[[T], bool]",
                 lost: "Callable[[str, PhysicsError], T]", longest: Callable[[str], float] | None = None
                 ) -> "Iterator[T]":
    """work(file) of each file, in their order, so many at a time; those first that are `longest`. said(found): is
    anything printed of it? lost(file, why): what stands for one whose process ended twice. An interrupt, or leaving
    before the end, ends the processes."""
    from vibcli.cli.processes import Processes
    from vibcli.cli.progress import teller

    tell = teller()
    pool = Processes(jobs, None)
    try:
        order = range(len(files)) if longest is None else sorted(range(len(files)), key=lambda i: -longest(files[i]))
        waiting = {i: pool.submit(work, files[i]) for i in order}
        for number in range(len(files)):
            try:
                found = waiting[number].result()
            except PhysicsError as error:
                found = lost(files[number], error)
            if tell is not None and said(found):
                tell.hide()
            yield found
            if tell is not None:
                tell(f"{number + 1} of {len(files)} files", (number + 1) / len(files), True)
    finally:
        if tell is not None:
            tell(None, 1.0, False)
        pool.end()
