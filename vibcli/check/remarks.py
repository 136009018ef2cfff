"""What is said of an answer that differs: the known mistake that leads to it, else by how much it is off."""

from math import isfinite
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.mistakes import MODEL
from vibcli.mistakes.known import KnownMistake, of_catalogue
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import value_of

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Mapping
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

CLOSE, NEAR = 1e-3, 1e-4        # relative: what a mistake leads to; what is told as a difference, not as a ratio


def remark(problem: "Problem", asked: "Expression", expected: float, found: float,
           root: "Mapping | None" = None) -> str | None:
    """The sentence of the mistake that leads nearest to what is expected, one of the model first, else the ratio; root:
    the document of the scene, without which mistakes of its model are not looked for. None where one of the two is
    zero."""
    if not found or not expected:
        return None
    near = []
    for mistake in of_catalogue(problem, root, [asked]):
        wrong = _wrong(problem, mistake, asked, found)
        off = abs(wrong / expected - 1) if wrong is not None and isfinite(wrong) else CLOSE
        if off < CLOSE and abs(wrong / found - 1) > NEAR:
            near.append((mistake.kind != MODEL, off, mistake.told))
    if near:
        return min(near)[-1]
    ratio = expected / found
    return f"off by {abs(ratio - 1):.2g} of it" if abs(ratio - 1) < NEAR else f"ratio {ratio:.6g}"


def _wrong(problem: "Problem", mistake: KnownMistake, asked: "Expression", found: float) -> float | None:
    from vibcli.inverse import settled

    try:
        scene = problem if mistake.problem is None else settled(mistake.problem)
        return mistake.wrong(asked, unit_of(problem.spec, asked), found, lambda one: float(value_of(scene, one)[0]))
    except (SpecError, PhysicsError):
        return None
