"""H(s) as the sum of some of its modes, Σ R/(s − λ) + R̄/(s − λ̄), and of what moves freely.

Each residue R is that of H itself, (1/2πi) ∮ H ds about its pole.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

POINTS, SHARE = 24, 0.25        # of a circle, and its radius over the distance of the next pole
ONE = 1e-6          # relative distance of poles that count as one
FAR = 2.0**12       # times as far as modes are shown


def by_modes(response: "FrequencyResponseFunction", count: int, Omega: float) -> complex:
    """H(iΩ) of so many modes that oscillate, and of free motions."""
    poles, following = _lowest(response, count)
    s = 1j * Omega
    total = _free(response, poles[:1], s)
    for number, pole in enumerate(poles):
        others = np.append(np.delete(poles, number), [following, 0.0, np.conj(pole)])
        residue = _around(response, pole, SHARE * np.abs(others - pole).min())[0]
        total += residue / (s - pole) + np.conj(residue) / (s - np.conj(pole))
    return complex(total * s**response.order)


def _lowest(response: "FrequencyResponseFunction", count: int) -> tuple[np.ndarray, complex]:
    """(so many poles above the axis Im s = 0, the one that follows, or as far away)."""
    end = response.end
    found = _different(response.poles(0.0, end))
    while len(found) <= count and np.isfinite(end) and end < FAR * response.end:
        end *= 2
        found = _different(response.poles(0.0, end))
    if len(found) < count:
        raise PhysicsError(f"this frequency response has {len(found)} modes that oscillate", "ask for fewer")
    return found[:count], found[count] if len(found) > count else 4 * found[-1]


def _different(poles: np.ndarray) -> np.ndarray:
    """Those above the real axis, ascending, close ones as one."""
    poles = np.sort_complex(poles[poles.imag > ONE * np.abs(poles)] / 1j) * 1j
    apart = np.append(True, np.abs(np.diff(poles)) > ONE * np.abs(poles[1:])) if len(poles) else np.zeros(0, bool)
    found: np.ndarray = poles[apart]
    return found


def _around(response: "FrequencyResponseFunction", centre: complex, radius: float) -> tuple[complex, complex]:
    """The coefficients of 1/(s − centre) and 1/(s − centre)² of H."""
    turn = radius * np.exp(2j * np.pi * (np.arange(POINTS) + 0.5) / POINTS)
    values = response.at(centre + turn)[0]
    return complex(np.mean(values * turn)), complex(np.mean(values * turn**2))


def _free(response: "FrequencyResponseFunction", first: np.ndarray, s: complex) -> complex:
    """What moves freely adds: A/s² + B/s; rounding where nothing does."""
    radius = SHARE * (abs(first[0]) if len(first) else response.pace)
    B, A = _around(response, 0j, radius)
    size = np.abs(response.at(np.array([radius + 0j]))[0][0])
    A, B = (0.0 if abs(x) < 1e-10 * size * radius**power else x for power, x in ((2, A), (1, B)))
    return (A / s + B) / s if A or B else 0j
