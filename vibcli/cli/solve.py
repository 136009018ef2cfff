"""`vibcli solve FILE`: the whole solution."""

import click

from vibcli.cli.common import chosen, load, number_options, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.quantities.quantity import INSIGHT, ON_REQUEST

FOUND_BY = {"equations": ("energies", "equations"), "energies": ("energies",),
            "equilibrium": ("equilibrium", "virtual_work"), "frequencies": ("frequencies",), "modes": ("modes",),
            "damping": ("damping",), "virtual_work": ("virtual_work",)} | {word: (word,) for word in ON_REQUEST}


@click.command("solve")
@scene_options
@report_options
@number_options
@click.option("--insight", is_flag=True, help="Also whose energy each mode has, what its frequency depends on, and "
              "estimates of the lowest one.")
def command(file, settings, case, as_json, patience, timings, digits, normalise, insight, **report):
    """The solution of a scene: equilibrium, energies, equations of motion, frequencies, damping, modes; or what `find`
    in the file asks, responses too."""
    from vibcli.report.document import EVERYTHING

    output = output_of(file, as_json, **report)
    problems = chosen(load(file, settings, patience), case)

    def sections(problem):
        wanted = problem.spec.get("find")
        if wanted is None:
            return EVERYTHING + INSIGHT * insight
        asked = {"given", "chosen", "coordinates", *INSIGHT * insight} | {s for word in wanted for s in FOUND_BY[word]}
        return [s for s in EVERYTHING + ON_REQUEST if s in asked]

    return print_scenes(problems, sections, output, timings, digits, normalise,
                        ("equations", "frequencies", "equilibria"), question=True)
