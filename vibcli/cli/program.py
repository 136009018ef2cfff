"""The command line as a whole: arguments in, results on stdout, diagnostics on stderr, exit code out.

0 all well · 1 an answer differs · 2 command line · 3 a file is invalid · 4 a scene cannot be solved · 5 nothing was
collected · 101 our own fault · 130 interrupted, or told to end.
"""

import os
import sys
from importlib import import_module
from typing import TYPE_CHECKING, Any

import click

from vibcli import __version__
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli import COMMANDS

if TYPE_CHECKING:
    from collections.abc import Sequence


class Commands(click.Group):
    """Commands by name, imported when they are called."""

    def list_commands(self, context: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, context: click.Context, name: str) -> click.Command:
        if name not in COMMANDS:
            return None
        command: click.Command = import_module(f"vibcli.cli.{name}").command
        return command

    def resolve_command(self, context: click.Context, args: list[str]) -> tuple[str, click.Command, list[str]]:
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            from vibcli.base.spelling import nearest

            hint = nearest(args[0], COMMANDS)
            if os.path.exists(args[0]):
                hint = f"write: vibcli solve {args[0]}"
            raise click.UsageError(f"there is no command '{args[0]}'; {hint}")
        name, command, rest = super().resolve_command(context, args)
        if command is None:
            return name, command, rest
        rest = _by_long_names(command, rest)
        _require_once(command, rest)
        return name, command, rest

    def format_commands(self, context: click.Context, formatter: Any) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


def _by_long_names(command: click.Command, args: "Sequence[str]") -> list[str]:
    """Arguments with the long name of an option in place of its short one, where that cannot be the value of another:
    what click finds at once, without a search for what is spelt nearly so."""
    long = {option.opts[0]: option.opts[-1] for option in command.params if len(option.opts) > 1}
    return [long.get(arg, arg) if i and not args[i - 1].startswith("-") else arg for i, arg in enumerate(args)]


def _require_once(command: click.Command, args: "Sequence[str]") -> None:
    """UsageError of an option with one value that is given twice, of which click would take the last."""
    single = {name: option for option in command.params if isinstance(option, click.Option)
              and not (option.multiple or option.is_flag or option.count) for name in option.opts}
    met, rest = set(), iter(args)
    for arg in rest:
        name, sign, _ = arg.partition("=")
        if arg == "--":
            return
        if name in single and not sign:
            next(rest, None)
        if name in single and single[name] in met:
            raise click.UsageError(f"{' or '.join(single[name].opts)} is given twice, and holds one value")
        met.add(single.get(name))


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]},
             epilog="A scene to start from: vibcli new > scene.yaml; vibcli solve scene.yaml")
@click.version_option(__version__, prog_name="vibcli")
def group() -> None:
    """Mechanical vibration problems: from a scene in YAML to its equations, frequencies and motions."""


def main(args: list[str] | None = None) -> None:
    """Run the command line and leave with its exit code."""
    sys.exit(run(args))


def run(args: list[str] | None = None) -> int:
    """Run the command line; returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure") and stream.errors != "replace":
            stream.reconfigure(errors="replace")
    try:
        code = group.main(args, prog_name="vibcli", standalone_mode=False)
        sys.stdout.flush()
        return code if isinstance(code, int) else 0
    except SpecError as error:
        from vibcli.cli.common import show_diagnostics

        show_diagnostics(error.diagnostics)
        return 3
    except PhysicsError as error:
        from vibcli.cli.common import show_refusal

        show_refusal(error)
        return 4
    except click.exceptions.Exit as exit_:
        return exit_.exit_code
    except click.ClickException as error:
        from vibcli.cli.common import show_usage

        show_usage(error)
        return 2
    except (KeyboardInterrupt, click.Abort):
        click.echo("interrupted", err=True)
        return 130
    except Exception as error:  # the last resort: no traceback reaches a user
        from vibcli.cli.common import fault, show_fault

        show_fault(fault(error))
        if os.environ.get("VIBCLI_TRACEBACK"):
            raise
        return 101
