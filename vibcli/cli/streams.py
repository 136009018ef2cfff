"""The standard streams of a process, closed or not, and whoever reads them.

A reader that has left is no failure: what is still said goes nowhere, and the exit code is that of the work. An output
that cannot be written, on a full disc or because it is closed, is refused once, as is any file; of what cannot be
written to stderr nobody can be told.
"""

import io
import os
import sys
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from typing import TextIO


class Stream(io.RawIOBase):
    """The bytes of a standard stream; `descriptor` None: it is closed."""

    def __init__(self, descriptor: int | None, refuses: bool) -> None:
        self.descriptor, self.refuses, self.lost = descriptor, refuses, False

    def writable(self) -> bool:
        return True

    def isatty(self) -> bool:
        return self.descriptor is not None and os.isatty(self.descriptor)

    def fileno(self) -> int:
        if self.descriptor is None:
            raise io.UnsupportedOperation("stdout is closed")
        return self.descriptor

    def write(self, data: Any) -> int:
        while not self.lost:
            try:
                return os.write(self.fileno(), data)
            except BlockingIOError:     # whoever shares it made it so: a slow reader is waited for all the same
                from select import select

                select([], [self.descriptor], [])
            except OSError as error:
                self.lost = True
                if self.refuses and not isinstance(error, BrokenPipeError):
                    raise PhysicsError(f"the output cannot be written: {error.strerror or error}") from None
        return len(data)


def provide() -> None:
    """Let stdout and stderr be such streams."""
    sys.stdout, sys.stderr = _stream(sys.stdout, True), _stream(sys.stderr, False)


def _stream(given: "TextIO | None", refuses: bool) -> io.TextIOWrapper:
    """A text stream in place of a given one, which is None where it is closed."""
    if given is None:
        os.open(os.devnull, os.O_WRONLY)        # so that no file that is opened later takes its place
    descriptor = None if given is None else given.fileno()
    buffer = io.BufferedWriter(Stream(descriptor, refuses))
    return io.TextIOWrapper(buffer, getattr(given, "encoding", "utf-8"), "replace",
                            line_buffering=given is None or bool(given.line_buffering))
