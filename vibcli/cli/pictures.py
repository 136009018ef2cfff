"""What the commands that write a picture share: options, the name of the file, what is said of it."""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import reduce
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.errors import PhysicsError
from vibcli.cli.common import chosen, color_option, patience_option

if TYPE_CHECKING:
    from click.decorators import FC

    from vibcli.results.problem import Problem

LONGEST = 80


class File(click.Path):
    """The name of a file to write."""

    def convert(self, value: Any, parameter: Any, context: Any) -> Any:
        if not str(value).strip():
            self.fail("a file has a name, and this is empty", parameter, context)
        return super().convert(value, parameter, context)


FILE = File()


def picture_options(suffixes: Sequence[str]) -> "Callable[[FC], FC]":
    """Options of a command that writes a picture of one scene."""
    options = [
        click.argument("file", type=click.Path(), shell_complete=None),
        click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
                     help="Give a parameter another value: k=500 in the file's unit, or 'k=0.5 N/mm'."),
        click.option("--case", "case", metavar="NAME", help="This case of the file, instead of the scene itself."),
        click.option("-o", "--output", metavar="FILE", type=FILE,
                     help=f"The file to write: {', '.join(suffixes)}; unless named, {suffixes[0]} in this folder."),
        click.option("--force", is_flag=True, help="Replace the file if it exists."),
        patience_option,
        color_option,
    ]
    return lambda function: reduce(lambda f, option: option(f), reversed(options), function)


def one(problem: "Problem", case: str | None) -> "Problem":
    """The scene, or its case if one is named."""
    return chosen(problem, case)[0][1]


def target(file: str | None, output: Path | str | None, suffixes: Sequence[str], force: bool,
           *parts: str | None) -> Path:
    """The Path to write to, before anything is computed; a usage error where that cannot be."""
    path = Path(output) if output else Path(slug(Path(file).stem, *parts) + suffixes[0])
    refuse(path, suffixes, force)
    return path


def refuse(path: Path, suffixes: Sequence[str] | None, force: bool) -> None:
    """A usage error where a file cannot be written, or is there already."""
    from vibcli.base.output_files import refuse_unwritable

    with refused_as_usage():
        refuse_unwritable(path, suffixes)
    if path.exists() and not force:
        raise exists(path)


@contextmanager
def refused_as_usage() -> Iterator[None]:
    """What is refused of a place to write to is an error of the command line."""
    try:
        yield
    except PhysicsError as error:
        raise click.UsageError(f"{error.message}; {error.hint}") from None


def exists(path: Path | str) -> click.UsageError:
    return click.UsageError(f"'{path}' exists already and is left as it is: name another file, or --force")


def slug(*parts: str | None) -> str:
    """A plain name for a file: letters, digits, - and _."""
    text = "-".join(re.sub(r"[^A-Za-z0-9_]+", "-", part).strip("-") for part in parts if part)
    return text[:LONGEST].strip("-") or "scene"


def write(path: Path | str, data: bytes, force: bool) -> None:
    """Write a file, and say so."""
    if force:
        from vibcli.base.output_files import write_whole

        write_whole(path, data)
    else:
        write_new(path, data)
    from vibcli.base.diagnostics import escaped

    click.echo(f"wrote {escaped(str(path))}", err=True)


def write_new(path: Path | str, data: bytes) -> None:
    """Write a file that is not there; a usage error where somebody else was faster."""
    from vibcli.base.output_files import write_whole

    try:
        write_whole(path, data, new=True)
    except FileExistsError:
        raise exists(path) from None
