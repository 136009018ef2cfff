"""Following a file: it is looked at, read when it has changed, and what has changed of it is solved."""

import os
from time import sleep
from typing import TYPE_CHECKING

import click

from vibcli.api.source import bytes_source, content
from vibcli.base.errors import SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.cli.common import chosen, load, problem_in
from vibcli.cli.viewing.shown import Shown
from vibcli.cli.viewing.solver import Job, Solver, told

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.document.nodes import Mapping
    from vibcli.language.spec import Spec

PACE = 0.1      # seconds between looks at the file
MOST = 100      # solved parts that are kept
OWN = ("answers", "find", "cases")      # of the scene, not of its cases


class Asked(NamedTuple):
    """What is to be shown."""

    file: str
    settings: tuple[str, ...]
    case: str | None
    patience: int


def require_valid(asked: Asked) -> None:
    """A usage error where there is no such file, parameter or case; what is wrong within the file, the page shows."""
    try:
        chosen(load(asked.file, asked.settings, asked.patience), asked.case)
    except SpecError:
        return


def follow(asked: Asked, shown: Shown) -> None:
    """Follow the file until an interrupt."""
    following = Following(asked, shown)
    try:
        while True:
            following.look()
            following.work(PACE)
    finally:
        following.solver.stop()


class Following:
    """`beside`: files that the scene reads; `wanted`: what identifies each part of the page, and its Job; `kept`: what
    was found of parts, by what identifies them; `first`: has nothing been shown as a whole so far?"""

    def __init__(self, asked: Asked, shown: Shown) -> None:
        self.asked, self.shown, self.solver = asked, shown, Solver()
        self.beside: tuple[str, ...] = ()
        self.stamps: list[tuple[int, int, int] | None] | None = None
        self.wanted: dict[tuple[object, ...], Job] = {}
        self.kept: dict[tuple[object, ...], tuple[str, list[str]]] = {}
        self.under_way: tuple[object, ...] | None = None
        self.first = True

    def look(self) -> None:
        """Read the file where it, or one beside it, has changed."""
        stamps = [_stamp(file) for file in (self.asked.file, *self.beside)]
        if stamps == self.stamps:
            return
        self.stamps = stamps
        try:
            with open(self.asked.file, "rb") as stream:
                data = stream.read()
        except OSError as error:
            self.shown.show(errors=(f"{self.asked.file}: error: {(error.strerror or str(error)).lower()}",))
            return
        self._read(data)

    def _read(self, data: bytes) -> None:
        source = bytes_source(data, self.asked.file)
        try:
            problem = problem_in(source, self.asked.settings, self.asked.patience)
            parts = chosen(problem, self.asked.case)
        except SpecError as error:
            self.shown.show(errors=tuple(told(error.diagnostics, source)))
            return
        except click.UsageError as error:
            self.shown.show(errors=(error.message,))
            return
        self.beside = tuple(_beside(problem.spec, self.asked.file))
        self.stamps = [self.stamps[0], *map(_stamp, self.beside)]
        base, cases = content(source.node, OWN), dict(_cases(source.node))
        self.wanted = {
            (base, cases.get(case, content(source.node, ("cases",))), number, *self.stamps[1:]):
            Job(data, self.asked.file, self.asked.settings, case, number, self.asked.patience)
            for number, (case, _) in enumerate(parts)}
        if self.solver.busy and self.under_way not in self.wanted:
            self.solver.stop()
        self._show(problem.spec.get("title") or os.path.basename(self.asked.file))

    def work(self, seconds: float) -> None:
        """Let what is missing be solved, and wait so long for it."""
        if not self.solver.busy:
            missing = next((key for key in self.wanted if key not in self.kept), None)
            if missing is None:
                sleep(seconds)
                return
            self.under_way = missing
            self.solver.start(self.wanted[missing])
        found = self.solver.found(seconds)
        if found is not None:
            self.kept[self.under_way] = found
            for key in [key for key in self.kept if key not in self.wanted][:max(0, len(self.kept) - MOST)]:
                del self.kept[key]
            self._show(self.shown.state.title)

    def _show(self, title: str) -> None:
        """What is known of the file as it is now, when all is known; until then what was known before, if there was."""
        known = [self.kept[key] for key in self.wanted if key in self.kept]
        parts = tuple(html for html, _ in known if html)
        if len(known) < len(self.wanted):
            work = f"solving: {len(known)} of {len(self.wanted)} are there …" if len(self.wanted) > 1 else "solving …"
            self.shown.show(title=title, errors=(), work=work, parts=parts if self.first else self.shown.state.parts)
            return
        self.first = False
        self.shown.show(title=title, parts=parts, work="",
                        errors=tuple(error for _, errors in known for error in errors))


def _stamp(file: str) -> tuple[int, int, int] | None:
    try:
        found = os.stat(file)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _beside(spec: "Spec", file: str) -> "Iterator[str]":
    """The files that records of a scene lie in."""
    for record in (spec.get("records") or {}).values():
        yield os.path.join(os.path.dirname(file), record["file"].text)


def _cases(root: "Mapping") -> "Iterator[tuple[str, object]]":
    """(name, content) of the cases."""
    if "cases" in root.entries:
        yield from ((name, content(part)) for name, (_, part) in root.entries["cases"][1].entries.items())
