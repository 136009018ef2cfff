"""Expressions of scenes in letters in their shortest form, where angles are parts of a turn whatever the letters are:
sin ωt at t = π/ω, of an ω that stands for other letters."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import islice
from math import pi
from typing import TYPE_CHECKING, Any

from vibcli.report.steps.instances import INSTANCES, instances
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.steps.step import WorkedSolution
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ALIKE = 1e-9        # relative: of an angle
PARTS = 12          # of half a turn


def shortest(problem: "Problem", sheet: "WorkedSolution", node: "Node") -> "Node":
    """It with sines and cosines of parts of a turn, and what lines have for ω, put in; itself of a scene in numbers."""
    if not problem.numeric.has_free_symbols:
        return node
    known = [values for _, values in islice(instances(problem, sheet), INSTANCES)]
    of = {line.letter: line.node for line in sheet.steps if line.settles == "omega[1]" and line.letter}
    parameters, table = problem.scene.parameters, node.table
    put_in = {table.parameter(name): found for name, found in of.items()}
    put_in |= {parameters.nodes[name]: found for name, found in parameters.in_letters.items()}
    turned = textbook(substitute([node], _parts_of_a_turn(node, known))[0])
    return min(node, turned, textbook(substitute([turned], put_in)[0]), key=letters)


def _parts_of_a_turn(node: "Node", known: Sequence[Mapping[str, float]]) -> dict[Any, Any]:
    """{sine or cosine: its value} where the angle is π by a small fraction at all values of the letters."""
    found = {}
    for call in reachable([node]):
        if call.op == "call" and call.name in ("sin", "cos"):
            halves = [evaluate(list(call.args), Floats, values)[0] / pi for values in known]
            fraction = Fraction(halves[0]).limit_denominator(PARTS) if halves else None
            if halves and all(abs(half - fraction) <= ALIKE * max(1.0, abs(half)) for half in halves):
                table = node.table
                found[call] = table.call(call.name, table.pi * table.number(fraction))
    return found
