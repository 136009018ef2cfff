"""Run every measurement and print one table; the exit code is 1 where a budget is exceeded or a part fails."""

import json
import sys
from importlib import import_module
from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage
from time import perf_counter
from typing import Any

import click

from vibcli.bench import PARTS
from vibcli.bench.rows import HEAD, Failure, aligned

RUNS, FEW = 7, 3


@click.command()
@click.option("--quick", is_flag=True, help=f"{FEW} runs of each instead of {RUNS}.")
@click.option("--json", "as_json", is_flag=True, help="The table as JSON.")
@click.option("--only", type=click.Choice(list(PARTS)), multiple=True, help="Only these measurements.")
@click.option("--sympy", "slow", is_flag=True, help="Also SymPy's LagrangesMethod on the pendulum; takes seconds.")
def main(quick: bool, as_json: bool, only: tuple[str, ...], slow: bool) -> None:
    """Processor time, memory, growth and accuracy of vibcli against baselines measured in the same run."""
    rows: list[Any] = []
    for part in [*(only or PARTS), *["lagranges_method"] * slow]:
        start, spent = perf_counter(), _processor()
        try:
            measured(part, FEW if quick else RUNS, rows)
        except KeyboardInterrupt:
            rows.append(Failure(part, "interrupted, and the parts after it"))
            break
        click.echo(f"{part}: {perf_counter() - start:.0f} s, {_processor() - spent:.0f} s of the processor", err=True)
    if as_json:
        click.echo(json.dumps([row.data() for row in rows], indent=1, ensure_ascii=False))
    else:
        click.echo(aligned([HEAD, *(row.cells() for row in rows)]))
    sys.exit(int(not all(row.kept for row in rows)))


def _processor() -> float:
    """Seconds of this process and of those that it waited for."""
    return sum(found.ru_utime + found.ru_stime for found in map(getrusage, (RUSAGE_SELF, RUSAGE_CHILDREN)))


def measured(part: str, runs: int, rows: list[Any]) -> None:
    """Add the rows of a part, as far as they come, and why it fails where it does."""
    try:
        for row in import_module(f"vibcli.bench.{part}").rows(runs):
            rows.append(row)
    except Exception as error:
        rows.append(Failure(part, f"{type(error).__name__}: {error}"))


if __name__ == "__main__":
    main()
