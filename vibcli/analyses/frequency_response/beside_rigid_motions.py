"""What members that nothing holds answer to steady forces: H(0) = ∮ H(s) ds/(2πi s) around a circle that holds no other
pole, by the trapezoidal rule, whose error falls as a power of the radius (Trefethen & Weideman 2014); of a rigid motion
that is driven and seen the terms 1/s² and 1/s of the Laurent series are left."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.member_errors import of_value_at
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.member_response import MemberTransfer

NEAR, PLACES = 0.25, 32     # radius beside the next pole; places on a circle
ALIKE, SEEN = 1e-9, 1e-8    # of the largest H on a circle: how closely two agree; a term that is no rounding


class AtRest(NamedTuple):
    """H(0) and H′(0), whether there is a pole, and a bound of the error of H(0)."""

    value: complex
    slope: complex
    resonant: bool
    error: float


def at_rest(response: "MemberTransfer", next_pole: float) -> AtRest:
    """Of the output itself; PhysicsError where two circles do not tell the same."""
    circles = [NEAR * next_pole * part * np.exp(2j * np.pi * (np.arange(PLACES) + 0.5) / PLACES) for part in (1, 0.5)]
    one, other = (response.at(s)[0] for s in circles)
    s, size = circles[0], float(np.abs(one).max())
    value, driven = one.mean(), max(abs((one * s**k).mean()) / abs(s[0])**k for k in (1, 2))
    if driven > SEEN * size:
        return AtRest(0.0, 0.0, True, 0.0)
    apart = float(abs(other.mean() - value))
    if apart > ALIKE * size:
        raise PhysicsError("what these members, which nothing holds, answer to steady forces is not found",
                           "hold them with a spring, or ask at a time")
    error = apart + max(of_value_at(response, complex(at)) for at in s[:PLACES // 2])
    return AtRest(value.real if abs(value.imag) <= error else value, (one / s).mean(), False, error)
