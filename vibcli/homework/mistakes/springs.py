"""Springs whose stiffness is mistaken."""

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from vibcli.language.parameter_samples import sample_values
from vibcli.notation.scene_language import language
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def side_by_side(spec: "Spec") -> "Iterator[tuple[Record, Record]]":
    """The pairs of springs with stiffnesses between the same two ends."""
    plain = [record for record in (spec.get("springs") or {}).values() if "k" in record and "between" in record]
    for one, other in combinations(plain, 2):
        if _ends(one) == _ends(other):
            yield one, other


def _ends(record: "Record") -> list[str]:
    """The ends by what they are called, in either order."""
    return sorted(_end(end) for end in record["between"])


def _end(end: "list[Expression] | Reference") -> str:
    return ", ".join(part.text for part in end) if isinstance(end, list) else end.text


def lever_ratio(problem: "Problem", name: str) -> str | None:
    """|∂s/∂q| of a spring as drawn, in the language of scenes, where there is one coordinate and it is one of
    parameters; None elsewhere, and where it is 1."""
    scene = problem.scene
    stretch = next((spring.s for spring in scene.springs if spring.owner == name), None)
    if len(scene.q) != 1 or stretch is None:
        return None
    q, = scene.q
    slope = gradient(stretch).get(q)
    if slope is None:
        return None
    at, = substitute([slope], {q: scene.drawn.get(q, scene.table.zero)})
    if at.is_zero or at.mask:
        return None
    size = -at if _is_negative(problem, at) else at
    return None if size == scene.table.one else language(size)


def _is_negative(problem: "Problem", node: "Node") -> bool:
    """Is an expression of parameters negative at the values that these have, or at some of letters?"""
    parameters = problem.scene.parameters
    values = problem.numeric.floats if not problem.numeric.has_free_symbols else parameters.values(
        Floats, sample_values(parameters.free, 0))
    value: float = evaluate([node], Floats, values)[0]
    return value < 0
