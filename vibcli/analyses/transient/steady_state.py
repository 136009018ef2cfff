"""The steady state of a motion: what is left of it when its free vibrations have died out.

After its last breakpoint a force Re(F e^{iΩt}) keeps up q = Re((K + iΩ C − Ω² M)⁻¹ F e^{iΩt}); a ramp, or any power
Σ Fₖ tᵏ, what follows it, Σ Qₖ tᵏ with K Qₖ + (k+1) C Qₖ₊₁ + (k+2)(k+1) M Qₖ₊₂ = Fₖ; periodic forcing the motion that
repeats, (1 − e^{BT}) c = what one period from rest brings. Where modes without damping are free their
vibration does not die out: the steady state is then what the force keeps up.
"""

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment
from vibcli.analyses.transient.exponential_differences import differences
from vibcli.analyses.transient.following import UNFORCED, driven, moves_freely
from vibcli.analyses.transient.isolating_intervals import fastest, stretches
from vibcli.analyses.transient.modal_block import ModalBlock
from vibcli.analyses.transient.time_shift import difference, later, turned
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.isolating_intervals import Cells
    from vibcli.analyses.transient.linear_response import LinearMotion, SteadyMotion

RESONANT, DIGITS = 1e-12, 12      # relative: a frequency that counts as a natural one
POINTS = 20         # of Gauss's rule
BATCH, MOST = 400_000, 200_000_000      # values of one exponential each that a mean takes together, and in all
EPSILON = 2.0**-52


def steady_forcing(forcing: Forcing) -> Forcing:
    """What drives the steady state, from t = 0 on; PhysicsError where the load grows otherwise than a power of the
    time."""
    if forcing.period is not None:
        return Forcing(forcing.channels, turned(forcing), forcing.period)
    last = forcing.last
    for wave in last.waves:
        if wave.coefficient and (wave.exponent.real > 0 or (wave.power and wave.exponent.imag
                                                            and not wave.exponent.real)):
            raise PhysicsError("there is no steady state: the load grows without end",
                               hint="ask at a time, or let the load end")
    waves = [wave for wave in last.waves if not wave.exponent.real]
    return Forcing(forcing.channels, [Segment(0.0, tuple(part for wave in waves for part in later(wave, -last.start)))])


def transient_forcing(forcing: Any, steady: Forcing) -> Forcing:
    """What drives the transient: the forcing less that of the steady state."""
    if forcing.recorded:
        found: Forcing = forcing.less(steady.pieces[0].waves)
        return found
    if forcing.period is not None:
        end, tail = forcing.since, []
    else:
        last = forcing.last
        end = last.start
        tail = [last._replace(waves=tuple(wave for wave in last.waves if wave.exponent.real))]
    pieces = difference(forcing.segments(end), steady.segments(end), end) if end else []
    return Forcing(forcing.channels, pieces + (tail or [Segment(end)]))


def check_stable(blocks: Sequence[ModalBlock]) -> None:
    """Refuses a system whose free motion grows."""
    if any(node.real > 0 for block in blocks for node in block.nodes):
        raise PhysicsError("there is no steady state: the free motion grows", hint="the equilibrium is unstable")


def undying(blocks: Sequence[ModalBlock]) -> bool:
    """Are there free vibrations, or a drift, that nothing damps?"""
    return any(not node.real for block in blocks for node in block.nodes)


def phasor(motion: "LinearMotion", s: complex, force: np.ndarray) -> np.ndarray:
    """Q of q = Re(Q e^{st}) under the forces Re(F e^{st})."""
    if not any(_meets(node, s) or (block.half and _meets(node.conjugate(), s))
               for block in motion.blocks for node in block.nodes):
        try:
            return np.linalg.solve(s * s * motion.M + s * motion.C + motion.K, force.astype(complex))
        except np.linalg.LinAlgError:
            raise PhysicsError("the steady state is not determined: at the frequency of a load nothing holds some of "
                               "what moves", "hold it, or give it inertia") from None
    total = np.zeros(len(force), complex)
    if motion.system is not None:
        total += motion.system.follow @ force
    for block in motion.blocks:
        if block.half:
            total += (_kept_up(block.B, block.X, block.W, s, force)
                      + _kept_up(block.B.conj(), block.X.conj(), block.W.conj(), s, force)) / 2
        else:
            total += _kept_up(block.B, block.X, block.W, s, force)
    return total


def _meets(node: complex, s: complex) -> bool:
    return not node.real and abs(s - node) <= RESONANT * abs(s)


def _kept_up(B: np.ndarray, X: np.ndarray, W: np.ndarray, s: complex, force: np.ndarray) -> np.ndarray:
    """X c of c = (s − B)⁻¹ W f; where s is an eigenvalue that f does not reach, that part stays at rest."""
    given, c = W @ force, np.zeros(len(B), complex)
    for i in reversed(range(len(B))):
        rest = given[i] + B[i, i + 1:] @ c[i + 1:]
        if not _meets(B[i, i], s):
            c[i] = rest / (s - B[i, i])
        elif abs(rest) > UNFORCED * (np.abs(W[i]) @ np.abs(force) + np.abs(B[i, i + 1:]) @ np.abs(c[i + 1:])):
            raise resonance(s)
    return X @ c


def resonance(s: complex) -> PhysicsError:
    """The refusal of a steady state that is never reached."""
    if not s:
        return PhysicsError("there is no steady state: a constant force drives a motion that nothing holds",
                            hint="tie it with a spring, or ask at a time")
    return PhysicsError(f"no steady state is found: Ω = {abs(s.imag):.6g} rad/s is, to {DIGITS} digits, a natural "
                        "frequency without damping", hint="add a damper, move Ω, or ask at a time")


def amplitudes(motion: "LinearMotion", forcing: Forcing) -> list[tuple[complex, np.ndarray, np.ndarray]]:
    """[(s, Q, F)] of the waves Re(F e^{st}) that never end, F over all channels, s ≠ 0."""
    found = {}
    for wave in forcing.pieces[0].waves:
        if not wave.exponent:
            continue
        s, c = complex(0, wave.exponent.imag), wave.coefficient
        if s.imag < 0:
            s, c = s.conjugate(), c.conjugate()
        row = found.setdefault(s, np.zeros(forcing.channels, complex))
        row[wave.channel] += c
    n = len(motion.M)
    return [(s, phasor(motion, s, row[:n]), row) for s, row in sorted(found.items(), key=lambda item: item[0].imag)]


def following(motion: "LinearMotion", forcing: Forcing) -> list[tuple[np.ndarray, np.ndarray]]:
    """[(Qₖ, Fₖ)] of what follows the forces Σ Fₖ tᵏ, F over all channels; more of them where these drive off what
    nothing holds."""
    still = [wave for wave in forcing.pieces[0].waves if not wave.exponent]
    forces = np.zeros((max((wave.power + 1 for wave in still), default=0), forcing.channels))
    for wave in still:
        forces[wave.power, wave.channel] += complex(wave.coefficient).real
    n = len(motion.M)
    if moves_freely(motion.blocks):
        return driven(motion, forces)
    Q = np.zeros((len(forces) + 2, n))
    for k in reversed(range(len(forces))):
        inertia = (k + 1) * motion.C @ Q[k + 1] + (k + 2) * (k + 1) * motion.M @ Q[k + 2]
        Q[k] = np.real(phasor(motion, 0j, forces[k, :n] - inertia))
    return list(zip(Q, forces, strict=False))


def harmonic(motion: "SteadyMotion", forcing: Forcing, n: int) -> tuple[complex, np.ndarray, np.ndarray]:
    """(s, Q, F) of the n-th harmonic of periodic forcing."""
    s, row = harmonic_forces(forcing, n)
    return s, phasor(motion, s, row[:len(motion.M)]), row


def harmonic_forces(forcing: Forcing, n: int) -> tuple[complex, np.ndarray]:
    """(s, F) of the n-th harmonic of periodic forcing: F = (2/T) ∫ f e^{−st} dt over a period, s = 2πin/T; 0 of what
    is not told from rounding."""
    s = complex(0, math.tau * n / forcing.period)
    row = np.zeros(forcing.channels, complex)
    for piece, after in zip(forcing.pieces, [*forcing.pieces[1:], Segment(forcing.period)], strict=True):
        length, turn = np.array([after.start - piece.start]), cmath.exp(-s * piece.start)
        for channel, size in piece.impulses:
            row[channel] += 2 * size * turn
        for wave in piece.waves:
            for c, exponent in ((wave.coefficient, wave.exponent), (np.conj(wave.coefficient), np.conj(wave.exponent))):
                nodes = (0j, *[complex(exponent) - s] * (wave.power + 1))
                row[wave.channel] += c * turn * math.factorial(wave.power) * differences(nodes, length)[0]
    row /= forcing.period * (1 if n else 2)
    row[np.abs(row) <= lost_forces(forcing, n)] = 0.0
    return s, row if n else row.real


def lost_forces(forcing: Forcing, n: int) -> np.ndarray:
    """|δF| of the same by rounding, in proportion to the integral of their size."""
    size = np.zeros(forcing.channels)
    for piece, after in pairwise([*forcing.pieces, Segment(forcing.period)]):
        length = after.start - piece.start
        for channel, blow in piece.impulses:
            size[channel] += abs(blow)
        for part in piece.waves:
            grown = math.exp(max(0.0, part.exponent.real * length))
            size[part.channel] += abs(part.coefficient) * length ** (part.power + 1) * grown
    found: np.ndarray = 2 / forcing.period * size * EPSILON * (16 + 8 * math.pi * n)
    return found


def mean_square(motion: "SteadyMotion", output: "LinearOutput", start: float, end: float) -> float:
    """(1/(end − start)) ∫ y² dt by Gauss's rule on stretches shorter than any wave in it, exact to rounding;
    PhysicsError where these are too many."""
    pieces = motion.pieces(end)
    y = pieces.terms(output, 0)
    cells = stretches(pieces.timeline, start, end)
    nodes = y.nodes()
    parts, values = max(1.0, np.ceil(fastest(nodes) * cells.width.max() / 8)), POINTS * max(1, len(nodes))
    if not values * parts * len(cells) <= MOST:
        raise PhysicsError("its fastest part is so short beside a period that the mean of its square is not found",
                           "look for stiffnesses and masses of very different size")
    many = max(1.0, BATCH // values)
    rough = cells.divided(int(np.ceil(parts / many)))
    fine = int(np.ceil(parts * len(cells) / len(rough)))
    step = max(1, int(many // fine))
    batches = (rough.where(slice(i, i + step)).divided(fine) for i in range(0, len(rough), step))
    return sum(_square(y, batch) for batch in batches) / (end - start)


def _square(y: Any, cells: "Cells") -> float:
    """∫ y² dt over short Cells."""
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    half = cells.width / 2
    tau = (cells.early + half)[:, None] + half[:, None] * at
    values = y.at(np.repeat(cells.segment, POINTS), tau.ravel()).reshape(tau.shape)
    return float(half @ (values**2 @ weights))
