"""det(K − ω²M) = 0 of two and three degrees of freedom, written out by powers of ω², and its roots in letters.

    det(K − λM) = Σ (−λ)ᵏ aₖ,   aₖ = Σ det of K with k of its rows those of M

and of two with gyroscopic terms, where det(K + iωG − ω²M) has G₁₂² ω² less.
"""

from collections.abc import Sequence
from itertools import combinations, product
from typing import TYPE_CHECKING

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.nested_form import letters

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

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
    sums: list = [[] for _ in range(2 * n + 1)]
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
    sign = (-1) ** n
    turned = [" + i·", omega, "·", Name(sheet.matrix("G"))] if found.G else []
    head = sheet.write(*["−"] * (sign < 0), "det(", Name(of_K), *turned, " − ", omega ** 2, "·", Name(of_M), ") = ",
                       polynomial(names, omega), " = 0", settles="det(K - omega^2*M)", uses=uses)
    known = coefficients(about, found)
    lines = [head]
    for letter, node in zip(names, known, strict=True):
        value = about.value(node)
        shown = [] if value is not None and letters(node) > LONG else [" = ", node]
        more = () if value is None or node.op == "number" else number(value)
        lines.append(sheet.write(letter, *shown, *more, settles=letter.name, node=node, value=value, uses=uses))
    return names, known, lines


def tell_roots(about: AboutRest, sheet: WorkedSolution, uses: list[int]) -> None:
    """Natural frequencies in letters with their ratios of amplitudes, where the determinant factors so."""
    forms = about.problem.closed_forms
    for mode in forms.modes if forms is not None else ():
        if mode.unstable or mode.solves is not None or letters(mode.omega) > LONG:
            continue
        letter = about.letter(sheet.letter(f"omega{mode.index}"))
        parts = [letter, " = ", mode.omega]
        if mode.readable and not mode.turns:
            parts += [Words(",  "), *[part for name in about.scene.coordinates for part in (" : ", Name(name))][1:]]
            parts += [" = ", *[part for x in mode.shape for part in (" : ", x)][1:]]
        sheet.write(*parts, settles=f"omega[{mode.index}]", node=mode.omega, uses=uses)
