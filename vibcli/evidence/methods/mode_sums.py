"""Modal superposition as textbooks have it, with the lowest 1 … n undamped modes: what couples them in C is left out.

    p̈ᵣ + 2 ζᵣ ωᵣ ṗᵣ + ωᵣ² pᵣ = φᵣᵀ Q(t),   q = Σ φᵣ pᵣ,   2 ζᵣ ωᵣ = φᵣᵀ C φᵣ,

of loads Re Σ c e^{st}: pᵣ = Re Σ φᵣᵀc e^{st}/(s² + 2 ζᵣ ωᵣ s + ωᵣ²) and a free motion.
"""

from collections.abc import Iterable, Iterator
from functools import partial
from typing import Any

import numpy as np

from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """With 1 … n modes, where M and K are symmetric, nothing is gyroscopic, and loads are waves that last."""
    import scipy.linalg  # noqa: F401

    problem = subject.problem
    if problem.response.KIND != "small" or problem.configuration.linear_system.G:
        return
    forcing = problem.response.forcing()
    M, C, K = problem.response.matrices
    waves = forcing.pieces[0].waves
    plain = (K == K.T).all() and len(forcing.pieces) == 1 and not forcing.pieces[0].impulses
    if not plain or forcing.period is not None or any(wave.power for wave in waves):
        return
    for count in range(1, len(M) + 1):
        yield MethodRun("modal superposition", f"{count} mode{'s' * (count > 1)}",
                      partial(_sum, subject, (M, C, K), waves, count))


def _sum(subject: Subject, matrices: tuple[np.ndarray, ...], waves: Any, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    M, C, K = matrices
    plain, n = subject.data, len(M)
    squares, shapes = scipy.linalg.eigh(K, M)
    states = np.zeros((len(plain.times), 2 * n))
    for square, shape in zip(squares[:count], shapes.T[:count], strict=True):
        p, rate = _one(square, shape @ C @ shape, shape @ M @ plain.start[:n], shape @ M @ plain.start[n:],
                       [(shape[wave.channel] * wave.coefficient, wave.exponent) for wave in waves], plain.times)
        states[:, :n] += np.outer(p, shape)
        states[:, n:] += np.outer(rate, shape)
    return MethodAnswer([plain.read(states, plain.times)])


def _one(square: float, drag: float, place: float, speed: float, loads: Iterable[tuple[Any, Any]],
         times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(p, ṗ) at instants of p̈ + drag ṗ + square p = Re Σ c e^{st} from p, ṗ."""
    kept, rate = np.zeros(len(times), complex), np.zeros(len(times), complex)
    for c, s in loads:
        wave = c / (s * s + drag * s + square) * np.exp(s * times)
        kept, rate = kept + wave, rate + s * wave
    root = np.sqrt(complex(drag * drag - 4 * square))
    fast, slow = (-drag - root) / 2, (-drag + root) / 2
    x, v = place - kept[0].real, speed - rate[0].real
    a, b = (v - slow * x) / (fast - slow), (fast * x - v) / (fast - slow)
    free, its_rate = (a * fast**k * np.exp(fast * times) + b * slow**k * np.exp(slow * times) for k in (0, 1))
    return (kept + free).real, (rate + its_rate).real
