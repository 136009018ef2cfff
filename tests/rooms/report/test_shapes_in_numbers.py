"""Shape functions of members that meet, read back from the printed text, against the modes of the solver."""

import re
from math import cos, cosh, sin, sinh
from pathlib import Path

import pytest
from support.scenes import problem_of, value

from vibcli.report.sections.shapes_in_numbers import shapes_in_numbers

ROOT = Path(__file__).parents[3] / "problems/8_continuous"
LINE = re.compile(r"X\(x\) = (.*?) {3}of (\w+) in mode (\d+)(?:, x in m|, (\S+) m < x < (\S+) m)$")


def printed(scene, members):
    for one in shapes_in_numbers(scene, "first", members):
        text = "".join(getattr(part, "text", part) for part in one.parts)
        found = LINE.match(text)
        assert found, text
        yield found.groups()


@pytest.mark.parametrize(("name", "lengths"), [
    ("two_span_beam", {"girder": 21.0}), ("stepped_bar", {"rod": 1.2}), ("string_with_a_bead", {"string": 0.9}),
    ("portal_frame", {"left": 3.0, "right": 3.0, "girder": 4.0})])
def test_printed_shapes_are_those_of_modes(name, lengths):
    scene = problem_of(ROOT / f"{name}.yaml")
    told = list(printed(scene, list(lengths)))
    assert {(owner, mode) for _, owner, mode, *_ in told} == {(owner, mode) for owner in lengths for mode in "12"}
    for text, owner, mode, start, end in told:
        start, end = float(start or 0), float(end or lengths[owner])
        for share in (0.0, 0.31, 0.77, 1.0):
            x = start + share * (end - start)
            known = eval(text.replace("−", "-").replace("·", "*"), {
                "x": x, "cos": cos, "sin": sin, "cosh": cosh, "sinh": sinh})
            assert known == pytest.approx(value(scene, f"mode[{mode}][{owner}.u({x!r} m)]"), abs=2e-6)


def test_what_is_of_another_equation_is_left_out():
    """Under tension and bending, or where letters have no value, nothing is told."""
    assert not list(shapes_in_numbers(problem_of(ROOT / "piano_string.yaml"), "first", ["string"]))
