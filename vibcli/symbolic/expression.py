"""The table of expressions: equal expressions are one node, so shared parts are differentiated and evaluated once.

Rationals are ints where they are whole, else Fractions. Only rational literals fold, and only while the result stays
within BITS; parameters are leaves. Every walk is iterative, because a node is always made after its parts: ascending
`index` is an order of evaluation."""

from collections.abc import Collection, Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.exact_values import folded
from vibcli.symbolic.node import BARS, Node, by_index, one_variable, union, without_bars
from vibcli.symbolic.rationals import BITS, HALF, ONE, ZERO, bits, exact, rational_power, square_part

if TYPE_CHECKING:
    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.variable_sets import VariableSet

_OF_PAIRS = ("sum", "product")


class Table:
    """All nodes of one scene. Symbols are made by `parameter` and `variable`; the rest by the operators. `sample`:
    float values of the parameters, once they are known; they decide only how R − r is written, and with
    `squares_at_sample` how (R − r)² is; dimension(name): that of a letter, if known; `hidden`: literals whose
    units no letter tells; `legs`: (dx, dy) of which it has roots √(dx² + dy²)."""

    time: Node

    def __init__(self, records: dict[Any, Any] | None = None, squares_at_sample: bool = False,
                 functions: "dict[str, DefinedFunction] | None" = None, dimension: Any = None,
                 hidden: "Collection[Any] | None" = None) -> None:
        """`records`: {name: samples} of functions of the time; `functions`: {name: DefinedFunction}."""
        self._nodes: dict[tuple[Any, ...], Node] = {}
        self._count, self.dimension, self.hidden = 0, dimension, set() if hidden is None else hidden
        self.variables, self.called, self.legs, self.sample, self.signs, self.time = [], set(), {}, None, {}, None
        self.squares_at_sample, self.records, self.functions = squares_at_sample, records or {}, functions or {}
        self.positive, self.definitions, self.programs, self.kept = set(), {}, {}, {}
        self.zero, self.one = self.number(ZERO), self.number(ONE)
        self.pi = self._make("pi", (), ONE, 0, "pi")
        self.positive.add(self.pi)

    def __len__(self) -> int:
        return self._count

    def _make(self, op: str, args: tuple[Any, ...], coefficient: Fraction | int, mask: "VariableSet | int" = 0,
              name: str | None = None) -> Node:
        """The one node like this; what has parts depends on the variables of these."""
        key = (op, name, coefficient, args)
        if (node := self._nodes.get(key)) is None:
            node = self._nodes[key] = Node()
            parts = args if op == "call" else tuple([arg for arg, _ in args]) if op in _OF_PAIRS else ()
            node.table, node.op, node.args, node.coefficient, node.parts = self, op, args, coefficient, parts
            node.mask, node.name = union([part.mask for part in parts]) if parts else mask, name
            node.index, node.gradient = self._count, None
            self._count += 1
        return node

    def number(self, value: Fraction | int) -> Node:
        return self._make("number", (), value if value.__class__ is int else exact(value), 0)

    def node(self, value: Fraction | int | Node) -> Node:
        return value if isinstance(value, Node) else self.number(value)

    def parameter(self, name: str, positive: bool = True) -> Node:
        node = self._make("symbol", (), ONE, 0, name)
        if positive:
            self.positive.add(node)
        return node

    def variable(self, name: str) -> Node:
        """A symbol to differentiate by."""
        known = self._nodes.get(("symbol", name, ONE, ()))
        if known is not None:
            return known
        node = self._make("symbol", (), ONE, one_variable(len(self.variables)), name)
        self.variables.append(node)
        return node

    def defined(self, name: str, node: Node) -> Node:
        """A symbol that stands for a long node without variables, which is evaluated and never written out."""
        if node.op in ("number", "symbol"):
            return node
        found = self._make("symbol", (node,), ONE, 0, name)
        self.definitions[found] = node
        return found

    def time_variable(self, name: Any) -> Node:
        """The variable that is the time."""
        self.time = self.variable(name)
        return self.time

    def dependent(self, name: str, mask: "VariableSet | int", at_rest: bool = False) -> Node:
        """A symbol that depends on variables through an equation: its `gradient` is set where that is solved.
        `at_rest`: that of this name in the scene at rest, which has another gradient."""
        return self._make("symbol", (self.zero if at_rest else self.one,), ONE, mask, name)

    def scaled(self, node: Node, factor: float | Fraction) -> Node:
        """factor·node, the factor rational; over a sum it is distributed."""
        if factor == 1:
            return node
        return self.sum((node, factor))

    def sum(self, *terms: tuple[Node, Any]) -> Node:
        """Σ cᵢ·nodeᵢ of (node, rational c) pairs; sums within sums are flattened, equal terms collected."""
        if len(terms) == 1 and terms[0][1] == 1 and (terms[0][0].op != "product" or terms[0][0].coefficient == 1):
            return terms[0][0]
        constant, collected = ZERO, {}
        for node, factor in terms:
            if factor.__class__ is not int:
                factor = exact(factor)
            op = node.op
            if op == "sum":
                if node.coefficient:
                    constant += factor * node.coefficient
                for part, c in node.args:
                    if factor != 1:
                        c = factor * c
                    collected[part] = collected[part] + c if part in collected else c
                continue
            if op == "number" and bits(node.coefficient) <= BITS:
                if node.coefficient:
                    constant += factor * node.coefficient
                continue
            if op == "product" and node.coefficient != 1:
                factor = factor * node.coefficient if factor != 1 else node.coefficient
                node = self._bare(node)
            collected[node] = collected[node] + factor if node in collected else factor
        return self._sum(constant, collected)

    def _bare(self, product: Node) -> Node:
        """A product without its rational coefficient."""
        args: tuple[tuple[Node, Any], ...] = product.args
        if len(args) == 1 and args[0][1] == 1:
            return args[0][0]
        return self._make("product", args, ONE)

    def _sum(self, constant: Fraction | int, collected: dict[Node, Fraction | int]) -> Node:
        if constant and bits(constant) > BITS:
            collected[self.number(constant)] = ONE
            constant = ZERO
        args = [(node, c if c.__class__ is int else exact(c)) for node, c in collected.items() if c]
        if not args:
            return self.number(constant)
        if len(args) == 1 and not constant:
            node, c = args[0]
            if c == 1:
                return node
            if node.op == "product":
                return self._make("product", node.args, c)
            return self._make("product", ((node, ONE),), c)
        args.sort(key=by_index)
        return self._make("sum", tuple(args), exact(constant))

    def total(self, nodes: Iterable[Node]) -> Node:
        """Σ nodeᵢ."""
        return self.sum(*((node, 1) for node in nodes))

    def product(self, *factors: tuple[Node, Fraction | int]) -> Node:
        """Π nodeᵢ^eᵢ of (node, rational e) pairs; products are flattened and equal bases collected."""
        coefficient, collected = ONE, {}
        for node, exponent in factors:
            exponent = exponent if exponent.__class__ is int else exact(exponent)
            if node.op in ("symbol", "call"):
                collected[node] = collected[node] + exponent if node in collected else exponent
            elif node.op == "number" and exponent == 1 and node not in collected and (
                    bits(node.coefficient) + bits(coefficient) <= BITS):
                coefficient = exact(coefficient * node.coefficient)
            else:
                coefficient = self._gather(node, exponent, coefficient, collected)
        args = [(base, e if e.__class__ is int else exact(e)) for base, e in collected.items() if e]
        if not (args and coefficient):
            return self.number(coefficient) if coefficient else self.zero
        if not self.called.isdisjoint(BARS) and (plainer := without_bars(collected)) is not None:
            return self.product((self.number(coefficient), ONE), *plainer)
        if coefficient != 1 and bits(coefficient) > BITS:
            args.append((self.number(coefficient), ONE))
            coefficient = ONE
        if len(args) == 1 and args[0][1] == 1:
            base = args[0][0]
            if coefficient == 1:
                return base
            if base.op == "sum":
                return self.sum((base, coefficient))
        elif len(args) > 1:
            args.sort(key=by_index)
        return self._make("product", tuple(args), exact(coefficient))

    def _gather(self, node: Node, exponent: Fraction | int, coefficient: Fraction | int,
                collected: dict[Node, Fraction | int]) -> Fraction | int:
        """Multiply node^exponent into (coefficient, {base: exponent}); returns the new coefficient."""
        pending = [(node, exponent)]
        while pending:
            base, e = pending.pop()
            if base.op == "number":
                coefficient = self._gather_number(base.coefficient, e, coefficient, collected)
                continue
            if base.op == "product" and (e.denominator == 1 or self._splits(base)):
                value = rational_power(base.coefficient, e)
                if value is None:
                    pending.append((self.number(base.coefficient), e))
                elif value != 1:
                    coefficient *= value
                pending += base.args if e == 1 else [(part, power * e) for part, power in base.args]
                continue
            if base.op == "sum" and e.denominator == 1 and self._leads_negative(base):
                base = self.scaled(base, -ONE)
                coefficient = coefficient if e.numerator % 2 == 0 else -coefficient
            if base in collected:
                e += collected.pop(base)
            if base.op == "product" and e.denominator == 1:
                pending.append((base, e))
            else:
                collected[base] = e
        return coefficient

    def _gather_number(self, value: Fraction | int, e: Fraction | int, coefficient: Fraction | int,
                       collected: dict[Node, Fraction | int]) -> Fraction | int:
        """value^e into the coefficient as far as that is rational and short; of √8 = 2√2 the root stays."""
        if not value:
            return coefficient * rational_power(value, exact(e) if e <= 0 else ONE)
        if e.denominator == 2:
            outside, value = square_part(value)
            coefficient = exact(coefficient * Fraction(outside) ** e.numerator)
        if value == 1:
            return coefficient
        base = self.number(value)
        if base in collected:
            e = exact(e + collected.pop(base))
        whole = e.numerator // e.denominator
        factor = rational_power(value, whole)
        if factor is not None and bits(factor) + bits(coefficient) <= BITS:
            coefficient, e = exact(coefficient * factor), exact(e - whole)
        if e:
            collected[base] = e
        return coefficient

    def _leads_negative(self, total: Node) -> bool:
        """Of a sum and its negative only one stands in products, so that R − r and r − R cancel: of parameters the
        one that is positive at the sample values."""
        leads = (total.coefficient or total.args[0][1]) < 0
        if self.sample is None or total.mask:
            return leads
        if total not in self.signs:
            from vibcli.symbolic.evaluation import Floats, evaluate

            try:
                self.signs[total] = evaluate([total], Floats, self.sample)[0] < 0
            except KeyError:  # a symbol that is no parameter of the scene
                self.signs[total] = leads
        return self.signs[total]

    def resample(self, sample: Any) -> None:
        """Decide by other values of the parameters from now on how R − r is written."""
        self.sample, self.signs, self.kept = sample, {}, {}

    def _splits(self, product: Node) -> bool:
        """(Π bᵢ^eᵢ)^e = Π bᵢ^(eᵢe) holds for fractional e where every base is positive."""
        return product.coefficient > 0 and all(self.is_positive(base) for base, _ in product.args)

    def is_positive(self, node: Node, depth: int = 4) -> bool:
        """Is a node positive whatever the values of the variables? Sums and products of what is, to some depth."""
        if node.op == "number":
            return node.coefficient > 0
        if node in self.positive or node.name in ("exp", "cosh"):
            return True
        if node.mask or not depth or node.op not in ("sum", "product") or node.coefficient < 0:
            return False
        if all(self.is_positive(part, depth - 1) and (c > 0 or node.op == "product") for part, c in node.args):
            self.positive.add(node)
        return node in self.positive

    def power(self, base: Node, exponent: Fraction | int | Node) -> Node:
        """base^exponent, the exponent a rational or a node."""
        if isinstance(exponent, Node):
            if exponent.op != "number":
                return self.call("power", base, exponent)
            exponent = exponent.coefficient
        exponent = exact(exponent)
        if abs(exponent.numerator) > 1000 or exponent.denominator > 1000:
            return self.call("power", base, self.number(exponent))
        if base.op == "number" and not base.coefficient and exponent <= 0:
            if exponent == 0:
                return self.one
            raise ZeroDivisionError("division by zero")
        return self.product((base, exponent))

    def sqrt(self, node: Node) -> Node:
        return self.power(node, HALF)

    def call(self, name: str, *args: Node) -> Node:
        """A function of nodes; its value is folded only where it is exact (sin 0 = 0)."""
        if (value := folded(self, name, args)) is None:
            self.called.add(name)
            value = self.written(name, *args)
        return value

    def written(self, name: str, *args: Node) -> Node:
        """A call of a function as it stands: sin(x − a) where its value is −sin(a − x)."""
        return self._make("call", args, ONE, name=name)
