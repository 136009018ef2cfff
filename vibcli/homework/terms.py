"""An equation with numbers by its terms: coefficients of functions of coordinates, velocities, accelerations, time.

    Σ cᵢ φᵢ(q, q′, q″, t) = 0        {text of φᵢ: cᵢ}
"""

from collections.abc import Iterator, Mapping
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import NotInLetters
from vibcli.check.verdicts import expected_node, worst_place
from vibcli.homework.in_letters import expression_of, node_in_letters, put_in
from vibcli.notation.ordering import term_rank
from vibcli.notation.scene_language import language
from vibcli.quantities.energies import equation_number
from vibcli.results.random_states import at_states, states
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

Terms = dict[str, float]
OF_NUMBERS = "1"            # the function of a term that is a number
SMALL = 1e-15               # relative: a coefficient beside the others that is none
MOST = 60                   # terms


def terms_of(problem: "Problem", asked: "Expression") -> Terms:
    """The terms of an equation that is asked of a scene with numbers; NotInLetters where numbers stand within its
    functions, so that no coefficients tell it."""
    i = equation_number(problem, asked.tree.indices[0])
    if asked.tree.head != "equation":
        return terms(problem, node_in_letters(problem, asked))
    scene, found = problem.scene, {}
    M, C, G, K = problem.configuration.linear_system.matrices()
    for j, name in enumerate(scene.coordinates):
        damping = C.get((i, j), 0.0) + G.get((i, j), 0.0)
        for primes, number in (("''", M.get((i, j), 0.0)), ("'", damping), ("", K.get((i, j), 0.0))):
            found[name + primes] = float(number)
    size = max(map(abs, found.values()), default=0.0)
    found = {text: number for text, number in found.items() if abs(number) > SMALL * size}
    drive = problem.symbolic.excitation.get(i, scene.table.zero) if scene.timed else scene.table.zero
    for text, number in terms(problem, put_in(problem, drive)).items():
        found[text] = found.get(text, 0.0) - number
    return found


def terms(problem: "Problem", node: "Node") -> Terms:
    """Those of a node with numbers; NotInLetters as above."""
    found: Terms = {}
    for function, constant in sorted(_parts(node, node.table.one), key=_rank):
        text = OF_NUMBERS if function is None else _text(problem, function)
        number, = evaluate([constant], Floats, problem.numeric.floats)
        found[text] = found.get(text, 0.0) + number
        if len(found) > MOST:
            raise NotInLetters(f"this equation has more than {MOST} terms", "ask for equation[…] of small oscillations")
    return {text: number for text, number in found.items() if number}


def _rank(part: "tuple[Node | None, Node]") -> "tuple[int | list[tuple[int, Fraction | int]], ...]":
    """Accelerations first, then what else moves, loads, numbers."""
    function = part[0]
    if function is None:
        return (2,)
    return (function.mask == function.table.time.mask, *term_rank((function, 1)))


def _parts(node: "Node", factor: "Node") -> "Iterator[tuple[Node | None, Node]]":
    """(function, constant) of the terms of a node times a constant factor: sums in brackets are multiplied out."""
    table = node.table
    if not node.mask:
        yield None, factor * node
    elif node.op == "sum":
        for part, c in node.args:
            yield from _parts(part, factor * c)
        if node.coefficient:
            yield None, factor * node.coefficient
    elif node.op == "product":
        constant = table.product(*((base, e) for base, e in node.args if not base.mask)) * node.coefficient
        inner = next((base for base, e in node.args if base.mask and base.op == "sum" and e == 1), None)
        if inner is None:
            yield table.product(*((base, e) for base, e in node.args if base.mask)), factor * constant
            return
        others = table.product(*((base, e) for base, e in node.args if base.mask and base is not inner))
        for part, c in (*inner.args, (table.one, inner.coefficient)):
            if c:
                yield from _parts(table.product((part, ONE), (others, ONE)), factor * constant * c)
    else:
        yield node, factor


def _text(problem: "Problem", function: "Node") -> str:
    """A function in the language of scenes: numbers other than whole ones stand in what follows the time alone."""
    time = problem.scene.time.mask
    for part in reachable([function]):
        of_state = part.mask & ~time
        numbers = [part.coefficient, *(c for _, c in part.args)] if part.op in ("sum", "product") else []
        if of_state and any(number.denominator != 1 for number in numbers):
            raise NotInLetters(f"numbers stand within {language(function)}: no coefficients tell this equation",
                               "ask for equation[…] of small oscillations")
    return language(function)


def fitted(problem: "Problem", asked: "Expression", answer: "Expression", basis: Mapping[str, float]) -> Terms | None:
    """The coefficients of an answer in the terms of a basis, by least squares over random states; None where it is not
    made of these."""
    at, groups = states(problem)
    if asked.tree.head == "equation":
        at = {name: value - problem.numeric.drawn_floats.get(name, 0.0) for name, value in at.items()}
    texts = list(basis)
    nodes = [expected_node(problem, expression_of(text)) for text in texts]
    *columns, wanted = at_states(problem, [*nodes, expected_node(problem, answer)], at)
    sizes = np.array([float(np.abs(one).max()) or 1.0 for one in columns])
    table = np.stack(columns, axis=-1) / sizes
    found, *_ = np.linalg.lstsq(table, wanted, rcond=None)
    if worst_place(wanted, table @ found, groups) is not None:
        return None
    return dict(zip(texts, (found / sizes).tolist(), strict=True))


def alike(one: Mapping[str, float], other: Mapping[str, float], width: float) -> bool:
    """Is there a factor by which each coefficient of the other lies within a relative width of that of the first one?

        λ·otherᵢ ∈ oneᵢ (1 ± width)     for all i
    """
    low, high = -inf, inf
    for text in {**one, **other}:
        a, b = one.get(text, 0.0), other.get(text, 0.0)
        if not a or not b:
            if a or b:
                return False
            continue
        ends = sorted((a * (1 - width) / b, a * (1 + width) / b))
        low, high = max(low, ends[0]), min(high, ends[1])
    return low <= high
