"""Expressions as power series: source that computes one coefficient after the other from those before it.

A series Σ uₖ sᵏ is a list of fixed-point integers (value · 2ᴮ), which grows by one coefficient in each round k. The
parts of an expression follow one another (Griewank & Walther, Evaluating Derivatives, 2008, §13.2):

    p = u w         pₖ = Σ uⱼ wₖ₋ⱼ                     r = 1/u      u₀ rₖ = −Σ_{j>0} uⱼ rₖ₋ⱼ
    f′ = u′ g       k fₖ = Σ j uⱼ gₖ₋ⱼ                 p = √u       2 p₀ pₖ = uₖ − Σ_{0<j<k} pⱼ pₖ₋ⱼ
                                                       p = uᵉ       k u₀ pₖ = Σ_{j>0} ((e + 1) j − k) uⱼ pₖ₋ⱼ

What is constant is computed once, to all its digits. The source is made of our own slot names alone.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

ODD_AND_EVEN = {"sin": ("sin", "cos", "-"), "cos": ("sin", "cos", "-"), "sinh": ("sinh", "cosh", ""),
                "cosh": ("sinh", "cosh", "")}
SMOOTH = frozenset(("tan", "tanh", "asin", "acos", "atan", "atan2", "exp", "log", "power", *ODD_AND_EVEN))


class SeriesSource:
    """`first`: lines that compute the coefficients of order 0; `lines`: those of order k > 0, given k, h = ⌊(k + 1)/2⌋
    and the number of bits B. slots: {symbol: its list}; constants: {node: slot} of what is made of parameters alone."""

    def __init__(self, slots: "Mapping[Node, str]") -> None:
        self.slots, self.first, self.lines = dict(slots), [], []
        self._lists: dict[Any, str] = {}
        self.constants: dict[Node, str] = {}

    @property
    def products(self) -> int:
        """Of series, in each round."""
        return sum(line.count("map(mul") for line in self.lines)

    def add(self, nodes: "Sequence[Node]") -> list[str]:
        """The lists of the nodes."""
        for part in reachable(nodes, self.slots):
            if part.mask and part not in self.slots:
                self.slots[part] = getattr(self, "_" + part.op)(part)
        return [self._list(node) for node in nodes]

    def _list(self, node: "Node") -> str:
        return self.slots[node] if node.mask else self._once(("constant", node), self._constant(node), "0")

    def _constant(self, node: "Node") -> str:
        """The slot of a number."""
        return self.constants.setdefault(node, f"c{len(self.constants)}")

    def _once(self, key: Any, first: str, step: str) -> str:
        """The list of these coefficients, in whose texts it is called @; made once."""
        if key not in self._lists:
            self._lists[key] = slot = f"x{len(self._lists)}"
            self._write(slot, first, step)
        return self._lists[key]

    def _write(self, slot: str, first: str, step: str) -> None:
        self.first.append(f"{slot}=[{first}]".replace("@", slot))
        self.lines.append(f"{slot}.append({step})".replace("@", slot))

    def _symbol(self, node: "Node") -> None:
        raise KeyError(node.name)

    def _sum(self, node: "Node") -> str:
        table, parts = node.table, node.args
        still = table.sum(*((part, c) for part, c in parts if not part.mask), (table.number(node.coefficient), ONE))
        step = "".join(self._scaled(table.number(c), self.slots[part]) for part, c in parts if part.mask)
        return self._once(node, step if still.is_zero else f"{step}+{self._constant(still)}", step)

    def _scaled(self, factor: "Node", u: str) -> str:
        """+ factor·(the last coefficient of a list)"""
        if factor.op != "number" or factor.coefficient.denominator != 1:
            return f"+({u}[-1]*{self._constant(factor)}>>B)"
        whole = int(factor.coefficient)
        return f"{'+' if whole > 0 else '-'}{u}[-1]" if abs(whole) == 1 else f"{whole:+d}*{u}[-1]"

    def _product(self, node: "Node") -> str:
        table, found = node.table, None
        for base, e in node.args:
            if base.mask:
                factor = self._power_of(self.slots[base], e)
                found = factor if found is None else self._times(found, factor)
        still = table.product(*((base, e) for base, e in node.args if not base.mask),
                              (table.number(node.coefficient), ONE))
        if still.op == "number" and still.coefficient == 1:
            return found
        text = self._scaled(still, found)
        return self._once(node, text, text)

    def _times(self, u: str, w: str) -> str:
        if u == w:
            return self._square(u)
        u, w = sorted((u, w))
        return self._once(("times", u, w), f"{u}[0]*{w}[0]>>B", f"sum(map(mul,{u},{w}[::-1]))>>B")

    def _square(self, u: str) -> str:
        return self._once(("square", u), f"{u}[0]**2>>B",
                          f"2*sum(map(mul,{u}[:h],{u}[:-h-1:-1]))+(0 if k&1 else {u}[h]**2)>>B")

    def _power_of(self, u: str, e: Fraction | int) -> str:
        """uᵉ: of whole numbers by squares, products and one division, of halves by one root."""
        if e == 1:
            return u
        if e == -1:
            return self._once(("inverse", u), f"over({u}[0])", f"-(sum(map(mul,{u}[:0:-1],@))>>B)*@[0]>>B")
        if e == HALF:
            return self._once(("root", u), f"root({u}[0])",
                              f"(({u}[-1]<<B)-sum(map(mul,@[1:],@[:0:-1])))//(2*@[0])")
        if e.denominator > 2:
            return self._any_power(u, e)
        if e < 0:
            return self._power_of(self._power_of(u, -e), -ONE)
        if e.denominator == 2:
            return self._times(self._power_of(u, e - HALF), self._power_of(u, HALF))
        half = self._power_of(u, e // 2)
        return self._square(half) if e % 2 == 0 else self._times(self._square(half), u)

    def _any_power(self, u: str, e: Fraction | int) -> str:
        n, d, slope = e.numerator, e.denominator, self._slope(u)
        return self._once(("power", u, e), f"power({u}[0],{n},{d})",
                          f"({n + d}*sum(map(mul,{slope},@[::-1]))-{d}*k*sum(map(mul,{u}[:0:-1],@)))//({d}*k*{u}[0])")

    def _slope(self, u: str) -> str:
        """The list of j uⱼ, j > 0."""
        key = "slope", u
        if key not in self._lists:
            self._lists[key] = slot = f"x{len(self._lists)}"
            self.first.append(f"{slot}=[]")
            self.lines.append(f"{slot}.append(k*{u}[-1])")
        return self._lists[key]

    def _integral(self, name: str, u: str, slope: str, sign: str = "") -> str:
        """f(u), where f′ = ± slope."""
        return self._once((name, u), f"{name}({u}[0])", self._rate(u, slope, sign))

    def _rate(self, u: str, g: str, sign: str = "") -> str:
        """The coefficient of f, where f′ = ± u′ g."""
        return f"{sign}(sum(map(mul,{self._slope(u)},{g}[k-1::-1]))>>B)//k"

    def _call(self, node: "Node") -> str:
        if node.name not in SMOOTH:
            raise KeyError(node.name)
        args = map(self._list, node.args)
        return self._pair(node.name, *args) if node.name in ODD_AND_EVEN else getattr(self, "_" + node.name)(*args)

    def _pair(self, name: str, u: str) -> str:
        """sin and cos, or sinh and cosh, each of which is the rate of the other."""
        odd, even, sign = ODD_AND_EVEN[name]
        if (odd, u) not in self._lists:
            self._slope(u)
            s = self._lists[odd, u] = f"x{len(self._lists)}"
            c = self._lists[even, u] = f"x{len(self._lists)}"
            self._write(s, f"{odd}({u}[0])", self._rate(u, c))
            self._write(c, f"{even}({u}[0])", self._rate(u, s, sign))
        return self._lists[name, u]

    def _exp(self, u: str) -> str:
        self._slope(u)
        return self._integral("exp", u, "@")

    def _tan(self, u: str) -> str:
        return self._of_its_square("tan", u, "+")

    def _tanh(self, u: str) -> str:
        return self._of_its_square("tanh", u, "-")

    def _of_its_square(self, name: str, u: str, sign: str) -> str:
        """f′ = 1 ± f²"""
        if (name, u) not in self._lists:
            self._slope(u)
            f = self._lists[name, u] = f"x{len(self._lists)}"
            bend = self._lists[name, u, "′"] = f"x{len(self._lists)}"
            self._write(f, f"{name}({u}[0])", self._rate(u, bend))
            square = self._square(f)
            self._write(bend, f"(1<<B){sign}{square}[0]", f"{sign}{square}[-1]")
        return self._lists[name, u]

    def _log(self, u: str) -> str:
        return self._integral("log", u, self._power_of(u, -ONE))

    def _one_and_square(self, u: str, sign: str) -> str:
        square = self._square(u)
        return self._once(("one", sign, square), f"(1<<B){sign}{square}[0]", f"{sign}{square}[-1]")

    def _asin(self, u: str) -> str:
        return self._integral("asin", u, self._power_of(self._one_and_square(u, "-"), -HALF))

    def _acos(self, u: str) -> str:
        return self._integral("acos", u, self._power_of(self._one_and_square(u, "-"), -HALF), "-")

    def _atan(self, u: str) -> str:
        return self._integral("atan", u, self._power_of(self._one_and_square(u, "+"), -ONE))

    def _atan2(self, y: str, x: str) -> str:
        """Its rate is (x y′ − y x′)/(x² + y²)."""
        squares = self._square(x), self._square(y)
        total = "+".join(f"{square}[-1]" for square in squares)
        over = self._power_of(self._once(("sum", *squares), total, total), Fraction(-1))
        along = self._rate(y, self._times(x, over)) + self._rate(x, self._times(y, over), "-")
        return self._once(("atan2", y, x), f"atan2({y}[0],{x}[0])", along)

    def _power(self, u: str, w: str) -> str:
        """u^w = e^{w log u}"""
        return self._exp(self._times(w, self._log(u)))
