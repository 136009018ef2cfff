"""The lag of the steady state of one degree of freedom, from (R + iS) X e^{−iθ} = A + iB."""

from cmath import phase
from math import cos
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.step import number
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.steady_state import Steady
    from vibcli.symbolic.node import Node

QUARTER = 1e-12         # of the cosine of a lag: it is a quarter of a turn
LONG = 24               # letters of its tangent, beyond which the parts have letters


def told_lag(degree: Degree, theta: "Node", steady: "Steady", lag: float | None, lines: list[int]) -> int:
    """Write down tan θ, and θ; θ alone where it is a quarter of a turn, but for rounding."""
    formula = steady.formula
    if lag is not None and abs(cos(lag)) <= QUARTER:
        resists = degree.K - degree.M * formula.Omega ** 2
        return degree.sheet.write(resists, " = 0", Words(":  "), theta, *number(lag, "rad"), uses=lines,
                                  settles="quarter of a turn", value=lag, unit="rad")
    more = [] if lag is None else [Words(",  "), theta, *number(lag, "rad")]
    tangent, lines = (_by_parts(degree, steady, lines) if letters(formula.tangent) > LONG else None) or (
        formula.tangent, lines)
    return degree.settled([theta.table.call("tan", theta)], tangent, "", "tan theta", lines, more=more)


def _by_parts(degree: Degree, steady: "Steady", uses: list[int]) -> "tuple[Node, list[int]] | None":
    """(tan θ of a load A + iB that is resisted by R + iS, the line that tells these); None where one of them is
    zero."""
    about, sheet, found = degree.about, degree.sheet, list[Any]()
    nodes = [degree.K - degree.M * steady.formula.Omega ** 2, degree.C * steady.formula.Omega, *load_of(degree, steady)]
    if any(node.is_zero for node in nodes):
        return None
    force, stiffness = ("N", "N/m") if degree.unit == "m" else ("N·m", "N·m/rad")
    names = [sheet.letter("R"), sheet.letter("S"), sheet.letter("F", "re"), sheet.letter("F", "im")]
    for name, node, of in zip(names, nodes, (stiffness, stiffness, force, force), strict=True):
        letter, value = about.letter(name), about.value(node)
        unit = "" if value is None else of
        line = sheet.write(*([] if found else [Words("with  ")]), letter, " = ", node,
                           *(() if value is None else number(value, unit)), settles=letter.name, node=node, value=value,
                           unit=unit, letter=letter.name, uses=uses, joined=bool(found))
        about.know(letter, value)
        found.append(letter)
    R, S, A, B = found
    return (A * S - B * R) / (A * R + B * S), [line]


def know_lag(degree: Degree, theta: "Node", steady: "Steady", lag: float, lines: list[int]) -> None:
    """Let the last line tell the letter of the lag in numbers."""
    degree.sheet.write(settles=theta.name, node=_angle(degree, steady), value=lag, unit="rad", letter=theta.name,
                       joined=True, uses=lines)
    degree.about.know(theta, lag)


def _angle(degree: Degree, steady: "Steady") -> "Node":
    """θ = arg((R + iS)/(A + iB)), without the size of a load that is a sine or a cosine alone, or whose parts have a
    ratio in numbers."""
    (real, ahead), Omega = load_of(degree, steady), steady.formula.Omega
    size = size_of(ahead if real.is_zero else real)
    of = [textbook(part / size) for part in (real, ahead)]
    if all(map(is_number, of)) and degree.about.table.is_positive(size):
        real, ahead = of
    R, S = degree.K - degree.M * Omega ** 2, degree.C * Omega
    return degree.about.table.call("atan2", S * real - R * ahead, R * real + S * ahead)


def tell_phase(degree: Degree, theta: "Node", steady: "Steady", lines: list[int]) -> None:
    """Write down the line of the phase of the coordinate that a sheet asks in letters, where it is θ."""
    for asked in [one.asked for one in degree.problem.spec.answers if one.asked.text == f"phase({degree.name})"]:
        tell_found(degree.problem, degree.sheet, asked, [(_angle(degree, steady), [theta])], lines)


def lag_of(degree: Degree, steady: "Steady") -> float | None:
    """θ in numbers, None in letters; between −π and π, which its tangent leaves open."""
    Omega = steady.formula.Omega
    nodes = (*load_of(degree, steady), degree.K - degree.M * Omega ** 2, degree.C * Omega)
    parts = [degree.about.value(node) for node in nodes]
    if None in parts:
        return None
    real, ahead, resists, damps = parts
    return -phase(complex(real, ahead) / complex(resists, damps))


def load_of(degree: Degree, steady: "Steady") -> "tuple[Node, Node]":
    """(A, B) of a load A sin + B cos, (B, −A) where cosines are counted from."""
    from vibcli.analyses.closed_form.steady_state import waves_of_all

    zero = degree.about.table.zero
    acting = waves_of_all(degree.problem.scene, {0: degree.found.drive[0]})[0]
    found = {kind: node for (_, kind), node in acting.items()}
    A, B = (textbook(found.get(kind, zero)) for kind in ("sin", "cos"))
    return (A, B) if steady.wave == "sin" else (B, -A)


def size_of(node: "Node") -> "Node":
    """A coefficient without its sign."""
    return -node if node.op != "sum" and node.coefficient < 0 else node
