"""`vibcli view FILE`: report, figures and moving modes in the browser, following the file as it is edited."""

import os
import sys
from collections.abc import Sequence

import click

from vibcli.cli.common import color_option, patience_option


@click.command("view")
@click.argument("file", type=click.Path(), shell_complete=None)
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Give a parameter another value, in every case: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--case", "case", metavar="NAME", help="Only this case of the file.")
@click.option("--port", type=click.IntRange(0, 65535), default=0, metavar="N",
              help="The port on this machine; a free one unless given.")
@click.option("--no-open", "closed", is_flag=True, help="Only print the address, for a browser that is open.")
@patience_option
@color_option
def command(file: str, settings: Sequence[str], case: str | None, port: int, closed: bool, patience: int) -> None:
    """Report, figures and moving modes in the browser, which follows the file as it is edited; an interrupt ends it.

    The page is served to this machine alone, and asks for nothing elsewhere.
    """
    from vibcli.cli.viewing.following import Asked, follow, require_valid
    from vibcli.cli.viewing.server import serving
    from vibcli.cli.viewing.shown import Shown

    asked = Asked(file, tuple(settings), case, patience)
    require_valid(asked)
    shown = Shown(os.path.basename(file))
    with serving(shown, port) as address:
        click.echo(address)
        sys.stdout.flush()
        if not closed:
            _open(address)
        follow(asked, shown)


def _open(address: str) -> None:
    """Open the browser, beside what follows: some browsers hold on until they are closed."""
    import webbrowser
    from threading import Thread

    def opened() -> None:
        if not webbrowser.open(address):
            click.echo("no browser was found: open the address in one", err=True)

    Thread(target=opened, daemon=True).start()
