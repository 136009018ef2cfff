"""Reports as files and in other formats: their options, and writing documents and the pictures beside them."""

from collections.abc import Callable, Sequence
from functools import reduce
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.enumeration import listed
from vibcli.base.named_tuple import NamedTuple
from vibcli.cli.pictures import FILE
from vibcli.report.formats import FORMATS, WITHIN

if TYPE_CHECKING:
    from click.decorators import FC

    from vibcli.report.blocks import Document, Picture

SCENE, OF_SCENES = "scene", (".yaml", ".yml")
SUFFIXES = {name: suffixes for name, (suffixes, _, _) in FORMATS.items()} | {"json": (".json",)}
ILLUSTRATED = {name: where for name, (_, where, _) in FORMATS.items() if where}


class Output(NamedTuple):
    """What to write, where (None: stdout), and whether with pictures; `strict`: all of it with all its digits, or
    nothing."""

    kind: str = "text"
    path: Path | None = None
    pictures: bool = False
    force: bool = False
    strict: bool = False


def report_options(function: "FC", formats: Sequence[str] = tuple(FORMATS), more: str = "") -> "FC":
    """Options of the commands that print a report; `more` is said of further formats."""
    options: list[Callable[[FC], FC]] = [
        click.option("--format", "kind", type=click.Choice(list(formats)),
                     help=f"How to write the report; by the suffix of -o unless named, else text.{more}"),
        click.option("-o", "--output", metavar="FILE", type=FILE,
                     help=f"Write the report to a file: {listed([s for s, *_ in SUFFIXES.values()], 'or')}."),
        click.option("--force", is_flag=True, help="Replace files that exist."),
        click.option("--pictures", is_flag=True, help="Also draw the scene and its mode shapes (not in text)."),
        click.option("--strict", is_flag=True, help="Print nothing (exit code 4) where the bound of an error allows "
                     "fewer digits than are printed of others, or what is found leaves more than rounding behind."),
    ]
    return reduce(lambda f, option: option(f), reversed(options), function)


def output_of(file: str, as_json: bool, kind: Any, output: Any, force: bool, pictures: bool,
              strict: bool = False) -> Output:
    """The Output that the options ask for, before anything is computed; a usage error where that cannot be."""
    if as_json and kind:
        raise click.UsageError("--json does not go with --format")
    suffixes = (SUFFIXES | {SCENE: OF_SCENES}).get("json" if as_json else kind, sum(SUFFIXES.values(), ()))
    kind = "json" if as_json else kind or _by_suffix(output)
    if pictures and kind == "json":
        raise click.UsageError("--pictures does not go with JSON")
    if pictures and kind not in ILLUSTRATED:
        raise click.UsageError(f"--pictures needs --format {listed(ILLUSTRATED, 'or')}")
    if output in (None, "-"):
        if pictures and ILLUSTRATED[kind] != WITHIN:
            raise click.UsageError(f"--pictures in {kind} are files beside the report: name it with -o FILE")
        return Output(kind, None, pictures, strict=strict)
    from vibcli.cli.pictures import target

    return Output(kind, target(file, output, suffixes, force), pictures, force, strict)


def _by_suffix(output: Path | str | None) -> str:
    suffix = Path(output or "").suffix.lower()
    return next((kind for kind, suffixes in SUFFIXES.items() if suffix in suffixes), "text")


def write_text(text: str, output: Output) -> None:
    """Print a report, or write its file."""
    if output.path is None:
        click.echo(text)
        return
    from vibcli.cli.pictures import write

    write(output.path, (text + "\n").encode("utf-8", "replace"), output.force)


def write_documents(documents: "Sequence[Document]", output: Output) -> None:
    """Render documents and write them, the pictures first."""
    placed = []

    def place(picture: "Picture") -> str:
        from vibcli.cli.pictures import slug

        name = f"{slug(output.path.stem, str(len(placed) + 1), picture.name)}{ILLUSTRATED[output.kind]}"
        placed.append((output.path.with_name(name), picture))
        return name

    text = import_module(f"vibcli.report.formats.{output.kind}").render(documents, place)
    if placed:
        from vibcli.cli.pictures import target, write

        for path, _ in placed:
            target(None, path, (path.suffix,), output.force)
        for path, picture in placed:
            write(path, picture.draw(path.suffix[1:]), output.force)
    write_text(text, output)
