"""`vibcli stress`: families of scenes with one knob, each point beside its true value."""

import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from vibcli.cli.common import color_option
from vibcli.cli.pictures import FILE, refuse, write


@click.command("stress")
@click.option("--family", "names", multiple=True, metavar="NAME", help="Only this family; may be given several times.")
@click.option("--json", "as_json", is_flag=True, help="Machine-readable: relative errors and bounds.")
@click.option("-o", "--output", metavar="FOLDER", type=FILE, help="Write a picture of each family there (.svg).")
@click.option("--force", is_flag=True, help="Replace pictures that exist.")
@color_option
def command(names: Sequence[str], as_json: bool, output: str | None, force: bool) -> int:
    """Families of scenes that one knob makes ever harder, each point beside its true value of many digits.

    Exit code: 0, 1 where an error exceeds the bound that is stated: vibcli explain stress.
    """
    from vibcli.evidence.stress import sweep, told

    chosen = _known(names)
    pictures = {name: Path(output) / f"{name}.svg" for name in chosen} if output else {}
    _prepared(output, pictures, force)
    found = []
    for one in sweep.solved(chosen):
        found.append(one)
        if not as_json:
            _show(one)
        if output:
            _draw(one, pictures[one.name], force)
    click.echo(json.dumps(told.data(found), ensure_ascii=False, allow_nan=False, indent=1) if as_json else
               told.summary(found))
    return int(sweep.is_broken(found))


def _known(names):
    from vibcli.base.spelling import nearest
    from vibcli.evidence.stress.families import FAMILIES

    for name in names:
        if name not in FAMILIES:
            raise click.UsageError(f"there is no family '{name}'; {nearest(name, FAMILIES)}")
    return list(dict.fromkeys(names)) or list(FAMILIES)


def _prepared(folder: str | None, pictures: dict[str, Path], force: bool) -> None:
    if folder is None:
        return
    if os.path.exists(folder) and not os.path.isdir(folder):
        raise click.UsageError(f"'{folder}' is no folder: name one for the pictures")
    os.makedirs(folder, exist_ok=True)
    for path in pictures.values():
        refuse(path, (".svg",), force)


def _show(one: Any) -> None:
    from vibcli.evidence.stress import told
    from vibcli.report.formats.text import section_lines, shown

    click.echo(shown([*section_lines([told.section(one)])[1:], ""]))


def _draw(one: Any, path: Path, force: bool) -> None:
    from vibcli.evidence.stress.picture import drawn

    write(path, drawn(one, "svg"), force)
