"""What supports exert along a motion, in letters: R_ρ = E_ρ + Σ λ_k ∂G_k/∂ρ with the λ_k of E_q + Σ λ_k ∂G_k/∂q = 0.

The multipliers, and coordinates that others give, are eliminated; where that makes an expression longer than one reads,
or loops are closed in numbers, multipliers stay in it as symbols lambda_NAME.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING, Released
from vibcli.mechanics.lagrange import equation_of
from vibcli.mechanics.static_preload import pivots, solve_linear
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.node import Node

READABLE = 60           # letters of a reaction; beyond, the shorter of both forms is told
FIRST = 6               # equations, the shortest, of which each is once the first to give multipliers


def along_the_motion(numeric: "NumericSystem", ties: bool = False) -> "dict[str, Node]":
    """{signal: expression} of the supports in coordinates, velocities and accelerations; B.normal of bodies that slide
    or roll on a surface, or slide along a direction. ties: of ropes and other constraints too, where all multipliers
    are eliminated."""
    released = Released(numeric)
    scene, table = released.scene, released.scene.table
    still = {node: table.zero for symbol in released.held
             for node in (symbol, table.variable(symbol.name + "'"), table.variable(symbol.name + "''"))}
    symbols = [table.variable("lambda_" + constraint.name.replace(".", "_")) for constraint in scene.constraints]
    slopes = [[_steady_slope(released, row[q]) if q in row else table.zero for q in scene.q]
              for row in (gradient(constraint.node) for constraint in scene.constraints)]
    slopes = [substitute(row, still) for row in slopes]
    parts = scene.unrooted(substitute([equation_of(scene, i) for i in range(len(scene.q))], still))
    tied = [[row[i] * symbol for row, symbol in zip(slopes, symbols, strict=True)] for i in range(len(scene.q))]
    equations = {q: textbook(table.total([part, *forces]))
                 for q, part, forces in zip(scene.q, parts, tied, strict=True)}
    free = [table.zero, *(equations[q] for q in released.real)]      # what a free coordinate does costs no reaction
    found = {symbol.name: equations[symbol] for symbol in released.held
             if not any(is_zero(equations[symbol] - sign * node) for node in free for sign in (1, -1))}
    found |= dict(_normals(released, found, still))
    ways = _eliminated(released, symbols, slopes, parts)
    if not ways:
        return found
    known = {tie.signal: symbol if tie.form in LENGTHENING else -symbol
             for tie, symbol in zip(scene.constraints, symbols, strict=True)
             if ties and all(symbol in way for way in ways)}
    return {signal: _shorter(node, ways) for signal, node in found.items()} | {
        signal: min((textbook(substitute([node], way)[0]) for way in ways), key=letters)
        for signal, node in known.items()}


def _normals(released: Released, found: "Mapping[str, Node]",
             still: "dict[Node, Node]") -> "Iterator[tuple[str, Node]]":
    """(B.normal, n·R) of each body with a surface or a guide that takes part along both axes."""
    for name, body in released.scene.bodies.items():
        sides = [found.get(f"{name}.reaction.{axis}") for axis in "xy"]
        if body.normal is not None and None not in sides:
            nx, ny = substitute(list(body.normal), still)
            yield f"{name}.normal", textbook(nx * sides[0] + ny * sides[1])


def _eliminated(released: Released, symbols: "Sequence[Node]", slopes: "list[list[Node]]",
                parts: "Sequence[Node]") -> "list[dict[Node, Node]]":
    """[{λ, dependent coordinate or rate: what it is}], one for each choice of equations for the λ; none where loops are
    closed in numbers or supports share loads."""
    scene, table, plain = released.scene, released.scene.table, released.numeric.scene
    if plain.loops is not None:
        return []
    known = {}
    for name in plain.dependent:
        nodes = copied([plain.symbol(name, order) for order in range(3)], table)
        known |= dict(zip((scene.symbol(name, order) for order in range(3)), nodes, strict=True))
    if not symbols:
        return [known]
    order, ways = sorted(range(len(released.real)), key=lambda i: letters(parts[i])), {}
    for first in order[:FIRST]:
        rows, picked = _regular_rows(released, slopes, sorted(order, key=lambda i: i != first))
        if len(picked) == len(symbols) and frozenset(rows) not in ways:
            solution = solve_linear([[slopes[k][i] for k in picked] + [-parts[i]] for i in rows], table.zero)
            ways[frozenset(rows)] = known | {
                symbols[k]: substitute([node], known)[0] for k, node in zip(picked, solution, strict=True)}
    return list(ways.values())


def _regular_rows(released: Released, slopes: "Sequence[list[Node]]",
                  order: Sequence[int]) -> tuple[list[int], list[int]]:
    """(equations, multipliers) of a largest regular system of the E_q + Σ λ_k ∂G_k/∂q = 0, the first of an order."""
    scene, n = released.scene, len(released.real)
    at = {**scene.sample, **dict.fromkeys((q.name for q in released.held), 0.0), **_beside(released, 1),
          scene.time.name: 0.0}
    sizes = [evaluate(row[:n], Floats, at) for row in slopes]
    rows, picked = [], []
    for i in order:
        found, columns = pivots([[size[k] for size in sizes] for k in (*rows, i)])
        if len(found) > len(rows):
            rows, picked = [(*rows, i)[k] for k in found], columns
    return rows, picked


def _shorter(node: "Node", ways: "Sequence[dict[Node, Node]]") -> "Node":
    """The node with what is known put in the way that is shortest, unless that is too long to read and longer."""
    short = min((textbook(substitute([node], known)[0]) for known in ways), key=letters)
    return short if letters(short) <= max(READABLE, letters(node)) else node


def _steady_slope(released: Released, node: "Node") -> "Node":
    """A slope that is 0 or ±1 in all positions as that number: a rope that keeps its direction."""
    scene = released.scene
    values = []
    for attempt in range(3):
        values += evaluate([node], Floats, {**scene.sample, **dict.fromkeys((q.name for q in released.held), 0.0),
                                            **_beside(released, attempt + 1), scene.time.name: 0.0})
    whole = round(values[0]) if values[0] == values[0] else 2
    return scene.table.number(whole) if abs(whole) <= 1 and all(abs(v - whole) <= 1e-12 for v in values) else node


def _beside(released: Released, steps: int) -> dict[str, float]:
    """{coordinate: a number some hundredths of the figure beside the drawn one}."""
    scene = released.scene
    return {q.name: scene.number(q) + 0.01 * steps * (-1) ** i * scene.unit_of(q.name)
            for i, q in enumerate(released.real)}
