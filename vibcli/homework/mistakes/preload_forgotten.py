"""A spring without its tension at rest."""

from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    for name, record in (problem.spec.get("springs") or {}).items():
        if "preload" in record and record["preload"] != "static" and "torsion" not in record:
            yield name, {"springs": {name: {"preload": "0"}}}


MISTAKE = CommonMistake("the tension of the spring at rest is forgotten: it adds to the stiffness", model=_changed)
