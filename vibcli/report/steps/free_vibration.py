"""What is asked of a free vibration by the constants of its lines, x = e^{−δt} (A cos ω_dt + B sin ω_dt):

    decrement 2πδ/ω_d,   amplitude √(A² + B²),   phase atan2(B, A),   extremes ±√(A² + B²) where nothing damps.
"""

from contextlib import suppress
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Words
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

CLOSE = 1e-9        # relative: of a line and the engine's number


def tell_of_free(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked a number of a free vibration of the only coordinate, and is it written down by its lines?"""
    tree, known = asked.tree, {line.letter: line for line in sheet.steps if line.letter and line.value is not None}
    if not (tree.args and isinstance(tree.args[0], NameRef) and not tree.args[0].primes
            and {"A", "B"} <= {line.settles for line in known.values()}):
        return False
    value, floats = float(value_of(problem, asked)[0]), {letter: line.value for letter, line in known.items()}
    for node in _forms(problem, known, tree.head):
        found, = evaluate([node], Floats, {**problem.numeric.floats, **floats})
        if abs(found - value) <= CLOSE * abs(value):
            unit = unit_told(problem.spec, asked)
            sheet.write(Words(as_printed(asked.text, problem.spec.coordinates) + ":  "), node, *number(value, unit),
                        *as_counted(problem, tree), settles=asked.text, node=node, value=value, unit=unit,
                        uses=[line.number for line in known.values()])
            return True
    return False


def _forms(problem, known, head):
    """What the quantity of this name may be, by the letters of the lines."""
    table = problem.scene.table
    letter = {line.settles: table.parameter(name, positive=False) for name, line in known.items()}
    size = table.sqrt(letter["A"] ** 2 + letter["B"] ** 2)
    if head == "decrement" and {"delta", "omega_d[1]"} <= set(letter):
        return [2 * table.pi * letter["delta"] / letter["omega_d[1]"]]
    if head in ("max", "min") and "delta" not in letter:
        swings = size if head == "max" else -size
        with suppress(PhysicsError, SpecError):
            return [swings, problem.symbolic.equilibrium_position[problem.scene.coordinates[0]] + swings]
    return {"amplitude": [size], "phase": [table.call("atan2", letter["B"], letter["A"])]}.get(head, [])
