"""H(iΩ) at many frequencies, each to the rounding that the condition of K − Ω²M + iΩC allows.

Few degrees of freedom, or few frequencies: LU of every matrix (direct.py); else a method of large_systems.py.
"""

from typing import Any

import numpy as np

from vibcli.analyses.frequency_response.direct import direct
from vibcli.base.errors import PhysicsError

WORK = 2e8      # elimination of so many frequencies by LU is not worth a search for a faster method


def frf(system: Any, Omega: float | np.ndarray) -> np.ndarray:
    """H(iΩ) of a TransferFunction, complex; PhysicsError where a frequency is that of a pole."""
    values, resonant = sampled(system, Omega)
    if resonant.any():
        Omega = float(np.ravel(Omega)[np.ravel(resonant)][0])
        raise PhysicsError(f"the input drives an undamped mode at its natural frequency, {Omega:.6g} rad/s: its "
                           "amplitude grows without bound", "add damping, or ask at another frequency")
    return values


def sampled(system: Any, Omega: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(H, whether there is a pole) at each frequency; H is 0 at poles."""
    values, _, resonant = _at(system, Omega, False)
    return values, resonant


def sloped(system: Any, Omega: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(H, dH/ds, whether there is a pole) at each frequency; both are 0 at poles."""
    return _at(system, Omega, True)


def _at(system, Omega, steep):
    shape = np.shape(Omega)
    s = 1j * np.atleast_1d(np.asarray(Omega, dtype=float)).ravel()
    values, slopes, resonant = undifferentiated(system, s, steep)
    if system.order:
        power = s**(system.order - 1)
        values, slopes = values * power * s, slopes * power * s + system.order * power * values if steep else None
    parts = [np.where(resonant, 0.0, part).reshape(shape) if part is not None else None for part in (values, slopes)]
    return *parts, resonant.reshape(shape)


def undifferentiated(system: Any, s: np.ndarray,
                     steep: bool = False) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    """(H, dH/ds or None, whether there is a pole) of the output itself at complex s; the method for many is found once
    and kept with the system."""
    if system.evaluated_by() is None and len(s) * system.n**3 <= WORK:
        return direct(system, s, steep)
    from vibcli.analyses.frequency_response.large_systems import chosen

    return system.evaluated_by(lambda system: chosen(system) or direct)(system, s, steep)
