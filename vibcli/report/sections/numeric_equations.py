"""Equations of small oscillations with numbers for their coefficients."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.factored_system import summed
from vibcli.report.measured import without_units
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import ALL_PURE
from vibcli.symbolic.normal_form import TooLong, expanded
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.mechanics.lagrange import EquationsOfMotion
    from vibcli.notation.plain import Notation
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ROUNDING = 1e-13        # of the terms that add up to a coefficient, which is zero then


def linear_rows(problem: "Problem", equations: "EquationsOfMotion") -> "Iterator[tuple[str | None, str | None]]":
    """The equation of small oscillations of each coordinate: (text, LaTeX), in letters or with numbers."""
    from vibcli.notation.latex import in_one_line
    from vibcli.notation.scene_language import language

    count = len(problem.scene.coordinates)
    if equations.in_letters:
        for i in range(count):
            left, right = equations.linear[i], equations.drive.get(i, problem.scene.table.zero)
            yield f"{language(left)} = {language(right)}", f"{in_one_line(left)} = {in_one_line(right)}"
    elif problem.numeric.has_free_symbols:
        yield from [(None, None)] * count
    else:
        rows = numeric_rows(problem, (equations.M, equations.C, equations.G, equations.K))
        for i, row in enumerate(rows):
            drive = numeric_drive(problem, equations, i)
            text, tex = (f"{joined(row, times, write)} = {joined(drive, times, write)}"
                         for times, write in (("*", language), (r" \, ", in_one_line)))
            yield text, tex


def numeric_rows(problem: "Problem", matrices: Any) -> "list[list[tuple[float, Node]]]":
    """[(coefficient, symbol node)] of each linear equation in numbers, of the matrices M, C, G, K {(i, j): number}."""
    scene, (M, C, G, K) = problem.scene, matrices
    rows: list[list[tuple[float, Node]]] = [[] for _ in scene.coordinates]
    for parts, symbols in ((M, scene.a), (summed(C, G), scene.v), (K, scene.q)):
        for i, j in sorted(parts):
            if parts[i, j] and i < len(rows) and j < len(symbols):
                rows[i].append((float(parts[i, j]), symbols[j]))
    return rows


def numeric_drive(problem: "Problem", equations: "EquationsOfMotion", i: int) -> "list[tuple[float, Node]]":
    """[(coefficient, function of the time)] of what drives coordinate i; the time function is 1 where it is a load
    without letters."""
    node = equations.drive.get(i)
    if node is None:
        return []
    if problem.scene.table.hidden is ALL_PURE:
        node = without_units(node)
    row, sizes, table, time = {}, {}, problem.scene.table, problem.scene.time.mask
    for monomial, value in _multiplied_out(problem, node).items():
        moving = table.product(*(pair for pair in monomial if pair[0].mask & time))
        fixed = table.product((table.number(value), ONE), *(pair for pair in monomial if not pair[0].mask & time))
        part = evaluate([fixed], Floats, problem.configuration.at_rest)[0]
        row[moving], sizes[moving] = row.get(moving, 0.0) + part, sizes.get(moving, 0.0) + abs(part)
    return [(value, moving) for moving, value in row.items() if abs(value) > ROUNDING * sizes[moving]]


def _multiplied_out(problem: "Problem", node: "Node") -> Any:
    """{monomial: coefficient} of a function of the time; where its letters make it too long, with their numbers."""
    try:
        return expanded(node)
    except TooLong:
        time, table = problem.scene.time.mask, problem.scene.table
        fixed = [part for part in _beside(node, time) if part.op != "number"]
        numbers = evaluate(fixed, Floats, problem.configuration.at_rest)
        known = {part: table.number(Fraction(x)) for part, x in zip(fixed, numbers, strict=True)}
        return expanded(substitute([node], known)[0])


def _beside(node: "Node", time: Any) -> "Iterator[Node]":
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
