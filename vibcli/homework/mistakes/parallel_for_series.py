"""Springs one behind the other as if they stood side by side."""

from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    for name, record in (problem.spec.get("springs") or {}).items():
        parts = record.get("series") or ()
        if parts and all("k" in part for part in parts):
            k = " + ".join(f"({part['k'].text})" for part in parts)
            yield name, {"springs": {name: {"k": k, "series": None}}}


MISTAKE = CommonMistake("these springs carry the same force: their compliances add up", model=_changed)
