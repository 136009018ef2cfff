"""First-order bounds of the errors of a steady state: of its phasors, and of what it starts from.

    D Q = F, D = s² M + s C + K:      |δQ| <= |D⁻¹| (|δF| + |δD| |Q| + |2 s M + C| |Q| |δs| + rounding of D and of D Q)
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.data_errors import DATA
from vibcli.analyses.transient.following import errors_of, moves_freely

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.analyses.transient.linear_response import LinearMotion, SteadyMotion

EPSILON = 2.0**-52


def of_phasor(matrices: Sequence[np.ndarray], data: "DataErrors", s: complex, Q: np.ndarray,
              F: np.ndarray, off: np.ndarray | float = 0.0) -> np.ndarray:
    """|δQ| of a phasor under the forces F, which are `off` beside a rounding; matrices: M, C, K."""
    M, C, K = matrices
    n, size, large = len(M), np.abs(Q), abs(s)
    missed = 4 * DATA * np.abs(F) + off
    for k, ((weights, rows), entries) in enumerate(zip(data.weights, data.entries, strict=True)):
        missed += large**k * (np.abs(rows).T @ (weights * np.abs(rows @ Q)) + entries @ size)
    missed += (n + 4) * EPSILON * (large**2 * np.abs(M) + large * np.abs(C) + np.abs(K)) @ size
    missed += 2 * DATA * large * np.abs(2 * s * (M @ Q) + C @ Q)
    found: np.ndarray = np.abs(np.linalg.pinv(s * s * M + s * C + K)) @ missed
    return found


def of_waves(motion: "LinearMotion", waves: Sequence[tuple[complex, np.ndarray, np.ndarray]],
             powers: list[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """(δq, δq̇) at t = 0 of the waves [(s, Q, F)] and of Σ Qₖ tᵏ, powers [(Qₖ, Fₖ)]."""
    found = np.zeros((2, len(motion.M)))
    for s, Q, F in waves:
        error = of_phasor(motion.matrices[:3], motion.data_errors, s, Q, F[:len(Q)])
        found += error, abs(s) * (error + 2 * DATA * np.abs(Q))
    for row, error in zip(found, of_powers(motion, powers), strict=False):
        row += error
    return found[0], found[1]


def of_powers(motion: "LinearMotion", powers: list[tuple[np.ndarray, np.ndarray]],
              lost: Sequence[np.ndarray] | np.ndarray = ()) -> list[np.ndarray]:
    """|δQₖ| of K Qₖ = Fₖ − (k+1) C Qₖ₊₁ − (k+2)(k+1) M Qₖ₊₂; lost: how far the first Fₖ may be off beside a
    rounding."""
    if powers and moves_freely(motion.blocks):
        return list(errors_of(motion, powers, lost))
    matrices, data = motion.matrices[:3], motion.data_errors
    M, C, _ = matrices
    known = [(np.zeros(len(M)), np.zeros(len(M)))] * 2        # (|Q|, |δQ|) of the next two
    for k in reversed(range(len(powers))):
        Q, F = powers[k]
        off = np.zeros(len(M))
        for order, (matrix, (above, error)) in enumerate(zip((C, M), known[:2], strict=True), 1):
            weights, rows = data.weights[order]
            times = (k + 1) * (k + 2 if order == 2 else 1)
            off += times * (np.abs(matrix) @ (error + (len(M) + 4) * EPSILON * above) + data.entries[order] @ above
                            + np.abs(rows).T @ (weights * (np.abs(rows) @ above)))
        known.insert(0, (np.abs(Q), of_phasor(matrices, data, 0j, Q, F[:len(Q)], off)))
    return [error for _, error in known[:len(powers)]]


def of_wave(motion: "SteadyMotion", wave: tuple[complex, np.ndarray, np.ndarray],
            off: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """(|δQ|, |δF| beside a rounding) of a wave (s, Q, F); off: this |δF|, None for nothing."""
    s, Q, F = wave
    n, off = len(Q), np.zeros(len(F)) if off is None else off
    return of_phasor(motion.matrices[:3], motion.data_errors, s, Q, F[:n], off[:n]), off


def of_output(output: "LinearOutput", wave: tuple[complex, np.ndarray, np.ndarray], error: np.ndarray,
              off: np.ndarray) -> float:
    """|δX| of the phasor of an output under a wave (s, Q, F); error, off: those of the wave."""
    s, Q, F = wave
    total = 4 * DATA * abs(output.constant) if not s else 0.0
    for coefficients, factor in ((output.q, 1.0), (output.v, abs(s)), (output.a, abs(s)**2)):
        total += sum(abs(x) * factor * (error[i] + 8 * DATA * abs(Q[i])) for i, x in coefficients.items())
    return float(total + sum(abs(x) * (4 * DATA * abs(F[channel]) + off[channel])
                             for channel, x in output.channels.items()))


def of_waves_in(motion: "SteadyMotion", output: "LinearOutput") -> dict[float, float]:
    """{Ω: |δX|} of the phasors of an output; of periodic forcing only of what its mean drives off."""
    found: dict[float, float] = {}
    for wave, errors in zip(motion.waves, motion.errors_of_waves, strict=True) if motion.period is None else ():
        rate = wave[0].imag
        found[rate] = found.get(rate, 0.0) + of_output(output, wave, *errors)
    if motion.powers:
        found[0.0] = of_powers_in(motion, output)[0]
    return found


def of_powers_in(motion: "SteadyMotion", output: "LinearOutput") -> list[float]:
    """[|δcₖ|] of Σ cₖ tᵏ of an output, which has of q̇ and q̈ what follows the higher powers of Σ Qₖ tᵏ."""
    errors = of_powers(motion, motion.powers, motion.lost)
    found = []
    for k, (_, F) in enumerate(motion.powers):
        total = 4 * DATA * abs(output.constant) if not k else 0.0
        off = 4 * DATA * abs(F) + (motion.lost[k] if k < len(motion.lost) else 0.0)
        total += sum(abs(x) * off[channel] for channel, x in output.channels.items())
        for (Q, _), error, factor, coefficients in zip(
                motion.powers[k:], errors[k:], (1, k + 1, (k + 1) * (k + 2)), (output.q, output.v, output.a),
                strict=False):
            total += sum(abs(x) * factor * (error[i] + 8 * DATA * abs(Q[i])) for i, x in coefficients.items())
        found.append(float(total))
    return found


def of_harmonic(motion: "SteadyMotion", output: "LinearOutput", n: int) -> float:
    """|δX| of a harmonic under periodic forcing."""
    from vibcli.analyses.transient.steady_state import harmonic, lost_forces

    wave = harmonic(motion, motion.forcing, n)
    return of_output(output, wave, *of_wave(motion, wave, lost_forces(motion.forcing, n)))
