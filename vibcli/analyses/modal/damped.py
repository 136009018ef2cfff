"""Damped free vibration: (λ² M + λ (C + G) + K) x = 0.

In fixed point with a bound of every eigenvalue: modes without damping first, then the damping in them
(damped_in_modal_coordinates.py), or directly where coordinates without inertia are damped or K is not symmetric
(massless_coordinates.py, nonsymmetric.py). Larger systems (method.py) in floats (damped_large.py,
nonsymmetric_large.py).
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import ModalDamping
from vibcli.analyses.modal.damped_modes import DampedMode, collected
from vibcli.analyses.modal.method import (
    ENCLOSED,
    FIRST_ORDER,
    FOLLOWER,
    IN_DIGITS,
    IN_FLOATS,
    SQUARES,
    choose,
    damped_at_all,
    dragged,
    form_of,
)
from vibcli.analyses.modal.mode_numbers import Digits, NearestFloats, in_units
from vibcli.analyses.modal.rigid_body_modes import undamped_rigid
from vibcli.analyses.modal.scaling import Scaling, exponent
from vibcli.analyses.modal.undamped import DIGITS, ENOUGH, ESCALATE, EVALUATED, EXACT, decimal, prepared, within_floats
from vibcli.analyses.modal.undamped_certified import enclosed, spread
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.precision import working_bits

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

GOAL = 160
WANTED = 60
FAINT = 1e-9        # relative bound of Re λ and Im λ, above which weak damping is found in more digits
TRIES = 4
FARTHEST = 2000


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


def depth(elements: Any, scale: Scaling) -> tuple[int, int]:
    """Bits that soft springs and strong damping, and that very weak damping need besides."""
    p, sizes = scale.coordinates, [0]
    for weight, row in elements.dampers:
        felt = [exponent(x) + p[i] for i, x in row.items() if x]
        if weight and felt:
            sizes.append(exponent(weight) - scale.damping + 2 * max(felt))
    for (i, j), x in (*elements.C.items(), *elements.G.items()):
        if x:
            sizes.append(exponent(x) - scale.damping + p[i] + p[j])
    return spread(elements, scale) + max(0, 3 * max(sizes)), max(0, -min(sizes) - 40)


class CertifiedEigenvalues:
    """The eigenvalues of `data`, which is `elements` in any arithmetic, with their bounds.

    system: ModalDamping, MassiveSystem or Follower, which hold the basis of the vectors; unit: log2 of
    the relative rounding of the data; undamped: nothing depends on velocities but G; conservative: and K is symmetric;
    follower: nothing depends on velocities, and K is not symmetric.
    """

    system: Any

    __slots__ = ("conservative", "decided", "follower", "found", "scale", "system", "undamped")

    def __init__(self, elements: Any, data: Any, goal: Any, wanted: int, unit: float) -> None:
        form, follows, held = form_of(elements), elements.circulatory, bool(dragged(elements))
        self.undamped = not damped_at_all(elements)
        self.conservative, self.follower = self.undamped and not follows, form == FOLLOWER
        self.scale, zeros = prepared(elements, held)
        self.decided = zeros is not None
        if held:
            double = undamped_rigid(elements, zeros, data)
            zeros = None if double is None else zeros + double
        strong, weak = depth(elements, self.scale)
        goal, deep = goal + strong + weak, goal - 50 + weak
        for _ in range(TRIES):
            if form == FOLLOWER:
                from vibcli.analyses.modal.nonsymmetric import Follower

                self.system = Follower(data, self.scale, None, goal, deep)
            elif form == FIRST_ORDER:
                from vibcli.analyses.modal.massless_coordinates import MassiveSystem

                self.system = MassiveSystem(data, self.scale, zeros, goal, deep)
            else:
                self.system = self._modal(elements, data, goal, deep, zeros, unit)
            self.found = self.system.eigenvalues(wanted)
            missing = self.worst() + wanted
            if missing <= 0:
                break
            goal += 2 * math.ceil(min(missing, FARTHEST)) + 20
        if self.follower and (unit > EXACT or data.K_size):
            self.found = self.system.rounded(data, self.scale, unit)
        elif unit > EXACT or data.K_size:
            from vibcli.analyses.modal.rounding import with_data_error

            self.found = with_data_error(self.found, self.system, data, self.scale, unit)
        if follows:
            from vibcli.analyses.modal.nonsymmetric import rested

            self.found = rested(self.found, self.system.bits)
            self.decided = all(d.re or d.im for d in self.found)

    def _modal(self, elements: "FactoredSystem", data: "FactoredSystem", goal: int, deep: int, zeros: int | None,
               unit: float) -> ModalDamping:
        answer = enclosed(data, self.scale, zeros, goal=goal)
        if unit > EXACT or data.K_size:
            answer.add_data_error(data, self.scale, unit)
        self.decided = zeros is not None or not answer.zero.any()
        still = undamped_rigid(elements, zeros, data)
        return ModalDamping(answer, data, self.scale, still, goal, deep)

    def worst(self) -> float:
        """log2 of the largest relative bound of an eigenvalue; under follower forces of each of its parts."""
        bits, moving = self.system.bits, [d for d in self.found if d.re or d.im]
        sizes = [fx.log2(math.isqrt(d.re * d.re + d.im * d.im), bits) for d in moving]
        if self.follower:
            sizes = [fx.log2(min(part for part in (d.re, d.im) if part), bits) for d in moving]
        return max((d.radius - size for d, size in zip(moving, sizes, strict=True)), default=-math.inf)

    def settled(self, goal: float) -> bool:
        """Whether every eigenvalue is known to 2^goal and every zero follows from the structure."""
        return self.decided and self.worst() <= goal

    def tells_parts(self) -> bool:
        """Are both parts of every eigenvalue known to FAINT, where something damps?"""
        return self.undamped or all(d.radius <= fx.magnitude(abs(part), self.system.bits) + math.log2(FAINT)
                                    for d in self.found if d.im for part in (d.re, d.im) if part)

    def shapes(self) -> np.ndarray:
        """The vectors in all coordinates, a column for each eigenvalue, their largest component real."""
        basis = in_units(fx.floats(self.system.basis, self.system.bits), self.scale)[1]
        out = basis @ np.array([d.x for d in self.found]).T
        lead = out[np.argmax(np.abs(out), axis=0), range(out.shape[1])]
        return np.asarray(out * np.where(lead == 0, 1.0, np.abs(lead) / np.where(lead == 0, 1.0, lead)))
