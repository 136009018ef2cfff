"""The steps from the equations of several degrees of freedom to their frequencies and modes: M, C, G, K, the
determinant of K − ω²M written out of two, ratios of amplitudes, damped eigenvalues, amplitudes under one harmonic."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.assumed_shapes import tell_estimates
from vibcli.report.steps.characteristic import polynomial, tell_polynomial, tell_roots
from vibcli.report.steps.damped_degrees import stay_apart, tell_damped
from vibcli.report.steps.from_start import tell_from_start
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.loads_that_swing import tell_loads
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, of_time, told
from vibcli.report.steps.told_matrices import tell_matrices
from vibcli.report.steps.two_degrees import NOTHING, TwoDegrees

if TYPE_CHECKING:
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.symbolic.node import Node


class SeveralDegrees:
    """The steps of M q̈ + (C + G) q̇ + K q = Q."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
        self.about, self.sheet, self.found, self.problem = about, sheet, found, about.problem
        self._free = not (found.K or found.G)
        two = len(about.scene.q) == 2 and not (self._free or (found.G and found.C)
                                               or about.problem.symbolic.configuration.falls)
        self.two = TwoDegrees(about, sheet, found) if two else None

    def write(self) -> None:
        """Write down all of them."""
        matrices = tell_matrices(self.about, self.sheet, self.found)
        lines = list(matrices)
        self._letters: list[Node] = []
        if self.two is not None:
            lines += self.two.determinant(lines)
            self._letters = self.two.letters
        elif self._free:
            of_M = Name(self.sheet.matrix("M"))
            lines.append(self.sheet.write(Words("nothing is stiff:  "), "det(ω²·", of_M, ") = 0", Words("  for  "),
                                          "ω = 0", Words(" alone"), settles="det(omega^2*M)", uses=lines))
        elif len(self.about.scene.q) == 3 and not self.found.G:
            self._letters, _, told_in = tell_polynomial(self.about, self.sheet, self.found, lines)
            lines += told_in
        if not self.problem.numeric.has_free_symbols:
            self._modes(lines)
        elif self.two is not None:
            self.two.in_letters(lines)
        else:
            tell_roots(self.about, self.sheet, self.found, lines)
        tell_estimates(self.about, self.sheet, self.found, matrices)
        tell_damped(self.about, self.sheet, self.found, matrices)
        if self.two is not None:
            self.two.motion_in_letters()
        tell_from_start(self.about, self.sheet, self.found, lines)
        tell_loads(self.about, self.sheet, self.found)

    def _modes(self, uses: list[int]) -> None:
        """Each frequency, and the ratio of its amplitudes."""
        modal = self.problem.modal
        found = [(mode, [complex(x) for x in modal.shape(mode)]) for mode in modal.modes]
        self._by_ratio = self._has_ratio(found)
        lines = [self._frequency(mode, shape, uses) for mode, shape in found]
        if not self._by_ratio:
            return
        ratio = self.two.ratio(uses)
        shapes = [[x.real for x in shape] for _, shape in found]
        of = [self._amplitude_ratio(k, shape, [ratio, line]) for k, (shape, line) in enumerate(
            zip(shapes, lines, strict=True), 1)]
        if not self.found.C or stay_apart(self.about, self.found):
            self.two.normal_coordinates(shapes, of)

    @property
    def _mixed(self) -> str:
        """Words on the units of amplitudes that are not of one kind."""
        kinds = {bool(self.problem.system.dimension(name)) for name in self.about.scene.coordinates}
        return "  (in m and rad)" if len(kinds) > 1 else ""

    def _has_ratio(self, found: "Sequence[tuple[Mode, list[complex]]]") -> bool:
        """Do two coordinates have a ratio of amplitudes that a row gives in both modes?"""
        if self.two is None or self.found.G or len(found) != 2 or any(
                mode.omega is None or shape[0] != 1 or shape[1].imag for mode, shape in found):
            return False
        return self.two.fits([[x.real for x in shape] for _, shape in found], [float(mode.omega) for mode, _ in found])

    def _amplitude_ratio(self, k: int, shape: Sequence[float], uses: list[int]) -> int:
        names = self.about.scene.coordinates
        (x, of_x), (y, of_y) = ((Name(name), "m" if self.problem.system.dimension(name) else "rad") for name in names)
        unit = f"{of_y}/{of_x}" if of_x != of_y else ""
        return self.sheet.write(Words(f"in mode {k}  "), y, "/", x, *number(shape[1], unit), value=shape[1], unit=unit,
                                uses=uses, node=self.two.shape_at(k), settles=f"mode[{k}][{names[1]}]")

    def _frequency(self, mode: "Mode", shape: list[complex], uses: list[int]) -> int:
        """The line of a mode: with two degrees by the formula of the roots, else with the ratios."""
        names = self.about.scene.coordinates
        size = max(map(abs, shape))
        amplitudes = " : ".join(_complex(0j if abs(x) <= NOTHING * size else x) for x in shape)
        ratio = [*[part for name in names for part in (" : ", Name(name))][1:], " = " + amplitudes]
        if mode.omega is None:
            return self.sheet.write(Words(f"mode {mode.index} grows as exp(s·t) with "), "s = " + told(
                mode.growth_rate), Words(" 1/s,  "), *ratio, Words(self._mixed), settles=f"growth_rate[{mode.index}]",
                value=float(mode.growth_rate), unit="1/s", uses=uses)
        omega = float(mode.omega)
        times = of_time(self.sheet, omega) if omega else [Words(":  it moves freely")]
        if not self._by_ratio:
            times += [Words(",  "), *ratio, Words(self._mixed)]
        node = self.two.frequency(mode.index, omega) if self.two is not None else None
        letter = self.about.letter(self.sheet.letter(f"omega{mode.index}"))
        last, ratios = self._ratios(mode.index, shape, letter) if omega else (None, [])
        vanishes = polynomial(self._letters, letter) if self._letters else last
        line = self.sheet.write(letter, *number(omega, "rad/s"), *times, uses=uses, node=node, letter=letter.name,
                                settles=f"omega[{mode.index}]", value=omega, unit="rad/s",
                                vanishes=vanishes if node is None else None)
        if ratios and self._letters:        # they follow from the root, else are found with it
            self.sheet.write(settles=f"mode[{mode.index}]", uses=[line], joined=True)
        for i, symbol, left in ratios:
            self.sheet.write(settles=f"mode[{mode.index}][{names[i]}]", value=shape[i].real, letter=symbol.name,
                             vanishes=left, joined=True)
        return line

    def _ratios(self, k: int, shape: Sequence[complex], omega: "Node") -> tuple[Any, list[Any]]:
        """(the row of the largest of (K − ω²M)u, [(i, letter of uᵢ, another row)]), which vanish together; nothing of
        two coordinates, where a part is zero, and where something is gyroscopic."""
        n, zero, largest = len(shape), self.about.table.zero, max(range(len(shape)), key=lambda i: abs(shape[i]))
        if n == 2 or self.found.G or any(x.imag or abs(x) <= NOTHING * abs(shape[largest]) for x in shape):
            return None, []
        first = shape.index(1)
        u = [self.about.table.one if i == first else self.about.letter(self.sheet.letter(f"u{i + 1}", str(k)))
             for i in range(n)]
        rows = [self.about.table.total([(self.found.K.get((i, j), zero) - omega ** 2 * self.found.M.get((i, j), zero))
                                        * u[j] for j in range(n)]) for i in range(n)]
        others = zip((i for i in range(n) if i != first), (i for i in range(n) if i != largest), strict=True)
        return rows[largest], [(i, u[i], rows[row]) for i, row in others]


def _complex(x: complex) -> str:
    """An amplitude; i a quarter period ahead of the others."""
    if not x.imag:
        return told(x.real)
    ahead = "i" if abs(x.imag) == 1 else f"{told(abs(x.imag))}·i"
    if not x.real:
        return f"−{ahead}" if x.imag < 0 else ahead
    return f"({told(x.real)} {'−' if x.imag < 0 else '+'} {ahead})"
