"""Energies that the file writes out, to the second order about rest."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.mechanics.linearise import row_of, slopes_of
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.bodies import LONG, EnergyPart
from vibcli.report.steps.connections import SECOND, Acting
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

OF = {"T": "kinetic energy", "V": "potential energy", "Phi": "dissipation function"}


class WrittenOut:
    """What `energies:` adds to T, V and Φ."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution) -> None:
        self.about, self.sheet, self.scene = about, sheet, about.scene
        record = about.problem.spec.get("energies") or {}
        self._given = {key: self.scene.lower(record[key]) for key in OF if key in record}

    def __contains__(self, key: str) -> bool:
        return key in self._given

    def quadratic(self, key: str) -> "dict[tuple[int, int], Node]":
        """{(i, j): ∂²T/∂q̇ᵢ∂q̇ⱼ} at rest of T or Φ, empty where the file gives none."""
        if key not in self._given:
            return {}
        speeds = {v: i for i, v in enumerate(self.scene.v)}
        second = slopes_of(row_of(self._given[key], speeds), speeds)
        found = {pair: self.about.rest(node) for pair, node in second.items()}
        return {pair: node for pair, node in found.items() if not node.is_zero}

    def of_speeds(self, key: str) -> Iterator[EnergyPart]:
        """T or Φ to the second order in the speeds."""
        entries = self.quadratic(key)
        if entries:
            yield self._told(key, self.about.squared(entries, self.scene.v))

    def potential(self) -> "Iterator[tuple[EnergyPart, Acting]]":
        """V to the second order in the deviations from rest."""
        if "V" in self._given:
            small = self.about.small(self._given["V"])
            node = self.about.first(small, self.scene.q) + self.about.bent(small)
            part, one = self._told("V", node), self.scene.table.one
            yield part, Acting("V as given", one, one, None, small, part.line)

    def _told(self, key: str, node: "Node") -> EnergyPart:
        letter = self.sheet.letter(key, "given")
        given = textbook(self.about.shifted(self._given[key]) - self.about.rest(self._given[key]))
        exact = given is textbook(node)
        whole = [] if exact or letters(given) > LONG else [given, " = "]
        more = [] if exact else [" + …", Words(SECOND.partition(":")[0] + ")")]
        line = self.sheet.write(Words(f"{OF[key]} as given, from rest:  "), Name(letter), " = ", *whole, node, *more,
                                settles=letter, node=node)
        return EnergyPart(letter, node, line)
