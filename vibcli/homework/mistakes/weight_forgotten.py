"""The scene without gravity."""

from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    if problem.spec.get("gravity") is not None:
        yield "", {"gravity": "0"}


MISTAKE = CommonMistake("the weight is forgotten: it counts in the equilibrium or in the stiffness", model=_changed)
