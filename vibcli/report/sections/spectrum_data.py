"""Natural frequencies, damping and mode shapes as plain data with the documented keys of --json."""

from collections.abc import Sequence
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.report.keys import Key, data
from vibcli.report.sections.equilibrium import EQUILIBRIUM
from vibcli.report.sections.shown_modes import in_letters, shown, shown_damped

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem

MODES = Key("modes", "a list: modes of the system without its dampers, by ascending omega, unstable ones first", each=(
    Key("index", "number of the mode, from 1"),
    Key("omega", "natural angular frequency; exactly 0 of a rigid mode, null of one that grows without oscillating"),
    Key("frequency", "omega/(2 pi), in Hz"),
    Key("period", "2 pi/omega; null of a rigid mode and where omega is null"),
    Key("growth_rate", "of an unstable mode, which grows as exp(growth_rate t), oscillating where omega is given too "
        "(flutter); negative of one that decays where there is G and K is not symmetric; else null"),
    Key("shape", "{coordinate: amplitude}, the first one that moves being 1 (see --normalise)"),
    Key("error", "bound of the relative error of omega and of growth_rate")))
DAMPED_MODES = Key(
    "damped", "a list by ascending |eigenvalue|, one entry to a conjugate pair; null where nothing damps", each=(
        Key("index", "number of the mode, from 1; two real eigenvalues of one over-damped mode share it"),
        Key("eigenvalue", "[re, im] of the eigenvalue, im ≥ 0: motion as exp(eigenvalue t)"),
        Key("omega", "|eigenvalue|; √(λ₁λ₂) of an over-damped mode"),
        Key("zeta", "damping ratio −re/|eigenvalue|; −(λ₁ + λ₂)/(2 omega) ≥ 1 of an over-damped mode; null of an "
            "unpaired real eigenvalue"),
        Key("omega_d", "damped angular frequency |im|; null where it does not oscillate"),
        Key("omega_d_where", "the condition under which omega_d counts where it is in letters; null in numbers"),
        Key("decay", "decay rate −re; −(λ₁ + λ₂)/2 of an over-damped mode"),
        Key("growth_rate", "growth rate re where it grows; else null"),
        Key("shape", "{coordinate: amplitude}, a number or [re, im]"),
        Key("error", "bound of the relative error of the eigenvalue")))
POLYNOMIAL = Key("characteristic_polynomial", "in letters only: factors in λ = omega² that have no readable roots")

WITHOUT_MATRICES = "what vibrates with distributed inertia has no matrices; the report has its equations and shapes"


def frequencies_data(problem: "Problem", normalise: str = "first",
                     digits: int | None = None, wanted: "Wanted | None" = None) -> dict[str, Any]:
    """What `vibcli frequencies --json` prints."""
    from vibcli.report.sections.equations_of_motion import MATRICES
    from vibcli.report.sections.statics import REACTIONS

    asked = "reactions" in problem.spec.get("find", ()) and not problem.numeric.has_free_symbols
    of_members = problem.numeric.has_free_symbols and bool(problem.scene.pieces)
    matrices = not (of_members or problem.modal.many)
    found = data((EQUILIBRIUM, *[MATRICES] * matrices, *[REACTIONS] * asked), problem)
    if problem.numeric.has_free_symbols:
        closed = _closed_forms(problem, wanted)
        found |= data((MODES, DAMPED_MODES, *[POLYNOMIAL] * (POLYNOMIAL.name in closed)), closed)
        return found | {"matrices": None, "remark": WITHOUT_MATRICES} if of_members else found
    if digits is None:
        still, modes = shown(problem, wanted), shown_damped(problem, wanted)
        found |= data((MODES, DAMPED_MODES), _modes(problem, still, modes, normalise, tau))
    else:
        still, told = _to_digits(problem, normalise, digits, wanted)
        found |= told
    return found if problem.modal.modes.finite else _with_counts(problem, found, still, normalise)


def _to_digits(problem: "Problem", normalise: str, digits: int,
               wanted: "Wanted") -> "tuple[Sequence[Mode], dict[str, Any]]":
    """(the modes shown, {modes, damped}) to so many digits."""
    import mpmath

    with mpmath.workdps(digits + 15):
        still, damped = problem.modal.modes_to(digits), problem.modal.damped_to(digits)
        still = shown(problem, wanted, still)
        modes = _modes(problem, still, shown_damped(problem, wanted, damped), normalise, 2 * mpmath.pi)
        return still, data((MODES, DAMPED_MODES), modes, digits)


def _with_counts(problem: "Problem", found: dict[str, Any], modes: "Sequence[Mode]", normalise: str) -> dict[str, Any]:
    """The same with the shapes of members and the count that proves the modes complete."""
    rows = found["modes"]
    if problem.scene.pieces:
        from vibcli.report.sections.member_modes import member_shapes

        rows = [row | {"members": member_shapes(problem, mode.index, normalise)}
                for row, mode in zip(found["modes"], modes, strict=True)]
    count = problem.modal.modes.counted_above(modes[-1]) if modes[-1].omega else None
    return found | {"matrices": None, "modes": rows, "count": count}


def _modes(problem: "Problem", modes: "Sequence[Mode]", damped: "Sequence[DampedMode] | None", normalise: str,
           turn: float) -> Any:
    """{modes, damped} in numbers."""
    def shape(mode: Any) -> "dict[str, Any]":
        return dict(zip(problem.scene.coordinates, problem.modal.shape(mode, normalise), strict=True))

    return {"modes": [MODES.row(
        mode.index, mode.omega, mode.omega and mode.omega / turn, turn / mode.omega if mode.omega else None,
        mode.growth_rate, shape(mode), float(mode.error)) for mode in modes],
        "damped": None if damped is None else [DAMPED_MODES.row(
            mode.index, [mode.eigenvalue.real, mode.eigenvalue.imag], mode.omega, mode.zeta, mode.omega_d, None,
            mode.decay, mode.growth_rate, shape(mode), float(mode.error)) for mode in damped]}


def _closed_forms(problem: "Problem", wanted: "Wanted | None") -> dict[str, Any]:
    """{modes, damped, characteristic_polynomial where there is one} in letters; None where no form is readable."""
    from vibcli.notation.scene_language import language

    forms, names, table = problem.closed_forms, problem.scene.coordinates, problem.scene.table
    if forms is None:
        return {"modes": None, "damped": None}
    turn, modes, damped = 2 * table.pi, [], []
    for mode in forms.modes if forms.numbered is None else in_letters(problem, wanted, forms):
        shape = dict(zip(names, mode.shape or [None] * len(names), strict=True))
        rates = (None, None, None, mode.omega) if mode.unstable else (
            mode.omega, mode.omega / turn, None if mode.omega.is_zero else mode.period, None)
        modes.append(MODES.row(mode.index, *rates, shape, mode.error))
        if mode.zeta is not None:
            damped.append(DAMPED_MODES.row(
                mode.index, None, mode.omega, mode.zeta, mode.omega_d, f"{language(mode.zeta)} < 1",
                mode.zeta * mode.omega, None, shape, 0.0))
    found: dict[str, Any] = {"modes": modes, "damped": damped or None}
    if forms.polynomials:
        square = table.parameter("omega") ** 2
        found[POLYNOMIAL.name] = [table.sum(*((c * square ** i, 1) for i, c in enumerate(reversed(polynomial))))
                                  for polynomial in forms.polynomials]
    return found
