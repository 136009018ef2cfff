"""Values of parameters at which two equilibria meet, and how the scene rests there."""

from typing import TYPE_CHECKING

from vibcli.evidence.reference.folds import FoldEquations, true_fold
from vibcli.evidence.reference.static_positions import equations
from vibcli.evidence.subject import FOLD, Subject, of_number
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities import equilibrium
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import about_which
from vibcli.results.motion_signals import node_of

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

BACK = 0.1      # of the way to the given equilibrium: where other methods begin


def fold(problem: "Problem", tree: "QuantityRef") -> Subject:
    """fold[1, P], fold[1, P](x)"""
    value = measure(problem, tree)[0]           # refused where there is none
    asked, which = about_which(tree)
    one = problem if which is None else equilibrium.about(problem, int(which))
    number, name = int(asked.indices[0]), asked.indices[1]
    near, static = one.limit_loads(name).limit_point(number), equations(one.configuration)
    node = node_of(one, asked.args[0]) if asked.args else None
    known = FoldEquations(one.numeric, static, name, {**near.values, **near.position, name: near.value})
    true, n = true_fold(known, node, abs(value)), known.n
    begin = [*static.near, one.numeric.floats[name]]
    start = [(1 - BACK) * x + BACK * other for x, other in zip(known.near, begin, strict=False)]
    return of_number(FOLD, one, tree, "where two equilibria meet", true, (known, [*start, *known.near[n + 1:]], node),
                     abs(float(true.values[0])) or 1.0, lambda: problem.about(Configuration(problem.numeric)))
