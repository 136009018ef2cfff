"""What is asked of a free vibration by the constants of its lines, x = e^{−δt} (A cos ω_dt + B sin ω_dt):

    amplitude √(A² + B²),   phase atan2(B, A),   period 2π/ω_d,   decrement 2πδ/ω_d;

its envelope falls to 1/n in the time ln n/δ, in ln n over the decrement cycles.
"""

from typing import TYPE_CHECKING

from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Words
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

FALLS = "time_to", "cycles_to"
CLOSE = 1e-9        # relative: of a line and the engine's number


def tell_of_free(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked a number of a free vibration of the only coordinate, and is it written down by its lines?"""
    tree, known = asked.tree, {line.letter: line for line in sheet.steps if line.letter and line.value is not None}
    if not (tree.args and isinstance(tree.args[0], NameRef) and not tree.args[0].primes
            and {"A", "B"} <= {line.settles for line in known.values()}):
        return False
    value, floats = float(value_of(problem, asked)[0]), {letter: line.value for letter, line in known.items()}
    for node in _forms(problem, known, tree):
        found, = evaluate([node], Floats, {**problem.numeric.floats, **floats})
        if abs(found - value) <= CLOSE * abs(value):
            unit = unit_told(problem.spec, asked)
            sheet.write(Words(as_printed(asked.text, problem.spec.coordinates) + ":  "), node, *number(value, unit),
                        *as_counted(problem, tree), settles=asked.text, node=node, value=value, unit=unit,
                        uses=[line.number for line in known.values()])
            return True
    return False


def _forms(problem, known, tree):
    """What the quantity may be, by the letters of the lines."""
    table = problem.scene.table
    letter = {line.settles: table.parameter(name, positive=False) for name, line in known.items()}
    found = {"amplitude": [table.sqrt(letter["A"] ** 2 + letter["B"] ** 2)],
             "phase": [table.call("atan2", letter["B"], letter["A"])]}
    rate = letter.get("omega_d[1]" if "delta" in letter else "omega[1]")
    if rate is not None:
        found["period"] = [2 * table.pi / rate]
    if rate is None or "delta" not in letter:
        return found.get(tree.head, [])
    decrement = 2 * table.pi * letter["delta"] / rate
    found["decrement"] = [decrement]
    if tree.head in FALLS:
        known_as = problem.scene.parameters.nodes
        falls = table.call("log", 1 / lower(parse(tree.indices[0]), table, lambda name, *_: known_as[name]))
        found |= {"time_to": [falls / letter["delta"]], "cycles_to": [falls / decrement]}
    return found.get(tree.head, [])
