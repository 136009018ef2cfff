"""Do expressions that lines tell agree with those of the engine, at values of the letters and at states of motion?"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import isnan
from random import Random
from typing import TYPE_CHECKING

from vibcli.language.parameter_samples import sample_values
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAMPLES, STATES = (60, 61, 62), 3
SIZES = (1, 0.1, 0.01)      # of a state of motion, in SI units
LONG = 3.0                  # seconds that are looked at, behind what begins and ends
ALIKE = 1e-9                # relative: of an expression and its simpler form at values of the letters
LEFT = 1e-7                 # relative: of forces at rest, whose place may be known in numbers


def samples_of(problem: "Problem", known: Mapping[str, float]) -> list[dict[str, float]]:
    """Values of the parameters, those of the file or some of letters, at which expressions are held against each
    other; `known`: those of further letters."""
    if not problem.numeric.has_free_symbols:
        return [{**problem.numeric.floats, **known}]
    parameters = problem.scene.parameters
    return [{**parameters.values(Floats, sample_values(parameters.free, attempt)), **known} for attempt in SAMPLES]


def same(one: "Node", other: "Node", samples: "Sequence[Mapping[str, float]]") -> bool:
    """Are two expressions of the parameters equal at values of these?"""
    for values in samples:
        a, b = evaluate([one, other], Floats, values)
        if not abs(a - b) <= ALIKE * max(abs(a), abs(b)):
            return False
    return True


def tidy(node: "Node", samples: "Sequence[Mapping[str, float]]") -> "Node":
    """The simplest form of an expression without coordinates; itself where the simpler one is not the same."""
    found = textbook(node)
    if is_zero(found):
        return node.table.zero
    shortened = shorter(found)
    best = shortened if letters(shortened) < letters(found) else found
    return best if same(best, node, samples) else node


def agree_in_motion(scene: "Scene", samples: "Sequence[Mapping[str, float]]", one: "Sequence[Node]",
                    other: "Sequence[Node]", more: "Sequence[Node]" = ()) -> bool:
    """Have two lists of terms, functions of the motion, the time and `more`, the same sum at states of motion?"""
    draw, symbols = Random("states"), (*scene.q, *scene.v, *scene.a, *more)
    for values, begin, end in [(known, *span) for known in samples for span in _spans(scene, known, one, other)]:
        for size in SIZES:          # some laws end
            state = {node.name: draw.uniform(-size, size) for node in symbols}
            found = [evaluate(list(terms), Floats, {**values, **state, scene.time.name: t})
                     for t in [draw.uniform(begin, end)] for terms in (one, other)]
            if not isnan(sum(map(sum, found))):
                break
        if not abs(sum(found[0]) - sum(found[1])) <= LEFT * sum(abs(x) for terms in found for x in terms):
            return False
    return True


def _spans(scene: "Scene", values: Mapping[str, float], *sides: "Sequence[Node]") -> list[tuple[float, float]]:
    """[(begin, end)] of the time between instants at which something begins or ends, so that all of it is seen."""
    calls = [part for part in reachable([node for side in sides for node in side]) if part.op == "call"
             and part.name in PULSES and _moves_with(part.args[0]) == {scene.time.name}]
    instants = {0.0}
    for call in calls:
        at_once, later = (evaluate([call.args[0]], Floats, {**values, scene.time.name: t})[0] for t in (0.0, 1.0))
        if later != at_once:
            instants.add(at_once / (at_once - later))
    known = sorted(t for t in instants if t >= 0)
    found = list(pairwise([*known, known[-1] + LONG]))
    return found * -(-STATES // len(found))


def _moves_with(node: "Node") -> set[str]:
    """The names of the variables in an expression."""
    return {part.name for part in reachable([node]) if part.op == "symbol" and part.mask}


def same_in_motion(problem: "Problem", one: "Sequence[Node]", other: "Sequence[Node]") -> bool:
    """The same of terms without letters of their own."""
    return agree_in_motion(problem.scene, samples_of(problem, {}), one, other)
