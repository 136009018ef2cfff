"""`vibcli check PATH…`: the answers in problem files against the results."""

import os
import sys
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.diagnostics import escaped
from vibcli.base.garbage import GARBAGE
from vibcli.cli.checking.files import scenes_below
from vibcli.cli.checking.found import CheckedFile
from vibcli.cli.checking.text import is_told, summary, tell_in_full, tell_in_short, tell_troubles
from vibcli.cli.common import color_option, patience_option
from vibcli.cli.pictures import FILE

if TYPE_CHECKING:
    from vibcli.cli.checking.cache import Cache

GRAVEST = (101, 3, 4, 1, 0)
STDIN = "-"
FULL, CONCISE = "full", "concise"
FORMATS = (FULL, CONCISE, "json", "junit", "github", "sarif")


@click.command("check")
@click.argument("paths", nargs=-1, required=True, type=click.Path())
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Give a parameter another value, in every file: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--format", "form", type=click.Choice(FORMATS), help="How it is told: in full, a line for each thing "
              "that is wrong, or for other programs (vibcli explain ci).")
@click.option("--json", "as_json", is_flag=True, help="Verdicts as JSON: --format json.")
@click.option("-o", "--output", metavar="FILE", type=FILE,
              help="Write the report to a file (json, xml, sarif, txt), and tell in full as well.")
@click.option("--force", is_flag=True, help="Replace the file if it exists.")
@click.option("--quiet", "-q", is_flag=True, help="Print only what does not agree.")
@click.option("--jobs", "-j", type=click.IntRange(1, 256), default=1, metavar="N",
              help="Check N files at a time, in processes of their own.")
@click.option("--max-failures", type=click.IntRange(1), metavar="N",
              help="Stop where N answers differ, are uncertain, or files could not be checked.")
@click.option("--changed-since", "revision", metavar="REV",
              help="Only files that differ from a revision of git, or whose records do.")
@click.option("--stdin-name", metavar="FILE", help="The name of the scene that is read from stdin, as '-'.")
@click.option("--no-cache", is_flag=True, envvar="VIBCLI_NO_CACHE", help="Check anew what was checked before.")
@click.option("--cache-dir", metavar="FOLDER", type=click.Path(),
              help="Where results are kept for the next time; unless named, .vibcli_cache beside the first path.")
@patience_option
@color_option
def command(paths: Sequence[str], settings: Sequence[str], form: str | None, as_json: bool, output: str | None,
            force: bool, quiet: bool, jobs: int, max_failures: int | None, revision: str | None,
            stdin_name: str | None, no_cache: bool, cache_dir: str | None, patience: int) -> int:
    """Compare the answers in scene files (and in folders of them) with the results.

    Exit code: 0 all agree, 1 an answer differs, 3 a file is invalid, 4 a scene cannot be solved or whether an answer
    agrees is uncertain (of several the gravest of 3, 4, 1), 5 no answer was found to check, 130 interrupted: what was
    found by then is told.
    """
    if as_json and form not in (None, "json"):
        raise click.UsageError(f"--json and --format {form} are two ways to tell it: choose one")
    form = "json" if as_json else form
    if stdin_name is not None and STDIN not in paths:
        raise click.UsageError("--stdin-name names what is read from stdin: give '-' as a path")
    path, form = _target(output, form, force)
    files, on_screen = _chosen(paths, revision), FULL if output or form is None else form
    if revision is not None and not files:
        click.echo(escaped(f"no scene has changed since {revision}"))
        return 0
    tell = partial(_tell, on_screen=on_screen, quiet=quiet)
    cache = None if no_cache else _cache(cache_dir, paths, [settings, patience])
    found, left, interrupted = [], 0, False
    try:
        for one in _each(files, jobs, cache, settings, patience, stdin_name, partial(is_told, quiet=quiet)):
            tell(one)
            found.append(one)
            if max_failures and sum(each.failures for each in found) >= max_failures:
                left = len(files) - len(found)
                break
    except KeyboardInterrupt:
        interrupted = True
    _finish(found, on_screen, form, path, force, left)
    if interrupted:
        raise KeyboardInterrupt
    code = next(code for code in GRAVEST if code in {0, *(one.code for one in found)})
    return 5 if code == 0 and not any(answer.data["agrees"] for one in found for answer in one.answers) else code


def _tell(one: CheckedFile, on_screen: str, quiet: bool) -> None:
    """Tell of a file as soon as it is checked."""
    if on_screen == CONCISE:
        tell_in_short(one)
        return
    tell_troubles(one)
    if on_screen == FULL:
        tell_in_full(one, quiet)


def _target(output: str | None, form: str | None, force: bool) -> tuple[Path | None, str | None]:
    """(the Path to write to or None, the form of what is written there, or else told)."""
    if output is None:
        return None, form
    from vibcli.cli.checking.reports import FORMS
    from vibcli.cli.pictures import target

    by_suffix = {suffix: name for name, (_, suffixes) in FORMS.items() for suffix in suffixes}
    if form in (FULL, CONCISE):
        raise click.UsageError(f"--format {form} is told on the screen: -o writes {', '.join(FORMS)}")
    path = target(None, output, list(by_suffix) if form is None else None, force)
    return path, form or by_suffix[path.suffix.lower()]


def _finish(found: Sequence[CheckedFile], on_screen: str, form: str | None, path: Path | None, force: bool,
            left: int) -> None:
    """What is told at the end, and written."""
    if on_screen in (FULL, CONCISE):
        click.echo(summary(found) + (f"; {left} more left, as so many fail" if left else ""))
        if on_screen == FULL and os.environ.get("GITHUB_ACTIONS") == "true":
            click.echo(_report("github", found), nl=False)
    else:
        click.echo(_report(on_screen, found), nl=False)
    if path is not None:
        from vibcli.cli.pictures import write

        write(path, _report(form, found).encode("utf-8", "replace"), force)     # as on the screen


def _report(form: str, found: Sequence[CheckedFile]) -> str:
    from vibcli.cli.checking.reports import FORMS

    return FORMS[form][0](found)


def _each(files: Sequence[str], jobs: int, cache: "Cache | None", settings: Sequence[str], patience: int,
          stdin_name: str | None, said: Callable[[Any], bool]) -> Iterator[CheckedFile]:
    """The CheckedFile of each file, in their order: those that are kept, the others checked, several at a time."""
    known = {} if cache is None else {file: one for file in files if file != STDIN and (one := cache.find(file))}
    rest = [file for file in files if file not in known]
    work: Callable[[str], CheckedFile] = partial(_checked, cache, settings, patience)
    if STDIN in rest:
        work = partial(_from_stdin, _stdin(), stdin_name or "stdin", settings, patience, work)
    checked: Iterator[CheckedFile] = map(work, rest)
    if jobs > 1 and len(rest) > 1:
        from vibcli.cli.checking.work import not_checked
        from vibcli.cli.jobs import in_processes

        checked = in_processes(work, rest, min(jobs, len(rest)), said, not_checked,
                               None if cache is None else cache.seconds)
    for file in files:
        yield known[file] if file in known else next(checked)


def _checked(cache: "Cache | None", settings: Sequence[str], patience: int, file: str) -> CheckedFile:
    GARBAGE.clear()
    from vibcli.cli.checking.work import checked_file

    check = partial(checked_file, settings=settings, patience=patience)
    return check(file) if cache is None else cache.checked(file, check)


def _from_stdin(data: bytes, name: str, settings: Sequence[str], patience: int, work: Callable[[str], CheckedFile],
                file: str) -> CheckedFile:
    if file != STDIN:
        return work(file)
    from vibcli.cli.checking.work import checked_file

    return checked_file(name, settings, patience, data)


def _stdin() -> bytes:
    """What stdin holds, no more than a scene may."""
    from vibcli.base.decoding import MAX_BYTES

    try:
        return sys.stdin.buffer.read(MAX_BYTES + 1)
    except (OSError, AttributeError) as error:      # there is no stream where it is closed
        why = getattr(error, "strerror", None) or "it is closed"
        raise click.UsageError(f"stdin cannot be read: {why}") from None


def _cache(folder: str | None, paths: Sequence[str], options: Sequence[Any]) -> "Cache | None":
    """The Cache, None with a warning where it cannot be used, and where all comes from stdin."""
    from vibcli.cli.checking.cache import Cache, Unusable, folder_of

    named = [path for path in paths if path != STDIN]
    if not named and folder is None:
        return None
    place = folder_of(named) if folder is None else Path(folder)
    try:
        return Cache(place, options)
    except Unusable as error:
        click.echo(escaped(f"warning: {place} cannot keep results: {error}; all is checked anew"), err=True)
        return None


def _chosen(paths: Sequence[str], revision: str | None) -> list[str]:
    """The files that the paths name, or those of them that have changed since a revision."""
    files = [file for path in paths for file in ([path] if path == STDIN else scenes_below(path))]
    if revision is None:
        return files
    from vibcli.cli.checking.changed import changed_since

    if STDIN in files:
        raise click.UsageError("--changed-since asks git of files: stdin is none")
    return changed_since(revision, files)
