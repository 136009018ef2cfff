"""What scenes that nothing holds answer to steady forces: H(0) = ∮ H(s) ds/(2πi s) around a circle that holds no other
pole, by the trapezoidal rule, whose error falls as a power of the radius (Trefethen & Weideman 2014); of a rigid motion
that is driven and seen the terms 1/s² and 1/s of the Laurent series are left."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis

NEAR, PLACES = 0.25, 32     # radius beside the next pole; places on a circle
ALIKE, SEEN = 1e-9, 1e-8    # of the largest H on a circle: how closely two agree; a term that is no rounding


class AtRest(NamedTuple):
    """H(0) and H′(0), whether there is a pole, and a bound of the error of H(0). At a pole value is what the Laurent
    series has besides (c, how far that may be off) of 1/s and 1/s², drift."""

    value: complex
    slope: complex
    resonant: bool
    error: float
    drift: tuple[tuple[complex, float], ...] = ()

    def of_rate(self, order: int) -> "AtRest":
        """Of sᵒʳᵈᵉʳ H beside a pole."""
        terms = [*[(0j, 0.0)] * order, *self.drift[::-1], (self.value, self.error)][:3]
        return AtRest(terms[2][0], 0.0, self.resonant, terms[2][1], (terms[1], terms[0]))


def next_to_zero(modal: "ModalAnalysis") -> float | None:
    """How far from 0 the next pole is where nothing holds the scene; None where that is held."""
    modes = modal.modes
    if not (any(mode.rigid for mode in modes) if modes.finite else modes.ground.rigid):
        return None
    found, damped = [float(mode.omega or mode.growth_rate or 0.0) for mode in modes.shown()], modal.damped
    if damped is not None:
        found = [abs(complex(mode.eigenvalue)) for mode in damped.first(len(found))]
    return min((size for size in found if size), default=1.0)


def at_rest(response: "FrequencyResponseFunction", next_pole: float,
            bound: Callable[[np.ndarray], float]) -> AtRest:
    """Of the output itself, `bound` giving the largest error of H around a circle; PhysicsError where two circles do
    not tell the same."""
    circles = [NEAR * next_pole * part * np.exp(2j * np.pi * (np.arange(PLACES) + 0.5) / PLACES) for part in (1, 0.5)]
    one, other = (response.at(s)[0] for s in circles)
    s, size = circles[0], float(np.abs(one).max())
    value, drift = one.mean(), [(one * s**k).mean() for k in (1, 2)]
    apart = float(abs(other.mean() - value))
    driven = any(abs(c) > SEEN * size * abs(s[0])**k for k, c in enumerate(drift, 1))
    if apart > ALIKE * size and not driven:
        raise PhysicsError("what this scene, which nothing holds, answers to steady forces is not found",
                           "hold it with a spring, or ask at a time")
    off = bound(s)
    value = value.real if abs(value.imag) <= apart + off else value
    if driven:
        return AtRest(value, 0.0, True, apart + off, tuple((c, off * abs(s[0])**k) for k, c in enumerate(drift, 1)))
    return AtRest(value, (one / s).mean(), False, apart + off)
