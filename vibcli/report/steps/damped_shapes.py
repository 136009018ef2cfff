"""The shapes of damped modes of two and three degrees of freedom where they are asked: of two by one of the equations,

    y/x = −(λ²M₁₁ + λ(C₁₁ + G₁₁) + K₁₁)/(λ²M₁₂ + λ(C₁₂ + G₁₂) + K₁₂),   λ = −δ + iω_d,

of three as amplitudes that all of them have together; |y/x| is the ratio of the amplitudes, its angle how much y is
ahead (Rao 2011, section 6.16)."""

from cmath import phase
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_nodes import ComplexNode
from vibcli.report.steps.complex_numbers import complex_told, shape_told
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.results.problem import Problem

PARTS = "re", "im", "abs", "arg"
MOST = 3            # coordinates
CLOSE = 1e-9        # relative: of a ratio and the engine's
NOTHING = 1e-12     # of a part of a shape beside others: rounding


def tell_damped_shapes(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: "Sequence[int]") -> None:
    """Write down those that a sheet asks, or answers, of modes that oscillate."""
    problem, asked = about.problem, list(_asked(about.problem))
    for mode in problem.modal.damped or ():
        of_mode = [(text, part, i) for text, part, k, i in asked if k == mode.index]
        shape = [complex(x) for x in problem.modal.shape(mode)]
        if of_mode and complex(mode.eigenvalue).imag and abs(shape[0] - 1) <= NOTHING and len(shape) <= MOST and all(
                abs(x) > NOTHING for x in shape):
            _DampedShape(about, sheet, found, mode, shape).write(of_mode, uses)


def _asked(problem: "Problem") -> "Iterator[tuple[str, str, int, int]]":
    """(text, part, the number of the mode, the place of the coordinate) of what is asked of shapes."""
    rules, names = problem.spec.get("variants"), problem.scene.coordinates
    for one in (*(rules.ask if rules is not None else ()), *problem.spec.answers):
        tree: Any = one.asked.tree
        part, first = getattr(tree, "head", getattr(tree, "name", "")), next(iter(getattr(tree, "args", ())), None)
        if part in PARTS and isinstance(first, QuantityRef) and first.head == "mode_d":
            number, name = first.indices
            name = problem.spec.coordinate_name(name) or name
            if name in names:
                yield one.asked.text, part, int(number), names.index(name)


class _DampedShape:
    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations, mode: "DampedMode",
                 shape: "Sequence[complex]") -> None:
        self.about, self.sheet, self.found, self.k, self.shape = about, sheet, found, mode.index, shape
        self.table, self.names, self.root = about.table, about.scene.coordinates, complex(mode.eigenvalue)
        delta, omega_d = (about.letter(sheet.letter(f"{name}{self.k}")) for name in ("delta", "omega_d"))
        self.of_root = ComplexNode(-delta, omega_d)
        self.numbers = {**about.numbers(), delta.name: -self.root.real, omega_d.name: self.root.imag}

    def write(self, asked: "Sequence[tuple[str, str, int]]", uses: "Sequence[int]") -> None:
        """Write down the line of the shape, and what it settles."""
        head = [Words(f"damped mode {self.k}, of  "), "λ = " + complex_told(self.root), Words(" 1/s:  ")]
        if len(self.shape) == 2:
            known = self._of_two()
            if known is None:
                return
            shown, ratio = known
            line = self.sheet.write(*head, *shown, *self._sizes(), settles=f"mode_d[{self.k}]", uses=uses)
            ratios = [ratio, ratio]
        else:
            line = self.sheet.write(*head, *shape_told(self.names, self.shape), *self._sizes(),
                                    settles=f"mode_d[{self.k}]", uses=uses)
            ratios = self._of_three(line)
        for text, part, i in asked:
            if i:
                self._settle(text, part, i, ratios[i], line)

    def _settle(self, text: str, part: str, i: int, ratio: ComplexNode, line: int) -> None:
        """Let the last line settle a part of the ratio of a coordinate to the first."""
        node = {"re": lambda: ratio.real, "im": lambda: ratio.imaginary,
                "abs": lambda: self.table.sqrt(ratio.real ** 2 + ratio.imaginary ** 2),
                "arg": lambda: self.table.call("atan2", ratio.imaginary, ratio.real)}[part]()
        x = self.shape[i]
        value = {"re": x.real, "im": x.imag, "abs": abs(x), "arg": phase(x)}[part]
        self.sheet.write(settles=text, node=node, value=value, joined=True, uses=[line],
                         unit="rad" if part == "arg" else self._unit(i))

    def _unit(self, i: int) -> str:
        first, own = ("m" if self.about.problem.system.dimension(self.names[k]) else "rad" for k in (0, i))
        return "" if first == own else f"{own}/{first}"

    def _sizes(self) -> list[Name | str | Words]:
        """Parts of the ratios of amplitudes, and how much each is ahead."""
        parts: list[Any] = []
        for i, x in enumerate(self.shape[1:], 1):
            sense = "ahead" if x.imag > 0 else "behind"
            parts += [Words(",  "), "|", Name(self.names[i]), "/", Name(self.names[0]), "|", *number(abs(x), self._unit(
                i)), Words(",  "), Name(self.names[i]), Words(" is  "), told(abs(phase(x))), Words(f" rad {sense}")]
        return parts

    def _entry(self, i: int, j: int, root: ComplexNode) -> ComplexNode:
        """λ²Mᵢⱼ + λ(Cᵢⱼ + Gᵢⱼ) + Kᵢⱼ."""
        M, C, G, K = (part.get((i, j), self.table.zero) for part in self.found[:4])
        square, rate = root.times(root), C + G
        return ComplexNode(K + rate * root.real + M * square.real, rate * root.imaginary + M * square.imaginary)

    def _of_two(self) -> "tuple[list[Any], ComplexNode] | None":
        """(parts of y/x by a row, the ratio); None where no row gives it."""
        x, y = map(Name, self.names)
        given = ComplexNode(self.about.letter(self.sheet.letter("lambda")), self.table.zero)
        for row in range(2):
            above, below = (self._entry(row, j, self.of_root) for j in range(2))
            if all(map(is_zero, below)):
                continue
            ratio = ComplexNode(-above.real, -above.imaginary).over(below)
            found = complex(*evaluate(list(ratio), Floats, self.numbers))
            if abs(found - self.shape[1]) <= CLOSE * abs(found):
                shown = -self._entry(row, 0, given).real / self._entry(row, 1, given).real
                return [Words(f"from row {row + 1}  "), y, "/", x, " = ", shown, f" = {complex_told(found)}"], ratio
        return None

    def _of_three(self, line: int) -> list[ComplexNode]:
        """The ratios by letters, which the last line tells together: rows of the equations vanish with them."""
        letters = [ComplexNode(*(self.about.letter(self.sheet.letter(f"u{i + 1}", f"{part}{self.k}"))
                                 for part in ("re", "im"))) for i in range(1, len(self.shape))]
        ratios, zero = [ComplexNode(self.table.one, self.table.zero), *letters], self.table.zero
        largest = max(range(len(self.shape)), key=lambda i: abs(self.shape[i]))
        rows = (row for row in range(len(self.shape)) if row != largest)
        for letter, x, row in zip(letters, self.shape[1:], rows, strict=True):
            terms = [self._entry(row, j, self.of_root).times(ratio) for j, ratio in enumerate(ratios)]
            for symbol, value, left in zip(letter, (x.real, x.imag), zip(*terms, strict=True), strict=True):
                self.sheet.write(settles=symbol.name, letter=symbol.name, value=value, joined=True, uses=[line],
                                 vanishes=self.table.total([zero, *left]))
        return ratios
