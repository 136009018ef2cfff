"""Directions and distances of a scene, as expressions."""

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, root_of_square, textbook
from vibcli.symbolic.rationals import ONE


class Geometry:
    """Turns what is drawn into expressions; their signs are those as drawn."""

    __slots__ = ("at_drawn", "expressions", "report", "sign", "table", "time")

    def __init__(self, expressions):
        self.expressions, self.sign, self.table = expressions, expressions.sign, expressions.table
        self.at_drawn, self.time = expressions.coordinates.at_drawn, expressions.coordinates.time
        self.report = expressions.reports.report

    def unit(self, dx, dy, where=None):
        """The unit vector along (dx, dy), constants."""
        length = self.distance(dx, dy)
        if abs(self.expressions.number(length)) == 0:
            self.report(where, "this direction has no length", "give one such as [0, 1], or two different places")
            return self.table.one, self.table.zero
        return dx / length, dy / length

    def absolute(self, node):
        """A node or its opposite, so that it is positive as drawn."""
        return node if self.sign(node) > 0 else -node

    def distance(self, dx, dy):
        """√(dx² + dy²), rational where the direction never changes: there it is ±dx, ±dy or their projection."""
        dx0, dy0 = self.at_drawn(dx, dy)
        for along, across in ((dx, dy), (dy, dx)):
            if is_zero(across):
                return self.absolute(along)
        if not dx.mask and not dy.mask:
            return self.table.sqrt(textbook(dx * dx + dy * dy))
        if is_zero(dx * dy0 - dy * dx0):
            return (dx * dx0 + dy * dy0) / self.distance(dx0, dy0)
        square = dx * dx + dy * dy
        root = root_of_square(square)
        if root is not None:
            return self.absolute(root)
        return self.table.sqrt(textbook(square) if square.mask & self.time.mask else square)

    def unrooted(self, nodes):
        """The nodes with √(L² cos² θ) as L cos θ, with its sign as drawn."""
        simpler = {}
        for part in reachable(nodes):
            roots = {base: root_of_square(base) for base, e in part.args
                     if e.denominator == 2 and base.mask} if part.op == "product" else {}
            if any(root is not None for root in roots.values()):
                factors = [(base, e) if (root := roots.get(base)) is None else
                           (self.absolute(root), 2 * e) for base, e in part.args]
                simpler[part] = self.table.product((self.table.number(part.coefficient), ONE), *factors)
        return substitute(nodes, simpler) if simpler else nodes

    def height_of(self, surface, x):
        """f(x) of a curve y = f(x)."""
        return self.expressions.lower(surface["curve"], (surface["in"], x))
