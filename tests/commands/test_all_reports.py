"""Every problem in every format: no line too long, no rounding, no unit as it was typed, nothing left open."""

import json
from contextlib import suppress
from pathlib import Path

import pytest
from support.renderings import FORMATS, faults, unbalanced
from support.scenes import kept_problem_of

from vibcli.api.reports import data, report, solution
from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled

FILES = sorted((Path(__file__).parents[2] / "problems").glob("*/*.yaml"))


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_of_all_problems(path):
    found = settled(kept_problem_of(path))
    sections = solution(found)
    assert not faults(report(found, sections).document(), FORMATS)
    with suppress(PhysicsError):
        json.dumps(data(found, ("equations", "frequencies", "equilibria"), "first", None, sections),
                   allow_nan=False, default=str)


def test_what_is_not_closed_is_seen():
    assert unbalanced(r"\begin{align*} \left( \frac{a}{b} \right) \\{x\\} \end{align*}") == []
    for wrong in (r"\frac{a}{b", r"a}", r"\left( a", r"\begin{align*} a", r"\begin{a} { \end{a} }"):
        assert unbalanced(wrong)
