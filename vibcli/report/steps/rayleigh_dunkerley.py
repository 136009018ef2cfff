"""The steps to bounds of the lowest natural frequency: from above by Rayleigh's quotient of the static deflection u,
from below by each inertia alone (Rao 2011, sections 7.2 and 7.3),

    K u = s M d,   ω² ≤ uᵀKu/uᵀMu,   1/ω² ≥ Σ 1/ω_j²,   1/ω_j² = tr(K⁻¹M_j) = Σ a_ik M_j,ik.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.characteristic import determinant
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

CLOSE = 1e-9        # relative: of a number by the lines and the engine's
MOST = 4            # coordinates, beyond which K is not inverted in letters
OF_LENGTHS, OF_TURNS = ("N/m", "kg"), ("N·m", "kg·m²")      # units of uᵀKu and uᵀMu
SHORT = 20          # letters of the frequency of an inertia alone that is written out


class LowestFrequency:
    """Rayleigh's and Dunkerley's bounds, on a sheet; uses: the lines that tell M and K."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, equations: SmallEquations,
                 uses: "Sequence[int]") -> None:
        self.about, self.sheet, self.M, self.K, self.uses = about, sheet, equations.M, equations.K, uses
        self.table, self.n = about.table, len(about.scene.q)
        self.found = about.problem.modal.result("estimates")

    def rayleigh(self) -> None:
        """Write down the quotient of the static deflection; nothing where it is not the engine's."""
        shape = [float(self.found.deflection[name]) for name in self.about.scene.coordinates]
        M, _, _, K = self.about.problem.configuration.linear_system.matrices()
        sizes = [sum(value * shape[i] * shape[j] for (i, j), value in matrix.items()) for matrix in (K, M)]
        if abs((sizes[0] / sizes[1]) ** 0.5 / self.found.rayleigh - 1) > CLOSE:
            return
        u = Name(self.sheet.letter("u"))
        kinds = {bool(self.about.problem.system.dimension(name)) for name in self.about.scene.coordinates}
        units = ("", "") if len(kinds) > 1 else OF_LENGTHS if True in kinds else OF_TURNS
        forms = [part for matrix, value, unit in zip("KM", sizes, units, strict=True) for part in (
            Words(",  "), u, "·", Name(self.sheet.matrix(matrix)), "·", u, *number(value, unit))]
        deflection = f" = ({', '.join(map(told, shape))})"
        line = self.sheet.write(Words("Rayleigh, with the static deflection  "), u, deflection, *forms,
                                settles="deflection", uses=self.uses)
        node = self._quotient(shape, zip(sizes, units, strict=True), line)
        self.sheet.write(Words("the root of their quotient:  "), "ω = " + told(self.found.rayleigh), Words(
            " rad/s   (an upper bound)"), settles="rayleigh", node=node, value=float(self.found.rayleigh), unit="rad/s",
            uses=[line])

    def _quotient(self, shape: list[float], sizes: Iterator[Any], line: int) -> "Node | None":
        """√(uᵀKu/uᵀMu) by letters of what the line tells; None where a part of the deflection is zero."""
        if not all(shape):
            return None
        u = [self._letter(f"u{i + 1}") for i in range(self.n)]
        self._deflection(shape, u, line)
        found = [self._letter(f"u{matrix}u") for matrix in "KM"]
        for letter, matrix, (value, unit) in zip(found, (self.K, self.M), sizes, strict=True):
            node = self.table.total([entry * u[i] * u[j] for (i, j), entry in matrix.items()])
            self.sheet.write(settles=letter.name, letter=letter.name, node=node, value=value, unit=unit, joined=True)
        return self.table.sqrt(found[0] / found[1])

    def _deflection(self, shape: list[float], u: "Sequence[Node]", line: int) -> None:
        """The parts of the deflection, found together with s from K u = s M d."""
        d, zero = self._pulled(), self.table.zero
        s, rows = self._letter("s"), range(self.n)
        largest = max(rows, key=lambda i: abs(shape[i]))
        left = [self.table.total([self.K[i, j] * (self.table.one if j == largest else u[j]) for j in rows
                                  if (i, j) in self.K] or [zero])
                - s * self.table.total([self.M[i, j] for j in d if (i, j) in self.M] or [zero]) for i in rows]
        scale = self._scale(shape, d)
        self.sheet.write(settles=u[largest].name, letter=u[largest].name, node=self.table.one, value=1.0, joined=True)
        for i in rows:
            letter, value = (s, scale) if i == largest else (u[i], shape[i])
            self.sheet.write(settles=letter.name, letter=letter.name, value=value, vanishes=left[i], joined=True)

    def _pulled(self) -> list[int]:
        """The coordinates that are pulled by their inertia: those that measure what the first one with inertia does."""
        kinds = [self.about.problem.system.dimension(name) for name in self.about.scene.coordinates]
        first = next(i for i in range(self.n) if (i, i) in self.M)
        return [i for i in range(self.n) if kinds[i] == kinds[first]]

    def _scale(self, shape: Sequence[float], d: Sequence[int]) -> float:
        """s, by uᵀKu = s uᵀMd."""
        M, _, _, K = self.about.problem.configuration.linear_system.matrices()
        below = sum(value * shape[i] for (i, j), value in M.items() if j in d)
        return cast("float", sum(value * shape[i] * shape[j] for (i, j), value in K.items()) / below)

    def dunkerley(self) -> None:
        """Write down the frequencies with each inertia alone, and their sum; nothing where it is not the engine's."""
        alone = {name: float(omega) for name, omega in self.found.alone.items()}
        if len(alone) < 2 or abs(sum(omega ** -2 for omega in alone.values()) * self.found.dunkerley ** 2 - 1) > CLOSE:
            return
        nodes, symbols = self._of_each(alone), []
        for i, (name, omega) in enumerate(alone.items()):
            letter, node = self._letter("omega", name), nodes.get(name)
            shown = [] if node is None or letters(node) > SHORT else [" = ", node]
            head = [] if i else [Words("Dunkerley, each inertia alone:  ")]
            line = self.sheet.write(*head, letter, *shown, *number(omega, "rad/s"), settles=f"omega_alone[{name}]",
                                    value=omega, unit="rad/s", letter=letter.name, joined=i > 0, uses=self.uses,
                                    node=node)
            symbols.append(letter)
        self.sheet.write("1/ω² = ", Words("the sum of "), "1/ω_j²", Words(",  "), "ω = " + told(self.found.dunkerley),
                         Words(" rad/s   (a lower bound)"), settles="dunkerley", unit="rad/s", uses=[line],
                         value=float(self.found.dunkerley),
                         node=1 / self.table.sqrt(self.table.total([letter ** -2 for letter in symbols])))

    def _letter(self, wanted: str, of: str = "") -> "Node":
        return self.table.parameter(self.sheet.letter(wanted, of), positive=False)

    def _of_each(self, alone: "Mapping[str, float]") -> "dict[str, Node]":
        """{body: ω with its inertia alone} in letters, as far as they are the engine's."""
        if self.n > MOST:
            return {}
        K, whole = self._rows(), determinant(self._rows())
        found = {}
        for name, matrix in self._inertias().items():
            above = self.table.total([node * self._minor(K, i, j) * (-1) ** (i + j)
                                      for (i, j), node in matrix.items()] or [self.table.zero])
            node = self.table.zero if above.is_zero else root(self.about.tidy(whole / above), self.about.samples)
            value = self.about.value(node)
            if name in alone and value and abs(value / alone[name] - 1) <= CLOSE:
                found[name] = node
        return found

    def _rows(self) -> "list[list[Node]]":
        return [[self.K.get((i, j), self.table.zero) for j in range(self.n)] for i in range(self.n)]

    def _minor(self, K: "Sequence[list[Node]]", i: int, j: int) -> "Node":
        rows = [[entry for k, entry in enumerate(row) if k != j] for m, row in enumerate(K) if m != i]
        return determinant(rows) if rows else self.table.one

    def _inertias(self) -> "dict[str, Any]":
        """{body: its part of M} about rest."""
        terms: dict[str, list[Any]] = {}
        for term in self.about.scene.vibrating.inertias:
            terms.setdefault(term.owner, []).append((term.weight, self.about.small(term.s)))
        return {name: self.about.sum_of_squares(parts) for name, parts in terms.items()}
