"""Springs, weights, dampers and steady loads about rest: what each adds to V and Φ.

    V_s = N Δ + ½ k Δ²      V_w = f (s − s₀)      Φ_d = ½ c u̇²      δA = F δs

N is the tension at rest. What is loaded at rest, a weight or a steady load is followed to the second order, as its
force meets the curvature of s; else the first order suffices, the square of Δ being all that counts.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, SumOfTerms, Words
from vibcli.report.steps.bodies import LONG, EnergyPart
from vibcli.report.steps.lettered import is_told_by_number
from vibcli.report.steps.parts_in_series import tell_parts
from vibcli.report.steps.sides import by_sides
from vibcli.report.steps.small import AboutRest, Small
from vibcli.report.steps.step import WorkedSolution, number, place_told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.scene.energy_terms import Damper, Spring
    from vibcli.scene.laws import Law
    from vibcli.symbolic.node import Node

AT_ONCE = 4         # letters of a stretch or speed, up to which its energy stands in the same line
AT_SIGHT = 12       # letters of a potential of weights, up to which it is told unexpanded as well
FIRST = "   (first order: it bears nothing at rest)"
SECOND = "   (second order: its force at rest counts)"
LIMP = "   (second order: it has no such term)"
SLOPES = {("k", "N"): "N/m", ("k", "N·m"): "N·m/rad", ("c", "N"): "N·s/m", ("c", "N·m"): "N·m·s/rad"}
STRAIGHT = "   (second order, as its force at rest counts: there is no such term)"


class Acting(NamedTuple):
    """Something that stores energy by a function s of the coordinates: its tension at rest as it is known, as a letter
    (or itself where it needs none), its stiffness or None, s about rest, the number of its line; linear: is its tension
    its stiffness times its deflection? kept: what stands for its tension in the sums, None of the tension itself."""

    name: str
    tension: Any
    shown: Any
    k: Any
    s: Small
    line: int | None
    linear: bool = False
    kept: Any = None


class Connections:
    """What the springs, weights, dampers and loads of a scene add; `others`: does something else add to V, too?"""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, others: bool) -> None:
        self.about, self.sheet, self.scene = about, sheet, about.scene
        springs = {term.owner for term in self.scene.springs} | {law.owner for law in self.scene.laws if not law.damper}
        acting = [{term.owner for term in terms} for terms in (self.scene.weights, self.scene.forces)]
        self._several = others or len(springs) + sum(map(len, acting)) > 1
        self._damping: list[Any] | None = None
        self._stretched: list[Any] = []
        self._located: set[str] = set()

    def _letter(self, letter: str, owner: str) -> str:
        """That of an element, its name with it where there are several."""
        return self.sheet.letter(letter, owner if self._several else "")

    def _of(self, term: Any) -> str:
        """The name of an element in letters, numbered where several terms are its own."""
        own = [one for one in (*self.scene.springs, *self.scene.dampers) if one.owner == term.owner]
        return term.owner if len(own) < 2 else f"{term.owner}{own.index(term) + 1}"

    def stored(self) -> "Iterator[tuple[EnergyPart, Acting]]":
        """(V, what acts) of each spring and each weight."""
        for term, still in self._beside("springs"):
            yield self._spring(term, term.weight, still)
        for law, still in self._beside("laws"):
            if not law.damper:
                yield self._spring(law, self._slope(law, still.s, "k", "stiffness"), still)
        yield from self._weights()

    def _beside(self, kind: str) -> Iterator[Any]:
        """[(term, the same as a function of driven displacements)]."""
        return zip(getattr(self.scene, kind), self.scene.undriven(kind), strict=True)

    def _slope(self, law: "Law", at: "Node", letter: str, what: str) -> "Node":
        """The slope of a law at rest, told with a letter of its own."""
        tell_parts(self.about.problem, self.sheet, law.owner)
        slope = gradient(law.derivative).get(law.x, self.scene.table.zero)
        node = self.about.rest(substitute([slope], {law.x: at})[0], named=False)
        name = self.sheet.letter(letter, law.owner)
        value, unit = self.about.value(node), SLOPES[letter, self._unit(law.owner)]
        shown = [] if is_told_by_number(node, value) else [" = ", node]
        self.sheet.write(Words(f"{what} of {law.owner} at rest, the slope of its law:  "), Name(name), *shown,
                         *(() if value is None else number(value, unit)), settles=name, node=node, value=value,
                         unit="" if value is None else unit)
        return self.about.keep(self.about.letter(name), node) if self.about.is_long(node) else node

    def _unit(self, owner: str) -> str:
        """That of the force of an element."""
        return "N·m" if "torsion" in self._elements.get(owner, {}) else "N"

    def _spring(self, term: "Law | Spring", k: "Node", still: "Law | Spring") -> tuple[EnergyPart, Acting]:
        about, sheet = self.about, self.sheet
        small, tension = about.small(term.s), about.tension(still.force(self.scene))
        loaded = not tension.is_zero
        if (like := self._like_another(term, small, tension, k)) is not None:
            return like
        delta, V, N = (self._letter(letter, self._of(term)) for letter in ("Delta", "V", "N"))
        shown = self.scene.table.parameter(N, positive=False) if loaded else tension
        moves = about.moves(small) + (about.bent(small) if loaded else self.scene.table.zero)
        told, exact = self._told(term, small, moves, delta, loaded)
        square = about.half_squares([(k, small)], rates=False)
        node = shown * moves + square
        letter = about.letter(delta)
        formula = shown * letter + k * letter ** 2 / 2
        more = [" + …", Words(LIMP)] if node.is_zero and not hasattr(term, "weight") else []
        what = "moment" if self._unit(term.owner) == "N·m" else "force"
        more += [Words(",  "), Name(N), Words(f" its {what} at rest")] if loaded and not node.is_zero else []
        line = sheet.write(Name(V), *([] if formula.is_zero else [" = ", formula]), " = ", node, *more, settles=V,
                           node=node, uses=[told], joined=exact and letters(moves) <= AT_ONCE)
        kept = about.keep(shown, tension) if loaded else tension
        found = EnergyPart(V, node, line), Acting(term.owner, tension, shown, k, small, line, hasattr(term, "weight"),
                                                  kept)
        self._stretched.append((term, *found))
        return found

    def _like_another(self, term: "Law | Spring", small: Small, tension: "Node",
                      k: "Node") -> tuple[EnergyPart, Acting] | None:
        """V of a spring that is stretched like one before it, and as stiff; None of others."""
        for first, energy, acting in self._stretched:
            if (acting.k, acting.tension, acting.linear) == (k, tension, hasattr(term, "weight")) and is_zero(
                    first.s - term.s):
                V = self._letter("V", self._of(term))
                line = self.sheet.write(Words(f"{term.owner}, like {first.owner}:  "), Name(V), " = ", Name(
                    energy.letter), settles=V, node=energy.node, uses=[energy.line])
                return EnergyPart(V, energy.node, line), acting._replace(name=term.owner, s=small, line=line)
        return None

    def _told(self, term: "Law | Spring", small: Small, moves: "Node", letter: str, loaded: bool) -> tuple[int, bool]:
        """The line of a stretch, counted from rest, and whether it is told exactly."""
        s, exact = self._exactly(small, moves)
        s = by_sides(self.about, term.s, s)
        parts = [] if exact or letters(s) > LONG else [s, " = "]
        more = () if exact else (" + …", Words(FIRST if not loaded else SECOND if small.bends else STRAIGHT))
        return self.sheet.write(*self._across(f"stretch of {term.owner}, from rest", term), Name(letter), " = ",
                                *parts, moves, *more, settles=letter, node=moves), exact

    def _across(self, words: str, term: Any) -> "list[Node | str | Words]":
        """Words on an element, and the places of points between which it is, that no line before tells; none of points
        that go straight."""
        parts: list[Any] = [Words(words)]
        for end in self._elements.get(term.owner, {}).get("between", ()):
            name = getattr(end, "text", None)
            if name not in self.scene.points or name in self._located:
                continue
            place = [textbook(self.about.shifted(node)) for node in self.scene.points[name][1]]
            turned = any(node.op == "call" and node.mask for node in reachable(place))
            if turned and sum(map(letters, place)) <= LONG:
                self._located.add(name)
                parts += [Words(f", {name} at  "), *place_told(*place)]
        return [*parts, Words(":  ")]

    @property
    def _elements(self) -> dict[str, Any]:
        """{name: record} of the springs and dampers."""
        spec = self.about.problem.spec
        return {**(spec.get("springs") or {}), **(spec.get("dampers") or {})}

    def _exactly(self, small: Small, moves: "Node") -> "tuple[Node, bool]":
        """What a function of the coordinates is, counted from rest, and whether it is what is told of it."""
        s = textbook(self.about.shifted(small.s) - self.about.rest(small.still, named=False))
        return s, not small.bends and plain(s) == plain(textbook(moves))

    def _turns(self, s: "Node") -> bool:
        """Does what moves along s turn in time, so that a weight is a load in time there?"""
        return any(textbook(slope).mask & self.scene.time.mask for x, slope in gradient(s).items() if x in self.scene.q)

    def _weights(self) -> Iterator[tuple[EnergyPart, Acting]]:
        """The weight of each body, its height to the second order; of several all in a line."""
        acting = [Acting(term.owner, term.weight, term.weight, None, self.about.small(term.s), None)
                  for term in self.scene.weights if not self._turns(term.s)]
        about, total = self.about, self.scene.table.total
        moves = {one: about.first(one.s, self.scene.q) + about.bent(one.s) for one in acting}
        terms = {one.name: total([other.tension * moves[other] for other in acting if other.name == one.name])
                 for one in acting}
        terms = {name: node for name, node in terms.items() if not node.is_zero}
        acting = [one for one in acting if one.name in terms]
        if not acting:
            return
        V = self._letter("V", next(iter(terms)) if len(terms) == 1 else "g")
        words = "weight of" if len(terms) == 1 else "weights of"
        node = total(list(terms.values()))
        exact = all(self._exactly(one.s, moves[one])[1] for one in acting)
        more = () if exact else (" + …", Words(SECOND if any(one.s.bends for one in acting) else STRAIGHT))
        whole = total([one.tension * self._exactly(one.s, moves[one])[0] for one in acting])
        told = [] if exact or letters(whole) > AT_SIGHT else [whole, " = "]
        line = self.sheet.write(Words(f"{words} {listed(terms)}, counted from rest:  "), Name(V), " = ", *told,
                                SumOfTerms(tuple(terms.values())), *more, settles=V, node=node)
        for i, one in enumerate(acting):
            yield EnergyPart(V, node if not i else None, line), one._replace(line=line)

    def _dampers(self) -> "list[tuple[Damper, Node]]":
        """[(what damps, its coefficient at rest)]."""
        if self._damping is None:
            laws = [(law, self._slope(law, self.scene.table.zero, "c", "coefficient")) for law in self.scene.laws
                    if law.damper]
            self._damping = [*((term, term.weight) for term in self.scene.dampers), *laws]
        return self._damping

    def dissipated(self) -> "Iterator[EnergyPart]":
        """Φ of each damper."""
        found = self._dampers()
        several = len(found) > 1
        for term, c in found:
            small = self.about.small(term.s)
            rate = self.about.rate(small)
            letter = self.sheet.letter("Phi", self._of(term) if several else "")
            u = self.sheet.letter("u", self._of(term))
            first = "   (first order)" if small.bends else ""
            told = self.sheet.write(*self._across(f"speed across {term.owner}", term), Name(u + "'"), " = ", rate,
                                    Words(first), settles=u, node=rate)
            node = self.about.half_squares([(c, small)], rates=True)
            formula = c * self.about.letter(u + "'") ** 2 / 2
            shown = [] if formula.is_zero else [" = ", formula]
            line = self.sheet.write(Name(letter), *shown, " = ", node, settles=letter, node=node, uses=[told],
                                    joined=letters(rate) <= AT_ONCE)
            yield EnergyPart(letter, node, line)

    def loads(self) -> "Iterator[tuple[EnergyPart, Acting]]":
        """Each steady load by its potential −F s; loads in time are told with the equations."""
        for term in self.scene.forces:
            small, force = self.about.small(term.s), self.about.rest(term.steady)
            if force.is_zero:
                continue
            V = self._letter("V", term.owner)
            moves = self.about.first(small, self.scene.q) + self.about.bent(small)
            more = (" + …", Words(SECOND)) if small.bends else ()
            line = self.sheet.write(Words(f"potential −F·s of the steady load {term.owner}, from rest:  "), Name(V),
                                    " = ", -force * moves, *more, settles=V, node=-force * moves)
            yield EnergyPart(V, -force * moves, line), Acting(term.owner, -force, -force, None, small, line)

    def stiffness(self, acting: "list[Acting]") -> "dict[tuple[int, int], Node]":
        """K = Σ k a aᵀ + Σ N b of all that acts."""
        table, found = self.scene.table, {}
        for one in acting:
            if one.k is not None:
                for pair, node in self.about.sum_of_squares([(one.k, one.s)]).items():
                    found.setdefault(pair, []).append(node)
            for pair, b in one.s.second.items():
                found.setdefault(pair, []).append((one.kept or one.tension) * b)
        entries = {pair: self.about.tidy(table.total(nodes)) for pair, nodes in found.items()}
        return {pair: node for pair, node in entries.items() if not (node.is_zero or self.about.is_rounding(node))}

    def damping_matrix(self) -> "dict[tuple[int, int], Node]":
        """C = Σ c ∇s ∇sᵀ."""
        return self.about.sum_of_squares([(c, self.about.small(term.s)) for term, c in self._dampers()])
