"""What each question takes and what it skips: the stages of its scene, as commands tell their timings, and the packages
and rooms that a process of its own imports. Found by asking, never written down."""

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Document, Section, TableBlock, paragraph

PACKAGES = ("numpy", "mpmath", "scipy", "sympy", "matplotlib")
SCENE = "forced_vibration.yaml"      # of vibcli/examples: one degree, damped, driven, in numbers
QUESTIONS = {
    "solve": ("solve",), "solve --insight": ("solve", "--insight"), "solve --steps": ("solve", "--steps"),
    "equations": ("equations",), "frequencies": ("frequencies",), "frequencies --digits 30": (
        "frequencies", "--digits", "30"),
    "response": ("response",), "frf": ("frf",), "check": ("check",),
}
IN_A_PROCESS = """
import contextlib, io, json, sys
from vibcli.cli.program import run
out, err = io.StringIO(), io.StringIO()
with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
    code = run(sys.argv[1:])
print(json.dumps([code, err.getvalue(), sorted(sys.modules)]))
"""
WITHOUT_TIMINGS = ("check",)
ANSWERED, REFUSED = (0, 1), 4       # exit codes: 1 of a check in which answers differ
TAKEN, SKIPPED, NOT_TOLD = "•", "", "?"


class Taken(NamedTuple):
    """What a question takes. stages: {stage: was it?}, empty where the command does not tell; packages, rooms: names;
    modules: how many of its own; refused: why the scene has no answer to it."""

    stages: dict[str, bool]
    packages: tuple[str, ...]
    rooms: tuple[str, ...]
    modules: int
    refused: str = ""


def taken(*args: str) -> Taken:
    """By a command, in a process of its own; RuntimeError where that fails for no reason of the scene."""
    done = subprocess.run([sys.executable, "-c", IN_A_PROCESS, *args], capture_output=True, text=True, check=True)
    code, told, modules = json.loads(done.stdout)
    if code not in (*ANSWERED, REFUSED):
        raise RuntimeError(f"{' '.join(args)} leaves with {code}: {told.strip()}")
    lines = [line.split() for line in told.splitlines() if len(line.split()) == 2]
    own = [name.split(".") for name in modules if name.startswith("vibcli.")]
    stages = {stage: cost != "skipped" for stage, cost in lines if stage != "stage"}
    packages, rooms = (name for name in PACKAGES if name in modules), sorted({name[1] for name in own})
    refused = "" if code != REFUSED else told.partition("error: ")[2].partition("\n")[0]
    return Taken({} if refused else stages, tuple(packages), tuple(rooms), len(own), refused)


def every_question(file: str) -> dict[str, Taken]:
    """{question: what it takes} of a scene."""
    return {question: taken(command, file, *options, *["--timings"] * (command not in WITHOUT_TIMINGS))
            for question, (command, *options) in QUESTIONS.items()}


def example() -> str:
    """The scene that is asked unless one is named."""
    import vibcli

    return str(Path(vibcli.__file__).parent / "examples" / SCENE)


def document(found: Mapping[str, Taken]) -> Document:
    """Question × stage, and question × package and room."""
    questions = tuple(found)
    stages = list(dict.fromkeys(stage for one in found.values() for stage in one.stages))
    rooms = sorted({room for one in found.values() for room in one.rooms})
    by_stage = tuple((stage, *(_mark(found[question].stages.get(stage, None if not found[question].stages else False))
                               for question in questions)) for stage in stages)
    by_module = tuple((name, *(_mark(name in (*found[question].packages, *found[question].rooms))
                               for question in questions)) for name in (*PACKAGES, *rooms))
    counts = ("modules of its own", *(str(one.modules) for one in found.values()))
    return Document("What each question takes, and what it skips", None, (), (
        Section("Stages", (TableBlock(("stage", *questions), by_stage), paragraph(
            f"{TAKEN} taken; empty: skipped; {NOT_TOLD} a command that tells no stages."),
            *(paragraph(f"{question}: {one.refused}") for question, one in found.items() if one.refused))),
        Section("Packages and rooms", (TableBlock(("", *questions), (*by_module, counts)), paragraph(
            f"{TAKEN} imported.")))))


def _mark(taken: bool | None) -> str:
    return NOT_TOLD if taken is None else TAKEN if taken else SKIPPED


def data(found: Mapping[str, Taken]) -> dict[str, Any]:
    """The same as data."""
    return {question: {"stages": one.stages or None, "packages": one.packages, "rooms": one.rooms,
                       "modules": one.modules, "refused": one.refused or None} for question, one in found.items()}
