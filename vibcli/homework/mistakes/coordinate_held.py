"""One of several coordinates held as drawn."""

from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    names = list(problem.scene.coordinates)
    for name in names if len(names) > 1 else ():
        yield name, {"constraints": {"held_fast": {"equation": f"{name} = 0"}}}


MISTAKE = CommonMistake("this holds one of the coordinates fast", model=_changed)
