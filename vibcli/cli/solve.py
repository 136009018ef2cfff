"""`vibcli solve FILE`: the whole solution."""

import click

from vibcli.cli.common import chosen, load, number_options, scene_options
from vibcli.cli.output import print_scenes

FOUND_BY = {"equations": ("energies", "equations"), "energies": ("energies",), "equilibrium": ("equilibrium",),
            "equilibria": ("equilibria",), "frequencies": ("frequencies",), "modes": ("modes",),
            "damping": ("damping",)}


@click.command("solve")
@scene_options
@number_options
def command(file, settings, case, as_json, timings, digits, normalise):
    """The whole solution of a scene: equilibrium, energies, equations of motion, frequencies, damping, modes."""
    from vibcli.report.text import EVERYTHING, ORDER

    problems = chosen(load(file, settings), case)

    def sections(problem):
        wanted = problem.spec.get("find")
        if wanted is None:
            return EVERYTHING
        asked = {section for word in wanted.words for section in FOUND_BY[word]}
        return [s for s in ORDER if s in asked or s in ("given", "coordinates")]

    return print_scenes(problems, sections, as_json, timings, digits, normalise,
                        ("equations", "frequencies", "equilibria"), question=True)
