"""The steps to the stiffest and the softest direction of springs, or dampers, that end together: the entries of
Σ κ n nᵀ, and by Mohr's circle

    k = (k_xx + k_yy)/2 ± √(((k_xx − k_yy)/2)² + k_xy²),   tan 2α = 2 k_xy/(k_xx − k_yy).
"""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.equivalents import SECTIONS
from vibcli.quantities.expression import value_of
from vibcli.quantities.in_letters import quantity_in_letters
from vibcli.report.blocks import Words
from vibcli.report.steps.agreement import tidy
from vibcli.report.steps.characteristic import LONG
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

ENTRIES, LETTER = ("xx", "xy", "yy"), {"stiffness": "k", "damping": "c"}
UNIT = {"stiffness": "N/m", "damping": "N·s/m"}
CLOSE = 1e-9        # relative: of a line and the engine's number


def tell_direction(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked of several elements that end together written down by entries that have letters? Not where one
    of these is zero."""
    tree = asked.tree
    if tree.head not in SECTIONS:
        return False
    floats, value = problem.numeric.floats, float(value_of(problem, asked)[0])
    try:
        nodes = [tidy(quantity_in_letters(problem, tree._replace(component=name)), [floats]) for name in ENTRIES]
    except PhysicsError:
        return False
    entries = _Entries(problem, sheet, tree, nodes)
    if tree.component in ENTRIES:
        entries.line(ENTRIES.index(tree.component))
        return True
    form = _by_entries(entries.symbols, tree.component)
    found, = evaluate([form], Floats, dict(zip(entries.names, entries.values, strict=True)))
    if not all(entries.values) or abs(found - value) > CLOSE * abs(value):
        return False
    unit = unit_told(problem.spec, asked)
    sheet.write(Words(f"{as_printed(asked.text)}:  "), form, *number(value, unit), settles=asked.text, node=form,
                value=value, unit=unit, uses=[entries.line(i) for i in range(len(ENTRIES))])
    return True


class _Entries:
    """k_xx, k_xy, k_yy of a place, each written down once."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution, tree: "QuantityRef", nodes: "list[Node]") -> None:
        self.sheet, self.tree, self.nodes = sheet, tree, nodes
        rules = problem.spec.get("variants")
        of = {one.asked.tree.indices[0] for one in (*(rules.ask if rules is not None else ()), *problem.spec.answers)
              if getattr(one.asked.tree, "head", "") in SECTIONS}
        place = tree.indices[0] if len(of) > 1 else ""
        self.names = [sheet.letter(f"{LETTER[tree.head]}_{name}", place) for name in ENTRIES]
        self.symbols = [nodes[0].table.parameter(name, positive=False) for name in self.names]
        self.values = evaluate(nodes, Floats, problem.numeric.floats)

    def line(self, i: int) -> int:
        """The number of the line of an entry."""
        settles = f"{self.tree.head}[{self.tree.indices[0]}].{ENTRIES[i]}"
        told = next((line.number for line in self.sheet.steps if line.settles == settles), None)
        if told is not None:
            return told
        node, value, unit = self.nodes[i], self.values[i], UNIT[self.tree.head]
        shown = [" = ", node] if not is_number(node) and letters(node) <= LONG else []
        return self.sheet.write(Words(f"{as_printed(settles)}:  "), self.symbols[i], *shown, *number(value, unit),
                                settles=settles, node=node, value=value, unit=unit, letter=self.names[i])


def _by_entries(symbols: "list[Node]", component: str) -> "Node":
    """.max, .min or .angle."""
    xx, xy, yy = symbols
    if component == "angle":
        return xx.table.call("atan2", 2 * xy, xx - yy) / 2
    root = xx.table.sqrt(((xx - yy) / 2) ** 2 + xy ** 2)
    return (xx + yy) / 2 + (root if component == "max" else -root)
