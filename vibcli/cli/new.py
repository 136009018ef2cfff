"""`vibcli new [TEMPLATE]`: a commented scene to start from."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vibcli.base.diagnostics import escaped
from vibcli.cli.pictures import FILE, refuse, write_new

if TYPE_CHECKING:
    from types import ModuleType

DEFAULT = "mass_spring"


def _complete(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[str]:
    from vibcli.manual import scenes

    return [name for which in scenes.FOLDERS for name in scenes.names(which) if name.startswith(incomplete)]


@click.command("new")
@click.argument("template", default=DEFAULT, shell_complete=_complete)
@click.option("-o", "--output", metavar="FILE", type=FILE, help="Write the scene to a new file.")
@click.option("--list", "listing", is_flag=True, help="What there is to start from.")
def command(template: str, output: str | None, listing: bool) -> None:
    """A commented scene to start from: a TEMPLATE (mass_spring if none is named) or an example of the manual.

    `vibcli new pendulum -o pendulum.yaml` writes it to a file, which must not exist yet.
    """
    from vibcli.manual import scenes

    if listing:
        click.echo("\n".join(_listing(scenes)))
        return
    name = template.removesuffix(".yaml")
    if scenes.path(name) is None:
        from vibcli.base.spelling import near

        found = near(name, [*scenes.names("templates"), *scenes.names("examples")])
        hint = f"did you mean '{found}'?" if found else "templates: " + ", ".join(scenes.names("templates"))
        raise click.UsageError(f"there is no template '{template}'; {hint} (all: vibcli new --list)")
    if output in (None, "-"):
        click.echo(scenes.text(name), nl=False)
        for file in scenes.beside(name):
            click.echo(f"it reads {os.path.basename(file)}, which -o writes beside it", err=True)
        return
    copies = [(os.path.join(os.path.dirname(output), os.path.basename(file)), file) for file in scenes.beside(name)]
    for path in (output, *(copy for copy, _ in copies)):
        refuse(Path(path), None, False)
    for copy, file in copies:
        with open(file, "rb") as record:
            write_new(copy, record.read())
    write_new(output, scenes.text(name).encode())
    written = ", ".join([output, *(copy for copy, _ in copies)])
    click.echo(escaped(f"wrote {written}; next: vibcli solve {output}"), err=True)


def _listing(scenes: "ModuleType") -> list[str]:
    from vibcli.manual.layout import table

    titles = {which: [(name, scenes.title(name)) for name in scenes.names(which)] for which in scenes.FOLDERS}
    width = max(len(name) for rows in titles.values() for name, _ in rows)
    lines = []
    for which, heading in zip(scenes.FOLDERS, ("Templates, commented", "Examples of the manual"), strict=True):
        lines += [*([""] if lines else []), heading, *table(titles[which], least=width)]
    return lines
