"""Damped free vibration: (λ² M + λ (C + G) + K) x = 0.

In fixed point with a bound of every eigenvalue: modes without damping first, then the damping in them
(damped_in_modal_coordinates.py), or directly where coordinates without inertia are damped or K is not symmetric
(massless_coordinates.py, nonsymmetric.py). Larger systems (method.py) in floats (damped_large.py,
nonsymmetric_large.py).
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.certified_eigenvalues import FAINT, CertifiedEigenvalues
from vibcli.analyses.modal.damped_modes import DampedMode, collected
from vibcli.analyses.modal.method import ENCLOSED, IN_DIGITS, IN_FLOATS, SQUARES, choose, form_of
from vibcli.analyses.modal.mode_numbers import Digits, NearestFloats
from vibcli.analyses.modal.undamped import DIGITS, ENOUGH, ESCALATE, EVALUATED, EXACT, decimal, within_floats
from vibcli.numerics.precision import working_bits

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

GOAL = 160
WANTED = 60


def damped(elements: Any, precise: "Callable[..., FactoredSystem] | None" = None,
           exact: Callable[..., Any] | None = None, digits: int | None = None) -> list[DampedMode]:
    """The damped modes by ascending |λ|; None where nothing damps or turns (no C, no G) and K is symmetric.

    With neither C nor G the first of each ±λ alone is given.

    `precise(dps)` evaluates the elements to dps digits, `exact()` as Fractions (None where they are
    irrational); without either the floats are taken for exact. `digits`: this many correct digits, and
    numbers of mpmath.
    """
    if form_of(elements) == SQUARES:
        return None
    return within_floats(_damped, elements, precise, exact, digits)


def _damped(elements: "FactoredSystem", precise: "Callable[..., FactoredSystem] | None",
            exact: Callable[..., Any] | None, digits: int | None) -> list[DampedMode]:
    arithmetic = choose(elements, digits).arithmetic
    if arithmetic == IN_DIGITS:
        return damped_digits(elements, precise, exact, digits)
    if arithmetic == IN_FLOATS and elements.circulatory:
        from vibcli.analyses.modal.nonsymmetric_large import follower_floats

        return follower_floats(elements)
    if arithmetic != ENCLOSED:
        from vibcli.analyses.modal.damped_large import damped_floats

        modes = damped_floats(elements)
        if arithmetic == IN_FLOATS or all(mode.error <= ENOUGH and mode.bounds[0] <= FAINT for mode in modes):
            return modes
    data = _exactly(exact, elements)
    unit = EVALUATED if data is None and precise is not None else EXACT
    answer = CertifiedEigenvalues(elements, data or elements, GOAL, WANTED, unit)
    if unit > EXACT and not (answer.settled(math.log2(ESCALATE)) and answer.tells_parts()):
        answer = CertifiedEigenvalues(elements, precise(DIGITS), GOAL, WANTED, decimal(DIGITS))
    return collected(answer, NearestFloats, answer.shapes())


def damped_digits(elements: Any, precise: "Callable[[int], FactoredSystem]",
                  exact: "Callable[[], FactoredSystem | None]", digits: int) -> list[DampedMode]:
    """The damped modes to `digits` correct digits, in numbers of mpmath."""
    from vibcli.analyses.modal.damped_shapes_precise import shapes

    wanted = working_bits(digits)
    goal = GOAL + 2 * wanted
    if precise is None:
        answer = CertifiedEigenvalues(elements, _exactly(exact, elements) or elements, goal, wanted, EXACT)
    else:
        for guard in (30, 90, 270):
            dps = digits + guard
            answer = CertifiedEigenvalues(elements, precise(dps), goal, wanted, decimal(dps))
            if answer.settled(-digits * math.log2(10)):
                break
    return collected(answer, Digits, shapes(answer.system, answer.found, answer.scale))


def _exactly(exact: Callable[..., Any] | None, elements: "FactoredSystem") -> "FactoredSystem | None":
    """The data as Fractions, or None; on what K is not symmetric by, rounding has no part then."""
    data = exact() if exact is not None else None
    found: FactoredSystem | None = data.with_parts(K_size=None) if data is not None and elements.circulatory else data
    return found
