"""A rolling body that has no rotational energy."""

from vibcli.homework.mistakes.bodies import massive, without_inertia
from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    for name, body in massive(problem):
        if "roll" in body.record:
            yield name, without_inertia(name)


MISTAKE = CommonMistake("it rolls: the energy of its rotation is forgotten", model=_changed)
