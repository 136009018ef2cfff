"""The steps to the damping matrix of a scene of which each mode has a damping ratio of its own (Clough & Penzien 1993,
section 12-3), driven displacements d leaving the modes at −K⁻¹K_d d:

    C = Σ 2ζω r rᵀ/(uᵀr),   C_d = Σ (2ζ/ω) r uᵀK_d/(uᵀr),   r = Mu.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.mechanics.given_damping_in_letters import excitation_by_damping, proportional
from vibcli.mechanics.linearisation import at_position
from vibcli.mechanics.symbolic_linear import place_in_letters
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.notation.names import lowered
from vibcli.quantities.matrices import entry_dimension
from vibcli.quantities.signal_dimensions import input_dimension
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import HINT, UNTOLD, SmallEquations, Untold
from vibcli.report.steps.matrix_units import unit_of_entry
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.report.steps.step import WorkedLine
    from vibcli.symbolic.node import Node

MODAL = "modal"
MOST = 4            # coordinates, beyond which the entries are too many to read
INSTANTS = 0.137, 0.411      # at which right sides are compared
CLOSE = 1e-8        # relative: of an entry by the lines and the engine's, beside the largest


def with_damping_by_modes(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> SmallEquations:
    """Equations with what damping by modes adds, which is written down; themselves where there is none. Untold where
    the lines do not tell the shapes of all modes."""
    if proportional(about.problem.spec):
        return found
    return _Damping(about, sheet, found).told()


class _Damping:
    """What ratios of modes add, by the letters of these modes."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
        self.about, self.sheet, self.found, self.table = about, sheet, found, about.table
        self.n, record = len(about.scene.q), about.problem.spec.get("damping")
        if MODAL not in record or self.n > MOST or about.problem.numeric.has_free_symbols:
            raise Untold(UNTOLD, HINT)
        ratios = [about.scene.lower(one) for one in record[MODAL]]
        self.modes = [self._mode(k, ratios[min(k, len(ratios)) - 1]) for k in range(1, self.n + 1)]

    def _mode(self, k: int, zeta: "Node") -> "tuple[Node, Node, list[Node], list[Node], Node]":
        """(ζ, ω, M u, u, uᵀMu)."""
        names, lines = self.about.scene.coordinates, {line.settles: line for line in self.sheet.steps}
        told = [lines.get(f"mode[{k}][{name}]") for name in names]
        omega = lines.get(f"omega[{k}]")
        if omega is None or not omega.value or told.count(None) != 1:
            raise Untold(UNTOLD, HINT)
        u = [self.table.one if line is None else self._known(line) for line in told]
        row = [self.table.total([self.found.M[i, j] * u[j] for j in range(self.n) if (i, j) in self.found.M]
                                or [self.table.zero]) for i in range(self.n)]
        return zeta, self._known(omega), row, u, self.table.total([a * b for a, b in zip(row, u, strict=True)])

    def _known(self, line: "WorkedLine") -> "Node":
        letter = self.about.letter(line.letter or line.settles)
        self.about.know(letter, line.value)
        return letter

    def told(self) -> SmallEquations:
        """Write down the entries, and give the equations with them."""
        sheet, zero = self.sheet, self.table.zero
        self.letter, M, (u, r) = sheet.matrix("C"), Name(sheet.matrix("M")), map(sheet.letter, "ur")
        self.line = sheet.write(Words("of each mode `damping:` adds to  "), f"{self.letter}_ij", Words("  the part  "),
                                f"2·ζ·ω·{r}_i·{r}_j/({u}·{r})", Words("  with  "), Name(r), " = ", M, "·", Name(u),
                                settles="damping by modes", uses=self.found.lines)
        engine, C = self.about.problem.configuration.linear_system.matrices()[1], {}
        for i in range(self.n):
            for j in range(i, self.n):
                node = self.table.total([self.found.C.get((i, j), zero), *(
                    2 * zeta * omega * row[i] * row[j] / mass for zeta, omega, row, _, mass in self.modes)])
                C[i, j] = C[j, i] = self._entry(i, j, node, not C, j > i)
                if abs(self.about.value(C[i, j]) - engine.get((i, j), 0.0)) > CLOSE * max(map(abs, engine.values())):
                    raise Untold(UNTOLD, HINT)
        lines = [*self.found.lines, self.line]
        return self.found._replace(C=C, drive=self._drive(), lines=[*lines, sheet.last])

    def _unit_of_driven(self, i: int, name: str) -> str:
        """That of the factor of the speed of what is driven."""
        known, q = input_dimension(self.about.problem.spec, name), self.about.scene.coordinates[i]
        return "" if known is None else units.text(entry_dimension("C", self.about.problem.system.dimension(q), known))

    def _entry(self, i: int, j: int, node: "Node", first: bool = False, twice: bool = False, words: str = "",
               driven: str = "") -> "Node":
        """The letter of an entry, which is written down."""
        name, value = self.sheet.letter(f"{self.letter}{i + 1}{j + 1}"), self.about.value(node)
        unit = unit_of_entry(self.about.problem, i, j, "C") if j < self.n else self._unit_of_driven(i, driven)
        twin = f" = {self.letter}{lowered(j + 1)}{lowered(i + 1)}" if twice else ""
        self.sheet.write(Words(words), f"{self.letter}{lowered(i + 1)}{lowered(j + 1)}{twin}", *number(value, unit),
                         settles=name, node=node, value=value, unit=unit, uses=[self.line], joined=not first,
                         letter=name)
        letter = self.about.letter(name)
        self.about.know(letter, value)
        return letter

    def _drive(self) -> "dict[int, Node]":
        """{i: Q(t)} with what damping does of driven displacements; Untold where that is not the engine's."""
        symbolic, drive = self.about.problem.symbolic, dict(self.found.drive)
        opened = symbolic.configuration.with_inputs
        driven = {j: one for j, one in enumerate(opened.scene.inputs.values(), opened.n) if one.node is not None}
        if not driven:
            return drive
        *_, K = matrices_in_letters(at_position(opened.form, place_in_letters(symbolic)))
        K = {pair: copied([node], self.table)[0] for pair, node in K.items() if pair[1] in driven and pair[0] < self.n}
        for j, one in driven.items():
            rate, = copied([opened.scene.rate(one.node)], self.table)
            for i in range(self.n):
                node = self.table.total([2 * zeta / omega * row[i] / mass * self.table.total(
                    [u[k] * K[k, j] for k in range(self.n) if (k, j) in K] or [self.table.zero])
                    for zeta, omega, row, u, mass in self.modes])
                if not node.is_zero:
                    entry = self._entry(i, j, node, words="" if i else f"and before the speed of {one.name}  ",
                                        driven=one.name)
                    drive[i] = drive.get(i, self.table.zero) - entry * rate
        self._require(drive)
        return drive

    def _require(self, drive: "Mapping[int, Node]") -> None:
        """Untold where right sides are not those of the engine at some instants."""
        more, time = excitation_by_damping(self.about.problem.symbolic), self.about.scene.time.name
        for t in INSTANTS:
            values = {**self.about.numbers(), time: t}
            for i, node in drive.items():
                terms = evaluate([node, self.found.drive.get(i, self.table.zero), more.get(i, self.table.zero)], Floats,
                                 values)
                if abs(terms[0] - terms[1] - terms[2]) > CLOSE * (abs(terms[1]) + abs(terms[2])):
                    raise Untold(UNTOLD, HINT)
