"""The steps of an expansion of the energies by powers of the deviations ξ from rest, up to an order n: of each spring

    Δ = Σ Δᵢ, to order n where it is loaded at rest, else to n − 1,   V_s = N Δ + k Δ²/2 + …

then the sums V and T, and Lagrange's equations of these to order n − 1 (Kovacić & Radomirović 2018, 9.4 and 9.5).
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isclose
from operator import mul
from random import Random
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.expansion import ENERGIES
from vibcli.report.blocks import Name, Words
from vibcli.report.sections.expansion import WORD, left_out, order_asked, sum_of
from vibcli.report.steps.agreement import ALIKE, samples_of
from vibcli.report.steps.step import WorkedSolution
from vibcli.results.expansions import deflection, expansions, is_loaded, of_loads, of_others
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.nested_form import letters

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.mechanics.spring_shares import SpringShares
    from vibcli.results.expansions import Expansion
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LONG = 300              # letters of all terms, beyond which they are told in numbers
DIGITS, NEAR = 160, 8   # in which a remainder is looked at, and where: 10^−NEAR from rest


def tell_expansion(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down the expansion that a scene asks; nothing of others, or where there is none."""
    if WORD not in (problem.spec.get("find") or ()):
        return
    order = order_asked(problem)
    try:
        one = _chosen(problem, expansions(problem, order), order)
    except PhysicsError:
        return
    _Told(problem, sheet, one, order).write()


def _chosen(problem: "Problem", found: "Sequence[Expansion]", order: int) -> "Expansion":
    """In letters where these are not long and leave a remainder of a higher order; else in numbers."""
    short = found[0].letters and sum(letters(c) for terms in found[0].energies.values() for c in terms.values()) <= LONG
    return found[0] if len(found) == 1 or (short and _remains_small(problem, found[0], order)) else found[-1]


def _remains_small(problem: "Problem", one: Any, order: int) -> bool:
    """Is what V and T have beyond their terms of a higher order, half as far from rest less by more than 2^order?"""
    from mpmath import mp, mpf, workdps

    scene, place = problem.scene.resting, problem.symbolic.equilibrium_position
    moved = [*scene.q, *scene.v]
    with workdps(DIGITS):
        arithmetic = multiprecision()
        known = {name: mpf(value) for name, value in samples_of(problem, {})[0].items()}
        rest = dict(zip(place, evaluate(list(place.values()), arithmetic, known), strict=True))
        rest = {**known, scene.time.name: mpf(0), **{x.name: mpf(0) for x in (*scene.v, *scene.a)}, **rest}

        def remainder(which: str, far: Any) -> Any:
            off = {x.name: far * (i + 2) / (i + 1) for i, x in enumerate(moved)}
            nodes = [ENERGIES[which](scene)]
            (there,), (here,) = (evaluate(nodes, arithmetic, values) for values in (
                {**rest, **{name: rest[name] + by for name, by in off.items()}}, rest))
            terms = [(c, one.product(powers)) for powers, c in one.energies[which].items()]
            values = evaluate([node for term in terms for node in term], arithmetic, {**rest, **off})
            return abs(there - here - sum(a * b for a, b in zip(values[::2], values[1::2], strict=True)))

        for which in "VT":
            far, near = (remainder(which, mpf(10) ** -NEAR / half) for half in (1, 2))
            if not near <= far * mpf(2) ** -order / mp.sqrt(2) and far > mpf(10) ** (20 - DIGITS):
                return False
    return True


class _Told:
    """The lines of an Expansion to an order."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution, one: "Expansion", order: int) -> None:
        self.problem, self.sheet, self.one, self.order = problem, sheet, one, order

    def write(self) -> None:
        """Write down all of them."""
        parts = self._rest([line for name in self.one.springs for line in self._spring(name)])
        V = parts[0] if len(parts) == 1 else self._energy("V", parts)
        W = of_loads(self.problem, self.order, self.one.letters)
        work = [self.sheet.write(Words(f"work of the steady loads, to order {self.order}:  "), *self._sum(W),
                                 settles=self._to_order("work"), node=self._node(W), uses=[V])] if W else []
        self._equations([V, self._energy("T", ()), *work])

    def _spring(self, name: str) -> Iterator[int]:
        """Its deflection, then its energy; nothing of what stores none."""
        one, shares, sheet = self.one, self.one.springs[name], self.sheet
        whole = _added(shares.material, shares.geometric)
        if not whole:
            return
        order = self.order if is_loaded(self.problem, name, one.letters) else self.order - 1
        terms = deflection(self.problem, name, order, one.letters)
        delta, V = sheet.letter("Delta", name), sheet.letter("V", name)
        line = self._told(delta, terms) or sheet.write(
            Words(f"deflection of {name} from rest, to order {order}:  "), Name(delta), " = ", *self._sum(terms),
            settles=f"{delta} to order {order}", node=self._node(terms), uses=[self._line_of(delta)])
        yield self._told(V, whole) or sheet.write(
            Words(f"with its law, to order {self.order}:  "), Name(V), " = ", *self._sum(whole), *self._shared(shares),
            settles=self._to_order(V), node=self._node(whole), uses=[line, self._line_of(V)])

    def _shared(self, shares: "SpringShares") -> tuple[Any, ...]:
        """What of an energy the material makes, where the geometry adds to it."""
        if not shares.geometric:
            return ()
        if not shares.material:
            return (Words(",  all of it by its geometry, as Δ has no first order"),)
        return (Words(",  of it  "), *self._sum(shares.material),
                Words("  by its material, were Δ of the first order alone, the rest by its geometry"))

    def _rest(self, lines: list[int]) -> list[int]:
        """The lines of all parts of V: those of the springs, and of what is left."""
        left = of_others(self.problem, self.order, self.one.letters)
        if not left:
            return lines
        others = "of weights, " if self.problem.scene.weights else "of all else, " if lines else ""
        letter = self.sheet.letter("V", ("g" if self.problem.scene.weights else "0") if lines else "")
        return [*lines, self.sheet.write(Words(f"{others}to order {self.order}:  "), Name(letter), " = ",
                                         *self._sum(left), settles=self._to_order(letter), node=self._node(left))]

    def _energy(self, which: str, uses: Sequence[int]) -> int:
        letter, terms = self.sheet.letter(which), self.one.energies[which]
        words = Words("summed:  " if uses else f"to order {self.order}:  ")
        return self._told(letter, terms) or self.sheet.write(
            words, Name(letter), " = ", *self._sum(terms), settles=self._to_order(letter), node=self._node(terms),
            uses=uses)

    def _equations(self, uses: list[int]) -> None:
        """Lagrange's equations of T and V to one order less."""
        equations, missing = self.one.equations, left_out(self.problem, self.one)
        for i, (name, terms) in enumerate(zip(self.problem.scene.coordinates, equations or (), strict=False)):
            words = f"Lagrange's equation, to order {self.order - 1}:  " if len(equations) == 1 else (
                f"Lagrange's equation of {name}, to order {self.order - 1}:  ")
            self.sheet.write(Words(words), *self._sum(terms), " = 0",
                             *([Words(f"   (without {' and '.join(missing)})")] if missing and not i else ()),
                             settles=f"expanded equation of {name}", node=self._node(terms), uses=uses)

    def _sum(self, terms: Any) -> Any:
        return sum_of(self.problem, self.one, terms)

    def _node(self, terms: Any) -> "Node | None":
        table = self.problem.scene.table
        return table.sum(*((self.one.product(powers) * c, 1) for powers, c in terms.items())) if (
            self.one.letters) else None

    def _to_order(self, letter: str) -> str:
        return f"{letter} to order {self.order}"

    def _told(self, letter: str, terms: Any) -> int | None:
        """The number of the line that told these terms before; None where none did."""
        found = next((line for line in self.sheet.steps if line.settles == letter and line.node is not None), None)
        scene, draw = self.problem.scene.resting, Random(letter)
        for values in samples_of(self.problem, {}):
            state = {x.name: draw.uniform(-1, 1) for x in (*scene.q, *scene.v)}
            try:
                before, = evaluate([found.node], Floats, {**values, **state}) if found else (None,)
            except KeyError:        # it has letters of its own
                return None
            products = [self.one.product(powers) for powers in terms]
            factors = [c if self.one.letters else scene.table.number(Fraction(c)) for c in terms.values()]
            total = sum(map(mul, *(evaluate(nodes, Floats, {**values, **state}) for nodes in (products, factors))))
            if before is None or not isclose(total, before, rel_tol=ALIKE):
                return None
        return found.number

    def _line_of(self, letter: str) -> int:
        """The number of the line that settles a letter to the second order; None where there is none."""
        return next((line.number for line in self.sheet.steps if line.settles == letter), None)


def _added(one: "Mapping[tuple[int, ...], Any]", other: "Mapping[tuple[int, ...], Any]") -> dict[tuple[int, ...], Any]:
    """{powers: factor} of a sum."""
    return {powers: one[powers] + other[powers] if powers in one and powers in other else
            one.get(powers, other.get(powers)) for powers in sorted({*one, *other}, key=lambda p: (sum(p), p[::-1]))}
