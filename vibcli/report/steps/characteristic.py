"""det(K − ω²M) = 0 of two and three degrees of freedom, written out by powers of ω², and its roots in letters.

    det(K − λM) = Σ (−λ)ᵏ aₖ,   aₖ = Σ det of K with k of its rows those of M

and of two with gyroscopic terms, where det(K + iωG − ω²M) has G₁₂² ω² less.
"""

from collections.abc import Sequence
from itertools import combinations, product
from typing import TYPE_CHECKING, Any, cast

from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.matrix_units import unit_of_determinant
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.symbolic.node import Node

WRITTEN_OUT = 60    # letters of a determinant by its entries, beyond which it is told by its powers alone
LONG = 100          # letters of a root or a coefficient, beyond which it is told by its number alone


def coefficients(about: AboutRest, found: SmallEquations) -> "list[Node]":
    """[aₙ, …, a₀]."""
    n, zero = len(about.scene.q), about.table.zero
    rows = [[[part.get((i, j), zero) for j in range(n)] for i in range(n)] for part in (found.K, found.M)]
    turned = found.G.get((0, 1), zero) ** 2
    return [about.tidy(about.table.total([turned if k == 1 else zero, *(
        determinant([rows[i in of_M][i] for i in range(n)]) for of_M in combinations(range(n), k))]))
        for k in range(n, -1, -1)]


def polynomial(names: "Sequence[Node]", omega: "Node") -> "Node":
    """aₙ ω²ⁿ − aₙ₋₁ ω²ⁿ⁻² + … of [aₙ, …, a₀]."""
    n = len(names) - 1
    return omega.table.total([a * omega ** (2 * (n - k)) * (-1) ** k for k, a in enumerate(names)])


def damped_coefficients(about: AboutRest, found: SmallEquations) -> "list[Node]":
    """[c₂ₙ, …, c₀] of det(λ²M + λ(C + G) + K) = Σ cₖ λᵏ."""
    n, zero = len(about.scene.q), about.table.zero
    parts = (found.K,), (found.C, found.G), (found.M,)
    rows = [[[about.table.total([part[i, j] for part in of if (i, j) in part] or [zero]) for j in range(n)]
             for i in range(n)] for of in parts]
    sums: list[Any] = [[] for _ in range(2 * n + 1)]
    for powers in product(range(3), repeat=n):
        sums[sum(powers)].append(determinant([rows[power][i] for i, power in enumerate(powers)]))
    return [about.tidy(about.table.total(terms)) for terms in reversed(sums)]


def determinant(rows: "Sequence[Sequence[Node]]") -> "Node":
    """Along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    minors = ([row[:j] + row[j + 1:] for row in map(list, rows[1:])] for j in range(len(rows)))
    return rows[0][0].table.total([entry * determinant(minor) * (-1) ** j for j, (entry, minor) in enumerate(
        zip(rows[0], minors, strict=True)) if not entry.is_zero])


def tell_polynomial(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: list[int]
                    ) -> "tuple[list[Node], list[Node], list[int]]":
    """Write down det(K − ω²M) = 0 and its coefficients: (their letters, the coefficients, the numbers of the lines)."""
    n = len(about.scene.q)
    names = [about.letter(sheet.letter(f"a{power}")) for power in range(n, -1, -1)]
    omega, of_M, of_K = about.letter(sheet.letter("omega")), sheet.matrix("M"), sheet.matrix("K")
    turned = [" + i·", omega, "·", Name(sheet.matrix("G"))] if found.G else []
    powers = ["−(", polynomial(names, omega), ")"] if n % 2 else [polynomial(names, omega)]
    head = sheet.write("det(", Name(of_K), *turned, " − ", omega ** 2, "·", Name(of_M), ") = ", *_written_out(
        about, found, omega), *powers, " = 0", settles="det(K - omega^2*M)", uses=uses)
    known = coefficients(about, found)
    lines = [head]
    for power, (letter, node) in enumerate(zip(names, known, strict=True)):
        lines.append(tell_coefficient(about, sheet, (letter, node), 2 * (n - power), uses))
    return names, known, lines


def _written_out(about: AboutRest, found: SmallEquations, omega: "Node") -> "list[Node | str]":
    """Parts of the determinant by its entries and ` = `; none of a long or a gyroscopic one."""
    n, zero = len(about.scene.q), about.table.zero
    node = determinant([[found.K.get((i, j), zero) - omega ** 2 * found.M.get((i, j), zero) for j in range(n)]
                        for i in range(n)])
    return [] if found.G or letters(node) > WRITTEN_OUT else [node, " = "]


def tell_coefficient(about: AboutRest, sheet: WorkedSolution, found: "tuple[Node, Node]", power: int,
                     uses: list[int]) -> int:
    """Write down a letter and what it is, a sum of determinants that are multiplied by the time to a power."""
    letter, node = found
    value, unit = about.value(node), unit_of_determinant(about.problem, power)
    shown = [] if value is not None and (letters(node) > LONG or is_number(node)) else [" = ", node]
    return sheet.write(letter, *shown, *(() if value is None else number(value, unit)), settles=letter.name, node=node,
                       value=value, unit="" if value is None else unit, uses=uses)


def tell_roots(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: list[int]) -> None:
    """Natural frequencies in letters with their ratios of amplitudes, where the determinant factors so."""
    forms = about.problem.closed_forms
    modes = [mode for mode in (forms.modes if forms is not None else ()) if not (
        mode.unstable or mode.solves is not None or letters(mode.omega) > LONG)]
    if len(about.scene.q) == 3 and not found.G:
        uses = [*uses, *_factors(about, sheet, coefficients(about, found), [mode.omega for mode in modes], uses)]
    for mode in modes:
        letter = about.letter(sheet.letter(f"omega{mode.index}"))
        omega = _by_coefficients(about, found, mode)
        parts = [letter, " = ", omega]
        if mode.readable and not mode.turns:
            parts += [Words(",  "), *[part for name in about.scene.coordinates for part in (" : ", Name(name))][1:]]
            parts += [" = ", *[part for x in mode.shape for part in (" : ", x)][1:]]
        sheet.write(*parts, settles=f"omega[{mode.index}]", node=omega, uses=uses)


def _by_coefficients(about: AboutRest, found: SmallEquations, mode: "ClosedMode") -> "Node":
    """The frequency of a mode, of two by the formula of the roots where that is shorter."""
    if len(about.scene.q) != 2 or found.G or mode.index > 2:
        return cast("Node", mode.omega)
    a2, a1, a0 = coefficients(about, found)
    if a2.is_zero:
        return cast("Node", mode.omega)
    b1, b0 = about.tidy(a1 / a2), about.tidy(a0 / a2)
    spread = root(about.tidy(b1 * b1 - 4 * b0), about.samples)
    node = root(about.tidy((b1 - spread if mode.index == 1 else b1 + spread) / 2), about.samples)
    return node if letters(node) < letters(mode.omega) and about.same(node, mode.omega) else mode.omega


def _factors(about: AboutRest, sheet: WorkedSolution, known: "list[Node]", omegas: "Sequence[Node]",
             uses: list[int]) -> list[int]:
    """The line of a₃ω⁶ − a₂ω⁴ + a₁ω² − a₀ as a product, by a root that is rational in the letters; none without one."""
    a3, a2, a1, a0 = known
    for omega in omegas:
        root = about.tidy(omega ** 2)
        if root.is_zero or any(e.denominator > 1 for part in reachable([root]) if part.op == "product"
                               for _, e in part.args):
            continue
        b1 = about.tidy(a2 - a3 * root)
        b0 = about.tidy(a1 - b1 * root)
        if is_zero(a0 - b0 * root):
            square = about.letter(sheet.letter("omega")) ** 2
            rest = a3 * square ** 2 - b1 * square + b0
            return [sheet.write(Words("it factors:  "), Factor(square - root), "·", Factor(rest), " = 0",
                                settles="factors of det(K - omega^2*M)", uses=uses)]
    return []
