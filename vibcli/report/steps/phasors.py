"""The parts of complex amplitudes X = a + ib, which Z X = F gives together, and by these the amplitude of what is a
linear function of the motion, as the force of a spring or a distance:

    s = Σ αⱼqⱼ + βⱼq̇ⱼ + s₀(t),   S = Σ (αⱼ + iΩβⱼ) Xⱼ + S₀.
"""

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.steady_state import waves_of_all
from vibcli.base.errors import NotInLetters, PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.signals import moving
from vibcli.mechanics.symbolic_linear import outputs
from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.complex_nodes import ComplexNode, LetteredStiffness, determinant_of
from vibcli.report.steps.complex_numbers import complex_parts
from vibcli.report.steps.held import drive_of
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef, QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from vibcli.language.reader import Expression
    from vibcli.report.steps.steady_states import SteadyState
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

CLOSE = 1e-8        # relative: of an amplitude by the lines and the engine's
READABLE = 20       # letters of what stands between bars


class Phasors:
    """Those of all coordinates under loads of one frequency; known: have they letters, none of the parts being zero?"""

    def __init__(self, steady: "SteadyState", values: "Sequence[complex]") -> None:
        self.steady, self.sheet, self.about, self.table = steady, steady.sheet, steady.about, steady.table
        self.parts = ("a",) if steady.undamped else ("a", "b")
        self.values = [part for X in values for part in ((X.real,) if steady.undamped else (X.real, X.imag))]
        self.found = bool(values) and not steady.several and all(self.values)
        if steady.Z and not steady.several:
            self.sheet.responses[steady.given] = LetteredStiffness(steady.Z, stiffness_of(steady), steady.D,
                                                                   steady.given)
        self.by_cramer = by_cramer(steady) if not (steady.several or steady.numeric) and steady.Z else []
        self.known = self.found or bool(self.by_cramer)
        self.letters = [self.about.letter(self.sheet.letter(part, f"X{k + 1}"))
                        for k in range(steady.n) for part in self.parts]

    def parts_of(self, k: int) -> "tuple[Node, Node]":
        """a and b of a coordinate."""
        if self.by_cramer:
            return self.by_cramer[k].real, self.by_cramer[k].imaginary
        if self.steady.undamped:
            return self.letters[k], self.table.zero
        return self.letters[2 * k], self.letters[2 * k + 1]

    def write(self) -> None:
        """Let the last line tell the letters, which are found together."""
        steady, rows = self.steady, []
        for i in range(steady.n):
            Z = [steady.told(i, j) for j in range(steady.n)]
            F, X = steady.told(i), [self.parts_of(j) for j in range(steady.n)]
            rows.append(self.table.total([z[0] * x[0] - z[1] * x[1] for z, x in zip(Z, X, strict=True)]) - F[0])
            if not steady.undamped:
                rows.append(self.table.total([z[0] * x[1] + z[1] * x[0] for z, x in zip(Z, X, strict=True)]) - F[1])
        given = {steady.Omega: steady.given} if steady.Omega is not steady.given else {}
        for i, (letter, value, row) in enumerate(zip(self.letters, self.values, substitute(rows, given), strict=True)):
            self.about.know(letter, value)
            name = self.about.scene.coordinates[i // len(self.parts)]
            self.sheet.write(settles=letter.name, letter=letter.name, value=value, vanishes=row, joined=True,
                             unit="m" if self.about.problem.system.dimension(name) else "rad")

    def size(self, k: int) -> "Node | None":
        """|X| of a coordinate; None where the parts have no letters."""
        return _size(*self.parts_of(k), self.about.value) if self.known else None

    def lag(self, k: int) -> "Node | None":
        """Its lag."""
        a, b = self.parts_of(k)
        return self.table.call("atan2", -b, a) if self.known and not self.steady.undamped else None

    def tell_asked(self, uses: "list[int]") -> None:
        """Write down the amplitudes of other signals that a sheet asks, and phases that no line tells."""
        settled = {line.settles for line in self.sheet.steps}
        for asked, signal in asked_of_signals(self.about, answers=True) if self.known else ():
            found = self._of_signal(signal) if asked.text not in settled else None
            if found is None:
                continue
            S, shown = found
            if asked.tree.head == "phase":
                self._tell_phase(asked, S, shown, uses)
            elif self.by_cramer:
                size = ["|", *shown, "|"] if shown is not None else [Words("the size of its complex amplitude")]
                tell_found(self.about.problem, self.sheet, asked, [(self._abs(S), size)], uses)
            else:
                tell_amplitude(self.about, self.sheet, asked, self._abs(S), shown, uses)

    def _tell_phase(self, asked: "Expression", S: ComplexNode, shown: list[Any] | None, uses: list[int]) -> None:
        """The line of the lag behind a sine of what has the complex amplitude S."""
        lag, quarter = self.table.call("atan2", -S.imaginary, S.real), self.table.pi / 2
        what = [Words("the lag of  "), *([Words("its complex amplitude")] if shown is None else shown)]
        turned = [(lag - quarter, [*what, " − π/2"]), (lag + 3 * quarter, [*what, " + 3·π/2"])]
        tell_found(self.about.problem, self.sheet, asked, [(lag, what)] if self.steady.wave == "sin" else turned, uses)

    def _abs(self, S: ComplexNode) -> "Node":
        if self.by_cramer and S.imaginary.is_zero:
            return self.table.call("abs", S.real)
        return _size(S.real, S.imaginary, self.about.value)

    def _of_signal(self, signal: "SignalAboutRest") -> "tuple[ComplexNode, list[Any] | None] | None":
        """(S by the parts of X, parts of it by X where that is short); None where it is driven otherwise."""
        drive = _driven(self.about, signal.drive, self.steady)
        if drive is None:
            return None
        factors, shown = signal.factors(self.steady.given), [drive[0]]
        real, imaginary = [drive[0]], [drive[1]]
        for j, factor in enumerate(factors):
            part = factor.times(ComplexNode(*self.parts_of(j)))
            real.append(part.real)
            imaginary.append(part.imaginary)
            shown.append(factor.real * self.about.letter(self.sheet.letter(f"X{j + 1}")))
        total = textbook(self.table.total(shown))
        whole = min(total, textbook(-total), key=lambda node: len(plain(node)))
        plainly = all(part.imaginary.is_zero for part in (drive, *factors))
        told = [whole] if plainly and letters(whole) <= READABLE else self._by_factors(drive, factors)
        return ComplexNode(self.table.total(real), self.table.total(imaginary)), told

    def _by_factors(self, drive: Any, factors: "Sequence[Any]") -> "list[Any] | None":
        """Parts of (α + iβ) X₁ + … where these are short."""
        terms = [(factor, [Name(self.sheet.letter(f"X{j + 1}"))]) for j, factor in enumerate(factors)]
        told: list[Any] = []
        for (real, imaginary), letter in [(drive, []), *terms]:
            if real.is_zero and imaginary.is_zero:
                continue
            told += [" + "] * bool(told)
            told += [*_in_brackets(ComplexNode(real, imaginary)), "·", *letter] if letter else complex_parts(
                real, imaginary)
        size = sum(letters(node) for pair in (drive, *factors) for node in pair)
        return told if size <= READABLE else None

class SignalAboutRest(NamedTuple):
    """α and β by coordinate, and s₀(t); of a force of the ground what accelerations add, too."""

    slopes: "list[Node]"
    rates: "list[Node]"
    drive: Any
    of_accelerations: "list[Node]"

    def factors(self, Omega: "Node") -> "list[ComplexNode]":
        """α − Ω²γ + iΩβ by coordinate."""
        return [ComplexNode(alpha - Omega ** 2 * gamma, Omega * beta) for alpha, beta, gamma in zip(
            self.slopes, self.rates, self.of_accelerations, strict=True)]


def asked_of_signals(about: AboutRest, answers: bool = False) -> "Iterator[tuple[Expression, SignalAboutRest]]":
    """What a sheet asks of amplitudes of signals that are no coordinates, and answers."""
    rules = about.problem.spec.get("variants")
    asked = (*(rules.ask if rules is not None else ()), *(about.problem.spec.answers if answers else ()))
    for one in {one.asked.text: one for one in asked}.values():
        tree = one.asked.tree
        own = isinstance(tree, QuantityRef) and tree.args and isinstance(tree.args[0], NameRef) and (
            tree.args[0].name in about.scene.coordinates)
        head = getattr(tree, "head", "")
        if (head == "amplitude" and not own) or (head == "phase" and answers):
            with suppress(NotInLetters, PhysicsError, SpecError):
                yield one.asked, _linear(about, tree.args[0])


def _linear(about: AboutRest, tree: "SyntaxTree") -> SignalAboutRest:
    """A signal about rest; what coordinates do not tell, as a force of the ground, by the rows of the engine."""
    zero, system, n = about.table.zero, about.problem.system, len(about.scene.q)
    with suppress(PhysicsError, SpecError):
        node, = copied([lower(tree, system.scene.table, lambda name, primes, part: moving(system, name, primes))],
                       about.table)
        small, slopes = about.small(node), gradient(node)
        return SignalAboutRest([small.slopes.get(j, zero) for j in range(n)], [
            about.rest(slopes[v]) if v in slopes else zero for v in about.scene.v], small.drive, [
            about.rest(slopes[a]) if a in slopes else zero for a in about.scene.a])
    rows, direct = outputs(about.problem.symbolic, _named(tree))
    q, v, a = [[copied([part[j]], about.table)[0] if j in part else zero for j in range(n)] for part in rows]
    return SignalAboutRest(q, v, copied([direct], about.table)[0], a)


def _named(signal: SignalAboutRest) -> Any:
    return signal.name + "'" * signal.primes if isinstance(signal, NameRef) else signal


def tell_amplitude(about: AboutRest, sheet: WorkedSolution, asked: "Expression", node: "Node",
                   shown: "list[Any] | None", uses: "Sequence[int]") -> None:
    """Write down the amplitude of a signal; nothing where that is not the engine's."""
    value = float(value_of(about.problem, asked)[0])
    if abs((about.value(node) or 0.0) - value) > CLOSE * abs(value):
        return
    unit = unit_told(about.problem.spec, asked)
    sheet.write(Words(as_printed(asked.text)), *([Words(":  "), "|", *shown, "|"] if shown is not None else []),
                *number(value, unit), settles=asked.text, node=node, value=value, unit=unit, uses=uses)


def _driven(about: AboutRest, node: "Node", steady: "SteadyState") -> "ComplexNode | None":
    """What a signal is driven with by the argument and wave of a steady state; None of another frequency."""
    if node.is_zero:
        return ComplexNode(node, node)
    n = len(about.scene.q)
    waves = waves_of_all(about.scene, {**drive_of(about.problem), n: node})[n]
    if any(argument is not steady.argument for argument, _ in waves):
        return None
    A, B = (waves.get((steady.argument, wave), about.table.zero) for wave in ("sin", "cos"))
    return ComplexNode(A, B) if steady.wave == "sin" else ComplexNode(B, -A)


def tell_of_one(about: AboutRest, sheet: WorkedSolution, of: "tuple[Node, Node | None]", steady: Any,
                uses: "Sequence[int]") -> None:
    """Write down the amplitudes of other signals of one degree of freedom, √(α² + Ω²β²) X, and in numbers long ones of
    those that are driven beside it, |(α + iΩβ) X exp(−iθ) + S₀|; `of`: X, and θ where there is a lag."""
    settled, (Omega,) = {line.settles for line in sheet.steps}, copied([steady.formula.Omega], about.table)
    for asked, signal in asked_of_signals(about, answers=True):
        if asked.tree.head != "amplitude" or asked.text in settled:
            continue
        (factor,), X = signal.factors(Omega), of[0]
        if signal.drive.is_zero:
            node = root(about.tidy(factor.real ** 2 + factor.imaginary ** 2), about.samples) * X
            tell_found(about.problem, sheet, asked, [(node, [node])], uses)
        elif of[1] is not None and _is_long(about, asked) and (drive := _driven(about, signal.drive, steady)):
            tell_found(about.problem, sheet, asked, [_beside(about, factor, of, drive)], uses)


def _is_long(about: AboutRest, asked: "Expression") -> bool:
    """Is an amplitude by itself too long to be read?"""
    steady = about.problem.symbolic_steady_state(_named(asked.tree.args[0]))
    return letters(steady.formula.amplitude) > READABLE


def _beside(about: AboutRest, factor: ComplexNode, of: "tuple[Node, Node | None]",
            drive: ComplexNode) -> "tuple[Node, list[Factor | Node | str]]":
    """(the size of (α + iβ) X exp(−iθ) + S₀, parts that tell it)."""
    (X, theta), call = of, about.table.call
    if factor.real.coefficient < 0 == (factor.real.op == "sum"):
        factor, drive = (ComplexNode(-one.real, -one.imaginary) for one in (factor, drive))
    S = factor.times(ComplexNode(X * call("cos", theta), -(X * call("sin", theta))))
    minus = drive.imaginary.is_zero and drive.real.op != "sum" and drive.real.coefficient < 0
    beside = [" − ", Factor(-drive.real)] if minus else [" + ", *complex_parts(*drive)]
    shown = [*_in_brackets(factor), "·", X, "·exp(−i·", theta, ")", *beside]
    return about.table.sqrt((S.real + drive.real) ** 2 + (S.imaginary + drive.imaginary) ** 2), ["|", *shown, "|"]


def _in_brackets(factor: ComplexNode) -> list[Any]:
    """Parts of a + ib before a dot."""
    both = not (factor.real.is_zero or factor.imaginary.is_zero)
    parts = complex_parts(*factor)
    return ["(", *parts, ")"] if both else [Factor(parts[0])] if len(parts) == 1 else parts


def stiffness_of(steady: "SteadyState") -> list[list[ComplexNode]]:
    """Rows of Z by the letters of its entries."""
    return [[ComplexNode(*steady.told(i, j)) for j in range(steady.n)] for i in range(steady.n)]


def by_cramer(steady: "SteadyState") -> list[ComplexNode]:
    """The complex amplitudes by determinants of Z, in the letters of its entries and of F."""
    rows, forces = stiffness_of(steady), [ComplexNode(*steady.told(i)) for i in range(steady.n)]
    below = determinant_of(rows)
    columns = ([[forces[i] if j == k else part for j, part in enumerate(row)] for i, row in enumerate(rows)]
               for k in range(steady.n))
    return [determinant_of(column).over(below) for column in columns]


def _size(a: "Node", b: "Node", value_of_node: "Callable[[Node], float | None]") -> "Node":
    """√(a² + b²)."""
    if b.is_zero:
        return -a if value_of_node(a) < 0 else a
    return a.table.sqrt(a ** 2 + b ** 2)
