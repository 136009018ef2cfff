"""Parsed fields as expressions of a scene, what can be said of their values as drawn, directions and distances, whose
signs are those as drawn."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.base.diagnostics import distinct_figures
from vibcli.language.parameters import Parameters, unusable
from vibcli.language.reader import Expression, Record
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import (
    TooLong,
    collected,
    expanded,
    factors_of,
    is_zero,
    reduced,
    root_of_square,
    textbook,
)
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.semantics import literal_unit, lower_measured
from vibcli.symbolic.syntax import ExpressionError, Sum, parts_of

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.base.errors import Where
    from vibcli.scene.builder import Reports
    from vibcli.scene.coordinates import SceneCoordinates
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, SyntaxTree
    from vibcli.symbolic.variable_sets import VariableSet


class Expressions:
    """Lowers fields to nodes of a scene and compares nodes in its drawn position, the `coordinates` being its own."""

    __slots__ = ("coordinates", "parameters", "reports", "sample", "table")

    def __init__(self, coordinates: "SceneCoordinates", parameters: Parameters, sample: Mapping[str, float],
                 reports: "Reports") -> None:
        self.coordinates, self.parameters, self.sample, self.reports = coordinates, parameters, sample, reports
        self.table = coordinates.table

    def lower(self, expression: Expression, local: "tuple[str, Node] | None" = None) -> "Node":
        """The node of a parsed field; `local`: (name, node) of a name that is good there alone. Who reads more of a
        scene that is built has the values to judge it by."""
        def symbol(name: str, primes: int, tree: "NameRef") -> "Node":
            if local and name == local[0] and not primes:
                return local[1]
            known = self.parameters.in_letters if name in self.parameters.in_letters else self.parameters.nodes
            return known[name] if name in known else self.coordinates.symbol(name, primes)

        try:
            node = lower_measured(expression.tree, self.table, symbol)
        except ExpressionError as error:
            self.reports.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
            return self.table.one
        if isinstance(self.table.hidden, set):
            self.table.hidden.update(_hidden(expression.tree))
        if self.reports.finished or node.mask or node.op == "symbol":
            return node
        problem = unusable(evaluate([node], Floats, self.sample)[0], Floats)
        if problem:
            where = expression.scalar.place(0, len(expression.text))
            self.reports.report(where, "this value is " + problem[0], problem[1])
        return self.table.one if problem else node

    def positive(self, expression: Expression, what: str, zero: bool = False) -> "Node":
        """The node of a field whose value must be positive, or not negative."""
        node = self.lower(expression)
        value, = evaluate([node], Floats, self.sample)
        if not (value > 0 or (zero and value == 0)):
            found = f"{value:.6g} {units.text(expression.dimension or {})}".rstrip()
            wanted = "zero or more" if zero else "a positive value"
            self.reports.report(expression.where, f"{what} is {found}, expected {wanted}",
                        "mind the signs" if value < 0 else None)
        return node

    def load(self, expression: Expression, local: "tuple[str, Node] | None" = None) -> "tuple[Node, Node]":
        """(steady part, part in time) of a load: what holds the time are its summands as they are written, so that
        F0*(1 - cos(W*t)) is in time as a whole."""
        tree, parts = expression.tree, ([], [])
        for sign, part in tree.parts if isinstance(tree, Sum) else [(1, tree)]:
            parts["t" in {name for name, *_ in parts_of(part).names}].append((sign, part))
        if not all(parts):
            whole = self.lower(expression, local)
            return (self.table.zero, whole) if parts[1] else (whole, self.table.zero)
        steady, timed = (self.lower(Expression(expression.scalar, tree._replace(parts=tuple(part))), local)
                         for part in parts)
        return steady, timed

    def pair(self, expressions: Sequence[Expression]) -> "tuple[Node, Node]":
        """The nodes of two fields, such as a place [x, y]."""
        return self.lower(expressions[0]), self.lower(expressions[1])

    def number(self, node: "Node") -> float:
        """The value of a node as drawn, with sample values for symbols."""
        value: float = evaluate(self.coordinates.at_drawn(node), Floats, self.sample)[0]
        return value

    def sign(self, node: "Node") -> int:
        """That of a node as drawn."""
        return -1 if self.number(node) < 0 else 1

    def agree(self, a: "Node", b: "Node") -> bool:
        """Are two expressions the same, by algebra or at the sample?"""
        if a is b or is_zero(a - b):
            return True
        x, y = self.number(a), self.number(b)
        return abs(x - y) <= 1e-9 * max(abs(x), abs(y))

    def terms_with(self, node: "Node", mask: "VariableSet | int | None" = None) -> "Node":
        """The terms of an expression that depend on one of these symbols (None: all), multiplied out as far as it can
        be."""
        try:
            terms = reduced(expanded(node))
        except (TooLong, ZeroDivisionError):
            return node
        return collected(self.table, {monomial: value for monomial, value in terms.items()
                                      if mask is None or any(atom.mask & mask for atom, _ in monomial)})

    def vanishes(self, node: "Node") -> bool:
        """Is an expression zero in all positions: by algebra, or term by term at the sample?"""
        if is_zero(node):
            return True
        try:
            terms = reduced(expanded(node))
        except (TooLong, ZeroDivisionError):
            return False
        groups = {}
        for monomial, value in terms.items():
            moving = tuple(pair for pair in monomial if pair[0].mask)
            fixed = self.table.product(*(pair for pair in monomial if not pair[0].mask))
            groups.setdefault(moving, []).append(self.table.scaled(fixed, value))
        for parts in groups.values():
            sizes = evaluate(parts, Floats, self.sample)
            if not abs(sum(sizes)) <= 1e-12 * sum(map(abs, sizes)):
                return False
        return True

    def require_equal(self, a: "Node", b: "Node", where: "Where", message: str, hint: str | None = None,
                      size: float = 0.0) -> None:
        """Report `message` with both values where they differ in the drawn position by more than `size`."""
        if not self.agree(*self.coordinates.at_drawn(a, b)) and not abs(self.number(a) - self.number(b)) <= size:
            self.reports.report(where, message.format(*self.figures(a, b)), hint)

    def figures(self, a: "Node", b: "Node") -> tuple[str, str]:
        """Two values in the drawn position, with as many digits as tell them apart."""
        return distinct_figures(self.number(a), self.number(b))

    def unit(self, dx: "Node", dy: "Node", where: "Where | None" = None) -> "tuple[Node, Node]":
        """The unit vector along (dx, dy), constants."""
        length = self.distance(dx, dy)
        if self.number(length) == 0:
            self.reports.report(where, "this direction has no length",
                                "give one such as [0, 1], or two different places")
            return self.table.one, self.table.zero
        return dx / length, dy / length

    def absolute(self, node: "Node") -> "Node":
        """A node or its opposite, so that it is positive as drawn, whatever sign a letter has that may have any."""
        either = [name for name in self.parameters.free if not self.table.is_positive(self.parameters.nodes[name])]
        if either:
            drawn, = self.coordinates.at_drawn(node)
            if self._turns(drawn, either):
                size = self.table.sqrt(textbook(drawn * drawn))
                return size if drawn is node else textbook(node * drawn / size)
        return node if self.sign(node) > 0 else -node

    def _turns(self, drawn: "Node", letters: Sequence[str]) -> bool:
        """Has a value another sign where one of the letters has the other one?"""
        value, here = self.number(drawn), {part.name for part in reachable([drawn]) if part.op == "symbol"}
        return any(evaluate([drawn], Floats, {**self.sample, name: -self.sample[name]})[0] * value < 0
                   for name in here.intersection(letters))

    def distance(self, dx: "Node", dy: "Node") -> "Node":
        """√(dx² + dy²), rational where the direction never changes: there it is ±dx, ±dy or their projection."""
        dx0, dy0 = self.coordinates.at_drawn(dx, dy)
        for along, across in ((dx, dy), (dy, dx)):
            if is_zero(across):
                return self.absolute(along)
        if not dx.mask and not dy.mask:
            return self.table.sqrt(textbook(dx * dx + dy * dy))
        if is_zero(dx * dy0 - dy * dx0):
            return textbook((dx * dx0 + dy * dy0) / self.distance(dx0, dy0))
        square = dx * dx + dy * dy
        root = root_of_square(square)
        if root is not None:
            return self.absolute(root)
        self.table.legs[dx, dy] = None
        return self.table.sqrt(textbook(square) if square.mask & self.coordinates.time.mask else square)

    def unrooted(self, nodes: "list[Node]") -> "list[Node]":
        """The nodes with √(L² cos² θ) as L cos θ, with its sign as drawn; what stands beside it in factors."""
        simpler = {}
        for part in reachable(nodes):
            roots = {base: root_of_square(base) for base, e in part.args
                     if e.denominator == 2 and base.mask} if part.op == "product" else {}
            if any(root is not None for root in roots.values()):
                factors: list[tuple[Node, Fraction | int]] = [(self.table.number(part.coefficient), ONE)]
                for base, e in part.args:
                    root = roots.get(base)
                    factors += _factors(base, e) if root is None else [(self.absolute(root), 2 * e)]
                simpler[part] = self.table.product(*factors)
        return self.unrooted(substitute(nodes, simpler)) if simpler else nodes      # roots within others are left

    def height_of(self, surface: Record, x: "Node") -> "Node":
        """f(x) of a curve y = f(x)."""
        return self.lower(surface["curve"], (surface["in"], x))


def _factors(base: "Node", exponent: "Fraction | int") -> "Sequence[tuple[Node, Fraction | int]]":
    """[(factor, its exponent)] of a sum; a power, anything else and what is too long are one."""
    try:
        if exponent == 1 and base.op == "sum":
            return factors_of(base.table, reduced(expanded(base)))
    except (TooLong, ZeroDivisionError):
        pass
    return [(base, exponent)]


def _hidden(tree: "SyntaxTree", told: bool = False) -> "list[Fraction]":
    """The values of literals whose units no letter tells; `told`: letters are added."""
    if tree.kind == "number":
        unit = literal_unit(tree.units) if tree.value and tree.units and not told else None
        return [tree.value * unit.value] if unit and unit.dimension else []
    told = tree.kind == "sum" and any(part.kind != "number" for part in tree.children)
    return [value for part in tree.children for value in _hidden(part, told)]
