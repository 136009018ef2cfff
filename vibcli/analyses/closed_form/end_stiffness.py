"""Dynamic stiffness of a uniform member at the end at which others are tied to it, its other end as it is held:

    one motion     F + Z H = 0,  k = F/H                         F with that end free, H with it held
    two motions    F₀₀ + Z₁ F₁₀ + Z₂ F₀₁ + Z₁₂ F_c + (Z₁ Z₂ − Z₁₂²) H = 0
                   k = F₀₁/H of the displacement, F₁₀/H of the turn, −F_c/2H of both

linear parts of its frequency function with impedances there, functions of θ = βl and under an axial force of η = αl.
"""

from collections.abc import Callable, Collection, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.frequency_functions import UniformPiece, frequency_function
from vibcli.analyses.closed_form.textbook_equation import content, is_small, quotient
from vibcli.analyses.closed_form.two_wave_numbers import ratio
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.frequency_functions import Function
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.symbolic.node import Node

HYPERBOLIC = "sinh", "cosh"
UNKNOWN = "Z at the joint", "Z of its turn", "Z of both"


class WaveArguments(NamedTuple):
    """θ of a member, the argument of sin and cos, and η, that of sinh and cosh where an axial force acts."""

    wave_number: "Node"
    second: "Node | None" = None

    def called(self, functions: tuple[tuple[int, *tuple[str, ...]], ...]) -> "Node":
        """The product of functions, ((0, names), …)."""
        x = self.wave_number
        return x.table.product(*((x.table.call(name, (name in HYPERBOLIC and self.second) or x), 1)
                                 for _, *names in functions for name in names))

    def square(self, piece: Any) -> "Node":
        """ω² by θ and η."""
        force = piece.tension if piece.bending.is_zero else piece.bending
        x, other = self.wave_number, self.second
        if other is not None:
            force = force * (x * other) ** 2 / piece.length ** 4
        else:
            order = 2 if piece.bending.is_zero else 4
            force = force * (x / piece.length) ** order
        found: Node = (force + piece.foundation) / piece.inertia
        return found


def is_pulled(piece: Any) -> bool:
    """Does an axial force act on a beam?"""
    return not (piece.bending.is_zero or piece.tension.is_zero)


def wave_power(piece: Any, omega: "Node") -> "tuple[int, Node]":
    """(power, θ to that power) by ω: θ⁴ of beams, else θ²."""
    load = piece.inertia * omega ** 2 - piece.foundation
    if is_pulled(piece):
        table, pull = omega.table, piece.tension
        return 2, piece.length ** 2 / (2 * piece.bending) * (
            table.sqrt(textbook(pull ** 2 + 4 * piece.bending * load)) - pull)
    order = 2 if piece.bending.is_zero else 4
    stiffness = piece.tension if order == 2 else piece.bending
    return order, textbook(piece.length ** order / stiffness) * (load if load.op == "sum" else textbook(load))


def end_stiffness(placed: "PlacedPiece", waves: WaveArguments, joints: Collection[int],
                  impedance: "Callable[[int, Node], Node]") -> "dict[tuple[int, int], tuple[Node, Node]]":
    """{(motion, motion): (above, below)} of the motions that are joints, 0 the displacement, of beams 1 the turn;
    `impedance`(coordinate, how much the end moves by it): what acts on another, a letter where that stands apart."""
    piece, table = placed.piece, waves.wave_number.table
    half = len(placed.rows) // 2
    unit, stiffness = piece.length, piece.tension if half == 1 else piece.bending
    if waves.second is None:
        unit = piece.length / waves.wave_number
    scales = [stiffness / unit ** (3 if half > 1 else 1), stiffness / unit, stiffness / unit ** 2]
    unknown, ends, met = [table.parameter(name) for name in UNKNOWN], [], []
    for rows in (placed.rows[:half], placed.rows[half:]):
        own = [motion for motion, row in enumerate(rows) if row and next(iter(row)) in joints]
        met += own
        end = [None if not row else unknown[motion] if motion in own else textbook(
            impedance(*next(iter(row.items()))) / scales[motion]) for motion, row in enumerate(rows)]
        ends.append((*end, unknown[2]) if len(own) == 2 else tuple(end))
    one, theta = table.one, waves.wave_number
    beam = UniformPiece(one, theta, one) if waves.second is None else UniformPiece(theta, theta, one, waves.second)
    function = frequency_function(table, 2 * half, [beam], ends)
    if len(met) == 1:
        motion, = met
        free, = _at(function, unknown, (0, 0, 0))
        held = _parted(function, unknown[motion])
        return {(motion, motion): _quotient(waves, free, held, scales[motion])}
    free, one_held, other_held, both, less, more = _at(function, unknown, (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0),
                                                       (0, 0, -HALF), (0, 0, HALF))
    held = _sum((both, 1), (one_held, -1), (other_held, -1), (free, 1))
    return {(0, 0): _quotient(waves, _sum((other_held, 1), (free, -1)), held, scales[0]),
            (1, 1): _quotient(waves, _sum((one_held, 1), (free, -1)), held, scales[1]),
            (0, 1): _quotient(waves, _sum((less, HALF), (more, -HALF)), held, scales[2])}


def _at(function: "Function", unknown: "Sequence[Node]",
        *values: "tuple[int, int, Fraction | int]") -> "list[Function]":
    """The functions with values for what is unknown."""
    number = unknown[0].table.number
    return [{names: substitute([node], dict(zip(unknown, map(number, one), strict=True)))[0]
             for names, node in function.items()} for one in values]


def _parted(function: "Function", unknown: "Node") -> "Function":
    """What stands before the unknown."""
    table = unknown.table
    return {names: textbook((node - substitute([node], {unknown: table.zero})[0]) / unknown)
            for names, node in function.items()}


def _sum(*parts: "tuple[Function, Fraction | int]") -> "Function":
    """Σ factor·function."""
    names = dict.fromkeys(name for function, _ in parts for name in function)
    found = {}
    for one in names:
        nodes = [function[one] * factor for function, factor in parts if one in function]
        found[one] = textbook(nodes[0].table.total(nodes))
    return {one: node for one, node in found.items() if not node.is_zero}


def _quotient(waves: WaveArguments, above: "Function",
              below: "Function", scale: "Node") -> "tuple[Node, Node]":
    """(above, below) of scale·above/below."""
    table = waves.wave_number.table
    above, below = ({names: node for names, node in one.items() if not node.is_zero} for one in (above, below))
    if not above:
        return table.zero, table.one
    if waves.second is not None:
        over, under = ratio(waves, above, below)
        return quotient(textbook(scale) * over / under)
    first = next((size for size in below.values() if all(part.op != "sum" for part in reachable([size]))), table.one)
    raw = [table.total([textbook(size / first) * waves.called(names) for names, size in one.items()])
           for one in (above, below)]
    cleared = [single(total) for total in raw]
    if not _in_letters(cleared):
        return textbook(scale) * raw[0], raw[1]
    (over, one), (under, other) = map(content, cleared)
    return quotient(textbook(scale * (one / other)) * over / under)


def _in_letters(nodes: "list[Node]") -> bool:
    """Have sums no numbers but small ones?"""
    return all(is_small(Fraction(c)) for part in reachable(nodes) for c in (
        part.coefficient, *(c for _, c in (part.args if part.op == "sum" else ()))))
