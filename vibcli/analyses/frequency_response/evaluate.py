"""H(iΩ) of a FrequencyResponseFunction at many frequencies, differentiated as often as its order says."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction


def frf(system: "FrequencyResponseFunction", Omega: float | np.ndarray) -> np.ndarray:
    """H(iΩ), complex; PhysicsError where a frequency is that of a pole."""
    values, resonant = sampled(system, Omega)
    if resonant.any():
        Omega = float(np.ravel(Omega)[np.ravel(resonant)][0])
        if not Omega:
            raise PhysicsError("a steady input drives a motion that nothing holds: its amplitude grows without bound",
                               "hold it with a spring, or ask at another frequency")
        raise PhysicsError(f"the input drives an undamped mode at its natural frequency, {Omega:.6g} rad/s: its "
                           "amplitude grows without bound", "add damping, or ask at another frequency")
    return values


def sampled(system: "FrequencyResponseFunction", Omega: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(H, whether there is a pole) at each frequency; H is 0 at poles."""
    values, _, resonant = _at(system, Omega, False)
    return values, resonant


def sloped(system: "FrequencyResponseFunction", Omega: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(H, dH/ds, whether there is a pole) at each frequency; both are 0 at poles."""
    return _at(system, Omega, True)


def _at(system: "FrequencyResponseFunction", Omega: float | np.ndarray,
        steep: bool) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    shape = np.shape(Omega)
    s = 1j * np.atleast_1d(np.asarray(Omega, dtype=float)).ravel()
    values, slopes, resonant = system.at(s, steep)
    if system.order:
        power = s**(system.order - 1)
        values, slopes = values * power * s, slopes * power * s + system.order * power * values if steep else None
    values, slopes = (np.where(resonant, 0.0, part).reshape(shape) if part is not None else None
                      for part in (values, slopes))
    return values, slopes, resonant.reshape(shape)

