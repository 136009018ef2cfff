"""`vibcli stress`: families of scenes with one knob, each point beside its true value; a FILE is shaken."""

import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from vibcli.cli.common import chosen, color_option, patience_option, problem_in, settings_in, source_of
from vibcli.cli.pictures import FILE, refuse, write


@click.command("stress")
@click.argument("file", type=click.Path(), required=False)
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Of a FILE: give a parameter another value: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--case", "case", metavar="NAME", help="Of a FILE: this case, instead of the scene itself.")
@click.option("--family", "names", multiple=True, metavar="NAME", help="Only this family; may be given several times.")
@click.option("--json", "as_json", is_flag=True, help="Machine-readable: relative errors and bounds.")
@click.option("-o", "--output", metavar="FOLDER", type=FILE, help="Write a picture of each family there (.svg).")
@click.option("--force", is_flag=True, help="Replace pictures that exist.")
@patience_option
@color_option
def command(file: str | None, settings: Sequence[str], case: str | None, names: Sequence[str], as_json: bool,
            output: str | None, force: bool, patience: int) -> int:
    """Families of scenes that one knob makes ever harder, each point beside its true value of many digits.

    With a FILE that scene is shaken: written otherwise, it has to rest, swing and answer as before; and the digits of
    its answers are told that its data support. Exit code: 0, 1 where a bound is exceeded: vibcli explain stress.
    """
    if file is not None:
        if names or output:
            raise click.UsageError("--family and -o are for the families: leave FILE out")
        return _scene(file, settings, case, as_json, patience)
    if settings or case:
        raise click.UsageError("--set and --case are for a scene: name its FILE")
    from vibcli.evidence.stress import sweep, told

    wanted = _known(names)
    pictures = {name: Path(output) / f"{name}.svg" for name in wanted} if output else {}
    _prepared(output, pictures, force)
    found = []
    for one in sweep.solved(wanted):
        found.append(one)
        if not as_json:
            _print([told.section(one)])
        if output:
            _draw(one, pictures[one.name], force)
    click.echo(json.dumps(told.data(found), ensure_ascii=False, allow_nan=False, indent=1) if as_json else
               told.summary(found))
    return int(sweep.is_broken(found))


def _scene(file: str, settings: Sequence[str], case: str | None, as_json: bool, patience: int) -> int:
    """Shake a scene of the user's."""
    from vibcli.base.work import Work
    from vibcli.cli.progress import teller
    from vibcli.evidence.compared import in_numbers
    from vibcli.evidence.stress import told
    from vibcli.evidence.stress.read_again import read_again
    from vibcli.evidence.stress.shaken import BROKEN, shaken
    from vibcli.evidence.stress.supported import supported
    from vibcli.evidence.stress.whole_scene import shaken_as_a_whole

    source = source_of(file)
    drawn = in_numbers(chosen(problem_in(source, settings, patience), case)[0][1])[1]
    top, remade = read_again(source.node, file, settings_in(source, settings), case, lambda: Work(patience, teller()),
                             drawn)
    problem = remade(lambda same: same)
    shakes = [*shaken(problem), *shaken_as_a_whole(problem, remade)]
    answers = list(supported(problem, top, remade))
    if as_json:
        click.echo(json.dumps(told.scene_data(shakes, answers, drawn), ensure_ascii=False, allow_nan=False, indent=1))
    else:
        _print(told.scene_sections(shakes, answers, drawn))
    return int(any(one.verdict == BROKEN for one in shakes))


def _print(sections: Sequence[Any]) -> None:
    from vibcli.report.formats.text import section_lines, shown

    click.echo(shown([*section_lines(sections)[1:], ""]))


def _known(names: Sequence[str]) -> list[str]:
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


def _draw(one: Any, path: Path, force: bool) -> None:
    from vibcli.evidence.stress.picture import drawn

    write(path, drawn(one, "svg"), force)
