"""The scene without a damper."""

from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    for name, record in (problem.spec.get("dampers") or {}).items():
        if "c" in record:
            yield name, {"dampers": {name: {"c": "0"}}}


MISTAKE = CommonMistake("the damper is forgotten", model=_changed)
