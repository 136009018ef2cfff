"""Frequency responses of three degrees of freedom at a frequency, by the determinants of

    Z = K − Ω²M + iΩ(C + G),   Z X = b,   H = cᵀX + d,

in letters for the entries of Z (Rao 2011, section 5.6)."""

from typing import TYPE_CHECKING, Any, cast

from vibcli.mechanics.symbolic_linear import coefficients
from vibcli.quantities.in_letters import frequency_of
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.characteristic import determinant
from vibcli.report.steps.complex_nodes import ComplexNode, LetteredStiffness, determinant_of
from vibcli.report.steps.complex_numbers import complex_parts, complex_told
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.matrix_units import unit_of_entry
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS, Node, is_measure, is_number
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.syntax import QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

DEGREES = 3
PARTS = "re", "im", "arg", "phase"


def tell_receptance(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is the size, a part or the lag of a response at a frequency written down so?"""
    response = response_at(asked.tree)
    if response is None or len(problem.scene.q) != DEGREES:
        return False
    before, known = len(sheet.steps), set(sheet.responses)
    receptance = _Receptance(problem, sheet, response)
    if tell_found(problem, sheet, asked, receptance.forms(getattr(asked.tree, "head", "abs")), [sheet.last]):
        return True
    del sheet.steps[before:]
    for Omega in sheet.responses.keys() - known:
        del sheet.responses[Omega]
    return False


def response_at(tree: Any) -> "QuantityRef | None":
    """The response whose size, part or lag at a frequency is asked; None of another tree."""
    head = getattr(tree, "head", getattr(tree, "name", ""))
    if head == "transmissibility":
        return cast("QuantityRef | None", tree)
    first = next(iter(getattr(tree, "args", ())), None)
    at = isinstance(first, QuantityRef) and first.head == "frf" and first.args
    return cast("QuantityRef | None", first if at and head in ("abs", *PARTS) else None)


class _Receptance:
    def __init__(self, problem: "Problem", sheet: WorkedSolution, response: QuantityRef) -> None:
        self.problem, self.sheet, self.table = problem, sheet, problem.scene.table
        given, self.numeric = frequency_of(problem, response.args[0]), not problem.numeric.has_free_symbols
        if given not in sheet.responses:
            sheet.responses[given] = self._stiffness(given)
        self.Z = sheet.responses[given]
        self.Omega = self.Z.Omega
        parts = coefficients(problem.symbolic, *response.indices)
        self.b, self.c, (self.direct, *_) = ([self._power(part, i) for i in range(DEGREES)] for part in parts)

    def _power(self, part: Any, i: int) -> ComplexNode:
        """Σ sᵏ of [{i: node}] at s = iΩ."""
        zeroth, first, second = (copied([one[i]], self.table)[0] if i in one else self.table.zero for one in part)
        return ComplexNode(textbook(zeroth - self.Omega ** 2 * second), textbook(self.Omega * first))

    def _entry(self, i: int, j: int) -> ComplexNode:
        M, C, G, K = (part.get((i, j), self.table.zero) for part in self.problem.symbolic.matrices)
        parts = K - self.Omega ** 2 * M, self.Omega * (C + G)
        return ComplexNode(*(self.table.zero if is_zero(part) else part for part in parts))

    def _at(self, given: Any) -> tuple[Any, list[Any]]:
        """(Ω, parts that open the line): one without letters has a letter of its own, which tells its unit."""
        units = [is_measure(part) for part in reachable([given]) if part.op == "symbol"]
        if not all(units):
            return given, [Words("the response at  Ω = "), given, Words("  by  ")]
        letter, value = self._fresh("Omega"), evaluate([given], Floats, dict.fromkeys(UNITS.values(), 1.0))[0]
        told = [] if units else [Words(" rad/s")]
        known = [] if is_number(given) else number(value, "rad/s")
        self.sheet.write(Words("the response at  "), Name(letter), " = ", given, *told, *known, settles=letter,
                         letter=letter, node=given if units else given / self.table.parameter(UNITS["s"]), value=value,
                         unit="rad/s", opens=True)
        return self.table.parameter(letter), [Words("by  ")]

    def _stiffness(self, given: Any) -> LetteredStiffness:
        """Write down the entries of Z and its determinant, and give them letters."""
        self.Omega, head = self._at(given)
        sheet, zero = self.sheet, self.table.zero
        letters = [[zero] * DEGREES for _ in range(DEGREES)]
        parts = [[ComplexNode(zero, zero)] * DEGREES for _ in range(DEGREES)]
        entries = [[self._entry(i, j) for j in range(DEGREES)] for i in range(DEGREES)]
        for i, j in ((i, j) for i in range(DEGREES) for j in range(DEGREES)):
            entry = entries[i][j]
            alike = all(is_zero(one - other) for one, other in zip(entry, entries[j][i], strict=True))
            if j < i and alike:
                letters[i][j], parts[i][j] = letters[j][i], parts[j][i]
            elif not (entry.real.is_zero and entry.imaginary.is_zero):
                name = self._fresh(f"{sheet.matrix('Z')}{i + 1}{j + 1}")
                base = name.rstrip("′")
                twin = [" = ", Name(f"{base[:-2]}{j + 1}{i + 1}{name[len(base):]}")] if j > i and alike else []
                letters[i][j] = self.table.parameter(name, positive=False)
                sheet.write(*head, letters[i][j], *twin, " = ", *complex_parts(*entry), *self._number(entry, i, j),
                            settles=name, joined=not head)
                parts[i][j], head = self._known(name, entry, unit_of_entry(self.problem, i, j)), []
        D = self.table.parameter(self._fresh("D"), positive=False)
        sheet.write(Words("their determinant  "), D, " = ", determinant(letters), settles=D.name, uses=[sheet.last])
        return LetteredStiffness(letters, parts, D, self.Omega)

    def _fresh(self, name: str) -> str:
        """A letter that no line has."""
        taken = {part for line in self.sheet.steps for part in (line.letter, line.settles)}
        taken |= {part.name for line in self.sheet.steps for part in line.parts if isinstance(part, Node)
                  and part.op == "symbol"}
        found = self.sheet.letter(name)
        while found in taken or f"{found}_re" in taken:
            name += "′"
            found = self.sheet.letter(name)
        return found

    def _number(self, entry: ComplexNode, i: int, j: int) -> list[str | Words]:
        if not self.numeric or all(is_number(part) for part in entry):
            return []
        value = complex(*evaluate(list(entry), Floats, self._floats))
        return [f" = {complex_told(value)}", Words(f" {unit_of_entry(self.problem, i, j)}")]

    @property
    def _floats(self) -> dict[str, float]:
        """The values of all letters."""
        return {**self.problem.numeric.floats, **{line.letter: line.value for line in self.sheet.steps
                                                  if line.letter and line.value is not None}}

    def _known(self, name: str, entry: ComplexNode, unit: str) -> ComplexNode:
        """The real and the imaginary part by letters of their own."""
        found = []
        for node, part in zip(entry, ("re", "im"), strict=True):
            if node.is_zero:
                found.append(node)
                continue
            own = self.sheet.letter(name, part)
            value = evaluate([node], Floats, self._floats)[0] if self.numeric else None
            self.sheet.write(settles=own, letter=own, node=node, value=value, joined=True,
                             unit="" if value is None else unit)
            found.append(self.table.parameter(own, positive=False))
        return ComplexNode(*found)

    def forms(self, part: str) -> "Iterator[tuple[Node, list[Any]]]":
        """(what is asked of H, parts that tell it)."""
        H, shown = self._response()
        real, imaginary = H
        atan2 = self.table.call("atan2", imaginary, real)
        node = {"re": real, "im": imaginary, "arg": atan2, "phase": -atan2}.get(
            part, self.table.sqrt(real ** 2 + imaginary ** 2))
        words = {"re": "the real part of  ", "im": "the imaginary part of  ", "arg": "the angle of  ",
                 "phase": "the lag of  "}
        yield node, [Words(words[part]), shown] if part in words else ["|", shown, "|"]

    def _response(self) -> "tuple[ComplexNode, Node]":
        """(H, the same by the letters of Z and of its determinant)."""
        below, H = determinant_of(self.Z.parts), self.direct
        shown = self.direct.real
        for k, factor in enumerate(self.c):
            if factor.real.is_zero and factor.imaginary.is_zero:
                continue
            column = [[self.b[i] if j == k else part for j, part in enumerate(row)] for i, row in enumerate(
                self.Z.parts)]
            X = determinant_of(column).over(below)
            H = ComplexNode(*(one + other for one, other in zip(H, factor.times(X), strict=True)))
            above = determinant([[self.b[i].real if j == k else part for j, part in enumerate(row)]
                                 for i, row in enumerate(self.Z.letters)])
            shown = shown + factor.real * above / self.Z.determinant
        return H, shown
