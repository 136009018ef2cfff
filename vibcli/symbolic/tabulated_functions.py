"""A law from points, with its energy and its derivatives: functions of one argument that are polynomials between the
points (monotone_cubics.py). Beyond the ends they are straight lines, or have no value."""

from bisect import bisect_right
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.defined_functions import DefinedFunction, Ending
from vibcli.symbolic.monotone_cubics import cubics, energies

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

SPARE = 64          # bits that sums of energies have more than their numbers
DEGREE = 3


class PiecewiseCubic:
    """F through points, u ascending with u = 0 within; `name`: that of what it is the law of."""

    def __init__(self, name: str, u: "Sequence[Fraction]", F: "Sequence[Fraction]", linear: bool) -> None:
        self.name, self.linear, self.points = name, linear, tuple(u)
        self.pieces = cubics(u, F, linear)
        self.edges = [piece.low for piece in self.pieces[1:]]
        self.first_pieces = [0, *(bisect_right(self.edges, place) for place in self.kinks)]
        inside = 0 in self.edges and 0 not in self.kinks
        self.cut = self.edges.index(Fraction(0)) if inside else None   # the piece that the next one goes on at u = 0
        self.rises = all(a < b for a, b in pairwise(F)) and all(
            piece.coefficients[1] > 0 for piece in self.pieces if None in (piece.low, piece.high))
        self._heights: dict[int, list[Fraction]] = {}
        self._known: dict[Any, Any] = {}

    @property
    def kinks(self) -> "tuple[Fraction, ...]":
        """The points at which it changes from one cubic to another."""
        return self.points if self.linear else self.points[1:-1]

    def called(self, order: int, u: "Node") -> "Node":
        """The derivative of F of an order at u; of the order −1 V = ∫₀ᵘ F du."""
        if order > DEGREE:
            return u.table.zero
        function = LawFromTable(self, order)
        u.table.functions.setdefault(function.name, function)
        return u.table.call(function.name, u)

    def exactly(self, order: int, k: int, precision: int) -> "list[Fraction]":
        """The coefficients of the derivative of an order on a piece, by powers of u − anchor."""
        c = list(self.pieces[k].coefficients)
        if order < 0:
            if precision not in self._heights:
                self._heights[precision] = energies(self.pieces, precision + SPARE)
            return [self._heights[precision][k], *(x / (i + 1) for i, x in enumerate(c))]
        for _ in range(order):
            c = [i * x for i, x in enumerate(c)][1:]
        return c

    def in_numbers(self, order: int, arithmetic: Any,
                   precision: int) -> tuple[tuple[Any, Any], list[Any], list[tuple[Any, list[Any]]]]:
        """((first point, last point), edges, (anchor, coefficients) of each piece) in numbers of an arithmetic."""
        key = order, arithmetic.pi.__class__, precision
        if key not in self._known:
            number = arithmetic.number
            rows = [(number(piece.anchor), [number(c) for c in self.exactly(order, k, precision)])
                    for k, piece in enumerate(self.pieces)]
            ends = number(self.points[0]), number(self.points[-1])
            self._known[key] = ends, [number(edge) for edge in self.edges], rows
        found: tuple[tuple[Any, Any], list[Any], list[tuple[Any, list[Any]]]] = self._known[key]
        return found

    def arrays(self, order: int) -> "tuple[np.ndarray, ...]":
        """(edges, anchors, coefficients, lowest power first) in floats."""
        import numpy as np

        if ("arrays", order) not in self._known:
            from vibcli.symbolic.evaluation import Floats

            _, edges, rows = self.in_numbers(order, Floats, 53)
            self._known["arrays", order] = (np.array(edges, dtype=float), np.array([a for a, _ in rows]),
                                            np.array([c for _, c in rows]).T)
        found: tuple[np.ndarray, ...] = self._known["arrays", order]
        return found


class LawFromTable(DefinedFunction):
    """F^(order)(u) of a PiecewiseCubic, V of the order −1."""

    def __init__(self, law: PiecewiseCubic, order: int) -> None:
        self.law, self.order = law, order
        self.name, self.ends = f"{law.name}.table.{order + 1}", not law.linear
        self.about = f"the law of '{law.name}' changes from point to point of its table"

    @property
    def symbol(self) -> str:
        return ("V", "F", "K", "K1", "K2")[self.order + 1] + "_" + self.law.name.replace(".", "")

    def at(self, *args: "float | mpmath.mpf") -> "float | mpmath.mpf":
        from vibcli.symbolic.evaluation import Floats, multiprecision

        u, = args
        arithmetic, precision = Floats, 53
        if hasattr(u, "_mpf_"):
            import mpmath

            arithmetic, precision = multiprecision(), mpmath.mp.prec
        (low, high), edges, rows = self.law.in_numbers(self.order, arithmetic, precision)
        if not self.law.linear and not low <= u <= high:
            return u * 0 + float("nan")
        anchor, coefficients = rows[bisect_right(edges, u)]
        return _horner(coefficients, u - anchor)

    def on_arrays(self, *args: "float | np.ndarray") -> "np.ndarray":
        import numpy as np

        u = np.asarray(args[0], dtype=float)
        return self._within(u, np.searchsorted(self.law.arrays(self.order)[0], u, side="right"))

    def on_senses(self, args: "Sequence[Any]", senses: "Sequence[Any]") -> "np.ndarray":
        import numpy as np

        law, u = self.law, np.asarray(args[0], dtype=float)
        passed = sum((0.5 * (1 + np.asarray(sense)) for sense in senses), 0.0)
        k = np.array(law.first_pieces)[np.asarray(passed, dtype=int)]
        cut = law.cut
        return self._within(u, k if cut is None else np.where((k == cut) & (u >= 0), k + 1, k))

    def _within(self, u: "np.ndarray", k: "int | np.ndarray") -> "np.ndarray":
        """The values of the polynomials of given numbers, none beyond the ends of a table that has such."""
        import numpy as np

        _, anchors, coefficients = self.law.arrays(self.order)
        found: np.ndarray = _horner(coefficients[:, k], u - anchors[k])
        if self.law.linear:
            return found
        low, high = float(self.law.points[0]), float(self.law.points[-1])
        return np.where((u >= low) & (u <= high), found, np.nan)

    def coefficients(self, ring: Any, args: "Sequence[Any]") -> list[Any]:
        from vibcli.symbolic.running_errors import error_in, number_in
        from vibcli.symbolic.truncated_polynomials import NoDerivative

        u = args[0].coefficient if hasattr(args[0], "op") else args[0]
        known = not hasattr(args[0], "op") or args[0].op == "number"
        if ring.order > 1 - self.order and (not known or any(
                abs(number_in(u) - float(place)) <= error_in(u) for place in self.law.kinks)):
            raise NoDerivative(self.symbol)
        return super().coefficients(ring, args)

    def slope(self, node: "Node", i: int) -> "Node":
        return self.law.called(self.order + 1, node.args[i])

    def folded(self, table: "Table", args: "Sequence[Node]") -> "Node | None":
        if not args[0].is_zero or (self.order > 1 and 0 in self.law.kinks):
            return None
        k = bisect_right(self.law.edges, 0)
        return table.number(self.law.exactly(self.order, k, 53)[0])

    def positive_where(self, node: "Node", x: "Node") -> "list[Node] | None":
        return [] if self.order == 1 and self.law.linear and self.law.rises else None

    def ending(self, _args: "Sequence[float]") -> Ending | None:
        return Ending(f"the table of '{self.law.name.partition('.')[0]}' ends",
                      "give that table more points, or let it go on with beyond: linear") if self.ends else None

    def kinks(self, node: "Node") -> "list[Node]":
        return [node.args[0] - place for place in self.law.kinks]


def _horner(coefficients: Any, t: Any) -> Any:
    total = coefficients[-1] + 0 * t
    for c in coefficients[-2::-1]:
        total = total * t + c
    return total
