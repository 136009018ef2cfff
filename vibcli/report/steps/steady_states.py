"""The steps from the equations of several degrees of freedom to what loads that swing keep up: complex amplitudes X of

    Z X = F,   Z = K − Ω²M + iΩ(C + G),   q = Im X e^{iΩt},   F = A + iB of loads A sin Ωt + B cos Ωt,

by Cramer's rule up to three degrees of freedom, by numbers beyond (Rao 2011, section 5.6)."""

from cmath import phase
from math import isclose, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.names import lowered
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.characteristic import determinant
from vibcli.report.steps.complex_numbers import cleared, complex_parts, complex_told
from vibcli.report.steps.fixed_points import tell_fixed_points
from vibcli.report.steps.held import HINT, UNTOLD, SmallEquations, Untold
from vibcli.report.steps.matrix_units import unit_of_determinant, unit_of_entry, unit_of_load
from vibcli.report.steps.phasors import Phasors
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node

WRITTEN = 3         # degrees of freedom that are solved by determinants
READABLE = 60       # letters of an amplitude, beyond which Cramer's rule alone tells it
CLOSE = 1e-8        # relative: of an amplitude by the lines and the engine's, beside the largest


class SteadyState:
    """What loads of one frequency keep up. argument: Ωt + φ; loads: {row: {sin or cos: factor}}."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations, argument: "Node",
                 loads: "Mapping[int, Mapping[str, Node]]") -> None:
        self.about, self.sheet, self.found, self.argument, self.loads = about, sheet, found, argument, loads
        self.table, self.names = about.table, about.scene.coordinates
        self.n, self.given = len(self.names), gradient(argument)[about.scene.time]
        kinds = sorted({wave for parts in loads.values() for wave in parts})
        self.wave = kinds[0] if len(kinds) == 1 else "sin"
        symbol = self.given.op == "symbol" or is_number(self.given) or letters(self.given) <= 2
        self.Omega = self.given if symbol else about.letter(sheet.letter("Omega"))
        if not symbol:
            self._know()
        self.undamped = not found.C and not found.G and len(kinds) == 1
        self.parts, self.Z = dict[Any, tuple[Any, ...]](), list[list[Any]]()    # of letters of Z and F; rows of letters
        self.numeric = not about.problem.numeric.has_free_symbols

    def _know(self) -> None:
        """Give the letter of the frequency its number, and values beside those of the other letters."""
        for values in self.about.samples:
            values[self.Omega.name], = evaluate([self.given], Floats, values)
        self.about.know(self.Omega, self.about.value(self.given))

    def write(self, order: int, several: bool) -> "Sequence[complex]":
        """Write down all of it, of a further frequency the results alone; the amplitudes in numbers."""
        self.order, self.several = order, several
        line = self._equations()
        written = self.n <= WRITTEN and order == 1
        lines = [line, *(self._determinant([line]) if written else [])]
        values = self._solved()
        if values is None and not written:
            self._right_sides(line)
            return ()
        self.phasors = Phasors(self, values or ())
        if self.phasors.found:
            self.phasors.write()
        for k, name in enumerate(self.names):
            self._amplitude(k, name, values, lines, written)
        self.phasors.tell_asked(lines)
        if written and not self.several and all(self.force(i)[1].is_zero for i in range(self.n)):
            tell_fixed_points(self.about, sheet=self.sheet, found=self.found, forces=[
                self.force(i)[0] for i in range(self.n)], Omega=self.Omega, uses=lines)
        return values or ()

    def own(self, letter: str, k: int) -> Name:
        """The letter of a coordinate, with a second index where loads have several frequencies."""
        return Name(self.sheet.letter(f"{letter}{k + 1}{self.order if self.several else ''}"))

    def entry(self, i: int, j: int) -> "tuple[Node, Node]":
        """(real part, imaginary part) of Zᵢⱼ."""
        zero, M, C, G, K = self.table.zero, *self.found[:4]
        real = K.get((i, j), zero) - self.Omega ** 2 * M.get((i, j), zero)
        imaginary = self.Omega * (C.get((i, j), zero) + G.get((i, j), zero))
        return zero if is_zero(real) else real, zero if is_zero(imaginary) else imaginary

    def force(self, i: int) -> "tuple[Node, Node]":
        """(real part, imaginary part) of Fᵢ."""
        A, B = (self.loads.get(i, {}).get(wave, self.table.zero) for wave in ("sin", "cos"))
        return (textbook(A), textbook(B)) if self.wave == "sin" else (textbook(B), textbook(-A))

    def _equations(self) -> int:
        """The line of Z X = F."""
        sheet, Omega = self.sheet, self.Omega
        argument = [self.argument] if Omega is self.given else self._shifted()
        what = [Words(", "), Omega, " = ", self.given] if Omega is not self.given else []
        what += number(value, "rad/s") if (value := self.about.value(self.given)) is not None and what else []
        under = [Words(" under  "), f"{self.wave}(", *argument, ")", *what]
        if self.order > 1:
            return sheet.write(Words("likewise"), *under, settles="steady state", uses=self.found.lines)
        M, C, G, K = (Name(sheet.matrix(letter)) for letter in "MCGK")
        both = [part for name, matrix in ((C, self.found.C), (G, self.found.G)) if matrix for part in (" + ", name)][1:]
        rates = [" + i·", Factor(Omega), "·", *(["(", *both, ")"] if len(both) > 1 else both)] if both else []
        X, F = (Name(sheet.letter(letter)) for letter in "XF")
        form = [X, f"·{self.wave}(", *argument, ")"]
        if not self.undamped:
            part = "imaginary" if self.wave == "sin" else "real"
            turned = ["(", *argument, ")"] if len(argument) > 3 or argument[0].op == "sum" else argument
            form = [Words(f"the {part} part of  "), X, "·exp(i·", *turned, ")"]
        head = [Words("steady state"), *(under if self.several else []), Words(": each coordinate is  "), *form]
        stiff = [K, " − "] if self.found.K else ["−"]
        equations = [Words("  with  "), "(", *stiff, Factor(Omega ** 2), "·", M, *rates, ")·", X, " = ", F]
        return sheet.write(*head, *([] if self.several else what), *equations, settles="steady state",
                           uses=self.found.lines)

    def _shifted(self) -> list[Any]:
        """Parts of Ωt, and of the phase of the loads."""
        time = self.about.scene.time
        phase_of = textbook(self.argument - self.given * time)
        return [self.Omega, "·", time, *([] if phase_of.is_zero else [" + ", Factor(phase_of)])]

    def _right_sides(self, line: int) -> None:
        """The line of F of what is not solved in letters."""
        told = [(self._letter("F", i), complex_parts(*self.force(i))) for i in self.loads]
        self.sheet.write(Words("solved as any linear equations, with  "), *[part for i, (letter, parts) in enumerate(
            told) for part in (*([Words(",  ")] if i else []), letter, " = ", *parts)], settles="right sides",
            uses=[line])

    def _letter(self, name: str, i: int, j: int | None = None) -> "Node":
        return self.about.letter(self.sheet.letter(f"{self.sheet.matrix(name) if j is not None else name}{i + 1}"
                                                   + ("" if j is None else str(j + 1))))

    def _entries(self) -> "list[list[Node]]":
        """Rows of letters of Z, one for what stands twice in it; zero where it has nothing beside its diagonal."""
        rows = [[self.table.zero] * self.n for _ in range(self.n)]
        self.defined: list[tuple[Node, str, tuple[Any, ...], str]] = []
        for i in range(self.n):
            for j in range(self.n):
                parts = self.entry(i, j)
                if i != j and all(part.is_zero for part in parts):
                    continue
                twin = j < i and all(map(self.about.same, parts, self.entry(j, i)))
                rows[i][j] = rows[j][i] if twin else self._letter("Z", i, j)
                if not twin:
                    mirrored = j > i and all(map(self.about.same, parts, self.entry(j, i)))
                    more = f" = {self.sheet.matrix('Z')}{lowered(j + 1)}{lowered(i + 1)}" if mirrored else ""
                    self.defined.append((rows[i][j], more, parts, unit_of_entry(self.about.problem, i, j)))
        return rows

    def _determinant(self, uses: list[int]) -> list[int]:
        """Lines of the entries of Z and F, and of its determinant."""
        from numpy.linalg import det

        sheet, self.Z = self.sheet, self._entries()
        self.F = [self.table.zero] * self.n
        for i in self.loads:
            self.F[i] = self._letter("F", i)
            self.defined.append((self.F[i], "", self.force(i), unit_of_load(self.about.problem, i)))
        head, first = [Words("for short  "), Name(sheet.matrix("Z")), "·", Name(sheet.letter("X")), " = ", Name(
            sheet.letter("F")), Words(":  ")], len(sheet.steps)
        for letter, more, parts, unit in self.defined:
            value = self._complex(*parts)
            shown = complex_parts(*parts)
            if value is not None:
                plain = all(is_number(part) for part in parts)
                shown = [*([] if plain else [*shown, " = "]), complex_told(value), Words(f" {unit}")]
            joined = len(sheet.steps) > first
            real = {"node": parts[0], "value": self.about.value(parts[0]), "letter": letter.name}
            sheet.write(*([] if joined else head), letter, more, " = ", *shown, settles=letter.name, uses=uses,
                        joined=joined, unit=unit * (value is not None), **(real if parts[1].is_zero else {}))
            self.parts[letter] = tuple(self._part((letter, unit), part, name, parts[1].is_zero)
                                       for part, name in zip(parts, ("re", "im"), strict=True))
        node, value = determinant(self.Z), complex(det(self._rows(self.about.numbers())[0])) if self.numeric else None
        self.D = self.about.letter(sheet.letter("D"))
        return [sheet.last, sheet.write(Words("its determinant  "), self.D, " = ", node, *(() if value is None else (
            " = " + complex_told(value), Words(f" {unit_of_determinant(self.about.problem)}"))),
                                        settles=self.D.name, uses=[sheet.last])]

    def _part(self, told: "tuple[Node, str]", node: "Node", name: str, real: "Node") -> "Node":
        """The letter of the real or the imaginary part of one that is told, (letter, unit); of zero itself."""
        letter, unit = told
        if node.is_zero or real:
            return node if node.is_zero else letter
        own, value = self.about.letter(self.sheet.letter(letter.name, name)), self.about.value(node)
        self.sheet.write(settles=own.name, letter=own.name, node=node, value=value, unit=unit, joined=True)
        self.about.know(own, value)
        return own

    def told(self, i: int, j: int | None = None) -> "tuple[Node, Node]":
        """(real part, imaginary part) of Zᵢⱼ, or of Fᵢ, by letters where lines tell them."""
        given = self.force(i) if j is None else self.entry(i, j)
        if not self.parts:
            return given
        return self.parts.get(self.F[i] if j is None else self.Z[i][j], given)

    def _complex(self, real: "Node", imaginary: "Node") -> complex | None:
        values = [self.about.value(node) for node in (real, imaginary)]
        return None if None in values else complex(*values)

    def _rows(self, values: dict[str, float]) -> tuple[list[list[complex]], list[complex]]:
        """Z and F at values of the letters."""
        def at(parts: "tuple[Node, Node]") -> complex:
            return complex(*evaluate(list(parts), Floats, values))

        return ([[at(self.entry(i, j)) for j in range(self.n)] for i in range(self.n)],
                [at(self.force(i)) for i in range(self.n)])

    def _solved(self) -> list[complex] | None:
        """Complex amplitudes in numbers, those that the engine finds: Untold of others; None in letters."""
        if not self.numeric:
            return None
        from numpy.linalg import LinAlgError, solve

        try:
            found = [cleared(complex(x)) for x in solve(*self._rows(self.about.numbers()))]
        except LinAlgError:
            raise Untold(UNTOLD, HINT) from None
        Omega, turn = self.about.value(self.given), -1j if self.wave == "sin" else 1
        size = max(map(abs, found))
        for name, X in zip(self.names, found, strict=True):
            signal = self.about.problem.response.signal(NameRef(0, len(name), name, 0))
            known = [value for at, value in signal.phasors if isclose(at, Omega, rel_tol=CLOSE)]
            if abs((known[0] if known else 0.0) - turn * X) > CLOSE * size:
                raise Untold(UNTOLD, HINT)
        return found

    def _amplitude(self, k: int, name: str, values: "Sequence[complex] | None", uses: list[int], written: bool) -> None:
        """The line of X of a coordinate, |X| and its lag."""
        letter, unit = self.own("X", k), "m" if self.about.problem.system.dimension(name) else "rad"
        more, told_of = {}, [Words("of "), *self._which(k), Name(name), Words(":  ")]
        if written:
            column = [[self.F[i] if j == k else entry for j, entry in enumerate(row)] for i, row in enumerate(self.Z)]
            above = determinant(column)
            if above.is_zero:
                self.sheet.write(*told_of, letter, " = 0", settles=f"amplitude({name})", node=above, uses=uses)
                return
            told_of += [letter, " = ", above / self.D]
            more = self._in_letters(name, told_of, letter)
        if values is not None:
            told_of += self._in_numbers(values[k], letter, unit, written)
            node = self.phasors.size(k) or more.get("node")
            turned = node is not None and (self.about.value(node) or 0.0) < 0
            more = {"node": -node if turned else node, "value": abs(values[k]), "unit": unit}
        settles = f"amplitude {self.order} of {name}" if self.several else f"amplitude({name})"
        self.sheet.write(*told_of, settles=settles, uses=uses, **more)
        if values is not None and values[k] and not self.undamped:
            self._lag(k, name, values[k])

    def _lag(self, k: int, name: str, value: complex) -> None:
        """The lag of a coordinate behind the wave of the loads, beside its amplitude."""
        lag = pi if value.real < 0 == value.imag else -phase(value)
        plain = not self.several and self.wave == "sin" and self.argument.op == "product"
        self.sheet.write(Words("its lag  "), self.own("theta", k), *number(lag, "rad"), value=lag, unit="rad",
                         settles=f"phase({name})" if plain else f"lag {self.order} of {name}", joined=True,
                         node=self.phasors.lag(k))

    def _which(self, k: int) -> list[Any]:
        """Words that say which row a coordinate of another number has."""
        own = self.names[k].lstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_")
        nth = ("first", "second", "third")[k] if self.n <= WRITTEN else ""
        return [Words(f"the {nth} coordinate, ")] if own not in ("", str(k + 1)) and nth else []

    def _in_numbers(self, value: complex, letter: Name, unit: str, written: bool) -> list[Any]:
        """Parts of a complex amplitude and its size."""
        if self.undamped:
            return [*([] if written else [letter]), *number(value.real, unit)]
        head: list[Any] = [" = " + complex_told(value), Words(f" {unit},  ")] if written else []
        return [*head, "|", letter, "|", *number(abs(value), unit)]

    def _in_letters(self, name: str, told_of: Any, letter: Name) -> "dict[str, Node]":
        """The amplitude that the engine finds in letters, told where it is one to read; in numbers of what is not
        damped."""
        try:
            formula = self.about.problem.symbolic_steady_state(name).formula
        except (NotInLetters, PhysicsError):
            return {}
        if not self._agrees(node := formula.amplitude, self.names.index(name)):
            raise Untold(UNTOLD, HINT)
        if letters(node) <= READABLE and self.Omega is self.given and (self.undamped or not self.numeric):
            told_of += [*([Words(",  "), "|", letter, "|"] if not formula.undamped else []), " = ", node]
        return {"node": node}

    def _agrees(self, node: "Node", k: int) -> bool:
        """Is the size of an amplitude by Z X = F that of the engine's formula at values of the letters?"""
        from numpy.linalg import solve

        for values in self.about.samples:
            of_engine, = evaluate([node], Floats, values)
            mine = list(map(abs, solve(*self._rows(values))))
            if not abs(abs(of_engine) - mine[k]) <= CLOSE * (mine[k] if of_engine else max(mine)):
                return False
        return True
