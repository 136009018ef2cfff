"""What the commands that plot and save curves share: options, signals given as text, the files that they write."""

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vibcli.cli.pictures import FILE, refuse, write

if TYPE_CHECKING:
    import numpy as np
    from click.decorators import FC

    from vibcli.language.reader import Expression
    from vibcli.plots.figure import Figure
    from vibcli.results.problem import Problem

WIDEST = 120
PICTURES = (".png", ".svg", ".pdf")
INSTANT = "a time, as in 2.5 or '40 ms'"


def curve_options(function: "FC") -> "FC":
    """Options of a command that shows curves."""
    options: list[Callable[[FC], FC]] = [
        click.option("--plot", is_flag=True, help="Plot in the terminal."),
        click.option("--save", "saves", multiple=True, metavar="FILE", type=FILE,
                     help="Write a picture (.png, .svg, .pdf) or the sampled numbers (.csv, .npz, .json) of the scene, "
                     "or of one --case."),
    ]
    return reduce(lambda f, option: option(f), reversed(options), function)


def asked(text: str, option: str) -> "Expression":
    """A signal given on the command line as an Expression."""
    from vibcli.api.given import expression

    try:
        return expression(text, option)
    except ValueError as error:
        raise click.UsageError(f"{option} {text}: {error}") from None


def size(text: str, option: str, unit: str, wants: str, exact: bool = False) -> Any:
    """A positive quantity given on the command line, in SI units: see vibcli/api/given.py."""
    from vibcli.api import given

    try:
        return given.size(text, unit, wants, exact)
    except ValueError as error:
        raise click.UsageError(f"{option} {text}: {error}") from None


def refuse_targets(paths: Sequence[str], force: Any,
                   suffixes: Sequence[str] = (*PICTURES, ".csv", ".npz", ".json")) -> None:
    """A usage error, before anything is computed, where one of the files cannot be written."""
    for path in map(Path, paths):
        refuse(path, suffixes, force)


def require_curves(plot: bool, saves: Sequence[str], as_json: bool, options: Mapping[str, bool | str | None]) -> None:
    """A usage error where an option would do nothing, or a plot would break the JSON."""
    idle = next((option for option, given in options.items() if given), None)
    if idle and not (plot or saves):
        raise click.UsageError(f"{idle} belongs to --plot or --save")
    if plot and as_json:
        raise click.UsageError("--plot does not go with --json: save the numbers with --save FILE")


def cases_to_show(problems: "Sequence[tuple[str | None, Problem]]",
                  saves: Sequence[str]) -> "Sequence[tuple[str | None, Problem]]":
    """The scene and its cases; the scene alone where its curves are saved, for they are saved to one file."""
    return problems[:1] if saves else problems


def show_curves(plot: bool, saves: Sequence[str], force: bool, title: str, figure: "Callable[[], Figure]",
                columns: "Callable[[], list[tuple[str, str, np.ndarray]]] | None" = None) -> None:
    """Plot what `figure()` gives in the terminal; write it, or what `columns()` gives, to files under a title."""
    from vibcli.report.formats.curves import curve_file, in_terminal

    if plot:
        import shutil

        click.echo("\n" + in_terminal(figure(), min(shutil.get_terminal_size().columns, WIDEST)))
    for path in saves:
        write(path, curve_file(Path(path).suffix.lower(), title, figure, columns), force)
