"""Bodies that a frame carries which turns steadily: T = T₂ + T₁ + T₀ by powers of the speeds within it.

T₂ gives M. T₁ = Σ pᵢ(q) q̇ᵢ gives the gyroscopic Gᵢⱼ = ∂pᵢ/∂qⱼ − ∂pⱼ/∂qᵢ, and −T₀(q) acts like a potential: the
centrifugal forces.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.bodies import LONG, EnergyPart
from vibcli.report.steps.connections import SECOND, STRAIGHT, Acting
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


class _Carried(NamedTuple):
    """What a frame carries: its name, T whole, by the speeds [pᵢ], T₀."""

    name: str
    T: Any
    momenta: Any
    T0: Any


class TurningFrames:
    """What the bodies that turning frames carry add to G and to V; nothing where no frame turns."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution) -> None:
        self.about, self.sheet, self.scene = about, sheet, about.scene
        self._carried = list(self._found())

    def _found(self) -> Iterator[_Carried]:
        scene, rest = self.scene, dict.fromkeys(self.scene.v, self.scene.table.zero)
        driven = dict.fromkeys(term.owner for term in scene.inertias if scene.time in gradient(term.s))
        for name in driven:
            T = textbook(scene.table.total([term.energy(scene) for term in scene.inertias if term.owner == name]))
            slopes = [gradient(T).get(v, scene.table.zero) for v in scene.v]
            *momenta, T0 = substitute([*slopes, T], rest)
            if not T.mask & scene.time.mask:
                yield _Carried(name, T, momenta, T0)

    @property
    def names(self) -> set[str]:
        """Of the bodies."""
        return {body.name for body in self._carried}

    def kinetic(self) -> Iterator[EnergyPart]:
        """T₂ of each to the second order, beside T whole where it is short."""
        for body in self._carried:
            terms = [(term.weight, self.about.small(term.s)) for term in self.scene.inertias if term.owner == body.name]
            node, letter = self.about.squared(self.about.sum_of_squares(terms), self.scene.v), self._letter("T2", body)
            whole = [Name(self._letter("T", body)), " = ", body.T, Words(",  ")] if letters(body.T) <= LONG else []
            if not node.is_zero:
                line = self.sheet.write(Words(f"{body.name} in the frame that turns:  "), *whole, Words(
                    "of it with squares of speeds  "), Name(letter), " = ", node, settles=letter, node=node)
                yield EnergyPart(letter, node, line)

    def _letter(self, letter: str, body: Any) -> str:
        return self.sheet.letter(letter, body.name)

    def potential(self) -> "Iterator[tuple[EnergyPart, Acting]]":
        """−T₀ of each to the second order from rest."""
        one = self.scene.table.one
        for body in self._carried:
            small, V = self.about.small(-body.T0), self._letter("V0", body)
            node = self.about.first(small, self.scene.q) + self.about.bent(small)
            if not node.is_zero:
                whole = textbook(-body.T0)
                told = [whole, Words(",  from rest  "), Name(V), " = "] if letters(whole) <= LONG else []
                more = [" + …", Words(SECOND if small.bends else STRAIGHT)]
                if plain(whole) == plain(textbook(node)):
                    told, more = [], []
                line = self.sheet.write(Words(f"of T of {body.name} what has no speeds acts like a potential:  "),
                                        Name(V), " = ", *told, node, *more, settles=V, node=node)
                yield EnergyPart(V, node, line), Acting(body.name, one, one, None, small, line)

    def gyroscopic(self) -> "dict[tuple[int, int], Node]":
        """G = ∂pᵢ/∂qⱼ − ∂pⱼ/∂qᵢ at rest."""
        q, zero, found = self.scene.q, self.scene.table.zero, {}
        for i in range(len(q)):
            for j in range(len(q)):
                node = self.about.tidy(self.about.rest(self.scene.table.total(
                    [gradient(body.momenta[i]).get(q[j], zero) - gradient(body.momenta[j]).get(q[i], zero)
                     for body in self._carried])))
                if not node.is_zero:
                    found[i, j] = node
        return found
