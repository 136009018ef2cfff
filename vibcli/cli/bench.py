"""`vibcli bench FILE`: run time against true error of what a scene asks; without FILE the project's own table."""

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.diagnostics import escaped
from vibcli.cli.common import chosen, color_option, load, patience_option
from vibcli.cli.pictures import FILE, refuse, write

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.evidence.compared import Evidence
    from vibcli.results.problem import Problem

PICTURES, REPORTS = (".svg", ".png", ".pdf"), (".md", ".html", ".txt")
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


@click.command("bench")
@click.argument("file", type=click.Path(), required=False)
@click.option("--of", "quantities", multiple=True, metavar="QUANTITY", help="What: omega (all modes are one), max(x), "
              "peak[x, F]; may be given several times. What the file's answers ask unless given, else its modes.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Give a parameter another value: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--case", "case", metavar="NAME", help="This case of the file, instead of the scene itself.")
@click.option("--json", "as_json", is_flag=True, help="Machine-readable: seconds of processor time, relative errors.")
@click.option("-o", "--output", "outputs", multiple=True, metavar="FILE", type=FILE,
              help="Write the curves (.svg, .png, .pdf) or the tables (.md, .html, .txt); may be given several times.")
@click.option("--force", is_flag=True, help="Replace files that exist.")
@click.option("--quick", is_flag=True, help="3 runs of each instead of 7.")
@click.option("--only", multiple=True, metavar="PART", help="Without FILE: only this part; may be given several times.")
@click.option("--against", metavar="OLD.json", type=click.Path(exists=True, dir_okay=False), help="Compare ratios of "
              "run times with those of an older --json; exit code 1 where one is worse in two runs out of two.")
@click.option("--skipped", is_flag=True, help="What each question takes of a scene and of the program, and what it "
              "skips; of FILE, else of an example.")
@patience_option
@color_option
def command(file: str | None, quantities: Sequence[str], settings: Sequence[str], case: str | None, as_json: bool,
            outputs: Sequence[str], force: bool, quick: bool, only: Sequence[str], against: str | None, skipped: bool,
            patience: int) -> int:
    """Run time against true error of all methods that answer, each number beside one of many digits.

    Without FILE the project's own measurements, which take minutes: vibcli explain bench.
    """
    if skipped:
        if quantities or settings or case or outputs or against or only:
            raise click.UsageError("--skipped asks all questions of a scene as it is: of the other options only --json "
                                   "goes with it")
        return _skipped(file, as_json)
    if against and (as_json or outputs):
        raise click.UsageError("--against prints the ratios alone: leave --json and -o out")
    if file is None:
        if quantities or settings or case or outputs or against:
            raise click.UsageError("--of, --set, --case, --against and -o are for a scene: name its FILE")
        return _own_measurements(quick, as_json, only)
    if only:
        raise click.UsageError("--only names parts of the project's own measurements, which take no FILE")
    for path in map(Path, outputs):
        refuse(path, (*PICTURES, *REPORTS), force)
    for name in ONE_THREAD:         # processor time counts what threads wait for; before NumPy is imported
        os.environ.setdefault(name, "1")
    from vibcli.evidence.subject import NOTHING_ELSE

    before = _older(against)
    problem = chosen(load(file, settings, patience), case)[0][1]
    found = _evidence(problem, quantities, quick)
    if before is not None:
        return _against(before, found, lambda: _evidence(problem, quantities, quick))
    _told(found, as_json)
    for path in map(Path, outputs):
        _write(found, path, force)
    return 0 if found.compared or all(one.why in NOTHING_ELSE for one in found.left_out) else 4


def _skipped(file: str | None, as_json: bool) -> int:
    import json

    from vibcli.cli.common import problem_in, source_of
    from vibcli.evidence import skipped
    from vibcli.report.formats.text import render

    if file is not None:
        problem_in(source_of(file), ())         # whatever is wrong with it
    found = skipped.every_question(file or skipped.example())
    click.echo(json.dumps(skipped.data(found), ensure_ascii=False, indent=1) if as_json else
               render([skipped.document(found)]))
    return 0


def _own_measurements(quick: bool, as_json: bool, only: Sequence[str]) -> int:
    options = [*["--quick"] * quick, *["--json"] * as_json, *(part for name in only for part in ("--only", name))]
    return subprocess.run([sys.executable, "-m", "vibcli.bench", *options], check=False).returncode


def _evidence(problem: "Problem", quantities: Sequence[str], quick: bool) -> "Evidence":
    from vibcli.api.values import checked_quantity
    from vibcli.cli.sampled import asked
    from vibcli.evidence.asked import ALL_MODES
    from vibcli.evidence.compared import evidence
    from vibcli.evidence.timing import FEW, RUNS

    trees = [checked_quantity(problem.spec, asked(text + "[1]" * (text in ALL_MODES), "--of")) for text in quantities]
    return evidence(problem, trees, FEW if quick else RUNS)


def _older(path: str | None) -> dict[str, Any] | None:
    """An older comparison as data; a usage error of what is none."""
    from vibcli.evidence.against import older

    if path is None:
        return None
    try:
        return older(path)
    except (ValueError, OSError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise click.UsageError(f"--against {path}: {reason}") from None


def _against(before: dict[str, Any], found: "Evidence", again: "Callable[[], Evidence]") -> int:
    from vibcli.evidence.against import beside, document, worse_in_both
    from vibcli.report.formats.text import render

    first = beside(before, _data(found))
    last = beside(before, _data(again())) if any(row.worse for row in first.rows) else first
    worse = worse_in_both(first, last)
    click.echo(render([document(last, worse)]))
    return 1 if worse else 0 if last.rows else 4


def _data(found: "Evidence") -> dict[str, Any]:
    import platform

    from vibcli import __version__
    from vibcli.evidence.told import data

    return {"version": __version__, "machine": f"{platform.system()} {platform.machine()}", **data(found)}


def _told(found: "Evidence", as_json: bool) -> None:
    import json

    from vibcli.evidence import told
    from vibcli.report.formats.text import render

    click.echo(json.dumps(_data(found), ensure_ascii=False, allow_nan=False, indent=1) if as_json else
               render([told.document(found)]))


def _write(found: Any, path: Path, force: bool) -> None:
    """The curves of what is worth a picture, one figure for all; or the report with its pictures beside it."""
    from vibcli.evidence import told

    if path.suffix.lower() in PICTURES:
        from vibcli.evidence.picture import figure, picture_of

        shown = [one for one in found.compared if told.worth_a_picture(one)]
        if not shown:
            click.echo(f"no picture is written to {escaped(str(path))}: nothing is compared", err=True)
            return
        write(path, picture_of(figure(shown))(path.suffix[1:].lower()), force)
        return
    from vibcli.cli.reports import Output, write_documents
    from vibcli.report.formats import FORMATS

    kind = next(name for name, (suffixes, _, _) in FORMATS.items() if path.suffix.lower() in suffixes)
    write_documents([told.document(found, pictures=kind != "text")], Output(kind, path, True, force))
