"""The steps of damping of several degrees of freedom: is it proportional, so that C M⁻¹ K is symmetric (Caughey &
O'Kelly 1965) and normal coordinates stay apart? Then the roots of det(λ²M + λ(C + G) + K) = 0."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.characteristic import damped_coefficients, tell_coefficient
from vibcli.report.steps.damped_shapes import tell_damped_shapes
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, told

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

DETERMINANT = "det(lambda^2*M + lambda*C + K)"
MOST = 3            # coordinates, beyond which the determinant is not multiplied out


def tell_damped(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: list[int]) -> None:
    """Whether modes stay apart, and the eigenvalues where there are numbers."""
    problem = about.problem
    of = {letter: sheet.matrix(letter) for letter in "MCGK" if getattr(found, letter)}
    if found.C and found.K and not found.G and proportional(problem.spec):
        uses = [*uses, *_proportional(about, sheet, found, of, uses)]
    damped = None if problem.numeric.has_free_symbols else problem.modal.damped
    if damped is None:
        return
    rates = [part for letter in "CG" if letter in of for part in (" + ", Name(of[letter]))][1:]
    head = ["det(λ²·", Name(of["M"]), " + λ·", *(["(", *rates, ")"] if len(rates) > 1 else rates),
            *([" + ", Name(of["K"])] if "K" in of else []), ")"]
    if not proportional(problem.spec):
        lines, polynomial = [sheet.write(Words("`damping:` adds what damps each mode by itself:  "),
                                       "λ = −ζ·ω ± ω·√(1 − ζ²)·i", settles=DETERMINANT, uses=uses)], None
    elif len(about.scene.q) > MOST:
        lines, polynomial = [sheet.write(*head, " = 0", Words(" has the roots"), settles=DETERMINANT, uses=uses)], None
    else:
        lines, polynomial = _polynomial(about, sheet, found, head, uses)
    again = _again(damped, polynomial)
    for mode in damped:
        value = complex(mode.eigenvalue)
        if value.imag:
            _tell_pair(about, sheet, mode, lines, polynomial)
        else:
            order, again = (again, "") if not value else ("", again)
            sheet.write(f"λ = {told(value.real)}", Words(f" 1/s{order}"), uses=lines,
                        settles=f"eigenvalue[{mode.index}]")
    if polynomial is not None:
        tell_damped_shapes(about, sheet, found, lines)


def _again(damped: "Modes", polynomial: "Sequence[Node]") -> str:
    """What is said where λ = 0 is first told, of more such roots than modes: of these λ² comes out of the
    determinant."""
    powers = [] if polynomial is None else [i for i, part in enumerate(reversed(polynomial)) if not part.is_zero]
    if not powers or powers[0] <= sum(not complex(mode.eigenvalue) for mode in damped):
        return ""
    return ", a double root" if powers[0] == 2 else f", a root of order {powers[0]}"


def _polynomial(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, head: Sequence[Any],
                uses: list[int]) -> "tuple[list[int], list[Node]]":
    """Write down the determinant by powers of λ and its coefficients: (the numbers of the lines, the letters of the
    coefficients from the highest power on)."""
    known = damped_coefficients(about, found)
    names = [about.letter(sheet.letter(f"c{power}")) for power in range(len(known) - 1, -1, -1)]
    here = [(name, node) for name, node in zip(names, known, strict=True) if not node.is_zero]
    powers = about.table.total([name * about.letter(sheet.letter("lambda")) ** power for power, name in zip(
        range(len(known) - 1, -1, -1), names, strict=True) if name in dict(here)])
    lines = [sheet.write(*head, " = ", powers, " = 0", settles=DETERMINANT, uses=uses)]
    lines += [tell_coefficient(about, sheet, (name, node), len(known) - 1 - i, uses)
              for i, (name, node) in enumerate(zip(names, known, strict=True)) if not node.is_zero]
    return lines, [name if name in dict(here) else about.table.zero for name in names]


def _tell_pair(about: AboutRest, sheet: WorkedSolution, mode: "DampedMode", lines: list[int],
               polynomial: "list[Node]") -> None:
    """λ = −δ ± iω_d and ζ; each vanishing with the real and the imaginary part of the polynomial."""
    value, table, k = complex(mode.eigenvalue), about.table, mode.index
    real = f"{told(value.real)} " if value.real else ""
    sheet.write(f"λ = {real}±{' ' * bool(real)}{told(abs(value.imag))}·i", Words(" 1/s"), uses=lines,
                settles=f"eigenvalue[{k}]")
    delta, omega_d = (about.letter(sheet.letter(f"{name}{k}")) for name in ("delta", "omega_d"))
    parts = [None, None] if polynomial is None else _at(table, polynomial, -delta, omega_d)
    for name, letter, size, part in (("decay", delta, -value.real, parts[0]),
                                     ("omega_d", omega_d, abs(value.imag), parts[1])):
        sheet.write(settles=f"{name}[{k}]", value=size, unit="1/s" if name == "decay" else "rad/s", uses=lines,
                    letter=letter.name, vanishes=part, joined=True)
    sheet.write(f"ζ = {told(float(mode.zeta))}", settles=f"zeta[{k}]", node=delta / table.sqrt(delta**2 + omega_d**2),
                value=float(mode.zeta), uses=lines, joined=True)


def _at(table: "Table", polynomial: "Sequence[Node]", x: "Node", y: "Node") -> "list[Node]":
    """[real part, imaginary part] of a polynomial at x + iy."""
    real = imaginary = table.zero
    for coefficient in polynomial:
        real, imaginary = real * x - imaginary * y + coefficient, real * y + imaginary * x
    return [real, imaginary]


def _proportional(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, of: Mapping[str, str],
                  uses: list[int]) -> list[int]:
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


def _is_simple(about: AboutRest, found: SmallEquations) -> bool:
    return len(about.scene.q) == 2 and all(i == j for i, j in found.M) and len(found.M) == 2


def stay_apart(about: AboutRest, found: SmallEquations) -> bool:
    """Is the damping of two coordinates seen to be proportional, C M⁻¹ K being symmetric?"""
    return _is_simple(about, found) and about.same(*(_product(about, found, *pair) for pair in ((0, 1), (1, 0))))


def _product(about: AboutRest, found: SmallEquations, i: int, j: int) -> "Node":
    """(C M⁻¹ K)ᵢⱼ of a diagonal M."""
    zero = about.table.zero
    return about.tidy(about.table.total([found.C.get((i, k), zero) * found.K.get((k, j), zero) / found.M[k, k]
                                         for k in range(2)]))
