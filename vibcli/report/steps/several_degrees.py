"""The steps from the equations of several degrees of freedom to their frequencies and modes: M, C, G, K, the
determinant of K − ω²M written out of two, ratios of amplitudes, damped eigenvalues."""

from collections.abc import Mapping
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.notation.plain import lowered
from vibcli.report.blocks import Either, Name, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.small_oscillations import SmallEquations
from vibcli.report.steps.step import WorkedSolution, told

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MARK = "𝔇"              # stands under the root while the rest is written
MATRICES = ("mass matrix", "M"), ("damping matrix", "C"), ("gyroscopic matrix", "G"), ("stiffness matrix", "K")


class SeveralDegrees:
    """The steps of M q̈ + (C + G) q̇ + K q = Q."""

    def __init__(self, problem: "Problem", about: AboutRest, sheet: WorkedSolution, found: SmallEquations):
        self.problem, self.about, self.sheet, self.found = problem, about, sheet, found
        self.n, self.numbers = len(problem.scene.q), not problem.numeric.has_free_symbols

    def write(self) -> None:
        """Write down all of them."""
        lines = [self._matrix(words, letter, getattr(self.found, letter)) for words, letter in MATRICES
                 if getattr(self.found, letter)]
        if self.n == 2 and not self.found.G:
            lines.append(self._determinant(lines))
        if self.numbers:
            self._modes(lines)
            self._damped(lines)

    def _matrix(self, words, letter, entries: "Mapping[tuple[int, int], Node]"):
        parts: list[Any] = []
        skew = letter == "G"
        for (i, j), node in sorted(entries.items()):
            twins = letter == "G" or self.about.same(node, entries.get((j, i), self.about.table.zero))
            if j < i and twins:
                continue
            twin = "" if i == j or not twins else f" = {'−' * skew}{letter}{lowered(j + 1)}{lowered(i + 1)}"
            parts += [Words(",  ")] * bool(parts) + [f"{letter}{lowered(i + 1)}{lowered(j + 1)}{twin} = ", node]
        return self.sheet.write(Words(f"{words}:  "), *parts, settles=letter, uses=self.found.lines)

    def _determinant(self, uses):
        """det(K − ω²M) = a₂ ω⁴ − a₁ ω² + a₀ = 0."""
        table, (M, K) = self.about.table, (self.found.M, self.found.K)

        def entry(part, i, j):
            return part.get((i, j), table.zero)

        coefficients = [
            entry(M, 0, 0) * entry(M, 1, 1) - entry(M, 0, 1) * entry(M, 1, 0),
            entry(M, 0, 0) * entry(K, 1, 1) + entry(M, 1, 1) * entry(K, 0, 0)
            - entry(M, 0, 1) * entry(K, 1, 0) - entry(M, 1, 0) * entry(K, 0, 1),
            entry(K, 0, 0) * entry(K, 1, 1) - entry(K, 0, 1) * entry(K, 1, 0)]
        names = [self.sheet.letter(f"a{power}") for power in (2, 1, 0)]
        a2, a1, a0 = map(self.about.letter, names)
        omega = self.about.letter(self.sheet.letter("omega"))
        mark = table.sqrt(table.parameter(MARK, positive=False))
        parts: list[Any] = []
        for name, node in zip(names, map(self.about.tidy, coefficients), strict=True):
            value = self.about.value(node)
            parts += [Words(",  "), Name(name), " = ", node, *(() if value is None or node.op == "number" else (
                " = " + told(value),))]
        roots = Either((a1 + mark) / (2 * a2), mark, table.sqrt(a1 * a1 - 4 * a0 * a2))
        polynomial = a2 * omega ** 4 - a1 * omega ** 2 + a0
        return self.sheet.write("det(K − ", omega ** 2, "·M) = ", polynomial, " = 0", *parts, Words(",  "), omega ** 2,
                                " = ", roots, settles="det(K - omega^2*M)", uses=uses)

    def _modes(self, uses):
        """Each frequency with the ratio of its amplitudes."""
        names, modal = self.problem.scene.coordinates, self.problem.modal
        for mode in modal.modes:
            shape = modal.shape(mode)
            ratio = [*[part for name in names for part in (" : ", Name(name))][1:],
                     " = " + " : ".join(told(float(x.real)) for x in shape)]
            if mode.omega is None:
                self.sheet.write(Words(f"mode {mode.index} grows as exp(s·t) with "), "s = " + told(mode.growth_rate),
                                 Words(" 1/s,  "), *ratio, settles=f"growth_rate[{mode.index}]",
                                 value=float(mode.growth_rate), unit="1/s", uses=uses)
                continue
            times = [Words(",  "), "f = " + told(mode.omega / tau), Words(" Hz,  "), "T = " + told(tau / mode.omega),
                     Words(" s,  ")] if mode.omega else [Words(":  it moves freely,  ")]
            self.sheet.write(f"ω{lowered(mode.index)} = {told(mode.omega)}", Words(" rad/s"), *times, *ratio,
                             settles=f"omega[{mode.index}]", value=float(mode.omega), unit="rad/s", uses=uses)

    def _damped(self, uses):
        """The eigenvalues of det(λ² M + λ (C + G) + K) = 0."""
        damped = self.problem.modal.damped
        if damped is None:
            return
        head = ["det(λ²·M + λ·C + K) = 0" if not self.found.G else "det(λ²·M + λ·(C + G) + K) = 0",
                Words(" has the roots")]
        if not proportional(self.problem.spec):
            head = [Words("`damping:` adds what damps each mode by itself:  "), "λ = −ζ·ω ± ω·√(1 − ζ²)·i"]
        line = self.sheet.write(*head, settles="det(lambda^2*M + lambda*C + K)", uses=uses)
        for mode in damped:
            value, parts = complex(mode.eigenvalue), []
            if value.imag:
                parts = [f" ± {told(abs(value.imag))}·i", Words(" 1/s,  "), f"ζ = {told(float(mode.zeta))}"]
            self.sheet.write(f"λ = {told(value.real)}", *(parts or [Words(" 1/s")]), uses=[line],
                             settles=f"eigenvalue[{mode.index}]")
