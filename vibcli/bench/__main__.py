"""Run every measurement and print one table; the exit code is 1 where a budget is exceeded."""

import json
import sys
import tempfile
from typing import Any

import click

from vibcli.bench import (
    accuracy,
    asked_motions,
    files,
    growth,
    lagranges_method,
    linkage,
    members,
    responses,
    startup,
    sweeps,
    trajectories,
)
from vibcli.bench.rows import HEAD, aligned


@click.command()
@click.option("--quick", is_flag=True, help="Three runs of each instead of eleven.")
@click.option("--json", "as_json", is_flag=True, help="The table as JSON.")
@click.option("--only", type=click.Choice(["startup", "growth", "linkage", "files", "accuracy", "responses",
                                           "trajectories", "asked_motions", "members", "sweeps"]), multiple=True,
              help="Only these measurements.")
@click.option("--sympy", "slow", is_flag=True, help="Also SymPy's LagrangesMethod on the pendulum; takes seconds.")
def main(quick: Any, as_json: bool, only: Any, slow: complex):
    """Processor time, memory, growth and accuracy of vibcli against baselines measured in the same run."""
    runs = 3 if quick else 11
    with tempfile.TemporaryDirectory() as folder:
        parts = {"startup": lambda: startup.rows(runs, folder), "growth": lambda: growth.rows(runs),
                 "linkage": lambda: linkage.rows(runs), "files": lambda: files.rows(3 if quick else 9, folder),
                 "accuracy": lambda: accuracy.rows(runs), "responses": lambda: responses.rows(runs),
                 "trajectories": lambda: trajectories.rows(runs), "asked_motions": lambda: asked_motions.rows(runs),
                 "members": lambda: members.rows(runs), "sweeps": lambda: sweeps.rows(runs)}
        rows = [row for name, part in parts.items() if not only or name in only for row in part()]
        if slow:
            rows += lagranges_method.rows(runs)
    if as_json:
        click.echo(json.dumps([row.data() for row in rows], indent=1, ensure_ascii=False))
    else:
        click.echo(aligned([HEAD, *(row.cells() for row in rows)]))
    sys.exit(int(not all(row.kept for row in rows)))


if __name__ == "__main__":
    main()
