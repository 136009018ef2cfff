"""One degree of freedom about rest, m q̈ + c q̇ + k q = Q, and how its lines are written."""

import re
from collections.abc import Iterable
from math import degrees
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure
from vibcli.report.blocks import WithNumbers
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


DEGREES = re.compile(r"^[\d.\s]+deg$")


class Degree:
    """M, C, K of the only coordinate, and the letters ω, δ, ζ, ω_d on a sheet."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
        self.problem, self.about, self.sheet, self.found = about.problem, about, sheet, found
        zero = about.table.zero
        self.M, self.C, self.K = (part.get((0, 0), zero) for part in (found.M, found.C, found.K))
        self.omega, self.delta, self.zeta, self.omega_d = (
            about.letter(sheet.letter(name)) for name in ("omega", "delta", "zeta", "omega_d"))
        self.name, = about.scene.coordinates
        self.unit = "m" if self.problem.system.dimension(self.name) else "rad"

    def root(self, node: "Node") -> "Node":
        """√ of an expression, in its simplest form."""
        return root(node, self.about.samples)

    def settled(self, head: Iterable[Any], node: "Node", unit: str, settles: str, uses: Iterable[int | None],
                letters: bool = True, more: Iterable[Any] = (), joined: bool = False) -> int:
        """A line `head = expression = with numbers = value`, and `more`, or joined to the last one; its number."""
        value, numbers, head = self.about.known_value(node), self.about.numbers(), list(head)
        letter = next((part.name for part in (head[-1], head[0]) if getattr(part, "op", "") == "symbol"), "")
        parts: list[Any] = [*head, *([" = ", node] if letters or value is None else [])]
        if value is not None:
            put_in = {name: self._as_given(name, x) for name, x in numbers.items()}
            parts += [" = ", WithNumbers(node, put_in), *number(value, unit)]
        return self.sheet.write(*parts, *more, settles=settles, node=node, value=value, unit=unit, uses=list(uses),
                                joined=joined, letter=letter)

    def _as_given(self, name: str, x: float) -> str:
        """A number to put in: of an angle that the file gives in degrees these, with its sign in brackets."""
        record = self.problem.spec.parameters.get(name, {})
        given = record["value"].text if "value" in record else ""
        text = f"{figure(degrees(x))}°" if DEGREES.search(given) else figure(x)
        return f"({text})".replace("-", "−") if x < 0 else text
