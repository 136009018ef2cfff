"""The steps of damping of several degrees of freedom: is it proportional, so that C M⁻¹ K is symmetric (Caughey &
O'Kelly 1965) and normal coordinates stay apart? Then the roots of det(λ²M + λ(C + G) + K) = 0."""

from typing import TYPE_CHECKING

from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, told

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def tell_damped(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: list[int]) -> None:
    """Whether modes stay apart, and the eigenvalues where there are numbers."""
    problem = about.problem
    of = {letter: sheet.matrix(letter) for letter in "MCGK" if getattr(found, letter)}
    if found.C and not found.G and proportional(problem.spec):
        uses = [*uses, *_proportional(about, sheet, found, of, uses)]
    damped = None if problem.numeric.has_free_symbols else problem.modal.damped
    if damped is None:
        return
    rates = [part for letter in "CG" if letter in of for part in (" + ", Name(of[letter]))][1:]
    head = ["det(λ²·", Name(of["M"]), " + λ·", *(["(", *rates, ")"] if len(rates) > 1 else rates), " + ", Name(of["K"]),
            ") = 0", Words(" has the roots")]
    if not proportional(problem.spec):
        head = [Words("`damping:` adds what damps each mode by itself:  "), "λ = −ζ·ω ± ω·√(1 − ζ²)·i"]
    line = sheet.write(*head, settles="det(lambda^2*M + lambda*C + K)", uses=uses)
    for mode in damped:
        value, parts = complex(mode.eigenvalue), []
        if value.imag:
            parts = [f" ± {told(abs(value.imag))}·i", Words(" 1/s,  "), f"ζ = {told(float(mode.zeta))}"]
        sheet.write(f"λ = {told(value.real)}", *(parts or [Words(" 1/s")]), uses=[line],
                    settles=f"eigenvalue[{mode.index}]")


def _proportional(about, sheet, found, of, uses):
    """The line on C M⁻¹ K of two degrees; none of more, and of a mass matrix that is not diagonal."""
    if not _is_simple(about, found):
        return []
    one, other = (_product(about, found, *pair) for pair in ((0, 1), (1, 0)))
    alike = about.same(one, other)
    words = "proportional, normal coordinates stay apart" if alike else "not proportional, modes are complex"
    P = sheet.matrix("P")
    of_what = [Words(f"damping: it is {words}, as the product of "), Name(of["C"]), Words(", the inverse of "),
               Name(of["M"]), Words(" and "), Name(of["K"]), Words(" has  ")]
    return [sheet.write(*of_what, f"{P}₁₂ = ", one, " = " if alike else " ≠ ", f"{P}₂₁", *([] if alike else [
        " = ", other]), settles="proportional", uses=uses)]


def _is_simple(about, found):
    return len(about.scene.q) == 2 and all(i == j for i, j in found.M) and len(found.M) == 2


def stay_apart(about: AboutRest, found: SmallEquations) -> bool:
    """Is the damping of two coordinates seen to be proportional, C M⁻¹ K being symmetric?"""
    return _is_simple(about, found) and about.same(*(_product(about, found, *pair) for pair in ((0, 1), (1, 0))))


def _product(about: AboutRest, found: SmallEquations, i: int, j: int) -> "Node":
    """(C M⁻¹ K)ᵢⱼ of a diagonal M."""
    zero = about.table.zero
    return about.tidy(about.table.total([found.C.get((i, k), zero) * found.K.get((k, j), zero) / found.M[k, k]
                                         for k in range(2)]))
