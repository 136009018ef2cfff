"""Equations of small oscillations with numbers for their coefficients."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import TooLong, expanded
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.mechanics.lagrange import EquationsOfMotion
    from vibcli.notation.plain import Notation
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ROUNDING = 1e-13        # of the terms that add up to a coefficient, which is zero then


def linear_row(problem: "Problem", equations: "EquationsOfMotion", i: int):
    """The equation of small oscillations of coordinate i: (text, LaTeX), in letters or with numbers."""
    from vibcli.notation.latex import latex
    from vibcli.notation.scene_language import language

    if equations.in_letters:
        right = equations.drive.get(i, problem.scene.table.zero)
        return tuple(f"{write(equations.linear[i])} = {write(right)}" for write in (language, latex))
    if problem.numeric.has_free_symbols:
        return None, None
    matrices = equations.M, equations.C, equations.G, equations.K
    row, drive = numeric_row(problem, matrices, i), numeric_drive(problem, equations, i)
    return tuple(f"{joined(row, times, write)} = {joined(drive, times, write)}"
                 for times, write in (("*", language), (r" \, ", latex)))


def numeric_row(problem: "Problem", matrices: Any, i: int) -> "list[tuple[float, Node]]":
    """[(coefficient, symbol node)] of a linear equation in numbers, of the matrices M, C, G, K."""
    scene, (M, C, G, K) = problem.scene, matrices
    row = []
    kinds = ((M,), scene.a), ((C, G), scene.v), ((K,), scene.q)
    for parts, symbols in kinds:
        for j, symbol in enumerate(symbols):
            value = float(sum(matrix.get((i, j), 0.0) for matrix in parts))
            if value:
                row.append((value, symbol))
    return row


def numeric_drive(problem: "Problem", equations: "EquationsOfMotion", i: int) -> "list[tuple[float, Node]]":
    """[(coefficient, function of the time)] of what drives coordinate i; the time function is 1 where it is a load
    without letters."""
    node = equations.drive.get(i)
    if node is None:
        return []
    row, sizes, table, time = {}, {}, problem.scene.table, problem.scene.time.mask
    for monomial, value in _multiplied_out(problem, node).items():
        moving = table.product(*(pair for pair in monomial if pair[0].mask & time))
        fixed = table.product((table.number(value), ONE), *(pair for pair in monomial if not pair[0].mask & time))
        part = evaluate([fixed], Floats, problem.configuration.at_rest)[0]
        row[moving], sizes[moving] = row.get(moving, 0.0) + part, sizes.get(moving, 0.0) + abs(part)
    return [(value, moving) for moving, value in row.items() if abs(value) > ROUNDING * sizes[moving]]


def _multiplied_out(problem, node):
    """{monomial: coefficient} of a function of the time; where its letters make it too long, with their numbers."""
    try:
        return expanded(node)
    except TooLong:
        time, table = problem.scene.time.mask, problem.scene.table
        fixed = [part for part in _beside(node, time) if part.op != "number"]
        numbers = evaluate(fixed, Floats, problem.configuration.at_rest)
        known = {part: table.number(Fraction(x)) for part, x in zip(fixed, numbers, strict=True)}
        return expanded(substitute([node], known)[0])


def _beside(node, time):
    """The largest parts of sums and products in a node that do not depend on the time."""
    if not node.mask & time:
        yield node
    elif node.op in ("sum", "product"):
        for part, _ in node.args:
            yield from _beside(part, time)


def joined(row: "Sequence[tuple[float, Node]]", times: str, write: "Notation", minus: str = "-") -> str:
    """Σ coefficient·symbol as text."""
    parts = []
    for value, symbol in row:
        sign = (minus if value < 0 else "") if not parts else (f" {minus} " if value < 0 else " + ")
        size = write.numeral(f"{abs(value):.6g}")
        factor = "" if abs(value) == 1 else f"{size}{times}"
        parts.append(sign + (size if symbol.op == "number" else factor + write(symbol)))
    return "".join(parts) or "0"
