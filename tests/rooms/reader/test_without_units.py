"""Scenes without any unit: every scene reads the same with its values in SI and no units, and answers as before."""

import json
import re
from pathlib import Path

import mpmath
import pytest
import yaml
from support.documents import LOADER
from support.scenes import problem

from vibcli.base.errors import SpecError
from vibcli.check.verdicts import check
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import ExpressionError, parts_of

ROOT = Path(__file__).parents[3]
SCENES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml")])
WORDS = ("title", "source", "question", "about", "sign", "unused", "unit", "shape", "find", "motion", "records")


def bare(text):
    """A text with each value in SI and without unit; other texts as they are."""
    if order := re.search(r" [<>]=? ", text):
        return bare(text[:order.start()]) + order.group() + bare(text[order.end():])
    try:
        tree = parse(text, "x = y" if "=" in text else None)
    except ExpressionError:
        return text
    parts, pending = [], [tree]
    while pending:
        tree = pending.pop()
        parts += parts_of(tree).numbers
        pending += [arg for part in _quantities(tree) for arg in part.args]
    for start, end, value, chain, _ in sorted(parts, reverse=True):
        if chain:
            unit = literal_unit(chain)
            number = repr(float(value)) if unit.value == 1 and not (unit.pi or unit.roots) else repr(unit.in_si(value))
            whole = (start, text[end:].strip()) == (0, "")
            text = text[:start] + (number if whole else f"({number})") + text[end:]
    return text


def _quantities(tree):
    from vibcli.symbolic.syntax import parts_of

    return parts_of(tree).quantities


def stripped(node, key=None):
    if isinstance(node, dict):
        return {bare(name) if key == "answers" else name: stripped(part, name if key != "answers" else None)
                for name, part in node.items() if name != "unit"}
    if isinstance(node, list):
        return [stripped(part) for part in node]
    return node if key in WORDS else bare(node)


def scene(path, close=False):
    """The Problem of a scene without its units; `close`: with answers that agree to half a percent."""
    found = stripped(yaml.load(path.read_text(encoding="utf-8"), Loader=LOADER))
    for part in (found, *found.get("cases", {}).values()) if close else ():
        for asked, value in part.get("answers", {}).items():
            if isinstance(value, str) and "=" not in value and value not in ("true", "false"):
                part["answers"][asked] = {"value": value, "rtol": "0.005"} if value.strip("-0.") else value
    node, diagnostics = read(json.dumps(found, indent=1).replace(': ""', ": ").encode(), str(path))
    return Problem(read_spec(node, str(path), diagnostics))


UNITS = [path for path in SCENES if "records:" not in path.read_text(encoding="utf-8")]
CYCLIC = [path for path in UNITS if "Hz" in path.read_text(encoding="utf-8")]       # without it Hz would be rad/s


@pytest.mark.parametrize("path", UNITS[::5] + CYCLIC, ids=lambda path: path.stem)
def test_every_scene_may_be_without_units(path):
    assert scene(path).spec.free_numbers


@pytest.mark.sweep
@pytest.mark.parametrize("path", [path for path in UNITS[::20] if path not in CYCLIC], ids=lambda path: path.stem)
def test_answers_are_those_in_units(path):
    assert [verdict.answer.asked.text for verdict in check(scene(path, True)) if not verdict.agrees] == []


OSCILLATOR = """
parameters: {k: 800, c: 2*k, b: 3*sqrt(2)}
bodies: {a: {mass: 2, slide: x}}
springs: {s: {law: d + 2*d^3, between: [ground, a]}}
dampers: {r: {c: c/1600, between: [ground, a]}}
forces: {F: {coordinate: x, value: 3*cos(2*t)}}
energies: {V: b*x^4 + 3*x^2/2}
motion: full
answers: {"x(2)": 1}
"""


@pytest.mark.sweep
def test_coefficients_may_have_units_that_are_not_written():
    """2 x'' + x' + x + 2 x³ + 4 b x³ + 3 x = 3 cos 2t from rest, by a Taylor series of its own."""
    b = 3 * mpmath.sqrt(2)
    solution = mpmath.odefun(lambda t, y: [y[1], (3 * mpmath.cos(2 * t) - y[1] - 4 * y[0] - (2 + 4 * b) * y[0]**3) / 2],
                             0, [0, 0])
    verdict, = check(problem(OSCILLATOR))
    assert verdict.found == pytest.approx(float(solution(2)[0]), rel=1e-8)


@pytest.mark.parametrize("change", ["", "mass: 2 -> mass: m", "k: 800 -> k: 800 N/m"])
def test_letters_and_units_are_still_checked(change):
    text = """
parameters: {k: 800, m: }
bodies: {a: {mass: 2, slide: x}}
springs: {s: {k: k + 2*m, between: [ground, a]}}
energies: {T: m*x'^2}
"""
    old, _, new = change.partition(" -> ")
    text = text.replace(old, new) if old else text.replace("k: 800", "k:").replace("mass: 2", "mass: m")
    if old.startswith("mass"):
        problem(text)
        return
    with pytest.raises(SpecError, match="expected a"):
        problem(text)
