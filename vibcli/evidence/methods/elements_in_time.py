"""Members in 1 … 128 elements a piece in time: by all modes of these or a few, exactly, and step by step,

    q̇ₖ₊₁ = q̇ₖ + h (q̈ₖ + q̈ₖ₊₁)/2,      qₖ₊₁ = qₖ + h q̇ₖ + h² (q̈ₖ + q̈ₖ₊₁)/4      (Newmark 1959, β = 1/4, γ = 1/2)
"""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.meshed_members import MembersInTime, MeshInMotion, in_motion
from vibcli.evidence.methods.finite_elements import DIVISIONS, MOST, require_free
from vibcli.evidence.plain_equations import SAMPLES, extreme
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

FINEST = 64             # elements a piece, of which a few modes are taken
FEW = (1, 2, 4, 8, 16, 32)
STEPPED, STEPS = (8, 32), (100, 1000, 10_000, 100_000)
APART = 1e-5            # radians until the end, by which two roots of a mode differ at least


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Assembled beforehand; steps where time passes."""
    import scipy.linalg  # noqa: F401

    asked = subject.data
    if asked is None:
        return
    for divisions in DIVISIONS:
        mesh = in_motion(asked.members, divisions)
        if mesh is None or len(mesh.M) > MOST:
            break
        yield MethodRun("finite elements", f"{divisions} a piece", partial(_by_modes, asked, mesh, None))
        if divisions == FINEST:
            for count in FEW:
                yield MethodRun(f"modes of {divisions} elements a piece", f"{count} mode{'s' * (count > 1)}",
                                partial(_by_modes, asked, mesh, count))
        if divisions in STEPPED and asked.until:
            for steps in STEPS:
                yield MethodRun(f"Newmark of {divisions} elements a piece", f"{steps} steps",
                                partial(_by_steps, asked, mesh, steps))


def _read(asked: MembersInTime, times: np.ndarray, values: np.ndarray) -> MethodAnswer:
    """What is asked, by samples of the signal."""
    return MethodAnswer([float(values[-1]) if asked.feature == "value" else extreme(times, values, asked.feature)])


class FirstOrderModes(NamedTuple):
    """ż = λ z + Lᵀ f from `start` on, of which a signal is Σ seen z, and `at_once` f beside that."""

    rates: np.ndarray
    L: np.ndarray
    start: np.ndarray
    seen: np.ndarray
    at_once: np.ndarray

    def signal(self, loads: Sequence[tuple[float, dict[tuple[complex, int], np.ndarray]]],
               times: np.ndarray) -> np.ndarray:
        """Under loads, at instants."""
        found: np.ndarray = ((self.seen * self.start) @ np.exp(np.outer(self.rates, times))).real
        for instant, terms in loads:
            here = times >= instant
            s = times[here] - instant
            for (rate, power), vector in terms.items():
                found[here] += ((self.seen * (vector @ self.L)) @ _convolved(self.rates[:, None], rate, power, s)
                                + (self.at_once @ vector) * s**power * np.exp(rate * s)).real
        return found


def _convolved(own: np.ndarray, rate: complex, power: int, s: np.ndarray) -> np.ndarray:
    """∫₀ˢ e^{λ(s − τ)} τᵖ e^{μτ} dτ of λs."""
    apart, alike = rate - own, own == rate
    apart = np.where(alike, 1, apart)
    found = (np.exp(rate * s) - np.exp(own * s)) / apart
    for k in range(1, power + 1):
        found = (s**k * np.exp(rate * s) - k * found) / apart
    return np.where(alike, s ** (power + 1) / (power + 1) * np.exp(rate * s), found)


def _by_modes(asked: MembersInTime, mesh: MeshInMotion, count: int | None, _: Deadline) -> MethodAnswer:
    """By so many of the lowest modes, of which what couples them in C is left out, or by all."""
    require_free(mesh)
    times = np.array([asked.until]) if asked.feature == "value" else np.linspace(0.0, asked.until, SAMPLES)
    symmetric = (abs(mesh.K - mesh.K.T) <= 1e-12 * abs(mesh.K).max()).all()
    plain = symmetric and (asked.damping is not None or count is not None or not mesh.C.any())
    modes = _pairs(asked, mesh, count) if plain else _of_states(mesh)
    return _read(asked, times, modes.signal(mesh.loads, times) + mesh.beside(times))


def _pairs(asked: MembersInTime, mesh: MeshInMotion, count: int | None) -> FirstOrderModes:
    """Of undamped modes, two each: z = ṗ − λ′ p, λ′ the other root of λ² + c λ + ω² = 0."""
    squares, shapes, c = _undamped(asked, mesh, count)
    root = np.sqrt((c * c / 4 - squares).astype(complex))
    least = APART / (asked.until or 1.0)
    root = np.where(abs(root) < least, least, root)
    one, two = -c / 2 + root, -c / 2 - root
    q, v = (shapes.T @ mesh.M @ values for values in mesh.start)
    r, r_rate, r_twice = mesh.rows @ shapes
    seen = [sign * (r + x * (r_rate + x * r_twice)) / (2 * root) for sign, x in ((1, one), (-1, two))]
    return FirstOrderModes(np.concatenate([one, two]), np.hstack([shapes, shapes]),
                           np.concatenate([v - two * q, v - one * q]), np.concatenate(seen), shapes @ r_twice)


def _undamped(asked: MembersInTime, mesh: MeshInMotion, count: int | None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(ω², φ, c) of the lowest modes or all."""
    import scipy.linalg

    chosen = None if count is None else [0, min(count, len(mesh.M)) - 1]
    squares, shapes = scipy.linalg.eigh(mesh.K, mesh.M, subset_by_index=chosen)
    if asked.damping is None:
        return squares, shapes, np.einsum("ij,ij->j", shapes, mesh.C @ shapes)
    return squares, shapes, asked.damping.of(np.sqrt(np.maximum(squares, 0.0)), np.arange(len(squares)))


def _of_states(mesh: MeshInMotion) -> FirstOrderModes:
    """Of (q, q̇)."""
    n = len(mesh.M)
    inverse = np.linalg.inv(mesh.M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ mesh.K, -inverse @ mesh.C]])
    rates, V = np.linalg.eig(A)
    back = np.linalg.inv(V)
    r, r_rate, r_twice = mesh.rows
    seen = r @ V[:n] + r_rate @ V[n:] + rates * (r_twice @ V[n:])
    return FirstOrderModes(rates, (back[:, n:] @ inverse).T, back @ np.concatenate(mesh.start), seen,
                           inverse @ r_twice)


def _by_steps(asked: MembersInTime, mesh: MeshInMotion, steps: int, deadline: Deadline) -> MethodAnswer:
    require_free(mesh)
    times = np.linspace(0.0, asked.until, steps + 1)
    M, C, K, h = mesh.M, mesh.C, mesh.K, times[1]
    if asked.damping is not None:
        _, shapes, c = _undamped(asked, mesh, None)
        C = (M @ shapes * c) @ (M @ shapes).T
    vectors, weights = _weights(mesh, times)
    factor = np.linalg.inv(M + h / 2 * C + h * h / 4 * K)
    q, v = mesh.start
    a = np.linalg.solve(M, weights[0] @ vectors - C @ v - K @ q)
    found = np.empty(len(times))
    for k in range(len(times)):
        found[k] = mesh.rows[0] @ q + mesh.rows[1] @ v + mesh.rows[2] @ a
        if k == steps:
            break
        if not k & 255:
            deadline.check()
        v = v + h / 2 * a
        q = q + h * v - h * h / 4 * a
        a = factor @ (weights[k + 1] @ vectors - C @ v - K @ q)
        v, q = v + h / 2 * a, q + h * h / 4 * a
    return _read(asked, times, found + mesh.beside(times))


def _weights(mesh: MeshInMotion, times: np.ndarray) -> tuple[Any, Any]:
    """(vectors, what stands before each of them at every instant) of loads."""
    vectors, weights = [np.zeros(len(mesh.M))], [np.zeros(len(times))]
    for instant, terms in mesh.loads:
        s = np.maximum(times - instant, 0.0)
        for (rate, power), vector in terms.items():
            wave = np.where(times >= instant, s**power * np.exp(rate * s), 0.0)
            vectors += [vector.real, -vector.imag]
            weights += [wave.real, wave.imag]
    return np.array(vectors), np.array(weights).T
