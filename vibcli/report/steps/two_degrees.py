"""The steps from M and K of two degrees of freedom to their natural frequencies, ratios of amplitudes and normal
coordinates: det(K − ω²M) = a₂ ω⁴ − a₁ ω² + a₀ = 0 written out, and what follows from its roots."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.notation.plain import plain
from vibcli.report.blocks import Either, Factor, Name, Words
from vibcli.report.steps.characteristic import tell_polynomial, tell_roots
from vibcli.report.steps.from_modes_in_letters import tell_in_letters
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import HALF, fraction_of

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

MARK = "𝔇"              # stands under the root while the rest is written
CLOSE = 1e-8            # relative: of a frequency by its formula and the engine's
NOTHING = 1e-9          # of a ratio of amplitudes: it is zero but for rounding


class TwoDegrees:
    """M q̈ + G q̇ + K q = 0 of two coordinates."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
        self.about, self.sheet, self.found, self.table = about, sheet, found, about.table
        self.names = about.scene.coordinates
        for power in (2, 1, 0):         # before ω, so that they stand before its powers
            about.letter(sheet.letter(f"a{power}"))
        self.omega = about.letter(sheet.letter("omega"))
        self._told: tuple[Any, ...] | None = None         # what modes in letters have, and the lines that tell them
        self.row = self._first([i for i in range(2) if not self._stiffened(i, 1).is_zero])

    def _first(self, rows: Sequence[int]) -> int:
        """The first of these rows, before those that rigid motions fulfil whatever their shape."""
        return next((i for i in rows if (i, 0) in self.found.K or (i, 1) in self.found.K), next(iter(rows), None))

    def fits(self, shapes: list[list[float]], omegas: list[float]) -> bool:
        """Is there a row that gives the ratio of all shapes? It is the one that is told."""
        for i in range(2):
            below, above = self._stiffened(i, 1), self._stiffened(i, 0)
            found = [[self.about.value(substitute([node], {self.omega: self.table.number(fraction_of(omega))})[0])
                      for node in (above, below)] for omega in omegas]
            if all(y and abs(x + u[1] * y) <= CLOSE * (abs(x) + abs(u[1] * y) + NOTHING * abs(y))
                   for (x, y), u in zip(found, shapes, strict=True)):
                self.row = i
                return True
        return False

    def entry(self, letter: str, i: int, j: int) -> "Node":
        return cast("Node", getattr(self.found, letter).get((i, j), self.table.zero))

    def determinant(self, uses: list[int]) -> list[int]:
        """Write down det(K − ω²M) = 0, its coefficients, and the formula of its roots; the numbers of the lines."""
        self.letters, self.coefficients, lines = tell_polynomial(self.about, self.sheet, self.found, uses)
        (a2, a1, a0), omega = self.letters, self.omega
        if self.coefficients[0].is_zero:
            return [*lines, self.sheet.write(omega ** 2, " = ", a0 / a1, settles="omega^2", node=a0 / a1, uses=lines)]
        if self.coefficients[2].is_zero:
            values = [self.about.value(node) for node in self.coefficients[:2]]
            put_in = [] if None in values else [f" = {told(values[1])}/{told(values[0])}"]
            return [*lines, self.sheet.write(omega ** 2, " = 0", Words("  or  "), omega ** 2, " = ", a1 / a2, *put_in,
                                             settles="omega^2", node=a1 / a2, uses=lines)]
        mark = self.table.sqrt(self.table.parameter(MARK, positive=False))
        roots = Either((a1 + mark) / (2 * a2), mark, self.table.sqrt(a1 * a1 - 4 * a0 * a2))
        return [*lines, self.sheet.write(omega ** 2, " = ", roots, *self._put_in(), settles="omega^2", uses=lines)]

    def _put_in(self) -> list[str]:
        """The numbers of the formula of the roots, its square root drawn; nothing of letters, nor of complex ones."""
        values = [self.about.value(node) for node in self.coefficients]
        if None in values or values[1]**2 < 4 * values[0] * values[2]:
            return []
        a2, a1, a0 = values
        return [f" = ({told(a1)} ∓ {told((a1 * a1 - 4 * a0 * a2)**0.5)})/{told(2 * a2)}"]

    def frequency(self, index: int, omega: float) -> "Node | None":
        """ω of the mode of this number by the coefficients; None where that is not the engine's."""
        a2, a1, a0 = self.letters
        sign = -1 if index == 1 else 1
        found = [self.about.value(node) for node in self.coefficients]
        if None in found or not found[0]:
            return None
        square = (found[1] + sign * (found[1]**2 - 4 * found[2] * found[0])**0.5) / (2 * found[0])
        alike = isinstance(square, float) and abs(square - omega**2) <= CLOSE * abs(found[1] / found[0])
        return self.table.sqrt((a1 + sign * self.table.sqrt(a1 * a1 - 4 * a0 * a2)) / (2 * a2)) if alike else None

    def in_letters(self, uses: list[int]) -> None:
        """Write down the roots where their square root is none, else those of closed form, and the ratios."""
        found = self._squares()
        lines = [self._root_in_letters(k, node, uses) for k, node in enumerate(found, 1)]
        if self._apart() and (alone := self._alone(found)):
            self._told = alone, [*uses, *lines]
            return
        coupled = not (self.found.G or self.row is None or self._stiffened(self.row, 0).is_zero)
        ratio = self.ratio([*uses, *lines]) if coupled else None
        if not found:
            tell_roots(self.about, self.sheet, self.found, uses)
        if not coupled:
            return
        if not found and ratio is not None:
            self._told = self._lettered(ratio)
        shapes = []
        for k, node in enumerate(found, 1):
            x, y = map(Name, self.names)
            above, below = (self.about.tidy(found) for found in substitute(
                [self._stiffened(self.row, j) for j in range(2)], {self.omega: self.table.sqrt(node)}))
            if below.is_zero and not above.is_zero:
                self.sheet.write(Words(f"in mode {k}, by that row,  "), x, " = 0", uses=[ratio, lines[k - 1]],
                                 settles=f"mode[{k}][{self.names[0]}]", node=self.table.zero)
            if not below.is_zero:
                shape = self._quotient(-above, below)
                shapes.append((node, (self.table.one, shape)))
                last = self.sheet.write(Words(f"in mode {k}  "), y, "/", x, " = ", shape, node=shape, uses=[
                    ratio, lines[k - 1]], settles=f"mode[{k}][{self.names[1]}]")
        if len(shapes) == 2:
            self._told = shapes, [*lines, last]

    def _lettered(self, ratio: int) -> "tuple[list[tuple[Node, tuple[Node, Node]]], list[int]] | None":
        """Modes whose frequencies and ratios have letters, told where the file starts a motion that nothing damps."""
        if self.found.C or self.found.drive or self.about.problem.spec.get("initial") is None:
            return None
        a2, a1, a0 = self.coefficients
        known = [self.table.sqrt((a1 + sign * self.table.sqrt(a1 * a1 - 4 * a0 * a2)) / (2 * a2)) for sign in (-1, 1)]
        letters, modes = [], []
        told: list[Any] = [Words("with the ratios  ")]
        for k, node in enumerate(known, 1):
            omega, r = (self.about.letter(self.sheet.letter(f"{letter}{k}")) for letter in ("omega", "r"))
            letters += [(omega, node), (r, self.shape_at(k))]
            modes.append((omega ** 2, (self.table.one, r)))
            told += [Words(",  " * (k > 1)), r, " = ", self.shape_at(k)]
        line = self.sheet.write(*told, settles="ratios of amplitudes", uses=[ratio])
        for letter, node in letters:
            self.sheet.write(settles=letter.name, node=node, joined=True, letter=letter.name)
            for values in self.about.samples:
                values[letter.name], = evaluate([node], Floats, values)
        return modes, [ratio, line]

    def motion_in_letters(self) -> None:
        """Write down the free motion from the start that the file gives, by modes that were told in letters."""
        if self._told is not None:
            tell_in_letters(self.about, self.sheet, self.found, *self._told)

    def _apart(self) -> bool:
        """Does no equation have both coordinates, but perhaps by damping?"""
        return not (self.found.G or any(i != j for matrix in (self.found.M, self.found.K) for i, j in matrix))

    def _alone(self, squares: "Sequence[Node]") -> "list[tuple[Node, tuple[Node, Node]]]":
        """[(ω², the shape)] of modes in which one coordinate moves; none where the letters leave open which."""
        shapes = (self.table.one, self.table.zero), (self.table.zero, self.table.one)
        of = [[i for i in range(2) if is_zero(node * self.entry("M", i, i) - self.entry("K", i, i))]
              for node in squares]
        return [(node, shapes[i]) for node, (i,) in zip(squares, of, strict=True)] if of in ([[0], [1]], [
            [1], [0]]) else []

    def _quotient(self, above: "Node", below: "Node") -> "Node":
        """above/below, without a root of a number below where it is shorter so."""
        plainly = self.about.tidy(above / below)
        roots = {part for part in reachable([below]) if part.op == "product" and [
            (base.op, e) for base, e in part.args] == [("number", HALF)]}
        if len(roots) != 1:
            return plainly
        turned, = substitute([below], {(root := roots.pop()): -root})
        found = self.about.tidy(textbook(above * turned) / textbook(below * turned))
        return min((plainly, found), key=lambda node: len(plain(node)))

    def _root_in_letters(self, k: int, node: "Node", uses: list[int]) -> int:
        omega, letter = root(node, self.about.samples), self.about.letter(self.sheet.letter(f"omega{k}"))
        return self.sheet.write(letter ** 2, " = ", node, Words(",  "), letter, " = ", omega, node=omega,
                                settles=f"omega[{k}]", uses=uses, letter=letter.name)

    def _squares(self) -> "list[Node]":
        """[ω₁², ω₂²] where the square root of their formula comes out; else none."""
        a2, a1, a0 = self.coefficients
        if a2.is_zero:
            return []
        if a0.is_zero:
            return [self.table.zero, self.about.tidy(a1 / a2)]
        discriminant = self.about.tidy(a1 * a1 - 4 * a0 * a2)
        spread = root(discriminant, self.about.samples)
        if any(e.denominator > 1 and base.op != "number" for part in reachable([spread]) if part.op == "product"
               for base, e in part.args):
            return []
        found = [self.about.tidy((a1 + sign * spread) / (2 * a2)) for sign in (-1, 1)]
        values = [evaluate(found, Floats, values) for values in self.about.samples]
        order = [low <= high for low, high in values]
        return [] if len(set(order)) > 1 else found if order[0] else found[::-1]

    def ratio(self, uses: list[int]) -> int:
        """Write down the ratio of amplitudes from the first equation that couples them."""
        x, y = map(Name, self.names)
        shape = -self._stiffened(self.row, 0) / self._stiffened(self.row, 1)
        shorter = single(shape)
        self.shape = shorter if 4 * letters(shorter) <= 3 * letters(shape) else shape
        return self.sheet.write(Words(f"from row {self.row + 1} the ratio of amplitudes  "), y, "/", x, " = ",
                                self.shape, settles=f"{self.names[1]}/{self.names[0]}", node=self.shape, uses=uses)

    def shape_at(self, k: int) -> "Node":
        """The ratio with the letter of the frequency of a mode."""
        return substitute([self.shape], {self.omega: self.about.letter(self.sheet.letter(f"omega{k}"))})[0]

    def _stiffened(self, i: int, j: int) -> "Node":
        return self.entry("K", i, j) - self.omega ** 2 * self.entry("M", i, j)

    def normal_coordinates(self, shapes: list[list[float]], uses: list[int]) -> None:
        """Write down the modal masses and the normal coordinates p; `shapes`: of each mode, the first coordinate 1."""
        letters = [self.sheet.letter(f"p{k + 1}") for k in range(2)]
        unit = "kg" if self.about.problem.system.dimension(self.names[0]) else "kg·m²"
        lines = [self._modal_mass(k, shape, unit, uses) for k, shape in enumerate(shapes, 1)]
        told: list[Any] = []
        for i, name in enumerate(self.names):
            terms = [(u[i], letter) for u, letter in zip(shapes, letters, strict=True) if abs(u[i]) > NOTHING]
            told += [Words(",  " * bool(told)), Name(name), " = ", *_sum(terms, self._unit * bool(i))]
        self.sheet.write(Words("normal coordinates:  "), *told, settles="normal coordinates", uses=lines)

    @property
    def _unit(self) -> str:
        """That of a ratio of amplitudes, '' where both are of one kind."""
        first, second = ("m" if self.about.problem.system.dimension(name) else "rad" for name in self.names)
        return "" if first == second else f"\u00a0{second}/{first}"

    def _modal_mass(self, k: int, u: Sequence[float], unit: str, uses: list[int]) -> int:
        """Σ Mᵢⱼ uᵢ uⱼ."""
        pairs = [(i, j) for i in range(2) for j in range(i, 2)
                 if (i, j) in self.found.M and min(abs(u[i]), abs(u[j])) > NOTHING]
        entries = [self.entry("M", i, j) * (1 if i == j else 2) for i, j in pairs]
        value = sum((self.about.value(node) or 0.0) * u[i] * u[j] for node, (i, j) in zip(entries, pairs, strict=True))
        terms = [part for node, (i, j) in zip(entries, pairs, strict=True)
                 for part in (" + ", *_weighted(node, u[i] * u[j] if i != j else u[i], i == j, self._unit * bool(j)))]
        return self.sheet.write(Words(f"modal mass of mode {k}:  "), *terms[1:], *number(value, unit),
                                settles=f"modal_mass[{k}]", value=value, unit=unit, uses=uses)


def _weighted(node: "Node", value: float, squared: bool, unit: str) -> list[Any]:
    """Parts of node·value, or node·value², the value having a unit; of the node alone where that is 1."""
    text = told(value)
    if value == 1 and not unit:
        return [node]
    if unit:
        return ["(" + text, Words(unit), ")" + "²" * squared + "·", Factor(node)]
    bracketed = f"({text})" if value < 0 or "e" in text else text
    return [bracketed + "²" * squared + "·", Factor(node)]


def _sum(terms: Sequence[tuple[float, str]], unit: str) -> list[Name | str]:
    """Parts of Σ value·letter, the values having a unit."""
    parts: list[Any] = []
    for value, letter in terms:
        sign = (" − " if value < 0 else " + ") if parts else "−" if value < 0 else ""
        text = told(abs(value))
        size = ["(" + text, Words(unit), ")·"] if unit else [] if abs(value) == 1 else [text + "·"]
        parts += [*([sign] if sign else []), *size, Name(letter)]
    return parts
