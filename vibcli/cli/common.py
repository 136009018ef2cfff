"""What the commands share: their options, reading a file into a Problem, colour, diagnostics."""

import os
import sys
from collections.abc import Callable, Sequence
from functools import reduce
from math import ceil
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.errors import Diagnostic, PhysicsError, Remark, SpecError

if TYPE_CHECKING:
    from click.decorators import FC

    from vibcli.api.source import SceneSource
    from vibcli.base.errors import Where
    from vibcli.language.document.document import Scalar
    from vibcli.language.document.nodes import Mapping
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

MOST = 600      # steps of a million products, for --digits
_sources: dict[str, Sequence[str]] = {}


def scene_options(function: "FC") -> "FC":
    """Options of every command that reads one scene."""
    options: list[Callable[[FC], FC]] = [
        click.argument("file", type=click.Path(), shell_complete=None),
        click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
                     help="Give a parameter another value, in every case: k=500 in the file's unit, or 'k=0.5 N/mm'."),
        click.option("--case", "case", metavar="NAME", help="Only this case of the file."),
        click.option("--json", "as_json", is_flag=True, help="Machine-readable results in SI units."),
        patience_option,
        click.option("--timings", is_flag=True,
                     help="What each stage cost and which were skipped, and what certifies the results, on stderr."),
        color_option,
    ]
    return reduce(lambda f, option: option(f), reversed(options), function)


def patience_option(function: "FC") -> "FC":
    return click.option("--patience", type=click.IntRange(1, 1_000_000), default=1, metavar="N",
                        help="Let long work take N times as many steps before it is given up.")(function)


def accuracy_option(function: "FC") -> "FC":
    return click.option("--accuracy", metavar="E", callback=_accuracy, help="The error of each coordinate of a motion "
                        "that is integrated, relative to how far it goes: 1e-6 is sooner found than 1e-9, the "
                        "default.")(function)


def _accuracy(context: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
    if value is None:
        return None
    from vibcli.api.given import accuracy

    try:
        return accuracy(value)
    except ValueError as error:
        raise click.UsageError(f"--accuracy {value}: {error}") from None


def integrated(problems: "Sequence[tuple[Any, Problem]]", accuracy: float | None) -> "list[tuple[Any, Problem]]":
    """The same with their motions integrated as accurately as is asked; a usage error where they are small ones."""
    if accuracy is None:
        return list(problems)
    if all(problem.spec.motion == "small" for _, problem in problems):
        raise click.UsageError("--accuracy is for motions that are integrated: small oscillations are exact in time")
    return [(case, problem.with_accuracy(accuracy)) for case, problem in problems]


def color_option(function: "FC") -> "FC":
    option = click.option("--color", type=click.Choice(["auto", "always", "never"]), default="auto",
                          callback=_set_color, expose_value=False,
                          help="Colour in the output (NO_COLOR and FORCE_COLOR are honoured).")
    return option(function)


def number_options(function: "FC") -> "FC":
    """Options of the commands that print frequencies."""
    digits = click.option("--digits", type=click.IntRange(1, 1000), metavar="N",
                          help="Recompute with N correct digits in arbitrary precision.")
    shapes = click.option("--normalise", type=click.Choice(["first", "largest", "mass"]), default="first",
                          help="Mode shapes: first coordinate 1, largest amplitude 1, or φᵀMφ = 1.")
    return digits(shapes(function))


def _set_color(context: click.Context, parameter: click.Parameter, value: str) -> None:
    if value == "auto":
        wanted = None
        if os.environ.get("NO_COLOR"):
            wanted = False
        elif os.environ.get("FORCE_COLOR"):
            wanted = True
    else:
        wanted = value == "always"
    context.color = wanted


def load(file: Any, settings: Sequence[str] = (), patience: int = 1) -> "Problem":
    """The Problem of a file, with its reading timed; SpecError or a usage error where it cannot be read. patience:
    the factor of what its long work may take."""
    problem = problem_in(source_of(file), settings, patience)
    show_diagnostics(problem.spec.remarks)
    return problem


def source_of(file: Any) -> "SceneSource":
    """A file as it is read; a usage error where there is none."""
    from vibcli.api.source import file_source

    try:
        return file_source(file)
    except FileNotFoundError:
        if os.path.islink(file):
            raise click.UsageError(f"'{file}' is a link that leads to no file") from None
        raise click.UsageError(f"there is no file '{file}'{_near(file)}") from None


def problem_in(source: "SceneSource", settings: Sequence[str] = (), patience: int = 1) -> "Problem":
    """The Problem of a scene as it was read, whose long work tells how far it is."""
    from vibcli.api.source import problem_of
    from vibcli.base.work import Work
    from vibcli.cli.progress import teller

    return problem_of(source, settings_in(source, settings), Work(patience, teller()))


def _near(file: str) -> str:
    from difflib import get_close_matches

    folder, name = os.path.split(file)
    try:
        near = get_close_matches(name, os.listdir(folder or "."), 1)
    except OSError:
        return ""
    return f"; did you mean '{os.path.join(folder, near[0])}'?" if near else ""


def settings_in(source: "SceneSource", settings: Sequence[str]) -> dict[str, tuple[object, "Scalar"]]:
    """{name: (tree, scalar)} of the --set options; SpecError where the scene could not be read."""
    _sources.pop(source.file, None)
    _sources[source.file] = source.lines
    if source.node is None:
        raise SpecError(source.diagnostics)
    if not settings:
        return {}
    from vibcli.api.given import parameters_of, setting

    found, known = {}, parameters_of(source.node)
    for option in settings:
        name, equals, text = option.partition("=")
        if not equals or not text.strip():
            raise click.UsageError(f"--set {option}: write NAME=VALUE, as in --set k=500 or --set 'k=0.5 N/mm'")
        try:
            found |= setting(name, text, known, "--set")
        except ValueError as error:
            raise click.UsageError(f"--set {option}: {error}") from None
    return found


def chosen(problem: "Problem", case: str | None) -> "list[tuple[str | None, Problem]]":
    """[(case name or None, Problem)] that a command is to treat: one case, or the scene and all its cases."""
    if case is None:
        return [(None, problem)] + [(name, problem.case(name)) for name in problem.spec.cases]
    from vibcli.api import given

    try:
        return [(case, given.case(problem, case))]
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def show_diagnostics(diagnostics: Sequence[Diagnostic],
                     lines_of: "Callable[[Where], Sequence[str]] | None" = None) -> None:
    """Diagnostics on stderr, each with its line and a caret. lines_of: the lines of the file of a place; unless given
    those that were read."""
    from vibcli.base.diagnostics import render

    color = colored(sys.stderr)
    for diagnostic in diagnostics:
        lines = (lines_of or shown_lines)(diagnostic.where) if diagnostic.where else ()
        click.echo(render(diagnostic, lines, color), err=True, color=color)
    errors = sum(not isinstance(one, Remark) for one in diagnostics)
    if errors > 1:
        click.echo(f"{errors} errors", err=True)


def shown_lines(where: "Where") -> Sequence[str]:
    """The lines of the file of a place: of a scene, or of a record beside it."""
    if where.file not in _sources and where.width:
        from vibcli.api import source

        return source.shown_lines(where.file)
    return _sources.get(where.file, ())


def forget(file: str) -> None:
    """Let go of the lines of a file that was read."""
    _sources.pop(file, None)


def show_refusal(error: PhysicsError, file: str | None = None) -> None:
    """A physical refusal on stderr."""
    from vibcli.base.errors import Diagnostic, Where

    file = file or next(reversed(_sources), None)
    where = error.where or (Where(file, 1, 1, 0) if file else None)
    show_diagnostics([Diagnostic(where, error.message, error.hint)])


def show_usage(error: click.ClickException) -> None:
    """What is wrong with a command line, on stderr; nothing that it quotes can steer a terminal."""
    from io import StringIO

    from vibcli.base.diagnostics import lines_escaped

    text = StringIO()
    error.show(text)
    click.echo(lines_escaped(text.getvalue()), nl=False, err=True)


def fault(error: Exception) -> str:
    """A fault of ours in short; KeyboardInterrupt where it was made of one, as in the making of a class."""
    if isinstance(error.__cause__, KeyboardInterrupt):
        raise KeyboardInterrupt
    return f"{type(error).__name__}: {str(error)[:200]}"


def show_fault(text: str) -> None:
    """A fault of ours on stderr."""
    from vibcli.base.diagnostics import lines_escaped

    click.echo(f"vibcli: an error of its own: {lines_escaped(text)}\n"
               "Please report it with the file that shows it; VIBCLI_TRACEBACK=1 shows where it happened.", err=True)


def colored(stream: Any) -> bool:
    """Are colours for a stream?"""
    context = click.get_current_context(silent=True)
    if context is not None and context.color is not None:
        return context.color
    if os.environ.get("NO_COLOR"):
        return False
    return bool(os.environ.get("FORCE_COLOR")) or stream.isatty()


def show_timings(problems: "Sequence[tuple[str | None, Problem]]") -> None:
    """What each stage cost, and what certifies what was found, on stderr."""
    from vibcli.api.source import certified, stage_costs

    for name, problem in problems:
        click.echo("stage            ms" + (f"   (case {name})" if name else ""), err=True)
        for stage, cost in stage_costs(problem).items():
            click.echo(f"{stage:<14} {'skipped' if cost is None else f'{1e3 * cost:7.2f}'}", err=True)
        for told in certified(problem):
            click.echo(told, err=True)


def require_quick(problem: "Problem", digits: int | None) -> None:
    """Refuse --digits where it would take long, by an estimate of the steps."""
    if digits is None:
        return
    steps, limit = problem.modal.steps_to_digits(digits), MOST * problem.work.patience
    if steps > limit:
        raise click.UsageError(f"--digits {digits} for {len(problem.scene.coordinates)} coordinates would take about "
                               f"{steps:.0f} steps of a million products each; the limit is {limit}: ask for fewer "
                               f"digits, or allow more with --patience {ceil(steps / MOST)}")


def known_mistake(root: "Mapping | None", problem: "Problem", asked: "Expression", expected: float, found: float,
                  case: str | None) -> str | None:
    """The sentence of the mistake that leads to an answer which differs, None where none is known; root: the document
    of the scene, without which mistakes of its model are not looked for."""
    from vibcli.homework.mistakes.nearest import nearest_mistake

    return nearest_mistake(problem, asked, expected, found, root, case)
