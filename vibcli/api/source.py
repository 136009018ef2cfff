"""A scene as it was read, and the Problem of it."""

import os
from time import perf_counter
from typing import TYPE_CHECKING, Any

from vibcli.base.decoding import MAX_BYTES, lines, too_long
from vibcli.base.errors import Diagnostic, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import Work
from vibcli.language.document.document import read, read_file
from vibcli.language.document.nodes import Mapping, Scalar, Sequence

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


UNNAMED = "scene"       # of a text or a mapping: diagnostics name it before line and column


class SceneSource(NamedTuple):
    """A scene as it was read: the name of its file, the top of its document (None where reading had to stop), what is
    wrong with it so far, its lines, and what reading it cost [s]."""

    file: str
    node: Mapping | None
    diagnostics: list[Diagnostic]
    lines: list[str]
    cost: float = 0.0


def file_source(path: "str | os.PathLike[str]") -> SceneSource:
    """A scene file as it is read; FileNotFoundError where there is none."""
    start = perf_counter()
    node, diagnostics, lines = read_file(path)
    return SceneSource(os.fsdecode(path), node, diagnostics, lines, perf_counter() - start)


def bytes_source(data: bytes, file: str) -> SceneSource:
    """The bytes of a scene file as it is read."""
    return SceneSource(file, *read(data, file), lines(data))


def content(node: Mapping | Sequence | Scalar, without: tuple[str, ...] = ()) -> tuple[Any, ...]:
    """What stands in a node, some keys left out, whatever its layout and the remarks beside it."""
    if isinstance(node, Scalar):
        return node.text, node.quoted
    if isinstance(node, Mapping):
        return tuple((key, content(value)) for key, (_, value) in node.entries.items() if key not in without)
    return tuple(map(content, node.items))


def shown_lines(file: str) -> list[str]:
    """The lines of a record beside a scene, for a message; none where it cannot be read."""
    from vibcli.language import data_columns

    return data_columns.shown_lines(file)


def stage_costs(problem: "Problem") -> "dict[str, float | None]":
    """{stage: seconds that it took, None where it was skipped}, of reading those alone that were timed."""
    from vibcli.results.stages import STAGES

    read = {stage: problem.timings[stage] for stage in ("read", "spec") if stage in problem.timings}
    return read | {stage: problem.timings.get(stage) for stage in STAGES}


def certified(problem: "Problem") -> list[str]:
    """What is left of the equations where what was found is put back into them, in words."""
    from vibcli.results.certificate import ENERGY, certificate

    return [f"{what}: off by {left:.1e} of the largest of them" if what == ENERGY else
            f"residual ratio of {what}: {left:.2g}" for what, left in certificate(problem).items()]


def text_source(text: str, folder: "str | os.PathLike[str]" = ".") -> SceneSource:
    """The text of a scene as it is read; `folder`: where its records lie. SpecError where it is too long."""
    file = os.path.normpath(os.path.join(os.fspath(folder), UNNAMED))
    data = text.encode("utf-8", "surrogatepass")
    if len(data) > MAX_BYTES:
        raise SpecError([too_long(file, len(data))])
    return SceneSource(file, *read(data, file), text.splitlines())


def problem_of(source: SceneSource, settings: dict[str, Any] | None = None, work: Work | None = None) -> "Problem":
    """The Problem of a scene; SpecError where it is invalid. settings: {parameter: (syntax tree, text)} that replace
    values of the file; work: what counts its long work."""
    if source.node is None:
        raise SpecError(source.diagnostics)
    from vibcli.reader.read import read_spec
    from vibcli.results.problem import Problem

    start = perf_counter()
    problem = Problem(read_spec(source.node, source.file, source.diagnostics, settings or {}), work=work)
    problem.costs.update(read=source.cost, spec=perf_counter() - start)
    return problem


def settled(problem: "Problem", thorough: bool = False) -> "Problem":
    """The problem with values for what it chooses. `thorough`: SymPy may look for closed forms that the project's own
    algebra does not find."""
    if not problem.spec.choices:
        return problem
    from vibcli import inverse

    return inverse.settled(problem, thorough)
