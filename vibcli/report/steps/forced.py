"""The steps from M q̈ + C q̇ + K q = Q(t) to what one degree of freedom does under its load: the steady state under
harmonics, one or several or those of a periodic wave, and the sum of the pieces of what begins and ends.

A load A sin Ωt + B cos Ωt keeps up X sin(Ωt + ε − θ), as (K − M Ω² + i C Ω) X e^{−iθ} = F with F = √(A² + B²).
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.from_the_start import KeptUp, tell_start
from vibcli.report.steps.lags import know_lag, lag_of, load_of, size_of, tell_phase, told_lag
from vibcli.report.steps.phasors import tell_of_one
from vibcli.report.steps.pieces import pieces_of, tell_impulses, tell_pieces
from vibcli.report.steps.resonance import is_resonance, tell_growing, tell_resonance
from vibcli.report.steps.step import number
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.analyses.closed_form.dimensionless import Dimensionless
    from vibcli.analyses.closed_form.steady_state import Steady
    from vibcli.symbolic.node import Node

SERIES = {"square": ("4/π·(", 2, 4), "sawtooth": ("−2/π·(", 1, -2)}      # of 2π: its factor, step of n, π·factor
TOLD = 3                # harmonics of a periodic wave that have numbers


def tell_forced(degree: Degree) -> None:
    """What a load keeps up, or its pieces bring about; nothing where that is not told."""
    from vibcli.analyses.closed_form.powers_of_time import are_powers
    from vibcli.analyses.closed_form.steady_state import waves_of_all

    load = degree.found.drive.get(0)
    if load is None or degree.problem.spec.in_full:
        return
    if are_powers(degree.problem.symbolic):
        _growing(degree)
        return
    try:
        found: dict[Any, Any] = {}
        for (argument, kind), node in waves_of_all(degree.problem.scene, {0: load})[0].items():
            found.setdefault(argument, {})[kind] = node
    except NotInLetters:
        _other(degree, load)
        return
    if len(found) == 1:
        (argument, parts), = found.items()
        if is_resonance(degree, argument):
            tell_resonance(degree, argument, parts)
        else:
            _one_harmonic(degree)
    elif found:
        for number, (argument, parts) in enumerate(found.items(), 1):
            if is_resonance(degree, argument):
                tell_growing(degree, argument, parts)
            else:
                _of_several(degree, number, argument, parts)


def _growing(degree: Degree) -> None:
    """What follows a load that is a power of the time."""
    try:
        node = degree.problem.symbolic_following(degree.name)
    except PhysicsError:
        return
    degree.sheet.write(Words("tried in the equation, the form of the load gives  "), Name(degree.name), " = ", node,
                       settles=f"following({degree.name})", node=node, uses=degree.found.lines)


def _one_harmonic(degree: Degree) -> None:
    """X and θ, from the complex equation."""
    try:
        steady = degree.problem.symbolic_steady_state(degree.name)
    except (NotInLetters, PhysicsError):
        return
    formula, table, sheet = steady.formula, degree.about.table, degree.sheet
    X, theta = (degree.about.letter(sheet.letter(letter)) for letter in ("X", "theta"))
    lags = not (formula.undamped or formula.ahead)
    wave = steady.wave if not formula.ahead else {"sin": "cos", "cos": "sin"}[steady.wave]
    node = X * table.call(wave, steady.argument - theta if lags else steady.argument)
    node = -node if formula.ahead and steady.wave == "cos" else node
    mean = [] if steady.mean is None or steady.mean.is_zero else [steady.mean, " + "]
    line = sheet.write(Words("steady state:  "), Name(degree.name), " = ", *mean, node, uses=degree.found.lines,
                       settles="steady state")
    lines = [line]
    if lags:
        _complex_equation(degree, X, steady)
    size = degree.about.tidy(formula.amplitude) if formula.undamped else formula.amplitude
    degree.settled([X], size, degree.unit, f"amplitude({degree.name})", lines)
    _by_ratio(degree, X, steady, lines)
    lag = lag_of(degree, steady) if lags else None
    if lags and formula.tangent is not None:
        lines.append(told_lag(degree, theta, steady, lag, lines))
        if lag is None:
            tell_phase(degree, theta, steady, lines)
        else:
            know_lag(degree, theta, steady, lag, lines)
    degree.about.know(X, degree.about.value(formula.amplitude))
    tell_of_one(degree.about, sheet, (X, None if lag is None else theta), steady, lines)
    if not formula.ahead:
        tell_start(degree, KeptUp(steady, X, theta if lags else None, lag), lines)


def _by_ratio(degree: Degree, X: "Node", steady: "Steady", lines: list[int]) -> None:
    """The same amplitude by r = Ω/ω and ζ, where it is a product of these."""
    from vibcli.analyses.closed_form.dimensionless import CONSTANT, SQUARE, dimensionless

    formula, table, sheet = steady.formula, degree.about.table, degree.sheet
    found = dimensionless(formula) if formula.Omega.op == "symbol" else _product(degree, steady)
    if found is None:
        return
    Omega = gradient(steady.argument)[degree.problem.scene.time]
    r, omega = degree.about.letter(sheet.letter("r")), degree.about.known_value(found.omega)
    turned = 2 * degree.zeta * r
    above = {CONSTANT: table.one, SQUARE: r ** 2}.get(found.above, table.sqrt(1 + turned ** 2))
    below = 1 - r ** 2 if found.zeta is None else table.sqrt((1 - r ** 2) ** 2 + turned ** 2)
    speed = degree.about.known_value(Omega)
    value = None if None in (omega, speed) else speed / omega
    gain = [] if found.gain.op == "number" and found.gain.coefficient == 1 else [Factor(found.gain)]
    over = ["/", Factor(below)] if gain and above is table.one else ["·"] * bool(gain) + [above / below]
    sheet.write(Words("or, with  "), r, " = ", Omega / degree.omega, *(() if value is None else number(value)),
                Words(":  "), X, " = ", *gain, *over, settles=r.name, node=Omega / degree.omega, value=value,
                letter=r.name, uses=lines)


def _product(degree: Degree, steady: "Steady") -> "Dimensionless | None":
    """The same of a frequency that is an expression: of a load F/K, of one proportional to Ω² by F/(MΩ²), and of a
    support that moves, whose load is K and iΩC times a place."""
    from vibcli.analyses.closed_form.dimensionless import BASE, CONSTANT, SQUARE, Dimensionless

    (A, B), Omega = load_of(degree, steady), gradient(steady.argument)[degree.problem.scene.time]
    shaken = not (A.is_zero or B.is_zero)
    unlike = shaken and (degree.C.is_zero or not is_zero(A * degree.C * Omega - B * degree.K))
    if unlike or (degree.C.is_zero and A.is_zero):
        return None
    F = A if degree.C.is_zero else size_of(B if A.is_zero else A)
    over = textbook(F / Omega ** 2)
    squared = not shaken and letters(over) < letters(F)
    gain = over / degree.M if squared else F / degree.K
    return Dimensionless(degree.about.tidy(gain), BASE if shaken else SQUARE if squared else CONSTANT, degree.root(
        degree.K / degree.M), None if degree.C.is_zero else degree.zeta)


def _complex_equation(degree: Degree, X: "Node", steady: "Steady") -> None:
    """Beside the last line (K − M Ω² + i C Ω) X e^{−iθ} = A + i B of a load A sin + B cos; B − i A where cosines are
    counted from."""
    Omega = steady.formula.Omega
    real, ahead = load_of(degree, steady)
    load: list[Any] = [real] if not real.is_zero or ahead.is_zero else []
    if not ahead.is_zero:
        negative = ahead.op != "sum" and ahead.coefficient < 0
        sign = (" − " if load else "−") if negative else " + " if load else ""
        load += [sign + "i·", Factor(-ahead if negative else ahead)]
    theta = degree.sheet.letter("theta")
    damps = [] if degree.C.is_zero else [" + i·", Factor(degree.C * Omega)]
    resists = ["(", degree.K - degree.M * Omega ** 2, *damps, ")·"]
    degree.sheet.write(Words("with complex amplitudes  "), *resists, X, "·exp(−i·", Name(theta), ") = ", *load,
                       settles="complex equation", uses=degree.found.lines, joined=True)


def _size(degree: Degree, parts: Any) -> "Node":
    return parts[0] if len(parts) == 1 else degree.root(single(textbook(degree.about.table.total([
        part ** 2 for part in parts]))))


def _resistance(degree: Degree, Omega: "Node") -> "Node":
    """√((K − M Ω²)² + C² Ω²); K − M Ω² where nothing damps."""
    resists: Node = degree.K - degree.M * Omega ** 2
    if degree.C.is_zero:
        return resists
    return degree.about.table.sqrt(resists ** 2 + degree.C ** 2 * Omega ** 2)


def _of_several(degree: Degree, number: int, argument: "Node", parts: "Mapping[str, Node]") -> None:
    """The amplitude and lag under one of several harmonics."""
    sheet, table = degree.sheet, degree.about.table
    Omega = gradient(argument)[degree.problem.scene.time]
    X, theta = (degree.about.letter(sheet.letter(f"{letter}{number}")) for letter in ("X", "theta"))
    force = _size(degree, list(parts.values()))
    wave = " and ".join(parts)
    line = degree.settled([Words(f"to {wave} of "), argument, Words(" belongs  "), X], force / _resistance(
        degree, Omega), degree.unit, f"amplitude {number}", degree.found.lines)
    if not degree.C.is_zero:
        degree.settled([Words("which lags by  "), table.call("tan", theta)],
                       degree.C * Omega / (degree.K - degree.M * Omega ** 2), "", f"tan theta{number}", [line])


def _other(degree: Degree, load: "Node") -> None:
    """What is no sum of harmonics: a periodic wave by its series, what begins and ends by its pieces."""
    wave = _periodic(degree, load)
    if wave is not None:
        _series(degree, *wave)
        return
    found = pieces_of(degree.problem.scene, load)
    if found is None:
        tell_impulses(degree)
    else:
        tell_pieces(degree, found)


def _periodic(degree: Degree, load: "Node") -> "tuple[str, Node, Node] | None":
    """(name of the wave, its argument, its factor) of F·square(Ωt) or F·sawtooth(Ωt) alone; else None."""
    atoms = [base for base, e in (load.args if load.op == "product" else ()) if base.op == "call" and e == 1
             and base.name in SERIES]
    if load.op == "call" and load.name in SERIES:
        return load.name, load.args[0], load.table.one
    if len(atoms) != 1:
        return None
    factor = textbook(load / atoms[0])
    return None if factor.mask else (atoms[0].name, atoms[0].args[0], factor)


def _series(degree: Degree, wave: str, argument: "Node", F: "Node") -> None:
    """F·square(Ωt) = F·4/π·(sin Ωt + sin 3Ωt/3 + …), and Xₙ of each."""
    sheet, table = degree.sheet, degree.about.table
    Omega = gradient(argument)[degree.problem.scene.time]
    head, step, factor = SERIES[wave]
    first = [table.call("sin", (1 + k * step) * argument) / (1 + k * step) for k in range(3)]
    series = sheet.write(f"{wave}(", argument, ") = " + head, first[0], " + ", first[1], " + ", first[2], " + …)",
                         settles=f"series of {wave}")
    n, X = degree.about.letter(sheet.letter("n")), sheet.letter("X", "n")
    force = F * factor / (table.pi * n)
    asked = {one.asked.text for one in degree.problem.spec.answers}
    orders = ", ".join(str(1 + k * step) for k in range(TOLD))
    general = sheet.write(Words("to its n-th harmonic belongs  "), Name(X), " = ", size_of(force) / _resistance(
        degree, n * Omega), Words(f",   n = {orders}, …"), settles=X, uses=[series, *degree.found.lines])
    for k in range(TOLD):
        order = table.number(1 + k * step)
        node = size_of(F * factor / (table.pi * order)) / _resistance(degree, order * Omega)
        letter: Any = degree.about.letter(sheet.letter(f"X{1 + k * step}"))
        quantity = f"harmonic[{1 + k * step}]({degree.name})"
        if degree.about.value(node) is not None or (quantity in asked and not degree.C.is_zero):
            degree.settled([letter], node, degree.unit, quantity, [general], letters=False, joined=k > 0)
